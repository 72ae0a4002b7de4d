/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Limits, symbols and amplification factors compared with closed forms. */
#include "solver/method.h" /* before cmocka.h, which makes a macro of `fail` */
#include "verification/stability/long_run.h"
#include "verification/stability/step_limit.h"
#include "verification/stability/maximum_principle.h"
#include "verification/stability/spectrum.h"
#include "verification/stability/symbol.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_legendre.h>
#include <math.h>

extern const struct method method_so_ssph, method_fo_ssph, method_brookshaw, method_ftcs, method_ftcs_flux;

static struct model_problem probe(const struct method *m, int dim, double h) {
    struct model_problem b = {.method = m, .dim = dim, .options = {.h = h}};
    struct failure why;
    if (step_limit_model(&b, &why)) fail_msg("%s", why.text);
    return b;
}

static struct step_limit predicted(const struct model_problem *b) {
    struct step_limit l;
    struct failure why;
    if (step_limit_predict(b, &l, &why)) fail_msg("%s", why.text);
    return l;
}

/* -4 sin^2(theta/2) and -sin^2(theta) along each axis: limits 1/(2 d) and 2/d. */
static void finite_differences_have_their_symbols(void **state) {
    (void)state;
    const double theta[DIM_MAX] = {1.37, -0.59, 0.83};
    for (int dim = 1; dim <= DIM_MAX; dim++) {
        struct model_problem direct = probe(&method_ftcs, dim, 0), flux = probe(&method_ftcs_flux, dim, 0);
        struct symbol s[2];
        struct failure why;
        double want[2] = {0, 0};
        for (int a = 0; a < dim; a++) {
            want[0] -= 4 * pow(sin(theta[a] / 2), 2);
            want[1] -= pow(sin(theta[a]), 2);
        }
        assert_int_equal(symbol_create(&s[0], &direct, &why), STATUS_OK);
        assert_int_equal(symbol_create(&s[1], &flux, &why), STATUS_OK);
        for (int k = 0; k < 2; k++) {
            assert_near(creal(symbol_at(&s[k], theta)), want[k], 1e-13);
            assert_near(cimag(symbol_at(&s[k], theta)), 0, 1e-13);
            symbol_free(&s[k]);
        }
        assert_near(predicted(&direct).von_neumann, 0.5 / dim, 1e-12);
        assert_near(predicted(&flux).von_neumann, 2.0 / dim, 1e-11);
        if (dim < 3) assert_near(predicted(&direct).published, 0.25 * dim, 0); /* Pamplona eq. 17 */
        assert_nan(predicted(&flux).published);
    }
}

/* Slower along y: 1/(2 (1 + r)) and 2/(1 + r); Song eq. 34 is 1/|w_0| = 1/(q (1 + r)) of an isotropic 1/(2 q). */
static void limits_of_two_diffusivities(void **state) {
    (void)state;
    const double r = 0.37;
    const struct method *const all[] = {&method_ftcs, &method_ftcs_flux, &method_so_ssph};
    for (int m = 0; m < 3; m++) {
        struct model_problem b = {.method = all[m], .dim = 2, .ratio = r, .options = {.walls = m ? WALLS_FIXED : 0}};
        struct failure why;
        double measured;
        assert_int_equal(step_limit_model(&b, &why), STATUS_OK);
        struct step_limit l = predicted(&b);
        if (m < 2) assert_near(l.von_neumann, (m ? 2 : 0.5) / (1 + r), 1e-11);
        struct model_problem even = b;
        even.ratio = 1;
        if (m == 2) assert_near(l.published, predicted(&even).published * 2 / (1 + r), 1e-12);
        assert_int_equal(step_limit_measure(&b, &measured, &why), STATUS_OK);
        assert_near(measured / l.von_neumann, 1, 0.02);
    }
}

/* A field at any angle (the head of ftcs_cross.c): fluxes at faces 1/(2 trace K), those at corners 1/(2 the largest
 * K_aa).  Along x it is the diagonal problem.  A run of so_ssph and its symbol agree. */
