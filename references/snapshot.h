/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_SNAPSHOT_H
#define HEATLADDER_REFERENCES_SNAPSHOT_H

#include "references/scene.h"

/* The exact solution at one time for many points; shared terms are evaluated once. */
struct snapshot {
    const struct scene *scene;
    const struct problem *problem;
    double time; /* s */
    void *shared;
};

/* *scene and *problem must outlive the snapshot; release it with snapshot_free. */
struct snapshot snapshot_take(const struct scene *scene, const struct problem *problem, double time);
void snapshot_free(struct snapshot *s);

/* scene_exact at x (m) and the time of the snapshot. */
struct exact snapshot_at(const struct snapshot *s, const double *x);
/* The same at the n points (x[i], y[i], z[i]); y is NULL on a rod, z in the plane.  Batches of a few thousand points
 * are efficient. */
void snapshot_at_points(const struct snapshot *s, size_t n, const double *x, const double *y, const double *z,
                        struct exact *e);

#endif
