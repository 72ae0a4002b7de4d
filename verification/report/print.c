/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Verdicts for a reader. */

#include "verification/report/page.h"
#include "solver/words.h"
#include "verification/case/command.h"
#include "verification/case/results.h"
#include "verification/text/table.h"
#include "verification/text/verdict.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Characters of a group's counts and groups in a line, without and with counts of skipped rows. */
enum { NARROW = 11, WIDE = 23, ACROSS = 4, ACROSS_WIDE = 2 };

static void print_all(const struct gates *g) {
    struct table t = table_headed(2, "gate|verdict|expected|measured|error|seconds|what");
    for (int i = 0; i < g->declared; i++) {
        const struct gate *gate = &g->result[i].gate;
        const struct measured *m = &g->result[i].measured;
        struct measured ignored;
        const struct measure *measure = measures_find(gate->measure, &ignored);
        table_add(&t, "%s", gate->id); /* may have a bar in it */
        table_add(&t, "%s", verdict_words[m->verdict]);
        if (gate->lo == 0)
            table_add(&t, "<= %.4g", gate->hi);
        else
            table_add(&t, "%.4g to %.4g", gate->lo, gate->hi);
        if (m->ci[0] < m->ci[1])
            table_add(&t, "%.4f (%.4f to %.4f)", m->value, m->ci[0], m->ci[1]);
        else if (isnan(m->value))
            table_add(&t, "-");
        else
            table_add(&t, "%.4g", m->value);
        if (isnan(gate->ceiling))
            table_add(&t, " ");
        else if (isnan(m->error))
            table_add(&t, "- <= %.2e", gate->ceiling);
        else
            table_add(&t, "%.2e <= %.2e", m->error, gate->ceiling);
        table_add(&t, "%.2f|%s", g->result[i].seconds, measure ? measure->about : gate->measure);
    }
    table_end(&t, stdout);
}

/* "10/11 pass, 1 skipped"; returns 1 if some rows of the group are skipped and others are not. */
static int count_group(const struct gates_tally *t, char text[WIDE + 1]) {
    int some = t->judged && t->skipped;
    snprintf(text, WIDE + 1, "skipped");
    if (t->judged) snprintf(text, WIDE + 1, "%3d/%d%s", t->passed, t->judged, t->passed == t->judged ? "" : " pass");
    if (some) words_add(text, WIDE + 1, ", %d skipped", t->skipped);
    return some;
}

static void print_groups(const struct gates *g) {
    int column = 0, wide = 0;
    char counts[WIDE + 1];
    for (int i = 0; i < g->declared; i++) {
        struct gates_tally t = gates_tally(g, g->result[i].gate.id);
        wide |= count_group(&t, counts);
    }
    for (int i = 0; i < g->declared; i++) {
        const char *id = g->result[i].gate.id;
        if (!gates_begins_group(g, i)) continue;
        struct gates_tally t = gates_tally(g, id);
        const char *word = verdict_words[t.passed == t.judged ? VERDICT_PASS : VERDICT_FAIL];
        count_group(&t, counts);
        printf("%s%-14.*s %-*s%s", verdict_colour(stdout, word), (int)gates_group_length(id), id,
               wide ? WIDE : NARROW, counts, verdict_colour_end(stdout, word));
        printf("%s", ++column % (wide ? ACROSS_WIDE : ACROSS) ? "  " : "\n");
    }
    if (column % (wide ? ACROSS_WIDE : ACROSS)) printf("\n");
}

/* The value against its band, which the reason has rounded, and where the band comes from. */
static void print_details(const struct gate_result *r) {
    const struct gate *gate = &r->gate;
    const struct measured *m = &r->measured;
    if (isfinite(m->value)) printf("  measured %.6g, expected %.6g to %.6g", m->value, gate->lo, gate->hi);
    if (isfinite(m->value) && !isnan(gate->ceiling)) printf("; error %.4e, at most %.4e", m->error, gate->ceiling);
    printf("%s  why: %s\n", isfinite(m->value) ? "\n" : "", gate->why);
}

