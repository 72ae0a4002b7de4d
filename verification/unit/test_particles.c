/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Methods as a whole on a box without two equal numbers: linear fields stay, axes exchange, heat counts, steps end on
 * time. */

#include "solver/method.h"
#include "solver/time/stepper.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

extern const struct method method_brookshaw, method_fo_ssph, method_ftcs, method_ftcs_flux, method_so_ssph;

/* ---- box ---- */

static const double SLOPE[2] = {0.77, 0.29}; /* K/m */

static double plane(const struct problem *p, const double x[2]) {
    return 0.31 + SLOPE[0] * x[0] + (p->dim == 2 ? SLOPE[1] * x[1] : 0);
}

static double plane_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    return p->side[s] == DIRICHLET ? plane(p, x) : p->material[0].k[s / 2] * SLOPE[s / 2] * (s % 2 ? 1 : -1);
}

static void stays(const struct method *m, int dim, int sides, struct options o) {
    struct problem p = dim == 2 ? odd_rectangle() : odd_rod();
    struct field f;
    struct failure why;
    char what[160];
    p.initial = plane, p.wall = plane_wall;
    if (strcmp(m->name, "brookshaw") == 0) p.material[0].k[1] = p.material[0].k[0];
    for (int s = 0; s < 4; s++) p.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
    snprintf(what, sizeof what, "%s, %d-D, sides %d, layout %d, sampling %d, order %d", m->name, dim, sides, o.layout,
             o.sampling, o.order);
    if (method_solve(m, &p, &o, &f, &why)) fail_msg("%s: %s", what, why.text);
    assert_order(f.n, >, 18);
    for (size_t i = 0; i < f.n; i++) {
        double x[DIM_MAX];
        field_place(&f, i, x);
        if (!(fabs(f.T[i] - plane(&p, x)) < 1e-12))
            fail_msg("%s: %g K at (%g, %g) m, not %g", what, f.T[i], x[0], x[1], plane(&p, x));
    }
    field_free(&f);
}

static const struct options usual = {.dx = 0.075, .h = 1.23, .stepper = STEPPER_EULER, .fourier = 0.07};

static void linear_fields_are_steady_on_lattices(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw, &method_ftcs,
                                        &method_ftcs_flux};
    for (int m = 0; m < 5; m++)
        for (int dim = 1; dim <= 2; dim++)
            for (int sides = 0; sides < (dim == 2 ? 16 : 4); sides++)
                for (int layout = 0; layout < 2; layout++)
                    for (int sampling = 0; sampling < 3; sampling++) {
                        struct options o = usual;
                        o.layout = layout ? LAYOUT_NODE : LAYOUT_LATTICE;
                        o.sampling =
                            (const enum sampling[]){SAMPLING_POINT, SAMPLING_CELL, SAMPLING_SPLINE}[sampling];
                        stays(all[m], dim, sides, o);
                    }
}

static void linear_fields_are_steady_on_clouds(void **state) {
    (void)state;
    for (int m = 0; m < 2; m++)
        for (int dim = 1; dim <= 2; dim++)
            for (int sides = 0; sides < (dim == 2 ? 16 : 4); sides++) {
                struct options o = usual;
                o.layout = LAYOUT_JITTER, o.jitter = 0.23, o.seed = 3;
                stays(m ? &method_fo_ssph : &method_so_ssph, dim, sides, o);
            }
}

static void linear_fields_are_steady_at_higher_order(void **state) {
    (void)state;
    for (int order = 2; order <= 4; order++)
        for (int sides = 0; sides < 16; sides++) {
            struct options o = usual;
            o.order = order, o.h = 0.65 * order, o.fourier = 0.05;
            stays(&method_so_ssph, 2, sides, o);
        }
}

/* ---- A wave in a box without flux decays at kappa_x q^2 + kappa_y r^2, to A dx^2 of that (A <= 1/3) and F/2 of it
 * ---- */

