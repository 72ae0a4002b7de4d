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
static const char *const plane_flux[] = {"flux_x_lo", "flux_x_hi", "flux_y_lo",
                                         "flux_y_hi", "flux_z_lo", "flux_z_hi"};
static const char *const round_flux[] = {"flux_r_lo", "flux_r_hi"};
static const char *const front_names[FRONT_SECTORS] = {"front", "front_axes", "front_diagonals"};
/* By dimension. */
static const char *const point_form[] = {"", "X", "X,Y", "X,Y,Z"};
static const char *const point_like[] = {"", "at:0.1", "at:0.1,0.2", "at:0.1,0.2,0.3"};

static int read_place(const char *text, const struct problem *p, struct quantity *q, struct failure *why) {
    const char *at = text + strlen("at:");
    q->kind = QUANTITY_AT;
    for (int a = 0; a < p->dim; a++) {
        char *end;
        q->at[a] = strtod(at, &end);
        if (end == at || *end != (a + 1 < p->dim ? ',' : '\0') || !isfinite(q->at[a]))
            return refuse(why, STATUS_INPUT, "quantity '%.60s': at: needs %s, such as %s", text,
                          p->dim > 1 ? point_form[p->dim] : "one number", point_like[p->dim]);
        if (q->at[a] < p->lo[a] || q->at[a] > p->hi[a])
            return refuse(why, STATUS_INPUT, "quantity '%.60s': %c = %g m is outside %g to %g m", text, "xyz"[a],
                          q -> at[a], p -> lo[a], p -> hi[a]);
        at = end + 1;
    }
    if (p->shape && shape_depth(p, q->at) < 0)
        return refuse(why, STATUS_INPUT, "quantity '%.60s': outside the %s", text, p->shape->name);
    return STATUS_OK;
}

/* Number of front_names that *p has: one of phases or of k = k_0 T^n on a rod, with sectors in the plane and in
 * space. */
static int fronts(const struct problem *p) {
    if (p->k_law == K_POWER && (p->kinked[0] || p->breaks_on_curves)) return p->dim == 1 ? 1 : FRONT_SECTORS;
    return p->k_law == K_PHASES;
}

int quantity_read(const char *text, const struct problem *p, struct quantity *q, struct failure *why) {
    const char *const *flux = p->shape ? round_flux : plane_flux;
    *q = (struct quantity){.kind = QUANTITY_HEAT};
    if (strncmp(text, "at:", 3) == 0) return read_place(text, p, q, why);
    for (int at = 0; at < fronts(p); at++) {
        if (strcmp(text, front_names[at]) != 0) continue;
        *q = (struct quantity){.kind = QUANTITY_FRONT, .sector = (enum front_sector)at};
        return STATUS_OK;
    }
    if (strcmp(text, "heat") == 0 && p->k_law == K_PHASES)
        return refuse(why, STATUS_INPUT, "quantity 'heat': phases have latent heat too; use front, at:X or a flux");
    if (strcmp(text, "heat") == 0) return STATUS_OK;
    for (int s = 0; s < 2 * p->dim; s++) {
        if (!shape_has_wall(p, s) || strcmp(text, flux[s]) != 0) continue;
        *q = (struct quantity){.kind = QUANTITY_FLUX, .side = (enum side)s};
        return STATUS_OK;
    }
    char valid[200] = "";
    for (int s = 0; s < 2 * p->dim; s++)
        if (shape_has_wall(p, s)) strcat(strcat(valid, flux[s]), ", ");
    for (int at = 0; at < fronts(p); at++) strcat(strcat(valid, front_names[at]), ", ");
    return refuse(why, STATUS_INPUT, "unknown quantity '%.60s' (valid: %sheat, at:%s)", text, valid,
                  point_form[p->dim]);
}

const char *quantity_unit(const struct quantity *q, const struct problem *p) {
    if (q->kind == QUANTITY_AT) return "K";
    if (q->kind == QUANTITY_FRONT) return "m";
    if (q->kind == QUANTITY_HEAT) return p->dim == 1 ? "J/m^2" : p->dim == 2 ? "J/m" : "J";
    return p->dim == 1 ? "W/m^2" : p->dim == 2 ? "W/m" : "W";
}

/* Data of the integrands. */
struct field_at {
    struct snapshot now;
    enum side side;
};

static const struct material *material_at(const struct problem *p, const double *x) {
    return &p->material[p->materials == 2 && x[0] >= p->interface];
}

static struct approx heat_density(const void *data, const double *x) {
    const struct field_at *f = data;
    struct exact e = snapshot_at(&f->now, x);
    double rho_c = material_at(f->now.problem, x)->rho_c;
    return (struct approx){rho_c * e.temperature, rho_c * e.error_bound};
}

