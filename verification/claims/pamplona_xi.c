/* Pamplona 2019, eq. 18 and Figs. 7 and 8: the xi that makes the error least, over h and material, the order that is
 * left, and the cost.
 *
 * A tuned volume only scales the rate of heating, so the best xi has a closed form.  On a lattice the operator
 * answers x^2/2 with M (2 F x^2 dx^2 summed) instead of 1; eq. 14 with the ghosts counted in N scales that by
 * (n/(n+4))^2; and xi takes both back: xi = ((n + 4)/n)^2 / M, with n = 1.2 * 0.1 m/h.  Its slope in log h is 1/3 at
 * h = 0.006 m. */
#include "verification/claims/kit.h"
#include "verification/claims/measures.h"
#include "verification/claims/pamplona_plate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MATERIALS = 3 };
static const char *const material[MATERIALS] = {"steel", "titanium", "vanadium"};
static const double alpha[MATERIALS] = {60.5 / (7854 * 434.), 21.9 / (4500 * 522.), 30.7 / (6100 * 489.)};

struct setting {
    int n, material;
    double beta; /* eq. 15 */
    double lag;  /* claims_pamplona_plate.h */
    double t;    /* s */
    const char *walls;
};

static struct setting as_published(int n, int which) {
    return (struct setting){n, which, 0.08, 1, 28.8894, "fixed"};
}

static double h_of(int n) {
    return 1.2 * 0.1 / n;
}

/* Mean |e|/T, or NaN with *m failed. */
static double error_at(const struct setting *s, double xi, struct claims_measured *m) {
    struct claims_pamplona_plate e;
    char words[240];
    double h = h_of(s->n), dt = s->beta * h * h / alpha[s->material];
    snprintf(words, sizeof words,
             "brookshaw --dx %.17g --walls %s --kernel quartic --h 1.2 --volume tuned --xi %.10g --stepper rk2 --dt "
             "%.10g --set material=%s",
             0.1 / s->n, s->walls, xi, dt, material[s->material]);
    return claims_pamplona_plate_run(&e, m, s->t, s->lag, words) ? NAN : e.mean_relative;
}

struct best {
    double xi, error;
};

/* The least error over xi, by the golden section. */
static struct best fit(const struct setting *s, struct claims_measured *m) {
    const double golden = (sqrt(5) - 1) / 2;
    double lo = 1.1, hi = 3, a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    double at_a = error_at(s, a, m), at_b = error_at(s, b, m);
    while (hi - lo > 0.002 && isfinite(at_a + at_b)) {
        if (at_a < at_b) {
            hi = b, b = a, at_b = at_a;
            a = hi - golden * (hi - lo);
            at_a = error_at(s, a, m);
        } else {
            lo = a, a = b, at_a = at_b;
            b = lo + golden * (hi - lo);
            at_b = error_at(s, b, m);
        }
    }
    return at_a < at_b ? (struct best){a, at_a} : (struct best){b, at_b};
}

/* M above for h/dx, from the weights themselves; NaN with *m failed. */
static double lattice_moment(const char *kernel, double h, struct claims_measured *m) {
    struct command_run run;
    struct claims_kit_cell cell;
    struct failure why;
    const double one[2] = {1, 1};
    double sum = NAN;
    int bad = claims_kit_run(&run, m, "run plate brookshaw --dx 0.005 --kernel %s --h %g --volume raw --t-end 0.01",
                             kernel, h);
    const struct material *k = &run.request.experiment.problem.material[0];
    if (!bad && claims_kit_weigh(&cell, &run.request, one, &why)) bad = claims_kit_fail(m, why.text);
    if (!bad) {
        sum = 0;
        for (size_t j = 0; j < cell.nb.n; j++) sum += cell.w[0][j] * cell.d[j][0] * cell.d[j][0] / 2;
        sum /= k->k[0] / k->rho_c;
    }
    command_run_free(&run);
    return sum;
}

