/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two points at one place, among points in rows, in columns and in no order: found wherever all pairs have some. */
#include "verification/foreign/points_checks.h"

#include "solver/problem.h"
#include "solver/status.h"
#include "verification/foreign/samples.h"

#include "verification/unit/near.h"

#include <gsl/gsl_rng.h>
#include <stdio.h>

enum { MOST = 200, DRAWS = 4000 };
static double at_x[MOST], at_y[MOST];

/* 2 m by half a metre: a point is the same within 2 nm along x and half a nanometre along y. */
static const struct problem body = {.dim = 2, .lo = {0.25, -1}, .hi = {2.25, -0.5}};
static const double nearest[2] = {2e-9, 0.5e-9};

static int is_pair(const struct samples *s, int i, int j) {
    for (int a = 0; a < s->dim; a++)
        if (fabs(s->value[a][i] - s->value[a][j]) > nearest[a]) return 0;
    return 1;
}

/* What all pairs say; where there are some, the two lines of the message are of one. */
static int compare(int dim, int n) {
    struct problem p = body;
    struct samples s = {.path = "file", .dim = dim, .n = (size_t)n, .value = {at_x, at_y}};
    struct failure why = {0};
    int pairs = 0, second = 0, first = 0;
    p.dim = dim;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) pairs += is_pair(&s, i, j);
    assert_int_equal(same_points_check(&s, &p, &why), pairs ? STATUS_INPUT : STATUS_OK);
    if (!pairs) return 0;
    if (sscanf(why.text, "file, line %d: the same point as in line %d", &second, &first) != 2)
        fail_msg("%s", why.text);
    assert_true(first < second && is_pair(&s, first - 1, second - 1));
    return 1;
}

/* Places in distances: in boxes of 64, at and beside their sides.  No two are just one distance apart. */
static double place(gsl_rng *r, int a) {
    static const double within[] = {0, 0.37, 0.81, 1.23, 7.5, 63.2, 63.66};
    return body.lo[a] + nearest[a] * (64.0 * (double)gsl_rng_uniform_int(r, 4) + within[gsl_rng_uniform_int(r, 7)]);
}

static void points_in_no_order(void **state) {
    (void)state;
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    int found[2] = {0, 0};
    for (int k = 0; k < DRAWS; k++) {
        int dim = 1 + k % 2, n = 2 + (int)gsl_rng_uniform_int(r, dim == 2 ? 24 : 6);
        for (int i = 0; i < n; i++) at_x[i] = place(r, 0), at_y[i] = place(r, 1);
        found[dim - 1] += compare(dim, n);
    }
    for (int d = 0; d < 2; d++) { /* both happen */
        assert_order(found[d], >, DRAWS / 8);
        assert_order(found[d], <, DRAWS * 3 / 8);
    }
    gsl_rng_free(r);
}

/* Many points at places of their own but for one of them, which takes the place of any other. */
static void one_pair_among_many(void **state) {
    (void)state;
    for (int k = 0; k < MOST; k++) {
        for (int i = 0; i < MOST; i++) {
            int at = 77 * i % 211; /* all apart, in no order */
            at_x[i] = body.lo[0] + 0.01 * (at % 15), at_y[i] = body.lo[1] + 0.01 * (at / 15.0);
        }
        assert_int_equal(compare(2, MOST), 0);
        int other = (k + 1 + 31 * k % (MOST - 1)) % MOST;
        at_x[k] = at_x[other], at_y[k] = at_y[other];
        assert_int_equal(compare(2, MOST), 1);
    }
}

/* Rows whose points stray by a tenth of a distance, a few by more; their steps are now and then below one. */
static void points_in_rows_and_columns(void **state) {
    (void)state;
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    int found[2] = {0, 0};
    for (int k = 0; k < DRAWS; k++) {
        int rows = k % 2, n = 0;
        double *along = rows ? at_x : at_y, *across = rows ? at_y : at_x, width = nearest[rows],
               length = nearest[!rows];
        double row = body.lo[rows];
        for (int j = 0; j < 5; j++, row += width * (gsl_rng_uniform_int(r, 12) ? 2.2 : 0.6)) {
            double x = body.lo[!rows];
            for (int i = 0; i < 6; i++, n++) {
                x += length * (gsl_rng_uniform_int(r, 40) ? 1.5 : gsl_rng_uniform_int(r, 2) ? 0.6 : -1.2);
                along[n] = x, across[n] = row + width * (gsl_rng_uniform_int(r, 60) ? 0.1 * gsl_rng_uniform(r) : 1.5);
            }
        }
        found[rows] += compare(2, n);
    }
    for (int d = 0; d < 2; d++) {
        assert_order(found[d], >, DRAWS / 8);
        assert_order(found[d], <, DRAWS * 7 / 16);
    }
    gsl_rng_free(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_in_no_order),
        cmocka_unit_test(one_pair_among_many),
        cmocka_unit_test(points_in_rows_and_columns),
    };
    return cmocka_run_group_tests_name("same points", tests, NULL, NULL);
}
