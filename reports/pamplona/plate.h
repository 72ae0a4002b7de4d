#ifndef HEATLADDER_REPORTS_PAMPLONA_PLATE_H
#define HEATLADDER_REPORTS_PAMPLONA_PLATE_H

/* Pamplona 2019, Table 1: the "average error", which the paper does not define, under every reading at hand. */

struct failure;

int pamplona_plate_write(const char *dir, struct failure *why);

#endif
