/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options, points and steps of the finite differences. */
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
    double extent = p->hi[0] - p->lo[0], count = extent / dx, points = 1;
    for (int a = 0; a < p->dim; a++) points *= (p->hi[a] - p->lo[a]) / dx;
    if (!(dx > 0 && isfinite(dx))) return refuse(why, STATUS_INPUT, "--dx %g: must be positive and finite", dx);
    if (points > most) return refuse(why, STATUS_INPUT, "--dx %g: %.3g grid points, at most %g", dx, points, most);
    if (divides(p, dx)) return STATUS_OK;

    double below = floor(count), above = fmax(below + 1, SPACINGS_MIN);
    for (int i = 0; i < SEARCH && below >= SPACINGS_MIN && !divides(p, extent / below); i++) below--;
    for (int i = 0; i < SEARCH && !divides(p, extent / above); i++) above++;
    int coarser = divides(p, extent / below), finer = divides(p, extent / above);
    char domain[DIM_MAX][32] = {"", "", ""}, near[80] = "none found";
    for (int a = 1; a < p->dim; a++) snprintf(domain[a], sizeof domain[a], " by %g m", p->hi[a] - p->lo[a]);
    if (coarser && finer)
        snprintf(near, sizeof near, "%.10g and %.10g", extent / below, extent / above);
    else if (coarser || finer)
        snprintf(near, sizeof near, "%.10g", extent / (coarser ? below : above));
    return refuse(why, STATUS_INPUT,
                  "--dx %.10g: does not divide %g m%s%s into whole spacings, %d or more; nearest: %s", dx, extent,
                  domain[1], domain[2], SPACINGS_MIN, near);
}

static int check_times(const struct problem *p, const struct options *o, struct failure *why) {
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

/* Which options go together, as one table: a condition, the option with its value (none: the method), the reason and
 * the remedy. */
int ftcs_plan_check(const char *method, int with_fluxes, const struct problem *p, const struct options *o,
                    struct failure *why) {
    const char *layout = layout_words[o->layout], *walls = walls_words[o->walls];
    const char *sampling = sampling_words[o->sampling], *stepper = stepper_words[o->stepper];
    const int round = p->shape != NULL, two = p->materials > 1, node = o->layout == LAYOUT_NODE;
    const int law = p->k_law != K_CONSTANT, matched = options_is_matched(o),
              periodic = !round && p->side[X_LO] == PERIODIC;
    const int staged = law && (o->stepper == STEPPER_RK2 || o->stepper == STEPPER_RKL2);
    const int steps = matched || staged || o->stepper == STEPPER_AUTO || o->stepper == STEPPER_EULER;
    int robin = 0, robin_across = 0;
    for (int s = 0; s < 2 * p->dim && !round; s++) robin |= p->side[s] == ROBIN;
    for (int s = Y_LO; s < 2 * p->dim && !round; s++) robin_across |= p->side[s] == ROBIN;
    const struct {
        int refuses;
        const char *option, *value, *text;
    } table[] = {
        {round && with_fluxes, NULL, NULL, "needs a rod or a rectangle, this scene has a round body; use ftcs"},
        {round && o->layout != LAYOUT_LATTICE, "layout", layout, "a round body has rings and rays; omit it"},
        {round && o->sampling != SAMPLING_POINT, "sampling", sampling, "rings and rays take points; use point"},
        {round && o->walls != WALLS_MIRROR, "walls", walls, "is for particles; use mirror"},
        {round && (two || p->material[0].k[0] != p->material[0].k[1]), NULL, NULL,
         "takes one material with k_x = k_y in a round body"},
        {round && p->dim == 3 && p->material[0].k[0] != p->material[0].k[2], NULL, NULL,
         "takes one material with k_x = k_y = k_z in a ball"},
        {round && (matched || !steps), "stepper", stepper, "a round body has euler and auto; use euler"},
        {round && (p->wall_rate || p->source_rate), NULL, NULL,
         "needs steady walls and a steady source in a round body"},
        {!law && p->source_at, NULL, NULL, "needs a source that is steady or linear in time"},
        {two && with_fluxes, NULL, NULL, "takes one material, the scene has two; use ftcs"},
        {two && robin_across, NULL, NULL,
         "no Robin wall across both materials; use a particle method, such as contact_ssph"},
        {two && o->sampling == SAMPLING_SPLINE, "sampling", sampling, "takes one material; use point or cell"},
        {two && node, "layout", layout, "takes one material; use lattice"},
        {two && matched, "stepper", stepper, "takes one material; use euler"},
        {law && with_fluxes, NULL, NULL, "takes one k, the scene has k(T); use ftcs"},
        {law && node, "layout", layout, "k(T) is for the points of cells; use lattice"},
        {law && o->walls != WALLS_MIRROR, "walls", walls,
         "walls are faces of cells where k depends on T; use mirror"},
        {law && matched, "stepper", stepper, "k depends on T, and so does the error that a step cancels; use euler"},
        {law && o->sampling == SAMPLING_SPLINE, "sampling", sampling, "takes one k; use point or cell"},
        {law && o->mean == MEAN_SERIES, "mean", "series",
         "is for two materials; use harmonic, arithmetic or kirchhoff"},
        {!law && o->mean == MEAN_KIRCHHOFF, "mean", "kirchhoff", "is for k(T); use harmonic, arithmetic or series"},
        {robin && node, "layout", layout, "a Robin wall is midway between a point and its ghost; use lattice"},
        {robin && matched, "stepper", stepper, "the ghosts of a Robin wall are of second order; use euler"},
        {periodic && node, "layout", layout, "the scene is periodic and has no walls; use lattice"},
        {periodic && o->walls != WALLS_MIRROR, "walls", walls, "the scene is periodic and has no walls; use mirror"},
        {options_is_cloud(o), "layout", layout, "finite differences need a grid; use lattice or node"},
        {o->walls > WALLS_FIXED, "walls", walls, "is for particles; use mirror or fixed"},
        {!steps && law, "stepper", stepper, "finite differences with k(T) have euler, rk2, rkl2 and auto; use rk2"},
        {!steps, "stepper", stepper, "finite differences have euler, auto and, on a rod, matched; use euler"},
        {matched && p->dim > 1, "stepper", stepper,
         p->dim == 2 ? "in the plane the error is not isotropic, and no step cancels it; use euler"
                     : "in space the error is not isotropic, and no step cancels it; use euler"},
        {matched && p->wall_rate, "stepper", stepper,
         "the start and the steps of this run are derived for steady walls; use euler"},
        {matched && p->source_rate, "stepper", stepper,
         "a source that depends on time has its own error in Euler's steps, which no step cancels; use euler"},
        {matched && with_fluxes && p->source, "stepper", stepper,
         "fluxes annihilate (-1)^i, which a source excites at the walls at third order; use ftcs"},
    };
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        if (table[k].refuses && !table[k].option)
            return refuse(why, STATUS_NOT_APPLICABLE, "%s: %s", method, table[k].text);
        if (table[k].refuses)
            return refuse(why, STATUS_NOT_APPLICABLE, "--%s %s: %s", table[k].option, table[k].value, table[k].text);
    }
    if (matched && (o->dt != 0 || o->fourier != 0))
        return refuse(why, STATUS_INPUT, "--stepper matched: sets its own step; omit --dt and --fourier");
    return check_times(p, o, why);
}

