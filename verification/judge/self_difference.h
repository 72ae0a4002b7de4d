/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_SELF_DIFFERENCE_H
#define HEATLADDER_VERIFICATION_JUDGE_SELF_DIFFERENCE_H

/* A ladder in time of a method whose semi-discrete solution is not known: successive runs against each other, or all
 * against one of a finer step. */

#include "verification/case/norm.h"

struct failure;
struct field;
struct ladder;
struct problem;

/* Sets errors and abscissas of the l->n rungs from the fields of l->n + 1 runs with the time steps dt, s: from the
 * difference to the last field if it is that of --fine (l->fine > 0), else to the next one.  STATUS_OK, or
 * STATUS_INPUT with *why if the points differ. */
int self_difference_errors(const struct problem *p, const struct field *field, const double *dt, struct ladder *l,
                           struct failure *why);

/* Sets apart to the norms of the difference of two fields, with the second as the exact one, for any order of their
 * points; those of parts are NaN.  Returns 1, or 0 if the points differ. */
int self_difference_fields(const struct problem *p, const struct field *a, const struct field *b,
                           double apart[NORM_QUANTITY]);

/* T[i], K, of *b at point i of *a: the same points in any order. */
void self_difference_other(const struct field *a, const struct field *b, double *T);

#endif
