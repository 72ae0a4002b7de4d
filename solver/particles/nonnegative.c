/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Non-negative least-squares weights.
 *
 * Among all w >= 0 with sum_j w_j P_j = b, the minimum of sum_j w_j^2/W_j is w_j = W_j max(0, z .  P_j), where z
 * minimises the convex function
 *     f(z) = sum_j W_j max(0, z . P_j)^2/2 - b . z,   grad f = sum_j W_j max(0, z . P_j) P_j - b
 * (the dual of the quadratic programme: Boyd & Vandenberghe 2004, section 5.2).  If all z .  P_j are positive, these
 * are the least-squares weights. f is piecewise quadratic, so Newton's method with a line search converges in a few
 * steps.  If b is outside the cone of the P_j, there are no such weights and f has no minimum. */
#include "solver/particles/ssph.h"

#include <math.h>

struct dual {
    size_t n;
    int terms;
    double (*P)[FIT_TERMS_MAX];
    const double *W, *b;
};

static double along(const struct dual *d, size_t j, const double *z) {
    double sum = 0;
    for (int k = 0; k < d->terms; k++) sum += z[k] * d->P[j][k];
    return sum;
}

/* Returns f and sets its gradient. */
static double value(const struct dual *d, const double *z, double *gradient) {
    double f = 0;
    for (int k = 0; k < d->terms; k++) f -= d->b[k] * z[k], gradient[k] = -d->b[k];
    for (size_t j = 0; j < d->n; j++) {
        double s = along(d, j, z);
        if (s <= 0 || d->W[j] <= 0) continue;
        f += d->W[j] * s * s / 2;
        for (int k = 0; k < d->terms; k++) gradient[k] += d->W[j] * s * d->P[j][k];
    }
    return f;
}

/* The step -H^-1 gradient by Cholesky.  H = sum_j W_j P_j P_j^T over the j with z .  P_j >= 0, plus 1e-9 of the
 * others, which keeps it regular if the former do not span.  At z = 0 all j count: the first step is least
 * squares. */
static void newton(const struct dual *d, const double *z, const double *gradient, double *step) {
    double H[FIT_TERMS_MAX][FIT_TERMS_MAX] = {{0}};
    int m = d->terms;
    for (size_t j = 0; j < d->n; j++) {
        double weight = fmax(0, d->W[j]) * (along(d, j, z) >= 0 ? 1 : 1e-9);
        for (int k = 0; k < m; k++)
            for (int l = 0; l <= k; l++) H[k][l] += weight * d->P[j][k] * d->P[j][l];
    }
    for (int k = 0; k < m; k++) {
        for (int l = 0; l <= k; l++) {
            for (int i = 0; i < l; i++) H[k][l] -= H[k][i] * H[l][i];
            H[k][l] = l < k ? H[k][l] / H[l][l] : sqrt(H[k][k]);
        }
        step[k] = -gradient[k];
        for (int l = 0; l < k; l++) step[k] -= H[k][l] * step[l];
        step[k] /= H[k][k];
    }
    for (int k = m - 1; k >= 0; k--) {
        for (int l = k + 1; l < m; l++) step[k] -= H[l][k] * step[l];
        step[k] /= H[k][k];
    }
}

static double largest_entry(const double *v, int m) {
    double most = 0;
    for (int k = 0; k < m; k++) most = fmax(most, fabs(v[k]));
    return most;
}

/* sum_j w_j P_j - b */
static void excess(const struct dual *d, const double *w, double *off) {
    for (int k = 0; k < d->terms; k++) off[k] = -d->b[k];
    for (size_t j = 0; j < d->n; j++)
        for (int k = 0; k < d->terms; k++) off[k] += w[j] * d->P[j][k];
}

/* Iterative refinement of *w: terms of z .  P_j may cancel, and its rounding exceeds that of w_j. */
static void refine(const struct dual *d, const double *z, double *w) {
    enum { TIMES = 2 };
    double off[FIT_TERMS_MAX], step[FIT_TERMS_MAX];
    for (int again = 0; again < TIMES; again++) {
        excess(d, w, off);
        newton(d, z, off, step);
        for (size_t j = 0; j < d->n; j++)
            if (w[j] > 0) w[j] = fmax(0, w[j] + d->W[j] * along(d, j, step));
    }
}

/* One step of the minimisation from *z, with f and its gradient there; halves the step until f decreases
 * (Armijo). */
static double line_search(const struct dual *d, double f, double *z, double *gradient, double enough) {
    enum { HALVINGS = 40 };
    double step[FIT_TERMS_MAX], next[FIT_TERMS_MAX], slope = 0, t = 1;
    newton(d, z, gradient, step);
    for (int k = 0; k < d->terms; k++) slope += gradient[k] * step[k];
    for (int half = 0; half < HALVINGS; half++, t /= 2) {
        for (int k = 0; k < d->terms; k++) next[k] = z[k] + t * step[k];
        double at = value(d, next, gradient);
        if (half == HALVINGS - 1 || at <= f + 1e-4 * t * slope || largest_entry(gradient, d->terms) <= enough) {
            f = at;
            break;
        }
    }
    for (int k = 0; k < d->terms; k++) z[k] = next[k];
    return f;
}

int nonnegative_weights(size_t n, int terms, double P[][FIT_TERMS_MAX], const double *W, const double *b, double *w) {
    enum { STEPS = 100 };
    const struct dual d = {n, terms, P, W, b};
    double z[FIT_TERMS_MAX] = {0}, gradient[FIT_TERMS_MAX], f = value(&d, z, gradient);
    double enough = 1e-9 * largest_entry(b, terms);
    for (int i = 0; i < STEPS && largest_entry(gradient, terms) > enough; i++)
        f = line_search(&d, f, z, gradient, enough);
    for (size_t j = 0; j < n; j++) w[j] = W[j] > 0 ? W[j] * fmax(0, along(&d, j, z)) : 0;
    refine(&d, z, w);
    excess(&d, w, gradient);
    return largest_entry(gradient, terms) <= 1e-3 * enough;
}
