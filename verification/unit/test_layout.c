/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places of particles and ghosts, and the ghosts' values on fields that the walls' images continue exactly. */

#include "solver/particles/particles.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

extern const struct method method_brookshaw, method_kernel_second, method_so_ssph;

/* ---- lattices ---- */

/* A steady cubic: ghosts continue it exactly. */
static struct problem continued_problem(void) {
    struct problem p = odd_rectangle();
    p.wall = steady_wall, p.source = steady_source, p.initial = steady_cubic;
    return p;
}

static struct options jittered(double amplitude) {
    return (struct options){.dx = 0.05, .h = 1.23, .layout = LAYOUT_JITTER, .jitter = amplitude, .seed = 11};
}

static void make(const struct problem *p, const struct options *o, double reach, struct lattice *l, struct cloud *c) {
    struct failure why = {0};
    assert_int_equal(layout_lattice(p, o, l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(p, o, l, reach, c, &why), STATUS_OK);
}

/* Walls within `reach` of x along one axis. */
static int walls_near(const struct problem *p, int axis, double x, double reach) {
    return (x - p->lo[axis] < reach) + (p->hi[axis] - x < reach);
}

static int by_place(const void *a, const void *b) {
    const double *p = a, *q = b;
    return p[0] != q[0] ? (p[0] > q[0] ? 1 : -1) : (p[1] > q[1]) - (p[1] < q[1]);
}

/* Particles of the cloud, sorted; the caller frees them. */
static double (*sorted(const struct cloud *c))[2] {
    double(*place)[2] = xcalloc(c->n, sizeof *place);
    for (size_t i = 0; i < c->n; i++) place[i][0] = c->x[i], place[i][1] = c->y[i];
    qsort(place, c->n, sizeof *place, by_place);
    return place;
}

/* Inside plane walls, and cut by them: the reach of an operator changes the ghosts alone. */
static void one_seed_gives_one_cloud_to_all_operators(void **state) {
    (void)state;
    static const double reach[] = {0.05, 0.11, 0.176, 0.25};
    for (int cut = 0; cut < 2; cut++) {
        struct problem p = continued_problem();
        struct options o = jittered(0.37);
        struct lattice l;
        struct cloud c[4];
        double(*place[4])[2];
        o.walls = cut ? WALLS_FIT : WALLS_MIRROR, o.shift = cut ? 0.3 : 0;
        for (int i = 0; i < 4; i++) {
            make(&p, &o, reach[i], &l, &c[i]);
            place[i] = sorted(&c[i]);
            assert_int_equal(c[i].n, c[0].n);
            assert_memory_equal(place[i], place[0], c[0].n * sizeof **place);
        }
        for (int i = 0; i < 4; i++) {
            free(place[i]);
            layout_cloud_free(&c[i]);
        }
    }
}

static void ghosts_continue_the_field_beyond_walls(void **state) {
    (void)state;
    for (double amplitude = 0; amplitude < 0.5; amplitude += 0.37) {
        struct problem p = continued_problem();
        struct options o = jittered(amplitude);
        struct lattice l;
        struct cloud c;
        const double reach = 4 * 1.23 * 0.05;
        make(&p, &o, reach, &l, &c);
        size_t expected = c.n;
        for (size_t i = 0; i < c.n; i++)
            expected += (size_t)((1 + walls_near(&p, 0, c.x[i], reach)) * (1 + walls_near(&p, 1, c.y[i], reach)) - 1);
        assert_int_equal(c.total, expected);
        for (size_t k = 0; k < c.total; k++) {
            size_t i = c.source[k];
            assert_int_equal(k<c.n, c.x[k]> p.lo[0] && c.x[k] < p.hi[0] && c.y[k] > p.lo[1] && c.y[k] < p.hi[1]);
            double source = p.initial(&p, (double[2]){c.x[i], c.y[i]}),
                   want = p.initial(&p, (double[2]){c.x[k], c.y[k]});
            assert_near(c.factor[k] * source + c.offset[k], want, 2e-14); /* some dozens of roundings of 1 K */
        }
        layout_cloud_free(&c);
    }
}

static double smooth(const struct problem *p, const double x[2]) {
    (void)p;
    return exp(0.8 * x[0]) * cos(1.1 * x[1] + 0.4);
}

static double smooth_source(const struct problem *p, const double x[2]) {
    return (1.21 * p->material[0].k[1] - 0.64 * p->material[0].k[0]) * smooth(p, x);
}

static double smooth_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    double flux = p->material[0].k[1] * 1.1 * exp(0.8 * x[0]) * sin(1.1 * x[1] + 0.4);
    return s == Y_LO ? flux : s == Y_HI ? -flux : smooth(p, x);
}

