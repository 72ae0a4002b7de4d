/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options, points and steps of the finite volumes; the matched run.
 *
 * The symbols along one axis, -(4/dx^2) sin^2(xi dx/2) and with fluxes -(1/dx^2) sin^2(xi dx), are both -xi^2 + A
 * dx^2 xi^4 + O(dx^4), with A = 1/12 and 1/3.  With a steady source Euler's error is
 *
 *     -(dt/2) T_tt = -(dt/2) (kappa^2 T_xxxx + kappa G_xx/rho_c).
 *
 * At kappa dt/dx^2 = 2A its first part cancels the spatial error A kappa dx^2 T_xxxx: the matched run on a rod, of
 * fourth order (with fluxes for smooth data only).  The source G + A dx^2 G_xx cancels the second part, and the
 * spatial error of the steady state.  In the plane and in space this would need an isotropic stencil. */
#include "solver/differences/ftcs.h"

#include "solver/status.h"

#include <math.h>
#include <stdio.h>

enum { SPACINGS_MIN = 4 };

/* ---- Options ---- */

/* Which options go together, as one table: a condition, the option with its value (none: the method), the reason and
 * the remedy. */
static int check_options(const char *method, int with_fluxes, const struct problem *p, const struct options *o,
                         struct failure *why) {
    const char *layout = layout_words[o->layout], *walls = walls_words[o->walls];
    const char *sampling = sampling_words[o->sampling], *stepper = stepper_words[o->stepper];
    const int round = p->shape != NULL, two = p->materials > 1, node = o->layout == LAYOUT_NODE;
    const int law = p->k_law != K_CONSTANT, matched = options_is_matched(o),
              periodic = !round && p->side[X_LO] == PERIODIC;
    const int staged = !round && (o->stepper == STEPPER_RK2 || o->stepper == STEPPER_RKL2);
    const int steps = matched || staged || o->stepper == STEPPER_AUTO || o->stepper == STEPPER_EULER;
    const int tensor = problem_has_cross(p), melts = p->k_law == K_PHASES;
    int open = 0; /* sides that are neither held nor periodic */
    for (int s = 0; s < 2 * p->dim; s++) open |= p->side[s] == NEUMANN || p->side[s] == ROBIN;
    int robin = 0;
    for (int s = 0; s < 2 * p->dim && !round; s++) robin |= p->side[s] == ROBIN;
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
        {two && with_fluxes, NULL, NULL, "takes one material, the scene has two; use ftcs"},
        {two && o->sampling == SAMPLING_SPLINE, "sampling", sampling, "takes one material; use point or cell"},
        {two && node, "layout", layout, "takes one material; use lattice"},
        {p->resistance > 0 && (o->mean == MEAN_HARMONIC || o->mean == MEAN_ARITHMETIC), "mean",
         o->mean == MEAN_HARMONIC ? "harmonic" : "arithmetic", "has no place for a contact resistance; use series"},
        {two && matched, "stepper", stepper, "takes one material; use euler"},
        {!law && problem_nonlinearity(p), NULL, NULL,
         "a wall whose flux is not linear in T needs k(T) here; use so_ssph"},
        {law && with_fluxes, NULL, NULL, "takes one k, the scene has k(T); use ftcs"},
        {law && node, "layout", layout, "k(T) is for the points of cells; use lattice"},
        {law && o->walls != WALLS_MIRROR, "walls", walls,
         "walls are faces of cells where k depends on T; use mirror"},
        {law && matched, "stepper", stepper, "k depends on T, and so does the error that a step cancels; use euler"},
        {law && o->sampling == SAMPLING_SPLINE, "sampling", sampling, "takes one k; use point or cell"},
        {law && o->mean == MEAN_SERIES, "mean", "series",
         "is for two materials; use harmonic, arithmetic or kirchhoff"},
        {melts && o->mean != MEAN_KIRCHHOFF && o->mean != MEAN_AUTO, "mean", mean_words[o->mean],
         "a cell at the melting point has k = 0; use kirchhoff"},
        {melts && (staged || o->sampling != SAMPLING_POINT), NULL, NULL,
         "melts by steps of Euler's, which are monotone, from point values; use euler, point"},
        {melts && p->k_frozen, NULL, NULL, "k of the initial temperature has no phases"},
        {!law && o->mean == MEAN_KIRCHHOFF, "mean", "kirchhoff", "is for k(T); use harmonic, arithmetic or series"},
        {tensor && with_fluxes, NULL, NULL, "a diagonal conductivity only, the scene has k_xy; use ftcs or so_ssph"},
        {tensor && (round || two || law || p->source || p->source_at), NULL, NULL,
         "takes k_xy with one material in a box, without a source; use ftcs, so_ssph"},
        {tensor && (robin || (open && (p->dim == 3 || p->direction))), NULL, NULL,
         "takes k_xy between held or periodic sides, insulated ones in the plane beside a constant K"},
        {tensor && node, "layout", layout, "k_xy is for the points of cells; use lattice"},
        {tensor && o->walls != WALLS_MIRROR, "walls", walls, "k_xy needs mirror images beyond a wall; use mirror"},
        {tensor && matched, "stepper", stepper, "k_xy has an error of its own, which no step cancels; use euler"},
        {!tensor && o->cross, "cross", cross_words[o->cross], "k_xy is 0 in this scene; omit it"},
        {robin && node, "layout", layout, "a Robin wall is midway between a point and its ghost; use lattice"},
        {robin && matched, "stepper", stepper, "the ghosts of a Robin wall are of second order; use euler"},
        {periodic && node, "layout", layout, "the scene is periodic and has no walls; use lattice"},
        {periodic && o->walls != WALLS_MIRROR, "walls", walls, "the scene is periodic and has no walls; use mirror"},
        {options_is_cloud(o), "layout", layout, "finite differences need a grid; use lattice or node"},
        {o->walls > WALLS_FIXED, "walls", walls, "is for particles; use mirror or fixed"},
        {!steps, "stepper", stepper,
         "finite differences have euler, rk2, rkl2, auto and, on a rod, matched; use rkl2"},
        {matched && p->dim > 1, "stepper", stepper,
         p->dim == 2 ? "in the plane the error is not isotropic, and no step cancels it; use euler"
                     : "in space the error is not isotropic, and no step cancels it; use euler"},
        {matched && p->wall_rate, "stepper", stepper,
         "the start and the steps of this run are derived for steady walls; use euler"},
        {matched && (p->source_rate || p->source_at), "stepper", stepper,
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
    if (!(p->t_end >= 0 && isfinite(p->t_end)))
        return refuse(why, STATUS_INPUT, "--t-end %g: must be finite and not negative", p->t_end);
    return STATUS_OK;
}

/* ---- Points ---- */

/* 1 if every extent is a whole number of spacings dx, to a relative tolerance of 1e-6. */
static int divides(const struct problem *p, double dx) {
    for (int a = 0; a < p->dim; a++) {
        double count = (p->hi[a] - p->lo[a]) / dx;
        if (fabs(count - nearbyint(count)) > 1e-6 * count || nearbyint(count) < SPACINGS_MIN) return 0;
    }
    return 1;
}

static int check_count(double dx, double points, struct failure *why) {
    const double most = 1e9;
    if (points <= most) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--dx %g: %.3g grid points, at most %g", dx, points, most);
}

static int check_spacing(const struct problem *p, double dx, struct failure *why) {
    enum { SEARCH = 100000 };
    double extent = p->hi[0] - p->lo[0], count = extent / dx, points = 1;
    for (int a = 0; a < p->dim; a++) points *= (p->hi[a] - p->lo[a]) / dx;
    if (check_count(dx, points, why)) return why->status;
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

static int check_rings(const struct problem *p, double dx, struct failure *why) {
    double width = p->radius[1] - p->radius[0], rings = width / dx, half = M_PI * p->radius[1] / dx;
    if (check_count(dx, rings * 2 * half * (p->dim == 3 ? half : 1), why)) return why->status;
    if (fabs(rings - nearbyint(rings)) <= 1e-6 * rings && nearbyint(rings) >= SPACINGS_MIN) return STATUS_OK;
    double below = fmax(floor(rings), SPACINGS_MIN);
    return refuse(why, STATUS_INPUT,
                  "--dx %.10g: does not divide the %g m from %s into whole rings, %d or more; nearest: %.10g and "
                  "%.10g",
                  dx, width, p->radius[0] > 0 ? "wall to wall" : "the middle to the wall", SPACINGS_MIN,
                  width / below, width / (below + 1));
}

/* Rings, bands and rays; a disc has one band, about the equator. */
static void lay_rings(struct ftcs_grid *g) {
    const struct problem *p = g->p;
    const double radius = p->radius[1], width = radius - p->radius[0];
    g->n[0] = (int)nearbyint(width / g->o->dx);
    g->d[0] = width / g->n[0];
    g->n[1] = p->dim == 3 ? (int)ceil(M_PI * radius / g->d[0]) : 1;
    g->d[1] = M_PI / g->n[1];
    g->n[2] = (int)ceil(2 * M_PI * radius / g->d[0]);
    g->d[2] = 2 * M_PI / g->n[2];
    for (int a = 0; a < DIM_MAX; a++) g->first[a] = (a ? 0 : p->radius[0]) + 0.5 * g->d[a];
}

/* Places the unknowns.  A node on a wall is an unknown on a Neumann side and is given on a Dirichlet side. */
static void lay_box(struct ftcs_grid *g) {
    const struct problem *p = g->p;
    const int node = g->o->layout == LAYOUT_NODE;
    for (int a = 0; a < DIM_MAX; a++) g->n[a] = 1, g->d[a] = 1;
    for (int s = 0; s < SIDES; s++) g->end_cell[s] = node && s / 2 < p->dim && p->side[s] == NEUMANN ? 0.5 : 1;
    for (int a = 0; a < p->dim; a++) {
        double extent = p->hi[a] - p->lo[a], spacings = nearbyint(extent / g->o->dx);
        int given_lo = node && p->side[2 * a] == DIRICHLET, given_hi = node && p->side[2 * a + 1] == DIRICHLET;
        g->d[a] = extent / spacings;
        g->n[a] = (int)spacings + node - given_lo - given_hi;
        g->first[a] = p->lo[a] + (node ? given_lo : 0.5) * g->d[a];
    }
}

static void lay_grid(struct ftcs_grid *g) {
    const struct problem *p = g->p;
    g->rho_c = p->materials == 2 ? fmin(p->material[0].rho_c, p->material[1].rho_c) : p->material[0].rho_c;
    for (int a = 0; a < p->dim; a++)
        for (int m = 0; m < p->materials; m++)
            g->kappa[a] = fmax(g->kappa[a], p->material[m].k[a] / p->material[m].rho_c);
    if (g->round)
        lay_rings(g);
    else
        lay_box(g);
    ptrdiff_t size = 1;
    for (int a = 0; a < DIM_MAX; a++) {
        int ghosts = a < (g->round ? 1 : p->dim) ? g->reach : 0;
        g->stride[a] = size;
        g->corner += ghosts * size;
        size *= g->n[a] + 2 * ghosts;
    }
    g->size = (size_t)size;
}

/* ---- Steps ---- */

/* Sets *m to -1 for point samples of data that are constant between jumps midway between two points, to 0 for smooth
 * data; else refuses.  A Dirichlet value that differs from the data is a jump at the wall. */
static int matched_points(const struct ftcs_grid *g, int *m, struct failure *why) {
    const struct problem *p = g->p;
    double size = 0, jump[JUMP_MAX + 2];
    int jumps = 0, slopes = 0;
    for (int i = 0; i < g->n[0]; i++)
        size = fmax(size, fabs(p->initial(p, (double[2]){g->first[0] + i * g->d[0], 0})));
    for (int k = 0; k < p->jumps[0]; k++)
        if (p->jump[0][k] > p->lo[0] && p->jump[0][k] < p->hi[0]) jump[jumps++] = p->jump[0][k];
    for (int s = X_LO; s <= X_HI; s++) {
        double foot[2] = {s == X_HI ? p->hi[0] : p->lo[0], 0},
               apart = p->initial(p, foot) - p->wall(p, (enum side)s, foot, 0);
        if (p->side[s] == DIRICHLET && fabs(apart) > 1e-9 * fmax(size, fabs(apart))) jump[jumps++] = foot[0];
    }
    for (int k = 0; k < jumps; k++) {
        double cells = (jump[k] - g->first[0]) / g->d[0] + 0.5;
        if (fabs(cells - nearbyint(cells)) > 1e-6)
            return refuse(why, STATUS_NOT_APPLICABLE,
                          "--stepper matched: the initial data jump at x = %g m, not midway between two points; use "
                          "--sampling spline",
                          jump[k]);
    }
    for (int i = 0; i + 1 < g->n[0]; i++) {
        double x = g->first[0] + i * g->d[0], next = x + g->d[0];
        int across = 0;
        for (int k = 0; k < jumps; k++) across |= x < jump[k] && jump[k] < next;
        slopes |= !across && p->initial(p, (double[2]){x, 0}) != p->initial(p, (double[2]){next, 0});
    }
    if (jumps && slopes)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "--stepper matched: the initial data jump and vary between the jumps; use --sampling spline");
    *m = jumps ? -1 : 0;
    return STATUS_OK;
}

/* The length and number of the steps of a matched run.  Averaging with a B-spline of order m is equivalent to
 * diffusion for the time m dx^2/(24 kappa).  Point samples of a jump midway between two points are cell averages of
 * data that are steeper by one order.  The matching step rarely fits a whole number of times.  The spatial error is
 * cancelled by the sum of dt^2: pairs of a longer and a shorter step reach it with any even count above the ideal
 * one. */
static int plan_matched(struct ftcs_grid *g, double *count, struct failure *why) {
    const enum sampling sampling = g->o->sampling;
    const double square = g->d[0] * g->d[0], kappa = g->kappa[0], t_end = g->p->t_end;
    int m = sampling == SAMPLING_SPLINE ? 4 : sampling == SAMPLING_CELL ? 1 : 0;
    if (sampling == SAMPLING_POINT && matched_points(g, &m, why)) return why->status;
    g->start = m * square / (24 * kappa);
    if (!(t_end - g->start > 0))
        return refuse(why, STATUS_INPUT,
                      "--stepper matched: starts at %g s, after the end at %g s; use --dx below %g", g->start, t_end,
                      g->d[0] * sqrt(t_end / g->start));
    double ideal = (t_end - g->start) * kappa / square / (g->reach == 2 ? 2. / 3 : 1. / 6);
    *count = 2 * ceil(ideal / 2 - 1e-9);
    g->alternation = sqrt(fmax(0, *count / ideal - 1));
    return STATUS_OK;
}

static int plan_steps(struct ftcs_grid *g, struct failure *why) {
    const struct options *o = g->o;
    double cells = (double)g->n[0] * g->n[1] * g->n[2], kappa = fmax(fmax(g->kappa[0], g->kappa[1]), g->kappa[2]);
    double count = 0, dt = o->dt != 0 ? o->dt : (o->fourier != 0 ? o->fourier : 0.1) * g->d[0] * g->d[0] / kappa;
    if (options_is_matched(o)) {
        if (plan_matched(g, &count, why)) return why->status;
    } else {
        double radius = 0;
        for (int a = 0; a < g->p->dim; a++) radius += 4 * kappa / (g->d[a] * g->d[a]);
        if (o->stepper == STEPPER_RKL2 && o->dt == 0 && o->fourier == 0) dt = sqrt(g->p->t_end / radius);
        count = g->p->t_end > 0 ? fmax(1, ceil(g->p->t_end / dt - 1e-9)) : 0;
    }
    if (!(count <= 1e12)) return refuse(why, STATUS_INPUT, "%s: %g time steps, at most 1e12", g->method, count);
    if (count * 8 * cells > 9e18)
        return refuse(why, STATUS_INPUT, "%s: %g time steps of %g points, above the limit of 9e18 updates", g->method,
                      count, cells);
    g->steps = (long long)count;
    g->dt = count > 0 ? (g->p->t_end - g->start) / count : 0;
    g->stages = o->stepper == STEPPER_RK2 ? 2 : 1;
    return STATUS_OK;
}

int ftcs_plan(struct ftcs_grid *g, const char *method, int fluxes, const struct problem *p, const struct options *o,
              struct failure *why) {
    *g = (struct ftcs_grid){.p = p,
                            .o = o,
                            .method = method,
                            .round = p->shape != NULL,
                            .reach = fluxes ? 2 : 1,
                            .width = (o->lanes > 0 ? o->lanes : options_lanes_most()) / 4,
                            .changes = problem_changes(p) || p->source_at};
    if (check_options(method, fluxes, p, o, why)) return why->status;
    if (g->round ? check_rings(p, o->dx, why) : check_spacing(p, o->dx, why)) return why->status;
    lay_grid(g);
    if (plan_steps(g, why)) return why->status;
    for (int a = 0; a < p->dim && p->k_law; a++) g->kappa[a] = 1 / g->rho_c; /* for theta */
    return STATUS_OK;
}
