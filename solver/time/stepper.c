/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of steppers, and the march of those with updates through dT/dt = L(T) = A T + g.  Each step is a list of
 * updates from the stepper, the same in every step.
 *
 * Data that change in time, dT/dt = A T + g(t).  Within a step from t to t + dt, g is the polynomial of degree m
 * (`degree` of the stepper) through its values at m + 1 equidistant times, ends included:  g = sum_i g_i l_i(c), with
 * Lagrange's l_i and c = (time - t)/dt.  The powers of c are further unknowns of a linear system with constant
 * coefficients:
 *
 *     dT/dt = A T + sum_i g_i sum_k l_ik c_k,   dc_k/dt = k c_(k-1)/dt,   c_0 = 1,   c_k = 0 at the start.
 *
 * An update therefore treats c_1, c_2, ... as it treats T, and finds g at the time of its own stage: a stepper needs
 * no list of stage times.  Euler's stage has c_1 = 0, those of the midpoint rule 0 and 1/2.
 *
 * Order.  For linear data a stepper of order p is applied to an autonomous system and keeps its order.  The
 * interpolation changes g by (c - c_0) .. (c - c_m) dt^(m+1) times its derivative of order m + 1.  Near a wall A and
 * g are as large as 1/dx^2, but g is A times a smooth field, and the sum over the steps (1 - R(z))^-1 z phi(z) is
 * bounded for a stable stepper.  The error in T is therefore O(dt^(m+1)): m = 1 keeps order 2, and a stepper without
 * another time error has order m + 1. */
#include "solver/time/stepper.h"

#include "solver/space/assembly.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- The table ---- */

#define STEPPER(NAME, name) extern const struct stepper stepper_##name;
#include "solver/steppers.def"
#undef STEPPER

const struct stepper *stepper_of(enum stepper_name name) {
#define STEPPER(NAME, name) [STEPPER_##NAME] = &stepper_##name,
    static const struct stepper *const all[] = {
#include "solver/steppers.def"
    };
#undef STEPPER
    return all[name];
}

enum stepper_name stepper_auto(int particles, int step_given, int transforms) {
    if (!particles || step_given) return STEPPER_EULER;
    return transforms ? STEPPER_EXACT : STEPPER_RKL2;
}

enum stepper_name stepper_without_error(int transforms) {
    return transforms ? STEPPER_EXACT : STEPPER_CHEBYSHEV;
}

const char *stepper_list(int nonlinear, char text[STEPPER_LIST]) {
    const char *name[STEPPER_LIST] = {0};
    int n = 0, used = 0;
    for (int k = STEPPER_AUTO + 1; stepper_words[k]; k++) {
        const struct stepper *s = stepper_of((enum stepper_name)k);
        if (nonlinear ? s->stage != NULL : s->updates != NULL) name[n++] = s->name;
    }
    for (int k = 0; k < n; k++)
        used += snprintf(text + used, (size_t)(STEPPER_LIST - used), "%s%s",
                         k == 0      ? ""
                         : k < n - 1 ? ", "
                                     : " or ",
                         name[k]);
    return text;
}

/* ---- Data that change ---- */

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

