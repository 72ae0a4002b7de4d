/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data that change in time: dT/dt = A T + g(t).
 *
 * Within a step from t to t + dt, g is the polynomial of degree m through its values at m + 1 equidistant times,
 * ends included:  g = sum_i g_i l_i(c), with Lagrange's l_i and c = (time - t)/dt.  The powers of c are further
 * unknowns of a linear system with constant coefficients:
 *
 *     dT/dt = A T + sum_i g_i sum_k l_ik c_k,   dc_k/dt = k c_(k-1)/dt,   c_0 = 1,   c_k = 0 at the start.
 *
 * An update therefore treats c_1, c_2, ... as it treats T, and finds g at the time of its own stage.  Euler's stage
 * has c_1 = 0, those of the midpoint rule 0 and 1/2.  For rkl2, c_1 of u_j is c/b_j with the stage time
 *
 *     c = (j^2 + j - 2)/(s^2 + s - 2),   of Y_1: 4/(3 (s^2 + s - 2)),
 *
 * of Y_j = (1 - b_j) Y_0 + b_j u_j: the derivative of the stage's polynomial at 0.  In terms of the u_j the method
 * of Meyer, Balsara & Aslam (2014, eq. 17) adds g_0 + (g(c) - g_0)/b_j, which is g(c/b_j) for linear data.
 *
 * Order.  For linear data a stepper of order p is applied to an autonomous system and keeps its order.  The
 * interpolation changes g by (c - c_0) .. (c - c_m) dt^(m+1) times its derivative of order m + 1.  Near a wall A and
 * g are as large as 1/dx^2, but g is A times a smooth field, and the sum over the steps (1 - R(z))^-1 z phi(z) is
 * bounded for a stable stepper.  The error in T is therefore O(dt^(m+1)): order 2 for rk2, rkl2 with m = 1.  The
 * polynomials of chebyshev.c have no other time error; m = 4 gives them order 5. */
#include "solver/time/changing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEGREE_MAX = 4, POWERS = DEGREE_MAX + 1 };

struct changing {
    struct heat_operator *a;
    const struct problem *p;
    const struct options *o;
    int degree;
    double *sample[POWERS], *g;         /* K s^-1, a->state each */
    double lagrange[POWERS][POWERS];    /* l_ik */
    double now[POWERS], before[POWERS]; /* c_k of the two states that updates alternate between */
    double dt, end;                     /* s, length and end of the current step */
};

/* l_i is the product over j != i of (m c - j)/(i - j). */
static void set_lagrange(struct changing *c) {
    for (int i = 0; i <= c->degree; i++) {
        double *l = c->lagrange[i];
        l[0] = 1;
        for (int j = 0; j <= c->degree; j++)
            for (int k = c->degree; k >= 0 && j != i; k--)
                l[k] = ((k ? c->degree * l[k - 1] : 0) - j * l[k]) / (i - j);
    }
}

struct changing *changing_create(struct heat_operator *a, const struct march *m, size_t *bytes) {
    struct changing *c = xcalloc(1, sizeof *c);
    int degree = stepper_of(m->stepper)->degree;
    *c = (struct changing){.a = a, .p = m->changing, .o = m->options, .degree = degree > 0 ? degree : 1, .end = NAN};
    for (int i = 0; i <= c->degree; i++) c->sample[i] = xcalloc(a->state, sizeof **c->sample);
    c->g = xcalloc(a->state, sizeof *c->g);
    *bytes += (size_t)(c->degree + 1) * a->state * sizeof *c->g; /* a->g is counted by the operator */
    set_lagrange(c);
    a->g = c->g;
    return c;
}

void changing_free(struct changing *c) {
    if (!c) return;
    for (int i = 0; i <= c->degree; i++) free(c->sample[i]);
    free(c->g);
    free(c);
}

void changing_begin(struct changing *c, double t, double dt) {
    if (!c) return;
    int known = fabs(t - c->end) <= 1e-9 * dt; /* the end of the previous step */
    if (known) {
        double *first = c->sample[c->degree];
        c->sample[c->degree] = c->sample[0], c->sample[0] = first;
    }
    for (int i = known; i <= c->degree; i++)
        operator_constants(c->a, c->p, c->o, t + i * dt / c->degree, c->sample[i]);
    memset(c->now, 0, sizeof c->now);
    c->now[0] = 1;
    c->dt = dt, c->end = t + dt;
}

/* The powers of c follow the update, from `now` to `before` as from one state to the other. */
static void advance(struct changing *c, const struct update *u) {
    double next[POWERS];
    for (int k = 0; k <= c->degree; k++)
        next[k] = (k ? u->rate / c->dt * k * c->now[k - 1] : u->start) + u->self * c->now[k] +
                  (u->old != 0 ? u->old * c->before[k] : 0);
    memcpy(c->before, c->now, sizeof c->before);
    memcpy(c->now, next, sizeof c->now);
}

void changing_update(struct changing *c, const struct update *u) {
    double weight[POWERS] = {0}, *restrict g = c->g;
    for (int i = 0; i <= c->degree; i++)
        for (int k = 0; k <= c->degree; k++) weight[i] += c->lagrange[i][k] * c->now[k];
    for (int i = 0; i <= c->degree; i++) {
        const double *restrict from = c->sample[i];
        if (i == 0)
            for (size_t n = 0; n < c->a->state; n++) g[n] = weight[0] * from[n];
        else
            for (size_t n = 0; n < c->a->state; n++) g[n] += weight[i] * from[n];
    }
    advance(c, u);
}
