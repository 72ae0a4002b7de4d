/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Temperatures stored or written with few digits.
 *
 * An explicit step that changes T by less than half a unit of its last digit, u |T|, changes nothing.  The run
 * stalls where F times the second difference is that small.  The error of a steady state is therefore up to N^2/8
 * u/F for N cells, N^2 u at F = 1/8.  A larger error has another cause. */
#include "verification/fault/diagnosis.h"

#include "solver/field.h"
#include "verification/fault/wording.h"
#include "verification/text/number.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

/* A few round-off errors of the largest value: temperatures mapped back to the scene (references/mapping.h) have
 * them. */
static const double CLOSE = 16 * DBL_EPSILON;

int diagnosis_rounding(const struct field *f, double error, double cells, struct diagnosis *d) {
    enum { MOST = 9, LEAST = 10 }; /* digits; and the number of values that cannot be round by chance */
    int digits = 0, full = 0;
    const double off = CLOSE * field_largest(f);
    char text[NUMBER_PRINTED];
    for (size_t i = 0; i < f->n && digits <= MOST; i++) {
        double T = f->T[i];
        int single = fabs(T - (float)T) <= off;
        int of = number_digits(T, T == 0 ? 0 : off / fabs(T), MOST, text);
        if (single && of > FLT_DIG + 1) of = FLT_DIG + 1;
        full += of >= FLT_DIG;
        digits = of > digits ? of : digits;
    }
    double unit = 0.5 * pow(10, 1 - digits);
    if (digits > MOST || full < LEAST || !(error <= cells * cells * unit)) return 0;
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_DIGITS, 0}, .size = digits, .unit = "digits", .share = NAN};
    wording_fault(d);
    return 1;
}
