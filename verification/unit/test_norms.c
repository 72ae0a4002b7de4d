/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Norms, ranges and the checkerboard, on fields with known results. */
#include "verification/judge/norms.h"

#include "references/scene.h"
#include "solver/method.h"
#include "solver/problem.h"

#include "verification/unit/near.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

static double wall_of_side(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)x, (void)t;
    return s == X_LO ? -0.25 : 3.5;
}

static struct problem rod(void) {
    return (struct problem){.dim = 1, .lo = {-0.3}, .hi = {2.1}, .wall = wall_of_side};
}

static struct field points(const struct problem *p, int nx, int ny) {
    struct field f;
    field_alloc_lattice(&f, p->dim, (const int[]){nx, ny, 1}, NULL);
    for (int a = 0; a < p->dim; a++) f.spacing[a] = (p->hi[a] - p->lo[a]) / f.shape[a];
    for (int a = 0; a < p->dim; a++)
        for (int i = 0; i < f.shape[a]; i++) f.x[a][i] = p->lo[a] + (i + 0.5) * f.spacing[a];
    return f;
}

static void norms_equal_hand_calculation(void **state) {
    (void)state;
    struct problem p = rod();
    struct field f = points(&p, 4, 1);
    double exact[4] = {1, -2, 3, 0.5};
    const double T[4] = {1.5, -2, 2.75, 1.5};
    for (int i = 0; i < 4; i++) f.T[i] = T[i];
    double e[NORM_QUANTITY];
    norms_all(&f, exact, NULL, e);
    assert_near(e[NORM_L1], 1.75 / 6.5, DBL_EPSILON); /* |Te| in the denominator: Te may change sign */
    assert_near(e[NORM_L2], sqrt((0.25 + 0.0625 + 1) / (1 + 4 + 9 + 0.25)), DBL_EPSILON);
    assert_near(e[NORM_LINF], 1, 0);
    field_free(&f);
}

/* In units of 2^-700 and of 2^900, whose squares underflow or overflow; and for errors alone, of 2^-700. */
static void norms_are_dimensionless(void **state) {
    (void)state;
    struct problem p = rod();
    struct field f = points(&p, 4, 1);
    const double exact[4] = {1, -2, 3, 0.5}, error[4] = {0.5, 0, -0.25, 1}, small = 0x1p-700;
    double of_one = 0;
    for (int k = 0; k < 4; k++) {
        double unit = k == 1 ? small : k == 2 ? 0x1p900 : 1, in[4], part = k == 3 ? small : 1;
        for (int i = 0; i < 4; i++) in[i] = (k == 3 ? 0 : unit * exact[i]), f.T[i] = in[i] + part * unit * error[i];
        if (k == 3) in[0] = 1, f.T[0] = 1;
        double l2 = norms_l2(&f, in, NULL);
        if (k == 0) of_one = l2;
        assert_near(l2 / (k == 3 ? small * sqrt(0.0625 + 1) : of_one), 1, k == 3 ? 2 * DBL_EPSILON : 0);
    }
    field_free(&f);
}

/* The plate's corners, on nodes: four of twelve points have no value, and no error there is seen. */
static void points_without_a_value_are_left_out_and_counted(void **state) {
    (void)state;
    const struct scene *s = scene_find("plate");
    struct problem p;
    struct failure why = {0};
    double exact[12];
    scene_defaults(s, &p);
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    struct field f = points(&p, 4, 3);
    for (int i = 0; i < 4; i++) f.x[0][i] = p.hi[0] * i / 3;
    for (int i = 0; i < 3; i++) f.x[1][i] = p.hi[1] * i / 2;
    f.time = p.t_end;
    double bound = norms_exact(s, &p, &f, exact);
    for (int i = 0; i < 12; i++) f.T[i] = exact[i] == NORMS_NO_VALUE ? 17 : exact[i] + 0.013;
    double e[NORM_QUANTITY];
    norms_all(&f, exact, NULL, e);
    assert_order(bound, <, 1e-12);
    assert_int_equal(norms_left_out(&f, exact), 4);
    assert_near(e[NORM_LINF], 0.013, 1e-15);
    /* An offset that every point has is the norm itself; a norm over the temperatures is smaller. */
    for (int k = 0; k < NORM_QUANTITY; k++)
        if (k != NORM_INTERIOR && k != NORM_BOUNDARY && !(e[k] > 1e-4)) fail_msg("norm %d is %g", k, e[k]);
    assert_int_equal(norms_check(&f, exact, &why), STATUS_OK);
    exact[5] = NAN; /* a NaN is not a corner */
    norms_all(&f, exact, NULL, e);
    for (int k = 0; k < NORM_QUANTITY; k++)
        if (!isnan(e[k])) fail_msg("norm %d is %g beside a NaN", k, e[k]);
    for (int i = 0; i < 12; i++) exact[i] = NORMS_NO_VALUE;
    assert_int_equal(norms_check(&f, exact, &why), STATUS_INPUT);
    assert_has(why.text, "no value at any of the points (12");
    field_free(&f);
}

