/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks of a scene's parameters: one sentence a refusal, which names the option, the value and what is valid. */
#include "references/params.h"

#include "solver/status.h"

#include <math.h>
#include <string.h>

void params_keep(struct problem *p) {
    double kept[PARAM_MAX];
    memcpy(kept, p->param, sizeof kept);
    *p = (struct problem){0};
    memcpy(p->param, kept, sizeof kept);
}

int params_between(const struct param *table, const struct problem *p, int i, double lo, double hi,
                   const char *because, struct failure *why) {
    const char *name = table[i].name, *unit = table[i].unit, *gap = *table[i].unit ? " " : "";
    const char *colon = because ? ": " : "", *reason = because ? because : "";
    double value = p->param[i];
    if (isfinite(value) && lo < value && value < hi) return STATUS_OK;
    if (isinf(lo) && isinf(hi)) return refuse(why, STATUS_INPUT, "--set %s=%g: needs a finite number", name, value);
    if (isinf(hi))
        return refuse(why, STATUS_INPUT, "--set %s=%g: needs a finite number greater than %g%s%s%s%s", name, value,
                      lo, gap, unit, colon, reason);
    return refuse(why, STATUS_INPUT, "--set %s=%g: needs a number between %g and %g%s%s, both excluded%s%s", name,
                  value, lo, hi, gap, unit, colon, reason);
}

int params_all_positive(const struct param *table, const struct problem *p, const int *list, struct failure *why) {
    for (; *list >= 0; list++)
        if (params_between(table, p, *list, 0, INFINITY, NULL, why)) return STATUS_INPUT;
    return STATUS_OK;
}

int params_finite(const struct param *table, const struct problem *p, int i, struct failure *why) {
    return params_between(table, p, i, -INFINITY, INFINITY, NULL, why);
}

int params_whole(const struct param *table, const struct problem *p, int i, int lo, int hi, struct failure *why) {
    double value = p->param[i];
    if (lo <= value && value <= hi && value == floor(value)) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--set %s=%g: needs a whole number from %d to %d", table[i].name, value, lo, hi);
}
