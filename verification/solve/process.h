/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_PROCESS_H
#define HEATLADDER_VERIFICATION_SOLVE_PROCESS_H

/* An external program, run by `sh -c` in a process group of its own. */

#include <stdio.h>

struct failure;

struct process {
    const char *command;
    const char *label; /* prefix of each line that it prints, on standard error */
    const char *dir;   /* its TMPDIR */
    FILE *log;         /* receives its printed text; NULL for none */
    double timeout;    /* s; 0 for none */
    int *code;         /* receives the exit status as in a shell, 124 after a timeout; -1 if it was interrupted */
};

/* Returns when the program and its group have ended, by themselves or because of this call: after the timeout, at an
 * interrupt (the caller holds them: text/output.h), or as background processes left by the program.  STATUS_OK: exit
 * status 0.  STATUS_SKIPPED: 77, the program declines the case.  STATUS_INPUT: it could not be run. STATUS_NUMERICAL:
 * any other end. *why has the reason and the last lines that it printed. */
int process_run(const struct process *p, struct failure *why);

/* The reason of a case that a program declines begins so; 1 for such a reason. */
#define PROCESS_DECLINED "not applicable (exit status 77)"
int process_declined(const char *reason);

#endif