static void limits_follow_the_angle_of_a_field(void **state) {
    (void)state;
    const double r = 0.137, angle = 152;
    for (int m = 0; m < 3; m++) {
        const struct options o = {.cross = m == 1 ? CROSS_CORNER : CROSS_FACE};
        struct model_problem b;
        struct failure why;
        double measured, largest = r + (1 - r) * pow(cos(angle * M_PI / 180), 2);
        if (step_limit_setup(m < 2 ? &method_ftcs : &method_so_ssph, &o, 2, r, angle, 0, 0, &b, &why))
            fail_msg("%s", why.text);
        struct step_limit l = predicted(&b);
        if (m < 2) assert_near(l.von_neumann, 0.5 / (m ? largest : 1 + r), 1e-11);
        assert_int_equal(step_limit_measure(&b, &measured, &why), STATUS_OK);
        assert_near(measured / l.von_neumann, 1, 0.02);
    }
    struct model_problem b;
    struct failure why;
    const struct options corner = {.cross = CROSS_CORNER};
    assert_int_equal(step_limit_setup(&method_ftcs, &corner, 3, r, angle, 0, 0, &b, &why), STATUS_INPUT);
    assert_int_equal(step_limit_setup(&method_ftcs, &corner, 2, r, 0, 0, 0, &b, &why), STATUS_INPUT);
}

static void grids_refuse_jitter_and_accept_nodes(void **state) {
    (void)state;
    struct model_problem b = {.method = &method_ftcs, .dim = 2, .options = {.layout = LAYOUT_JITTER, .jitter = 0.1}};
    struct failure why;
    assert_int_equal(step_limit_model(&b, &why), STATUS_INPUT);
    b = (struct model_problem){.method = &method_ftcs_flux, .dim = 1, .options = {.layout = LAYOUT_NODE}};
    assert_int_equal(step_limit_model(&b, &why), STATUS_OK);
    assert_near(predicted(&b).von_neumann, 2, 1e-11);
    const struct options o = {.stepper = STEPPER_EULER};
    assert_int_equal(step_limit_setup(&method_so_ssph, &o, 1, 0.5, 0, 0, 0, &b, &why), STATUS_INPUT);
}

/* The largest eigenvalue of n cells with a stencil of w[1], w[2] at one and two cells.  Odd reflection has the modes
 * sin(theta (i + 1/2)) with theta up to pi; nodes with Dirichlet ends have sin(theta i) with theta up to pi (n -
 * 1)/n.  For ghosts at the wall's value the n (nodes: n - 1) unknowns have no contribution from beyond them. */
static double largest_of_rod(const double w[3], int n, int node, int fixed) {
    enum { MOST = 16 };
    double T[MOST] = {0}, next[MOST], size = 0;
    if (!fixed) {
        double theta = M_PI * (node ? n - 1 : n) / n;
        return 2 * w[1] * (1 - cos(theta)) + 2 * w[2] * (1 - cos(2 * theta));
    }
    int unknowns = node ? n - 1 : n;
    for (int i = 0; i < unknowns; i++) T[i] = i % 2 ? -1 : 1;
    for (int pass = 0; pass < 2000; pass++) {
        double length = 0;
        for (int i = 0; i < unknowns; i++) {
            next[i] = 2 * (w[1] + w[2]) * T[i];
            for (int j = 1; j < 3; j++)
                next[i] -= w[j] * ((i >= j ? T[i - j] : 0) + (i + j < unknowns ? T[i + j] : 0));
            length += next[i] * next[i];
        }
        size = sqrt(length);
        for (int i = 0; i < unknowns; i++) T[i] = next[i] / size;
    }
    return size;
}

/* The limit of a rod of six cells is 2/lambda of these; bisection stops within 0.5 % and detects growth beyond 0.2
 * %. */
static void limits_depend_on_walls_and_nodes(void **state) {
    (void)state;
    const double s[2] = {1 / 1.1, 2 / 1.1}, W[2] = {2.0 / 3 - s[0] * s[0] * (1 - s[0] / 2), pow(2 - s[1], 3) / 6};
    const double five[3] = {-2, 1, 0}, sph[3] = {0, W[0] / (W[0] + 16 * W[1]), 4 * W[1] / (W[0] + 16 * W[1])};
    for (int m = 0; m < 2; m++)
        for (int node = 0; node < 2; node++)
            for (int fixed = 0; fixed < 2; fixed++) {
                struct model_problem b = {
                    .method = m ? &method_so_ssph : &method_ftcs,
                    .dim = 1,
                    .n = 6,
                    .options = {.h = m ? 1.1 : 0,
                                .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE,
                                .walls = fixed ? WALLS_FIXED : WALLS_MIRROR},
                };
                struct failure why;
                double measured, lambda = largest_of_rod(m ? sph : five, b.n, node, fixed);
                assert_int_equal(step_limit_model(&b, &why), STATUS_OK);
                assert_int_equal(step_limit_measure(&b, &measured, &why), STATUS_OK);
                assert_near(measured * lambda / 2, 1, 0.01);
                assert_order(2 / lambda, >=,
                             predicted(&b).von_neumann * (1 - 1e-12)); /* the symbol's, of every wave */
            }
}

