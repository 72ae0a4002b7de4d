/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The price of a treatment of walls: step and growth by all eigenvalues of the operator; what dummies or fits take.
 */
#include "reports/walls/walls_price.h"

#include "solver/method.h"
#include "solver/particles/particles.h"
#include "verification/command/arguments.h"
#include "verification/stability/spectrum.h"

#include <math.h>

/* By how much an error of the particles may be larger in a dummy: the sum of |share|, of the worst; how many
 * particles it takes, and how well its fit is posed.
 *
 * Derived, of `fit`: about a wall's point particles fill half a disc, and h grows until 15 are in it: 16 in the mean
 * of lattices of any origin and angle.  Moments of the continuous half disc with the cubic kernel, functions scaled
 * to size 1: condition number (1-norm) 49 with the wall's temperatures (x, y, x^2, xy, y^2 free) and 12 with its flux
 * (1, y, x^2, xy, y^2).  The worst of 4000 lattices: 52 and 57, `cooled` as `flux`.
 * Of `one_sided`, in axes that are not the wall's: 6000 lattices of any angle, 0 to 2.2 dx from a plane wall of any
 * direction, take 17.5 particles, and the worst condition numbers are 780 held, 675 flux and 687 cooled.  In the axes
 * of the wall they would be 250, 57 and 94. */
static void take_dummies(const struct cloud *c, struct walls_price *price) {
    size_t dummies = c->begin ? c->total - c->n : 0;
    for (size_t j = 0; j < dummies; j++) {
        double sum = 0;
        for (size_t k = c->begin[j]; k < c->begin[j + 1]; k++) sum += fabs(c->share[k]);
        price->amplification = fmax(price->amplification, sum);
    }
    if (dummies) price->taken = fmax(price->taken, (double)c->begin[dummies] / (double)dummies);
    price->condition = fmax(price->condition, c->condition);
}

/* The operator of a request's run, all eigenvalues. */
static int take_spectrum(const struct experiment *e, struct walls_price *price, struct failure *why) {
    struct options o;
    struct lattice l;
    struct cloud c;
    struct heat_operator a;
    struct spectrum s;
    int rows;
    const struct scheme *scheme = e->method->scheme;
    double unit = problem_diffusivity(&e->problem) / (e->options.dx * e->options.dx);
    if (particles_prepare(&e->problem, &e->options, scheme, &o, &l, &rows, why)) return why->status;
    if (particles_cloud(&e->problem, &o, scheme, &l, &c, why)) return why->status;
    int status = operator_create_csr(&a, &e->problem, &o, scheme, &c, l.dx[0], why);
    take_dummies(&c, price);
    layout_cloud_free(&c);
    if (status) return status;
    status = spectrum_create(&s, &a, &(struct amplification){STEPPER_EULER, 0}, why);
    if (a.fits.rows) price->taken = fmax(price->taken, (double)a.fits.particles / (double)a.fits.rows);
    price->condition = fmax(price->condition, a.fits.condition);
    operator_free(&a);
    if (status) return status;
    price->limit = fmin(price->limit, s.limit * unit);
    price->growth = fmax(price->growth, s.growth > spectrum_rounding(&s) ? s.growth / unit : 0);
    spectrum_free(&s);
    return STATUS_OK;
}

int walls_price_take(struct walls_price *price, struct failure *why, const char *command) {
    struct request r;
    int status = arguments_parse_line(command, &r, why);
    if (!status) status = take_spectrum(&r.experiment, price, why);
    arguments_free(&r);
    return status;
}
