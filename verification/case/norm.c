/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names of the norms, from norms.def. */
#include "verification/case/norm.h"

#include <stddef.h>

#define NORM(NAME, word, title, column, key, of) word,
const char *const norm_words[] = {
#include "verification/case/norms.def"
    NULL};
#undef NORM
#define NORM(NAME, word, title, column, key, of) title,
const char *const norm_titles[] = {
#include "verification/case/norms.def"
    "the quantity's error"};
#undef NORM
#define NORM(NAME, word, title, column, key, of) column,
const char *const norm_columns[] = {
#include "verification/case/norms.def"
    NULL};
#undef NORM
#define NORM(NAME, word, title, column, key, of) key,
const char *const norm_keys[] = {
#include "verification/case/norms.def"
    NULL};
#undef NORM
