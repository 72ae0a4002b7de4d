/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIGURE_FIGURE_H
#define HEATLADDER_REPORTS_FIGURE_FIGURE_H

/* The data of a figure: one file, one block a curve, so that a plot draws and never computes.  A block is
 *
 *     # NAME
 *     # heatladder ...
 *     header, rows, two blank lines        (gnuplot: plot FILE index "NAME") */

#include <stddef.h>
#include <stdio.h>

struct failure;

enum figure_part {
    FIGURE_POINTS,    /* `run`: x,T of a rod */
    FIGURE_START,     /* `run`: the initial data at its points; x,T or x,y,T by rows */
    FIGURE_CUT,       /* `run`: x,T along y = at */
    FIGURE_EXACT,     /* `reference`: x,T finely, of a rod or along the y of --at */
    FIGURE_ISOTHERMS, /* `run`: isotherms, those of the exact solution, where to write their levels; and E in % */
};

struct figure_series {
    const char *name; /* NULL ends the list */
    const char *command;
    enum figure_part part;
    double at; /* m */
};

struct figure {
    const char *name; /* of the file, without .csv; NULL ends a list */
    const char *title;
    const struct figure_series *series; /* at most 10 */
    double level[3];                    /* K: first isotherm, step, last */
};

/* The first lines of a data file: its title, and how to make it again.  "# command: ..." lines may follow. */
void figure_head(FILE *out, const char *title);

/* A data file that is made by one function: `write` fills it, STATUS_OK or *why. */
struct figure_page {
    const char *name; /* of the file, without .csv */
    int (*write)(FILE *out, struct failure *why);
};

/* Each in turn, put in its place as it is done; names and times go to standard output. */
int figure_pages(const struct figure_page *pages, size_t count, const char *dir, struct failure *why);

/* Runs the commands of the series in parallel and puts NAME.csv into `dir`: STATUS_OK, or *why of a run or the file.
 */
int figure_write(const struct figure *figure, const char *dir, struct failure *why);

/* Isotherms of temperatures on a lattice, as lines that can be drawn. */

struct isotherm_grid {
    int n[2];           /* points along x and y, x fastest */
    double lo[2], d[2]; /* m */
    double *T;          /* K, n[0] n[1] */
};

/* Writes x,y,level rows, each line of the level followed by a blank line.  `at` gets the point at that part
 * (0 to 1) of the longest line, m.  Returns how many lines there are. */
int isotherm_trace(const struct isotherm_grid *g, double level, double part, FILE *out, double at[2]);

/* The same temperatures `times` as finely, by a bicubic spline (GSL).  The caller frees T. */
struct isotherm_grid isotherm_refine(const struct isotherm_grid *g, int times);

#endif
