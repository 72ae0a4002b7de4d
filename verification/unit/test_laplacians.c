/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The discrete Laplacians on neighbourhoods without symmetry: exactness, conservation, optimality of positive
 * stencils, factors of Brookshaw's weight, refusals. */

#include "solver/particles/particles.h"
#include "solver/space/assembly.h"
#include "solver/space/kernel.h"
#include "solver/method.h"
#include "solver/space/operator.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"
#include "verification/unit/odd_neighbourhood.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_rng.h>
#include <stdlib.h>

extern const struct method method_brookshaw;

/* ---- exactness ---- */

/* sum_j w_j x_j^a y_j^b */
static double moment(const double *w, int a, int b) {
    double sum = 0;
    for (int j = 0; j < MANY; j++) sum += w[j] * pow(place[j][0], a) * pow(place[j][1], b);
    return sum;
}

static const double both[2] = {0.71, 0.43}, same[2] = {0.71, 0.71};

static void linear_fields_are_steady(void **state) {
    (void)state;
    static const char *const exact[] = {"schwaiger", "fatehi_manzari", "cspm", "so_ssph", "positive"};
    static const char *const others[] = {"brookshaw", "brookshaw_corrected", "kernel_second"};
    double w[2][MANY];
    struct neighbourhood nb = around(2, same);
    for (int k = 0; k < 5; k++) {
        weights_of(exact[k], &nb, w);
        assert_near(moment(w[0], 1, 0), 0, 1e-10);
        assert_near(moment(w[0], 0, 1), 0, 1e-10);
    }
    for (int k = 0; k < 3; k++) {
        weights_of(others[k], &nb, w);
        assert_order(fabs(moment(w[0], 1, 0)), >, 0.01);
    }
}

static void quadratics_are_exact(void **state) {
    (void)state;
    static const char *const exact[] = {"fatehi_manzari", "so_ssph", "positive"};
    double w[2][MANY];
    struct neighbourhood nb = around(2, both);
    for (int k = 0; k < 3; k++) {
        weights_of(exact[k], &nb, w);
        assert_near(moment(w[0], 2, 0), 2 * KX, 1e-12);
        assert_near(moment(w[0], 0, 2), 2 * KY, 1e-12);
        assert_near(moment(w[0], 1, 1), 0, 1e-12);
    }
    nb = around(2, same);
    weights_of("brookshaw_corrected", &nb, w); /* exact for the distance's square alone */
    assert_near(moment(w[0], 2, 0) + moment(w[0], 0, 2), 4 * KX, 1e-12);
    assert_order(fabs(moment(w[0], 2, 0) - moment(w[0], 0, 2)), >, 0.01);
    weights_of("cspm", &nb, w);
    assert_order(fabs(moment(w[0], 2, 0) - 2 * KX), >, 0.001);
}

static void positive_weights(void **state) {
    (void)state;
    double w[2][MANY];
    struct neighbourhood nb = around(2, same);
    weights_of("brookshaw_corrected", &nb, w);
    for (int j = 0; j < MANY; j++) assert_order(w[0][j], >=, 0);
    nb = around(2, both);
    weights_of("positive", &nb, w);
    for (int j = 0; j < MANY; j++) assert_order(w[0][j], >=, 0);
}

/* ---- On lattices, through operator and rows ---- */

