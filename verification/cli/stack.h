/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CLI_STACK_H
#define HEATLADDER_VERIFICATION_CLI_STACK_H

struct failure;

enum { STACK_LEAST = 256 }; /* kB per thread: twice the largest observed depth, 64 to 128 */

/* STATUS_INPUT if the limit of the stack (ulimit -s) or of OpenMP's threads (OMP_STACKSIZE, GOMP_STACKSIZE) is below
 * STACK_LEAST, where a thread would crash without a message; else STATUS_OK. */
int stack_check(struct failure *why);

/* kB requested by a value of OMP_STACKSIZE (OpenMP 5.0, section 6.7: a whole number with B, K, M or G; kB without a
 * unit); -1 if it is invalid. */
double stack_size(const char *text);

#endif
