/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particles for rho_c dT/dt = div(k grad T) + G that is not linear: k(T), or a wall with a flux that is not linear in
 * its temperature.
 *
 * Rates, with theta, the integral of k (Kirchhoff 1894):
 *
 *   brookshaw  sum_j w_ij k_ij (T_j - T_i), w of the operator for k = 1; k_ij: --mean harmonic, arithmetic, or
 *              kirchhoff, (theta_j - theta_i)/(T_j - T_i)
 *   so_ssph    lap theta
 *   fo_ssph    q = -k(T) <grad T>, -<div q>
 *
 * The product of kirchhoff's mean and T_j - T_i is theta_j - theta_i.  No quotient is formed, so equal temperatures
 * need no limit and nothing cancels.  For a k linear in T this mean is the arithmetic one.
 *
 * Ghosts at the distance d beyond a wall are reflected in theta: 2 theta(T_w) - theta + d^2 theta_nn for a wall held
 * at T_w, with theta_nn from the equation, and theta + 2 d q for a flux q.  A wall that exchanges heat has the
 * temperature that obeys theta(T_w) - theta = d q(T_w), with `exchange` of its law as q, by Newton's method.  Beyond
 * a corner the reflection along x comes first.
 *
 * Steps: dT/dt = L(T, t) by the stages of the stepper (struct stage), with walls and source at the time of each
 * stage. Without --dt a step is half of the stable one, or the stepper's own length, for the largest k of the state
 * at its start; a stepper that chooses its number of stages takes it from the same k.
 *
 * Phases: brookshaw with kirchhoff's mean.  The state is U, the enthalpy from the melting point over rho_c of the
 * material, from which T and theta follow.  The weights of a pair are positive and theta does not fall with U: steps
 * of Euler's up to 1/(bound of the rates) are monotone; other steppers are refused.
 *
 * Restrictions: one isotropic material, plane walls, --walls mirror, order 2. */
#include "solver/particles/nonlinear.h"

#include "solver/particles/particles.h"
#include "solver/space/assembly.h"
#include "solver/space/blocks.h"
#include "solver/space/sample.h"
#include "solver/work.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Conductivity ---- */

/* K: U of the temperature T, and T of U; for laws without phases both are T. */
static double state_of(const struct problem *p, double T) {
    const double u = T - p->k_ref, latent = u > 0 ? p->latent : u < 0 ? 0 : p->latent / 2;
    return p->k_law == K_PHASES ? (p->phase_rho_c[u > 0] * u + latent) / p->material[0].rho_c : T;
}

static double temperature_of(const struct problem *p, double U) {
    if (p->k_law != K_PHASES) return U;
    const double heat = p->material[0].rho_c * U;
    if (heat > p->latent) return p->k_ref + (heat - p->latent) / p->phase_rho_c[1];
    return p->k_ref + fmin(heat, 0) / p->phase_rho_c[0];
}

/* With phases, d theta/dU. */
double nonlinear_k(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_PHASES) return p->material[0].rho_c * p->phase_k[u > 0] / p->phase_rho_c[u > 0];
    if (p->k_law == K_CONSTANT) return p->material[0].k[0];
    if (p->k_law == K_LINEAR) return fmax(0, p->k_0 * (1 + p->k_beta * u));
    return u > 0 ? p->k_0 * pow(u, p->k_n) : 0;
}

double nonlinear_theta(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_CONSTANT) return p->material[0].k[0] * u;
    if (p->k_law == K_PHASES) return p->phase_k[u > 0] * u;
    if (p->k_law == K_LINEAR) return p->k_0 * u * (1 + p->k_beta * u / 2);
    return u > 0 ? p->k_0 * u * pow(u, p->k_n) / (p->k_n + 1) : 0;
}

