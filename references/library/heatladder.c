/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The public interface of the solvers and the references. */
#include "references/library/heatladder.h"

#include "references/columns.h"
#include "references/library/guard.h"
#include "references/mapping.h"
#include "references/snapshot.h"
#include "solver/field.h"
#include "solver/method.h"
#include "solver/shape.h"
#include "solver/time/stepper.h"
#include "solver/words.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "version.inc"

#define SAME(name) _Static_assert((int)HL_##name == (int)STATUS_##name, "one status, two names")
SAME(INPUT);
SAME(NUMERICAL);
SAME(NOT_APPLICABLE);
SAME(UNSTABLE);
SAME(MEMORY);
#undef SAME

struct hl_problem {
    const struct scene *scene;
    struct problem problem;
};

const char *hl_version(void) {
    return VERSION_TEXT;
}

const char *hl_scene(int i) {
    int count = 0;
    while (scenes[count]) count++;
    return i >= 0 && i < count ? scenes[i]->name : NULL;
}

const char *hl_method(int i) {
    int count = 0;
    while (methods[count]) count++;
    return i >= 0 && i < count ? methods[i]->name : NULL;
}

int hl_parameter(const char *scene, int i, struct hl_parameter *parameter) {
    const struct scene *s = scene ? scene_find(scene) : NULL;
    int count = 0;
    while (s && s->params[count].name) count++;
    if (i < 0 || i >= count || !parameter) return 0;
    const struct param *p = &s->params[i];
    *parameter = (struct hl_parameter){p->name, p->value, p->unit, p->about, p->choice};
    return 1;
}

static int call(int (*body)(void *argument, struct failure *why), void *argument, struct hl_error *why) {
    struct failure failure = {0};
    int status = guard_call(body, argument, &failure);
    if (why) why->status = status, memcpy(why->text, failure.text, sizeof why->text);
    return status;
}
_Static_assert(sizeof((struct hl_error){0}.text) == sizeof((struct failure){0}.text), "texts are of one size");

/* Refuses a NULL, by the name of its argument. */
static int missing(const char *name, struct failure *why) {
    return refuse(why, STATUS_INPUT, "%s is missing: it is NULL", name);
}

/* "unknown <what> '<name>'; did you mean ...": NULL is unknown too. */
static int unknown(const char *what, const char *name, const char *const *names, struct failure *why) {
    return name ? words_unknown(names, what, name, why) : missing(what, why);
}

/* ---- Problems ---- */

struct creation {
    const char *scene;
    const struct hl_setting *settings;
    struct hl_problem *made;
};

static int set(const struct scene *s, const struct hl_setting *set, struct problem *p, struct failure *why) {
    const char *names[PARAM_MAX + 1] = {0};
    char what[64];
    int words = 0;
    for (int k = 0; s->params[k].name; k++) names[k] = s->params[k].name;
    int i = words_index(names, set->name);
    snprintf(what, sizeof what, "parameter of %s", s->name);
    if (i < 0) return unknown(what, set->name, names, why);
    while (s->params[i].choice && s->params[i].choice[words]) words++;
    int in_range = !words || (set->value >= 0 && set->value < words && set->value == floor(set->value));
    if (!isfinite(set->value) || !in_range)
        return refuse(why, STATUS_INPUT, "--set %s=%g: must be %s", set->name, set->value,
                      words ? "the place of a word in the parameter's list" : "a finite number");
    p->param[i] = set->value;
    return STATUS_OK;
}

static int create(void *argument, struct failure *why) {
    struct creation *c = argument;
    const struct scene *s = c->scene ? scene_find(c->scene) : NULL;
    if (!s) {
        const char *names[WORDS_MAX] = {0};
        for (int i = 0; scenes[i] && i + 1 < WORDS_MAX; i++) names[i] = scenes[i]->name;
        return unknown("scene", c->scene, names, why);
    }
    struct hl_problem *h = xcalloc(1, sizeof *h);
    h->scene = s;
    scene_defaults(s, &h->problem);
    for (const struct hl_setting *at = c->settings; at && at->name; at++)
        if (set(s, at, &h->problem, why)) return why->status;
    if (s->setup(&h->problem, why)) return why->status;
    c->made = guard_keep(h);
    return STATUS_OK;
}

struct hl_problem *hl_problem_create(const char *scene, const struct hl_setting *settings, struct hl_error *why) {
    struct creation c = {scene, settings, NULL};
    call(create, &c, why);
    return c.made;
}

