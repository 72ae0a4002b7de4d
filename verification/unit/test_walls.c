/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plane walls of higher order and Robin walls, in every method and stepper. */

#include "solver/method.h"
#include "solver/time/transform.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

extern const struct method method_brookshaw, method_fo_ssph, method_ftcs, method_ftcs_flux, method_so_ssph;

/* ---- cubic ---- */

static const double PI = 3.14159265358979323846;

static double farthest(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f;
    struct failure why;
    double most = 0, x[DIM_MAX];
    if (method_solve(m, p, o, &f, &why)) fail_msg("%s: %s", m->name, why.text);
    for (size_t i = 0; i < f.n; i++) most = fmax(most, fabs(f.T[i] - p->initial(p, field_place(&f, i, x))));
    field_free(&f);
    return most;
}

/* Central differences, moments to order 2 and first derivatives taken twice are exact for a cubic. */
static void steady_cubic_is_preserved(void **state) {
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
static void steady_cubic_is_preserved_under_jitter(void **state) {
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

static double heated_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)x, (void)t;
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
    for (size_t i = 0; i < f.n; i++) most = fmax(most, fabs(f.T[i] - warm(&p, (double[2]){f.x[0][i], 0})));
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

/* (-1)^i is insulated at a Dirichlet wall: the error of the ghosts there, d^4, excites it at third order. */
static void matched_runs_refuse_first_derivatives_with_a_source(void **state) {
    (void)state;
    const struct method *const all[] = {&method_fo_ssph, &method_ftcs_flux};
    for (int m = 0; m < 2; m++) {
        struct problem p = heated_rod();
        struct options o = {.dx = 0.05, .stepper = STEPPER_MATCHED};
        struct field f;
        struct failure why;
        assert_int_equal(method_solve(all[m], &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
        assert_has(why.text, "(-1)^i");
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

/* ---- robin ---- */

static const struct method *const methods_robin[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw,
                                                     &method_ftcs, &method_ftcs_flux};
enum { METHODS = sizeof methods_robin / sizeof *methods_robin, PARTICLES = 3 };

static const double AMBIENT = 0.37, HEIGHT = 0.83; /* K, of the surroundings; of the mode */

static double ambient(const struct problem *p, enum side s, const double x[2], double t) {
    (void)x, (void)t;
    return p->side[s] == NEUMANN ? 0 : AMBIENT;
}

/* param: wave number and phase along x, along y */
static double mode(const struct problem *p, const double x[2]) {
    double T = HEIGHT * cos(p->param[0] * (x[0] - p->lo[0]) - p->param[1]);
    if (p->dim == 2) T *= cos(p->param[2] * (x[1] - p->lo[1]) - p->param[3]);
    return AMBIENT + T;
}

/* The lowest root nu of nu L = atan(lo/(k nu)) + atan(hi/(k nu)), and psi. */
static void lowest_mode(double lo, double hi, double k, double L, double *nu, double *psi) {
    double below = 0, above = M_PI / L;
    for (int i = 0; i < 200; i++) {
        *nu = (below + above) / 2;
        *(*nu * L < atan2(lo, k * *nu) + atan2(hi, k * *nu) ? &below : &above) = *nu;
    }
    *psi = atan2(lo, k * *nu);
}

static struct problem cooled(int dim) {
    struct problem p = dim == 1 ? odd_rod() : odd_rectangle();
    p.wall = ambient, p.initial = mode, p.t_end = 0.21;
    p.side[X_LO] = dim == 1 ? NEUMANN : ROBIN, p.side[X_HI] = ROBIN, p.robin[X_LO] = dim == 1 ? 0 : 0.47,
    p.robin[X_HI] = 2.3;
    p.side[Y_LO] = NEUMANN, p.side[Y_HI] = ROBIN, p.robin[Y_HI] = 0.71;
    for (int a = 0; a < dim; a++)
        lowest_mode(p.robin[2 * a], p.robin[2 * a + 1], p.material[0].k[a], p.hi[a] - p.lo[a], &p.param[2 * a],
                    &p.param[2 * a + 1]);
    return p;
}

static struct field solved(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f;
    struct failure why = {0};
    if (method_solve(m, p, o, &f, &why)) fail_msg("%s: %s", m->name, why.text);
    return f;
}

/* The modes of the transform are those of the ghosts: no stepper but exact has a time error to hide behind. */
static void steppers_agree_with_the_exact_one(void **state) {
    (void)state;
    const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2, STEPPER_CHEBYSHEV};
    for (int m = 0; m < PARTICLES; m++)
        for (int dim = 1; dim < 3; dim++) {
            struct problem p = cooled(dim);
            if (m == 2) p.material[0].k[1] = p.material[0].k[0];
            p.initial = odd_start, p.t_end = 0.0173;
            struct options o = {.dx = 0.05, .stepper = STEPPER_EXACT};
            struct field exact = solved(methods_robin[m], &p, &o);
            for (int s = 0; s < 4; s++) {
                double apart[2] = {0, 0};
                for (int fine = 0; fine < 2; fine++) {
                    o.stepper = steppers[s], o.dt = p.t_end / (fine ? 800 : 200);
                    struct field f = solved(methods_robin[m], &p, &o);
                    for (size_t i = 0; i < f.n; i++) apart[fine] = fmax(apart[fine], fabs(f.T[i] - exact.T[i]));
                    field_free(&f);
                }
                /* first order: a quarter; second: a sixteenth, or rounding; none */
                double fewer = steppers[s] == STEPPER_CHEBYSHEV ? 1e-12 : apart[0] / (s ? 14 : 3.9) + 1e-13;
                assert_order(apart[1], <, fewer);
                assert_order(apart[0], <, 1e-3);
            }
            field_free(&exact);
        }
}

static double ambient_but_no_flux(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    return p->side[s] == NEUMANN ? 0 : ambient(p, s, x, 0);
}

static double hot(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return HEIGHT;
}

/* One side of a square is cooled, each in turn; the opposite one has a Dirichlet and then a Neumann condition.  The
 * temperatures relative to the cooled side are the same. */
static void robin_sides_are_equivalent(void **state) {
    (void)state;
    enum { N = 12 };
    double kept[N];
    for (int turn = 0; turn < 8; turn++) {
        int s = turn % 4;
        struct problem p = {.dim = 2,
                            .hi = {1, 1},
                            .t_end = 0.1,
                            .materials = 1,
                            .material = {{{1, 1}, 1}},
                            .initial = hot,
                            .wall = ambient_but_no_flux};
        for (int side = 0; side < 4; side++) p.side[side] = side == (s ^ 1) && turn < 4 ? DIRICHLET : NEUMANN;
        p.side[s] = ROBIN, p.robin[s] = 0.7;
        struct options o = {.dx = 1.0 / N, .stepper = STEPPER_EXACT};
        struct field f = solved(methods_robin[0], &p, &o);
        assert_int_equal(f.n, N * N);
        for (int i = 0; i < N; i++) {
            int from = s % 2 ? N - 1 - i : i;
            double T = f.T[s < Y_LO ? from : from * N];
            if (s == 0)
                kept[i] = T;
            else
                assert_near(T, kept[i], 1e-13);
        }
        field_free(&f);
        assert_order(fabs(kept[0] - kept[N - 1]), >, 0.01);
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_cubic_is_preserved),
        cmocka_unit_test(steady_cubic_is_preserved_under_jitter),
        cmocka_unit_test(matched_runs_with_a_source_are_of_fourth_order),
        cmocka_unit_test(matched_runs_refuse_first_derivatives_with_a_source),
        cmocka_unit_test(points_of_unknown_order_are_refused),
        cmocka_unit_test(steppers_agree_with_the_exact_one),
        cmocka_unit_test(robin_sides_are_equivalent),
    };
    return cmocka_run_group_tests_name("walls", tests, NULL, NULL);
}
