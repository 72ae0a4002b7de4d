/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_NEAR_H
#define HEATLADDER_VERIFICATION_UNIT_NEAR_H

/* cmocka, and assertions that print their arguments: on doubles (cmocka's own compares floats) and on texts. */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* The subject of the assertions, such as a scene: named by one that fails; NULL: none. */
static const char *near_about;

static inline void near_failed(const char *file, int line) {
    if (near_about) print_error("%s:\n", near_about);
    _fail(file, line);
}

/* |got - want| <= tolerance; NaN fails. */
#define assert_near(got, want, tolerance) near_(got, want, tolerance, #got, __FILE__, __LINE__)

static inline void near_(double got, double want, double tolerance, const char *what, const char *file, int line) {
    if (fabs(got - want) <= tolerance) return;
    print_error("%s = %.17g, wanted %.17g within %g\n", what, got, want, tolerance);
    near_failed(file, line);
}

/* got < limit, or whatever `relation` says; NaN fails. */
#define assert_order(got, relation, limit)                                                                           \
    do {                                                                                                             \
        const double got_ = (double)(got), limit_ = (double)(limit);                                                 \
        if (got_ relation limit_) break;                                                                             \
        print_error("%s %s %s: %.17g and %.17g\n", #got, #relation, #limit, got_, limit_);                           \
        near_failed(__FILE__, __LINE__);                                                                             \
    } while (0)

#define assert_nan(got) nan_(got, #got, __FILE__, __LINE__)

static inline void nan_(double got, const char *what, const char *file, int line) {
    if (isnan(got)) return;
    print_error("%s = %.17g, wanted NaN\n", what, got);
    near_failed(file, line);
}

/* `part` occurs in `text`, or it does not. */
#define assert_has(text, part) has_(text, part, 1, __FILE__, __LINE__)
#define assert_lacks(text, part) has_(text, part, 0, __FILE__, __LINE__)

static inline void has_(const char *text, const char *part, int wanted, const char *file, int line) {
    if ((strstr(text, part) != NULL) == wanted) return;
    print_error("'%s' is %s:\n%s\n", part, wanted ? "not in" : "in", text);
    near_failed(file, line);
}

#endif
