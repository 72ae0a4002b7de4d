/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gates on a page. */
#include "verification/page/page.h"

#include "solver/status.h"
#include "verification/diagnosis/wording.h"
#include "verification/page/chart.h"
#include "verification/page/html.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

size_t page_group_length(const char *id) {
    return strcspn(id, "/");
}

int page_same_group(const char *a, const char *b) {
    size_t n = page_group_length(a);
    return n == page_group_length(b) && strncmp(a, b, n) == 0;
}

static int passed(const struct page_gate *g) {
    return strcmp(g->verdict, "pass") == 0;
}

/* What a program says is not for it is no failure, and counts nowhere. */
static int skipped(const struct page_gate *g) {
    return strcmp(g->verdict, "skipped") == 0;
}

static void put_band(const struct page_gate *g, FILE *out) {
    char text[160];
    if (g->lo == 0)
        snprintf(text, sizeof text, "at most %.4g", g->hi);
    else
        snprintf(text, sizeof text, "%.4g to %.4g", g->lo, g->hi);
    html_cell(out, "td", text);
    snprintf(text, sizeof text, "%.4g", g->value);
    html_cell(out, "td", text);
    text[0] = '\0';
    if (!isnan(g->ceiling)) snprintf(text, sizeof text, "%.3g, at most %.3g", g->error, g->ceiling);
    html_cell(out, "td", text);
}

static void put_gate(const struct page_gate *g, FILE *out) {
    fprintf(out, "<tr>");
    html_cell(out, "td", g->id);
    fprintf(out, "<td>");
    html_verdict(out, g->verdict);
    fprintf(out, "</td>");
    put_band(g, out);
    html_print(out, "<td>%s</td></tr>\n", passed(g) ? g->why : g->reason);
}

static void put_header(FILE *out) {
    fprintf(out, "<div class=\"scroll\"><table>\n<tr><th>gate</th><th>verdict</th><th>expected</th>"
                 "<th class=\"n\">measured</th><th>error</th><th>why</th></tr>\n");
}

/* Whether the scene is a word of the gate's command. */
static int is_about(const struct page_gate *g, const char *scene) {
    size_t length = strlen(scene);
    const char *at = g->command;
    while ((at = strstr(at, scene)) &&
           !(at > g->command && at[-1] == ' ' && (at[length] == ' ' || at[length] == '\0')))
        at += length;
    return at != NULL;
}

void page_put_scene(const struct page_gate *gate, int count, const char *scene, FILE *out) {
    int n = 0, good = 0;
    for (int i = 0; i < count; i++)
        if (is_about(&gate[i], scene)) n += !skipped(&gate[i]), good += passed(&gate[i]);
    if (n == 0) return;
    fprintf(out, "<details><summary>%d of %d gates hold</summary>\n", good, n);
    put_header(out);
    for (int i = 0; i < count; i++)
        if (is_about(&gate[i], scene)) put_gate(&gate[i], out);
    fprintf(out, "</table></div></details>\n");
}

static void put_rungs(const struct rungs *l, FILE *out) {
    html_print(out,
               "<div class=\"scroll\"><table class=\"narrow\">\n<tr><th class=\"n\">%s</th><th class=\"n\">%s</th>"
               "<th>for the slope</th></tr>\n",
               l->axis, l->norm);
    for (int i = 0; i < l->n; i++) {
        char x[40], error[40];
        snprintf(x, sizeof x, "%.6g", l->x[i]);
        snprintf(error, sizeof error, "%.4e", l->error[i]);
        fprintf(out, "<tr>");
        html_cell(out, "td", x);
        html_cell(out, "td", isfinite(l->error[i]) ? error : "-");
        html_cell(out, "td", l->counts[i] ? "counts" : "left out");
        fprintf(out, "</tr>\n");
    }
    fprintf(out, "</table></div>\n");
}

double page_order(double lo, double hi) {
    double middle = (lo + hi) / 2, whole = round(middle);
    return lo <= whole && whole <= hi ? whole : middle;
}

void page_put_ladder(const struct page_gate *g, FILE *out) {
    const struct rungs *l = &g->rungs;
    int hollow[NUMBERS_MAX];
    char name[80];
    if (l->n == 0) return;
    for (int i = 0; i < l->n; i++) hollow[i] = !l->counts[i];
    snprintf(name, sizeof name, "%s (hollow: left out of the fit)", l->norm);
    const struct chart_series series = {name, l->n, l->x, l->error, hollow};
    fprintf(out, "<figure>\n");
    chart_write(&(struct chart){g->id, l->axis, l->norm, 1, &series, page_order(g->lo, g->hi)}, out);
    fprintf(out, "</figure>\n");
    put_rungs(l, out);
}

