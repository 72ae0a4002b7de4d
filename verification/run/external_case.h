#ifndef HEATLADDER_VERIFICATION_RUN_EXTERNAL_CASE_H
#define HEATLADDER_VERIFICATION_RUN_EXTERNAL_CASE_H

#include <stdio.h>

struct experiment;

/* Writes what another program must know to run the experiment, as lines `key = value`. */
void external_case_write(const struct experiment *e, FILE *out);

#endif
