/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_LEDGER_CLAIMS_WRITE_H
#define HEATLADDER_REPORTS_LEDGER_CLAIMS_WRITE_H

/* The ledger as text, JSON, CSV and Markdown.  None holds a time or a path, so that equal verdicts give equal files
 * (but for the one number that is in seconds). */

#include "reports/ledger/claims.h"

#include <stdio.h>

struct failure;

/* Into a stream: a paragraph, an object, a line or a table row a claim. */
void claims_write_text(const struct claims *c, FILE *out);
void claims_write_json(const struct claims *c, FILE *out);
/* As text the claims with an unexpected verdict, and the count of all. */
void claims_write_changed(const struct claims *c, FILE *out);
void claims_write_csv(const struct claims *c, FILE *out);
void claims_write_markdown(const struct claims *c, FILE *out);

/* claims.csv and claims.md into `dir`: both, whole, or neither. */
int claims_write_files(const struct claims *c, const char *dir, struct failure *why);

#endif
