/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stencils on a cubic lattice against closed forms: moments, symbols, isotropic h/dx, largest Euler steps. */

#include "solver/method.h"
#include "solver/space/kernel.h"
#include "solver/space/operator.h"
#include "solver/time/matched.h"
#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>

extern const struct method method_brookshaw, method_fo_ssph, method_so_ssph;

static const double PI = 3.14159265358979323846;

struct stencil {
    int reach[DIM_MAX];
    double *w;
};

/* On spacing 1, with k and rho_c of the problem. */
static struct stencil stencil_of(const struct method *m, const struct problem *p, const struct options *o) {
    struct stencil s;
    struct failure why;
    double kappa[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) kappa[a] = p->material[0].k[a] / p->material[0].rho_c;
    if (operator_stencil(p, o, m->scheme, 1, kappa, s.reach, &s.w, &why)) fail_msg("%s", why.text);
    return s;
}

/* sum w f(offset) over the octant, with the number of images */
static double total(const struct stencil *s, double (*f)(const int *at, const double *with), const double *with) {
    double sum = 0;
    for (int k = 0; k <= s->reach[2]; k++)
        for (int j = 0; j <= s->reach[1]; j++)
            for (int i = 0; i <= s->reach[0]; i++)
                sum += s->w[operator_offset(s->reach, i, j, k)] * operator_images(i, j, k) *
                       f((const int[]){i, j, k}, with);
    return sum;
}

static double power(const int *at, const double *with) {
    return pow(at[0], with[0]) * pow(at[1], with[1]) * pow(at[2], with[2]);
}

static double wave(const int *at, const double *theta) {
    double product = 1;
    for (int a = 0; a < DIM_MAX; a++) product *= cos(at[a] * theta[a]);
    return product;
}

/* The odd moments and the mixed second ones vanish on an octant; the rest of the ten quadratics are here. */
static void stencils_are_exact_for_quadratics(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_fo_ssph, &method_so_ssph, &method_brookshaw};
    for (int m = 0; m < 4; m++)
        for (int k = 0; kernel_words[k]; k++) {
            struct problem p = odd_box();
            struct options o = {.dx = 0.1, .h = m == 2 ? 2.2 : 1.17, .order = m == 2 ? 4 : 0, .kernel = k};
            if (m == 3) p.material[0].k[1] = p.material[0].k[2] = p.material[0].k[0];
            struct stencil s = stencil_of(all[m], &p, &o);
            assert_near(total(&s, power, (const double[]){0, 0, 0}), 0, 1e-14);
            for (int a = 0; a < DIM_MAX; a++) {
                double square[DIM_MAX] = {0}, fourth[DIM_MAX] = {0};
                square[a] = 2, fourth[a] = 4;
                assert_near(total(&s, power, square), 2 * p.material[0].k[a] / p.material[0].rho_c, 1e-13);
                if (m == 2) assert_near(total(&s, power, fourth), 0, 1e-11);
            }
            free(s.w);
        }
}

/* ---- Closed forms for k_x = k_y = k_z ---- */

static struct problem unit_cube(void) {
    return (struct problem){
        .dim = 3, .hi = {1, 1, 1}, .materials = 1, .material = {{{1, 1, 1}, 1}}, .wall = problem_held};
}

/* The unnormalised weight of the pair at the distance r for each operator. */
static double pair_weight(const struct method *m, const struct options *o, double r) {
    if (m == &method_so_ssph) return kernel_value(o->kernel, 3, r / o->h) * r * r; /* z . P_j is along |s|^2 */
    if (m == &method_fo_ssph) return kernel_value(o->kernel, 3, r / o->h);
    return -kernel_slope(o->kernel, 3, r / o->h) * r / (r * r + 0.01 * o->h * o->h);
}

/* sum w_j (cos(theta . x_j) - 1) with sum w_j x_j^2 = 2; FO: -sum_a (sum_j w_j x_ja sin(theta . x_j))^2 with
 * sum w_j x_j^2 = 1. */
static double symbol(const struct method *m, const struct options *o, const double *theta) {
    const int first = m == &method_fo_ssph, r = 3;
    double second = 0, even = 0, odd[DIM_MAX] = {0};
    for (int k = -r; k <= r; k++)
        for (int j = -r; j <= r; j++)
            for (int i = -r; i <= r; i++) {
                int at[DIM_MAX] = {i, j, k}, square = i * i + j * j + k * k;
                if (square == 0 || square >= 4 * o->h * o->h) continue;
                double w = pair_weight(m, o, sqrt(square)), phase = i * theta[0] + j * theta[1] + k * theta[2];
                second += w * i * i;
                even += w * (cos(phase) - 1);
                for (int a = 0; a < DIM_MAX; a++) odd[a] += w * at[a] * sin(phase);
            }
    if (!first) return 2 * even / second;
    return -(odd[0] * odd[0] + odd[1] * odd[1] + odd[2] * odd[2]) / (second * second);
}

static const struct method *const operators[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw};

