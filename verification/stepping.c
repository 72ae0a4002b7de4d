/* Which stepper, and which time step, where the user leaves that open.
 *
 * The exact stepper where the method has it.  Else the time step is refined until its error is shown to be small.
 * With a stepper of order p, a run of N steps and one of M > N steps give fields that differ by C (1/N^p - 1/M^p), so
 * that
 *
 *     e(M) = |T_N - T_M| / ((M/N)^p - 1),   T_inf = T_M + (T_M - T_N) / ((M/N)^p - 1)          (Richardson 1911)
 *
 * are the time error of the finer one and the field without any.  Two cheap runs give both; they foretell the M at
 * which e(M) is 1 % of the error of T_inf, and the run at that M is measured against the one before.
 *
 * For --time-error the steps are halved until e(2 N) is what is asked for; then the longest step is looked for: a run
 * of fewer steps is measured against T_inf.  Norms are E1's. */
#include "verification/stepping.h"

#include "references/scene.h"
#include "verification/external.h"
#include "verification/fold.h"
#include "verification/norms.h"
#include "verification/request.h"

#include <math.h>
#include <stdlib.h>

static const double SHARE = 0.01, MARGIN = 0.8; /* aims at 0.8 % so that a slightly wrong forecast still holds */
static const double FOURIER =
    0.2; /* of the first run, over the dimension: stable for every method but rkl2, which is so at any */
static const double FLOOR = 1e-12; /* of E1: what rounding leaves; no time error below it is looked for */
enum { HALVINGS = 8, ROUNDS = 5 };

struct trial {
    struct field field;
    double steps;
};

static int solve(const struct request *r, const struct options *o, struct field *f, struct failure *why) {
    return fold_solve(r->method, &r->problem, o, f, why);
}

static int try_steps(const struct request *r, const struct options *o, double steps, struct trial *t,
                     struct failure *why) {
    struct options with = *o;
    with.dt = r->problem.t_end / steps;
    with.fourier = 0;
    t->steps = steps;
    return solve(r, &with, &t->field, why);
}

static int order_of(const struct options *o) {
    return o->stepper == STEPPER_EULER ? 1 : 2;
}

static double first_steps(const struct request *r, const struct options *o) {
    double kappa = 0;
    for (int m = 0; m < r->problem.materials; m++)
        for (int a = 0; a < r->problem.dim; a++)
            kappa = fmax(kappa, r->problem.material[m].k[a] / r->problem.material[m].rho_c);
    double steps = r->problem.t_end * kappa / (FOURIER / r->problem.dim * o->dx * o->dx);
    if (o->stepper == STEPPER_RKL2) steps = r->time_error > 0 ? 2 : sqrt(steps) / 2; /* some ten stages a step */
    return fmax(1, ceil(steps));
}

/* The first run, at half the time step again and again while that is unstable. */
static int first(const struct request *r, const struct options *o, struct trial *t, struct failure *why) {
    double steps = first_steps(r, o);
    int status = try_steps(r, o, steps, t, why);
    for (int i = 0; i < HALVINGS && status == STATUS_NUMERICAL; i++) status = try_steps(r, o, steps *= 2, t, why);
    return status;
}

/* All relative to sum w|Te|: the time error of `fine`, its whole error, and the error of the field without time
 * error. */
struct estimate {
    double time, whole, space;
};

static int within_reach(double steps, double particles, int order) {
    return steps * particles * order <= STEPPING_UPDATES_MAX;
}

/* How many steps follow `steps`, which led to the estimate: as many where that will do. */
static double next_steps(double steps, struct estimate e, double particles, int order) {
    if (e.time <= SHARE * e.whole || e.time <= FLOOR) return steps;
    double more = ceil(steps * fmax(1.1, pow(e.time / (MARGIN * SHARE * e.space), 1.0 / order)));
    return within_reach(more, particles, order) ? more : steps;
}

/* T_inf from two runs. */
static double *find_limit(const struct trial *coarse, const struct trial *fine, int order) {
    size_t n = fine->field.n;
    double gain = 1 / (pow(fine->steps / coarse->steps, order) - 1), *limit = xcalloc(n, sizeof *limit);
    for (size_t i = 0; i < n; i++) limit[i] = fine->field.T[i] + gain * (fine->field.T[i] - coarse->field.T[i]);
    return limit;
}

static double distance(const struct field *f, const double *limit, const double *exact) {
    double apart = 0, size = 0;
    for (size_t i = 0; i < f->n; i++) {
        double w = f->weight ? f->weight[i] : 1;
        apart += w * fabs(limit[i] - f->T[i]);
        size += w * fabs(exact[i]);
    }
    return apart / size;
}

static double whole_error(const struct request *r, const struct field *f, const double *exact) {
    return norms_error(&r->problem, f, exact, NORMS_ALL, 0).l1;
}

static struct estimate compare(const struct request *r, const struct trial *coarse, const struct trial *fine,
                               const double *exact, int order) {
    double *limit = find_limit(coarse, fine, order);
    struct field at_limit = fine->field;
    at_limit.T = limit;
    struct estimate e = {distance(&fine->field, limit, exact), whole_error(r, &fine->field, exact),
                         whole_error(r, &at_limit, exact)};
    free(limit);
    return e;
}

