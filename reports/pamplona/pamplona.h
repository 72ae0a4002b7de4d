/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_PAMPLONA_PAMPLONA_H
#define HEATLADDER_REPORTS_PAMPLONA_PAMPLONA_H

struct claims_measured;
struct failure;

/* Table 1 and figures 5-8 of Pamplona, Silva, Bucar, Vasco 2019 into `dir`: all, by the two below and Figures 5, 6.
 */
int pamplona_write(const char *dir, struct failure *why);

/* Table 1: the "average error", which the paper does not define, under all plausible definitions. */
int pamplona_table1_write(const char *dir, struct failure *why);

/* Figures 7a, 7b and 8: best xi, its error and the cost over h, for three materials. */
int pamplona_fig7_write(const char *dir, struct failure *why);

/* The measures, as the rows of pamplona.def name them (a measure reads m->argument; claims.h). */
#define CLAIM(id, source, published, measure, argument, expected, why) void measure(struct claims_measured *m);
#include "reports/pamplona/pamplona.def"
#undef CLAIM

#endif
