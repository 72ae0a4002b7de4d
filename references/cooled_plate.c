/* A plate with one hot side, one insulated and two cooled ones: early form and modes.
 *
 * With cos(p x), p W tan(p W) = h W, and sin(r y), r H cot(r H) = -h H, whose integrals and those of their squares
 * are I_m, N_m and J_n, M_n, and u = d/dt of the half line y > 0 that is heated to 1, the response to the hot side is
 *
 *     F(t) = int_0^t u(y, t') X(x, t') dt'      X: the slab across, from 1, insulated and cooled        (Duhamel)
 *     F(t) = F(inf) - sum_mn C_mn cos(p x) sin(r y) exp(-kappa (p^2 + r^2) t),  C = r I_m/(N_m M_n (p^2 + r^2)),
 *
 * the coefficients by Green's second identity from the hot side alone.  Neither is cheap everywhere: the integral
 * needs half lines, and sum and F(inf) crawl near the corner (W, 0).  Their difference does: with an early time t0,
 *
 *     F(t) = F(t0) + sum_mn C_mn cos(p x) sin(r y) (exp(-kappa (p^2 + r^2) t0) - exp(-kappa (p^2 + r^2) t)).
 *
 * sqrt(4 kappa t0) = s0 = 0.12 of the shorter extent, so that ends do not feel each other (erfc(1/0.12) = 4e-32), and
 * some 4.1 W/s0 and 4.1 H/s0 modes have exponents below 41.5.  With z = y/sqrt(4 kappa t'),
 *
 *     F(t0) = 2/sqrt(pi) int_{y/s0}^inf exp(-z^2) X(u, s = y/z) dz,   u = W - x,
 *
 * X of cooling_half; further than 6.1 s0 from x = W it is erfc(y/s0).  By panels of log z no longer than 1, with 16
 * Gauss points: the integrand is analytic within pi/4 of the axis, so that the error is 3.4^-32 = 1e-17. What is left
 * of a start at 1 is sum_mn I_m J_n/(N_m M_n) cos sin exp, early a product of half lines. Restrictions: isotropic;
 * both cooled sides alike. */
#include "references/cooled_plate.h"

#include "references/cooling.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_integration.h>

static const double last_exponent = 41.5;
enum { MODES_MOST = 520 }; /* along x: 4.1 W/s0 + 2, W no longer than 10 H */

static int modes_of(double L, double s) {
    return (int)(2 + L / s * 2 * sqrt(last_exponent) / M_PI);
}

/* Sizes of the modes at s, K: those that the hot side has given since s0 and those left of the start. */
static void fill_modes(struct cooled_plate *c) {
    double *p = c->mode, *r = p + c->m, *size = r + c->n, c0 = c->early * c->early / 4, c1 = c->s * c->s / 4;
    struct cooling_mode *along = xcalloc((size_t)c->m, sizeof *along);
    for (int m = 0; m < c->m; m++) {
        along[m] = cooling_mode(m + 1, 1, c->W, c->h);
        p[m] = along[m].q;
    }
    for (int n = 0; n < c->n; n++) {
        struct cooling_mode Y = cooling_mode(n + 1, 0, c->H, c->h);
        r[n] = Y.q;
        for (int m = 0; m < c->m; m++) {
            double rate = p[m] * p[m] + Y.q * Y.q, shape = along[m].integral / (along[m].norm * Y.norm);
            double given = Y.q / rate * exp(-c0 * rate) * -expm1(-(c1 - c0) * rate);
            double left = Y.integral * exp(-c1 * rate);
            size[n * c->m + m] = shape * (c->hot * given + c->start * left);
            double rounding = DBL_EPSILON * fabs(shape) *
                              (fabs(c->hot) * given * (12 + 8 * c0 * rate + 3 * (m + n)) +
                               fabs(c->start * left) * (12 + 8 * c1 * rate + 3 * (m + n)));
            c->error[0] += rounding;
            c->error[1] += sqrt(rate) * rounding;
        }
    }
    free(along);
}

