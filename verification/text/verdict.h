/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_VERDICT_H
#define HEATLADDER_VERIFICATION_TEXT_VERDICT_H

#include <stdio.h>

enum verdict {
    VERDICT_INCONCLUSIVE, /* zero, so that an unset verdict does not pass */
    VERDICT_FAIL,
    VERDICT_PASS,
    VERDICT_MEASURED, /* there was no band to judge by */
    VERDICT_SKIPPED   /* not applicable, by its own word */
};

extern const char *const verdict_words[]; /* in the order of the enum, ended by NULL */

/* Pass where x is finite and lo <= x <= hi, else fail: NaN fails. */
enum verdict verdict_within(double x, double lo, double hi);

/* The escape sequence that colours a verdict's word, "" for any other word, off a terminal, and with NO_COLOR. */
const char *verdict_colour(FILE *out, const char *word);
const char *verdict_colour_end(FILE *out, const char *word);

#endif
