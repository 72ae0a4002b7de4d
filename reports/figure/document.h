/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIGURE_DOCUMENT_H
#define HEATLADDER_REPORTS_FIGURE_DOCUMENT_H

/* Headings, paragraphs and tables, written as Markdown and as HTML at once: NAME.md for a terminal, NAME.html for the
 * page.  In texts `code` is marked by backticks. */

#include "verification/text/output.h"
#include "verification/text/table.h"

struct document {
    struct output page[2]; /* Markdown, HTML */
    FILE *md, *html;
};

void document_open(struct document *d, const char *dir, const char *name, const char *title);
/* Puts both files in their places: a status of solver/status.h. */
int document_close(struct document *d, struct failure *why);
void document_drop(struct document *d);

void document_heading(struct document *d, const char *format, ...) __attribute__((format(printf, 2, 3)));
void document_text(struct document *d, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* A command without the program's name. */
void document_command(struct document *d, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Writes the table and frees it. */
void document_table(struct document *d, struct table *t);

#endif
