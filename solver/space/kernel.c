/* Smoothing kernels.
 *
 * cubic     w = a (2/3 - s^2 + s^3/2) for s < 1, a (2 - s)^3 / 6 for s < 2   (Monaghan & Lattanzio 1985)
 * quartic   w = a (2/3 - 9/8 s^2 + 19/24 s^3 - 5/32 s^4)                     (Liu & Liu 2003)
 * wendland  w = a (1 - s/2)^4 (1 + 2 s), in 1D a (1 - s/2)^3 (1 + 3 s/2)     (Wendland 1995, C2)
 *
 * Pamplona eq. 9 prints the quartic with plus signs throughout, which is neither normalised nor decreasing.  As
 * meant, it is slightly negative near s = 2 and not monotone there: w'(s) = -s (9/4 - 19/8 s + 5/8 s^2) a changes
 * sign at s = 1.8, where w < 0. */
#include "solver/space/kernel.h"

#include <math.h>

static const double norm[3][3] = {
    /* integrals over R^1, R^2 and R^3 in closed form */
    [KERNEL_CUBIC] = {1, 15 / (7 * M_PI), 3 / (2 * M_PI)},
    [KERNEL_QUARTIC] = {1, 15 / (7 * M_PI), 315 / (208 * M_PI)},
    [KERNEL_WENDLAND] = {5.0 / 8, 7 / (4 * M_PI), 21 / (16 * M_PI)},
};

double kernel_value(enum kernel_name kernel, int dim, double s) {
    if (s >= KERNEL_SUPPORT) return 0;
    double a = norm[kernel][dim - 1], u = 1 - s / 2;
    switch (kernel) {
    case KERNEL_CUBIC:
        return s < 1 ? a * (2.0 / 3 - s * s * (1 - s / 2)) : a * (2 - s) * (2 - s) * (2 - s) / 6;
    case KERNEL_QUARTIC:
        return a * (2.0 / 3 - s * s * (9.0 / 8 - s * (19.0 / 24 - s * 5 / 32)));
    default:
        return dim == 1 ? a * u * u * u * (1 + 1.5 * s) : a * u * u * u * u * (1 + 2 * s);
    }
}

double kernel_slope(enum kernel_name kernel, int dim, double s) {
    if (s >= KERNEL_SUPPORT) return 0;
    double a = norm[kernel][dim - 1], u = 1 - s / 2;
    switch (kernel) {
    case KERNEL_CUBIC:
        return s < 1 ? -a * s * (2 - 1.5 * s) : -a * (2 - s) * (2 - s) / 2;
    case KERNEL_QUARTIC:
        return -a * s * (9.0 / 4 - s * (19.0 / 8 - s * 5 / 8));
    default:
        return dim == 1 ? -a * 3 * s * u * u : -a * 5 * s * u * u * u;
    }
}

double kernel_curvature(enum kernel_name kernel, int dim, double s) {
    if (s >= KERNEL_SUPPORT) return 0;
    double a = norm[kernel][dim - 1], u = 1 - s / 2;
    switch (kernel) {
    case KERNEL_CUBIC:
        return s < 1 ? a * (3 * s - 2) : a * (2 - s);
    case KERNEL_QUARTIC:
        return -a * (9.0 / 4 - s * (19.0 / 4 - s * 15 / 8));
    default:
        return dim == 1 ? -a * 3 * u * (u - s) : -a * 5 * u * u * (u - 1.5 * s);
    }
}
