/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Clouds of a box and lattices in a ball: images at faces, edges and corners, rows that keep quadratics
 * and heat, walls that cut the lattice, exchange of axes. */

#include "solver/space/assembly.h"
#include "solver/particles/particles.h"
#include "solver/particles/walls.h"
#include "solver/shape.h"
#include "solver/time/growth.h"

#include "verification/unit/near.h"

#include <stdlib.h>

static const double B = 1.9; /* W m^-2 K^-1 */

/* T = c + b . x + x . Q x, K, on a body of one material. */
struct quadratic {
    double c, b[3], Q[3][3];
};
static const struct quadratic curved = {1.1,
                                        {0.7, -0.4, 0.3},
                                        {{0.35, -0.55, 0.2}, {0.1, 0.45, -0.3}, {0.15, 0.25, -0.6}}},
                              linear = {1.1, {0.7, -0.4, 0.3}, {{0}}}, flat = {1.1, {0}, {{0}}};

static double value(const struct quadratic *f, const double *x) {
    double sum = f->c;
    for (int a = 0; a < 3; a++) {
        sum += f->b[a] * x[a];
        for (int b = 0; b < 3; b++) sum += f->Q[a][b] * x[a] * x[b];
    }
    return sum;
}

static double initial(const struct problem *p, const double *x) {
    return value(p->data, x);
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    const struct quadratic *f = p->data;
    struct foot foot = shape_foot(p, (int)s, x);
    double T = value(f, foot.x), q = 0, k = p->material[0].k[walls_axis(foot.normal)];
    (void)t;
    for (int a = 0; a < 3; a++) {
        double slope = f->b[a];
        for (int b = 0; b < 3; b++) slope += (f->Q[a][b] + f->Q[b][a]) * foot.x[b];
        q += k * foot.normal[a] * slope;
    }
    return p->side[s] == DIRICHLET ? T : p->side[s] == NEUMANN ? q : T + q / B;
}

/* The source that keeps the field steady. */
static double source(const struct problem *p, const double *x) {
    const struct quadratic *f = p->data;
    double sum = 0;
    (void)x;
    for (int a = 0; a < 3; a++) sum -= 2 * p->material[0].k[a] * f->Q[a][a];
    return sum;
}

/* A box with the walls of x, y and z of the kinds given, or a ball with the first. */
static struct problem body(int ball, const enum side_kind kind[3], const struct quadratic *f) {
    struct problem p = {.dim = 3,
                        .lo = {-0.3, 0.1, 0},
                        .hi = {0.5, 0.7, 1},
                        .t_end = 0.01,
                        .materials = 1,
                        .material = {{{0.7, 0.4, 0.9}, 1.3}}};
    if (ball) shape_make_ball(&p, 0.5), p.material[0] = (struct material){{0.7, 0.7, 0.7}, 1.3};
    for (int s = 0; s < SIDES; s++) p.side[s] = kind[ball ? 0 : s / 2], p.robin[s] = p.side[s] == ROBIN ? B : 0;
    p.initial = initial, p.wall = wall, p.source = source, p.data = f;
    return p;
}

static const enum side_kind mixed[3] = {DIRICHLET, NEUMANN, DIRICHLET}, other[3] = {NEUMANN, DIRICHLET, NEUMANN},
                            insulated[3] = {NEUMANN, NEUMANN, NEUMANN};

static struct options jittered(double amplitude) {
    return (struct options){.dx = 0.1, .h = 1.1, .layout = LAYOUT_JITTER, .jitter = amplitude, .seed = 4};
}

/* Clouds with the values of their dummies, and the rows of a method for which they are valid. */
static void make(const struct problem *p, struct options *o, const char *method, struct cloud *c,
                 struct heat_operator *a) {
    struct lattice l;
    struct failure why = {0};
    struct options given = *o;
    int rows;
    const struct scheme *s = method_find(method)->scheme;
    if (particles_prepare(p, &given, s, o, &l, &rows, &why) || particles_cloud(p, o, s, &l, c, &why) ||
        (a && assembly_operator(a, p, o, s, c, l.dx[0], &why)))
        fail_msg("%s: %s", method, why.text);
}

