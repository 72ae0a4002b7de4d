/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conductivity that depends on temperature: laws, means, walls, time steps and refusals. */
#include "references/kirchhoff.h"
#include "solver/method.h"
#include "solver/particles/nonlinear.h"
#include "solver/time/stepper.h"
#include "verification/case/experiment.h"
#include "verification/judge/run.h"
#include "verification/unit/odd_problems.h"
#include "verification/unit/odd_scenes.h"

#include <string.h>

#include <gsl/gsl_errno.h>

static const char *const method_names[] = {"so_ssph", "fo_ssph", "brookshaw", "ftcs"};

static struct field solved(const char *method, const struct problem *p, const struct options *o) {
    struct failure why = {0};
    struct field f;
    if (method_solve(method_find(method), p, o, &f, &why)) fail_msg("%s: %s", method, why.text);
    return f;
}

static void assert_refused(const char *method, const struct problem *p, const struct options *o, int status,
                           const char *part) {
    struct failure why = {0};
    struct field f;
    if (method_solve(method_find(method), p, o, &f, &why) == STATUS_OK)
        fail_msg("%s is not refused: %s", method, part);
    assert_int_equal(why.status, status);
    if (!strstr(why.text, part)) fail_msg("%s: \"%s\" lacks \"%s\"", method, why.text, part);
}

static void theta_is_the_integral_and_has_an_inverse(void **state) {
    (void)state;
    struct problem p[2] = {{.k_law = K_LINEAR, .k_0 = 0.013, .k_beta = 0.7, .k_ref = -0.4},
                           {.k_law = K_POWER, .k_0 = 0.013, .k_n = 2.385, .k_ref = -0.4}};
    for (int law = 0; law < 2; law++)
        for (double T = -0.35; T < 3; T += 0.37) {
            double d = 1e-3, k = nonlinear_k(&p[law], T), theta = nonlinear_theta(&p[law], T);
            double slope = (nonlinear_theta(&p[law], T + d) - nonlinear_theta(&p[law], T - d)) / (2 * d);
            assert_near(slope, k, law ? 1e-5 * k / pow(T + 0.4, 2) : 1e-12);
            assert_near(nonlinear_T(&p[law], theta), T, 1e-14);
            assert_near(kirchhoff_k(&p[law], T), k, 1e-15);
            assert_near(kirchhoff_theta(&p[law], T), theta, 1e-15);
        }
}

/* A law that does not change k leaves the linear problem.  The second ghost of a Robin wall differs. */
static void constant_law_is_the_linear_problem(void **state) {
    (void)state;
    static const char *const bodies[] = {"rod-cooling", "rod-cosine", "rod-step", "wave"};
    for (int b = 0; b < 4; b++)
        for (int m = 0; m < 4; m++) {
            struct problem p, q;
            if (b == 0 && m < 3) continue;
            odd_find(bodies[b], &p);
            double dx = (p.hi[0] - p.lo[0]) / 24, kappa = p.material[0].k[0] / p.material[0].rho_c;
            for (int a = 1; a < p.dim; a++) p.material[0].k[a] = p.material[0].k[0];
            p.cross[0] = 0;
            p.t_end = 20 * 0.2 * dx * dx / kappa;
            q = p;
            q.k_law = K_LINEAR, q.k_0 = p.material[0].k[0], q.k_ref = 0.7;
            for (int mean = MEAN_HARMONIC; mean <= MEAN_KIRCHHOFF; mean++) {
                struct options o = {.dx = dx, .fourier = 0.2, .stepper = STEPPER_EULER, .domain = DOMAIN_WHOLE};
                if (mean == MEAN_SERIES) continue;
                struct field f = solved(method_names[m], &p, &o);
                o.mean = (enum mean)mean;
                struct field g = solved(method_names[m], &q, &o);
                assert_int_equal(f.n, g.n);
                for (size_t i = 0; i < f.n; i++)
                    assert_near(g.T[i], f.T[i], 1e-12 * (fabs(f.range[0]) + fabs(f.range[1])));
                field_free(&f);
                field_free(&g);
            }
        }
}

