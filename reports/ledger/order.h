/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_LEDGER_ORDER_H
#define HEATLADDER_REPORTS_LEDGER_ORDER_H

#include "reports/ledger/claims.h"

/* Measures of orders of accuracy and of tables of errors; the argument of each is explained beside it. */

void ledger_order_order(struct claims_measured *m);
void ledger_order_printed_order(struct claims_measured *m);
void ledger_order_table(struct claims_measured *m);
void ledger_order_gap(struct claims_measured *m);
void ledger_order_eq45(struct claims_measured *m);
void ledger_order_walls(struct claims_measured *m);
void ledger_order_sensitive(struct claims_measured *m);
void ledger_order_diverges(struct claims_measured *m);
void ledger_order_steadier(struct claims_measured *m);
void ledger_order_better(struct claims_measured *m);

#endif
