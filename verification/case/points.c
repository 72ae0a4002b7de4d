/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points from CSV. */
#include "verification/case/points.h"

#include "solver/shape.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/text/number.h"
#include "verification/text/whole_file.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMN_X, COLUMN_Y, COLUMN_Z, COLUMN_DX, COLUMN_DY, COLUMN_DZ, COLUMNS };
static const char *const names[COLUMNS] = {"x", "y", "z", "dx", "dy", "dz"};
static const char *const headers[] = {"", "x", "x,y", "x,y,z"}; /* by dimension */
static const size_t few = 1000;                                 /* points: below this number threads do not pay off */
static const double slack = 1e-9; /* relative to the extent: coordinates on a side may be rounded decimals */

struct line {
    const char *text;
    long number; /* line number in the file, from 1 */
};

struct reader {
    const char *name;
    const struct problem *p;
    struct points *points;
    char *at;           /* start of the next line */
    long line;          /* number of the last line */
    struct line *lines; /* lines with points */
    int place[COLUMNS]; /* column index from 0; -1 if missing */
    int width;          /* number of columns in the header */
};

/* The next line with content, terminated by a NUL; NULL at the end, or on failure with *why. */
static char *next_line(struct reader *r, struct failure *why) {
    while (*r->at) {
        char *line = r->at, *end = strchr(line, '\n');
        r->line++;
        if (!end) {
            refuse(why, STATUS_INPUT, "%.150s, line %ld: no newline at the end; the file may be truncated", r->name,
                   r->line);
            return NULL;
        }
        r->at = end + 1;
        if (end > line && end[-1] == '\r') end--;
        *end = '\0';
        if (r->line == 1 && strncmp(line, "\xEF\xBB\xBF", 3) == 0) line += 3;
        const char *first = line + strspn(line, " \t");
        if (*first != '#' && *first != '\0') return line;
    }
    return NULL;
}

static int is_blank_or_quote(char c) {
    return c == ' ' || c == '\t' || c == '"' || c == '\'';
}

/* The cell that starts at *at, without blanks and quotes. *at moves past its comma, or becomes NULL after the last
 * cell. */
static struct points_text next_cell(const char **at) {
    const char *start = *at, *end = start + strcspn(start, ",");
    *at = *end ? end + 1 : NULL;
    while (start < end && is_blank_or_quote(*start)) start++;
    while (start < end && is_blank_or_quote(end[-1])) end--;
    return (struct points_text){start, (int)(end - start)};
}

static int read_header(struct reader *r, const char *line, struct failure *why) {
    for (int c = 0; c < COLUMNS; c++) r->place[c] = -1;
    for (const char *at = line; at; r->width++) {
        struct points_text cell = next_cell(&at);
        for (int c = 0; c < COLUMNS; c++) {
            if ((size_t)cell.length != strlen(names[c]) || strncmp(cell.start, names[c], (size_t)cell.length))
                continue;
            if (r->place[c] >= 0)
                return refuse(why, STATUS_INPUT, "%.150s, line %ld: two columns are called '%s'", r->name, r->line,
                              names[c]);
            r->place[c] = r->width;
        }
    }
    for (int a = 0; a < r->p->dim; a++)
        if (r->place[a] < 0)
            return refuse(why, STATUS_INPUT,
                          "%.150s, line %ld: '%.60s' has no column %s; the header is %s, separated by commas",
                          r->name, r->line, line, names[a], headers[r->p->dim]);
    return STATUS_OK;
}

static int read_number(const struct reader *r, long line, int column, struct points_text cell, double *value,
                       struct failure *why) {
    if (cell.length > 0 && number_read_printed(cell.start, (size_t)cell.length, value) == 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "%.150s, line %ld, column %d (%s): '%.*s' is not a finite number", r->name, line,
                  r->place[column] + 1, names[column], cell.length < 40 ? cell.length : 40, cell.start);
}

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

