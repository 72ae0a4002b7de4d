/* SPDX-License-Identifier: GPL-3.0-or-later */
/* choose: what it promises it keeps, at parameters that nobody tuned for, twice alike; and it says so where it
 * cannot. */
#include "verification/choose/choose.h"

#include "verification/command/arguments.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int choose_within(const char *line, double error, double work, struct choose *c, struct failure *why) {
    struct request r;
    if (arguments_parse_line(line, &r, why)) fail_msg("%s", why->text);
    int status = choose_run(&r.experiment, error, work, c, why);
    arguments_free(&r);
    return status;
}

static int choose(const char *line, double error, struct choose *c, struct failure *why) {
    return choose_within(line, error, choose_work_max, c, why);
}

static void keeps(const char *line, double error) {
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    if (choose(line, error, c, &why)) fail_msg("%s: %s", line, why.text);
    assert_true(c->reached && c->proof.error.l1 <= error);
    assert_order(c->best.predicted_error, <=, error);
    assert_order(c->proof.error.l1, >, 0.5 * c->best.predicted_error);
    assert_order(c->proof.error.l1, <, 2 * c->best.predicted_error);
    assert_near(c->proof.cost.work, c->best.predicted_work, 0); /* told by the plan of that very run */
    for (int i = 1; i < c->count; i++) assert_true(!(c->one[i].predicted_work < c->one[0].predicted_work));
    free(c);
}

static void the_error_is_reached(void **state) {
    (void)state;
    keeps("reference rod-step --at 0 --time 1", 1e-3);
    keeps("reference rod-step --at 0 --time 1 --set kappa=0.017 --set a=0.37 --set T0=3", 1e-5);
    keeps("reference rod-gauss --at 0 --time 1 --set kappa=0.1", 1e-6);
    keeps("reference rod-contact --at 0 --time 1", 1e-3);
    keeps("reference square-step --at 0,0 --time 1 --set a=0.437", 3e-4);
    keeps("reference rect-manufactured --at 0,0 --time 1", 1e-3);
    keeps("reference rect-manufactured --at 0,0 --time 1 --set height=0.37", 1e-4);
    keeps("reference wall-composite --at 0 --time 1 --set x_c=0.37", 1e-5);
    keeps("reference disc-mode --at 0,0 --time 1", 1e-4); /* rings and rays */
    keeps("reference annulus --at 1,0 --time 1", 1e-4);
}

/* By hand: 2000 particles with their nearest neighbours, h = 2 kappa t/dx^2 = 1e4 for the better conductor, and one
 * step of sqrt(75 h) = 866 updates of two pairs, a load and a store: 6.9e6, and no more than that again to set up. */
static void a_step_of_polynomials_is_chosen_where_no_transform_is(void **state) {
    (void)state;
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    assert_int_equal(choose("reference rod-contact --at 0 --time 1", 1e-6, c, &why), STATUS_OK);
    assert_int_equal(c->best.candidate->options.stepper, STEPPER_CHEBYSHEV);
    assert_int_equal(c->proofs, 1);
    assert_int_equal(c->proof.steps, 1);
    assert_order(c->proof.cost.work, <, 2 * 6.9e6);
    free(c);
}

static void the_choice_repeats(void **state) {
    (void)state;
    struct failure why;
    struct choose *a = xcalloc(1, sizeof *a), *b = xcalloc(1, sizeof *b);
    assert_int_equal(choose("reference rod-step --at 0 --time 1", 1e-6, a, &why), STATUS_OK);
    assert_int_equal(choose("reference rod-step --at 0 --time 1", 1e-6, b, &why), STATUS_OK);
    assert_ptr_equal(a->best.candidate, b->best.candidate);
    assert_near(a->proof.error.l1, b->proof.error.l1, 0);
    assert_near(a->one[1].predicted_work, b->one[1].predicted_work, 0);
    free(a);
    free(b);
}

/* Sixteen particles along x need four matched steps, but the search for an isotropic h/dx outweighs them, as it
 * outweighs all of a run of finite differences. */
static void setting_up_decides_where_runs_are_short(void **state) {
    (void)state;
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    assert_int_equal(choose("reference square-step --at 0,0 --time 1", 1e-2, c, &why), STATUS_OK);
    assert_string_equal(c->best.candidate->method, "ftcs");
    assert_int_equal(choose("reference square-step --at 0,0 --time 1", 1e-5, c, &why), STATUS_OK);
    assert_int_equal(c->best.candidate->options.stepper, STEPPER_MATCHED);
    free(c);
}

