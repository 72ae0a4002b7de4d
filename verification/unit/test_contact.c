/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two materials: contact_ssph is exact for piecewise quadratics, no mode grows at any ratio, and the heat of a start
 * that jumps; an interface anywhere. */

#include "solver/particles/start.h"
#include "solver/space/assembly.h"
#include "solver/space/operator.h"
#include "solver/particles/ssph.h"
#include "verification/stability/spectrum.h"
#include "solver/method.h"
#include "solver/particles/particles.h"
#include "solver/differences/ftcs.h"
#include "solver/space/sample.h"
#include "verification/case/command.h"
#include "verification/judge/run.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"
#include "verification/unit/stencil_moments.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

extern const struct method method_contact_ssph, method_so_ssph;

/* ---- exactness ---- */

static struct options options_of(enum layout_name layout) {
    int moved = layout == LAYOUT_JITTER || layout == LAYOUT_RELAXED;
    return (struct options){.dx = 0.05, .h = 1.23, .seed = 7, .layout = layout, .jitter = moved ? 0.5 : 0};
}

/* k_x = 0.7, 0.0311 and k_y = 0.4, 0.19 on either side of x = 0.4 m; rho c = 1.3, 0.9 */
static struct problem two_sides(int dim) {
    struct problem p = dim == 2 ? odd_rectangle() : odd_rod();
    p.materials = 2, p.interface = 0.4;
    p.material[1] = (struct material){{0.0311, 0.19}, 0.9};
    return p;
}

/* c . (1, x, y, x^2, x y, y^2) left of the interface; right of it the function for which T, k_x T_x and T_t are
 * continuous, found from T = a(y) + b(y) X + c X^2 with X = x - 0.4, not from the Taylor series about a particle. */
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
                double d[15][DIM_MAX] = {{0}}, c[6] = {0}, w[15], *out[2] = {w, NULL}, sum = 0;
                struct neighbourhood nb = {
                    .dim = dim, .x = {0.4 + offset[k], dim == 2 ? 0.83 : 0}, .n = 15, .d = d, .h = 0.061};
                if (dim == 1 && term == 2) continue;
                c[term] = 1.37;
                for (int j = 0; j < 15; j++)
                    for (int a = 0; a < dim; a++) d[j][a] = around[j][a];
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

