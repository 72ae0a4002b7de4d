/* The discrete Laplacians on neighbourhoods without any symmetry: what each must have exactly, each against its
 * formula written out step by step for a field of odd numbers, which of them conserve heat, and what they refuse. */
#include "solver/methods/particles.h"
#include "solver/space/csr.h"
#include "solver/space/kernel.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

enum { MANY = 15 };
static const double H = 0.061, KX = 0.71, KY = 0.43;

/* Neighbours with no symmetry, 0.02 to 0.12 m away, and their temperatures less that of the particle. */
static double place[MANY][2] = {{0.041, 0.013},  {-0.052, 0.007}, {0.003, 0.049},  {-0.011, -0.055},
                                {0.063, -0.038}, {-0.047, 0.058}, {0.034, 0.071},  {-0.069, -0.041},
                                {0.083, 0.029},  {-0.089, 0.019}, {0.017, -0.101}, {-0.021, 0.093},
                                {0.022, -0.029}, {0.097, -0.011}, {-0.027, 0.023}};
static const double field[MANY] = {1.31, -0.72, 0.41,  2.17, -1.13, 0.93, 0.29, -2.31,
                                   0.57, 1.91,  -0.37, 0.83, -1.47, 1.03, 0.67};
static const double volume[MANY] = {0.0023, 0.0029, 0.0019, 0.0031, 0.0027, 0.0021, 0.0025, 0.0033,
                                    0.0022, 0.0026, 0.0030, 0.0024, 0.0028, 0.0020, 0.0032};

static const struct method *named(const char *name) {
    for (int i = 0; methods[i]; i++)
        if (strcmp(methods[i]->name, name) == 0) return methods[i];
    return NULL;
}

static struct neighbourhood around(int dim, const double kappa[2]) {
    return (struct neighbourhood){.dim = dim,
                                  .i = 3,
                                  .n = MANY,
                                  .d = place,
                                  .h = H,
                                  .volume = 0.0017,
                                  .V = volume,
                                  .rho_c = 1.3,
                                  .kappa = {kappa[0], kappa[1]}};
}

static void weights_of(const char *name, const struct neighbourhood *nb, double w[2][MANY]) {
    struct problem p = odd_rectangle();
    struct options o = {.kernel = KERNEL_CUBIC};
    struct failure why = {0};
    double *out[2] = {w[0], w[1]};
    if (named(name)->scheme->weights(&p, &o, nb, out, &why)) print_error("%s\n", why.text);
    assert_int_equal(why.status, STATUS_OK);
}

/* sum_j w_j x_j^a y_j^b */
static double moment(const double *w, int a, int b) {
    double sum = 0;
    for (int j = 0; j < MANY; j++) sum += w[j] * pow(place[j][0], a) * pow(place[j][1], b);
    return sum;
}

static const double both[2] = {0.71, 0.43}, same[2] = {0.71, 0.71};

static void linear_fields_stay(void **state) {
    (void)state;
    static const char *const exact[] = {"schwaiger", "fatehi_manzari", "cspm", "so_ssph"};
    static const char *const not [] = {"brookshaw", "brookshaw_corrected", "kernel_second"};
    double w[2][MANY];
    struct neighbourhood nb = around(2, same);
    for (int k = 0; k < 4; k++) {
        weights_of(exact[k], &nb, w);
        assert_near(moment(w[0], 1, 0), 0, 1e-10);
        assert_near(moment(w[0], 0, 1), 0, 1e-10);
    }
    for (int k = 0; k < 3; k++) {
        weights_of(not [k], &nb, w);
        assert_true(fabs(moment(w[0], 1, 0)) > 0.1);
    }
}

static void quadratics_are_exact(void **state) {
    (void)state;
    static const char *const exact[] = {"fatehi_manzari", "so_ssph"};
    double w[2][MANY];
    struct neighbourhood nb = around(2, both);
    for (int k = 0; k < 2; k++) {
        weights_of(exact[k], &nb, w);
        assert_near(moment(w[0], 2, 0), 2 * KX, 1e-12);
        assert_near(moment(w[0], 0, 2), 2 * KY, 1e-12);
        assert_near(moment(w[0], 1, 1), 0, 1e-12);
    }
    nb = around(2, same);
    weights_of("brookshaw_corrected", &nb, w); /* of the distance's square alone */
    assert_near(moment(w[0], 2, 0) + moment(w[0], 0, 2), 4 * KX, 1e-12);
    assert_true(fabs(moment(w[0], 2, 0) - moment(w[0], 0, 2)) > 0.01);
    weights_of("cspm", &nb, w);
    assert_true(fabs(moment(w[0], 2, 0) - 2 * KX) > 0.001);
}