/* A ghost without its term of highest order is off by d^3/3 T_nnn at a wall of given flux and by d^2 T_nn at one of
 * given temperature; the term is only taken where that makes it better, so it is never off by more than twice these,
 * nor by more than d^2 of them where k is the same along both axes. */
static void ghosts_hold_for_any_two_conductivities(void **state) {
    (void)state;
    static const double ratio[] = {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-16, 1e-100, 1e-300};
    for (size_t k = 0; k < sizeof ratio / sizeof *ratio; k++)
        for (int side = X_LO; side <= Y_HI; side++)
            for (double d = 0.005; d < 0.2; d *= 2) {
                struct problem p = odd_rectangle();
                p.wall = smooth_wall, p.source = smooth_source, p.initial = smooth;
                p.material[0].k[side / 2] = 0.7 * ratio[k], p.material[0].k[1 - side / 2] = 0.7;
                int axis = side / 2, beyond[2] = {-1, -1};
                double ghost[2] = {0.41, 0.83}, source[2] = {0.41, 0.83}, foot[2] = {0.41, 0.83};
                foot[axis] = side % 2 ? p.hi[axis] : p.lo[axis];
                ghost[axis] = foot[axis] + (side % 2 ? d : -d), source[axis] = foot[axis] - (side % 2 ? d : -d);
                beyond[axis] = side;
                double T = (axis ? 1 : -1) * smooth(&p, source) +
                           layout_ghost_offset(&p, WALLS_MIRROR, NULL, beyond, ghost, source);
                double term = axis ? d * d * d / 3 * pow(1.1, 3) * exp(0.8 * 0.41) : d * d * 0.64 * smooth(&p, foot);
                assert_near(T, smooth(&p, ghost), (ratio[k] < 1 ? 2 : d * d) * term + 1e-14);
            }
}

static double insulated(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

static double even_source(const struct problem *p, const double x[2]) {
    return cos(3 * x[0]) * cos(3 * p->hi[0]) + sin(3 * x[0]) * sin(3 * p->hi[0]); /* cos(3 (x - hi)) */
}

/* T_nnn of an insulated wall is 0 if the source is even about it; a small k would magnify its rounding. */
static void round_off_of_a_source_adds_no_term(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    const int beyond[2] = {X_HI, -1};
    p.side[X_HI] = NEUMANN, p.wall = insulated, p.source = even_source, p.material[0].k[0] = 1e-12;
    for (double d = 0.01; d < 0.2; d *= 1.01) {
        const double ghost[2] = {p.hi[0] + d, 0.83}, source[2] = {p.hi[0] - d, 0.83};
        assert_near(layout_ghost_offset(&p, WALLS_MIRROR, NULL, beyond, ghost, source), 0, 0);
    }
}

/* Two sides of given temperature that disagree at their corner: T = -T_source + ... by either order of reflection. */
static void corner_ghosts_take_the_mean_of_both_sides(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    for (int s = 0; s < 4; s++) p.side[s] = DIRICHLET;
    /* walls at 0.8 K (right) and -0.23 K (top): 2 (0.8) - (2 (-0.23) - T) or 2 (-0.23) - (2 (0.8) - T) */
    const int side[2] = {X_HI, Y_HI};
    const double source[2] = {1.11, 1.37}, ghost[2] = {1.19, 1.43};
    assert_near(layout_ghost_offset(&p, WALLS_MIRROR, NULL, side, ghost, source), 0, 1e-15);
    assert_near(layout_ghost_offset(&p, WALLS_FIXED, NULL, side, ghost, source), (0.8 - 0.23) / 2, 1e-15);
}

static void fixed_ghosts_hold_the_wall(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = jittered(0.21);
    struct lattice l;
    struct cloud c;
    o.walls = WALLS_FIXED;
    make(&p, &o, 0.13, &l, &c);
    for (size_t k = c.n; k < c.total; k++) {
        if (c.y[k] < p.lo[1] || c.y[k] > p.hi[1]) continue;
        assert_near(c.factor[k], 0, 0);
        assert_near(c.offset[k], c.x[k] < p.lo[0] ? 0.3 : 0.8, 0);
    }
    layout_cloud_free(&c);
}

static void spacings_that_do_not_divide_are_refused(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.071};
    struct lattice l;
    struct failure why;
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_INPUT);
    assert_has(why.text, "nearest: 0.06 and 0.075");
    o.dx = 0.0745; /* 20.1 of them fit, and 20 cells do divide: only 0.075 is of 20 */
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_INPUT);
    assert_has(why.text, "nearest: 0.06 and 0.075");
    o.dx = 1e-12;
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_INPUT);
    assert_has(why.text, "--dx 1e-12: 1.5e+12 particles along x, must be below 1e+08");
}

