/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options of an experiment: the rows of command.def and the readers of values that are no plain number or word. */
#include "verification/case/command.h"

#include "references/scene.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/text/number.h"

#include <stdio.h>
#include <string.h>

/* T,T,... or FROM:TO:COUNT, evenly with both ends. */
static int read_times(void *options, const struct option *o, const char *text, struct failure *why) {
    struct command *c = options;
    enum { MOST = 10000000 };
    const char *first = strchr(text, ':'), *last = strrchr(text, ':');
    char word[2][40];
    long count = 0;
    c->times = 0;
    if (!first) return option_numbers(options, o, text, why);
    int bad = last == first || first - text >= 40 || last - first > 40;
    for (int k = 0; k < 2 && !bad; k++) {
        const char *from = k ? first + 1 : text;
        snprintf(word[k], sizeof word[k], "%.*s", (int)((k ? last : first) - from), from);
        bad = number_read(word[k], &c->time.value[k]) || c->time.value[k] < o->lo;
    }
    if (bad || number_read_whole(last + 1, MOST, &count) || count < 2)
        return refuse(why, STATUS_INPUT,
                      "--%s '%.60s': must be numbers with commas between, or FROM:TO:COUNT, such as "
                      "0:1.5:16, with a COUNT from 2 to %d",
                      o->name, text, MOST);
    c->time.count = 2, c->time.text = text, c->times = (int)count;
    return STATUS_OK;
}

static int read_h(void *options, const struct option *o, const char *text, struct failure *why) {
    struct command *c = options;
    if (strcmp(text, "iso") != 0) {
        if (option_number(options, o, text, why) == STATUS_OK) return STATUS_OK;
        return refuse(why, STATUS_INPUT, "--h %.60s: must be a number > 0, or iso", text);
    }
    c->experiment.options.h_iso = 1;
    return STATUS_OK;
}

static int read_choice(const struct param *p, const char *text, double *value, struct failure *why) {
    int index = words_index(p->choice, text);
    if (index < 0) return words_unknown(p->choice, p->name, text, why);
    *value = index;
    return STATUS_OK;
}

static int set_param(struct command *c, const char *name, const char *text, struct failure *why) {
    const struct param *table = c->experiment.scene->params;
    const char *names[PARAM_MAX + 1] = {0};
    char what[64];
    for (int i = 0; table[i].name; i++) names[i] = table[i].name;
    int i = words_index(names, name);
    snprintf(what, sizeof what, "parameter of %s", c->experiment.scene->name);
    if (i < 0) return words_unknown(names, what, name, why);
    if (c->overridden & 1ul << i) return refuse(why, STATUS_INPUT, "--set %s is given twice", name);
    c->overridden |= 1ul << i;
    if (table[i].choice) return read_choice(&table[i], text, &c->experiment.problem.param[i], why);
    if (number_read(text, &c->experiment.problem.param[i]) == 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--set %s=%.60s: must be a finite number%s%s", name, text,
                  *table[i].unit ? ", in " : "", table[i].unit);
}

static int read_set(void *options, const struct option *o, const char *text, struct failure *why) {
    struct command *c = options;
    char name[64];
    size_t length = strcspn(text, "=");
    if (text[length] != '=' || length == 0 || length >= sizeof name)
        return refuse(why, STATUS_INPUT, "--%s '%.60s': must be NAME=VALUE", o->name, text);
    memcpy(name, text, length);
    name[length] = '\0';
    return set_param(c, name, text + length + 1, why);
}

static int read_t_end(void *options, const struct option *o, const char *text, struct failure *why) {
    struct command *c = options;
    (void)o;
    return set_param(c, "t_end", text, why);
}

static int read_columns(void *options, const struct option *o, const char *text, struct failure *why) {
    struct command *c = options;
    (void)o;
    return samples_columns_read(text, &c->experiment.program.columns, why);
}

static int read_map(void *options, const struct option *o, const char *text, struct failure *why) {
    struct command *c = options;
    if (mapping_read(text, &c->experiment.program.map) == 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT,
                  "--%s '%.60s': must name each axis of the scene once: x or -x of a rod; x,y or "
                  "-y,x and the like of a rectangle; z,-x,y and the like of a box",
                  o->name, text);
}

static int read_vary(void *options, const struct option *o, const char *text, struct failure *why) {
    struct command *c = options;
    static const char *const taken[] = {"case", "out", "dx", NULL};
    struct program *g = &c->experiment.program;
    struct numbers *list = &c->rungs.vary;
    size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    snprintf(g->vary, sizeof g->vary, "%.*s", (int)(length < sizeof g->vary ? length : 0), text);
    if (!*g->vary || text[length] != '=' || words_index(taken, g->vary) >= 0)
        return refuse(why, STATUS_INPUT,
                      "--%s '%.60s': must be NAME=A,B,C,..., NAME of letters, digits and _, and not case, out or dx",
                      o->name, text);
    list->count = number_read_list(text + length + 1, list->value, NUMBERS_MAX);
    for (int i = 0; i < list->count; i++)
        if (!(list->value[i] > 0)) list->count = -1;
    if (list->count > 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--%s '%.60s': must be NAME=A,B,C,... with 1 to %d numbers > 0", o->name, text,
                  NUMBERS_MAX);
}

#define PLACE(member) .place = offsetof(struct command, member)
const struct option command_options[] = {
#include "verification/case/command.def"
    {0}};
#undef PLACE
