/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hot loops against their definition, and the same bits for any sharing, width of vectors and threads. */

#include "solver/space/assembly.h"
#include "solver/sweep/state.h"
#include "solver/sweep/sweep.h"
#include "solver/sweep/wavefront.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <stdlib.h>
#include <string.h>

extern const struct method method_brookshaw, method_fo_ssph, method_so_ssph;

/* ---- sweeps ---- */

enum { UPDATES = 19 }; /* two full sweeps and a part of one */

struct made {
    struct problem p;
    struct heat_operator a;
    double *Y[2], *Y0;
    struct update u[UPDATES];
};

/* Any numbers, the same in every run; in (-1, 1). */
static double noise(size_t i) {
    return sin(12.9898 * (double)i + 78.233 * sin((double)i));
}

static double *any_state(const struct heat_operator *a, size_t seed) {
    double *T = xcalloc(a->n, sizeof *T), *state = xcalloc(a->state, sizeof *state);
    for (size_t i = 0; i < a->n; i++) T[i] = noise(i + seed);
    state_load(a, T, state);
    free(T);
    return state;
}

/* plain: Euler steps of the homogeneous problem; otherwise every term of an update. */
static void make(struct made *m, struct problem p, struct options o, const struct method *method, int plain) {
    struct lattice l;
    struct failure why;
    m->p = p;
    assert_int_equal(layout_lattice(&m->p, &o, &l, &why), STATUS_OK);
    if (operator_create_lattice(&m->a, &m->p, &o, method->scheme, &l, &why)) fail_msg("%s", why.text);
    if (plain) {
        if (m->a.g) m->a.bytes -= m->a.state * sizeof *m->a.g;
        free(m->a.g);
        m->a.g = NULL;
    }
    m->Y[0] = any_state(&m->a, 0), m->Y[1] = any_state(&m->a, 1000003);
    m->Y0 = any_state(&m->a, 2000003);
    double bound = operator_bound(&m->a);
    for (int k = 0; k < UPDATES; k++) {
        m->u[k] = (struct update){.rate = (1 + 0.1 * k) / (2 * bound), .self = 1};
        if (!plain)
            m->u[k] = (struct update){.rate = (1 + 0.1 * k) / (4 * bound),
                                      .self = 0.83,
                                      .old = -0.21,
                                      .start = 0.17 + 0.01 * k,
                                      .Y0 = k % 5 ? m->Y0 : NULL};
    }
}

static void made_free(struct made *m) {
    for (int k = 0; k < 2; k++) free(m->Y[k]);
    free(m->Y0);
    operator_free(&m->a);
}

/* ---- The definition ---- */

/* The value at a place that may be outside: the ghosts of layout.h, one axis after the other. */
static double value_at(const struct heat_operator *a, const double *x, const int place[DIM_MAX]) {
    const struct lattice *l = &a->lattice;
    for (int d = 0; d < DIM_MAX; d++) {
        int high = place[d] >= l->n[d], side = 2 * d + high, k = high ? place[d] - l->n[d] + 1 : -place[d];
        if (k <= 0) continue;
        int at[DIM_MAX] = {place[0], place[1], place[2]}, out = high ? 1 : -1;
        if (l->sign[side] == LAYOUT_RECURRENCE) {
            at[d] -= out;
            double beside = value_at(a, x, at), f = l->factor[side];
            if (k == 1) return f * beside;
            at[d] = high ? l->n[d] - k : k - 1;
            double source = value_at(a, x, at);
            at[d] += out;
            return f * (beside + source) - value_at(a, x, at);
        }
        int from = k - 1 + l->shift[side];
        if (from < 0 || l->sign[side] == 0) return 0;
        at[d] = high ? l->n[d] - 1 - from : from;
        return l->sign[side] * value_at(a, x, at);
    }
    return x[operator_place(a, place[1], place[2]) + place[0]];
}

static double applied(const struct heat_operator *a, const double *x, int i, int j, int k) {
    double sum = 0;
    for (int n = -a->reach[2]; n <= a->reach[2]; n++)
        for (int m = -a->reach[1]; m <= a->reach[1]; m++)
            for (int l = -a->reach[0]; l <= a->reach[0]; l++) {
                double w = a->weight[operator_offset(a->reach, abs(l), abs(m), abs(n))];
                if (w != 0) sum += w * value_at(a, x, (const int[]){i + l, j + m, k + n});
            }
    return sum;
}

