/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A streaming JSON writer with a stack of closing brackets. */
#include "verification/text/json.h"

#include "verification/text/utf8.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

static void quote(FILE *out, const char *text) {
    fputc('"', out);
    while (*text) {
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
        quote(j->out, key);
        fputs(": ", j->out);
    }
}

static void open(struct json *j, const char *key, const char *brackets) {
    start(j, key);
    fputc(brackets[0], j->out);
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

void json_array(struct json *j, const char *key) {
    open(j, key, "[]");
}

void json_end(struct json *j) {
    j->depth--;
    if (j->members[j->depth]) indent(j);
    fputc(j->closing[j->depth], j->out);
    if (j->depth == 0) fputc('\n', j->out);
}

void json_number(struct json *j, const char *key, double value) {
    start(j, key);
    if (isfinite(value))
        fprintf(j->out, "%.17g", value);
    else
        fputs("null", j->out);
}

void json_whole(struct json *j, const char *key, long long value) {
    start(j, key);
    fprintf(j->out, "%lld", value);
}

void json_text(struct json *j, const char *key, const char *value) {
    start(j, key);
    if (value)
        quote(j->out, value);
    else
        fputs("null", j->out);
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
