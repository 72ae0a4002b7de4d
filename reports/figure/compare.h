/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIGURE_COMPARE_H
#define HEATLADDER_REPORTS_FIGURE_COMPARE_H

/* A published table of errors over dx, measured again: a document beside the published numbers, the data of its
 * convergence figure, and the effect of the choices that the paper leaves open. */

struct failure;

struct compare_choice {
    const char *label;   /* NULL ends the list; the first one is the paper's protocol */
    const char *options; /* beside --dx, as typed */
    int decimals;        /* decimals of the reference solution; 0: all */
    double late;         /* s: that solution is taken so much after the end of the run */
};

struct compare {
    const char *table, *table_title;   /* file, also of reports/published; without its ending */
    const char *figure, *figure_title; /* file without its ending */
    const char *scene;
    const struct compare_choice *choice; /* at most 10 */
    const char *note[6];                 /* paragraphs: the reason where a digit differs; NULL ends them */
};

/* Runs every choice and puts the files into `dir`: STATUS_OK, or *why of a run or a file. */
int compare_write(const struct compare *c, const char *dir, struct failure *why);

#endif
