/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SWEEP_FLUSH_H
#define HEATLADDER_SOLVER_SWEEP_FLUSH_H

/* Between flush_begin and flush_end numbers below 2.2e-308 are zero in the calling thread.  Ahead of a heat front an
 * explicit step produces ever smaller values, far below any temperature, and processors are a hundred times slower
 * with subnormal numbers.  Without such a mode of the processor these functions do nothing. */

#ifdef __SSE2__
#include <xmmintrin.h>

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

#endif
