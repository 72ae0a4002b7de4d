/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The discrete Laplacians on neighbourhoods without any symmetry: what each must have exactly, which of them conserve
 * heat, and what they refuse. */
#include "solver/particles/compatibility.h"
#include "solver/space/csr.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"
#include "verification/unit/odd_neighbourhood.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>

/* sum_j w_j x_j^a y_j^b */
static double moment(const double *w, int a, int b) {
    double sum = 0;
    for (int j = 0; j < MANY; j++) sum += w[j] * pow(place[j][0], a) * pow(place[j][1], b);
    return sum;
}

static const double both[2] = {0.71, 0.43}, same[2] = {0.71, 0.71};

static void linear_fields_stay(void **state) {
    (void)state;
    static const char *const exact[] = {"schwaiger", "fatehi_manzari", "cspm", "so_ssph", "positive"};
    static const char *const others[] = {"brookshaw", "brookshaw_corrected", "kernel_second"};
    double w[2][MANY];
    struct neighbourhood nb = around(2, same);
    for (int k = 0; k < 5; k++) {
        weights_of(exact[k], &nb, w);
        assert_near(moment(w[0], 1, 0), 0, 1e-10);
        assert_near(moment(w[0], 0, 1), 0, 1e-10);
    }
    for (int k = 0; k < 3; k++) {
        weights_of(others[k], &nb, w);
        assert_order(fabs(moment(w[0], 1, 0)), >, 0.01);
    }
}

static void quadratics_are_exact(void **state) {
    (void)state;
    static const char *const exact[] = {"fatehi_manzari", "so_ssph", "positive"};
    double w[2][MANY];
    struct neighbourhood nb = around(2, both);
    for (int k = 0; k < 3; k++) {
        weights_of(exact[k], &nb, w);
        assert_near(moment(w[0], 2, 0), 2 * KX, 1e-12);
        assert_near(moment(w[0], 0, 2), 2 * KY, 1e-12);
        assert_near(moment(w[0], 1, 1), 0, 1e-12);
    }
    nb = around(2, same);
    weights_of("brookshaw_corrected", &nb, w); /* of the distance's square alone */
    assert_near(moment(w[0], 2, 0) + moment(w[0], 0, 2), 4 * KX, 1e-12);
    assert_order(fabs(moment(w[0], 2, 0) - moment(w[0], 0, 2)), >, 0.01);
    weights_of("cspm", &nb, w);
    assert_order(fabs(moment(w[0], 2, 0) - 2 * KX), >, 0.001);
}

static void positive_weights(void **state) {
    (void)state;
    double w[2][MANY];
    struct neighbourhood nb = around(2, same);
    weights_of("brookshaw_corrected", &nb, w);
    for (int j = 0; j < MANY; j++) assert_order(w[0][j], >=, 0);
    nb = around(2, both);
    weights_of("positive", &nb, w);
    for (int j = 0; j < MANY; j++) assert_order(w[0][j], >=, 0);
}

/* ---- On lattices, through operator and rows ---- */

static void second_moments_on_the_lattice(void **state) {
    (void)state;
    static const char *const all[] = {"brookshaw_corrected", "schwaiger",       "fatehi_manzari", "cspm",
                                      "kernel_second",       "flux_divergence", "positive",       "conjugate"};
    for (int m = 0; m < 8; m++)
        for (int k = 0; kernel_words[k]; k++) {
            struct options o = {.dx = 0.05, .h = 1.23, .kernel = (enum kernel_name)k};
            struct problem p = odd_rectangle();
            struct failure why;
            int reach[2];
            double *w, sum[3] = {0, 0, 0};
            assert_int_equal(operator_stencil(&p, &o, named(all[m])->scheme, 1, same, reach, &w, &why), STATUS_OK);
            for (int j = -reach[1]; j <= reach[1]; j++)
                for (int i = -reach[0]; i <= reach[0]; i++) {
                    double v = w[abs(j) * (reach[0] + 1) + abs(i)];
                    sum[0] += v * i * i, sum[1] += v * j * j, sum[2] += v;
                }
            free(w);
            assert_near(sum[0], 2 * KX, 1e-11);
            assert_near(sum[1], 2 * KX, 1e-11);
            assert_near(sum[2], 0, 1e-12);
        }
}

static double no_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 0;
}

/* Sums of columns: d/dt of the heat that 1 K at particle j makes, over the largest weight. */
static double lost(const char *name, double jitter) {
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05, .h = 1.23, .seed = 7, .layout = LAYOUT_JITTER, .jitter = jitter};
    struct lattice l;
    struct cloud c;
    struct heat_operator a;
    struct failure why;
    for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
    p.wall = no_flux;
    p.material[0].k[1] = p.material[0].k[0];
    const struct scheme *s = named(name)->scheme;
    assert_int_equal(layout_lattice(&p, &o, 1, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&p, &o, &l, s->sweeps * 2 * o.h * l.dx[0], &c, &why), STATUS_OK);
    assert_int_equal(operator_create_csr(&a, &p, &o, s, &c, l.dx[0], &why), STATUS_OK);
    double *sum = xcalloc(a.n, sizeof *sum), most = 0, size = 0;
    struct row r;
    csr_row_create(&r, a.n);
    for (size_t i = 0; i < a.n; i++) {
        operator_row_take(&a, i, &r);
        size = fmax(size, fabs(r.value[i]));
        for (size_t k = 0; k < r.n; k++) sum[r.column[k]] += r.value[r.column[k]];
    }
    csr_row_free(&r);
    for (size_t i = 0; i < a.n; i++) most = fmax(most, fabs(sum[i]));
    free(sum);
    operator_free(&a);
    layout_cloud_free(&c);
    return most / size;
}

