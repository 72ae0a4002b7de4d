/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Amplitude of the checkerboard in a field, by a sine or cosine transform along each axis.
 *
 * The transform is that of the error T - Te, not of T, so that short wavelengths of the exact solution (such as a
 * jump) do not count as oscillations.
 *
 * Its modes vanish on a Dirichlet wall and are flat on a Neumann wall, like the error.  Cosines on a Dirichlet wall
 * would have a kink: a slope of s K/m at the wall leaks s (hi - lo) / (pi k)^2 into mode k, more than the amplitudes
 * of interest.
 *
 * The upper half of the band, 2 to 4 points per wavelength along some axis, is searched, not only the highest mode
 * (-1)^j.  That mode is odd about the middle of an even number of points, so a symmetric scene never excites it; its
 * neighbours carry the checkerboard. */

#include "solver/time/transform.h"
#include "verification/judge/norms.h"

#include <math.h>
#include <stdlib.h>

/* The lattice (solver/space/layout.h) of a field: points half a spacing inside the walls, or on them, without those
 * on a Dirichlet wall and with those on a Neumann wall. */
static struct lattice lattice_of(const struct problem *p, const struct field *f) {
    struct lattice l = {.dim = f->dim, .n = {1, 1, 1}};
    for (int a = 0; a < f->dim; a++) l.n[a] = f->shape[a];
    for (int s = 0; s < 2 * f->dim; s++) {
        const double *x = f->x[s / 2];
        int half = fabs((x[0] - p->lo[s / 2]) / f->spacing[s / 2] - 0.5) < 0.25;
        l.sign[s] = p->side[s] == DIRICHLET ? -1 : 1;
        l.shift[s] = half ? 0 : l.sign[s];
    }
    return l;
}

/* The transform of a mode of amplitude c is c times the number of spacings, twice that at the ends of the band. */
static double doubled(double theta) {
    return theta <= 0 || theta >= M_PI ? 2 : 1;
}

/* Past dim theta is long and not at an end. */
static double largest(const struct lattice *l, const double *Y) {
    double most = 0, spacings = transform_scale(l) / (1 << l->dim), *theta[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) {
        theta[a] = xcalloc((size_t)l->n[a], sizeof **theta);
        for (int k = 0; k < l->n[a]; k++) theta[a][k] = a < l->dim ? transform_angle(l, a, k) : M_PI / 4;
    }
    for (int k = 0; k < l->n[2]; k++)
        for (int j = 0; j < l->n[1]; j++) {
            double highest = fmax(theta[1][j], theta[2][k]),
                   times = spacings * doubled(theta[1][j]) * doubled(theta[2][k]);
            for (int i = 0; i < l->n[0]; i++, Y++) {
                double amplitude = fabs(*Y) / (times * doubled(theta[0][i]));
                if (highest < M_PI / 2 && theta[0][i] < M_PI / 2) continue;
                if (!(amplitude <= most) && !isnan(most)) most = amplitude;
            }
        }
    for (int a = 0; a < DIM_MAX; a++) free(theta[a]);
    return most;
}

double checkerboard_amplitude(const struct problem *p, const struct field *f, double *exact) {
    for (int a = 0; a < f->dim; a++)
        if (f->shape[a] < 2) return NAN;
    struct lattice l = lattice_of(p, f);
    struct transform *t = transform_create(&l);
    for (size_t i = 0; i < f->n; i++) exact[i] = exact[i] == NORMS_NO_VALUE ? 0 : f->T[i] - exact[i];
    transform_forward(t, exact);
    double amplitude = largest(&l, exact);
    transform_free(t);
    return amplitude;
}
