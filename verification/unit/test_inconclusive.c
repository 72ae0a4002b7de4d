/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reasons for an inconclusive ladder: each with its numbers, and none if there is none. */
#include "verification/judge/inconclusive.h"

#include "references/mapping.h"
#include "verification/judge/ladder.h"

#include "verification/unit/near.h"

#include <gsl/gsl_cdf.h>
#include <stdio.h>
#include <stdlib.h>

/* Halved rungs with errors of these local slopes that end at `finest`; the coarsest `out` do not count. */
static struct ladder *ladder(const double *slope, int n, double finest, int out) {
    struct ladder *l = calloc(1, sizeof *l);
    double x[RUNG_MAX], error[RUNG_MAX];
    assert_non_null(l);
    l->n = n;
    l->error[n - 1] = finest;
    for (int i = n - 2; i >= 0; i--) l->error[i] = l->error[i + 1] * pow(2, slope[i]);
    for (int i = 0; i < n; i++) {
        l->x[i] = 0.4 / pow(2, i);
        l->window.counts[i] = i >= out;
        l->rung[i].error.l1 = l->error[i];
    }
    l->slope = slope_fit(x, error, ladder_counted(l, x, error));
    l->verdict = VERDICT_INCONCLUSIVE;
    snprintf(l->reason, sizeof l->reason, "kept");
    return l;
}

static const double steady[3] = {2, 2, 2}, many_digits[2] = {1.0123456789012345, 2.0123456789012345};
static double plain[2];
static const struct mapping as_it_is;

static struct field field_of(double *T, size_t n) {
    return (struct field){.n = n, .T = T};
}

static void judge(struct ladder *l, double lo, double hi, double ceiling, const struct inconclusive_noise *noise) {
    struct ladder_rungs rungs = {.expect = {.count = 2, .value = {lo, hi}}, .ceiling = ceiling};
    for (int i = 0; i < 2; i++) plain[i] = many_digits[i];
    struct field f = field_of(plain, 2);
    inconclusive_judge(&rungs, noise, &f, &as_it_is, l);
}

static void noise_leaves_a_ladder_inconclusive(void **state) {
    (void)state;
    const struct inconclusive_noise noise = {.apart = 0.0123, .share = 0.37, .finest = 1e-4},
                                    less = {0.0123, 0.09, 1e-4};
    static const char *const said = "answers differ by 0.012 K from run to run, 37 % of the error: random numbers, "
                                    "threads or an unset variable; no order shows";
    struct ladder *l = ladder(steady, 4, 1e-3, 0);
    judge(l, 1.9, 2.1, 0, &noise);
    assert_string_equal(l->reason, said);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    judge(l, 1.9, 2.1, 7.1e-4, &noise); /* 1e-3 less three times 1e-4 */
    assert_string_equal(l->reason, said);
    l->verdict = VERDICT_FAIL;
    judge(l, 1.9, 2.1, 7.1e-4, &noise);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    judge(l, 1.9, 2.1, 6.9e-4, &noise);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    assert_has(l->reason, "no order shows; the error 0.0007 is above its ceiling 0.00069");
    snprintf(l->reason, sizeof l->reason, "kept");
    judge(l, 1.9, 2.1, 0, &less);
    l->verdict = VERDICT_PASS;
    judge(l, 1.9, 2.1, 0, &noise);
    l->verdict = VERDICT_FAIL, l->failure.status = 3;
    judge(l, 1.9, 2.1, 0, &noise);
    assert_string_equal(l->reason, "kept");
    free(l);
}

/* A unit is off by a quarter of it on average: of 12.34, 0.5678 and 3.210 with four digits, of 1.23 with two
 * decimals. */
