/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Invalid parameters are refused with a sentence that names the option and its valid values. */
#include "verification/unit/odd_scenes.h"

#include <stdio.h>
#include <string.h>

#include <gsl/gsl_errno.h>

static int index_of(const struct scene *s, const char *name) {
    for (int i = 0; s->params[i].name; i++)
        if (strcmp(s->params[i].name, name) == 0) return i;
    fail_msg("%s has no parameter %s", s->name, name);
    return -1;
}

static const struct refusal {
    const char *scene, *param;
    double value;
    const char *valid; /* part of the expected refusal */
} refusals[] = {
    {"rod-step", "a", 2.5, "between 0 and 2 m"},
    {"rod-step", "a", 2, "a < L"},
    {"rod-step", "kappa", -0.02, "greater than 0 m^2/s"},
    {"rod-gauss", "sigma0", 15.5, "sigma0 < L"},
    {"square-step", "b", 2.1, "b < L"},
    {"plate", "height", 1000, "times the width"},
    {"plate", "material", 0.5, "steel, titanium or vanadium"},
    {"plate", "T3", INFINITY, "finite"},
    {"plate", "T0", NAN, "finite"},
    {"rod-contact", "t_end", 2.5, "D = L - |x_c| = 1 m and k1/rho_c1 = 0.005 m^2/s"},
    {"plane-contact", "mode", 21, "whole number from 0 to 20"},
    {"plane-contact", "A", 2.5, "A < Tm"},
    {"plane-contact", "k2", 3e4, "within a factor of 1e6"},
    {"wall-composite", "x_c", 1.4, "between 0 and 1 m"},
    {"wall-composite", "T1", 0, "T2"},
    {"rod-cosine", "mode", 2.5, "whole number from 1 to 32"},
    {"rod-cosine", "A", 1.5, "A < Tm"},
    {"rod-driven", "A", 2, "A < Tm"},
    {"rod-driven", "omega", 0, "greater than 0 1/s"},
    {"plate-driven", "phase_a", 200, "between -100 and 100"},
    {"plate-driven", "Tm", 1.3, "the sum of the amplitudes: T > 0"},
    {"rect-manufactured", "A", 1.5, "from 0 to 1 K: the temperature stays positive, 0 < A <= 1"},
    {"cube-step", "c", 2.1, "the brick ends before the walls"},
    {"box-cosine", "mode_z", 13, "whole number from 0 to 12"},
    {"oblique", "k_xy", -0.01, "between -0.01 and 0.01 W/(m K) that is not 0"},
    {"oblique", "mode_x", 0.5, "whole number from 1 to 32"},
    {"wave", "mode_z", -1, "whole number from 0 to 32"},
    {"box-manufactured", "b", 0, "greater than 0"},
    {"box-contact", "mode_z", 21, "whole number from 0 to 20"},
    {"ball-cooling", "b", 1e11, "b radius/k of 1e-12 to 1e12"},
    {"ball-mode", "m", 3, "whole number from 0 to 2"},
    {"front", "n", 2.5, "whole number from 1 to 6"},
    {"front", "k_0", 1e250, "temperature from 1e-30 to 1e30 K"},
    {"wall-kirchhoff", "beta", -2, "k = k_0 (1 + beta (T - T_ref)) > 0 from 0.5 to 1.8 K"},
    {"wall-kirchhoff", "T1", 0.5, "other than T2=0.5"},
    {"plate-kirchhoff", "A", -0.1, "0 K or more"},
    {"rect-manufactured", "rise", -0.1, "0 K/s or more"},
};

static void bad_values_are_refused(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
        const struct refusal *r = &refusals[i];
        const struct scene *s = scene_find(r->scene);
        struct problem p;
        struct failure why = {0};
        char option[64];
        scene_defaults(s, &p);
        p.param[index_of(s, r->param)] = r->value;
        assert_int_equal(s->setup(&p, &why), STATUS_INPUT);
        assert_int_equal(why.status, STATUS_INPUT);
        snprintf(option, sizeof option, "--set %s=%g: needs ", r->param, r->value);
        if (strncmp(why.text, option, strlen(option)) != 0 || !strstr(why.text, r->valid))
            fail_msg("\"%s\" lacks \"%s\" or \"%s\"", why.text, option, r->valid);
    }
}

/* The refusal names the material that sets the limit. */
static void the_faster_half_rod_is_named(void **state) {
    (void)state;
    const struct scene *s = scene_find("rod-contact");
    struct problem p;
    struct failure why = {0};
    scene_defaults(s, &p);
    p.param[index_of(s, "k2")] = 0.02;
    assert_int_equal(s->setup(&p, &why), STATUS_INPUT);
    if (!strstr(why.text, "D = L - |x_c| = 1 m and k2/rho_c2 = 0.04 m^2/s")) fail_msg("\"%s\"", why.text);
}

/* Both ends of "needs ... to ..." are valid. */
static void range_ends_are_valid(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        double most; /* largest height/width, and width/height */
    } plates[] = {{"plate", 1000}, {"plate-cooling", 10}};
    for (int k = 0; k < 4; k++) {
        const struct scene *s = scene_find(plates[k / 2].scene);
        struct problem p;
        struct failure why = {0};
        double *height = &p.param[index_of(s, "height")], width = 0.25;
        scene_defaults(s, &p);
        p.param[index_of(s, "width")] = width;
        *height = k % 2 ? width * plates[k / 2].most : width / plates[k / 2].most;
        if (s->setup(&p, &why)) fail_msg("%s: %s", s->name, why.text);
        *height *= k % 2 ? 1.001 : 0.999;
        assert_int_equal(s->setup(&p, &why), STATUS_INPUT);
    }
}

/* A setup overwrites all of an earlier one. */
static void setup_overwrites_every_field(void **state) {
    (void)state;
    struct problem p, q;
    struct failure why;
    const struct scene *s = scene_find("rod-gauss");
    scene_defaults(s, &p);
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    memset(&q, 0x5a, sizeof q);
    memcpy(q.param, p.param, sizeof q.param);
    assert_int_equal(s->setup(&q, &why), STATUS_OK);
    assert_int_equal(q.jumps[0], 0);
    assert_int_equal(q.jumps[1], 0);
    assert_int_equal(q.mirror[1], 0);
    assert_true(q.source == NULL);
    assert_true(q.lo[1] == 0 && q.hi[1] == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_values_are_refused),
        cmocka_unit_test(the_faster_half_rod_is_named),
        cmocka_unit_test(range_ends_are_valid),
        cmocka_unit_test(setup_overwrites_every_field),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("references, parameters", tests, NULL, NULL);
}
