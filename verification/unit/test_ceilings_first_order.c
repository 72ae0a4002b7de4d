/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors of first order that gates/plane.def and gates/materials.def predict: what is blind to (-1)^i at jumps,
 * walls and corners, and the resistance that a mean of two conductivities adds. */
#include "references/scene.h"
#include "verification/unit/stencil_moments.h"

static const double PI = 3.14159265358979323846, PLATE = 0.1; /* m */
enum { N = 50, CORNER = 80, IMAGES = 2 };

static double gauss(double x, double kt) {
    return exp(-x * x / (4 * kt)) / sqrt(4 * PI * kt);
}

static double box(double x, double lo, double hi, double kt) {
    return (erf((x - lo) / sqrt(4 * kt)) - erf((x - hi) / sqrt(4 * kt))) / 2;
}

/* Diffusivities of the envelope of (-1)^i, across and along its lines, over kappa. */
static struct stencil blind(const char *method, double *m, double *n) {
    const double one[2] = {1, 1};
    struct stencil s = stencil_of(method, one);
    *m = stencil_moment(&s, 2, 0, 1) / 2, *n = stencil_moment(&s, 0, 2, 1) / 2;
    return s;
}

/* E1/dx of square-step at its defaults: half of the jump of 1 at x = -a, as much of the other sign at x = a. */
static double of_square(const char *method) {
    const double L = 2, a = 0.5, kt = 0.05;
    double m, n, sum = 0;
    free(blind(method, &m, &n).w);
    for (int j = 0; j < 4 * N; j++)
        for (int i = 0; i < 4 * N; i++) {
            double x[2] = {-L + L * (i + 0.5) / (2 * N), -L + L * (j + 0.5) / (2 * N)}, g[2];
            for (int d = 0; d < 2; d++)
                g[d] = (gauss(x[d] + a, m * kt) - gauss(x[d] - a, m * kt)) / 2 * box(x[1 - d], -a, a, n * kt);
            sum += fmax(fabs(g[0]), fabs(g[1])) * L * L / (4 * N * N);
        }
    return sum / (4 * a * a);
}

/* E1 of rod-step at its defaults, of what is blind to (-1)^i with first derivatives of weights c[j], -c[-j] at j dx.
 * Samples of a jump `off` dx beyond the middle of two particles are those of a piece that is so much wider; of
 * (-1)^i they hold `half` dx of a source at either edge, of either sign since the hot particles are even in number.
 * dx^2 is the operator's A and the samples' -+ 1/24; even and odd particles have U + V and U - V, of mean max. */
static double of_rod(const double c[3], double dx, double off, double half, int averages) {
    const double L = 2, a = 0.5, kt = 0.05, wide = a + off * dx;
    double D = 2 * (-c[1] + 2 * c[2]), A = 2 * (c[1] + 8 * c[2]) / 3, sum = 0;
    for (int i = 0; i < 100 * N; i++) {
        double x = -L + 2 * L * (i + 0.5) / (100 * N), u[2], g[2];
        for (int e = 0; e < 2; e++) {
            double z = x + (e ? -a : a), T_xx = -z / (2 * kt), T_4x = (3 - z * z / (2 * kt)) * z / (4 * kt * kt);
            u[e] = dx * dx * (A * kt * T_4x + (averages ? T_xx : -T_xx) / 24) * gauss(z, kt);
            g[e] = half * dx * gauss(z, D * D * kt);
        }
        double U = box(x, -wide, wide, kt) - box(x, -a, a, kt) + u[0] - u[1];
        sum += fmax(fabs(U), fabs(g[0] - g[1])) * L / (50 * N);
    }
    return sum / (2 * a);
}

