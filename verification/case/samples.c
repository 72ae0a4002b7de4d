/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Common parts of the readers of all formats: names, arrays, one value, and the type of a file. */
#include "verification/case/samples.h"

#include "solver/status.h"
#include "solver/words.h"
#include "verification/text/number.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static const off_t MOST = 2000000000; /* bytes of an answer: about 3e7 points of 17 digits */
static const char *const names[COLUMN_COUNT] = {"x", "y", "z", "T", "w"};

const char *samples_column_name(const struct column_map *c, int column) {
    return c->name[column][0] ? c->name[column] : names[column];
}

int samples_needs(int dim, int column) {
    return column < dim || column == COLUMN_T;
}

void samples_header(const struct column_map *c, int dim, char text[SAMPLES_HEADER]) {
    *text = '\0';
    for (int k = 0; k < COLUMN_COUNT; k++)
        if (samples_needs(dim, k)) words_add(text, SAMPLES_HEADER, "%s%s", k ? "," : "", samples_column_name(c, k));
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

void samples_reserve(struct samples *s, size_t room) {
    for (int k = 0; k < COLUMN_COUNT; k++)
        if (s->has[k]) s->value[k] = xcalloc(room, sizeof *s->value[k]);
    s->room = room;
}

const double *samples_point(const struct samples *s, size_t i, double x[3]) {
    for (int a = 0; a < 3; a++) x[a] = a < s->dim ? s->value[a][i] : 0;
    return x;
}

long samples_line(const struct samples *s, size_t i) {
    return s->line ? s->line[i] : (long)i + 1;
}

void samples_grow(struct samples *s) {
    size_t room = s->room ? 2 * s->room : 1024;
    for (int k = 0; k < COLUMN_COUNT; k++)
        if (s->has[k]) s->value[k] = xgrow(s->value[k], s->n, room, sizeof *s->value[k]);
    s->line = xgrow(s->line, s->n, room, sizeof *s->line);
    s->room = room;
}

int samples_is(const char *text, size_t length, const char *word) {
    return length == strlen(word) && memcmp(text, word, length) == 0;
}

const char *samples_quote(const char *text, size_t length, char quoted[48]) {
    size_t n = 0;
    for (; n < length && n < 40; n++) quoted[n] = text[n] >= ' ' && text[n] <= '~' ? text[n] : '?';
    strcpy(quoted + n, n < length ? "..." : "");
    return quoted;
}

int samples_put(struct samples *s, int column, const char *text, size_t length, long line, int place,
                struct failure *why) {
    char quoted[48];
    const char *hint = "a decimal number";
    int bad = number_read_printed(text, length, &s->value[column][s->n]);
    s->line[s->n] = line;
    if (!bad) return STATUS_OK;
    samples_quote(text, length, quoted);
    if (bad > 0)
        return refuse(why, STATUS_NUMERICAL, "%.150s, line %ld, column %d: %s = %s is not finite", s->path, line,
                      place, names[column], quoted);
    if (length > 2 && strncasecmp(text + (*text == '-'), "0x", 2) == 0)
        hint = "a decimal number, not a hexadecimal one";
    else if (*text == '*')
        hint = "a decimal number (Fortran prints asterisks where its field is too narrow)";
    else if (memchr(text, ',', length))
        hint = "a number with a decimal point";
    return refuse(why, STATUS_INPUT, "%.150s, line %ld, column %d: %s = '%s' is not %s", s->path, line, place,
                  names[column], quoted, hint);
}

FILE *samples_open(const char *path, const char *name, struct failure *why) {
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
