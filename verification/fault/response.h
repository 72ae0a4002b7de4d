/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_RESPONSE_H
#define HEATLADDER_VERIFICATION_FAULT_RESPONSE_H

#include "solver/field.h"
#include "verification/fault/fault.h"

/* The response of the final temperature to a fault, by finite differences on a lattice of this program.  It explains
 * an error; no verdict depends on it. */

struct response_lattice {
    int n[DIM_MAX]; /* cells, 1 past dim */
    double dx;      /* m */
    double *T;      /* K, n[0] n[1] n[2], for the problem without a fault; owned */
    double *longer; /* K: dT/dF for Euler steps, with the mesh Fourier number F; owned; NULL for phases */
    double *apart;  /* K: T less that by the steps of the responses; owned; NULL for phases */
};

/* Finds the lattice of about 64 cells along x (in space 16 along the longest axis) that fits the domain (and, if
 * possible, the interface and jumps), and solves for T.  Returns 0, or -1 if none fits. */
int response_lattice_create(const struct problem *p, struct response_lattice *l);
void response_lattice_free(struct response_lattice *l);

/* Interpolates T of the lattice to the points of *f, K, into base[f->n], and dT/dF into longer[f->n].  The
 * discretization errors, `base` minus the exact solution in space and `longer` in time, are proportional to dx^2. */
void response_base(const struct problem *p, const struct response_lattice *l, const struct field *f, double *base,
                   double *longer);

/* laplace(T) at the points of *f, K m^-2, into out[f->n], for one material. */
void response_laplacian(const struct problem *p, const struct response_lattice *l, const struct field *f,
                        double *out);

/* The final temperature of *p with that fault. */
struct response {
    struct faulty with;
    double size;    /* size of the fault */
    struct field T; /* K, on the lattice; owned */
};

/* Evaluates the response at a size of the fault; 0: a small one.  Returns 0, or -1 if *p cannot have the fault;
 * nothing is then to be freed. */
int response_take(const struct problem *p, const struct response_lattice *l, struct fault fault, double size,
                  struct response *r);
void response_free(struct response *r);

/* Sets out[f->n] to dT/dsize at the points of *f, K per unit of the fault's size (for a fault that is either present
 * or absent: the difference); base: by response_base. */
void response_at(const struct response *r, const struct response_lattice *l, const struct field *f,
                 const double *base, double *out);

/* Sets response[f->n] to the response to a fault of FAULT_RUNG, K, on a lattice of cells of size dx, m: what is wrong
 * in a cell is not proportional to dx.  Returns 0, or -1 if *p cannot have the fault or more than 160 cells along x
 * (48 in space) would be needed. */
int response_on_cells(const struct problem *p, double dx, struct fault fault, const struct field *f,
                      double *response);

#endif
