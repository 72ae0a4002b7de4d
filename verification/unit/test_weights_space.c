/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights of the particle methods in space, on neighbourhoods without symmetry: exactness, symmetry of pairs, signs,
 * exchange of axes; volumes that are exact on the lattice; quadratics across an interface. */

#include "solver/method.h"
#include "solver/particles/particles.h"
#include "solver/particles/ssph.h"

#include "verification/unit/near.h"

#include <gsl/gsl_rng.h>

enum { CLOUDS = 7, POINTS = 180 };
static const double H = 0.061, SPREAD = 2.2; /* m; h */

static struct problem box(void) {
    return (struct problem){.dim = 3,
                            .hi = {1.5, 1.2, 0.9},
                            .materials = 1,
                            .material = {{{0.7, 0.4, 1.1}, 1.3}},
                            .initial = problem_start,
                            .wall = problem_held};
}

/* A random cloud about a particle, in a cube a little wider than the support. */
static struct neighbourhood draw(unsigned long seed, double d[POINTS][DIM_MAX], const struct material *m) {
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, seed);
    for (int j = 0; j < POINTS; j++)
        for (int a = 0; a < 3; a++) d[j][a] = 2 * SPREAD * H * (gsl_rng_uniform(random) - 0.5);
    gsl_rng_free(random);
    struct neighbourhood nb = {.dim = 3, .i = 3, .x = {0.7, 0.3, 0.4}, .n = POINTS, .d = d, .h = H};
    nb.volume = 1.1e-5, nb.rho_c = m->rho_c;
    for (int a = 0; a < 3; a++) nb.kappa[a] = m->k[a] / m->rho_c;
    return nb;
}

static int try_weights(const char *name, const struct problem *p, const struct options *o,
                       const struct neighbourhood *nb, double w[3][POINTS], struct failure *why) {
    double *out[3] = {w[0], w[1], w[2]};
    return operator_weights(method_find(name)->scheme, p, o, nb, out, why);
}

static void weights_of(const char *name, const struct problem *p, const struct options *o,
                       const struct neighbourhood *nb, double w[3][POINTS]) {
    struct failure why = {0};
    if (try_weights(name, p, o, nb, w, &why)) fail_msg("%s: %s", name, why.text);
}

/* sum_j w_j d_j^e, in units of h */
static double moment(const struct neighbourhood *nb, const double *w, int a, int b, int c) {
    double sum = 0;
    for (size_t j = 0; j < nb->n; j++) sum += w[j] * pow(nb->d[j][0], a) * pow(nb->d[j][1], b) * pow(nb->d[j][2], c);
    return sum / pow(H, a + b + c);
}

/* kappa . the second derivatives of the monomial at the particle, in units of h */
static double expected(const struct neighbourhood *nb, const int e[3]) {
    if (e[0] + e[1] + e[2] != 2) return 0;
    for (int a = 0; a < 3; a++)
        if (e[a] == 2) return 2 * nb->kappa[a] / (H * H);
    return 0;
}

static void check_exact(const char *name, int order, const struct neighbourhood *nb, double *w) {
    for (int degree = 1; degree <= order; degree++)
        for (int c = 0; c <= degree; c++)
            for (int b = 0; b <= degree - c; b++) {
                const int e[3] = {degree - b - c, b, c};
                double got = moment(nb, w, e[0], e[1], e[2]), want = expected(nb, e);
                if (!(fabs(got - want) <= 1e-7)) print_error("%s: x^%d y^%d z^%d\n", name, e[0], e[1], e[2]);
                assert_near(got, want, 1e-7); /* kappa/h^2 is 200 s^-1 */
            }
}

