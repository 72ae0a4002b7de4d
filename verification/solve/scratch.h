/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_SCRATCH_H
#define HEATLADDER_VERIFICATION_SOLVE_SCRATCH_H

/* A directory for the files of another program. */

struct failure;

enum { SCRATCH_PATH = 256 };

struct scratch {
    char dir[SCRATCH_PATH]; /* under TMPDIR if its name needs no quotes in a shell, else under /tmp */
};

int scratch_open(struct scratch *s, struct failure *why); /* STATUS_OK, or STATUS_INPUT with *why */
void scratch_close(struct scratch *s);                    /* removes the directory and all in it */

#endif
