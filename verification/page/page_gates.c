/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gates on a page. */
#include "verification/page/page.h"

#include "verification/diagnosis/wording.h"
#include "verification/page/chart.h"
#include "verification/page/html.h"
#include "verification/text/table.h"
#include "verification/text/words.h"

#include <math.h>
#include <string.h>

static void put_band(const struct gate_result *r, FILE *out) {
    char text[160];
    if (r->gate.lo == 0)
        snprintf(text, sizeof text, "at most %.4g", r->gate.hi);
    else
        snprintf(text, sizeof text, "%.4g to %.4g", r->gate.lo, r->gate.hi);
    html_cell(out, text);
    snprintf(text, sizeof text, "%.4g", r->measured.value);
    html_cell(out, isnan(r->measured.value) ? "-" : text);
    text[0] = '\0';
    if (!isnan(r->gate.ceiling) && isnan(r->measured.error))
        snprintf(text, sizeof text, "-, at most %.3g", r->gate.ceiling);
    else if (!isnan(r->gate.ceiling))
        snprintf(text, sizeof text, "%.3g, at most %.3g", r->measured.error, r->gate.ceiling);
    html_cell(out, text);
}

static void put_gate(const struct gate_result *r, FILE *out) {
    fprintf(out, "<tr>");
    html_cell(out, r->gate.id);
    fprintf(out, "<td>");
    html_verdict(out, verdict_words[r->measured.verdict]);
    fprintf(out, "</td>");
    put_band(r, out);
    html_print(out, "<td>%s</td></tr>\n", gates_holds(r) ? r->gate.why : r->measured.reason);
}

static void put_header(FILE *out) {
    fprintf(out, "<div class=\"scroll\"><table>\n<tr><th>gate</th><th>verdict</th><th>expected</th>"
                 "<th class=\"n\">measured</th><th>error</th><th>why</th></tr>\n");
}

void page_put_scene(const struct gates *g, const char *scene, FILE *out) {
    int n = 0, good = 0;
    for (int i = 0; i < g->declared; i++)
        if (words_among(g->result[i].typed, scene))
            n += gates_holds(&g->result[i]) || gates_fails(&g->result[i]), good += gates_holds(&g->result[i]);
    if (n == 0) return;
    fprintf(out, "<details><summary>%d of %d gates hold</summary>\n", good, n);
    put_header(out);
    for (int i = 0; i < g->declared; i++)
        if (words_among(g->result[i].typed, scene)) put_gate(&g->result[i], out);
    fprintf(out, "</table></div></details>\n");
}

static void put_rungs(const struct rungs *l, FILE *out) {
    struct table t = table_create(3, 0);
    table_add(&t, "%s|%s|for the slope", l->axis, l->norm);
    for (int i = 0; i < l->n; i++) {
        table_add(&t, "%.6g", l->x[i]);
        table_number(&t, "%.4e", l->error[i], "-");
        table_add(&t, l->counts[i] ? "counts" : "left out");
    }
    html_table(out, &t, 1);
}

double page_order(double lo, double hi) {
    double middle = (lo + hi) / 2, whole = round(middle);
    return lo <= whole && whole <= hi ? whole : middle;
}

void page_put_ladder(const struct gate_result *r, FILE *out) {
    const struct rungs *l = &r->measured.rungs;
    char name[80];
    if (l->n == 0) return;
    snprintf(name, sizeof name, "%s (hollow: left out of the fit)", l->norm);
    const struct chart_series series = {name, l->n, l->x, l->error, l->counts};
    fprintf(out, "<figure>\n");
    chart_write(&(struct chart){r->gate.id, l->axis, l->norm, 1, &series, page_order(r->gate.lo, r->gate.hi)}, out);
    fprintf(out, "</figure>\n");
    put_rungs(l, out);
}

void page_put_ladders(const struct gates *g, FILE *out) {
    for (int i = 0; i < g->declared; i++) {
        const struct gate_result *r = &g->result[i];
        if (!gates_holds(r) || r->measured.rungs.n == 0) continue;
        char order[80];
        snprintf(order, sizeof order, "order %.3g, expected %.3g to %.3g", r->measured.value, r->gate.lo, r->gate.hi);
        html_print(out, "<details><summary>%s: %s</summary>\n", r->gate.id, order);
        page_put_ladder(r, out);
        fprintf(out, "</details>\n");
    }
}

static void put_failure(const struct gate_result *r, FILE *out) {
    html_print(out, "<h4>%s: ", r->gate.id);
    html_verdict(out, verdict_words[r->measured.verdict]);
    html_print(out, "</h4>\n<p>%s</p>\n", r->measured.reason);
    if (*r->measured.diagnosis) html_print(out, "<p>Diagnosis: %s.</p>\n", r->measured.diagnosis);
    html_print(out, "<p class=\"faint\">Why: %s</p>\n", r->gate.why);
    html_command(out, r->typed);
    page_put_ladder(r, out);
}

/* As gates_status: where nothing was judged, nothing is known. */
static const char *tally_word(struct gates_tally t) {
    return t.failed ? "fail" : t.passed < t.judged || t.judged == 0 ? "inconclusive" : "pass";
}

static void put_groups(const struct gates *g, FILE *out) {
    fprintf(out, "<ul class=\"groups\">\n");
    for (int i = 0; i < g->declared; i++) {
        const char *id = g->result[i].gate.id;
        if (!gates_begins_group(g, i)) continue;
        struct gates_tally t = gates_tally(g, id);
        char group[240];
        snprintf(group, sizeof group, "%.*s", (int)gates_group_length(id), id);
        html_print(out, "<li>%s ", group);
        if (t.judged) fprintf(out, "%d/%d ", t.passed, t.judged);
        html_verdict(out, t.judged ? tally_word(t) : "skipped");
        fprintf(out, "\n");
    }
    fprintf(out, "</ul>\n");
}

void page_put_gates(const struct gates *g, const char *made, FILE *out) {
    struct gates_tally t = gates_tally(g, NULL);
    char diagnosis[WORDING_ALL];
    fprintf(out, "<p class=\"verdict\">");
    html_verdict(out, tally_word(t));
    fprintf(out, ": %d of %d gates hold", t.passed, t.judged);
    if (t.skipped) fprintf(out, ", %d skipped", t.skipped);
    fprintf(out, "</p>\n");
    gates_diagnosis(g, diagnosis, sizeof diagnosis);
    if (*diagnosis) html_print(out, "<p class=\"verdict\">Diagnosis: %s.</p>\n", diagnosis);
    html_print(out, "<p class=\"faint\">The gates were run %s.</p>\n", made);
    for (int i = 0; i < g->declared; i++)
        if (gates_fails(&g->result[i])) put_failure(&g->result[i], out);
    put_groups(g, out);
    fprintf(out, "<details><summary>Every gate</summary>\n");
    put_header(out);
    for (int i = 0; i < g->declared; i++) put_gate(&g->result[i], out);
    fprintf(out, "</table></div></details>\n");
}
