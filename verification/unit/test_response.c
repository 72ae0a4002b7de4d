/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Responses and truncation errors for bodies whose solution is one cosine: each Euler step multiplies it by G, so
 * that the run on the lattice is known as well as the solution. */
#include "verification/fault/response.h"

#include "references/scene.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/fault/diagnosis.h"
#include "verification/fault/fit.h"
#include "verification/fault/melting.h"

#include "verification/unit/diagnosed_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

enum { N = 40 };
static const double KAPPA[2] = {0.35, 0.2}, LO[2] = {0.2, -0.6}, WIDE[2] = {1.3, 0.91};

static double q_of(int a) {
    return (a ? 1 : 2) * M_PI / WIDE[a];
}

static double mode(int dim, const double x[2]) {
    return cos(q_of(0) * (x[0] - LO[0])) * (dim == 2 ? cos(q_of(1) * (x[1] - LO[1])) : 1);
}

static double start(const struct problem *p, const double x[2]) {
    return 3 * mode(p->dim, x);
}

/* Insulated; of rho c = 2. */
static struct problem body(int dim) {
    struct problem p = {.dim = dim,
                        .t_end = 0.1,
                        .materials = 1,
                        .side = {NEUMANN, NEUMANN, NEUMANN, NEUMANN},
                        .initial = start,
                        .wall = problem_held};
    p.material[0] = (struct material){{2 * KAPPA[0], 2 * KAPPA[1]}, 2};
    for (int a = 0; a < dim; a++) p.lo[a] = LO[a], p.hi[a] = LO[a] + WIDE[a];
    return p;
}

static double rate(int dim) { /* T falls as exp(-rate t) */
    return KAPPA[0] * q_of(0) * q_of(0) + (dim == 2 ? KAPPA[1] * q_of(1) * q_of(1) : 0);
}

/* Amplification of the mode by the steps of that mesh Fourier number. */
static double fall(int dim, double dx, double fourier, double t) {
    double steps = ceil(t * KAPPA[0] / (fourier * dx * dx)), dt = t / steps, G = 1;
    for (int a = 0; a < dim; a++) G -= 4 * dt * KAPPA[a] * pow(sin(q_of(a) * dx / 2) / dx, 2);
    return pow(G, steps);
}

/* Points in the middle part, where the splines do not depend on the ends. */
static void points(int dim, struct field *f) {
    field_alloc(f, dim, N);
    for (int i = 0; i < N; i++) {
        f->x[0][i] = LO[0] + WIDE[0] * (0.31 + 0.0097 * i);
        if (dim == 2) f->x[1][i] = LO[1] + WIDE[1] * (0.69 - 0.0083 * i);
    }
}

static double mode_at(const struct field *f, int i) {
    return mode(f->dim, (double[2]){f->x[0][i], f->dim == 2 ? f->x[1][i] : 0});
}

static void response_lattice_decays_one_mode(void **state) {
    (void)state;
    for (int dim = 1; dim <= 2; dim++) {
        struct problem p = body(dim);
        struct response_lattice l;
        struct field f;
        double base[N], longer[N], laplace[N];
        assert_int_equal(response_lattice_create(&p, &l), 0);
        assert_int_equal(l.n[0], dim == 2 ? 70 : 64); /* 7 rows for 10 columns */
        assert_int_equal(l.n[1], dim == 2 ? 49 : 1);
        assert_near(l.dx, WIDE[0] / l.n[0], 1e-15);
        points(dim, &f);
        response_base(&p, &l, &f, base, longer);
        response_laplacian(&p, &l, &f, laplace);
        double T = 3 * fall(dim, l.dx, 0.05, p.t_end), late = 3 * fall(dim, l.dx, 0.15, p.t_end), minus = 0;
        for (int a = 0; a < dim; a++) minus += pow(2 * sin(q_of(a) * l.dx / 2) / l.dx, 2);
        for (int i = 0; i < N; i++) {
            assert_near(base[i], T * mode_at(&f, i), 3e-6);
            assert_near(longer[i], (late - T) / 0.1 * mode_at(&f, i), 3e-6);
            assert_near(laplace[i], -minus * T * mode_at(&f, i), 3e-6 * minus);
        }
        field_free(&f);
        response_lattice_free(&l);
    }
}

