/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The battery's draw: the same for a seed, within its ranges, of every image; and bounds that follow it. */
#include "verification/gates/battery.h"

#include "verification/case/command.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>

/* The request of a row as it is drawn. */
static void parse(const struct battery_row *row, unsigned long seed, struct command *r) {
    static const char *const program[] = {"--solver", "{case} {out}", NULL};
    char command[BATTERY_COMMAND];
    struct failure why = {0};
    if (battery_command(row, seed, command, &why) || command_read_with(command, program, r, &why))
        fail_msg("%s, seed %lu: %s: %s", row->id, seed, command, why.text);
}

static double param_of(const struct command *r, const char *name) {
    const struct scene *s = r->experiment.scene;
    for (int i = 0; s->params[i].name; i++)
        if (strcmp(s->params[i].name, name) == 0) return r->experiment.problem.param[i];
    fail_msg("%s has no %s", s->name, name);
    return NAN;
}

static void draws_lie_within_their_ranges(void **state) {
    (void)state;
    for (const struct battery_row *row = battery_table; row->orders; row++)
        for (unsigned long seed = 1; seed <= 20; seed++) {
            struct command r, again;
            parse(row, seed, &r);
            parse(row, seed, &again);
            const struct mapping *m = &r.experiment.program.map;
            assert_true(mapping_same(m, &again.experiment.program.map));
            assert_int_equal(m->axes, r.experiment.problem.dim);
            assert_order(m->scale, >=, 0.5);
            assert_order(m->scale, <=, 2);
            char name[32];
            double lo, hi;
            int used;
            for (const char *at = row->ranges; *at; at += strspn(at, " ")) {
                if (sscanf(at, "%31[A-Za-z0-9_]=%lf:%lf%n", name, &lo, &hi, &used) != 3) {
                    assert_true(strncmp(at, "cross", 5) == 0 || strncmp(at, "turned", 6) == 0 ||
                                strncmp(at, "opposite", 8) == 0);
                    at += strcspn(at, " ");
                    continue;
                }
                at += used;
                double value = strcmp(name, "offset") == 0 ? m->offset / m->scale : param_of(&r, name);
                double slack = 0.006 * fmax(fabs(lo), fabs(hi)); /* three digits, of either factor */
                if (!(value >= lo - slack && value <= hi + slack)) fail_msg("%s: %s = %g", row->id, name, value);
                if (strcmp(name, "offset") != 0) assert_true(value == param_of(&again, name));
            }
            command_free(&again);
            command_free(&r);
        }
}

/* Seeds draw all images, and crossed rows complement the others: a side that is never the low one in one row is the
 * low one in the other; an axis that is y in one is x in the other. */
/* 400 draws leave one of 48 out with a probability of 48 (47/48)^400 = 1 %. */
static void draws_of_a_box_are_its_symmetries(void) {
    const struct battery_row *row = battery_table;
    int seen[27][8] = {{0}}, count = 0;
    while (strcmp(row->id, "space/smooth") != 0) row++;
    for (unsigned long seed = 1; seed <= 400; seed++) {
        struct command r;
        parse(row, seed, &r);
        const struct mapping *m = &r.experiment.program.map;
        int *place = &seen[m->from[0] + 3 * m->from[1] + 9 * m->from[2]]
                          [m->against[0] + 2 * m->against[1] + 4 * m->against[2]];
        count += !(*place)++;
        command_free(&r);
    }
    assert_int_equal(count, 48);
}

static void all_symmetries_are_drawn(void **state) {
    (void)state;
    int seen[2][8] = {{0}, {0}};
    const struct battery_row *source = NULL, *changing = NULL;
    for (const struct battery_row *row = battery_table; row->orders; row++) {
        if (row->orders & 2 && strcmp(row->id, "plane/source") == 0) source = row;
        if (row->orders & 2 && strcmp(row->id, "plane/changing") == 0) changing = row;
        for (unsigned long seed = 1; seed <= 20; seed++) {
            struct command r;
            parse(row, seed, &r);
            const struct mapping *m = &r.experiment.program.map;
            if (m->axes < 3) seen[m->axes - 1][4 * m->from[0] + 2 * m->against[1] + m->against[0]]++;
            command_free(&r);
        }
    }
    draws_of_a_box_are_its_symmetries();
    assert_true(seen[0][0] && seen[0][1]);
    for (int i = 0; i < 8; i++) assert_order(seen[1][i], >, 0);
    assert_true(source && changing);
    for (unsigned long seed = 1; seed <= 20; seed++) {
        struct command r[2];
        parse(source, seed, &r[0]);
        parse(changing, seed, &r[1]);
        const struct mapping *m = &r[0].experiment.program.map, *n = &r[1].experiment.program.map;
        assert_true(m->from[0] != n->from[0] && m->against[0] != n->against[0] && m->against[1] != n->against[1]);
        command_free(&r[0]);
        command_free(&r[1]);
    }
}

