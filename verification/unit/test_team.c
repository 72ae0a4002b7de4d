/* When a march takes threads and when it goes on alone: decided by what a look at the machine has seen. */
#include "solver/team.h"

#include "verification/unit/near.h"

#include <math.h>

static void processors_without_work_are_taken(void **state) {
    (void)state;
    struct team t = {.most = 3, .size = 1};
    team_look(&t, 0.002, 8, 0.3, 0);
    assert_int_equal(t.size, 1); /* the others are busy */
    assert_near(t.rate, 4000, 1e-9);
    team_look(&t, 0.004, 8, 0.304, 1);
    assert_int_equal(t.size, 2);
    assert_near(t.rate, 4000, 1e-9); /* one thread at its best */
    struct team many = {.most = 3, .size = 1};
    team_look(&many, 0.002, 8, 0.3, 11);
    assert_int_equal(many.size, 3); /* no more than may be used */
}

static void threads_that_do_not_pay_go_home(void **state) {
    (void)state;
    struct team t = {.most = 2, .size = 2, .rate = 1000};
    team_look(&t, 0.005, 1, 1, 0);
    assert_int_equal(t.size, 2); /* they were woken */
    assert_near(t.lost, 0.004, 1e-15);
    team_look(&t, 0.001, 1.06, 1, 0);
    assert_int_equal(t.size, 2); /* 5.7 % less time */
    team_look(&t, 0.001, 1.04, 1, 0);
    assert_int_equal(t.size, 1); /* 3.8 % are not worth a processor, but are no loss */
    assert_near(t.lost, 0.004, 1e-15);
    t.size = 2, t.before = t.lost;
    team_look(&t, 0.001, 0.3, 1, 0);
    assert_int_equal(t.size, 1);
    assert_near(t.lost, 0.0047, 1e-15);
    assert_near(t.wake, 0.004, 1e-15); /* the worst trial, which the next may be like */
}

/* One thread does 1000 a second and all of it in 2 s: 100 ms may be lost. */
static void a_trial_is_begun_where_its_loss_is_small(void **state) {
    (void)state;
    struct team unknown = {.most = 2, .size = 1, .total = 2000, .done = 20, .wake = HUGE_VAL};
    team_look(&unknown, 0.02, 20, 0.02, 1);
    assert_int_equal(unknown.size, 1); /* no thread has begun to run yet */
    for (int more = -1; more <= 1; more += 2) {
        struct team t = {.most = 2, .size = 1, .total = 2000, .done = 20, .piece = 20};
        t.lost = 0.03, t.wake = 0.05 - 0.05 * 0.03 - 0.02 + more * 1e-6; /* and two pieces of 20 ms */
        team_look(&t, 0.02, 20, 0.02, 1);
        assert_int_equal(t.size, more < 0 ? 2 : 1);
    }
    for (int more = -1; more <= 1; more += 2) { /* where nobody knows how long it will take: of what has passed */
        struct team t = {.most = 2, .size = 1, .done = 500, .piece = 5, .wake = 0.015 + more * 1e-6};
        team_look(&t, 0.02, 20, 0.5, 1);
        assert_int_equal(t.size, more < 0 ? 2 : 1);
    }
}

/* Pieces of 0.3 ms alone, which threads make `factor` times as long whenever they are tried and which wait for them
 * 2 ms at the beginning of each trial, twice what was seen: at most 1.05 times as long as alone in all, and what one
 * trial loses. */
static void a_march_is_never_much_slower(void **state) {
    (void)state;
    for (double factor = 0.5; factor < 300; factor *= 1.7)
        for (double pieces = 1; pieces < 3e5; pieces *= 3) {
            struct team t = {.most = 2, .size = 1, .total = pieces, .wake = 1e-3, .piece = 1};
            double piece = 3e-4, wait = 2e-3, wall = 0, alone = 0, most = 0;
            while (t.done < pieces) {
                int size = t.size;
                double took = size > 1 ? factor * piece + wait : piece;
                alone += piece, wall += took, wait = size > 1 ? 0 : 2e-3;
                t.done += 1;
                team_look(&t, took, 1, wall, 1);
                most = fmax(most, t.lost - t.before);
            }
            assert_true(wall <= 1.05 * alone + most);
            if (factor < 0.9 && alone > 1) assert_true(wall <= 1.02 * factor * alone);
        }
}

static void one_thread_stays_one(void **state) {
    (void)state;
    for (int most = 0; most < 2; most++) {
        struct team t = team_start(most, 1000);
        for (int k = 0; k < 1000; k++) assert_int_equal(team_size(&t, 1), 1);
        team_end(&t);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(processors_without_work_are_taken),
        cmocka_unit_test(threads_that_do_not_pay_go_home),
        cmocka_unit_test(a_trial_is_begun_where_its_loss_is_small),
        cmocka_unit_test(a_march_is_never_much_slower),
        cmocka_unit_test(one_thread_stays_one),
    };
    return cmocka_run_group_tests_name("team", tests, NULL, NULL);
}
