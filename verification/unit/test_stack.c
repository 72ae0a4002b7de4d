/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stacks that are too small are refused before anything runs in them. */
#include "verification/cli/stack.h"

#include "solver/status.h"

#include "verification/unit/near.h"

#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

static void sizes_are_read_as_openmp_does(void **state) {
    (void)state;
    assert_near(stack_size("307"), 307, 0);
    assert_near(stack_size("3072 B"), 3, 0);
    assert_near(stack_size("17k"), 17, 0);
    assert_near(stack_size(" 3 M "), 3072, 0);
    assert_near(stack_size("2G"), 2097152, 0);
    static const char *const none[] = {"", "many", "3X", "3 M M", "-5"};
    for (int i = 0; i < 5; i++) assert_near(stack_size(none[i]), -1, 0);
}

static void small_stacks_are_refused(void **state) {
    (void)state;
    static const struct {
        const char *size;
        int status;
    } row[] = {{"64k", STATUS_INPUT}, {"256k", STATUS_OK}, {"0", STATUS_INPUT}, {"-1", STATUS_OK}}; /* -1: no size */
    struct failure why;
    struct rlimit limit, small;
    unsetenv("GOMP_STACKSIZE");
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        setenv("OMP_STACKSIZE", row[i].size, 1);
        assert_int_equal(stack_check(&why), row[i].status);
    }
    setenv("OMP_STACKSIZE", "64k", 1);
    assert_int_equal(stack_check(&why), STATUS_INPUT);
    assert_string_equal(why.text, "OMP_STACKSIZE=64k is too small; at least 256K, or unset");
    unsetenv("OMP_STACKSIZE");
    assert_int_equal(getrlimit(RLIMIT_STACK, &limit), 0);
    small = limit;
    small.rlim_cur = 100 * 1024;
    assert_int_equal(setrlimit(RLIMIT_STACK, &small), 0);
    assert_int_equal(stack_check(&why), STATUS_INPUT);
    assert_string_equal(why.text, "a stack of 100 kB is too small; at least 256 kB: ulimit -s 256");
    assert_int_equal(setrlimit(RLIMIT_STACK, &limit), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sizes_are_read_as_openmp_does),
        cmocka_unit_test(small_stacks_are_refused),
    };
    return cmocka_run_group_tests_name("stack", tests, NULL, NULL);
}
