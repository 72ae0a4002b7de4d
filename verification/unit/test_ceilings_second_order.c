/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors that gates/manufactured.def predicts, of second and of fourth order: e_t = L e + r on a grid of its own,
 * r what the stencil and the source leave.  Walls are of fourth order, so that they count in the fourth alone: a
 * ghost at the distance d then misses d^4/12 (T_xxxx + k_y/k_x T_yyyy) on an x side, and on a y side, n its normal,
 * d^5/60 T_nnnnn + d^5/18 G_nnn/k_y + d^5/36 k_x/k_y T_nxxxx (solver/space/layout.c). */
#include "verification/unit/stencil_moments.h"

enum { NX = 60, NY = 42 };

static const double PI = 3.14159265358979323846, HEIGHT = 0.7, TIME = 2, AMPLITUDE = 0.8, RHO_C = 1.7;

/* d^(a + b) S / dx^a dy^b of the steady part; its 1 counts in S alone */
static double S(double x, double y, int a, int b) {
    double rate = 1.1 / HEIGHT;
    return (a + b == 0) + 0.5 * pow(0.8, a) * exp(0.8 * x) * pow(rate, b) * cos(rate * y + 0.4 + b * PI / 2);
}

struct sides {
    double x[2][NY], y[2][NX]; /* e on the x sides; its outward slope on the y sides */
};

/* e(TIME) from e(0) in place. */
static void diffuse(double e[NY][NX], const double kappa[2], double r[NY][NX], const struct sides *at) {
    static double next[NY][NX];
    double hx = 1.0 / NX, hy = HEIGHT / NY, dt = 0.2 / (kappa[0] / hx / hx + kappa[1] / hy / hy);
    int steps = (int)ceil(TIME / dt);
    dt = TIME / steps;
    for (int s = 0; s < steps; s++) {
        for (int j = 0; j < NY; j++)
            for (int i = 0; i < NX; i++) {
                double c = e[j][i], side[4];
                for (int hi = 0; hi < 2; hi++) {
                    side[hi] = i == (hi ? NX - 1 : 0) ? 2 * at->x[hi][j] - c : e[j][i + 2 * hi - 1];
                    side[2 + hi] = j == (hi ? NY - 1 : 0) ? c + at->y[hi][i] * hy : e[j + 2 * hi - 1][i];
                }
                next[j][i] = c + dt * (kappa[0] * (side[0] + side[1] - 2 * c) / hx / hx +
                                       kappa[1] * (side[2] + side[3] - 2 * c) / hy / hy + r[j][i]);
            }
        memcpy(e, next, sizeof next);
    }
}

/* sum w x_i^a x_ghost^b across a wall, over pairs of row and ghost */
static double across(const struct stencil *s, int axis, int a, int b) {
    double sum = 0;
    for (int i = 0; i < s->reach[axis]; i++)
        for (int k = i + 1; k <= s->reach[axis]; k++)
            for (int m = -s->reach[1 - axis]; m <= s->reach[1 - axis]; m++)
                sum += (axis ? stencil_weight(s, m, k) : stencil_weight(s, k, m)) * pow(i + 0.5, a) *
                       pow(k - i - 0.5, b);
    return sum;
}

struct row {
    const char *method;
    double k_y;
    int degree;     /* of the derivatives left: 4, 6 */
    int spline;     /* order of the averages at the start, 0 for points */
    double F;       /* of Euler's steps, 0 for exact ones */
    double stretch; /* dy / dx */
    double matched; /* dx, m, of the matched run; 0 for others */
    double want;    /* E1 / dx^(degree - 2) */
};

/* What Euler's steps of the matched run make of the mode less what the solution does, over dx^4. */
static double matched_mode(const struct stencil *s, const struct row *o, double A, double rate) {
    double kappa = 0.02 / RHO_C, dx = o->matched, theta[2] = {2 * PI * dx, PI / HEIGHT * o->stretch * dx}, lambda = 0;
    double ideal = TIME * kappa / (2 * A * dx * dx), steps = 2 * ceil(ideal / 2), u = sqrt(steps / ideal - 1);
    for (int j = -s->reach[1]; j <= s->reach[1]; j++)
        for (int i = -s->reach[0]; i <= s->reach[0]; i++)
            lambda += stencil_weight(s, i, j) * cos(i * theta[0]) * cos(j * theta[1]) / (dx * dx);
    double z = TIME / steps * lambda, pair = (1 + z * (1 + u)) * (1 + z * (1 - u));
    return (exp(steps / 2 * log(pair)) - exp(-rate * TIME)) / pow(dx, 4);
}

