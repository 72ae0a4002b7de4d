/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive cubature: Gauss-Legendre rules of 6 points per axis (4 for a cell in space) on a box and on its halves
 * along each axis.
 *
 * On a box of extent h, for f that varies over the length l, the error of the rule is 1.9e-16 (h/l)^12 of f with 6
 * points, 5.6e-10 (h/l)^8 with 4 (remainder term; Abramowitz and Stegun 1964, 25.4.30); on the halves it is 4096 or
 * 256 times smaller.  If the two results differ by at most 1e-14 of f (1e-11 in space), the result of the halves is
 * accepted and the difference is its error estimate, by the same factor too large unless the errors of the parts
 * cancel.  Otherwise the halves become boxes themselves, until they are too small to matter.  A whole body in space,
 * with an accuracy of 1e-10, takes 6 points: then h/l may be 3, and 0.8 with 4 points.
 *
 * A cell of a mesh is accepted without halves if the rule of fewer points agrees: of 4 points in the plane, h/l <
 * 0.25 (52 values in place of 180), of 3 in space, error 5e-7 (h/l)^6, h/l < 0.16 (91 in place of 576).  The rule
 * itself is then exact to rounding.
 *
 * The rule misses features that are narrow compared with the box.  The caller lists the places of such features, and
 * boxes are graded towards them by factors of four. */
#include "references/cubature.h"

#include <float.h>
#include <math.h>

enum { GRADES_1D = 20, GRADES = 12, BREAKS = 2 + CUBATURE_KNOTS * (2 * GRADES_1D + 1) };

/* Positive nodes and weights on (-1, 1). */
static const struct rule {
    int points;
    double node[3], weight[3];
} six = {6,
         {0.2386191860831969, 0.6612093864662645, 0.9324695142031521},
         {0.4679139345726910, 0.3607615730481386, 0.1713244923791704}},
  four = {4, {0.3399810435848563, 0.8611363115940526}, {0.6521451548625461, 0.3478548451374539}},
  three = {3, {0.7745966692414834, 0}, {0.5555555555555556, 0.8888888888888889}};

struct integrand {
    struct approx (*f)(const void *data, const double *x);
    const void *data;
    int dim;
    const struct rule *rule, *fewer; /* fewer: of a cell, else NULL */
    double accuracy;
    double whole; /* length, area or volume of the domain */
    double size;  /* largest |f| sampled */
    double error;
};

static struct approx rule(struct integrand *g, const struct rule *r, const double *lo, const double *hi) {
    struct approx sum = {0, 0};
    int all = r->points * (g->dim > 1 ? r->points : 1) * (g->dim > 2 ? r->points : 1);
    for (int k = 0; k < all; k++) {
        double x[DIM_MAX] = {0}, w = 1;
        for (int a = 0, rest = k; a < g->dim; a++, rest /= r->points) {
            double middle = (lo[a] + hi[a]) / 2, half = hi[a] - middle;
            int i = rest % r->points;
            x[a] = middle + (i % 2 ? half : -half) * r->node[i / 2];
            w *= r->weight[i / 2] / 2;
        }
        struct approx value = g->f(g->data, x);
        g->size = fmax(g->size, fabs(value.value));
        sum.value += w * value.value;
        sum.error += w * value.error;
    }
    return sum;
}

/* Part k of a box, halved along each axis. */
static void part(const struct integrand *g, const double *lo, const double *hi, int k, double *from, double *to) {
    for (int a = 0; a < g->dim; a++) {
        double middle = (lo[a] + hi[a]) / 2;
        int upper = k >> a & 1;
        from[a] = upper ? middle : lo[a];
        to[a] = upper ? hi[a] : middle;
    }
}

static double volume(const double *lo, const double *hi, int dim) {
    double v = hi[0] - lo[0];
    for (int a = 1; a < dim; a++) v *= hi[a] - lo[a];
    return v;
}

/* Mean over a box times its fraction of the domain; `once` is the rule on the whole box. */
static double box(struct integrand *g, const double *lo, const double *hi, struct approx once) {
    const int parts = 1 << g->dim;
    double share = volume(lo, hi, g->dim) / g->whole, from[DIM_MAX], to[DIM_MAX], sum = 0;
    struct approx of[1 << DIM_MAX], mean = {0, 0};
    double rough = g->fewer ? fabs(once.value - rule(g, g->fewer, lo, hi).value) : INFINITY;
    if (rough <= g->accuracy * g->size) {
        g->error += share * (once.error + rough);
        return share * once.value;
    }
    for (int k = 0; k < parts; k++) {
        part(g, lo, hi, k, from, to);
        of[k] = rule(g, g->rule, from, to);
        mean.value += of[k].value / parts, mean.error += of[k].error / parts;
    }
    double apart = fabs(mean.value - once.value), middle = (lo[0] + hi[0]) / 2;
    int small = !(middle > lo[0] && middle < hi[0]) || share * apart <= 1e-17 * g->size;
    if (!(apart > g->accuracy * g->size) || apart <= 2 * mean.error || small) { /* true for a NaN as well */
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

struct approx cubature_mean(struct approx (*f)(const void *data, const double *x), const void *data, int dim,
                            const double *lo, const double *hi, const struct cubature_knots *knots) {
    double list[DIM_MAX][BREAKS], sum = 0;
    int n[DIM_MAX] = {2, 2, 2}, grades = dim == 1 ? GRADES_1D : GRADES, boxes = 1;
    if (knots->grades > 0 && knots->grades < grades) grades = knots->grades;
    double accuracy = knots->accuracy > 0 ? knots->accuracy : dim == 3 ? 1e-11 : 1e-14;
    struct integrand g = {.f = f, .data = data, .dim = dim, .accuracy = accuracy, .whole = volume(lo, hi, dim)};
    g.rule = dim == 3 && !(accuracy > 1e-11) ? &four : &six;
    if (knots->cell) g.fewer = dim == 3 ? &three : &four;
    if (!(g.whole > 0)) return f(data, lo);
    for (int a = 0; a < dim; a++) {
        n[a] = breaks(lo[a], hi[a], knots, a, grades, list[a]);
        boxes *= n[a] - 1;
    }
    for (int k = 0; k < boxes; k++) {
        double from[DIM_MAX], to[DIM_MAX];
        for (int a = 0, rest = k; a < dim; rest /= n[a++] - 1)
            from[a] = list[a][rest % (n[a] - 1)], to[a] = list[a][rest % (n[a] - 1) + 1];
        sum += box(&g, from, to, rule(&g, g.rule, from, to));
    }
    return (struct approx){sum, g.error + 8 * DBL_EPSILON * g.size};
}