static void polynomials_are_exact(void **state) {
    (void)state;
    static const char *const names[] = {"so_ssph", "fatehi_manzari", "positive", "contact_ssph"};
    double d[POINTS][DIM_MAX], w[3][POINTS];
    struct problem p = box();
    for (unsigned long seed = 1; seed <= CLOUDS; seed++) {
        struct neighbourhood nb = draw(seed, d, &p.material[0]);
        for (int k = 0; k < 4; k++) {
            weights_of(names[k], &p, &(struct options){0}, &nb, w);
            check_exact(names[k], 2, &nb, w[0]);
        }
        for (int order = 3; order <= 4; order++) {
            weights_of("so_ssph", &p, &(struct options){.order = order}, &nb, w);
            check_exact("so_ssph", order, &nb, w[0]);
        }
    }
}

static void first_derivatives_of_linear_fields_are_exact(void **state) {
    (void)state;
    double d[POINTS][DIM_MAX], w[3][POINTS];
    struct problem p = box();
    for (unsigned long seed = 1; seed <= CLOUDS; seed++) {
        struct neighbourhood nb = draw(seed, d, &p.material[0]);
        weights_of("fo_ssph", &p, &(struct options){0}, &nb, w);
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) assert_near(H * moment(&nb, w[a], b == 0, b == 1, b == 2), a == b, 1e-12);
    }
}

static void positive_weights_are_never_negative(void **state) {
    (void)state;
    double d[POINTS][DIM_MAX], w[3][POINTS];
    struct problem p = box();
    for (unsigned long seed = 1; seed <= 4 * CLOUDS; seed++) {
        struct neighbourhood nb = draw(seed, d, &p.material[0]);
        size_t used = 0;
        weights_of("positive", &p, &(struct options){0}, &nb, w);
        for (size_t j = 0; j < nb.n; j++) {
            assert_order(w[0][j], >=, 0);
            used += w[0][j] > 0;
        }
        assert_order(used, <=, 9); /* a vertex of the programme */
    }
}

static void half_neighbourhoods_and_planes_are_refused(void **state) {
    (void)state;
    double d[POINTS][DIM_MAX], w[3][POINTS];
    struct problem p = box();
    struct failure why;
    struct neighbourhood nb = draw(1, d, &p.material[0]);
    for (size_t j = 0; j < nb.n; j++) d[j][2] = fabs(d[j][2]);
    assert_int_equal(try_weights("positive", &p, &(struct options){0}, &nb, w, &why), STATUS_NUMERICAL);
    assert_has(why.text, "particle 3 at (0.7, 0.3, 0.4) m has 180 neighbours");
    for (size_t j = 0; j < nb.n; j++) d[j][2] = d[j][0] + 2 * d[j][1];
    assert_int_equal(try_weights("so_ssph", &p, &(struct options){0}, &nb, w, &why), STATUS_NUMERICAL);
    assert_has(why.text, "particle 3 at (0.7, 0.3, 0.4) m has 180 neighbours for 9 unknowns, condition number");
    assert_int_equal(try_weights("fatehi_manzari", &p, &(struct options){0}, &nb, w, &why), STATUS_NUMERICAL);
}

/* The factors of two sweeps, and Brookshaw's weights, depend on a pair's distance alone. */
static void pair_weights_are_symmetric(void **state) {
    (void)state;
    static const char *const twice[] = {"fo_ssph", "flux_divergence", "conjugate"};
    double d[POINTS][DIM_MAX], back[POINTS][DIM_MAX], w[3][POINTS], v[3][POINTS], F[POINTS], G[POINTS];
    double C[DIM_MAX][DIM_MAX];
    struct problem p = box();
    struct options o = {0};
    struct failure why;
    struct material same = {{0.7, 0.7, 0.7}, 1.3};
    p.material[0] = same;
    struct neighbourhood nb = draw(1, d, &same), other = nb;
    for (int j = 0; j < POINTS; j++)
        for (int a = 0; a < 3; a++) back[j][a] = -d[j][a];
    other.d = back;
    weights_of("brookshaw", &p, &o, &nb, w);
    weights_of("brookshaw", &p, &o, &other, v);
    assert_memory_equal(w[0], v[0], sizeof w[0]);
    for (int k = 0; k < 3; k++) {
        const struct scheme *s = method_find(twice[k])->scheme;
        assert_int_equal(s->pairs(&p, &o, &nb, F, C, &why), STATUS_OK);
        assert_int_equal(s->pairs(&p, &o, &other, G, C, &why), STATUS_OK);
        assert_memory_equal(F, G, sizeof F);
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) assert_near(C[a][b], C[b][a], 0);
    }
}

