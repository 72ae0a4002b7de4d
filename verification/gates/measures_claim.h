#ifndef HEATLADDER_VERIFICATION_GATES_MEASURES_CLAIM_H
#define HEATLADDER_VERIFICATION_GATES_MEASURES_CLAIM_H

#include "verification/gates/measures.h"

/* 1 where every claim of "claims --only GLOB" has the verdict that its row expects, else 0. */
void measures_claim_take(const struct request *r, double lo, double hi, struct measured *m);

#endif
