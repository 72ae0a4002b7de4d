/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two forms of each sum agree where both converge, at any time, and their bounds are honest. */
#include "references/series.h"

#include "references/layers.h"
#include "references/rectangle.h"
#include "verification/unit/near.h"

#include <float.h>
#include <gsl/gsl_errno.h>

static void box_forms_agree(void **state) {
    (void)state;
    const double L = 1.37;
    for (double s = 0.01; s < 8; s *= 1.31)
        for (double a = 0.071; a < L; a += 0.213)
            for (double x = -L; x <= L; x += 0.0931) {
                struct curve u = series_box_images(x, L, a, s), v = series_box_modes(x, L, a, s);
                struct approx best = series_box(x, L, a, s).at;
                assert_near(u.at.value, v.at.value, u.at.error + v.at.error);
                assert_near(u.at.value, v.at.value, 2e-13);
                assert_near(u.slope.value, v.slope.value, u.slope.error + v.slope.error);
                assert_near(u.slope.value, v.slope.value, 2e-13 / fmin(s, a));
                assert_order(best.error, <, 1e-14 + 1e-15 * L / s); /* an image is 2L away */
            }
}

static void box_is_exact_at_the_start_and_at_the_walls(void **state) {
    (void)state;
    assert_near(series_box(0.41, 1.37, 0.41, 0).at.value, 1, 0);
    assert_near(series_box(-0.4100001, 1.37, 0.41, 0).at.value, 0, 0);
    assert_near(series_box(0.4, 1.37, 0.41, 1e-9).at.value, 1, 0);
    assert_near(series_box(0.41, 1.37, 0.41, 1e-9).at.value, 0.5, 1e-15); /* the mean of the two sides of a jump */
    for (double s = 0.003; s < 50; s *= 1.7) assert_near(series_box(1.37, 1.37, 0.41, s).at.value, 0, 1e-15);
}

/* At late times the number of significant images is unbounded; a sum that would exceed the limit is not
 * evaluated. */
static void unbounded_series_report_infinity(void **state) {
    (void)state;
    for (double s = 1e7; s < 1e300; s *= 1e60) {
        struct curve u = series_box_images(0.3, 1.37, 0.41, s), v = series_gauss_images(0.3, 1.37, s);
        assert_true(isinf(u.at.error) && isinf(u.slope.error) && isinf(v.at.error) && isinf(v.slope.error));
    }
    assert_true(isinf(series_gauss_modes(0.3, 1.37, 1e-5).at.error)); /* early, nor do modes */
    struct approx u = series_box_images(0.3, 1.37, 0.41, 1e4).at;
    assert_near(u.value, 0, u.error);
    assert_order(u.error, <, 1e-12);
}

static void gauss_forms_agree(void **state) {
    (void)state;
    for (double sigma = 0.05; sigma < 5; sigma *= 1.23)
        for (double x = -1.37; x <= 1.37; x += 0.0931) {
            struct curve u = series_gauss_images(x, 1.37, sigma), v = series_gauss_modes(x, 1.37, sigma);
            assert_near(u.at.value, v.at.value, u.at.error + v.at.error);
            assert_near(u.slope.value, v.slope.value, u.slope.error + v.slope.error);
            assert_near(u.at.value, v.at.value, 1e-14);
            assert_near(u.slope.value, v.slope.value, 3e-14 / sigma);
        }
}

/* x and sigma are rounded, each by half of eps, and exp(-z^2/2) is off by z^2 times that. */
static void gauss_bound_covers_round_off_of_x(void **state) {
    (void)state;
    for (double z = 1.3; z < 9; z *= 1.4) {
        struct approx u = series_gauss_images(z * 1.37, 40, 1.37).at;
        assert_near(u.value, exp(-z * z / 2), u.error);
        assert_order(u.error, >=, z * z * DBL_EPSILON * u.value);
    }
}

/* One side at 1, by the double sine series. */
static struct surface one_side(int side, double x, double W, double y, double B, double s) {
    struct rectangle r;
    double hot[4] = {0, 0, 0, 0};
    hot[side] = 1;
    rectangle_prepare((double[2]){W, B}, hot, s, &r);
    return rectangle_at(&r, (double[2]){x, y});
}

/* The responses of four sides add up to 1 minus a plate that cools from 1, a product of two boxes; so do the slopes.
 */
