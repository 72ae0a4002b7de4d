/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Running gates.  A row that was not filled is inconclusive and does not pass; gates_status also compares the rows
 * executed with those declared. */
#include "verification/gates/gates.h"

#include "verification/case/command.h"
#include "verification/solve/program.h"
#include "verification/text/output.h"
#include "verification/text/progress.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Estimate of particle updates: particles x steps, summed over rungs; steps = t kappa/(F dx^2), with F as given, else
 * 1/600, where the time error of Euler's method is below 1 %; a few steps for the exact stepper.  It decides only
 * which row starts first. */
static double steps_at(const struct command *r, double dx) {
    const struct experiment *e = &r->experiment;
    const struct material *m = &e->problem.material[0];
    double diffusion = e->problem.t_end * m->k[0] / m->rho_c / (dx * dx), steps = 0;
    for (int i = 0; i < r->rungs.dt.count; i++) steps += e->problem.t_end / r->rungs.dt.value[i];
    for (int i = 0; i < r->rungs.fourier.count; i++) steps += diffusion / r->rungs.fourier.value[i];
    if (steps > 0) return steps;
    return e->method && e->method->scheme && !options_is_matched(&e->options) ? 20 : 600 * diffusion;
}

static double job_size(const struct command *r) {
    if (!r) return 0;
    const struct problem *p = &r->experiment.problem;
    double work = 0;
    for (int i = 0; i < r->rungs.dx.count; i++) {
        double particles = 1;
        for (int a = 0; a < p->dim; a++) particles *= (p->hi[a] - p->lo[a]) / r->rungs.dx.value[i];
        work += particles * steps_at(r, r->rungs.dx.value[i]);
    }
    return isfinite(work) ? work : 0;
}

void gates_run(struct gates *g) {
    gates_read(g);
    size_t *order = xcalloc((size_t)g->declared, sizeof *order);
    double *light = xcalloc((size_t)g->declared, sizeof *light);
    for (int i = 0; i < g->declared; i++) order[i] = (size_t)i, light[i] = -job_size(g->result[i].read);
    if (!g->program) gsl_sort_index(order, light, 1, (size_t)g->declared);
    struct progress progress = progress_start("gates", g->declared);
    int executed = 0, solver = g->program && g->program->solver;
#pragma omp parallel for schedule(dynamic, 1) reduction(+ : executed) if (!solver)
    for (int i = 0; i < g->declared; i++) {
        struct gate_result *result = &g->result[order[i]];
        if (output_noted()) continue;
        gates_run_row(g, result, g->program);
        executed += !result->executed;
        result->executed = 1;
        progress_tick(&progress);
    }
    progress_end(&progress);
    g->executed = executed;
    free(light);
    free(order);
}

void gates_cut(struct gates *g, int signal) {
    int judged = 0;
    for (int i = 0; i < g->declared; i++)
        if (g->result[i].executed)
            g->result[judged++] = g->result[i];
        else
            gates_forget(&g->result[i]);
    g->planned = g->declared;
    g->declared = judged;
    g->interrupted = signal;
}

size_t gates_group_length(const char *id) {
    return strcspn(id, "/");
}

int gates_same_group(const char *a, const char *b) {
    size_t n = gates_group_length(a);
    return n == gates_group_length(b) && strncmp(a, b, n) == 0;
}

int gates_begins_group(const struct gates *g, int i) {
    for (int k = 0; k < i; k++)
        if (gates_same_group(g->result[k].gate.id, g->result[i].gate.id)) return 0;
    return 1;
}

int gates_holds(const struct gate_result *r) {
    return r->measured.verdict == VERDICT_PASS;
}

int gates_fails(const struct gate_result *r) {
    return !gates_holds(r) && r->measured.verdict != VERDICT_SKIPPED;
}

struct gates_tally gates_tally(const struct gates *g, const char *id) {
    struct gates_tally t = {0};
    for (int i = 0; i < g->declared; i++) {
        const enum verdict verdict = g->result[i].measured.verdict;
        if (id && !gates_same_group(g->result[i].gate.id, id)) continue;
        t.judged += verdict != VERDICT_SKIPPED;
        t.skipped += verdict == VERDICT_SKIPPED;
        t.passed += verdict == VERDICT_PASS;
        t.failed += verdict == VERDICT_FAIL;
        t.seconds += g->result[i].seconds;
    }
    t.undecided = t.judged - t.passed - t.failed;
    return t;
}

int gates_status(const struct gates *g) {
    struct gates_tally t = gates_tally(g, NULL);
    int silent = 0, sound = 0;
    for (int i = 0; i < g->declared; i++) {
        const struct gate_result *r = &g->result[i];
        const enum verdict verdict = r->measured.verdict;
        silent += verdict == VERDICT_FAIL && isnan(r->measured.value);
        sound += r->executed && verdict != VERDICT_FAIL && verdict != VERDICT_MEASURED;
    }
    if (g->program && silent && silent + t.skipped == g->declared) return STATUS_NUMERICAL;
    if (g->declared == 0 || g->executed != g->declared || sound < g->declared) return STATUS_GATE;
    if (g->program && t.skipped == g->declared) return STATUS_SKIPPED;
    return t.undecided || !t.passed ? STATUS_INCONCLUSIVE : STATUS_OK;
}
