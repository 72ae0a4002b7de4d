/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Faults as changes of a problem: where each can be made, and the data that it changes. */
#include "verification/fault/fault.h"

#include "verification/unit/diagnosed_problems.h"
#include "verification/unit/near.h"

#include <math.h>
#include <string.h>

static void impossible_sizes_are_refused(void **state) {
    (void)state;
    struct problem p = problem_of("rod-step");
    static const enum fault_kind bends[] = {FAULT_CONDUCTIVITY, FAULT_AXIS, FAULT_RHO_C, FAULT_COEFFICIENT};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(fault_can_be(&p, (struct fault){bends[i], 0}, -0.99), 1);
        assert_int_equal(fault_can_be(&p, (struct fault){bends[i], 0}, -1.21), 0);
        assert_int_equal(fault_can_be(&p, (struct fault){bends[i], 0}, 4.93), 1);
    }
    assert_int_equal(fault_can_be(&p, (struct fault){FAULT_WALL, 0}, -1), 1);    /* lost */
    assert_int_equal(fault_can_be(&p, (struct fault){FAULT_WALL, 0}, -2), 1);    /* wrong sign */
    assert_int_equal(fault_can_be(&p, (struct fault){FAULT_WALL, 0}, -5.71), 0); /* 571 % too small */
    assert_int_equal(fault_can_be(&p, (struct fault){FAULT_SOURCE, 0}, -1.89), 0);
    assert_int_equal(fault_can_be(&p, (struct fault){FAULT_CLOCK, 0}, -0.9 * p.t_end), 1);
    assert_int_equal(fault_can_be(&p, (struct fault){FAULT_CLOCK, 0}, -1.1 * p.t_end), 0);
    assert_int_equal(fault_can_be(&p, (struct fault){FAULT_AMPLITUDE, 0}, -1.2), 0);
    for (int k = 0; k < 2; k++)
        assert_int_equal(fault_can_be(&p, (struct fault){FAULT_EXTENT, 0}, (k ? 0.26 : -0.24) * (p.hi[0] - p.lo[0])),
                         !k);
}

/* A larger conductivity has the effect of longer steps only where nothing but conduction changes T. */
static void conductivity_and_pace_differ_by_sources_fluxes_and_air(void **state) {
    (void)state;
    static const char *const one[] = {"rod-gauss", "rod-cosine", "rod-contact", "square-step", "plate"},
                             *const two[] = {"rod-cooling", "plate-cooling", "rect-manufactured", CHANGING,
                                             "rod-driven"};
    for (int i = 0; i < 5; i++) {
        struct problem p = problem_of(one[i]), q = problem_of(two[i]);
        assert_true(fault_is_pace(&p));
        assert_false(fault_is_pace(&q));
    }
    struct problem p = problem_of("rect-manufactured");
    p.source = NULL; /* fluxes are left */
    assert_false(fault_is_pace(&p));
}

/* Probes along y have the extent of y; the walls across y, and no others, keep k dT/dn = b (value - T) in a
 * stretched body. */
static void probe_sizes_along_y_use_the_extent_of_y(void **state) {
    (void)state;
    struct problem p = problem_of("plate-cooling"), rod = problem_of("rod-step");
    struct faulty with;
    struct fault along_y = {.kind = FAULT_EXTENT, .at = 1};
    assert_near(fault_probe(&p, along_y), (p.hi[1] - p.lo[1]) / 200, 1e-15);
    assert_true(faulty_make(&p, along_y, 0.05, &with));
    double s = 1 + 2 * 0.05 / (p.hi[1] - p.lo[1]);
    for (int side = X_LO; side <= X_HI; side++) assert_near(with.problem.robin[side], p.robin[side], 0);
    for (int side = Y_LO; side <= Y_HI; side++) assert_near(with.problem.robin[side], p.robin[side] / s, 1e-12);
    struct problem cooled = p;
    cooled.robin[Y_LO] = 3;
    assert_true(faulty_make(&cooled, (struct fault){.kind = FAULT_EXTENT, .at = 0}, 0.05, &with));
    assert_near(with.problem.robin[Y_LO], 3, 0);
    struct fault all = {FAULT_COEFFICIENT, FAULT_ALL_SIDES};
    assert_true(faulty_make(&p, all, 0.1, &with));
    for (int side = 0; side < 4; side++) assert_near(with.problem.robin[side], 1.1 * p.robin[side], 1e-12);
    struct fault swap = {.kind = FAULT_SWAP}, isotropic = {.kind = FAULT_ISOTROPIC};
    assert_false(faulty_make(&rod, swap, 1, &with)); /* a rod has one conductivity, and so has the plate */
    assert_false(faulty_make(&p, swap, 1, &with));
    assert_false(faulty_make(&p, isotropic, 1, &with));
}