double nonlinear_T(const struct problem *p, double theta) {
    if (p->k_law == K_PHASES) return p->k_ref + theta / p->phase_k[theta > 0];
    double part = theta / (p->k_law == K_CONSTANT ? p->material[0].k[0] : p->k_0);
    if (p->k_law == K_CONSTANT) return p->k_ref + part;
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
    size_t *row;             /* total + 1 */
    struct blocks_list list; /* neighbours and weights of the rows, w[0] */
    double *across;          /* w[1] of TWICE in the plane */
    double *T, *k, *theta;   /* total: K, W m^-1 K^-1, W m^-1 */
    double *q[2];            /* W m^-2, total, of TWICE */
    double row_sum;          /* largest sum of |w| and its diagonal for k = 1, m^-2 times 1/rho_c */
    double most, lo, hi, heating;
};

static const char *const operations[] = {[PAIRS] = "brookshaw", [CURVATURE] = "so_ssph", [TWICE] = "fo_ssph", NULL};

/* The operation of a method; that of the end of the list if it has none. */
static enum operation operation_of(const struct scheme *s) {
    int k = 0;
    while (operations[k] && strcmp(operations[k], s->name) != 0) k++;
    return (enum operation)k;
}

/* ---- Ghosts ---- */

/* Temperature of a wall that exchanges heat with surroundings at T_a, at the distance d beyond a point with this
 * theta and temperature T. */
static double exchange_wall(const struct problem *p, int side, double d, double T_a, double theta, double T) {
    enum { ITERATIONS = 50 };
    for (int i = 0; i < ITERATIONS; i++) {
        double slope, heat = problem_law(p, side)->exchange(p, (enum side)side, d, T_a, T, &slope);
        double step = (nonlinear_theta(p, T) - theta - heat) / (nonlinear_k(p, T) - slope);
        T -= step;
        if (!(fabs(step) > 4 * DBL_EPSILON * fabs(T - p->k_ref))) break;
    }
    return T;
}

/* d^2 times the second derivative of theta across a held wall: rho_c dT/dt = theta_nn + theta_tt + G. */
static double bend(const struct problem *p, int side, const double *foot, double d, double t) {
    enum side s = (enum side)side;
    const double T = p->wall(p, s, foot, t);
    const double rho_c = p->k_law == K_PHASES ? p->phase_rho_c[T > p->k_ref] : p->material[0].rho_c;
    double across = (p->wall_rate ? rho_c * p->wall_rate(p, s, foot, t) : 0) - problem_source(p, foot, t);
    double along = 0, middle = p->dim > 1 ? nonlinear_theta(p, T) : 0;
    for (int a = 0; a < p->dim; a++)
        for (int up = -1; up <= 1 && a != side / 2; up += 2) {
            double at[DIM_MAX] = {foot[0], foot[1], foot[2]};
            at[a] += up * d;
            along += nonlinear_theta(p, p->wall(p, s, at, t)) - middle;
        }
    return d * d * across - along;
}

static double reflect_theta(struct conduction *c, int side, const double *foot, double d, double theta, double t) {
    const struct problem *p = c->p;
    double value = p->wall(p, (enum side)side, foot, t);
    if (problem_law(p, side)->is_flux) {
        double extent = p->hi[side / 2] - p->lo[side / 2];
        c->heating = fmax(c->heating, fabs(value) / (p->material[0].rho_c * extent));
        return theta + 2 * d * value;
    }
    c->lo = fmin(c->lo, state_of(p, value)), c->hi = fmax(c->hi, state_of(p, value));
    double curved = p->side[side] == DIRICHLET ? bend(p, side, foot, d, t) : 0;
    if (problem_law(p, side)->exchange) value = exchange_wall(p, side, d, value, theta, nonlinear_T(p, theta));
    c->most = fmax(c->most, nonlinear_k(p, value));
    return 2 * nonlinear_theta(p, value) - theta + curved;
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
        theta = reflect_theta(c, side, at, fabs(ghost[a] - wall), theta, t);
        at[a] = ghost[a];
    }
    return theta;
}

/* ---- Rows ---- */

