/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicted errors for single scenes: a jump under first derivatives applied twice (rod-step), a source and walls of
 * two kinds (rect-manufactured), walls cooled by air (rod-cooling, plate-cooling).  Also comparisons of two exact
 * solutions, or with the finite differences, which share no code with the particles. */
#include "verification/gates/ceiling.h"

#include "references/scene.h"
#include "references/snapshot.h"
#include "solver/status.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double sq(double x) {
    return x * x;
}

static int place_of(const struct scene *s, const char *name) {
    for (int i = 0; s->params[i].name; i++)
        if (strcmp(s->params[i].name, name) == 0) return i;
    return -1;
}

double ceiling_param(const struct experiment *e, const char *name) {
    int i = place_of(e->scene, name);
    return i < 0 ? NAN : e->problem.param[i];
}

/* ---- Two exact solutions ---- */

/* The mean of |T of *q - T of *p| at their end times, divided by the mean of |T of *p|, at points of *p's box. */
static double apart(const struct scene *scene, const struct problem *p, const struct problem *q) {
    const int n = p->dim == 2 ? 48 : 2000;
    struct snapshot s[2] = {snapshot_take(scene, p, p->t_end), snapshot_take(scene, q, q->t_end)};
    double sum = 0, whole = 0;
    for (int i = 0; i < (p->dim == 2 ? n * n : n); i++) {
        double x[2] = {p->lo[0] + (p->hi[0] - p->lo[0]) * (i % n + 0.5) / n,
                       p->lo[1] + (p->hi[1] - p->lo[1]) * (i / n + 0.5) / n};
        double T = snapshot_at(&s[0], x).temperature;
        sum += fabs(snapshot_at(&s[1], x).temperature - T), whole += fabs(T);
    }
    for (int k = 0; k < 2; k++) snapshot_free(&s[k]);
    return sum / whole;
}

double ceiling_changed(const struct experiment *e, const char *name, double by) {
    struct problem q = {0};
    struct failure ignored;
    int i = place_of(e->scene, name);
    memcpy(q.param, e->problem.param, sizeof q.param);
    if (i < 0) return NAN;
    q.param[i] += by;
    return e->scene->setup(&q, &ignored) ? NAN : apart(e->scene, &e->problem, &q);
}

double ceiling_late(const struct experiment *e, double part) {
    struct problem q = e->problem;
    q.t_end *= 1 - part;
    return apart(e->scene, &e->problem, &q);
}

double ceiling_layer(const struct experiment *e) {
    enum { ANGLES = 360, RINGS = 50 };
    const struct problem *p = &e->problem;
    const double R = p->radius[1], depth = sqrt(4 * problem_diffusivity(p) * p->t_end / M_PI);
    struct snapshot s = snapshot_take(e->scene, p, p->t_end);
    double slope = 0, whole = 0;
    for (int k = 0; k < ANGLES; k++) {
        double n[2] = {cos(2 * M_PI * k / ANGLES), sin(2 * M_PI * k / ANGLES)};
        struct exact T = snapshot_at(&s, (double[2]){R * (1 - 1e-9) * n[0], R * (1 - 1e-9) * n[1]});
        slope += fabs(T.gradient[0] * n[0] + T.gradient[1] * n[1]) / ANGLES;
        for (int i = 0; i < RINGS; i++) {
            double r = R * (i + 0.5) / RINGS;
            whole += fabs(snapshot_at(&s, (double[2]){r * n[0], r * n[1]}).temperature) * r * R / (RINGS * ANGLES);
        }
    }
    snapshot_free(&s);
    return slope * R * depth / whole;
}

/* ---- Two materials ---- */

/* Links of m dx across a contact midway between particles have the conductivity 2 k1 k2/(k1 + k2) instead of k_s of
 * resistances in series.  To first order the excess conductance reduces the resistance by sum c_m (k - k_s) dT^2,
 * with the temperature difference dT for unit flux. */
double ceiling_harmonic(const struct experiment *e) {
    const struct material *m = e->problem.material;
    const double k1 = m[0].k[0], k2 = m[1].k[0], k = 2 * k1 * k2 / (k1 + k2);
    const struct ceiling_symbol s = ceiling_symbol(e);
    double R = 0;
    for (int n = 2; n <= CEILING_REACH; n++)
        for (int left = 0; left < n; left++) {
            double dT = (left + 0.5) / k1 + (n - left - 0.5) / k2;
            R -= s.link[n] * (k - n / dT) * dT * dT;
        }
    return R;
}

/* rod-contact: the jump R dx q of the flux q = dT e1 e2/(e1 + e2)/sqrt(pi t) diffuses into both halves, as
 * exp(-x^2/(4 kappa t))/sqrt(t). */
