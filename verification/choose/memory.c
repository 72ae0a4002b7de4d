/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planned bytes against those of the machine. */
#include "verification/choose/forewarn.h"

#include "solver/status.h"
#include "verification/choose/plan.h"
#include "verification/run/experiment.h"

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

static double bytes_of(const struct plan *plan) {
    return (double)plan->part.bytes[plan_peak(plan)];
}

/* The finest spacing above the one of *e that divides the domain and fits, to 3 %; NaN where some tens of tries find
 * none.  Numbers of cells have few digits in base 2, so that coarser rows can stand in for those that are planned. */
static double finest(const struct experiment *e, double bytes, double most) {
    enum { PLANS = 20, TRIES = 200 };
    struct experiment coarser = *e;
    double extent = e->problem.hi[0] - e->problem.lo[0];
    double n = floor(extent / e->options.dx * pow(most / bytes, 1.0 / e->problem.dim));
    for (int plans = 0, tries = 0; plans < PLANS && tries < TRIES && n >= 1; tries++, n--) {
        struct plan plan;
        struct failure ignored;
        n -= fmod(n, n < 128 ? 1 : exp2(floor(log2(n / 32)) - 1));
        double across = (e->problem.hi[e->problem.dim - 1] - e->problem.lo[e->problem.dim - 1]) * n / extent;
        coarser.options.dx = extent / n;
        if (fabs(across - nearbyint(across)) > 1e-9 * across) continue;
        plans++;
        if (plan_make(&coarser, PLAN_STORAGE, &plan, &ignored)) continue;
        if (bytes_of(&plan) <= most) return coarser.options.dx;
    }
    return NAN;
}

int memory_check(const struct experiment *e, struct failure *why) {
    struct plan plan;
    struct failure ignored;
    if (plan_make(e, PLAN_STORAGE, &plan, &ignored)) return STATUS_OK;
    double most = e->memory > 0 ? GB * e->memory : memory_there(), bytes = bytes_of(&plan);
    if (most == 0 || bytes <= most) return STATUS_OK;
    double dx = finest(e, bytes, most);
    char fits[64] = "";
    if (isfinite(dx)) snprintf(fits, sizeof fits, "; --dx %.10g fits", dx);
    return refuse(why, STATUS_INPUT, "--dx %.10g: takes %.3g GB, %s %.3g GB%s; --memory GB allows more",
                  e->options.dx, bytes / GB, e->memory > 0 ? "--memory allows" : "free are", most / GB, fits);
}
