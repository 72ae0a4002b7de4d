/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With x and y exchanged a method gives the same field, exchanged: for all 16 kinds of sides, every layout, sampling
 * and stepper, on a box whose extents, places and conductivities all differ. */
#include "solver/method.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

extern const struct method method_so_ssph, method_fo_ssph, method_brookshaw, method_ftcs, method_ftcs_flux;

static struct problem upright;

/* Jumps along x, meets the walls of x and not those of y. */
static double uneven(const struct problem *p, const double x[2]) {
    double far = (x[0] - p->lo[0]) * (p->hi[0] - x[0]);
    return 0.3 + (x[0] < 0.4 ? 1 : 0.4) * far * (1.1 + sin(1.3 * x[1]));
}

static double uneven_wall(const struct problem *p, enum side s, const double x[2]) {
    if (p->side[s] == NEUMANN) return 0.21 * (1 + (int)s) * (0.2 + x[1 - (int)s / 2]);
    return s < Y_LO ? 0.3 : 0.9 - 0.3 * x[0] + 0.1 * s;
}

static double uneven_source(const struct problem *p, const double x[2]) {
    return 0.31 * (x[0] - p->lo[0]) + 0.83 * x[1] * x[1];
}

static double across(const struct problem *p, const double x[2]) {
    (void)p;
    return uneven(&upright, (const double[]){x[1], x[0]});
}

static double across_wall(const struct problem *p, enum side s, const double x[2]) {
    (void)p;
    return uneven_wall(&upright, (enum side)((s + 2) % 4), (const double[]){x[1], x[0]});
}

static double across_source(const struct problem *p, const double x[2]) {
    (void)p;
    return uneven_source(&upright, (const double[]){x[1], x[0]});
}

static void exchanges(const struct method *m, int sides, struct options o) {
    struct field f, g;
    struct failure why;
    char what[160];
    snprintf(what, sizeof what, "%s, sides %d, layout %d, sampling %d, stepper %d", m->name, sides, o.layout,
             o.sampling, o.stepper);
    upright = odd_rectangle();
    upright.initial = uneven, upright.wall = uneven_wall, upright.source = uneven_source;
    upright.jumps[0] = 1, upright.jump[0][0] = 0.4;
    if (strcmp(m->name, "brookshaw") == 0) upright.material[0].k[1] = upright.material[0].k[0];
    for (int s = 0; s < 4; s++) upright.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
    struct problem lying = upright;
    lying.initial = across, lying.wall = across_wall, lying.source = across_source;
    for (int a = 0; a < 2; a++) {
        lying.lo[a] = upright.lo[1 - a], lying.hi[a] = upright.hi[1 - a];
        lying.material[0].k[a] = upright.material[0].k[1 - a];
        lying.jumps[a] = upright.jumps[1 - a], lying.jump[a][0] = upright.jump[1 - a][0];
        for (int hi = 0; hi < 2; hi++) lying.side[2 * a + hi] = upright.side[2 * (1 - a) + hi];
    }
    if (method_solve(m, &upright, &o, &f, &why) || method_solve(m, &lying, &o, &g, &why))
        fail_msg("%s: %s", what, why.text);
    assert_int_equal(f.shape[0], g.shape[1]);
    assert_int_equal(f.shape[1], g.shape[0]);
    for (int j = 0; j < f.shape[1]; j++)
        for (int i = 0; i < f.shape[0]; i++) {
            size_t k = (size_t)j * (size_t)f.shape[0] + (size_t)i, l = (size_t)i * (size_t)g.shape[0] + (size_t)j;
            if (!(fabs(f.T[k] - g.T[l]) < 1e-11)) fail_msg("%s: %.17g and %.17g K", what, f.T[k], g.T[l]);
        }
    field_free(&f);
    field_free(&g);
}

static void axes_can_be_exchanged(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw, &method_ftcs,
                                        &method_ftcs_flux};
    static const enum sampling samplings[] = {SAMPLING_POINT, SAMPLING_CELL, SAMPLING_SPLINE};
    static const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_EXACT, STEPPER_RKL2};
    for (int m = 0; m < 5; m++)
        for (int sides = 0; sides < 16; sides++)
            for (int layout = 0; layout < 2; layout++)
                for (int sampling = 0; sampling < 3; sampling++)
                    for (int stepper = 0; stepper < (m < 3 ? 3 : 1); stepper++) {
                        struct options o = {.dx = 0.075, .h = 1.23, .stepper = steppers[stepper]};
                        o.layout = layout ? LAYOUT_NODE : LAYOUT_LATTICE;
                        o.sampling = samplings[sampling];
                        o.fourier = o.stepper == STEPPER_EXACT ? 0 : o.stepper == STEPPER_RKL2 ? 0.7 : 0.07;
                        exchanges(all[m], sides, o);
                    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {cmocka_unit_test(axes_can_be_exchanged)};
    return cmocka_run_group_tests_name("exchanged_axes", tests, NULL, NULL);
}