static double at(const struct problem *p, const struct cloud *c, size_t i) {
    double x[DIM_MAX];
    layout_cloud_place(c, i, x);
    return p->initial(p, x);
}

/* ---- images ---- */

static void images_continue_quadratics_at_faces_edges_and_corners(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct problem p = body(0, k ? other : mixed, &curved);
        struct options o = jittered(0.31);
        struct cloud c;
        make(&p, &o, "so_ssph", &c, NULL);
        size_t expected = c.n;
        for (size_t i = 0; i < c.n; i++) {
            size_t images = 1;
            const double x[3] = {c.x[i], c.y[i], c.z[i]};
            for (int a = 0; a < 3; a++) images *= (size_t)(1 + (x[a] - p.lo[a] < 0.22) + (p.hi[a] - x[a] < 0.22));
            expected += images - 1;
        }
        assert_int_equal(c.n, 8 * 6 * 10);
        assert_int_equal(c.total, expected);
        for (size_t j = 0; j < c.total; j++)
            assert_near(c.factor[j] * at(&p, &c, c.source[j]) + c.offset[j], at(&p, &c, j), 2e-14);
        layout_cloud_free(&c);
    }
}

/* At a corner of different wall temperatures a ghost takes the mean over all six orders of reflection:
 * T = -T_source + 2 (+-a +-b +-c), and each value is first, second and last in two orders. */
static double uneven(const struct problem *p, enum side s, const double *x, double t) {
    static const double held[SIDES] = {0.3, 0.8, 0.11, -0.23, 0.57, 1.3};
    (void)p, (void)x, (void)t;
    return held[s];
}

static void corner_ghosts_take_the_mean_of_all_orders(void **state) {
    (void)state;
    struct problem p = body(0, mixed, &flat);
    const int side[3] = {X_HI, Y_HI, Z_LO};
    for (int s = 0; s < SIDES; s++) p.side[s] = DIRICHLET;
    p.wall = uneven, p.source = NULL;
    const double from[3] = {0.47, 0.66, 0.02}, ghost[3] = {0.53, 0.74, -0.02};
    /* first and last reflection have one sign, the second the other: 2 (1 - 1 + 1)/3 of each */
    assert_near(layout_ghost_offset(&p, WALLS_MIRROR, NULL, side, ghost, from), 2.0 / 3 * (0.8 - 0.23 + 0.57), 1e-15);
}

static int by_place(const void *a, const void *b) {
    const double *p = a, *q = b;
    for (int k = 0; k < 3; k++)
        if (p[k] != q[k]) return p[k] > q[k] ? 1 : -1;
    return 0;
}

static double *sorted(const struct cloud *c) {
    double *x = xcalloc(3 * c->n, sizeof *x);
    for (size_t i = 0; i < c->n; i++) layout_cloud_place(c, i, x + 3 * i);
    qsort(x, c->n, 3 * sizeof *x, by_place);
    return x;
}

static void one_seed_gives_one_cloud_to_all_operators(void **state) {
    (void)state;
    static const char *const methods_of[] = {"so_ssph", "positive", "fo_ssph"};
    for (int ball = 0; ball < 2; ball++) {
        double *x[3];
        struct cloud c[3];
        for (int m = 0; m < 3; m++) {
            struct problem p = body(ball, insulated, &flat);
            struct options o = jittered(0.2);
            o.h = 0, o.walls = ball ? WALLS_FIT : WALLS_MIRROR;
            make(&p, &o, methods_of[m], &c[m], NULL);
            x[m] = sorted(&c[m]);
            assert_int_equal(c[m].n, c[0].n);
            assert_memory_equal(x[m], x[0], 3 * c[0].n * sizeof **x);
        }
        for (int m = 0; m < 3; m++) free(x[m]), layout_cloud_free(&c[m]);
    }
}

