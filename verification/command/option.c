/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The readers of options' values, and their table, options.def.  A value is taken whole or refused; the text of a
 * refusal names the option, the value, and what would be valid. */
#include "verification/command/option.h"

#include "references/scene.h"
#include "verification/text/number.h"
#include "verification/command/request.h"
#include "verification/command/stack.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The smallest number that counts as positive: a bound of the table is inclusive. */
#define ABOVE_ZERO 1e-300

static void *place(struct request *r, const struct option *o) {
    return (char *)r + o->offset;
}

static int read_flag(struct request *r, const struct option *o, const char *text, struct failure *why) {
    (void)text, (void)why;
    *(int *)place(r, o) = 1;
    return STATUS_OK;
}

static int read_text(struct request *r, const struct option *o, const char *text, struct failure *why) {
    if (*text == '\0') return refuse(why, STATUS_INPUT, "--%s: empty; valid: %s", o->name, o->value);
    *(const char **)place(r, o) = text;
    return STATUS_OK;
}

/* May be given again: the globs are joined. */
static int read_globs(struct request *r, const struct option *o, const char *text, struct failure *why) {
    char **globs = place(r, o), *before = *globs;
    if (*text == '\0') return refuse(why, STATUS_INPUT, "--%s: empty; valid: %s", o->name, o->value);
    size_t size = strlen(text) + (before ? strlen(before) + 1 : 0) + 1;
    *globs = xcalloc(size, 1);
    snprintf(*globs, size, "%s%s%s", before ? before : "", before ? "," : "", text);
    free(before);
    return STATUS_OK;
}

static int refuse_number(const struct option *o, const char *text, struct failure *why) {
    char valid[80];
    if (o->lo == ABOVE_ZERO && o->hi == INFINITY)
        snprintf(valid, sizeof valid, "a number > 0");
    else if (o->lo == -INFINITY)
        snprintf(valid, sizeof valid, "a finite number");
    else if (o->hi == INFINITY)
        snprintf(valid, sizeof valid, "a number >= %g", o->lo);
    else
        snprintf(valid, sizeof valid, "a number from %g to %g", o->lo, o->hi);
    return refuse(why, STATUS_INPUT, "--%s %.60s: must be %s", o->name, text, valid);
}

static int read_number(struct request *r, const struct option *o, const char *text, struct failure *why) {
    double value;
    if (number_read(text, &value) || value < o->lo || value > o->hi) return refuse_number(o, text, why);
    *(double *)place(r, o) = value;
    return STATUS_OK;
}

static int read_numbers(struct request *r, const struct option *o, const char *text, struct failure *why) {
    struct numbers *list = place(r, o);
    list->count = number_read_list(text, list->value, NUMBERS_MAX);
    list->text = text;
    if (list->count < 0)
        return refuse(why, STATUS_INPUT, "--%s '%.60s': must be 1 to %d numbers with commas between, such as %s",
                      o->name, text, NUMBERS_MAX, o->lo >= 0 ? "0.1,0.05,4/160" : "-0.3,0.7");
    for (int i = 0; i < list->count; i++)
        if (list->value[i] < o->lo || list->value[i] > o->hi) return refuse_number(o, text, why);
    return STATUS_OK;
}

/* T,T,... or FROM:TO:COUNT, evenly, both ends with them. */
static int read_times(struct request *r, const struct option *o, const char *text, struct failure *why) {
    enum { MOST = 10000000 };
    const char *first = strchr(text, ':'), *last = strrchr(text, ':');
    char word[2][40];
    long count = 0;
    r->times = 0;
    if (!first) return read_numbers(r, o, text, why);
    int bad = last == first || first - text >= 40 || last - first > 40;
    for (int k = 0; k < 2 && !bad; k++) {
        const char *from = k ? first + 1 : text;
        snprintf(word[k], sizeof word[k], "%.*s", (int)((k ? last : first) - from), from);
        bad = number_read(word[k], &r->time.value[k]) || r->time.value[k] < o->lo;
    }
    if (bad || number_read_whole(last + 1, MOST, &count) || count < 2)
        return refuse(why, STATUS_INPUT,
                      "--%s '%.60s': must be numbers with commas between, or FROM:TO:COUNT, such as "
                      "0:1.5:16, with a COUNT from 2 to %d",
                      o->name, text, MOST);
    r->time.count = 2, r->time.text = text, r->times = (int)count;
    return STATUS_OK;
}

static int read_whole(struct request *r, const struct option *o, const char *text, struct failure *why) {
    long value;
    if (number_read_whole(text, (long)o->hi, &value) || value < (long)o->lo)
        return refuse(why, STATUS_INPUT, "--%s %.60s: must be a whole number from %.0f to %.0f", o->name, text, o->lo,
                      o->hi);
    *(int *)place(r, o) = (int)value;
    return STATUS_OK;
}

static int read_order_of(struct request *r, const struct option *o, const char *text, struct failure *why) {
    long value;
    if (number_read_whole(text, 4, &value) || value == 0 || value == 3)
        return refuse(why, STATUS_INPUT, "--%s %.60s: must be 1, 2 or 4", o->name, text);
    *(int *)place(r, o) = (int)value;
    return STATUS_OK;
}

