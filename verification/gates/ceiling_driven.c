/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicted errors where walls change in time (rod-driven, plate-driven).
 *
 * The error e of a lattice solves e_t = L e + r, e = 0 at the start, on a grid of its own.  r is the truncation error
 * of the exact solution, dx^2 kappa_x sum_b fourth[b] d^4 T/dx^(4-2b) dy^2b, less dt/2 T_tt of Euler steps; at order
 * 4 of a rod dx^4 kappa sixth[0] T_xxxxxx.  It is sampled at TIMES times and linear in between.  With dT/dt of their
 * walls the ghosts leave e = 0 on a Dirichlet side and e_n = 0 on a side of given flux; at order 4 ghosts at the
 * distance d are off by d^4/12 T_xxxx.  On a Robin side the ghost next to it is midway beyond the wall:
 *
 *     k e_n + b e = -dx^2 (k/24 T_nnn + b/8 T_nn + w_2 (k T_nnn + b T_nn))
 *
 * The second ghost continues the first as if the air were steady and uniform, u_2 = f (u_1 + u_-1) - u_0, and lacks
 * dx^3 (T_nnn + b/k T_nn): hence the term with w_2, the weight of the neighbour two rows away. *
 * Errors in time.  A step of order 2 adds -q dt^3 times the third derivative of the flow, with q = 1/6 of the
 * midpoint rule and (1 + 8/(s^2 + s - 2))/18 of rkl2 with s stages, and linear data add dt^3/12 g_tt.  With
 * T_tt = A T_t + g_t the sum is
 *
 *     e_t = A e - dt^2 (q + 1/12) (A T_tt - T_ttt) - q dt^2 T_ttt
 *
 * so that e = dt^2 (q + 1/12) T_tt + u with u_t = A u - q dt^2 T_ttt, u = 0 on the sides, and e = 0 at the start.
 * Euler steps have e_t = A e - dt/2 T_tt.
 *
 * Polynomials in time (chebyshev) have the error of their data alone, interpolated at c = 0, 1/4, .. 1 of a step: the
 * wall is off by dt^5 g^(5) c (c - 1/4) .. (c - 1)/120.  This has the mean 0, so a mode that a step hardly damps is
 * off by O(dt^6); the wall's layer of width sqrt(kappa dt) is off by O(dt^5): E1 is of order 5 1/2.  The modes of the
 * rod are summed. */
#include "verification/gates/ceiling.h"

#include "references/snapshot.h"
#include "solver/time/stepper.h"
#include "verification/solve/experiment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_X = 160, MOST_Y = 24, TIMES = 33 };

struct driven_error {
    const struct experiment *e;
    struct ceiling_symbol symbol;
    int plain;                       /* 1: walls alone, without dT/dt in their ghosts */
    int n[2], degree;                /* cells; 4 or 6 */
    double h[2], kappa[2], euler;    /* m, m^2/s; dt/2, s */
    double r[TIMES][MOST_Y][MOST_X]; /* K s^-1 */
    double wall[TIMES][4][MOST_X];   /* by side: e of a Dirichlet side, else the outward flux k e_n at e = 0 */
    double e_now[MOST_Y][MOST_X];
};

static double sq(double x) {
    return x * x;
}

/* d^degree T along an axis at x; of degree 2, 3, 4 or 6. */
static double along(const struct snapshot *s, const double at[2], int axis, int degree) {
    static const double weight[7][4] = {[2] = {-2, 1}, [3] = {0, -1, 0.5}, [4] = {6, -4, 1}, [6] = {-20, 15, -6, 1}};
    double d = 0.02 * (s->problem->hi[axis] - s->problem->lo[axis]), sum = 0;
    for (int i = -3; i <= 3; i++) {
        double x[2] = {at[0], at[1]}, w = weight[degree][abs(i)];
        x[axis] += i * d;
        if (w != 0) sum += (degree % 2 && i < 0 ? -w : w) * snapshot_at(s, x).temperature;
    }
    return sum / pow(d, degree);
}

