/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Verdicts on synthetic ladders: those that must not pass, and those that must. */
#include "verification/judge/slope.h"

#include "verification/unit/judged_ladder.h"
#include "verification/unit/near.h"

#include <string.h>

/* A ladder: dx_i = first/ratio^i, error(dx) with the finest dx as a second argument. */
struct stand_in {
    const char *name;
    double first, ratio;
    int n;
    double (*error)(double x, double finest);
    double lo, hi;
    enum verdict verdict;
    const char *said; /* in the reason */
};

static double power(double x, double finest) {
    (void)finest;
    return 0.37 * pow(x, 1.97);
}

static double first_order(double x, double finest) {
    (void)finest;
    return 0.37 * x;
}

static double growing(double x, double finest) {
    (void)finest;
    return 0.37 * pow(x, -2);
}

static double constant(double x, double finest) {
    (void)x, (void)finest;
    return 0.0123;
}

static double quarter_floor(double x,
                            double finest) { /* the floor of the example: about a quarter of the finest error */
    (void)finest;
    return 0.01 * (pow(x / 0.1, 2) + 0.0003);
}

static double exponential(double x, double finest) {
    (void)finest;
    return 0.01 * exp(20 * x);
}

static double stalled(double x, double finest) {
    (void)finest;
    return fmax(0.01 * pow(x / 0.1, 2), 3e-7);
}

static double small_floor(double x, double finest) { /* 0.063 of the finest */
    return x * x + 0.067 * finest * finest;
}

static double some_floor(double x, double finest) { /* 0.13 of the finest */
    return x * x + 0.15 * finest * finest;
}

static double half_floor(double x, double finest) {
    return x * x + finest * finest;
}

static double lower_term(double x, double finest) { /* first order takes over at the fine end */
    return x * x + 0.31 * finest * x;
}

static double higher_term(double x, double finest) {
    (void)finest;
    return x * x * (1 + 0.9 * x);
}

static double higher_term_off(double x, double finest) {
    (void)finest;
    return x * x * (1 - 0.9 * x);
}

static double logarithm(double x, double finest) {
    (void)finest;
    return -x * x * log(x);
}

static double lucky(double x, double finest) { /* the last rung alone is far too good */
    return x * x * (x < 1.01 * finest ? 0.27 : 1);
}

static double unlucky(double x, double finest) {
    return x * x * (x < 1.01 * finest ? 2.3 : 1);
}

static double cancelling(double x, double finest) { /* the error changes its sign */
    return fabs(x * x - 3.7 * finest * x);
}

static double rising_end(double x, double finest) {
    return x < 1.5 * finest ? 1.2 * pow(2 * finest, 2) : x * x;
}

static double zigzag(double x, double finest) { /* 40 % up and down */
    int i = (int)lround(log(x / finest) / log(2));
    return x * x * (i % 2 ? 1.4 : 1 / 1.4);
}

static double steeper_end(double x, double finest) {
    return x * x * (1 - 0.13 * exp(-3 * (x / finest - 1)));
}

static double not_finite(double x, double finest) {
    return x < 1.01 * finest ? NAN : x * x;
}

