/* Transient heat conduction through two layers, by numerical inversion of the Laplace transform.
 *
 * In layer i, at the distance d from the contact and with q_i = sqrt(z rho_c_i/k_i), the transform of T is
 *
 *     T^ = start_i/z + (wall_i - start_i)/z sinh(q_i d)/sinh(q_i w_i)
 *                    + (theta - start_i/z) sinh(q_i (w_i - d))/sinh(q_i w_i)
 *
 * and theta(z), the contact's, follows from equal fluxes, sum_i k_i dT^/dd = 0 at d = 0.  No contact temperature,
 * error function or eigenvalue enters (Carslaw and Jaeger 1959, chapter 12).  The inversion is Talbot's, by the
 * midpoint rule with N points on the contour z(a) = N/t (0.5017 a cot(0.6407 a) - 0.6122 + 0.2645 i a), -pi < a < pi,
 * whose error falls as 3.89^-N (Trefethen, Weideman, Schmelzer 2006, BIT 46:653); N = 24 balances it with rounding.
 * Restrictions: constant walls, each layer at one temperature at the start. */
#include "references/layers.h"

#include <complex.h>
#include <math.h>

static const double pi = 3.14159265358979323846;

/* sinh(q d)/sinh(q w) for 0 <= d <= w, without overflow: the contour reaches |q w| of any size */
static double complex sinh_ratio(double complex q, double d, double w) {
    return cexp(-q * (w - d)) * (1 - cexp(-2 * q * d)) / (1 - cexp(-2 * q * w));
}

/* Transforms are of T - start_i, so that the difference of the starts does not lose digits. */
static double complex transform(const struct layers *w, double x, double complex z) {
    double complex conductance = 0, flux = 0, q[2];
    for (int i = 0; i < 2; i++) {
        q[i] = csqrt(z * (w->rho_c[i] / w->k[i]));
        double complex e = cexp(-2 * q[i] * w->width[i]);
        double complex g = w->k[i] * q[i] * (1 + e) / (1 - e);                       /* k q coth(q w) */
        double complex h = w->k[i] * q[i] * 2 * cexp(-q[i] * w->width[i]) / (1 - e); /* k q / sinh(q w) */
        conductance += g;
        flux += g * w->start[i] + h * (w->wall[i] - w->start[i]);
    }
    double complex theta = flux / conductance; /* z times the transform of the contact's temperature */
    int i = x >= 0;
    double d = fabs(x), width = w->width[i];
    return ((w->wall[i] - w->start[i]) * sinh_ratio(q[i], d, width) +
            (theta - w->start[i]) * sinh_ratio(q[i], width - d, width)) /
           z;
}

struct exact layers_at(const struct layers *w, double x, double t) {
    enum { N = 24 };
    double start = w->start[x >= 0], sum = 0;
    double scale =
        fmax(fabs(w->start[1] - w->start[0]), fmax(fabs(w->wall[0] - w->start[0]), fabs(w->wall[1] - w->start[1])));
    if (t == 0) return (struct exact){start, 0};
    for (int j = 0; j < N / 2; j++) {
        double a = (2 * j + 1) * pi / N, cot = 1 / tan(0.6407 * a);
        double complex z = N * (0.5017 * a * cot - 0.6122 + 0.2645 * I * a);
        double complex dz = N * (0.5017 * cot - 0.5017 * 0.6407 * a * (1 + cot * cot) + 0.2645 * I);
        sum += cimag(cexp(z) * transform(w, x, z / t) * dz);
    }
    double largest = fmax(fabs(w->start[0]), fabs(w->start[1]));
    return (struct exact){start + sum * 2 / N / t, 2e-13 * scale + 4e-16 * largest};
}

/* Lowest root: below the first pole of either cotangent the sum falls from positive to minus infinity. */
double layers_slowest(const struct layers *w) {
    double lo = 0, hi = INFINITY;
    for (int i = 0; i < 2; i++) hi = fmin(hi, w->k[i] / w->rho_c[i] * pow(pi / w->width[i], 2));
    for (int step = 0; step < 60; step++) {
        double mu = (lo + hi) / 2, sum = 0;
        for (int i = 0; i < 2; i++) {
            double q = sqrt(mu * w->rho_c[i] / w->k[i]);
            sum += w->k[i] * q / tan(q * w->width[i]);
        }
        *(sum > 0 ? &lo : &hi) = mu;
    }
    return lo;
}
