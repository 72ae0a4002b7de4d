/* Song 2018, section 5: oscillations and what becomes of them, the time step, and the solution of eq. 45. */
#include "verification/claims/kit.h"

#include "references/series.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static double outside(const struct result *r) {
    return fmax(r->shape.overshoot, r->shape.undershoot);
}

/* "run's words | ... | beyond: run's words | ...": none leaves its initial range (0 to 10 K). */
static void take_no_oscillation(const char *argument, struct claims_measured *m) {
    char part[200];
    int held[2] = {1, 1}, beyond = 0;
    while (claims_kit_part(&argument, part, sizeof part)) {
        struct command_run run;
        char *words = part;
        if (*words == '+') beyond = 1, words++;
        int bad = claims_kit_run(&run, m, "run %s", words);
        double most = outside(&run.result);
        command_run_free(&run);
        if (bad) return;
        claims_kit_number(m, most, "K", "%s", words);
        held[beyond] &= most <= 1e-11; /* rounding: 10 K, thousands of steps */
    }
    claims_kit_decide(m, held[0], held[1],
                      "no run leaves the initial range of 0 to 10 K (to rounding, 1e-11 K): the first two as "
                      "published, then others");
}

/* "run's words | ...": each leaves its initial range, or carries a wave of two points, by 1 % of the jump. */
static void take_oscillation(const char *argument, struct claims_measured *m) {
    char part[200];
    int held = 1;
    while (claims_kit_part(&argument, part, sizeof part)) {
        struct command_run run;
        int bad = claims_kit_run(&run, m, "run %s", part);
        double most = fmax(outside(&run.result), run.result.shape.checkerboard);
        command_run_free(&run);
        if (bad) return;
        claims_kit_number(m, most, "K", "%s", part);
        held &= most >= 0.1;
    }
    claims_kit_decide(m, held, 1,
                      "overshoot, or the amplitude of a wave of two to four points, at least 0.1 K of the 10 K jump");
}

/* The same words, where there must be none: below 1e-6 of the largest temperature. */
static void take_smooth(const char *argument, struct claims_measured *m) {
    char part[200];
    int held = 1;
    while (claims_kit_part(&argument, part, sizeof part)) {
        struct command_run run;
        int bad = claims_kit_run(&run, m, "run %s", part);
        double most = fmax(outside(&run.result), run.result.shape.checkerboard) / run.result.shape.max;
        command_run_free(&run);
        if (bad) return;
        claims_kit_number(m, most, "", "%s", part);
        held &= most <= 1e-6;
    }
    claims_kit_decide(m, held, 1, "overshoot and waves of two to four points below 1e-6 of the largest temperature");
}

/* The wave of two points in the error e: the largest |(1, -4, 6, -4, 1) . e|/16, which a pure (-1)^j passes whole. */
static double sawtooth(const struct command_run *run) {
    const struct field *f = &run->field;
    double most = 0, e[5] = {0};
    for (size_t i = 0; i < f->n; i++) {
        for (int k = 0; k < 4; k++) e[k] = e[k + 1];
        double x[2] = {f->x[i], 0};
        e[4] = f->T[i] - command_run_exact(run, x, f->time);
        if (i >= 4) most = fmax(most, fabs(e[0] - 4 * e[1] + 6 * e[2] - 4 * e[3] + e[4]) / 16);
    }
    return most;
}

/* How the sawtooth of fo_ssph falls from 5 to 50 and 500 s, walls far away, beside the peak of the heat itself. */
static void take_persistence(const char *argument, struct claims_measured *m) {
    static const double time[3] = {5, 50, 500};
    double wave[2][3], peak[3];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) {
            struct command_run run;
            int bad = claims_kit_run(&run, m, "run rod-step %s --h 1.05 --dx 0.1 --set L=20 --t-end %g",
                                     k ? "so_ssph" : argument, time[i]);
            if (!bad) wave[k][i] = sawtooth(&run);
            peak[i] = run.result.shape.max;
            command_run_free(&run);
            if (bad) return;
        }
    double early = -log10(wave[0][1] / wave[0][0]), late = -log10(wave[0][2] / wave[0][1]);
    claims_kit_number(m, wave[0][0], "K", "sawtooth at 5 s");
    claims_kit_number(m, wave[0][2], "K", "at 500 s");
    claims_kit_number(m, early, "", "falls from 5 to 50 s as 1/t to the power");
    claims_kit_number(m, late, "", "from 50 to 500 s");
    claims_kit_number(m, -log10(peak[2] / peak[1]), "", "the heat's own peak, from 50 to 500 s");
    claims_kit_number(m, wave[1][2], "K", "so_ssph at 500 s");
    /* 2: twice the power at which a pair of opposite sources, which the two jumps are, falls in one dimension */
    claims_kit_decide(m, fmax(early, late) <= 2, wave[0][1] >= 0.99 * wave[0][0],
                      "it falls by a power of time, at most 2, and not exponentially; without a condition only if "
                      "99 %% were left after ten times as long");
}

