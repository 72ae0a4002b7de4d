/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Matched runs: refusals, order with a source. */
#include "solver/time/matched.h"

#include "verification/case/command.h"
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

/* A hot bar along one axis of a box. */
static double hot_bar(const struct problem *p, const double *x) {
    int along = (int)p->param[0];
    for (int a = 0; a < DIM_MAX; a++)
        if (a != along && fabs(x[a]) > 0.6) return 0;
    return 1;
}

/* Point samples of a brick in a box are taken, those of an endless bar along any axis are refused. */
static void jumps_along_two_axes_of_three_are_refused(void **state) {
    (void)state;
    struct command r = request("run cube-step so_ssph --dx 0.2 --set a=0.6 --set b=0.6 --set c=0.6");
    const struct experiment *e = &r.experiment;
    struct lattice l;
    struct failure why = {0};
    assert_int_equal(layout_lattice(&e->problem, &e->options, &l, &why), STATUS_OK);
    assert_int_equal(matched_check(&e->problem, &e->options, e->method->scheme, &l, &why), STATUS_OK);
    for (int a = 0; a < DIM_MAX; a++) {
        struct problem p = e->problem;
        p.param[0] = a, p.initial = hot_bar, p.jumps[a] = 0;
        p.side[2 * a] = p.side[2 * a + 1] = NEUMANN;
        for (int b = 0; b < DIM_MAX; b++) p.jump[b][0] = -0.6, p.jump[b][1] = 0.6;
        assert_int_equal(matched_check(&p, &e->options, e->method->scheme, &l, &why), STATUS_NOT_APPLICABLE);
        assert_non_null(strstr(why.text, "along two axes only"));
    }
    command_free(&r);
}

static double wave_number(const struct problem *p, int a) {
    return acos(-1) / (p->hi[a] - p->lo[a]);
}

static double wavy_source(const struct problem *p, const double *x) {
    int a = (int)p->param[0];
    return cos(wave_number(p, a) * x[a]);
}

/* rho_c dT/dt = kappa T_aa + cos(q x_a) between insulated walls, from T = 1. */
static double heated_error(const char *line, int a) {
    struct command r = request(line);
    struct experiment *e = &r.experiment;
    struct problem p = e->problem;
    struct field f;
    struct failure why;
    double q = wave_number(&p, a), rate = p.material[0].k[a] * q * q, most = 0, x[DIM_MAX];
    p.param[0] = a, p.initial = problem_start, p.start = 1, p.source = wavy_source;
    for (int b = 0; b < DIM_MAX; b++) p.mirror[b] = 0;
    if (method_solve(e->method, &p, &e->options, &f, &why)) fail_msg("%s", why.text);
    for (size_t i = 0; i < f.n; i++)
        most = fmax(most, fabs(f.T[i] - 1 + expm1(-rate * p.t_end) / rate * cos(q * field_place(&f, i, x)[a])));
    field_free(&f);
    command_free(&r);
    return most;
}

static void source_along_any_axis_is_of_fourth_order(void **state) {
    (void)state;
#define HEATED                                                                                                       \
    "run box-cosine so_ssph --stepper matched --h iso --t-end 8 --set kappa_y=0.01 --set kappa_z=0.01 --dx "
    for (int a = 0; a < DIM_MAX; a++)
        assert_near(log2(heated_error(HEATED "0.1", a) / heated_error(HEATED "0.05", a)), 4, 0.1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unmatched_steps_are_not_applicable),
        cmocka_unit_test(varying_walls_are_detected_on_each_side),
        cmocka_unit_test(jumps_along_two_axes_of_three_are_refused),
        cmocka_unit_test(source_along_any_axis_is_of_fourth_order),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("matched", tests, NULL, NULL);
}