void page_put_ladders(const struct page_gate *gate, int count, FILE *out) {
    for (int i = 0; i < count; i++) {
        if (!passed(&gate[i]) || gate[i].rungs.n == 0) continue;
        char order[80];
        snprintf(order, sizeof order, "order %.3g, expected %.3g to %.3g", gate[i].value, gate[i].lo, gate[i].hi);
        html_print(out, "<details><summary>%s: %s</summary>\n", gate[i].id, order);
        page_put_ladder(&gate[i], out);
        fprintf(out, "</details>\n");
    }
}

static void put_failure(const struct page_gate *g, FILE *out) {
    html_print(out, "<h4>%s: ", g->id);
    html_verdict(out, g->verdict);
    html_print(out, "</h4>\n<p>%s</p>\n", g->reason);
    if (*g->diagnosis) html_print(out, "<p>Diagnosis: %s.</p>\n", g->diagnosis);
    html_print(out, "<p class=\"faint\">Expected because: %s</p>\n<pre><code>heatladder %s</code></pre>\n", g->why,
               g->command);
    page_put_ladder(g, out);
}

/* Gates of one group, or all. */
struct tally {
    int held, judged, failed;
};

static struct tally tally_of(const struct page_gate *gate, int count, const char *group) {
    struct tally t = {0};
    for (int i = 0; i < count; i++) {
        if (skipped(&gate[i]) || (group && !page_same_group(gate[i].id, group))) continue;
        t.judged++;
        t.held += passed(&gate[i]);
        t.failed += !passed(&gate[i]) && strcmp(gate[i].verdict, "inconclusive") != 0;
    }
    return t;
}

/* As gates_status: where nothing was judged, nothing is known. */
static const char *tally_word(struct tally t) {
    return t.failed ? "fail" : t.held < t.judged || t.judged == 0 ? "inconclusive" : "pass";
}

static void put_groups(const struct page_gate *gate, int count, FILE *out) {
    fprintf(out, "<ul class=\"groups\">\n");
    for (int i = 0; i < count; i++) {
        int first = 1;
        for (int k = 0; k < i && first; k++) first = !page_same_group(gate[k].id, gate[i].id);
        if (!first) continue;
        struct tally t = tally_of(gate, count, gate[i].id);
        char group[240];
        snprintf(group, sizeof group, "%.*s", (int)page_group_length(gate[i].id), gate[i].id);
        html_print(out, "<li>%s ", group);
        fprintf(out, "%d/%d ", t.held, t.judged);
        html_verdict(out, t.judged ? tally_word(t) : "skipped");
        fprintf(out, "\n");
    }
    fprintf(out, "</ul>\n");
}

static void put_diagnosis(const struct page_gate *gate, int count, FILE *out) {
    const char **said = xcalloc((size_t)count, sizeof *said);
    char all[WORDING_ALL];
    int n = 0;
    for (int i = 0; i < count; i++)
        if (!passed(&gate[i]) && !skipped(&gate[i])) said[n++] = gate[i].diagnosis;
    wording_all(said, n, all, sizeof all);
    if (*all) html_print(out, "<p class=\"verdict\">Diagnosis: %s.</p>\n", all);
    free(said);
}

void page_put_gates(const struct page_gate *gate, int count, const char *made, FILE *out) {
    struct tally t = tally_of(gate, count, NULL);
    fprintf(out, "<p class=\"verdict\">");
    html_verdict(out, tally_word(t));
    fprintf(out, ": %d of %d gates hold", t.held, t.judged);
    if (t.judged < count) fprintf(out, ", %d skipped", count - t.judged);
    fprintf(out, "</p>\n");
    put_diagnosis(gate, count, out);
    html_print(out, "<p class=\"faint\">The gates were run %s.</p>\n", made);
    for (int i = 0; i < count; i++)
        if (!passed(&gate[i]) && !skipped(&gate[i])) put_failure(&gate[i], out);
    put_groups(gate, count, out);
    fprintf(out, "<details><summary>Every gate</summary>\n");
    put_header(out);
    for (int i = 0; i < count; i++) put_gate(&gate[i], out);
    fprintf(out, "</table></div></details>\n");
}
