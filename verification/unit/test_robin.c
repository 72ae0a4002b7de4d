/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Robin walls, k dT/dn = b (T_a - T) (Song 2018, eq. 4), in every method and stepper.
 *
 * The rod: cos(mu s) about T_a, s from an insulated wall, mu L tan(mu L) = b L/k.  The plate: the same along y, and
 * along x a mode between two Robin walls of b_lo and b_hi: cos(nu s - psi), tan psi = b_lo/(k nu), nu L = psi +
 * atan(b_hi/(k nu)). */
#include "solver/time/transform.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

extern const struct method method_so_ssph, method_fo_ssph, method_brookshaw, method_ftcs, method_ftcs_flux;
static const struct method *const all[] = {&method_so_ssph, &method_fo_ssph, &method_brookshaw, &method_ftcs,
                                           &method_ftcs_flux};
enum { METHODS = sizeof all / sizeof *all, PARTICLES = 3 };

static const double AMBIENT = 0.37, HEIGHT = 0.83; /* K, of the surroundings; of the mode */

static double ambient(const struct problem *p, enum side s, const double x[2]) {
    (void)x;
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

static double decay(const struct problem *p) {
    double rate = 0;
    for (int a = 0; a < p->dim; a++) rate += p->material[0].k[a] / p->material[0].rho_c * pow(p->param[2 * a], 2);
    return exp(-rate * p->t_end);
}

static struct field solved(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f;
    struct failure why = {0};
    if (method_solve(m, p, o, &f, &why)) fail_msg("%s: %s", m->name, why.text);
    return f;
}

/* Largest error over the amplitude. */
static double error_of(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f = solved(m, p, o);
    double most = 0;
    for (size_t i = 0; i < f.n; i++) {
        double x[2] = {f.x[i], f.y ? f.y[i] : 0}, want = AMBIENT + decay(p) * (mode(p, x) - AMBIENT);
        most = fmax(most, fabs(f.T[i] - want) / HEIGHT);
    }
    field_free(&f);
    return most;
}

static void every_method_is_of_second_order(void **state) {
    (void)state;
    for (int m = 0; m < METHODS; m++)
        for (int dim = 1; dim < 3; dim++)
            for (int sampling = SAMPLING_POINT; sampling <= SAMPLING_CELL; sampling++) {
                struct problem p = cooled(dim);
                if (m == 2)
                    p.material[0].k[1] = p.material[0].k[0],
                    lowest_mode(p.robin[Y_LO], p.robin[Y_HI], p.material[0].k[1], p.hi[1] - p.lo[1], &p.param[2],
                                &p.param[3]);
                struct options o = {.dx = 0.05, .fourier = 0.05, .sampling = (enum sampling)sampling};
                if (m < PARTICLES) o.stepper = STEPPER_EXACT, o.fourier = 0;
                double coarse = error_of(all[m], &p, &o);
                o.dx = 0.0125;
                double fine = error_of(all[m], &p, &o);
                assert_near(log(coarse / fine) / log(4), 2, 0.15);
                assert_order(fine, <, 1e-3);
            }
}

/* The modes of the transform are those of the ghosts: no stepper but exact has a time error to hide behind. */
static void all_steppers_agree_with_the_exact_one(void **state) {
    (void)state;
    const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2, STEPPER_CHEBYSHEV};
    for (int m = 0; m < PARTICLES; m++)
        for (int dim = 1; dim < 3; dim++) {
            struct problem p = cooled(dim);
            if (m == 2) p.material[0].k[1] = p.material[0].k[0];
            p.initial = odd_start, p.t_end = 0.0173;
            struct options o = {.dx = 0.05, .stepper = STEPPER_EXACT};
            struct field exact = solved(all[m], &p, &o);
            for (int s = 0; s < 4; s++) {
                double apart[2] = {0, 0};
                for (int fine = 0; fine < 2; fine++) {
                    o.stepper = steppers[s], o.dt = p.t_end / (fine ? 800 : 200);
                    struct field f = solved(all[m], &p, &o);
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

/* Rows of their own take the factor of each particle's distance. */
static void clouds_are_of_second_order(void **state) {
    (void)state;
    struct problem p = cooled(2);
    struct options o = {.dx = 0.1, .layout = LAYOUT_JITTER, .jitter = 0.2, .seed = 3, .stepper = STEPPER_RK2};
    double coarse = error_of(&method_so_ssph, &p, &o);
    o.dx = 0.025;
    double fine = error_of(&method_so_ssph, &p, &o);
    assert_near(log(coarse / fine) / log(4), 2, 0.3);
}

/* b = 0 insulates; b past 1/eps holds the wall at T_a. */
static void limits_are_neumann_and_dirichlet(void **state) {
    (void)state;
    const double b[] = {0, 1e300};
    for (int m = 0; m < METHODS; m++)
        for (int end = 0; end < 2; end++)
            for (int layout = LAYOUT_LATTICE; layout <= (m < PARTICLES ? LAYOUT_JITTER : LAYOUT_LATTICE); layout += 2)
                for (int stepper = 0; stepper < 2; stepper++) {
                    struct problem p = cooled(2), q;
                    if (m == 2) p.material[0].k[1] = p.material[0].k[0];
                    struct options o = {.dx = 0.05, .layout = (enum layout_name)layout, .jitter = 0.13, .seed = 2};
                    o.stepper = stepper && m < PARTICLES && layout == LAYOUT_LATTICE ? STEPPER_EXACT : STEPPER_EULER;
                    if (o.stepper == STEPPER_EULER) o.fourier = 0.05;
                    p.initial = odd_start, p.t_end = 0.02;
                    for (int s = 0; s < 4; s++) p.side[s] = ROBIN, p.robin[s] = b[end];
                    p.side[Y_LO] = DIRICHLET; /* one that is no limit */
                    q = p;
                    for (int s = 0; s < 4; s++)
                        if (q.side[s] == ROBIN) q.side[s] = end ? DIRICHLET : NEUMANN;
                    struct field f = solved(all[m], &p, &o), g = solved(all[m], &q, &o);
                    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], g.T[i], 1e-13);
                    field_free(&f);
                    field_free(&g);
                }
}

static double ambient_but_no_flux(const struct problem *p, enum side s, const double x[2]) {
    return p->side[s] == NEUMANN ? 0 : ambient(p, s, x);
}

static double hot(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return HEIGHT;
}

/* One side of a square is cooled, another by turns, the opposite one held, then insulated: seen from it the
 * temperatures are the same. */
static void each_side_is_cooled_alike(void **state) {
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
        struct field f = solved(all[0], &p, &o);
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

/* What the body has lost has gone through its wall: rho_c int (T - T_0) = -int b (T - T_a) dt. */
static void heat_leaves_through_the_wall(void **state) {
    (void)state;
    struct problem p = cooled(1);
    double L = p.hi[0] - p.lo[0], k = p.material[0].k[0], kappa = k / p.material[0].rho_c, mu = p.param[0];
    double through = p.robin[X_HI] * HEIGHT * cos(mu * L) * (1 - decay(&p)) / (kappa * mu * mu);
    for (int m = 0; m < METHODS; m++) {
        struct options o = {.dx = 0.0125, .fourier = 0.01};
        struct field f = solved(all[m], &p, &o);
        assert_near((f.heat[0] - f.heat[1]) / through, 1, 1e-3); /* (mu dx)^2 and as much of Euler's */
        field_free(&f);
    }
}

/* Orthogonal modes of unit length, in both mixed and equal pairs of walls. */
static void modes_are_orthogonal(void **state) {
    (void)state;
    const double f[][2] = {{0.31, -0.77}, {-1, 0.9}, {0, 1}, {1 - 1e-12, 1 - 1e-12}};
    for (size_t k = 0; k < sizeof f / sizeof *f; k++) {
        struct lattice l = {.dim = 1, .n = {57, 1}, .dx = {0.1, 1}};
        double T[57], start[57];
        for (int s = 0; s < 2; s++) {
            l.sign[s] = fabs(f[k][s]) == 1 ? (int)f[k][s] : LAYOUT_ROBIN;
            l.robin[s] = f[k][s];
        }
        struct transform *t = transform_create(&l);
        for (int i = 0; i < 57; i++) T[i] = start[i] = sin(0.37 * i * i);
        transform_forward(t, T);
        transform_backward(t, T);
        for (int i = 0; i < 57; i++) assert_near(T[i] / transform_scale(&l), start[i], 2e-14);
        for (int i = 1; i < 57; i++)
            assert_order(transform_angle(&l, 0, i), >, transform_angle(&l, 0, i - 1)); /* none missed, none twice */
        transform_free(t);
    }
}

static void what_has_no_answer_is_refused(void **state) {
    (void)state;
    struct problem p = cooled(1);
    const struct options o[] = {
        {.dx = 0.05, .order = 4}, {.dx = 0.05, .stepper = STEPPER_MATCHED}, {.dx = 0.05, .layout = LAYOUT_NODE}};
    struct field f;
    struct failure why;
    for (int k = 0; k < 3; k++) {
        assert_int_equal(method_solve(&method_so_ssph, &p, &o[k], &f, &why), STATUS_NOT_APPLICABLE);
        assert_has(why.text, "Robin wall");
        if (k == 0) continue;
        assert_int_equal(method_solve(&method_ftcs, &p, &o[k], &f, &why), STATUS_NOT_APPLICABLE);
        assert_has(why.text, "Robin wall");
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_is_of_second_order),
        cmocka_unit_test(all_steppers_agree_with_the_exact_one),
        cmocka_unit_test(clouds_are_of_second_order),
        cmocka_unit_test(limits_are_neumann_and_dirichlet),
        cmocka_unit_test(each_side_is_cooled_alike),
        cmocka_unit_test(heat_leaves_through_the_wall),
        cmocka_unit_test(modes_are_orthogonal),
        cmocka_unit_test(what_has_no_answer_is_refused),
    };
    return cmocka_run_group_tests_name("robin", tests, NULL, NULL);
}
