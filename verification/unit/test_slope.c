/* Slopes, windows and verdicts, and the ways in which other suites were fooled. */
#include "verification/ladder/slope.h"

#include "verification/ladder/window.h"

#include "verification/unit/near.h"

#include <string.h>

enum { N = 6 };
static const double X[N] = {0.4, 0.2, 0.1, 0.05, 0.025, 0.0125};

static enum verdict judge(const double *error, int n, double lo, double hi, char reason[160]) {
    struct slope s = slope_fit(X, error, n);
    return slope_judge(&s, X, error, lo, hi, reason, 160);
}

static void power_law(double p, double c, double error[N]) {
    for (int i = 0; i < N; i++) error[i] = c * pow(X[i], p);
}

static void a_pure_power_is_found(void **state) {
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
static void the_interval_is_students(void **state) {
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
    assert_true(isnan(s.ci[0]) && isnan(s.ci[1]));
    assert_true(isnan(slope_fit(X, error, 1).value));
    assert_true(isnan(slope_fit(X, error, 0).value));
}

static void inside_outside_and_across(void **state) {
    (void)state;
    char reason[160];
    double error[N];
    power_law(2.04, 0.3, error);
    assert_int_equal(judge(error, N, 1.9, 2.1, reason), VERDICT_PASS);
    assert_int_equal(judge(error, N, 0.9, 1.1, reason), VERDICT_FAIL);
    assert_non_null(strstr(reason, "lies outside"));
    assert_int_equal(judge(error, N, 2.1, 2.3, reason), VERDICT_FAIL);
    for (int i = 0; i < N; i++) error[i] *= i % 2 ? 1.2 : 1 / 1.2; /* scatter: the interval is wide */
    assert_int_equal(judge(error, N, 1.9, 2.1, reason), VERDICT_INCONCLUSIVE);
    assert_non_null(strstr(reason, "reaches past"));
}

static void three_rungs_are_too_few(void **state) {
    (void)state;
    char reason[160];
    double error[N];
    power_law(2, 0.3, error);
    assert_int_equal(judge(error, 3, 1.9, 2.1, reason), VERDICT_INCONCLUSIVE);
    assert_string_equal(reason, "3 rungs count, at least 4 must");
    assert_int_equal(judge(error, 0, 1.9, 2.1, reason), VERDICT_INCONCLUSIVE);
}

/* |log| of growing errors has slope 2 as well: they must fail by their sign. */
static void growing_errors_fail(void **state) {
    (void)state;
    char reason[160];
    double error[N];
    power_law(-2, 0.3, error);
    assert_int_equal(judge(error, N, 1.9, 2.1, reason), VERDICT_FAIL);
    assert_non_null(strstr(reason, "does not fall"));
}

/* The mean slope of this one lies in a wide band, and its largest local slope is 2. */
static void a_stalled_ladder_fails(void **state) {
    (void)state;
    char reason[160];
    const double error[N] = {1, 0.25, 0.0625, 0.0157, 0.0157, 0.0157};
    assert_int_equal(judge(error, N, 0.5, 2.5, reason), VERDICT_FAIL);
    assert_non_null(strstr(reason, "does not fall"));
}

static void what_is_not_finite_fails(void **state) {
    (void)state;
    char reason[160];
    const double bad[3] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < N; i++) {
            double error[N];
            power_law(2, 0.3, error);
            error[i] = bad[k];
            assert_int_equal(judge(error, N, -INFINITY, INFINITY, reason), VERDICT_FAIL);
            assert_non_null(strstr(reason, "not finite"));
        }
}

static void a_band_of_nan_passes_nothing(void **state) {
    (void)state;
    char reason[160];
    double error[N];
    power_law(2, 0.3, error);
    assert_int_not_equal(judge(error, N, NAN, 2.1, reason), VERDICT_PASS);
    assert_int_not_equal(judge(error, N, 1.9, NAN, reason), VERDICT_PASS);
    assert_int_equal(verdict_within(NAN, 0, 1), VERDICT_FAIL);
    assert_int_equal(verdict_within(INFINITY, 0, INFINITY), VERDICT_FAIL);
    assert_int_equal(verdict_within(0.5, NAN, 1), VERDICT_FAIL);
    assert_int_equal(verdict_within(0.5, 0.5, 0.5), VERDICT_PASS);
    assert_int_not_equal((enum verdict)0, VERDICT_PASS); /* what nobody judged */
}

/* ---- The window ---- */

static void rungs(const double *error, int n, struct window_rung *rung) {
    for (int i = 0; i < n; i++) rung[i] = (struct window_rung){.x = X[i], .error = error[i]};
}

static void a_clean_ladder_counts_whole(void **state) {
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
    assert_non_null(strstr(w.left_out[5], "round-off floor"));
    assert_non_null(strstr(w.left_out[4], "reference floor"));
    assert_non_null(strstr(w.left_out[0], "time-error floor"));
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
    assert_non_null(strstr(w.left_out[0], "pre-asymptotic"));
    for (int i = 0; i < N; i++) error[i] = pow(0.5, i * i); /* every local slope differs */
    rungs(error, N, rung);
    window_choose(rung, N, &w);
    assert_int_equal(w.n, WINDOW_LEAST);
    assert_true(w.counts[2] && w.counts[3] && w.counts[4] && w.counts[5]);
}

/* Second order on coarse rungs, nothing on fine ones: the fine ones stay, and fail. */
static void the_fine_end_tells_the_truth(void **state) {
    (void)state;
    struct window w;
    struct window_rung rung[N];
    char reason[160];
    const double error[N] = {1, 0.25, 0.0625, 0.05, 0.049, 0.0489};
    rungs(error, N, rung);
    window_choose(rung, N, &w);
    assert_true(w.counts[3] && w.counts[4] && w.counts[5]);
    struct slope s = slope_fit(X + 2, error + 2, 4);
    assert_int_not_equal(slope_judge(&s, X + 2, error + 2, 1.9, 2.1, reason, sizeof reason), VERDICT_PASS);
}

static void what_is_not_finite_is_not_left_out(void **state) {
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

static void an_error_of_zero_is_rounding(void **state) {
    (void)state;
    struct window w;
    struct window_rung rung[2] = {{.x = 1, .error = 1}, {.x = 0.5, .error = 0, .rounding = 1e-15 / 0.0}};
    window_choose(rung, 2, &w);
    assert_int_equal(w.counts[1], 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pure_power_is_found),
        cmocka_unit_test(the_interval_is_students),
        cmocka_unit_test(two_points_have_no_interval),
        cmocka_unit_test(inside_outside_and_across),
        cmocka_unit_test(three_rungs_are_too_few),
        cmocka_unit_test(growing_errors_fail),
        cmocka_unit_test(a_stalled_ladder_fails),
        cmocka_unit_test(what_is_not_finite_fails),
        cmocka_unit_test(a_band_of_nan_passes_nothing),
        cmocka_unit_test(a_clean_ladder_counts_whole),
        cmocka_unit_test(floors_are_left_out_with_their_reason),
        cmocka_unit_test(coarse_rungs_are_left_out_until_four_remain),
        cmocka_unit_test(the_fine_end_tells_the_truth),
        cmocka_unit_test(what_is_not_finite_is_not_left_out),
        cmocka_unit_test(an_error_of_zero_is_rounding),
    };
    return cmocka_run_group_tests_name("slope", tests, NULL, NULL);
}
