/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Faults as changes of a problem.
 *
 * A wall that lies elsewhere stretches the domain by s along an axis: with x = c + s (X - c) the equation in X has
 * k/s^2 for k, and a flux q or a coefficient b at a side across that axis becomes q/s and b/s, so that the lattice of
 * the right problem serves the faulty one. */
#include "verification/diagnosis/fault.h"

#include <math.h>
#include <string.h>

/* The fault of *p; right: where X of the faulty problem lies in the coordinates that its data are given in. */
static const struct faulty *faulty_at(const struct problem *p, const double x[2], double right[2]) {
    const struct faulty *f = p->data;
    int turned = f->fault.kind == FAULT_TRANSPOSED;
    for (int a = 0; a < 2; a++) right[a ^ turned] = f->centre[a] + f->stretch[a] * (x[a] - f->centre[a]);
    return f;
}

/* Away from the nearer of the jumps along an axis, so that what lies between two of them is wider by the size. */
static double narrowed(const struct problem *p, int axis, double x, double size) {
    double middle = 0;
    for (int k = 0; k < p->jumps[axis]; k++) middle += p->jump[axis][k] / p->jumps[axis];
    return fabs(x - middle) <= size ? middle : x - (x > middle ? size : -size);
}

static double initial(const struct problem *p, const double x[2]) {
    double at[2];
    const struct faulty *f = faulty_at(p, x, at);
    if (f->fault.kind == FAULT_START_SHIFT) at[f->fault.axis] -= f->size;
    if (f->fault.kind == FAULT_START_WIDTH || f->fault.kind == FAULT_SAMPLES)
        at[f->fault.axis] = narrowed(f->right, f->fault.axis, at[f->fault.axis], f->size);
    double T = f->right->initial(f->right, at);
    return f->fault.kind == FAULT_AMPLITUDE ? (1 + f->size) * T : T;
}

static double wall(const struct problem *p, enum side s, const double x[2]) {
    double at[2];
    const struct faulty *f = faulty_at(p, x, at);
    if (f->fault.kind == FAULT_TRANSPOSED) return f->right->wall(f->right, (enum side)(s ^ 2), at);
    double value = f->right->wall(f->right, s, at);
    if (f->right->side[s] == NEUMANN) value /= f->stretch[s / 2];
    int is_flux = f->right->side[s] == NEUMANN && f->fault.axis == FAULT_ALL_SIDES;
    if (f->fault.kind == FAULT_AMPLITUDE || (f->fault.kind == FAULT_WALL && (f->fault.axis == (int)s || is_flux)))
        value *= 1 + f->size;
    return value;
}

/* What the cell of a corner lacks, W m^-3, where the sides of given temperature T there are taken for cold: 2 k
 * T/dx^2 of each, across half a cell.  Nothing on a side itself and even about it, so that ghosts have no part in it.
 */
static double lost_at_corner(const struct faulty *f, const double x[2]) {
    const struct problem *p = f->right;
    double dx = f->size, lost = 0;
    for (int a = 0; a < 2; a++) {
        double away = fabs(x[a] - (f->fault.axis >> a & 1 ? p->hi[a] : p->lo[a]));
        if (away < dx / 4 || away > 3 * dx / 4) return 0;
    }
    for (int a = 0; a < 2; a++) {
        enum side s = (enum side)(2 * a + (f->fault.axis >> a & 1));
        if (p->side[s] == DIRICHLET) lost += 2 * p->material[0].k[a] * p->wall(p, s, x) / (dx * dx);
    }
    return lost;
}

static double source(const struct problem *p, const double x[2]) {
    double at[2];
    const struct faulty *f = faulty_at(p, x, at);
    double value = problem_source(f->right, at, f->fault.kind == FAULT_SOURCE_TIME ? f->size : 0);
    if (f->fault.kind == FAULT_CORNER) value -= lost_at_corner(f, at);
    return f->fault.kind == FAULT_SOURCE || f->fault.kind == FAULT_AMPLITUDE ? (1 + f->size) * value : value;
}

static double source_rate(const struct problem *p, const double x[2]) {
    double at[2];
    const struct faulty *f = faulty_at(p, x, at);
    double value = f->right->source_rate(f->right, at);
    return f->fault.kind == FAULT_SOURCE || f->fault.kind == FAULT_AMPLITUDE ? (1 + f->size) * value : value;
}

