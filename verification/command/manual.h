/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_COMMAND_MANUAL_H
#define HEATLADDER_VERIFICATION_COMMAND_MANUAL_H

#include <stdio.h>

/* The manual page heatladder(1), in the macros of man(7), and the completion for bash: made from the tables that the
 * arguments are read by, as the help is. */
void manual_page(FILE *out);
void manual_completion(FILE *out);

#endif
