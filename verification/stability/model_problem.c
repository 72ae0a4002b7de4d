/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small model problems in memory: the response of a method to an impulse, to noise and to a smooth hill. */
#include "verification/stability/model_problem.h"

#include "solver/space/assembly.h"
#include "solver/space/kernel.h"
#include "solver/particles/particles.h"
#include "solver/time/stepper.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* splitmix64 (Steele, Lea & Flood 2014) of the cell, uniform in [-1, 1) */
static double noise_at(const struct problem *p, const double *x) {
    static const uint64_t factor[DIM_MAX] = {0x9e3779b97f4a7c15u, 0xd1b54a32d192ed03u, 0x8cb92ba72f3d8dd7u};
    uint64_t z = 0;
    for (int a = 0; a < p->dim; a++)
        z ^= (uint64_t)(int64_t)floor(x[a]) * factor[a] + (a > 0 ? 0x632be59bd9b4e019u : 0);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-52 - 1;
}

static double impulse_at(const struct problem *p, const double *x) {
    for (int a = 0; a < p->dim; a++)
        if (floor(x[a]) != floor(p->hi[a] / 2)) return 0;
    return 1;
}

static double hill_at(const struct problem *p, const double *x) {
    double T = 1;
    for (int a = 0; a < p->dim; a++) T *= sin(M_PI * x[a] / p->hi[a]);
    return T + p->param[0] * noise_at(p, x);
}

static double zero(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0; /* K, or W m^-2 */
}

double model_problem_kappa_y(const struct model_problem *b) {
    return b->ratio > 0 ? b->ratio : 1;
}

/* K of a field at that angle from x, rad: 1 along it, `across` across. */
static void turn(struct problem *p, double angle, double across) {
    const double b[2] = {cos(angle), sin(angle)};
    for (int a = 0; a < 2; a++) p->material[0].k[a] = across + (1 - across) * b[a] * b[a];
    p->cross[problem_pair(0, 1)] = (1 - across) * b[0] * b[1];
}

struct problem model_problem_setup(const struct model_problem *b, enum model_problem_data data, double disturb) {
    struct problem p = {.dim = b->dim,
                        .t_end = 1,
                        .materials = 1,
                        .material = {{{1, model_problem_kappa_y(b), 1}, 1}},
                        .param = {disturb},
                        .initial = data == MODEL_NOISE     ? noise_at
                                   : data == MODEL_IMPULSE ? impulse_at
                                                           : hill_at,
                        .wall = zero};
    for (int a = 0; a < b->dim; a++) p.hi[a] = b->n;
    if (b->contact > 0) {
        p.materials = 2, p.interface = b->n / 2;
        p.material[1].rho_c = b->contact;
        for (int a = 0; a < b->dim; a++) p.material[1].k[a] = b->contact * p.material[0].k[a];
    }
    for (int s = 0; s < 2 * b->dim; s++) p.side[s] = b->field != 0 ? PERIODIC : b->insulated ? NEUMANN : DIRICHLET;
    if (b->field != 0) turn(&p, b->field * M_PI / 180, model_problem_kappa_y(b));
    return p;
}

int model_problem_resolve(struct model_problem *b, int least, struct failure *why) {
    const struct scheme *s = b->method->scheme;
    struct model_problem sized = *b;
    if (b->n == 0) sized.n = least;
    struct problem p = model_problem_setup(&sized, MODEL_NOISE, 0);
    if (!s && options_is_cloud(&b->options))
        return refuse(why, STATUS_INPUT, "--layout %s: %s needs a grid: lattice or node",
                      layout_words[b->options.layout], b->method->name);
    b->options.dx = 1;
    if (b->step.stepper == STEPPER_AUTO) b->step.stepper = stepper_auto(1, 1, 0);
    b->options.stepper = b->step.stepper;
    int reach = 2;
    if (s) {
        struct options resolved;
        if (particles_resolve(&p, &b->options, s, &resolved, why)) return why->status;
        b->options = resolved;
        reach = (int)ceil(s->sweeps * 2 * resolved.h);
    }
    if (b->n == 0) b->n = reach + 2 > least ? reach + 2 : least;
    return STATUS_OK;
}

