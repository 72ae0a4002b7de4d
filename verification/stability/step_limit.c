/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stability limits of explicit methods.
 *
 * Published: Song 2018 eq. 34, SO-SSPH:  dt <= 1/|kappa_x eta_i + kappa_y phi_i| with the weights eta_i, phi_i of
 * the particle itself (a necessary condition of |Re G| <= 1 only if no other weight is negative);  eq. 41, FO-SSPH:
 * dt <= 1/(2 (kappa_x (sum |lambda_j|)^2 + kappa_y (sum |gamma_j|)^2)).  Pamplona 2019 eq. 17, FTCS: dt <= gamma
 * (dx^2 + dy^2)/kappa, gamma = 1/4; all three are extended here to dim axes by one term per axis.  Their eq. 15 for
 * SPH, dt = beta h^2/kappa, leaves beta open.
 *
 * Measured: noise over LIMIT_STEPS = N steps.  A mode at a relative distance e above its limit grows by at least
 * (1 + 2e)^N.  Its share of the noise is at least 1/n, so it exceeds 2 K for e > ln(2 n)/(2 N) = 0.2 % (n = 24).
 * Modes that neither grow nor decay (the checkerboard of a first difference) keep their initial amplitude, below 1
 * K, and are not counted as growth.  Bisection stops at 1 %.
 *
 * A mode with an eigenvalue of positive real part grows with time, not with the number of steps.  Shorter steps are
 * therefore run for the same time, 500 dx^2/kappa; if a 64th of the step still grows, no step is stable. */
#include "verification/stability/step_limit.h"

#include "solver/time/stepper.h"
#include "solver/words.h"

#include "verification/stability/spectrum.h"
#include "verification/stability/symbol.h"
#include "verification/text/json.h"

#include <math.h>
#include <string.h>

enum { HALVED = 64 };

static int is(const struct model_problem *b, const char *name) {
    return strcmp(b->method->name, name) == 0;
}

int step_limit_model(struct model_problem *b, struct failure *why) {
    int rows = model_problem_has_rows(b);
    static const int along[DIM_MAX][2] = {
        {LIMIT_ROD, LIMIT_ROD}, {LIMIT_SQUARE, LIMIT_SQUARE_JITTER}, {LIMIT_CUBE, LIMIT_CUBE_JITTER}};
    return model_problem_resolve(b, along[b->dim - 1][rows], why);
}

/* Refuses a stepper without a largest stable step. */
static int refuse_stepper(const struct stepper *s, struct failure *why) {
    const char *reason = s->evolve ? "has no steps"
                         : s->plan ? "determines its own step"
                                   : "is stable at any step, with more updates";
    const char *names[WORDS_MAX] = {0};
    char text[200];
    for (int i = 1, n = 0; stepper_words[i] && n < WORDS_MAX - 1; i++)
        if (stepper_of((enum stepper_name)i)->amplification) names[n++] = stepper_words[i];
    words_join(names, text, sizeof text);
    return refuse(why, STATUS_INPUT, "--stepper %s: it %s; use %s", s->name, reason, text);
}

int step_limit_setup(const struct method *m, const struct options *o, int dim, double ratio, double field,
                     double contact, int stages, struct model_problem *b, struct failure *why) {
    *b = (struct model_problem){.method = m,
                                .dim = dim,
                                .ratio = ratio,
                                .field = field,
                                .contact = contact,
                                .options = *o,
                                .step = {o->stepper, stages}};
    if (field != 0 && (dim != 2 || contact > 0 || options_is_cloud(o)))
        return refuse(why, STATUS_INPUT, "--field %g: is for --dim 2, one material and a regular layout", field);
    if (field == 0 && o->cross) return refuse(why, STATUS_INPUT, "--cross %s: needs --field", cross_words[o->cross]);
    if (contact > 0 && !m->scheme)
        return refuse(why, STATUS_INPUT, "--contact %g: %s has no rows for eigenvalues; use contact_ssph", contact,
                      m->name);
    if (ratio > 0 && dim == 1)
        return refuse(why, STATUS_INPUT, "--ratio %g: a rod has one diffusivity; use --dim 2", ratio);
    const int is_auto = b->step.stepper == STEPPER_AUTO;
    const struct stepper *stepper = stepper_of(is_auto ? stepper_auto(1, 1, 0) : b->step.stepper);
    if (!stepper->amplification) return refuse_stepper(stepper, why);
    if (stepper->order != 1 && !m->scheme)
        return refuse(why, STATUS_INPUT, "--stepper %s: %s has euler", stepper->name, m->name);
    const int least_stages = stepper->count ? stepper->count(0, 0) : 0;
    if (least_stages ? stages < least_stages : stages > 0)
        return stepper->count
                   ? refuse(why, STATUS_INPUT,
                            "--stepper %s: its steps have any number of stages; add --stages N, %d or more",
                            stepper->name, least_stages)
                   : refuse(why, STATUS_INPUT, "--stages %d: %s has %d", stages, stepper->name, stepper->stages);
    return step_limit_model(b, why);
}

