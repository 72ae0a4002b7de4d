/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_PAMPLONA_READINGS_H
#define HEATLADDER_REPORTS_PAMPLONA_READINGS_H

/* Pamplona 2019, Table 1 under every reading at hand: where the walls lie, what the ghosts in the corners hold, how
 * many terms of the series are summed, and what "average error" means. */

#include "reports/pamplona/plate.h"

struct published;

enum { READINGS_PLACES = 3, READINGS_CORNERS = 3, READINGS_SERIES = 6 };

extern const char *const readings_places[READINGS_PLACES];
extern const char *const readings_corners[READINGS_CORNERS];
extern const int readings_terms[READINGS_SERIES]; /* n, m, p <= terms in eqs. 2 and 4 */

struct reading {
    int place, corner, terms;                                    /* indices of the lists above */
    double error[PLATE_DEFINITIONS][PLATE_METHODS][PLATE_TIMES]; /* % */
    double off[PLATE_DEFINITIONS];                               /* largest factor from the eight of Table 1 */
    int best;                                                    /* definition of the least `off` */
};

struct readings {
    int count, nearest; /* the reading of the least `off` */
    struct reading reading[READINGS_PLACES * READINGS_CORNERS * READINGS_SERIES];
};

/* Tries all.  The caller frees the result. */
struct readings *readings_try(const struct published *table1);

#endif
