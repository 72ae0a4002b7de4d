/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_INCONCLUSIVE_H
#define HEATLADDER_VERIFICATION_JUDGE_INCONCLUSIVE_H

/* Errors of a program that show no order without being wrong: noise, digits, a solver's tolerance, few rungs. */

#include "solver/field.h"

struct ladder;
struct ladder_rungs;
struct experiment;
struct mapping;

/* Difference between two equal runs at the rung before the finest, in the norm of the ladder. */
struct inconclusive_noise {
    double apart;  /* K, maximum difference; 0 if they agree or it is unknown */
    double share;  /* the scatter of one run relative to the error of that rung */
    double finest; /* the scatter at the finest rung, in the unit of l->error */
};

static const double INCONCLUSIVE_NOISE = 0.1; /* a larger share shows no order */

/* If *l did not pass: VERDICT_INCONCLUSIVE with a specific reason if noise, printed digits, or errors that do not
 * decrease smoothly and match no fault may be the cause, unless the error is above its ceiling even so.  For a
 * ladder that is inconclusive far below its ceiling, states the number of rungs that would decide. finest: its field
 * at the finest rung, of the scene; map: from the scene to the case, whose temperatures the program printed. */
void inconclusive_judge(const struct ladder_rungs *rungs, const struct inconclusive_noise *noise,
                        const struct field *finest, const struct mapping *map, struct ladder *l);

/* Mean relative rounding error of the printed T in terms of E1 (at most half of its maximum), and the number of
 * digits. *f is of the scene, *map from there to the case. */
double inconclusive_digits(const struct field *f, const struct mapping *map, int *digits);

/* Sets l->diagnosis to the fault that the errors of a ladder in space match, from the fields of its finest rung and
 * of the one before, in that order (n = 0 if a rung has none). *noise: the difference between equal runs of a
 * program; if it hides the errors, it is the diagnosis. */
void diagnose_ladder(const struct experiment *e, const struct field kept[2], struct ladder *l,
                     struct inconclusive_noise *noise);

#endif
