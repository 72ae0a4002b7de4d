/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Eigenvalues of an operator with rows.  GSL balances, reduces to Hessenberg form and applies QR steps (Golub & Van
 * Loan 7.5).  The computed eigenvalues are exact for a matrix within eps n |A| of A.  For a symmetric operator their
 * error has the same bound; for a highly non-normal one it is larger, so a real part just above zero is not
 * significant.  The bound below is 100 eps sqrt(n) radius. */
#include "verification/stability/spectrum.h"

#include <float.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>

double spectrum_rounding(const struct spectrum *s) {
    return 100 * DBL_EPSILON * sqrt((double)s->n) * s->radius;
}

static void summarise(struct spectrum *s, const struct amplification *step) {
    double reach = amplification_reach(step);
    s->limit = INFINITY, s->growth = -INFINITY;
    for (size_t i = 0; i < s->n; i++) {
        s->radius = fmax(s->radius, cabs(s->lambda[i]));
        s->growth = fmax(s->growth, creal(s->lambda[i]));
        s->twist = fmax(s->twist, fabs(cimag(s->lambda[i])));
    }
    for (size_t i = 0; i < s->n; i++)
        if (cabs(s->lambda[i]) > spectrum_rounding(s))
            s->limit = fmin(s->limit, amplification_limit(step, reach, s->lambda[i]));
}

int spectrum_create(struct spectrum *s, const struct heat_operator *a, const struct amplification *step,
                    struct failure *why) {
    *s = (struct spectrum){.n = a->n};
    if (a->weight || a->n > SPECTRUM_MAX)
        return refuse(why, STATUS_INPUT, "%zu particles: all eigenvalues can be computed for at most %d, with rows",
                      a->n, SPECTRUM_MAX);
    gsl_matrix *m = gsl_matrix_alloc(a->n, a->n); /* rows without padding */
    operator_dense(a, m->data);
    s->lambda = xcalloc(a->n, sizeof *s->lambda); /* two doubles each, the layout of GSL (C11, 6.2.5) */
    gsl_vector_complex_view value = gsl_vector_complex_view_array((double *)s->lambda, a->n);
    gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(a->n);
    gsl_eigen_nonsymm_params(0, 1, work);
    int status = gsl_eigen_nonsymm(m, &value.vector, work);
    gsl_eigen_nonsymm_free(work);
    gsl_matrix_free(m);
    if (!status) summarise(s, step);
    if (status || !isfinite(s->radius)) {
        spectrum_free(s);
        return refuse(why, STATUS_NUMERICAL, "the eigenvalues of %zu particles did not converge", a->n);
    }
    return STATUS_OK;
}

void spectrum_free(struct spectrum *s) {
    free(s->lambda);
    *s = (struct spectrum){0};
}