/* The plate's sides are of four temperatures: a transposed code has each beside the other axis, and one that loses a
 * corner loses 2 k T/dx^2 of the two sides that meet there. */
static void sides_and_corners_have_faults_of_their_own(void **state) {
    (void)state;
    struct problem p = problem_of("plate");
    const double dx = 0.01, side = p.hi[0], k = p.material[0].k[0], along[2] = {0.3 * side, 0.8 * side};
    struct faulty with;
    double T[4];
    for (int s = 0; s < 4; s++) T[s] = p.wall(&p, (enum side)s, along, 0);
    assert_true(faulty_make(&p, (struct fault){FAULT_TRANSPOSED, 0}, 1, &with));
    for (int s = 0; s < 4; s++)
        assert_near(with.problem.wall(&with.problem, (enum side)s, along, 0), T[s ^ 2], 1e-15 * fabs(T[s ^ 2]));
    for (int corner = 0; corner < 4; corner++) {
        int right = corner & 1, upper = corner >> 1;
        double x[2] = {right ? side - dx / 2 : dx / 2, upper ? side - dx / 2 : dx / 2};
        double lost = 2 * k * (T[X_LO + right] + T[Y_LO + upper]) / (dx * dx);
        for (int all = 0; all < 2; all++) {
            assert_true(faulty_make(&p, (struct fault){FAULT_CORNER, all ? 27 : corner}, dx, &with));
            assert_near(problem_source(&with.problem, x, 0), -lost, 1e-12 * lost);
        }
    }
}

/* A held side moves away from a cooled one that stays; a side of given flux keeps it and loses b T more. */
static void held_sides_move_and_sides_of_given_flux_leak(void **state) {
    (void)state;
    struct problem rod = problem_of("rod-cooling"), p = problem_of("rect-manufactured"),
                   step = problem_of("rod-step");
    struct faulty with;
    const double L = rod.hi[0] - rod.lo[0], on[2] = {0.3, p.lo[1]};
    assert_true(faulty_make(&rod, (struct fault){FAULT_HELD, 0}, 0.1 * L, &with));
    assert_near(with.centre[0] + with.stretch[0] * (rod.hi[0] - with.centre[0]), rod.hi[0], 1e-15);
    assert_near(with.centre[0] + with.stretch[0] * (rod.lo[0] - with.centre[0]), rod.lo[0] - 0.1 * L, 1e-12);
    assert_false(faulty_make(&step, (struct fault){FAULT_HELD, 0}, 0.1, &with));
    assert_true(faulty_make(&p, (struct fault){FAULT_LEAK, Y_LO}, 0.2, &with));
    double b = 0.2 * p.material[0].k[1] / (p.hi[1] - p.lo[1]), flux = p.wall(&p, Y_LO, on, 0);
    assert_near(with.problem.robin[Y_LO], b, 1e-12 * b);
    assert_near(b * with.problem.wall(&with.problem, Y_LO, on, 0), flux, 1e-12 * fabs(flux));
    assert_false(faulty_make(&p, (struct fault){FAULT_LEAK, X_LO}, 0.2, &with)); /* held */
}

