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
#include "verification/run/norms.h"

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

static double largest(const struct lattice *l, const double *Y) {
    double most = 0, spacings = transform_scale(l) / (1 << l->dim);
    size_t n = (size_t)l->n[0] * (size_t)l->n[1] * (size_t)l->n[2];
    for (size_t i = 0; i < n; i++) {
        double highest = 0, times = spacings;
        size_t rest = i;
        for (int a = 0; a < l->dim; rest /= (size_t)l->n[a++]) {
            double theta = transform_angle(l, a, (int)(rest % (size_t)l->n[a]));
            highest = fmax(highest, theta), times *= doubled(theta);
        }
        if (highest < M_PI / 2) continue;
        double amplitude = fabs(Y[i]) / times;
        if (!(amplitude <= most)) most = amplitude;
        if (isnan(most)) return most;
    }
    return most;
}

double checkerboard_amplitude(const struct problem *p, const struct field *f, const double *exact) {
    for (int a = 0; a < f->dim; a++)
        if (f->shape[a] < 2) return NAN;
    struct lattice l = lattice_of(p, f);
    double *e = xcalloc(f->n, sizeof *e);
    struct transform *t = transform_create(&l);
    for (size_t i = 0; i < f->n; i++) e[i] = exact[i] == NORMS_NO_VALUE ? 0 : f->T[i] - exact[i];
    transform_forward(t, e);
    double amplitude = largest(&l, e);
    transform_free(t);
    free(e);
    return amplitude;
}
