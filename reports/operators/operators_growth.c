/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How often a mode grows: operators on jittered clouds in the plane, by jitter, kappa_y/kappa_x, h/dx and particles.
 * Cold walls; eight draws of each cloud.  A mode counts where it grows by a tenth in 100 dx^2/kappa_x, at any time
 * step (solver/time/growth.h). */
#include "reports/operators/operators.h"

#include "reports/figure/figure.h"
#include "reports/operators/candidates.h"
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

enum { SEEDS = 8, NAMES = 12, SIDES = 2, JITTERS = 5, RATIOS = 3, LENGTHS = 2 };
enum { CELLS = NAMES * SIDES * JITTERS * RATIOS * LENGTHS };

/* The draws of one kind of cloud. */
struct growth_cell {
    double rate[SEEDS]; /* kappa_x/dx^2; 0: no mode grows; NaN: the method refuses the cloud */
};

static struct model_problem problem_of(int cell, int seed) {
    int length = cell % LENGTHS, ratio = cell / LENGTHS % RATIOS, jitter = cell / (LENGTHS * RATIOS) % JITTERS,
        side = cell / (LENGTHS * RATIOS * JITTERS) % SIDES, name = cell / (LENGTHS * RATIOS * JITTERS * SIDES);
    const struct method *method = method_find(names[name]);
    return (struct model_problem){.method = method,
                                  .dim = 2,
                                  .n = sides[side],
                                  .ratio = ratios[ratio],
                                  .options = {.layout = LAYOUT_JITTER,
                                              .jitter = jitters[jitter],
                                              .h = method->scheme->h ? 0 : lengths[length], /* or its own */
                                              .seed = (unsigned long)seed},
                                  .step = {STEPPER_EULER, 0}};
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

/* How many draws grow; *drawn were not refused, *most is their largest rate. */
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

static void list_growth(const struct growth_cell *all, FILE *csv) {
    fprintf(csv, "operator,particles,jitter,kappa_y/kappa_x,h/dx,growing,draws,largest rate [kappa_x/dx^2]\n");
    for (int k = 0; k < CELLS; k++) {
        struct model_problem b = problem_of(k, 0);
        double most;
        int drawn, growing = count_growing(&all[k], &drawn, &most);
        fprintf(csv, "%s,%d,%g,%g,%g,%d,%d,%.3g\n", b.method->name, b.n * b.n, b.options.jitter, b.ratio, b.options.h,
                growing, drawn, most);
    }
}

/* The six clouds of one operator, number of particles and jitter, from cell `first`; no line where none grows. */
static int tabulate_row(const struct growth_cell *first, const struct model_problem *b, FILE *md) {
    int drawn, growing = 0;
    double most;
    for (int k = 0; k < RATIOS * LENGTHS; k++) growing += count_growing(&first[k], &drawn, &most);
    if (!growing) return 0;
    fprintf(md, "| `%s` | %g |", b->method->name, b->options.jitter);
    for (int k = 0; k < RATIOS * LENGTHS; k++) {
        int n = count_growing(&first[k], &drawn, &most);
        if (!drawn)
            fprintf(md, " refused |");
        else if (!n)
            fprintf(md, " 0 of %d |", drawn);
        else
            fprintf(md, " %d of %d, %.2g |", n, drawn, most);
    }
    fprintf(md, "\n");
    return growing;
}

/* All clouds, a block for each operator: jitters side by side, in groups of h/dx, ratio and particles.  How far a
 * mode goes in the time is its rate times that. */
static void draw_growth(const struct growth_cell *all, FILE *figure) {
    figure_head(figure, "Share of eight jittered clouds with a mode that grows at any time step");
    fprintf(figure, "# command: heatladder limit fatehi_manzari --dim 2 --layout jitter --jitter 0.4 --ratio 0.1\n");
    for (int name = 0; name < NAMES; name++) {
        fprintf(figure, "\n\n# %s on clouds\nplace,%s,rate x %g dx^2/kappa_x,draws\n", names[name], names[name],
                TIME);
        for (int group = 0; group < SIDES * RATIOS * LENGTHS; group++)
            for (int j = 0; j < JITTERS; j++) {
                int side = group / (RATIOS * LENGTHS), kind = group % (RATIOS * LENGTHS), drawn;
                double most;
                int growing = count_growing(&all[((name * SIDES + side) * JITTERS + j) * RATIOS * LENGTHS + kind],
                                            &drawn, &most);
                if (drawn)
                    fprintf(figure, "%d,%.4g,%.3g,%d\n", group * (JITTERS + 1) + j + 1, (double)growing / drawn,
                            most * TIME, drawn);
            }
    }
}

static void tabulate_growth(const struct growth_cell *all, FILE *md) {
    int grows[NAMES] = {0};
    fprintf(md,
            "\n## Growing modes in the plane\n\nOf %d draws of a jittered cloud between cold walls, those with a "
            "mode that grows at any time step, and the largest rate in kappa_x/dx^2.  Rows without one are in "
            "operators.csv.\n",
            SEEDS);
    for (int side = 0; side < SIDES; side++) {
        fprintf(md, "\n### %d particles\n\n| operator | jitter |", sides[side] * sides[side]);
        for (int k = 0; k < RATIOS * LENGTHS; k++)
            fprintf(md, " kappa_y/kappa_x %g, h/dx %g |", ratios[k / LENGTHS], lengths[k % LENGTHS]);
        fprintf(md, "\n|---|---|");
        for (int k = 0; k < RATIOS * LENGTHS; k++) fprintf(md, "---|");
        fprintf(md, "\n");
        for (int k = 0; k < NAMES * JITTERS; k++) {
            int name = k / JITTERS, cell = ((name * SIDES + side) * JITTERS + k % JITTERS) * RATIOS * LENGTHS;
            struct model_problem b = problem_of(cell, 0);
            grows[name] += tabulate_row(&all[cell], &b, md);
        }
    }
    fprintf(md, "\nNo mode grows of:");
    for (int k = 0; k < NAMES; k++)
        if (!grows[k]) fprintf(md, " `%s`", names[k]);
    fprintf(md, "\n");
}

/* Counts into the rows of `choice` whose operator it is. */
static void count_all(const struct growth_cell *all, struct choice choice[OPERATORS]) {
    for (int k = 0; k < CELLS; k++) {
        double most;
        int drawn, growing = count_growing(&all[k], &drawn, &most);
        const char *name = names[k / (CELLS / NAMES)];
        for (int o = 0; o < OPERATORS; o++)
            if (operators[o].materials == 1 && strcmp(operators[o].method, name) == 0)
                choice[o].growing += growing, choice[o].draws += drawn;
    }
}

struct growth_cell *operators_take_growth(struct choice choice[OPERATORS]) {
    struct growth_cell *all = take_growth();
    count_all(all, choice);
    return all;
}

void operators_growth(const struct growth_cell *all, FILE *csv, FILE *md, FILE *figure) {
    list_growth(all, csv);
    tabulate_growth(all, md);
    draw_growth(all, figure);
}
