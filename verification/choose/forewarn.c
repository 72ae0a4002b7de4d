/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Seconds by counted work. */
#include "verification/choose/forewarn.h"

#include "solver/status.h"
#include "verification/choose/plan.h"
#include "verification/run/experiment.h"
#include "verification/run/time_step.h"

#include <stdio.h>

/* What is surely short: a search takes some 50 times the updates of its first run (a jump's, by Euler steps). */
static const double SHORT_UPDATES = 2e6, SHORT_PARTICLES = 1e5;

static int is_short(const struct experiment *e) {
    const struct options *o = &e->options;
    double n = plan_steps_particles(&e->problem, o->dx), steps = time_step_first(e);
    if (o->dt > 0) steps = e->problem.t_end / o->dt;
    if (o->fourier > 0) steps = e->problem.t_end * problem_diffusivity(&e->problem) / (o->fourier * o->dx * o->dx);
    return n <= SHORT_PARTICLES && n * steps <= SHORT_UPDATES;
}

static double seconds_of(const struct plan *plan) {
    double runs = plan->refined ? 1.5 : 1; /* those before the last have half its steps, a quarter, ... */
    return runs * plan_work(plan) / forewarn_rate + forewarn_exact * (double)plan->particles;
}

double forewarn_seconds(const struct experiment *e) {
    struct plan plan;
    struct failure ignored;
    return is_short(e) || plan_make(e, PLAN_SKETCH, &plan, &ignored) ? 0 : seconds_of(&plan);
}

int forewarn_run(const char *what, const struct experiment *e, struct failure *why) {
    struct plan plan;
    if (is_short(e) && e->memory == 0) return STATUS_OK;
    if (memory_check(e, why)) return why->status;
    int status = is_short(e) ? STATUS_NOT_APPLICABLE : plan_make(e, PLAN_SKETCH, &plan, why);
    if (!status) forewarn(what, seconds_of(&plan));
    return status == STATUS_INPUT ? status : STATUS_OK;
}

void forewarn_text(double seconds, char *text, size_t size) {
    static const struct {
        const char *name;
        double seconds;
    } unit[] = {{"seconds", 1}, {"minutes", 60}, {"hours", 3600}, {"days", 86400}, {"years", 3.156e7}};
    int k = 0;
    while (k < 4 && seconds >= 2 * unit[k + 1].seconds) k++;
    snprintf(text, size, "%.2g %s", seconds / unit[k].seconds, unit[k].name);
}

int forewarn(const char *what, double seconds) {
    char text[40];
    if (!(seconds >= forewarn_least)) return 0;
    forewarn_text(seconds, text, sizeof text);
    fprintf(stderr, "heatladder: %s will take some %s of one processor, by the operations it counts\n", what, text);
    return 1;
}

int forewarn_next(struct forewarned *f, const char *what, double seconds) {
    f->all += seconds;
    if (!(f->all > 2 * f->warned) || !forewarn(what, f->all)) return 0;
    f->warned = f->all;
    return 1;
}
