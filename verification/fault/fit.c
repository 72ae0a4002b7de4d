/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Least squares of the error field e with the response f of one fault at a time, in addition to the discretization
 * errors of second-order differences at the same spacing: in space g, in time (Euler's, at mesh Fourier number 1) h,
 *
 *     e = size f + b g + c h + d m,    |b| <= 2,  |c| <= 1/2,  |d| <= 2
 *
 * since a faulty code has discretization errors too. m = dx^2/24 laplace(T) is the difference between a cell mean
 * and the value at its centre.  The numbers of a code are values (d = 0), cell means (1), or linear elements with
 * projected initial data (-2 at their nodes, 2 with a lumped mass). d is constant in time, because d m evolves like
 * T, unless a source adds values to means.  An answer at the start determines d (diagnosis_mean), and its part is
 * subtracted from e.  Without one, if m resembles the fault (for one material without a source it is dx^2/(24 kappa)
 * dT/dt, a clock that is fast by a sixth of a step at F = 1/4), no fit can separate them, and d = 1/2, between
 * values and means, is used.  For data with jumps, where means are values on faces, g already includes it: d = 0.
 *
 * A fault with |size f| below twice |g + h/5| or three times |m|, more than any of these d differ from 1/2, is not
 * reported: that is the size of a correct code's error.  The 5 % of the points with the largest g (discontinuous
 * corners) are excluded. */
#include "verification/fault/fit.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/fault/diagnosis.h"
#include "verification/fault/response.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdlib.h>

enum { ROUNDS = 20000 };

/* Minimizes over size, b, c and d in turn until they converge: four numbers, three of them bounded. */
struct fit fit_fault(const struct fit_errors *s, const double *f) {
    enum { N = 5 };
    double a[N][N] = {{0}}; /* products of e, f, g, h, m */
    for (size_t i = 0; i < s->field->n; i++) {
        double w = s->field->weight ? s->field->weight[i] : 1, v[N] = {s->e[i], f[i], s->g[i], s->h[i], s->m[i]};
        if (!isfinite(v[0])) continue;
        for (int k = 0; k < N; k++)
            for (int l = 0; l < N; l++) a[k][l] += w * v[k] * v[l];
    }
    if (!(a[0][0] > 0 && a[1][1] > 0)) return (struct fit){0, 0, 0};
    double x[N] = {-1, 0, 0, 0, s->is_mean ? 0.5 : 0}; /* coefficients of e, f, g, h, m: x.v is the residual */
    int numbers = s->is_mean && a[1][4] * a[1][4] < FIT_SHARE * a[1][1] * a[4][4] ? N : N - 1;
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 1; k < numbers; k++) {
            double rest = 0, most = k == 1 ? INFINITY : k == 3 ? 0.5 : FIT_MOST;
            for (int l = 0; l < N; l++) rest -= l == k ? 0 : a[k][l] * x[l];
            x[k] = a[k][k] > 0 ? fmax(-most, fmin(most, rest / a[k][k])) : 0;
        }
    double left = 0, natural = a[2][2] + 0.4 * a[2][3] + 0.04 * a[3][3] + 2.25 * a[4][4];
    for (int k = 0; k < N; k++)
        for (int l = 0; l < N; l++) left += x[k] * a[k][l] * x[l];
    return (struct fit){x[1], 1 - left / a[0][0], fabs(x[1]) * sqrt(a[1][1] / fmax(natural, 1e-300))};
}

struct fit_errors fit_errors(const struct problem *p, const struct response_lattice *l,
                             const struct diagnosis_rung *r) {
    const struct field *f = r->field;
    struct fit_errors s = {.field = f, .is_mean = p->jumps[0] + p->jumps[1] + p->jumps[2] == 0 && p->materials == 1};
    double **const owned[] = {&s.e, &s.g, &s.h, &s.m};
    for (int k = 0; k < 4; k++) *owned[k] = xcalloc(f->n, sizeof(double));
    double *size = xcalloc(f->n, sizeof *size), dx2 = pow(r->dx / l->dx, 2);
    response_base(p, l, f, s.g, s.h);
    struct response clock;
    if (p->materials == 1) {
        response_laplacian(p, l, f, s.m);
    } else if (!response_take(p, l, (struct fault){FAULT_CLOCK, 0}, 0, &clock)) {
        response_at(&clock, l, f, s.g, s.m);
        response_free(&clock);
    }
    double kappa = p->materials == 1 ? 1 : problem_diffusivity(p);
    for (size_t i = 0; i < f->n; i++) s.m[i] *= r->dx * r->dx / (24 * kappa);
    for (size_t i = 0; i < f->n; i++) {
        s.g[i] = dx2 * (s.g[i] - r->exact[i]);
        s.h[i] *= dx2;
        size[i] = isfinite(s.g[i]) ? fabs(s.g[i]) : INFINITY;
    }
    gsl_sort(size, 1, f->n);
    double largest = size[f->n - 1 - f->n / 20];
    for (size_t i = 0; i < f->n; i++) {
        s.e[i] = fabs(s.g[i]) <= largest ? f->T[i] - r->exact[i] : NAN;
        if (!s.is_mean || !isfinite(r->mean)) continue;
        s.e[i] -= r->mean * s.m[i];
        s.m[i] = 0;
    }
    free(size);
    return s;
}

void fit_errors_free(struct fit_errors *s) {
    free(s->e);
    free(s->g);
    free(s->h);
    free(s->m);
}
