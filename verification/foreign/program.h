#ifndef HEATLADDER_VERIFICATION_FOREIGN_PROGRAM_H
#define HEATLADDER_VERIFICATION_FOREIGN_PROGRAM_H

/* Another program in the place of a method: run now (--solver), or judged by what it left (--results). */

#include "verification/foreign/samples.h"

#include <stddef.h>

struct failure;
struct field;
struct options;
struct problem;
struct scene;

extern const char program_help[]; /* how a program is run and what it answers, for --help */

enum { PROGRAM_PATH = 1024 };

struct program {
    const char *label;
    const char *solver;  /* the command; NULL with `results` */
    const char *results; /* the directory of answers; NULL with `solver` */
    const char *keep;    /* where case, answer and log of each rung stay; NULL for nowhere */
    double timeout;      /* s; 0 for none */
    struct column_map columns;
    const char *vary, *value; /* NAME and what it is at this rung; NULL for none */
};

/* 1 where there is a program: a command, or its answers. */
int program_given(const struct program *g);

/* DIR/SCENE/DX, with /NAME=VALUE where the program varies in NAME and /dt=DT where o->dt is given; of DX and DT the
 * fewest digits that read back the same. */
void program_directory(const char *dir, const struct program *g, const struct scene *s, const struct options *o,
                       char path[PROGRAM_PATH]);

/* The answer to *p, of the scene *s, at *o.  STATUS_OK: the caller owns *f, whose `seconds` are those of the whole
 * command, `step_seconds` those that the program says it solved for (all, where it says nothing).  STATUS_SKIPPED:
 * the program says that the case is not for it. */
int program_solve(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                  struct field *f, struct failure *why);

#endif
