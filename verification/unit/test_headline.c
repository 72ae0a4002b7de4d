/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sentences for faults, and one headline for all rows of a battery. */
#include "verification/fault/headline.h"
#include "verification/fault/wording.h"

#include "verification/unit/diagnosed_problems.h"
#include "verification/unit/near.h"

#include <math.h>
#include <string.h>

static void faults_have_sentences(void **state) {
    (void)state;
    static const struct {
        struct fault fault;
        double size;
        const char *unit, *says;
    } rows[] = {
        {{FAULT_CLOCK, 0}, -0.98765, "steps", "as if the run had stopped 0.988 steps early"},
        {{FAULT_CLOCK, 0}, 2, "s", "as if the run had stopped 2 s late"},
        {{FAULT_CLOCK, 0},
         0.25,
         "dx^2/kappa",
         "as if the run had stopped 0.25 dx^2/kappa late: one step, if steps are of that length"},
        {{FAULT_CONDUCTIVITY, 0}, -12.5, "%", "as if the conductivity were 12.5 % too small"},
        {{FAULT_ISOTROPIC, 0}, 100, "", "as if k_x were k_y"},
        {{FAULT_ISOTROPIC, 1}, 100, "", "as if k_y were k_x"},
        {{FAULT_AXIS, 1}, 3, "%", "as if k_y were 3 % too large"},
        {{FAULT_RHO_C, 0}, 3, "%", "as if rho c of the first material were 3 % too large"},
        {{FAULT_RHO_C, 1}, -3, "%", "as if rho c of the second material were 3 % too small"},
        {{FAULT_COEFFICIENT, 2}, 5, "%", "as if the heat transfer coefficient of side y_lo were 5 % too large"},
        {{FAULT_COEFFICIENT, FAULT_ALL_SIDES}, 5, "%", "as if the heat transfer coefficients were 5 % too large"},
        {{FAULT_SOURCE, 0}, 7, "%", "as if the source were 7 % too large"},
        {{FAULT_SOURCE, 0}, 400, "%", "as if the source were 400 % too large"},
        {{FAULT_SOURCE, 0}, -95.1, "%", "as if the source were lost"},
        {{FAULT_SOURCE, 0}, -191, "%", "as if the source had the wrong sign"},
        {{FAULT_SOURCE_TIME, 0}, -1, "steps", "as if the source were that of 1 step earlier"},
        {{FAULT_SOURCE_TIME, 0},
         -0.52,
         "steps",
         "as if the source were that of 0.52 steps earlier: of the step's start, not its middle"},
        {{FAULT_WALL, 3}, -94.9, "%", "as if what side y_hi holds were 94.9 % too small"},
        {{FAULT_WALL, 3}, -104.9, "%", "as if what side y_hi holds were lost"},
        {{FAULT_WALL, 0}, -190.5, "%", "as if what side x_lo holds had the wrong sign"},
        {{FAULT_WALL, 0}, -189, "%", "as if what side x_lo holds were 189 % too small"},
        {{FAULT_WALL, 1}, 299, "%", "as if what side x_hi holds were 299 % too large"},
        {{FAULT_WALL, 1}, 301, "%", "as if what side x_hi holds were another value"},
        {{FAULT_WALL, FAULT_ALL_SIDES}, 5, "%", "as if what sides of given flux hold were 5 % too large"},
        {{FAULT_CORNER, 1}, 100, "%", "as if 100 % of what sides hold were lost at the corner x_hi, y_lo"},
        {{FAULT_EXTENT, 1}, -0.5, "cells", "as if the sides across y were 0.5 cells further in"},
        {{FAULT_EXTENT, FAULT_BOTH_AXES}, 0.5, "cells", "as if the sides across x and y were 0.5 cells further out"},
        {{FAULT_START_SHIFT, 1}, -0.5, "cells", "as if the initial data were 0.5 cells too far down along y"},
        {{FAULT_START_WIDTH, 0}, 1, "cells", "as if the jumps of the initial data were 1 cells further out along x"},
        {{FAULT_INTERFACE, 0}, -0.5, "cells", "as if the interface were 0.5 cells too far down"},
        {{FAULT_AMPLITUDE, 0},
         0.5,
         "%",
         "as if all temperatures were 0.5 % too large, or heat were gained everywhere"},
        {{FAULT_AMPLITUDE, 0}, -1, "%", "as if all temperatures were 1 % too small, or heat were lost everywhere"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct diagnosis d = {.named = 1, .fault = rows[i].fault, .size = rows[i].size, .unit = rows[i].unit};
        wording_fault(&d);
        assert_string_equal(d.what, rows[i].says);
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
    d.share = 0.5, d.named = 0;
    wording_text(&d, text, sizeof text);
    assert_string_equal(text, "as if late");
}

/* ---- Headlines ---- */

static const struct diagnosis none = {.unit = NULL};

static struct diagnosis of(enum fault_kind kind, int axis, double size, const char *unit) {
    return (struct diagnosis){.named = 1, .fault = {kind, axis}, .size = size, .unit = unit, .share = 0.95};
}

static void headline_is(const struct diagnosis *found, int failing, const char *wanted) {
    char text[HEADLINE_TEXT];
    struct headline h = headline_choose(found, failing);
    headline_print(&h, text);
    assert_string_equal(text, wanted);
}

static void headlines_need_half_of_the_rows_and_sizes_that_agree(void **state) {
    (void)state;
    const struct diagnosis k1 = of(FAULT_CONDUCTIVITY, 0, 1.06, "%"), k2 = of(FAULT_CONDUCTIVITY, 0, 0.9, "%"),
                           tiny = of(FAULT_CONDUCTIVITY, 0, 0.00111, "%"),
                           huge = of(FAULT_CONDUCTIVITY, 0, 1590, "%"), more = of(FAULT_CONDUCTIVITY, 0, 4120, "%"),
                           late = of(FAULT_CLOCK, 0, 1, "steps"), s = of(FAULT_CLOCK, 0, 1, "s"),
                           yx = of(FAULT_ISOTROPIC, 1, 100, ""), xy = of(FAULT_ISOTROPIC, 0, 100, "");
    headline_is((const struct diagnosis[]){k1, k2}, 2,
                "as if the conductivity were 0.9 % too large (2 of 2 rows that do not pass)");
    headline_is((const struct diagnosis[]){none, k1, late, k2}, 4,
                "as if the conductivity were 0.9 % too large (2 of 4 rows that do not pass)");
    headline_is((const struct diagnosis[]){none, k1, late, k2, none}, 5,
                "perhaps as if the conductivity were 0.9 % too large (2 of 5 rows that do not pass)");
    headline_is((const struct diagnosis[]){k1, tiny}, 2, "");
    headline_is((const struct diagnosis[]){huge, more, k1}, 3, "");
    headline_is((const struct diagnosis[]){late, s}, 2, "");
    headline_is((const struct diagnosis[]){late}, 1,
                "perhaps as if the run had stopped 1 step late (1 of 1 rows that do not pass)");
    headline_is((const struct diagnosis[]){yx, xy, yx}, 3, "as if k_y were k_x (2 of 3 rows that do not pass)");
    const struct diagnosis some = of(FAULT_SOME_STEPS, 0, 1, "steps");
    headline_is(
        (const struct diagnosis[]){late, some, none}, 3,
        "as if runs at some spacings had stopped one step late: `while (t < t_end)` with a sum of rounded steps "
        "does so (2 of 3 rows that do not pass)");
    headline_is(&none, 1, "");
    headline_is(&none, 0, "");
}

/* A conductivity and the length of a step have one effect where nothing but conduction changes T: the headline says
 * both, unless a row with a source or an air votes for the conductivity. */
static void headlines_say_both_of_two_faults_with_one_effect(void **state) {
    (void)state;
    struct diagnosis pace = of(FAULT_CONDUCTIVITY, 0, 50, "%"), k = pace;
    pace.is_pace = 1;
    headline_is(
        (const struct diagnosis[]){pace, pace, none}, 3,
        "as if the conductivity, or the length of each step, were 50 % too large (2 of 3 rows that do not pass)");
    headline_is((const struct diagnosis[]){pace, k, pace}, 3,
                "as if the conductivity were 50 % too large (3 of 3 rows that do not pass)");
}

/* A draw mirrors rods and turns planes: sides that differ are one fault; noise has a size in each field. */
static void headlines_join_sides(void **state) {
    (void)state;
    const struct diagnosis lo = of(FAULT_COEFFICIENT, 0, -49.9, "%"), all = of(FAULT_COEFFICIENT, 4, -50.1, "%"),
                           hi = of(FAULT_COEFFICIENT, 1, -50, "%"), x = of(FAULT_EXTENT, 0, 0.49, "cells"),
                           both = of(FAULT_EXTENT, 2, 0.5, "cells"), noisy = of(FAULT_NOISE, 0, 0.2, "K"),
                           less = of(FAULT_NOISE, 0, 0.01, "K"), arithmetic = of(FAULT_MEAN, 0, 1, "cells"),
                           other = of(FAULT_MEAN, 3, 0.6, "cells");
    headline_is((const struct diagnosis[]){lo, all, hi}, 3,
                "as if the heat transfer coefficients were 50 % too small (3 of 3 rows that do not pass)");
    headline_is(
        (const struct diagnosis[]){hi, hi}, 2,
        "as if the heat transfer coefficient of side x_hi were 50 % too small (2 of 2 rows that do not pass)");
    headline_is((const struct diagnosis[]){x, x}, 2,
                "as if the sides across x were 0.49 cells further out (2 of 2 rows that do not pass)");
    headline_is((const struct diagnosis[]){x, both}, 2,
                "as if the sides were 0.49 cells further out (2 of 2 rows that do not pass)");
    headline_is(
        (const struct diagnosis[]){noisy, less}, 2,
        "answers differ by 0.01 K from run to run: random numbers, threads or an unset variable (2 of 2 rows that "
        "do not pass)");
    headline_is((const struct diagnosis[]){arithmetic, other, arithmetic}, 3,
                "as if another mean of two conductivities stood for the harmonic one (3 of 3 rows that do not pass)");
}

/* A row that passes refutes a fault that alone would leave twice its ceiling, if the row has walls of that kind. */
static void rows_that_pass_refute_a_headline(void **state) {
    (void)state;
    struct problem p = problem_of("rod-cosine"); /* insulated */
    struct diagnosis found[2] = {of(FAULT_CONDUCTIVITY, 0, 5, "%"), of(FAULT_CONDUCTIVITY, 0, 5, "%")};
    struct headline h = headline_choose(found, 2);
    double effect = diagnosis_effect(&p, &h.fault, 0.05, 0);
    assert_int_equal(headline_contradicts(&h, &p, 0.05, 0, 0.49 * effect), 1);
    assert_int_equal(headline_contradicts(&h, &p, 0.05, 0, 0.51 * effect), 0);
    struct problem law = problem_of("wall-kirchhoff"); /* k of its own */
    assert_int_equal(headline_contradicts(&h, &law, 0.05, 0, 1e-9), 0);
    for (int k = 0; k < 2; k++) {
        found[0] = of(FAULT_EXTENT, 0, 0.5, "cells");
        found[0].sides = k ? 1u << DIRICHLET : 1u << NEUMANN;
        h = headline_choose(found, 1);
        assert_int_equal(headline_contradicts(&h, &p, 0.05, 0, 1e-6), k == 0);
    }
    struct problem box = problem_of("rect-manufactured"); /* held across x, fluxes across y */
    for (int side = X_LO; side <= Y_LO; side += Y_LO) {
        found[0] = of(FAULT_WALL, side, -100, "%");
        found[0].sides = 1u << DIRICHLET;
        h = headline_choose(found, 1);
        assert_int_equal(headline_contradicts(&h, &box, 0.05, 0, 1e-6), side == X_LO);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_have_sentences),
        cmocka_unit_test(sentences_end_with_the_share),
        cmocka_unit_test(headlines_need_half_of_the_rows_and_sizes_that_agree),
        cmocka_unit_test(headlines_say_both_of_two_faults_with_one_effect),
        cmocka_unit_test(headlines_join_sides),
        cmocka_unit_test(rows_that_pass_refute_a_headline),
    };
    return cmocka_run_group_tests_name("headline", tests, NULL, NULL);
}
