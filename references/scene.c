/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of scenes.  make writes build/scenes.inc from the descriptors in the files scene_*.c. */
#include "references/scene.h"

#include <stdlib.h>
#include <string.h>

#define SCENE(name) extern const struct scene scene_##name;
#include "scenes.inc"
#undef SCENE

#define SCENE(name) &scene_##name,
const struct scene *const scenes[] = {
#include "scenes.inc"
    NULL};
#undef SCENE

const struct scene *scene_find(const char *name) {
    for (const struct scene *const *s = scenes; *s; s++)
        if (strcmp((*s)->name, name) == 0) return *s;
    return NULL;
}

void scene_defaults(const struct scene *s, struct problem *p) {
    *p = (struct problem){0};
    for (int i = 0; s->params[i].name; i++) p->param[i] = s->params[i].value;
}

struct exact scene_exact(const struct scene *s, const struct problem *p, const double *x, double t) {
    void *shared = s->prepare ? s->prepare(p, t) : NULL;
    struct exact e = s->exact(p, shared, x, t);
    free(shared);
    return e;
}
