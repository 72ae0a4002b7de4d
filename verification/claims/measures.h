#ifndef HEATLADDER_VERIFICATION_CLAIMS_MEASURES_H
#define HEATLADDER_VERIFICATION_CLAIMS_MEASURES_H

/* What a row of claims.def can measure: one table a file, each ended by a NULL name.  A new measure is a function and
 * a row of the table of its file. */

#include "verification/claims/claims.h"

extern const struct claims_measure claims_order_measures[];           /* orders and tables of errors */
extern const struct claims_measure claims_song_limit_measures[];      /* Song eqs. 31-41 */
extern const struct claims_measure claims_song_moment_measures[];     /* Song eqs. 10-26 */
extern const struct claims_measure claims_song_wave_measures[];       /* oscillations, time error */
extern const struct claims_measure claims_song_exact_measures[];      /* eqs. 44, 45 */
extern const struct claims_measure claims_pamplona_exact_measures[];  /* Pamplona eqs. 2-7, steady state */
extern const struct claims_measure claims_pamplona_kernel_measures[]; /* eqs. 9, 14, 15, 17, time integration */
extern const struct claims_measure claims_pamplona_plate_measures[];  /* Table 1, section 6 */
extern const struct claims_measure claims_pamplona_xi_measures[];     /* eq. 18, Fig. 7 */
extern const struct claims_measure claims_pamplona_cost_measures[];   /* Fig. 8 */

#endif
