/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages of a run of gates and of one ladder. */
#include "verification/report/page.h"

#include "solver/status.h"
#include "version.inc"
#include "verification/fault/wording.h"
#include "verification/solve/program.h"
#include "verification/judge/ladder.h"
#include "verification/report/picture.h"
#include "verification/text/html.h"
#include "verification/text/output.h"
#include "verification/text/table.h"

#include <math.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>

void page_origin(char *text, size_t size) {
    struct utsname machine;
    char when[64] = "", where[256] = "an unknown machine";
    time_t now = time(NULL);
    struct tm parts;
    if (gmtime_r(&now, &parts)) strftime(when, sizeof when, "%Y-%m-%d %H:%M UTC", &parts);
    if (uname(&machine) == 0)
        snprintf(where, sizeof where, "%.60s %.60s, %.60s", machine.sysname, machine.release, machine.machine);
    snprintf(text, size, "%s on %s by heatladder %s", when, where, VERSION_TEXT);
}

static void put_end(const char *command, FILE *out) {
    char made[PAGE_ORIGIN];
    page_origin(made, sizeof made);
    html_print(out, "<p class=\"faint\">Made %s with</p>\n", made);
    html_command(out, command);
    html_close(out);
}

static void put_diagnosis(const char *text, const char *class, FILE *out) {
    if (*text) html_print(out, "<p class=\"%s\">Diagnosis: %s.</p>\n", class, text);
}

static void put_rungs(const struct rungs *l, FILE *out) {
    struct table t = table_create(3, 0);
    if (l->n == 0) return;
    table_add(&t, "%s|%s|for the slope", l->axis, l->norm);
    for (int i = 0; i < l->n; i++) {
        table_add(&t, "%.6g", l->x[i]);
        table_number(&t, "%.4e", l->error[i], "-");
        table_add(&t, l->counts[i] ? "counts" : "left out");
    }
    html_table(out, &t);
}

static void put_failure(const struct gate_result *r, FILE *out) {
    html_print(out, "<h4>%s: ", r->gate.id);
    html_verdict(out, verdict_words[r->measured.verdict]);
    html_print(out, "</h4>\n<p>%s</p>\n", r->measured.reason);
    put_diagnosis(r->measured.diagnosis, "", out);
    html_print(out, "<p class=\"faint\">Why: %s</p>\n", r->gate.why);
    html_command(out, r->typed);
    fprintf(out, "<div class=\"panels\">\n");
    picture_ladder(out, &r->measured.rungs, &r->gate);
    if (r->measured.field.n) picture_field(out, &r->measured);
    fprintf(out, "</div>\n");
    if (r->measured.due_scale > 0)
        fprintf(out, "<p class=\"faint\">With more digits the difference would scatter over %.1g K either way.</p>\n",
                r->measured.due_scale);
    put_rungs(&r->measured.rungs, out);
}

/* The word of gates_status: without a judged gate nothing is known. */
static const char *tally_word(struct gates_tally t) {
    return t.failed ? "fail" : t.passed < t.judged || t.judged == 0 ? "inconclusive" : "pass";
}

/* A verdict that is not a pass stands out: the one tick of the page is that of all. */
static void put_other(const char *word, FILE *out) {
    if (strcmp(word, "pass") != 0) html_verdict(out, word);
}

static void put_groups(const struct gates *g, FILE *out) {
    fprintf(out, "<details><summary>By group</summary>\n<ul class=\"groups\">\n");
    for (int i = 0; i < g->declared; i++) {
        const char *id = g->result[i].gate.id;
        if (!gates_begins_group(g, i)) continue;
        struct gates_tally t = gates_tally(g, id);
        fprintf(out, "<li>");
        html_bytes(out, id, gates_group_length(id));
        if (t.judged) fprintf(out, " %d/%d ", t.passed, t.judged);
        put_other(t.judged ? tally_word(t) : "skipped", out);
        fprintf(out, "\n");
    }
    fprintf(out, "</ul></details>\n");
}

