/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_PROCESS_H
#define HEATLADDER_VERIFICATION_FOREIGN_PROCESS_H

/* Another program, run by `sh -c` in a process group of its own. */

#include <stdio.h>

struct failure;
struct scratch;

struct process {
    const char *command;
    const char *label;       /* stands before each line that it prints, on standard error */
    struct scratch *scratch; /* its TMPDIR; the group ends with it */
    FILE *log;               /* takes what it prints too; NULL for none */
    double timeout;          /* s; 0 for none */
    int *code; /* gets the exit status as a shell has it, 124 past the timeout; -1 where it was cut off */
};

/* Returns when the program and all that it started have ended, by themselves or by this call: past the timeout, at an
 * interrupt (the caller holds them: text/atomic_file.h), or as what the program left running.
 * STATUS_OK: exit status 0.  STATUS_SKIPPED: 77, the case is not for it.  STATUS_INPUT: it could not be run.
 * STATUS_NUMERICAL: any other end.  *why says which, with the last line that it printed. */
int process_run(const struct process *p, struct failure *why);

#endif
