/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Averages of initial data in closed form: moments of the B-splines, jumps, and data beyond the walls.  Both
 * implementations, that of the particles and that of the finite differences, must give the same numbers. */
#include "solver/method.h"

#include "solver/differences/ftcs.h"
#include "solver/space/sample.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

extern const struct method method_so_ssph;

static const double dx[2] = {0.13, 0.07};

/* B-spline averages of order m = 1, 4: m dx^2/12 is their variance. */
static void both(const struct problem *p, enum sampling sampling, double x, double y, double want, double tolerance) {
    const double at[2] = {x, y};
    assert_near(sample_initial(p, sampling, dx, at), want, tolerance);
    assert_near(ftcs_sample(p, at, dx, sampling), want, tolerance);
}

static double still(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 0;
}

static double cold(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

static double parabolas(const struct problem *p, const double x[2]) {
    (void)p;
    return 1.7 + 0.9 * x[0] - 2.3 * x[0] * x[0] + 3.1 * x[1] * x[1];
}

static void averages_have_spline_moments(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    p.initial = parabolas;
    const double at[2] = {0.41, 0.83}, here = parabolas(&p, at);
    for (int m = 1; m <= 4; m += 3)
        both(&p, m == 1 ? SAMPLING_CELL : SAMPLING_SPLINE, at[0], at[1],
             here + m / 12.0 * (-2.3 * dx[0] * dx[0] + 3.1 * dx[1] * dx[1]), 1e-14);
    both(&p, SAMPLING_POINT, at[0], at[1], here, 0);
}

static double hot_right(const struct problem *p, const double x[2]) {
    return x[0] >= p->jump[0][0] ? 1.9 : 0.3;
}

/* The integral of the cubic B-spline from -2 to u. */
static double spline_below(double u) {
    double v = 2 - fabs(u), tail = v * v * v * v / 24;
    if (fabs(u) < 1) tail = 0.5 - fabs(u) * (2.0 / 3 - u * u / 3 + fabs(u * u * u) / 8);
    return u < 0 ? tail : 1 - tail;
}

static void averages_split_at_jumps(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    p.initial = hot_right;
    p.jumps[0] = 1, p.jump[0][0] = 0.4;
    for (double u = -1.9; u < 2; u += 0.317) { /* the jump is u dx to the right of the point */
        double below = fmin(1, fmax(0, 0.5 + u));
        both(&p, SAMPLING_CELL, 0.4 - u * dx[0], 0.83, 1.9 - 1.6 * below, 1e-14);
        both(&p, SAMPLING_SPLINE, 0.4 - u * dx[0], 0.83, 1.9 - 1.6 * spline_below(u), 1e-14);
    }
}

/* A jump so near to a wall that its image is averaged too: beyond the wall T = 2 T_wall - T(image). */
static void averages_split_at_images_of_jumps(void **state) {
    (void)state;
    struct problem p = odd_rectangle(); /* 0.8 K at x = 1.15 m */
    const double x = 1.15 - 0.5 * dx[0];
    p.initial = hot_right;
    p.jumps[0] = 1, p.jump[0][0] = 1.15 - 0.2 * dx[0];
    double cold = spline_below(0.3), hot = spline_below(0.5) - cold;
    double hot_image = spline_below(0.7) - spline_below(0.5), cold_image = 1 - spline_below(0.7);
    double want = 0.3 * cold + 1.9 * hot + (1.6 - 1.9) * hot_image + (1.6 - 0.3) * cold_image;
    both(&p, SAMPLING_SPLINE, x, 0.83, want, 1e-14);
}

static double plane(const struct problem *p, const double x[2]) {
    (void)p;
    return 0.3 + 0.5 / 1.5 * (x[0] + 0.35); /* 0.3 and 0.8 K on the walls: odd beyond them */
}

static double slope(const struct problem *p, const double x[2]) {
    return 0.2 - 0.11 / p->material[0].k[1] * (x[1] - p->lo[1]); /* the flux of 0.11 W m^-2 through y = 0.2 m */
}

static void walls_continue_the_data(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    p.initial = plane;
    const double left[2] = {-0.35 + 0.3 * dx[0], 0.83}, right[2] = {1.15 - 0.2 * dx[0], 0.83};
    both(&p, SAMPLING_SPLINE, left[0], left[1], plane(&p, left), 1e-15);
    both(&p, SAMPLING_SPLINE, right[0], right[1], plane(&p, right), 1e-15);
    p.initial = slope;
    const double low[2] = {0.41, 0.2 + 0.3 * dx[1]};
    both(&p, SAMPLING_SPLINE, low[0], low[1], slope(&p, low), 1e-15);
}

static double met(const struct problem *p, const double x[2]) {
    double wall = p->wall(p, X_HI, NULL, 0), slope = p->robin[X_HI] * (wall - 1.4) / p->material[1].k[0];
    return 1.4 + slope * (x[0] - p->hi[0]);
}

/* Linear data that meet k dT/dn = b (wall - T) go on beyond the wall as they are: k is that of the second material.
 */
static void a_cooled_wall_of_two_materials_continues_the_data(void **state) {
    (void)state;
    struct problem p = odd_rod();
    p.materials = 2, p.interface = 0.4;
    p.material[1] = (struct material){{0.0311, 0.19}, 0.9};
    p.side[X_HI] = ROBIN, p.robin[X_HI] = 0.27;
    p.initial = met;
    const double at[2] = {1.15 - 0.2 * dx[0], 0};
    both(&p, SAMPLING_CELL, at[0], 0, met(&p, at), 1e-14);
    both(&p, SAMPLING_SPLINE, at[0], 0, met(&p, at), 1e-14);
}

/* A parabola between two jumps, cold outside. */
static double hump(const struct problem *p, const double x[2]) {
    double inside = x[0] >= p->jump[0][0] && x[0] <= p->jump[0][1];
    return inside * (1.9 - 2.3 * x[0] + 3.1 * x[0] * x[0]);
}

static double power_sum(const double c[3], int k, double x) { /* the integral of x^k (c_0 + c_1 x + c_2 x^2) */
    double sum = 0;
    for (int m = 0; m < 3; m++) sum += c[m] * pow(x, m + k + 1) / (m + k + 1);
    return sum;
}

/* Whatever the quadrature misses at the jumps, heat and its place are kept. */
static void averages_keep_heat_and_centre(void **state) {
    (void)state;
    const double c[3] = {1.9, -2.3, 3.1};
    struct problem p = {
        .dim = 1, .hi = {1.5, 0}, .initial = hump, .wall = cold, .jumps = {2}, .jump = {{0.31, 0.77}}};
    for (int n = 40; n < 50; n++) {
        struct lattice l = {.dim = 1, .n = {n, 1, 1}, .dx = {1.5 / n, 1, 1}, .first = {0.75 / n}};
        double T[50], sum[2] = {0, 0};
        sample_lattice(&p, SAMPLING_SPLINE, &l, T);
        for (int i = 0; i < n; i++)
            for (int k = 0; k < 2; k++) sum[k] += pow(l.first[0] + i * l.dx[0], k) * T[i] * l.dx[0];
        for (int k = 0; k < 2; k++) assert_near(sum[k], power_sum(c, k, 0.77) - power_sum(c, k, 0.31), 1e-14);
    }
}

/* Neighbours share nodes: as if each were sampled on its own, with jumps on either side of a knot and beside walls.
 */
static void lattice_samples_equal_single_samples(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    p.initial = hot_right;
    p.jumps[0] = 2, p.jump[0][0] = 0.4, p.jump[0][1] = 1.07;
    p.jumps[1] = 1, p.jump[1][0] = 0.77;
    struct lattice l = {.dim = 2, .n = {11, 13, 1}, .dx = {0.13, 0.07, 1}, .first = {-0.28, 0.24}};
    double T[11 * 13];
    for (int sampling = SAMPLING_POINT; sampling <= SAMPLING_SPLINE; sampling++) {
        sample_lattice(&p, (enum sampling)sampling, &l, T);
        for (int k = 0; k < l.n[0] * l.n[1]; k++) {
            double at[DIM_MAX];
            layout_position(&l, k % l.n[0], k / l.n[0], 0, at);
            assert_near(sample_initial(&p, (enum sampling)sampling, l.dx, at), T[k], 2e-15);
        }
    }
}

static double held_near(const struct problem *p, enum side s, const double x[2], double t) {
    (void)s, (void)x, (void)t;
    return p->param[1];
}

static double even(const struct problem *p, const double x[2]) {
    (void)x;
    return p->param[0];
}

/* To 1e-9 of the temperatures, whatever these are. */
static void round_off_at_a_wall_is_not_a_jump(void **state) {
    (void)state;
    struct problem p = {.dim = 1, .hi = {1, 0}, .initial = even, .wall = held_near};
    struct lattice l = {.dim = 1, .n = {10, 1, 1}, .dx = {0.1, 1, 1}, .first = {0.05, 0}};
    for (double T = 1e-6; T < 1e7; T *= 1e3) {
        p.param[0] = T, p.param[1] = T * (1 + 1e-9);
        assert_int_equal(sample_meets_wall(&p, &l, X_LO), 1);
        p.param[1] = T * (1 + 3e-9);
        assert_int_equal(sample_meets_wall(&p, &l, X_LO), 0);
    }
}

static double warm_patch(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)t;
    return x[1] > 0.7 && x[1] < 0.9;
}

