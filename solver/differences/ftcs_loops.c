/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hot loops of the finite differences, compiled for each vector width. */
#include "solver/differences/ftcs_loops.h"

#include "solver/options.h"

#include <math.h>

#define JOIN_NAMES(a, b) a##b
#define JOIN(a, b) JOIN_NAMES(a, b)

#if defined(__x86_64__)
#define FOR(machine) __attribute__((target(machine)))
#else
#define FOR(machine)
#endif

#define TARGET
#define LOOPS two
#include "solver/differences/ftcs_loops.inc"
#define TARGET FOR("avx2")
#define LOOPS four
#include "solver/differences/ftcs_loops.inc"
#define TARGET FOR("avx512f")
#define LOOPS eight
#include "solver/differences/ftcs_loops.inc"

const struct ftcs_loops *ftcs_loops_of(int lanes) {
    const struct ftcs_loops *const widths[] = {&two, &four, &eight};
    return widths[(lanes > 0 ? lanes : options_lanes_most()) / 4];
}
