/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cooled ends: no root is missed and each is good to the last bit, half lines and modes are what they say, and the
 * scenes have the limits of an insulated and of a held end. */
#include "references/cooling.h"

#include "references/cooled_plate.h"
#include "references/roots.h"
#include "verification/unit/odd_scenes.h"

#include <float.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <stdlib.h>

/* z cot z = -biot and z tan z = biot by bisection in 40 digits. */
static void roots_are_known(void **state) {
    (void)state;
    static const struct {
        int n, insulated;
        double biot, z;
    } known[] = {
        {1, 0, 0.37, 1.776172342176420698232},      {1, 1, 0.37, 0.5732025235114154397751},
        {3, 0, 14.423, 8.873246010034986667007},    {3, 1, 14.423, 7.380977853508463440951},
        {1, 1, 1e-12, 9.999999999998333232767e-7},  {1, 0, 1e-12, 1.570796326795533239004},
        {2, 1, 3.1e-09, 3.141592654576553885322},   {7, 0, 2500000.0, 21.99113977867264142706},
        {7, 1, 2500000.0, 20.42034408019602415325}, {400, 0, 0.001, 1255.066265905893077068},
        {400, 1, 911.0, 1254.12369639422967525},    {1, 1, 1e+18, 1.570796326794896617661},
        {2, 0, 1e+18, 6.283185307179586470642},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double z = roots_cooled(known[i].n, known[i].insulated, known[i].biot);
        assert_near(z, known[i].z, 2 * DBL_EPSILON * known[i].z);
    }
}

/* One root between neighbouring multiples of pi/2, for any biot: each obeys its equation to rounding. */
static void no_root_is_missed(void **state) {
    (void)state;
    for (double biot = 1e-20; biot < 1e21; biot *= 7.3)
        for (int insulated = 0; insulated < 2; insulated++)
            for (int n = 1; n <= 60; n++) {
                double z = roots_cooled(n, insulated, biot), hi = (n - insulated * 0.5) * M_PI, size = hypot(z, biot);
                assert_order(z, >=, (hi - M_PI / 2) * (1 - 2 * DBL_EPSILON));
                assert_order(z, <=, hi * (1 + DBL_EPSILON));
                double residual = insulated ? z * sin(z) - biot * cos(z) : z * cos(z) + biot * sin(z);
                assert_near(residual / size, 0, 4 * DBL_EPSILON * (z + z / size));
            }
    for (int n = 1; n < 9; n++) {
        assert_near(roots_cooled(n, 0, 0), (n - 0.5) * M_PI, DBL_EPSILON * n);
        assert_near(roots_cooled(n, 0, INFINITY), n * M_PI, 0);
        assert_near(roots_cooled(n, 1, 0), (n - 1) * M_PI, 0);
        assert_near(roots_cooled(n, 1, INFINITY), (n - 0.5) * M_PI, DBL_EPSILON * n);
    }
}

/* Integrals of a mode by Simpson's rule: error below 2e-11 for the first four. */
static void modes_have_their_integrals(void **state) {
    (void)state;
    const double L = 0.37;
    static const double h[] = {0, 1e-9, 0.83, 17, 4e5};
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 8; k++) {
            enum { N = 2000 };
            int insulated = k % 2;
            struct cooling_mode m = cooling_mode(k / 2 + 1, insulated, L, h[i]);
            double integral = 0, norm = 0;
            for (int j = 0; j <= N; j++) {
                double w = L / N / 3 * (j == 0 || j == N ? 1 : j % 2 ? 4 : 2), phase = m.q * L * j / N;
                double value = insulated ? cos(phase) : sin(phase);
                integral += w * value;
                norm += w * value * value;
            }
            assert_near(m.integral, integral, 1e-11);
            assert_near(m.norm, norm, 1e-11);
            assert_near(m.end_cosine, cos(m.q * L), 1e-14);
        }
}

/* At the end the flux is that of the air; both slopes are those of differences; far from the end nothing has changed;
 * for h to infinity the end is held. */