static void second_moments_on_the_lattice(void **state) {
    (void)state;
    for (int m = 0; methods[m]; m++) {
        const struct scheme *s = methods[m]->scheme;
        if (!s) continue;
        for (int k = 0; kernel_words[k]; k++)
            for (int unequal = 0; unequal < (s->isotropic ? 1 : 2); unequal++) {
                struct options o = {.dx = 0.05, .h = 1.23, .kernel = (enum kernel_name)k};
                struct problem p = odd_rectangle();
                struct failure why;
                int reach[DIM_MAX];
                double *w, sum[3] = {0, 0, 0};
                const double *kappa = unequal ? both : same;
                p.material[0] = (struct material){{kappa[0], kappa[1]}, 1};
                if (operator_stencil(&p, &o, s, 1, kappa, reach, &w, &why))
                    fail_msg("%s: %s", methods[m]->name, why.text);
                for (int j = -reach[1]; j <= reach[1]; j++)
                    for (int i = -reach[0]; i <= reach[0]; i++) {
                        double v = w[abs(j) * (reach[0] + 1) + abs(i)];
                        sum[0] += v * i * i, sum[1] += v * j * j, sum[2] += v;
                    }
                free(w);
                if (!(fabs(sum[0] / kappa[0] - 2) <= 1e-11 && fabs(sum[1] / kappa[1] - 2) <= 1e-11))
                    fail_msg("%s: moments %.12g, %.12g kappa", methods[m]->name, sum[0] / kappa[0],
                             sum[1] / kappa[1]);
                assert_near(sum[2], 0, 1e-12);
            }
    }
}

static double no_flux(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

/* Sums of columns: d/dt of the heat that 1 K at particle j makes, over the largest weight. */
static double lost(const char *name, double jitter) {
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05, .h = 1.23, .seed = 7, .layout = LAYOUT_JITTER, .jitter = jitter};
    struct lattice l;
    struct cloud c;
    struct heat_operator a;
    struct failure why;
    for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
    p.wall = no_flux;
    p.material[0].k[1] = p.material[0].k[0];
    const struct scheme *s = named(name)->scheme;
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&p, &o, &l, s->sweeps * 2 * o.h * l.dx[0], &c, &why), STATUS_OK);
    assert_int_equal(assembly_operator(&a, &p, &o, s, &c, l.dx[0], &why), STATUS_OK);
    double *sum = xcalloc(a.n, sizeof *sum), most = 0, size = 0;
    for (size_t i = 0; i < a.n; i++) {
        size = fmax(size, fabs(a.diagonal[i])), sum[i] += a.diagonal[i];
        for (size_t k = a.row[i]; k < a.row[i + 1]; k++) sum[a.column[k]] += a.value[k];
    }
    for (size_t i = 0; i < a.n; i++) most = fmax(most, fabs(sum[i]));
    free(sum);
    operator_free(&a);
    layout_cloud_free(&c);
    return most / size;
}

static void pair_operators_conserve_heat_on_clouds(void **state) {
    (void)state;
    static const char *const all[] = {"brookshaw",           "kernel_second", "so_ssph",        "fo_ssph",
                                      "brookshaw_corrected", "schwaiger",     "fatehi_manzari", "cspm",
                                      "flux_divergence",     "positive",      "conjugate"};
    for (int m = 0; m < 11; m++) {
        assert_near(lost(all[m], 0), 0, 1e-13);
        if (m < 2 || m == 10)
            assert_near(lost(all[m], 0.31), 0, 1e-13);
        else
            assert_order(lost(all[m], 0.31), >, 0.01);
    }
}

/* ---- Refusals ---- */

static int try_weights(const char *name, size_t n, double (*d)[DIM_MAX], struct failure *why) {
    struct problem p = odd_rectangle();
    struct options o = {.kernel = KERNEL_CUBIC};
    double w[2][MANY], *out[2] = {w[0], w[1]};
    struct neighbourhood nb = around(2, same);
    nb.n = n, nb.d = d;
    return operator_weights(named(name)->scheme, &p, &o, &nb, out, why);
}

static void try_few(const char *name, size_t n, double (*d)[DIM_MAX], const char *says) {
    struct failure why = {0};
    assert_int_equal(try_weights(name, n, d, &why), STATUS_NUMERICAL);
    assert_has(why.text, "particle 3 at (0.7, -0.3) m");
    assert_has(why.text, says);
}

