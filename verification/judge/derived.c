/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fluxes, heat, temperatures and fronts of a field on arbitrary points. */
#include "verification/judge/derived.h"

#include "references/kirchhoff.h"
#include "references/quantity.h"
#include "solver/field.h"
#include "solver/status.h"
#include "verification/judge/interpolate.h"

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

/* Numbers of panels of the box from lo to hi along each axis but `skip` (-1: none); returns the quadrature points. */
static int divide(const struct problem *p, const double *lo, const double *hi, int skip, double dx, int parts[]) {
    int points = 1;
    for (int a = 0; a < p->dim; a++) {
        parts[a] = a == skip ? 0 : panels(hi[a] - lo[a], dx);
        points *= a == skip ? 1 : 3 * parts[a];
    }
    return points;
}

/* Quadrature point k and its weight; the coordinate along an axis without panels is left as it is. */
static double quadrature_point(const struct problem *p, const double *lo, const double *hi, const int parts[], int k,
                               double *x) {
    double weight = 1, w;
    for (int a = 0; a < p->dim; a++) {
        if (parts[a] == 0) continue;
        x[a] = place(lo[a], hi[a], parts[a], k % (3 * parts[a]), &w);
        weight *= w;
        k /= 3 * parts[a];
    }
    return weight;
}

static int flux(enum side s, const struct problem *p, const struct interpolate *f, double dx, double *value,
                struct failure *why) {
    int a = (int)s / 2, parts[DIM_MAX], points = divide(p, p->lo, p->hi, a, dx, parts);
    double x[DIM_MAX] = {0}, T, gradient[DIM_MAX];
    *value = 0;
    x[a] = s % 2 ? p->hi[a] : p->lo[a];
    for (int k = 0; k < points; k++) {
        double w = quadrature_point(p, p->lo, p->hi, parts, k, x);
        if (interpolate_at(f, x, &T, gradient, why)) return why->status;
        double there = kirchhoff_along(p, material_at(p, x[0]), a, T);
        *value += w * there * (s % 2 ? gradient[a] : -gradient[a]);
    }
    return STATUS_OK;
}

/* Heat of from <= x <= to, within one material. */
static int heat_between(double from, double to, const struct problem *p, struct interpolate *f, double dx,
                        double *value, struct failure *why) {
    double lo[DIM_MAX] = {from, p->lo[1], p->lo[2]}, hi[DIM_MAX] = {to, p->hi[1], p->hi[2]}, x[DIM_MAX] = {0}, T;
    double rho_c = material_at(p, (from + to) / 2)->rho_c;
    int parts[DIM_MAX], points = divide(p, lo, hi, -1, dx, parts);
    f->from = from - 1e-9 * (to - from), f->to = to + 1e-9 * (to - from);
    for (int k = 0; k < points; k++) {
        double w = quadrature_point(p, lo, hi, parts, k, x);
        if (interpolate_at(f, x, &T, NULL, why)) return why->status;
        *value += w * rho_c * T;
    }
    return STATUS_OK;
}

static int heat(const struct problem *p, struct interpolate *f, double dx, double *value, struct failure *why) {
    *value = 0;
    if (p->materials == 1) return heat_between(p->lo[0], p->hi[0], p, f, dx, value, why);
    if (heat_between(p->lo[0], p->interface, p, f, dx, value, why)) return why->status;
    return heat_between(p->interface, p->hi[0], p, f, dx, value, why);
}

/* 1 if x is within 22.5 degrees of an axis, or of a diagonal of the body; each point of a plane is one or the other.
 */
static int is_in_sector(enum front_sector sector, int dim, const double *x, double r) {
    static const double NEAR = 0.92387953251128675613; /* cos(pi/8) */
    double most = 0, sum = 0;
    for (int a = 0; a < dim; a++) most = fmax(most, fabs(x[a])), sum += fabs(x[a]);
    return sector == FRONT_ALL || (sector == FRONT_AXES ? most : sum / sqrt(dim)) > NEAR * r;
}

