/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Faults as changes of a problem.
 *
 * A displaced wall stretches the domain by s along an axis.  With x = c + s (X - c) the equation in X has k/s^2
 * instead of k, and a flux q or a coefficient b at a side across that axis becomes q/s or b/s.  The lattice of the
 * correct problem can therefore be used for the faulty one. */
#include "verification/fault/fault.h"

#include "references/kirchhoff.h"

#include <math.h>
#include <string.h>

/* The axis that a pair of exchanged axes puts in the place of axis a. */
static int exchanged(int pair, int a) {
    int first = fault_pair(pair, 0), second = fault_pair(pair, 1);
    return a == first ? second : a == second ? first : a;
}

static enum side exchanged_side(int pair, int s) {
    return (enum side)(2 * exchanged(pair, s / 2) + s % 2);
}

/* The fault of *p; right: position of X of the faulty problem in the coordinates of its data. */
static const struct faulty *faulty_at(const struct problem *p, const double *x, double right[DIM_MAX]) {
    const struct faulty *f = p->data;
    for (int a = 0; a < p->dim; a++) {
        int from = f->fault.kind == FAULT_TRANSPOSED ? exchanged(f->fault.axis, a) : a;
        right[from] = f->centre[a] + f->stretch[a] * (x[a] - f->centre[a]);
    }
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
    if (f->fault.kind == FAULT_START_SHIFT) at[f->fault.axis] -= f->size;
    if (f->fault.kind == FAULT_START_WIDTH || f->fault.kind == FAULT_SAMPLES)
        at[f->fault.axis] = narrowed(f->right, f->fault.axis, at[f->fault.axis], f->size);
    double T = f->right->initial(f->right, at);
    if (f->fault.kind == FAULT_OFFSET) return T + f->size;
    return f->fault.kind == FAULT_AMPLITUDE ? (1 + f->size) * T : T;
}

/* The data of side s of the faulty problem from those of the correct one, `value`, or from their rate. */
static double wall_value(const struct faulty *f, enum side s, double value, int is_rate) {
    if (f->right->side[s] == NEUMANN) value /= f->stretch[s / 2];
    int is_flux = f->right->side[s] == NEUMANN && f->fault.axis == FAULT_ALL_SIDES;
    if (f->fault.kind == FAULT_AMPLITUDE || (f->fault.kind == FAULT_WALL && (f->fault.axis == (int)s || is_flux)))
        value *= 1 + f->size;
    return f->fault.kind == FAULT_OFFSET && f->right->side[s] != NEUMANN && !is_rate ? value + f->size : value;
}

/* Middle between the lowest and the highest of 17 values of side s at x during the run. */
static double middle_of_range(const struct problem *p, enum side s, const double *x) {
    enum { TIMES = 17 };
    double lo = INFINITY, hi = -INFINITY;
    for (int i = 0; i < TIMES; i++) {
        double value = p->wall(p, s, x, p->t_end * i / (TIMES - 1));
        lo = fmin(lo, value), hi = fmax(hi, value);
    }
    return (lo + hi) / 2;
}

/* The time at which the faulty problem takes side s. */
static double wall_time(const struct faulty *f, enum side s, double t) {
    if (f->fault.kind == FAULT_WALL_FROZEN) return 0;
    int of_side = f->fault.axis == 0 || f->fault.axis == 1 + (int)s;
    return f->fault.kind == FAULT_WALL_TIME && of_side ? t + f->size : t;
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    if (f->fault.kind == FAULT_TRANSPOSED)
        return f->right->wall(f->right, exchanged_side(f->fault.axis, (int)s), at, t);
    double value = f->right->wall(f->right, s, at, wall_time(f, s, t));
    if (f->fault.kind == FAULT_WALL_SWING) value += f->size * (value - middle_of_range(f->right, s, at));
    return wall_value(f, s, value, 0);
}

static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    if (f->fault.kind == FAULT_TRANSPOSED)
        return f->right->wall_rate(f->right, exchanged_side(f->fault.axis, (int)s), at, t);
    double rate = f->right->wall_rate(f->right, s, at, wall_time(f, s, t));
    return wall_value(f, s, f->fault.kind == FAULT_WALL_SWING ? (1 + f->size) * rate : rate, 1);
}

