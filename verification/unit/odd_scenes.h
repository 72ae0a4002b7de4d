#ifndef HEATLADDER_VERIFICATION_UNIT_ODD_SCENES_H
#define HEATLADDER_VERIFICATION_UNIT_ODD_SCENES_H

/* Every scene at odd parameters, all distinct, so that no swap or forgotten factor can hide. */

#include "references/scene.h"
#include "solver/method.h"

#include "verification/unit/near.h"

struct odd_scene {
    const char *name;
    double param[PARAM_MAX];
    double scale;    /* K, of the temperature differences */
    double step;     /* m, of the differences that check the equation */
    double earliest; /* s, from when on the solution is smooth over a few steps */
};

static const struct odd_scene odd_scenes[] = {
    {"plate", {0.13, 0.07, 0.31, 0.57, 0.83, 1.19, 0.11, 1, 23.7}, 1, 0.001, 20},
    {"rect-manufactured", {0.9, 0.6, 0.023, 0.0061, 1.9, 0.7, 1.3}, 2, 0.02, 0.1},
    {"rod-contact", {1.3, 0.13, 0.011, 2.3, 0.9, 0.0017, 0.61, 0.2, 1.1}, 1, 0.003, 0.9},
    {"rod-cosine", {1.3, 0.017, 2, 1.1, 0.6, 1.7}, 1, 0.02, 0.1},
    {"rod-gauss", {11, 1.9, 0.017, 4.3}, 1, 0.1, 0.1},
    {"rod-step", {1.7, 0.62, 0.013, 7.3, 2.385}, 7, 0.01, 1.5},
    {"square-step", {1.9, 0.47, 0.83, 0.013, 0.0071, 6.1, 3.7}, 6, 0.01, 2},
    {"wall-composite", {1.1, 0.37, 0.9, 1.3, 1.2, 0.013, 0.021, 0.3, 4}, 1, 0.01, 0.5},
};
enum { ODD_SCENES = sizeof odd_scenes / sizeof *odd_scenes };

/* The scene, and *p set up at the odd parameters. */
static inline const struct scene *odd_setup(const struct odd_scene *odd, struct problem *p) {
    struct failure why = {0};
    const struct scene *s = scene_find(odd->name);
    assert_non_null(s);
    scene_defaults(s, p);
    for (int i = 0; s->params[i].name; i++) p->param[i] = odd->param[i];
    int status = s->setup(p, &why);
    if (status) print_error("%s: %s\n", odd->name, why.text);
    assert_int_equal(status, STATUS_OK);
    return s;
}

/* A number in (0, 1), the same sequence on every machine. */
static inline double odd_random(unsigned long *state) {
    *state = (*state * 1103515245UL + 12345UL) & 0x7fffffffUL;
    return ((double)*state + 0.5) / 0x80000000UL;
}

#endif
