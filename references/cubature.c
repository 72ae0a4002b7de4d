/* Adaptive cubature.
 *
 * On a box of extent h on which f varies over the length l, the Gauss-Legendre rules of 4 and 6 points are off by
 * 5.6e-10 (h/l)^8 and 1.9e-16 (h/l)^12 of f (remainder term; Abramowitz and Stegun 1964, 25.4.30), so where they
 * differ by 1e-10 of f the second is off by 2e-17 (for a Gaussian, whose derivatives grow, by 1e-14).  Elsewhere the
 * box is halved along each axis, until it is too small to count.  A feature that is narrow beside the box falls
 * between the points of both rules; the caller names where such may be, and boxes are graded towards these places by
 * factors of two. */
#include "references/cubature.h"

#include <float.h>
#include <math.h>

enum { GRADES_1D = 40, GRADES_2D = 12, BREAKS = 2 + CUBATURE_KNOTS * (2 * GRADES_1D + 1) };

/* On (-1, 1): the positive nodes and their weights. */
static const double node4[] = {0.3399810435848563, 0.8611363115940526},
                    weight4[] = {0.6521451548625461, 0.3478548451374538};
static const double node6[] = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521},
                    weight6[] = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};

struct integrand {
    struct approx (*f)(const void *data, const double x[2]);
    const void *data;
    int dim;
    double whole; /* the measure of all */
    double size;  /* largest |f| met */
    double error;
};

static struct approx rule(struct integrand *g, const double lo[2], const double hi[2], int n, const double *node,
                          const double *weight) {
    struct approx sum = {0, 0};
    double middle[2] = {(lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2}, half[2] = {hi[0] - middle[0], hi[1] - middle[1]};
    for (int j = 0; j < (g->dim == 2 ? 2 * n : 1); j++)
        for (int i = 0; i < 2 * n; i++) {
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

/* The mean over a box times its share of the whole. */
static double box(struct integrand *g, const double lo[2], const double hi[2]) {
    double share = (hi[0] - lo[0]) * (g->dim == 2 ? hi[1] - lo[1] : 1) / g->whole;
    struct approx coarse = rule(g, lo, hi, 2, node4, weight4), fine = rule(g, lo, hi, 3, node6, weight6);
    double apart = fabs(fine.value - coarse.value), middle[2] = {(lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2}, sum = 0;
    int small = !(middle[0] > lo[0] && middle[0] < hi[0]) || share * apart <= 1e-17 * g->size;
    if (!(apart > 1e-10 * g->size) || apart <= 2 * fine.error || small) { /* a NaN ends it too */
        g->error += share * (fine.error + (small ? apart : 1e-4 * apart));
        return share * fine.value;
    }
    for (int j = 0; j < g->dim; j++)
        for (int i = 0; i < 2; i++) {
            double from[2] = {i ? middle[0] : lo[0], lo[1]}, to[2] = {i ? hi[0] : middle[0], hi[1]};
            if (g->dim == 2) from[1] = j ? middle[1] : lo[1], to[1] = j ? hi[1] : middle[1];
            sum += box(g, from, to);
        }
    return sum;
}

/* Puts x into the ascending list of n breaks between its first and last; how many there are then. */
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
            n = insert(list, n, at - ldexp(hi - lo, -j));
            n = insert(list, n, at + ldexp(hi - lo, -j));
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
        for (int i = 0; i + 1 < n[0]; i++)
            sum += box(&g, (double[2]){list[0][i], list[1][j]}, (double[2]){list[0][i + 1], list[1][j + 1]});
    return (struct approx){sum, g.error + 8 * DBL_EPSILON * g.size};
}
