#ifndef HEATLADDER_SOLVER_TIME_TRANSFORM_H
#define HEATLADDER_SOLVER_TIME_TRANSFORM_H

#include "solver/space/layout.h"

/* The sine or cosine transform of a lattice that has the parity of its mirroring walls (sign -1 or +1) on each axis.
 */

enum { TRANSFORM_SHORT = 128 }; /* particles along an axis up to which its sums are done as they stand */

struct transform;

/* T is one of the arrays (n[0] x n[1], x fastest, from xcalloc) that it will be used on; it is not touched. */
struct transform *transform_create(const struct lattice *l, double *T);
void transform_free(struct transform *t);

/* What it holds for itself, with what FFTW may hold for long axes. */
size_t transform_bytes(const struct lattice *l);
/* About what FFTW holds for plans along an axis of n, and works with.  It does not tell: for sines and cosines of
 * 1000 to 10^6 points the allocator counts 2 to 7 doubles a point, on primes and powers of two up to 9. */
size_t transform_library_bytes(int n);

/* T becomes its coefficients, or coefficients become T.  Forth and back multiplies by transform_gain. */
void transform_forward(struct transform *t, double *T);
void transform_backward(struct transform *t, double *T);
double transform_gain(const struct lattice *l);

/* Wave number of mode k along an axis, radians a particle. */
double transform_angle(const struct lattice *l, int axis, int k);

#endif
