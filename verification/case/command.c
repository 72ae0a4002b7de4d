/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a command line against its syntax and two tables of options.
 *
 * The scene must be known before its parameters can be set, so the words are walked twice: first the positionals,
 * then the options in their order.  A word that is unknown, doubled, empty or without a meaning for the method is
 * refused, with the valid ones. */
#include "verification/case/command.h"

#include "references/scene.h"
#include "solver/space/operator.h"
#include "solver/words.h"
#include "verification/case/results.h"
#include "verification/case/lanes.h"
#include "verification/text/shell.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Syntax ---- */

#define MODEL                                                                                                        \
    " stepper kernel h order layout jitter sweeps seed sampling shift origin angle walls mean cross volume xi "      \
    "domain threads t-end set"
#define PROGRAM " solver results keep timeout columns aspect map scale offset"
const struct command_syntax command_syntaxes[] = {
    [COMMAND_RUN] = {"run", "SCENE METHOD", "dx", "dx dt fourier memory quantity" MODEL PROGRAM, NULL},
    [COMMAND_LADDER] = {"ladder", "SCENE METHOD", "",
                        "dx dt fourier memory quantity vary fine seeds at expect ceiling norm" MODEL PROGRAM,
                        "results columns at expect json"},
    [COMMAND_LIMIT] =
        {"limit", "METHOD", "dim",
         "dim stepper stages kernel h order layout jitter sweeps seed volume walls ratio field cross contact", NULL},
    [COMMAND_REFERENCE] = {"reference", "SCENE", "", "at time t-end set map scale offset", NULL}};
#undef MODEL
#undef PROGRAM

static const struct option *find(const struct option *table, const char *name) {
    for (const struct option *o = table; o && o->name; o++)
        if (*name && strcmp(o->name, name) == 0) return o;
    return NULL;
}

const struct option *command_option(const struct command_syntax *syntax, const struct option *own, const char *name) {
    const struct option *o = find(own, name);
    return o || !words_among(syntax->options, name) ? o : find(command_options, name);
}

const char *command_given(const struct command *c, const char *name) {
    for (int i = 0; i < c->options; i++)
        if (strcmp(c->given[i].option->name, name) == 0) return c->given[i].value ? c->given[i].value : "";
    return NULL;
}

/* ---- Words ---- */

static int take_scene(struct command *c, const char *name, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    c->experiment.scene = scene_find(name);
    if (c->experiment.scene) {
        scene_defaults(c->experiment.scene, &c->experiment.problem);
        return STATUS_OK;
    }
    if (strchr(name, ' '))
        return refuse(why, STATUS_INPUT, "'%.60s' is one argument, and should be several: split it at blanks", name);
    for (int i = 0; scenes[i] && i < WORDS_MAX - 1; i++) names[i] = scenes[i]->name;
    return words_unknown(names, "scene", name, why);
}

static int take_method(struct command *c, const char *name, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    if (c->external) {
        c->external->name = c->experiment.program.label = name;
        return STATUS_OK;
    }
    c->experiment.method = method_find(name);
    if (c->experiment.method) return STATUS_OK;
    for (int i = 0; methods[i] && i < WORDS_MAX - 1; i++) names[i] = methods[i]->name;
    return words_unknown(names, "method", name, why);
}

static int missing(const struct command *c, const char *what, struct failure *why) {
    return refuse(why, STATUS_INPUT, "%s needs a %s: heatladder %s %s (see: heatladder list)", c->syntax->name, what,
                  c->syntax->name, c->syntax->positionals);
}

/* The words of SCENE and METHOD, which the first of the `sceneless` options makes optional. */
static int take_words(struct command *c, struct failure *why) {
    const char *wanted = c->syntax->positionals, *sceneless = c->syntax->sceneless;
    char option[32] = "";
    if (sceneless) snprintf(option, sizeof option, "%.*s", (int)strcspn(sceneless, " "), sceneless);
    int scene = words_among(wanted, "SCENE"), method = words_among(wanted, "METHOD"), optional = !scene && !method;
    if (!c->word[0] && (optional || command_given(c, option))) return STATUS_OK;
    if (scene || words_among(wanted, "[SCENE]")) {
        if (!c->word[0]) return missing(c, "SCENE", why);
        if (take_scene(c, c->word[0], why)) return why->status;
    }
    if (!method) return STATUS_OK;
    return c->word[scene] ? take_method(c, c->word[scene], why) : missing(c, "METHOD", why);
}

/* ---- Options ---- */