/* "METHOD | METHOD": the central wave of two points is in the null space. */
static void take_null_space(const char *argument, struct claims_measured *m) {
    char method[40];
    int held = 1;
    while (claims_kit_part(&argument, method, sizeof method)) {
        struct command_run run;
        int bad = claims_kit_run(&run, m, "run rod-step %s --h 1.05 --dx 0.1", method);
        struct experiment *e = &run.request.experiment;
        double kappa[2] = {0.01, 0}, theta[2] = {acos(-1), 0};
        struct heat_operator a = {0};
        struct failure why;
        if (!bad &&
            operator_stencil(&e->problem, &e->options, e->method->scheme, 0.1, kappa, a.reach, &a.weight, &why))
            bad = claims_kit_fail(m, why.text);
        int sweeps = bad ? 0 : e->method->scheme->sweeps;
        double rate = bad ? 0 : operator_symbol(&a, theta) * 0.1 * 0.1 / kappa[0];
        free(a.weight);
        command_run_free(&run);
        if (bad) return;
        claims_kit_number(m, rate, "kappa/dx^2", "rate of (-1)^j, %s", method);
        held &= (fabs(rate) <= 1e-12) == (sweeps == 2);
    }
    claims_kit_decide(m, held, 1, "0 to rounding (1e-12) for first derivatives applied twice, and for them alone");
}

/* "words | dt": what the published Euler step adds to the error, from the same run without any time error. */
static void take_time_error(const char *argument, struct claims_measured *m) {
    char words[160], dt[32];
    double most = 0;
    while (claims_kit_part(&argument, words, sizeof words) && claims_kit_part(&argument, dt, sizeof dt)) {
        struct command_run euler, exact;
        int bad = claims_kit_run(&euler, m, "run %s --stepper euler --dt %s", words, dt) |
                  claims_kit_run(&exact, m, "run %s --stepper exact", words);
        double apart = 0, size = 0;
        for (size_t i = 0; i < (bad ? 0 : exact.field.n); i++) {
            apart += fabs(euler.field.T[i] - exact.field.T[i]);
            size += fabs(exact.field.T[i]);
        }
        double share = apart / size / exact.result.error.l1;
        command_run_free(&euler);
        command_run_free(&exact);
        if (bad) return;
        claims_kit_number(m, 100 * share, "% of E", "time error, dt = %s s, %s", dt, words);
        most = fmax(most, share);
    }
    /* 5 % at the finest of spacings 1:50 moves the slope through them by log(1.05)/log(50) = 0.012 */
    claims_kit_decide(
        m, most <= 0.05, most <= 0.01,
        "the time step makes up at most 5 %% of the error at the finest spacing, which moves the slope by "
        "0.01; at most 1 %%, which leaves the printed digits alone, for no condition");
}

/* E1 against the exact solution at five times: below what a plot can show. */
static void take_agreement(const char *argument, struct claims_measured *m) {
    double worst = 0, last = INFINITY;
    int falling = 1;
    for (int t = 1; t <= 5; t++) {
        struct command_run run;
        int bad = claims_kit_run(&run, m, "run %s --t-end %d", argument, t);
        double most = run.result.shape.max;
        falling &= most <= last;
        worst = fmax(worst, run.result.error.linf / 10);
        last = most;
        command_run_free(&run);
        if (bad) return;
        claims_kit_number(m, most, "K", "peak at %d s", t);
    }
    claims_kit_number(m, 100 * worst, "% of T0", "largest error at any of the times");
    claims_kit_decide(m, worst <= 0.05 && falling, worst <= 0.01,
                      "peaks fall, and no point is off by more than 5 %% of T0 (1 %% for no condition)");
}

/* ---- Eqs. 44, 45: the solution that errors are measured against ---- */

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

const struct claims_measure claims_song_wave_measures[] = {{"no_oscillation", take_no_oscillation},
                                                           {"oscillation", take_oscillation},
                                                           {"smooth", take_smooth},
                                                           {"persistence", take_persistence},
                                                           {"null_space", take_null_space},
                                                           {"time_error", take_time_error},
                                                           {"agreement", take_agreement},
                                                           {"eq45", take_eq45},
                                                           {"walls", take_walls},
                                                           {0}};
