/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicted errors of smooth data and of jumps: derivatives of the exact solution, by differences, times the moments
 * of a lattice's weights.
 *
 * The weights are implemented independently of the solver, from the papers: least squares with the weights W
 * (so_ssph), pairs -W'/r (brookshaw and its corrected variants), W'' + (d - 1) W'/r (cspm, kernel_second), first
 * derivatives x W or x W'/r applied twice (fo_ssph, flux_divergence, conjugate), and finite differences.  On a
 * lattice, corrections that divide by a particle's own moments only make radial weights exact for x^2. */
#include "verification/gates/ceiling.h"

#include "references/snapshot.h"
#include "solver/particles/particles.h"
#include "solver/shape.h"
#include "solver/space/kernel.h"
#include "verification/run/run.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Weights on a lattice of spacing 1 ---- */

enum { REACH = 10, WIDE = 2 * REACH + 1, MONOMIALS = 5 };

struct stencil {
    double w[WIDE][WIDE]; /* [REACH + j][REACH + i] */
};

static double moment(const struct stencil *s, int a, int b) {
    double sum = 0;
    for (int j = -REACH; j <= REACH; j++)
        for (int i = -REACH; i <= REACH; i++) sum += s->w[REACH + j][REACH + i] * pow(i, a) * pow(j, b);
    return sum;
}

enum family { LEAST_SQUARES, PAIRS, CURVATURE, TWICE_VALUE, TWICE_SLOPE, DIFFERENCE, DIFFERENCE_TWICE };

