/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sentences for faults, and one headline for all rows of a battery. */
#include "verification/fault/headline.h"
#include "verification/fault/fit.h"
#include "verification/fault/wording.h"

#include "verification/unit/diagnosed_problems.h"
#include "verification/unit/near.h"

#include <math.h>
#include <string.h>

static struct diagnosis of(enum fault_kind kind, int at, double size, const char *unit) {
    return (struct diagnosis){.named = 1, .fault = {kind, at}, .size = size, .unit = unit, .share = 0.95};
}

/* Each row of the table, at each place and of either sign. */
static void every_fault_has_a_sentence(void **state) {
    (void)state;
    for (int kind = 0; kind < FAULT_KINDS; kind++)
        for (int at = -1; at < fault_places((enum fault_kind)kind); at++)
            for (int sign = -1; sign <= 1; sign += 2) {
                struct diagnosis d = of((enum fault_kind)kind, at, sign * 12.5, "%");
                wording_fault(&d);
                if (!*d.what || strchr(d.what, '{') || strstr(d.what, "null"))
                    fail_msg("%s at %d: %s", fault_rows[kind].name, at, d.what);
            }
}

static void sizes_choose_the_sentence(void **state) {
    (void)state;
    static const struct {
        struct fault fault;
        double size;
        const char *unit, *says;
    } rows[] = {
        {{FAULT_CLOCK, 0}, -0.98765, "steps", "as if the run had stopped 0.988 steps early"},
        {{FAULT_CLOCK, 0}, 0.25, "dx^2/kappa", "0.25 dx^2/kappa late: one step, if steps are of that length"},
        {{FAULT_SOURCE, 0}, 400, "%", "as if the source were 400 % too large"},
        {{FAULT_SOURCE, 0}, -95.1, "%", "as if the source were lost"},
        {{FAULT_SOURCE, 0}, -191, "%", "as if the source had the wrong sign"},
        {{FAULT_SOURCE_TIME, 0}, -1, "steps", "as if the source were that of 1 step earlier"},
        {{FAULT_SOURCE_TIME, 0}, -0.52, "steps", "0.52 steps earlier: of the step's start, not its middle"},
        {{FAULT_WALL, 3}, -94.9, "%", "as if what side y_hi holds were 94.9 % too small"},
        {{FAULT_WALL, 3}, -104.9, "%", "as if what side y_hi holds were lost"},
        {{FAULT_WALL, 1}, 301, "%", "as if what side x_hi holds were another value"},
        {{FAULT_WALL, FAULT_ALL_SIDES}, 5, "%", "as if what sides of given flux hold were 5 % too large"},
        {{FAULT_EXTENT, FAULT_BOTH_AXES}, 0.5, "cells", "as if the sides across x and y were 0.5 cells further out"},
        {{FAULT_OFFSET, 0}, -273.15, "K", "273.15 K too low: degrees Celsius and kelvin are mixed"},
        {{FAULT_UNSTABLE, 0}, 1e30, "K", "overflow: temperatures up to 1e+30 K"},
        {{FAULT_UNSTABLE, 0}, 0, "", "temperatures overflow, as in an unstable run"},
        {{FAULT_AMPLITUDE, 0}, -1, "%", "as if all temperatures were 1 % too small, or heat were lost everywhere"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct diagnosis d = of(rows[i].fault.kind, rows[i].fault.at, rows[i].size, rows[i].unit);
        wording_fault(&d);
        assert_has(d.what, rows[i].says);
    }
}

static void sentences_end_with_the_share(void **state) {
    (void)state;
    char text[300];
    struct diagnosis d = {.named = 1, .share = 0.954, .what = "as if late"};
    wording_text(&d, text, sizeof text);
    assert_string_equal(text, "as if late (95 % of the error)");
    d.share = NAN;
    wording_text(&d, text, sizeof text);
    assert_string_equal(text, "as if late");
}

/* ---- Headlines ---- */

/* The errors of a code with that fault in a scene, at dx and 2 dx. */
static struct diagnosis shown(const char *scene, struct fault fault, double units, double dx) {
    struct problem p = problem_of(scene);
    struct rung r[2];
    struct diagnosis d;
    for (int k = 0; k < 2; k++) solve(scene, &p, fault, units, k ? 2 * dx : dx, &r[k]);
    diagnosis_find(&p, &r[0].at, &r[1].at, &d);
    for (int k = 0; k < 2; k++) forget(&r[k]);
    return d;
}

enum { ROWS = 3 };
static const char *const scenes_of[ROWS] = {"rod-gauss", "rod-cooling", "rect-manufactured"};
static const double spacings[ROWS] = {0.15, 0.005, 0.05};

static void forget_rows(struct diagnosis found[ROWS]) {
    for (int i = 0; i < ROWS; i++) free(found[i].evidence);
}

/* A fault of one size in three problems is named firmly, with that size; the rows keep what it leaves. */
static void one_fault_explains_all_rows(void **state) {
    (void)state;
    static const struct {
        struct fault fault;
        double units, size;
    } rows[] = {{{FAULT_CLOCK, 0}, -2, -2},
                {{FAULT_CONDUCTIVITY, 0}, 0.1, 10},
                {{FAULT_AMPLITUDE, 0}, 0.02, 2},
                {{FAULT_START_SIZE, 0}, 0.02, 2},
                {{FAULT_OFFSET, 0}, 0.2, 0.2}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct diagnosis found[ROWS];
        for (int i = 0; i < ROWS; i++) found[i] = shown(scenes_of[i], rows[k].fault, rows[k].units, spacings[i]);
        struct headline h = headline_choose(found, ROWS, NULL, NULL);
        print_message("%s, %d votes\n", h.fault.what, h.votes);
        assert_true(h.fault.named && h.is_firm);
        assert_int_equal(h.fault.fault.kind, rows[k].fault.kind);
        assert_near(h.fault.size, rows[k].size, 0.1 * fabs(rows[k].size));
        for (int i = 0; i < ROWS; i++) assert_order(headline_share(&h, &found[i]), >, 0.9);
        forget_rows(found);
    }
}

/* Rows that show whole steps by themselves, past t_end or not; and one, with a source, that is late or early by a
 * step. */
static void rows_join_whole_steps(void **state) {
    (void)state;
    for (int k = 0; k < 4; k++) {
        const int at = k / 2, late = k % 2 ? 1 : -1, joins = (late > 0) == (at == STEPS_LATE);
        struct diagnosis found[ROWS];
        for (int i = 0; i < ROWS; i++) found[i] = of(FAULT_WHOLE_STEPS, at, 1, "");
        found[2] = shown(scenes_of[2], (struct fault){FAULT_CLOCK, 0}, late, spacings[2]);
        struct headline h = headline_choose(found, ROWS, NULL, NULL);
        print_message("%s, %d votes\n", h.fault.what, h.votes);
        assert_int_equal(h.fault.fault.kind, FAULT_WHOLE_STEPS);
        assert_int_equal(h.fault.fault.at, at);
        assert_int_equal(h.votes, joins ? 3 : 2);
        assert_int_equal(h.is_firm, joins);
        free(found[2].evidence);
    }
}

/* The diagnosis of a row whose rungs, the fine one first, end late by these numbers of steps. */
static struct diagnosis ended(const char *scene, double dx, double fine, double coarse) {
    struct problem p = problem_of(scene);
    struct rung r[2];
    struct diagnosis d;
    for (int k = 0; k < 2; k++)
        solve(scene, &p, (struct fault){FAULT_CLOCK, 0}, k ? coarse : fine, k ? 2 * dx : dx, &r[k]);
    diagnosis_find(&p, &r[0].at, &r[1].at, &d);
    for (int k = 0; k < 2; k++) forget(&r[k]);
    return d;
}

/* One step late at the fine rung, at the coarse one, at none: the last row has the error of a correct code, which any
 * small fault explains, and votes for nothing. */
static void rows_that_are_right_have_no_vote(void **state) {
    (void)state;
    struct diagnosis found[ROWS] = {ended(scenes_of[0], spacings[0], 1, 0), ended(scenes_of[1], spacings[1], 0, 1),
                                    ended(scenes_of[2], spacings[2], 0, 0)};
    struct headline h = headline_choose(found, ROWS, NULL, NULL);
    print_message("%s, %d votes\n", h.fault.what, h.votes);
    assert_int_equal(h.fault.fault.kind, FAULT_SOME_STEPS);
    assert_int_equal(h.votes, 2);
    assert_near(headline_share(&h, &found[2]), 0, 0);
    forget_rows(found);
}

/* Half the steps are as good as twice rho c where no data change in time; one row of many with such data decides. */
static void half_the_steps_are_not_twice_the_capacity(void **state) {
    (void)state;
    enum { MANY = 40 };
    static const char *const scene[] = {"rod-cooling", "rod-driven"};
    static const double dx[] = {0.005, 0.025};
    struct diagnosis found[2], row[MANY];
    for (int i = 0; i < 2; i++) {
        struct problem p = problem_of(scene[i]);
        const double half = -0.5 * p.t_end * problem_diffusivity(&p) / (0.2 * dx[i] * dx[i]);
        found[i] = ended(scene[i], dx[i], half, half / 4);
    }
    for (int i = 0; i < MANY; i++) row[i] = found[i == MANY - 1];
    for (int all = 0; all < 2; all++) {
        struct headline h = headline_choose(row, MANY - 1 + all, NULL, NULL);
        print_message("%s, %d votes\n", h.fault.what, h.votes);
        assert_int_equal(h.votes, MANY - 1 + all);
        assert_has(h.fault.what, all ? "early: half the steps" : "as if rho c were ");
    }
    for (int i = 0; i < 2; i++) free(found[i].evidence);
}

/* With a coefficient of the wrong sign T grows, and some runs overflow. */
static void an_overflow_joins_a_wrong_sign(void **state) {
    (void)state;
    const struct diagnosis found[] = {of(FAULT_AIR_SIGN, 0, 1, ""), of(FAULT_UNSTABLE, 0, 0, "")};
    struct headline h = headline_choose(found, 2, NULL, NULL);
    assert_int_equal(h.fault.fault.kind, FAULT_AIR_SIGN);
    assert_int_equal(h.votes, 2);
}

/* k, rho c and the end time are named together if T depends on k t/rho c alone; a Robin wall, a source and given
 * fluxes leave rho c and the end time. */
static void faults_of_one_effect_are_named_together(void **state) {
    (void)state;
    static const struct {
        const char *scene[2];
        double dx[2];
        enum fault_kind kind;
        unsigned paces;
        const char *says;
    } rows[] = {{{"rod-gauss", "rod-cosine"},
                 {0.15, 0.025},
                 FAULT_CONDUCTIVITY,
                 PACE_CONDUCTIVITY | PACE_CAPACITY | PACE_END,
                 "as if the diffusivity, k/rho c, or the end time were "},
                {{"rod-cooling", "rect-manufactured"},
                 {0.005, 0.05},
                 FAULT_HEAT_CAPACITY,
                 PACE_CAPACITY | PACE_END,
                 "% too small"}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct diagnosis found[2];
        for (int i = 0; i < 2; i++)
            found[i] = shown(rows[k].scene[i], (struct fault){rows[k].kind, 0}, 0.05, rows[k].dx[i]);
        struct headline h = headline_choose(found, 2, NULL, NULL);
        print_message("%s, %d votes\n", h.fault.what, h.votes);
        assert_int_equal(h.fault.paces, rows[k].paces);
        assert_has(h.fault.what, rows[k].says);
        for (int i = 0; i < 2; i++) free(found[i].evidence);
    }
}

/* Two faults in three rows: neither is firm. */
static void rows_that_disagree_name_nothing_firmly(void **state) {
    (void)state;
    struct diagnosis found[ROWS];
    for (int i = 0; i < ROWS; i++)
        found[i] = shown(scenes_of[i], (struct fault){i ? FAULT_CONDUCTIVITY : FAULT_AMPLITUDE, 0},
                         i == 2 ? -0.05 : 0.03, spacings[i]);
    struct headline h = headline_choose(found, ROWS, NULL, NULL);
    print_message("%s, %d votes\n", h.fault.what, h.votes);
    assert_false(h.is_firm);
    forget_rows(found);
}

static int against_clocks(const struct diagnosis *fault, const void *context) {
    return fault->fault.kind == FAULT_CLOCK ? *(const int *)context : 0;
}

static int confine(const struct diagnosis *fault, const void *context) {
    return fault->fault.kind == *(const enum fault_kind *)context ? 2 : 0;
}

/* In one row a conductivity and an end time explain the same: if rows outside its class contradict one, it is the
 * other.  An offset has no such rival. */
static void a_fault_of_all_rows_is_better_than_one_of_a_class(void **state) {
    (void)state;
    for (int rivals = 0; rivals < 2; rivals++) {
        struct fault fault = {rivals ? FAULT_CONDUCTIVITY : FAULT_OFFSET, 0};
        struct diagnosis found = shown("rod-gauss", fault, 0.2, 0.15);
        struct headline h = headline_choose(&found, 1, NULL, NULL);
        const enum fault_kind first = h.fault.fault.kind;
        assert_true(h.fault.named);
        h = headline_choose(&found, 1, confine, &first);
        print_message("%s, then %s\n", fault_rows[first].name, h.fault.what);
        assert_int_equal(h.fault.fault.kind == first, !rivals);
        assert_int_equal(h.scope, rivals ? 0 : 2);
        free(found.evidence);
    }
}

/* Two faults that explain as much are both named where rows melt: there many displace the front. */
static void fronts_that_are_displaced_have_two_names(void **state) {
    (void)state;
    struct diagnosis found = shown("rod-gauss", (struct fault){FAULT_CONDUCTIVITY, 0}, 0.2, 0.15);
    struct evidence *e = found.evidence;
    int at = 0;
    while (e->fit[at].fault.kind != FAULT_CONDUCTIVITY) at++;
    const struct fault_fit same = e->fit[at];
    e->fit[0] = e->fit[1] = same;
    e->fit[1].fault.kind = FAULT_LATENT;
    e->n = 2;
    for (int melts = 0; melts < 2; melts++) {
        char text[HEADLINE_TEXT];
        e->melts = melts;
        struct headline h = headline_choose(&found, 1, NULL, NULL);
        headline_print(&h, "", text);
        print_message("%s\n", text);
        assert_has(text, "perhaps as if the conductivity");
        assert_int_equal(strstr(text, ", or as if the latent heat were") != NULL, melts);
    }
    free(e);
}

/* Latent heat over a part of the difference of the walls: the range differs in K from row to row. */
static void ranges_that_follow_the_walls_are_joined(void **state) {
    (void)state;
    struct diagnosis found[2];
    for (int i = 0; i < 2; i++) {
        found[i] = shown("melt", (struct fault){FAULT_MELTING_POINT, 0}, 0.2, 0.0125);
        struct evidence *e = found[i].evidence;
        struct fault_fit *c = e->fit;
        int at = 0;
        while (e->fit[at].fault.kind != FAULT_MELTING_POINT) at++;
        *c = e->fit[at], e->n = 1; /* its response stands for that of a range */
        c->fault.kind = FAULT_RANGE, c->whole = 1 + 2 * i;
        for (int r = 0; r < 2 && i; r++) {
            c->rung[r].size *= 3;
            for (int m = 0; m < FIT_FIELDS; m++) c->rung[r].product[1][m] /= 3, c->rung[r].product[m][1] /= 3;
        }
    }
    struct headline h = headline_choose(found, 2, NULL, NULL);
    print_message("%s, %d votes\n", h.fault.what, h.votes);
    assert_has(h.fault.what, "% of the difference of walls, above the melting point");
    assert_int_equal(h.votes, 2);
    for (int i = 0; i < 2; i++) free(found[i].evidence);
}

/* Conductivities a thousand apart do not show which mean it is; ten apart, with a smaller share, they do. */
static void the_row_that_tells_means_apart_names_the_mean(void **state) {
    (void)state;
    struct diagnosis found[2];
    for (int i = 0; i < 2; i++) found[i] = shown("rod-contact", (struct fault){FAULT_MEAN, 0}, 1, 0.01);
    struct fault_fit *far = found[1].evidence->fit;
    while (far->fault.kind != FAULT_MEAN) far++;
    far->geometric = 0.94, far->rung[0].share = 1;
    struct headline h = headline_choose(found, 2, NULL, NULL);
    print_message("%s\n", h.fault.what);
    assert_has(h.fault.what, "as if the arithmetic mean");
    for (int i = 0; i < 2; i++) free(found[i].evidence);
}

/* A source that is late by some seconds explains nearly as much. */
static void a_source_that_keeps_its_first_value_is_not_of_another_time(void **state) {
    (void)state;
    struct diagnosis found = shown(CHANGING, (struct fault){FAULT_SOURCE_FROZEN, 0}, 1, 0.025);
    struct headline h = headline_choose(&found, 1, NULL, NULL);
    print_message("%s\n", h.fault.what);
    assert_int_equal(h.fault.fault.kind, FAULT_SOURCE_FROZEN);
    free(found.evidence);
}

/* Two runs of different steps show walls 1.6 steps early: one step of the run, and half a cell. */
static void a_step_too_few_explains_walls_that_are_early(void **state) {
    (void)state;
    const struct diagnosis early = of(FAULT_CLOCK, 0, -1, "steps"), walls = of(FAULT_WALL_TIME, 0, -1.6, "steps"),
                           half = of(FAULT_WALL_TIME, 0, -0.2, "steps");
    const struct diagnosis found[] = {walls, early, walls, half};
    struct headline h = headline_choose(found, 4, NULL, NULL);
    assert_int_equal(h.fault.fault.kind, FAULT_CLOCK);
    assert_int_equal(h.votes, 3);
}

/* A fault that leaves a sixth of each error is not all of the cause: with it, another is planted. */
static void a_part_of_all_errors_is_not_firm(void **state) {
    (void)state;
    struct diagnosis found[2];
    for (int i = 0; i < 2; i++) {
        found[i] = shown("rect-manufactured", (struct fault){FAULT_WALL, X_LO}, 0.1, 0.05);
        for (int k = 0; k < found[i].evidence->n; k++)
            for (int r = 0; r < 2; r++) /* the errors gain what no fault explains */
                found[i].evidence->fit[k].rung[r].product[0][0] *= 1.18,
                    found[i].evidence->fit[k].rung[r].share /= 1.18;
    }
    struct headline h = headline_choose(found, 2, NULL, NULL);
    assert_true(h.fault.named && !h.is_firm);
    for (int i = 0; i < 2; i++) free(found[i].evidence);
}

/* The only row with fits speaks for one without if the fault explains nine tenths of its error. */
static void a_row_alone_speaks_for_others_if_it_is_sure(void **state) {
    (void)state;
    struct diagnosis found[2] = {shown("rect-manufactured", (struct fault){FAULT_WALL, X_LO}, 0.1, 0.05),
                                 {.unit = ""}};
    found[0].named = 0; /* as where no size follows the spacing */
    for (int part = 0; part < 2; part++) {
        for (int k = 0; k < found[0].evidence->n && part; k++)
            for (int r = 0; r < 2; r++)
                found[0].evidence->fit[k].rung[r].product[0][0] *= 1.18,
                    found[0].evidence->fit[k].rung[r].share /= 1.18;
        assert_true(headline_choose(found, 1, NULL, NULL).fault.named);
        assert_int_equal(headline_choose(found, 2, NULL, NULL).fault.named, !part);
    }
    free(found[0].evidence);
}

/* Rows without fits vote by name; rows that pass refute the winner, or confine it to a class. */
static void rows_that_pass_decide(void **state) {
    (void)state;
    const struct diagnosis late = of(FAULT_CLOCK, 0, 1, "steps"), noisy = of(FAULT_NOISE, 0, 0.2, "K"),
                           less = of(FAULT_NOISE, 0, 0.01, "K");
    const struct diagnosis found[] = {late, late, noisy, late, less};
    static const int none = 0, all = 1, outside = 2;
    char text[HEADLINE_TEXT];
    struct headline h = headline_choose(found, 5, against_clocks, &none);
    headline_print(&h, "in space", text);
    assert_string_equal(text, "as if the run had stopped 1 step late (3 of 5 rows that do not pass)");
    h = headline_choose(found, 5, against_clocks, &all);
    headline_print(&h, "in space", text);
    assert_has(text, "perhaps answers differ by");
    h = headline_choose(found, 2, against_clocks, &outside);
    headline_print(&h, "in space", text);
    assert_string_equal(text, "in space, as if the run had stopped 1 step late (2 of 2 rows that do not pass)");
    const struct diagnosis refused[] = {of(FAULT_UNSTABLE, 0, 0, ""), of(FAULT_UNSTABLE, 0, 5e3, "K"), late};
    h = headline_choose(refused, 3, NULL, NULL);
    headline_print(&h, "", text);
    assert_has(text, "perhaps the run is unstable, up to 5e+03 K");
    assert_int_equal(h.votes, 2);
    struct diagnosis exchanged[2]; /* points outside the body */
    for (int k = 0; k < 2; k++) diagnosis_exchanged(1, &exchanged[k]);
    h = headline_choose(exchanged, 2, NULL, NULL);
    headline_print(&h, "", text);
    assert_string_equal(text, "as if y and z were swapped (2 of 2 rows that do not pass)");
    h = headline_choose(found, 0, NULL, NULL);
    headline_print(&h, "", text);
    assert_string_equal(text, "");
}

/* A row that passes refutes a fault that alone would leave twice its ceiling, if the row has walls of that kind. */
static void effects_above_a_ceiling_contradict(void **state) {
    (void)state;
    struct problem p = problem_of("rod-cosine"); /* insulated */
    struct diagnosis d = of(FAULT_CONDUCTIVITY, 0, 5, "%");
    double effect = headline_effect(&p, &d, 0.05, 0, 0);
    assert_int_equal(headline_contradicts(&d, &p, 0.05, 0, 0, 0.49 * effect), 1);
    assert_int_equal(headline_contradicts(&d, &p, 0.05, 0, 0, 0.51 * effect), 0);
    struct problem law = problem_of("wall-kirchhoff"); /* k of its own */
    assert_int_equal(headline_contradicts(&d, &law, 0.05, 0, 0, 1e-9), 0);
    for (int k = 0; k < 2; k++) {
        d = of(FAULT_EXTENT, 0, 0.5, "cells");
        d.sides = k ? 1u << DIRICHLET : 1u << NEUMANN;
        assert_int_equal(headline_contradicts(&d, &p, 0.05, 0, 0, 1e-6), k == 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fault_has_a_sentence),
        cmocka_unit_test(sizes_choose_the_sentence),
        cmocka_unit_test(sentences_end_with_the_share),
        cmocka_unit_test(one_fault_explains_all_rows),
        cmocka_unit_test(rows_join_whole_steps),
        cmocka_unit_test(faults_of_one_effect_are_named_together),
        cmocka_unit_test(rows_that_are_right_have_no_vote),
        cmocka_unit_test(half_the_steps_are_not_twice_the_capacity),
        cmocka_unit_test(an_overflow_joins_a_wrong_sign),
        cmocka_unit_test(rows_that_disagree_name_nothing_firmly),
        cmocka_unit_test(rows_that_pass_decide),
        cmocka_unit_test(a_fault_of_all_rows_is_better_than_one_of_a_class),
        cmocka_unit_test(a_step_too_few_explains_walls_that_are_early),
        cmocka_unit_test(fronts_that_are_displaced_have_two_names),
        cmocka_unit_test(ranges_that_follow_the_walls_are_joined),
        cmocka_unit_test(the_row_that_tells_means_apart_names_the_mean),
        cmocka_unit_test(a_source_that_keeps_its_first_value_is_not_of_another_time),
        cmocka_unit_test(a_part_of_all_errors_is_not_firm),
        cmocka_unit_test(a_row_alone_speaks_for_others_if_it_is_sure),
        cmocka_unit_test(effects_above_a_ceiling_contradict),
    };
    return cmocka_run_group_tests_name("headline", tests, NULL, NULL);
}
