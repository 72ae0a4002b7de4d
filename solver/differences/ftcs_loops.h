/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_LOOPS_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_LOOPS_H

#include <stddef.h>

/* Loops over a row of n points.  All pointers are to the first point of the row; T is read one point beyond either
 * end. */
struct ftcs_loops {
    /* next = T + Fx (T_(i+1) - 2 T_i + T_(i-1)) */
    void (*rod)(int n, double Fx, const double *restrict T, double *restrict next);
    /* two materials: next = T + dt (right (T_(i+1) - T_i) - left (T_i - T_(i-1))) */
    void (*layers)(int n, double dt, const double *restrict left, const double *restrict right,
                   const double *restrict T, double *restrict next);
    /* a row of a rectangle of two materials: the same + dt across (T_above - 2 T_i + T_below) */
    void (*layers_row)(int n, double dt, const double *restrict left, const double *restrict right,
                       const double *restrict across, const double *restrict T, const double *restrict below,
                       const double *restrict above, double *restrict next);
    /* a row of a rectangle */
    void (*row)(int n, double Fx, double Fy, const double *restrict T, const double *restrict below,
                const double *restrict above, double *restrict next);
    /* a row of a box: F by axis, `up` and `over` the offsets along y and z */
    void (*box)(int n, const double F[3], const double *restrict T, ptrdiff_t up, ptrdiff_t over,
                double *restrict next);
    /* two materials: next += dt across (T_over - 2 T_i + T_under) */
    void (*lateral)(int n, double dt, const double *restrict across, const double *restrict T, ptrdiff_t over,
                    double *restrict next);
    /* to = (with `add`: to +=) factor (ahead - behind) */
    void (*difference)(int n, double factor, const double *restrict ahead, const double *restrict behind, int add,
                       double *restrict to);
    /* T += dt heating */
    void (*accumulate)(int n, double dt, const double *restrict heating, double *restrict T);
    /* number of points outside middle +- reach */
    int (*outside)(int n, double middle, double reach, const double *T);
};

/* Loops for vectors of 2, 4 or 8 doubles; 0: the widest that the machine supports. */
const struct ftcs_loops *ftcs_loops_of(int lanes);

#endif