/* Air that is lost is that of all Robin sides, and of no other. */
static void air_is_of_robin_sides(void **state) {
    (void)state;
    struct problem p = problem_of("rod-cooling"), cold = problem_of("plate-cooling"); /* air at 0 K */
    struct faulty with;
    const double lo = p.lo[0], hi = p.hi[0];
    assert_true(faulty_make(&p, (struct fault){FAULT_AIR, 0}, -1, &with));
    assert_near(with.problem.wall(&with.problem, X_HI, &hi, 0), 0, 0);
    assert_near(with.problem.wall(&with.problem, X_LO, &lo, 0), p.wall(&p, X_LO, &lo, 0), 0);
    assert_false(faulty_make(&cold, (struct fault){FAULT_AIR, 0}, -1, &with));
}

/* A rod has no y, a body of one material no second, an oblong cannot be transposed, and an absent part has no
 * fault. */
/* plate-cooling is cooled at x_hi and y_hi. */
static void half_a_cell_at_robin_walls_is_across_an_axis(void **state) {
    (void)state;
    const struct problem p = problem_of("plate-cooling");
    static const int places[] = {0, 1, FAULT_ALL_AXES};
    for (int i = 0; i < 3; i++) {
        struct faulty f;
        assert_true(faulty_make(&p, (struct fault){FAULT_NEAR_WALL, places[i]}, 0.0125, &f));
        for (int a = 0; a < 2; a++) {
            const double change = f.problem.robin[2 * a + 1] / p.robin[2 * a + 1];
            assert_near(change, i == 1 - a ? 1 : 1 / (1 - 0.0125 * p.robin[X_HI] / p.material[0].k[a]), 1e-15);
        }
    }
    assert_false(fault_applies(&p, (struct fault){FAULT_NEAR_WALL, 2}));
    assert_false(fault_applies(&p, (struct fault){FAULT_NEAR_WALL, FAULT_BOTH_AXES}));
}