double ceiling_contact(const struct experiment *e, double R) {
    const struct problem *p = &e->problem;
    double effusivity[2], width[2], heat = 0, jump = fabs(ceiling_param(e, "T1") - ceiling_param(e, "T2"));
    struct snapshot s = snapshot_take(e->scene, p, p->t_end);
    for (int k = 0; k < 2; k++) {
        const struct material *m = &p->material[k];
        effusivity[k] = sqrt(m->k[0] * m->rho_c), width[k] = sqrt(m->k[0] / m->rho_c);
    }
    for (int i = 0; i < 1000; i++) {
        double x[2] = {p->lo[0] + (p->hi[0] - p->lo[0]) * (i + 0.5) / 1000, 0};
        heat += fabs(snapshot_at(&s, x).temperature) * (p->hi[0] - p->lo[0]) / 1000;
    }
    snapshot_free(&s);
    double spread = effusivity[1] * width[0] + effusivity[0] * width[1];
    return fabs(R) * e->options.dx * jump * effusivity[0] * effusivity[1] * spread /
           sq(effusivity[0] + effusivity[1]) / heat;
}

/* Jittered pairs in series conduct 1/<1/F>, the lattice F.  The distance of nearest neighbours is 1 plus the
 * difference of two uniform draws from -j to j. */
double ceiling_stall(const struct experiment *e) {
    enum { DRAWS = 200 };
    const double j = e->options.jitter;
    double resistance = 0;
    for (int a = 0; a < DRAWS; a++)
        for (int b = 0; b < DRAWS; b++) {
            double r = 1 + j * (2 * (a + 0.5) / DRAWS - 1) - j * (2 * (b + 0.5) / DRAWS - 1);
            resistance += 1 / ceiling_pair(e, r) / (DRAWS * DRAWS);
        }
    return ceiling_late(e, 1 - 1 / (resistance * ceiling_pair(e, 1)));
}

/* ---- rod-step and first derivatives applied twice ---- */

static double gauss(double x, double kt) {
    return exp(-x * x / (4 * kt)) / sqrt(4 * M_PI * kt);
}

static double box(double x, double half, double kt) {
    return (erf((x + half) / sqrt(4 * kt)) - erf((x - half) / sqrt(4 * kt))) / 2;
}

/* A stencil that does not see (-1)^i keeps this component of the samples as an envelope V, which spreads with its
 * own diffusivity.  Samples that jump from 1 to 0 contribute half a cell of a source at either edge, samples with a
 * value in between a quarter of a cell.  Even and odd particles have U + V and U - V: E1 is the mean of the larger
 * one. */
double ceiling_blind(const struct experiment *e, double off, double half) {
    enum { POINTS = 5000 };
    const struct ceiling_symbol s = ceiling_symbol(e);
    const double dx = e->options.dx, L = e->problem.hi[0], a = ceiling_param(e, "a"), wide = a + off * dx;
    const double kt = ceiling_param(e, "kappa") * e->problem.t_end;
    const double m = e->options.sampling == SAMPLING_CELL ? 1 : -1;
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
        double x = -L + 2 * L * (i + 0.5) / POINTS, u[2], g[2];
        for (int k = 0; k < 2; k++) {
            double z = x + (k ? -a : a), T_xx = -z / (2 * kt), T_4x = (3 - z * z / (2 * kt)) * z / sq(2 * kt);
            u[k] = dx * dx * (s.fourth[0] * kt * T_4x + m * T_xx / 24) * gauss(z, kt);
            g[k] = half * dx * gauss(z, s.blind * kt);
        }
        double U = box(x, wide, kt) - box(x, a, kt) + u[0] - u[1];
        sum += fmax(fabs(U), fabs(g[0] - g[1])) * 2 * L / POINTS;
    }
    return sum / (2 * a);
}

/* ---- rect-manufactured ---- */

enum { NX = 60, NY = 42 };

/* T = S + Z exp(-lambda t): a source, Dirichlet walls along x and walls of given flux along y.  The error e solves
 * e_t = L e + r, where r has the leading truncation error of S; Z is a mode of the continuous problem and of the
 * mirrored lattice.  Walls are of fourth order and matter only there.  A ghost at the distance d then has the error
 * d^4/12 (T_xxxx + k_y/k_x T_yyyy) on an x side and, with the normal n, d^5/60 T_nnnnn + d^5/18 G_nnn/k_y + d^5/36
 * k_x/k_y T_nxxxx on a y side (solver/space/layout.c). */
