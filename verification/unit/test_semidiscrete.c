/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reference of a ladder in time without an exact stepper, on methods with given errors: T = (1 +
 * part D dt^order) T_exact of the rungs' stepper, (1 + wrong/N^2) T_exact of the polynomials in N steps. */
#include "verification/judge/ladder.h"

#include "references/scene.h"
#include "solver/space/operator.h"
#include "verification/case/command.h"
#include "verification/judge/run.h"
#include "verification/judge/time_step.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double D = 0.77;

static int answer(const struct problem *p, const struct options *o, double part, double wrong, struct field *f,
                  struct failure *why) {
    enum { POINTS = 40 };
    if (o->stepper == STEPPER_EXACT) return refuse(why, STATUS_NOT_APPLICABLE, "--stepper exact: not here");
    double step = o->dt > 0 ? o->dt : o->fourier * o->dx * o->dx / p->material[0].k[0];
    field_alloc(f, 1, POINTS);
    f->time = p->t_end, f->steps = (long long)ceil(p->t_end / step - 1e-9), f->stages = 1;
    f->dt = p->t_end / (double)f->steps;
    double error = part * D * pow(f->dt, o->stepper == STEPPER_EULER ? 1 : 2);
    if (o->stepper == STEPPER_CHEBYSHEV) error = wrong / (double)(f->steps * f->steps);
    for (int i = 0; i < POINTS; i++) {
        double x[2] = {p->lo[0] + (i + 0.5) * (p->hi[0] - p->lo[0]) / POINTS, 0};
        f->x[0][i] = x[0];
        f->T[i] = (1 + error) * scene_exact(scene_find("rod-gauss"), p, x, p->t_end).temperature;
    }
    return STATUS_OK;
}

static int solve_real(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                      struct failure *why) {
    (void)m;
    return answer(p, o, 1, 5e-10, f, why);
}

static int solve_off(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                     struct failure *why) {
    (void)m;
    if (o->stepper == STEPPER_CHEBYSHEV && o->dt > 0.4) return refuse(why, STATUS_UNSTABLE, "T grew");
    return answer(p, o, 1, 6.4e-7, f, why);
}

static int solve_wrong(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                       struct failure *why) {
    (void)m;
    return answer(p, o, 1.0 / 64, 0.6, f, why);
}

static const struct scheme scheme;
static const struct method real = {"real", "", "stepper", &scheme, solve_real};
static const struct method off = {"off", "", "stepper", &scheme, solve_off};
static const struct method wrong = {"wrong", "", "stepper", &scheme, solve_wrong};

static void climb(const char *options, const struct method *m, int status, struct ladder *l, struct failure *why) {
    struct command r;
    char line[160];
    snprintf(line, sizeof line, "ladder rod-gauss ftcs --dx 0.5 %s", options);
    if (command_read(line, &r, why)) fail_msg("%s", why->text);
    r.experiment.method = m;
    r.experiment.options.domain = DOMAIN_WHOLE; /* these methods know of no lattice, nor of its symmetry */
    int got = ladder_run(&r.experiment, &r.rungs, l, why);
    if (got != status) fail_msg("%s: status %d, %s", line, got, why->text);
    command_free(&r);
    ladder_free(l);
}

/* t_end = 5 s: one step and two agree to 3.75e-10; or, with eigenvalues off the axis, 8 steps are too few and 16
 * the first that are done, 16 and 32 are 1.9e-9 apart and
 * 32 and 64 agree to 4.7e-10. */
static void semidiscrete_reference_needs_two_agreeing_runs(void **state) {
    (void)state;
    static const struct {
        const char *options;
        const struct method *method;
        double wrong;
        int steps, order;
    } tried[] = {{"--dt 0.8,0.4,0.2,0.1 --stepper rkl2", &real, 5e-10, 2, 2},
                 {"--dt 0.8,0.4,0.2,0.1 --stepper euler", &real, 5e-10, 2, 1},
                 {"--fourier 0.032,0.016,0.008,0.004 --stepper rkl2", &real, 5e-10, 2, 2},
                 {"--dt 0.8,0.4,0.2,0.1 --stepper rkl2", &off, 6.4e-7, 64, 2}};
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    for (int i = 0; i < 4; i++) {
        climb(tried[i].options, tried[i].method, STATUS_OK, l, &why);
        double left = tried[i].wrong / tried[i].steps / tried[i].steps;
        assert_int_equal(l->semidiscrete_steps, tried[i].steps);
        assert_near(l->semidiscrete_error / (3 * left), 1, 1e-5);
        assert_near(l->rung[0].reference_error, l->semidiscrete_error, 0);
        assert_near(l->error[3] / (D * pow(l->x[3], tried[i].order) - left), 1, 1e-6);
        assert_near(l->slope.value, tried[i].order, 0.01);
        assert_int_equal(l->slope.n, 4);
    }
    free(l);
}

/* 256 steps differ from 128 by 3 * 0.6/256^2 = 2.7e-5, which is 0.23 of dt^2 D/64 at the finest and 0.06 at the next
 */
static void inaccurate_semidiscrete_reference_is_reported(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("--dt 0.8,0.4,0.2,0.1 --stepper rkl2 --expect 1.5,2.5", &wrong, STATUS_OK, l, &why);
    assert_int_equal(l->semidiscrete_steps, 256);
    assert_int_equal(l->slope.n, 3);
    assert_has(l->window.left_out[3], "reference floor");
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    free(l);
}

/* Both references are the same: the particles of a cloud without jitter against those of the lattice. */
static void semidiscrete_and_exact_steppers_agree(void **state) {
    (void)state;
    static const char *const lines[] = {"ladder rod-cosine so_ssph --dx 1/40 --dt 0.1,0.05 --stepper rkl2",
                                        "ladder rod-cosine so_ssph --dx 1/40 --dt 0.1,0.05 --stepper rkl2 "
                                        "--layout jitter --jitter 0"};
    struct semidiscrete reference[2];
    struct failure why;
    for (int i = 0; i < 2; i++) {
        struct command r;
        if (command_read(lines[i], &r, &why)) fail_msg("%s", why.text);
        r.experiment.options.dt = 0.05;
        if (semidiscrete_solve(&r.experiment, &reference[i], &why)) fail_msg("%s", why.text);
        command_free(&r);
    }
    double most = 0, size = 0;
    for (size_t i = 0; i < reference[1].field.n; i++) {
        most += fabs(reference[1].field.T[i] - reference[0].field.T[i]);
        size += fabs(reference[0].field.T[i]);
    }
    assert_int_equal(reference[0].steps, 0);
    assert_near(reference[0].error, 0, 0);
    assert_int_equal(reference[1].steps, 2);
    assert_order(reference[1].error, <, 1e-12);
    assert_near(most / size, 0, 1e-12);
    for (int i = 0; i < 2; i++) field_free(&reference[i].field);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(semidiscrete_reference_needs_two_agreeing_runs),
        cmocka_unit_test(inaccurate_semidiscrete_reference_is_reported),
        cmocka_unit_test(semidiscrete_and_exact_steppers_agree),
    };
    return cmocka_run_group_tests_name("reference", tests, NULL, NULL);
}
