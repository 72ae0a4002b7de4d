/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder ladder: runs at decreasing dx (or dt), and the observed order of the error. */
#include "solver/words.h"
#include "verification/cli/verb.h"

#include "verification/text/json.h"
#include "references/scene.h"
#include "verification/fault/diagnose.h"
#include "verification/fault/wording.h"
#include "verification/gates/gates.h"
#include "verification/judge/gci.h"
#include "verification/judge/ladder.h"
#include "verification/report/page.h"
#include "verification/solve/memory.h"
#include "verification/text/output.h"
#include "verification/text/table.h"
#include "verification/text/verdict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct ladder_options {
    struct command command;
    const char *junit_path, *page_path; /* NULL for none, also below */
    const char *json_path, *csv_path;
};

static void print_text(const struct ladder *l, const struct problem *p, const struct diagnosis *d) {
    char what[480];
    struct table t = ladder_table(l, 1);
    const char *verdict = verdict_words[l->verdict];
    result_describe(&l->rung[l->n - 1], what, sizeof what);
    printf("%s\n", what);
    if (l->self_differences && l->fine > 0)
        printf("errors by Richardson's extrapolation from a run on the same grid at %.6g s\n", l->fine);
    else if (l->self_differences)
        printf("errors by Richardson's extrapolation from successive runs on one grid; the finest is not shown\n");
    else if (l->in_time && !l->semidiscrete_steps && !l->failure.status)
        printf("errors against the exact solution in time of the same particles' equations\n");
    if (l->semidiscrete_steps)
        printf("errors against exp(tA) by polynomials in %lld steps, %.1e from that in half as many\n",
               l->semidiscrete_steps, l->semidiscrete_error);
    if (l->rung[0].derived_name) printf("the exact quantity is %.12g\n", l->rung[0].derived_exact);
    printf("\n");
    table_end(&t, stdout);
    ladder_slope_text(l, what, sizeof what);
    printf("\n%s\n", what);
    ladder_places_text(l, p, what, sizeof what);
    if (*what) printf("%s\n", what);
    printf("%s%s%s: %s (%.2g s)\n", verdict_colour(stdout, verdict), verdict, verdict_colour_end(stdout, verdict),
           l->reason, l->seconds);
    int inside = l->asked.expect.count &&
                 verdict_within(l->slope.value, l->asked.expect.value[0], l->asked.expect.value[1]) == VERDICT_PASS;
    if (!l->open || (inside && !d->named && !l->asked.diagnose)) return;
    wording_text(d, what, sizeof what);
    printf("diagnosis: %s\n", what);
}

enum { ROW = 3 }; /* rungs or quantities are the rows of a table (json.h); 0: JSON */

static int write_ladder(const struct ladder *l, const struct diagnosis *d, const char *path, int row,
                        struct failure *why) {
    struct output page;
    struct json j = json_table(output_open(&page, "%s", path), row);
    ladder_json(l, &j);
    if (!row) diagnosis_json(d, &j);
    json_end(&j);
    return output_close(&page, 1, why);
}

/* ---- Without a scene ---- */

static const char gci_note[] = "p: observed order; GCI: grid convergence index of the finest, 1.25 |change| / (r^p - "
                               "1) (Roache 1994; ASME V&V 20).\n"
                               "No exact solution is known here: this says how far the answers agree with each "
                               "other, not that they are right.\n";

static void add_quantity(struct table *t, const struct gci *g, const struct gci_row *row) {
    char few[80], between[120];
    snprintf(few, sizeof few, "%d printed digits leave p open by %.2g", row->digits, row->unsure);
    snprintf(between, sizeof between,
             "refused: interpolation between points is off by %.2g of the change (at most %g)", row->between,
             GCI_BETWEEN);
    const char *note = row->between > GCI_BETWEEN ? between
                       : row->unsure > 0.1        ? few
                       : row->change == 0         ? "the two finest agree: no order"
                       : !isfinite(row->order)    ? "changes do not fall: no order"
                       : row->oscillates          ? "oscillates: the order means little"
                       : row->order < 0.5         ? "hardly converges"
                       : row->order > 8           ? "above any usual order: too few digits?"
                                                  : "";
    table_add(t, "%s", row->name);
    for (int i = g->n - 3; i < g->n; i++) table_number(t, "%.8g", row->value[i], "-");
    table_number(t, "%.3f", row->order, "-");
    table_number(t, "%.8g", row->extrapolated, "-");
    table_number(t, "%.3g", 100 * row->index, "-");
    table_add(t, "%s", note);
}

