/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several updates per sweep.
 *
 * Update k follows update k - 1 at the distance `lag`, one band at a time, so data larger than the cache pass
 * through it once for all updates. (Update k + 1 overwrites the input of update k, which is no longer needed there.)
 * Each thread takes a slab, which shrinks by the lag with each update; the seams between slabs are filled in when
 * both are done.  The result does not depend on threads or bands, bit for bit.  Threads wait for each other twice
 * per sweep. */
#include "solver/sweep/wavefront.h"

#include <omp.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

/* Between flush_begin and flush_end numbers below 2.2e-308 are zero in the calling thread.  Ahead of a heat front an
 * explicit step produces ever smaller values, far below any temperature, and processors are a hundred times slower
 * with subnormal numbers.  Without such a mode of the processor these functions do nothing. */
#ifdef __SSE2__
enum { FLUSH_ZERO = 0x8000 | 0x0040 }; /* flush results, treat operands as zero */

static inline unsigned flush_begin(void) {
    unsigned before = _mm_getcsr();
    _mm_setcsr(before | FLUSH_ZERO);
    return before;
}

static inline void flush_end(unsigned before) {
    _mm_setcsr(before);
}
#else
static inline unsigned flush_begin(void) {
    return 0;
}

static inline void flush_end(unsigned before) {
    (void)before;
}
#endif
/* Updates [first, first + count) of the units [begin, end), without those that depend on units outside: next to
 * other slabs each update covers fewer units. */
static void sweep_slab(const struct wavefront *w, int first, int count, ptrdiff_t begin, ptrdiff_t end) {
    ptrdiff_t below = begin > 0 ? w->lag : 0, above = end < w->units ? w->lag : 0;
    for (ptrdiff_t front = begin; front - (count - 1) * w->lag < end; front += w->band)
        for (int k = 0; k < count; k++) {
            ptrdiff_t lo = front - k * w->lag, hi = lo + w->band;
            if (lo < begin + k * below) lo = begin + k * below;
            if (hi > end - k * above) hi = end - k * above;
            if (lo < hi) w->advance(w->what, first + k, lo, hi);
        }
}

/* Completes the updates on either side of `at`, between two slabs. */
static void sweep_seam(const struct wavefront *w, int first, int count, ptrdiff_t at) {
    for (int k = 1; k < count; k++) w->advance(w->what, first + k, at - k * w->lag, at + k * w->lag);
}

/* A slab must be longer than the seams at both ends, so short slabs share a sweep among fewer updates. */
void wavefront_sweep(const struct wavefront *w, int count) {
    ptrdiff_t threads = w->threads < w->units ? w->threads : w->units, together = w->together;
    if (threads > 1 && w->lag > 0 && together > w->units / threads / (2 * w->lag))
        together = w->units / threads / (2 * w->lag);
    if (together < 1) together = 1;
    if (threads <= 1) {
        unsigned mode = flush_begin();
        for (int k = 0; k < count; k += (int)together)
            sweep_slab(w, k, count - k < together ? count - k : (int)together, 0, w->units);
        flush_end(mode);
        return;
    }
#pragma omp parallel num_threads((int)threads)
    {
        ptrdiff_t team = omp_get_num_threads(), t = omp_get_thread_num();
        ptrdiff_t begin = w->units * t / team, end = w->units * (t + 1) / team;
        unsigned mode = flush_begin();
        for (int k = 0; k < count; k += (int)together) {
            int some = count - k < together ? count - k : (int)together;
            sweep_slab(w, k, some, begin, end);
#pragma omp barrier
            if (t > 0) sweep_seam(w, k, some, begin);
#pragma omp barrier
        }
        flush_end(mode);
    }
}