static double no_flux(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

/* ---- Heat: the content, and the heat that a source adds, for all materials ---- */

static double warm(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 1.7;
}

static double heating(const struct problem *p, const double x[2]) {
    return 0.43 * (x[0] - p->lo[0]); /* W m^-3: more on the right */
}

static void heat_is_counted(void **state) {
    (void)state;
    const struct method *const all[] = {&method_brookshaw, &method_ftcs};
    for (int m = 0; m < 2; m++)
        for (int dim = 1; dim <= 2; dim++)
            for (int node = 0; node < (m ? 2 : 1); node++) { /* a point with half a cell counts half */
                struct problem p = dim == 2 ? odd_rectangle() : odd_rod();
                struct options o = usual;
                struct field f;
                struct failure why;
                double height = dim == 2 ? 1.2 : 1;
                int two = !node && (m == 0 || dim == 1);
                p.initial = warm, p.wall = no_flux, p.source = heating;
                p.materials = two ? 2 : 1, p.interface = 0.25; /* on a face: 0.6 m of 1.5 */
                p.material[0].k[1] = p.material[0].k[0];
                p.material[1] = (struct material){{0.21, 0.21}, 0.9};
                for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
                o.layout = node ? LAYOUT_NODE : LAYOUT_LATTICE;
                if (method_solve(all[m], &p, &o, &f, &why)) fail_msg("%s: %s", all[m]->name, why.text);
                double held = 1.7 * height * (1.3 * 0.6 + (two ? 0.9 : 1.3) * 0.9),
                       gained = p.t_end * height * 0.43 * 1.5 * 1.5 / 2;
                assert_near(f.heat[0] / held, 1, 1e-12);
                assert_near((f.heat[1] - f.heat[0]) / gained, 1, 1e-9);
                field_free(&f);
            }
}

/* ---- A run is unstable if it exceeds the temperatures of the walls; each side in turn is hot near one end ---- */

static int hot_side, hot_end;

static double cold(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 0;
}

static double hot_corner(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    int along = 1 - (int)s / 2, axis = (int)s / 2;
    double from = fabs(x[along] - (hot_end ? p->hi[along] : p->lo[along]));
    int on_it = fabs(x[axis] - (s % 2 ? p->hi[axis] : p->lo[axis])) < 1e-9; /* as struct problem promises */
    return (int)s == hot_side && on_it ? 2.385 * exp(-9 * from) : 0;
}

static void hot_corner_heats_the_nearest_particle(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_ftcs};
    for (int m = 0; m < 2; m++)
        for (hot_side = 0; hot_side < 4; hot_side++)
            for (hot_end = 0; hot_end < 2; hot_end++) {
                struct problem p = odd_rectangle();
                struct options o = usual;
                struct field f;
                struct failure why;
                double most = 0;
                p.initial = cold, p.wall = hot_corner, p.t_end = 0.05;
                for (int s = 0; s < 4; s++) p.side[s] = s / 2 == hot_side / 2 ? DIRICHLET : NEUMANN;
                if (method_solve(all[m], &p, &o, &f, &why))
                    fail_msg("%s, side %d, end %d: %s", all[m]->name, hot_side, hot_end, why.text);
                for (size_t i = 0; i < f.n; i++) most = fmax(most, f.T[i]);
                assert_order(most, >, 0.8);
                assert_order(most, <, 2.385);
                field_free(&f);
            }
}

/* ---- A failure of a run reports its place and time: a particle of the box and the number of the step ---- */

static void failures_name_the_particle(void **state) {
    (void)state;
    for (int dim = 1; dim <= 2; dim++) {
        struct problem p = dim == 2 ? odd_rectangle() : odd_rod();
        struct options o = usual;
        struct field f;
        struct failure why;
        double x[2] = {0, 0.2375}, sum = 0, dt = 0.52 * o.dx * o.dx / ((0.7 + (dim == 2 ? 0.4 : 0)) / 1.3);
        p.t_end = 4000 * dt;
        o.fourier = 0, o.dt = dt;
        assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
        const char *at = strstr(why.text, "at x = "), *bound = strstr(why.text, "kappa dt/dx^2 is ");
        assert_true(at && bound);
        assert_int_equal(sscanf(at, dim == 2 ? "at x = %lf m, y = %lf m" : "at x = %lf m", &x[0], &x[1]), dim);
        assert_int_equal(sscanf(bound, "kappa dt/dx^2 is %lf", &sum), 1);
        for (int a = 0; a < dim; a++) {
            double cells = (x[a] - p.lo[a]) / o.dx - 0.5;
            assert_near(cells, nearbyint(cells), 1e-4);
            assert_order(p.lo[a], <, x[a]);
            assert_order(x[a], <, p.hi[a]);
        }
        assert_near(sum, dt * (0.7 + (dim == 2 ? 0.4 : 0)) / 1.3 / (o.dx * o.dx), 1e-4);
    }
}