static void print_gci(const struct gci *g) {
    char header[160];
    snprintf(header, sizeof header, "quantity|at %.6g|at %.6g|at %.6g|p|extrapolated|GCI [%%]| ", g->h[g->n - 3],
             g->h[g->n - 2], g->h[g->n - 1]);
    struct table t = table_headed(1, header);
    for (int k = 0; k < g->rows; k++) add_quantity(&t, g, &g->row[k]);
    printf("Richardson's extrapolation from the three finest of %d spacings, %.6g, %.6g and %.6g (ratios %.4g and "
           "%.4g)\n\n",
           g->n, g->h[g->n - 3], g->h[g->n - 2], g->h[g->n - 1], g->h[g->n - 3] / g->h[g->n - 2],
           g->h[g->n - 2] / g->h[g->n - 1]);
    table_end(&t, stdout);
    printf("\n%s", gci_note);
}

static int write_gci(const struct gci *g, const char *path, int row, struct failure *why) {
    struct output page;
    struct json j = json_table(output_open(&page, "%s", path), row);
    gci_json(g, &j);
    json_end(&j);
    return output_close(&page, 1, why);
}

/* The first quantity whose order interpolation does not hide; gci_read refuses answers without one. */
static const struct gci_row *judged_quantity(const struct gci *g) {
    const struct gci_row *row = g->row;
    while (row->between > GCI_BETWEEN) row++;
    return row;
}

/* With --expect the order of one quantity is judged. */
static int without_scene(const struct ladder_options *r, struct failure *why) {
    struct gci *g = xcalloc(1, sizeof *g);
    const struct numbers *expect = &r->command.rungs.expect;
    int status = output_check(r->json_path, why);
    if (!status) status = output_check(r->csv_path, why);
    if (!status)
        status = gci_read(r->command.experiment.program.results, &r->command.experiment.program.columns,
                          &r->command.at, g, why);
    if (!status) print_gci(g);
    if (!status && r->json_path) status = write_gci(g, r->json_path, 0, why);
    if (!status && r->csv_path) status = write_gci(g, r->csv_path, ROW, why);
    if (!status && expect->count) {
        const struct gci_row *row = judged_quantity(g);
        if (verdict_within(row->order, expect->value[0], expect->value[1]) != VERDICT_PASS)
            status = refuse(why, STATUS_GATE, "the observed order of %s, %.3f, is not within %g to %g", row->name,
                            row->order, expect->value[0], expect->value[1]);
    }
    free(g);
    return status;
}

static int is_judged(const struct ladder_options *r) {
    return r->command.rungs.expect.count || r->command.rungs.ceiling > 0;
}

static void print_asked(const struct ladder_options *r, char *text, size_t size) {
    const struct numbers *e = &r->command.rungs.expect;
    *text = '\0';
    if (e->count) snprintf(text, size, "--expect %g,%g", e->value[0], e->value[1]);
    if (r->command.rungs.ceiling > 0)
        words_add(text, size, "%s--ceiling %g", *text ? " " : "", r->command.rungs.ceiling);
    if (!*text) snprintf(text, size, "all runs end");
}

