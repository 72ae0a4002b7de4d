/* The candidates of `choose` and `bench`. */
#include "verification/candidate.h"

#include "references/scene.h"
#include "verification/request.h"
#include "verification/run.h"

#include <math.h>
#include <string.h>

#define MATCHED .stepper = STEPPER_MATCHED, .sampling = SAMPLING_SPLINE
const struct candidate candidates_table[] = {
    {"so_ssph matched, cubic kernel", "so_ssph", {MATCHED, .h_iso = 1}, 2, 0},
    {"so_ssph matched, quartic kernel", "so_ssph", {MATCHED, .h_iso = 1, .kernel = KERNEL_QUARTIC}, 2, 0},
    {"so_ssph matched, wendland kernel", "so_ssph", {MATCHED, .h_iso = 1, .kernel = KERNEL_WENDLAND}, 2, 0},
    {"so_ssph matched, cubic kernel", "so_ssph", {MATCHED, .h = 1.05}, 1, 0},
    {"ftcs matched", "ftcs", {MATCHED}, 1, 0},
    {"so_ssph exact, h/dx 1.05", "so_ssph", {.stepper = STEPPER_EXACT, .h = 1.05}, 0, 0},
    {"so_ssph exact, cell samples", "so_ssph", {.stepper = STEPPER_EXACT, .sampling = SAMPLING_CELL}, 0, 0},
    {"so_ssph of order 4, exact", "so_ssph", {.stepper = STEPPER_EXACT, .order = 4}, 0, 0},
    {"brookshaw exact", "brookshaw", {.stepper = STEPPER_EXACT}, 0, 0},
    {"ftcs at F = 1/6", "ftcs", {.stepper = STEPPER_EULER, .fourier = 1.0 / 6}, 0, 0},
    {"ftcs at F = 0.2, cell samples",
     "ftcs",
     {.stepper = STEPPER_EULER, .fourier = 0.2, .sampling = SAMPLING_CELL},
     0,
     0},
    {"so_ssph rkl2", "so_ssph", {.stepper = STEPPER_RKL2, .sampling = SAMPLING_CELL}, 0, 0.125},
    {"brookshaw rkl2, series mean", "brookshaw", {.stepper = STEPPER_RKL2, .mean = MEAN_SERIES}, 0, 0.125},
    {0}};
#undef MATCHED

struct options candidate_options(const struct candidate *c, const struct request *r, int n) {
    struct options o = c->options;
    o.dx = (r->problem.hi[0] - r->problem.lo[0]) / n;
    o.threads = r->options.threads;
    if (c->steps > 0) o.dt = r->problem.t_end / ceil(10 + c->steps * n);
    return o;
}

int candidate_run(const struct candidate *c, const struct request *r, int n, struct result *out) {
    struct request with = *r;
    for (int i = 0; methods[i]; i++)
        if (strcmp(methods[i]->name, c->method) == 0) with.method = methods[i];
    struct options o = candidate_options(c, r, n);
    return run_request(&with, &o, out, NULL);
}

double candidate_work(const struct result *r) {
    double n = (double)r->particles;
    if (r->steps == 0) return n * (10 * log2(n) + 60);
    return (double)r->interactions + 2 * (double)r->updates;
}
