/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Consistency of the derivative operators (Song 2018, sections 4.1 and 4.2): on a lattice, where odd terms cancel, a
 * Taylor expansion to order p gives first (p = 1) and second (p = 2) derivatives to second order in dx.  The error
 * contains no time step, walls or initial data.
 *
 * The test function is u = exp(a.x) sin(b.x + c), with distinct derivatives: for D = d/dx, D u = a u + b v and D
 * v = a v - b u, v = exp(a.x) cos(b.x + c). */
#include "verification/stability/consistency.h"

#include "solver/particles/particles.h"
#include "verification/case/experiment.h"

#include <math.h>

static const double A[2] = {0.3, -0.2}, B[2] = {1.1, 0.7}, PHASE = 0.4; /* m^-1 */
enum { POINTS = 16 };

static double smooth(const double x[2]) {
    return exp(A[0] * x[0] + A[1] * x[1]) * sin(B[0] * x[0] + B[1] * x[1] + PHASE);
}

static void derivatives(const double x[2], int a, double *first, double *second) {
    double u = smooth(x), v = exp(A[0] * x[0] + A[1] * x[1]) * cos(B[0] * x[0] + B[1] * x[1] + PHASE);
    *first = A[a] * u + B[a] * v;
    *second = (A[a] * A[a] - B[a] * B[a]) * u + 2 * A[a] * B[a] * v;
}

/* sum w_j (u_j - u_i) */
static double apply(const struct neighbourhood *nb, const double *w, const double x[2]) {
    double sum = 0, u = smooth(x);
    for (size_t j = 0; j < nb->n; j++) {
        double at[2] = {x[0] + nb->d[j][0], x[1] + nb->d[j][1]};
        sum += w[j] * (smooth(at) - u);
    }
    return sum;
}

/* Adds the error at x to *error, and the magnitude of the exact value to *size. */
static void compare(const struct neighbourhood *nb, int sweeps, double *const w[2], const double x[2], double *error,
                    double *size) {
    double whole = 0;
    for (int a = 0; a < nb->dim; a++) {
        double first, second;
        derivatives(x, a, &first, &second);
        whole += nb->kappa[a] * second;
        if (sweeps == 1) continue;
        *error += fabs(apply(nb, w[a], x) - first);
        *size += fabs(first);
    }
    if (sweeps == 2) return;
    *error += fabs(apply(nb, w[0], x) - whole);
    *size += fabs(whole);
}

int consistency_error(const struct experiment *e, double *error, struct failure *why) {
    const struct problem *p = &e->problem;
    const struct options *o = &e->options;
    const struct scheme *scheme = e->method->scheme;
    double d[NEIGHBOURS_MAX][DIM_MAX], w0[NEIGHBOURS_MAX], w1[NEIGHBOURS_MAX], *w[2] = {w0, w1}, size = 0;
    if (!scheme)
        return refuse(why, STATUS_NOT_APPLICABLE, "%s is not a particle method and has no weights", e->method->name);
    int order = o->order > 2 ? o->order : 2;
    struct neighbourhood nb;
    if (operator_neighbourhood(p->dim, o->dx, o->h > 0 ? o->h : 1.1 * order / 2, d, &nb, why)) return why->status;
    if (scheme->volume) nb.volume = scheme->volume(p, o, nb.h, nb.volume);
    nb.rho_c = p->material[0].rho_c;
    for (int a = 0; a < p->dim; a++) nb.kappa[a] = p->material[0].k[a] / p->material[0].rho_c;
    if (particles_check(p, o, scheme, why) || operator_weights(scheme, p, o, &nb, w, why)) return why->status;
    *error = 0;
    for (int i = 0; i < POINTS; i++) {
        double x[2] = {-1 + 0.137 * i, p->dim == 2 ? 0.9 - 0.119 * i : 0};
        compare(&nb, scheme->sweeps, w, x, error, &size);
    }
    *error /= size;
    return STATUS_OK;
}
