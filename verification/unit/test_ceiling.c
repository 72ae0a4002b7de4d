/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The evaluator of the gates' bounds against closed forms, and its weights against the operators' own. */
#include "verification/unit/stencil_moments.h"

#include "references/scene.h"
#include "verification/gates/ceiling.h"
#include "verification/gates/ceiling_weights.h"
#include "verification/stability/amplification.h"

#include <complex.h>
#include <gsl/gsl_errno.h>

static struct command request;

static const struct experiment *of(const char *line) {
    struct failure why;
    command_free(&request);
    if (command_read(line, &request, &why)) fail_msg("%s: %s", line, why.text);
    return &request.experiment;
}

/* ---- Loads on an edge ---- */

/* The source of `ceiling_edges` from the derivatives of the scene's S, and T on the edge as an integral over wave
 * numbers. */
static void source_on_an_edge(void **state) {
    (void)state;
    enum { POINTS = 20000 };
    const struct experiment *e =
        of("run box-manufactured ftcs --dx 0.03 --set width=1.2 --set height=0.6 --set depth=0.84 --set k_x=0.01 "
           "--set k_y=0.007 --set k_z=0.014 --set b=0.15");
    const double dx = 0.03, k_y = 0.007, k_z = 0.014, b = 0.15, B = 1.1 / 0.6, C = 0.9 / 0.84;
    double slope = 0, lattice = 0;
    for (int edge = 0; edge < 4; edge++) {
        double y = 0.4 + 1.1 * (edge % 2), z = -0.3 + 0.9 * (edge / 2), along = 0.5 * exp(0.8);
        double S_y = -B * along * sin(y) * cos(z), S_yz = B * C * along * sin(y) * sin(z);
        slope = fmax(slope, k_y * fabs(S_yz) + fabs(b * S_y + (edge / 2 ? k_z : -k_z) * S_yz));
    }
    for (int i = 0; i < POINTS; i++) {
        double s = sin(M_PI / 2 * (i + 0.5) / POINTS);
        lattice += M_PI / 2 / POINTS / (s * sqrt(1 + k_y / k_z * s * s) + b * dx / (2 * sqrt(k_y * k_z)));
    }
    double want = 2 / (M_PI * sqrt(k_y * k_z)) * dx * dx / 6 * slope * lattice;
    assert_near(ceiling_edges(e), want, 0.12 * want); /* dx/2 S_yy/S_y of the difference; b dx/k of the integral */
    assert_near(ceiling_edges(of("run rect-manufactured ftcs --dx 0.03")), 0, 0); /* each edge has a held side */
}

/* ---- Weights ---- */

/* No method without weights: it would have no ceiling. */
static void every_method_has_weights(void **state) {
    (void)state;
    for (int i = 0; methods[i]; i++) {
        char line[100];
        snprintf(line, sizeof line, "run rod-cosine %s --dx 0.05", methods[i]->name);
        struct ceiling_weights s = ceiling_weights(of(line));
        if (s.family == UNKNOWN) fail_msg("%s: no row in ceiling_weights.c", methods[i]->name);
        assert_near(ceiling_weights_moment(&s, 2, 0, 0), 2, 1e-12);
    }
    struct experiment e = *of("run rod-cosine so_ssph --dx 0.05");
    struct method other = *e.method;
    other.name = "other", e.method = &other;
    assert_false(ceiling(&e) > 0);
}

