/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derived quantities of the exact solution.
 *
 * The flux density follows from the boundary condition: q on a Neumann side, b (T_a - T) on a Robin side, k dT/dn on
 * a Dirichlet side.  On a Dirichlet side of a plate it grows as 1/distance towards a corner with a side at another
 * temperature, and its integral diverges.  The quadrature (cubature.h) is graded towards ends, jumps and interface
 * down to the diffusion length. */
#include "references/quantity.h"

#include "references/cubature.h"
#include "references/kirchhoff.h"
#include "references/snapshot.h"

#include "solver/shape.h"
#include "solver/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Names of the wall fluxes, indexed by enum side. */
static const char *const plane_flux[] = {"flux_x_lo", "flux_x_hi", "flux_y_lo", "flux_y_hi"};
static const char *const round_flux[] = {"flux_r_lo", "flux_r_hi"};

static int read_place(const char *text, const struct problem *p, struct quantity *q, struct failure *why) {
    const char *at = text + strlen("at:");
    q->kind = QUANTITY_AT;
    for (int a = 0; a < p->dim; a++) {
        char *end;
        q->at[a] = strtod(at, &end);
        if (end == at || *end != (a + 1 < p->dim ? ',' : '\0') || !isfinite(q->at[a]))
            return refuse(why, STATUS_INPUT, "quantity '%.60s': at: needs %s, such as %s", text,
                          p->dim == 2 ? "X,Y" : "one number", p->dim == 2 ? "at:0.1,0.2" : "at:0.1");
        if (q->at[a] < p->lo[a] || q->at[a] > p->hi[a])
            return refuse(why, STATUS_INPUT, "quantity '%.60s': %c = %g m is outside %g to %g m", text, a ? 'y' : 'x',
                          q->at[a], p->lo[a], p->hi[a]);
        at = end + 1;
    }
    if (p->shape && shape_depth(p, q->at) < 0)
        return refuse(why, STATUS_INPUT, "quantity '%.60s': (%g, %g) m is outside the %s", text, q->at[0], q->at[1],
                      p->shape->name);
    return STATUS_OK;
}

int quantity_read(const char *text, const struct problem *p, struct quantity *q, struct failure *why) {
    const char *const *flux = p->shape ? round_flux : plane_flux;
    *q = (struct quantity){.kind = QUANTITY_HEAT};
    if (strncmp(text, "at:", 3) == 0) return read_place(text, p, q, why);
    if (strcmp(text, "heat") == 0) return STATUS_OK;
    for (int s = 0; s < 2 * p->dim; s++) {
        if (!shape_has_wall(p, s) || strcmp(text, flux[s]) != 0) continue;
        *q = (struct quantity){.kind = QUANTITY_FLUX, .side = (enum side)s};
        return STATUS_OK;
    }
    char valid[64] = "";
    for (int s = 0; s < 2 * p->dim; s++)
        if (shape_has_wall(p, s)) strcat(strcat(valid, flux[s]), ", ");
    return refuse(why, STATUS_INPUT, "unknown quantity '%.60s' (valid: %sheat, at:%s)", text, valid,
                  p->dim == 2 ? "X,Y" : "X");
}

const char *quantity_unit(const struct quantity *q, const struct problem *p) {
    if (q->kind == QUANTITY_AT) return "K";
    if (q->kind == QUANTITY_HEAT) return p->dim == 1 ? "J/m^2" : "J/m";
    return p->dim == 1 ? "W/m^2" : "W/m";
}

/* Data of the integrands. */
struct field_at {
    struct snapshot now;
    enum side side;
};

static const struct material *material_at(const struct problem *p, const double x[2]) {
    return &p->material[p->materials == 2 && x[0] >= p->interface];
}

static struct approx heat_density(const void *data, const double x[2]) {
    const struct field_at *f = data;
    struct exact e = snapshot_at(&f->now, x);
    double rho_c = material_at(f->now.problem, x)->rho_c;
    return (struct approx){rho_c * e.temperature, rho_c * e.error_bound};
}

/* k dT/dn on the side f->side. along[0] is the coordinate along the side; on a round wall it is the angle. */
static struct approx flux_density(const void *data, const double along[2]) {
    const struct field_at *f = data;
    const struct problem *p = f->now.problem;
    int s = (int)f->side, a = p->shape ? 0 : s / 2;
    double x[2] = {along[0], p->dim == 2 ? along[0] : 0}, u[2] = {cos(along[0]), sin(along[0])};
    if (p->shape)
        x[0] = p->radius[s] * u[0], x[1] = p->radius[s] * u[1];
    else
        x[a] = s % 2 ? p->hi[a] : p->lo[a];
    double wall = p->wall(p, f->side, x, f->now.time), b = p->robin[s];
    if (p->side[s] == NEUMANN) return (struct approx){wall, 0};
    struct exact e = snapshot_at(&f->now, x);
    if (p->side[s] == ROBIN) return (struct approx){b * (wall - e.temperature), b * e.error_bound};
    double k = kirchhoff_along(p, material_at(p, x), a, e.temperature);
    double slope = p->shape ? u[0] * e.gradient[0] + u[1] * e.gradient[1] : e.gradient[a];
    double bound = p->shape ? e.gradient_bound[0] + e.gradient_bound[1] : e.gradient_bound[a];
    return (struct approx){s % 2 ? k * slope : -k * slope, k * bound};
}

