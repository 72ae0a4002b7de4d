/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Drawn rows: GSL's mt19937, seeded by the seed and by what is drawn, so that a row's draw does not depend on the
 * rows before it.  Numbers are drawn evenly (the scale: its logarithm) and rounded to three digits: what is typed is
 * what is run. */
#include "verification/gates/battery.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "verification/ladder/command.h"
#include "verification/run/run.h"
#include "verification/text/number.h"
#include "verification/text/words.h"

#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- The draw ---- */

static gsl_rng *generator(unsigned long seed, const char *scene, const char *more) {
    unsigned long hash = 2166136261; /* FNV-1a, 32 bits */
    for (const char *c = scene; *c; c++) hash = (hash ^ (unsigned char)*c) * 16777619 & 0xffffffff;
    for (const char *c = more; *c; c++) hash = (hash ^ (unsigned char)*c) * 16777619 & 0xffffffff;
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(r, (seed * 2654435761UL ^ hash) & 0xffffffff);
    return r;
}

static double between(gsl_rng *r, double lo, double hi) {
    char text[40];
    snprintf(text, sizeof text, "%.3g", lo + (hi - lo) * gsl_rng_uniform(r));
    return strtod(text, NULL);
}

/* One of two images of a rod, one of eight of a rectangle. */
static struct mapping draw_map(unsigned long seed, const char *scene, int dim, int cross) {
    gsl_rng *r = generator(seed, scene, "");
    struct mapping m = {.axes = dim};
    for (int a = 0; a < dim; a++) m.against[a] = (int)gsl_rng_uniform_int(r, 2) != cross;
    if (dim == 2) m.swap = (int)gsl_rng_uniform_int(r, 2) != cross;
    gsl_rng_free(r);
    return m;
}

/* Removes an option, " --scale " or " --set NAME=", and the word after it, where they are there. */
static void drop_option(char *words, const char *option) {
    char *at = strstr(words, option);
    if (!at) return;
    char *end = at + strlen(option) + strcspn(at + strlen(option), " ");
    memmove(at, end, strlen(end) + 1);
}

/* The words that the ranges ask for, at the end of *words; *offset in K of the scene. */
static int draw_ranges(const char *ranges, gsl_rng *r, char *words, double *offset, struct failure *why) {
    for (const char *at = ranges; *at; at += strspn(at, " ")) {
        char name[32], set[48];
        double lo, hi;
        int used = 0;
        if (strncmp(at, "cross", 5) == 0) {
            at += 5;
            continue;
        }
        if (sscanf(at, "%31[A-Za-z0-9_]=%lf:%lf%n", name, &lo, &hi, &used) != 3 || !(lo < hi))
            return refuse(why, STATUS_INPUT, "ranges '%.100s': NAME=LO:HI is wanted", at);
        at += used;
        double value = between(r, lo, hi);
        if (strcmp(name, "offset") == 0) {
            *offset = value;
            continue;
        }
        snprintf(set, sizeof set, " --set %s=", name);
        drop_option(words, set);
        words_add(words, DRAW_COMMAND, " --set %s=%.3g", name, value);
    }
    return STATUS_OK;
}

int draw_dimension(const char *command, struct failure *why) {
    const char *const program[] = {"--solver", "{case}{out}", NULL};
    struct command r;
    int dim = command_read_with(command, program, &r, why) ? 0 : r.experiment.problem.dim;
    command_free(&r);
    return dim;
}

int draw_command(const struct draw *d, unsigned long seed, char command[DRAW_COMMAND], struct failure *why) {
    const char *rest = strstr(d->command, " --dx ");
    char words[DRAW_COMMAND], scene[40], map[MAPPING_WORDS];
    double offset = 0;
    snprintf(command, DRAW_COMMAND, "%s", d->command);
    if (seed == 0) return STATUS_OK;
    int dim = draw_dimension(d->command, why);
    if (!dim || !rest || sscanf(d->command, "%*s %39s", scene) != 1)
        return refuse(why, STATUS_INPUT, "'%.200s': cannot be drawn", d->command);
    snprintf(words, sizeof words, "%.*s", (int)(rest - d->command), d->command);
    int cross = strstr(d->ranges, "cross") != NULL;
    gsl_rng *r = generator(seed, scene, d->ranges);
    struct mapping m = draw_map(seed, scene, dim, cross);
    int status = draw_ranges(d->ranges, r, words, &offset, why);
    double scale = between(r, -1, 1);
    gsl_rng_free(r);
    mapping_print(&m, map);
    scale = exp2(scale);
    snprintf(command, DRAW_COMMAND, "%.900s --map %s --scale %.3g", words, map, scale);
    if (offset != 0) words_add(command, DRAW_COMMAND, " --offset %.3g", scale * offset);
    words_add(command, DRAW_COMMAND, "%s", rest);
    return status;
}

