/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CLI_SURROUNDINGS_H
#define HEATLADDER_VERIFICATION_CLI_SURROUNDINGS_H

/* Effects of libraries, the system and the environment on the program, set up once by main. */

struct command;

/* Errors of GSL, FFTW and OpenMP end the program with a message and STATUS_NUMERICAL where memory is missing; GSL's
 * other errors are statuses of its functions.  Sets $HEATLADDER to the path of the program, unless it is set. */
void surroundings_prepare(const char *typed);

/* After this call exit() is main's own. */
void surroundings_leave(void);

/* Starts the program again with threads that wait without spinning, where a command uses several. */
void surroundings_wait_passively(const struct command *c, char *const *argv);

#endif