static void jumps_off_the_middle(void **state) {
    (void)state;
    double c[3] = {0}, sum = 0;
    for (int j = 1; j < 3; j++) { /* j W(j)/(2 sum j^2 W), of the cubic kernel at h/dx = 1.1 */
        double s = j / 1.1;
        c[j] = j * (s < 1 ? 2.0 / 3 - s * s * (1 - s / 2) : pow(2 - s, 3) / 6);
        sum += 2 * j * c[j];
    }
    for (int j = 1; j < 3; j++) c[j] /= sum;
    const double quarter = 4.0 / 642, on = 4.0 / 644, flux[3] = {0, 0.5, 0};
    assert_near(of_rod(c, quarter, -0.25, 0.5, 0), 5.716e-3, 1e-6);
    assert_near(of_rod(c, quarter, 0, 0.25, 1), 2.801e-3, 1e-6);
    assert_near(of_rod(c, on, 0.5, 0.5, 0), 6.287e-3, 1e-6);
    assert_near(of_rod(c, on, 0, 0, 1), 4.559e-5, 1e-8);
    assert_near(of_rod(flux, quarter, -0.25, 0.5, 0), 5.637e-3, 1e-6);
    assert_near(of_rod(flux, quarter, 0, 0.25, 1), 2.761e-3, 1e-6);
    assert_near(of_rod(flux, on, 0.5, 0.5, 0), 6.224e-3, 1e-6);
}

/* 1 on the wall x = 0, 0 on y = 0, mirrored at both as ghosts are: what the temperature is near a corner. */
static double near_corner(int i, int j) {
    double value = 2 / PI * atan2(fabs(j + 0.5), fabs(i + 0.5));
    return i < 0 && j >= 0 ? 2 - value : j < 0 && i >= 0 ? -value : value;
}

/* sum r (-1)^i y over the cells of a corner, r the stencil's error there */
static double pull_of_corner(const struct stencil *s) {
    double sum = 0;
    for (int j = 0; j < CORNER; j++)
        for (int i = 0; i < CORNER; i++) {
            double r = 0;
            for (int b = -s->reach[1]; b <= s->reach[1]; b++)
                for (int a = -s->reach[0]; a <= s->reach[0]; a++)
                    r += stencil_weight(s, a, b) * near_corner(i + a, j + b);
            sum += r * (i % 2 ? -1 : 1) * (j + 0.5) * (i == CORNER - 1 ? 0.5 : 1);
        }
    return sum;
}

/* A pair of sources at the corner, of moment 1 along y for a time t, insulated at x = 0 and at zero along y. */
static double pulled(double x, double y, double mk, double nk, double t) {
    enum { TIMES = 60 };
    double sum = 0;
    for (int k = 0; k < TIMES; k++) {
        double u = (k + 0.5) / TIMES, s = t * pow(u, 4), a = 0, b = 0;
        for (int image = -1; image <= 1; image++) {
            double y_image = y - 2 * image * PLATE;
            a += 2 * gauss(x - 2 * image * PLATE, mk * s);
            b += y_image / (nk * s) * gauss(y_image, nk * s);
        }
        sum += a * b * t * 4 * pow(u, 3) / TIMES;
    }
    return sum;
}

/* The envelope of (-1)^i at x, y: wall[0], wall[1] across its lines, wall[2], wall[3] along them. */
static double envelope(double x, double y, const double wall[4], const double k[3], double pull, double t) {
    double start = 0, along = 0, corners = 0;
    for (int i = -IMAGES; i <= IMAGES; i++) {
        start -= wall[0] * gauss(x - 2 * i * PLATE, k[1] * t) - wall[1] * gauss(PLATE - x - 2 * i * PLATE, k[1] * t);
        along += (i % 2 ? -1 : 1) * box(y, i * PLATE, (i + 1) * PLATE, k[2] * t);
    }
    for (int e = 0; e < 2; e++)
        for (int f = 0; f < 2; f++)
            corners += (e ? -1 : 1) * (wall[e] - wall[2 + f]) * k[0] * pull *
                       pulled(e ? PLATE - x : x, f ? PLATE - y : y, k[1], k[2], t);
    return start * along + corners;
}

