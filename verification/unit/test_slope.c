/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slopes, windows and verdicts, and the ways in which other suites were fooled. */
#include "verification/judge/slope.h"

#include "verification/judge/judge.h"
#include "verification/judge/window.h"

#include "verification/unit/near.h"

#include <string.h>

enum { N = 6 };
static const double X[N] = {0.4, 0.2, 0.1, 0.05, 0.025, 0.0125};

static void power_law(double p, double c, double error[N]) {
    for (int i = 0; i < N; i++) error[i] = c * pow(X[i], p);
}

static void pure_power_law_is_recovered(void **state) {
    (void)state;
    double error[N], local[N];
    power_law(1.73, 0.37, error);
    struct slope s = slope_fit(X, error, N);
    assert_near(s.value, 1.73, 1e-13);
    assert_near(s.ci[0], 1.73, 1e-12);
    assert_near(s.ci[1], 1.73, 1e-12);
    slope_local(X, error, N, local);
    for (int i = 0; i + 1 < N; i++) assert_near(local[i], 1.73, 1e-12);
}

/* By hand: log-log points (0,0), (1,1), (2,3) give slope 3/2, residuals (1/6, -1/3, 1/6), standard error
 * sqrt((1/6)/1/2) = 0.288675, t(0.975, 1) = 12.7062. */
static void interval_uses_student_t(void **state) {
    (void)state;
    const double e = exp(1), x[3] = {1, 1 / e, 1 / (e * e)}, error[3] = {1, 1 / e, exp(-3)};
    struct slope s = slope_fit(x, error, 3);
    assert_near(s.value, 1.5, 1e-14);
    assert_near(s.ci[1] - s.value, 12.706204736432095 * sqrt(1.0 / 12), 1e-9);
    assert_near(s.value - s.ci[0], 12.706204736432095 * sqrt(1.0 / 12), 1e-9);
}

static void two_points_have_no_interval(void **state) {
    (void)state;
    double error[N];
    power_law(2, 1, error);
    struct slope s = slope_fit(X, error, 2);
    assert_near(s.value, 2, 1e-13);
    assert_nan(s.ci[0]);
    assert_nan(s.ci[1]);
    assert_nan(slope_fit(X, error, 1).value);
    assert_nan(slope_fit(X, error, 0).value);
}

/* ---- The window ---- */

static void rungs(const double *error, int n, struct window_rung *rung) {
    for (int i = 0; i < n; i++) rung[i] = (struct window_rung){.x = X[i], .error = error[i]};
}

static void clean_ladder_keeps_all_rungs(void **state) {
    (void)state;
    struct window w;
    struct window_rung rung[N];
    double error[N];
    power_law(2, 0.3, error);
    rungs(error, N, rung);
    window_choose(rung, N, &w);
    assert_int_equal(w.n, N);
    for (int i = 0; i < N; i++) assert_string_equal(w.left_out[i], "");
}

static void floors_are_left_out_with_their_reason(void **state) {
    (void)state;
    struct window w;
    struct window_rung rung[N];
    double error[N];
    power_law(2, 0.3, error);
    rungs(error, N, rung);
    rung[5].rounding = 0.3;
    rung[4].reference = 0.11;
    rung[0].time = 0.0101;
    rung[1].time = 0.0099;
    rung[2].time = NAN; /* unknown: the user chose the step */
    window_choose(rung, N, &w);
    assert_int_equal(w.n, 3);
    assert_has(w.left_out[5], "round-off floor");
    assert_has(w.left_out[4], "reference floor");
    assert_has(w.left_out[0], "time-error floor");
    assert_int_equal(w.counts[1] && w.counts[2] && w.counts[3], 1);
}

static void coarse_rungs_are_left_out_until_four_remain(void **state) {
    (void)state;
    struct window w;
    struct window_rung rung[N];
    double error[N];
    power_law(2, 0.3, error);
    error[0] *= 0.5;
    rungs(error, N, rung);
    window_choose(rung, N, &w);
    assert_int_equal(w.n, N - 1);
    assert_has(w.left_out[0], "pre-asymptotic");
    for (int i = 0; i < N; i++) error[i] = pow(0.5, i * i); /* every local slope differs */
    rungs(error, N, rung);
    window_choose(rung, N, &w);
    assert_int_equal(w.n, WINDOW_LEAST);
    assert_true(w.counts[2] && w.counts[3] && w.counts[4] && w.counts[5]);
}

