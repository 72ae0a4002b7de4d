/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particles on box lattices: sweeps and ghosts against their definition, the same bits for any sharing. */

#include "solver/sweep/state.h"
#include "solver/sweep/sweep.h"
#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <stdlib.h>

extern const struct method method_brookshaw, method_fo_ssph, method_so_ssph;

enum { UPDATES = 11 }; /* a full sweep and a part of one */

struct made {
    struct problem p;
    struct heat_operator a;
    double *Y[2], *Y0;
    struct update u[UPDATES];
};

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
    if (layout_lattice(&m->p, &o, &l, &why) || operator_create_lattice(&m->a, &m->p, &o, method->scheme, &l, &why))
        fail_msg("%s", why.text);
    if (plain) {
        free(m->a.g);
        m->a.g = NULL;
    }
    m->Y[0] = any_state(&m->a, 0), m->Y[1] = any_state(&m->a, 1000003);
    m->Y0 = any_state(&m->a, 2000003);
    double bound = operator_bound(&m->a);
    for (int k = 0; k < UPDATES; k++) {
        m->u[k] = (struct update){.rate = (1 + 0.1 * k) / (2 * bound), .self = 1};
        if (!plain)
            m->u[k] =
                (struct update){(1 + 0.1 * k) / (4 * bound), 0.83, -0.21, 0.17 + 0.01 * k, k % 5 ? m->Y0 : NULL};
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

/* h/dx with 19, 27, 33 and 57 points, and one without a loop of its own. */
static const double widths[] = {0.72, 0.9, 1.1, 1.15, 1.3};

static void box_sweep_equals_its_definition(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++)
        for (int walls = 0; walls < 4; walls++) {
            struct problem p = odd_box();
            struct options o = {.dx = 0.1, .h = widths[k]};
            o.layout = walls == 1 ? LAYOUT_NODE : LAYOUT_LATTICE;
            o.walls = walls == 2 ? WALLS_FIXED : WALLS_MIRROR;
            if (walls == 1) p.side[X_HI] = p.side[Z_LO] = NEUMANN, p.side[Y_LO] = DIRICHLET;
            for (int s = 1; s < SIDES && walls == 3; s += 2) p.side[s] = ROBIN, p.robin[s] = 0.3 * s;
            assert_defined(p, o, &method_so_ssph, 0);
            assert_defined(p, o, &method_so_ssph, 1);
        }
}

static struct problem isotropic_box(void) {
    struct problem p = odd_box();
    for (int a = 0; a < p.dim; a++) p.material[0].k[a] = 0.7;
    return p;
}

static void other_stencils_equal_their_definition(void **state) {
    (void)state;
    for (int plain = 0; plain < 2; plain++) {
        assert_defined(isotropic_box(), (struct options){.dx = 0.1, .h = 0.7}, &method_brookshaw,
                       plain); /* 7 points */
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

/* One update at a time against all in one call, for threads and widths of vectors. */
static void sharing_changes_no_bit(void **state) {
    (void)state;
    static const int threads[] = {1, 2, 3, 1000};
    for (size_t h = 0; h < sizeof widths / sizeof *widths; h++)
        for (int plain = 0; plain < 2; plain++) {
            struct options o = {.dx = 0.05, .h = widths[h], .lanes = 2};
            struct made apart;
            make(&apart, odd_box(), o, &method_so_ssph, plain);
            for (int k = 0; k < UPDATES; k++) state_update(&apart.a, &apart.u[k], 1, apart.Y);
            for (o.lanes = 2; o.lanes <= options_lanes_most(); o.lanes *= 2)
                for (size_t t = 0; t < sizeof threads / sizeof *threads; t++) {
                    struct made m;
                    make(&m, odd_box(), o, &method_so_ssph, plain);
                    m.a.threads = threads[t];
                    state_update(&m.a, m.u, UPDATES, m.Y);
                    assert_same_bits(&m, &apart);
                    made_free(&m);
                }
            made_free(&apart);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_sweep_equals_its_definition),
        cmocka_unit_test(other_stencils_equal_their_definition),
        cmocka_unit_test(sharing_changes_no_bit),
    };
    return cmocka_run_group_tests_name("box", tests, NULL, NULL);
}
