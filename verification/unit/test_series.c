/* The two forms of each sum agree where both converge, at any time, and their bounds are honest. */
#include "references/series.h"

#include "references/layers.h"
#include "references/rectangle.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

static void box_forms_agree(void **state) {
    (void)state;
    const double L = 1.37;
    for (double s = 0.01; s < 8; s *= 1.31)
        for (double a = 0.071; a < L; a += 0.213)
            for (double x = -L; x <= L; x += 0.0931) {
                struct approx u = series_box_images(x, L, a, s), v = series_box_modes(x, L, a, s);
                struct approx best = series_box(x, L, a, s);
                assert_near(u.value, v.value, u.error + v.error);
                assert_near(u.value, v.value, 2e-13);
                assert_true(best.error < 1e-14 + 1e-15 * L / s); /* an image lies 2L away */
            }
}

static void box_is_exact_at_the_start_and_at_the_walls(void **state) {
    (void)state;
    assert_near(series_box(0.41, 1.37, 0.41, 0).value, 1, 0);
    assert_near(series_box(-0.4100001, 1.37, 0.41, 0).value, 0, 0);
    assert_near(series_box(0.4, 1.37, 0.41, 1e-9).value, 1, 0);
    assert_near(series_box(0.41, 1.37, 0.41, 1e-9).value, 0.5, 1e-15); /* the mean of the two sides of a jump */
    for (double s = 0.003; s < 50; s *= 1.7) assert_near(series_box(1.37, 1.37, 0.41, s).value, 0, 1e-15);
}

/* Where modes have not converged, the bound says so. */
static void box_modes_know_their_limit(void **state) {
    (void)state;
    struct approx u = series_box_modes(0.3, 1.37, 0.41, 1e-6), start = series_box_modes(0.3, 1.37, 0.41, 0);
    assert_true(u.error > 1e-6 && u.error <= 1.1);
    assert_near(u.value, 1, u.error);
    assert_true(start.error >= 1);
}

static void gauss_forms_agree(void **state) {
    (void)state;
    for (double sigma = 0.05; sigma < 5; sigma *= 1.23)
        for (double x = -1.37; x <= 1.37; x += 0.0931) {
            struct approx u = series_gauss_images(x, 1.37, sigma), v = series_gauss_modes(x, 1.37, sigma);
            assert_near(u.value, v.value, u.error + v.error);
            assert_near(series_gauss(x, 1.37, sigma).value, series_gauss_other(x, 1.37, sigma).value, 1e-14);
        }
}

/* sum of 1/n^2 = pi^2/6, whose partial sums are off by 1/n */
static void levin_sums_what_crawls(void **state) {
    (void)state;
    double term[30];
    for (int n = 1; n <= 30; n++) term[n - 1] = 1.0 / (n * n);
    struct series_levin r = series_accelerate(term, 30);
    assert_near(r.accelerated, 1.6449340668482264365, 1e-10);
    assert_true(r.plain < 1.62 && r.error < 1e-9 && r.terms_used <= 30);
}

/* Near the hot side the sine series of the steady plate crawls.  On the middle line its terms alternate, and the
 * Levin transform sums them to rounding; off it they change sign irregularly, and it makes them worse.  Strips need
 * neither. */
static void levin_helps_on_the_middle_line_alone(void **state) {
    (void)state;
    const double W = 0.13, B = 0.07, xi = 0.001 * W;
    struct series_levin middle = rectangle_steady_series(xi, W, 0.5 * B, B, 32);
    struct series_levin off = rectangle_steady_series(xi, W, 0.05 * B, B, 64);
    assert_near(middle.accelerated, rectangle_steady(xi, W, 0.5 * B, B).value, 1e-14);
    assert_true(fabs(middle.plain - middle.accelerated) > 5e-3);
    double plain = fabs(off.plain - rectangle_steady(xi, W, 0.05 * B, B).value);
    double accelerated = fabs(off.accelerated - rectangle_steady(xi, W, 0.05 * B, B).value);
    assert_true(accelerated > 5 * plain && accelerated > 1e4 * off.error); /* nor is its own error to be trusted */
}

static void steady_strips_are_the_sine_series(void **state) {
    (void)state;
    for (double W = 0.02; W < 1; W *= 2.3)
        for (double xi = 0.13; xi <= 1; xi += 0.17)
            for (double eta = 0.011; eta < 1; eta += 0.157) {
                double B = 0.17;
                if (xi * W < 0.12 * B) continue; /* too near for a plain sum */
                struct series_levin plain = rectangle_steady_series(xi * W, W, eta * B, B, 200);
                struct approx strips = rectangle_steady(xi * W, W, eta * B, B);
                assert_near(plain.plain, strips.value, strips.error + 1e-15);
                assert_true(strips.error < 1e-13);
            }
}

/* Laplace's equation of four sides at once: the responses of all four add up to 1. */
static void four_hot_sides_make_a_hot_plate(void **state) {
    (void)state;
    const double W = 0.13, B = 0.07;
    for (double x = 0.003; x < W; x += 0.0113)
        for (double y = 0.002; y < B; y += 0.0071) {
            double sum = rectangle_steady(x, W, y, B).value + rectangle_steady(W - x, W, y, B).value +
                         rectangle_steady(y, B, x, W).value + rectangle_steady(B - y, B, x, W).value;
            assert_near(sum, 1, 1e-15 * 8);
        }
}

