/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_band_2: vectors of 2 doubles, for any machine. */
#include "solver/sweep/sweep.h"

#define LANES 2
#define SWEEP_BAND sweep_band_2
#define SWEEP_BANDS sweep_bands_2
#define SWEEP_PLANES sweep_planes_2
#include "solver/sweep/lanes.inc"
