/* Where the particles and their ghosts are.
 *
 * Cell-centred lattice: x_i = lo + (i + 1/2) dx (Song's tables; the walls lie midway between a particle and its
 * mirror image).  Node lattice: x_i = lo + i dx, where a node on a Dirichlet wall is known and so not a particle, and
 * a node on a Neumann wall is one.  Jitter: each particle of the cell-centred lattice is moved uniformly within +-A
 * dx along each axis; its ghosts are the mirror images of the moved particles, so that walls stay exact; so are those
 * of all clouds (place.c, relax.c).
 *
 * Ghosts at the distance d beyond a wall, n its outward normal, t along it:
 *   fixed      T_g = T_wall (Pamplona Fig. 3, first order)
 *   Dirichlet  T_g = 2 T_wall - T_source + d^2 T_nn + O(d^4)
 *   Neumann    T_g = T_source + 2 d q / k_n + d^3/3 T_nnn + O(d^5)
 *   Robin      T_g = f T_source + (1 - f) T_a + O(d^3), f = (k_n - b d)/(k_n + b d): k_n dT/dn = b (T_a - T) midway
 * Sides and source do not change in time, so that the equation gives k_n T_nn = -G - k_t T_tt on a Dirichlet wall
 * and, from its derivative, k_n T_nnn = -G_n - k_t (q/k_n)_tt on a Neumann wall.  Central differences of step d,
 * D^2 f = f(t + d) - 2 f(t) + f(t - d), keep these orders:
 *   d^2 T_nn = -(d^2 G + k_t D^2 T_wall) / k_n
 *   d^3/3 T_nnn = -(d^2/6 (G_g - G_source) + d/3 k_t D^2 q / k_n) / k_n
 * At a corner, wall data and source are taken where their formulas continue them. */
#include "solver/space/layout.h"

#include "solver/space/place.h"
#include "solver/space/relax.h"

#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PARTICLES_MAX = 4e9; /* rows have columns of 32 bits */

/* The nearest spacings, on either side, that divide every extent, dy = ratio dx; NaN where there is none. */
static void nearest_spacings(const struct problem *p, double dx, double ratio, double out[2]) {
    double extent = p->hi[0] - p->lo[0], other = p->dim == 2 ? (p->hi[1] - p->lo[1]) / ratio : extent;
    double near = fmax(1, floor(extent / dx));
    for (int up = 0; up < 2; up++) {
        out[up] = NAN;
        for (double n = up ? near : near + 1; n >= 1 && n < 4 * near + 1000; n += up ? -1 : 1) {
            double cells = other * n / extent;
            if (fabs(cells - round(cells)) > 1e-9 * cells || round(cells) < 1) continue;
            out[up] = extent / n;
            break;
        }
    }
}

static const double CELLS_MAX = 1e8; /* along an axis */

static int count_cells(const struct problem *p, int axis, double spacing, double *cells) {
    *cells = (p->hi[axis] - p->lo[axis]) / spacing;
    double whole = round(*cells);
    int divides = whole >= 1 && fabs(*cells - whole) <= 1e-6 * whole;
    *cells = whole;
    return divides;
}

static int refuse_spacing(const struct problem *p, const struct options *o, double ratio, struct failure *why) {
    double near[2];
    nearest_spacings(p, o->dx, ratio, near);
    if (isnan(near[0]))
        return refuse(why, STATUS_INPUT,
                      "--dx %g does not divide the domain, and with dy = %.6g dx none near it does", o->dx, ratio);
    if (isnan(near[1]))
        return refuse(why, STATUS_INPUT, "--dx %g does not divide the domain; try %.10g", o->dx, near[0]);
    return refuse(why, STATUS_INPUT, "--dx %g does not divide the domain; the nearest that do are %.10g and %.10g",
                  o->dx, near[0], near[1]);
}

/* (k - b d)/(k + b d), with no overflow where b is huge: what a ghost d beyond a Robin wall takes of its source. */
static double robin_factor(const struct problem *p, int side, double k, double d) {
    double ratio = p->side[side] == ROBIN ? p->robin[side] * d / k : 0;
    return ratio > 1 ? (1 / ratio - 1) / (1 / ratio + 1) : (1 - ratio) / (1 + ratio);
}

/* What ghost k = 1, 2, ... beyond a Robin side makes of a constant temperature. */
static double robin_sum(double robin, int k) {
    double sum = robin;
    for (int i = 1; i < k; i++) sum = robin * (sum + 1) - 1;
    return sum;
}

