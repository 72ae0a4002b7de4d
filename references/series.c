/* Box and Gaussian between two walls at zero, from images and from modes.
 *
 * Images: a wall at zero is the plane of odd symmetry of a medium without walls, so a source between walls at -L and
 * L has images at 2kL of sign (-1)^k:  u(x) = sum_k (-1)^k U(x - 2kL).  Few are needed while s = sqrt(4 kappa t) < L.
 * Modes: data even about x = 0 expand in cos(q x), q = (n + 1/2) pi/L, which vanish at the walls, and each decays as
 * exp(-q^2 kappa t) = exp(-(q s/2)^2).  Few are needed once s > L.  The two are linked by Poisson's summation formula
 * (Carslaw and Jaeger 1959, chapters 3 and 10), and share no term.
 *
 * Restrictions: one material, both walls Dirichlet zero, data even about the middle. */
#include "references/series.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sum.h>

static const double pi = 3.14159265358979323846;

enum { MODES_MAX = 20000 };
static const double negligible = 1e-18; /* of a unit amplitude */

double series_box_line(double x, double a, double s) {
    if (s == 0) return series_in_box(x, a);
    return (erf((a + x) / s) + erf((a - x) / s)) / 2;
}

/* How many images on either side lie within `reach` of x; `half` is half the width of the source. */
static int images_within(double x, double L, double half, double reach) {
    double k = ceil((reach + fabs(x) + half) / (2 * L)) - 1;
    return k > 0 ? (int)fmin(k, 1e6) : 0;
}

struct approx series_box_images(double x, double L, double a, double s) {
    if (s == 0) return (struct approx){series_in_box(x, a), 0};
    int K = images_within(x, L, a, SERIES_REACH * s);
    double sum = 0, error = 2e-17;
    for (int k = -K; k <= K; k++) {
        double d = fabs(x - 2 * k * L);
        if (d - a > SERIES_REACH * s) continue;
        /* erfc, since the difference of two erf near 1 would lose the far tail */
        double u = (erfc((d - a) / s) - erfc((d + a) / s)) / 2;
        sum += k % 2 ? -u : u;
        error += DBL_EPSILON * (2 * u + fabs(2 * k * L) / s);
    }
    return (struct approx){sum, error + DBL_EPSILON * fabs(sum)};
}

struct approx series_box_modes(double x, double L, double a, double s) {
    double sum = 0, size = 0, tail = 0;
    for (int n = 0; n < MODES_MAX; n++) {
        double q = (n + 0.5) * pi / L, decay = exp(-(q * s / 2) * (q * s / 2));
        double c = 2 / (q * L) * decay;
        sum += c * sin(q * a) * cos(q * x);
        size += c * (1 + q * (a + fabs(x)));         /* the phases q a and q x are rounded too */
        double ratio = exp(-q * pi / L * s * s / 2); /* of each later mode to the one before, at most */
        tail = fmin(1, c * ratio / (1 - ratio));
        if (tail <= negligible) break;
    }
    return (struct approx){sum, tail + DBL_EPSILON * size};
}

struct approx series_box(double x, double L, double a, double s) {
    return s <= L ? series_box_images(x, L, a, s) : series_box_modes(x, L, a, s);
}

struct approx series_box_other(double x, double L, double a, double s) {
    return s <= L ? series_box_modes(x, L, a, s) : series_box_images(x, L, a, s);
}

struct approx series_gauss_images(double x, double L, double sigma) {
    const double reach = 9.1 * sigma; /* exp(-9.1^2/2) = 1.0e-18 */
    int K = images_within(x, L, 0, reach);
    double sum = 0, error = 2 * negligible;
    for (int k = -K; k <= K; k++) {
        double z = (x - 2 * k * L) / sigma, u = exp(-z * z / 2);
        sum += k % 2 ? -u : u;
        error += DBL_EPSILON * u * (2 + z * z + fabs(z * 2 * k * L / sigma));
    }
    return (struct approx){sum, error};
}

/* The coefficient of mode q is (1/L) times the integral of exp(-x^2/(2 sigma^2)) cos(q x) over the whole line, since
 * the images of the source and the antiperiod 2L of the mode change sign together. */
struct approx series_gauss_modes(double x, double L, double sigma) {
    double amplitude = sqrt(2 * pi) * sigma / L, sum = 0, error = 2 * negligible;
    for (int n = 0; n < MODES_MAX; n++) {
        double q = (n + 0.5) * pi / L, z = q * sigma, c = amplitude * exp(-z * z / 2);
        sum += c * cos(q * x);
        error += DBL_EPSILON * c * (2 + z * z + q * fabs(x));
        if (c <= negligible * amplitude) break;
    }
    return (struct approx){sum, error};
}

struct approx series_gauss(double x, double L, double sigma) {
    return sigma <= L ? series_gauss_images(x, L, sigma) : series_gauss_modes(x, L, sigma);
}

struct approx series_gauss_other(double x, double L, double sigma) {
    return sigma <= L ? series_gauss_modes(x, L, sigma) : series_gauss_images(x, L, sigma);
}

struct series_levin series_accelerate(const double *term, size_t n) {
    struct series_levin r = {0, 0, INFINITY, 0};
    for (size_t i = 0; i < n; i++) r.plain += term[i];
    r.accelerated = r.plain;
    gsl_sum_levin_u_workspace *w = gsl_sum_levin_u_alloc(n);
    double limit, error;
    if (w && gsl_sum_levin_u_accel(term, n, w, &limit, &error) == GSL_SUCCESS) {
        r.accelerated = limit;
        r.error = error;
        r.terms_used = w->terms_used;
    }
    gsl_sum_levin_u_free(w);
    return r;
}
