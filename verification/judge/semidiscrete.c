/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reference of a ladder in time: T(t_end) of dT/dt = A T + g, with the same A and g as in the rungs.
 *
 * If a transform diagonalises A, the exact stepper gives it.  Otherwise (jitter, two materials, fixed walls) it is
 * exp(tA) by Chebyshev polynomials (solver/time/chebyshev.c), which share only the operator with the rungs' steppers
 * and have no time error for a real spectrum.
 *
 * This is checked, here and when a user requests them: runs of N and of N/2 steps are polynomials of different
 * degree and differ if an eigenvalue off the axis makes them wrong.  N is doubled until the run is stable and both
 * agree.  The remaining difference is the reference's own error, by which the ladder's window excludes rungs. */
#include "verification/judge/semidiscrete.h"

#include "solver/time/stepper.h"
#include "verification/case/experiment.h"
#include "verification/solve/symmetry.h"

static const double AGREE = 1e-9; /* relative to sum |T|: ten times the rounding error of the longest step */
enum { STEPS_MAX = 256 };

static int march(const struct experiment *e, long long steps, const struct field *placed, struct field *f,
                 struct failure *why) {
    struct options with = e->options;
    with.stepper = stepper_without_error(0);
    with.dt = e->problem.t_end / (double)steps;
    with.fourier = 0;
    if (placed) with.placed = placed;
    return symmetry_solve(e->method, &e->problem, &with, f, why);
}

int semidiscrete_polynomials(const struct experiment *e, struct semidiscrete *s, struct failure *why) {
    struct field finer;
    int status = STATUS_UNSTABLE;
    *s = (struct semidiscrete){0};
    for (long long steps = 1; steps <= STEPS_MAX && status == STATUS_UNSTABLE; steps *= 2)
        status = march(e, steps, NULL, &s->field, why);
    if (status) return status;
    do {
        if ((status = march(e, 2 * s->field.steps, &s->field, &finer, why))) break;
        s->error = field_distance(&finer, s->field.T, finer.T);
        s->updates += s->field.cost.updates;
        field_free(&s->field);
        s->field = finer, s->steps = finer.steps;
    } while (s->error > AGREE && s->steps < STEPS_MAX);
    if (status) field_free(&s->field);
    return status;
}

int semidiscrete_solve(const struct experiment *e, struct semidiscrete *s, struct failure *why) {
    struct options exact = e->options;
    *s = (struct semidiscrete){0};
    if (!e->method->scheme)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "a ladder in time needs the particles' equations for its reference, which %s does not have",
                      e->method->name);
    exact.stepper = stepper_without_error(1);
    exact.dt = exact.fourier = 0;
    int status = method_solve(e->method, &e->problem, &exact, &s->field, why);
    if (status != STATUS_NOT_APPLICABLE) return status;
    status = semidiscrete_polynomials(e, s, why);
    if (status != STATUS_UNSTABLE) return status;
    struct failure unstable = *why;
    return refuse(why, status, "no semi-discrete reference: %.400s", unstable.text);
}
