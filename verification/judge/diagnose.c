/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the rungs of a ladder to the diagnosis of their errors. */
#include "verification/judge/inconclusive.h"

#include "references/scene.h"
#include "solver/field.h"
#include "solver/status.h"
#include "verification/fault/diagnosis.h"
#include "verification/fault/wording.h"
#include "verification/judge/ladder.h"
#include "verification/judge/self_difference.h"
#include "verification/judge/norms.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Repeats the coarser rung to measure how much a program's answers differ between runs. */
static void repeat(const struct experiment *e, const struct field *before, const struct result *first,
                   const struct ladder *l, struct inconclusive_noise *noise) {
    struct experiment again = *e;
    struct result result;
    struct field f = {0};
    struct norms_error apart;
    if (!e->program.solver) return;
    again.options.dx = l->x[l->n - 2];
    again.program.keep = NULL;
    if (run_experiment(&again, &result, &f) == STATUS_OK && self_difference_fields(&e->problem, before, &f, &apart)) {
        int largest = l->norm == LADDER_LINF;
        noise->apart = apart.linf;
        noise->finest = largest ? apart.linf : apart.l1 / sqrt(2);
        noise->share = noise->finest / (largest ? first->error.linf : first->error.l1);
    }
    field_free(&f);
}

/* Determines whether the program's numbers are point values or cell means (diagnosis_mean), from its answer at dx
 * and a time so early that one step too many or too few is a hundredth of the difference between a mean and a
 * value. */
static double mean_of_start(const struct experiment *e, double dx) {
    static const double EARLY = 1e-4; /* in units of dx^2/kappa; the mean differs by 1/24 */
    struct experiment start = *e;
    struct result result;
    struct failure ignored;
    struct field f = {0};
    int i = 0;
    if (!e->program.solver) return NAN;
    start.options.dx = dx;
    start.program.keep = NULL;
    while (strcmp(e->scene->params[i].name, "t_end") != 0) i++;
    start.problem.param[i] = EARLY * dx * dx / problem_diffusivity(&e->problem);
    if (e->scene->setup(&start.problem, &ignored) || run_experiment(&start, &result, &f)) return NAN;
    double *exact = xcalloc(f.n, sizeof *exact);
    norms_exact(e->scene, &start.problem, &f, exact);
    double mean = diagnosis_mean(&start.problem, &(struct diagnosis_rung){&f, exact, dx, 0, NAN});
    free(exact);
    field_free(&f);
    return mean;
}

/* Diagnoses the case given to the program, in its axes and temperatures.  If two materials meet across y, no solver
 * here can compute the response, and the scene itself is used. */
void diagnose_ladder(const struct experiment *e, const struct field kept[2], struct ladder *l,
                     struct inconclusive_noise *noise) {
    struct diagnosis_rung rung[2];
    struct field given[2] = {{0}, {0}};
    struct image image;
    double *exact[2];
    if (l->n < 2 || kept[0].n == 0 || kept[1].n == 0) {
        snprintf(l->diagnosis.what, sizeof l->diagnosis.what, "none: two rungs with an answer are needed");
        return;
    }
    repeat(e, &kept[1], &l->rung[l->n - 2], l, noise);
    if (noise->share > INCONCLUSIVE_NOISE && diagnosis_repeat(noise->apart, field_largest(&kept[1]), &l->diagnosis))
        return;
    double mean = mean_of_start(e, l->x[l->n - 2]);
    mapping_image(&e->program.map, &e->problem, &image);
    int mapped = e->problem.materials == 1 || image.interface_axis == 0;
    for (int k = 0; k < 2; k++) {
        exact[k] = xcalloc(kept[k].n, sizeof **exact);
        norms_exact(e->scene, &e->problem, &kept[k], exact[k]);
        if (mapped) given[k] = program_as_given(&e->program, &kept[k], exact[k]);
        double dt = kept[k].dt;
        if (!(dt > 0) && kept[k].steps > 0) dt = kept[k].time / (double)kept[k].steps;
        rung[k] = (struct diagnosis_rung){mapped ? &given[k] : &kept[k], exact[k], l->x[l->n - 1 - k], dt, mean};
    }
    if (!diagnosis_unstable(&rung[0], &l->diagnosis) && !diagnosis_unstable(&rung[1], &l->diagnosis))
        diagnosis_find(mapped ? &image.problem : &e->problem, &rung[0], &rung[1], &l->diagnosis);
    if (!mapped && l->diagnosis.named && l->diagnosis.fault.kind == FAULT_OFFSET) {
        l->diagnosis.size *= mapping_scale(&e->program.map); /* in the temperatures of the case */
        wording_fault(&l->diagnosis);
    }
    struct diagnosis repeats;
    if (!l->diagnosis.named && diagnosis_repeat(noise->apart, field_largest(&kept[1]), &repeats))
        l->diagnosis = repeats;
    for (int k = 0; k < 2; k++) free(exact[k]), field_free(&given[k]);
}
