/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder list: the available scenes, methods and other choices. */
#include "verification/cli/verb.h"

#include "references/scene.h"
#include "solver/method.h"
#include "solver/time/stepper.h"
#include "solver/words.h"
#include "reports/ledger/claims.h"
#include "reports/papers.h"
#include "verification/gates/battery.h"
#include "verification/gates/gates.h"
#include "verification/text/json.h"
#include "verification/text/output.h"
#include "verification/text/table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void list_params(const struct param *p, struct table *t) {
    for (; p->name; p++) {
        char words[96] = "";
        if (p->choice) words_join(p->choice, words, sizeof words);
        table_add(t, "   |%s", p->name);
        if (p->choice)
            table_add(t, "%s", p->choice[(int)p->value]);
        else
            table_add(t, "%g", p->value);
        table_add(t, "%s|%s%s%s", p->unit, p->about, p->choice ? ": " : "", words);
    }
}

static void list_scenes(void) {
    for (const struct scene *const *s = scenes; *s; s++) {
        struct table t = table_create(5, 5);
        printf("%s%s: %s\n  %s\n", s == scenes ? "" : "\n", (*s)->name, (*s)->about, (*s)->citation);
        list_params((*s)->params, &t);
        table_end(&t, stdout);
    }
}

static void list_methods(void) {
    for (const struct method *const *m = methods; *m; m++)
        printf("%s%s: %s\n  options: %s\n", m == methods ? "" : "\n", (*m)->name, (*m)->about, (*m)->accepts);
}

static void list_words(const char *what, const char *const *words) {
    char text[200];
    words_join(words, text, sizeof text);
    printf("%s: %s (the first is the default)\n", what, text);
}

static void list_kernels(void) {
    list_words("kernels", kernel_words);
}

static void list_steppers(void) {
    printf("steppers, auto where none is given:\n");
    for (int i = 1; stepper_words[i]; i++)
        printf("  %s: %s\n", stepper_words[i], stepper_of((enum stepper_name)i)->about);
}

static const int battery_orders[] = {2, 1, 4};

/* The faults that each row is there for, a line a row. */
static void list_battery_rows(void) {
    struct table t = table_headed(3, "row|order|detects");
    for (int k = 0; k < 3; k++)
        for (const struct battery_row *row = battery_table; row->orders; row++) {
            const char *why = row->why + strlen("detects ");
            if (row->orders & battery_orders[k])
                table_add(&t, "%s|%d|%.*s", row->id, battery_orders[k], (int)strcspn(why, ":;"), why);
        }
    table_end(&t, stdout);
    printf("\nheatladder list battery -v: commands, bounds and draws\n");
}

static const char *ranges_of(const char *id, int order) {
    for (const struct battery_row *row = battery_table; row->orders; row++)
        if (row->orders & order && strcmp(row->id, id) == 0) return row->ranges;
    return "";
}

static void list_battery_details(void) {
    for (int k = 0; k < 3; k++) {
        struct gates all = {0};
        struct failure ignored;
        battery_add(battery_orders[k], PROFILE_ALL, 0, &all, &ignored);
        battery_bounds(&all, &ignored);
        for (int i = 0; i < all.declared; i++) {
            const struct gate *g = &all.result[i].gate;
            const char *ranges = ranges_of(g->id, battery_orders[k]);
            printf("%s (order %d): %s in [%g, %g]", g->id, battery_orders[k], g->measure, g->lo, g->hi);
            if (!isnan(g->ceiling)) printf(", error at most %g", g->ceiling);
            printf("\n  heatladder %s --solver 'CMD'\n", g->command);
            if (*ranges) printf("  drawn: %s\n", ranges);
            printf("  %s\n", g->why);
        }
        gates_free(&all);
    }
}

static void list_claims(void) {
    for (const struct claims_row *row = papers_claims; row->id; row++)
        printf("%s: %s (%s)\n  expected: %s\n", row->id, row->published, row->source,
               claims_verdict_words[row->expected]);
}

/* ---- JSON: the elements of the array that has the topic's name ---- */

static void json_words(struct json *j, const char *key, const char *const *words) {
    json_array(j, key);
    for (int i = 0; words[i]; i++) json_text(j, NULL, words[i]);
    json_end(j);
}

static void json_scenes(struct json *j) {
    for (const struct scene *const *s = scenes; *s; s++) {
        json_object(j, NULL);
        json_add(j, "name %s|about %s|citation %s", (*s)->name, (*s)->about, (*s)->citation);
        json_array(j, "parameters");
        for (const struct param *p = (*s)->params; p->name; p++) {
            json_object(j, NULL);
            json_add(j, "name %s|unit %s|about %s", p->name, p->unit, p->about);
            if (p->choice)
                json_text(j, "default", p->choice[(int)p->value]), json_words(j, "choices", p->choice);
            else
                json_number(j, "default", p->value);
            json_end(j);
        }
        json_end(j);
        json_end(j);
    }
}

static void json_named(struct json *j, const char *name, const char *about, const char *options) {
    json_object(j, NULL);
    json_text(j, "name", name);
    if (about) json_text(j, "about", about);
    if (options) json_text(j, "options", options);
    json_end(j);
}

static void json_methods(struct json *j) {
    for (const struct method *const *m = methods; *m; m++) json_named(j, (*m)->name, (*m)->about, (*m)->accepts);
}

static void json_kernels(struct json *j) {
    for (int i = 0; kernel_words[i]; i++) json_named(j, kernel_words[i], NULL, NULL);
}

