/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_OPERATORS_OTHERS_H
#define HEATLADDER_REPORTS_OPERATORS_OTHERS_H

struct claims_measured;

/* The measures, as the rows of others.def name them (a measure reads m->argument; claims.h). */
#define CLAIM(id, source, published, measure, argument, expected, why) void measure(struct claims_measured *m);
#include "reports/operators/others.def"
#undef CLAIM

#endif
