/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SWEEP_FLUSH_H
#define HEATLADDER_SOLVER_SWEEP_FLUSH_H

/* Between flush_begin and flush_end a number below 2.2e-308 is zero, in the calling thread.  Ahead of a front an
 * explicit step leaves less with every cell, far below any temperature, and processors take a hundred times as long
 * for what they cannot hold in full.  Where a processor has no such mode nothing is done. */

#ifdef __SSE2__
#include <xmmintrin.h>

enum { FLUSH_ZERO = 0x8000 | 0x0040 }; /* results, operands */

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
