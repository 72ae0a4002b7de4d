/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_COMMAND_ARGUMENTS_H
#define HEATLADDER_VERIFICATION_COMMAND_ARGUMENTS_H

/* From the words of a command line to a struct request, checked and with its problem set up. */

#include "verification/command/request.h"

/* argv[0] is the verb; *r is all zeros before.  0, or STATUS_INPUT with *why filled; either way the caller calls
 * arguments_free. */
int arguments_parse(int argc, char *const *argv, struct request *r, struct failure *why);

/* The same from one line, as a user would type it after the name of the program; '...' and "..." hold blanks. */
int arguments_parse_line(const char *line, struct request *r, struct failure *why);

/* The same, with `more`, words ended by NULL, after those of the line. */
int arguments_parse_line_with(const char *line, const char *const *more, struct request *r, struct failure *why);

void arguments_free(struct request *r);

/* Whether the options of a request go together.  Both: STATUS_OK, or STATUS_INPUT with *why filled. */

/* All that the verb needs is given; before the scene is set up. */
int checks_required(const struct request *r, struct failure *why);

/* No option contradicts another or lacks one that it needs; once the scene is set up. */
int checks_together(const struct request *r, struct failure *why);

#endif