/* ---- clouds ---- */

static struct options options_of(enum layout_name layout) {
    return (struct options){.dx = 0.05, .h = 1.23, .seed = 7, .layout = layout, .jitter = 0.5, .sweeps = 2000};
}

static void make_clouds(const struct problem *p, const struct options *o, struct cloud *c) {
    struct lattice l;
    struct failure why = {0};
    assert_int_equal(layout_lattice(p, o, &l, &why), STATUS_OK);
    if (layout_cloud(p, o, &l, 2 * o->h * l.dx[0], c, &why)) print_error("%s\n", why.text);
    assert_int_equal(why.status, STATUS_OK);
}

static double distance(const struct cloud *c, size_t i, size_t j) {
    return hypot(c->x[i] - c->x[j], c->y[i] - c->y[j]);
}

/* Six neighbours at one distance, except for stretching (28 rows of 0.0429 instead of 0.0433 m fit into 1.2 m), away
 * from walls. */
static void hexagonal_cloud_has_six_neighbours(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_HEXAGONAL);
    struct cloud c;
    int seen = 0;
    make_clouds(&p, &o, &c);
    assert_near(c.volume * (double)c.n, 1.5 * 1.2, 1e-12);
    for (size_t i = 0; i < c.n; i++) {
        int near = 0;
        if (fabs(c.x[i] - 0.4) > 0.5 || fabs(c.y[i] - 0.8) > 0.4) continue;
        for (size_t j = 0; j < c.total; j++) {
            if (j == i || distance(&c, i, j) > 1.3 * 0.05) continue;
            assert_near(distance(&c, i, j) / 0.05, 1, 0.01);
            near++;
        }
        assert_int_equal(near, 6);
        seen++;
    }
    assert_order(seen, >, 100);
    layout_cloud_free(&c);
}

static double nearest(const struct cloud *c) {
    double least = HUGE_VAL;
    for (size_t i = 0; i < c->n; i++)
        for (size_t j = 0; j < c->total; j++)
            if (j != i) least = fmin(least, distance(c, i, j));
    return least;
}

static void relaxed_clouds_are_settled(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_RELAXED), start = options_of(LAYOUT_JITTER);
    struct cloud c, d, raw;
    make_clouds(&p, &o, &c);
    make_clouds(&p, &start, &raw);
    assert_order(nearest(&c), >, 0.75 * 0.05); /* grains of hexagons, 1.07 dx apart, and their borders */
    assert_order(nearest(&raw), <, 0.4 * 0.05);
    for (size_t i = 0; i < c.n; i++) {
        assert_order(c.x[i], >, p.lo[0]);
        assert_order(c.x[i], <, p.hi[0]);
        assert_order(c.y[i], >, p.lo[1]);
        assert_order(c.y[i], <, p.hi[1]);
    }
    o.threads = 3;
    make_clouds(&p, &o, &d);
    assert_memory_equal(c.x, d.x, c.total * sizeof *c.x);
    assert_memory_equal(c.y, d.y, c.total * sizeof *c.y);
    layout_cloud_free(&d);
    o.seed = 8;
    make_clouds(&p, &o, &d);
    assert_true(memcmp(c.x, d.x, c.n * sizeof *c.x) != 0);
    layout_cloud_free(&d);
    layout_cloud_free(&c);
    layout_cloud_free(&raw);
}

