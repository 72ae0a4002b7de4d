/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the two finest fields of a ladder to the fault that its errors match. */
#include "verification/fault/diagnose.h"

#include "references/scene.h"
#include "solver/field.h"
#include "solver/status.h"
#include "verification/fault/fit.h"
#include "verification/fault/wording.h"
#include "verification/solve/program.h"
#include "verification/judge/ladder.h"
#include "verification/judge/norms.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The difference of the program's answer at dx and a time `early`, in units of dx^2/kappa, from point values of that
 * time, in units of dx^2/24 laplace(T) (diagnosis_mean). */
static double start_at(const struct experiment *e, double dx, double early) {
    struct experiment start = *e;
    struct result result;
    struct failure ignored;
    struct field f = {0};
    int i = 0;
    start.options.dx = dx;
    start.program.keep = NULL;
    start.program.diagnosis = 1;
    while (strcmp(e->scene->params[i].name, "t_end") != 0) i++;
    start.problem.param[i] = early * dx * dx / problem_diffusivity(&e->problem);
    if (e->scene->setup(&start.problem, &ignored) || run_experiment(&start, &result, &f)) return NAN;
    double *exact = xcalloc(f.n, sizeof *exact);
    norms_exact(e->scene, &start.problem, &f, exact);
    double mean = diagnosis_mean(&start.problem, &(struct diagnosis_rung){&f, exact, dx, 0, NAN});
    free(exact);
    field_free(&f);
    return mean;
}

/* Determines whether the program's numbers are point values or cell means, from its answer at a time so early that
 * one step too many or too few is a hundredth of the difference between a mean and a value.  No such numbers differ
 * from values by more than 2 units.  A program of whole steps of F dx^2/kappa makes none or one, 24 F units.  With a
 * later t_end it gives the same answer, and is off by 24 (LATER - EARLY) units less; any other difference stays.
 * *late is then F, which the unknown mean leaves uncertain by 1/12; or, if it made none, minus the longest stable
 * step in a rod; otherwise 0. */
static double mean_of_start(const struct experiment *e, double dx, double *late) {
    static const double EARLY = 1e-4, LATER = 0.02, MOST = 1.1 * FIT_MOST, SAME = 0.1, LONGEST = 0.5;
    *late = 0;
    double mean = e->program.solver ? start_at(e, dx, EARLY) : NAN, whole = nearbyint(mean);
    if (!(isfinite(mean) && mean - start_at(e, dx, LATER) > 12 * (LATER - EARLY)))
        return fabs(mean) <= MOST ? mean : NAN;
    int is_sampling = fabs(mean - whole) < SAME && (whole == 0 || whole == 1 || whole == -2);
    if (is_sampling) *late = -LONGEST;
    if (mean > 0 && !is_sampling && fabs(mean - 2) >= SAME) *late = mean / 24; /* 2: a lumped mass, or F = 1/12 */
    return is_sampling ? mean : NAN;
}

/* The case given to the program, in its axes and temperatures.  If two materials meet across y, no solver here can
 * compute the response, and the scene itself is used. */
static void find_fault(const struct experiment *e, const struct ladder *l, struct diagnosis *d) {
    struct diagnosis_rung rung[2];
    struct field given[2] = {{0}, {0}};
    struct image image;
    double *exact[2], late, mean = mean_of_start(e, l->x[l->n - 2], &late);
    mapping_image(&e->program.map, &e->problem, &image);
    int mapped = e->problem.materials == 1 || image.interface_axis == 0;
    for (int k = 0; k < 2; k++) {
        const struct field *kept = &l->kept[k];
        exact[k] = xcalloc(kept->n, sizeof **exact);
        norms_exact(e->scene, &e->problem, kept, exact[k]);
        if (mapped) given[k] = program_as_given(&e->program, kept, exact[k]);
        double dt = kept->dt;
        if (!(dt > 0) && kept->steps > 0) dt = kept->time / (double)kept->steps;
        rung[k] = (struct diagnosis_rung){mapped ? &given[k] : kept, exact[k], l->x[l->n - 1 - k], dt, mean};
    }
    const struct problem *p = mapped ? &image.problem : &e->problem;
    if (!diagnosis_unstable(&rung[0], d) && !diagnosis_unstable(&rung[1], d) && !diagnosis_cut(p, &rung[0], d))
        diagnosis_find(p, &rung[0], &rung[1], d);
    if (late != 0) diagnosis_whole_steps(late, d);
    if (!mapped && d->named && d->fault.kind == FAULT_OFFSET) {
        d->size *= mapping_scale(&e->program.map); /* in the temperatures of the case */
        wording_fault(d);
    }
    for (int k = 0; k < 2; k++) free(exact[k]), field_free(&given[k]);
}

void diagnose_ladder(const struct experiment *e, struct ladder *l, struct diagnosis *d) {
    struct diagnosis repeats;
    double apart = l->noise.apart, largest = field_largest(&l->kept[1]);
    *d = (struct diagnosis){.unit = ""};
    if (l->failure.status == STATUS_UNSTABLE) diagnosis_overflow(d);
    if (l->failure.exchanged) diagnosis_exchanged(l->failure.exchanged - 1, d);
    if (!l->open || d->named) return;
    if (l->n < 2 || l->kept[0].n == 0 || l->kept[1].n == 0) {
        snprintf(d->what, sizeof d->what, "none: two rungs with an answer are needed");
        return;
    }
    if (l->noise.share > JUDGE_NOISE && diagnosis_repeat(apart, largest, d)) return;
    find_fault(e, l, d);
    if (!d->named && diagnosis_repeat(apart, largest, &repeats)) {
        free(d->evidence);
        *d = repeats;
    }
    if (d->named) ladder_explained(l);
}