static int conduction_row(struct conduction *c, const struct assembly *m, size_t i, struct surroundings *at,
                          struct failure *why) {
    double weight[2][NEIGHBOURS_MAX], *w[DIM_MAX] = {weight[0], weight[1]}, sum = 0;
    if (assembly_neighbourhood(m, i, at, why) || operator_weights(m->s, m->p, m->o, &at->nb, w, why))
        return why->status;
    size_t first = c->list.n;
    for (size_t k = 0; k < at->nb.n; k++) blocks_list_add(&c->list, at->near[k], weight[0][k]);
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
static int conduction_rows(struct conduction *c, const struct assembly *m, struct failure *why) {
    struct surroundings *at = xcalloc(1, sizeof *at);
    unsigned char *wanted = xcalloc(c->cloud.total, 1);
    int status = STATUS_OK;
    for (size_t i = 0; i < c->cloud.total && !status; i++) {
        if (i < c->cloud.n || wanted[i]) status = conduction_row(c, m, i, at, why);
        c->row[i + 1] = c->list.n;
        for (size_t k = c->row[i]; k < c->row[i + 1] && i < c->cloud.n && c->operation == TWICE; k++)
            wanted[c->list.point[k]] = 1;
    }
    free(wanted);
    free(at);
    return status;
}

static int conduction_create(struct conduction **out, const struct problem *p, const struct options *o,
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
    int status = conduction_rows(c, &m, why);
    assembly_free(&m);
    return status;
}

static void conduction_free(struct conduction *c) {
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
    const int phases = c->p->k_law == K_PHASES;
    const struct problem *p = c->p;
    c->most = 0;
    for (size_t i = 0; i < c->cloud.n; i++)
        c->T[i] = phases ? temperature_of(p, T[i]) : T[i], c->theta[i] = nonlinear_theta(p, c->T[i]);
    for (size_t j = c->cloud.n; j < c->cloud.total; j++) {
        c->theta[j] = ghost_theta(c, j, t);
        c->T[j] = nonlinear_T(p, c->theta[j]);
    }
    for (size_t i = 0; i < c->cloud.total; i++) {
        c->k[i] = nonlinear_k(p, c->T[i]);
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
            double difference = c->T[c->list.point[k]] - c->T[i];
            sum[0] += c->list.value[k] * difference;
            if (c->across) sum[1] += c->across[k] * difference;
        }
        for (int a = 0; a < 2; a++) c->q[a][i] = c->k[i] * sum[a];
    }
}

