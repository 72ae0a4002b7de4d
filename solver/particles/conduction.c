/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rates of rho_c dT/dt = div(k(T) grad T) + G by particles, with theta, the integral of k (Kirchhoff 1894):
 *
 *   brookshaw  sum_j w_ij k_ij (T_j - T_i), w of the operator for k = 1; k_ij: --mean harmonic, arithmetic, or
 *              kirchhoff, (theta_j - theta_i)/(T_j - T_i)
 *   so_ssph    lap theta
 *   fo_ssph    q = -k(T) <grad T>, -<div q>
 *
 * The product of kirchhoff's mean and T_j - T_i is theta_j - theta_i.  No quotient is formed, so equal temperatures
 * need no limit and nothing cancels.  For a k linear in T this mean is the arithmetic one.
 *
 * Ghosts are reflected in theta, in which every condition but Robin's is linear: 2 theta(T_wall) - theta +
 * d^2 theta_nn for a held wall, with theta_nn from the equation, and theta + 2 d q for a flux.  A Robin wall at T_w
 * obeys theta(T_w) - theta = d b (T_a - T_w), solved by Newton's method.  Beyond a corner the reflection along x
 * comes first.
 *
 * Restrictions: one isotropic material, plane walls, --walls mirror, order 2. */
#include "solver/particles/conduction.h"
#include "solver/space/assembly.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

double conduction_k(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_LINEAR) return fmax(0, p->k_0 * (1 + p->k_beta * u));
    return u > 0 ? p->k_0 * pow(u, p->k_n) : 0;
}

double conduction_theta(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_LINEAR) return p->k_0 * u * (1 + p->k_beta * u / 2);
    return u > 0 ? p->k_0 * u * pow(u, p->k_n) / (p->k_n + 1) : 0;
}

double conduction_T(const struct problem *p, double theta) {
    double part = theta / p->k_0;
    if (p->k_law == K_LINEAR) return p->k_ref + 2 * part / (1 + sqrt(fmax(0, 1 + 2 * p->k_beta * part)));
    return p->k_ref + copysign(pow((p->k_n + 1) * fabs(part), 1 / (p->k_n + 1)), part);
}

enum operation { PAIRS, CURVATURE, TWICE };

struct conduction {
    struct problem unit; /* the problem with k = 1 */
    const struct problem *p;
    enum operation operation;
    enum mean mean;
    struct cloud cloud;
    size_t *row;               /* total + 1 */
    struct assembly_list list; /* neighbours and weights of the rows, w[0] */
    double *across;            /* w[1] of TWICE in the plane */
    double *T, *k, *theta;     /* total: K, W m^-1 K^-1, W m^-1 */
    double *q[2];              /* W m^-2, total, of TWICE */
    double row_sum;            /* largest sum of |w| and its diagonal for k = 1, m^-2 times 1/rho_c */
    double most, lo, hi, heating;
};

static const char *const operations[] = {[PAIRS] = "brookshaw", [CURVATURE] = "so_ssph", [TWICE] = "fo_ssph", NULL};

/* The operation of a method; that of the end of the list if it has none. */
static enum operation operation_of(const struct scheme *s) {
    int k = 0;
    while (operations[k] && strcmp(operations[k], s->name) != 0) k++;
    return (enum operation)k;
}

int conduction_supports(const struct scheme *s) {
    return operations[operation_of(s)] != NULL;
}

/* ---- Ghosts ---- */

/* Temperature of a Robin wall at the distance d beyond a point with this theta and temperature T. */
static double robin_wall(const struct problem *p, double b, double d, double T_a, double theta, double T) {
    enum { ITERATIONS = 50 };
    for (int i = 0; i < ITERATIONS; i++) {
        double step = (conduction_theta(p, T) - theta - b * d * (T_a - T)) / (conduction_k(p, T) + b * d);
        T -= step;
        if (!(fabs(step) > 4 * DBL_EPSILON * fabs(T - p->k_ref))) break;
    }
    return T;
}

/* d^2 times the second derivative of theta across a held wall: rho_c dT/dt = theta_nn + theta_tt + G. */
static double bend(const struct problem *p, int side, const double *foot, double d, double t) {
    enum side s = (enum side)side;
    double across =
        (p->wall_rate ? p->material[0].rho_c * p->wall_rate(p, s, foot, t) : 0) - problem_source(p, foot, t);
    double along = 0, middle = p->dim > 1 ? conduction_theta(p, p->wall(p, s, foot, t)) : 0;
    for (int a = 0; a < p->dim; a++)
        for (int up = -1; up <= 1 && a != side / 2; up += 2) {
            double at[DIM_MAX] = {foot[0], foot[1], foot[2]};
            at[a] += up * d;
            along += conduction_theta(p, p->wall(p, s, at, t)) - middle;
        }
    return d * d * across - along;
}