/* The folder of the cases, answers and logs of --keep. */
static void print_kept(const struct gates *g, const struct gate_result *r) {
    char place[RESULTS_PATH];
    const char *keep = g->program ? g->program->keep : NULL;
    if (!keep || !r->read || !r->read->experiment.scene) return;
    const struct experiment *e = &r->read->experiment;
    if (!results_of_scene(keep, e->scene, e->program.setting, place)) printf("  cases: %s\n", place);
}

static void print_failure(const struct gates *g, const struct gate_result *r, int all) {
    const struct measured *m = &r->measured;
    const char *word = verdict_words[m->verdict];
    printf("\n%s: %s%s%s: %s\n", r->gate.id, verdict_colour(stdout, word), word, verdict_colour_end(stdout, word),
           m->reason);
    if (*m->diagnosis) printf("  diagnosis: %s\n", m->diagnosis);
    if (all) print_details(r);
    print_kept(g, r);
    printf("  heatladder %s\n", r->typed);
}

static int is_skipped(const struct gate_result *r) {
    return r->measured.verdict == VERDICT_SKIPPED;
}

/* One line for all that are skipped for the reason of the gate i, where i is the first of them: their names, or their
 * number where it is large and not all is wanted. */
static void print_skipped(const struct gates *g, int i, int all) {
    enum { MANY = 10 };
    const char *reason = g->result[i].measured.reason;
    int number = 0;
    for (int k = 0; k < g->declared; k++)
        if (is_skipped(&g->result[k]) && strcmp(g->result[k].measured.reason, reason) == 0) {
            if (k < i) return;
            number++;
        }
    printf("\n");
    if (number > MANY && !all) printf("%d %s (--verbose: their names)", number, gates_noun(g, number));
    for (int k = i; k < g->declared && (number <= MANY || all); k++)
        if (is_skipped(&g->result[k]) && strcmp(g->result[k].measured.reason, reason) == 0)
            printf("%s%s", k > i ? ", " : "", g->result[k].gate.id);
    printf(": skipped: %s\n", reason);
}

void print_gates(const struct gates *g, int all, double seconds) {
    struct gates_tally t = gates_tally(g, NULL);
    if (all)
        print_all(g);
    else
        print_groups(g);
    for (int i = 0; i < g->declared; i++)
        if (gates_fails(&g->result[i])) print_failure(g, &g->result[i], all);
    for (int i = 0; i < g->declared; i++)
        if (is_skipped(&g->result[i])) print_skipped(g, i, all);
    if (*g->diagnosis) printf("\ndiagnosis: %s\n", g->diagnosis);
    if (g->interrupted)
        printf("\ninterrupted by signal %d: %d of %d rows were judged\n", g->interrupted, g->executed, g->planned);
    int rows = g->interrupted ? g->planned : g->declared;
    printf("\n%d %s%s", rows, gates_noun(g, rows), g->program ? ": " : " declared, ");
    if (!g->program) printf("%d executed: ", g->executed - t.skipped);
    printf("%d passed, %d failed, %d inconclusive", t.passed, t.failed, t.undecided);
    if (t.skipped) printf(", %d skipped", t.skipped);
    if (g->program && g->interrupted) printf(", %d not judged", g->planned - g->executed);
    printf(" (%.2f s)\n", seconds);
}

/* Escapes GitHub's workflow commands: characters that would end a command or a property. */
static void put_escaped(const char *text, const char *special) {
    for (; *text; text++)
        if (strchr(special, *text))
            fprintf(stderr, "%%%02X", (unsigned)*text);
        else
            fputc(*text, stderr);
}

void print_annotations(const struct gates *g) {
    for (int i = 0; i < g->declared; i++) {
        const struct gate_result *r = &g->result[i];
        const struct measured *m = &r->measured;
        if (!gates_fails(r)) continue;
        fprintf(stderr, "::%s title=", m->verdict == VERDICT_FAIL ? "error" : "warning");
        put_escaped(r->gate.id, "%\r\n:,");
        fprintf(stderr, "::");
        put_escaped(m->reason, "%\r\n");
        if (*m->diagnosis) fprintf(stderr, "; diagnosis: ");
        put_escaped(m->diagnosis, "%\r\n");
        fputc('\n', stderr);
    }
}
