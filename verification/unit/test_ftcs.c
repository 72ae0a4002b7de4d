/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The finite differences against exact statements: their symbol, steady states, walls, heat, limits of the step; and
 * in round bodies. */

#include "solver/field.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "solver/shape.h"

#include "verification/unit/ftcs_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

extern const struct method method_ftcs, method_ftcs_flux;

/* ---- symbol and steady states ---- */

static void decays_as_its_symbol(const struct method *m, struct problem *p, enum layout_name layout) {
    const double dx = 0.046, dt = 0.00061;
    p->t_end = 217 * dt;
    struct options o = {.dx = dx, .dt = dt, .layout = layout};
    struct field f = solved(m, p, &o);
    double gain = gain_of(m, p, dx, dt);
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

static void modes_decay_by_the_amplification_factor(void **state) {
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

/* ---- Steady states ---- */

static double line(const struct problem *p, const double x[2]) {
    return p->param[0] + p->param[1] * x[0] + p->param[2] * x[1];
}

static double line_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    if (p->side[s] == DIRICHLET) return line(p, x);
    return p->material[0].k[s / 2] * p->param[1 + s / 2] * (s % 2 ? 1 : -1);
}

static double steady_source(const struct problem *p, const double x[2]) {
    return -2 * (p->material[0].k[0] * p->param[1] - p->material[0].k[1] * p->param[2]) + 0 * x[0];
}

static double parabola(const struct problem *p, const double x[2]) {
    return p->param[0] + p->param[1] * x[0] * x[0] - p->param[2] * x[1] * x[1];
}

static double parabola_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    if (p->side[s] == DIRICHLET) return parabola(p, x);
    return p->material[0].k[s / 2] * (s % 2 ? 1 : -1) * (s < 2 ? 2 * p->param[1] * x[0] : -2 * p->param[2] * x[1]);
}

/* G = -div(k grad T) keeps a parabola steady; with nodes on the walls the differences are exact (with fluxes all
 * except those next to a Dirichlet wall). */
static void parabola_with_a_source_is_steady(void **state) {
    (void)state;
    struct problem p = plane(0, 0);
    p.param[0] = 0.31, p.param[1] = 1.7, p.param[2] = 0.45;
    p.initial = parabola, p.wall = parabola_wall, p.source = steady_source;
    struct options o = {.dx = 0.046, .fourier = 0.2, .layout = LAYOUT_NODE};
    struct field f = solved(&method_ftcs, &p, &o);
    double x[DIM_MAX];
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], parabola(&p, field_place(&f, i, x)), 2e-12);
    field_free(&f);
    p.dim = 1;
    p.param[2] = 0;
    p.side[X_LO] = p.side[X_HI] = NEUMANN;
    f = solved(&method_ftcs_flux, &p, &o);
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], parabola(&p, (double[2]){f.x[0][i], 0}), 2e-12);
    field_free(&f);
}

/* ---- Walls ---- */

/* With `fixed`, ghosts half a spacing outside have the wall's temperature: the wall acts dx/2 too far out. */
static void fixed_walls_are_half_a_spacing_outside(void **state) {
    (void)state;
    struct problem p = rod(0);
    p.param[0] = 1.37, p.param[1] = -2.9, p.param[2] = 0;
    p.initial = line, p.wall = line_wall, p.t_end = 90;
    struct options o = {.dx = 0.115, .fourier = 0.45, .walls = WALLS_FIXED};
    struct field f = solved(&method_ftcs, &p, &o);
    double slope = p.param[1] * 2.3 / (2.3 + 0.115), middle = line(&p, (double[2]){0.45, 0});
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], middle + slope * (f.x[0][i] - 0.45), 1e-9);
    field_free(&f);
}

/* Insulated, with a flux in on one side: heat grows by the flux times the time, on both layouts. */
static double one_flux(const struct problem *p, enum side s, const double x[2], double t) {
    (void)x, (void)t;
    return s == X_LO ? p->param[4] : 0;
}

