/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite differences in a round body: cells on rings and rays,
 *
 *   r_i = r_hole + (i + 1/2) dr,   theta_j = (j + 1/2) dtheta,   dr = dx, dtheta = 2 pi/ceil(2 pi radius/dx)
 *   dT_ij/dt = kappa (r_+ (T_(i+1)j - T_ij) - r_- (T_ij - T_(i-1)j)) / (r_i dr^2)
 *              + kappa (T_i(j+1) - 2 T_ij + T_i(j-1)) / (r_i dtheta)^2 + G / rho_c,     r_+- = r_i +- dr/2
 *
 * and in a ball, with the angle alpha from the axis z in ceil(pi radius/dx) bands, the balance of each cell
 *
 *   volume (r_+^3 - r_-^3)/3 (cos alpha_- - cos alpha_+) dtheta;   faces r_+-^2 (cos alpha_- - cos alpha_+) dtheta,
 *   r dr sin(alpha_+-) dtheta and r dr dalpha;   distances dr, r dalpha and r sin(alpha) dtheta.
 *
 * The scheme is conservative.  r_- = 0 closes the centre, sin(alpha_+-) = 0 the poles: faces without area carry no
 * flux.  A wall is half a spacing outside its last ring and conducts 2 k / dr to it, in series with b if it is
 * cooled; a given flux enters directly.  All three boundary conditions are second order.  The step is explicit along
 * r and implicit along the angles (ftcs_polar_step.c).
 *
 * The values along r are contiguous, so all loops run along r and none is a recursion. */
#include "solver/differences/ftcs_polar.h"

#include "solver/differences/ftcs_grid.h"
#include "solver/differences/ftcs_plan.h"

#include "solver/method.h"
#include "solver/work.h"
#include "solver/problem.h"

#include <math.h>
#include <stdlib.h>

enum { CHECK_EVERY = 32, RINGS_MIN = 4 };

/* ---- Refusals and grid ---- */

static int check_options(const char *method, const struct problem *p, const struct options *o, struct failure *why) {
    double width = p->radius[1] - p->radius[0], rings = width / o->dx, half = M_PI * p->radius[1] / o->dx;
    double points = rings * 2 * half * (p->dim == 3 ? half : 1);
    if (ftcs_plan_check(method, 0, p, o, why)) return why->status;
    if (!(o->dx > 0 && isfinite(o->dx)))
        return refuse(why, STATUS_INPUT, "--dx %g: must be positive and finite", o->dx);
    if (points > 1e9) return refuse(why, STATUS_INPUT, "--dx %g: %.3g grid points, at most 1e9", o->dx, points);
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
    *g = (struct polar){.method = method, .dim = p->dim};
    if (check_options(method, p, o, why)) return why->status;
    const struct material *m = &p->material[0];
    double width = p->radius[1] - p->radius[0];
    g->rings = (int)nearbyint(width / o->dx);
    g->dr = width / g->rings;
    g->rays = (int)ceil(2 * M_PI * p->radius[1] / g->dr);
    g->dtheta = 2 * M_PI / g->rays;
    g->bands = p->dim == 3 ? (int)ceil(M_PI * p->radius[1] / g->dr) : 1;
    g->down = M_PI / g->bands;
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
    return (size_t)g->rings * (size_t)g->bands * (size_t)g->rays;
}

double ftcs_polar_radius(const struct polar *g, int ring) {
    return g->hole + (ring + 0.5) * g->dr;
}

/* The point of a line at radius r, m. */
static void point(const struct polar *g, int line, double r, double x[DIM_MAX]) {
    double theta = (line / g->bands + 0.5) * g->dtheta, alpha = (line % g->bands + 0.5) * g->down;
    double apart = g->dim == 3 ? r * sin(alpha) : r; /* from the axis */
    x[0] = apart * cos(theta), x[1] = apart * sin(theta), x[2] = g->dim == 3 ? r * cos(alpha) : 0;
}

double ftcs_polar_face(const struct polar *g, double r) {
    return g->dim == 3 ? r * r : r;
}

double ftcs_polar_wedge(const struct polar *g, int ring) {
    double r = ftcs_polar_radius(g, ring);
    return (g->dim == 3 ? r * r + g->dr * g->dr / 12 : r) * g->dr;
}

/* m^dim */
static double volume(const struct polar *g, int ring, int line) {
    double alpha = (line % g->bands + 0.5) * g->down, high = g->dim == 3 ? 2 * sin(alpha) * sin(g->down / 2) : 1;
    return ftcs_polar_wedge(g, ring) * g->dtheta * high;
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
    double r = s == X_HI ? g->hole + width : g->hole,
           share = ftcs_polar_face(g, r) / (ftcs_polar_wedge(g, ring) * g->rho_c);
    (s == X_HI ? g->out : g->in)[ring] = share * wall_conducts(g, p, s);
    for (int j = 0; j < g->rays * g->bands; j++) {
        double x[DIM_MAX];
        point(g, j, r, x);
        double value = p->wall(p, s, x, 0);
        if (p->side[s] == NEUMANN) {
            g->heating[(ptrdiff_t)j * g->rings + ring] += share * value;
            most = fmax(most, fabs(value));
        } else {
            g->beside[s == X_HI][j] = value;
            *lowest = fmin(*lowest, value), *highest = fmax(*highest, value);
        }
    }
    return most * (width / k + p->t_end / (g->rho_c * width));
}

enum { BY_SHEET = 4 };

