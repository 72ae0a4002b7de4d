#ifndef HEATLADDER_VERIFICATION_CLAIMS_PAMPLONA_PLATE_H
#define HEATLADDER_VERIFICATION_CLAIMS_PAMPLONA_PLATE_H

/* Runs of Pamplona's plate and the errors that the paper speaks of. */

#include "verification/claims/claims.h"
#include "verification/run/result.h"

enum { CLAIMS_PAMPLONA_PLATE_SIDE = 40 }; /* most particles along a side */

struct claims_pamplona_plate {
    double mean_relative;           /* mean of |e|/T: what the paper's "average error" is nearest to */
    double e1;                      /* sum |e| / sum T */
    double over_kelvin;             /* mean of |e| over 1 K, the hottest wall */
    double rms;                     /* root mean square of e over 1 K */
    double left_mean, left_max;     /* |e| beside the left wall, K */
    double centre_mean, centre_max; /* |e| of the middle 4 x 4, K */
    double ring_mean;               /* |e| of the outermost ring, K */
    double ring_late, centre_late;  /* mean of T_exact - T, K */
    double ring_part, centre_part;  /* mean of (T_exact - T)/T_exact */
    struct result result;
};

/* "words" of a run on the plate, by the paper's fixed walls unless they say otherwise, taken to lag * t and compared
 * at t, s.  With lag = ((n + 1)/n)^2 the plate counts as n + 1 spacings wide, from ghost to ghost.  0, or *m failed.
 */
int claims_pamplona_plate_run(struct claims_pamplona_plate *e, struct claims_measured *m, double t, double lag,
                              const char *words);

#endif
