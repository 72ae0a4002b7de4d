/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_BATTERY_H
#define HEATLADDER_VERIFICATION_GATES_BATTERY_H

/* The battery: gates for external codes of order 1, 2 or 4 in space.
 *
 * A code cannot be tuned to it: a seed draws the parameters of a row within its ranges, one of the images of its
 * scene (references/mapping.h), a scale and, if the row has a range for it, an offset of the temperature.  Bounds
 * are expressions of the drawn values. */

#include "verification/gates/gates.h"

/* Particles without walls have the periodic bodies only: periodic/..., space/smooth. */
enum profile { PROFILE_ALL, PROFILE_PARTICLES };
extern const char *const battery_profile_words[]; /* ended by NULL */

struct battery_row {
    int orders; /* 1, 2 or 4 of the code, or several: 1 | 2 */
    const char *id, *measure;
    const char *run;   /* verb and scene */
    const char *sets;  /* NAME=VALUE of the scene's parameters, blanks between */
    const char *rungs; /* further options */
    const char
        *ranges; /* ranges for random draws: NAME=LO:HI of the scene's parameters, offset=LO:HI in K of the
                    scene, and `cross`: the image is that of the scene's other rows with x and y exchanged and
                    both reversed (a rod: reversed; a box: each axis moved to the next and reversed), so that
                    one draw covers both orientations; `turned`: each axis of a box moved to the one after
                    next, so that three rows of one draw have each wall on each axis; or `opposite`: with each axis
                    reversed alone, so that each corner of the case has opposite corners of the scene in two rows */
    int line;    /* line of battery.def with the row's bounds */
    const char *why;
};

extern const struct battery_row battery_table[]; /* ended by 0 orders */

enum { BATTERY_COMMAND = 1024 };

/* The row's command as drawn, "ladder SCENE mine ..."; rows with the same scene and ranges have the same draw.  Seed
 * 0: as written. */
int battery_command(const struct battery_row *row, unsigned long seed, char command[BATTERY_COMMAND],
                    struct failure *why);

/* Adds the rows for that order and profile to *g, drawn with the seed; their bounds are not evaluated yet. */
int battery_add(int order, enum profile profile, unsigned long seed, struct gates *g, struct failure *why);

/* Evaluates the bounds of all rows in *g; some run the five-point difference. */
int battery_bounds(struct gates *g, struct failure *why);

/* Appends the words of `verify` that choose among these rows: " --profile P --rungs N". */
void battery_words(enum profile profile, int rungs, char *text, size_t size);

/* Writes the case of every rung of every row in *g: DIR/SCENE/SETTING/DX/case, and DIR/cases.txt (results.h).  With
 * seeds > 1 each rung of a ladder in space is written `seeds` times, as DX/seed=1/case and so on.  A case shared by
 * several rows is written once.  *cases: the number of lines of cases.txt.  STATUS_OK or STATUS_INPUT with *why. */
int battery_write(struct gates *g, int seeds, const char *dir, int *cases, struct failure *why);

#endif
