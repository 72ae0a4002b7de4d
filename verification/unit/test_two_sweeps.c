/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of two sweeps against their definition: the derivatives of all points, then the divergence of the flux; and
 * the conjugate pair, symmetric and never growing. */
#include "solver/space/assembly.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <stdlib.h>

extern const struct method method_fo_ssph, method_flux_divergence, method_conjugate;

static const struct options jittered = {.dx = 0.075, .h = 1.23, .seed = 7, .layout = LAYOUT_JITTER, .jitter = 0.31};

static void assemble(const struct problem *p, const struct options *o, const struct scheme *s, struct cloud *c,
                     struct heat_operator *a) {
    struct lattice l;
    struct failure why;
    if (layout_lattice(p, o, &l, &why) || layout_cloud(p, o, &l, 4 * o->h * l.dx[0], c, &why) ||
        assembly_operator(a, p, o, s, c, l.dx[0], &why))
        fail_msg("%s", why.text);
}

/* sum_j w_a (f_j - sign f_i) over the neighbours of point i. */
static void differ(const struct assembly *m, size_t i, const double *f[2], double sign, double out[2]) {
    struct surroundings *at = xcalloc(1, sizeof *at);
    double weight[2][NEIGHBOURS_MAX], *w[2] = {weight[0], weight[1]};
    struct failure why;
    if (assembly_neighbourhood(m, i, at, &why) || operator_weights(m->s, m->p, m->o, &at->nb, w, &why))
        fail_msg("%s", why.text);
    for (int a = 0; a < 2; a++) {
        out[a] = 0;
        for (size_t k = 0; k < at->nb.n; k++) out[a] += w[a][k] * (f[a][at->near[k]] - sign * f[a][i]);
    }
    free(at);
}

static void composed_rows_equal_two_sweeps(void **state) {
    (void)state;
    const struct method *const all[] = {&method_fo_ssph, &method_flux_divergence, &method_conjugate};
    struct problem p = odd_rectangle();
    p.side[X_HI] = ROBIN, p.robin[X_HI] = 1.7;
    for (int k = 0; k < 3; k++) {
        const struct scheme *s = all[k]->scheme;
        struct cloud c;
        struct heat_operator a;
        struct assembly m;
        struct failure why;
        assemble(&p, &jittered, s, &c, &a);
        assert_int_equal(assembly_create(&m, &p, &jittered, s, &c, jittered.dx, &why), STATUS_OK);
        double *T = xcalloc(c.total, sizeof *T), *q[2], d[2], bound = operator_bound(&a);
        for (size_t i = 0; i < c.n; i++) T[i] = sin(0.37 * (double)(i * i % 101));
        for (size_t i = c.n; i < c.total; i++) T[i] = c.factor[i] * T[c.source[i]] + c.offset[i];
        for (int axis = 0; axis < 2; axis++) q[axis] = xcalloc(c.total, sizeof *q[axis]);
        for (size_t i = 0; i < c.total; i++) {
            double beyond = fmax(fmax(p.lo[0] - c.x[i], c.x[i] - p.hi[0]), fmax(p.lo[1] - c.y[i], c.y[i] - p.hi[1]));
            if (beyond > 2 * jittered.h * jittered.dx) continue; /* no particle needs it */
            differ(&m, i, (const double *[2]){T, T}, 1, d);
            for (int axis = 0; axis < 2; axis++) q[axis][i] = p.material[0].k[axis] / p.material[0].rho_c * d[axis];
        }
        for (size_t i = 0; i < a.n; i++) {
            double sum = (a.g ? a.g[i] : 0) + a.diagonal[i] * T[i];
            for (size_t j = a.row[i]; j < a.row[i + 1]; j++) sum += a.value[j] * T[a.column[j]];
            differ(&m, i, (const double *[2]){q[0], q[1]}, s->adjoint ? -1 : 1, d);
            assert_near(sum, d[0] + d[1], 1e-13 * bound);
        }
        free(T), free(q[0]), free(q[1]);
        assembly_free(&m);
        operator_free(&a);
        layout_cloud_free(&c);
    }
}

static double no_flux(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

/* Between insulated walls A is symmetric to rounding, with no eigenvalue above 0. */
static void the_conjugate_pair_is_symmetric_and_never_grows(void **state) {
    (void)state;
    static const double jitter[] = {0, 0.1, 0.5};
    for (int k = 0; k < 3; k++) {
        struct problem p = odd_rectangle();
        struct options o = jittered;
        struct cloud c;
        struct heat_operator a;
        o.dx = 0.15, o.jitter = jitter[k];
        for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
        p.wall = no_flux, p.hi[0] = p.lo[0] + 1.5;
        assemble(&p, &o, method_conjugate.scheme, &c, &a);
        double *A = xcalloc(a.n * a.n, sizeof *A), bound = operator_bound(&a), *lambda = xcalloc(a.n, sizeof *lambda);
        operator_dense(&a, A);
        for (size_t i = 0; i < a.n * a.n; i++) A[i] /= bound;
        for (size_t i = 0; i < a.n; i++)
            for (size_t j = 0; j < i; j++) assert_near(A[i * a.n + j], A[j * a.n + i], 1e-14);
        gsl_matrix_view M = gsl_matrix_view_array(A, a.n, a.n);
        gsl_vector_view values = gsl_vector_view_array(lambda, a.n);
        gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(a.n);
        gsl_eigen_symm(&M.matrix, &values.vector, work);
        gsl_eigen_symm_free(work);
        for (size_t i = 0; i < a.n; i++) assert_order(lambda[i], <, 1e-13);
        free(A), free(lambda);
        operator_free(&a);
        layout_cloud_free(&c);
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(composed_rows_equal_two_sweeps),
        cmocka_unit_test(the_conjugate_pair_is_symmetric_and_never_grows),
    };
    return cmocka_run_group_tests_name("two_sweeps", tests, NULL, NULL);
}
