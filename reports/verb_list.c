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

static void list_gates(void) {
    struct gates all;
    struct failure why;
    gates_collect(NULL, "reference/*", 0, &all, &why);
    for (int i = 0; i < all.declared; i++) {
        const struct gate *g = &all.result[i].gate;
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

static const struct topic {
    const char *name, *about;
    void (*list)(void);
    void (*details)(void); /* with --verbose; NULL: as list */
} topics[] = {
    {"scenes", "problems with an exact solution, their parameters and defaults", list_scenes, NULL},
    {"methods", "discretizations and their options", list_methods, NULL},
    {"kernels", "smoothing kernels", list_kernels, NULL},
    {"steppers", "time steppers", list_steppers, NULL},
    {"gates", "checks of the suite itself", list_gates, NULL},
    {"battery", "checks for any code, with the fault that each detects", list_battery_rows, list_battery_details},
    {"claims", "statements of the papers", list_claims, NULL},
    {0}};

struct list_options {
    struct command command;
    int verbose;
};

static int act(const void *options, struct failure *why) {
    const struct list_options *r = options;
    const char *names[WORDS_MAX] = {0}, *topic = r->command.word[0];
    for (int i = 0; topics[i].name; i++) names[i] = topics[i].name;
    for (int i = 0; topics[i].name && !topic; i++) printf("heatladder list %-10s %s\n", names[i], topics[i].about);
    if (!topic) return STATUS_OK;
    int at = words_index(names, topic);
    if (at < 0) return words_unknown(names, "topic", topic, why);
    if (r->verbose && topics[at].details)
        topics[at].details();
    else
        topics[at].list();
    return STATUS_OK;
}

static const struct option own[] = {{"verbose", NULL, "of the battery: commands, bounds and draws; also -v",
                                     option_flag, OPTION_PLACE(list_options, verbose)},
                                    {0}};

static const struct command_syntax syntax = {"list", "[TOPIC]", "", "", NULL};

const struct verb verb_list = {&syntax, own, sizeof(struct list_options),
                               "list a TOPIC: scenes, methods, kernels, steppers, gates, battery or claims; without "
                               "one, the topics",
                               act};
