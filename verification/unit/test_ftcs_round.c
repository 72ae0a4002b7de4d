/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The finite volumes in a disc, a ring and a ball against exact statements. */

#include "solver/field.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "solver/shape.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

extern const struct method method_ftcs;

static const double PI = 3.14159265358979323846, R = 1.3, HOLE = 0.4, K = 0.29, RHO_C = 2.385;

enum body { DISC, RING, BALL, BODIES };

static double seven(const struct problem *p, const double *x) {
    (void)x;
    return 7 + p->param[0];
}

static double wall_of_seven(const struct problem *p, enum side s, const double *x, double t) {
    (void)s, (void)x;
    return 7 + p->param[0] + p->param[1] * t;
}

static struct problem made(enum body body, enum side_kind kind) {
    struct problem p = {.dim = 2, .t_end = 1.7, .materials = 1, .material = {{{K, K, K}, RHO_C}}};
    if (body == BALL)
        shape_make_ball(&p, R);
    else
        shape_round(&p, body == RING ? HOLE : 0, R);
    for (int s = 0; s < 2; s++) p.side[s] = kind, p.robin[s] = 0.7;
    p.initial = seven, p.wall = wall_of_seven;
    return p;
}

static struct field solved(const struct problem *p, double rings, double fourier) {
    struct field f;
    struct failure why = {0};
    struct options o = {.dx = (p->radius[1] - p->radius[0]) / rings, .fourier = fourier};
    if (method_solve(&method_ftcs, p, &o, &f, &why)) fail_msg("%s", why.text);
    return f;
}

/* ---- Fields that the differences represent ---- */

static double squared(const struct problem *p, const double *x) {
    return x[0] * x[0] + x[1] * x[1] + (p->dim == 3 ? x[2] * x[2] : 0);
}

/* 3 + 1.7 r^2: the differences along r are exact for it, and so is the slope that they give a wall. */
static double bowl(const struct problem *p, const double *x) {
    return 3 + 1.7 * squared(p, x);
}

static double sink(const struct problem *p, const double *x) {
    (void)x;
    return RHO_C * p->param[1] - 2 * p->dim * 1.7 * K;
}

static double bowl_flux(const struct problem *p, enum side s, const double *x, double t) {
    (void)t;
    return (s == X_HI ? 2 : -2) * 1.7 * sqrt(squared(p, x)) * K;
}

static double even_source(const struct problem *p, const double *x) {
    (void)x;
    return RHO_C * p->param[1];
}

static double even_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)s, (void)x, (void)t;
    return p->param[1];
}

/* Steady, and rising evenly; some thousand steps of a few roundings each: 1e-11 of T. */
static void exact_fields_stay(void **state) {
    (void)state;
    for (int turn = 0; turn < 18; turn++) {
        const enum side_kind kind = (enum side_kind)(turn % 3);
        struct problem p = made((enum body)(turn / 3 % 3), kind);
        double x[DIM_MAX];
        p.param[1] = turn / 9 * 0.7;
        p.source = even_source, p.wall_rate = turn / 9 ? even_rate : NULL;
        if (kind == NEUMANN) p.initial = bowl, p.source = sink, p.wall = bowl_flux, p.wall_rate = NULL;
        struct field f = solved(&p, 9, 0.2);
        for (size_t i = 0; i < f.n; i++)
            assert_near(f.T[i], p.initial(&p, field_place(&f, i, x)) + p.param[1] * p.t_end, 7e-11);
        field_free(&f);
    }
}

/* ---- Heat ---- */

static double rough(const struct problem *p, const double *x) {
    return 7 + sin(1e4 * x[0] + p->param[0]) * cos(3e4 * x[1]) * (p->dim == 3 ? cos(2e4 * x[2]) : 1);
}

/* Through one half of the walls. */
static double one_half(const struct problem *p, enum side s, const double *x, double t) {
    (void)s, (void)t;
    return x[p->dim - 1] > 0 ? 0.93 : 0;
}