static void define(const struct heat_operator *a, const struct update *u, const double *x, double *y) {
    for (int k = 0; k < a->lattice.n[2]; k++)
        for (int j = 0; j < a->lattice.n[1]; j++)
            for (int i = 0; i < a->lattice.n[0]; i++) {
                ptrdiff_t here = operator_place(a, j, k) + i;
                double sum = applied(a, x, i, j, k) + (a->g ? a->g[here] : 0);
                y[here] = u->rate * sum + u->self * x[here] + u->old * y[here] + (u->Y0 ? u->start * u->Y0[here] : 0);
            }
}

static void assert_defined(struct problem p, struct options o, const struct method *method, int plain) {
    struct made m, want;
    make(&m, p, o, method, plain);
    make(&want, p, o, method, plain);
    state_update(&m.a, m.u, UPDATES, m.Y);
    for (int k = 0; k < UPDATES; k++) define(&want.a, &want.u[k], want.Y[k % 2], want.Y[1 - k % 2]);
    double *got = xcalloc(m.a.n, sizeof *got), *wanted = xcalloc(m.a.n, sizeof *wanted), largest = 1;
    state_store(&m.a, m.Y[0], got);
    state_store(&m.a, want.Y[UPDATES % 2], wanted);
    for (size_t i = 0; i < m.a.n; i++) largest = fmax(largest, fabs(wanted[i]));
    /* each update rounds a sum of as many terms as the stencil has weights, and no update here makes noise grow */
    for (size_t i = 0; i < m.a.n; i++) assert_near(got[i], wanted[i], 1e-13 * largest);
    free(got);
    free(wanted);
    made_free(&m);
    made_free(&want);
}

/* h/dx for every stencil with a loop of its own, and for some without: a rod, the plane, a box; ended by 0. */
static const double widths[][11] = {{0.9, 1.05, 1.6, 2.2, 30.1}, /* the last reaches 60 particles */
                                    {0.9, 1.05, 1.23, 1.45, 1.55, 1.62, 2, 2.11, 2.2, 2.6},
                                    {0.72, 0.9, 1.1, 1.15, 1.3}}; /* 19, 27, 33 and 57 points */
static const double spacings[] = {0.01, 0.05, 0.1};

static struct problem odd_body(int dim) {
    return dim == 1 ? odd_rod() : dim == 2 ? odd_rectangle() : odd_box();
}

static void sweeps_equal_their_definition(void **state) {
    (void)state;
    for (int dim = 1; dim <= 3; dim++)
        for (const double *h = widths[dim - 1]; *h > 0; h++)
            for (int walls = 0; walls < (*h > 3 ? 1 : 4); walls++) {
                struct problem p = odd_body(dim);
                struct options o = {.dx = spacings[dim - 1], .h = *h};
                o.layout = walls == 1 ? LAYOUT_NODE : LAYOUT_LATTICE;
                o.walls = walls == 2 ? WALLS_FIXED : WALLS_MIRROR;
                if (walls == 1) p.side[X_HI] = p.side[Z_LO] = NEUMANN, p.side[Y_LO] = DIRICHLET;
                for (int s = 1; s < 2 * dim && walls == 3; s += 2) p.side[s] = ROBIN, p.robin[s] = 0.3 * s;
                for (int plain = 0; plain < 2; plain++) assert_defined(p, o, &method_so_ssph, plain);
            }
}

static void other_stencils_equal_their_definition(void **state) {
    (void)state;
    struct problem isotropic = odd_box();
    for (int a = 0; a < 3; a++) isotropic.material[0].k[a] = 0.7;
    for (int plain = 0; plain < 2; plain++) {
        assert_defined(odd_rectangle(), (struct options){.dx = 0.05, .h = plain ? 1.23 : 1.05}, &method_fo_ssph,
                       plain);
        assert_defined(isotropic, (struct options){.dx = 0.1, .h = 0.7}, &method_brookshaw, plain); /* 7 points */
        assert_defined(odd_box(), (struct options){.dx = 0.1, .h = 1.1}, &method_fo_ssph, plain);
        assert_defined(odd_box(), (struct options){.dx = 0.1, .h = 2.2, .order = 4}, &method_so_ssph, plain);
    }
}

/* ---- The same bits ---- */

