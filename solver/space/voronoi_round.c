/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A cell cut by a round wall.
 *
 * Each edge is cut at its intersection with the circle; both particles of a pair find the same point, so their face
 * is the same.  The area inside a circle is an integral along the polygon: for an edge inside, the triangle with the
 * centre; for one outside, the sector of its angle.  The angles of the sectors sum to the part of the circle inside
 * the cell.  The areas therefore sum to that of the body and the walls to its circles, to round-off, for any
 * intersection. */
#include "solver/space/voronoi_round.h"

#include <math.h>

static double cross(const double a[2], const double b[2]) {
    return a[0] * b[1] - a[1] * b[0];
}

static double angle(const double a[2], const double b[2]) {
    return atan2(cross(a, b), a[0] * b[0] + a[1] * b[1]);
}

/* The part t[0] to t[1] of the edge from a to b inside the circle; t[0] = t[1] if there is none. */
static void within(const double a[2], const double b[2], double R, double t[2]) {
    double e[2] = {b[0] - a[0], b[1] - a[1]}, square = e[0] * e[0] + e[1] * e[1],
           middle = -(a[0] * e[0] + a[1] * e[1]);
    double half = middle * middle + square * (R * R - a[0] * a[0] - a[1] * a[1]);
    t[0] = t[1] = 0;
    if (!(half > 0)) return;
    t[0] = fmin(fmax((middle - sqrt(half)) / square, 0), 1);
    t[1] = fmin(fmax((middle + sqrt(half)) / square, 0), 1);
}

/* Adds the contribution of the edge from a to b to area and angle of the circle of radius R; returns the length
 * inside. */
static double add_edge(const double a[2], const double b[2], double R, double t[2], double *area, double *arc) {
    double end[2][2], length = hypot(b[0] - a[0], b[1] - a[1]);
    within(a, b, R, t);
    for (int s = 0; s < 2; s++)
        for (int k = 0; k < 2; k++) end[s][k] = a[k] + t[s] * (b[k] - a[k]);
    double outside = (t[0] > 0 ? angle(a, end[0]) : 0) + (t[1] < 1 ? angle(end[1], b) : 0);
    *area += (cross(end[0], end[1]) + R * R * outside) / 2;
    *arc += outside;
    return length * (t[1] - t[0]);
}

struct voronoi_round voronoi_round(const struct voronoi_polygon *cell, const double at[2], const double radius[2]) {
    struct voronoi_round r = {.area = 0};
    double area[2] = {0, 0}, arc[2] = {0, 0}, t[2];
    for (int k = 0; k < cell->n; k++) {
        int next = k + 1 < cell->n ? k + 1 : 0;
        const double a[2] = {at[0] + cell->x[k], at[1] + cell->y[k]};
        const double b[2] = {at[0] + cell->x[next], at[1] + cell->y[next]};
        double hole = radius[0] > 0 ? add_edge(a, b, radius[0], t, &area[0], &arc[0]) : 0;
        r.face[k] = add_edge(a, b, radius[1], t, &area[1], &arc[1]) - hole;
        if (!(r.face[k] > 0)) continue;
        for (int s = 0; s < 2; s++) {
            double x = cell->x[k] + t[s] * (b[0] - a[0]), y = cell->y[k] + t[s] * (b[1] - a[1]);
            r.farthest = fmax(r.farthest, x * x + y * y);
        }
    }
    r.area = area[1] - area[0];
    for (int s = 0; s < 2; s++) r.wall[s] = arc[s] * radius[s];
    return r;
}