/* Half a cell from a side to the next centre: the line goes on, with the curvature of the cell further in. */
static void response_extrapolates_linearly_to_the_wall(void **state) {
    (void)state;
    for (int dim = 1; dim <= 2; dim++)
        for (int side = 0; side < 2 * dim; side++) {
            struct problem p = body(dim);
            struct response_lattice l;
            struct field f;
            double base[3], longer[3], laplace[3], minus = 0;
            int a = side / 2;
            assert_int_equal(response_lattice_create(&p, &l), 0);
            field_alloc(&f, dim, 3);
            for (int i = 0; i < 3; i++) {
                double x[2] = {LO[0] + 20.5 * l.dx, LO[1] + 20.5 * l.dx};
                x[a] = side % 2 ? p.hi[a] - i * l.dx / 4 : p.lo[a] + i * l.dx / 4;
                field_put(&f, (size_t)i, x);
            }
            response_base(&p, &l, &f, base, longer);
            response_laplacian(&p, &l, &f, laplace);
            double T = 3 * fall(dim, l.dx, 0.05, p.t_end) * mode_at(&f, 2);
            assert_near(base[2], T, 1e-12); /* a centre */
            assert_near(base[1] - base[0], base[2] - base[1], 1e-12);
            assert_order(fabs(base[2] - base[0]), >, 1e-6);
            for (int b = 0; b < dim; b++) {
                double curved = pow(2 * sin(q_of(b) * l.dx / 2) / l.dx, 2);
                minus += b == a ? curved * cos(1.5 * q_of(a) * l.dx) / cos(0.5 * q_of(a) * l.dx) : curved;
            }
            assert_near(laplace[2], -minus * T, 1e-8);
            field_free(&f);
            response_lattice_free(&l);
        }
}

/* A face of the arithmetic mean has 250 times the harmonic mean's rate: Euler's steps are unstable. */
static void a_mean_of_conductivities_a_thousand_apart_has_a_response(void **state) {
    (void)state;
    struct problem p = problem_of("wall-composite");
    struct response_lattice l;
    struct response r;
    for (int m = 0; m < 2; m++) p.material[m].k[0] = p.material[m].rho_c = m ? 0.001 : 1;
    p.t_end = 0.1;
    assert_int_equal(response_lattice_create(&p, &l), 0);
    assert_int_equal(response_take(&p, &l, (struct fault){FAULT_MEAN, 0}, 0, &r), 0);
    for (size_t i = 0; i < r.T.n; i++) assert_order(fabs(r.T.T[i]), <, 2);
    response_free(&r);
    response_lattice_free(&l);
}

static void a_response_is_per_unit_of_the_size(void **state) {
    (void)state;
    struct problem p = body(1);
    struct response_lattice l;
    struct field f;
    double base[N], longer[N], out[N];
    static const double sizes[] = {0, 0.3};
    assert_int_equal(response_lattice_create(&p, &l), 0);
    points(1, &f);
    response_base(&p, &l, &f, base, longer);
    for (int k = 0; k < 2; k++) { /* all temperatures: linear */
        struct response r;
        assert_int_equal(response_take(&p, &l, (struct fault){FAULT_AMPLITUDE, 0}, sizes[k], &r), 0);
        assert_near(r.size, k ? 0.3 : 0.01, 1e-15);
        response_at(&r, &l, &f, base, out);
        for (int i = 0; i < N; i++) assert_near(out[i], base[i], 1e-9);
        response_free(&r);
    }
    struct response r;
    double s = 0.01 * p.t_end;
    assert_int_equal(response_take(&p, &l, (struct fault){FAULT_CLOCK, 0}, 0, &r), 0);
    assert_near(r.size, s, 1e-15);
    response_at(&r, &l, &f, base, out);
    double slope = 3 * (fall(1, l.dx, 0.05, p.t_end + s) - fall(1, l.dx, 0.05, p.t_end)) / s;
    for (int i = 0; i < N; i++) assert_near(out[i], slope * mode_at(&f, i), 1e-4);
    response_free(&r);
    field_free(&f);
    response_lattice_free(&l);
}

/* Steps of rkl2 with F = 1.75 add (F dx^2 q^2)^2/14 of the decay, Euler's at F = 0.05 ten times as much; `base` has
 * the latter. */