static void positive_weights(void **state) {
    (void)state;
    double w[2][MANY];
    struct neighbourhood nb = around(2, same);
    weights_of("brookshaw_corrected", &nb, w);
    for (int j = 0; j < MANY; j++) assert_true(w[0][j] >= 0);
}

/* ---- The formulas, step by step and in metres, for the cubic kernel in the plane ---- */

static double slope(double r) { /* dW/dr, m^-3 */
    double s = r / H, a = 15 / (7 * M_PI);
    return (s < 1 ? -a * (2 * s - 1.5 * s * s) : s < 2 ? -a / 2 * (2 - s) * (2 - s) : 0) / (H * H * H);
}

static double bend(double r) { /* d2W/dr2, m^-4 */
    double s = r / H, a = 15 / (7 * M_PI);
    return (s < 1 ? -a * (2 - 3 * s) : s < 2 ? a * (2 - s) : 0) / (H * H * H * H);
}

/* The corrected gradient of f, K/m, by Cramer's rule. */
static void gradient(const double *f, double g[2]) {
    double m[3] = {0, 0, 0}, b[2] = {0, 0};
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], c = -volume[j] * slope(hypot(x, y)) / hypot(x, y);
        m[0] += c * x * x, m[1] += c * x * y, m[2] += c * y * y;
        b[0] += c * x * f[j], b[1] += c * y * f[j];
    }
    double det = m[0] * m[2] - m[1] * m[1];
    g[0] = (m[2] * b[0] - m[1] * b[1]) / det, g[1] = (m[0] * b[1] - m[1] * b[0]) / det;
}

/* What f has beside its corrected gradient at neighbour j, K. */
static double beyond(const double *f, const double g[2], int j) {
    return f[j] - g[0] * place[j][0] - g[1] * place[j][1];
}

static double schwaiger(const double *f) {
    double g[2], sum = 0, m[3] = {0, 0, 0};
    gradient(f, g);
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], c = -volume[j] * slope(hypot(x, y)) / hypot(x, y);
        sum += 2 * c * beyond(f, g, j);
        m[0] += c * x * x, m[1] += c * x * y, m[2] += c * y * y;
    }
    return KX * (m[0] + m[2]) / (m[0] * m[2] - m[1] * m[1]) / 2 * sum;
}

typedef void components(const double *f, double S[3]);

static void fatehi_components(const double *f, double S[3]) {
    double g[2];
    gradient(f, g);
    S[0] = S[1] = S[2] = 0;
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], r = hypot(x, y);
        double c = -volume[j] * slope(r) / r * beyond(f, g, j);
        S[0] += c * x * x / (r * r), S[1] += c * x * y / (r * r), S[2] += c * y * y / (r * r);
    }
}

/* g: the gradient that is taken off, or NULL */
static void cspm_sums(const double *f, const double g[2], double S[3]) {
    S[0] = S[1] = S[2] = 0;
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], r = hypot(x, y), w1 = slope(r), w2 = bend(r);
        double rest = volume[j] * (g ? beyond(f, g, j) : f[j]);
        S[0] += rest * (w2 * x * x / (r * r) + w1 * y * y / (r * r * r));
        S[1] += rest * (w2 - w1 / r) * x * y / (r * r);
        S[2] += rest * (w2 * y * y / (r * r) + w1 * x * x / (r * r * r));
    }
}

static void cspm_components(const double *f, double S[3]) {
    double g[2];
    gradient(f, g);
    cspm_sums(f, g, S);
}

static void cspm_matrix(const double *f, double S[3]) {
    cspm_sums(f, NULL, S);
}

static double determinant(double a[3][3]) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/* KX T_xx + KY T_yy from S = K (T_xx, T_xy, T_yy), by Cramer's rule. */
static double solved(const double *f, components *right, components *left) {
    double K[3][3], S[3], column[3], got[3];
    right(f, S);
    for (int n = 0; n < 3; n++) {
        double q[MANY];
        for (int j = 0; j < MANY; j++) {
            double x = place[j][0], y = place[j][1];
            q[j] = n == 0 ? x * x / 2 : n == 1 ? x * y : y * y / 2;
        }
        left(q, column);
        for (int m = 0; m < 3; m++) K[m][n] = column[m];
    }
    for (int n = 0; n < 3; n++) {
        double swapped[3][3];
        memcpy(swapped, K, sizeof K);
        for (int m = 0; m < 3; m++) swapped[m][n] = S[m];
        got[n] = determinant(swapped) / determinant(K);
    }
    return KX * got[0] + KY * got[2];
}

