/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs commands and reads their JSON. */
#include "reports/figure/reading.h"

#include "verification/judge/ladder.h"
#include "verification/judge/run.h"
#include "verification/stability/step_limit.h"
#include "verification/text/json.h"
#include "verification/text/output.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void reading_set(struct reading *r, const char *command, ...) {
    va_list arguments;
    va_start(arguments, command);
    *r = (struct reading){0};
    vsnprintf(r->command, sizeof r->command, command, arguments);
    va_end(arguments);
}

static int run(struct command_run *r, struct json *j, struct failure *why) {
    int status = command_run_solve(r);
    *why = r->result.failure;
    if (!status_refused(status)) result_json(&r->result, j);
    return status;
}

static int ladder(struct command_run *r, struct json *j, struct failure *why) {
    struct ladder *l = xcalloc(1, sizeof *l);
    int status = ladder_run(&r->typed.experiment, &r->typed.rungs, l, why);
    if (!status) ladder_json(l, j);
    ladder_free(l);
    free(l);
    return status;
}

static int limit(struct command_run *r, struct json *j, struct failure *why) {
    const struct command *c = &r->typed;
    struct model_problem b;
    struct step_limit l;
    int status = step_limit_setup(c->experiment.method, &c->experiment.options, c->dim, c->ratio, c->field,
                                  c->contact, c->stages, &b, why);
    if (!status) status = step_limit_predict(&b, &l, why);
    if (!status) step_limit_json(&b, &l, j);
    return status;
}

static void run_one(struct reading *r) {
    static const struct {
        const char *name;
        int (*run)(struct command_run *r, struct json *j, struct failure *why);
    } verbs[] = {{"run", run}, {"ladder", ladder}, {"limit", limit}};
    struct command_run command;
    struct failure why = {0};
    size_t size;
    FILE *out = output_stream(&r->json, &size);
    struct json j = json_on(out);
    int status = command_run_read(&command, "%s", r->command);
    if (status) why = command.result.failure;
    for (size_t i = 0; i < sizeof verbs / sizeof *verbs && !status; i++)
        if (strcmp(command.typed.syntax->name, verbs[i].name) == 0) status = verbs[i].run(&command, &j, &why);
    json_end(&j);
    fclose(out);
    if (status) r->failure = why;
    command_run_free(&command);
}

int reading_run(struct reading *r, int count, struct failure *why) {
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = count - 1; i >= 0; i--) run_one(&r[i]);
    for (int i = 0; i < count; i++)
        if (r[i].failure.status && r[i].failure.status != STATUS_UNSTABLE)
            return refuse(why, r[i].failure.status, "heatladder %.100s: %.300s", r[i].command, r[i].failure.text);
    return STATUS_OK;
}

/* The value of a key, in the outermost object or behind a text; NULL for none. */
static const char *find(const struct reading *r, const char *key, size_t length) {
    char member[80], name[64];
    snprintf(name, sizeof name, "%.*s", (int)length, key);
    char *behind = strstr(name, " after ");
    const char *from = r->json;
    if (behind) from = strstr(r->json, behind + strlen(" after ")), *behind = '\0';
    snprintf(member, sizeof member, "%s\"%s\": ", behind ? "" : "\n  ", name);
    const char *at = from ? strstr(from, member) : NULL;
    return at ? at + strlen(member) : NULL;
}

static double number(const struct reading *r, const char *key, size_t length) {
    const char *at = find(r, key, length);
    if (strncmp(key, "failure", length) == 0) return r->failure.status != 0;
    return at && (*at == '-' || (*at >= '0' && *at <= '9')) ? strtod(at, NULL) : NAN;
}

double reading_value(const struct reading *r, const char *key) {
    size_t length = strcspn(key, ",/");
    double value = number(r, key, length);
    while (key[length] == ',') {
        key += length + 1;
        length = strcspn(key, ",/");
        double other = number(r, key, length);
        if (isnan(other) || other > value) value = other;
    }
    return key[length] == '/' ? value / number(r, key + length + 1, strlen(key + length + 1)) : value;
}

void reading_row(const struct reading *r, const char *keys, FILE *out) {
    char key[80];
    for (size_t n; *keys; keys += n + (keys[n] == ' ')) {
        n = strcspn(keys, " ");
        snprintf(key, sizeof key, "%.*s", (int)n, keys);
        fprintf(out, "%.6g%c", reading_value(r, key), keys[n] ? ',' : '\n');
    }
}

void reading_text(const struct reading *r, const char *key, char *text, size_t size) {
    const char *at = find(r, key, strlen(key));
    *text = '\0';
    if (at && *at == '"') snprintf(text, size, "%.*s", (int)strcspn(at + 1, "\""), at + 1);
}

void reading_free(struct reading *r, int count) {
    for (int i = 0; i < count; i++) free(r[i].json);
}
