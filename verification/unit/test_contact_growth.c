/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contact_ssph with materials of any ratio: no mode grows, and a row's weights beside the interface are exact and not
 * negative.  Clouds of 40 particles on a rod and 12 x 12 in the plane, k and rho c apart by 1e-4 to 1e4. */
#include "solver/particles/ssph.h"
#include "verification/stability/spectrum.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <math.h>

extern const struct method method_contact_ssph;

static double zero(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 0;
}

static double cold(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 0;
}

struct cloud_case {
    int dim, n;
    double h, k, rho_c, interface;
    enum layout_name layout;
    double jitter;
    unsigned long seed;
};

/* 1 where a mode of the operator grows. */
static int grows(const struct cloud_case *c) {
    struct problem p = {.dim = c->dim,
                        .hi = {c->n, c->dim == 2 ? c->n : 0},
                        .t_end = 1,
                        .materials = 2,
                        .interface = c->interface,
                        .material = {{{1, 1}, 1}, {{c->k, c->k}, c->rho_c}},
                        .initial = cold,
                        .wall = zero};
    struct options o = {.dx = 1,
                        .h = c->h,
                        .layout = c->layout,
                        .jitter = c->jitter,
                        .sweeps = 2000,
                        .seed = c->seed,
                        .stepper = STEPPER_EULER};
    struct lattice l;
    struct cloud cloud;
    struct heat_operator a;
    struct spectrum s;
    struct failure why = {0};
    for (int side = 0; side < 4; side++) p.side[side] = c->seed % 2 ? DIRICHLET : NEUMANN;
    if (layout_lattice(&p, &o, 1, &l, &why) || layout_cloud(&p, &o, &l, 2 * c->h, &cloud, &why) ||
        operator_create_csr(&a, &p, &o, method_contact_ssph.scheme, &cloud, 1, &why) ||
        spectrum_create(&s, &a, &(struct amplification){STEPPER_EULER, 0}, &why))
        fail_msg("%s", why.text);
    int out = s.growth > spectrum_rounding(&s);
    if (out)
        print_error("dim %d h %g k %g rho_c %g layout %d jitter %g seed %lu: grows by %g\n", c->dim, c->h, c->k,
                    c->rho_c, (int)c->layout, c->jitter, c->seed, s.growth);
    spectrum_free(&s);
    operator_free(&a);
    layout_cloud_free(&cloud);
    return out;
}

static const double ratio[][2] = {{1e-4, 1},   {1e-2, 1}, {100, 1},   {1e4, 1},    {1, 1e-4},
                                  {1, 1e-2},   {1, 100},  {1, 1e4},   {100, 1e-2}, {1e-3, 1e3},
                                  {1e-4, 1e4}, {1e3, 10}, {1e3, 1e3}, {1e-4, 1e-4}};
enum { RATIOS = sizeof ratio / sizeof *ratio };

static const struct {
    enum layout_name layout;
    double jitter;
} clouds[] = {{LAYOUT_JITTER, 0}, {LAYOUT_JITTER, 0.1}, {LAYOUT_JITTER, 0.3}, {LAYOUT_RELAXED, 0.5}};
enum { CLOUDS = sizeof clouds / sizeof *clouds };

/* `seeds` draws of each cloud, with the interface at other places of its cell (on a particle too). */
static int count(int dim, int n, double h, int seeds) {
    int growing = 0;
    for (int q = 0; q < CLOUDS; q++)
        for (int k = 0; k < RATIOS; k++)
            for (int s = 0; s < seeds; s++) {
                struct cloud_case c = {dim,
                                       n,
                                       h,
                                       ratio[k][0],
                                       ratio[k][1],
                                       n / 2 + 0.25 * (s % 3),
                                       clouds[q].layout,
                                       clouds[q].jitter,
                                       (unsigned long)(1 + s + seeds * k)};
                growing += grows(&c);
            }
    return growing;
}

static void no_mode_grows_on_a_rod(void **state) {
    (void)state;
    assert_int_equal(count(1, 40, 1.1, 3), 0);
    assert_int_equal(count(1, 40, 2, 3), 0);
}

static void no_mode_grows_in_the_plane(void **state) {
    (void)state;
    assert_int_equal(count(2, 9, 1.1, 1), 0);
}

/* x, x^2/2 at two neighbours on either side of a particle of a rod. */
static void weights_are_not_negative(void **state) {
    (void)state;
    static const double at[] = {-2, -1, 0.3, 1.9};
    double P[4][SSPH_TERMS_MAX] = {{0}}, W[4] = {1, 1, 4, 0.01}, b[2] = {0, 1}, w[4];
    for (int j = 0; j < 4; j++) P[j][0] = at[j], P[j][1] = at[j] * at[j] / 2;
    assert_int_equal(nonnegative_weights(4, 2, P, W, b, w), 1);
    double sum[2] = {0};
    for (int j = 0; j < 4; j++) {
        assert_order(w[j], >=, 0);
        for (int k = 0; k < 2; k++) sum[k] += w[j] * P[j][k];
    }
    assert_near(sum[0], 0, 1e-14);
    assert_near(sum[1], 1, 1e-14);
    assert_int_equal(nonnegative_weights(2, 2, P, W, b, w), 0); /* both on one side */
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_mode_grows_on_a_rod),
        cmocka_unit_test(no_mode_grows_in_the_plane),
        cmocka_unit_test(weights_are_not_negative),
    };
    return cmocka_run_group_tests_name("two materials of any ratio", tests, NULL, NULL);
}
