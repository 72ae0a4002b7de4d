/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options that lack, contradict or need each other. */
#include "solver/words.h"
#include "verification/case/command.h"

#include "references/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* "--a, --b or --c": the blank-separated names that are options of the command.  How many. */
static int join(const struct command *c, const char *names, char *text, size_t size) {
    char list[100], *rest = list;
    const char *word[8];
    int n = 0;
    snprintf(list, sizeof list, "%s", names);
    for (char *name; n < 8 && (name = strtok_r(rest, " ", &rest));)
        if (command_option(c->syntax, c->own, name)) word[n++] = name;
    *text = '\0';
    for (int i = 0; i < n; i++) words_add(text, size, "%s--%s", i == 0 ? "" : i == n - 1 ? " or " : ", ", word[i]);
    return n;
}

/* Whether one of the blank-separated names was given. */
static const struct option *any_given(const struct command *c, const char *names) {
    for (int i = 0; i < c->options; i++)
        if (words_among(names, c->given[i].option->name)) return c->given[i].option;
    return NULL;
}

static int check_pairs(const struct command *c, struct failure *why) {
    char text[100];
    for (int i = 0; i < c->options; i++) {
        const struct option *o = c->given[i].option, *other = o->excludes ? any_given(c, o->excludes) : NULL;
        if (other)
            return refuse(why, STATUS_INPUT, "--%s and --%s exclude each other: give one of them", o->name,
                          other->name);
        if (o->needs && join(c, o->needs, text, sizeof text) && !any_given(c, o->needs))
            return refuse(why, STATUS_INPUT, "--%s needs %s", o->name, text);
    }
    return STATUS_OK;
}

/* The first rule that holds refuses the command. */
struct rule {
    int refuses;
    const char *option; /* that was given */
    const char *reason, *take;
};

/* By dimension; 0: no scene. */
static const char *const points[] = {"X or X,Y or X,Y,Z", "X", "X,Y", "X,Y,Z"};
static const char *const axes[] = {"", "the scene has x alone", "the scene has x and y", "the scene has x, y and z"};
static const char *const maps[] = {"", "x or -x", "x,y or y,-x and the like", "z,-x,y and the like"};

int command_check(const struct command *c, struct failure *why) {
    const struct experiment *e = &c->experiment;
    const struct options *o = &e->options;
    const struct problem *p = &e->problem;
    const struct mapping *map = &e->program.map;
    const struct numbers *expect = &c->rungs.expect, *dt = &c->rungs.dt, *at = &c->at;
    const int scene = e->scene != NULL, round = scene && p->shape, flat = scene && !p->shape;
    const int plane = p->dim == 2, ours = e->method && e->method->scheme;
    double least = INFINITY, greatest = 0;
    for (int i = 0; i < dt->count; i++) least = fmin(least, dt->value[i]), greatest = fmax(greatest, dt->value[i]);

    const struct rule rules[] = {
        {scene && greatest > p->t_end, "dt", "a step exceeds the end time", "at most the end time"},
        {at->count > DIM_MAX || (at->count && scene && at->count != p->dim), "at",
         "the point has as many numbers as axes", points[p->dim]},
        {c->rungs.fine > 0 && !(dt->count > 1 && c->rungs.fine < least), "fine",
         "it is finer than each of several --dt", "--dt A,B,C with larger steps"},
        {c->rungs.fine > 0 && ours && !c->experiment.problem.k_law, "fine",
         "the limit of the particles' equations in time is known", "no --fine"},
        {expect->count && !(expect->count == 2 && expect->value[0] < expect->value[1]), "expect", "a band is LO < HI",
         "LO,HI such as 1.9,2.1"},
        {o->aspect > 0 && (!plane || round), "aspect", "the scene is no rectangle", "a scene on a rectangle"},
        {map->axes && map->axes != p->dim, "map", axes[p->dim], maps[p->dim]},
        {round && c->origin.count > 0 && c->origin.count != p->dim, "origin", "it is a point",
         p->dim == 3 ? "X,Y,Z, in dx" : "X,Y, in dx"},
        {round && command_given(c, "shift"), "shift", "it is for plane walls, the scene is round",
         p->dim == 3 ? "--origin X,Y,Z and --angle A" : "--origin X,Y and --angle A"},
        {flat && o->has_origin, "origin", "it is for round bodies, the scene has plane walls", "--shift S"},
        {flat && o->has_angle, "angle", "it is for round bodies, the scene has plane walls", "--shift S"},
    };
    if (check_pairs(c, why)) return why->status;
    for (size_t k = 0; k < sizeof rules / sizeof *rules; k++) {
        const char *given = command_given(c, rules[k].option);
        if (rules[k].refuses)
            return refuse(why, STATUS_INPUT, "--%s %.60s: %s; take %s", rules[k].option, given ? given : "",
                          rules[k].reason, rules[k].take);
    }
    return options_check(o, why);
}
