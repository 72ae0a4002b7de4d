/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_WALLS_WALLS_PRICE_H
#define HEATLADDER_REPORTS_WALLS_WALLS_PRICE_H

struct failure;

struct walls_price {      /* the worst of some runs */
    double limit, growth; /* dx^2/kappa, kappa/dx^2 */
    double amplification; /* largest sum of the |shares| of a dummy */
};

/* Raises *price to that of the run of `command` where that is worse; *price starts with the limit INFINITY. */
int walls_price_take(struct walls_price *price, struct failure *why, const char *command);

#endif
