/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Brookshaw's weight of one pair, each factor of it in closed form. */
#include "solver/method.h"

#include "solver/space/operator.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>

extern const struct method method_brookshaw;

/* kappa = 0.7/1.3 left of x = 0.4 m and 0.2/0.9 right of it */
static struct problem two_halves(void) {
    struct problem p = odd_rectangle();
    p.materials = 2, p.interface = 0.4;
    p.material[0] = (struct material){{0.7, 0.7}, 1.3};
    p.material[1] = (struct material){{0.2, 0.2}, 0.9};
    return p;
}

static const double dx = 0.05, h = 0.061, d[2] = {0.021, -0.037};

/* The weight that the particle at x has on one at x + d, s^-1. */
static double weight(const struct problem *p, struct options o, double x) {
    double at[1][2] = {{d[0], d[1]}}, w[1], *out[2] = {w, NULL};
    struct failure why = {0};
    const struct scheme *scheme = method_brookshaw.scheme;
    struct neighbourhood nb = {
        .dim = 2, .x = {x, 0.7}, .n = 1, .d = at, .h = h, .volume = scheme->volume(p, &o, h, dx * dx)};
    nb.rho_c = layout_rho_c(p, 0, x);
    assert_int_equal(operator_weights(scheme, p, &o, &nb, out, &why), STATUS_OK);
    return w[0];
}

/* -(dW/dr) r/(r^2 + eta^2) of the cubic kernel in the plane, m^-4; r < h */
static double F(void) {
    double r = hypot(d[0], d[1]), s = r / h, slope = 15 / (7 * M_PI) * s * (2 - 1.5 * s);
    return slope / (h * h * h) * r / (r * r + 0.01 * h * h);
}

static void raw_weights(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct options o = {.dx = dx, .volume = VOLUME_RAW};
    assert_near(weight(&p, o, 0.11) / (dx * dx * 2 * 0.7 * F() / 1.3), 1, 1e-14);
    assert_near(weight(&p, o, 0.77) / (dx * dx * 2 * 0.2 * F() / 0.9), 1, 1e-14);
}

static void means_across_the_interface(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct options o = {.dx = dx, .volume = VOLUME_RAW};
    const double x = 0.385, part = (0.4 - x) / d[0], unit = dx * dx * F() / 1.3; /* five sevenths lie on the left */
    assert_near(weight(&p, o, x) / unit, 4 * 0.7 * 0.2 / 0.9, 1e-13);
    o.mean = MEAN_ARITHMETIC;
    assert_near(weight(&p, o, x) / unit, 0.9, 1e-13);
    o.mean = MEAN_SERIES;
    assert_near(weight(&p, o, x) / unit, 2 / (part / 0.7 + (1 - part) / 0.2), 1e-13);
}

/* V = area xi/N, N with the ghosts: 30 x 24 particles and two layers on each side. */
static void tuned_volume(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct options o = {.dx = dx, .volume = VOLUME_TUNED};
    double pair = 2 * 0.7 * F() / 1.3, area = 1.5 * 1.2, N = 34 * 28;
    assert_near(weight(&p, o, 0.11) / pair, area * 9 * cbrt(h) / N, 1e-14);
    o.xi = 1.71;
    assert_near(weight(&p, o, 0.11) / pair, area * 1.71 / N, 1e-14);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(raw_weights),
        cmocka_unit_test(means_across_the_interface),
        cmocka_unit_test(tuned_volume),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
