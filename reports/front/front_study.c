/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The front of k = k_0 T^2 by ftcs with each mean of a pair: profiles at dx = 1/40 m, errors against spacing. */
#include "reports/front/front_study.h"

#include "references/scene.h"
#include "reports/figure/figure.h"
#include "solver/field.h"
#include "verification/judge/command_run.h"

#include <stdio.h>

static const char *const means[] = {"harmonic", "arithmetic", "kirchhoff"};
enum { MEANS = 3 };

static int write_exact(FILE *out, struct failure *why) {
    const struct scene *s = scene_find("front");
    struct problem p;
    scene_defaults(s, &p);
    if (s->setup(&p, why)) return why->status;
    fprintf(out, "\n\n# exact\nx [m],T [K]\n");
    for (int i = 0; i <= 500; i++) {
        double x = p.hi[0] * i / 500;
        fprintf(out, "%g,%.6g\n", x, scene_exact(s, &p, &x, p.t_end).temperature);
    }
    return STATUS_OK;
}

static int run(const char *mean, int cells, struct command_run *r, struct failure *why) {
    command_run_line(r, "run front ftcs --fourier 0.1 --mean %s --dx 1/%d", mean, cells);
    return command_run_check(r, why);
}

static int write_mean(const char *mean, FILE *out, struct failure *why) {
    struct command_run r;
    int status = run(mean, 40, &r, why);
    const struct experiment *e = &r.typed.experiment;
    struct field f = {0};
    if (!status) status = method_solve(e->method, &e->problem, &e->options, &f, why);
    fprintf(out, "\n\n# profile, %s\nx [m],T [K]\n", mean);
    for (size_t i = 0; i < f.n; i++) fprintf(out, "%g,%.6g\n", f.x[0][i], f.T[i]);
    field_free(&f);
    command_run_free(&r);
    fprintf(out, "\n\n# error, %s\ndx [m],E1\n", mean);
    for (int cells = 10; cells <= 160 && !status; cells *= 2) {
        status = run(mean, cells, &r, why);
        if (!status) fprintf(out, "%g,%.6e\n", 1.0 / cells, r.result.error.l1);
        command_run_free(&r);
    }
    return status;
}

static int write_front(FILE *out, struct failure *why) {
    figure_head(out, "front: k = k_0 T^2, finite differences with three means of a pair");
    for (int k = 0; k < MEANS; k++)
        fprintf(out, "# command: heatladder ladder front ftcs --mean %s --fourier 0.1 --dx 1/20,1/40,1/80,1/160\n",
                means[k]);
    int status = write_exact(out, why);
    for (int k = 0; k < MEANS && !status; k++) status = write_mean(means[k], out, why);
    return status;
}

int front_study_write(const char *dir, struct failure *why) {
    return figure_pages(&(struct figure_page){"front_means", write_front}, 1, dir, why);
}