static int unknown_option(const struct command *c, const char *name, struct failure *why) {
    const char *names[WORDS_MAX] = {0}, *command = c->syntax->name;
    int n = 0;
    if (find(command_options, name))
        return refuse(why, STATUS_INPUT, "--%s has no meaning for %s (see: heatladder %s --help)", name, command,
                      command);
    if (strcmp(name, "dy") == 0 || strcmp(name, "dz") == 0)
        return refuse(why, STATUS_INPUT,
                      "unknown option --%s; --dx is the spacing along every axis, and --aspect R "
                      "makes dy = R dx",
                      name);
    for (const struct option *o = c->own; o && o->name; o++)
        if (*o->name) names[n++] = o->name; /* not a heading */
    for (const struct option *o = command_options; o->name; o++)
        if (words_among(c->syntax->options, o->name)) names[n++] = o->name;
    const char *nearest = words_nearest(names, name);
    return refuse(why, STATUS_INPUT, "unknown option --%.60s%s%s%s (see: heatladder %s --help)", name,
                  nearest ? "; did you mean --" : "", nearest ? nearest : "", nearest ? "?" : "", command);
}

/* Notes argv[*at] as given, with argv[*at + 1] where its value is a word of its own; *at: the last one read. */
static int split_option(struct command *c, int argc, char *const *argv, int *at, struct failure *why) {
    char name[32];
    const char *typed = strcmp(argv[*at], "-v") == 0 ? "verbose" : argv[*at] + 2, *equals = strchr(typed, '=');
    size_t length = equals ? (size_t)(equals - typed) : strlen(typed);
    snprintf(name, sizeof name, "%.*s", (int)(length < sizeof name ? length : sizeof name - 1), typed);
    const struct option *o = command_option(c->syntax, c->own, name);
    if (!o) return unknown_option(c, name, why);
    if (c->options == COMMAND_WORDS) return refuse(why, STATUS_INPUT, "more than %d options", COMMAND_WORDS);
    if (!o->repeats && command_given(c, name)) return refuse(why, STATUS_INPUT, "--%s is given twice", name);
    if (!o->value && equals) return refuse(why, STATUS_INPUT, "--%s takes no value", name);
    const char *value = equals ? equals + 1 : NULL;
    if (o->value && !value) {
        if (*at + 1 == argc || strncmp(argv[*at + 1], "--", 2) == 0)
            return refuse(why, STATUS_INPUT, "--%s needs a value: --%s %s", name, name, o->value);
        value = argv[++*at];
    }
    c->given[c->options].option = o;
    c->given[c->options++].value = value;
    return STATUS_OK;
}

/* An option of the model must be one that the method accepts; the text names the methods that do. */
static int check_model(const struct command *c, const struct option *o, struct failure *why) {
    const struct method *method = c->experiment.method;
    if (!o->model || !method || words_among(method->accepts, o->name)) return STATUS_OK;
    const char *names[WORDS_MAX] = {0};
    char text[240];
    int n = 0;
    for (int i = 0; methods[i] && n < WORDS_MAX - 1; i++)
        if (words_among(methods[i]->accepts, o->name)) names[n++] = methods[i]->name;
    words_join(names, text, sizeof text);
    return refuse(why, STATUS_INPUT, "--%s has no meaning for %s%s%s", o->name, method->name,
                  n ? "; it has for " : "", text);
}

static int read_options(void *options, struct failure *why) {
    struct command *c = options;
    const char *sceneless = c->syntax->sceneless, *name = c->syntax->name;
    for (int i = 0; i < c->options; i++) {
        const struct option *o = c->given[i].option;
        if (sceneless && !c->experiment.scene && !words_among(sceneless, o->name))
            return refuse(why, STATUS_INPUT, "--%s needs a SCENE (see: heatladder %s --help)", o->name, name);
        if (check_model(c, o, why) || o->read(options, o, c->given[i].value, why)) return why->status;
    }
    char required[100], *rest = required;
    snprintf(required, sizeof required, "%s", c->syntax->required);
    for (const char *word; (word = strtok_r(rest, " ", &rest));)
        if (!command_given(c, word)) {
            const struct option *o = command_option(c->syntax, c->own, word);
            return refuse(why, STATUS_INPUT, "%s needs --%s %s: %s", name, word, o->value, o->about);
        }
    return STATUS_OK;
}

/* ---- The experiment ---- */

/* The spacings of existing answers, and the parameters that their cases were written for. */
static int take_results(struct command *c, struct failure *why) {
    struct experiment *e = &c->experiment;
    struct program *g = &e->program;
    char dir[RESULTS_PATH];
    if (!g->results || !e->scene) return STATUS_OK;
    if (results_setting(e->scene, &e->problem, c->overridden, &g->map, e->options.aspect, g->setting) ||
        !results_has(g->results, e->scene, g->setting))
        g->setting[0] = '\0';
    if (results_of_scene(g->results, e->scene, g->setting, dir))
        return refuse(why, STATUS_INPUT, "--results '%.200s': too long a path", g->results);
    if (!c->rungs.dx.count && results_list(dir, &c->rungs.dx, why)) return why->status;
    struct results_known known = {c->overridden, &e->problem, !mapping_is_none(&g->map), &g->map, &e->options.aspect};
    return results_params(g->results, e->scene, g->setting, &c->rungs.dx, &known, why);
}

