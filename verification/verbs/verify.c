/* heatladder verify: every gate, each with its reason. */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "solver/method.h"
#include "verification/text/atomic_file.h"
#include "verification/gates/gates.h"
#include "verification/text/json.h"
#include "verification/text/output.h"
#include "verification/gates/junit.h"
#include "verification/command/request.h"
#include "verification/text/table.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>

static void gate_json(const struct gate_result *r, struct json *j) {
    const struct gate *g = &r->gate;
    const struct measured *m = &r->measured;
    int at_most = g->lo == 0; /* a bound from above; else a band */
    json_object(j, NULL);
    json_text(j, "id", g->id);
    json_text(j, "measure", g->measure);
    json_text(j, "command", g->command);
    json_number(j, "expected", at_most ? 0 : (g->lo + g->hi) / 2);
    json_number(j, "tolerance", at_most ? g->hi : (g->hi - g->lo) / 2);
    json_number(j, "measured", m->value);
    json_array(j, "interval95");
    for (int i = 0; i < 2; i++) json_number(j, NULL, m->ci[i]);
    json_end(j);
    json_number(j, "error", m->error);
    json_number(j, "ceiling", g->ceiling);
    json_text(j, "verdict", verdict_words[m->verdict]);
    json_text(j, "reason", m->reason);
    json_text(j, "why", g->why);
    json_number(j, "seconds", r->seconds);
    json_end(j);
}

static int write_json(const struct gates *g, const char *path, struct failure *why) {
    struct output page;
    if (output_open(&page, why, "%s", path)) return why->status;
    struct json j = json_on(page.out);
    json_object(&j, NULL);
    json_whole(&j, "declared", g->declared);
    json_whole(&j, "executed", g->executed);
    json_array(&j, "gates");
    for (int i = 0; i < g->declared; i++) gate_json(&g->result[i], &j);
    json_end(&j);
    json_end(&j);
    return output_close(&page, 1, why);
}

static void add_row(struct table *t, const struct gate_result *r) {
    const struct gate *g = &r->gate;
    const struct measured *m = &r->measured;
    table_add(t, "%s", g->id);
    table_add(t, "%s", g->measure);
    table_add(t, "%s", verdict_words[m->verdict]);
    table_add(t, "%.4g .. %.4g", g->lo, g->hi);
    table_add(t, "%.4g", m->value);
    if (m->ci[0] < m->ci[1])
        table_add(t, "%.4f .. %.4f", m->ci[0], m->ci[1]);
    else
        table_add(t, " ");
    if (isnan(g->ceiling))
        table_add(t, " ");
    else
        table_add(t, "%.2e < %.2e", m->error, g->ceiling);
    table_add(t, "%.2f", r->seconds);
}

static int print_text(const struct gates *g, double seconds) {
    static const char *const header[] = {"gate",  "measure",       "verdict",         "expected",
                                         "value", "95 % interval", "error < ceiling", "seconds"};
    struct table t = table_create(8, 3);
    int count[4] = {0};
    for (int i = 0; i < 8; i++) table_add(&t, "%s", header[i]);
    for (int i = 0; i < g->declared; i++) add_row(&t, &g->result[i]);
    table_print(&t, stdout);
    table_free(&t);
    printf("\n");
    for (int i = 0; i < g->declared; i++) {
        const struct gate_result *r = &g->result[i];
        count[r->measured.verdict]++;
        if (r->measured.verdict == VERDICT_PASS) continue;
        printf("%s: %s: %s\n  expected because: %s\n  heatladder %s\n", r->gate.id,
               verdict_words[r->measured.verdict], r->measured.reason, r->gate.why, r->gate.command);
    }
    printf("%d gates declared, %d executed: %d passed, %d failed, %d inconclusive (%.2f s)\n", g->declared,
           g->executed, count[VERDICT_PASS], count[VERDICT_FAIL], count[VERDICT_INCONCLUSIVE], seconds);
    return count[VERDICT_PASS];
}

static int ungated(void) {
    int n = 0;
    for (int s = 0; scenes[s]; s++)
        for (int m = 0; methods[m]; m++) n += !gates_has_order(scenes[s]->name, methods[m]->name);
    return n;
}

static int verify(const struct request *r, struct gates *g, struct failure *why) {
    if (atomic_file_check(r->json_path, why) || atomic_file_check(r->junit_path, why)) return why->status;
    if (gates_collect(r->only, r->quick, g, why)) return why->status;
    double start = omp_get_wtime();
    gates_run(g);
    print_text(g, omp_get_wtime() - start);
    if (!r->only && !r->quick && ungated())
        printf("%d pairs of scene and method have no gated ladder (see: heatladder list gates)\n", ungated());
    if (r->json_path && write_json(g, r->json_path, why)) return why->status;
    if (r->junit_path && junit_write(g, r->junit_path, why)) return why->status;
    return STATUS_OK;
}

int verb_verify(const struct request *r) {
    struct failure why;
    struct gates gates = {0};
    int status = verify(r, &gates, &why);
    if (status)
        fprintf(stderr, "heatladder: %s\n", why.text);
    else if (!gates_hold(&gates))
        status = STATUS_GATE;
    gates_free(&gates);
    return status;
}
