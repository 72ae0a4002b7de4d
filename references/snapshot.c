/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The exact solution at one time. */
#include "references/snapshot.h"

#include <stdlib.h>

struct snapshot snapshot_take(const struct scene *scene, const struct problem *problem, double time) {
    return (struct snapshot){scene, problem, time, scene->prepare ? scene->prepare(problem, time) : NULL};
}

void snapshot_free(struct snapshot *s) {
    free(s->shared);
    s->shared = NULL;
}

struct exact snapshot_at(const struct snapshot *s, const double *x) {
    return s->scene->exact(s->problem, s->shared, x, s->time);
}

void snapshot_at_points(const struct snapshot *s, size_t n, const double *x, const double *y, const double *z,
                        struct exact *e) {
    if (s->scene->at_points) {
        s->scene->at_points(s->problem, s->shared, n, (const double *const[]){x, y, z}, s->time, e);
        return;
    }
    for (size_t i = 0; i < n; i++) e[i] = snapshot_at(s, (double[]){x[i], y ? y[i] : 0, z ? z[i] : 0});
}