static int read_point(const struct reader *r, size_t i, struct failure *why) {
    struct points *points = r->points;
    struct points_text cell[COLUMNS] = {{0}};
    double *x = points->x[i];
    char at_text[80];
    long line = r->lines[i].number;
    int width = 0;
    for (const char *at = r->lines[i].text; at; width++) {
        struct points_text next = next_cell(&at);
        for (int c = 0; c < COLUMNS; c++)
            if (r->place[c] == width) cell[c] = next;
    }
    if (width != r->width)
        return refuse(why, STATUS_INPUT, "%.150s, line %ld: %d column%s, the header has %d", r->name, line, width,
                      width == 1 ? "" : "s", r->width);
    for (int a = 0; a < points->dim; a++) {
        points->typed[i][a] = cell[a];
        if (read_number(r, line, a, cell[a], &x[a], why)) return why->status;
        int inside = check_inside(r->p, a, &x[a]);
        if (inside > 0) points->typed[i][a].length = 0;
        if (inside < 0)
            return refuse(why, STATUS_INPUT, "%.150s, line %ld, column %d (%s): %.*s m is outside %g to %g m",
                          r->name, line, r->place[a] + 1, names[a], cell[a].length < 40 ? cell[a].length : 40,
                          cell[a].start, r->p->lo[a], r->p->hi[a]);
    }
    if (!is_in_shape(r->p, x)) {
        write_point(r->p->dim, x, at_text);
        return refuse(why, STATUS_INPUT, "%.150s, line %ld: %s m is outside the %s", r->name, line, at_text,
                      r->p->shape->name);
    }
    for (int a = 0; a < points->dim && points->cell; a++) {
        int c = r->place[COLUMN_DX + a] >= 0 ? COLUMN_DX + a : COLUMN_DX;
        double *extent = &points->cell[i][a];
        if (read_number(r, line, c, cell[c], extent, why)) return why->status;
        if (*extent < 0)
            return refuse(why, STATUS_INPUT, "%.150s, line %ld, column %d (%s): %g m: a cell's extent is 0 or more",
                          r->name, line, r->place[c] + 1, names[c], *extent);
    }
    return STATUS_OK;
}

static int list_lines(struct reader *r, struct failure *why) {
    size_t room = 0, n = 0;
    for (const char *text; (text = next_line(r, why)) != NULL; n++) {
        if (n == room) {
            room = room ? 2 * room : 1024;
            r->lines = xgrow(r->lines, n, room, sizeof *r->lines);
        }
        r->lines[n] = (struct line){text, r->line};
    }
    r->points->n = n;
    return why->status;
}

/* Reads the points of all lines; reports the first failure. */
static int read_points(const struct reader *r, struct failure *why) {
    struct points *points = r->points;
    size_t n = points->n, bad = n;
    points->x = xcalloc(n, sizeof *points->x);
    points->typed = xcalloc(n, sizeof *points->typed);
    if (r->place[COLUMN_DX] >= 0) points->cell = xcalloc(n, sizeof *points->cell);
#pragma omp parallel for reduction(min : bad) if (n > few)
    for (size_t i = 0; i < n; i++) {
        struct failure ignored;
        if (i < bad && read_point(r, i, &ignored)) bad = i;
    }
    return bad < n ? read_point(r, bad, why) : STATUS_OK;
}

static int read_lines(struct reader *r, struct failure *why) {
    const char *line = next_line(r, why);
    if (why->status) return why->status;
    if (!line)
        return refuse(why, STATUS_INPUT, "%.150s: empty; must start with the header %s", r->name, headers[r->p->dim]);
    if (read_header(r, line, why) || list_lines(r, why)) return why->status;
    if (r->points->n == 0) return refuse(why, STATUS_INPUT, "%.150s: a header without points", r->name);
    return read_points(r, why);
}

int points_read(FILE *in, const char *name, const struct problem *p, struct points *points, struct failure *why) {
    size_t size;
    *why = (struct failure){0};
    *points = (struct points){.dim = p->dim, .text = whole_file_read(in, &size)};
    struct reader r = {.name = name, .p = p, .points = points, .at = points->text};
    if (ferror(in))
        refuse(why, STATUS_INPUT, "%.150s: %s", name, strerror(errno));
    else if (memchr(points->text, '\0', size))
        refuse(why, STATUS_INPUT, "%.150s: has a NUL byte; it is not a text file", name);
    else
        read_lines(&r, why);
    free(r.lines);
    if (why->status) points_free(points);
    return why->status;
}

int points_one(const struct problem *p, const double *x, struct points *points, struct failure *why) {
    *points = (struct points){.dim = p->dim,
                              .n = 1,
                              .x = xcalloc(1, sizeof *points->x),
                              .typed = xcalloc(1, sizeof *points->typed),
                              .text = xcalloc(DIM_MAX, 32)};
    char at[80];
    for (int a = 0; a < p->dim; a++) {
        char *typed = points->text + 32 * a;
        points->x[0][a] = x[a];
        points->typed[0][a] = (struct points_text){typed, snprintf(typed, 32, "%.17g", x[a])};
        int inside = check_inside(p, a, &points->x[0][a]);
        if (inside > 0) points->typed[0][a].length = 0;
        if (inside >= 0) continue;
        points_free(points);
        write_point(p->dim, x, at);
        if (p->dim == 1) return refuse(why, STATUS_INPUT, "--at %s: outside %g to %g m", at, p->lo[0], p->hi[0]);
        return refuse(why, STATUS_INPUT, "--at %s: %c is outside %g to %g m", at, "xyz"[a], p -> lo[a], p -> hi[a]);
    }
    if (is_in_shape(p, x)) return STATUS_OK;
    points_free(points);
    write_point(p->dim, x, at);
    return refuse(why, STATUS_INPUT, "--at %s: outside the %s", at, p->shape->name);
}

void points_free(struct points *points) {
    free(points->x);
    free(points->cell);
    free(points->typed);
    free(points->text);
    *points = (struct points){0};
}