/* Places the unknowns.  A node on a wall is an unknown on a Neumann side and is given on a Dirichlet side. */
static void lay_grid(struct ftcs_grid *g, const struct problem *p, const struct options *o) {
    int node = o->layout == LAYOUT_NODE;
    for (int a = 0; a < DIM_MAX; a++) g->n[a] = 1, g->d[a] = 1;
    g->dim = p->dim;
    g->rho_c = p->material[0].rho_c;
    if (p->materials == 2) g->rho_c = fmin(g->rho_c, p->material[1].rho_c);
    for (int s = 0; s < SIDES; s++) g->end_cell[s] = node && s / 2 < p->dim && p->side[s] == NEUMANN ? 0.5 : 1;
    for (int a = 0; a < p->dim; a++) {
        double extent = p->hi[a] - p->lo[a], spacings = nearbyint(extent / o->dx);
        int given_lo = node && p->side[2 * a] == DIRICHLET, given_hi = node && p->side[2 * a + 1] == DIRICHLET;
        g->d[a] = extent / spacings;
        g->n[a] = (int)spacings + node - given_lo - given_hi;
        g->origin[a] = p->lo[a] + (node ? given_lo : 0.5) * g->d[a];
        for (int m = 0; m < p->materials; m++)
            g->kappa[a] = fmax(g->kappa[a], p->material[m].k[a] / p->material[m].rho_c);
    }
    ptrdiff_t size = 1;
    for (int a = 0; a < DIM_MAX; a++) {
        g->stride[a] = size;
        if (a >= p->dim) continue;
        g->corner += FTCS_LAYERS * size;
        size *= g->n[a] + 2 * FTCS_LAYERS;
    }
    g->size = (size_t)size;
}

static int plan_steps(struct ftcs_grid *g, const struct problem *p, const struct options *o, struct failure *why) {
    double square = g->d[0] * g->d[0], kappa = fmax(fmax(g->kappa[0], g->kappa[1]), g->kappa[2]);
    double span = p->t_end, points = (double)ftcs_grid_points(g), count;
    if (options_is_matched(o)) {
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
        double dt = o->dt != 0 ? o->dt : (o->fourier != 0 ? o->fourier : 0.1) * square / kappa, radius = 0;
        for (int a = 0; a < p->dim; a++) radius += 4 * kappa / (g->d[a] * g->d[a]);
        if (o->stepper == STEPPER_RKL2 && o->dt == 0 && o->fourier == 0) dt = sqrt(span / radius);
        count = span > 0 ? fmax(1, ceil(span / dt - 1e-9)) : 0;
    }
    if (!(count <= 1e12)) return refuse(why, STATUS_INPUT, "%s: %g time steps, at most 1e12", g->method, count);
    if (count * 8 * points > 9e18)
        return refuse(why, STATUS_INPUT, "%s: %g time steps of %g points, above the limit of 9e18 updates", g->method,
                      count, points);
    g->steps = (long long)count;
    g->dt = count > 0 ? span / count : 0;
    return STATUS_OK;
}

int ftcs_plan(struct ftcs_grid *g, const char *method, int with_fluxes, const struct problem *p,
              const struct options *o, struct failure *why) {
    *g = (struct ftcs_grid){.method = method, .with_fluxes = with_fluxes, .loops = ftcs_loops_of(o->lanes)};
    if (ftcs_plan_check(method, with_fluxes, p, o, why) || check_spacing(p, o->dx, why)) return why->status;
    lay_grid(g, p, o);
    return plan_steps(g, p, o, why);
}
