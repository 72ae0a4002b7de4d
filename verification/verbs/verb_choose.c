/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder choose: the cheapest run that reaches an error, and what it beat. */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "verification/choose/choose.h"
#include "verification/text/json.h"
#include "verification/command/request.h"
#include "verification/text/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The command that does it again. */
static void print_command(const struct request *r, const struct result *p) {
    const struct options *o = &p->options;
    printf("  heatladder run %s %s --dx %.17g --stepper %s --sampling %s", r->experiment.scene->name, p->method->name,
           o->dx, stepper_words[o->stepper], sampling_words[o->sampling]);
    if (result_accepts(p, "h"))
        printf(o->h_iso ? " --kernel %s --h iso" : " --kernel %s --h %.17g", kernel_words[o->kernel], o->h);
    if (o->order) printf(" --order %d", o->order);
    if (result_accepts(p, "mean")) printf(" --mean %s", mean_words[o->mean]);
    if (o->fourier > 0) printf(" --fourier %.17g", o->fourier);
    if (o->dt > 0) printf(" --dt %.17g", o->dt);
    for (int i = 0; r->experiment.scene->params[i].name; i++) {
        const struct param *param = &r->experiment.scene->params[i];
        if (!(r->overridden & 1ul << i)) continue;
        if (param->choice)
            printf(" --set %s=%s", param->name, param->choice[(int)r->experiment.problem.param[i]]);
        else
            printf(" --set %s=%.17g", param->name, r->experiment.problem.param[i]);
    }
    printf("\n");
}

static void print_text(const struct request *r, const struct choose *c) {
    const struct result *p = &c->proof;
    char what[240];
    if (c->best.candidate) {
        result_describe(p, what, sizeof what);
        printf("%s\n", what);
        print_command(r, p);
        printf("  %-10s E1 %.4e wanted, %.4e predicted, %.4e measured", "error", c->error, c->best.predicted_error,
               p->error.l1);
        if (!isnan(c->between)) printf(", %.4e half-way between the particles", c->between);
        putchar('\n');
        printf("  %-10s dx = %g m, %zu particles, %lld steps of %g s\n", "size", p->options.dx, p->particles,
               p->steps, p->dt);
        printf("  %-10s %.3g s, work of %.3g pairs, %d proving run%s\n\n", "cost", p->cost.seconds, p->cost.work,
               c->proofs, c->proofs == 1 ? "" : "s");
    }
    struct table t = table_headed(1, "candidate|particles along x|order|E1 predicted|work [pairs]");
    for (int i = 0; i < c->count; i++) {
        const struct extrapolation *o = &c->one[i];
        if (!isfinite(o->predicted_work)) continue;
        table_add(&t, "%s|%d", o->candidate->label, o->wanted);
        table_number(&t, "%.2f", o->order > 0 ? o->order : NAN, "-");
        table_add(&t, "%.3e|%.3g", o->predicted_error, o->predicted_work);
    }
    table_end(&t, stdout);
    for (int i = 0; i < c->count; i++)
        if (*c->one[i].reason) printf("left out: %s: %s\n", c->one[i].candidate->label, c->one[i].reason);
}

static void one_json(const struct request *r, const struct extrapolation *o, struct json *j) {
    int can = isfinite(o->predicted_work);
    struct options with = candidate_options(o->candidate, &r->experiment, o->wanted);
    json_add(j, "candidate %s|method %s|stepper %s", o->candidate->label, o->candidate->method,
             stepper_words[with.stepper]);
    json_number(j, "dx", can ? with.dx : NAN);
    json_number(j, "order", o->order > 0 ? o->order : NAN);
    json_number(j, "predicted_error", can ? o->predicted_error : NAN);
    json_number(j, "predicted_work", can ? o->predicted_work : NAN);
    json_text(j, "reason", *o->reason ? o->reason : NULL);
}

static void print_json(const struct request *r, const struct choose *c) {
    struct json j = json_on(stdout);
    const struct result *p = &c->proof;
    json_add(&j, "scene %s|error %g|reached %d", r->experiment.scene->name, c->error, c->reached);
    if (c->best.candidate) {
        const struct options *o = &p->options;
        json_add(&j, "method %s|dx %g|dt %g|steps %lld|stepper %s", p->method->name, o->dx, p->dt, p->steps,
                 stepper_words[o->stepper]);
        json_text(&j, "kernel", result_accepts(p, "kernel") ? kernel_words[o->kernel] : NULL);
        json_number(&j, "h", o->h > 0 ? o->h : NAN);
        json_number(&j, "order", o->order ? (double)o->order : NAN);
        json_add(&j, "sampling %s|particles %zu|predicted_error %g|measured_error %g|error_between %g",
                 sampling_words[o->sampling], p->particles, c->best.predicted_error, p->error.l1, c->between);
        json_add(&j, "predicted_work %g|measured_work %g|seconds %g|proving_runs %d", c->best.predicted_work,
                 p->cost.work, p->cost.seconds, c->proofs);
    }
    json_array(&j, "runners_up");
    for (int i = 0; i < c->count; i++) {
        if (c->one[i].candidate == c->best.candidate) continue;
        json_object(&j, NULL);
        one_json(r, &c->one[i], &j);
        json_end(&j);
    }
    json_end(&j);
    json_end(&j);
}

int verb_choose(const struct request *r, struct failure *why) {
    struct choose *c = xcalloc(1, sizeof *c);
    int status = choose_run(&r->experiment, r->error, choose_work_max, c, why);
    if (!status_refused(status)) (r->json ? print_json : print_text)(r, c);
    free(c);
    return status;
}
