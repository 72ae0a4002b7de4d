/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs of particles in a box: walls, steppers, symmetry of axes, the plane as a limit. */

#include "solver/method.h"
#include "solver/space/sample.h"
#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>

extern const struct method method_brookshaw, method_fo_ssph, method_so_ssph;

static struct field solved(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f;
    struct failure why;
    if (method_solve(m, p, o, &f, &why)) fail_msg("%s: %s", m->name, why.text);
    return f;
}

/* ---- A steady cubic with all twenty terms ---- */

/* x^a, a < 4, differentiated `by` times */
static void powers(double x, int by, double out[4]) {
    const double all[3][4] = {{1, x, x * x, x * x * x}, {0, 1, 2 * x, 3 * x * x}, {0, 0, 2, 6 * x}};
    for (int a = 0; a < 4; a++) out[a] = all[by][a];
}

/* Differentiated by[a] times along axis a. */
static double cubic_derivative(const double *x, const int by[DIM_MAX]) {
    double sum = 0, of[DIM_MAX][4];
    for (int d = 0; d < DIM_MAX; d++) powers(x[d], by[d], of[d]);
    for (int a = 0; a < 4; a++)
        for (int b = 0; a + b < 4; b++)
            for (int c = 0; a + b + c < 4; c++)
                sum += (0.31 + (7 * a + 5 * b + 3 * c + 4 * a * b + b * c) % 11 - 5) / 7 * of[0][a] * of[1][b] *
                       of[2][c];
    return sum;
}

static double cubic(const struct problem *p, const double *x) {
    (void)p;
    return cubic_derivative(x, (const int[]){0, 0, 0});
}

static double cubic_source(const struct problem *p, const double *x) {
    double sum = 0;
    for (int a = 0; a < 3; a++)
        sum -= p->material[0].k[a] * cubic_derivative(x, (const int[]){2 * (a == 0), 2 * (a == 1), 2 * (a == 2)});
    return sum;
}

static double cubic_wall(const struct problem *p, enum side s, const double *x, double t) {
    int axis = (int)s / 2, out = s % 2 ? 1 : -1;
    (void)t;
    if (p->side[s] == DIRICHLET) return cubic(p, x);
    return out * p->material[0].k[axis] * cubic_derivative(x, (const int[]){axis == 0, axis == 1, axis == 2});
}

static double farthest(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f = solved(m, p, o);
    double most = 0, x[DIM_MAX];
    for (size_t i = 0; i < f.n; i++) most = fmax(most, fabs(f.T[i] - p->initial(p, field_place(&f, i, x))));
    field_free(&f);
    return most;
}

/* Moments to order 2 on an even stencil, and first derivatives taken twice, are exact for a cubic. */
static void steady_cubic_is_preserved_between_all_walls(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw};
    for (int kinds = 0; kinds < 64; kinds += 3) /* each kind beside each */
        for (int m = 0; m < 3; m++)
            for (int node = 0; node < 2; node++) {
                struct problem p = odd_box();
                struct options o = {.dx = 0.1, .fourier = 0.09, .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
                for (int s = 0; s < SIDES; s++) p.side[s] = kinds >> s & 1 ? NEUMANN : DIRICHLET;
                if (m == 2) p.material[0].k[1] = p.material[0].k[2] = p.material[0].k[0];
                p.initial = cubic, p.wall = cubic_wall, p.source = cubic_source;
                assert_near(farthest(all[m], &p, &o), 0, 2e-13);
                o.fourier = 0, o.stepper = STEPPER_EXACT;
                assert_near(farthest(all[m], &p, &o), 0, 2e-13);
            }
}

/* ---- Steppers ---- */

/* Walls of every kind on every axis, and a source. */
static struct problem mixed_box(int turn) {
    struct problem p = odd_box();
    static const enum side_kind kinds[] = {DIRICHLET, NEUMANN, ROBIN, DIRICHLET, NEUMANN, ROBIN, NEUMANN};
    for (int s = 0; s < SIDES; s++) p.side[s] = kinds[(s + turn) % 7], p.robin[s] = 0.3 + 0.1 * s;
    p.source = cubic_source;
    return p;
}

