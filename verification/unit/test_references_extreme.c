/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values at odd and at extreme parameters, from sums, integrals and inversions in 45-digit arithmetic (mpmath 1.3),
 * each from the data of the problem and not from the form that the scene uses.  Arguments are the doubles written
 * here.  The stated bounds hold against them, and are small. */
#include "verification/unit/odd_scenes.h"

#include <string.h>

#include <gsl/gsl_errno.h>

static const struct known {
    const char *scene;
    double param[PARAM_MAX];
    double x[2], t, T;  /* m, s, K */
    double gradient[2]; /* K/m; NAN where not known */
} known[] = {
#include "verification/unit/known_extreme.inc"
};

static double scale_of(const struct scene *s, const struct problem *p) {
    double scale = 0;
    for (int i = 0; s->params[i].name; i++)
        if (strcmp(s->params[i].unit, "K") == 0) scale = fmax(scale, fabs(p->param[i]));
    return scale > 0 ? scale : 1;
}

static void setup(const struct known *k, const struct scene **s, struct problem *p) {
    struct failure why = {0};
    *s = scene_find(k->scene);
    assert_non_null(*s);
    scene_defaults(*s, p);
    memcpy(p->param, k->param, sizeof p->param);
    if ((*s)->setup(p, &why)) fail_msg("%s: %s", k->scene, why.text);
}

static void values_hold_within_their_bounds(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const struct known *k = &known[i];
        const struct scene *s;
        struct problem p;
        setup(k, &s, &p);
        struct exact e = scene_exact(s, &p, k->x, k->t), f = s->second(&p, k->x, k->t);
        double scale = scale_of(s, &p), off = fabs(e.temperature - k->T);
        if (!(off <= e.error_bound)) print_error("row %zu, %s at t = %g: off %g\n", i, k->scene, k->t, off);
        assert_near(e.temperature, k->T, e.error_bound);
        assert_near(f.temperature, k->T, f.error_bound);
        assert_order(e.error_bound, <=, 3e-13 * scale);
        for (int a = 0; a < p.dim; a++) {
            if (isnan(k->gradient[a])) continue;
            assert_near(e.gradient[a], k->gradient[a], e.gradient_bound[a]);
        }
    }
}

/* A pulse far narrower than s is small everywhere, and the bound is of its size: 3e-14 of the largest temperature. */
static void bounds_of_small_pulses_are_small(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const struct known *k = &known[i];
        const struct scene *s;
        struct problem p;
        if (strcmp(k->scene, "rod-step") && strcmp(k->scene, "square-step")) continue;
        setup(k, &s, &p);
        double peak = scene_exact(s, &p, (double[2]){0, 0}, k->t).temperature;
        assert_order(scene_exact(s, &p, k->x, k->t).error_bound, <=, 3e-14 * peak);
    }
}

/* At any time a scene has a temperature with a bound, and its second form is within the bounds, or has none.  Of
 * rod-contact only while its walls are not felt. */
static void any_time_has_its_bound(void **state) {
    (void)state;
    for (int i = 0; scenes[i]; i++) {
        const struct scene *s = scenes[i];
        struct problem p;
        struct failure why;
        scene_defaults(s, &p);
        assert_int_equal(s->setup(&p, &why), STATUS_OK);
        double x[2] = {0.31 * p.lo[0] + 0.69 * p.hi[0], 0.57 * p.lo[1] + 0.43 * p.hi[1]};
        if (p.shape) x[0] = 0.31 * p.radius[0] + 0.69 * p.radius[1]; /* and y near 0 */
        int bounded = 0;
        for (double t = 1e-310; t < 1e300; t *= 1e5) {
            if (strcmp(s->name, "rod-contact") == 0 && t > p.t_end) break;
            struct exact e = scene_exact(s, &p, x, t), f = s->second(&p, x, t);
            if (!isfinite(e.temperature) || !isfinite(e.error_bound)) fail_msg("%s, t = %g", s->name, t);
            if (!isfinite(f.error_bound)) continue;
            double apart = fabs(e.temperature - f.temperature);
            if (!(apart <= e.error_bound + f.error_bound))
                fail_msg("%s, t = %g: %g apart, bounds %g and %g", s->name, t, apart, e.error_bound, f.error_bound);
            bounded++;
        }
        assert_order(bounded, >, 0);
    }
}

/* Bounds are sums of roundings, far above most errors that they cover: what they are, at the odd parameters, after
 * parts and multiples of the end time, at a part of each extent.  Another form, or another bound, changes them.
 * Five digits are kept, to 5e-5 of each. */
static void bounds_are_kept(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        double part[2], time, bound[4]; /* of T, of its gradient along x and y, of the second form */
    } kept[] = {
#include "verification/unit/known_bounds.inc"
    };
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++) {
        struct problem p;
        const struct scene *s = odd_find(kept[i].scene, &p);
        double x[2], t = kept[i].time * p.t_end;
        for (int a = 0; a < 2; a++) x[a] = p.lo[a] + kept[i].part[a] * (p.hi[a] - p.lo[a]);
        double r = p.radius[0] + kept[i].part[0] * (p.radius[1] - p.radius[0]);
        if (p.shape) x[0] = 0.8 * r, x[1] = 0.6 * r;
        struct exact e = scene_exact(s, &p, x, t), f = s->second(&p, x, t);
        const double bound[] = {e.error_bound, e.gradient_bound[0], e.gradient_bound[1], f.error_bound};
        for (int k = 0; k < 4; k++)
            if (bound[k] != kept[i].bound[k] && !(fabs(bound[k] / kept[i].bound[k] - 1) < 1e-4))
                fail_msg("%s, row %zu: bound %d is %.5g, was %.5g", s->name, i, k, bound[k], kept[i].bound[k]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_hold_within_their_bounds),
        cmocka_unit_test(any_time_has_its_bound),
        cmocka_unit_test(bounds_are_kept),
        cmocka_unit_test(bounds_of_small_pulses_are_small),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("references, extreme values", tests, NULL, NULL);
}
