/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several updates in one sweep.
 *
 * Update k follows update k - 1 at the distance of the lag, a band at a time, so that what does not fit the cache
 * goes through it once for all of them.  (Update k + 1 writes over the input of update k, whose readers are then
 * past.) Threads take slabs, which shrink by the lag from update to update; what is left between two slabs is filled
 * in when both are done.  Neither changes a bit of the result.  Threads wait for each other twice a sweep. */
#include "solver/sweep/wavefront.h"

#include "solver/sweep/flush.h"

#include <omp.h>

/* Updates [first, first + count) of the units [begin, end) as far as they do not depend on units beyond: where others
 * lie there, each update does fewer. */
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

/* What two slabs left undone on either side of `at`. */
static void sweep_seam(const struct wavefront *w, int first, int count, ptrdiff_t at) {
    for (int k = 1; k < count; k++) w->advance(w->what, first + k, at - k * w->lag, at + k * w->lag);
}

/* A slab must hold what its updates leave undone at both ends: fewer of them share a sweep where it is short. */
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