/* ---- rows ---- */

/* The largest |dT/dt| of the initial data, K s^-1. */
static double drift(const struct problem *p, const struct cloud *c, const struct heat_operator *a) {
    double most = 0;
    for (size_t i = 0; i < a->n; i++) {
        double sum = a->diagonal[i] * at(p, c, i) + (a->g ? a->g[i] : 0);
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++) sum += a->value[k] * at(p, c, a->column[k]);
        most = fmax(most, fabs(sum));
    }
    return most;
}

static void check_steady(const struct problem *p, struct options o, const char *method) {
    struct cloud c;
    struct heat_operator a;
    make(p, &o, method, &c, &a);
    double most = drift(p, &c, &a);
    if (!(most <= 1e-8)) fail_msg("%s, walls %d, kind %d: %g K/s", method, o.walls, p->side[0], most);
    layout_cloud_free(&c);
    operator_free(&a);
}

static void quadratics_are_steady_on_jittered_boxes(void **state) {
    (void)state;
    static const char *const exact[] = {"so_ssph", "fatehi_manzari", "positive", "contact_ssph"};
    for (int m = 0; m < 4; m++)
        for (int k = 0; k < 2; k++) {
            struct problem p = body(0, k ? other : mixed, &curved);
            struct options o = jittered(0.2);
            o.h = m == 2 ? 0 : 1.1;
            check_steady(&p, o, exact[m]);
        }
}

static double layered(const struct problem *p, const double *x) {
    const struct material *m = &p->material[layout_material(p, x[0])];
    return 0.9 + 0.31 * (x[0] - p->interface) / m->k[0];
}

static double layered_wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)t;
    return p->side[s] == DIRICHLET ? layered(p, shape_foot(p, (int)s, x).x) : 0;
}

static void flux_across_two_materials_is_steady(void **state) {
    (void)state;
    static const enum side_kind kind[3] = {DIRICHLET, NEUMANN, NEUMANN};
    for (int layout = 0; layout < 2; layout++)
        for (int m = 0; m < 2; m++) {
            struct problem p = body(0, kind, &flat);
            struct options o = jittered(0.2);
            p.materials = 2, p.interface = 0.1, p.material[1] = (struct material){{0.09, 0.8, 0.5}, 0.7};
            p.initial = layered, p.wall = layered_wall, p.source = NULL;
            if (layout == 0) o.layout = LAYOUT_LATTICE;
            if (m == 1)
                for (int k = 0; k < 2; k++) p.material[k].k[1] = p.material[k].k[2] = p.material[k].k[0];
            o.mean = MEAN_SERIES; /* Brookshaw's operator is exact for it on the lattice alone */
            if (m == 0 || layout == 0) check_steady(&p, o, m ? "brookshaw" : "contact_ssph");
        }
}

static void brookshaw_keeps_heat(void **state) {
    (void)state;
    struct problem p = body(0, insulated, &curved);
    struct options o = jittered(0.3);
    struct cloud c;
    struct heat_operator a;
    p.material[0] = (struct material){{0.7, 0.7, 0.7}, 1.3};
    make(&p, &o, "brookshaw", &c, &a);
    double *sum = xcalloc(a.n, sizeof *sum), most = 0;
    for (size_t i = 0; i < a.n; i++) {
        sum[i] += a.diagonal[i], most = fmax(most, -a.diagonal[i]);
        for (size_t k = a.row[i]; k < a.row[i + 1]; k++) {
            assert_order(a.value[k], >=, 0);
            sum[a.column[k]] += a.value[k];
        }
    }
    for (size_t i = 0; i < a.n; i++) assert_near(sum[i], 0, 1e-13 * most);
    free(sum);
    layout_cloud_free(&c);
    operator_free(&a);
}

