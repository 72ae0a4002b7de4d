/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_PAPERS_H
#define HEATLADDER_REPORTS_PAPERS_H

/* The statements of all papers, one table; a paper is a folder and a row of papers.c. */

#include "reports/ledger/claims.h"

extern const struct claims_row papers_claims[]; /* ended by a NULL id */

#endif