void hl_problem_free(struct hl_problem *problem) {
    guard_free(problem);
}

void hl_problem_box(const struct hl_problem *problem, struct hl_box *box) {
    if (box) *box = (struct hl_box){0};
    if (!box || !problem) return;
    const struct problem *p = &problem->problem;
    *box = (struct hl_box){.dim = p->dim, .hole = p->radius[0], .radius = p->radius[1], .t_end = p->t_end};
    for (int a = 0; a < p->dim; a++) box->lo[a] = p->lo[a], box->hi[a] = p->hi[a];
}

/* ---- Quantities at points ---- */

struct evaluation {
    const struct hl_problem *problem;
    double t;
    const struct hl_points *points;
    double *value, *bound; /* bound: of the exact solution */
    const char *what;      /* names of columns */
};

static const char axes[DIM_MAX] = {'x', 'y', 'z'};

/* Copies the point into at; one within 1e-9 of the extent from a side is on it. */
static int take_point(const struct problem *p, const double *const x[DIM_MAX], size_t i, double at[DIM_MAX],
                      struct failure *why) {
    const double SLACK = 1e-9;
    char place[PLACE_TEXT];
    for (int a = 0; a < p->dim; a++) {
        at[a] = x[a][i];
        double away = SLACK * (p->hi[a] - p->lo[a]);
        if (!(at[a] >= p->lo[a] - away && at[a] <= p->hi[a] + away))
            return refuse(why, STATUS_INPUT, "point %zu: %c = %.12g m is outside %g to %g m", i, axes[a], at[a],
                          p->lo[a], p->hi[a]);
        if (fabs(at[a] - p->lo[a]) <= away) at[a] = p->lo[a];
        if (fabs(at[a] - p->hi[a]) <= away) at[a] = p->hi[a];
    }
    if (p->shape && !(shape_depth(p, at) >= -SLACK * p->radius[1]))
        return refuse(why, STATUS_INPUT, "point %zu: %s is outside the %s", i, problem_place(p->dim, at, place),
                      p->shape->name);
    return STATUS_OK;
}

/* Copies the extents of the cell into extent. */
static int take_cell(int dim, const struct hl_points *points, size_t i, double extent[DIM_MAX], struct failure *why) {
    const double *const cell[DIM_MAX] = {points->dx, points->dy ? points->dy : points->dx,
                                         points->dz ? points->dz : points->dx};
    for (int a = 0; a < dim; a++) {
        extent[a] = cell[a][i];
        if (!(extent[a] >= 0 && isfinite(extent[a])))
            return refuse(why, STATUS_INPUT, "point %zu: d%c = %g m: the extent of a cell is finite and >= 0", i,
                          axes[a], extent[a]);
    }
    return STATUS_OK;
}

/* value: the name of that argument. */
static int check_arguments(const struct evaluation *e, const char *value, struct failure *why) {
    const struct hl_points *points = e->points;
    if (!e->problem) return missing("problem", why);
    if (!points) return missing("points", why);
    if (points->n && !e->value) return missing(value, why);
    const double *const x[DIM_MAX] = {points->x, points->y, points->z};
    const int dim = e->problem->problem.dim;
    if (!(e->t >= 0 && isfinite(e->t))) return refuse(why, STATUS_INPUT, "t = %g s: must be finite and >= 0", e->t);
    for (int a = 0; a < dim && points->n; a++)
        if (!x[a])
            return refuse(why, STATUS_INPUT, "%c is missing: %s has %d ax%cs", axes[a], e->problem->scene->name, dim,
                          dim > 1 ? 'e' : 'i');
    return STATUS_OK;
}

enum { BATCH = 4096 }; /* points that share work */

/* The guard releases the arrays and the snapshot. */
static int exact_at(void *argument, struct failure *why) {
    const struct evaluation *e = argument;
    const struct hl_points *points = e->points;
    if (check_arguments(e, "T", why)) return why->status;
    const struct problem *p = &e->problem->problem;
    double at[DIM_MAX], *x[DIM_MAX] = {NULL};
    for (int a = 0; a < p->dim; a++) x[a] = xcalloc(BATCH, sizeof **x);
    struct exact *exact = xcalloc(BATCH, sizeof *exact);
    struct snapshot s = snapshot_take(e->problem->scene, p, e->t);
    for (size_t first = 0; first < points->n; first += BATCH) {
        size_t count = points->n - first < BATCH ? points->n - first : BATCH;
        for (size_t i = 0; i < count; i++) {
            if (take_point(p, (const double *const[]){points->x, points->y, points->z}, first + i, at, why))
                return why->status;
            for (int a = 0; a < p->dim; a++) x[a][i] = at[a];
        }
        snapshot_at_points(&s, count, x[0], x[1], x[2], exact);
        for (size_t i = 0; i < count; i++) {
            e->value[first + i] = exact[i].temperature;
            if (e->bound) e->bound[first + i] = exact[i].error_bound;
        }
    }
    return STATUS_OK;
}

