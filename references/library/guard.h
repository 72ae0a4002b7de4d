/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_LIBRARY_GUARD_H
#define HEATLADDER_REFERENCES_LIBRARY_GUARD_H

/* A call of the library: one at a time, with its memory in a list and the host's error handler of GSL set aside. */

struct failure;

/* The status of body(argument, why).  Out of memory, in `body` or in GSL, is STATUS_MEMORY.  What `body` allocates
 * and neither frees nor keeps is released. */
int guard_call(int (*body)(void *argument, struct failure *why), void *argument, struct failure *why);
enum { STATUS_MEMORY = 7 };

/* The block outlives the call that allocated it; returns it. */
void *guard_keep(void *block);

#endif
