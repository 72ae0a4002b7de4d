/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows vote.  A row that names another fault or size, or no fault, votes against.  A fault of one kind of walls is
 * refuted by a row that has only walls of that kind and passes. */
#include "verification/fault/headline.h"

#include "solver/status.h"
#include "verification/fault/wording.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Faults of different axes or materials are different; faults of different sides or corners are one fault of all
 * sides.  An extra step in every run agrees with extra steps in some runs. */
static int is_same(const struct diagnosis *a, const struct diagnosis *b) {
    static const double SAME = 0.2; /* each size is known to 12 %, half of FAULT_STEADY: sqrt(2) of that */
    /* a wall that is taken as linear over half a cell acts dx^2/(8 kappa) late, half a step of dx^2/(4 kappa) */
    static const double HALF_CELL = 0.75;
    const enum fault_kind kind = a->fault.kind;
    if (!a->named || !b->named || strcmp(a->unit, b->unit) != 0) return 0;
    if (kind != b->fault.kind && !(kind == FAULT_SOME_STEPS && b->fault.kind == FAULT_CLOCK)) return 0;
    int has_axis = kind == FAULT_AXIS || kind == FAULT_SWAP || kind == FAULT_TRANSPOSED || kind == FAULT_ISOTROPIC ||
                   kind == FAULT_RHO_C;
    int no_size = *a->unit == '\0' || kind == FAULT_MEAN || kind == FAULT_NOISE || kind == FAULT_UNSTABLE;
    if (has_axis && a->fault.axis != b->fault.axis) return 0;
    if (kind == FAULT_WALL_TIME && strcmp(a->unit, "steps") == 0)
        return a->size * b->size > 0 && fabs(a->size - b->size) <= HALF_CELL;
    return no_size || fabs(a->size - b->size) <= SAME * fmin(fabs(a->size), fabs(b->size));
}

static int votes_for(const struct diagnosis *found, int failing, int i) {
    int votes = 0;
    for (int k = 0; k < failing; k++) votes += is_same(&found[i], &found[k]);
    return votes;
}

static int by_size(const void *a, const void *b) {
    double x = ((const struct diagnosis *)a)->size, y = ((const struct diagnosis *)b)->size;
    return (x > y) - (x < y);
}

struct headline headline_choose(const struct diagnosis *found, int failing) {
    struct headline h = {.failing = failing};
    int best = -1, named = 0, count = 0;
    for (int i = 0; i < failing; i++) {
        int votes = votes_for(found, failing, i);
        named += found[i].named;
        if (votes > h.votes) h.votes = votes, best = i;
    }
    if (h.votes < 2 && named != 1) h.votes = 0;
    if (h.votes == 0) return h;
    struct diagnosis *same = xcalloc((size_t)failing, sizeof *same);
    for (int i = 0; i < failing; i++)
        if (is_same(&found[best], &found[i])) same[count++] = found[i];
    qsort(same, (size_t)count, sizeof *same, by_size);
    h.fault = same[(count - 1) / 2];
    h.fault.fault.kind = found[best].fault.kind;
    for (int i = 0; i < count; i++) {
        if (same[i].fault.axis != same[0].fault.axis) h.fault.fault.axis = FAULT_ANY;
        h.fault.sides &= same[i].sides;
        h.fault.is_pace &= same[i].is_pace;
    }
    free(same);
    h.is_firm = h.votes >= 2 && 2 * h.votes >= failing;
    wording_fault(&h.fault);
    return h;
}

void headline_print(const struct headline *h, char text[HEADLINE_TEXT]) {
    *text = '\0';
    if (h->votes)
        snprintf(text, HEADLINE_TEXT, "%s%s (%d of %d rows that do not pass)", h->is_firm ? "" : "perhaps ",
                 h->fault.what, h->votes, h->failing);
}

int headline_contradicts(const struct headline *h, const struct problem *p, double dx, double zero, double ceiling) {
    static const double SURE = 2; /* the rest of the error, up to a ceiling itself, may have the other sign */
    struct diagnosis d = h->fault;
    int other_mean = d.fault.kind == FAULT_MEAN && (d.fault.axis == FAULT_ANY || d.fault.axis == MEAN_IS_OTHER);
    if (other_mean || (d.fault.axis == FAULT_ANY && p->dim > 1)) return 0; /* it may differ from row to row */
    if (d.fault.axis == FAULT_ANY) d.fault.axis = 0;
    if (p->k_law && d.fault.kind == FAULT_CONDUCTIVITY) return 0; /* k there is from a law of its own */
    int of_sides = d.fault.kind == FAULT_EXTENT || d.fault.kind == FAULT_WALL;
    if (of_sides && (!d.sides || d.sides & ~diagnosis_sides(p, d.fault))) return 0; /* walls of another kind */
    return diagnosis_effect(p, &d, dx, zero) > SURE * ceiling;
}
