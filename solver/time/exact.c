/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact solution of the semi-discrete problem dT/dt = A T + g on a lattice.
 *
 * Stencils are even and walls are represented by mirror images, so the sine or cosine transform with the parity of
 * the walls diagonalises A.  The eigenvalues are the symbol at the wave numbers of the transform:
 *
 *     T^(t) = exp(lambda t) T^(0) + t phi(lambda t) g^,   phi(z) = (exp(z) - 1) / z,
 *     lambda = sum_ijk w_ijk cos(i theta_x) cos(j theta_y) cos(k theta_z).
 *
 * In the plane and in space two properties reduce the work below that of two full transforms.  A layer is a row of
 * the plane or a plane of the box, its last axis y or z:
 *   - If elimination shows that the data are a sum of R products of a layer and a function of the last coordinate, R
 *     layers and R lines are transformed instead.
 *   - If few modes survive, only these are evaluated. The amplitude of a mode is at most 2^dim max |T|, so all modes
 *     with exp(lambda t) < eps / (2^dim n) together contribute less than eps max |T| and are dropped. exp(lambda t)
 *     is nearly a product (exactly one for the Laplacian), so the result is again a sum of a few products,
 *     transformed back as layers and lines.
 * Both are tried as long as the operation count of the elimination is below that of FFTW's transform. */
#include "solver/time/stepper.h"

#include "solver/time/products.h"
#include "solver/sweep/state.h"
#include "solver/time/transform.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Decayed modes need no exp.  For z < FAR, exp(z) - 1 has no cancellation. */
static const double GONE = -746, FAR = -1; /* exp(GONE) is zero */

struct modes {
    const struct heat_operator *a;
    const struct lattice *l;
    struct transform *transform;
    double t;                 /* s */
    int last;                 /* axis: z in space, else y (of one particle, for a rod) */
    int n[2];                 /* particles of a layer; layers */
    double *fold;             /* room for the weights of fold() */
    double *versine[DIM_MAX]; /* cos(i theta_k) - 1 times the multiplicity of +-i, at [i n + k] */
};

/* cos x - 1 = -2 sin^2(x/2) has a relative error of a few eps at any x. */
static double *versines(const struct heat_operator *a, int axis) {
    const struct lattice *l = &a->lattice;
    int r = a->reach[axis], n = l->n[axis];
    double *table = xcalloc((size_t)n * (size_t)(r + 1), sizeof *table);
    for (int k = 0; k < n; k++) {
        double theta = l->dim > axis ? transform_angle(l, axis, k) : 0;
        for (int i = 1; i <= r; i++) {
            double half = sin(i * theta / 2);
            table[i * n + k] = -4 * half * half;
        }
    }
    return table;
}

/* Eigenvalues of the modes (k, m), k = 0 .. n[0] - 1, plus `across`, for the quadrant w of weights.  A constant field
 * is steady, so the exact sum of the weights is zero.  Its rounding error, eps kappa/dx^2, would be comparable with
 * the slowest eigenvalues.  Therefore lambda = sum_ij w_ij (cos a cos b - 1), with cos a cos b - 1 = (cos a - 1) cos
 * b + (cos b - 1). */
static void rates(const struct modes *s, const double *w, double across, int m, double *restrict lambda) {
    int rx = s->a->reach[0], ry = s->a->reach[1], nx = s->l->n[0], ny = s->l->n[1];
    for (int i = 0; i <= rx; i++) {
        const double *restrict versine = s->versine[0] + (size_t)i * (size_t)nx;
        double column = 0;
        for (int j = 0; j <= ry; j++) {
            double weight = w[j * (rx + 1) + i], other = s->versine[1][j * ny + m];
            column += weight * ((j ? 2 : 1) + other);
            across += (i ? 2 : 1) * weight * other;
        }
        if (i == 0)
            for (int k = 0; k < nx; k++) lambda[k] = 0;
        else
            for (int k = 0; k < nx; k++) lambda[k] += column * versine[k];
    }
    for (int k = 0; k < nx; k++) lambda[k] += across;
}

/* The quadrant w of the modes with wave number q along z of a box, and the rate of the mode constant in x and y. */
static double fold(const struct modes *s, int q, double *w) {
    const int *reach = s->a->reach, nz = s->l->n[2];
    double across = 0;
    for (int j = 0; j <= reach[1]; j++)
        for (int i = 0; i <= reach[0]; i++, w++) {
            double bent = 0;
            *w = 0;
            for (int k = 0; k <= reach[2]; k++) {
                double weight = s->a->weight[operator_offset(reach, i, j, k)], versine = s->versine[2][k * nz + q];
                *w += weight * ((k ? 2 : 1) + versine);
                bent += weight * versine;
            }
            across += operator_images(i, j, 0) * bent;
        }
    return across;
}

/* Eigenvalues of the modes of a layer, with wave number q along the last axis. */
static void layer_rates(const struct modes *s, int q, double *lambda) {
    if (s->last == 1) {
        rates(s, s->a->weight, 0, q, lambda);
        return;
    }
    double across = fold(s, q, s->fold);
    for (int m = 0; m < s->l->n[1]; m++) rates(s, s->fold, across, m, lambda + m * s->l->n[0]);
}

