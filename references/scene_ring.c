/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ring: heat that flows along circles only.
 *
 *     rho_c dT/dt = div(k_par b b^T grad T)  on [-L, L]^2, b = (-y, x)/r, sides held at Tm
 *
 * Nothing flows across circles: each is a rod without ends, of length 2 pi r, and with kappa = k_par/rho_c
 *
 *     data = smooth  T = Tm + A exp(-((r - r0)/w)^2) cos(mode theta + phase) exp(-kappa mode^2 t/r^2)
 *     data = patch   Tm + A in r1 < r < r2, |theta - pi| < half, else Tm at t = 0 (Parrish and Stone 2005, section
 *                    4.2; Sharma and Hammett 2007, section 4.2); with s = sqrt(4 kappa t)/r and phi = theta - pi
 *
 *         T - Tm = A (half/pi + sum over n of 2/(n pi) sin(n half) cos(n phi) exp(-n^2 s^2/4))
 *                = A/2 sum over j of erf((phi + half + 2 pi j)/s) - erf((phi - half + 2 pi j)/s)
 *
 * The two sums are equal (Poisson); exact takes the shorter one, the second form the other.  The second form of the
 * smooth data averages them over the circle with the Gaussian exp(-u^2)/sqrt(pi), theta + s u, by the trapezoidal
 * rule, whose error for a step du is exp(-(pi/du - mode s/2)^2).
 *
 * At the sides and at the centre, where b is (1, 0), the smooth data are below exp(-25) A, in the error bound, and
 * the patch is 0.
 *
 * Orders.  A code keeps no heat on its circle.  Fluxes through faces damp radial waves q at the rate kappa dx^2
 * sin^2(2 theta) q^4/16, those from gradients at corners at kappa dx^4 sin^2(4 theta) q^6/2304 (the head of
 * solver/differences/ftcs_cross.c).  Smooth data show order 2 in both.  The edges r1 and r2 of the patch spread by
 * (kappa t dx^2)^(1/4) or (kappa t dx^4)^(1/6): E1 falls as dx^(1/2) or, once that length is above dx, dx^(2/3).
 *
 * Restrictions: A < Tm; w up to a fifth of r0 and of L - r0; r1 < r2 < L; mode 1 to 32; half below pi. */
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, K_PAR, RHO_C, DATA, R0, W, MODE, PHASE, R1, R2, HALF, TM, A, T_END };
enum { SMOOTH, PATCH };

static const char *const words[] = {"smooth", "patch", NULL};