static void moments_equal_those_of_the_operators(void **state) {
    (void)state;
    static const char *const method[] = {"so_ssph",         "fo_ssph",        "brookshaw",    "brookshaw_corrected",
                                         "schwaiger",       "fatehi_manzari", "cspm",         "kernel_second",
                                         "flux_divergence", "conjugate",      "contact_ssph", "so_ssph --order 4"};
    static const char *const kernel[] = {"cubic", "quartic", "wendland"};
    for (size_t k = 0; k < 3 * sizeof method / sizeof *method; k++)
        for (int dim = 1; dim <= 2; dim++) {
            char line[200];
            struct stencil s;
            struct failure why;
            const double one[2] = {1, 1};
            snprintf(line, sizeof line, "run %s %s --kernel %s --dx 0.1 --h %g%s",
                     dim == 1 ? "rod-step" : "square-step", method[k / 3], kernel[k % 3],
                     strstr(method[k / 3], "order") ? 2.17 : 1.13,
                     dim == 1 ? " --set kappa=1" : " --set kappa_x=1 --set kappa_y=1");
            const struct experiment *e = of(line);
            if (operator_stencil(&e->problem, &e->options, e->method->scheme, 1, one, s.reach, &s.w, &why))
                fail_msg("%s: %s", line, why.text);
            struct ceiling_weights w = ceiling_weights(e);
            assert_near(ceiling_weights_moment(&w, 4, 0, 0), stencil_moment(&s, 4, 0, 0), 1e-11);
            assert_near(ceiling_weights_moment(&w, 2, 2, 0), stencil_moment(&s, 2, 2, 0), 1e-11);
            assert_near(ceiling_weights_moment(&w, 6, 0, 0), stencil_moment(&s, 6, 0, 0), 1e-9);
            assert_near(ceiling_weights_moment(&w, 4, 2, 0), stencil_moment(&s, 4, 2, 0), 1e-10);
            if (w.blind > 0 && dim == 1) assert_near(w.blind, stencil_moment(&s, 2, 0, 1) / 2, 1e-12);
            free(s.w);
        }
}

/* The same in space, with different diffusivities for the least squares. */
static void moments_in_space_equal_those_of_the_operators(void **state) {
    (void)state;
    static const char *const method[] = {"so_ssph", "fo_ssph", "brookshaw", "fatehi_manzari"};
    for (int k = 0; k < 4; k++) {
        char line[200];
        struct failure why;
        double *w, sum[3][3] = {{0}};
        int reach[DIM_MAX];
        snprintf(line, sizeof line,
                 "run cube-step %s --dx 0.1 --h 1.13 --set kappa_x=1 --set kappa_y=%g --set kappa_z=%g", method[k],
                 k < 2 ? 0.7 : 1, k < 2 ? 1.3 : 1);
        const struct experiment *e = of(line);
        const double kappa[DIM_MAX] = {1, k < 2 ? 0.7 : 1, k < 2 ? 1.3 : 1};
        if (operator_stencil(&e->problem, &e->options, e->method->scheme, 1, kappa, reach, &w, &why))
            fail_msg("%s: %s", line, why.text);
        for (int z = 0; z <= reach[2]; z++)
            for (int y = 0; y <= reach[1]; y++)
                for (int x = 0; x <= reach[0]; x++) {
                    const double at[DIM_MAX] = {x, y, z};
                    double weight = w[operator_offset(reach, x, y, z)] * operator_images(x, y, z);
                    for (int a = 0; a < DIM_MAX; a++)
                        for (int b = 0; b < DIM_MAX; b++) sum[a][b] += weight * at[a] * at[a] * at[b] * at[b];
                }
        struct ceiling_weights s = ceiling_weights(e);
        for (int a = 0; a < DIM_MAX; a++)
            for (int b = 0; b < DIM_MAX; b++) {
                int power[DIM_MAX] = {0};
                power[a] += 2, power[b] += 2;
                assert_near(ceiling_weights_moment(&s, power[0], power[1], power[2]), sum[a][b], 1e-11);
            }
        free(w);
    }
}

/* The ratio is 1 for the central difference, whatever the conductivities, and 4 for differences over two cells; of
 * weights of order 2 in the plane it is the largest of the axis and the diagonal, where x^4 + y^4 is half as large.
 */
static void worst_ratio_of_moments(void **state) {
    (void)state;
    assert_near(ceiling_worst(of("run rect-manufactured ftcs --dx 0.1")), 1, 1e-12);
    assert_near(ceiling_worst(of("run cube-step ftcs --dx 0.1")), 1, 1e-12);
    assert_near(ceiling_worst(of("run rod-step ftcs_flux --dx 0.1")), 4, 1e-12);
    const struct experiment *e = of("run wave so_ssph --dx 0.05");
    struct ceiling_weights s = ceiling_weights(e);
    double straight = ceiling_weights_moment(&s, 4, 0, 0) / 2, mixed = ceiling_weights_moment(&s, 2, 2, 0) / 2;
    assert_near(ceiling_worst(e), fmax(straight, straight + 3 * mixed), 1e-12);
    const struct experiment iso = *of("run square-step so_ssph --stepper matched --h iso --dx 0.1");
    s = ceiling_weights(&iso);
    assert_near(ceiling_weights_moment(&s, 2, 2, 0), ceiling_weights_moment(&s, 4, 0, 0) / 3, 1e-11);
    assert_near(s.h, 1.2591264671505324, 1e-12);
}

