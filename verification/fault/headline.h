/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_HEADLINE_H
#define HEATLADDER_VERIFICATION_FAULT_HEADLINE_H

/* One fault for all rows of a battery. */

#include "verification/fault/diagnosis.h"

struct headline {
    struct diagnosis fault; /* median size among the rows that agree; FAULT_ANY if their axes differ */
    int votes, failing;     /* rows that agree, and all rows that do not pass */
    int is_firm;            /* 1: at least two rows agree, and at least half of those that do not pass */
};

enum { HEADLINE_TEXT = 340 };

/* The fault that most of `failing` rows name with sizes that agree to 20 %; found[i].named is 0 if row i names none.
 * votes is 0 if no two rows agree, unless a single row names a fault. */
struct headline headline_choose(const struct diagnosis *found, int failing);

/* The fault, with "perhaps" unless it is firm, and the votes; "" without votes. */
void headline_print(const struct headline *h, char text[HEADLINE_TEXT]);

/* 1 if a row that passes with an error below its ceiling contradicts the fault of *h: at spacing dx, m, the fault
 * alone would cause an error of twice the ceiling.  zero: see diagnosis_effect. */
int headline_contradicts(const struct headline *h, const struct problem *p, double dx, double zero, double ceiling);

#endif
