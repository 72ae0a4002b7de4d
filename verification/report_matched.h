#ifndef HEATLADDER_VERIFICATION_REPORT_MATCHED_H
#define HEATLADDER_VERIFICATION_REPORT_MATCHED_H

struct failure;

/* The matched run (solver/matched.h): error against counted work beside Song's choice, and A, B, F and the stability
 * limit over h/dx. */
int report_matched_write(const char *dir, struct failure *why);

#endif
