/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_PEERS_SUNDIALS_KERNELS_H
#define HEATLADDER_VERIFICATION_BENCH_PEERS_SUNDIALS_KERNELS_H

#include <sundials/sundials_nvector.h>

/* Replaces the kernels of a serial vector; its clones inherit them. */
void sundials_kernels(N_Vector v);

#endif
