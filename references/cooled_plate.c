/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A plate with one hot, one insulated and two cooled sides: early-time form and modes.
 *
 * The modes are cos(p x) with p W tan(p W) = h W and sin(r y) with r H cot(r H) = -h H.  Their integrals are I_m and
 * J_n, the integrals of their squares N_m and M_n.  The initial data at 1 decay as a product of two slabs (at early
 * times, of two half lines),
 *
 *     X(x, t) Y(y, t),  X = sum_m I_m/N_m cos(p x) exp(-kappa p^2 t),  Y = sum_n J_n/M_n sin(r y) exp(-kappa r^2 t).
 *
 * With u = d/dt of the half line y > 0 heated to 1 at y = 0, the response to the hot side is
 *
 *     F(t) = int_0^t u(y, t') X(x, t') dt'                                                              (Duhamel)
 *     F(t) = F(inf) - sum_mn C_mn cos(p x) sin(r y) exp(-kappa (p^2 + r^2) t),  C = r I_m/(N_m M_n (p^2 + r^2)).
 *
 * Green's second identity gives C from the hot side alone.  Neither form is efficient everywhere: the integral needs
 * half lines, while the sum and F(inf) converge slowly near the corner (W, 0).  The difference from an early time t0
 * converges fast:
 *
 *     F(t) = F(t0) + sum_mn C_mn cos(p x) sin(r y) (exp(-kappa (p^2 + r^2) t0) - exp(-kappa (p^2 + r^2) t)).
 *
 * The choice s0 = sqrt(4 kappa t0) = 0.16 of the shorter extent makes the influence of one end on the other
 * negligible (erfc(1/0.16) = 1e-18).  Significant modes have kappa (p^2 + r^2) t0 < 41.5, a quarter ellipse of 4.1
 * W/s0 by 4.1 H/s0.  With z = y/sqrt(4 kappa t') and d = W - x,
 *
 *     F(t0) = erfc(y/s0) - 2/sqrt(pi) int_{y/s0}^inf exp(-z^2) (1 - X(d, s = y/z)) dz,
 *
 * where X is cooling_half.  The integrand is negligible for s < d/6.1 and for s < y/6.1.  The quadrature uses panels
 * of length 1 in log s from s0 down, with 16 Gauss points each.  The integrand is analytic within pi/4 of the axis,
 * so the error is 3.4^-32 = 1e-17.  All points use the same panels, so each term is the product of a factor of x and
 * a factor of y.  Points of a lattice share these factors and the sums over m of each column.
 *
 * Restrictions: isotropic; the same h on both cooled sides. */
#include "references/cooled_plate.h"

#include "references/cooling.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_integration.h>

static const double last_exponent = 41.5, reach = 6.1;
enum { NODES = COOLED_PLATE_NODES, KEPT = 8 /* panels that points share; the rest are computed per point */ };

static int modes_of(double L, double s) {
    return (int)(2 + L / s * 2 * sqrt(last_exponent) / M_PI);
}

/* ---- Terms that all points share ---- */

/* One axis: wave numbers, and the amplitudes of the initial data at 1. */
static void fill_axis(const struct cooling_mode *mode, int count, double late, double *q, double *left,
                      double error[2], double *steepest) {
    for (int k = 0; k < count; k++) {
        double exponent = fmin(late * mode[k].q * mode[k].q, 800); /* exp(-800) = 0 */
        double shape = mode[k].integral / mode[k].norm * exp(-exponent);
        double rounding = DBL_EPSILON * fabs(shape) * (6 + 8 * exponent + 3 * k);
        q[k] = mode[k].q;
        left[k] = exponent > last_exponent ? 0 : shape;
        error[0] += rounding;
        error[1] += q[k] * rounding;
        *steepest += q[k] * fabs(left[k]);
    }
}

/* Amplitudes of the response to the hot side since s0, and the error bounds. */
static void fill_modes(struct cooled_plate *c) {
    double *p = c->mode, *r = p + c->m, *given = r + c->n + c->m + c->n, c0 = pow(c->early / 2, 2);
    double late = pow(c->s / 2, 2), error[2][2] = {{0}}, steepest[2] = {0};
    struct cooling_mode *X = xcalloc((size_t)c->m + (size_t)c->n, sizeof *X), *Y = X + c->m;
    for (int m = 0; m < c->m; m++) X[m] = cooling_mode(m + 1, 1, c->W, c->h);
    for (int n = 0; n < c->n; n++) Y[n] = cooling_mode(n + 1, 0, c->H, c->h);
    fill_axis(X, c->m, late, p, r + c->n, error[0], &steepest[0]);
    fill_axis(Y, c->n, late, r, r + c->n + c->m, error[1], &steepest[1]);
    c->error[0] += fabs(c->start) * (error[0][0] + error[1][0]);
    for (int a = 0; a < 2; a++)
        c->error[1] += fabs(c->start) * (error[a][1] + steepest[a] * (error[1 - a][0] + 4 * DBL_EPSILON));
    for (int m = 0; m < c->m && c->hot != 0; m++)
        for (int n = 0; n < c->n; n++) {
            double rate = p[m] * p[m] + r[n] * r[n], shape = X[m].integral / (X[m].norm * Y[n].norm);
            if (c0 * rate > last_exponent) break;
            double size = c->hot * shape * r[n] / rate * exp(-c0 * rate) * -expm1(-(late - c0) * rate);
            double rounding = DBL_EPSILON * fabs(size) * (12 + 8 * c0 * rate + 3 * (m + n));
            given[m * c->n + n] = size;
            c->error[0] += rounding;
            c->error[1] += sqrt(rate) * rounding;
        }
    free(X);
}

struct cooled_plate *cooled_plate(double W, double H, double h, double hot, double start, double s) {
    double early = fmin(s, 0.16 * fmin(W, H)), first = hot == 0 ? s : early;
    int m = early < s ? modes_of(W, first) : 0, n = early < s ? modes_of(H, first) : 0;
    size_t modes = 2 * ((size_t)m + (size_t)n) + (size_t)m * (size_t)n;
    struct cooled_plate *c = xcalloc(1, sizeof *c + modes * sizeof(double));
    *c = (struct cooled_plate){
        .W = W, .H = H, .h = h, .s = s, .hot = hot, .start = start, .early = early, .m = m, .n = n};
    double scale = fabs(hot) + fabs(start);
    c->error[0] = 60 * DBL_EPSILON * scale;
    c->error[1] = 100 * DBL_EPSILON * scale * (1 / early + h);
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(NODES);
    for (int i = 0; i < NODES; i++) gsl_integration_glfixed_point(0, 1, (size_t)i, &c->node[i], &c->weight[i], table);
    gsl_integration_glfixed_table_free(table);
    fill_modes(c);
    return c;
}

/* ---- Factors of x and factors of y ---- */

/* One factor of every term: `node` for the integral, `mode` and `slope` for the sums. */
struct factor {
    double at;                 /* m */
    double start, start_slope; /* solution of the slab at s, initially at 1, and its slope */
    double early, edge;        /* X(d, s0); erfc(y/s0) and its slope */
    int panels, done;          /* panels required, and nodes evaluated */
    double (*node)[3], *mode, *slope;
};

static double width_of(const struct cooled_plate *c, int k) {
    return c->early * exp(-(k / NODES + c->node[k % NODES]));
}

static int panels_of(const struct cooled_plate *c, double distance) {
    double length = log(reach * c->early / distance);
    return length < 0 ? 0 : length < 700 ? (int)ceil(length) : 700;
}

/* 1 - X, dX/dx and dX/ds. */
static void x_node(const struct cooled_plate *c, double x, int k, double node[3]) {
    struct cooling_half X = cooling_half(c->W - x, c->h, width_of(c, k));
    node[0] = 1 - X.T, node[1] = -X.slope, node[2] = X.change;
}

/* Quadrature weights: with the factor z for 1 - X and dX/dx, without it for dX/ds. */
static void y_node(const struct cooled_plate *c, double y, int k, double node[3]) {
    double z = y / width_of(c, k);
    node[1] = 2 / sqrt(M_PI) * c->weight[k % NODES] * exp(-z * z);
    node[0] = z * node[1];
}

/* Number of significant modes along y for the wave number p along x. */
static int rows_of(const struct cooled_plate *c, double p) {
    double left = 4 * last_exponent / (c->early * c->early) - p * p;
    int most = 2 + (left > 0 ? (int)(c->H / M_PI * sqrt(left)) : 0);
    return c->hot == 0 ? 0 : most < c->n ? most : c->n;
}

static void fill_x(const struct cooled_plate *c, double x, struct factor *f) {
    const double *p = c->mode, *left = p + c->m + c->n, *given = left + c->m + c->n;
    f->at = x;
    f->done = 0;
    f->start = f->start_slope = 0;
    if (c->m == 0) {
        struct cooling_half X = cooling_half(c->W - x, c->h, c->s);
        f->start = X.T, f->start_slope = -X.slope;
    }
    memset(f->mode, 0, 2 * (size_t)c->n * sizeof(double));
    for (int m = 0; m < c->m; m++) {
        double cosine = cos(p[m] * x), sine = -p[m] * sin(p[m] * x);
        const double *size = given + m * c->n;
        int rows = rows_of(c, p[m]);
        f->start += left[m] * cosine;
        f->start_slope += left[m] * sine;
        for (int n = 0; n < rows; n++) {
            f->mode[n] += size[n] * cosine;
            f->slope[n] += size[n] * sine;
        }
    }
    if (c->hot == 0) return;
    f->early = cooling_half(c->W - x, c->h, c->early).T;
    f->panels = panels_of(c, c->W - x);
}

static void fill_y(const struct cooled_plate *c, double y, struct factor *f) {
    const double *r = c->mode + c->m, *left = r + c->n + c->m;
    f->at = y;
    f->done = 0;
    f->start = f->start_slope = 0;
    if (c->m == 0) {
        struct cooling_half Y = cooling_half(c->H - y, c->h, c->s);
        f->start = erf(y / c->s) + Y.T - 1;
        f->start_slope = 2 / sqrt(M_PI) / c->s * exp(-pow(y / c->s, 2)) - Y.slope;
    }
    for (int n = 0; n < c->n; n++) {
        f->mode[n] = sin(r[n] * y);
        f->slope[n] = r[n] * cos(r[n] * y);
        f->start += left[n] * f->mode[n];
        f->start_slope += left[n] * f->slope[n];
    }
    if (c->hot == 0) return;
    f->early = erfc(y / c->early);
    f->edge = -2 / sqrt(M_PI) / c->early * exp(-pow(y / c->early, 2));
    f->panels = panels_of(c, y);
}

/* ---- Products ---- */

/* F at s0.  On y = 0 its slope grows as the logarithm of the distance to the corner and is infinite there. */
static void add_heated(const struct cooled_plate *c, struct factor *X, struct factor *Y, struct surface *T) {
    double F = Y->early, slope[2] = {0, Y->edge * X->early}, own[2][3];
    int panels = X->panels < Y->panels ? X->panels : Y->panels, corner = X->at >= c->W && Y->at <= 0;
    for (int k = 0; k < NODES * panels && !corner; k++) {
        double *x = k < NODES * KEPT ? X->node[k] : own[0], *y = k < NODES * KEPT ? Y->node[k] : own[1];
        if (k >= X->done) x_node(c, X->at, k, x);
        if (k >= Y->done) y_node(c, Y->at, k, y);
        F -= y[0] * x[0];
        slope[0] += y[0] * x[1];
        slope[1] += y[1] * x[2];
    }
    int done = NODES * (corner ? 0 : panels < KEPT ? panels : KEPT);
    if (X->done < done) X->done = done;
    if (Y->done < done) Y->done = done;
    T->at.value += c->hot * F;
    for (int a = 0; a < 2; a++) T->slope[a].value += c->hot * slope[a];
    if (corner) T->slope[1] = (struct approx){-INFINITY, INFINITY};
}

static struct surface join(const struct cooled_plate *c, struct factor *X, struct factor *Y) {
    struct surface T = {
        {c->start * X->start * Y->start, c->error[0]},
        {{c->start * X->start_slope * Y->start, c->error[1]}, {c->start * X->start * Y->start_slope, c->error[1]}}};
    if (c->hot == 0) return T;
    for (int n = 0; n < c->n; n++) {
        T.at.value += X->mode[n] * Y->mode[n];
        T.slope[0].value += X->slope[n] * Y->mode[n];
        T.slope[1].value += X->mode[n] * Y->slope[n];
    }
    add_heated(c, X, Y, &T);
    return T;
}

/* Number of points in each row if the points form a lattice in row order, else 1. */
static size_t line_of(size_t n, const double *x, const double *y) {
    for (size_t k = 1; k < n; k++)
        if (x[k] == x[0] && y[k] != y[0]) return k;
    return 1;
}

void cooled_plate_at(const struct cooled_plate *c, size_t n, const double *x, const double *y, struct surface *T) {
    size_t line = line_of(n, x, y), nodes = c->hot == 0 ? 0 : NODES * KEPT, each = 3 * nodes + 2 * (size_t)c->n;
    struct factor *f = xcalloc(line + 1, sizeof *f);
    double *all = xcalloc((line + 1) * each + 1, sizeof *all);
    for (size_t i = 0; i <= line; i++) {
        f[i].at = NAN;
        f[i].node = (double(*)[3])(all + i * each);
        f[i].mode = all + i * each + 3 * nodes;
        f[i].slope = f[i].mode + c->n;
    }
    for (size_t i = 0; i < n; i++) {
        struct factor *X = &f[i % line], *Y = &f[line];
        if (X->at != x[i]) fill_x(c, x[i], X);
        if (Y->at != y[i]) fill_y(c, y[i], Y);
        T[i] = join(c, X, Y);
    }
    free(all);
    free(f);
}

/* ---- Second form: series ---- */

/* A plate with one hot, one insulated and two cooled sides: the steady state by a series along one axis, minus the
 * double series of the transient.
 *
 *     along x:  F = sum_m I_m/N_m cos(p x) (p cosh(p (H - y)) + h sinh(p (H - y)))/(p cosh(p H) + h sinh(p H))
 *     along y:  F = 1 - h y/(1 + h H) - sum_n h/(r M_n) sin(r y) cosh(r x)/(r sinh(r W) + h cosh(r W))
 *
 * The notation is that above.  The terms decay as exp(-p y) and exp(-r (W - x)); the series that decays
 * faster is used. */

enum { MOST = 20000, MODES = 2000 /* along each axis */ };

static void steady_along_x(double W, double H, double h, const double x[2], struct approx *F) {
    double term = 0;
    for (int m = 1; m <= MOST; m++) {
        struct cooling_mode X = cooling_mode(m, 1, W, h);
        double p = X.q, down = p == 0 ? 1
                                      : exp(-p * x[1]) * ((p + h) + (p - h) * exp(-2 * p * (H - x[1]))) /
                                            ((p + h) + (p - h) * exp(-2 * p * H));
        term = X.integral / X.norm * down;
        F->value += term * cos(p * x[0]);
        F->error += DBL_EPSILON * fabs(term) * (8 + 4 * m + 4 * p * x[1]);
        if (p * x[1] > last_exponent) return;
    }
    F->error += 2 * MOST * fabs(term); /* the terms decay as 1/m^2 */
}

static void steady_along_y(double W, double H, double h, const double x[2], struct approx *F) {
    double term = 0;
    F->value += 1 - h * x[1] / (1 + h * H);
    for (int n = 1; n <= MOST; n++) {
        struct cooling_mode Y = cooling_mode(n, 0, H, h);
        double r = Y.q, away = exp(-r * (W - x[0])) * (1 + exp(-2 * r * x[0]));
        term = h / (r * Y.norm) * away / (r * -expm1(-2 * r * W) + h * (1 + exp(-2 * r * W)));
        F->value -= term * sin(r * x[1]);
        F->error += DBL_EPSILON * fabs(term) * (8 + 4 * n + 4 * r * (W - x[0]));
        if (r * (W - x[0]) > last_exponent) return;
    }
    F->error += 2 * MOST * fabs(term);
}

struct approx cooled_plate_series(double W, double H, double h, double hot, double start, double s,
                                  const double x[2]) {
    struct approx T = {0, 1e-17 * (fabs(hot) + fabs(start))}, F = {0, 4 * DBL_EPSILON};
    (x[1] * H > (W - x[0]) * W ? steady_along_x : steady_along_y)(W, H, h, x, &F);
    T.value = hot * F.value;
    T.error += fabs(hot) * F.error;
    double needed = s < INFINITY ? fmax(W, H) / s * 2 * sqrt(last_exponent) / M_PI : 0;
    if (needed > MODES) T.error = INFINITY; /* some significant modes are missing */
    int most = needed == 0 || needed > MODES ? 0 : (int)(2 + W / s * 2 * sqrt(last_exponent) / M_PI);
    struct cooling_mode *along = xcalloc((size_t)most, sizeof *along);
    for (int m = 0; m < most; m++) along[m] = cooling_mode(m + 1, 1, W, h);
    for (int n = 1, alive = most; n <= MOST && alive; n++) {
        struct cooling_mode Y = cooling_mode(n, 0, H, h);
        alive = 0;
        for (int m = 0; m < most; m++) {
            double p = along[m].q, rate = p * p + Y.q * Y.q, exponent = rate * s * s / 4;
            double shape = along[m].integral / (along[m].norm * Y.norm) * exp(-exponent);
            if (exponent > last_exponent) break;
            alive = 1;
            T.value += shape * (start * Y.integral - hot * Y.q / rate) * cos(p * x[0]) * sin(Y.q * x[1]);
            T.error += DBL_EPSILON * fabs(shape) * (fabs(start * Y.integral) + fabs(hot * Y.q / rate)) *
                       (12 + 8 * exponent + 4 * (m + n));
        }
    }
    free(along);
    return T;
}
