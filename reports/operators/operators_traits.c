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
#include <stdio.h>

struct trait {
    double least;      /* weight, kappa/dx^2 */
    double limit;      /* dx^2/kappa; 0 where a mode grows at any step */
    double neighbours; /* of a row */
    double seconds;    /* of assembly, a particle, one thread */
    struct failure why;
};

/* The operator on n x n particles; fills *a. */
static int assemble(const struct candidate_operator *o, const struct cloud_kind *c, int n, int insulated,
                    struct heat_operator *a, double *seconds, struct failure *why) {
    struct model_problem b = {.method = method_find(o->method),
                              .dim = 2,
                              .n = n,
                              .insulated = insulated,
                              .options = {.layout = c->layout, .jitter = c->jitter, .seed = 1},
                              .step = {STEPPER_EULER, 0}};
    struct cloud cloud;
    if (model_problem_resolve(&b, n, why)) return why->status;
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    if (model_problem_cloud(&b, &p, &cloud, why)) return why->status;
    double start = omp_get_wtime();
    int status = operator_create_csr(a, &p, &b.options, b.method->scheme, &cloud, 1, why);
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

static int take_trait(const struct candidate_operator *o, const struct cloud_kind *c, struct trait *t) {
    enum { SIDE = 14, TIMED = 316 };
    struct heat_operator a;
    struct spectrum s;
    double ignored;
    int timed = c->layout == LAYOUT_JITTER; /* the others differ in places alone */
    if (assemble(o, c, SIDE, 1, &a, &ignored, &t->why)) return t->why.status;
    t->least = least_weight(&a);
    t->neighbours = (double)a.pairs / (double)a.n;
    operator_free(&a);
    if (assemble(o, c, SIDE, 0, &a, &ignored, &t->why)) return t->why.status;
    int status = spectrum_create(&s, &a, &(struct amplification){STEPPER_EULER, 0}, &t->why);
    operator_free(&a);
    if (status) return status;
    t->limit = s.limit;
    spectrum_free(&s);
    t->seconds = NAN;
    if (!timed) return STATUS_OK;
    status = assemble(o, c, TIMED, 0, &a, &t->seconds, &t->why);
    if (!status) t->neighbours = (double)a.pairs / (double)a.n, operator_free(&a);
    return status;
}

void operators_traits(FILE *csv, FILE *md) {
    fprintf(csv, "operator,cloud,least weight [kappa/dx^2],largest stable step [dx^2/kappa],neighbours,assembly "
                 "[us/particle]\n");
    fprintf(md,
            "\n## The operators by themselves, in the plane, h/dx 1.1\n\nLeast weight in kappa/dx^2; largest stable "
            "step of Euler's method in dx^2/kappa (0: a mode grows at any step); neighbours.\n\n| operator |");
    for (int c = 0; c < CLOUDS; c++) fprintf(md, " %s |", operators_clouds[c].name);
    fprintf(md, " assembly, us a particle |\n|---|");
    for (int c = 0; c <= CLOUDS; c++) fprintf(md, "---|");
    for (int k = 0; k < OPERATORS; k++) {
        double seconds = NAN;
        if (operators[k].materials != 1) continue;
        fprintf(md, "\n| `%s` |", operators[k].method);
        for (int c = 0; c < CLOUDS; c++) {
            struct trait t = {.least = INFINITY};
            if (take_trait(&operators[k], &operators_clouds[c], &t)) {
                fprintf(md, " refused |");
                continue;
            }
            fprintf(csv, "%s,%s,%.4g,%.4g,%.2f,%.3g\n", operators[k].method, operators_clouds[c].name, t.least,
                    t.limit, t.neighbours, 1e6 * t.seconds);
            fprintf(md, " %.3f, %.3f, %.1f |", t.least, t.limit, t.neighbours);
            if (operators_clouds[c].jitter == 0.3) seconds = t.seconds;
        }
        fprintf(md, " %.2f |", 1e6 * seconds);
    }
    fprintf(md, "\n");
}
