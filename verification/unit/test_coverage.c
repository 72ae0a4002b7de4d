/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An answer covers the domain with each point once: the usual arrangements pass; a gap, a point outside, a lattice
 * that lacks a point, and two points at one place are refused with the place. */
#include "verification/solve/coverage.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/case/samples.h"

#include "verification/unit/near.h"

#include <gsl/gsl_rng.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 160 * 160 };
static double at_x[ROOM], at_y[ROOM], at_z[ROOM];
static struct failure why;

/* Puts n[0] by n[1] points from `first` on, one step apart, without point `skip` (-1: all), and returns their
 * number. */
static size_t lattice(const double first[2], const double step[2], const int n[2], int skip) {
    size_t m = 0;
    memset(at_z, 0, sizeof at_z);
    for (int c = 0; c < n[0] * n[1]; c++)
        if (c != skip) at_x[m] = first[0] + c % n[0] * step[0], at_y[m++] = first[1] + c / n[0] * step[1];
    return m;
}

static struct problem problem_of(const char *scene) {
    struct problem p;
    scene_defaults(scene_find(scene), &p);
    assert_int_equal(scene_find(scene)->setup(&p, &why), 0);
    return p;
}

/* `check` of n points in a case of spacing dx passes where `says` is NULL. */
static void expect_of(int (*check)(const struct samples *, const struct image *, const double *, struct failure *),
                      const char *scene, double dx, size_t n, const char *says) {
    const struct image image = {.problem = problem_of(scene)};
    struct samples s = {.path = "out.csv", .dim = image.problem.dim, .n = n, .value = {at_x, at_y}};
    why = (struct failure){0};
    int status = check(&s, &image, (double[2]){dx, dx}, &why);
    if (!says && status) fail_msg("%s, %zu points: %s", scene, n, why.text);
    if (says) assert_int_equal(status, STATUS_INPUT);
    if (says) assert_has(why.text, says);
}

/* A box of 0.6 m by 0.9 m by 0.3 m from (-0.2, 0.1, 0). */
static const struct image box = {.problem = {.dim = 3, .lo = {-0.2, 0.1, 0}, .hi = {0.4, 1, 0.3}}};

/* Puts a lattice of 0.05 m into it: cells + more points along each axis, from `first` spacings; -1: none missing. */
static size_t lattice_in_box(double first, int more, int skip) {
    const int n[3] = {12 + more, 18 + more, 6 + more};
    size_t m = 0;
    for (int c = 0; c < n[0] * n[1] * n[2]; c++) {
        if (c == skip) continue;
        at_x[m] = -0.2 + 0.05 * (first + c % n[0]);
        at_y[m] = 0.1 + 0.05 * (first + c / n[0] % n[1]);
        at_z[m++] = 0.05 * (first + c / n[0] / n[1]);
    }
    return m;
}

static void expect_in_box(size_t n, const char *says) {
    static const double d[] = {0.05, 0.05, 0.05};
    struct samples s = {.path = "out.csv", .dim = 3, .n = n, .value = {at_x, at_y, at_z}};
    int status = coverage_check(&s, &box, d, &why);
    if (!says && status) fail_msg("%s", why.text);
    if (says) assert_int_equal(status, STATUS_INPUT);
    if (says) assert_has(why.text, says);
}

static void expect(const char *scene, double dx, size_t n, const char *says) {
    expect_of(coverage_check, scene, dx, n, says);
}

static void expect_missing(const char *scene, size_t n, const char *says) {
    expect_of(coverage_check_missing, scene, 0.05, n, says);
}

/* The rod and the square from -2 to 2 m: cell centres, nodes, nodes between the walls, and points off the walls. */
static void usual_arrangements_cover_the_domain(void **state) {
    (void)state;
    static const char *const scene[] = {"rod-step", "square-step"};
    for (int dim = 1; dim <= 2; dim++)
        for (int n = 4; n < 80; n = n * 3 / 2) {
            double dx = 4.0 / n;
            const struct {
                double first, step; /* in dx from the low wall */
                int n;
            } usual[] = {{0.5, 1, n}, {0, 1, n + 1}, {1, 1, n - 1}, {0.211, 1 - 0.422 / n, n}};
            for (int k = 0; k < 4; k++) {
                double first = -2 + dx * usual[k].first, step = dx * usual[k].step;
                size_t m = lattice((double[2]){first, first}, (double[2]){step, step},
                                   (int[2]){usual[k].n, dim == 2 ? usual[k].n : 1}, -1);
                expect(scene[dim - 1], dx, m, NULL);
            }
        }
    at_x[0] = 0;
    expect("rod-step", 2, 1, NULL); /* two cells: the node between */
}

