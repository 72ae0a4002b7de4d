/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The finite differences in round bodies against what can be said of them exactly. */
#include "solver/field.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "solver/shape.h"
#include "verification/unit/near.h"

#include <string.h>

extern const struct method method_ftcs, method_ftcs_flux;

static double slope; /* K m^-2, of the bowl below */

/* 3 + slope r^2: the differences along r are exact for it, and so is the slope that they give a wall. */
static double bowl(const struct problem *p, const double x[2]) {
    (void)p;
    return 3 + slope * (x[0] * x[0] + x[1] * x[1]);
}

static double sink(const struct problem *p, const double x[2]) {
    (void)x;
    return -4 * slope * p->material[0].k[0];
}

static double into(const struct problem *p, enum side s, const double x[2]) {
    double r = hypot(x[0], x[1]), normal = s == X_HI ? 1 : -1;
    return normal * 2 * slope * r * p->material[0].k[0];
}

static double seven(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 7;
}

static double all_seven(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 7;
}

static double rough(const struct problem *p, const double x[2]) {
    (void)p;
    return 7 + sin(1e4 * x[0]) * cos(3e4 * x[1]);
}

static double rough_elsewhere(const struct problem *p, const double x[2]) {
    return rough(p, (double[2]){x[0] + 0.1, x[1]});
}

static struct problem body(double hole, enum side_kind kind) {
    struct problem p = {.dim = 2, .t_end = 3, .materials = 1, .material = {{{0.29, 0.29}, 2.385}}};
    shape_round(&p, hole, 1.3);
    p.side[X_LO] = p.side[X_HI] = kind;
    p.robin[X_LO] = p.robin[X_HI] = 0.7;
    p.initial = all_seven, p.wall = seven;
    return p;
}

static struct field solved(const struct problem *p, double spacings, double fourier) {
    struct field f;
    struct failure why = {0};
    struct options o = {.dx = (p->radius[1] - p->radius[0]) / spacings, .fourier = fourier};
    if (method_solve(&method_ftcs, p, &o, &f, &why)) fail_msg("%s", why.text);
    return f;
}

static double furthest(const struct problem *p, const struct field *f) {
    double most = 0;
    for (size_t i = 0; i < f->n; i++) most = fmax(most, fabs(f->T[i] - p->initial(p, (double[2]){f->x[i], f->y[i]})));
    return most;
}

/* Some thousand steps of a few roundings each, which the middle's long sweeps around add up: 1e-11 of T. */
static void steady_states_stay(void **state) {
    (void)state;
    for (int hole = 0; hole < 2; hole++) {
        for (enum side_kind kind = DIRICHLET; kind <= ROBIN; kind++) {
            struct problem p = body(0.4 * hole, kind);
            if (kind == NEUMANN) slope = 0, p.wall = into;
            struct field f = solved(&p, 9, 0.2);
            assert_near(furthest(&p, &f), 0, 7e-11);
            field_free(&f);
        }
        struct problem p = body(0.4 * hole, NEUMANN);
        slope = 1.7;
        p.initial = bowl, p.wall = into, p.source = sink;
        struct field f = solved(&p, 9, 0.2);
        assert_near(furthest(&p, &f), 0, 7e-11);
        field_free(&f);
    }
}

static void areas_and_heat(void **state) {
    (void)state;
    slope = 0;
    for (int hole = 0; hole < 2; hole++) {
        struct problem p = body(0.4 * hole, NEUMANN);
        double sum = 0, heat = 0;
        p.initial = rough, p.wall = into;
        struct field f = solved(&p, 9, 0.2);
        for (size_t i = 0; i < f.n; i++) sum += f.weight[i], heat += f.weight[i] * f.T[i] * p.material[0].rho_c;
        assert_near(sum, shape_volume(&p), 1e-12);
        assert_near(f.heat[1], f.heat[0], 1e-10);
        assert_near(f.heat[1], heat, 1e-10);
        field_free(&f);
    }
}

/* rho_c times the area takes up what enters: 7 W/m^2 through walls as long as they are. */
static void a_flux_enters_once(void **state) {
    (void)state;
    struct problem p = body(0.4, NEUMANN);
    struct field f = solved(&p, 9, 0.2);
    assert_near(f.heat[1] - f.heat[0], 7 * p.t_end * 2 * M_PI * (1.3 + 0.4), 1e-9);
    field_free(&f);
}

/* In the norm of the areas the difference of two runs never grows up to 1/2, whatever the data are; above it does. */
static void steps_up_to_a_half(void **state) {
    (void)state;
    for (int over = 0; over < 2; over++) {
        struct problem p = body(0, DIRICHLET), q = p;
        double before = 0, after = 0;
        p.initial = rough, q.initial = rough_elsewhere;
        p.t_end = q.t_end = 0.5;
        struct field f = solved(&p, 16, over ? 0.53 : 0.5), g = solved(&q, 16, over ? 0.53 : 0.5);
        for (size_t i = 0; i < f.n; i++) {
            double x[2] = {f.x[i], f.y[i]};
            before += f.weight[i] * pow(p.initial(&p, x) - q.initial(&q, x), 2);
            after += f.weight[i] * pow(f.T[i] - g.T[i], 2);
        }
        if (over)
            assert_order(after, >, before / 100);
        else
            assert_order(after, <, before / 100);
        field_free(&f);
        field_free(&g);
    }
    struct problem p = body(0, DIRICHLET);
    struct field f;
    struct failure why = {0};
    p.initial = rough, p.t_end = 20;
    struct options o = {.dx = 1.3 / 16, .fourier = 0.6};
    assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
    if (!strstr(why.text, "stable up to 0.5")) fail_msg("%s", why.text);
}

static void what_it_cannot_do_is_refused(void **state) {
    (void)state;
    const struct options right = {.dx = 0.13};
    struct options wrong[] = {right, right, right, right, right, right, right};
    static const char *const says[] = {
        "--layout node", "--sampling cell", "--walls fit", "--stepper rk2", "nearest: 0.1444444444 and 0.13",
        "--dx -1",       "give one of them"};
    wrong[0].layout = LAYOUT_NODE, wrong[1].sampling = SAMPLING_CELL, wrong[2].walls = WALLS_FIT;
    wrong[3].stepper = STEPPER_RK2, wrong[4].dx = 0.14, wrong[5].dx = -1, wrong[6].dt = wrong[6].fourier = 0.1;
    struct problem p = body(0, DIRICHLET);
    struct field f;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct failure why = {0};
        assert_true(method_solve(&method_ftcs, &p, &wrong[i], &f, &why));
        if (!strstr(why.text, says[i])) fail_msg("%s", why.text);
    }
    struct failure why = {0};
    assert_int_equal(method_solve(&method_ftcs_flux, &p, &right, &f, &why), STATUS_NOT_APPLICABLE);
    if (!strstr(why.text, "use ftcs")) fail_msg("%s", why.text);
    p.material[0].k[1] = 0.3;
    assert_int_equal(method_solve(&method_ftcs, &p, &right, &f, &why), STATUS_NOT_APPLICABLE);
    if (!strstr(why.text, "k_x = k_y")) fail_msg("%s", why.text);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(steady_states_stay), cmocka_unit_test(areas_and_heat),
                                       cmocka_unit_test(a_flux_enters_once), cmocka_unit_test(steps_up_to_a_half),
                                       cmocka_unit_test(what_it_cannot_do_is_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
