/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SSPH across the contact of two materials: SO-SSPH (Song eqs. 10, 11) with monomials that continue beyond a plane
 * interface at X = x_c - x_i according to the interface conditions.  With xi = x - X and the ratios r = k_x/k_x' and
 * a = kappa_x/kappa_x' of this side to the other (dashed), T and k_x T_x are continuous, and so is T_t:
 *   kappa_x T_xx + kappa_y T_yy = kappa_x' T_xx' + kappa_y' T_yy', in space with kappa_z T_zz.  They continue as
 *   x      ->  X + r xi                        x^2/2  ->  X^2/2 + r X xi + a xi^2/2
 *   y      ->  y                               x y    ->  (X + r xi) y
 *   y^2/2  ->  y^2/2 + b xi^2/2,   b = (kappa_y - kappa_y')/kappa_x'
 * and z as y; y z is unchanged.  With a contact resistance R on a rod T is not continuous: X is replaced by X + J in
 * the continuation of x and X^2/2 by X^2/2 + J X in that of x^2/2, J = R k_x with the sign of xi.  T_t then jumps by
 * J T_xt, which the functions omit: an error J T_xt xi^2/(2 kappa_x') in T_j.  For weights w >= 0 the equations of
 * x^2/2 and x bound the sum of w_j (X + J + r xi) beyond the interface by 2 kappa_x/min |x|, so the omission leaves
 * less than kappa_x/kappa_x' |T_xt| support^2/min |x|, which is O(dx) as is the rest.
 *
 * The weights are the least squares with these five (two on a rod, nine in space) functions and the kernel as
 * weight.  For large r or a the functions beyond the interface would dominate the sum, so each equation is divided by
 * its size, which makes all of them comparable with monomials.  With weights of either sign modes still grow: on a
 * rod from h/dx = 1.5, on clouds in the plane at a ratio of 100 between diffusivities. Weights >= 0 exclude growth by
 * a maximum principle: the extreme value of a row is bounded by its neighbours.  On a rod such weights exist if there
 * is a neighbour on either side; in the plane they were found in every row up to jitter 0.3.  The least squares among
 * them are used (nonnegative.c), or those of either sign if none exist.
 *
 * Exact: for all piecewise quadratic fields that satisfy the interface conditions, on any cloud.  The truncation
 * error is O(dx) at the interface as elsewhere on a cloud, with weights >= 0 at most kappa |T_xxx| support/3 for any
 * ratio: second order in total.  Heat is not conserved.  Initial data that jump at the contact are first order,
 * except for the averages of start.c.
 *
 * Without a neighbour beyond the interface, and for one material, the weights are those of so_ssph.
 *
 * Restrictions: no source with two materials (its jump would have to be specified); layers thicker than the kernel's
 * support, so that the images beyond a wall are of the wall's own material. */
#include "solver/particles/particles.h"
#include "solver/particles/ssph.h"
#include "solver/space/kernel.h"

#include <math.h>

static int check(const struct problem *p, const struct options *o, struct failure *why) {
    if (p->materials == 1) return STATUS_OK;
    if (p->source)
        return refuse(why, STATUS_NOT_APPLICABLE, "contact_ssph: no source with two materials; use brookshaw");
    double layer = fmin(p->interface - p->lo[0], p->hi[0] - p->interface), support = KERNEL_SUPPORT * o->h * o->dx;
    if (layer < support)
        return refuse(why, STATUS_INPUT,
                      "--dx %g: the interface is %g m from a wall, within the kernel's support of %g m; use a "
                      "smaller --dx or --h",
                      o->dx, layer, support);
    return STATUS_OK;
}

/* Functions of a neighbour at d (m) in units of h, ordered as in ssph_weights.  Returns
 * their size relative to those monomials, at least 1. */
static double contact_functions(const struct problem *p, const struct neighbourhood *nb, const double *d, double *P) {
    int here = layout_material(p, nb->x[0]), there = layout_material(p, nb->x[0] + d[0]);
    const struct material *m = &p->material[here], *other = &p->material[there];
    double x = d[0] / nb->h, X = (p->interface - nb->x[0]) / nb->h;
    if (here == there) X = x; /* no interface */
    double xi = x - X, r = m->k[0] / other->k[0], kappa_x = other->k[0] / other->rho_c;
    double J = copysign(p->resistance * m->k[0] / nb->h, x), near = here == there ? X : X + J;
    double along = near + r * xi, a = nb->kappa[0] / kappa_x, most = 0;
    double curved = X * (near - X / 2) + r * X * xi + a * xi * xi / 2;
    int n = 0;
    P[n++] = along;
    for (int e = 1; e < nb->dim; e++) P[n++] = d[e] / nb->h;
    P[n++] = curved;
    for (int e = 1; e < nb->dim; e++) {
        double y = d[e] / nb->h, b = (nb->kappa[e] - other->k[e] / other->rho_c) / kappa_x;
        P[n++] = along * y;
        for (int c = 1; c < e; c++) P[n++] = d[c] / nb->h * y;
        P[n++] = y * y / 2 + b * xi * xi / 2;
        most = fmax(most, fabs(b));
    }
    if (here == there) return 1;
    return fmax(fmax(1, along / x), fmax(2 * curved, most * xi * xi) / (x * x));
}

/* Least-squares weights, with the equations beyond the interface divided by their size.  If one is negative, the
 * least squares among non-negative weights, if there are any. */
static int across(const struct options *o, const struct neighbourhood *nb, double P[][FIT_TERMS_MAX],
                  const double *size, const double *target, double *w, struct failure *why) {
    double W[NEIGHBOURS_MAX], other[NEIGHBOURS_MAX], least = 0;
    int terms = nb->dim * (nb->dim + 3) / 2;
    if (ssph_fit(nb, o->kernel, terms, P, size, target, w, why)) return why->status;
    for (size_t j = 0; j < nb->n; j++) {
        least = fmin(least, w[j]);
        W[j] = kernel_value(o->kernel, nb->dim, neighbourhood_distance(nb, j) / nb->h) / (size[j] * size[j]);
    }
    if (least < 0 && nonnegative_weights(nb->n, terms, P, W, target, other))
        for (size_t j = 0; j < nb->n; j++) w[j] = other[j];
    return STATUS_OK;
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                   struct failure *why) {
    double target[SSPH_TERMS_MAX] = {0}, P[NEIGHBOURS_MAX][FIT_TERMS_MAX], size[NEIGHBOURS_MAX];
    int crossed = 0;
    for (int a = 0; a < nb->dim; a++) target[ssph_second(nb->dim, a)] = nb->kappa[a];
    for (size_t j = 0; j < nb->n && p->materials == 2; j++)
        crossed |= layout_material(p, nb->x[0]) != layout_material(p, nb->x[0] + nb->d[j][0]);
    if (!crossed) return ssph_weights(nb, o->kernel, 2, target, w[0], why);
    for (size_t j = 0; j < nb->n; j++) size[j] = contact_functions(p, nb, nb->d[j], P[j]);
    for (int k = 0; k < SSPH_TERMS_MAX; k++) target[k] /= nb->h * nb->h;
    return across(o, nb, P, size, target, w[0], why);
}

static const struct scheme scheme = {
    .name = "contact_ssph", .two_materials = 1, .sweeps = 1, .keeps_start = 1, .check = check, .weights = weights};

const struct method method_contact_ssph = {
    .name = "contact_ssph",
    .about = "SO-SSPH with a Taylor series that keeps T, k T_x and T_t continuous across an interface",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &scheme,
    .solve = particles_solve,
};
