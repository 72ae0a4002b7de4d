/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plate-driven: a plate with a periodic flux through one side and air of periodic temperature at another.
 *
 *     rho_c dT/dt = k_x d2T/dx2 + k_y d2T/dy2  on [0, width] x [0, height]
 *     x = 0:      k_x dT/dn = Q cos(omega_q t + phase_q) cos(mu y)
 *     x = width:  T = Tm
 *     y = 0:      dT/dn = 0
 *     y = height: k_y dT/dn = b (T_a - T),   T_a = Tm + B cos(omega_a t + phase_a) cos(nu x)
 *
 * with mu height tan(mu height) = b height/k_y and nu width = pi/2.  Each drive has the shape of a mode of the other
 * axis, so the periodic state is a sum of two products:
 *
 *     T = Tm + Re[X(x) exp(i (omega_q t + phase_q))] cos(mu y) + Re[Y(y) exp(i (omega_a t + phase_a))] cos(nu x)
 *     X = Q/(k_x p) sinh(p (width - x))/cosh(p width),                 k_x p^2 = i omega_q rho_c + k_y mu^2
 *     Y = B b cosh(s y)/(k_y s sinh(s height) + b cosh(s height)),     k_y s^2 = i omega_a rho_c + k_x nu^2
 *
 * (Carslaw and Jaeger 1959, sections 2.6 to 2.8 and 3.9; the product as in section 1.15).  The start is this state
 * at t = 0.  The second form sums the damped waves that the sides reflect (driven.c), with p and s in real
 * arithmetic and mu by bisection.
 *
 * Restrictions: the amplitudes add up to less than Tm, so that T > 0. */
#include "references/driven.h"
#include "references/params.h"
#include "references/roots.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { WIDTH, HEIGHT, K_X, K_Y, RHO_C, AIR, TM, Q, OMEGA_Q, PHASE_Q, B, OMEGA_A, PHASE_A, T_END };

