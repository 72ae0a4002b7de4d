/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stack sizes of OMP_STACKSIZE; scripts/tests/limits.bats has the refusals. */
#include "verification/cli/stack.h"

#include "solver/status.h"

#include "verification/unit/near.h"

static void stack_sizes_follow_openmp_syntax(void **state) {
    (void)state;
    assert_near(stack_size("307"), 307, 0);
    assert_near(stack_size("3072 B"), 3, 0);
    assert_near(stack_size("17k"), 17, 0);
    assert_near(stack_size(" 3 M "), 3072, 0);
    assert_near(stack_size("2G"), 2097152, 0);
    static const char *const none[] = {"", "many", "3X", "3 M M", "-5"};
    for (int i = 0; i < 5; i++) assert_near(stack_size(none[i]), -1, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stack_sizes_follow_openmp_syntax),
    };
    return cmocka_run_group_tests_name("stack", tests, NULL, NULL);
}
