/* The words of the options. */
#include "solver/options.h"

#include <stddef.h>

const char *const kernel_words[] = {
    [KERNEL_CUBIC] = "cubic", [KERNEL_QUARTIC] = "quartic", [KERNEL_WENDLAND] = "wendland", NULL};
const char *const stepper_words[] = {[STEPPER_AUTO] = "auto",
                                     [STEPPER_EULER] = "euler",
                                     [STEPPER_RK2] = "rk2",
                                     [STEPPER_RKL2] = "rkl2",
                                     [STEPPER_EXACT] = "exact",
                                     [STEPPER_MATCHED] = "matched",
                                     NULL};
const char *const layout_words[] = {
    [LAYOUT_LATTICE] = "lattice", [LAYOUT_NODE] = "node", [LAYOUT_JITTER] = "jitter", NULL};
const char *const sampling_words[] = {
    [SAMPLING_POINT] = "point", [SAMPLING_CELL] = "cell", [SAMPLING_SPLINE] = "spline", NULL};
const char *const walls_words[] = {[WALLS_MIRROR] = "mirror", [WALLS_FIXED] = "fixed", NULL};
const char *const mean_words[] = {
    [MEAN_HARMONIC] = "harmonic", [MEAN_ARITHMETIC] = "arithmetic", [MEAN_SERIES] = "series", NULL};
const char *const domain_words[] = {[DOMAIN_FOLDED] = "folded", [DOMAIN_WHOLE] = "whole", NULL};
const char *const volume_words[] = {[VOLUME_MOMENT] = "moment", [VOLUME_RAW] = "raw", [VOLUME_TUNED] = "tuned", NULL};
