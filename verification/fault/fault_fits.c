/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of faults, and the fit of each at two rungs: a second one at the size found where the response is not
 * proportional to it. */
#include "verification/fault/fault_fits.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/fault/diagnosis.h"
#include "verification/fault/response.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = 20000 };

static int list_faults(const struct problem *p, struct fault *list) {
    static const struct {
        enum fault_kind kind;
        int count; /* number of axes, sides or corners */
    } kinds[] = {{FAULT_CLOCK, 1},
                 {FAULT_CONDUCTIVITY, 1},
                 {FAULT_SWAP, FAULT_PAIRS},
                 {FAULT_TRANSPOSED, FAULT_PAIRS},
                 {FAULT_SOURCE, 1},
                 {FAULT_CAPACITY, 1},
                 {FAULT_INTERFACE, 1},
                 {FAULT_MEAN, 1},
                 {FAULT_AMPLITUDE, 1},
                 {FAULT_SOURCE_TIME, 1},
                 {FAULT_FROZEN, 1},
                 {FAULT_DIFFUSIVITY, 1},
                 {FAULT_OFFSET, 1},
                 {FAULT_NEAR_WALL, 1},
                 {FAULT_ISOTROPIC, FAULT_OTHERS},
                 {FAULT_EXTENT, FAULT_ALL_AXES + 1},
                 {FAULT_START_SHIFT, DIM_MAX},
                 {FAULT_START_WIDTH, DIM_MAX},
                 {FAULT_SAMPLES, DIM_MAX},
                 {FAULT_WALL, FAULT_ALL_SIDES + 1},
                 {FAULT_CORNER, FAULT_CORNERS},
                 {FAULT_WALL_TIME, 1 + SIDES},
                 {FAULT_WALL_FROZEN, 1},
                 {FAULT_WALL_SWING, 1},
                 {FAULT_COEFFICIENT, FAULT_ALL_SIDES + 1},
                 {FAULT_LAW, LAWS},
                 {FAULT_AXIS, DIM_MAX},
                 {FAULT_RHO_C, 2}};
    int n = 0;
    struct faulty ignored;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (int a = 0; a < kinds[i].count; a++) {
            list[n] = (struct fault){kinds[i].kind, a};
            n += fault_make(p, list[n], 0, &ignored);
        }
    return n;
}

/* About POINTS points of a rung, evenly spaced in its order; `drop` frees the arrays. */
static struct diagnosis_rung sample(const struct diagnosis_rung *r, struct field *f) {
    size_t stride = r->field->n / POINTS + 1;
    if (stride > 1) stride |= 1; /* so that the stride does not select columns of a lattice */
    size_t n = (r->field->n + stride - 1) / stride;
    double *exact = xcalloc(n, sizeof *exact);
    field_alloc(f, r->field->dim, n);
    f->weight = r->field->weight ? xcalloc(n, sizeof *f->weight) : NULL;
    for (size_t i = 0; i < n; i++) {
        double x[DIM_MAX];
        field_put(f, i, field_place(r->field, i * stride, x));
        if (f->weight) f->weight[i] = r->field->weight[i * stride];
        f->T[i] = r->field->T[i * stride];
        exact[i] = r->exact[i * stride];
    }
    return (struct diagnosis_rung){f, exact, r->dx, r->dt, r->mean};
}

static void drop(struct diagnosis_rung *r, struct field *f) {
    free((void *)r->exact);
    field_free(f);
}

/* Two rungs, the fine one first, and the data for the responses to faults. */
struct looked_at {
    const struct problem *p;
    const struct response_lattice *l;
    const struct diagnosis_rung *rung;
    struct fit_errors errors[2];
    double *base[2], *response;
};

/* Both fits of a fault with its response at that size (0: a small size).  Returns 0, or -1 if there is no
 * response. */
