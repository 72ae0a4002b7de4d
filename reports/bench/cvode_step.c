/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cvode_step CASE OUT TOLERANCE: SUNDIALS' CVODE on square-step and cube-step, as its manual advises for a symmetric
 * matrix.
 *
 *     dT/dt = sum over axes of kappa (second difference of T), T = 0 on the sides; BDF, Newton, conjugate gradients
 *
 * The Jacobian times a vector is the right side itself: the equation is linear and its walls are at zero.
 * Distributions compile the vectors of SUNDIALS without optimization, which costs a factor of 12; their loops stand
 * here again. */
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_pcg.h>
#include <time.h>

enum { NOT_APPLICABLE = 77, ITERATIONS = 100, STEPS = 1000000 };
static const double WARM = 0.1; /* s: solves before the one that is timed */

static int dim, n, total; /* cells along an axis, and in all */
static double dx, half_width, half[3], kappa[3], T0, t_end;

static void stop(const char *reason) {
    fprintf(stderr, "cvode_step: %s\n", reason);
    exit(1);
}

static void read_case(const char *path) {
    char line[4096], scene[40] = "";
    FILE *f = fopen(path, "r");
    if (!f) stop("the case cannot be opened");
    while (fgets(line, sizeof line, f)) {
        sscanf(line, "scene = %39s", scene);
        sscanf(line, "dim = %d", &dim);
        sscanf(line, "cells = %d", &n);
        sscanf(line, "dx = %lf", &dx);
        sscanf(line, "param_L = %lf", &half_width);
        sscanf(line, "param_a = %lf", &half[0]);
        sscanf(line, "param_b = %lf", &half[1]);
        sscanf(line, "param_c = %lf", &half[2]);
        sscanf(line, "param_kappa_x = %lf", &kappa[0]);
        sscanf(line, "param_kappa_y = %lf", &kappa[1]);
        sscanf(line, "param_kappa_z = %lf", &kappa[2]);
        sscanf(line, "param_T0 = %lf", &T0);
        sscanf(line, "t_end = %lf", &t_end);
    }
    fclose(f);
    if (strcmp(scene, "square-step") != 0 && strcmp(scene, "cube-step") != 0) exit(NOT_APPLICABLE);
    total = dim == 3 ? n * n * n : n * n;
}

/* ---- Loops of N_Vector ---- */

static double *array(N_Vector v) {
    return N_VGetArrayPointer_Serial(v);
}

static void linear_sum(double a, N_Vector x, double b, N_Vector y, N_Vector z) {
    const double *p = array(x), *q = array(y);
    double *r = array(z);
#pragma omp simd
    for (int i = 0; i < total; i++) r[i] = a * p[i] + b * q[i];
}

static void scale(double c, N_Vector x, N_Vector z) {
    const double *p = array(x);
    double *r = array(z);
#pragma omp simd
    for (int i = 0; i < total; i++) r[i] = c * p[i];
}

static void constant(double c, N_Vector z) {
    double *r = array(z);
    for (int i = 0; i < total; i++) r[i] = c;
}

static void product(N_Vector x, N_Vector y, N_Vector z) {
    const double *p = array(x), *q = array(y);
    double *r = array(z);
#pragma omp simd
    for (int i = 0; i < total; i++) r[i] = p[i] * q[i];
}

static double dot(N_Vector x, N_Vector y) {
    const double *p = array(x), *q = array(y);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < total; i++) sum += p[i] * q[i];
    return sum;
}

static double weighted_norm(N_Vector x, N_Vector w) {
    const double *p = array(x), *q = array(w);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < total; i++) sum += p[i] * q[i] * p[i] * q[i];
    return sqrt(sum / total);
}

static int linear_combination(int count, double *c, N_Vector *X, N_Vector z) {
    scale(c[0], X[0], z);
    for (int k = 1; k < count; k++) linear_sum(c[k], X[k], 1, z, z);
    return 0;
}

static int scale_add(int count, double *c, N_Vector x, N_Vector *Y, N_Vector *Z) {
    for (int k = 0; k < count; k++) linear_sum(c[k], x, 1, Y[k], Z[k]);
    return 0;
}

static void use_loops(N_Vector v) {
    v->ops->nvlinearsum = linear_sum;
    v->ops->nvscale = scale;
    v->ops->nvconst = constant;
    v->ops->nvprod = product;
    v->ops->nvdotprod = dot;
    v->ops->nvwrmsnorm = weighted_norm;
    v->ops->nvlinearcombination = linear_combination;
    v->ops->nvscaleaddmulti = scale_add;
}

/* ---- The equation ---- */

static double place(int i) {
    return -half_width + (i + 0.5) * dx;
}

static void fill_start(double *T) {
    for (int c = 0; c < total; c++) {
        int hot = 1;
        for (int a = 0, rest = c; a < dim; a++, rest /= n) hot &= fabs(place(rest % n)) <= half[a] * (1 + 1e-12);
        T[c] = hot ? T0 : 0;
    }
}

/* One line of cells along x, with the lines beside it along y (and z); a ghost beyond a wall has the opposite
 * temperature. */
