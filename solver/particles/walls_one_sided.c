/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A wall without dummies: SSPH's own least squares, one-sided, with the boundary condition as an additional
 * equation.
 *
 * Near a wall the constant of the expansion about particle i is an unknown, as in modified SPH (Zhang & Batra 2004,
 * Comput. Mech. 34:137).  A quadratic q is fitted to the nearby particles and particle i itself, with the kernel as
 * weight, and at the nearest point of each wall within the support, with ten times the weight at distance 0, to
 *   given T_w  q = T_w,   given flux g  q_n = g/k,   exchange b (T_a - T)  q_n + (b/k) q = (b/k) T_a,
 * with slopes in units of h.  Then
 *   dT_i/dt = sum_a kappa_a q_aa + sigma (q(x_i) - T_i),   sigma = 2 sum_a kappa_a/h^2,
 * where sigma is close to the rate of an inner particle's own weight (3.5 kappa/h^2 on a square lattice, 2.3 on a
 * rod).
 *
 * Rationale: if the fit is bound exactly to T_i and T_w, a particle at distance d has weights of size 1/(d h), and
 * the stable step decreases with d.  With exact T_i and a weighted wall, the influence of the wall vanishes as d
 * tends to 0, and one-sided second differences let T_i grow.  Here the weights are of size 1/h^2 for any wall
 * position, and T_i is relaxed to the fit.
 *
 * Step: with few particles in the fit the fastest mode is localised on one of them, and its rate is that particle's
 * own weight.  Over all angles of a square lattice and depths up to 2 dx it is at most 5.0 kappa/dx^2 at a plane
 * wall (h grows to 1.46 dx), and 5.3 at 0.3 dx from a Dirichlet wall that is convex into the body with a radius of
 * 3.2 dx, where fifteen particles are found before h grows: stable steps of 0.40 and 0.37 dx^2/kappa, compared with
 * 0.525 without walls.
 *
 * Order: q is exact for quadratics, q(x_i) - T_i = O(dx^3), and both terms have an error of O(dx) in a layer one
 * kernel wide.  The layer contributes O(dx^3) to T at a Dirichlet wall and O(dx^2) at others, as dummies by `fit`
 * do: second order, also in the maximum norm.  The fit requires fifteen particles, as there. */
#include "solver/particles/walls.h"

#include "solver/particles/ssph.h"
#include "solver/shape.h"
#include "solver/space/assembly.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdlib.h>

static const double WALL_WEIGHT = 10;

/* 1, x, y, x^2/2, x y, y^2/2 at d in units of h (1, x, x^2/2 on a rod; in space with z, x z, y z, z^2/2); returns
 * their number. */
static int quadratic_monomials(int dim, const double *d, double *P) {
    int n = 0;
    P[n++] = 1;
    for (int a = 0; a < dim; a++) P[n++] = d[a];
    for (int b = 0; b < dim; b++)
        for (int a = 0; a <= b; a++) P[n++] = d[a] * d[b] * (a == b ? 0.5 : 1);
    return n;
}

/* Adds their slopes along the normal. */
static void add_slopes(int dim, const double *d, const double *normal, double *P) {
    int n = 1;
    for (int a = 0; a < dim; a++) P[n++] += normal[a];
    for (int b = 0; b < dim; b++)
        for (int a = 0; a <= b; a++) P[n++] += a == b ? d[a] * normal[a] : d[a] * normal[b] + d[b] * normal[a];
}

/* The equation of wall s at its foot: the row P and the returned right-hand side. */
static double equation(const struct problem *p, int s, const struct foot *f, const double *x, double h, double *P) {
    double d[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) d[a] = (f->x[a] - x[a]) / h;
    double value = p->wall(p, (enum side)s, f->x, 0), k = p->material[0].k[walls_axis(f->normal)];
    int terms = quadratic_monomials(p->dim, d, P);
    if (p->side[s] == DIRICHLET) return value;
    double ratio = problem_transfer(p, s) * h / k, size = 1 / (1 + ratio);
    for (int t = 0; t < terms; t++) P[t] *= ratio;
    add_slopes(p->dim, d, f->normal, P);
    for (int t = 0; t < terms; t++) P[t] *= size;
    return size * (problem_law(p, s)->is_flux ? value * h / k : ratio * value);
}

