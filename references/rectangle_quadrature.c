/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rectangle with one side switched on, from quadrature over time of the wall's Green's function.
 *
 * The hot side acts through the kernel of the half line, d/dt erfc(xi/s), on what the two neighbours leave of 1 by
 * then, a unit box that cools; images across xi = W of alternating sign make the far side cold.  With
 * z = xi/sqrt(4 kappa tau)
 *
 *     T = sum over images of +-2/sqrt(pi) int_{xi/s}^inf exp(-z^2) box(eta, xi/z) dz
 *
 * Late, images count up to a distance of 14 B: one at u gives at most what it does once steady, 2/pi
 * atan(sin(pi eta/B)/sinh(pi u/B)) < 4/pi exp(-pi u/B), 1e-19 there (Carslaw and Jaeger 1959, chapter 5).
 *
 * Shares no form with rectangle.c. */
#include "references/rectangle.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

enum { IMAGES_MAX = 10000 };

struct kernel {
    double distance, eta, B; /* m */
};

/* exp(-z^2) times the unit box across, after the time at which z = distance/s; per log z, since the box falls where
 * z = distance/eta, however small that is */
static double integrand(double log_z, void *data) {
    const struct kernel *k = data;
    double z = exp(log_z);
    struct curve across = series_box(k->eta - k->B / 2, k->B / 2, k->B / 2, k->distance / z);
    return 2 / sqrt(M_PI) * z * exp(-z * z) * across.at.value;
}

/* The hot side seen from one image of the point: int over time of (wall kernel of the half line) x (box across). */
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
    if (most > 2 * IMAGES_MAX * W) return (struct approx){0, INFINITY}; /* more count than are summed */
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(1000);
    for (int k = 0; xi + 2 * k * W < most; k++) {
        struct approx near = image(xi + 2 * k * W, eta, B, s, w), far = image(2 * (k + 1) * W - xi, eta, B, s, w);
        T.value += near.value - far.value;
        T.error += near.error + far.error;
    }
    gsl_integration_workspace_free(w);
    return T;
}