static void poor_clouds_are_refused(void **state) {
    (void)state;
    static const char *const corrected[] = {"brookshaw_corrected", "schwaiger", "fatehi_manzari", "cspm"};
    double line[4][DIM_MAX] = {{0.021, 0.042}, {-0.017, -0.034}, {0.043, 0.086}, {-0.03, -0.06}};
    double right[5][DIM_MAX] = {{0.041, 0.013}, {0.003, 0.049}, {0.011, -0.055}, {0.063, -0.038}, {0.021, 0.007}};
    struct failure why;
    double three[2][DIM_MAX] = {{0.041, 0.013}, {0.003, 0.049}}, twice[2][DIM_MAX] = {{0.041, 0.013}, {0, 0}};
    for (int m = 0; m < 4; m++) {
        try_few(corrected[m], 0, place, "has 0 neighbours, condition number");
        try_few(corrected[m], 4, line, "has 4 neighbours, condition number");
    }
    try_few("fatehi_manzari", 2, three, "has 2 neighbours, condition number");
    try_few("cspm", 2, three, "has 2 neighbours, condition number");
    try_few("kernel_second", 2, twice, "at the same place");
    static const char *const empty = "neighbours, none in one half of the plane";
    for (size_t n = 0; n < 3; n++) try_few("kernel_second", n, place, empty);
    try_few("kernel_second", 4, line, "has 4 neighbours, none in one half of the plane");
    for (int turn = 0; turn < 4; turn++) { /* whichever half is empty */
        try_few("kernel_second", 5, right, empty);
        for (int j = 0; j < 5; j++) {
            double x = right[j][0];
            right[j][0] = -right[j][1], right[j][1] = x;
        }
    }
    try_few("positive", 5, right, "no weights >= 0");
    try_few("positive", 4, line, "use a larger --h");
    right[4][0] = -0.011, right[4][1] = 0.018; /* leaves a gap of 160 degrees */
    assert_int_equal(try_weights("kernel_second", 5, right, &why), STATUS_OK);
    try_few("flux_divergence", 0, place, "has 0 neighbours, condition number infinite");
    try_few("flux_divergence", 1, place, "has 1 neighbours, condition number");
    try_few("flux_divergence", 4, line, "has 4 neighbours, condition number");
    assert_int_equal(try_weights("flux_divergence", 2, three, &why), STATUS_OK);
}

static void pair_operators_refuse_anisotropy(void **state) {
    (void)state;
    static const char *const pairs[] = {"brookshaw", "brookshaw_corrected", "schwaiger", "kernel_second"};
    static const char *const others[] = {"fatehi_manzari", "cspm", "flux_divergence", "positive", "conjugate"};
    struct problem p = odd_rectangle(); /* k_x and k_y differ */
    struct options o = {.kernel = KERNEL_CUBIC};
    struct failure why;
    for (int m = 0; m < 4; m++)
        assert_int_equal(particles_check(&p, &o, named(pairs[m])->scheme, &why), STATUS_NOT_APPLICABLE);
    for (int m = 0; m < 5; m++) assert_int_equal(particles_check(&p, &o, named(others[m])->scheme, &why), 0);
}

/* ---- positive stencils ---- */

static double cost_of(const double *d) {
    double r = hypot(d[0], d[1]) / H, W = kernel_value(KERNEL_CUBIC, 2, r);
    return W > 0 ? r * r / W : INFINITY;
}

