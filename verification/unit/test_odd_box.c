/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Methods as a whole, on a box whose extents, places, spacings and conductivities all differ.
 *
 * A linear temperature stays as it is: its second derivatives vanish, first ones are exact, averages are its values,
 * and every wall continues it exactly, be it held or heated.  For all 16 kinds of sides, every layout and every
 * sampling, so that no axis and no side can be taken for another. */
#include "solver/method.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

extern const struct method method_so_ssph, method_fo_ssph, method_brookshaw, method_ftcs, method_ftcs_flux;

static const double SLOPE[2] = {0.77, 0.29}; /* K/m */

static double plane(const struct problem *p, const double x[2]) {
    return 0.31 + SLOPE[0] * x[0] + (p->dim == 2 ? SLOPE[1] * x[1] : 0);
}

static double plane_wall(const struct problem *p, enum side s, const double x[2]) {
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
        const double x[2] = {f.x[i], f.y ? f.y[i] : 0};
        if (!(fabs(f.T[i] - plane(&p, x)) < 1e-12))
            fail_msg("%s: %g K at (%g, %g) m, not %g", what, f.T[i], x[0], x[1], plane(&p, x));
    }
    field_free(&f);
}

static const struct options usual = {.dx = 0.075, .h = 1.23, .stepper = STEPPER_EULER, .fourier = 0.07};

static void on_lattices(void **state) {
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

static void on_clouds(void **state) {
    (void)state;
    for (int m = 0; m < 2; m++)
        for (int dim = 1; dim <= 2; dim++)
            for (int sides = 0; sides < (dim == 2 ? 16 : 4); sides++) {
                struct options o = usual;
                o.layout = LAYOUT_JITTER, o.jitter = 0.23, o.seed = 3;
                stays(m ? &method_fo_ssph : &method_so_ssph, dim, sides, o);
            }
}

static void of_higher_order(void **state) {
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

static const double PI = 3.14159265358979323846;
static int waves[2];

static double wave(const struct problem *p, const double x[2]) {
    double product = 1;
    for (int a = 0; a < p->dim; a++) product *= cos(waves[a] * PI * (x[a] - p->lo[a]) / (p->hi[a] - p->lo[a]));
    return 1.9 + product;
}

static double no_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 0;
}

static void decays(const struct method *m, int order) {
    struct problem p = odd_rectangle();
    struct options o = usual;
    struct field f;
    struct failure why;
    double rate = 0, left = 0, start = 0;
    p.initial = wave, p.wall = no_flux;
    if (strcmp(m->name, "brookshaw") == 0) p.material[0].k[1] = p.material[0].k[0];
    for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
    for (int a = 0; a < 2; a++)
        rate += p.material[0].k[a] / p.material[0].rho_c * pow(waves[a] * PI / (p.hi[a] - p.lo[a]), 2);
    p.t_end = 0.9 / rate;
    o.dx = 0.0375, o.order = order, o.fourier = 0.05;
    if (order) o.h = 0.65 * order;
    if (method_solve(m, &p, &o, &f, &why)) fail_msg("%s, order %d: %s", m->name, order, why.text);
    for (size_t i = 0; i < f.n; i++) {
        double w = wave(&p, (const double[]){f.x[i], f.y[i]}) - 1.9;
        left += w * (f.T[i] - 1.9);
        start += w * w;
    }
    double seen = -log(left / start) / p.t_end;
    if (!(fabs(seen / rate - 1) < 0.02))
        fail_msg("%s, order %d, waves %d and %d: decays at %g of its rate", m->name, order, waves[0], waves[1],
                 seen / rate);
    field_free(&f);
}

static void waves_decay_at_their_rate(void **state) {
    (void)state;
    static const int of[3][2] = {{1, 0}, {0, 1}, {2, 1}};
    for (int k = 0; k < 3; k++) {
        waves[0] = of[k][0], waves[1] = of[k][1];
        for (int order = 2; order <= 4; order++) decays(&method_so_ssph, order);
        decays(&method_fo_ssph, 0);
        decays(&method_brookshaw, 0);
        decays(&method_ftcs, 0);
        decays(&method_ftcs_flux, 0);
    }
}

/* ---- Heat: what is there, and what a source adds, whatever the materials ---- */

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
            for (int node = 0; node < (m ? 2 : 1);
                 node++) { /* particles count alike, also where half a cell is theirs */
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

/* ---- A run is unstable past what the walls hold, wherever they hold it: each side in turn is hot near one end ----
 */

static int hot_side, hot_end;

static double cold(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 0;
}

static double hot_corner(const struct problem *p, enum side s, const double x[2]) {
    int along = 1 - (int)s / 2, axis = (int)s / 2;
    double from = fabs(x[along] - (hot_end ? p->hi[along] : p->lo[along]));
    int on_it = fabs(x[axis] - (s % 2 ? p->hi[axis] : p->lo[axis])) < 1e-9; /* as struct problem promises */
    return (int)s == hot_side && on_it ? 2.385 * exp(-9 * from) : 0;
}

static void walls_are_hot_where_they_are(void **state) {
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

/* ---- Where and when a run failed is what it says: on a particle of the box, with the step's own number ---- */

static void a_failure_says_where(void **state) {
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

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_lattices),          cmocka_unit_test(on_clouds),
        cmocka_unit_test(of_higher_order),      cmocka_unit_test(waves_decay_at_their_rate),
        cmocka_unit_test(heat_is_counted),      cmocka_unit_test(walls_are_hot_where_they_are),
        cmocka_unit_test(a_failure_says_where),
    };
    return cmocka_run_group_tests_name("odd_box", tests, NULL, NULL);
}
