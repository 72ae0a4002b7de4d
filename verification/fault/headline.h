/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_HEADLINE_H
#define HEATLADDER_VERIFICATION_FAULT_HEADLINE_H

/* One fault for all rows of a battery. */

#include "verification/fault/diagnosis.h"

/* A fault with one size, and what it explains of the rows that fail. */
struct headline {
    struct diagnosis fault; /* at FAULT_ANY if the places differ; not named: none was found */
    double share;           /* mean share of the squared errors of the rows whose errors are known */
    int votes, failing;     /* rows that it explains to FIT_VOTE or more; all rows that do not pass */
    int is_firm;            /* 1: half of the rows with known errors vote for it, two at least, and it has no rival */
    int scope;              /* 1: rows that pass contradict it, but none of the class of all failing rows */
    struct diagnosis rival; /* a fault that explains as much, if all rows melt; not named: none */
};

enum { HEADLINE_TEXT = 560 };

/* Whether rows that pass contradict a fault: 0, 1, or 2: only rows outside the class of all that fail. */
typedef int headline_check(const struct diagnosis *fault, const void *context);

/* The fault that explains most of `failing` rows and that no row which passes contradicts (contradicts NULL: no such
 * row is known); found[i] is what row i alone shows. */
struct headline headline_choose(const struct diagnosis *found, int failing, headline_check *contradicts,
                                const void *context);

/* The share of the squared error of a row that it explains; NAN if the errors of the row are not known. */
double headline_share(const struct headline *h, const struct diagnosis *row);

/* The fault, with "perhaps" unless it is firm, and the votes; "" without one.  class: "in space", of all rows that
 * fail. */
void headline_print(const struct headline *h, const char *class, char text[HEADLINE_TEXT]);

/* The relative error (E1) that a fault causes in *p at spacing dx, m, and steps of dt, s (0: unknown); `zero`, K, is
 * the temperature from which relative errors are measured.  NAN if *p cannot have the fault or if it is not a change
 * of a problem. */
double headline_effect(const struct problem *p, const struct diagnosis *d, double dx, double dt, double zero);

/* 1 if a row that passes with an error below its ceiling contradicts the fault: at spacing dx, m, the fault alone
 * would cause an error of twice the ceiling. */
int headline_contradicts(const struct diagnosis *fault, const struct problem *p, double dx, double dt, double zero,
                         double ceiling);

#endif
