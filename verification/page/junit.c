/* Gates as JUnit XML: a test suite of a test case each, failed or in error (inconclusive) with its reason. */
#include "verification/page/junit.h"

#include "solver/status.h"
#include "verification/gates/gates.h"
#include "verification/page/html.h"
#include "verification/text/output.h"

#include <stdio.h>

static void put_case(const struct gate_result *r, FILE *out) {
    const enum verdict verdict = r->measured.verdict;
    const char *tag = verdict == VERDICT_FAIL ? "failure" : verdict == VERDICT_SKIPPED ? "skipped" : "error";
    html_print(out, "    <testcase name=\"%s", r->gate.id);
    fprintf(out, "\" time=\"%.3f\"", r->seconds);
    if (verdict == VERDICT_PASS) {
        fprintf(out, "/>\n");
        return;
    }
    html_print(out, ">\n      <%s message=\"%s%s%s\">expected because: %s\nheatladder %s</%s>\n    </testcase>\n",
               tag, r->measured.reason, *r->measured.diagnosis ? "; diagnosis: " : "", r->measured.diagnosis,
               r->gate.why, r->typed, tag);
}

int junit_write(const struct gates *g, const char *path, struct failure *why) {
    struct output page;
    double seconds = 0;
    int failed = 0, skipped = 0, passed = 0;
    for (int i = 0; i < g->declared; i++) {
        seconds += g->result[i].seconds;
        failed += g->result[i].measured.verdict == VERDICT_FAIL;
        passed += g->result[i].measured.verdict == VERDICT_PASS;
        skipped += g->result[i].measured.verdict == VERDICT_SKIPPED;
    }
    FILE *out = output_open(&page, "%s", path);
    fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n");
    fprintf(out,
            "  <testsuite name=\"gates\" tests=\"%d\" failures=\"%d\" errors=\"%d\" skipped=\"%d\" time=\"%.3f\">\n",
            g->declared, failed, g->declared - failed - skipped - passed, skipped, seconds);
    for (int i = 0; i < g->declared; i++) put_case(&g->result[i], out);
    fprintf(out, "  </testsuite>\n</testsuites>\n");
    return output_close(&page, 1, why);
}