static int read_columns(const struct hl_problem *h, const char *what, struct columns *c, struct failure *why) {
    return what ? columns_parse(what, h->problem.dim, c, why) : missing("what", why);
}

static int reference_at(void *argument, struct failure *why) {
    const struct evaluation *e = argument;
    const struct hl_points *points = e->points;
    struct columns c;
    if (check_arguments(e, "value", why) || read_columns(e->problem, e->what, &c, why)) return why->status;
    if (columns_check(&c, &e->problem->problem, 1, &e->t, points->dx != NULL, why)) return why->status;
    const struct problem *p = &e->problem->problem;
    const double *const given[DIM_MAX] = {points->x, points->y, points->z};
    double(*x)[DIM_MAX] = xcalloc(BATCH, sizeof *x), (*cell)[DIM_MAX] = xcalloc(BATCH, sizeof *cell);
    double *value = xcalloc(BATCH * (size_t)c.values, sizeof *value);
    struct image image;
    mapping_image(&(struct mapping){0}, p, &image);
    struct snapshot now = snapshot_take(e->problem->scene, p, e->t);
    for (size_t first = 0; first < points->n; first += BATCH) {
        size_t count = points->n - first < BATCH ? points->n - first : BATCH, values = (size_t)c.values;
        for (size_t i = 0; i < count; i++) {
            if (take_point(p, given, first + i, x[i], why)) return why->status;
            if (points->dx && take_cell(p->dim, points, first + i, cell[i], why)) return why->status;
        }
        columns_at_points(&c, &image, &now, count, x, points->dx ? cell : NULL, value);
        for (size_t i = 0; i < count; i++)
            for (size_t j = 0; j < values; j++) e->value[j * points->n + first + i] = value[i * values + j];
    }
    return STATUS_OK;
}

int hl_exact_at(const struct hl_problem *problem, double t, size_t n, const double *x, const double *y,
                const double *z, double *T, double *bound, struct hl_error *why) {
    struct hl_points points = {n, x, y, z, NULL, NULL, NULL};
    return call(exact_at, &(struct evaluation){problem, t, &points, T, bound, NULL}, why);
}

int hl_exact(const struct hl_problem *problem, double t, size_t n, const double *x, const double *y, double *T,
             double *bound, struct hl_error *why) {
    return hl_exact_at(problem, t, n, x, y, NULL, T, bound, why);
}

int hl_reference(const struct hl_problem *problem, const char *what, double t, const struct hl_points *points,
                 double *value, struct hl_error *why) {
    return call(reference_at, &(struct evaluation){problem, t, points, value, NULL, what}, why);
}

struct naming {
    const struct hl_problem *problem;
    const char *what;
    char *names;
    size_t size;
    int values;
};

static int name_values(void *argument, struct failure *why) {
    struct naming *n = argument;
    struct columns c;
    char header[COLUMNS_HEADER];
    if (!n->problem) return missing("problem", why);
    if (read_columns(n->problem, n->what, &c, why)) return why->status;
    columns_header(&c, header);
    if (n->names && strlen(header) >= n->size)
        return refuse(why, STATUS_INPUT, "size = %zu: the names take %zu characters", n->size, strlen(header) + 1);
    if (n->names) strcpy(n->names, header);
    n->values = c.values;
    return STATUS_OK;
}

int hl_reference_values(const struct hl_problem *problem, const char *what, char *names, size_t size,
                        struct hl_error *why) {
    struct naming n = {problem, what, names, size, 0};
    return call(name_values, &n, why) ? -1 : n.values;
}

/* ---- Solvers ---- */

struct solution {
    const struct hl_problem *problem;
    const char *method;
    const struct hl_options *options;
    struct hl_field *field;
};

