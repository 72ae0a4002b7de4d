/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_PRODUCTS_H
#define HEATLADDER_SOLVER_TIME_PRODUCTS_H

/* A field on a lattice as a sum of a few products, F(i, j) = sum_r X_r(i) Y_r(j). */

struct products {
    int rank, n[2];
    double *factor[2]; /* X_r(i) at factor[0][r n[0] + i], Y_r(j) at factor[1][r n[1] + j]; owned */
};

/* Splits F (n[0] x n[1], the first index fastest) with an error below tolerance max |F| at every value.  Returns 1
 * if at most `most` products suffice; else 0, also if a value is not finite. */
int products_split(const double *F, const int n[2], double tolerance, int most, struct products *p);
void products_join(const struct products *p, double *F);
void products_free(struct products *p);

#endif