/* The fluxes of pairs are opposite, so that insulated bodies keep their heat, on clouds too. */
static void pairs_keep_heat(void **state) {
    (void)state;
    struct problem p;
    odd_find("rod-cosine", &p);
    p.k_law = K_POWER, p.k_0 = 0.02, p.k_n = 1.7;
    for (int mean = MEAN_HARMONIC; mean <= MEAN_KIRCHHOFF; mean++)
        for (int m = 2; m < 4; m++) {
            struct options o = {.dx = (p.hi[0] - p.lo[0]) / 40, .fourier = 0.05, .mean = (enum mean)mean, .seed = 3};
            if (mean == MEAN_SERIES) continue;
            if (m == 2) o.layout = LAYOUT_JITTER, o.jitter = 0.3;
            struct field f = solved(method_names[m], &p, &o);
            assert_near(f.heat[1], f.heat[0], 1e-12 * fabs(f.heat[0]));
            field_free(&f);
        }
}

/* With means of k over T, and with theta itself, Kirchhoff's profile is steady. */
static void kirchhoff_profile_is_steady(void **state) {
    (void)state;
    static const struct {
        const char *method;
        enum mean mean;
    } exact[] = {{"so_ssph", MEAN_AUTO},
                 {"brookshaw", MEAN_KIRCHHOFF},
                 {"brookshaw", MEAN_ARITHMETIC},
                 {"ftcs", MEAN_KIRCHHOFF},
                 {"ftcs", MEAN_ARITHMETIC}};
    const struct scene *s = scene_find("wall-kirchhoff");
    for (int k = 0; k < 5; k++) {
        struct problem p;
        struct failure why;
        scene_defaults(s, &p);
        p.param[7] = 0; /* A */
        assert_int_equal(s->setup(&p, &why), STATUS_OK);
        assert_true(p.source_at == NULL);
        struct options o = {.dx = 0.05, .fourier = 0.2, .mean = exact[k].mean};
        struct field f = solved(exact[k].method, &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], p.initial(&p, &f.x[0][i]), 1e-13);
        field_free(&f);
    }
}

/* Ahead of the front T = 0 and k = 0: harmonic means let nothing in, the others do. */
static void harmonic_means_lock_the_front(void **state) {
    (void)state;
    const struct scene *s = scene_find("front");
    for (int n = 1; n <= 3; n++)
        for (int mean = MEAN_HARMONIC; mean <= MEAN_KIRCHHOFF; mean++)
            for (int m = 2; m < 4; m++) {
                struct problem p;
                struct failure why;
                scene_defaults(s, &p);
                p.param[4] = n;
                assert_int_equal(s->setup(&p, &why), STATUS_OK);
                struct options o = {.dx = 0.025, .fourier = 0.1, .mean = (enum mean)mean, .h = 0.6};
                if (mean == MEAN_SERIES) continue;
                struct field f = solved(method_names[m], &p, &o);
                double reached = 0;
                for (size_t i = 0; i < f.n; i++)
                    if (f.T[i] > 0) reached = fmax(reached, f.x[0][i]);
                if (mean == MEAN_HARMONIC)
                    assert_order(reached, <, 0.35);
                else
                    assert_order(reached, >, 0.55 - 0.025);
                field_free(&f);
            }
}

