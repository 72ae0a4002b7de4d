/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder verify: all gates, or the battery on another program. */
#include "solver/words.h"
#include "verification/cli/verb.h"
#include "verification/solve/program.h"

#include "verification/text/output.h"
#include "verification/cli/battery_options.h"
#include "verification/gates/gate_file.h"
#include "verification/gates/gates.h"
#include "verification/text/json.h"
#include "verification/text/shell.h"
#include "verification/case/results.h"
#include "verification/report/page.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ORIGIN = 1100 };

struct verify_options {
    struct command command;
    struct battery_options battery;
    char *only, *skip;      /* owned: globs of gates; NULL: all, none */
    const char *gates_path; /* file of rows; NULL: the built-in ones */
    double time_order;      /* order of the code in time; 0: any of 0.9 or more */
    int jobs;               /* cases of a program at a time; 0: 1 */
    int quick, verbose;
    const char *json_path, *csv_path, *junit_path, *page_path; /* NULL for none */
};

static void rungs_json(const struct rungs *l, struct json *j) {
    json_add(j, "axis %s|norm %s", l->axis, l->norm);
    json_numbers(j, "rungs", l->x, l->n);
    json_numbers(j, "errors", l->error, l->n);
    json_array(j, "counted"); /* for the slope: 1 or 0 */
    for (int i = 0; i < l->n; i++) json_whole(j, NULL, l->counts[i]);
    json_end(j);
}

static void gate_json(const struct gate_result *r, struct json *j) {
    const struct gate *g = &r->gate;
    const struct measured *m = &r->measured;
    int at_most = g->lo == 0; /* a bound from above; else a band */
    /* An error that is measured itself has its bound as ceiling. */
    double ceiling = isnan(g->ceiling) && strcmp(g->measure, "error") == 0 ? g->hi : g->ceiling;
    json_object(j, NULL);
    json_add(j, "id %s|measure %s|command %s", g->id, g->measure, r->typed);
    json_number(j, "expected", at_most ? 0 : (g->lo + g->hi) / 2);
    json_number(j, "tolerance", at_most ? g->hi : (g->hi - g->lo) / 2);
    json_number(j, "measured", m->value);
    json_numbers(j, "interval95", m->ci, 2);
    json_add(j, "error %g|ceiling %g|verdict %s|reason %s", m->error, ceiling, verdict_words[m->verdict], m->reason);
    json_text(j, "diagnosis", *m->diagnosis ? m->diagnosis : NULL);
    json_text(j, "why", g->why);
    if (m->rungs.n) rungs_json(&m->rungs, j);
    json_number(j, "seconds", r->seconds);
    json_end(j);
}

/* row: of a table (json.h), 0 for JSON */
static int write_verdicts(const struct gates *g, const char *path, int row, struct failure *why) {
    struct output page;
    struct json j = json_table(output_open(&page, "%s", path), row);
    char made[PAGE_ORIGIN];
    page_origin(made, sizeof made);
    json_text(&j, "made", made);
    json_whole(&j, "declared", g->interrupted ? g->planned : g->declared);
    json_whole(&j, "executed", g->executed - gates_tally(g, NULL).skipped);
    if (g->interrupted) json_whole(&j, "interrupted", g->interrupted);
    json_text(&j, "diagnosis", *g->diagnosis ? g->diagnosis : NULL);
    json_array(&j, "gates");
    for (int i = 0; i < g->declared; i++) gate_json(&g->result[i], &j);
    json_end(&j);
    json_end(&j);
    return output_close(&page, 1, why);
}

/* The rows: of a file, of the battery where another program answers, or the built-in ones. */
static int collect(const struct verify_options *r, struct gate_file *file, struct gates *g, char origin[],
                   struct failure *why) {
    const struct program *program = &r->command.experiment.program;
    if (program->solver && strlen(program->solver) > GATES_SOLVER)
        return refuse(why, STATUS_INPUT, "--solver: more than %d letters; put them into a script", GATES_SOLVER);
    if (program_check(program, why)) return why->status;
    if (program->results && results_directory_check(program->results, why)) return why->status;
    if (!r->command.external && !r->gates_path) return gates_collect(r->only, r->skip, r->quick, g, why);
    if (r->command.external) g->program = program;
    if (r->gates_path && gate_file_open(r->gates_path, file, why)) return why->status;
    for (int i = 0; i < file->count; i++) gates_add(g, &file->gate[i]);
    int order = battery_order(&r->battery);
    unsigned long seed = battery_seed(&r->command, &r->battery);
    if (!r->gates_path && battery_add(order, r->battery.profile, seed, g, why)) return why->status;
    g->origin = origin;
    snprintf(origin, ORIGIN, "--order %d --seed %lu", order, seed);
    if (r->gates_path) {
        char *words = shell_line(2, (const char *const[]){"--gates", r->gates_path});
        snprintf(origin, ORIGIN, "%s", words);
        free(words);
    }
    battery_words(r->battery.profile, r->battery.rungs, origin, ORIGIN);
    if (r->time_order > 0) words_add(origin, ORIGIN, " --time-order %g", r->time_order);
    if (gates_choose(g, r->only, r->skip, r->quick, why)) return why->status;
    if (!r->gates_path && battery_bounds(g, why)) return why->status;
    gates_refine(g, r->battery.rungs, r->time_order);
    return STATUS_OK;
}

static int write_page(const struct gates *g, const struct verify_options *r, struct failure *why) {
    const char *title = g->interrupted ? "heatladder verify (interrupted)" : "heatladder verify";
    return page_gates_write(g, title, r->command.typed, r->page_path, why);
}

