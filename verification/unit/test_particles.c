/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a problem to a field: the step that is asked for, the end that is reached, the heat that is counted, what must
 * stay as it is; and the steppers on one equation. */
#include "solver/method.h"

#include "solver/time/stepper.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

extern const struct method method_so_ssph, method_fo_ssph, method_brookshaw, method_ftcs;

/* F counts in the larger diffusivity, whichever axis has it; the step is shortened to end on time. */
static void steps_end_on_time(void **state) {
    (void)state;
    for (int swap = 0; swap < 2; swap++) {
        struct problem p = odd_rectangle();
        struct options o = {.dx = 0.05, .h = 1.23, .stepper = STEPPER_EULER, .fourier = 0.19};
        struct field f;
        struct failure why;
        if (swap) p.material[0].k[0] = 0.4, p.material[0].k[1] = 0.7;
        assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_OK);
        double asked = 0.19 * 0.05 * 0.05 / (0.7 / 1.3);
        assert_int_equal(f.steps, ceil(p.t_end / asked));
        assert_near(f.dt * (double)f.steps, p.t_end, 1e-16);
        field_free(&f);
    }
}

/* Uniform temperature and no flux: rho_c T length, each half its own. */
static double warm(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 1.7;
}

static double no_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 0;
}

static void heat_counts_each_material(void **state) {
    (void)state;
    struct problem p = odd_rod();
    struct options o = {.dx = 0.05, .h = 1.23, .stepper = STEPPER_RK2, .fourier = 0.1};
    struct field f;
    struct failure why;
    p.materials = 2, p.interface = 0.2, p.initial = warm, p.wall = no_flux;
    p.material[1] = (struct material){{0.2, 0.2}, 0.9};
    for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
    assert_int_equal(method_solve(&method_brookshaw, &p, &o, &f, &why), STATUS_OK);
    const double heat = 1.7 * (1.3 * 0.55 + 0.9 * 0.95); /* from -0.35 to 0.2 m and on to 1.15 m */
    for (int k = 0; k < 2; k++) assert_near(f.heat[k] / heat, 1, 1e-13);
    assert_near(f.spacing[0], 0.05, 1e-16);
    assert_near(f.spacing[1], 0, 0); /* a rod has none across */
    field_free(&f);
}

/* Heated through one end for so long that q t/(rho_c L) is 40 times the bend q L/k of the profile, which is all that
 * the initial data span: hot, but not unstable. */
static double heating(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)x;
    return s == X_HI ? 0.37 : 0;
}

static void a_heated_rod_is_not_unstable(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_brookshaw, &method_ftcs};
    for (int k = 0; k < 3; k++) {
        struct problem p = odd_rod();
        struct options o = {.dx = 0.05, .h = 1.23, .stepper = STEPPER_EULER, .fourier = 0.21};
        struct field f;
        struct failure why;
        double extent = p.hi[0] - p.lo[0], mean = 0;
        p.initial = warm, p.wall = heating, p.source = NULL;
        p.side[X_LO] = p.side[X_HI] = NEUMANN;
        p.t_end = 40 * extent * extent * p.material[0].rho_c / p.material[0].k[0];
        if (method_solve(all[k], &p, &o, &f, &why)) fail_msg("%s: %s", all[k]->name, why.text);
        for (size_t i = 0; i < f.n; i++) mean += f.T[i] / (double)f.n;
        assert_near(mean, 1.7 + 0.37 * p.t_end / (p.material[0].rho_c * extent), 1e-9 * mean);
        field_free(&f);
    }
}

/* First and second derivatives of a plane are exact on any cloud, and its walls are continued exactly: it stays. */
static double plane(const struct problem *p, const double x[2]) {
    (void)p;
    return 0.31 + 0.77 * x[0] + 0.29 * x[1];
}

static double plane_wall(const struct problem *p, enum side s, const double x[2]) {
    return p->side[s] == DIRICHLET ? plane(p, x) : p->material[0].k[1] * (s == Y_LO ? -0.29 : 0.29);
}

/* One wall that the start does not meet, with points on the walls: the start jumps there, whichever wall it is. */
static double warmer(const struct problem *p, enum side s, const double x[2]) {
    (void)x;
    return p->side[s] == DIRICHLET ? 2.9 : 0;
}

static void matched_refuses_a_jump_at_every_wall(void **state) {
    (void)state;
    for (int s = 0; s < 4; s++) {
        struct problem p = odd_rectangle();
        struct options o = {.dx = 0.05, .h = 1.23, .stepper = STEPPER_MATCHED, .layout = LAYOUT_NODE};
        struct field f;
        struct failure why;
        char where[40];
        p.initial = warm, p.wall = warmer, p.material[0].k[1] = p.material[0].k[0];
        for (int k = 0; k < 4; k++) p.side[k] = k == s ? DIRICHLET : NEUMANN;
        snprintf(where, sizeof where, "jump at %c = %.6g m", "xy"[s / 2], s % 2 ? p.hi[s / 2] : p.lo[s / 2]);
        assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
        if (!strstr(why.text, where)) fail_msg("%s: %s", where, why.text);
    }
}

/* One wall whose temperature varies along it, or on the way through the body alone. */
static double along_it(const struct problem *p, enum side s, const double x[2]) {
    return p->side[s] == DIRICHLET ? x[1 - s / 2] : 0;
}

static double through_it(const struct problem *p, enum side s, const double x[2]) {
    return p->side[s] == DIRICHLET ? x[s / 2] : 0;
}

