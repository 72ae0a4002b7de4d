/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of text.  The header determines the separator. */
#include "verification/case/formats.h"

#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/samples.h"
#include "verification/text/output.h"
#include "verification/text/number.h"

#include <stdlib.h>
#include <string.h>

enum { CELLS = 256 };

struct cell {
    const char *text;
    size_t length;
};

struct reader {
    FILE *in;
    const struct column_map *wanted;
    struct samples *s;
    char *text; /* the line without its end */
    size_t room, length;
    long line;
    char separator; /* a comma, a semicolon, or a blank for any number of blanks */
    struct cell cell[CELLS];
    int cells;
    char comments[4000];     /* above the first point, each ended by a newline */
    int place[COLUMN_COUNT]; /* index of each column among the cells; -1 if missing */
    int width;               /* cells of a line */
};

static int wrong(const struct reader *t, struct failure *why, const char *what) {
    return refuse(why, STATUS_INPUT, "%.150s, line %ld: %s", t->s->path, t->line, what);
}

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

static void take_comment(struct reader *t) {
    const char *text = t->text + strspn(t->text, "# \t");
    take_said(text, "seconds", &t->s->seconds);
    take_said(text, "steps", &t->s->steps);
    take_said(text, "updates", &t->s->updates);
    if (t->s->n == 0) words_add(t->comments, sizeof t->comments, "%s\n", text);
}

/* Reads the next line that is neither blank nor a comment: 1, 0 at the end of the file, or -1 with *why. */
static int next_line(struct reader *t, struct failure *why) {
    ssize_t read;
    while ((read = getline(&t->text, &t->room, t->in)) >= 0) {
        t->length = (size_t)read;
        t->line++;
        if (output_noted()) return wrong(t, why, "interrupted while it is read"), -1;
        if (memchr(t->text, '\0', t->length)) return wrong(t, why, "a NUL byte: this is no text file"), -1;
        if (t->text[t->length - 1] != '\n')
            return wrong(t, why, "ends without a newline: the file looks cut off; end the last line too"), -1;
        t->length = strcspn(t->text, "\r\n");
        if (t->text[t->length] == '\r' && t->text[t->length + 1] != '\n')
            return wrong(t, why, "a carriage return within the line: end each line with a newline"), -1;
        t->text[t->length] = '\0';
        if (t->line == 1 && strncmp(t->text, "\xEF\xBB\xBF", 3) == 0) {
            t->length -= 3;
            memmove(t->text, t->text + 3, t->length + 1);
        }
        const char *first = t->text + strspn(t->text, " \t");
        if (*first == '#')
            take_comment(t);
        else if (*first)
            return 1;
    }
    if (!ferror(t->in) && !feof(t->in)) xcheck(NULL, t->room, 1); /* a line longer than the memory available */
    return 0;
}

static char separator_of(const char *text) {
    return strchr(text, ';') ? ';' : strchr(text, ',') ? ',' : ' ';
}

/* Reads the cell that starts at `at`, without its blanks and quotes; returns where the next one would start. */
static const char *split_cell(const char *at, char separator, struct cell *cell) {
    at += strspn(at, " \t");
    if (*at == '"' || *at == '\'') {
        const char *end = strchr(at + 1, *at);
        if (end) {
            *cell = (struct cell){at + 1, (size_t)(end - at - 1)};
            return end + 1 + strspn(end + 1, " \t");
        }
    }
    size_t length = separator == ' ' ? strcspn(at, " \t") : strcspn(at, separator == ',' ? "," : ";");
    cell->text = at;
    at += length;
    while (length > 0 && strchr(" \t", cell->text[length - 1])) length--;
    cell->length = length;
    return at;
}

/* Fills t->cell; -1 with *why if there are too many cells. */
static int split(struct reader *t, const char *text, struct failure *why) {
    t->cells = 0;
    for (const char *at = text;; at++) {
        if (t->separator == ' ') at += strspn(at, " \t");
        if (t->separator == ' ' && *at == '\0') return 0;
        if (t->cells == CELLS) return wrong(t, why, "more than 256 columns"), -1;
        at = split_cell(at, t->separator, &t->cell[t->cells++]);
        if (*at == '\0') return 0;
        if (t->separator != ' ' && *at != t->separator) return wrong(t, why, "a quote is followed by more text"), -1;
        if (t->separator == ' ') at--;
    }
}

static int all_numbers(const struct reader *t) {
    double ignored;
    for (int i = 0; i < t->cells; i++)
        if (number_read_printed(t->cell[i].text, t->cell[i].length, &ignored) < 0) return 0;
    return 1;
}

