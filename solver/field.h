/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_FIELD_H
#define HEATLADDER_SOLVER_FIELD_H

/* The solution that a method returns: places, temperatures, counts and times. */

#include <stddef.h>

struct cost {               /* of a run */
    long long updates;      /* particle updates: particles x operator applications */
    long long interactions; /* pairs evaluated: updates x neighbours */
    double work;            /* all that is done, counted (solver/work.h); 0 where unknown */
    size_t bytes;           /* held while time runs, places and temperatures among them */
    double seconds;         /* wall time of the whole call */
    double step_seconds;    /* wall time of the time loop alone */
};

struct field { /* owned arrays: field_free */
    int dim;
    size_t n;
    int shape[2];      /* lattice points along x and y (1 for a rod), x fastest; {0, 0} where there is no lattice */
    double spacing[2]; /* m */
    double *x, *y;     /* m, n each; y is NULL for a rod */
    double *T;         /* K, n */
    double *weight;    /* m^d, n: the volume that each point stands for in a norm; NULL where all are equal */
    double time;              /* s, the time that T belongs to (t_end) */
    double h;                 /* smoothing length over dx, as used; 0 for a method without one */
    double dt;                /* s, 0 for the exact stepper */
    long long steps;          /* time steps; 0 for the exact stepper */
    int stages;               /* operator applications a step; a first step may take more */
    long long applications;   /* of the operator, in all steps; 0 for the exact stepper and where unknown */
    double heat[2];           /* J m^(d-3): sum of rho_c T volume at the start and at the end */
    double range[2];          /* K, lowest and highest of the sampled initial data */
    double data[2];           /* K: what initial data, walls and heat that comes in span; 0, 0 where unknown */
    double bound;             /* s^-1: upper bound of the operator's spectrum; 0 where none is known */
    struct cost cost;
};

double field_clock(void); /* s, of a clock that never goes back: what the times of a cost are differences of */

void field_alloc(struct field *f, int dim, size_t n); /* zeroes *f, allocates x, T, and y for dim 2 */
void field_free(struct field *f);

/* sum w |f->T - T| / sum w |size| at the n points of *f, K, but for those where size is INFINITY: no value is known
 * there.  w: f->weight. */
double field_distance(const struct field *f, const double *T, const double *size);

double field_largest(const struct field *f); /* K: the largest |f->T[i]|, of those that are numbers */

/* K: the largest |f->T[i] - T[i]| at the n points of *f; NaN where one is. */
double field_farthest(const struct field *f, const double *T);

#endif
