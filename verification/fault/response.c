/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Responses: the difference of two runs divided by the size of the fault, interpolated to the points by splines
 * (GSL: cubic; Steffen's for two materials, which does not overshoot at their interface; in space by cubics through
 * four points of each axis).  Beyond the outermost cell centres the interpolation on rods and in the plane is linear.
 */
#include "verification/fault/response.h"

#include "solver/method.h"

#include <gsl/gsl_interp2d.h>
#include <gsl/gsl_spline.h>
#include <gsl/gsl_spline2d.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Small: the time error of Euler's method, dt/2 d2T/dt2, cancels part of the error in space, all of it at 1/6. */
static const double FOURIER = 0.05;

/* With k(T) steps of rkl2, which evaluate source and walls a fifth as often; 0: no Fourier number. */
static double fourier_of(const struct problem *p) {
    return p->k_law ? 0 : FOURIER;
}

static int solve(const struct problem *p, double dx, double fourier, enum mean mean, struct field *f) {
    struct failure ignored;
    struct options o = {.dx = dx,
                        .fourier = fourier,
                        .stepper = fourier > 0 ? STEPPER_EULER : STEPPER_RKL2,
                        .sampling = p->jumps[0] + p->jumps[1] + p->jumps[2] ? SAMPLING_CELL : SAMPLING_POINT,
                        .mean = p->k_law && mean != MEAN_HARMONIC ? MEAN_KIRCHHOFF : mean,
                        .domain = DOMAIN_WHOLE};
    return method_solve(method_find("ftcs"), p, &o, f, &ignored);
}

static int is_face(double at, double lo, double dx) {
    double cells = (at - lo) / dx;
    return fabs(cells - nearbyint(cells)) < 1e-9 * fabs(cells) + 1e-12;
}

/* Number of jumps and interfaces on faces of n cells along x; -1 if the cells do not fit the domain. */
static int fit(const struct problem *p, int n) {
    double dx = (p->hi[0] - p->lo[0]) / n;
    int faces = p->materials == 2 && is_face(p->interface, p->lo[0], dx);
    for (int a = 0; a < p->dim; a++) {
        if (!is_face(p->hi[a], p->lo[a], dx)) return -1;
        for (int k = 0; k < p->jumps[a]; k++) faces += is_face(p->jump[a][k], p->lo[a], dx);
    }
    return faces;
}

int response_lattice_create(const struct problem *p, struct response_lattice *l) {
    /* the steps of k(T), and of walls that change in the plane, take ten times as long */
    const int coarse = p->k_law || (p->wall_rate && p->dim > 1) ? 2 : 1;
    int best = -1, n = 0, least = p->dim == 3 ? 16 : 64, most = p->dim == 3 ? 40 : 128;
    for (int i = least / coarse; i <= most / coarse; i++)
        if (fit(p, i) > best) best = fit(p, i), n = i;
    if (best < 0 || p->shape) return -1; /* rings do not form a lattice */
    struct field f;
    *l = (struct response_lattice){.dx = (p->hi[0] - p->lo[0]) / n};
    if (solve(p, l->dx, fourier_of(p), MEAN_SERIES, &f)) return -1;
    memcpy(l->n, f.shape, sizeof l->n);
    l->T = f.T;
    f.T = NULL;
    field_free(&f);
    if (solve(p, l->dx, 3 * FOURIER, MEAN_SERIES, &f)) {
        response_lattice_free(l);
        return -1;
    }
    l->longer = f.T;
    f.T = NULL;
    const double longer = 3 * FOURIER - fourier_of(p);
    for (int i = 0; i < l->n[0] * l->n[1] * l->n[2]; i++) l->longer[i] = (l->longer[i] - l->T[i]) / longer;
    field_free(&f);
    return 0;
}

void response_lattice_free(struct response_lattice *l) {
    free(l->T);
    free(l->longer);
    *l = (struct response_lattice){0};
}

