/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ceilings of rows with an error of another kind than the five-point difference's: first order at a jump, at a wall
 * or at a contact, a front, and codes that may be a part of a cell off. */
#include "verification/gates/ceiling.h"

#include "references/scene.h"
#include "references/snapshot.h"
#include "solver/status.h"
#include "verification/gates/ceiling_weights.h"

#include <math.h>
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

/* ---- One wave ---- */

/* The symbol is -q.K q + kappa_x dx^2 sum w (q.x)^4/24, x in dx, and the mean of |cos| is 2/pi. */
double ceiling_tensor(const struct experiment *e) {
    static const char *const modes[] = {"mode_x", "mode_y", "mode_z"};
    const struct problem *p = &e->problem;
    const double kappa = p->material[0].k[0] / p->material[0].rho_c;
    struct ceiling_weights w = ceiling_weights(e);
    double q[DIM_MAX] = {0}, rate = 0;
    for (int a = 0; a < p->dim; a++) q[a] = 2 * M_PI * ceiling_param(e, modes[a]) / (p->hi[a] - p->lo[a]);
    for (int a = 0; a < p->dim; a++)
        for (int b = 0; b < p->dim; b++)
            rate +=
                q[a] * q[b] * (a == b ? p->material[0].k[a] : p->cross[problem_pair(a, b)]) / p->material[0].rho_c;
    double off = kappa * sq(e->options.dx) * ceiling_weights_along(&w, q, 4) / 24;
    return 2 / M_PI * fabs(off) * p->t_end * exp(-rate * p->t_end) * ceiling_param(e, "A") / ceiling_param(e, "Tm");
}

/* The mean of sqrt(|sin 2 theta|) is 0.763; each edge has the angle 2 half at first, and its heat after that. */
double ceiling_patch(const struct experiment *e) {
    const double kappa = ceiling_param(e, "k_par") / ceiling_param(e, "rho_c"), half = ceiling_param(e, "half");
    const double width = 0.763 * pow(kappa * e->problem.t_end * sq(e->options.dx) / 16, 0.25),
                 L = ceiling_param(e, "L");
    const double edges = 2 * half * (ceiling_param(e, "r1") + ceiling_param(e, "r2"));
    return 1.211 * ceiling_param(e, "A") * edges * width / (4 * L * L * ceiling_param(e, "Tm"));
}

