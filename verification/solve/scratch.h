/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_SCRATCH_H
#define HEATLADDER_VERIFICATION_SOLVE_SCRATCH_H

/* A directory for one run of another program. scratch_close removes it.  If this program is killed, a shell detects
 * the end of a pipe, ends the program's process group and removes the directory. */

#include <sys/types.h>

struct failure;

enum { SCRATCH_PATH = 256 };

struct scratch {
    char dir[SCRATCH_PATH]; /* under TMPDIR if its name needs no quotes in a shell, else under /tmp */
    int pipe;               /* receives one line: the process group that ends with the directory */
    pid_t guard;
};

int scratch_open(struct scratch *s, struct failure *why); /* STATUS_OK, or STATUS_INPUT with *why */
void scratch_close(struct scratch *s);                    /* returns when all is removed */

/* Duplicates a descriptor to a number above those given to a started program, which dup2 would close; closed on
 * exec.  Returns -1 with errno set on failure. */
int scratch_descriptor(int descriptor);

#endif
