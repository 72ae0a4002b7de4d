/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The discrete Laplacians of SPH compared on the same clouds.
 *
 * Orders: one ladder per operator, cloud and scene.  rod-cosine is smooth and insulated and shows the conservation
 * of heat; square-step has discontinuous initial data, averaged over cells; rect-manufactured has a source,
 * temperatures and fluxes at its walls (isotropic here, which all operators support); wall-composite has two
 * materials with conductivities of 1 : 1000; rod-contact has a jump of the initial data between two materials.
 * Error against work: the ladders of rect-manufactured, with the work in neighbour pairs times steps.  Error against
 * neighbours: rect-manufactured at one spacing, with h/dx from 0.9 to 2. */
#include "reports/operators/operators.h"

#include "solver/method.h"
#include "solver/space/operator.h"
#include "reports/figure/document.h"
#include "reports/figure/figure.h"
#include "reports/figure/reading.h"
#include "verification/case/command.h"
#include "verification/judge/ladder.h"
#include "verification/stability/model_problem.h"
#include "verification/stability/spectrum.h"
#include "verification/text/output.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

/* The clouds and the operators side by side. */
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
    if (!command_read(out->command, &r, &out->why)) ladder_run(&r.experiment, &r.rungs, &out->ladder, &out->why);
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

static double finest_error(const struct order *o) {
    return o->ladder.rung[o->ladder.n - 1].error[NORM_L1];
}

static void tabulate_orders(const struct order *all, struct document *d) {
    for (int t = 0; t < TRIALS; t++) {
        struct table out = table_create(1 + CLOUDS, 1);
        table_add(&out, "operator");
        for (int c = 0; c < CLOUDS; c++) table_add(&out, "%s", operators_clouds[c].name);
        for (int k = 0; k < OPERATORS; k++) {
            if (operators[k].materials != trials[t].materials) continue;
            table_add(&out, "`%s%s`", operators[k].method, operators[k].options);
            for (int c = 0; c < CLOUDS; c++) {
                const struct order *o = &all[(k * CLOUDS + c) * TRIALS + t];
                const struct slope *s = &o->ladder.slope;
                if (without_order(o))
                    table_add(&out, "%s", without_order(o));
                else
                    table_add(&out, "%.2f (%.2f to %.2f), %.1e", s->value, s->ci[0], s->ci[1], finest_error(o));
            }
        }
        document_heading(d, "%s%s --dx %s", trials[t].scene, trials[t].options, trials[t].dx);
        document_text(d, "Order of E1 with its 95 %% interval, and E1 at the finest rung.");
        document_table(d, &out);
    }
}

/* ---- Error against work ---- */

static const int worked_on[] = {0, 3, 4}; /* indices of clouds */
enum { WORKED_ON = 3, WORKED = 2 /* trials */ };
static const double ENOUGH = 1e-3; /* error to be reached */

/* The interactions (pairs of neighbours in all steps and stages) at which E1 falls to `error`, between two rungs on
 * the straight line of their logarithms; NaN where none is that good, or all are. */
static double work_at(const struct ladder *l, double error) {
    for (int i = 1; i < l->n; i++) {
        const struct result *coarse = &l->rung[i - 1], *fine = &l->rung[i];
        if (coarse->error[NORM_L1] < error || fine->error[NORM_L1] > error) continue;
        double part = log(coarse->error[NORM_L1] / error) / log(coarse->error[NORM_L1] / fine->error[NORM_L1]);
        double ratio = (double)fine->cost.interactions / (double)coarse->cost.interactions;
        return (double)coarse->cost.interactions * pow(ratio, part);
    }
    return NAN;
}

static const struct order *worked(const struct order *all, int row, int cloud) {
    return &all[(row * CLOUDS + worked_on[cloud]) * TRIALS + WORKED];
}

