/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls of the finite volumes.  A wall is a face to a ghost, whose temperature gives the flux of the wall through the
 * conductance of that face.  At the distance d from the wall
 *
 *   Dirichlet  T_ghost = 2 T_wall - T_mirror + d^2 T_nn, or T_wall (`fixed`, Pamplona 2019; first order)
 *   Neumann    T_ghost = T_mirror + 2 d (k dT/dn) / k + d^3/3 T_nnn
 *   Robin      T_ghost = T_mirror + 2 d b (T_a - T_mirror) / (k + b d): 1/b and d/k in series (second order)
 *
 * On the wall k_n T_nn + sum k_t T_tt + G = rho_c T_t over the tangential axes t, with the normal derivative k_n
 * T_nnn
 * + sum k_t T_ntt + G_n = rho_c T_nt.  T_tt, T_ntt and G_n follow from the boundary data and the source by central
 * differences over d, with errors of d^4 and d^5, and the right-hand sides from the rate of change of the data.
 * Round walls have neither term.  Each ghost is a multiple of one unknown plus a constant, so the steps need no cases
 * for the kind of a side.  With k(T) the ghost is T_mirror + 2 d q / k, q the flux of the wall (ftcs_face.c).
 *
 * Data that change are those at the start of a step of Euler's, T + dt (A T + g(t)), with A T + g(t) the differences
 * of the state at t, so only -(dt/2) T_tt remains: first order in dt, and exact where T is linear in t.  Data at the
 * end of the step would add dt g'(t), of the same order.  Stages of other steps have the data of their times. */
#include "solver/differences/ftcs.h"

#include "solver/status.h"

#include <math.h>

/* The two other axes, the lower one first. */
static const int others[DIM_MAX][2] = {{1, 2}, {0, 2}, {0, 1}};

/* Conductivity, W m^-1 K^-1, along the axis in the cell at this place of the side. */
static double conducts(const struct ftcs_grid *g, enum side s, int place, int axis) {
    const struct problem *p = g->p;
    if (s == X_LO || s == X_HI) return p->material[s == X_HI ? p->materials - 1 : 0].k[axis];
    double x = g->first[0] + place % g->n[0] * g->d[0];
    return axis > 0 ? ftcs_face_k(p, g->o->mean, axis, g->d[0], x)
                    : p->material[p->materials == 2 && x >= p->interface].k[0];
}

/* Correction of a ghost at the distance d for boundary data that vary and change and for the source, times the
 * conductivity across the side, K W m^-1 K^-1.  value: the wall's at its foot. */
static double beyond(const struct ftcs_grid *g, enum side s, int place, const double *foot, double value, double t,
                     double d) {
    const struct problem *p = g->p;
    const int a = (int)s / 2, column = s == X_LO ? 0 : s == X_HI ? g->n[0] - 1 : place % g->n[0];
    double bend = 0, stored = 0, outwards = s % 2 ? d : -d;
    for (int b = 0; b < p->dim; b++) {
        double lo[DIM_MAX] = {foot[0], foot[1], foot[2]}, hi[DIM_MAX] = {foot[0], foot[1], foot[2]};
        lo[b] -= d, hi[b] += d;
        if (b != a) bend += conducts(g, s, place, b) * (p->wall(p, s, lo, t) - 2 * value + p->wall(p, s, hi, t));
    }
    if (p->wall_rate) {
        double rho_c = ftcs_face_rho_c(p, g->d[0], g->first[0] + column * g->d[0]);
        stored = d * d * rho_c * p->wall_rate(p, s, foot, t);
    }
    if (p->side[s] == DIRICHLET) return stored - bend - d * d * problem_source(p, foot, t);
    double in[DIM_MAX] = {foot[0], foot[1], foot[2]}, out[DIM_MAX] = {foot[0], foot[1], foot[2]};
    in[a] -= outwards, out[a] += outwards;
    return (stored - bend) / conducts(g, s, place, a) * d / 3 -
           d * d / 6 * (problem_source(p, out, t) - problem_source(p, in, t));
}

/* Ghost m mirrors unknown m + shift.  The wall is half a spacing outside the first unknown (shift 0), on it (1), or
 * on ghost 0 (-1). */
void ftcs_wall_make(struct ftcs_grid *g, enum side s) {
    const struct problem *p = g->p;
    const int a = (int)s / 2, given = p->side[s] == DIRICHLET;
    const int shift = g->o->layout == LAYOUT_NODE ? (given ? -1 : 1) : 0;
    struct ftcs_side *e = &g->side[s];
    for (int k = 0; k < 2; k++) e->n[k] = g->n[others[a][k]], e->step[k] = g->stride[others[a][k]];
    e->places = e->n[0] * e->n[1];
    const ptrdiff_t out = s % 2 ? g->stride[a] : -g->stride[a];
    const ptrdiff_t first = g->corner + (s % 2 ? (g->n[a] - 1) * g->stride[a] : 0);
    const size_t count = (size_t)g->reach * (size_t)e->places;
    g->held += 2 * count;
    e->sign = xcalloc(2 * count, sizeof *e->sign);
    e->offset = e->sign + count;
    for (int m = 0; m < g->reach; m++) {
        const int held = given && (g->o->walls == WALLS_FIXED || m + shift < 0);
        e->apart[m] = (2 * m + 1 + shift) * g->d[a];
        e->ghost[m] = first + (1 + m) * out;
        e->mirror[m] = first - (p->side[s] == PERIODIC ? g->n[a] - 1 - m : m + shift < 0 ? 0 : m + shift) * out;
        for (int place = 0; place < e->places; place++) {
            double sign = held ? 0 : given ? -1 : 1, k = conducts(g, s, place, a);
            if (p->side[s] == ROBIN) sign = 1 - 2 / (1 + 2 * k / (p->robin[s] * e->apart[m]));
            e->sign[m * e->places + place] = sign;
        }
    }
}

