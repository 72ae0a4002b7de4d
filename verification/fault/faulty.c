/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The data of a faulty problem.
 *
 * A displaced wall stretches the domain by s along an axis.  With x = c + s (X - c) the equation in X has k/s^2
 * instead of k, and a flux q or a coefficient b at a side across that axis becomes q/s or b/s.  The lattice of the
 * right problem can therefore be used for the faulty one. */
#include "verification/fault/faulty.h"

#include "verification/fault/fault.h"

#include <math.h>

int faulty_side(int corner, int a) {
    int edge = corner - 12, along = edge / 4;
    if (corner < 12) return 2 * a + ((corner < 4 ? corner : corner - 4) >> a & 1);
    return a == along ? -1 : 2 * a + (edge % 4 >> (a - (a > along)) & 1);
}

int faulty_corner(int place, int i) {
    if (place < 24) return i == 0 ? place : -1;
    if (place < 27) return i < 4 ? 12 + 4 * (place - 24) + i : -1;
    if (place == 27) return i < 4 ? i : -1;
    return i < 12 ? 12 + i : -1;
}

enum side faulty_from(const struct faulty *f, int s) {
    return (enum side)(2 * f->from[s / 2] + s % 2);
}

/* The fault of *p; right: position of X of the faulty problem in the coordinates of its data. */
static const struct faulty *faulty_at(const struct problem *p, const double *x, double right[DIM_MAX]) {
    const struct faulty *f = p->data;
    for (int a = 0; a < p->dim; a++) right[f->from[a]] = f->centre[a] + f->stretch[a] * (x[a] - f->centre[a]);
    return f;
}

/* Moves x away from the nearer of the jumps along an axis, which widens the region between two jumps by the size. */
static double narrowed(const struct problem *p, int axis, double x, double size) {
    double middle = 0;
    for (int k = 0; k < p->jumps[axis]; k++) middle += p->jump[axis][k] / p->jumps[axis];
    return fabs(x - middle) <= size ? middle : x - (x > middle ? size : -size);
}

static double initial(const struct problem *p, const double *x) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    for (int a = 0; a < p->dim; a++) {
        at[a] -= f->start[a];
        if (f->width[a] != 0) at[a] = narrowed(f->right, a, at[a], f->width[a]);
    }
    return f->factor * f->initial * f->right->initial(f->right, at) + f->offset;
}

/* Data of a side, or their rate, with factor and offset. */
static double scaled(const struct faulty *f, enum side s, double value, double offset) {
    const enum side_kind kind = f->right->side[faulty_from(f, (int)s)];
    if (kind == NEUMANN) value /= f->stretch[s / 2];
    if (kind == NEUMANN && f->problem.side[s] == ROBIN) value /= f->problem.robin[s]; /* b T_a is the given flux */
    return f->factor * f->wall[s] * value + (kind == NEUMANN ? 0 : offset);
}

/* Position and time at which the faulty problem takes side s. */
static double taken_at(const struct faulty *f, enum side s, double t, double at[DIM_MAX]) {
    for (int a = 0; a < f->right->dim; a++) at[a] += a == (int)s / 2 ? 0 : f->along[a];
    return f->frozen ? 0 : t + f->late[s];
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    const enum side from = faulty_from(f, (int)s);
    if (f->kept == (int)s) return f->right->initial(f->right, at);
    if (f->wall[s] == 0) return scaled(f, s, 0, f->offset);
    t = taken_at(f, s, t, at);
    return scaled(f, s, f->right->wall(f->right, from, at, t), f->offset);
}

static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    if (f->kept == (int)s || f->wall[s] == 0) return 0;
    t = taken_at(f, s, t, at);
    return scaled(f, s, f->right->wall_rate(f->right, faulty_from(f, (int)s), at, t), 0);
}

/* Heat lost in the cell of a corner or the cells of an edge, W m^-3, if its sides at T, or with air at T, are assumed
 * cold: T/(r dx) for each, r being dx/2k of half a cell and 1/b.  It is zero on a side and even about it, so ghosts
 * do not contribute. */
static double lost_at_corner(const struct faulty *f, int corner, const double *x) {
    const struct problem *p = f->right;
    double dx = f->size, lost = 0;
    for (int a = 0; a < p->dim; a++) {
        int s = faulty_side(corner, a);
        double away = s < 0 ? dx / 2 : fabs(x[a] - (s % 2 ? p->hi[a] : p->lo[a]));
        if (away < dx / 4 || away > 3 * dx / 4) return 0;
    }
    for (int a = 0; a < p->dim; a++) {
        int s = faulty_side(corner, a);
        if (s < 0 || (p->side[s] != DIRICHLET && p->side[s] != ROBIN)) continue;
        double resistance = dx / (2 * p->material[0].k[a]) + (p->side[s] == ROBIN ? 1 / p->robin[s] : 0);
        lost += p->wall(p, (enum side)s, x, 0) / (resistance * dx);
    }
    return lost;
}

/* A corner of a box is on several edges, and loses its heat once. */
static double lost_at_corners(const struct faulty *f, const double *x) {
    double lost = 0;
    for (int i = 0; f->corner >= 0 && faulty_corner(f->corner, i) >= 0; i++) {
        double at_one = lost_at_corner(f, faulty_corner(f->corner, i), x);
        if (fabs(at_one) > fabs(lost)) lost = at_one;
    }
    return lost;
}

static double source_at(const struct problem *p, const double *x, double t) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    double value = problem_source(f->right, at, f->source_frozen ? 0 : t + f->source_late);
    return f->factor * f->source * value - lost_at_corners(f, at);
}

static double source(const struct problem *p, const double *x) {
    return source_at(p, x, 0);
}

static double source_rate(const struct problem *p, const double *x) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    return f->factor * f->source * f->right->source_rate(f->right, at);
}

static void direction(const struct problem *p, const double *x, double b[DIM_MAX]) {
    const struct faulty *f = p->data;
    const double other[DIM_MAX] = {p->lo[0] + x[1] - p->lo[1], p->lo[1] + x[0] - p->lo[0], 0};
    f->right->direction(f->right, f->swapped ? other : x, b);
    if (f->opposite) b[1] = 0 - b[1];
    const double x_of = b[0], y_of = b[1], c = cos(f->turn), s = sin(f->turn);
    b[0] = c * x_of - s * y_of, b[1] = s * x_of + c * y_of;
}

int faulty_make(const struct problem *p, struct fault fault, double size, struct faulty *f) {
    if (!fault_applies(p, fault)) return 0;
    *f = (struct faulty){.problem = *p, .right = p, .fault = fault, .size = size, .mean = MEAN_SERIES};
    f->factor = f->source = f->initial = 1;
    f->corner = f->kept = f->left_out = -1;
    for (int a = 0; a < DIM_MAX; a++) {
        f->stretch[a] = 1, f->centre[a] = (p->lo[a] + p->hi[a]) / 2, f->from[a] = a;
        f->problem.mirror[a] = 0;
    }
    for (int s = 0; s < SIDES; s++) f->wall[s] = 1;
    fault_rows[fault.kind].change(f);
    struct problem *q = &f->problem;
    q->data = f;
    q->initial = initial;
    q->wall = wall;
    if (p->direction) q->direction = direction;
    q->wall_rate = p->wall_rate && !f->frozen ? wall_rate : NULL;
    if (p->source || f->corner >= 0) q->source = source;
    q->source_rate = p->source_rate && !f->source_frozen ? source_rate : NULL;
    if (p->source_at) q->source_at = source_at;
    return 1;
}
