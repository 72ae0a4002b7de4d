/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages for somebody's own code: a ladder, or a run of gates. */
#include "verification/page/page.h"

#include "solver/status.h"
#include "verification/command/help.h"
#include "verification/diagnosis/wording.h"
#include "verification/foreign/program.h"
#include "verification/ladder/ladder.h"
#include "verification/page/chart.h"
#include "verification/page/html.h"
#include "verification/text/output.h"
#include "verification/text/table.h"

#include <math.h>
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
    snprintf(text, size, "%s on %s by heatladder %s", when, where, help_version);
}

static void put_command(const char *command, FILE *out) {
    fprintf(out, "<p class=\"faint\">Made by</p>\n");
    html_command(out, command);
}

static void put_program(const struct program *p, FILE *out) {
    if (p && p->solver) html_print(out, "<p>Program: <code>%s</code></p>\n", p->solver);
    if (p && p->results)
        html_print(out, "<p>Program: the one that wrote the results in <code>%s</code></p>\n", p->results);
}

int page_gates_write(const struct gates *g, const char *title, const char *command, const char *path,
                     struct failure *why) {
    struct output page;
    FILE *out = output_open(&page, "%s", path);
    html_open(out, title);
    char made[PAGE_ORIGIN];
    page_origin(made, sizeof made);
    put_program(g->program, out);
    page_put_gates(g, made, out);
    orders_put_all(g, out);
    page_put_ladders(g, out);
    put_command(command, out);
    html_close(out);
    return output_close(&page, 1, why);
}

int page_ladder_write(const struct ladder *l, const struct ladder_rungs *asked, const char *command, const char *path,
                      struct failure *why) {
    struct output page;
    FILE *out = output_open(&page, "%s", path);
    char title[240], name[80], axis[60];
    result_describe(&l->rung[l->n - 1], title, sizeof title);
    snprintf(name, sizeof name, "%s (hollow: left out of the fit)", ladder_norm_titles[l->norm]);
    snprintf(axis, sizeof axis, "%s%s", l->inverse ? "1 / " : "", ladder_axis(l));
    double expected = asked->expect.count ? page_order(asked->expect.value[0], asked->expect.value[1]) : NAN;
    html_open(out, title);
    char slope[240];
    struct chart_series series = {name, l->n, l->x, l->error, l->window.counts};
    struct chart chart = {title, axis, ladder_norm_titles[l->norm], 1, &series, expected};
    fprintf(out, "<p class=\"verdict\">");
    html_verdict(out, verdict_words[l->verdict]);
    ladder_slope_text(l, slope, sizeof slope);
    html_print(out, ": %s</p>\n<p>%s.</p>\n", l->reason, slope);
    if (l->diagnosed) {
        wording_text(&l->diagnosis, slope, sizeof slope);
        html_print(out, "<p>Diagnosis: %s.</p>\n", slope);
    }
    char made[PAGE_ORIGIN];
    page_origin(made, sizeof made);
    html_print(out, "<p class=\"faint\">Made %s.</p>\n", made);
    fprintf(out, "<figure>\n");
    chart_write(&chart, out);
    fprintf(out, "</figure>\n");
    struct table rungs = ladder_table(l, 0);
    html_table(out, &rungs, 0);
    put_command(command, out);
    html_close(out);
    return output_close(&page, 1, why);
}
