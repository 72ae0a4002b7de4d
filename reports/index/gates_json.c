/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the JSON of `verify --json`: the members of each object of the array "gates", in any order, one object after
 * the other.  It reads that file and no other JSON. */
#include "reports/index/index.h"

#include "solver/status.h"
#include "verification/text/whole_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The string that begins at the quote *from, unescaped in place; *from moves past it.  NULL where it does not end. */
static char *take_string(char **from) {
    char *start = *from + 1, *to = start, *at = start;
    for (; *at && *at != '"'; at++) {
        if (*at == '\\' && at[1]) at++;
        *to++ = *at;
    }
    if (!*at) return NULL;
    *from = at + 1;
    *to = '\0';
    return start;
}

static void set_text(struct page_gate *g, const char *key, const char *value) {
    if (strcmp(key, "id") == 0) g->id = value;
    if (strcmp(key, "verdict") == 0) g->verdict = value;
    if (strcmp(key, "reason") == 0) g->reason = value;
    if (strcmp(key, "why") == 0) g->why = value;
    if (strcmp(key, "command") == 0) g->command = value;
    if (strcmp(key, "diagnosis") == 0) g->diagnosis = value;
    if (strcmp(key, "norm") == 0) g->rungs.norm = value;
    if (strcmp(key, "axis") == 0) snprintf(g->rungs.axis, sizeof g->rungs.axis, "%s", value);
}

static void set_number(struct page_gate *g, const char *key, double value, double *middle, double *half) {
    if (strcmp(key, "expected") == 0) *middle = value;
    if (strcmp(key, "tolerance") == 0) *half = value;
    if (strcmp(key, "measured") == 0) g->value = value;
    if (strcmp(key, "error") == 0) g->error = value;
    if (strcmp(key, "ceiling") == 0) g->ceiling = value;
}

/* The numbers from behind a bracket, at most `room`, null as NaN; *count of them.  Where they end, or NULL. */
static char *take_numbers(char *at, double *value, int room, int *count) {
    for (*count = 0;;) {
        at += strspn(at, " \t\r\n,");
        if (*at == ']') return at + 1;
        if (!*at || *count == room) return NULL;
        char *end;
        double number = strtod(at, &end);
        value[(*count)++] = end > at ? number : NAN;
        at += strcspn(at, ",] \n");
    }
}

static void set_numbers(struct page_gate *g, const char *key, const double *value, int count) {
    for (int i = 0; i < count; i++) {
        if (strcmp(key, "interval95") == 0 && i < 2) g->ci[i] = value[i];
        if (strcmp(key, "rungs") == 0) g->rungs.x[i] = value[i];
        if (strcmp(key, "errors") == 0) g->rungs.error[i] = value[i];
        if (strcmp(key, "counted") == 0) g->rungs.counts[i] = value[i] == 1;
    }
    if (strcmp(key, "rungs") == 0) g->rungs.n = count;
}

/* One object, from behind its brace; returns where it ends, or NULL. */
static char *take_gate(char *at, struct page_gate *g) {
    double middle = NAN, half = NAN;
    *g = (struct page_gate){.id = "",
                            .verdict = "",
                            .reason = "",
                            .why = "",
                            .command = "",
                            .diagnosis = "",
                            .value = NAN,
                            .ci = {NAN, NAN},
                            .rungs.norm = "",
                            .error = NAN,
                            .ceiling = NAN};
    for (;;) {
        at += strspn(at, " \t\r\n,");
        if (*at == '}') break;
        if (*at != '"') return NULL;
        const char *key = take_string(&at);
        if (!key) return NULL;
        at += strspn(at, ": ");
        if (*at == '"') {
            const char *value = take_string(&at);
            if (!value) return NULL;
            set_text(g, key, value);
        } else if (*at == '[') {
            double of[NUMBERS_MAX];
            int count;
            if (!(at = take_numbers(at + 1, of, NUMBERS_MAX, &count))) return NULL;
            set_numbers(g, key, of, count);
        } else {
            char *end;
            double value = strtod(at, &end);
            set_number(g, key, end > at ? value : NAN, &middle, &half);
            at += strcspn(at, ",}\n");
        }
    }
    g->lo = middle == 0 ? 0 : middle - half;
    g->hi = middle + half;
    return at + 1;
}

int gates_json_read(const char *path, struct gates_json *g) {
    *g = (struct gates_json){.text = whole_file_at(path, NULL)};
    static const char made[] = "\"made\": ";
    char *at = g->text ? strstr(g->text, "\"gates\": [") : NULL, *origin = at ? strstr(g->text, made) : NULL;
    if (!at) {
        gates_json_free(g);
        return -1;
    }
    g->made = "from an existing file; date and machine not recorded";
    if (origin && origin < at && *(origin += strlen(made)) == '"') g->made = take_string(&origin);
    at += strlen("\"gates\": [");
    size_t room = 0;
    while (at && *(at += strspn(at, " \t\r\n,")) == '{') {
        size_t used = (size_t)g->count;
        if (used == room) g->gate = xgrow(g->gate, used, room = 2 * room + 64, sizeof *g->gate);
        at = take_gate(at + 1, &g->gate[g->count++]);
    }
    if (at) return 0;
    gates_json_free(g);
    return -1;
}

void gates_json_free(struct gates_json *g) {
    free(g->gate);
    free(g->text);
    *g = (struct gates_json){0};
}
