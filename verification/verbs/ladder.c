/* heatladder ladder: runs of falling dx (or dt), and the order at which the error falls. */
#include "verification/command/verb.h"

#include "verification/text/json.h"
#include "verification/ladder/ladder.h"
#include "verification/page/page.h"
#include "verification/text/atomic_file.h"
#include "verification/text/paint.h"
#include "verification/command/request.h"
#include "verification/text/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void add_header(struct table *t, const struct ladder *l) {
    const char *header[] = {l->in_time ? "dt [s]"
                            : *l->vary ? l->vary
                                       : "dx [m]",
                            "particles",
                            "steps",
                            "E1",
                            "L2",
                            "Linf [K]",
                            "slope",
                            "time [%]",
                            "seconds",
                            "left out"};
    for (int i = 0; i < 10; i++) table_add(t, "%s", header[i]);
}

static void add_rung(struct table *t, const struct ladder *l, int i) {
    const struct result *r = &l->rung[i];
    table_add(t, "%.6g", l->inverse ? 1 / l->x[i] : l->x[i]);
    table_add(t, "%zu", r->particles);
    table_add(t, "%lld", r->steps);
    table_add(t, "%.4e", r->failure.status ? NAN : r->error.l1);
    table_add(t, "%.4e", r->failure.status ? NAN : r->error.l2);
    table_add(t, "%.4e", r->failure.status ? NAN : r->error.linf);
    if (i == 0)
        table_add(t, " ");
    else
        table_add(t, "%.3f", l->local[i - 1]);
    if (isnan(r->time_error))
        table_add(t, " ");
    else
        table_add(t, "%.2g", 100 * r->time_error);
    table_add(t, "%.2g", r->seconds);
    table_add(t, "%s", r->failure.status ? r->failure.text : l->window.left_out[i]);
}

static void print_text(const struct ladder *l) {
    struct table t = table_create(10, 0);
    char what[240];
    const char *verdict = verdict_words[l->verdict];
    result_describe(&l->rung[l->n - 1], what, sizeof what);
    printf("%s\n", what);
    if (l->self_differences)
        printf("errors by Richardson's extrapolation from successive runs on one grid; the finest is not shown\n");
    else if (l->in_time && !l->semidiscrete_steps && !l->failure.status)
        printf("errors against the exact solution in time of the same particles' equations\n");
    if (l->semidiscrete_steps)
        printf("errors against %lld steps of rk2 for the same particles' equations, themselves wrong by %.1e\n",
               l->semidiscrete_steps, l->semidiscrete_error);
    printf("\n");
    add_header(&t, l);
    for (int i = 0; i < l->n; i++) add_rung(&t, l, i);
    table_print(&t, stdout);
    table_free(&t);
    ladder_slope_text(l, what, sizeof what);
    printf("\n%s\n", what);
    printf("%s%s%s: %s (%.2g s)\n", paint_start(stdout, verdict), verdict, paint_end(stdout, verdict), l->reason,
           l->seconds);
}

static void print_json(const struct ladder *l) {
    struct json j = json_on(stdout);
    json_object(&j, NULL);
    ladder_json(l, &j);
    json_end(&j);
}

int verb_ladder(const struct request *r, struct failure *why) {
    struct ladder *l = xcalloc(1, sizeof *l);
    int status = atomic_file_check(r->page_path, why);
    if (!status) status = ladder_run(&r->experiment, &r->rungs, l, why);
    if (!status_refused(status) || l->tried) {
        struct failure unwritten;
        (r->json ? print_json : print_text)(l);
        if (!r->json && l->tried) why->text[0] = '\0'; /* it stands in the table */
        if (r->page_path && page_ladder_write(l, &r->rungs, r->page_path, &unwritten) && !status)
            status = unwritten.status, *why = unwritten;
    }
    if (!status && (r->rungs.expect.count || r->rungs.ceiling > 0) && l->verdict != VERDICT_PASS)
        status = l->verdict == VERDICT_FAIL ? STATUS_GATE : STATUS_INCONCLUSIVE;
    free(l);
    return status;
}
