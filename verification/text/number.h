/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_NUMBER_H
#define HEATLADDER_VERIFICATION_TEXT_NUMBER_H

#include <stddef.h>

/* Numbers as people write them on a command line: strict, so that a slip is refused and not half read. */

enum { NUMBERS_MAX = 32 };

struct numbers {
    int count;
    double value[NUMBERS_MAX];
    const char *text; /* as typed; NULL where nobody typed it */
};

/* Reads the whole of `text` as a finite decimal, or as a fraction of two (4/42).  0, or -1 where it is neither. */
int number_read(const char *text, double *value);

/* Reads comma-separated numbers.  Returns their number, at most max; or -1 if one is not a number, there is none, or
 * there are more than max. */
int number_read_list(const char *text, double *values, int max);

/* Sorts `count` values, NUMBERS_MAX at most, in place, the largest first. */
void number_sort_falling(double *values, int count);

/* Reads the whole of `text` as a whole number in [0, max].  0 or -1. */
int number_read_whole(const char *text, long max, long *value);

/* The fewest significant digits that read back as `value` to a relative error `off`; most + 1 where `most` do not.
 * `text`: the last try, as %e. */
enum { NUMBER_PRINTED = 32 };
int number_digits(double value, double off, int most, char text[NUMBER_PRINTED]);

/* Sum of the units of the last printed digit of n values: that of *digits significant ones (%g, %e), the most of any
 * value, or of the most decimals of any (%f), whichever is coarser.  Values are known to within `off`; smaller ones
 * have no digits. */
double number_units(const double *value, size_t n, double off, int *digits);

/* Reads `length` bytes as a decimal in the notation of programs: 1.5, 1.5e-3, 1.5D-3, or 1.2345-110 (Fortran with an
 * exponent of three digits).  Returns 0; 1 for nan or inf in any case, with *value NaN; -1 for anything else. */
int number_read_printed(const char *text, size_t length, double *value);

#endif
