/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_DIAGNOSED_PROBLEMS_H
#define HEATLADDER_VERIFICATION_UNIT_DIAGNOSED_PROBLEMS_H

/* Scenes with parameters that show every fault. */

#include "references/scene.h"
#include "solver/problem.h"
#include "solver/status.h"

#include "verification/unit/near.h"

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

#endif
