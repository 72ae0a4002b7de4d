/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_MESH_PEERS_H
#define HEATLADDER_VERIFICATION_BENCH_MESH_PEERS_H

/* Voronoi cells of a jittered cloud: ours beside those of other programs, on one thread. */

#include <stdio.h>

struct failure;

struct mesh_peer {
    const char *who;
    /* Words of a shell, whose "$@" is POINTS LO_X HI_X LO_Y HI_Y.  They print seconds, the sum of the areas and that
     * of the faces between particles; exit status 77 where the program is not installed. */
    const char *command;
};

extern const struct mesh_peer mesh_peers_table[]; /* ended by one without a name */

/* Writes a table of the seconds for n x n particles, BENCH_RUNS rounds of one after the other: medians and extremes,
 * and by how many times ours are faster, whose seconds count those of the particles and ghosts as well.
 * STATUS_NUMERICAL where a program failed, or its cells are not ours: a sum is off by more than 1e-9 of itself, some
 * n^2 roundings. */
int mesh_peers_run(const struct mesh_peer *table, int n, FILE *out, struct failure *why);

#endif
