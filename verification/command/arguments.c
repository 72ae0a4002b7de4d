/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a command line against two tables: verbs.def says which options a verb has, options.def how each is read.
 *
 * The scene must be known before its parameters can be set, so the words are walked twice: first the positionals,
 * then the options in their order.  Nothing is guessed: what is unknown, doubled, empty or without a meaning for the
 * method is refused with a text that says what would be valid. */
#include "verification/command/arguments.h"

#include "references/scene.h"
#include "solver/space/operator.h"
#include "verification/command/option.h"
#include "verification/command/verb.h"
#include "verification/foreign/results.h"
#include "verification/run/lanes.h"
#include "verification/text/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LINE_WORDS = 64 };

struct word { /* one option as typed: --name value, or --name=value */
    const struct option *option;
    const char *value; /* NULL for a flag */
};

/* Words of earlier releases, and their replacements. */
static const struct {
    const char *word, *instead;
} removed[] = {
    {"operators", "heatladder report operators DIR"},
    {"stability", "heatladder report stability DIR"},
    {"claims", "heatladder report claims DIR"},
    {"page", "heatladder report page DIR"},
    {"choose", "heatladder bench, which charts error against time"},
    {"plan", "heatladder run, which refuses a run that needs more memory than is free"},
    {"--run", "a batch engine on DIR/cases.txt, then heatladder verify --results DIR"},
    {"--resume", "--keep DIR, then heatladder verify --results DIR"},
    {"--peers", "make league"},
    {"--time-error", "--fourier F; heatladder ladder --fourier A,B,C fits the order in time"},
    {"--redraw", "--layout jitter or relaxed"},
};

/* Refuses a removed word; STATUS_OK for any other. */
static int check_removed(const char *dashes, const char *name, struct failure *why) {
    char word[40];
    snprintf(word, sizeof word, "%s%.30s", dashes, name);
    for (size_t i = 0; i < sizeof removed / sizeof *removed; i++)
        if (strcmp(word, removed[i].word) == 0)
            return refuse(why, STATUS_INPUT, "%s is removed; use %s", word, removed[i].instead);
    return STATUS_OK;
}

static int unknown_verb(const char *name, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    if (check_removed("", name, why)) return why->status;
    for (int i = 0; verbs[i].name && i < WORDS_MAX - 1; i++) names[i] = verbs[i].name;
    return words_unknown(names, "verb", name, why);
}

static int take_scene(struct request *r, const char *name, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    r->experiment.scene = scene_find(name);
    if (r->experiment.scene) {
        scene_defaults(r->experiment.scene, &r->experiment.problem);
        return STATUS_OK;
    }
    for (int i = 0; scenes[i] && i < WORDS_MAX - 1; i++) names[i] = scenes[i]->name;
    return words_unknown(names, "scene", name, why);
}

static int take_method(struct request *r, const char *name, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    if (r->external) {
        r->external->name = r->experiment.program.label = name;
        return STATUS_OK;
    }
    r->experiment.method = method_find(name);
    if (r->experiment.method) return STATUS_OK;
    for (int i = 0; methods[i] && i < WORDS_MAX - 1; i++) names[i] = methods[i]->name;
    return words_unknown(names, "method", name, why);
}

/* "[a|b|c] [DIR]": one of these words, then a directory, either of which may be left out. */
static int take_study(struct request *r, int place, const char *word, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    char text[200], *rest = text;
    snprintf(text, sizeof text, "%.*s", (int)strcspn(r->verb->positionals + 1, "]"), r->verb->positionals + 1);
    for (int n = 0; n < WORDS_MAX - 1 && (names[n] = strtok_r(rest, "|", &rest)); n++) continue;
    int is_path = strchr(word, '/') || access(word, F_OK) == 0;
    if (place == 1 && r->dir) return words_unknown(names, "study", r->dir, why);
    if (place == 0 && words_index(names, word) >= 0)
        r->topic = word;
    else if (place == 0 && !is_path && words_nearest(names, word))
        return words_unknown(names, "study", word, why);
    else
        r->dir = word;
    return STATUS_OK;
}

