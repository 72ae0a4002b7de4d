/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_DIAGNOSIS_DIAGNOSIS_H
#define HEATLADDER_VERIFICATION_DIAGNOSIS_DIAGNOSIS_H

#include "verification/diagnosis/fault.h"

struct field;
struct json;

/* Diagnosis of a ladder's errors: the fault whose response explains most of the error field. */

struct diagnosis_rung {
    const struct field *field;
    const double *exact; /* K, at the points of the field; NAN where the solution has no value */
    double dx;           /* m */
    double dt;           /* s; 0 where unknown */
    double mean;         /* by how many dx^2/24 laplace(T) the numbers differ from values; NAN where unknown */
};

/* Means of two conductivities that may stand for the harmonic one: `axis` of a diagnosed FAULT_MEAN. */
enum { MEAN_IS_ARITHMETIC, MEAN_IS_GEOMETRIC, MEAN_IS_EITHER, MEAN_IS_OTHER };

struct diagnosis {
    int named;
    struct fault fault;
    double size;      /* in `unit` */
    const char *unit; /* "steps", "s", "dx^2/kappa", "%", "cells", "K", "digits" or "" */
    double share;     /* share of the squared error, 0 to 1, at the finest rung; NAN if another criterion applies */
    double fourier;   /* dt kappa/dx^2 of the finest rung; 0 where unknown */
    unsigned sides;   /* 1 << enum side_kind of each side that the fault is about; 0 where it is about none */
    char what[240];   /* "as if the run had stopped 0.98 steps early"; why none is named where none is */
};

/* `mean` of a rung of that code, from its answer at a time so early that T is still that of the start; NAN where that
 * is not what its errors look like. */
double diagnosis_mean(const struct problem *p, const struct diagnosis_rung *start);

/* Names a fault that explains at least 90 % of the squared error of the finest rung, *fine, and whose size follows
 * the spacing as that fault does from the next coarser rung, *coarse: a part of a cell or of a step, or of
 * everything.  Errors of discretization grow with the spacing otherwise, so that none is named for them. */
void diagnosis_find(const struct problem *p, const struct diagnosis_rung *fine, const struct diagnosis_rung *coarse,
                    struct diagnosis *d);

/* The relative error (E1) that the fault of *d makes of *p at spacing dx, m; `zero`, K, is the temperature that
 * relative errors start from.  NAN where *p cannot have the fault or it is no change of a problem. */
double diagnosis_effect(const struct problem *p, const struct diagnosis *d, double dx, double zero);

/* Names a run whose temperatures leave the range of the solution by far.  1 where they do. */
int diagnosis_unstable(const struct diagnosis_rung *r, struct diagnosis *d);

/* Two runs of the same that are `apart`, K, of fields as large as `largest`, K, are named where that is more than
 * sums in another order leave: one field shows nothing then.  1 where it is. */
int diagnosis_repeat(double apart, double largest, struct diagnosis *d);

/* Temperatures that are all rounded to the same few digits, or to 24 bits, and an error (relative, E1) that this
 * explains, with cells along the longer side.  1 where they are. */
int diagnosis_rounding(const struct field *f, double error, double cells, struct diagnosis *d);

/* The member "diagnosis" of an object that is open: null, or what, size, unit and share. */
void diagnosis_json(const struct diagnosis *d, struct json *j);

#endif
