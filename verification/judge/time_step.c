/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Choice of stepper and time step, unless the user sets them.
 *
 * The exact stepper is used if the method has it.  Polynomials in time need no search: the
 * difference of two runs shows how small their error is.
 *
 * The finite differences take rkl2 in a box.  On a mode that decays as exp(-lambda t), lambda = sum of kappa_a k_a^2,
 * the relative errors at the end are
 *
 *     c t lambda^3 dt^2 / 18 in time, c = 1 + 8/(s^2 + s - 2) <= 1.8, and t sum of kappa_a k_a^4 dx^2 / 12 in space.
 *
 * The sum is at least lambda^2 / sum of kappa_a (Cauchy), so the share of time is at most (2/3) c lambda t (N_0/N)^2
 * with N = t/dt steps and N_0^2 = t sum of kappa_a / dx^2.  If data excite all modes equally, those that make up the
 * errors are near lambda t = 3 in time and 2 in space, the maxima of lambda^3 exp(-lambda t) and lambda^2
 * exp(-lambda t): the ratio of these is 1.66 c (N_0/N)^2.  N = 16 N_0 makes that 0.65 % for many stages, 1.2 % for
 * three, and a single mode up to lambda t = 1.5 stays below 0.5 %.  Sixteen steps at least: rkl2 halves in each what
 * its stages cannot follow.  The run itself then states its time error, from the last steps (field.time_error); only
 * where that is above 1 % of the whole, as for data that change fast, another run follows.
 *
 * Otherwise the time step is refined until its error is shown to be small.  A run of N steps by a stepper of order p
 * has the time error C e, e = c / N^p, with c = 1, or as above for rkl2 (unit/test_ceiling.c).  Two runs then give
 *
 *     T_inf = T_2 + (T_2 - T_1) e_2 / (e_1 - e_2)                                                 (Richardson 1911)
 *
 * without time error, and the difference of a run from T_inf is its time error.  Two cheap runs predict the N at
 * which it is 1 % of the error of T_inf, and the run at that N is compared with the previous one.
 *
 * Norms are those of E1. */
#include "verification/judge/time_step.h"
#include "solver/particles/particles.h"
#include "solver/time/stepper.h"

#include "references/scene.h"
#include "verification/solve/symmetry.h"
#include "verification/judge/norms.h"
#include "verification/case/experiment.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double SHARE = 0.01, MARGIN = 0.8; /* the target of 0.8 % tolerates an inaccurate prediction */
/* Fourier number of the first run, divided by the dimension: stable for every method (rkl2 at any value). */
static const double FOURIER = 0.2;
static const double FLOOR = 1e-12;                     /* rounding level of E1, below which no time error is sought */
enum { HALVINGS = 8, LATER_HALVINGS = 2, ROUNDS = 5 }; /* later: for another number of rkl2's stages */

struct trial {
    struct field field;
    double steps;
};

struct search {
    const struct experiment *e;
    int order;
    double *exact;             /* K, at the points of the fields */
    struct trial coarse, fine; /* the last two runs */
    long long updates;         /* total of all runs */
};

static int try_steps(struct search *s, double steps, struct trial *t, struct failure *why) {
    struct options with = s->e->options;
    with.dt = s->e->problem.t_end / steps;
    with.fourier = 0;
    t->steps = steps;
    int status = symmetry_solve(s->e->method, &s->e->problem, &with, &t->field, why);
    if (!status) s->updates += t->field.cost.updates;
    return status;
}

static int order_of(const struct options *o) {
    const struct stepper *s = stepper_of(o->stepper);
    return s && s->order > 0 ? s->order : 2;
}

static double first_steps(const struct experiment *e) {
    const struct options *o = &e->options;
    double steps = e->problem.t_end * problem_diffusivity(&e->problem) / (FOURIER / e->problem.dim * o->dx * o->dx);
    if (stepper_of(o->stepper)->count) steps = sqrt(steps) / 2; /* about ten stages per step */
    return fmax(1, ceil(steps));
}

/* 16 N_0, for the finite differences in a box */
static double known_steps(const struct experiment *e) {
    const double rate = e->problem.dim * problem_diffusivity(&e->problem) / (e->options.dx * e->options.dx);
    return fmax(16, ceil(16 * sqrt(e->problem.t_end * rate)));
}

/* A run of that many steps; the time step is halved, at most `halvings` times, while it is unstable. */
static int try_stable(struct search *s, double steps, int halvings, struct trial *t, struct failure *why) {
    int status = try_steps(s, steps, t, why);
    for (int i = 0; i < halvings && status == STATUS_UNSTABLE; i++) status = try_steps(s, steps *= 2, t, why);
    return status;
}

