/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Symmetry: only half of a rod, a quarter of a square or an octant of a cube is computed.
 *
 * If initial data, coefficients and sides are even about a plane, so is the solution, and no heat crosses the plane:
 * an insulated side.  On a lattice with an even number of particles across, the plane is midway between two of them.
 * The even ghosts of the insulated side are then exactly the omitted particles, so the discrete solution is the
 * same, to round-off. */
#include "verification/solve/symmetry.h"

#include "solver/particles/particles.h"
#include "solver/space/layout.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double reduced_wall(const struct problem *p, enum side s, const double *x, double t) {
    int a = (int)s / 2, inner = s % 2 == 0 && p->lo[a] != p->whole->lo[a];
    return inner ? 0 : p->whole->wall(p->whole, s, x, t);
}

int symmetry_reduce(const struct problem *whole, const struct options *o, struct problem *half, int cut[DIM_MAX]) {
    int cuts = 0;
    *half = *whole;
    half->whole = whole;
    half->wall = reduced_wall;
    for (int a = 0; a < DIM_MAX; a++) {
        double count = a < whole->dim ? (whole->hi[a] - whole->lo[a]) / layout_spacing(whole, o, a) : 0;
        double pairs = round(count / 2);
        cut[a] = whole->mirror[a] && !whole->wall_rate && o->layout == LAYOUT_LATTICE &&
                 o->domain == DOMAIN_SYMMETRY && pairs >= 1 && fabs(count - 2 * pairs) <= 1e-6 * count;
        if (!cut[a]) continue;
        half->lo[a] = (whole->lo[a] + whole->hi[a]) / 2;
        half->side[2 * a] = NEUMANN;
        half->mirror[a] = 0;
        cuts++;
    }
    return cuts;
}

/* The index in the part of point i of the whole along an axis of n points in the part. */
static int folded(int i, int n, int cut) {
    return !cut ? i : i < n ? n - 1 - i : i - n;
}

/* An array of the whole domain from one of the part. */
static double *restore_array(double *part, const struct field *whole, const int n[DIM_MAX], const int cut[DIM_MAX]) {
    double *to = part ? xcalloc(whole->n, sizeof *to) : NULL, *next = to;
    for (int k = 0; k < whole->shape[2] && part; k++)
        for (int j = 0; j < whole->shape[1]; j++) {
            const int row = folded(k, n[2], cut[2]) * n[1] + folded(j, n[1], cut[1]);
            const double *from = part + (size_t)row * (size_t)n[0];
            for (int i = 0; cut[0] && i < n[0]; i++) *next++ = from[n[0] - 1 - i];
            memcpy(next, from, (size_t)n[0] * sizeof *next);
            next += n[0];
        }
    free(part);
    return to;
}

static void restore(struct field *f, const struct problem *whole, const int cut[DIM_MAX]) {
    int n[DIM_MAX], copies = 1;
    for (int a = 0; a < DIM_MAX; a++) n[a] = f->shape[a], f->shape[a] *= cut[a] ? 2 : 1, copies *= cut[a] ? 2 : 1;
    f->n *= (size_t)copies;
    for (int a = 0; a < 2; a++) f->heat[a] *= copies;
    f->T = restore_array(f->T, f, n, cut);
    f->weight = restore_array(f->weight, f, n, cut);
    for (int a = 0; a < f->dim; a++) {
        double *part = f->x[a];
        if (!cut[a]) continue;
        f->x[a] = xcalloc(2 * (size_t)n[a], sizeof *part);
        for (int i = 0; i < n[a]; i++) {
            f->x[a][n[a] - 1 - i] = whole->lo[a] + whole->hi[a] - part[i];
            f->x[a][n[a] + i] = part[i];
        }
        free(part);
    }
}

int symmetry_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                   struct failure *why) {
    struct problem half;
    int cut[DIM_MAX];
    int ordered = !m->scheme || p->dim == 1 || !particles_rows(p, o); /* else by cells: they have no mirror order */
    if (ordered && symmetry_reduce(p, o, &half, cut)) {
        struct options apart = *o;
        apart.assembled = NULL; /* rows of the whole */
        int status = method_solve(m, &half, &apart, f, why);
        if (status == STATUS_OK) restore(f, p, cut);
        if (!status_refused(status)) return status; /* the part may be too short for the stencil */
    }
    return method_solve(m, p, o, f, why);
}
