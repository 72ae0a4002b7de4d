/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of gates as text: a scanner of C blanks, comments, literals, names and numbers, and the form of a row. */
#include "verification/gates/gate_file.h"

#include "solver/status.h"
#include "verification/case/rows.h"
#include "verification/text/utf8.h"
#include "verification/text/number.h"
#include "verification/text/whole_file.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ID_MOST = 200 }; /* bytes: a path with it fits */

struct scanner {
    const char *name;
    const char *start, *at, *end;
    char *to; /* position for the next text, at most the length read so far */
    struct failure *why;
};

/* Refuses with line and column of s->at, counted from 1. */
static int wrong(struct scanner *s, const char *format, ...) {
    int line = 1, column = 1;
    char text[240];
    va_list arguments;
    for (const char *c = s->start; c < s->at; c++, column++)
        if (*c == '\n') line++, column = 0;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return refuse(s->why, STATUS_INPUT, "%.150s, line %d, column %d: %s", s->name, line, column, text);
}

static int begins(const struct scanner *s, const char *word) {
    size_t n = strlen(word);
    return (size_t)(s->end - s->at) >= n && memcmp(s->at, word, n) == 0;
}

static const char *find(const struct scanner *s, const char *word) {
    struct scanner look = *s;
    while (look.at < look.end && !begins(&look, word)) look.at++;
    return look.at;
}

static int skip_blanks(struct scanner *s) {
    for (;;) {
        if (s->at < s->end && *s->at && strchr(" \t\r\n", *s->at)) {
            s->at++;
        } else if (begins(s, "//")) {
            s->at = find(s, "\n");
        } else if (begins(s, "/*")) {
            struct scanner after = *s;
            after.at += 2;
            const char *close = find(&after, "*/");
            if (close == s->end) return wrong(s, "this comment has no end");
            s->at = close + 2;
        } else {
            return STATUS_OK;
        }
    }
}

/* Describes the text at this position, for a message. */
static const char *found(const struct scanner *s, char quoted[48]) {
    size_t n = 0;
    while (s->at + n < s->end && n < 20 && s->at[n] != '\n') n++;
    return n ? rows_quote(s->at, n, quoted) : "the end of the line";
}

static int take_mark(struct scanner *s, char mark) {
    char quoted[48];
    if (skip_blanks(s)) return STATUS_INPUT;
    if (s->at < s->end && *s->at == mark) return s->at++, STATUS_OK;
    return wrong(s,
                 "expected '%c', found %s; a row is GATE(\"id\", QUICK, \"measure\", \"command\", lo, hi, ceiling, "
                 "\"why\")",
                 mark, found(s, quoted));
}

/* One literal, appended at s->to. */
static int take_literal(struct scanner *s) {
    const struct scanner open = *s;
    for (s->at++; s->at < s->end && *s->at != '"'; s->at++) {
        char c = *s->at;
        size_t length = utf8_length(s->at); /* a NUL ends the text */
        if (!length && c != '\n') return wrong(s, "a text has a control character, or is not UTF-8");
        if (c == '\\' && s->at + 1 < s->end) {
            c = *++s->at;
            if (!strchr("\\\"'n", c) || !c) return wrong(s, "of escapes \\\\, \\\", \\' and \\n are known");
            if (c == 'n') c = '\n';
        } else if (c == '\n') {
            break;
        }
        *s->to++ = c;
        for (; length > 1; length--) *s->to++ = *++s->at;
    }
    if (s->at < s->end && *s->at == '"') return s->at++, STATUS_OK;
    struct scanner at = open;
    return wrong(&at, "this text has no closing \" on its line");
}

/* Adjacent literals are one text. */
static int take_text(struct scanner *s, const char *what, const char **text) {
    char quoted[48];
    *text = s->to;
    if (skip_blanks(s)) return STATUS_INPUT;
    if (s->at >= s->end || *s->at != '"')
        return wrong(s, "expected the %s in \"...\", found %s", what, found(s, quoted));
    while (s->at < s->end && *s->at == '"')
        if (take_literal(s) || skip_blanks(s)) return STATUS_INPUT;
    *s->to++ = '\0';
    return **text ? STATUS_OK : wrong(s, "the %s is empty", what);
}