static double mixed(const struct snapshot *s, const double at[2]) {
    double d[2], sum = 0;
    for (int a = 0; a < 2; a++) d[a] = 0.02 * (s->problem->hi[a] - s->problem->lo[a]);
    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            double x[2] = {at[0] + i * d[0], at[1] + j * d[1]};
            sum += (i ? 1 : -2) * (j ? 1 : -2) * snapshot_at(s, x).temperature;
        }
    return sum / sq(d[0] * d[1]);
}

/* d^degree T/dt^degree at x, of degree 2 or 3. */
static double in_time(const struct driven_error *m, const double x[2], double t, int degree) {
    double d = 0.01 * m->e->problem.t_end, sum = 0;
    for (int i = -2; i <= 2; i++) {
        double w = degree == 2 ? (i == 0 ? -2 : abs(i) == 1)
                               : (i == 0        ? 0
                                  : abs(i) == 1 ? -1
                                                : 0.5) *
                                     (i < 0 ? -1 : 1);
        if (w != 0) sum += w * scene_exact(m->e->scene, &m->e->problem, x, t + i * d).temperature;
    }
    return sum / pow(d, degree);
}

static void centre(const struct driven_error *m, int i, int j, double x[2]) {
    x[0] = (i + 0.5) * m->h[0], x[1] = m->e->problem.dim == 2 ? (j + 0.5) * m->h[1] : 0;
}

static double residual(const struct driven_error *m, const struct snapshot *s, const double x[2]) {
    const double *kappa = m->kappa, *c = m->symbol.fourth, dx = m->e->options.dx;
    if (m->degree == 6) return pow(dx, 4) * kappa[0] * m->symbol.sixth[0] * along(s, x, 0, 6);
    double T_4x = along(s, x, 0, 4), T_4y = 0, T_xxyy = 0;
    if (m->e->problem.dim == 2) T_4y = along(s, x, 1, 4), T_xxyy = mixed(s, x);
    double T_tt = sq(kappa[0]) * T_4x + 2 * kappa[0] * kappa[1] * T_xxyy + sq(kappa[1]) * T_4y;
    return sq(dx) * kappa[0] * (c[0] * T_4x + c[1] * T_xxyy + c[2] * T_4y) - m->euler * T_tt;
}

/* The data of a side at the foot x. */
static double missed(const struct driven_error *m, const struct snapshot *s, int side, const double x[2]) {
    const struct problem *p = &m->e->problem;
    const double dx = m->e->options.dx, k = p->material[0].k[side / 2], b = p->robin[side], n = side % 2 ? 1 : -1;
    if (p->side[side] == DIRICHLET && m->plain) return -sq(dx) / 8 * along(s, x, side / 2, 2);
    if (p->side[side] == DIRICHLET)
        return m->degree == 6 ? -pow(dx, 4) * m->symbol.ghost[0] / 12 * along(s, x, side / 2, 4) : 0;
    if (p->side[side] == NEUMANN) return 0;
    double T_nnn = n * along(s, x, side / 2, 3), T_nn = along(s, x, side / 2, 2);
    return -sq(dx) * (k / 24 * T_nnn + b / 8 * T_nn + m->symbol.link[2] * (k * T_nnn + b * T_nn));
}

static void sample(struct driven_error *m, int t) {
    const struct problem *p = &m->e->problem;
    struct snapshot s = snapshot_take(m->e->scene, p, p->t_end * t / (TIMES - 1));
    double x[2];
    for (int j = 0; j < m->n[1]; j++)
        for (int i = 0; i < m->n[0]; i++) {
            centre(m, i, j, x);
            m->r[t][j][i] = residual(m, &s, x);
        }
    for (int side = 0; side < 2 * p->dim; side++)
        for (int i = 0; i < m->n[1 - side / 2]; i++) {
            centre(m, side / 2 ? i : 0, side / 2 ? 0 : i, x);
            x[side / 2] = side % 2 ? p->hi[side / 2] : p->lo[side / 2];
            m->wall[t][side][i] = missed(m, &s, side, x);
        }
    snapshot_free(&s);
}

