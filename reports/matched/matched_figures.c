/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Error against work on square-step: the run of Song 2018, section 5.2 (point samples, Euler, dt = 0.001 s), beside
 * the matched run.  Work is the number of pairs of particles evaluated, on the whole domain. */
#include "reports/matched/matched_figures.h"

#include "reports/figure/figure.h"
#include "verification/judge/command_run.h"

#include <stdio.h>
#include <string.h>

static const struct curve {
    const char *name, *options, *dx[8];
} curves[] = {
    {"as published", "--stepper euler --dt 0.001", {"0.5", "0.25", "0.125", "0.1", "0.0625", "0.05"}},
    {"matched",
     "--stepper matched --h iso --sampling spline",
     {"0.25", "0.2", "0.125", "0.1", "0.0625", "0.05", "0.025"}},
    {"matched, without the start",
     "--stepper euler --fourier 0.29516 --h iso --sampling spline",
     {"0.25", "0.2", "0.125", "0.1", "0.0625", "0.05", "0.025"}},
};

static int write_curve(const struct curve *c, FILE *out, struct failure *why) {
    fprintf(out, "\n\n# %s\n# heatladder run square-step so_ssph --domain whole %s --dx ...\npairs,%s,dx [m],steps\n",
            c->name, c->options, c->name);
    for (int i = 0; c->dx[i]; i++) {
        struct command_run run;
        command_run_line(&run, "run square-step so_ssph --domain whole %s --dx %s", c->options, c->dx[i]);
        int status = command_run_check(&run, why);
        const struct result *r = &run.result;
        if (!status)
            fprintf(out, "%lld,%.6e,%g,%lld\n", r->cost.interactions, r->error.l1, run.typed.experiment.options.dx,
                    r->steps);
        command_run_free(&run);
        if (status) return status;
    }
    return STATUS_OK;
}

static int write_work(FILE *out, struct failure *why) {
    figure_head(out, "square-step: error against work, as published and matched");
    fprintf(out,
            "# command: heatladder run square-step so_ssph --dx 0.1 --stepper euler --dt 0.001\n"
            "# command: heatladder run square-step so_ssph --dx 0.1 --stepper matched --h iso --sampling spline\n");
    int status = STATUS_OK;
    for (size_t i = 0; i < sizeof curves / sizeof *curves && !status; i++) status = write_curve(&curves[i], out, why);
    return status;
}

int matched_figures_write(const char *dir, struct failure *why) {
    return figure_pages(&(struct figure_page){"matched_fig1", write_work}, 1, dir, why);
}