/* ---- Errors of one mode, in closed form ---- */

/* rod-cosine at its defaults: E1 of an amplitude that is off by the part `off` of itself. */
static double of_mode(const struct experiment *e, double off, double *q2) {
    double q = ceiling_param(e, "mode") * M_PI / ceiling_param(e, "L"), t = e->problem.t_end;
    *q2 = q * q;
    return fabs(off) * ceiling_param(e, "A") * exp(-q * q * ceiling_param(e, "kappa") * t) * 2 / M_PI /
           ceiling_param(e, "Tm");
}

static void error_of_one_mode_on_a_lattice(void **state) {
    (void)state;
    const struct experiment *e = of("run rod-cosine so_ssph --dx 0.01");
    struct ceiling_weights s = ceiling_weights(e);
    double q2, one = of_mode(e, 1, &q2), A = ceiling_weights_moment(&s, 4, 0, 0) / 24, kt;
    kt = ceiling_param(e, "kappa") * e->problem.t_end;
    double want = one * A * 1e-4 * q2 * q2 * kt;
    assert_near(ceiling_truncation(e), want, 1e-3 * want);
    assert_near(ceiling(e), 1.3 * want, 2e-3 * want); /* by the finite differences */
    e = of("run rod-cosine so_ssph --dx 0.01 --sampling spline");
    assert_near(ceiling_truncation(e), one * 1e-4 * fabs(A * q2 * q2 * kt - q2 / 6), 1e-3 * want);
    e = of("run rod-cosine ftcs --dx 0.01 --fourier 0.3");
    assert_near(ceiling_truncation(e), one * (0.15 - 1.0 / 12) * 1e-4 * q2 * q2 * kt, 1e-3 * want);
    assert_near(ceiling_five_point(e, 0), one / 12 * 1e-4 * q2 * q2 * kt, 2e-3 * want); /* without its steps */
    assert_near(ceiling_central(e), one / 12 * 1e-4 * q2 * q2 * kt, 1e-3 * want);
    e = of("run rod-cosine so_ssph --order 4 --dx 0.01");
    s = ceiling_weights(e);
    double sixth = fabs(ceiling_weights_moment(&s, 6, 0, 0)) / 720;
    assert_near(ceiling_fourth(e), one * sixth * 1e-8 * pow(q2, 3) * kt, 1e-3 * ceiling_fourth(e));
    assert_near(ceiling_next(e, sqrt(q2)), 1.3 * one * sixth * 1e-8 * pow(q2, 3) * kt,
                2e-3 * ceiling_next(e, sqrt(q2)));
    assert_near(ceiling_sixth(e), one * 1e-8 / 540 * pow(q2, 3) * kt, 1e-3 * ceiling_sixth(e));
    assert_near(ceiling_late(e, 0.01), one * expm1(0.01 * q2 * kt), 1e-4 * ceiling_late(e, 0.01));
    assert_near(ceiling_changed(e, "A", 0.1), one * 0.1 / ceiling_param(e, "A"), 1e-6);
    assert_nan(ceiling_changed(e, "none", 0.1));
    assert_nan(ceiling_param(e, "none"));
}

static void time_error_of_one_mode(void **state) {
    (void)state;
    const struct experiment *e = of("run rod-cosine so_ssph --dx 1/20 --stepper euler --dt 1/64");
    double q2, one = of_mode(e, 1, &q2), t = e->problem.t_end, rate = ceiling_param(e, "kappa") * q2, dt = 1.0 / 64;
    assert_near(ceiling_time(e), one * dt / 2 * rate * rate * t, 1e-3 * ceiling_time(e));
    struct experiment fixed = *e;
    fixed.options.dt = dt; /* over the run: the integral of rate^2 exp(-rate t) */
    assert_near(ceiling_run_time(&fixed), one * dt / 2 * rate * expm1(rate * t), 2e-3 * one * dt * rate);
    e = of("run rod-cosine so_ssph --dx 1/20 --stepper rk2 --dt 1/64");
    assert_near(ceiling_time(e), one * dt * dt / 6 * pow(rate, 3) * t, 1e-3 * ceiling_time(e));
    e = of("run rod-cosine so_ssph --dx 1/20 --stepper rkl2 --dt 1/64");
    assert_near(ceiling_time(e), one * dt * dt / 10 * pow(rate, 3) * t, 1e-3 * ceiling_time(e));
}