/* With one neighbour on either side (h/dx <= 1) both are central differences. */
static void narrow_supports_reduce_to_finite_differences(void **state) {
    (void)state;
    struct model_problem so = probe(&method_so_ssph, 1, 0.83), fo = probe(&method_fo_ssph, 1, 0.83);
    assert_near(predicted(&so).von_neumann, 0.5, 1e-12);
    assert_near(predicted(&so).published, 0.5, 1e-13);
    assert_near(predicted(&fo).von_neumann, 2, 1e-11);
    assert_near(predicted(&fo).published, 0.5, 1e-13); /* Song eq. 41: a quarter of it */
}

/* Face and edge neighbours in space (sqrt(2) < 2 h/dx < sqrt(3)) with weights w1 and w2, exact for x^2: 2 w1 + 8 w2 =
 * 2.  The symbol is -4 at (pi, 0, 0), -8 + 16 w2 at (pi, pi, 0) and -12 + 48 w2 at (pi, pi, pi).  With w2 = 0 it is
 * the seven-point difference. */
static void limits_in_space_follow_from_two_weights(void **state) {
    (void)state;
    struct model_problem narrow = probe(&method_brookshaw, 3, 0.6);
    assert_near(predicted(&narrow).von_neumann, 1.0 / 6, 1e-12);
    const struct method *const all[] = {&method_so_ssph, &method_brookshaw};
    for (int m = 0; m < 2; m++) {
        struct model_problem b = probe(all[m], 3, 0.83);
        struct symbol s;
        struct failure why;
        assert_int_equal(symbol_create(&s, &b, &why), STATUS_OK);
        double w1 = symbol_weight(&s, 0, 0, 1), w2 = symbol_weight(&s, 0, 1, -1);
        assert_near(symbol_weight(&s, 1, 1, 1), 0, 0);
        assert_near(2 * w1 + 8 * w2, 2, 1e-13);
        double lowest = fmax(4, fmax(8 - 16 * w2, 12 - 48 * w2));
        assert_near(predicted(&b).von_neumann, 2 / lowest, 1e-12);
        symbol_free(&s);
    }
}

static void complex_eigenvalues_limit_the_step(void **state) {
    (void)state;
    struct amplification euler = {STEPPER_EULER, 0}, rk2 = {STEPPER_RK2, 0};
    assert_near(amplification_limit(&euler, 2, -1.3 + 0.7 * I), 2.6 / (1.69 + 0.49), 1e-14);
    assert_near(amplification_limit(&euler, 2, 0.7 * I), 0, 0);
    assert_near(amplification_limit(&euler, 2, 1e-9 + 0.7 * I), 0, 0);
    double dt = amplification_limit(&rk2, 2, -1.3 + 0.7 * I);
    assert_near(cabs(amplification_factor(&rk2, dt * (-1.3 + 0.7 * I))), 1, 1e-9);
}

static void rkl2_equals_its_legendre_polynomial(void **state) {
    (void)state;
    for (int s = 3; s <= 15; s += 4) {
        struct amplification a = {STEPPER_RKL2, s};
        double beta = amplification_interval(&a), z = 0.371 * beta, b = beta / (s * (s + 1.0));
        assert_near(creal(amplification_factor(&a, -z)), 1 - b + b * gsl_sf_legendre_Pl(s, 1 - 2 * z / beta), 1e-13);
        assert_order(amplification_reach(&a), >, beta);
        assert_near(cabs(amplification_factor(&a, -amplification_reach(&a))), 1, 1e-9);
    }
}

