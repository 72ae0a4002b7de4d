/* sweep_band_4: vectors of 4 doubles, for AVX2. */
#include "solver/sweep.h"

#if defined(__x86_64__)
#pragma GCC target("avx2")
#endif
#define LANES 4
#define SWEEP_BAND sweep_band_4
#include "solver/sweep_lanes.inc"