static double decay(double z) {
    return z < GONE ? 0 : exp(z);
}

static double phi(double z) {
    return z < FAR ? (decay(z) - 1) / z : fabs(z) > 1e-12 ? expm1(z) / z : 1;
}

/* ---- Data that are a sum of products, few surviving modes ---- */

/* Largest number of products for which elimination costs less than a transform.  R products cost (R + 1) (R + 2)
 * operations for each value searched and 2 R for each value assembled, two values at a time; FFTW processes one line
 * at a time. */
static int worthwhile(const struct modes *s, double searched) {
    double flops = transform_flops(s->transform);
    int R = 0;
    while ((R + 2) * (R + 3) * searched / 2 + R + 1 <= flops) R++;
    return R;
}

static void transform_factors(const struct modes *s, struct products *p,
                              void (*way)(const struct transform *, int, int, double *)) {
    for (int r = 0; r < p->rank; r++) {
        way(s->transform, 0, s->last - 1, p->factor[0] + (size_t)r * (size_t)p->n[0]);
        way(s->transform, s->last, s->last, p->factor[1] + (size_t)r * (size_t)p->n[1]);
    }
}

/* Returns 1 and the transform of F as products if F is a sum of few products; else 0. */
static int product_transform(const struct modes *s, const double *F, struct products *p) {
    if (s->l->dim < 2 || !products_split(F, s->n, 4 * DBL_EPSILON, worthwhile(s, 1), p)) return 0;
    transform_factors(s, p, transform_axes_forward);
    return 1;
}

static double largest_magnitude(const double *x, int n) {
    double most = 0;
    for (int i = 0; i < n; i++) most = fmax(most, fabs(x[i]));
    return most;
}

/* Clears keep[axis][k] if every mode of the data *p with this wave number is below round-off of the largest: modes
 * of the opposite parity, for data even or odd about the middle. */
static void drop_absent(const struct products *p, int axis, int *keep) {
    int n = p->n[axis], across = p->n[1 - axis];
    double *size = xcalloc((size_t)n, sizeof *size);
    for (int r = 0; r < p->rank; r++) {
        double other = largest_magnitude(p->factor[1 - axis] + r * across, across);
        for (int k = 0; k < n; k++) size[k] += other * fabs(p->factor[axis][r * n + k]);
    }
    double most = largest_magnitude(size, n);
    for (int k = 0; k < n; k++) keep[k] &= size[k] > DBL_EPSILON * most;
    free(size);
}

/* Exponent lambda t below which a mode is dropped. */
static double least_exponent(const struct modes *s) {
    return log(DBL_EPSILON / (1 << s->l->dim) / s->n[0] / s->n[1]);
}

/* Modes of a layer and wave numbers along the last axis with at least one surviving mode, keep[0] and keep[1], and
 * their counts. */
static void survivors(const struct modes *s, const struct products *p, int *keep[2], int count[2]) {
    double *lambda = xcalloc((size_t)s->n[0], sizeof *lambda), least = least_exponent(s) / s->t;
    for (int q = 0; q < s->n[1]; q++) keep[1][q] = 1;
    drop_absent(p, 1, keep[1]);
    for (int q = 0; q < s->n[1]; q++) {
        int any = 0;
        if (!keep[1][q]) continue;
        layer_rates(s, q, lambda);
        for (int k = 0; k < s->n[0]; k++) {
            int survives = !(lambda[k] < least);
            any += survives;
            keep[0][k] |= survives;
        }
        keep[1][q] = any > 0;
    }
    free(lambda);
    drop_absent(p, 0, keep[0]);
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < s->n[side]; k++)
            if (keep[side][k]) keep[side][count[side]++] = k; /* the list overwrites the marks */
}

/* Amplitudes at time t of the modes keep[0] x keep[1] of the data *p. */
static void amplitudes(const struct modes *s, const struct products *p, int *const keep[2], const int count[2],
                       double *C) {
    double *lambda = xcalloc((size_t)s->n[0], sizeof *lambda), scale = 1 / transform_scale(s->l);
    double least = least_exponent(s);
    for (int m = 0; m < count[1]; m++) {
        layer_rates(s, keep[1][m], lambda);
        for (int k = 0; k < count[0]; k++) {
            double sum = 0, z = lambda[keep[0][k]] * s->t;
            if (z < least) continue;
            for (int r = 0; r < p->rank; r++)
                sum += p->factor[0][r * p->n[0] + keep[0][k]] * p->factor[1][r * p->n[1] + keep[1][m]];
            C[(size_t)m * (size_t)count[0] + (size_t)k] = scale * exp(z) * sum;
        }
    }
    free(lambda);
}

/* Expands the factors of the kept modes to all modes. */
static struct products spread(const struct products *few, int *const keep[2], const int n[2]) {
    struct products all = {.rank = few->rank, .n = {n[0], n[1]}};
    for (int axis = 0; axis < 2; axis++) {
        all.factor[axis] = xcalloc((size_t)few->rank * (size_t)n[axis], sizeof **all.factor);
        for (int r = 0; r < few->rank; r++)
            for (int k = 0; k < few->n[axis]; k++)
                all.factor[axis][r * n[axis] + keep[axis][k]] = few->factor[axis][r * few->n[axis] + k];
    }
    return all;
}