static void a_response_in_the_plane_has_no_error_of_the_base(void **state) {
    (void)state;
    struct problem p = body(2);
    struct response_lattice l;
    struct field f;
    struct response r;
    double base[N], longer[N], out[N], pace = 0;
    assert_int_equal(response_lattice_create(&p, &l), 0);
    points(2, &f);
    response_base(&p, &l, &f, base, longer);
    assert_int_equal(response_take(&p, &l, (struct fault){FAULT_AMPLITUDE, 0}, 0.01, &r), 0);
    response_at(&r, &l, &f, base, out);
    for (int a = 0; a < 2; a++) pace += KAPPA[a] * pow(2 * sin(q_of(a) * l.dx / 2) / l.dx, 2);
    double T = 3 * exp(-pace * p.t_end), step = 1.75 * l.dx * l.dx / KAPPA[0];
    double most = pow(pace * step, 2) / 14 * pace * p.t_end * T;
    for (int i = 0; i < N; i++) assert_near(out[i], T * mode_at(&f, i), most + 3e-6);
    assert_order(fabs(base[0] - out[0]), >, 2 * most);
    response_free(&r);
    field_free(&f);
    response_lattice_free(&l);
}

/* A code whose answer is 1 % too large: its errors at dx, and the truncation error of differences there. */
static void errors_are_seen_at_the_spacing_of_the_rung(void **state) {
    (void)state;
    static const double means[] = {NAN, -2};
    struct problem p = body(1);
    struct response_lattice l;
    struct field f;
    double exact[N], base[N], dx = 0.05;
    assert_int_equal(response_lattice_create(&p, &l), 0);
    points(1, &f);
    double T = 3 * exp(-rate(1) * p.t_end), lattice = 3 * fall(1, l.dx, 0.05, p.t_end);
    double late = 3 * fall(1, l.dx, 0.15, p.t_end), q = q_of(0), curved = pow(2 * sin(q * l.dx / 2) / l.dx, 2);
    for (int i = 0; i < N; i++) exact[i] = T * mode_at(&f, i), f.T[i] = 1.01 * exact[i];
    for (int k = 0; k < 2; k++) {
        struct fit_errors s = fit_errors(&p, &l, &(struct diagnosis_rung){&f, exact, dx, 0, means[k]}, base);
        int left = 0;
        assert_int_equal(s.is_mean, 1);
        for (int i = 0; i < N; i++) {
            double c = mode_at(&f, i), mean = -curved * lattice * c * dx * dx / 24;
            assert_near(s.g[i], pow(dx / l.dx, 2) * (lattice - T) * c, 3e-5);
            assert_near(s.h[i], pow(dx / l.dx, 2) * (late - lattice) / 0.1 * c, 3e-5);
            assert_near(s.m[i], k ? 0 : mean, 1e-6);
            if (!isnan(s.e[i])) assert_near(s.e[i], 0.01 * T * c - (k ? -2 * mean : 0), 3e-6);
            for (int j = 0; j < N && isnan(s.e[i]); j++) /* at the largest difference: here the maximum of T */
                if (!isnan(s.e[j])) assert_order(fabs(s.g[i]), >, fabs(s.g[j]));
            left += isnan(s.e[i]);
        }
        assert_int_equal(left, N / 20);
        fit_errors_free(&s);
    }
    field_free(&f);
    response_lattice_free(&l);
}

/* The smallest number of 64 to 128 cells with faces on most jumps, and on an interface. */
static void faces_lie_on_jumps_and_interfaces(void **state) {
    (void)state;
    static const struct {
        const char *scene, *param[2];
        double value[2];
        int cells;
    } rows[] = {
        {"rod-step", {"a"}, {0.5}, 64},                    /* 3/8 n and 5/8 n of 4 m */
        {"rod-step", {"a"}, {8.0 / 15}, 90},               /* 11/30 n */
        {"wall-composite", {"x_c"}, {0.4}, 65},            /* 2/5 n */
        {"rod-contact", {"x_c", "t_end"}, {0.3, 0.5}, 80}, /* 13/20 n */
        {"square-step", {"a", "b"}, {0.6, 0.75}, 80},      /* 7/20 n and 5/16 n */
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct scene *s = scene_find(rows[i].scene);
        struct problem p;
        struct failure why;
        struct response_lattice l;
        scene_defaults(s, &p);
        for (int k = 0; s->params[k].name; k++)
            for (int j = 0; j < 2 && rows[i].param[j]; j++)
                if (strcmp(s->params[k].name, rows[i].param[j]) == 0) p.param[k] = rows[i].value[j];
        if (s->setup(&p, &why)) fail_msg("%s", why.text);
        assert_int_equal(response_lattice_create(&p, &l), 0);
        if (l.n[0] != rows[i].cells) fail_msg("%s, row %zu: %d cells", rows[i].scene, i, l.n[0]);
        response_lattice_free(&l);
    }
}

