/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls that cut the lattice at arbitrary positions: values of dummies, the choice of held particles, clipped cells;
 * and initial data that solve the equation remain steady. */
#include "solver/space/assembly.h"
#include "solver/shape.h"
#include "solver/particles/particles.h"
#include "solver/particles/particles.h"
#include "solver/particles/walls.h"

#include "verification/stability/spectrum.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <string.h>

extern const struct method method_so_ssph;

static const double K = 0.7, B = 1.9;

/* The field that a treatment continues: a + b x + c y + degree 2, with one kind of wall everywhere. */
static struct field_of {
    double a, b, c, xx, xy, yy;
} const quadratic = {1.1, 0.7, -0.4, 0.35, -0.55, 0.85}, linear = {1.1, 0.7, -0.4, 0, 0, 0},
        flat = {1.1, 0, 0, 0, 0, 0};

static double value(const struct field_of *f, const double x[2]) {
    return f->a + f->b * x[0] + f->c * x[1] + f->xx * x[0] * x[0] + f->xy * x[0] * x[1] + f->yy * x[1] * x[1];
}

static double slope(const struct field_of *f, const double x[2], const double n[2]) {
    return n[0] * (f->b + 2 * f->xx * x[0] + f->xy * x[1]) + n[1] * (f->c + f->xy * x[0] + 2 * f->yy * x[1]);
}

static double initial(const struct problem *p, const double x[2]) {
    return value(p->data, x);
}

static double wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    struct foot f = shape_foot(p, (int)s, x);
    double T = value(p->data, f.x), q = K * slope(p->data, f.x, f.normal);
    return p->side[s] == DIRICHLET ? T : p->side[s] == NEUMANN ? q : T + q / B;
}

static struct problem body(int round, enum side_kind kind, const struct field_of *f) {
    struct problem p = {.dim = 2, .hi = {1.3, 0.9}, .t_end = 0.01, .materials = 1, .material = {{{K, K}, 1}}};
    if (round) shape_round(&p, round == 2 ? 0.5 : 0, 1.1);
    for (int s = 0; s < 4; s++) p.side[s] = kind, p.robin[s] = kind == ROBIN ? B : 0;
    p.initial = initial, p.wall = wall, p.data = f;
    return p;
}

/* The largest error of a dummy within 2.2 dx of a wall, K. */
static double off(const struct problem *p, enum walls walls, enum layout_name layout) {
    struct options o = {.dx = 0.1, .h = 1.1, .walls = walls, .layout = layout, .jitter = 0.2, .seed = 3};
    struct lattice l;
    struct cloud c;
    struct failure why = {0};
    double most = 0;
    if (!p->shape) o.shift = 0.37;
    if (layout_lattice(p, &o, &l, &why) || layout_cloud(p, &o, &l, 0.22, &c, &why) ||
        walls_fill(p, &o, &c, 0.1, &why))
        fail_msg("%s", why.text);
    assert_order(c.n, >, 30);
    assert_order(c.total, >, c.n);
    for (size_t j = c.n; j < c.total; j++) {
        double T = c.offset[j], x[2] = {c.x[j], c.y[j]};
        for (size_t k = c.begin[j - c.n]; k < c.begin[j - c.n + 1]; k++)
            T += c.share[k] * value(p->data, (const double[2]){c.x[c.from[k]], c.y[c.from[k]]});
        most = fmax(most, fabs(T - value(p->data, x)));
    }
    layout_cloud_free(&c);
    return most;
}

static void fits_continue_quadratics(void **state) {
    (void)state;
    for (int round = 0; round < 3; round++)
        for (int kind = DIRICHLET; kind <= ROBIN; kind++)
            for (int layout = 0; layout < 2; layout++) {
                struct problem p = body(round, (enum side_kind)kind, &quadratic);
                assert_near(off(&p, WALLS_FIT, layout ? LAYOUT_JITTER : LAYOUT_LATTICE), 0, 1e-11);
            }
}

/* Across a plane wall; a corner of two walls takes two reflections. */
static void images_continue_linear_temperatures(void **state) {
    (void)state;
    for (int kind = DIRICHLET; kind <= ROBIN; kind++) {
        struct problem p = body(0, (enum side_kind)kind, &linear);
        if (kind == ROBIN) continue; /* its factor is that of a slope along the normal alone */
        assert_near(off(&p, WALLS_IMAGE, LAYOUT_LATTICE), 0, 1e-12);
        p.data = &quadratic;
        assert_order(off(&p, WALLS_IMAGE, LAYOUT_LATTICE), >, 1e-3);
    }
}