/* At rest beyond the front, and all heat behind it comes through the wall. */
static void front_holds_the_heat_that_it_received(void **state) {
    (void)state;
    enum { N = 20000 };
    const struct scene *s = scene_find("front");
    for (int n = 1; n <= 3; n++) {
        struct problem p;
        struct failure why;
        double heat[2] = {0, 0}, in = 0, dx;
        scene_defaults(s, &p);
        p.param[4] = n;
        assert_int_equal(s->setup(&p, &why), STATUS_OK);
        dx = p.hi[0] / N;
        for (int i = 0; i < N; i++) {
            double x = (i + 0.5) * dx, t = (i + 0.5) / N * p.t_end, wall = 0;
            for (int end = 0; end < 2; end++)
                heat[end] += p.material[0].rho_c * scene_exact(s, &p, &x, end * p.t_end).temperature * dx;
            struct exact e = scene_exact(s, &p, &wall, t);
            in -= kirchhoff_k(&p, e.temperature) * e.gradient[0] * p.t_end / N;
        }
        assert_near(heat[1] - heat[0], in, 2e-5 * heat[1]);
        assert_near(scene_exact(s, &p, (double[]){0.5500001}, p.t_end).temperature, 0, 0);
        assert_order(scene_exact(s, &p, (double[]){0.5499999}, p.t_end).temperature, >, 0);
    }
}

static double distance(const struct field *f, const struct field *g) {
    return field_farthest(f, g->T);
}

/* By self-differences on one grid, with walls that change. */
static void steppers_have_their_order(void **state) {
    (void)state;
    static const struct {
        enum stepper_name stepper;
        int steps;
        double order;
    } row[] = {{STEPPER_EULER, 800, 1}, {STEPPER_RK2, 800, 2}, {STEPPER_RKL2, 400, 2}};
    static const char *const bodies[] = {"front", "wall-kirchhoff"}; /* walls that change, a source that changes */
    for (int run = 0; run < 12; run++) {
        struct problem p;
        struct field f[3];
        const int k = run % 3, m = run / 3 % 2 ? 3 : 0;
        odd_find(bodies[run / 6], &p);
        for (int i = 0; i < 3; i++) {
            struct options o = {.dx = p.hi[0] / 18, .stepper = row[k].stepper, .dt = p.t_end / (row[k].steps << i)};
            f[i] = solved(method_names[m], &p, &o);
            assert_int_equal(f[i].steps, row[k].steps << i);
        }
        double order = log2(distance(&f[0], &f[1]) / distance(&f[1], &f[2]));
        print_message("%s: order %g in time, stages %d to %d\n", method_names[m], order, f[0].stages, f[2].stages);
        assert_near(order, row[k].order, 0.12);
        for (int i = 0; i < 3; i++) field_free(&f[i]);
    }
}

static double one_mode(const struct problem *p, const double *x) {
    return p->start + cos(2 * acos(-1) * (x[0] - p->lo[0]) / (p->hi[0] - p->lo[0]));
}

/* Each step of ftcs multiplies a mode of an insulated rod by the amplification factor of the stepper. */
static void modes_of_differences_are_amplified_by_each_step(void **state) {
    (void)state;
    enum { N = 24, STEPS = 3 };
    static const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2, STEPPER_RKL2,
                                                 STEPPER_RKL2};
    static const double fourier[] = {0.37, 0.37, 0.7, 2.9, 31.7};
    for (int k = 0; k < 5; k++) {
        struct problem p = odd_rod();
        double dx = (p.hi[0] - p.lo[0]) / N, kappa = p.material[0].k[0] / p.material[0].rho_c;
        p.k_law = K_LINEAR, p.k_0 = p.material[0].k[0], p.source = NULL, p.initial = one_mode;
        for (int s = 0; s < 2; s++) p.side[s] = NEUMANN, p.held[s] = 0;
        p.wall = problem_held, p.t_end = STEPS * fourier[k] * dx * dx / kappa;
        struct options o = {.dx = dx, .stepper = steppers[k], .fourier = fourier[k]};
        struct field f = solved("ftcs", &p, &o);
        double z = -4 * fourier[k] * pow(sin(acos(-1) / N), 2), left = 1;
        for (int i = 0; i < STEPS; i++) left *= creal(stepper_of(steppers[k])->amplification(f.stages, z));
        assert_int_equal(f.steps, STEPS);
        for (size_t i = 0; i < f.n; i++)
            assert_near(f.T[i], p.start + left * (one_mode(&p, &f.x[0][i]) - p.start), 1e-13 * (1 + fabs(p.start)));
        field_free(&f);
    }
}

