/* wall-composite: a wall of two layers warms up from one side until the heat flux is steady.
 *
 *     rho_c dT/dt = d/dx(k dT/dx)  on [0, L],   (k1, rho_c1) for x < x_c, (k2, rho_c2) for x >= x_c,
 *     T(0, t) = T1,   T(L, t) = T2,   T(x, 0) = T2
 *
 * Steady, the same flux q crosses both layers, whose resistances add up: q = (T1 - T2)/(x_c/k1 + (L - x_c)/k2),
 *
 *     S(x) = T1 - q x/k1 for x < x_c,   T2 + q (L - x)/k2 for x >= x_c
 *
 * (Carslaw and Jaeger 1959, section 3.2).  `exact` is S; what is left of the start at time t is in its error bound.
 *
 * Bound: mu is the lowest root of k1 q1 cot(q1 x_c) + k2 q2 cot(q2 (L - x_c)) = 0, q_i^2 = mu rho_c_i/k_i.  In a wall
 * with both layers thicker by the factor g = 1.02 the slowest mode phi decays at mu/g^2, solves the same equation and
 * is positive on all of [0, L], so |T - S| <= max|T2 - S| exp(-mu t/g^2) phi/min phi (maximum principle).
 *
 * End time: at the defaults mu = 15.4 s^-1 (nearly (pi/(2 x_c))^2, an insulated first layer, since k2 << k1), and
 * exp(-mu t_end) = 1.9e-17 at t_end = 2.5 s: steady to round-off.
 *
 * The second form is the whole transient through the Laplace transform.
 *
 * Restrictions: 0 < x_c < L; T1 != T2. */
#include "references/layers.h"
#include "references/params.h"

#include "solver/method.h"

#include <float.h>
#include <math.h>

enum { L, X_C, K1, RHO_C1, T1, K2, RHO_C2, T2, T_END };

static const struct param params[] = {
    {"L", 1, "m", "thickness of the wall", NULL},
    {"x_c", 0.4, "m", "where the layers meet, between 0 and L", NULL},
    {"k1", 1, "W/m/K", "conductivity at x < x_c", NULL},
    {"rho_c1", 1, "J/m^3/K", "heat capacity at x < x_c", NULL},
    {"T1", 1, "K", "temperature at x = 0", NULL},
    {"k2", 0.001, "W/m/K", "conductivity at x > x_c", NULL},
    {"rho_c2", 0.001, "J/m^3/K", "heat capacity at x > x_c", NULL},
    {"T2", 0, "K", "temperature at x = L, and everywhere at the start", NULL},
    {"t_end", 2.5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double initial(const struct problem *p, const double x[2]) {
    (void)x;
    return p->param[T2];
}

static double wall(const struct problem *p, enum side s, const double x[2]) {
    (void)x;
    return p->param[s == X_LO ? T1 : T2];
}

static int setup(struct problem *p, struct failure *why) {
    static const int positive[] = {L, X_C, K1, RHO_C1, K2, RHO_C2, T_END, -1};
    params_keep(p);
    if (params_all_positive(params, p, positive, why)) return STATUS_INPUT;
    if (params_between(params, p, X_C, 0, p->param[L], "the layers meet inside the wall, x_c < L", why))
        return STATUS_INPUT;
    if (params_finite(params, p, T1, why) || params_finite(params, p, T2, why)) return STATUS_INPUT;
    if (p->param[T1] == p->param[T2])
        return refuse(why, STATUS_INPUT, "--set T1=%g: needs a temperature other than T2=%g, or nothing flows",
                      p->param[T1], p->param[T2]);
    p->dim = 1;
    p->hi[0] = p->param[L];
    p->t_end = p->param[T_END];
    p->materials = 2;
    p->interface = p->param[X_C];
    p->material[0] = (struct material){{p->param[K1], p->param[K1]}, p->param[RHO_C1]};
    p->material[1] = (struct material){{p->param[K2], p->param[K2]}, p->param[RHO_C2]};
    p->initial = initial;
    p->wall = wall;
    return STATUS_OK;
}

static struct layers layers_of(const struct problem *p) {
    const double *v = p->param;
    return (struct layers){.width = {v[X_C], v[L] - v[X_C]},
                           .k = {v[K1], v[K2]},
                           .rho_c = {v[RHO_C1], v[RHO_C2]},
                           .wall = {v[T1], v[T2]},
                           .start = {v[T2], v[T2]}};
}

/* max|T2 - S| exp(-mu t/g^2) max phi/min phi: see the opening comment.  phi is 1 at the contact and concave in either
 * layer, so it is least at the contact or at a wall, and largest at the contact or at the top of a sine. */
static double remaining(const struct problem *p, double t) {
    const double g = 1.02, right_angle = 1.57079632679489662;
    struct layers w = layers_of(p);
    double mu = layers_slowest(&w) / (g * g), least = 1, most = 1;
    for (int i = 0; i < 2; i++) {
        double q = sqrt(mu * w.rho_c[i] / w.k[i]), angle = q * g * w.width[i];
        least = fmin(least, sin(angle - q * w.width[i]) / sin(angle));
        if (angle > right_angle) most = fmax(most, 1 / sin(angle));
    }
    return fabs(w.wall[0] - w.wall[1]) * fmin(1, exp(-mu * t) * most / least);
}

static struct exact exact(const struct problem *p, const double x[2], double t) {
    const double *v = p->param;
    double q = (v[T1] - v[T2]) / (v[X_C] / v[K1] + (v[L] - v[X_C]) / v[K2]);
    double S = x[0] < v[X_C] ? v[T1] - q * x[0] / v[K1] : v[T2] + q * (v[L] - x[0]) / v[K2];
    return (struct exact){S, remaining(p, t) + 4 * DBL_EPSILON * (fabs(v[T1]) + fabs(v[T2]))};
}

static struct exact second(const struct problem *p, const double x[2], double t) {
    struct layers w = layers_of(p);
    return layers_at(&w, x[0] - p->param[X_C], t);
}

const struct scene scene_wall_composite = {
    .name = "wall-composite",
    .about = "a wall of two layers, run until it is steady: conductivities a factor of 1000 apart",
    .citation = "Carslaw and Jaeger 1959, section 3.2",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
};
