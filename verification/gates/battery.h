/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_BATTERY_H
#define HEATLADDER_VERIFICATION_GATES_BATTERY_H

/* The battery: gates for a code that nobody here wrote, of order 1, 2 or 4 in space. */

#include "verification/gates/gates.h"

/* Codes that can have other rows: all but slab/..., periodic/... alone for particles without walls, all for codes in
 * three dimensions. */
enum profile { PROFILE_ALL, PROFILE_PARTICLES, PROFILE_SLABS };
extern const char *const battery_profile_words[]; /* ended by NULL */

/* ---- Draws ---- */

/* The battery cannot be learnt by heart: a seed draws the parameters of a row within its ranges, one of the images of
 * its scene (references/mapping.h), a scale and, where the row has a range of it, an offset of the temperature.  The
 * row's bound follows the draw. */

/* Where the bound of a row comes from: its ceiling, or the upper bound of a measure that is a single error. */
enum draw_bound {
    AS_WRITTEN,       /* holds for all that is drawn: no parameter changes what it comes from */
    FIVE_POINT,       /* 4 times the error of the five-point difference at the finest spacing, in the row's norm */
    MEAN_OF_CELL,     /* the mean over a cell, dx^2/24 laplace(T), and FIVE_POINT */
    CELL_AWAY,        /* all of the field a whole cell away: dx times the mean of |T_x| + |T_y| over that of |T| */
    SLOPE_OF_ELEMENT, /* dx/2 |T_xx / T_x| at the high end of a rod: an element's gradient */
};

/* ranges: words with blanks between: NAME=LO:HI of the scene's parameters, offset=LO:HI in K of the scene, and
 * `cross`: the image is the one of the scene's other rows with x and y exchanged and both turned round (of a rod:
 * turned round), so that one draw has all that it must see on either hand. */
struct draw {
    const char *command, *ranges; /* as written in the row */
    enum draw_bound bound;
    const char *measure;
};

enum { DRAW_COMMAND = 1024 };

/* Of the scene that the command of another program is about: 1 or 2; 0 with *why where it cannot be read. */
int draw_dimension(const char *command, struct failure *why);

/* The command with its drawn words; rows of the same scene and ranges draw the same.  Seed 0: as it is written. */
int draw_command(const struct draw *d, unsigned long seed, char command[DRAW_COMMAND], struct failure *why);

/* *bound for that command; untouched where it is AS_WRITTEN. */
int draw_bound(const struct draw *d, const char *command, double *bound, struct failure *why);

/* ---- Rows ---- */

/* The row for a code of a given order. */
struct battery_row {
    int order; /* 1, 2 or 4 */
    struct gate gate;
    enum draw_bound bound;
    const char *ranges; /* of what a seed draws */
};

extern const struct battery_row battery_table[]; /* ended by a NULL id */

/* Adds the rows for that order and profile to *g, drawn by the seed (0: as they are written). */
int battery_add(int order, enum profile profile, unsigned long seed, struct gates *g, struct failure *why);

/* Appends the words of `verify` that choose among these rows: " --profile P --rungs N". */
void battery_words(enum profile profile, int rungs, char *text, size_t size);

/* Sets the bounds of the rows in *g, all of that order, to those of what was drawn: some need a run of the five-point
 * difference. */
int battery_bounds(int order, struct gates *g, struct failure *why);

/* Writes the case of every rung of every row in *g: DIR/SCENE/SETTING/DX/case, and DIR/cases.txt (results.h).
 * With seeds > 1 each rung of a ladder in space is written as often, as DX/seed=1/case and so on.  What rows share is
 * written once.  *cases: those that cases.txt names then.  STATUS_OK or STATUS_INPUT with *why. */
int battery_write(const struct gates *g, int seeds, const char *dir, int *cases, struct failure *why);

#endif