/* Song eqs. 34 and 41 for one particle; keeps the smallest bound. */
static int song_bound(const struct model_problem *b, const struct neighbourhood *nb, void *strictest,
                      struct failure *why) {
    double w[DIM_MAX][NEIGHBOURS_MAX];
    double *out[DIM_MAX] = {w[0], w[1], w[2]}, squares = 0, own = 0, *least = strictest;
    int sweeps = b->method->scheme->sweeps;
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    if (operator_weights(b->method->scheme, &p, &b->options, nb, out, why)) return why->status;
    for (size_t k = 0; k < nb->n; k++) own += w[0][k];
    for (int a = 0; a < b->dim && sweeps == 2; a++) {
        double sum = 0;
        for (size_t k = 0; k < nb->n; k++) sum += fabs(w[a][k]);
        squares += nb->kappa[a] * sum * sum;
    }
    *least = fmin(*least, sweeps == 2 ? 0.5 / squares : 1 / fabs(own));
    return STATUS_OK;
}

/* On a lattice one particle represents all. */
static int song(const struct model_problem *b, double *published, struct failure *why) {
    struct cloud c;
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    *published = INFINITY;
    if (!options_is_cloud(&b->options)) {
        double d[NEIGHBOURS_MAX][DIM_MAX];
        struct neighbourhood nb;
        if (operator_neighbourhood(b->dim, 1, b->options.h, d, &nb, why)) return why->status;
        for (int a = 0; a < b->dim; a++) nb.kappa[a] = p.material[0].k[a];
        return song_bound(b, &nb, published, why);
    }
    if (model_problem_cloud(b, &p, &c, why)) return why->status;
    int status = model_problem_around(b, &c, c.n, song_bound, published, why);
    layout_cloud_free(&c);
    return status;
}

static int publish(const struct model_problem *b, struct step_limit *l, struct failure *why) {
    l->published = NAN, l->source = NULL;
    if (stepper_of(b->step.stepper)->order != 1) return STATUS_OK; /* the published bounds are for Euler's method */
    if (b->contact > 0 || b->field != 0) return STATUS_OK;         /* and for one material without k_xy */
    if (is(b, "ftcs")) {
        l->published = 0.25 * b->dim, l->source = "Pamplona 2019, eq. 17 with gamma = 1/4";
    } else if (is(b, "so_ssph") && b->options.order <= 2) {
        l->source = "Song 2018, eq. 34";
        return song(b, &l->published, why);
    } else if (is(b, "fo_ssph")) {
        l->source = "Song 2018, eq. 41";
        return song(b, &l->published, why);
    }
    return STATUS_OK;
}

static int from_symbol(const struct model_problem *b, struct step_limit *l, struct failure *why) {
    struct symbol s;
    if (symbol_create(&s, b, why)) return why->status;
    struct symbol_extreme e = symbol_extreme(&s, &b->step);
    l->von_neumann = e.limit, l->growth = e.growth, l->radius = e.radius;
    l->grows = e.growth > 1e-12 * e.radius;
    memcpy(l->theta, e.theta, sizeof l->theta);
    symbol_free(&s);
    return STATUS_OK;
}

static int from_spectrum(const struct model_problem *b, struct step_limit *l, struct failure *why) {
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    struct heat_operator a;
    struct spectrum s;
    if (model_problem_operator(b, &p, &a, why)) return why->status;
    l->particles = a.n;
    int status = spectrum_create(&s, &a, &b->step, why);
    operator_free(&a);
    if (status) return status;
    l->von_neumann = s.limit, l->growth = s.growth, l->radius = s.radius;
    l->grows = s.growth > spectrum_rounding(&s);
    for (int axis = 0; axis < DIM_MAX; axis++) l->theta[axis] = NAN;
    spectrum_free(&s);
    return STATUS_OK;
}

int step_limit_predict(const struct model_problem *b, struct step_limit *l, struct failure *why) {
    *l = (struct step_limit){.published = NAN, .measured = NAN};
    if (publish(b, l, why)) return why->status;
    if (model_problem_has_rows(b) ? from_spectrum(b, l, why) : from_symbol(b, l, why)) return why->status;
    double h = b->options.h;
    l->beta = b->method->scheme ? l->von_neumann / (h * h) : NAN;
    return STATUS_OK;
}

int step_limit_grows(const struct model_problem *b, double F, long long steps, struct failure *why) {
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    double largest;
    int status = model_problem_run(b, &p, F, steps, &largest, why);
    return status == STATUS_UNSTABLE ? 1 : status ? -1 : !(largest <= 2);
}

