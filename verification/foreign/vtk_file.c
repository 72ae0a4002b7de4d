/* SPDX-License-Identifier: GPL-3.0-or-later */
/* VTK File Formats for VTK version 4.2 (Kitware), the legacy form: words between blanks.  All that is wanted are
 * arrays of numbers with a name; what is in no wanted array is passed over. */
#include "verification/foreign/formats.h"

#include "solver/status.h"
#include "verification/foreign/samples.h"
#include "verification/text/number.h"
#include "verification/text/whole_file.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORD = 96 };

struct reader {
    const char *at, *end;
    long line;
    const struct column_map *wanted;
    struct samples *s;
    size_t seen[COLUMN_COUNT]; /* values read of each */
    char array[400];           /* names of the point data that were passed over */
    int cell_data;
};

static const char legacy[] = "# vtk DataFile";

int vtk_file_is(const char *text, size_t size) {
    return size >= sizeof legacy && memcmp(text, legacy, sizeof legacy - 1) == 0;
}

int vtk_file_is_xml(const char *text, size_t size) {
    while (size > 0 && *text && strchr(" \t\r\n\xEF\xBB\xBF", *text)) text++, size--;
    return size > 8 && (memcmp(text, "<?xml", 5) == 0 || memcmp(text, "<VTKFile", 8) == 0);
}

static int wrong(const struct reader *v, struct failure *why, const char *what) {
    return refuse(why, STATUS_INPUT, "%.150s, line %ld: %s", v->s->path, v->line, what);
}

/* The next word between blanks, uncut; its length, 0 at the end. */
static size_t next_word(struct reader *v, const char **word) {
    while (v->at < v->end && strchr(" \t\r\n", *v->at)) v->line += *v->at++ == '\n';
    *word = v->at;
    while (v->at < v->end && !strchr(" \t\r\n", *v->at)) v->at++;
    return (size_t)(v->at - *word);
}

/* Value number i of a column; points have as many as their arrays. */
static int put(struct reader *v, int column, const char *word, size_t length, struct failure *why) {
    struct samples *s = v->s;
    size_t n = s->n;
    while (v->seen[column] >= s->room) {
        s->n = s->room; /* all of it is kept */
        samples_grow(s);
    }
    s->n = v->seen[column]++;
    int status = samples_put(s, column, word, length, v->line, 1, why);
    s->n = n;
    return status;
}

/* `count` tuples of `width` numbers, of which number a goes to column first + a; the rest is passed over. */
static int read_tuples(struct reader *v, size_t count, int width, int first, int kept, struct failure *why) {
    for (size_t i = 0; i < count; i++)
        for (int a = 0; a < width; a++) {
            const char *word;
            size_t length = next_word(v, &word);
            if (length == 0) return wrong(v, why, "the file ends within an array: it looks cut off");
            if (a < kept && put(v, first + a, word, length, why)) return why->status;
        }
    return STATUS_OK;
}

/* The column of a point array's name, or -1; what is not wanted is noted for a message. */
static int column_of(struct reader *v, const char *name) {
    for (int k = COLUMN_T; k < COLUMN_COUNT; k++)
        if (v->s->has[k] && strcmp(samples_column_name(v->wanted, k), name) == 0) return k;
    words_add(v->array, sizeof v->array, "%s%.60s", *v->array ? ", " : "", name);
    return -1;
}

/* The next word as a text of its own, cut where it is longer. */
static int word_into(struct reader *v, char text[WORD]) {
    const char *word;
    size_t length = next_word(v, &word);
    snprintf(text, WORD, "%.*s", (int)fmin((double)length, WORD), word);
    return length > 0;
}

static int count_into(struct reader *v, size_t *count, struct failure *why) {
    char text[WORD];
    long value = 0;
    if (!word_into(v, text) || number_read_whole(text, 4000000000, &value))
        return wrong(v, why, "a count is missing or is no whole number");
    *count = (size_t)value;
    return STATUS_OK;
}

/* SCALARS name type [components], LOOKUP_TABLE name, values */
static int read_scalars(struct reader *v, size_t points, struct failure *why) {
    char name[WORD], type[WORD], word[WORD];
    size_t width = 1;
    if (!word_into(v, name) || !word_into(v, type)) return wrong(v, why, "SCALARS needs a name and a type");
    const char *start = v->at;
    long line = v->line;
    if (!word_into(v, word)) return wrong(v, why, "SCALARS without values");
    if (strcmp(word, "LOOKUP_TABLE") != 0) {
        v->at = start, v->line = line;
        if (count_into(v, &width, why)) return STATUS_INPUT;
        word_into(v, word);
    }
    word_into(v, word); /* the name of the lookup table */
    int column = column_of(v, name);
    if (column < 0 || width != 1) return STATUS_OK; /* its numbers are words of no meaning */
    return read_tuples(v, points, 1, column, 1, why);
}

