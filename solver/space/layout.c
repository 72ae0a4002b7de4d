/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lattices and ghosts.
 *
 * Cell-centred lattice: x_i = lo + (i + 1/2) dx (Song's tables), with walls midway between a particle and its mirror
 * image.  Node lattice: x_i = lo + i dx.  A node on a Dirichlet wall is known and not a particle; a node on a
 * Neumann wall is a particle.
 *
 * Ghosts at the distance d beyond a wall, with the outward normal n and the tangent t:
 *   fixed      T_g = T_wall (Pamplona Fig. 3, first order)
 *   Dirichlet  T_g = 2 T_wall - T_source + d^2 T_nn + O(d^4)
 *   Neumann    T_g = T_source + 2 d q / k_n + d^3/3 T_nnn + O(d^5)
 *   Robin      T_g = f T_source + (1 - f) T_a + O(d^3), f = (k_n - b d)/(k_n + b d): k_n dT/dn = b (T_a - T) midway
 * Sides and source are steady, so the equation gives k_n T_nn = -G - k_t T_tt on a Dirichlet wall, and its
 * derivative k_n T_nnn = -G_n - k_t (q/k_n)_tt on a Neumann wall.  Central differences of step d, D^2 f = f(t + d) -
 * 2 f(t) + f(t - d), keep these orders if their own error, O(d^2 k_t/k_n) of the term, is smaller than the term;
 * otherwise the term is omitted:
 *   d^2 T_nn = -(d^2 G + k_t D^2 T_wall) / k_n
 *   d^3/3 T_nnn = -(d^2/6 (G_g - G_source) + d/3 k_t D^2 q / k_n) / k_n
 * In a box k_t D^2 stands for the sum over both tangents.  At an edge or a corner the wall data and the source are
 * evaluated at the continuation of the wall. */
#include "solver/space/layout.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double PARTICLES_MAX = 4e9; /* column indices have 32 bits */

double layout_spacing(const struct problem *p, const struct options *o, int axis) {
    double ratio = options_is_matched(o) ? sqrt(p->material[0].k[axis] / p->material[0].k[0]) : 1;
    return o->dx * ratio;
}

/* 1 if n cells along x are whole numbers of cells along the other axes. */
static int divides_all(const struct problem *p, const struct options *o, double n) {
    for (int a = 1; a < p->dim; a++) {
        double other = (p->hi[a] - p->lo[a]) / (layout_spacing(p, o, a) / o->dx);
        double cells = other * n / (p->hi[0] - p->lo[0]);
        if (fabs(cells - round(cells)) > 1e-9 * cells || round(cells) < 1) return 0;
    }
    return 1;
}

/* The nearest spacings below and above that divide every extent; NaN if there is none. */
static void nearest_spacings(const struct problem *p, const struct options *o, double out[2]) {
    double extent = p->hi[0] - p->lo[0], near = fmax(1, floor(extent / o->dx));
    for (int up = 0; up < 2; up++) {
        double n = up ? near : near + 1;
        while (n >= 1 && n < 4 * near + 1000 && !divides_all(p, o, n)) n += up ? -1 : 1;
        out[up] = n >= 1 && n < 4 * near + 1000 ? extent / n : NAN;
    }
}

static const double CELLS_MAX = 1e8; /* per axis */

static int count_cells(const struct problem *p, int axis, double spacing, double *cells) {
    *cells = (p->hi[axis] - p->lo[axis]) / spacing;
    double whole = round(*cells);
    int divides = whole >= 1 && fabs(*cells - whole) <= 1e-6 * whole;
    *cells = whole;
    return divides;
}

static int refuse_spacing(const struct problem *p, const struct options *o, struct failure *why) {
    double near[2];
    nearest_spacings(p, o, near);
    if (isnan(near[0]) && p->dim == 3)
        return refuse(why, STATUS_INPUT,
                      "--dx %g: does not divide the domain; with dy = %.6g dx and dz = %.6g dx no "
                      "close value does",
                      o->dx, layout_spacing(p, o, 1) / o->dx, layout_spacing(p, o, 2) / o->dx);
    if (isnan(near[0]))
        return refuse(why, STATUS_INPUT, "--dx %g: does not divide the domain; with dy = %.6g dx no close value does",
                      o->dx, layout_spacing(p, o, 1) / o->dx);
    if (isnan(near[1]))
        return refuse(why, STATUS_INPUT, "--dx %g: does not divide the domain; nearest: %.10g", o->dx, near[0]);
    return refuse(why, STATUS_INPUT, "--dx %g: does not divide the domain; nearest: %.10g and %.10g", o->dx, near[0],
                  near[1]);
}

double layout_image_factor(const struct problem *p, int side, double k, double d) {
    double ratio = problem_transfer(p, side) * d / k;
    if (p->side[side] == DIRICHLET) return -1;
    return ratio > 1 ? (1 / ratio - 1) / (1 / ratio + 1) : (1 - ratio) / (1 + ratio);
}

/* Response of ghost k = 1, 2, ... to a constant temperature by the recurrence of struct lattice. */
static double recurrence_sum(double factor, int k) {
    double sum = factor;
    for (int i = 1; i < k; i++) sum = factor * (sum + 1) - 1;
    return sum;
}

double layout_hexagonal_rows(double height, double dx) {
    return fmax(1, round(height / (dx * sqrt(0.75))));
}

int layout_lattice(const struct problem *p, const struct options *o, struct lattice *l, struct failure *why) {
    *l = (struct lattice){.dim = p->dim, .n = {1, 1, 1}, .dx = {1, 1, 1}};
    if (!(o->dx > 0) || !isfinite(o->dx))
        return refuse(why, STATUS_INPUT, "--dx %g: must be a length > 0, in m", o->dx);
    int node = o->layout == LAYOUT_NODE;
    double particles = 1;
    for (int a = 0; a < p->dim; a++) {
        double cells, spacing = layout_spacing(p, o, a);
        if (a && o->layout == LAYOUT_HEXAGONAL)
            spacing = (p->hi[a] - p->lo[a]) / layout_hexagonal_rows(p->hi[a] - p->lo[a], o->dx);
        int divides = count_cells(p, a, spacing, &cells) || p->shape; /* a round body accepts any spacing */
        if (!(cells < CELLS_MAX))
            return refuse(why, STATUS_INPUT, "--dx %g: %g particles along %c, must be below %g", o->dx, cells,
                          "xyz"[a], CELLS_MAX);
        if (!divides) return refuse_spacing(p, o, why);
        const enum side_kind *kind = &p->side[2 * a];
        l->dx[a] = (p->hi[a] - p->lo[a]) / cells;
        l->n[a] = (int)cells;
        if (node) l->n[a] += 1 - (kind[0] == DIRICHLET) - (kind[1] == DIRICHLET);
        if (l->n[a] < 1) return refuse_spacing(p, o, why);
        particles *= l->n[a];
        l->first[a] = p->lo[a] + (node ? (kind[0] == DIRICHLET) * l->dx[a] : l->dx[a] / 2);
        for (int s = 2 * a; s < 2 * a + 2; s++) {
            int dirichlet = p->side[s] == DIRICHLET;
            double foot = s == X_HI ? p->hi[0] : p->lo[0];
            l->shift[s] = !node ? 0 : dirichlet ? -1 : 1;
            l->sign[s] = problem_law(p, s)->exchange ? LAYOUT_RECURRENCE
                         : !dirichlet                ? 1
                         : o->walls == WALLS_FIXED   ? 0
                                                     : -1;
            l->factor[s] = layout_image_factor(p, s, p->material[layout_material(p, foot)].k[a], l->dx[a] / 2);
        }
    }
    if (particles > PARTICLES_MAX)
        return refuse(why, STATUS_INPUT, "--dx %g: %.3g particles, at most %g", o->dx, particles, PARTICLES_MAX);
    return STATUS_OK;
}

void layout_position(const struct lattice *l, int i, int j, int k, double x[DIM_MAX]) {
    const int at[DIM_MAX] = {i, j, k};
    for (int a = 0; a < DIM_MAX; a++) x[a] = a < l->dim ? l->first[a] + at[a] * l->dx[a] : 0;
}

double layout_volume(const struct lattice *l) {
    return l->dx[0] * l->dx[1] * l->dx[2];
}

int layout_material(const struct problem *p, double x) {
    return p->materials == 2 && x >= p->interface - 1e-12 * (p->hi[0] - p->lo[0]);
}

double layout_beyond(const struct problem *p, double width, double x) {
    if (p->materials < 2 || width == 0) return layout_material(p, x);
    double part = (x + width / 2 - p->interface) / width;
    return part < 1e-9 ? 0 : part > 1 - 1e-9 ? 1 : part;
}

double layout_part(const struct problem *p, double width, double x, double *middle) {
    const int m = layout_material(p, x);
    const double apart = fmax(0, m ? x - p->interface : p->interface - x), edge = m ? 1 - 1e-9 : 1 + 1e-9;
    *middle = x;
    if (!(apart < edge * width)) return width;
    const double part = width / 2 + apart;
    *middle = p->interface + (m ? part : -part) / 2;
    return part;
}

double layout_rho_c(const struct problem *p, double width, double x) {
    double middle;
    if (p->resistance > 0 && width > 0)
        return p->material[layout_material(p, x)].rho_c * layout_part(p, width, x, &middle) / width;
    double part = layout_beyond(p, width, x);
    return part == 0 ? p->material[0].rho_c : (1 - part) * p->material[0].rho_c + part * p->material[1].rho_c;
}

double layout_cell(const struct options *o, double spacing) {
    return options_is_cloud(o) ? 0 : spacing;
}

/* A difference, and the sum of the magnitudes of its terms. */
struct difference {
    double value, size;
};

/* k_t D^2 of the boundary data at a foot, with the step d, without tangents that cross the interface. */
static struct difference curvature(const struct problem *p, int side, const double *foot, double d) {
    struct difference all = {0, 0};
    for (int along = 0; along < p->dim; along++) {
        if (along == side / 2 || (p->materials == 2 && along == 0)) continue;
        double at[DIM_MAX] = {0}, k = p->material[layout_material(p, foot[0])].k[along], sum = 0;
        memcpy(at, foot, (size_t)p->dim * sizeof *at);
        for (int way = -1; way < 2; way += 2) {
            at[along] = foot[along] + way * d;
            sum += p->wall(p, (enum side)side, at, 0);
        }
        double middle = 2 * p->wall(p, (enum side)side, foot, 0);
        all.value += k * (sum - middle), all.size += k * (fabs(sum) + fabs(middle));
    }
    return all;
}

/* -k_n times the highest-order term of the ghost, by differences of the step part x d. */
static struct difference highest(const struct problem *p, int side, const double *foot, double d, double part) {
    int axis = side / 2, flux = p->side[side] == NEUMANN;
    double k = p->material[layout_material(p, foot[0])].k[axis], step = side % 2 ? part * d : -part * d;
    double factor = (flux ? d / (3 * k) : 1) / (part * part), outer[DIM_MAX] = {0}, inner[DIM_MAX] = {0};
    memcpy(outer, foot, (size_t)p->dim * sizeof *outer);
    memcpy(inner, foot, (size_t)p->dim * sizeof *inner);
    struct difference sum = curvature(p, side, foot, part * d);
    sum.value *= factor, sum.size *= factor;
    if (!p->source) return sum;
    if (flux) {
        outer[axis] += step, inner[axis] -= step;
        double G[2] = {p->source(p, outer), p->source(p, inner)};
        sum.value += d * d / (6 * part) * (G[0] - G[1]);
        sum.size += d * d / (6 * part) * (fabs(G[0]) + fabs(G[1]));
    } else {
        double G = d * d * p->source(p, foot);
        sum.value += G, sum.size += fabs(G);
    }
    return sum;
}

/* The part of dT/dt = `wall_rate`, or of its gradient, in k_n times the same term. */
static double rise(const struct problem *p, int side, const double foot[2], double d) {
    const struct material *m = &p->material[layout_material(p, foot[0])];
    double part = p->side[side] == NEUMANN ? d / (3 * m->k[side / 2]) : 1;
    return part * d * d * m->rho_c * p->wall_rate(p, (enum side)side, foot, 0);
}

/* The same with the step d, or 0 if its error is larger than the term.  The error decreases with the square of the
 * step, so half the step gives an estimate.  For k_n far below k_t only this error and round-off remain. */
static double highest_known(const struct problem *p, int side, const double *foot, double d) {
    struct difference whole = highest(p, side, foot, d, 1), half = highest(p, side, foot, d, 0.5);
    double error = fabs(whole.value - half.value) * 4 / 3, rounding = 4 * DBL_EPSILON * (whole.size + half.size);
    double known = fabs(4 * half.value - whole.value) / 3 > error + rounding ? whole.value : 0;
    return p->wall_rate ? known - rise(p, side, foot, d) : known;
}

/* One reflection of `at` along the axis of a side to the coordinate `source`: T_at = *sign T_source + the returned
 * offset. l is that of layout_ghost_offset. */
static double reflect(const struct problem *p, enum walls walls, int side, const double *at, double source,
                      const struct lattice *l, double *sign) {
    int axis = side / 2;
    double foot[DIM_MAX] = {0}, ghost = at[axis];
    memcpy(foot, at, (size_t)p->dim * sizeof *foot);
    foot[axis] = side % 2 ? p->hi[axis] : p->lo[axis];
    *sign = 1;
    if (p->side[side] == PERIODIC) return 0;
    double value = p->wall(p, (enum side)side, foot, 0), d = fabs(ghost - foot[axis]);
    double k = p->material[layout_material(p, foot[0])].k[axis];
    if (problem_law(p, side)->exchange) {
        int layer = l ? (int)round(d / l->dx[axis] + 0.5) : 0;
        *sign = l ? recurrence_sum(l->factor[side], layer) : layout_image_factor(p, side, k, d);
        return (1 - *sign) * value;
    }
    if (p->side[side] == NEUMANN) {
        *sign = 1;
        return (value * fabs(ghost - source) - highest_known(p, side, foot, d)) / k;
    }
    *sign = walls == WALLS_FIXED || d < 1e-9 * (p->hi[axis] - p->lo[axis]) ? 0 : -1;
    if (*sign == 0) return value;
    return 2 * value - highest_known(p, side, foot, d) / k;
}

double layout_ghost_offset(const struct problem *p, enum walls walls, const struct lattice *l, const int *side,
                           const double *ghost, const double *source) {
    double offset = 0, sign;
    int orders = 0;
    for (int last = 0; last < p->dim; last++) { /* the last reflection is along this axis */
        if (side[last] < 0) continue;
        int before[DIM_MAX];
        double at[DIM_MAX] = {0};
        memcpy(before, side, (size_t)p->dim * sizeof *before);
        memcpy(at, ghost, (size_t)p->dim * sizeof *at);
        double sum = reflect(p, walls, side[last], ghost, source[last], l, &sign);
        before[last] = -1, at[last] = source[last];
        offset += sum + sign * layout_ghost_offset(p, walls, l, before, at, source);
        orders++;
    }
    return orders ? offset / orders : 0;
}
