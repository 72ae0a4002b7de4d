/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_POINTS_TEXT_H
#define HEATLADDER_VERIFICATION_UNIT_POINTS_TEXT_H

/* points_read of a text, which is not empty. */

#include "verification/case/points.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <string.h>

static inline int points_text(const char *text, const struct problem *p, struct points *points, struct failure *why) {
    FILE *in = fmemopen((void *)text, strlen(text), "r");
    assert_non_null(in);
    int status = points_read(in, "points.csv", p, points, why);
    fclose(in);
    return status;
}

#endif
