/* SPDX-License-Identifier: GPL-3.0-or-later */
/* box-manufactured: a box in which every term of the equation is active: source, anisotropy, and data that vary along
 * walls of all three kinds.
 *
 *     rho_c dT/dt = k_x d2T/dx2 + k_y d2T/dy2 + k_z d2T/dz2 + G(x, y, z)  on [0, width] x [0, height] x [0, depth]
 *
 * Source and walls follow from a chosen solution (method of manufactured solutions, Roache 2002):
 *
 *     T = S(x, y, z) + Z(x, y, z) exp(-lambda t)
 *     S = 1 + 1/2 exp(0.8 x/width) cos(1.1 y/height + 0.4) cos(0.9 z/depth - 0.3)                  K
 *     Z = A sin(2 pi x/width) cos(pi y/height) sin(q (z - depth/2))                                  K
 *     lambda = (k_x (2 pi/width)^2 + k_y (pi/height)^2 + k_z q^2)/rho_c
 *     G = -(k_x S_xx + k_y S_yy + k_z S_zz)                                                          W m^-3
 *
 * With u = q depth/2 and u cot u = -b depth/(2 k_z), first root, the eigenfunction Z vanishes on the x sides, has
 * zero slope on the y sides and obeys k_z dZ/dn = -b Z on the z sides (roots.h).  So the boundary data are those of S
 * and steady: T = S on the x sides, the flux k_y dS/dn on the y sides, the ambient temperature S + k_z/b dS/dn on the
 * z sides.  They are traces of one smooth function, and agree with the initial data: the solution is smooth up to
 * edges and corners.
 *
 * The second form evolves T(0) - S without Z, lambda or q: by FFTW along x and y at the nodes of a Gauss rule along
 * z, and along z in Legendre polynomials, in which Galerkin's method has the cooled sides as natural conditions.
 *
 * Restrictions: A <= 1, so that T > 0; 1e-6 <= b depth/k_z <= 1e6. */
#include "references/params.h"
#include "references/roots.h"
#include "references/spectral.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_integration.h>

enum { WIDTH, HEIGHT, DEPTH, K_X, K_Y, K_Z, RHO_C, B, A, T_END, Q_Z }; /* Q_Z: m^-1, computed by setup */