static void domains_without_a_lattice_are_told_of_one(void **state) {
    (void)state;
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    const char *plate = "reference plate --at 0.01,0.01 --time 1 --set height=";
    char line[120];
    snprintf(line, sizeof line, "%s0.07071", plate);
    assert_int_equal(choose(line, 1e-2, c, &why), STATUS_INPUT);
    assert_has(why.text, "0.1 m by 0.0707100591716 m"); /* 239/338 */
    snprintf(line, sizeof line, "%s0.07", plate);
    assert_int_equal(choose(line, 1e-2, c, &why), STATUS_OK);
    assert_int_equal(choose("reference wall-composite --at 0 --time 1 --set x_c=0.41237", 1e-2, c, &why),
                     STATUS_INPUT);
    assert_has(why.text, "x = 0.412371134021 m"); /* 40/97 */
    assert_int_equal(choose("reference rod-contact --at 0 --time 0.5 --t-end 0.5 --set x_c=0.41237", 1e-2, c, &why),
                     STATUS_INPUT);
    assert_has(why.text, "x = 0.412371134021 m, and not at 0.41237 m"); /* of -1 to 1: 137/194 */
    free(c);
}

/* The one that is told of has a lattice: a ring of 338/985 of the diameter, and sides and layers of one fraction. */
static void the_domain_that_is_told_of_fits(void **state) {
    (void)state;
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    static const char *const told[][2] = {
        {"reference annulus --at 1,0 --time 1 --set r1=0.313713",
         "reference annulus --at 1,0 --time 1 --set r1=0.313705583756"},
        {"reference plane-contact --at 0.1,0.1 --time 1 --set w1=0.41237",
         "reference plane-contact --at 0.1,0.1 --time 1 --set w1=0.412370672098 --set w2=0.599999327902 "
         "--set height=0.499999439919"}};
    assert_int_equal(choose(told[0][0], 1e-2, c, &why), STATUS_INPUT);
    assert_has(why.text, "one fits a hole of radius 0.313705583756 m, and not 0.313713 m");
    assert_int_equal(choose(told[1][0], 1e-2, c, &why), STATUS_INPUT);
    assert_has(why.text, "one fits 1.01237 m by 0.499999439919 m with the interface at x = 0.412370672098 m, and not "
                         "0.5 m with it at 0.41237 m");
    for (int i = 0; i < 2; i++) {
        struct request r;
        if (arguments_parse_line(told[i][1], &r, &why)) fail_msg("%s: %s", told[i][1], why.text);
        assert_order(candidate_unit(&r.experiment.problem), >, 0);
        arguments_free(&r);
    }
    free(c);
}

/* As candidate_predict counts it: rows at ten times their pairs, and the exact temperature of each particle. */
static double whole(const struct result *r, int rows) {
    return r->cost.work + 1e4 * (double)r->particles + (rows ? 9 * (double)r->cost.interactions : 0);
}

/* No run may take more than 1e9 pairs.  What was the best then is within reach, and work was left for nothing finer.
 */
static void out_of_reach_one_sees_how_far_one_comes(void **state) {
    (void)state;
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    const char *lines[] = {"reference plate --at 0.01,0.01 --time 1", "reference rod-contact --at 0 --time 1"};
    for (int i = 0; i < 2; i++) {
        assert_int_equal(choose_within(lines[i], 1e-12, 1e9, c, &why), STATUS_GATE);
        char said[200];
        snprintf(said, sizeof said, "; the best was %.3g, by %s with %d particles along x",
                 fmax(c->proof.error.l1, c->between), c->best.candidate->label, c->best.wanted);
        assert_has(why.text, said);
        double best = c->proof.error.l1, predicted = c->best.predicted_error;
        assert_order(best, >, 0.5 * predicted);
        assert_order(best, <, 2 * predicted);
        assert_order(whole(&c->proof, i), <=, 1e9);
        assert_order(whole(&c->proof, i), >, 0.2e9);
        assert_int_equal(choose_within(lines[i], 1.5 * best, 1e9, c, &why), STATUS_OK);
        assert_int_equal(choose_within(lines[i], 0.4 * best, 1e9, c, &why), STATUS_GATE);
        assert_order(whole(&c->proof, i), <=, 1e9);
    }
    free(c);
}

/* Some 1e6 steps, each rounded by 1e-16 at random. */
static void rounding_is_predicted(void **state) {
    (void)state;
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    assert_int_equal(choose_within("reference rod-step --at 0 --time 1", 1e-15, 1e9, c, &why), STATUS_GATE);
    assert_has(why.text, "rounding alone leaves");
    assert_order(c->rounding, >, 1e-14);
    assert_order(c->rounding, <, 1e-12);
    double least = INFINITY, most = 0;
    for (int i = 0; i < c->count; i++) {
        assert_true(c->one[i].predicted_work == INFINITY);
        if (c->one[i].rounding > 0) least = fmin(least, c->one[i].rounding);
        most = fmax(most, c->one[i].rounding);
    }
    assert_near(c->rounding, least, 0);
    assert_order(most, >, least);
    free(c);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_error_is_reached),
        cmocka_unit_test(the_choice_repeats),
        cmocka_unit_test(setting_up_decides_where_runs_are_short),
        cmocka_unit_test(domains_without_a_lattice_are_told_of_one),
        cmocka_unit_test(the_domain_that_is_told_of_fits),
        cmocka_unit_test(a_step_of_polynomials_is_chosen_where_no_transform_is),
        cmocka_unit_test(out_of_reach_one_sees_how_far_one_comes),
        cmocka_unit_test(rounding_is_predicted),
    };
    return cmocka_run_group_tests_name("choose", tests, NULL, NULL);
}