static void write_work(const struct order *all, FILE *out) {
    figure_head(out, "rect-manufactured: error against work",
                "ladder rect-manufactured so_ssph --set k_y=0.02 --layout relaxed --seed 1 --dx %s",
                trials[WORKED].dx);
    for (int k = 0; k < WORKED_ON * OPERATORS; k++) {
        const struct candidate_operator *o = &operators[k % OPERATORS];
        const struct order *order = worked(all, k % OPERATORS, k / OPERATORS);
        char columns[80];
        if (o->materials != trials[WORKED].materials) continue;
        snprintf(columns, sizeof columns, "interactions,%s,dx [m]", o->method);
        figure_block(out, columns, "%s %s", o->method, operators_clouds[worked_on[k / OPERATORS]].name);
        for (int i = 0; i < order->ladder.n && !without_order(order); i++) {
            const struct result *r = &order->ladder.rung[i];
            fprintf(out, "%lld,%.5e,%g\n", r->cost.interactions, r->error[NORM_L1], r->options.dx);
        }
    }
}

/* ---- Error against neighbours ---- */

/* 1 if --h sets the number of neighbours. */
static int has_h(const char *method) {
    return !method_find(method)->scheme->cells;
}

static const double lengths[] = {0.9, 1.0, 1.1, 1.2, 1.3, 1.5, 1.75, 2};
static const int drawn[] = {0, 2, 4}; /* indices of clouds */

enum { LENGTHS = 8, DRAWN = 3 };

/* Growing or singular operators are omitted. */
static int put_neighbours(const struct reading *r, FILE *out, struct failure *why) {
    for (int k = 0; k < DRAWN * OPERATORS; k++) {
        const struct candidate_operator *o = &operators[k % OPERATORS];
        char columns[80];
        if (o->materials != 1 || !has_h(o->method)) continue;
        snprintf(columns, sizeof columns, "neighbours,%s,h/dx", o->method);
        figure_block(out, columns, "%s %s", o->method, operators_clouds[drawn[k / OPERATORS]].name);
        for (int i = 0; i < LENGTHS; i++, r++) {
            if (r->failure.status == STATUS_INPUT) return *why = r->failure, STATUS_INPUT;
            if (!r->failure.status) reading_row(r, "interactions/updates error_l1 h", out);
        }
    }
    return STATUS_OK;
}

static int write_neighbours(FILE *out, struct failure *why) {
    enum { RUNS = DRAWN * OPERATORS * LENGTHS };
    struct reading *all = xcalloc(RUNS, sizeof *all);
    int count = 0, status;
    for (int k = 0; k < RUNS; k++) {
        const struct candidate_operator *o = &operators[k / LENGTHS % OPERATORS];
        if (o->materials != 1 || !has_h(o->method)) continue;
        reading_set(&all[count++], "run rect-manufactured %s --set k_y=0.02 --dx 0.025 --h %g%s", o->method,
                    lengths[k % LENGTHS], operators_clouds[drawn[k / (LENGTHS * OPERATORS)]].options);
    }
    reading_run(all, count, why);
    figure_head(out, "rect-manufactured, dx = 0.025 m: error against neighbours",
                "run rect-manufactured so_ssph --set k_y=0.02 --dx 0.025 --h 1.1 --layout relaxed");
    status = put_neighbours(all, out, why);
    reading_free(all, count);
    free(all);
    return status;
}

/* ---- Which to take ---- */

/* The largest stable step of Euler's method between cold walls, dx^2/kappa, by all eigenvalues; 0 where a mode grows,
 * NaN where the operator refuses the cloud. */
static double step_of(const struct candidate_operator *o, const struct cloud_kind *c) {
    struct model_problem b = {.method = method_find(o->method),
                              .dim = 2,
                              .n = 14,
                              .options = {.layout = c->layout, .jitter = c->jitter, .seed = 1}};
    struct heat_operator a;
    struct spectrum s;
    struct failure why;
    if (model_problem_resolve(&b, b.n, &why)) return NAN;
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    if (model_problem_operator(&b, &p, &a, &why)) return NAN;
    int status = spectrum_create(&s, &a, &b.step, &why);
    operator_free(&a);
    if (status) return NAN;
    double limit = s.limit;
    spectrum_free(&s);
    return limit;
}

/* The largest drift of rod-cosine's heat on a cloud. */
static void put_heat(const struct order *of, struct table *t) {
    double drift = 0;
    for (int c = 0; c < CLOUDS; c++) {
        const struct ladder *l = &of[c * TRIALS].ladder;
        if (!without_order(&of[c * TRIALS])) drift = fmax(drift, fabs(l->rung[l->n - 1].heat_drift));
    }
    if (drift < 1e-11)
        table_add(t, "kept"); /* to rounding */
    else
        table_add(t, "%.0e", drift);
}

