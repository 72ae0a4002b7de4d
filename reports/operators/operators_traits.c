/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Operators by themselves: n x n particles in the plane with dx = 1 and kappa = 1, insulated for the weights, between
 * cold walls for the eigenvalues; assembly is timed on 316 x 316 particles. */
#include "reports/operators/candidates.h"

#include "solver/method.h"
#include "solver/space/csr.h"
#include "verification/stability/model_problem.h"
#include "verification/stability/spectrum.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>

/* The operator on n x n particles; fills *a. */
static int assemble(const struct candidate_operator *o, const struct cloud_kind *c, int n, int insulated,
                    struct heat_operator *a, double *seconds) {
    struct model_problem b = {.method = method_find(o->method),
                              .dim = 2,
                              .n = n,
                              .insulated = insulated,
                              .options = {.layout = c->layout, .jitter = c->jitter, .seed = 1},
                              .step = {STEPPER_EULER, 0}};
    struct cloud cloud;
    struct failure why;
    if (model_problem_resolve(&b, n, &why)) return why.status;
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    if (model_problem_cloud(&b, &p, &cloud, &why)) return why.status;
    double start = omp_get_wtime();
    int status = operator_create_csr(a, &p, &b.options, b.method->scheme, &cloud, 1, &why);
    *seconds = (omp_get_wtime() - start) / (double)cloud.n;
    layout_cloud_free(&cloud);
    return status;
}

static double least_weight(const struct heat_operator *a) {
    struct row r;
    double least = INFINITY;
    csr_row_create(&r, a->n);
    for (size_t i = 0; i < a->n; i++) {
        operator_row_take(a, i, &r);
        for (size_t k = 0; k < r.n; k++)
            if (r.column[k] != i) least = fmin(least, r.value[r.column[k]]);
    }
    csr_row_free(&r);
    return least;
}

static void take_trait(const struct candidate_operator *o, const struct cloud_kind *c, struct trait *t) {
    enum { SIDE = 14 };
    struct heat_operator a;
    struct spectrum s;
    double ignored;
    *t = (struct trait){.least = INFINITY, .seconds = NAN};
    t->status = assemble(o, c, SIDE, 1, &a, &ignored);
    if (t->status) return;
    t->least = least_weight(&a);
    t->neighbours = (double)a.pairs / (double)a.n;
    operator_free(&a);
    t->status = assemble(o, c, SIDE, 0, &a, &ignored);
    if (t->status) return;
    struct failure why;
    t->status = spectrum_create(&s, &a, &(struct amplification){STEPPER_EULER, 0}, &why);
    operator_free(&a);
    if (t->status) return;
    t->limit = s.limit;
    spectrum_free(&s);
}

/* Assembly on a large cloud, with nothing beside it. */
static void take_seconds(const struct candidate_operator *o, const struct cloud_kind *c, struct trait *t) {
    enum { SIDE = 316 };
    struct heat_operator a;
    t->status = assemble(o, c, SIDE, 0, &a, &t->seconds);
    if (!t->status) t->neighbours = (double)a.pairs / (double)a.n, operator_free(&a);
}

struct trait *operators_take_traits(void) {
    struct trait *all = xcalloc(OPERATORS * CLOUDS, sizeof *all);
#pragma omp parallel for schedule(dynamic, 1)
    for (int k = 0; k < OPERATORS * CLOUDS; k++)
        if (operators[k / CLOUDS].materials == 1)
            take_trait(&operators[k / CLOUDS], &operators_clouds[k % CLOUDS], &all[k]);
    for (int k = 0; k < OPERATORS; k++) {
        struct trait *timed = &all[k * CLOUDS + OPERATORS_JITTER_03];
        if (operators[k].materials == 1 && !timed->status)
            take_seconds(&operators[k], &operators_clouds[OPERATORS_JITTER_03], timed);
    }
    return all;
}

void operators_traits(const struct trait *all, FILE *csv, FILE *md) {
    fprintf(csv, "operator,cloud,least weight [kappa/dx^2],largest stable step [dx^2/kappa],neighbours,assembly "
                 "[us/particle]\n");
    fprintf(md,
            "\n## The operators by themselves, in the plane, h/dx 1.1\n\nLeast weight in kappa/dx^2; largest stable "
            "step of Euler's method in dx^2/kappa (0: a mode grows at any step); neighbours.\n\n| operator |");
    for (int c = 0; c < CLOUDS; c++) fprintf(md, " %s |", operators_clouds[c].name);
    fprintf(md, " assembly, us a particle |\n|---|");
    for (int c = 0; c <= CLOUDS; c++) fprintf(md, "---|");
    for (int k = 0; k < OPERATORS; k++) {
        if (operators[k].materials != 1) continue;
        fprintf(md, "\n| `%s` |", operators[k].method);
        for (int c = 0; c < CLOUDS; c++) {
            const struct trait *t = &all[k * CLOUDS + c];
            if (t->status) {
                fprintf(md, " refused |");
                continue;
            }
            fprintf(csv, "%s,%s,%.4g,%.4g,%.2f,%.3g\n", operators[k].method, operators_clouds[c].name, t->least,
                    t->limit, t->neighbours, 1e6 * t->seconds);
            fprintf(md, " %.3f, %.3f, %.1f |", t->least, t->limit, t->neighbours);
        }
        fprintf(md, " %.2f |", 1e6 * all[k * CLOUDS + OPERATORS_JITTER_03].seconds);
    }
    fprintf(md, "\n");
}
