/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Properties that methods of this suite alone can show: limits of Robin walls, stability functions of the steppers,
 * the maximum principle, refusals of sparse clouds, and 1e7 steps. */
#include "solver/field.h"
#include "solver/time/stepper.h"
#include "verification/case/command.h"
#include "verification/judge/run.h"
#include "verification/stability/long_run.h"
#include "verification/stability/maximum_principle.h"
#include "verification/stability/step_limit.h"

#include "verification/unit/near.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <string.h>

static struct command request;

static struct experiment *of(const char *line) {
    struct failure why;
    command_free(&request);
    if (command_read(line, &request, &why)) fail_msg("%s: %s", line, why.text);
    return &request.experiment;
}

static struct model_problem model(const char *line) {
    struct model_problem b;
    struct failure why;
    const struct experiment *e = of(line);
    if (step_limit_setup(e->method, &e->options, request.dim, request.ratio, request.field, request.contact,
                         request.stages, &b, &why))
        fail_msg("%s: %s", line, why.text);
    return b;
}

/* K, between the runs of two problems. */
static double runs_apart(const struct experiment *e, const struct problem of[2]) {
    struct field f[2];
    struct failure why;
    for (int k = 0; k < 2; k++)
        if (method_solve(e->method, &of[k], &e->options, &f[k], &why)) fail_msg("%s", why.text);
    double apart = field_farthest(&f[0], f[1].T);
    for (int k = 0; k < 2; k++) field_free(&f[k]);
    return apart;
}

/* Insulated at b = 0, held at T_a at b = 1e300, to rounding; b = 1e-3 is neither. */
static void cooled_walls_have_both_limits(void **state) {
    (void)state;
    static const char *const line[] = {
        "run plate-cooling so_ssph --t-end 600 --dx 0.05", "run plate-cooling fo_ssph --t-end 600 --dx 0.05",
        "run plate-cooling ftcs --fourier 0.1 --t-end 600 --dx 0.05",
        "run plate-cooling so_ssph --layout jitter --jitter 0.2 --t-end 600 --dx 0.05"};
    static const double b[] = {0, 1e300, 1e-3};
    static const enum side_kind limit[] = {NEUMANN, DIRICHLET, NEUMANN};
    for (size_t i = 0; i < sizeof line / sizeof *line; i++)
        for (int end = 0; end < 3; end++) {
            const struct experiment *e = of(line[i]);
            struct problem p[2] = {e->problem, e->problem};
            for (int s = 0; s < 2 * e->problem.dim; s++)
                if (e->problem.side[s] == ROBIN) p[0].robin[s] = b[end], p[1].side[s] = limit[end];
            double apart = runs_apart(e, p);
            if (end < 2 ? !(apart <= 1e-11) : !(apart > 1e-6)) fail_msg("%s, b = %g: %g K", line[i], b[end], apart);
        }
}

/* On an impulse T stays in range where no weight is negative, and only there. */
static void maximum_principle_follows_the_weights(void **state) {
    (void)state;
    static const char *const line[] = {"limit so_ssph --dim 2 --kernel cubic",
                                       "limit so_ssph --dim 2 --kernel quartic"};
    for (int i = 0; i < 2; i++) {
        struct model_problem b = model(line[i]);
        int kept = 0, tried = 0;
        for (int k = 0; k < MAXIMUM_COUNT; k++) {
            struct maximum_principle x;
            struct failure why;
            if (maximum_principle_find(&b, maximum_principle_h(k), &x, &why)) continue;
            int weights = x.lowest >= -MAXIMUM_ROUNDING, runs = x.undershoot <= MAXIMUM_ROUNDING;
            if (weights != runs) fail_msg("%s: h/dx %g", line[i], maximum_principle_h(k));
            kept += weights, tried++;
        }
        assert_order(0, <, kept); /* the quartic kernel alone is negative somewhere */
        assert_true(i == 0 ? kept == tried : kept < tried);
    }
}

/* No neighbour within 2 h = dx, no diagonals, and a particle with fewer neighbours than unknowns. */
static void sparse_clouds_are_refused(void **state) {
    (void)state;
    static const char *const line[] = {
        "run square-step brookshaw --h 0.5 --dx 0.1", "run square-step so_ssph --h 0.7 --dx 0.1",
        "run square-step so_ssph --h 0.72 --layout jitter --jitter 0.5 --seed 1 --dx 0.1"};
    for (int i = 0; i < 3; i++) {
        struct result result;
        assert_int_equal(status_exit(run_experiment(of(line[i]), &result, NULL)), 3);
        assert_has(result.failure.text, "particle");
        assert_has(result.failure.text, "neighbours");
    }
}

/* A random walk of sqrt(1e7) roundings is 3e-4 of 1e7 of one sign. */
static void ten_million_steps_do_not_drift(void **state) {
    (void)state;
    const long long steps = 10000000;
    struct model_problem b = model("limit so_ssph --dim 1");
    struct step_limit l;
    struct long_run e;
    struct failure why;
    if (step_limit_predict(&b, &l, &why) || long_run_measure(&b, 0.999 * l.von_neumann, steps, &e, &why))
        fail_msg("%s", why.text);
    assert_order(fabs(e.drift), <=, 1e-3 * (double)steps * DBL_EPSILON);
    assert_order(e.rise, <=, 8 * DBL_EPSILON); /* the last digit of a constant rod may flicker */
    assert_order(e.largest, <=, 2);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cooled_walls_have_both_limits),
        cmocka_unit_test(maximum_principle_follows_the_weights),
        cmocka_unit_test(sparse_clouds_are_refused),
        cmocka_unit_test(ten_million_steps_do_not_drift),
    };
    return cmocka_run_group_tests_name("principles", tests, NULL, NULL);
}
