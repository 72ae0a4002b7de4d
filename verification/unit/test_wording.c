/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a fault is called, by its kind, axis, size and unit. */
#include "verification/diagnosis/wording.h"

#include "verification/diagnosis/diagnosis.h"

#include "verification/unit/near.h"

#include <math.h>
#include <string.h>

static void faults_have_their_words(void **state) {
    (void)state;
    static const struct {
        struct fault fault;
        double size;
        const char *unit, *says;
    } rows[] = {
        {{FAULT_CLOCK, 0}, -0.98765, "steps", "the run had stopped 0.988 steps early"},
        {{FAULT_CLOCK, 0}, 2, "s", "the run had stopped 2 s late"},
        {{FAULT_CLOCK, 0},
         0.25,
         "dx^2/kappa",
         "the run had stopped 0.25 dx^2/kappa late: one step, if steps are of that length"},
        {{FAULT_CONDUCTIVITY, 0}, -12.5, "%", "the conductivity were 12.5 % too small"},
        {{FAULT_ISOTROPIC, 0}, 100, "", "k_x were k_y"},
        {{FAULT_ISOTROPIC, 1}, 100, "", "k_y were k_x"},
        {{FAULT_AXIS, 1}, 3, "%", "k_y were 3 % too large"},
        {{FAULT_RHO_C, 0}, 3, "%", "rho c of the first material were 3 % too large"},
        {{FAULT_RHO_C, 1}, -3, "%", "rho c of the second material were 3 % too small"},
        {{FAULT_COEFFICIENT, 2}, 5, "%", "the heat transfer coefficient of side y_lo were 5 % too large"},
        {{FAULT_COEFFICIENT, FAULT_ALL_SIDES}, 5, "%", "the heat transfer coefficients were 5 % too large"},
        {{FAULT_SOURCE, 0}, 7, "%", "the source were 7 % too large"},
        {{FAULT_SOURCE, 0}, 400, "%", "the source were 400 % too large"},
        {{FAULT_SOURCE, 0}, -95.1, "%", "the source were lost"},
        {{FAULT_SOURCE, 0}, -191, "%", "the source had the wrong sign"},
        {{FAULT_SOURCE_TIME, 0}, -1, "steps", "the source were that of 1 steps earlier"},
        {{FAULT_WALL, 3}, -94.9, "%", "what side y_hi holds were 94.9 % too small"},
        {{FAULT_WALL, 3}, -104.9, "%", "what side y_hi holds were lost"},
        {{FAULT_WALL, 0}, -190.5, "%", "what side x_lo holds had the wrong sign"},
        {{FAULT_WALL, 0}, -189, "%", "what side x_lo holds were 189 % too small"},
        {{FAULT_WALL, 1}, 299, "%", "what side x_hi holds were 299 % too large"},
        {{FAULT_WALL, 1}, 301, "%", "what side x_hi holds were another value"},
        {{FAULT_WALL, FAULT_ALL_SIDES}, 5, "%", "what sides of given flux hold were 5 % too large"},
        {{FAULT_CORNER, 1}, 100, "%", "100 % of what sides hold were lost at a corner, x_hi, y_lo"},
        {{FAULT_EXTENT, 1}, -0.5, "cells", "the sides across y lay 0.5 cells inside"},
        {{FAULT_EXTENT, FAULT_BOTH_AXES}, 0.5, "cells", "the sides across x and y lay 0.5 cells outside"},
        {{FAULT_START_SHIFT, 1}, -0.5, "cells", "the initial data lay 0.5 cells too far down along y"},
        {{FAULT_START_WIDTH, 0}, 1, "cells", "the jumps of the initial data lay 1 cells outwards along x"},
        {{FAULT_INTERFACE, 0}, -0.5, "cells", "the interface lay 0.5 cells too far down"},
        {{FAULT_AMPLITUDE, 0}, 0.5, "%", "all temperatures were 0.5 % too large"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct diagnosis d = {.named = 1, .fault = rows[i].fault, .size = rows[i].size, .unit = rows[i].unit};
        wording_fault(&d);
        assert_int_equal(strncmp(d.what, "as if ", 6), 0);
        assert_string_equal(d.what + 6, rows[i].says);
    }
}

static void a_share_stands_beside_what_is_named(void **state) {
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_have_their_words),
        cmocka_unit_test(a_share_stands_beside_what_is_named),
    };
    return cmocka_run_group_tests_name("wording", tests, NULL, NULL);
}