static void first_derivatives_are_not_matched_where_a_wall_varies(void **state) {
    (void)state;
    for (int k = 0; k < 8; k++) {
        struct problem p = odd_rectangle();
        struct options o = {.dx = 0.05, .h = 1.23, .stepper = STEPPER_MATCHED, .sampling = SAMPLING_SPLINE};
        struct field f;
        struct failure why = {0};
        p.source = NULL, p.wall = k < 4 ? along_it : through_it, p.material[0].k[1] = p.material[0].k[0];
        for (int s = 0; s < 4; s++) p.side[s] = s == k % 4 ? DIRICHLET : NEUMANN;
        int status = method_solve(&method_fo_ssph, &p, &o, &f, &why);
        assert_int_equal(strstr(why.text, "a first derivative applied twice") != NULL, k < 4);
        if (!status) field_free(&f);
    }
}

static void planes_stay_on_any_cloud(void **state) {
    (void)state;
    const struct method *const of_planes[] = {&method_so_ssph, &method_fo_ssph};
    for (int m = 0; m < 2; m++) {
        struct problem p = odd_rectangle();
        struct options o = {.dx = 0.05, .h = 1.23, .layout = LAYOUT_JITTER, .jitter = 0.23, .seed = 3};
        struct field f;
        struct failure why;
        p.initial = plane, p.wall = plane_wall;
        o.stepper = STEPPER_EULER, o.fourier = 0.07;
        assert_int_equal(method_solve(of_planes[m], &p, &o, &f, &why), STATUS_OK);
        for (size_t i = 0; i < f.n; i++) {
            const double x[2] = {f.x[i], f.y[i]};
            assert_near(f.T[i], plane(&p, x), 1e-13); /* some 50 steps, each of a few dozen roundings of 1 K */
        }
        field_free(&f);
    }
}

static int march(enum stepper_name stepper, int stages, double alternation, double time, int steps, double *T) {
    size_t row[2] = {0, 0}, bytes = 0;
    double diagonal[1] = {-1};
    struct heat_operator a = {.n = 1, .state = 1, .row = row, .diagonal = diagonal};
    struct march m = {
        .stepper = stepper, .time = time, .steps = steps, .alternation = alternation, .stages = stages, .hi = 2};
    struct failure why;
    return stepper_march(&a, &m, T, &bytes, &why);
}

static void one_equation(void **state) {
    (void)state;
    const double dt = 0.23;
    double T = 1.3, euler = 1, midpoint = 1;
    for (int k = 0; k < 3; k++) euler *= 1 - dt, midpoint *= 1 - dt + dt * dt / 2;
    assert_int_equal(march(STEPPER_EULER, 1, 0, 3 * dt, 3, &T), STATUS_OK);
    assert_near(T, 1.3 * euler, 1e-15);
    T = 1.3;
    assert_int_equal(march(STEPPER_RK2, 2, 0, 3 * dt, 3, &T), STATUS_OK);
    assert_near(T, 1.3 * midpoint, 1e-15);
    T = 1.3; /* a long and a short step */
    assert_int_equal(march(STEPPER_EULER, 1, 0.3, 2 * dt, 2, &T), STATUS_OK);
    assert_near(T, 1.3 * (1 - 1.3 * dt) * (1 - 0.7 * dt), 1e-15);
}

static void what_is_not_a_number_is_unstable(void **state) {
    (void)state;
    double T = NAN;
    assert_int_equal(march(STEPPER_EULER, 1, 0, 0.1, 1, &T), STATUS_UNSTABLE);
    T = 1e300; /* out of bounds, though it is finite */
    assert_int_equal(march(STEPPER_EULER, 1, 0, 0.1, 1, &T), STATUS_UNSTABLE);
}

/* The least odd s of 3 or more with (s^2 + s - 2)/2 >= dt bound (Meyer, Balsara & Aslam 2014, eq. 19). */
static void stages_are_the_fewest(void **state) {
    (void)state;
    for (double z = 0.37; z < 400; z *= 1.31) {
        int s = stepper_of(STEPPER_RKL2)->count(z / 7.1, 7.1);
        assert_true(s % 2 == 1 && s >= 3 && (s * s + s - 2) / 2.0 >= z);
        int fewer = s - 2;
        assert_true(fewer < 3 || (fewer * fewer + fewer - 2) / 2.0 < z);
    }
}

/* With many stages a step is that of infinitely many, to 8/s^2 of its third-order term. */
static void stages_may_be_many(void **state) {
    (void)state;
    double many = 1.3, more = 1.3;
    assert_int_equal(march(STEPPER_RKL2, 9999, 0, 0.7, 2, &many), STATUS_OK);
    assert_int_equal(march(STEPPER_RKL2, 60001, 0, 0.7, 2, &more), STATUS_OK);
    assert_near(more, many, 1e-8);
    assert_near(more / 1.3, exp(-0.7), 2 * 0.35 * 0.35 * 0.35 / 18);
    assert_int_equal(stepper_of(STEPPER_RKL2)->count(1e12, 1e12), STEPPER_STAGES_MAX + 1);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_end_on_time),
        cmocka_unit_test(a_heated_rod_is_not_unstable),
        cmocka_unit_test(heat_counts_each_material),
        cmocka_unit_test(matched_refuses_a_jump_at_every_wall),
        cmocka_unit_test(first_derivatives_are_not_matched_where_a_wall_varies),
        cmocka_unit_test(planes_stay_on_any_cloud),
        cmocka_unit_test(one_equation),
        cmocka_unit_test(what_is_not_a_number_is_unstable),
        cmocka_unit_test(stages_are_the_fewest),
        cmocka_unit_test(stages_may_be_many),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