static void half_lines_cool(void **state) {
    (void)state;
    for (double h = 0.01; h < 1e4; h *= 13)
        for (double s = 0.003; s < 30; s *= 4.7) {
            struct cooling_half end = cooling_half(0, h, s);
            assert_near(end.slope, h * end.T, 4 * DBL_EPSILON * h);
            assert_near(cooling_half(6.3 * s, h, s).T, 1, 1e-15);
            for (double d = 0.1 * s; d < 4 * s; d += 0.7 * s) {
                double e = 1e-3 * s;
                double by_d = (8 * (cooling_half(d + e, h, s).T - cooling_half(d - e, h, s).T) -
                               (cooling_half(d + 2 * e, h, s).T - cooling_half(d - 2 * e, h, s).T)) /
                              (12 * e);
                double by_s = (8 * (cooling_half(d, h, s + e).T - cooling_half(d, h, s - e).T) -
                               (cooling_half(d, h, s + 2 * e).T - cooling_half(d, h, s - 2 * e).T)) /
                              (12 * e);
                assert_near(cooling_half(d, h, s).slope, by_d, 2e-11 / s);
                assert_near(cooling_half(d, h, s).change, by_s, 2e-11 / s);
            }
        }
    assert_near(cooling_half(0.2, 1e17, 0.3).T, erf(0.2 / 0.3), 1e-15);
    for (double y = 4.9; y < 25; y += 0.07) /* exp(y^2) erfc(y) by either way; exp rounds y^2 */
        assert_near(cooling_half(0, 2 * y, 1).end, exp(y * y) * erfc(y), 4e-16 * y * y * exp(y * y) * erfc(y));
    assert_near(cooling_half(0.2, 0, 0.3).T, 1, 0);
}

static const struct scene *scene_at(const char *name, const double *param, struct problem *p) {
    struct failure why = {0};
    const struct scene *s = scene_find(name);
    scene_defaults(s, p);
    for (int i = 0; s->params[i].name; i++) p->param[i] = param[i];
    if (s->setup(p, &why)) fail_msg("%s", why.text);
    return s;
}

static const double times[] = {0.03, 1.1, 17, 130, 700, 2900, 31000, 4e5, 1e9};
enum { TIMES = sizeof times / sizeof *times };

/* b = 0: the half of a rod twice as long between two held ends.  b = 1e19: both ends held. */
static void rod_limits(void **state) {
    (void)state;
    double v[PARAM_MAX] = {0.37, 41, 2.9e6, 31, 97, 0, 7, 450}, L = v[0];
    for (int i = 0; i < TIMES; i++)
        for (double x = 0; x <= L; x += L / 17) {
            struct problem p;
            double s = sqrt(4 * v[1] / v[2] * times[i]);
            v[5] = 0, v[6] = 7;
            const struct scene *rod = scene_at("rod-cooling", v, &p);
            struct exact e = scene_exact(rod, &p, (double[2]){x, 0}, times[i]);
            struct curve u = series_box(x - L, L, L, s);
            assert_near(e.temperature, 31 + 66 * u.at.value, e.error_bound + 66 * u.at.error);
            assert_near(e.gradient[0], 66 * u.slope.value, e.gradient_bound[0] + 66 * u.slope.error);
            v[5] = 1e19, v[6] = 31;
            rod = scene_at("rod-cooling", v, &p);
            e = scene_exact(rod, &p, (double[2]){x, 0}, times[i]);
            u = series_box(x - L / 2, L / 2, L / 2, s);
            assert_near(e.temperature, 31 + 66 * u.at.value, e.error_bound + 66 * u.at.error);
        }
}

/* A cooled rod ends as a line, however late it is. */
static void a_rod_ends_as_a_line(void **state) {
    (void)state;
    struct problem p;
    const double v[PARAM_MAX] = {0.37, 41, 2.9e6, 31, 97, 630, 7, 450}, h = v[5] / v[1];
    const struct scene *rod = scene_at("rod-cooling", v, &p);
    for (double t = 3e4; t < 1e13; t *= 1.3) /* the slowest mode: exp(-7.5e-4 t) */
        for (double x = 0; x <= v[0]; x += v[0] / 17) {
            struct exact e = scene_exact(rod, &p, (double[2]){x, 0}, t);
            double slope = (v[6] - v[3]) * h / (1 + h * v[0]), left = 200 * exp(-7.5e-4 * t);
            assert_near(e.temperature, v[3] + slope * x, 1e-13 * 97 + left);
            assert_near(e.gradient[0], slope, 1e-12 + 10 * left / v[0]);
        }
}