/* Heat lost in the cell of a corner or the cells of an edge, W m^-3, if its Dirichlet sides at T are assumed cold: 2
 * k T/dx^2 for each, across half a cell.  It is zero on a side and even about it, so ghosts do not contribute. */
static double lost_at_corner(const struct faulty *f, const double *x) {
    const struct problem *p = f->right;
    double dx = f->size, lost = 0;
    for (int a = 0; a < p->dim; a++) {
        int s = fault_side_of_corner(f->fault.axis, a);
        double away = s < 0 ? dx / 2 : fabs(x[a] - (s % 2 ? p->hi[a] : p->lo[a]));
        if (away < dx / 4 || away > 3 * dx / 4) return 0;
    }
    for (int a = 0; a < p->dim; a++) {
        int s = fault_side_of_corner(f->fault.axis, a);
        if (s >= 0 && p->side[s] == DIRICHLET)
            lost += 2 * p->material[0].k[a] * p->wall(p, (enum side)s, x, 0) / (dx * dx);
    }
    return lost;
}

static double source(const struct problem *p, const double *x) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    double value = problem_source(f->right, at, f->fault.kind == FAULT_SOURCE_TIME ? f->size : 0);
    if (f->fault.kind == FAULT_CORNER) value -= lost_at_corner(f, at);
    return f->fault.kind == FAULT_SOURCE || f->fault.kind == FAULT_AMPLITUDE ? (1 + f->size) * value : value;
}

static double source_rate(const struct problem *p, const double *x) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    double value = f->right->source_rate(f->right, at);
    return f->fault.kind == FAULT_SOURCE || f->fault.kind == FAULT_AMPLITUDE ? (1 + f->size) * value : value;
}

static double source_at(const struct problem *p, const double *x, double t) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    double late = f->fault.kind == FAULT_SOURCE_TIME ? f->size : 0;
    double value = problem_source(f->right, at, f->fault.kind == FAULT_FROZEN ? 0 : t + late);
    return f->fault.kind == FAULT_SOURCE || f->fault.kind == FAULT_AMPLITUDE ? (1 + f->size) * value : value;
}

static void turn(struct problem *q, const struct problem *p, int pair) {
    for (int a = 0; a < p->dim; a++) {
        int from = exchanged(pair, a);
        q->material[0].k[a] = p->material[0].k[from];
        q->jumps[a] = p->jumps[from];
        memcpy(q->jump[a], p->jump[from], sizeof q->jump[a]);
    }
    for (int s = 0; s < 2 * p->dim; s++) {
        enum side from = exchanged_side(pair, s);
        q->side[s] = p->side[from], q->robin[s] = p->robin[from];
    }
}

static void stretch(struct faulty *f, int axis) {
    struct problem *p = &f->problem;
    double s = 1 + 2 * f->size / (p->hi[axis] - p->lo[axis]);
    f->stretch[axis] = s;
    for (int m = 0; m < p->materials; m++) p->material[m].k[axis] /= s * s;
    p->k_0 /= s * s;
    for (int hi = 0; hi < 2; hi++) p->robin[2 * axis + hi] /= s;
    for (int k = 0; k < p->jumps[axis]; k++)
        p->jump[axis][k] = f->centre[axis] + (p->jump[axis][k] - f->centre[axis]) / s;
    if (axis == 0) p->interface = f->centre[0] + (p->interface - f->centre[0]) / s;
}

/* Applies the fault to a k that depends on T. */
static void change_law(const struct problem *p, struct faulty *f) {
    struct problem *q = &f->problem;
    const enum fault_kind kind = f->fault.kind;
    double scale = kind == FAULT_AMPLITUDE ? 1 + f->size : 1, single = NAN;
    q->k_ref = scale * p->k_ref + (kind == FAULT_OFFSET ? f->size : 0);
    q->k_beta /= scale;
    if (p->k_law == K_POWER) q->k_0 /= pow(scale, p->k_n);
    if (kind == FAULT_CONDUCTIVITY || (kind == FAULT_AXIS && f->fault.axis == 0)) q->k_0 *= 1 + f->size;
    if (kind != FAULT_LAW) return;
    q->k_frozen = f->fault.axis == LAW_START;
    if (f->fault.axis == LAW_REF) single = p->k_0;
    if (f->fault.axis >= LAW_SIDE && f->fault.axis < LAW_HARMONIC)
        single = fault_law_at_side(p, f->fault.axis - LAW_SIDE);
    if (isfinite(single)) q->k_law = K_LINEAR, q->k_0 = single, q->k_beta = 0;
}

