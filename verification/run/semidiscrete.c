/* The reference of a ladder in time: T(t_end) of dT/dt = A T + g, whose A and g are those of the rungs.
 *
 * Where A is diagonal under a transform, the exact stepper has it.  Elsewhere (jitter, two materials, fixed walls) it
 * is the midpoint rule's, which shares with super time stepping the operator alone.  It is stable for dt <= 2/bound
 * and wrong by dt^2/6 |A^3 T| t, where rkl2 is wrong by dt^2/18 or more (gates/time.def).
 * With M steps to the finest rung's one it makes up 3/M^2 of that rung's error: 0.9 % for M = 18.
 *
 * That is measured, not trusted: a run of N steps of the size 1/bound and the reference's own of M > N differ by
 * C (1/N^2 - 1/M^2), so the reference is wrong by |T_N - T_M| / ((M/N)^2 - 1) (Richardson 1911).  The ladder's window
 * leaves out each rung of whose error this is too large a part. */
#include "verification/run/semidiscrete.h"

#include "verification/run/experiment.h"

#include <math.h>

static const double FINER = 18; /* steps of the reference to one of the finest rung */

static int march(const struct experiment *e, double steps, struct field *f, struct failure *why) {
    struct options with = e->options;
    with.stepper = STEPPER_RK2;
    with.dt = steps > 0 ? e->problem.t_end / steps : 0; /* 0: 1/bound */
    with.fourier = 0;
    return e->method->solve(&e->problem, &with, f, why);
}

static int midpoint(const struct experiment *e, struct semidiscrete *s, struct failure *why) {
    const struct options *o = &e->options;
    struct field coarse;
    double dt = o->dt > 0 ? o->dt : o->fourier * o->dx * o->dx / problem_diffusivity(&e->problem);
    int status = march(e, 0, &coarse, why);
    if (status == STATUS_UNSTABLE) {
        struct failure unstable = *why;
        return refuse(why, status, "no semi-discrete reference: %.400s", unstable.text);
    }
    if (status) return status;
    double N = (double)coarse.steps;
    status = march(e, fmax(2 * N, ceil(FINER * e->problem.t_end / dt)), &s->field, why);
    if (!status) {
        double ratio = (double)s->field.steps / N;
        s->steps = s->field.steps;
        s->error = field_distance(&s->field, coarse.T, s->field.T) / (ratio * ratio - 1);
    }
    field_free(&coarse);
    return status;
}

int semidiscrete_solve(const struct experiment *e, struct semidiscrete *s, struct failure *why) {
    struct options exact = e->options;
    *s = (struct semidiscrete){0};
    if (!e->method->scheme)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "a ladder in time needs the particles' equations for its reference, which %s does not have",
                      e->method->name);
    exact.stepper = STEPPER_EXACT;
    exact.dt = exact.fourier = 0;
    int status = e->method->solve(&e->problem, &exact, &s->field, why);
    return status == STATUS_NOT_APPLICABLE ? midpoint(e, s, why) : status;
}
