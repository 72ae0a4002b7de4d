/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Box and Gaussian between two Dirichlet walls at zero, by images and by modes.
 *
 * Images: a wall at zero is a plane of odd symmetry of a medium without walls, so a source between walls at -L and L
 * has images at 2kL with sign (-1)^k:  u(x) = sum_k (-1)^k U(x - 2kL).  Few images are significant for
 * s = sqrt(4 kappa t) < L.
 *
 * Modes: data even about x = 0 expand in cos(q x), q = (n + 1/2) pi/L, which vanish at the walls.  Each mode decays
 * as exp(-q^2 kappa t) = exp(-(q s/2)^2).  Few modes are significant for s > L.  Poisson's summation formula links
 * the two forms (Carslaw and Jaeger 1959, chapters 3 and 10); they share no term.
 *
 * Restrictions: one material, both walls at zero, data even about the middle. */
#include "references/series.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_errno.h>

enum { MODES_MAX = 20000, IMAGES_MAX = 100000 };
static const double negligible = 1e-18;                              /* relative to a unit amplitude */
static const struct curve no_bound = {{0, INFINITY}, {0, INFINITY}}; /* for sums that would need more terms */

double series_box_line(double x, double a, double s) {
    if (s == 0) return series_in_box(x, a);
    return (erf((a + x) / s) + erf((a - x) / s)) / 2;
}

/* Number of images on either side within `reach` of x, up to IMAGES_MAX; `half` is the half width of the source. */
static int images_within(double x, double L, double half, double reach) {
    double k = ceil((reach + fabs(x) + half) / (2 * L)) - 1;
    return k > 0 ? (int)fmin(k, IMAGES_MAX) : 0;
}

/* (erf(z + h) - erf(z - h))/2 for h <= 1/4 without cancellation: the Taylor series of erf about z in Hermite
 * polynomials (Abramowitz and Stegun 1964, 7.1.19),
 *
 *     2/sqrt(pi) exp(-z^2) sum over even n of h^(n+1)/(n+1)! H_n(z),   H_(n+1) = 2 z H_n - 2 n H_(n-1).
 *
 * At z = SERIES_REACH the terms decay as 3.1^n/(n+1)!; the terms n > 30 are 1e-20 of the sum.  Terms of opposite
 * sign are at most exp(2 h^2) - 1 of the sum. */
static double pulse(double z, double h) {
    double before = 0, g = 1, factorial = 1, sum = 1; /* g = h^n H_n */
    for (int n = 0; n < 30; n++) {
        double next = 2 * z * h * g - 2 * n * h * h * before;
        before = g;
        g = next;
        factorial *= n + 2;
        if (n % 2) sum += g / factorial;
    }
    return 2 / sqrt(M_PI) * h * exp(-z * z) * sum;
}

/* One image, unsigned, at the distance d >= 0 from its centre; the error of d is `lost` in units of eps.  The
 * arguments v = (d -+ a)/s have the error eps (2 |v| + lost/s), which changes erfc by a factor 2/sqrt(pi) exp(-v^2)
 * of it.  The error of erfc itself is 5 units in the last place (glibc). */
static struct curve box_image(double d, double a, double s, double lost) {
    double in = (d - a) / s, out = (d + a) / s, edge = exp(-in * in) / sqrt(M_PI);
    struct curve u;
    if (4 * a > s) {
        double near = erfc(in), far = erfc(out);
        u.at.value = (near - far) / 2;
        u.at.error = DBL_EPSILON * (3 * (near + far) + edge * (2 * fabs(in) + lost / s));
        double other = exp(-out * out) / sqrt(M_PI);
        u.slope.value = (other - edge) / s;
        u.slope.error =
            DBL_EPSILON / s * (edge * (4 + (2 * fabs(in) + lost / s) * 2 * fabs(in)) + other * (4 + 4 * out * out));
    } else {
        double z = d / s, h = a / s, relative = 12 + 2 * z * (2 * z + lost / s);
        u.at.value = pulse(z, h);
        u.at.error = DBL_EPSILON * relative * u.at.value;
        u.slope.value = -2 / sqrt(M_PI) / s * exp(-z * z - h * h) * sinh(2 * z * h);
        u.slope.error = DBL_EPSILON * (relative * fabs(u.slope.value) + 4 * u.at.value * lost / (s * s));
    }
    return u;
}

struct curve series_box_images(double x, double L, double a, double s) {
    if (s == 0) return (struct curve){{series_in_box(x, a), 0}, {0, 0}};
    int K = images_within(x, L, a, SERIES_REACH * s);
    double beyond = 2.2 * fmin(3.2e-18, 7.8e-17 * a / s); /* erfc(reach)/2, or 2 a/s exp(-reach^2)/sqrt(pi) */
    struct curve sum = {{0, beyond}, {0, beyond * 2 * SERIES_REACH / s}};
    if (K == IMAGES_MAX) return no_bound;
    for (int k = -K; k <= K; k++) {
        double to = x - 2 * k * L, d = fabs(to);
        if (d - a > SERIES_REACH * s) continue;
        struct curve u = box_image(d, a, s, k ? fabs(2 * k * L) + d : 0);
        double sign = k % 2 ? -1 : 1;
        sum.at.value += sign * u.at.value;
        sum.slope.value += (to < 0 ? -sign : sign) * u.slope.value;
        sum.at.error += u.at.error + DBL_EPSILON * u.at.value;
        sum.slope.error += u.slope.error + DBL_EPSILON * fabs(u.slope.value);
    }
    return sum;
}

