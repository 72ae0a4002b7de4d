/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The finite differences in a ball against exact statements. */

#include "solver/field.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "solver/shape.h"

#include "verification/unit/ftcs_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

static const double R = 1.3, K = 0.29, RHO_C = 2.385;

static double seven(const struct problem *p, const double *x) {
    (void)p, (void)x;
    return 7;
}

static double wall_of_seven(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 7;
}

static struct problem ball(enum side_kind kind) {
    struct problem p = {.t_end = 1.7, .materials = 1, .material = {{{K, K, K}, RHO_C}}};
    shape_make_ball(&p, R);
    p.side[X_HI] = kind, p.robin[X_HI] = 0.7;
    p.initial = seven, p.wall = wall_of_seven;
    return p;
}

static struct field solved_in_shells(const struct problem *p, int shells, double fourier) {
    struct options o = {.dx = R / shells, .fourier = fourier};
    return solved(&method_ftcs, p, &o);
}

/* 3 + 1.7 r^2: the differences along r are exact for it, and so is the slope that they give a wall. */
static double bowl(const struct problem *p, const double *x) {
    (void)p;
    return 3 + 1.7 * (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

static double sink(const struct problem *p, const double *x) {
    (void)p, (void)x;
    return -6 * 1.7 * K;
}

static double bowl_flux(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 2 * 1.7 * R * K;
}

static void steady_states_stay(void **state) {
    (void)state;
    for (enum side_kind kind = DIRICHLET; kind <= ROBIN; kind++) {
        struct problem p = ball(kind);
        if (kind == NEUMANN) p.initial = bowl, p.source = sink, p.wall = bowl_flux;
        struct field f = solved_in_shells(&p, 9, 0.2);
        assert_near(furthest_from_start(&p, &f), 0, 1e-11);
        field_free(&f);
    }
}

static double rough(const struct problem *p, const double *x) {
    return 7 + sin(1e4 * x[0] + p->param[0]) * cos(3e4 * x[1]) * cos(2e4 * x[2]);
}

/* J, entering through one half of the wall. */
static double upper_half(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)t;
    return x[2] > 0 ? 0.93 : 0;
}

static void heat_rises_by_the_flux(void **state) {
    (void)state;
    struct problem p = ball(NEUMANN);
    double volume = 0, heat = 0;
    p.initial = rough, p.wall = upper_half;
    struct field f = solved_in_shells(&p, 10, 0.3); /* an even number of bands */
    for (size_t i = 0; i < f.n; i++) volume += f.weight[i], heat += f.weight[i] * f.T[i] * RHO_C;
    assert_near(volume, 4 * PI / 3 * R * R * R, 1e-12);
    assert_near(f.heat[1], heat, 1e-10);
    assert_near(f.heat[1] - f.heat[0], 0.93 * p.t_end * 2 * PI * R * R, 1e-10);
    field_free(&f);
}

static double vertical(const struct problem *p, const double *x) {
    return p->param[0] + 1.1 * x[2] * x[2] * x[2] - x[0] * x[2];
}

/* Turned by one ray, or upside down, the data are those of other cells, and so is the solution. */
static void grid_keeps_its_symmetries(void **state) {
    (void)state;
    struct problem p = ball(ROBIN);
    p.initial = vertical, p.param[0] = 7;
    struct field f = solved_in_shells(&p, 6, 0.3);
    for (size_t i = 0; i < f.n; i++) { /* T(x, y, z) = T(x, -y, z), and T - steady part is odd in z */
        double x[DIM_MAX], y[DIM_MAX];
        field_place(&f, i, x);
        for (size_t j = 0; j < f.n; j++) {
            field_place(&f, j, y);
            if (fabs(x[0] - y[0]) + fabs(x[1] + y[1]) + fabs(x[2] - y[2]) < 1e-9) assert_near(f.T[i], f.T[j], 1e-12);
            if (fabs(x[0] - y[0]) + fabs(x[1] - y[1]) + fabs(x[2] + y[2]) < 1e-9)
                assert_near(f.T[i] - 7, 7 - f.T[j], 1e-12);
        }
    }
    field_free(&f);
}

enum { Q = 0, U = 1 };

/* The derivative of sin(q r)/(q r) along u: -j_1(q r) (u.x)/r, an eigenfunction for q R a root of j_1. */
static double oblique(const struct problem *p, const double *x) {
    double q = p->param[Q], r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]), s = q * r, along = 0;
    for (int a = 0; a < 3; a++) along += p->param[U + a] * x[a];
    return 7 - along / r * (sin(s) / (s * s) - cos(s) / s);
}

/* u from the axis to the equator: both angles, near the axis too, are of second order at a fixed F. */
static void oblique_mode_decays_at_second_order(void **state) {
    (void)state;
    for (int turn = 0; turn < 3; turn++) {
        const int shells[3] = {6, 12, 24};
        struct problem p = ball(DIRICHLET);
        double mean[3];
        p.initial = oblique, p.t_end = 0.5, p.param[Q] = 4.493409457909064 / R;
        p.param[U] = sin(0.7 * turn) * cos(0.3), p.param[U + 1] = sin(0.7 * turn) * sin(0.3);
        p.param[U + 2] = cos(0.7 * turn);
        double left = exp(-K / RHO_C * p.param[Q] * p.param[Q] * p.t_end);
        for (int k = 0; k < 3; k++) {
            struct field f = solved_in_shells(&p, shells[k], 0.3);
            double x[DIM_MAX];
            mean[k] = 0;
            for (size_t i = 0; i < f.n; i++) {
                field_place(&f, i, x);
                mean[k] += f.weight[i] * fabs(f.T[i] - 7 - left * (oblique(&p, x) - 7));
            }
            field_free(&f);
        }
        assert_near(log2(mean[1] / mean[2]), 2, 0.06);
        assert_near(log2(mean[0] / mean[1]), 2, 0.2);
    }
}

/* Four shells in a held wall have the largest eigenvalue of the part along r, 4.232 kappa/dr^2. */
static void steps_up_to_047_are_stable(void **state) {
    (void)state;
    struct problem p = ball(DIRICHLET);
    struct field f;
    struct failure why = {0};
    struct options o = {.dx = R / 4, .fourier = 0.47};
    const double most = R * R / 16 / K * RHO_C;
    p.initial = rough, p.t_end = 1000 * 0.47 * most;
    f = solved(&method_ftcs, &p, &o);
    assert_near(furthest_from_start(&(struct problem){.initial = seven}, &f), 0, 0.001);
    field_free(&f);
    o.fourier = 0.485, p.t_end = 1000 * o.fourier * most;
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
    assert_has(why.text, "is 0.485, stable up to 0.47");
}

static void anisotropic_ball_is_refused(void **state) {
    (void)state;
    struct problem p = ball(DIRICHLET);
    struct options o = {.dx = R / 8};
    struct field f;
    struct failure why = {0};
    p.material[0].k[2] = 0.3;
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "ftcs: takes one material with k_x = k_y = k_z in a ball");
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_states_stay),         cmocka_unit_test(heat_rises_by_the_flux),
        cmocka_unit_test(grid_keeps_its_symmetries),  cmocka_unit_test(oblique_mode_decays_at_second_order),
        cmocka_unit_test(steps_up_to_047_are_stable), cmocka_unit_test(anisotropic_ball_is_refused),
    };
    return cmocka_run_group_tests_name("ftcs_ball", tests, NULL, NULL);
}
