/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls that change in time: solutions that are polynomials are exact, and rkl2 is its published recurrence. */
#include "solver/particles/particles.h"

#include "verification/unit/near.h"
#include "verification/unit/odd_problems.h"
#include "verification/unit/odd_scenes.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

/* The heat polynomials x^3 + 6 kappa x t of each axis, times 0.3 and 0.7, and 0.2 + 0.4 x y; derivative along `axis`
 * (-1: none). */
static double cubic(const struct problem *p, const double *x, double t, int axis) {
    static const double size[2] = {0.3, 0.7};
    double sum = axis < 0 ? 0.2 : 0;
    for (int a = 0; a < p->dim; a++) {
        double kappa = p->material[0].k[a] / p->material[0].rho_c, z = x[a];
        if (axis < 0) sum += size[a] * (z * z * z + 6 * kappa * z * t);
        if (axis == a) sum += size[a] * (3 * z * z + 6 * kappa * t);
    }
    return p->dim == 1 ? sum : sum + 0.4 * (axis < 0 ? x[0] * x[1] : x[1 - axis]);
}

static double start(const struct problem *p, const double *x) {
    return cubic(p, x, 0, -1);
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    int axis = (int)s / 2;
    double slope = p->material[0].k[axis] * cubic(p, x, t, axis) * (s % 2 ? 1 : -1);
    double T = cubic(p, x, t, -1);
    return p->side[s] == DIRICHLET ? T : p->side[s] == NEUMANN ? slope : T + slope / p->robin[s];
}

/* Central differences are exact for these polynomials. */
static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    return (wall(p, s, x, t + 0.5) - wall(p, s, x, t - 0.5));
}

static struct problem changing(struct problem p) {
    p.initial = start, p.wall = wall, p.wall_rate = wall_rate;
    return p;
}

static double off(struct problem p, struct options o) {
    struct failure why;
    struct field f;
    double worst = 0, x[DIM_MAX];
    if (method_solve(method_find("so_ssph"), &p, &o, &f, &why)) fail_msg("%s", why.text);
    for (size_t i = 0; i < f.n; i++)
        worst = fmax(worst, fabs(f.T[i] - cubic(&p, field_place(&f, i, x), p.t_end, -1)));
    field_free(&f);
    return worst;
}

/* so_ssph is exact for cubics, each ghost too with dT/dt of its wall, and every stepper for linear data. */
static void cubic_heat_polynomials_are_exact(void **state) {
    (void)state;
    static const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2, STEPPER_CHEBYSHEV};
    for (int k = 0; k < 4; k++)
        for (int layout = 0; layout < 2; layout++)
            for (int dim = 1; dim <= 2; dim++) {
                struct problem p = changing(dim == 1 ? odd_rod() : odd_rectangle());
                struct options o = {
                    .dx = 0.05, .stepper = steppers[k], .fourier = steppers[k] == STEPPER_RKL2 ? 1 : 0.1};
                o.layout = layout ? LAYOUT_NODE : LAYOUT_LATTICE;
                if (dim == 1) p.side[X_HI] = NEUMANN;
                assert_near(off(p, o), 0, 1e-12);
                p.jumps[0] = 1, p.jump[0][0] = (p.lo[0] + p.hi[0]) / 2; /* a jump without height: rkl2 damps */
                assert_near(off(p, o), 0, 1e-12);
            }
}

