/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_WORK_H
#define HEATLADDER_SOLVER_WORK_H

/* The unit of field.work is one multiplication and addition in a stream of vectors.  Work done number by number
 * takes WORK_SCALAR of them for each operation: a vector of 512 bits holds 8 doubles. */
enum {
    WORK_SCALAR = 8,
    WORK_FUNCTION = 20,               /* operations of an exp or a sqrt: a polynomial of degree 13 or so */
    WORK_PLACE = 20,                  /* of a point's place, heat and range: five passes of some four */
    WORK_SAMPLE = 16 + WORK_FUNCTION, /* of a sample of the data: four comparisons on each of four sides */
    WORK_GHOST = 2                    /* of a ghost in each application: a load and a store */
};

#endif
