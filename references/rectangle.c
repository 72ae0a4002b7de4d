/* Rectangle with one side switched on: closed forms for the steady state, for small and for large times.
 *
 * Steady (Pamplona 2019 eq. 2, one side, with the sign that its boundary asks for), sums over odd n, r = n pi/B:
 *
 *     H = sum_n 4/(n pi) sin(r eta) sinh(r (W - xi))/sinh(r W)
 *
 * falls off as exp(-r xi), so it crawls near the hot side.  Since
 *
 *     sinh(r (W - xi))/sinh(r W) = sum_{k>=0} exp(-r (xi + 2kW)) - exp(-r (2(k+1)W - xi))
 *     sum_n 4/(n pi) sin(r eta) exp(-r xi) = 2/pi atan(sin(pi eta/B)/sinh(pi xi/B)) = A(xi)
 *
 * (A is the semi-infinite strip; Carslaw and Jaeger 1959, chapter 5), the two sums change places and
 *
 *     H = sum_{k>=0} A(xi + 2kW) - A(2(k+1)W - xi)
 *
 * gains a factor exp(-2 pi W/B) a term, everywhere, at the hot side as well.
 *
 * Large times: what is still missing from H obeys zero walls and is a double sine series.  Its coefficients follow
 * from the hot side alone: for a mode sin(q xi) sin(r eta), Green's second identity leaves its slope there,
 *
 *     H - T = sum_m sum_n 8 q/(n pi W (q^2 + r^2)) sin(q xi) sin(r eta) exp(-(q^2 + r^2) s^2/4),   q = m pi/W
 *
 * Small times, s <= 0.15 min(W, B): only the hot side and its two corners are felt,
 *
 *     T = erfc(xi/s) - Q(xi, eta) - Q(xi, B - eta)
 *
 * Q, the deficit by one corner, is the integral over time of the half line's wall kernel times the chill that the
 * neighbour has sent by then; with z = xi/sqrt(4 kappa tau) and Owen's T function (Owen 1956)
 *
 *     Q = 2/sqrt(pi) int_{xi/s}^inf exp(-z^2) erfc(z eta/xi) dz = erfc(xi/s) - 4 T_Owen(sqrt(2) xi/s, eta/xi)
 *     4 T_Owen = 2/pi int_0^{eta/xi} exp(-(xi/s)^2 (1 + v^2))/(1 + v^2) dv
 *
 * For eta > xi the two change places: Q(xi, eta) + Q(eta, xi) = erfc(xi/s) erfc(eta/s).  What the far side would add
 * is below erfc(1/0.15) = 4.2e-21.
 *
 * Restrictions: isotropic; the point is not a corner (there T depends on the direction). */
#include "references/rectangle.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

static const double pi = 3.14159265358979323846;

/* Where the forms for small and for large times change over, s/min(W, B). */
static const double small_time = 0.15;

double rectangle_sinh_ratio(double q, double a, double b) {
    return exp(-q * (b - a)) * expm1(-2 * q * a) / expm1(-2 * q * b);
}

/* A(xi) above; sin of the nearer end, so that the side neighbours are exactly cold */
static double strip(double xi, double eta, double B) {
    return 2 / pi * atan2(sin(pi * fmin(eta, B - eta) / B), sinh(pi * xi / B));
}

struct approx rectangle_steady(double xi, double W, double eta, double B) {
    double sum = 0, tail = 1;
    int k = 0;
    for (; k < 100000 && tail > 1e-18; k++) {
        sum += strip(xi + 2 * k * W, eta, B) - strip(2 * (k + 1) * W - xi, eta, B);
        tail = 4 / pi * exp(-2 * pi * (k + 1) * W / B) / -expm1(-2 * pi * W / B);
    }
    return (struct approx){sum, tail + 2 * DBL_EPSILON * (2 + k)};
}

struct series_levin rectangle_steady_series(double xi, double W, double eta, double B, size_t n) {
    double term[512];
    if (n > sizeof term / sizeof *term) n = sizeof term / sizeof *term;
    for (size_t i = 0; i < n; i++) {
        double odd = 2 * (double)i + 1, q = odd * pi / B;
        term[i] = 4 / (odd * pi) * sin(q * eta) * rectangle_sinh_ratio(q, W - xi, W);
    }
    return series_accelerate(term, n);
}

