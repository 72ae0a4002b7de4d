/* SPDX-License-Identifier: GPL-3.0-or-later */
/* E1 at the particles alone is blind to what aliases there: a cosine of wave length 2 dx is zero at each of them.
 * Between them the same samples have another value.
 *
 * Lagrange's polynomial through 8 points differs from T by T^(8) prod (x - x_j)/8!: 1.07e-3 dx^8 T^(8) half-way
 * between the middle two, 0.013 dx^8 T^(8) between the first two.  That is above the order of every method here.  T
 * has a kink where two materials meet, so a polynomial keeps to one of them, and a gap that the interface lies in is
 * left out. */
#include "verification/choose/halfway.h"

#include "references/snapshot.h"
#include "solver/field.h"

#include <math.h>

enum { POINTS = 8 };

/* A row of lattice points: T[i * step], at x0 + i along the axis, for first <= i < last. */
struct row {
    const double *T;
    size_t step;
    int first, last;
};

/* Half-way between the points i and i + 1 of a row. */
static double between(const struct row *r, int i) {
    int count = r->last - r->first < POINTS ? r->last - r->first : POINTS, start = i + 1 - count / 2;
    if (start < r->first) start = r->first;
    if (start > r->last - count) start = r->last - count;
    double sum = 0;
    for (int j = start; j < start + count; j++) {
        double weight = 1;
        for (int k = start; k < start + count; k++)
            if (k != j) weight *= (i + 0.5 - k) / (j - k);
        sum += weight * r->T[(size_t)j * r->step];
    }
    return sum;
}

static double coordinate(const struct field *f, size_t i, int axis) {
    return axis ? f->y[i] : f->x[i];
}

/* Narrows the row to the points on the same side of the interface as both i and i + 1; 0 where they are not. */
static int same_material(const struct problem *p, const struct field *f, int i, struct row *r) {
    if (p->materials < 2) return 1;
    double clear = 1e-9 * f->spacing[0];
    int after = f->x[i] > p->interface - clear;
    if (!after && f->x[i + 1] > p->interface + clear) return 0;
    while (after && f->x[r->first] < p->interface - clear) r->first++;
    while (!after && f->x[r->last - 1] > p->interface + clear) r->last--;
    return 1;
}

double halfway_error(const struct scene *s, const struct problem *p, const struct field *f) {
    double apart = 0, whole = 0;
    if (f->shape[0] == 0) return NAN;
    struct snapshot now = snapshot_take(s, p, f->time);
    for (int axis = 0; axis < f->dim; axis++) {
        size_t along = axis ? (size_t)f->shape[0] : 1, across = axis ? 1 : (size_t)f->shape[0];
        for (int line = 0; line < f->shape[1 - axis]; line++)
            for (int i = 0; i + 1 < f->shape[axis]; i++) {
                size_t origin = (size_t)line * across, at = origin + (size_t)i * along;
                struct row row = {f->T + origin, along, 0, f->shape[axis]};
                double x[2] = {f->x[at], f->y ? f->y[at] : 0};
                if (axis == 0 && !same_material(p, f, i, &row)) continue;
                x[axis] = 0.5 * (x[axis] + coordinate(f, at + along, axis));
                struct exact e = snapshot_at(&now, x);
                if (e.no_value) continue;
                apart += fabs(between(&row, i) - e.temperature);
                whole += fabs(e.temperature);
            }
    }
    snapshot_free(&now);
    return apart / whole;
}
