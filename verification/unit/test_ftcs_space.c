/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The finite differences in a box against exact statements. */

#include "solver/field.h"
#include "solver/method.h"
#include "solver/problem.h"

#include "verification/unit/ftcs_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

static const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};

/* ---- Symbol and order ---- */

static void modes_decay_by_the_amplification_factor(void **state) {
    (void)state;
    const double dx = 0.046, dt = 0.00061;
    for (int turn = 0; turn < 8; turn++) {
        const struct method *m = both[turn & 1];
        struct problem p = box(7, 4, 3);
        struct options o = {.dx = dx, .dt = dt, .layout = turn & 2 ? LAYOUT_NODE : LAYOUT_LATTICE};
        if (turn & 4)
            for (int s = 0; s < SIDES; s++) p.side[s] = s / 2 == 1 ? DIRICHLET : NEUMANN;
        p.t_end = 61 * dt;
        struct field f = solved(m, &p, &o);
        double left = pow(gain_of(m, &p, dx, dt), 61);
        assert_near(mode_error(&p, &f, left), 0, 3e-13);
        assert_order(left, <, 0.9);
        assert_order(left, >, 0.001);
        assert_int_equal(f.cost.updates, 61 * (long long)f.n);
        assert_int_equal(f.cost.interactions, f.cost.updates * (m == &method_ftcs ? 6 : 12));
        assert_int_equal(f.n, (size_t)f.shape[0] * (size_t)f.shape[1] * (size_t)f.shape[2]);
        assert_near(f.spacing[2], dx, 1e-16);
        field_free(&f);
    }
}

/* At a fixed F the error of symbol and Euler's step together is of second order in dx; exp(-s^2 t) is the decay. */
static void cosine_decays_at_second_order(void **state) {
    (void)state;
    for (int m = 0; m < 2; m++) {
        struct problem p = box(1, 1, 1);
        double rate = 0, error[3];
        for (int s = 0; s < SIDES; s++) p.side[s] = NEUMANN;
        for (int a = 0; a < 3; a++)
            rate += p.material[0].k[a] / p.material[0].rho_c * pow(PI / (p.hi[a] - p.lo[a]), 2);
        for (int k = 0; k < 3; k++) {
            struct options o = {.dx = 0.46 / 4 / (1 << k), .fourier = 0.1};
            struct field f = solved(both[m], &p, &o);
            error[k] = mode_error(&p, &f, exp(-rate * p.t_end));
            field_free(&f);
        }
        assert_near(log2(error[1] / error[2]), 2, 0.04);
        assert_near(log2(error[0] / error[1]), 2, 0.16);
    }
}

/* ---- Quadratics ---- */

static void every_quadratic_with_its_source_is_steady(void **state) {
    (void)state;
    for (int turn = 0; turn < 8; turn++) {
        struct problem p = box(0, 0, 0);
        for (int s = 0; s < SIDES; s++) p.side[s] = (s + (turn >> 2)) % 2 || s == 3 ? DIRICHLET : NEUMANN;
        quadratic_data(&p, 0), p.t_end = 5;
        struct options o = {.dx = 0.115, .fourier = 0.15, .layout = turn & 2 ? LAYOUT_NODE : LAYOUT_LATTICE};
        struct field f = solved(both[turn & 1], &p, &o);
        assert_near(furthest_from_start(&p, &f), 0, 1e-11);
        field_free(&f);
    }
}

/* The mean over a B-spline of order m adds m d^2/24 T_aa of each axis. */
static void averages_of_a_quadratic_are_exact(void **state) {
    (void)state;
    for (int m = 0; m < 3; m++) {
        struct problem p = box(0, 0, 0);
        const double dx = 0.115, order = m == SAMPLING_SPLINE ? 4 : m;
        struct options o = {.dx = dx, .sampling = (enum sampling)m};
        quadratic_data(&p, 0), p.source = NULL, p.t_end = 0;
        struct field f = solved(&method_ftcs, &p, &o);
        size_t inside = 0;
        for (size_t i = 0; i < f.n; i++) {
            double x[DIM_MAX], more = 0, depth = INFINITY;
            field_place(&f, i, x);
            for (int a = 0; a < 3; a++) {
                more += order * dx * dx / 24 * bend_of[a];
                depth = fmin(depth, fmin(x[a] - p.lo[a], p.hi[a] - x[a]));
            }
            if (depth < 2 * dx) continue; /* the data are continued beyond the wall */
            inside++;
            assert_near(f.T[i], quadratic(&p, x) + more, 1e-13);
        }
        assert_int_equal(inside, 16 * 8 * 4);
        field_free(&f);
    }
}

