/* The hot loop: y = rate (A x + g) + self x + old y + start Y0 + start_rate L0.
 *
 * On a lattice each row of particles streams through one loop over its columns.  For the stencils that the usual h/dx
 * give, the loop over the offsets is unrolled by the compiler (their radius and support are constants there); any
 * other stencil adds one offset at a time to a short buffer that stays in the first-level cache.  The order of the
 * additions is the same on any machine and for any number of threads. */
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

/* What stands beside the sum over neighbours; pointers at the first particle of the row. */
struct others {
    struct update u;
    const double *g;
};

INLINE double combine(const struct others *o, ptrdiff_t c, double sum, double x, double y) {
    const struct update *u = &o->u;
    double to = u->rate * (o->g ? sum + o->g[c] : sum) + u->self * x + u->old * y;
    if (u->Y0) to += u->start * u->Y0[c];
    if (u->L0) to += u->start_rate * u->L0[c];
    return to;
}

enum { PIECE = 256, REACH_MAX = 16, PAIRED = PIECE + 2 * REACH_MAX };

/* One piece of a row.  pair[j] holds x above + x below at distance j, so that each offset of the quadrant costs one
 * addition and one multiplication more.  rx, ry and q (offsets with i i + j j <= q) are constants where it is
 * inlined; the order of the additions is the same for every piece. */
INLINE double weigh(int rx, int ry, int q, const double *restrict w, const double *restrict x,
                    double (*restrict pair)[PAIRED], ptrdiff_t c) {
    double sum = w[0] * x[c];
    _Pragma("GCC unroll 9") for (int i = 1; i <= rx; i++) sum += w[i] * (x[c - i] + x[c + i]);
    _Pragma("GCC unroll 9") for (int j = 1; j <= ry; j++) {
        const double *s = &pair[j][REACH_MAX];
        sum += w[j * (rx + 1)] * s[c];
        _Pragma("GCC unroll 9") for (int i = 1; i <= rx; i++) if (i * i + j * j <= q) sum +=
            w[j * (rx + 1) + i] * (s[c - i] + s[c + i]);
    }
    return sum;
}

INLINE void pair_rows(int rx, int ry, const double *restrict x, ptrdiff_t stride, ptrdiff_t n,
                      double (*restrict pair)[PAIRED]) {
    for (int j = 1; j <= ry; j++) {
        const double *below = x - j * stride, *above = x + j * stride;
        double *s = &pair[j][REACH_MAX];
        for (ptrdiff_t c = -rx; c < n + rx; c++) s[c] = below[c] + above[c];
    }
}

INLINE void row_sum(int rx, int ry, int q, const double *restrict w, const double *restrict x, ptrdiff_t stride,
                    ptrdiff_t n, const struct others *o, double *restrict y) {
    double pair[REACH_MAX + 1][PAIRED];
    int plain = !o->g && !o->u.Y0 && !o->u.L0 && o->u.self == 1 && o->u.old == 0;
    double rate = o->u.rate;
    for (ptrdiff_t begin = 0; begin < n; begin += PIECE) {
        ptrdiff_t m = n - begin < PIECE ? n - begin : PIECE;
        const double *at = x + begin;
        double *to = y + begin;
        pair_rows(rx, ry, at, stride, m, pair);
        if (plain) /* an Euler step without source or walls' values */
            for (ptrdiff_t c = 0; c < m; c++) to[c] = at[c] + rate * weigh(rx, ry, q, w, at, pair, c);
        else
            for (ptrdiff_t c = 0; c < m; c++)
                to[c] = combine(o, begin + c, weigh(rx, ry, q, w, at, pair, c), at[c], to[c]);
    }
}

