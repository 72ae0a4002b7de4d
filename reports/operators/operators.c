/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The discrete Laplacians on the clouds that SPH has, side by side.
 *
 * Orders: a ladder for each operator, cloud and scene.  rod-cosine is smooth and insulated, and says what is kept of
 * its heat; square-step starts with jumps, averaged over cells; rect-manufactured has a source, temperatures and
 * fluxes at its walls (isotropic here, which all operators take); wall-composite has two materials of k 1 : 1000,
 * rod-contact a start that jumps where two meet.
 * Error against work: the ladders of rect-manufactured, in pairs of neighbours that the steps took.
 * Error against neighbours: rect-manufactured at one spacing, h/dx from 0.9 to 2. */
#include "reports/operators/operators.h"

#include "solver/method.h"
#include "solver/space/operator.h"
#include "reports/figure/figure.h"
#include "reports/operators/candidates.h"
#include "verification/ladder/command.h"
#include "verification/ladder/command_run.h"
#include "verification/ladder/ladder.h"
#include "verification/text/output.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct cloud_kind operators_clouds[CLOUDS] = {
    {"lattice", "", LAYOUT_JITTER, 0},
    {"hexagonal", " --layout hexagonal", LAYOUT_HEXAGONAL, 0},
    {"jitter 0.1", " --layout jitter --jitter 0.1 --seed 1", LAYOUT_JITTER, 0.1},
    {"jitter 0.3", " --layout jitter --jitter 0.3 --seed 1", LAYOUT_JITTER, 0.3},
    {"relaxed", " --layout relaxed --seed 1", LAYOUT_RELAXED, 0.5},
};

static const struct trial {
    const char *scene, *options, *dx;
    int materials;
} trials[] = {
    {"rod-cosine", "", "1/20,1/40,1/80,1/160,1/320", 1},
    {"square-step", " --sampling cell", "1/4,1/8,1/12,1/16", 1},
    {"rect-manufactured", " --set k_y=0.02", "1/10,1/20,1/30,1/50", 1},
    {"wall-composite", " --t-end 0.1", "1/20,1/40,1/80,1/160", 2},
    {"rod-contact", " --sampling cell", "1/40,1/80,1/160,1/320", 2},
};

const struct candidate_operator operators[OPERATORS] = {
    {"brookshaw", "", 1},
    {"brookshaw_corrected", "", 1},
    {"schwaiger", "", 1},
    {"fatehi_manzari", "", 1},
    {"cspm", "", 1},
    {"kernel_second", "", 1},
    {"flux_divergence", "", 1},
    {"fo_ssph", "", 1},
    {"so_ssph", "", 1},
    {"conjugate", "", 1},
    {"positive", "", 1},
    {"voronoi_flux", "", 1},
    {"brookshaw", " --mean series", 2},
    {"contact_ssph", "", 2},
    {"voronoi_flux", "", 2},
};

enum { TRIALS = sizeof trials / sizeof *trials };

/* ---- Orders ---- */

struct order {
    int tried;
    char command[240];
    struct ladder ladder;
    struct failure why;
};

static void take_order(const struct candidate_operator *o, const struct cloud_kind *c, const struct trial *t,
                       struct order *out) {
    struct command r;
    snprintf(out->command, sizeof out->command, "ladder %s %s%s%s%s --dx %s", t->scene, o->method, o->options,
             c->options, t->options, t->dx);
    out->tried = 1;
    if (!command_read(out->command, &r, &out->why))
        ladder_run(&r.experiment, &r.rungs, &out->ladder, &out->why);
    command_free(&r);
}

static struct order *take_orders(void) {
    struct order *all = xcalloc(OPERATORS * CLOUDS * TRIALS, sizeof *all);
#pragma omp parallel for schedule(dynamic, 1)
    for (int k = OPERATORS * CLOUDS * TRIALS - 1; k >= 0; k--) {
        const struct candidate_operator *o = &operators[k / (CLOUDS * TRIALS)];
        const struct trial *t = &trials[k % TRIALS];
        if (o->materials == t->materials) take_order(o, &operators_clouds[k / TRIALS % CLOUDS], t, &all[k]);
    }
    return all;
}

