/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How often a mode grows: operators on jittered clouds in the plane, by jitter, kappa_y/kappa_x, h/dx and particles.
 * Cold walls; eight draws of each cloud.  A mode counts where it grows by a tenth in 100 dx^2/kappa_x, at any time
 * step (solver/time/growth.h). */
#include "reports/operators/operators.h"

#include "reports/figure/figure.h"
#include "solver/method.h"
#include "solver/time/growth.h"
#include "verification/stability/model_problem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double TIME = 100; /* dx^2/kappa_x */

static const char *const names[] = {
    "brookshaw", "brookshaw_corrected", "schwaiger", "fatehi_manzari", "cspm",        "kernel_second", "fo_ssph",
    "so_ssph",   "flux_divergence",     "conjugate", "positive",       "voronoi_flux"};
static const int sides[] = {14, 30};
static const double jitters[] = {0.1, 0.2, 0.3, 0.4, 0.5}, ratios[] = {1, 0.25, 0.1}, lengths[] = {1.1, 1.5};

enum { SEEDS = 8, NAMES = 12, WIDTHS = 2, JITTERS = 5, RATIOS = 3, LENGTHS = 2 };
enum { CELLS = NAMES * WIDTHS * JITTERS * RATIOS * LENGTHS };

/* The draws of one kind of cloud. */
struct growth_cell {
    double rate[SEEDS]; /* kappa_x/dx^2; 0: no mode grows; NaN: the method refuses the cloud */
};

static struct model_problem problem_of(int cell, int seed) {
    int length = cell % LENGTHS, ratio = cell / LENGTHS % RATIOS, jitter = cell / (LENGTHS * RATIOS) % JITTERS,
        side = cell / (LENGTHS * RATIOS * JITTERS) % WIDTHS, name = cell / (LENGTHS * RATIOS * JITTERS * WIDTHS);
    const struct method *method = method_find(names[name]);
    return (struct model_problem){.method = method,
                                  .dim = 2,
                                  .n = sides[side],
                                  .ratio = ratios[ratio],
                                  .options = {.layout = LAYOUT_JITTER,
                                              .jitter = jitters[jitter],
                                              .h = method->scheme->h ? 0 : lengths[length], /* or its own */
                                              .seed = (unsigned long)seed}};
}

static double rate_of(struct model_problem b) {
    struct failure why;
    struct heat_operator a;
    if (model_problem_resolve(&b, b.n, &why)) return NAN;
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    if (model_problem_operator(&b, &p, &a, &why)) return NAN;
    double rate = growth_rate(&a, operator_bound(&a), TIME);
    operator_free(&a);
    return rate;
}

static struct growth_cell *take_growth(void) {
    struct growth_cell *all = xcalloc(CELLS, sizeof *all);
#pragma omp parallel for schedule(dynamic, 1)
    for (int k = CELLS * SEEDS - 1; k >= 0; k--)
        all[k / SEEDS].rate[k % SEEDS] = rate_of(problem_of(k / SEEDS, k % SEEDS));
    return all;
}

/* Number of draws that grow; *drawn: draws that were not refused; *most: their largest rate. */
static int count_growing(const struct growth_cell *c, int *drawn, double *most) {
    int growing = 0;
    *drawn = 0, *most = 0;
    for (int s = 0; s < SEEDS; s++) {
        if (isnan(c->rate[s])) continue;
        ++*drawn;
        growing += c->rate[s] > 0;
        *most = fmax(*most, c->rate[s]);
    }
    return growing;
}

/* Draws all clouds, one block per operator: jitters side by side, in groups of h/dx, ratio and particles.  The
 * growth of a mode over the run is its rate times the time. */
static void draw_growth(const struct growth_cell *all, FILE *figure) {
    figure_head(figure, "Share of eight jittered clouds with a mode that grows at any time step",
                "limit fatehi_manzari --dim 2 --layout jitter --jitter 0.4 --ratio 0.1");
    for (int name = 0; name < NAMES; name++) {
        char columns[120];
        snprintf(columns, sizeof columns, "place,%s,rate x %g dx^2/kappa_x,draws", names[name], TIME);
        figure_block(figure, columns, "%s on clouds", names[name]);
        for (int group = 0; group < WIDTHS * RATIOS * LENGTHS; group++)
            for (int j = 0; j < JITTERS; j++) {
                int side = group / (RATIOS * LENGTHS), kind = group % (RATIOS * LENGTHS), drawn;
                double most;
                int growing = count_growing(&all[((name * WIDTHS + side) * JITTERS + j) * RATIOS * LENGTHS + kind],
                                            &drawn, &most);
                if (drawn)
                    fprintf(figure, "%d,%.4g,%.3g,%d\n", group * (JITTERS + 1) + j + 1, (double)growing / drawn,
                            most * TIME, drawn);
            }
    }
}

/* Counts into the rows of that operator. */
static void count_all(const struct growth_cell *all, struct growth_count count[OPERATORS]) {
    for (int k = 0; k < CELLS; k++) {
        double most;
        int drawn, growing = count_growing(&all[k], &drawn, &most);
        for (int o = 0; o < OPERATORS; o++)
            if (operators[o].materials == 1 && strcmp(operators[o].method, names[k / (CELLS / NAMES)]) == 0)
                count[o].growing += growing, count[o].draws += drawn;
    }
}

void operators_growth(struct growth_count count[OPERATORS], FILE *figure) {
    struct growth_cell *all = take_growth();
    count_all(all, count);
    draw_growth(all, figure);
    free(all);
}