static int take_positional(struct request *r, int place, const char *word, struct failure *why) {
    const char *wanted = r->verb->positionals;
    if (place < 2 && strchr(wanted, '|')) return take_study(r, place, word, why);
    if (place == 0 && (words_among(wanted, "SCENE") || words_among(wanted, "[SCENE]")))
        return take_scene(r, word, why);
    if (place == words_among(wanted, "SCENE") && words_among(wanted, "METHOD")) return take_method(r, word, why);
    if (place == 0 && (words_among(wanted, "[TOPIC]") || words_among(wanted, "[DIR]"))) {
        *(words_among(wanted, "[DIR]") ? &r->dir : &r->topic) = word;
        return STATUS_OK;
    }
    return refuse(why, STATUS_INPUT, "'%.60s' is one word too many for %s (wanted: %s %s)", word, r->verb->name,
                  r->verb->name, wanted);
}

static int unknown_option(const struct verb *v, const char *name, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    int n = 0;
    for (const struct option *o = options_table; o->key && n < WORDS_MAX - 1; o++)
        if (words_among(v->options, o->key)) names[n++] = o->name;
    if (strcmp(name, "set") == 0 && words_among(v->options, "ratio"))
        return refuse(why, STATUS_INPUT,
                      "--set has no meaning for %s: its step is in units of dx^2/kappa, and "
                      "only the ratio of k_y to k_x counts, --ratio R",
                      v->name);
    for (const struct option *o = options_table; o->key; o++)
        if (strcmp(o->name, name) == 0)
            return refuse(why, STATUS_INPUT, "--%s has no meaning for %s (see: heatladder %s --help)", name, v->name,
                          v->name);
    if (check_removed("--", name, why)) return why->status;
    const char *nearest = words_nearest(names, name);
    return refuse(why, STATUS_INPUT, "unknown option --%.60s%s%s%s (see: heatladder %s --help)", name,
                  nearest ? "; did you mean --" : "", nearest ? nearest : "", nearest ? "?" : "", v->name);
}

/* Reads argv[*at], and argv[*at + 1] where the option's value is a word of its own; moves *at to the last one read.
 */
static int split_option(const struct verb *v, int argc, char *const *argv, int *at, struct word *w,
                        struct failure *why) {
    char name[32];
    const char *typed = argv[*at] + 2, *equals = strchr(typed, '=');
    size_t length = equals ? (size_t)(equals - typed) : strlen(typed);
    snprintf(name, sizeof name, "%.*s", (int)(length < sizeof name ? length : sizeof name - 1), typed);
    w->option = option_find(v->options, name);
    w->value = equals ? equals + 1 : NULL;
    if (!w->option) return unknown_option(v, name, why);
    if (!w->option->value) {
        if (equals) return refuse(why, STATUS_INPUT, "--%s takes no value", name);
        return STATUS_OK;
    }
    if (equals) return STATUS_OK;
    if (*at + 1 == argc || strncmp(argv[*at + 1], "--", 2) == 0)
        return refuse(why, STATUS_INPUT, "--%s needs a value: --%s %s", name, name, w->option->value);
    w->value = argv[++*at];
    return STATUS_OK;
}

/* An option of the model must be one that the method accepts; the text names the methods that do. */
static int check_model(const struct request *r, const struct option *o, struct failure *why) {
    if (!o->model || !r->experiment.method || words_among(r->experiment.method->accepts, o->key)) return STATUS_OK;
    const char *names[WORDS_MAX] = {0};
    char text[240];
    int n = 0;
    for (int i = 0; methods[i] && n < WORDS_MAX - 1; i++)
        if (words_among(methods[i]->accepts, o->key)) names[n++] = methods[i]->name;
    words_join(names, text, sizeof text);
    return refuse(why, STATUS_INPUT, "--%s has no meaning for %s%s%s", o->name, r->experiment.method->name,
                  n ? "; it has for " : "", text);
}

static int take_option(struct request *r, const struct word *w, struct failure *why) {
    const struct option *o = w->option;
    if (r->given[o - options_table] && !words_among("set only skip", o->key))
        return refuse(why, STATUS_INPUT, "--%s is given twice", o->name);
    r->given[o - options_table] = 1;
    const struct verb *v = r->verb;
    if (v->sceneless && !r->experiment.scene && !words_among(v->sceneless, o->key))
        return refuse(why, STATUS_INPUT, "--%s needs a SCENE (see: heatladder %s --help)", o->name, v->name);
    if (check_model(r, o, why)) return why->status;
    return o->read(r, o, w->value, why);
}

