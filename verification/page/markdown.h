/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_PAGE_MARKDOWN_H
#define HEATLADDER_VERIFICATION_PAGE_MARKDOWN_H

#include <stdio.h>

/* The Markdown that this project writes: headings, paragraphs, lists, tables, code, `code`, *emphasis*, links.  A
 * heading of level n becomes one of level n + deeper. */
void markdown_write(FILE *out, FILE *in, int deeper);

#endif