/* Knots of an axis: ends, jumps, interface, and on a rod the middle, the place of its pulse.  Initial data in the
 * plane have no pulse. */
static void add_knots(const struct problem *p, int axis, int place, struct cubature_knots *knots) {
    double at[CUBATURE_KNOTS] = {p->lo[axis], p->hi[axis]};
    int n = 2;
    if (p->dim == 1) at[n++] = (p->lo[axis] + p->hi[axis]) / 2;
    for (int j = 0; j < p->jumps[axis]; j++) at[n++] = p->jump[axis][j];
    if (axis == 0 && p->materials == 2) at[n++] = p->interface;
    for (int i = 0; i < n; i++) {
        knots->knot[place][i].at = at[i];
        knots->knot[place][i].graded = 1;
    }
    knots->count[place] = n;
}

/* In two dimensions no feature is narrower than the diffusion length at t > 0. */
static int grades_for(const struct problem *p, double t) {
    double kappa = INFINITY, extent = 0;
    for (int a = 0; a < p->dim; a++) {
        for (int m = 0; m < p->materials; m++) kappa = fmin(kappa, p->material[m].k[a] / p->material[m].rho_c);
        extent = fmax(extent, p->hi[a] - p->lo[a]);
    }
    return p->dim == 2 && t > 0 ? 1 + (int)fmax(0, ceil(log2(extent / sqrt(4 * kappa * t)) / 2)) : 0;
}

/* Integrand over a round body, at = (r, theta): r times the density. */
static struct approx round_heat_density(const void *data, const double at[2]) {
    struct approx d = heat_density(data, (const double[2]){at[0] * cos(at[1]), at[0] * sin(at[1])});
    return (struct approx){at[0] * d.value, at[0] * d.error};
}

/* Integral over [lo, hi]; `size` is its length or area. */
static struct quantity_value integral(struct approx (*density)(const void *f, const double at[2]),
                                      const struct field_at *f, int dim, const double *lo, const double *hi,
                                      double size, const struct cubature_knots *knots) {
    struct approx mean = cubature_mean(density, f, dim, lo, hi, knots);
    return (struct quantity_value){size * mean.value, size * mean.error, 0};
}

static struct quantity_value heat(struct field_at *f) {
    const struct problem *p = f->now.problem;
    const double *R = p->radius, around[2] = {R[0], 0}, upto[2] = {R[1], 2 * M_PI};
    struct cubature_knots knots = {.count = {p->shape ? 2 : 0, 0}, .grades = grades_for(p, f->now.time)};
    double volume = 1;
    for (int s = 0; s < knots.count[0]; s++) knots.knot[0][s].at = R[s], knots.knot[0][s].graded = 1;
    if (p->shape) return integral(round_heat_density, f, 2, around, upto, (R[1] - R[0]) * 2 * M_PI, &knots);
    for (int a = 0; a < p->dim; a++) {
        volume *= p->hi[a] - p->lo[a];
        add_knots(p, a, a, &knots);
    }
    return integral(heat_density, f, p->dim, p->lo, p->hi, volume, &knots);
}

static struct quantity_value flux(struct field_at *f) {
    const struct problem *p = f->now.problem;
    struct cubature_knots knots = {.count = {0, 0}};
    double lo[2] = {0, 0}, hi[2] = {2 * M_PI, 0};
    if (p->shape) return integral(flux_density, f, 1, lo, hi, 2 * M_PI * p->radius[f->side], &knots);
    int axis = f->side < Y_LO;
    if (p->dim == 1) {
        struct approx end = flux_density(f, (double[2]){0, 0});
        return (struct quantity_value){end.value, end.error, 0};
    }
    for (int end = 0; end < 2 && p->side[f->side] == DIRICHLET; end++) {
        double corner[2];
        corner[1 - axis] = f->side % 2 ? p->hi[1 - axis] : p->lo[1 - axis];
        corner[axis] = end ? p->hi[axis] : p->lo[axis];
        if (snapshot_at(&f->now, corner).no_value) return (struct quantity_value){NAN, NAN, 1};
    }
    lo[0] = p->lo[axis], hi[0] = p->hi[axis];
    add_knots(p, axis, 0, &knots);
    return integral(flux_density, f, 1, lo, hi, hi[0] - lo[0], &knots);
}

struct quantity_value quantity_exact(const struct quantity *q, const struct scene *s, const struct problem *p,
                                     double t) {
    struct field_at f = {snapshot_take(s, p, t), q->side};
    struct quantity_value v;
    if (q->kind == QUANTITY_AT) {
        struct exact e = snapshot_at(&f.now, q->at);
        v = (struct quantity_value){e.temperature, e.error_bound, e.no_value};
    } else {
        v = q->kind == QUANTITY_HEAT ? heat(&f) : flux(&f);
    }
    snapshot_free(&f.now);
    return v;
}
