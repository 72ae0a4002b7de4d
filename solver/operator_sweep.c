/* The hot loop: y = rate (A x + g) + self x + old y + start Y0 + start_rate L0.
 *
 * On a lattice each row of particles streams by in short pieces that stay in the first-level cache.   For the
 * stencils that the usual h/dx give, the loops over the offsets are unrolled by the compiler (their radius and
 * support are constants there).  The order of the additions is the same on any machine and for any number of threads.
 */
#include "solver/operator.h"

#include <string.h>

#if defined(__x86_64__) && defined(__gnu_linux__)
#define CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define CLONES
#endif
#define INLINE static inline __attribute__((always_inline))

/* Homogeneous ghosts: sign x source along x, then along y, corners with them. */
static void refresh_ghosts(const struct heat_operator *a, double *x) {
    const struct lattice *l = &a->lattice;
    ptrdiff_t rx = a->reach[0], ry = a->reach[1], nx = l->n[0], ny = l->n[1], stride = nx + 2 * rx;
    for (ptrdiff_t j = ry; j < ny + ry; j++) {
        double *row = x + j * stride + rx;
        for (ptrdiff_t k = 1; k <= rx; k++) {
            ptrdiff_t lo = k - 1 + l->shift[X_LO], hi = k - 1 + l->shift[X_HI];
            row[-k] = lo < 0 ? 0 : l->sign[X_LO] * row[lo];
            row[nx - 1 + k] = hi < 0 ? 0 : l->sign[X_HI] * row[nx - 1 - hi];
        }
    }
    for (ptrdiff_t k = 1; k <= ry; k++)
        for (int s = Y_LO; s <= Y_HI; s++) {
            ptrdiff_t from = k - 1 + l->shift[s];
            double *to = x + (s == Y_LO ? ry - k : ry + ny - 1 + k) * stride;
            const double *source = x + (s == Y_LO ? ry + from : ry + ny - 1 - from) * stride;
            if (from < 0 || l->sign[s] == 0)
                memset(to, 0, (size_t)stride * sizeof *to);
            else
                for (ptrdiff_t i = 0; i < stride; i++) to[i] = l->sign[s] * source[i];
        }
}

enum { PIECE = 256, REACH_MAX = 24, PADDED = PIECE + 2 * REACH_MAX };

static const double zeros[PIECE];

/* y from the sums over neighbours of n particles in a row; u, g: at the first of them. */
INLINE void finish(const struct update *u, const double *g0, ptrdiff_t n, const double *restrict sum,
                   const double *restrict x, double *restrict y) {
    const double *restrict g = g0 ? g0 : zeros, *restrict Y0 = u->Y0 ? u->Y0 : zeros;
    const double *restrict L0 = u->L0 ? u->L0 : zeros;
    double rate = u->rate, self = u->self, old = u->old, start = u->start, start_rate = u->start_rate;
    for (ptrdiff_t c = 0; c < n; c++)
        y[c] = rate * (sum[c] + g[c]) + self * x[c] + old * y[c] + start * Y0[c] + start_rate * L0[c];
}

/* The same for an Euler step without source or walls' values. */
INLINE int is_plain(const struct update *u, const double *g) {
    return !g && !u->Y0 && !u->L0 && u->self == 1 && u->old == 0;
}

/* A rod: y or the sums, from the neighbours along x. */
INLINE void row_rod(int rx, const double *restrict w, const double *restrict x, ptrdiff_t n, int plain, double rate,
                    double *restrict to) {
    for (ptrdiff_t c = 0; c < n; c++) {
        double sum = w[0] * x[c];
        _Pragma("GCC unroll 8") for (int i = 1; i <= rx; i++) sum += w[i] * (x[c - i] + x[c + i]);
        to[c] = plain ? x[c] + rate * sum : sum;
    }
}

/* A piece of a row in the plane, in two passes: first along y, which needs no shifted loads,
 *   column_i = sum_j w_ij (x above + x below at distance j),
 * then along x: column_0 + sum_i (column_i to the left + to the right).  Offsets have i i + j j <= q; rx, ry and q
 * are constants where it is inlined. */