/* Rows of a cloud without displacements are the stencil. */
static void rows_of_a_cloud_equal_the_stencil(void **state) {
    (void)state;
    static const char *const names[] = {"so_ssph", "fo_ssph", "brookshaw"};
    for (int k = 0; k < 6; k++) {
        struct problem p;
        struct field f[2];
        struct failure why;
        odd_find(k < 3 ? "plate-driven" : "rod-driven", &p);
        if (k == 2) p.material[0].k[1] = p.material[0].k[0];
        if (k < 3) p.side[Y_HI] = NEUMANN; /* images beyond a Robin wall have factors of their own on a cloud */
        p.t_end = 0.3;
        for (int cloud = 0; cloud < 2; cloud++) {
            struct options o = {.dx = k < 3 ? 0.05 : 0.83 / 30, .stepper = STEPPER_RK2, .fourier = 0.1};
            o.layout = cloud ? LAYOUT_JITTER : LAYOUT_LATTICE;
            if (method_solve(method_find(names[k % 3]), &p, &o, &f[cloud], &why)) fail_msg("%s", why.text);
        }
        for (size_t i = 0; i < f[0].n; i++) {
            size_t j = 0;
            double x[DIM_MAX], y[DIM_MAX];
            field_place(&f[0], i, x);
            while (fabs(field_place(&f[1], j, y)[0] - x[0]) > 1e-9 || fabs(y[1] - x[1]) > 1e-9) j++;
            assert_near(f[1].T[j], f[0].T[i], 1e-13);
        }
        field_free(&f[0]), field_free(&f[1]);
    }
}

static double quartic(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x;
    return s == X_LO ? 0.3 + 0.7 * t - 11 * t * t + 90 * t * t * t - 170 * t * t * t * t : 0.8;
}

static double quartic_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x;
    return s == X_LO ? 0.7 - 22 * t + 270 * t * t - 680 * t * t * t : 0;
}

/* The answer does not depend on the number of steps. */
static void quartic_data_leave_polynomials_without_time_error(void **state) {
    (void)state;
    struct problem p = odd_rod();
    struct field f[3];
    struct failure why;
    p.wall = quartic, p.wall_rate = quartic_rate, p.t_end = 0.2;
    for (int k = 0; k < 3; k++) {
        struct options o = {.dx = 0.05, .stepper = STEPPER_CHEBYSHEV, .dt = p.t_end / (1 + 3 * k)};
        assert_int_equal(method_solve(method_find("so_ssph"), &p, &o, &f[k], &why), STATUS_OK);
        assert_near(field_farthest(&f[k], f[0].T), 0, 1e-12);
    }
    for (int k = 0; k < 3; k++) field_free(&f[k]);
}

/* A x + g at the time t, with linear data between the ends of the step. */
static void slope_at(struct heat_operator *a, double *const g[2], double part, const double *x, double *to) {
    double *state[2] = {xcalloc(a->state, sizeof **state), xcalloc(a->state, sizeof **state)};
    double *data = xcalloc(a->state, sizeof *data);
    for (size_t i = 0; i < a->state; i++) data[i] = (1 - part) * g[0][i] + part * g[1][i];
    a->g = data;
    state_load(a, x, state[0]);
    state_update(a, &(struct update){.rate = 1}, 1, state);
    state_store(a, state[0], to);
    a->g = NULL;
    free(data), free(state[0]), free(state[1]);
}

/* Meyer, Balsara & Aslam 2014, eqs. 16 to 18, as printed, with the walls at the times of the stages. */
static void published_step(struct heat_operator *a, double *const g[2], double dt, int s, double *Y0) {
    enum { MOST = 64 };
    double L0[MOST], L[MOST], Y[3][MOST], b[MOST], all = (double)s * s + s - 2;
    b[0] = b[1] = b[2] = 1.0 / 3;
    for (int j = 3; j <= s; j++) b[j] = (j * j + j - 2.0) / (2.0 * j * (j + 1));
    slope_at(a, g, 0, Y0, L0);
    memcpy(Y[0], Y0, a->n * sizeof *Y0);
    for (size_t i = 0; i < a->n; i++) Y[1][i] = Y0[i] + b[1] * 4 / all * dt * L0[i];
    for (int j = 2; j <= s; j++) {
        double c = j == 2 ? 4 / (3 * all) : ((j - 1.0) * j - 2) / all; /* time of stage j - 1 */
        double mu = (2.0 * j - 1) / j * b[j] / b[j - 1], nu = -(j - 1.0) / j * b[j] / b[j - 2], w = mu * 4 / all;
        slope_at(a, g, c, Y[(j - 1) % 3], L);
        for (size_t i = 0; i < a->n; i++)
            Y[j % 3][i] = mu * Y[(j - 1) % 3][i] + nu * Y[(j - 2) % 3][i] + (1 - mu - nu) * Y0[i] + w * dt * L[i] -
                          (1 - b[j - 1]) * w * dt * L0[i];
    }
    memcpy(Y0, Y[s % 3], a->n * sizeof *Y0);
}

