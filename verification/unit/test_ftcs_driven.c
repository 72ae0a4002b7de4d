/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The finite differences at walls that change in time. */

#include "solver/field.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "solver/shape.h"

#include "verification/unit/ftcs_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

static const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};

/* Euler's step has no error where T is linear in t, and the differences none where it is quadratic in x: whatever the
 * dimension, the layout and the kinds of the walls, only data of another time or a ghost without dT_w/dt would. */
static void quadratic_that_rises_evenly_is_exact(void **state) {
    (void)state;
    for (int turn = 0; turn < 36; turn++) {
        struct problem p = box(0, 0, 0);
        const int node = turn / 2 % 2, first = turn / 4 % 3;
        struct options o = {.dx = 0.115, .fourier = 0.1, .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
        p.dim = turn / 12 + 1;
        for (int s = 0; s < SIDES; s++) {
            p.side[s] = (enum side_kind)((s + first) % (node ? 2 : 3));
            p.robin[s] = 0.6 + 0.2 * s;
        }
        quadratic_data(&p, 0.7);
        struct field f = solved(both[turn % 2], &p, &o);
        double worst = 0, x[DIM_MAX];
        for (size_t i = 0; i < f.n; i++) {
            field_place(&f, i, x);
            worst = fmax(worst, fabs(f.T[i] - quadratic_at(&p, x, p.t_end)));
        }
        assert_order(f.steps, >, 10);
        assert_near(worst, 0, 1e-12);
        field_free(&f);
    }
}

static double swinging(const struct problem *p, enum side s, const double *x, double t) {
    (void)x;
    return p->param[2] + (s == X_LO ? sin(9 * t) : 0);
}

static double swinging_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x;
    return s == X_LO ? 9 * cos(9 * t) : 0;
}

/* On one grid the differences of runs at dt, dt/2 and dt/4 have the ratio 2. */
static void changing_wall_is_of_first_order_in_dt(void **state) {
    (void)state;
    for (int m = 0; m < 2; m++) {
        struct problem p = rod(1);
        struct field f[3];
        double apart[2] = {0, 0};
        p.wall = swinging, p.wall_rate = swinging_rate, p.param[3] = 0;
        for (int k = 0; k < 3; k++) {
            struct options o = {.dx = 0.046, .dt = p.t_end / (200 << k)};
            f[k] = solved(both[m], &p, &o);
        }
        for (size_t i = 0; i < f[0].n; i++)
            for (int k = 0; k < 2; k++) apart[k] += fabs(f[k].T[i] - f[k + 1].T[i]);
        assert_order(apart[0], >, 1e-4);
        assert_near(apart[0] / apart[1], 2, 0.06);
        for (int k = 0; k < 3; k++) field_free(&f[k]);
    }
}

static long asked;

static double counted(const struct problem *p, enum side s, const double *x, double t) {
    asked++;
    return level(p, s, x, t);
}

static void steady_walls_are_read_once(void **state) {
    (void)state;
    long before = 0;
    for (int turn = 0; turn < 4; turn++) {
        struct problem p = plane(3, 2);
        struct options o = {.dx = 0.115, .dt = p.t_end / (turn % 2 ? 100 : 10)};
        asked = 0, p.wall = counted;
        struct field f = solved(both[turn / 2], &p, &o);
        if (turn % 2) assert_int_equal(asked, before);
        before = asked;
        field_free(&f);
    }
}

static double hot(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x;
    return s == X_LO ? 500 * t : 0;
}

static double hot_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x, (void)t;
    return s == X_LO ? 500 : 0;
}

/* The range of a stable run grows with that of the walls. */
static void hot_wall_is_no_instability(void **state) {
    (void)state;
    struct problem p = rod(1);
    struct options o = {.dx = 0.115, .fourier = 0.01};
    p.wall = hot, p.wall_rate = hot_rate;
    struct field f = solved(&method_ftcs, &p, &o);
    assert_order(f.T[0], >, 100);
    field_free(&f);
    struct failure why = {0};
    o.fourier = 0.7, p.t_end = 40;
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
}

static void matched_run_needs_steady_walls(void **state) {
    (void)state;
    struct problem p = rod(1);
    struct options o = {.dx = 0.046, .stepper = STEPPER_MATCHED};
    struct field f;
    struct failure why = {0};
    p.wall_rate = swinging_rate;
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "--stepper matched: the start and the steps of this run are derived for steady walls");
}

/* T = 3 + 0.7 t with the source and the held walls of a disc, a ring and a ball. */
static double three(const struct problem *p, const double *x) {
    (void)p, (void)x;
    return 3;
}

static double warming(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)x;
    return 3 + 0.7 * t;
}

static double warming_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0.7;
}

static double even_source(const struct problem *p, const double *x) {
    (void)x;
    return 0.7 * p->material[0].rho_c;
}

static void round_body_warms_evenly(void **state) {
    (void)state;
    for (int turn = 0; turn < 3; turn++) {
        struct problem p = {.dim = 2, .t_end = 0.4, .materials = 1, .material = {{{0.29, 0.29, 0.29}, 2.385}}};
        struct options o = {.dx = 0.1, .fourier = 0.3};
        if (turn == 2)
            shape_make_ball(&p, 0.9);
        else
            shape_round(&p, 0.4 * turn, 0.9);
        p.initial = three, p.wall = warming, p.wall_rate = warming_rate, p.source = even_source;
        struct field f = solved(&method_ftcs, &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], 3 + 0.7 * p.t_end, 1e-12);
        field_free(&f);
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quadratic_that_rises_evenly_is_exact),
        cmocka_unit_test(changing_wall_is_of_first_order_in_dt),
        cmocka_unit_test(steady_walls_are_read_once),
        cmocka_unit_test(hot_wall_is_no_instability),
        cmocka_unit_test(matched_run_needs_steady_walls),
        cmocka_unit_test(round_body_warms_evenly),
    };
    return cmocka_run_group_tests_name("ftcs_driven", tests, NULL, NULL);
}