static void few_printed_digits_leave_a_ladder_inconclusive(void **state) {
    (void)state;
    const struct ladder_rungs rungs = {.ceiling = 1};
    const struct inconclusive_noise none = {0};
    double significant[] = {12.34, 0, 0.5678, -3.21}, decimals[] = {123.45, 1.23, 0.07};
    double share[2] = {(1e-2 + 1e-4 + 1e-3) / 4 / (12.34 + 0.5678 + 3.21), 3e-2 / 4 / (123.45 + 1.23 + 0.07)};
    static const struct {
        int decimals;
        double of;
        const char *said;
    } row[] = {
        {0, 0.21, "printed digits: 4 in the file make up 21 % of the finest error; more of them show the order"},
        {1, 0.6, "printed digits: 5 in the file make up 60 % of the finest error"},
        {1, 7, "printed digits: 5 in the file make up 100 % of the finest error"},
        {0, 0.11, "printed digits: 4 in the file make up 11 % of the finest error"},
        {0, 0.09, "kept"},
        {1, 0.09, "kept"}};
    for (int i = 0; i < 6; i++) {
        struct ladder *l = ladder(steady, 4, share[row[i].decimals] / row[i].of, 0);
        struct field f = field_of(row[i].decimals ? decimals : significant, row[i].decimals ? 3 : 4);
        l->verdict = VERDICT_FAIL;
        inconclusive_judge(&rungs, &none, &f, &as_it_is, l);
        assert_has(l->reason, row[i].said);
        assert_int_equal(l->verdict, i < 4 ? VERDICT_INCONCLUSIVE : VERDICT_FAIL);
        l->norm = LADDER_QUANTITY; /* its digits are not those of the field */
        snprintf(l->reason, sizeof l->reason, "kept");
        inconclusive_judge(&rungs, &none, &f, &as_it_is, l);
        assert_string_equal(l->reason, "kept");
        free(l);
    }
}

/* A case in other temperatures: 1.234, -0.0377 and 3.107 of the file, scaled by 1.02 and shifted by -0.533. */
static void digits_are_counted_in_the_temperatures_of_the_file(void **state) {
    (void)state;
    static const struct mapping maps[] = {
        {.axes = 1, .scale = 1.02, .offset = -0.533}, {.axes = 1, .scale = 0.542}, {.axes = 1, .offset = 3.107}};
    const struct ladder_rungs rungs = {.ceiling = 1};
    const struct inconclusive_noise none = {0};
    for (int k = 0; k < 3; k++) {
        double T[] = {1.234, -0.0377, 3.107}, sum = 0;
        for (int i = 0; i < 3; i++) sum += fabs(T[i] = mapping_temperature_back(&maps[k], T[i]));
        double share = (1e-3 + 1e-4 + 1e-3) / 4 / mapping_scale(&maps[k]) / sum;
        if (maps[k].offset > 3) share = (2e-3 + 1e-4) / 4 / sum;
        struct ladder *l = ladder(steady, 4, share / 0.21, 0);
        struct field f = field_of(T, 3);
        inconclusive_judge(&rungs, &none, &f, &maps[k], l);
        assert_has(l->reason, "printed digits: 4 in the file make up 21 % of the finest error");
        T[1] = sqrt(2); /* all digits */
        snprintf(l->reason, sizeof l->reason, "kept");
        inconclusive_judge(&rungs, &none, &f, &maps[k], l);
        assert_string_equal(l->reason, "kept");
        free(l);
    }
}

