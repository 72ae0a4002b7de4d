/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points in any order are put into a table of boxes, SIDE distances wide, by a hash of the box's place.  A point is
 * looked for in its own box and, where it is nearer than a distance to the next one (one in 16), in that.  No box has
 * more than (SIDE + 1)^2 points: of one more, two would be the same. */
#include "verification/foreign/points_checks.h"

#include "solver/problem.h"
#include "solver/status.h"
#include "verification/foreign/samples.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { SIDE = 64 };
static const double NEAR = 1e-9; /* of the extent: a coordinate may be a rounded decimal */

static double away(const struct problem *p, int a) {
    return NEAR * (p->hi[a] - p->lo[a]);
}

/* Whether the points stand row by row, or column by column, as most programs write them: each follows the one before
 * along its row, or begins a row further on.  No two are the same then. */
static int are_in_order(const struct samples *s, const struct problem *p) {
    const double *x = s->value[COLUMN_X], *y = s->value[COLUMN_Y];
    int across = s->dim == 2 && s->n > 1 && fabs(y[1] - y[0]) < fabs(x[1] - x[0]) ? 1 : 0;
    if (s->dim == 1) {
        for (size_t i = 1; i < s->n; i++)
            if (x[i] - x[i - 1] <= away(p, 0)) return 0;
        return 1;
    }
    const double *along = s->value[1 - across], step = away(p, 1 - across), next = 2 * away(p, across);
    double row = s->value[across][0];
    for (size_t i = 1; i < s->n; i++) {
        double further = s->value[across][i] - row;
        if (further > next)
            row += further;
        else if (fabs(further) > next / 8 || along[i] - along[i - 1] <= step)
            return 0;
    }
    return 1;
}

static int are_same(const struct samples *s, const struct problem *p, size_t i, size_t j) {
    for (int a = 0; a < s->dim; a++)
        if (fabs(s->value[a][i] - s->value[a][j]) > away(p, a)) return 0;
    return 1;
}

static int refuse_same(const struct samples *s, const struct problem *p, size_t i, size_t j, struct failure *why) {
    return refuse(why, STATUS_INPUT,
                  "%.150s, line %ld: the same point as in line %ld (x = %.9g m%s); one value a point is wanted",
                  s->path, samples_line(s, j), samples_line(s, i), s->value[COLUMN_X][i],
                  p->dim == 1 ? ", for a rod one row of points" : "");
}

/* The slots of a table and what is looked up in it.  A slot has the upper half of a box's hash and, in the lower
 * half, its point, counted from 0, or FREE. */
struct table {
    uint64_t *slot;
    size_t size; /* a power of two */
};

#define FREE UINT64_MAX

struct lookup {
    uint64_t hash[4]; /* of the boxes where the same point may be; the first is the point's own */
    int boxes;
};

enum { AHEAD = 64 }; /* points whose slots are on their way from memory at a time */

static uint64_t hash_of(const int64_t box[2]) {
    uint64_t key = (uint64_t)box[0] * 0x9e3779b97f4a7c15u ^ (uint64_t)box[1] * 0xc2b2ae3d27d4eb4fu;
    return (key ^ key >> 29) * 0xbf58476d1ce4e5b9u;
}

static size_t first_slot(const struct table *t, uint64_t hash) {
    return (size_t)(hash >> 20) & (t->size - 1);
}

static struct lookup prepare(const struct table *t, const struct samples *s, const struct problem *p, size_t i) {
    int64_t own[2] = {0, 0}, side[2] = {0, 0};
    struct lookup l = {.boxes = 0};
    for (int a = 0; a < s->dim; a++) {
        double boxes = (s->value[a][i] - p->lo[a]) / (SIDE * away(p, a)), box = floor(boxes);
        own[a] = (int64_t)box, side[a] = (boxes - box >= 1 - 1.0 / SIDE) - (boxes - box <= 1.0 / SIDE);
    }
    for (int k = 0; k < 4; k++)
        if ((k % 2 == 0 || side[0]) && (k / 2 == 0 || side[1])) {
            uint64_t hash = hash_of((int64_t[2]){own[0] + k % 2 * side[0], own[1] + k / 2 * side[1]});
            __builtin_prefetch(&t->slot[first_slot(t, hash)]);
            l.hash[l.boxes++] = hash;
        }
    return l;
}

/* The point that is the same as point i, or i; point i is in the table then. */
static size_t same_as(struct table *t, const struct samples *s, const struct problem *p, size_t i,
                      const struct lookup *l) {
    size_t at = 0;
    for (int k = l->boxes - 1; k >= 0; k--) /* its own box last: `at` is the free slot there */
        for (at = first_slot(t, l->hash[k]); t->slot[at] != FREE; at = (at + 1) & (t->size - 1)) {
            size_t other = (uint32_t)t->slot[at];
            if ((t->slot[at] ^ l->hash[k]) >> 32 == 0 && are_same(s, p, other, i)) return other;
        }
    t->slot[at] = l->hash[0] >> 32 << 32 | i;
    return i;
}

int same_points_check(const struct samples *s, const struct problem *p, struct failure *why) {
    struct table t = {.size = 2};
    struct lookup l[AHEAD];
    size_t same = 0, i = 0;
    if (are_in_order(s, p)) return STATUS_OK;
    while (t.size < 2 * s->n) t.size *= 2;
    t.slot = xcalloc(t.size, sizeof *t.slot);
    for (size_t k = 0; k < t.size; k++) t.slot[k] = FREE; /* in order, so that each page is asked for once */
    for (; i < s->n; i++) {
        if (i % AHEAD == 0)
            for (size_t k = i; k < i + AHEAD && k < s->n; k++) l[k - i] = prepare(&t, s, p, k);
        if ((same = same_as(&t, s, p, i, &l[i % AHEAD])) != i) break;
    }
    free(t.slot);
    return i < s->n ? refuse_same(s, p, same, i, why) : STATUS_OK;
}
