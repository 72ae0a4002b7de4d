/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_MEMORY_H
#define HEATLADDER_VERIFICATION_SOLVE_MEMORY_H

struct experiment;
struct failure;

/* Bytes available to a program: MemAvailable on Linux, else the physical memory; 0 if neither is known. */
double memory_there(void);

/* Estimated peak memory of the run of *e in bytes, within 20 % for most operators; 0 if its options are refused. */
double memory_estimate(const struct experiment *e);

/* STATUS_OK for an external program, if the estimate is at most e->memory (or memory_there() if that is 0), or if
 * nothing is known.  Else STATUS_INPUT, with the finest dx that fits and divides the domain in *why. */
int memory_check(const struct experiment *e, struct failure *why);

#endif