static void every_treatment_keeps_a_constant(void **state) {
    (void)state;
    static const enum walls all[] = {WALLS_FIXED, WALLS_AVERAGE, WALLS_IMAGE, WALLS_FIT};
    for (int round = 0; round < 3; round++)
        for (int t = 0; t < 4; t++)
            for (int kind = DIRICHLET; kind <= ROBIN; kind++) {
                struct problem p = body(round, (enum side_kind)kind, &flat);
                struct options o = {.walls = all[t], .shift = round ? 0 : 0.37};
                struct failure why;
                if (particles_check(&p, &o, method_so_ssph.scheme, &why)) continue;
                assert_near(off(&p, all[t], LAYOUT_LATTICE), 0, 1e-12);
            }
}

/* so_ssph is exact for quadratics, dummies continue them, and the one-sided fit is exact for them: d T/dt = kappa
 * lap T everywhere except at held particles.  First derivatives are exact for quadratics on the lattice that the
 * dummies continue for two kernel widths. */
static void quadratic_has_uniform_heating_rate(void **state) {
    (void)state;
    extern const struct method method_fatehi_manzari, method_fo_ssph, method_flux_divergence;
    const struct method *const all[] = {&method_so_ssph, &method_fatehi_manzari, &method_so_ssph, &method_fo_ssph,
                                        &method_flux_divergence};
    struct field_of harmonic = quadratic;
    harmonic.yy = -harmonic.xx;
    for (int m = 0; m < 5; m++)
        for (int round = 0; round < 3; round++)
            for (int kind = DIRICHLET; kind <= ROBIN; kind++) {
                struct problem p = body(round, (enum side_kind)kind, &harmonic);
                struct options o = {.dx = 0.1, .shift = round ? 0 : 0.5, .stepper = STEPPER_RKL2};
                o.walls = m == 2 ? WALLS_ONE_SIDED : WALLS_FIT;
                struct field f;
                struct failure why;
                if (method_solve(all[m], &p, &o, &f, &why)) fail_msg("%s", why.text);
                for (size_t i = 0; i < f.n; i++)
                    assert_near(f.T[i], value(&harmonic, (const double[2]){f.x[0][i], f.x[1][i]}), 1e-10);
                field_free(&f);
            }
}

/* One-sided rows: weights of the size of an inner particle's at any distance from a wall, so that no step is lost. */
static void one_sided_rows_do_not_grow_beside_a_wall(void **state) {
    (void)state;
    extern const struct method method_so_ssph;
    for (int kind = DIRICHLET; kind <= ROBIN; kind++)
        for (int near = 1; near < 6; near++) {
            struct problem p = body(0, (enum side_kind)kind, &flat);
            struct options o = {.dx = 0.1, .h = 1.1, .walls = WALLS_ONE_SIDED};
            struct lattice l;
            struct cloud c;
            struct heat_operator a;
            struct failure why;
            o.shift = 0.5 + pow(10, -near);
            assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
            assert_int_equal(layout_cloud(&p, &o, &l, 0.22, &c, &why), STATUS_OK);
            assert_int_equal(c.total, c.n); /* no dummies */
            assert_int_equal(assembly_operator(&a, &p, &o, method_so_ssph.scheme, &c, 0.1, &why), STATUS_OK);
            double most = 0, inner = 4 * K / 0.01; /* the symbol's largest */
            for (size_t i = 0; i < a.n; i++) most = fmax(most, fabs(a.diagonal[i]));
            if (!(most < inner)) fail_msg("kind %d, 1e-%d dx from the wall: %g, %g inside", kind, near, most, inner);
            layout_cloud_free(&c);
            operator_free(&a);
        }
}

static void a_missing_one_sided_fit_is_refused(void **state) {
    (void)state;
    extern const struct method method_so_ssph;
    struct problem p = body(1, DIRICHLET, &flat);
    struct options o = {.dx = 0.9, .walls = WALLS_ONE_SIDED, .stepper = STEPPER_RKL2};
    struct field f;
    struct failure why;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_NUMERICAL);
    assert_non_null(strstr(why.text, "at least 15 are needed"));
}

/* All eigenvalues, on lattices and clouds of jitter 0.2: none grows, and the largest step of so_ssph is within one
 * fifth of its value without walls, 0.525 dx^2/kappa; at jitter 0.3 it is at least 0.43. */
