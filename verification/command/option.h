/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_COMMAND_OPTION_H
#define HEATLADDER_VERIFICATION_COMMAND_OPTION_H

/* The options of the command line: one table, options.def, read by arguments.c and by the help. */

#include <stddef.h>

struct failure;
struct request;

struct option {
    const char *key;   /* what a verb's list calls it */
    const char *name;  /* as typed, after the two dashes */
    const char *value; /* what the help calls its value; NULL for a flag */
    const char *about; /* one line, with the unit */
    /* Puts `text` in its place in *r.  0, or STATUS_INPUT with *why filled. */
    int (*read)(struct request *r, const struct option *o, const char *text, struct failure *why);
    size_t offset;            /* of its place in struct request */
    const char *const *words; /* the words that it takes; NULL for another kind of value */
    double lo, hi;            /* the numbers that it takes */
    int model;                /* 1: has a meaning only for methods that accept it */
};

extern const struct option options_table[]; /* ended by a NULL key */
extern const int options_count;

/* The row of that name among those whose keys `allowed` (blank-separated) holds; NULL where there is none. */
const struct option *option_find(const char *allowed, const char *name);

#endif
