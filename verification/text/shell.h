/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_SHELL_H
#define HEATLADDER_VERIFICATION_TEXT_SHELL_H

/* Words of a command line: globs, and words quoted for a shell. */

#include <stddef.h>

/* 1 if a word consists of letters, digits and /._-+=,@%, without meaning for a shell. */
int shell_is_plain(const char *word);

/* The words in one line, in quotes where a shell would change them; the caller frees it. */
char *shell_line(int count, const char *const *words);

/* The pattern of fnmatch that matches `word` alone, into `pattern` of twice its bytes at most; cut to size.  Returns
 * it. */
const char *shell_literal(const char *word, char *pattern, size_t size);

/* The first of several globs with commas between, into `glob`; where the next one starts, NULL for none.  A backslash
 * takes the meaning of the letter after it. */
const char *shell_glob(const char *globs, char *glob, size_t size);

/* 1 if one of the globs matches the name (* also matches /); NULL matches none. */
int shell_match(const char *globs, const char *name);

#endif