int model_problem_cloud(const struct model_problem *b, const struct problem *p, struct cloud *c,
                        struct failure *why) {
    struct lattice l;
    if (layout_lattice(p, &b->options, &l, why)) return why->status;
    return layout_cloud(p, &b->options, &l, b->method->scheme->sweeps * 2.0 * b->options.h, c, why);
}

int model_problem_has_rows(const struct model_problem *b) {
    return options_is_cloud(&b->options) || b->contact > 0;
}

int model_problem_operator(const struct model_problem *b, const struct problem *p, struct heat_operator *a,
                           struct failure *why) {
    const struct scheme *s = b->method->scheme;
    struct lattice l;
    struct cloud c;
    if (!model_problem_has_rows(b)) {
        if (layout_lattice(p, &b->options, &l, why)) return why->status;
        return operator_create_lattice(a, p, &b->options, s, &l, why);
    }
    if (model_problem_cloud(b, p, &c, why)) return why->status;
    int status = assembly_operator(a, p, &b->options, s, &c, 1, why);
    layout_cloud_free(&c);
    return status;
}

int model_problem_around(const struct model_problem *b, const struct cloud *c, size_t count, model_problem_see *see,
                         void *with, struct failure *why) {
    uint32_t near[NEIGHBOURS_MAX];
    double d[NEIGHBOURS_MAX][DIM_MAX];
    struct neighbours cells;
    int status = STATUS_OK;
    neighbours_create(&cells, c, KERNEL_SUPPORT * b->options.h);
    for (size_t i = 0; i < count && !status; i++) {
        struct neighbourhood nb = {.dim = b->dim,
                                   .i = i,
                                   .x = {c->x[i], c->y[i]},
                                   .d = d,
                                   .h = b->options.h,
                                   .volume = c->volume,
                                   .rho_c = 1,
                                   .kappa = {1, model_problem_kappa_y(b), 1}};
        nb.n = neighbours_find(&cells, i, near, NEIGHBOURS_MAX);
        if (nb.n > NEIGHBOURS_MAX) {
            status = refuse(why, STATUS_NUMERICAL, "particle %zu has %zu neighbours", i, nb.n);
            break;
        }
        for (size_t k = 0; k < nb.n; k++)
            d[k][0] = c->x[near[k]] - c->x[i], d[k][1] = c->y[near[k]] - c->y[i], d[k][2] = 0;
        status = see(b, &nb, with, why);
    }
    neighbours_free(&cells);
    return status;
}

static double largest_of(const double *T, size_t n) {
    double most = 0;
    for (size_t i = 0; i < n; i++)
        if (fabs(T[i]) > most || isnan(T[i])) most = fabs(T[i]); /* a NaN propagates */
    return most;
}

static int march(const struct model_problem *b, const struct problem *p, double F, long long steps, double *largest,
                 struct failure *why) {
    struct heat_operator a;
    if (model_problem_operator(b, p, &a, why)) return why->status;
    double *T = xcalloc(a.state, sizeof *T);
    for (size_t i = 0; i < a.n; i++) {
        double x[DIM_MAX];
        for (size_t axis = 0, rest = i; axis < DIM_MAX; axis++, rest /= (size_t)b->n)
            x[axis] = (double)(rest % (size_t)b->n) + 0.5;
        T[i] = p->initial(p, x);
    }
    struct march m = {.stepper = b->step.stepper,
                      .time = F * (double)steps,
                      .steps = steps,
                      .alternation = 0,
                      .stages = b->step.stages,
                      .lo = -1,
                      .hi = 1};
    size_t bytes = 0;
    int status = stepper_march(&a, &m, T, &bytes, why);
    *largest = largest_of(T, a.n);
    free(T);
    operator_free(&a);
    return status;
}

int model_problem_run(const struct model_problem *b, const struct problem *given, double F, long long steps,
                      double *largest, struct failure *why) {
    struct problem p = *given;
    struct options o = b->options;
    struct field f;
    if (stepper_of(b->step.stepper)->count) return march(b, &p, F, steps, largest, why);
    p.t_end = F * (double)steps;
    o.dt = F;
    if (method_solve(b->method, &p, &o, &f, why)) return why->status;
    *largest = largest_of(f.T, f.n);
    field_free(&f);
    return STATUS_OK;
}