static double applied(const char *name, const double kappa[2]) {
    struct neighbourhood nb = around(2, kappa);
    double w[2][MANY], sum = 0;
    weights_of(name, &nb, w);
    for (int j = 0; j < MANY; j++) sum += w[0][j] * field[j];
    return sum;
}

static void as_the_formulas_say(void **state) {
    (void)state;
    assert_near(applied("schwaiger", same) / schwaiger(field), 1, 1e-12);
    assert_near(applied("fatehi_manzari", both) / solved(field, fatehi_components, fatehi_components), 1, 1e-11);
    assert_near(applied("cspm", both) / solved(field, cspm_components, cspm_matrix), 1, 1e-11);
    double pairs = 0, corrected = 0, m[3] = {0, 0, 0};
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], r = hypot(x, y), c = -volume[j] * slope(r) / r;
        pairs += KX * volume[j] * field[j] * (bend(r) + slope(r) / r);
        m[0] += c * x * x, m[1] += c * x * y, m[2] += c * y * y;
    }
    assert_near(applied("kernel_second", same) / pairs, 1, 1e-12);
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], r = hypot(x, y), det = m[0] * m[2] - m[1] * m[1];
        double form = (m[2] * x * x - 2 * m[1] * x * y + m[0] * y * y) / det;
        corrected -= 2 * KX * volume[j] * slope(r) / (r * r * r) * form * field[j];
    }
    assert_near(applied("brookshaw_corrected", same) / corrected, 1, 1e-12);
}

static void fluxes_by_the_kernels_gradient(void **state) {
    (void)state;
    double w[2][MANY];
    struct neighbourhood nb = around(2, both);
    weights_of("flux_divergence", &nb, w);
    for (int j = 0; j < MANY; j++) {
        double r = hypot(place[j][0], place[j][1]);
        for (int a = 0; a < 2; a++) assert_near(w[a][j], -volume[j] * slope(r) * place[j][a] / r, 1e-12 / H);
    }
}

static void second_derivatives_of_kernels(void **state) {
    (void)state;
    for (int k = 0; kernel_words[k]; k++)
        for (int dim = 1; dim <= 2; dim++)
            for (double s = 0.037; s < 2; s += 0.113) {
                const double e = 1e-5;
                double low = kernel_slope((enum kernel_name)k, dim, s - e);
                double high = kernel_slope((enum kernel_name)k, dim, s + e);
                if ((s - 1 - e) * (s - 1 + e) < 0) continue; /* a corner of the cubic kernel's */
                assert_near(kernel_curvature((enum kernel_name)k, dim, s), (high - low) / (2 * e), 1e-8);
            }
}

/* ---- On lattices, through operator and rows ---- */

static void second_moments_on_the_lattice(void **state) {
    (void)state;
    static const char *const all[] = {"brookshaw_corrected", "schwaiger",      "fatehi_manzari", "cspm",
                                      "kernel_second",       "flux_divergence"};
    for (int m = 0; m < 6; m++)
        for (int k = 0; kernel_words[k]; k++) {
            struct options o = {.dx = 0.05, .h = 1.23, .kernel = (enum kernel_name)k};
            struct problem p = odd_rectangle();
            struct failure why;
            int reach[2];
            double *w, sum[3] = {0, 0, 0};
            assert_int_equal(operator_stencil(&p, &o, named(all[m])->scheme, 1, same, reach, &w, &why), STATUS_OK);
            for (int j = -reach[1]; j <= reach[1]; j++)
                for (int i = -reach[0]; i <= reach[0]; i++) {
                    double v = w[abs(j) * (reach[0] + 1) + abs(i)];
                    sum[0] += v * i * i, sum[1] += v * j * j, sum[2] += v;
                }
            free(w);
            assert_near(sum[0], 2 * KX, 1e-11);
            assert_near(sum[1], 2 * KX, 1e-11);
            assert_near(sum[2], 0, 1e-12);
        }
}

static double no_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
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
    assert_int_equal(layout_lattice(&p, &o, 1, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&p, &o, &l, s->sweeps * 2 * o.h * l.dx[0], &c, &why), STATUS_OK);
    assert_int_equal(operator_create_csr(&a, &p, &o, s, &c, l.dx[0], &why), STATUS_OK);
    double *sum = xcalloc(a.n, sizeof *sum), most = 0, size = 0;
    struct row r;
    csr_row_create(&r, a.n);
    for (size_t i = 0; i < a.n; i++) {
        operator_row_take(&a, i, &r);
        size = fmax(size, fabs(r.value[i]));
        for (size_t k = 0; k < r.n; k++) sum[r.column[k]] += r.value[r.column[k]];
    }
    csr_row_free(&r);
    for (size_t i = 0; i < a.n; i++) most = fmax(most, fabs(sum[i]));
    free(sum);
    operator_free(&a);
    layout_cloud_free(&c);
    return most / size;
}