/* The value beyond a side next to the cell value c, with the side's data w. */
static double beyond(const struct driven_error *m, int side, double c, double w) {
    const struct problem *p = &m->e->problem;
    double h = m->h[side / 2], k = p->material[0].k[side / 2], b = p->robin[side];
    if (p->side[side] == DIRICHLET) return 2 * w - c;
    if (p->side[side] == NEUMANN) return c + h * w / k;
    return ((k / h - b / 2) * c + w) / (k / h + b / 2);
}

static void diffuse(struct driven_error *m) {
    double next[MOST_Y][MOST_X], rate = 0, t_end = m->e->problem.t_end;
    int dim = m->e->problem.dim;
    for (int a = 0; a < dim; a++) rate += m->kappa[a] / sq(m->h[a]);
    int steps = (int)ceil(t_end * rate / 0.2);
    for (int step = 0; step < steps; step++) {
        double part = (step + 0.5) / steps * (TIMES - 1), w = part - floor(part);
        int t = (int)part;
        for (int j = 0; j < m->n[1]; j++)
            for (int i = 0; i < m->n[0]; i++) {
                const int at[2] = {i, j};
                double c = m->e_now[j][i], sum = (1 - w) * m->r[t][j][i] + w * m->r[t + 1][j][i];
                for (int side = 0; side < 2 * dim; side++) {
                    int a = side / 2, to = at[a] + (side % 2 ? 1 : -1), across = at[1 - a];
                    double data = (1 - w) * m->wall[t][side][across] + w * m->wall[t + 1][side][across];
                    double other = to < 0 || to >= m->n[a] ? beyond(m, side, c, data)
                                   : a                     ? m->e_now[to][i]
                                                           : m->e_now[j][to];
                    sum += m->kappa[a] / sq(m->h[a]) * (other - c);
                }
                next[j][i] = c + t_end / steps * sum;
            }
        memcpy(m->e_now, next, sizeof next);
    }
}

static struct driven_error *create(const struct experiment *e) {
    const struct problem *p = &e->problem;
    struct driven_error *m = xcalloc(1, sizeof *m);
    *m = (struct driven_error){.e = e, .n = {p->dim == 1 ? MOST_X : MOST_Y, 1}};
    m->degree = e->options.order == 4 ? 6 : 4;
    if (p->dim == 2) m->n[1] = (int)fmin(MOST_Y, round(MOST_Y * p->hi[1] / p->hi[0]));
    for (int a = 0; a < p->dim; a++)
        m->h[a] = p->hi[a] / m->n[a], m->kappa[a] = p->material[0].k[a] / p->material[0].rho_c;
    return m;
}

/* E1 of m->e_now plus `more` times d2T/dt2. */
static double finish(struct driven_error *m, double more) {
    double sum = 0, mean = 0, x[2];
    for (int j = 0; j < m->n[1]; j++)
        for (int i = 0; i < m->n[0]; i++) {
            double bent = 0;
            centre(m, i, j, x);
            if (more != 0) bent = more * in_time(m, x, m->e->problem.t_end, 2);
            sum += fabs(m->e_now[j][i] + bent);
            mean += fabs(scene_exact(m->e->scene, &m->e->problem, x, m->e->problem.t_end).temperature);
        }
    free(m);
    return sum / mean;
}

double ceiling_driven(const struct experiment *e) {
    struct driven_error *m = create(e);
    m->symbol = ceiling_symbol(e);
    if (!e->method->scheme) m->euler = e->options.fourier / 2 * sq(e->options.dx) / problem_diffusivity(&e->problem);
    for (int t = 0; t < TIMES; t++) sample(m, t);
    diffuse(m);
    return finish(m, 0);
}

