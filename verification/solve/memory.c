/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Estimated memory of a run, from its particles and neighbours, and the memory of the machine. */
#include "verification/solve/memory.h"

#include "solver/particles/particles.h"
#include "solver/status.h"
#include "verification/case/experiment.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

static const double GB = 1e9;

double memory_there(void) {
    double kibibytes = 0;
    char line[128];
    FILE *in = fopen("/proc/meminfo", "r");
    while (in && kibibytes == 0 && fgets(line, sizeof line, in))
        if (sscanf(line, "MemAvailable: %lf", &kibibytes) != 1) kibibytes = 0;
    if (in) fclose(in);
    if (kibibytes > 0) return 1024 * kibibytes;
    double pages = (double)sysconf(_SC_PHYS_PAGES), page = (double)sysconf(_SC_PAGESIZE);
    return pages > 0 && page > 0 ? pages * page : 0;
}

/* Each particle has four doubles (three states and a source, or the temperature, the exact one, and those of another
 * run), and off the lattice its position.  Each neighbour within 2 h (4 h in two sweeps) needs a weight and a column
 * in the rows, and twice that again during assembly; on a rod the rows are also stored as bands. */
double memory_estimate(const struct experiment *e) {
    const double ENTRY[] = {0, 60, 40, 28};
    const struct problem *p = &e->problem;
    double particles = 1, bytes;
    struct options resolved;
    struct lattice l;
    struct failure ignored;
    int rows = 0;
    for (int a = 0; a < p->dim; a++) particles *= (p->hi[a] - p->lo[a]) / e->options.dx;
    if (e->method->scheme && particles_prepare(p, &e->options, e->method->scheme, &resolved, &l, &rows, &ignored))
        rows = 0; /* refused, for example as too many particles: a lower bound */
    double reach = rows ? e->method->scheme->sweeps * resolved.h : 0; /* half width of a row, in dx */
    double neighbours[] = {0, 4 * reach, 4 * M_PI * reach * reach, 32 * M_PI / 3 * reach * reach * reach};
    bytes = 8 * (4 + (rows ? p->dim : 0)) + ENTRY[p->dim] * neighbours[p->dim];
    return particles * bytes;
}

/* The finest spacing above that of *e that divides the domain and fits into memory; NaN if none is found. */
static double finest(const struct experiment *e, double bytes, double most) {
    enum { TRIES = 1000 };
    const struct problem *p = &e->problem;
    const double *lo = p->lo, *hi = p->hi;
    double n = floor((hi[0] - lo[0]) / e->options.dx * pow(most / bytes, 1.0 / p->dim));
    for (int tries = 0; tries < TRIES && n >= 1; tries++, n--) {
        double across = (hi[p->dim - 1] - lo[p->dim - 1]) / (hi[0] - lo[0]) * n;
        if (fabs(across - nearbyint(across)) <= 1e-9 * across) return (hi[0] - lo[0]) / n;
    }
    return NAN;
}

int memory_check(const struct experiment *e, struct failure *why) {
    if (e->external) return STATUS_OK;
    double most = e->memory > 0 ? GB * e->memory : memory_there(), bytes = memory_estimate(e);
    if (most == 0 || !(bytes > most)) return STATUS_OK;
    double dx = finest(e, bytes, most);
    char fits[64] = "";
    if (isfinite(dx)) snprintf(fits, sizeof fits, "; --dx %.10g fits", dx);
    return refuse(why, STATUS_INPUT, "--dx %.10g: needs %.3g GB, %s %.3g GB%s; --memory GB sets another limit",
                  e->options.dx, bytes / GB, e->memory > 0 ? "--memory allows" : "available:", most / GB, fits);
}