double rectangle_corner(double xi, double eta, double s) {
    double h = fmax(xi, eta) / s, ratio = fmin(xi, eta) / fmax(xi, eta), sum = 0;
    if (hypot(xi, eta) > SERIES_REACH * s) return 0;
    /* 32 Gauss points integrate this to rounding: its poles +-i are far, and h <= SERIES_REACH */
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(32);
    for (size_t i = 0; i < 32; i++) {
        double v, weight;
        gsl_integration_glfixed_point(0, ratio, i, &v, &weight, table);
        sum += weight * exp(-h * h * (1 + v * v)) / (1 + v * v);
    }
    gsl_integration_glfixed_table_free(table);
    double owen = 2 / pi * sum, E = erfc(xi / s);
    return eta <= xi ? E - owen : owen - erfc(eta / s) * (1 - E);
}

/* H - T for large times.  Modes are taken in blocks, since a long plate has many along its length. */
static struct approx missing(double xi, double W, double eta, double B, double s) {
    enum { BLOCK = 256 };
    const double c = s * s / 4, least = 1e-18;
    double along[BLOCK], size[BLOCK], q2[BLOCK], decay[BLOCK], sum = 0, error = 8 * DBL_EPSILON;
    for (int m0 = 1, alive = BLOCK; alive == BLOCK; m0 += BLOCK) {
        for (alive = 0; alive < BLOCK; alive++) {
            double q = (m0 + alive) * pi / W;
            q2[alive] = q * q;
            decay[alive] = exp(-c * q * q);
            along[alive] = q * sin(q * xi) * decay[alive];
            size[alive] = q * decay[alive] * (4 + q * xi); /* the phase q xi is rounded */
            if (decay[alive] < least) break;
        }
        for (int n = 1; alive; n += 2) {
            double r = n * pi / B, across = exp(-c * r * r), inner = 0, rounding = 0;
            if (across * decay[0] < least) break;
            for (int i = 0; i < alive && across * decay[i] >= least; i++) {
                inner += along[i] / (q2[i] + r * r);
                rounding += size[i] / (q2[i] + r * r);
            }
            sum += 8 / (n * pi * W) * across * sin(r * eta) * inner;
            error += DBL_EPSILON * 8 / (n * pi * W) * across * (1 + r * eta) * rounding;
        }
    }
    return (struct approx){sum, error};
}

struct approx rectangle_response(double xi, double W, double eta, double B, double s) {
    if (s == 0) return (struct approx){0, 0};
    if (s <= small_time * fmin(W, B)) {
        double T = erfc(xi / s) - rectangle_corner(xi, eta, s) - rectangle_corner(xi, B - eta, s);
        return (struct approx){T, 8 * DBL_EPSILON};
    }
    struct approx H = rectangle_steady(xi, W, eta, B), D = missing(xi, W, eta, B, s);
    return (struct approx){H.value - D.value, H.error + D.error};
}

struct kernel {
    double distance, eta, B; /* m */
};

/* exp(-z^2) times the unit box across, after the time at which z = distance/s; per log z, since the box falls where
 * z = distance/eta, however small that is */
static double integrand(double log_z, void *data) {
    const struct kernel *k = data;
    double z = exp(log_z);
    struct approx across = series_box(k->eta - k->B / 2, k->B / 2, k->B / 2, k->distance / z);
    return 2 / sqrt(pi) * z * exp(-z * z) * across.value;
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
    if (s == 0) return (struct approx){0, 0};
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(1000);
    for (int k = 0; xi + 2 * k * W < SERIES_REACH * s; k++) {
        struct approx near = image(xi + 2 * k * W, eta, B, s, w), far = image(2 * (k + 1) * W - xi, eta, B, s, w);
        T.value += near.value - far.value;
        T.error += near.error + far.error;
    }
    gsl_integration_workspace_free(w);
    return T;
}
