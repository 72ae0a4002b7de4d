/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rectangle with a step change on one side, by quadrature over time of the wall's Green's function.
 *
 * The kernel of the half line, d/dt erfc(xi/s), carries the hot side into the rectangle.  It acts on a unit box
 * along eta that cools through the two neighbouring sides.  Images across xi = W with alternating sign hold the far
 * side at zero.  With z = xi/sqrt(4 kappa tau)
 *
 *     T = sum over images of +-2/sqrt(pi) int_{xi/s}^inf exp(-z^2) box(eta, xi/z) dz
 *
 * At late times images up to the distance 14 B are significant.  The contribution of an image at the distance u is
 * below its steady value, 2/pi atan(sin(pi eta/B)/sinh(pi u/B)) < 4/pi exp(-pi u/B), which is 1e-19 at 14 B (Carslaw
 * and Jaeger 1959, chapter 5).
 *
 * This form shares no formula with rectangle.c. */
#include "references/rectangle.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

enum { IMAGES_MAX = 10000 };

struct kernel {
    double distance, eta, B; /* m */
};

/* exp(-z^2) times the unit box along eta at the time given by z = distance/s.  The variable is log z because the box
 * decays near z = distance/eta, at any scale of eta. */
static double integrand(double log_z, void *data) {
    const struct kernel *k = data;
    double z = exp(log_z);
    struct curve across = series_box(k->eta - k->B / 2, k->B / 2, k->B / 2, k->distance / z);
    return 2 / sqrt(M_PI) * z * exp(-z * z) * across.at.value;
}

/* Contribution of one image: integral over time of (wall kernel of the half line) x (box along eta). */
static struct approx image(double distance, double eta, double B, double s, gsl_integration_workspace *w) {
    struct kernel k = {distance, eta, B};
    gsl_function f = {integrand, &k};
    double from = log(distance / s), to = log(SERIES_REACH);
    struct approx sum = {0, 1e-15};
    if (distance == 0) return (struct approx){1, 0};
    if (eta == 0 || eta == B || from >= to) return (struct approx){0, 1e-17};
    int pieces = (int)fmin(ceil(to - from), 800);
    for (int i = 0; i < pieces; i++) {
        double a = from + (to - from) * i / pieces, b = from + (to - from) * (i + 1) / pieces, value, error;
        int status = gsl_integration_qag(&f, a, b, 1e-15, 1e-13, 1000, GSL_INTEG_GAUSS41, w, &value, &error);
        sum.value += value;
        sum.error += status && status != GSL_EROUND ? INFINITY : error;
    }
    /* eta - B/2 is rounded; |dT/d eta| <= T/distance to the nearer neighbour, up to a factor below 2 */
    sum.error += DBL_EPSILON * B / fmin(eta, B - eta) * sum.value;
    return sum;
}

struct approx rectangle_quadrature(double xi, double W, double eta, double B, double s) {
    struct approx T = {0, 1e-17};
    double most = fmin(SERIES_REACH * s, 14 * B);
    if (s == 0) return (struct approx){0, 0};
    if (most > 2 * IMAGES_MAX * W) return (struct approx){0, INFINITY}; /* more significant images than IMAGES_MAX */
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(1000);
    for (int k = 0; xi + 2 * k * W < most; k++) {
        struct approx near = image(xi + 2 * k * W, eta, B, s, w), far = image(2 * (k + 1) * W - xi, eta, B, s, w);
        T.value += near.value - far.value;
        T.error += near.error + far.error;
    }
    gsl_integration_workspace_free(w);
    return T;
}
