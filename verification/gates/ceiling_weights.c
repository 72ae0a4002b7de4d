/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights of the methods on a lattice of spacing 1, implemented independently of the solver, from the papers: least
 * squares with the weights W (so_ssph), pairs -W'/r (brookshaw and its corrected variants), W'' + (d - 1) W'/r (cspm,
 * kernel_second), first derivatives x W or x W'/r applied twice (fo_ssph, flux_divergence, conjugate), and finite
 * differences.  On a lattice, corrections that divide by a particle's own moments only make radial weights exact for
 * x^2. */
#include "verification/gates/ceiling_weights.h"

#include "solver/particles/particles.h"
#include "solver/space/kernel.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

enum { REACH = CEILING_REACH, NEAR = REACH / 2, MONOMIALS = 9 };

/* Loops over the offsets within r along each axis that the dimension has. */
#define OFFSETS(dim, r, i, j, k)                                                                                     \
    for (int k = (dim) > 2 ? -(r) : 0; k <= ((dim) > 2 ? (r) : 0); k++)                                              \
        for (int j = (dim) > 1 ? -(r) : 0; j <= ((dim) > 1 ? (r) : 0); j++)                                          \
            for (int i = -(r); i <= (r); i++)
#define AT(s, i, j, k) (s)->w[REACH + (k)][REACH + (j)][REACH + (i)]

static double power(double x, int n) {
    double product = 1;
    while (n-- > 0) product *= x;
    return product;
}

double ceiling_weights_moment(const struct ceiling_weights *s, int a, int b, int c) {
    double sum = 0;
    OFFSETS(s->dim, s->reach, i, j, k) sum += AT(s, i, j, k) * power(i, a) * power(j, b) * power(k, c);
    return sum;
}

double ceiling_weights_along(const struct ceiling_weights *s, const double u[DIM_MAX], int n) {
    double sum = 0;
    OFFSETS(s->dim, s->reach, i, j, k) sum += AT(s, i, j, k) * power(u[0] * i + u[1] * j + u[2] * k, n);
    return sum;
}

double ceiling_weights_row(const struct ceiling_weights *s) {
    double sum = -fabs(AT(s, 0, 0, 0));
    OFFSETS(s->dim, s->reach, i, j, k) sum += fabs(AT(s, i, j, k));
    return sum;
}