static void four_side_responses_sum_to_a_product(void **state) {
    (void)state;
    const double W = 0.13, B = 0.07;
    for (double s = 0.0002; s < 0.3; s *= 1.37)
        for (double x = 0; x <= W; x += 0.0131)
            for (double y = 0.0005; y < B; y += 0.0071) {
                struct curve u = series_box(x - W / 2, W / 2, W / 2, s), v = series_box(y - B / 2, B / 2, B / 2, s);
                double sum = 0, slope[2] = {0, 0}, error[3] = {0, 0, 0};
                for (int side = 0; side < 4; side++) {
                    struct surface T = one_side(side, x, W, y, B, s);
                    sum += T.at.value;
                    error[2] += T.at.error;
                    for (int a = 0; a < 2; a++) slope[a] += T.slope[a].value, error[a] += T.slope[a].error;
                }
                assert_near(sum, 1 - u.at.value * v.at.value, 1e-13);
                assert_near(sum, 1 - u.at.value * v.at.value, error[2] + u.at.error + v.at.error);
                assert_near(slope[0], -u.slope.value * v.at.value, error[0] + u.slope.error + v.at.error / s);
                assert_near(slope[1], -u.at.value * v.slope.value, error[1] + v.slope.error + u.at.error / s);
                assert_order(error[0], <, 1e-12 / s + 1e-13 / fmin(y, B - y));
                assert_order(error[2], <, 2e-13);
            }
}

/* Long and short plates have their middle left out; slopes are those of central differences. */
static void long_plates_agree_with_quadrature(void **state) {
    (void)state;
    static const double s[] = {0.0149, 0.04, 0.3, 2.1, 91, 1e7};
    for (int i = 0; i < 6; i++)
        for (double x = 0.0013; x < 1; x += 0.119) {
            struct surface u = one_side(0, x * 7.3, 7.3, 0.031, 0.1, s[i]);
            struct approx v = rectangle_quadrature(x * 7.3, 7.3, 0.031, 0.1, s[i]);
            assert_near(u.at.value, v.value, u.at.error + v.error);
            u = one_side(3, 0.31, 7.3, (1 - x) * 0.1, 0.1, s[i]);
            v = rectangle_quadrature(x * 0.1, 0.1, 0.31, 7.3, s[i]);
            assert_near(u.at.value, v.value, u.at.error + v.error);
            assert_order(u.at.error, <, 1e-12);
            assert_order(v.error, <, 1e-11);
        }
}

/* Equal layers form one wall, whose slowest mode is sin(pi x/L); its transient is a cooling box. */
static void two_equal_layers_equal_one_wall(void **state) {
    (void)state;
    static struct layers_modes m;
    struct layers_contour c;
    struct layers w = {{0.37, 0.73}, {0.9, 0.9}, {1.3, 1.3}, {0.2, 0.2}, {1.7, 1.7}, 0};
    double kappa = 0.9 / 1.3, L = 0.37 + 0.73;
    for (double t = 0.0001; t < 1e12; t *= t < 1 ? 2.1 : 37) {
        layers_modes(&w, t, &m);
        layers_contour(&w, t, &c);
        for (int n = 0; n < m.n; n++)
            assert_near(m.mode[n].q[0] * L, (n + 1) * 3.14159265358979323846, 1e-15 * 4 * (n + 1));
        for (double x = -0.36; x < 0.73; x += 0.083) {
            struct curve e = layers_contour_at(&c, x), f = layers_modes_at(&m, x);
            struct curve u = series_box(x + 0.37 - L / 2, L / 2, L / 2, sqrt(4 * kappa * t));
            assert_near(e.at.value, 0.2 + 1.5 * u.at.value, e.at.error);
            assert_near(f.at.value, 0.2 + 1.5 * u.at.value, f.at.error);
            assert_near(e.slope.value, 1.5 * u.slope.value, e.slope.error);
            assert_near(f.slope.value, 1.5 * u.slope.value, f.slope.error);
        }
    }
}

/* If e differs r-fold, r > 1e4, the rounding of the frequencies counts r-fold.  In the last three trials the other
 * layer is still at its start, so the sum of modes is 0. */
