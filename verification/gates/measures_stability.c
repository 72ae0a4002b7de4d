/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of stability: limits, steppers' intervals, maximum principle, refusals, long runs. */
#include "verification/gates/measures.h"

#include "solver/time/stepper.h"
#include "solver/words.h"
#include "verification/stability/long_run.h"
#include "verification/stability/step_limit.h"
#include "verification/stability/maximum_principle.h"
#include "verification/case/command.h"
#include "verification/judge/run.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The model problem, the limit that theory gives where l is not NULL, and the one that runs show where `measured`. 0,
 * or *m failed. */
static int find(const struct command *r, struct model_problem *b, struct step_limit *l, int measured,
                struct measured *m) {
    struct failure why = {0};
    int status = step_limit_setup(r->experiment.method, &r->experiment.options, r->dim, r->ratio, r->contact,
                                  r->stages, b, &why);
    if (!status && l) status = step_limit_predict(b, l, &why);
    if (!status && l && measured) status = step_limit_measure(b, &l->measured, &why);
    measures_fail(m, &why);
    return status;
}

void measures_limit_agree(const struct command *r, double lo, double hi, struct measured *m) {
    static const double ratio[] = {1.05, 1.5, 2.05};
    double worst = 0, at[3] = {NAN, NAN, NAN};
    int count = r->experiment.options.h > 0 || !r->experiment.method->scheme ? 1 : 3;
    for (int k = 0; k < count; k++) {
        struct command with = *r;
        struct model_problem b;
        struct step_limit l;
        if (count > 1) with.experiment.options.h = ratio[k];
        if (find(&with, &b, &l, 1, m)) return;
        double apart = fabs(l.measured / l.von_neumann - 1);
        if (apart < worst) continue;
        worst = apart;
        at[0] = b.options.h, at[1] = l.measured, at[2] = l.von_neumann;
        if (isnan(apart)) break;
    }
    measures_judge(m, worst, lo, hi);
    words_add(m->reason, sizeof m->reason, " (h/dx %.4g: measured %.5g, von Neumann %.5g)", at[0], at[1], at[2]);
}

void measures_limit_published(const struct command *r, double lo, double hi, struct measured *m) {
    enum { STEPS = 1000 };
    struct model_problem b;
    struct step_limit l;
    struct failure why;
    if (find(r, &b, &l, 0, m)) return;
    int grows = step_limit_grows(&b, 0.99 * l.published, STEPS, &why);
    measures_judge(m, l.published / l.von_neumann, lo, hi);
    words_add(m->reason, sizeof m->reason, " (published %.5g, von Neumann %.5g)", l.published, l.von_neumann);
    if (grows == (l.published * 0.99 > l.von_neumann)) return;
    m->verdict = VERDICT_FAIL;
    words_add(m->reason, sizeof m->reason, grows ? "; yet a run at %.5g grew" : "; yet a run at %.5g decayed",
              0.99 * l.published);
}

void measures_limit_interval(const struct command *r, double lo, double hi, struct measured *m) {
    struct model_problem b;
    struct step_limit l;
    if (find(r, &b, &l, 1, m)) return;
    measures_judge(m, l.measured * l.radius / amplification_interval(&b.step), lo, hi);
    words_add(m->reason, sizeof m->reason, " (measured %.5g of 1/|lambda|, theory %.5g; |G| = 1 at %.5g)",
              l.measured * l.radius, amplification_interval(&b.step), amplification_reach(&b.step));
}

/* One step of the stepper on the one equation dT/dt = -T. */
static double factor(const struct amplification *step, double dt) {
    size_t row[2] = {0, 0}, bytes = 0;
    double diagonal[1] = {-1}, T[1] = {1};
    struct heat_operator a = {.n = 1, .state = 1, .row = row, .diagonal = diagonal};
    struct march m = {
        .stepper = step->stepper, .time = dt, .steps = 1, .stages = step->stages, .lo = -1e300, .hi = 1e300};
    struct failure why;
    return stepper_march(&a, &m, T, &bytes, &why) ? NAN : T[0];
}

void measures_stepper_factor(const struct command *r, double lo, double hi, struct measured *m) {
    enum { POINTS = 400 };
    struct model_problem b;
    double worst = 0;
    if (find(r, &b, NULL, 0, m)) return;
    for (int k = 0; k <= POINTS && !isnan(worst); k++) {
        double z = 1.2 * amplification_interval(&b.step) * k / POINTS,
               theory = creal(amplification_factor(&b.step, -z));
        double apart = fabs(factor(&b.step, z) - theory) / (1 + fabs(theory));
        if (!(apart <= worst)) worst = apart;
    }
    measures_judge(m, worst, lo, hi);
}

void measures_growth(const struct command *r, double lo, double hi, struct measured *m) {
    struct model_problem b;
    struct step_limit l;
    if (!find(r, &b, &l, 0, m)) measures_judge(m, l.growth, lo, hi);
}

void measures_maximum_principle(const struct command *r, double lo, double hi, struct measured *m) {
    struct model_problem b;
    double where = NAN, kept = 0, refused = 0, apart = 0;
    if (find(r, &b, NULL, 0, m)) return;
    for (int k = 0; k < MAXIMUM_COUNT; k++) {
        struct maximum_principle x;
        struct failure why;
        if (maximum_principle_find(&b, maximum_principle_h(k), &x, &why)) {
            refused++;
            continue;
        }
        int weights = x.lowest >= -MAXIMUM_ROUNDING, runs = x.undershoot <= MAXIMUM_ROUNDING;
        kept += weights;
        if (weights != runs) apart++, where = maximum_principle_h(k);
    }
    measures_judge(m, apart, lo, hi);
    words_add(m->reason, sizeof m->reason, " (kept at %.0f values of h/dx, %.0f refused)", kept, refused);
    if (apart > 0) words_add(m->reason, sizeof m->reason, "; they disagree at h/dx = %.4g", where);
}

void measures_refusal(const struct command *r, double lo, double hi, struct measured *m) {
    struct result result;
    int status = run_experiment(&r->experiment, &result, NULL);
    const char *text = result.failure.text;
    if (!status) text = "a field was given back";
    measures_judge(m, status_exit(status), lo, hi);
    snprintf(m->reason, sizeof m->reason, "status %d: %.280s", status_exit(status), text);
    if (!strstr(text, "particle") || !strstr(text, "neighbours")) m->verdict = VERDICT_FAIL;
}

void measures_endurance(const struct command *r, double lo, double hi, struct measured *m) {
    const long long steps = 10000000;
    struct model_problem b;
    struct step_limit l;
    struct long_run e;
    struct failure why = {0};
    if (find(r, &b, &l, 0, m)) return;
    int status = long_run_measure(&b, 0.999 * l.von_neumann, steps, &e, &why);
    measures_fail(m, &why);
    if (status) return;
    measures_judge(m, fabs(e.drift) / ((double)steps * DBL_EPSILON), lo, hi);
    words_add(m->reason, sizeof m->reason, " (drift %.3g, max T %.15g K, which rose by at most %.3g K)", e.drift,
              e.largest, e.rise);
    /* the last digit of a constant rod may flicker, by the rounding of one step */
    if (!(e.rise <= 8 * DBL_EPSILON && e.largest <= 2)) m->verdict = VERDICT_FAIL;
}
