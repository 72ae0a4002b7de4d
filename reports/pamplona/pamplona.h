#ifndef HEATLADDER_REPORTS_PAMPLONA_PAMPLONA_H
#define HEATLADDER_REPORTS_PAMPLONA_PAMPLONA_H

struct failure;

/* Table 1 and figures 5-8 of Pamplona, Silva, Bucar, Vasco 2019 into `dir`. */
int pamplona_write(const char *dir, struct failure *why);

#endif