/* For the march *m; a->g becomes an array of the result.  Adds its bytes to *bytes. */
static struct changing *changing_create(struct heat_operator *a, const struct march *m, size_t *bytes) {
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

static void changing_free(struct changing *c) {
    if (!c) return;
    for (int i = 0; i <= c->degree; i++) free(c->sample[i]);
    free(c->g);
    free(c);
}

/* Starts a step of length dt at the time t, s.  Steady data have no struct changing. */
static void changing_begin(struct changing *c, double t, double dt) {
    if (!c) return;
    int known = fabs(t - c->end) <= 1e-9 * dt; /* the end of the previous step */
    if (known) {
        double *first = c->sample[c->degree];
        c->sample[c->degree] = c->sample[0], c->sample[0] = first;
    }
    for (int i = known; i <= c->degree; i++)
        (c->a->weight ? operator_constants : assembly_constants)(c->a, c->p, c->o, t + i * dt / c->degree,
                                                                 c->sample[i]);
    memset(c->now, 0, sizeof c->now);
    c->now[0] = 1;
    c->dt = dt, c->end = t + dt;
}

/* The powers of c follow the update, from `now` to `before` as from one state to the other. */
static void advance_powers(struct changing *c, const struct update *u) {
    double next[POWERS];
    for (int k = 0; k <= c->degree; k++)
        next[k] = (k ? u->rate / c->dt * k * c->now[k - 1] : u->start) + u->self * c->now[k] +
                  (u->old != 0 ? u->old * c->before[k] : 0);
    memcpy(c->before, c->now, sizeof c->before);
    memcpy(c->now, next, sizeof c->now);
}

/* Sets a->g for the update *u, the next one of the step. */
static void changing_update(struct changing *c, const struct update *u) {
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
    advance_powers(c, u);
}

/* ---- The march ---- */

enum { TOGETHER = 32 }; /* updates passed to the operator at once; steps between checks of the bounds */

long long stepper_applications(const struct march *m) {
    return m->steps * m->stages + (m->start[0] > 0 ? 2LL * m->start[0] + m->start[1] - m->stages : 0);
}

/* Threads wait for each other once in a sweep of eight updates (wavefront.h). */
int stepper_threads(int asked, size_t n) {
    size_t most = 8 * n / STEPPER_SHARE;
    return asked < 2 || most < 2 ? 1 : most < (size_t)asked ? (int)most : asked;
}

/* Refuses if the state has left the bounds of the run. */
static int check_bounds(const struct march *m, const struct heat_operator *a, const double *state, long long step,
                        struct failure *why) {
    double half = fmax((m->hi - m->lo) / 2, 1e-6 * fmax(fabs(m->lo), fabs(m->hi)));
    size_t i = state_find_outside(a, state, m->lo - half, m->hi + half);
    if (i == a->n) return STATUS_OK;
    double dt = m->time / (double)m->steps, *T = xcalloc(a->n, sizeof *T), value;
    char where[4 + PLACE_TEXT] = "", place[PLACE_TEXT], pace[PACE_TEXT] = "";
    state_store(a, state, T);
    value = T[i];
    free(T);
    if (m->field) {
        const struct field *f = m->field;
        double x[DIM_MAX];
        snprintf(where, sizeof where, " at %s", problem_place(f->dim, field_place(f, i, x), place));
    }
    if (m->changing) problem_wall_pace(m->changing, dt, pace);
    const char *reason =
        stepper_of(m->stepper)->order == 0 ? ": a mode grows, or the spectrum is not near the real axis"
        : *pace                            ? pace
        : dt * m->bound <= 2               ? ": dt is too large, or a mode grows at any step (see: heatladder limit)"
                                           : ": dt is too large";
    return refuse(
        why, STATUS_UNSTABLE,
        "unstable: at step %lld of %lld (t = %.6g s) particle %zu%s has %.4g K, the data are in [%.4g, %.4g] K; "
        "dt = %.6g s%s",
        step, m->steps, dt * (double)step, i, where, value, m->lo, m->hi, dt, reason);
}

/* Updates that read and write two states; Y[0] is the current state on entry and exit.  Data that change (c, or
 * NULL) are set for each update. */
static void update_in_turn(const struct heat_operator *a, struct changing *c, const struct update *u, int count,
                           double *Y[2]) {
    for (int k = 0; k < count && c; k++) {
        changing_update(c, &u[k]);
        state_update(a, &u[k], 1, Y);
    }
    for (int k = 0; k < count && !c; k += TOGETHER)
        state_update(a, u + k, count - k < TOGETHER ? count - k : TOGETHER, Y);
}

/* A step whose updates also read the state at its start.  That state is kept while the other two alternate. */
static void update_from_start(const struct heat_operator *a, struct changing *c, struct update *u, int stages,
                              double *Y[3]) {
    double *T = Y[0], *turn[2] = {Y[1], Y[2]};
    update_in_turn(a, c, u, 1, (double *[2]){T, Y[1]});
    for (int k = 1; k < stages; k++) u[k].Y0 = u[k].start != 0 ? T : NULL;
    update_in_turn(a, c, u + 1, stages - 1, turn);
    Y[0] = turn[0], Y[1] = turn[1], Y[2] = T;
}

/* A damping first step: two quarter steps, then half a step. */
static void damping_step(const struct heat_operator *a, struct changing *c, const struct march *m, double *Y[3]) {
    const struct stepper *s = stepper_of(m->stepper);
    int most = m->start[0] > m->start[1] ? m->start[0] : m->start[1];
    double dt = m->time / (double)m->steps;
    struct update *u = xcalloc((size_t)most, sizeof *u);
    s->damp(dt / 4, m->start[0], u);
    for (int quarter = 0; quarter < 2; quarter++) {
        changing_begin(c, quarter * dt / 4, dt / 4);
        update_in_turn(a, c, u, m->start[0], Y);
    }
    s->updates(dt / 2, m->bound, m->start[1], u);
    changing_begin(c, dt / 2, dt / 2);
    update_from_start(a, c, u, m->start[1], Y);
    free(u);
}

/* Steps first <= k < end, each with its own data. */
static void changing_steps(const struct heat_operator *a, struct changing *c, const struct march *m, struct update *u,
                           int stages, long long first, long long end, double *Y[3]) {
    double dt = m->time / (double)m->steps;
    for (long long k = first; k < end; k++) {
        changing_begin(c, (double)k * dt, dt);
        if (stepper_of(m->stepper)->arrays == 2)
            update_in_turn(a, c, u, stages, Y);
        else
            update_from_start(a, c, u, stages, Y);
    }
}

/* The updates of `count` steps; the caller frees them. */
static struct update *list_updates(const struct march *m, const struct stepper *s, int stages, int count) {
    double dt = m->time / (double)m->steps;
    struct update *u = xcalloc((size_t)count * (size_t)stages, sizeof *u);
    for (int k = 0; k < count; k++)
        s->updates(dt * (k % 2 ? 1 - m->alternation : 1 + m->alternation), m->bound, stages, u + k * stages);
    return u;
}

int stepper_march(const struct heat_operator *a, const struct march *m, double *T, size_t *bytes,
                  struct failure *why) {
    const struct stepper *s = stepper_of(m->stepper);
    const int arrays = s->arrays, stages = s->stages > 0 ? s->stages : m->stages;
    int status = STATUS_OK;
    double *Y[3] = {T};
    struct heat_operator own = *a;
    struct changing *c = m->changing ? changing_create(&own, m, bytes) : NULL;
    struct update *u = list_updates(m, s, stages, arrays == 2 ? TOGETHER : 1);
    own.threads = stepper_threads(a->threads, a->n);
    for (int k = 1; k < arrays; k++) Y[k] = xcalloc(a->state, sizeof *Y[k]);
    *bytes += ((size_t)arrays * a->state - a->n) * sizeof **Y;
    state_load(a, T, T);
    for (long long done = 0; done < m->steps && !status;) {
        int count = m->steps - done < TOGETHER ? (int)(m->steps - done) : TOGETHER, damps = done == 0 && m->start[0];
        if (damps) damping_step(&own, c, m, Y);
        if (c) changing_steps(&own, c, m, u, stages, done + damps, done + count, Y);
        if (arrays == 2 && !c) update_in_turn(&own, NULL, u, count * stages, Y);
        for (int k = damps; k < count && arrays == 3 && !c; k++) update_from_start(&own, NULL, u, stages, Y);
        done += count;
        status = check_bounds(m, a, Y[0], done, why);
    }
    state_store(a, Y[0], T);
    for (int k = 0; k < arrays; k++)
        if (Y[k] != T) free(Y[k]);
    free(u);
    changing_free(c);
    return status;
}
