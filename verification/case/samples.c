/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points of a file, from a table or NumPy's .npy. */
#include "verification/case/samples.h"

#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/npy_file.h"
#include "verification/case/rows.h"
#include "verification/text/number.h"

#include <errno.h>
#include <fcntl.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const off_t MOST = 2000000000; /* bytes of an answer: about 3e7 points of 17 digits */
static const char *const names[COLUMN_COUNT] = {"x", "y", "z", "T", "w"};

const char *samples_column_name(const struct column_map *c, int column) {
    return c->name[column][0] ? c->name[column] : names[column];
}

int samples_needs(const struct column_map *c, int dim, int column) {
    return column < dim || column == COLUMN_T || (column == COLUMN_W && c->name[column][0]);
}

static int read_one(const char *text, size_t length, struct column_map *c, struct failure *why) {
    for (int k = 0; k < COLUMN_COUNT; k++) {
        if (length < 3 || strncmp(text, names[k], 1) != 0 || text[1] != '=') continue;
        if (c->name[k][0]) return refuse(why, STATUS_INPUT, "--columns: %s is given twice", names[k]);
        if (length - 2 >= COLUMN_NAME)
            return refuse(why, STATUS_INPUT, "--columns '%.60s': a name of more than %d letters", text,
                          COLUMN_NAME - 1);
        memcpy(c->name[k], text + 2, length - 2);
        return STATUS_OK;
    }
    return refuse(why, STATUS_INPUT,
                  "--columns '%.60s': must be of x=NAME, y=NAME, z=NAME, T=NAME, w=NAME, with commas between", text);
}

int samples_columns_read(const char *map, struct column_map *c, struct failure *why) {
    *c = (struct column_map){.text = map};
    for (const char *at = map;; at++) {
        size_t length = strcspn(at, ",");
        if (read_one(at, length, c, why)) return STATUS_INPUT;
        at += length;
        if (*at == '\0') return STATUS_OK;
    }
}

void samples_free(struct samples *s) {
    for (int k = 0; k < COLUMN_COUNT; k++) free(s->value[k]);
    free(s->line);
    *s = (struct samples){0};
}

const double *samples_point(const struct samples *s, size_t i, double x[3]) {
    for (int a = 0; a < 3; a++) x[a] = a < s->dim ? s->value[a][i] : 0;
    return x;
}

long samples_line(const struct samples *s, size_t i) {
    return s->line ? s->line[i] : (long)i + 1;
}

const char *samples_place(const struct samples *s, size_t i, char text[SAMPLES_PLACE]) {
    *text = '\0';
    for (int a = 0; a < s->dim; a++)
        words_add(text, SAMPLES_PLACE, "%s%c = %.9g", a ? ", " : "", "xyz"[a], s -> value[a][i]);
    return text;
}

int samples_scale_weights(struct samples *s, struct failure *why) {
    double *w = s->value[COLUMN_W], largest = 0;
    for (size_t i = 0; i < s->n && w; i++) {
        if (!(w[i] >= 0))
            return refuse(why, STATUS_INPUT, "%.150s, line %ld: w = %g; a weight must be 0 or more", s->path,
                          samples_line(s, i), w[i]);
        largest = fmax(largest, w[i]);
    }
    if (w && !(largest > 0))
        return refuse(why, STATUS_INPUT, "%.150s: all weights w are 0; a norm needs some above", s->path);
    for (size_t i = 0; i < s->n && w; i++) {
        double scaled = scalbn(w[i], -ilogb(largest));
        if (w[i] > 0 && scaled < DBL_MIN)
            return refuse(why, STATUS_INPUT,
                          "%.150s, line %ld: w = %g beside a largest of %g: weights may differ by up to 1e307",
                          s->path, samples_line(s, i), w[i], largest);
        w[i] = scaled;
    }
    return STATUS_OK;
}

/* ---- Tables ---- */

