/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_band_4: vectors of 4 doubles, for AVX2. */
#include "solver/sweep/sweep.h"

#define LANES 4
#define SWEEP_BAND sweep_band_4
#define SWEEP_BANDS sweep_bands_4
#define SWEEP_PLANES sweep_planes_4
#include "solver/sweep/lanes.inc"
