/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derived quantities of numerical fields: exact for polynomials of degree five, and as good as the field beside them.
 */
#include "verification/judge/derived.h"

#include "references/quantity.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "verification/case/command.h"
#include "verification/judge/ladder.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <string.h>

/* T = x^3 y^2 - 0.7 x y + 0.2 x^5 + 1.3 y^4 on [-1, 2] x [0.5, 1.7], k = (0.3, 0.8), rho c = 1.9. */
static double T(double x, double y) {
    return x * x * x * y * y - 0.7 * x * y + 0.2 * pow(x, 5) + 1.3 * pow(y, 4);
}

/* Cells of 0.1 m, each with a point that is moved by up to 0.03 m. */
static void fill(struct field *f) {
    field_alloc(f, 2, 30 * 12);
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 30; i++) {
            size_t k = (size_t)(30 * j + i);
            f->x[0][k] = -1 + 0.1 * (i + 0.5) + 0.03 * sin(7.0 * i + 3.0 * j);
            f->x[1][k] = 0.5 + 0.1 * (j + 0.5) + 0.03 * cos(5.0 * i + 11.0 * j);
            f->T[k] = T(f->x[0][k], f->x[1][k]);
        }
}

static void exact_for_polynomials(void **state) {
    (void)state;
    struct problem p = {.dim = 2, .lo = {-1, 0.5}, .hi = {2, 1.7}, .materials = 1, .material = {{{0.3, 0.8}, 1.9}}};
    struct field f;
    struct failure why;
    fill(&f);
    const double y2 = (pow(1.7, 3) - pow(0.5, 3)) / 3, y1 = (1.7 * 1.7 - 0.25) / 2, x4 = 3.75, x2 = 1.5;
    const double y5 = (pow(1.7, 5) - pow(0.5, 5)) / 5;
    const struct {
        struct quantity quantity;
        double value;
    } row[] = {
        {{.kind = QUANTITY_AT, .at = {0.2137, 1.1}}, T(0.2137, 1.1)},
        /* -k_x dT/dx at x = -1, integrated over y; k_y dT/dy at y = 1.7 over x */
        {{.kind = QUANTITY_FLUX, .side = X_LO}, -0.3 * (3 * y2 - 0.7 * y1 + 1.0 * 1.2)},
        {{.kind = QUANTITY_FLUX, .side = Y_HI}, 0.8 * (2 * 1.7 * x4 - 0.7 * x2 + 5.2 * pow(1.7, 3) * 3)},
        {{.kind = QUANTITY_HEAT}, 1.9 * (x4 * y2 - 0.7 * x2 * y1 + 0.2 * (64 - 1) / 6.0 * 1.2 + 1.3 * y5 * 3)},
    };
    for (int i = 0; i < 4; i++) {
        double value;
        if (derived_value(&row[i].quantity, &p, &f, 0.1, &value, &why)) fail_msg("%s", why.text);
        assert_near(value, row[i].value, 1e-8 * fabs(row[i].value));
    }
    field_free(&f);
}

/* T = 1 + cos(x) cos(2 y) on [0, 3] x [0, 5], 30 by 50 spacings: 8 by 13 panels of four at most.  Gauss and
 * Legendre's rule misses h^7 (3!)^4 / (7 (6!)^3) of the sixth derivative, 2^6 at most: 5.2e-8 of a panel of 0.4 m,
 * 2e-6 of 13 over 3 m.  A polynomial of degree five leaves (2 r)^6/6! within the reach r = 0.35 m of 36
 * points, 1.6e-4 at most. With one panel along y it would miss by some of T itself. */