static int check_positionals(const struct request *r, struct failure *why) {
    const char *wanted = r->verb->positionals;
    const char *missing = words_among(wanted, "SCENE") && !r->experiment.scene ? "SCENE"
                          : words_among(wanted, "METHOD") && (!r->experiment.method || !r->experiment.method->name)
                              ? "METHOD"
                              : NULL;
    if (!missing) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "%s needs a %s: heatladder %s %s (see: heatladder list)", r->verb->name, missing,
                  r->verb->name, wanted);
}

/* Which spacings there are, and the parameters that the cases were written for: neither is typed again. */
static int take_results(struct request *r, struct failure *why) {
    struct experiment *e = &r->experiment;
    struct program *g = &e->program;
    char dir[RESULTS_PATH];
    if (!g->results || !e->scene) return STATUS_OK;
    if (results_setting(e->scene, &e->problem, r->overridden, &g->map, e->options.aspect, g->setting) ||
        !results_has(g->results, e->scene, g->setting))
        g->setting[0] = '\0';
    if (results_of_scene(g->results, e->scene, g->setting, dir))
        return refuse(why, STATUS_INPUT, "--results '%.200s': too long a path", g->results);
    if (!r->rungs.dx.count && results_list(dir, &r->rungs.dx, why)) return why->status;
    struct results_known known = {r->overridden, &e->problem, !mapping_is_none(&g->map), &g->map, &e->options.aspect};
    return results_params(g->results, e->scene, g->setting, &r->rungs.dx, &known, why);
}

static int is_given(const struct request *r, const char *key) {
    for (const struct option *o = options_table; o->key; o++)
        if (strcmp(o->key, key) == 0) return r->given[o - options_table];
    return 0;
}

/* Where the lattice lies, and the walls that a round body has unless others are named. */
static int take_lattice(struct request *r, struct failure *why) {
    struct options *o = &r->experiment.options;
    const struct method *method = r->experiment.method;
    int round = r->experiment.scene && r->experiment.problem.shape;
    o->has_origin = r->origin.count > 0, o->has_angle = is_given(r, "angle");
    if (o->has_origin && r->origin.count != 2)
        return refuse(why, STATUS_INPUT, "--origin %.60s: needs X,Y, in dx", r->origin.text);
    for (int a = 0; a < 2 && o->has_origin; a++) o->origin[a] = r->origin.value[a];
    if (round && !is_given(r, "walls") && !(method && (!method->scheme || method->scheme->cells)))
        o->walls = WALLS_FIT;
    if (round && is_given(r, "shift"))
        return refuse(why, STATUS_INPUT, "--shift: is for plane walls; round bodies take --origin X,Y and --angle A");
    if (r->experiment.scene && !round && (o->has_origin || o->has_angle))
        return refuse(why, STATUS_INPUT, "--%s: is for round bodies; plane walls take --shift S",
                      o->has_origin ? "origin" : "angle");
    return STATUS_OK;
}

const char *const arguments_profiles[] = {"all", "particles", "slabs", NULL};

static int apply(struct request *r, const struct word *words, int count, struct failure *why) {
    for (int i = 0; i < count; i++)
        if (take_option(r, &words[i], why)) return why->status;
    if (checks_required(r, why) || take_results(r, why)) return why->status;
    if (r->experiment.scene && r->experiment.scene->setup(&r->experiment.problem, why)) return why->status;
    if (r->experiment.derived &&
        quantity_read(r->experiment.derived, &r->experiment.problem, &r->experiment.quantity, why))
        return why->status;
    r->experiment.options.dx = r->rungs.dx.value[0];
    r->experiment.options.dt = r->rungs.dt.count ? r->rungs.dt.value[0] : 0;
    r->experiment.options.fourier = r->rungs.fourier.count ? r->rungs.fourier.value[0] : 0;
    if (take_lattice(r, why)) return why->status;
    return checks_together(r, why);
}

static int has_option(int argc, char *const *argv, const char *name) {
    size_t length = strlen(name);
    for (int i = 1; i < argc; i++)
        if (strncmp(argv[i], "--", 2) == 0 && strncmp(argv[i] + 2, name, length) == 0 &&
            (argv[i][length + 2] == '\0' || argv[i][length + 2] == '='))
            return 1;
    return 0;
}