/* Relative to sum w|Te|: the time error of `fine`, its total error, and the error of the field without time
 * error. */
struct estimate {
    double time, whole, space;
};

/* Next number of steps from the estimate for `steps`; unchanged if the time error is small enough. */
static double next_steps(double steps, struct estimate e, double particles, int order) {
    if (e.time <= SHARE * e.whole || e.time <= FLOOR) return steps;
    double more = ceil(steps * fmax(1.1, pow(e.time / (MARGIN * SHARE * e.space), 1.0 / order)));
    return more * particles * order <= TIME_STEP_UPDATES_MAX ? more : steps;
}

static double size_of(const struct search *s, const struct trial *t) { /* e */
    const struct stepper *stepper = stepper_of(s->e->options.stepper);
    return (stepper->error ? stepper->error(t->field.stages) : 1) / pow(t->steps, s->order);
}

/* T_inf; the caller frees it.  If RKL2's stages compensate for the steps, the extrapolation is ill-conditioned; the
 * runs are then assumed to differ by a fifth of the finer one's error. */
static double *find_limit(const struct search *s) {
    size_t n = s->fine.field.n;
    double coarse = size_of(s, &s->coarse), fine = size_of(s, &s->fine), *limit = xcalloc(n, sizeof *limit);
    double ratio = fine / fmax(coarse - fine, 0.2 * fine);
    const double *T = s->fine.field.T, *before = s->coarse.field.T;
    for (size_t i = 0; i < n; i++) limit[i] = T[i] + ratio * (T[i] - before[i]);
    return limit;
}

static double whole_error(const struct search *s, const struct field *f) {
    return norms_l1(f, s->exact, NULL);
}

static struct estimate compare(const struct search *s) {
    double *limit = find_limit(s);
    struct field at_limit = s->fine.field;
    at_limit.T = limit;
    struct estimate e = {field_distance(&s->fine.field, limit, s->exact), whole_error(s, &s->fine.field),
                         whole_error(s, &at_limit)};
    free(limit);
    return e;
}

/* The finer trial becomes the coarser one, and a run of `steps` steps replaces it. */
static int replace(struct search *s, double steps, struct failure *why) {
    field_free(&s->coarse.field);
    s->coarse = s->fine;
    s->fine = (struct trial){0};
    return try_stable(s, steps, LATER_HALVINGS, &s->fine, why);
}

/* Refines until the time error is small; *time_error is its share. */
static int refine(struct search *s, double *time_error, struct failure *why) {
    int status = STATUS_OK;
    for (int round = 0; round < ROUNDS && !status; round++) {
        struct estimate e = compare(s);
        *time_error = e.time / e.whole;
        double steps = next_steps(s->fine.steps, e, (double)s->fine.field.n, s->order);
        if (steps == s->fine.steps) break;
        status = replace(s, steps, why);
    }
    return status;
}

/* Memory besides a run during the search for its time step: the previous run, and the exact temperatures unless
 * polynomials are used. */
static size_t search_bytes(const struct experiment *e, const struct field *f) {
    return field_bytes(f) + (stepper_of(e->options.stepper)->order == 0 ? 0 : f->n * sizeof *f->T);
}

static int solve_searched(const struct experiment *e, struct field *f, struct time_step *stepping,
                          struct failure *why) {
    struct search s = {.e = e, .order = order_of(&e->options)};
    int status = try_stable(&s, first_steps(e), HALVINGS, &s.coarse, why);
    if (status) return status;
    s.exact = xcalloc(s.coarse.field.n, sizeof *s.exact);
    norms_exact(e->scene, &e->problem, &s.coarse.field, s.exact);
    status = norms_check(&s.coarse.field, s.exact, why);
    if (!status) status = try_stable(&s, 2 * s.coarse.steps, LATER_HALVINGS, &s.fine, why);
    if (!status) status = refine(&s, &stepping->time_error, why);
    free(s.exact);
    field_free(&s.coarse.field);
    if (status) {
        field_free(&s.fine.field);
        return status;
    }
    *f = s.fine.field;
    f->cost.bytes += search_bytes(e, f);
    stepping->updates = s.updates - f->cost.updates;
    return STATUS_OK;
}

/* Every q-th point, some ten thousand of them at most: enough for a mean. */
static struct field thinned(const struct field *f) {
    enum { ENOUGH = 8192 };
    const size_t q = (f->n / ENOUGH) | 1;
    struct field part;
    field_alloc(&part, f->dim, (f->n + q - 1) / q);
    part.time = f->time;
    if (f->weight) part.weight = xcalloc(part.n, sizeof *part.weight);
    for (size_t k = 0; k < part.n; k++) {
        double x[DIM_MAX];
        field_put(&part, k, field_place(f, k * q, x));
        part.T[k] = f->T[k * q];
        if (f->weight) part.weight[k] = f->weight[k * q];
    }
    return part;
}

