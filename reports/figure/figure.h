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
    FIGURE_CLOUD,     /* `run`: x,y,T of the plane, in any order */
    FIGURE_ERROR,     /* `run`: x,y,|T - T_exact|; in space of the layer nearest to z = at, by rows */
    FIGURE_ROWS,      /* a row a value, of keys of the command's JSON (reading.h) */
};

struct figure_series {
    const char *name; /* NULL ends the list */
    const char *command;
    enum figure_part part;
    double at;                                 /* m */
    const char *columns, *keys, *const *value; /* FIGURE_ROWS: header, blank-separated keys; %s of the command is one
                                                  value after the other, ended by NULL */
};

/* Rows of the table of series: of a field, and of readings; {0} ends it. */
#define FIGURE_FIELD(name, command, part, at)                                                                        \
    { name, command, part, at, NULL, NULL, NULL }
#define FIGURE_READ(name, command, columns, keys, values)                                                            \
    { name, command, FIGURE_ROWS, 0, columns, keys, values }

struct figure {
    const char *name; /* name of the file, without .csv; NULL ends a list */
    const char *title;
    const struct figure_series *series;
};

/* The first lines of a data file: its title, how to make it again, and a command that gives a number of it.  More
 * lines "# command: ..." may follow. */
void figure_head(FILE *out, const char *title, const char *command, ...) __attribute__((format(printf, 3, 4)));

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

/* The same for each of a list. */
int figure_write_all(const struct figure *figures, const char *dir, struct failure *why);

/* The head of a block: its name (printf-like) and its columns. */
void figure_block(FILE *out, const char *columns, const char *name, ...) __attribute__((format(printf, 3, 4)));

#endif
