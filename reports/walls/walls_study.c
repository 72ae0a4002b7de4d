/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls that cut the lattice at arbitrary positions: accuracy and stability of each treatment with so_ssph.
 *
 * Round walls: eight lattices (origin and angle by seeds 1 to 8) at each spacing, in one fit of the order.  Steps
 * and growth are from all eigenvalues of the operator at dx = 0.125, the worst of four lattices.  Plane walls are in
 * walls_planes.c. */
#include "reports/walls/walls_study.h"

#include "reports/figure/document.h"
#include "reports/figure/figure.h"
#include "reports/walls/walls_planes.h"
#include "reports/walls/walls_price.h"
#include "solver/method.h"
#include "verification/judge/command_run.h"
#include "verification/judge/slope.h"
#include "verification/text/output.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TREATMENTS = 7 };
static const char *const treatments[TREATMENTS] = {"mirror", "fixed", "distance", "average",
                                                   "image",  "fit",   "one_sided"};
static const struct body {
    const char *name, *scene;
    const char *derived[TREATMENTS]; /* order in E1; NULL: refused */
} bodies[] = {
    {"disc held", "disc-mode --set wall=1", {NULL, "1", "1", "1", "2", "2", "2"}},
    {"disc flux", "disc-mode --set wall=2", {NULL, NULL, NULL, "1", "1", "2", "2"}},
    {"disc cooled", "disc-mode --set wall=3", {NULL, NULL, NULL, NULL, "1", "2", "2"}},
    {"annulus held and flux", "annulus", {NULL, NULL, NULL, "1", "1", "2", "2"}},
};
static const double spacings[] = {0.1, 0.07, 0.05, 0.035, 0.025};
enum { BODIES = 4, SPACINGS = 5, SEEDS = 8, RUNS = SPACINGS * SEEDS, SPECTRA = 4 };

struct entry {                                                   /* one treatment at one body */
    double dx[RUNS], E1[RUNS], largest[RUNS], work[RUNS], drift; /* work: interactions */
    double neighbours;                                           /* in the mean, at the finest spacing */
    struct walls_price price;
    struct failure why;
};

static void take_runs(const char *scene, const char *walls, struct entry *e) {
#pragma omp parallel for schedule(dynamic, 1)
    for (int k = RUNS - 1; k >= 0; k--) {
        struct command_run run;
        e->dx[k] = spacings[k / SEEDS];
        command_run_line(&run, "run %.*s so_ssph%s --walls %s --seed %d --dx %g", (int)strcspn(scene, " "), scene,
                         scene + strcspn(scene, " "), walls, 1 + k % SEEDS, e->dx[k]);
        command_run_note(&run, &e->why);
        e->E1[k] = run.result.error.l1, e->largest[k] = run.result.error.linf;
        e->work[k] = (double)run.result.cost.interactions;
        if (k / SEEDS == SPACINGS - 1) {
#pragma omp critical(walls_drift)
            {
                e->drift = fmax(e->drift, fabs(run.result.heat_drift));
                e->neighbours += (double)run.result.cost.interactions / (double)run.result.cost.updates / SEEDS;
            }
        }
        command_run_free(&run);
    }
}

static void take_spectra(const char *scene, const char *walls, struct entry *e) {
    e->price.limit = INFINITY;
    for (int seed = 1; seed <= SPECTRA && !e->why.status; seed++) {
        char command[200];
        snprintf(command, sizeof command, "run %.*s so_ssph%s --walls %s --seed %d --dx 0.125 --stepper euler",
                 (int)strcspn(scene, " "), scene, scene + strcspn(scene, " "), walls, seed);
        walls_price_take(&e->price, &e->why, command);
    }
}

/* Checks that such a run is refused, as the table states. */
static void take_refusal(const char *scene, const char *walls, struct failure *why) {
    struct command_run run;
    int status = command_run_line(&run, "run %.*s so_ssph%s --walls %s --dx 0.1", (int)strcspn(scene, " "), scene,
                                  scene + strcspn(scene, " "), walls);
    if (status != STATUS_NOT_APPLICABLE)
        refuse(why, STATUS_NUMERICAL, "heatladder %.100s was to be refused: status %d", run.command, status);
    command_run_free(&run);
}

static double mean_of(const double *x) {
    double sum = 0;
    for (int k = 0; k < SEEDS; k++) sum += x[RUNS - SEEDS + k] / SEEDS;
    return sum;
}

static double most_of(const double *x) {
    double most = 0;
    for (int k = 0; k < SEEDS; k++) most = fmax(most, x[RUNS - SEEDS + k]);
    return most;
}

static void write_row(const char *walls, const char *derived, const struct entry *e, struct document *d) {
    document_cell(d, "`%s`", walls);
    if (!derived) {
        document_cell(d, "refused");
        for (int i = 0; i < 9; i++) document_cell(d, " ");
        return;
    }
    struct slope s = slope_fit(e->dx, e->E1, RUNS), m = slope_fit(e->dx, e->largest, RUNS);
    document_cell(d, "%s", derived);
    document_cell(d, "%.2f", s.value);
    document_cell(d, "%.2f to %.2f", s.ci[0], s.ci[1]);
    document_cell(d, "%.2f", m.value);
    document_cell(d, "%.2e", mean_of(e->E1));
    document_cell(d, "%.2e", most_of(e->largest));
    document_cell(d, "%.3f", e->price.limit);
    document_cell(d, "%.2g, %.1e", e->price.growth, e->drift);
    document_cell(d, "%.1f", e->neighbours);
    document_cell(d, "%.1f", e->price.amplification);
}