/* Materials that meet across y change T unless they are equal. */
static void materials_that_meet_across_y_differ(void **state) {
    (void)state;
    struct problem p;
    struct failure why;
    struct field f;
    double dx = 0.1, change[2] = {0, 0};
    scene_defaults(scene_find("plane-contact"), &p);
    if (scene_find("plane-contact")->setup(&p, &why)) fail_msg("%s", why.text);
    const int n[] = {(int)lround((p.hi[0] - p.lo[0]) / dx), (int)lround((p.hi[1] - p.lo[1]) / dx), 1};
    field_alloc_lattice(&f, 2, n, NULL);
    for (int a = 0; a < 2; a++)
        for (int i = 0; i < n[a]; i++) f.x[a][i] = p.lo[a] + (i + 0.5) * dx;
    for (int equal = 0; equal < 2; equal++) {
        if (equal) p.material[1] = p.material[0];
        assert_int_equal(response_on_cells(&p, dx, (struct fault){FAULT_TURNED, 1}, &f, f.T), 0);
        for (size_t i = 0; i < f.n; i++) change[equal] = fmax(change[equal], fabs(f.T[i]));
    }
    assert_order(change[0], >, 0.1);
    assert_near(change[1], 0, 0);
    field_free(&f);
}

/* W m^-2 */
static const double HEATING = 0.022;

static double heated(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x, (void)t;
    return s == X_LO ? HEATING : 0;
}

static double cold(const struct problem *p, const double *x) {
    (void)p, (void)x;
    return -0.1;
}

/* One cell or two of 0.2 m, solid and 0.4 K below the melting point, take `heat`, J m^-3 of one cell. */
static struct field melted(int cells, double heat, struct fault fault, double size) {
    const struct problem p = {.dim = 1,
                              .hi = {0.2 * cells},
                              .t_end = heat * 0.2 / HEATING,
                              .materials = 1,
                              .material = {{{0.022}, 0.9}},
                              .side = {NEUMANN, NEUMANN},
                              .k_law = K_PHASES,
                              .k_ref = 0.3,
                              .phase_k = {0.022, 0.012},
                              .phase_rho_c = {0.9, 1.4},
                              .latent = 1.5,
                              .initial = cold,
                              .wall = heated};
    struct faulty with;
    struct field f;
    assert_true(faulty_make(&p, fault, size, &with));
    melting_solve(&with, 0.2, &f);
    return f;
}

/* One cell takes what enters: H is heat - 0.36 J m^-3 from the solid at the melting point, and T follows from H. */
static void a_cell_that_melts_has_the_temperature_of_its_heat(void **state) {
    (void)state;
    static const struct {
        struct fault fault;
        double size, heat, T;
    } row[] = {
        {{FAULT_FRONT, AT_FRONT_LOCKED}, 1, 0.96, 0.3}, /* with no other cell: as without a fault */
        {{FAULT_FRONT, AT_FRONT_LOCKED}, 1, 2.46, 0.3 + 0.6 / 1.4},
        {{FAULT_FRONT, AT_FRONT_LOST}, 1, 0.96, 0.3 + 0.6 / 1.4},
        {{FAULT_FRONT, AT_FRONT_KEPT}, 1, 2.46, 0.3},
        {{FAULT_FRONT, AT_FRONT_LOOSE}, 1, 0.96, 0.3 + 0.6 / 0.9},
        {{FAULT_LATENT, 0}, -0.8, 0.96, 0.3 + 0.3 / 1.4},
        {{FAULT_RANGE, 0}, 0.2, 0.96, 0.3 + 0.2 * 0.6 / (1.5 + 1.4 * 0.2)},
        {{FAULT_RANGE, 1}, 0.2, 0.96, 0.2 + 0.2 * (0.6 + 0.09) / (1.5 + 0.09 + 0.14)},
        {{FAULT_RANGE, 2}, 0.2, 0.96, 0.1 + 0.2 * (0.6 + 0.18) / (1.5 + 0.18)},
        {{FAULT_MELTING_POINT, 0}, 0.1, 0.9, 0.4},                                 /* H is 0.45 */
        {{FAULT_PHASES, PHASES_RHO_C + PHASES_SWAPPED}, 1, 2.66, 0.3 + 0.6 / 0.9}, /* H is heat - 0.56 */
        {{FAULT_PHASE_PART, 3}, 0.25, 2.46, 0.3 + 0.6 / 1.75},
        {{FAULT_PHASE_PART, 2}, -0.5, 0.09, 0.3 - 0.09 / 0.45}, /* H is -0.09 */
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct field f = melted(1, row[i].heat, row[i].fault, row[i].size);
        print_message("%zu: %g K\n", i, f.T[0]);
        assert_near(f.T[0], row[i].T, 1e-12);
        field_free(&f);
    }
}