/* ---- runs ---- */

/* F counts in the larger diffusivity, whichever axis has it; the step is shortened to end on time. */
static void last_step_ends_at_t_end(void **state) {
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
static double warm_runs(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 1.7;
}

/* Heated through one end for so long that q t/(rho_c L) is 40 times the bend q L/k of the profile, which is all that
 * the initial data span: hot, but not unstable. */
static double heating_runs(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)x, (void)t;
    return s == X_HI ? 0.37 : 0;
}

static void heating_by_a_wall_is_not_instability(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_brookshaw, &method_ftcs};
    for (int k = 0; k < 3; k++) {
        struct problem p = odd_rod();
        struct options o = {.dx = 0.05, .h = 1.23, .stepper = STEPPER_EULER, .fourier = 0.21};
        struct field f;
        struct failure why;
        double extent = p.hi[0] - p.lo[0], mean = 0;
        p.initial = warm_runs, p.wall = heating_runs, p.source = NULL;
        p.side[X_LO] = p.side[X_HI] = NEUMANN;
        p.t_end = 40 * extent * extent * p.material[0].rho_c / p.material[0].k[0];
        if (method_solve(all[k], &p, &o, &f, &why)) fail_msg("%s: %s", all[k]->name, why.text);
        for (size_t i = 0; i < f.n; i++) mean += f.T[i] / (double)f.n;
        assert_near(mean, 1.7 + 0.37 * p.t_end / (p.material[0].rho_c * extent), 1e-9 * mean);
        field_free(&f);
    }
}

/* One wall that the start does not meet, with points on the walls: the start jumps there, whichever wall it is. */
static double warmer(const struct problem *p, enum side s, const double x[2], double t) {
    (void)x, (void)t;
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
        p.initial = warm_runs, p.wall = warmer, p.material[0].k[1] = p.material[0].k[0];
        for (int k = 0; k < 4; k++) p.side[k] = k == s ? DIRICHLET : NEUMANN;
        snprintf(where, sizeof where, "jump at %c = %.6g m", "xy"[s / 2], s % 2 ? p.hi[s / 2] : p.lo[s / 2]);
        assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
        if (!strstr(why.text, where)) fail_msg("%s: %s", where, why.text);
    }
}

/* One wall whose temperature varies along it, or only on the path through the body. */
static double along_it(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    return p->side[s] == DIRICHLET ? x[1 - s / 2] : 0;
}

static double through_it(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
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

/* ---- axes ---- */

static struct problem upright;

/* Jumps along x, meets the walls of x and not those of y. */
static double uneven(const struct problem *p, const double x[2]) {
    double far = (x[0] - p->lo[0]) * (p->hi[0] - x[0]);
    return 0.3 + (x[0] < 0.4 ? 1 : 0.4) * far * (1.1 + sin(1.3 * x[1]));
}

static double uneven_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    if (p->side[s] == NEUMANN) return 0.21 * (1 + (int)s) * (0.2 + x[1 - (int)s / 2]);
    return s < Y_LO ? 0.3 : 0.9 - 0.3 * x[0] + 0.1 * s;
}

static double uneven_source(const struct problem *p, const double x[2]) {
    return 0.31 * (x[0] - p->lo[0]) + 0.83 * x[1] * x[1];
}

static double across(const struct problem *p, const double x[2]) {
    (void)p;
    return uneven(&upright, (const double[]){x[1], x[0]});
}

static double across_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)t;
    return uneven_wall(&upright, (enum side)((s + 2) % 4), (const double[]){x[1], x[0]}, 0);
}

