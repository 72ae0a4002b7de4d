/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sizes of faults from spacing to spacing.
 *
 * One field cannot distinguish faults with similar responses (without a source T depends on kappa t alone).  The
 * dependence of the size on the spacing can: a clock is wrong by a number of steps, a position by a number of cells,
 * a coefficient by a fraction of itself. */
#include "verification/fault/fault_fits.h"

#include "solver/field.h"
#include "verification/fault/diagnosis.h"

#include <math.h>
#include <string.h>

static const double LEAST_MEAN =
    0.3; /* least fraction of the arithmetic mean's effect for which another mean is detected */

/* Outward displacement, m, of the jumps of the initial data, if they are midway between the adjacent points along an
 * axis; 0 if they do not agree. */
static double displacement(const struct problem *p, int axis, const struct diagnosis_rung *r) {
    double out = 0;
    for (int k = 0; k < p->jumps[axis]; k++) {
        double at = p->jump[axis][k], below = -INFINITY, above = INFINITY;
        for (size_t i = 0; i < r->field->n; i++) {
            double x[DIM_MAX], place = field_place(r->field, i, x)[axis];
            if (place < at)
                below = fmax(below, place);
            else
                above = fmin(above, place);
        }
        double moved = (2 * k < p->jumps[axis] ? -1 : 1) * ((below + above) / 2 - at);
        if (k && fabs(moved - out) > 1e-6 * r->dx) return 0;
        out = moved;
    }
    return fabs(out) > 1e-6 * r->dx ? out : 0;
}

/* |log| of the change of the size from rung to rung in these units. */
static double drift(const struct fault_fit *c, double fine, double coarse) {
    double ratio = c->coarse.size / coarse / (c->fine.size / fine);
    return ratio > 0 ? fabs(log(ratio)) : INFINITY;
}

void fault_scaling(const struct problem *p, struct fault_fit *c, const struct diagnosis_rung *fine,
                   const struct diagnosis_rung *coarse) {
    int place = c->fault.kind == FAULT_EXTENT || c->fault.kind == FAULT_START_SHIFT ||
                c->fault.kind == FAULT_START_WIDTH || c->fault.kind == FAULT_INTERFACE ||
                c->fault.kind == FAULT_MEAN || c->fault.kind == FAULT_NEAR_WALL;
    int in_time =
        c->fault.kind == FAULT_CLOCK || c->fault.kind == FAULT_SOURCE_TIME || c->fault.kind == FAULT_WALL_TIME;
    int clock = in_time && fine->dt > 0 && coarse->dt > 0;
    c->unit[0] = clock ? fine->dt : place ? fine->dx : 1;
    c->unit[1] = clock ? coarse->dt : place ? coarse->dx : 1;
    if (c->fault.kind == FAULT_SAMPLES)
        c->unit[0] = displacement(p, c->fault.axis, fine), c->unit[1] = displacement(p, c->fault.axis, coarse);
    c->name = clock ? "steps" : in_time ? "s" : place ? "cells" : c->fault.kind == FAULT_OFFSET ? "K" : "%";
    if (clock) c->steps[0] = c->fine.size / fine->dt, c->steps[1] = c->coarse.size / coarse->dt;
    c->drift = drift(c, c->unit[0], c->unit[1]);
    double diffusive[2] = {pow(fine->dx, 2) / problem_diffusivity(p), pow(coarse->dx, 2) / problem_diffusivity(p)};
    if (in_time && !clock && drift(c, diffusive[0], diffusive[1]) < c->drift) {
        memcpy(c->unit, diffusive, sizeof diffusive);
        c->name = FAULT_DIFFUSIVE;
        c->drift = drift(c, c->unit[0], c->unit[1]);
    }
    if (c->fault.kind == FAULT_WALL_TIME && drift(c, 1, 1) < c->drift) { /* a phase */
        c->unit[0] = c->unit[1] = 1;
        c->name = "s";
        c->drift = drift(c, 1, 1);
    }
    double due = c->fault.kind == FAULT_NEAR_WALL ? 0.5 : 1, found = c->fine.size / c->unit[0] / due;
    int whole = fault_is_whole(c->fault.kind) || c->fault.kind == FAULT_NEAR_WALL || c->fault.kind == FAULT_SAMPLES;
    if (whole && !(fabs(found - 1) <= FAULT_STEADY)) c->drift = INFINITY;
    if (c->fault.kind == FAULT_MEAN && !(found > LEAST_MEAN && found < 1 + FAULT_STEADY)) c->drift = INFINITY;
}
