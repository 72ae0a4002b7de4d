/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SSPH across a contact: fields that it must have exactly, one material, and what is refused. */
#include "solver/space/operator.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <string.h>

extern const struct method method_so_ssph, method_contact_ssph;

static struct options options_of(enum layout_name layout) {
    return (struct options){.dx = 0.05, .h = 1.23, .seed = 7, .layout = layout, .jitter = 0.5, .sweeps = 2000};
}

/* k_x = 0.7, 0.0311 and k_y = 0.4, 0.19 on either side of x = 0.4 m; rho c = 1.3, 0.9 */
static struct problem two_sides(int dim) {
    struct problem p = dim == 2 ? odd_rectangle() : odd_rod();
    p.materials = 2, p.interface = 0.4;
    p.material[1] = (struct material){{0.0311, 0.19}, 0.9};
    return p;
}

/* c . (1, x, y, x^2, x y, y^2) left of the interface, and right of it what T, k_x T_x and T_t continuous make of it;
 * found from T = a(y) + b(y) X + c X^2 with X = x - 0.4, not from the Taylor series about a particle. */
static double field_at(const struct problem *p, const double c[6], const double x[2]) {
    const struct material *m = p->material;
    double X = x[0] - 0.4, y = x[1], at = 0.4;
    double a = c[0] + c[1] * at + c[2] * y + c[3] * at * at + c[4] * at * y + c[5] * y * y;
    double b = c[1] + 2 * c[3] * at + c[4] * y;
    if (X < 0) return a + b * X + c[3] * X * X;
    double t = m[0].k[0] / m[0].rho_c * 2 * c[3] + m[0].k[1] / m[0].rho_c * 2 * c[5]; /* T_t, K/s */
    double curved = (t - m[1].k[1] / m[1].rho_c * 2 * c[5]) / (2 * m[1].k[0] / m[1].rho_c);
    return a + m[0].k[0] / m[1].k[0] * b * X + curved * X * X;
}

static const double around[15][2] = {{0.041, 0.013},  {-0.052, 0.007}, {0.003, 0.049},  {-0.011, -0.055},
                                     {0.063, -0.038}, {-0.047, 0.058}, {0.034, 0.071},  {-0.069, -0.041},
                                     {0.083, 0.029},  {-0.089, 0.019}, {0.017, -0.101}, {-0.021, 0.093},
                                     {0.022, -0.029}, {0.097, -0.011}, {-0.027, 0.023}};

static void piecewise_quadratics_are_exact(void **state) {
    (void)state;
    static const double offset[] = {-0.101, -0.043, -0.0007, 0.0009, 0.037, 0.094};
    for (int dim = 1; dim <= 2; dim++)
        for (int k = 0; k < 6; k++)
            for (int term = 0; term < (dim == 2 ? 6 : 4); term++) {
                struct problem p = two_sides(dim);
                struct options o = {.kernel = KERNEL_CUBIC};
                struct failure why = {0};
                double d[15][2], c[6] = {0}, w[15], *out[2] = {w, NULL}, sum = 0;
                struct neighbourhood nb = {
                    .dim = dim, .x = {0.4 + offset[k], dim == 2 ? 0.83 : 0}, .n = 15, .d = d, .h = 0.061};
                if (dim == 1 && term == 2) continue;
                c[term] = 1.37;
                memcpy(d, around, sizeof d);
                for (int j = 0; j < 15 && dim == 1; j++) d[j][1] = 0;
                const struct material *m = &p.material[offset[k] > 0];
                for (int a = 0; a < 2; a++) nb.kappa[a] = m->k[a] / m->rho_c;
                if (operator_weights(method_contact_ssph.scheme, &p, &o, &nb, out, &why))
                    print_error("%s\n", why.text);
                assert_int_equal(why.status, STATUS_OK);
                for (int j = 0; j < 15; j++) {
                    double at[2] = {nb.x[0] + d[j][0], nb.x[1] + d[j][1]};
                    sum += w[j] * (field_at(&p, c, at) - field_at(&p, c, nb.x));
                }
                const struct material *left = &p.material[0];
                double t = (left->k[0] * 2 * c[3] + (dim == 2) * left->k[1] * 2 * c[5]) / left->rho_c;
                assert_near(sum, t, 1e-9);
            }
}

static void one_material_is_so_ssph(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_JITTER);
    struct field a, b;
    struct failure why;
    o.jitter = 0.31;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &a, &why), STATUS_OK);
    assert_int_equal(method_solve(&method_contact_ssph, &p, &o, &b, &why), STATUS_OK);
    assert_memory_equal(a.T, b.T, a.n * sizeof *a.T);
    field_free(&a);
    field_free(&b);
}

static double heated(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 0.7;
}

static void poor_contacts_are_refused(void **state) {
    (void)state;
    struct problem p = two_sides(2);
    struct options o = options_of(LAYOUT_JITTER);
    struct field f;
    struct failure why;
    double lone[1][2] = {{0.041, 0.013}}, w[1], *out[2] = {w, NULL};
    struct neighbourhood nb = {
        .dim = 2, .i = 3, .x = {0.39, 0.83}, .n = 1, .d = lone, .h = 0.061, .kappa = {0.5, 0.3}};
    assert_int_equal(operator_weights(method_contact_ssph.scheme, &p, &o, &nb, out, &why), STATUS_NUMERICAL);
    assert_has(why.text, "particle 3");
    assert_has(why.text, "has 1 neighbours for 5 unknowns, condition number");
    p.interface = p.hi[0] - 0.11;
    assert_int_equal(method_solve(&method_contact_ssph, &p, &o, &f, &why), STATUS_INPUT);
    assert_has(why.text, "0.11 m from a wall");
    p = two_sides(2);
    p.source = heated;
    assert_int_equal(method_solve(&method_contact_ssph, &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "brookshaw");
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(piecewise_quadratics_are_exact),
        cmocka_unit_test(one_material_is_so_ssph),
        cmocka_unit_test(poor_contacts_are_refused),
    };
    return cmocka_run_group_tests_name("contact_ssph", tests, NULL, NULL);
}
