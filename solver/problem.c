/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quantities that depend on the problem only. */
#include "solver/problem.h"

#include <math.h>
#include <stdio.h>

static double newton_cooling(const struct problem *p, enum side s, double d, double value, double T, double *slope) {
    double b = p->robin[s] * d;
    *slope = -b;
    return b * (value - T);
}

const struct wall_law problem_laws[] = {
    [DIRICHLET] = {.name = "Dirichlet", .word = "dirichlet", .number = 1},
    [NEUMANN] = {.name = "Neumann", .word = "neumann", .number = 2, .is_flux = 1},
    [ROBIN] = {.name = "Robin", .word = "robin", .number = 3, .exchange = newton_cooling},
    [PERIODIC] = {.name = "periodic", .word = "periodic"}};

const struct wall_law *problem_law(const struct problem *p, int side) {
    return &problem_laws[p->side[side]];
}

int problem_has_wall_temperature(const struct problem *p, int side) {
    return problem_law(p, side)->number && !problem_law(p, side)->is_flux;
}

double problem_transfer(const struct problem *p, int side) {
    return p->side[side] == ROBIN ? p->robin[side] : 0;
}

const char *problem_nonlinearity(const struct problem *p) {
    if (p->k_law == K_PHASES) return "a phase melts here";
    if (p->k_law != K_CONSTANT) return "k depends on temperature here";
    for (int s = 0; s < SIDES; s++)
        if (problem_law(p, s)->nonlinear) return "the flux through a wall is not linear in its temperature here";
    return NULL;
}

int problem_has_cross(const struct problem *p) {
    return p->direction || p->cross[0] != 0 || p->cross[1] != 0 || p->cross[2] != 0;
}

void problem_tensor(const struct problem *p, const double *x, double K[DIM_MAX][DIM_MAX]) {
    double along[DIM_MAX] = {0};
    if (p->direction) p->direction(p, x, along);
    for (int a = 0; a < DIM_MAX; a++)
        for (int b = 0; b < DIM_MAX; b++) {
            double constant = a == b ? p->material[0].k[a] : p->cross[problem_pair(a, b)];
            double field = (a == b ? p->k_perp : 0) + (p->k_par - p->k_perp) * along[a] * along[b];
            K[a][b] = !p->direction ? constant : a != b && p->is_diagonal ? 0 : field;
        }
}

double problem_diffusivity(const struct problem *p) {
    double kappa = 0;
    for (int m = 0; m < p->materials; m++)
        for (int a = 0; a < p->dim; a++) kappa = fmax(kappa, p->material[m].k[a] / p->material[m].rho_c);
    return kappa;
}

double problem_start(const struct problem *p, const double *x) {
    (void)x;
    return p->start;
}

double problem_held(const struct problem *p, enum side s, const double *x, double t) {
    (void)x, (void)t;
    return p->held[s];
}

void problem_wall_range(const struct problem *p, enum side s, const double *x, double *lo, double *hi) {
    const int times = p->wall_rate ? 64 : 0;
    for (int k = 0; k <= times; k++) {
        double value = p->wall(p, s, x, k ? p->t_end * k / times : 0);
        *lo = fmin(*lo, value), *hi = fmax(*hi, value);
    }
}

/* A point of side s: the middle of it, or of a round wall the point on the x axis. */
static void wall_middle(const struct problem *p, enum side s, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = p->shape ? 0 : (p->lo[a] + p->hi[a]) / 2;
    x[s / 2] = p->shape ? p->radius[s % 2] : s % 2 ? p->hi[s / 2] : p->lo[s / 2];
}

/* Times apart by the golden section, which no period divides. */
double problem_wall_period(const struct problem *p) {
    enum { TIMES = 200 };
    static const double GOLDEN = 0.61803398874989485;
    double period = INFINITY;
    for (int s = 0; s < 2 * p->dim && p->wall_rate; s++) {
        double x[DIM_MAX], lo = INFINITY, hi = -INFINITY, fastest = 0;
        if (p->side[s] == PERIODIC || (p->shape && s > X_HI)) continue;
        wall_middle(p, (enum side)s, x);
        for (int k = 0; k < TIMES; k++) {
            double t = p->t_end * fmod(GOLDEN * k, 1), value = p->wall(p, (enum side)s, x, t);
            lo = fmin(lo, value), hi = fmax(hi, value);
            fastest = fmax(fastest, fabs(p->wall_rate(p, (enum side)s, x, t)));
        }
        if (fastest > 0) period = fmin(period, M_PI * (hi - lo) / fastest);
    }
    return period;
}

/* A step continues the data by their rate.  With n steps a period they are then off by up to (2 pi/n)^2/2 amplitudes,
 * a fifth for n = 10; with n below 6 by more than the amplitude, and the ghosts of a wall by more than its range. */
const char *problem_wall_pace(const struct problem *p, double dt, char text[PACE_TEXT]) {
    enum { STEPS = 10 };
    double period = problem_wall_period(p);
    *text = '\0';
    if (dt > period / STEPS)
        snprintf(text, PACE_TEXT, ": a wall changes with a period of %.3g s, %.2g steps; %d are needed (--dt %.2g)",
                 period, period / dt, STEPS, period / STEPS);
    return text;
}

static double later_wall(const struct problem *p, enum side s, const double *x, double t) {
    const struct later *l = p->data;
    return l->of->wall(l->of, s, x, l->time + t);
}

static double later_rate(const struct problem *p, enum side s, const double *x, double t) {
    const struct later *l = p->data;
    return l->of->wall_rate(l->of, s, x, l->time + t);
}

static double later_source(const struct problem *p, const double *x) {
    const struct later *l = p->data;
    return problem_source(l->of, x, l->time);
}

void problem_later(const struct problem *p, double time, struct later *l) {
    *l = (struct later){.problem = *p, .of = p, .time = time};
    l->problem.data = l;
    l->problem.wall = later_wall;
    if (p->wall_rate) l->problem.wall_rate = later_rate;
    if (p->source) l->problem.source = later_source;
    l->problem.initial = NULL;
    l->problem.source_rate = NULL;
}

int problem_changes(const struct problem *p) {
    return p->wall_rate || p->source_rate;
}

double problem_source(const struct problem *p, const double *x, double t) {
    if (p->source_at) return p->source_at(p, x, t);
    return (p->source ? p->source(p, x) : 0) + (p->source_rate ? t * p->source_rate(p, x) : 0);
}

const char *problem_place(int dim, const double *x, char text[PLACE_TEXT]) {
    if (dim < 3)
        snprintf(text, PLACE_TEXT, "(%.6g, %.6g) m", x[0], x[1]);
    else
        snprintf(text, PLACE_TEXT, "(%.6g, %.6g, %.6g) m", x[0], x[1], x[2]);
    return text;
}
