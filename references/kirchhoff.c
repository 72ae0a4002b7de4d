/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conductivities that depend on temperature. */
#include "references/kirchhoff.h"
#include "references/params.h"

#include "solver/status.h"

#include <math.h>

double kirchhoff_k(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_PHASES) return p->phase_k[u > 0];
    if (p->k_law == K_POWER) return u > 0 ? p->k_0 * pow(u, p->k_n) : 0;
    return p->k_law == K_LINEAR ? p->k_0 * (1 + p->k_beta * u) : p->material[0].k[0];
}

double kirchhoff_slope(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_POWER) return u > 0 ? p->k_0 * p->k_n * pow(u, p->k_n - 1) : 0;
    return p->k_law == K_LINEAR ? p->k_0 * p->k_beta : 0;
}

double kirchhoff_theta(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_PHASES) return p->phase_k[u > 0] * u;
    if (p->k_law == K_POWER) return u > 0 ? p->k_0 * pow(u, p->k_n + 1) / (p->k_n + 1) : 0;
    return p->k_law == K_LINEAR ? p->k_0 * u * (1 + p->k_beta * u / 2) : p->material[0].k[0] * u;
}

double kirchhoff_along(const struct problem *p, const struct material *m, int axis, double T) {
    return p->k_law ? kirchhoff_k(p, T) : m->k[axis];
}

int kirchhoff_linear(const struct param *table, struct problem *p, const int index[3], double rho_c, double lo,
                     double hi, struct failure *why) {
    double least, most;
    p->k_law = K_LINEAR;
    p->k_0 = p->param[index[0]], p->k_beta = p->param[index[1]], p->k_ref = p->param[index[2]];
    least = fmin(kirchhoff_k(p, lo), kirchhoff_k(p, hi)), most = fmax(kirchhoff_k(p, lo), kirchhoff_k(p, hi));
    if (!(least > 0))
        return refuse(why, STATUS_INPUT, "--set %s=%g: needs k = %s (1 + %s (T - %s)) > 0 from %g to %g K",
                      table[index[1]].name, p->k_beta, table[index[0]].name, table[index[1]].name,
                      table[index[2]].name, lo, hi);
    params_material(p, most, most, rho_c);
    return STATUS_OK;
}
