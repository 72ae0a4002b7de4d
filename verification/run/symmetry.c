/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Symmetry: only half of a rod or a quarter of a square is computed.
 *
 * If initial data, coefficients and sides are even about a plane, so is the solution, and no heat crosses the plane:
 * an insulated side.  On a lattice with an even number of particles across, the plane is midway between two of them.
 * The even ghosts of the insulated side are then exactly the omitted particles, so the discrete solution is the
 * same, to round-off. */
#include "verification/run/symmetry.h"

#include <math.h>
#include <string.h>

static double reduced_wall(const struct problem *p, enum side s, const double x[2], double t) {
    int a = (int)s / 2, inner = s % 2 == 0 && p->lo[a] != p->whole->lo[a];
    return inner ? 0 : p->whole->wall(p->whole, s, x, t);
}

int symmetry_reduce(const struct problem *whole, const struct options *o, struct problem *half, int cut[2]) {
    int cuts = 0;
    double ratio = options_is_matched(o) ? sqrt(whole->material[0].k[1] / whole->material[0].k[0]) : 1;
    *half = *whole;
    half->whole = whole;
    half->wall = reduced_wall;
    for (int a = 0; a < 2; a++) {
        double count = a < whole->dim ? (whole->hi[a] - whole->lo[a]) / (a ? o->dx * ratio : o->dx) : 0;
        double pairs = round(count / 2);
        cut[a] = whole->mirror[a] && o->layout == LAYOUT_LATTICE && o->domain == DOMAIN_SYMMETRY && pairs >= 1 &&
                 fabs(count - 2 * pairs) <= 1e-6 * count;
        if (!cut[a]) continue;
        half->lo[a] = (whole->lo[a] + whole->hi[a]) / 2;
        half->side[2 * a] = NEUMANN;
        half->mirror[a] = 0;
        cuts++;
    }
    return cuts;
}

/* A row of the whole domain from one of the part, of length n. */
static void restore_row(const double *part, int n, int cut, double *whole) {
    for (int i = 0; cut && i < n; i++) *whole++ = part[n - 1 - i];
    memcpy(whole, part, (size_t)n * sizeof *whole);
}

/* Mirrors positions to the lower side of the middle between lo and hi. */
static void mirror(double *x, int n, double lo, double hi) {
    for (int i = 0; i < n; i++) x[i] = lo + hi - x[i];
}

static void restore(struct field *f, const struct problem *whole, const int cut[2]) {
    struct field part = *f;
    int copies = (cut[0] ? 2 : 1) * (cut[1] ? 2 : 1);
    f->n = part.n * (size_t)copies;
    f->x = xcalloc(f->n, sizeof *f->x);
    f->y = part.y ? xcalloc(f->n, sizeof *f->y) : NULL;
    f->T = xcalloc(f->n, sizeof *f->T);
    f->weight = part.weight ? xcalloc(f->n, sizeof *f->weight) : NULL;
    for (int a = 0; a < 2; a++) f->shape[a] *= cut[a] ? 2 : 1, f->heat[a] *= copies;
    int nx = part.shape[0], ny = part.shape[1];
    for (int j = 0; j < f->shape[1]; j++) {
        int lower = cut[1] && j < ny, row = !cut[1] ? j : lower ? ny - 1 - j : j - ny;
        size_t to = (size_t)j * (size_t)f->shape[0], from = (size_t)row * (size_t)nx;
        restore_row(part.x + from, nx, cut[0], f->x + to);
        if (cut[0]) mirror(f->x + to, nx, whole->lo[0], whole->hi[0]);
        if (f->y) restore_row(part.y + from, nx, cut[0], f->y + to);
        if (lower) mirror(f->y + to, f->shape[0], whole->lo[1], whole->hi[1]);
        if (f->weight) restore_row(part.weight + from, nx, cut[0], f->weight + to);
        restore_row(part.T + from, nx, cut[0], f->T + to);
    }
    field_free(&part);
}

int symmetry_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                   struct failure *why) {
    struct problem half;
    int cut[2];
    if (symmetry_reduce(p, o, &half, cut)) {
        int status = method_solve(m, &half, o, f, why);
        if (status == STATUS_OK) restore(f, p, cut);
        if (!status_refused(status)) return status; /* the part may be too short for the stencil */
    }
    return method_solve(m, p, o, f, why);
}