static void exact_equals_chebyshev_and_the_limit_of_small_steps(void **state) {
    (void)state;
    for (int turn = 0; turn < 7; turn++) {
        struct problem p = mixed_box(turn);
        struct options o = {.dx = 0.1, .h = 1.1, .stepper = STEPPER_EXACT};
        p.t_end = 0.0173;
        struct field exact = solved(&method_so_ssph, &p, &o), other;
        o.stepper = STEPPER_CHEBYSHEV;
        other = solved(&method_so_ssph, &p, &o);
        assert_near(field_farthest(&other, exact.T), 0, 1e-13);
        field_free(&other);
        double off[2];
        for (int half = 0; half < 2; half++) {
            o.stepper = STEPPER_EULER, o.dt = p.t_end / (40 << half);
            other = solved(&method_so_ssph, &p, &o);
            off[half] = field_farthest(&other, exact.T);
            field_free(&other);
        }
        assert_near(off[0] / off[1], 2, 0.1); /* Euler's error is dt/2 of the same function */
        field_free(&exact);
    }
}

/* ---- Axes ---- */

/* The problem with axis a in place of axis a + 1; its data are the untouched problem. */
static void turned_point(const double *x, double to[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) to[a] = x[(a + 1) % DIM_MAX];
}

static double turned_initial(const struct problem *p, const double *x) {
    const struct problem *first = p->data;
    double to[DIM_MAX];
    turned_point(x, to);
    return first->initial(first, to);
}

static double turned_source(const struct problem *p, const double *x) {
    const struct problem *first = p->data;
    double to[DIM_MAX];
    turned_point(x, to);
    return first->source(first, to);
}

static double turned_wall(const struct problem *p, enum side s, const double *x, double t) {
    const struct problem *first = p->data;
    double to[DIM_MAX];
    turned_point(x, to);
    return first->wall(first, (enum side)((s + 4) % SIDES), to, t);
}

static struct problem turned(const struct problem *first) {
    struct problem p = *first;
    for (int a = 0; a < DIM_MAX; a++) {
        int to = (a + 1) % DIM_MAX;
        p.lo[to] = first->lo[a], p.hi[to] = first->hi[a], p.material[0].k[to] = first->material[0].k[a];
        for (int s = 0; s < 2; s++)
            p.side[2 * to + s] = first->side[2 * a + s], p.robin[2 * to + s] = first->robin[2 * a + s];
    }
    p.data = first, p.initial = turned_initial, p.wall = turned_wall, p.source = turned_source;
    return p;
}

static void axes_are_equivalent(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_fo_ssph};
    static const enum stepper_name steppers[] = {STEPPER_EXACT, STEPPER_RK2};
    for (int turn = 0; turn < 7; turn++) {
        struct problem p = mixed_box(turn), q = turned(&p);
        struct options o = {.dx = 0.1, .stepper = steppers[turn % 2], .sampling = (enum sampling)(turn % 3)};
        struct field f = solved(all[turn % 2], &p, &o), g = solved(all[turn % 2], &q, &o);
        for (int a = 0; a < DIM_MAX; a++) assert_int_equal(f.shape[a], g.shape[(a + 1) % DIM_MAX]);
        size_t n = (size_t)f.shape[0], at = 0;
        for (size_t k = 0; k < (size_t)f.shape[2]; k++)
            for (size_t j = 0; j < (size_t)f.shape[1]; j++)
                for (size_t i = 0; i < n; i++, at++)
                    assert_near(f.T[at], g.T[(j * n + i) * (size_t)f.shape[2] + k], 1e-13);
        field_free(&f);
        field_free(&g);
    }
}

static double flat_initial(const struct problem *p, const double *x) {
    double pi = acos(-1), u = (x[0] - p->lo[0]) / (p->hi[0] - p->lo[0]),
           v = (x[1] - p->lo[1]) / (p->hi[1] - p->lo[1]);
    return 1 + 0.7 * cos(2 * pi * u) * cos(pi * v) + 0.3 * cos(pi * u);
}

/* Uniform along z between insulated sides: uniform for ever, and the plane's solution up to O(dx^2). */
static void body_uniform_along_z_is_a_plane(void **state) {
    (void)state;
    double off[3];
    for (int rung = 0; rung < 3; rung++) {
        struct problem p = odd_box(), plane = odd_rectangle();
        struct options o = {.dx = 0.1 / (1 << rung), .h = 1.1, .stepper = STEPPER_EXACT};
        for (int s = 0; s < SIDES; s++) p.side[s] = plane.side[s] = NEUMANN;
        p.t_end = plane.t_end = 0.2;
        p.initial = plane.initial = flat_initial, p.wall = plane.wall = problem_held;
        struct field f = solved(&method_so_ssph, &p, &o), g = solved(&method_so_ssph, &plane, &o);
        size_t layer = g.n;
        off[rung] = 0;
        for (size_t i = 0; i < f.n; i++) {
            assert_near(f.T[i], f.T[i % layer], 1e-13);
            if (i < layer) off[rung] = fmax(off[rung], fabs(f.T[i] - g.T[i]));
        }
        field_free(&f);
        field_free(&g);
    }
    assert_near(log2(off[1] / off[2]), 2, 0.15);
}