/* The place of the word among `words` into *value; unchanged for NULL. */
static int read_word(const char *name, const char *word, const char *const *words, int *value, struct failure *why) {
    if (!word) return STATUS_OK;
    *value = words_index(words, word);
    return *value < 0 ? words_unknown(words, name, word, why) : STATUS_OK;
}

static int read_options(const struct method *m, const struct hl_options *given, struct options *o,
                        struct failure *why) {
    int word[6] = {0};
    const struct {
        const char *name;
        int is_given;
        const char *word, *const *words;
    } option[] = {{"kernel", given->kernel != NULL, given->kernel, kernel_words},
                  {"stepper", given->stepper != NULL, given->stepper, stepper_words},
                  {"layout", given->layout != NULL, given->layout, layout_words},
                  {"sampling", given->sampling != NULL, given->sampling, sampling_words},
                  {"walls", given->walls != NULL, given->walls, walls_words},
                  {"mean", given->mean != NULL, given->mean, mean_words},
                  {"h", given->h != 0, NULL, NULL},
                  {"order", given->order != 0, NULL, NULL},
                  {"jitter", given->jitter != 0, NULL, NULL},
                  {"seed", given->seed != 0, NULL, NULL}};
    for (size_t i = 0; i < sizeof option / sizeof *option; i++) {
        if (option[i].is_given && !words_among(m->accepts, option[i].name))
            return refuse(why, STATUS_INPUT, "--%s: no option of %s", option[i].name, m->name);
        if (option[i].words && read_word(option[i].name, option[i].word, option[i].words, &word[i], why))
            return why->status;
    }
    *o = (struct options){.dx = given->dx,
                          .dt = given->dt,
                          .fourier = given->fourier,
                          .h = given->h,
                          .jitter = given->jitter,
                          .order = given->order,
                          .seed = given->seed,
                          .kernel = (enum kernel_name)word[0],
                          .stepper = (enum stepper_name)word[1],
                          .layout = (enum layout_name)word[2],
                          .sampling = (enum sampling)word[3],
                          .walls = (enum walls)word[4],
                          .mean = (enum mean)word[5]};
    return STATUS_OK;
}

static int solve(void *argument, struct failure *why) {
    const struct solution *s = argument;
    const struct method *m = s->method ? method_find(s->method) : NULL;
    struct field f;
    struct options o;
    if (!s->problem) return missing("problem", why);
    if (!s->field) return missing("field", why);
    if (!s->options) return missing("options", why);
    if (!m) {
        const char *names[WORDS_MAX] = {0};
        for (int i = 0; methods[i] && i + 1 < WORDS_MAX; i++) names[i] = methods[i]->name;
        return unknown("method", s->method, names, why);
    }
    const struct problem *p = &s->problem->problem;
    if (read_options(m, s->options, &o, why)) return why->status;
    int is_open = o.stepper == STEPPER_AUTO && m->scheme && o.dt == 0 && o.fourier == 0;
    if (is_open) o.stepper = stepper_auto(1, 0, 1);
    int status = method_solve(m, p, &o, &f, why);
    if (is_open && status == STATUS_NOT_APPLICABLE) {
        o.stepper = STEPPER_AUTO;
        status = method_solve(m, p, &o, &f, why);
    }
    if (status) return status;
    double *x[DIM_MAX] = {NULL}, at[DIM_MAX];
    for (int a = 0; a < f.dim; a++) x[a] = xcalloc(f.n, sizeof **x);
    for (size_t i = 0; i < f.n; i++) {
        field_place(&f, i, at);
        for (int a = 0; a < f.dim; a++) x[a][i] = at[a];
    }
    *s->field = (struct hl_field){.dim = f.dim,
                                  .n = f.n,
                                  .x = guard_keep(x[0]),
                                  .y = guard_keep(x[1]),
                                  .z = guard_keep(x[2]),
                                  .T = guard_keep(f.T),
                                  .t = f.time,
                                  .dt = f.dt,
                                  .steps = f.steps};
    return STATUS_OK;
}

int hl_solve(const struct hl_problem *problem, const char *method, const struct hl_options *options,
             struct hl_field *field, struct hl_error *why) {
    struct solution s = {problem, method, options, field};
    if (field) *field = (struct hl_field){0};
    return call(solve, &s, why);
}

void hl_field_free(struct hl_field *field) {
    if (!field) return;
    guard_free(field->x);
    guard_free(field->y);
    guard_free(field->z);
    guard_free(field->T);
    *field = (struct hl_field){0};
}
