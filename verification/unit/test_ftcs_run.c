/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run of the finite differences from its start to its end: what is sampled, how many steps there are, what is
 * refused, and how it fails. */
#include "verification/unit/ftcs_problems.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

/* ---- Sampling ---- */

static double step(const struct problem *p, const double x[2]) {
    return (x[0] < p->jump[0][0] ? 1.3 : -0.4) * (p->dim == 1 ? 1 : x[1] < p->jump[1][0] ? 0.6 : 2.1);
}

/* Integral of the cubic B-spline up to u: sum of (u - k)^4 / 24 with the binomial coefficients and their signs. */
static double below(double u) {
    static const int binomial[5] = {1, -4, 6, -4, 1};
    double sum = 0;
    for (int k = 0; k < 5; k++) sum += binomial[k] * pow(fmax(0, fmin(4, u + 2) - k), 4) / 24;
    return sum;
}

/* Without a step in time the field is the sampled data: of a jump, the part of the cell on either side. */
static void test_cell_averages_of_a_jump(void **state) {
    (void)state;
    struct problem p = plane(0, 0);
    p.initial = step, p.t_end = 0;
    p.jumps[0] = p.jumps[1] = 1;
    p.jump[0][0] = 0.4431, p.jump[1][0] = 0.9017;
    p.side[X_LO] = p.side[X_HI] = NEUMANN;
    const double d = 0.046;
    struct options o = {.dx = d, .sampling = SAMPLING_CELL};
    struct field f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 0);
    for (size_t i = 0; i < f.n; i++) {
        double left = fmin(1, fmax(0, (0.4431 - f.x[i]) / d + 0.5));
        double low = fmin(1, fmax(0, (0.9017 - f.y[i]) / d + 0.5));
        assert_near(f.T[i], (1.3 * left - 0.4 * (1 - left)) * (0.6 * low + 2.1 * (1 - low)), 1e-14);
    }
    field_free(&f);
}

/* The same for B-splines; next to an insulated wall the data on its far side are the image, jump included. */
static void test_spline_averages_of_a_jump(void **state) {
    (void)state;
    const double d = 0.046, jump[] = {0.4431, -0.7 + 0.0617, 1.6 - 0.0271};
    for (int k = 0; k < 3; k++) {
        struct problem p = rod(0);
        p.initial = step, p.t_end = 0;
        p.jumps[0] = 1, p.jump[0][0] = jump[k];
        p.side[X_LO] = p.side[X_HI] = NEUMANN;
        struct options o = {.dx = d, .sampling = SAMPLING_SPLINE};
        struct field f = solved(&method_ftcs, &p, &o);
        for (size_t i = 0; i < f.n; i++) {
            double image[] = {2 * p.lo[0] - jump[k], 2 * p.hi[0] - jump[k]};
            double left =
                below((jump[k] - f.x[i]) / d) - below((image[0] - f.x[i]) / d) + 1 - below((image[1] - f.x[i]) / d);
            assert_near(f.T[i], 1.3 * left - 0.4 * (1 - left), 1e-13);
        }
        field_free(&f);
    }
}

/* A mode continued past its walls is the mode: its average is the mode times the transform of the B-spline. */
static void test_sampling_past_the_walls(void **state) {
    (void)state;
    struct problem p = plane(9, 5);
    p.t_end = 0;
    struct options o = {.dx = 0.046, .sampling = SAMPLING_SPLINE};
    struct field f = solved(&method_ftcs, &p, &o);
    double u = 9 * PI * 0.046 / 2.3 / 2, v = 5 * PI * 0.046 / 1.38 / 2;
    assert_near(mode_error(&p, &f, pow(sin(u) / u * sin(v) / v, 4)), 0, 2e-8);
    field_free(&f);
}

/* ---- What is refused, and how a run fails ---- */

static void refused(const struct method *m, const struct problem *p, const struct options *o, const char *words[]) {
    struct field f = {.n = 77};
    struct failure why = {0};
    assert_true(status_refused(method_solve(m, p, o, &f, &why)));
    assert_true(status_refused(why.status));
    assert_int_equal(f.n, 77);
    for (; *words; words++)
        if (!strstr(why.text, *words)) fail_msg("'%s' is not in: %s", *words, why.text);
}

#define REFUSED(m, p, o, ...) refused(m, p, &(struct options)o, (const char *[]){__VA_ARGS__, NULL})
#define O(...)                                                                                                       \
    { __VA_ARGS__ }