/* E1/dx of the plate at its defaults, m^-1 */
static double of_plate(const char *method) {
    const struct scene *scene = scene_find("plate");
    struct problem p;
    struct failure why;
    double m, n, sum = 0, heat = 0;
    struct stencil s = blind(method, &m, &n);
    scene_defaults(scene, &p);
    assert_int_equal(scene->setup(&p, &why), STATUS_OK);
    double kappa = p.material[0].k[0] / p.material[0].rho_c, k[3] = {kappa, m * kappa, n * kappa}, wall[4];
    for (int side = 0; side < 4; side++) wall[side] = p.wall(&p, (enum side)side, p.lo);
    const double turned[4] = {wall[2], wall[3], wall[0], wall[1]}, pull = pull_of_corner(&s);
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            double x[2] = {PLATE * (i + 0.5) / N, PLATE * (j + 0.5) / N};
            sum += fmax(fabs(envelope(x[0], x[1], wall, k, pull, p.t_end)),
                        fabs(envelope(x[1], x[0], turned, k, pull, p.t_end)));
            heat += scene_exact(scene, &p, x, p.t_end).temperature;
        }
    free(s.w);
    return sum / heat;
}

static void jumps_walls_and_corners(void **state) {
    (void)state;
    assert_near(of_square("fo_ssph"), 1.487, 0.004);
    assert_near(of_square("ftcs_flux"), 1.294, 0.004);
    assert_near(of_plate("fo_ssph"), 21.2, 0.15); /* near corners a grid of 50 x 50 loses a little */
    assert_near(of_plate("ftcs_flux"), 11.9, 0.15);
}

/* ---- Two materials ---- */

enum { ROD = 60, REACH = 3 };

/* Weights of the cubic kernel's pairs, exact for x^2; eta = 0.1 h. */
static int pair_weights(double h, double c[REACH + 1]) {
    double moment = 0;
    int reach = 0;
    for (int m = 1; m <= REACH && m < 2 * h; m++, reach++) {
        double s = m / h, slope = s < 1 ? s * (2 - 1.5 * s) : (2 - s) * (2 - s) / 2;
        c[m] = slope * m / (m * m + 0.01 * h * h);
        moment += c[m] * m * m;
    }
    for (int m = 1; m <= reach; m++) c[m] /= moment;
    return reach;
}

/* The flux through 2 ROD cells between far ones that hold the profile of a unit flux, -J higher on the right. */
static double flux_with(double J, const double k[2], double mean, double h) {
    static double a[2 * ROD][2 * ROD], T[2 * ROD];
    double c[REACH + 1];
    int reach = pair_weights(h, c);
    memset(a, 0, sizeof a);
    for (int i = 0; i < 2 * ROD; i++) {
        T[i] = 0;
        for (int j = i - reach; j <= i + reach; j++) {
            if (j == i) continue;
            double x = j + 0.5 - ROD, w = c[abs(j - i)] * ((i < ROD) != (j < ROD) ? mean : k[i >= ROD]);
            a[i][i] += w;
            if (j >= 0 && j < 2 * ROD)
                a[i][j] -= w;
            else
                T[i] += w * (x < 0 ? -x / k[0] : J - x / k[1]);
        }
    }
    for (int p = 0; p < 2 * ROD; p++) /* Gauss; the matrix is banded and diagonally dominant */
        for (int q = p + 1; q < 2 * ROD && q <= p + reach; q++) {
            double f = a[q][p] / a[p][p];
            for (int z = p; z < 2 * ROD && z <= p + 2 * reach; z++) a[q][z] -= f * a[p][z];
            T[q] -= f * T[p];
        }
    for (int p = 2 * ROD - 1; p >= 0; T[p] /= a[p][p], p--)
        for (int z = p + 1; z < 2 * ROD && z <= p + 2 * reach; z++) T[p] -= a[p][z] * T[z];
    return k[1] * (T[3 * ROD / 2] - T[7 * ROD / 4]) / (7 * ROD / 4 - 3 * ROD / 2);
}