struct manufactured {
    double size[2], t, kappa[2], k[2]; /* m, s, m^2/s, W m^-1 K^-1 */
    double q[2], rate;                 /* m^-1 of Z; lambda, s^-1 */
    double e[NY][NX], r[NY][NX];       /* over dx^2 or dx^4 */
    double x[2][NY], y[2][NX];         /* e on the x sides; its outward slope on the y sides */
};

/* d^(a + b) S / dx^a dy^b */
static double S(const struct manufactured *m, double x, double y, int a, int b) {
    double rate_x = 0.8 / m->size[0], rate_y = 1.1 / m->size[1];
    return (a + b == 0) +
           0.5 * pow(rate_x, a) * exp(rate_x * x) * pow(rate_y, b) * cos(rate_y * y + 0.4 + b * M_PI / 2);
}

static void cell(const struct manufactured *m, int i, int j, double *x, double *y) {
    *x = (i + 0.5) * m->size[0] / NX, *y = (j + 0.5) * m->size[1] / NY;
}

/* Advances e(0) to e(t) in place. */
static void diffuse(struct manufactured *m) {
    double next[NY][NX], hx = m->size[0] / NX, hy = m->size[1] / NY;
    double ax = m->kappa[0] / sq(hx), ay = m->kappa[1] / sq(hy);
    int steps = (int)ceil(m->t * (ax + ay) / 0.2);
    for (int s = 0; s < steps; s++) {
        for (int j = 0; j < NY; j++)
            for (int i = 0; i < NX; i++) {
                double c = m->e[j][i], west = i ? m->e[j][i - 1] : 2 * m->x[0][j] - c;
                double east = i < NX - 1 ? m->e[j][i + 1] : 2 * m->x[1][j] - c;
                double south = j ? m->e[j - 1][i] : c + m->y[0][i] * hy;
                double north = j < NY - 1 ? m->e[j + 1][i] : c + m->y[1][i] * hy;
                double rate = ax * (west + east - 2 * c) + ay * (south + north - 2 * c) + m->r[j][i];
                next[j][i] = c + m->t / steps * rate;
            }
        memcpy(m->e, next, sizeof next);
    }
}

static void miss_at_walls(struct manufactured *m, const struct ceiling_symbol *s) {
    for (int hi = 0; hi < 2; hi++) {
        double n = hi ? 1 : -1, x, y, X = hi * m->size[0], Y = hi * m->size[1];
        for (int j = 0; j < NY; j++) {
            cell(m, 0, j, &x, &y);
            m->x[hi][j] = -s->ghost[0] / 12 * (S(m, X, y, 4, 0) + m->k[1] / m->k[0] * S(m, X, y, 0, 4));
        }
        for (int i = 0; i < NX; i++) {
            cell(m, i, 0, &x, &y);
            double G_nnn = -m->k[0] * S(m, x, Y, 2, 3) - m->k[1] * S(m, x, Y, 0, 5);
            m->y[hi][i] = -s->ghost[1] * n *
                          (S(m, x, Y, 0, 5) / 60 + G_nnn / 18 / m->k[1] + m->k[0] / m->k[1] * S(m, x, Y, 4, 1) / 36);
        }
    }
}

/* Residual of the steady part at one point; matched: D^2 of the source is included. */
static double residual(const struct manufactured *m, const struct ceiling_symbol *s, double x, double y, int degree,
                       int matched) {
    const double *moment = degree == 4 ? s->fourth : s->sixth, A = s->fourth[0];
    double r = 0;
    for (int b = 0; 2 * b <= degree; b++) r += m->kappa[0] * moment[b] * S(m, x, y, degree - 2 * b, 2 * b);
    for (int d = 0; d < 2 && matched; d++)
        r -= A / 12 *
             (m->kappa[0] * S(m, x, y, d ? 2 : 6, d ? 4 : 0) + m->kappa[1] * S(m, x, y, d ? 0 : 4, d ? 6 : 2));
    return r;
}

/* The error of the mode at the end time divided by its amplitude. */
static double mode_error(const struct manufactured *m, const struct ceiling_symbol *s, const struct experiment *e,
                         int degree, double m24) {
    const double *moment = degree == 4 ? s->fourth : s->sixth, q2 = sq(m->q[0]) + sq(m->q[1]);
    double sum = 0, rt = m->kappa[0] * m->t / sq(e->options.dx);
    for (int b = 0; 2 * b <= degree; b++)
        sum += (degree == 4 ? 1 : -1) * moment[b] * pow(m->q[0], degree - 2 * b) * pow(m->q[1], 2 * b);
    if (options_is_matched(&e->options)) sum += ceiling_matched_rest(s->fourth[0], rt) * pow(q2, 3);
    if (!e->method->scheme) sum -= e->options.fourier / 2 / sq(m->kappa[0]) * sq(m->rate);
    return m->t * m->kappa[0] * sum - m24 * q2;
}

