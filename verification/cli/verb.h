/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CLI_VERB_H
#define HEATLADDER_VERIFICATION_CLI_VERB_H

/* The verbs of the command line.  A new one is a row of verbs.def and a file with its struct verb. */

#include "verification/case/command.h"

struct verb {
    const struct command_syntax *syntax;
    const struct option *own; /* options beside those of the syntax; ended by a NULL name; NULL: none */
    size_t size;              /* size of its options, a struct that begins with a struct command */
    const char *about;        /* one line */
    /* Runs the verb.  Returns a status of solver/status.h; *why, empty on entry, gives the reason of a failure. */
    int (*act)(const void *options, struct failure *why);
};

#define VERB(name) extern const struct verb verb_##name;
#include "verification/cli/verbs.def"
#undef VERB

extern const struct verb *const verbs[]; /* ended by NULL */

/* Lists the rows of the verb's options in the order of the help, with the headings (option.h) of the groups that are
 * not empty; returns their number. */
enum { VERB_ROWS = 100 };
int verb_options(const struct verb *v, const struct option *list[VERB_ROWS]);

const struct verb *verb_find(const char *name); /* NULL if there is none */

/* The row of --json; its place is a const char *, NULL where it is not given. */
#define JSON_OPTION(place, ...)                                                                                      \
    {                                                                                                                \
        "json", "FILE",                                                                                              \
            "write " __VA_ARGS__ " as JSON; - for standard output, the text then goes to standard error",            \
            option_text, place                                                                                       \
    }

/* The row of --csv, the same. */
#define CSV_OPTION(place, ...)                                                                                       \
    {                                                                                                                \
        "csv", "FILE", "write " __VA_ARGS__ " as CSV, with the columns of JSON; - for standard output", option_text, \
            place                                                                                                    \
    }

/* Refuses an unknown verb and suggests the nearest one or its replacement. */
int verb_unknown(const char *name, struct failure *why);

#endif
