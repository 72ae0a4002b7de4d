/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Relaxed and hexagonal clouds: places of particles and ghosts, heat, the same for any threads. */
#include "solver/space/layout.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

extern const struct method method_so_ssph, method_brookshaw, method_kernel_second;

static struct options options_of(enum layout_name layout) {
    return (struct options){.dx = 0.05, .h = 1.23, .seed = 7, .layout = layout, .jitter = 0.5, .sweeps = 2000};
}

static void make(const struct problem *p, const struct options *o, struct cloud *c) {
    struct lattice l;
    struct failure why = {0};
    assert_int_equal(layout_lattice(p, o, 1, &l, &why), STATUS_OK);
    if (layout_cloud(p, o, &l, 2 * o->h * l.dx[0], c, &why)) print_error("%s\n", why.text);
    assert_int_equal(why.status, STATUS_OK);
}

static double distance(const struct cloud *c, size_t i, size_t j) {
    return hypot(c->x[i] - c->x[j], c->y[i] - c->y[j]);
}

/* Six neighbours at one distance, but for stretching (1.2 m hold 28 rows of 0.0429 instead of 0.0433 m), away from
 * walls. */
static void six_neighbours(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_HEXAGONAL);
    struct cloud c;
    int seen = 0;
    make(&p, &o, &c);
    assert_near(c.volume * (double)c.n, 1.5 * 1.2, 1e-12);
    for (size_t i = 0; i < c.n; i++) {
        int near = 0;
        if (fabs(c.x[i] - 0.4) > 0.5 || fabs(c.y[i] - 0.8) > 0.4) continue;
        for (size_t j = 0; j < c.total; j++) {
            if (j == i || distance(&c, i, j) > 1.3 * 0.05) continue;
            assert_near(distance(&c, i, j) / 0.05, 1, 0.01);
            near++;
        }
        assert_int_equal(near, 6);
        seen++;
    }
    assert_order(seen, >, 100);
    layout_cloud_free(&c);
}

static void ghosts_are_mirror_images(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_JITTER);
    struct cloud c;
    make(&p, &o, &c);
    assert_order(c.total, >, c.n);
    for (size_t i = c.n; i < c.total; i++) {
        for (int a = 0; a < 2; a++) {
            double at = a ? c.y[i] : c.x[i], from = a ? c.y[c.source[i]] : c.x[c.source[i]];
            double off = fmin(fabs(at - from), fmin(fabs(at + from - 2 * p.lo[a]), fabs(at + from - 2 * p.hi[a])));
            assert_near(off, 0, 1e-13);
        }
    }
    layout_cloud_free(&c);
}

static double nearest(const struct cloud *c) {
    double least = HUGE_VAL;
    for (size_t i = 0; i < c->n; i++)
        for (size_t j = 0; j < c->total; j++)
            if (j != i) least = fmin(least, distance(c, i, j));
    return least;
}

static void settled_clouds(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_RELAXED), start = options_of(LAYOUT_JITTER);
    struct cloud c, d, raw;
    make(&p, &o, &c);
    make(&p, &start, &raw);
    assert_order(nearest(&c), >, 0.75 * 0.05); /* grains of hexagons, 1.07 dx apart, and their borders */
    assert_order(nearest(&raw), <, 0.4 * 0.05);
    for (size_t i = 0; i < c.n; i++) {
        assert_order(c.x[i], >, p.lo[0]);
        assert_order(c.x[i], <, p.hi[0]);
        assert_order(c.y[i], >, p.lo[1]);
        assert_order(c.y[i], <, p.hi[1]);
    }
    o.threads = 3;
    make(&p, &o, &d);
    assert_memory_equal(c.x, d.x, c.total * sizeof *c.x);
    assert_memory_equal(c.y, d.y, c.total * sizeof *c.y);
    layout_cloud_free(&d);
    o.seed = 8;
    make(&p, &o, &d);
    assert_true(memcmp(c.x, d.x, c.n * sizeof *c.x) != 0);
    layout_cloud_free(&d);
    layout_cloud_free(&c);
    layout_cloud_free(&raw);
}

