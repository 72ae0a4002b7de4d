/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_FIT_H
#define HEATLADDER_VERIFICATION_FAULT_FIT_H

/* The errors of two rungs, and the share of them that each fault explains. */

#include "verification/fault/fault.h"

struct diagnosis_rung;
struct field;
struct response_lattice;

static const double FIT_SHARE = 0.9; /* least share of the squared error that a fault must explain to be reported */
static const double FIT_MOST = 2; /* multiple of the second-order discretization error: a correct code's own error */
/* Relative change of a size from rung to rung below which it counts as constant: the finest spacings of the battery
 * have the ratio 4/3, by which a size in a unit with another power of dx changes at least. */
static const double FIT_STEADY = 0.25;
static const char FIT_DIFFUSIVE[] = "dx^2/kappa"; /* a unit of time */

enum { FIT_FIELDS = 5 }; /* e, f, g, h, m */

struct fit {
    double size, share;
    double part;                            /* |size f| / sqrt(|g + h/5|^2 + |3/2 m|^2) */
    double product[FIT_FIELDS][FIT_FIELDS]; /* over the points */
    int numbers;                            /* 5, or 4: m is not fitted */
    double mean;                            /* the factor of m */
};

/* A rung: its errors, and the discretization errors of second-order differences. */
struct fit_errors {
    const struct field *field;
    double *e, *g, *h; /* K, owned; e is NAN at an excluded point */
    double *m;   /* K, owned: dx^2/24 laplace(T); for two materials dx^2/(24 kappa) dT/dt with the larger kappa */
    int is_mean; /* 1: the code may use cell means as point values */
};

/* If `mean` of *r is known, it is already subtracted.  Sets base[] by response_base.  The caller calls
 * fit_errors_free. */
struct fit_errors fit_errors(const struct problem *p, const struct response_lattice *l,
                             const struct diagnosis_rung *r, double *base);
void fit_errors_free(struct fit_errors *s);

/* Least squares for a fault with the response f, K per unit of its size, at the points of *s. */
struct fit fit_fault(const struct fit_errors *s, const double *f);

/* The share of the squared error that the fault explains with that size. */
double fit_share(const struct fit *fit, double size);

/* A fault at two rungs, the fine one first. */
struct fault_fit {
    struct fault fault;
    struct fit rung[2];
    double cell[2], step[2], diffusive[2]; /* units at the rungs: m; s, 0: unknown; dx^2/kappa, s */
    double whole;                          /* fault_whole */
    double unit[2];                        /* the unit in which the size is most nearly constant from rung to rung */
    double drift;     /* |log| of the change of the size in it; INFINITY if the size is not constant */
    const char *name; /* the unit: "steps", "s", "dx^2/kappa", "cells", "K" or "%" */
    unsigned sides;   /* fault_sides */
    double geometric; /* FAULT_MEAN: the effect of the geometric mean over that of the arithmetic one */
};

/* Faults that the problem of a row can have, fitted to its errors. */
enum { FIT_ALL = 160 };
struct evidence {
    int n;
    int melts; /* 1: a problem with phases */
    struct fault_fit fit[FIT_ALL];
};

/* Fits all faults to two rungs, the fine one first; the caller frees the result.  NULL: no lattice fits. */
struct evidence *fit_all(const struct problem *p, const struct diagnosis_rung *rung);

/* The first fit of that kind; NULL: there is none. */
const struct fault_fit *fit_first(const struct evidence *e, enum fault_kind kind);

/* The share of the errors that an end which is late or early (STEPS_LATE, STEPS_EARLY) by up to `most`, in units of
 * dx^2/kappa, by another part of it at each rung, explains; 0: none does.  NULL explains nothing. */
double fit_whole_steps(const struct evidence *e, int at, double most);

/* The share of the errors that an end which is one step late or early (`way`: 1 or -1) at some rungs and right at the
 * others explains; 0: none does.  off[k]: whether it is wrong at rung k. */
double fit_some_steps(const struct evidence *e, int way, int off[2]);

/* Names of the units of a kind, ended by NULL. */
const char *const *fit_unit_names(enum fault_kind kind);

/* The size of a unit at a rung, as in struct fault_fit; 0: the fit has no such unit. */
double fit_unit(const struct fault_fit *c, const char *name, int rung);

/* PACE_... of a fault with a size in that unit; 0: none. */
unsigned fit_pace(enum fault_kind kind, const char *unit);

#endif
