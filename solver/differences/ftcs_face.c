/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The conductance of a face: flux = C (T_n - T_i), C = k area / distance.
 *
 * Two materials in contact at a plane across x.  The series mean between two points is k = d / (l_1/k_1 + l_2/k_2),
 * l_m the length of the line between them in material m (Patankar 1980, sections 4.2-3, for any place of the
 * interface).  Steady profiles are then exact and the cells have the heat of both materials: second order for any
 * interface position.  The harmonic and arithmetic means use the conductivities at the two points; they are exact,
 * respectively first order, if the interface is midway.  Along y and z the two parts of a cell that the interface
 * cuts conduct in parallel, with the mean of k_y or k_z over its width.  A point or face within round-off of the
 * interface is on it.
 *
 * A contact resistance R on a rod is in series with the two parts of a line, k = d / (l_1/k_1 + R + l_2/k_2): steady
 * profiles remain exact.  The parts of a cut cell then differ by R q, which is not small with d, so the cell cannot
 * have one temperature: the first point on either side has the heat of its own material up to the interface, in a
 * width of d/2 + its distance from there (d/2 to 3 d/2).  The heat of a side is then that of a sum over points up to
 * O(d^2), and the flux between them is q (1 + O(d^2)): second order.  A point on the interface is of material 1, with
 * half a cell.  The harmonic and arithmetic means have no place for R.
 *
 * Conductivity that depends on temperature.  With theta(T), the integral of k, the mean of k over the temperatures
 * between two points conducts theta_n - theta_i (kirchhoff): the differences of one material, with theta for T.  The
 * harmonic and arithmetic means use the two values of k.  The harmonic mean of Patankar is 0 if one of them is 0.
 *
 * A wall half a cell away: a held wall has the same mean of k between T_i and T_wall; a flux is given; at a Robin
 * wall T_wall balances k dT/dn = b (T_a - T_wall), with the mean of k over the temperatures.
 *
 * Phases.  The unknown is U, the enthalpy from the melting point over rho_c of the faster phase, in K: dU/dt is the
 * sum of the differences of theta over that rho_c, and theta is k T of the solid for U < 0, 0 while the cell melts, 0
 * < U < latent/rho_c, and that of the liquid beyond.  theta does not fall with U, so that a step of Euler's is
 * monotone for dt sum of kappa/dx^2 up to 1/2, at a wall 1/3 (its ghost counts twice).  The weights of rk2 and rkl2
 * have either sign (nu_2 = -1/2): no step of theirs is monotone, and both are refused.
 *
 * Restriction: a conductivity that depends on temperature is isotropic. */
#include "solver/differences/ftcs.h"

#include <math.h>

/* ---- Two materials ---- */

/* Distance of x beyond the interface in units of d, with round-off removed. */
static double depth(const struct problem *p, double d, double x) {
    double apart = (x - p->interface) / fabs(d), edge = nearbyint(2 * apart) / 2;
    return fabs(apart - edge) < 1e-9 ? edge : apart;
}

/* The part of its own material that the point x has, with a resistance. */
static void own_part(const struct problem *p, double d, double x, double at, double share[2], double middle[2]) {
    const int m = at >= 0, is_first = at >= -1 && at < 1;
    share[m] = is_first ? 0.5 + fabs(at) : 1;
    share[1 - m] = 0;
    middle[m] = is_first ? p->interface + (m ? 0.5 : -0.5) * share[m] * d : x;
}

/* Parts of the cell about x on either side of the interface: their widths in units of d and their centres, m. */
void ftcs_face_parts(const struct problem *p, double d, double x, double share[2], double middle[2]) {
    double at = p->materials == 2 ? depth(p, d, x) : -1;
    if (p->resistance > 0) {
        own_part(p, d, x, at, share, middle);
        return;
    }
    share[0] = fmin(1, fmax(0, 0.5 - at));
    share[1] = 1 - share[0];
    middle[0] = middle[1] = x;
    if (share[0] == 0 || share[1] == 0) return;
    middle[0] = p->interface - 0.5 * share[0] * d;
    middle[1] = p->interface + 0.5 * share[1] * d;
}