/* ---- Its bound ---- */

/* The five-point difference at the finest spacing, of dx and dy the larger; it knows of no image, and a jump lies on
 * its faces. */
static int finest_run(const char *command, struct command *r, struct failure *why) {
    static const char *const options[] = {" --map ",    " --axes ",   " --scale ",
                                          " --offset ", " --aspect ", " --set a=8/15"};
    char words[DRAW_COMMAND], line[DRAW_COMMAND + 40], finest[40];
    const char *dx = strstr(command, " --dx "), *oblong = strstr(command, " --aspect ");
    double spacing, aspect = oblong ? strtod(oblong + strlen(" --aspect "), NULL) : 1;
    snprintf(words, sizeof words, "%.*s", (int)(dx - command), command);
    snprintf(finest, sizeof finest, "%.*s", (int)strcspn(dx + 6, " "), dx + 6);
    const char *last = strrchr(finest, ',');
    if (number_read(last ? last + 1 : finest, &spacing))
        return refuse(why, STATUS_INPUT, "'%.200s': --dx is no list of numbers", command);
    for (size_t i = 0; i < sizeof options / sizeof *options; i++) drop_option(words, options[i]);
    char *mine = strstr(words, " mine");
    int changing = strstr(words, "rise=") != NULL;
    snprintf(line, sizeof line, "run%.*s ftcs%s --dx %.17g%s", (int)(mine - strchr(words, ' ')), strchr(words, ' '),
             mine + 5, fmax(aspect, 1) * spacing, changing ? " --fourier 0.01" : "");
    return command_read(line, r, why);
}

/* Sums over the points of a field, by differences of the exact solution. */
struct sums {
    double T, gradient, laplace;
};

static struct sums sums_of(const struct experiment *e, const struct field *f) {
    const struct problem *p = &e->problem;
    const double d = e->options.dx / 8;
    struct sums sum = {0};
    for (size_t i = 0; i < f->n; i++) {
        double x[2] = {f->x[i], p->dim == 2 ? f->y[i] : 0}, laplace = 0, slopes = 0;
        struct exact here = scene_exact(e->scene, p, x, p->t_end);
        for (int a = 0; a < p->dim; a++) {
            double lo[2] = {x[0], x[1]}, hi[2] = {x[0], x[1]};
            lo[a] -= d, hi[a] += d;
            double below = scene_exact(e->scene, p, lo, p->t_end).temperature;
            double above = scene_exact(e->scene, p, hi, p->t_end).temperature;
            laplace += (below - 2 * here.temperature + above) / (d * d);
            slopes += fabs(above - below) / (2 * d); /* a cell away along each axis */
        }
        sum.T += fabs(here.temperature);
        sum.gradient += slopes;
        sum.laplace += fabs(laplace);
    }
    return sum;
}

/* |T_xx / T_x| at the high end of a rod. */
static double bend_at_end(const struct experiment *e) {
    const struct problem *p = &e->problem;
    double d = e->options.dx / 8, x[2] = {p->hi[0], 0}, in[2] = {p->hi[0] - d, 0};
    double end = scene_exact(e->scene, p, x, p->t_end).gradient[0],
           inside = scene_exact(e->scene, p, in, p->t_end).gradient[0];
    return fabs((end - inside) / d / end);
}

static double bound_of(enum draw_bound bound, const struct experiment *e, const struct field *f, double five_point) {
    double dx = e->options.dx;
    if (bound == FIVE_POINT) return five_point;
    if (bound == SLOPE_OF_ELEMENT) return dx / 2 * bend_at_end(e);
    struct sums sum = sums_of(e, f);
    if (bound == MEAN_OF_CELL) return dx * dx / 24 * sum.laplace / sum.T + five_point;
    return dx * sum.gradient / sum.T;
}

int draw_bound(const struct draw *d, const char *command, double *bound, struct failure *why) {
    struct command r = {0};
    struct result result;
    struct field f = {0};
    if (d->bound == AS_WRITTEN) return STATUS_OK;
    int status = finest_run(command, &r, why);
    if (!status && (status = run_experiment(&r.experiment, &result, &f))) *why = result.failure;
    if (!status) {
        double five_point = 4 * (strcmp(d->measure, "order_linf") == 0 ? result.error.linf : result.error.l1);
        *bound = bound_of(d->bound, &r.experiment, &f, five_point);
    }
    field_free(&f);
    command_free(&r);
    return status;
}