int step_limit_measure(const struct model_problem *b, double *measured, struct failure *why) {
    double in = 0, out = 0, first = amplification_interval(&b->step) / 4, F = first;
    while (!(in > 0 && out > 0) && F >= first / HALVED && F <= first * HALVED) {
        int grows = step_limit_grows(b, F, (long long)(LIMIT_STEPS * fmax(1, first / F)), why);
        if (grows < 0) return why->status;
        *(grows ? &out : &in) = F;
        F *= grows ? 0.5 : 2;
    }
    *measured = out > 0 ? 0 : INFINITY;
    if (!(in > 0 && out > 0)) return STATUS_OK;
    while (out > 1.01 * in) {
        double middle = sqrt(in * out);
        int grows = step_limit_grows(b, middle, LIMIT_STEPS, why);
        if (grows < 0) return why->status;
        *(grows ? &out : &in) = middle;
    }
    *measured = sqrt(in * out);
    return STATUS_OK;
}

void step_limit_json(const struct model_problem *b, const struct step_limit *l, struct json *j) {
    json_add(j, "method %s|dim %d", b->method->name, b->dim);
    json_text(j, "kernel", b->method->scheme ? kernel_words[b->options.kernel] : NULL);
    json_number(j, "h", b->method->scheme ? b->options.h : NAN);
    json_add(j, "layout %s|jitter %g|seed %lld|walls %s", layout_words[b->options.layout], b->options.jitter,
             (long long)b->options.seed, walls_words[b->options.walls]);
    json_number(j, "ratio", b->dim > 1 ? model_problem_kappa_y(b) : NAN);
    json_number(j, "field [degrees]", b->field != 0 ? b->field : NAN);
    json_number(j, "contact", b->contact > 0 ? b->contact : NAN);
    json_add(j, "stepper %s|published %g|source %s|von_neumann %g|measured %g", stepper_words[b->step.stepper],
             l->published, l->source, l->von_neumann, l->measured);
    json_add(j, "beta %g|radius [kappa/dx^2] %g|growth [kappa/dx^2] %g", l->beta, l->radius, l->growth);
    struct customary_step custom[CUSTOMARY_STEPS];
    int customs = step_limit_customary(b, custom);
    json_array(j, "customary");
    for (int k = 0; k < customs; k++) {
        json_object(j, NULL);
        json_add(j, "source %s|step %g|times_stable %g", custom[k].source, custom[k].F, custom[k].F / l->von_neumann);
        json_end(j);
    }
    json_end(j);
    json_numbers(j, "theta", l->theta, b->dim);
}

/* ---- Customary steps, dt = C h^2/kappa ---- */

/* Morris, Fox & Zhu 1997 (J. Comput. Phys. 136:214): C = 0.125 for a viscosity nu in place of kappa, with a quintic
 *   spline of support 3 h.  For a kernel with the support 2 h used here, their h is 2/3 of this h.
 * Cleary & Monaghan 1999 (J. Comput. Phys. 148:227): C = 0.15, dt = 0.15 rho c h^2/k, a cubic spline of support 2 h.
 * Biriukov & Price 2019 (MNRAS 483:4901), table of the largest stable C for three kernels in three dimensions:
 *   Brookshaw's pairs 0.15, 0.18, 0.2; direct second derivatives 0.2, 0.35, 0.4; two first derivatives 0.6, 1.2, 1.6.
 *   The smallest of each is used, with h of a kernel of support 2 h.
 *
 * For a method without h (cells) the default h/dx of the other methods is used, as in a code that changes only its
 * operator. */

static double biriukov(const char *method) {
    static const struct {
        const char *method;
        double C;
    } table[] = {{"brookshaw", 0.15}, {"kernel_second", 0.2}, {"conjugate", 0.6}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        if (strcmp(table[k].method, method) == 0) return table[k].C;
    return 0;
}

int step_limit_customary(const struct model_problem *b, struct customary_step out[CUSTOMARY_STEPS]) {
    const struct scheme *s = b->method->scheme;
    if (!s || stepper_of(b->step.stepper)->order != 1) return 0;
    double h = s->cells ? 1.1 : b->options.h, morris = h * 2 / 3, C = biriukov(b->method->name);
    int n = 0;
    out[n++] = (struct customary_step){"Morris et al. 1997, 0.125 h^2/kappa, kernel to 3 h", 0.125 * morris * morris};
    out[n++] = (struct customary_step){"Cleary & Monaghan 1999, 0.15 rho c h^2/k, kernel to 2 h", 0.15 * h * h};
    if (C > 0) out[n++] = (struct customary_step){"Biriukov & Price 2019, table, kernel to 2 h", C * h * h};
    return n;
}