/* Eq. 13 as it stands, with the volume dx^2: its answer to x^2/2. */
static void take_eq13(const char *argument, struct claims_measured *m) {
    static const double h[] = {1.2, 2, 3};
    double worst = 0, as_run = NAN;
    (void)argument;
    for (int i = 0; i < 3; i++) {
        double M = lattice_moment("quartic", h[i], m);
        if (isnan(M)) return;
        claims_kit_number(m, M, "", "answer to x^2/2, where 1 is exact, h/dx = %g", h[i]);
        if (i == 0) as_run = fabs(M - 1);
        worst = fmax(worst, fabs(M - 1));
    }
    claims_kit_decide(
        m, as_run <= 0.15, worst <= 0.01,
        "within 15 %% as run, since the paper tunes xi for what is left; within 1 %% at every h/dx for no "
        "condition");
}

static double closed_form(double moment, double h) {
    double n = 0.12 / h;
    return pow((n + 4) / n, 2) / moment;
}

static double eq18(double h) {
    return 9 * cbrt(h);
}

static void take_eq18(const char *argument, struct claims_measured *m) {
    static const int n[] = {18, 20, 24, 30};
    const double fine = 0.002;
    double off[3] = {0, 0, 0}, moment = lattice_moment("quartic", 1.2, m);
    (void)argument;
    if (isnan(moment)) return;
    for (int i = 0; i < 4; i++) {
        double h = h_of(n[i]), lag = pow((n[i] + 1.0) / n[i], 2);
        struct setting s = as_published(n[i], 0);
        double xi = fit(&s, m).xi;
        const double other[3] = {closed_form(moment, h), xi, xi / lag};
        for (int k = 0; k < 3; k++) off[k] = fmax(off[k], fabs(eq18(h) / other[k] - 1));
        if (n[i] != 20) continue;
        claims_kit_number(m, eq18(h), "m", "eq. 18 at h = %.3f m", h);
        claims_kit_number(m, other[0], "m", "closed form");
        claims_kit_number(m, other[1], "m", "fitted, 20 spacings");
        claims_kit_number(m, other[2], "m", "fitted, 21 spacings");
    }
    double at_fine = fabs(eq18(fine) / closed_form(moment, fine) - 1);
    claims_kit_number(m, 100 * off[0], "%", "eq. 18 off the closed form by at most, h = 0.004 to 0.0067 m");
    claims_kit_number(m, 100 * off[1], "%", "off the fitted, n spacings");
    claims_kit_number(m, 100 * off[2], "%", "off the fitted, n + 1 spacings");
    claims_kit_number(m, 100 * at_fine, "%", "off the closed form at %g m", fine);
    claims_kit_decide(m, fmin(off[1], off[2]) <= 0.05, fmax(off[1], off[2]) <= 0.05 && at_fine <= 0.05,
                      "within 5 %% of the fit for h <= 0.007 m, on the plate of one width; on that of either, and "
                      "at smaller h too, for no condition");
}

/* What eq. 18 costs in error against the best xi. */
static void take_rise(const char *argument, struct claims_measured *m) {
    double rise[2];
    (void)argument;
    for (int l = 0; l < 2; l++) {
        struct setting s = as_published(20, 0);
        s.lag = l ? 1.1025 : 1;
        struct best b = fit(&s, m);
        rise[l] = 100 * (error_at(&s, eq18(h_of(20)), m) - b.error);
        claims_kit_number(m, 100 * b.error, "%", "error at the best xi, %s", l ? "21 spacings" : "20 spacings");
        claims_kit_number(m, rise[l], "%", "added by eq. 18");
    }
    int near[2] = {fabs(rise[0] - 3.5) <= 1, fabs(rise[1] - 3.5) <= 1};
    claims_kit_decide(m, near[0] || near[1], near[0] && near[1],
                      "adds 3.5 %% of error (+- 1 %%) at h = 0.006 m, on the plate of one width; of either for no "
                      "condition");
}

