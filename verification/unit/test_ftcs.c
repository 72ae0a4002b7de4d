/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The finite differences against what can be said of them exactly: their symbol, their steady states, their walls,
 * and their order at the matched step. */
#include "verification/unit/ftcs_problems.h"

#include <gsl/gsl_errno.h>
#include <string.h>

/* -dx^2/kappa times the symbol on a mode, along one axis. */
static double symbol(const struct method *m, double number, double dx, double extent) {
    double phase = number * PI * dx / extent;
    return m == &method_ftcs ? 4 * pow(sin(phase / 2), 2) : pow(sin(phase), 2);
}

/* ---- Decay of a discrete mode: every wall on every layout, both methods, exactly n steps ---- */

static void decays_as_its_symbol(const struct method *m, struct problem *p, enum layout_name layout) {
    const double dx = 0.046, dt = 0.00061;
    p->t_end = 217 * dt;
    struct options o = {.dx = dx, .dt = dt, .layout = layout};
    struct field f = solved(m, p, &o);
    double gain = 1;
    for (int a = 0; a < p->dim; a++)
        gain -= p->material[0].k[a] / p->material[0].rho_c * dt / (dx * dx) *
                symbol(m, p->param[a], dx, p->hi[a] - p->lo[a]);
    assert_int_equal(f.steps, 217);
    assert_near(f.dt, dt, 1e-17);
    assert_near(mode_error(p, &f, pow(gain, 217)), 0, 5e-13);
    assert_order(pow(gain, 217), <, 0.95);
    assert_order(pow(gain, 217), >, 0.001);
    assert_int_equal(f.cost.updates, 217 * (long long)f.n);
    assert_int_equal(f.cost.interactions, f.cost.updates * p->dim * (m == &method_ftcs ? 2 : 4));
    assert_order(f.cost.bytes, <=, 8 * (3 * f.n + 30 * (size_t)(f.shape[0] + f.shape[1])));
    field_free(&f);
}

static void test_symbol(void **state) {
    (void)state;
    const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
    for (int m = 0; m < 2; m++)
        for (int layout = LAYOUT_LATTICE; layout <= LAYOUT_NODE; layout++) {
            struct problem sine = rod(13), cosine = rod(7), flat = plane(5, 3), swapped = plane(7, 4);
            cosine.side[X_LO] = cosine.side[X_HI] = NEUMANN;
            swapped.side[X_LO] = swapped.side[X_HI] = NEUMANN;
            swapped.side[Y_LO] = swapped.side[Y_HI] = DIRICHLET;
            decays_as_its_symbol(both[m], &sine, (enum layout_name)layout);
            decays_as_its_symbol(both[m], &cosine, (enum layout_name)layout);
            decays_as_its_symbol(both[m], &flat, (enum layout_name)layout);
            decays_as_its_symbol(both[m], &swapped, (enum layout_name)layout);
        }
}

/* The fluxes do not see the fastest mode of the grid: cos(N pi x/L) on insulated nodes, +-1. */
static void test_fluxes_are_blind_to_the_checkerboard(void **state) {
    (void)state;
    struct problem p = rod(50);
    p.side[X_LO] = p.side[X_HI] = NEUMANN;
    struct options o = {.dx = 0.046, .fourier = 0.21, .layout = LAYOUT_NODE};
    struct field f = solved(&method_ftcs_flux, &p, &o);
    assert_near(mode_error(&p, &f, 1), 0, 1e-12);
    field_free(&f);
    f = solved(&method_ftcs, &p, &o);
    assert_order(mode_error(&p, &f, 0), <, 1e-3);
    field_free(&f);
}

/* ---- Steady states ---- */

static double line(const struct problem *p, const double x[2]) {
    return p->param[0] + p->param[1] * x[0] + p->param[2] * x[1];
}

static double line_wall(const struct problem *p, enum side s, const double x[2]) {
    if (p->side[s] == DIRICHLET) return line(p, x);
    return p->material[0].k[s / 2] * p->param[1 + s / 2] * (s % 2 ? 1 : -1);
}

/* A linear profile with its flux given on two sides stays, for both methods on both layouts. */
static void test_linear_profile_stays(void **state) {
    (void)state;
    const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
    for (int turn = 0; turn < 8; turn++) {
        struct problem p = plane(0, 0);
        p.param[0] = 1.37, p.param[1] = -2.9, p.param[2] = 0.77;
        p.initial = line, p.wall = line_wall;
        p.side[turn & 1 ? X_HI : X_LO] = NEUMANN;
        p.side[turn & 1 ? Y_LO : Y_HI] = DIRICHLET;
        struct options o = {.dx = 0.046, .fourier = 0.2, .layout = turn & 2 ? LAYOUT_NODE : LAYOUT_LATTICE};
        o.sampling = turn & 1 ? SAMPLING_SPLINE : SAMPLING_CELL; /* both keep a linear profile, walls included */
        struct field f = solved(both[turn >> 2], &p, &o);
        assert_order(f.steps, >, 50);
        for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], line(&p, (double[2]){f.x[i], f.y[i]}), 1e-12);
        field_free(&f);
    }
}

