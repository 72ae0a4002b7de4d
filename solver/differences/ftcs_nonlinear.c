/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite differences in conservative form for a conductivity that depends on temperature:
 *
 *   rho_c dT_i/dt = (F_(i+1/2) - F_(i-1/2))/dx + the same along y + G,   F_(i+1/2) = k_(i+1/2) (T_(i+1) - T_i)/dx
 *
 * k_(i+1/2) is the harmonic or the arithmetic mean of the two values, or the mean of k over the temperatures between
 * them (kirchhoff), for which k_(i+1/2) (T_(i+1) - T_i) is the integral of k from T_i to T_(i+1).  The harmonic mean
 * of Patankar (1980) is 0 if one of the values is 0.  Walls are faces, half a spacing from a point: a held wall has
 * the face's flux between T_i and T_wall, a flux is given, and at a Robin wall T_wall balances k dT/dn = b (T_a -
 * T_wall), by bisection.
 *
 * Steps, with D_j = Y_j - T the change up to stage j, f the rate and f_0 that of the start:
 *
 *   euler  T += dt f_0
 *   rk2    T += dt f(T + dt/2 f_0, t + dt/2)
 *   rkl2   D_j = b_j U_j,  U_0 = 0,  U_1 = w dt f_0,  w = 4/(s^2 + s - 2)
 *          U_j = (2j - 1)/j (U_(j-1) + w dt (f_(j-1) - (1 - b_(j-1)) f_0)/b_(j-1)) - (j - 1)/j U_(j-2)
 *          b_j = (j^2 + j - 2)/(2 j (j + 1)), b_1 = 1/3
 *
 * The last is the scheme of Meyer, Balsara & Aslam (2014, eqs. 16-18), divided by its b_j.  Walls and source are
 * those of the time of the stage, which follows from the same recurrence with f = 1.
 *
 * Orders in time.  A step of order 2 adds dt^3 ((S_1 - 1/6) f' f' f + (S_2/2 - 1/6) f''(f, f)), with S_1 = 0 and S_2
 * = 1/4 for rk2, and S_1 and S_2/2 near 1/9 for rkl2 with many stages: -dt^3/18 T_ttt.
 *
 * Restrictions: cell-centred grid, one isotropic material.  A step of euler or rk2 is refused if dt k/rho_c (1/dx^2 +
 * 1/dy^2) exceeds 1/2 for the largest k of the state at its start; rkl2 takes its number of stages from that k. */
#include "solver/differences/ftcs_grid.h"

#include "solver/differences/ftcs_plan.h"
#include "solver/problem.h"
#include "solver/work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct cells {
    const struct problem *p;
    enum mean mean;
    struct ftcs_grid g;
    enum stepper_name stepper;
    double *T, *rate;       /* K, W m^-3, of a stage */
    double *start, *before; /* the same at the start of the step; NULL for euler, the second for rk2 too */
    double *U[2];           /* K: U_(j-1), U_(j-2) of rkl2; else NULL */
    int stages;             /* largest number in a step */
    long long rates;        /* evaluations */
    double *first;          /* k of the initial data, W m^-1 K^-1, if it is frozen; else NULL */
    double most;            /* W m^-1 K^-1: largest k of a step */
    int hottest;            /* its cell */
    double lo, hi, heating; /* K: range of data so far; W m^-3: largest source and inflow */
};

static double conductivity(const struct problem *p, double T) {
    double k = p->k_law == K_POWER ? (T > p->k_ref ? p->k_0 * pow(T - p->k_ref, p->k_n) : 0)
                                   : p->k_0 + p->k_0 * p->k_beta * (T - p->k_ref);
    return k > 0 ? k : 0;
}

/* Integral of k from `from` to `to`, W m^-1. */
static double between(const struct problem *p, double from, double to) {
    if (p->k_law == K_LINEAR) return (to - from) * p->k_0 * (1 + p->k_beta * ((from + to) / 2 - p->k_ref));
    double n = p->k_n + 1, a = fmax(0, from - p->k_ref), b = fmax(0, to - p->k_ref);
    return p->k_0 / n * (pow(b, n) - pow(a, n));
}

/* k times the difference of temperatures, W m^-1, with the mean of the pair. */
static double transfer(const struct cells *c, double from, double to) {
    double a = conductivity(c->p, from), b = conductivity(c->p, to);
    switch (c->mean) {
    case MEAN_HARMONIC:
        return a > 0 && b > 0 ? (to - from) * 2 / (1 / a + 1 / b) : 0;
    case MEAN_ARITHMETIC:
        return (to - from) * (a + b) / 2;
    default:
        return between(c->p, from, to);
    }
}