/* Least and largest order on the clouds, and the largest E1 of a cloud over that of the lattice. */
static void put_order(const struct order *of, int trial, struct table *t) {
    double least = INFINITY, most = -INFINITY, worst = 0;
    int failed = 0;
    for (int c = 0; c < CLOUDS; c++) {
        const struct order *o = &of[c * TRIALS + trial];
        if (without_order(o)) {
            failed++;
            continue;
        }
        least = fmin(least, o->ladder.slope.value), most = fmax(most, o->ladder.slope.value);
        worst = fmax(worst, finest_error(o) / finest_error(&of[trial]));
    }
    if (failed)
        table_add(t, "%.2f to %.2f, none on %d of %d|%.2g", least, most, failed, CLOUDS, worst);
    else
        table_add(t, "%.2f to %.2f|%.2g", least, most, worst);
}

static void put_work(const struct order *of, int trial, struct table *t) {
    for (int c = 0; c < WORKED_ON; c++) {
        const struct order *o = &of[worked_on[c] * TRIALS + trial];
        table_number(t, "%.1e", without_order(o) ? NAN : work_at(&o->ladder, ENOUGH), "-");
    }
}

static void tabulate_choice(const struct order *all, const struct growth_count *growth, struct document *d) {
    struct table one = table_headed(1, "operator|heat drift|order|worst|growing|step|step at jitter 0.3|work: "
                                       "lattice|jitter 0.3|relaxed"),
                 two = table_headed(1, "operator|order|worst|work: lattice|jitter 0.3|relaxed");
    for (int k = 0; k < OPERATORS; k++) {
        const struct order *of = &all[k * CLOUDS * TRIALS];
        const struct candidate_operator *o = &operators[k];
        struct table *t = o->materials == 1 ? &one : &two;
        table_add(t, "`%s%s`", o->method, o->options);
        if (o->materials == 1) put_heat(of, t);
        put_order(of, o->materials == 1 ? WORKED : 3, t);
        if (o->materials == 1)
            table_add(t, "%d of %d|%.3f|%.3f", growth[k].growing, growth[k].draws, step_of(o, &operators_clouds[0]),
                      step_of(o, &operators_clouds[3]));
        put_work(of, o->materials == 1 ? WORKED : 3, t);
    }
    document_heading(d, "Which to take");
    document_text(d,
                  "Heat drift: the largest on a cloud (rod-cosine). Order: least and largest on the five clouds "
                  "(rect-manufactured). Worst: the largest E1 of a cloud over that of the lattice. Growing: draws of "
                  "jittered clouds (jitter 0.1 to 0.5, kappa_y/kappa_x 1 to 0.1, h/dx 1.1 and 1.5, 196 and 900 "
                  "particles) on which a mode grows at any step. Step: the largest stable one, dx^2/kappa, on the "
                  "lattice and at jitter 0.3 (0: none). Work: pairs of neighbours, in all steps, for E1 = %g; "
                  "-: not reached.",
                  ENOUGH);
    document_table(d, &one);
    document_text(d, "Two materials, k 1 : 1000: the same on wall-composite.");
    document_table(d, &two);
}

int operators_write(const char *dir, struct failure *why) {
    enum { DATA = 3 };
    struct output data[DATA];
    struct document d;
    struct growth_count growth[OPERATORS] = {{0}};
    double start = omp_get_wtime();
    if (output_directory(dir, "operators.md", why)) return why->status;
    struct order *all = take_orders();
    document_open(&d, dir, "operators", "Discrete Laplacians side by side");
    operators_growth(growth, output_open(&data[0], "%s/operators_growth.csv", dir));
    write_work(all, output_open(&data[1], "%s/operators_work.csv", dir));
    int status = write_neighbours(output_open(&data[2], "%s/operators_error.csv", dir), why);
    tabulate_choice(all, growth, &d);
    tabulate_orders(all, &d);
    if (!status) status = output_close(data, DATA, why);
    if (!status) status = document_close(&d, why);
    output_drop(data, DATA);
    document_drop(&d);
    free(all);
    if (!status) printf("%s/operators.md, data of three figures (%.1f s)\n", dir, omp_get_wtime() - start);
    return status;
}
