/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_band_8: vectors of 8 doubles, for AVX-512. */
#include "solver/sweep/sweep.h"

#define LANES 8
#define SWEEP_BAND sweep_band_8
#define SWEEP_BANDS sweep_bands_8
#define SWEEP_PLANES sweep_planes_8
#include "solver/sweep/lanes.inc"
