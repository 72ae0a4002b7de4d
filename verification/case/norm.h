/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_NORM_H
#define HEATLADDER_VERIFICATION_CASE_NORM_H

/* The norms of the error, by name (norms.def). */

enum norm {
#define NORM(NAME, word, title, column, key, of) NORM_##NAME,
#include "verification/case/norms.def"
#undef NORM
    NORM_QUANTITY /* the error of --quantity; has no word, column or key */
};

extern const char *const norm_words[];   /* words of --norm, in the order of the enum, ended by NULL */
extern const char *const norm_titles[];  /* including NORM_QUANTITY */
extern const char *const norm_columns[]; /* NULL: shown only if it is fitted */
extern const char *const norm_keys[];    /* in JSON, with the unit (json.h) */

#endif
