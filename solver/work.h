/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_WORK_H
#define HEATLADDER_SOLVER_WORK_H

/* The unit of field.work is one multiplication and addition in a stream of vectors.  Scalar work costs WORK_SCALAR
 * units per operation: a 512-bit vector has 8 doubles. */
enum {
    WORK_SCALAR = 8,
    WORK_FUNCTION = 20, /* operations of an exp or a sqrt: a polynomial of degree 13 or so */
    WORK_PLACE = 20,    /* per point, for position, heat and range: five passes of about four operations */
    WORK_SAMPLE = 16 + WORK_FUNCTION, /* per sample of the data: four comparisons on each of four sides */
    WORK_GHOST = 2                    /* per ghost and operator application: a load and a store */
};

#endif