/* FIELD name arrays, then of each: name components tuples type, values */
static int read_field(struct reader *v, struct failure *why) {
    char name[WORD], type[WORD];
    size_t arrays = 0, width = 0, count = 0;
    if (!word_into(v, name) || count_into(v, &arrays, why)) return wrong(v, why, "FIELD needs a name and a count");
    for (size_t i = 0; i < arrays; i++) {
        if (!word_into(v, name)) return wrong(v, why, "the file ends within FIELD: it looks cut off");
        if (count_into(v, &width, why) || count_into(v, &count, why)) return STATUS_INPUT;
        word_into(v, type);
        int column = width == 1 ? column_of(v, name) : -1;
        if (read_tuples(v, count, (int)width, column < 0 ? 0 : column, column >= 0, why)) return why->status;
    }
    return STATUS_OK;
}

static int read_all(struct reader *v, struct failure *why) {
    const char *word;
    size_t length, points = 0;
    int of_points = 0;
    char form[WORD];
    for (int i = 0; i < 2; i++) { /* the version and the title */
        while (v->at < v->end && *v->at != '\n') v->at++;
        if (v->at < v->end) v->at++, v->line++;
    }
    if (!word_into(v, form) || strcmp(form, "ASCII") != 0)
        return wrong(v, why, "ASCII is wanted here: binary VTK is not read");
    while ((length = next_word(v, &word)) > 0) {
        int status = STATUS_OK;
        if (samples_is(word, length, "POINTS")) {
            status = count_into(v, &points, why) || !word_into(v, form)
                         ? STATUS_INPUT
                         : read_tuples(v, points, 3, COLUMN_X, v->s->dim, why);
        } else if (samples_is(word, length, "POINT_DATA")) {
            of_points = 1;
            status = count_into(v, &points, why);
        } else if (samples_is(word, length, "CELL_DATA")) {
            v->cell_data = 1, of_points = 0;
        } else if (of_points && samples_is(word, length, "SCALARS")) {
            status = read_scalars(v, points, why);
        } else if (of_points && samples_is(word, length, "FIELD")) {
            status = read_field(v, why);
        }
        if (status) return why->status;
    }
    return STATUS_OK;
}

/* As many values of each column as points. */
static int check_counts(const struct reader *v, struct failure *why) {
    const char *T = samples_column_name(v->wanted, COLUMN_T);
    if (v->seen[COLUMN_X] == 0) return refuse(why, STATUS_INPUT, "%.200s: no POINTS", v->s->path);
    if (v->seen[COLUMN_T] == 0)
        return refuse(why, STATUS_INPUT,
                      "%.120s: no point data '%s'%s (there are: %.150s); --columns T=NAME names them", v->s->path, T,
                      v->cell_data ? ", cell data are not at points" : "", *v->array ? v->array : "none");
    for (int k = 0; k < COLUMN_COUNT; k++)
        if (v->s->has[k] && v->seen[k] != v->seen[COLUMN_X])
            return refuse(why, STATUS_INPUT, "%.150s: %zu values of %s at %zu points", v->s->path, v->seen[k],
                          samples_column_name(v->wanted, k), v->seen[COLUMN_X]);
    return STATUS_OK;
}

static int read_text(const char *text, size_t size, const struct column_map *c, struct samples *s,
                     struct failure *why) {
    struct reader *v = xcalloc(1, sizeof *v);
    *v = (struct reader){.at = text, .end = text + size, .line = 1, .wanted = c, .s = s};
    int status = STATUS_OK;
    s->has[COLUMN_X] = s->has[COLUMN_T] = 1;
    s->has[COLUMN_Y] = s->dim == 2;
    s->has[COLUMN_W] = c->name[COLUMN_W][0] != '\0';
    if (strlen(text) != size) status = refuse(why, STATUS_INPUT, "%.200s: holds a NUL byte: not ascii", s->path);
    if (!status && text[size - 1] != '\n')
        status = refuse(why, STATUS_INPUT,
                        "%.200s: ends without a newline: the file looks cut off; end the last line too", s->path);
    if (!status) status = read_all(v, why);
    if (!status) status = check_counts(v, why);
    if (!status) s->n = v->seen[COLUMN_X];
    free(v);
    return status;
}

int vtk_file_read(FILE *in, const struct column_map *c, struct samples *s, struct failure *why) {
    size_t size;
    char *text = whole_file_read(in, &size);
    int status = read_text(text, size, c, s, why);
    free(text);
    return status;
}

/* The codes that write VTU write it in binary unless asked (verification/README.md). */
int vtk_file_refuse_xml(FILE *in, const struct column_map *c, struct samples *s, struct failure *why) {
    (void)in, (void)c;
    return refuse(why, STATUS_INPUT,
                  "%.200s: a VTU file is not read, since most programs write its numbers in binary: "
                  "write legacy ASCII VTK, CSV or .npy",
                  s->path);
}