static void symbols_equal_their_closed_forms(void **state) {
    (void)state;
    for (int m = 0; m < 3; m++)
        for (int k = 0; kernel_words[k]; k++)
            for (double h = 0.97; h < 1.4; h += 0.14) {
                struct problem p = unit_cube();
                struct options o = {.dx = 0.1, .h = h, .kernel = (enum kernel_name)k};
                struct stencil s = stencil_of(operators[m], &p, &o);
                for (int n = 0; n < 12; n++) {
                    double theta[DIM_MAX] = {fmod(0.37 + 1.1 * n, PI), fmod(0.71 + 2.3 * n, PI), fmod(1.9 * n, PI)};
                    assert_near(total(&s, wave, theta), symbol(operators[m], &o, theta), 1e-12);
                }
                free(s.w);
            }
}

/* -|theta|^2 + A sum theta_a^4 + B sum theta_a^2 theta_b^2 leaves O(theta^6). */
static void matched_symbol_is_the_leading_error(void **state) {
    (void)state;
    for (int k = 0; kernel_words[k]; k++) {
        struct options o = {.dx = 0.1, .h = 1.17, .kernel = (enum kernel_name)k};
        struct symbol_error e;
        struct failure why;
        double left[2];
        assert_int_equal(matched_symbol(3, &o, method_so_ssph.scheme, &e, &why), STATUS_OK);
        for (int half = 0; half < 2; half++) {
            double t[DIM_MAX] = {0.21, 0.33, 0.27}, fourth = 0, mixed = 0, square = 0;
            for (int a = 0; a < DIM_MAX; a++) t[a] /= 1 + half, square += t[a] * t[a], fourth += pow(t[a], 4);
            mixed = (square * square - fourth) / 2;
            left[half] = symbol(&method_so_ssph, &o, t) + square - e.A * fourth - e.B * mixed;
        }
        assert_near(left[0] / left[1], 64, 1.5);
    }
}

/* B = 2 A for weights c W |x|^2: sum W |x|^2 (3 x^2 y^2 - x^4) = 0. */
static double isotropy(const struct options *o) {
    double sum = 0;
    for (int k = -2; k <= 2; k++)
        for (int j = -2; j <= 2; j++)
            for (int i = -2; i <= 2; i++) {
                double square = i * i + j * j + k * k, fourth = pow(i, 4);
                if (square == 0 || square >= 4 * o->h * o->h) continue;
                sum += kernel_value(o->kernel, 3, sqrt(square) / o->h) * square * (3.0 * i * i * j * j - fourth);
            }
    return sum;
}

static void isotropic_ratios_solve_their_equation(void **state) {
    (void)state;
    static const double known[] = {0.9742, 1.0298, 1.0269};
    for (int k = 0; kernel_words[k]; k++) {
        struct options o = {.dx = 0.1, .kernel = (enum kernel_name)k};
        struct symbol_error e;
        struct failure why;
        double h, slope;
        assert_int_equal(matched_isotropic(3, &o, method_so_ssph.scheme, &h, &why), STATUS_OK);
        assert_near(h, known[k], 5e-5);
        o.h = h + 1e-6, slope = isotropy(&o) / 1e-6;
        o.h = h;
        assert_near(isotropy(&o) / slope, 0, 1e-10);
        assert_int_equal(matched_symbol(3, &o, method_so_ssph.scheme, &e, &why), STATUS_OK);
        /* with neighbours one particle away along each axis x^4 = x^2: A = 1/12 */
        if (k == 0) assert_near(e.A, 1.0 / 12, 1e-14);
    }
}

/* ---- Largest Euler step ---- */

/* The largest |symbol| over the cosine modes of a cube of n particles a side. */
static double largest(const struct method *m, const struct options *o, int n) {
    double most = 0;
    for (int a = 0; a < n; a++)
        for (int b = 0; b <= a; b++)
            for (int c = 0; c <= b; c++)
                most = fmax(most, -symbol(m, o, (const double[]){PI * a / n, PI * b / n, PI * c / n}));
    return most;
}

static double rough(const struct problem *p, const double *x) {
    (void)p;
    return sin(1e4 * sin(12.9898 * x[0] + 78.233 * x[1] + 37.719 * x[2]));
}

/* Steps of 2/S in units of dx^2/kappa: noise decays just below, grows just above. */
static void euler_is_stable_up_to_two_over_the_symbol(void **state) {
    (void)state;
    enum { N = 10 };
    for (int m = 0; m < 3; m++)
        for (int k = 0; kernel_words[k]; k++)
            for (int above = 0; above < 2; above++) {
                struct problem p = unit_cube();
                struct options o = {.dx = 1.0 / N, .h = 1.1, .stepper = STEPPER_EULER, .kernel = (enum kernel_name)k};
                struct field f;
                struct failure why;
                for (int s = 0; s < SIDES; s++) p.side[s] = NEUMANN;
                p.initial = rough;
                o.dt = (above ? 2.02 : 1.98) / largest(operators[m], &o, N) * o.dx * o.dx;
                p.t_end = 2000 * o.dt;
                int status = method_solve(operators[m], &p, &o, &f, &why);
                assert_int_equal(status, above ? STATUS_UNSTABLE : STATUS_OK);
                if (!status) field_free(&f);
            }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stencils_are_exact_for_quadratics),
        cmocka_unit_test(symbols_equal_their_closed_forms),
        cmocka_unit_test(matched_symbol_is_the_leading_error),
        cmocka_unit_test(isotropic_ratios_solve_their_equation),
        cmocka_unit_test(euler_is_stable_up_to_two_over_the_symbol),
    };
    return cmocka_run_group_tests_name("box_stencils", tests, NULL, NULL);
}
