/* The error of derivative weights is made of the neighbours that there are. */
#include "verification/ladder/consistency.h"

#include "solver/space/operator.h"
#include "verification/command/arguments.h"

#include "verification/unit/near.h"

/* Leaves what is not a number where the next function has its arrays. */
static double __attribute__((noinline)) spoil(void) {
    volatile double at[16 * NEIGHBOURS_MAX];
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) at[i] = NAN;
    return at[7];
}

static void what_lies_behind_the_last_neighbour_is_not_read(void **state) {
    (void)state;
    static const char *const lines[] = {"run rod-gauss so_ssph --dx 0.1", "run square-step fo_ssph --dx 0.1"};
    for (int k = 0; k < 2; k++) {
        struct request r;
        struct failure why;
        double error;
        if (arguments_parse_line(lines[k], &r, &why)) fail_msg("%s", why.text);
        assert_true(isnan(spoil()));
        assert_int_equal(consistency_error(&r.experiment, &error, &why), STATUS_OK);
        assert_true(error > 0 && error < 0.1); /* of second order: dx^2 b^4 over 12 and more, b = 1.1 m^-1 */
        arguments_free(&r);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_lies_behind_the_last_neighbour_is_not_read),
    };
    return cmocka_run_group_tests_name("consistency", tests, NULL, NULL);
}
