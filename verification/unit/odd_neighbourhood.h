/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_ODD_NEIGHBOURHOOD_H
#define HEATLADDER_VERIFICATION_UNIT_ODD_NEIGHBOURHOOD_H

/* A neighbourhood without any symmetry, and the weights that a discrete Laplacian has there. */

#include "solver/space/operator.h"

#include "verification/unit/near.h"

#include <string.h>

enum { MANY = 15 };
static const double H = 0.061, VOLUME = 0.0017, KX = 0.71, KY = 0.43;

/* Neighbours with no symmetry, 0.02 to 0.12 m away, and their temperatures less that of the particle. */
static double place[MANY][DIM_MAX] = {{0.041, 0.013},  {-0.052, 0.007}, {0.003, 0.049},  {-0.011, -0.055},
                                      {0.063, -0.038}, {-0.047, 0.058}, {0.034, 0.071},  {-0.069, -0.041},
                                      {0.083, 0.029},  {-0.089, 0.019}, {0.017, -0.101}, {-0.021, 0.093},
                                      {0.022, -0.029}, {0.097, -0.011}, {-0.027, 0.023}};
static const double field[MANY] = {1.31, -0.72, 0.41,  2.17, -1.13, 0.93, 0.29, -2.31,
                                   0.57, 1.91,  -0.37, 0.83, -1.47, 1.03, 0.67};

static inline const struct method *named(const char *name) {
    for (int i = 0; methods[i]; i++)
        if (strcmp(methods[i]->name, name) == 0) return methods[i];
    return NULL;
}

static inline struct neighbourhood around(int dim, const double kappa[2]) {
    return (struct neighbourhood){.dim = dim,
                                  .i = 3,
                                  .x = {0.7, -0.3},
                                  .n = MANY,
                                  .d = place,
                                  .h = H,
                                  .volume = VOLUME,
                                  .rho_c = 1.3,
                                  .kappa = {kappa[0], kappa[1]}};
}

static inline void weights_of(const char *name, const struct neighbourhood *nb, double w[2][MANY]) {
    struct problem p = odd_rectangle();
    struct options o = {.kernel = KERNEL_CUBIC};
    struct failure why = {0};
    double *out[2] = {w[0], w[1]};
    if (operator_weights(named(name)->scheme, &p, &o, nb, out, &why)) print_error("%s\n", why.text);
    assert_int_equal(why.status, STATUS_OK);
}

#endif