/* The response of a lattice to x^2, y^2 and z^2 for `--volume moment`. */
static void moment_volume_is_exact_on_the_lattice(void **state) {
    (void)state;
    static const double h[] = {0.93, 1.1, 1.74};
    static double d[NEIGHBOURS_MAX][DIM_MAX], weight[3][NEIGHBOURS_MAX];
    struct problem p = box();
    p.material[0] = (struct material){{0.7, 0.7, 0.7}, 1.3};
    for (int k = 0; k < 3; k++) {
        struct options o = {.h = h[k]};
        struct failure why;
        struct neighbourhood nb = {.dim = 3, .d = d, .h = h[k] * 0.05, .rho_c = 1.3, .kappa = {0.7 / 1.3}};
        for (int c = -4; c <= 4; c++)
            for (int b = -4; b <= 4; b++)
                for (int a = -4; a <= 4; a++) {
                    if (a * a + b * b + c * c == 0 || a * a + b * b + c * c >= 4 * h[k] * h[k]) continue;
                    d[nb.n][0] = 0.05 * a, d[nb.n][1] = 0.05 * b, d[nb.n++][2] = 0.05 * c;
                }
        const struct scheme *s = method_find("brookshaw")->scheme;
        nb.volume = s->volume(&p, &o, nb.h, pow(0.05, 3));
        double *out[3] = {weight[0], weight[1], weight[2]};
        assert_int_equal(operator_weights(s, &p, &o, &nb, out, &why), STATUS_OK);
        assert_near(moment(&nb, weight[0], 2, 0, 0) * H * H, 2 * 0.7 / 1.3, 1e-12);
        assert_near(moment(&nb, weight[0], 0, 0, 2) * H * H, 2 * 0.7 / 1.3, 1e-12);
        const struct scheme *twice = method_find("flux_divergence")->scheme;
        nb.volume = twice->volume(&p, &o, nb.h, pow(0.05, 3));
        assert_int_equal(operator_weights(twice, &p, &o, &nb, out, &why), STATUS_OK);
        assert_near(moment(&nb, weight[2], 0, 0, 1) * H, 1, 1e-12);
    }
}

/* x, y, z -> y, z, x of cloud and conductivities: the same weights up to round-off. */
static void exchange_of_axes_changes_no_weight(void **state) {
    (void)state;
    static const char *const names[] = {"so_ssph",   "fatehi_manzari",      "positive", "schwaiger",
                                        "brookshaw", "brookshaw_corrected", "cspm"};
    double d[POINTS][DIM_MAX], turned[POINTS][DIM_MAX], w[3][POINTS], v[3][POINTS];
    for (int k = 0; k < 7; k++) {
        struct problem p = box(), q = box();
        if (method_find(names[k])->scheme->isotropic) p.material[0] = (struct material){{0.7, 0.7, 0.7}, 1.3};
        for (int a = 0; a < 3; a++) q.material[0].k[a] = p.material[0].k[(a + 1) % 3];
        struct neighbourhood nb = draw(2, d, &p.material[0]), other = draw(2, turned, &q.material[0]);
        for (int j = 0; j < POINTS; j++)
            for (int a = 0; a < 3; a++) turned[j][a] = d[j][(a + 1) % 3];
        weights_of(names[k], &p, &(struct options){0}, &nb, w);
        weights_of(names[k], &q, &(struct options){0}, &other, v);
        double most = 0;
        for (int j = 0; j < POINTS; j++) most = fmax(most, fabs(w[0][j]));
        assert_order(most, >, 1);
        for (int j = 0; j < POINTS; j++) assert_near(w[0][j], v[0][j], 1e-9 * most);
    }
}

