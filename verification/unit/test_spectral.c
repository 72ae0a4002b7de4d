/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The spectral second form, on data with a known evolution. */
#include "references/spectral.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

static struct problem box(int dim, enum side_kind along_x, enum side_kind along_y) {
    struct problem p = {.dim = dim, .lo = {-0.3, 0.2}, .hi = {1.1, 1.3}, .materials = 1};
    p.material[0] = (struct material){{0.023, 0.0061}, 1.9};
    p.side[X_LO] = p.side[X_HI] = along_x;
    p.side[Y_LO] = p.side[Y_HI] = along_y;
    return p;
}

/* Two modes an axis, 5 along x; kind sine or cosine by the sides */
static double wave(const struct problem *p, int d, int m, double x) {
    double phase = m * M_PI * (x - p->lo[d]) / (p->hi[d] - p->lo[d]);
    return p->side[2 * d] == DIRICHLET ? sin(phase) : cos(phase);
}

static double rate(const struct problem *p, int d, int m) {
    double q = m * M_PI / (p->hi[d] - p->lo[d]);
    return p->material[0].k[d] / p->material[0].rho_c * q * q;
}

static double rod(const struct problem *p, const double x[2]) {
    return 0.7 * wave(p, 0, 5, x[0]) - 0.4 * wave(p, 0, 2, x[0]);
}

static double rectangle(const struct problem *p, const double x[2]) {
    return 0.7 * wave(p, 0, 5, x[0]) * wave(p, 1, 3, x[1]) - 0.4 * wave(p, 0, 2, x[0]) * wave(p, 1, 4, x[1]);
}

static void modes_decay_at_their_rates(void **state) {
    (void)state;
    static const int n[2] = {24, 16};
    const double x[2] = {0.37, 0.83}, t = 2.385;
    for (int kinds = 0; kinds < 4; kinds++) {
        struct problem p = box(2, kinds & 1 ? NEUMANN : DIRICHLET, kinds & 2 ? NEUMANN : DIRICHLET);
        struct spectral *s = spectral_alloc(&p, n, rectangle);
        struct exact e = spectral_at(s, x, t), start = spectral_at(s, x, 0);
        double want =
            0.7 * wave(&p, 0, 5, x[0]) * wave(&p, 1, 3, x[1]) * exp(-(rate(&p, 0, 5) + rate(&p, 1, 3)) * t) -
            0.4 * wave(&p, 0, 2, x[0]) * wave(&p, 1, 4, x[1]) * exp(-(rate(&p, 0, 2) + rate(&p, 1, 4)) * t);
        assert_near(e.temperature, want, e.error_bound);
        assert_near(start.temperature, rectangle(&p, x), start.error_bound);
        assert_order(e.error_bound, <, 1e-12);
        spectral_free(s);

        struct problem line = box(1, p.side[X_LO], NEUMANN);
        s = spectral_alloc(&line, n, rod);
        e = spectral_at(s, x, t);
        want = 0.7 * wave(&line, 0, 5, x[0]) * exp(-rate(&line, 0, 5) * t) -
               0.4 * wave(&line, 0, 2, x[0]) * exp(-rate(&line, 0, 2) * t);
        assert_near(e.temperature, want, e.error_bound);
        assert_order(e.error_bound, <, 1e-12);
        spectral_free(s);
    }
}

static double brick(const struct problem *p, const double *x) {
    return rectangle(p, x) * wave(p, 2, 6, x[2]);
}

/* The third axis has sines or cosines of its own; its two sides must be of one kind. */
static void modes_of_a_box_decay_along_z_too(void **state) {
    (void)state;
    static const int n[3] = {24, 16, 20};
    const double x[3] = {0.37, 0.83, -0.23}, t = 2.385;
    for (int kind = 0; kind < 2; kind++) {
        struct problem p = box(3, NEUMANN, DIRICHLET), plane = box(2, NEUMANN, DIRICHLET);
        p.lo[2] = -0.7, p.hi[2] = 0.2, p.material[0].k[2] = 0.013;
        p.side[Z_LO] = p.side[Z_HI] = kind ? NEUMANN : DIRICHLET;
        struct spectral *s = spectral_alloc(&p, n, brick), *flat = spectral_alloc(&plane, n, rectangle);
        struct exact e = spectral_at(s, x, t), start = spectral_at(s, x, 0), f = spectral_at(flat, x, t);
        assert_near(start.temperature, brick(&p, x), start.error_bound);
        assert_near(e.temperature, f.temperature * wave(&p, 2, 6, x[2]) * exp(-rate(&p, 2, 6) * t),
                    e.error_bound + f.error_bound);
        assert_order(e.error_bound, <, 1e-12);
        spectral_free(s);
        spectral_free(flat);
        p.side[Z_LO] = kind ? DIRICHLET : NEUMANN;
        assert_null(spectral_alloc(&p, n, brick));
    }
}

/* The mode that alternates from sample to sample is weighted apart from the others. */
static double last_mode(const struct problem *p, const double x[2]) {
    return 1.3 * wave(p, 0, 8, x[0]) + 0.9;
}

static void end_modes_have_half_weight(void **state) {
    (void)state;
    static const int n[2] = {8, 1}, more[2] = {9, 1};
    struct problem p = box(1, DIRICHLET, DIRICHLET), q = box(1, NEUMANN, NEUMANN);
    const double x[2] = {0.37, 0};
    struct spectral *s = spectral_alloc(&q, more, last_mode);
    assert_near(spectral_at(s, x, 0).temperature, last_mode(&q, x), 1e-14);
    assert_near(spectral_at(s, x, 1e6).temperature, 0.9, 1e-14);
    spectral_free(s);
    s = spectral_alloc(&p, n, rod); /* modes 2 and 5 of 8 */
    assert_near(spectral_at(s, x, 0).temperature, rod(&p, x), 1e-14);
    assert_order(spectral_at(s, x, 0).error_bound, <, 1e-12);
    spectral_free(s);
}

/* A step is not resolved by modes: the bound must say so. */
static double step(const struct problem *p, const double x[2]) {
    (void)p;
    return x[0] > 0.123;
}

static void unresolved_data_have_a_large_error_bound(void **state) {
    (void)state;
    static const int n[2] = {64, 1};
    struct problem p = box(1, NEUMANN, NEUMANN);
    struct spectral *s = spectral_alloc(&p, n, step);
    assert_order(spectral_at(s, (double[2]){0.5, 0}, 1).error_bound, >, 0.01);
    spectral_free(s);
}

static void unequal_sides_and_two_materials_are_refused(void **state) {
    (void)state;
    static const int n[2] = {8, 8};
    struct problem p = box(2, DIRICHLET, NEUMANN), q = p, r = p;
    p.side[X_HI] = NEUMANN;
    q.side[Y_LO] = DIRICHLET;
    r.materials = 2;
    assert_null(spectral_alloc(&p, n, rod));
    assert_null(spectral_alloc(&q, n, rod));
    assert_null(spectral_alloc(&r, n, rod));
    spectral_free(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(modes_decay_at_their_rates),
        cmocka_unit_test(modes_of_a_box_decay_along_z_too),
        cmocka_unit_test(end_modes_have_half_weight),
        cmocka_unit_test(unresolved_data_have_a_large_error_bound),
        cmocka_unit_test(unequal_sides_and_two_materials_are_refused),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("spectral", tests, NULL, NULL);
}
