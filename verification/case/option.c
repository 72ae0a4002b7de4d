/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Readers of option values.  A refusal names the option, the value and the valid range. */
#include "verification/case/option.h"

#include "solver/status.h"
#include "solver/words.h"
#include "verification/text/number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *place(void *options, const struct option *o) {
    return (char *)options + o->place;
}

int option_flag(void *options, const struct option *o, const char *text, struct failure *why) {
    (void)text, (void)why;
    *(int *)place(options, o) = 1;
    return STATUS_OK;
}

int option_text(void *options, const struct option *o, const char *text, struct failure *why) {
    if (*text == '\0') return refuse(why, STATUS_INPUT, "--%s: empty; valid: %s", o->name, o->value);
    *(const char **)place(options, o) = text;
    return STATUS_OK;
}

/* Repeated options are joined. */
int option_globs(void *options, const struct option *o, const char *text, struct failure *why) {
    char **globs = place(options, o), *before = *globs;
    if (*text == '\0') return refuse(why, STATUS_INPUT, "--%s: empty; valid: %s", o->name, o->value);
    size_t size = strlen(text) + (before ? strlen(before) + 1 : 0) + 1;
    *globs = xcalloc(size, 1);
    snprintf(*globs, size, "%s%s%s", before ? before : "", before ? "," : "", text);
    free(before);
    return STATUS_OK;
}

static int refuse_number(const struct option *o, const char *text, struct failure *why) {
    char valid[80];
    if (o->lo > 0 && o->lo < 1e-99 && o->hi == INFINITY)
        snprintf(valid, sizeof valid, "a number > 0");
    else if (o->lo == -INFINITY)
        snprintf(valid, sizeof valid, "a finite number");
    else if (o->hi == INFINITY)
        snprintf(valid, sizeof valid, "a number >= %g", o->lo);
    else
        snprintf(valid, sizeof valid, "a number from %g to %g", o->lo, o->hi);
    return refuse(why, STATUS_INPUT, "--%s %.60s: must be %s", o->name, text, valid);
}

int option_number(void *options, const struct option *o, const char *text, struct failure *why) {
    double value;
    if (number_read(text, &value) || value < o->lo || value > o->hi) return refuse_number(o, text, why);
    *(double *)place(options, o) = value;
    return STATUS_OK;
}

/* Quotes the entry at fault, whole. */
static int refuse_numbers(const struct option *o, const char *text, struct failure *why) {
    const char *example = o->lo >= 0 ? "0.1,0.05,4/160" : "-0.3,0.7", *at = text;
    double value;
    for (int n = 1; n <= NUMBERS_MAX; n++) {
        int length = (int)strcspn(at, ",");
        char entry[64];
        snprintf(entry, sizeof entry, "%.*s", length, at);
        if (length >= (int)sizeof entry || number_read(entry, &value))
            return refuse(why, STATUS_INPUT,
                          "--%s: entry %d, '%.60s%s', is not a number; must be 1 to %d numbers with "
                          "commas between, such as %s",
                          o->name, n, entry, length > 60 ? "..." : "", NUMBERS_MAX, example);
        at += length + (at[length] == ',');
    }
    return refuse(why, STATUS_INPUT, "--%s: more than %d numbers", o->name, NUMBERS_MAX);
}

int option_numbers(void *options, const struct option *o, const char *text, struct failure *why) {
    struct numbers *list = place(options, o);
    list->count = number_read_list(text, list->value, NUMBERS_MAX);
    list->text = text;
    if (list->count < 0) return refuse_numbers(o, text, why);
    for (int i = 0; i < list->count; i++)
        if (list->value[i] < o->lo || list->value[i] > o->hi) return refuse_number(o, text, why);
    return STATUS_OK;
}

int option_whole(void *options, const struct option *o, const char *text, struct failure *why) {
    long value;
    if (number_read_whole(text, (long)o->hi, &value) || value < (long)o->lo)
        return refuse(why, STATUS_INPUT, "--%s %.60s: must be a whole number from %.0f to %.0f", o->name, text, o->lo,
                      o->hi);
    *(int *)place(options, o) = (int)value;
    return STATUS_OK;
}

int option_seed(void *options, const struct option *o, const char *text, struct failure *why) {
    long value;
    if (number_read_whole(text, 4294967295, &value))
        return refuse(why, STATUS_INPUT, "--%s %.60s: must be a whole number from 0 to 4294967295", o->name, text);
    *(unsigned long *)place(options, o) = (unsigned long)value;
    return STATUS_OK;
}

/* An enumerator has the size of an int.  Its value is copied as bytes because each enum is a separate type. */
int option_word(void *options, const struct option *o, const char *text, struct failure *why) {
    int value = words_index(o->words, text);
    char option[40];
    snprintf(option, sizeof option, "--%s", o->name);
    if (value < 0) return words_unknown(o->words, option, text, why);
    memcpy(place(options, o), &value, sizeof value);
    return STATUS_OK;
}
