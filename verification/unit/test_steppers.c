/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steppers on one equation: each row of steppers.def by its own numbers; stages, exponentials, threads. */

#include "solver/time/stepper.h"
#include "verification/case/command.h"
#include "verification/judge/run.h"

#include "verification/unit/near.h"

#include <float.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdlib.h>

/* ---- polynomials ---- */

/* T of dT/dt = heat - rate T after a step_polynomials from T0. */
static double step_polynomials(double dt, double bound, double rate, double heat, double T0) {
    int degree = stepper_of(STEPPER_CHEBYSHEV)->count(dt, bound);
    struct update *u = calloc((size_t)degree, sizeof *u);
    double before = NAN, T = T0;
    assert_non_null(u);
    stepper_of(STEPPER_CHEBYSHEV)->updates(dt, bound, degree, u);
    assert_near(u[0].start, 0, 0);
    assert_near(u[0].old + u[1].old, 0, 0);
    for (int k = 0; k < degree; k++) {
        assert_near(u[k].self + u[k].old + u[k].start, 1, 4e-16 * (1 - u[k].old)); /* a constant stays */
        double old = k < 2 ? 0 : u[k].old * before;
        double next = u[k].rate * (heat - rate * T) + u[k].self * T + old + u[k].start * T0;
        before = T, T = next;
    }
    free(u);
    return T;
}

/* Rounding grows as h^(5/4), h = dt bound/2: all errors of one sign would be h^(3/2) / 6. */
static void chebyshev_step_is_the_exponential(void **state) {
    (void)state;
    const double bound = 7.3;
    for (double z = 1e-7; z < 262144; z *= 2.7) {
        double dt = z / bound, h = z / 2, rounding = 4e-16 * (1 + pow(h, 1.5) / 6);
        for (double part = 0; part <= 1; part += 0.0625) {
            double rate = part * part * bound;
            assert_near(step_polynomials(dt, bound, rate, 0, 1.3), 1.3 * exp(-rate * dt), 3 * rounding);
        }
        /* walls and sources come in: to 2.1 from 1.3 */
        double rate = 0.31 * bound;
        assert_near(step_polynomials(dt, bound, rate, 2.1 * rate, 1.3), 2.1 - 0.8 * exp(-rate * dt), 3 * rounding);
        assert_near(step_polynomials(dt, bound, 0, 0, 1.3), 1.3, 3 * rounding);
    }
}

/* The rest of the series is less than half a rounding error, 2^-53; with an eighth fewer terms it is more. */
static void chebyshev_degree_is_sharp(void **state) {
    (void)state;
    for (double h = 2.5; h < 131072; h *= 3.1) {
        int degree = stepper_of(STEPPER_CHEBYSHEV)->count(2 * h / 7.3, 7.3);
        double rest = 0, more = 0;
        for (int k = degree + 1; k < 5 * degree / 4; k++) rest += 2 * gsl_sf_bessel_In_scaled(k, h);
        for (int k = 7 * degree / 8; k < 5 * degree / 4; k++) more += 2 * gsl_sf_bessel_In_scaled(k, h);
        assert_order(rest, <, ldexp(1, -53));
        assert_order(more, >, ldexp(1, -53));
    }
    assert_near(stepper_of(STEPPER_CHEBYSHEV)->length(0, 1e9, 7.3) * 7.3, 262144, 1e-9);
}

static int march_polynomials(double rate, double time, long long steps, double *T) {
    size_t row[2] = {0, 0}, bytes = 0;
    double diagonal[1] = {-rate};
    struct heat_operator a = {.n = 1, .state = 1, .row = row, .diagonal = diagonal};
    struct march m = {.stepper = STEPPER_CHEBYSHEV, .time = time, .steps = steps, .hi = 2, .bound = 1.7};
    struct failure why;
    m.stages = stepper_of(STEPPER_CHEBYSHEV)->count(time / (double)steps, m.bound);
    return stepper_march(&a, &m, T, &bytes, &why);
}