static void heat_balance(void **state) {
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

/* Smoothing by the sampling shortens the run by its time; a jump sampled at points lengthens it. */
static void matched_run_starts_at_the_sampling_time(void **state) {
    (void)state;
    const double m[] = {0, 1, 4, -1, 1, 4}, dx = 0.046;
    for (int i = 0; i < 9; i++) {
        const struct method *method = i < 6 ? &method_ftcs : &method_ftcs_flux; /* spacing 2 dx */
        struct problem p = rod(3);
        if (i >= 3 && i < 6)
            p.jumps[0] = 1, p.jump[0][0] = 0.45, p.param[3] = 0; /* midway; the same level on either side */
        struct options o = {.dx = dx, .stepper = STEPPER_MATCHED, .sampling = (enum sampling)(i % 3)};
        struct field f = solved(method, &p, &o);
        double unit = dx * dx * 2.385 / 0.29, run = p.t_end - m[i % 6] * unit / 24;
        double matched = i < 6 ? unit / 6 : 2 * unit / 3;
        assert_near((double)f.steps * f.dt, run, 1e-15);
        assert_near((double)f.steps, run / matched + 1, 1); /* the next even number */
        assert_int_equal(f.steps % 2, 0);
        assert_near(f.time, p.t_end, 0);
        field_free(&f);
    }
}

/* T = level + t mode with a mode of the differences: its initial value and its rate of change. */
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
static void changing_source_is_taken_at_the_old_time(void **state) {
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

static double step(const struct problem *p, const double x[2]) {
    return (x[0] < p->jump[0][0] ? 1.3 : -0.4) * (p->dim == 1 ? 1 : x[1] < p->jump[1][0] ? 0.6 : 2.1);
}

/* ---- Refusals and failures of a run ---- */

/* Just inside the limit a run is bounded, just outside it is a status with step, time and place. */
static void stability(void **state) {
    (void)state;
    const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
    const double limit[] = {0.5, 2}; /* dt (kappa_x + kappa_y) / dx^2 */
    for (int m = 0; m < 2; m++) {
        struct problem p = plane(3, 2);
        p.initial = step, p.jumps[0] = 1, p.jump[0][0] = 0.2431, p.jump[1][0] = 0.9017, p.t_end = 60;
        double share = 0.71 / (0.29 + 0.71); /* --fourier counts in the larger kappa */
        struct options o = {.dx = 0.046, .fourier = 0.995 * limit[m] * share};
        struct field f = solved(both[m], &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_order(fabs(f.T[i]), <, 4);
        field_free(&f);

        struct failure why = {0};
        o.fourier = 1.02 * limit[m] * share;
        assert_int_equal(method_solve(both[m], &p, &o, &f, &why), STATUS_UNSTABLE);
        const char *text = strstr(why.text, "unstable at step ");
        long step_seen = 0, steps = 0;
        assert_non_null(text);
        assert_int_equal(sscanf(text, "unstable at step %ld of %ld,", &step_seen, &steps), 2);
        assert_true(step_seen % 32 == 0 && step_seen < steps / 2); /* it is not run to the end */
        assert_has(why.text, " t = ");
        assert_has(why.text, " at x = ");
        assert_has(why.text, ", y = ");
        o.fourier = 3 * limit[m], p.t_end = 19.5 * o.fourier * 0.046 * 0.046 * 2.385 / 0.71; /* at the last step */
        assert_int_equal(method_solve(both[m], &p, &o, &f, &why), STATUS_UNSTABLE);
        assert_has(why.text, "unstable at step 20 of 20,");
        p.initial = mode, p.param[2] = NAN; /* not a number from the start */
        assert_int_equal(method_solve(both[m], &p, &o, &f, &why), STATUS_UNSTABLE);
    }
}

static double along_y(const struct problem *p, const double x[2]) {
    return cos(PI * (x[1] - p->lo[1]) / (p->hi[1] - p->lo[1]));
}

static double insulated(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

/* Two materials in the plane, the interface 0.3 of a cell behind a face.  T = cos(pi y/H) has no flux along x, and a
 * step of Euler takes (k_y/rho_c) dt (2 sin(pi d/2 H)/d)^2 of it, k_y and rho_c averaged over the cell.  Where both
 * have the same kappa the step's sum of kappa dt/dx^2 is that of both axes. */
static void two_materials_in_the_plane(void **state) {
    (void)state;
    const double d = 0.1, first = 0.3, k[2] = {0.7, 0.09}, rho_c[2] = {1.3, 2.9};
    struct problem p = {.dim = 2,
                        .hi = {1, 0.8},
                        .t_end = 1e-3,
                        .materials = 2,
                        .interface = 0.43,
                        .side = {NEUMANN, NEUMANN, NEUMANN, NEUMANN},
                        .initial = along_y,
                        .wall = insulated};
    struct options o = {.dx = d, .dt = 1e-3};
    struct failure why = {0};
    for (int m = 0; m < 2; m++) p.material[m] = (struct material){{k[m], k[m]}, rho_c[m]};
    struct field f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 1);
    for (size_t i = 0; i < f.n; i++) {
        double x[DIM_MAX];
        field_place(&f, i, x);
        double part = fmin(1, fmax(0, (p.interface - x[0]) / d + 0.5)), symbol = 2 * sin(PI * d / 1.6) / d;
        double kappa = (part * k[0] + (1 - part) * k[1]) / (part * rho_c[0] + (1 - part) * rho_c[1]);
        if (x[0] > 0.4 && x[0] < 0.5) assert_near(part, first, 1e-12);
        assert_near(f.T[i], (1 - kappa * 1e-3 * symbol * symbol) * cos(PI * x[1] / 0.8), 1e-14);
    }
    field_free(&f);
    p.material[1] = (struct material){{0.07, 0.07}, 0.13};
    p.t_end = 200 * 0.4 * d * d / (0.7 / 1.3), o.dt = 0, o.fourier = 0.4, p.interface = 0.4;
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
    const char *text = strstr(why.text, "sum of kappa dt/dx^2 is ");
    double sum = NAN;
    assert_non_null(text);
    assert_int_equal(sscanf(text, "sum of kappa dt/dx^2 is %lf", &sum), 1);
    assert_near(sum, 0.4 * (31. / 22 + 1), 1e-5); /* along x the rate of test_rate_of_two_materials */
}

/* The step is whole: t_end / ceil(t_end / dt); a dx that is out by rounding is snapped. */
static void steps_are_whole_and_dx_is_snapped(void **state) {
    (void)state;
    struct problem p = rod(3);
    struct options o = {.dx = 0.0383333333, .dt = 0.0037};
    struct field f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 100);
    assert_near(f.dt, 0.0037, 1e-18);
    assert_near(f.spacing[0], 2.3 / 60, 1e-16);
    assert_int_equal(f.shape[0], 60);
    assert_int_equal(f.shape[1], 1);
    assert_near(f.time, 0.37, 0);
    field_free(&f);
    o.dt = 0.00371;
    f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 100);
    field_free(&f);
    o.dt = 0.00369;
    f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 101);
    assert_near(f.range[0], 0.83 + 1.9 * sin(3 * PI * 29.5 / 60), 1e-14);
    field_free(&f);
}