/* Any stencil, one offset at a time. */
INLINE void row_any(int rx, int ry, const double *restrict w, const double *restrict x, ptrdiff_t stride, ptrdiff_t n,
                    const struct others *o, double *restrict y) {
    double pair[REACH_MAX + 1][PAIRED], sum[PIECE];
    for (ptrdiff_t begin = 0; begin < n; begin += PIECE) {
        ptrdiff_t m = n - begin < PIECE ? n - begin : PIECE;
        const double *at = x + begin;
        pair_rows(rx, ry, at, stride, m, pair);
        for (ptrdiff_t c = 0; c < m; c++) sum[c] = w[0] * at[c];
        for (int j = 0; j <= ry; j++)
            for (int i = 0; i <= rx; i++) {
                double weight = w[j * (rx + 1) + i];
                const double *s = j ? &pair[j][REACH_MAX] : at;
                if (weight == 0 || (i == 0 && j == 0)) continue;
                if (i == 0)
                    for (ptrdiff_t c = 0; c < m; c++) sum[c] += weight * s[c];
                else
                    for (ptrdiff_t c = 0; c < m; c++) sum[c] += weight * (s[c - i] + s[c + i]);
            }
        for (ptrdiff_t c = 0; c < m; c++) y[begin + c] = combine(o, begin + c, sum[c], at[c], y[begin + c]);
    }
}

/* The largest i i + j j of an offset with a weight. */
static int support_of(const struct heat_operator *a) {
    int q = 0;
    for (int j = 0; j <= a->reach[1]; j++)
        for (int i = 0; i <= a->reach[0]; i++)
            if (a->weight[j * (a->reach[0] + 1) + i] != 0 && i * i + j * j > q) q = i * i + j * j;
    return q;
}

CLONES static void sweep_rows(const struct heat_operator *a, int q, const struct update *u, const double *x,
                              double *y, ptrdiff_t begin, ptrdiff_t end) {
    const struct lattice *l = &a->lattice;
    int rx = a->reach[0], ry = a->reach[1];
    ptrdiff_t n = l->n[0], stride = n + 2 * rx;
    const double *w = a->weight;
    for (ptrdiff_t j = begin; j < end; j++) {
        ptrdiff_t at = (j + ry) * stride + rx;
        struct others o = {*u, a->g ? a->g + at : NULL};
        if (u->Y0) o.u.Y0 = u->Y0 + at;
        if (u->L0) o.u.L0 = u->L0 + at;
        const double *xr = x + at;
        double *yr = y + at;
        switch (1000 * rx + 100 * ry + q) {
        case 1001:
            row_sum(1, 0, 1, w, xr, stride, n, &o, yr);
            break;
        case 2004:
            row_sum(2, 0, 4, w, xr, stride, n, &o, yr);
            break;
        case 3009:
            row_sum(3, 0, 9, w, xr, stride, n, &o, yr);
            break;
        case 4016:
            row_sum(4, 0, 16, w, xr, stride, n, &o, yr);
            break;
        case 1102:
            row_sum(1, 1, 2, w, xr, stride, n, &o, yr);
            break;
        case 2204:
            row_sum(2, 2, 4, w, xr, stride, n, &o, yr);
            break;
        case 2205:
            row_sum(2, 2, 5, w, xr, stride, n, &o, yr);
            break;
        case 2208:
            row_sum(2, 2, 8, w, xr, stride, n, &o, yr);
            break;
        case 3309:
            row_sum(3, 3, 9, w, xr, stride, n, &o, yr);
            break;
        case 4416:
            row_sum(4, 4, 16, w, xr, stride, n, &o, yr);
            break;
        default:
            row_any(rx, ry, w, xr, stride, n, &o, yr);
        }
    }
}

CLONES static void sweep_csr(const struct heat_operator *a, const struct update *u, const double *restrict x,
                             double *restrict y, ptrdiff_t begin, ptrdiff_t end) {
    struct others o = {*u, a->g};
    const double *restrict value = a->value;
    const uint32_t *restrict column = a->column;
    for (ptrdiff_t i = begin; i < end; i++) {
        double sum = a->diagonal[i] * x[i];
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++) sum += value[k] * x[column[k]];
        y[i] = combine(&o, i, sum, x[i], y[i]);
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