static double steady_source(const struct problem *p, const double x[2]) {
    return -2 * (p->material[0].k[0] * p->param[1] - p->material[0].k[1] * p->param[2]) + 0 * x[0];
}

static double parabola(const struct problem *p, const double x[2]) {
    return p->param[0] + p->param[1] * x[0] * x[0] - p->param[2] * x[1] * x[1];
}

static double parabola_wall(const struct problem *p, enum side s, const double x[2]) {
    if (p->side[s] == DIRICHLET) return parabola(p, x);
    return p->material[0].k[s / 2] * (s % 2 ? 1 : -1) * (s < 2 ? 2 * p->param[1] * x[0] : -2 * p->param[2] * x[1]);
}

/* G = -div(k grad T) of a parabola holds it; with nodes on the walls the differences are exact (with fluxes all but
 * next to a wall whose temperature is given). */
static void test_source_holds_a_parabola(void **state) {
    (void)state;
    struct problem p = plane(0, 0);
    p.param[0] = 0.31, p.param[1] = 1.7, p.param[2] = 0.45;
    p.initial = parabola, p.wall = parabola_wall, p.source = steady_source;
    struct options o = {.dx = 0.046, .fourier = 0.2, .layout = LAYOUT_NODE};
    struct field f = solved(&method_ftcs, &p, &o);
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], parabola(&p, (double[2]){f.x[i], f.y[i]}), 2e-12);
    field_free(&f);
    p.dim = 1;
    p.param[2] = 0;
    p.side[X_LO] = p.side[X_HI] = NEUMANN;
    f = solved(&method_ftcs_flux, &p, &o);
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], parabola(&p, (double[2]){f.x[i], 0}), 2e-12);
    field_free(&f);
}

/* ---- Walls ---- */

/* With `fixed`, ghosts half a spacing outside hold the wall's temperature: the wall is felt dx/2 too far out. */
static void test_fixed_walls_lie_half_a_spacing_out(void **state) {
    (void)state;
    struct problem p = rod(0);
    p.param[0] = 1.37, p.param[1] = -2.9, p.param[2] = 0;
    p.initial = line, p.wall = line_wall, p.t_end = 90;
    struct options o = {.dx = 0.115, .fourier = 0.45, .walls = WALLS_FIXED};
    struct field f = solved(&method_ftcs, &p, &o);
    double slope = p.param[1] * 2.3 / (2.3 + 0.115), middle = line(&p, (double[2]){0.45, 0});
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], middle + slope * (f.x[i] - 0.45), 1e-9);
    field_free(&f);
}

/* Insulated, with a flux in on one side: heat grows by the flux times the time, on both layouts. */
static double one_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)x;
    return s == X_LO ? p->param[4] : 0;
}

static void test_heat_balance(void **state) {
    (void)state;
    for (int layout = LAYOUT_LATTICE; layout <= LAYOUT_NODE; layout++) {
        struct problem p = plane(4, 3);
        p.side[X_LO] = p.side[X_HI] = NEUMANN;
        p.wall = one_flux, p.param[4] = 0.93;
        struct options o = {.dx = 0.023, .fourier = 0.2, .layout = (enum layout_name)layout};
        struct field f = solved(&method_ftcs, &p, &o);
        assert_near(f.heat[1] - f.heat[0], 0.93 * p.t_end * 1.38, 1e-12);
        assert_near(f.heat[0], 2.385 * 0.83 * 2.3 * 1.38, 1e-12);
        assert_true((f.weight != NULL) == (layout == LAYOUT_NODE));
        double area = 0;
        for (size_t i = 0; i < f.n; i++) area += f.weight ? f.weight[i] : f.spacing[0] * f.spacing[1];
        assert_near(area, 2.3 * 1.38, 1e-12);
        field_free(&f);
    }
}

/* ---- The matched step ---- */

static double order_between(const struct method *m, enum sampling sampling, double fourier, double *fine) {
    double error[2];
    for (int rung = 0; rung < 2; rung++) {
        struct problem p = rod(3);
        p.t_end =
            64 * pow(2.3 / 72, 2) / (6 * 0.29 / 2.385); /* whole steps at the matched F, which else is met nearly */
        struct options o = {.dx = 2.3 / (72 << rung), .sampling = sampling, .stepper = STEPPER_MATCHED};
        if (fourier > 0) o.stepper = STEPPER_EULER, o.fourier = fourier;
        struct field f = solved(m, &p, &o);
        double rate = 0.29 / 2.385 * pow(3 * PI / 2.3, 2);
        error[rung] = mode_error(&p, &f, exp(-rate * p.t_end));
        field_free(&f);
    }
    *fine = error[1];
    return log2(error[0] / error[1]);
}