/* Flux into cell i, W m^-2, from a wall or air at `value` beyond the resistance 1/b. */
static double frozen_flux(const struct cells *c, int i, double value, double b, double half) {
    return (value - c->T[i]) / (half / c->first[i] + 1 / b);
}

/* Flux into the body, W m^-2, at a Robin face half a spacing from a point at T. */
static double exchange(const struct cells *c, double b, double T_a, double T, double half) {
    enum { HALVINGS = 60 };
    double cold = fmin(T, T_a), hot = fmax(T, T_a);
    for (int i = 0; i < HALVINGS; i++) {
        double wall = cold + (hot - cold) / 2;
        *(between(c->p, T, wall) / half > b * (T_a - wall) ? &hot : &cold) = wall;
    }
    return b * (T_a - cold);
}

/* Adds the flux through the face of cell i at the wall, m^2 of wall per m^3 of cell: 1/d. */
static void add_wall(struct cells *c, int s, int i, double t) {
    const struct problem *p = c->p;
    const int a = s / 2, at[2] = {i % c->g.n[0], i / c->g.n[0]};
    double d = c->g.d[a], x[DIM_MAX] = {0}, in = 0;
    for (int b = 0; b < p->dim; b++) x[b] = c->g.origin[b] + at[b] * c->g.d[b];
    x[a] = s % 2 ? p->hi[a] : p->lo[a];
    double value = p->wall(p, (enum side)s, x, t);
    if (p->side[s] == NEUMANN) {
        in = value;
        c->heating = fmax(c->heating, fabs(in) / (p->hi[a] - p->lo[a]));
    } else {
        c->lo = fmin(c->lo, value), c->hi = fmax(c->hi, value);
        if (c->first)
            in = frozen_flux(c, i, value, p->side[s] == ROBIN ? p->robin[s] : INFINITY, d / 2);
        else
            in = p->side[s] == ROBIN ? exchange(c, p->robin[s], value, c->T[i], d / 2)
                                     : transfer(c, c->T[i], value) / (d / 2);
    }
    c->rate[i] += in / d;
}

static void add_faces(struct cells *c, double t) {
    const struct ftcs_grid *g = &c->g;
    const int across[2] = {1, g->n[0]}; /* from a cell to the next one along the axis */
    for (int i = 0; i < g->n[0] * g->n[1]; i++) {
        const int at[2] = {i % g->n[0], i / g->n[0]};
        for (int a = 0; a < g->dim; a++) {
            int last = at[a] == g->n[a] - 1, next = last ? i - at[a] * across[a] : i + across[a];
            if (at[a] == 0 && c->p->side[2 * a] != PERIODIC) add_wall(c, 2 * a, i, t);
            if (last && c->p->side[2 * a] != PERIODIC) {
                add_wall(c, 2 * a + 1, i, t);
                continue;
            }
            double moved = c->first ? (c->T[next] - c->T[i]) * (c->first[i] + c->first[next]) / 2
                                    : transfer(c, c->T[i], c->T[next]);
            double flux = moved / (g->d[a] * g->d[a]);
            c->rate[i] += flux, c->rate[next] -= flux;
        }
    }
}

static void set_rates(struct cells *c, double t) {
    const struct ftcs_grid *g = &c->g;
    c->most = 0, c->rates++;
    for (int i = 0; i < g->n[0] * g->n[1]; i++) {
        double x[DIM_MAX] = {g->origin[0] + i % g->n[0] * g->d[0], g->origin[1] + i / g->n[0] * g->d[1]};
        double k = c->first ? c->first[i] : conductivity(c->p, c->T[i]);
        c->rate[i] = problem_source(c->p, x, t);
        c->heating = fmax(c->heating, fabs(c->rate[i]));
        if (k > c->most) c->most = k, c->hottest = i;
    }
    add_faces(c, t);
}

/* dt k/rho_c (1/dx^2 + 1/dy^2) for the largest k of the state. */
static double largest_fourier(const struct cells *c) {
    const struct ftcs_grid *g = &c->g;
    return g->dt * c->most / g->rho_c * (1 / (g->d[0] * g->d[0]) + (g->dim == 2) / (g->d[1] * g->d[1]));
}

