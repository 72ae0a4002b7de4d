/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_DIAGNOSED_PROBLEMS_H
#define HEATLADDER_VERIFICATION_UNIT_DIAGNOSED_PROBLEMS_H

/* Scenes with parameters that show every fault. */

#include "references/scene.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/fault/diagnosis.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char CHANGING[] = "rect-manufactured whose source changes";

static inline const struct scene *scene_of(const char *name) {
    return scene_find(strcmp(name, CHANGING) == 0 ? "rect-manufactured" : name);
}

static inline struct problem problem_of(const char *name) {
    struct problem p;
    struct failure why;
    const struct scene *s = scene_of(name);
    scene_defaults(s, &p);
    if (strcmp(name, "square-step") == 0) p.param[1] = 0.5, p.param[2] = 0.75, p.param[3] = 0.02; /* a, b, kappa_x */
    if (strcmp(name, "rect-manufactured") == 0) p.param[2] = 0.005, p.param[3] = 0.02;     /* k_x, k_y: G matters */
    if (strcmp(name, CHANGING) == 0) p.param[5] = 0.05, p.param[6] = 8, p.param[7] = 0.25; /* A, rise, t_end */
    if (s->setup(&p, &why)) fail_msg("%s", why.text);
    return p;
}

struct rung {
    struct field field;
    double *exact;
    struct diagnosis_rung at;
};

/* A code that solves *p with a fault of the size `units` (cells, steps, or parts) at dx, by ftcs with F = 0.2. */
static inline void solve(const char *name, const struct problem *p, struct fault fault, double units, double dx,
                         struct rung *r) {
    struct faulty with;
    struct failure why;
    struct options o = {.dx = dx,
                        .fourier = 0.2,
                        .stepper = STEPPER_EULER,
                        .sampling = p->jumps[0] ? SAMPLING_CELL : SAMPLING_POINT,
                        .mean = MEAN_SERIES,
                        .domain = DOMAIN_WHOLE};
    double kappa = 0, size = units;
    for (int m = 0; m < p->materials; m++)
        for (int a = 0; a < p->dim; a++) kappa = fmax(kappa, p->material[m].k[a] / p->material[m].rho_c);
    double dt = p->t_end / ceil(p->t_end * kappa / (0.2 * dx * dx));
    if (fault_rows[fault.kind].unit == UNIT_TIME) size *= dt;
    if (fault_rows[fault.kind].unit == UNIT_LENGTH || fault.kind == FAULT_CORNER || fault.kind == FAULT_SAMPLES)
        size *= dx;
    assert_true(faulty_make(p, fault, size, &with));
    o.mean = p->k_law == K_PHASES ? MEAN_KIRCHHOFF : with.mean;
    if (method_solve(method_find("ftcs"), &with.problem, &o, &r->field, &why)) fail_msg("%s: %s", name, why.text);
    r->exact = xcalloc(r->field.n, sizeof *r->exact);
    for (int a = 0; a < p->dim; a++)
        for (int i = 0; i < r->field.shape[a]; i++)
            r->field.x[a][i] = with.centre[a] + with.stretch[a] * (r->field.x[a][i] - with.centre[a]) + with.moved[a];
    for (size_t i = 0; i < r->field.n; i++) {
        double x[DIM_MAX];
        field_place(&r->field, i, x);
        struct exact e = scene_exact(scene_of(name), p, x, p->t_end);
        r->exact[i] = e.no_value ? NAN : e.temperature;
    }
    r->at = (struct diagnosis_rung){&r->field, r->exact, dx, dt, NAN};
}

static inline void forget(struct rung *r) {
    field_free(&r->field);
    free(r->exact);
}

#endif
