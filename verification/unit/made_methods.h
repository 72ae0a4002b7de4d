/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_MADE_METHODS_H
#define HEATLADDER_VERIFICATION_UNIT_MADE_METHODS_H

/* Methods of known error: the exact solution plus C dx^P + D dt^Q, so that every answer is known.
 */

#include "references/scene.h"
#include "solver/field.h"
#include "solver/method.h"
#include "solver/space/operator.h"
#include "verification/case/command.h"

#include "verification/unit/near.h"

#include <stdlib.h>
#include <string.h>

static const double C = 0.31, D = 0.77;

static inline int whole(const struct problem *p, double dx) {
    return (int)nearbyint((p->hi[0] - p->lo[0]) / dx);
}

static inline int answer(const struct problem *p, const struct options *o, int order, struct field *f) {
    int n = whole(p, o->dx);
    double steps =
        o->stepper == STEPPER_EXACT
            ? 0
            : ceil(p->t_end / (o->dt > 0 ? o->dt : o->fourier * o->dx * o->dx / p->material[0].k[0]) - 1e-9);
    double dt = steps > 0 ? p->t_end / steps : 0;
    field_alloc(f, 1, (size_t)n);
    f->time = p->t_end, f->dt = dt, f->steps = (long long)steps, f->stages = 1;
    for (int i = 0; i < n; i++) {
        f->x[0][i] = p->lo[0] + (i + 0.5) * (p->hi[0] - p->lo[0]) / n;
        double x[2] = {f->x[0][i], 0};
        f->T[i] = scene_exact(scene_find("rod-gauss"), p, x, p->t_end).temperature *
                  (1 + C * pow(o->dx, 2) + D * pow(dt, order));
    }
    return STATUS_OK;
}

static inline int solve_euler(const struct method *m, const struct problem *p, const struct options *o,
                              struct field *f, struct failure *why) {
    (void)m;
    if (o->stepper == STEPPER_EXACT) return refuse(why, STATUS_NOT_APPLICABLE, "--stepper exact: not here");
    return answer(p, o, o->stepper == STEPPER_RKL2 ? 2 : 1, f);
}

static inline int solve_any(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                            struct failure *why) {
    (void)m, (void)why;
    return answer(p, o, o->stepper == STEPPER_RKL2 ? 2 : 1, f);
}

static inline int solve_picky(const struct method *m, const struct problem *p, const struct options *o,
                              struct field *f, struct failure *why) {
    (void)m;
    double F = o->dt * p->material[0].k[0] / (o->dx * o->dx);
    if (F > 0.01) return refuse(why, STATUS_UNSTABLE, "T grew at step 7");
    return answer(p, o, 1, f);
}

static inline int solve_broken(const struct method *m, const struct problem *p, const struct options *o,
                               struct field *f, struct failure *why) {
    (void)m;
    if (o->dx < 0.3) return refuse(why, STATUS_UNSTABLE, "T grew at step 7");
    return answer(p, o, 1, f);
}

static inline int solve_wrong_input(const struct method *m, const struct problem *p, const struct options *o,
                                    struct field *f, struct failure *why) {
    (void)m;
    if (o->stepper == STEPPER_EXACT) return refuse(why, STATUS_INPUT, "--dx: does not divide the domain");
    return solve_euler(m, p, o, f, why);
}

static const struct scheme scheme;
static const struct method wrong_input = {"wrong_input", "", "stepper", &scheme, solve_wrong_input};
static const struct method euler = {"euler_only", "", "stepper", NULL, solve_euler};
static const struct method no_exact = {"no_exact", "", "stepper", &scheme, solve_euler};
static const struct method with_exact = {"with_exact", "", "stepper", &scheme, solve_any};
static const struct method picky = {"picky", "", "stepper", NULL, solve_picky};
static const struct method broken = {"broken", "", "stepper", NULL, solve_broken};

static inline struct command request(const char *line, const struct method *m) {
    struct command r;
    struct failure why;
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    r.experiment.method = m;
    r.experiment.options.domain = DOMAIN_WHOLE; /* these methods know of no lattice, nor of its symmetry */
    return r;
}

#endif