/* What the sampling has smoothed already is not integrated again; a jump sampled at points is the reverse. */
static void test_matched_starts_late(void **state) {
    (void)state;
    const double m[] = {0, 1, 4, -1, 1, 4}, dx = 0.046;
    for (int i = 0; i < 6; i++) {
        struct problem p = rod(3);
        if (i >= 3) p.jumps[0] = 1, p.jump[0][0] = 0.45, p.param[3] = 0; /* midway; the same level on either side */
        struct options o = {.dx = dx, .stepper = STEPPER_MATCHED, .sampling = (enum sampling)(i % 3)};
        struct field f = solved(&method_ftcs, &p, &o);
        double run = p.t_end - m[i] * dx * dx * 2.385 / (24 * 0.29), matched = dx * dx * 2.385 / (6 * 0.29);
        assert_near((double)f.steps * f.dt, run, 1e-15);
        assert_near((double)f.steps, run / matched + 1, 1); /* the next even number */
        assert_int_equal(f.steps % 2, 0);
        assert_near(f.time, p.t_end, 0);
        field_free(&f);
    }
}

/* T = level + t mode, mode being one of the differences: what it takes at first, and what more in time. */
static double rising(const struct problem *p, const double x[2]) {
    return p->material[0].rho_c * (mode(p, x) - p->param[2]) / p->param[3];
}

static double rising_more(const struct problem *p, const double x[2]) {
    return p->param[4] * rising(p, x);
}

static double level_alone(const struct problem *p, const double x[2]) {
    (void)x;
    return p->param[2];
}

/* Euler's step has no error where T is linear in time and the source that of its start. */
static void test_source_that_changes_is_that_of_the_old_time(void **state) {
    (void)state;
    const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
    for (int turn = 0; turn < 4; turn++) {
        const struct method *m = both[turn >> 1];
        struct problem p = turn & 1 ? plane(5, 3) : rod(13);
        struct options o = {.dx = 0.046, .dt = 0.00061};
        p.initial = level_alone, p.source = rising, p.source_rate = rising_more;
        p.t_end = 217 * o.dt;
        for (int a = 0; a < p.dim; a++)
            p.param[4] += p.material[0].k[a] / p.material[0].rho_c / (o.dx * o.dx) *
                          symbol(m, p.param[a], o.dx, p.hi[a] - p.lo[a]);
        struct field f = solved(m, &p, &o);
        assert_near(mode_error(&p, &f, p.t_end / p.param[3]), 0, 1e-13);
        field_free(&f);
    }
}

/* A cooled wall has no place on nodes, whichever of the sides it is. */
static void test_a_cooled_side_is_refused_on_nodes(void **state) {
    (void)state;
    for (int dim = 1; dim <= 2; dim++)
        for (int side = 0; side < 2 * dim; side++) {
            struct problem p = dim == 2 ? plane(5, 3) : rod(13);
            struct options o = {.dx = 0.046, .dt = 0.00061, .layout = LAYOUT_NODE};
            struct failure why = {0};
            struct field f;
            p.side[side] = ROBIN, p.robin[side] = 0.31;
            assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
            assert_has(why.text, "a Robin wall must be midway between a point and its ghost");
        }
}

static void test_matched_is_fourth_order(void **state) {
    (void)state;
    double matched, plain;
    assert_near(order_between(&method_ftcs, SAMPLING_POINT, 0, &matched), 4, 0.02);
    /* here the steps are uneven: sum dt^3 is off by 3 alternation^2 < 6/64 at the coarse rung, half of the constant's
     * terms
     */
    assert_near(order_between(&method_ftcs, SAMPLING_SPLINE, 0, &matched), 4, 0.07);
    assert_near(order_between(&method_ftcs_flux, SAMPLING_POINT, 0, &matched), 4, 0.02);
    assert_near(order_between(&method_ftcs, SAMPLING_POINT, 0.31, &plain), 2, 0.1);
    assert_order(plain, >, 50 * matched);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_symbol),
        cmocka_unit_test(test_fluxes_are_blind_to_the_checkerboard),
        cmocka_unit_test(test_linear_profile_stays),
        cmocka_unit_test(test_source_holds_a_parabola),
        cmocka_unit_test(test_fixed_walls_lie_half_a_spacing_out),
        cmocka_unit_test(test_heat_balance),
        cmocka_unit_test(test_matched_starts_late),
        cmocka_unit_test(test_source_that_changes_is_that_of_the_old_time),
        cmocka_unit_test(test_a_cooled_side_is_refused_on_nodes),
        cmocka_unit_test(test_matched_is_fourth_order),
    };
    return cmocka_run_group_tests_name("ftcs", tests, NULL, NULL);
}