static void mode_bounds_cover_round_off_at_high_contrast(void **state) {
    (void)state;
    static const struct {
        struct layers w;
        double t, x;
    } trial[] = {
        {{{0.99999737825985313, 2.6217401468686674e-06},
          {28178606.143624965, 8.8172876823339544e-05},
          {1.9063131695087671e-07, 1.3786323128614672e-06},
          {1, 0},
          {0, 0},
          0},
         2.6875696469190628e-15,
         7.8652204406060016e-07},
        {{{0.057, 0.943}, {9348, 0.405}, {5090, 0.159}, {1, 0}, {0, 0}, 0}, 5.1e-5, 0.75},
        {{{0.0566, 0.943}, {8.74e7, 0.164}, {2.59e7, 0.0252}, {1, 0}, {0, 0}, 0}, 2.04e-5, 0.283},
        {{{0.943, 0.0566}, {0.164, 8.74e7}, {0.0252, 2.59e7}, {0, 1}, {0, 0}, 0}, 2.04e-5, -0.283},
        {{{0.057, 0.943}, {9348, 0.405}, {5090, 0.159}, {1, 0}, {0, 0}, 0.7}, 0.021, 0.31},
        {{{0.943, 0.0566}, {0.164, 87}, {0.0252, 26}, {0.3, 1}, {0, 0}, 1.3e-4}, 0.0071, -0.083},
        {{{0.4, 0.6}, {1, 1.7}, {1.3, 0.9}, {1, 0}, {0, 0}, 4300}, 0.011, -0.0003},
    };
    static struct layers_modes m;
    struct layers_contour c;
    for (int i = 0; i < 7; i++) {
        layers_modes(&trial[i].w, trial[i].t, &m);
        layers_contour(&trial[i].w, trial[i].t, &c);
        struct curve e = layers_contour_at(&c, trial[i].x), f = layers_modes_at(&m, trial[i].x);
        assert_near(f.at.value, e.at.value, f.at.error + e.at.error);
        if (i > 0 && i < 4) assert_near(f.at.value, 0, f.at.error);
        if (i > 1 && i < 4) assert_order(f.at.error, <, 1000 * fabs(f.at.value)); /* the bound is not idle */
    }
}

/* No mode is missed, even where both layers resonate and the contact is a node: the n-th has n - 1 nodes, so that the
 * frequencies of equal layers are n pi/(sum of their times), and those of other layers are in between. */
static void modes_of_two_layers_are_complete(void **state) {
    (void)state;
    static struct layers_modes m;
    for (double contrast = 1e-6; contrast < 2e6; contrast *= 10) {
        struct layers w = {{0.4, 0.6}, {1, contrast}, {1.3, contrast * 0.7}, {0, 0}, {1, 0}, 0};
        layers_modes(&w, 1e-3, &m);
        double sum = 0.4 * sqrt(1.3) + 0.6 * sqrt(0.7);
        assert_order(m.n, >, 20);
        for (int n = 1; n <= m.n; n++) {
            double phase = m.mode[n - 1].q[0] / sqrt(1.3) * sum / 3.14159265358979323846;
            assert_order(phase, >, n - 1);
            assert_order(phase, <, n + 1);
            assert_true(n == 1 || m.mode[n - 1].q[0] > m.mode[n - 2].q[0] * (1 + 1e-9));
            double p1 = m.mode[n - 1].q[0] * 0.4, p2 = m.mode[n - 1].q[1] * 0.6, e1 = sqrt(1.3),
                   e2 = contrast * sqrt(0.7);
            double residual = e1 * cos(p1) * sin(p2) + e2 * cos(p2) * sin(p1);
            assert_near(residual, 0, 4e-16 * (1 + p1 + p2) * (e1 + e2));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_forms_agree),
        cmocka_unit_test(box_is_exact_at_the_start_and_at_the_walls),
        cmocka_unit_test(unbounded_series_report_infinity),
        cmocka_unit_test(gauss_forms_agree),
        cmocka_unit_test(gauss_bound_covers_round_off_of_x),
        cmocka_unit_test(four_side_responses_sum_to_a_product),
        cmocka_unit_test(long_plates_agree_with_quadrature),
        cmocka_unit_test(two_equal_layers_equal_one_wall),
        cmocka_unit_test(modes_of_two_layers_are_complete),
        cmocka_unit_test(mode_bounds_cover_round_off_at_high_contrast),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("series", tests, NULL, NULL);
}