/* sum(w |e|^p), not sum(|w e|^p): a uniform weight must not be seen. */
static void weights_multiply_the_power(void **state) {
    (void)state;
    struct problem p = rod();
    struct field f = points(&p, 3, 1);
    const double exact[3] = {2, 2, 2};
    f.T[0] = 2.5, f.T[1] = 2, f.T[2] = 1;
    double even[NORM_QUANTITY];
    norms_all(&f, exact, NULL, even);
    f.weight = xcalloc(3, sizeof *f.weight);
    for (int i = 0; i < 3; i++) f.weight[i] = 0.037;
    double scaled[NORM_QUANTITY];
    norms_all(&f, exact, NULL, scaled);
    assert_near(scaled[NORM_L1], even[NORM_L1], DBL_EPSILON);
    assert_near(scaled[NORM_L2], even[NORM_L2], DBL_EPSILON);
    f.weight[0] = 0.5, f.weight[1] = 1, f.weight[2] = 0.25;
    double uneven[NORM_QUANTITY];
    norms_all(&f, exact, NULL, uneven);
    assert_near(uneven[NORM_L1], (0.5 * 0.5 + 0.25 * 1) / 3.5, DBL_EPSILON);
    assert_near(uneven[NORM_L2], sqrt((0.5 * 0.25 + 0.25) / (4 * 1.75)), DBL_EPSILON);
    field_free(&f);
}

static void interior_and_boundary_partition_the_points(void **state) {
    (void)state;
    struct problem p = {.dim = 2, .lo = {0, -1}, .hi = {2, 1}, .wall = wall_of_side};
    struct field f = points(&p, 8, 8); /* spacing 0.25: outermost points 0.125 from a wall */
    double exact[64];
    for (int i = 0; i < 64; i++) {
        int edge = i % 8 == 0 || i % 8 == 7 || i < 8 || i >= 56;
        exact[i] = 1;
        f.T[i] = edge ? 1.3 : 1.07;
    }
    unsigned char *near = norms_near(&p, &f, 0.2), *all = norms_near(&p, &f, 5);
    double e[NORM_QUANTITY];
    norms_all(&f, exact, near, e);
    assert_near(e[NORM_INTERIOR], 0.07, 1e-15);
    assert_near(e[NORM_BOUNDARY], 0.3, 1e-15);
    assert_near(e[NORM_LINF], 0.3, 1e-15);
    assert_near(e[NORM_L1], (36 * 0.07 + 28 * 0.3) / 64, 1e-15);
    assert_nan(norms_interior(&f, exact, all)); /* no points: no number */
    assert_nan(norms_interior(&f, exact, NULL));
    free(near);
    free(all);
    field_free(&f);
}

static void nan_propagates_to_every_norm(void **state) {
    (void)state;
    struct problem p = rod();
    for (int at = 0; at < 5; at++) {
        struct field f = points(&p, 5, 1);
        double exact[5] = {1, 1, 1, 1, 1};
        f.T[at] = NAN;
        double e[NORM_QUANTITY];
        norms_all(&f, exact, NULL, e);
        struct norms_shape s = norms_shape(&p, &f, exact);
        assert_nan(e[NORM_L1]);
        assert_nan(e[NORM_L2]);
        assert_nan(e[NORM_LINF]);
        assert_nan(s.min);
        assert_nan(s.max);
        assert_nan(s.overshoot);
        assert_nan(s.undershoot);
        assert_nan(s.variation);
        assert_nan(s.checkerboard);
        field_free(&f);
    }
}