static const struct stand_in cases[] = {
    {"a power", 0.4, 2, 6, power, 1.9, 2.1, VERDICT_PASS, "is inside"},
    {"a power, four rungs of ratio 2", 0.4, 2, 4, power, 1.9, 2.1, VERDICT_PASS, "is inside"},
    {"a power, span of 4", 0.4, 1.41421356237309505, 5, power, 1.9, 2.1, VERDICT_PASS, "is inside"},
    {"a term of higher order", 0.4, 2, 6, higher_term, 1.9, 2.1, VERDICT_PASS, "is inside"},
    {"a term of higher order, the other sign", 0.4, 2, 6, higher_term_off, 1.9, 2.1, VERDICT_PASS, "is inside"},
    {"a logarithm in its band", 0.1, 2, 6, logarithm, 1.7, 2, VERDICT_PASS, "is inside"},
    {"a floor of 6 % between rungs of ratio 4", 0.4, 4, 5, small_floor, 1.9, 2.1, VERDICT_PASS, "is inside"},
    {"a floor, where order 0 is in the band", 0.4, 2, 5, constant, -0.1, 0.1, VERDICT_PASS, "is inside"},
    {"first order", 0.4, 2, 6, first_order, 1.9, 2.1, VERDICT_FAIL, "is outside"},
    {"growing", 0.4, 2, 6, growing, 1.9, 2.1, VERDICT_FAIL, "does not fall"},
    {"constant", 0.4, 2, 6, constant, 1.9, 2.1, VERDICT_FAIL, "does not fall"},
    {"a quarter of floor", 0.1, 1.41421356237309505, 11, quarter_floor, 1.9, 2.1, VERDICT_FAIL, "2 finest rungs"},
    {"a quarter of floor, ratio 1.2", 0.1, 1.2, 20, quarter_floor, 1.9, 2.1, VERDICT_FAIL, "2 finest rungs"},
    {"no span", 0.1, 1.002960, 11, exponential, 1.9, 2.1, VERDICT_INCONCLUSIVE, "span a factor of 1.03"},
    {"stalled at 3e-7", 0.1, 2, 11, stalled, 1.9, 2.1, VERDICT_FAIL, "does not fall"},
    {"flattening, a wide band", 0.4, 4, 5, some_floor, 1.5, 2.5, VERDICT_FAIL,
     "falls too slowly, as if 13 % of it did not fall"},
    {"flattening, wide rungs", 0.4, 4, 5, some_floor, 1.9, 2.1, VERDICT_FAIL, "falls too slowly"},
    {"half a floor", 0.4, 2, 9, half_floor, 1.8, 2.2, VERDICT_FAIL, "2 finest rungs"},
    {"first order takes over", 0.4, 2, 9, lower_term, 1.9, 2.1, VERDICT_FAIL, "2 finest rungs"},
    {"a lucky last rung", 0.4, 2, 9, lucky, 1.5, 2.5, VERDICT_FAIL, "2 finest rungs"},
    {"an unlucky last rung", 0.4, 2, 9, unlucky, 1.5, 2.5, VERDICT_FAIL, "2 finest rungs"},
    {"a sign that changes", 0.4, 2, 8, cancelling, 1.9, 2.1, VERDICT_INCONCLUSIVE, "reaches past"},
    {"a rise at the end", 0.4, 2, 6, rising_end, 1.5, 2.1, VERDICT_FAIL, "does not fall"},
    {"steeper at the end", 0.4, 2, 8, steeper_end, 1.9, 2.1, VERDICT_FAIL, "2 finest rungs"},
    {"up and down", 0.4, 2, 6, zigzag, 1.9, 2.1, VERDICT_INCONCLUSIVE, "reaches past"},
    {"a span of 3.4 alone", 0.4, 1.5, 4, power, 1.9, 2.1, VERDICT_INCONCLUSIVE, "span a factor of 3.38"},
    {"three rungs", 0.4, 2, 3, power, 1.9, 2.1, VERDICT_INCONCLUSIVE, "3 rungs count"},
    {"two rungs", 0.4, 2, 2, power, 1.9, 2.1, VERDICT_INCONCLUSIVE, "2 rungs count, at least 4 must"},
    {"one rung", 0.4, 2, 1, power, 1.9, 2.1, VERDICT_INCONCLUSIVE, "1 rung counts, at least 4 must"},
    {"no rungs", 0.4, 2, 0, power, 1.9, 2.1, VERDICT_INCONCLUSIVE, "0 rungs count"},
    {"not finite", 0.4, 2, 6, not_finite, 1.9, 2.1, VERDICT_FAIL, "not finite"},
    {"no band", 0.4, 2, 6, power, NAN, 2.1, VERDICT_FAIL, "not finite"},
    {"no band above", 0.4, 2, 6, power, 1.9, NAN, VERDICT_FAIL, "not finite"},
    {"a band upside down", 0.4, 2, 6, power, 2.1, 1.9, VERDICT_FAIL, "not finite"},
};

static void synthetic_ladders_get_their_verdict(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        const struct stand_in *c = &cases[k];
        double x[RUNG_MAX], error[RUNG_MAX], finest = c->first / pow(c->ratio, c->n - 1);
        char reason[240];
        int scattered;
        for (int i = 0; i < c->n; i++) {
            x[i] = c->first / pow(c->ratio, i);
            error[i] = c->error(x[i], finest);
        }
        enum verdict verdict = judge(x, error, c->n, c->lo, c->hi, &scattered, reason);
        if (verdict != c->verdict || !strstr(reason, c->said))
            fail_msg("%s: %s: %s", c->name, verdict_words[verdict], reason);
    }
}