/* Two cells warm up q dx/(2 k) = 0.1 K apart, by 0.03 K a step of F = 0.3. The first is at the melting point after
 * 6.5 s; at 17 s the other is at it too, to 0.1 K 0.7^20 = 8e-5 K, unless no heat passes the first. */
static void a_cell_at_the_melting_point_passes_heat_unless_locked(void **state) {
    (void)state;
    struct field held = melted(2, 1.87, (struct fault){FAULT_LATENT, 0}, 0);
    struct field locked = melted(2, 1.87, (struct fault){FAULT_FRONT, AT_FRONT_LOCKED}, 1);
    print_message("%g and %g K, %g and %g K\n", held.T[0], held.T[1], locked.T[0], locked.T[1]);
    assert_near(held.T[0], 0.3, 0);
    assert_near(held.T[1], 0.3, 1e-3);
    assert_near(locked.T[0], 0.3, 0);
    assert_near(locked.T[1], 0.2 + 0.015, 0.016);
    field_free(&held);
    field_free(&locked);
}

/* Faces left out in the cell of a corner change T there most, and at the opposite corner least. */
static void faces_at_corners_are_left_out(void **state) {
    (void)state;
    struct problem p;
    struct failure why;
    struct field f;
    double dx = 0.005;
    scene_defaults(scene_find("plate"), &p);
    if (scene_find("plate")->setup(&p, &why)) fail_msg("%s", why.text);
    p.t_end /= 10;
    const int n[] = {(int)lround((p.hi[0] - p.lo[0]) / dx), (int)lround((p.hi[1] - p.lo[1]) / dx), 1};
    field_alloc_lattice(&f, 2, n, NULL);
    for (int a = 0; a < 2; a++)
        for (int i = 0; i < n[a]; i++) f.x[a][i] = p.lo[a] + (i + 0.5) * dx;
    for (int corner = 0; corner < BESIDE_ALL; corner++) {
        const int x = corner % 2 * (n[0] - 1), y = corner / 2 * (n[1] - 1);
        const double *there = &f.T[x + n[0] * y], *opposite = &f.T[n[0] - 1 - x + n[0] * (n[1] - 1 - y)];
        assert_int_equal(response_on_cells(&p, dx, (struct fault){FAULT_BESIDE, corner}, &f, f.T), 0);
        for (size_t i = 0; i < f.n; i++) assert_order(fabs(f.T[i]), <=, fabs(*there));
        assert_order(fabs(*opposite), <, 1e-3 * fabs(*there));
    }
    field_free(&f);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(response_lattice_decays_one_mode),
        cmocka_unit_test(response_extrapolates_linearly_to_the_wall),
        cmocka_unit_test(a_mean_of_conductivities_a_thousand_apart_has_a_response),
        cmocka_unit_test(a_response_is_per_unit_of_the_size),
        cmocka_unit_test(a_response_in_the_plane_has_no_error_of_the_base),
        cmocka_unit_test(faces_lie_on_jumps_and_interfaces),
        cmocka_unit_test(errors_are_seen_at_the_spacing_of_the_rung),
        cmocka_unit_test(materials_that_meet_across_y_differ),
        cmocka_unit_test(a_cell_that_melts_has_the_temperature_of_its_heat),
        cmocka_unit_test(a_cell_at_the_melting_point_passes_heat_unless_locked),
        cmocka_unit_test(faces_at_corners_are_left_out),
    };
    return cmocka_run_group_tests_name("response", tests, NULL, NULL);
}
