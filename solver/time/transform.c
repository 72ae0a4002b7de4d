/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sine and cosine transforms along the axes of a lattice.
 *
 * Mode k is phi_k(i) = sin or cos(theta_k s_i), odd or even about the low wall, with the distance s_i from it;
 * theta_k gives it the parity of the high wall too.  Forward: c_k = 2 sum_i w_i phi_k(i) T_i, w_i = 1/2 on an
 * insulated wall, else 1.  Backward: T_i = sum_k m_k c_k phi_k(i), m_k = 1 if phi_k^2 = 1 everywhere, else 2.  These
 * are FFTW's r2r transforms ("1d Real-even DFTs", "1d Real-odd DFTs").
 *
 * One plan for a single line is applied line by line: FFTW's unmeasured plans for many lines are up to four times
 * slower.  A pass for each axis transforms a plane or a box in place.  Plans of the first KEPT lengths are cached for
 * the life of the program, because planning a short line takes thirty times as long as its transform.  Results do not
 * depend on the cache.
 *
 * With a wall of factor f (struct lattice) the modes are, k = 0 .. n - 1,
 *
 *     phi_k(i) = cos(theta_k (i + 1/2) - psi_lo),   n theta_k = k pi + psi_lo + psi_hi,
 *     tan psi = (1 - f) / ((1 + f) tan(theta/2)) since T_-1 = f T_0.
 *
 * While theta_k grows by pi / n, the right side decreases from at most (k + 1) pi to at least k pi, so there is one
 * root for each k.  The modes are the eigenvectors of a symmetric matrix and therefore orthogonal: the n x n table
 * of modes of unit length is its own inverse. f = -1 and 1 give the sines and cosines above. */
#include "solver/time/transform.h"

#include <fftw3.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    LINES = 8, /* neighbouring lines gathered at a time: one cache line of each of their points */
    KEPT = 64
};

struct basis {
    fftw_r2r_kind kind[2]; /* forward, backward */
    double first;          /* theta_k = pi (k + first) / (n + extra) */
    int extra;
};

/* Indexed by [node layout][low side even][high side even]. */
static const struct basis bases[2][2][2] = {
    {{{{FFTW_RODFT10, FFTW_RODFT01}, 1, 0}, {{FFTW_RODFT11, FFTW_RODFT11}, 0.5, 0}},
     {{{FFTW_REDFT11, FFTW_REDFT11}, 0.5, 0}, {{FFTW_REDFT10, FFTW_REDFT01}, 0, 0}}},
    {{{{FFTW_RODFT00, FFTW_RODFT00}, 1, 1}, {{FFTW_RODFT01, FFTW_RODFT10}, 0.5, 0}},
     {{{FFTW_REDFT01, FFTW_REDFT10}, 0.5, 0}, {{FFTW_REDFT00, FFTW_REDFT00}, 0, -1}}},
};

struct axis {
    int n;
    double *mode;      /* phi_k(i) at [k n + i], of unit length; NULL if FFTW is used */
    fftw_plan plan[2]; /* forward, backward; for one line */
    int kept[2];       /* 1: in the cache, not to be destroyed */
};

struct transform {
    int dim;
    struct axis axis[DIM_MAX];
};

static const struct basis *basis_of(const struct lattice *l, int axis) {
    return &bases[l->shift[2 * axis] != 0][l->sign[2 * axis] > 0][l->sign[2 * axis + 1] > 0];
}

static int is_recurrent(const struct lattice *l, int axis) {
    return l->sign[2 * axis] == LAYOUT_RECURRENCE || l->sign[2 * axis + 1] == LAYOUT_RECURRENCE;
}

/* psi of a side */
static double phase(const struct lattice *l, int side, double theta) {
    double f = l->sign[side] == LAYOUT_RECURRENCE ? l->factor[side] : l->sign[side];
    return atan2(1 - f, (1 + f) * tan(theta / 2));
}

/* n theta_k - k pi, in [0, pi] */
static double recurrence_shift(const struct lattice *l, int axis, int k) {
    double lo = 0, hi = M_PI;
    for (int step = 0; step < 100 && hi - lo > DBL_EPSILON / 4 * hi; step++) {
        double shift = (lo + hi) / 2, theta = (M_PI * k + shift) / l->n[axis];
        *(shift < phase(l, 2 * axis, theta) + phase(l, 2 * axis + 1, theta) ? &lo : &hi) = shift;
    }
    return (lo + hi) / 2;
}

/* Whole turns are removed from theta (i + 1/2) = (k pi + shift) (2 i + 1) / (2 n) in integer arithmetic; there may
 * be thousands. */
static double *recurrence_modes(const struct lattice *l, int axis) {
    size_t n = (size_t)l->n[axis];
    double *mode = xcalloc(n * n, sizeof *mode);
    for (size_t k = 0; k < n; k++) {
        double shift = recurrence_shift(l, axis, (int)k),
               psi = phase(l, 2 * axis, (M_PI * (double)k + shift) / (double)n);
        double sum = 0, unit = 0.5 / (double)n;
        for (size_t i = 0; i < n; i++) {
            double turned = M_PI * (double)(k * (2 * i + 1) % (4 * n)),
                   value = cos((turned + shift * (double)(2 * i + 1)) * unit - psi);
            mode[k * n + i] = value;
            sum += value * value;
        }
        for (size_t i = 0; i < n; i++) mode[k * n + i] /= sqrt(sum);
    }
    return mode;
}

double transform_angle(const struct lattice *l, int axis, int k) {
    if (is_recurrent(l, axis)) return (M_PI * k + recurrence_shift(l, axis, k)) / l->n[axis];
    const struct basis *b = basis_of(l, axis);
    return M_PI * (k + b->first) / (l->n[axis] + b->extra);
}