/* Applies the fault to the coefficients of *f, which are initially those of *p. */
static void change_coefficients(const struct problem *p, struct faulty *f) {
    struct problem *q = &f->problem;
    const enum fault_kind kind = f->fault.kind;
    const int axis = f->fault.axis;
    for (int a = 0; a < p->dim && kind == FAULT_SWAP; a++) q->material[0].k[a] = p->material[0].k[exchanged(axis, a)];
    if (kind == FAULT_ISOTROPIC) q->material[0].k[fault_other(axis, 0)] = p->material[0].k[fault_other(axis, 1)];
    if (kind == FAULT_CAPACITY) q->material[1].rho_c = q->material[0].rho_c;
    if (kind == FAULT_RHO_C) q->material[axis].rho_c *= 1 + f->size;
    for (int m = 0; m < q->materials; m++)
        for (int a = 0; a < p->dim; a++)
            if (kind == FAULT_CONDUCTIVITY || (kind == FAULT_AXIS && a == axis)) q->material[m].k[a] *= 1 + f->size;
    for (int m = 0; m < q->materials && kind == FAULT_DIFFUSIVITY; m++) {
        for (int a = 0; a < p->dim; a++) q->material[m].k[a] /= q->material[m].rho_c;
        q->material[m].rho_c = 1;
    }
    for (int s = 0; s < 2 * p->dim; s++) {
        const struct material *beside = &q->material[s == X_HI ? q->materials - 1 : 0];
        if (kind == FAULT_COEFFICIENT && (s == axis || axis == FAULT_ALL_SIDES)) q->robin[s] *= 1 + f->size;
        if (kind == FAULT_NEAR_WALL) q->robin[s] /= fmax(0.01, 1 - f->size * q->robin[s] / beside->k[s / 2]);
    }
}

/* Applies the fault to the positions of sides, interface and jumps. */
static void change_places(const struct problem *p, struct faulty *f) {
    struct problem *q = &f->problem;
    const enum fault_kind kind = f->fault.kind;
    const int axis = f->fault.axis;
    if (kind == FAULT_TRANSPOSED) turn(q, p, axis);
    if (kind == FAULT_INTERFACE) q->interface += f->size;
    for (int a = 0; a < p->dim; a++)
        if (kind == FAULT_EXTENT && (axis == a || axis >= FAULT_BOTH_AXES)) stretch(f, a);
    int width = kind == FAULT_START_WIDTH || kind == FAULT_SAMPLES;
    for (int k = 0; (width || kind == FAULT_START_SHIFT) && axis < p->dim && k < q->jumps[axis]; k++)
        q->jump[axis][k] += width && 2 * k < q->jumps[axis] ? -f->size : f->size;
}

int fault_make(const struct problem *p, struct fault fault, double size, struct faulty *f) {
    if (!fault_applies(p, fault)) return 0;
    *f = (struct faulty){.problem = *p, .right = p, .fault = fault, .size = size, .stretch = {1, 1, 1}};
    struct problem *q = &f->problem;
    q->data = f;
    q->initial = initial;
    q->wall = wall;
    if (p->wall_rate) q->wall_rate = fault.kind == FAULT_WALL_FROZEN ? NULL : wall_rate;
    if (p->source || fault.kind == FAULT_CORNER) q->source = source;
    if (p->source_rate) q->source_rate = fault.kind == FAULT_FROZEN ? NULL : source_rate;
    if (fault.kind == FAULT_CLOCK) q->t_end += size;
    for (int a = 0; a < p->dim; a++) f->centre[a] = (p->lo[a] + p->hi[a]) / 2, q->mirror[a] = 0;
    if (p->source_at) q->source_at = source_at;
    change_coefficients(p, f);
    if (p->k_law) change_law(p, f);
    change_places(p, f);
    return 1;
}
