/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plan of a finite-difference run: refuses invalid options, places the points and counts the steps. */
#include "solver/differences/ftcs_plan.h"

#include "solver/differences/ftcs_grid.h"
#include "solver/differences/ftcs_loops.h"
#include "solver/differences/ftcs_matched.h"
#include "solver/method.h"
#include "solver/problem.h"

#include <math.h>
#include <stdio.h>

enum { SPACINGS_MIN = 4 };

/* 1 if every extent is a whole number of spacings dx, to a relative tolerance of 1e-6. */
static int divides(const struct problem *p, double dx) {
    for (int a = 0; a < p->dim; a++) {
        double count = (p->hi[a] - p->lo[a]) / dx;
        if (fabs(count - nearbyint(count)) > 1e-6 * count || nearbyint(count) < SPACINGS_MIN) return 0;
    }
    return 1;
}

static int check_spacing(const struct problem *p, double dx, struct failure *why) {
    enum { SEARCH = 100000 };
    const double most = 1e9;
    double extent[2] = {p->hi[0] - p->lo[0], p->hi[1] - p->lo[1]}, count = extent[0] / dx;
    double points = count * (p->dim == 2 ? extent[1] / dx : 1);
    if (!(dx > 0 && isfinite(dx))) return refuse(why, STATUS_INPUT, "--dx %g: must be positive and finite", dx);
    if (points > most) return refuse(why, STATUS_INPUT, "--dx %g: %.3g grid points, at most %g", dx, points, most);
    if (divides(p, dx)) return STATUS_OK;

    double below = floor(count), above = fmax(below + 1, SPACINGS_MIN);
    for (int i = 0; i < SEARCH && below >= SPACINGS_MIN && !divides(p, extent[0] / below); i++) below--;
    for (int i = 0; i < SEARCH && !divides(p, extent[0] / above); i++) above++;
    int coarser = divides(p, extent[0] / below), finer = divides(p, extent[0] / above);
    char domain[64] = "", near[80] = "none found";
    if (p->dim == 2) snprintf(domain, sizeof domain, " by %g m", extent[1]);
    if (coarser && finer)
        snprintf(near, sizeof near, "%.10g and %.10g", extent[0] / below, extent[0] / above);
    else if (coarser || finer)
        snprintf(near, sizeof near, "%.10g", extent[0] / (coarser ? below : above));
    return refuse(why, STATUS_INPUT,
                  "--dx %.10g: does not divide %g m%s into whole spacings, %d or more; nearest: %s", dx, extent[0],
                  domain, SPACINGS_MIN, near);
}

int ftcs_plan_check_times(const struct problem *p, const struct options *o, struct failure *why) {
    if (o->dt != 0 && !(o->dt > 0 && isfinite(o->dt)))
        return refuse(why, STATUS_INPUT, "--dt %g: must be positive and finite", o->dt);
    if (o->fourier != 0 && !(o->fourier > 0 && isfinite(o->fourier)))
        return refuse(why, STATUS_INPUT, "--fourier %g: must be positive and finite", o->fourier);
    if (o->dt != 0 && o->fourier != 0)
        return refuse(why, STATUS_INPUT, "--dt %g --fourier %g: give one of them", o->dt, o->fourier);
    if (!(p->t_end >= 0 && isfinite(p->t_end)))
        return refuse(why, STATUS_INPUT, "--t-end %g: must be finite and not negative", p->t_end);
    return STATUS_OK;
}

static int check_options(const struct ftcs_grid *g, const struct problem *p, const struct options *o,
                         struct failure *why) {
    if (p->materials > 1 && g->with_fluxes)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "%s: takes one material; this scene has %d, in contact at x = %g m; use ftcs", g->method,
                      p->materials, p->interface);
    if (p->materials > 1 && p->dim == 2 && (p->side[Y_LO] == ROBIN || p->side[Y_HI] == ROBIN))
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "%s: has no Robin wall across both materials; use a particle method, such as "
                      "contact_ssph",
                      g->method);
    if (p->materials > 1 && (o->sampling == SAMPLING_SPLINE || o->layout == LAYOUT_NODE))
        return refuse(why, STATUS_NOT_APPLICABLE, "--%s: takes one material; with two: %s",
                      o->layout == LAYOUT_NODE ? "layout node" : "sampling spline",
                      o->layout == LAYOUT_NODE ? "lattice" : "point or cell");
    if (p->materials > 1 && o->stepper == STEPPER_MATCHED)
        return refuse(why, STATUS_NOT_APPLICABLE, "--stepper matched: takes one material; valid here: euler, auto");
    for (int s = 0; s < 2 * p->dim; s++)
        if (p->side[s] == ROBIN && (o->layout == LAYOUT_NODE || o->stepper == STEPPER_MATCHED))
            return refuse(why, STATUS_NOT_APPLICABLE,
                          "%s: a Robin wall must be midway between a point and its ghost for second order; use %s",
                          o->layout == LAYOUT_NODE ? "--layout node" : "--stepper matched",
                          o->layout == LAYOUT_NODE ? "--layout lattice" : "--stepper euler");
    if (options_is_cloud(o))
        return refuse(why, STATUS_NOT_APPLICABLE, "--layout %s: %s needs a grid: lattice or node",
                      layout_words[o->layout], g->method);
    if (o->stepper == STEPPER_MATCHED && p->dim == 2)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "--stepper matched: in the plane the error of %s is not isotropic, and no step "
                      "cancels it; valid here: euler, auto",
                      g->method);
    if (o->stepper == STEPPER_MATCHED && p->source_rate)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "--stepper matched: a source that depends on time has its own error in Euler's steps, "
                      "which no step cancels; use --stepper euler");
    if (o->stepper == STEPPER_MATCHED && g->with_fluxes && p->source)
        return refuse(
            why, STATUS_NOT_APPLICABLE,
            "--stepper matched: %s annihilates (-1)^i, which a source excites at the walls at third order; use "
            "ftcs",
            g->method);
    if (o->stepper != STEPPER_AUTO && o->stepper != STEPPER_EULER && o->stepper != STEPPER_MATCHED)
        return refuse(why, STATUS_NOT_APPLICABLE, "--stepper %s: %s has euler, auto%s", stepper_words[o->stepper],
                      g->method, p->dim == 1 ? ", matched" : "");
    if (o->stepper == STEPPER_MATCHED && (o->dt != 0 || o->fourier != 0))
        return refuse(why, STATUS_INPUT, "--stepper matched: sets its own step; omit --dt and --fourier");
    if (ftcs_plan_check_times(p, o, why)) return why->status;
    if (p->side[X_LO] == PERIODIC && (o->layout == LAYOUT_NODE || o->walls != WALLS_MIRROR))
        return refuse(why, STATUS_NOT_APPLICABLE, "--%s: the scene is periodic and has no walls",
                      o->layout == LAYOUT_NODE ? "layout node" : "walls");
    if (o->walls > WALLS_FIXED)
        return refuse(why, STATUS_NOT_APPLICABLE, "--walls %s: is for particles; %s has mirror and fixed",
                      walls_words[o->walls], g->method);
    return check_spacing(p, o->dx, why);
}

