/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_HTML_H
#define HEATLADDER_VERIFICATION_TEXT_HTML_H

/* HTML that needs no network, no script and no file beside it: readable on a phone, on paper, in dark and light. */

#include <stdio.h>

struct table;

void html_open(FILE *out, const char *title); /* up to <main> and <h1> */
void html_close(FILE *out);

/* Escapes the characters of HTML and XML in the first `size` bytes, or in all; control characters become blanks. */
void html_bytes(FILE *out, const char *text, size_t size);
void html_text(FILE *out, const char *text);
/* printf with the conversion %s alone, each text escaped. */
void html_print(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Escaped as html_text, but for `code` between backticks. */
void html_marked(FILE *out, const char *text);

/* A cell <td>; numbers are right-aligned, and `code` is marked. */
void html_cell(FILE *out, const char *text);
/* Writes the table and frees it. */
void html_table(FILE *out, struct table *t);

/* The word of a verdict (pass, fail, inconclusive ...) and a sign, readable without colour. */
void html_verdict(FILE *out, const char *word);

/* A command without the program's name, in a box; its lines break at blanks, not at hyphens. */
void html_command(FILE *out, const char *command);

/* Embeds the SVG file at `path` as an image; 0, or -1 where it cannot be read. */
int html_image(FILE *out, const char *path, const char *alternative);

/* Copies the body of a page of html_open at `path`, without its title.  Returns 0, or -1 if there is none. */
int html_include(FILE *out, const char *path);

#endif