/* A wall meets the data where it does so beside each particle. */
static void wall_agreement_is_checked_along_the_wall(void **state) {
    (void)state;
    struct problem p = {.dim = 2, .hi = {1, 1}, .initial = still, .wall = warm_patch};
    struct lattice l = {.dim = 2, .n = {10, 10, 1}, .dx = {0.1, 0.1, 1}, .first = {0.05, 0.05}};
    assert_int_equal(sample_meets_wall(&p, &l, X_HI), 0);
    l.n[1] = 7; /* below the patch */
    assert_int_equal(sample_meets_wall(&p, &l, X_HI), 1);
}

static double oblique(const struct problem *p, const double x[2]) {
    return 1 + 0.7 * cos(2 * M_PI * (x[0] / p->hi[0] + 2 * x[1] / p->hi[1]) + 0.3);
}

/* A wave is an eigenfunction of every average that does not see where the period begins. */
static void periodic_sides_have_no_wall_images(void **state) {
    (void)state;
    struct problem p = {.dim = 2, .hi = {1.3, 0.9}, .materials = 1, .initial = oblique, .wall = cold};
    for (int s = 0; s < 4; s++) p.side[s] = PERIODIC;
    p.material[0] = (struct material){{1, 1}, 1};
    const double middle[2] = {0.61, 0.47}, edge[][2] = {{0.02, 0.47}, {1.27, 0.41}, {0.6, 0.01}, {1.29, 0.88}};
    for (int how = SAMPLING_CELL; how <= SAMPLING_SPLINE; how++)
        for (int i = 0; i < 4; i++) {
            double share = (sample_initial(&p, (enum sampling)how, dx, middle) - 1) / (oblique(&p, middle) - 1);
            both(&p, (enum sampling)how, edge[i][0], edge[i][1], 1 + share * (oblique(&p, edge[i]) - 1), 2e-3);
        }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(averages_have_spline_moments),
        cmocka_unit_test(periodic_sides_have_no_wall_images),
        cmocka_unit_test(averages_split_at_jumps),
        cmocka_unit_test(averages_split_at_images_of_jumps),
        cmocka_unit_test(walls_continue_the_data),
        cmocka_unit_test(a_cooled_wall_of_two_materials_continues_the_data),
        cmocka_unit_test(lattice_samples_equal_single_samples),
        cmocka_unit_test(averages_keep_heat_and_centre),
        cmocka_unit_test(wall_agreement_is_checked_along_the_wall),
        cmocka_unit_test(round_off_at_a_wall_is_not_a_jump),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
