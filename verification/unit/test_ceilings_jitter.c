/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors that gates/plane.def predicts for rod-gauss of Taylor order 4 on jittered particles: e_t = A e + r.
 *
 * Weights of order 4 leave r = sum over n > 4 of M_n/n! T^(n), M_n = sum w d^n of each particle's own row.  On a
 * lattice odd moments vanish, and e = kappa t C T^(6)(t).  Off it M_5 is of order dx^3 with either sign.  Shifting
 * all particles alike changes no moment, nor does mirroring them: to first order in the shifts M_5 is a second
 * difference of these, which A^-1 takes back but for dx^5.  What is left of M_5 is of second order in the shifts, and
 * a sum of it over the length that heat goes in t.
 *
 * A is taken as that of the lattice, by its symbol: off by the jitter J, as a part of what rough r leaves, the odd
 * moments' share of e.  T^(n) is that of t/2; A spreads it to that of t. */
#include "solver/particles/particles.h"
#include "verification/ladder/slope.h"
#include "verification/unit/stencil_moments.h"

enum { MOST = 8, RUNGS = 11, FINE = 6 };

static const double PI = 3.14159265358979323846, SIGMA0 = 2, KAPPA = 0.01, TIME = 5;

/* d^n/dx^n of the Gaussian at time t, by Hermite's polynomials */
static double gauss(int n, double x, double t) {
    double s = sqrt(SIGMA0 * SIGMA0 + 2 * KAPPA * t), z = x / s, H[2] = {1, z};
    for (int k = 1; k < n; k++) {
        double next = z * H[1] - k * H[0];
        H[0] = H[1], H[1] = next;
    }
    return (n % 2 ? -1 : 1) * (n ? H[1] : 1) / pow(s, n) * SIGMA0 / s * exp(-z * z / 2);
}

static int by_place(const void *a, const void *b) {
    double x = **(const double *const *)a, y = **(const double *const *)b;
    return (x > y) - (x < y);
}

struct predicted {
    double whole, odd; /* E1, and that of the odd moments alone */
};

/* What the moments of each row leave at t/2, in the order of places: even ones in r[0], odd ones in r[1]. */
static void residuals(const struct heat_operator *a, const struct cloud *c, const double **place, double *r[2]) {
    for (size_t q = 0; q < c->n; q++) {
        size_t i = (size_t)(place[q] - c->x);
        double M[MOST + 1] = {0}, n_factorial = 24;
        if (fabs(c->x[i]) > 6 * SIGMA0) continue; /* walls are there, and T^(n) < 1e-4 of its largest */
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++)
            for (int n = 5; n <= MOST; n++) M[n] += a->value[k] * pow(c->x[a->column[k]] - c->x[i], n);
        for (int n = 5; n <= MOST; n++) {
            n_factorial *= n;
            r[n % 2][q] += M[n] / n_factorial * gauss(n, c->x[i], TIME / 2);
        }
    }
}

/* K[m]: what a particle has of a unit residual m particles away, int_0^t exp(s A) ds of the lattice. */
static void spread(const struct stencil *s, double dx, int n, double *K) {
    for (int k = 0; k < n; k++) {
        double theta = 2 * PI * k / n, rate = 0;
        for (int j = 1; j <= s->reach[0]; j++) rate += 2 * stencil_weight(s, j, 0) * (1 - cos(j * theta)) / (dx * dx);
        double held = k == 0 ? TIME : -expm1(-rate * TIME) / rate;
        for (int m = 0; m < n; m++) K[m] += held * cos(theta * m) / n;
    }
}