static void faults_apply_to_existing_parts_only(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        struct fault fault;
        int can;
    } rows[] = {
        {"square-step", {FAULT_TRANSPOSED, 0}, 1},
        {"rect-manufactured", {FAULT_TRANSPOSED, 0}, 0},
        {"rect-manufactured", {FAULT_SWAP, 0}, 1},
        {"rect-manufactured", {FAULT_ISOTROPIC, 1}, 1},
        {"rod-step", {FAULT_ISOTROPIC, 0}, 0},
        {"rect-manufactured", {FAULT_SOURCE, 0}, 1},
        {"rect-manufactured", {FAULT_SOURCE_TIME, 0}, 0},
        {CHANGING, {FAULT_SOURCE_TIME, 0}, 1},
        {"square-step", {FAULT_SOURCE, 0}, 0},
        {"rod-cooling", {FAULT_WALL_TIME, 0}, 0},
        {"plate-driven", {FAULT_WALL_TIME, 0}, 1},
        {"rod-driven", {FAULT_WALL_FROZEN, 0}, 1},
        {"rod-contact", {FAULT_CAPACITY, 0}, 1},
        {"rod-contact", {FAULT_RHO_C, 1}, 1},
        {"rod-contact", {FAULT_RHO_C, 2}, 0},
        {"rod-contact", {FAULT_AXIS, 0}, 0},
        {"plate", {FAULT_AXIS, 1}, 1},
        {"plate", {FAULT_AXIS, 2}, 0},
        {"rod-contact", {FAULT_INTERFACE, 0}, 1},
        {"rod-contact", {FAULT_MEAN, 0}, 1},
        {"rod-step", {FAULT_INTERFACE, 0}, 0},
        {"rod-cooling", {FAULT_COEFFICIENT, X_HI}, 1},
        {"rod-cooling", {FAULT_COEFFICIENT, X_LO}, 0},
        {"rod-cooling", {FAULT_COEFFICIENT, FAULT_ALL_SIDES}, 0},
        {"plate-cooling", {FAULT_COEFFICIENT, FAULT_ALL_SIDES}, 1},
        {"rect-manufactured", {FAULT_WALL, Y_HI}, 1},
        {"rect-manufactured", {FAULT_WALL, FAULT_ALL_SIDES}, 1},
        {"plate", {FAULT_WALL, FAULT_ALL_SIDES}, 0},
        {"rod-cosine", {FAULT_WALL, X_LO}, 0},
        {"rod-contact", {FAULT_WALL, X_HI}, 0}, /* all at 0 K */
        {"rod-step", {FAULT_START_WIDTH, 0}, 1},
        {"rod-step", {FAULT_START_WIDTH, 1}, 0},
        {"rod-contact", {FAULT_START_WIDTH, 0}, 0}, /* one jump */
        {"square-step", {FAULT_SAMPLES, 1}, 1},
        {"rod-gauss", {FAULT_SAMPLES, 0}, 0},
        {"rod-gauss", {FAULT_START_SHIFT, 0}, 1},
        {"square-step", {FAULT_START_SHIFT, 1}, 1},
        {"rod-gauss", {FAULT_EXTENT, 1}, 0},
        {"rod-gauss", {FAULT_EXTENT, FAULT_BOTH_AXES}, 0},
        {"plate", {FAULT_EXTENT, FAULT_BOTH_AXES}, 1},
        {"plate", {FAULT_EXTENT, 2}, 0},
        {"box-manufactured", {FAULT_EXTENT, FAULT_BOTH_AXES}, 0},
        {"box-manufactured", {FAULT_EXTENT, FAULT_ALL_AXES}, 1},
        {"box-manufactured", {FAULT_AXIS, 2}, 1},
        {"box-manufactured", {FAULT_SWAP, 2}, 1},
        {"box-manufactured", {FAULT_ISOTROPIC, 5}, 1},
        {"cube-step", {FAULT_TRANSPOSED, 2}, 1},
        {"rect-manufactured", {FAULT_ISOTROPIC, 2}, 0},
        {"box-manufactured", {FAULT_CORNER, 3}, 0},
        {"box-manufactured", {FAULT_CORNER, 11}, 1},
        {"box-manufactured", {FAULT_CORNER, 12}, 1}, /* the edge between a flux and air */
        {"box-manufactured", {FAULT_CORNER, 26}, 1}, /* the edges along z */
        {"box-manufactured", {FAULT_CORNER, 27}, 0}, /* the corners of a plane */
        {"plate", {FAULT_CORNER, 27}, 1},
        {"plate", {FAULT_CORNER, 28}, 0},
        {"rect-manufactured", {FAULT_LOADS, 0}, 1},
        {"plate", {FAULT_LOADS, 0}, 0},
        {"plane-contact", {FAULT_TURNED, 0}, 0},
        {"plane-contact", {FAULT_TURNED, 1}, 1},
        {"rod-contact", {FAULT_TURNED, 1}, 0},
        {"box-manufactured", {FAULT_CORNER, 23}, 1},
        {"plate", {FAULT_CORNER, 2}, 1},
        {"square-step", {FAULT_CORNER, 0}, 0}, /* Dirichlet value 0 */
        {"plate", {FAULT_CLOCK, 1}, 0},
        {"wave", {FAULT_NOT_PERIODIC, 1}, 1},
        {"wave", {FAULT_CROSS, 0}, 0}, /* a diagonal tensor */
        {"plate", {FAULT_TWICE, 0}, 0},
        {"wave", {FAULT_INSULATED, 0}, 0},
        {"plate-cooling", {FAULT_AIR_SIGN, 0}, 1},
        {"rod-step", {FAULT_ALONG, 0}, 0},
        {"rect-manufactured", {FAULT_ALONG, FAULT_BOTH_AXES}, 1},
        {"plate", {FAULT_NOISE, 0}, 0}, /* no change of a problem */
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct problem p = problem_of(rows[i].scene);
        struct faulty with;
        if (faulty_make(&p, rows[i].fault, 0.01, &with) != rows[i].can)
            fail_msg("%s: fault %d of %d", rows[i].scene, rows[i].fault.kind, rows[i].fault.at);
    }
}

