/* When a march takes threads and when it goes on alone: decided by what a look at the machine has seen. */
#include "solver/team.h"

#include "verification/unit/near.h"

static void processors_without_work_are_taken(void **state) {
    (void)state;
    struct team t = {.most = 3, .size = 1};
    team_look(&t, 0.0021, 0.0021, 0);
    assert_int_equal(t.size, 1); /* the others are busy */
    team_look(&t, 0.0021, 0.0021, 1);
    assert_int_equal(t.size, 2);
    struct team many = {.most = 3, .size = 1};
    team_look(&many, 0.0021, 0.0021, 11);
    assert_int_equal(many.size, 3); /* no more than may be used */
}

static void a_busy_machine_sends_threads_home(void **state) {
    (void)state;
    struct team t = {.most = 2, .size = 2};
    team_look(&t, 0.0034, 0.0065, 0); /* 96 % of two processors: together */
    assert_int_equal(t.size, 2);
    team_look(&t, 0.0034, 0.0051, 0); /* 75 % */
    assert_int_equal(t.size, 1);
}

/* Each refusal in a row is followed by twice as many looks alone; one stretch that went well ends that. */
static void refusals_are_remembered(void **state) {
    (void)state;
    struct team t = {.most = 2, .size = 2};
    for (int refusal = 0, wait = 1; refusal < 8; refusal++, wait = wait < 64 ? 2 * wait : 64) {
        int looks = 0;
        team_look(&t, 0.0034, 0.0035, 0);
        assert_int_equal(t.size, 1);
        while (t.size == 1) team_look(&t, 0.0023, 0.0023, 1), looks++;
        assert_int_equal(looks, wait + 1);
    }
    team_look(&t, 0.0034, 0.0067, 0);
    assert_int_equal(t.size, 2);
    team_look(&t, 0.0034, 0.0035, 0);
    team_look(&t, 0.0023, 0.0023, 1);
    team_look(&t, 0.0023, 0.0023, 1);
    assert_int_equal(t.size, 2);
}

static void one_thread_stays_one(void **state) {
    (void)state;
    for (int most = 0; most < 2; most++) {
        struct team t = team_start(most);
        for (int k = 0; k < 1000; k++) assert_int_equal(team_size(&t), 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(processors_without_work_are_taken),
        cmocka_unit_test(a_busy_machine_sends_threads_home),
        cmocka_unit_test(refusals_are_remembered),
        cmocka_unit_test(one_thread_stays_one),
    };
    return cmocka_run_group_tests_name("team", tests, NULL, NULL);
}
