/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines and cells of a text in memory. */
#include "verification/case/rows.h"

#include "solver/status.h"
#include "verification/text/number.h"
#include "verification/text/output.h"
#include "verification/text/whole_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const size_t FEW = 1000; /* rows: below this number threads do not pay off */

static int wrong(const struct rows *r, long line, const char *what, struct failure *why) {
    return refuse(why, STATUS_INPUT, "%.150s, line %ld: %s", r->name, line, what);
}

/* Adds a line to one of the lists, whose room doubles. */
static void add(struct rows_line **list, size_t *count, const char *text, long number) {
    if (*count == 0 || (*count >= 64 && (*count & (*count - 1)) == 0))
        *list = xgrow(*list, *count, *count ? 2 * *count : 64, sizeof **list);
    (*list)[(*count)++] = (struct rows_line){text, number};
}

static int list_lines(struct rows *r, struct failure *why) {
    long number = 1;
    char *at = r->text;
    if (strncmp(at, "\xEF\xBB\xBF", 3) == 0) at += 3; /* byte order mark */
    for (char *end; *at; at = end + 1, number++) {
        end = at + strcspn(at, "\r\n");
        if (*end == '\r' && end[1] == '\n') *end++ = '\0';
        if (*end == '\r' && end[1]) return wrong(r, number, "a carriage return: end each line with a newline", why);
        if (*end != '\n')
            return wrong(r, number, "ends without a newline: the file looks cut off; end the last line too", why);
        *end = '\0';
        const char *text = at + strspn(at, " \t");
        if (*text == '#')
            add(&r->comment, &r->comments, text + strspn(text, "# \t"), number);
        else if (*text)
            add(&r->line, &r->count, at, number);
    }
    return STATUS_OK;
}

int rows_of(char *text, const char *name, struct rows *r, struct failure *why) {
    *r = (struct rows){.name = name, .text = text};
    return list_lines(r, why);
}

int rows_read(FILE *in, const char *name, struct rows *r, struct failure *why) {
    size_t size, length;
    char *text = whole_file_read(in, &size);
    *r = (struct rows){.name = name, .text = text};
    if (output_noted()) return refuse(why, STATUS_INPUT, "%.150s: interrupted while it is read", name);
    if (ferror(in)) return refuse(why, STATUS_INPUT, "%.150s: %s", name, strerror(errno));
    if ((length = strlen(text)) < size) {
        long line = 1;
        for (size_t i = 0; i < length; i++) line += text[i] == '\n';
        return wrong(r, line, "a NUL byte: this is no text file", why);
    }
    return list_lines(r, why);
}

void rows_free(struct rows *r) {
    free(r->line);
    free(r->comment);
    free(r->text);
    *r = (struct rows){0};
}

char rows_separator(const char *line) {
    return strchr(line, ';') ? ';' : strchr(line, ',') ? ',' : ' ';
}

/* Reads the cell that starts at `at`; returns where its separator is due. */
static const char *take_cell(const char *at, char separator, struct rows_cell *cell) {
    const char marks[] = {separator, separator == ' ' ? '\t' : '\0', '\0'};
    at += strspn(at, " \t");
    const char *end = *at == '"' || *at == '\'' ? strchr(at + 1, *at) : NULL;
    if (end) {
        *cell = (struct rows_cell){at + 1, (size_t)(end - at - 1)};
        return end + 1 + strspn(end + 1, " \t");
    }
    *cell = (struct rows_cell){at, strcspn(at, marks)};
    at += cell->length;
    while (cell->length > 0 && strchr(" \t", cell->text[cell->length - 1])) cell->length--;
    return at;
}

int rows_split(const struct rows *r, const struct rows_line *l, char separator, struct rows_cell cell[ROWS_CELLS],
               struct failure *why) {
    int n = 0;
    for (const char *at = l->text;; at += separator != ' ') {
        if (separator == ' ' && at[strspn(at, " \t")] == '\0') return n;
        if (n == ROWS_CELLS) return wrong(r, l->number, "more than 256 columns", why), -1;
        at = take_cell(at, separator, &cell[n++]);
        if (*at == '\0') return n;
        if (separator != ' ' && *at != separator)
            return wrong(r, l->number, "a quote is followed by more text", why), -1;
    }
}

int rows_is(const struct rows_cell *cell, const char *word) {
    return cell->length == strlen(word) && memcmp(cell->text, word, cell->length) == 0;
}

int rows_find(const struct rows *r, const struct rows_line *l, const struct rows_cell *cell, int n, const char *name,
              struct failure *why) {
    int found = -1;
    for (int i = 0; i < n; i++) {
        if (!rows_is(&cell[i], name)) continue;
        if (found >= 0)
            return refuse(why, STATUS_INPUT, "%.150s, line %ld: two columns are called '%.60s'", r->name, l->number,
                          name),
                   -2;
        found = i;
    }
    return found;
}

const char *rows_quote(const char *text, size_t length, char quoted[48]) {
    size_t n = 0;
    for (; n < length && n < 40; n++) quoted[n] = text[n] >= ' ' && text[n] <= '~' ? text[n] : '?';
    strcpy(quoted + n, n < length ? "..." : "");
    return quoted;
}

static int refuse_number(const struct rows *r, long line, const struct rows_column *c, const struct rows_cell *cell,
                         int bad, struct failure *why) {
    const char *text = cell->text, *valid = "a decimal number";
    char quoted[48];
    if (bad > 0)
        valid = "a finite number";
    else if (cell->length > 2 && strncasecmp(text + (*text == '-'), "0x", 2) == 0)
        valid = "a decimal number, but a hexadecimal one";
    else if (*text == '*')
        valid = "a decimal number (Fortran prints asterisks where its field is too narrow)";
    else if (memchr(text, ',', cell->length))
        valid = "a number with a decimal point";
    return refuse(why, bad > 0 ? STATUS_NUMERICAL : STATUS_INPUT, "%.150s, line %ld, column %d (%s): '%s' is not %s",
                  r->name, line, c->place + 1, c->name, rows_quote(text, cell->length, quoted), valid);
}

static int read_row(const struct rows *r, size_t first, size_t i, char separator, int width,
                    const struct rows_column *column, int columns, struct failure *why) {
    struct rows_cell cell[ROWS_CELLS];
    const struct rows_line *l = &r->line[first + i];
    int n = rows_split(r, l, separator, cell, why);
    if (n < 0) return why->status;
    if (n != width)
        return refuse(why, STATUS_INPUT, "%.150s, line %ld: %d column%s where the lines above have %d", r->name,
                      l->number, n, n == 1 ? "" : "s", width);
    for (const struct rows_column *c = column; c < column + columns; c++) {
        if (c->place < 0) continue;
        const struct rows_cell *from = &cell[c->place];
        int bad = number_read_printed(from->text, from->length, &c->value[i * c->stride]);
        if (bad) return refuse_number(r, l->number, c, from, bad, why);
        if (c->typed) c->typed[i * c->stride] = *from;
    }
    return STATUS_OK;
}

int rows_numbers(const struct rows *r, size_t first, char separator, int width, const struct rows_column *column,
                 int columns, struct failure *why) {
    size_t n = r->count - first, bad = n;
#pragma omp parallel for reduction(min : bad) if (n > FEW)
    for (size_t i = 0; i < n; i++) {
        struct failure ignored;
        if (i < bad && read_row(r, first, i, separator, width, column, columns, &ignored)) bad = i;
    }
    return bad < n ? read_row(r, first, bad, separator, width, column, columns, why) : STATUS_OK;
}
