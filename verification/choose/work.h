#ifndef HEATLADDER_VERIFICATION_CHOOSE_WORK_H
#define HEATLADDER_VERIFICATION_CHOOSE_WORK_H

/* What a run does beside the pairs of its steps, counted. */

struct problem;
struct result;

/* Pairs (candidate.h) of the set-up of the run *r of *p, and of the transforms of --stepper exact: all but the steps.
 */
double work_of_setup(const struct problem *p, const struct result *r);

/* Pairs that all its steps take for the ghosts of a lattice; 0 for rows, which have none. */
double work_of_ghosts(const struct problem *p, const struct result *r);

#endif