static void uncovered_parts_are_refused(void **state) {
    (void)state;
    for (int n = 8; n < 80; n = n * 3 / 2) {
        double dx = 4.0 / n, low = -2 + dx / 4, at = -2 + dx / 2;
        lattice((double[2]){low, low}, (double[2]){dx / 2, dx / 2}, (int[2]){n, n}, -1);
        expect("square-step", dx, (size_t)(n * n), "the field must cover the whole domain");
        size_t half = lattice((double[2]){at, at}, (double[2]){dx, dx}, (int[2]){n / 2, 1}, -1);
        expect("rod-step", dx, half, "at least");
        lattice((double[2]){at + dx, at}, (double[2]){dx, dx}, (int[2]){n, 1}, -1);
        expect("rod-step", dx, (size_t)n, "is outside -2 to 2 m");
    }
    size_t m = 0; /* 12 by 12 cells in four by four boxes, one of them empty */
    for (int c = 0; c < 144; c++)
        if (c % 12 / 3 != 2 || c / 12 / 3 != 3)
            at_x[m] = -2 + (c % 12 + 0.5) / 3, at_y[m++] = -2 + (c / 12 + 0.5) / 3;
    expect("square-step", 1 / 3.0, m, "no point in 0 <= x <= 1 m, 1 <= y <= 2 m:");
}

/* 160 x 160 points, enough for threads; those outside the square, or in the corners around the disc. */
static void first_point_outside_is_named(void **state) {
    (void)state;
    static const int outside[2][2] = {{25000, 9000}, {9000, 25000}};
    double dx = 4.0 / 160, first = -2 + dx / 2;
    for (int k = 0; k < 2; k++) {
        size_t m = lattice((double[2]){first, first}, (double[2]){dx, dx}, (int[2]){160, 160}, -1);
        for (int i = 0; i < 2; i++) at_x[outside[k][i]] = -7;
        expect("square-step", dx, m, "line 9001: x = -7, y = ");
        assert_has(why.text, " m: x is outside -2 to 2 m");
    }
    const struct problem p = problem_of("disc-mode");
    dx = (p.hi[0] - p.lo[0]) / 160, first = p.lo[0] + dx / 2;
    size_t m = lattice((double[2]){first, first}, (double[2]){dx, dx}, (int[2]){160, 160}, -1);
    expect("disc-mode", dx, m, "line 1: x = -");
}

/* rod-cosine is 1 m long, 20 cells; rod-contact is from -1 to 1 m and has its interface at 0. */
static void missing_point_of_a_rod_is_named(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        double first, step;
        int n, skip;
        const char *says;
    } row[] = {{"rod-cosine", 0.025, 0.05, 20, 0, "x = 0.025 m"},
               {"rod-cosine", 0.025, 0.05, 20, 1, "x = 0.075 m"},
               {"rod-cosine", 0.025, 0.05, 20, 7, "x = 0.375 m"},
               {"rod-cosine", 0.025, 0.05, 20, 18, "x = 0.925 m"},
               {"rod-cosine", 0.025, 0.05, 20, 19, "x = 0.975 m"},
               {"rod-cosine", 0, 0.05, 20, -1, NULL}, /* a node on one wall, none on the other */
               {"rod-contact", -1, 0.05, 41, 20, NULL},
               {"rod-contact", -1, 0.05, 41, 19, "x = -0.05 m"},
               {"rod-contact", -0.975, 0.05, 40, 0, "x = -0.975 m"},
               {"rod-contact", -0.975, 0.05, 40, 39, "x = 0.975 m"}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        expect_missing(
            row[i].scene,
            lattice((double[2]){row[i].first, 0}, (double[2]){row[i].step, 0}, (int[2]){row[i].n, 1}, row[i].skip),
            row[i].says);
    for (int i = 0; i < 20; i++) at_x[i] = 0.5 - 0.5 * cos(M_PI * i / 19);
    expect_missing("rod-cosine", 20, NULL); /* Chebyshev's points */
    for (int i = 0; i < 20; i++) at_x[i] = 0.025 + 0.05 * i + (i % 3 - 1) * 0.01;
    expect_missing("rod-cosine", 20, NULL);
    for (int i = 0; i < 20; i++) at_x[i] = i < 10 ? 0.025 + 0.025 * i : 0.3 + 0.05 * (i - 10);
    expect_missing("rod-cosine", 18, "x = 0.7"); /* fine, then coarse, and less than the rod */
}

