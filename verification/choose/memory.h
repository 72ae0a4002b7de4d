/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CHOOSE_MEMORY_H
#define HEATLADDER_VERIFICATION_CHOOSE_MEMORY_H

/* Whether a run fits into the memory that is there. */

struct experiment;
struct failure;

/* Bytes that a program may still take: MemAvailable of Linux, else the physical memory; 0 where neither is known. */
double memory_there(void);

/* STATUS_OK where the plan of *e takes no more than e->memory, or memory_there() where that is 0, or says nothing.
 * Else STATUS_INPUT, *why naming the finest dx that fits, among those that divide the domain. */
int memory_check(const struct experiment *e, struct failure *why);

#endif
