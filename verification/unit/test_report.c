/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Published tables as printed; the closed form of xi, the search for the best one, and fits of known laws. */
#include "reports/figure/published.h"
#include "reports/figure/reading.h"
#include "reports/pamplona/xi.h"

#include "verification/judge/run.h"
#include "verification/unit/near.h"

#include <string.h>

static void deviation_in_units_of_the_last_digit(void **state) {
    (void)state;
    assert_near(published_units("0.0089", 0.0088837), 0, 0);
    assert_near(published_units("0.3381", 0.33698), -11, 0);
    assert_near(published_units("5.0103e-5", 4.9183e-5), -920, 0);
    assert_near(published_units("2.7827", 2.785), 23, 0);
    assert_near(published_units("27", 31), 4, 0);
    assert_near(published_units("3e-2", 0.05), 2, 0);
}

static void published_tables_are_read(void **state) {
    (void)state;
    struct published t;
    struct failure why;
    assert_int_equal(published_read(&t, "song_table1", &why), STATUS_OK);
    assert_int_equal(t.rows, 2);
    assert_int_equal(t.columns, 6);
    assert_string_equal(t.method[1], "so_ssph");
    assert_string_equal(t.where[3], "0.10");
    assert_string_equal(t.cell[1][0], "5.0103e-5");
    assert_near(t.value[0][5], 0.3381, 0);
    assert_int_equal(published_read(&t, "song_table9", &why), STATUS_INPUT);
    assert_has(why.text, "reports/published/song_table9.csv");
    assert_int_equal(published_row(&t, "so_ssph"), -1);
    assert_int_equal(published_read(&t, "pamplona_table1", &why), STATUS_OK);
    assert_int_equal(published_row(&t, "ftcs"), 1);
    assert_int_equal(published_row(&t, "so_ssph"), -1);
}

/* With the closed form's xi the tuned volume is the one that is exact for x^2 and y^2. */
static void closed_form_xi_equals_the_moment_volume(void **state) {
    (void)state;
    static const char words[] =
        "run plate brookshaw --kernel cubic --h 1.2 --dx 0.1/17 --stepper rk2 --dt 0.1 --t-end 7.3 --volume";
    struct command_run tuned, moment;
    assert_int_equal(command_run_line(&tuned, "%s tuned --xi %.17g", words, xi_closed_form(17, KERNEL_CUBIC)),
                     STATUS_OK);
    assert_int_equal(command_run_line(&moment, "%s moment", words), STATUS_OK);
    for (size_t i = 0; i < tuned.field.n; i++) assert_near(tuned.field.T[i], moment.field.T[i], 1e-12);
    command_run_free(&tuned);
    command_run_free(&moment);
}

static void power_law_and_exponential_are_distinguished(void **state) {
    (void)state;
    double h[5], power[5], exponential[5];
    for (int i = 0; i < 5; i++) {
        h[i] = 0.004 + 0.0013 * i;
        power[i] = 2.385 * pow(h[i], -3.7);
        exponential[i] = 7.1e5 * pow(10, -140 * h[i]);
    }
    struct xi_line l = xi_growth(h, power, 5, 1);
    assert_near(l.slope, -3.7, 1e-10);
    assert_near(l.off, 0, 1e-10);
    assert_order(xi_growth(h, power, 5, 0).off, >, 0.02);
    l = xi_growth(h, exponential, 5, 0);
    assert_near(l.slope, -140, 1e-8);
    assert_near(l.off, 0, 1e-10);
    assert_order(xi_growth(h, exponential, 5, 1).off, >, 0.02);
}

/* The search ends at a minimum: neighbours on either side are worse. */
static void best_xi_minimises_the_error(void **state) {
    (void)state;
    struct xi_best b = {.n = 13, .material = 2, .kernel = KERNEL_QUARTIC, .beta = 0.08, .t = 19.7};
    xi_find(&b);
    assert_int_equal(b.failure.status, STATUS_OK);
    assert_order(b.work, >, 0);
    assert_order(xi_error(&b, b.xi - 0.004), >, b.error);
    assert_order(xi_error(&b, b.xi + 0.004), >, b.error);
    assert_order(xi_error(&b, b.xi), >, b.error); /* the least that was met, here not in the middle */
}

/* Keys of a run, a ladder and a limit; a run that fails; a command that is refused. */
static void readings_are_keys_of_a_commands_json(void **state) {
    (void)state;
    struct reading r[4];
    struct failure why;
    char text[40];
    reading_set(&r[0], "run rod-step ftcs --dx 4/%d --fourier 0.2", 40);
    reading_set(&r[1], "ladder rod-cosine ftcs --fourier 0.2 --dx 1/20,1/40,1/80,1/160 --expect 1.9,2.1");
    reading_set(&r[2], "limit brookshaw --dim 1 --h 1.1");
    reading_set(&r[3], "run rod-step ftcs --dx 0.1 --fourier 0.9 --t-end 500");
    assert_int_equal(reading_run(r, 4, &why), STATUS_OK);
    assert_near(reading_value(&r[0], "particles"), 40, 0);
    assert_near(reading_value(&r[0], "dx"), 0.1, 1e-15);
    assert_near(reading_value(&r[0], "steps/particles"), reading_value(&r[0], "steps") / 40, 1e-15);
    assert_near(reading_value(&r[0], "dx,particles,steps/dx"), fmax(40, reading_value(&r[0], "steps")) * 10, 1e-9);
    assert_near(reading_value(&r[0], "failure"), 0, 0);
    assert_true(isnan(reading_value(&r[0], "quantity")) && isnan(reading_value(&r[0], "particles,quantity")));
    assert_near(reading_value(&r[1], "slope"), 2, 0.1);
    reading_text(&r[1], "verdict", text, sizeof text);
    assert_string_equal(text, "pass");
    assert_near(reading_value(&r[2], "times_stable after Cleary"), 0.15 * 1.21 / reading_value(&r[2], "von_neumann"),
                1e-12);
    assert_near(reading_value(&r[3], "failure"), 1, 0);
    assert_true(isnan(reading_value(&r[3], "particles")));
    reading_free(r, 4);
    reading_set(&r[0], "run rod-setp ftcs --dx 0.1");
    assert_int_equal(reading_run(r, 1, &why), STATUS_INPUT);
    assert_has(why.text, "heatladder run rod-setp ftcs --dx 0.1: unknown scene 'rod-setp'");
    reading_free(r, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(readings_are_keys_of_a_commands_json),
        cmocka_unit_test(deviation_in_units_of_the_last_digit),
        cmocka_unit_test(published_tables_are_read),
        cmocka_unit_test(closed_form_xi_equals_the_moment_volume),
        cmocka_unit_test(power_law_and_exponential_are_distinguished),
        cmocka_unit_test(best_xi_minimises_the_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
