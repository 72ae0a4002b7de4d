/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A command line that is run and kept: its failure, and its error against a later or a rounded solution. */
#include "verification/judge/run.h"

#include "references/scene.h"
#include "solver/status.h"
#include "verification/unit/near.h"

#include <math.h>

/* A command that fails is named with its reason; one of another verb is read and not run. */
static void failed_command_gives_its_reason(void **state) {
    (void)state;
    struct command_run run;
    struct failure why;
    assert_int_equal(command_run_line(&run, "run rod-step so_ssph --dx %s", "0.3"), STATUS_INPUT);
    assert_int_equal(command_run_check(&run, &why), STATUS_INPUT);
    assert_has(why.text, "heatladder run rod-step so_ssph --dx 0.3: ");
    command_run_free(&run);
    assert_int_equal(command_run_line(&run, "reference rod-cosine --at 0.31 --time %g", 1.7), STATUS_OK);
    assert_near(run.typed.time.value[0], 1.7, 0);
    assert_null(run.field.T);
    const double kappa = 0.013, mode = 3, pi = M_PI, x[2] = {0.31, 0};
    assert_near(command_run_exact(&run, x, 1.7) - command_run_exact(&run, x, 1e9),
                (command_run_exact(&run, x, 0) - command_run_exact(&run, x, 1e9)) *
                    exp(-kappa * pow(mode * pi, 2) * 1.7),
                1e-12);
    command_run_free(&run);
    assert_int_equal(command_run_line(&run, "%0500d", 7), STATUS_INPUT);
    command_run_free(&run);
}

static double exact(const struct command_run *run, const double x[2], double t) {
    const struct experiment *e = &run->typed.experiment;
    return e->scene->published ? e->scene->published(&e->problem, x, t) : command_run_exact(run, x, t);
}

/* Against the solution (as published, if it is) later by 0.25 s, or rounded to two decimals. */
static void field_file_has_the_relative_error(void **state) {
    (void)state;
    static const char *const line[] = {
        "run rod-cosine voronoi_flux --dx 0.1 --layout jitter --jitter 0.3 --set L=1.3 --dt 0.1",
        "run rod-step ftcs --dx 0.5 --dt 1"};
    for (int i = 0; i < 2; i++) {
        struct command_run run;
        assert_int_equal(command_run_line(&run, "%s", line[i]), STATUS_OK);
        const struct field *f = &run.field;
        double late = 0, rounded = 0, whole[2] = {0};
        for (size_t k = 0; k < f->n; k++) {
            double x[] = {f->x[0][k], 0}, w = f->weight ? f->weight[k] : 1;
            double T[] = {exact(&run, x, f->time + 0.25), rint(100 * exact(&run, x, f->time)) / 100};
            late += w * fabs(f->T[k] - T[0]), whole[0] += w * fabs(T[0]);
            rounded += w * fabs(f->T[k] - T[1]), whole[1] += w * fabs(T[1]);
        }
        assert_near(command_run_error(&run, 0, 0.25), late / whole[0], 1e-12);
        assert_near(command_run_error(&run, 2, 0), rounded / whole[1], 1e-12);
        command_run_free(&run);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(field_file_has_the_relative_error),
        cmocka_unit_test(failed_command_gives_its_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
