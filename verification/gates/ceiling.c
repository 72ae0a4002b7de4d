/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicted errors of smooth data and of jumps: derivatives of the exact solution, by differences, times the moments
 * of a lattice's weights. */
#include "verification/gates/ceiling.h"

#include "references/snapshot.h"
#include "solver/particles/particles.h"
#include "solver/shape.h"
#include "verification/gates/ceiling_weights.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double diffusivity(const struct experiment *e, double x) {
    const struct problem *p = &e->problem;
    const struct material *m = &p->material[p->materials > 1 && x >= p->interface];
    return m->k[0] / m->rho_c;
}

double ceiling_pair(const struct experiment *e, double r) {
    struct ceiling_weights_case c = ceiling_weights_case(e);
    return ceiling_weights_radial(&c, r);
}

/* ---- The symbol of a method on a lattice ---- */

/* Moments across one wall, of rows and ghosts on either side of it. */
static void ghost_moments(const struct ceiling_weights *s, double ratio, double ghost[2]) {
    enum { REACH = CEILING_WEIGHTS_REACH };
    for (int i = 0; i < REACH; i++)
        for (int k = 0; i + k + 1 <= REACH; k++)
            for (int m = 0; m < CEILING_WEIGHTS_WIDE; m++) {
                ghost[0] += s->w[REACH][m][REACH + i + k + 1] * (i + 0.5) * pow(k + 0.5, 4);
                ghost[1] += s->w[REACH][REACH + i + k + 1][m] * pow(k + 0.5, 5) / ratio;
            }
}

struct ceiling_symbol ceiling_symbol(const struct experiment *e) {
    enum { REACH = CEILING_WEIGHTS_REACH, WIDE = CEILING_WEIGHTS_WIDE };
    struct ceiling_weights_case c = ceiling_weights_case(e);
    struct ceiling_weights s;
    struct ceiling_symbol symbol = {.h = c.h};
    ceiling_weights_of(&c, &s, &symbol.blind);
    for (int b = 0; b < 3; b++)
        symbol.fourth[b] = ceiling_weights_moment(&s, 4 - 2 * b, 2 * b, 0) / tgamma(5 - 2 * b) / tgamma(2 * b + 1);
    for (int b = 0; b < 4; b++)
        symbol.sixth[b] = ceiling_weights_moment(&s, 6 - 2 * b, 2 * b, 0) / tgamma(7 - 2 * b) / tgamma(2 * b + 1);
    for (int a = 0; a < c.dim; a++)
        for (int b = 0; b < c.dim; b++) {
            int power[DIM_MAX] = {0};
            power[a] += 2, power[b] += 2;
            symbol.by_axes[a][b] = ceiling_weights_moment(&s, power[0], power[1], power[2]) / (a == b ? 24 : 4);
        }
    const double *w = &s.w[0][0][0], centre = s.w[REACH][REACH][REACH];
    for (int n = 0; n < WIDE * WIDE * WIDE; n++) symbol.row += fabs(w[n]);
    symbol.row -= fabs(centre);
    ghost_moments(&s, c.ratio[1], symbol.ghost);
    for (int n = 0; n <= CEILING_REACH; n++) symbol.link[n] = s.w[REACH][REACH][REACH + n];
    return symbol;
}

/* sum_b c[b] cos^(n-2b) sin^2b */
static double along(const double *c, int n, double angle) {
    double sum = 0;
    for (int b = 0; 2 * b <= n; b++) sum += c[b] * pow(cos(angle), n - 2 * b) * pow(sin(angle), 2 * b);
    return sum;
}

enum { ANGLES = 64 };

double ceiling_worst(const struct experiment *e) {
    struct ceiling_symbol s = ceiling_symbol(e);
    const double five_point[3] = {1.0 / 12, 0, 1.0 / 12};
    double most = s.fourth[0] * 12;
    for (int k = 0; k < ANGLES && e->problem.dim == 2; k++) {
        double angle = M_PI * k / ANGLES;
        most = fmax(most, along(s.fourth, 4, angle) / along(five_point, 4, angle));
    }
    for (int k = 0; k < ANGLES * ANGLES && e->problem.dim == 3; k++) {
        double up = M_PI * (k % ANGLES) / ANGLES, round = M_PI * (k / ANGLES) / ANGLES, sum = 0, of_seven = 0;
        double u[DIM_MAX] = {cos(up) * cos(round), cos(up) * sin(round), sin(up)};
        for (int a = 0; a < DIM_MAX; a++)
            for (int b = 0; b <= a; b++) sum += s.by_axes[a][b] * u[a] * u[a] * u[b] * u[b];
        for (int a = 0; a < DIM_MAX; a++)
            of_seven += e->problem.material[0].k[a] / e->problem.material[0].k[0] * pow(u[a], 4) / 12;
        most = fmax(most, sum / of_seven);
    }
    return most;
}

