/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIGURE_DOCUMENT_H
#define HEATLADDER_REPORTS_FIGURE_DOCUMENT_H

/* Headings, paragraphs and tables, written as Markdown and as HTML at once: NAME.md for a terminal, NAME.html for the
 * page.  In texts `code` is marked by backticks. */

#include "verification/text/output.h"

struct document {
    struct output page[2]; /* Markdown, HTML */
    FILE *md, *html;
    int columns; /* columns of the open table; 0: none is open */
    int cells;   /* cells in its current row */
    int heading; /* 1: in the row of headers */
};

void document_open(struct document *d, const char *dir, const char *name, const char *title);
/* Puts both files in their places: a status of solver/status.h. */
int document_close(struct document *d, struct failure *why);
void document_drop(struct document *d);

void document_heading(struct document *d, const char *format, ...) __attribute__((format(printf, 2, 3)));
void document_text(struct document *d, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* A command without the program's name. */
void document_command(struct document *d, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A table: its headers "a|b|c", more headers, then cells row by row.  The next heading or text ends it. */
void document_table(struct document *d, const char *headers);
void document_header(struct document *d, const char *format, ...) __attribute__((format(printf, 2, 3)));
void document_cell(struct document *d, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
