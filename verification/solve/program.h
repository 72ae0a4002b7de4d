/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_PROGRAM_H
#define HEATLADDER_VERIFICATION_SOLVE_PROGRAM_H

/* An external program in place of a method: run now (--solver), or judged by existing answers (--results). */

#include "verification/case/experiment.h"

struct field;
struct options;
struct scene;

extern const char program_help[]; /* how a program is run and what it must write, for --help */

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
