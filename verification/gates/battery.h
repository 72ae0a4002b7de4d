#ifndef HEATLADDER_VERIFICATION_GATES_BATTERY_H
#define HEATLADDER_VERIFICATION_GATES_BATTERY_H

/* The battery: gates for a code that nobody here wrote, of order 1, 2 or 4 in space. */

#include "verification/gates/gates.h"

/* The row for a code of a given order. */
struct battery_row {
    int order; /* 1, 2 or 4 */
    struct gate gate;
};

extern const struct battery_row battery_table[]; /* ended by a NULL id */

/* Adds the rows for that order to *g. */
void battery_add(int order, struct gates *g);

/* Writes the case of every rung of every row in *g: DIR/SCENE/SETTING/DX/case, and DIR/cases.txt (results.h).
 * *written counts them; what rows share is written once.  STATUS_OK or STATUS_INPUT with *why. */
int battery_write(const struct gates *g, const char *dir, int *written, struct failure *why);

#endif
