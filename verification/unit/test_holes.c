/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A lattice that lacks a point is refused with the place; what is no lattice, or one with another pattern, is not. */
#include "verification/foreign/points_checks.h"

#include "references/scene.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/foreign/samples.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 2000 };
static double at_x[ROOM], at_y[ROOM];

/* n[0] by n[1] points from first, a step apart, but for the k-th ("skip", -1: none); how many. */
static size_t lattice(const double first[2], const double step[2], const int n[2], int skip) {
    size_t m = 0;
    for (int c = 0; c < n[0] * n[1]; c++)
        if (c != skip) at_x[m] = first[0] + c % n[0] * step[0], at_y[m++] = first[1] + c / n[0] * step[1];
    return m;
}

static int check(const char *scene, size_t n, struct failure *why) {
    struct problem p;
    const struct scene *s = scene_find(scene);
    struct samples points = {.path = "out.csv", .n = n, .value = {at_x, at_y}};
    *why = (struct failure){0};
    scene_defaults(s, &p);
    if (s->setup(&p, why)) fail_msg("%s", why->text);
    points.dim = p.dim;
    return holes_check(&points, &p, (double[2]){0.05, 0.05}, why);
}

/* rod-cosine is 1 m long: 20 cells. */
static void a_point_of_a_rod(void **state) {
    (void)state;
    static const struct {
        int skip;
        const char *said;
    } gone[] = {{0, "x = 0.025 m"}, {1, "x = 0.075 m"}, {7, "x = 0.375 m"}, {18, "x = 0.925 m"}, {19, "x = 0.975 m"}};
    struct failure why;
    const int n[2] = {20, 1}, nodes[2] = {21, 1}, inner[2] = {19, 1};
    const double first[2] = {0.025, 0}, step[2] = {0.05, 0}, node[2] = {0, 0}, one[2] = {0.05, 0};
    for (int k = 0; k < 5; k++) {
        assert_int_equal(check("rod-cosine", lattice(first, step, n, gone[k].skip), &why), STATUS_INPUT);
        if (!strstr(why.text, gone[k].said)) fail_msg("%d: %s", gone[k].skip, why.text);
    }
    assert_int_equal(check("rod-cosine", lattice(first, step, n, -1), &why), STATUS_OK);
    assert_int_equal(check("rod-cosine", lattice(node, step, nodes, -1), &why), STATUS_OK);
    assert_int_equal(check("rod-cosine", lattice(one, step, inner, -1), &why), STATUS_OK); /* none on the walls */
    assert_int_equal(check("rod-cosine", lattice(node, step, n, -1), &why), STATUS_OK);    /* on one of them */
    for (int i = 0; i < 20; i++) at_x[i] = 0.5 - 0.5 * cos(3.14159 * i / 19);
    assert_int_equal(check("rod-cosine", 20, &why), STATUS_OK);
    for (int i = 0; i < 20; i++) at_x[i] = 0.025 + 0.05 * i + (i % 3 - 1) * 0.01;
    assert_int_equal(check("rod-cosine", 20, &why), STATUS_OK);                                /* no lattice */
    for (int i = 0; i < 20; i++) at_x[i] = i < 10 ? 0.025 + 0.025 * i : 0.3 + 0.05 * (i - 10); /* fine, then coarse */
    assert_int_equal(check("rod-cosine", 18, &why), STATUS_INPUT);
    assert_has(why.text, "x = 0.7");
}

/* Of five points that are left of six the distances show it, of four that are left of five they do not. */
static void of_few_points_none_is_missed(void **state) {
    (void)state;
    struct failure why;
    const double first[2] = {0.1, 0}, step[2] = {0.15, 0};
    for (int skip = 1; skip < 5; skip++) {
        assert_int_equal(check("rod-cosine", lattice(first, step, (int[2]){6, 1}, skip), &why), STATUS_INPUT);
        assert_near(strtod(strstr(why.text, "x = ") + 4, NULL), 0.1 + 0.15 * skip, 1e-6);
        if (skip < 4)
            assert_int_equal(check("rod-cosine", lattice(first, step, (int[2]){5, 1}, skip), &why), STATUS_OK);
    }
}

/* rod-contact from -1 to 1 m, layers that meet at 0 without a point there; at each end one is missed. */
static void an_interface_has_no_point_of_its_own(void **state) {
    (void)state;
    struct failure why;
    const int n[2] = {41, 1}, cells[2] = {40, 1};
    const double first[2] = {-1, 0}, step[2] = {0.05, 0}, centre[2] = {-0.975, 0};
    assert_int_equal(check("rod-contact", lattice(first, step, n, 20), &why), STATUS_OK);
    assert_int_equal(check("rod-contact", lattice(first, step, n, 19), &why), STATUS_INPUT);
    for (int end = 0; end < 2; end++) {
        assert_int_equal(check("rod-contact", lattice(centre, step, cells, end ? 39 : 0), &why), STATUS_INPUT);
        assert_has(why.text, end ? "x = 0.975 m" : "x = -0.975 m");
    }
}

/* rect-manufactured is 1 m by 0.7 m. */
static void a_point_of_a_plane(void **state) {
    (void)state;
    struct failure why;
    const int n[2] = {20, 14}, nodes[2] = {21, 15}, rows[2] = {20, 13};
    const double first[2] = {0.025, 0.025}, step[2] = {0.05, 0.05}, node[2] = {0, 0};
    assert_int_equal(check("rect-manufactured", lattice(first, step, n, -1), &why), STATUS_OK);
    for (int skip = 0; skip < 280; skip += 7) {
        assert_int_equal(check("rect-manufactured", lattice(first, step, n, skip), &why), STATUS_INPUT);
        assert_has(why.text, "out.csv: 1 point is missing from 20 columns by 14 rows, at x = ");
    }
    assert_int_equal(check("rect-manufactured", lattice(first, step, n, 7 * 20 + 3), &why), STATUS_INPUT);
    assert_has(why.text, "at x = 0.175, y = 0.375 m");
    size_t m = lattice(node, step, nodes, 0);
    assert_int_equal(check("rect-manufactured", m, &why), STATUS_OK); /* a corner */
    assert_int_equal(check("rect-manufactured", m - 2, &why), STATUS_INPUT);
    assert_has(why.text, "1 point is missing");
    assert_int_equal(check("rect-manufactured", lattice(first, step, rows, -1), &why), STATUS_INPUT);
    assert_has(why.text, "missing at y = 0.675 m");
    m = lattice(node, step, nodes, -1);
    for (size_t i = 0; i < m; i++) at_x[i] += 0.01 * sin((double)i); /* a cloud */
    assert_int_equal(check("rect-manufactured", m - 1, &why), STATUS_OK);
}

/* square-step is 4 m by 4 m: coordinates that differ by less than 1e-9 of that are one column's. */
static void digits_that_were_cut(void **state) {
    (void)state;
    struct failure why;
    const int n[2] = {20, 20};
    const double first[2] = {-1.9, -1.9}, step[2] = {0.2, 0.2};
    size_t m = lattice(first, step, n, -1);
    for (size_t i = 0; i < m; i++) at_x[i] += 1.5e-9 * sin((double)i), at_y[i] += 1.5e-9 * cos(3. * (double)i);
    if (check("square-step", m, &why)) fail_msg("%s", why.text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_of_a_rod),
        cmocka_unit_test(of_few_points_none_is_missed),
        cmocka_unit_test(an_interface_has_no_point_of_its_own),
        cmocka_unit_test(a_point_of_a_plane),
        cmocka_unit_test(digits_that_were_cut),
    };
    return cmocka_run_group_tests_name("holes", tests, NULL, NULL);
}