static void heat_rises_by_the_flux(void **state) {
    (void)state;
    static const double wall[BODIES] = {PI * 1.3, PI * (1.3 + 0.4), 2 * PI * 1.3 * 1.3}; /* half of it */
    static const double rings[BODIES] = {11, 9, 10}; /* an even number of rays and bands */
    for (int body = 0; body < BODIES; body++) {
        struct problem p = made((enum body)body, NEUMANN);
        double volume = 0, heat = 0;
        p.initial = rough, p.wall = one_half;
        struct field f = solved(&p, rings[body], 0.3);
        for (size_t i = 0; i < f.n; i++) volume += f.weight[i], heat += f.weight[i] * f.T[i] * RHO_C;
        assert_near(volume, shape_volume(&p), 1e-12);
        assert_near(f.heat[1], heat, 1e-10);
        assert_near(f.heat[1] - f.heat[0], 0.93 * p.t_end * wall[body], 1e-10);
        field_free(&f);
    }
}

/* ---- Angles ---- */

static double vertical(const struct problem *p, const double *x) {
    (void)p;
    return 7 + 1.1 * x[2] * x[2] * x[2] - x[0] * x[2];
}

/* Upside down, or mirrored at y = 0, the data of a ball are those of other cells, and so is the solution. */
static void grid_keeps_its_symmetries(void **state) {
    (void)state;
    struct problem p = made(BALL, ROBIN);
    p.initial = vertical;
    struct field f = solved(&p, 6, 0.3);
    for (size_t i = 0; i < f.n; i++) {
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

enum { Q = 2, U = 3 };

/* The derivative of sin(q r)/(q r) along u: -j_1(q r) (u.x)/r, an eigenfunction for q R a root of j_1. */
static double oblique(const struct problem *p, const double *x) {
    double q = p->param[Q], r = sqrt(squared(p, x)), s = q * r, along = 0;
    for (int a = 0; a < 3; a++) along += p->param[U + a] * x[a];
    return 7 - along / r * (sin(s) / (s * s) - cos(s) / s);
}

/* u from the axis to the equator: both angles, near the axis too, are of second order at a fixed F. */
static void oblique_mode_decays_at_second_order(void **state) {
    (void)state;
    for (int turn = 0; turn < 3; turn++) {
        const int shells[3] = {6, 12, 24};
        struct problem p = made(BALL, DIRICHLET);
        double mean[3];
        p.initial = oblique, p.t_end = 0.5, p.param[Q] = 4.493409457909064 / R;
        p.param[U] = sin(0.7 * turn) * cos(0.3), p.param[U + 1] = sin(0.7 * turn) * sin(0.3);
        p.param[U + 2] = cos(0.7 * turn);
        double left = exp(-K / RHO_C * p.param[Q] * p.param[Q] * p.t_end), x[DIM_MAX];
        for (int k = 0; k < 3; k++) {
            struct field f = solved(&p, shells[k], 0.3);
            mean[k] = 0;
            for (size_t i = 0; i < f.n; i++)
                mean[k] += f.weight[i] * fabs(f.T[i] - 7 - left * (oblique(&p, field_place(&f, i, x)) - 7));
            field_free(&f);
        }
        assert_near(log2(mean[1] / mean[2]), 2, 0.06);
        assert_near(log2(mean[0] / mean[1]), 2, 0.2);
    }
}

/* ---- Limits ---- */

/* Rough data decay up to 1/2 and in a ball 0.47, beyond they grow; four shells in a held wall have the largest
 * eigenvalue of the part along r, 4.232 kappa/dr^2. */
static void steps_up_to_the_limit_are_stable(void **state) {
    (void)state;
    static const double rings[BODIES] = {16, 9, 4}, limit[BODIES] = {0.5, 0.5, 0.47};
    for (int body = 0; body < BODIES; body++) {
        struct problem p = made((enum body)body, DIRICHLET);
        struct options o = {.dx = (p.radius[1] - p.radius[0]) / rings[body]};
        struct field f;
        struct failure why = {0};
        p.initial = rough, p.t_end = 1000 * limit[body] * o.dx * o.dx / K * RHO_C;
        f = solved(&p, rings[body], limit[body]);
        for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], 7, 0.1);
        field_free(&f);
        o.fourier = body == BALL ? 0.485 : 0.516, p.t_end *= o.fourier / limit[body];
        assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
        assert_has(why.text, body == BALL ? "is 0.485, stable up to 0.47" : "is 0.516, stable up to 0.5");
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_fields_stay),
        cmocka_unit_test(heat_rises_by_the_flux),
        cmocka_unit_test(grid_keeps_its_symmetries),
        cmocka_unit_test(oblique_mode_decays_at_second_order),
        cmocka_unit_test(steps_up_to_the_limit_are_stable),
    };
    return cmocka_run_group_tests_name("ftcs_round", tests, NULL, NULL);
}
