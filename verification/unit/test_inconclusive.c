/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reasons for an inconclusive ladder: each with its numbers, and none if there is none. */
#include "verification/judge/judge.h"

#include "references/mapping.h"
#include "solver/field.h"
#include "verification/judge/norms.h"
#include "verification/judge/slope.h"
#include "verification/judge/window.h"

#include "verification/unit/near.h"

#include <gsl/gsl_cdf.h>
#include <stdio.h>

/* Halved rungs of another program with errors of these local slopes that end at `finest`; the coarsest `out` do not
 * count. */
struct made {
    double x[RUNG_MAX], error[RUNG_MAX], band[2];
    struct judge_facts f;
};

static void make(struct made *m, const double *slope, int n, double finest, int out) {
    *m = (struct made){0};
    m->error[n - 1] = finest;
    for (int i = n - 1; i >= 0; i--) {
        m->x[i] = 0.4 / pow(2, i);
        if (i < n - 1) m->error[i] = m->error[i + 1] * pow(2, slope[i]);
    }
    m->f = (struct judge_facts){.rungs = {m->x + out, m->error + out, n - out, 0, NULL},
                                .x = m->x,
                                .error = m->error,
                                .n = n,
                                .finest = finest,
                                .answers = 1};
}

static struct judge_verdict judge(struct made *m, double lo, double hi, double ceiling) {
    m->band[0] = lo, m->band[1] = hi;
    m->f.band = m->band, m->f.ceiling = ceiling;
    return judge_ladder(&m->f);
}

static const double steady[3] = {2, 2, 2};

/* Second order, against bands of third. */
static void noise_leaves_a_ladder_inconclusive(void **state) {
    (void)state;
    static const char *const said = "answers differ by 0.012 K from run to run, 37 % of the error: random numbers, "
                                    "threads or an unset variable; no order shows";
    struct made m;
    make(&m, steady, 4, 1e-3, 0);
    m.f.noise = (struct judge_noise){.apart = 0.0123, .share = 0.37, .finest = 1e-4};
    struct judge_verdict v = judge(&m, 2.9, 3.1, 0);
    assert_string_equal(v.reason, said);
    assert_int_equal(v.verdict, VERDICT_INCONCLUSIVE);
    v = judge(&m, 2.9, 3.1, 7.1e-4); /* 1e-3 less three times 1e-4 */
    assert_string_equal(v.reason, said);
    assert_int_equal(v.verdict, VERDICT_INCONCLUSIVE);
    v = judge(&m, 2.9, 3.1, 6.9e-4);
    assert_int_equal(v.verdict, VERDICT_FAIL);
    assert_has(v.reason, "no order shows; the error 0.0007 is above its ceiling 0.00069");
    assert_int_equal(judge(&m, 1.9, 2.1, 0).verdict, VERDICT_PASS);
    m.f.noise.share = 0.09;
    v = judge(&m, 2.9, 3.1, 0);
    assert_int_equal(v.verdict, VERDICT_FAIL);
    assert_has(v.reason, "is outside [2.9, 3.1]");
    m.f.noise.share = 0.37, m.f.failure.status = STATUS_NUMERICAL;
    assert_int_equal(judge(&m, 2.9, 3.1, 0).verdict, VERDICT_FAIL);
}

static void few_printed_digits_leave_a_ladder_inconclusive(void **state) {
    (void)state;
    static const struct {
        double of;
        const char *said;
    } row[] = {{0.21, "printed digits: 4 in the file make up 21 % of the finest error; more of them show the order"},
               {7, "printed digits: 4 in the file make up 100 % of the finest error"},
               {0.11, "printed digits: 4 in the file make up 11 % of the finest error"},
               {0.09, "is outside [2.9, 3.1]"}};
    for (int i = 0; i < 4; i++) {
        struct made m;
        make(&m, steady, 4, 1e-3, 0);
        m.f.printed = row[i].of, m.f.digits = 4;
        struct judge_verdict v = judge(&m, 2.9, 3.1, 1);
        assert_has(v.reason, row[i].said);
        assert_int_equal(v.verdict, i < 3 ? VERDICT_INCONCLUSIVE : VERDICT_FAIL);
    }
}

static double digits_of(double *T, size_t n, const struct mapping *map, int wanted) {
    struct field f = {.n = n, .T = T};
    int digits;
    double share = norms_digits(&f, map, &digits);
    if (wanted) assert_int_equal(digits, wanted);
    return share;
}

/* A unit is off by a quarter of it on average: of 12.34, 0.5678 and 3.210 with four digits, of 1.23 with two
 * decimals.  A case in other temperatures: 1.234, -0.0377 and 3.107 of the file, scaled by 1.02 and shifted by
 * -0.533. */