static void reserve(struct polar *g) {
    size_t rings = (size_t)g->rings, lines = (size_t)g->rays * (size_t)g->bands, sheet = rings * (size_t)g->bands;
    double **disc[BY_SHEET] = {&g->z, &g->scale, &g->sum, &g->row};
    double **ball[BY_SHEET] = {&g->lower, &g->upper, &g->around, &g->row};
    for (int k = 0; k < BY_SHEET; k++) *(g->dim == 2 ? disc : ball)[k] = xcalloc(sheet, sizeof(double));
    g->in = xcalloc(rings, sizeof(double));
    g->out = xcalloc(rings, sizeof(double));
    for (int k = 0; k < 2; k++) g->beside[k] = xcalloc(lines, sizeof(double));
    g->heating = xcalloc(cells(g), sizeof(double));
    g->T = xcalloc(cells(g), sizeof(double));
    if (g->dim == 3) g->modes = ftcs_polar_step_modes(g);
}

static void polar_free(struct polar *g) {
    double *all[] = {g->in,  g->out, g->lower,     g->upper,     g->around,  g->z, g->scale,
                     g->row, g->sum, g->beside[0], g->beside[1], g->heating, g->T};
    ftcs_polar_step_modes_free(g->modes);
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) free(all[k]);
}

/* Initial data and source, and the range of a stable run: that of the data and the possible effect of source
 * and fluxes, widened by half of it. */
static void fill(struct polar *g, const struct problem *p) {
    double source = 0;
    g->lowest = INFINITY, g->highest = -INFINITY;
    ftcs_polar_step_factors(g);
    for (int j = 0; j < g->rays * g->bands; j++)
        for (int i = 0; i < g->rings; i++) {
            double x[DIM_MAX];
            point(g, j, ftcs_polar_radius(g, i), x);
            double T = p->initial(p, x), G = p->source ? p->source(p, x) : 0;
            g->T[(ptrdiff_t)j * g->rings + i] = T;
            g->heating[(ptrdiff_t)j * g->rings + i] = G / g->rho_c;
            g->lowest = fmin(g->lowest, T), g->highest = fmax(g->highest, T);
            source = fmax(source, fabs(G));
        }
    double lowest = g->lowest, highest = g->highest, more = source * p->t_end / g->rho_c;
    if (g->hole > 0) more += wall_make(g, p, X_LO, &lowest, &highest);
    more += wall_make(g, p, X_HI, &lowest, &highest);
    g->middle = (lowest + highest) / 2;
    g->reach = fmax(highest - lowest + more, 1e-6 * fabs(g->middle));
}

static int check_stable(const struct polar *g, long long step, struct failure *why) {
    for (size_t k = 0; k < cells(g); k++) {
        if (fabs(g->T[k] - g->middle) <= g->reach) continue; /* false for NaN */
        double x[DIM_MAX];
        char text[PLACE_TEXT];
        point(g, (int)(k / (size_t)g->rings), ftcs_polar_radius(g, (int)(k % (size_t)g->rings)), x);
        return refuse(
            why, STATUS_UNSTABLE,
            "%s: unstable at step %lld of %lld, t = %g s: T = %g K at %s; kappa dt/dr^2 is %g, stable up to "
            "%g",
            g->method, step, g->steps, (double)step * g->dt, g->T[k], problem_place(g->dim, x, text),
            g->kappa * g->dt / (g->dr * g->dr), g->dim == 3 ? 0.47 : 0.5);
    }
    return STATUS_OK;
}

/* ---- A run ---- */

static double heat(const struct polar *g) {
    long double sum = 0;
    for (int j = 0; j < g->rays * g->bands; j++)
        for (int i = 0; i < g->rings; i++) sum += volume(g, i, j) * g->rho_c * g->T[(ptrdiff_t)j * g->rings + i];
    return (double)sum;
}

static int run(struct polar *g, struct failure *why) {
    for (long long k = 1; k <= g->steps; k++) {
        ftcs_polar_step(g);
        if (k % CHECK_EVERY && k != g->steps) continue;
        int status = check_stable(g, k, why);
        if (status) return status;
    }
    return STATUS_OK;
}

static size_t held(const struct polar *g) {
    size_t rings = (size_t)g->rings, bands = (size_t)g->bands;
    return (2 * cells(g) + (2 + BY_SHEET * bands) * rings + 2 * (size_t)g->rays * bands) * sizeof(double);
}

/* Two neighbours per axis and cell; each step makes one pass along r and two sweeps around;
 * in a ball two transforms and a solution along the bands. */
static void count(const struct polar *g, struct field *f) {
    f->dim = g->dim, f->n = cells(g);
    f->dt = g->dt, f->steps = g->steps, f->stages = 1;
    f->cost.updates = g->steps * (long long)f->n;
    f->cost.interactions = 2 * g->dim * f->cost.updates;
    f->cost.bytes = held(g);
    f->cost.work = WORK_SCALAR * (double)f->n * (WORK_PLACE + WORK_SAMPLE + 2 * WORK_FUNCTION);
    f->cost.work += 2 * (double)f->cost.interactions;
}

static void hand_over(struct polar *g, struct field *f) {
    field_alloc(f, g->dim, cells(g));
    f->weight = xcalloc(f->n, sizeof *f->weight);
    for (size_t k = 0; k < f->n; k++) {
        int ring = (int)(k % (size_t)g->rings), line = (int)(k / (size_t)g->rings);
        double x[DIM_MAX];
        point(g, line, ftcs_polar_radius(g, ring), x);
        field_put(f, k, x);
        f->T[k] = g->T[k], f->weight[k] = volume(g, ring, line);
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
        for (int a = 0; a < p->dim; a++) f->spacing[a] = g.dr;
        f->time = p->t_end;
        f->heat[0] = before, f->heat[1] = heat(&g);
        f->range[0] = g.lowest, f->range[1] = g.highest;
        f->cost.step_seconds = stepped - stepping;
        f->cost.seconds = field_clock() - called;
    }
    polar_free(&g);
    return status;
}
