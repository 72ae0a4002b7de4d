/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cell-linked list against all pairs. */
#include "solver/method.h"

#include "solver/space/neighbours.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>

enum { MOST = 400 };

static int ascending(const void *a, const void *b) {
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

static size_t all_pairs(const struct cloud *c, size_t i, double radius, uint32_t *out) {
    size_t n = 0;
    for (size_t j = 0; j < c->total; j++) {
        double x[DIM_MAX], y[DIM_MAX];
        layout_cloud_place(c, i, x);
        layout_cloud_place(c, j, y);
        double r = hypot(hypot(y[0] - x[0], y[1] - x[1]), y[2] - x[2]);
        if (j != i && r < radius * (1 - 1e-9)) out[n++] = (uint32_t)j;
    }
    return n;
}

static void as_all_pairs(struct problem p, double jitter, double radius) {
    struct options o = {.dx = 0.05, .layout = LAYOUT_JITTER, .jitter = jitter, .seed = 5};
    struct failure why;
    struct lattice l;
    struct cloud c;
    struct neighbours nb;
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&p, &o, &l, 0.21, &c, &why), STATUS_OK);
    neighbours_create(&nb, &c, radius);
    for (size_t i = 0; i < c.total; i += p.dim == 3 ? 41 : 3) {
        uint32_t got[MOST], want[MOST];
        size_t n = neighbours_find(&nb, i, got, MOST), expected = all_pairs(&c, i, radius, want);
        assert_int_equal(n, expected);
        qsort(got, n, sizeof *got, ascending);
        assert_memory_equal(got, want, n * sizeof *got);
    }
    neighbours_free(&nb);
    layout_cloud_free(&c);
}

static void cell_search_equals_all_pairs(void **state) {
    (void)state;
    as_all_pairs(odd_rectangle(), 0.43, 0.117);
    as_all_pairs(odd_rectangle(), 0.43, 0.0231); /* many cells, most of them empty */
    as_all_pairs(odd_rectangle(), 0, 0.1);       /* four neighbours are on the circle: out, by rounding or not */
    as_all_pairs(odd_rod(), 0.29, 0.163);
    struct problem narrow = odd_rectangle(), flat = odd_rectangle();
    narrow.hi[0] = narrow.lo[0] + 0.3, flat.hi[1] = flat.lo[1] + 0.3;
    as_all_pairs(narrow, 0.43, 0.2); /* fewer cells along x than along y */
    as_all_pairs(flat, 0.43, 0.2);
    static const double radius[] = {0.015, 0.058, 0.11, 0.155};
    for (int k = 0; k < 4; k++) as_all_pairs(odd_box(), 0.43, radius[k]);
}

static void neighbours_without_room_are_counted(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05, .layout = LAYOUT_JITTER, .jitter = 0.17, .seed = 3};
    struct failure why;
    struct lattice l;
    struct cloud c;
    struct neighbours nb;
    uint32_t few[8] = {0}, all[MOST];
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&p, &o, &l, 0.1, &c, &why), STATUS_OK);
    neighbours_create(&nb, &c, 0.117);
    few[7] = UINT32_MAX;
    size_t n = neighbours_find(&nb, 100, all, MOST);
    assert_order(n, >, 8);
    assert_int_equal(neighbours_find(&nb, 100, few, 7), n);
    assert_memory_equal(few, all, 7 * sizeof *few);
    assert_int_equal(few[7], UINT32_MAX);
    neighbours_free(&nb);
    layout_cloud_free(&c);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cell_search_equals_all_pairs),
        cmocka_unit_test(neighbours_without_room_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
