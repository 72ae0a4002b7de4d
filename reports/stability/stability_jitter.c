/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Clouds under jitter: the worst condition number and the sign of the largest real part. */
#include "reports/stability/stability.h"

#include "solver/particles/ssph.h"
#include "verification/stability/step_limit.h"

#include <math.h>
#include <stdlib.h>

enum { RATIOS = 27, JITTERS = 11, SEEDS = 3, SIDE = 12, METHODS = 2 };
static const char *const jittered[METHODS] = {"so_ssph", "fo_ssph"};

struct cell {
    double condition, growth; /* the worst of the seeds; NaN growth where a cloud was refused */
};

static int worst_condition(const struct model_problem *b, const struct neighbourhood *nb, void *worst,
                           struct failure *why) {
    double *most = worst;
    (void)why;
    *most = fmax(*most, ssph_condition(nb, b->options.kernel, b->method->scheme->sweeps == 2 ? 1 : 2));
    return STATUS_OK;
}

static struct cell measure_cloud(const struct model_problem *b) {
    struct cell cell = {0, NAN};
    struct failure why;
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    struct cloud c;
    struct step_limit l;
    if (model_problem_cloud(b, &p, &c, &why)) return cell;
    model_problem_around(b, &c, c.n, worst_condition, &cell.condition, &why);
    layout_cloud_free(&c);
    if (!step_limit_predict(b, &l, &why)) cell.growth = l.grows ? l.growth : fmin(l.growth, 0);
    return cell;
}

static struct cell worst_of_seeds(int i) {
    struct cell worst = {0, -INFINITY};
    for (unsigned long seed = 1; seed <= SEEDS; seed++) {
        struct model_problem b =
            stability_model(jittered[i / (RATIOS * JITTERS)], 2, KERNEL_CUBIC, 0.7 + 0.05 * (i % RATIOS));
        struct failure why;
        b.options.layout = LAYOUT_JITTER;
        b.options.jitter = 0.05 * (i / RATIOS % JITTERS);
        b.options.seed = seed;
        if (model_problem_resolve(&b, SIDE, &why)) return (struct cell){NAN, NAN};
        struct cell cell = measure_cloud(&b);
        worst.condition = fmax(worst.condition, cell.condition);
        if (!(cell.growth <= worst.growth)) worst.growth = cell.growth;
        if (isnan(worst.growth)) break;
    }
    return worst;
}

int stability_jitter_page(FILE *out, struct failure *why) {
    (void)why;
    enum { CASES = RATIOS * JITTERS * METHODS };
    struct cell *cell = xcalloc(CASES, sizeof *cell);
    stability_head(out, "Particles off the lattice, 2D, cubic kernel, the worst of three seeds",
                   "limit fo_ssph --dim 2 --h 1.1 --layout jitter --jitter 0.2 --seed 3");
#pragma omp parallel for schedule(dynamic, 4)
    for (int i = 0; i < CASES; i++) cell[CASES - 1 - i] = worst_of_seeds(CASES - 1 - i);
    for (int i = 0; i < CASES; i++) {
        if (i % (RATIOS * JITTERS) == 0)
            stability_block(out,
                            "h/dx,jitter,log10(condition),growth_kappa/dx^2,sign (1 grows, -1 decays, nan refused)",
                            "%s", jittered[i / (RATIOS * JITTERS)]);
        double sign = isnan(cell[i].growth) ? NAN : cell[i].growth > 0 ? 1 : -1;
        fprintf(out, "%.4g,%.4g,%.4g,%.4g,%.0f\n", 0.7 + 0.05 * (i % RATIOS), 0.05 * (i / RATIOS % JITTERS),
                log10(cell[i].condition), cell[i].growth, sign);
        if (i % RATIOS == RATIOS - 1) fputc('\n', out);
    }
    free(cell);
    return STATUS_OK;
}