/* Distances show a missing point where five are left, not where four are. */
static void four_points_do_not_determine_a_spacing(void **state) {
    (void)state;
    const double first[2] = {0.1, 0}, step[2] = {0.15, 0};
    for (int skip = 1; skip < 5; skip++) {
        expect_missing("rod-cosine", lattice(first, step, (int[2]){6, 1}, skip), "a point is missing");
        assert_near(strtod(strstr(why.text, "x = ") + 4, NULL), 0.1 + 0.15 * skip, 1e-6);
        if (skip < 4) expect_missing("rod-cosine", lattice(first, step, (int[2]){5, 1}, skip), NULL);
    }
}

/* rect-manufactured is 1 m by 0.7 m, square-step 4 m by 4 m. */
static void missing_point_of_a_plane_is_named(void **state) {
    (void)state;
    const int n[2] = {20, 14}, nodes[2] = {21, 15}, square[2] = {20, 20};
    const double centre[2] = {0.025, 0.025}, step[2] = {0.05, 0.05}, node[2] = {0, 0};
    for (int skip = 0; skip < 280; skip += 7)
        expect_missing("rect-manufactured", lattice(centre, step, n, skip),
                       "out.csv: 1 point is missing from 20 columns by 14 rows, at x = ");
    expect_missing("rect-manufactured", lattice(centre, step, n, 7 * 20 + 3), "at x = 0.175, y = 0.375 m");
    size_t m = lattice(node, step, nodes, 0);
    expect_missing("rect-manufactured", m, NULL); /* no corner */
    expect_missing("rect-manufactured", m - 2, "1 point is missing");
    m = lattice(centre, step, n, -1);
    at_x[m] = 0, at_y[m] = 0.375;
    expect_missing("rect-manufactured", m + 1,
                   "at x = 0, y = 0.025 m and elsewhere: the wall x = 0 m has points along");
    m = lattice(node, step, nodes, 2 * 21);
    at_x[5 * 21 + 2] = at_x[5 * 21 + 1]; /* a place inside is named before one on a wall */
    expect_missing("rect-manufactured", m,
                   "2 points are missing from 21 columns by 15 rows, at x = 0.15, y = 0.25 m and");
    assert_null(strstr(why.text, "wall"));
    expect_missing("rect-manufactured", lattice(centre, step, (int[2]){20, 13}, -1), "missing at y = 0.675 m");
    m = lattice(node, step, nodes, -1);
    for (size_t i = 0; i < m; i++) at_x[i] += 0.01 * sin((double)i) * (at_x[i] > 0.1 && at_x[i] < 0.9);
    expect_missing("rect-manufactured", m - 1, NULL); /* a cloud */
    m = lattice((double[2]){-1.9, -1.9}, (double[2]){0.2, 0.2}, square, -1);
    for (size_t i = 0; i < m; i++) at_x[i] += 1.5e-9 * sin((double)i), at_y[i] += 1.5e-9 * cos(3. * (double)i);
    expect("square-step", 0.2, m, NULL); /* coordinates that differ by less than 1e-9 of 4 m make one column */
}

static void usual_arrangements_cover_a_box(void **state) {
    (void)state;
    expect_in_box(lattice_in_box(0.5, 0, -1), NULL);
    expect_in_box(lattice_in_box(0, 1, -1), NULL);
    expect_in_box(lattice_in_box(1, -1, -1), NULL);
    expect_in_box(lattice_in_box(0, 1, 5), NULL); /* no point of an edge */
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    size_t m = lattice_in_box(0.5, 0, -1);
    for (size_t i = 0; i < m; i++) {
        at_x[i] += 0.02 * (gsl_rng_uniform(r) - 0.5), at_y[i] += 0.02 * (gsl_rng_uniform(r) - 0.5);
        at_z[i] += 0.02 * (gsl_rng_uniform(r) - 0.5);
    }
    expect_in_box(m, NULL);
    for (size_t i = 0; i < m; i++) {
        at_x[i] = -0.2 + 0.6 * gsl_rng_uniform(r), at_y[i] = 0.1 + 0.9 * gsl_rng_uniform(r);
        at_z[i] = 0.3 * gsl_rng_uniform(r);
    }
    expect_in_box(m, NULL);
    gsl_rng_free(r);
}

