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

static int write_curve(int order, const char *redraw, const char *name, FILE *out, struct failure *why) {
    static const int across[] = {20, 40, 80, 160, 320};
    fprintf(out, "\n\n# order %d, every %s steps\ndx [m],%s\n", order, name, name);
    for (int i = 0; i < 5; i++) {
        struct command_run run;
        command_run_line(&run, runs, order, redraw, across[i]);
        int status = command_run_check(&run, why);
        if (!status) fprintf(out, "%.6g,%.5e\n", 1.0 / across[i], run.result.error.l1);
        command_run_free(&run);
        if (status) return status;
    }
    return STATUS_OK;
}

int operators_redraw(FILE *out, struct failure *why) {
    static const char *const redraw[][2] = {
        {"", "no"}, {" --redraw 64", "64"}, {" --redraw 16", "16"}, {" --redraw 4", "4"}, {" --redraw 1", "1"}};
    int status = STATUS_OK;
    figure_head(out, "rod-cosine: a cloud that is drawn anew every N steps");
    fprintf(out, "# command: heatladder ");
    fprintf(out, runs, 4, " --redraw 4", 160);
    fprintf(out, "\n");
    for (int order = 2; order <= 4; order += 2)
        for (int k = 0; k < 5 && !status; k++) status = write_curve(order, redraw[k][0], redraw[k][1], out, why);
    return status;
}
