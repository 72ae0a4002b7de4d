/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_VORONOI_ROUND_H
#define HEATLADDER_SOLVER_SPACE_VORONOI_ROUND_H

#include "solver/space/voronoi_cell.h"

/* The part of a cell between two circles about 0. */
struct voronoi_round {
    double face[VORONOI_CORNERS]; /* m, by edge */
    double wall[2];               /* m, arc length of the inner and the outer circle inside the cell */
    double area;                  /* m^2 */
    double farthest;              /* m^2, largest squared distance of an end of a face from the particle */
};

/* The cell of a particle at `at`; radius[0] may be 0. */
struct voronoi_round voronoi_round(const struct voronoi_polygon *cell, const double at[2], const double radius[2]);

#endif
