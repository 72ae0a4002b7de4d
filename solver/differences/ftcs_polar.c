/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite differences in a round body: cells on rings and rays,
 *
 *   r_i = r_hole + (i + 1/2) dr,   theta_j = (j + 1/2) dtheta,   dr = dx, dtheta = 2 pi/ceil(2 pi radius/dx)
 *   dT_ij/dt = kappa (r_+ (T_(i+1)j - T_ij) - r_- (T_ij - T_(i-1)j)) / (r_i dr^2)
 *              + kappa (T_i(j+1) - 2 T_ij + T_i(j-1)) / (r_i dtheta)^2 + G / rho_c,     r_+- = r_i +- dr/2
 *
 * The scheme is conservative, and r_- = 0 closes the centre of a disc.  A wall is half a spacing outside its last
 * ring and conducts 2 k / dr to it, in series with b if it is cooled; a given flux enters directly.  All three
 * boundary conditions are second order.
 *
 * Cells at the centre are dx^2 / (2 radius) wide.  The stable step of an explicit method would scale with their
 * square, dx^4, so each step is explicit along r and implicit along theta,
 *
 *   (1 - a_i delta_theta^2) T_new = T + dt (the part along r + G / rho_c),   a_i = kappa dt / (r_i dtheta)^2
 *
 * and first order in dt.  In the norm weighted by the areas of the cells the explicit part is symmetric and below 4
 * kappa / dr^2, and the inverse of the implicit part is at most 1: stable up to kappa dt / dr^2 = 1/2.  On a ring
 * the inverse is (1 - z)^2 / ((1 - z E)(1 - z / E)), where E is the shift by one ray and z + 1/z = 2 + 1/a: one
 * sweep around the ring in each direction.
 *
 * The values along r are contiguous, so all loops run along r and none is a recursion. */
#include "solver/differences/ftcs_grid.h"
#include "solver/differences/ftcs_plan.h"

#include "solver/method.h"
#include "solver/work.h"
#include "solver/problem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CHECK_EVERY = 32, RINGS_MIN = 4 };

struct polar {
    const char *method;
    int rings, rays;
    double dr, dtheta, hole; /* m; rad; m, radius of the hole */
    double dt;               /* s */
    long long steps;
    double rho_c, kappa;    /* J m^-3 K^-1; m^2 s^-1 */
    double *in, *out;       /* s^-1, by ring: conductance to the inner and outer ring or wall */
    double *z, *scale;      /* by ring: the root z; (1 - z)^2 */
    double *beside[2];      /* K, by ray: temperature beyond the wall of the hole and beyond the outer wall */
    double *heating;        /* K s^-1, by cell: source and given flux */
    double *T;              /* K, rings x rays, rings fastest */
    double *row, *sum;      /* K, by ring: values on the current ray; initial values of the next sweep */
    double lowest, highest; /* K, of the initial data */
    double middle, reach;   /* K: a stable solution stays within middle +- reach */
};

/* ---- Refusals and grid ---- */

static int check_options(const char *method, const struct problem *p, const struct options *o, struct failure *why) {
    double width = p->radius[1] - p->radius[0], rings = width / o->dx;
    if (ftcs_plan_check(method, 0, p, o, why)) return why->status;
    if (!(o->dx > 0 && isfinite(o->dx)))
        return refuse(why, STATUS_INPUT, "--dx %g: must be positive and finite", o->dx);
    if (rings * 2 * M_PI * p->radius[1] / o->dx > 1e9)
        return refuse(why, STATUS_INPUT, "--dx %g: %.3g grid points, at most 1e9", o->dx,
                      rings * 2 * M_PI * p->radius[1] / o->dx);
    if (fabs(rings - nearbyint(rings)) > 1e-6 * rings || nearbyint(rings) < RINGS_MIN) {
        double below = fmax(floor(rings), RINGS_MIN);
        return refuse(why, STATUS_INPUT,
                      "--dx %.10g: does not divide the %g m from %s into whole rings, %d or more; nearest: %.10g and "
                      "%.10g",
                      o->dx, width, p->radius[0] > 0 ? "wall to wall" : "the middle to the wall", RINGS_MIN,
                      width / below, width / (below + 1));
    }
    return STATUS_OK;
}