/* Whether the option is there for which a SCENE may be left out. */
static int needs_no_scene(const struct verb *v, int argc, char *const *argv) {
    char option[32];
    if (!v->sceneless) return 0;
    snprintf(option, sizeof option, "%.*s", (int)strcspn(v->sceneless, " "), v->sceneless);
    return has_option(argc, argv, option);
}

/* Any METHOD word will do where a program stands in: it is a label then, which accepts no option of the model. */
static void take_program(struct request *r) {
    r->external = xcalloc(1, sizeof *r->external);
    *r->external = (struct method){.about = "another program", .accepts = ""};
    r->experiment.method = r->external;
}

int arguments_parse(int argc, char *const *argv, struct request *r, struct failure *why) {
    char *line = r->line;
    *r = (struct request){.line = line, .draw = 1, .given = xcalloc((size_t)options_count, 1)};
    *why = (struct failure){0};
    struct word words[LINE_WORDS];
    int options = 0, positionals = 0;
    if (lanes_forced(&r->experiment.options.lanes, why)) return why->status;
    if (argc < 1) return refuse(why, STATUS_INPUT, "a verb is missing (see: heatladder --help)");
    r->typed = words_line(argc, (const char *const *)argv);
    r->verb = verb_find(argv[0]);
    if (!r->verb) return unknown_verb(argv[0], why);
    if (words_among(r->verb->options, "solver") &&
        (has_option(argc, argv, "solver") || has_option(argc, argv, "results")))
        take_program(r);
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-v") == 0 && words_among(r->verb->options, "verbose")) {
            r->verbose = 1;
        } else if (strncmp(argv[i], "--", 2) != 0) {
            if (take_positional(r, positionals++, argv[i], why)) return why->status;
        } else if (options == LINE_WORDS) {
            return refuse(why, STATUS_INPUT, "more than %d options", LINE_WORDS);
        } else if (split_option(r->verb, argc, argv, &i, &words[options++], why)) {
            return why->status;
        }
    }
    int sceneless = positionals == 0 && needs_no_scene(r->verb, argc, argv);
    if (!sceneless && check_positionals(r, why)) return why->status;
    return apply(r, words, options, why);
}

/* Splits *line in place at blanks outside of quotes.  How many words, or -1 where there are too many or a quote is
 * left open. */
static int split_line(char *line, char **words, int max) {
    int n = 0;
    char *to = line;
    for (const char *from = line;;) {
        from += strspn(from, " \t");
        if (*from == '\0') return n;
        if (n == max) return -1;
        words[n++] = to;
        char quote = '\0';
        for (; *from && (quote || !strchr(" \t", *from)); from++) {
            if (*from == quote)
                quote = '\0';
            else if (!quote && (*from == '\'' || *from == '"'))
                quote = *from;
            else
                *to++ = *from;
        }
        if (quote) return -1;
        int last = *from == '\0';
        *to++ = '\0';
        if (last) return n;
        from++;
    }
}

int arguments_parse_line_with(const char *line, const char *const *more, struct request *r, struct failure *why) {
    char *words[2 * LINE_WORDS];
    size_t size = strlen(line) + 1, room = size;
    for (const char *const *word = more; *word; word++) room += strlen(*word) + 1;
    *r = (struct request){.line = xcalloc(room, 1)};
    memcpy(r->line, line, size);
    int n = split_line(r->line, words, 2 * LINE_WORDS);
    if (n < 0) return refuse(why, STATUS_INPUT, "'%.200s': too many words, or a quote is left open", line);
    for (char *to = r->line + size; *more && n < 2 * LINE_WORDS; more++, n++) {
        words[n] = memcpy(to, *more, strlen(*more) + 1);
        to += strlen(*more) + 1;
    }
    if (*more) return refuse(why, STATUS_INPUT, "'%.200s': too many words", line);
    return arguments_parse(n, words, r, why);
}

int arguments_parse_line(const char *line, struct request *r, struct failure *why) {
    return arguments_parse_line_with(line, (const char *const[]){NULL}, r, why);
}

void arguments_free(struct request *r) {
    free(r->line);
    free(r->typed);
    free(r->external);
    free(r->only);
    free(r->skip);
    free(r->given);
    *r = (struct request){0};
}
