/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is measured beside one another, as fine as the errors of interest need.  Multiples of 8 leave the jump of
 * square-step midway between points.  The stand-ins lie in bench/peers and are run from the root of the sources. */
#include "verification/bench/peers.h"

#include <stddef.h>

#define SQUARE .scene = "square-step", .side = "4"
#define PLATE .scene = "plate", .side = "0.1"
#define BUILT(name) "p=${PEERS:-build/peers}/" name "; [ -x $p ] || exit 77; $p {case} {out}"
#define PYTHON(name)                                                                                                 \
    "p=${PYTHON:-python3}; command -v $p >/dev/null || exit 77; $p verification/bench/peers/" name " {case} {out}"
/* of the gates of square-step and plate, those of differences and of Brookshaw's Laplacian */
#define SECOND .gate = {1.9, 2.1}
#define CORNERS .gate = {1.75, 2.0}
#define CORNERS_SPH .gate = {1.85, 2.05}
#define FTCS .who = "FTCS at F = 1/6", .command = BUILT("ftcs")
#define CVODE .who = "SUNDIALS CVODE BDF-Krylov", .command = BUILT("sundials") " bdf", .settings = BDF_TOLERANCES
#define DIRK .who = "SUNDIALS ARKODE DIRK-Krylov", .command = BUILT("sundials") " dirk", .settings = DIRK_TOLERANCES
#define ERK .who = "SUNDIALS ARKODE ERK", .command = BUILT("sundials") " erk", .settings = "1e-4 1e-3 1e-2"
#define BDF_TOLERANCES "3e-6 1e-5 3e-5 1e-4 3e-4 1e-3"
#define DIRK_TOLERANCES "1e-5 1e-4 3e-4 1e-3 3e-3 1e-2"
#define DST .who = "SciPy DST", .command = PYTHON("scipy_peer.py") " dst"
#define DSTK .who = "SciPy DST with exact wave numbers", .command = PYTHON("scipy_peer.py") " dstk"
#define SCIPY_BDF                                                                                                    \
    .who = "SciPy BDF", .command = PYTHON("scipy_peer.py") " bdf", .settings = "1e-5 1e-4 1e-3", .serial = 1
#define EXPM .who = "SciPy expm_multiply", .command = PYTHON("scipy_peer.py") " expm", .serial = 1
#define CUBIC .who = "PySPH Brookshaw cubic kernel", .command = PYTHON("pysph_peer.py") " cubic 0.4"
#define QUINTIC                                                                                                      \
    .who = "PySPH Brookshaw quintic kernel", .command = PYTHON("pysph_peer.py") " quintic 0.4", .serial = 1
#define MATCHED "so_ssph --stepper matched --h iso --sampling spline"
#define EXACT "so_ssph --stepper exact --h 1.05"
#define RKL2 "so_ssph --stepper rkl2 --h 1.05"
#define TIME_ERRORS .settings = "1e-6 3e-6 1e-5 3e-5 1e-4 3e-4 1e-3 3e-3"
#define OURS(name, words) .who = "so_ssph " name, .kind = PEERS_OURS, .command = words
#define WHOLE(name, words)                                                                                           \
    .who = "so_ssph " name " unfolded", .kind = PEERS_WHOLE, .command = words " --domain whole", .serial = 1
/* The same operator, kernel, h and steps as PySPH's: once on the lattice's one stencil, once by lists of neighbours.
 * 0.4: nine tenths of what Euler is stable at. */
#define RATE(name, words)                                                                                            \
    .who = "brookshaw " name, .kind = PEERS_RATE, .serial = 1,                                                       \
    .command = "brookshaw --stepper euler --fourier 0.4 --volume raw --domain whole" words

const struct peer peers_table[] = {
    {SQUARE, OURS("matched", MATCHED), .n = {16, 24, 28, 34, 40, 64}},
    {SQUARE, OURS("exact", EXACT), .n = {64, 128, 256, 576, 1024}},
    {SQUARE, OURS("rkl2", RKL2), TIME_ERRORS, .n = {64, 128, 256, 576}},
    {SQUARE, FTCS, SECOND, .n = {32, 64, 128, 256, 384}},
    {SQUARE, CVODE, SECOND, .n = {64, 128, 256, 512}},
    {SQUARE, DIRK, SECOND, .n = {32, 64, 128, 256}},
    {SQUARE, ERK, SECOND, .n = {32, 64, 128, 256}},
    {SQUARE, DST, SECOND, .n = {64, 128, 256, 576, 1024}},
    {SQUARE, DSTK, SECOND, .n = {64, 128, 256, 384}},
    {SQUARE, SCIPY_BDF, SECOND, .n = {32, 48, 64, 96}},
    {SQUARE, EXPM, SECOND, .n = {32, 64, 128, 256}},
    {SQUARE, CUBIC, SECOND, .n = {24, 40, 80, 128}},
    {SQUARE, QUINTIC, SECOND, .n = {24, 40, 80, 128}},
    {SQUARE, WHOLE("matched", MATCHED), .n = {16, 24, 28, 34, 40, 64}},
    {SQUARE, WHOLE("exact", EXACT), .n = {64, 128, 256, 576, 1024}},
    {SQUARE, WHOLE("rkl2", RKL2), TIME_ERRORS, .n = {64, 128, 256, 576}},
    {SQUARE, RATE("on the lattice", ""), .n = {128}},
    {SQUARE, RATE("by lists of neighbours", " --layout jitter --jitter 0.01"), .n = {128}},
    {PLATE, OURS("matched", MATCHED), .n = {16, 32, 64, 128}},
    {PLATE, OURS("exact", EXACT), .n = {32, 64, 128, 160, 256, 512, 1024}},
    {PLATE, OURS("rkl2", RKL2), TIME_ERRORS, .n = {32, 64, 128, 160}},
    {PLATE, FTCS, CORNERS, .n = {32, 64, 128, 160}},
    {PLATE, CVODE, CORNERS, .n = {32, 64, 128, 160}},
    {PLATE, DIRK, CORNERS, .n = {16, 32, 64, 128}},
    {PLATE, ERK, CORNERS, .n = {16, 32, 64, 128}},
    {PLATE, DST, CORNERS, .n = {32, 64, 128, 160, 256, 512, 1024}},
    {PLATE, SCIPY_BDF, CORNERS, .n = {16, 24, 32, 48}},
    {PLATE, EXPM, CORNERS, .n = {16, 32, 64, 96}},
    {PLATE, CUBIC, CORNERS_SPH, .n = {16, 24, 32, 48}},
    {.scene = NULL},
};

const char peers_versions[] =
    "p=${PEERS:-build/peers}/sundials; [ ! -x $p ] || echo SUNDIALS $($p --version)\n"
    "${PYTHON:-python3} -c 'import scipy; print(\"SciPy\", scipy.__version__)' 2>/dev/null\n"
    "${PYTHON:-python3} -c 'import pysph; print(\"PySPH\", pysph.__version__)' 2>/dev/null\n";
