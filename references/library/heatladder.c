/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The public interface of the solvers and the references. */
#include "references/library/heatladder.h"

#include "references/library/guard.h"
#include "references/scene.h"
#include "references/snapshot.h"
#include "solver/field.h"
#include "solver/method.h"
#include "solver/shape.h"
#include "solver/time/stepper.h"

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
    const struct scene *s = scene_find(scene);
    int count = 0;
    while (s && s->params[count].name) count++;
    if (i < 0 || i >= count) return 0;
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

/* ---- Problems ---- */

struct creation {
    const char *scene;
    const struct hl_setting *settings;
    struct hl_problem *made;
};

static int set(const struct scene *s, const struct hl_setting *set, struct problem *p, struct failure *why) {
    int i = 0, words = 0;
    while (s->params[i].name && strcmp(s->params[i].name, set->name) != 0) i++;
    const struct param *param = &s->params[i];
    if (!param->name) return refuse(why, STATUS_INPUT, "%s has no parameter '%.60s'", s->name, set->name);
    while (param->choice && param->choice[words]) words++;
    int in_range = !words || (set->value >= 0 && set->value < words && set->value == floor(set->value));
    if (!isfinite(set->value) || !in_range)
        return refuse(why, STATUS_INPUT, "%s = %g: must be %s", set->name, set->value,
                      words ? "the place of a word in the parameter's list" : "finite");
    p->param[i] = set->value;
    return STATUS_OK;
}

static int create(void *argument, struct failure *why) {
    struct creation *c = argument;
    const struct scene *s = c->scene ? scene_find(c->scene) : NULL;
    if (!s) return refuse(why, STATUS_INPUT, "no scene '%.60s'", c->scene ? c->scene : "");
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
    const struct problem *p = &problem->problem;
    *box = (struct hl_box){.dim = p->dim, .hole = p->radius[0], .radius = p->radius[1], .t_end = p->t_end};
    for (int a = 0; a < p->dim; a++) box->lo[a] = p->lo[a], box->hi[a] = p->hi[a];
}

/* ---- Exact solutions ---- */

struct evaluation {
    const struct hl_problem *problem;
    double t;
    size_t n;
    const double *x[DIM_MAX];
    double *T, *bound;
};

static const char axes[DIM_MAX] = {'x', 'y', 'z'};

/* Copies the point into at; one within 1e-9 of the extent from a side is on it. */
static int take_point(const struct evaluation *e, size_t i, double at[DIM_MAX], struct failure *why) {
    const double SLACK = 1e-9;
    const struct problem *p = &e->problem->problem;
    for (int a = 0; a < p->dim; a++) {
        at[a] = e->x[a][i];
        double away = SLACK * (p->hi[a] - p->lo[a]);
        if (!(at[a] >= p->lo[a] - away && at[a] <= p->hi[a] + away))
            return refuse(why, STATUS_INPUT, "point %zu: %c = %.12g m is outside %g to %g m", i, axes[a], at[a],
                          p->lo[a], p->hi[a]);
        if (fabs(at[a] - p->lo[a]) <= away) at[a] = p->lo[a];
        if (fabs(at[a] - p->hi[a]) <= away) at[a] = p->hi[a];
    }
    char third[32] = "";
    if (p->dim == 3) snprintf(third, sizeof third, ", %g", at[2]);
    if (p->shape && !(shape_depth(p, at) >= -SLACK * p->radius[1]))
        return refuse(why, STATUS_INPUT, "point %zu: %g, %g%s m is outside the %s", i, at[0], at[1], third,
                      p->shape->name);
    return STATUS_OK;
}

static int evaluate(void *argument, struct failure *why) {
    enum { BATCH = 4096 };
    const struct evaluation *e = argument;
    const struct problem *p = &e->problem->problem;
    if (!(e->t >= 0 && isfinite(e->t))) return refuse(why, STATUS_INPUT, "t = %g s: must be finite and >= 0", e->t);
    double at[DIM_MAX], *x[DIM_MAX] = {NULL};
    for (int a = 0; a < p->dim; a++) {
        if (e->n && !e->x[a])
            return refuse(why, STATUS_INPUT, "%c is missing: %s has %d axes", axes[a], e->problem->scene->name,
                          p->dim);
        x[a] = xcalloc(BATCH, sizeof **x);
    }
    struct exact *exact = xcalloc(BATCH, sizeof *exact);
    struct snapshot s = snapshot_take(e->problem->scene, p, e->t);
    for (size_t first = 0; first < e->n; first += BATCH) {
        size_t count = e->n - first < BATCH ? e->n - first : BATCH;
        for (size_t i = 0; i < count; i++) {
            if (take_point(e, first + i, at, why)) return why->status;
            for (int a = 0; a < p->dim; a++) x[a][i] = at[a];
        }
        snapshot_at_points(&s, count, x[0], x[1], x[2], exact);
        for (size_t i = 0; i < count; i++) {
            e->T[first + i] = exact[i].temperature;
            if (e->bound) e->bound[first + i] = exact[i].error_bound;
        }
    }
    return STATUS_OK; /* the guard releases the arrays and the snapshot */
}

int hl_exact_at(const struct hl_problem *problem, double t, size_t n, const double *x, const double *y,
                const double *z, double *T, double *bound, struct hl_error *why) {
    struct evaluation e = {problem, t, n, {x, y, z}, T, bound};
    return call(evaluate, &e, why);
}

int hl_exact(const struct hl_problem *problem, double t, size_t n, const double *x, const double *y, double *T,
             double *bound, struct hl_error *why) {
    return hl_exact_at(problem, t, n, x, y, NULL, T, bound, why);
}

/* ---- Solvers ---- */

struct solution {
    const struct hl_problem *problem;
    const char *method;
    const struct hl_options *options;
    struct hl_field *field;
};

static int accepts(const struct method *m, const char *name) {
    size_t length = strlen(name);
    for (const char *at = m->accepts; (at = strstr(at, name)); at += length)
        if ((at == m->accepts || at[-1] == ' ') && (at[length] == '\0' || at[length] == ' ')) return 1;
    return 0;
}

/* The place of the word among `words` into *value; unchanged for NULL. */
static int read_word(const char *name, const char *word, const char *const *words, int *value, struct failure *why) {
    int i = 0;
    if (!word) return STATUS_OK;
    while (words[i] && strcmp(words[i], word) != 0) i++;
    if (!words[i]) return refuse(why, STATUS_INPUT, "%s = '%.60s': unknown", name, word);
    *value = i;
    return STATUS_OK;
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
        if (option[i].is_given && !accepts(m, option[i].name))
            return refuse(why, STATUS_INPUT, "%s: no option of %s", option[i].name, m->name);
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
    if (given->order && (given->order < 2 || given->order > 4))
        return refuse(why, STATUS_INPUT, "order = %d: must be 2, 3 or 4", given->order);
    return STATUS_OK;
}

static int solve(void *argument, struct failure *why) {
    const struct solution *s = argument;
    const struct method *m = s->method ? method_find(s->method) : NULL;
    const struct problem *p = &s->problem->problem;
    struct field f;
    struct options o;
    if (!m) return refuse(why, STATUS_INPUT, "no method '%.60s'", s->method ? s->method : "");
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
    *field = (struct hl_field){0};
    return call(solve, &s, why);
}

void hl_field_free(struct hl_field *field) {
    guard_free(field->x);
    guard_free(field->y);
    guard_free(field->z);
    guard_free(field->T);
    *field = (struct hl_field){0};
}
