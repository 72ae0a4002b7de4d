/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data that are taken a part of a step late, from two answers on one grid. */
#include "references/scene.h"
#include "solver/method.h"
#include "verification/fault/diagnosis.h"
#include "verification/unit/odd_problems.h"
#include "verification/unit/odd_scenes.h"

#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>

static struct field solved(const struct problem *p, double dx, double dt) {
    struct options o = {.dx = dx, .dt = dt, .stepper = STEPPER_EULER};
    struct failure why = {0};
    struct field f;
    if (method_solve(method_find("ftcs"), p, &o, &f, &why)) fail_msg("%s", why.text);
    return f;
}

/* The diagnosis of Euler steps of dt and 2 dt whose data are `late` steps late. */
static struct diagnosis diagnosed(const char *scene, enum fault_kind kind, double late) {
    struct problem p;
    struct field f[2];
    struct diagnosis d;
    odd_find(scene, &p);
    double dx = (p.hi[0] - p.lo[0]) / 18, dt = p.t_end / ceil(p.t_end / (0.1 * dx * dx / problem_diffusivity(&p)));
    for (int k = 0; k < 2; k++) {
        struct faulty with;
        double step = (2 - k) * dt;
        assert_int_equal(faulty_make(&p, (struct fault){kind, 0}, -late * step, &with), 1);
        f[k] = solved(&with.problem, dx, step);
    }
    for (size_t i = 0; i < f[0].n; i++) f[0].T[i] -= f[1].T[i];
    diagnosis_steps(&p, &f[1], f[0].T, f[0].dt - f[1].dt, &d);
    for (int k = 0; k < 2; k++) field_free(&f[k]);
    return d;
}

static void walls_of_another_time_are_named_with_their_size(void **state) {
    (void)state;
    static const char *const scenes_of[] = {"rod-driven", "plate-driven"};
    for (int s = 0; s < 2; s++)
        for (double late = -1; late <= 1; late += 0.5) {
            struct diagnosis d = diagnosed(scenes_of[s], FAULT_WALL_TIME, late);
            print_message("%s, %g steps late: %s\n", scenes_of[s], late, d.named ? d.what : "-");
            assert_int_equal(d.named, late != 0);
            if (late == 0) continue;
            assert_int_equal(d.fault.kind, FAULT_WALL_TIME);
            assert_near(d.size, -late, 0.05);
        }
}

static void sources_of_another_time_are_named_with_their_size(void **state) {
    (void)state;
    struct diagnosis d = diagnosed("wall-kirchhoff", FAULT_SOURCE_TIME, 0.5);
    assert_int_equal(d.named && d.fault.kind == FAULT_SOURCE_TIME, 1);
    assert_near(d.size, -0.5, 0.05);
    assert_int_equal(diagnosed("wall-kirchhoff", FAULT_SOURCE_TIME, 0).named, 0);
}

/* The phase of a wall is the same at every spacing.  The response to a phase is not proportional
 * to its size. */
static void phases_are_named_with_size_and_side(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        struct fault fault;
        double size; /* s */
    } row[] = {{"rod-driven", {FAULT_WALL_TIME, 0}, -0.8},
               {"plate-driven", {FAULT_WALL_TIME, 0}, 0.9},
               {"plate-driven", {FAULT_WALL_TIME, 1 + X_LO}, 1.1}};
    for (int k = 0; k < 3; k++) {
        const struct scene *s = scene_find(row[k].scene);
        struct problem p;
        struct faulty with;
        struct field f[2];
        struct diagnosis_rung rung[2];
        struct diagnosis d;
        struct failure why;
        odd_find(row[k].scene, &p);
        if (p.dim > 1) p.param[13] /= 2; /* t_end: a response in the plane takes a second */
        if (s->setup(&p, &why)) fail_msg("%s", why.text);
        faulty_make(&p, row[k].fault, row[k].size, &with);
        for (int i = 0; i < 2; i++) {
            double dx = (p.hi[0] - p.lo[0]) / (i ? 18 : 36);
            f[i] = solved(&with.problem, dx, 0.1 * dx * dx / problem_diffusivity(&p));
            double *exact = xcalloc(f[i].n, sizeof *exact), x[DIM_MAX];
            for (size_t j = 0; j < f[i].n; j++)
                exact[j] = scene_exact(s, &p, field_place(&f[i], j, x), p.t_end).temperature;
            rung[i] = (struct diagnosis_rung){&f[i], exact, dx, f[i].dt, NAN};
        }
        diagnosis_find(&p, &rung[0], &rung[1], &d);
        print_message("%s: %s\n", row[k].scene, d.what);
        assert_int_equal(d.named && d.fault.kind == row[k].fault.kind, 1);
        assert_int_equal(d.fault.at, row[k].fault.at);
        assert_string_equal(d.unit, "s");
        assert_near(d.size, row[k].size, 0.02);
        free(d.evidence);
        for (int i = 0; i < 2; i++) {
            free((void *)rung[i].exact);
            field_free(&f[i]);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_of_another_time_are_named_with_their_size),
        cmocka_unit_test(phases_are_named_with_size_and_side),
        cmocka_unit_test(sources_of_another_time_are_named_with_their_size),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("late data", tests, NULL, NULL);
}