/* Length of a word of letters, digits and characters of numbers. */
static size_t word_length(const struct scanner *s) {
    size_t n = 0;
    while (s->at + n < s->end && s->at[n] &&
           strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+-./", s->at[n]))
        n++;
    return n;
}

static int take_word(struct scanner *s, char word[40]) {
    if (skip_blanks(s)) return STATUS_INPUT;
    size_t n = word_length(s);
    snprintf(word, 40, "%.*s", (int)(n < 40 ? n : 39), s->at);
    return STATUS_OK;
}

static int take_number(struct scanner *s, const char *what, double *value) {
    char word[40], quoted[48];
    if (take_word(s, word)) return STATUS_INPUT;
    if (word_length(s) > 39) return wrong(s, "a number of more than 39 letters");
    if (strcmp(word, "NAN") == 0)
        *value = NAN;
    else if (strcmp(word, "INFINITY") == 0)
        *value = INFINITY;
    else if (strcmp(word, "-INFINITY") == 0)
        *value = -INFINITY;
    else if (number_read(word, value))
        return wrong(s, "expected %s, a number or NAN, found %s", what, found(s, quoted));
    s->at += word_length(s);
    return STATUS_OK;
}

static int take_tier(struct scanner *s, enum gate_tier *tier) {
    char word[40], quoted[48];
    if (take_word(s, word)) return STATUS_INPUT;
    if (strcmp(word, "QUICK") != 0 && strcmp(word, "FULL") != 0)
        return wrong(s, "expected QUICK or FULL, found %s", found(s, quoted));
    *tier = strcmp(word, "QUICK") == 0 ? TIER_QUICK : TIER_FULL;
    s->at += strlen(word);
    return STATUS_OK;
}

static int take_row(struct scanner *s, struct gate *g) {
    char word[40], quoted[48];
    if (take_word(s, word)) return STATUS_INPUT;
    if (strcmp(word, "GATE") != 0) return wrong(s, "expected GATE(...), found %s", found(s, quoted));
    s->at += 4;
    if (take_mark(s, '(') || take_text(s, "id", &g->id)) return STATUS_INPUT;
    if (take_mark(s, ',') || take_tier(s, &g->tier)) return STATUS_INPUT;
    if (take_mark(s, ',') || take_text(s, "measure", &g->measure)) return STATUS_INPUT;
    if (take_mark(s, ',') || take_text(s, "command", &g->command)) return STATUS_INPUT;
    if (take_mark(s, ',') || take_number(s, "the lower bound", &g->lo)) return STATUS_INPUT;
    if (take_mark(s, ',') || take_number(s, "the upper bound", &g->hi)) return STATUS_INPUT;
    if (take_mark(s, ',') || take_number(s, "the ceiling", &g->ceiling)) return STATUS_INPUT;
    if (take_mark(s, ',') || take_text(s, "reason", &g->why)) return STATUS_INPUT;
    return take_mark(s, ')');
}

/* --keep uses a folder named after the gate: each part between slashes is one level, and none leads outside. */
static int check_id(struct scanner *s, const char *id) {
    if (strlen(id) > ID_MOST) return wrong(s, "the row above, '%.60s...': an id of more than %d bytes", id, ID_MOST);
    if (strchr(id, '\n')) return wrong(s, "the row above: an id of one line is wanted");
    for (const char *part = id;;) {
        size_t n = strcspn(part, "/");
        if (n == 0 || (n <= 2 && strncmp(part, "..", n) == 0))
            return wrong(s, "the row above, '%.60s': the parts of an id may not be empty, '.' or '..'", id);
        if (!part[n]) return STATUS_OK;
        part += n + 1;
    }
}

static int check_row(struct scanner *s, const struct gate *g) {
    struct measured m;
    const struct measure *measure = measures_find(g->measure, &m);
    if (!measure) return wrong(s, "the row above, '%.60s': %.150s", g->id, m.reason);
    if (!(g->lo <= g->hi)) return wrong(s, "the row above, '%.60s': %g to %g is no band", g->id, g->lo, g->hi);
    if (measure->ceiling && !isnan(g->ceiling) && !(g->ceiling > 0))
        return wrong(s, "the row above, '%.60s': the ceiling %g bounds no error; a positive number or NAN is wanted",
                     g->id, g->ceiling);
    return check_id(s, g->id);
}

static int by_id(const void *a, const void *b) {
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static int check_twice(const struct gate_file *f, const char *name, struct failure *why) {
    const char **id = xcalloc((size_t)f->count, sizeof *id), *twice = NULL;
    for (int i = 0; i < f->count; i++) id[i] = f->gate[i].id;
    qsort(id, (size_t)f->count, sizeof *id, by_id);
    for (int i = 1; i < f->count && !twice; i++)
        if (strcmp(id[i - 1], id[i]) == 0) twice = id[i];
    free(id);
    return twice ? refuse(why, STATUS_INPUT, "%.150s: the row '%.60s' is there twice", name, twice) : STATUS_OK;
}

int gate_file_read(const char *text, size_t size, const char *name, struct gate_file *f, struct failure *why) {
    *f = (struct gate_file){.text = xcalloc(size + 8, 1)};
    struct scanner s = {.name = name, .start = text, .at = text, .end = text + size, .to = f->text, .why = why};
    int room = 0;
    if (skip_blanks(&s)) return STATUS_INPUT;
    while (s.at < s.end) {
        if (f->count == room)
            f->gate = xgrow(f->gate, (size_t)f->count, (size_t)(room = 2 * room + 16), sizeof *f->gate);
        struct gate *g = &f->gate[f->count];
        if (take_row(&s, g) || check_row(&s, g)) return STATUS_INPUT;
        f->count++;
        if (skip_blanks(&s)) return STATUS_INPUT;
    }
    if (!f->count) return wrong(&s, "no row; expected GATE(\"id\", QUICK, \"measure\", ...)");
    return check_twice(f, name, why);
}

int gate_file_open(const char *path, struct gate_file *f, struct failure *why) {
    enum { MOST = 1 << 20 };
    *f = (struct gate_file){0};
    FILE *in = whole_file_open(path);
    if (!in) return refuse(why, STATUS_INPUT, "--gates %.200s: %s", path, whole_file_error());
    char *text = xcalloc(MOST + 1, 1);
    size_t n = fread(text, 1, MOST + 1, in);
    int status = ferror(in) ? refuse(why, STATUS_INPUT, "--gates %.200s: %s", path, strerror(errno))
                 : n > MOST ? refuse(why, STATUS_INPUT, "--gates %.200s: larger than 1 MB", path)
                            : gate_file_read(text, n, path, f, why);
    fclose(in);
    free(text);
    return status;
}

void gate_file_free(struct gate_file *f) {
    free(f->gate);
    free(f->text);
    *f = (struct gate_file){0};
}