/* Why there is no order: a word for a table. */
static const char *without_order(const struct order *o) {
    int status = o->ladder.failure.status ? o->ladder.failure.status : o->why.status;
    return status == STATUS_UNSTABLE ? "grows" : status ? "refused" : NULL;
}

static void write_orders(const struct order *all, FILE *csv) {
    fprintf(csv, "operator,cloud,scene,order,low,high,dx [m],E1,E1/dx^2 [m^-2],heat drift,failure,command\n");
    for (int k = 0; k < OPERATORS * CLOUDS * TRIALS; k++) {
        const struct order *o = &all[k];
        if (!o->tried) continue;
        const struct ladder *l = &o->ladder;
        const struct result *finest = &l->rung[l->n > 0 ? l->n - 1 : 0];
        double dx = finest->options.dx, E = without_order(o) ? NAN : finest->error.l1;
        fprintf(csv, "%s%s,%s,%s,%.4f,%.4f,%.4f,%g,%.4e,%.4g,%.2e,%s,heatladder %s\n",
                operators[k / (CLOUDS * TRIALS)].method, operators[k / (CLOUDS * TRIALS)].options,
                operators_clouds[k / TRIALS % CLOUDS].name, trials[k % TRIALS].scene, l->slope.value, l->slope.ci[0],
                l->slope.ci[1], dx, E, E / (dx * dx), without_order(o) ? NAN : finest->heat_drift,
                without_order(o) ? without_order(o) : "", o->command);
    }
}

static void tabulate_orders(const struct order *all, FILE *md) {
    for (int t = 0; t < TRIALS; t++) {
        fprintf(md,
                "\n## %s%s --dx %s\n\nOrder of E1 with its 95 %% interval, and E1 at the finest rung."
                "\n\n| operator |",
                trials[t].scene, trials[t].options, trials[t].dx);
        for (int c = 0; c < CLOUDS; c++) fprintf(md, " %s |", operators_clouds[c].name);
        fprintf(md, "\n|---|");
        for (int c = 0; c < CLOUDS; c++) fprintf(md, "---|");
        for (int k = 0; k < OPERATORS; k++) {
            if (operators[k].materials != trials[t].materials) continue;
            fprintf(md, "\n| `%s%s` |", operators[k].method, operators[k].options);
            for (int c = 0; c < CLOUDS; c++) {
                const struct order *o = &all[(k * CLOUDS + c) * TRIALS + t];
                const struct slope *s = &o->ladder.slope;
                if (without_order(o))
                    fprintf(md, " %s |", without_order(o));
                else
                    fprintf(md, " %.2f (%.2f to %.2f), %.1e |", s->value, s->ci[0], s->ci[1],
                            o->ladder.rung[o->ladder.n - 1].error.l1);
            }
        }
        fprintf(md, "\n");
    }
}

/* ---- Error against work ---- */

static const int worked_on[] = {0, 3, 4}; /* of the clouds */
enum { WORKED_ON = 3, WORKED = 2 /* of the trials */ };
static const double ENOUGH = 1e-3; /* error to be reached */

/* The interactions (pairs of neighbours in all steps and stages) at which E1 falls to `error`, between two rungs on
 * the straight line of their logarithms; NaN where none is that good, or all are. */
static double work_at(const struct ladder *l, double error) {
    for (int i = 1; i < l->n; i++) {
        const struct result *coarse = &l->rung[i - 1], *fine = &l->rung[i];
        if (coarse->error.l1 < error || fine->error.l1 > error) continue;
        double part = log(coarse->error.l1 / error) / log(coarse->error.l1 / fine->error.l1);
        double ratio = (double)fine->cost.interactions / (double)coarse->cost.interactions;
        return (double)coarse->cost.interactions * pow(ratio, part);
    }
    return NAN;
}

static const struct order *worked(const struct order *all, int row, int cloud) {
    return &all[(row * CLOUDS + worked_on[cloud]) * TRIALS + WORKED];
}

