/* The checkerboard in a field, by a sine or cosine transform along each axis (FFTW).
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
#include "verification/checkerboard.h"

#include "solver/method.h"
#include "solver/problem.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>

/* Coefficient k of a transform of n points belongs to the mode of k + shift half waves in n + extra spacings. */
struct transform {
    fftw_r2r_kind kind;
    double shift;
    int extra;
};

/* [points on the wall's lattice][low side][high side], sides by enum side_kind.  Points half a spacing inside the
 * walls; then points on the lattice that the walls are on, where a Dirichlet wall has none and a Neumann wall has. */
static const struct transform transforms[2][2][2] = {
    {{{FFTW_RODFT10, 1, 0}, {FFTW_RODFT11, 0.5, 0}}, {{FFTW_REDFT11, 0.5, 0}, {FFTW_REDFT10, 0, 0}}},
    {{{FFTW_RODFT00, 1, 1}, {FFTW_RODFT01, 0.5, 0}}, {{FFTW_REDFT01, 0.5, 0}, {FFTW_REDFT00, 0, -1}}},
};

static struct transform choose(const struct problem *p, const struct field *f, int axis) {
    const double *x = axis ? f->y : f->x;
    int half = fabs((x[0] - p->lo[axis]) / f->spacing[axis] - 0.5) < 0.25;
    return transforms[!half][p->side[2 * axis]][p->side[2 * axis + 1]];
}

/* FFTW's transform of a mode of amplitude c is c times the number of spacings, twice that at the ends of the band.
 * Returns what to divide by; *theta is the phase from point to point, pi for the highest mode. */
static double scale(const struct transform *t, int n, int k, double *theta) {
    double waves = k + t->shift, spacings = n + t->extra;
    *theta = acos(-1) * waves / spacings;
    return waves <= 0 || waves >= spacings ? 2 * spacings : spacings;
}

static double largest(const struct field *f, const struct transform t[2], const double *Y) {
    double most = 0, theta[2] = {0, 0};
    for (int j = 0; j < f->shape[1]; j++) {
        double along_y = f->dim == 2 ? scale(&t[1], f->shape[1], j, &theta[1]) : 1;
        for (int i = 0; i < f->shape[0]; i++) {
            double along_x = scale(&t[0], f->shape[0], i, &theta[0]);
            double amplitude = fabs(Y[(size_t)j * (size_t)f->shape[0] + (size_t)i]) / (along_x * along_y);
            if (fmax(theta[0], theta[1]) < acos(-1) / 2) continue;
            if (!(amplitude <= most)) most = amplitude;
            if (isnan(most)) return most;
        }
    }
    return most;
}

double checkerboard_amplitude(const struct problem *p, const struct field *f, const double *exact) {
    if (f->shape[0] < 2 || (f->dim == 2 && f->shape[1] < 2)) return NAN;
    struct transform t[2] = {choose(p, f, 0)};
    if (f->dim == 2) t[1] = choose(p, f, 1);
    double *e = xcalloc(f->n, sizeof *e);
    fftw_plan plan;
#pragma omp critical(fftw_planner)
    {
        plan = f->dim == 2 ? fftw_plan_r2r_2d(f->shape[1], f->shape[0], e, e, t[1].kind, t[0].kind, FFTW_ESTIMATE)
                           : fftw_plan_r2r_1d(f->shape[0], e, e, t[0].kind, FFTW_ESTIMATE);
    }
    for (size_t i = 0; i < f->n; i++) e[i] = f->T[i] - exact[i];
    fftw_execute(plan);
    double amplitude = largest(f, t, e);
#pragma omp critical(fftw_planner)
    fftw_destroy_plan(plan);
    free(e);
    return amplitude;
}
