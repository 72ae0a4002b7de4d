/* The exact solution of the semi-discrete problem dT/dt = A T + g on a lattice.
 *
 * Stencils are even and ghosts mirror, so A is diagonal under the sine or cosine transform that has the walls'
 * parity: T^(t) = exp(lambda t) T^(0) + t phi(lambda t) g^,   phi(z) = (exp(z) - 1) / z, lambda = sum_ij w_ij cos(i
 * theta_x) cos(j theta_y) the symbol at the transform's wave numbers. */
#include "solver/time/exact.h"

#include "solver/time/state.h"
#include "solver/time/transform.h"

#include <math.h>
#include <stdlib.h>

/* cos(i theta_k), i <= reach, for every mode k of an axis, times the multiplicity of +-i. */
static double *cosines(const struct heat_operator *a, int axis) {
    const struct lattice *l = &a->lattice;
    int r = a->reach[axis];
    double *table = xcalloc((size_t)l->n[axis] * (size_t)(r + 1), sizeof *table);
    for (int k = 0; k < l->n[axis]; k++)
        for (int i = 0; i <= r; i++) table[k * (r + 1) + i] = (i ? 2 : 1) * cos(i * transform_angle(l, axis, k));
    return table;
}

/* Modes that are gone cost no exp; below -1 exp(z) - 1 loses nothing. */
static const double GONE = -746, FAR = -1; /* exp(GONE) is zero */

static void advance_modes(const struct heat_operator *a, double t, double *T, const double *g) {
    const struct lattice *l = &a->lattice;
    int rx = a->reach[0], ry = a->reach[1];
    double *cx = cosines(a, 0), *cy = l->dim == 2 ? cosines(a, 1) : NULL,
           *column = xcalloc((size_t)rx + 1, sizeof *column);
    double scale = 1 / transform_gain(l);
    for (int m = 0; m < l->n[1]; m++) {
        for (int i = 0; i <= rx; i++) {
            column[i] = 0;
            for (int j = 0; j <= ry; j++) column[i] += a->weight[j * (rx + 1) + i] * (cy ? cy[m * (ry + 1) + j] : 1);
        }
        for (int k = 0; k < l->n[0]; k++) {
            double lambda = 0;
            for (int i = 0; i <= rx; i++) lambda += column[i] * cx[k * (rx + 1) + i];
            size_t at = (size_t)m * (size_t)l->n[0] + (size_t)k;
            double z = lambda * t, decay = z < GONE ? 0 : exp(z), mode = decay * T[at];
            if (g) mode += t * (z < FAR ? (decay - 1) / z : fabs(z) > 1e-12 ? expm1(z) / z : 1) * g[at];
            T[at] = scale * mode;
        }
    }
    free(cx);
    free(cy);
    free(column);
}

size_t exact_bytes(const struct heat_operator *a) {
    const struct lattice *l = &a->lattice;
    size_t tables = 0;
    for (int d = 0; d < l->dim; d++) tables += (size_t)l->n[d] * (size_t)(a->reach[d] + 1) * sizeof(double);
    return transform_bytes(l) + tables + (a->constant ? a->n * sizeof *a->g : 0);
}

int exact_check(const struct lattice *l, struct failure *why) {
    for (int s = 0; s < 2 * l->dim; s++)
        if (l->sign[s] == 0) return refuse(why, STATUS_NOT_APPLICABLE, "--stepper exact: needs --walls mirror");
    if ((l->shift[X_LO] > 0 && l->shift[X_HI] > 0 && l->n[0] < 2) ||
        (l->dim == 2 && l->shift[Y_LO] > 0 && l->shift[Y_HI] > 0 && l->n[1] < 2))
        return refuse(why, STATUS_NOT_APPLICABLE, "--stepper exact: needs two particles along an insulated axis");
    return STATUS_OK;
}

void exact_evolve(const struct heat_operator *a, double t, double *T, size_t *bytes) {
    const struct lattice *l = &a->lattice;
    struct transform *modes = transform_create(l, T);
    double *g = NULL;
    if (a->g) {
        g = xcalloc(a->n, sizeof *g);
        state_store(a, a->g, g);
        transform_forward(modes, g);
    }
    transform_forward(modes, T);
    advance_modes(a, t, T, g);
    transform_backward(modes, T);
    *bytes += exact_bytes(a);
    transform_free(modes);
    free(g);
}
