/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_BATTERY_ROW_H
#define HEATLADDER_VERIFICATION_UNIT_BATTERY_ROW_H

#include "verification/gates/battery.h"

#include "verification/unit/near.h"

/* The rows that match, as they are written, with their bounds; end with gates_free. */
static inline struct gates battery_rows(int order, const char *only) {
    struct gates g = {0};
    struct failure why;
    if (battery_add(order, PROFILE_ALL, 0, &g, &why) || gates_choose(&g, only, NULL, 0, &why) ||
        battery_bounds(&g, &why))
        fail_msg("%s", why.text);
    return g;
}

#endif
