/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_DRAW_H
#define HEATLADDER_VERIFICATION_GATES_DRAW_H

/* The battery cannot be learnt by heart: a seed draws the parameters of a row within its ranges, one of the images of
 * its scene (references/mapping.h), a scale and, where the row has a range of it, an offset of the temperature.  The
 * row's bound follows the draw. */

struct failure;

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

#endif
