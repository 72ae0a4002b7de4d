/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks of a scene's parameters.  Each refusal is one sentence with the option, its value and the valid range. */
#include "references/params.h"

#include "solver/status.h"

#include <math.h>
#include <string.h>

/* with_both: "from" lo to hi, bounds included; else "between" them. */
static int outside(const struct param *table, const struct problem *p, int i, double lo, double hi, int with_both,
                   const char *because, struct failure *why) {
    const char *name = table[i].name, *unit = table[i].unit, *gap = *table[i].unit ? " " : "";
    const char *colon = because ? ": " : "", *reason = because ? because : "";
    double value = p->param[i];
    if (isinf(lo) && isinf(hi)) return refuse(why, STATUS_INPUT, "--set %s=%g: needs a finite number", name, value);
    if (isinf(hi))
        return refuse(why, STATUS_INPUT, "--set %s=%g: needs a finite number greater than %g%s%s%s%s", name, value,
                      lo, gap, unit, colon, reason);
    if (with_both)
        return refuse(why, STATUS_INPUT, "--set %s=%g: needs a number from %g to %g%s%s%s%s", name, value, lo, hi,
                      gap, unit, colon, reason);
    return refuse(why, STATUS_INPUT, "--set %s=%g: needs a number between %g and %g%s%s, both excluded%s%s", name,
                  value, lo, hi, gap, unit, colon, reason);
}

int params_between(const struct param *table, const struct problem *p, int i, double lo, double hi,
                   const char *because, struct failure *why) {
    double value = p->param[i];
    return isfinite(value) && lo < value && value < hi ? STATUS_OK : outside(table, p, i, lo, hi, 0, because, why);
}

int params_within(const struct param *table, const struct problem *p, int i, double lo, double hi,
                  const char *because, struct failure *why) {
    const double rounding = 1e-9 * hi;
    int within = p->param[i] >= lo - rounding && p->param[i] <= hi + rounding;
    return within ? STATUS_OK : outside(table, p, i, lo, hi, 1, because, why);
}

static int is_among(const int *list, int i) {
    while (list && *list >= 0 && *list != i) list++;
    return list && *list == i;
}

int params_start(const struct param *table, struct problem *p, const int *any, struct failure *why) {
    double kept[PARAM_MAX];
    memcpy(kept, p->param, sizeof kept);
    *p = (struct problem){.initial = problem_start, .wall = problem_held};
    memcpy(p->param, kept, sizeof kept);
    for (int i = 0; table[i].name; i++) {
        if (params_between(table, p, i, is_among(any, i) ? -INFINITY : 0, INFINITY, NULL, why)) return STATUS_INPUT;
        p->t_end = p->param[i]; /* the last one is the end time */
    }
    return STATUS_OK;
}

void params_material(struct problem *p, double k_x, double k_y, double rho_c) {
    p->material[p->materials++] = (struct material){{k_x, k_y}, rho_c};
}

int params_whole(const struct param *table, const struct problem *p, int i, int lo, int hi, struct failure *why) {
    double value = p->param[i];
    if (lo <= value && value <= hi && value == floor(value)) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--set %s=%g: needs a whole number from %d to %d", table[i].name, value, lo, hi);
}