/* The influx across y is that of the higher body; Dirichlet values at x depend on the position along y. */
static void stretched_bodies_keep_walls_and_sources(void **state) {
    (void)state;
    struct problem p = problem_of("rect-manufactured");
    struct faulty with;
    const double size = 0.03, s = 1 + 2 * size / (p.hi[1] - p.lo[1]), middle = (p.lo[1] + p.hi[1]) / 2;
    assert_true(faulty_make(&p, (struct fault){FAULT_EXTENT, 1}, size, &with));
    for (int k = 0; k < 4; k++) {
        double x[2] = {p.hi[0] * (0.1 + 0.23 * k), p.hi[1] * (0.2 + 0.19 * k)};
        double right[2] = {x[0], middle + s * (x[1] - middle)};
        enum side side = (enum side)k;
        double held = p.wall(&p, side, right, 0);
        assert_near(with.problem.wall(&with.problem, side, x, 0), side < Y_LO ? held : held / s, 1e-14);
        assert_near(with.problem.initial(&with.problem, x), p.initial(&p, right), 1e-14);
        assert_near(problem_source(&with.problem, x, 0), problem_source(&p, right, 0), 1e-14);
    }
    assert_near(with.problem.material[0].k[0], p.material[0].k[0], 0);
    assert_near(with.problem.material[0].k[1], p.material[0].k[1] / (s * s), 1e-15);
}

/* The start of square-step, hot for |y| <= b = 0.75 m: each jump further out, or both further up. */
static void starts_move_along_y(void **state) {
    (void)state;
    struct problem p = problem_of("square-step");
    const enum fault_kind kinds[] = {FAULT_START_WIDTH, FAULT_START_SHIFT};
    const double b = p.jump[1][1], size = 0.05;
    assert_near(b, 0.75, 0);
    for (int k = 0; k < 2; k++) {
        struct faulty with;
        assert_true(faulty_make(&p, (struct fault){kinds[k], 1}, size, &with));
        const struct problem *q = &with.problem;
        double low = k ? -b + size : -b - size;
        assert_near(q->jump[1][0], low, 1e-15);
        assert_near(q->jump[1][1], b + size, 1e-15);
        for (int i = 0; i < 2; i++) assert_near(q->jump[0][i], p.jump[0][i], 0);
        double hot = p.initial(&p, (double[2]){0.1, 0.1});
        assert_near(q->initial(q, (double[2]){0.1, b + 0.9 * size}), hot, 0);
        assert_near(q->initial(q, (double[2]){0.1, b + 1.1 * size}), 0, 0);
        assert_near(q->initial(q, (double[2]){0.1, low + 0.1 * size}), hot, 0);
        assert_near(q->initial(q, (double[2]){0.1, low - 0.1 * size}), 0, 0);
        assert_near(q->initial(q, (double[2]){p.jump[0][1] + 0.1 * size, 0.1}), 0, 0);
    }
}

static double warm_middle(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    double along = (x[1 - s / 2] - p->lo[1 - s / 2]) / (p->hi[1 - s / 2] - p->lo[1 - s / 2]);
    return along > 0.4 && along < 0.6;
}

/* A side that is warm in its middle alone, at the coordinate along it. */
static void wall_value_in_the_middle_alone_is_found(void **state) {
    (void)state;
    struct problem p = problem_of("plate");
    struct faulty with;
    p.wall = warm_middle;
    p.lo[0] += 10, p.hi[0] += 10;
    for (int s = 0; s < 4; s++) {
        p.side[s] = NEUMANN;
        assert_true(faulty_make(&p, (struct fault){FAULT_WALL, s}, 0.01, &with));
    }
}

