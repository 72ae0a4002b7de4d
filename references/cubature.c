/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive cubature: Gauss-Legendre rules of 6 points per axis on a box and on its halves along each axis.
 *
 * On a box of extent h, for f that varies over the length l, the error of the rule is 1.9e-16 (h/l)^12 of f
 * (remainder term; Abramowitz and Stegun 1964, 25.4.30); on the halves it is 4096 times smaller.  If the two results
 * differ by at most 1e-14 of f, the result of the halves is accepted and the difference is its error estimate.  This
 * estimate is 4096 times too large unless the errors of the parts cancel.  Otherwise the halves become boxes
 * themselves, until they are too small to matter.
 *
 * The rule misses features that are narrow compared with the box.  The caller lists the places of such features, and
 * boxes are graded towards them by factors of four. */
#include "references/cubature.h"

#include <float.h>
#include <math.h>

enum { GRADES_1D = 20, GRADES_2D = 12, BREAKS = 2 + CUBATURE_KNOTS * (2 * GRADES_1D + 1) };

enum { POINTS = 6 };
/* Positive nodes and weights of the rule on (-1, 1). */
static const double node[] = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521},
                    weight[] = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};

struct integrand {
    struct approx (*f)(const void *data, const double x[2]);
    const void *data;
    int dim;
    double whole; /* length or area of the domain */
    double size;  /* largest |f| sampled */
    double error;
};

static struct approx rule(struct integrand *g, const double lo[2], const double hi[2]) {
    struct approx sum = {0, 0};
    double middle[2] = {(lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2}, half[2] = {hi[0] - middle[0], hi[1] - middle[1]};
    for (int j = 0; j < (g->dim == 2 ? POINTS : 1); j++)
        for (int i = 0; i < POINTS; i++) {
            double x[2] = {middle[0] + (i % 2 ? half[0] : -half[0]) * node[i / 2], middle[1]}, w = weight[i / 2] / 2;
            if (g->dim == 2) {
                x[1] += (j % 2 ? half[1] : -half[1]) * node[j / 2];
                w *= weight[j / 2] / 2;
            }
            struct approx value = g->f(g->data, x);
            g->size = fmax(g->size, fabs(value.value));
            sum.value += w * value.value;
            sum.error += w * value.error;
        }
    return sum;
}

/* Part k of a box, halved along each axis. */
static void part(const struct integrand *g, const double lo[2], const double hi[2], int k, double from[2],
                 double to[2]) {
    for (int a = 0; a < 2; a++) {
        double middle = (lo[a] + hi[a]) / 2;
        int upper = k >> a & 1;
        from[a] = a < g->dim && upper ? middle : lo[a];
        to[a] = a < g->dim && !upper ? middle : hi[a];
    }
}

/* Mean over a box times its fraction of the domain; `once` is the rule on the whole box. */
static double box(struct integrand *g, const double lo[2], const double hi[2], struct approx once) {
    const int parts = 1 << g->dim;
    double share = (hi[0] - lo[0]) * (g->dim == 2 ? hi[1] - lo[1] : 1) / g->whole, from[2], to[2], sum = 0;
    struct approx of[4], mean = {0, 0};
    for (int k = 0; k < parts; k++) {
        part(g, lo, hi, k, from, to);
        of[k] = rule(g, from, to);
        mean.value += of[k].value / parts, mean.error += of[k].error / parts;
    }
    double apart = fabs(mean.value - once.value), middle = (lo[0] + hi[0]) / 2;
    int small = !(middle > lo[0] && middle < hi[0]) || share * apart <= 1e-17 * g->size;
    if (!(apart > 1e-14 * g->size) || apart <= 2 * mean.error || small) { /* true for a NaN as well */
        g->error += share * (mean.error + apart);
        return share * mean.value;
    }
    for (int k = 0; k < parts; k++) {
        part(g, lo, hi, k, from, to);
        sum += box(g, from, to, of[k]);
    }
    return sum;
}

/* Inserts x into the ascending list of n breaks if it is inside their range; returns the new count. */
static int insert(double *list, int n, double x) {
    int at = n - 1;
    if (!(x > list[0] && x < list[n - 1])) return n;
    while (list[at - 1] > x) at--;
    if (list[at - 1] == x) return n;
    for (int i = n; i > at; i--) list[i] = list[i - 1];
    list[at] = x;
    return n + 1;
}

static int breaks(double lo, double hi, const struct cubature_knots *knots, int axis, int grades, double *list) {
    int n = 2;
    list[0] = lo, list[1] = hi;
    for (int k = 0; k < knots->count[axis]; k++) {
        double at = knots->knot[axis][k].at;
        if (!(at >= lo && at <= hi)) continue;
        n = insert(list, n, at);
        for (int j = 1; j <= grades && knots->knot[axis][k].graded; j++) {
            n = insert(list, n, at - ldexp(hi - lo, -2 * j));
            n = insert(list, n, at + ldexp(hi - lo, -2 * j));
        }
    }
    return n;
}

struct approx cubature_mean(struct approx (*f)(const void *data, const double x[2]), const void *data, int dim,
                            const double lo[2], const double hi[2], const struct cubature_knots *knots) {
    double list[2][BREAKS], sum = 0;
    int n[2] = {2, 2}, grades = dim == 2 ? GRADES_2D : GRADES_1D;
    if (knots->grades > 0 && knots->grades < grades) grades = knots->grades;
    struct integrand g = {f, data, dim, (hi[0] - lo[0]) * (dim == 2 ? hi[1] - lo[1] : 1), 0, 0};
    if (!(g.whole > 0)) return f(data, lo);
    for (int a = 0; a < dim; a++) n[a] = breaks(lo[a], hi[a], knots, a, grades, list[a]);
    if (dim == 1) list[1][0] = list[1][1] = lo[1];
    for (int j = 0; j + 1 < n[1]; j++)
        for (int i = 0; i + 1 < n[0]; i++) {
            double from[2] = {list[0][i], list[1][j]}, to[2] = {list[0][i + 1], list[1][j + 1]};
            sum += box(&g, from, to, rule(&g, from, to));
        }
    return (struct approx){sum, g.error + 8 * DBL_EPSILON * g.size};
}
