/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_OPTION_H
#define HEATLADDER_VERIFICATION_CASE_OPTION_H

/* Options of a command line: rows of tables, which the parser, the help and the manual page read. */

#include <math.h>
#include <stddef.h>

struct failure;

/* One option.  Members that a row leaves out are 0. */
struct option {
    const char *name;  /* as typed, without the dashes; "": `about` is the heading of the rows that follow */
    const char *value; /* the help's name of the value; NULL for a flag */
    const char *about; /* one line, with the unit */
    /* Stores the value of `text` in *options.  0, or STATUS_INPUT with *why filled. */
    int (*read)(void *options, const struct option *o, const char *text, struct failure *why);
    size_t place;             /* offset of the value in *options */
    double lo, hi;            /* numbers that it takes */
    const char *const *words; /* words that it takes */
    const char *needs;        /* options, blank-separated: one must be given too, where the command has any of them */
    const char *excludes;     /* options that may not be given too */
    int model;                /* 1: only for methods that accept it */
    int repeats;              /* 1: may be given several times */
};

#define OPTION_PLACE(type, member) .place = offsetof(struct type, member)
#define OPTION_POSITIVE 1e-300, INFINITY /* range of a number > 0: bounds are inclusive */

/* Readers: *options has at `place` an int, a const char *, a char * that the caller frees, a double, a struct
 * numbers, an int, an unsigned long, an enum whose values are places in `words`. */
int option_flag(void *options, const struct option *o, const char *text, struct failure *why);
int option_text(void *options, const struct option *o, const char *text, struct failure *why);
int option_globs(void *options, const struct option *o, const char *text, struct failure *why);
int option_number(void *options, const struct option *o, const char *text, struct failure *why);
int option_numbers(void *options, const struct option *o, const char *text, struct failure *why);
int option_whole(void *options, const struct option *o, const char *text, struct failure *why);
int option_seed(void *options, const struct option *o, const char *text, struct failure *why);
int option_word(void *options, const struct option *o, const char *text, struct failure *why);

#endif