/* b = 0: the slab between y = 0 and an insulated end.  b = 1e19: the half of a plate twice as wide with cold sides.
 */
static void plate_limits(void **state) {
    (void)state;
    double v[PARAM_MAX] = {0.53, 0.91, 41, 2.9e6, 83, 7, 0, 7, 5000}, W = v[0], H = v[1];
    for (int i = 1; i < TIMES; i++)
        for (int k = 0; k < 40; k++) {
            struct problem p;
            double s = sqrt(4 * v[2] / v[3] * times[i]), x = W * (k % 8 + 0.13) / 8, y = H * (k / 8 + 0.07) / 5;
            v[6] = 0;
            const struct scene *plate = scene_at("plate-cooling", v, &p);
            struct exact e = scene_exact(plate, &p, (double[2]){x, y}, times[i]);
            struct curve u = series_box(y - H, H, H, s);
            assert_near(e.temperature, 83 - 76 * u.at.value, e.error_bound + 76 * u.at.error);
            assert_near(e.gradient[0], 0, e.gradient_bound[0]);
            assert_near(e.gradient[1], -76 * u.slope.value, e.gradient_bound[1] + 76 * u.slope.error);
            v[6] = 1e19;
            plate = scene_at("plate-cooling", v, &p);
            e = scene_exact(plate, &p, (double[2]){x, y}, times[i]);
            struct rectangle r;
            rectangle_prepare((double[2]){2 * W, H}, (double[4]){0, 0, 76, 0}, s, &r);
            struct surface T = rectangle_at(&r, (double[2]){W + x, y});
            assert_near(e.temperature, 7 + T.at.value, e.error_bound + T.at.error);
        }
}

/* Published to four digits: test T4 of the standard NAFEMS benchmarks. */
static void nafems_t4(void **state) {
    (void)state;
    struct problem p;
    struct failure why;
    const struct scene *s = scene_find("plate-cooling");
    const double x[2] = {0.6, 0.2};
    scene_defaults(s, &p);
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    assert_near(scene_exact(s, &p, x, 2.5e5).temperature, 18.25, 0.005);
    assert_near(scene_exact(s, &p, x, 2.5e5).temperature, scene_exact(s, &p, x, 1e9).temperature, 1e-12);
    assert_order(scene_exact(s, &p, x, 6000).temperature, <, 17);
}

static struct surface surface_at(const struct cooled_plate *c, const double x[2]) {
    struct surface T;
    cooled_plate_at(c, 1, &x[0], &x[1], &T);
    return T;
}

/* While it is early, of a plate that starts warm: central differences, off by step^2/6 of a third derivative of up to
 * some 1e6 K m^-3. */
static void early_gradients_are_differences(void **state) {
    (void)state;
    struct cooled_plate *c = cooled_plate(0.6, 1, 14.4, 100, 37, 0.05);
    const double step = 1e-4, at[][2] = {{0.57, 0.03}, {0.31, 0.02}, {0.58, 0.97}, {0.4, 0.98}, {0.59, 0.5}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++)
        for (int a = 0; a < 2; a++) {
            double x[2] = {at[i][0], at[i][1]}, T[2];
            double slope = surface_at(c, x).slope[a].value;
            for (int k = 0; k < 2; k++) {
                x[a] = at[i][a] + (k ? step : -step);
                T[k] = surface_at(c, x).at.value;
            }
            assert_near((T[1] - T[0]) / (2 * step), slope, 0.02);
        }
    free(c);
}

/* Points of a lattice share what they can, and points that follow them do not: each has the bits that it has alone.
 */
