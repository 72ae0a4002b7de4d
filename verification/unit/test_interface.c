/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An interface anywhere: the errors that gates/materials.def predicts for rod-contact, and what cut cells hold.
 *
 * T = Tc + (T_i - Tc) erf(s/sqrt(4 kappa_i t)) at the distance s from the contact, q = Q/sqrt(t) the flux there, Q =
 * E_2 (T_2 - Tc)/sqrt(pi), E = sqrt(k rho_c).  In units of dx a particle lies xi beyond the interface, its cell has
 * the parts l_1 = 1/2 - xi and l_2 = 1/2 + xi (none where |xi| = 1/2).  With pairs that are exact for steady profiles
 * a run keeps two sums as the solution does, rho_c T and rho_c T R, R = x/k.  What the midpoint rule and the cut cell
 * miss of them, M(c) = (c_2/k_2 - c_1/k_1)/24 + (l_1 c_1 + l_2 c_2) xi/k + c_1 l_1^2/(2 k_1) - c_2 l_2^2/(2 k_2), k
 * that of the particle, c = rho_c for the first (K), rho_c_i (T_i - Tc) at the start for the second (J), the error
 * makes up for: in units of dx^2, with the stencil's symbol error A and Euler's -F_i/2 in A_i = A - F_i/2,
 *     e_i = g_i (c_i + A_i (T_i - Tc)/kappa_i (3/2 - s^2/(4 kappa_i t))),  g_i = s/(2 sqrt(pi kappa_i t^3))
 * exp(-s^2/(4 kappa_i t)), c_2 - c_1 = J,   E_1 c_1 + E_2 c_2 = -sqrt(pi) Q (M(rho_c) + (A_2 rho_c_2/k_2 - A_1
 * rho_c_1/k_1)/2). */
#include "solver/differences/ftcs_grid.h"
#include "solver/space/sample.h"
#include "verification/command/arguments.h"
#include "verification/run/result.h"
#include "verification/run/run.h"
#include "verification/unit/stencil_moments.h"

static const double PI = 3.14159265358979323846, K[2] = {0.01, 0.001}, RHO_C[2] = {2, 0.5}, START[2] = {1, 0};

/* xi in (-1/2, 1/2], 1/2 for an interface midway; the contact at x_c between walls at -1 and 1, after 1 s */
static double predicted(double A, double xi, double x_c) {
    double E[2], kappa[2], a[2], l[2] = {0.5 - xi, 0.5 + xi}, c[2], sum = 0, heat = 0;
    for (int i = 0; i < 2; i++) E[i] = sqrt(K[i] * RHO_C[i]), kappa[i] = K[i] / RHO_C[i];
    double Tc = (E[0] * START[0] + E[1] * START[1]) / (E[0] + E[1]), missed[2];
    for (int i = 0; i < 2; i++) a[i] = RHO_C[i] * (START[i] - Tc);
    for (int m = 0; m < 2; m++) {
        const double *v = m ? a : RHO_C;
        missed[m] = (v[1] / K[1] - v[0] / K[0]) / 24;
        if (xi == 0.5) continue; /* no cell is cut */
        missed[m] += (l[0] * v[0] + l[1] * v[1]) * xi / K[xi > 0] + v[0] * l[0] * l[0] / 2 / K[0] -
                     v[1] * l[1] * l[1] / 2 / K[1];
    }
    double J = missed[1], flux = E[1] * (START[1] - Tc);
    double G = -flux * (missed[0] + A / 2 * (RHO_C[1] / K[1] - RHO_C[0] / K[0]));
    c[0] = (G - E[1] * J) / (E[0] + E[1]), c[1] = (G + E[0] * J) / (E[0] + E[1]);
    for (int i = 0; i < 2; i++) {
        double slope = A * (START[i] - Tc) / kappa[i], dv = 1e-3;
        for (double v = dv / 2; v < 40; v += dv)
            sum += sqrt(kappa[i] / PI) * exp(-v) * fabs(c[i] + slope * (1.5 - v)) * dv;
        heat += START[i] * (i ? 1 - x_c : 1 + x_c) - (START[i] - Tc) * sqrt(4 * kappa[i] / PI);
    }
    return sum / heat;
}

static void errors_of_a_contact_anywhere(void **state) {
    (void)state;
    const double A[] = {1.0 / 12, 0.0970, 0.3360}; /* h/dx = 0.9 and ftcs, 1.1, 2 */
    const double midway[] = {1.302, 1.450, 4.098}, on[] = {0.826, 0.909, 3.212}, quarter[] = {0.864, 0.902, 2.782};
    for (int h = 0; h < 3; h++) {
        assert_near(predicted(A[h], 0.5, 0), midway[h], 0.001);
        assert_near(predicted(A[h], 0, 0), on[h], 0.001);
        assert_near(predicted(A[h], 0.25, 0.25), quarter[h], 0.001);
    }
    assert_near(predicted(1.0 / 12, -0.25, 0.25), 0.779, 0.001);
}

static struct result result_of(const char *line) {
    struct request r;
    struct result out;
    struct failure why;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (run_experiment(&r.experiment, &out, NULL)) fail_msg("%s: %s", line, out.failure.text);
    arguments_free(&r);
    return out;
}