static void overshoot_counts_the_walls(void **state) {
    (void)state;
    struct problem p = rod();
    struct field f = points(&p, 4, 1);
    double exact[4] = {0};
    const double T[4] = {-0.2, 3.6, 1, -0.31};
    for (int i = 0; i < 4; i++) f.T[i] = T[i];
    f.range[0] = 0, f.range[1] = 3;
    struct norms_shape s = norms_shape(&p, &f, exact);
    assert_near(s.min, -0.31, 0);
    assert_near(s.max, 3.6, 0);
    assert_near(s.overshoot, 0.1, 1e-15);   /* past the wall at 3.5, not past the data at 3 */
    assert_near(s.undershoot, 0.06, 1e-15); /* past the wall at -0.25 */
    assert_near(s.variation, 3.8 + 2.6 + 1.31, 1e-14);
    p.side[X_LO] = p.side[X_HI] = NEUMANN; /* a flux is no temperature */
    s = norms_shape(&p, &f, exact);
    assert_near(s.overshoot, 0.6, 1e-15);
    assert_near(s.undershoot, 0.31, 1e-15);
    p.side[X_HI] = ROBIN; /* the air at 3.5 */
    s = norms_shape(&p, &f, exact);
    assert_near(s.overshoot, 0.1, 1e-15);
    assert_near(s.undershoot, 0.31, 1e-15);
    field_free(&f);
}

/* Rows of 1 4, 2 2 and 7 -2 K: 3 + 0 + 9 along x, over 0.2 m; 1 + 5 and 2 + 4 along y, over 0.7 m.  With 0 in place
 * of 4 it is 1 + 0 + 9 and 1 + 5, 2 + 4. */
static void variation_in_the_plane_is_over_the_other_spacing(void **state) {
    (void)state;
    struct problem p = {.dim = 2, .lo = {0, -1}, .hi = {1.4, -0.4}, .wall = wall_of_side};
    struct field f = points(&p, 2, 3);
    double exact[6] = {0};
    const double T[6] = {1, 4, 2, 2, 7, -2};
    for (int i = 0; i < 6; i++) f.T[i] = T[i];
    assert_near(norms_shape(&p, &f, exact).variation, 12 * 0.2 + 12 * 0.7, 1e-14);
    f.T[1] = 0;
    assert_near(norms_shape(&p, &f, exact).variation, 10 * 0.2 + 12 * 0.7, 1e-14);
    field_free(&f);
}

static double wall_along_x(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)t;
    return s == Y_HI ? 2 + x[0] : 1;
}

/* A Dirichlet wall of 2 K with 1 K/m along it: 3.05 K at the foot of the last point. */
static void overshoot_counts_the_warmest_place_of_a_wall(void **state) {
    (void)state;
    struct problem p = {.dim = 2, .hi = {1.4, 0.6}, .wall = wall_along_x};
    struct field f = points(&p, 2, 3);
    double exact[6] = {0};
    for (int i = 0; i < 6; i++) f.T[i] = 1.5;
    f.T[1] = 3.25, f.T[2] = 0.75;
    f.range[0] = 1, f.range[1] = 2;
    struct norms_shape s = norms_shape(&p, &f, exact);
    assert_near(s.overshoot, 0.2, 1e-14);
    assert_near(s.undershoot, 0.25, 1e-14);
    field_free(&f);
}

/* T is 1 % off: neither sum is representable where T is near the largest number, or near the smallest. */
static void sums_do_not_overflow(void **state) {
    (void)state;
    enum { N = 7 };
    static const double scale[] = {1.5e308, 1, 3e-307};
    for (int k = 0; k < 3; k++) {
        double T[N], exact[N], w[N];
        for (int i = 0; i < N; i++) exact[i] = scale[k] * (i + 1) / N, T[i] = 0.99 * exact[i], w[i] = 1 + 0.1 * i;
        struct field f = {.dim = 1, .n = N, .T = T, .weight = w};
        double e[NORM_QUANTITY];
        norms_all(&f, exact, NULL, e);
        assert_near(e[NORM_L1], 0.01, 1e-12);
        assert_near(e[NORM_L2], 0.01, 1e-12);
    }
}

static void heat_drifts_relative_to_its_size(void **state) {
    (void)state;
    struct field f = {.heat = {-2, -1.5}};
    assert_near(norms_heat_drift(&f), 0.25, 0);
}

/* Every mode of every pair of walls, of amplitude 0.83: found with that amplitude in the upper half of the band, and
 * not at all in the lower half. */
