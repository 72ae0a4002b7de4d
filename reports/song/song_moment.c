/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Song 2018, eqs. 10 to 26: the moment matrix of evenly spread particles, what the Taylor expansion leaves out, and
 * the truncation errors that follow.  Computed from the kernel alone, apart from the solver's assembly.
 *
 *   M_kl = sum_j P_k P_l W dV,   P = x, y, x^2/2, y^2/2, xy (SO) or x, y (FO)                              (10, 12)
 *   b~_k - b_k = sum_j (f_j - f_i - sum_l P_l u_l) P_k W dV                                                 (22, 25)
 */
#include "reports/ledger/claim.h"
#include "reports/song/song.h"
#include "solver/space/csr.h"

#include "solver/space/kernel.h"
#include "verification/judge/command.h"
#include "verification/judge/consistency.h"

#include <complex.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { TERMS = 5 };

struct moments {
    double M[TERMS][TERMS], inverse[TERMS][TERMS];
    double left[TERMS]; /* part of b omitted by the expansion */
    double odd;         /* largest moment with an odd power, over that of |x|^a |y|^b */
};

static const double H = 1.1; /* h/dx, section 5.2 */

static void monomials(double x, double y, double P[TERMS]) {
    P[0] = x, P[1] = y, P[2] = x * x / 2, P[3] = y * y / 2, P[4] = x * y;
}

/* f = Im exp(a x + b y + i c) less its expansion to `order`, at a distance (x, y) from the origin. */
static double remainder_of(int order, double x, double y) {
    const double complex a = 0.3 + 1.1 * I, b = -0.2 + 0.7 * I, f = cexp(0.4 * I), z = a * x + b * y;
    double complex kept = 1 + z + (order == 2 ? z * z / 2 : 0);
    return cimag(f * (cexp(z) - kept));
}

static void invert(struct moments *m, int terms) {
    double copy[TERMS * TERMS], out[TERMS * TERMS];
    gsl_matrix_view A = gsl_matrix_view_array(copy, (size_t)terms, (size_t)terms);
    gsl_matrix_view B = gsl_matrix_view_array(out, (size_t)terms, (size_t)terms);
    gsl_permutation *p = gsl_permutation_alloc((size_t)terms);
    int sign;
    for (int k = 0; k < terms; k++)
        for (int l = 0; l < terms; l++) copy[k * terms + l] = m->M[k][l];
    gsl_linalg_LU_decomp(&A.matrix, p, &sign);
    gsl_linalg_LU_invert(&A.matrix, p, &B.matrix);
    gsl_permutation_free(p);
    for (int k = 0; k < terms; k++)
        for (int l = 0; l < terms; l++) m->inverse[k][l] = out[k * terms + l];
}

/* `scatter` (in dx) moves each neighbour, as jitter does. */
static struct moments moments_at(int order, double dx, double scatter) {
    struct moments m = {.odd = 0};
    int terms = order == 2 ? TERMS : 2, reach = (int)ceil(2 * H);
    double odd = 0, size = 0;
    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++) {
            double P[TERMS], x = dx * (i + scatter * sin(7.1 * i + 3.3 * j)),
                             y = dx * (j + scatter * cos(5.7 * i - j));
            double s = hypot(x, y) / (H * dx);
            if ((i == 0 && j == 0) || s >= 2) continue;
            double W = kernel_value(KERNEL_CUBIC, 2, s) / (H * H); /* times dV = dx^2 */
            monomials(x, y, P);
            for (int k = 0; k < terms; k++) {
                double Wk = P[k] * W;
                for (int l = 0; l < terms; l++) m.M[k][l] += P[l] * Wk;
                m.left[k] += remainder_of(order, x, y) * Wk;
            }
            odd += x * y * y * W;
            size += fabs(x * y * y) * W;
        }
    m.odd = fabs(odd) / size;
    invert(&m, terms);
    return m;
}

/* Eq. 18, and that M is symmetric. */
void song_moment_odd_moments(struct claims_measured *m) {
    struct moments even = moments_at(2, 0.1, 0), scattered = moments_at(2, 0.1, 0.2);
    claim_number(m, even.odd, "", "odd moment over its size, lattice");
    claim_number(m, scattered.odd, "", "the same, particles scattered by 0.2 dx");
    claim_decide(m, even.odd <= 1e-14, 1, "odd moments cancel to rounding (1e-14) on a lattice");
}

void song_moment_symmetric(struct claims_measured *m) {
    double worst = 0, least = INFINITY;
    for (int i = 0; i < 2; i++) {
        struct moments s = moments_at(2, 0.1, 0.3 * i);
        for (int k = 0; k < TERMS; k++) {
            for (int l = 0; l < TERMS; l++)
                worst = fmax(worst, fabs(s.M[k][l] - s.M[l][k]) / sqrt(s.M[k][k] * s.M[l][l]));
            least = fmin(least, s.inverse[k][k] * s.M[k][k]);
        }
    }
    claim_number(m, worst, "", "largest |M_kl - M_lk| over sqrt(M_kk M_ll), lattice and scattered");
    claim_decide(m, worst <= 1e-15, least > 0, "symmetric to rounding (1e-15), on a lattice and off it");
}

/* log2 of the ratio at dx = 0.1 and 0.05 */
static double power(double coarse, double fine) {
    return log2(fabs(coarse / fine));
}

