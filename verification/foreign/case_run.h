/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_CASE_RUN_H
#define HEATLADDER_VERIFICATION_FOREIGN_CASE_RUN_H

/* One case, run by a program in the case's own directory:
 *
 *     case      what the program reads
 *     out.part  where it writes; out.csv once the program has ended well
 *     log       what it printed
 *     status    its exit status as a shell has it: 124 past the time limit, 128 + n after signal n
 *
 * A case that was interrupted has no status, and an answer that is there is whole. */

struct failure;
struct scratch;

struct case_run {
    const char *dir;
    const char *solver; /* with {case}, {out}, {dx} and {name} in it */
    const char *dx;
    const char *name, *value; /* parameter of --vary; NULL for none */
    const char *label;        /* stands before each line that it prints */
    double timeout;           /* s; 0 for none */
};

/* The status of process_run, or STATUS_INPUT where the directory cannot be written; *code is the exit status, -1
 * where there is none.  *scratch is the program's TMPDIR; the caller holds interrupts (text/atomic_file.h). */
int case_run(const struct case_run *c, struct scratch *scratch, int *code, struct failure *why);

/* The exit status that `dir` has; -1 for none. */
int case_run_status(const char *dir);

/* 1 where `dir` has an answer (out.csv, out.npy, out.dat), whose path then stands in `path` of `size`
 * letters; else the path of the first of them. */
int case_run_answer(const char *dir, char *path, unsigned long size);

#endif