static int plan(struct polar *g, const char *method, const struct problem *p, const struct options *o,
                struct failure *why) {
    *g = (struct polar){.method = method};
    if (check_options(method, p, o, why)) return why->status;
    const struct material *m = &p->material[0];
    double width = p->radius[1] - p->radius[0];
    g->rings = (int)nearbyint(width / o->dx);
    g->dr = width / g->rings;
    g->rays = (int)ceil(2 * M_PI * p->radius[1] / g->dr);
    g->dtheta = 2 * M_PI / g->rays;
    g->hole = p->radius[0];
    g->rho_c = m->rho_c;
    g->kappa = m->k[0] / m->rho_c;
    double dt = o->dt != 0 ? o->dt : (o->fourier != 0 ? o->fourier : 0.1) * g->dr * g->dr / g->kappa;
    double count = p->t_end > 0 ? fmax(1, ceil(p->t_end / dt - 1e-9)) : 0;
    if (!(count <= 1e12)) return refuse(why, STATUS_INPUT, "%s: %g time steps, at most 1e12", method, count);
    g->steps = (long long)count;
    g->dt = count > 0 ? p->t_end / count : 0;
    return STATUS_OK;
}

static size_t cells(const struct polar *g) {
    return (size_t)g->rings * (size_t)g->rays;
}

static double radius(const struct polar *g, int ring) {
    return g->hole + (ring + 0.5) * g->dr;
}

static void place(const struct polar *g, int ring, int ray, double x[2]) {
    double r = radius(g, ring), theta = (ray + 0.5) * g->dtheta;
    x[0] = r * cos(theta), x[1] = r * sin(theta);
}

/* m^2 */
static double area(const struct polar *g, int ring) {
    return radius(g, ring) * g->dr * g->dtheta;
}

/* ---- The arrays ---- */

/* W m^-2 K^-1, from the last ring through the wall. */
static double wall_conducts(const struct polar *g, const struct problem *p, enum side s) {
    double k = p->material[0].k[0], half = g->dr / 2;
    if (p->side[s] == NEUMANN) return 0;
    return p->side[s] == ROBIN ? 1 / (1 / p->robin[s] + half / k) : k / half;
}

/* Sets conductance, temperature and flux of a wall.  Widens the range of the wall temperatures, K, and returns the
 * possible effect of a given flux, K. */
static double wall_make(struct polar *g, const struct problem *p, enum side s, double *lowest, double *highest) {
    const int ring = s == X_HI ? g->rings - 1 : 0;
    double width = g->rings * g->dr, k = p->material[0].k[0], most = 0;
    double r = s == X_HI ? g->hole + width : g->hole, share = r / (radius(g, ring) * g->dr * g->rho_c);
    (s == X_HI ? g->out : g->in)[ring] = share * wall_conducts(g, p, s);
    for (int j = 0; j < g->rays; j++) {
        double theta = (j + 0.5) * g->dtheta, x[2] = {r * cos(theta), r * sin(theta)}, value = p->wall(p, s, x, 0);
        if (p->side[s] == NEUMANN) {
            g->heating[j * g->rings + ring] += share * value;
            most = fmax(most, fabs(value));
        } else {
            g->beside[s == X_HI][j] = value;
            *lowest = fmin(*lowest, value), *highest = fmax(*highest, value);
        }
    }
    return most * (width / k + p->t_end / (g->rho_c * width));
}

static void reserve(struct polar *g) {
    size_t rings = (size_t)g->rings, rays = (size_t)g->rays;
    double **by_ring[] = {&g->in, &g->out, &g->z, &g->scale, &g->row, &g->sum};
    for (size_t k = 0; k < sizeof by_ring / sizeof *by_ring; k++) *by_ring[k] = xcalloc(rings, sizeof(double));
    for (int k = 0; k < 2; k++) g->beside[k] = xcalloc(rays, sizeof(double));
    g->heating = xcalloc(cells(g), sizeof(double));
    g->T = xcalloc(cells(g), sizeof(double));
}

