/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hexagonal and graded clouds; all others start from the lattice.
 *
 * Hexagonal: rows sqrt(3)/2 dx apart, stretched to fill the height, and moved by dx/4 to either side in turn.  The
 * mirror line of a hexagonal lattice runs through particles: along the walls, which mirror between them, one row of
 * pairs is dx/2 and 3/2 dx apart.  On a rod it is the lattice.
 *
 * Graded: along each axis the faces of the cells lie at lo + L (e^(a xi) - 1)/(e^a - 1), xi = i/n, a = ln R: widths
 * grow by the same factor from cell to cell, R from wall to wall.  Particles lie midway between faces, walls midway
 * between a particle and its image.  With x* = lo - L/(e^a - 1) a cell is 2 tanh(a/(2n)) (x - x*) wide, so a place
 * alone tells the width. */
#include "solver/space/place.h"

#include <math.h>

double place_rows(double height, double dx) {
    return fmax(1, round(height / (dx * sqrt(0.75))));
}

static double extent(const struct problem *p, int axis) {
    return p->hi[axis] - p->lo[axis];
}

/* Face k of n cells, m. */
static double face(const struct problem *p, const struct options *o, int axis, int k, int n) {
    return p->lo[axis] + extent(p, axis) * (pow(o->grading, (double)k / n) - 1) / (o->grading - 1);
}

void place_position(const struct problem *p, const struct options *o, const struct lattice *l, int i, int j,
                    double x[2]) {
    int at[2] = {i, j};
    layout_position(l, i, j, x);
    if (o->layout == LAYOUT_HEXAGONAL && l->dim == 2) x[0] += (j % 2 ? 0.25 : -0.25) * l->dx[0];
    for (int a = 0; a < l->dim && o->layout == LAYOUT_GRADED && o->grading > 1; a++)
        x[a] = (face(p, o, a, at[a], l->n[a]) + face(p, o, a, at[a] + 1, l->n[a])) / 2;
}

double place_width(const struct problem *p, const struct options *o, const struct lattice *l, int axis, double x) {
    if (o->layout != LAYOUT_GRADED || !(o->grading > 1)) return l->dx[axis];
    return 2 * tanh(log(o->grading) / (2 * l->n[axis])) * (x - p->lo[axis] + extent(p, axis) / (o->grading - 1));
}

double place_spacing(const struct problem *p, const struct options *o, const struct lattice *l, const double x[2]) {
    double along = place_width(p, o, l, 0, x[0]);
    return l->dim == 1 ? along : sqrt(along * place_width(p, o, l, 1, x[1]));
}

double place_coarsest(const struct problem *p, const struct options *o, const struct lattice *l) {
    return place_spacing(p, o, l, p->hi);
}