/* No mean is asked for. */
static void default_mean_lets_the_front_advance(void **state) {
    (void)state;
    struct problem p;
    odd_find("front", &p);
    for (int m = 2; m < 4; m++) {
        struct options o = {.dx = p.hi[0] / 36, .fourier = 0.1}, named = o;
        named.mean = MEAN_KIRCHHOFF;
        struct field f = solved(method_names[m], &p, &o), g = solved(method_names[m], &p, &named);
        assert_int_equal(memcmp(f.T, g.T, f.n * sizeof *f.T), 0);
        field_free(&f);
        field_free(&g);
    }
}

/* A run reports the mean that it takes. */
static void default_mean_follows_the_problem(void **state) {
    (void)state;
    static const char *const bodies[] = {"rod-contact", "front"};
    for (int k = 0; k < 2; k++)
        for (int m = 2; m < 4; m++) {
            struct experiment e = {.scene = scene_find(bodies[k]), .method = method_find(method_names[m])};
            struct result r;
            odd_find(bodies[k], &e.problem);
            e.options = (struct options){.dx = (e.problem.hi[0] - e.problem.lo[0]) / 40, .fourier = 0.1};
            e.problem.t_end /= 10;
            run_experiment(&e, &r, NULL);
            assert_int_equal(r.options.mean, k ? MEAN_KIRCHHOFF : MEAN_HARMONIC);
        }
}

static double harmonic_theta(const struct problem *p, const double *x) {
    return nonlinear_T(p, 3 + x[0] * x[0] - x[1] * x[1] + 0.3 * x[0] * x[1] - 0.2 * x[1]);
}

static double harmonic_wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)s, (void)t;
    return harmonic_theta(p, x);
}

/* so_ssph is exact for a quadratic theta, its ghosts beyond walls of varying temperature too. */
static void quadratic_theta_is_steady(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05};
    p.k_law = K_LINEAR, p.k_0 = 1, p.k_beta = 0.3, p.k_ref = -0.2;
    p.material[0].k[0] = p.material[0].k[1] = 2, p.source = NULL, p.t_end = 0.02;
    for (int s = 0; s < 4; s++) p.side[s] = DIRICHLET;
    p.initial = harmonic_theta, p.wall = harmonic_wall;
    struct field f = solved("so_ssph", &p, &o);
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], p.initial(&p, (double[]){f.x[0][i], f.x[1][i]}), 1e-12);
    field_free(&f);
}

static double hot_middle(const struct problem *p, const double *x) {
    return p->k_ref + sin(acos(-1) * (x[0] - p->lo[0]) / (p->hi[0] - p->lo[0]));
}

/* k is 21 times as large in the middle as at the walls. */
static struct problem hot_rod(void) {
    struct problem p = odd_rod();
    p.k_law = K_LINEAR, p.k_0 = p.material[0].k[0] / 21, p.k_beta = 20, p.k_ref = 1.3;
    for (int s = 0; s < 2; s++) p.side[s] = DIRICHLET, p.held[s] = p.k_ref;
    p.initial = hot_middle, p.wall = problem_held, p.source = NULL, p.t_end = 0.3;
    return p;
}

static void hot_middle_cools_without_growth(void **state) {
    (void)state;
    struct problem p = hot_rod();
    struct options o = {.dx = (p.hi[0] - p.lo[0]) / 20, .stepper = STEPPER_EULER};
    struct field f = solved("so_ssph", &p, &o);
    for (size_t i = 0; i < f.n; i++) assert_true(f.T[i] > p.k_ref && f.T[i] < p.k_ref + 1);
    field_free(&f);
}

/* The stages of a step with k of the start follow that k, while the body cools. */
static void frozen_k_cools_without_growth(void **state) {
    (void)state;
    struct problem p = hot_rod();
    struct options o = {.dx = (p.hi[0] - p.lo[0]) / 60, .stepper = STEPPER_RKL2};
    p.k_frozen = 1, p.t_end = 3;
    struct field f = solved("ftcs", &p, &o);
    for (size_t i = 0; i < f.n; i++) assert_true(f.T[i] > p.k_ref && f.T[i] < p.k_ref + 1);
    field_free(&f);
}