/* The eigenvalues of a regular cloud are the symbol at the waves that vanish at its walls. */
static void eigenvalues_equal_the_symbol(void **state) {
    (void)state;
    struct model_problem b = probe(&method_so_ssph, 1, 1.37);
    struct symbol s;
    struct heat_operator a;
    struct spectrum e;
    struct failure why;
    assert_int_equal(symbol_create(&s, &b, &why), STATUS_OK);
    b.options.layout = LAYOUT_JITTER; /* amplitude 0 */
    b.n = 16;
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    assert_int_equal(model_problem_operator(&b, &p, &a, &why), STATUS_OK);
    assert_int_equal(spectrum_create(&e, &a, &b.step, &why), STATUS_OK);
    for (int k = 1; k <= 16; k++) {
        double theta[2] = {M_PI * k / 16, 0}, want = creal(symbol_at(&s, theta)), nearest = INFINITY;
        for (size_t i = 0; i < e.n; i++) nearest = fmin(nearest, cabs(e.lambda[i] - want));
        assert_near(nearest, 0, spectrum_rounding(&e));
    }
    spectrum_free(&e);
    operator_free(&a);
    symbol_free(&s);
}

static void the_quartic_kernel_breaks_song_34(void **state) {
    (void)state;
    struct model_problem b = {.method = &method_so_ssph, .dim = 1, .options = {.kernel = KERNEL_QUARTIC, .h = 1.12}};
    struct failure why;
    assert_int_equal(step_limit_model(&b, &why), STATUS_OK);
    struct step_limit l = predicted(&b);
    assert_order(l.published, >, 1.02 * l.von_neumann);
    assert_int_equal(step_limit_grows(&b, 0.99 * l.published, 2000, &why), 1);
    assert_int_equal(step_limit_grows(&b, 0.99 * l.von_neumann, 2000, &why), 0);
    struct maximum_principle x;
    assert_int_equal(maximum_principle_find(&b, 1.12, &x, &why), STATUS_OK);
    assert_order(x.lowest, <, 0);
    assert_order(x.undershoot, >, 1e-3);
}

/* A stencil that reaches past the 128 phases of the transform, twice 139 particles: the worst of 20000 waves. */
static void limits_of_wide_stencils(void **state) {
    (void)state;
    struct model_problem b = probe(&method_fo_ssph, 1, 70);
    struct symbol s;
    struct failure why;
    double radius = 0;
    assert_int_equal(symbol_create(&s, &b, &why), STATUS_OK);
    for (int k = 0; k < 20000; k++) radius = fmax(radius, cabs(symbol_at(&s, (double[2]){M_PI * k / 20000, 0})));
    symbol_free(&s);
    assert_near(predicted(&b).von_neumann * radius / 2, 1, 1e-4);
}

/* The least limit of fo_ssph in space, 1.754191 at (1.232, 1.232, 0), is not next to the least value on the
 * grid, 1.755 at another minimum. */
static void the_least_of_several_minima_is_found(void **state) {
    (void)state;
    struct model_problem b = {.method = &method_fo_ssph, .dim = 3, .options = {.kernel = KERNEL_QUARTIC, .h = 1.1}};
    struct symbol s;
    struct failure why;
    assert_int_equal(step_limit_model(&b, &why), STATUS_OK);
    const struct step_limit l = predicted(&b);
    assert_near(l.von_neumann, 1.754191, 1e-6);
    assert_int_equal(symbol_create(&s, &b, &why), STATUS_OK);
    double along[4][DIM_MAX] = {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0.5, 0}}, least = INFINITY;
    for (int k = 1; k < 4000; k++) {
        const double t = M_PI * k / 1000 / 4, *d = along[k % 4];
        least = fmin(least, 2 / cabs(symbol_at(&s, (const double[]){t * d[0], t * d[1], t * d[2]})));
    }
    symbol_free(&s);
    assert_near(l.von_neumann / least, 1, 1e-5);
}

/* The moment matrix of a particle without neighbours is singular at any step. */
static void failed_run_is_not_growth(void **state) {
    (void)state;
    struct model_problem b = probe(&method_so_ssph, 1, 1.1);
    struct failure why;
    b.options.h = 0.47;
    assert_int_equal(step_limit_grows(&b, 0.13, 100, &why), -1);
    assert_int_equal(why.status, STATUS_NUMERICAL);
}

static void long_runs_conserve_heat(void **state) {
    (void)state;
    struct model_problem b = probe(&method_brookshaw, 1, 1.2);
    struct long_run e;
    struct failure why;
    assert_int_equal(long_run_measure(&b, 0.999 * predicted(&b).von_neumann, 100000, &e, &why), STATUS_OK);
    assert_near(e.drift, 0, 100000 * 2.3e-16);
    assert_order(e.rise, <=, 1e-15);
    assert_near(e.largest, e.mean, 1e-12);
}