static void fits_let_no_mode_grow(void **state) {
    (void)state;
    extern const struct method method_so_ssph, method_fo_ssph, method_fatehi_manzari;
    const struct method *const all[] = {&method_so_ssph, &method_fatehi_manzari, &method_fo_ssph};
    for (int m = 0; m < 3; m++)
        for (int round = 0; round < 3; round++)
            for (int k = 0; k < 6; k++) {
                struct problem p = body(round, (enum side_kind)(k / 2), &flat);
                struct options o = {.dx = 0.13, .h = 1.1, .walls = WALLS_FIT, .seed = 5, .shift = round ? 0 : 0.47};
                struct lattice l;
                struct cloud c;
                struct heat_operator a;
                struct spectrum s;
                struct failure why;
                if (!round) o.dx = 0.1;
                if (k % 2 && m < 2) o.layout = LAYOUT_JITTER, o.jitter = 0.2;
                if (k % 2 && m == 2) o.seed = 6, o.shift *= 1.5; /* fo_ssph grows on a cloud without walls too */
                if (layout_lattice(&p, &o, &l, &why) || particles_cloud(&p, &o, all[m]->scheme, &l, &c, &why) ||
                    assembly_operator(&a, &p, &o, all[m]->scheme, &c, o.dx, &why) ||
                    spectrum_create(&s, &a, &(struct amplification){STEPPER_EULER, 0}, &why))
                    fail_msg("%s", why.text);
                if (!(s.growth <= spectrum_rounding(&s)))
                    fail_msg("%s, body %d, kind and layout %d: %g", all[m]->name, round, k, s.growth);
                if (m == 0) assert_order(s.limit * K / (o.dx * o.dx), >, k % 2 ? 0.344 : 0.42);
                spectrum_free(&s);
                operator_free(&a);
                layout_cloud_free(&c);
            }
}

static void particles_on_a_wall_hold_its_temperature(void **state) {
    (void)state;
    struct problem p = body(0, DIRICHLET, &linear);
    struct options o = {.dx = 0.1, .h = 1.1, .shift = 0.5, .walls = WALLS_FIT};
    struct lattice l;
    struct cloud c;
    struct failure why;
    size_t held = 0;
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&p, &o, &l, 0.22, &c, &why), STATUS_OK);
    for (size_t i = 0; i < c.n; i++) held += c.held[i];
    assert_int_equal(c.n, 14 * 10);
    assert_int_equal(held, 14 * 10 - 12 * 8);
    layout_cloud_free(&c);
}

/* Cells of a lattice anywhere add up to the body. */
static void clipped_cells_fill_the_body(void **state) {
    (void)state;
    for (int round = 1; round < 3; round++) {
        struct problem p = body(round, DIRICHLET, &flat);
        double d = 0.173, sum = 0, hole = round == 2 ? 0.25 : 0;
        for (int j = -10; j < 10; j++)
            for (int i = -10; i < 10; i++)
                sum += shape_clipped(&p, (const double[2]){(i + 0.21) * d, (j + 0.67) * d},
                                     (const double[2]){(i + 1.21) * d, (j + 1.67) * d});
        assert_near(sum, 3.14159265358979323846 * (1.21 - hole), 1e-13);
        assert_near(shape_volume(&p), 3.14159265358979323846 * (1.21 - hole), 1e-14);
    }
}

/* From the centre every place of a round wall is the nearest: one of them is taken. */
static void centre_of_a_disc_has_a_wall_point(void **state) {
    (void)state;
    struct problem p = {.dim = 2};
    shape_round(&p, 0, 1.3);
    struct foot f = shape_foot(&p, X_HI, (double[2]){0, 0});
    assert_near(hypot(f.x[0], f.x[1]), 1.3, 1e-15);
    assert_near(f.normal[0] * 1.3, f.x[0], 1e-15);
    assert_near(f.normal[1] * 1.3, f.x[1], 1e-15);
    assert_near(f.depth, 1.3, 1e-15);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(centre_of_a_disc_has_a_wall_point),
        cmocka_unit_test(fits_continue_quadratics),
        cmocka_unit_test(images_continue_linear_temperatures),
        cmocka_unit_test(every_treatment_keeps_a_constant),
        cmocka_unit_test(quadratic_has_uniform_heating_rate),
        cmocka_unit_test(one_sided_rows_do_not_grow_beside_a_wall),
        cmocka_unit_test(a_missing_one_sided_fit_is_refused),
        cmocka_unit_test(fits_let_no_mode_grow),
        cmocka_unit_test(particles_on_a_wall_hold_its_temperature),
        cmocka_unit_test(clipped_cells_fill_the_body),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("walls anywhere", tests, NULL, NULL);
}
