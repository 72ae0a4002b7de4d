/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_DIAGNOSIS_HEADLINE_H
#define HEATLADDER_VERIFICATION_DIAGNOSIS_HEADLINE_H

/* One fault for all rows of a battery. */

#include "verification/diagnosis/diagnosis.h"

struct headline {
    struct diagnosis fault; /* median size among the rows that agree; FAULT_ANY if their axes differ */
    int votes, failing;     /* rows that agree, and all that do not pass */
    int is_firm;            /* 1: at least two agree, and at least half of all that do not pass */
};

enum { HEADLINE_TEXT = 340 };

/* The fault that most of `failing` rows name with sizes that agree to 20 %; found[i].named is 0 where row i names
 * none.  votes is 0 where no two agree, unless one row alone names a fault. */
struct headline headline_choose(const struct diagnosis *found, int failing);

/* The fault, "perhaps" where it is not firm, and the votes; "" without votes. */
void headline_print(const struct headline *h, char text[HEADLINE_TEXT]);

/* 1 where a row that passes with an error below its ceiling could not do so with the fault of *h: at spacing dx, m,
 * the fault alone would leave twice the ceiling.  zero: of diagnosis_effect. */
int headline_contradicts(const struct headline *h, const struct problem *p, double dx, double zero, double ceiling);

#endif
