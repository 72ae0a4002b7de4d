/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_CASE_RUN_H
#define HEATLADDER_VERIFICATION_SOLVE_CASE_RUN_H

/* One case, run by a program in the case's own directory:
 *
 *     case      input of the program
 *     out.part  its output; renamed to out.csv after a successful end
 *     log       its printed text
 *     status    its exit status as in a shell: 124 after a timeout, 128 + n after signal n
 *
 * An interrupted case has no status, and an existing answer is complete. */

struct failure;

struct case_run {
    const char *dir;
    const char *solver; /* command with {case}, {out}, {dx} and {name} */
    const char *dx;
    const char *name, *value; /* parameter of --vary; NULL for none */
    const char *label;        /* prefix of each line that it prints */
    double timeout;           /* s; 0 for none */
};

/* Returns the status of process_run, or STATUS_INPUT if the directory cannot be written; *code is the exit status,
 * -1 if there is none. `scratch` is the program's TMPDIR; the caller holds interrupts (text/output.h). */
int case_run(const struct case_run *c, const char *scratch, int *code, struct failure *why);

/* The exit status recorded in `dir`; -1 for none. */
int case_run_status(const char *dir);

#endif