/* Logarithms 0, 0, s, 0, 0 about no slope: third differences 3 s and -3 s over sqrt(20), and 0.8 s^2 over three
 * degrees of freedom.  Of four rungs there is one third difference, which says nothing. */
static void roughness_needs_five_rungs(void **state) {
    (void)state;
    const double x[5] = {1, 0.5, 0.25, 0.125, 0.0625}, error[5] = {1, 1, exp(0.1), 1, 1};
    assert_near(slope_roughness(x, error, 5), (9.0 / 20) / (0.8 / 3), 1e-12);
    assert_near(slope_roughness(x, error, 4), 0, 0);
}

/* A bound of the whole error and more is no share of it. */
static void rounding_above_the_error_counts_as_all(void **state) {
    (void)state;
    static const double share[4] = {0.997, 1, 1.5, 2.5};
    struct window_rung rung[4];
    struct window w;
    for (int i = 0; i < 4; i++) rung[i] = (struct window_rung){.x = 1.0 / (1 + i), .error = 1, .rounding = share[i]};
    window_choose(rung, 4, &w);
    assert_string_equal(w.left_out[0], "round-off floor: up to 100 % of the error is rounding");
    for (int i = 1; i < 4; i++)
        assert_string_equal(w.left_out[i], "round-off floor: all of the error may be rounding");
}

/* For an even number of finer local slopes the median is the mean of the middle two: 2.08 for 2.00, 2.04, 2.12,
 * 2.16; 1.99 differs from it by less than 0.1, 1.97 by more. */
static void median_of_an_even_count(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        const double local[N - 1] = {k ? 1.97 : 1.99, 2.00, 2.04, 2.12, 2.16};
        struct window w;
        struct window_rung rung[N];
        double error[N] = {1};
        for (int i = 0; i + 1 < N; i++) error[i + 1] = error[i] * pow(2, -local[i]);
        rungs(error, N, rung);
        window_choose(rung, N, &w);
        assert_int_equal(w.counts[0], !k);
    }
}

/* Second order on coarse rungs, nothing on fine ones: the fine ones stay, and fail. */
static void stalled_fine_rungs_stay_and_fail(void **state) {
    (void)state;
    struct window w;
    struct window_rung rung[N];
    char reason[160];
    const double error[N] = {1, 0.25, 0.0625, 0.05, 0.049, 0.0489};
    rungs(error, N, rung);
    window_choose(rung, N, &w);
    assert_true(w.counts[3] && w.counts[4] && w.counts[5]);
    struct judged judged = {X + 2, error + 2, 4, 0, NULL};
    assert_int_not_equal(judge_order(&judged, 1.9, 2.1, reason, sizeof reason), VERDICT_PASS);
}

static void nonfinite_errors_are_included(void **state) {
    (void)state;
    struct window w;
    struct window_rung rung[N];
    double error[N];
    power_law(2, 0.3, error);
    error[0] = NAN;
    rungs(error, N, rung);
    window_choose(rung, N, &w);
    assert_int_equal(w.counts[0], 1);
}

static void zero_error_counts_as_rounding(void **state) {
    (void)state;
    struct window w;
    struct window_rung rung[2] = {{.x = 1, .error = 1}, {.x = 0.5, .error = 0, .rounding = 1e-15 / 0.0}};
    window_choose(rung, 2, &w);
    assert_int_equal(w.counts[1], 0);
    assert_has(w.left_out[1], "all of the error");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pure_power_law_is_recovered),
        cmocka_unit_test(interval_uses_student_t),
        cmocka_unit_test(two_points_have_no_interval),
        cmocka_unit_test(clean_ladder_keeps_all_rungs),
        cmocka_unit_test(floors_are_left_out_with_their_reason),
        cmocka_unit_test(coarse_rungs_are_left_out_until_four_remain),
        cmocka_unit_test(roughness_needs_five_rungs),
        cmocka_unit_test(rounding_above_the_error_counts_as_all),
        cmocka_unit_test(median_of_an_even_count),
        cmocka_unit_test(stalled_fine_rungs_stay_and_fail),
        cmocka_unit_test(nonfinite_errors_are_included),
        cmocka_unit_test(zero_error_counts_as_rounding),
    };
    return cmocka_run_group_tests_name("slope", tests, NULL, NULL);
}
