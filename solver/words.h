/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_WORDS_H
#define HEATLADDER_SOLVER_WORDS_H

/* Names and options.  A list of words is an array ended by NULL. */

#include <stddef.h>

struct failure; /* solver/status.h */

enum { WORDS_MAX = 136 }; /* the longest list that a caller may build on its stack, its NULL counted */

/* The place of `word` in the list, or -1. */
int words_index(const char *const *words, const char *word);

/* The word of the list that takes the fewest edits to reach; NULL where none is within half of the word's letters. */
const char *words_nearest(const char *const *words, const char *word);

/* Appends to a text as printf does, cut to size: 0, or -1 where it is cut. */
int words_add(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Writes "a, b, c", cut to size. */
void words_join(const char *const *words, char *text, size_t size);

/* 1 if `word` is in a blank-separated list. */
int words_among(const char *blank_separated, const char *word);

/* Fills *why with "unknown <what> '<word>'; did you mean '<nearest>'? (valid: ...)" and returns STATUS_INPUT. */
int words_unknown(const char *const *words, const char *what, const char *word, struct failure *why);

#endif
