/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The noise of a code that moves its particles: every so many steps other particles, and T from the old to the new.
 *
 * At a new place x the value c_0 of the quadratic that fits the old particles, ghosts among them, by least squares,
 *   sum_j W(x_j - x) (T_j - c_0 - c . P((x_j - x)/h))^2,   P = x, y, x^2/2, x y, y^2/2,
 * which is exact for quadratics.  Of a smooth T it is wrong by third derivatives, dx^3 with a sign that changes from
 * place to place and draw to draw, and by fourth ones, K dx^4 T_xxxx with one sign.  After t/(N dt) draws these add
 * up to K dx^4 t/(N dt): with dt = F dx^2/kappa second order, of the constant K kappa t/(N F) beside the operator's
 * own; an operator of higher order falls to second.  With dt ~ dx it is third order. */
#include "solver/particles/particles.h"
#include "solver/particles/ssph.h"
#include "solver/space/kernel.h"
#include "solver/space/neighbours.h"

#include <stdlib.h>
#include <string.h>

int redraw_check(const struct problem *p, const struct options *o, struct failure *why) {
    if (o->redraw == 0) return STATUS_OK;
    if (o->layout != LAYOUT_JITTER && o->layout != LAYOUT_RELAXED)
        return refuse(why, STATUS_NOT_APPLICABLE, "--redraw %d: needs --layout jitter or relaxed", o->redraw);
    if (p->materials == 2)
        return refuse(why, STATUS_NOT_APPLICABLE, "--redraw %d: takes one material, the scene has two", o->redraw);
    return STATUS_OK;
}

/* T at the place of point i of *all, whose first `old` points are those of the old cloud. */
static int interpolate(const struct options *o, const struct cloud *from, const double *T,
                       const struct neighbours *cells, double h, size_t i, double *out, struct failure *why) {
    enum { TERMS = 6 };
    const struct cloud *all = cells->cloud;
    uint32_t near[NEIGHBOURS_MAX];
    double d[NEIGHBOURS_MAX][2], P[NEIGHBOURS_MAX][SSPH_TERMS_MAX], value[NEIGHBOURS_MAX], w[NEIGHBOURS_MAX];
    struct neighbourhood nb = {.dim = all->dim, .i = i - from->total, .x = {all->x[i], all->y[i]}, .d = d, .h = h};
    size_t found = neighbours_find(cells, i, near, NEIGHBOURS_MAX);
    for (size_t k = 0; k < found && k < NEIGHBOURS_MAX; k++) {
        size_t j = near[k];
        if (j >= from->total) continue;
        double *at = d[nb.n], x = (all->x[j] - all->x[i]) / h, y = (all->y[j] - all->y[i]) / h;
        at[0] = x * h, at[1] = y * h;
        memcpy(P[nb.n], (double[TERMS]){1, x, x * x / 2, y, x * y, y * y / 2}, TERMS * sizeof *P[0]);
        double factor = from->factor ? from->factor[j] : from->sign[j];
        value[nb.n++] = factor * T[from->source[j]] + from->offset[j];
    }
    int terms = all->dim == 2 ? TERMS : 3;
    const double target[TERMS] = {1};
    if (ssph_fit(&nb, o->kernel, terms, P, NULL, target, w, NULL, why)) return why->status;
    *out = 0;
    for (size_t k = 0; k < nb.n; k++) *out += w[k] * value[k];
    return STATUS_OK;
}

/* T on the particles of `to` from those of `from`. */
static int carry(const struct options *o, const struct cloud *from, const struct cloud *to, double h, double *T,
                 struct failure *why) {
    struct cloud all = {.dim = from->dim, .n = from->total, .total = from->total + to->n};
    struct neighbours cells;
    int status = STATUS_OK;
    double *next = xcalloc(to->n, sizeof *next);
    all.x = xcalloc(all.total, sizeof *all.x);
    all.y = xcalloc(all.total, sizeof *all.y);
    memcpy(all.x, from->x, from->total * sizeof *all.x);
    memcpy(all.y, from->y, from->total * sizeof *all.y);
    memcpy(all.x + from->total, to->x, to->n * sizeof *all.x);
    memcpy(all.y + from->total, to->y, to->n * sizeof *all.y);
    neighbours_create(&cells, &all, KERNEL_SUPPORT * h);
    for (size_t i = 0; i < to->n && !status; i++)
        status = interpolate(o, from, T, &cells, h, from->total + i, &next[i], why);
    if (!status) memcpy(T, next, to->n * sizeof *T);
    neighbours_free(&cells);
    free(all.x);
    free(all.y);
    free(next);
    return status;
}

/* The cloud of the draw after the one of *o, and all that goes with it. */
static int draw(const struct problem *p, struct options *o, const struct scheme *s, const struct lattice *l,
                struct heat_operator *a, struct field *f, struct failure *why) {
    struct cloud from, to;
    double reach = particles_reach(o, s, l);
    if (layout_cloud(p, o, l, reach, &from, why)) return why->status;
    o->seed++;
    int status = layout_cloud(p, o, l, reach, &to, why);
    if (status) {
        layout_cloud_free(&from);
        return status;
    }
    status = carry(o, &from, &to, o->h * l->dx[0], f->T, why);
    operator_free(a);
    if (!status) status = operator_create_csr(a, p, o, s, &to, l->dx[0], why);
    memcpy(f->x, to.x, to.n * sizeof *f->x);
    if (f->y) memcpy(f->y, to.y, to.n * sizeof *f->y);
    layout_cloud_free(&from);
    layout_cloud_free(&to);
    return status;
}

int redraw_march(const struct problem *p, const struct options *given, const struct scheme *s,
                 const struct lattice *l, const struct march *m, struct heat_operator *a, struct field *f,
                 struct failure *why) {
    struct options o = *given;
    size_t ignored = 0;
    int status = STATUS_OK;
    double dt = m->time / (double)m->steps;
    for (long long done = 0; done < m->steps && !status;) {
        struct march part = *m;
        part.steps = m->steps - done < o.redraw ? m->steps - done : o.redraw;
        part.time = dt * (double)part.steps;
        part.bound = operator_bound(a);
        const struct stepper *stepper = stepper_of(m->stepper);
        if (stepper->count) part.stages = stepper->count(dt, part.bound);
        status = stepper_march(a, &part, f->T, &ignored, why);
        done += part.steps;
        if (!status && done < m->steps) status = draw(p, &o, s, l, a, f, why);
    }
    return status;
}
