/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A streaming writer with a stack of closing brackets; the cells of a table go to csv.c. */
#include "verification/text/json.h"

#include "verification/text/utf8.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

static void quote(FILE *out, const char *text, size_t size) {
    fputc('"', out);
    for (const char *end = text + size; text < end;) {
        size_t length = utf8_length(text);
        if (*text == '"' || *text == '\\')
            fprintf(out, "\\%c", *text);
        else if (length)
            fwrite(text, 1, length, out);
        else
            fprintf(out, "\\u%04x", (unsigned char)*text < 0x80 ? (unsigned char)*text : 0xFFFD);
        text += length ? length : 1;
    }
    fputc('"', out);
}

static void indent(const struct json *j) {
    fprintf(j->out, "\n%*s", 2 * j->depth, "");
}

static void start(struct json *j, const char *key) {
    if (j->depth > 0) {
        if (j->members[j->depth - 1]++) fputc(',', j->out);
        indent(j);
    }
    if (key) {
        const char *unit = strstr(key, " [");
        quote(j->out, key, unit ? (size_t)(unit - key) : strlen(key));
        fputs(": ", j->out);
    }
}

/* A cell of a table, or nothing where the value is no part of a row. */
static void cell(struct json *j, const char *key, const char *text) {
    char name[96];
    const char *unit = strstr(j->array, " [");
    if (key && j->depth == j->row) csv_cell(&j->csv, key, text);
    if (key || j->depth != j->row + 1) return;
    snprintf(name, sizeof name, "%.*s_%d%s", unit ? (int)(unit - j->array) : 63, j->array, ++j->members[j->depth - 1],
             unit ? unit : "");
    csv_cell(&j->csv, name, text);
}

/* A number; NULL: null, an empty cell. */
static void put(struct json *j, const char *key, const char *text) {
    if (j->row)
        cell(j, key, text ? text : "");
    else {
        start(j, key);
        fputs(text ? text : "null", j->out);
    }
}

static void open(struct json *j, const char *key, const char *brackets) {
    if (!j->row) {
        start(j, key);
        fputc(brackets[0], j->out);
    } else if (*brackets == '{' && j->depth + 1 == j->row)
        csv_row(&j->csv);
    else if (*brackets == '[')
        snprintf(j->array, sizeof j->array, "%s", key ? key : "");
    j->members[j->depth] = 0;
    j->closing[j->depth++] = brackets[1];
}

void json_object(struct json *j, const char *key) {
    open(j, key, "{}");
}

struct json json_on(FILE *out) {
    struct json j = {.out = out};
    json_object(&j, NULL);
    return j;
}

struct json json_table(FILE *out, int row) {
    struct json j = {.out = out, .row = row};
    json_object(&j, NULL);
    return j;
}

void json_array(struct json *j, const char *key) {
    open(j, key, "[]");
}

void json_end(struct json *j) {
    j->depth--;
    if (j->row) {
        if (j->depth == 0) csv_end(&j->csv, j->out);
        return;
    }
    if (j->members[j->depth]) indent(j);
    fputc(j->closing[j->depth], j->out);
    if (j->depth == 0) fputc('\n', j->out);
}

void json_number(struct json *j, const char *key, double value) {
    char text[32];
    snprintf(text, sizeof text, "%.17g", value);
    put(j, key, isfinite(value) ? text : NULL);
}

void json_whole(struct json *j, const char *key, long long value) {
    char text[32];
    snprintf(text, sizeof text, "%lld", value);
    put(j, key, text);
}

void json_text(struct json *j, const char *key, const char *value) {
    if (!value || j->row)
        put(j, key, value);
    else {
        start(j, key);
        quote(j->out, value, strlen(value));
    }
}

void json_numbers(struct json *j, const char *key, const double *values, int count) {
    json_array(j, key);
    for (int i = 0; i < count; i++) json_number(j, NULL, values[i]);
    json_end(j);
}

void json_add(struct json *j, const char *members, ...) {
    char key[64];
    va_list values;
    va_start(values, members);
    for (const char *at = members, *kind; (kind = strchr(at, '%')); at = kind + strcspn(kind, "|")) {
        at += *at == '|';
        snprintf(key, sizeof key, "%.*s", (int)(kind - at) - 1, at);
        if (kind[1] == 's')
            json_text(j, key, va_arg(values, const char *));
        else if (kind[1] == 'g')
            json_number(j, key, va_arg(values, double));
        else if (kind[1] == 'd')
            json_whole(j, key, va_arg(values, int));
        else
            json_whole(j, key, kind[1] == 'z' ? (long long)va_arg(values, size_t) : va_arg(values, long long));
    }
    va_end(values);
}