/* ---- balls, and boxes cut anywhere ---- */

static void cells_of_any_lattice_fill_the_ball(void **state) {
    (void)state;
    struct problem p = body(1, mixed, &flat);
    const double d = 0.093, ball = 4.0 / 3 * 3.14159265358979323846 * 0.125;
    double sum = 0;
    for (int k = -8; k < 8; k++)
        for (int j = -8; j < 8; j++)
            for (int i = -8; i < 8; i++) {
                const double lo[3] = {(i + 0.21) * d, (j + 0.67) * d, (k + 0.4) * d};
                double part = shape_clipped(&p, lo, (double[3]){lo[0] + d, lo[1] + d, lo[2] + d}) / (d * d * d);
                assert_order(part, >=, 0);
                assert_order(part, <=, 1 + 1e-12);
                sum += part * d * d * d;
            }
    assert_near(sum, ball, 1e-14);
    assert_near(shape_volume(&p), ball, 1e-15);
}

/* A cell by discs: the midpoint rule of its slices, with kinks where a circle meets an edge. */
static void clipped_cell_is_the_integral_of_its_slices(void **state) {
    (void)state;
    enum { SLICES = 2000 };
    static const double lo[][3] = {{0.2, 0.15, 0.3}, {-0.4, 0.1, -0.3}, {-0.1, -0.2, 0.42}, {0.3, 0.3, 0.3}};
    struct problem p = body(1, mixed, &flat);
    for (int k = 0; k < 4; k++) {
        const double hi[3] = {lo[k][0] + 0.2, lo[k][1] + 0.17, lo[k][2] + 0.23};
        double sum = 0, dz = 0.23 / SLICES;
        for (int i = 0; i < SLICES; i++) {
            double z = lo[k][2] + (i + 0.5) * dz;
            struct problem disc = {.dim = 2};
            if (fabs(z) >= 0.5) continue;
            shape_round(&disc, 0, sqrt(0.25 - z * z));
            sum += shape_clipped(&disc, lo[k], hi) * dz;
        }
        assert_near(shape_clipped(&p, lo[k], hi), sum, 1e-8);
    }
}

/* The largest error of a dummy, K. */
static double off(const struct problem *p, enum walls walls, double jitter) {
    struct options o = {.dx = 0.1, .h = 1.1, .walls = walls, .seed = 3};
    struct cloud c;
    double most = 0;
    if (jitter > 0) o.layout = LAYOUT_JITTER, o.jitter = jitter;
    if (!p->shape) o.shift = 0.37;
    make(p, &o, "so_ssph", &c, NULL);
    assert_order(c.total, >, c.n);
    for (size_t j = c.n; j < c.total; j++) {
        double T = c.offset[j];
        for (size_t k = c.begin[j - c.n]; k < c.begin[j - c.n + 1]; k++) T += c.share[k] * at(p, &c, c.from[k]);
        most = fmax(most, fabs(T - at(p, &c, j)));
    }
    layout_cloud_free(&c);
    return most;
}

static const enum side_kind all_of[3][3] = {
    {DIRICHLET, DIRICHLET, DIRICHLET}, {NEUMANN, NEUMANN, NEUMANN}, {ROBIN, ROBIN, ROBIN}};

static void fits_continue_quadratics(void **state) {
    (void)state;
    for (int ball = 0; ball < 2; ball++)
        for (int kind = 0; kind < 3; kind++)
            for (int layout = 0; layout < 2; layout++) {
                struct problem p = body(ball, all_of[kind], &curved);
                assert_near(off(&p, WALLS_FIT, layout ? 0.2 : 0), 0, 1e-11);
            }
    struct problem p = body(0, mixed, &curved);
    assert_near(off(&p, WALLS_FIT, 0.2), 0, 1e-11);
}