static void along_rod(const gsl_interp_type *type, const double *x, const double *D, size_t n, const struct field *f,
                      double *out) {
    gsl_spline *spline = gsl_spline_alloc(type, n);
    gsl_interp_accel *near = gsl_interp_accel_alloc();
    gsl_spline_init(spline, x, D, n);
    for (size_t i = 0; i < f->n; i++) {
        double to[DIM_MAX];
        field_place(f, i, to);
        double at = fmin(fmax(to[0], x[0]), x[n - 1]);
        out[i] = gsl_spline_eval(spline, at, near);
        if (at != to[0]) out[i] += (to[0] - at) * gsl_spline_eval_deriv(spline, at, near);
    }
    gsl_interp_accel_free(near);
    gsl_spline_free(spline);
}

static void in_plane(double *const x[2], const double *D, const int n[2], const struct field *f, double *out) {
    gsl_spline2d *spline = gsl_spline2d_alloc(gsl_interp2d_bicubic, (size_t)n[0], (size_t)n[1]);
    gsl_interp_accel *near[2] = {gsl_interp_accel_alloc(), gsl_interp_accel_alloc()};
    gsl_spline2d_init(spline, x[0], x[1], D, (size_t)n[0], (size_t)n[1]);
    for (size_t i = 0; i < f->n; i++) {
        double to[DIM_MAX], at[2];
        field_place(f, i, to);
        for (int a = 0; a < 2; a++) at[a] = fmin(fmax(to[a], x[a][0]), x[a][n[a] - 1]);
        out[i] = gsl_spline2d_eval(spline, at[0], at[1], near[0], near[1]);
        if (at[0] != to[0])
            out[i] += (to[0] - at[0]) * gsl_spline2d_eval_deriv_x(spline, at[0], at[1], near[0], near[1]);
        if (at[1] != to[1])
            out[i] += (to[1] - at[1]) * gsl_spline2d_eval_deriv_y(spline, at[0], at[1], near[0], near[1]);
    }
    for (int a = 0; a < 2; a++) gsl_interp_accel_free(near[a]);
    gsl_spline2d_free(spline);
}

/* Lagrange's cubic through four of the n equidistant x: the first of them, and their weights at `at`. */
static int cubic_weights(const double *x, int n, double at, double w[4]) {
    double place = (at - x[0]) / (x[1] - x[0]);
    int first = (int)fmin(fmax(floor(place) - 1, 0), n - 4);
    for (int k = 0; k < 4; k++) {
        w[k] = 1;
        for (int m = 0; m < 4; m++) w[k] *= m == k ? 1 : (place - first - m) / (k - m);
    }
    return first;
}

static void in_space(double *const x[], const double *D, const int n[], const struct field *f, double *out) {
    for (size_t i = 0; i < f->n; i++) {
        double at[DIM_MAX], w[DIM_MAX][4], sum = 0;
        int first[DIM_MAX];
        field_place(f, i, at);
        for (int a = 0; a < DIM_MAX; a++) first[a] = cubic_weights(x[a], n[a], at[a], w[a]);
        for (int k = 0; k < 64; k++) {
            int c = first[0] + k % 4 + n[0] * (first[1] + k / 4 % 4 + n[1] * (first[2] + k / 16));
            sum += w[0][k % 4] * w[1][k / 4 % 4] * w[2][k / 16] * D[c];
        }
        out[i] = sum;
    }
}

/* The cell centres along an axis, in the coordinates of the right problem; the caller frees them. */
static double *centres(const struct faulty *f, const struct response_lattice *l, int axis) {
    double *x = xcalloc((size_t)l->n[axis], sizeof *x);
    for (int i = 0; i < l->n[axis]; i++) {
        double at = f->right->lo[axis] + (i + 0.5) * l->dx;
        x[i] = f->centre[axis] + f->stretch[axis] * (at - f->centre[axis]);
    }
    return x;
}