/* T at time t.  Returns 0 and leaves T unchanged if it is not a sum of few products. */
static int evolve_few(const struct modes *s, const struct products *start, double *T) {
    int *keep[2], count[2] = {0, 0};
    const int *n = s->n;
    for (int side = 0; side < 2; side++) keep[side] = xcalloc((size_t)n[side], sizeof **keep);
    survivors(s, start, keep, count);
    double all = (double)count[0] * count[1];
    double *C = xcalloc((size_t)count[0] * (size_t)count[1], sizeof *C);
    struct products few;
    amplitudes(s, start, keep, count, C);
    int found = products_split(C, count, DBL_EPSILON, worthwhile(s, all / n[0] / n[1]), &few);
    if (found) {
        struct products end = spread(&few, keep, n);
        transform_factors(s, &end, transform_axes_backward);
        products_join(&end, T);
        products_free(&end);
        products_free(&few);
    }
    free(C);
    for (int side = 0; side < 2; side++) free(keep[side]);
    return found;
}

/* ---- All modes ---- */

/* F becomes its coefficients; *p is its transform as products, or NULL. */
static void coefficients(const struct modes *s, const struct products *p, double *F) {
    if (p)
        products_join(p, F);
    else
        transform_forward(s->transform, F);
}

/* Advances the coefficients T by the time t; g are the coefficients of the source, or NULL. */
static void advance_all(const struct modes *s, double *T, const double *g) {
    double *lambda = xcalloc((size_t)s->n[0], sizeof *lambda), scale = 1 / transform_scale(s->l);
    size_t at = 0;
    for (int q = 0; q < s->n[1]; q++) {
        layer_rates(s, q, lambda);
        for (int k = 0; k < s->n[0]; k++, at++) {
            double z = lambda[k] * s->t, mode = decay(z) * T[at];
            if (g) mode += s->t * phi(z) * g[at];
            T[at] = scale * mode;
        }
    }
    free(lambda);
}

static void evolve_all(const struct modes *s, const struct products *start, double *T) {
    double *g = NULL;
    if (s->a->g) {
        struct products p;
        g = xcalloc(s->a->n, sizeof *g);
        state_store(s->a, s->a->g, g);
        int product = product_transform(s, g, &p);
        coefficients(s, product ? &p : NULL, g);
        if (product) products_free(&p);
    }
    coefficients(s, start, T);
    advance_all(s, T, g);
    transform_backward(s->transform, T);
    free(g);
}

/* Advances T, in the particles' order, from 0 to t (s). */
static void evolve(const struct heat_operator *a, double t, double *T) {
    const struct lattice *l = &a->lattice;
    struct modes s = {.a = a, .l = l, .t = t, .last = l->dim < 3 ? 1 : 2, .transform = transform_create(l)};
    struct products start;
    s.n[0] = s.last == 1 ? l->n[0] : l->n[0] * l->n[1], s.n[1] = l->n[s.last];
    s.fold = xcalloc(operator_offset(a->reach, a->reach[0], a->reach[1], 0) + 1, sizeof *s.fold);
    for (int axis = 0; axis < DIM_MAX; axis++) s.versine[axis] = versines(a, axis);
    int product = product_transform(&s, T, &start);
    if (!(product && !a->g && evolve_few(&s, &start, T))) evolve_all(&s, product ? &start : NULL, T);
    if (product) products_free(&start);
    for (int axis = 0; axis < DIM_MAX; axis++) free(s.versine[axis]);
    free(s.fold);
    transform_free(s.transform);
}

static int needs(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                 struct failure *why) {
    (void)p, (void)o, (void)s;
    for (int side = 0; side < 2 * l->dim; side++)
        if (l->sign[side] == LAYOUT_RECURRENCE && l->n[side / 2] > TRANSFORM_TABLE_MOST)
            return refuse(why, STATUS_NOT_APPLICABLE,
                          "--stepper exact: %d particles along an axis with a wall that exchanges heat; its modes "
                          "need a table of n x n, at most %d",
                          l->n[side / 2], TRANSFORM_TABLE_MOST);
    for (int a = 0; a < l->dim; a++)
        if (l->shift[2 * a] > 0 && l->shift[2 * a + 1] > 0 && l->n[a] < 2)
            return refuse(why, STATUS_NOT_APPLICABLE, "--stepper exact: needs two particles along an insulated axis");
    return STATUS_OK;
}

static int plan(const struct problem *p, const struct options *o, const struct scheme *s,
                const struct heat_operator *a, struct march *m, struct failure *why) {
    (void)p, (void)o, (void)s, (void)a, (void)why;
    m->steps = m->stages = 0;
    return STATUS_OK;
}

const struct stepper stepper_exact = {.name = "exact",
                                      .about = "exp(tA) by one pair of FFTs: one stencil, mirror walls",
                                      .needs = needs,
                                      .plan = plan,
                                      .evolve = evolve};