double transform_scale(const struct lattice *l) {
    double scale = 1;
    for (int a = 0; a < l->dim; a++)
        if (!is_recurrent(l, a)) scale *= 2.0 * (l->n[a] + basis_of(l, a)->extra);
    return scale;
}

/* FFTW_ESTIMATE does not use the contents of the arrays. */
static fftw_plan plan_line(int n, fftw_r2r_kind kind) {
    double *from = xcalloc((size_t)n, sizeof *from), *to = xcalloc((size_t)n, sizeof *to);
    fftw_plan plan = fftw_plan_r2r_1d(n, from, to, kind, FFTW_ESTIMATE | FFTW_UNALIGNED | FFTW_PRESERVE_INPUT);
    free(from);
    free(to);
    return plan;
}

/* Call from one thread at a time: FFTW's planner and this cache have shared state. */
static struct {
    int count, n[KEPT];
    fftw_r2r_kind kind[KEPT];
    fftw_plan plan[KEPT];
} kept;

static fftw_plan cached_plan(int n, fftw_r2r_kind kind, int *is_kept) {
    int i = 0;
    while (i < kept.count && (kept.n[i] != n || kept.kind[i] != kind)) i++;
    *is_kept = i < KEPT;
    if (i < kept.count) return kept.plan[i];
    fftw_plan plan = plan_line(n, kind);
    if (*is_kept) kept.n[i] = n, kept.kind[i] = kind, kept.plan[i] = plan, kept.count++;
    return plan;
}

void transform_forget(void) {
    while (kept.count > 0) fftw_destroy_plan(kept.plan[--kept.count]);
}

static struct axis prepare(const struct lattice *l, int axis) {
    struct axis a = {.n = l->n[axis]};
    if (is_recurrent(l, axis)) {
        a.mode = recurrence_modes(l, axis);
        return a;
    }
#pragma omp critical(fftw_planner)
    for (int way = 0; way < 2; way++) a.plan[way] = cached_plan(a.n, basis_of(l, axis)->kind[way], &a.kept[way]);
    return a;
}

struct transform *transform_create(const struct lattice *l) {
    struct transform *t = xcalloc(1, sizeof *t);
    t->dim = l->dim;
    for (int a = 0; a < l->dim; a++) t->axis[a] = prepare(l, a);
    return t;
}

void transform_free(struct transform *t) {
    for (int a = 0; a < t->dim; a++) {
#pragma omp critical(fftw_planner)
        for (int way = 0; way < 2; way++)
            if (!t->axis[a].mode && !t->axis[a].kept[way]) fftw_destroy_plan(t->axis[a].plan[way]);
        free(t->axis[a].mode);
    }
    free(t);
}

/* FFTW's interface has no const; FFTW_PRESERVE_INPUT keeps the input. */
static void line(const struct axis *a, int way, const double *from, double *to) {
    size_t n = (size_t)a->n;
    if (a->mode) {
        memset(to, 0, n * sizeof *to);
        for (size_t k = 0; k < n; k++)
            for (size_t i = 0; i < n; i++) to[way ? i : k] += a->mode[k * n + i] * from[way ? k : i];
        return;
    }
    fftw_execute_r2r(a->plan[way], (double *)from, to);
}

double transform_flops(const struct transform *t) {
    double all = 0;
    for (int a = 0; a < t->dim; a++) {
        double add, mul, fma;
        if (t->axis[a].mode) {
            all += 2 * t->axis[a].n;
            continue;
        }
        fftw_flops(t->axis[a].plan[1], &add, &mul, &fma);
        all += (add + mul + 2 * fma) / t->axis[a].n;
    }
    return all;
}

/* The lines of `blocks` blocks, of `stride` lines each, in place.  work: 2 LINES n values. */
static void pass(const struct axis *a, int way, size_t stride, size_t blocks, double *T, double *work) {
    const size_t n = (size_t)a->n;
    double *in = work, *out = work + LINES * n;
    for (size_t block = 0; block < blocks; block++)
        for (size_t j = 0; j < stride; j += LINES) {
            size_t count = stride - j < LINES ? stride - j : LINES;
            double *line_0 = T + block * n * stride + j;
            if (stride == 1) in = line_0;
            for (size_t k = 0; k < n && stride > 1; k++)
                for (size_t r = 0; r < count; r++) in[r * n + k] = line_0[k * stride + r];
            for (size_t r = 0; r < count; r++) line(a, way, in + r * n, out + r * n);
            for (size_t k = 0; k < n; k++)
                for (size_t r = 0; r < count; r++) line_0[k * stride + r] = out[r * n + k];
        }
}

static void passes(const struct transform *t, int way, int first, int last, double *T) {
    size_t n = 1, longest = 0, stride = 1;
    for (int a = first; a <= last; a++) {
        size_t along = (size_t)t->axis[a].n;
        n *= along;
        if (along > longest) longest = along;
    }
    double *work = xcalloc(2 * LINES * longest, sizeof *work);
    for (int a = first; a <= last; stride *= (size_t)t->axis[a++].n)
        pass(&t->axis[a], way, stride, n / stride / (size_t)t->axis[a].n, T, work);
    free(work);
}

void transform_axes_forward(const struct transform *t, int first, int last, double *T) {
    passes(t, 0, first, last, T);
}

void transform_axes_backward(const struct transform *t, int first, int last, double *T) {
    passes(t, 1, first, last, T);
}

void transform_forward(const struct transform *t, double *T) {
    passes(t, 0, 0, t->dim - 1, T);
}

void transform_backward(const struct transform *t, double *T) {
    passes(t, 1, 0, t->dim - 1, T);
}
