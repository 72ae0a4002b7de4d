#ifndef HEATLADDER_REPORTS_PAMPLONA_PAMPLONA_H
#define HEATLADDER_REPORTS_PAMPLONA_PAMPLONA_H

struct failure;

/* Table 1 and figures 5-8 of Pamplona, Silva, Bucar, Vasco 2019 into `dir`: all, by the two below and Figures 5, 6.
 */
int pamplona_write(const char *dir, struct failure *why);

/* Table 1: the "average error", which the paper does not define, under every reading at hand. */
int pamplona_plate_write(const char *dir, struct failure *why);

/* Figures 7a, 7b and 8: best xi, its error and the cost over h, for three materials. */
int pamplona_xi_write(const char *dir, struct failure *why);

#endif