/* ---- round ---- */

static double slope; /* K m^-2, of the bowl below */

/* 3 + slope r^2: the differences along r are exact for it, and so is the slope that they give a wall. */
static double bowl(const struct problem *p, const double x[2]) {
    (void)p;
    return 3 + slope * (x[0] * x[0] + x[1] * x[1]);
}

static double sink(const struct problem *p, const double x[2]) {
    (void)x;
    return -4 * slope * p->material[0].k[0];
}

static double into(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    double r = hypot(x[0], x[1]), normal = s == X_HI ? 1 : -1;
    return normal * 2 * slope * r * p->material[0].k[0];
}

static double seven(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 7;
}

static double all_seven(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 7;
}

static double rough(const struct problem *p, const double x[2]) {
    (void)p;
    return 7 + sin(1e4 * x[0]) * cos(3e4 * x[1]);
}

static double rough_elsewhere(const struct problem *p, const double x[2]) {
    return rough(p, (double[2]){x[0] + 0.1, x[1]});
}

static struct problem body(double hole, enum side_kind kind) {
    struct problem p = {.dim = 2, .t_end = 3, .materials = 1, .material = {{{0.29, 0.29}, 2.385}}};
    shape_round(&p, hole, 1.3);
    p.side[X_LO] = p.side[X_HI] = kind;
    p.robin[X_LO] = p.robin[X_HI] = 0.7;
    p.initial = all_seven, p.wall = seven;
    return p;
}

static struct field solved_round(const struct problem *p, double spacings, double fourier) {
    struct field f;
    struct failure why = {0};
    struct options o = {.dx = (p->radius[1] - p->radius[0]) / spacings, .fourier = fourier};
    if (method_solve(&method_ftcs, p, &o, &f, &why)) fail_msg("%s", why.text);
    return f;
}

static double furthest(const struct problem *p, const struct field *f) {
    double most = 0;
    double x[DIM_MAX];
    for (size_t i = 0; i < f->n; i++) most = fmax(most, fabs(f->T[i] - p->initial(p, field_place(f, i, x))));
    return most;
}

