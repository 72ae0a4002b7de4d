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

/* Runs the l->n experiments, which differ in their time step, and sets errors and abscissas of all except the finest
 * from the difference to the next.  Returns STATUS_OK, or the status of the first run that failed, with *why;
 * STATUS_INPUT if the points differ. */
int self_difference_climb(const struct experiment *rung, struct ladder *l, struct failure *why);

/* Sets *apart to the difference of two fields, relative to the second except for the maximum (K), for any order of
 * their points.  Returns 1, or 0 if the points differ. */
int self_difference_fields(const struct problem *p, const struct field *a, const struct field *b,
                           struct norms_error *apart);

#endif