static void uncovered_and_doubled_parts_of_a_box_are_refused(void **state) {
    (void)state;
    size_t m = lattice_in_box(0.5, 0, -1), layers = m / 6;
    expect_in_box(5 * layers, "missing at z = 0.275 m");
    expect_in_box(3 * layers, "where dx = 0.05 m asks for 935 at least");
    for (size_t i = 5 * layers; i < m; i++) at_z[i] = at_z[i - layers] - 0.02;
    expect_in_box(m, NULL);
    for (size_t i = 0; i < m; i++) at_z[i] *= 0.3;
    expect_in_box(m, "no point in -0.2 <= x <= -0.08 m, 0.1 <= y <= 0.22");
    assert_has(why.text, "0.1 <= z <= 0.2 m");
    m = lattice_in_box(0.5, 0, -1);
    at_z[77] = 0.31;
    expect_in_box(m, "line 78: x = 0.075, y = 0.425, z = 0.31 m: z is outside 0 to 0.3 m");
    assert_int_equal(why.exchanged, 0);
    m = lattice_in_box(0.5, 0, -1);
    for (size_t i = 0; i < m; i++) {
        const double x = at_x[i];
        at_x[i] = at_y[i], at_y[i] = x;
    }
    expect_in_box(m, "m; with x and y exchanged all points are inside");
    assert_int_equal(why.exchanged, 1);
    m = lattice_in_box(0.5, 0, 12 * 18 * 2 + 12 * 7 + 3);
    expect_in_box(m,
                  "1 point is missing from 12 columns by 18 rows by 6 layers, at x = -0.025, y = 0.475, z = 0.125 m");
    m = lattice_in_box(0.5, 0, -1);
    at_x[m] = at_x[40], at_y[m] = at_y[40], at_z[m] = at_z[40];
    expect_in_box(m + 1, "line 1297: the same point as in line 41");
}

/* Two layers of nodes, 10 by 8 by 6 cells of 0.1 m, between the walls and on neither side of an interface in the
 * middle of one axis: no node on it is due, but a plane of nodes elsewhere is, also where the interface is across
 * another. */
static void an_interface_may_have_no_nodes(void **state) {
    (void)state;
    static const int cells[3] = {10, 8, 6};
    static const double d[] = {0.1, 0.1, 0.1};
    for (int dim = 1; dim <= 3; dim++)
        for (int axis = 0; axis < dim; axis++)
            for (int off = 0; off < dim; off++) {
                struct image image = {.problem = {.dim = dim, .materials = 2, .interface = 0.05 * cells[axis]},
                                      .interface_axis = axis};
                struct samples s = {.path = "out.csv", .dim = dim, .value = {at_x, at_y, at_z}};
                int n[3] = {1, 1, 1};
                for (int a = 0; a < dim; a++) image.problem.hi[a] = 0.1 * cells[a], n[a] = cells[a] - 1;
                for (int c = 0; c < n[0] * n[1] * n[2]; c++) {
                    const int at[] = {c % n[0] + 1, c / n[0] % n[1] + 1, c / n[0] / n[1] + 1};
                    if (at[off] == cells[off] / 2) continue;
                    for (int a = 0; a < dim; a++) s.value[a][s.n] = 0.1 * at[a];
                    s.n++;
                }
                int status = coverage_check(&s, &image, d, &why);
                if (off == axis && status) fail_msg("%d of %d: %s", axis, dim, why.text);
                assert_int_equal(status, off == axis ? STATUS_OK : STATUS_INPUT);
            }
}

