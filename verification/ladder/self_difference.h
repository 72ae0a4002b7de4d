/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_LADDER_SELF_DIFFERENCE_H
#define HEATLADDER_VERIFICATION_LADDER_SELF_DIFFERENCE_H

/* A ladder in time without a semi-discrete reference: successive runs against each other. */

struct experiment;
struct failure;
struct field;
struct ladder;
struct norms_error;
struct problem;

/* Runs the l->n experiments, which differ in their time step, and sets errors and abscissas of all but the finest, by
 * their distances from the next.  STATUS_OK, or the status of the first that failed, with *why; STATUS_INPUT where
 * the runs' points differ. */
int self_difference_climb(const struct experiment *rung, struct ladder *l, struct failure *why);

/* How far two fields are apart, relative to the second but for the largest difference (K), into *apart, whatever the
 * order of their points.  1; or 0 where these are not the same. */
int self_difference_fields(const struct problem *p, const struct field *a, const struct field *b,
                           struct norms_error *apart);

#endif
