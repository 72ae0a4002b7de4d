/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors that plane.def predicts for the plate, whose sides disagree at the corners.
 *
 * At a corner T = T_y + (T_x - T_y) 2/pi atan(y/x), and the error depends on position/dx alone: one discrete problem
 * on a quarter of the plane, spacing 1, jump 1, solved by relaxation.  Its rim holds the far field: with L = lap +
 * dx^2 (A (d_x^4 + d_y^4) + B d_x^2 d_y^2) the error e solves lap e = -(2 A - B) T_xxxx, T_xxxx = 12/pi sin(4
 * theta)/r^4, so that e = (2 A - B)/pi sin(4 theta)/r^2.  (sin(2 theta)/r^2, of no source, is even when x and y are
 * swapped; e is odd.)
 *
 * Far from the corners e = dx^2 e_2, from the sine transform of the discrete problem to order dx^2.  A wall at T_w
 * gives the mode sin(k x) sin(l y), D = k^2 + l^2, the steady amplitude c_k c_l T_w R, R = l^2/D, c_k = 4/(k w) for
 * odd k, and the transient one -c_k c_l T_w R exp(-kappa D t).  On the lattice, D becomes D - dx^2 d, d = A (k^4 +
 * l^4) + B k^2 l^2; the wall's l^2 becomes l^2 - dx^2 (A l^4 + B/2 k^2 l^2), the other half of what couples the axes
 * being the other wall's, for which a ghost beyond the corner is the mean of both; and c_k becomes c_k (1 + k^2
 * dx^2/24).  Of the steady amplitude the last adds nothing but at the walls themselves, and the rest is (2 A - B)
 * (k^4 l^2/D^2 - k^2 l^2/(2 D)), which is summed over l: with P = sinh(k (w - y))/sinh(k w), of which -k^3/2 dP/dk
 * and -k^2/2 P. */
#include "verification/unit/stencil_moments.h"

enum { N = 36, GHOSTS = 4, WIDE = N + 2 * GHOSTS };

static const double PI = 3.14159265358979323846;

static double far_field(double x, double y) {
    return 2 / PI * atan2(y, x);
}

static double far_error(double x, double y, double excess) {
    return excess / PI * sin(4 * atan2(y, x)) / (x * x + y * y);
}

static double T[WIDE][WIDE];

/* T at cell (i, j) counted from the corner, -1 being the first ghost: y = 0 holds 0, x = 0 holds 1. */
static double at(int i, int j) {
    int gi = i < 0 ? -1 - i : i, gj = j < 0 ? -1 - j : j;
    double inner = T[gj][gi];
    if (i < 0 && j < 0) return inner; /* the mean of the two orders of reflection, 2 + T and T - 2 */
    if (i < 0) return 2 - inner;
    return j < 0 ? -inner : inner;
}

static double relax(const struct stencil *s) {
    double most = 0;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            double sum = 0;
            for (int b = -s->reach[1]; b <= s->reach[1]; b++)
                for (int a = -s->reach[0]; a <= s->reach[0]; a++)
                    if (a || b) sum += stencil_weight(s, a, b) * at(i + a, j + b);
            double change = -sum / stencil_weight(s, 0, 0) - T[j][i];
            T[j][i] += change;
            most = fmax(most, fabs(change));
        }
    return most;
}

struct corner {
    double largest; /* of a jump of 1 */
    double ratio;   /* of the error to the far field at the cell (7, 2) */
    double core;    /* sum over cells of |e| - |far field| */
};

static struct corner corner_of(const char *method) {
    struct corner c = {0};
    struct stencil s = stencil_of(method, (const double[]){1, 1});
    double excess = 2 * stencil_moment(&s, 4, 0, 0) / 24 - stencil_moment(&s, 2, 2, 0) / 4;
    for (int j = 0; j < WIDE; j++)
        for (int i = 0; i < WIDE; i++) {
            double x = i + 0.5, y = j + 0.5;
            T[j][i] = far_field(x, y) + far_error(x, y, excess);
        }
    while (relax(&s) > 1e-10) continue;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            double e = fabs(T[j][i] - far_field(i + 0.5, j + 0.5));
            c.largest = fmax(c.largest, e);
            c.core += e - fabs(far_error(i + 0.5, j + 0.5, excess));
        }
    c.ratio = (T[2][7] - far_field(7.5, 2.5)) / far_error(7.5, 2.5, excess);
    free(s.w);
    return c;
}

static void the_largest_error_at_a_corner(void **state) {
    (void)state;
    struct corner so = corner_of("so_ssph"), ftcs = corner_of("ftcs"), brookshaw = corner_of("brookshaw");
    assert_near(so.largest, 0.00704, 0.000005);
    assert_near(so.ratio, 1, 0.03); /* dx^4/r^6 beside it */
    assert_near(ftcs.largest, 0.02193, 0.000005);
    assert_near(ftcs.ratio, 1, 0.03);
    assert_near(brookshaw.largest, 0.002926, 0.0000005); /* 2 A - B = -0.0024: no far field to speak of */
}

/* ---- The whole plate: sides y = 0, x = w, y = w, x = 0 ---- */

enum { SIDE = 40, MODES = 30 * SIDE };
static const double WALL[4] = {0.25, 0.5, 0.75, 1}, WIDTH = 0.1, TIME = 28.8894, KAPPA = 60.5 / (7854.0 * 434);
static double e2[SIDE][SIDE], exact[SIDE][SIDE];