/* J m^-3 K^-1: heat capacity of the parts of the cell about x over its volume. */
double ftcs_face_rho_c(const struct problem *p, double d, double x) {
    double share[2], middle[2];
    ftcs_face_parts(p, d, x, share, middle);
    return share[0] * p->material[0].rho_c + (share[1] > 0 ? share[1] * p->material[1].rho_c : 0);
}

/* W m^-1 K^-1: between x and x + d (of either sign) along x; along another axis that of the cell about x. */
double ftcs_face_k(const struct problem *p, enum mean mean, int axis, double d, double x) {
    double share[2], middle[2];
    if (p->materials < 2) return p->material[0].k[axis];
    if (axis != 0) {
        ftcs_face_parts(p, d, x, share, middle);
        return share[0] * p->material[0].k[axis] + share[1] * p->material[1].k[axis];
    }
    double here = depth(p, d, x), there = here + (d > 0 ? 1 : -1);
    double ka = p->material[here >= 0].k[0], kb = p->material[there >= 0].k[0];
    double beyond = fmin(1, fmax(0, fmax(here, there))); /* fraction of the line */
    double R = (here >= 0) == (there >= 0) ? 0 : p->resistance / fabs(d);
    if (mean == MEAN_ARITHMETIC) return 0.5 * (ka + kb);
    if (mean != MEAN_SERIES && !(R > 0)) return 2 * ka * kb / (ka + kb);
    return 1 / ((1 - beyond) / p->material[0].k[0] + R + beyond / p->material[1].k[0]);
}

/* ---- Conductivity that depends on temperature ---- */

static double phase_kappa(const struct problem *p, int liquid) {
    return p->phase_k[liquid] / p->phase_rho_c[liquid];
}

/* 1 for a cell at the melting point */
static int is_melting(const struct problem *p, double U) {
    return U >= 0 && U <= p->latent / p->material[0].rho_c;
}

double ftcs_face_state(const struct problem *p, double T) {
    if (p->k_law != K_PHASES) return T;
    double u = T - p->k_ref, heat = p->phase_rho_c[u > 0] * u;
    return (heat + (u > 0 ? p->latent : u < 0 ? 0 : p->latent / 2)) / p->material[0].rho_c;
}

double ftcs_face_temperature(const struct problem *p, double U) {
    if (p->k_law != K_PHASES) return U;
    const double heat = p->material[0].rho_c * U;
    return p->k_ref + (is_melting(p, U) ? 0 : (U > 0 ? heat - p->latent : heat) / p->phase_rho_c[U > 0]);
}

/* W m^-1 K^-1, of a state */
double ftcs_face_law(const struct problem *p, double T) {
    if (p->k_law == K_PHASES) return is_melting(p, T) ? 0 : phase_kappa(p, T > 0) * p->material[0].rho_c;
    double u = T - p->k_ref, k = p->k_law == K_LINEAR ? p->k_0 * (1 + p->k_beta * u) : p->k_0;
    if (p->k_law == K_POWER) k *= u > 0 ? pow(u, p->k_n) : 0;
    return k > 0 ? k : 0;
}

/* W m^-1 */
static double theta(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_PHASES) return p->phase_k[u > 0] * u;
    if (p->k_law == K_LINEAR) return p->k_0 * u * (1 + p->k_beta * u / 2);
    return u > 0 ? p->k_0 / (p->k_n + 1) * pow(u, p->k_n + 1) : 0;
}

static double mean_of(enum mean mean, double a, double b) {
    if (mean != MEAN_HARMONIC) return (a + b) / 2;
    return a > 0 && b > 0 ? 2 / (1 / a + 1 / b) : 0;
}