/* r_f of k = k_0 T^n.  T^n is linear in r^2 behind a front that spreads from r = 0, and in x behind one that a wall
 * drives: the root of a straight line, by least squares.  T^n between 0.2 and 0.8 of its maximum is 0.45 to 0.89 r_f,
 * where the point at the maximum and the cells at the front, with an error as large as their T, have no part. */
static int spread(enum front_sector sector, const struct problem *p, const struct field *f, double *value,
                  struct failure *why) {
    static const double LEAST = 0.2, MOST = 0.8;
    const int driven = p->side[X_LO] != NEUMANN;
    double most = 0, n = 0, s = 0, ss = 0, u = 0, su = 0;
    for (size_t i = 0; i < f->n; i++) most = fmax(most, pow(fmax(0, f->T[i] - p->k_ref), p->k_n));
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX], r2 = 0, v = pow(fmax(0, f->T[i] - p->k_ref), p->k_n) / most;
        field_place(f, i, x);
        for (int a = 0; a < f->dim; a++) r2 += x[a] * x[a];
        if (!(v >= LEAST && v <= MOST) || !is_in_sector(sector, f->dim, x, sqrt(r2))) continue;
        const double at = driven ? x[0] : r2;
        n++, s += v, ss += v * v, u += at, su += v * at; /* the place is a straight line in T^n */
    }
    const double apart = n * ss - s * s, root = apart > 1e-9 * n * ss ? (u * ss - s * su) / apart : NAN;
    *value = driven ? root : sqrt(root);
    if (isfinite(*value)) return STATUS_OK;
    return refuse(why, STATUS_NUMERICAL, "quantity 'front': no two points have T^n from %g to %g of its maximum",
                  LEAST, MOST);
}

/* From the points alone: the last one of the phase at x = lo, and the next one that is not of it. */
static int melt_front(const struct problem *p, const struct field *f, double *value, struct failure *why) {
    double x[DIM_MAX], near[2] = {-INFINITY, INFINITY}, T[2] = {NAN, NAN}, first = INFINITY;
    int melted = 0;
    for (size_t i = 0; i < f->n; i++)
        if (field_place(f, i, x)[0] < first) first = x[0], melted = f->T[i] > p->k_ref;
    for (size_t i = 0; i < f->n; i++)
        if ((melted ? f->T[i] > p->k_ref : f->T[i] < p->k_ref) && field_place(f, i, x)[0] > near[0])
            near[0] = x[0], T[0] = f->T[i];
    for (size_t i = 0; i < f->n; i++)
        if (field_place(f, i, x)[0] > near[0] && x[0] < near[1]) near[1] = x[0], T[1] = f->T[i];
    *value = near[0] + (p->k_ref - T[0]) / (T[1] - T[0]) * (near[1] - near[0]);
    if (isfinite(*value)) return STATUS_OK;
    return refuse(why, STATUS_NUMERICAL, "quantity 'front': no two points are on either side of %g K", p->k_ref);
}

int derived_value(const struct quantity *q, const struct problem *p, const struct field *field, double dx,
                  double *value, struct failure *why) {
    struct interpolate f = interpolate_begin("the field", field);
    int status;
    if (p->materials == 2 && q->kind == QUANTITY_AT) { /* one polynomial must not extend across the kink */
        f.from = q->at[0] >= p->interface ? p->interface : -INFINITY;
        f.to = q->at[0] < p->interface ? p->interface : INFINITY;
    }
    if (q->kind == QUANTITY_FRONT)
        status = p->k_law == K_POWER ? spread(q->sector, p, field, value, why) : melt_front(p, field, value, why);
    else if (q->kind == QUANTITY_AT)
        status = interpolate_at(&f, q->at, value, NULL, why);
    else
        status = q->kind == QUANTITY_FLUX ? flux(q->side, p, &f, dx, value, why) : heat(p, &f, dx, value, why);
    interpolate_end(&f);
    return status;
}
