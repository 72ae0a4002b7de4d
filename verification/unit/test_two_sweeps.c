/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two sweeps of first derivatives: pairs that do not depend on threads, updates that are their definition to the bit
 * for any number of them, and the rows that they stand for. */
#include "solver/space/csr.h"
#include "solver/space/gradient.h"
#include "solver/sweep/state.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

extern const struct method method_fo_ssph, method_flux_divergence, method_conjugate;

static double no_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 0;
}

/* *a on a cloud of its own; ended by operator_free. */
static void assemble(const struct problem *p, const struct options *o, const struct method *m,
                     struct heat_operator *a) {
    struct lattice l;
    struct cloud c;
    struct failure why;
    assert_int_equal(layout_lattice(p, o, 1, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(p, o, &l, 4 * o->h * l.dx[0], &c, &why), STATUS_OK);
    assert_int_equal(operator_create_csr(a, p, o, m->scheme, &c, l.dx[0], &why), STATUS_OK);
    layout_cloud_free(&c);
}

/* Two sweeps, by one thread and by three. */
static void threads_change_no_pair(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05, .h = 1.23, .seed = 7, .layout = LAYOUT_JITTER, .jitter = 0.31};
    struct heat_operator a, b;
    assemble(&p, &o, &method_flux_divergence, &a);
    o.threads = 3;
    assemble(&p, &o, &method_flux_divergence, &b);
    const struct gradient *of[2] = {a.gradient, b.gradient};
    size_t points = of[0]->total;
    assert_memory_equal(of[0]->kept, of[1]->kept, (points + 1) * sizeof *of[0]->kept);
    assert_memory_equal(of[0]->other, of[1]->other, of[0]->kept[points] * sizeof *of[0]->other);
    assert_memory_equal(of[0]->F, of[1]->F, of[0]->kept[points] * sizeof *of[0]->F);
    assert_memory_equal(of[0]->C, of[1]->C, 3 * points * sizeof *of[0]->C);
    assert_memory_equal(of[0]->pair, of[1]->pair, of[0]->lent[points] * sizeof *of[0]->pair);
    operator_free(&a);
    operator_free(&b);
}

/* A quarter of the least number that is held in full is zero, in a sweep alone. */
static void what_no_temperature_needs_is_zero(void **state) {
    (void)state;
#ifdef __SSE2__
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05, .h = 1.23, .seed = 7, .layout = LAYOUT_JITTER, .jitter = 0.31};
    struct heat_operator a;
    assemble(&p, &o, &method_flux_divergence, &a);
    double *Y[2] = {xcalloc(a.state, sizeof(double)), xcalloc(a.state, sizeof(double))};
    volatile double least = 2.3e-308;
    for (size_t i = 0; i < a.n; i++) Y[0][i] = least;
    state_update(&a, &(struct update){.rate = 0, .self = 0.25}, 1, Y);
    for (size_t i = 0; i < a.n; i++) assert_true(Y[0][i] == 0);
    assert_order(least / 4, >, 0);
    free(Y[0]), free(Y[1]);
    operator_free(&a);
#else
    skip();
#endif
}

/* ---- The definition: fluxes of all points, then what flows in; sums in the order of the pairs ---- */

/* From point i to the other point of its pair number k, kept ones first: which, d in m, and F. */
static size_t pair_of(const struct gradient *g, size_t i, uint32_t k, double d[2], double *F) {
    uint32_t kept = g->kept[i + 1] - g->kept[i], at = k < kept ? g->kept[i] + k : g->lent[i] + k - kept;
    size_t j = k < kept ? g->other[at] : g->keeper[at];
    *F = g->F[k < kept ? at : g->pair[at]];
    for (size_t axis = 0; axis < 2; axis++) d[axis] = g->place[2 * j + axis] - g->place[2 * i + axis];
    return j;
}

static uint32_t pairs_of(const struct gradient *g, size_t i) {
    return g->kept[i + 1] - g->kept[i] + g->lent[i + 1] - g->lent[i];
}