int layout_lattice(const struct problem *p, const struct options *o, double ratio, struct lattice *l,
                   struct failure *why) {
    *l = (struct lattice){.dim = p->dim, .n = {1, 1}, .dx = {1, 1}};
    if (!(o->dx > 0) || !isfinite(o->dx))
        return refuse(why, STATUS_INPUT, "--dx %g: must be a length > 0, in m", o->dx);
    int node = o->layout == LAYOUT_NODE;
    double particles = 1;
    for (int a = 0; a < p->dim; a++) {
        double cells, spacing = a ? o->dx * ratio : o->dx;
        if (a && o->layout == LAYOUT_HEXAGONAL)
            spacing = (p->hi[a] - p->lo[a]) / place_rows(p->hi[a] - p->lo[a], o->dx);
        int divides = count_cells(p, a, spacing, &cells);
        if (!(cells < CELLS_MAX))
            return refuse(why, STATUS_INPUT, "--dx %g: %g particles along %c, fewer than %g can be", o->dx, cells,
                          "xy"[a], CELLS_MAX);
        if (!divides) return refuse_spacing(p, o, ratio, why);
        const enum side_kind *kind = &p->side[2 * a];
        l->dx[a] = (p->hi[a] - p->lo[a]) / cells;
        l->n[a] = (int)cells;
        if (node) l->n[a] += 1 - (kind[0] == DIRICHLET) - (kind[1] == DIRICHLET);
        if (l->n[a] < 1) return refuse_spacing(p, o, ratio, why);
        particles *= l->n[a];
        l->first[a] = p->lo[a] + (node ? (kind[0] == DIRICHLET) * l->dx[a] : l->dx[a] / 2);
        for (int s = 2 * a; s < 2 * a + 2; s++) {
            int dirichlet = p->side[s] == DIRICHLET;
            double foot = s == X_HI ? p->hi[0] : p->lo[0];
            l->shift[s] = !node ? 0 : dirichlet ? -1 : 1;
            l->sign[s] = p->side[s] == ROBIN ? LAYOUT_ROBIN : !dirichlet ? 1 : o->walls == WALLS_FIXED ? 0 : -1;
            l->robin[s] = robin_factor(p, s, p->material[layout_material(p, foot)].k[a], l->dx[a] / 2);
            if (node && p->side[s] == ROBIN)
                return refuse(
                    why, STATUS_NOT_APPLICABLE,
                    "--layout node: a Robin wall lies midway between a particle and its ghost; take lattice");
        }
    }
    if (particles > PARTICLES_MAX)
        return refuse(why, STATUS_INPUT, "--dx %g: %.3g particles, at most %g", o->dx, particles, PARTICLES_MAX);
    return STATUS_OK;
}

void layout_position(const struct lattice *l, int i, int j, double x[2]) {
    x[0] = l->first[0] + i * l->dx[0];
    x[1] = l->dim == 2 ? l->first[1] + j * l->dx[1] : 0;
}

int layout_material(const struct problem *p, double x) {
    return p->materials == 2 && x >= p->interface - 1e-12 * (p->hi[0] - p->lo[0]);
}

double layout_beyond(const struct problem *p, double width, double x) {
    if (p->materials < 2 || width == 0) return layout_material(p, x);
    double part = (x + width / 2 - p->interface) / width;
    return part < 1e-9 ? 0 : part > 1 - 1e-9 ? 1 : part;
}

double layout_rho_c(const struct problem *p, double width, double x) {
    double part = layout_beyond(p, width, x);
    return part == 0 ? p->material[0].rho_c : (1 - part) * p->material[0].rho_c + part * p->material[1].rho_c;
}

double layout_cell(const struct options *o, double spacing) {
    return options_is_cloud(o) ? 0 : spacing;
}

/* k_t D^2 of the side's data along it, at the foot of a ghost that is d beyond: 0 on a rod, and where materials meet
 * along the side. */
static double curvature(const struct problem *p, int side, const double foot[2], double d) {
    int along = 1 - side / 2;
    double before[2] = {foot[0], foot[1]}, after[2] = {foot[0], foot[1]};
    if (p->dim == 1 || (p->materials == 2 && along == 0)) return 0;
    before[along] -= d, after[along] += d;
    double sum = p->wall(p, (enum side)side, before) + p->wall(p, (enum side)side, after);
    return p->material[layout_material(p, foot[0])].k[along] * (sum - 2 * p->wall(p, (enum side)side, foot));
}

