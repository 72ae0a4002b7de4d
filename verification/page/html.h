/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_PAGE_HTML_H
#define HEATLADDER_VERIFICATION_PAGE_HTML_H

/* HTML that needs no network, no script and no file beside it: readable on a phone, on paper, in dark and light. */

#include <stdio.h>

struct table;

void html_open(FILE *out, const char *title); /* up to the open <main> */
void html_close(FILE *out);

/* The characters of HTML and XML escaped, control characters as blanks; of the first `size` bytes, or of all. */
void html_bytes(FILE *out, const char *text, size_t size);
void html_text(FILE *out, const char *text);
/* As printf with no conversion but %s, each of them by html_text. */
void html_print(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A cell <td>; numbers are set right.  */
void html_cell(FILE *out, const char *text);
/* The table, freed; a header is set as the last cell of its column.  narrow: no wider than its cells. */
void html_table(FILE *out, struct table *t, int narrow);

/* The word of a verdict with its sign, so that it reads without colour: pass, fail, inconclusive, ... */
void html_verdict(FILE *out, const char *word);

/* A command, which is typed after the program's name, in a box: its lines break at blanks, not at hyphens. */
void html_command(FILE *out, const char *command);

/* The file at `path` (SVG) as an image within the page; 0, or -1 where it cannot be read. */
int html_image(FILE *out, const char *path, const char *alternative);

#endif