static double reflect(struct conduction *c, int side, const double *foot, double d, double theta, double t) {
    const struct problem *p = c->p;
    double value = p->wall(p, (enum side)side, foot, t);
    if (p->side[side] == NEUMANN) {
        double extent = p->hi[side / 2] - p->lo[side / 2];
        c->heating = fmax(c->heating, fabs(value) / (p->material[0].rho_c * extent));
        return theta + 2 * d * value;
    }
    c->lo = fmin(c->lo, value), c->hi = fmax(c->hi, value);
    double curved = p->side[side] == DIRICHLET ? bend(p, side, foot, d, t) : 0;
    if (p->side[side] == ROBIN) value = robin_wall(p, p->robin[side], d, value, theta, conduction_T(p, theta));
    c->most = fmax(c->most, conduction_k(p, value));
    return 2 * conduction_theta(p, value) - theta + curved;
}

/* theta of ghost j; on periodic sides that of its source. */
static double ghost_theta(struct conduction *c, size_t j, double t) {
    const struct problem *p = c->p;
    double at[DIM_MAX], ghost[DIM_MAX], theta = c->theta[c->cloud.source[j]];
    layout_cloud_place(&c->cloud, c->cloud.source[j], at);
    layout_cloud_place(&c->cloud, j, ghost);
    for (int a = 0; a < p->dim; a++) {
        int side = 2 * a + (ghost[a] > p->hi[a]);
        double wall = ghost[a] > p->hi[a] ? p->hi[a] : p->lo[a];
        if ((ghost[a] >= p->lo[a] && ghost[a] <= p->hi[a]) || p->side[side] == PERIODIC) continue;
        at[a] = wall;
        theta = reflect(c, side, at, fabs(ghost[a] - wall), theta, t);
        at[a] = ghost[a];
    }
    return theta;
}

/* ---- Rows ---- */

static int add_row(struct conduction *c, const struct assembly *m, size_t i, struct surroundings *at,
                   struct failure *why) {
    double weight[2][NEIGHBOURS_MAX], *w[DIM_MAX] = {weight[0], weight[1]}, sum = 0;
    if (assembly_neighbourhood(m, i, at, why) || operator_weights(m->s, m->p, m->o, &at->nb, w, why))
        return why->status;
    size_t first = c->list.n;
    for (size_t k = 0; k < at->nb.n; k++) assembly_list_add(&c->list, at->near[k], weight[0][k]);
    if (c->across) {
        c->across = xcheck(realloc(c->across, c->list.room * sizeof(double)), c->list.room, sizeof(double));
        for (size_t k = 0; k < at->nb.n; k++) c->across[first + k] = weight[1][k];
    }
    for (size_t k = 0; k < at->nb.n; k++)
        sum += fabs(weight[0][k]) + (c->operation == TWICE && c->unit.dim == 2 ? fabs(weight[1][k]) : 0);
    if (c->operation == TWICE) sum = sum * sum / c->p->material[0].rho_c;
    c->row_sum = fmax(c->row_sum, 2 * sum);
    return STATUS_OK;
}

/* Rows of the particles; for TWICE also of the ghosts next to them. */
static int add_rows(struct conduction *c, const struct assembly *m, struct failure *why) {
    struct surroundings *at = xcalloc(1, sizeof *at);
    unsigned char *wanted = xcalloc(c->cloud.total, 1);
    int status = STATUS_OK;
    for (size_t i = 0; i < c->cloud.total && !status; i++) {
        if (i < c->cloud.n || wanted[i]) status = add_row(c, m, i, at, why);
        c->row[i + 1] = c->list.n;
        for (size_t k = c->row[i]; k < c->row[i + 1] && i < c->cloud.n && c->operation == TWICE; k++)
            wanted[c->list.point[k]] = 1;
    }
    free(wanted);
    free(at);
    return status;
}

