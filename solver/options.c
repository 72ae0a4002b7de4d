/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names of the option values, derived settings, and the vector width. */
#include "solver/options.h"

#include <stddef.h>

#define KERNEL(NAME, name) #name,
const char *const kernel_words[] = {
#include "solver/kernels.def"
    NULL};
#undef KERNEL
#define STEPPER(NAME, name) #name,
const char *const stepper_words[] = {"auto",
#include "solver/steppers.def"
                                     NULL};
#undef STEPPER
const char *const layout_words[] = {
    [LAYOUT_LATTICE] = "lattice", [LAYOUT_NODE] = "node",           [LAYOUT_JITTER] = "jitter",
    [LAYOUT_RELAXED] = "relaxed", [LAYOUT_HEXAGONAL] = "hexagonal", NULL};
const char *const sampling_words[] = {
    [SAMPLING_POINT] = "point", [SAMPLING_CELL] = "cell", [SAMPLING_SPLINE] = "spline", NULL};
const char *const walls_words[] = {
    [WALLS_MIRROR] = "mirror", [WALLS_FIXED] = "fixed", [WALLS_DISTANCE] = "distance",   [WALLS_AVERAGE] = "average",
    [WALLS_IMAGE] = "image",   [WALLS_FIT] = "fit",     [WALLS_ONE_SIDED] = "one_sided", NULL};
const char *const mean_words[] = {
    [MEAN_AUTO] = "auto",     [MEAN_HARMONIC] = "harmonic",   [MEAN_ARITHMETIC] = "arithmetic",
    [MEAN_SERIES] = "series", [MEAN_KIRCHHOFF] = "kirchhoff", NULL};
const char *const domain_words[] = {[DOMAIN_SYMMETRY] = "symmetry", [DOMAIN_WHOLE] = "whole", NULL};
const char *const volume_words[] = {[VOLUME_MOMENT] = "moment", [VOLUME_RAW] = "raw", [VOLUME_TUNED] = "tuned", NULL};

int options_lanes_most(void) {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return 8;
    if (__builtin_cpu_supports("avx2")) return 4;
#endif
    return 2;
}

double options_spacing(const struct options *o, int axis) {
    return axis == 1 && o->aspect > 0 ? o->aspect * o->dx : o->dx;
}

int options_is_matched(const struct options *o) {
    return o->stepper == STEPPER_MATCHED;
}

int options_is_cloud(const struct options *o) {
    return o->layout != LAYOUT_LATTICE && o->layout != LAYOUT_NODE;
}