static struct predicted predict(const char *layout, double dx) {
    char line[120];
    struct request r;
    struct failure why;
    struct lattice l;
    struct cloud c;
    struct heat_operator a;
    snprintf(line, sizeof line, "run rod-gauss so_ssph --order 4 --h 2.2 %s --dx %.17g", layout, dx);
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    const struct problem *p = &r.experiment.problem;
    const struct options *o = &r.experiment.options;
    const struct scheme *scheme = r.experiment.method->scheme;
    struct stencil s;
    if (layout_lattice(p, o, 1, &l, &why) || layout_cloud(p, o, &l, particles_reach(o, scheme, &l), &c, &why) ||
        operator_create_csr(&a, p, o, scheme, &c, dx, &why) ||
        operator_stencil(p, o, scheme, 1, (double[]){KAPPA, 0}, s.reach, &s.w, &why))
        fail_msg("%s", why.text);
    int n = (int)c.n;
    const double **place = xcalloc(c.n, sizeof *place);
    double *K = xcalloc(3 * c.n, sizeof *K), *rest[2] = {K + n, K + 2 * n}, T = 0;
    for (int q = 0; q < n; q++) place[q] = &c.x[q];
    qsort(place, c.n, sizeof *place, by_place);
    residuals(&a, &c, place, rest);
    spread(&s, dx, n, K);
    struct predicted E = {0, 0};
    for (int q = 0; q < n; q++) {
        double even = 0, odd = 0;
        for (int j = 0; j < n; j++) even += K[abs(q - j)] * rest[0][j], odd += K[abs(q - j)] * rest[1][j];
        E.whole += fabs(even + odd), E.odd += fabs(odd), T += gauss(0, *place[q], TIME);
    }
    free(K);
    free(place);
    free(s.w);
    operator_free(&a);
    layout_cloud_free(&c);
    arguments_free(&r);
    return (struct predicted){E.whole / T, E.odd / T};
}

static void errors_on_a_lattice(void **state) {
    (void)state;
    assert_near(predict("", 0.05).whole / pow(0.05, 4), 1.185e-3, 0.001e-3);
    assert_near(predict("", 0.05).odd, 0, 1e-15);
}

static void errors_of_jittered_particles(void **state) {
    (void)state;
    static const double dx[RUNGS] = {0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.125, 0.1, 0.075, 0.0625, 0.05};
    static const struct {
        double jitter;
        int seed;
        double error, slope[2], fine, ceiling; /* at the finest; of 95 %; of six rungs; the gate's */
    } want[] = {
        {0.1, 1, 7.728e-9, {3.923, 4.027}, 3.978, 8.12e-9}, {0.1, 2, 7.447e-9, {3.905, 4.001}, 4.083, 7.80e-9},
        {0.1, 3, 7.552e-9, {3.907, 3.990}, 4.003, 7.94e-9}, {0.3, 1, 8.879e-9, {3.907, 4.062}, 3.942, 1.061e-8},
        {0.3, 2, 7.600e-9, {3.858, 4.016}, 4.099, 8.77e-9}, {0.3, 3, 8.591e-9, {3.854, 4.075}, 3.922, 1.012e-8}};
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        char layout[60];
        double error[RUNGS];
        struct predicted E = {0, 0};
        snprintf(layout, sizeof layout, "--layout jitter --jitter %g --seed %d", want[k].jitter, want[k].seed);
        for (int i = 0; i < RUNGS; i++) E = predict(layout, dx[i]), error[i] = E.whole;
        struct slope order = slope_fit(dx, error, RUNGS);
        assert_near(E.whole, want[k].error, 0.002e-9);
        for (int end = 0; end < 2; end++) assert_near(order.ci[end], want[k].slope[end], 0.001);
        assert_near(slope_fit(dx + RUNGS - FINE, error + RUNGS - FINE, FINE).value, want[k].fine, 0.001);
        /* what the rough part may be off by, and 3 % for all else */
        assert_near(1.03 * (E.whole + want[k].jitter * E.odd), want[k].ceiling, 0.01e-9);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_on_a_lattice),
        cmocka_unit_test(errors_of_jittered_particles),
    };
    return cmocka_run_group_tests_name("predicted, jittered particles of order 4", tests, NULL, NULL);
}