double ceiling_manufactured(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const struct ceiling_symbol s = ceiling_symbol(e);
    const double m24 = e->options.sampling == SAMPLING_SPLINE ? 4.0 / 24 : 0, A = ceiling_param(e, "A");
    const int matched = options_is_matched(&e->options), degree = matched || e->options.order == 4 ? 6 : 4;
    struct manufactured *m = xcalloc(1, sizeof *m);
    double sum = 0, mean = 0, x, y;
    m->t = p->t_end;
    for (int a = 0; a < 2; a++) {
        m->size[a] = p->hi[a], m->q[a] = (2 - a) * M_PI / p->hi[a], m->k[a] = p->material[0].k[a];
        m->kappa[a] = m->k[a] / p->material[0].rho_c, m->rate += m->kappa[a] * sq(m->q[a]);
    }
    double left = A * exp(-m->rate * m->t), mode = left * mode_error(m, &s, e, degree, m24);
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++) {
            cell(m, i, j, &x, &y);
            m->r[j][i] = residual(m, &s, x, y, degree, matched);
            m->e[j][i] = m24 * (S(m, x, y, 2, 0) + S(m, x, y, 0, 2));
        }
    if (degree == 6) miss_at_walls(m, &s);
    diffuse(m);
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++) {
            cell(m, i, j, &x, &y);
            double Z = sin(m->q[0] * x) * cos(m->q[1] * y);
            sum += fabs(m->e[j][i] + mode * Z), mean += S(m, x, y, 0, 0) + left * Z;
        }
    free(m);
    return sum / mean * pow(e->options.dx, degree - 2);
}

/* ---- Walls cooled by air: k dT/dn = b (T_a - T) ---- */

/* Modes cos(q x) or sin(q x) of one axis: symmetric about 0 or zero there, and cooled at the other end.  On a
 * lattice of n points the ghost midway beyond the wall replaces the slope q by 2 tan(q dx/2)/dx, and sums replace
 * integrals.  On a cloud a ghost has the distance d of its own source and the error -2/3 b/k q^2 d^3: sum_i sum_g
 * w_ig d_g^3 = mu dx^2 times this as a flux, with mu = 3 A for arbitrary positions. */
enum { MODES = 14, CELLS_ROD = 640, CELLS_PLATE = 96 };

struct axis {
    double length, b_k; /* m; b/k, m^-1 */
    int held, n;
    double dx, mu, start[2];         /* m; the initial data are start[0] + start[1] x */
    double q[2][MODES], c[2][MODES]; /* wave numbers and coefficients: solution, lattice */
};

static double slope_at_wall(const struct axis *a, double q, int lattice) {
    if (!lattice) return q;
    return a->mu > 0 ? q * (1 + a->mu * sq(q * a->dx) / 1.5) : 2 * tan(q * a->dx / 2) / a->dx;
}

static double wave_number(const struct axis *a, int m, int lattice) {
    double lo = (m + 0.5 * a->held) * M_PI / a->length, hi = lo + M_PI / 2 / a->length;
    for (int i = 0; i < 200; i++) {
        double q = (lo + hi) / 2, slope = slope_at_wall(a, q, lattice), sign = m % 2 ? -1 : 1, end = q * a->length;
        double left = a->held ? slope * cos(end) + a->b_k * sin(end) : a->b_k * cos(end) - slope * sin(end);
        *(sign * left > 0 ? &lo : &hi) = q;
    }
    return (lo + hi) / 2;
}

static double mode_at(const struct axis *a, double q, double x) {
    return a->held ? sin(q * x) : cos(q * x);
}

/* The amplitude of the solution: the integral of start times mode divided by that of mode squared. */
static double amplitude(const struct axis *a, double q) {
    double L = a->length, end = q * L, size = L / 2 + (a->held ? -1 : 1) * sin(2 * end) / (4 * q);
    double even = a->start[0] * sin(end) / q;
    double odd = a->start[0] * (1 - cos(end)) / q + a->start[1] * (sin(end) / q - L * cos(end)) / q;
    return (a->held ? odd : even) / size;
}

static void modes_of(struct axis *a) {
    for (int m = 0; m < MODES; m++) {
        double sum = 0, size = 0, q = a->q[1][m] = wave_number(a, m, 1);
        a->q[0][m] = wave_number(a, m, 0), a->c[0][m] = amplitude(a, a->q[0][m]);
        for (int i = 0; i < a->n; i++) {
            double x = (i + 0.5) * a->dx, phi = mode_at(a, q, x);
            sum += (a->start[0] + a->start[1] * x) * phi, size += phi * phi;
        }
        a->c[1][m] = sum / size;
    }
}