static void test_refusals(void **state) {
    (void)state;
    struct problem r = rod(3), s = plane(3, 2), two = plane(3, 2), late = rod(3), odd = plane(3, 2);
    two.materials = 2;
    late.t_end = NAN;
    odd.hi[1] = odd.lo[1] + sqrt(2);
    REFUSED(&method_ftcs, &r, O(.dx = 0.3), "--dx 0.3", "0.3285714286", "0.2875");
    REFUSED(&method_ftcs, &s, O(.dx = 0.05), "--dx 0.05", "2.3 m by 1.38 m", "0.05111111111", "0.046");
    REFUSED(&method_ftcs, &odd, O(.dx = 0.05), "--dx 0.05", "1.41421 m", "nearest: 0.0038");
    REFUSED(&method_ftcs, &r, O(.dx = 5), "--dx 5", "nearest: 0.575");
    REFUSED(&method_ftcs, &r, O(.dx = 1.15), "--dx 1.15", "4 or more", "nearest: 0.575");
    REFUSED(&method_ftcs, &r, O(.dx = 0), "--dx 0");
    REFUSED(&method_ftcs, &r, O(.dx = NAN), "--dx nan");
    REFUSED(&method_ftcs, &r, O(.dx = INFINITY), "--dx inf");
    REFUSED(&method_ftcs, &r, O(.dx = -0.1), "--dx -0.1");
    REFUSED(&method_ftcs, &r, O(.dx = 1e-9), "--dx 1e-09: 2.3e+09 grid points, at most 1e+09");
    REFUSED(&method_ftcs, &s, O(.dx = 1e-9), "--dx 1e-09: 3.17e+18 grid points, at most 1e+09");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .dt = -0.25), "--dt -0.25");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .dt = NAN), "--dt nan");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .fourier = -0.2), "--fourier -0.2");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .dt = 0.1, .fourier = 0.2), "--dt 0.1", "--fourier 0.2");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .dt = 1e-300), "time steps");
    REFUSED(&method_ftcs, &late, O(.dx = 0.115), "--t-end nan");
    REFUSED(&method_ftcs_flux, &two, O(.dx = 0.046), "ftcs_flux", "2", "one material", "use ftcs");
    two.side[Y_HI] = ROBIN;
    REFUSED(&method_ftcs, &two, O(.dx = 0.046), "ftcs", "Robin", "contact_ssph");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .layout = LAYOUT_JITTER), "--layout jitter", "lattice or node");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .stepper = STEPPER_RK2), "--stepper rk2", "euler", "matched");
    REFUSED(&method_ftcs_flux, &s, O(.dx = 0.046, .stepper = STEPPER_EXACT), "--stepper exact", "ftcs_flux", "euler");
    REFUSED(&method_ftcs, &s, O(.dx = 0.046, .stepper = STEPPER_MATCHED), "--stepper matched", "isotropic", "euler");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .stepper = STEPPER_MATCHED, .dt = 0.1), "matched", "--dt");
    late.t_end = 0.01;
    REFUSED(&method_ftcs, &late, O(.dx = 0.115, .stepper = STEPPER_MATCHED, .sampling = SAMPLING_SPLINE), "matched",
            "0.018", "--dx below 0.085");
}

