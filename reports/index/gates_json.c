/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the JSON of `verify --json`: the members of each object of the array "gates", in any order, one object after
 * the other.  It reads that file and no other JSON. */
#include "reports/index/index.h"

#include "verification/text/whole_file.h"
#include "verification/text/words.h"

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

static void set_text(struct gate_result *r, const char *key, const char *value) {
    struct measured *m = &r->measured;
    if (strcmp(key, "id") == 0) r->gate.id = value;
    if (strcmp(key, "why") == 0) r->gate.why = value;
    if (strcmp(key, "command") == 0) snprintf(r->typed, sizeof r->typed, "%s", value);
    if (strcmp(key, "verdict") == 0) m->verdict = (enum verdict)fmax(0, words_index(verdict_words, value));
    if (strcmp(key, "reason") == 0) snprintf(m->reason, sizeof m->reason, "%s", value);
    if (strcmp(key, "diagnosis") == 0) snprintf(m->diagnosis, sizeof m->diagnosis, "%s", value);
    if (strcmp(key, "norm") == 0) m->rungs.norm = value;
    if (strcmp(key, "axis") == 0) snprintf(m->rungs.axis, sizeof m->rungs.axis, "%s", value);
}

static void set_number(struct gate_result *r, const char *key, double value, double *middle, double *half) {
    if (strcmp(key, "expected") == 0) *middle = value;
    if (strcmp(key, "tolerance") == 0) *half = value;
    if (strcmp(key, "measured") == 0) r->measured.value = value;
    if (strcmp(key, "error") == 0) r->measured.error = value;
    if (strcmp(key, "ceiling") == 0) r->gate.ceiling = value;
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

static void set_numbers(struct measured *m, const char *key, const double *value, int count) {
    for (int i = 0; i < count; i++) {
        if (strcmp(key, "interval95") == 0 && i < 2) m->ci[i] = value[i];
        if (strcmp(key, "rungs") == 0) m->rungs.x[i] = value[i];
        if (strcmp(key, "errors") == 0) m->rungs.error[i] = value[i];
        if (strcmp(key, "counted") == 0) m->rungs.counts[i] = value[i] == 1;
    }
    if (strcmp(key, "rungs") == 0) m->rungs.n = count;
}

/* One object, from behind its brace; returns where it ends, or NULL. */
static char *take_gate(char *at, struct gate_result *r) {
    double middle = NAN, half = NAN;
    r->gate = (struct gate){.id = "", .why = "", .ceiling = NAN};
    r->measured = (struct measured){.value = NAN, .ci = {NAN, NAN}, .error = NAN, .rungs.norm = ""};
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
            set_text(r, key, value);
        } else if (*at == '[') {
            double of[NUMBERS_MAX];
            int count;
            if (!(at = take_numbers(at + 1, of, NUMBERS_MAX, &count))) return NULL;
            set_numbers(&r->measured, key, of, count);
        } else {
            char *end;
            double value = strtod(at, &end);
            set_number(r, key, end > at ? value : NAN, &middle, &half);
            at += strcspn(at, ",}\n");
        }
    }
    r->gate.lo = middle == 0 ? 0 : middle - half;
    r->gate.hi = middle + half;
    return at + 1;
}

int gates_json_read(const char *path, struct gates *g, const char **origin) {
    *g = (struct gates){.text = whole_file_at(path, NULL)};
    static const char made[] = "\"made\": ";
    char *at = g->text ? strstr(g->text, "\"gates\": [") : NULL, *when = at ? strstr(g->text, made) : NULL;
    *origin = "from an existing file; date and machine not recorded";
    if (when && when < at && *(when += strlen(made)) == '"') *origin = take_string(&when);
    if (at) at += strlen("\"gates\": [");
    while (at && *(at += strspn(at, " \t\r\n,")) == '{') {
        gates_add(g, &(struct gate){0});
        at = take_gate(at + 1, &g->result[g->declared - 1]);
    }
    if (at) return 0;
    gates_free(g);
    return -1;
}