/* Index of a column given by its name or its number; -1 if it is absent, -2 if the name occurs twice. */
static int find(const struct reader *t, const char *name) {
    int found = -1;
    long number;
    for (int i = 0; i < t->cells; i++)
        if (samples_is(t->cell[i].text, t->cell[i].length, name)) found = found == -1 ? i : -2;
    if (found == -1 && number_read_whole(name, t->cells, &number) == 0 && number > 0) found = (int)number - 1;
    return found;
}

static int refuse_header(const struct reader *t, struct failure *why) {
    char header[SAMPLES_HEADER], quoted[48];
    samples_header(t->wanted, t->s->dim, header);
    samples_quote(t->text, strlen(t->text), quoted);
    return refuse(why, STATUS_INPUT,
                  "%.120s, line %ld: '%s' should be the header %s, or --columns name the columns (x=NAME,T=NAME; a "
                  "number for the place)",
                  t->s->path, t->line, quoted, header);
}

/* Locates the coordinates, T and w. w may be missing unless it was named; a rod's y and z are skipped, and the z of a
 * plane may exist. */
static int locate(struct reader *t, struct failure *why) {
    for (int k = 0; k < COLUMN_COUNT; k++) {
        int needed = samples_needs(t->s->dim, k) || (k == COLUMN_W && t->wanted->name[k][0]);
        int used = needed || k == COLUMN_W || t->s->dim > 1;
        const char *name = samples_column_name(t->wanted, k);
        t->place[k] = used ? find(t, name) : -1;
        if (t->place[k] == -2)
            return refuse(why, STATUS_INPUT, "%.150s, line %ld: two columns are called '%s'", t->s->path, t->line,
                          name);
        if (needed && t->place[k] < 0) return refuse_header(t, why);
        t->s->has[k] = t->place[k] >= 0;
    }
    t->width = t->cells;
    return STATUS_OK;
}

/* Whether the text names the coordinates and T and has as many columns as a point; t->cell is then split from it. */
static int is_header(struct reader *t, const char *text, int columns) {
    struct failure ignored;
    t->separator = separator_of(text);
    if (split(t, text, &ignored) || t->cells != columns) return 0;
    for (int k = 0; k < COLUMN_COUNT; k++)
        if (samples_needs(t->s->dim, k) && find(t, samples_column_name(t->wanted, k)) < 0) return 0;
    return 1;
}

/* Reads the header: the first line, or a comment above it; without one the columns are given by their numbers.
 * Returns 1 if the line is already a point. */
static int read_header(struct reader *t, struct failure *why) {
    char separator = t->separator = separator_of(t->text);
    if (split(t, t->text, why)) return -1;
    int point = all_numbers(t), columns = t->cells;
    char *end, *comment = t->comments;
    for (; point && (end = strchr(comment, '\n')); comment = end + 1) {
        *end = '\0';
        if (is_header(t, comment, columns)) break;
    }
    int found = point && end;
    t->separator = separator;
    if (!found && split(t, t->text, why)) return -1;
    if (locate(t, why)) return -1;
    return point;
}

static int read_point(struct reader *t, struct failure *why) {
    if (split(t, t->text, why)) return STATUS_INPUT;
    if (t->cells != t->width)
        return refuse(why, STATUS_INPUT, "%.150s, line %ld: %d column%s where the lines above have %d", t->s->path,
                      t->line, t->cells, t->cells == 1 ? "" : "s", t->width);
    if (t->s->n == t->s->room) samples_grow(t->s);
    for (int k = 0; k < COLUMN_COUNT; k++) {
        if (t->place[k] < 0) continue;
        const struct cell *cell = &t->cell[t->place[k]];
        if (samples_put(t->s, k, cell->text, cell->length, t->line, t->place[k] + 1, why)) return why->status;
    }
    t->s->n++;
    return STATUS_OK;
}

static int read_all(struct reader *t, struct failure *why) {
    int more = next_line(t, why);
    if (more < 0) return STATUS_INPUT;
    if (more == 0) return refuse(why, STATUS_INPUT, "%.150s: comments and no point", t->s->path);
    int point = read_header(t, why);
    if (point < 0) return STATUS_INPUT;
    while (point || (more = next_line(t, why)) > 0) {
        point = 0;
        if (read_point(t, why)) return why->status;
    }
    if (more < 0) return STATUS_INPUT;
    if (t->s->n == 0) return refuse(why, STATUS_INPUT, "%.150s: a header and no point", t->s->path);
    return STATUS_OK;
}

int table_file_read(FILE *in, const struct column_map *c, struct samples *s, struct failure *why) {
    struct reader *t = xcalloc(1, sizeof *t);
    *t = (struct reader){.in = in, .wanted = c, .s = s};
    int status = read_all(t, why);
    free(t->text);
    free(t);
    return status;
}
