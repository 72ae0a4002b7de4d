/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder reference: the exact solution at one point and time, with its error bound; or columns of a scene at the
 * points of a file. */
#include "verification/cli/verb.h"

#include "references/scene.h"
#include "verification/case/answer.h"
#include "verification/text/json.h"
#include "verification/text/output.h"
#include "verification/text/whole_file.h"

#include "solver/method.h"
#include "solver/status.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct reference_options {
    struct command command;
    const char *points;    /* file of points, - for standard input; NULL: --at */
    const char *what;      /* columns; NULL: the temperature */
    double cell;           /* m */
    const char *json_path; /* NULL for none */
};

#define PLACE(member) OPTION_PLACE(reference_options, member)
static const struct option own[] = {
    {"", .about = "Output:"},
    {"points", "FILE", "CSV of points x, x,y or x,y,z, m; - for standard input", option_text, PLACE(points)},
    {"what", "LIST", "columns to print at each point, separated by commas; default temperature", option_text,
     PLACE(what)},
    {"dx", "DX", "extent of the cell around each point, m, for initial_mean", option_number, PLACE(cell),
     OPTION_POSITIVE},
    JSON_OPTION(PLACE(json_path), "the temperature at one point and time"),
    {0}};

/* Both forms at one point. */
struct forms {
    struct exact exact, second;
    double published;
};

static int write_json(const struct reference_options *r, const struct forms *f, struct failure *why) {
    struct output page;
    struct json j = json_on(output_open(&page, "%s", r->json_path));
    json_text(&j, "scene", r->command.experiment.scene->name);
    json_numbers(&j, "at", r->command.at.value, r->command.experiment.problem.dim);
    json_number(&j, "time", r->command.time.value[0]);
    json_number(&j, "temperature", f->exact.no_value ? NAN : f->exact.temperature);
    json_number(&j, "error_bound", f->exact.no_value ? NAN : f->exact.error_bound);
    int second = !f->second.no_value && isfinite(f->second.error_bound);
    json_number(&j, "second_form", second ? f->second.temperature : NAN);
    json_number(&j, "second_error_bound", second ? f->second.error_bound : NAN);
    if (r->command.experiment.scene->published) {
        json_number(&j, "published", f->published);
        json_number(&j, "difference", f->exact.no_value ? NAN : f->published - f->exact.temperature);
    }
    json_end(&j);
    return output_close(&page, 1, why);
}

static void print_text(const struct reference_options *r, const struct forms *f) {
    printf("%s at %g", r->command.experiment.scene->name, r->command.at.value[0]);
    for (int a = 1; a < r->command.experiment.problem.dim; a++) printf(", %g", r->command.at.value[a]);
    printf(" m, %g s\n", r->command.time.value[0]);
    if (f->exact.no_value) {
        printf("  no value: a corner of two temperatures, %.17g K between them\n", f->exact.temperature);
        return;
    }
    printf("  %-12s %.17g K, within %.1e K\n", "temperature", f->exact.temperature, f->exact.error_bound);
    if (isfinite(f->second.error_bound))
        printf("  %-12s %.17g K, within %.1e K\n", "second form", f->second.temperature, f->second.error_bound);
    else
        printf("  %-12s -, since at this time it would take too many terms\n", "second form");
    if (r->command.experiment.scene->published && !isfinite(f->published))
        printf("  %-12s -, since as printed it overflows\n", "as published");
    else if (r->command.experiment.scene->published)
        printf("  %-12s %.17g K, %+.1e K away\n", "as published", f->published, f->published - f->exact.temperature);
}

static int print_forms(const struct reference_options *r, struct failure *why) {
    const struct scene *s = r->command.experiment.scene;
    const struct problem *p = &r->command.experiment.problem;
    const struct mapping *m = &r->command.experiment.program.map;
    double t = r->command.time.value[0], x[DIM_MAX];
    mapping_to_scene(m, p->dim, r->command.at.value, x);
    struct forms f = {scene_exact(s, p, x, t), s->second(p, x, t), s->published ? s->published(p, x, t) : 0};
    for (struct exact *e = &f.exact;; e = &f.second) {
        e->error_bound = mapping_bound(m, e->temperature, e->error_bound);
        e->temperature = mapping_temperature(m, e->temperature);
        if (e == &f.second) break;
    }
    f.published = mapping_temperature(m, f.published);
    print_text(r, &f);
    return r->json_path ? write_json(r, &f, why) : STATUS_OK;
}

/* *p: the case's. */
static int read_points(const struct reference_options *r, const struct problem *p, struct points *points,
                       struct failure *why) {
    if (!r->points) return points_one(p, r->command.at.value, points, why);
    if (strcmp(r->points, "-") == 0) return points_read(stdin, "standard input", p, points, why);
    FILE *in = whole_file_open(r->points);
    if (!in) return refuse(why, STATUS_INPUT, "--points %.200s: %s", r->points, whole_file_error());
    int status = points_read(in, r->points, p, points, why);
    fclose(in);
    return status;
}

/* The times of --time, to be freed. */
static double *list_times(const struct command *r, int *count) {
    *count = r->times ? r->times : r->time.count;
    double *time = xcalloc((size_t)*count + 1, sizeof *time);
    if (r->times)
        answer_times(r->time.value[0], r->time.value[1], r->times, time);
    else
        memcpy(time, r->time.value, (size_t)*count * sizeof *time);
    return time;
}

static int check(const struct reference_options *r, struct failure *why) {
    const struct command *c = &r->command;
    if (!r->points == !c->at.count)
        return refuse(why, STATUS_INPUT,
                      "reference needs either --at X[,Y[,Z]] or --points FILE (- for standard input)");
    if (!r->what && c->time.count == 0)
        return refuse(why, STATUS_INPUT, "reference needs --time T[,T...]: when, s; or --what names columns without");
    if (output_check(r->json_path, why)) return why->status;
    if (!r->json_path || !(r->points || r->what || c->time.count > 1)) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--json has the temperature at one point and time (--at, --time); %s is CSV",
                  r->points ? "--points"
                  : r->what ? "--what"
                            : "--time T,T,...");
}

static int act(const void *options, struct failure *why) {
    const struct reference_options *r = options;
    const struct command *c = &r->command;
    struct image image;
    struct answer a = {.scene = c->experiment.scene, .image = &image, .cell = r->cell};
    if (check(r, why)) return why->status;
    mapping_image(&c->experiment.program.map, &c->experiment.problem, &image);
    if (columns_parse(r->what ? r->what : "temperature", image.problem.dim, &a.columns, why)) return why->status;
    for (int i = 0; i < a.columns.count; i++)
        if (a.columns.kind[i]->renamed)
            fprintf(stderr, "heatladder: --what %s is now called %s; the old word ends with 5.0\n",
                    a.columns.kind[i]->name, a.columns.kind[i]->renamed);
    if (read_points(r, &image.problem, &a.points, why)) return why->status;
    double *time = list_times(c, &a.times);
    a.time = time;
    int status = answer_check(&a, why);
    if (!status && (r->points || r->what || c->time.count > 1))
        answer_write(&a, stdout);
    else if (!status)
        status = print_forms(r, why);
    free(time);
    points_free(&a.points);
    return status;
}

const struct verb verb_reference = {
    &command_syntaxes[COMMAND_REFERENCE], own, sizeof(struct reference_options),
    "evaluate a scene at your points: exact solution, initial data, source, coefficients, walls", act};
