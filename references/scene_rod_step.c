/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rod-step: a hot piece in the middle of a rod (Song, Xing, Hou, Lu 2018, section 5.1).
 *
 *     dT/dt = kappa d2T/dx2  on [-L, L],   T(-L, t) = T(L, t) = 0,   T(x, 0) = T0 for |x| <= a, else 0   (42-44)
 *
 * On the infinite line the box spreads as U(x, t) = T0/2 (erf((a+x)/s) + erf((a-x)/s)), s = sqrt(4 kappa t).  Eq. 45
 * prints this as the exact solution (with kappa_y in its second term, although one dimension has kappa_x only).  U
 * does not vanish at the walls; at the defaults it exceeds the solution between walls by T0/2 erfc((L-a)/s) = 1.0e-5
 * K there.  Images of alternating sign at 2kL make it exact:
 *
 *     T(x, t) = sum_k (-1)^k U(x - 2kL, t)
 *             = sum_n 2 T0 sin(q a)/(q L) cos(q x) exp(-q^2 kappa t),   q = (n + 1/2) pi/L
 *
 * The images are used for s <= L, the modes later; each form checks the other.  Errors are of the order of
 * round-off.
 *
 * Restrictions: a < L.  At t = 0 the edges |x| = a belong to the box (eq. 43). */
#include "references/params.h"
#include "references/series.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, A, KAPPA, T0, T_END };

static const struct param params[] = {
    {"L", 2, "m", "half length of the rod, walls at -L and L", NULL},
    {"a", 0.5, "m", "half width of the hot piece, below L", NULL},
    {"kappa", 0.01, "m^2/s", "diffusivity", NULL},
    {"T0", 10, "K", "initial temperature of the hot piece above that of the walls", NULL},
    {"t_end", 5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double width_at(const struct problem *p, double t) {
    return sqrt(4 * p->param[KAPPA] * t);
}

static double initial(const struct problem *p, const double *x) {
    return series_in_box(x[0], p->param[A]) ? p->param[T0] : 0;
}

static int setup(struct problem *p, struct failure *why) {
    if (params_start(params, p, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, p->param[L], "the hot piece ends before the walls, a < L", why))
        return STATUS_INPUT;
    p->dim = 1;
    p->lo[0] = -p->param[L];
    p->hi[0] = p->param[L];
    params_material(p, p->param[KAPPA], p->param[KAPPA], 1);
    p->jumps[0] = 2;
    p->jump[0][0] = -p->param[A];
    p->jump[0][1] = p->param[A];
    p->mirror[0] = 1;
    p->initial = initial;
    return STATUS_OK;
}

static struct exact scaled(const struct problem *p, struct curve u) {
    double peak = p->param[T0];
    return (struct exact){.temperature = peak * u.at.value,
                          .error_bound = peak * (u.at.error + DBL_EPSILON * fabs(u.at.value)),
                          .gradient = {peak * u.slope.value},
                          .gradient_bound = {peak * (u.slope.error + DBL_EPSILON * fabs(u.slope.value))}};
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    return scaled(p, series_box(x[0], p->param[L], p->param[A], width_at(p, t)));
}

static struct exact second(const struct problem *p, const double *x, double t) {
    return scaled(p, series_box_other(x[0], p->param[L], p->param[A], width_at(p, t)));
}

static double published(const struct problem *p, const double *x, double t) {
    return p->param[T0] * series_box_line(x[0], p->param[A], width_at(p, t));
}

const struct scene scene_rod_step = {
    .name = "rod-step",
    .about = "a hot piece in the middle of a rod between cold walls: data with two jumps",
    .citation = "Song, Xing, Hou, Lu 2018, section 5.1, eqs. 42-45",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .published = published,
    .odd = {{1.7, 0.62, 0.013, 7.3, 2.385}, 7, 0.01, 1.5},
};
