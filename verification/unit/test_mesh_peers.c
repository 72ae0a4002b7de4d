/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Voronoi cells beside those of others: stand-ins that print what is known beforehand. */
#include "verification/bench/mesh_peers.h"

#include "solver/status.h"
#include "verification/text/output.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <string.h>

enum { N = 16 };

/* The cells of N x N particles fill a square of 4 m: 16 m^2.  Its faces' length is learnt from a refusal. */
static double length_of_faces(void) {
    static const struct mesh_peer none[] = {{"none", "echo 1 16 0"}, {.who = NULL}};
    struct failure why;
    double length = 0;
    struct output page;
    assert_int_equal(mesh_peers_run(none, N, output_open(&page, "table"), &why), STATUS_NUMERICAL);
    assert_has(why.text, "the cells of none are not ours: areas 16 and 16 m^2, faces 0 and ");
    assert_int_equal(sscanf(strstr(why.text, "faces 0 and "), "faces 0 and %lf m", &length), 1);
    output_drop(&page, 1);
    return length;
}

/* Of a square lattice 2 N (N - 1) faces are dx long each: 120 m here.  No cells of that area have less than hexagons,
 * 0.931 of it; a little jitter is between, as it cuts corners. */
static void programs_that_agree_are_timed(void **state) {
    (void)state;
    char good[120];
    struct failure why;
    struct output page;
    double length = length_of_faces();
    assert_order(length, >, 120 * 0.931);
    assert_order(length, <, 120);
    snprintf(good, sizeof good,
             "[ $(wc -l <$1) = %d ] && [ \"$2 $3 $4 $5\" = '-2 2 -2 2' ] && echo 512 16 %.12g; :", N * N, length);
    const struct mesh_peer table[] = {{"good", good}, {"absent", "exit 77"}, {.who = NULL}};
    if (mesh_peers_run(table, N, output_open(&page, "table"), &why)) fail_msg("%s", why.text);
    output_end(&page);
    assert_has(page.text, "Voronoi cells of 256 jittered particles, one thread");
    assert_has(page.text, "512 to 512");
    assert_has(page.text, "\nnot installed (make setup-peers): absent\n");
    output_drop(&page, 1);
}

static void other_cells_are_refused(void **state) {
    (void)state;
    char areas[60];
    snprintf(areas, sizeof areas, "echo 1 15.99 %.12g", length_of_faces());
    const struct {
        const char *command, *says;
    } cases[] = {{areas, "are not ours: areas 15.99 and 16 m^2"},
                 {"echo so many cells", "wrong made no cells: 'so many cells"},
                 {"echo 1 16 120; exit 3", "wrong made no cells"}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const struct mesh_peer table[] = {{"wrong", cases[k].command}, {.who = NULL}};
        struct failure why;
        struct output page;
        assert_int_equal(mesh_peers_run(table, N, output_open(&page, "table"), &why), STATUS_NUMERICAL);
        assert_has(why.text, cases[k].says);
        output_drop(&page, 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(programs_that_agree_are_timed),
        cmocka_unit_test(other_cells_are_refused),
    };
    return cmocka_run_group_tests_name("mesh_peers", tests, NULL, NULL);
}
