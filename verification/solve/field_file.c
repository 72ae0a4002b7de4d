/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a file to a field. */
#include "verification/solve/field_file.h"

#include "references/mapping.h"
#include "solver/field.h"
#include "solver/problem.h"
#include "solver/shape.h"
#include "solver/status.h"
#include "verification/solve/coverage.h"
#include "verification/case/samples.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Moves a coordinate that is a rounded decimal of a wall's onto the wall, so that its treatment there (such as the
 * missing value in a discontinuous corner) does not depend on its last digit. */
static void snap_to_walls(struct samples *s, const struct problem *p) {
    for (int a = 0; a < s->dim; a++) {
        double *x = s->value[COLUMN_X + a], away = 1e-9 * (p->hi[a] - p->lo[a]);
        for (size_t i = 0; i < s->n; i++)
            if (fabs(x[i] - p->lo[a]) <= away)
                x[i] = p->lo[a];
            else if (fabs(x[i] - p->hi[a]) <= away)
                x[i] = p->hi[a];
    }
}

/* Refuses a temperature that no error of a method leads to.  A source alone gives no scale. */
static int check_size(const struct samples *s, const struct problem *p, struct failure *why) {
    static const double OVERFLOW = 1e12; /* times the largest temperature of initial data and walls */
    double lo = HUGE_VAL, hi = -HUGE_VAL, x[DIM_MAX];
    const double *T = s->value[COLUMN_T];
    char place[SAMPLES_PLACE];
    size_t largest = 0;
    for (size_t i = 1; i < s->n; i++)
        if (fabs(T[i]) > fabs(T[largest])) largest = i;
    if (!(fabs(T[largest]) > OVERFLOW)) return STATUS_OK;
    for (size_t i = 0; i < s->n; i++) {
        double start = p->initial(p, samples_point(s, i, x));
        lo = fmin(lo, start), hi = fmax(hi, start);
        for (int side = 0; side < 2 * p->dim; side++)
            if (shape_has_wall(p, side) && problem_has_wall_temperature(p, side))
                problem_wall_range(p, (enum side)side, shape_foot(p, side, x).x, &lo, &hi);
    }
    if (fabs(T[largest]) <= OVERFLOW * fmax(1, fmax(fabs(lo), fabs(hi)))) return STATUS_OK;
    return refuse(
        why, STATUS_UNSTABLE,
        "%.150s, line %ld: T = %g K at %s m, where initial data and walls have %g to %g K: overflow, such as "
        "of an unstable step",
        s->path, samples_line(s, largest), T[largest], samples_place(s, largest, place), lo, hi);
}

static long long whole(double value) {
    return value > 0 && value < 1e18 ? (long long)value : 0;
}

/* The arrays change hands. */
static void hand_over(struct samples *s, const struct problem *p, struct field *f) {
    enum { MANY = 20000 }; /* points: more than threads cost to start */
    double coldest = HUGE_VAL, hottest = -HUGE_VAL;
#pragma omp parallel for reduction(min : coldest) reduction(max : hottest) if (s->n >= MANY)
    for (size_t i = 0; i < s->n; i++) {
        double x[DIM_MAX], start = p->initial(p, samples_point(s, i, x));
        coldest = fmin(coldest, start), hottest = fmax(hottest, start);
    }
    *f = (struct field){.dim = s->dim, .n = s->n, .range = {coldest, hottest}, .heat = {NAN, NAN}};
    double **const to[COLUMN_COUNT] = {&f->x[0], &f->x[1], &f->x[2], &f->T, &f->weight};
    for (int k = 0; k < COLUMN_COUNT; k++)
        if (k < s->dim || k >= COLUMN_T) *to[k] = s->value[k], s->value[k] = NULL;
    f->time = p->t_end;
    f->cost.step_seconds = s->seconds;
    f->steps = whole(s->steps);
    f->cost.updates = whole(s->updates);
    f->dt = f->steps > 0 ? p->t_end / (double)f->steps : 0;
    f->stages = f->steps > 0;
}

int field_file_read(const char *path, const char *name, const struct column_map *c, const struct image *image,
                    const double *d, struct field *f, struct failure *why) {
    const struct problem *p = &image->problem;
    struct samples s;
    if (samples_read(path, name, p->dim, c, &s, why)) return why->status;
    int status = coverage_check(&s, image, d, why);
    if (!status) status = samples_scale_weights(&s, why);
    if (!status) status = check_size(&s, p, why);
    if (!status) {
        snap_to_walls(&s, p);
        hand_over(&s, p, f);
    }
    samples_free(&s);
    return status;
}