static void checkerboard_amplitude_of_a_pure_mode(void **state) {
    (void)state;
    const double pi = M_PI;
    for (int n = 2; n <= 8; n++)
        for (int sides = 0; sides < 4; sides++)
            for (int k = 0; k < n; k++) {
                struct problem p = rod();
                p.side[X_LO] = sides & 1 ? NEUMANN : DIRICHLET;
                p.side[X_HI] = sides & 2 ? NEUMANN : DIRICHLET;
                struct field f = points(&p, n, 1);
                double exact[8], waves = k + (sides == 0 ? 1 : sides == 3 ? 0 : 0.5);
                for (int i = 0; i < n; i++) {
                    double phase = pi * waves * (i + 0.5) / n;
                    exact[i] = 5 + i;
                    f.T[i] = exact[i] + 0.83 * (sides & 1 ? cos(phase) : sin(phase));
                }
                assert_near(norms_checkerboard(&p, &f, exact), 2 * waves >= n ? 0.83 : 0, 1e-14);
                field_free(&f);
            }
}

static void checkerboard_amplitude_in_the_plane(void **state) {
    (void)state;
    const double pi = M_PI;
    struct problem p = {.dim = 2, .lo = {0, -1}, .hi = {1.4, 1}, .wall = wall_of_side};
    p.side[Y_LO] = p.side[Y_HI] = NEUMANN;
    struct field f = points(&p, 7, 10);
    double exact[70] = {0};
    for (int i = 0; i < 70; i++) f.T[i] = -0.41 * sin(pi * 2 * (i % 7 + 0.5) / 7) * cos(pi * 9 * (i / 7 + 0.5) / 10);
    assert_near(norms_checkerboard(&p, &f, exact), 0.41, 1e-14); /* short along y alone */
    static const int too_few[][DIM_MAX] = {{0, 0, 0}, {70, 1, 1}, {1, 70, 1}};
    for (int k = 0; k < 3; k++) {
        memcpy(f.shape, too_few[k], sizeof f.shape);
        assert_nan(norms_checkerboard(&p, &f, exact));
    }
    field_free(&f);
}

/* Points on the lattice that the walls are on. */
static void checkerboard_amplitude_on_nodes(void **state) {
    (void)state;
    const double pi = M_PI;
    struct problem p = {.dim = 1, .lo = {0}, .hi = {2}, .wall = wall_of_side};
    struct field inner = points(&p, 9, 1);
    double exact[11] = {0};
    inner.spacing[0] = 0.2;
    for (int i = 0; i < 9; i++) {
        inner.x[0][i] = 0.2 * (i + 1);
        inner.T[i] = 0.6 * sin(pi * 7 * (i + 1) / 10);
    }
    assert_near(norms_checkerboard(&p, &inner, exact), 0.6, 1e-14);
    field_free(&inner);
    memset(exact, 0, sizeof exact);
    p.side[X_LO] = p.side[X_HI] = NEUMANN;
    struct field all = points(&p, 11, 1);
    all.spacing[0] = 0.2;
    for (int i = 0; i < 11; i++) {
        all.x[0][i] = 0.2 * i;
        all.T[i] = 0.6 * cos(pi * 10 * i / 10);
    }
    assert_near(norms_checkerboard(&p, &all, exact), 0.6, 1e-14);
    field_free(&all);
}

static void nan_is_the_largest_distance(void **state) {
    (void)state;
    double T[4] = {1, 2.5, -3, 0.1}, other[4] = {1.25, 2.5, -1.3, 0.7};
    const struct field f = {.dim = 1, .n = 4, .T = T};
    assert_near(field_farthest(&f, other), 1.7, 1e-15);
    for (int i = 0; i < 4; i++) {
        double one = other[i];
        other[i] = NAN;
        assert_nan(field_farthest(&f, other));
        other[i] = one;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nan_is_the_largest_distance),
        cmocka_unit_test(norms_equal_hand_calculation),
        cmocka_unit_test(norms_are_dimensionless),
        cmocka_unit_test(points_without_a_value_are_left_out_and_counted),
        cmocka_unit_test(weights_multiply_the_power),
        cmocka_unit_test(interior_and_boundary_partition_the_points),
        cmocka_unit_test(nan_propagates_to_every_norm),
        cmocka_unit_test(overshoot_counts_the_walls),
        cmocka_unit_test(overshoot_counts_the_warmest_place_of_a_wall),
        cmocka_unit_test(variation_in_the_plane_is_over_the_other_spacing),
        cmocka_unit_test(sums_do_not_overflow),
        cmocka_unit_test(heat_drifts_relative_to_its_size),
        cmocka_unit_test(checkerboard_amplitude_of_a_pure_mode),
        cmocka_unit_test(checkerboard_amplitude_in_the_plane),
        cmocka_unit_test(checkerboard_amplitude_on_nodes),
    };
    return cmocka_run_group_tests_name("norms", tests, NULL, NULL);
}