static void polar_free(struct polar *g) {
    double *all[] = {g->in, g->out, g->z, g->scale, g->row, g->sum, g->beside[0], g->beside[1], g->heating, g->T};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) free(all[k]);
}

/* Coefficients of each ring. */
static void rings_make(struct polar *g) {
    for (int i = 0; i < g->rings; i++) {
        double r = radius(g, i), rate = g->kappa / (r * g->dr * g->dr);
        double a = g->kappa * g->dt / (r * r * g->dtheta * g->dtheta), root = sqrt(1 + 4 * a);
        double rest = (1 + root) / (1 + 2 * a + root); /* 1 - z */
        g->in[i] = i > 0 ? rate * (r - g->dr / 2) : 0;
        g->out[i] = i < g->rings - 1 ? rate * (r + g->dr / 2) : 0;
        g->z[i] = 2 * a / (1 + 2 * a + root);
        g->scale[i] = rest * rest;
    }
}

/* Initial data and source, and the range of a stable run: that of the data and the possible effect of source
 * and fluxes, widened by half of it. */
static void fill(struct polar *g, const struct problem *p) {
    double source = 0;
    g->lowest = INFINITY, g->highest = -INFINITY;
    rings_make(g);
    for (int j = 0; j < g->rays; j++)
        for (int i = 0; i < g->rings; i++) {
            double x[2];
            place(g, i, j, x);
            double T = p->initial(p, x), G = p->source ? p->source(p, x) : 0;
            g->T[j * g->rings + i] = T;
            g->heating[j * g->rings + i] = G / g->rho_c;
            g->lowest = fmin(g->lowest, T), g->highest = fmax(g->highest, T);
            source = fmax(source, fabs(G));
        }
    double lowest = g->lowest, highest = g->highest, more = source * p->t_end / g->rho_c;
    if (g->hole > 0) more += wall_make(g, p, X_LO, &lowest, &highest);
    more += wall_make(g, p, X_HI, &lowest, &highest);
    g->middle = (lowest + highest) / 2;
    g->reach = fmax(highest - lowest + more, 1e-6 * fabs(g->middle));
}

/* ---- One step ---- */

/* T + dt (the part along r + heating), in place; the sums that start the sweep around the ring go to `sum`. */
static void step_along(struct polar *g) {
    const int n = g->rings;
    const double dt = g->dt, *in = g->in, *out = g->out, *z = g->z;
    double *restrict row = g->row, *restrict sum = g->sum;
    memset(sum, 0, (size_t)n * sizeof *sum);
    for (ptrdiff_t j = 0; j < g->rays; j++) {
        double *T = g->T + j * n;
        const double *heating = g->heating + j * n;
        row[0] = T[0] + dt * (out[0] * (T[1] - T[0]) - in[0] * (T[0] - g->beside[0][j]) + heating[0]);
        for (int i = 1; i < n - 1; i++)
            row[i] = T[i] + dt * (out[i] * (T[i + 1] - T[i]) - in[i] * (T[i] - T[i - 1]) + heating[i]);
        row[n - 1] = T[n - 1] + dt * (out[n - 1] * (g->beside[1][j] - T[n - 1]) - in[n - 1] * (T[n - 1] - T[n - 2]) +
                                      heating[n - 1]);
        memcpy(T, row, (size_t)n * sizeof *T);
        for (int i = 0; i < n; i++) sum[i] = row[i] + z[i] * sum[i];
    }
}

/* The filter 1 / (1 - z E) around each ring, along the rays or backwards; after the first, the sums for the way
 * back.  `sum` over all rays, weighted by powers of z, is the value before the first ray times 1 - z^rays. */
static void sweep_around(struct polar *g, int backwards) {
    const int n = g->rings;
    const double *z = g->z;
    double *restrict before = g->row, *restrict sum = g->sum;
    for (int i = 0; i < n; i++) {
        before[i] = g->sum[i] / -expm1(g->rays * log(z[i]));
        sum[i] = 0;
    }
    for (ptrdiff_t k = 0; k < g->rays; k++) {
        double *restrict T = g->T + (backwards ? g->rays - 1 - k : k) * n;
        for (int i = 0; i < n; i++) before[i] = T[i] = T[i] + z[i] * before[i];
    }
    if (backwards) return;
    for (ptrdiff_t j = g->rays - 1; j >= 0; j--) {
        const double *T = g->T + j * n;
        for (int i = 0; i < n; i++) sum[i] = T[i] + z[i] * sum[i];
    }
}

