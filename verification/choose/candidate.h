#ifndef HEATLADDER_VERIFICATION_CHOOSE_CANDIDATE_H
#define HEATLADDER_VERIFICATION_CHOOSE_CANDIDATE_H

/* Ways to run a scene whose error falls with dx alone, so that a few coarse runs predict the rest. */

#include "verification/run/result.h"

struct experiment;

struct candidate {
    const char *label;
    const char *method;
    struct options options; /* dx left open */
    int dim;                /* 1 or 2: for that dimension only; 0: for both */
    double steps;           /* > 0: time steps are open, for bench 10 and this many for each particle along x */
    int bench_only;         /* 1: for bench alone */
};

enum { CANDIDATE_UNIT_MAX = 1024 };

extern const struct candidate candidates_table[]; /* ended by a NULL label */

/* One size of it: particles along x of the domain, and time steps where they are open (0: as for bench). */
struct candidate_size {
    int n, steps;
};

struct options candidate_options(const struct candidate *c, const struct experiment *e, struct candidate_size size);

/* The number of cells along x whose multiples all suit the problem: no part of a cell is left over, and every jump,
 * if that can be, lies on a face.  0 where there is none up to CANDIDATE_UNIT_MAX. */
int candidate_unit(const struct problem *p);

/* For a text: the values nearest to what the domain has, of which candidate_unit would be a unit. */
void candidate_fitting(const struct problem *p, char *text, size_t size);

/* The smallest multiple of the unit that is not below `least`. */
int candidate_member(double least, int unit);

/* The solve alone, as struct method's. */
int candidate_solve(const struct candidate *c, const struct experiment *e, struct candidate_size size,
                    struct field *f, struct failure *why);

/* Runs and measures it; as run_experiment. */
int candidate_run(const struct candidate *c, const struct experiment *e, struct candidate_size size,
                  struct result *out);

/* The same, with *between the error half-way between the particles (halfway.h). */
int candidate_prove(const struct candidate *c, const struct experiment *e, struct candidate_size size,
                    struct result *out, double *between);

/* What a run takes, told by its plan (verification/choose/plan.h). */
struct candidate_cost {
    double work;     /* field.work */
    double whole;    /* with the exact temperatures, and rows at what they take: for limits */
    double bytes;    /* held at once, at most */
    double rounding; /* what rounding leaves of E1, in the mean */
};

/* The cost of the run; a status of solver/method.h.  Rounding: T is rounded at each application of the operator, by
 * eps/4 of itself in the mean and at random: eps/4 sqrt(applications).  With transforms the symbol of the slowest
 * mode is what is left of terms of size kappa/dx^2, each wrong by eps/4 in the mean, and acts until the mode is gone:
 * eps/4 kappa min(t, L^2/(pi^2 kappa))/dx^2. */
int candidate_predict(const struct candidate *c, const struct experiment *e, struct candidate_size size,
                      struct candidate_cost *cost, struct failure *why);

#endif