static void write_work(const struct order *all, FILE *out) {
    figure_head(out, "rect-manufactured: error against work");
    fprintf(out,
            "# command: heatladder ladder rect-manufactured so_ssph --set k_y=0.02 --layout relaxed --seed 1 --dx "
            "%s\n",
            trials[WORKED].dx);
    for (int k = 0; k < WORKED_ON * OPERATORS; k++) {
        const struct candidate_operator *o = &operators[k % OPERATORS];
        const struct order *order = worked(all, k % OPERATORS, k / OPERATORS);
        if (o->materials != trials[WORKED].materials) continue;
        fprintf(out, "\n\n# %s %s\ninteractions,%s,dx [m]\n", o->method,
                operators_clouds[worked_on[k / OPERATORS]].name, o->method);
        for (int i = 0; i < order->ladder.n && !without_order(order); i++) {
            const struct result *r = &order->ladder.rung[i];
            fprintf(out, "%lld,%.5e,%g\n", r->cost.interactions, r->error.l1, r->options.dx);
        }
    }
}

static void tabulate_work(const struct order *all, FILE *md) {
    fprintf(
        md,
        "\n## Work for E1 = %g, rect-manufactured\n\nInteractions (pairs of neighbours, in all steps and stages), "
        "between the rungs of the ladders above; -: not reached.\n\n| operator |",
        ENOUGH);
    for (int c = 0; c < WORKED_ON; c++) fprintf(md, " %s |", operators_clouds[worked_on[c]].name);
    fprintf(md, "\n|---|");
    for (int c = 0; c < WORKED_ON; c++) fprintf(md, "---|");
    for (int k = 0; k < OPERATORS; k++) {
        if (operators[k].materials != trials[WORKED].materials) continue;
        fprintf(md, "\n| `%s` |", operators[k].method);
        for (int c = 0; c < WORKED_ON; c++) {
            const struct order *order = worked(all, k, c);
            double work = without_order(order) ? NAN : work_at(&order->ladder, ENOUGH);
            if (isnan(work))
                fprintf(md, " - |");
            else
                fprintf(md, " %.2e |", work);
        }
    }
    fprintf(md, "\n");
}

/* ---- Error against neighbours ---- */

/* Whether --h sets how many neighbours there are. */
static int has_h(const char *method) {
    return !method_find(method)->scheme->cells;
}

static const double lengths[] = {0.9, 1.0, 1.1, 1.2, 1.3, 1.5, 1.75, 2};
static const int drawn[] = {0, 2, 4}; /* of the clouds */

enum { LENGTHS = 8, DRAWN = 3 };

struct neighbours_run {
    int status;
    double neighbours, error;
    struct failure why;
};

static void take_neighbours(int k, struct neighbours_run *n) {
    const struct candidate_operator *o = &operators[k / LENGTHS % OPERATORS];
    struct command_run run;
    if (o->materials != 1 || !has_h(o->method)) return;
    command_run_line(&run, "run rect-manufactured %s --set k_y=0.02 --dx 0.025 --h %g%s", o->method,
                     lengths[k % LENGTHS], operators_clouds[drawn[k / (LENGTHS * OPERATORS)]].options);
    n->status = command_run_check(&run, &n->why);
    n->neighbours = (double)run.result.cost.interactions / (double)run.result.cost.updates;
    n->error = run.result.error.l1;
    command_run_free(&run);
}

static int write_neighbours(FILE *out, struct failure *why) {
    enum { RUNS = DRAWN * OPERATORS * LENGTHS };
    struct neighbours_run *all = xcalloc(RUNS, sizeof *all);
    int status = STATUS_OK;
#pragma omp parallel for schedule(dynamic, 1)
    for (int k = RUNS - 1; k >= 0; k--) take_neighbours(k, &all[k]);
    figure_head(out, "rect-manufactured, dx = 0.025 m: error against neighbours");
    fprintf(
        out,
        "# command: heatladder run rect-manufactured so_ssph --set k_y=0.02 --dx 0.025 --h 1.1 --layout relaxed\n");
    for (int k = 0; k < RUNS && !status; k++) {
        const struct candidate_operator *o = &operators[k / LENGTHS % OPERATORS];
        if (o->materials != 1 || !has_h(o->method)) continue;
        if (k % LENGTHS == 0)
            fprintf(out, "\n\n# %s %s\nneighbours,%s,h/dx\n", o->method,
                    operators_clouds[drawn[k / (LENGTHS * OPERATORS)]].name, o->method);
        if (all[k].status == STATUS_INPUT) /* what grows, or is singular, is left out */
            status = STATUS_INPUT, *why = all[k].why;
        else if (!all[k].status)
            fprintf(out, "%.3f,%.5e,%g\n", all[k].neighbours, all[k].error, lengths[k % LENGTHS]);
    }
    free(all);
    return status;
}