/* Places the unknowns.  A node on a wall is an unknown on a Neumann side and is given on a Dirichlet side. */
static void lay_grid(struct ftcs_grid *g, const struct problem *p, const struct options *o) {
    int node = o->layout == LAYOUT_NODE;
    g->n[1] = 1;
    g->d[1] = 1;
    g->dim = p->dim;
    g->rho_c = p->material[0].rho_c;
    if (p->materials == 2) g->rho_c = fmin(g->rho_c, p->material[1].rho_c);
    for (int s = 0; s < 4; s++) g->end_cell[s] = node && s / 2 < p->dim && p->side[s] == NEUMANN ? 0.5 : 1;
    for (int a = 0; a < p->dim; a++) {
        double extent = p->hi[a] - p->lo[a], spacings = nearbyint(extent / o->dx);
        int given_lo = node && p->side[2 * a] == DIRICHLET, given_hi = node && p->side[2 * a + 1] == DIRICHLET;
        g->d[a] = extent / spacings;
        g->n[a] = (int)spacings + node - given_lo - given_hi;
        g->origin[a] = p->lo[a] + (node ? given_lo : 0.5) * g->d[a];
        for (int m = 0; m < p->materials; m++)
            g->kappa[a] = fmax(g->kappa[a], p->material[m].k[a] / p->material[m].rho_c);
    }
    g->stride = g->n[0] + 2 * FTCS_LAYERS;
    g->corner = FTCS_LAYERS + (p->dim == 2 ? FTCS_LAYERS * g->stride : 0);
    g->size = (size_t)(g->stride * (g->n[1] + (p->dim == 2 ? 2 * FTCS_LAYERS : 0)));
}

static int plan_steps(struct ftcs_grid *g, const struct problem *p, const struct options *o, struct failure *why) {
    double square = g->d[0] * g->d[0], kappa = fmax(g->kappa[0], g->kappa[1]), span = p->t_end, count;
    if (o->stepper == STEPPER_MATCHED) {
        /* Averaging with a B-spline of order m is equivalent to diffusion for the time m dx^2/(24 kappa).  Point
         * samples of a jump midway between two points are cell averages of data that are steeper by one order. */
        int m = o->sampling == SAMPLING_SPLINE ? 4 : o->sampling == SAMPLING_CELL ? 1 : 0;
        if (o->sampling == SAMPLING_POINT && ftcs_matched_points(g, p, &m, why)) return why->status;
        g->start = m * square / (24 * kappa);
        span -= g->start;
        if (!(span > 0))
            return refuse(why, STATUS_INPUT,
                          "--stepper matched: starts at %g s, after the end at %g s; use --dx below %g", g->start,
                          p->t_end, g->d[0] * sqrt(p->t_end / g->start));
        /* The matching step rarely fits a whole number of times.  The spatial error is cancelled by the sum of dt^2:
         * pairs of a longer and a shorter step reach it with any even count above the ideal one. */
        double ideal = span * kappa / square / (g->with_fluxes ? 2. / 3 : 1. / 6);
        count = 2 * ceil(ideal / 2 - 1e-9);
        g->alternation = sqrt(fmax(0, count / ideal - 1));
    } else {
        double dt = o->dt != 0 ? o->dt : (o->fourier != 0 ? o->fourier : 0.1) * square / kappa;
        count = span > 0 ? fmax(1, ceil(span / dt - 1e-9)) : 0;
    }
    if (!(count <= 1e12)) return refuse(why, STATUS_INPUT, "%s: %g time steps, at most 1e12", g->method, count);
    if (count * 8 * g->n[0] * g->n[1] > 9e18)
        return refuse(why, STATUS_INPUT, "%s: %g time steps of %g points, above the limit of 9e18 updates", g->method,
                      count, 1.0 * g->n[0] * g->n[1]);
    g->steps = (long long)count;
    g->dt = count > 0 ? span / count : 0;
    return STATUS_OK;
}

int ftcs_plan(struct ftcs_grid *g, const char *method, int with_fluxes, const struct problem *p,
              const struct options *o, struct failure *why) {
    *g = (struct ftcs_grid){.method = method, .with_fluxes = with_fluxes, .loops = ftcs_loops_of(o->lanes)};
    int status = check_options(g, p, o, why);
    if (status) return status;
    lay_grid(g, p, o);
    return plan_steps(g, p, o, why);
}