static double cooled_rod(const struct experiment *e, struct axis *x, double A, double T1, double rise) {
    const double kappa_t = problem_diffusivity(&e->problem) * e->problem.t_end;
    double sum = 0, mean = 0;
    modes_of(x);
    for (int i = 0; i < x->n; i++) {
        double at = (i + 0.5) * x->dx, u[2] = {0, 0};
        for (int m = 0; m < MODES; m++)
            for (int k = 0; k < 2; k++) {
                double q2 = sq(x->q[k][m]), rate = q2 - (k ? A * sq(q2 * x->dx) : 0);
                u[k] += x->c[k][m] * exp(-kappa_t * rate) * mode_at(x, x->q[k][m], at);
            }
        sum += fabs(u[1] - u[0]), mean += T1 + rise * at + u[0];
    }
    return sum / mean / sq(x->dx);
}

/* factor[k][m][j] of mode m at particle j, for the solution and the lattice */
static void profile(const struct axis *a, double kappa_t, double *factor) {
    for (int k = 0; k < 2; k++)
        for (int m = 0; m < MODES; m++)
            for (int j = 0; j < a->n; j++)
                factor[(k * MODES + m) * a->n + j] =
                    a->c[k][m] * exp(-kappa_t * sq(a->q[k][m])) * mode_at(a, a->q[k][m], (j + 0.5) * a->dx);
}

/* The product of two rods plus the contribution of the lattice's mixed moment. */
static double cooled_plate(const struct experiment *e, struct axis a[2], double A, double B, double T_a,
                           double warm) {
    const double kappa_t = problem_diffusivity(&e->problem) * e->problem.t_end, dx2 = sq(a[0].dx);
    double *factor[2], left[MODES][MODES], sum = 0, mean = 0;
    for (int d = 0; d < 2; d++) {
        modes_of(&a[d]);
        factor[d] = xcalloc((size_t)(2 * MODES * a[d].n), sizeof(double));
        profile(&a[d], kappa_t, factor[d]);
    }
    for (int n = 0; n < MODES; n++)
        for (int m = 0; m < MODES; m++) {
            double p = sq(a[0].q[1][m]), q = sq(a[1].q[1][n]);
            left[n][m] = exp(kappa_t * dx2 * fmin(A * (p * p + q * q) + B * p * q, (p + q) / dx2));
        }
    for (int j = 0; j < a[1].n; j++)
        for (int i = 0; i < a[0].n; i++) {
            double u[2] = {0, 0};
            for (int n = 0; n < MODES; n++)
                for (int m = 0; m < MODES; m++)
                    for (int k = 0; k < 2; k++)
                        u[k] += factor[0][(k * MODES + m) * a[0].n + i] * factor[1][(k * MODES + n) * a[1].n + j] *
                                (k ? left[n][m] : 1);
            sum += fabs(u[1] - u[0]) * warm, mean += T_a + warm * u[0];
        }
    for (int d = 0; d < 2; d++) free(factor[d]);
    return sum / mean / dx2;
}

double ceiling_cooled(const struct experiment *e, double more, int cloud) {
    const struct problem *p = &e->problem;
    const struct ceiling_symbol s = ceiling_symbol(e);
    const double A = more * s.fourth[0], mu = cloud ? 3 * A : 0, b_k = ceiling_param(e, "b") / ceiling_param(e, "k");
    const double T1 = ceiling_param(e, "T1"), T0 = ceiling_param(e, "T0"), T_a = ceiling_param(e, "T_a");
    const double dx2 = sq(e->options.dx);
    struct axis a[2];
    for (int d = 0; d < p->dim; d++) {
        a[d] =
            (struct axis){.length = p->hi[d], .b_k = b_k, .held = p->dim == 1 || d == 1, .start = {1, 0}, .mu = mu};
        a[d].dx = p->hi[0] / (p->dim == 1 ? CELLS_ROD : CELLS_PLATE), a[d].n = (int)round(p->hi[d] / a[d].dx);
    }
    if (p->dim == 2) return dx2 * cooled_plate(e, a, A, more * s.fourth[1], T_a, T0 - T_a);
    double rise = (T_a - T1) * b_k / (1 + b_k * p->hi[0]);
    a[0].start[0] = T0 - T1, a[0].start[1] = -rise;
    return dx2 * cooled_rod(e, &a[0], A, T1, rise);
}