/* ---- Axes ---- */

/* Smooth data of one variable that the walls bend. */
static double along_one(const struct problem *p, const double *x) {
    double u = x[(int)p->param[4]];
    return 0.4 + sin(3.1 * u) + u * u;
}

static double one_wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)x, (void)t;
    return (int)s / 2 == (int)p->param[4] ? 0.9 - 0.7 * (s % 2) : 0;
}

static double one_source(const struct problem *p, const double *x) {
    return 0.3 + cos(2.2 * x[(int)p->param[4]]);
}

/* A problem on the rod lo[0] .. hi[0] of r, repeated across the other axes of a box along `axis`. */
static struct problem repeated(const struct problem *r, int axis) {
    struct problem p = *r;
    p.dim = 3, p.param[4] = axis;
    for (int a = 0; a < 3; a++) {
        int own = a == axis;
        p.lo[a] = own ? r->lo[0] : 0.2, p.hi[a] = own ? r->hi[0] : 0.2 + 4 * 0.115;
        p.material[0].k[a] = own ? r->material[0].k[0] : 0.2 - 0.03 * a;
        for (int s = 0; s < 2; s++) {
            p.side[2 * a + s] = own ? r->side[s] : NEUMANN;
            p.robin[2 * a + s] = own ? r->robin[s] : 0;
        }
    }
    return p;
}

