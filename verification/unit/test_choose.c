/* choose: what it promises it keeps, at parameters that nobody tuned for, twice alike; and it says so where it
 * cannot. */
#include "verification/choose.h"

#include "verification/arguments.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int choose(const char *line, double error, struct choose *c, struct failure *why) {
    struct request r;
    if (arguments_parse_line(line, &r, why)) fail_msg("%s", why->text);
    int status = choose_run(&r, error, c, why);
    arguments_free(&r);
    return status;
}

static void keeps(const char *line, double error) {
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    if (choose(line, error, c, &why)) fail_msg("%s: %s", line, why.text);
    assert_true(c->reached && c->proof.error.l1 <= error);
    assert_true(c->best.predicted_error <= error);
    assert_true(c->proof.error.l1 > 0.5 * c->best.predicted_error && c->proof.error.l1 < 2 * c->best.predicted_error);
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
    snprintf(line, sizeof line, "%s0.0707", plate);
    assert_int_equal(choose(line, 1e-2, c, &why), STATUS_INPUT);
    assert_non_null(strstr(why.text, "0.1 m by 0.0706896551724 m")); /* 41/58 */
    snprintf(line, sizeof line, "%s0.0706896551724", plate);
    assert_int_equal(choose(line, 1e-2, c, &why), STATUS_OK);
    assert_int_equal(choose("reference wall-composite --at 0 --time 1 --set x_c=0.4123", 1e-2, c, &why),
                     STATUS_INPUT);
    assert_non_null(strstr(why.text, "x = 0.412698412698 m")); /* 26/63 */
    free(c);
}

static void what_cannot_be_is_said(void **state) {
    (void)state;
    struct failure why;
    struct choose *c = xcalloc(1, sizeof *c);
    assert_int_equal(choose("reference square-step --at 0,0 --time 1", 1e-13, c, &why), STATUS_GATE);
    assert_non_null(strstr(why.text, "the best was"));
    /* some 1e6 steps, each rounded by 1e-16 at random: said without a run */
    assert_int_equal(choose("reference rod-step --at 0 --time 1", 1e-15, c, &why), STATUS_GATE);
    assert_non_null(strstr(why.text, "rounding alone leaves"));
    assert_int_equal(c->proofs, 0);
    assert_true(c->rounding > 1e-14 && c->rounding < 1e-12);
    free(c);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_error_is_reached),
        cmocka_unit_test(the_choice_repeats),
        cmocka_unit_test(setting_up_decides_where_runs_are_short),
        cmocka_unit_test(domains_without_a_lattice_are_told_of_one),
        cmocka_unit_test(what_cannot_be_is_said),
    };
    return cmocka_run_group_tests_name("choose", tests, NULL, NULL);
}
