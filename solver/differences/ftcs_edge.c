/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ghosts of the finite differences,
 *
 *   Dirichlet  T_ghost = 2 T_wall - T_mirror + d^2 T_nn, or T_wall (`fixed`, Pamplona 2019; first order)
 *   Neumann    T_ghost = T_mirror + 2 d (k dT/dn) / k + d^3/3 T_nnn
 *   Robin      T_ghost = T_mirror + 2 d b (T_a - T_mirror) / (k + b d): k dT/dn = b (T_a - T) midway (second order)
 *
 * at the distance d from the wall.  On the wall k_n T_nn + sum k_t T_tt + G = rho_c T_t over the tangential axes t,
 * with the normal derivative k_n T_nnn + sum k_t T_ntt + G_n = rho_c T_nt.  T_tt, T_ntt and G_n follow from the
 * boundary data and the source by central differences over d, with errors of d^4 and d^5, and the right-hand sides
 * from the rate of change of the data.  Each ghost is a multiple of one unknown plus a constant, so the steps need no
 * cases for the kind of a side.
 *
 * Data that change are those at the start of a step.  Euler's step is T + dt (A T + g(t)) with A T + g(t) the
 * differences of the state at t, so only -(dt/2) T_tt remains: first order in dt, and exact where T is linear in t.
 * Data at the end of the step would add dt g'(t), of the same order. */
#include "solver/differences/ftcs_grid.h"

#include "solver/differences/ftcs_layers.h"
#include "solver/options.h"
#include "solver/problem.h"

#include <math.h>

/* Conductivity, W m^-1 K^-1, along the axis in the cell at this place of the side. */
static double conducts(const struct ftcs_grid *g, const struct problem *p, enum side s, int place, int axis) {
    if (s == X_LO || s == X_HI) return p->material[s == X_HI ? p->materials - 1 : 0].k[axis];
    double x = g->origin[0] + place % g->n[0] * g->d[0];
    return axis > 0 ? ftcs_layers_across(p, axis, g->d[0], x)
                    : p->material[p->materials == 2 && x >= p->interface].k[0];
}

/* Correction of a ghost at the distance d for boundary data that vary and change and for the source, times the
 * conductivity across the side, K W m^-1 K^-1.  value: the wall's at its foot. */
static double beyond(const struct ftcs_grid *g, const struct problem *p, enum side s, int place, const double *foot,
                     double value, double t, double d) {
    const int a = (int)s / 2, column = s == X_LO ? 0 : s == X_HI ? g->n[0] - 1 : place % g->n[0];
    double bend = 0, stored = 0, outwards = s % 2 ? d : -d;
    for (int b = 0; b < p->dim; b++) {
        double lo[DIM_MAX] = {foot[0], foot[1], foot[2]}, hi[DIM_MAX] = {foot[0], foot[1], foot[2]};
        lo[b] -= d, hi[b] += d;
        if (b != a) bend += conducts(g, p, s, place, b) * (p->wall(p, s, lo, t) - 2 * value + p->wall(p, s, hi, t));
    }
    if (p->wall_rate) {
        double rho_c = ftcs_layers_rho_c(p, g->d[0], g->origin[0] + column * g->d[0]);
        stored = d * d * rho_c * p->wall_rate(p, s, foot, t);
    }
    if (p->side[s] == DIRICHLET) return stored - bend - (p->source ? d * d * p->source(p, foot) : 0);
    double in[DIM_MAX] = {foot[0], foot[1], foot[2]}, out[DIM_MAX] = {foot[0], foot[1], foot[2]};
    in[a] -= outwards, out[a] += outwards;
    return (stored - bend) / conducts(g, p, s, place, a) * d / 3 -
           (p->source ? d * d / 6 * (p->source(p, out) - p->source(p, in)) : 0);
}

/* 2 b d / (k + b d) at the distance d = apart/2: 0 to 2 for any b. */
static double taken(double k, double b, double apart) {
    return 2 / (1 + k / (b * apart / 2));
}

/* Ghost m mirrors unknown m + shift.  The wall is half a spacing outside the first unknown (shift 0), on it (1), or
 * on ghost 0 (-1). */
void ftcs_edge_make(struct ftcs_grid *g, const struct problem *p, const struct options *o, enum side s) {
    const int a = (int)s / 2, given = p->side[s] == DIRICHLET;
    const int shift = o->layout == LAYOUT_NODE ? (given ? -1 : 1) : 0;
    struct ftcs_edge *e = &g->edge[s];
    e->places = (int)(ftcs_grid_points(g) / g->n[a]);
    g->held += FTCS_LAYERS * (size_t)e->places;
    e->offset = xcalloc(FTCS_LAYERS * (size_t)e->places, sizeof *e->offset);
    for (int m = 0; m < FTCS_LAYERS; m++) {
        int held = given && (o->walls == WALLS_FIXED || m + shift < 0);
        e->apart[m] = (2 * m + 1 + shift) * g->d[a];
        e->mirror[m] = m + shift < 0 ? 0 : m + shift;
        e->sign[m] = held ? 0 : given ? -1 : 1;
        if (p->side[s] == ROBIN) e->sign[m] = 1 - taken(conducts(g, p, s, 0, a), p->robin[s], e->apart[m]);
        if (p->side[s] == PERIODIC) e->mirror[m] = g->n[a] - 1 - m; /* at the opposite end; offsets stay 0 */
    }
}