static const struct param params[] = {
    {"width", 1.0, "m", "extent along x, between two Dirichlet walls", NULL},
    {"height", 0.7, "m", "extent along y, between two Neumann walls", NULL},
    {"depth", 0.8, "m", "extent along z, between two Robin walls", NULL},
    {"k_x", 0.02, "W/m/K", "conductivity along x", NULL},
    {"k_y", 0.005, "W/m/K", "conductivity along y", NULL},
    {"k_z", 0.011, "W/m/K", "conductivity along z", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"b", 0.03, "W/m^2/K", "heat transfer coefficient of the z sides", NULL},
    {"A", 0.8, "K", "amplitude of the decaying part, up to 1", NULL},
    {"t_end", 2, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* S - 1 and its gradient. */
static double steady(const struct problem *p, const double *x, double slope[3]) {
    double a = 0.8 / p->param[WIDTH], b = 1.1 / p->param[HEIGHT], c = 0.9 / p->param[DEPTH];
    double along = 0.5 * exp(a * x[0]), y = b * x[1] + 0.4, z = c * x[2] - 0.3;
    slope[0] = a * along * cos(y) * cos(z);
    slope[1] = -b * along * sin(y) * cos(z);
    slope[2] = -c * along * cos(y) * sin(z);
    return along * cos(y) * cos(z);
}

static double source(const struct problem *p, const double *x) {
    const double *v = p->param;
    double a = 0.8 / v[WIDTH], b = 1.1 / v[HEIGHT], c = 0.9 / v[DEPTH], slope[3];
    return (b * b * v[K_Y] + c * c * v[K_Z] - a * a * v[K_X]) * steady(p, x, slope);
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    int axis = (int)s / 2;
    double at[3] = {x[0], x[1], x[2]}, slope[3];
    (void)t;
    at[axis] = s % 2 ? p->hi[axis] : p->lo[axis];
    double S = 1 + steady(p, at, slope), flux = p->material[0].k[axis] * (s % 2 ? slope[axis] : -slope[axis]);
    return axis == 0 ? S : axis == 1 ? flux : S + flux / p->robin[s];
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, *k = p->material[0].k;
    double q[3] = {2 * M_PI / v[WIDTH], M_PI / v[HEIGHT], v[Q_Z]}, from[3] = {0, 0, v[DEPTH] / 2}, slope[3];
    double factor[3], change[3], exponent = 0, turns = 0;
    for (int a = 0; a < 3; a++) {
        double phase = q[a] * (x[a] - from[a]), s = sin(phase), c = cos(phase);
        factor[a] = a == 1 ? c : s, change[a] = a == 1 ? -q[a] * s : q[a] * c;
        exponent += k[a] * q[a] * q[a] / v[RHO_C] * t;
        turns += q[a] * (fabs(x[a]) + from[a]);
    }
    double amplitude = v[A] * exp(-exponent), rounding = amplitude * (10 + 2 * turns + 10 * exponent);
    struct exact e = {.temperature = 1 + steady(p, x, slope) + amplitude * factor[0] * factor[1] * factor[2],
                      .error_bound = DBL_EPSILON * (10 + rounding)};
    for (int a = 0; a < 3; a++) {
        e.gradient[a] = slope[a] + amplitude * change[a] * factor[(a + 1) % 3] * factor[(a + 2) % 3];
        e.gradient_bound[a] = DBL_EPSILON * (24 / v[WIDTH + a] + q[a] * rounding);
    }
    return e;
}

static double transient(const struct problem *p, const double *x) {
    const double *v = p->param;
    return v[A] * sin(2 * M_PI / v[WIDTH] * x[0]) * cos(M_PI / v[HEIGHT] * x[1]) *
           sin(v[Q_Z] * (x[2] - v[DEPTH] / 2));
}

static double initial(const struct problem *p, const double *x) {
    double slope[3];
    return 1 + steady(p, x, slope) + transient(p, x);
}

static int setup(struct problem *p, struct failure *why) {
    static const enum side_kind kind[] = {DIRICHLET, NEUMANN, ROBIN};
    double *v = p->param;
    if (params_start(params, p, NULL, why)) return STATUS_INPUT;
    if (params_within(params, p, A, 0, 1, "the temperature stays positive, 0 < A <= 1", why)) return STATUS_INPUT;
    if (params_between(params, p, B, 1e-6 * v[K_Z] / v[DEPTH], 1e6 * v[K_Z] / v[DEPTH], "b depth/k_z of 1e-6 to 1e6",
                       why))
        return STATUS_INPUT;
    p->dim = 3;
    params_material(p, v[K_X], v[K_Y], v[RHO_C]);
    p->material[0].k[2] = v[K_Z];
    for (int s = 0; s < SIDES; s++) p->side[s] = kind[s / 2], p->hi[s / 2] = v[WIDTH + s / 2];
    p->robin[Z_LO] = p->robin[Z_HI] = v[B];
    v[Q_Z] = roots_cooled(1, 0, v[B] * v[DEPTH] / (2 * v[K_Z])) * 2 / v[DEPTH];
    p->initial = initial;
    p->wall = wall;
    p->source = source;
    return STATUS_OK;
}

/* ---- The second form ---- */

enum { DEGREES = 20, NODES = 32 };

static void legendre(double xi, double P[DEGREES]) {
    P[0] = 1, P[1] = xi;
    for (int i = 2; i < DEGREES; i++) P[i] = ((2 * i - 1) * xi * P[i - 1] - (i - 1) * P[i - 2]) / i;
}

/* Galerkin's problem mass v = mu stiffness v on -1 <= xi <= 1 in Legendre polynomials: a mode decays as
 * exp(-time/mu). The integral of P_i' P_j' is m (m + 1), m the lower degree, if i + j is even, else 0.  biot = b
 * depth/(2 k_z).  The rounding error of mu is relative to the largest mu, that of the slowest mode. */
static void modes(double biot, double mu[DEGREES], double vector[DEGREES][DEGREES]) {
    gsl_matrix *mass = gsl_matrix_calloc(DEGREES, DEGREES), *stiff = gsl_matrix_calloc(DEGREES, DEGREES);
    gsl_matrix *vectors = gsl_matrix_alloc(DEGREES, DEGREES);
    gsl_vector *values = gsl_vector_alloc(DEGREES);
    gsl_eigen_gensymmv_workspace *work = gsl_eigen_gensymmv_alloc(DEGREES);
    for (size_t i = 0; i < DEGREES; i++) {
        gsl_matrix_set(mass, i, i, 2 / (2.0 * (double)i + 1));
        for (size_t j = i % 2; j < DEGREES; j += 2) {
            double m = (double)(i < j ? i : j);
            gsl_matrix_set(stiff, i, j, m * (m + 1) + 2 * biot);
        }
    }
    gsl_eigen_gensymmv(mass, stiff, values, vectors, work);
    for (size_t n = 0; n < DEGREES; n++) {
        mu[n] = gsl_vector_get(values, n);
        for (size_t i = 0; i < DEGREES; i++) vector[n][i] = gsl_matrix_get(vectors, i, n);
    }
    gsl_eigen_gensymmv_free(work);
    gsl_vector_free(values);
    gsl_matrix_free(vectors), gsl_matrix_free(stiff), gsl_matrix_free(mass);
}

/* Evolution along z of data with these Legendre coefficients, at xi. */
static double evolved(const double coefficient[DEGREES], double biot, double time, double xi) {
    double mu[DEGREES], vector[DEGREES][DEGREES], P[DEGREES], T = 0;
    modes(biot, mu, vector);
    legendre(xi, P);
    for (int n = 0; n < DEGREES; n++) {
        double projected = 0, norm = 0, value = 0;
        for (int i = 0; i < DEGREES; i++) {
            double weighted = vector[n][i] * 2 / (2.0 * i + 1);
            projected += weighted * coefficient[i], norm += weighted * vector[n][i], value += vector[n][i] * P[i];
        }
        T += projected / norm * value * exp(-time / mu[n]);
    }
    return T;
}

/* The coordinate of the rectangle's spectral expansion along z is the node: lo[2]. */
static struct exact second(const struct problem *p, const double *x, double t) {
    static const int n[2] = {16, 12};
    const double *v = p->param, half = v[DEPTH] / 2;
    double coefficient[DEGREES] = {0}, P[DEGREES], slope[3], bound = 0;
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(NODES);
    for (size_t node = 0; node < NODES; node++) {
        struct problem slice = *p;
        double xi, weight;
        gsl_integration_glfixed_point(-1, 1, node, &xi, &weight, rule);
        slice.dim = 2;
        slice.lo[2] = half + half * xi;
        struct spectral *s = spectral_alloc(&slice, n, transient);
        struct exact e = spectral_at(s, x, t);
        spectral_free(s);
        legendre(xi, P);
        for (int i = 0; i < DEGREES; i++) coefficient[i] += (i + 0.5) * weight * e.temperature * P[i];
        bound = fmax(bound, e.error_bound);
    }
    gsl_integration_glfixed_table_free(rule);
    double time = v[K_Z] / v[RHO_C] * t / (half * half), biot = v[B] * half / v[K_Z];
    double T = evolved(coefficient, biot, time, x[2] / half - 1);
    /* 20 x 20 eigenvectors round to 400 eps; the largest mu is about 1/biot of the others */
    return (struct exact){.temperature = 1 + steady(p, x, slope) + T,
                          .error_bound = DBL_EPSILON * (400 + 100 / biot) + 4 * bound};
}

const struct scene scene_box_manufactured = {
    .name = "box-manufactured",
    .about = "an anisotropic box with a source and walls of all three kinds: smooth",
    .citation = "manufactured; method: Roache 2002, J. Fluids Eng. 124:4",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{0.9, 0.6, 0.7, 0.023, 0.0061, 0.013, 1.9, 0.037, 0.7, 1.3}, 2, 0.02, 0.1},
};