/* ---- Samples ---- */

static double factor(const struct problem *p, const double *x) {
    int a = (int)p->param[0];
    return x[0] < p->jump[0][0] ? 1 + sin((1.3 + a) * x[0]) : 0.4 * x[0];
}

static double product(const struct problem *p, const double *x) {
    const struct problem *rods = p->data;
    return factor(&rods[0], &x[0]) * factor(&rods[1], &x[1]) * factor(&rods[2], &x[2]);
}

/* Averages of a product are products of averages, also across the jumps and the images beyond insulated walls. */
static void samples_of_products_are_products(void **state) {
    (void)state;
    static const double jump[DIM_MAX] = {0.41, 0.77, 0.23};
    struct problem p = odd_box(), rods[DIM_MAX];
    struct options o = {.dx = 0.1};
    struct failure why;
    struct lattice l;
    p.data = rods, p.initial = product, p.wall = problem_held;
    for (int s = 0; s < SIDES; s++) p.side[s] = NEUMANN;
    for (int a = 0; a < DIM_MAX; a++) p.jumps[a] = 1, p.jump[a][0] = jump[a];
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
    for (int how = SAMPLING_POINT; how <= SAMPLING_SPLINE; how++) {
        double X[DIM_MAX][20], *T = xcalloc((size_t)(l.n[0] * l.n[1] * l.n[2]), sizeof *T);
        for (int a = 0; a < DIM_MAX; a++) {
            rods[a] = p;
            rods[a].dim = 1, rods[a].initial = factor, rods[a].param[0] = a, rods[a].jump[0][0] = jump[a];
            rods[a].lo[0] = p.lo[a], rods[a].hi[0] = p.hi[a];
            struct lattice rod = {.dim = 1, .n = {l.n[a], 1, 1}, .dx = {l.dx[a], 1, 1}, .first = {l.first[a]}};
            sample_lattice(&rods[a], (enum sampling)how, &rod, X[a]);
        }
        sample_lattice(&p, (enum sampling)how, &l, T);
        for (int i = 0; i < l.n[0] * l.n[1] * l.n[2]; i++)
            assert_near(T[i], X[0][i % l.n[0]] * X[1][i / l.n[0] % l.n[1]] * X[2][i / l.n[0] / l.n[1]], 1e-14);
        free(T);
    }
}

static double bent_along_one_axis(const struct problem *p, const double *x) {
    int a = (int)p->param[0];
    return fmax(0, x[a] - p->lo[a] - 0.2);
}

/* A wall is met only if it is met on every line. */
static void walls_are_met_on_all_lines(void **state) {
    (void)state;
    for (int s = 0; s < SIDES; s++)
        for (int a = 0; a < DIM_MAX; a++) {
            struct problem p = odd_box();
            struct options o = {.dx = 0.1};
            struct lattice l;
            struct failure why;
            if (a == s / 2) continue;
            p.param[0] = a, p.initial = bent_along_one_axis, p.wall = problem_held, p.side[s] = DIRICHLET;
            assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
            assert_int_equal(sample_meets_wall(&p, &l, (enum side)s), 0);
            p.hi[a] = p.lo[a] + 0.2;
            assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
            assert_int_equal(sample_meets_wall(&p, &l, (enum side)s), 1);
        }
}

static double cold(const struct problem *p, const double *x) {
    (void)p, (void)x;
    return 0;
}

static void any_side_warms_a_cold_box(void **state) {
    (void)state;
    for (int s = 0; s < SIDES; s++) {
        struct problem p = odd_box();
        struct options o = {.dx = 0.1, .stepper = STEPPER_EXACT};
        for (int k = 0; k < SIDES; k++) p.side[k] = DIRICHLET, p.held[k] = k == s;
        p.initial = cold, p.wall = problem_held;
        struct field f = solved(&method_so_ssph, &p, &o);
        assert_order(field_largest(&f), >, 0.1);
        field_free(&f);
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_cubic_is_preserved_between_all_walls),
        cmocka_unit_test(exact_equals_chebyshev_and_the_limit_of_small_steps),
        cmocka_unit_test(axes_are_equivalent),
        cmocka_unit_test(body_uniform_along_z_is_a_plane),
        cmocka_unit_test(samples_of_products_are_products),
        cmocka_unit_test(walls_are_met_on_all_lines),
        cmocka_unit_test(any_side_warms_a_cold_box),
    };
    return cmocka_run_group_tests_name("box_runs", tests, NULL, NULL);
}