/* Two materials of one diffusivity.  Between neighbours on a rod with k in series, rows beside the contact differ
 * from the others by d = +-(r - 1)/(r + 1), and their coupling is t = 2 sqrt(r)/(1 + r): a mode faster than all
 * others would need (1 - d)(1 + d) < t^2, but d^2 + t^2 = 1 at every ratio r.  So the step is that of one material,
 * 1/2, and in the plane, where axes add up, 1/4. */
static void nearest_neighbour_contact_keeps_the_step_limit(void **state) {
    (void)state;
    for (int dim = 1; dim <= 2; dim++)
        for (double r = 0.1; r > 1e-5; r *= 0.1) {
            struct options o = {.order = 2};
            struct model_problem b;
            struct step_limit l;
            struct failure why = {0};
            double measured;
            if (step_limit_setup(method_find("voronoi_flux"), &o, dim, 0, 0, r, 0, &b, &why))
                fail_msg("%s", why.text);
            assert_int_equal(step_limit_predict(&b, &l, &why), STATUS_OK);
            assert_near(l.von_neumann, 0.5 / dim, 1e-9);
            assert_int_equal(step_limit_measure(&b, &measured, &why), STATUS_OK);
            assert_near(measured / l.von_neumann, 1, 0.01);
        }
    struct options o = {.order = 2};
    struct model_problem b;
    struct failure why;
    assert_int_equal(step_limit_setup(&method_ftcs, &o, 1, 0, 0, 0.1, 0, &b, &why), STATUS_INPUT);
    assert_has(why.text, "--contact 0.1: ftcs has no rows");
    assert_int_equal(step_limit_setup(&method_so_ssph, &o, 1, 0, 0, 0.1, 0, &b, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "one material only");
}

/* Weights of no symmetry, as beside a wall or in a cloud: the sum over all of them. */
static void symbol_is_the_sum_over_all_weights(void **state) {
    (void)state;
    double w[3 * 5];
    for (int k = 0; k < 15; k++) w[k] = fmod(0.37 + 0.61803 * k, 1) - 0.4;
    const struct symbol s = {2, {2, 1}, w};
    const double theta[2] = {0.83, -1.7};
    double complex want = 0;
    for (int j = -1; j <= 1; j++)
        for (int i = -2; i <= 2; i++) want += symbol_weight(&s, i, j, 0) * cexp(I * (i * theta[0] + j * theta[1]));
    double complex got = symbol_at(&s, theta);
    assert_near(creal(got), creal(want), 1e-14);
    assert_near(cimag(got), cimag(want), 1e-14);
}

static double first_alone(const struct problem *p, const double x[2]) {
    (void)p;
    return x[0] < 1 && x[1] < 1;
}

/* The stages of such a step are given, not chosen by a run: it is marched from the same data, each particle's. */
static void given_stages_start_from_the_initial_data(void **state) {
    (void)state;
    struct model_problem b = {.method = &method_so_ssph, .dim = 2, .options = {.h = 1.2}, .step = {STEPPER_RKL2, 3}};
    struct failure why;
    double largest;
    assert_int_equal(step_limit_model(&b, &why), STATUS_OK);
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    p.initial = first_alone;
    assert_int_equal(model_problem_run(&b, &p, 1e-9, 1, &largest, &why), STATUS_OK);
    assert_near(largest, 1, 1e-7);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finite_differences_have_their_symbols),
        cmocka_unit_test(limits_of_two_diffusivities),
        cmocka_unit_test(limits_follow_the_angle_of_a_field),
        cmocka_unit_test(grids_refuse_jitter_and_accept_nodes),
        cmocka_unit_test(limits_depend_on_walls_and_nodes),
        cmocka_unit_test(narrow_supports_reduce_to_finite_differences),
        cmocka_unit_test(limits_in_space_follow_from_two_weights),
        cmocka_unit_test(complex_eigenvalues_limit_the_step),
        cmocka_unit_test(rkl2_equals_its_legendre_polynomial),
        cmocka_unit_test(eigenvalues_equal_the_symbol),
        cmocka_unit_test(the_quartic_kernel_breaks_song_34),
        cmocka_unit_test(limits_of_wide_stencils),
        cmocka_unit_test(the_least_of_several_minima_is_found),
        cmocka_unit_test(failed_run_is_not_growth),
        cmocka_unit_test(long_runs_conserve_heat),
        cmocka_unit_test(nearest_neighbour_contact_keeps_the_step_limit),
        cmocka_unit_test(symbol_is_the_sum_over_all_weights),
        cmocka_unit_test(given_stages_start_from_the_initial_data),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
