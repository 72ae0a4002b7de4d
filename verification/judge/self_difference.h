/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_SELF_DIFFERENCE_H
#define HEATLADDER_VERIFICATION_JUDGE_SELF_DIFFERENCE_H

/* A ladder in time of a method whose semi-discrete solution is not known: successive runs against each other, or all
 * against one of a finer step. */

struct experiment;
struct failure;
struct field;
struct ladder;
struct norms_error;
struct problem;

/* Runs the l->n experiments, which differ in their time step, and sets errors and abscissas from the difference to
 * *fine, whose step is l->fine.  If fine is NULL the difference is to the next rung, and l->n is one less afterwards.
 * Returns STATUS_OK, or the status of the first run that failed, with *why; STATUS_INPUT if the points differ. */
int self_difference_climb(const struct experiment *rung, const struct experiment *fine, struct ladder *l,
                          struct failure *why);

/* Sets *apart to the difference of two fields, relative to the second except for the maximum (K), for any order of
 * their points.  Returns 1, or 0 if the points differ. */
int self_difference_fields(const struct problem *p, const struct field *a, const struct field *b,
                           struct norms_error *apart);

#endif
