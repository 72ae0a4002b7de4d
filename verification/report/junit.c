/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gates as JUnit XML: a test suite a group, a test case a gate, failed or in error (inconclusive) with its reason. */

#include "solver/status.h"
#include "verification/text/html.h"
#include "verification/report/page.h"
#include "verification/text/output.h"

#include <stdio.h>

/* Properties of the whole suite: the fault that most gates match. */
static void put_properties(const struct gates *g, FILE *out) {
    if (!*g->diagnosis) return;
    html_print(out, "    <properties>\n      <property name=\"diagnosis\" value=\"%s\"/>\n    </properties>\n",
               g->diagnosis);
}

static void put_case(const struct gate_result *r, const char *group, FILE *out) {
    const enum verdict verdict = r->measured.verdict;
    const char *tag = verdict == VERDICT_FAIL ? "failure" : verdict == VERDICT_SKIPPED ? "skipped" : "error";
    html_print(out, "    <testcase classname=\"heatladder.%s\" name=\"%s", group, r->gate.id);
    fprintf(out, "\" time=\"%.3f\"", r->seconds);
    if (verdict == VERDICT_PASS) {
        fprintf(out, "/>\n");
        return;
    }
    html_print(out, ">\n      <%s message=\"%s%s%s\">why: %s\nheatladder %s</%s>\n    </testcase>\n", tag,
               r->measured.reason, *r->measured.diagnosis ? "; diagnosis: " : "", r->measured.diagnosis, r->gate.why,
               r->typed, tag);
}

static void put_suite(const struct gates *g, const char *group, FILE *out) {
    struct gates_tally t = gates_tally(g, group);
    char name[120];
    snprintf(name, sizeof name, "%.*s", (int)gates_group_length(group), group);
    html_print(out, "  <testsuite name=\"%s\"", name);
    fprintf(out, " tests=\"%d\" failures=\"%d\" errors=\"%d\" skipped=\"%d\" time=\"%.3f\">\n", t.judged + t.skipped,
            t.failed, t.undecided, t.skipped, t.seconds);
    put_properties(g, out);
    for (int i = 0; i < g->declared; i++)
        if (gates_same_group(g->result[i].gate.id, group)) put_case(&g->result[i], name, out);
    fprintf(out, "  </testsuite>\n");
}

int junit_write(const struct gates *g, const char *path, struct failure *why) {
    struct output page;
    FILE *out = output_open(&page, "%s", path);
    fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n");
    for (int i = 0; i < g->declared; i++)
        if (gates_begins_group(g, i)) put_suite(g, g->result[i].gate.id, out);
    if (g->interrupted)
        fprintf(out,
                "  <testsuite name=\"interrupted\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\">\n"
                "    <testcase classname=\"heatladder\" name=\"interrupted\">\n      <error message=\"interrupted "
                "by signal %d: %d of %d rows were judged\"/>\n    </testcase>\n  </testsuite>\n",
                g->interrupted, g->executed, g->planned);
    fprintf(out, "</testsuites>\n");
    return output_close(&page, 1, why);
}