static void define(const struct heat_operator *a, const struct update *u, double *x, double *y) {
    const struct gradient *g = a->gradient;
    double *q = xcalloc(2 * g->total, sizeof *q), d[2], F;
    for (size_t k = 0; k < g->total - a->n; k++) x[a->n + k] = g->factor[k] * x[g->source[k]] + g->offset[k];
    for (size_t i = 0; i < g->total; i++) {
        double sum[2] = {0, 0}, *C = &g->C[3 * i];
        for (uint32_t k = 0; k < pairs_of(g, i); k++) {
            size_t j = pair_of(g, i, k, d, &F);
            double slope = F * (x[j] - x[i]);
            sum[0] += slope * d[0], sum[1] += slope * d[1];
        }
        q[2 * i] = g->kappa[0] * (C[0] * sum[0] + C[1] * sum[1]);
        q[2 * i + 1] = g->kappa[1] * (C[1] * sum[0] + C[2] * sum[1]);
    }
    for (size_t i = 0; i < a->n; i++) {
        double sum[3] = {0, 0, 0}, *C = &g->C[3 * i];
        for (uint32_t k = 0; k < pairs_of(g, i); k++) {
            size_t j = pair_of(g, i, k, d, &F);
            double qx = q[2 * j] - q[2 * i], qy = q[2 * j + 1] - q[2 * i + 1];
            double Fx = F * d[0], Fy = F * d[1];
            sum[0] += Fx * qx, sum[1] += Fy * qx + Fx * qy, sum[2] += Fy * qy;
        }
        double rate = C[0] * sum[0] + C[1] * sum[1] + C[2] * sum[2];
        if (a->g) rate += a->g[i];
        y[i] = u->rate * rate + u->self * x[i] + u->old * y[i];
        if (u->Y0) y[i] += u->start * u->Y0[i];
    }
    free(q);
}

enum { UPDATES = 4 };

/* The state after UPDATES of a, by definition or as it is done; n of the particles, to be freed. */
static double *updated(const struct heat_operator *a, int defined) {
    double *Y[2] = {xcalloc(a->state, sizeof(double)), xcalloc(a->state, sizeof(double))};
    double *start = xcalloc(a->n, sizeof *start), rate = 0.1 / operator_bound(a);
    struct update u[UPDATES];
    for (int k = 0; k < UPDATES; k++)
        u[k] = (struct update){rate * (1 + 0.1 * k), 0.83, -0.21, 0.17 + 0.01 * k, k % 2 ? start : NULL};
    for (size_t i = 0; i < a->n; i++) {
        Y[0][i] = sin(0.37 * (double)(i * i % 101)), Y[1][i] = cos(0.53 * (double)(i * i % 89));
        start[i] = sin(0.71 * (double)(i * i % 97));
    }
    if (defined)
        for (int k = 0; k < UPDATES; k++) define(a, &u[k], Y[k % 2], Y[1 - k % 2]);
    else
        state_update(a, u, UPDATES, Y);
    free(Y[1]), free(start);
    return Y[0];
}

/* A plane, and a strip where pairs reach further than a thread's share of it. */
static void no_thread_changes_a_bit(void **state) {
    (void)state;
    static const int threads[] = {1, 2, 3, 16};
    for (int strip = 0; strip < 2; strip++) {
        struct problem p = odd_rectangle();
        struct options o = {.dx = 0.01, .h = 1.23, .seed = 7, .layout = LAYOUT_JITTER, .jitter = 0.2};
        struct heat_operator a;
        if (strip) p.hi[0] = p.lo[0] + 15, p.hi[1] = p.lo[1] + 0.08;
        assemble(&p, &o, &method_fo_ssph, &a);
        assert_order(a.n, >, 10000);
        assert_int_equal(a.gradient->reach > a.n / 2, strip);
        double *want = updated(&a, 1);
        for (int t = 0; t < 4; t++) {
            a.threads = threads[t];
            memset(a.gradient->flux, -1, 2 * a.gradient->total * sizeof(double)); /* NaN: none is older than a step */
            double *got = updated(&a, 0);
            assert_memory_equal(got, want, a.n * sizeof *got);
            free(got);
        }
        free(want);
        operator_free(&a);
    }
}

