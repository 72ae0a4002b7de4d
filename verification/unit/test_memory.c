/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The estimated memory of a run, and its refusal above the limit. */
#include "verification/solve/memory.h"

#include "verification/case/command.h"
#include "verification/judge/run.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

static void check(const char *line, const char *says) {
    struct command r;
    struct failure why = {0};
    if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    assert_int_equal(memory_check(&r.experiment, &why), says ? STATUS_INPUT : STATUS_OK);
    if (says && !strstr(why.text, says)) fail_msg("%s: \"%s\" lacks \"%s\"", line, why.text, says);
    command_free(&r);
}

/* A rod's particle takes 40 bytes, one of the plane 48: 1e-5 GB hold 250 and 208. */
static void the_finest_spacing_that_fits_is_named(void **state) {
    (void)state;
    check("run rod-step so_ssph --dx 0.001 --memory 1e-5",
          "needs 0.000128 GB, --memory allows 1e-05 GB; --dx 0.01282051282 fits");
    check("run rod-step so_ssph --dx 0.01282051282 --memory 1e-5", NULL);
    check("run square-step so_ssph --dx 0.1 --memory 1e-5", "--dx 0.2352941176 fits");
    check("run square-step so_ssph --dx 0.2352941176 --memory 1e-5", NULL);
    check("run square-step so_ssph --dx 4/20000 --layout jitter --jitter 0.2 --memory 24", "GB sets another limit");
}

/* Rows are stored once during the run, and nearly three times while they are assembled. */
static void rows_count_with_their_neighbours(void **state) {
    (void)state;
    static const char *const lines[] = {"run square-step so_ssph --dx 0.1 --layout jitter --jitter 0.2",
                                        "run square-step so_ssph --dx 0.1 --layout jitter --jitter 0.2 --h 1.5",
                                        "run rod-contact brookshaw --dx 0.002",
                                        "run cube-step so_ssph --dx 0.2 --layout jitter --jitter 0.2 --dt 0.1"};
    for (int i = 0; i < 4; i++) {
        struct command r;
        struct result result;
        struct failure why;
        if (command_read(lines[i], &r, &why)) fail_msg("%s: %s", lines[i], why.text);
        assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
        double times = memory_estimate(&r.experiment) / (double)result.cost.bytes;
        assert_order(times, >, 1.3);
        assert_order(times, <, 3.2);
        command_free(&r);
    }
}

/* Two states of T, each with its ghosts; exp(tA) transforms T in place. */
static void a_particle_of_a_box_takes_under_twenty_bytes(void **state) {
    (void)state;
    static const char *const given[] = {"so_ssph --stepper euler --dt 0.01", "so_ssph --stepper exact",
                                        "ftcs --dt 0.01", "ftcs_flux --dt 0.01"};
    static const double most[] = {20, 8.1, 20, 22};
    for (int i = 0; i < 4; i++) {
        char line[160];
        struct command r;
        struct field f;
        struct failure why;
        snprintf(line, sizeof line, "run cube-step %s --dx 4/100 --set t_end=0.01", given[i]);
        if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
        if (method_solve(r.experiment.method, &r.experiment.problem, &r.experiment.options, &f, &why))
            fail_msg("%s", why.text);
        assert_order((double)f.cost.bytes / (double)f.n, <, most[i]);
        field_free(&f);
        command_free(&r);
    }
}

static void free_memory_is_less_than_the_machine_has(void **state) {
    (void)state;
    double all = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    assert_order(memory_there(), >, 1e6);
    assert_order(memory_there(), <=, all);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_finest_spacing_that_fits_is_named),
        cmocka_unit_test(rows_count_with_their_neighbours),
        cmocka_unit_test(a_particle_of_a_box_takes_under_twenty_bytes),
        cmocka_unit_test(free_memory_is_less_than_the_machine_has),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
