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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_unit_has_every_update_in_turn)};
    return cmocka_run_group_tests_name("wavefront", tests, NULL, NULL);
}