/* A field quadratic on either side of x = 0.7 + `beyond` with continuous T, k_x T_x and T_t, at x. */
static double across(const struct problem *p, const double c[10], const double *at) {
    const struct material *m = &p->material[0], *o = &p->material[1];
    double xi = at[0] - p->interface, y = at[1], z = at[2], b = 0;
    double kappa[3], other[3];
    for (int a = 0; a < 3; a++) kappa[a] = m->k[a] / m->rho_c, other[a] = o->k[a] / o->rho_c;
    double along = c[1] + c[4] * y + c[5] * z, curved = c[6];
    if (xi >= 0) {
        double t = kappa[0] * c[6] + (kappa[1] - other[1]) * c[7] + (kappa[2] - other[2]) * c[8];
        along *= m->k[0] / o->k[0], curved = t / other[0];
    }
    b = c[0] + c[2] * y + c[3] * z + c[7] * y * y + c[8] * z * z + c[9] * y * z;
    return b + along * xi + curved * xi * xi;
}

static void quadratics_across_an_interface_are_exact(void **state) {
    (void)state;
    static const double beyond[] = {-0.06, -0.003, 0.0007, 0.05};
    double d[POINTS][DIM_MAX], w[3][POINTS];
    struct problem p = box();
    p.materials = 2, p.material[1] = (struct material){{0.21, 0.9, 0.53}, 0.87};
    for (int k = 0; k < 4; k++)
        for (int term = 0; term < 10; term++) {
            p.interface = 0.7 + beyond[k];
            const struct material *own = &p.material[beyond[k] <= 0];
            struct neighbourhood nb = draw(5, d, own);
            double c[10] = {0}, sum = 0;
            c[term] = 1.37;
            weights_of("contact_ssph", &p, &(struct options){0}, &nb, w);
            for (size_t j = 0; j < nb.n; j++) {
                double at[3] = {nb.x[0] + d[j][0], nb.x[1] + d[j][1], nb.x[2] + d[j][2]};
                sum += w[0][j] * (across(&p, c, at) - across(&p, c, nb.x));
            }
            const struct material *m = &p.material[0];
            double rate = 2 * (m->k[0] * c[6] + m->k[1] * c[7] + m->k[2] * c[8]) / m->rho_c;
            assert_near(sum, rate, 1e-9);
        }
}

static void methods_of_the_plane_are_refused(void **state) {
    (void)state;
    static const char *const names[] = {"kernel_second", "voronoi_flux"};
    for (int k = 0; k < 2; k++) {
        struct problem p = box();
        struct failure why;
        struct options o = {.dx = 0.1, .h = 1.1, .layout = LAYOUT_JITTER, .jitter = 0.2};
        p.material[0] = (struct material){{0.7, 0.7, 0.7}, 1.3};
        assert_int_equal(particles_check(&p, &o, method_find(names[k])->scheme, &why), STATUS_NOT_APPLICABLE);
        assert_has(why.text, names[k]);
        assert_has(why.text, "use so_ssph");
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_are_exact),
        cmocka_unit_test(first_derivatives_of_linear_fields_are_exact),
        cmocka_unit_test(positive_weights_are_never_negative),
        cmocka_unit_test(half_neighbourhoods_and_planes_are_refused),
        cmocka_unit_test(pair_weights_are_symmetric),
        cmocka_unit_test(moment_volume_is_exact_on_the_lattice),
        cmocka_unit_test(exchange_of_axes_changes_no_weight),
        cmocka_unit_test(quadratics_across_an_interface_are_exact),
        cmocka_unit_test(methods_of_the_plane_are_refused),
    };
    return cmocka_run_group_tests_name("weights in space", tests, NULL, NULL);
}