INLINE void row_plane(int rx, int ry, int q, const double *restrict w, const double *restrict x, ptrdiff_t stride,
                      ptrdiff_t n, int plain, double rate, double *restrict to) {
    double column[REACH_MAX + 1][PADDED];
    for (ptrdiff_t c = -rx; c < n + rx; c++) {
        double pair[REACH_MAX + 1];
        pair[0] = x[c];
        _Pragma("GCC unroll 8") for (int j = 1; j <= ry; j++) pair[j] = x[c - j * stride] + x[c + j * stride];
        _Pragma("GCC unroll 8") for (int i = 0; i <= rx; i++) {
            double sum = w[i] * pair[0];
            _Pragma("GCC unroll 8") for (int j = 1; j <= ry; j++) if (i * i + j * j <= q) sum +=
                w[j * (rx + 1) + i] * pair[j];
            column[i][c + REACH_MAX] = sum;
        }
    }
    for (ptrdiff_t c = 0; c < n; c++) {
        double sum = column[0][c + REACH_MAX];
        _Pragma("GCC unroll 8") for (int i = 1; i <= rx; i++) sum +=
            column[i][c - i + REACH_MAX] + column[i][c + i + REACH_MAX];
        to[c] = plain ? x[c] + rate * sum : sum;
    }
}

/* Any stencil: the same two passes, one offset at a time. */
INLINE void row_any(int rx, int ry, const double *restrict w, const double *restrict x, ptrdiff_t stride, ptrdiff_t n,
                    int plain, double rate, double *restrict to) {
    double column[PADDED], sum[PIECE] = {0};
    for (int i = 0; i <= rx; i++) {
        double *at = column + REACH_MAX;
        for (ptrdiff_t c = -rx; c < n + rx; c++) at[c] = w[i] * x[c];
        for (int j = 1; j <= ry; j++) {
            double weight = w[j * (rx + 1) + i];
            if (weight == 0) continue;
            const double *above = x - j * stride, *below = x + j * stride;
            for (ptrdiff_t c = -rx; c < n + rx; c++) at[c] += weight * (above[c] + below[c]);
        }
        for (ptrdiff_t c = 0; c < n; c++) sum[c] += i ? at[c - i] + at[c + i] : at[c];
    }
    for (ptrdiff_t c = 0; c < n; c++) to[c] = plain ? x[c] + rate * sum[c] : sum[c];
}

/* The largest i i + j j of an offset with a weight. */
static int support_of(const struct heat_operator *a) {
    int q = 0;
    for (int j = 0; j <= a->reach[1]; j++)
        for (int i = 0; i <= a->reach[0]; i++)
            if (a->weight[j * (a->reach[0] + 1) + i] != 0 && i * i + j * j > q) q = i * i + j * j;
    return q;
}

/* One piece of a row: n <= PIECE particles. */
INLINE void piece(const struct heat_operator *a, int q, const double *x, ptrdiff_t stride, ptrdiff_t n, int plain,
                  double rate, double *to) {
    int rx = a->reach[0], ry = a->reach[1];
    const double *w = a->weight;
    switch (1000 * rx + 100 * ry + q) {
    case 1001:
        row_rod(1, w, x, n, plain, rate, to);
        break;
    case 2004:
        row_rod(2, w, x, n, plain, rate, to);
        break;
    case 3009:
        row_rod(3, w, x, n, plain, rate, to);
        break;
    case 4016:
        row_rod(4, w, x, n, plain, rate, to);
        break;
    case 1102:
        row_plane(1, 1, 2, w, x, stride, n, plain, rate, to);
        break;
    case 2204:
        row_plane(2, 2, 4, w, x, stride, n, plain, rate, to);
        break;
    case 2205:
        row_plane(2, 2, 5, w, x, stride, n, plain, rate, to);
        break;
    case 2208:
        row_plane(2, 2, 8, w, x, stride, n, plain, rate, to);
        break;
    case 3309:
        row_plane(3, 3, 9, w, x, stride, n, plain, rate, to);
        break;
    case 4416:
        row_plane(4, 4, 16, w, x, stride, n, plain, rate, to);
        break;
    default:
        row_any(rx, ry, w, x, stride, n, plain, rate, to);
    }
}