struct cooled_plate *cooled_plate(double W, double H, double h, double hot, double start, double s) {
    double early = fmin(s, 0.12 * fmin(W, H));
    int m = early < s ? modes_of(W, early) : 0, n = early < s ? modes_of(H, early) : 0;
    struct cooled_plate *c = xcalloc(1, sizeof *c + ((size_t)m + (size_t)n + (size_t)m * (size_t)n) * sizeof(double));
    *c = (struct cooled_plate){
        .W = W, .H = H, .h = h, .s = s, .hot = hot, .start = start, .early = early, .m = m, .n = n};
    double scale = fabs(hot) + fabs(start);
    c->error[0] = 60 * DBL_EPSILON * scale;
    c->error[1] = 100 * DBL_EPSILON * scale * (1 / early + h);
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(COOLED_PLATE_NODES);
    for (int i = 0; i < COOLED_PLATE_NODES; i++)
        gsl_integration_glfixed_point(0, 1, (size_t)i, &c->node[i], &c->weight[i], table);
    gsl_integration_glfixed_table_free(table);
    fill_modes(c);
    return c;
}

/* F at the early width s, its integral by log s', s' = y/z.  On y = 0 its slope is 2/sqrt(pi) times
 * int_0^s dX/ds'/s' ds' - X/s, which grows as log u towards the corner u = 0. */
static struct surface heated(const struct cooled_plate *c, double u, double y, double s) {
    const double reach = 6.1, unit = 2 / sqrt(M_PI);
    double edge = unit * exp(-y * y / (s * s)) / s, lo = y > 0 ? y / reach : u / reach;
    struct surface F = {{erfc(y / s), 0}, {{0, 0}, {-edge, 0}}};
    if (u > reach * s || lo >= s) return F;
    F = (struct surface){{y == 0, 0}, {{0, 0}, {-edge * cooling_half(u, c->h, s).T, 0}}};
    if (lo == 0) F.slope[1] = (struct approx){-INFINITY, INFINITY};
    if (lo == 0) return F;
    double length = log(s / lo);
    int panels = (int)ceil(length);
    for (int i = 0; i < panels * COOLED_PLATE_NODES; i++) {
        int k = i % COOLED_PLATE_NODES;
        double width = s * exp(-(i / COOLED_PLATE_NODES + c->node[k]) * length / panels), z = y / width;
        double w = unit * c->weight[k] * length / panels * exp(-z * z);
        struct cooling_half X = cooling_half(u, c->h, width);
        F.at.value += w * z * X.T;
        F.slope[0].value -= w * z * X.slope; /* u = W - x */
        F.slope[1].value += w * X.change;
    }
    return F;
}

/* What is left, early, of a start at 1. */
static struct surface cooled(const struct cooled_plate *c, const double x[2], double s) {
    struct cooling_half X = cooling_half(c->W - x[0], c->h, s), Y = cooling_half(c->H - x[1], c->h, s);
    double z = x[1] / s, held = erf(z) + Y.T - 1, slope = 2 / sqrt(M_PI) / s * exp(-z * z) - Y.slope;
    return (struct surface){{X.T * held, 0}, {{-X.slope * held, 0}, {X.T * slope, 0}}};
}

static void add(struct surface *T, double factor, struct surface part) {
    T->at.value += factor * part.at.value;
    for (int a = 0; a < 2; a++) T->slope[a].value += factor * part.slope[a].value;
}

struct surface cooled_plate_at(const struct cooled_plate *c, const double x[2]) {
    struct surface T = {{0, c->error[0]}, {{0, c->error[1]}, {0, c->error[1]}}};
    const double *p = c->mode, *r = p + c->m, *size = r + c->n;
    add(&T, c->hot, heated(c, c->W - x[0], x[1], c->early));
    if (c->m == 0) add(&T, c->start, cooled(c, x, c->s));
    double cosine[MODES_MOST], sine[MODES_MOST];
    for (int m = 0; m < c->m; m++) {
        cosine[m] = cos(p[m] * x[0]);
        sine[m] = p[m] * sin(p[m] * x[0]);
    }
    for (int n = 0; n < c->n; n++) {
        double value = 0, slope = 0;
        for (int m = 0; m < c->m; m++) {
            value += size[n * c->m + m] * cosine[m];
            slope -= size[n * c->m + m] * sine[m];
        }
        T.at.value += value * sin(r[n] * x[1]);
        T.slope[0].value += slope * sin(r[n] * x[1]);
        T.slope[1].value += value * r[n] * cos(r[n] * x[1]);
    }
    return T;
}
