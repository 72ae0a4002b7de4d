/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_PAMPLONA_PAMPLONA_H
#define HEATLADDER_REPORTS_PAMPLONA_PAMPLONA_H

struct claims_measured;
struct failure;

/* Table 1 and figures 5-8 of Pamplona, Silva, Bucar, Vasco 2019 into `dir`. */
int pamplona_write(const char *dir, struct failure *why);

/* The measures, as the rows of pamplona.def name them (claims.h). */
#define CLAIM(id, source, published, measure, argument, expected, why) void measure(struct claims_measured *m);
#define READ(...)
#include "reports/pamplona/pamplona.def"
#undef READ
#undef CLAIM

#endif
