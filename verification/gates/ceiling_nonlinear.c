/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicted errors where k depends on T.
 *
 * Smooth data on a rod.  With theta the integral of k and pairs of weight w at the distance r, the means of a pair
 * leave the truncation error d/dx of
 *
 *     Phi = A dx^2 (theta_xxx + m T_x^3),   A = sum w x^4/(24 dx^2)
 *     m = 0 (kirchhoff, so_ssph),  k'' (arithmetic),  k'' - 3 k'^2/k (harmonic)
 *
 * since (k_i + k_j)/2 (T_j - T_i) exceeds theta_j - theta_i by k'' T_x^3 r^3/12, the harmonic mean by k'^2/(4 k)
 * T_x^3 r^3 less, and sum w r^4/2 = 12 A dx^2.  For fo_ssph Phi = A dx^2/2 (theta_xxx + k T_xxx).  The error e obeys
 *
 *     rho_c e_t = (k e)_xx + Phi_x,   e = 0 at the start
 *
 * on a grid of its own.  Ghosts with theta_nn of the equation leave k e = 0 on a held wall, a face half a spacing
 * from a point leaves k e = -dx^2/8 theta_nn.
 *
 * For the wave k = k_0 T^n these are, in units of k_0 (rho_c c n/k_0)^(1 + 1/n) xi^(1/n - 2)/n^3: n - 1 (kirchhoff),
 * -(n - 1)^2 (arithmetic), 2 n^2 + 2 n - 1 (harmonic).  For n = 1 kirchhoff's mean is exact behind the front, for n =
 * 2 the arithmetic mean has the opposite error, and the harmonic mean 11 times as large a one.
 *
 * Errors in time.  A step leaves -p dt^3 f''(f, f) - q dt^3 f' f' f, with T_t = f and the data of the walls as
 * further unknowns: p = 1/24, q = 1/6 of the midpoint rule; p and q near 1/18 of rkl2 with many stages (p = 1/6 - sum
 * b c^2/2 = 1/6 - 1/9, in the limit where the stages are Bessel functions).  Since T_ttt = f''(f, f) + f' f' f and f'
 * f = T_tt,
 *
 *     e_t = f' e - dt^2 (p T_ttt + (q - p) f' T_tt),   e = 0 at the start
 *
 * so that e = dt^2 (q - p) T_tt + u with u_t = f' u - q dt^2 T_ttt, u = 0 on held walls.  Euler steps have e_t = f' e
 * - dt/2 T_tt.
 *
 * A front inside.  Phi grows as xi^(1/n - 2): a layer of a few dx at the front is off by the temperature there,
 * dx^(1/n), and what it holds is lost to the rest: E1 is of order 1 + 1/n, the largest error of order 1/n. */
#include "verification/gates/ceiling.h"

#include "references/kirchhoff.h"
#include "references/scene.h"
#include "solver/options.h"
#include "solver/method.h"

#include <math.h>
#include <string.h>

enum { CELLS = 40 };

struct smooth {
    const struct experiment *e;
    double A;             /* fourth moment times dx^2, m^2; 0: no error in space */
    int twice, face;      /* fo_ssph; walls are faces */
    double second, third; /* s, s^2: factors of T_tt and T_ttt in e_t */
};

static double temperature(const struct smooth *s, double x, double t) {
    return scene_exact(s->e->scene, &s->e->problem, &x, t).temperature;
}

/* f(T) to the third difference of step d */
static double third(const struct smooth *s, double x, double t, int of_theta) {
    const struct problem *p = &s->e->problem;
    const double d = (p->hi[0] - p->lo[0]) / 200;
    double f[4];
    for (int k = 0; k < 4; k++) {
        f[k] = temperature(s, x + (k < 2 ? k - 2 : k - 1) * d, t);
        if (of_theta) f[k] = kirchhoff_theta(p, f[k]);
    }
    return (f[3] - 2 * f[2] + 2 * f[1] - f[0]) / (2 * d * d * d);
}

/* d^degree T/dt^degree, of degree 2 or 3 */
static double in_time(const struct smooth *s, double x, double t, int degree) {
    const double d = 0.01 * s->e->problem.t_end;
    double near = temperature(s, x, t + d), before = temperature(s, x, t - d);
    if (degree == 2) return (near - 2 * temperature(s, x, t) + before) / (d * d);
    return (temperature(s, x, t + 2 * d) - 2 * near + 2 * before - temperature(s, x, t - 2 * d)) / (2 * d * d * d);
}

static double step_error(const struct smooth *s, double x, double t) {
    return (s->second != 0 ? s->second * in_time(s, x, t, 2) : 0) +
           (s->third != 0 ? s->third * in_time(s, x, t, 3) : 0);
}