static void second_difference(const double *restrict row, const double *const beside[4], double *restrict out) {
    const double *restrict y0 = beside[0], *restrict y1 = beside[1], *restrict z0 = beside[2],
                           *restrict z1 = beside[3];
    double cx = kappa[0] / (dx * dx), cy = kappa[1] / (dx * dx), cz = kappa[2] / (dx * dx);
    for (int i = 1; i < n - 1 && dim == 2; i++)
        out[i] = cx * (row[i - 1] - 2 * row[i] + row[i + 1]) + cy * (y0[i] - 2 * row[i] + y1[i]);
    for (int i = 1; i < n - 1 && dim == 3; i++)
        out[i] = cx * (row[i - 1] - 2 * row[i] + row[i + 1]) + cy * (y0[i] - 2 * row[i] + y1[i]) +
                 cz * (z0[i] - 2 * row[i] + z1[i]);
    for (int i = 0; i < n; i += n - 1) {
        out[i] = cx * ((i ? row[i - 1] : row[1]) - 3 * row[i]) + cy * (y0[i] - 2 * row[i] + y1[i]);
        if (dim == 3) out[i] += cz * (z0[i] - 2 * row[i] + z1[i]);
    }
}

static void laplacian(const double *T, double *out, double *ghosts) {
    for (int line = 0; line < total / n; line++) {
        const double *row = T + (ptrdiff_t)line * n, *beside[4] = {NULL};
        int wall = 0;
        for (int a = 1, rest = line; a < dim; a++, rest /= n) {
            ptrdiff_t step = a == 1 ? n : (ptrdiff_t)n * n;
            beside[2 * a - 2] = rest % n > 0 ? row - step : ghosts;
            beside[2 * a - 1] = rest % n < n - 1 ? row + step : ghosts;
            wall |= rest % n == 0 || rest % n == n - 1;
        }
        for (int i = 0; i < n && wall; i++) ghosts[i] = -row[i];
        second_difference(row, beside, out + (ptrdiff_t)line * n);
    }
}

static int rhs(double t, N_Vector T, N_Vector dT_dt, void *ghosts) {
    (void)t;
    laplacian(N_VGetArrayPointer(T), N_VGetArrayPointer(dT_dt), ghosts);
    return 0;
}

static int jacobian_times(N_Vector v, N_Vector Jv, double t, N_Vector T, N_Vector dT_dt, void *ghosts, N_Vector tmp) {
    (void)T, (void)dT_dt, (void)tmp;
    return rhs(t, v, Jv, ghosts);
}

static void solve(N_Vector T, double *ghosts, double tolerance, SUNContext sun) {
    double t;
    void *ode = CVodeCreate(CV_BDF, sun);
    SUNLinearSolver krylov = SUNLinSol_PCG(T, SUN_PREC_NONE, ITERATIONS, sun);
    if (!ode || !krylov) stop("out of memory");
    if (CVodeInit(ode, rhs, 0, T) || CVodeSStolerances(ode, tolerance, tolerance * T0)) stop("CVODE was not set up");
    if (CVodeSetUserData(ode, ghosts) || CVodeSetLinearSolver(ode, krylov, NULL)) stop("CVODE was not set up");
    if (CVodeSetJacTimes(ode, NULL, jacobian_times) || CVodeSetMaxNumSteps(ode, STEPS)) stop("CVODE was not set up");
    if (CVodeSetStopTime(ode, t_end) || CVode(ode, t_end, T, &t, CV_NORMAL) < 0) stop("CVODE failed");
    CVodeFree(&ode);
    SUNLinSolFree(krylov);
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void write_answer(const char *path, const double *T, double seconds) {
    FILE *f = fopen(path, "w");
    if (!f) stop("the answer cannot be written");
    fprintf(f, "# seconds = %.9g\n%s\n", seconds, dim == 3 ? "x,y,z,T" : "x,y,T");
    for (int c = 0; c < total; c++) {
        for (int a = 0, rest = c; a < dim; a++, rest /= n) fprintf(f, "%.17g,", place(rest % n));
        fprintf(f, "%.17g\n", T[c]);
    }
    if (fclose(f)) stop("the answer cannot be written");
}

int main(int argc, char **argv) {
    SUNContext sun;
    double begin, seconds, first = now();
    if (argc == 2 && strcmp(argv[1], "--version") == 0) return puts(SUNDIALS_VERSION) < 0;
    if (argc != 4) stop("three arguments are needed: CASE OUT TOLERANCE");
    read_case(argv[1]);
    if (SUNContext_Create(NULL, &sun)) stop("SUNContext_Create failed");
    N_Vector T = N_VNew_Serial(total, sun);
    double *ghosts = calloc((size_t)n, sizeof *ghosts);
    if (!T || !ghosts) stop("out of memory");
    use_loops(T);
    do {
        begin = now();
        fill_start(N_VGetArrayPointer(T));
        solve(T, ghosts, atof(argv[3]), sun);
        seconds = now() - begin;
    } while (begin - first < WARM);
    write_answer(argv[2], N_VGetArrayPointer(T), seconds);
    return 0;
}