struct equations { /* equations of the neighbours, the particle itself, and the walls */
    struct neighbourhood nb;
    double d[NEIGHBOURS_MAX][DIM_MAX], P[NEIGHBOURS_MAX][FIT_TERMS_MAX], size[NEIGHBOURS_MAX], w[NEIGHBOURS_MAX];
    size_t from[NEIGHBOURS_MAX]; /* index of the neighbour */
    double given[SIDES];         /* right-hand sides of the walls */
};

/* Collects the equations within 2 h of the particle; returns the number for particles. */
static size_t collect_equations(const struct problem *p, const struct neighbourhood *nb, double h,
                                struct equations *e) {
    size_t n = 0, particles;
    e->nb =
        (struct neighbourhood){.dim = nb->dim, .i = nb->i, .x = {nb->x[0], nb->x[1], nb->x[2]}, .d = e->d, .h = h};
    for (size_t j = 0; j <= nb->n && n + SIDES < NEIGHBOURS_MAX; j++) {
        double s[DIM_MAX];
        if (j < nb->n && neighbourhood_distance(nb, j) >= KERNEL_SUPPORT * h * (1 - 1e-9)) continue;
        for (int a = 0; a < DIM_MAX; a++) e->d[n][a] = j < nb->n ? nb->d[j][a] : 0, s[a] = e->d[n][a] / h;
        e->from[n] = j, e->size[n] = 1;
        quadratic_monomials(nb->dim, s, e->P[n++]);
    }
    particles = n;
    for (int s = 0; s < SIDES; s++) {
        if (!shape_has_wall(p, s)) continue;
        struct foot f = shape_foot(p, s, nb->x);
        if (!(f.depth < KERNEL_SUPPORT * h)) continue;
        e->given[n - particles] = equation(p, s, &f, nb->x, h, e->P[n]);
        e->d[n][0] = e->d[n][1] = e->d[n][2] = 0, e->size[n++] = 1 / sqrt(WALL_WEIGHT);
    }
    e->nb.n = n;
    return particles;
}

int walls_one_sided(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                    struct wall_row *out, struct failure *why) {
    size_t least = walls_least[nb->dim], particles = 0;
    double sigma = 0;
    char place[PLACE_TEXT];
    for (int a = 0; a < nb->dim; a++) sigma += nb->kappa[a];
    sigma = 2 * sigma / (nb->h * nb->h);
    struct equations *e = xcalloc(1, sizeof *e);
    int status = STATUS_NUMERICAL;
    *out = (struct wall_row){.own = -sigma};
    for (double grown = 1; grown <= assembly_widest(nb->dim, o->h) && status; grown *= 1.1) {
        double h = grown * nb->h, target[FIT_TERMS_MAX] = {sigma}, second = 1 / (h * h);
        int terms = (nb->dim + 1) * (nb->dim + 2) / 2;
        for (int a = 0; a < nb->dim; a++) target[1 + ssph_second(nb->dim, a)] = nb->kappa[a] * second;
        particles = collect_equations(p, nb, h, e);
        if (particles < least)
            refuse(why, STATUS_NUMERICAL,
                   "particle %zu at %s, beside a wall, has %zu particles within %.3g m, at least %zu are "
                   "needed; use a smaller --dx",
                   nb->i, problem_place(nb->dim, nb->x, place), particles, KERNEL_SUPPORT * h, least);
        else
            status = ssph_fit(&e->nb, o->kernel, terms, e->P, e->size, target, e->w, why);
    }
    for (size_t k = 0; k < e->nb.n && !status; k++) {
        if (k >= particles)
            out->g += e->w[k] * e->given[k - particles];
        else if (e->from[k] == nb->n)
            out->own += e->w[k];
        else
            out->w[e->from[k]] = e->w[k];
    }
    free(e);
    return status;
}