static void shared_points_are_as_alone(void **state) {
    (void)state;
    enum { NX = 7, NY = 5, N = NX * NY + 4 };
    double x[N], y[N];
    for (int i = 0; i < NX * NY; i++) x[i] = 0.6 * (i % NX + 0.5) / NX, y[i] = (i / NX + 0.5) / NY;
    for (int i = NX * NY; i < N; i++) x[i] = 0.6 - 0.013 * (i - NX * NY), y[i] = i % 2 ? 1e-9 : 0.37;
    for (int late = 0; late < 2; late++) {
        struct cooled_plate *c = cooled_plate(0.6, 1, 14.4, 100, 37, late ? 0.4 : 0.05);
        struct surface T[N];
        cooled_plate_at(c, N, x, y, T);
        for (int i = 0; i < N; i++) {
            struct surface alone = surface_at(c, (double[2]){x[i], y[i]});
            assert_memory_equal(&T[i], &alone, sizeof alone);
        }
        free(c);
    }
}

/* Later the start is a product of two sums of modes, and a slope takes one of each along an axis: 4 epsilon of it at
 * least, beyond what a start without modes has. */
static void the_modes_of_a_start_widen_its_bounds(void **state) {
    (void)state;
    const double start = 37, h = 14.4;
    struct cooled_plate *c = cooled_plate(0.6, 1, h, 0, start, 0.4);
    const double *wave = c->mode, *size = c->mode + c->m + c->n;
    double slope = 0;
    assert_order(c->m, >, 0);
    for (int k = 0; k < c->m + c->n; k++) slope += wave[k] * fabs(size[k]);
    assert_order(c->error[0], >, 60 * DBL_EPSILON * start);
    assert_order(c->error[1], >, DBL_EPSILON * start * (100 * (1 / c->early + h) + 4 * slope));
    free(c);
}

/* Early the double series would take modes without number: it says that it has no bound, and at once.  As long as it
 * has one, it holds. */
static void the_series_knows_its_limit(void **state) {
    (void)state;
    int bounded = 0, unbounded = 0;
    for (double s = 0.3; s > 1e-9; s /= 2.3) {
        struct cooled_plate *c = cooled_plate(0.6, 1, 14.4, 100, 37, s);
        const double x[2] = {0.41, 0.0087};
        struct surface T = surface_at(c, x);
        struct approx U = cooled_plate_series(0.6, 1, 14.4, 100, 37, s, x);
        free(c);
        if (isfinite(U.error)) assert_near(U.value, T.at.value, U.error + T.at.error);
        bounded += U.error < 1e-8, unbounded += isinf(U.error);
    }
    assert_order(bounded, >=, 5);
    assert_order(unbounded, >=, 5);
}

/* On the hot side the gradient is the limit of that beside it; in the corner it grows without bound, and says so. */
static void the_hot_side_has_a_gradient(void **state) {
    (void)state;
    struct problem p;
    struct failure why;
    const struct scene *s = scene_find("plate-cooling");
    scene_defaults(s, &p);
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    for (double u = 1e-3; u < 0.6; u *= 2.1) {
        struct exact on = scene_exact(s, &p, (double[2]){0.6 - u, 0}, 3000);
        struct exact off = scene_exact(s, &p, (double[2]){0.6 - u, 1e-7 * u}, 3000);
        assert_near(on.temperature, 100, on.error_bound);
        assert_near(on.gradient[1], off.gradient[1], 1e-5 * fabs(off.gradient[1]));
        assert_near(on.gradient[0], 0, on.gradient_bound[0]);
    }
    struct exact corner = scene_exact(s, &p, (double[2]){0.6, 0}, 3000);
    assert_near(corner.temperature, 100, corner.error_bound);
    assert_true(isinf(corner.gradient[1]));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(roots_are_known),
        cmocka_unit_test(no_root_is_missed),
        cmocka_unit_test(modes_have_their_integrals),
        cmocka_unit_test(half_lines_cool),
        cmocka_unit_test(rod_limits),
        cmocka_unit_test(a_rod_ends_as_a_line),
        cmocka_unit_test(plate_limits),
        cmocka_unit_test(nafems_t4),
        cmocka_unit_test(early_gradients_are_differences),
        cmocka_unit_test(shared_points_are_as_alone),
        cmocka_unit_test(the_modes_of_a_start_widen_its_bounds),
        cmocka_unit_test(the_series_knows_its_limit),
        cmocka_unit_test(the_hot_side_has_a_gradient),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("cooling", tests, NULL, NULL);
}
