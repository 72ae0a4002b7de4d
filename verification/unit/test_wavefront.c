/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several updates in one sweep: each unit has each update once, when what it reads is there and not yet written over.
 */
#include "solver/sweep/wavefront.h"

#include "verification/unit/near.h"

enum { UNITS = 97, UPDATES = 19 };

struct record {
    int lag, wrong;
    int done[UNITS]; /* updates that a unit has had */
};

/* Two states in turn: update k reads what update k - 1 left of the units within the lag, which update k + 1 replaces.
 */
static void advance(const void *what, int k, ptrdiff_t lo, ptrdiff_t hi) {
    struct record *r = *(struct record *const *)what;
    for (ptrdiff_t i = lo; i < hi; i++) {
        for (ptrdiff_t j = i - r->lag; j <= i + r->lag; j++)
            if (j >= 0 && j < UNITS && (r->done[j] < k || r->done[j] > k + 1)) r->wrong++;
        if (i < 0 || i >= UNITS || r->done[i]++ != k) r->wrong++;
    }
}

static void every_unit_has_every_update_in_turn(void **state) {
    (void)state;
    for (int lag = 0; lag <= 4; lag += 2)
        for (int band = 1; band <= 8; band += 7)
            for (int together = 1; together <= 8; together += 7)
                for (int threads = 1; threads <= 3; threads++) {
                    struct record r = {.lag = lag}, *kept = &r;
                    struct wavefront w = {advance, &kept, UNITS, lag, band, together, threads};
                    wavefront_sweep(&w, 0);
                    wavefront_sweep(&w, UPDATES);
                    assert_int_equal(r.wrong, 0);
                    for (int i = 0; i < UNITS; i++) assert_int_equal(r.done[i], UPDATES);
                }
}

/* The fourth part of the smallest number that is held in full, of each unit in its last update. */
static void quarter(const void *what, int k, ptrdiff_t lo, ptrdiff_t hi) {
    volatile double least = 2.3e-308;
    double *const *part = what;
    (void)k;
    for (ptrdiff_t i = lo; i < hi; i++) (*part)[i] = least / 4;
}

static void what_no_temperature_needs_is_zero(void **state) {
    (void)state;
#ifdef __SSE2__
    for (int threads = 1; threads <= 3; threads++) {
        double part[UNITS], *parts = part, after;
        volatile double least = 2.3e-308;
        for (int i = 0; i < UNITS; i++) part[i] = 1;
        struct wavefront w = {quarter, &parts, UNITS, 2, 8, 8, threads};
        wavefront_sweep(&w, UPDATES);
        for (int i = 0; i < UNITS; i++) assert_true(part[i] == 0);
        after = least / 4;
        assert_order(after, >, 0); /* in a sweep alone */
    }
#else
    skip();
#endif
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_unit_has_every_update_in_turn),
                                       cmocka_unit_test(what_no_temperature_needs_is_zero)};
    return cmocka_run_group_tests_name("wavefront", tests, NULL, NULL);
}
