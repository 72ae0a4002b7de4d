/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_NEAR_H
#define HEATLADDER_VERIFICATION_UNIT_NEAR_H

/* cmocka, and an assertion on doubles (cmocka's own compares floats). */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* |got - want| <= tolerance; NaN fails. */
#define assert_near(got, want, tolerance) near_(got, want, tolerance, #got, __FILE__, __LINE__)

static inline void near_(double got, double want, double tolerance, const char *what, const char *file, int line) {
    if (fabs(got - want) <= tolerance) return;
    print_error("%s = %.17g, wanted %.17g within %g\n", what, got, want, tolerance);
    _fail(file, line);
}

#endif
