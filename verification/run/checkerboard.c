/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The checkerboard in a field, by a sine or cosine transform along each axis.
 *
 * What is looked at:
 *   - The error T - Te and not T, so that what the exact solution itself has at short wavelengths (a jump does) is
 * not taken for an oscillation.
 *   - In the modes that vanish on a Dirichlet wall and are flat on a Neumann wall, as the error does.  Cosines on a
 *     Dirichlet wall would see a kink: a slope s K/m at the wall leaks s (hi - lo) / (pi k)^2 into mode k, more than
 *     what is looked for.
 *   - The upper half of the band, 2 to 4 points to a wavelength along some axis, and not its highest mode (-1)^j
 * alone: that one is odd about the middle of an even number of points, so that a symmetric scene never excites it,
 * and its neighbours carry the checkerboard. */

#include "solver/time/transform.h"
#include "verification/run/norms.h"

#include <math.h>
#include <stdlib.h>

/* What solver/space/layout.h has for the points of a field: half a spacing inside the walls, or on the lattice that
 * the walls are on, where a Dirichlet wall has none and a Neumann wall has. */
static struct lattice lattice_of(const struct problem *p, const struct field *f) {
    struct lattice l = {.dim = f->dim, .n = {f->shape[0], f->shape[1]}};
    for (int s = 0; s < 2 * f->dim; s++) {
        const double *x = s / 2 ? f->y : f->x;
        int half = fabs((x[0] - p->lo[s / 2]) / f->spacing[s / 2] - 0.5) < 0.25;
        l.sign[s] = p->side[s] == DIRICHLET ? -1 : 1;
        l.shift[s] = half ? 0 : l.sign[s];
    }
    return l;
}

/* A transform makes c times the number of spacings of a mode of amplitude c, twice that at the ends of the band. */
static double doubled(double theta) {
    return theta <= 0 || theta >= M_PI ? 2 : 1;
}

static double largest(const struct lattice *l, const double *Y) {
    double most = 0, spacings = transform_scale(l) / (l->dim == 2 ? 4 : 2);
    for (int j = 0; j < l->n[1]; j++) {
        double theta_y = l->dim == 2 ? transform_angle(l, 1, j) : 0, ends = l->dim == 2 ? doubled(theta_y) : 1;
        for (int i = 0; i < l->n[0]; i++) {
            double theta_x = transform_angle(l, 0, i);
            if (fmax(theta_x, theta_y) < M_PI / 2) continue;
            double amplitude =
                fabs(Y[(size_t)j * (size_t)l->n[0] + (size_t)i]) / (spacings * ends * doubled(theta_x));
            if (!(amplitude <= most)) most = amplitude;
            if (isnan(most)) return most;
        }
    }
    return most;
}

double checkerboard_amplitude(const struct problem *p, const struct field *f, const double *exact) {
    if (f->shape[0] < 2 || (f->dim == 2 && f->shape[1] < 2)) return NAN;
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
