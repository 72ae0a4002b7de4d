/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Error against spacing where the cloud is drawn anew every N steps: rod-cosine, SO-SSPH of order 2 and 4, F = 0.1.
 */
#include "reports/operators/operators.h"

#include "reports/figure/figure.h"
#include "solver/status.h"
#include "verification/command/command_run.h"

static const char *const runs =
    "run rod-cosine so_ssph --order %d --layout jitter --jitter 0.2 --seed 1 --stepper rk2 "
    "--fourier 0.1%s --dx 1/%d";

static const char *const redraw[][2] = {
    {"", "no"}, {" --redraw 64", "64"}, {" --redraw 16", "16"}, {" --redraw 4", "4"}, {" --redraw 1", "1"}};
static const int across[] = {20, 40, 80, 160};

enum { REDRAWS = 5, RUNGS = 4, ORDERS = 2 };
enum { RUNS = ORDERS * REDRAWS * RUNGS };

/* The error of run k, by order, redraw and spacing. */
static int take_error(int k, double *error, struct failure *why) {
    struct command_run run;
    command_run_line(&run, runs, 2 + 2 * (k / (REDRAWS * RUNGS)), redraw[k / RUNGS % REDRAWS][0], across[k % RUNGS]);
    int status = command_run_check(&run, why);
    *error = run.result.error.l1;
    command_run_free(&run);
    return status;
}

int operators_redraw(FILE *out, struct failure *why) {
    double error[RUNS];
    struct failure failed[RUNS];
    int status[RUNS];
#pragma omp parallel for schedule(dynamic, 1)
    for (int k = RUNS - 1; k >= 0; k--) status[k] = take_error(k, &error[k], &failed[k]);
    for (int k = 0; k < RUNS; k++)
        if (status[k]) {
            *why = failed[k];
            return status[k];
        }
    figure_head(out, "rod-cosine: a cloud that is drawn again every N steps");
    fprintf(out, "# command: heatladder ");
    fprintf(out, runs, 4, " --redraw 4", 160);
    fprintf(out, "\n");
    for (int k = 0; k < RUNS; k++) {
        const char *name = redraw[k / RUNGS % REDRAWS][1];
        if (k % RUNGS == 0)
            fprintf(out, "\n\n# order %d, every %s steps\ndx [m],%s\n", 2 + 2 * (k / (REDRAWS * RUNGS)), name, name);
        fprintf(out, "%.6g,%.5e\n", 1.0 / across[k % RUNGS], error[k]);
    }
    return STATUS_OK;
}