/* Seeds draw most of the 48 maps of a box, and a crossed row has each axis of the other one at the next place. */
static void seeds_draw_the_maps_of_a_box(void **state) {
    (void)state;
    char drawn[48][MAPPING_WORDS];
    int maps = 0;
    const struct battery_row *walls = NULL, *heat = NULL;
    for (const struct battery_row *row = battery_table; row->orders; row++) {
        if (strcmp(row->id, "space/walls") == 0) walls = row;
        if (strcmp(row->id, "space/heat") == 0) heat = row;
    }
    assert_true(walls && heat);
    for (unsigned long seed = 1; seed <= 200; seed++) {
        struct command r[2];
        char words[MAPPING_WORDS];
        int k = 0;
        parse(walls, seed, &r[0]);
        parse(heat, seed, &r[1]);
        const struct mapping *m = &r[0].experiment.program.map, *n = &r[1].experiment.program.map;
        for (int a = 0; a < 3; a++) assert_true(n->from[a] == (m->from[a] + 1) % 3 && n->against[a] != m->against[a]);
        mapping_print(m, words);
        while (k < maps && strcmp(drawn[k], words) != 0) k++;
        if (k == maps) strcpy(drawn[maps++], words);
        command_free(&r[0]);
        command_free(&r[1]);
    }
    assert_order(maps, >=, 44); /* 200 draws leave out 0.7 of 48 on average */
}

/* A drawn value replaces the written one, once; seed 0 draws nothing. */
static void drawn_value_replaces_the_default(void **state) {
    (void)state;
    static const struct battery_row row = {
        1, "a/b", "order", "ladder rect-manufactured", "k_x=0.5 A=0.3", "--aspect 2 --dx 0.1", "k_x=2:3 offset=1:2",
        0, ""};
    char command[BATTERY_COMMAND];
    struct failure why = {0};
    assert_int_equal(battery_command(&row, 0, command, &why), STATUS_OK);
    assert_string_equal(command, "ladder rect-manufactured mine --set k_x=0.5 --set A=0.3 --aspect 2 --dx 0.1");
    assert_int_equal(battery_command(&row, 7, command, &why), STATUS_OK);
    assert_has(command, "ladder rect-manufactured mine --set A=0.3 --set k_x=2.");
    assert_lacks(command, "k_x=0.5");
    assert_has(command, " --map ");
    assert_has(command, " --offset ");
    assert_has(command, " --aspect 2 --dx 0.1");
}