static void unsettled_clouds_report_the_last_displacement(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_RELAXED);
    struct field f;
    struct failure why;
    o.sweeps = 3;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &f, &why), STATUS_NUMERICAL);
    assert_has(why.text, "not settled after 3 sweeps");
    assert_has(why.text, "use more --sweeps");
}

/* Particles taken from an earlier answer are those that would be settled again: the same temperatures, bit for bit;
 * the answer's own dt has no part in it. */
static void relaxed_particles_are_reused(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = options_of(LAYOUT_RELAXED);
    struct field before, again, taken;
    struct failure why;
    o.stepper = STEPPER_RK2;
    o.fourier = 0.05;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &before, &why), STATUS_OK);
    o.fourier = 0.04;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &again, &why), STATUS_OK);
    o.placed = &before;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &taken, &why), STATUS_OK);
    for (int a = 0; a < 2; a++) assert_memory_equal(taken.x[a], again.x[a], taken.n * sizeof *taken.T);
    assert_memory_equal(taken.T, again.T, taken.n * sizeof *taken.T);
    assert_true(taken.T[17] != before.T[17]);
    field_free(&before);
    field_free(&again);
    field_free(&taken);
}

/* Runs that share rows have the bits of runs with rows of their own, and so has the rate of growing modes. */
static void rows_are_assembled_once(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = jittered(0.37), alone;
    struct assembled kept = {0};
    struct field first, shared, own;
    struct failure why;
    double rate[2];
    o.stepper = STEPPER_RK2, o.fourier = 0.05, o.assembled = &kept;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &first, &why), STATUS_OK);
    const double *value = kept.rows.value;
    assert_non_null(value);
    o.fourier = 0.04, alone = o, alone.assembled = NULL;
    assert_int_equal(method_solve(&method_so_ssph, &p, &o, &shared, &why), STATUS_OK);
    assert_ptr_equal(kept.rows.value, value);
    assert_int_equal(method_solve(&method_so_ssph, &p, &alone, &own, &why), STATUS_OK);
    for (int a = 0; a < 2; a++) assert_memory_equal(shared.x[a], own.x[a], own.n * sizeof *own.T);
    assert_memory_equal(shared.T, own.T, own.n * sizeof *own.T);
    assert_true(own.T[17] != first.T[17]);
    assert_int_equal(particles_growth(&method_so_ssph, &p, &o, &rate[0], &why), STATUS_OK);
    assert_int_equal(particles_growth(&method_so_ssph, &p, &alone, &rate[1], &why), STATUS_OK);
    assert_near(rate[0], rate[1], 0);
    field_free(&first);
    field_free(&shared);
    field_free(&own);
    particles_free_assembled(&kept);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_assembled_once),
        cmocka_unit_test(one_seed_gives_one_cloud_to_all_operators),
        cmocka_unit_test(ghosts_continue_the_field_beyond_walls),
        cmocka_unit_test(ghosts_hold_for_any_two_conductivities),
        cmocka_unit_test(round_off_of_a_source_adds_no_term),
        cmocka_unit_test(corner_ghosts_take_the_mean_of_both_sides),
        cmocka_unit_test(fixed_ghosts_hold_the_wall),
        cmocka_unit_test(spacings_that_do_not_divide_are_refused),
        cmocka_unit_test(hexagonal_cloud_has_six_neighbours),
        cmocka_unit_test(relaxed_clouds_are_settled),
        cmocka_unit_test(relaxed_particles_are_reused),
        cmocka_unit_test(unsettled_clouds_report_the_last_displacement),
    };
    return cmocka_run_group_tests_name("layout", tests, NULL, NULL);
}