static const struct param params[] = {
    {"width", 1, "m", "extent along x", NULL},
    {"height", 0.8, "m", "extent along y", NULL},
    {"k_x", 0.03, "W/m/K", "conductivity along x", NULL},
    {"k_y", 0.02, "W/m/K", "conductivity along y", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"b", 0.15, "W/m^2/K", "heat transfer coefficient of the side y = height", NULL},
    {"Tm", 2, "K", "mean temperature, and that of the side x = width", NULL},
    {"Q", 0.1, "W/m^2", "amplitude of the flux through the side x = 0", NULL},
    {"omega_q", 0.5, "1/s", "angular frequency of the flux", NULL},
    {"phase_q", 0.4, "", "phase of the flux at t = 0, rad", NULL},
    {"B", 1.2, "K", "amplitude of the temperature of the air at the side y = height", NULL},
    {"omega_a", 0.3, "1/s", "angular frequency of the air", NULL},
    {"phase_a", 1.3, "", "phase of the air at t = 0, rad", NULL},
    {"t_end", 8, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

enum { MU = T_END + 1 }; /* m^-1, kept after the parameters by setup */

static double nu_of(const double *v) {
    return M_PI / 2 / v[WIDTH];
}

static double flux_phase(const double *v, double t) {
    return v[OMEGA_Q] * t + v[PHASE_Q];
}

static double air_phase(const double *v, double t) {
    return v[OMEGA_A] * t + v[PHASE_A];
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    const double *v = p->param;
    if (s == X_LO) return v[Q] * cos(flux_phase(v, t)) * cos(v[MU] * x[1]);
    if (s == Y_LO) return 0;
    return v[TM] + (s == Y_HI ? v[B] * cos(air_phase(v, t)) * cos(nu_of(v) * x[0]) : 0);
}

static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    const double *v = p->param;
    if (s == X_LO) return -v[Q] * v[OMEGA_Q] * sin(flux_phase(v, t)) * cos(v[MU] * x[1]);
    return s == Y_HI ? -v[B] * v[OMEGA_A] * sin(air_phase(v, t)) * cos(nu_of(v) * x[0]) : 0;
}

/* X, driven from x = 0 with p, and Y, driven from y = height with s. */
static struct driven flux_wave(const double *v, double complex p) {
    return (struct driven){.p = p, .size = v[Q] / (v[K_X] * p), .loss = 2, .L = v[WIDTH], .far = -1};
}

static struct driven air_wave(const double *v, double complex s) {
    double complex both = v[K_Y] * s + v[AIR];
    return (struct driven){.p = s, .size = v[B] * v[AIR] / both, .loss = 2 * v[AIR] / both, .L = v[HEIGHT], .far = 1};
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, mu = v[MU], nu = nu_of(v), lost = 20 * DBL_EPSILON;
    struct driven flux = flux_wave(v, csqrt((I * v[OMEGA_Q] * v[RHO_C] + v[K_Y] * mu * mu) / v[K_X]));
    struct driven air = air_wave(v, csqrt((I * v[OMEGA_A] * v[RHO_C] + v[K_X] * nu * nu) / v[K_Y]));
    struct curve X = driven_now(&flux, x[0], flux_phase(v, t), v[OMEGA_Q] * t + fabs(v[PHASE_Q]));
    struct curve Y = driven_now(&air, v[HEIGHT] - x[1], air_phase(v, t), v[OMEGA_A] * t + fabs(v[PHASE_A]));
    double c[2] = {cos(nu * x[0]), cos(mu * x[1])}, s[2] = {sin(nu * x[0]), sin(mu * x[1])};
    double error = X.at.error + Y.at.error + lost * (fabs(X.at.value) + fabs(Y.at.value));
    double bend = lost * (fabs(X.slope.value) + fabs(Y.slope.value));
    return (struct exact){
        .temperature = v[TM] + X.at.value * c[1] + Y.at.value * c[0],
        .error_bound = error + DBL_EPSILON * v[TM],
        .gradient = {X.slope.value * c[1] - nu * Y.at.value * s[0], -mu * X.at.value * s[1] - Y.slope.value * c[0]},
        .gradient_bound = {X.slope.error + nu * error + bend, Y.slope.error + mu * error + bend}};
}

/* Root of z tan z = biot in (0, pi/2) by bisection. */
static double bisect(double biot) {
    double lo = 0, hi = M_PI / 2;
    for (int i = 0; i < 200; i++) {
        double z = (lo + hi) / 2;
        *(z * sin(z) < biot * cos(z) ? &lo : &hi) = z;
    }
    return (lo + hi) / 2;
}

/* sqrt(a + i b), a and b >= 0, in real arithmetic. */
static double complex root_of(double a, double b) {
    double re = sqrt((hypot(a, b) + a) / 2);
    return re + I * (b / 2 / re);
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param, nu = nu_of(v), mu = bisect(v[AIR] * v[HEIGHT] / v[K_Y]) / v[HEIGHT];
    struct driven flux = flux_wave(v, root_of(v[K_Y] / v[K_X] * mu * mu, v[OMEGA_Q] * v[RHO_C] / v[K_X]));
    struct driven air = air_wave(v, root_of(v[K_X] / v[K_Y] * nu * nu, v[OMEGA_A] * v[RHO_C] / v[K_Y]));
    struct approx X = driven_reflected(&flux, x[0], flux_phase(v, t), v[OMEGA_Q] * t + fabs(v[PHASE_Q]));
    struct approx Y = driven_reflected(&air, v[HEIGHT] - x[1], air_phase(v, t), v[OMEGA_A] * t + fabs(v[PHASE_A]));
    double rounding = DBL_EPSILON * (20 * (fabs(X.value) + fabs(Y.value)) + v[TM]);
    return (struct exact){.temperature = v[TM] + X.value * cos(mu * x[1]) + Y.value * cos(nu * x[0]),
                          .error_bound = X.error + Y.error + rounding};
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

/* The amplitude that the flux causes is largest on its side; the air's is below B. */
static double largest(const double *v) {
    double complex slope;
    struct driven flux = flux_wave(v, csqrt((I * v[OMEGA_Q] * v[RHO_C] + v[K_Y] * v[MU] * v[MU]) / v[K_X]));
    return cabs(driven_at(&flux, 0, &slope)) + v[B];
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {PHASE_Q, PHASE_A, -1};
    double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_between(params, p, PHASE_Q, -100, 100, NULL, why) ||
        params_between(params, p, PHASE_A, -100, 100, NULL, why))
        return STATUS_INPUT;
    v[MU] = roots_cooled(1, 1, v[AIR] * v[HEIGHT] / v[K_Y]) / v[HEIGHT];
    if (!(largest(v) < v[TM]))
        return refuse(why, STATUS_INPUT, "--set Tm=%g: needs more than %g K, the sum of the amplitudes: T > 0", v[TM],
                      largest(v));
    p->dim = 2;
    p->hi[0] = v[WIDTH];
    p->hi[1] = v[HEIGHT];
    params_material(p, v[K_X], v[K_Y], v[RHO_C]);
    p->side[X_LO] = p->side[Y_LO] = NEUMANN;
    p->side[Y_HI] = ROBIN;
    p->robin[Y_HI] = v[AIR];
    p->initial = initial;
    p->wall = wall;
    p->wall_rate = wall_rate;
    return STATUS_OK;
}

const struct scene scene_plate_driven = {
    .name = "plate-driven",
    .about = "a plate with a periodic flux at one side and periodic air at another: walls that change in time",
    .citation = "Carslaw and Jaeger 1959, sections 2.6 to 2.8 and 3.9; the product of section 1.15",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{0.9, 0.7, 0.031, 0.019, 1.9, 0.17, 2.3, 0.11, 0.61, -0.37, 1.1, 0.37, 1.7, 5.1}, 2, 0.01, 0.7},
};