/* Just inside the limit a run is bounded, just outside it is a status with step, time and place. */
static void test_stability(void **state) {
    (void)state;
    const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
    const double limit[] = {0.5, 2}; /* of dt (kappa_x + kappa_y) / dx^2 */
    for (int m = 0; m < 2; m++) {
        struct problem p = plane(3, 2);
        p.initial = step, p.jumps[0] = 1, p.jump[0][0] = 0.2431, p.jump[1][0] = 0.9017, p.t_end = 60;
        double share = 0.71 / (0.29 + 0.71); /* of the larger kappa, which --fourier is made with */
        struct options o = {.dx = 0.046, .fourier = 0.995 * limit[m] * share};
        struct field f = solved(both[m], &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_order(fabs(f.T[i]), <, 4);
        field_free(&f);

        struct failure why = {0};
        o.fourier = 1.02 * limit[m] * share;
        assert_int_equal(method_solve(both[m], &p, &o, &f, &why), STATUS_UNSTABLE);
        const char *text = strstr(why.text, "unstable at step ");
        long step_seen = 0, steps = 0;
        assert_non_null(text);
        assert_int_equal(sscanf(text, "unstable at step %ld of %ld,", &step_seen, &steps), 2);
        assert_true(step_seen % 32 == 0 && step_seen < steps / 2); /* it is not run to the end */
        assert_has(why.text, " t = ");
        assert_has(why.text, " at x = ");
        assert_has(why.text, ", y = ");
        o.fourier = 3 * limit[m], p.t_end = 19.5 * o.fourier * 0.046 * 0.046 * 2.385 / 0.71; /* at the last step */
        assert_int_equal(method_solve(both[m], &p, &o, &f, &why), STATUS_UNSTABLE);
        assert_has(why.text, "unstable at step 20 of 20,");
        p.initial = mode, p.param[2] = NAN; /* not a number from the start */
        assert_int_equal(method_solve(both[m], &p, &o, &f, &why), STATUS_UNSTABLE);
    }
}

/* Two materials of one kappa, k/rho_c = 0.1/1 and 1/10: the cell of the second next to the interface, halfway
 * between the points, has faces of 2/11 and 1/10, so that its rate is 31/22 of what --fourier counts in. */
static void test_rate_of_two_materials(void **state) {
    (void)state;
    struct problem p = rod(3);
    struct options o = {.dx = 0.05, .fourier = 0.8};
    struct field f;
    struct failure why = {0};
    p.t_end = 200.5 * 0.8 * 0.05 * 0.05 / 0.1, p.materials = 2, p.interface = 0.3; /* 201 steps */
    p.material[0] = (struct material){{1, 1}, 10}, p.material[1] = (struct material){{0.1, 0.1}, 1};
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
    const char *text = strstr(why.text, "sum of kappa dt/dx^2 is ");
    double sum = NAN;
    assert_non_null(text);
    assert_int_equal(sscanf(text, "sum of kappa dt/dx^2 is %lf", &sum), 1);
    assert_near(sum, 0.8 * 200.5 / 201 * 31 / 22, 1e-5); /* six digits are printed */
}

static double along_y(const struct problem *p, const double x[2]) {
    return cos(PI * (x[1] - p->lo[1]) / (p->hi[1] - p->lo[1]));
}

static double insulated(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 0;
}

/* Two materials in the plane, the interface 0.3 of a cell behind a face.  T = cos(pi y/H) has no flux along x, and a
 * step of Euler takes (k_y/rho_c) dt (2 sin(pi d/2 H)/d)^2 of it, k_y and rho_c averaged over the cell.  Where both
 * have the same kappa the step's sum of kappa dt/dx^2 is that of both axes. */
static void test_two_materials_in_the_plane(void **state) {
    (void)state;
    const double d = 0.1, first = 0.3, k[2] = {0.7, 0.09}, rho_c[2] = {1.3, 2.9};
    struct problem p = {.dim = 2,
                        .hi = {1, 0.8},
                        .t_end = 1e-3,
                        .materials = 2,
                        .interface = 0.43,
                        .side = {NEUMANN, NEUMANN, NEUMANN, NEUMANN},
                        .initial = along_y,
                        .wall = insulated};
    struct options o = {.dx = d, .dt = 1e-3};
    struct failure why = {0};
    for (int m = 0; m < 2; m++) p.material[m] = (struct material){{k[m], k[m]}, rho_c[m]};
    struct field f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 1);
    for (size_t i = 0; i < f.n; i++) {
        double part = fmin(1, fmax(0, (p.interface - f.x[i]) / d + 0.5)), symbol = 2 * sin(PI * d / 1.6) / d;
        double kappa = (part * k[0] + (1 - part) * k[1]) / (part * rho_c[0] + (1 - part) * rho_c[1]);
        if (f.x[i] > 0.4 && f.x[i] < 0.5) assert_near(part, first, 1e-12);
        assert_near(f.T[i], (1 - kappa * 1e-3 * symbol * symbol) * cos(PI * f.y[i] / 0.8), 1e-14);
    }
    field_free(&f);
    p.material[1] = (struct material){{0.07, 0.07}, 0.13};
    p.t_end = 200 * 0.4 * d * d / (0.7 / 1.3), o.dt = 0, o.fourier = 0.4, p.interface = 0.4;
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
    const char *text = strstr(why.text, "sum of kappa dt/dx^2 is ");
    double sum = NAN;
    assert_non_null(text);
    assert_int_equal(sscanf(text, "sum of kappa dt/dx^2 is %lf", &sum), 1);
    assert_near(sum, 0.4 * (31. / 22 + 1), 1e-5); /* along x the rate of test_rate_of_two_materials */
}

/* The step is whole: t_end / ceil(t_end / dt); a dx that is out by rounding is snapped. */
static void test_whole_steps(void **state) {
    (void)state;
    struct problem p = rod(3);
    struct options o = {.dx = 0.0383333333, .dt = 0.0037};
    struct field f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 100);
    assert_near(f.dt, 0.0037, 1e-18);
    assert_near(f.spacing[0], 2.3 / 60, 1e-16);
    assert_int_equal(f.shape[0], 60);
    assert_int_equal(f.shape[1], 1);
    assert_near(f.time, 0.37, 0);
    field_free(&f);
    o.dt = 0.00371;
    f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 100);
    field_free(&f);
    o.dt = 0.00369;
    f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 101);
    assert_near(f.range[0], 0.83 + 1.9 * sin(3 * PI * 29.5 / 60), 1e-14);
    field_free(&f);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cell_averages_of_a_jump),
        cmocka_unit_test(test_spline_averages_of_a_jump),
        cmocka_unit_test(test_sampling_past_the_walls),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_stability),
        cmocka_unit_test(test_rate_of_two_materials),
        cmocka_unit_test(test_two_materials_in_the_plane),
        cmocka_unit_test(test_whole_steps),
    };
    return cmocka_run_group_tests_name("ftcs run", tests, NULL, NULL);
}
