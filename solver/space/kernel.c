/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Smoothing kernels.
 *
 * cubic     w = a (2/3 - s^2 + s^3/2) for s < 1, a (2 - s)^3 / 6 for s < 2   (Monaghan & Lattanzio 1985)
 *
 * quartic   w = a (2/3 - 9/8 s^2 + 19/24 s^3 - 5/32 s^4)   (Liu & Liu 2003)
 *
 * wendland  w = a (1 - s/2)^4 (1 + 2 s), in 1D a (1 - s/2)^3 (1 + 3 s/2)   (Wendland 1995, C2)
 *
 * Pamplona eq. 9 prints the quartic with plus signs throughout, which is neither normalised nor decreasing.  The
 * intended kernel is slightly negative near s = 2 and not monotone there: w'(s) = -s (9/4 - 19/8 s + 5/8 s^2) a
 * changes sign at s = 1.8, where w < 0. */
#include "solver/space/kernel.h"

#include <math.h>

/* w, w' and w'' for s < 2, and the normalisation a in 1D, 2D and 3D, the inverse of the integral in closed form.
 * The names are those of kernels.def. */
struct kernel {
    double a[3];
    double (*value)(double a, int dim, double s);
    double (*slope)(double a, int dim, double s);
    double (*curvature)(double a, int dim, double s);
};

static double cubic_value(double a, int dim, double s) {
    (void)dim;
    return s < 1 ? a * (2.0 / 3 - s * s * (1 - s / 2)) : a * (2 - s) * (2 - s) * (2 - s) / 6;
}

static double cubic_slope(double a, int dim, double s) {
    (void)dim;
    return s < 1 ? -a * s * (2 - 1.5 * s) : -a * (2 - s) * (2 - s) / 2;
}

static double cubic_curvature(double a, int dim, double s) {
    (void)dim;
    return s < 1 ? a * (3 * s - 2) : a * (2 - s);
}

static double quartic_value(double a, int dim, double s) {
    (void)dim;
    return a * (2.0 / 3 - s * s * (9.0 / 8 - s * (19.0 / 24 - s * 5 / 32)));
}

static double quartic_slope(double a, int dim, double s) {
    (void)dim;
    return -a * s * (9.0 / 4 - s * (19.0 / 8 - s * 5 / 8));
}

static double quartic_curvature(double a, int dim, double s) {
    (void)dim;
    return -a * (9.0 / 4 - s * (19.0 / 4 - s * 15 / 8));
}

static double wendland_value(double a, int dim, double s) {
    double u = 1 - s / 2;
    return dim == 1 ? a * u * u * u * (1 + 1.5 * s) : a * u * u * u * u * (1 + 2 * s);
}

static double wendland_slope(double a, int dim, double s) {
    double u = 1 - s / 2;
    return dim == 1 ? -a * 3 * s * u * u : -a * 5 * s * u * u * u;
}

static double wendland_curvature(double a, int dim, double s) {
    double u = 1 - s / 2;
    return dim == 1 ? -a * 3 * u * (u - s) : -a * 5 * u * u * (u - 1.5 * s);
}

static const struct kernel
    cubic = {{1, 15 / (7 * M_PI), 3 / (2 * M_PI)}, cubic_value, cubic_slope, cubic_curvature},
    quartic = {{1, 15 / (7 * M_PI), 315 / (208 * M_PI)}, quartic_value, quartic_slope, quartic_curvature},
    wendland = {{5.0 / 8, 7 / (4 * M_PI), 21 / (16 * M_PI)}, wendland_value, wendland_slope, wendland_curvature};

static const struct kernel *const kernels[] = {
#define KERNEL(NAME, name) [KERNEL_##NAME] = &name,
#include "solver/kernels.def"
#undef KERNEL
};

double kernel_value(enum kernel_name kernel, int dim, double s) {
    const struct kernel *k = kernels[kernel];
    return s >= KERNEL_SUPPORT ? 0 : k->value(k->a[dim - 1], dim, s);
}

double kernel_slope(enum kernel_name kernel, int dim, double s) {
    const struct kernel *k = kernels[kernel];
    return s >= KERNEL_SUPPORT ? 0 : k->slope(k->a[dim - 1], dim, s);
}

double kernel_curvature(enum kernel_name kernel, int dim, double s) {
    const struct kernel *k = kernels[kernel];
    return s >= KERNEL_SUPPORT ? 0 : k->curvature(k->a[dim - 1], dim, s);
}
