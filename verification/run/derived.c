/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fluxes, heat and temperatures of a field on arbitrary points. */
#include "verification/run/derived.h"

#include "references/kirchhoff.h"
#include "references/quantity.h"
#include "solver/field.h"
#include "solver/status.h"
#include "verification/run/interpolate.h"

#include <math.h>

/* Three-point Gauss-Legendre rule on [-1, 1], exact to degree five. */
static const double NODE[3] = {-0.77459666924148337704, 0, 0.77459666924148337704};
static const double WEIGHT[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
static const double PANEL = 4; /* spacings */

static const struct material *material_at(const struct problem *p, double x) {
    return &p->material[p->materials == 2 && x >= p->interface];
}

static int panels(double length, double dx) {
    return (int)fmax(1, ceil(length / (PANEL * dx)));
}

/* Point k of a line from lo to hi, and its weight. */
static double place(double lo, double hi, int parts, int k, double *weight) {
    double half = (hi - lo) / parts / 2;
    *weight = WEIGHT[k % 3] * half;
    return lo + half * (2 * (k / 3) + 1 + NODE[k % 3]);
}

static int flux(enum side s, const struct problem *p, const struct interpolate *f, double dx, double *value,
                struct failure *why) {
    int a = (int)s / 2, along = 1 - a, parts = p->dim == 2 ? panels(p->hi[along] - p->lo[along], dx) : 1;
    *value = 0;
    for (int k = 0; k < (p->dim == 2 ? 3 * parts : 1); k++) {
        double x[2] = {0, 0}, w = 1, T, gradient[2];
        if (p->dim == 2) x[along] = place(p->lo[along], p->hi[along], parts, k, &w);
        x[a] = s % 2 ? p->hi[a] : p->lo[a];
        if (interpolate_at(f, x, &T, gradient, why)) return why->status;
        double there = kirchhoff_along(p, material_at(p, x[0]), a, T);
        *value += w * there * (s % 2 ? gradient[a] : -gradient[a]);
    }
    return STATUS_OK;
}

/* Heat of lo <= x <= hi, within one material. */
static int heat_between(double lo, double hi, const struct problem *p, struct interpolate *f, double dx,
                        double *value, struct failure *why) {
    int px = panels(hi - lo, dx), py = p->dim == 2 ? panels(p->hi[1] - p->lo[1], dx) : 1;
    double rho_c = material_at(p, (lo + hi) / 2)->rho_c, T;
    f->from = lo - 1e-9 * (hi - lo), f->to = hi + 1e-9 * (hi - lo);
    for (int j = 0; j < (p->dim == 2 ? 3 * py : 1); j++)
        for (int i = 0; i < 3 * px; i++) {
            double wx, wy = 1, x[2] = {place(lo, hi, px, i, &wx), 0};
            if (p->dim == 2) x[1] = place(p->lo[1], p->hi[1], py, j, &wy);
            if (interpolate_at(f, x, &T, NULL, why)) return why->status;
            *value += wx * wy * rho_c * T;
        }
    return STATUS_OK;
}

static int heat(const struct problem *p, struct interpolate *f, double dx, double *value, struct failure *why) {
    *value = 0;
    if (p->materials == 1) return heat_between(p->lo[0], p->hi[0], p, f, dx, value, why);
    if (heat_between(p->lo[0], p->interface, p, f, dx, value, why)) return why->status;
    return heat_between(p->interface, p->hi[0], p, f, dx, value, why);
}

int derived_value(const struct quantity *q, const struct problem *p, const struct field *field, double dx,
                  double *value, struct failure *why) {
    struct interpolate f = interpolate_begin("the field", field->dim, field->n, field->x, field->y, field->T);
    int status;
    if (p->materials == 2 && q->kind == QUANTITY_AT) { /* one polynomial must not extend across the kink */
        f.from = q->at[0] >= p->interface ? p->interface : -INFINITY;
        f.to = q->at[0] < p->interface ? p->interface : INFINITY;
    }
    if (q->kind == QUANTITY_AT)
        status = interpolate_at(&f, q->at, value, NULL, why);
    else
        status = q->kind == QUANTITY_FLUX ? flux(q->side, p, &f, dx, value, why) : heat(p, &f, dx, value, why);
    interpolate_end(&f);
    return status;
}