static enum ceiling_family family_of(const char *method) {
    static const struct {
        const char *method;
        enum ceiling_family family;
    } row[] = {{"so_ssph", LEAST_SQUARES},
               {"contact_ssph", LEAST_SQUARES},
               {"cspm", CURVATURE},
               {"kernel_second", CURVATURE},
               {"fo_ssph", TWICE_VALUE},
               {"flux_divergence", TWICE_SLOPE},
               {"conjugate", TWICE_SLOPE},
               {"ftcs", DIFFERENCE},
               {"voronoi_flux", DIFFERENCE},
               {"positive", DIFFERENCE},
               {"ftcs_flux", DIFFERENCE_TWICE},
               {"brookshaw", PAIRS},
               {"brookshaw_corrected", PAIRS},
               {"schwaiger", PAIRS},
               {"fatehi_manzari", PAIRS}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        if (strcmp(row[k].method, method) == 0) return row[k].family;
    return UNKNOWN;
}

double ceiling_weights_radial(const struct ceiling_weights *c, double r) {
    double s = r / c->h;
    if (r == 0 || s >= KERNEL_SUPPORT) return 0;
    double slope = kernel_slope(c->kernel, c->dim, s);
    switch (c->family) {
    case PAIRS:
        return -slope * r / (r * r + c->eta * c->eta);
    case CURVATURE:
        return kernel_curvature(c->kernel, c->dim, s) + (c->dim - 1) * slope / s;
    case TWICE_SLOPE:
        return -slope / r;
    default:
        return kernel_value(c->kernel, c->dim, s);
    }
}

/* sum_a ratio_a d2/dx_a2 of the best-fitting polynomial of degree `order`; odd monomials drop out by symmetry. */
static void least_squares(struct ceiling_weights *s) {
    static const int powers[MONOMIALS][DIM_MAX] = {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {4, 0, 0}, {0, 4, 0},
                                                   {0, 0, 4}, {2, 2, 0}, {2, 0, 2}, {0, 2, 2}};
    const int *use[MONOMIALS];
    int n = 0;
    for (int m = 0; m < MONOMIALS; m++) {
        const int *p = powers[m];
        int missing = (s->dim < 2 && p[1] > 0) || (s->dim < 3 && p[2] > 0);
        if (!missing && p[0] + p[1] + p[2] <= s->order) use[n++] = p;
    }
    gsl_matrix *N = gsl_matrix_alloc((size_t)n, (size_t)n);
    gsl_vector *z = gsl_vector_calloc((size_t)n);
    for (int a = 0; a < n; a++) {
        const int *p = use[a];
        for (int b = 0; b < n; b++) {
            double m = ceiling_weights_moment(s, p[0] + use[b][0], p[1] + use[b][1], p[2] + use[b][2]);
            gsl_matrix_set(N, (size_t)a, (size_t)b, m);
        }
        for (int axis = 0; axis < s->dim; axis++)
            if (p[axis] == 2 && p[0] + p[1] + p[2] == 2) gsl_vector_set(z, (size_t)a, 2 * s->ratio[axis]);
    }
    gsl_linalg_HH_svx(N, z);
    OFFSETS(s->dim, s->reach, i, j, k) {
        double sum = 0;
        for (int a = 0; a < n; a++)
            sum += gsl_vector_get(z, (size_t)a) * power(i, use[a][0]) * power(j, use[a][1]) * power(k, use[a][2]);
        AT(s, i, j, k) *= sum;
    }
    gsl_matrix_free(N);
    gsl_vector_free(z);
}

/* The tensor: 2 K_ab d2/dx_a dx_b.  Least squares of the second order: x_a x_b W, of another parity than all other
 * monomials.  Fluxes at faces: half of K_ab at the four cells of a diagonal.  Fluxes at corners: along each axis (1,
 * -2, 1), averaged along the others with (1, 2, 1)/4. */
static void add_cross(struct ceiling_weights *s) {
    const struct ceiling_weights W = *s;
    const int squares = s->family == LEAST_SQUARES;
    if (s->corner) memset(s->w, 0, sizeof s->w);
    for (int a = 0; a < s->dim; a++)
        for (int b = 0; b < s->dim; b++) {
            const double K = a == b ? s->ratio[a] : s->cross[problem_pair(a, b)];
            double kernel = 0;
            OFFSETS(s->dim, s->reach, i, j, k) {
                const int x[DIM_MAX] = {i, j, k}, product = x[a] * x[b];
                const double r = sqrt(i * i + j * j + k * k);
                if (squares) kernel += ceiling_weights_radial(&W, r) * product * product;
            }
            OFFSETS(s->dim, s->reach, i, j, k) {
                const int x[DIM_MAX] = {i, j, k}, far = abs(i) > 1 || abs(j) > 1 || abs(k) > 1;
                double w = 1;
                for (int c = 0; c < s->dim; c++) {
                    double slope = x[c] / 2., bend = x[c] ? 1 : -2, mean = x[c] ? 0.25 : 0.5;
                    int own = c == a || c == b;
                    w *= own ? (a == b ? bend : slope) : s->corner ? mean : x[c] == 0;
                }
                if (squares) w = ceiling_weights_radial(&W, sqrt(i * i + j * j + k * k)) * x[a] * x[b] / kernel;
                if ((a != b || s->corner) && (squares || !far)) AT(s, i, j, k) += K * w;
            }
        }
}

/* The weight in the derivative along axis a, D that along x. */
static double along_axis(const struct ceiling_weights *D, int a, int i, int j, int k) {
    return a == 0 ? AT(D, i, j, k) : a == 1 ? AT(D, j, i, k) : AT(D, k, j, i);
}

/* 2 K_ab of the derivative along a of that along b. */
static void add_mixed(struct ceiling_weights *s, const struct ceiling_weights *D, int a, int b) {
    const double K = 2 * s->cross[problem_pair(a, b)];
    OFFSETS(s->dim, NEAR, i, j, k) {
        const double w = K * along_axis(D, a, i, j, k);
        if (w == 0) continue;
        OFFSETS(s->dim, NEAR, l, m, n) AT(s, i + l, j + m, k + n) += w * along_axis(D, b, l, m, n);
    }
}

/* The derivative along x, sum w x = 1, applied twice, and its images along the other axes times their ratios. */
static void apply_twice(struct ceiling_weights *s) {
    struct ceiling_weights D = *s, one = {.dim = s->dim};
    double sum = ceiling_weights_moment(s, 2, 0, 0), across = 0;
    OFFSETS(s->dim, NEAR, i, j, k) {
        double w = AT(&D, i, j, k) *= i / sum;
        across += w * i * (i % 2 ? -1 : 1);
    }
    s->blind = across * across;
    OFFSETS(s->dim, NEAR, i, j, k) {
        double w = AT(&D, i, j, k);
        if (w == 0) continue;
        OFFSETS(s->dim, NEAR, l, m, n) AT(&one, i + l, j + m, k + n) += w * AT(&D, l, m, n);
    }
    s->reach = REACH;
    OFFSETS(s->dim, REACH, i, j, k) {
        AT(s, i, j, k) = AT(&one, i, j, k);
        if (s->dim > 1) AT(s, i, j, k) += s->ratio[1] * AT(&one, j, i, k);
        if (s->dim > 2) AT(s, i, j, k) += s->ratio[2] * AT(&one, k, j, i);
    }
    for (int b = 1; b < s->dim; b++)
        for (int a = 0; a < b; a++) add_mixed(s, &D, a, b);
}

/* Neighbours `step` dx away along each axis. */
static void difference(struct ceiling_weights *s, int step) {
    memset(s->w, 0, sizeof s->w);
    for (int a = 0; a < s->dim; a++)
        for (int side = -step; side <= step; side += 2 * step)
            AT(s, a == 0 ? side : 0, a == 1 ? side : 0, a == 2 ? side : 0) = s->ratio[a] / (step * step);
}

static void fill(struct ceiling_weights *s) {
    s->reach = NEAR, s->blind = 0;
    memset(s->w, 0, sizeof s->w);
    OFFSETS(s->dim, NEAR, i, j, k) AT(s, i, j, k) = ceiling_weights_radial(s, sqrt(i * i + j * j + k * k));
    double second = ceiling_weights_moment(s, 2, 0, 0) / 2;
    switch (s->family) {
    case LEAST_SQUARES:
        least_squares(s);
        return;
    case TWICE_VALUE:
    case TWICE_SLOPE:
        apply_twice(s);
        return;
    case DIFFERENCE:
        difference(s, 1);
        return;
    case DIFFERENCE_TWICE:
        difference(s, 2);
        s->blind = 1;
        return;
    case PAIRS:
    case CURVATURE:
        OFFSETS(s->dim, NEAR, i, j, k) AT(s, i, j, k) /= second;
        return;
    case UNKNOWN:
        OFFSETS(s->dim, NEAR, i, j, k) AT(s, i, j, k) = NAN;
    }
}

/* B - 2 A */
static double anisotropy(struct ceiling_weights *s, double h) {
    s->h = h;
    fill(s);
    return ceiling_weights_moment(s, 2, 2, 0) / 4 - ceiling_weights_moment(s, 4, 0, 0) / 12;
}

/* --h iso: the root of B = 2 A nearest to 1.2 in the plane, to 1 in space. */
static double isotropic_h(struct ceiling_weights s) {
    static const double step = 1.0 / 64;
    const double middle = s.dim == 3 ? 1 : 1.2;
    for (int k = 0; k < 100; k++)
        for (int side = -1; side <= 1; side += 2) {
            double lo = middle + side * k * step, hi = lo + side * step, at_lo = anisotropy(&s, lo);
            if (at_lo * anisotropy(&s, hi) > 0) continue;
            for (int i = 0; i < 50; i++) {
                double half = (lo + hi) / 2;
                *(anisotropy(&s, half) * at_lo > 0 ? &lo : &hi) = half;
            }
            return (lo + hi) / 2;
        }
    return NAN;
}

struct ceiling_weights ceiling_weights(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const struct options *o = &e->options;
    struct options resolved = *o;
    struct failure ignored;
    struct ceiling_weights s = {.family = family_of(e->method->name), .kernel = o->kernel, .dim = p->dim};
    for (int a = 0; a < DIM_MAX; a++)
        s.ratio[a] = a < p->dim && !options_is_matched(o) ? p->material[0].k[a] / p->material[0].k[0] : 1;
    s.order = o->order > 2 ? o->order : 2;
    if (e->method->scheme && !particles_resolve(p, o, e->method->scheme, &resolved, &ignored)) s.h = resolved.h;
    if (o->h_iso) s.h = isotropic_h(s);
    if (strcmp(e->method->name, "brookshaw") == 0) s.eta = 0.1 * s.h;
    for (int k = 0; k < DIM_MAX; k++) s.cross[k] = p->cross[k] / p->material[0].k[0];
    fill(&s);
    s.corner = o->cross == CROSS_CORNER;
    if (problem_has_cross(p) && s.family != TWICE_VALUE && s.family != TWICE_SLOPE) add_cross(&s);
    return s;
}