/* The point of a round body at distance r from 0, at the angle (a disc) or at longitude and colatitude (a ball).
 * Returns the measure of the unit circle or sphere per angle. */
static double place_round(const struct problem *p, double r, const double *angle, double x[DIM_MAX]) {
    double across = p->dim == 3 ? sin(angle[1]) : 1;
    x[0] = r * across * cos(angle[0]), x[1] = r * across * sin(angle[0]);
    x[2] = p->dim == 3 ? r * cos(angle[1]) : 0;
    return across;
}

/* k dT/dn on the side f->side, per coordinate along the side; on a round wall per angle and radius^(dim-1). */
static struct approx flux_density(const void *data, const double *along) {
    const struct field_at *f = data;
    const struct problem *p = f->now.problem;
    int s = (int)f->side, a = p->shape ? 0 : s / 2;
    double x[DIM_MAX] = {0}, per = 1, slope = 0, bound = 0;
    for (int d = 0, n = 0; d < p->dim; d++) x[d] = d == a ? (s % 2 ? p->hi[a] : p->lo[a]) : along[n++];
    if (p->shape) per = place_round(p, p->radius[s], along, x);
    const struct wall_law *law = problem_law(p, s);
    double wall = p->wall(p, f->side, x, f->now.time), b;
    if (law->is_flux) return (struct approx){per * wall, 0};
    struct exact e = snapshot_at(&f->now, x);
    if (law->exchange) {
        const double q = law->exchange(p, f->side, 1, wall, e.temperature, &b), rounding = fabs(b) * e.error_bound;
        return (struct approx){per * q, rounding};
    }
    double k = kirchhoff_along(p, material_at(p, x), a, e.temperature), K[DIM_MAX][DIM_MAX];
    problem_tensor(p, x, K);
    if (p->direction) k = K[a][a]; /* T is uniform along such a side */
    for (int d = 0; d < p->dim; d++) {
        if (!p->shape && d != a) continue;
        slope += p->shape ? x[d] / p->radius[s] * e.gradient[d] : e.gradient[d];
        bound += e.gradient_bound[d];
    }
    return (struct approx){per * (s % 2 ? k * slope : -k * slope), k * bound};
}

/* Knots of an axis: ends, jumps, interface, and on a rod the middle, the place of its pulse.  Initial data in the
 * plane and in space have no pulse.  In space only jumps are graded: there the data of walls agree with the start. */
static void add_knots(const struct problem *p, int axis, int place, struct cubature_knots *knots) {
    double at[CUBATURE_KNOTS] = {p->lo[axis], p->hi[axis]};
    int n = 2;
    if (p->dim == 1) at[n++] = (p->lo[axis] + p->hi[axis]) / 2;
    for (int j = 0; j < p->jumps[axis]; j++) at[n++] = p->jump[axis][j];
    if (axis == 0 && p->materials == 2) at[n++] = p->interface;
    for (int i = 0; i < n; i++) {
        knots->knot[place][i].at = at[i];
        int jump = i >= 2 && i < 2 + p->jumps[axis];
        knots->knot[place][i].graded = p->dim < 3 || (jump && knots->grades > 0);
    }
    knots->count[place] = n;
}

/* In a plane or in space no feature is narrower than the diffusion length s at t > 0.  In space boxes start with 16
 * s: their rule of 6 points has a point at half s from the ends. */
static int grades_for(const struct problem *p, double t) {
    double kappa = INFINITY, extent = 0;
    for (int a = 0; a < p->dim; a++) {
        for (int m = 0; m < p->materials; m++) kappa = fmin(kappa, p->material[m].k[a] / p->material[m].rho_c);
        extent = fmax(extent, p->hi[a] - p->lo[a]);
    }
    int finest = (int)fmax(0, ceil(log2(extent / sqrt(4 * kappa * t)) / 2));
    return p->dim == 1 || !(t > 0) ? 0 : p->dim == 2 ? 1 + finest : finest > 2 ? finest - 2 : 0;
}

/* Integrand over a round body, at = (r, angles): the density times r^(dim-1). */
static struct approx round_heat_density(const void *data, const double *at) {
    const struct field_at *f = data;
    double x[DIM_MAX], per = at[0] * place_round(f->now.problem, at[0], at + 1, x);
    if (f->now.problem->dim == 3) per *= at[0];
    struct approx d = heat_density(data, x);
    return (struct approx){per * d.value, per * d.error};
}

/* Integral over [lo, hi] of dim axes. */
static struct quantity_value integral(struct approx (*density)(const void *f, const double *at),
                                      const struct field_at *f, int dim, const double *lo, const double *hi,
                                      double size, const struct cubature_knots *knots) {
    struct approx mean = cubature_mean(density, f, dim, lo, hi, knots);
    return (struct quantity_value){size * mean.value, size * mean.error, 0};
}