/* One reflection, along `axis`: T_ghost = *sign T_source + the returned offset.  `at` has the other coordinate; l is
 * as for layout_ghost_offset. */
static double reflect(const struct problem *p, enum walls walls, int axis, int side, double ghost, double source,
                      const double at[2], const struct lattice *l, double *sign) {
    double foot[2] = {at[0], at[1]}, outer[2] = {at[0], at[1]}, inner[2] = {at[0], at[1]};
    foot[axis] = side % 2 ? p->hi[axis] : p->lo[axis];
    outer[axis] = ghost, inner[axis] = source;
    double value = p->wall(p, (enum side)side, foot), d = fabs(ghost - foot[axis]);
    double k = p->material[layout_material(p, foot[0])].k[axis];
    if (p->side[side] == ROBIN) {
        int layer = l ? (int)round(d / l->dx[axis] + 0.5) : 0;
        *sign = l ? robin_sum(l->robin[side], layer) : robin_factor(p, side, k, d);
        return (1 - *sign) * value;
    }
    if (p->side[side] == NEUMANN) {
        double steeper = p->source ? d * d / 6 * (p->source(p, outer) - p->source(p, inner)) : 0;
        *sign = 1;
        return (value * fabs(ghost - source) - steeper - d / 3 * curvature(p, side, foot, d) / k) / k;
    }
    *sign = walls == WALLS_FIXED || d < 1e-9 * (p->hi[axis] - p->lo[axis]) ? 0 : -1;
    if (*sign == 0) return value;
    return 2 * value - ((p->source ? d * d * p->source(p, foot) : 0) + curvature(p, side, foot, d)) / k;
}

double layout_ghost_offset(const struct problem *p, enum walls walls, const struct lattice *l, const int side[2],
                           const double ghost[2], const double source[2]) {
    double offset = 0, sign;
    int orders = 0;
    for (int outer = 0; outer < 2; outer++) { /* reflect along `outer` last */
        int inner = 1 - outer;
        if (side[outer] < 0) continue;
        double sum = reflect(p, walls, outer, side[outer], ghost[outer], source[outer], ghost, l, &sign);
        if (side[inner] >= 0) {
            double at[2];
            at[outer] = source[outer];
            at[inner] = ghost[inner];
            double inner_sign;
            sum += sign * reflect(p, walls, inner, side[inner], ghost[inner], source[inner], at, l, &inner_sign);
        }
        offset += sum;
        orders++;
    }
    return orders ? offset / orders : 0;
}

/* Particles in the order of square cells of side `reach`: neighbours in space are neighbours in memory. */
static void place_particles(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
                            struct cloud *c) {
    int block[2] = {(int)fmax(1, floor(reach / l->dx[0])), l->dim == 2 ? (int)fmax(1, floor(reach / l->dx[1])) : 1};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, o->seed);
    double amplitude = o->layout == LAYOUT_JITTER || o->layout == LAYOUT_RELAXED ? 2 * o->jitter : 0;
    size_t k = 0;
    for (int j0 = 0; j0 < l->n[1]; j0 += block[1])
        for (int i0 = 0; i0 < l->n[0]; i0 += block[0])
            for (int j = j0; j < j0 + block[1] && j < l->n[1]; j++)
                for (int i = i0; i < i0 + block[0] && i < l->n[0]; i++, k++) {
                    double x[2];
                    place_position(p, o, l, i, j, x);
                    c->x[k] = x[0] + amplitude * l->dx[0] * (gsl_rng_uniform(random) - 0.5);
                    c->y[k] = l->dim == 2 ? x[1] + amplitude * l->dx[1] * (gsl_rng_uniform(random) - 0.5) : 0;
                    c->source[k] = (uint32_t)k;
                    c->sign[k] = 1;
                }
    gsl_rng_free(random);
}