/* Rounding: 6 eps relative in the exponent E = (q s/2)^2, 2 eps relative in the phases q a and q x. */
struct curve series_box_modes(double x, double L, double a, double s) {
    struct curve sum = {{0, 0}, {0, 0}};
    double tail = 0, steep = 0, small = fmin(1, 2 * a / L); /* |2 sin(q a)/(q L)| <= 2 a/L */
    for (int n = 0; n < MODES_MAX; n++) {
        double q = (n + 0.5) * M_PI / L, E = (q * s / 2) * (q * s / 2), decay = exp(-E), c = 2 / (q * L) * decay;
        double amplitude = c * sin(q * a), rounding = fabs(amplitude) * (4 + 6 * E) + 2 * c * q * a;
        sum.at.value += amplitude * cos(q * x);
        sum.slope.value -= amplitude * q * sin(q * x);
        sum.at.error += DBL_EPSILON * (rounding + 2 * fabs(amplitude) * q * fabs(x));
        sum.slope.error += DBL_EPSILON * q * (rounding + fabs(amplitude) * (2 + 2 * q * fabs(x)));
        double ratio = exp(-q * M_PI / L * s * s / 2); /* bound on the ratio of consecutive later modes */
        tail = fmin(1, fmin(2 / (q * L), small) * decay * ratio / (1 - ratio));
        steep = fmin(2 / L, q * small) * decay * ratio / (1 - ratio) * (1 + 1 / ((n + 0.5) * (1 - ratio)));
        if (tail <= negligible * small && steep * L <= 10 * negligible * small) break;
    }
    sum.at.error += tail;
    sum.slope.error += steep;
    return sum;
}

struct curve series_box(double x, double L, double a, double s) {
    return s <= L ? series_box_images(x, L, a, s) : series_box_modes(x, L, a, s);
}

struct curve series_box_other(double x, double L, double a, double s) {
    return s <= L ? series_box_modes(x, L, a, s) : series_box_images(x, L, a, s);
}

/* The error of z = (x - 2kL)/sigma, with rounded sigma, is eps (2 |z| + |2kL|/sigma); exp(-z^2/2) changes by z times
 * that. */
struct curve series_gauss_images(double x, double L, double sigma) {
    const double reach = 9.3 * sigma; /* exp(-9.3^2/2) = 1.7e-19; the slope has the further factor 9.3 */
    int K = images_within(x, L, 0, reach);
    struct curve sum = {{0, 2 * negligible}, {0, 4 * negligible / sigma}};
    if (K == IMAGES_MAX) return no_bound;
    for (int k = -K; k <= K; k++) {
        double z = (x - 2 * k * L) / sigma, u = exp(-z * z / 2), sign = k % 2 ? -1 : 1;
        double lost = DBL_EPSILON * (2 * fabs(z) + fabs(2 * k * L) / sigma);
        sum.at.value += sign * u;
        sum.slope.value -= sign * u * z / sigma;
        sum.at.error += u * (2 * DBL_EPSILON + fabs(z) * lost);
        sum.slope.error += u / sigma * (4 * DBL_EPSILON * fabs(z) + (1 + z * z) * lost);
    }
    return sum;
}

/* The coefficient of mode q is 1/L times the integral of exp(-x^2/(2 sigma^2)) cos(q x) over the whole line: images
 * of the source and the antiperiod 2L of the mode change sign together. */
struct curve series_gauss_modes(double x, double L, double sigma) {
    double amplitude = sqrt(2 * M_PI) * sigma / L;
    struct curve sum = {{0, 2 * negligible}, {0, 40 * negligible / L}};
    for (int n = 0; n < MODES_MAX; n++) {
        double q = (n + 0.5) * M_PI / L, z = q * sigma, c = amplitude * exp(-z * z / 2);
        double error = DBL_EPSILON * c * (4 + 4 * z * z + 2 * q * fabs(x));
        sum.at.value += c * cos(q * x);
        sum.slope.value -= c * q * sin(q * x);
        sum.at.error += error;
        sum.slope.error += q * error;
        if (c <= negligible * amplitude) return sum;
    }
    return no_bound;
}

struct curve series_gauss(double x, double L, double sigma) {
    return sigma <= L ? series_gauss_images(x, L, sigma) : series_gauss_modes(x, L, sigma);
}

struct curve series_gauss_other(double x, double L, double sigma) {
    return sigma <= L ? series_gauss_modes(x, L, sigma) : series_gauss_images(x, L, sigma);
}
