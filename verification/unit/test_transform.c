/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sine and cosine transforms: each mode alone has one coefficient, and all of them together give the data back. */
#include "solver/time/transform.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <float.h>
#include <stdlib.h>

static const double PI = 3.14159265358979323846;

/* Between walls of each kind, on cells and on nodes. */
static struct lattice between(int sides, enum layout_name layout, double dx) {
    struct problem p = odd_rectangle();
    struct options o = {.dx = dx, .layout = layout};
    struct lattice l;
    struct failure why;
    for (int s = 0; s < 4; s++) p.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
    assert_int_equal(layout_lattice(&p, &o, 1, &l, &why), STATUS_OK);
    return l;
}

static double mode_along(const struct lattice *l, int axis, int k, int i) {
    int even = l->sign[2 * axis] > 0, node = l->shift[2 * axis] != 0;
    double from_wall = node ? i + !even : i + 0.5, phase = transform_angle(l, axis, k) * from_wall;
    return even ? cos(phase) : sin(phase);
}

static void one_mode(const struct lattice *l, const int mode[2], double *T) {
    size_t nx = (size_t)l->n[0], n = nx * (size_t)l->n[1], only = (size_t)mode[1] * nx + (size_t)mode[0];
    for (size_t i = 0; i < n; i++)
        T[i] = 1.7 * mode_along(l, 0, mode[0], (int)(i % nx)) * mode_along(l, 1, mode[1], (int)(i / nx));
    struct transform *t = transform_create(l);
    transform_forward(t, T);
    /* n products of size 1 add up, each rounded to 2e-16 of the sum, and FFTW does better */
    double tolerance = 1e-14 * transform_scale(l);
    assert_order(fabs(T[only]), >, 0.2 * transform_scale(l));
    for (size_t i = 0; i < n; i++)
        if (i != only) assert_near(T[i], 0, tolerance);
    transform_free(t);
}

static void a_mode_has_one_coefficient(void **state) {
    (void)state;
    for (int layout = 0; layout < 2; layout++)
        for (int sides = 0; sides < 16; sides++) {
            struct lattice l = between(sides, (enum layout_name)layout, 0.01); /* 150 along x, 120 along y */
            double *T = xcalloc((size_t)l.n[0] * (size_t)l.n[1], sizeof *T);
            one_mode(&l, (int[]){0, 0}, T);
            one_mode(&l, (int[]){l.n[0] - 1, 3}, T);
            one_mode(&l, (int[]){13, l.n[1] - 1}, T);
            free(T);
        }
}

static void back_again(const struct lattice *l) {
    size_t n = (size_t)l->n[0] * (size_t)l->n[1];
    double *T = xcalloc(n, sizeof *T), gain = transform_scale(l);
    for (size_t i = 0; i < n; i++) T[i] = sin(0.7 * (double)(i * i % 101));
    struct transform *t = transform_create(l);
    transform_forward(t, T);
    transform_backward(t, T);
    for (size_t i = 0; i < n; i++) assert_near(T[i] / gain, sin(0.7 * (double)(i * i % 101)), 1e-13);
    transform_free(t);
    free(T);
}

static void all_modes_give_the_data_back(void **state) {
    (void)state;
    for (int layout = 0; layout < 2; layout++)
        for (int sides = 0; sides < 16; sides++) {
            struct lattice l = between(sides, (enum layout_name)layout, 0.01), rod = l;
            back_again(&l);
            rod.dim = 1, rod.n[1] = 1;
            back_again(&rod);
            l = between(sides, (enum layout_name)layout, 0.1);
            back_again(&l);
        }
}

/* Insulated at one end, cooled by f = (1 - b)/(1 + b) at the other: mode k of n particles is cos(theta (i + 1/2)),
 * and the ghost asks for tan(n theta) tan(theta/2) = b.  The slowest one decays however little is cooled: its theta
 * is sqrt(2 b/n) and must be known to its own last digits, not to those of pi. */
static void cooled_ends_have_their_angles(void **state) {
    (void)state;
    enum { N = 11 };
    for (int power = 3; power <= 50; power += 47 / 3) {
        struct lattice l = {.dim = 1, .n = {N, 1}, .sign = {1, LAYOUT_ROBIN}, .robin = {0, 1 - ldexp(1, -power)}};
        double b = ldexp(1, -power) / (2 - ldexp(1, -power));
        double slowest = transform_angle(&l, 0, 0);
        assert_near(tan(N * slowest) * tan(slowest / 2) / b, 1, 16 * DBL_EPSILON);
        for (int k = 1; k < N; k++) {
            double theta = transform_angle(&l, 0, k);
            assert_near(theta, (PI * k + atan(b / tan(theta / 2))) / N, 4 * DBL_EPSILON * theta);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mode_has_one_coefficient),
        cmocka_unit_test(all_modes_give_the_data_back),
        cmocka_unit_test(cooled_ends_have_their_angles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
