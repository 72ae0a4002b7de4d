/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_PRODUCTS_H
#define HEATLADDER_SOLVER_TIME_PRODUCTS_H

/* A field on a lattice as a sum of a few products, F(i, j) = sum_r X_r(i) Y_r(j). */

struct products {
    int rank, n[2];
    double *factor[2]; /* X_r(i) at factor[0][r n[0] + i], Y_r(j) at factor[1][r n[1] + j]; owned */
};

/* Splits F (n[0] x n[1], the first index fastest) so that no value is missed by more than tolerance max |F|.  1 where
 * `most` products or fewer do; else 0, as where a value is not finite. */
int products_split(const double *F, const int n[2], double tolerance, int most, struct products *p);
void products_join(const struct products *p, double *F);
void products_free(struct products *p);

#endif