static void conduction_rate(struct conduction *c, const double *T, double t, double *out) {
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

static const struct cloud *conduction_cloud(const struct conduction *c) {
    return &c->cloud;
}

static double conduction_bound(const struct conduction *c) {
    return c->row_sum * c->most;
}

static void conduction_range(const struct conduction *c, double *lo, double *hi, double *heating) {
    *lo = c->lo, *hi = c->hi, *heating = c->heating;
}

static size_t conduction_pairs(const struct conduction *c) {
    return c->row[c->cloud.total];
}

static size_t conduction_bytes(const struct conduction *c) {
    size_t row = c->list.n * (sizeof(double) * (c->across ? 2 : 1) + sizeof *c->list.point);
    return row + c->cloud.total * (sizeof *c->row + sizeof(double) * (c->operation == TWICE ? 5 : 3));
}

/* ---- Steps ---- */

struct run {
    struct conduction *c;
    const struct problem *p;
    const struct options *o;
    const struct stepper *stepper;
    size_t n;
    double *T, *state[4]; /* K: the particles; Y_(j-1), Y_(j-2), and K s^-1: L_0, L */
    double t, dt;
    long long steps, applications;
    int stages; /* most in a step */
};

static void apply(struct run *r, const double *T, double t, double *out) {
    conduction_rate(r->c, T, t, out);
    r->applications++;
}

/* older becomes stage j; L of the stage before it. */
static void combine_stage(const struct stage *g, double dt, size_t n, const double *restrict T,
                          const double *restrict newer, const double *restrict L, const double *restrict L0,
                          double *restrict older) {
    const double rest = 1 - g->newer - g->older, rate = dt * g->rate;
    for (size_t i = 0; i < n; i++)
        older[i] = g->newer * newer[i] + g->older * older[i] + rest * T[i] + rate * (L[i] - g->first * L0[i]);
}

/* A step of s stages, from L_0 in state[2]. */
static void advance_step(struct run *r, int s) {
    double *newer = r->state[0], *older = r->state[1];
    const double *L0 = r->state[2];
    struct stage g = r->stepper->stage(s, 1);
    for (size_t i = 0; i < r->n; i++) older[i] = r->T[i], newer[i] = r->T[i] + g.rate * r->dt * L0[i];
    for (int j = 2; j <= s; j++) {
        g = r->stepper->stage(s, j);
        apply(r, newer, r->t + g.time * r->dt, r->state[3]);
        combine_stage(&g, r->dt, r->n, r->T, newer, r->state[3], L0, older);
        double *swap = newer;
        newer = older, older = swap;
    }
    memcpy(r->T, newer, r->n * sizeof *newer);
}

/* Refuses a state outside the data by more than their range and the heat received; a NaN is outside. */
static int check_range(const struct run *r, const double data[2], struct failure *why) {
    double lo, hi, heating, x[DIM_MAX];
    char pace[PACE_TEXT];
    conduction_range(r->c, &lo, &hi, &heating);
    lo = fmin(lo, data[0]), hi = fmax(hi, data[1]);
    double slack = hi - lo + 2 * heating * r->p->t_end + 1e-6 * fmax(fabs(lo), fabs(hi));
    for (size_t i = 0; i < r->n; i++) {
        if (r->T[i] >= lo - slack && r->T[i] <= hi + slack) continue;
        layout_cloud_place(conduction_cloud(r->c), i, x);
        problem_wall_pace(r->p, r->dt, pace);
        return refuse(
            why, STATUS_UNSTABLE,
            "unstable: at step %lld (t = %.6g s) particle %zu at (%.6g, %.6g) m has %.4g K, the data are in "
            "[%.4g, %.4g] K; dt = %.6g s%s",
            r->steps, r->t, i, x[0], x[1], temperature_of(r->p, r->T[i]), lo, hi, r->dt,
            *pace ? pace : " is too large for k(T)");
    }
    return STATUS_OK;
}

/* Length of the next step: a whole number of equal steps to the end. */
static double next_step(const struct run *r, double bound) {
    const struct options *o = r->o;
    double left = r->p->t_end - r->t, dt = o->dt;
    if (dt == 0 && o->fourier > 0) dt = o->fourier * o->dx * o->dx / problem_diffusivity(r->p);
    if (dt == 0) dt = r->stepper->length ? r->stepper->length(0, r->p->t_end, bound) : 1 / bound;
    return left / fmax(1, ceil(left / dt - 1e-9));
}

static int run_steps(struct run *r, const double data[2], struct failure *why) {
    enum { STEPS_MAX = 100000000 };
    while (r->t < r->p->t_end) {
        apply(r, r->T, r->t, r->state[2]);
        double bound = conduction_bound(r->c);
        r->dt = next_step(r, bound);
        int s = r->stepper->count ? r->stepper->count(r->dt, bound) : r->stepper->stages;
        if (!(r->dt > 1e-12 * r->p->t_end) || s > STEPPER_STAGES_MAX || r->steps >= STEPS_MAX)
            return refuse(why, STATUS_UNSTABLE,
                          "unstable: at step %lld (t = %.6g s) k(T) would need steps of %.3g s with %d stages",
                          r->steps, r->t, r->dt, s);
        r->stages = s > r->stages ? s : r->stages;
        advance_step(r, s);
        double left = r->p->t_end - r->t;
        r->t = left - r->dt <= 1e-9 * r->dt ? r->p->t_end : r->t + r->dt;
        r->steps++;
        if (check_range(r, data, why)) return why->status;
    }
    return STATUS_OK;
}

static void set_counts(const struct run *r, const struct lattice *l, struct field *f) {
    f->h = r->o->h;
    f->steps = r->steps, f->stages = r->stages, f->dt = r->steps ? r->p->t_end / (double)r->steps : 0;
    f->applications = r->applications;
    f->bound = conduction_bound(r->c);
    f->cost.updates = r->applications * (long long)r->n;
    f->cost.interactions = r->applications * (long long)conduction_pairs(r->c);
    f->cost.work = WORK_SCALAR * ((double)f->cost.interactions + WORK_FUNCTION * (double)f->cost.updates);
    f->cost.bytes = conduction_bytes(r->c) + r->n * (size_t)(l->dim + 5) * sizeof(double);
    for (int a = 0; a < l->dim; a++) {
        f->shape[a] = l->dim == 1 && !options_is_cloud(r->o) ? l->n[a] : 0;
        f->spacing[a] = l->dx[a];
    }
    for (int a = l->dim; a < DIM_MAX && f->shape[0]; a++) f->shape[a] = 1;
}

static double total_heat(const struct problem *p, const struct field *f, double volume) {
    double sum = 0;
    for (size_t i = 0; i < f->n; i++) sum += f->T[i];
    return p->material[0].rho_c * volume * sum;
}

/* Positions and initial data. */
static void set_start(const struct problem *p, const struct options *o, const struct lattice *l,
                      const struct cloud *c, struct field *f) {
    field_alloc(f, p->dim, c->n);
    f->range[0] = INFINITY, f->range[1] = -INFINITY;
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX];
        layout_cloud_place(c, i, x);
        field_put(f, i, x);
        f->T[i] = sample_initial(p, o->sampling, l->dx, x);
        f->range[0] = fmin(f->range[0], f->T[i]), f->range[1] = fmax(f->range[1], f->T[i]);
        f->T[i] = state_of(p, f->T[i]);
    }
}

