/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_COMMAND_RUN_H
#define HEATLADDER_VERIFICATION_JUDGE_COMMAND_RUN_H

/* A command line, run and kept, for claims and reports: each of their numbers has a command that repeats it. */

#include "verification/case/command.h"
#include "verification/judge/result.h"

#include <stdarg.h>

struct command_run {
    char command[400]; /* as a user would type it after the program's name */
    struct command typed;
    struct result result; /* its failure: of the command line or of the run */
    struct field field;
};

/* Reads a command line (printf-like) and, where its verb is `run`, runs it.  The status, which is also that of
 * run->result.failure; command_run_free in any case.  Safe from any thread. */
int command_run_line(struct command_run *run, const char *format, ...) __attribute__((format(printf, 2, 3)));
int command_run_list(struct command_run *run, const char *format, va_list arguments)
    __attribute__((format(printf, 2, 0)));

/* The two halves of that: between them numbers can be set in run->typed.experiment that no user would type. */
int command_run_read(struct command_run *run, const char *format, ...) __attribute__((format(printf, 2, 3)));
int command_run_solve(struct command_run *run);

/* The failure, if any, with the command that it is of. */
int command_run_check(const struct command_run *run, struct failure *why);

/* Keeps the failure of a run of a parallel loop in *any, whose status was STATUS_OK; the run's status. */
int command_run_note(const struct command_run *run, struct failure *any);

/* E1 (Song eq. 46) against the solution as the source prints it, or the exact one where the two are one, taken `late`
 * seconds after the end of the run and rounded to so many decimals, 0 for none. */
double command_run_error(const struct command_run *run, int decimals, double late);

/* The exact solution of the command's scene at x and time t (s), K. */
double command_run_exact(const struct command_run *run, const double x[2], double t);

void command_run_free(struct command_run *run);

#endif
