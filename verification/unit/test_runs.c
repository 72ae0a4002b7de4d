/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs that share cases: which row runs a case, which gets the answer of another, when a program counts as absent,
 * and the printed messages. */
#include "verification/solve/runs.h"

#include "solver/status.h"
#include "verification/text/progress.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static enum runs_turn begin(struct runs *r, const char *dir, const char *text, double *seconds, struct failure *why) {
    *why = (struct failure){0};
    return runs_begin(r, dir, text, "smooth/gauss", "0.25", seconds, why);
}

static void a_case_is_answered_once(void **state) {
    (void)state;
    struct runs *r = runs_create(1, 4, NULL);
    struct failure why, bad;
    double seconds = 0;
    refuse(&bad, STATUS_NUMERICAL, "exit status 9");
    assert_int_equal(begin(r, "a", "case 1", &seconds, &why), RUNS_NOW);
    runs_end(r, "a", 9, 1.25, &bad);
    assert_int_equal(begin(r, "a", "case 1", &seconds, &why), RUNS_BEFORE);
    assert_near(seconds, 1.25, 0);
    assert_string_equal(why.text, "exit status 9");
    assert_int_equal(begin(r, "a", "case 2", &seconds, &why), RUNS_APART);
    runs_end(r, NULL, 0, 2, &(struct failure){0});
    assert_int_equal(begin(r, NULL, "case 1", &seconds, &why), RUNS_NOW);
    runs_end(r, NULL, 0, 2, &(struct failure){0});
    assert_int_equal(begin(r, "a", "case 1", &seconds, &why), RUNS_BEFORE);
    assert_near(seconds, 1.25, 0);
    runs_free(r);
}

/* Exit statuses 126 and 127 of the first that ends, not of one after an answer. */
static void answering_program_is_not_missing(void **state) {
    (void)state;
    for (int code = 126; code <= 127; code++)
        for (int answered = 0; answered < 2; answered++) {
            struct runs *r = runs_create(1, 4, NULL);
            struct failure why, none = {0}, bad;
            double seconds;
            refuse(&bad, STATUS_INPUT, "could not be run");
            for (int i = 0; i < 1 + answered; i++) {
                assert_int_equal(begin(r, NULL, "case", &seconds, &why), RUNS_NOW);
                runs_end(r, NULL, i < answered ? 9 : code, 1, i < answered ? &none : &bad);
            }
            assert_int_equal(runs_absent(r, &why), !answered);
            assert_int_equal(begin(r, NULL, "case", &seconds, &why), answered ? RUNS_NOW : RUNS_OVER);
            if (!answered) assert_string_equal(why.text, "could not be run");
            runs_free(r);
        }
}

/* The text that a terminal shows since `from`. */
static void shown(FILE *to, long from, char text[400]) {
    fflush(stderr);
    rewind(to);
    fseek(to, from, SEEK_SET);
    text[fread(text, 1, 399, to)] = '\0';
}

/* After the first of 11 runs the remaining time is ten times that of the first. */
static void terminal_shows_remaining_rows(void **state) {
    (void)state;
    struct progress progress = {.shown = 1};
    struct runs *r = runs_create(2, 11, &progress);
    struct failure why;
    struct timespec from, to;
    char first[400], second[400];
    double seconds, left = NAN;
    FILE *file = tmpfile();
    int stream = dup(STDERR_FILENO);
    clock_gettime(CLOCK_MONOTONIC, &from);
    dup2(fileno(file), STDERR_FILENO);
    begin(r, NULL, "case 1", &seconds, &why);
    begin(r, NULL, "case 2", &seconds, &why);
    shown(file, 0, first);
    nanosleep(&(struct timespec){0, 500000000}, NULL);
    long end = ftell(file);
    runs_end(r, NULL, 0, 0.05, &why);
    begin(r, NULL, "case 3", &seconds, &why);
    shown(file, end, second);
    clock_gettime(CLOCK_MONOTONIC, &to);
    dup2(stream, STDERR_FILENO);
    close(stream);
    fclose(file);
    assert_has(first, "smooth/gauss, dx 0.25: run 1 ");
    assert_has(first, "smooth/gauss, dx 0.25: run 2 ");
    assert_int_equal(sscanf(second, "\rsmooth/gauss, dx 0.25: run 3 of 11, some %lf s left", &left), 1);
    double spent = (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
    assert_order(left, >=, 5);
    assert_order(left, <=, 10 * spent + 0.5);
    runs_free(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_case_is_answered_once),
        cmocka_unit_test(answering_program_is_not_missing),
        cmocka_unit_test(terminal_shows_remaining_rows),
    };
    return cmocka_run_group_tests_name("runs", tests, NULL, NULL);
}