/* Reads a cost reported in a comment, if it is a number. */
static void take_said(const char *text, const char *name, double *value) {
    size_t length = strlen(name);
    double said;
    if (strncmp(text, name, length) != 0) return;
    text += length + strspn(text + length, " \t");
    if (*text++ != '=') return;
    text += strspn(text, " \t");
    if (number_read_printed(text, strcspn(text, " \t,;"), &said) == 0 && said >= 0) *value = said;
}

/* The header of a table, or its first row where the columns are given by their numbers. */
struct header {
    const struct rows_line *line;
    int columns, point; /* point: 1 if the first row is a point already */
    struct rows_cell cell[ROWS_CELLS];
};

/* The place of a column given by its name or its number; -1 for none, -2 with *why for two. */
static int find(const struct rows *r, const struct header *h, const char *name, struct failure *why) {
    long number;
    int found = rows_find(r, h->line, h->cell, h->columns, name, why);
    return found == -1 && number_read_whole(name, h->columns, &number) == 0 ? (int)number - 1 : found;
}

static int are_numbers(const struct header *h) {
    double ignored;
    for (int i = 0; i < h->columns; i++)
        if (number_read_printed(h->cell[i].text, h->cell[i].length, &ignored) < 0) return 0;
    return 1;
}

/* Whether a comment names the coordinates and T, and has as many columns as a point. */
static int is_header(const struct rows *r, const struct rows_line *comment, const struct column_map *c, int dim,
                     int columns, struct header *h) {
    struct failure ignored;
    h->line = comment;
    h->columns = rows_split(r, comment, rows_separator(comment->text), h->cell, &ignored);
    if (h->columns != columns) return 0;
    for (int k = 0; k <= COLUMN_T; k++)
        if (samples_needs(c, dim, k) && find(r, h, samples_column_name(c, k), &ignored) < 0) return 0;
    return 1;
}

/* Finds the header: the first line, or a comment above it. */
static int find_header(const struct rows *r, const struct column_map *c, int dim, struct header *h,
                       struct failure *why) {
    const struct rows_line *first = r->line;
    struct header own = {.line = first};
    own.columns = rows_split(r, first, rows_separator(first->text), own.cell, why);
    if (own.columns < 0) return why->status;
    own.point = are_numbers(&own);
    h->point = 1;
    for (size_t i = 0; own.point && i < r->comments && r->comment[i].number < first->number; i++)
        if (is_header(r, &r->comment[i], c, dim, own.columns, h)) return STATUS_OK;
    *h = own;
    return STATUS_OK;
}

static int refuse_header(const struct rows *r, const struct column_map *c, int dim, struct failure *why) {
    char header[4 * COLUMN_NAME + 8] = "", quoted[48];
    for (int k = 0; k <= COLUMN_T; k++)
        if (samples_needs(c, dim, k))
            words_add(header, sizeof header, "%s%s", k ? "," : "", samples_column_name(c, k));
    return refuse(why, STATUS_INPUT,
                  "%.120s, line %ld: '%s' should be the header %s, or --columns name the columns (x=NAME,T=NAME; a "
                  "number for the place)",
                  r->name, r->line->number, rows_quote(r->line->text, strlen(r->line->text), quoted), header);
}

/* w may be missing unless it was named; a rod's y and z are skipped, and the z of a plane may exist. */
static int read_points(const struct rows *r, const struct column_map *c, struct samples *s, struct failure *why) {
    struct header h;
    struct rows_column column[COLUMN_COUNT];
    if (find_header(r, c, s->dim, &h, why)) return why->status;
    size_t first = h.point ? 0 : 1, n = r->count - first;
    for (int k = 0; k < COLUMN_COUNT; k++) {
        int needed = samples_needs(c, s->dim, k), used = needed || k == COLUMN_W || s->dim > 1;
        int place = used ? find(r, &h, samples_column_name(c, k), why) : -1;
        if (place == -2) return why->status;
        if (needed && place < 0) return refuse_header(r, c, s->dim, why);
        if (place >= 0) s->value[k] = xcalloc(n, sizeof *s->value[k]);
        column[k] = (struct rows_column){names[k], place, 1, s->value[k], NULL};
    }
    if (n == 0) return refuse(why, STATUS_INPUT, "%.150s: a header and no point", r->name);
    s->n = n;
    s->line = xcalloc(n, sizeof *s->line);
    for (size_t i = 0; i < n; i++) s->line[i] = r->line[first + i].number;
    return rows_numbers(r, first, rows_separator(r->line->text), h.columns, column, COLUMN_COUNT, why);
}

