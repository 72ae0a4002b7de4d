/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs over time: the blow-up that a published bound allows, and the checkerboard. */
#include "reports/stability/stability.h"

#include "verification/stability/step_limit.h"
#include "verification/judge/command_run.h"

#include <math.h>
#include <stdlib.h>

/* ---- Blow-up ---- */

static const double DISTURBANCE = 1e-10; /* K */

/* The difference of a disturbed and an undisturbed run after this number of steps, K; NaN if one was refused. */
static double apart(const struct model_problem *b, double F, long long steps) {
    struct field f[2];
    struct failure why;
    struct options o = b->options;
    for (int i = 0; i < 2; i++) {
        struct problem p = model_problem_setup(b, MODEL_HILL, i * DISTURBANCE);
        p.t_end = F * (double)steps;
        o.dt = F;
        if (!method_solve(b->method, &p, &o, &f[i], &why)) continue;
        if (i) field_free(&f[0]);
        return NAN;
    }
    double most = field_farthest(&f[0], f[1].T);
    field_free(&f[0]);
    field_free(&f[1]);
    return most;
}

static int follow(FILE *out, const char *name, struct model_problem b, int stride, struct failure *why) {
    enum { POINTS = 100 };
    struct step_limit l;
    if (step_limit_model(&b, why) || step_limit_predict(&b, &l, why)) return why->status;
    const double F[2] = {0.99 * l.published, 0.99 * l.von_neumann};
    for (int k = 0; k < 2; k++) {
        double distance[POINTS];
        stability_block(out, "step,distance_K,F", "%s %s", name, k ? "true" : "published");
#pragma omp parallel for schedule(dynamic, 1)
        for (int i = 0; i < POINTS; i++) distance[i] = apart(&b, F[k], (long long)stride * (i + 1));
        for (int i = 0; i < POINTS && !isnan(distance[i]); i++)
            fprintf(out, "%d,%.6g,%.6g\n", stride * (i + 1), distance[i], F[k]);
    }
    return STATUS_OK;
}

int stability_blowup_page(FILE *out, struct failure *why) {
    stability_head(out, "A disturbance of 1e-10 K at 0.99 of the published bound, and at 0.99 of the true one",
                   "limit so_ssph --dim 1 --kernel quartic --h 1.1");
    fprintf(out, "# command: heatladder limit ftcs --dim 2\n");
    if (follow(out, "so_ssph", stability_model("so_ssph", 1, KERNEL_QUARTIC, 1.1), 10, why)) return why->status;
    return follow(out, "ftcs", stability_model("ftcs", 2, KERNEL_CUBIC, 0), 1, why);
}

/* ---- The checkerboard over time ---- */

struct place {
    const char *name, *dx;
};

int stability_checkerboard_page(FILE *out, struct failure *why) {
    enum { TIMES = 33, METHODS = 4, PLACES = 3 };
    static const struct place places[PLACES] = {{"midway", "4/80"}, {"quarter", "4/82"}, {"on", "4/84"}};
    static const char *const names[METHODS] = {"fo_ssph", "so_ssph", "ftcs", "ftcs_flux"};
    stability_head(out, "The jump of rod-step: what oscillates, and for how long",
                   "run rod-step fo_ssph --dx 4/80 --t-end 5");
    for (int i = 0; i < METHODS * PLACES; i++) {
        struct command_run *run = xcalloc(TIMES, sizeof *run);
        int method = i / PLACES, status = STATUS_OK;
#pragma omp parallel for schedule(dynamic, 1)
        for (int k = TIMES - 1; k >= 0; k--)
            command_run_line(&run[k], "run rod-step %s --dx %s --t-end %.6g%s", names[method], places[i % PLACES].dx,
                             pow(10, -2 + 4.7 * k / (TIMES - 1)), method >= 2 ? " --fourier 0.2" : "");
        stability_block(out, "t_s,checkerboard/peak,total_variation/peak,peak_K", "%s %s", names[method],
                        places[i % PLACES].name);
        for (int k = 0; k < TIMES; k++) {
            const struct norms_shape *s = &run[k].result.shape;
            if (!status) status = command_run_check(&run[k], why);
            fprintf(out, "%.6g,%.6g,%.6g,%.6g\n", run[k].result.t_end, s->checkerboard / s->max,
                    s->variation / s->max, s->max);
            command_run_free(&run[k]);
        }
        free(run);
        if (status) return status;
    }
    return STATUS_OK;
}
