/* SPDX-License-Identifier: GPL-3.0-or-later */
/* disc-cooling: an initially warm disc cooled by the surrounding air; see round_cooling.c. */
#include "references/round_cooling.h"

static const struct param params[] = {
    {"radius", 1, "m", "radius of the disc", NULL},
    {"k", 0.01, "W/m/K", "conductivity", NULL},
    {"rho_c", 1, "J/m^3/K", "heat capacity", NULL},
    {"T0", 1, "K", "initial temperature", NULL},
    {"T_a", 0, "K", "temperature of the air", NULL},
    {"b", 0.02, "W/m^2/K", "heat transfer coefficient", NULL},
    {"t_end", 5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int setup(struct problem *p, struct failure *why) {
    return round_cooling_setup(params, 2, p, why);
}

const struct scene scene_disc_cooling = {
    .name = "disc-cooling",
    .about = "an initially warm disc cooled by the surrounding air",
    .citation = "Carslaw and Jaeger 1959, section 7.7",
    .params = params,
    .odd = {{1.3, 0.017, 1.9, 0.97, 0.21, 0.037, 11}, 1, 0.02, 3},
    .setup = setup,
    .prepare = round_cooling_prepare,
    .prepared = round_cooling_at,
    .second = round_cooling_second,
};
