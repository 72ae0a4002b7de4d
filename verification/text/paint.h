/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_PAINT_H
#define HEATLADDER_VERIFICATION_TEXT_PAINT_H

#include <stdio.h>

/* The escape sequence that colours a verdict's word, "" for any other word, off a terminal, and with NO_COLOR. */
const char *paint_start(FILE *out, const char *word);
const char *paint_end(FILE *out, const char *word);

#endif