/* The cost of the weights of these five that meet the conditions; infinite where one of them is negative. */
static double cost_of_five(double (*d)[DIM_MAX], const int five[5], const double kappa[2]) {
    double A[25], b[5] = {0, 0, 2 * kappa[0] / (H * H), 2 * kappa[1] / (H * H), 0}, w[5], sum = 0;
    int sign;
    size_t order[5];
    gsl_permutation p = {5, order};
    for (int k = 0; k < 5; k++) {
        double x = d[five[k]][0] / H, y = d[five[k]][1] / H, all[5] = {x, y, x * x, y * y, x * y};
        for (int l = 0; l < 5; l++) A[5 * l + k] = all[l];
    }
    gsl_matrix_view M = gsl_matrix_view_array(A, 5, 5);
    gsl_vector_view right = gsl_vector_view_array(b, 5), out = gsl_vector_view_array(w, 5);
    gsl_linalg_LU_decomp(&M.matrix, &p, &sign);
    if (!(fabs(gsl_linalg_LU_det(&M.matrix, sign)) > 1e-9)) return INFINITY;
    gsl_linalg_LU_solve(&M.matrix, &p, &right.vector, &out.vector);
    for (int k = 0; k < 5; k++) {
        if (w[k] < 0) return INFINITY;
        sum += w[k] * cost_of(d[five[k]]);
    }
    return sum;
}

/* The least over all fives of n. */
static double least_cost(double (*d)[DIM_MAX], int n, const double kappa[2]) {
    double least = INFINITY;
    int f[5];
    for (f[0] = 0; f[0] < n; f[0]++)
        for (f[1] = f[0] + 1; f[1] < n; f[1]++)
            for (f[2] = f[1] + 1; f[2] < n; f[2]++)
                for (f[3] = f[2] + 1; f[3] < n; f[3]++)
                    for (f[4] = f[3] + 1; f[4] < n; f[4]++) least = fmin(least, cost_of_five(d, f, kappa));
    return least;
}

static void check_programme(double (*d)[DIM_MAX], int n, const double kappa[2]) {
    struct problem p = odd_rectangle();
    struct options o = {.kernel = KERNEL_CUBIC};
    struct neighbourhood nb = around(2, kappa);
    struct failure why;
    double w[2][MANY], *out[2] = {w[0], w[1]}, sum = 0, moment[5] = {0}, least = least_cost(d, n, kappa);
    nb.n = (size_t)n, nb.d = d;
    int status = operator_weights(named("positive")->scheme, &p, &o, &nb, out, &why);
    assert_int_equal(status, isfinite(least) ? STATUS_OK : STATUS_NUMERICAL);
    if (status) return;
    for (int j = 0; j < n; j++) {
        double x = d[j][0], y = d[j][1], all[5] = {x / H, y / H, x * x, y * y, x * y};
        assert_order(w[0][j], >=, 0);
        if (w[0][j] > 0) sum += w[0][j] * cost_of(d[j]);
        for (int k = 0; k < 5; k++) moment[k] += w[0][j] * all[k] * (k < 2 ? H * H : 1);
    }
    assert_near(sum / least, 1, 1e-8);
    for (int k = 0; k < 5; k++) assert_near(moment[k], k == 2 ? 2 * kappa[0] : k == 3 ? 2 * kappa[1] : 0, 1e-10);
}

static void nonnegative_weights_are_optimal(void **state) {
    (void)state;
    check_programme(place, MANY, (const double[2]){0.71, 0.43});
    check_programme(place, MANY, (const double[2]){0.71, 0.71});
}

static void nonnegative_weights_are_optimal_on_random_clouds(void **state) {
    (void)state;
    enum { DRAWS = 60, DRAWN = 11 };
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 11);
    for (int k = 0; k < DRAWS; k++) {
        double d[DRAWN][DIM_MAX] = {{0}};
        for (int j = 0; j < DRAWN; j++)
            for (int a = 0; a < 2; a++) d[j][a] = 3.2 * H * (gsl_rng_uniform(random) - 0.5);
        check_programme(d, DRAWN, (const double[2]){0.71, k % 2 ? 0.71 : 0.23});
    }
    gsl_rng_free(random);
}

/* ---- brookshaw ---- */

/* kappa = 0.7/1.3 left of x = 0.4 m and 0.2/0.9 right of it */
static struct problem two_halves(void) {
    struct problem p = odd_rectangle();
    p.materials = 2, p.interface = 0.4;
    p.material[0] = (struct material){{0.7, 0.7}, 1.3};
    p.material[1] = (struct material){{0.2, 0.2}, 0.9};
    return p;
}

