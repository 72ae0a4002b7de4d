/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Faults as changes of a problem.
 *
 * A displaced wall stretches the domain by s along an axis.  With x = c + s (X - c) the equation in X has k/s^2
 * instead of k, and a flux q or a coefficient b at a side across that axis becomes q/s or b/s.  The lattice of the
 * correct problem can therefore be used for the faulty one. */
#include "verification/diagnosis/fault.h"

#include "references/kirchhoff.h"

#include <math.h>
#include <string.h>

int fault_pair(int pair, int second) {
    return second ? (pair == 0 ? 1 : 2) : (pair == 1 ? 1 : 0);
}

int fault_other(int axis, int other) {
    static const int of[FAULT_OTHERS] = {1, 0, 0, 2, 2, 1};
    return other ? of[axis] : axis % 3;
}

/* The axis that a pair of exchanged axes puts in the place of axis a. */
static int exchanged(int pair, int a) {
    int first = fault_pair(pair, 0), second = fault_pair(pair, 1);
    return a == first ? second : a == second ? first : a;
}

static enum side exchanged_side(int pair, int s) {
    return (enum side)(2 * exchanged(pair, s / 2) + s % 2);
}

/* The side across axis a that a corner or an edge is on; -1: the edge is along a. */
static int side_of_corner(int corner, int a) {
    int edge = corner - 12, along = edge / 4;
    if (corner < 12) return 2 * a + ((corner < 4 ? corner : corner - 4) >> a & 1);
    return a == along ? -1 : 2 * a + (edge % 4 >> (a - (a > along)) & 1);
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

/* The time at which the faulty problem takes its walls. */
static double wall_time(const struct faulty *f, double t) {
    if (f->fault.kind == FAULT_WALL_FROZEN) return 0;
    return f->fault.kind == FAULT_WALL_TIME ? t + f->size : t;
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    if (f->fault.kind == FAULT_TRANSPOSED)
        return f->right->wall(f->right, exchanged_side(f->fault.axis, (int)s), at, t);
    return wall_value(f, s, f->right->wall(f->right, s, at, wall_time(f, t)), 0);
}

static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    double at[DIM_MAX];
    const struct faulty *f = faulty_at(p, x, at);
    if (f->fault.kind == FAULT_TRANSPOSED)
        return f->right->wall_rate(f->right, exchanged_side(f->fault.axis, (int)s), at, t);
    return wall_value(f, s, f->right->wall_rate(f->right, s, at, wall_time(f, t)), 1);
}

/* Heat lost in the cell of a corner or the cells of an edge, W m^-3, if its Dirichlet sides at T are assumed cold: 2
 * k T/dx^2 for each, across half a cell.  It is zero on a side and even about it, so ghosts do not contribute. */
