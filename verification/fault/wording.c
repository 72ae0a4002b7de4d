/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sentences for faults, from the texts of fault.def. */
#include "verification/fault/wording.h"

#include "solver/words.h"
#include "verification/fault/diagnosis.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *text_of(const struct diagnosis *d) {
    const struct fault_row *row = &fault_rows[d->fault.kind];
    if (d->is_pace) return "as if the conductivity, or the length of each step, were {size} % too {way}";
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
    char size[24];
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
