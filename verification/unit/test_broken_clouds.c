/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Clouds that a method cannot work on: each gives a refusal that names the particle, its neighbours and the condition
 * number, or a measured, finite result; never NaN. */
#include "solver/space/assembly.h"
#include "solver/method.h" /* before cmocka.h, which makes a macro of `fail` */
#include "solver/sweep/state.h"
#include "verification/stability/model_problem.h"
#include "verification/stability/spectrum.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

enum { SIDE = 13, MOST = SIDE * SIDE };

extern const struct method method_so_ssph, method_fo_ssph, method_brookshaw;

/* A hand-made cloud of spacing 1 without ghosts. */
struct made {
    struct cloud c;
    double x[MOST], y[MOST], offset[MOST];
    uint32_t source[MOST];
    double factor[MOST];
};

static void place(struct made *m, double x, double y) {
    size_t i = m->c.n++;
    m->x[i] = x, m->y[i] = y, m->source[i] = (uint32_t)i, m->factor[i] = 1;
    m->c.total = m->c.n;
}

static void empty(struct made *m) {
    *m = (struct made){.c = {.dim = 2, .volume = 1, .reach = 8}};
    m->c.x = m->x, m->c.y = m->y, m->c.offset = m->offset, m->c.source = m->source, m->c.factor = m->factor;
}

/* The particles of a square lattice but those that `left_out` says. */
static void lattice(struct made *m, int (*left_out)(int i, int j)) {
    empty(m);
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++)
            if (!left_out || !left_out(i, j)) place(m, i + 0.5, j + 0.5);
}

struct outcome {
    int status;
    struct failure why;
    double largest; /* |T| after a time of 1 */
};

/* The operator of a cloud, and 200 steps of an impulse with it. */
static struct outcome try(const struct method *method, struct made *m, double h) {
    struct outcome out = {0};
    struct model_problem b = {.method = method, .dim = 2, .n = SIDE, .options = {.dx = 1, .h = h}};
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    struct heat_operator a;
    out.status = assembly_operator(&a, &p, &b.options, method->scheme, &m->c, 1, &out.why);
    if (out.status) return out;
    double T[2][MOST] = {{0}}, *turn[2] = {T[0], T[1]}, dt = 1 / fmax(1, operator_bound(&a));
    T[0][0] = 1;
    for (int step = 0; step < 200; step++) state_update(&a, &(struct update){.rate = dt, .self = 1}, 1, turn);
    for (size_t i = 0; i < a.n; i++)
        if (!(fabs(T[0][i]) <= out.largest)) out.largest = fabs(T[0][i]);
    operator_free(&a);
    return out;
}

static void assert_refused(const struct outcome *o, const char *particle) {
    assert_int_equal(o->status, STATUS_NUMERICAL);
    if (!strstr(o->why.text, particle)) fail_msg("'%s' does not name %s", o->why.text, particle);
    assert_has(o->why.text, "neighbours");
}

static void assert_bounded(const struct outcome *o) {
    if (o->status) fail_msg("%s", o->why.text);
    assert_true(isfinite(o->largest) && o->largest <= 1 + 1e-12);
}

static int lonely(int i, int j) {
    return i > 3 && i < 9 && j > 3 && j < 9 && (i != 6 || j != 6);
}

static int hole(int i, int j) {
    return i > 4 && i < 8 && j > 4 && j < 8;
}

static void isolated_particle_is_refused(void **state) {
    (void)state;
    struct made m;
    lattice(&m, lonely);
    const struct method *all[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw};
    for (int k = 0; k < 3; k++) {
        struct outcome o = try(all[k], &m, 1.1);
        assert_refused(&o, "at (6.5, 6.5)");
        assert_has(o.why.text, "0 neighbours");
    }
}

static void collinear_neighbours_are_refused(void **state) {
    (void)state;
    struct made m;
    const double c = 0.6, s = 0.8; /* the line's direction, along no axis */
    empty(&m);
    for (int i = 0; i < SIDE; i++) place(&m, c * (i + 0.5), s * (i + 0.5));
    struct outcome so = try(&method_so_ssph, &m, 1.6), fo = try(&method_fo_ssph, &m, 1.6),
                   pair = try(&method_brookshaw, &m, 1.6);
    assert_refused(&so, "particle 0");
    assert_refused(&fo, "particle 0");
    assert_bounded(&pair);
}

/* A ninth of the spacing between nine of them, in a regular lattice. */
static void clustered_particles_stay_finite(void **state) {
    (void)state;
    struct made m;
    lattice(&m, hole);
    for (int j = -1; j < 2; j++)
        for (int i = -1; i < 2; i++) place(&m, 6.5 + i / 9.0, 6.5 + j / 9.0);
    const struct method *all[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw};
    for (int k = 0; k < 3; k++) {
        struct outcome o = try(all[k], &m, 1.6);
        if (o.status)
            assert_refused(&o, "particle");
        else
            assert_true(isfinite(o.largest));
    }
}

/* Every jitter and h/dx: refused by name, or eigenvalues that are finite. */
static void jitter_is_refused_or_measured(void **state) {
    (void)state;
    static const double h[] = {0.51, 0.72, 0.9, 1.1, 1.7, 2.9};
    int refused = 0, measured = 0;
    for (int k = 0; k < 6 * 5; k++) {
        struct model_problem b = {.method = k % 2 ? &method_so_ssph : &method_fo_ssph, .dim = 2};
        struct heat_operator a;
        struct spectrum s;
        struct failure why;
        b.options = (struct options){.h = h[k % 6], .layout = LAYOUT_JITTER, .jitter = 0.125 * (k / 6), .seed = 7};
        assert_int_equal(model_problem_resolve(&b, 12, &why), STATUS_OK);
        struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
        int status = model_problem_operator(&b, &p, &a, &why);
        if (status) {
            assert_int_equal(status, STATUS_NUMERICAL);
            assert_has(why.text, "condition number");
            refused++;
            continue;
        }
        assert_int_equal(spectrum_create(&s, &a, &(struct amplification){STEPPER_EULER, 0}, &why), STATUS_OK);
        assert_true(isfinite(s.growth) && isfinite(s.radius));
        spectrum_free(&s);
        operator_free(&a);
        measured++;
    }
    assert_order(refused, >, 0);
    assert_order(measured, >, 0);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isolated_particle_is_refused),
        cmocka_unit_test(collinear_neighbours_are_refused),
        cmocka_unit_test(clustered_particles_stay_finite),
        cmocka_unit_test(jitter_is_refused_or_measured),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