/* The verdicts, on standard output and in the files asked for. */
static int write_all(const struct gates *g, const struct verify_options *r, double seconds, struct failure *why) {
    print_gates(g, r->verbose, seconds);
    fflush(stdout);
    if (getenv("GITHUB_ACTIONS")) print_annotations(g);
    if (r->json_path && write_verdicts(g, r->json_path, 0, why)) return why->status;
    if (r->csv_path && write_verdicts(g, r->csv_path, 3, why)) return why->status;
    if (r->junit_path && junit_write(g, r->junit_path, why)) return why->status;
    if (r->page_path && write_page(g, r, why)) return why->status;
    return STATUS_OK;
}

static void announce(const struct verify_options *r, struct gates *g) {
    int runs = gates_runs(g), jobs = r->jobs ? r->jobs : 1;
    char side[40] = "one after the other";
    if (jobs > 1) snprintf(side, sizeof side, "%d at a time", jobs);
    if (runs == 1)
        fprintf(stderr, "heatladder: the program runs once\n");
    else
        fprintf(stderr, "heatladder: up to %d runs of the program, %s, and more for each row that fails\n", runs,
                side);
}

static int run_gates(const struct verify_options *r, struct gates *g, struct failure *why) {
    if (!g->program || !g->program->solver) return gates_run(g), STATUS_OK;
    announce(r, g);
    g->verbose = r->verbose;
    return gates_run_program(g, r->jobs ? r->jobs : 1, why);
}

/* The page has a file beside it. */
static int check_places(const struct verify_options *r, struct failure *why) {
    char data[1024] = "";
    if (r->page_path) page_data_path(r->page_path, data, sizeof data);
    if (r->csv_path && strcmp(r->csv_path, data) == 0)
        return refuse(why, STATUS_INPUT, "--csv %.200s is the file of the ladders of --page; choose another name",
                      data);
    if (output_check(r->json_path, why) || output_check(r->junit_path, why)) return why->status;
    if (output_check(r->csv_path, why)) return why->status;
    return output_check(r->page_path, why);
}

static int verify(const struct verify_options *r, struct gate_file *file, struct gates *g, struct failure *why) {
    char origin[ORIGIN];
    if (check_places(r, why)) return why->status;
    if (collect(r, file, g, origin, why)) return why->status;
    double start = omp_get_wtime();
    int status = output_noted() ? STATUS_OK : run_gates(r, g, why);
    if (output_noted()) {
        gates_cut(g, output_noted());
        fprintf(stderr, "heatladder: interrupted: %d of %d %s judged\n", g->executed, g->planned,
                gates_noun(g, g->planned));
    }
    gates_diagnose(g);
    return status ? status : write_all(g, r, omp_get_wtime() - start, why);
}

static int act(const void *options, struct failure *why) {
    const struct verify_options *r = options;
    struct gates gates = {0};
    struct gate_file file = {0};
    output_hold(); /* an interrupt ends the program once the verdicts so far are written */
    int status = verify(r, &file, &gates, why);
    output_release();
    if (!status) status = gates_status(&gates);
    gates_free(&gates);
    gate_file_free(&file);
    return status;
}

#define PLACE(member) OPTION_PLACE(verify_options, member)
static const struct option own[] = {
    {"time-order", "P", "order of your code in time; its band is P - 0.2 to P + 0.5, by default 0.9 and more",
     option_number, PLACE(time_order), 0.5, 6, .needs = "solver results gates"},
    {"seeds", "N", "run each rung N times, with seed = 1 to N in its case, and pool the errors", option_whole,
     PLACE(command.experiment.program.seeds), 2, SEEDS_MAX, .needs = "solver results"},
    {"jobs", "N", "cases of --solver to run at a time, default 1; with more, seconds are not comparable",
     option_whole, PLACE(jobs), 1, 1024, .needs = "solver"},
    {"", .about = "Rows:"},
    {"quick", NULL,
     "only quick gates; with --solver or --results: only rows of rods, scenes rod-... and wall-...; "
     "with --gates: only its rows QUICK",
     option_flag, PLACE(quick)},
    {"only", "GLOB[,GLOB...]", "only names that match, such as '*gauss*'; may be repeated", option_globs, PLACE(only),
     .repeats = 1},
    {"skip", "GLOB[,GLOB...]", "leave out names that match; may be repeated", option_globs, PLACE(skip),
     .repeats = 1},
    BATTERY_OPTIONS(verify_options),
    {"gates", "FILE",
     "judge the rows of FILE in place of the built-in gates: "
     "GATE(\"id\", QUICK, \"measure\", \"command\", lo, hi, ceiling, \"why\")",
     option_text, PLACE(gates_path)},
    {"", .about = "Output:"},
    {"verbose", NULL, "list every gate with its details, name each skipped row, diagnose every ladder; also -v",
     option_flag, PLACE(verbose)},
    {"page", "FILE", "write the verdict and its table as an HTML page; beside it the ladders as CSV", option_text,
     PLACE(page_path)},
    {"junit", "FILE", "write the verdicts as JUnit XML", option_text, PLACE(junit_path)},
    CSV_OPTION(PLACE(csv_path), "the verdicts"),
    JSON_OPTION(PLACE(json_path), "the verdicts"),
    {0}};

static const struct command_syntax syntax = {"verify", "", "", "solver results keep timeout columns", NULL};

const struct verb verb_verify = {&syntax, own, sizeof(struct verify_options),
                                 "run every gate; with --solver or --results: run the battery on your program", act};
