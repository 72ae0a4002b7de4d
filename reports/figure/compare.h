/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIGURE_COMPARE_H
#define HEATLADDER_REPORTS_FIGURE_COMPARE_H

/* A published table of errors over dx, measured again: CSV and Markdown beside the published numbers, the data of its
 * convergence figure, and what the choices that the paper leaves open would change. */

struct failure;

struct compare_choice {
    const char *label;   /* NULL ends the list; the first one is the paper's protocol */
    const char *options; /* beside --dx, as a user would type them */
    int decimals;        /* that the solution compared with is rounded to; 0: it is not */
    double late;         /* s: that solution is taken so much after the end of the run */
};

struct compare {
    const char *table, *table_title;   /* file, also of reports/published; without its ending */
    const char *figure, *figure_title; /* likewise */
    const char *scene;
    const struct compare_choice *choice; /* at most 10 */
    const char *note;                    /* Markdown: where a digit differs, why */
};

/* Runs every choice and puts the three files into `dir`, all or none: STATUS_OK, or *why of a run or a file. */
int compare_write(const struct compare *c, const char *dir, struct failure *why);

#endif
