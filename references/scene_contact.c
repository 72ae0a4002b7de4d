/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The slowest mode of a rectangle or box of two materials in contact at x = w1: plane-contact and box-contact.
 *
 *     rho_c dT/dt = div(k grad T)  on [0, w1 + w2] x [0, height] (x [0, depth])
 *     k, rho_c = k1, rho_c1 at x < w1, k2, rho_c2 else
 *     T = Tm at x = 0 and x = w1 + w2,   dT/dn = 0 on the other sides
 *     T(x, y, z, 0) = Tm + A phi(x) cos(q_y y) cos(q_z z),   q_y = mode pi/height,   q_z = mode_z pi/depth,   max phi
 * = 1
 *
 * With q^2 = q_y^2 + q_z^2 the solution is T = Tm + A phi(x) cos(q_y y) cos(q_z z) exp(-lambda t).  Here (k phi')' +
 * (lambda rho_c - k q^2) phi = 0, phi = 0 at both walls, and phi and k phi' are continuous at w1.  With s_i = lambda
 * rho_c_i/k_i - q^2, C(s, z) = cos(sqrt(s) z) and S(s, z) = sin(sqrt(s) z)/sqrt(s) (cosh and sinh for s < 0), phi is
 * its value at w1 times S(s_1, x)/S(s_1, w1) or S(s_2, w1 + w2 - x)/S(s_2, w2), and lambda is a root of
 *
 *     k1 C(s_1, w1)/S(s_1, w1) + k2 C(s_2, w2)/S(s_2, w2) = 0      (Carslaw and Jaeger 1959, section 12.8)
 *
 * Both terms decrease with lambda.  The first root is between the first zero and the first pole of either term,
 * s_i = (pi/2 w_i)^2 and (pi/w_i)^2.  There phi has its maximum in the layer with sqrt(s_i) w_i > pi/2 and is
 * monotone in the other.
 *
 * The second form is a Ritz approximation: integrated Legendre polynomials in each layer minimise the quotient of
 * int k (phi'^2 + q^2 phi^2) and int rho_c phi^2.  It imposes no condition at the contact.
 *
 * Rounding: lambda is a quotient of integrals of the coefficients, so its relative error is that of the
 * coefficients.  A relative change eps of lambda or q^2 moves the phase sqrt(s) z by w (|s| + q^2)/(2 sqrt(s)) eps
 * (`turn`).
 *
 * Restrictions: A < Tm, so that T > 0; modes <= 20; widths, k and rho_c of the materials within a factor of 1e6. */
#include "references/params.h"
#include "references/roots.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_integration.h>

/* The scenes' tables begin with these; DEPTH and MODE_Z in a box only.  LAMBDA: s^-1, computed by setup. */
enum { W1, W2, HEIGHT, K1, RHO_C1, K2, RHO_C2, MODE, TM, A, DEPTH, MODE_Z, LAMBDA = PARAM_MAX - 1 };

/* ---- The mode ---- */

struct layer {
    double w, k, rho_c;
    double s; /* m^-2: lambda rho_c/k - q^2 */
};

struct mode {
    double along[DIM_MAX]; /* m^-1: q_y and q_z */
    double q;              /* m^-1 */
    struct layer layer[2];
};

static struct mode mode_of(const struct problem *p, double lambda) {
    const double *v = p->param;
    struct mode m = {.layer = {{v[W1], v[K1], v[RHO_C1], 0}, {v[W2], v[K2], v[RHO_C2], 0}}};
    m.q = m.along[1] = v[MODE] * M_PI / v[HEIGHT];
    if (p->dim == 3) m.along[2] = v[MODE_Z] * M_PI / v[DEPTH], m.q = hypot(m.along[1], m.along[2]);
    for (int i = 0; i < 2; i++) m.layer[i].s = lambda * m.layer[i].rho_c / m.layer[i].k - m.q * m.q;
    return m;
}

/* S and C at 0 <= z <= w.  For s < 0 both are divided by their common factor cosh(sqrt(-s) w). */
static double sine(const struct layer *l, double z) {
    double r = sqrt(fabs(l->s));
    if (r * l->w < 1e-8) return z;
    return l->s > 0 ? sin(r * z) / r : exp(r * (z - l->w)) * -expm1(-2 * r * z) / (1 + exp(-2 * r * l->w)) / r;
}

static double cosine(const struct layer *l, double z) {
    double r = sqrt(fabs(l->s));
    return l->s > 0 ? cos(r * z) : exp(r * (z - l->w)) * (1 + exp(-2 * r * z)) / (1 + exp(-2 * r * l->w));
}

/* The negative sum of both terms times S_1 S_2/(S_1 + S_2).  The factor removes the poles and keeps the sign. */
static double mismatch(double lambda, const void *problem) {
    struct mode m = mode_of(problem, lambda);
    const struct layer *a = &m.layer[0], *b = &m.layer[1];
    double Sa = fmax(sine(a, a->w) / a->w, DBL_MIN), Sb = fmax(sine(b, b->w) / b->w, DBL_MIN);
    return -(a->k / a->w * cosine(a, a->w) * Sb + b->k / b->w * cosine(b, b->w) * Sa) / (Sa + Sb);
}

/* Smallest lambda at which sqrt(s) w = part pi in one of the layers. */
static double first_at(const struct problem *p, double part) {
    struct mode m = mode_of(p, 0);
    double lambda[2];
    for (int i = 0; i < 2; i++) {
        double r = part * M_PI / m.layer[i].w;
        lambda[i] = (m.q * m.q + r * r) * m.layer[i].k / m.layer[i].rho_c;
    }
    return fmin(lambda[0], lambda[1]);
}

/* Phase shift at the end of the layer, in units of eps, for a relative change 2 eps of lambda or q^2. */
static double turn(const struct layer *l, double q) {
    return l->w * (fabs(l->s) + q * q) / (sqrt(fabs(l->s)) + 1 / l->w);
}

/* ---- The scene ---- */

/* cos(q_y y) cos(q_z z); of the axis `sine` the sine. */
static double across(const struct mode *m, int dim, const double *x, int sine) {
    double product = 1;
    for (int a = 1; a < dim; a++) product *= a == sine ? sin(m->along[a] * x[a]) : cos(m->along[a] * x[a]);
    return product;
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param;
    struct mode m = mode_of(p, v[LAMBDA]);
    int right = x[0] >= v[W1], wide = 0; /* wide: the layer with the maximum of phi */
    for (int i = 0; i < 2; i++)
        if (m.layer[i].s > 0 && sqrt(m.layer[i].s) * m.layer[i].w >= M_PI / 2 * (1 - 1e-12)) wide = i;
    const struct layer *l = &m.layer[right], *w = &m.layer[wide];
    double z = right ? v[W1] + v[W2] - x[0] : x[0];
    double size = right == wide ? sqrt(w->s) : sqrt(w->s) * sine(w, w->w) / sine(l, l->w);
    double phi = size * sine(l, z), slope = (right ? -size : size) * cosine(l, z);
    double decay = v[LAMBDA] * t, amplitude = v[A] * exp(-decay);
    double turns = turn(&m.layer[0], m.q) + turn(&m.layer[1], m.q);
    for (int a = 1; a < p->dim; a++) turns += fabs(m.along[a] * x[a]);
    double rounding = DBL_EPSILON * amplitude * (16 + 8 * turns + 12 * decay);
    double steepest = fmax(fabs(size) + 1 / l->w, sqrt(fabs(l->s)) + m.q);
    struct exact e = {.temperature = amplitude * phi * across(&m, p->dim, x, 0),
                      .error_bound = rounding + DBL_EPSILON * v[TM],
                      .gradient = {amplitude * slope * across(&m, p->dim, x, 0)},
                      .gradient_bound = {2 * steepest * rounding}};
    e.temperature = v[TM] + e.temperature;
    for (int a = 1; a < p->dim; a++) {
        e.gradient[a] = -amplitude * phi * m.along[a] * across(&m, p->dim, x, a);
        e.gradient_bound[a] = m.along[a] * rounding;
    }
    return e;
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static int setup(const struct param *params, int dim, struct problem *p, struct failure *why) {
    const int any[] = {MODE, dim == 3 ? MODE_Z : -1, -1};
    static const int pair[][2] = {{W1, W2}, {K1, K2}, {RHO_C1, RHO_C2}};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_whole(params, p, MODE, 0, 20, why)) return STATUS_INPUT;
    if (dim == 3 && params_whole(params, p, MODE_Z, 0, 20, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    for (int i = 0; i < 3; i++)
        if (params_between(params, p, pair[i][1], 1e-6 * v[pair[i][0]], 1e6 * v[pair[i][0]],
                           "within a factor of 1e6 of the first material", why))
            return STATUS_INPUT;
    p->dim = dim;
    p->hi[0] = v[W1] + v[W2];
    p->hi[1] = v[HEIGHT];
    p->interface = v[W1];
    params_material(p, v[K1], v[K1], v[RHO_C1]);
    params_material(p, v[K2], v[K2], v[RHO_C2]);
    p->side[Y_LO] = p->side[Y_HI] = NEUMANN;
    p->mirror[1] = (int)v[MODE] % 2 == 0;
    if (dim == 3) {
        p->hi[2] = v[DEPTH];
        for (int m = 0; m < 2; m++) p->material[m].k[2] = p->material[m].k[0];
        p->side[Z_LO] = p->side[Z_HI] = NEUMANN;
        p->mirror[2] = (int)v[MODE_Z] % 2 == 0;
    }
    p->param[LAMBDA] = roots_increasing(mismatch, p, first_at(p, 0.5), first_at(p, 1));
    p->initial = initial;
    p->held[X_LO] = p->held[X_HI] = v[TM];
    return STATUS_OK;
}

/* ---- The second form ---- */

enum { DEGREE = 20, BUBBLES = DEGREE - 1, RITZ = 2 * BUBBLES + 1, NODES = 32 };

/* Shape functions at -1 <= xi <= 1: bubbles (P_j - P_(j-2))/(2j - 1), 2 <= j <= DEGREE, with slopes P_(j-1), and the
 * hat (1 + xi)/2 of the contact, with slope 1/2. */
static void shapes(double xi, double value[BUBBLES + 1], double slope[BUBBLES + 1]) {
    double P[DEGREE + 1] = {1, xi};
    for (int j = 2; j <= DEGREE; j++) P[j] = ((2 * j - 1) * xi * P[j - 1] - (j - 1) * P[j - 2]) / j;
    for (int j = 2; j <= DEGREE; j++) value[j - 2] = (P[j] - P[j - 2]) / (2 * j - 1), slope[j - 2] = P[j - 1];
    value[BUBBLES] = (1 + xi) / 2, slope[BUBBLES] = 0.5;
}

/* Index of shape function j of layer i; the hat is the last unknown, shared by both layers. */
static int unknown(int i, int j) {
    return j == BUBBLES ? RITZ - 1 : i * BUBBLES + j;
}

/* Element matrices in units of the first layer: its width, conductivity and heat capacity. */
static void add_layer(const struct mode *m, int i, gsl_matrix *stiff, gsl_matrix *mass) {
    const struct layer *unit = &m->layer[0], *l = &m->layer[i];
    double w = l->w / unit->w, k = l->k / unit->k, rho_c = l->rho_c / unit->rho_c, q = m->q * unit->w;
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(NODES);
    for (size_t node = 0; node < NODES; node++) {
        double xi, weight, N[BUBBLES + 1], D[BUBBLES + 1];
        gsl_integration_glfixed_point(-1, 1, node, &xi, &weight, rule);
        shapes(xi, N, D);
        for (int a = 0; a <= BUBBLES; a++)
            for (int b = 0; b <= BUBBLES; b++) {
                size_t row = (size_t)unknown(i, a), column = (size_t)unknown(i, b);
                double NN = weight * w / 2 * N[a] * N[b], DD = weight * 2 / w * D[a] * D[b];
                *gsl_matrix_ptr(stiff, row, column) += k * (DD + q * q * NN);
                *gsl_matrix_ptr(mass, row, column) += rho_c * NN;
            }
    }
    gsl_integration_glfixed_table_free(rule);
}

/* Returns lambda and its vector from the largest quotient of mass to stiffness, 1/lambda, whose relative rounding
 * error is of order eps. *next is the second largest quotient relative to it. */
static double ritz(const struct mode *m, double vector[RITZ], double *next) {
    gsl_matrix *stiff = gsl_matrix_calloc(RITZ, RITZ), *mass = gsl_matrix_calloc(RITZ, RITZ);
    gsl_matrix *vectors = gsl_matrix_alloc(RITZ, RITZ);
    gsl_vector *quotient = gsl_vector_alloc(RITZ);
    gsl_eigen_gensymmv_workspace *work = gsl_eigen_gensymmv_alloc(RITZ);
    for (int i = 0; i < 2; i++) add_layer(m, i, stiff, mass);
    gsl_eigen_gensymmv(mass, stiff, quotient, vectors, work);
    gsl_eigen_gensymmv_sort(quotient, vectors, GSL_EIGEN_SORT_VAL_DESC);
    for (size_t j = 0; j < RITZ; j++) vector[j] = gsl_matrix_get(vectors, j, 0);
    const struct layer *unit = &m->layer[0];
    double first = gsl_vector_get(quotient, 0);
    *next = gsl_vector_get(quotient, 1) / first;
    gsl_eigen_gensymmv_free(work);
    gsl_vector_free(quotient);
    gsl_matrix_free(vectors), gsl_matrix_free(mass), gsl_matrix_free(stiff);
    return unit->k / (unit->rho_c * unit->w * unit->w * first);
}

static double sum_of(const double vector[RITZ], int i, double xi, int slope) {
    double N[BUBBLES + 1], D[BUBBLES + 1], sum = 0;
    shapes(xi, N, D);
    for (int j = 0; j <= BUBBLES; j++) sum += vector[unknown(i, j)] * (slope ? D[j] : N[j]);
    return sum;
}

/* Maximum of phi: its slope vanishes in the layer in which phi decreases towards the contact. */
static double largest(const double vector[RITZ]) {
    double sign = vector[RITZ - 1] < 0 ? -1 : 1, lo = -1, hi = 1;
    int i = sign * sum_of(vector, 0, 1, 1) < 0 ? 0 : 1;
    for (int n = 0; n < 60; n++) {
        double middle = (lo + hi) / 2;
        *(sign * sum_of(vector, i, middle, 1) > 0 ? &lo : &hi) = middle;
    }
    return sum_of(vector, i, lo, 0);
}

/* At this DEGREE the truncation error is below round-off for phases up to 2 pi. */
static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    struct mode m = mode_of(p, 0);
    double vector[RITZ], next, lambda;
    if (m.q * fmax(v[W1], v[W2]) > 2 * M_PI) return (struct exact){.temperature = NAN, .error_bound = INFINITY};
    lambda = ritz(&m, vector, &next);
    int right = x[0] >= v[W1];
    double z = right ? v[W1] + v[W2] - x[0] : x[0], decay = lambda * t, amplitude = v[A] * exp(-decay);
    double phi = sum_of(vector, right, 2 * z / m.layer[right].w - 1, 0) / largest(vector);
    return (struct exact){.temperature = v[TM] + amplitude * phi * across(&m, p->dim, x, 0),
                          .error_bound = DBL_EPSILON * (RITZ * amplitude * (8 / (1 - next) + 4 * decay) + v[TM])};
}

/* ---- The two scenes ---- */

static const struct param plane_params[] = {
    {"w1", 0.4, "m", "width of the first material, x < w1", NULL},
    {"w2", 0.6, "m", "width of the second material", NULL},
    {"height", 0.5, "m", "extent along y", NULL},
    {"k1", 0.02, "W/m/K", "conductivity of the first material", NULL},
    {"rho_c1", 1, "J/m^3/K", "heat capacity of the first material", NULL},
    {"k2", 0.002, "W/m/K", "conductivity of the second material", NULL},
    {"rho_c2", 0.5, "J/m^3/K", "heat capacity of the second material", NULL},
    {"mode", 1, "", "number of half waves along y, an integer", NULL},
    {"Tm", 2, "K", "mean temperature, also that of the walls", NULL},
    {"A", 1, "K", "initial maximum of the mode, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int plane_setup(struct problem *p, struct failure *why) {
    return setup(plane_params, 2, p, why);
}

const struct scene scene_plane_contact = {
    .name = "plane-contact",
    .about = "the slowest mode of a rectangle of two materials in contact",
    .citation = "Carslaw and Jaeger 1959, section 12.8",
    .params = plane_params,
    .setup = plane_setup,
    .exact = exact,
    .second = second,
    .odd = {{0.37, 0.59, 0.83, 0.019, 1.3, 0.0023, 0.61, 2, 2.1, 1.2, 1.7}, 1, 0.003, 0.1},
};

static const struct param box_params[] = {
    {"w1", 0.4, "m", "width of the first material, x < w1", NULL},
    {"w2", 0.6, "m", "width of the second material", NULL},
    {"height", 0.5, "m", "extent along y", NULL},
    {"k1", 0.02, "W/m/K", "conductivity of the first material", NULL},
    {"rho_c1", 1, "J/m^3/K", "heat capacity of the first material", NULL},
    {"k2", 0.002, "W/m/K", "conductivity of the second material", NULL},
    {"rho_c2", 0.5, "J/m^3/K", "heat capacity of the second material", NULL},
    {"mode", 1, "", "number of half waves along y, an integer", NULL},
    {"Tm", 2, "K", "mean temperature, also that of the walls", NULL},
    {"A", 1, "K", "initial maximum of the mode, below Tm", NULL},
    {"depth", 1.2, "m", "extent along z", NULL},
    {"mode_z", 2, "", "number of half waves along z, an integer", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int box_setup(struct problem *p, struct failure *why) {
    return setup(box_params, 3, p, why);
}

const struct scene scene_box_contact = {
    .name = "box-contact",
    .about = "the slowest mode of a box of two materials in contact",
    .citation = "Carslaw and Jaeger 1959, section 12.8",
    .params = box_params,
    .setup = box_setup,
    .exact = exact,
    .second = second,
    .odd = {{0.37, 0.59, 0.83, 0.019, 1.3, 0.0023, 0.61, 2, 2.1, 1.2, 0.67, 1, 1.7}, 1, 0.003, 0.1},
};