/* Slopes that turn by more than a half and back, or are of both signs. */
static void turning_slopes_are_not_smooth(void **state) {
    (void)state;
    static const struct {
        double slope[5];
        const char *said;
    } row[] = {{{2, 3, 2, 2, 2},
                "errors do not fall smoothly (slopes 2.00, 3.00, 2.00, 2.00, 2.00): points at random, "
                "a solver's tolerance, or errors that cancel"},
               {{2, 2, 2, 1.4, 2}, "errors do not fall smoothly"},
               {{-0.6, -0.2, 0.1, 0.3, 0.6}, "errors do not fall smoothly (slopes -0.60, -0.20, 0.10"},
               {{-0.6, -0.2, 0, 0.2, 0.4}, "kept"},
               {{1, 1.6, 2.2, 2.8, 3.4}, "kept"},
               {{2, 2.6, 2.2, 2, 2}, "kept"},
               {{2, 2.4, 1.8, 1.6, 1.4}, "kept"}};
    const struct inconclusive_noise none = {0};
    for (int i = 0; i < 7; i++)
        for (int named = 0; named < 2; named++) {
            struct ladder *l = ladder(row[i].slope, 6, 1e-3, 0);
            l->verdict = VERDICT_FAIL, l->diagnosis.named = named;
            judge(l, 2.5, 2.9, 0, &none);
            assert_has(l->reason, named ? "kept" : row[i].said);
            free(l);
        }
}

/* Student's interval of `count` rungs, halved, with the scatter of these of the `of` that there are. */
static double half_interval(const struct slope *s, int of, int count) {
    double squares[2] = {of * (of * of - 1.0), count * (count * count - 1.0)}; /* times log(2)^2/12 */
    return (s->ci[1] - s->ci[0]) / 2 / gsl_cdf_tdist_Pinv(0.975, of - 2) * gsl_cdf_tdist_Pinv(0.975, count - 2) *
           sqrt(squares[0] / squares[1]);
}

/* Slopes of 2.4, 1.6 and 2.4 in a band whose middle is not the fitted slope; with a coarsest rung that does not
 * count, one more rung is missing. */
static void missing_rungs_are_counted(void **state) {
    (void)state;
    static const double slope[4] = {2.4, 2.4, 1.6, 2.4};
    const struct inconclusive_noise none = {0};
    for (int out = 0; out < 2; out++) {
        struct ladder *l = ladder(slope + !out, 4 + out, 2e-4, out);
        double room = fmin(l->slope.value - 1.75, 2.3 - l->slope.value);
        char text[160];
        int needed = 5;
        while (half_interval(&l->slope, 4, needed) > room) needed++;
        assert_order(needed, >, 5);
        judge(l, 1.75, 2.3, 0.01, &none);
        snprintf(text, sizeof text,
                 "the interval [%.2f, %.2f] of 4 rungs reaches past [1.75, 2.3]: with this scatter "
                 "%d rungs decide (--rungs %d)",
                 l->slope.ci[0], l->slope.ci[1], needed + out, needed + out);
        assert_has(l->reason, text);
        assert_has(l->reason,
                   "the error 0.0002 is 50 times below its ceiling and falls throughout (slopes 2.40, 1.60, "
                   "2.40), but");
        judge(l, 1.99, 2.01, 0.01, &none);
        assert_has(l->reason, "reaches past [1.99, 2.01]: no 12 rungs with this scatter decide");
        snprintf(l->reason, sizeof l->reason, "kept");
        judge(l, 1.75, 2.3, 0.0019, &none); /* not far below */
        assert_lacks(l->reason, "rungs decide");
        free(l);
    }
}

/* If the error increases once, further rungs do not help. */
static void rising_errors_need_no_more_rungs(void **state) {
    (void)state;
    static const double slope[4] = {2.4, 2.4, -0.2, 2.4};
    const struct inconclusive_noise none = {0};
    struct ladder *l = ladder(slope, 5, 2e-4, 0);
    judge(l, 1.75, 2.3, 0.01, &none);
    assert_lacks(l->reason, "falls throughout");
    free(l);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_leaves_a_ladder_inconclusive),
        cmocka_unit_test(few_printed_digits_leave_a_ladder_inconclusive),
        cmocka_unit_test(digits_are_counted_in_the_temperatures_of_the_file),
        cmocka_unit_test(turning_slopes_are_not_smooth),
        cmocka_unit_test(missing_rungs_are_counted),
        cmocka_unit_test(rising_errors_need_no_more_rungs),
    };
    return cmocka_run_group_tests_name("inconclusive", tests, NULL, NULL);
}
