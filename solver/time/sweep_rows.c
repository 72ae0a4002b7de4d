/* Updates by rows: y = rate (A x + g) + self x + old y + start Y0 with A in compressed rows. */
#include "solver/time/sweep.h"

/* Four partial sums a row: additions that do not wait for each other, in an order that does not change.  No clones
 * for wide vectors here: their gathers are slower than single loads. */
static inline double row_times(const struct heat_operator *a, const double *restrict x, size_t i) {
    const double *restrict value = a->value;
    const uint32_t *restrict column = a->column;
    double sum[4] = {a->diagonal[i] * x[i], 0, 0, 0};
    size_t k = a->row[i], end = a->row[i + 1];
    for (; k + 4 <= end; k += 4)
        for (size_t p = 0; p < 4; p++) sum[p] += value[k + p] * x[column[k + p]];
    for (; k < end; k++) sum[0] += value[k] * x[column[k]];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static void update_rows(const struct heat_operator *a, const struct update *u, const double *x, double *y,
                        size_t begin, size_t end) {
    if (sweep_is_plain(a, u)) {
        for (size_t i = begin; i < end; i++) y[i] = x[i] + u->rate * row_times(a, x, i);
        return;
    }
    for (size_t i = begin; i < end; i++) {
        double sum = row_times(a, x, i);
        if (a->g) sum += a->g[i];
        double to = u->rate * sum + u->self * x[i] + u->old * y[i];
        if (u->Y0) to += u->start * u->Y0[i];
        y[i] = to;
    }
}

enum { SHARE = 5000 }; /* rows that are worth a thread */

static void share_rows(const struct heat_operator *a, const struct update *u, size_t threads, const double *x,
                       double *y) {
#pragma omp parallel for num_threads(threads)
    for (size_t t = 0; t < threads; t++) update_rows(a, u, x, y, a->n * t / threads, a->n * (t + 1) / threads);
}

void sweep_rows(const struct heat_operator *a, const struct update *u, int count, double *const Y[2]) {
    size_t most = a->n / SHARE, threads = a->threads < 1 ? 1 : (size_t)a->threads;
    if (threads > most) threads = most;
    for (int k = 0; k < count; k++) {
        if (threads > 1)
            share_rows(a, &u[k], threads, Y[k % 2], Y[1 - k % 2]);
        else
            update_rows(a, &u[k], Y[k % 2], Y[1 - k % 2], 0, a->n);
    }
}