static void write_rows(const struct entry *all, struct document *d) {
    document_text(d,
                  "`so_ssph`, h/dx 1.1, eight lattices of random origin and angle at each of dx = 0.1 to 0.025 m. "
                  "Errors at 0.025 m: the mean E1, and the largest error of all. Step and growth by eigenvalues at "
                  "0.125 m, the worst of four lattices. Amplification: the largest sum of |share| of a dummy.");
    for (int b = 0; b < BODIES; b++) {
        document_heading(d, "%s (%s)", bodies[b].name, bodies[b].scene);
        document_table(d,
                       "--walls|order derived|order of E1|95 % interval|order of the largest error|E1|largest error, "
                       "K|step, dx^2/kappa|growth, kappa/dx^2; heat drift|neighbours|amplification");
        for (int t = 0; t < TREATMENTS; t++)
            write_row(treatments[t], bodies[b].derived[t], &all[b * TREATMENTS + t], d);
    }
}

static void write_errors(const struct entry *all, FILE *out) {
    figure_head(out, "so_ssph, walls that cut the lattice: error by treatment of the wall");
    fprintf(out, "# command: heatladder run disc-mode so_ssph --set wall=1 --walls fit --seed 1 --dx 0.1\n");
    for (int k = 0; k < BODIES * TREATMENTS; k++) {
        if (!bodies[k / TREATMENTS].derived[k % TREATMENTS]) continue;
        fprintf(out, "\n\n# %s, %s\ndx,%s,interactions\n", treatments[k % TREATMENTS], bodies[k / TREATMENTS].name,
                treatments[k % TREATMENTS]);
        for (int i = 0; i < RUNS; i += SEEDS) {
            double sum = 0, work = 0;
            for (int j = i; j < i + SEEDS; j++) sum += all[k].E1[j] / SEEDS, work += all[k].work[j] / SEEDS;
            fprintf(out, "%g,%.5e,%.5e\n", all[k].dx[i], sum, work);
        }
    }
}

/* ---- The error on the disc ---- */

static int write_field(FILE *out, struct failure *why) {
    static const char *const drawn[] = {"fixed", "average", "fit"};
    figure_head(out, "so_ssph on a disc whose wall is held, dx = 0.05 m: |T - T exact|, K, by treatment of the wall");
    for (int k = 0; k < 3; k++)
        fprintf(out, "# command: heatladder run disc-mode so_ssph --walls %s --seed 1 --dx 0.05 --field FILE.csv\n",
                drawn[k]);
    for (int k = 0; k < 3; k++) {
        struct command_run run;
        command_run_line(&run, "run disc-mode so_ssph --walls %s --seed 1 --dx 0.05", drawn[k]);
        int status = command_run_check(&run, why);
        const struct field *f = &run.field;
        fprintf(out, "\n\n# %s\nx,y,error\n", drawn[k]);
        for (size_t i = 0; i < f->n && !status; i++) {
            const double x[2] = {f->x[0][i], f->x[1][i]};
            fprintf(out, "%.5f,%.5f,%.3e\n", x[0], x[1],
                    fmax(1e-7, fabs(f->T[i] - command_run_exact(&run, x, f->time))));
        }
        command_run_free(&run);
        if (status) return status;
    }
    return STATUS_OK;
}

static int take_all(struct entry *all, struct failure *why) {
    for (int k = 0; k < BODIES * TREATMENTS; k++) {
        const struct body *body = &bodies[k / TREATMENTS];
        const char *walls = treatments[k % TREATMENTS];
        if (body->derived[k % TREATMENTS]) {
            take_runs(body->scene, walls, &all[k]);
            take_spectra(body->scene, walls, &all[k]);
        } else {
            take_refusal(body->scene, walls, &all[k].why);
        }
        if (!all[k].why.status) continue;
        *why = all[k].why;
        return why->status;
    }
    return STATUS_OK;
}

int walls_study_write(const char *dir, struct failure *why) {
    enum { DATA = 3 };
    struct output data[DATA];
    struct document d;
    double start = omp_get_wtime();
    if (output_directory(dir, "walls.md", why)) return why->status;
    document_open(&d, dir, "walls", "Walls that cut the lattice anywhere");
    FILE *error = output_open(&data[0], "%s/walls_error.csv", dir);
    FILE *offset = output_open(&data[1], "%s/walls_offset.csv", dir);
    FILE *field = output_open(&data[2], "%s/walls_field.csv", dir);
    struct entry *all = xcalloc(BODIES * TREATMENTS, sizeof *all);
    int status = take_all(all, why);
    if (!status) {
        write_rows(all, &d);
        write_errors(all, error);
        status = walls_planes_offsets(offset, &d, error, why);
    }
    if (!status) status = walls_planes_steps(&d, why);
    if (!status) status = write_field(field, why);
    if (!status) status = output_close(data, DATA, why);
    if (!status) status = document_close(&d, why);
    output_drop(data, DATA);
    document_drop(&d);
    free(all);
    if (!status) printf("%s/walls.md, data of four figures (%.1f s)\n", dir, omp_get_wtime() - start);
    return status;
}
