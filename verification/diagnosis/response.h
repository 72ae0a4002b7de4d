/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_DIAGNOSIS_RESPONSE_H
#define HEATLADDER_VERIFICATION_DIAGNOSIS_RESPONSE_H

#include "solver/field.h"
#include "verification/diagnosis/fault.h"

/* The response of the final temperature to a fault, by finite differences on a lattice of this program's own.  It
 * explains an error; no verdict rests on it. */

struct response_lattice {
    int n[2];       /* cells */
    double dx;      /* m */
    double *T;      /* K, n[0] n[1], of the problem as it is; owned */
    double *longer; /* K: dT/dF, F the mesh Fourier number, of Euler's steps; owned */
};

/* The lattice of some 64 cells along x that fits the domain (and the interface and jumps, where one does), with T. 0;
 * -1 where none is found. */
int response_lattice_create(const struct problem *p, struct response_lattice *l);
void response_lattice_free(struct response_lattice *l);

/* T of the lattice at the points of *f, K, into base[f->n], and dT/dF into longer[f->n].  Both `base` less the exact
 * solution, what differences of second order leave in space, and `longer`, in time, go as dx^2. */
void response_base(const struct problem *p, const struct response_lattice *l, const struct field *f, double *base,
                   double *longer);

/* laplace(T) at the points of *f, K m^-2, into out[f->n], of one material. */
void response_laplacian(const struct problem *p, const struct response_lattice *l, const struct field *f,
                        double *out);

/* The final temperature of *p with that fault. */
struct response {
    struct faulty with;
    double size;    /* size of the fault */
    struct field T; /* K, on the lattice; owned */
};

/* At a size of the fault, 0: a small one.  0; -1 where *p cannot have it, and nothing is to be freed. */
int response_take(const struct problem *p, const struct response_lattice *l, struct fault fault, double size,
                  struct response *r);
void response_free(struct response *r);

/* dT/dsize at the points of *f, K per unit of the fault's size (of one that is there in full or not: the whole
 * difference), into out[f->n]; base: of response_base. */
void response_at(const struct response *r, const struct response_lattice *l, const struct field *f,
                 const double *base, double *out);

/* The response to FAULT_CORNER, K for all that is lost, into response[f->n].  Taken on a lattice of cells of the size
 * dx, m, since what a corner's cell lacks does not go in proportion to it.  0; -1 where *p cannot have that fault or
 * there would be more than 160 cells along x. */
int response_at_corner(const struct problem *p, double dx, struct fault fault, const struct field *f,
                       double *response);

#endif
