/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The faults that a problem can have, and their sizes. */
#include "verification/fault/fault.h"

#include "references/kirchhoff.h"

#include <math.h>

int fault_pair(int pair, int second) {
    return second ? (pair == 0 ? 1 : 2) : (pair == 1 ? 1 : 0);
}

int fault_other(int axis, int other) {
    static const int of[FAULT_OTHERS] = {1, 0, 0, 2, 2, 1};
    return other ? of[axis] : axis % 3;
}

int fault_side_of_corner(int corner, int a) {
    int edge = corner - 12, along = edge / 4;
    if (corner < 12) return 2 * a + ((corner < 4 ? corner : corner - 4) >> a & 1);
    return a == along ? -1 : 2 * a + (edge % 4 >> (a - (a > along)) & 1);
}

double fault_law_at_side(const struct problem *p, int s) {
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
    return s < 2 * p->dim && p->side[s] == DIRICHLET && fault_law_at_side(p, s) > 0;
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
        int s = fault_side_of_corner(corner, a);
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

/* Whether that side changes in time, and another one too. */
static int is_one_of_changing(const struct problem *p, int side) {
    int changing = 0, this_one = 0;
    for (int s = 0; s < 2 * p->dim; s++) {
        double x[DIM_MAX] = {0};
        for (int a = 0; a < p->dim; a++) x[a] = p->lo[a] + 0.37 * (p->hi[a] - p->lo[a]);
        int changes = p->wall_rate(p, (enum side)s, x, 0.31 * p->t_end) != 0;
        changing += changes;
        this_one = this_one || (changes && s == side);
    }
    return this_one && changing > 1;
}

int fault_applies(const struct problem *p, struct fault fault) {
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
    if (kind == FAULT_WALL_TIME) return p->wall_rate && (axis == 0 || is_one_of_changing(p, axis - 1));
    if (kind == FAULT_WALL_FROZEN || (kind == FAULT_WALL_SWING && axis == 0)) return p->wall_rate != 0;
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

int fault_is_whole(enum fault_kind kind) {
    return kind == FAULT_SWAP || kind == FAULT_CAPACITY || kind == FAULT_ISOTROPIC || kind == FAULT_TRANSPOSED ||
           kind == FAULT_FROZEN || kind == FAULT_WALL_FROZEN || kind == FAULT_DIFFUSIVITY || kind == FAULT_LAW;
}

int fault_bends(enum fault_kind kind) {
    return kind == FAULT_CONDUCTIVITY || kind == FAULT_AXIS || kind == FAULT_RHO_C || kind == FAULT_COEFFICIENT ||
           kind == FAULT_WALL_TIME;
}

int fault_can_be(const struct problem *p, enum fault_kind kind, double size) {
    static const double SIGN = 0.1; /* largest distance from -2 that counts as a wrong sign */
    if (kind == FAULT_WALL || kind == FAULT_SOURCE) return size > -1.05 || fabs(size + 2) < SIGN;
    if (kind == FAULT_CLOCK) return size > -p->t_end;
    if (kind == FAULT_AMPLITUDE || kind == FAULT_COEFFICIENT) return size > -1.05;
    return !fault_bends(kind) || kind == FAULT_WALL_TIME || size > -1;
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
