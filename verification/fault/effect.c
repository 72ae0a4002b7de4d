/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The error that a fault found in one problem would cause in another. */
#include "verification/fault/diagnosis.h"

#include "solver/field.h"
#include "verification/fault/fault_fits.h"
#include "verification/fault/response.h"

#include <math.h>
#include <string.h>

/* The size of *d at spacing dx, in the unit of its fault. */
static double size_at(const struct problem *p, const struct diagnosis *d, double dx) {
    double diffusive = dx * dx / problem_diffusivity(p);
    if (strcmp(d->unit, "cells") == 0) return d->size * dx;
    if (strcmp(d->unit, "%") == 0) return d->size / 100;
    if (strcmp(d->unit, "steps") == 0) return d->size * d->fourier * diffusive;
    if (strcmp(d->unit, FAULT_DIFFUSIVE) == 0) return d->size * diffusive;
    return *d->unit ? d->size : 1;
}

double diagnosis_effect(const struct problem *p, const struct diagnosis *d, double dx, double zero) {
    struct response_lattice l;
    struct response r;
    struct fault fault = d->fault;
    double size = size_at(p, d, dx), sum = 0, whole = 0;
    if (fault.kind == FAULT_MEAN) fault.axis = 0;
    if (fault.kind == FAULT_CORNER || fault.kind == FAULT_SAMPLES || response_lattice_create(p, &l)) return NAN;
    int failed = response_take(p, &l, fault, fault_bends(fault.kind) || fault.kind == FAULT_NEAR_WALL ? size : 0, &r);
    if (!failed) {
        struct field f;
        field_alloc_lattice(&f, p->dim, l.n, NULL);
        for (int a = 0; a < p->dim; a++)
            for (int i = 0; i < l.n[a]; i++) f.x[a][i] = p->lo[a] + (i + 0.5) * l.dx;
        response_at(&r, &l, &f, l.T, f.T);
        for (size_t i = 0; i < f.n; i++) sum += fabs(size * f.T[i]), whole += fabs(l.T[i] - zero);
        field_free(&f);
        response_free(&r);
    }
    response_lattice_free(&l);
    return failed ? NAN : sum / whole;
}