static int has_wall_value(const struct problem *p, enum side s) {
    for (int i = 0; i <= 8; i++) {
        double x[2];
        x[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
        x[1 - s / 2] = p->lo[1 - s / 2] + (p->hi[1 - s / 2] - p->lo[1 - s / 2]) * (0.03 + 0.117 * i);
        if (p->wall(p, s, x) != 0) return 1;
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

/* That side; or all of them, of several. */
static int has_coefficient(const struct problem *p, int axis) {
    int cooled = 0;
    if (axis != FAULT_ALL_SIDES) return is_cooled(p, axis);
    for (int s = 0; s < 2 * p->dim; s++) cooled += is_cooled(p, s);
    return cooled >= 2;
}

static int has_corner(const struct problem *p, int corner) {
    int held = 0;
    for (int a = 0; a < 2; a++) {
        enum side s = (enum side)(2 * a + (corner >> a & 1));
        held = held || (p->side[s] == DIRICHLET && has_wall_value(p, s));
    }
    return held;
}

static int is_square(const struct problem *p) {
    return p->dim == 2 && p->lo[0] == p->lo[1] && p->hi[0] == p->hi[1];
}

static int applies(const struct problem *p, struct fault fault) {
    switch (fault.kind) {
    case FAULT_SWAP:
    case FAULT_ISOTROPIC:
        return p->dim == 2 && p->material[0].k[0] != p->material[0].k[1];
    case FAULT_TRANSPOSED:
        return is_square(p);
    case FAULT_CORNER:
        return p->dim == 2 && has_corner(p, fault.axis);
    case FAULT_SOURCE:
        return p->source != 0;
    case FAULT_SOURCE_TIME:
        return p->source_rate != 0;
    case FAULT_CAPACITY:
        return p->materials == 2 && p->material[0].rho_c != p->material[1].rho_c;
    case FAULT_AXIS:
        return p->dim == 2 && fault.axis < 2;
    case FAULT_RHO_C:
        return p->materials == 2 && fault.axis < 2;
    case FAULT_COEFFICIENT:
        return has_coefficient(p, fault.axis);
    case FAULT_INTERFACE:
    case FAULT_MEAN:
        return p->materials == 2;
    case FAULT_WALL:
        if (fault.axis == FAULT_ALL_SIDES) return has_fluxes(p);
        return fault.axis < 2 * p->dim && has_wall_value(p, (enum side)fault.axis);
    case FAULT_START_WIDTH:
    case FAULT_SAMPLES:
        return fault.axis < p->dim && p->jumps[fault.axis] >= 2;
    case FAULT_EXTENT:
        return fault.axis < p->dim || (fault.axis == FAULT_BOTH_AXES && p->dim == 2);
    case FAULT_START_SHIFT:
        return fault.axis < p->dim;
    default:
        return fault.axis == 0;
    }
}

static void turn(struct problem *q, const struct problem *p) {
    for (int a = 0; a < 2; a++) {
        q->material[0].k[a] = p->material[0].k[1 - a];
        q->jumps[a] = p->jumps[1 - a];
        memcpy(q->jump[a], p->jump[1 - a], sizeof q->jump[a]);
    }
    for (int s = 0; s < 4; s++) q->side[s] = p->side[s ^ 2], q->robin[s] = p->robin[s ^ 2];
}

static void stretch(struct faulty *f, int axis) {
    struct problem *p = &f->problem;
    double s = 1 + 2 * f->size / (p->hi[axis] - p->lo[axis]);
    f->stretch[axis] = s;
    for (int m = 0; m < p->materials; m++) p->material[m].k[axis] /= s * s;
    for (int hi = 0; hi < 2; hi++) p->robin[2 * axis + hi] /= s;
    for (int k = 0; k < p->jumps[axis]; k++)
        p->jump[axis][k] = f->centre[axis] + (p->jump[axis][k] - f->centre[axis]) / s;
    if (axis == 0) p->interface = f->centre[0] + (p->interface - f->centre[0]) / s;
}

int fault_make(const struct problem *p, struct fault fault, double size, struct faulty *f) {
    if (!applies(p, fault)) return 0;
    *f = (struct faulty){.problem = *p, .right = p, .fault = fault, .size = size, .stretch = {1, 1}};
    struct problem *q = &f->problem;
    q->data = f;
    q->initial = initial;
    q->wall = wall;
    if (p->source || fault.kind == FAULT_CORNER) q->source = source;
    if (p->source_rate) q->source_rate = source_rate;
    for (int a = 0; a < 2; a++) f->centre[a] = (p->lo[a] + p->hi[a]) / 2, q->mirror[a] = 0;
    switch (fault.kind) {
    case FAULT_CLOCK:
        q->t_end += size;
        break;
    case FAULT_CONDUCTIVITY:
        for (int m = 0; m < q->materials; m++) q->material[m].k[0] *= 1 + size, q->material[m].k[1] *= 1 + size;
        break;
    case FAULT_SWAP:
        q->material[0] = (struct material){{p->material[0].k[1], p->material[0].k[0]}, p->material[0].rho_c};
        break;
    case FAULT_ISOTROPIC:
        q->material[0].k[fault.axis] = p->material[0].k[1 - fault.axis];
        break;
    case FAULT_TRANSPOSED:
        turn(q, p);
        break;
    case FAULT_CAPACITY:
        q->material[1].rho_c = q->material[0].rho_c;
        break;
    case FAULT_AXIS:
        for (int m = 0; m < q->materials; m++) q->material[m].k[fault.axis] *= 1 + size;
        break;
    case FAULT_RHO_C:
        q->material[fault.axis].rho_c *= 1 + size;
        break;
    case FAULT_COEFFICIENT:
        for (int s = 0; s < 4; s++)
            if (s == fault.axis || fault.axis == FAULT_ALL_SIDES) q->robin[s] *= 1 + size;
        break;
    case FAULT_EXTENT:
        for (int a = 0; a < p->dim; a++)
            if (fault.axis == a || fault.axis == FAULT_BOTH_AXES) stretch(f, a);
        break;
    case FAULT_INTERFACE:
        q->interface += size;
        break;
    case FAULT_START_SHIFT:
        for (int k = 0; k < q->jumps[fault.axis]; k++) q->jump[fault.axis][k] += size;
        break;
    case FAULT_START_WIDTH:
    case FAULT_SAMPLES:
        for (int k = 0; k < q->jumps[fault.axis]; k++)
            q->jump[fault.axis][k] += 2 * k < q->jumps[fault.axis] ? -size : size;
        break;
    default:
        break;
    }
    return 1;
}

int fault_is_whole(enum fault_kind kind) {
    return kind == FAULT_SWAP || kind == FAULT_CAPACITY || kind == FAULT_ISOTROPIC || kind == FAULT_TRANSPOSED;
}

int fault_bends(enum fault_kind kind) {
    return kind == FAULT_CONDUCTIVITY || kind == FAULT_AXIS || kind == FAULT_RHO_C || kind == FAULT_COEFFICIENT;
}

int fault_can_be(const struct problem *p, enum fault_kind kind, double size) {
    static const double SIGN = 0.1; /* how near to -2 a wrong sign is */
    switch (kind) {
    case FAULT_WALL:
    case FAULT_SOURCE:
        return size > -1.05 || fabs(size + 2) < SIGN;
    case FAULT_CLOCK:
        return size > -p->t_end;
    case FAULT_AMPLITUDE:
        return size > -1.05;
    default:
        return !fault_bends(kind) || size > -1;
    }
}

double fault_probe(const struct problem *p, struct fault fault) {
    switch (fault.kind) {
    case FAULT_CLOCK:
    case FAULT_SOURCE_TIME:
        return 0.01 * p->t_end;
    case FAULT_EXTENT:
        return (p->hi[fault.axis % 2] - p->lo[fault.axis % 2]) / 200;
    case FAULT_START_SHIFT:
    case FAULT_START_WIDTH:
    case FAULT_SAMPLES:
        return (p->hi[fault.axis] - p->lo[fault.axis]) / 200;
    case FAULT_INTERFACE:
        return (p->hi[0] - p->lo[0]) / 200;
    case FAULT_SOURCE:
    case FAULT_WALL:
        return 1; /* the equation is linear in them */
    default:
        return fault_is_whole(fault.kind) ? 1 : 0.01;
    }
}
