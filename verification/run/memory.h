/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_MEMORY_H
#define HEATLADDER_VERIFICATION_RUN_MEMORY_H

struct experiment;
struct failure;

/* Bytes that a program may still take: MemAvailable of Linux, else the physical memory; 0 where neither is known. */
double memory_there(void);

/* Estimated peak bytes of the run of *e, to 20 % for most operators; 0 where its options are refused. */
double memory_estimate(const struct experiment *e);

/* STATUS_OK for another program, and where memory_estimate is at most e->memory, or memory_there() where that is 0,
 * or where nothing is known. Else STATUS_INPUT, with the finest dx that fits and divides the domain in *why. */
int memory_check(const struct experiment *e, struct failure *why);

#endif