/* ... and, before that, to 1 minus a plate that cools from 1: a product of two boxes. */
static void four_sides_are_a_product_of_boxes(void **state) {
    (void)state;
    const double W = 0.13, B = 0.07;
    for (double s = 0.002; s < 0.3; s *= 1.37)
        for (double x = 0; x <= W; x += 0.0131)
            for (double y = 0.0005; y < B; y += 0.0071) {
                double sum = rectangle_response(x, W, y, B, s).value + rectangle_response(W - x, W, y, B, s).value +
                             rectangle_response(y, B, x, W, s).value + rectangle_response(B - y, B, x, W, s).value;
                double cool =
                    series_box(x - W / 2, W / 2, W / 2, s).value * series_box(y - B / 2, B / 2, B / 2, s).value;
                assert_near(sum, 1 - cool, 2e-14);
            }
}

/* Long and short plates have hundreds of modes along one axis. */
static void long_plates_agree_with_quadrature(void **state) {
    (void)state;
    static const double s[] = {0.0149, 0.0151, 0.04, 0.3, 2.1};
    for (int i = 0; i < 5; i++)
        for (double x = 0.0013; x < 1; x += 0.119) {
            struct approx u = rectangle_response(x * 7.3, 7.3, 0.031, 0.1, s[i]);
            struct approx v = rectangle_quadrature(x * 7.3, 7.3, 0.031, 0.1, s[i]);
            assert_near(u.value, v.value, u.error + v.error);
            u = rectangle_response(x * 0.1, 0.1, 0.31, 7.3, s[i]);
            v = rectangle_quadrature(x * 0.1, 0.1, 0.31, 7.3, s[i]);
            assert_near(u.value, v.value, u.error + v.error);
            assert_true(u.error < 1e-12 && v.error < 1e-11);
        }
}

/* Owen's T at both ends and in the middle, from quadrature in 30-digit arithmetic of
 * erfc(xi) - Q, Q = 2/sqrt(pi) int_xi^inf exp(-z^2) erfc(z eta/xi) dz */
static void corner_values_are_known(void **state) {
    (void)state;
    static const double known[][3] = {
        {0.10775284106671307, 0.027020197237194381, 0.154571498825948618503844},
        {0.0005658946562790019, 0.0030172619813591071, 0.881970531858959159415070},
        {0.81743015784482254, 0.19844308218500264, 0.076730430856505483810872},
    };
    for (int i = 0; i < 3; i++)
        assert_near(erfc(known[i][0]) - rectangle_corner(known[i][0], known[i][1], 1), known[i][2], 1e-15);
    assert_near(rectangle_corner(0.37, 0.37, 1), erfc(0.37) * erfc(0.37) / 2, 1e-15);
}

static void sinh_ratio_never_overflows(void **state) {
    (void)state;
    assert_near(rectangle_sinh_ratio(1.3, 0.7, 1.1), sinh(1.3 * 0.7) / sinh(1.3 * 1.1), 1e-15);
    assert_near(rectangle_sinh_ratio(1e6, 1.0999999, 1.1), exp(-0.1), 1e-9);
    assert_near(rectangle_sinh_ratio(1e-9, 0.7, 1.1), 0.7 / 1.1, 1e-15);
    assert_near(rectangle_sinh_ratio(1e6, 0, 1.1), 0, 0);
}

/* Equal layers are one wall, whose slowest mode is sin(pi x/L); its transient is the box that cools. */
static void two_equal_layers_are_one_wall(void **state) {
    (void)state;
    struct layers w = {{0.37, 0.73}, {0.9, 0.9}, {1.3, 1.3}, {0.2, 0.2}, {1.7, 1.7}};
    double kappa = 0.9 / 1.3, L = 0.37 + 0.73, mu = layers_slowest(&w);
    assert_near(mu, kappa * pow(3.14159265358979323846 / L, 2), 1e-13 * mu);
    for (double t = 0.001; t < 1; t *= 2.1)
        for (double x = -0.36; x < 0.73; x += 0.083) {
            struct exact e = layers_at(&w, x, t);
            struct approx u = series_box(x + 0.37 - L / 2, L / 2, L / 2, sqrt(4 * kappa * t));
            assert_near(e.temperature, 0.2 + 1.5 * u.value, e.error_bound);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_forms_agree),
        cmocka_unit_test(box_is_exact_at_the_start_and_at_the_walls),
        cmocka_unit_test(box_modes_know_their_limit),
        cmocka_unit_test(gauss_forms_agree),
        cmocka_unit_test(levin_sums_what_crawls),
        cmocka_unit_test(levin_helps_on_the_middle_line_alone),
        cmocka_unit_test(steady_strips_are_the_sine_series),
        cmocka_unit_test(four_hot_sides_make_a_hot_plate),
        cmocka_unit_test(four_sides_are_a_product_of_boxes),
        cmocka_unit_test(long_plates_agree_with_quadrature),
        cmocka_unit_test(corner_values_are_known),
        cmocka_unit_test(sinh_ratio_never_overflows),
        cmocka_unit_test(two_equal_layers_are_one_wall),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("series", tests, NULL, NULL);
}