int nonlinear_solve(const struct method *m, const struct problem *p, const struct options *given, struct field *out,
                    struct failure *why) {
    double begin = field_clock();
    struct options o;
    struct lattice l;
    struct conduction *c = NULL;
    struct field f = {0};
    int rows;
    if (p->k_law == K_PHASES && (operation_of(m->scheme) != PAIRS || given->mean != MEAN_KIRCHHOFF ||
                                 given->sampling != SAMPLING_POINT || given->stepper != STEPPER_EULER))
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "%s: %s; use ftcs, or brookshaw with --mean kirchhoff, --stepper euler and --sampling point",
                      m->name, problem_nonlinearity(p));
    if (!operations[operation_of(m->scheme)])
        return refuse(why, STATUS_NOT_APPLICABLE, "%s: %s; use so_ssph, fo_ssph%s", m->name, problem_nonlinearity(p),
                      p->k_law ? ", brookshaw or ftcs" : " or brookshaw");
    if (particles_prepare(p, given, m->scheme, &o, &l, &rows, why)) return why->status;
    if (o.stepper == STEPPER_AUTO) o.stepper = stepper_auto(1, o.dt > 0 || o.fourier > 0, 0);
    int status = conduction_create(&c, p, &o, m->scheme, &l, why);
    if (!status) {
        set_start(p, &o, &l, conduction_cloud(c), &f);
        struct run r = {.c = c, .p = p, .o = &o, .stepper = stepper_of(o.stepper), .n = f.n, .T = f.T};
        for (int k = 0; k < 4; k++) r.state[k] = xcalloc(f.n, sizeof(double));
        f.heat[0] = total_heat(p, &f, layout_volume(&l));
        double loop = field_clock();
        status = run_steps(&r, (double[2]){state_of(p, f.range[0]), state_of(p, f.range[1])}, why);
        f.cost.step_seconds = field_clock() - loop;
        f.heat[1] = total_heat(p, &f, layout_volume(&l));
        for (size_t i = 0; i < f.n; i++) f.T[i] = temperature_of(p, f.T[i]);
        f.time = p->t_end;
        set_counts(&r, &l, &f);
        for (int k = 0; k < 4; k++) free(r.state[k]);
    }
    conduction_free(c);
    f.cost.seconds = field_clock() - begin;
    if (status)
        field_free(&f);
    else
        *out = f;
    return status;
}
