/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_LADDER_GCI_H
#define HEATLADDER_VERIFICATION_LADDER_GCI_H

/* Without an exact solution: Richardson's extrapolation and the grid convergence index. */

#include "verification/text/number.h"

struct column_map;
struct failure;
struct json;

enum { GCI_QUANTITIES = 16, GCI_NAME = 48 };

struct gci_row { /* one quantity */
    char name[GCI_NAME];
    double value[NUMBERS_MAX];  /* at each spacing, the coarsest first; NaN where it is a distance between fields */
    double order;               /* from the three finest; NaN where they have none */
    double orders[NUMBERS_MAX]; /* of each three successive, n - 2 */
    double extrapolated;        /* Richardson's, from the two finest; NaN for fields */
    double change;              /* of the two finest, relative to the finest */
    double index;               /* GCI of the finest, relative: 1.25 change / (r^p - 1) */
    int oscillates;             /* 1: successive changes have opposite signs */
    int digits;                 /* printed: most significant ones of any value */
    double unsure;              /* by how much those digits leave the order open */
};

struct gci {
    int n; /* spacings, the coarsest first */
    double h[NUMBERS_MAX];
    int rows;
    struct gci_row row[GCI_QUANTITIES];
};

/* The observed order of e32 = f3 - f2 and e21 = f2 - f1 on grids that differ by r21 and r32 > 1 (f1 is the finest);
 * *oscillates is 1 where their signs differ.  NaN where no order above 0 fits, that is, where |e32/e21| is not above
 * ln r32/ln r21 (1 where the signs differ), or where a change is 0 or no number. */
double gci_order(double e21, double e32, double r21, double r32, int *oscillates);

/* DIR/H/out.csv and likewise: each a field of points and T, or names and one line of values below.  With `at` of one
 * or two numbers the temperature there is one of the quantities.  STATUS_OK, or STATUS_INPUT with *why. */
int gci_read(const char *dir, const struct column_map *c, const struct numbers *at, struct gci *g,
             struct failure *why);

void gci_json(const struct gci *g, struct json *j); /* into an object that is open */

#endif