/* K, of ghost m at the foot x, where the wall has that value */
static double offset(const struct ftcs_grid *g, enum side s, int m, int place, const double *x, double value,
                     double t) {
    const struct ftcs_side *e = &g->side[s];
    const enum side_kind kind = g->p->side[s];
    const double sign = e->sign[m * e->places + place], k = conducts(g, s, place, (int)s / 2), apart = e->apart[m];
    if (kind == ROBIN || sign == 0) return (1 - sign) * value;
    double T = kind == DIRICHLET ? 2 * value : value / k * apart;
    return g->round || problem_has_cross(g->p) ? T : T + beyond(g, s, place, x, value, t, apart / 2) / k;
}

/* Also widens the range of the data and the possible effect of fluxes. */
void ftcs_wall_data(struct ftcs_grid *g, double t) {
    const struct problem *p = g->p;
    for (int s = 0; s < SIDES; s++) {
        const int a = s / 2, b = others[a][0], c = others[a][1];
        struct ftcs_side *e = &g->side[s];
        for (int place = 0; place < e->places && p->side[s] != PERIODIC; place++) {
            double u[DIM_MAX], x[DIM_MAX];
            u[a] = g->round ? p->radius[s] : s % 2 ? p->hi[a] : p->lo[a];
            u[b] = g->first[b] + place % g->n[b] * g->d[b];
            u[c] = g->first[c] + place / g->n[b] * g->d[c];
            ftcs_point(g, u, x);
            double value = p->wall(p, (enum side)s, x, t), extent = g->n[a] * g->d[a];
            for (int m = 0; m < g->reach; m++)
                e->offset[m * e->places + place] = p->k_law ? value : offset(g, (enum side)s, m, place, x, value, t);
            if (p->side[s] == NEUMANN)
                g->inflow = fmax(g->inflow, fabs(value) * (extent / conducts(g, (enum side)s, place, a) +
                                                           p->t_end / g->rho_c / extent));
            else
                g->data[0] = fmin(g->data[0], ftcs_face_state(p, value)),
                g->data[1] = fmax(g->data[1], ftcs_face_state(p, value));
        }
    }
}

/* Layer m beyond a side from its mirror image. */
static void reflect(const struct ftcs_side *e, int m, double *T) {
    const double *sign = e->sign + m * e->places, *offset = e->offset + m * e->places, *image = T + e->mirror[m];
    double *ghost = T + e->ghost[m];
    const ptrdiff_t n = e->n[0], step = e->step[0];
    for (int j = 0; j < e->n[1]; j++, sign += n, offset += n, image += e->step[1], ghost += e->step[1])
        for (ptrdiff_t i = 0; i < n; i++) ghost[i * step] = sign[i] * image[i * step] + offset[i];
}

/* With k(T): theta beyond the wall, or T behind a face of the largest k. */
static void reflect_law(const struct ftcs_grid *g, enum side s, double *T) {
    const struct ftcs_side *e = &g->side[s];
    const double d = g->d[s / 2], most = g->p->material[0].k[s / 2];
    for (int place = 0; place < e->places; place++) {
        const ptrdiff_t step = place % e->n[0] * e->step[0] + place / e->n[0] * e->step[1];
        const ptrdiff_t at = e->mirror[0] + step, ghost = e->ghost[0] + step;
        double moved = d * ftcs_face_wall(g, s, T[at], g->law[at], e->offset[place], d / 2);
        if (g->C[0])
            T[ghost] = T[at] + moved / most;
        else
            g->law[ghost] = g->law[at] + moved;
    }
}

void ftcs_wall_ghosts(struct ftcs_grid *g, double *T) {
    const int law = g->p->k_law != K_CONSTANT, sides = 2 * g->p->dim;
    double *of = law && !g->C[0] ? g->law : T;
    for (int s = 0; s < sides; s++) {
        const struct ftcs_side *e = &g->side[s];
        if (law && g->p->side[s] != PERIODIC)
            reflect_law(g, (enum side)s, T);
        else if (e->places == 1) /* a rod */
            for (int m = 0; m < g->reach; m++) of[e->ghost[m]] = e->sign[m] * of[e->mirror[m]] + e->offset[m];
        else
            for (int m = 0; m < g->reach && e->places; m++) reflect(e, m, of);
    }
}