static const double pair_dx = 0.05, pair_h = 0.061, pair[2] = {0.021, -0.037};

/* The weight that the particle at x has on one at x + pair, s^-1. */
static double weight(const struct problem *p, struct options o, double x) {
    double at[1][DIM_MAX] = {{pair[0], pair[1]}}, w[1], *out[2] = {w, NULL};
    struct failure why = {0};
    const struct scheme *scheme = method_brookshaw.scheme;
    struct neighbourhood nb = {.dim = 2,
                               .x = {x, 0.7},
                               .n = 1,
                               .d = at,
                               .h = pair_h,
                               .volume = scheme->volume(p, &o, pair_h, pair_dx * pair_dx)};
    nb.rho_c = layout_rho_c(p, 0, x);
    assert_int_equal(operator_weights(scheme, p, &o, &nb, out, &why), STATUS_OK);
    return w[0];
}

/* -(dW/dr) r/(r^2 + eta^2) of the cubic kernel in the plane, m^-4; r < pair_h */
static double F(void) {
    double r = hypot(pair[0], pair[1]), s = r / pair_h, slope = 15 / (7 * M_PI) * s * (2 - 1.5 * s);
    return slope / (pair_h * pair_h * pair_h) * r / (r * r + 0.01 * pair_h * pair_h);
}

static void raw_volume_weights(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct options o = {.dx = pair_dx, .volume = VOLUME_RAW};
    assert_near(weight(&p, o, 0.11) / (pair_dx * pair_dx * 2 * 0.7 * F() / 1.3), 1, 1e-14);
    assert_near(weight(&p, o, 0.77) / (pair_dx * pair_dx * 2 * 0.2 * F() / 0.9), 1, 1e-14);
}

static void conductivity_means_across_the_interface(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct options o = {.dx = pair_dx, .volume = VOLUME_RAW};
    const double x = 0.385, part = (0.4 - x) / pair[0],
                 unit = pair_dx * pair_dx * F() / 1.3; /* five sevenths are on the left */
    assert_near(weight(&p, o, x) / unit, 4 * 0.7 * 0.2 / 0.9, 1e-13);
    o.mean = MEAN_ARITHMETIC;
    assert_near(weight(&p, o, x) / unit, 0.9, 1e-13);
    o.mean = MEAN_SERIES;
    assert_near(weight(&p, o, x) / unit, 2 / (part / 0.7 + (1 - part) / 0.2), 1e-13);
}

/* V = area xi/N, N with the ghosts: 30 x 24 particles and two layers on each side. */
static void tuned_volume_scales_the_weights(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct options o = {.dx = pair_dx, .volume = VOLUME_TUNED};
    double unit = 2 * 0.7 * F() / 1.3, area = 1.5 * 1.2, N = 34 * 28;
    assert_near(weight(&p, o, 0.11) / unit, area * 9 * cbrt(pair_h) / N, 1e-14);
    o.xi = 1.71;
    assert_near(weight(&p, o, 0.11) / unit, area * 1.71 / N, 1e-14);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_fields_are_steady),
        cmocka_unit_test(quadratics_are_exact),
        cmocka_unit_test(positive_weights),
        cmocka_unit_test(second_moments_on_the_lattice),
        cmocka_unit_test(pair_operators_conserve_heat_on_clouds),
        cmocka_unit_test(poor_clouds_are_refused),
        cmocka_unit_test(pair_operators_refuse_anisotropy),
        cmocka_unit_test(nonnegative_weights_are_optimal),
        cmocka_unit_test(nonnegative_weights_are_optimal_on_random_clouds),
        cmocka_unit_test(raw_volume_weights),
        cmocka_unit_test(conductivity_means_across_the_interface),
        cmocka_unit_test(tuned_volume_scales_the_weights),
    };
    return cmocka_run_group_tests_name("laplacians", tests, NULL, NULL);
}