/* Adds the axes across whose sides the row gives a flux that is not 0. */
static void mark_fluxes(const struct battery_row *row, unsigned long seed, int given[2]) {
    struct command r;
    struct image image;
    parse(row, seed, &r);
    mapping_image(&r.experiment.program.map, &r.experiment.problem, &image);
    const struct problem *p = &image.problem;
    for (int s = 0; s < 2 * p->dim; s++) {
        double x[DIM_MAX];
        for (int a = 0; a < p->dim; a++) x[a] = (p->lo[a] + p->hi[a]) / 2;
        x[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
        given[s / 2] |=
            p->side[s] == NEUMANN && fabs(p->wall(p, (enum side)s, x, 0)) > 1e-3 * fabs(p->material[0].k[0]);
    }
    command_free(&r);
}

/* A code that skips sources that depend on time, and one spacing along each axis, has fluxes across both axes. */
static void every_draw_gives_fluxes_across_both_axes(void **state) {
    (void)state;
    for (int order = 1; order <= 4; order *= 2)
        for (unsigned long seed = 1; seed <= 50; seed++) {
            int given[2] = {0, 0};
            for (const struct battery_row *row = battery_table; row->orders; row++)
                if (row->orders & order && strncmp(row->id, "plane/", 6) == 0 && !strstr(row->sets, "rise") &&
                    !strstr(row->rungs, "--aspect"))
                    mark_fluxes(row, seed, given);
            if (!given[0] || !given[1]) fail_msg("order %d, seed %lu: x %d, y %d", order, seed, given[0], given[1]);
        }
}

/* A flux is that through a side of the case: whole/flux, the cooled side of the rod, in either image. */
static void fluxes_are_named_by_sides_of_the_case(void **state) {
    (void)state;
    int seen[2] = {0, 0};
    for (const struct battery_row *row = battery_table; row->orders; row++)
        for (unsigned long seed = 1; seed <= 10 && strcmp(row->id, "whole/flux") == 0; seed++) {
            struct command r;
            parse(row, seed, &r);
            int mirrored = r.experiment.program.map.against[0];
            assert_string_equal(r.experiment.derived, mirrored ? "flux_x_lo" : "flux_x_hi");
            assert_int_equal(r.experiment.quantity.side, X_HI);
            seen[mirrored]++;
            command_free(&r);
        }
    assert_true(seen[0] && seen[1]);
}

/* A contact in the plane is across x in one of two rows and across y in the other. */
static void both_axes_have_a_contact(void **state) {
    (void)state;
    for (unsigned long seed = 1; seed <= 20; seed++) {
        int swapped = 0, rows = 0;
        for (const struct battery_row *row = battery_table; row->orders; row++) {
            struct command r;
            if (strcmp(row->id, "contact/plane") != 0 && strcmp(row->id, "contact/across") != 0) continue;
            parse(row, seed, &r);
            swapped += r.experiment.program.map.from[0], rows++;
            command_free(&r);
        }
        assert_int_equal(rows, 2);
        assert_int_equal(swapped, 1);
    }
}

/* Rows of boxes: every kind of wall on every axis, an interface across every axis, and a column along every axis. */
static void every_draw_has_each_wall_on_each_axis(void **state) {
    (void)state;
    for (unsigned long seed = 1; seed <= 50; seed++) {
        int walls[DIM_MAX][ROBIN + 1] = {{0}}, interface[DIM_MAX] = {0}, column[DIM_MAX] = {0};
        for (const struct battery_row *row = battery_table; row->orders; row++) {
            struct command r;
            struct image image;
            if (strncmp(row->id, "space/", 6) != 0) continue;
            parse(row, seed, &r);
            mapping_image(&r.experiment.program.map, &r.experiment.problem, &image);
            const struct problem *p = &image.problem;
            int manufactured = strcmp(r.experiment.scene->name, "box-manufactured") == 0;
            if (p->materials == 2) interface[image.interface_axis]++;
            for (int s = 0; s < 2 * p->dim && manufactured; s++) walls[s / 2][p->side[s]]++;
            for (int a = 0; a < p->dim; a++) column[a] += p->hi[a] - p->lo[a] > 1.9;
            command_free(&r);
        }
        for (int a = 0; a < DIM_MAX; a++) {
            assert_int_equal(interface[a], 1);
            assert_order(column[a], >, 0);
            if (!walls[a][DIRICHLET] || !walls[a][NEUMANN] || !walls[a][ROBIN])
                fail_msg("seed %lu, axis %d: %d held, %d flux, %d cooled", seed, a, walls[a][DIRICHLET],
                         walls[a][NEUMANN], walls[a][ROBIN]);
        }
    }
}

static void invalid_ranges_are_refused(void **state) {
    (void)state;
    static const char *const wrong[] = {"kappa", "kappa=1", "kappa=2:1", "kappa=a:b", "=1:2"};
    char command[BATTERY_COMMAND];
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct failure why = {0};
        const struct battery_row row = {2, "a/b", "error", "run rod-step", "", "--dx 0.05", wrong[i], 0, ""};
        assert_int_equal(battery_command(&row, 1, command, &why), STATUS_INPUT);
        assert_has(why.text, "NAME=LO:HI is wanted");
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(draws_lie_within_their_ranges),
        cmocka_unit_test(all_symmetries_are_drawn),
        cmocka_unit_test(drawn_value_replaces_the_default),
        cmocka_unit_test(invalid_ranges_are_refused),
        cmocka_unit_test(every_draw_gives_fluxes_across_both_axes),
        cmocka_unit_test(fluxes_are_named_by_sides_of_the_case),
        cmocka_unit_test(both_axes_have_a_contact),
        cmocka_unit_test(seeds_draw_the_maps_of_a_box),
        cmocka_unit_test(every_draw_has_each_wall_on_each_axis),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("draw", tests, NULL, NULL);
}
