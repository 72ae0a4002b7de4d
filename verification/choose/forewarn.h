/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CHOOSE_FOREWARN_H
#define HEATLADDER_VERIFICATION_CHOOSE_FOREWARN_H

/* What will take long says so beforehand, once, on standard error.  The prediction is of counted work, so that it is
 * the same on every machine: forewarn_rate of the unit of solver/outline.h a second, about what one processor does.
 */

#include <stddef.h>

struct experiment;
struct failure;

static const double forewarn_least = 10;   /* s: a shorter run gets no warning */
static const double forewarn_rate = 5e9;   /* s^-1 */
static const double forewarn_exact = 2e-6; /* s: of an exact temperature of the plane, at most (a plate's at the
                                              start: 53 x 53 modes, value and slope); a fifth of it on a rod */

/* Several runs, each known only when the one before is over: seconds of all so far, and of the last warning. */
struct forewarned {
    double all, warned;
};

/* Seconds of the run of *e by its plan, the exact temperatures and the search for a time step with it.  0 where the
 * plan gives no estimate or would take as long as the run: that is less than forewarn_least then. */
double forewarn_seconds(const struct experiment *e);

/* "3 minutes", "2.1 years" */
void forewarn_text(double seconds, char *text, size_t size);

/* Says that `what` will take so long, where it is forewarn_least or more: 1 then, else 0. */
int forewarn(const char *what, double seconds);

/* Says how long `what`, the run of *e, will take.  STATUS_OK; STATUS_INPUT where its plan is refused, as the run
 * would be once all is set up, or takes more memory than there is. */
int forewarn_run(const char *what, const struct experiment *e, struct failure *why);

/* The same for one run more, where all take more than twice the last warning. */
int forewarn_next(struct forewarned *f, const char *what, double seconds);

/* Whether a run fits into the memory that is there. */

/* Bytes that a program may still take: MemAvailable of Linux, else the physical memory; 0 where neither is known. */
double memory_there(void);

/* STATUS_OK where the plan of *e takes no more than e->memory, or memory_there() where that is 0, or says nothing.
 * Else STATUS_INPUT, *why naming the finest dx that fits, among those that divide the domain. */
int memory_check(const struct experiment *e, struct failure *why);

#endif