static void digits_are_counted_in_the_temperatures_of_the_file(void **state) {
    (void)state;
    static const struct mapping as_it_is, maps[] = {{.axes = 1, .scale = 1.02, .offset = -0.533},
                                                    {.axes = 1, .scale = 0.542},
                                                    {.axes = 1, .offset = 3.107}};
    double significant[] = {12.34, 0, 0.5678, -3.21}, decimals[] = {123.45, 1.23, 0.07};
    assert_near(digits_of(significant, 4, &as_it_is, 4), (1e-2 + 1e-4 + 1e-3) / 4 / (12.34 + 0.5678 + 3.21), 1e-15);
    assert_near(digits_of(decimals, 3, &as_it_is, 5), 3e-2 / 4 / (123.45 + 1.23 + 0.07), 1e-15);
    for (int k = 0; k < 3; k++) {
        double T[] = {1.234, -0.0377, 3.107}, sum = 0;
        for (int i = 0; i < 3; i++) sum += fabs(T[i] = mapping_temperature_back(&maps[k], T[i]));
        double share = (1e-3 + 1e-4 + 1e-3) / 4 / mapping_scale(&maps[k]) / sum;
        if (maps[k].offset > 3) share = (2e-3 + 1e-4) / 4 / sum;
        assert_near(digits_of(T, 3, &maps[k], 4), share, 1e-15);
        T[1] = sqrt(2); /* all digits */
        assert_order(digits_of(T, 3, &maps[k], 0), <, 1e-11);
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
               {{-0.6, -0.2, 0, 0.2, 0.4}, ""},
               {{1, 1.6, 2.2, 2.8, 3.4}, ""},
               {{2, 2.6, 2.2, 2, 2}, ""},
               {{2, 2.4, 1.8, 1.6, 1.4}, ""}};
    for (int i = 0; i < 7; i++)
        for (int named = 0; named < 2; named++) {
            struct made m;
            make(&m, row[i].slope, 6, 1e-3, 0);
            m.f.named = named;
            struct judge_verdict v = judge(&m, 4.5, 4.9, 0);
            int rough = *row[i].said && !named;
            if (rough) assert_has(v.reason, row[i].said);
            assert_int_equal(v.verdict, rough ? VERDICT_INCONCLUSIVE : VERDICT_FAIL);
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
    for (int out = 0; out < 2; out++) {
        struct made m;
        make(&m, slope + !out, 4 + out, 2e-4, out);
        struct slope s = slope_fit(m.f.rungs.x, m.f.rungs.error, 4);
        double room = fmin(s.value - 1.75, 2.3 - s.value);
        char text[160];
        int needed = 5;
        while (half_interval(&s, 4, needed) > room) needed++;
        assert_order(needed, >, 5);
        struct judge_verdict v = judge(&m, 1.75, 2.3, 0.01);
        snprintf(text, sizeof text,
                 "the order's interval [%.2f, %.2f] of 4 rungs reaches past [1.75, 2.3]: with this scatter "
                 "%d rungs decide (--rungs %d)",
                 s.ci[0], s.ci[1], needed + out, needed + out);
        assert_has(v.reason, text);
        assert_has(v.reason,
                   "the error 0.0002 is 50 times below its ceiling and falls throughout (slopes 2.40, 1.60, "
                   "2.40), but");
        assert_has(judge(&m, 1.99, 2.01, 0.01).reason,
                   "reaches past [1.99, 2.01]: no 12 rungs with this scatter decide");
        assert_lacks(judge(&m, 1.75, 2.3, 0.0019).reason, "rungs decide"); /* not far below */
    }
}

/* If the error increases once, further rungs do not help. */
static void rising_errors_need_no_more_rungs(void **state) {
    (void)state;
    static const double slope[4] = {2.4, 2.4, -0.2, 2.4};
    struct made m;
    make(&m, slope, 5, 2e-4, 0);
    assert_lacks(judge(&m, 1.75, 2.3, 0.01).reason, "falls throughout");
}

/* Errors of second order, and then none: the file of the reference, say.  If all are at round-off, 0 is one of them.
 */
static void an_error_of_zero_is_no_order(void **state) {
    (void)state;
    struct made m;
    make(&m, steady, 4, 1e-3, 0);
    m.error[3] = 0;
    m.f.rungs.n = 3, m.f.exact = 1, m.f.finest_exact = 1, m.f.finest = 0;
    struct judge_verdict v = judge(&m, 1.9, 2.1, 1);
    assert_int_equal(v.verdict, VERDICT_INCONCLUSIVE);
    assert_has(v.reason, "the finest error is exactly 0, after errors that are not at round-off");
    m.f.rungs.n = 0, m.f.exact = 4;
    assert_int_equal(judge(&m, 1.9, 2.1, 1).verdict, VERDICT_PASS);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_leaves_a_ladder_inconclusive),
        cmocka_unit_test(few_printed_digits_leave_a_ladder_inconclusive),
        cmocka_unit_test(digits_are_counted_in_the_temperatures_of_the_file),
        cmocka_unit_test(turning_slopes_are_not_smooth),
        cmocka_unit_test(missing_rungs_are_counted),
        cmocka_unit_test(rising_errors_need_no_more_rungs),
        cmocka_unit_test(an_error_of_zero_is_no_order),
    };
    return cmocka_run_group_tests_name("inconclusive", tests, NULL, NULL);
}
