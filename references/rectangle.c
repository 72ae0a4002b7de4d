/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rectangle with a step change of its side temperatures: closed form of the steady state minus a double sine series.
 *
 * Steady state for one side at 1 (Pamplona 2019 eq. 2, with the sign required by the boundary condition).  The sum
 * is over odd n, with r = n pi/B:
 *
 *     H = sum_n 4/(n pi) sin(r eta) sinh(r (W - xi))/sinh(r W)
 *
 * It decays as exp(-r xi) and converges slowly near the hot side.  The terms exp(-r xi) - exp(-r (2W - xi)) of the
 * ratio sum to semi-infinite strips (Carslaw and Jaeger 1959, chapter 5); the remainder decays as exp(-2 r W)
 * everywhere:
 *
 *     H = A(xi) - A(2W - xi) + sum_n 4/(n pi) sin(r eta) (exp(-r xi) - exp(-r (2W - xi)))/(exp(2 r W) - 1)
 *     A(u) = 2/pi atan(sin(pi eta/B)/sinh(pi u/B))
 *
 * For W < B the solution is the straight line 1 - xi/W minus the effect of both neighbours.  The sums are over all
 * m, with q = m pi/W:
 *
 *     H = 1 - xi/W - E(eta) - E(B - eta),   E = sum_m 2/(m pi) sin(q xi) sinh(q (B - eta))/sinh(q B)
 *       = D(eta) - D(2B - eta) + sum_m 2/(m pi) sin(q xi) (exp(-q eta) - exp(-q (2B - eta)))/(exp(2 q B) - 1)
 *     D(u) = 2/pi arg(1/(1 - exp(pi (i xi - u)/W)))
 *
 * Transient: H - T vanishes on all sides and is a double sine series.  For the mode sin(q xi) sin(r eta), Green's
 * second identity gives the coefficient from the slope of the mode on the hot side:
 *
 *     H - T = sum_m sum_n 8 q/(n pi W (q^2 + r^2)) sin(q xi) sin(r eta) exp(-(q^2 + r^2) s^2/4),   q = m pi/W
 *
 * Cut: the influence of an end reaches at most 6.3 s (erfc(6.3) = 5e-19) and at most 14 times the other extent
 * (exp(-14 pi) = 8e-20).  Between these reaches the solution is uniform along the axis; this part is cut out.  The
 * cut rectangle is at most 12.6 s or 28 of its widths long.  At any time and for any shape at most 53 modes of an
 * axis then have (q s/2)^2 < 41.5, and the exponentials of the strips stay finite.
 *
 * Restrictions: isotropic. */
#include "references/rectangle.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

static const double last_exponent = 41.5; /* exp(-41.5) = 9.5e-19 */

/* Position along an axis: distances to both ends; sine and cosine of the angle pi x/length. */
struct place {
    double lo, hi, length, sine, cosine; /* cosine > 0 in the lower half */
};

static struct place place(double lo, double hi, double length) {
    double angle = M_PI * fmin(lo, hi) / length, c = cos(angle);
    return (struct place){lo, hi, length, sin(angle), lo <= hi ? c : -c};
}

/* Value and slopes along xi and eta. */
struct sum {
    double value, along, across, size; /* size: sum of the magnitudes of the slopes' terms */
};

/* A(u) of the derivation; `along` is dA/du. */
static struct sum strip(double u, const struct place *eta) {
    double grown = expm1(M_PI * u / eta->length), sinh_u = (grown + grown / (grown + 1)) / 2,
           cosh_u = hypot(1, sinh_u);
    double den = (sinh_u * sinh_u + eta->sine * eta->sine) * eta->length / 2;
    struct sum A = {2 / M_PI * atan2(eta->sine, sinh_u), -eta->sine * cosh_u / den, eta->cosine * sinh_u / den, 0};
    A.size = fabs(A.along) + fabs(A.across);
    return A;
}

