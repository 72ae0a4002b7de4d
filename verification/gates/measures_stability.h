#ifndef HEATLADDER_VERIFICATION_GATES_MEASURES_STABILITY_H
#define HEATLADDER_VERIFICATION_GATES_MEASURES_STABILITY_H

/* What gates measure where methods fail; rows of measures.c.  Commands are those of `limit`; of `run` for a refusal.
 */

#include "verification/gates/measures.h"

void measures_stability_agree(const struct request *r, double lo, double hi, struct measured *m);
void measures_stability_published(const struct request *r, double lo, double hi, struct measured *m);
void measures_stability_interval(const struct request *r, double lo, double hi, struct measured *m);
void measures_stability_factor(const struct request *r, double lo, double hi, struct measured *m);
void measures_stability_growth(const struct request *r, double lo, double hi, struct measured *m);
void measures_stability_maximum(const struct request *r, double lo, double hi, struct measured *m);
void measures_stability_refusal(const struct request *r, double lo, double hi, struct measured *m);
void measures_stability_endurance(const struct request *r, double lo, double hi, struct measured *m);

#endif