/* ---- Derivatives of the exact solution ---- */

enum { TIMES = 7, ROD_POINTS = 400, SIDE_POINTS = 48, BOX_POINTS = 12 };

struct rates {
    double T, rate[4]; /* K; n-th derivative in time, K s^-n */
    double kappa;      /* m^2 s^-1, there */
};

/* Sample k of `side` along each axis, at cell centres. */
static void sample_point(const struct problem *p, int side, int k, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++, k /= side) {
        double lo = a < p->dim && p->dim == 3 && p->mirror[a] ? (p->lo[a] + p->hi[a]) / 2 : p->lo[a];
        x[a] = a < p->dim ? lo + (p->hi[a] - lo) * (k % side + 0.5) / side : 0;
    }
}

/* Fills at most ROD_POINTS, SIDE_POINTS^2 or BOX_POINTS^3 points and returns their number. */
static int rates_of(const struct experiment *e, struct rates *at) {
    static const double first[3] = {3. / 4, -3. / 20, 1. / 60}, second[3] = {3. / 2, -3. / 20, 1. / 90},
                        third[3] = {-13. / 8, 1, -1. / 8};
    const struct problem *p = &e->problem;
    const double step = 0.02 * p->t_end;
    struct snapshot s[TIMES];
    const int side[DIM_MAX] = {ROD_POINTS, SIDE_POINTS, BOX_POINTS}, across = side[p->dim - 1];
    int n = 0, count = 1;
    for (int a = 0; a < p->dim; a++) count *= across;
    for (int k = 0; k < TIMES; k++) s[k] = snapshot_take(e->scene, p, p->t_end + (k - 3) * step);
    for (int i = 0; i < count; i++) {
        double x[DIM_MAX];
        sample_point(p, across, i, x);
        double T[TIMES];
        if (p->shape && shape_depth(p, x) < 0) continue;
        for (int k = 0; k < TIMES; k++) T[k] = snapshot_at(&s[k], x).temperature;
        struct rates r = {.T = T[3], .rate = {T[3]}, .kappa = diffusivity(e, x[0])};
        for (int k = 0; k < 3; k++) {
            double odd = T[4 + k] - T[2 - k], even = T[4 + k] + T[2 - k] - 2 * T[3];
            r.rate[1] += first[k] * odd / step;
            r.rate[2] += second[k] * even / (step * step);
            r.rate[3] += third[k] * odd / pow(step, 3);
        }
        at[n++] = r;
    }
    for (int k = 0; k < TIMES; k++) snapshot_free(&s[k]);
    return n;
}

/* Factors of T_t/kappa, t T_tt/kappa and t T_ttt/kappa^2 (errors in space), and of t T_tt and t T_ttt (errors in
 * time). */
struct terms {
    double laplacian, fourth, sixth, euler, third;
};

/* The mean of |the sum of these terms| divided by the mean of |T|; *largest, unless NULL: the largest |sum|. */
static double terms_of(const struct experiment *e, const struct terms *c, double *largest) {
    struct rates *at = xcalloc(ROD_POINTS + SIDE_POINTS * SIDE_POINTS, sizeof *at);
    double sum = 0, whole = 0, most = 0, t = e->problem.t_end;
    int n = rates_of(e, at);
    for (int i = 0; i < n; i++) {
        const double *rate = at[i].rate, kappa = at[i].kappa;
        double error = fabs(c->laplacian * rate[1] / kappa + t * rate[2] * (c->fourth / kappa + c->euler) +
                            t * rate[3] * (c->sixth / (kappa * kappa) + c->third));
        sum += error, whole += fabs(at[i].T), most = fmax(most, error);
    }
    free(at);
    if (largest) *largest = most;
    return sum / whole;
}

static double mean_of(const struct experiment *e, const struct terms *c) {
    return terms_of(e, c, NULL);
}

/* ---- Errors in space ---- */

static double sq(double x) {
    return x * x;
}

/* Point samples of a jump midway between lattice points act as -dx^2/24 T_xx, averages of order m as +m. */
static double start_of(const struct experiment *e) {
    const struct problem *p = &e->problem;
    enum sampling sampling = e->options.sampling;
    if (sampling != SAMPLING_POINT) return sampling == SAMPLING_CELL ? 1 : 4;
    return p->jumps[0] + p->jumps[1] + p->jumps[2] > 0 ? -1 : 0;
}

/* s; for Euler steps, otherwise 0 */
static double euler_step(const struct experiment *e) {
    const struct options *o = &e->options;
    const struct stepper *stepper = stepper_of(o->stepper);
    int euler = !e->method->scheme || (stepper && stepper->order == 1);
    return euler ? o->fourier * sq(o->dx) / problem_diffusivity(&e->problem) : 0;
}