double ceiling_patch_jump(const struct experiment *e) {
    const double kappa = ceiling_param(e, "k_par") / ceiling_param(e, "rho_c");
    return ceiling_param(e, "A") *
           erf(ceiling_param(e, "half") * ceiling_param(e, "r2") / (2 * sqrt(kappa * e->problem.t_end)));
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

/* The scene with kappa larger by `part` of itself and a later phase. */
static struct problem driven_as(const struct experiment *e, double part, double phase) {
    struct problem q = {0};
    struct failure ignored;
    memcpy(q.param, e->problem.param, sizeof q.param);
    q.param[place_of(e->scene, "kappa")] *= 1 + part, q.param[place_of(e->scene, "phase")] += phase;
    if (e->scene->setup(&q, &ignored)) q.t_end = NAN;
    return q;
}

/* Euler steps of the periodic state multiply it by exp(i omega dt): p^2 is (exp(i omega dt) - 1)/(kappa dt), to first
 * order i omega/kappa (1 + i omega dt/2), as of a conductivity larger by i omega dt/2.  A factor i is a quarter of a
 * period.  A wall one step early is omega dt ahead in phase. */
double ceiling_driven_step(const struct experiment *e, double dt, int early) {
    enum { POINTS = 400 };
    const struct problem *p = &e->problem;
    const double turn = ceiling_param(e, "omega") * dt;
    const struct problem of[] = {driven_as(e, turn / 2, -M_PI / 2), driven_as(e, 0, -M_PI / 2),
                                 driven_as(e, 0, early ? turn : 0), *p};
    double sum = 0, whole = 0;
    for (int i = 0; i < POINTS; i++) {
        double x[DIM_MAX] = {p->lo[0] + (p->hi[0] - p->lo[0]) * (i + 0.5) / POINTS}, T[4];
        for (int k = 0; k < 4; k++) T[k] = scene_exact(e->scene, &of[k], x, p->t_end).temperature;
        sum += fabs(T[0] - T[1] + T[2] - T[3]), whole += fabs(T[3]);
    }
    return sum / whole;
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
    const struct ceiling_weights s = ceiling_weights(e);
    double R = 0;
    for (int n = 2; n <= s.reach; n++)
        for (int left = 0; left < n; left++) {
            double dT = (left + 0.5) / k1 + (n - left - 0.5) / k2;
            R -= s.w[CEILING_REACH][CEILING_REACH][CEILING_REACH + n] * (k - n / dT) * dT * dT;
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
    const struct ceiling_weights s = ceiling_weights(e);
    double resistance = 0;
    for (int a = 0; a < DRAWS; a++)
        for (int b = 0; b < DRAWS; b++) {
            double r = 1 + j * (2 * (a + 0.5) / DRAWS - 1) - j * (2 * (b + 0.5) / DRAWS - 1);
            resistance += 1 / ceiling_weights_radial(&s, r) / (DRAWS * DRAWS);
        }
    return ceiling_late(e, 1 - 1 / (resistance * ceiling_weights_radial(&s, 1)));
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
    const struct ceiling_weights s = ceiling_weights(e);
    const double dx = e->options.dx, L = e->problem.hi[0], a = ceiling_param(e, "a"), wide = a + off * dx;
    const double kt = ceiling_param(e, "kappa") * e->problem.t_end;
    const double A = ceiling_weights_moment(&s, 4, 0, 0) / 24, m = e->options.sampling == SAMPLING_CELL ? 1 : -1;
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
        double x = -L + 2 * L * (i + 0.5) / POINTS, u[2], g[2];
        for (int k = 0; k < 2; k++) {
            double z = x + (k ? -a : a), T_xx = -z / (2 * kt), T_4x = (3 - z * z / (2 * kt)) * z / sq(2 * kt);
            u[k] = dx * dx * (A * kt * T_4x + m * T_xx / 24) * gauss(z, kt);
            g[k] = half * dx * gauss(z, s.blind * kt);
        }
        double U = box(x, wide, kt) - box(x, a, kt) + u[0] - u[1];
        sum += fmax(fabs(U), fabs(g[0] - g[1])) * 2 * L / POINTS;
    }
    return sum / (2 * a);
}

/* ---- aligned ---- */

double ceiling_aligned(const struct experiment *e, double par, double all) {
    const struct problem *p = &e->problem;
    const double *x = e->quantity.at, middle[DIM_MAX] = {0}, dx2 = sq(e->options.dx), Tm = p->held[X_LO];
    double decay = log(ceiling_param(e, "A") / (scene_exact(e->scene, p, middle, p->t_end).temperature - Tm));
    double along = 2 * sq(M_PI / (p->hi[0] - p->lo[0])) * p->k_par / p->material[0].rho_c * p->t_end;
    double T = scene_exact(e->scene, p, x, p->t_end).temperature;
    return (par * along + all * decay) * dx2 * (T - Tm) / T;
}

/* ---- Codes of any kind ---- */

/* Means over cell centres of |T|, |T_x| + |T_y| + |T_z| and |lap T|, by differences of step dx/8. */
struct means {
    double T, gradient, laplacian;
};

static struct means means_of(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const double dx = e->options.dx, d = dx / 8;
    int n[DIM_MAX] = {1, 1, 1}, cells = 1;
    for (int a = 0; a < p->dim; a++) cells *= n[a] = (int)round((p->hi[a] - p->lo[a]) / dx);
    struct snapshot s = snapshot_take(e->scene, p, p->t_end);
    struct means mean = {0};
    for (int k = 0; k < cells; k++) {
        const int at[DIM_MAX] = {k % n[0], k / n[0] % n[1], k / n[0] / n[1]};
        double x[DIM_MAX] = {0}, laplacian = 0;
        for (int a = 0; a < p->dim; a++) x[a] = p->lo[a] + (at[a] + 0.5) * dx;
        double T = snapshot_at(&s, x).temperature;
        for (int a = 0; a < p->dim; a++) {
            double middle = x[a], beside[2];
            for (int side = 0; side < 2; side++)
                x[a] = middle + (side ? d : -d), beside[side] = snapshot_at(&s, x).temperature;
            x[a] = middle;
            laplacian += (beside[0] - 2 * T + beside[1]) / (d * d);
            mean.gradient += fabs(beside[1] - beside[0]) / (2 * d);
        }
        mean.T += fabs(T), mean.laplacian += fabs(laplacian);
    }
    mean.T /= cells, mean.gradient /= cells, mean.laplacian /= cells;
    snapshot_free(&s);
    return mean;
}

double ceiling_cell_mean(const struct experiment *e) {
    struct means mean = means_of(e);
    return sq(e->options.dx) / 24 * mean.laplacian / mean.T;
}

double ceiling_cell_away(const struct experiment *e) {
    struct means mean = means_of(e);
    return e->options.dx * mean.gradient / mean.T;
}

double ceiling_bend(const struct experiment *e) {
    enum { CELLS = 6 };
    /* Weights in the gradient at 0 of six points at 0.6 + k, by Lagrange; their sum is 68. */
    static const double weight[CELLS] = {5.41, 16.43, 22.00, 16.46, 6.57, 1.09}, first = 0.6;
    const struct problem *p = &e->problem;
    const double dx = e->options.dx, d = dx / 8;
    double sum = 0, all = 0, wall[2] = {p->hi[0], 0};
    for (int k = 0; k < CELLS; k++) {
        double x[2] = {p->hi[0] - (first + k) * dx, 0}, in[2] = {x[0] - d, 0};
        double from = scene_exact(e->scene, p, in, p->t_end).gradient[0];
        all += weight[k], sum += weight[k] * fabs(scene_exact(e->scene, p, x, p->t_end).gradient[0] - from) / d;
    }
    return sum / all / fabs(scene_exact(e->scene, p, wall, p->t_end).gradient[0]);
}

/* The load of a side, W m^-2: the given flux, or b T_a. */
static double load(const struct problem *p, enum side s, const double *x) {
    return (p->side[s] == ROBIN ? p->robin[s] : 1) * p->wall(p, s, x, p->t_end);
}

/* The change of the load of side s along `axis`, away from the edge at x, W m^-3. */
static double load_slope(const struct problem *p, enum side s, int axis, const double *x, double d) {
    double in[DIM_MAX] = {x[0], x[1], x[2]};
    in[axis] += x[axis] > p->lo[axis] ? -d : d;
    return fabs(load(p, s, in) - load(p, s, x)) / d;
}

/* The largest temperature of the source of `ceiling_edges` on the edge of two sides. */
static double edge_of(const struct experiment *e, enum side s, enum side cooled) {
    enum { POINTS = 13 };
    const struct problem *p = &e->problem;
    const int a = (int)s / 2, c = (int)cooled / 2, along = 3 - a - c;
    const double *k = p->material[0].k, dx = e->options.dx;
    double x[DIM_MAX] = {0}, slope = 0;
    x[a] = s % 2 ? p->hi[a] : p->lo[a], x[c] = cooled % 2 ? p->hi[c] : p->lo[c];
    for (int i = 0; i < POINTS; i++) {
        if (along < p->dim) x[along] = p->lo[along] + (p->hi[along] - p->lo[along]) * i / (POINTS - 1);
        slope = fmax(slope, load_slope(p, s, c, x, dx) + load_slope(p, cooled, a, x, dx));
    }
    double far = 4 * k[c] / (p->robin[cooled] * dx) * sqrt(k[a] / (k[a] + k[c]));
    return 2 / (M_PI * sqrt(k[a] * k[c])) * sq(dx) / 6 * slope * log(far);
}

double ceiling_edges(const struct experiment *e) {
    const struct problem *p = &e->problem;
    double most = 0;
    for (int s = 0; s < 2 * p->dim; s++)
        for (int r = 0; r < 2 * p->dim; r++)
            if (s / 2 != r / 2 && p->side[r] == ROBIN && p->side[s] == NEUMANN)
                most = fmax(most, edge_of(e, (enum side)s, (enum side)r));
    return most;
}

/* Modes n = 1 and 3 of R decay as exp(-kappa (n pi/width)^2 t); R has the amplitudes 1 and -1/10. */
double ceiling_source_step(const struct experiment *e, double dt) {
    enum { POINTS = 400 };
    double rate = ceiling_param(e, "k_x") / ceiling_param(e, "rho_c") * sq(M_PI / ceiling_param(e, "width")), sum = 0;
    double first = 1 - exp(-rate * e->problem.t_end), third = 1 - exp(-9 * rate * e->problem.t_end);
    for (int i = 0; i < POINTS; i++) {
        double a = M_PI * (i + 0.5) / POINTS;
        sum += fabs(first * sin(a) - third * sin(3 * a) / 10) / POINTS;
    }
    return dt * ceiling_param(e, "rise") * sum / means_of(e).T;
}

/* A layer of a few dx at the front is off by the temperature there, dx^(1/n), and what it holds is lost to the rest:
 * E1 is of order 1 + 1/n, the largest error of order 1/n.  The heat within `width` of the front, as a part of the
 * whole: T is xi^(1/n). */
double ceiling_front(const struct experiment *e, double width) {
    double reach = ceiling_param(e, "c") * e->problem.t_end + ceiling_param(e, "x0");
    return pow(width / reach, 1 + 1 / ceiling_param(e, "n"));
}

/* Pairs of weight w at the distance r leave the truncation error dPhi/dx, with theta the integral of k:
 *
 *     Phi = A dx^2 (theta_xxx + m T_x^3),   A = sum w x^4/(24 dx^2)
 *     m = 0 (kirchhoff, so_ssph),  k'' (arithmetic),  k'' - 3 k'^2/k (harmonic)
 *
 * since (k_i + k_j)/2 (T_j - T_i) exceeds theta_j - theta_i by k'' T_x^3 r^3/12, the harmonic mean by k'^2/(4 k)
 * T_x^3 r^3 less.  Behind the front, k = k_0 T^n, the bracket is `units` of k_0 (rho_c c n/k_0)^(1 + 1/n)
 * xi^(1/n - 2)/n^3: n - 1 (kirchhoff), -(n - 1)^2 (arithmetic), 2 n^2 + 2 n - 1 (harmonic).  Phi is monotone along
 * the rod: the mean of |dPhi/dx| is the difference of its ends. */
double ceiling_wave(const struct experiment *e, double units) {
    const double n = ceiling_param(e, "n"), c = ceiling_param(e, "c"), k_0 = ceiling_param(e, "k_0"),
                 L = e->problem.hi[0];
    const double rho_c = ceiling_param(e, "rho_c"), x0 = ceiling_param(e, "x0"), end = x0 + c * e->problem.t_end;
    const double rise = n * rho_c * c / k_0, power = 1 - 1 / n; /* T = (rise xi)^(1/n) */
    double bracket = k_0 * pow(rise, 1 + 1 / n) * units / (n * n * n), heat;
    double over_time = pow(x0 - L, -power) - pow(end - L, -power) - pow(x0, -power) + pow(end, -power);
    heat = pow(rise, 1 / n) * (pow(end, 1 + 1 / n) - pow(end - L, 1 + 1 / n)) / (1 + 1 / n) * rho_c;
    return ceiling_worst(e) / 12 * sq(e->options.dx) * bracket * over_time / (c * power) / heat;
}
