/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gates of another program.  Twice as many rows as cases run at a time: the program runs for the next row while one
 * row is judged or waits for a case of another. */
#include "verification/gates/gates.h"

#include "solver/status.h"
#include "verification/solve/program.h"
#include "verification/solve/runs.h"
#include "verification/solve/scratch.h"
#include "verification/text/output.h"
#include "verification/text/progress.h"

#include <gsl/gsl_sort_double.h>
#include <stdlib.h>

static void show_row(const struct gates *g, const struct gate_result *r, struct progress *progress) {
    const struct measured *m = &r->measured;
    int passed = m->verdict == VERDICT_PASS;
    progress_print(progress, "%d of %d  %s  %s%s%s  %.1f s", progress->done, g->declared, r->gate.id,
                   verdict_words[m->verdict], passed ? "" : ": ", passed ? "" : m->reason, r->seconds);
}

static void run_row(struct gates *g, struct gate_result *result, const struct program *program,
                    struct progress *progress) {
    struct failure ignored;
    if (output_noted() || runs_absent(program->runs, &ignored)) return;
    gates_run_row(g, result, program);
    if (output_noted() || runs_absent(program->runs, &ignored)) return; /* no verdict: its runs were interrupted */
    result->executed = 1;
#pragma omp critical(gates_row)
    {
        progress->done++;
        show_row(g, result, progress);
    }
}

static void run_rows(struct gates *g, int jobs, const struct program *program, struct progress *progress) {
    size_t *order = xcalloc((size_t)g->declared, sizeof *order);
    double *few = xcalloc((size_t)g->declared, sizeof *few);
    for (int i = 0; i < g->declared; i++) order[i] = (size_t)i, few[i] = -gates_rungs(&g->result[i]);
    if (jobs > 1) gsl_sort_index(order, few, 1, (size_t)g->declared); /* most rungs first */
#pragma omp parallel for schedule(dynamic, 1) num_threads(2 * jobs) if (jobs > 1)
    for (int i = 0; i < g->declared; i++) run_row(g, &g->result[order[i]], program, progress);
    free(few);
    free(order);
}

int gates_run_program(struct gates *g, int jobs, struct failure *why) {
    struct program program = *g->program;
    struct scratch scratch;
    struct progress progress = progress_start("rows", g->declared);
    int kept = program.keep != NULL;
    if (!kept && scratch_open(&scratch, why)) return why->status;
    if (!kept) program.keep = scratch.dir;
    program.runs = runs_create(jobs, gates_runs(g), &progress);
    run_rows(g, jobs, &program, &progress);
    progress_end(&progress);
    for (int i = 0; i < g->declared; i++) g->executed += g->result[i].executed;
    int status = runs_absent(program.runs, why) ? STATUS_INPUT : STATUS_OK;
    runs_free(program.runs);
    if (!kept) scratch_close(&scratch);
    return status;
}