static void who_conserves_heat(void **state) {
    (void)state;
    static const char *const all[] = {"brookshaw",           "kernel_second", "so_ssph",        "fo_ssph",
                                      "brookshaw_corrected", "schwaiger",     "fatehi_manzari", "cspm",
                                      "flux_divergence",     "positive",      "conjugate"};
    for (int m = 0; m < 11; m++) {
        assert_near(lost(all[m], 0), 0, 1e-13);
        if (m < 2 || m == 10)
            assert_near(lost(all[m], 0.31), 0, 1e-13);
        else
            assert_order(lost(all[m], 0.31), >, 0.01);
    }
}

/* ---- Refusals ---- */

static int try_weights(const char *name, size_t n, double (*d)[2], struct failure *why) {
    struct problem p = odd_rectangle();
    struct options o = {.kernel = KERNEL_CUBIC};
    double w[2][MANY], *out[2] = {w[0], w[1]};
    struct neighbourhood nb = around(2, same);
    nb.n = n, nb.d = d;
    return operator_weights(named(name)->scheme, &p, &o, &nb, out, why);
}

static void try_few(const char *name, size_t n, double (*d)[2], const char *says) {
    struct failure why = {0};
    assert_int_equal(try_weights(name, n, d, &why), STATUS_NUMERICAL);
    assert_has(why.text, "particle 3 at (0.7, -0.3) m");
    assert_has(why.text, says);
}

static void poor_clouds_are_refused(void **state) {
    (void)state;
    static const char *const corrected[] = {"brookshaw_corrected", "schwaiger", "fatehi_manzari", "cspm"};
    double line[4][2] = {{0.021, 0.042}, {-0.017, -0.034}, {0.043, 0.086}, {-0.03, -0.06}};
    double right[5][2] = {{0.041, 0.013}, {0.003, 0.049}, {0.011, -0.055}, {0.063, -0.038}, {0.021, 0.007}};
    struct failure why;
    double three[2][2] = {{0.041, 0.013}, {0.003, 0.049}}, twice[2][2] = {{0.041, 0.013}, {0, 0}};
    for (int m = 0; m < 4; m++) {
        try_few(corrected[m], 0, place, "has 0 neighbours, condition number");
        try_few(corrected[m], 4, line, "has 4 neighbours, condition number");
    }
    try_few("fatehi_manzari", 2, three, "has 2 neighbours, condition number");
    try_few("cspm", 2, three, "has 2 neighbours, condition number");
    try_few("kernel_second", 2, twice, "at the same place");
    static const char *const empty = "neighbours, none in one half of the plane";
    for (size_t n = 0; n < 3; n++) try_few("kernel_second", n, place, empty);
    try_few("kernel_second", 4, line, "has 4 neighbours, none in one half of the plane");
    for (int turn = 0; turn < 4; turn++) { /* whichever half is empty */
        try_few("kernel_second", 5, right, empty);
        for (int j = 0; j < 5; j++) {
            double x = right[j][0];
            right[j][0] = -right[j][1], right[j][1] = x;
        }
    }
    try_few("positive", 5, right, "no weights >= 0");
    try_few("positive", 4, line, "take a larger --h");
    right[4][0] = -0.011, right[4][1] = 0.018; /* leaves a gap of 160 degrees */
    assert_int_equal(try_weights("kernel_second", 5, right, &why), STATUS_OK);
    try_few("flux_divergence", 0, place, "has 0 neighbours, condition number infinite");
    try_few("flux_divergence", 1, place, "has 1 neighbours, condition number");
    try_few("flux_divergence", 4, line, "has 4 neighbours, condition number");
    assert_int_equal(try_weights("flux_divergence", 2, three, &why), STATUS_OK);
}

static void what_cannot_be_had_is_refused(void **state) {
    (void)state;
    static const char *const all[] = {"brookshaw_corrected", "schwaiger", "kernel_second", "fatehi_manzari", "cspm",
                                      "flux_divergence",     "positive",  "conjugate"};
    struct options o = {.kernel = KERNEL_CUBIC};
    struct failure why;
    for (int m = 0; m < 8; m++) {
        struct problem p = odd_rectangle(); /* k_x and k_y differ */
        assert_int_equal(compatibility_check(&p, &o, named(all[m])->scheme, &why),
                         m < 3 ? STATUS_NOT_APPLICABLE : STATUS_OK);
        p.materials = 2;
        assert_int_equal(compatibility_check(&p, &o, named(all[m])->scheme, &why), STATUS_NOT_APPLICABLE);
        assert_has(why.text, "take brookshaw");
    }
    struct problem p = odd_rectangle();
    assert_int_equal(compatibility_check(&p, &o, named("brookshaw")->scheme, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "brookshaw: isotropic conductivity only");
    o.volume = VOLUME_TUNED;
    p = odd_rod();
    assert_int_equal(compatibility_check(&p, &o, named("brookshaw")->scheme, &why), STATUS_OK);
    assert_int_equal(compatibility_check(&p, &o, named("kernel_second")->scheme, &why), STATUS_NOT_APPLICABLE);
    assert_int_equal(compatibility_check(&p, &o, named("flux_divergence")->scheme, &why), STATUS_NOT_APPLICABLE);
    assert_int_equal(compatibility_check(&p, &o, named("conjugate")->scheme, &why), STATUS_NOT_APPLICABLE);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_fields_stay),
        cmocka_unit_test(quadratics_are_exact),
        cmocka_unit_test(positive_weights),
        cmocka_unit_test(second_moments_on_the_lattice),
        cmocka_unit_test(who_conserves_heat),
        cmocka_unit_test(poor_clouds_are_refused),
        cmocka_unit_test(what_cannot_be_had_is_refused),
    };
    return cmocka_run_group_tests_name("laplacians", tests, NULL, NULL);
}
