#ifndef HEATLADDER_REPORTS_PAMPLONA_XI_H
#define HEATLADDER_REPORTS_PAMPLONA_XI_H

struct failure;

/* Pamplona 2019, Figures 7a, 7b and 8: best xi, its error and the cost over h, for three materials; into `dir`. */
int pamplona_xi_write(const char *dir, struct failure *why);

#endif
