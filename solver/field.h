/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_FIELD_H
#define HEATLADDER_SOLVER_FIELD_H

/* The solution returned by a method: positions, temperatures, counts and times. */

#include "solver/problem.h"

#include <stddef.h>

struct cost {               /* cost of a run */
    long long updates;      /* particle updates: particles x operator applications */
    long long interactions; /* pairs evaluated: updates x neighbours */
    double work;            /* operation count (solver/work.h); 0 if unknown */
    size_t bytes;           /* memory during the time loop, including positions and temperatures */
    double seconds;         /* wall time of the whole call */
    double step_seconds;    /* wall time of the time loop */
};

struct field { /* arrays are owned; release with field_free */
    int dim;
    size_t n;
    int shape[DIM_MAX];      /* lattice points by axis (1 past dim), x fastest; 0 without a lattice */
    double spacing[DIM_MAX]; /* m; 0 past dim */
    double *x[DIM_MAX];      /* m, by axis: n, on a lattice shape[axis] coordinates; NULL past dim */
    double *T;               /* K, n */
    double *weight;          /* m^dim, n: volume weight of each point in norms; NULL if all are equal */
    double time;             /* s, time of T (t_end) */
    double h;                /* smoothing length over dx; 0 for methods without one */
    double dt;               /* s; 0 for the exact stepper */
    long long steps;         /* time steps; 0 for the exact stepper */
    int stages;              /* operator applications per step; a first step may need more */
    long long applications;  /* operator applications in all steps; 0 for the exact stepper or if unknown */
    double heat[2];          /* J m^(dim-3): sum of rho_c T volume, initial and final */
    double range[2];         /* K, minimum and maximum of the sampled initial data */
    double data[2];          /* K: range of initial data, walls and incoming heat; 0, 0 if unknown */
    double bound;            /* s^-1: upper bound of the operator's spectrum; 0 if unknown */
    double time_error; /* K: mean of |T| that the time steps have changed, from the last of them; 0 if unknown */
    struct cost cost;
};

double field_clock(void); /* s, from a monotonic clock */

/* Zeroes *f; allocates T and the coordinates of n points, or of a lattice.  A lattice takes T, of n values or more,
 * if it is not NULL. */
void field_alloc(struct field *f, int dim, size_t n);
void field_alloc_lattice(struct field *f, int dim, const int shape[DIM_MAX], double *T);
struct field field_copy(const struct field *f);
void field_free(struct field *f);

/* Position of point i, m, 0 past dim; returns x. */
static inline const double *field_place(const struct field *f, size_t i, double x[DIM_MAX]) {
    size_t rest = i;
    for (int a = 0; a < DIM_MAX; a++) {
        size_t n = (size_t)f->shape[a];
        x[a] = a >= f->dim ? 0 : f->x[a][n ? rest % n : i];
        if (n) rest /= n;
    }
    return x;
}
/* Moves point i of a field without a lattice to x. */
static inline void field_put(struct field *f, size_t i, const double x[]) {
    for (int a = 0; a < f->dim; a++) f->x[a][i] = x[a];
}

/* Size of its arrays. */
size_t field_bytes(const struct field *f);

/* sum w |f->T - T| / sum w |size| over the n points of *f, K, with w = f->weight.  Points with size INFINITY have no
 * known value and are skipped. */
double field_distance(const struct field *f, const double *T, const double *size);

double field_largest(const struct field *f); /* K: largest finite |f->T[i]| */

/* K: largest |f->T[i] - T[i]| over the n points of *f; NaN if one of them is. */
double field_farthest(const struct field *f, const double *T);

#endif
