/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Possible share of rounding in a run's error, by hand, and the bound of a quantity's exact value. */
#include "verification/judge/run.h"

#include "references/quantity.h"
#include "solver/field.h"
#include "solver/problem.h"
#include "verification/case/command.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <float.h>

static struct result run(const char *line, struct field *f, struct quantity_value *exact) {
    struct command r;
    struct result result;
    struct failure why;
    if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (run_experiment(&r.experiment, &result, f)) fail_msg("%s: %s", line, result.failure.text);
    if (exact) *exact = quantity_exact(&r.experiment.quantity, r.experiment.scene, &r.experiment.problem, f->time);
    command_free(&r);
    return result;
}

static double of(const char *line) {
    struct field f;
    double rounding = run(line, &f, NULL).rounding;
    field_free(&f);
    return rounding;
}

/* So many applications of the weights, F = kappa t/dx^2, along one axis or two. */
static double stepped(int axes, double F, double applications) {
    return DBL_EPSILON * (1 + sqrt(applications) + 4 * axes * F);
}

/* kappa t = 0.05 m^2 on the rod and, along y alone, 0.1 m^2 on the square: 5 and 10 cells of 0.1 m. */
static void rounding_bound_of_time_steps(void **state) {
    (void)state;
    const double close = 1e-12 * DBL_EPSILON;
    assert_near(of("run rod-step so_ssph --dx 0.1 --stepper euler --dt 0.05"), stepped(1, 5, 100), close);
    assert_near(of("run rod-step so_ssph --dx 0.1 --stepper rk2 --dt 0.05"), stepped(1, 5, 2 * 100), close);
    assert_near(of("run square-step ftcs --dx 0.1 --dt 0.1 --set kappa_y=0.02"), stepped(2, 10, 50), close);
}

/* The reported number of steps of a program counts up to (4 F)^2, F = kappa t/dx^2: at 0.2 two thirds of one. */
static void claimed_steps_are_capped_by_round_off(void **state) {
    (void)state;
    static const char *const line = "run rod-step mine --dx 0.5 --set kappa=%s --solver 'printf \"# steps = "
                                    "9\\nx,T\\n-1.75,0\\n-1.25,0\\n-0.75,0\\n"
                                    "-0.25,9\\n0.25,9\\n0.75,1\\n1.25,0\\n1.75,0\\n\" >{out}; : {case}'";
    char with[400];
    snprintf(with, sizeof with, line, "0.01");
    assert_near(of(with), stepped(1, 0.2, 0.64), 1e-12 * DBL_EPSILON);
    snprintf(with, sizeof with, line, "0.1");
    assert_near(of(with), stepped(1, 2, 9), 1e-12 * DBL_EPSILON);
}

/* 6.8 eps a level, one and log2(2 n) along an axis, n of them where a wall is cooled; over the mean, and not the root
 * of the mean square. */
static void rounding_bound_of_transforms(void **state) {
    (void)state;
    const struct {
        const char *line;
        double levels;
    } row[] = {{"run rod-step so_ssph --dx 0.125 --stepper exact", 1 + 6},
               {"run rect-manufactured so_ssph --dx 0.1 --stepper exact", 1 + log2(20) + log2(14)},
               {"run rod-cooling so_ssph --dx 0.3/10 --stepper exact", 1 + 10},
               {"run plate-cooling so_ssph --dx 0.1 --stepper exact", 1 + 6 + 10}};
    for (int i = 0; i < 4; i++) {
        struct field f;
        double rounding = run(row[i].line, &f, NULL).rounding, sum = 0, square = 0;
        for (size_t k = 0; k < f.n; k++) sum += fabs(f.T[k]), square += f.T[k] * f.T[k];
        double uneven = sqrt(square / (double)f.n) / (sum / (double)f.n);
        assert_near(rounding / (DBL_EPSILON * (1 + 6.8 * row[i].levels * uneven)), 1, 1e-12);
        field_free(&f);
    }
}

/* A flux rounds extent/dx times more than the field, for the longer side; heat does not. */
static void rounding_bound_of_quantities(void **state) {
    (void)state;
    static const struct {
        const char *line;
        double more;
    } row[] = {{"run rod-gauss ftcs --dx 0.25 --dt 0.1 --quantity at:0.3", 1},
               {"run rod-cooling ftcs --dx 0.03 --fourier 0.2 --quantity flux_x_hi", 10},
               {"run rect-manufactured so_ssph --dx 0.1 --stepper exact --quantity flux_x_lo", 10},
               {"run rect-manufactured so_ssph --dx 0.1 --stepper exact --set height=1.3 --quantity flux_x_lo", 13}};
    for (int i = 0; i < 4; i++) {
        struct field f;
        struct quantity_value exact;
        struct result r = run(row[i].line, &f, &exact);
        assert_near(r.derived_rounding / r.rounding, row[i].more, 1e-9);
        assert_order(exact.error_bound, >, 0);
        assert_near(r.derived_bound * fabs(exact.value) / exact.error_bound, 1, 1e-12);
        assert_near(r.error[NORM_QUANTITY] * fabs(exact.value), fabs(r.derived - exact.value),
                    1e-12 * fabs(exact.value));
        field_free(&f);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rounding_bound_of_time_steps),
        cmocka_unit_test(claimed_steps_are_capped_by_round_off),
        cmocka_unit_test(rounding_bound_of_transforms),
        cmocka_unit_test(rounding_bound_of_quantities),
    };
    return cmocka_run_group_tests_name("run", tests, NULL, NULL);
}