static void who_conserves_heat(void **state) {
    (void)state;
    static const char *const all[] = {"brookshaw",           "kernel_second", "so_ssph",        "fo_ssph",
                                      "brookshaw_corrected", "schwaiger",     "fatehi_manzari", "cspm",
                                      "flux_divergence"};
    for (int m = 0; m < 9; m++) {
        assert_near(lost(all[m], 0), 0, 1e-13);
        if (m < 2)
            assert_near(lost(all[m], 0.31), 0, 1e-13);
        else
            assert_true(lost(all[m], 0.31) > 0.01);
    }
}

/* ---- Refusals ---- */

static int try_weights(const char *name, size_t n, double (*d)[2], struct failure *why) {
    struct problem p = odd_rectangle();
    struct options o = {.kernel = KERNEL_CUBIC};
    double w[2][MANY], *out[2] = {w[0], w[1]};
    struct neighbourhood nb = around(2, same);
    nb.n = n, nb.d = d;
    return named(name)->scheme->weights(&p, &o, &nb, out, why);
}

static void try_few(const char *name, size_t n, double (*d)[2], const char *says) {
    struct failure why = {0};
    assert_int_equal(try_weights(name, n, d, &why), STATUS_NUMERICAL);
    assert_non_null(strstr(why.text, "particle 3 at"));
    assert_non_null(strstr(why.text, says));
}

static void poor_clouds_are_refused(void **state) {
    (void)state;
    static const char *const corrected[] = {"brookshaw_corrected", "schwaiger", "fatehi_manzari", "cspm"};
    double line[4][2] = {{0.021, 0.042}, {-0.017, -0.034}, {0.043, 0.086}, {-0.03, -0.06}};
    double right[5][2] = {{0.041, 0.013}, {0.003, 0.049}, {0.011, -0.055}, {0.063, -0.038}, {0.021, 0.007}};
    struct failure why;
    double three[2][2] = {{0.041, 0.013}, {0.003, 0.049}}, twice[2][2] = {{0.041, 0.013}, {0, 0}};
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
    right[4][0] = -0.011, right[4][1] = 0.018; /* leaves a gap of 160 degrees */
    assert_int_equal(try_weights("kernel_second", 5, right, &why), STATUS_OK);
    try_few("flux_divergence", 0, place, "has 0 neighbours, condition number infinite");
    try_few("flux_divergence", 1, place, "has 1 neighbours, condition number");
    try_few("flux_divergence", 4, line, "has 4 neighbours, condition number");
    assert_int_equal(try_weights("flux_divergence", 2, three, &why), STATUS_OK);
}

static void what_cannot_be_had_is_refused(void **state) {
    (void)state;
    static const char *const all[] = {"brookshaw_corrected", "schwaiger", "kernel_second",
                                      "fatehi_manzari",      "cspm",      "flux_divergence"};
    struct options o = {.kernel = KERNEL_CUBIC};
    struct failure why;
    for (int m = 0; m < 6; m++) {
        struct problem p = odd_rectangle(); /* k_x and k_y differ */
        assert_int_equal(named(all[m])->scheme->check(&p, &o, &why), m < 3 ? STATUS_NOT_APPLICABLE : STATUS_OK);
        p.materials = 2;
        assert_int_equal(named(all[m])->scheme->check(&p, &o, &why), STATUS_NOT_APPLICABLE);
        assert_non_null(strstr(why.text, "use brookshaw"));
    }
    o.volume = VOLUME_TUNED;
    struct problem p = odd_rod();
    assert_int_equal(named("kernel_second")->scheme->check(&p, &o, &why), STATUS_NOT_APPLICABLE);
    assert_int_equal(named("flux_divergence")->scheme->check(&p, &o, &why), STATUS_NOT_APPLICABLE);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_fields_stay),
        cmocka_unit_test(quadratics_are_exact),
        cmocka_unit_test(positive_weights),
        cmocka_unit_test(as_the_formulas_say),
        cmocka_unit_test(fluxes_by_the_kernels_gradient),
        cmocka_unit_test(second_derivatives_of_kernels),
        cmocka_unit_test(second_moments_on_the_lattice),
        cmocka_unit_test(who_conserves_heat),
        cmocka_unit_test(poor_clouds_are_refused),
        cmocka_unit_test(what_cannot_be_had_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