/* The share in E1 of the time error that a field states. */
static int find_share(const struct experiment *e, const struct field *f, struct estimate *share,
                      struct failure *why) {
    struct field part = thinned(f);
    double *exact = xcalloc(part.n, sizeof *exact);
    norms_exact(e->scene, &e->problem, &part, exact);
    int status = norms_check(&part, exact, why);
    if (!status) {
        double volume = 0, size = 0;
        for (size_t k = 0; k < part.n; k++) {
            const double w = part.weight ? part.weight[k] : 1;
            if (exact[k] != NORMS_NO_VALUE) volume += w, size += w * fabs(exact[k]);
        }
        share->whole = share->space = norms_l1(&part, exact, NULL);
        share->time = f->time_error * volume / size;
    }
    free(exact);
    field_free(&part);
    return status;
}

/* One run, or another where the error that it states is not small. */
static int solve_estimated(const struct experiment *e, struct field *f, struct time_step *stepping,
                           struct failure *why) {
    struct search s = {.e = e, .order = order_of(&e->options)};
    struct estimate share;
    int status = try_stable(&s, known_steps(e), HALVINGS, &s.fine, why);
    if (status) return status;
    for (int round = 0; round < ROUNDS; round++) {
        status = find_share(e, &s.fine.field, &share, why);
        if (status) break;
        stepping->time_error = share.time / share.whole;
        const double steps = next_steps(s.fine.steps, share, (double)s.fine.field.n, s.order);
        if (steps == s.fine.steps) break;
        field_free(&s.fine.field);
        status = try_stable(&s, steps, LATER_HALVINGS, &s.fine, why);
        if (status) break;
    }
    if (status) {
        field_free(&s.fine.field);
        return status;
    }
    *f = s.fine.field;
    stepping->updates = s.updates - f->cost.updates;
    return STATUS_OK;
}

static int solve_by_polynomials(const struct experiment *e, struct field *f, struct time_step *stepping,
                                struct failure *why) {
    struct semidiscrete s;
    int status = semidiscrete_polynomials(e, &s, why);
    if (status) return status;
    double *exact = xcalloc(s.field.n, sizeof *exact);
    norms_exact(e->scene, &e->problem, &s.field, exact);
    *f = s.field;
    stepping->time_error = s.error / norms_l1(f, exact, NULL);
    stepping->updates = s.updates;
    f->cost.bytes += search_bytes(e, f);
    free(exact);
    return STATUS_OK;
}

/* Possible share of the exact stepper's transforms in E1.  The error of a transform of n values, with sines and
 * cosines to one ulp, is at most 3.4 eps log2(n) of its 2-norm (Higham 2002, theorem 24.2), for 2 n by symmetry;
 * there are two along each axis.  The relative error of the eigenvalues is a few eps, which a mode multiplies by |z|
 * exp(z): less than one further level.  Modes of a Robin wall are plain sums of n.  E1 is relative to the mean, not
 * to the root mean square. */
static double transform_rounding(const struct problem *p, const struct field *f, double dx) {
    double levels = 1, sum = 0, square = 0;
    for (int a = 0; a < p->dim; a++) {
        double n = (p->hi[a] - p->lo[a]) / dx;
        int robin = p->side[2 * a] == ROBIN || p->side[2 * a + 1] == ROBIN;
        levels += robin ? n : log2(2 * n);
    }
    for (size_t i = 0; i < f->n; i++) sum += fabs(f->T[i]), square += f->T[i] * f->T[i];
    return 6.8 * DBL_EPSILON * levels * (sum > 0 ? sqrt((double)f->n * square) / sum : 1);
}

double time_step_weights(const struct experiment *e) {
    const struct problem *p = &e->problem;
    return 4 * p->dim * problem_diffusivity(p) * p->t_end / (e->options.dx * e->options.dx);
}

/* Rounding error of E1: that of the weights, plus eps sqrt(applications), since each application rounds T
 * randomly. */
static double rounding(const struct experiment *e, const struct field *f) {
    if (f->steps == 0) return DBL_EPSILON + transform_rounding(&e->problem, f, e->options.dx);
    double applications = (double)f->steps * (f->stages > 0 ? f->stages : 1);
    return DBL_EPSILON * (1 + sqrt(applications) + time_step_weights(e));
}

