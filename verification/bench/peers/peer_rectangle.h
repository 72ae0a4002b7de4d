/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The case file of --solver, for stand-ins in C: a rectangle of one material whose sides hold a temperature each, on
 * cell-centred points; and the answer that goes back. */
#ifndef HEATLADDER_VERIFICATION_BENCH_PEERS_PEER_RECTANGLE_H
#define HEATLADDER_VERIFICATION_BENCH_PEERS_PEER_RECTANGLE_H

struct rectangle {
    int plate;               /* 1: the plate, hot all over; 0: square-step, hot inside +-half */
    int n[2];                /* points along x and y */
    double lo[2], dx, t_end; /* m, m, s */
    double kappa[2];         /* m^2/s */
    double side[4];          /* K, at the lowest x, highest x, lowest y, highest y */
    double T0, half[2];      /* K, m */
    int threads;
};

enum { RECTANGLE_FEW = 16384 }; /* points that threads are not woken for: some microseconds of work */

/* s: solves are done over until so much has passed, then the one that is timed.  Not the one during which it passes:
 * that is the likelier one the longer it takes, on a busy machine one in which others had their turn. */
#define RECTANGLE_WARM 0.1

/* Ends the program where it cannot be read or is another scene. */
struct rectangle rectangle_read(const char *path);

/* T[n[0] n[1]], rows along x, at the start. */
void rectangle_start(const struct rectangle *p, double *T);

void rectangle_write(const struct rectangle *p, const double *T, const char *path, double seconds, long steps);

/* Says `text` and ends the program. */
void rectangle_die(const char *text);

#endif
