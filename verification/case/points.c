/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points of a table. */
#include "verification/case/points.h"

#include "solver/shape.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/text/number.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[] = {"x", "y", "z", "dx", "dy", "dz"};
static const char *const headers[] = {"", "x", "x,y", "x,y,z"}; /* by dimension */
static const size_t FEW = 1000;                                 /* points: below this number threads do not pay off */
static const double slack = 1e-9; /* relative to the extent: coordinates on a side may be rounded decimals */

/* Moves a coordinate within round-off of a side, inside or outside, onto it, as for mesh nodes.  Returns -1 if it is
 * outside, and 1 if it moved by more than rounding, so that the output must show the new value. */
static int check_inside(const struct problem *p, int axis, double *x) {
    double lo = p->lo[axis], hi = p->hi[axis], away = slack * (hi - lo), given = *x;
    if (!(*x >= lo - away && *x <= hi + away)) return -1;
    if (fabs(*x - lo) <= away) *x = lo;
    if (fabs(*x - hi) <= away) *x = hi;
    return fabs(*x - given) > 4 * DBL_EPSILON * (fabs(lo) + fabs(hi));
}

/* 1 if a point is in a round body, within the same tolerance. */
static int is_in_shape(const struct problem *p, const double *x) {
    return !p->shape || shape_depth(p, x) >= -slack * p->radius[1];
}

/* "x,y,z" */
static void write_point(int dim, const double *x, char text[80]) {
    *text = '\0';
    for (int a = 0; a < dim; a++) words_add(text, 80, "%s%.12g", a ? "," : "", x[a]);
}

/* Moves point i onto a side that it is next to.  Refuses a point that is outside, or a negative extent. */
static int place_point(struct points *points, size_t i, const struct problem *p, struct failure *why) {
    double *x = points->x[i];
    for (int a = 0; a < points->dim; a++) {
        int inside = check_inside(p, a, &x[a]);
        if (inside > 0) points->typed[i][a].length = 0;
        if (inside < 0) return refuse(why, STATUS_INPUT, "%s is outside %g to %g m", names[a], p->lo[a], p->hi[a]);
        if (points->cell && points->cell[i][a] < 0)
            return refuse(why, STATUS_INPUT, "the extent %g m of a cell is below 0", points->cell[i][a]);
    }
    return is_in_shape(p, x) ? STATUS_OK : refuse(why, STATUS_INPUT, "outside the %s", p->shape->name);
}

/* Refuses the first of the points that is wrong. */
static int place_points(struct points *points, const struct problem *p, struct failure *why) {
    const struct rows *r = &points->rows;
    struct failure own;
    size_t n = points->n, bad = n;
    char at[80];
#pragma omp parallel for reduction(min : bad) private(own) if (n > FEW)
    for (size_t i = 0; i < n; i++)
        if (i < bad && place_point(points, i, p, &own)) bad = i;
    if (bad == n) return STATUS_OK;
    place_point(points, bad, p, &own);
    write_point(points->dim, points->x[bad], at);
    return refuse(why, STATUS_INPUT, "%.150s, line %ld: (%s) m: %.200s", r->name, r->line[bad + 1].number, at,
                  own.text);
}

static int read_rows(struct points *points, const struct problem *p, struct failure *why) {
    const struct rows *r = &points->rows;
    struct rows_cell cell[ROWS_CELLS];
    struct rows_column column[2 * DIM_MAX];
    if (r->count == 0)
        return refuse(why, STATUS_INPUT, "%.150s: empty; must start with the header %s", r->name, headers[p->dim]);
    char separator = rows_separator(r->line->text), quoted[48];
    int width = rows_split(r, r->line, separator, cell, why), place[2 * DIM_MAX];
    if (width < 0) return why->status;
    for (int k = 0; k < 2 * DIM_MAX; k++)
        if ((place[k] = rows_find(r, r->line, cell, width, names[k], why)) == -2) return why->status;
    for (int a = 0; a < p->dim; a++)
        if (place[a] < 0)
            return refuse(why, STATUS_INPUT, "%.150s, line %ld: '%s' has no column %s; the header is %s", r->name,
                          r->line->number, rows_quote(r->line->text, strlen(r->line->text), quoted), names[a],
                          headers[p->dim]);
    size_t n = points->n = r->count - 1;
    if (n == 0) return refuse(why, STATUS_INPUT, "%.150s: a header without points", r->name);
    points->x = xcalloc(n, sizeof *points->x);
    points->typed = xcalloc(n, sizeof *points->typed);
    if (place[DIM_MAX] >= 0) points->cell = xcalloc(n, sizeof *points->cell);
    for (int a = 0; a < p->dim; a++) {
        int extent = place[DIM_MAX + a] >= 0 ? DIM_MAX + a : DIM_MAX; /* dy and dz are dx where they are not given */
        column[2 * a] = (struct rows_column){names[a], place[a], DIM_MAX, &points->x[0][a], &points->typed[0][a]};
        column[2 * a + 1] = (struct rows_column){names[extent], points->cell ? place[extent] : -1, DIM_MAX,
                                                 points->cell ? &points->cell[0][a] : NULL, NULL};
    }
    if (rows_numbers(r, 1, separator, width, column, 2 * p->dim, why)) return why->status = STATUS_INPUT;
    return place_points(points, p, why);
}

int points_read(FILE *in, const char *name, const struct problem *p, struct points *points, struct failure *why) {
    *points = (struct points){.dim = p->dim};
    int status = rows_read(in, name, &points->rows, why);
    if (!status) status = read_rows(points, p, why);
    if (status) points_free(points);
    return status;
}

int points_one(const struct problem *p, const double *x, struct points *points, struct failure *why) {
    char *text = xcalloc(DIM_MAX, NUMBER_PRINTED), at[80];
    struct failure own;
    *points = (struct points){.dim = p->dim,
                              .n = 1,
                              .x = xcalloc(1, sizeof *points->x),
                              .typed = xcalloc(1, sizeof *points->typed),
                              .rows.text = text};
    for (int a = 0; a < p->dim; a++, text += NUMBER_PRINTED) {
        points->x[0][a] = x[a];
        points->typed[0][a] = (struct rows_cell){text, (size_t)snprintf(text, NUMBER_PRINTED, "%.17g", x[a])};
    }
    if (!place_point(points, 0, p, &own)) return STATUS_OK;
    points_free(points);
    write_point(p->dim, x, at);
    return refuse(why, STATUS_INPUT, "--at %s: %.200s", at, own.text);
}

void points_free(struct points *points) {
    free(points->x);
    free(points->cell);
    free(points->typed);
    rows_free(&points->rows);
    *points = (struct points){0};
}
