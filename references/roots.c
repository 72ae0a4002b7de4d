/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Roots of increasing phase functions by GSL.
 *
 * A slab cooled at one end has the modes sin(z x/L) with k z/L cos z = -b sin z, or cos(z x/L) with k z/L sin z = b
 * cos z.  With biot = b L/k and atan2 from 0 to pi/2 these conditions are
 *
 *     z + atan2(z, biot) = n pi   or   z - atan2(biot, z) = (n - 1) pi.
 *
 * The left sides increase without bound, so there is one root for each n >= 1, also at biot = 0 and infinity
 * (Carslaw and Jaeger 1959, section 3.9 and appendix IV).
 *
 * Round bodies: since z J_m' = m J_m - z J_(m+1), the conditions at the wall have the form z J_(m+1) = (m + B) J_m
 * with B = infinity, 0 and biot, for J_m and for j_m.  It has one root between 0 and the first root of J_m if m + B >
 * 0; for m = B = 0 it is the first root of J_1 (sections 7.6, 7.7 and 9.4). */
#include "references/roots.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

struct call {
    double (*f)(double z, const void *data);
    const void *data;
};

static double pass_on(double z, void *call) {
    const struct call *c = call;
    return c->f(z, c->data);
}

double roots_increasing(double (*f)(double z, const void *data), const void *data, double lo, double hi) {
    struct call call = {f, data};
    gsl_function function = {pass_on, &call};
    if (f(lo, data) >= 0) return lo;
    if (f(hi, data) <= 0) return hi;
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_root_fsolver_set(solver, &function, lo, hi);
    for (int i = 0; i < 200 && gsl_root_fsolver_iterate(solver) == GSL_SUCCESS; i++)
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), 0,
                                   2 * DBL_EPSILON) == GSL_SUCCESS)
            break;
    double root = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    return root;
}

struct cooled {
    int n, insulated;
    double biot;
};

/* The difference of the two large terms is exact; it is taken first. */
static double phase(double z, const void *data) {
    const struct cooled *c = data;
    return c->insulated ? z - (c->n - 1) * M_PI - atan2(c->biot, z) : z - c->n * M_PI + atan2(z, c->biot);
}

double roots_cooled(int n, int insulated, double biot) {
    struct cooled c = {n, insulated, biot};
    double hi = (insulated ? n - 0.5 : n) * M_PI, lo = (insulated ? n - 1 : n - 0.5) * M_PI;
    if (biot == 0) return lo;
    if (isinf(biot)) return hi;
    return roots_increasing(phase, &c, lo, hi);
}

struct round {
    int m, held; /* held: J_m = 0 */
    double biot;
    double (*J)(int m, double z);
};

static double excess(double z, const void *data) {
    const struct round *c = data;
    if (c->held) return -c->J(c->m, z);
    double weight = c->m + c->biot;
    return (z * c->J(c->m + 1, z) - weight * c->J(c->m, z)) / (1 + weight);
}

/* z J_m' can decrease only for z > m, so the root is above m.  The first root of J_nu is above nu + 1/2 and below nu
 * + 2 nu^(1/3) + 2.41; that of j_m is that of J_(m + 1/2). */
double roots_round(double (*J)(int m, double z), int m, int spherical, enum side_kind wall, double biot) {
    struct round c = {m, wall == DIRICHLET, wall == ROBIN ? biot : 0, J};
    if (m == 0 && wall == NEUMANN) c = (struct round){1, 1, 0, J};
    struct round held = {c.m, 1, 0, J};
    double nu = spherical ? c.m + 0.5 : c.m,
           most = roots_increasing(excess, &held, nu + 0.5, nu + 2 * cbrt(nu) + 2.41);
    return c.held ? most : roots_increasing(excess, &c, c.m, most);
}
