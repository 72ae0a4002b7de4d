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
    FIGURE_CUT,       /* `run`: x,T along y = at */
    FIGURE_EXACT,     /* `reference`: x,T finely, of a rod or along the y of --at */
    FIGURE_ISOTHERMS, /* `run`: x,y,T by rows, of the particles and of the exact solution; and E in % */
};

struct figure_series {
    const char *name; /* NULL ends the list */
    const char *command;
    enum figure_part part;
    double at; /* m */
};

struct figure {
    const char *name; /* name of the file, without .csv; NULL ends a list */
    const char *title;
    const struct figure_series *series; /* at most 10 */
};

/* The first lines of a data file: its title, and how to make it again.  "# command: ..." lines may follow. */
void figure_head(FILE *out, const char *title);

/* A data file that is made by one function: `write` fills it, STATUS_OK or *why. */
struct figure_page {
    const char *name; /* name of the file, without .csv */
    int (*write)(FILE *out, struct failure *why);
};

/* Each in turn, put in its place as it is done; names and times go to standard output. */
int figure_pages(const struct figure_page *pages, size_t count, const char *dir, struct failure *why);

/* Runs the commands of the series in parallel and puts NAME.csv into `dir`: STATUS_OK, or *why of a run or the file.
 */
int figure_write(const struct figure *figure, const char *dir, struct failure *why);

#endif