static double across_source(const struct problem *p, const double x[2]) {
    (void)p;
    return uneven_source(&upright, (const double[]){x[1], x[0]});
}

static void exchanges(const struct method *m, int sides, struct options o) {
    struct field f, g;
    struct failure why;
    char what[160];
    snprintf(what, sizeof what, "%s, sides %d, layout %d, sampling %d, stepper %d", m->name, sides, o.layout,
             o.sampling, o.stepper);
    upright = odd_rectangle();
    upright.initial = uneven, upright.wall = uneven_wall, upright.source = uneven_source;
    upright.jumps[0] = 1, upright.jump[0][0] = 0.4;
    if (strcmp(m->name, "brookshaw") == 0) upright.material[0].k[1] = upright.material[0].k[0];
    for (int s = 0; s < 4; s++) upright.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
    struct problem lying = upright;
    lying.initial = across, lying.wall = across_wall, lying.source = across_source;
    for (int a = 0; a < 2; a++) {
        lying.lo[a] = upright.lo[1 - a], lying.hi[a] = upright.hi[1 - a];
        lying.material[0].k[a] = upright.material[0].k[1 - a];
        lying.jumps[a] = upright.jumps[1 - a], lying.jump[a][0] = upright.jump[1 - a][0];
        for (int hi = 0; hi < 2; hi++) lying.side[2 * a + hi] = upright.side[2 * (1 - a) + hi];
    }
    if (method_solve(m, &upright, &o, &f, &why) || method_solve(m, &lying, &o, &g, &why))
        fail_msg("%s: %s", what, why.text);
    assert_int_equal(f.shape[0], g.shape[1]);
    assert_int_equal(f.shape[1], g.shape[0]);
    for (int j = 0; j < f.shape[1]; j++)
        for (int i = 0; i < f.shape[0]; i++) {
            size_t k = (size_t)j * (size_t)f.shape[0] + (size_t)i, l = (size_t)i * (size_t)g.shape[0] + (size_t)j;
            if (!(fabs(f.T[k] - g.T[l]) < 1e-11)) fail_msg("%s: %.17g and %.17g K", what, f.T[k], g.T[l]);
        }
    field_free(&f);
    field_free(&g);
}

static void exchange_of_axes_exchanges_the_result(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw, &method_ftcs,
                                        &method_ftcs_flux};
    static const enum sampling samplings[] = {SAMPLING_POINT, SAMPLING_CELL, SAMPLING_SPLINE};
    static const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_EXACT, STEPPER_RKL2};
    for (int m = 0; m < 5; m++)
        for (int sides = 0; sides < 16; sides++)
            for (int layout = 0; layout < 2; layout++)
                for (int sampling = 0; sampling < 3; sampling++)
                    for (int stepper = 0; stepper < (m < 3 ? 3 : 1); stepper++) {
                        struct options o = {.dx = 0.075, .h = 1.23, .stepper = steppers[stepper]};
                        o.layout = layout ? LAYOUT_NODE : LAYOUT_LATTICE;
                        o.sampling = samplings[sampling];
                        o.fourier = o.stepper == STEPPER_EXACT ? 0 : o.stepper == STEPPER_RKL2 ? 0.7 : 0.07;
                        exchanges(all[m], sides, o);
                    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_fields_are_steady_on_lattices),
        cmocka_unit_test(linear_fields_are_steady_on_clouds),
        cmocka_unit_test(linear_fields_are_steady_at_higher_order),
        cmocka_unit_test(heat_is_counted),
        cmocka_unit_test(hot_corner_heats_the_nearest_particle),
        cmocka_unit_test(failures_name_the_particle),
        cmocka_unit_test(last_step_ends_at_t_end),
        cmocka_unit_test(heating_by_a_wall_is_not_instability),
        cmocka_unit_test(matched_refuses_a_jump_at_every_wall),
        cmocka_unit_test(first_derivatives_are_not_matched_where_a_wall_varies),
        cmocka_unit_test(exchange_of_axes_exchanges_the_result),
    };
    return cmocka_run_group_tests_name("particles", tests, NULL, NULL);
}
