/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sentences for faults, from the texts of fault.def. */
#include "verification/fault/wording.h"

#include "solver/words.h"
#include "verification/fault/diagnosis.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Sentences for several of k, rho c and the end time, the first of them with the size. */
static const char *text_of_several(unsigned paces) {
    static const char *const text[] = {
        [PACE_CONDUCTIVITY | PACE_CAPACITY] = "as if the diffusivity, k/rho c, were {size} % too {way}",
        [PACE_CONDUCTIVITY | PACE_END] = "as if the conductivity, or the end time, were {size} % too {way}",
        [PACE_CAPACITY | PACE_END] = "as if rho c were {size} % too {way}, or the end time {inverse} % too {back}",
        [PACE_CONDUCTIVITY | PACE_CAPACITY | PACE_END] =
            "as if the diffusivity, k/rho c, or the end time were {size} % too {way}"};
    return paces < sizeof text / sizeof *text ? text[paces] : NULL;
}

static const char *text_of(const struct diagnosis *d) {
    const struct fault_row *row = &fault_rows[d->fault.kind];
    if (text_of_several(d->paces)) return text_of_several(d->paces);
    for (int i = 0; i < 4 && row->other[i].text; i++)
        if ((!row->other[i].unit || strcmp(row->other[i].unit, d->unit) == 0) && d->size > row->other[i].from &&
            d->size < row->other[i].to)
            return row->other[i].text;
    return row->text;
}

static const char *place_of(const struct diagnosis *d) {
    const struct fault_places *places = fault_rows[d->fault.kind].places;
    if (!places) return "";
    return d->fault.at < 0 ? places->any : places->name[d->fault.at];
}

void wording_fault(struct diagnosis *d) {
    const struct fault_row *row = &fault_rows[d->fault.kind];
    char size[24], inverse[24]; /* 1/(1 + s) - 1, in % */
    snprintf(inverse, sizeof inverse, "%.3g", fabs(100 * (100 / (100 + d->size) - 1)));
    snprintf(size, sizeof size, d->fault.kind == FAULT_OFFSET ? "%.5g" : "%.3g", fabs(d->size));
    d->what[0] = '\0';
    for (const char *at = text_of(d); *at; at++) {
        const char *part = (const char[]){*at, '\0'};
        if (strncmp(at, "{size}", 6) == 0) part = size;
        if (strncmp(at, "{unit}", 6) == 0)
            part = strcmp(size, "1") == 0 && strcmp(d->unit, "steps") == 0 ? "step" : d->unit;
        if (strncmp(at, "{name}", 6) == 0) part = place_of(d);
        if (strncmp(at, "{way}", 5) == 0)
            part = d->size < 0 ? (row->below ? row->below : "small") : row->above ? row->above : "large";
        if (strncmp(at, "{inverse}", 9) == 0) part = inverse;
        if (strncmp(at, "{back}", 6) == 0) part = d->size < 0 ? "large" : "small";
        words_add(d->what, sizeof d->what, "%s", part);
        if (*at == '{') at += strcspn(at, "}");
    }
}

void wording_text(const struct diagnosis *d, char *text, size_t size) {
    if (d->named && isfinite(d->share))
        snprintf(text, size, "%s (%.0f %% of the error)", d->what, 100 * d->share);
    else
        snprintf(text, size, "%s", d->what);
}