static void take_materials(const char *argument, struct claims_measured *m) {
    static const int n[] = {13, 17, 20, 24};
    double most = 0;
    (void)argument;
    for (int i = 0; i < 4; i++) {
        double xi[MATERIALS], mean = 0, sum = 0;
        for (int k = 0; k < MATERIALS; k++) {
            struct setting s = as_published(n[i], k);
            xi[k] = fit(&s, m).xi;
            mean += xi[k] / MATERIALS;
        }
        for (int k = 0; k < MATERIALS; k++) sum += (xi[k] - mean) * (xi[k] - mean) / MATERIALS;
        claims_kit_number(m, sqrt(sum), "m", "h = %.4f m", h_of(n[i]));
        most = fmax(most, sqrt(sum));
    }
    claims_kit_decide(
        m, most <= 0.0302 + 0.002, 1,
        "standard deviation of the fitted xi over the three materials at most 0.0302 m, xi being fitted "
        "to 0.002 m");
}

/* Whether the divergence between materials comes from their steps: smaller steps, and equal alpha t. */
static void take_divergence(const char *argument, struct claims_measured *m) {
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {0};
    (void)argument;
    for (int k = 0; k < MATERIALS; k++) {
        struct setting s = as_published(20, k);
        double xi = fit(&s, m).xi;
        for (int i = 0; i < 3; i++) {
            struct setting with = s;
            if (i == 1) with.beta /= 8;
            if (i == 2) with.t *= alpha[0] / alpha[k];
            double E = 100 * (i == 2 ? fit(&with, m).error : error_at(&with, xi, m));
            lo[i] = fmin(lo[i], E);
            hi[i] = fmax(hi[i], E);
        }
    }
    claims_kit_number(m, hi[0] - lo[0], "%", "errors of the materials differ by");
    claims_kit_number(m, hi[1] - lo[1], "%", "with an eighth of the step");
    claims_kit_number(m, hi[2] - lo[2], "%", "at equal alpha t and equal steps");
    claims_kit_decide(m, hi[1] - lo[1] <= 0.5 * (hi[0] - lo[0]), 1,
                      "caused by the step if an eighth of it at least halves the difference");
}

/* Observed order (eq. 19) of the best error between h = 0.009 and 0.005 m. */
static void take_observed_order(const char *argument, struct claims_measured *m) {
    double order[2] = {0, 0}, ratio = log(h_of(13) / h_of(24));
    (void)argument;
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < MATERIALS; k++) {
            struct setting a = as_published(13, k), b = as_published(24, k);
            if (i == 1) a.walls = b.walls = "mirror";
            double p = log(fit(&a, m).error / fit(&b, m).error) / ratio;
            order[i] += p / MATERIALS;
            if (i == 0) claims_kit_number(m, p, "", "order, %s", material[k]);
        }
    }
    claims_kit_number(m, order[0], "", "mean");
    claims_kit_number(m, order[1], "", "mean, mirror walls");
    claims_kit_decide(m, fabs(order[0] - 1) <= 0.2, fabs(order[1] - 1) <= 0.2 && fabs(order[0] - 1.1253) <= 0.1,
                      "first order +- 0.2 as published; no condition if with exact walls too, and within 0.1 of "
                      "1.1253");
}

/* Section 6: with xi kept, a smaller h heats faster. */
static void take_direction(const char *argument, struct claims_measured *m) {
    double moment = lattice_moment("quartic", 1.2, m), coarse = 1.643 / closed_form(moment, 0.009),
           fine = 1.643 / closed_form(moment, 0.005);
    (void)argument;
    if (isnan(moment)) return;
    claims_kit_number(m, coarse, "", "rate over the true one, xi = 1.643 m, h = 0.009 m");
    claims_kit_number(m, fine, "", "h = 0.005 m");
    claims_kit_decide(m, fine > coarse, 1, "with xi kept, the particles conduct faster at the smaller h");
}

const struct claims_measure claims_pamplona_xi_measures[] = {{"eq13", take_eq13},
                                                             {"eq18", take_eq18},
                                                             {"eq18_rise", take_rise},
                                                             {"xi_materials", take_materials},
                                                             {"xi_divergence", take_divergence},
                                                             {"observed_order", take_observed_order},
                                                             {"xi_direction", take_direction},
                                                             {0}};
