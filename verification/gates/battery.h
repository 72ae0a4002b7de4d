/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_BATTERY_H
#define HEATLADDER_VERIFICATION_GATES_BATTERY_H

/* The battery: gates for a code that nobody here wrote, of order 1, 2 or 4 in space. */

#include "verification/command/request.h"
#include "verification/gates/draw.h"
#include "verification/gates/gates.h"

/* The row for a code of a given order. */
struct battery_row {
    int order; /* 1, 2 or 4 */
    struct gate gate;
    enum draw_bound bound;
    const char *ranges; /* of what a seed draws (draw.h) */
};

extern const struct battery_row battery_table[]; /* ended by a NULL id */

/* Adds the rows for that order and profile to *g, drawn by the seed (0: as they are written). */
int battery_add(int order, enum profile profile, unsigned long seed, struct gates *g, struct failure *why);

/* Appends the words of `verify` that choose among these rows, as *r has them: " --profile P --rungs N". */
void battery_words(const struct request *r, char *text, size_t size);

/* Sets the bounds of the rows in *g, all of that order, to those of what was drawn: some need a run of the five-point
 * difference. */
int battery_bounds(int order, struct gates *g, struct failure *why);

/* Writes the case of every rung of every row in *g: DIR/SCENE/SETTING/DX/case, and DIR/cases.txt (results.h).
 * With seeds > 1 each rung of a ladder in space is written as often, as DX/seed=1/case and so on.  What rows share is
 * written once.  *cases: those that cases.txt names then.  STATUS_OK or STATUS_INPUT with *why. */
int battery_write(const struct gates *g, int seeds, const char *dir, int *cases, struct failure *why);

#endif
