/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Euler's method: T += dt L(T) (Song eqs. 31, 37). |G| <= 1 on [-2, 0]. */
#include "solver/time/stepper.h"

static void updates(double dt, double bound, int stages, struct update *u) {
    (void)bound, (void)stages;
    u[0] = (struct update){.rate = dt, .self = 1};
}

static struct stage stage(int s, int j) {
    (void)s, (void)j;
    return (struct stage){.rate = 1};
}

static double complex amplification(int stages, double complex z) {
    (void)stages;
    return 1 + z;
}

static double interval(int stages) {
    (void)stages;
    return 2;
}

const struct stepper stepper_euler = {.name = "euler",
                                      .about = "Euler's method (Song)",
                                      .order = 1,
                                      .arrays = 2,
                                      .stages = 1,
                                      .updates = updates,
                                      .stage = stage,
                                      .amplification = amplification,
                                      .interval = interval};