/* Layers that the method reads. */
static int layers(const struct ftcs_grid *g) {
    return g->with_fluxes ? FTCS_LAYERS : 1;
}

/* K, of a ghost at the foot x, where the wall has that value */
static double offset(const struct ftcs_grid *g, const struct problem *p, enum side s, int m, int place,
                     const double *x, double value, double t) {
    const struct ftcs_edge *e = &g->edge[s];
    const double k = conducts(g, p, s, place, (int)s / 2), apart = e->apart[m];
    if (p->side[s] == ROBIN) return taken(conducts(g, p, s, 0, (int)s / 2), p->robin[s], apart) * value;
    if (e->sign[m] == 0) return value;
    return (p->side[s] == DIRICHLET ? 2 * value : value / k * apart) +
           beyond(g, p, s, place, x, value, t, apart / 2) / k;
}

void ftcs_edge_data(struct ftcs_grid *g, const struct problem *p, double t) {
    for (int s = 0; s < 2 * p->dim; s++) {
        const int a = s / 2, b = a == 0 ? 1 : 0, c = 3 - a - b;
        const double extent = p->hi[a] - p->lo[a];
        struct ftcs_edge *e = &g->edge[s];
        for (int place = 0; place < e->places && p->side[s] != PERIODIC; place++) {
            double x[DIM_MAX];
            x[a] = s % 2 ? p->hi[a] : p->lo[a];
            x[b] = g->origin[b] + place % g->n[b] * g->d[b];
            x[c] = g->origin[c] + place / g->n[b] * g->d[c]; /* 0 in the plane */
            double value = p->wall(p, (enum side)s, x, t), k = conducts(g, p, (enum side)s, place, a);
            for (int m = 0; m < layers(g); m++)
                e->offset[m * e->places + place] = offset(g, p, (enum side)s, m, place, x, value, t);
            if (p->side[s] == NEUMANN)
                g->inflow = fmax(g->inflow, fabs(value) * (extent / k + p->t_end / g->rho_c / extent));
            else
                g->data[0] = fmin(g->data[0], value), g->data[1] = fmax(g->data[1], value);
        }
    }
    g->middle = 0.5 * (g->data[0] + g->data[1]);
    g->reach = fmax(g->data[1] - g->data[0] + g->inflow, 1e-6 * fabs(g->middle));
}

/* T of one layer of ghosts from that of its mirror image */
static void reflect(ptrdiff_t n, double sign, const double *restrict T, const double *restrict more,
                    double *restrict ghost) {
    for (ptrdiff_t i = 0; i < n; i++) ghost[i] = sign * T[i] + more[i];
}

/* Ghosts at both ends of a row along x */
static inline void ends(const struct ftcs_grid *g, ptrdiff_t place, double *row) {
    const struct ftcs_edge *lo = &g->edge[X_LO], *hi = &g->edge[X_HI];
    const ptrdiff_t nx = g->n[0];
    for (int m = 0; m < layers(g); m++) {
        row[-1 - m] = lo->sign[m] * row[lo->mirror[m]] + lo->offset[m * lo->places + place];
        row[nx + m] = hi->sign[m] * row[nx - 1 - hi->mirror[m]] + hi->offset[m * hi->places + place];
    }
}

static void lateral_walls(const struct ftcs_grid *g) {
    const ptrdiff_t nx = g->n[0];
    for (int s = Y_LO; s < 2 * g->dim; s++) {
        const struct ftcs_edge *e = &g->edge[s];
        const int a = s / 2, b = 3 - a; /* rows along x, side by side along b */
        const ptrdiff_t inwards = s % 2 ? -g->stride[a] : g->stride[a];
        double *side = g->T + g->corner + (s % 2 ? (g->n[a] - 1) * g->stride[a] : 0);
        for (ptrdiff_t m = 0; m < layers(g); m++)
            for (ptrdiff_t j = 0; j < g->n[b]; j++) {
                double *T = side + j * g->stride[b];
                reflect(nx, e->sign[m], T + e->mirror[m] * inwards, e->offset + m * e->places + j * nx,
                        T - (1 + m) * inwards);
            }
    }
}

void ftcs_edge_walls(const struct ftcs_grid *g) {
    double *first = g->T + g->corner;
    if (g->dim == 1) {
        ends(g, 0, first);
        return;
    }
    for (ptrdiff_t place = 0, k = 0; k < g->n[2]; k++)
        for (int j = 0; j < g->n[1]; j++, place++) ends(g, place, first + j * g->stride[1] + k * g->stride[2]);
    lateral_walls(g);
}