static void a_cross_term_is_lost_or_has_the_other_sign(void **state) {
    (void)state;
    struct problem p = problem_of("rect-manufactured");
    struct faulty with;
    p.cross[0] = 0.3 * p.material[0].k[0];
    assert_true(faulty_make(&p, (struct fault){FAULT_CROSS, 0}, 1, &with));
    assert_near(with.problem.cross[0], 0, 0);
    assert_true(faulty_make(&p, (struct fault){FAULT_CROSS, 1}, 1, &with));
    assert_near(with.problem.cross[0], -p.cross[0], 0);
}

/* Size 1 is a right angle, anticlockwise. */
static void a_field_is_turned_by_its_size(void **state) {
    (void)state;
    struct problem p = problem_of("ring");
    struct faulty with;
    const double x[DIM_MAX] = {0.31, -0.17, 0};
    double b[DIM_MAX], turned[DIM_MAX];
    assert_true(faulty_make(&p, (struct fault){FAULT_TURN, 0}, 1. / 9, &with));
    p.direction(&p, x, b), with.problem.direction(&with.problem, x, turned);
    assert_near(b[0] * turned[1] - b[1] * turned[0], sin(M_PI / 18), 1e-15);
    assert_true(faulty_make(&p, (struct fault){FAULT_FIELD, FIELD_SWAPPED}, 1, &with));
    with.problem.direction(&with.problem, x, turned);
    for (int a = 0; a < 2; a++) assert_near(turned[a], -b[1 - a], 1e-15);
    assert_true(faulty_make(&p, (struct fault){FAULT_K_PAR, 0}, 0.21, &with));
    assert_near(with.problem.k_par, 1.21 * p.k_par, 1e-15 * p.k_par);
    assert_false(faulty_make(&(struct problem){.dim = 2}, (struct fault){FAULT_TURN, 0}, 1, &with));
}

/* A positive size is a later time: the source at t is that of the scene at t + size. */
static void sources_are_late_by_their_size(void **state) {
    (void)state;
    struct problem p = problem_of(CHANGING);
    struct faulty with;
    const double x[DIM_MAX] = {0.37 * p.hi[0], 0.61 * p.hi[1], 0}, late[] = {0.031, -0.017};
    assert_order(fabs(problem_source(&p, x, 0.1 + late[0]) - problem_source(&p, x, 0.1)), >, 1e-3);
    for (int k = 0; k < 2; k++) {
        assert_true(faulty_make(&p, (struct fault){FAULT_SOURCE_TIME, 0}, late[k], &with));
        double due = problem_source(&p, x, 0.1 + late[k]);
        assert_near(problem_source(&with.problem, x, 0.1), due, 1e-12 * fabs(due)); /* one product's rounding */
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impossible_sizes_are_refused),
        cmocka_unit_test(conductivity_and_pace_differ_by_sources_fluxes_and_air),
        cmocka_unit_test(probe_sizes_along_y_use_the_extent_of_y),
        cmocka_unit_test(sides_and_corners_have_faults_of_their_own),
        cmocka_unit_test(held_sides_move_and_sides_of_given_flux_leak),
        cmocka_unit_test(air_is_of_robin_sides),
        cmocka_unit_test(half_a_cell_at_robin_walls_is_across_an_axis),
        cmocka_unit_test(faults_apply_to_existing_parts_only),
        cmocka_unit_test(stretched_bodies_keep_walls_and_sources),
        cmocka_unit_test(starts_move_along_y),
        cmocka_unit_test(wall_value_in_the_middle_alone_is_found),
        cmocka_unit_test(a_cross_term_is_lost_or_has_the_other_sign),
        cmocka_unit_test(a_field_is_turned_by_its_size),
        cmocka_unit_test(sources_are_late_by_their_size),
    };
    return cmocka_run_group_tests_name("fault", tests, NULL, NULL);
}