/* ---- Steps ---- */

enum { LEGENDRE_MOST = 1000001 }; /* stages, whose rounding error is s^2 eps */

/* b_j */
static double legendre_share(int j) {
    return j < 2 ? 1. / 3 : ((double)j * j + j - 2) / (2 * j * (j + 1.0));
}

/* The largest dt k/rho_c (1/dx^2 + 1/dy^2), a quarter of dt times the spectral radius, of s stages. */
static double legendre_reach(int s) {
    return ((double)s * s + s - 2) / 8;
}

/* Smallest odd number of stages for that value: even ones damp the highest modes less. */
static int legendre_stages(double fourier) {
    int s = (int)ceil((sqrt(9 + 32 * fourier) - 1) / 2 - 1e-9) | 1;
    return s < 3 ? 3 : s;
}

/* Refuses at a point outside the data by more than their range and the heat received; a NaN is outside. */
static int check(const struct cells *c, long long step, struct failure *why) {
    const struct ftcs_grid *g = &c->g;
    double slack = c->hi - c->lo + 2 * c->heating * c->p->t_end / g->rho_c + 1e-6 * fabs(c->hi);
    double most = c->stepper == STEPPER_RKL2 ? legendre_reach(LEGENDRE_MOST) : 0.5;
    int i = 0, all = g->n[0] * g->n[1];
    while (i < all && c->T[i] >= c->lo - slack && c->T[i] <= c->hi + slack) i++;
    if (i == all && largest_fourier(c) <= most * (1 + 1e-9)) return STATUS_OK;
    if (i == all) i = c->hottest;
    return refuse(why, STATUS_UNSTABLE,
                  "%s: unstable at step %lld of %lld, t = %g s: T = %g K at (%g, %g) m; dt k/rho_c (1/dx^2 + 1/dy^2) "
                  "is %g for the largest k(T), stable up to %g; use a smaller --dt",
                  g->method, step, g->steps, (double)step * g->dt, c->T[i], g->origin[0] + i % g->n[0] * g->d[0],
                  g->dim == 2 ? g->origin[1] + i / g->n[0] * g->d[1] : 0, largest_fourier(c), most);
}

/* T + by f_0 in c->T, with the start of the step kept. */
static void half_step(struct cells *c, double by) {
    for (int i = 0; i < c->g.n[0] * c->g.n[1]; i++) {
        c->start[i] = c->T[i];
        c->T[i] += by / c->g.rho_c * c->rate[i];
    }
}

static void step_legendre(struct cells *c, double t, int s) {
    const struct ftcs_grid *g = &c->g;
    const int all = g->n[0] * g->n[1];
    const double w = 4 / ((double)s * s + s - 2), dt = g->dt / g->rho_c;
    double time[2] = {w, 0}; /* for U_(j-1) and U_(j-2), in steps */
    for (int i = 0; i < all; i++) {
        c->start[i] = c->T[i], c->before[i] = c->rate[i];
        c->U[0][i] = w * dt * c->rate[i], c->U[1][i] = 0;
    }
    for (int j = 2; j <= s; j++) {
        double b = legendre_share(j - 1), ahead = (2.0 * j - 1) / j, back = (j - 1.0) / j, *newer = c->U[1];
        for (int i = 0; i < all; i++) c->T[i] = c->start[i] + b * c->U[0][i];
        set_rates(c, t + b * time[0] * g->dt);
        for (int i = 0; i < all; i++)
            newer[i] = ahead * (c->U[0][i] + w * dt * (c->rate[i] - (1 - b) * c->before[i]) / b) - back * newer[i];
        c->U[1] = c->U[0], c->U[0] = newer;
        double later = ahead * (time[0] + w) - back * time[1];
        time[1] = time[0], time[0] = later;
    }
    for (int i = 0; i < all; i++) c->T[i] = c->start[i] + legendre_share(s) * c->U[0][i];
}

/* From rates at t in c->rate. */
static void step_once(struct cells *c, double t) {
    const struct ftcs_grid *g = &c->g;
    int stages = c->stepper == STEPPER_RKL2 ? legendre_stages(largest_fourier(c)) : c->stepper == STEPPER_RK2 ? 2 : 1;
    c->stages = stages > c->stages ? stages : c->stages;
    if (c->stepper == STEPPER_RKL2) {
        step_legendre(c, t, stages);
        return;
    }
    if (c->stepper == STEPPER_RK2) {
        half_step(c, g->dt / 2);
        set_rates(c, t + g->dt / 2);
        memcpy(c->T, c->start, (size_t)(g->n[0] * g->n[1]) * sizeof *c->T);
    }
    for (int i = 0; i < g->n[0] * g->n[1]; i++) c->T[i] += g->dt / g->rho_c * c->rate[i];
}

