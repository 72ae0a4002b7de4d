/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_OPERATORS_OPERATORS_H
#define HEATLADDER_REPORTS_OPERATORS_OPERATORS_H

struct failure;

/* The discrete Laplacians side by side into `dir`: operators.md and .html (which to take; orders on every cloud and
 * scene), operators_error.csv (error against neighbours), operators_work.csv, operators_growth.csv.  Progress goes to
 * standard output. */
int operators_write(const char *dir, struct failure *why);

#endif