static double truncation(const struct smooth *s, double x, double t) {
    const struct problem *p = &s->e->problem;
    if (s->A == 0) return 0;
    struct exact e = scene_exact(s->e->scene, p, &x, t);
    double T = e.temperature, k = kirchhoff_k(p, T), slope = kirchhoff_slope(p, T), m = 0,
           cube = pow(e.gradient[0], 3);
    double theta = third(s, x, t, 1);
    if (s->twice) return s->A / 2 * (theta + k * third(s, x, t, 0));
    const enum mean mean = s->e->options.mean;
    const int pairs = strcmp(s->e->method->name, "so_ssph") != 0;
    if (pairs && (mean == MEAN_ARITHMETIC || mean == MEAN_HARMONIC))
        m = p->k_law == K_POWER ? k * p->k_n * (p->k_n - 1) / pow(T - p->k_ref, 2) : 0;
    if (pairs && mean == MEAN_HARMONIC) m -= 3 * slope * slope / k;
    return s->A * (theta + m * cube);
}

/* k e on a held wall, W m^-1 */
static double at_wall(const struct smooth *s, int side, double t) {
    const struct problem *p = &s->e->problem;
    double x[DIM_MAX] = {side ? p->hi[0] : p->lo[0]}, dx = s->e->options.dx;
    double rate = p->wall_rate ? p->wall_rate(p, (enum side)side, x, t) : 0;
    return s->face && s->A > 0 ? -dx * dx / 8 * (p->material[0].rho_c * rate - problem_source(p, x, t)) : 0;
}

/* Solves for e, K, from its value at the start. */
static void diffuse(const struct smooth *s, double e[CELLS]) {
    const struct problem *p = &s->e->problem;
    const double h = (p->hi[0] - p->lo[0]) / CELLS, rho_c = p->material[0].rho_c;
    int steps = (int)ceil(p->t_end * problem_diffusivity(p) / (0.25 * h * h));
    for (int step = 0; step < steps; step++) {
        double t = p->t_end * step / steps, ke[CELLS], flux[CELLS + 1], x = p->lo[0] + h / 2;
        for (int i = 0; i < CELLS; i++) ke[i] = kirchhoff_k(p, temperature(s, x + i * h, t)) * e[i];
        for (int i = 0; i <= CELLS; i++) {
            double left = i ? ke[i - 1] : 2 * at_wall(s, X_LO, t) - ke[0];
            double right = i < CELLS ? ke[i] : 2 * at_wall(s, X_HI, t) - ke[CELLS - 1];
            flux[i] = (right - left) / h + truncation(s, p->lo[0] + i * h, t);
        }
        for (int i = 0; i < CELLS; i++)
            e[i] += p->t_end / steps * ((flux[i + 1] - flux[i]) / h / rho_c + step_error(s, x + i * h, t));
    }
}

/* E1 of e + by T_tt at the end. */
static double finish(const struct smooth *s, const double e[CELLS], double by) {
    const struct problem *p = &s->e->problem;
    double sum = 0, whole = 0;
    for (int i = 0; i < CELLS; i++) {
        double x = p->lo[0] + (i + 0.5) * (p->hi[0] - p->lo[0]) / CELLS;
        sum += fabs(e[i] + (by != 0 ? by * in_time(s, x, p->t_end, 2) : 0));
        whole += fabs(temperature(s, x, p->t_end));
    }
    return sum / whole;
}

double ceiling_kirchhoff(const struct experiment *of) {
    struct smooth s = {.e = of, .A = ceiling_symbol(of).fourth[0] * of->options.dx * of->options.dx};
    double e[CELLS] = {0};
    s.twice = strcmp(of->method->name, "fo_ssph") == 0, s.face = !of->method->scheme;
    diffuse(&s, e);
    return finish(&s, e, 0);
}

double ceiling_kirchhoff_time(const struct experiment *of) {
    const struct problem *p = &of->problem;
    const enum stepper_name stepper = of->options.stepper;
    const double dt = of->options.dt, q = stepper == STEPPER_RK2 ? 1. / 6 : ceiling_third(of);
    struct smooth s = {.e = of};
    double e[CELLS] = {0}, by = stepper == STEPPER_RK2 ? dt * dt / 8 : 0;
    if (stepper == STEPPER_EULER)
        s.second = -dt / 2;
    else
        s.third = -q * dt * dt;
    for (int i = 0; i < CELLS && by > 0; i++)
        e[i] = -by * in_time(&s, p->lo[0] + (i + 0.5) * (p->hi[0] - p->lo[0]) / CELLS, 0, 2);
    diffuse(&s, e);
    return finish(&s, e, by);
}

/* Heat within `width` (m) behind the front, or ahead of its initial place, as a part of the whole: T is xi^(1/n). */
static double tip(const struct experiment *e, double width) {
    double reach = ceiling_param(e, "c") * e->problem.t_end + ceiling_param(e, "x0");
    return pow(width / reach, 1 + 1 / ceiling_param(e, "n"));
}

double ceiling_tip(const struct experiment *e) {
    return tip(e, e->options.dx);
}

double ceiling_ahead(const struct experiment *e) {
    return tip(e, ceiling_param(e, "c") * e->problem.t_end);
}