/* Along x to the last bit, for the differences across are zero. */
static void rod_repeated_across_is_the_rod(void **state) {
    (void)state;
    for (int turn = 0; turn < 36; turn++) {
        const int axis = turn % 3, node = turn / 3 % 2, kind = turn / 6 % 3, m = turn / 18;
        struct problem r = rod(0);
        struct options o = {.dx = 0.115, .fourier = 0.1, .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
        if (node && kind == ROBIN)
            o.walls = WALLS_FIXED, r.side[X_HI] = NEUMANN;
        else
            r.side[X_HI] = (enum side_kind)kind, r.robin[X_HI] = 1.4;
        r.initial = along_one, r.wall = one_wall, r.source = one_source;
        struct problem p = repeated(&r, axis);
        struct field want = solved(both[m], &r, &o), f = solved(both[m], &p, &o);
        size_t apart = 1;
        for (int a = 0; a < axis; a++) apart *= (size_t)f.shape[a];
        assert_int_equal(f.n, want.n * (node ? 25 : 16));
        for (size_t i = 0; i < f.n; i++) {
            size_t k = i / apart % want.n;
            assert_near(f.T[i], want.T[k], axis == 0 ? 0 : 2e-14);
        }
        double volume = 0, rod_length = 0;
        for (size_t i = 0; i < f.n; i++) volume += f.weight ? f.weight[i] : pow(0.115, 3);
        for (size_t i = 0; i < want.n; i++) rod_length += want.weight ? want.weight[i] : 0.115;
        assert_near(volume, rod_length * 0.46 * 0.46, 1e-13);
        field_free(&f);
        field_free(&want);
    }
}

/* p->param[6 + a] is the axis of x[] that has the data of axis a. */
static void unturned(const struct problem *p, const double *x, double y[DIM_MAX]) {
    for (int a = 0; a < 3; a++) y[a] = x[(int)p->param[6 + a]];
}

static double turned(const struct problem *p, const double *x) {
    double y[DIM_MAX];
    unturned(p, x, y);
    return sin(1.3 * y[0] + 0.7) * exp(0.4 * y[1]) + y[2] * y[2] * y[0];
}

static double turned_wall(const struct problem *p, enum side s, const double *x, double t) {
    double y[DIM_MAX];
    (void)t;
    unturned(p, x, y);
    for (int a = 0; a < 3; a++)
        if ((int)s / 2 == (int)p->param[6 + a])
            return 0.3 + 0.2 * a - 0.5 * (s % 2) + 0.1 * y[(a + 1) % 3] * y[(a + 1) % 3];
    return NAN;
}

static double turned_source(const struct problem *p, const double *x) {
    double y[DIM_MAX];
    unturned(p, x, y);
    return y[0] + 2 * y[1] * y[1] - cos(y[2]);
}

static struct problem turned_box(const int to[3]) {
    static const enum side_kind kinds[] = {DIRICHLET, NEUMANN, ROBIN, DIRICHLET, NEUMANN, NEUMANN};
    struct problem p = box(0, 0, 0), q = p;
    p.initial = turned, p.wall = turned_wall, p.source = turned_source, p.t_end = 0.8;
    for (int a = 0; a < 3; a++) {
        p.param[6 + a] = to[a];
        p.lo[to[a]] = q.lo[a], p.hi[to[a]] = q.hi[a], p.material[0].k[to[a]] = q.material[0].k[a];
        for (int s = 0; s < 2; s++) p.side[2 * to[a] + s] = kinds[2 * a + s], p.robin[2 * to[a] + s] = 0.6;
    }
    return p;
}

static void axes_can_be_permuted(void **state) {
    (void)state;
    static const int orders[][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int turn = 0; turn < 12; turn++) {
        const int *to = orders[turn % 6];
        struct options o = {.dx = 0.115, .dt = 0.001, .sampling = SAMPLING_CELL};
        struct problem p = turned_box(orders[0]), q = turned_box(to);
        struct field want = solved(both[turn / 6], &p, &o), f = solved(both[turn / 6], &q, &o);
        double worst = 0;
        for (size_t i = 0; i < want.n; i++) {
            size_t rest = i, at[3] = {0}, stride[3] = {1, (size_t)f.shape[0], (size_t)(f.shape[0] * f.shape[1])},
                   k = 0;
            for (int a = 0; a < 3; a++) at[a] = rest % (size_t)want.shape[a], rest /= (size_t)want.shape[a];
            for (int a = 0; a < 3; a++) k += at[a] * stride[to[a]];
            worst = fmax(worst, fabs(f.T[k] - want.T[i]));
        }
        assert_near(worst, 0, 2e-14);
        assert_near(f.heat[1], want.heat[1], 1e-13);
        field_free(&f);
        field_free(&want);
    }
}

/* ---- Heat ---- */

/* In through two faces, at right angles. */
static double two_fluxes(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x, (void)t;
    return s == X_LO ? 0.93 : s == Z_HI ? -0.37 : 0;
}

static void heat_rises_by_the_fluxes(void **state) {
    (void)state;
    for (int layout = LAYOUT_LATTICE; layout <= LAYOUT_NODE; layout++) {
        struct problem p = box(2, 3, 1);
        const double volume = 2.3 * 1.38 * 0.92;
        struct options o = {.dx = 0.115, .fourier = 0.15, .layout = (enum layout_name)layout};
        for (int s = 0; s < SIDES; s++) p.side[s] = NEUMANN;
        p.wall = two_fluxes;
        struct field f = solved(&method_ftcs, &p, &o);
        double sum = 0;
        for (size_t i = 0; i < f.n; i++) sum += f.weight ? f.weight[i] : pow(0.115, 3);
        assert_near(sum, volume, 1e-12);
        assert_near(f.heat[0], 2.385 * 0.83 * volume, 1e-12);
        assert_near(f.heat[1] - f.heat[0], p.t_end * (0.93 * 1.38 * 0.92 - 0.37 * 2.3 * 1.38), 1e-12);
        field_free(&f);
    }
}

static double checkers(const struct problem *p, const double *x) {
    double T = 0.83;
    for (int a = 0; a < 3; a++)
        if ((int)p->param[6] >> a & 1) T *= cos(PI * (x[a] - p->lo[a]) / 0.23 - p->param[7]);
    return T;
}

/* -1 and 1 by turns along any of the axes: the fluxes between them are zero, the direct differences the largest. */
static void fluxes_annihilate_checkers(void **state) {
    (void)state;
    for (int turn = 0; turn < 14; turn++) {
        struct problem p = box(0, 0, 0);
        const int axes = turn / 2 + 1, node = turn % 2;
        struct options o = {.dx = 0.23, .fourier = 0.1, .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
        p.initial = checkers, p.param[6] = axes, p.param[7] = node ? 0 : PI / 2, p.t_end = 4;
        for (int s = 0; s < SIDES; s++) p.side[s] = node ? NEUMANN : PERIODIC;
        struct field f = solved(&method_ftcs_flux, &p, &o);
        assert_near(furthest_from_start(&p, &f), 0, 1e-12);
        field_free(&f);
        f = solved(&method_ftcs, &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_order(fabs(f.T[i]), <, 0.3);
        field_free(&f);
    }
}

/* ---- Two materials ---- */

/* The sum that the refusal of an unstable run states. */
static double fourier_in(const struct failure *why) {
    const char *text = strstr(why->text, "sum of kappa dt/dx^2 is ");
    double sum = NAN;
    assert_non_null(text);
    assert_int_equal(sscanf(text, "sum of kappa dt/dx^2 is %lf", &sum), 1);
    return sum;
}

static double across(const struct problem *p, const double *x) {
    return cos(PI * x[1] / p->hi[1]) * cos(PI * x[2] / p->hi[2]);
}

static double insulated(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

/* The interface is 0.3 of a cell behind a face.  The data have no flux along x, and a step takes (k_a/rho_c) dt
 * (2 sin(pi d/2 H_a)/d)^2 of them along y and z, k_a and rho_c averaged over the cell. */
static void two_materials_conduct_in_parallel_across(void **state) {
    (void)state;
    const double d = 0.1, dt = 1e-3, k[2][3] = {{0.7, 0.5, 0.3}, {0.09, 0.2, 0.6}}, rho_c[2] = {1.3, 2.9};
    struct problem p = {.dim = 3, .hi = {1, 0.8, 0.5}, .t_end = dt, .materials = 2, .interface = 0.43};
    struct options o = {.dx = d, .dt = dt};
    p.initial = across, p.wall = insulated;
    for (int s = 0; s < SIDES; s++) p.side[s] = NEUMANN;
    for (int m = 0; m < 2; m++) p.material[m] = (struct material){{k[m][0], k[m][1], k[m][2]}, rho_c[m]};
    struct field f = solved(&method_ftcs, &p, &o);
    for (size_t i = 0; i < f.n; i++) {
        double x[DIM_MAX], loss = 0;
        field_place(&f, i, x);
        double part = fmin(1, fmax(0, (p.interface - x[0]) / d + 0.5));
        for (int a = 1; a < 3; a++)
            loss += dt * (part * k[0][a] + (1 - part) * k[1][a]) / (part * rho_c[0] + (1 - part) * rho_c[1]) *
                    pow(2 * sin(PI * d / 2 / p.hi[a]) / d, 2);
        assert_near(f.T[i], (1 - loss) * across(&p, x), 1e-14);
    }
    field_free(&f);
    struct failure why = {0};
    p.interface = 0.4, o.dt = 0.05, p.t_end = 200 * o.dt;
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
    assert_near(fourier_in(&why), o.dt / (d * d) * (0.7 + 0.5 + 0.3) / 1.3, 1e-5); /* far from the interface */
}

/* A cell that the interface cuts starts at its heat over its heat capacity: here the mean across. */
static void averages_of_two_materials_are_exact(void **state) {
    (void)state;
    const double d = 0.1;
    struct problem p = {.dim = 3, .hi = {1, 0.8, 0.5}, .materials = 2, .interface = 0.43, .initial = across};
    struct options o = {.dx = d, .sampling = SAMPLING_CELL};
    double mean = 1;
    p.wall = insulated;
    for (int s = 0; s < SIDES; s++) p.side[s] = NEUMANN;
    for (int m = 0; m < 2; m++) p.material[m] = (struct material){{0.7, 0.5, 0.3}, 1.3 + m};
    for (int a = 1; a < 3; a++) mean *= sin(PI * d / 2 / p.hi[a]) / (PI * d / 2 / p.hi[a]);
    struct field f = solved(&method_ftcs, &p, &o);
    for (size_t i = 0; i < f.n; i++) {
        double x[DIM_MAX];
        field_place(&f, i, x);
        assert_near(f.T[i], mean * across(&p, x), 2e-9); /* Gauss-Legendre with four points */
    }
    field_free(&f);
}

/* Two halves of one material are that material. */
static void two_equal_materials_are_one(void **state) {
    (void)state;
    struct problem p = box(3, 2, 1), q = p;
    struct options o = {.dx = 0.115, .fourier = 0.15};
    for (int s = Y_HI; s < SIDES; s++) p.side[s] = q.side[s] = ROBIN, p.robin[s] = q.robin[s] = 0.7;
    q.materials = 2, q.interface = -0.7 + 9 * 0.115, q.material[1] = q.material[0];
    struct field want = solved(&method_ftcs, &p, &o), f = solved(&method_ftcs, &q, &o);
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], want.T[i], 1e-14);
    field_free(&f);
    field_free(&want);
}

/* ---- Steps, widths and refusals ---- */

static double step(const struct problem *p, const double *x) {
    double T = 1.3;
    for (int a = 0; a < p->dim; a++) T *= x[a] < 0.35 ? 0.6 : -1.1;
    return T;
}

/* dt sum of kappa/dx^2 up to 1/2, with fluxes up to 2: 1/6 and 2/3 of each of three equal axes. */
static void steps_up_to_a_sixth_are_stable(void **state) {
    (void)state;
    const double limit[] = {1. / 6, 2. / 3};
    for (int m = 0; m < 2; m++) {
        struct problem p = box(0, 0, 0);
        for (int a = 0; a < 3; a++) p.material[0].k[a] = 0.71;
        p.initial = step, p.t_end = 60;
        struct options o = {.dx = 0.046, .fourier = 0.995 * limit[m]};
        p.t_end = 400 * o.fourier * 0.046 * 0.046 * 2.385 / 0.71;
        struct field f = solved(both[m], &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_order(fabs(f.T[i]), <, 4);
        field_free(&f);
        struct failure why = {0};
        o.fourier = 1.04 * limit[m];
        assert_int_equal(method_solve(both[m], &p, &o, &f, &why), STATUS_UNSTABLE);
        assert_has(why.text, ", y = ");
        assert_has(why.text, ", z = ");
        assert_near(fourier_in(&why), 3 * 1.04 * limit[m], 0.01 * limit[m]);
    }
}

static void bits_do_not_depend_on_the_width_of_vectors(void **state) {
    (void)state;
    for (int turn = 0; turn < 3; turn++) {
        struct problem p = turned_box((const int[]){0, 1, 2});
        struct options o = {.dx = 0.115, .dt = 0.001, .lanes = 2};
        if (turn == 2)
            p.materials = 2, p.material[1] = (struct material){{0.5, 0.2, 0.1}, 1.7}, p.side[Y_LO] = NEUMANN;
        struct field want = solved(both[turn % 2], &p, &o);
        for (o.lanes = 4; o.lanes <= options_lanes_most(); o.lanes *= 2) {
            struct field f = solved(both[turn % 2], &p, &o);
            assert_memory_equal(f.T, want.T, f.n * sizeof *f.T);
            field_free(&f);
        }
        field_free(&want);
    }
}

static void matched_run_is_refused_in_space(void **state) {
    (void)state;
    struct problem p = box(1, 2, 3);
    struct options o = {.dx = 0.115, .stepper = STEPPER_MATCHED};
    struct field f;
    struct failure why = {0};
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "--stepper matched: in space the error is not isotropic");
    o = (struct options){.dx = 0.1};
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_INPUT);
    assert_has(why.text, "does not divide 2.3 m by 1.38 m by 0.92 m");
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(modes_decay_by_the_amplification_factor),
        cmocka_unit_test(cosine_decays_at_second_order),
        cmocka_unit_test(every_quadratic_with_its_source_is_steady),
        cmocka_unit_test(averages_of_a_quadratic_are_exact),
        cmocka_unit_test(rod_repeated_across_is_the_rod),
        cmocka_unit_test(axes_can_be_permuted),
        cmocka_unit_test(heat_rises_by_the_fluxes),
        cmocka_unit_test(fluxes_annihilate_checkers),
        cmocka_unit_test(two_materials_conduct_in_parallel_across),
        cmocka_unit_test(averages_of_two_materials_are_exact),
        cmocka_unit_test(two_equal_materials_are_one),
        cmocka_unit_test(steps_up_to_a_sixth_are_stable),
        cmocka_unit_test(bits_do_not_depend_on_the_width_of_vectors),
        cmocka_unit_test(matched_run_is_refused_in_space),
    };
    return cmocka_run_group_tests_name("ftcs_space", tests, NULL, NULL);
}