/* Some thousand steps of a few roundings each, which the middle's long sweeps around add up: 1e-11 of T. */
static void steady_states_stay(void **state) {
    (void)state;
    for (int hole = 0; hole < 2; hole++) {
        for (enum side_kind kind = DIRICHLET; kind <= ROBIN; kind++) {
            struct problem p = body(0.4 * hole, kind);
            if (kind == NEUMANN) slope = 0, p.wall = into;
            struct field f = solved_round(&p, 9, 0.2);
            assert_near(furthest(&p, &f), 0, 7e-11);
            field_free(&f);
        }
        struct problem p = body(0.4 * hole, NEUMANN);
        slope = 1.7;
        p.initial = bowl, p.wall = into, p.source = sink;
        struct field f = solved_round(&p, 9, 0.2);
        assert_near(furthest(&p, &f), 0, 7e-11);
        field_free(&f);
    }
}

static void polar_cells_sum_to_the_area(void **state) {
    (void)state;
    slope = 0;
    for (int hole = 0; hole < 2; hole++) {
        struct problem p = body(0.4 * hole, NEUMANN);
        double sum = 0, heat = 0;
        p.initial = rough, p.wall = into;
        struct field f = solved_round(&p, 9, 0.2);
        for (size_t i = 0; i < f.n; i++) sum += f.weight[i], heat += f.weight[i] * f.T[i] * p.material[0].rho_c;
        assert_near(sum, shape_volume(&p), 1e-12);
        assert_near(f.heat[1], f.heat[0], 1e-10);
        assert_near(f.heat[1], heat, 1e-10);
        field_free(&f);
    }
}

/* The heat content rises by the heat that enters: 7 W/m^2 through walls of their full length. */
static void boundary_flux_enters_once(void **state) {
    (void)state;
    struct problem p = body(0.4, NEUMANN);
    struct field f = solved_round(&p, 9, 0.2);
    assert_near(f.heat[1] - f.heat[0], 7 * p.t_end * 2 * M_PI * (1.3 + 0.4), 1e-9);
    field_free(&f);
}

/* In the norm of the areas the difference of two runs never grows up to 1/2, whatever the data are; above it does. */
static void steps_up_to_one_half_are_stable(void **state) {
    (void)state;
    for (int over = 0; over < 2; over++) {
        struct problem p = body(0, DIRICHLET), q = p;
        double before = 0, after = 0;
        p.initial = rough, q.initial = rough_elsewhere;
        p.t_end = q.t_end = 0.5;
        struct field f = solved_round(&p, 16, over ? 0.53 : 0.5), g = solved_round(&q, 16, over ? 0.53 : 0.5);
        for (size_t i = 0; i < f.n; i++) {
            double x[DIM_MAX];
            field_place(&f, i, x);
            before += f.weight[i] * pow(p.initial(&p, x) - q.initial(&q, x), 2);
            after += f.weight[i] * pow(f.T[i] - g.T[i], 2);
        }
        if (over)
            assert_order(after, >, before / 100);
        else
            assert_order(after, <, before / 100);
        field_free(&f);
        field_free(&g);
    }
    struct problem p = body(0, DIRICHLET);
    struct field f;
    struct failure why = {0};
    p.initial = rough, p.t_end = 20;
    struct options o = {.dx = 1.3 / 16, .fourier = 0.6};
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
    if (!strstr(why.text, "stable up to 0.5")) fail_msg("%s", why.text);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(modes_decay_by_the_amplification_factor),
        cmocka_unit_test(parabola_with_a_source_is_steady),
        cmocka_unit_test(fixed_walls_are_half_a_spacing_outside),
        cmocka_unit_test(heat_balance),
        cmocka_unit_test(matched_run_starts_at_the_sampling_time),
        cmocka_unit_test(changing_source_is_taken_at_the_old_time),
        cmocka_unit_test(stability),
        cmocka_unit_test(two_materials_in_the_plane),
        cmocka_unit_test(steps_are_whole_and_dx_is_snapped),
        cmocka_unit_test(steady_states_stay),
        cmocka_unit_test(polar_cells_sum_to_the_area),
        cmocka_unit_test(boundary_flux_enters_once),
        cmocka_unit_test(steps_up_to_one_half_are_stable),
    };
    return cmocka_run_group_tests_name("ftcs", tests, NULL, NULL);
}