/* `steps` steps in the place of the coarser of two trials, which then is the finer one. */
static int replace(const struct request *r, const struct options *o, double steps, struct trial *coarse,
                   struct trial *fine, struct failure *why) {
    field_free(&coarse->field);
    *coarse = *fine;
    *fine = (struct trial){0};
    return try_steps(r, o, steps, fine, why);
}

/* Refines `fine` until its time error is small; *time_error is its share. */
static int refine(const struct request *r, const struct options *o, int order, const double *exact,
                  struct trial *coarse, struct trial *fine, double *time_error, struct failure *why) {
    int status = STATUS_OK;
    for (int round = 0; round < ROUNDS && !status; round++) {
        struct estimate e = compare(r, coarse, fine, exact, order);
        *time_error = e.time / e.whole;
        double steps = next_steps(fine->steps, e, (double)fine->field.n, order);
        if (steps == fine->steps) break;
        status = replace(r, o, steps, coarse, fine, why);
    }
    return status;
}

/* Fewer steps in the place of `fine`, whose time error is `time`, where r->time_error allows. */
static void coarsen(const struct request *r, const struct options *o, int order, const double *exact, double time,
                    struct trial *coarse, struct trial *fine, double *time_error) {
    double *limit = find_limit(coarse, fine, order), steps = fine->steps * pow(time / r->time_error, 1.0 / order);
    struct failure ignored;
    *time_error = time / whole_error(r, &fine->field, exact);
    for (double more = 1; more * steps < 0.98 * fine->steps; more *= 1.05) {
        struct trial t = {0};
        if (try_steps(r, o, ceil(more * steps), &t, &ignored)) continue; /* unstable */
        double error = distance(&t.field, limit, exact);
        if (error <= r->time_error) {
            *time_error = error / whole_error(r, &t.field, exact);
            field_free(&fine->field);
            *fine = t;
            break;
        }
        field_free(&t.field);
    }
    free(limit);
}

/* Halves the step until the time error is what is asked for. */
static int reach(const struct request *r, const struct options *o, int order, const double *exact,
                 struct trial *coarse, struct trial *fine, double *time_error, struct failure *why) {
    double asked = r->time_error, time = compare(r, coarse, fine, exact, order).time;
    while (!(time <= asked)) {
        if (!within_reach(2 * fine->steps, (double)fine->field.n, order))
            return fail(why, STATUS_GATE,
                        "--time-error %g: %g after %.0f steps, and twice as many are past %g updates", asked, time,
                        fine->steps, STEPPING_UPDATES_MAX);
        int status = replace(r, o, 2 * fine->steps, coarse, fine, why);
        if (status) return status;
        time = compare(r, coarse, fine, exact, order).time;
    }
    coarsen(r, o, order, exact, time, coarse, fine, time_error);
    return STATUS_OK;
}

static int solve_refined(const struct request *r, const struct options *o, struct field *f, double *time_error,
                         struct failure *why) {
    struct trial coarse = {0}, fine = {0};
    int order = order_of(o);
    int status = first(r, o, &coarse, why);
    if (status) return status;
    double *exact = xcalloc(coarse.field.n, sizeof *exact);
    norms_exact(r->scene, &r->problem, &coarse.field, exact);
    status = try_steps(r, o, 2 * coarse.steps, &fine, why);
    if (!status) status = (r->time_error > 0 ? reach : refine)(r, o, order, exact, &coarse, &fine, time_error, why);
    free(exact);
    field_free(&coarse.field);
    if (status)
        field_free(&fine.field);
    else
        *f = fine.field;
    return status;
}

double stepping_forecast(const struct request *r, const struct options *o, double particles, double time,
                         double space) {
    int order = order_of(o);
    if (r->time_error > 0) {
        double steps = fmax(1, ceil(pow(time / r->time_error, 1.0 / order)));
        return within_reach(steps, particles, order) ? steps : 0;
    }
    double steps = 2 * first_steps(r, o), at = time / pow(steps, order);
    return next_steps(steps, (struct estimate){at, space + at, space}, particles, order);
}

int stepping_solve(const struct request *r, struct options *o, struct field *f, double *time_error,
                   struct failure *why) {
    int given = o->dt > 0 || o->fourier > 0, particles = r->method->scheme != NULL;
    *time_error = NAN;
    if (r->solver) return external_solve(r, o, f, why); /* its time step is its own */
    if (o->stepper == STEPPER_AUTO && r->time_error > 0 && particles) o->stepper = STEPPER_RKL2;
    if (o->stepper == STEPPER_AUTO && !given && particles) {
        o->stepper = STEPPER_EXACT;
        int status = solve(r, o, f, why);
        if (status == STATUS_OK) *time_error = 0;
        if (status != STATUS_INPUT) return status;
        o->stepper =
            STEPPER_RKL2; /* not on this layout or with these walls: s stages do the work of s^2/4 Euler steps */
    }
    if (o->stepper == STEPPER_AUTO) o->stepper = STEPPER_EULER;
    if (o->stepper == STEPPER_EXACT) *time_error = 0;
    if (given || o->stepper == STEPPER_EXACT || o->stepper == STEPPER_MATCHED || r->problem.t_end <= 0)
        return solve(r, o, f, why);
    return solve_refined(r, o, f, time_error, why);
}