static void carry(const struct faulty *f, const struct response_lattice *l, const double *T, const struct field *to,
                  double *out) {
    double *x[DIM_MAX] = {NULL};
    for (int a = 0; a < f->right->dim; a++) x[a] = centres(f, l, a);
    if (x[2])
        in_space(x, T, l->n, to, out);
    else if (x[1])
        in_plane(x, T, l->n, to, out);
    else
        along_rod(f->right->materials == 2 ? gsl_interp_steffen : gsl_interp_cspline, x[0], T, (size_t)l->n[0], to,
                  out);
    for (int a = 0; a < DIM_MAX; a++) free(x[a]);
}

void response_base(const struct problem *p, const struct response_lattice *l, const struct field *f, double *base,
                   double *longer) {
    struct faulty none;
    fault_make(p, (struct fault){FAULT_AMPLITUDE, 0}, 0, &none);
    carry(&none, l, l->T, f, base);
    carry(&none, l, l->longer, f, longer);
}

void response_laplacian(const struct problem *p, const struct response_lattice *l, const struct field *f,
                        double *out) {
    struct faulty none;
    const int *n = l->n, all = n[0] * n[1] * n[2];
    double *D = xcalloc((size_t)all, sizeof *D);
    for (int c = 0; c < all; c++)
        for (int a = 0, stride = 1; a < p->dim; stride *= n[a++]) {
            int at = c / stride % n[a], inner = at < 1 ? 1 : at > n[a] - 2 ? n[a] - 2 : at; /* next to the wall */
            const double *T = l->T + c + (inner - at) * stride;
            D[c] += (T[stride] - 2 * *T + T[-stride]) / (l->dx * l->dx);
        }
    fault_make(p, (struct fault){FAULT_AMPLITUDE, 0}, 0, &none);
    carry(&none, l, D, f, out);
    free(D);
}

int response_take(const struct problem *p, const struct response_lattice *l, struct fault fault, double size,
                  struct response *r) {
    enum mean mean = fault.kind == FAULT_MEAN ? MEAN_ARITHMETIC : MEAN_SERIES;
    if (fault.kind == FAULT_LAW && fault.axis == LAW_HARMONIC) mean = MEAN_HARMONIC;
    double small = fault.kind == FAULT_MEAN ? l->dx : fault_probe(p, fault); /* one cell for a local fault */
    r->size = size != 0 ? size : small;
    return fault_make(p, fault, r->size, &r->with) && !solve(&r->with.problem, l->dx, fourier_of(p), mean, &r->T)
               ? 0
               : -1;
}

void response_free(struct response *r) {
    field_free(&r->T);
}

void response_at(const struct response *r, const struct response_lattice *l, const struct field *f,
                 const double *base, double *out) {
    carry(&r->with, l, r->T.T, f, out);
    for (size_t i = 0; i < f->n; i++) out[i] = (out[i] - base[i]) / r->size;
}

int response_at_corner(const struct problem *p, double dx, struct fault fault, const struct field *f,
                       double *response) {
    const int most = p->dim == 3 ? 48 : 160;
    struct faulty with;
    struct field right, faulty;
    if ((p->hi[0] - p->lo[0]) / dx > most + 0.5 || !fault_make(p, fault, dx, &with)) return -1;
    if (solve(p, dx, 4 * FOURIER, MEAN_SERIES, &right)) return -1;
    int failed = solve(&with.problem, dx, 4 * FOURIER, MEAN_SERIES, &faulty);
    if (!failed) {
        struct response_lattice l = {{right.shape[0], right.shape[1], right.shape[2]}, dx, right.T, NULL};
        for (size_t i = 0; i < right.n; i++) right.T[i] = faulty.T[i] - right.T[i];
        carry(&with, &l, l.T, f, response);
        field_free(&faulty);
    }
    field_free(&right);
    return failed ? -1 : 0;
}