static struct quantity_value heat(struct field_at *f) {
    const struct problem *p = f->now.problem;
    const double *R = p->radius, around[] = {R[0], 0, 0}, upto[] = {R[1], 2 * M_PI, M_PI};
    struct cubature_knots knots = {
        .accuracy = p->dim == 3 ? 1e-10 : 0, .count = {p->shape ? 2 : 0, 0}, .grades = grades_for(p, f->now.time)};
    double volume = 1, angles = p->dim == 3 ? 2 * M_PI * M_PI : 2 * M_PI;
    for (int s = 0; s < knots.count[0]; s++)
        knots.knot[0][s].at = R[s], knots.knot[0][s].graded = p->dim < 3 || (s == 1 && knots.grades > 0);
    if (p->shape) return integral(round_heat_density, f, p->dim, around, upto, (R[1] - R[0]) * angles, &knots);
    for (int a = 0; a < p->dim; a++) {
        volume *= p->hi[a] - p->lo[a];
        add_knots(p, a, a, &knots);
    }
    return integral(heat_density, f, p->dim, p->lo, p->hi, volume, &knots);
}

/* 1 if the side and one next to it, each at its temperature, disagree: at a corner, or in the middle of an edge. */
static int disagrees(const struct field_at *f, int axis) {
    const struct problem *p = f->now.problem;
    for (int end = 0; end < 2 * p->dim && p->side[f->side] == DIRICHLET; end++) {
        double x[DIM_MAX];
        if (end / 2 == axis) continue;
        for (int d = 0; d < p->dim; d++) x[d] = (p->lo[d] + p->hi[d]) / 2;
        x[axis] = f->side % 2 ? p->hi[axis] : p->lo[axis];
        x[end / 2] = end % 2 ? p->hi[end / 2] : p->lo[end / 2];
        if (snapshot_at(&f->now, x).no_value) return 1;
    }
    return 0;
}

static struct quantity_value flux(struct field_at *f) {
    const struct problem *p = f->now.problem;
    struct cubature_knots knots = {.grades = p->dim == 3 ? grades_for(p, f->now.time) : 0};
    double lo[2] = {0, 0}, hi[2] = {2 * M_PI, M_PI}, R = p->radius[f->side % 2], size = 1;
    if (p->shape)
        return integral(flux_density, f, p->dim - 1, lo, hi, p->dim == 3 ? 2 * M_PI * M_PI * R * R : 2 * M_PI * R,
                        &knots);
    int axis = (int)f->side / 2, n = 0;
    if (p->dim == 1) {
        struct approx end = flux_density(f, lo);
        return (struct quantity_value){end.value, end.error, 0};
    }
    if (disagrees(f, axis)) return (struct quantity_value){NAN, NAN, 1};
    for (int a = 0; a < p->dim; a++) {
        if (a == axis) continue;
        lo[n] = p->lo[a], hi[n] = p->hi[a];
        size *= hi[n] - lo[n];
        add_knots(p, a, n++, &knots);
    }
    return integral(flux_density, f, p->dim - 1, lo, hi, size, &knots);
}

/* By bisection along x: T is monotone between the ends of a rod that a wall melts, and behind a front of k_0 T^n. */
static struct quantity_value front(const struct field_at *f) {
    const struct problem *p = f->now.problem;
    double lo[DIM_MAX] = {p->lo[0]}, hi[DIM_MAX] = {p->hi[0]};
    const int hot = snapshot_at(&f->now, lo).temperature > p->k_ref;
    for (;;) {
        double middle[DIM_MAX] = {lo[0] + (hi[0] - lo[0]) / 2};
        if (middle[0] == lo[0] || middle[0] == hi[0]) break;
        ((snapshot_at(&f->now, middle).temperature > p->k_ref) == hot ? lo : hi)[0] = middle[0];
    }
    struct exact e = snapshot_at(&f->now, lo);
    return (struct quantity_value){lo[0], hi[0] - lo[0] + e.error_bound / fabs(e.gradient[0]), 0};
}

struct quantity_value quantity_exact(const struct quantity *q, const struct scene *s, const struct problem *p,
                                     double t) {
    struct field_at f = {snapshot_take(s, p, t), q->side};
    struct quantity_value v;
    if (q->kind == QUANTITY_AT) {
        struct exact e = snapshot_at(&f.now, q->at);
        v = (struct quantity_value){e.temperature, e.error_bound, e.no_value};
    } else {
        v = q->kind == QUANTITY_FRONT ? front(&f) : q->kind == QUANTITY_HEAT ? heat(&f) : flux(&f);
    }
    snapshot_free(&f.now);
    return v;
}
