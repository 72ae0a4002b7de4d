/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A missing point barely changes a mean.  If the other points form a lattice, its position is known:
 *
 *   rows and columns    There are nx distinct x and ny distinct y, and at least 95 of 100 positions of the
 *                       nx x ny lattice have a point.  Fewer do not form a lattice: eight-node elements fill
 *                       three quarters.  A corner may be missing, as in many codes.
 *   equal spacing h     One gap of 2 h, 3 h, ... is next to two of h; or the gap from a wall to the first of
 *                       three points exceeds 5/4 h while the case has more cells than there are points.
 *                       Graded spacings have several wide gaps in a row.  Two layers may have no point on
 *                       their interface. */
#include "verification/foreign/coverage.h"

#include "solver/problem.h"
#include "solver/status.h"
#include "verification/foreign/samples.h"

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
                  s->path, "xy"[a], at);
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

/* Refuses a position of the nx x ny lattice without a point. */
static int check_places(const struct samples *s, const struct problem *p, double *const x[2], const size_t n[2],
                        struct failure *why) {
    unsigned char *has = xcalloc(n[0] * n[1], 1);
    size_t missing = 0, first = 0;
    for (size_t i = 0; i < s->n; i++) {
        size_t at[2];
        for (int a = 0; a < 2; a++) at[a] = gsl_interp_bsearch(x[a], s->value[a][i], 0, n[a]);
        has[at[1] * n[0] + at[0]] = 1;
    }
    for (size_t c = n[0] * n[1]; c-- > 0;) {
        if (has[c] || (on_wall(p, 0, x[0][c % n[0]]) && on_wall(p, 1, x[1][c / n[0]]))) continue;
        missing++, first = c;
    }
    free(has);
    if (!missing) return STATUS_OK;
    return refuse(why, STATUS_INPUT,
                  "%.150s: %zu point%s missing from %zu columns by %zu rows, at x = %.6g, y = %.6g m%s", s->path,
                  missing, missing == 1 ? " is" : "s are", n[0], n[1], x[0][first % n[0]], x[1][first / n[0]],
                  missing == 1 ? "" : " and elsewhere");
}

int missing_points_check(const struct samples *s, const struct problem *p, const double d[2], struct failure *why) {
    double *x[2] = {NULL, NULL};
    size_t n[2] = {1, 1};
    int status = STATUS_OK;
    if (s->n > MOST) return STATUS_OK;
    for (int a = 0; a < p->dim; a++) {
        x[a] = xcalloc(s->n, sizeof *x[a]);
        n[a] = distinct(s, p, a, x[a]);
    }
    if ((double)s->n >= FULL * (double)n[0] * (double)n[1]) {
        if (p->dim == 2) status = check_places(s, p, x, n, why);
        for (int a = 0; a < p->dim && !status; a++) status = check_axis(s, p, a, x[a], n[a], d[a], why);
    }
    free(x[0]);
    free(x[1]);
    return status;
}