static double lost_at_corner(const struct faulty *f, const double *x) {
    const struct problem *p = f->right;
    double dx = f->size, lost = 0;
    for (int a = 0; a < p->dim; a++) {
        int s = side_of_corner(f->fault.axis, a);
        double away = s < 0 ? dx / 2 : fabs(x[a] - (s % 2 ? p->hi[a] : p->lo[a]));
        if (away < dx / 4 || away > 3 * dx / 4) return 0;
    }
    for (int a = 0; a < p->dim; a++) {
        int s = side_of_corner(f->fault.axis, a);
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

/* k in the middle of a side. */
static double law_at_side(const struct problem *p, int s) {
    double x[DIM_MAX] = {(p->lo[0] + p->hi[0]) / 2, (p->lo[1] + p->hi[1]) / 2};
    x[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
    return kirchhoff_k(p, p->wall(p, (enum side)s, x, 0));
}

static int has_law(const struct problem *p, int law) {
    int s = law - LAW_SIDE;
    if (!p->k_law || law >= LAWS) return 0;
    if (law == LAW_REF) return p->k_law == K_LINEAR;
    if (law == LAW_START) return p->source_at || p->wall_rate; /* else the start may be steady */
    if (law == LAW_HARMONIC) return 1;
    return s < 2 * p->dim && p->side[s] == DIRICHLET && law_at_side(p, s) > 0;
}

static int has_wall_value(const struct problem *p, enum side s) {
    for (int i = 0; i <= 8; i++) {
        double x[DIM_MAX] = {0};
        for (int a = 0; a < p->dim; a++) x[a] = p->lo[a] + (p->hi[a] - p->lo[a]) * (0.03 + 0.117 * i);
        x[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
        if (p->wall(p, s, x, 0) != 0) return 1;
    }
    return 0;
}

static int has_fluxes(const struct problem *p) {
    int fluxes = 0;
    for (int s = 0; s < 2 * p->dim; s++) fluxes += p->side[s] == NEUMANN && has_wall_value(p, (enum side)s);
    return fluxes >= 2;
}

static int is_cooled(const struct problem *p, int s) {
    return s < 2 * p->dim && p->side[s] == ROBIN && p->robin[s] > 0;
}

static int has_cooled(const struct problem *p) {
    for (int s = 0; s < 2 * p->dim; s++)
        if (is_cooled(p, s)) return 1;
    return 0;
}

/* Whether that side has a coefficient, or any of several sides. */
static int has_coefficient(const struct problem *p, int axis) {
    int cooled = 0;
    if (axis != FAULT_ALL_SIDES) return is_cooled(p, axis);
    for (int s = 0; s < 2 * p->dim; s++) cooled += is_cooled(p, s);
    return cooled >= 2;
}

int fault_is_pace(const struct problem *p) {
    for (int s = 0; s < 2 * p->dim; s++)
        if (p->side[s] == ROBIN || (p->side[s] == NEUMANN && has_wall_value(p, (enum side)s))) return 0;
    return !p->source && !p->source_at && !p->wall_rate;
}

/* Whether there are two materials without sources, so that the fluxes determine the solution. */
static int has_diffusivities(const struct problem *p) {
    return p->materials == 2 && fault_is_pace(p) && p->material[0].rho_c != p->material[1].rho_c;
}

static int has_corner(const struct problem *p, int corner) {
    int held = 0;
    if ((p->dim == 2) != (corner < 4)) return 0;
    for (int a = 0; a < p->dim; a++) {
        int s = side_of_corner(corner, a);
        held = held || (s >= 0 && p->side[s] == DIRICHLET && has_wall_value(p, (enum side)s));
    }
    return held;
}

/* Whether two axes with different conductivities, or of one extent, can be exchanged. */
static int has_pair(const struct problem *p, enum fault_kind kind, int axis) {
    const double *k = p->material[0].k;
    if (p->dim < 2 || axis >= (kind == FAULT_ISOTROPIC ? p->dim * (p->dim - 1) : p->dim * (p->dim - 1) / 2)) return 0;
    int a = fault_pair(axis, 0), b = fault_pair(axis, 1);
    if (kind == FAULT_ISOTROPIC) a = fault_other(axis, 0), b = fault_other(axis, 1);
    if (kind == FAULT_TRANSPOSED) return p->lo[a] == p->lo[b] && p->hi[a] == p->hi[b];
    return k[a] != k[b];
}

static int applies(const struct problem *p, struct fault fault) {
    const enum fault_kind kind = fault.kind;
    const int axis = fault.axis;
    if (kind >= FAULT_SOME_STEPS || axis < 0) return 0;
    if (kind == FAULT_LAW) return has_law(p, axis);
    if (p->k_law && p->dim > 1 && (kind == FAULT_EXTENT || kind == FAULT_AXIS)) return 0; /* k would differ by axis */
    if (p->k_law && kind == FAULT_CORNER) return 0;
    if (kind == FAULT_SWAP || kind == FAULT_ISOTROPIC || kind == FAULT_TRANSPOSED) return has_pair(p, kind, axis);
    if (kind == FAULT_CORNER) return p->dim > 1 && !p->shape && has_corner(p, axis);
    if (kind == FAULT_SOURCE) return p->source || p->source_at;
    if (kind == FAULT_SOURCE_TIME || kind == FAULT_FROZEN) return p->source_rate || p->source_at;
    if (kind == FAULT_WALL_TIME || kind == FAULT_WALL_FROZEN) return p->wall_rate != 0;
    if (kind == FAULT_DIFFUSIVITY) return has_diffusivities(p);
    if (kind == FAULT_CAPACITY) return p->materials == 2 && p->material[0].rho_c != p->material[1].rho_c;
    if (kind == FAULT_AXIS) return p->dim > 1 && axis < p->dim;
    if (kind == FAULT_RHO_C) return p->materials == 2 && axis < 2;
    if (kind == FAULT_COEFFICIENT) return has_coefficient(p, axis);
    if (kind == FAULT_NEAR_WALL) return axis == 0 && has_cooled(p);
    if (kind == FAULT_INTERFACE || kind == FAULT_MEAN) return p->materials == 2;
    if (kind == FAULT_WALL && axis == FAULT_ALL_SIDES) return has_fluxes(p);
    if (kind == FAULT_WALL) return axis < 2 * p->dim && has_wall_value(p, (enum side)axis);
    if (kind == FAULT_START_WIDTH || kind == FAULT_SAMPLES) return axis < p->dim && p->jumps[axis] >= 2;
    if (kind == FAULT_EXTENT)
        return axis < p->dim || (p->dim > 1 && axis == (p->dim == 2 ? FAULT_BOTH_AXES : FAULT_ALL_AXES));
    return axis < (kind == FAULT_START_SHIFT ? p->dim : 1);
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
    if (f->fault.axis >= LAW_SIDE && f->fault.axis < LAW_HARMONIC) single = law_at_side(p, f->fault.axis - LAW_SIDE);
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
    if (!applies(p, fault)) return 0;
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

int fault_is_whole(enum fault_kind kind) {
    return kind == FAULT_SWAP || kind == FAULT_CAPACITY || kind == FAULT_ISOTROPIC || kind == FAULT_TRANSPOSED ||
           kind == FAULT_FROZEN || kind == FAULT_WALL_FROZEN || kind == FAULT_DIFFUSIVITY || kind == FAULT_LAW;
}

int fault_bends(enum fault_kind kind) {
    return kind == FAULT_CONDUCTIVITY || kind == FAULT_AXIS || kind == FAULT_RHO_C || kind == FAULT_COEFFICIENT;
}

int fault_can_be(const struct problem *p, enum fault_kind kind, double size) {
    static const double SIGN = 0.1; /* largest distance from -2 that counts as a wrong sign */
    if (kind == FAULT_WALL || kind == FAULT_SOURCE) return size > -1.05 || fabs(size + 2) < SIGN;
    if (kind == FAULT_CLOCK) return size > -p->t_end;
    if (kind == FAULT_AMPLITUDE || kind == FAULT_COEFFICIENT) return size > -1.05;
    return !fault_bends(kind) || size > -1;
}

double fault_probe(const struct problem *p, struct fault fault) {
    const enum fault_kind kind = fault.kind;
    const int axis = kind == FAULT_INTERFACE || fault.axis >= p->dim ? 0 : fault.axis;
    int is_place = kind == FAULT_EXTENT || kind == FAULT_START_SHIFT || kind == FAULT_START_WIDTH ||
                   kind == FAULT_SAMPLES || kind == FAULT_INTERFACE;
    if (kind == FAULT_CLOCK || kind == FAULT_SOURCE_TIME || kind == FAULT_WALL_TIME) return 0.01 * p->t_end;
    if (is_place) return (p->hi[axis] - p->lo[axis]) / 200;
    if (kind == FAULT_SOURCE || kind == FAULT_WALL) return 1; /* the equation is linear in them */
    return fault_is_whole(kind) ? 1 : 0.01;
}