static void heat_by_many_panels(void **state) {
    (void)state;
    struct problem p = {.dim = 2, .hi = {3, 5}, .materials = 1, .material = {{{1, 1}, 1.9}}};
    struct field f;
    struct failure why;
    double value;
    field_alloc(&f, 2, 30 * 50);
    for (size_t k = 0; k < f.n; k++) {
        f.x[0][k] = 0.1 * ((double)(k % 30) + 0.5), f.x[1][k] = 0.1 * ((double)(k / 30) + 0.5);
        f.T[k] = 1 + cos(f.x[0][k]) * cos(2 * f.x[1][k]);
    }
    if (derived_value(&(struct quantity){.kind = QUANTITY_HEAT}, &p, &f, 0.1, &value, &why)) fail_msg("%s", why.text);
    assert_near(value, 1.9 * (15 + sin(3) * sin(10) / 2), 1.9 * 15 * 1.6e-4);
    field_free(&f);
}

/* T = x sin(4 y) on [0, 1] x [-2, 2.5], 20 by 90 spacings: the integral of -sin(4 y) flows in through x = 0, by 23
 * panels of 0.2 m at most, which miss 2e-8.  The slope of a polynomial of degree five leaves (4 r)^5/5! within the
 * reach r = 0.175 m of 36 points, 1.4e-3 at most, of 4.5 m.  Three panels would miss 4^6 h^7 (3!)^4/(7 (6!)^3) each,
 * 0.03. */
static void flux_by_many_panels(void **state) {
    (void)state;
    struct problem p = {.dim = 2, .lo = {0, -2}, .hi = {1, 2.5}, .materials = 1, .material = {{{1, 1}, 1}}};
    struct field f;
    struct failure why;
    double value;
    field_alloc(&f, 2, 20 * 90);
    for (size_t k = 0; k < f.n; k++) {
        f.x[0][k] = 0.05 * ((double)(k % 20) + 0.5), f.x[1][k] = -2 + 0.05 * ((double)(k / 20) + 0.5);
        f.T[k] = f.x[0][k] * sin(4 * f.x[1][k]);
    }
    struct quantity through = {.kind = QUANTITY_FLUX, .side = X_LO};
    if (derived_value(&through, &p, &f, 0.05, &value, &why)) fail_msg("%s", why.text);
    assert_near(value, (cos(10) - cos(-8)) / 4, 4.5 * 1.4e-3);
    field_free(&f);
}

/* k = 0.3 and 0.0007 W/m/K on either side of x = 0.4 m and the same slope: the flux of each wall has its local k. */
static void a_wall_of_two_layers_has_the_conductivity_at_it(void **state) {
    (void)state;
    struct problem p = {.dim = 1,
                        .lo = {-1, 0},
                        .hi = {2, 0},
                        .materials = 2,
                        .interface = 0.4,
                        .material = {{{0.3, 0.3}, 1.9}, {{0.0007, 0.0007}, 0.6}}};
    struct field f;
    struct failure why;
    double low, high;
    field_alloc(&f, 1, 30);
    for (int i = 0; i < 30; i++) f.x[0][i] = -1 + 0.1 * (i + 0.5), f.T[i] = 2.3 - 1.7 * f.x[0][i];
    for (int side = X_LO; side <= X_HI; side++)
        if (derived_value(&(struct quantity){.kind = QUANTITY_FLUX, .side = (enum side)side}, &p, &f, 0.1,
                          side == X_LO ? &low : &high, &why))
            fail_msg("%s", why.text);
    assert_near(low, 0.3 * 1.7, 1e-10);
    assert_near(high, -0.0007 * 1.7, 1e-12);
    field_free(&f);
}

/* T^n on a cloud is a straight line in r^2 in a plane, with another r_f along the diagonals, and in x behind a wall.
 */