int conduction_create(struct conduction **out, const struct problem *p, const struct options *o,
                      const struct scheme *s, const struct lattice *l, struct failure *why) {
    struct conduction *c = xcalloc(1, sizeof *c);
    struct assembly m;
    *c = (struct conduction){
        .unit = *p, .p = p, .operation = operation_of(s), .mean = o->mean, .lo = INFINITY, .hi = -INFINITY};
    for (int a = 0; a < p->dim; a++) c->unit.material[0].k[a] = 1;
    *out = c;
    if (particles_cloud(p, o, s, l, &c->cloud, why)) return why->status;
    size_t total = c->cloud.total;
    c->row = xcalloc(total + 1, sizeof *c->row);
    double **array[] = {&c->T, &c->k, &c->theta, &c->q[0], &c->q[1]};
    for (size_t k = 0; k < (c->operation == TWICE ? 5 : 3); k++) *array[k] = xcalloc(total, sizeof(double));
    if (c->operation == TWICE && p->dim == 2) c->across = xcalloc(1, sizeof(double));
    if (assembly_create(&m, &c->unit, o, s, &c->cloud, l->dx[0], why)) return why->status;
    int status = add_rows(c, &m, why);
    assembly_free(&m);
    return status;
}

void conduction_free(struct conduction *c) {
    if (!c) return;
    layout_cloud_free(&c->cloud);
    double *array[] = {c->T, c->k, c->theta, c->q[0], c->q[1], c->across, c->list.value};
    for (size_t k = 0; k < sizeof array / sizeof *array; k++) free(array[k]);
    free(c->row);
    free(c->list.point);
    free(c);
}

/* ---- Rates ---- */

static void set_points(struct conduction *c, const double *T, double t) {
    const struct problem *p = c->p;
    c->most = 0;
    for (size_t i = 0; i < c->cloud.n; i++) c->T[i] = T[i], c->theta[i] = conduction_theta(p, T[i]);
    for (size_t j = c->cloud.n; j < c->cloud.total; j++) {
        c->theta[j] = ghost_theta(c, j, t);
        c->T[j] = conduction_T(p, c->theta[j]);
    }
    for (size_t i = 0; i < c->cloud.total; i++) {
        c->k[i] = conduction_k(p, c->T[i]);
        if (!(c->k[i] <= c->most)) c->most = c->k[i]; /* a NaN stays */
    }
}

static double pair_flux(const struct conduction *c, size_t i, size_t j) {
    double sum = c->k[i] + c->k[j];
    if (c->mean == MEAN_HARMONIC) return sum > 0 ? 2 * c->k[i] * c->k[j] / sum * (c->T[j] - c->T[i]) : 0;
    if (c->mean == MEAN_ARITHMETIC) return sum / 2 * (c->T[j] - c->T[i]);
    return c->theta[j] - c->theta[i];
}

/* q = k <grad T>, W m^-2, of every point with a row */
static void set_flux(struct conduction *c) {
    for (size_t i = 0; i < c->cloud.total; i++) {
        double sum[2] = {0, 0};
        for (size_t k = c->row[i]; k < c->row[i + 1]; k++) {
            double apart = c->T[c->list.point[k]] - c->T[i];
            sum[0] += c->list.value[k] * apart;
            if (c->across) sum[1] += c->across[k] * apart;
        }
        for (int a = 0; a < 2; a++) c->q[a][i] = c->k[i] * sum[a];
    }
}

void conduction_rate(struct conduction *c, const double *T, double t, double *out) {
    const struct problem *p = c->p;
    set_points(c, T, t);
    if (c->operation == TWICE) set_flux(c);
    for (size_t i = 0; i < c->cloud.n; i++) {
        double sum = 0, x[DIM_MAX];
        for (size_t k = c->row[i]; k < c->row[i + 1]; k++) {
            size_t j = c->list.point[k];
            double w = c->list.value[k];
            if (c->operation == TWICE) {
                sum += w * (c->q[0][j] - c->q[0][i]) + (c->across ? c->across[k] * (c->q[1][j] - c->q[1][i]) : 0);
            } else
                sum += w * (c->operation == CURVATURE ? c->theta[j] - c->theta[i] : pair_flux(c, i, j));
        }
        if (c->operation == TWICE) sum /= p->material[0].rho_c;
        layout_cloud_place(&c->cloud, i, x);
        double heating = problem_source(p, x, t) / p->material[0].rho_c;
        c->heating = fmax(c->heating, fabs(heating));
        out[i] = sum + heating;
    }
}

const struct cloud *conduction_cloud(const struct conduction *c) {
    return &c->cloud;
}

double conduction_bound(const struct conduction *c) {
    return c->row_sum * c->most;
}

void conduction_range(const struct conduction *c, double *lo, double *hi, double *heating) {
    *lo = c->lo, *hi = c->hi, *heating = c->heating;
}

size_t conduction_pairs(const struct conduction *c) {
    return c->row[c->cloud.total];
}

size_t conduction_bytes(const struct conduction *c) {
    size_t row = c->list.n * (sizeof(double) * (c->across ? 2 : 1) + sizeof *c->list.point);
    return row + c->cloud.total * (sizeof *c->row + sizeof(double) * (c->operation == TWICE ? 5 : 3));
}
