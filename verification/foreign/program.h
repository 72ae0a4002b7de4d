/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_PROGRAM_H
#define HEATLADDER_VERIFICATION_FOREIGN_PROGRAM_H

/* Another program in the place of a method: run now (--solver), or judged by what it left (--results). */

#include "references/mapping.h"
#include "verification/foreign/samples.h"

struct field;
struct options;
struct runs;
struct scene;

enum { PROGRAM_SETTING = 200 };

extern const char program_help[]; /* how a program is run and what it answers, for --help */

struct program {
    const char *label;
    const char *solver;  /* the command; NULL with `results` */
    const char *results; /* the directory of answers, DIR/SCENE/DX; NULL with `solver` */
    const char *keep;    /* directory for case, answer and log of each rung; NULL for none */
    int seeds, seed;     /* draws of each rung, 0 for one; which one it is, from 1, for the case; 0: none */
    double timeout;      /* s; 0 for none */
    struct column_map columns;
    struct mapping map;            /* between the scene and the case that the program solves */
    char vary[40], value[40];      /* NAME of --vary, and what it is at this rung; "" for none */
    char setting[PROGRAM_SETTING]; /* the parameters' directory below SCENE; "" for SCENE itself */
    struct runs *runs;             /* shared state of the runs of one program (runs.h); NULL for none */
    const char *row;               /* which gate asks, to be shown; NULL for none */
    char rung[100];                /* the directory of this rung below DX: NAME=VALUE or dt=DT; "" for DX itself */
};

/* STATUS_OK where the command, if there is one, has the places of its two files; else STATUS_INPUT. */
int program_check(const struct program *g, struct failure *why);

/* A copy of *f, an answer, in the axes and temperatures of the case: as the program gave it, to rounding.  *exact of
 * the same points, where not NULL, is mapped in place.  End with field_free. */
struct field program_as_given(const struct program *g, const struct field *f, double *exact);

/* The answer to *p, of the scene *s, at *o.  STATUS_OK: the caller owns *f, whose `seconds` are those of the whole
 * command, `step_seconds` those that the program says it solved for (all, where it says nothing).  STATUS_SKIPPED:
 * the program says that the case is not for it. */
int program_solve(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                  struct field *f, struct failure *why);

#endif
