/* Symmetry: no more is computed than half of a rod or a quarter of a square.
 *
 * Where initial data, coefficients and sides are even about a plane, so is the solution, and no heat crosses the
 * plane: an insulated side.  On a lattice with an even number of particles across, the plane lies midway between two
 * of them, where the even ghosts of an insulated side are the very particles that were left out: the discrete
 * solution is the same, to rounding. */
#include "verification/fold.h"

#include <math.h>
#include <stdlib.h>

static double folded_wall(const struct problem *p, enum side s, const double x[2]) {
    int a = (int)s / 2, inner = s % 2 == 0 && p->lo[a] != p->whole->lo[a];
    return inner ? 0 : p->whole->wall(p->whole, s, x);
}

int fold_problem(const struct problem *whole, const struct options *o, struct problem *half, int cut[2]) {
    int cuts = 0;
    double ratio = o->stepper == STEPPER_MATCHED ? sqrt(whole->material[0].k[1] / whole->material[0].k[0]) : 1;
    *half = *whole;
    half->whole = whole;
    half->wall = folded_wall;
    for (int a = 0; a < 2; a++) {
        double count = a < whole->dim ? (whole->hi[a] - whole->lo[a]) / (a ? o->dx * ratio : o->dx) : 0;
        double pairs = round(count / 2);
        cut[a] = whole->mirror[a] && o->layout == LAYOUT_LATTICE && o->domain == DOMAIN_FOLDED && pairs >= 1 &&
                 fabs(count - 2 * pairs) <= 1e-6 * count;
        if (!cut[a]) continue;
        half->lo[a] = (whole->lo[a] + whole->hi[a]) / 2;
        half->side[2 * a] = NEUMANN;
        half->mirror[a] = 0;
        cuts++;
    }
    return cuts;
}

/* The particle of the part that stands for (i, j) of the whole, n[a] particles along the axes of the part. */
static size_t source(const int n[2], const int cut[2], int i, int j) {
    if (cut[0]) i = i < n[0] ? n[0] - 1 - i : i - n[0];
    if (cut[1]) j = j < n[1] ? n[1] - 1 - j : j - n[1];
    return (size_t)j * (size_t)n[0] + (size_t)i;
}

static void unfold(struct field *f, const struct problem *whole, const int cut[2]) {
    struct field part = *f;
    int copies = (cut[0] ? 2 : 1) * (cut[1] ? 2 : 1);
    *f = part;
    f->n = part.n * (size_t)copies;
    f->x = xcalloc(f->n, sizeof *f->x);
    f->y = part.y ? xcalloc(f->n, sizeof *f->y) : NULL;
    f->T = xcalloc(f->n, sizeof *f->T);
    f->weight = part.weight ? xcalloc(f->n, sizeof *f->weight) : NULL;
    for (int a = 0; a < 2; a++) f->shape[a] *= cut[a] ? 2 : 1, f->heat[a] *= copies;
    for (int j = 0; j < f->shape[1]; j++)
        for (int i = 0; i < f->shape[0]; i++) {
            size_t to = (size_t)j * (size_t)f->shape[0] + (size_t)i, from = source(part.shape, cut, i, j);
            int lower[2] = {cut[0] && i < part.shape[0], cut[1] && j < part.shape[1]};
            f->x[to] = lower[0] ? whole->lo[0] + whole->hi[0] - part.x[from] : part.x[from];
            if (f->y) f->y[to] = lower[1] ? whole->lo[1] + whole->hi[1] - part.y[from] : part.y[from];
            if (f->weight) f->weight[to] = part.weight[from];
            f->T[to] = part.T[from];
        }
    field_free(&part);
}

int fold_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
               struct failure *why) {
    struct problem half;
    int cut[2];
    if (fold_problem(p, o, &half, cut)) {
        int status = m->solve(&half, o, f, why);
        if (status == STATUS_OK) unfold(f, p, cut);
        if (status != STATUS_INPUT) return status; /* refused: the part may be too short for the stencil */
    }
    return m->solve(p, o, f, why);
}