/* Temperature at x + i d along axis a and j d along axis b. */
static double beside(const struct snapshot *s, const double *x, int a, double i, int b, double j) {
    double at[DIM_MAX] = {x[0], x[1], x[2]};
    at[a] += i, at[b] += j;
    return snapshot_at(s, at).temperature;
}

/* d2/dx_a2 d2/dx_b2 of T for all axes, and their Laplacian, by differences of step d. */
static void differences(const struct snapshot *s, const double *x, double d, double fourth[DIM_MAX][DIM_MAX],
                        double *laplacian) {
    double centre = snapshot_at(s, x).temperature, sides[DIM_MAX], d4 = sq(d * d);
    *laplacian = 0;
    for (int a = 0; a < s->problem->dim; a++) {
        sides[a] = beside(s, x, a, d, a, 0) + beside(s, x, a, -d, a, 0);
        fourth[a][a] =
            (beside(s, x, a, 2 * d, a, 0) + beside(s, x, a, -2 * d, a, 0) - 4 * sides[a] + 6 * centre) / d4;
        *laplacian += (sides[a] - 2 * centre) / (d * d);
        for (int b = 0; b < a; b++) {
            double corners = beside(s, x, a, d, b, d) + beside(s, x, a, d, b, -d) + beside(s, x, a, -d, b, d) +
                             beside(s, x, a, -d, b, -d);
            fourth[a][b] = (corners - 2 * (sides[a] + sides[b]) + 4 * centre) / d4;
        }
    }
}

/* A rectangle or a box without a source, away from its walls. */
static double of_box(const struct experiment *e, const struct ceiling_symbol *symbol) {
    const struct problem *p = &e->problem;
    const int side = p->dim == 3 ? BOX_POINTS : SIDE_POINTS;
    double extent = INFINITY, sum = 0, whole = 0, ratio[DIM_MAX] = {0};
    double kappa = diffusivity(e, 0), euler = euler_step(e) / 2 * kappa / sq(e->options.dx);
    struct snapshot s = snapshot_take(e->scene, p, p->t_end);
    for (int a = 0; a < p->dim; a++) {
        extent = fmin(extent, p->hi[a] - p->lo[a]);
        ratio[a] = p->material[0].k[a] / p->material[0].k[0];
    }
    for (int k = 0; k < (p->dim == 3 ? side * side * side : side * side); k++) {
        double fourth[DIM_MAX][DIM_MAX], laplacian, error = 0, x[DIM_MAX];
        sample_point(p, side, k, x);
        differences(&s, x, extent / 200, fourth, &laplacian);
        for (int a = 0; a < p->dim; a++)
            for (int b = 0; b <= a; b++)
                error += (symbol->by_axes[a][b] - (a == b ? 1 : 2) * euler * ratio[a] * ratio[b]) * fourth[a][b];
        sum += fabs(kappa * p->t_end * error + start_of(e) / 24 * laplacian);
        whole += fabs(snapshot_at(&s, x).temperature);
    }
    snapshot_free(&s);
    return sum / whole * sq(e->options.dx);
}

double ceiling_lattice(const struct experiment *e) {
    struct ceiling_symbol s = ceiling_symbol(e);
    double dx2 = sq(e->options.dx);
    if (e->problem.dim > 1) return of_box(e, &s);
    struct terms c = {.laplacian = start_of(e) / 24 * dx2, .fourth = s.fourth[0] * dx2, .euler = -euler_step(e) / 2};
    return mean_of(e, &c);
}

double ceiling_points(const struct experiment *e) {
    struct experiment points = *e;
    points.options.sampling = SAMPLING_POINT;
    return ceiling_lattice(&points);
}

/* 1 if even initial data are cooled from the start: the jump of dT/dn has the same weight as the slope of the
 * mode. */
static int cooled_at_once(const struct experiment *e) {
    int robin = 0;
    for (int s = 0; s < SIDES; s++) robin |= e->problem.side[s] == ROBIN;
    return robin && e->problem.initial == problem_start;
}

static struct terms round_terms(const struct experiment *e) {
    struct ceiling_symbol s = ceiling_symbol(e);
    double A = 3 * s.fourth[0] + s.fourth[1] / 2; /* mean over the directions: <u^4> = 3/8, in space 1/5 */
    if (e->problem.dim == 3) A = (12 * s.fourth[0] + 4 * s.fourth[1]) / 5;
    A *= sq(e->options.dx) / 4;
    return (struct terms){.fourth = A, .laplacian = cooled_at_once(e) ? A : 0};
}

