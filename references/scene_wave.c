/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wave: one oblique wave on a periodic square or cube, which has no walls.
 *
 *     dT/dt = kappa_x d2T/dx2 + 2 kappa_xy d2T/dx dy + kappa_y d2T/dy2  on [0, L]^2, periodic in x and y,
 *     T(x, y, 0) = Tm + A cos(q_x x + q_y y + phase),   q_x = 2 pi mode_x/L,   q_y = 2 pi mode_y/L
 *
 * and with mode_z > 0 the same on [0, L]^3 with kappa_z, kappa_xz, kappa_yz and q_z = 2 pi mode_z/L.
 *
 * The wave is an eigenfunction of the operator with the eigenvalue -q.K q, K the tensor of diffusivities:
 *
 *     T = Tm + A cos(q.x + phase) exp(-(q.K q) t),
 *     q.K q = kappa_x q_x^2 + kappa_y q_y^2 + kappa_z q_z^2 + 2 kappa_xy q_x q_y + 2 kappa_xz q_x q_z + ...
 *
 * (Carslaw and Jaeger 1959, sections 1.17-20 and 2.2).  The second form turns the axes to the eigenvectors of K (GSL)
 * and convolves the initial data along each with the free-space Gaussian by the trapezoidal rule, without the
 * eigenfunction.
 *
 * Restrictions: A < Tm, so that T > 0; modes 0 to 32, mode_x and mode_y not both 0; no negative eigenvalue of K. */
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_eigen.h>

enum { L, KAPPA_X, KAPPA_Y, KAPPA_Z, KAPPA_XY, KAPPA_XZ, KAPPA_YZ, MODE_X, MODE_Y, MODE_Z, PHASE, TM, A, T_END };