static int read_table(FILE *in, const struct column_map *c, struct samples *s, struct failure *why) {
    struct rows r;
    int status = rows_read(in, s->path, &r, why);
    for (size_t i = 0; i < r.comments; i++) {
        take_said(r.comment[i].text, "seconds", &s->seconds);
        take_said(r.comment[i].text, "steps", &s->steps);
        take_said(r.comment[i].text, "updates", &s->updates);
    }
    if (!status && r.count == 0) status = refuse(why, STATUS_INPUT, "%.150s: comments and no point", s->path);
    if (!status) status = read_points(&r, c, s, why);
    rows_free(&r);
    return status;
}

/* ---- Files ---- */

/* A code in three dimensions that computes a plane as a thin box answers with one layer. */
static int check_layer(const struct samples *s, struct failure *why) {
    const double *z = s->value[COLUMN_Z];
    for (size_t i = 1; i < s->n && s->dim == 2 && z; i++)
        if (z[i] != z[0])
            return refuse(
                why, STATUS_INPUT,
                "%.150s, line %ld: z = %.9g m, but %.9g m above: the case is in the plane; answer x,y,T with "
                "one layer of the body",
                s->path, samples_line(s, i), z[i], z[0]);
    return STATUS_OK;
}

/* Opens a regular file, not a link; NULL with *why if it is not one. */
static FILE *open_regular(const char *path, const char *name, struct failure *why) {
    struct stat is;
    int file = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0 && errno == ELOOP)
        refuse(why, STATUS_INPUT, "%.200s: a link; the answer must be a file itself", name);
    else if (file < 0 && errno == ENOENT)
        refuse(why, STATUS_INPUT, "%.200s: no such file; the program left no answer", name);
    else if (file < 0)
        refuse(why, STATUS_INPUT, "%.200s: %s", name, strerror(errno));
    else if (fstat(file, &is) || !S_ISREG(is.st_mode))
        refuse(why, STATUS_INPUT, "%.200s: a %s; the answer must be a regular file", name,
               S_ISDIR(is.st_mode) ? "directory" : "device or pipe");
    else if (is.st_size > MOST)
        refuse(why, STATUS_INPUT, "%.200s: %.3g GB; an answer may have %g GB", name, (double)is.st_size * 1e-9,
               (double)MOST * 1e-9);
    else if (is.st_size == 0)
        refuse(why, STATUS_INPUT, "%.200s: empty; the answer must be a table of points", name);
    else
        return xcheck(fdopen(file, "r"), 1, BUFSIZ);
    if (file >= 0) close(file);
    return NULL;
}

int samples_read(const char *path, const char *name, int dim, const struct column_map *c, struct samples *s,
                 struct failure *why) {
    char start[NPY_FILE_START];
    *s = (struct samples){.path = name, .dim = dim, .seconds = NAN, .steps = NAN, .updates = NAN};
    FILE *in = open_regular(path, name, why);
    if (!in) return STATUS_INPUT;
    size_t n = fread(start, 1, sizeof start, in);
    rewind(in);
    int status = (npy_file_is(start, n) ? npy_file_read : read_table)(in, c, s, why);
    fclose(in);
    if (!status) status = check_layer(s, why);
    if (status) samples_free(s);
    return status;
}