static enum family family_of(const char *method) {
    static const struct {
        const char *method;
        enum family family;
    } row[] = {{"so_ssph", LEAST_SQUARES},
               {"contact_ssph", LEAST_SQUARES},
               {"cspm", CURVATURE},
               {"kernel_second", CURVATURE},
               {"fo_ssph", TWICE_VALUE},
               {"flux_divergence", TWICE_SLOPE},
               {"conjugate", TWICE_SLOPE},
               {"ftcs", DIFFERENCE},
               {"voronoi_flux", DIFFERENCE},
               {"positive", DIFFERENCE},
               {"ftcs_flux", DIFFERENCE_TWICE}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        if (strcmp(row[k].method, method) == 0) return row[k].family;
    return PAIRS;
}

struct lattice_case {
    enum family family;
    enum kernel_name kernel;
    int dim, order;
    double h, ratio; /* h/dx; kappa_y over kappa_x */
    double eta;      /* eta in -W' r/(r^2 + eta^2), in units of dx */
};

static double radial(const struct lattice_case *c, double r) {
    double s = r / c->h;
    if (r == 0 || s >= KERNEL_SUPPORT) return 0;
    double slope = kernel_slope(c->kernel, c->dim, s);
    switch (c->family) {
    case PAIRS:
        return -slope * r / (r * r + c->eta * c->eta);
    case CURVATURE:
        return kernel_curvature(c->kernel, c->dim, s) + (c->dim - 1) * slope / s;
    case TWICE_SLOPE:
        return -slope / r;
    default:
        return kernel_value(c->kernel, c->dim, s);
    }
}

static void fill(const struct lattice_case *c, struct stencil *s) {
    *s = (struct stencil){0};
    int rows = c->dim == 2 ? REACH / 2 : 0;
    for (int j = -rows; j <= rows; j++)
        for (int i = -REACH / 2; i <= REACH / 2; i++) s->w[REACH + j][REACH + i] = radial(c, hypot(i, j));
}

/* d2/dx2 + ratio d2/dy2 of the best-fitting polynomial of degree `order`. */
static void least_squares(const struct lattice_case *c, struct stencil *s) {
    static const int power[MONOMIALS][2] = {{2, 0}, {4, 0}, {0, 2}, {2, 2}, {0, 4}};
    int use[MONOMIALS], n = 0;
    struct stencil W = *s;
    for (int k = 0; k < MONOMIALS; k++)
        if (power[k][0] + power[k][1] <= c->order && (c->dim == 2 || power[k][1] == 0)) use[n++] = k;
    gsl_matrix *N = gsl_matrix_alloc((size_t)n, (size_t)n);
    gsl_vector *z = gsl_vector_calloc((size_t)n);
    for (int a = 0; a < n; a++) {
        const int *p = power[use[a]];
        for (int b = 0; b < n; b++)
            gsl_matrix_set(N, (size_t)a, (size_t)b, moment(&W, p[0] + power[use[b]][0], p[1] + power[use[b]][1]));
        gsl_vector_set(z, (size_t)a, p[0] + p[1] > 2 ? 0 : p[0] == 2 ? 2 : 2 * c->ratio);
    }
    gsl_linalg_HH_svx(N, z);
    for (int j = -REACH; j <= REACH; j++)
        for (int i = -REACH; i <= REACH; i++) {
            double sum = 0;
            for (int a = 0; a < n; a++)
                sum += gsl_vector_get(z, (size_t)a) * pow(i, power[use[a]][0]) * pow(j, power[use[a]][1]);
            s->w[REACH + j][REACH + i] *= sum;
        }
    gsl_matrix_free(N);
    gsl_vector_free(z);
}

/* The derivative along x, sum w x = 1, applied twice, and `ratio` times the same along y. */
static void apply_twice(const struct lattice_case *c, struct stencil *s, double *blind) {
    struct stencil D = *s, one = {0};
    double sum = moment(s, 2, 0), across = 0;
    for (int j = -REACH; j <= REACH; j++)
        for (int i = -REACH; i <= REACH; i++) {
            double w = D.w[REACH + j][REACH + i] *= i / sum;
            across += w * i * (i % 2 ? -1 : 1);
        }
    *blind = across * across;
    for (int j = -REACH / 2; j <= REACH / 2; j++)
        for (int i = -REACH / 2; i <= REACH / 2; i++)
            for (int l = -REACH / 2; l <= REACH / 2; l++)
                for (int k = -REACH / 2; k <= REACH / 2; k++)
                    one.w[REACH + j + l][REACH + i + k] += D.w[REACH + j][REACH + i] * D.w[REACH + l][REACH + k];
    for (int j = 0; j < WIDE; j++)
        for (int i = 0; i < WIDE; i++) s->w[j][i] = one.w[j][i] + (c->dim == 2 ? c->ratio * one.w[i][j] : 0);
}

static void stencil_of(const struct lattice_case *c, struct stencil *s, double *blind) {
    int step = c->family == DIFFERENCE_TWICE ? 2 : 1;
    *blind = 0;
    fill(c, s);
    switch (c->family) {
    case LEAST_SQUARES:
        least_squares(c, s);
        break;
    case TWICE_VALUE:
    case TWICE_SLOPE:
        apply_twice(c, s, blind);
        break;
    case DIFFERENCE_TWICE:
        *blind = 1;
        /* fall through */
    case DIFFERENCE:
        *s = (struct stencil){0};
        for (int side = -step; side <= step; side += 2 * step) {
            s->w[REACH][REACH + side] = 1.0 / (step * step);
            if (c->dim == 2) s->w[REACH + side][REACH] = c->ratio / (step * step);
        }
        break;
    default: {
        double second = moment(s, 2, 0) / 2;
        for (int j = 0; j < WIDE; j++)
            for (int i = 0; i < WIDE; i++) s->w[j][i] /= second;
    }
    }
}

/* B - 2 A */
static double anisotropy(struct lattice_case *c, double h) {
    struct stencil s;
    double blind;
    c->h = h;
    stencil_of(c, &s, &blind);
    return moment(&s, 2, 2) / 4 - moment(&s, 4, 0) / 12;
}

/* --h iso: the root of B = 2 A nearest to 1.2. */
static double isotropic_h(struct lattice_case *c) {
    static const double middle = 1.2, step = 1.0 / 64;
    for (int k = 0; k < 100; k++)
        for (int side = -1; side <= 1; side += 2) {
            double lo = middle + side * k * step, hi = lo + side * step, at_lo = anisotropy(c, lo);
            if (at_lo * anisotropy(c, hi) > 0) continue;
            for (int i = 0; i < 50; i++) {
                double half = (lo + hi) / 2;
                *(anisotropy(c, half) * at_lo > 0 ? &lo : &hi) = half;
            }
            return (lo + hi) / 2;
        }
    return NAN;
}

static double diffusivity(const struct experiment *e, double x) {
    const struct problem *p = &e->problem;
    const struct material *m = &p->material[p->materials > 1 && x >= p->interface];
    return m->k[0] / m->rho_c;
}

static struct lattice_case case_of(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const struct options *o = &e->options;
    struct options resolved = *o;
    struct failure ignored;
    struct lattice_case c = {.family = family_of(e->method->name), .kernel = o->kernel, .dim = p->dim};
    c.ratio = p->dim == 2 && !options_is_matched(o) ? p->material[0].k[1] / p->material[0].k[0] : 1;
    c.order = o->order > 2 ? o->order : 2;
    if (e->method->scheme && !particles_resolve(p, o, e->method->scheme, &resolved, &ignored)) c.h = resolved.h;
    if (o->h_iso) c.h = isotropic_h(&c);
    if (strcmp(e->method->name, "brookshaw") == 0) c.eta = 0.1 * c.h;
    return c;
}

double ceiling_pair(const struct experiment *e, double r) {
    struct lattice_case c = case_of(e);
    return radial(&c, r);
}

struct ceiling_symbol ceiling_symbol(const struct experiment *e) {
    struct lattice_case c = case_of(e);
    struct stencil s;
    struct ceiling_symbol symbol = {.h = c.h};
    stencil_of(&c, &s, &symbol.blind);
    for (int b = 0; b < 3; b++)
        symbol.fourth[b] = moment(&s, 4 - 2 * b, 2 * b) / tgamma(5 - 2 * b) / tgamma(2 * b + 1);
    for (int b = 0; b < 4; b++)
        symbol.sixth[b] = moment(&s, 6 - 2 * b, 2 * b) / tgamma(7 - 2 * b) / tgamma(2 * b + 1);
    for (int j = 0; j < WIDE; j++)
        for (int i = 0; i < WIDE; i++) symbol.row += fabs(s.w[j][i]) * (i != REACH || j != REACH);
    for (int i = 0; i < REACH; i++)
        for (int k = 0; i + k + 1 <= REACH; k++)
            for (int m = 0; m < WIDE; m++) {
                symbol.ghost[0] += s.w[m][REACH + i + k + 1] * (i + 0.5) * pow(k + 0.5, 4);
                symbol.ghost[1] += s.w[REACH + i + k + 1][m] * pow(k + 0.5, 5) / c.ratio;
            }
    for (int n = 0; n <= CEILING_REACH; n++) symbol.link[n] = s.w[REACH][REACH + n];
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
    return most;
}

/* ---- Derivatives of the exact solution ---- */

enum { TIMES = 7, ROD_POINTS = 400, SIDE_POINTS = 48 };

struct rates {
    double T, rate[4]; /* K; n-th derivative in time, K s^-n */
    double kappa;      /* m^2 s^-1, there */
};

/* Fills at most ROD_POINTS or SIDE_POINTS^2 points and returns their number. */
static int rates_of(const struct experiment *e, struct rates *at) {
    static const double first[3] = {3. / 4, -3. / 20, 1. / 60}, second[3] = {3. / 2, -3. / 20, 1. / 90},
                        third[3] = {-13. / 8, 1, -1. / 8};
    const struct problem *p = &e->problem;
    const double step = 0.02 * p->t_end;
    struct snapshot s[TIMES];
    int across = p->dim == 2 ? SIDE_POINTS : ROD_POINTS, rows = p->dim == 2 ? SIDE_POINTS : 1, n = 0;
    for (int k = 0; k < TIMES; k++) s[k] = snapshot_take(e->scene, p, p->t_end + (k - 3) * step);
    for (int i = 0; i < across * rows; i++) {
        double x[2] = {p->lo[0] + (p->hi[0] - p->lo[0]) * (i % across + 0.5) / across,
                       p->lo[1] + (p->hi[1] - p->lo[1]) * (i / across + 0.5) / rows};
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
    return p->jumps[0] + p->jumps[1] > 0 ? -1 : 0;
}

/* s; for Euler steps, otherwise 0 */
static double euler_step(const struct experiment *e) {
    const struct options *o = &e->options;
    const struct stepper *stepper = stepper_of(o->stepper);
    int euler = !e->method->scheme || (stepper && stepper->order == 1);
    return euler ? o->fourier * sq(o->dx) / problem_diffusivity(&e->problem) : 0;
}

/* T_xxxx, T_xxyy, T_yyyy, T_xx + T_yy by differences over nine points of step d */
static void differences(const struct snapshot *s, const double x[2], double d, double fourth[3], double *laplacian) {
    double T[5][5];
    for (int j = -2; j <= 2; j++)
        for (int i = -2; i <= 2; i++)
            if (!i || !j || (abs(i) == 1 && abs(j) == 1))
                T[j + 2][i + 2] = snapshot_at(s, (double[2]){x[0] + i * d, x[1] + j * d}).temperature;
    double c = T[2][2], sides = T[2][1] + T[2][3] + T[1][2] + T[3][2];
    double corners = T[1][1] + T[1][3] + T[3][1] + T[3][3], d4 = sq(d * d);
    fourth[0] = (T[2][0] + T[2][4] - 4 * (T[2][1] + T[2][3]) + 6 * c) / d4;
    fourth[1] = (corners - 2 * sides + 4 * c) / d4;
    fourth[2] = (T[0][2] + T[4][2] - 4 * (T[1][2] + T[3][2]) + 6 * c) / d4;
    *laplacian = (sides - 4 * c) / (d * d);
}

/* A rectangle without a source, away from its walls. */
static double of_rectangle(const struct experiment *e, const struct ceiling_symbol *symbol) {
    const struct problem *p = &e->problem;
    const double size[2] = {p->hi[0] - p->lo[0], p->hi[1] - p->lo[1]}, d = fmin(size[0], size[1]) / 200;
    double sum = 0, whole = 0, kappa = diffusivity(e, 0), euler = euler_step(e) / 2 * kappa / sq(e->options.dx);
    struct snapshot s = snapshot_take(e->scene, p, p->t_end);
    for (int k = 0; k < SIDE_POINTS * SIDE_POINTS; k++) {
        double fourth[3], laplacian, error = 0;
        double x[2] = {p->lo[0] + size[0] * (k % SIDE_POINTS + 0.5) / SIDE_POINTS,
                       p->lo[1] + size[1] * (k / SIDE_POINTS + 0.5) / SIDE_POINTS};
        differences(&s, x, d, fourth, &laplacian);
        for (int b = 0; b < 3; b++) error += (symbol->fourth[b] - (b == 1 ? 2 : 1) * euler) * fourth[b];
        sum += fabs(kappa * p->t_end * error + start_of(e) / 24 * laplacian);
        whole += fabs(snapshot_at(&s, x).temperature);
    }
    snapshot_free(&s);
    return sum / whole * sq(e->options.dx);
}

double ceiling_lattice(const struct experiment *e) {
    struct ceiling_symbol s = ceiling_symbol(e);
    double dx2 = sq(e->options.dx);
    if (e->problem.dim == 2) return of_rectangle(e, &s);
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
    for (int s = 0; s < 4; s++) robin |= e->problem.side[s] == ROBIN;
    return robin && e->problem.initial == problem_start;
}

static struct terms round_terms(const struct experiment *e) {
    struct ceiling_symbol s = ceiling_symbol(e);
    double A = (3 * s.fourth[0] + s.fourth[1] / 2) / 4 * sq(e->options.dx);
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

double ceiling_matched(const struct experiment *e) {
    struct ceiling_symbol s = ceiling_symbol(e);
    double m = start_of(e), dx4 = pow(e->options.dx, 4), most = 0;
    double all = diffusivity(e, 0) * e->problem.t_end, rt = all / sq(e->options.dx) - m / 24;
    double K = ceiling_matched_rest(s.fourth[0], rt);
    for (int k = 0; k < (e->problem.dim == 2 ? ANGLES : 1); k++) {
        double left = K - along(s.sixth, 6, M_PI * k / ANGLES);
        if (fabs(left) > fabs(most)) most = left;
    }
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