CLONES static void sweep_rows(const struct heat_operator *a, int q, const struct update *u, const double *x,
                              double *y, ptrdiff_t begin, ptrdiff_t end) {
    const struct lattice *l = &a->lattice;
    ptrdiff_t nx = l->n[0], stride = nx + 2 * a->reach[0];
    int plain = is_plain(u, a->g);
    double sum[PIECE];
    for (ptrdiff_t j = begin; j < end; j++)
        for (ptrdiff_t i = 0; i < nx; i += PIECE) {
            ptrdiff_t at = (j + a->reach[1]) * stride + a->reach[0] + i, n = nx - i < PIECE ? nx - i : PIECE;
            piece(a, q, x + at, stride, n, plain, u->rate, plain ? y + at : sum);
            if (plain) continue;
            struct update here = *u;
            if (u->Y0) here.Y0 = u->Y0 + at;
            if (u->L0) here.L0 = u->L0 + at;
            finish(&here, a->g ? a->g + at : NULL, n, sum, x + at, y + at);
        }
}

/* Four partial sums a row: additions that do not wait for each other, in an order that does not change.  No clones
 * for wide vectors here: their gathers are slower than single loads. */
INLINE double row_csr(const struct heat_operator *a, const double *restrict x, size_t i) {
    const double *restrict value = a->value;
    const uint32_t *restrict column = a->column;
    double sum[4] = {a->diagonal[i] * x[i], 0, 0, 0};
    size_t k = a->row[i], end = a->row[i + 1];
    for (; k + 4 <= end; k += 4)
        for (size_t p = 0; p < 4; p++) sum[p] += value[k + p] * x[column[k + p]];
    for (; k < end; k++) sum[0] += value[k] * x[column[k]];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static void sweep_csr(const struct heat_operator *a, const struct update *u, const double *x, double *y,
                      ptrdiff_t begin, ptrdiff_t end) {
    int plain = is_plain(u, a->g);
    double sum[PIECE];
    for (ptrdiff_t at = begin; at < end; at += PIECE) {
        ptrdiff_t n = end - at < PIECE ? end - at : PIECE;
        if (plain) {
            for (ptrdiff_t i = at; i < at + n; i++) y[i] = x[i] + u->rate * row_csr(a, x, (size_t)i);
            continue;
        }
        for (ptrdiff_t i = 0; i < n; i++) sum[i] = row_csr(a, x, (size_t)(at + i));
        struct update here = *u;
        if (u->Y0) here.Y0 = u->Y0 + at;
        if (u->L0) here.L0 = u->L0 + at;
        finish(&here, a->g ? a->g + at : NULL, n, sum, x + at, y + at);
    }
}

void operator_update(const struct heat_operator *a, const struct update *u, double *x, double *y) {
    ptrdiff_t rows = a->weight ? a->lattice.n[1] : (ptrdiff_t)a->n;
    int q = 0, threads = a->threads > 1 && a->n > 10000 ? a->threads : 1;
    if (a->weight) {
        refresh_ghosts(a, x);
        q = support_of(a);
    }
    if (threads == 1) {
        if (a->weight)
            sweep_rows(a, q, u, x, y, 0, rows);
        else
            sweep_csr(a, u, x, y, 0, rows);
        return;
    }
#pragma omp parallel for num_threads(threads)
    for (int t = 0; t < threads; t++) {
        ptrdiff_t begin = rows * t / threads, end = rows * (t + 1) / threads;
        if (a->weight)
            sweep_rows(a, q, u, x, y, begin, end);
        else
            sweep_csr(a, u, x, y, begin, end);
    }
}
