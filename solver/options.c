/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names of the option values, their ranges, derived settings, and the vector width. */
#include "solver/options.h"

#include <math.h>
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
const char *const cross_words[] = {[CROSS_FACE] = "face", [CROSS_CORNER] = "corner", NULL};
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

int options_check(const struct options *o, struct failure *why) {
    const int given[] = {o->dt != 0, o->fourier != 0}; /* NaN is given */
    const struct {
        const char *name;
        double value, hi;
    } number[] = {{"dx", o->dx, INFINITY}, {"dt", o->dt, INFINITY},    {"fourier", o->fourier, INFINITY},
                  {"h", o->h, INFINITY},   {"jitter", o->jitter, 0.5}, {"xi", o->xi, INFINITY}};
    const struct {
        int refuses;
        const char *name;
        double value;
        const char *reason, *take;
    } rule[] = {
        {o->jitter > 0 && o->layout != LAYOUT_JITTER && o->layout != LAYOUT_RELAXED, "jitter", o->jitter,
         "these particles do not move", "--layout jitter or relaxed"},
        {o->sweeps > 0 && o->layout != LAYOUT_RELAXED, "sweeps", o->sweeps, "these particles do not settle",
         "--layout relaxed"},
        {o->xi > 0 && o->volume != VOLUME_TUNED, "xi", o->xi, "this volume has no parameter", "--volume tuned"},
        {given[0] && o->stepper == STEPPER_EXACT, "dt", o->dt, "the stepper takes no time step", "another --stepper"},
        {given[1] && o->stepper == STEPPER_EXACT, "fourier", o->fourier, "the stepper takes no time step",
         "another --stepper"},
    };
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        if (!(number[i].value >= 0 && number[i].value <= number[i].hi && isfinite(number[i].value)))
            return refuse(why, STATUS_INPUT, "--%s %g: must be a finite number > 0%s", number[i].name,
                          number[i].value, isinf(number[i].hi) ? "" : ", at most 0.5");
    if (o->order && (o->order < 2 || o->order > 4))
        return refuse(why, STATUS_INPUT, "--order %d: must be 2, 3 or 4", o->order);
    if (given[0] && given[1])
        return refuse(why, STATUS_INPUT, "--dt and --fourier exclude each other: give one of them");
    for (size_t i = 0; i < sizeof rule / sizeof *rule; i++)
        if (rule[i].refuses)
            return refuse(why, STATUS_INPUT, "--%s %g: %s; take %s", rule[i].name, rule[i].value, rule[i].reason,
                          rule[i].take);
    return STATUS_OK;
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
