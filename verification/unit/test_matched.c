/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Matched runs that are refused. */
#include "solver/time/matched.h"

#include "verification/ladder/command.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

static struct command request(const char *line) {
    struct command r;
    struct failure why;
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    return r;
}

/* Good input that no step matches is not applicable; bad input, or a step given twice, is bad. */
static void unmatched_steps_are_not_applicable(void **state) {
    (void)state;
    static const struct {
        const char *line, *word;
        int status;
    } all[] = {
        {"run square-step so_ssph --stepper matched --h 1.1 --dx 0.1", "--h iso", STATUS_NOT_APPLICABLE},
        {"run square-step ftcs --stepper matched --dx 0.1", "isotropic", STATUS_NOT_APPLICABLE},
        {"run plate so_ssph --stepper matched --h iso --set T1=0 --set T3=0 --dx 0.01", "along one axis only",
         STATUS_NOT_APPLICABLE},
        {"run square-step so_ssph --stepper matched --h iso --dx 0.1 --dt 0.1", "--dt", STATUS_INPUT},
        {"run rod-gauss so_ssph --stepper matched --sampling spline --dx 0.5 --t-end 1e-3", "--t-end", STATUS_INPUT},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        struct command r = request(all[i].line);
        struct experiment *e = &r.experiment;
        struct field f;
        struct failure why = {0};
        assert_int_equal(method_solve(e->method, &e->problem, &e->options, &f, &why), all[i].status);
        if (!strstr(why.text, all[i].word)) fail_msg("'%s' is not in: %s", all[i].word, why.text);
        command_free(&r);
    }
}

static double along_y_hi(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)t;
    return s == Y_HI ? x[0] : 0;
}

/* A first derivative applied twice, on a rectangle that is 0 except on one side: refused for every such side. */
static void varying_walls_are_detected_on_each_side(void **state) {
    (void)state;
    struct command r = request("run square-step fo_ssph --dx 0.1 --sampling spline");
    const struct experiment *e = &r.experiment;
    struct problem p = e->problem;
    struct lattice l;
    struct failure why = {0};
    assert_int_equal(layout_lattice(&p, &e->options, &l, &why), STATUS_OK);
    assert_int_equal(matched_check(&p, &e->options, e->method->scheme, &l, &why), STATUS_OK);
    p.wall = along_y_hi;
    assert_int_equal(matched_check(&p, &e->options, e->method->scheme, &l, &why), STATUS_NOT_APPLICABLE);
    assert_non_null(strstr(why.text, "a first derivative applied twice"));
    command_free(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unmatched_steps_are_not_applicable),
        cmocka_unit_test(varying_walls_are_detected_on_each_side),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("matched", tests, NULL, NULL);
}
