/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cost of a treatment of walls: the stable step and growth from all eigenvalues of the operator, and the work of
 * dummies and fits. */
#include "reports/walls/walls_price.h"

#include "solver/method.h"
#include "solver/particles/particles.h"
#include "solver/time/stepper.h"
#include "verification/judge/command.h"
#include "verification/stability/spectrum.h"

#include <math.h>

/* The amplification of the particles' errors in a dummy: the largest sum of |share|. */
static void take_dummies(const struct cloud *c, struct walls_price *price) {
    size_t dummies = c->begin ? c->total - c->n : 0;
    for (size_t j = 0; j < dummies; j++) {
        double sum = 0;
        for (size_t k = c->begin[j]; k < c->begin[j + 1]; k++) sum += fabs(c->share[k]);
        price->amplification = fmax(price->amplification, sum);
    }
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
    status = spectrum_create(&s, &a, &(struct amplification){stepper_auto(1, 1, 0), 0}, why);
    operator_free(&a);
    if (status) return status;
    price->limit = fmin(price->limit, s.limit * unit);
    price->growth = fmax(price->growth, s.growth > spectrum_rounding(&s) ? s.growth / unit : 0);
    spectrum_free(&s);
    return STATUS_OK;
}

int walls_price_take(struct walls_price *price, struct failure *why, const char *command) {
    struct command r;
    int status = command_read(command, &r, why);
    if (!status) status = take_spectrum(&r.experiment, price, why);
    command_free(&r);
    return status;
}