/* Eqs. 20, 21, 24: exponents of the entries of M and of its inverse. */
void song_moment_scaling(struct claims_measured *m) {
    int order = atoi(m->argument), terms = order == 2 ? TERMS : 2;
    struct moments a = moments_at(order, 0.1, 0), b = moments_at(order, 0.05, 0);
    double worst = 0, outside = 0;
    for (int k = 0; k < terms; k++)
        for (int l = 0; l < terms; l++) {
            double claimed = (k < 2 ? 1 : 2) + (l < 2 ? 1 : 2), size = sqrt(a.M[k][k] * a.M[l][l]);
            int block = k == l || (k + l == 5 && k != 1 && l != 1);
            if (!block) {
                outside = fmax(outside, fabs(a.M[k][l]) / size);
                continue;
            }
            worst = fmax(worst, fabs(power(a.M[k][l], b.M[k][l]) - claimed));
            worst = fmax(worst, fabs(power(a.inverse[k][l], b.inverse[k][l]) + claimed));
        }
    claim_number(m, worst, "", "exponents off by at most");
    claim_number(m, outside, "", "largest entry outside of the blocks, relative");
    claim_decide(m, worst <= 1e-9 && outside <= 1e-14, 1, "exponents to 1e-9, blocks to rounding (1e-14)");
}

/* Eqs. 22, 25: exponents of the truncated terms of the expansion. */
void song_moment_left_out(struct claims_measured *m) {
    int order = atoi(m->argument), terms = order == 2 ? TERMS : 2, held = 1;
    struct moments a = moments_at(order, 0.02, 0), b = moments_at(order, 0.01, 0);
    for (int k = 0; k < terms; k++) {
        double measured = power(a.left[k], b.left[k]), claimed = k < 2 ? 4 : 6;
        claim_number(m, measured, "", "exponent of row %d", k + 1);
        held &= fabs(measured - claimed) <= 0.1;
    }
    claim_decide(m, held, 1, "exponents 4 for the first derivatives, 6 for the second, +- 0.1");
}

/* Eqs. 23, 26: "METHOD", the order of its derivatives of a smooth function in 1D and in 2D. */
void song_moment_truncation(struct claims_measured *m) {
    static const char *const scene[] = {"rod-gauss", "square-step"};
    int held = 1;
    for (int dim = 1; dim <= 2; dim++) {
        double dx[5], error[5];
        char line[80];
        struct command r;
        struct failure why;
        snprintf(line, sizeof line, "run %s %s --dx 0.1 --h 1.1", scene[dim - 1], m->argument);
        int status = command_read(line, &r, &why);
        for (int i = 0; i < 5 && !status; i++) {
            r.experiment.options.dx = dx[i] = 0.4 / (1 << i);
            status = consistency_error(&r.experiment, &error[i], &why);
        }
        command_free(&r);
        if (status && claim_fail(m, why.text)) return;
        int holds;
        struct judged rungs = {.x = dx, .error = error, .n = 5};
        claim_number(m, slope_fit(dx, error, 5).value, "", "order of the truncation error, %dD", dim);
        if (claim_judge(&holds, m, &rungs, 1.9, 2.1)) return;
        held &= holds;
    }
    claim_decide(m, held, 1, "second order +- 0.1 for a smooth function on a lattice, by the rule of the gates");
}

/* The largest |L x| and |L y| of an operator, in kappa/dx, away from the walls.  NaN where it fails. */
static double of_linear(const char *method, struct claims_measured *m) {
    struct model_problem b;
    struct cloud c;
    struct heat_operator a;
    struct row r;
    struct failure why;
    double most = 0;
    if (claim_model(&b, NULL, m, "limit %s --dim 2 --layout jitter --jitter 0.2 --seed 3", method)) return NAN;
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    if (model_problem_cloud(&b, &p, &c, &why)) return claim_fail(m, why.text), NAN;
    if (operator_create_csr(&a, &p, &b.options, b.method->scheme, &c, 1, &why)) {
        layout_cloud_free(&c);
        return claim_fail(m, why.text), NAN;
    }
    double inside = 2 * KERNEL_SUPPORT * b.options.h; /* support of two sweeps */
    csr_row_create(&r, a.n);
    for (size_t i = 0; i < a.n; i++) {
        double sum[2] = {0, 0};
        if (fmin(fmin(c.x[i] - p.lo[0], p.hi[0] - c.x[i]), fmin(c.y[i] - p.lo[1], p.hi[1] - c.y[i])) < inside)
            continue;
        operator_row_take(&a, i, &r);
        for (size_t k = 0; k < r.n; k++)
            sum[0] += r.value[r.column[k]] * (c.x[r.column[k]] - c.x[i]),
                sum[1] += r.value[r.column[k]] * (c.y[r.column[k]] - c.y[i]);
        most = fmax(most, fmax(fabs(sum[0]), fabs(sum[1])));
    }
    csr_row_free(&r);
    operator_free(&a);
    layout_cloud_free(&c);
    claim_number(m, most, "kappa/dx", "largest |L x|, %s", method);
    return most;
}

/* "METHOD | ... | + METHOD": none is exact for a linear temperature on a cloud, the last is. */
void song_moment_completeness(struct claims_measured *m) {
    char part[40];
    int none = 1, last = 1;
    while (claim_part(&m->argument, part, sizeof part)) {
        const char *method = part + (*part == '+');
        double most = of_linear(method, m);
        if (isnan(most)) return;
        if (*part == '+')
            last &= most <= 1e-11;
        else
            none &= most >= 0.01;
    }
    claim_decide(m, none && last, 1,
                 "L x of the first three at least 0.01 kappa/dx somewhere, that of the last 0 to rounding (1e-11)");
}