static void steps_follow_the_largest_k(void **state) {
    (void)state;
    struct problem p;
    odd_find("front", &p);
    struct options o = {.dx = p.hi[0] / 18, .stepper = STEPPER_EULER};
    struct field f = solved("so_ssph", &p, &o);
    double at_end = p.t_end * f.bound; /* steps of 1/bound, for the k of the end, and of the start */
    assert_order((double)f.steps, <, at_end);
    assert_order((double)f.steps, >, at_end * p.param[1] / (p.param[1] + p.param[2] * p.t_end));
    field_free(&f);
    for (int m = 0; m < 4; m++) {
        o.dt = p.t_end / 20;
        assert_refused(method_names[m], &p, &o, STATUS_UNSTABLE, "at step");
    }
}

static void refusals_name_the_option(void **state) {
    (void)state;
    struct problem p, q;
    odd_find("front", &p);
    odd_find("rod-cosine", &q);
    struct options o = {.dx = p.hi[0] / 18}, a = o, b = o, c = o, d = o, e = o, g = o;
    a.stepper = STEPPER_EXACT, b.mean = MEAN_SERIES, c.walls = WALLS_FIXED, d.order = 4, e.layout = LAYOUT_NODE;
    g.mean = MEAN_KIRCHHOFF, g.dx = q.hi[0] / 18;
    assert_refused("cspm", &p, &o, STATUS_NOT_APPLICABLE, "cspm: k depends on temperature here; use so_ssph");
    assert_refused("ftcs_flux", &p, &o, STATUS_NOT_APPLICABLE, "takes one k, the scene has k(T)");
    assert_refused("so_ssph", &p, &a, STATUS_NOT_APPLICABLE, "--stepper exact: k depends on temperature");
    assert_refused("so_ssph", &p, &d, STATUS_NOT_APPLICABLE, "--order 4");
    for (int m = 2; m < 4; m++) {
        assert_refused(method_names[m], &p, &b, STATUS_NOT_APPLICABLE, "--mean series: is for two materials");
        assert_refused(method_names[m], &p, &c, STATUS_NOT_APPLICABLE, "--walls fixed");
        assert_refused(method_names[m], &p, &e, STATUS_NOT_APPLICABLE, "--layout node");
        assert_refused(method_names[m], &q, &g, STATUS_NOT_APPLICABLE, "--mean kirchhoff");
    }
    a.stepper = STEPPER_CHEBYSHEV;
    assert_refused("ftcs", &p, &a, STATUS_NOT_APPLICABLE, "--stepper chebyshev: finite differences");
    a.stepper = STEPPER_MATCHED;
    assert_refused("ftcs", &p, &a, STATUS_NOT_APPLICABLE, "--stepper matched: k depends on T");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(theta_is_the_integral_and_has_an_inverse),
        cmocka_unit_test(constant_law_is_the_linear_problem),
        cmocka_unit_test(pairs_keep_heat),
        cmocka_unit_test(kirchhoff_profile_is_steady),
        cmocka_unit_test(harmonic_means_lock_the_front),
        cmocka_unit_test(front_holds_the_heat_that_it_received),
        cmocka_unit_test(steppers_have_their_order),
        cmocka_unit_test(modes_of_differences_are_amplified_by_each_step),
        cmocka_unit_test(default_mean_lets_the_front_advance),
        cmocka_unit_test(default_mean_follows_the_problem),
        cmocka_unit_test(quadratic_theta_is_steady),
        cmocka_unit_test(hot_middle_cools_without_growth),
        cmocka_unit_test(frozen_k_cools_without_growth),
        cmocka_unit_test(steps_follow_the_largest_k),
        cmocka_unit_test(refusals_name_the_option),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("conductivity of temperature", tests, NULL, NULL);
}