static void assert_same_bits(const struct made *got, const struct made *want) {
    double *a = xcalloc(got->a.n, sizeof *a), *b = xcalloc(want->a.n, sizeof *b);
    state_store(&got->a, got->Y[0], a);
    state_store(&want->a, want->Y[0], b);
    assert_memory_equal(a, b, got->a.n * sizeof *a);
    free(a);
    free(b);
}

/* One update at a time against all in one call, for threads (the last: as many as there are slabs) and widths of
 * vectors. */
static void sharing_changes_no_bit(void **state) {
    (void)state;
    static const int threads[] = {1, 2, 7, 1000};
    for (int dim = 2; dim <= 3; dim++)
        for (const double *h = widths[dim - 1]; *h > 0; h++)
            for (int plain = 0; plain < 2; plain++) {
                struct options o = {.dx = dim == 2 ? 0.02 : 0.05, .h = *h, .lanes = 2};
                struct made apart;
                make(&apart, odd_body(dim), o, &method_so_ssph, plain);
                for (int k = 0; k < UPDATES; k++) state_update(&apart.a, &apart.u[k], 1, apart.Y);
                for (o.lanes = 2; o.lanes <= options_lanes_most(); o.lanes *= 2)
                    for (size_t t = 0; t < sizeof threads / sizeof *threads; t++) {
                        struct made m;
                        make(&m, odd_body(dim), o, &method_so_ssph, plain);
                        m.a.threads = threads[t];
                        assert_int_equal(m.a.lanes, o.lanes);
                        state_update(&m.a, m.u, UPDATES, m.Y);
                        assert_same_bits(&m, &apart);
                        made_free(&m);
                    }
                made_free(&apart);
            }
}

/* ---- Rods with rows: bands ---- */

/* As make, off the lattice. */
static void make_rows(struct made *m, struct problem p, struct options o) {
    struct lattice l;
    struct cloud c;
    struct failure why;
    *m = (struct made){.p = p};
    assert_int_equal(layout_lattice(&m->p, &o, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&m->p, &o, &l, 2 * o.h * l.dx[0], &c, &why), STATUS_OK);
    assert_int_equal(assembly_operator(&m->a, &m->p, &o, method_so_ssph.scheme, &c, l.dx[0], &why), STATUS_OK);
    layout_cloud_free(&c);
    m->Y[0] = any_state(&m->a, 0), m->Y[1] = any_state(&m->a, 1000003), m->Y0 = any_state(&m->a, 2000003);
    for (int k = 0; k < UPDATES; k++) {
        double rate = (1 + 0.1 * k) / (4 * operator_bound(&m->a));
        m->u[k] = (struct update){rate, 0.83, -0.21, 0.17 + 0.01 * k, k % 5 ? m->Y0 : NULL};
        if (k % 7 == 6) m->u[k] = (struct update){.rate = rate, .self = 1};
    }
}

static void define_rows(const struct heat_operator *a, const struct update *u, const double *x, double *y) {
    for (size_t i = 0; i < a->n; i++) {
        double sum = (a->g ? a->g[i] : 0) + a->diagonal[i] * x[i];
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++) sum += a->value[k] * x[a->column[k]];
        y[i] = u->rate * sum + u->self * x[i] + u->old * y[i] + (u->Y0 ? u->start * u->Y0[i] : 0);
    }
}

/* 300 particles: two stretches of a shared sweep, and ends that no vector fits. */
static void banded_rows_equal_csr_rows(void **state) {
    (void)state;
    struct options o = {.dx = 0.005, .h = 1.6, .layout = LAYOUT_JITTER, .jitter = 0.3, .seed = 3, .lanes = 2};
    struct made want, two, apart, wide;
    make_rows(&want, odd_rod(), o);
    make_rows(&two, odd_rod(), o);
    make_rows(&apart, odd_rod(), o);
    assert_non_null(two.a.banded);
    assert_in_range(two.a.band, 3, 4);
    state_update(&two.a, two.u, UPDATES, two.Y);
    for (int k = 0; k < UPDATES; k++) define_rows(&want.a, &want.u[k], want.Y[k % 2], want.Y[1 - k % 2]);
    for (size_t i = 0; i < want.a.n; i++) assert_near(two.Y[0][i], want.Y[UPDATES % 2][i], 1e-13);
    for (int k = 0; k < UPDATES; k++) state_update(&apart.a, &apart.u[k], 1, apart.Y);
    assert_same_bits(&apart, &two);
    for (o.lanes = 4; o.lanes <= options_lanes_most(); o.lanes *= 2) {
        make_rows(&wide, odd_rod(), o);
        state_update(&wide.a, wide.u, UPDATES, wide.Y);
        assert_same_bits(&wide, &two);
        made_free(&wide);
    }
    made_free(&want);
    made_free(&two);
    made_free(&apart);
}

