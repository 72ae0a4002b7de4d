/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_FIT_H
#define HEATLADDER_VERIFICATION_FAULT_FIT_H

/* The errors of a rung, and the share of them that one fault explains. */

struct diagnosis_rung;
struct field;
struct problem;
struct response_lattice;

static const double FIT_SHARE = 0.9; /* least share of the squared error that a fault must explain to be reported */
static const double FIT_MOST = 2; /* multiple of the second-order discretization error: a correct code's own error */

struct fit {
    double size, share;
    double part; /* |size f| / sqrt(|g + h/5|^2 + |3/2 m|^2) */
};

/* A rung: its errors, and the discretization errors of second-order differences. */
struct fit_errors {
    const struct field *field;
    double *e, *g, *h; /* K, owned; e is NAN at an excluded point */
    double *m;   /* K, owned: dx^2/24 laplace(T); for two materials dx^2/(24 kappa) dT/dt with the larger kappa */
    int is_mean; /* 1: the code may use cell means as point values */
};

/* If `mean` of *r is known, it is already subtracted.  The caller calls fit_errors_free. */
struct fit_errors fit_errors(const struct problem *p, const struct response_lattice *l,
                             const struct diagnosis_rung *r);
void fit_errors_free(struct fit_errors *s);

/* Least squares for a fault with the response f, K per unit of its size, at the points of *s. */
struct fit fit_fault(const struct fit_errors *s, const double *f);

#endif