static void unsettled_clouds_say_how_far_they_came(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_RELAXED);
    struct field f;
    struct failure why;
    o.sweeps = 3;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_NUMERICAL);
    assert_has(why.text, "not settled after 3 sweeps");
    assert_has(why.text, "take more --sweeps");
}

/* A step of an affine field that the walls keep: nothing may change, whatever the cloud. */
static double affine(const struct problem *p, const double x[2]) {
    (void)p;
    return 0.37 + 0.61 * x[0] - 0.23 * x[1];
}

static double affine_wall(const struct problem *p, enum side s, const double x[2]) {
    return p->side[s] == DIRICHLET ? affine(p, x) : (s == Y_LO ? 0.23 : -0.23) * p->material[0].k[1];
}

static void affine_fields_stay_on_any_cloud(void **state) {
    (void)state;
    for (int layout = LAYOUT_JITTER; layout <= LAYOUT_HEXAGONAL; layout++) {
        struct problem p = odd_rectangle();
        struct options o = options_of((enum layout_name)layout);
        struct failure why = {0};
        struct field f;
        p.initial = affine, p.wall = affine_wall;
        if (layout == LAYOUT_JITTER) o.jitter = 0.31;
        if (method_solve(&method_so_ssph, &p, &o, &f, &why)) print_error("%s\n", why.text);
        assert_int_equal(why.status, STATUS_OK);
        for (size_t i = 0; i < f.n; i++) {
            double x[2] = {f.x[i], f.y[i]};
            assert_near(f.T[i], affine(&p, x), 1e-11);
        }
        field_free(&f);
    }
}

static double no_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 0;
}

static void pair_fluxes_keep_heat_on_every_cloud(void **state) {
    (void)state;
    const struct method *pair[2] = {&method_brookshaw, &method_kernel_second};
    for (int m = 0; m < 2; m++)
        for (int layout = LAYOUT_RELAXED; layout <= LAYOUT_HEXAGONAL; layout++) {
            struct problem p = odd_rectangle();
            struct options o = options_of((enum layout_name)layout);
            struct failure why = {0};
            struct field f;
            for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
            p.wall = no_flux, p.material[0].k[1] = p.material[0].k[0], p.t_end = 1e-4;
            o.h = 1.1, o.stepper = STEPPER_EULER, o.fourier = 0.02;
            if (method_solve(pair[m], &p, &o, &f, &why)) print_error("%s\n", why.text);
            assert_int_equal(why.status, STATUS_OK);
            assert_near(f.heat[1] / f.heat[0], 1, 1e-13);
            field_free(&f);
        }
}

/* Particles taken from an earlier answer are those that would be settled again: the same temperatures, bit for bit;
 * the answer's own dt has no part in it. */
static void settled_particles_are_taken_as_they_lie(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_RELAXED);
    struct field before, again, taken;
    struct failure why;
    o.stepper = STEPPER_RK2;
    o.fourier = 0.05;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &before, &why), STATUS_OK);
    o.fourier = 0.04;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &again, &why), STATUS_OK);
    o.placed = &before;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &taken, &why), STATUS_OK);
    assert_memory_equal(taken.x, again.x, taken.n * sizeof *taken.x);
    assert_memory_equal(taken.y, again.y, taken.n * sizeof *taken.y);
    assert_memory_equal(taken.T, again.T, taken.n * sizeof *taken.T);
    assert_true(taken.T[17] != before.T[17]);
    field_free(&before);
    field_free(&again);
    field_free(&taken);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(six_neighbours),
        cmocka_unit_test(ghosts_are_mirror_images),
        cmocka_unit_test(settled_clouds),
        cmocka_unit_test(settled_particles_are_taken_as_they_lie),
        cmocka_unit_test(unsettled_clouds_say_how_far_they_came),
        cmocka_unit_test(affine_fields_stay_on_any_cloud),
        cmocka_unit_test(pair_fluxes_keep_heat_on_every_cloud),
    };
    return cmocka_run_group_tests_name("clouds", tests, NULL, NULL);
}
