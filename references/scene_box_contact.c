/* SPDX-License-Identifier: GPL-3.0-or-later */
/* box-contact: the slowest mode of a box of two materials in contact at x = w1, a cosine along y and z; see
 * contact.c. */
#include "references/contact.h"

static const struct param params[] = {
    {"w1", 0.4, "m", "width of the first material, x < w1", NULL},
    {"w2", 0.6, "m", "width of the second material", NULL},
    {"height", 0.5, "m", "extent along y", NULL},
    {"k1", 0.02, "W/m/K", "conductivity of the first material", NULL},
    {"rho_c1", 1, "J/m^3/K", "heat capacity of the first material", NULL},
    {"k2", 0.002, "W/m/K", "conductivity of the second material", NULL},
    {"rho_c2", 0.5, "J/m^3/K", "heat capacity of the second material", NULL},
    {"mode", 1, "", "number of half waves along y, an integer", NULL},
    {"Tm", 2, "K", "mean temperature, also that of the walls", NULL},
    {"A", 1, "K", "initial maximum of the mode, below Tm", NULL},
    {"depth", 1.2, "m", "extent along z", NULL},
    {"mode_z", 2, "", "number of half waves along z, an integer", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int setup(struct problem *p, struct failure *why) {
    return contact_setup(params, 3, p, why);
}

const struct scene scene_box_contact = {
    .name = "box-contact",
    .about = "the slowest mode of a box of two materials in contact",
    .citation = "Carslaw and Jaeger 1959, section 12.8",
    .params = params,
    .setup = setup,
    .exact = contact_exact,
    .second = contact_second,
    .odd = {{0.37, 0.59, 0.83, 0.019, 1.3, 0.0023, 0.61, 2, 2.1, 1.2, 0.67, 1, 1.7}, 1, 0.003, 0.1},
};
