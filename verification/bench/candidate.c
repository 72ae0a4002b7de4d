/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The candidates of `bench`. */
#include "verification/bench/candidate.h"

#include "solver/time/stepper.h"
#include "verification/solve/symmetry.h"
#include "verification/solve/experiment.h"
#include "verification/judge/run.h"

#include <math.h>

/* In the order of struct candidate, the options last. */
#define CANDIDATE(label, method, dim, steps, ...)                                                                    \
    { label, method, {__VA_ARGS__}, dim, steps }
#define EXACT .stepper = STEPPER_EXACT
#define EULER .stepper = STEPPER_EULER
#define RKL2 .stepper = STEPPER_RKL2
#define CHEBYSHEV .stepper = STEPPER_CHEBYSHEV
#define MATCHED .stepper = STEPPER_MATCHED
#define SPLINE .sampling = SAMPLING_SPLINE
#define CELL .sampling = SAMPLING_CELL
#define QUARTIC .kernel = KERNEL_QUARTIC
#define WENDLAND .kernel = KERNEL_WENDLAND
#define SERIES .mean = MEAN_SERIES
#define JITTER .layout = LAYOUT_JITTER, .jitter = 0.2
/* Other operators have larger errors for the same work on a lattice (gates/gates.def). */
const struct candidate candidates_table[] = {
    CANDIDATE("so_ssph matched, cubic kernel", "so_ssph", 2, 0, MATCHED, SPLINE, .h_iso = 1),
    CANDIDATE("so_ssph matched, quartic kernel", "so_ssph", 2, 0, MATCHED, SPLINE, .h_iso = 1, QUARTIC),
    CANDIDATE("so_ssph matched, cubic kernel", "so_ssph", 1, 0, MATCHED, SPLINE, .h = 1.05),
    CANDIDATE("so_ssph matched, cell samples", "so_ssph", 1, 0, MATCHED, CELL, .h = 1.05),
    CANDIDATE("ftcs matched", "ftcs", 1, 0, MATCHED, SPLINE),
    CANDIDATE("so_ssph exact, h/dx 0.9", "so_ssph", 0, 0, EXACT, .h = 0.9),
    CANDIDATE("so_ssph exact, cell samples", "so_ssph", 0, 0, EXACT, CELL),
    CANDIDATE("so_ssph exact, quartic kernel, h/dx 1.3", "so_ssph", 0, 0, EXACT, QUARTIC, .h = 1.3),
    CANDIDATE("so_ssph exact, wendland kernel, h/dx 1.3", "so_ssph", 0, 0, EXACT, WENDLAND, .h = 1.3),
    CANDIDATE("so_ssph of order 4, exact", "so_ssph", 0, 0, EXACT, .order = 4),
    CANDIDATE("brookshaw exact", "brookshaw", 0, 0, EXACT),
    CANDIDATE("fatehi_manzari exact, h/dx 0.9", "fatehi_manzari", 0, 0, EXACT, .h = 0.9),
    CANDIDATE("ftcs at F = 1/6", "ftcs", 0, 0, EULER, .fourier = 1.0 / 6),
    CANDIDATE("brookshaw chebyshev, series mean", "brookshaw", 0, 0, CHEBYSHEV, SERIES),
    CANDIDATE("contact_ssph chebyshev, h/dx 0.7, cell samples", "contact_ssph", 1, 0, CHEBYSHEV, CELL, .h = 0.7),
    CANDIDATE("so_ssph rkl2", "so_ssph", 0, 0.125, RKL2, CELL),
    CANDIDATE("brookshaw rkl2, series mean", "brookshaw", 0, 0.125, RKL2, SERIES),
    CANDIDATE("so_ssph rk2 at F = 0.1", "so_ssph", 0, 0, .stepper = STEPPER_RK2, .fourier = 0.1),
    CANDIDATE("so_ssph euler at F = 0.1", "so_ssph", 0, 0, EULER, .fourier = 0.1),
    CANDIDATE("so_ssph euler, dt = 5e-5 s (Song)", "so_ssph", 0, 0, EULER, .h = 1.05, .dt = 5e-5),
    CANDIDATE("so_ssph jittered by 0.2 dx, rkl2", "so_ssph", 0, 0.125, RKL2, JITTER),
    CANDIDATE("fatehi_manzari jittered by 0.2 dx, rkl2", "fatehi_manzari", 0, 0.125, RKL2, JITTER),
    CANDIDATE("fo_ssph exact", "fo_ssph", 0, 0, EXACT),
    CANDIDATE("ftcs_flux at F = 0.2", "ftcs_flux", 0, 0, EULER, .fourier = 0.2),
    {0}};

/* Whether n square cells along x tile the domain with every jump on a face; for a round body, whether rings of the
 * same width fill it. */
static int fits(const struct problem *p, int n, int jumps) {
    double dx = (p->hi[0] - p->lo[0]) / n, rings = (p->radius[1] - p->radius[0]) / dx;
    if (p->shape && fabs(rings - nearbyint(rings)) > 1e-9 * rings) return 0;
    for (int a = 0; a < p->dim; a++) {
        double whole = (p->hi[a] - p->lo[a]) / dx;
        if (fabs(whole - nearbyint(whole)) > 1e-9 * whole) return 0;
        for (int k = 0; jumps && k < p->jumps[a]; k++) {
            double at = (p->jump[a][k] - p->lo[a]) / dx;
            if (fabs(at - nearbyint(at)) > 1e-9 * whole) return 0;
        }
    }
    double at = (p->interface - p->lo[0]) / dx;
    return p->materials == 1 || fabs(at - nearbyint(at)) <= 1e-9 * n;
}

int candidate_unit(const struct problem *p) {
    for (int jumps = 1; jumps >= 0; jumps--)
        for (int n = 1; n <= CANDIDATE_UNIT_MAX; n++)
            if (fits(p, n, jumps)) return n;
    return 0;
}

int candidate_member(double least, int unit) {
    return unit * (int)fmax(1, ceil(least / unit - 1e-9));
}

struct options candidate_options(const struct candidate *c, const struct experiment *e, int n) {
    struct options o = c->options;
    o.dx = (e->problem.hi[0] - e->problem.lo[0]) / n;
    o.threads = e->options.threads;
    o.domain = DOMAIN_WHOLE; /* times are those of the whole scene */
    if (e->problem.shape && method_find(c->method)->scheme) o.walls = WALLS_FIT;
    if (o.stepper == stepper_without_error(0)) o.dt = e->problem.t_end; /* one step has no error in time */
    if (c->steps > 0) o.dt = e->problem.t_end / ceil(10 + c->steps * n);
    return o;
}

static struct experiment experiment_of(const struct candidate *c, const struct experiment *e, int n) {
    struct experiment with = *e;
    with.method = method_find(c->method);
    with.options = candidate_options(c, e, n);
    return with;
}

int candidate_run(const struct candidate *c, const struct experiment *e, int n, struct result *out) {
    struct experiment with = experiment_of(c, e, n);
    return run_experiment(&with, out, NULL);
}

int candidate_solve(const struct candidate *c, const struct experiment *e, int n, struct field *f,
                    struct failure *why) {
    struct experiment with = experiment_of(c, e, n);
    return symmetry_solve(with.method, &with.problem, &with.options, f, why);
}