static void a_march_is_exact_in_any_number_of_steps(void **state) {
    (void)state;
    for (int steps = 1; steps < 50; steps = 3 * steps + 1)
        for (double time = 0.1; time < 300; time *= 7) {
            double T = 1.3;
            assert_int_equal(march_polynomials(0.9, time, steps, &T), STATUS_OK);
            assert_near(T, 1.3 * exp(-0.9 * time), 1e-13);
        }
    double T = 1.3;
    assert_int_equal(march_polynomials(1.9, 90, 1, &T), STATUS_UNSTABLE); /* beyond the bound */
}

/* ---- stages ---- */

static struct result result_of(const char *line) {
    struct command r;
    struct failure why;
    struct result result;
    if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (run_experiment(&r.experiment, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    command_free(&r);
    return result;
}

/* Neighbours within 2.2 dx: 2 on either side; in the plane (1, 0), (1, 1), (2, 0) and their images. */
static void interactions_count_neighbours(void **state) {
    (void)state;
    struct result rod = result_of("run rod-cosine so_ssph --dx 0.05 --stepper euler --fourier 0.2");
    assert_near((double)rod.cost.interactions / (double)rod.cost.updates, 4, 0);
    struct result plane = result_of("run plate brookshaw --dx 0.01 --stepper euler --fourier 0.1");
    assert_near((double)plane.cost.interactions / (double)plane.cost.updates, 12, 0);
}

static void rkl2_stages_meet_the_stability_bound(void **state) {
    (void)state;
    for (int s = 3; s < 1000; s += 2) {
        double z = (s * s + s - 2) / 2.0;
        assert_int_equal(stepper_of(STEPPER_RKL2)->count(z * (1 - 1e-6), 1), s);
        assert_int_equal(stepper_of(STEPPER_RKL2)->count(z * (1 + 1e-6), 1), s + 2);
    }
}

/* A start that jumps takes as first step two damped quarters, dt lambda <= 4/3 (s^2 + 5 s - 6), and a half.  From
 * the stages of the others dt lambda is known between two bounds. */
static void damped_start_meets_its_stability_bounds(void **state) {
    (void)state;
    for (double z = 0.01; z < 1e6; z *= 1.37) {
        int s[2];
        stepper_of(STEPPER_RKL2)->first(z / 7.3, 7.3, s);
        assert_order(s[0], >=, 2);
        assert_order(z, <=, 4.0 / 3 * (s[0] * (s[0] + 5) - 6) * (1 + 1e-8));
        if (s[0] > 2) assert_order(z, >, 4.0 / 3 * ((s[0] - 1) * (s[0] + 4) - 6));
        assert_int_equal(s[1], stepper_of(STEPPER_RKL2)->count(z / 2, 1));
    }
    struct result r = result_of("run rod-step so_ssph --dx 0.02 --stepper rkl2 --dt 0.5 --domain whole");
    long long first = r.cost.updates / (long long)r.particles - (r.steps - 1) * r.stages;
    int least[2], most[2], s = r.stages;
    stepper_of(STEPPER_RKL2)->first(1, ((s - 2) * (s - 1) - 2) / 2.0, least);
    stepper_of(STEPPER_RKL2)->first(1, (s * (s + 1) - 2) / 2.0, most);
    assert_order(s, >, 3);
    assert_order(first, >=, 2 * least[0] + least[1]);
    assert_order(first, <=, 2 * most[0] + most[1]);
}

/* n particles do 8 n updates between two waits. */
static void threads_need_a_minimum_of_work(void **state) {
    (void)state;
    const size_t one = STEPPER_SHARE / 8;
    assert_int_equal(stepper_threads(0, 100 * one), 1);
    assert_int_equal(stepper_threads(4, 2 * one - 1), 1);
    assert_int_equal(stepper_threads(4, 2 * one), 2);
    assert_int_equal(stepper_threads(4, 3 * one), 3);
    assert_int_equal(stepper_threads(4, 100 * one), 4);
}

/* ---- one equation ---- */

static int march(enum stepper_name stepper, int stages, double alternation, double time, int steps, double *T) {
    size_t row[2] = {0, 0}, bytes = 0;
    double diagonal[1] = {-1};
    struct heat_operator a = {.n = 1, .state = 1, .row = row, .diagonal = diagonal};
    struct march m = {
        .stepper = stepper, .time = time, .steps = steps, .alternation = alternation, .stages = stages, .hi = 2};
    struct failure why;
    return stepper_march(&a, &m, T, &bytes, &why);
}

static void steppers_advance_one_equation(void **state) {
    (void)state;
    const double dt = 0.23;
    double T = 1.3, euler = 1, midpoint = 1;
    for (int k = 0; k < 3; k++) euler *= 1 - dt, midpoint *= 1 - dt + dt * dt / 2;
    assert_int_equal(march(STEPPER_EULER, 1, 0, 3 * dt, 3, &T), STATUS_OK);
    assert_near(T, 1.3 * euler, 1e-15);
    T = 1.3;
    assert_int_equal(march(STEPPER_RK2, 2, 0, 3 * dt, 3, &T), STATUS_OK);
    assert_near(T, 1.3 * midpoint, 1e-15);
    T = 1.3; /* a long and a short step */
    assert_int_equal(march(STEPPER_EULER, 1, 0.3, 2 * dt, 2, &T), STATUS_OK);
    assert_near(T, 1.3 * (1 - 1.3 * dt) * (1 - 0.7 * dt), 1e-15);
}

/* ---- every row of steppers.def ---- */

/* The slope of log error over log step between two steps, one half of the other. */
static double order_of(double whole, double half) {
    return log2(fabs(whole / half));
}

/* One step of dt from T0 of dT/dt = f(T, t), by the stages. */
static double step_in_stages(const struct stepper *s, int stages, double (*f)(double T, double t), double T0,
                             double t, double dt) {
    double L0 = f(T0, t), older = T0, newer = T0 + dt * s->stage(stages, 1).rate * L0;
    for (int j = 2; j <= stages; j++) {
        struct stage k = s->stage(stages, j);
        double L = f(newer, t + k.time * dt);
        double next =
            k.newer * newer + k.older * older + (1 - k.newer - k.older) * T0 + dt * k.rate * (L - k.first * L0);
        older = newer, newer = next;
    }
    return newer;
}

static double decay(double T, double t) {
    (void)t;
    return -T;
}

/* T = 1 + sin t from T(0) = 1 */
static double riccati(double T, double t) {
    return cos(t) - (T - 1 - sin(t)) * (T + 1 + sin(t));
}

static double riccati_error(const struct stepper *s, int stages, int steps) {
    const double end = 1, dt = end / steps;
    double T = 1;
    for (int k = 0; k < steps; k++) T = step_in_stages(s, stages, riccati, T, k * dt, dt);
    return T - 1 - sin(end);
}

/* G(z) is exp(z) up to z^(order+1); |G| <= 1 up to the interval, above 1 soon after it; the updates and the stages
 * multiply T by G; T' = f(T, t) has the stated order. */
static void check_stepper(enum stepper_name name, int stages) {
    const struct stepper *s = stepper_of(name);
    const double reach = s->interval(stages), z = 0.02;
    double beyond = 0;
    for (int k = 0; k <= 200; k++) {
        double at = reach * k / 200, G = creal(s->amplification(stages, -at)), T = 1;
        beyond = fmax(beyond, cabs(s->amplification(stages, -reach * (1 + 0.3 * k / 200))));
        if (!(fabs(G) <= 1 + 1e-12)) fail_msg("%s: G = %g at -%g within its interval", s->name, G, at);
        assert_int_equal(march(name, stages, 0, at, 1, &T), STATUS_OK);
        if (!(fabs(T - G) <= 1e-12 * stages)) fail_msg("%s: updates have %.15g, G(-%g) = %.15g", s->name, T, at, G);
        if (!s->stage) continue;
        T = step_in_stages(s, stages, decay, 1, 0, at);
        if (!(fabs(T - G) <= 1e-12 * stages)) fail_msg("%s: stages have %.15g, G(-%g) = %.15g", s->name, T, at, G);
    }
    if (!(beyond > 1)) fail_msg("%s: stable beyond its interval %g", s->name, reach);
    double p = order_of(creal(s->amplification(stages, -z)) - exp(-z),
                        creal(s->amplification(stages, -z / 2)) - exp(-z / 2));
    if (fabs(p - s->order - 1) > 0.1) fail_msg("%s: G - exp(z) has order %g", s->name, p);
    if (!s->stage) return;
    p = order_of(riccati_error(s, stages, 40), riccati_error(s, stages, 80));
    if (fabs(p - s->order) > 0.1) fail_msg("%s: order %g with a right-hand side that is not linear", s->name, p);
}

static void every_row_has_its_order_and_its_interval(void **state) {
    (void)state;
    int tried = 0;
    for (int name = STEPPER_AUTO + 1; stepper_words[name]; name++) {
        const struct stepper *s = stepper_of((enum stepper_name)name);
        if (!s->amplification || s->order == 0) continue;
        /* data that change within a step: degree p - 1 for order p */
        if ((s->degree ? s->degree : 1) < s->order - 1) fail_msg("%s: degree %d", s->name, s->degree);
        for (int stages = s->stages ? s->stages : 3; stages <= (s->stages ? s->stages : 15); stages += 6) {
            struct update u[15] = {0};
            s->updates(0.1, 1, stages, u);
            if (s->arrays == 3) assert_near(u[0].old + u[1].old, 0, 0); /* no state before Y0 */
            check_stepper((enum stepper_name)name, stages);
        }
        tried++;
    }
    assert_order(tried, >=, 3);
}

static void nan_is_reported_as_unstable(void **state) {
    (void)state;
    double T = NAN;
    assert_int_equal(march(STEPPER_EULER, 1, 0, 0.1, 1, &T), STATUS_UNSTABLE);
    T = 1e300; /* out of bounds, though it is finite */
    assert_int_equal(march(STEPPER_EULER, 1, 0, 0.1, 1, &T), STATUS_UNSTABLE);
}

/* With many stages a step is that of infinitely many, to 8/s^2 of its third-order term. */
static void stages_may_be_many(void **state) {
    (void)state;
    double many = 1.3, more = 1.3;
    assert_int_equal(march(STEPPER_RKL2, 9999, 0, 0.7, 2, &many), STATUS_OK);
    assert_int_equal(march(STEPPER_RKL2, 60001, 0, 0.7, 2, &more), STATUS_OK);
    assert_near(more, many, 1e-8);
    assert_near(more / 1.3, exp(-0.7), 2 * 0.35 * 0.35 * 0.35 / 18);
    assert_int_equal(stepper_of(STEPPER_RKL2)->count(1e12, 1e12), STEPPER_STAGES_MAX + 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chebyshev_step_is_the_exponential),
        cmocka_unit_test(chebyshev_degree_is_sharp),
        cmocka_unit_test(a_march_is_exact_in_any_number_of_steps),
        cmocka_unit_test(threads_need_a_minimum_of_work),
        cmocka_unit_test(interactions_count_neighbours),
        cmocka_unit_test(rkl2_stages_meet_the_stability_bound),
        cmocka_unit_test(damped_start_meets_its_stability_bounds),
        cmocka_unit_test(steppers_advance_one_equation),
        cmocka_unit_test(every_row_has_its_order_and_its_interval),
        cmocka_unit_test(nan_is_reported_as_unstable),
        cmocka_unit_test(stages_may_be_many),
    };
    return cmocka_run_group_tests_name("steppers", tests, NULL, NULL);
}