static void step(struct polar *g) {
    step_along(g);
    sweep_around(g, 0);
    sweep_around(g, 1);
    for (ptrdiff_t j = 0; j < g->rays; j++)
        for (int i = 0; i < g->rings; i++) g->T[j * g->rings + i] *= g->scale[i];
}

static int check_stable(const struct polar *g, long long step, struct failure *why) {
    for (size_t k = 0; k < cells(g); k++) {
        if (fabs(g->T[k] - g->middle) <= g->reach) continue; /* false for NaN */
        double x[2];
        place(g, (int)(k % (size_t)g->rings), (int)(k / (size_t)g->rings), x);
        return refuse(why, STATUS_UNSTABLE,
                      "%s: unstable at step %lld of %lld, t = %g s: T = %g K at x = %g m, y = %g m; kappa dt/dr^2 is "
                      "%g, stable up to 0.5",
                      g->method, step, g->steps, (double)step * g->dt, g->T[k], x[0], x[1],
                      g->kappa * g->dt / (g->dr * g->dr));
    }
    return STATUS_OK;
}

/* ---- A run ---- */

static double heat(const struct polar *g) {
    long double sum = 0;
    for (int j = 0; j < g->rays; j++)
        for (int i = 0; i < g->rings; i++) sum += area(g, i) * g->rho_c * g->T[(ptrdiff_t)j * g->rings + i];
    return (double)sum;
}

static int run(struct polar *g, struct failure *why) {
    for (long long k = 1; k <= g->steps; k++) {
        step(g);
        if (k % CHECK_EVERY && k != g->steps) continue;
        int status = check_stable(g, k, why);
        if (status) return status;
    }
    return STATUS_OK;
}

static size_t held(const struct polar *g) {
    return (2 * cells(g) + 6 * (size_t)g->rings + 2 * (size_t)g->rays) * sizeof(double);
}

/* Four neighbours per cell; each step makes one pass along r and two sweeps around. */
static void count(const struct polar *g, struct field *f) {
    f->dim = 2, f->n = cells(g);
    f->dt = g->dt, f->steps = g->steps, f->stages = 1;
    f->cost.updates = g->steps * (long long)f->n;
    f->cost.interactions = 4 * f->cost.updates;
    f->cost.bytes = held(g);
    f->cost.work = WORK_SCALAR * (double)f->n * (WORK_PLACE + WORK_SAMPLE + 2 * WORK_FUNCTION);
    f->cost.work += 2 * (double)f->cost.interactions;
}

static void hand_over(struct polar *g, struct field *f) {
    field_alloc(f, 2, cells(g));
    f->weight = xcalloc(f->n, sizeof *f->weight);
    for (size_t k = 0; k < f->n; k++) {
        int ring = (int)(k % (size_t)g->rings);
        double x[2];
        place(g, ring, (int)(k / (size_t)g->rings), x);
        f->x[k] = x[0], f->y[k] = x[1], f->T[k] = g->T[k], f->weight[k] = area(g, ring);
    }
    count(g, f);
}

int ftcs_polar_solve(const char *method, const struct problem *p, const struct options *o, struct field *f,
                     struct failure *why) {
    struct polar g;
    double called = field_clock();
    if (plan(&g, method, p, o, why)) return why->status;
    reserve(&g);
    fill(&g, p);
    double before = heat(&g), stepping = field_clock();
    int status = run(&g, why);
    double stepped = field_clock();
    if (status == STATUS_OK) {
        hand_over(&g, f);
        f->spacing[0] = f->spacing[1] = g.dr;
        f->time = p->t_end;
        f->heat[0] = before, f->heat[1] = heat(&g);
        f->range[0] = g.lowest, f->range[1] = g.highest;
        f->cost.step_seconds = stepped - stepping;
        f->cost.seconds = field_clock() - called;
    }
    polar_free(&g);
    return status;
}