/* R: the jump -J at which the flux is 1 */
static double resistance(double k1, double k2, int arithmetic, double h) {
    const double k[2] = {k1, k2};
    double mean = arithmetic ? (k1 + k2) / 2 : 2 * k1 * k2 / (k1 + k2);
    double none = flux_with(0, k, mean, h), one = flux_with(1, k, mean, h);
    return -(1 - none) / (one - none);
}

static void means_add_a_resistance(void **state) {
    (void)state;
    assert_near(resistance(0.01, 0.001, 1, 0.9), 1 / 0.0055 - 550, 1e-6);
    assert_near(resistance(0.01, 0.001, 0, 0.9), 0, 1e-6);
    assert_near(resistance(0.01, 0.001, 0, 1.1), -9.90, 0.005);
    assert_near(resistance(0.01, 0.001, 0, 2), -123.4, 0.05);
    assert_near(resistance(1, 0.001, 0, 1.1), -13.40, 0.005);
}

/* ---- The contact itself: the same pair sums, Runge and Kutta's four stages, and erf ---- */

enum { CELLS = 320 };

static void heating(const double *T, const double c[REACH + 1], int reach, int n, double rate[CELLS]) {
    const double k[2] = {0.01, 0.001}, rho_c[2] = {2, 0.5}, across = 2 * k[0] * k[1] / (k[0] + k[1]);
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int j = i - reach; j <= i + reach; j++) {
            if (j == i) continue;
            int one = i >= n / 2, other = j >= n / 2;
            double T_j = j < 0 ? 2 - T[-1 - j] : j >= n ? -T[2 * n - 1 - j] : T[j]; /* walls of 1 and 0 */
            sum += c[abs(j - i)] * (one == other ? k[one] : across) * (T_j - T[i]);
        }
        rate[i] = sum / rho_c[i >= n / 2] * n * n / 4;
    }
}

/* E1 of rod-contact at its defaults on n particles */
static double of_contact(int n, double h) {
    double T[CELLS], c[REACH + 1], stage[CELLS], rate[4][CELLS], sum = 0, heat = 0;
    int reach = pair_weights(h, c), steps = (int)ceil(0.005 * n * n / 4 / 0.2);
    const double part[4] = {0, 0.5, 0.5, 1}, weight[4] = {1 / 6.0, 1 / 3.0, 1 / 3.0, 1 / 6.0}, dt = 1.0 / steps;
    for (int i = 0; i < n; i++) T[i] = i < n / 2;
    for (int step = 0; step < steps; step++) {
        for (int s = 0; s < 4; s++) {
            for (int i = 0; i < n; i++) stage[i] = T[i] + (s ? part[s] * dt * rate[s - 1][i] : 0);
            heating(stage, c, reach, n, rate[s]);
        }
        for (int s = 0; s < 4; s++)
            for (int i = 0; i < n; i++) T[i] += weight[s] * dt * rate[s][i];
    }
    double e1 = sqrt(0.01 * 2), e2 = sqrt(0.001 * 0.5), T_c = e1 / (e1 + e2);
    for (int i = 0; i < n; i++) {
        double x = (2 * i + 1.0 - n) / n;
        double exact = x < 0 ? T_c + (1 - T_c) * erf(-x / sqrt(4 * 0.005)) : T_c * erfc(x / sqrt(4 * 0.002));
        sum += fabs(T[i] - exact), heat += exact;
    }
    return sum / heat;
}

static void a_short_ladder_at_the_contact(void **state) {
    (void)state;
    const double slopes[4] = {0, 2.3115, 2.3580, 2.4084};
    for (int r = 1; r < 4; r++)
        assert_near(log2(of_contact(20 << r, 1.1) / of_contact(40 << r, 1.1)), slopes[r], 1e-4);
    assert_near(of_contact(320, 1.1), 3.184e-5, 1e-8);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jumps_off_the_middle),
        cmocka_unit_test(jumps_walls_and_corners),
        cmocka_unit_test(means_add_a_resistance),
        cmocka_unit_test(a_short_ladder_at_the_contact),
    };
    return cmocka_run_group_tests_name("predicted, first order", tests, NULL, NULL);
}
