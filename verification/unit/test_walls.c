/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls of higher order, in every method: a steady cubic stays, corners included; and a matched run with a source is
 * of fourth order. */
#include "solver/method.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <string.h>

extern const struct method method_so_ssph, method_fo_ssph, method_brookshaw, method_ftcs, method_ftcs_flux;

static const double PI = 3.14159265358979323846;

static double farthest(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f;
    struct failure why;
    double most = 0;
    if (method_solve(m, p, o, &f, &why)) fail_msg("%s: %s", m->name, why.text);
    for (size_t i = 0; i < f.n; i++) {
        double x[2] = {f.x[i], f.y ? f.y[i] : 0};
        most = fmax(most, fabs(f.T[i] - p->initial(p, x)));
    }
    field_free(&f);
    return most;
}

/* Central differences, moments to order 2 and first derivatives taken twice are exact for a cubic. */
static void a_steady_cubic_stays(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw, &method_ftcs,
                                        &method_ftcs_flux};
    for (int kinds = 0; kinds < 16; kinds++)
        for (int m = 0; m < 5; m++)
            for (int node = 0; node < 2; node++)
                for (int dim = 1; dim < 3; dim++) {
                    struct problem p = dim == 1 ? odd_rod() : odd_rectangle();
                    struct options o = {.dx = 0.05, .fourier = 0.11, .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
                    for (int s = 0; s < 4; s++) p.side[s] = kinds >> s & 1 ? NEUMANN : DIRICHLET;
                    if (m == 2) p.material[0].k[1] = p.material[0].k[0];
                    p.initial = steady_cubic, p.wall = steady_wall, p.source = steady_source;
                    assert_near(farthest(all[m], &p, &o), 0, 2e-13);
                    if (m > 2) continue;
                    o.fourier = 0, o.stepper = STEPPER_EXACT;
                    assert_near(farthest(all[m], &p, &o), 0, 2e-13);
                }
}

/* Order 4 knows fourth derivatives too: the same cubic, rows under jitter. */
static void a_steady_cubic_stays_under_jitter(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05, .layout = LAYOUT_JITTER, .jitter = 0.23, .seed = 5, .order = 4};
    p.initial = steady_cubic, p.wall = steady_wall, p.source = steady_source;
    assert_near(farthest(&method_so_ssph, &p, &o), 0, 1e-12);
}

/* ---- A rod with a source, warm at one end, heated at the other: S + Z, S steady, Z a mode that decays ---- */

static double S(double x, int derivative) {
    return (derivative == 0) + 0.5 * pow(0.83, derivative) * exp(0.83 * x);
}

static double wave(const struct problem *p) {
    return 1.5 * PI / (p->hi[0] - p->lo[0]);
}

static double warm(const struct problem *p, const double x[2]) {
    return S(x[0], 0) + p->param[0] * sin(wave(p) * (x[0] - p->lo[0]));
}

static double heated_wall(const struct problem *p, enum side s, const double x[2]) {
    (void)x;
    return s == X_LO ? S(p->lo[0], 0) : p->material[0].k[0] * S(p->hi[0], 1);
}

static double heater(const struct problem *p, const double x[2]) {
    return -p->material[0].k[0] * S(x[0], 2);
}

static struct problem heated_rod(void) {
    struct problem p = odd_rod();
    p.side[X_HI] = NEUMANN, p.initial = warm, p.wall = heated_wall, p.source = heater, p.t_end = 0.31;
    p.param[0] = 0.47;
    return p;
}

static double matched_error(const struct method *m, enum sampling sampling, double dx) {
    struct problem p = heated_rod();
    struct options o = {.dx = dx, .stepper = STEPPER_MATCHED, .sampling = sampling};
    double kappa = p.material[0].k[0] / p.material[0].rho_c, most = 0;
    struct field f;
    struct failure why;
    if (method_solve(m, &p, &o, &f, &why)) fail_msg("%s: %s", m->name, why.text);
    p.param[0] *= exp(-kappa * wave(&p) * wave(&p) * p.t_end);
    for (size_t i = 0; i < f.n; i++) most = fmax(most, fabs(f.T[i] - warm(&p, (double[2]){f.x[i], 0})));
    field_free(&f);
    return most;
}

static void matched_runs_with_a_source_are_of_fourth_order(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_ftcs};
    for (int m = 0; m < 2; m++)
        for (int sampling = SAMPLING_POINT; sampling <= SAMPLING_SPLINE; sampling++) {
            double coarse = matched_error(all[m], (enum sampling)sampling, 0.05);
            double fine = matched_error(all[m], (enum sampling)sampling, 0.0125);
            assert_near(log(coarse / fine) / log(4), 4, 0.03);
        }
}

/* (-1)^i is insulated at a Dirichlet wall: what ghosts miss there, d^4, feeds it at third order. */
static void what_is_blind_to_the_checkerboard_is_refused(void **state) {
    (void)state;
    const struct method *const all[] = {&method_fo_ssph, &method_ftcs_flux};
    for (int m = 0; m < 2; m++) {
        struct problem p = heated_rod();
        struct options o = {.dx = 0.05, .stepper = STEPPER_MATCHED};
        struct field f;
        struct failure why;
        assert_int_equal(method_solve(all[m], &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
        assert_has(why.text, "annihilates (-1)^i");
        p.source = NULL;
        assert_int_equal(method_solve(all[m], &p, &o, &f, &why), STATUS_OK);
        field_free(&f);
    }
}

/* ---- Starts that points do not serve ---- */

static double step_at(const struct problem *p, const double x[2]) {
    return x[0] < p->jump[0][0] ? 0.3 : 0.8 + p->param[0] * x[0];
}

static void points_of_unknown_order_are_refused(void **state) {
    (void)state;
    const struct method *const all[] = {&method_so_ssph, &method_ftcs};
    const struct {
        double at, slope;
        const char *says; /* NULL: accepted */
    } row[] = {{0.4, 0, NULL}, {0.41, 0, "midway"}, {0.4, 0.17, "vary between the jumps"}};
    for (int m = 0; m < 2; m++)
        for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
            struct problem p = odd_rod();
            struct options o = {.dx = 0.05, .stepper = STEPPER_MATCHED};
            struct field f;
            struct failure why;
            p.initial = step_at, p.jumps[0] = 1, p.jump[0][0] = row[k].at, p.param[0] = row[k].slope;
            p.t_end = 0.1;
            int status = method_solve(all[m], &p, &o, &f, &why);
            assert_int_equal(status, row[k].says ? STATUS_NOT_APPLICABLE : STATUS_OK);
            if (!status)
                field_free(&f);
            else if (!strstr(why.text, row[k].says) || !strstr(why.text, "--sampling spline"))
                fail_msg("%s: %s", all[m]->name, why.text);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_steady_cubic_stays),
        cmocka_unit_test(a_steady_cubic_stays_under_jitter),
        cmocka_unit_test(matched_runs_with_a_source_are_of_fourth_order),
        cmocka_unit_test(what_is_blind_to_the_checkerboard_is_refused),
        cmocka_unit_test(points_of_unknown_order_are_refused),
    };
    return cmocka_run_group_tests_name("walls", tests, NULL, NULL);
}