static void one_material_reduces_to_so_ssph(void **state) {
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
    double lone[1][DIM_MAX] = {{0.041, 0.013}}, w[1], *out[2] = {w, NULL};
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

/* ---- growth ---- */

static double zero(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

static double cold(const struct problem *p, const double x[2]) {
    (void)p, (void)x;
    return 0;
}

struct cloud_case {
    int dim, n;
    double h, k, rho_c, interface;
    enum layout_name layout;
    double jitter;
    unsigned long seed;
};

/* 1 where a mode of the operator grows. */
static int grows(const struct cloud_case *c) {
    struct problem p = {.dim = c->dim,
                        .hi = {c->n, c->dim == 2 ? c->n : 0},
                        .t_end = 1,
                        .materials = 2,
                        .interface = c->interface,
                        .material = {{{1, 1}, 1}, {{c->k, c->k}, c->rho_c}},
                        .initial = cold,
                        .wall = zero};
    struct options o = {.dx = 1,
                        .h = c->h,
                        .layout = c->layout,
                        .jitter = c->jitter,
                        .sweeps = 2000,
                        .seed = c->seed,
                        .stepper = STEPPER_EULER};
    struct lattice l;
    struct cloud cloud;
    struct heat_operator a;
    struct spectrum s;
    struct failure why = {0};
    for (int side = 0; side < 4; side++) p.side[side] = c->seed % 2 ? DIRICHLET : NEUMANN;
    if (layout_lattice(&p, &o, &l, &why) || layout_cloud(&p, &o, &l, 2 * c->h, &cloud, &why) ||
        assembly_operator(&a, &p, &o, method_contact_ssph.scheme, &cloud, 1, &why) ||
        spectrum_create(&s, &a, &(struct amplification){STEPPER_EULER, 0}, &why))
        fail_msg("%s", why.text);
    int out = s.growth > spectrum_rounding(&s);
    if (out)
        print_error("dim %d h %g k %g rho_c %g layout %d jitter %g seed %lu: grows by %g\n", c->dim, c->h, c->k,
                    c->rho_c, (int)c->layout, c->jitter, c->seed, s.growth);
    spectrum_free(&s);
    operator_free(&a);
    layout_cloud_free(&cloud);
    return out;
}

static const double ratio[][2] = {{1e-4, 1},   {1e-2, 1}, {100, 1},   {1e4, 1},    {1, 1e-4},
                                  {1, 1e-2},   {1, 100},  {1, 1e4},   {100, 1e-2}, {1e-3, 1e3},
                                  {1e-4, 1e4}, {1e3, 10}, {1e3, 1e3}, {1e-4, 1e-4}};
enum { RATIOS = sizeof ratio / sizeof *ratio };

static const struct {
    enum layout_name layout;
    double jitter;
} clouds[] = {{LAYOUT_JITTER, 0}, {LAYOUT_JITTER, 0.1}, {LAYOUT_JITTER, 0.3}, {LAYOUT_RELAXED, 0.5}};
enum { CLOUDS = sizeof clouds / sizeof *clouds };

/* `seeds` draws of each cloud, with the interface at other places of its cell (on a particle too). */
static int count(int dim, int n, double h, int seeds) {
    int growing = 0;
    for (int q = 0; q < CLOUDS; q++)
        for (int k = 0; k < RATIOS; k++)
            for (int s = 0; s < seeds; s++) {
                struct cloud_case c = {dim,
                                       n,
                                       h,
                                       ratio[k][0],
                                       ratio[k][1],
                                       n / 2 + 0.25 * (s % 3),
                                       clouds[q].layout,
                                       clouds[q].jitter,
                                       (unsigned long)(1 + s + seeds * k)};
                growing += grows(&c);
            }
    return growing;
}

static void no_mode_grows_on_a_rod(void **state) {
    (void)state;
    assert_int_equal(count(1, 40, 1.1, 3), 0);
    assert_int_equal(count(1, 40, 2, 3), 0);
}

static void no_mode_grows_in_the_plane(void **state) {
    (void)state;
    assert_int_equal(count(2, 9, 1.1, 1), 0);
}

/* x, x^2/2 at two neighbours on either side of a particle of a rod. */
static void weights_are_not_negative(void **state) {
    (void)state;
    static const double at[] = {-2, -1, 0.3, 1.9};
    double P[4][FIT_TERMS_MAX] = {{0}}, W[4] = {1, 1, 4, 0.01}, b[2] = {0, 1}, w[4];
    for (int j = 0; j < 4; j++) P[j][0] = at[j], P[j][1] = at[j] * at[j] / 2;
    assert_int_equal(nonnegative_weights(4, 2, P, W, b, w), 1);
    double sum[2] = {0};
    for (int j = 0; j < 4; j++) {
        assert_order(w[j], >=, 0);
        for (int k = 0; k < 2; k++) sum[k] += w[j] * P[j][k];
    }
    assert_near(sum[0], 0, 1e-14);
    assert_near(sum[1], 1, 1e-14);
    assert_int_equal(nonnegative_weights(2, 2, P, W, b, w), 0); /* both on one side */
}

/* ---- starts ---- */

static double jump(const struct problem *p, const double x[2]) {
    return x[0] < p->interface ? 0.4 : 1.3;
}

static struct problem two_halves(void) {
    struct problem p = odd_rod();
    p.materials = 2, p.interface = 0.4; /* the middle of -0.35 to 1.15 m */
    p.material[1] = p.material[0];
    p.jumps[0] = 1, p.jump[0][0] = 0.4;
    p.initial = jump;
    p.t_end = 1e-5;
    return p;
}

static const struct options cells = {
    .dx = 0.05, .h = 1.1, .layout = LAYOUT_JITTER, .jitter = 0, .sampling = SAMPLING_CELL, .stepper = STEPPER_EULER};

/* A chain of equal rates, except for the first particle beyond the contact, whose rate towards the contact is -1.02
 * times the others.  Its conserved quantity changes sign there, l = -1/1.02.  The total is then one hundredth of
 * either side, and the side that should hold one half holds about fifty times the total. */
static int one_back(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                    struct failure *why) {
    (void)why;
    for (size_t j = 0; j < nb->n; j++) {
        double d = nb->d[j][0], x = nb->x[0];
        w[0][j] = fabs(d) < 1.4 * o->dx ? nb->kappa[0] / (o->dx * o->dx) : 0;
        if (x > p->interface && x + d < p->interface) w[0][j] *= -1.02;
    }
    return STATUS_OK;
}

static const struct scheme back_scheme = {.two_materials = 1, .sweeps = 1, .keeps_start = 1, .weights = one_back};
static const struct method back = {.name = "back", .accepts = "", .scheme = &back_scheme, .solve = particles_solve};

static void start_outside_the_data_range_is_refused(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct failure why = {0};
    struct field f;
    assert_int_equal(method_solve(&back, &p, &cells, &f, &why), STATUS_NUMERICAL);
    if (!strstr(why.text, "the initial temperature of particle ") ||
        !strstr(why.text, "the data are in [0.4, 1.3] K"))
        fail_msg("%s", why.text);
}

/* l A = 0 on a lattice and on a cloud, and sum l = all. */
static void left_null_vector_conserves_heat(void **state) {
    (void)state;
    for (int cloud = 0; cloud < 2; cloud++) {
        struct problem p = two_halves();
        struct options o = cells;
        struct lattice lattice;
        struct cloud c;
        struct heat_operator a;
        struct failure why;
        o.jitter = 0.3 * cloud, o.seed = 3;
        p.material[1].k[0] *= 0.1, p.side[X_LO] = p.side[X_HI] = NEUMANN;
        if (layout_lattice(&p, &o, &lattice, &why) || layout_cloud(&p, &o, &lattice, 2.2 * lattice.dx[0], &c, &why) ||
            assembly_operator(&a, &p, &o, method_contact_ssph.scheme, &c, lattice.dx[0], &why))
            fail_msg("%s", why.text);
        double *l = xcalloc(2 * a.n, sizeof *l), *sum = l + a.n, *A = xcalloc(a.n * a.n, sizeof *A), all = 0;
        assert_int_equal(start_kept(&a, 50, l, &why), STATUS_OK);
        operator_dense(&a, A);
        for (size_t i = 0; i < a.n; i++) {
            for (size_t j = 0; j < a.n; j++) sum[j] += l[i] * A[i * a.n + j];
            all += l[i];
        }
        for (size_t j = 0; j < a.n; j++) assert_near(sum[j], 0, 1e-11 * operator_bound(&a) * all / (double)a.n);
        assert_near(all, 50, 1e-10);
        free(l), free(A);
        operator_free(&a);
        layout_cloud_free(&c);
    }
}

/* ---- interface ---- */

static struct result result_of(const char *line) {
    struct command r;
    struct result out;
    struct failure why;
    if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (run_experiment(&r.experiment, &out, NULL)) fail_msg("%s: %s", line, out.failure.text);
    command_free(&r);
    return out;
}

static void interface_at_round_off_changes_nothing(void **state) {
    (void)state;
    const char *const names[] = {"brookshaw --mean series", "brookshaw --mean harmonic", "ftcs --mean series",
                                 "ftcs --mean arithmetic",  "brookshaw --set R=30",      "ftcs --set R=30"};
    const char *const places[] = {"1e-15", "-1e-15", "3e-16", "-1e-16"};
    for (int m = 0; m < 6; m++)
        for (int sampling = 0; sampling < 2; sampling++) {
            char line[200];
            const char *const words = "run rod-contact %s --dx 2/81 --fourier 0.15 --sampling %s --set x_c=%s";
            snprintf(line, sizeof line, words, names[m], sampling ? "cell" : "point", "0");
            struct result on = result_of(line);
            for (int k = 0; k < 4; k++) {
                snprintf(line, sizeof line, words, names[m], sampling ? "cell" : "point", places[k]);
                assert_near(result_of(line).error[NORM_L1] / on.error[NORM_L1], 1, 1e-9);
            }
        }
}

static void cut_cells_keep_heat_and_steady_profiles(void **state) {
    (void)state;
    const char *const names[] = {"brookshaw", "ftcs --fourier 0.1", "brookshaw --set R=1.7",
                                 "ftcs --fourier 0.1 --set R=1.7"};
    for (int m = 0; m < 4; m++) {
        char line[200];
        snprintf(line, sizeof line, "run rod-contact %s --mean series --dx 2/57 --set x_c=0.0731", names[m]);
        assert_near(result_of(line).heat_drift, 0, 1e-12);
        snprintf(line, sizeof line,
                 "run wall-composite %s --mean series --dx 1/23 --set x_c=0.4217 --set k2=0.1 --set rho_c2=0.3 --set "
                 "t_end=40",
                 names[m]);
        assert_near(result_of(line).error[NORM_L1], 0, 1e-11);
    }
}

static double sloping(const struct problem *p, const double x[2]) {
    (void)p;
    return 1 + 3 * x[0];
}

/* A cell that the contact cuts starts at its heat over its heat capacity; neither start is 0 here. */
static void cut_cells_start_with_their_heat(void **state) {
    (void)state;
    const char *const line = "run rod-contact ftcs --dx 0.1 --set x_c=0.03 --set T1=0.9 --set T2=0.3";
    struct command r;
    struct failure why;
    assert_int_equal(command_read(line, &r, &why), STATUS_OK);
    /* the cell from 0 to 0.1: 0.03 m of 2 J/m^3/K at 0.9 K, 0.07 m of 0.5 J/m^3/K at 0.3 K */
    double want = (0.03 * 2 * 0.9 + 0.07 * 0.5 * 0.3) / (0.03 * 2 + 0.07 * 0.5);
    const double x[2] = {0.05, 0}, d[2] = {0.1, 0.1};
    assert_near(ftcs_sample(&r.experiment.problem, x, d, SAMPLING_POINT), want, 1e-14);
    assert_near(ftcs_sample(&r.experiment.problem, x, d, SAMPLING_CELL), want, 1e-14);
    /* and a start that varies: the middles of the parts are at 0.015 m and 0.065 m */
    r.experiment.problem.initial = sloping;
    want = (0.03 * 2 * 1.045 + 0.07 * 0.5 * 1.195) / (0.03 * 2 + 0.07 * 0.5);
    for (enum sampling how = SAMPLING_POINT; how <= SAMPLING_CELL; how++) {
        assert_near(ftcs_sample(&r.experiment.problem, x, d, how), want, 1e-14);
        assert_near(sample_cell(&r.experiment.problem, how, d, x), want, 1e-14);
    }
    command_free(&r);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(piecewise_quadratics_are_exact),
        cmocka_unit_test(one_material_reduces_to_so_ssph),
        cmocka_unit_test(poor_contacts_are_refused),
        cmocka_unit_test(no_mode_grows_on_a_rod),
        cmocka_unit_test(no_mode_grows_in_the_plane),
        cmocka_unit_test(weights_are_not_negative),
        cmocka_unit_test(start_outside_the_data_range_is_refused),
        cmocka_unit_test(left_null_vector_conserves_heat),
        cmocka_unit_test(interface_at_round_off_changes_nothing),
        cmocka_unit_test(cut_cells_keep_heat_and_steady_profiles),
        cmocka_unit_test(cut_cells_start_with_their_heat),
    };
    return cmocka_run_group_tests_name("contact", tests, NULL, NULL);
}
