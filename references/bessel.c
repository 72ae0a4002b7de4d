/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scaled modified Bessel functions of a complex argument on Talbot's contour.
 *
 * For |z| <= 30: the mean over tau of exp(z (cos tau - 1)) cos(n tau) by the trapezoidal rule.  Its terms are at
 * most 1; N points give the aliasing error exp(-z) I_(N-n)(z).  For |z| > 30: both parts of Hankel's series
 * (Abramowitz and Stegun 1964, 9.7.1 and 9.2.5).  For Im z >= 0
 *
 *     exp(-z) I_n = (S(-1/z) + i^(1 + 2n) exp(-2 z) S(1/z))/sqrt(2 pi z)
 *
 * and the smallest term of S is below exp(-2 |z|). */
#include "references/bessel.h"

#include <math.h>

static double complex by_integral(int n, double complex z) {
    enum { N = 96 };
    double complex sum = 0;
    for (int k = 0; k <= N / 2; k++) {
        double tau = 2 * M_PI * k / N, c = cos(tau);
        sum += (k == 0 || k == N / 2 ? 1 : 2) * cexp(z * (c - 1)) * (n ? c : 1);
    }
    return sum / N;
}

static double complex by_hankel(int n, double complex z) {
    enum { TERMS = 22 };
    double complex term = 1, even = 1, odd = 0, second = 0;
    for (int k = 1; k <= TERMS; k++) {
        term *= (4 * n * n - (2 * k - 1) * (2 * k - 1)) / (8.0 * k * z);
        if (k % 2)
            odd += term;
        else
            even += term;
    }
    if (creal(z) < 20) second = (cimag(z) < 0 ? -I : I) * (n ? -1 : 1) * cexp(-2 * z) * (even + odd);
    return (even - odd + second) / csqrt(2 * M_PI * z);
}

double complex bessel_scaled(int n, double complex z) {
    return cabs(z) <= 30 ? by_integral(n, z) : by_hankel(n, z);
}