static void published_treatments_keep_what_they_claim(void **state) {
    (void)state;
    for (int ball = 0; ball < 2; ball++)
        for (int kind = 0; kind < 3; kind++) {
            struct problem p = body(ball, all_of[kind], &flat);
            if (kind == 0) assert_near(off(&p, WALLS_FIXED, 0), 0, 1e-13);
            if (kind < 2) assert_near(off(&p, WALLS_AVERAGE, 0), 0, 1e-13);
            assert_near(off(&p, WALLS_IMAGE, 0), 0, 1e-12);
        }
    for (int kind = 0; kind < 2; kind++) {
        struct problem p = body(0, all_of[kind], &linear);
        assert_near(off(&p, WALLS_IMAGE, 0), 0, 1e-12);
    }
}

static void quadratics_are_steady_at_walls_anywhere(void **state) {
    (void)state;
    static const char *const exact[] = {"so_ssph", "fatehi_manzari", "positive", "so_ssph"};
    for (int m = 0; m < 4; m++)
        for (int ball = 0; ball < 2; ball++)
            for (int kind = 0; kind < 3; kind++) {
                struct problem p = body(ball, all_of[kind], &curved);
                struct options o = {.dx = 0.1, .seed = 5, .shift = ball ? 0 : 0.23};
                o.walls = m == 3 ? WALLS_ONE_SIDED : WALLS_FIT;
                check_steady(&p, o, exact[m]);
            }
}

static void quadratics_are_steady_between_images_of_a_shifted_lattice(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct problem p = body(0, k ? other : mixed, &curved);
        check_steady(&p, (struct options){.dx = 0.1, .shift = 0.23}, "so_ssph");
    }
}

/* The nearest stencil is degenerate on a lattice: rounding once made the programme cycle. */
static void every_particle_of_a_rotated_lattice_has_positive_weights(void **state) {
    (void)state;
    for (unsigned long seed = 0; seed < 3; seed++) {
        struct problem p = body(1, insulated, &curved);
        struct options o = {.dx = 0.0625, .seed = seed, .walls = WALLS_FIT};
        check_steady(&p, o, "positive");
    }
}

/* Without walls the stable step of so_ssph is 0.48 dx^2/kappa on the lattice; walls cost at most a fifth of it. */
static void no_mode_grows_in_a_ball(void **state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++)
        for (unsigned long seed = 1; seed < 5; seed++) {
            struct problem p = body(1, all_of[kind], &flat);
            struct options o = {.dx = 0.1, .h = 1.1, .seed = seed};
            struct cloud c;
            struct heat_operator a;
            if (seed % 2) o.layout = LAYOUT_JITTER, o.jitter = 0.2;
            o.walls = seed < 3 ? WALLS_FIT : WALLS_ONE_SIDED;
            make(&p, &o, "so_ssph", &c, &a);
            assert_near(growth_rate(&a, operator_bound(&a), 0.3), 0, 0);
            double most = 0, inner = 6 / 1.21 * 0.7 / 1.3 / 0.01; /* sigma of one_sided, the largest inner weight */
            for (size_t i = 0; i < a.n; i++) most = fmax(most, fabs(a.diagonal[i]));
            assert_order(most, <, 1.2 * inner);
            layout_cloud_free(&c);
            operator_free(&a);
        }
}

/* Temperatures that disagree at edges and corners, and move with the axes. */
static double uneven_wall(const struct problem *p, enum side s, const double *x, double t) {
    return wall(p, s, x, t) + 0.1 * p->hi[s / 2];
}