static void a_front_is_the_root_of_a_line(void **state) {
    (void)state;
    const struct problem plane = {.dim = 2,
                                  .hi = {1, 1},
                                  .k_law = K_POWER,
                                  .k_n = 2.7,
                                  .k_ref = -0.3,
                                  .side = {NEUMANN, NEUMANN, NEUMANN, NEUMANN}};
    const struct problem rod = {.dim = 1, .hi = {1}, .k_law = K_POWER, .k_n = 3, .k_ref = 0.2};
    const double want[] = {0.71, 0.83};
    struct field f, line;
    struct failure why;
    double value;
    field_alloc(&f, 2, 900);
    field_alloc(&line, 1, 30);
    for (size_t k = 0; k < f.n; k++) {
        const double x = f.x[0][k] = ((double)(k % 30) + 0.5 + 0.3 * sin(7.0 * (double)k)) / 30;
        const double y = f.x[1][k] = ((double)(k / 30) + 0.5 + 0.3 * cos(5.0 * (double)k)) / 30;
        const int diagonal = fabs(atan2(y, x) - M_PI / 4) < M_PI / 8;
        f.T[k] = -0.3 + 1.9 * pow(fmax(0, 1 - (x * x + y * y) / pow(want[diagonal], 2)), 1 / 2.7);
    }
    for (size_t k = 0; k < line.n; k++)
        line.x[0][k] = ((double)k + 0.5) / 30, line.T[k] = 0.2 + cbrt(fmax(0, 0.6180 - line.x[0][k]));
    for (int sector = FRONT_AXES; sector <= FRONT_DIAGONALS; sector++) {
        const struct quantity q = {.kind = QUANTITY_FRONT, .sector = (enum front_sector)sector};
        if (derived_value(&q, &plane, &f, 1.0 / 30, &value, &why)) fail_msg("%s", why.text);
        assert_near(value, want[sector == FRONT_DIAGONALS], 1e-12);
    }
    const struct quantity all = {.kind = QUANTITY_FRONT};
    if (derived_value(&all, &rod, &line, 1.0 / 30, &value, &why)) fail_msg("%s", why.text);
    assert_near(value, 0.6180, 1e-12);
    for (size_t k = 0; k < line.n; k++) line.T[k] = 0.2;
    assert_int_equal(derived_value(&all, &rod, &line, 1.0 / 30, &value, &why), STATUS_NUMERICAL);
    field_free(&f);
    field_free(&line);
}

static void climb(const char *line, struct ladder *l, int wanted, const char *because) {
    struct command r;
    struct failure why = {0};
    int status = command_read(line, &r, &why);
    if (!status) status = ladder_run(&r.experiment, &r.rungs, l, &why);
    if (status != wanted || !strstr(why.text, because)) fail_msg("%s: %d, %s", line, status, why.text);
    command_free(&r);
    ladder_free(l);
}

static void derived_quantities_have_ladders(void **state) {
    (void)state;
    struct ladder l;
    climb("ladder rod-cosine so_ssph --dx 1/20,1/40,1/80,1/160 --quantity at:0.3 --expect 1.95,2.05", &l, 0, "");
    assert_int_equal(l.verdict, VERDICT_PASS);
    climb("ladder rod-contact brookshaw --mean series --dx 1/40,1/80,1/160,1/320 --quantity heat --expect 1.9,2.1",
          &l, 0, "");
    assert_near(l.local[2], 2, 0.05);
    assert_near(l.rung[3].derived, 2, 1e-5); /* rho_c1 T1 L */
}

static void undefined_quantities_are_refused(void **state) {
    (void)state;
    struct ladder l;
    climb("ladder plate ftcs --dx 0.02,0.01 --quantity flux_x_lo", &l, STATUS_INPUT, "has no finite value");
    climb("ladder plate ftcs --dx 0.02,0.01 --quantity flux", &l, STATUS_INPUT, "unknown quantity 'flux'");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_for_polynomials),
        cmocka_unit_test(heat_by_many_panels),
        cmocka_unit_test(flux_by_many_panels),
        cmocka_unit_test(a_wall_of_two_layers_has_the_conductivity_at_it),
        cmocka_unit_test(a_front_is_the_root_of_a_line),
        cmocka_unit_test(derived_quantities_have_ladders),
        cmocka_unit_test(undefined_quantities_are_refused),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("derived", tests, NULL, NULL);
}