/* Axes of two to five cells: cell centres, nodes and inner nodes pass; each without one of them is refused. */
static void a_layer_of_few_is_missed(void **state) {
    (void)state;
    static const double first[] = {0.5, 0, 1};
    for (int cells = 2; cells <= 5; cells++)
        for (int kind = 0; kind < 3; kind++)
            for (int skip = -1; skip < cells - (kind == 2) + (kind == 1); skip++) {
                struct image image = {.problem = {.dim = 3, .materials = 1, .hi = {0.6, 0.6, 0.1 * cells}}};
                struct samples s = {.path = "out.csv", .dim = 3, .value = {at_x, at_y, at_z}};
                int layers = cells - (kind == 2) + (kind == 1), wall = kind == 1 && (skip == 0 || skip == layers - 1);
                for (int c = 0; c < 36 * layers; c++) {
                    if (c / 36 == skip) continue;
                    at_x[s.n] = 0.05 + 0.1 * (c % 6), at_y[s.n] = 0.05 + 0.1 * (c / 6 % 6);
                    at_z[s.n++] = 0.1 * (first[kind] + c / 36);
                }
                int status = s.n ? coverage_check(&s, &image, (double[]){0.1, 0.1, 0.1}, &why) : STATUS_INPUT;
                if (status != (skip < 0 || wall ? STATUS_OK : STATUS_INPUT))
                    fail_msg("%d cells, kind %d, without %d: %d, %s", cells, kind, skip, status, why.text);
            }
}

/* 2 m by half a metre: two points are the same within 2 nm along x and half a nanometre along y. */
static const struct problem body = {.dim = 2, .lo = {0.25, -1}, .hi = {2.25, -0.5}};
static const double nearest[2] = {2e-9, 0.5e-9};

static int is_pair(int dim, int i, int j) {
    return fabs(at_x[i] - at_x[j]) <= nearest[0] && (dim == 1 || fabs(at_y[i] - at_y[j]) <= nearest[1]);
}

/* Compares with all pairs; the two lines of the message are one of them.  1 where there is a pair. */
static int compare(int dim, int n) {
    struct problem p = body;
    struct samples s = {.path = "file", .dim = dim, .n = (size_t)n, .value = {at_x, at_y}};
    int pairs = 0, second = 0, first = 0;
    p.dim = dim;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) pairs += is_pair(dim, i, j);
    assert_int_equal(coverage_check_once(&s, &p, &why), pairs ? STATUS_INPUT : STATUS_OK);
    if (!pairs) return 0;
    if (sscanf(why.text, "file, line %d: the same point as in line %d", &second, &first) != 2)
        fail_msg("%s", why.text);
    assert_true(first < second && is_pair(dim, first - 1, second - 1));
    return 1;
}

/* Coordinates in units of the tolerance, near each other and far: chains along x, pairs in chains, none. */
static void two_points_at_one_place_are_found(void **state) {
    (void)state;
    enum { DRAWS = 8000 };
    static const double within[] = {0, 0.37, 0.81, 1.23, 7.5, 63.2, 63.66};
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    int found[2] = {0, 0};
    for (int k = 0; k < DRAWS; k++) {
        int dim = 1 + k % 2, n = 2 + (int)gsl_rng_uniform_int(r, dim == 2 ? 24 : 6);
        for (int i = 0; i < n; i++) {
            double far_x = 64.0 * (double)gsl_rng_uniform_int(r, 4), far_y = 64.0 * (double)gsl_rng_uniform_int(r, 4);
            at_x[i] = body.lo[0] + nearest[0] * (far_x + within[gsl_rng_uniform_int(r, 7)]);
            at_y[i] = body.lo[1] + nearest[1] * (far_y + within[gsl_rng_uniform_int(r, 7)]);
        }
        found[dim - 1] += compare(dim, n);
    }
    for (int d = 0; d < 2; d++) {
        assert_order(found[d], >, DRAWS / 8);
        assert_order(found[d], <, DRAWS * 3 / 8);
    }
    gsl_rng_free(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(usual_arrangements_cover_the_domain),
        cmocka_unit_test(uncovered_parts_are_refused),
        cmocka_unit_test(first_point_outside_is_named),
        cmocka_unit_test(missing_point_of_a_rod_is_named),
        cmocka_unit_test(four_points_do_not_determine_a_spacing),
        cmocka_unit_test(missing_point_of_a_plane_is_named),
        cmocka_unit_test(two_points_at_one_place_are_found),
        cmocka_unit_test(usual_arrangements_cover_a_box),
        cmocka_unit_test(uncovered_and_doubled_parts_of_a_box_are_refused),
        cmocka_unit_test(an_interface_may_have_no_nodes),
        cmocka_unit_test(a_layer_of_few_is_missed),
    };
    return cmocka_run_group_tests_name("coverage", tests, NULL, NULL);
}