static const struct param params[] = {
    {"L", 1, "m", "period along each axis", NULL},
    {"kappa_x", 0.01, "m^2/s", "diffusivity along x", NULL},
    {"kappa_y", 0.01, "m^2/s", "diffusivity along y", NULL},
    {"kappa_z", 0.01, "m^2/s", "diffusivity along z, if mode_z is positive", NULL},
    {"kappa_xy", 0, "m^2/s", "off the diagonal of the tensor", NULL},
    {"kappa_xz", 0, "m^2/s", "the same, if mode_z is positive", NULL},
    {"kappa_yz", 0, "m^2/s", "the same, if mode_z is positive", NULL},
    {"mode_x", 1, "", "number of waves along x, an integer", NULL},
    {"mode_y", 2, "", "number of waves along y, an integer", NULL},
    {"mode_z", 0, "", "number of waves along z, an integer; 0: a square", NULL},
    {"phase", 0.3, "", "phase of the wave at the origin, rad", NULL},
    {"Tm", 1, "K", "mean temperature", NULL},
    {"A", 0.7, "K", "initial amplitude of the wave, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double kappa_at(const double *v, int a, int b) {
    return a == b ? v[KAPPA_X + a] : v[KAPPA_XY + problem_pair(a, b)];
}

/* Eigenvalues, m^2 s^-1, and eigenvectors of K. */
static void turn(const struct problem *p, double lambda[DIM_MAX], double e[DIM_MAX][DIM_MAX]) {
    const size_t n = (size_t)p->dim;
    double K[DIM_MAX * DIM_MAX], vectors[DIM_MAX * DIM_MAX];
    for (size_t k = 0; k < n * n; k++) K[k] = kappa_at(p->param, (int)(k / n), (int)(k % n));
    gsl_matrix_view of = gsl_matrix_view_array(K, n, n), to = gsl_matrix_view_array(vectors, n, n);
    gsl_vector_view values = gsl_vector_view_array(lambda, n);
    gsl_eigen_symmv_workspace *room = gsl_eigen_symmv_alloc(n);
    gsl_eigen_symmv(&of.matrix, &values.vector, &to.matrix, room);
    gsl_eigen_symmv_free(room);
    for (size_t k = 0; k < n * n; k++) e[k % n][k / n] = vectors[k];
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param;
    double q[DIM_MAX] = {0}, rate = 0, gross = 0, phase = 0, turns = 0;
    for (int a = 0; a < p->dim; a++) {
        q[a] = 2 * M_PI * v[MODE_X + a] / v[L];
        for (int b = 0; b <= a; b++) {
            double part = (a == b ? 1 : 2) * kappa_at(v, a, b) * q[a] * q[b];
            rate += part, gross += fabs(part);
        }
        phase += q[a] * x[a];
        turns += q[a] * fabs(x[a]);
    }
    phase += v[PHASE], turns += fabs(v[PHASE]);
    double amplitude = v[A] * exp(-rate * t), rounding = DBL_EPSILON * amplitude * (4 + 3 * turns + 7 * gross * t);
    struct exact e = {.temperature = v[TM] + amplitude * cos(phase), .error_bound = rounding + DBL_EPSILON * v[TM]};
    for (int a = 0; a < p->dim; a++) {
        e.gradient[a] = -amplitude * q[a] * sin(phase);
        e.gradient_bound[a] = q[a] * rounding;
    }
    return e;
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {KAPPA_XY, KAPPA_XZ, KAPPA_YZ, MODE_X, MODE_Y, MODE_Z, PHASE, -1};
    const double *v = p->param;
    double lambda[DIM_MAX] = {0}, e[DIM_MAX][DIM_MAX];
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    for (int a = 0; a < 3; a++)
        if (params_whole(params, p, MODE_X + a, 0, 32, why)) return STATUS_INPUT;
    if (v[MODE_X] == 0 && params_whole(params, p, MODE_Y, 1, 32, why)) return STATUS_INPUT;
    if (params_between(params, p, PHASE, -100, 100, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    p->dim = v[MODE_Z] > 0 ? 3 : 2;
    params_material(p, v[KAPPA_X], v[KAPPA_Y], 1);
    if (p->dim == 3) p->material[0].k[2] = v[KAPPA_Z];
    for (int k = 0; k < (p->dim == 3 ? 3 : 1); k++) p->cross[k] = v[KAPPA_XY + k];
    turn(p, lambda, e);
    for (int a = 0; a < p->dim; a++)
        if (lambda[a] < -1e-12 * (v[KAPPA_X] + v[KAPPA_Y]))
            return refuse(why, STATUS_INPUT,
                          "--set kappa_xy=%g: the tensor of diffusivities has the eigenvalue %g m^2/s; needs none "
                          "below 0: kappa_xy^2 up to kappa_x kappa_y",
                          v[KAPPA_XY], lambda[a]);
    for (int a = 0; a < p->dim; a++) {
        p->hi[a] = v[L];
        p->side[2 * a] = p->side[2 * a + 1] = PERIODIC;
    }
    p->initial = initial;
    return STATUS_OK;
}

/* Weighted mean of the initial data at x + sum of s u e over the eigenvectors e, s = sqrt(4 lambda t), with the
 * weight exp(-|u|^2)/pi^(dim/2).  The quadrature error of a step du is exp(-(pi/du - (q.e) s/2)^2) of the wave: at
 * most exp(-38).  GSL's eigenvalues are those of K to some roundings of its trace. */
static struct exact second(const struct problem *p, const double *x, double t) {
    static const double reach = 6.2;                          /* limit of u */
    const double *v = p->param, most = p->dim > 2 ? 7.7 : 19; /* limit of (q.e) s */
    const int points = p->dim > 2 ? 40 : 64, n = p->dim;
    double lambda[DIM_MAX], e[DIM_MAX][DIM_MAX], s[DIM_MAX], du = 2 * reach / points, sum = 0, slab = 0;
    double turns = fabs(v[PHASE]), square_q = 0, trace = 0;
    int all = 1;
    turn(p, lambda, e);
    for (int k = 0; k < n; k++) {
        double along = 0, across = 0, q = 2 * M_PI * v[MODE_X + k] / v[L];
        s[k] = sqrt(4 * fmax(0, lambda[k]) * t);
        for (int a = 0; a < n; a++) {
            double part = 2 * M_PI * v[MODE_X + a] / v[L] * e[k][a];
            along += part, across += fabs(part);
        }
        if (fabs(along) * s[k] > most) return (struct exact){.temperature = NAN, .error_bound = INFINITY};
        if (along == 0) s[k] = 0;
        turns += q * fabs(x[k]) + across * s[k];
        square_q += q * q, trace += v[KAPPA_X + k];
        all *= points;
    }
    for (int k = 0; k < all; k++) {
        double place[DIM_MAX] = {x[0], x[1], n > 2 ? x[2] : 0}, square = 0;
        for (int d = 0, rest = k; d < n; d++, rest /= points) {
            double u = du * (rest % points + 0.5) - reach;
            for (int a = 0; a < n; a++) place[a] += s[d] * u * e[d][a];
            square += u * u;
        }
        slab += exp(-square) * (initial(p, place) - v[TM]);
        if ((k + 1) % (points * points)) continue;
        sum += slab, slab = 0;
    }
    double unit = n > 2 ? du / sqrt(M_PI) : 1;
    return (struct exact){.temperature = v[TM] + sum * du * du / M_PI * unit,
                          .error_bound =
                              DBL_EPSILON * (v[A] * (20 + 4 * turns + 8 * trace * square_q * t) + 3 * v[TM])};
}

const struct scene scene_wave = {
    .name = "wave",
    .about = "one oblique wave on a periodic square or cube: no walls",
    .citation = "Carslaw and Jaeger 1959, section 2.2",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.017, 0.011, 0.0083, 0.0041, -0.0023, 0.0029, 2, 1, 0, 0.37, 1.1, 0.6, 1.7}, 1, 0.01, 0.1},
};