static int solve(struct experiment *e, struct field *f, struct time_step *stepping, struct failure *why) {
    struct options *o = &e->options;
    int given = o->dt > 0 || o->fourier > 0 || e->problem.t_end <= 0, particles = e->method->scheme != NULL;
    const enum stepper_name given_stepper = o->stepper;
    const int melts = e->problem.k_law == K_PHASES; /* the front's cell leaves more than steps, and no order in dt */
    if (o->stepper == STEPPER_AUTO) {
        o->stepper = stepper_auto(particles, o->dt > 0 || o->fourier > 0, 1);
        int open = stepper_of(o->stepper)->evolve != NULL;
        int status = open ? symmetry_solve(e->method, &e->problem, o, f, why) : STATUS_NOT_APPLICABLE;
        if (status == STATUS_OK) stepping->time_error = 0;
        if (status != STATUS_NOT_APPLICABLE) return status;
        if (open) o->stepper = stepper_auto(particles, 0, 0);
        if (!particles && !given && !e->problem.shape && !melts) o->stepper = STEPPER_RKL2;
    }
    if (melts && o->stepper != given_stepper) o->stepper = STEPPER_EULER;
    const struct stepper *stepper = stepper_of(o->stepper);
    if (stepper->evolve) stepping->time_error = 0;
    if (o->stepper == stepper_without_error(0) && !given) return solve_by_polynomials(e, f, stepping, why);
    if (given || melts || stepper->order == 0) return symmetry_solve(e->method, &e->problem, o, f, why);
    return !particles && o->stepper == STEPPER_RKL2 ? solve_estimated(e, f, stepping, why)
                                                    : solve_searched(e, f, stepping, why);
}

int time_step_solve(struct experiment *e, struct field *f, struct time_step *stepping, struct failure *why) {
    *stepping = (struct time_step){.time_error = NAN};
    int status = solve(e, f, stepping, why);
    if (!status) stepping->rounding = rounding(e, f);
    return status;
}

/* ---- The reference of a ladder in time ---- */

/* The reference of a ladder in time: T(t_end) of dT/dt = A T + g, with the same A and g as in the rungs.
 *
 * If a transform diagonalises A, the exact stepper gives it.  Otherwise (jitter, two materials, fixed walls) it is
 * exp(tA) by Chebyshev polynomials (solver/time/chebyshev.c), which share only the operator with the rungs' steppers
 * and have no time error for a real spectrum.
 *
 * This is checked, here and when a user requests them: runs of N and of N/2 steps are polynomials of different
 * degree and differ if an eigenvalue off the axis makes them wrong.  N is doubled until the run is stable and both
 * agree.  The remaining difference is the reference's own error, by which the ladder's window excludes rungs. */

static const double AGREE = 1e-9; /* relative to sum |T|: ten times the rounding error of the longest step */
enum { STEPS_MAX = 256 };

static int march(const struct experiment *e, long long steps, struct field *f, struct failure *why) {
    struct options with = e->options;
    with.stepper = stepper_without_error(0);
    with.dt = e->problem.t_end / (double)steps;
    with.fourier = 0;
    return symmetry_solve(e->method, &e->problem, &with, f, why);
}

int semidiscrete_polynomials(const struct experiment *e, struct semidiscrete *s, struct failure *why) {
    struct field finer;
    int status = STATUS_UNSTABLE;
    *s = (struct semidiscrete){0};
    for (long long steps = 1; steps <= STEPS_MAX && status == STATUS_UNSTABLE; steps *= 2)
        status = march(e, steps, &s->field, why);
    if (status) return status;
    do {
        if ((status = march(e, 2 * s->field.steps, &finer, why))) break;
        s->error = field_distance(&finer, s->field.T, finer.T);
        s->updates += s->field.cost.updates;
        field_free(&s->field);
        s->field = finer, s->steps = finer.steps;
    } while (s->error > AGREE && s->steps < STEPS_MAX);
    if (status) field_free(&s->field);
    return status;
}

int semidiscrete_solve(const struct experiment *e, struct semidiscrete *s, struct failure *why) {
    struct experiment own = *e;
    struct options exact = e->options;
    struct assembled rows = {0};
    *s = (struct semidiscrete){0};
    if (!e->method->scheme)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "a ladder in time needs the particles' equations for its reference, which %s does not have",
                      e->method->name);
    exact.stepper = stepper_without_error(1);
    exact.dt = exact.fourier = 0;
    int status = method_solve(e->method, &e->problem, &exact, &s->field, why);
    if (status != STATUS_NOT_APPLICABLE) return status;
    own.options.assembled = &rows;
    status = semidiscrete_polynomials(&own, s, why);
    particles_free_assembled(&rows);
    if (status != STATUS_UNSTABLE) return status;
    struct failure unstable = *why;
    return refuse(why, status, "no semi-discrete reference: %.400s", unstable.text);
}
