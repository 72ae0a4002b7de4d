/* Song 2018, eqs. 44, 45: the solution that errors are measured against. */
#include "verification/claims/kit.h"
#include "verification/claims/measures.h"

#include "references/series.h"

#include <math.h>

static const double T0 = 10, A = 0.5, KAPPA = 0.01, L = 2; /* section 5.1: K, m, m^2/s, m */

/* Eq. 45 letter by letter. */
static double printed(double x, double t, double kappa_x, double kappa_y) {
    return T0 / 2 * (erf((A + x) / sqrt(4 * t * kappa_x)) + erf((A - x) / sqrt(4 * t * kappa_y)));
}

/* Largest |T(x) - T(-x)|: the problem is even. */
static void take_eq45(const char *argument, struct claims_measured *m) {
    double apart[2] = {0, 0};
    (void)argument;
    for (int i = 1; i <= 20; i++) {
        double x = 0.1 * i;
        apart[0] = fmax(apart[0], fabs(printed(x, 5, KAPPA, KAPPA) - printed(-x, 5, KAPPA, KAPPA)));
        apart[1] = fmax(apart[1], fabs(printed(x, 5, KAPPA, KAPPA / 3) - printed(-x, 5, KAPPA, KAPPA / 3)));
    }
    claims_kit_number(m, apart[0], "K", "|T(x) - T(-x)|, kappa_y = kappa_x");
    claims_kit_number(m, apart[1], "K", "kappa_y = kappa_x/3");
    claims_kit_decide(m, apart[0] <= 1e-12, apart[1] <= 1e-12,
                      "as even as the problem is: for the one kappa_y that makes it so, and for any");
}

/* Eq. 45 is the solution of the infinite line; eq. 44 has walls at zero.  Relative to the errors of Table 1. */
static void take_walls(const char *argument, struct claims_measured *m) {
    static const double time[2] = {5, 50};
    struct published t;
    double share[2], smallest = INFINITY;
    (void)argument;
    if (claims_kit_published(&t, m, "song_table1")) return;
    for (int r = 0; r < t.rows; r++)
        for (int i = 0; i < t.columns; i++) smallest = fmin(smallest, t.value[r][i]);
    for (int i = 0; i < 2; i++) {
        double apart = 0, size = 0, s = sqrt(4 * KAPPA * time[i]);
        for (int j = 0; j < 400; j++) {
            double x = -L + (j + 0.5) * 0.01, T = series_box(x, L, A, s).at.value;
            apart += fabs(series_box_line(x, A, s) - T);
            size += T;
        }
        share[i] = apart / size;
        claims_kit_number(m, share[i], "", "sum of differences over sum of T at %g s", time[i]);
    }
    claims_kit_number(m, 2 * printed(L, 5, KAPPA, KAPPA) / T0 / 2, "", "T(L)/T0 of eq. 45 at 5 s");
    claims_kit_decide(m, share[0] <= 0.01 * smallest, share[1] <= 0.01 * smallest,
                      "eq. 45 misses the walls by at most 1 %% of the smallest error of Table 1, %.4g: at 5 s, as "
                      "published, and ten times later",
                      smallest);
}

const struct claims_measure claims_song_exact_measures[] = {{"eq45", take_eq45}, {"walls", take_walls}, {0}};