/* One wave number along the walls of constant y, and, the axes swapped, along those of constant x. */
static void add_steady(int m, double excess) {
    double k = m * PI / WIDTH, c = 4 / (k * WIDTH), whole = 1 - exp(-2 * k * WIDTH), P[SIDE], off[SIDE];
    for (int j = 0; j < SIDE; j++) {
        double y = (j + 0.5) * WIDTH / SIDE, Y = WIDTH - y, near = exp(-k * y) / whole;
        P[j] = near * (1 - exp(-2 * k * Y));
        double slope = Y * near * (1 + exp(-2 * k * Y)) - P[j] * WIDTH * (2 - whole) / whole;
        off[j] = -excess / 2 * k * k * (k * slope + P[j]);
    }
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            double s = c * sin(k * (i + 0.5) * WIDTH / SIDE);
            int far = SIDE - 1 - j;
            exact[j][i] += s * (WALL[0] * P[j] + WALL[2] * P[far]);
            e2[j][i] += s * (WALL[0] * off[j] + WALL[2] * off[far]);
            exact[i][j] += s * (WALL[3] * P[j] + WALL[1] * P[far]);
            e2[i][j] += s * (WALL[3] * off[j] + WALL[1] * off[far]);
        }
}

/* Amplitude of a pair of opposite walls in the mode, and its part of order dx^2; l is the wave number across them. */
static void amplitude(int along, int across, double lo, double hi, double A, double B, double part[2]) {
    double k = along * PI / WIDTH, l = across * PI / WIDTH, D = k * k + l * l, R = l * l / D;
    double d = A * (pow(k, 4) + pow(l, 4)) + B * k * k * l * l;
    double c = along % 2 ? 4 / (along * PI) * 2 / (across * PI) * (lo + (across % 2 ? hi : -hi)) : 0;
    part[0] += c * R;
    part[1] += c * ((R * d - A * pow(l, 4) - B / 2 * k * k * l * l) / D + R * D / 24);
}

static void add_transient(int m, int n, double A, double B) {
    double k = m * PI / WIDTH, l = n * PI / WIDTH, part[2] = {0, 0}, left = exp(-KAPPA * TIME * (k * k + l * l));
    double d = A * (pow(k, 4) + pow(l, 4)) + B * k * k * l * l;
    amplitude(m, n, WALL[0], WALL[2], A, B, part);
    amplitude(n, m, WALL[3], WALL[1], A, B, part);
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            double mode = left * sin(k * (i + 0.5) * WIDTH / SIDE) * sin(l * (j + 0.5) * WIDTH / SIDE);
            exact[j][i] -= mode * part[0];
            e2[j][i] -= mode * (part[1] + part[0] * KAPPA * TIME * d);
        }
}

struct level {
    double all, interior, boundary; /* E1/dx^2 at 40 cells, m^-2 */
    double growth, boundary_growth; /* of it per unit of log(cells) */
};

static struct level plate(const char *method) {
    struct stencil s = stencil_of(method, (const double[]){1, 1});
    struct corner corner = corner_of(method);
    double A = stencil_moment(&s, 4, 0, 0) / 24, B = stencil_moment(&s, 2, 2, 0) / 4, sum[2][2] = {{0}}, jumps = 1.5;
    memset(e2, 0, sizeof e2);
    memset(exact, 0, sizeof exact);
    for (int m = 1; m < MODES; m += 2) add_steady(m, 2 * A - B);
    for (int m = 1; m <= 12; m++)
        for (int n = 1; n <= 12; n++) add_transient(m, n, A, B);
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            int near = i < SIDE / 10 || j < SIDE / 10 || i >= SIDE - SIDE / 10 || j >= SIDE - SIDE / 10;
            sum[near][0] += fabs(e2[j][i]);
            sum[near][1] += exact[j][i];
        }
    free(s.w);
    double cell = pow(WIDTH / SIDE, 2), core = corner.core * jumps / cell, K = fabs(2 * A - B) / PI * jumps / cell;
    return (struct level){.all = (sum[0][0] + sum[1][0] + core) / (sum[0][1] + sum[1][1]),
                          .interior = sum[0][0] / sum[0][1],
                          .boundary = (sum[1][0] + core) / sum[1][1],
                          .growth = K / (sum[0][1] + sum[1][1]),
                          .boundary_growth = K / sum[1][1]};
}

static void the_error_of_the_plate(void **state) {
    (void)state;
    struct level so = plate("so_ssph"), brookshaw = plate("brookshaw"), ftcs = plate("ftcs");
    assert_near(so.all, 112.9, 0.1);
    assert_near(so.interior, 160.5, 0.1);
    assert_near(so.boundary, 53.04, 0.05);
    assert_near(so.growth, 7.27, 0.01);
    assert_near(so.boundary_growth, 16.40, 0.01);
    assert_near(brookshaw.all, 92.2, 0.1);
    assert_near(brookshaw.growth, 0.24, 0.01);
    assert_near(ftcs.all, 97.4, 0.1);
    assert_near(ftcs.growth, 16.75, 0.01);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_largest_error_at_a_corner),
        cmocka_unit_test(the_error_of_the_plate),
    };
    return cmocka_run_group_tests_name("corner", tests, NULL, NULL);
}