static int run(struct cells *c, struct failure *why) {
    const struct ftcs_grid *g = &c->g;
    for (long long step = 0; step < g->steps; step++) {
        set_rates(c, (double)step * g->dt);
        if (check(c, step, why)) return why->status;
        step_once(c, (double)step * g->dt);
    }
    set_rates(c, c->p->t_end);
    return check(c, g->steps, why);
}

static void take_start(struct cells *c, enum sampling how, struct field *f) {
    const struct ftcs_grid *g = &c->g;
    field_alloc_lattice(f, g->dim, g->n, NULL);
    c->lo = INFINITY, c->hi = -INFINITY;
    for (size_t i = 0; i < f->n; i++) {
        size_t nx = (size_t)g->n[0];
        double x[DIM_MAX] = {g->origin[0] + (double)(i % nx) * g->d[0], g->origin[1] + (double)(i / nx) * g->d[1]};
        for (int a = 0; a < g->dim; a++) f->x[a][a ? i / nx : i % nx] = x[a];
        f->T[i] = ftcs_sample(c->p, x, g->d, how);
        c->lo = fmin(c->lo, f->T[i]), c->hi = fmax(c->hi, f->T[i]);
    }
    f->range[0] = c->lo, f->range[1] = c->hi;
}

static double heat_of(const struct cells *c) {
    const struct ftcs_grid *g = &c->g;
    double sum = 0;
    for (int i = 0; i < g->n[0] * g->n[1]; i++) sum += c->T[i];
    return sum * g->rho_c * g->d[0] * g->d[1];
}

static void report(const struct cells *c, struct field *f) {
    const int dim = c->g.dim;
    f->time = c->p->t_end, f->dt = c->g.dt, f->steps = c->g.steps, f->stages = c->stages;
    f->applications = c->rates - 1; /* the last one is for its range */
    for (int a = 0; a < dim; a++) f->spacing[a] = c->g.d[a];
    f->cost.updates = f->applications * (long long)f->n;
    f->cost.interactions = 2 * dim * f->cost.updates;
    f->cost.work = WORK_SCALAR * ((double)f->cost.interactions + 2 * WORK_FUNCTION * (double)f->cost.updates);
    f->cost.bytes = f->n * (size_t)(dim + 2 + (c->start != NULL) + 3 * (c->before != NULL)) * sizeof(double);
}

int ftcs_nonlinear_solve(const char *method, const struct problem *p, const struct options *o, struct field *out,
                         struct failure *why) {
    double called = field_clock();
    struct cells c = {.p = p, .mean = o->mean, .stepper = o->stepper, .stages = 1};
    struct field f;
    if (ftcs_plan(&c.g, method, 0, p, o, why)) return why->status;
    take_start(&c, o->sampling, &f);
    c.T = f.T;
    c.rate = xcalloc(f.n, sizeof *c.rate);
    if (p->k_frozen) c.first = xcalloc(f.n, sizeof *c.first);
    for (size_t i = 0; i < f.n && c.first; i++) c.first[i] = conductivity(p, f.T[i]);
    if (o->stepper == STEPPER_RK2 || o->stepper == STEPPER_RKL2) c.start = xcalloc(f.n, sizeof *c.start);
    double **const more[] = {&c.before, &c.U[0], &c.U[1]};
    for (int k = 0; k < 3 && o->stepper == STEPPER_RKL2; k++) *more[k] = xcalloc(f.n, sizeof **more[k]);
    f.heat[0] = heat_of(&c);
    double stepping = field_clock();
    int status = run(&c, why);
    f.cost.step_seconds = field_clock() - stepping;
    f.heat[1] = heat_of(&c);
    report(&c, &f);
    double *const owned[] = {c.rate, c.first, c.start, c.before, c.U[0], c.U[1]};
    for (size_t k = 0; k < sizeof owned / sizeof *owned; k++) free(owned[k]);
    f.cost.seconds = field_clock() - called;
    if (status == STATUS_OK) {
        *out = f;
        return STATUS_OK;
    }
    field_free(&f);
    return status;
}