static void json_steppers(struct json *j) {
    for (int i = 1; stepper_words[i]; i++)
        json_named(j, stepper_words[i], stepper_of((enum stepper_name)i)->about, NULL);
}

/* order: of a row of the battery, else 0 */
static void json_gate(struct json *j, const struct gate *g, int order) {
    json_object(j, NULL);
    json_add(j, "id %s|measure %s|lo %g|hi %g|ceiling %g|command %s|why %s", g->id, g->measure, g->lo, g->hi,
             g->ceiling, g->command, g->why);
    if (order) json_add(j, "order %d|drawn %s", order, ranges_of(g->id, order));
    json_end(j);
}

/* Text and, unless j is NULL, JSON: to derive the ceilings takes seconds. */
static void list_gates(struct json *j) {
    struct gates all;
    struct failure why;
    gates_collect(NULL, NULL, 0, &all, &why);
    for (int i = 0; i < all.declared; i++) {
        const struct gate *g = &all.result[i].gate;
        if (j) json_gate(j, g, 0);
        if (strncmp(g->id, "reference/", strlen("reference/")) == 0) continue;
        printf("%s: %s in [%g, %g]", g->id, g->measure, g->lo, g->hi);
        if (!isnan(g->ceiling)) printf(", error at most %g", g->ceiling);
        printf("\n  heatladder %s\n  %s\n", g->command, g->why);
    }
    gates_free(&all);
    printf("\nand for every scene, reference/<scene>: its two forms agree within their bounds\n");
    printf("\nscene and method without a gated ladder:\n");
    for (int s = 0; scenes[s]; s++)
        for (int m = 0; methods[m]; m++)
            if (!gates_has_order(scenes[s]->name, methods[m]->name))
                printf("  %s %s\n", scenes[s]->name, methods[m]->name);
}

static void json_battery(struct json *j) {
    for (int k = 0; k < 3; k++) {
        struct gates all = {0};
        struct failure ignored;
        battery_add(battery_orders[k], PROFILE_ALL, 0, &all, &ignored);
        battery_bounds(&all, &ignored);
        for (int i = 0; i < all.declared; i++) json_gate(j, &all.result[i].gate, battery_orders[k]);
        gates_free(&all);
    }
}

static void json_claims(struct json *j) {
    for (const struct claims_row *row = papers_claims; row->id; row++) {
        json_object(j, NULL);
        json_add(j, "id %s|published %s|source %s|expected %s", row->id, row->published, row->source,
                 claims_verdict_words[row->expected]);
        json_end(j);
    }
}

static const struct topic {
    const char *name, *about;
    void (*list)(void);           /* NULL: by json */
    void (*details)(void);        /* with --verbose; NULL: as list */
    void (*json)(struct json *j); /* the elements of the array; NULL for none, where list is NULL */
} topics[] = {
    {"scenes", "problems with an exact solution, their parameters and defaults", list_scenes, NULL, json_scenes},
    {"methods", "discretizations and their options", list_methods, NULL, json_methods},
    {"kernels", "smoothing kernels", list_kernels, NULL, json_kernels},
    {"steppers", "time steppers", list_steppers, NULL, json_steppers},
    {"gates", "checks of the suite itself", NULL, NULL, list_gates},
    {"battery", "checks for any code, with the fault that each detects", list_battery_rows, list_battery_details,
     json_battery},
    {"claims", "statements of the papers", list_claims, NULL, json_claims},
    {0}};

struct list_options {
    struct command command;
    int verbose;
    const char *json_path; /* NULL for none */
};

/* The rows of a topic, or of each topic its name (NULL). */
static int write_json(const struct topic *topic, const char *path, struct failure *why) {
    struct output page;
    struct json j = json_on(output_open(&page, "%s", path));
    json_array(&j, topic ? topic->name : "topics");
    for (int i = 0; topics[i].name && !topic; i++) json_named(&j, topics[i].name, topics[i].about, NULL);
    if (topic) topic->json(&j);
    json_end(&j);
    json_end(&j);
    return output_close(&page, 1, why);
}

static int act(const void *options, struct failure *why) {
    const struct list_options *r = options;
    const char *names[WORDS_MAX] = {0}, *topic = r->command.word[0];
    for (int i = 0; topics[i].name; i++) names[i] = topics[i].name;
    int at = topic ? words_index(names, topic) : -1;
    if (topic && at < 0) return words_unknown(names, "topic", topic, why);
    if (output_check(r->json_path, why)) return why->status;
    for (int i = 0; topics[i].name && !topic; i++) printf("heatladder list %-10s %s\n", names[i], topics[i].about);
    if (topic && r->verbose && topics[at].details)
        topics[at].details();
    else if (topic && topics[at].list)
        topics[at].list();
    else if (topic && !r->json_path)
        topics[at].json(NULL);
    return r->json_path ? write_json(topic ? &topics[at] : NULL, r->json_path, why) : STATUS_OK;
}

static const struct option own[] = {{"verbose", NULL, "of the battery: commands, bounds and draws; also -v",
                                     option_flag, OPTION_PLACE(list_options, verbose)},
                                    JSON_OPTION(OPTION_PLACE(list_options, json_path), "the rows of the topic"),
                                    {0}};

static const struct command_syntax syntax = {"list", "[TOPIC]", "", "", NULL};

const struct verb verb_list = {&syntax, own, sizeof(struct list_options),
                               "list a TOPIC: scenes, methods, kernels, steppers, gates, battery or claims; without "
                               "one, the topics",
                               act};
