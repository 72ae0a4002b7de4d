/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two figures of the matched run.
 *
 * Error against work, square-step: what Song 2018, section 5.2, runs (point samples, Euler, dt = 0.001 s) beside the
 * matched run.  Work is pairs of particles evaluated, on the whole domain.
 * The symbol over h/dx: A and B of its leading error, the step F = 2 A that matches it, and the largest stable step,
 * in the plane.  B = 2 A marks the isotropic ratios. */
#include "reports/matched/matched_figures.h"

#include "solver/time/matched.h"
#include "verification/stability/step_limit.h"
#include "reports/figure/figure.h"
#include "verification/ladder/command_run.h"

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

static int write_ratio(const struct method *m, enum kernel_name kernel, double h, FILE *out, struct failure *why) {
    struct model_problem b = {.method = m, .dim = 2, .options = {.dx = 1, .h = h, .kernel = kernel}};
    struct symbol_error e;
    struct step_limit limit;
    int status = step_limit_model(&b, why);
    if (!status) status = step_limit_predict(&b, &limit, why);
    if (!status) status = matched_symbol(2, &b.options, m->scheme, &e, why);
    if (status == STATUS_NUMERICAL) { /* the quartic kernel is not positive: M need not be, at small supports */
        fprintf(out, "# h/dx %.4f: singular\n", h);
        return STATUS_OK;
    }
    if (status) return status;
    fprintf(out, "%.4f,%.8f,%.8f,%.8f,%.8f\n", h, e.A, e.B / 2, 2 * e.A, limit.von_neumann);
    return STATUS_OK;
}

static int write_symbol(FILE *out, struct failure *why) {
    const struct method *m = method_find("so_ssph");
    int status = STATUS_OK;
    figure_head(out, "SO-SSPH in the plane: the symbol's error and the steps, over h/dx");
    fprintf(out,
            "# command: heatladder run square-step so_ssph --dx 0.1 --stepper matched --h iso --sampling spline\n");
    for (int k = 0; kernel_words[k] && !status; k++) {
        struct options o = {.kernel = (enum kernel_name)k};
        double iso;
        status = matched_isotropic(&o, m->scheme, &iso, why);
        fprintf(out, "\n\n# %s\nh/dx,A,B/2,F = 2 A,limit\n", kernel_words[k]);
        for (int i = 0; i <= 48 && !status; i++) status = write_ratio(m, o.kernel, 0.8 + i * 0.025, out, why);
        if (!status) fprintf(out, "\n\n# %s isotropic\nh/dx,A,B/2,F = 2 A,limit\n", kernel_words[k]);
        if (!status) status = write_ratio(m, o.kernel, iso, out, why);
    }
    return status;
}

int matched_figures_write(const char *dir, struct failure *why) {
    static const struct figure_page pages[] = {{"matched_fig1", write_work}, {"matched_fig2", write_symbol}};
    return figure_pages(pages, 2, dir, why);
}
