/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a file to a field. */
#include "verification/solve/field_file.h"

#include "solver/field.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/solve/coverage.h"
#include "verification/case/samples.h"

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

static int check_weights(const struct samples *s, struct failure *why) {
    double sum = 0;
    for (size_t i = 0; i < s->n && s->value[COLUMN_W]; i++) {
        double w = s->value[COLUMN_W][i];
        if (!(w >= 0))
            return refuse(why, STATUS_INPUT, "%.150s, line %ld: w = %g; a weight must be 0 or more", s->path,
                          samples_line(s, i), w);
        sum += w;
    }
    if (s->value[COLUMN_W] && !(sum > 0))
        return refuse(why, STATUS_INPUT, "%.150s: all weights w are 0; a norm needs some above", s->path);
    return STATUS_OK;
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

int field_file_read(const char *path, const char *name, const struct column_map *c, const struct problem *p,
                    const double *d, struct field *f, struct failure *why) {
    struct samples s;
    if (samples_read(path, name, p->dim, c, &s, why)) return why->status;
    int status = coverage_check(&s, p, d, why);
    if (!status) status = missing_points_check(&s, p, d, why);
    if (!status) status = check_weights(&s, why);
    if (!status) {
        snap_to_walls(&s, p);
        hand_over(&s, p, f);
    }
    samples_free(&s);
    return status;
}