/* One test case, which passes if the exit status is 0: also for a measured ladder, without --expect and --ceiling. */
static int write_junit(const struct ladder_options *r, const struct ladder *l, int status, struct failure *why) {
    char id[120], asked[160];
    struct gate_result result = {.seconds = l->seconds, .executed = 1};
    snprintf(id, sizeof id, "%s/%s", r->command.experiment.scene->name, r->command.experiment.method->name);
    print_asked(r, asked, sizeof asked);
    result.gate = (struct gate){.id = id, .why = asked, .command = id};
    snprintf(result.typed, sizeof result.typed, "%s", r->command.typed);
    result.measured = (struct measured){.value = l->slope.value, .verdict = l->verdict};
    if (!status && l->verdict == VERDICT_MEASURED) result.measured.verdict = VERDICT_PASS;
    snprintf(result.measured.reason, sizeof result.measured.reason, "%s", l->reason);
    struct gates one = {.declared = 1, .executed = 1, .result = &result};
    return junit_write(&one, r->junit_path, why);
}

/* Writes page, JUnit, JSON and CSV; a failure to write counts if nothing else failed. */
static int write_files(const struct ladder_options *r, const struct ladder *l, const struct diagnosis *d, int status,
                       struct failure *why) {
    struct failure unwritten = {0};
    if (r->page_path) page_ladder_write(l, d, r->command.typed, r->page_path, &unwritten);
    if (r->junit_path && !unwritten.status) write_junit(r, l, status, &unwritten);
    if (r->json_path && !unwritten.status) write_ladder(l, d, r->json_path, 0, &unwritten);
    if (r->csv_path && !unwritten.status) write_ladder(l, d, r->csv_path, ROW, &unwritten);
    if (status || !unwritten.status) return status;
    *why = unwritten;
    return unwritten.status;
}

/* The finest rung needs the most memory. */
static int check_finest(const struct command *c, struct failure *why) {
    struct experiment finest = c->experiment;
    for (int i = 0; i < c->rungs.dx.count; i++) finest.options.dx = fmin(finest.options.dx, c->rungs.dx.value[i]);
    return memory_check(&finest, why);
}

static int act(const void *options, struct failure *why) {
    const struct ladder_options *r = options;
    if (!r->command.experiment.scene) return without_scene(r, why);
    struct ladder *l = xcalloc(1, sizeof *l);
    struct diagnosis d;
    int status = output_check(r->page_path, why);
    if (!status) status = output_check(r->junit_path, why);
    if (!status) status = output_check(r->json_path, why);
    if (!status) status = output_check(r->csv_path, why);
    if (!status) status = check_finest(&r->command, why);
    struct experiment e = r->command.experiment;
    e.growth = 1;
    if (!status) status = ladder_run(&e, &r->command.rungs, l, why);
    diagnose_ladder(&e, l, &d);
    int has_rungs = l->n > 0 && l->rung[l->n - 1].method; /* else the ladder itself was refused */
    for (int i = 0; has_rungs && i < l->n; i++) result_warn(&l->rung[i]);
    if (!status_refused(status) || (l->external && has_rungs)) {
        print_text(l, &r->command.experiment.problem, &d);
        if (l->external) why->text[0] = '\0'; /* the table already shows it */
        status = write_files(r, l, &d, status, why);
    }
    if (!status && l->verdict == VERDICT_INCONCLUSIVE) status = STATUS_INCONCLUSIVE;
    if (!status && is_judged(r) && l->verdict == VERDICT_FAIL) status = STATUS_GATE;
    free(d.evidence);
    ladder_free(l);
    free(l);
    return status;
}

#define PLACE(member) OPTION_PLACE(ladder_options, member)
static const struct option own[] = {
    {"", .about = "Output:"},
    {"verbose", NULL, "diagnose the errors also of a ladder that passes; also -v", option_flag,
     PLACE(command.rungs.diagnose)},
    {"junit", "FILE", "write the verdict as JUnit XML", option_text, PLACE(junit_path)},
    {"page", "FILE", "write the verdict and its table as an HTML page", option_text, PLACE(page_path)},
    CSV_OPTION(PLACE(csv_path), "the rungs"),
    JSON_OPTION(PLACE(json_path), "the ladder"),
    {0}};

const struct verb verb_ladder = {&command_syntaxes[COMMAND_LADDER], own, sizeof(struct ladder_options),
                                 "solve at falling dx (or dt) and fit the order of the error", act};
