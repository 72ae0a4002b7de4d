/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cube-step: the error on the slice just above z = 0 by the first- and the second-order operator, and E1 of four
 * methods against spacing, with the jump midway between particles. */
#include "reports/space/space_study.h"

#include "reports/figure/figure.h"
#include "verification/judge/command_run.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CELLS = 80, SLICED = 2, SOLVED = 4, RUNGS = 3 };
static const char *const solved[SOLVED] = {"fo_ssph", "so_ssph", "brookshaw", "ftcs"}; /* slices of the first two */
static const int cells[RUNGS] = {40, 80, 120};                                         /* along 4 m */

static int run(const char *method, int n, const char *domain, struct command_run *r, struct failure *why) {
    const char *more = strcmp(method, "ftcs") == 0 ? "--fourier 0.05" : "--h 1.1";
    command_run_line(r, "run cube-step %s %s --set kappa_y=0.01 --set kappa_z=0.01%s --dx 4/%d", method, more, domain,
                     n);
    return command_run_check(r, why);
}

/* log10 of |T - T_exact|/T_0 at the particles of one layer, by rows: gnuplot's matrix of an image. */
static int write_slice(const char *method, FILE *out, struct failure *why) {
    struct command_run r;
    int status = run(method, CELLS, " --domain whole", &r, why);
    const struct problem *p = &r.typed.experiment.problem;
    const double dx = 4.0 / CELLS;
    fprintf(out, "\n\n# slice, %s\nx [m],y [m],log10 |T - T_exact|/T_0\n", method);
    for (int j = 0; j < CELLS && !status; j++) {
        for (int i = 0; i < CELLS; i++) {
            size_t at = ((size_t)CELLS / 2 * CELLS + (size_t)j) * CELLS + (size_t)i;
            double x[3] = {p->lo[0] + (i + 0.5) * dx, p->lo[1] + (j + 0.5) * dx, dx / 2};
            double error = fabs(r.field.T[at] - command_run_exact(&r, x, p->t_end)) / 10;
            fprintf(out, "%g,%g,%.3f\n", x[0], x[1], log10(fmax(error, 1e-9)));
        }
        fprintf(out, "\n");
    }
    command_run_free(&r);
    return status;
}

static int write_errors(const char *method, FILE *out, struct failure *why) {
    int status = STATUS_OK;
    fprintf(out, "\n\n# error, %s\ndx [m],E1\n", method);
    for (int k = 0; k < RUNGS && !status; k++) {
        struct command_run r;
        status = run(method, cells[k], "", &r, why);
        if (!status) fprintf(out, "%g,%.6e\n", 4.0 / cells[k], r.result.error.l1);
        command_run_free(&r);
    }
    return status;
}

static int write_step(FILE *out, struct failure *why) {
    figure_head(out, "cube-step: a jump in space, midway between particles");
    fprintf(out,
            "# command: heatladder run cube-step METHOD --h 1.1 --set kappa_y=0.01 --set kappa_z=0.01 --dx 4/%d\n"
            "# command: heatladder ladder cube-step METHOD --h 1.1 (ftcs: --fourier 0.05) --set kappa_y=0.01 --set "
            "kappa_z=0.01 --dx 4/40,4/80,4/120\n",
            CELLS);
    int status = STATUS_OK;
    for (int k = 0; k < SLICED && !status; k++) status = write_slice(solved[k], out, why);
    for (int k = 0; k < SOLVED && !status; k++) status = write_errors(solved[k], out, why);
    return status;
}

int space_study_write(const char *dir, struct failure *why) {
    return figure_pages(&(struct figure_page){"space_fig1", write_step}, 1, dir, why);
}