static void rkl2_is_its_published_recurrence(void **state) {
    (void)state;
    enum { STAGES = 7, STEPS = 3, N = 40 };
    struct problem p;
    struct options given = {.dx = 0.83 / N, .stepper = STEPPER_RKL2}, o;
    struct failure why;
    struct lattice l;
    struct heat_operator a;
    const struct scheme *s = method_find("so_ssph")->scheme;
    double *T, U[N], *g[2];
    int rows;
    size_t bytes = 0;
    odd_find("rod-driven", &p);
    assert_int_equal(particles_prepare(&p, &given, s, &o, &l, &rows, &why), STATUS_OK);
    assert_int_equal(operator_create_lattice(&a, &p, &o, s, &l, &why), STATUS_OK);
    struct march m = {.stepper = STEPPER_RKL2, .time = 0.4, .steps = STEPS, .stages = STAGES, .hi = 5, .options = &o};
    m.changing = &p;
    T = xcalloc(a.state, sizeof *T);
    for (int i = 0; i < N; i++) T[i] = U[i] = p.initial(&p, (double[]){l.first[0] + i * l.dx[0]});
    assert_int_equal(stepper_march(&a, &m, T, &bytes, &why), STATUS_OK);
    struct heat_operator own = a;
    for (int k = 0; k < 2; k++) g[k] = xcalloc(a.state, sizeof **g);
    for (int step = 0; step < STEPS; step++) {
        for (int k = 0; k < 2; k++) operator_constants(&a, &p, &o, m.time * (step + k) / STEPS, g[k]);
        published_step(&own, g, m.time / STEPS, STAGES, U);
    }
    for (int i = 0; i < N; i++) assert_near(T[i], U[i], 1e-13);
    free(g[0]), free(g[1]), free(T);
    operator_free(&a);
}

/* A wall of 2.385e4 s^-1 has a period of 2.634e-4 s; steps of 1e-3 s have four of them, and leave the range.  Ten
 * steps a period stay in it.  A run that is unstable for another reason says nothing of its walls. */
static void a_wall_faster_than_the_steps_is_named(void **state) {
    (void)state;
    static const char *const names[] = {"so_ssph", "ftcs"};
    for (int k = 0; k < 2; k++) {
        struct problem p;
        struct field f;
        struct failure why;
        struct options o = {.dx = 0.083, .stepper = STEPPER_EULER, .dt = 1e-3};
        odd_find("rod-driven", &p);
        p.param[4] = 2.385e4, p.t_end = 0.1;
        assert_near(problem_wall_period(&p), 2 * M_PI / 2.385e4, 0.001 * 2 * M_PI / 2.385e4);
        assert_int_equal(method_solve(method_find(names[k]), &p, &o, &f, &why), STATUS_UNSTABLE);
        assert_has(why.text, "a wall changes with a period of 0.000263 s, 0.26 steps; 10 are needed (--dt 2.6e-05)");
        o.dt = 2.5e-5;
        if (method_solve(method_find(names[k]), &p, &o, &f, &why)) fail_msg("%s", why.text);
        field_free(&f);
        p.param[4] = 0.61, p.t_end = 50, o.dt = 0.5;
        assert_int_equal(method_solve(method_find(names[k]), &p, &o, &f, &why), STATUS_UNSTABLE);
        assert_null(strstr(why.text, "a wall changes"));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cubic_heat_polynomials_are_exact),
        cmocka_unit_test(rows_of_a_cloud_equal_the_stencil),
        cmocka_unit_test(quartic_data_leave_polynomials_without_time_error),
        cmocka_unit_test(rkl2_is_its_published_recurrence),
        cmocka_unit_test(a_wall_faster_than_the_steps_is_named),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("data that change", tests, NULL, NULL);
}