static int fit_at(const struct looked_at *at, struct fault fault, double size, struct fit fit[2]) {
    struct response r = {.size = 0};
    int corner = fault.kind == FAULT_CORNER, near = fault.kind == FAULT_NEAR_WALL, failed = 0;
    if (!corner && !near) failed = response_take(at->p, at->l, fault, size, &r);
    for (int k = 0; k < 2 && !failed; k++) {
        const struct field *f = at->rung[k].field;
        if (near) response_free(&r);
        if (near) failed = response_take(at->p, at->l, fault, at->rung[k].dx / 2, &r); /* the size is then known */
        if (failed) break;
        if (corner)
            failed = response_at_corner(at->p, at->rung[k].dx, fault, f, at->response);
        else
            response_at(&r, at->l, f, at->base[k], at->response);
        if (!failed) fit[k] = fit_fault(&at->errors[k], at->response);
    }
    response_free(&r);
    return failed;
}

/* The response to a coefficient is not linear.  It is therefore evaluated again at the size s of the previous fit,
 * which gives a size f(s), until the two agree.  The next s follows from the secant through the last two f: for a
 * wall of almost no resistance f = -(1 + s), for which the fixed-point iteration s = f would not converge. */
static int fit_bent(const struct looked_at *at, struct fault fault, struct fit fit[2]) {
    enum { ROUNDS = 6 };
    static const double LARGE = 0.05, MOST = 3, SAME = 0.01, LIKELY = 0.5, STEEP = 0.9;
    const int phase = fault.kind == FAULT_WALL_TIME;
    const double least = phase                             ? -MOST
                         : fault.kind == FAULT_COEFFICIENT ? -1
                                                           : -0.9; /* b may be 0, k and rho c not */
    const double unit = phase ? at->p->t_end / 4 : 1;
    int failed = fit_at(at, fault, 0, fit);
    double before[2] = {0, fit[0].size}, s = before[1];
    for (int round = 0; round < ROUNDS && !failed && fault_bends(fault.kind); round++) {
        if (!(fit[0].share > LIKELY && fit[0].part > FIT_MOST && fabs(s) > LARGE * unit)) break;
        s = fmin(fmax(s, least * unit), MOST * unit);
        failed = fit_at(at, fault, s, fit);
        double found = fit[0].size, slope = (found - before[1]) / (s - before[0]);
        if (failed || fabs(found - s) <= SAME * fabs(found)) break;
        before[0] = s, before[1] = found;
        s = slope < STEEP ? (found - slope * s) / (1 - slope) : found;
    }
    return failed;
}

static int fit_all(const struct problem *p, const struct diagnosis_rung *rung, struct fault_fit *c) {
    struct response_lattice l;
    struct fault list[FAULT_FITS];
    int n = 0, faults = list_faults(p, list);
    if (response_lattice_create(p, &l)) return 0;
    struct looked_at at = {.p = p, .l = &l, .rung = rung};
    for (int k = 0; k < 2; k++) {
        double dx2 = pow(rung[k].dx / l.dx, 2);
        at.errors[k] = fit_errors(p, &l, &rung[k]);
        at.base[k] = xcalloc(rung[k].field->n, sizeof **at.base);
        for (size_t i = 0; i < rung[k].field->n; i++) at.base[k][i] = at.errors[k].g[i] / dx2 + rung[k].exact[i];
    }
    at.response = xcalloc(rung[0].field->n + rung[1].field->n, sizeof *at.response);
    for (int i = 0; i < faults; i++) {
        struct fit fit[2];
        if (fit_bent(&at, list[i], fit) || !fault_can_be(p, list[i].kind, fit[0].size)) continue;
        c[n] = (struct fault_fit){.fault = list[i], .fine = fit[0], .coarse = fit[1]};
        fault_scaling(p, &c[n++], &rung[0], &rung[1]);
    }
    for (int k = 0; k < 2; k++) {
        free(at.base[k]);
        fit_errors_free(&at.errors[k]);
    }
    free(at.response);
    response_lattice_free(&l);
    return n;
}

int fault_fits_all(const struct problem *p, const struct diagnosis_rung *rung, struct fault_fit *c) {
    struct field field[2];
    struct diagnosis_rung sampled[2] = {sample(&rung[0], &field[0]), sample(&rung[1], &field[1])};
    int n = fit_all(p, sampled, c);
    for (int i = 0; i < 2; i++) drop(&sampled[i], &field[i]);
    return n;
}