double ceiling_plain_wall(const struct experiment *e) {
    struct driven_error *m = create(e);
    m->plain = 1;
    for (int t = 0; t < TIMES; t++) sample(m, t);
    memset(m->r, 0, sizeof m->r);
    diffuse(m);
    return finish(m, 0);
}

/* The steps' contributions, of an order and with the third-order term of the flow; Dirichlet sides are taken `lead`
 * seconds early. */
static double time_error(const struct experiment *e, double dt, int order, double third, double lead) {
    struct driven_error *m = create(e);
    const struct problem *p = &e->problem;
    double x[2], more = order == 1 ? 0 : dt * dt * (third + 1.0 / 12);
    for (int t = 0; t < TIMES; t++) {
        double at = p->t_end * t / (TIMES - 1);
        for (int j = 0; j < m->n[1]; j++)
            for (int i = 0; i < m->n[0]; i++) {
                centre(m, i, j, x);
                m->r[t][j][i] = order == 1 ? -dt / 2 * in_time(m, x, at, 2) : -third * dt * dt * in_time(m, x, at, 3);
                if (t == 0 && order > 1) m->e_now[j][i] = -more * in_time(m, x, at, 2);
            }
        for (int s = 0; s < 2 && lead != 0; s++)
            m->wall[t][s][0] = lead * p->wall_rate(p, (enum side)s, (double[2]){s ? p->hi[0] : p->lo[0], 0}, at);
    }
    diffuse(m);
    return finish(m, more);
}

double ceiling_driven_time(const struct experiment *e) {
    int order = stepper_of(e->options.stepper)->order;
    return time_error(e, e->options.dt, order, order == 1 ? 0 : ceiling_third(e), 0);
}

double ceiling_driven_step(const struct experiment *e, double dt) {
    return time_error(e, dt, 1, 0, dt);
}

enum { QUARTERS = 4, PANELS = 400, MODES = 24 };

/* The interpolated drive of a step from t less the drive, at the fraction c of the step. */
static double interpolation_error(const struct experiment *e, double t, double c) {
    const double omega = ceiling_param(e, "omega"), phase = ceiling_param(e, "phase"), dt = e->options.dt;
    double sum = -cos(omega * (t + c * dt) + phase);
    for (int i = 0; i <= QUARTERS; i++) {
        double l = cos(omega * (t + i * dt / QUARTERS) + phase);
        for (int j = 0; j <= QUARTERS; j++) l *= i == j ? 1 : (QUARTERS * c - j) / (i - j);
        sum += l;
    }
    return sum;
}

double ceiling_driven_polynomials(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const double L = p->hi[0], kappa = problem_diffusivity(p), dt = e->options.dt;
    double mode[MODES + 1] = {0}, sum = 0, whole = 0;
    int steps = (int)round(p->t_end / dt);
    for (int step = 0; step < steps; step++) {
        double off[PANELS + 1];
        for (int i = 0; i <= PANELS; i++) off[i] = interpolation_error(e, step * dt, (double)i / PANELS);
        for (int k = 1; k <= MODES; k++) {
            double q = k * M_PI / L, z = -kappa * q * q * dt, simpson = 0;
            for (int i = 0; i <= PANELS; i++)
                simpson += (i % PANELS ? 2 + 2 * (i % 2) : 1) * off[i] * exp(z * (1 - (double)i / PANELS));
            mode[k] = exp(z) * mode[k] + 2 * kappa * q / L * ceiling_param(e, "A") * dt * simpson / (3 * PANELS);
        }
    }
    for (int i = 0; i < MOST_X; i++) {
        double x = (i + 0.5) * L / MOST_X, off = 0;
        for (int k = 1; k <= MODES; k++) off += mode[k] * sin(k * M_PI * x / L);
        sum += fabs(off), whole += fabs(scene_exact(e->scene, p, &x, p->t_end).temperature);
    }
    return sum / whole;
}
