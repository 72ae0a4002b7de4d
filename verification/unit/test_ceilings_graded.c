/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors that gates/cooling.def predicts for rod-cooling on a graded rod: the operator's error equation, solved.
 *
 * A cell is s wide, s = dx a (1 + (R - 1) x/L)/(R - 1), a = ln R, and e^(a/n) times as wide as the one before: with
 * M_3 = C a/n s and M_4 = A s^2, the third and fourth moments of the weights over 3! and 4!, what the discrete
 * solution has beside T is e,
 *   e_t = kappa (e_xx + M_3 T_xxx + M_4 T_xxxx),   e = 0 at x = 0,   e_x + b/k e = (2 A - w) s^2 T_xxx at x = L:
 * ghosts with their own sources' distances miss 2 A s^2 of the slope, of which rows that lie midway take w = 1/12 off
 * (test_ceilings_robin.c); the ghosts of a lattice have 1/12 in place of all of it.  T_x jumps at the cooled end from
 * the start on, by g: sums over midpoints keep the heat, and have s^2/24 g less of it than T.  Everything in dx^2. */
#include "solver/space/operator.h"
#include "references/cooling.h"
#include "verification/command/arguments.h"
#include "verification/command/request.h"
#include "verification/unit/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 600, MODES = 160, STEPS = 200 };

static const double L = 0.3, K = 52, RHO_C = 3.6e6, T0 = 100, B = 750, T_A = 5, TIME = 600;

/* sum w d^power of a particle amid cells that grow by a factor of e^growth, for kappa = 1 and its own cell 1 wide. */
static double moment(const char *method, double growth, int power) {
    double d[8][2], V[8], H[8], weight[8], *w[2] = {weight, NULL}, sum = 0;
    struct neighbourhood nb = {.dim = 1, .d = d, .h = 1.1, .volume = 1, .rho_c = 1, .kappa = {1, 1}, .V = V, .H = H};
    struct request r;
    struct failure why;
    char line[80];
    snprintf(line, sizeof line, "run rod-cooling %s --dx 0.01", method);
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    for (int k = -4; k <= 4; k++) {
        double wide = exp(growth * k), away = k * 1.0;
        if (growth > 0) away = (exp(growth * k) - 1) / (exp(growth / 2) - exp(-growth / 2)) * cosh(growth / 2);
        if (k == 0 || fabs(away) >= 1.1 * (1 + wide)) continue;
        d[nb.n][0] = away, d[nb.n][1] = 0, V[nb.n] = wide, H[nb.n++] = 1.1 * wide;
    }
    if (operator_weights(r.experiment.method->scheme, &r.experiment.problem, &r.experiment.options, &nb, w, &why))
        fail_msg("%s", why.text);
    for (size_t j = 0; j < nb.n; j++) sum += weight[j] * pow(d[j][0], power);
    arguments_free(&r);
    return sum;
}

/* One implicit step: e with the right side r, ghosts odd at x = 0 and e_(n) = end e_(n - 1) beyond L; lambda = kappa
 * dt/h^2. */
static void solve(double lambda, double end, double e[N]) {
    static double above[N];
    for (int i = 0; i < N; i++) {
        double diagonal = 1 + 2 * lambda + (i == 0 ? lambda : 0) - (i == N - 1 ? lambda * end : 0);
        double pivot = diagonal + (i > 0 ? lambda * above[i - 1] : 0);
        above[i] = -lambda / pivot;
        e[i] = (e[i] + (i > 0 ? lambda * e[i - 1] : 0)) / pivot;
    }
    for (int i = N - 2; i >= 0; i--) e[i] -= above[i] * e[i + 1];
}

/* E1/dx^2 where both ends start as the held one is; cells R times as wide at L as at 0; a lattice: its own ghosts. */
static double predicted(const char *method, double R, int lattice) {
    static double sine[N][MODES], cosine[N][MODES];
    const double h = L / N, kappa = K / RHO_C, biot = B / K, a = log(R), T1 = T0, growth = 1e-3;
    const double A = moment(method, 0, 4) / 24, C = moment(method, growth, 3) / 6 / growth;
    double q[MODES], c[MODES], e[N] = {0}, s[N], T = 0, sum = 0, line = (T_A - T1) * biot / (1 + biot * L);
    for (int m = 0; m < MODES; m++) {
        struct cooling_mode mode = cooling_mode(m + 1, 0, L, biot);
        q[m] = mode.q;
        c[m] = ((T0 - T1) * (1 - mode.end_cosine) + (T_A - T1) * mode.end_cosine) / (mode.q * mode.norm);
        for (int i = 0; i < N; i++) sine[i][m] = sin(q[m] * (i + 0.5) * h), cosine[i][m] = cos(q[m] * (i + 0.5) * h);
    }
    for (int i = 0; i < N; i++) s[i] = R > 1 ? a * (1 / (R - 1) + (i + 0.5) / N) : 1;
    double end = s[N - 1] * s[N - 1], wall = (lattice ? 1.0 / 12 : 2 * A - 1.0 / 12) * end, before = 0;
    e[N - 1] = -biot * (T0 - T_A) * end / 24 / h;
    for (int n = 0; n < STEPS; n++) {
        double after = TIME * pow(1e-7, 1 - (n + 1.0) / STEPS), dt = after - before, lambda = kappa * dt / (h * h);
        double third[MODES], fourth[MODES], slope = 0;
        for (int m = 0; m < MODES; m++) { /* integrals over the step, times kappa */
            double part =
                c[m] / (q[m] * q[m]) * (exp(-kappa * q[m] * q[m] * before) - exp(-kappa * q[m] * q[m] * after));
            third[m] = -pow(q[m], 3) * part, fourth[m] = pow(q[m], 4) * part;
            slope += third[m] * cos(q[m] * L);
        }
        for (int i = 0; i < N; i++)
            for (int m = 0; m < MODES; m++)
                e[i] += C * a / L * s[i] * third[m] * cosine[i][m] + A * s[i] * s[i] * fourth[m] * sine[i][m];
        e[N - 1] += wall * slope / h / (1 + biot * h / 2);
        solve(lambda, (1 - biot * h / 2) / (1 + biot * h / 2), e);
        before = after;
    }
    for (int i = 0; i < N; i++) {
        double u = T1 + line * (i + 0.5) * h;
        for (int m = 0; m < MODES; m++) u += c[m] * exp(-kappa * q[m] * q[m] * TIME) * sine[i][m];
        sum += fabs(e[i]), T += u;
    }
    return sum / T;
}

static void errors_of_a_graded_rod(void **state) {
    (void)state;
    /* a lattice's are known from its modes: this equation, another way */
    assert_near(predicted("so_ssph", 1, 1), 1.635, 0.008);
    assert_near(predicted("schwaiger", 1, 1), 1.588, 0.008);
    assert_near(predicted("so_ssph", 4, 0), 13.19, 0.03);
    assert_near(predicted("so_ssph", 2, 0), 6.48, 0.02);
    assert_near(predicted("fatehi_manzari", 4, 0), 8.62, 0.02);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(errors_of_a_graded_rod)};
    return cmocka_run_group_tests_name("predicted, a cooled rod of graded cells", tests, NULL, NULL);
}
