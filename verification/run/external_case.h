#ifndef HEATLADDER_VERIFICATION_RUN_EXTERNAL_CASE_H
#define HEATLADDER_VERIFICATION_RUN_EXTERNAL_CASE_H

#include <stdio.h>

struct options;
struct request;

/* Writes what another program must know to solve r->problem at the options *o, as lines `key = value`. */
void external_case_write(const struct request *r, const struct options *o, FILE *out);

#endif
