/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The least squares of an error with the response to a fault, on fields made so that size, share and part are known.
 */
#include "verification/fault/fit.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/fault/diagnosis.h"
#include "verification/judge/norms.h"
#include "verification/judge/run.h"
#include "verification/text/output.h"

#include "verification/unit/near.h"

#include <signal.h>
#include <stdlib.h>

enum { N = 6 };

/* Four fields that overlap, at five points; at the sixth all are zero. */
static const double f[N] = {1, -2, 0.5, 0.3, -0.7, 0}, g[N] = {0.4, 0.1, -0.9, 0.2, 0.6, 0},
                    h[N] = {-0.3, 0.8, 0.2, -0.5, 0.1, 0}, m[N] = {0.2, 0.3, 0.6, 0.9, -0.4, 0},
                    weight[N] = {1, 0.5, 2, 0.25, 1.5, 3};

static double product(const double *a, const double *b, const double *w) {
    double sum = 0;
    for (int i = 0; i < N; i++) sum += a[i] * b[i] * (w ? w[i] : 1);
    return sum;
}

/* The fit to size f + b g + c h + d m, and `rest` at the sixth point. */
static struct fit fit_of(double size, const double by[3], double rest, int is_mean, const double *w) {
    double e[N];
    struct field field = {.dim = 1, .n = N, .weight = (double *)w};
    for (int i = 0; i < N; i++) e[i] = size * f[i] + by[0] * g[i] + by[1] * h[i] + by[2] * m[i];
    e[N - 1] = rest;
    const struct fit_errors s = {&field, e, (double *)g, (double *)h, (double *)m, is_mean};
    return fit_fault(&s, f);
}

static void components_of_an_error_are_found(void **state) {
    (void)state;
    static const double by[2][3] = {{1.9, -0.45, 1.7}, {-1.2, 0.3, -1.9}}, none[3] = {0, 0, 0};
    for (int k = 0; k < 4; k++) {
        const double *w = k % 2 ? weight : NULL, size = k < 2 ? 3.7 : -0.6;
        struct fit found = fit_of(size, by[k / 2], 0, 1, w);
        assert_near(found.size, size, 1e-9);
        assert_near(found.share, 1, 1e-12);
        double natural =
            product(g, g, w) + 2 * product(g, h, w) / 5 + product(h, h, w) / 25 + product(m, m, w) * 9 / 4;
        assert_near(found.part, fabs(size) * sqrt(product(f, f, w) / natural), 1e-9);
        double all = size * size * product(f, f, w), rest = 0.8 * 0.8 * (w ? w[N - 1] : 1);
        found = fit_of(size, none, 0.8, 1, w);
        assert_near(found.size, size, 1e-9);
        assert_near(found.share, all / (all + rest), 1e-12);
    }
}

/* The errors are orthogonal, so that the part of each beyond its bound remains. */
static void discretization_errors_are_bounded(void **state) {
    (void)state;
    double e[5], unit[4][5] = {{0}};
    struct field field = {.dim = 1, .n = 5};
    for (int a = 0; a < 4; a++) unit[a][a] = 1;
    for (int sign = -1; sign <= 1; sign += 2) {
        const double made[4] = {7, sign * 2.5, sign * 0.9, sign * 2.25};
        for (int i = 0; i < 5; i++) e[i] = i < 4 ? made[i] : NAN;
        struct fit_errors s = {&field, e, unit[1], unit[2], unit[3], 1};
        double all = 49 + 6.25 + 0.81 + 5.0625;
        struct fit found = fit_fault(&s, unit[0]);
        assert_near(found.size, 7, 1e-12);
        assert_near(found.share, 1 - (0.25 + 0.16 + 0.0625) / all, 1e-12);
        assert_near(found.part, 7 / sqrt(1 + 0.04 + 2.25), 1e-12);
        s.is_mean = 0; /* m is no part of it */
        found = fit_fault(&s, unit[0]);
        assert_near(found.share, 1 - (0.25 + 0.16 + 5.0625) / all, 1e-12);
    }
}

/* If a cell mean resembles the fault, half of it is assumed. */
static void nearly_collinear_mean_is_halved(void **state) {
    (void)state;
    static const double cosine[] = {0.85, 0.95}; /* squared cosines of the angle between both */
    struct field field = {.dim = 1, .n = 2};
    double zero[2] = {0, 0}, one[2] = {1, 0};
    for (int k = 0; k < 2; k++) {
        double along = sqrt(cosine[k]), mean[2] = {along, sqrt(1 - cosine[k])};
        double e[2] = {2 + mean[0], mean[1]};
        const struct fit_errors s = {&field, e, zero, zero, mean, 1};
        struct fit found = fit_fault(&s, one);
        assert_near(found.size, k ? 2 + along / 2 : 2, 1e-9);
        assert_near(found.share, k ? 1 - mean[1] * mean[1] / 4 / (e[0] * e[0] + e[1] * e[1]) : 1, 1e-9);
    }
    double nothing[2] = {0, 0}, e[2] = {1, 2};
    const struct fit_errors s = {&field, e, zero, zero, one, 1}, exact = {&field, zero, one, one, one, 1};
    assert_near(fit_fault(&s, nothing).share, 0, 0);
    assert_near(fit_fault(&exact, one).share, 0, 0);
}

static void hear(int number) {
    (void)number;
}

/* No response is computed after an interrupt, so that the program ends at once. */
static void interrupt_ends_the_search(void **state) {
    (void)state;
    struct command_run run[2];
    struct diagnosis_rung rung[2];
    double *exact[2];
    for (int k = 0; k < 2; k++) {
        const double dx = k ? 0.5 : 0.25;
        assert_int_equal(command_run_line(&run[k], "run rod-gauss ftcs --dx %g", dx), STATUS_OK);
        const struct experiment *e = &run[k].typed.experiment;
        exact[k] = calloc(run[k].field.n, sizeof **exact);
        norms_exact(e->scene, &e->problem, &run[k].field, exact[k]);
        rung[k] = (struct diagnosis_rung){&run[k].field, exact[k], dx, run[k].field.dt, NAN};
    }
    signal(SIGTERM, hear);
    for (int interrupted = 0; interrupted < 2; interrupted++) {
        output_hold();
        if (interrupted) raise(SIGTERM);
        struct evidence *found = fit_all(&run[0].typed.experiment.problem, rung);
        assert_int_equal(found->n > 0, !interrupted);
        free(found);
        output_release();
    }
    for (int k = 0; k < 2; k++) {
        command_run_free(&run[k]);
        free(exact[k]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_of_an_error_are_found),
        cmocka_unit_test(discretization_errors_are_bounded),
        cmocka_unit_test(nearly_collinear_mean_is_halved),
        cmocka_unit_test(interrupt_ends_the_search),
    };
    return cmocka_run_group_tests_name("fit", tests, NULL, NULL);
}