/* The images of particle i beyond the walls, up to three (two sides and the corner between them). */
static void add_ghosts(const struct problem *p, const struct options *o, const struct lattice *l, size_t i,
                       struct cloud *c) {
    double source[2] = {c->x[i], c->y[i]};
    for (int sx = -1; sx < 2; sx++)
        for (int sy = p->dim == 2 ? -1 : 1; sy < 2; sy++) { /* -1: not beyond this axis; else the side's parity */
            int side[2] = {sx, p->dim == 2 && sy >= 0 ? 2 + sy : -1}, sign = 1, near = 1;
            double factor = 1;
            double ghost[2] = {source[0], source[1]};
            if (side[0] < 0 && side[1] < 0) continue;
            for (int a = 0; a < p->dim; a++) {
                if (side[a] < 0) continue;
                double wall = side[a] % 2 ? p->hi[a] : p->lo[a];
                near = near && fabs(source[a] - wall) < c->reach;
                ghost[a] = 2 * wall - source[a];
                if (l->sign[side[a]] == LAYOUT_ROBIN)
                    factor *= robin_factor(p, side[a], p->material[layout_material(p, ghost[0])].k[a],
                                           fabs(source[a] - wall));
                else
                    sign *= l->sign[side[a]];
            }
            if (!near) continue;
            size_t k = c->total++;
            c->x[k] = ghost[0];
            c->y[k] = ghost[1];
            c->source[k] = (uint32_t)i;
            c->sign[k] = (signed char)sign;
            if (c->factor) c->factor[k] = factor * sign;
            c->offset[k] = layout_ghost_offset(p, o->walls, NULL, side, ghost, source);
        }
}

/* Of particles and ghosts, which have their sources'. */
static void add_spacings(const struct problem *p, const struct options *o, const struct lattice *l, struct cloud *c) {
    c->spacing = xcalloc(c->total, sizeof *c->spacing);
    c->coarsest = place_coarsest(p, o, l);
    for (size_t i = 0; i < c->total; i++) {
        double x[2] = {c->x[c->source[i]], c->y[c->source[i]]};
        c->spacing[i] = place_spacing(p, o, l, x);
    }
}

static void take_places(const struct field *from, struct cloud *c) {
    memcpy(c->x, from->x, c->n * sizeof *c->x);
    if (from->y) memcpy(c->y, from->y, c->n * sizeof *c->y);
    c->settling = from->settling;
}

int layout_cloud(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
                 struct cloud *c, struct failure *why) {
    if (o->layout == LAYOUT_GRADED) reach *= place_coarsest(p, o, l) / l->dx[0];
    if (o->layout == LAYOUT_NODE)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "--layout node: particles with rows of their own need another layout");
    for (int a = 0; a < p->dim; a++)
        if (reach > p->hi[a] - p->lo[a])
            return refuse(why, STATUS_INPUT,
                          "--dx %g: the ghosts of a wall reach %g m, past the opposite wall; take a "
                          "smaller --dx or --h",
                          o->dx, reach);
    size_t n = (size_t)l->n[0] * (size_t)l->n[1], width[2];
    for (int a = 0; a < 2; a++) width[a] = a < p->dim ? (size_t)(2 * ceil(reach / l->dx[a]) + 3) : 0;
    size_t most = n + width[0] * (size_t)l->n[1] + width[1] * (size_t)l->n[0] + width[0] * width[1];
    if (o->layout == LAYOUT_GRADED) most = 9 * n;
    *c = (struct cloud){.dim = p->dim, .n = n, .total = n, .reach = reach, .volume = l->dx[0] * l->dx[1]};
    c->x = xcalloc(most, sizeof *c->x);
    c->y = xcalloc(most, sizeof *c->y);
    c->source = xcalloc(most, sizeof *c->source);
    c->sign = xcalloc(most, sizeof *c->sign);
    c->offset = xcalloc(most, sizeof *c->offset);
    for (int s = 0; s < 2 * p->dim; s++)
        if (p->side[s] == ROBIN && !c->factor) c->factor = xcalloc(most, sizeof *c->factor);
    for (size_t i = 0; c->factor && i < n; i++) c->factor[i] = 1;
    place_particles(p, o, l, reach, c);
    if (o->layout == LAYOUT_RELAXED && o->placed && o->redraw == 0)
        take_places(o->placed, c);
    else if (o->layout == LAYOUT_RELAXED && relax_cloud(p, o, p->dim == 2 ? sqrt(c->volume) : c->volume, c, why)) {
        layout_cloud_free(c);
        return why->status;
    }
    for (size_t i = 0; i < n; i++) add_ghosts(p, o, l, i, c);
    if (o->layout == LAYOUT_GRADED) add_spacings(p, o, l, c);
    return STATUS_OK;
}

void layout_cloud_free(struct cloud *c) {
    free(c->x);
    free(c->y);
    free(c->source);
    free(c->sign);
    free(c->offset);
    free(c->factor);
    free(c->spacing);
    *c = (struct cloud){0};
}