/* D(u) of the derivation; `along` is dD/du, `across` is dD/dxi. */
static struct sum wedge(double u, const struct place *xi) {
    double shrunk = expm1(-M_PI * u / xi->length), e = 1 + shrunk, half = xi->sine * xi->sine / (1 + xi->cosine);
    if (xi->cosine < 0) half = 1 - xi->cosine;                  /* 1 - cos(angle) */
    double real = -shrunk + e * half, imaginary = e * xi->sine; /* parts of 1 - zeta, up to the sign */
    double den = (real * real + imaginary * imaginary) * xi->length / 2;
    struct sum D = {2 / M_PI * atan2(imaginary, real), -imaginary / den, -e * (half + shrunk) / den, 0};
    D.size = fabs(D.along) + fabs(D.across);
    return D;
}

static void add(struct sum *to, double factor, double turn, struct sum part) {
    to->value += factor * part.value;
    to->along += factor * turn * part.along;
    to->across += factor * part.across;
    to->size += fabs(factor) * part.size;
}

/* Strip or wedge at the distance `near`, minus its last image, plus the remaining sum over n = 1, step + 1, ... of
 * c/n sin(n angle) (exp(-n pi u/b) - exp(-n pi (2 w - u)/b))/(exp(2 pi n w/b) - 1). */
static struct sum images(struct sum (*image)(double, const struct place *), double near, double far, double w,
                         const struct place *b, int step) {
    struct sum H = image(near, b);
    add(&H, -1, -1, image(w + far, b));
    double rate = M_PI / b->length, p = exp(-rate * near), o = exp(-rate * (w + far)), grow = exp(2 * rate * w);
    double pn = p, on = o, grown = grow, s = b->sine, c = b->cosine, sn = s, cn = c;
    for (int n = 1; grown < 1e18; n++) {
        if (step == 1 || n % 2) {
            double size = 2 * step / (n * M_PI) / (grown - 1);
            H.value += size * sn * (pn - on);
            H.along -= size * n * rate * sn * (pn + on);
            H.across += size * n * rate * cn * (pn - on);
        }
        double next = sn * c + cn * s;
        cn = cn * c - sn * s;
        sn = next;
        pn *= p;
        on *= o;
        grown *= grow;
    }
    return H;
}

/* Steady response to the side at xi->lo = 0. */
static struct sum steady(const struct place *xi, const struct place *eta) {
    double W = xi->length, B = eta->length;
    if (W >= B) return images(strip, xi->lo, xi->hi, W, eta, 2);
    struct sum H = {xi->hi / W, -1 / W, 0, 1 / W};
    for (int end = 0; end < 2; end++) {
        struct sum E = images(wedge, end ? eta->hi : eta->lo, end ? eta->lo : eta->hi, B, xi, 1);
        H.value -= E.value;
        H.along -= E.across;
        H.across -= end ? -E.along : E.along;
        H.size += E.size;
    }
    return H;
}

struct approx rectangle_steady(double xi, double W, double eta, double B) {
    struct place along = place(xi, W - xi, W), across = place(eta, B - eta, B);
    return (struct approx){steady(&along, &across).value, 24 * DBL_EPSILON};
}

/* Significant coefficients of row n. */
static void prepare_row(struct rectangle *r, int n, double c) {
    const double *g = r->side, W = r->cut[0], H = r->cut[1], ky = n * M_PI / H;
    for (int m = 1; m <= RECTANGLE_MODES; m++) {
        double kx = m * M_PI / W, rate = kx * kx + ky * ky, size = 0;
        if (c * rate > last_exponent) break;
        if (m % 2) size += 8 * ky / (m * M_PI * H) * (g[2] + (n % 2 ? g[3] : -g[3]));
        if (n % 2) size += 8 * kx / (n * M_PI * W) * (g[0] + (m % 2 ? g[1] : -g[1]));
        size *= exp(-c * rate) / rate;
        r->mode[n - 1][m - 1] = size;
        r->count[n - 1] = m;
        /* rounding of the exponent, and of the phases up to m pi/2 and n pi/2 in the recurrence of table() */
        double rounding = DBL_EPSILON * fabs(size) * (8 + 8 * c * rate + 5 * (m + n));
        r->error[0] += rounding;
        r->error[1] += kx * rounding;
        r->error[2] += ky * rounding;
    }
}