static int read_seed(struct request *r, const struct option *o, const char *text, struct failure *why) {
    long value;
    if (number_read_whole(text, 4294967295, &value))
        return refuse(why, STATUS_INPUT, "--%s %.60s: must be a whole number from 0 to 4294967295", o->name, text);
    *(unsigned long *)place(r, o) = (unsigned long)value;
    return STATUS_OK;
}

/* An enumerator has the size of an int; its place is written as bytes, since each is a type of its own. */
static int read_word(struct request *r, const struct option *o, const char *text, struct failure *why) {
    int value = words_index(o->words, text);
    if (value < 0) return words_unknown(o->words, o->name, text, why);
    memcpy(place(r, o), &value, sizeof value);
    return STATUS_OK;
}

static int read_h(struct request *r, const struct option *o, const char *text, struct failure *why) {
    if (strcmp(text, "iso") != 0) {
        if (read_number(r, o, text, why) == STATUS_OK) return STATUS_OK;
        return refuse(why, STATUS_INPUT, "--h %.60s: must be a number > 0, or iso", text);
    }
    r->experiment.options.h_iso = 1;
    return STATUS_OK;
}

static int read_choice(const struct param *p, const char *text, double *value, struct failure *why) {
    int index = words_index(p->choice, text);
    if (index < 0) return words_unknown(p->choice, p->name, text, why);
    *value = index;
    return STATUS_OK;
}

static int set_param(struct request *r, const char *name, const char *text, struct failure *why) {
    const struct param *table = r->experiment.scene->params;
    const char *names[PARAM_MAX + 1] = {0};
    char what[64];
    for (int i = 0; table[i].name; i++) names[i] = table[i].name;
    int i = words_index(names, name);
    snprintf(what, sizeof what, "parameter of %s", r->experiment.scene->name);
    if (i < 0) return words_unknown(names, what, name, why);
    if (r->overridden & 1ul << i) return refuse(why, STATUS_INPUT, "parameter '%s' is given twice", name);
    r->overridden |= 1ul << i;
    if (table[i].choice) return read_choice(&table[i], text, &r->experiment.problem.param[i], why);
    if (number_read(text, &r->experiment.problem.param[i]) == 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--set %s=%.60s: must be a finite number%s%s", name, text,
                  *table[i].unit ? ", in " : "", table[i].unit);
}

static int read_set(struct request *r, const struct option *o, const char *text, struct failure *why) {
    char name[64];
    size_t length = strcspn(text, "=");
    if (text[length] != '=' || length == 0 || length >= sizeof name)
        return refuse(why, STATUS_INPUT, "--%s '%.60s': must be NAME=VALUE", o->name, text);
    memcpy(name, text, length);
    name[length] = '\0';
    return set_param(r, name, text + length + 1, why);
}

static int read_t_end(struct request *r, const struct option *o, const char *text, struct failure *why) {
    (void)o;
    return set_param(r, "t_end", text, why);
}

static int read_columns(struct request *r, const struct option *o, const char *text, struct failure *why) {
    (void)o;
    return samples_columns_read(text, &r->experiment.program.columns, why);
}

static int read_map(struct request *r, const struct option *o, const char *text, struct failure *why) {
    if (mapping_read(text, &r->experiment.program.map) == 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT,
                  "--%s '%.60s': must name each axis of the scene once: x or -x of a rod; x,y or "
                  "-y,x and the like of a rectangle",
                  o->name, text);
}

static int read_vary(struct request *r, const struct option *o, const char *text, struct failure *why) {
    static const char *const taken[] = {"case", "out", "dx", NULL};
    struct program *g = &r->experiment.program;
    struct numbers *list = &r->rungs.vary;
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

#define IN(member) offsetof(struct request, member)
#define OPTION(key, name, value, about, reader, offset, lo, hi, model)                                               \
    {key, name, value, about, reader, offset, NULL, lo, hi, model},
#define FLAG(name, about, place) OPTION(name, name, NULL, about, read_flag, IN(place), 0, 0, 0)
#define TEXT(name, value, about, place) OPTION(name, name, value, about, read_text, IN(place), 0, 0, 0)
#define WORD(name, value, about, place, words, model)                                                                \
    {name, name, value, about, read_word, IN(place), words, 0, 0, model},
#define NUMBER(name, value, about, place, lo, hi, model)                                                             \
    OPTION(name, name, value, about, read_number, IN(place), lo, hi, model)
#define NUMBERS(name, value, about, place, lo, hi)                                                                   \
    OPTION(name, name, value, about, read_numbers, IN(place), lo, hi, 0)
#define WHOLE(name, value, about, place, lo, hi, model)                                                              \
    OPTION(name, name, value, about, read_whole, IN(place), lo, hi, model)
const struct option options_table[] = {
#include "verification/command/options.def"
    {0}};
const int options_count = (int)(sizeof options_table / sizeof *options_table) - 1;

const struct option *option_find(const char *allowed, const char *name) {
    for (const struct option *o = options_table; o->key; o++)
        if (strcmp(o->name, name) == 0 && words_among(allowed, o->key)) return o;
    return NULL;
}