static const struct param params[] = {
    {"L", 1, "m", "half of the side of the square", NULL},
    {"k_par", 0.01, "W/(m K)", "conductivity along the circles", NULL},
    {"rho_c", 1, "J/(m^3 K)", "heat capacity", NULL},
    {"data", SMOOTH, "", "initial data", words},
    {"r0", 0.5, "m", "radius of the smooth ring", NULL},
    {"w", 0.09, "m", "its width", NULL},
    {"mode", 2, "", "waves around the smooth ring, an integer", NULL},
    {"phase", 0.3, "", "phase of these waves, rad", NULL},
    {"r1", 0.5, "m", "inner radius of the patch", NULL},
    {"r2", 0.7, "m", "outer radius of the patch", NULL},
    {"half", 0.2617993877991494, "", "half of the angle of the patch, rad", NULL},
    {"Tm", 1, "K", "temperature of the sides", NULL},
    {"A", 0.7, "K", "initial excess, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* sqrt(4 kappa t)/r */
static double spread(const struct problem *p, double r, double t) {
    return 2 * sqrt(p->param[K_PAR] / p->param[RHO_C]) * sqrt(t) / r;
}

/* ---- The patch, over A ---- */

enum { TERMS = 400 };

static double fourier(double phi, double half, double s) {
    double sum = half / M_PI;
    for (int n = 1; n < TERMS && n * s < 13; n++)
        sum += 2 / (n * M_PI) * sin(n * half) * cos(n * phi) * exp(-n * s / 2 * (n * s / 2));
    return sum;
}

static double images(double phi, double half, double s) {
    double sum = 0;
    for (int j = -TERMS; j <= TERMS; j++) {
        double a = phi + half + 2 * M_PI * j, b = phi - half + 2 * M_PI * j;
        if (fmin(fabs(a), fabs(b)) < 7 * s || a * b < 0) sum += (erf(a / s) - erf(b / s)) / 2;
    }
    return sum;
}

static int is_in_patch(const double *v, double r, double phi) {
    return v[R1] < r && r < v[R2] && fabs(phi) < v[HALF];
}

/* is_second: by the longer sum. */
static struct exact patch(const struct problem *p, const double *x, double t, int is_second) {
    const double *v = p->param, r = hypot(x[0], x[1]), phi = atan2(-x[1], -x[0]), s = spread(p, r, t);
    struct exact e = {.temperature = v[TM], .error_bound = DBL_EPSILON * (4 * v[TM] + 20 * v[A])};
    for (int a = 0; a < 2; a++) e.gradient_bound[a] = INFINITY; /* jumps across r1 and r2 */
    if (!(v[R1] < r && r < v[R2])) return e;
    const int few = 2, by_images = (s < few) != is_second;
    if (s == 0) {
        e.temperature += is_in_patch(v, r, phi) ? v[A] : 0;
    } else if (by_images ? 7 * s > 2 * M_PI * (TERMS - 2) : TERMS * s < 13) {
        e = (struct exact){.temperature = NAN, .error_bound = INFINITY};
    } else {
        e.temperature += v[A] * (by_images ? images : fourier)(phi, v[HALF], s);
        e.error_bound += DBL_EPSILON * v[A] * (by_images ? 4 * s + 8 / fmax(s, DBL_EPSILON) : 8 + 60 / s);
    }
    return e;
}

/* ---- The smooth ring ---- */

/* Its envelope at r, K, and the rounding of that. */
static double envelope(const double *v, double r, double *rounding) {
    double z = (r - v[R0]) / v[W], size = v[A] * exp(-z * z);
    *rounding = DBL_EPSILON * size * (4 + 4 * z * z + 4 * fabs(z) * (r + v[R0]) / v[W]);
    return size;
}

static struct exact smooth(const struct problem *p, const double *x, double t) {
    const double *v = p->param, r = hypot(x[0], x[1]), angle = v[MODE] * atan2(x[1], x[0]) + v[PHASE];
    double rounding, size = envelope(v, r, &rounding), z = (r - v[R0]) / v[W],
                     ends = fmin(v[R0], v[L] - v[R0]) / v[W];
    double lost = v[A] * exp(-ends * ends);
    double decay = v[MODE] * spread(p, r, t) / 2, exponent = r > 0 ? decay * decay : 0, all = size * exp(-exponent);
    double off = rounding + DBL_EPSILON * all * (4 + 4 * fabs(angle) + 8 * exponent);
    struct exact e = {.temperature = v[TM] + all * cos(angle), .error_bound = DBL_EPSILON * v[TM] + off + lost};
    if (!(r > 0)) return e;
    double along = -all * v[MODE] / r * sin(angle);
    double out = all * cos(angle) * (2 * exponent / r - 2 * z / v[W]);
    double steep = (2 + v[MODE]) / r + 2 * fabs(z) / v[W] + 2 * exponent / r + 1 / v[W];
    e.gradient[0] = (out * x[0] - along * x[1]) / r;
    e.gradient[1] = (out * x[1] + along * x[0]) / r;
    for (int a = 0; a < 2; a++) e.gradient_bound[a] = 8 * (off * steep + lost / v[W]);
    return e;
}

static struct exact smooth_by_average(const struct problem *p, const double *x, double t) {
    enum { POINTS = 64 };
    static const double reach = 6.2, most = 19;
    const double *v = p->param, r = hypot(x[0], x[1]), theta = atan2(x[1], x[0]), s = spread(p, r, t);
    double rounding, size = envelope(v, r, &rounding), du = 2 * reach / POINTS, sum = 0;
    if (!(v[MODE] * s <= most))
        return (struct exact){.temperature = v[TM], .error_bound = size + DBL_EPSILON * v[TM]};
    for (int k = 0; k < POINTS; k++) {
        double u = du * (k + 0.5) - reach;
        sum += exp(-u * u) * cos(v[MODE] * (theta + s * u) + v[PHASE]);
    }
    double turns = v[MODE] * (M_PI + s) + fabs(v[PHASE]);
    return (struct exact){.temperature = v[TM] + size * sum * du / sqrt(M_PI),
                          .error_bound = rounding + DBL_EPSILON * (size * (20 + 4 * turns) + 3 * v[TM])};
}

/* ---- The scene ---- */

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    return p->param[DATA] == PATCH ? patch(p, x, t, 0) : smooth(p, x, t);
}

static struct exact second(const struct problem *p, const double *x, double t) {
    return p->param[DATA] == PATCH ? patch(p, x, t, 1) : smooth_by_average(p, x, t);
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static void direction(const struct problem *p, const double *x, double b[DIM_MAX]) {
    (void)p;
    double r = hypot(x[0], x[1]);
    b[0] = r > 0 ? -x[1] / r : 1;
    b[1] = r > 0 ? x[0] / r : 0;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {DATA, PHASE, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why) || params_whole(params, p, MODE, 1, 32, why)) return STATUS_INPUT;
    if (params_between(params, p, PHASE, -100, 100, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, R0, 0, v[L], "the ring is inside the square", why)) return STATUS_INPUT;
    if (params_within(params, p, W, 1e-3 * v[L], fmin(v[R0], v[L] - v[R0]) / 5, "the ring ends before the sides",
                      why))
        return STATUS_INPUT;
    if (params_between(params, p, R2, v[R1], v[L], "r1 < r2 < L", why)) return STATUS_INPUT;
    if (params_between(params, p, HALF, 0, M_PI, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    p->dim = 2;
    params_material(p, v[K_PAR], v[K_PAR], v[RHO_C]);
    p->direction = direction, p->k_par = v[K_PAR];
    for (int a = 0; a < 2; a++) p->lo[a] = -v[L], p->hi[a] = v[L];
    for (int s = 0; s < 4; s++) p->side[s] = DIRICHLET, p->held[s] = v[TM];
    p->initial = initial;
    p->breaks_on_curves = v[DATA] == PATCH;
    return STATUS_OK;
}

const struct scene scene_ring = {
    .name = "ring",
    .about = "conduction along circles only: a smooth ring, or a patch",
    .citation = "Parrish and Stone 2005, section 4.2",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.017, 1.7, SMOOTH, 0.61, 0.097, 3, 0.37, 0.52, 0.83, 0.29, 1.1, 0.6, 1.9}, 1, 0.004, 0.1},
};
