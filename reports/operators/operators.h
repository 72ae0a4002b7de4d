/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_OPERATORS_OPERATORS_H
#define HEATLADDER_REPORTS_OPERATORS_OPERATORS_H

struct failure;
struct claims_measured;

/* The discrete Laplacians side by side into `dir`: operators.md and .html (which to take; orders on every cloud and
 * scene), operators_error.csv (error against neighbours), operators_work.csv, operators_growth.csv.  Progress goes to
 * standard output. */
int operators_write(const char *dir, struct failure *why);

/* The measures, as the rows of others.def name them (a measure reads m->argument; claims.h). */
#define CLAIM(id, source, published, measure, argument, expected, why) void measure(struct claims_measured *m);
#include "reports/operators/others.def"
#undef CLAIM

#endif
