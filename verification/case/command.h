/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_COMMAND_H
#define HEATLADDER_VERIFICATION_CASE_COMMAND_H

/* From the words of a command line to an experiment, checked and with its problem set up. */

#include "verification/case/option.h"
#include "verification/case/experiment.h"

/* Words that a command takes, beside its own options. */
struct command_syntax {
    const char *name;
    const char *positionals; /* blank-separated: SCENE, METHOD; in brackets: optional; [a|b]: one of these words */
    const char *required;    /* names of options that must be given */
    const char *options;     /* names of the rows of command_options that it takes */
    const char *sceneless;   /* options that need no SCENE; the first of them makes it optional; NULL: none */
};

/* Commands of gates and claims. */
enum { COMMAND_RUN, COMMAND_LADDER, COMMAND_LIMIT, COMMAND_REFERENCE, COMMAND_COUNT };
extern const struct command_syntax command_syntaxes[COMMAND_COUNT];

extern const struct option command_options[]; /* rows of command.def; ended by a NULL name */

enum { COMMAND_WORDS = 64 };     /* most options of a line */
enum { COMMAND_THREADS = 1024 }; /* most threads of a run: of each 100 kB are on the stack that starts it */

struct command {
    struct experiment experiment; /* scene and method: NULL where the command takes none.  dx, dt and fourier are the
                                     first of the lists in `rungs` */
    struct ladder_rungs rungs;
    struct numbers at;        /* m: a number for each axis */
    struct numbers time;      /* s */
    int times;                /* > 1: so many, evenly from time.value[0] to [1]; 0: those of `time` */
    struct numbers origin;    /* dx: of the lattice of a round body */
    double ratio;             /* limit: kappa_y/kappa_x; 0: 1 */
    double field;             /* limit: degrees */
    double contact;           /* limit: k and rho c of the second material over those of the first; 0: one material */
    int dim, stages;          /* limit: 1 to 3; of a step, 0 if they are not chosen */
    const char *word[2];      /* the positionals as typed; NULL for none */
    unsigned long overridden; /* bits of the scene's parameters that were given */
    char *typed;              /* owned: the command, quoted for a shell */

    const struct command_syntax *syntax;
    const struct option *own; /* further options; ended by a NULL name */
    struct {
        const struct option *option;
        const char *value; /* NULL for a flag */
    } given[COMMAND_WORDS];
    int options;             /* how many were given */
    struct method *external; /* owned: stands for another program; else NULL */
    char *line;              /* owned: the words of a command that was given as one line; else NULL */
};

/* Reads the words of a command; argv[0] is its name.  *options, all zero before, begins with a struct command; the
 * places of the `own` rows are in it.  0, or STATUS_INPUT with *why filled; command_free in either case. */
int command_parse(const struct command_syntax *syntax, const struct option *own, int argc, char *const *argv,
                  void *options, struct failure *why);

/* The same for a run, ladder, limit or reference in one line, as typed after the name of the program; '...' and "..."
 * hold blanks.  `more`: words that follow, ended by NULL. */
int command_read(const char *line, struct command *c, struct failure *why);
int command_read_with(const char *line, const char *const *more, struct command *c, struct failure *why);

/* Splits *line in place at blanks outside of quotes.  The number of words, at most max; -1 if there are more or a
 * quote is left open. */
int command_words(char *line, char **words, int max);

/* Frees what *options, which begins with a struct command, owns. */
void command_free(void *options);

/* Whether the command takes the option, by its name: its row, or NULL. */
const struct option *command_option(const struct command_syntax *syntax, const struct option *own, const char *name);

/* The text of an option as given; "" for a flag; NULL where it was not given. */
const char *command_given(const struct command *c, const char *name);

/* No option contradicts another or lacks one that it needs (command_checks.c).  STATUS_OK or STATUS_INPUT. */
int command_check(const struct command *c, struct failure *why);

#endif