/* The place of the lattice, and the default walls of a round body. */
static void take_lattice(struct command *c) {
    struct options *o = &c->experiment.options;
    const struct method *method = c->experiment.method;
    int round = c->experiment.scene && c->experiment.problem.shape;
    o->has_origin = c->origin.count > 0, o->has_angle = command_given(c, "angle") != NULL;
    for (int a = 0; a < c->origin.count && a < 3; a++) o->origin[a] = c->origin.value[a];
    if (round && !command_given(c, "walls") && !(method && (!method->scheme || method->scheme->cells)))
        o->walls = WALLS_FIT;
}

static int apply(struct command *c, struct failure *why) {
    struct experiment *e = &c->experiment;
    int ladder = command_option(c->syntax, NULL, "vary") != NULL;
    if (read_options(c, why)) return why->status;
    if (ladder && !c->rungs.dx.count && !e->program.results)
        return refuse(why, STATUS_INPUT, "%s needs --dx A,B,C,..., or --results DIR with a directory a spacing",
                      c->syntax->name);
    if (take_results(c, why)) return why->status;
    if (e->scene && e->scene->setup(&e->problem, why)) return why->status;
    if (e->derived && quantity_read(e->derived, &e->problem, &e->quantity, why)) return why->status;
    if (e->program.map.axes && !e->problem.shape) e->quantity.side = mapping_side(&e->program.map, e->quantity.side);
    e->options.dx = c->rungs.dx.value[0];
    e->options.dt = c->rungs.dt.count ? c->rungs.dt.value[0] : 0;
    e->options.fourier = c->rungs.fourier.count ? c->rungs.fourier.value[0] : 0;
    take_lattice(c);
    return command_check(c, why);
}

/* METHOD is the name of the program, which accepts no option of the model. */
static void take_program(struct command *c) {
    c->external = xcalloc(1, sizeof *c->external);
    *c->external = (struct method){.about = "another program", .accepts = ""};
    c->experiment.method = c->external;
    c->experiment.external = 1;
}

int command_parse(const struct command_syntax *syntax, const struct option *own, int argc, char *const *argv,
                  void *options, struct failure *why) {
    struct command *c = options;
    int words = 0, most = 0;
    for (const char *at = syntax->positionals; *at; at += strcspn(at, " "), at += *at == ' ') most++;
    c->syntax = syntax, c->own = own;
    c->typed = shell_line(argc, (const char *const *)argv);
    *why = (struct failure){0};
    for (int i = 1; i < argc; i++) {
        int verbose = strcmp(argv[i], "-v") == 0 && command_option(syntax, own, "verbose");
        if (verbose || strncmp(argv[i], "--", 2) == 0) {
            if (split_option(c, argc, argv, &i, why)) return why->status;
        } else if (words == most) {
            return refuse(why, STATUS_INPUT, "'%.60s' is one word too many for %s (wanted: %s %s)", argv[i],
                          syntax->name, syntax->name, syntax->positionals);
        } else {
            c->word[words++] = argv[i];
        }
    }
    if (lanes_forced(&c->experiment.options.lanes, why)) return why->status;
    if (command_given(c, "solver") || command_given(c, "results")) take_program(c);
    return take_words(c, why) ? why->status : apply(c, why);
}

/* ---- One line ---- */

int command_words(char *line, char **words, int max) {
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

int command_read_with(const char *line, const char *const *more, struct command *c, struct failure *why) {
    char *words[2 * COMMAND_WORDS];
    size_t size = strlen(line) + 1, room = size;
    for (const char *const *word = more; *word; word++) room += strlen(*word) + 1;
    *c = (struct command){.line = xcalloc(room, 1)};
    memcpy(c->line, line, size);
    int n = command_words(c->line, words, 2 * COMMAND_WORDS);
    if (n < 0) return refuse(why, STATUS_INPUT, "'%.200s': too many words, or a quote is left open", line);
    for (char *to = c->line + size; *more && n < 2 * COMMAND_WORDS; to += strlen(*more++) + 1)
        words[n++] = strcpy(to, *more);
    if (*more) return refuse(why, STATUS_INPUT, "'%.200s': too many words", line);
    const char *names[COMMAND_COUNT + 1] = {0};
    for (int i = 0; i < COMMAND_COUNT; i++) names[i] = command_syntaxes[i].name;
    int found = n ? words_index(names, words[0]) : -1;
    if (found < 0) return words_unknown(names, "verb", n ? words[0] : "", why);
    return command_parse(&command_syntaxes[found], NULL, n, words, c, why);
}

int command_read(const char *line, struct command *c, struct failure *why) {
    return command_read_with(line, (const char *const[]){NULL}, c, why);
}

void command_free(void *options) {
    struct command *c = options;
    for (const struct option *o = c->own; o && o->name; o++)
        if (o->read == option_globs) free(*(char **)((char *)options + o->place));
    free(c->line);
    free(c->typed);
    free(c->external);
    *c = (struct command){0};
}
