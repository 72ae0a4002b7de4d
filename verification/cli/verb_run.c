/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder run: one solution, its error and its cost. */
#include "verification/cli/verb.h"

#include "references/snapshot.h"
#include "solver/shape.h"
#include "verification/text/output.h"
#include "verification/text/json.h"
#include "verification/solve/memory.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdio.h>

struct run_options {
    struct command command;
    const char *field_path; /* NULL for none */
    int warm_up;
    const char *json_path, *csv_path; /* NULL for none */
};

#define PLACE(member) OPTION_PLACE(run_options, member)
static const struct option own[] = {
    {"", .about = "Output:"},
    {"warm-up", NULL, "solve for 0.1 s before the timed run, not counted", option_flag, PLACE(warm_up)},
    {"field", "FILE", "write points, temperature and exact temperature as CSV", option_text, PLACE(field_path)},
    CSV_OPTION(PLACE(csv_path), "the result"),
    JSON_OPTION(PLACE(json_path), "the result"),
    {0}};

/* A program may report no cost. */
static void print_cost(const struct result *r) {
    if (isnan(r->cost.seconds) && r->cost.updates == 0) return;
    printf("  %-14s", "cost");
    if (!isnan(r->cost.seconds)) printf(" %.3g s%s", r->cost.seconds, r->cost.updates > 0 ? "," : "");
    if (r->cost.updates > 0) printf(" %lld updates", r->cost.updates);
    if (r->cost.interactions > 0) printf(", %lld interactions, %zu bytes", r->cost.interactions, r->cost.bytes);
    putchar('\n');
}

/* Whether no heat crosses the walls and no source makes any. */
static int keeps_heat(const struct problem *p) {
    double lo = 0, hi = 0, x[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) x[a] = p->lo[a] + 0.3 * (p->hi[a] - p->lo[a]);
    for (int s = 0; s < 2 * p->dim; s++) {
        if (!shape_has_wall(p, s) || p->side[s] == PERIODIC) continue;
        if (p->side[s] != NEUMANN) return 0;
        problem_wall_range(p, (enum side)s, shape_foot(p, s, x).x, &lo, &hi);
    }
    return lo == 0 && hi == 0 && !p->source && !p->source_rate && !p->source_at;
}

/* unit: of --quantity */
static void print_text(const struct result *r, const struct problem *p, const char *unit) {
    char what[240];
    result_describe(r, what, sizeof what);
    printf("%s\n", what);
    printf("  %-14s %.6g m, %zu particles\n", "dx", r->options.dx, r->particles);
    if (r->steps > 0)
        printf("  %-14s %.6g s (mesh Fourier number %.4g), %lld steps of %d stage%s\n", "dt", r->dt, r->fourier,
               r->steps, r->stages, r->stages == 1 ? "" : "s");
    if (r->saving > 0)
        printf("  %-14s the fewest stable Euler steps take %.3g times the updates\n", "saving", r->saving);
    printf("  %-14s E1 %.4e   L2 %.4e   L-infinity %.4e K\n", "error", r->error[NORM_L1], r->error[NORM_L2],
           r->error[NORM_LINF]);
    if (r->derived_name)
        printf("  %-14s %.6g %s (exact: %.6g), relative error %.4e\n", r->derived_name, r->derived, unit,
               r->derived_exact, r->error[NORM_QUANTITY]);
    if (r->time_error > 0) printf("  %-14s %.2g %% of E1\n", "time error", 100 * r->time_error);
    printf("  %-14s %.6g to %.6g K, ", "temperature", r->shape.min, r->shape.max);
    if (r->shape.overshoot == 0 && r->shape.undershoot == 0)
        printf("within the range of start and walls\n");
    else
        printf("%.2e above and %.2e below the range of start and walls\n", r->shape.overshoot, r->shape.undershoot);
    if (!isnan(r->shape.checkerboard)) printf("  %-14s %.2e K\n", "checkerboard", r->shape.checkerboard);
    if (isfinite(r->heat_drift) && keeps_heat(p))
        printf("  %-14s %.2e of the heat at the start\n", "heat drift", r->heat_drift);
    print_cost(r);
    if (r->search_updates > 0)
        printf("  %-14s %lld updates of other runs, to choose the time step\n", "search", r->search_updates);
}

/* row: of a table (json.h), 0 for JSON */
static int write_result(const struct result *r, const char *path, int row, struct failure *why) {
    struct output page;
    struct json j = json_table(output_open(&page, "%s", path), row);
    result_json(r, &j);
    json_end(&j);
    return output_close(&page, 1, why);
}

/* x[,y[,z]],T,exact in m and K, one line per point. */
static int write_field(const struct run_options *r, const struct field *f, struct failure *why) {
    struct output page;
    FILE *out = output_open(&page, "%s", r->field_path);
    fprintf(out, "%.*s,T,exact\n", 2 * f->dim - 1, "x,y,z");
    struct snapshot exact = snapshot_take(r->command.experiment.scene, &r->command.experiment.problem, f->time);
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX];
        field_place(f, i, x);
        for (int a = 0; a < f->dim; a++) fprintf(out, "%.17g,", x[a]);
        fprintf(out, "%.17g,%.17g\n", f->T[i], snapshot_at(&exact, x).temperature);
    }
    snapshot_free(&exact);
    return output_close(&page, 1, why);
}

static int check(const struct run_options *r, struct failure *why) {
    const struct ladder_rungs *l = &r->command.rungs;
    if (l->dx.count > 1 || l->dt.count > 1 || l->fourier.count > 1)
        return refuse(why, STATUS_INPUT, "run takes one --%s; for several: heatladder ladder",
                      l->dx.count > 1   ? "dx"
                      : l->dt.count > 1 ? "dt"
                                        : "fourier");
    if (memory_check(&r->command.experiment, why)) return why->status;
    if (output_check(r->field_path, why)) return why->status;
    if (output_check(r->csv_path, why)) return why->status;
    return output_check(r->json_path, why);
}

static int act(const void *options, struct failure *why) {
    const struct run_options *r = options;
    struct result result;
    struct field field = {0};
    struct experiment e = r->command.experiment;
    e.growth = 1;
    int status = check(r, why);
    if (!status && r->warm_up) status = run_warm_up(&e, why);
    if (!status) {
        status = run_experiment(&e, &result, &field);
        *why = result.failure;
        if (!status) result_warn(&result);
    }
    if (!status && r->field_path) status = write_field(r, &field, why);
    if (!status) print_text(&result, &e.problem, quantity_unit(&e.quantity, &e.problem));
    if (!status && r->json_path) status = write_result(&result, r->json_path, 0, why);
    if (!status && r->csv_path) status = write_result(&result, r->csv_path, 1, why);
    field_free(&field);
    return status;
}

const struct verb verb_run = {&command_syntaxes[COMMAND_RUN], own, sizeof(struct run_options),
                              "solve once and print the error against the exact solution", act};
