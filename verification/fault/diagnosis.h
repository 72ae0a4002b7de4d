/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_DIAGNOSIS_H
#define HEATLADDER_VERIFICATION_FAULT_DIAGNOSIS_H

#include "verification/fault/fault.h"

struct evidence;
struct fault_fit;
struct field;
struct json;

/* Diagnosis of a ladder's errors: the fault whose response explains most of the error field. */

struct diagnosis_rung {
    const struct field *field;
    const double *exact; /* K, at the points of the field; NAN where the solution has no value */
    double dx;           /* m */
    double dt;           /* s; 0: unknown */
    double mean; /* difference between the answers and point values, in units of dx^2/24 laplace(T); NAN: unknown */
};

/* Means of two conductivities that a code may use instead of the harmonic mean: `at` of a diagnosed FAULT_MEAN. */
enum { MEAN_IS_ARITHMETIC, MEAN_IS_GEOMETRIC, MEAN_IS_EITHER, MEAN_IS_OTHER };

struct diagnosis {
    int named;
    struct fault fault;
    double size;      /* in `unit` */
    const char *unit; /* "steps", "s", "dx^2/kappa", "%", "cells", "K", "digits" or "" */
    double share;     /* share of the squared error, 0 to 1, at the finest rung; NAN if another criterion applies */
    double fourier;   /* dt kappa/dx^2 of the finest rung; 0: unknown */
    unsigned paces;   /* PACE_... that explain the same: k, rho c and the end time, where only k/rho c acts */
    unsigned sides;   /* fault_sides */
    unsigned beside;  /* 1 << s of each side next to whose cells nearly all of the error is */
    struct evidence *evidence; /* fits of all faults, to be freed by the owner; NULL: none */
    char what[240]; /* "as if the run had stopped 0.98 steps early"; without a fault the reason why none is named */
};

/* Estimates `mean` of that code's rungs from an answer at such an early time that T is still the initial one; NAN if
 * the errors do not have that form. */
double diagnosis_mean(const struct problem *p, const struct diagnosis_rung *start);

/* Names a fault that explains at least 90 % of the squared error of the finest rung, *fine, and whose size scales
 * from the next coarser rung, *coarse, as this fault does: a fixed fraction of a cell, of a step or of the quantity.
 * Discretization errors scale differently, so that no fault is named for them. */
void diagnosis_find(const struct problem *p, const struct diagnosis_rung *fine, const struct diagnosis_rung *coarse,
                    struct diagnosis *d);

/* The same from the fits of all faults; NULL: there are none. */
void diagnosis_choose(const struct evidence *found, struct diagnosis *d);

/* The fault of *c with that size in a unit of fit_unit_names. */
struct diagnosis diagnosis_of(const struct fault_fit *c, const char *unit, double size);

/* Names whole steps of a program that is known to make one of about `late` dx^2/kappa where t_end is much shorter, or
 * none (late: minus its longest step), if an end at most that late explains the errors of both rungs.  An end that is
 * early by one size stays a clock. */
void diagnosis_whole_steps(double late, struct diagnosis *d);

/* Names data that are taken a part of a step late or early, from the difference of two answers on one grid: `apart`,
 * K, at the points of *f, whose steps differ by dt, s, the one with longer steps less the other. */
void diagnosis_steps(const struct problem *p, const struct field *f, const double *apart, double dt,
                     struct diagnosis *d);

/* Names a run whose temperatures are far outside the range of the solution, or overflow.  Returns 1 if they are. */
int diagnosis_unstable(const struct diagnosis_rung *r, struct diagnosis *d);
/* Names an answer that repeats its lowest or highest temperature at points where the solution goes
 * on, and the initial data differ.  Returns 1 if it does. */
int diagnosis_cut(const struct problem *p, const struct diagnosis_rung *r, struct diagnosis *d);
/* An unstable run: an answer that was refused for its temperatures (STATUS_UNSTABLE). */
void diagnosis_overflow(struct diagnosis *d);
/* The same of an answer with points that are inside only with two axes exchanged: pair 0: x and y, 1: y and z, 2: x
 * and z. */
void diagnosis_exchanged(int pair, struct diagnosis *d);

/* Names a difference `apart`, K, between two runs of the same case, of fields as large as `largest`, K, if it
 * exceeds the effect of summation order: a single field is then inconclusive.  Returns 1 if it does. */
int diagnosis_repeat(double apart, double largest, struct diagnosis *d);

/* Names temperatures that are all rounded to the same few digits, or to 24 bits, if this explains the error
 * (relative, E1); `cells` is the number along the longer side.  Returns 1 if it does. */
int diagnosis_rounding(const struct field *f, double error, double cells, struct diagnosis *d);

/* Writes the member "diagnosis" of an open object: null, or what, size, unit and share. */
void diagnosis_json(const struct diagnosis *d, struct json *j);

#endif
