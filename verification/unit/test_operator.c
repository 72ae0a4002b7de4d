/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The discrete operator: its exact derivatives, the agreement of its two forms, the exact stepper compared with
 * small steps, and the conservation of heat in every method. */
#include "solver/time/matched.h"

extern const struct method method_so_ssph, method_fo_ssph;

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

static struct options odd_options(void) {
    return (struct options){.dx = 0.05, .h = 1.23, .seed = 7};
}

static void run(const char *name, struct problem p, struct options o, struct field *f) {
    struct failure why = {0};
    const struct method *m = method_find(name);
    if (method_solve(m, &p, &o, f, &why)) print_error("%s\n", why.text);
    assert_int_equal(why.status, STATUS_OK);
}

/* The value of *f at its particle nearest to x; every layout of the test has one within rounding. */
static double value_at(const struct field *f, const double *x) {
    size_t best = 0;
    double least = HUGE_VAL;
    for (size_t i = 0; i < f->n; i++) {
        double at[DIM_MAX];
        field_place(f, i, at);
        double d = hypot(at[0] - x[0], at[1] - x[1]);
        if (d < least) least = d, best = i;
    }
    assert_near(least, 0, 1e-9);
    return f->T[best];
}

/* Ghosts and stencil against CSR rows with the ghosts eliminated: two ways through the same equations. */
static void csr_rows_equal_the_stencil(void **state) {
    (void)state;
    const char *names[] = {"so_ssph", "fo_ssph"};
    for (int walls = 0; walls < 2; walls++)
        for (int m = 0; m < 2; m++) {
            struct options o = odd_options(), r = o;
            struct field a, b;
            double x[DIM_MAX];
            o.walls = r.walls = (enum walls)walls;
            o.stepper = r.stepper = STEPPER_EULER;
            o.fourier = r.fourier = 0.07;
            r.layout = LAYOUT_JITTER;
            run(names[m], odd_rectangle(), o, &a);
            run(names[m], odd_rectangle(), r, &b);
            for (size_t i = 0; i < a.n; i += 17) assert_near(value_at(&b, field_place(&a, i, x)), a.T[i], 1e-12);
            field_free(&a);
            field_free(&b);
        }
}

static void exact_stepper_is_the_limit_of_small_steps(void **state) {
    (void)state;
    for (int layout = 0; layout < 2; layout++)
        for (int sides = 0; sides < 16; sides++) {
            struct problem p = odd_rectangle();
            struct options o = odd_options();
            struct field a, b;
            for (int s = 0; s < 4; s++) p.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
            o.layout = (enum layout_name)layout;
            o.stepper = STEPPER_EXACT;
            run("so_ssph", p, o, &a);
            o.stepper = STEPPER_RKL2, o.dt = p.t_end / 400;
            run("so_ssph", p, o, &b);
            for (size_t i = 0; i < a.n; i++) assert_near(b.T[i], a.T[i], 2e-5); /* O(dt^2), measured 9e-6 */
            field_free(&b);
            o.stepper = STEPPER_CHEBYSHEV;
            for (int steps = 1; steps < 8; steps += 6) { /* no time error in one step or seven */
                o.dt = p.t_end / steps;
                run("so_ssph", p, o, &b);
                assert_int_equal(b.steps, steps);
                for (size_t i = 0; i < a.n; i++) assert_near(b.T[i], a.T[i], 1e-11);
                field_free(&b);
            }
            field_free(&a);
        }
}

static void singular_supports_are_named(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = odd_options();
    struct field f;
    struct failure why;
    o.h = 0.6; /* no diagonal neighbours: T_xy has nothing to be seen by */
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_NUMERICAL);
    assert_has(why.text, "4 neighbours");
    assert_has(why.text, "condition number");
    o.h = 0.75, o.kernel = KERNEL_QUARTIC; /* diagonal neighbours at s = 1.886, where it is negative */
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_NUMERICAL);
    assert_has(why.text, "indefinite moment matrix");
    assert_has(why.text, "negative at 4 of them");
    assert_lacks(why.text, "infinite");
    o.kernel = KERNEL_CUBIC;
    o.h = 0.45; /* no neighbours at all */
    assert_int_equal(method_solve(&method_fo_ssph, &p, &o, &f, &why), STATUS_NUMERICAL);
    assert_has(why.text, "0 neighbours");
}

static void unstable_runs_report_place_and_time(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = odd_options();
    struct field f;
    struct failure why;
    p.t_end = 0.3;
    o.stepper = STEPPER_EULER, o.fourier = 0.9;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_UNSTABLE);
    assert_has(why.text, "unstable: at step");
    assert_has(why.text, "particle");
}

/* There is room for 1024: squares of 31 but not 33 points, lines of 1023 but not 1025. */
static void neighbour_limit_is_enforced(void **state) {
    (void)state;
    static double d[NEIGHBOURS_MAX][DIM_MAX];
    struct neighbourhood nb;
    struct failure why;
    const double most[] = {256, 8};
    for (int dim = 1; dim <= 2; dim++) {
        assert_int_equal(operator_neighbourhood(dim, 0.1, most[dim - 1], d, &nb, &why), STATUS_OK);
        if (dim == 1) assert_int_equal(nb.n, 1022);
        assert_int_equal(operator_neighbourhood(dim, 0.1, 1.001 * most[dim - 1], d, &nb, &why), STATUS_INPUT);
    }
}

static void matched_run_needs_isotropy(void **state) {
    (void)state;
    struct options o = {.kernel = KERNEL_CUBIC};
    struct symbol_error e;
    struct failure why;
    double h;
    assert_int_equal(matched_isotropic(2, &o, method_so_ssph.scheme, &h, &why), STATUS_OK);
    o.h = h;
    assert_int_equal(matched_symbol(2, &o, method_so_ssph.scheme, &e, &why), STATUS_OK);
    assert_near(e.B, 2 * e.A, 1e-12);
    o.h = 1.1; /* --h that is not isotropic has no matching step in the plane */
    o.stepper = STEPPER_MATCHED, o.dx = 0.05, o.sampling = SAMPLING_CELL;
    struct problem p = odd_rectangle();
    p.material[0].k[1] = p.material[0].k[0];
    struct field f;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "--h iso");
    o.order = 4; /* nor has order 4, at any --h */
    assert_int_equal(matched_isotropic(2, &o, method_so_ssph.scheme, &h, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "--order 4");
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(csr_rows_equal_the_stencil),  cmocka_unit_test(exact_stepper_is_the_limit_of_small_steps),
        cmocka_unit_test(singular_supports_are_named), cmocka_unit_test(unstable_runs_report_place_and_time),
        cmocka_unit_test(neighbour_limit_is_enforced), cmocka_unit_test(matched_run_needs_isotropy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
