#ifndef HEATLADDER_VERIFICATION_REPORT_PAMPLONA_H
#define HEATLADDER_VERIFICATION_REPORT_PAMPLONA_H

struct failure;

/* Table 1 and figures 5-8 of Pamplona, Silva, Bucar, Vasco 2019 into `dir`. */
int report_pamplona_write(const char *dir, struct failure *why);

#endif