void rectangle_prepare(const double extent[2], const double side[4], double s, struct rectangle *r) {
    double scale = 0;
    *r = (struct rectangle){.rows = 0};
    for (int i = 0; i < 4; i++) {
        r->side[i] = side[i];
        scale += fabs(side[i]);
    }
    for (int a = 0; a < 2; a++) {
        r->extent[a] = extent[a];
        r->reach[a] = fmin(6.3 * s, 14 * extent[1 - a]);
        r->cut[a] = fmin(extent[a], 2 * r->reach[a]);
    }
    double shorter = fmin(r->cut[0], r->cut[1]);
    for (int a = 0; a < 3; a++) r->error[a] = scale * (24 * DBL_EPSILON + 1e-17) / (a ? shorter : 1);
    for (int n = 1; n <= RECTANGLE_MODES && s < INFINITY; n++) {
        prepare_row(r, n, s * s / 4);
        if (r->count[n - 1] == 0) break;
        r->rows = n;
    }
}

static struct place place_in(const struct rectangle *r, int axis, double x) {
    double lo = fmax(x, 0), hi = fmax(r->extent[axis] - x, 0), cut = r->cut[axis];
    if (cut < r->extent[axis]) {
        if (lo > cut / 2 && hi > cut / 2)
            lo = hi = cut / 2;
        else if (lo <= cut / 2)
            hi = cut - lo;
        else
            lo = cut - hi;
    }
    return place(lo, hi, cut);
}

/* sin(m angle) and cos(m angle), m = 1 to n. */
static void table(const struct place *p, int n, double *sine, double *cosine) {
    double s = 0, c = 1;
    for (int m = 0; m < n; m++) {
        sine[m] = s * p->cosine + c * p->sine;
        cosine[m] = c * p->cosine - s * p->sine;
        s = sine[m];
        c = cosine[m];
    }
}

static void subtract_modes(const struct rectangle *r, const struct place at[2], struct surface *T) {
    double sx[RECTANGLE_MODES], cx[RECTANGLE_MODES], sy[RECTANGLE_MODES], cy[RECTANGLE_MODES];
    table(&at[0], r->count[0], sx, cx);
    table(&at[1], r->rows, sy, cy);
    for (int m = 0; m < r->count[0]; m++) cx[m] *= (m + 1) * M_PI / at[0].length;
    for (int n = 0; n < r->rows; n++) {
        double value = 0, slope = 0;
        for (int m = 0; m < r->count[n]; m++) {
            value += r->mode[n][m] * sx[m];
            slope += r->mode[n][m] * cx[m];
        }
        T->at.value -= value * sy[n];
        T->slope[0].value -= slope * sy[n];
        T->slope[1].value -= value * cy[n] * (n + 1) * M_PI / at[1].length;
    }
}

struct surface rectangle_at(const struct rectangle *r, const double x[2]) {
    struct place at[2] = {place_in(r, 0, x[0]), place_in(r, 1, x[1])};
    struct surface T = {{0, r->error[0]}, {{0, r->error[1]}, {0, r->error[2]}}};
    for (int side = 0; side < 4; side++) {
        if (r->side[side] == 0) continue;
        int a = side / 2, upper = side % 2;
        struct place xi = at[a];
        if (upper) xi = (struct place){xi.hi, xi.lo, xi.length, xi.sine, -xi.cosine};
        struct sum H = steady(&xi, &at[1 - a]);
        T.at.value += r->side[side] * H.value;
        T.slope[a].value += r->side[side] * (upper ? -H.along : H.along);
        T.slope[1 - a].value += r->side[side] * H.across;
        for (int b = 0; b < 2; b++) T.slope[b].error += 24 * DBL_EPSILON * fabs(r->side[side]) * H.size;
    }
    subtract_modes(r, at, &T);
    return T;
}

/* ---- Second form: quadrature ---- */

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
 * This form shares no formula with the closed form above. */

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