/* T_wall from theta(T_wall) - theta(T) = half q(T_wall), q the law of the side.  The left side grows with T_wall and
 * the right one falls: Newton's method, between the two temperatures. */
static double balanced(const struct problem *p, enum side s, double T, double T_a, double half) {
    enum { MOST = 60 };
    double lo = fmin(T, T_a), hi = fmax(T, T_a), wall = T, known = theta(p, T);
    for (int i = 0; i < MOST && lo < hi; i++) {
        double slope, heat = problem_law(p, (int)s)->exchange(p, s, half, T_a, wall, &slope);
        double apart = theta(p, wall) - known - heat;
        *(apart > 0 ? &hi : &lo) = wall;
        double next = wall - apart / (ftcs_face_law(p, wall) - slope);
        if (!(next > lo && next < hi)) next = lo + (hi - lo) / 2;
        if (next == wall || next == lo || next == hi) break;
        wall = next;
    }
    return wall;
}

/* Flux into a cell at T with the conductivity k, W m^-2, through a wall at the distance `half`. */
double ftcs_face_wall(const struct ftcs_grid *g, enum side s, double T, double k, double value, double half) {
    const struct problem *p = g->p;
    const struct wall_law *law = problem_law(p, (int)s);
    double slope;
    if (law->is_flux) return value;
    if (p->k_frozen) return (value - T) / (half / k + (law->exchange ? 1 / problem_transfer(p, (int)s) : 0));
    if (law->exchange) return law->exchange(p, s, 1, value, balanced(p, s, T, value, half), &slope);
    if (!g->C[0]) return (theta(p, value) - theta(p, ftcs_face_temperature(p, T))) / half;
    return mean_of(g->o->mean, k, ftcs_face_law(p, value)) * (value - T) / half;
}

/* The faces between the cells of an axis, and between the first and the last one of periodic sides.  Those of walls
 * have the largest k of the problem, since their ghosts follow from the flux. */
static void refresh_axis(struct ftcs_grid *g, int a) {
    const double k_wall = g->p->material[0].k[a], share = 1 / (g->d[a] * g->d[a]);
    const ptrdiff_t next = g->stride[a], extent = (g->n[a] - 1) * next;
    const int wraps = g->p->side[2 * a] == PERIODIC;
    double volume = g->d[0] * g->d[1] * g->d[2], *C = g->C[a];
    int i[DIM_MAX] = {0};
    do {
        const ptrdiff_t at = ftcs_at(g, i);
        const double k = g->law[at];
        const double below = i[a] ? g->law[at - next] : wraps ? g->law[at + extent] : NAN;
        C[at] = volume * share * (i[a] || wraps ? mean_of(g->o->mean, below, k) : k_wall);
        if (i[a] == g->n[a] - 1)
            C[at + next] = volume * share * (wraps ? mean_of(g->o->mean, k, g->law[at - extent]) : k_wall);
    } while (ftcs_next(g, i));
}

/* theta, or k and the conductances, of the state T. */
void ftcs_face_refresh(struct ftcs_grid *g, const double *T) {
    const struct problem *p = g->p;
    const int melts = p->k_law == K_PHASES;
    int i[DIM_MAX] = {0};
    do {
        const ptrdiff_t at = ftcs_at(g, i);
        for (ptrdiff_t k = 0; k < g->n[0] && !g->C[0] && !melts; k++) g->law[at + k] = theta(p, T[at + k]);
        for (ptrdiff_t k = 0; k < g->n[0] && melts; k++)
            g->law[at + k] = theta(p, ftcs_face_temperature(p, T[at + k]));
        for (ptrdiff_t k = 0; k < g->n[0] && g->C[0]; k++) g->law[at + k] = ftcs_face_law(p, T[at + k]);
        i[0] = g->n[0] - 1;
    } while (ftcs_next(g, i));
    for (int a = 0; a < p->dim && g->C[0]; a++) refresh_axis(g, a);
}
