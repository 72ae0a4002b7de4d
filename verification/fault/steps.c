/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data of another time than that of their stage, from two answers on one grid whose steps differ by dt.  An error of
 * order 1 in time differs between them by
 *
 *     T_2 - T_1 = n dt R + c h,   0 <= c
 *
 * with the response R to data that are taken n steps late, K/s, and h of Euler's method.  The errors in space cancel.
 */
#include "verification/fault/diagnosis.h"
#include "verification/fault/fit.h"
#include "verification/fault/response.h"
#include "verification/fault/wording.h"

#include "solver/field.h"
#include "solver/status.h"

#include <math.h>
#include <stdlib.h>

/* Sum of products over the points. */
static double product(size_t n, const double *a, const double *b) {
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

/* Fits `apart` by r and h; returns the share of its square, with the factor of r in *size. */
static double fit_both(size_t n, const double *apart, const double *r, const double *h, double *size) {
    double ar = product(n, apart, r), ah = product(n, apart, h), rr = product(n, r, r), rh = product(n, r, h);
    double hh = product(n, h, h), aa = product(n, apart, apart), det = rr * hh - rh * rh, c = 0;
    if (!(rr > 0 && aa > 0)) return 0;
    if (det > 1e-6 * rr * hh) c = (ah * rr - ar * rh) / det;
    if (c < 0) c = 0;
    *size = (ar - c * rh) / rr;
    return (*size * ar + c * ah) / aa;
}

void diagnosis_steps(const struct problem *p, const struct field *f, const double *apart, double dt,
                     struct diagnosis *d) {
    static const double SAME = 0.25;
    static const enum fault_kind kinds[] = {FAULT_WALL_TIME, FAULT_SOURCE_TIME};
    struct response_lattice l;
    *d = (struct diagnosis){.unit = "steps"};
    if (!(dt > 0) || response_lattice_create(p, &l)) return;
    double *array[3], size; /* base, h, R */
    for (int k = 0; k < 3; k++) array[k] = xcalloc(f->n, sizeof **array);
    response_base(p, &l, f, array[0], array[1]);
    double best = FIT_SHARE, euler = fit_both(f->n, apart, array[1], array[1], &size);
    double due = dt * problem_diffusivity(p) / (l.dx * l.dx);
    int is_euler = euler >= FIT_SHARE && fabs(fabs(size) / due - 1) < SAME; /* explicit or implicit steps */
    for (int k = 0; k < 2 && !is_euler; k++) {
        struct fault fault = {kinds[k], 0};
        struct response r;
        if (response_take(p, &l, fault, 0, &r)) continue;
        response_at(&r, &l, f, array[0], array[2]);
        response_free(&r);
        double share = fit_both(f->n, apart, array[2], array[1], &size);
        if (share < best) continue;
        best = share;
        d->named = 1, d->fault = fault, d->size = size / dt, d->share = share;
    }
    for (int k = 0; k < 3; k++) free(array[k]);
    response_lattice_free(&l);
    if (d->named) wording_fault(d);
}
