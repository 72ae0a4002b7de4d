/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Half, quarter and octant domains against the whole: the same field to rounding, for the work of the part. */
#include "verification/solve/symmetry.h"

#include "verification/case/command.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

static void solve(const char *line, enum domain domain, struct field *f) {
    struct command r;
    struct failure why;
    if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    r.experiment.options.domain = domain;
    if (symmetry_solve(r.experiment.method, &r.experiment.problem, &r.experiment.options, f, &why))
        fail_msg("%s: %s", line, why.text);
    command_free(&r);
}

/* `saving` is the ratio of updates of the whole to those of the part. */
static void as_the_whole(const char *line, int saving) {
    struct field part, whole;
    solve(line, DOMAIN_SYMMETRY, &part);
    solve(line, DOMAIN_WHOLE, &whole);
    assert_int_equal(part.n, whole.n);
    /* temperatures of 10 K; each of the steps and each transform rounds to 2e-16 of that */
    for (size_t i = 0; i < part.n; i++) {
        double x[DIM_MAX], y[DIM_MAX];
        field_place(&part, i, x);
        field_place(&whole, i, y);
        for (int a = 0; a < DIM_MAX; a++) assert_near(x[a], y[a], 1e-14);
        assert_near(part.T[i], whole.T[i], 2e-13);
    }
    assert_order(field_largest(&part), >, 0.1);
    assert_near(part.heat[1] / whole.heat[1], 1, 1e-13);
    assert_int_equal(part.cost.updates * saving, whole.cost.updates);
    assert_true(saving == 1 || part.cost.bytes < whole.cost.bytes);
    field_free(&part);
    field_free(&whole);
}

static void reduced_domain_equals_the_whole(void **state) {
    (void)state;
    as_the_whole("run rod-step so_ssph --dx 0.05 --stepper exact", 2);
    as_the_whole("run rod-step fo_ssph --dx 0.05 --stepper exact", 2);
    as_the_whole("run rod-gauss so_ssph --dx 0.25 --stepper rk2 --dt 0.5", 2);
    as_the_whole("run rod-step ftcs --dx 0.05 --fourier 0.3", 2);
    as_the_whole("run rod-step so_ssph --dx 0.05 --walls fixed --stepper euler --dt 0.01", 2);
    as_the_whole("run rod-gauss brookshaw --dx 30/100 --volume tuned --stepper euler --fourier 0.05", 2);
    as_the_whole("run rod-gauss brookshaw --dx 30/100 --volume tuned --stepper rkl2 --fourier 1", 2);
    as_the_whole("run rod-gauss ftcs --dx 30/40 --sampling spline --dt 2.5", 2);
    as_the_whole("run rod-gauss ftcs --dx 30/40 --sampling cell --dt 2.5", 2);
    as_the_whole("run square-step so_ssph --dx 0.1 --stepper exact", 4);
    as_the_whole("run square-step brookshaw --dx 0.1 --stepper rkl2 --dt 0.5", 4);
    as_the_whole("run square-step ftcs_flux --dx 0.1 --fourier 0.2", 4);
    as_the_whole("run square-step so_ssph --dx 0.1 --h iso --stepper matched --sampling spline", 4);
    as_the_whole("run square-step so_ssph --dx 0.1 --h iso --stepper matched --set kappa_y=0.0025 --set b=0.7", 4);
    as_the_whole("run cube-step so_ssph --dx 0.1 --stepper exact", 8);
    as_the_whole("run box-cosine so_ssph --dx 0.1 --stepper exact", 2); /* odd modes along y and z */
    as_the_whole("run box-cosine so_ssph --dx 0.1 --stepper exact --set mode_z=2", 4);
    as_the_whole("run cube-step fo_ssph --dx 0.1 --stepper rkl2 --dt 0.5", 8);
    as_the_whole("run cube-step so_ssph --dx 0.1 --h iso --stepper matched --sampling spline --set kappa_y=0.01 "
                 "--set kappa_z=0.01",
                 8);
}

static void asymmetric_problems_are_not_cut(void **state) {
    (void)state;
    as_the_whole("run rod-step so_ssph --dx 4/41 --stepper exact", 1);
    as_the_whole("run plate so_ssph --dx 0.01 --stepper exact", 1);
    as_the_whole("run square-step so_ssph --dx 0.2 --layout jitter --jitter 0.1 --stepper rk2 --dt 0.1", 1);
    as_the_whole("run plane-contact contact_ssph --set mode=2 --dx 1/20 --stepper rk2 --dt 0.1", 1);
    as_the_whole("run square-step so_ssph --dx 0.2 --walls fit --stepper rk2 --dt 0.1", 1);
    as_the_whole("run rod-step fo_ssph --dx 0.5 --stepper exact", 1); /* 4 particles, a stencil that reaches 4 */
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reduced_domain_equals_the_whole),
        cmocka_unit_test(asymmetric_problems_are_not_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
