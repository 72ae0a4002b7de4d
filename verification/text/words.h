/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_WORDS_H
#define HEATLADDER_VERIFICATION_TEXT_WORDS_H

/* Words of the command line.  A list of words is an array ended by NULL. */

#include <stddef.h>

struct failure; /* solver/status.h */

enum { WORDS_MAX = 136 }; /* the longest list that a caller may build on its stack, its NULL counted */

/* The place of `word` in the list, or -1. */
int words_index(const char *const *words, const char *word);

/* The word of the list that takes the fewest edits to reach; NULL where none is within half of the word's letters. */
const char *words_nearest(const char *const *words, const char *word);

/* 1 if a word consists of letters, digits and /._-+=,@%, without meaning for a shell. */
int words_is_plain(const char *word);

/* The words in one line, in quotes where a shell would change them; the caller frees it. */
char *words_line(int count, const char *const *words);

/* The pattern of fnmatch that matches `word` alone, into `pattern` of twice its bytes at most; cut to size.  Returns
 * it. */
const char *words_literal(const char *word, char *pattern, size_t size);

/* Appends to a text as printf does, cut to size: 0, or -1 where it is cut. */
int words_add(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Writes "a, b, c", cut to size. */
void words_join(const char *const *words, char *text, size_t size);

/* 1 if `word` is in a blank-separated list. */
int words_among(const char *blank_separated, const char *word);

/* Fills *why with "unknown <what> '<word>'; did you mean '<nearest>'? (valid: ...)" and returns STATUS_INPUT. */
int words_unknown(const char *const *words, const char *what, const char *word, struct failure *why);

/* The first of several globs with commas between, into `glob`; where the next one starts, NULL for none.  A backslash
 * takes the meaning of the letter after it. */
const char *words_glob(const char *globs, char *glob, size_t size);

/* 1 if one of the globs matches the name (* also matches /); NULL matches none. */
int words_match(const char *globs, const char *name);

#endif