static void more_rungs_are_no_advice_above_the_ceiling(void **state) {
    (void)state;
    const double x[4] = {8, 4, 2, 1}, error[4] = {90, 11, 5.6, 0.7};
    struct judged l = {x, error, 4, 0, NULL};
    char reason[240];
    enum verdict verdict = judge_order(&l, 1.9, 2.1, reason, sizeof reason);
    assert_int_equal(verdict, VERDICT_INCONCLUSIVE);
    assert_has(reason, "reaches past [1.9, 2.1]: more or finer rungs narrow it (verify: --rungs N)");
    judge_ceiling(0.7, 0.5, &verdict, reason, sizeof reason);
    assert_int_equal(verdict, VERDICT_FAIL);
    assert_has(reason, "reaches past [1.9, 2.1]; the error 0.7 is above its ceiling 0.5");
}

static void errors_that_do_not_fall_are_named(void **state) {
    (void)state;
    const double x[5] = {16, 8, 4, 2, 1}, error[5] = {70, 30, 16, 17.5, 2};
    struct judged l = {x, error, 5, 0, NULL};
    char reason[240];
    assert_int_equal(judge_order(&l, 0.9, 1.1, reason, sizeof reason), VERDICT_FAIL);
    assert_string_equal(reason, "the error does not fall: 1.6000e+01 at 4, 1.7500e+01 at 2");
}

static void fine_slope_equals_hand_calculation(void **state) {
    (void)state;
    const double x[5] = {16, 8, 4, 2, 1}, error[5] = {7, 3, 16, 4, 2};
    struct judged l = {x, error, 5, 0, NULL};
    assert_near(judge_fine_slope(&l), 1, 1e-14);
    l.scattered = 1; /* errors 16, 4, 2: log2 4, 2, 1 at 2, 1, 0: 3/2 */
    assert_near(judge_fine_slope(&l), 1.5, 1e-14);
    l.n = 1, l.scattered = 0;
    assert_nan(judge_fine_slope(&l));
}

static void error_floor_equals_hand_calculation(void **state) {
    (void)state;
    double x[6], error[6];
    for (int i = 0; i < 6; i++) {
        x[i] = 0.32 / pow(2, i);
        error[i] = 2.385 * pow(x[i], 1.5) + 2.385 * pow(0.01, 1.5) * 0.25; /* a fifth of the finest */
    }
    struct judged l = {x, error, 6, 0, NULL};
    assert_near(judge_floor(&l, 1.4, 1.6), 0.2, 1e-9); /* 1.5 is one of the orders tried */
    assert_near(judge_floor(&l, -0.2, 1.6), 0, 0);
    l.scattered = 1;
    assert_near(judge_floor(&l, 1.4, 1.6), 0.2, 1e-9);
    l.n = 3;
    assert_near(judge_floor(&l, 1.4, 1.6), 0, 0);
}

/* The coarse half has another floor than the fine one: which rungs are fitted must not depend on the unit of x. */
static void verdict_is_independent_of_units(void **state) {
    (void)state;
    double x[8], error[8];
    for (int i = 0; i < 8; i++) {
        x[i] = pow(2, -i);
        error[i] = pow(x[i], 1.5) * (i < 4 ? 1.3 : 1) + 0.2 * pow(2, -7 * 1.5); /* a sixth of the finest */
    }
    for (int k = 0; k < 3; k++) {
        struct judged l = {x, error, 8, 0, NULL};
        assert_near(judge_floor(&l, 1.4, 1.6), 1.0 / 6, 1e-9);
        for (int i = 0; i < 8; i++) x[i] *= 1e3;
    }
}

/* 1, 0, 0, 0, 0 at equal distances: the differences (1, 0) of weights 1, 3, 3, 1 over sqrt(20), and about the line
 * 1/5 - (k - 2)/5 a sum of squares of 1 - 1/5 - 4/10: (1/20)/2 over 0.4/3. */
static void roughness_equals_hand_calculation(void **state) {
    (void)state;
    const double e = exp(1), x[5] = {1, 1 / e, pow(e, -2), pow(e, -3), pow(e, -4)}, error[5] = {e, 1, 1, 1, 1};
    assert_near(slope_roughness(x, error, 5), (1.0 / 20 / 2) / (0.4 / 3), 1e-12);
    assert_near(slope_roughness(x, error, 4), 0, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(synthetic_ladders_get_their_verdict),
        cmocka_unit_test(more_rungs_are_no_advice_above_the_ceiling),
        cmocka_unit_test(errors_that_do_not_fall_are_named),
        cmocka_unit_test(fine_slope_equals_hand_calculation),
        cmocka_unit_test(error_floor_equals_hand_calculation),
        cmocka_unit_test(verdict_is_independent_of_units),
        cmocka_unit_test(roughness_equals_hand_calculation),
    };
    return cmocka_run_group_tests_name("judge", tests, NULL, NULL);
}
