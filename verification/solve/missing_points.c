/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A missing point barely changes a mean.  If the other points form a lattice, its position is known:
 *
 *   rows and columns    There are nx distinct x and ny distinct y (and nz distinct z), and at least 95 of 100
 *                       positions of the nx x ny (x nz) lattice have a point.  Fewer do not form a lattice:
 *                       eight-node elements fill three quarters.  Places on two walls, a corner of a rectangle or
 *                       an edge of a box, may be missing, as in many codes.
 *   equal spacing h     One gap of 2 h, 3 h, ... is next to two of h; or the gap from a wall to the first of
 *                       three points exceeds 5/4 h while the case has more cells than there are points.
 *                       Graded spacings have several wide gaps in a row.  Two layers may have no point on
 *                       their interface. */
#include "verification/solve/coverage.h"

#include "solver/problem.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/samples.h"

#include <gsl/gsl_interp.h>
#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 200000 };             /* points; sorting more takes too long */
static const double SAME = 1e-9;    /* relative to the extent: a coordinate may be a rounded decimal */
static const double FULL = 0.95;    /* fraction of the positions of a lattice */
static const double REGULAR = 1e-3; /* relative to h: printed with few digits */

/* Sorts the distinct coordinates along an axis into x[s->n] and returns their number. */
static size_t distinct(const struct samples *s, const struct problem *p, int a, double *x) {
    double away = SAME * (p->hi[a] - p->lo[a]);
    size_t n = 0;
    memcpy(x, s->value[a], s->n * sizeof *x);
    gsl_sort(x, 1, s->n);
    for (size_t i = 0; i < s->n; i++)
        if (n == 0 || x[i] > x[n - 1] + away) x[n++] = x[i];
    return n;
}

static int is_regular(const double *x, double h) {
    return fabs(x[1] - x[0] - h) <= REGULAR * h;
}

static int refuse_gap(const struct samples *s, int a, double at, struct failure *why) {
    return refuse(why, STATUS_INPUT, "%.150s: a point is missing at %c = %.6g m, between others at equal distances",
                  s->path, "xyz"[a], at);
}

/* Refuses a gap among n coordinates along an axis that are otherwise equidistant; d is the spacing of the case. */
static int check_axis(const struct samples *s, const struct problem *p, int a, const double *x, size_t n, double d,
                      struct failure *why) {
    static const double FROM_WALL = 1.25;
    if (n < 5) return STATUS_OK;
    double first = x[1] - x[0], last = x[n - 1] - x[n - 2];
    int few = (double)n < nearbyint((p->hi[a] - p->lo[a]) / d);
    if (few && is_regular(x + 1, first) && x[0] - p->lo[a] > FROM_WALL * first)
        return refuse_gap(s, a, x[0] - first, why);
    if (few && is_regular(x + n - 3, last) && p->hi[a] - x[n - 1] > FROM_WALL * last)
        return refuse_gap(s, a, x[n - 1] + last, why);
    for (size_t i = 0; i + 1 < n; i++) {
        size_t before = i > 0 ? i - 1 : i + 2,
               after = i + 2 < n ? i + 1 : i - 2; /* at an end both are on the same side */
        double h = x[before + 1] - x[before], gap = x[i + 1] - x[i], times = nearbyint(gap / h);
        int across = a == 0 && p->materials == 2 && x[i] < p->interface && p->interface < x[i + 1];
        if (times >= 2 && fabs(gap - times * h) <= REGULAR * h && is_regular(x + after, h) && !across)
            return refuse_gap(s, a, x[i] + h, why);
    }
    return STATUS_OK;
}

static int on_wall(const struct problem *p, int a, double x) {
    double away = SAME * (p->hi[a] - p->lo[a]);
    return fabs(x - p->lo[a]) <= away || fabs(x - p->hi[a]) <= away;
}

/* The coordinates of a position of the lattice; returns the number of walls that it is on. */
static int place(const struct problem *p, double *const x[DIM_MAX], const size_t n[DIM_MAX], size_t c,
                 double at[DIM_MAX]) {
    int walls = 0;
    for (int a = 0; a < p->dim; c /= n[a++]) {
        at[a] = x[a][c % n[a]];
        walls += on_wall(p, a, at[a]);
    }
    return walls;
}

/* Refuses a position of the lattice without a point. */
static int check_places(const struct samples *s, const struct problem *p, double *const x[DIM_MAX],
                        const size_t n[DIM_MAX], struct failure *why) {
    size_t all = n[0] * n[1] * n[2], missing = 0, first = 0;
    unsigned char *has = xcalloc(all, 1);
    double at[DIM_MAX];
    char layers[30] = "", where[100] = "";
    for (size_t i = 0; i < s->n; i++) {
        size_t c = 0;
        for (int a = p->dim; a-- > 0;) c = c * n[a] + gsl_interp_bsearch(x[a], s->value[a][i], 0, n[a]);
        has[c] = 1;
    }
    for (size_t c = all; c-- > 0;)
        if (!has[c] && place(p, x, n, c, at) < 2) missing++, first = c;
    free(has);
    if (!missing) return STATUS_OK;
    place(p, x, n, first, at);
    if (p->dim == 3) snprintf(layers, sizeof layers, " by %zu layers", n[2]);
    for (int a = 0; a < p->dim; a++) words_add(where, sizeof where, "%s%c = %.6g", a ? ", " : "", "xyz"[a], at[a]);
    return refuse(why, STATUS_INPUT, "%.150s: %zu point%s missing from %zu columns by %zu rows%s, at %s m%s", s->path,
                  missing, missing == 1 ? " is" : "s are", n[0], n[1], layers, where,
                  missing == 1 ? "" : " and elsewhere");
}

int missing_points_check(const struct samples *s, const struct problem *p, const double *d, struct failure *why) {
    double *x[DIM_MAX] = {NULL};
    size_t n[DIM_MAX] = {1, 1, 1};
    int status = STATUS_OK;
    if (s->n > MOST) return STATUS_OK;
    for (int a = 0; a < p->dim; a++) {
        x[a] = xcalloc(s->n, sizeof *x[a]);
        n[a] = distinct(s, p, a, x[a]);
    }
    if ((double)s->n >= FULL * (double)n[0] * (double)n[1] * (double)n[2]) {
        if (p->dim > 1) status = check_places(s, p, x, n, why);
        for (int a = 0; a < p->dim && !status; a++) status = check_axis(s, p, a, x[a], n[a], d[a], why);
    }
    for (int a = 0; a < p->dim; a++) free(x[a]);
    return status;
}
