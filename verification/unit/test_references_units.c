/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The answer is that of the problem, not of the units it is told in: powers of 2 change no digit. */
#include "verification/unit/odd_scenes.h"

#include <float.h>
#include <string.h>

#include <gsl/gsl_errno.h>

/* What is 2^temperature times as high, 2^length times as long and takes 2^(2 length) times as long; nothing is said
 * of conductivities and heat capacities, which stay. */
struct powers {
    int temperature, length;
};

static int power_of(const char *unit, struct powers by) {
    if (strcmp(unit, "K") == 0) return by.temperature;
    if (strcmp(unit, "m") == 0) return by.length;
    if (strcmp(unit, "s") == 0) return 2 * by.length;
    if (strcmp(unit, "W/m^2/K") == 0) return -by.length;
    if (strcmp(unit, "K/s") == 0) return by.temperature - 2 * by.length;
    return 0;
}

/* got is 2^power times want, but for what underflows. */
static void assert_times(double got, double want, int power) {
    if (isinf(want))
        assert_true(isinf(got)); /* a form that would take too many terms */
    else
        assert_near(ldexp(got, -power), want, DBL_MIN * fmax(1, ldexp(1, -power)));
}

static void assert_alike(const struct scene *s, struct powers by) {
    struct problem p, q;
    struct failure why;
    odd_setup(s, &p);
    odd_setup(s, &q);
    for (int i = 0; s->params[i].name; i++) q.param[i] = ldexp(p.param[i], power_of(s->params[i].unit, by));
    if (s->setup(&q, &why)) fail_msg("%s: %s", s->name, why.text);
    unsigned long random = 23;
    for (int trial = 0; trial < 100; trial++) {
        double x[2] = {0, 0}, y[2] = {0, 0}, t = p.t_end * pow(odd_random(&random), 3);
        odd_point(&p, 0, &random, x);
        for (int d = 0; d < p.dim; d++) y[d] = ldexp(x[d], by.length);
        for (int form = 0; form < 2; form++) {
            struct exact e = form ? s->second(&p, x, t) : scene_exact(s, &p, x, t);
            struct exact f =
                form ? s->second(&q, y, ldexp(t, 2 * by.length)) : scene_exact(s, &q, y, ldexp(t, 2 * by.length));
            assert_times(f.temperature, e.temperature, by.temperature);
            assert_times(f.error_bound, e.error_bound, by.temperature);
            for (int d = 0; d < p.dim && !form; d++) {
                assert_times(f.gradient[d], e.gradient[d], by.temperature - by.length);
                assert_times(f.gradient_bound[d], e.gradient_bound[d], by.temperature - by.length);
            }
        }
    }
}

/* A bound that does not scale has a part that belongs to no temperature. */
static void temperatures_have_no_unit(void **state) {
    (void)state;
    for (int o = 0; scenes[o]; o++) {
        int given = 0;
        for (int i = 0; scenes[o]->params[i].name; i++) given += strcmp(scenes[o]->params[i].unit, "K") == 0;
        if (!given || strcmp(scenes[o]->name, "rect-manufactured") == 0)
            continue; /* about a level of 1 K, as it is */
        assert_alike(scenes[o], (struct powers){.temperature = -20});
    }
}

static void lengths_have_no_unit(void **state) {
    (void)state;
    for (int o = 0; scenes[o]; o++)
        for (int power = -7; power <= 10; power += 17) assert_alike(scenes[o], (struct powers){.length = power});
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(temperatures_have_no_unit),
        cmocka_unit_test(lengths_have_no_unit),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("references, units", tests, NULL, NULL);
}
