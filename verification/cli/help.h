/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CLI_HELP_H
#define HEATLADDER_VERIFICATION_CLI_HELP_H

#include <stdio.h>

struct verb;

/* "1.0.0 (commit)": the release, and in a checkout the commit, with + where files differ from it. */
extern const char help_version[];

extern const char help_about[]; /* environment and exit statuses */

/* The output of --help: all verbs, or one with its options. */
void help_program(FILE *out);
void help_verb(const struct verb *v, FILE *out);

#endif