static void the_same_on_either_side_of_rounding(void **state) {
    (void)state;
    const char *const names[] = {"brookshaw --mean series", "brookshaw --mean harmonic", "ftcs --mean series",
                                 "ftcs --mean arithmetic"};
    const char *const places[] = {"1e-15", "-1e-15", "3e-16", "-1e-16"};
    for (int m = 0; m < 4; m++)
        for (int sampling = 0; sampling < 2; sampling++) {
            char line[200];
            const char *const words = "run rod-contact %s --dx 2/81 --fourier 0.15 --sampling %s --set x_c=%s";
            snprintf(line, sizeof line, words, names[m], sampling ? "cell" : "point", "0");
            struct result on = result_of(line);
            for (int k = 0; k < 4; k++) {
                snprintf(line, sizeof line, words, names[m], sampling ? "cell" : "point", places[k]);
                assert_near(result_of(line).error.l1 / on.error.l1, 1, 1e-9);
            }
        }
}

static void cut_cells_keep_heat_and_steady_profiles(void **state) {
    (void)state;
    const char *const names[] = {"brookshaw", "ftcs --fourier 0.1"};
    for (int m = 0; m < 2; m++) {
        char line[200];
        snprintf(line, sizeof line, "run rod-contact %s --mean series --dx 2/57 --set x_c=0.0731", names[m]);
        assert_near(result_of(line).heat_drift, 0, 1e-12);
        snprintf(line, sizeof line,
                 "run wall-composite %s --mean series --dx 1/23 --set x_c=0.4217 --set k2=0.1 --set rho_c2=0.3 --set "
                 "t_end=40",
                 names[m]);
        assert_near(result_of(line).error.l1, 0, 1e-11);
    }
}

static double sloping(const struct problem *p, const double x[2]) {
    (void)p;
    return 1 + 3 * x[0];
}

/* A cell that the contact cuts starts at its heat over its heat capacity; neither start is 0 here. */
static void cut_cells_start_at_their_heat(void **state) {
    (void)state;
    const char *const line = "run rod-contact ftcs --dx 0.1 --set x_c=0.03 --set T1=0.9 --set T2=0.3";
    struct request r;
    struct failure why;
    assert_int_equal(arguments_parse_line(line, &r, &why), STATUS_OK);
    /* the cell from 0 to 0.1: 0.03 m of 2 J/m^3/K at 0.9 K, 0.07 m of 0.5 J/m^3/K at 0.3 K */
    double want = (0.03 * 2 * 0.9 + 0.07 * 0.5 * 0.3) / (0.03 * 2 + 0.07 * 0.5);
    const double x[2] = {0.05, 0}, d[2] = {0.1, 0.1};
    assert_near(ftcs_sample(&r.experiment.problem, x, d, SAMPLING_POINT), want, 1e-14);
    assert_near(ftcs_sample(&r.experiment.problem, x, d, SAMPLING_CELL), want, 1e-14);
    /* and a start that varies: the middles of the parts are at 0.015 m and 0.065 m */
    r.experiment.problem.initial = sloping;
    want = (0.03 * 2 * 1.045 + 0.07 * 0.5 * 1.195) / (0.03 * 2 + 0.07 * 0.5);
    for (enum sampling how = SAMPLING_POINT; how <= SAMPLING_CELL; how++) {
        assert_near(ftcs_sample(&r.experiment.problem, x, d, how), want, 1e-14);
        assert_near(sample_cell(&r.experiment.problem, how, d, x), want, 1e-14);
    }
    arguments_free(&r);
}

static void what_two_materials_refuse(void **state) {
    (void)state;
    const char *const lines[][2] = {
        {"run rod-contact brookshaw --dx 0.1 --sampling spline", "--sampling spline: four cells of two materials"},
        {"run rod-contact ftcs --dx 0.1 --sampling spline", "point or cell"},
        {"run rod-contact ftcs --dx 0.1 --layout node", "lattice"},
        {"run rod-contact ftcs --dx 0.1 --stepper matched", "euler, auto"},
        {"run rod-contact ftcs_flux --dx 0.1", "in contact at x = 0 m"}};
    for (size_t k = 0; k < sizeof lines / sizeof *lines; k++) {
        struct request r;
        struct result out;
        struct failure why;
        assert_int_equal(arguments_parse_line(lines[k][0], &r, &why), STATUS_OK);
        assert_int_equal(run_experiment(&r.experiment, &out, NULL), STATUS_NOT_APPLICABLE);
        if (!strstr(out.failure.text, lines[k][1])) fail_msg("%s: %s", lines[k][0], out.failure.text);
        arguments_free(&r);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_a_contact_anywhere),
        cmocka_unit_test(the_same_on_either_side_of_rounding),
        cmocka_unit_test(cut_cells_keep_heat_and_steady_profiles),
        cmocka_unit_test(cut_cells_start_at_their_heat),
        cmocka_unit_test(what_two_materials_refuse),
    };
    return cmocka_run_group_tests_name("interface", tests, NULL, NULL);
}