/* ---- What one chooses by ---- */

static double finest_error(const struct order *o) {
    return o->ladder.rung[o->ladder.n - 1].error.l1;
}

static void choose_by_orders(const struct order *all, const struct trait *traits, struct choice choice[OPERATORS]) {
    static const int judged[] = {0, WORKED, 3}; /* trials, by the number of materials */
    for (int k = 0; k < OPERATORS; k++) {
        struct choice *c = &choice[k];
        const struct order *of = &all[k * CLOUDS * TRIALS];
        c->order[0] = INFINITY, c->order[1] = -INFINITY;
        for (int cloud = 0; cloud < CLOUDS; cloud++) {
            const struct order *o = &of[cloud * TRIALS + judged[operators[k].materials]], *kept = &of[cloud * TRIALS];
            if (without_order(o))
                c->failed++;
            else {
                c->order[0] = fmin(c->order[0], o->ladder.slope.value);
                c->order[1] = fmax(c->order[1], o->ladder.slope.value);
                c->worst = fmax(c->worst, finest_error(o) / finest_error(&of[judged[operators[k].materials]]));
            }
            if (kept->tried && !without_order(kept))
                c->drift = fmax(c->drift, fabs(kept->ladder.rung[kept->ladder.n - 1].heat_drift));
        }
        c->step[0] = traits[k * CLOUDS + OPERATORS_LATTICE].limit;
        c->step[1] = traits[k * CLOUDS + OPERATORS_JITTER_03].limit;
        for (int cloud = 0; cloud < WORKED_ON; cloud++) {
            const struct order *o = &of[worked_on[cloud] * TRIALS + judged[operators[k].materials]];
            c->pairs[cloud] = !o->tried || without_order(o) ? NAN : work_at(&o->ladder, ENOUGH);
        }
    }
}

int operators_write(const char *dir, struct failure *why) {
    enum { PAGES = 6 };
    struct output page[PAGES] = {{0}};
    struct choice choice[OPERATORS] = {{0}};
    double start = omp_get_wtime();
    int status = output_directory(dir, "operators.csv", why);
    FILE *csv = output_open(&page[0], "%s/operators.csv", dir), *md = output_open(&page[1], "%s/operators.md", dir);
    FILE *error = output_open(&page[2], "%s/operators_error.csv", dir);
    if (!status) {
        struct order *all = take_orders();
        struct trait *traits = operators_take_traits();
        struct growth_cell *growth = operators_take_growth(choice);
        choose_by_orders(all, traits, choice);
        fprintf(md, "# Discrete Laplacians side by side\n\n`grows`: a mode grows at any step.\n");
        operators_choice(choice, output_open(&page[3], "%s/operators_choice.csv", dir), md);
        write_orders(all, csv);
        tabulate_orders(all, md);
        tabulate_work(all, md);
        write_work(all, output_open(&page[5], "%s/operators_work.csv", dir));
        fprintf(csv, "\n\n");
        operators_traits(traits, csv, md);
        fprintf(csv, "\n\n");
        operators_growth(growth, csv, md, output_open(&page[4], "%s/operators_growth.csv", dir));
        free(all);
        free(traits);
        free(growth);
        status = write_neighbours(error, why);
    }
    if (!status) status = output_close(page, PAGES, why);
    output_drop(page, PAGES);
    if (!status) printf("%s/operators.md, tables and data of three figures (%.1f s)\n", dir, omp_get_wtime() - start);
    return status;
}