static double predicted(const struct row *o) {
    static double r[NY][NX], e[NY][NX];
    static struct sides at;
    double k[2] = {0.02, o->k_y}, kappa[2] = {k[0] / RHO_C, k[1] / RHO_C}, q = 2 * PI, p = PI / HEIGHT, moment[7],
           sum = 0;
    double rate = kappa[0] * q * q + kappa[1] * p * p, mode = 0, mean = 0;
    struct stencil s = stencil_of(o->method, (double[2]){kappa[0], kappa[1] / (o->stretch * o->stretch)});
    double A = stencil_moment(&s, 4, 0, 0) / 24 / kappa[0];
    for (int b = 0, n = o->degree; b <= n; b += 2) {
        moment[b] = stencil_moment(&s, n - b, b, 0) * pow(o->stretch, b) / tgamma(n - b + 1) / tgamma(b + 1);
        mode += TIME * (n == 4 ? 1 : -1) * moment[b] * pow(q, n - b) * pow(p, b);
    }
    mode -= TIME * o->F / 2 / k[0] * RHO_C * rate * rate + o->spline / 24.0 * (q * q + p * p);
    mode *= exp(-rate * TIME);
    if (o->matched > 0) mode = matched_mode(&s, o, A, rate);
    double wall = o->degree == 6 ? -across(&s, 0, 1, 4) / kappa[0] / 12 : 0;
    double flux = o->degree == 6 ? -across(&s, 1, 0, 5) / kappa[1] * pow(o->stretch, 6) : 0; /* dy^5 dy over dx^6 */
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++) {
            double x = (i + 0.5) / NX, y = (j + 0.5) * HEIGHT / NY;
            r[j][i] = 0;
            for (int b = 0; b <= o->degree; b += 2) r[j][i] += moment[b] * S(x, y, o->degree - b, b);
            if (o->matched > 0)
                for (int d = 0; d < 2; d++) /* D^2 of the source */
                    r[j][i] -= A / 12 * pow(o->stretch, 4 * d) *
                               (kappa[0] * S(x, y, d ? 2 : 6, d ? 4 : 0) + kappa[1] * S(x, y, d ? 0 : 4, d ? 6 : 2));
            e[j][i] = o->spline / 24.0 * (S(x, y, 2, 0) + S(x, y, 0, 2));
            mean += (S(x, y, 0, 0) + AMPLITUDE * exp(-rate * TIME) * sin(q * x) * cos(p * y)) / (NX * NY);
            for (int hi = 0; hi < 2; hi++) {
                double n = hi ? 1 : -1, top = hi * HEIGHT;
                double G_nnn = -k[0] * S(x, top, 2, 3) - k[1] * S(x, top, 0, 5);
                at.x[hi][j] = wall * (S(hi, y, 4, 0) + k[1] / k[0] * S(hi, y, 0, 4));
                at.y[hi][i] =
                    flux * n * (S(x, top, 0, 5) / 60 + G_nnn / 18 / k[1] + k[0] / k[1] * S(x, top, 4, 1) / 36);
            }
        }
    diffuse(e, kappa, r, &at);
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++)
            sum += fabs(e[j][i] + mode * AMPLITUDE * sin(q * (i + 0.5) / NX) * cos(p * (j + 0.5) * HEIGHT / NY));
    free(s.w);
    return sum / (NX * NY) / mean;
}

static void errors_of_a_smooth_solution(void **state) {
    (void)state;
    const char *const iso = "so_ssph --h 1.2591264671505324";
    const struct row row[] = {
        {"so_ssph", 0.005, 4, 0, 0, 1, 0, 0.533},     {"so_ssph", 1e-10, 4, 0, 0, 1, 0, 0.529},
        {"so_ssph", 0.005, 4, 4, 0, 1, 0, 0.266},     {"brookshaw", 0.02, 4, 0, 0, 1, 0, 0.433},
        {"fo_ssph", 0.005, 4, 0, 0, 1, 0, 1.744},     {"ftcs", 0.005, 4, 0, 0, 1, 0, 0.260},
        {"ftcs", 0.005, 4, 4, 0.1, 1, 0, 0.721},      {"ftcs_flux", 0.005, 4, 0, 0, 1, 0, 1.041},
        {"ftcs_flux", 0.005, 4, 0, 0.1, 1, 0, 0.855}, {"so_ssph --order 4 --h 2.2", 0.005, 6, 0, 0, 1, 0, 28.97},
        {iso, 0.005, 6, 0, 0, 0.5, 0.00625, 0.280},   {iso, 0.02, 6, 0, 0, 1, 0.00625, 0.700},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) assert_near(predicted(&row[k]) / row[k].want, 1, 0.003);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_a_smooth_solution),
    };
    return cmocka_run_group_tests_name("ceilings of a smooth solution", tests, NULL, NULL);
}