static void truncation_error_of_a_disc_mode(void **state) {
    (void)state;
    const struct experiment *e = of("run disc-mode ftcs --dx 0.05");
    const double lambda2 = pow(5.135622301840683, 2); /* J_2 vanishes at the wall */
    struct problem early = e->problem;
    double kt = problem_diffusivity(&early) * early.t_end, size = 0, all = 0;
    for (int i = 0; i < 10000; i++) {
        double x[2] = {-0.99 + 0.0198 * (i % 100 + 0.5), -0.99 + 0.0198 * (i / 100 + 0.5)};
        if (hypot(x[0], x[1]) > 1) continue;
        double T = scene_exact(e->scene, &early, x, early.t_end).temperature;
        double steady = scene_exact(e->scene, &early, x, 1000 * early.t_end).temperature;
        size += fabs(T - steady), all += fabs(T);
    }
    double want = lambda2 * lambda2 * kt / 16 * 0.0025 * size / all;
    assert_near(ceiling_truncation(e), want, 0.03 * want);
}

static void contact_resistance_error(void **state) {
    (void)state;
    const struct experiment *e = of("run rod-contact brookshaw --h 0.9 --dx 0.01");
    assert_near(ceiling_harmonic(e), 0, 0); /* nearest neighbours alone */
    assert_near(ceiling_contact(e, 2), 2 * ceiling_contact(e, -1), 1e-15);
    assert_near(ceiling_contact(e, 368.2), 0.332 * 0.01, 0.001 * 0.01);
}

/* ---- RKL2 ---- */

/* The coefficients of G = sum c_k z^k by Cauchy's integral, exact for a polynomial of a degree below POINTS. */
static void the_third_order_term_is_known(void **state) {
    (void)state;
    enum { POINTS = 64 };
    for (int s = 3; s <= 27; s += 2) {
        struct amplification a = {STEPPER_RKL2, s};
        double complex c[4] = {0};
        for (int i = 0; i < POINTS; i++) {
            double complex z = cexp(2 * M_PI * I * i / POINTS), G = amplification_factor(&a, z);
            for (int k = 0; k < 4; k++) c[k] += G / cpow(z, k) / POINTS;
        }
        for (int k = 0; k < 3; k++) assert_near(creal(c[k]), k < 2 ? 1 : 0.5, 1e-12);
        assert_near(1. / 6 - creal(c[3]), (1 + 8. / (s * s + s - 2)) / 18, 1e-12);
    }
}

static void stiff_modes_decay(void **state) {
    (void)state;
    for (int s = 3; s <= 35; s += 2) {
        struct amplification a = {STEPPER_RKL2, s};
        double most = 0, end = amplification_interval(&a);
        for (int i = 0; i <= 20000; i++)
            most = fmax(most, cabs(amplification_factor(&a, -(1.8 + (end - 1.8) * i / 20000))));
        assert_order(most, <, (s == 3 ? 0.771 : s < 9 ? 0.73 : 0.7108));
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(source_on_an_edge),
        cmocka_unit_test(every_method_has_weights),
        cmocka_unit_test(moments_equal_those_of_the_operators),
        cmocka_unit_test(moments_in_space_equal_those_of_the_operators),
        cmocka_unit_test(worst_ratio_of_moments),
        cmocka_unit_test(error_of_one_mode_on_a_lattice),
        cmocka_unit_test(time_error_of_one_mode),
        cmocka_unit_test(truncation_error_of_a_disc_mode),
        cmocka_unit_test(contact_resistance_error),
        cmocka_unit_test(the_third_order_term_is_known),
        cmocka_unit_test(stiff_modes_decay),
    };
    return cmocka_run_group_tests_name("ceiling", tests, NULL, NULL);
}
