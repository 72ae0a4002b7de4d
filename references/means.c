/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Averages of initial data over cells, weighted with the heat capacity of each material.
 *
 * The cubature is broken at jumps, at an interface, and graded towards a kink.  In a cell that a round wall cuts, the
 * average is along lines in y that end at the wall.  The length of these lines has a kink at the point at which the
 * wall leaves the cell, and a singular slope at a wall parallel to y.  In a ball the lines are along z, at Gauss
 * points of x and y: the same kinks cost some 1e-3 of the variation in the cell. */
#include "references/means.h"

#include "references/cubature.h"
#include "references/mapping.h"
#include "solver/shape.h"

#include <gsl/gsl_integration.h>
#include <math.h>

/* The line at x[0] of a cell cut by a round wall; its integral or its length. */
struct line {
    const struct problem *p;
    double lo, hi, x; /* m */
    int length;       /* 1: length only */
};

static struct approx initial_on_line(const void *data, const double *y) {
    const struct line *l = data;
    return (struct approx){l->p->initial(l->p, (const double[2]){l->x, y[0]}), 0};
}

static struct approx along_line(const void *data, const double *x) {
    struct line l = *(const struct line *)data;
    double piece[2][2];
    struct approx sum = {0, 0};
    l.x = x[0];
    for (int k = 0, n = shape_pieces(l.p, x[0], l.lo, l.hi, piece); k < n; k++) {
        struct cubature_knots none = {.count = {0, 0}};
        double from[2] = {piece[k][0], 0}, to[2] = {piece[k][1], 0}, length = to[0] - from[0];
        struct approx mean =
            l.length ? (struct approx){1, 0} : cubature_mean(initial_on_line, &l, 1, from, to, &none);
        sum.value += length * mean.value, sum.error += length * mean.error;
    }
    return sum;
}

static double ball_mean(const struct problem *p, const double *lo, const double *hi) {
    enum { POINTS = 10 };
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(POINTS);
    double sum = 0, volume = 0, at[2][POINTS], weight[2][POINTS];
    for (int a = 0; a < 2; a++)
        for (size_t i = 0; i < POINTS; i++)
            gsl_integration_glfixed_point(lo[a], hi[a], i, &at[a][i], &weight[a][i], rule);
    for (int k = 0; k < POINTS * POINTS; k++) {
        double x[DIM_MAX] = {at[0][k % POINTS], at[1][k / POINTS], 0}, w;
        double half = sqrt(fmax(0, p->radius[1] * p->radius[1] - x[0] * x[0] - x[1] * x[1]));
        double from = fmax(lo[2], -half), to = fmin(hi[2], half);
        for (size_t i = 0; i < POINTS && to > from; i++) {
            gsl_integration_glfixed_point(from, to, i, &x[2], &w, rule);
            w *= weight[0][k % POINTS] * weight[1][k / POINTS];
            sum += w * p->initial(p, x), volume += w;
        }
    }
    gsl_integration_glfixed_table_free(rule);
    return volume > 0 ? sum / volume
                      : p->initial(p, (double[]){(lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2});
}

static double clipped(const struct problem *p, const double *lo, const double *hi) {
    if (p->dim == 3) return ball_mean(p, lo, hi);
    struct cubature_knots knots = {.count = {0, 0}};
    struct line l = {p, lo[1], hi[1], 0, 0};
    int n = 0;
    for (int s = X_LO; s <= X_HI; s++) {
        double R = p->radius[s],
               place[] = {-R, R, sqrt(fmax(0, R * R - lo[1] * lo[1])), sqrt(fmax(0, R * R - hi[1] * hi[1]))};
        if (!shape_has_wall(p, s)) continue;
        for (int k = 0; k < 6 && n < CUBATURE_KNOTS; k++) {
            double at = k < 4 ? place[k] : -place[k - 2];
            if (!(at >= lo[0] && at <= hi[0])) continue;
            knots.knot[0][n].at = at;
            knots.knot[0][n++].graded = 1;
        }
    }
    knots.count[0] = n;
    double sum = cubature_mean(along_line, &l, 1, lo, hi, &knots).value;
    l.length = 1;
    return sum / cubature_mean(along_line, &l, 1, lo, hi, &knots).value;
}

static struct approx initial_at(const void *data, const double *x) {
    const struct problem *p = data;
    return (struct approx){p->initial(p, x), 0};
}

static void add_graded(struct cubature_knots *knots, int axis, double at) {
    int k = knots->count[axis]++;
    knots->knot[axis][k].at = at;
    knots->knot[axis][k].graded = 1;
}

/* Average over the part of the body from lo to hi.  The data of a scene may have a kink at an interface, and on a rod
 * or in the plane a peak in the middle. */
static double mean(const struct problem *p, int interface_axis, const double *lo, const double *hi) {
    struct cubature_knots knots = {.grades = 0};
    double volume = (hi[0] - lo[0]) * (hi[1] - lo[1]) * (p->dim == 3 ? hi[2] - lo[2] : 1);
    double part = p->shape ? shape_clipped(p, lo, hi) / volume : 1;
    if (part < 1 - 1e-9 && part > 1e-12) return clipped(p, lo, hi);
    for (int a = 0; a < p->dim; a++) {
        for (int j = 0; j < p->jumps[a]; j++) knots.knot[a][knots.count[a]++].at = p->jump[a][j];
        if (p->dim < 3) add_graded(&knots, a, (p->lo[a] + p->hi[a]) / 2);
        if (p->kinked[a]) add_graded(&knots, a, p->kink[a]);
        if (p->materials == 2 && a == interface_axis) knots.knot[a][knots.count[a]++].at = p->interface;
    }
    return cubature_mean(initial_at, p, p->dim, lo, hi, &knots).value;
}

double means_initial(const struct image *image, const double *lo, const double *hi) {
    const struct problem *p = &image->problem;
    const int a = image->interface_axis;
    double below[DIM_MAX], above[DIM_MAX], heat[2];
    if (p->materials < 2 || !(lo[a] < p->interface && p->interface < hi[a])) return mean(p, a, lo, hi);
    for (int d = 0; d < DIM_MAX; d++)
        below[d] = d == a ? p->interface : hi[d], above[d] = d == a ? p->interface : lo[d];
    heat[0] = (p->interface - lo[a]) * p->material[0].rho_c;
    heat[1] = (hi[a] - p->interface) * p->material[1].rho_c;
    return (mean(p, a, lo, below) * heat[0] + mean(p, a, above, hi) * heat[1]) / (heat[0] + heat[1]);
}
