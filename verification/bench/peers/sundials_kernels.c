/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Vector kernels for SUNDIALS' serial vectors, compiled with optimisation and with threads: distributions compile the
 * library's own without. */
#include "verification/bench/peers/sundials_kernels.h"

#include "verification/bench/peers/peer_rectangle.h"

#include <math.h>
#include <nvector/nvector_serial.h>

#define LENGTH(v) ((size_t)N_VGetLength_Serial(v))
#define ARRAY(v) N_VGetArrayPointer_Serial(v)
#define EACH(n, statement)                                                                                           \
    _Pragma("omp parallel for simd if (n >= RECTANGLE_FEW)") for (size_t i = 0; i < n; i++) {                        \
        statement;                                                                                                   \
    }

static void linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z) {
    const double *p = ARRAY(x), *q = ARRAY(y);
    double *r = ARRAY(z);
    size_t n = LENGTH(x);
    if (r == p && a == 1) {
        EACH(n, r[i] += b * q[i])
    } else if (r == q && b == 1) {
        EACH(n, r[i] += a * p[i])
    } else {
        EACH(n, r[i] = a * p[i] + b * q[i])
    }
}

static void constant(realtype c, N_Vector z) {
    double *r = ARRAY(z);
    size_t n = LENGTH(z);
    EACH(n, r[i] = c)
}

#define OF_ONE(name, parameters, value)                                                                              \
    static void name parameters {                                                                                    \
        const double *p = ARRAY(x);                                                                                  \
        double *r = ARRAY(z);                                                                                        \
        size_t n = LENGTH(x);                                                                                        \
        EACH(n, r[i] = value)                                                                                        \
    }

OF_ONE(magnitude, (N_Vector x, N_Vector z), fabs(p[i]))
OF_ONE(inverse, (N_Vector x, N_Vector z), 1 / p[i])
OF_ONE(scale, (realtype c, N_Vector x, N_Vector z), c *p[i])
OF_ONE(add_constant, (N_Vector x, realtype b, N_Vector z), p[i] + b)

#define OF_TWO(name, value)                                                                                          \
    static void name(N_Vector x, N_Vector y, N_Vector z) {                                                           \
        const double *p = ARRAY(x), *q = ARRAY(y);                                                                   \
        double *r = ARRAY(z);                                                                                        \
        size_t n = LENGTH(x);                                                                                        \
        EACH(n, r[i] = value)                                                                                        \
    }

OF_TWO(product, p[i] * q[i])
OF_TWO(quotient, p[i] / q[i])

static double sum_of_products(size_t n, const double *p, const double *q) {
    double sum = 0;
#pragma omp parallel for simd reduction(+ : sum) if (n >= RECTANGLE_FEW)
    for (size_t i = 0; i < n; i++) sum += p[i] * q[i];
    return sum;
}

static realtype dot(N_Vector x, N_Vector y) {
    return sum_of_products(LENGTH(x), ARRAY(x), ARRAY(y));
}

static realtype weighted_norm(N_Vector x, N_Vector w) {
    const double *p = ARRAY(x), *q = ARRAY(w);
    size_t n = LENGTH(x);
    double sum = 0;
#pragma omp parallel for simd reduction(+ : sum) if (n >= RECTANGLE_FEW)
    for (size_t i = 0; i < n; i++) sum += (p[i] * q[i]) * (p[i] * q[i]);
    return sqrt(sum / (double)n);
}

/* ---- Fused: many vectors in one sweep, by blocks that stay in the cache ---- */

enum { BLOCK = 1024 };

/* z = sum c[k] X[k]; z may be X[0] and no other. */
static int linear_combination(int count, realtype *c, N_Vector *X, N_Vector z) {
    double *r = ARRAY(z);
    size_t n = LENGTH(z);
#pragma omp parallel for if (n >= RECTANGLE_FEW)
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t to = from + BLOCK < n ? from + BLOCK : n;
        const double *first = ARRAY(X[0]);
#pragma omp simd
        for (size_t i = from; i < to; i++) r[i] = c[0] * first[i];
        for (int k = 1; k < count; k++) {
            const double *p = ARRAY(X[k]);
#pragma omp simd
            for (size_t i = from; i < to; i++) r[i] += c[k] * p[i];
        }
    }
    return 0;
}

static int dots(int count, N_Vector x, N_Vector *Y, realtype *product_of) {
    for (int k = 0; k < count; k++) product_of[k] = dot(x, Y[k]);
    return 0;
}

/* Z[k] = c[k] x + Y[k] */
static int scale_add(int count, realtype *c, N_Vector x, N_Vector *Y, N_Vector *Z) {
    for (int k = 0; k < count; k++) linear_sum(c[k], x, 1, Y[k], Z[k]);
    return 0;
}

void sundials_kernels(N_Vector v) {
    v->ops->nvlinearsum = linear_sum;
    v->ops->nvscale = scale;
    v->ops->nvconst = constant;
    v->ops->nvabs = magnitude;
    v->ops->nvinv = inverse;
    v->ops->nvaddconst = add_constant;
    v->ops->nvprod = product;
    v->ops->nvdiv = quotient;
    v->ops->nvdotprod = dot;
    v->ops->nvwrmsnorm = weighted_norm;
    v->ops->nvlinearcombination = linear_combination;
    v->ops->nvdotprodmulti = dots;
    v->ops->nvscaleaddmulti = scale_add;
}
