/* When a march takes threads and when it goes on alone: decided by what a look at the machine has seen. */
#include "solver/team.h"

#include "verification/unit/near.h"

static void processors_without_work_are_taken(void **state) {
    (void)state;
    struct team t = {.most = 3, .size = 1};
    team_look(&t, 0.002, 8, 0.3, 0);
    assert_int_equal(t.size, 1); /* the others are busy */
    assert_near(t.rate, 4000, 1e-9);
    team_look(&t, 0.004, 8, 0.304, 1);
    assert_int_equal(t.size, 2);
    assert_near(t.rate, 2000, 1e-9); /* the last look counts */
    struct team many = {.most = 3, .size = 1};
    team_look(&many, 0.002, 8, 0.3, 11);
    assert_int_equal(many.size, 3); /* no more than may be used */
}

static void threads_that_do_not_pay_go_home(void **state) {
    (void)state;
    struct team t = {.most = 2, .size = 2, .rate = 1000};
    team_look(&t, 0.001, 1.12, 1, 0);
    assert_int_equal(t.size, 2); /* 12 % faster */
    team_look(&t, 0.001, 1.08, 1, 0);
    assert_int_equal(t.size, 1); /* 8 % is not worth a processor, but is no loss */
    assert_near(t.lost, 0, 0);
    t.size = 2;
    team_look(&t, 0.001, 0.3, 1, 0);
    assert_int_equal(t.size, 1);
    assert_near(t.lost, 0.0007, 1e-15);
}

static void losses_are_made_up_first(void **state) {
    (void)state;
    struct team t = {.most = 2, .size = 1, .lost = 0.0005};
    team_look(&t, 0.001, 1, 0.2099, 1);
    assert_int_equal(t.size, 1);
    team_look(&t, 0.001, 1, 0.2101, 1); /* 5 % of the time since the beginning: this, and 10 ms that it may lose */
    assert_int_equal(t.size, 2);
}

/* Stretches of 0.3 ms alone, which threads make `factor` times as long whenever they are tried: never 1.1 times in
 * all, once 20 of the first losses have passed. */
static void a_march_is_never_much_slower(void **state) {
    (void)state;
    for (double factor = 0.5; factor < 300; factor *= 1.7) {
        struct team t = {.most = 2, .size = 1};
        double stretch = 3e-4, wall = 0, alone = 0;
        while (alone < 25 * factor * stretch || alone < 20) {
            double took = t.size > 1 ? factor * stretch : stretch;
            alone += stretch, wall += took;
            team_look(&t, took, 1, wall, 1);
        }
        assert_true(wall <= 1.1 * alone);
        if (factor < 0.9) assert_true(wall <= 1.02 * factor * alone);
    }
}

static void one_thread_stays_one(void **state) {
    (void)state;
    for (int most = 0; most < 2; most++) {
        struct team t = team_start(most);
        for (int k = 0; k < 1000; k++) assert_int_equal(team_size(&t, 1), 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(processors_without_work_are_taken),
        cmocka_unit_test(threads_that_do_not_pay_go_home),
        cmocka_unit_test(losses_are_made_up_first),
        cmocka_unit_test(a_march_is_never_much_slower),
        cmocka_unit_test(one_thread_stays_one),
    };
    return cmocka_run_group_tests_name("team", tests, NULL, NULL);
}