static void put_gate(const struct gate_result *r, FILE *out) {
    const struct gate *gate = &r->gate;
    char band[80], value[40] = "-", error[80] = "";
    if (gate->lo == 0)
        snprintf(band, sizeof band, "at most %.4g", gate->hi);
    else
        snprintf(band, sizeof band, "%.4g to %.4g", gate->lo, gate->hi);
    if (!isnan(r->measured.value)) snprintf(value, sizeof value, "%.4g", r->measured.value);
    if (!isnan(gate->ceiling) && isnan(r->measured.error))
        snprintf(error, sizeof error, "-, at most %.3g", gate->ceiling);
    else if (!isnan(gate->ceiling))
        snprintf(error, sizeof error, "%.3g, at most %.3g", r->measured.error, gate->ceiling);
    html_print(out, "<tr><td>%s</td><td>", gate->id);
    put_other(verdict_words[r->measured.verdict], out);
    fprintf(out, "</td>");
    html_cell(out, band);
    html_cell(out, value);
    html_cell(out, error);
    html_print(out, "<td>%s</td></tr>\n", gates_holds(r) ? gate->why : r->measured.reason);
}

static void put_verdict(const struct gates *g, FILE *out) {
    struct gates_tally t = gates_tally(g, NULL);
    const char *word = g->interrupted && !t.failed ? "inconclusive" : tally_word(t);
    fprintf(out, "<p class=\"verdict\">");
    html_verdict(out, word);
    if (g->interrupted)
        fprintf(out, ": interrupted: %d of %d gates were judged, %d hold", t.judged, g->planned, t.passed);
    else
        fprintf(out, ": %d of %d gates hold", t.passed, t.judged);
    if (t.skipped) fprintf(out, ", %d skipped", t.skipped);
    fprintf(out, "</p>\n");
    put_diagnosis(g->diagnosis, "verdict", out);
}

static void put_program(const struct program *p, FILE *out) {
    if (!p) return;
    if (p->solver)
        html_print(out, "<p>The program <code>%s</code>", p->solver);
    else
        html_print(out, "<p>The program that wrote the results in <code>%s</code>", p->results);
    fprintf(out,
            " ran on successively finer grids against exact solutions.  Each gate judges an order of convergence "
            "or the size of an error.</p>\n");
}

void page_data_path(const char *path, char *data, size_t size) {
    const char *ending = strrchr(path, '.');
    int length = ending && strcmp(ending, ".html") == 0 ? (int)(ending - path) : (int)strlen(path);
    snprintf(data, size, "%.*s.csv", length, path);
}

int page_gates_write(const struct gates *g, const char *title, const char *command, const char *path,
                     struct failure *why) {
    struct output page[2];
    char data[sizeof page->path];
    page_data_path(path, data, sizeof data);
    FILE *out = output_open(&page[0], "%s", path);
    html_open(out, title);
    put_program(g->program, out);
    put_verdict(g, out);
    for (int i = 0; i < g->declared; i++)
        if (gates_fails(&g->result[i])) put_failure(&g->result[i], out);
    put_groups(g, out);
    fprintf(out, "<details><summary>Every gate</summary>\n<div class=\"scroll\"><table>\n<tr><th>gate</th>"
                 "<th>verdict</th><th>expected</th><th>measured</th><th>error</th><th>why</th></tr>\n");
    for (int i = 0; i < g->declared; i++) put_gate(&g->result[i], out);
    fprintf(out, "</table></div></details>\n");
    put_end(command, out);
    page_data_write(g, command, output_open(&page[1], "%s", data));
    int alone = strcmp(path, "-") == 0; /* standard output takes one file */
    if (alone) output_drop(&page[1], 1);
    return output_close(page, alone ? 1 : 2, why);
}

int page_ladder_write(const struct ladder *l, const struct diagnosis *d, const char *command, const char *path,
                      struct failure *why) {
    struct output page;
    char title[240], slope[240];
    FILE *out = output_open(&page, "%s", path);
    result_describe(&l->rung[l->n - 1], title, sizeof title);
    ladder_slope_text(l, slope, sizeof slope);
    html_open(out, title);
    fprintf(out, "<p class=\"verdict\">");
    html_verdict(out, verdict_words[l->verdict]);
    html_print(out, ": %s</p>\n<p>%s.</p>\n", l->reason, slope);
    if (l->open) {
        wording_text(d, slope, sizeof slope);
        put_diagnosis(slope, "", out);
    }
    struct table rungs = ladder_table(l, 0);
    html_table(out, &rungs);
    put_end(command, out);
    return output_close(&page, 1, why);
}
