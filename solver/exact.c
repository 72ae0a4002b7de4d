/* The exact solution of the semi-discrete problem dT/dt = A T + g on a lattice.
 *
 * Stencils are even and ghosts mirror, so A is diagonal under the sine or cosine transform that has the walls'
 * parity: T^(t) = exp(lambda t) T^(0) + t phi(lambda t) g^,   phi(z) = (exp(z) - 1) / z, lambda = sum_ij w_ij cos(i
 * theta_x) cos(j theta_y) the symbol at the transform's wave numbers (FFTW manual, "1d Real-even DFTs", "1d Real-odd
 * DFTs"). */
#include "solver/exact.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>

struct basis {
    fftw_r2r_kind forward, backward;
    double first; /* theta_k = pi (k + first) / (n + more) */
    int more;
};

/* Indexed by [node layout][low side even][high side even]. */
static const struct basis bases[2][2][2] = {
    {{{FFTW_RODFT10, FFTW_RODFT01, 1, 0}, {FFTW_RODFT11, FFTW_RODFT11, 0.5, 0}},
     {{FFTW_REDFT11, FFTW_REDFT11, 0.5, 0}, {FFTW_REDFT10, FFTW_REDFT01, 0, 0}}},
    {{{FFTW_RODFT00, FFTW_RODFT00, 1, 1}, {FFTW_RODFT01, FFTW_RODFT10, 0.5, 0}},
     {{FFTW_REDFT01, FFTW_REDFT10, 0.5, 0}, {FFTW_REDFT00, FFTW_REDFT00, 0, -1}}},
};

static const struct basis *basis_of(const struct lattice *l, int axis) {
    return &bases[l->shift[2 * axis] != 0][l->sign[2 * axis] > 0][l->sign[2 * axis + 1] > 0];
}

static void transform(const struct lattice *l, double *T, int backward) {
    const struct basis *x = basis_of(l, 0), *y = basis_of(l, 1);
    fftw_plan plan;
#pragma omp critical(fftw_planner)
    {
        if (l->dim == 1)
            plan = fftw_plan_r2r_1d(l->n[0], T, T, backward ? x->backward : x->forward, FFTW_ESTIMATE);
        else
            plan = fftw_plan_r2r_2d(l->n[1], l->n[0], T, T, backward ? y->backward : y->forward,
                                    backward ? x->backward : x->forward, FFTW_ESTIMATE);
    }
    fftw_execute(plan);
#pragma omp critical(fftw_planner)
    fftw_destroy_plan(plan);
}

/* cos(i theta_k), i <= reach, for every mode k of an axis, times the multiplicity of +-i. */
static double *cosines(const struct heat_operator *a, int axis) {
    const struct lattice *l = &a->lattice;
    const struct basis *b = basis_of(l, axis);
    int r = a->reach[axis];
    double *table = xcalloc((size_t)l->n[axis] * (size_t)(r + 1), sizeof *table);
    for (int k = 0; k < l->n[axis]; k++)
        for (int i = 0; i <= r; i++)
            table[k * (r + 1) + i] = (i ? 2 : 1) * cos(M_PI * i * (k + b->first) / (l->n[axis] + b->more));
    return table;
}

static void advance_modes(const struct heat_operator *a, double t, double *T, const double *g) {
    const struct lattice *l = &a->lattice;
    int rx = a->reach[0], ry = a->reach[1];
    double *cx = cosines(a, 0), *cy = l->dim == 2 ? cosines(a, 1) : NULL,
           *column = xcalloc((size_t)rx + 1, sizeof *column);
    double scale = 1;
    for (int d = 0; d < l->dim; d++) scale /= 2.0 * (l->n[d] + basis_of(l, d)->more);
    for (int m = 0; m < l->n[1]; m++) {
        for (int i = 0; i <= rx; i++) {
            column[i] = 0;
            for (int j = 0; j <= ry; j++) column[i] += a->weight[j * (rx + 1) + i] * (cy ? cy[m * (ry + 1) + j] : 1);
        }
        for (int k = 0; k < l->n[0]; k++) {
            double lambda = 0;
            for (int i = 0; i <= rx; i++) lambda += column[i] * cx[k * (rx + 1) + i];
            size_t at = (size_t)m * (size_t)l->n[0] + (size_t)k;
            double z = lambda * t, mode = exp(z) * T[at];
            if (g) mode += t * (fabs(z) > 1e-12 ? expm1(z) / z : 1) * g[at];
            T[at] = scale * mode;
        }
    }
    free(cx);
    free(cy);
    free(column);
}

int exact_evolve(const struct heat_operator *a, double t, double *T, size_t *bytes, struct failure *why) {
    const struct lattice *l = &a->lattice;
    if (!a->weight)
        return fail(why, STATUS_INPUT, "--stepper exact: needs --layout lattice or node and one material");
    for (int s = 0; s < 2 * l->dim; s++)
        if (l->sign[s] == 0) return fail(why, STATUS_INPUT, "--stepper exact: needs --walls mirror");
    if ((l->shift[X_LO] > 0 && l->shift[X_HI] > 0 && l->n[0] < 2) ||
        (l->dim == 2 && l->shift[Y_LO] > 0 && l->shift[Y_HI] > 0 && l->n[1] < 2))
        return fail(why, STATUS_INPUT, "--stepper exact: needs two particles along an insulated axis");
    double *g = NULL;
    if (a->g) {
        g = xcalloc(a->n, sizeof *g);
        operator_store(a, a->g, g);
        transform(l, g, 0);
    }
    transform(l, T, 0);
    advance_modes(a, t, T, g);
    transform(l, T, 1);
    *bytes += (g ? 2 : 1) * a->n * sizeof *T;
    free(g);
    return STATUS_OK;
}
