/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Interpolation uses the nearest points only: removing the others changes nothing. */
#include "verification/judge/interpolate.h"

#include "solver/status.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ALONG = 40, ACROSS = 40, N = ALONG * ACROSS, NEAREST = 60 };

static double centre[2];

struct place {
    double x, y, T;
};

static int nearer(const void *a, const void *b) {
    const struct place *p = a, *q = b;
    double d = hypot(p->x - centre[0], p->y - centre[1]), e = hypot(q->x - centre[0], q->y - centre[1]);
    return (d > e) - (d < e);
}

/* Value and slopes at the centre, out[0] to out[2], of the first n places. */
static void look(const struct place *p, size_t n, double out[3]) {
    double x[N], y[N], T[N];
    struct failure why;
    for (size_t i = 0; i < n; i++) x[i] = p[i].x, y[i] = p[i].y, T[i] = p[i].T;
    const struct field field = {.dim = 2, .n = n, .x = {x, y}, .T = T};
    struct interpolate f = interpolate_begin("places", &field);
    if (interpolate_at(&f, centre, &out[0], &out[1], &why)) fail_msg("%s", why.text);
    interpolate_end(&f);
}

/* Boxes as long as eight of their widths along x, then along y; the field is none that a polynomial would give. */
static void interpolation_uses_near_points_in_a_long_box(void **state) {
    (void)state;
    static const double at[][2] = {{1.3, 0.31}, {0.04, 0.47}, {2.2, 0.02}, {3.97, 0.26}};
    static struct place p[N];
    for (int turned = 0; turned < 2; turned++)
        for (int k = 0; k < 4; k++) {
            double all[3], few[3];
            for (int i = 0; i < N; i++) {
                double shift = 0.3 * sin(7.0 * i), x = 4 * (i % ALONG + 0.5 + shift) / ALONG,
                       y = 0.5 * (i / ALONG + 0.5 - shift) / ACROSS;
                p[i] = (struct place){turned ? y : x, turned ? x : y, exp(x) * sin(9 * y) + cos(40 * x * y)};
            }
            centre[0] = at[k][turned], centre[1] = at[k][1 - turned];
            look(p, N, all);
            qsort(p, N, sizeof *p, nearer);
            look(p, NEAREST, few);
            assert_memory_equal(all, few, sizeof all); /* the same points in the same order */
        }
}

/* Rows and columns at unequal distances, and points off them: the mean estimate is above the mean error, and small.
 */
static void the_estimate_is_above_the_error(void **state) {
    (void)state;
    static double x[N], y[N], T[N];
    for (int scattered = 0; scattered < 2; scattered++) {
        for (int i = 0; i < N; i++) {
            double shift = scattered ? 0.3 * sin(7.0 * i) : 0;
            x[i] = pow((i % ALONG + 0.5 + shift) / ALONG, 1.2);
            y[i] = (i / ALONG + 0.5 - shift) / ACROSS;
            T[i] = exp(x[i]) * sin(9 * y[i]);
        }
        const struct field field = {.dim = 2, .n = N, .x = {x, y}, .T = T};
        struct interpolate f = interpolate_begin("places", &field);
        interpolate_find_rows(&f);
        assert_int_equal(f.along[0], scattered ? 0 : ALONG);
        double errors = 0, estimates = 0;
        for (int k = 0; k < 50; k++) {
            const double at[] = {0.5 + 0.5 * sin(3.0 * k), 0.5 + 0.5 * cos(5.0 * k)};
            double value, off;
            struct failure why;
            if (interpolate_sure(&f, at, &value, &off, &why)) fail_msg("%s", why.text);
            errors += fabs(value - exp(at[0]) * sin(9 * at[1]));
            estimates += off;
        }
        assert_order(errors, <, estimates);
        assert_order(estimates / 50, <, 1e-4);
        interpolate_end(&f);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(interpolation_uses_near_points_in_a_long_box),
                                       cmocka_unit_test(the_estimate_is_above_the_error)};
    return cmocka_run_group_tests_name("interpolate", tests, NULL, NULL);
}
