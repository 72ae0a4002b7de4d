/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_ODD_SCENES_H
#define HEATLADDER_VERIFICATION_UNIT_ODD_SCENES_H

/* Every scene at odd parameters, all distinct, so that no swap or forgotten factor can hide. */

#include "references/scene.h"
#include "solver/method.h"
#include "solver/shape.h"

#include "verification/unit/near.h"

/* *p set up at the scene's odd parameters; assertions that fail name the scene from here on. */
static inline void odd_setup(const struct scene *s, struct problem *p) {
    struct failure why = {0};
    near_about = s->name;
    if (!(s->odd.scale > 0)) fail_msg("%s has no odd parameters (.odd of its struct scene)", s->name);
    scene_defaults(s, p);
    for (int i = 0; s->params[i].name; i++) p->param[i] = s->odd.param[i];
    if (s->setup(p, &why)) fail_msg("%s at its odd parameters: %s", s->name, why.text);
}

/* The scene of that name, set up at its odd parameters. */
static inline const struct scene *odd_find(const char *name, struct problem *p) {
    const struct scene *s = scene_find(name);
    assert_non_null(s);
    odd_setup(s, p);
    return s;
}

/* A number in (0, 1), the same sequence on every machine. */
static inline double odd_random(unsigned long *state) {
    *state = (*state * 1103515245UL + 12345UL) & 0x7fffffffUL;
    return ((double)*state + 0.5) / 0x80000000UL;
}

/* A random point at least `margin` (m) from every wall. */
static inline void odd_point(const struct problem *p, double margin, unsigned long *random, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = 0;
    do
        for (int a = 0; a < p->dim; a++)
            x[a] = p->lo[a] + margin + odd_random(random) * (p->hi[a] - p->lo[a] - 2 * margin);
    while (p->shape && shape_depth(p, x) < margin);
}

#endif