/* What two sweeps make of a state, walls of all kinds among them, and the rows that they stand for. */
static void two_sweeps_are_their_rows(void **state) {
    (void)state;
    const struct method *const both_of[] = {&method_flux_divergence, &method_fo_ssph, &method_conjugate};
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05, .h = 1.23, .seed = 7, .layout = LAYOUT_JITTER, .jitter = 0.31};
    struct heat_operator a;
    struct row r;
    p.wall = no_flux;
    p.source = NULL;
    p.side[X_LO] = DIRICHLET, p.side[X_HI] = ROBIN, p.robin[X_HI] = 1.7, p.side[Y_LO] = NEUMANN;
    for (int m = 0; m < 3; m++) {
        assemble(&p, &o, both_of[m], &a);
        double *Y[2] = {xcalloc(a.state, sizeof(double)), xcalloc(a.state, sizeof(double))},
               bound = operator_bound(&a);
        double *x = xcalloc(a.n, sizeof *x);
        for (size_t i = 0; i < a.n; i++) Y[0][i] = x[i] = sin(0.37 * (double)(i * i % 101));
        state_update(&a, &(struct update){.rate = 1}, 1, Y);
        csr_row_create(&r, a.n);
        for (size_t i = 0; i < a.n; i++) {
            double sum = 0;
            operator_row_take(&a, i, &r);
            for (size_t k = 0; k < r.n; k++) sum += r.value[r.column[k]] * x[r.column[k]];
            assert_near(Y[0][i], sum, 1e-13 * bound);
        }
        csr_row_free(&r);
        for (int k = 0; k < 2; k++) free(Y[k]);
        free(x);
        operator_free(&a);
    }
}

/* Multiplied out, as where walls cut the lattice: the same rows, and the same that walls add. */
static void rows_multiplied_out_are_the_same(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.05, .h = 1.23, .seed = 7, .layout = LAYOUT_JITTER, .jitter = 0.31};
    struct lattice l;
    struct cloud c;
    struct heat_operator a, b = {0};
    struct failure why;
    struct row r;
    assert_int_equal(layout_lattice(&p, &o, 1, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&p, &o, &l, 4 * o.h * l.dx[0], &c, &why), STATUS_OK);
    assert_int_equal(operator_create_csr(&a, &p, &o, method_fo_ssph.scheme, &c, l.dx[0], &why), STATUS_OK);
    b.n = b.state = c.n;
    assert_int_equal(csr_assemble(&b, &p, &o, method_fo_ssph.scheme, &c, l.dx[0], &why), STATUS_OK);
    assert_non_null(a.gradient);
    assert_null(b.gradient);
    double *Y[2] = {xcalloc(a.state, sizeof(double)), xcalloc(a.state, sizeof(double))}, bound = operator_bound(&a);
    double *x = xcalloc(a.n, sizeof *x);
    for (size_t i = 0; i < a.n; i++) Y[0][i] = x[i] = sin(0.37 * (double)(i * i % 101));
    state_update(&a, &(struct update){.rate = 1}, 1, Y);
    csr_row_create(&r, b.n);
    for (size_t i = 0; i < b.n; i++) {
        double sum = b.g ? b.g[i] : 0;
        operator_row_take(&b, i, &r);
        for (size_t k = 0; k < r.n; k++) sum += r.value[r.column[k]] * x[r.column[k]];
        assert_near(Y[0][i], sum, 1e-13 * bound);
    }
    csr_row_free(&r);
    free(Y[0]), free(Y[1]), free(x);
    layout_cloud_free(&c);
    operator_free(&a);
    operator_free(&b);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_change_no_pair),           cmocka_unit_test(what_no_temperature_needs_is_zero),
        cmocka_unit_test(no_thread_changes_a_bit),          cmocka_unit_test(two_sweeps_are_their_rows),
        cmocka_unit_test(rows_multiplied_out_are_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