/* A cloud of the plane: several stretches and slabs, and more threads than slabs that could share a sweep. */
static void fused_updates_of_rows_equal_single_updates(void **state) {
    (void)state;
    static const int threads[] = {1, 2, 3, 40};
    struct options o = {.dx = 0.02, .h = 1.2, .layout = LAYOUT_JITTER, .jitter = 0.2, .seed = 3};
    struct made apart;
    make_rows(&apart, odd_rectangle(), o);
    assert_null(apart.a.banded);
    assert_order(apart.a.n, >, 10 * (size_t)apart.a.band);
    for (int k = 0; k < UPDATES; k++) state_update(&apart.a, &apart.u[k], 1, apart.Y);
    for (size_t k = 0; k < sizeof threads / sizeof *threads; k++) {
        struct made many;
        make_rows(&many, odd_rectangle(), o);
        many.a.threads = threads[k];
        state_update(&many.a, many.u, UPDATES, many.Y);
        assert_same_bits(&many, &apart);
        made_free(&many);
    }
    made_free(&apart);
}

/* ---- wavefronts ---- */

enum { UNITS = 97, WAVES = 19 };

struct record {
    int lag, wrong;
    int done[UNITS]; /* updates that a unit has had */
};

/* Two alternating states: update k reads the values of update k - 1 within the lag, which update k + 1
 * overwrites. */
static void advance(const void *what, int k, ptrdiff_t lo, ptrdiff_t hi) {
    struct record *r = *(struct record *const *)what;
    for (ptrdiff_t i = lo; i < hi; i++) {
        for (ptrdiff_t j = i - r->lag; j <= i + r->lag; j++)
            if (j >= 0 && j < UNITS && (r->done[j] < k || r->done[j] > k + 1)) r->wrong++;
        if (i < 0 || i >= UNITS || r->done[i]++ != k) r->wrong++;
    }
}

static void wavefront_applies_updates_in_order(void **state) {
    (void)state;
    for (int lag = 0; lag <= 4; lag += 2)
        for (int band = 1; band <= 8; band += 7)
            for (int together = 1; together <= 8; together += 7)
                for (int threads = 1; threads <= 3; threads++) {
                    struct record r = {.lag = lag}, *kept = &r;
                    struct wavefront w = {advance, &kept, UNITS, lag, band, together, threads};
                    wavefront_sweep(&w, 0);
                    wavefront_sweep(&w, WAVES);
                    assert_int_equal(r.wrong, 0);
                    for (int i = 0; i < UNITS; i++) assert_int_equal(r.done[i], WAVES);
                }
}

/* Sets each unit to one fourth of the smallest normal number. */
static void quarter(const void *what, int k, ptrdiff_t lo, ptrdiff_t hi) {
    volatile double least = 2.3e-308;
    double *const *part = what;
    (void)k;
    for (ptrdiff_t i = lo; i < hi; i++) (*part)[i] = least / 4;
}

static void subnormal_numbers_are_zero_in_a_sweep(void **state) {
    (void)state;
#ifdef __SSE2__
    for (int threads = 1; threads <= 3; threads++) {
        double part[UNITS], *parts = part, after;
        volatile double least = 2.3e-308;
        for (int i = 0; i < UNITS; i++) part[i] = 1;
        struct wavefront w = {quarter, &parts, UNITS, 2, 8, 8, threads};
        wavefront_sweep(&w, WAVES);
        for (int i = 0; i < UNITS; i++) assert_true(part[i] == 0);
        after = least / 4;
        assert_order(after, >, 0); /* in a sweep alone */
    }
#else
    skip();
#endif
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sweeps_equal_their_definition),
        cmocka_unit_test(other_stencils_equal_their_definition),
        cmocka_unit_test(sharing_changes_no_bit),
        cmocka_unit_test(banded_rows_equal_csr_rows),
        cmocka_unit_test(fused_updates_of_rows_equal_single_updates),
        cmocka_unit_test(wavefront_applies_updates_in_order),
        cmocka_unit_test(subnormal_numbers_are_zero_in_a_sweep),
    };
    return cmocka_run_group_tests_name("sweep", tests, NULL, NULL);
}
