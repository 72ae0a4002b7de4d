/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a judgement can be. */
#include "verification/text/verdict.h"

#include <math.h>
#include <stddef.h>

const char *const verdict_words[] = {"inconclusive", "fail", "pass", "measured", "skipped", NULL};

enum verdict verdict_within(double x, double lo, double hi) {
    return isfinite(x) && lo <= x && x <= hi ? VERDICT_PASS : VERDICT_FAIL;
}
