/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_PROGRAM_H
#define HEATLADDER_VERIFICATION_SOLVE_PROGRAM_H

/* An external program in place of a method: run now (--solver), or judged by existing answers (--results). */

#include "references/mapping.h"
#include "verification/case/samples.h"

struct field;
struct options;
struct runs;
struct scene;

enum { PROGRAM_SETTING = 200 };

extern const char program_help[]; /* how a program is run and what it must write, for --help */

struct program {
    const char *label;
    const char *solver;  /* the command; NULL with `results` */
    const char *results; /* the directory of answers, DIR/SCENE/DX; NULL with `solver` */
    const char *keep;    /* directory for case, answer and log of each rung; NULL for none */
    int seeds, seed;     /* draws of each rung, 0 for one; the current draw, from 1, for the case; 0: none */
    double timeout;      /* s; 0 for none */
    struct column_map columns;
    struct mapping map;            /* from the scene to the program's case */
    char vary[40], value[40];      /* NAME of --vary, and its value at this rung; "" for none */
    char setting[PROGRAM_SETTING]; /* directory of the parameters below SCENE; "" for SCENE itself */
    struct runs *runs;             /* shared state of the runs of one program (runs.h); NULL for none */
    const char *row;               /* the gate that runs the program, to be shown; NULL for none */
    char rung[100];                /* directory of this rung below DX: NAME=VALUE or dt=DT; "" for DX itself */
};

/* STATUS_OK if the command, if there is one, contains the places of its two files; else STATUS_INPUT. */
int program_check(const struct program *g, struct failure *why);

/* A copy of the answer *f in the axes and temperatures of the case: as printed by the program, to round-off. *exact
 * at the same points, unless NULL, is mapped in place.  Release with field_free. */
struct field program_as_given(const struct program *g, const struct field *f, double *exact);

/* The answer to *p, of the scene *s, at *o.  If STATUS_OK, the caller owns *f; its `seconds` are those of the whole
 * command, `step_seconds` the solution time reported by the program (by default the whole).  STATUS_SKIPPED: the
 * program declines the case. */
int program_solve(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                  struct field *f, struct failure *why);

#endif