double ceiling_round(const struct experiment *e) {
    struct terms c = round_terms(e);
    return mean_of(e, &c);
}

double ceiling_round_largest(const struct experiment *e) {
    struct terms c = round_terms(e);
    double largest;
    terms_of(e, &c, &largest);
    return largest;
}

double ceiling_fourth(const struct experiment *e) {
    struct terms c = {.sixth = ceiling_symbol(e).sixth[0] * pow(e->options.dx, 4)};
    return mean_of(e, &c);
}

/* n Euler steps of d (1 +- u), r d (1 + u^2) = 2 A, r = kappa/dx^2, multiply a mode by exp(sum log(1 + dt lambda)).
 * The second order cancels.  The remainder is r t (K |theta|^6 - c60 (theta_x^6 + theta_y^6) - c42 (...)) and, for
 * initial data averaged with a B-spline of order m, whose clock starts at m/(24 r), -m/2880 (theta_x^4 +
 * theta_y^4). */
double ceiling_matched_rest(double A, double rt) {
    double n = 2 * ceil(rt / (2 * A) / 2 - 1e-9), rd = rt / n, u2 = 2 * A / rd - 1;
    return 2 * A * A - rd * rd * (1 + 3 * u2) / 3;
}

/* sum w (u . x)^6/720 of the direction u for which it differs most from K. */
static double sixth_in_space(const struct experiment *e, double K) {
    enum { TURNS = 12, REACH = CEILING_WEIGHTS_REACH };
    struct ceiling_weights_case c = ceiling_weights_case(e);
    struct ceiling_weights w;
    double blind, most = K;
    ceiling_weights_of(&c, &w, &blind);
    for (int turn = 0; turn < TURNS * TURNS; turn++) {
        double up = M_PI / 2 * (turn % TURNS) / (TURNS - 1), round = M_PI / 4 * (turn / TURNS) / (TURNS - 1), sum = 0;
        for (int k = -REACH; k <= REACH; k++)
            for (int j = -REACH; j <= REACH; j++)
                for (int i = -REACH; i <= REACH; i++) {
                    double value = w.w[REACH + k][REACH + j][REACH + i];
                    if (value == 0) continue;
                    double along = cos(up) * (cos(round) * i + sin(round) * j) + sin(up) * k;
                    sum += value * pow(along, 6) / 720;
                }
        if (fabs(sum - K) > fabs(most - K)) most = sum;
    }
    return most;
}

double ceiling_matched(const struct experiment *e) {
    struct ceiling_symbol s = ceiling_symbol(e);
    double m = start_of(e), dx4 = pow(e->options.dx, 4), most = 0;
    double all = diffusivity(e, 0) * e->problem.t_end, rt = all / sq(e->options.dx) - m / 24;
    double K = ceiling_matched_rest(s.fourth[0], rt);
    for (int k = 0; k < (e->problem.dim == 2 ? ANGLES : 1); k++) {
        double left = K - along(s.sixth, 6, M_PI * k / ANGLES);
        if (fabs(left) > fabs(most)) most = left;
    }
    if (e->problem.dim == 3) most = K - sixth_in_space(e, K);
    struct terms c = {.sixth = -most * dx4 * rt / (rt + m / 24), .fourth = -m / 2880 * dx4 / all};
    return mean_of(e, &c);
}

double ceiling_jitter(const struct experiment *e) {
    return 1 + 4 * sq(e->options.jitter);
}

/* ---- Errors in time ---- */

static double step_of(const struct experiment *e) {
    const struct problem *p = &e->problem;
    double dt = e->options.dt > 0 ? e->options.dt : e->options.fourier * sq(e->options.dx) / problem_diffusivity(p);
    return p->t_end / ceil(p->t_end / dt - 1e-9);
}

double ceiling_third(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const struct stepper *stepper = stepper_of(e->options.stepper);
    double stages = 3, bound = 2 * ceiling_symbol(e).row * p->material[0].k[0] / p->material[0].rho_c;
    if (stepper && stepper->stages == 2) return 1.0 / 6;
    while (stages * stages + stages - 2 < 2 * step_of(e) * bound / sq(e->options.dx)) stages += 2;
    return (1 + 8 / (stages * stages + stages - 2)) / 18;
}

double ceiling_time(const struct experiment *e) {
    const struct stepper *stepper = stepper_of(e->options.stepper);
    double dt = step_of(e);
    if (stepper && stepper->order == 1) return mean_of(e, &(struct terms){.euler = dt / 2});
    return mean_of(e, &(struct terms){.third = dt * dt * ceiling_third(e)});
}

double ceiling_sixth(const struct experiment *e) {
    return mean_of(e, &(struct terms){.sixth = pow(e->options.dx, 4) / 540});
}
