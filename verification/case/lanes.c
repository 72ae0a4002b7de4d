/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The vector width from the environment. */
#include "verification/case/lanes.h"

#include "solver/options.h"

#include <stdlib.h>
#include <string.h>

int lanes_forced(int *lanes, struct failure *why) {
    const char *word = getenv("HEATLADDER_LANES");
    int most = options_lanes_most();
    *lanes = 0;
    if (!word || !*word) return STATUS_OK;
    for (int width = 2; width <= most; width *= 2)
        if (strlen(word) == 1 && *word == '0' + width) *lanes = width;
    if (*lanes) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "HEATLADDER_LANES=%.60s: this machine has vectors of %s", word,
                  most == 8   ? "2, 4 or 8"
                  : most == 4 ? "2 or 4"
                              : "2");
}
