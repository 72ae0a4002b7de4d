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

const struct wall_law problem_laws[] = {[DIRICHLET] = {.name = "Dirichlet"},
                                        [NEUMANN] = {.name = "Neumann", .is_flux = 1},
                                        [ROBIN] = {.name = "Robin", .exchange = newton_cooling},
                                        [PERIODIC] = {.name = "periodic"}};

const struct wall_law *problem_law(const struct problem *p, int side) {
    return &problem_laws[p->side[side]];
}

double problem_transfer(const struct problem *p, int side) {
    return p->side[side] == ROBIN ? p->robin[side] : 0;
}

const char *problem_nonlinearity(const struct problem *p) {
    if (p->k_law != K_CONSTANT) return "k depends on temperature here";
    for (int s = 0; s < SIDES; s++)
        if (problem_law(p, s)->nonlinear) return "the flux through a wall is not linear in its temperature here";
    return NULL;
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
