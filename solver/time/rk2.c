/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The midpoint rule: H = T + dt/2 L(T), T += dt L(H) (Pamplona section 3.3). |G| <= 1 on [-2, 0]. */
#include "solver/time/stepper.h"

static void updates(double dt, double bound, int stages, struct update *u) {
    (void)bound, (void)stages;
    u[0] = (struct update){.rate = dt / 2, .self = 1};
    u[1] = (struct update){.rate = dt, .old = 1};
}

static struct stage stage(int s, int j) {
    (void)s;
    const struct stage half = {.rate = 0.5}, whole = {.rate = 1, .time = 0.5};
    return j == 1 ? half : whole;
}

static double complex amplification(int stages, double complex z) {
    (void)stages;
    return 1 + z + z * z / 2;
}

static double interval(int stages) {
    (void)stages;
    return 2;
}

const struct stepper stepper_rk2 = {.name = "rk2",
                                    .about = "the midpoint rule (Pamplona)",
                                    .order = 2,
                                    .arrays = 2,
                                    .stages = 2,
                                    .updates = updates,
                                    .stage = stage,
                                    .amplification = amplification,
                                    .interval = interval};
