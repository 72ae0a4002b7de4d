/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_GCI_H
#define HEATLADDER_VERIFICATION_JUDGE_GCI_H

/* Without an exact solution: Richardson extrapolation and the grid convergence index. */

#include "verification/text/number.h"

struct column_map;
struct failure;
struct json;

enum { GCI_QUANTITIES = 16, GCI_NAME = 48 };

static const double GCI_BETWEEN = 0.1;

struct gci_row { /* one quantity */
    char name[GCI_NAME];
    double value[NUMBERS_MAX];  /* at each spacing, coarsest first; NaN for a difference of fields */
    double order;               /* from the three finest; NaN if they have none */
    double orders[NUMBERS_MAX]; /* for each three successive spacings, n - 2 */
    double extrapolated;        /* Richardson extrapolation from the two finest; NaN for fields */
    double change;              /* between the two finest, relative to the finest */
    double index;               /* GCI of the finest, relative: 1.25 change / (r^p - 1) */
    int oscillates;             /* 1: successive changes have opposite signs */
    int digits;                 /* printed: most significant ones of any value */
    double unsure;              /* by how much those digits leave the order open */
    double
        between; /* error of interpolation between points over the change of the grids; above GCI_BETWEEN no order */
};

struct gci {
    int n; /* number of spacings, coarsest first */
    double h[NUMBERS_MAX];
    int rows;
    struct gci_row row[GCI_QUANTITIES];
};

/* The observed order from e32 = f3 - f2 and e21 = f2 - f1 on grids with the ratios r21 and r32 > 1 (f1 is the
 * finest); *oscillates is 1 if their signs differ.  NaN if no positive order fits: |e32/e21| is at most ln r32/ln
 * r21 (1 for different signs), or a change is 0 or not a number. */
double gci_order(double e21, double e32, double r21, double r32, int *oscillates);

/* Reads DIR/H/out.csv and the like: either a field of points and T, or names with one line of values.  With `at`,
 * one to three numbers, the temperature at that point is a further quantity; with a column w so is the mean.  Returns
 * STATUS_OK, or STATUS_INPUT with *why: also if interpolation hides the order of all. */
int gci_read(const char *dir, const struct column_map *c, const struct numbers *at, struct gci *g,
             struct failure *why);

void gci_json(const struct gci *g, struct json *j); /* into an open object */

#endif
