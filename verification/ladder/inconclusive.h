/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_LADDER_INCONCLUSIVE_H
#define HEATLADDER_VERIFICATION_LADDER_INCONCLUSIVE_H

/* Errors of a program that show no order, and are not wrong for it: noise, digits, a solver's tolerance, few rungs.
 */

#include "solver/field.h"

struct ladder;
struct ladder_rungs;
struct experiment;
struct mapping;

/* How far two runs of the same are apart at the rung before the finest, in the norm of the ladder. */
struct inconclusive_noise {
    double apart;  /* K, the largest difference; 0 where they are the same or nobody knows */
    double share;  /* of that rung's error, the scatter of one run */
    double finest; /* the scatter at the finest rung, in the unit of l->error */
};

static const double INCONCLUSIVE_NOISE = 0.1; /* a share above shows no order */

/* Where *l did not pass: VERDICT_INCONCLUSIVE with a reason of its own where noise, printed digits, or errors that do
 * not fall smoothly and look like no fault, may be why; unless even so the error is above its ceiling.  Of a ladder
 * that is inconclusive far below its ceiling, how many rungs would decide.  finest: its field, at the finest rung, of
 * the scene; map: from there to the case, whose temperatures the program printed. */
void inconclusive_judge(const struct ladder_rungs *rungs, const struct inconclusive_noise *noise,
                        const struct field *finest, const struct mapping *map, struct ladder *l);

/* E1, relative, of the digits in which a program printed T, on average (at most twice that), and how many they are.
 * *f is of the scene, *map from there to the case. */
double inconclusive_digits(const struct field *f, const struct mapping *map, int *digits);

/* Which usual fault the errors of a ladder in space look like, into l->diagnosis: from the fields of its finest rung
 * and of the one before, in that order (n = 0 where a rung has none).  *noise: by how much a program's answers differ
 * from run to run, which is all of the diagnosis where that hides the rest. */
void diagnose_ladder(const struct experiment *e, const struct field kept[2], struct ladder *l,
                     struct inconclusive_noise *noise);

#endif
