#ifndef HEATLADDER_VERIFICATION_CANDIDATE_H
#define HEATLADDER_VERIFICATION_CANDIDATE_H

/* Ways to run a scene whose error falls with dx alone, so that a few coarse runs foretell the rest. */

#include "verification/result.h"

struct request;

struct candidate {
    const char *label;
    const char *method;
    struct options options; /* dx left open */
    int dim;                /* 1 or 2: for that dimension only; 0: for both */
    double steps;           /* time steps: 10, and this many for each particle along x; 0: as the options say */
    int wide;               /* 1: for bench alone */
};

extern const struct candidate candidates_table[]; /* ended by a NULL label */

/* The options of the candidate with n particles along x of r's domain. */
struct options candidate_options(const struct candidate *c, const struct request *r, int n);

/* The number of cells along x whose multiples all suit the problem: no part of a cell is left over, and every jump,
 * if that can be, lies on a face.  0 where there is none up to 64. */
int candidate_unit(const struct problem *p);

/* For a text: the values nearest to what the domain has, of which candidate_unit would be a unit. */
void candidate_fitting(const struct problem *p, char *text, size_t size);

/* The smallest multiple of the unit that is not below `least`. */
int candidate_member(double least, int unit);

/* The solve alone, as struct method's. */
int candidate_solve(const struct candidate *c, const struct request *r, int n, struct field *f, struct failure *why);

/* Runs and measures it; as run_request. */
int candidate_run(const struct candidate *c, const struct request *r, int n, struct result *out);

/* What the steps of a run with n particles along x will count in candidate_work; 0 where it would be refused. */
double candidate_steps_work(const struct candidate *c, const struct request *r, int n);

/* What rounding leaves of E1 after the steps of that run: T is rounded at each application of the operator, by eps/4
 * of itself in the mean and at random: eps/4 sqrt(applications).  0 where it would be refused. */
double candidate_rounding(const struct candidate *c, const struct request *r, int n);

/* What a run costs, counted so that it is the same on every machine.  The unit is a pair of particles, one
 * multiplication and one addition in a stream:
 *
 *     steps        pairs + 2 updates      (a load and a store of each particle beside its pairs), and ghosts
 *     the rest     setup_work.h           (set-up, sampling, assembly; the transforms of --stepper exact)
 */
double candidate_work(const struct result *r);

#endif
