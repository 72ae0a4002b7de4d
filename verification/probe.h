#ifndef HEATLADDER_VERIFICATION_PROBE_H
#define HEATLADDER_VERIFICATION_PROBE_H

/* A method by itself: n (on a rectangle n x n) particles of spacing dx = 1 and diffusivity 1, so that times are in
 * dx^2/kappa and steps are mesh Fourier numbers. */

#include "solver/operator.h"

#include "verification/amplify.h"

struct probe {
    const struct method *method;
    int dim;
    int n;                  /* along each axis */
    int insulated;          /* 1: no flux through the walls; 0: they are at 0 K */
    struct options options; /* dx = 1; stepper and stages are those of `step` */
    struct amplify step;
};

enum probe_data {
    PROBE_NOISE,   /* in [-1, 1], by the cell that a particle lies in */
    PROBE_IMPULSE, /* 1 K in the middle cell */
    PROBE_HILL     /* half a wave along each axis, 1 K high, and `disturb` times the noise */
};

/* The options settled (h/dx), and the least n that the method's reach allows where b->n is 0: at least `least`. */
int probe_settle(struct probe *b, int least, struct failure *why);

struct problem probe_problem(const struct probe *b, enum probe_data data, double disturb);

/* `steps` steps of F = dt kappa/dx^2 by the method's own solve (RKL2: by stepper_march, since a run chooses its own
 * stages).  *largest is max |T| at the end.  STATUS_NUMERICAL where the run is refused as unstable. */
int probe_run(const struct probe *b, const struct problem *p, double F, long long steps, double *largest,
              struct failure *why);

/* The operator of a particle method: a lattice's, or the rows of a jittered cloud. */
int probe_operator(const struct probe *b, const struct problem *p, struct heat_operator *a, struct failure *why);

/* Of a particle method on b's jittered (or regular) cloud; the caller frees it. */
int probe_cloud(const struct probe *b, const struct problem *p, struct cloud *c, struct failure *why);

/* Calls `see` with the neighbourhood of each of the first `count` particles of the cloud; stops at its first status.
 */
typedef int probe_see(const struct probe *b, const struct neighbourhood *nb, void *with, struct failure *why);
int probe_around(const struct probe *b, const struct cloud *c, size_t count, probe_see *see, void *with,
                 struct failure *why);

#endif