/* x, y, z -> y, z, x of a box with unequal sides, conductivities and walls: the same temperatures. */
static void exchange_of_axes_exchanges_the_field(void **state) {
    (void)state;
    static const enum walls walls[] = {WALLS_FIT, WALLS_ONE_SIDED, WALLS_FIT, WALLS_FIXED, WALLS_FIT};
    for (int k = 0; k < 5; k++) {
        const enum side_kind kind[3] = {DIRICHLET, k < 2 ? NEUMANN : DIRICHLET, k < 2 ? ROBIN : DIRICHLET};
        const enum side_kind turned[3] = {kind[1], kind[2], kind[0]};
        struct quadratic g = curved;
        struct problem p = body(0, kind, &curved), q = body(0, turned, &g);
        struct options o = {.dx = 0.1, .shift = 0.31, .walls = walls[k], .stepper = STEPPER_RK2, .dt = 0.001};
        struct field f, h;
        struct failure why;
        for (int a = 0; a < 3; a++) {
            int from = (a + 1) % 3;
            q.lo[a] = p.lo[from], q.hi[a] = p.hi[from], q.material[0].k[a] = p.material[0].k[from];
            g.b[a] = curved.b[from];
            for (int b = 0; b < 3; b++) g.Q[a][b] = curved.Q[from][(b + 1) % 3];
        }
        p.source = q.source = NULL; /* not steady */
        if (k >= 2) p.wall = q.wall = uneven_wall;
        const struct method *m = method_find(k >= 3 ? "fo_ssph" : "so_ssph"); /* rows of two sweeps, and of one */
        if (method_solve(m, &p, &o, &f, &why)) fail_msg("%s", why.text);
        if (method_solve(m, &q, &o, &h, &why)) fail_msg("%s", why.text);
        assert_int_equal(f.n, h.n);
        for (size_t i = 0; i < f.n; i++) {
            size_t j = 0;
            double x[DIM_MAX], y[DIM_MAX], apart = 1;
            field_place(&f, i, x);
            for (; j < h.n; j++) {
                field_place(&h, j, y);
                apart = fabs(y[0] - x[1]) + fabs(y[1] - x[2]) + fabs(y[2] - x[0]);
                if (apart <= 1e-9) break;
            }
            assert_order(j, <, h.n);
            assert_near(h.T[j], f.T[i], 1e-11);
        }
        field_free(&f);
        field_free(&h);
    }
}

static void layouts_of_the_plane_are_refused(void **state) {
    (void)state;
    static const enum layout_name plane[] = {LAYOUT_RELAXED, LAYOUT_HEXAGONAL};
    for (int k = 0; k < 2; k++) {
        struct problem p = body(0, mixed, &flat);
        struct options o = {.dx = 0.1, .layout = plane[k]};
        struct field f;
        struct failure why;
        assert_int_equal(method_solve(method_find("so_ssph"), &p, &o, &f, &why), STATUS_NOT_APPLICABLE);
        assert_has(why.text, "on a rod and in the plane only; use lattice or jitter");
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(images_continue_quadratics_at_faces_edges_and_corners),
        cmocka_unit_test(corner_ghosts_take_the_mean_of_all_orders),
        cmocka_unit_test(one_seed_gives_one_cloud_to_all_operators),
        cmocka_unit_test(quadratics_are_steady_on_jittered_boxes),
        cmocka_unit_test(flux_across_two_materials_is_steady),
        cmocka_unit_test(brookshaw_keeps_heat),
        cmocka_unit_test(cells_of_any_lattice_fill_the_ball),
        cmocka_unit_test(clipped_cell_is_the_integral_of_its_slices),
        cmocka_unit_test(fits_continue_quadratics),
        cmocka_unit_test(published_treatments_keep_what_they_claim),
        cmocka_unit_test(quadratics_are_steady_at_walls_anywhere),
        cmocka_unit_test(quadratics_are_steady_between_images_of_a_shifted_lattice),
        cmocka_unit_test(every_particle_of_a_rotated_lattice_has_positive_weights),
        cmocka_unit_test(no_mode_grows_in_a_ball),
        cmocka_unit_test(exchange_of_axes_exchanges_the_field),
        cmocka_unit_test(layouts_of_the_plane_are_refused),
    };
    return cmocka_run_group_tests_name("clouds in space", tests, NULL, NULL);
}
