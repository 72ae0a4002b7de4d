/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What will take long is told beforehand, what is short is not: by counted work, the same on every machine. */
#include "verification/choose/forewarn.h"

#include "verification/choose/plan.h"
#include "verification/command/arguments.h"
#include "verification/command/request.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static double seconds_of(const char *line) {
    struct request r;
    struct failure why;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    double seconds = forewarn_seconds(&r.experiment);
    arguments_free(&r);
    return seconds;
}

static void minutes_and_years_are_told(void **state) {
    (void)state;
    static const char *const lines[] = {"run rod-gauss so_ssph --dx 1e-6 --layout jitter",
                                        "run rod-cosine ftcs_flux --dx 0.01 --t-end 1e6",
                                        "run rod-step ftcs --dx 0.01 --set kappa=1e6",
                                        "run square-step so_ssph --dx 4/640 --layout jitter --jitter 0.2"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        if (!(seconds_of(lines[i]) >= forewarn_least)) fail_msg("%s: %g s", lines[i], seconds_of(lines[i]));
}

static void what_is_short_is_not(void **state) {
    (void)state;
    static const char *const lines[] = {"run rod-step so_ssph --dx 0.05",
                                        "run square-step so_ssph --dx 4/640",
                                        "run square-step ftcs --dx 0.02",
                                        "run rod-contact brookshaw --dx 0.002",
                                        "run plate brookshaw --dx 0.001",
                                        "run square-step so_ssph --dx 0.05 --layout jitter --jitter 0.2",
                                        "run rod-cosine fo_ssph --dx 1/6400 --layout node"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        if (!(seconds_of(lines[i]) < forewarn_least)) fail_msg("%s: %g s", lines[i], seconds_of(lines[i]));
}

/* What forewarn_run writes of the command; `text` holds 200 letters. */
static void words_of(const char *line, char *text) {
    struct request r;
    struct failure why;
    FILE *file = tmpfile();
    int shown = dup(STDERR_FILENO);
    assert_true(file && shown >= 0);
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    dup2(fileno(file), STDERR_FILENO);
    int status = forewarn_run("this run", &r.experiment, &why);
    dup2(shown, STDERR_FILENO);
    close(shown);
    arguments_free(&r);
    assert_int_equal(status, STATUS_OK);
    rewind(file);
    text[fread(text, 1, 199, file)] = '\0';
    fclose(file);
}

static void a_run_is_told_once_and_in_words(void **state) {
    (void)state;
    char text[200];
    words_of("run rod-step ftcs --dx 0.01 --set kappa=1e6", text);
    assert_has(text, "heatladder: this run will take some ");
    assert_has(text, " of one processor, by the operations it counts\n");
    assert_ptr_equal(strchr(text, '\n'), text + strlen(text) - 1);
    words_of("run square-step ftcs --dx 0.02", text);
    assert_string_equal(text, "");
}

/* The work of the plan and an exact temperature a particle; where a time step is searched, half as much work again.
 */
static void seconds_are_those_of_the_plan(void **state) {
    (void)state;
    static const char *const lines[] = {"run rod-cosine ftcs_flux --dx 0.01 --fourier 0.2 --t-end 1e6",
                                        "run rod-cosine ftcs_flux --dx 0.01 --t-end 1e6"};
    for (int i = 0; i < 2; i++) {
        struct request r;
        struct plan plan;
        struct failure why;
        if (arguments_parse_line(lines[i], &r, &why)) fail_msg("%s: %s", lines[i], why.text);
        assert_int_equal(plan_make(&r.experiment, PLAN_SKETCH, &plan, &why), STATUS_OK);
        assert_int_equal(plan.refined, i);
        double want = (i ? 1.5 : 1) * plan_work(&plan) / 5e9 + 2e-6 * 100;
        assert_near(forewarn_seconds(&r.experiment) / want, 1, 1e-12);
        arguments_free(&r);
    }
}

/* Before anything is set up: 39 million rows. */
static void what_cannot_be_counted_is_refused(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    const char *line = "run wall-composite brookshaw --dx 2.58301e-08 --stepper chebyshev --domain whole";
    assert_int_equal(arguments_parse_line(line, &r, &why), STATUS_OK);
    assert_int_equal(forewarn_run("it", &r.experiment, &why), STATUS_INPUT);
    assert_has(why.text, "more interactions than can be counted");
    arguments_free(&r);
    assert_int_equal(arguments_parse_line("run rod-step so_ssph --dx 0.05", &r, &why), STATUS_OK);
    assert_int_equal(forewarn_run("it", &r.experiment, &why), STATUS_OK);
    arguments_free(&r);
}

static void check_memory(const char *line, const char *says) {
    struct request r;
    struct failure why = {0};
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    assert_int_equal(forewarn_run("it", &r.experiment, &why), says ? STATUS_INPUT : STATUS_OK);
    if (says && !strstr(why.text, says)) fail_msg("%s: \"%s\" lacks \"%s\"", line, why.text, says);
    arguments_free(&r);
}

/* On a lattice bytes go with the particles: 40 a particle of a rod, and 1e5 particles of which n fit; and the spacing
 * that is named does fit, where the next finer one does not. */
static void what_memory_does_not_hold_is_refused(void **state) {
    (void)state;
    check_memory("run rod-step so_ssph --dx 0.001 --memory 1e-5", "--dx 0.016 fits; --memory GB allows more");
    check_memory("run rod-step so_ssph --dx 0.016 --memory 1e-5", NULL);
    /* 59 cells have no half, and take more than 58: 2.86e-6 GB */
    check_memory("run rod-step so_ssph --dx 4/120 --memory 2.37e-6", "--dx 0.06896551724 fits");
    check_memory("run rod-step so_ssph --dx 4/252 --memory 1e-5", "takes 1.01e-05 GB, --memory allows 1e-05 GB");
    check_memory("run square-step so_ssph --dx 4/64 --layout jitter --jitter 0.1 --memory 0.001", "--dx 0.1 fits");
    check_memory("run rod-step so_ssph --dx 4/252", NULL);
    check_memory("run square-step so_ssph --dx 4/20000 --layout jitter --jitter 0.2 --memory 24", "GB allows more");
    assert_order(memory_there(), >, 1e6);
    /* what is free is less than what the machine has, some of which the kernel holds */
    double all = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    if (access("/proc/meminfo", R_OK) == 0) assert_order(memory_there(), <, all);
}

/* Of Euler steps the operations rise as 1/dx^3 on a rod. */
static void it_grows_with_the_work(void **state) {
    (void)state;
    double coarse = seconds_of("run rod-step ftcs --dx 4/4000 --fourier 0.02"),
           fine = seconds_of("run rod-step ftcs --dx 4/8000 --fourier 0.02");
    assert_order(coarse, >, 0);
    assert_near(fine / coarse, 8, 0.4);
}

/* Of a search that gets longer as it goes: all of it, each time that it has doubled. */
static void a_search_that_doubles_says_so_again(void **state) {
    (void)state;
    static const struct {
        double seconds;
        int told;
    } run[] = {{4, 0}, {5, 0}, {3, 1}, {11, 0}, {2, 1}, {24, 0}, {1e3, 1}};
    struct forewarned f = {0};
    for (size_t i = 0; i < sizeof run / sizeof *run; i++)
        assert_int_equal(forewarn_next(&f, "the search with its next run", run[i].seconds), run[i].told);
    assert_near(f.warned, 1049, 0);
}

static void texts(void **state) {
    (void)state;
    char text[40];
    forewarn_text(23.7, text, sizeof text);
    assert_string_equal(text, "24 seconds");
    forewarn_text(150, text, sizeof text);
    assert_string_equal(text, "2.5 minutes");
    forewarn_text(3e8, text, sizeof text);
    assert_string_equal(text, "9.5 years");
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(minutes_and_years_are_told),
        cmocka_unit_test(what_is_short_is_not),
        cmocka_unit_test(a_run_is_told_once_and_in_words),
        cmocka_unit_test(seconds_are_those_of_the_plan),
        cmocka_unit_test(what_cannot_be_counted_is_refused),
        cmocka_unit_test(what_memory_does_not_hold_is_refused),
        cmocka_unit_test(it_grows_with_the_work),
        cmocka_unit_test(a_search_that_doubles_says_so_again),
        cmocka_unit_test(texts),
    };
    return cmocka_run_group_tests_name("forewarn", tests, NULL, NULL);
}
