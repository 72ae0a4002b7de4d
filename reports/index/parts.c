/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of the page: files that the reports leave.  A new part is a row of the table. */
#include "reports/index/index.h"

#include "verification/text/html.h"
#include "verification/text/whole_file.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH = 1200 };

static const char song[] = "Song 2018", pamplona[] = "Pamplona 2019";

static const struct part {
    const char *section;
    const char *file; /* below the directory: .svg with its data in .csv, .html, or a text */
    int folded;
    const char *text;    /* content; "" for a text that speaks for itself */
    const char *command; /* command that writes it */
} parts[] = {
    {"Verdict", "gates.html", 0, "", "make verify"},
    {"Charts", "gates.svg", 0, "The order of each ladder in the band of its own gate, a row a scene", "make verify"},
    {"Charts", "brief.svg", 0, "Error against wall time, every method with its best stepper", "make verify"},
    {"Error against time", "bench/error_time.svg", 0,
     "Error against wall time on square-step, one thread, median of 5 runs: each method, and so_ssph with each "
     "stepper",
     "make bench"},
    {"Error against time", "league/league.svg", 0,
     "Error against time on the square: the methods of this suite and other codes", "make setup-peers league"},
    {"Operators", "operators.html", 0, "Operators side by side", "make operators"},
    {"Operators", "operators_work.svg", 0, "Error against pairs of neighbours on three clouds, by operator",
     "make operators"},
    {"Operators", "operators_error.svg", 0, "Error against neighbours at equal spacing, by operator",
     "make operators"},
    {"Operators", "operators_growth.svg", 0,
     "Share of jittered clouds on which a mode grows at any time step, and how far it goes", "make operators"},
    {"Walls", "walls.html", 0, "Treatments of walls side by side", "make walls"},
    {"Walls", "walls_error.svg", 0, "Error against spacing, by treatment of the wall", "make walls"},
    {"Walls", "walls_work.svg", 0, "Error against work, by treatment of the wall", "make walls"},
    {"Walls", "walls_offset.svg", 0, "Order against the offset of plane walls", "make walls"},
    {"Walls", "walls_field.svg", 0, "The error on the disc", "make walls"},
    {"Walls", "front_means.svg", 0, "A front of k = k_0 T^2, by the mean of k at a pair", "make front"},
    {"Along a field", "field_patch.svg", 0, "A patch on its ring, exact and by three methods", "make field"},
    {"Along a field", "field_error.svg", 0, "Error against spacing, smooth and with a jump", "make field"},
    {"Along a field", "field_leak.svg", 0, "Heat that leaks across the field", "make field"},
    {"Along a field", "field_step.svg", 0, "Largest step against the angle of the field", "make field"},
    {"Stability", "stability_limits.svg", 0,
     "Largest stable step against h/dx: published, by von Neumann's analysis, measured", "make stability"},
    {"Stability", "stability_blowup.svg", 0, "Runs just below and just above the limit", "make stability"},
    {"Stability", "stability_jitter.svg", 0, "Spectra of jittered clouds", "make stability"},
    {"Stability", "stability_checkerboard.svg", 0, "Amplitude of the checkerboard against time", "make stability"},
    {"Speed", "bench/bench_square-step_time.svg", 1, "Error against wall time on square-step, every candidate",
     "make bench"},
    {"Speed", "bench/bench.txt", 1, "The machine, and the Pareto fronts of every scene", "make bench"},
    {song, "song_table1.html", 0, "Table 1: the rod, a jump", "make report"},
    {song, "song_fig1b.svg", 0, "Figure 1b: first-order SSPH oscillates at the jump, second-order does not",
     "make report"},
    {song, "song_fig2a.svg", 0, "Figure 2a: error against spacing, orders 1 and 2 at the jump", "make report"},
    {song, "song_table2.html", 0, "Table 2: the rod, a Gaussian", "make report"},
    {song, "song_fig2b.svg", 0, "Figure 2b: error against spacing on the Gaussian, order 2 of both methods",
     "make report"},
    {song, "song_table3.html", 0, "Table 3: the square", "make report"},
    {song, "song_fig5.svg", 0, "Figure 5: error against spacing on the square", "make report"},
    {pamplona, "pamplona_table1.html", 0, "Table 1: average error on the plate", "make report"},
    {pamplona, "pamplona_fig5.svg", 0, "Figure 5: isotherms of SPH and of the exact solution", "make report"},
    {pamplona, "pamplona_fig7a.svg", 0, "Figure 7a: least mean relative error against h, first order", "make report"},
    {pamplona, "pamplona_fig7b.svg", 0, "Figure 7b: best xi against h", "make report"},
    {pamplona, "pamplona_fig8.svg", 0, "Figure 8: cost against h", "make report"},
    {"The matched run", "matched_fig1.svg", 0,
     "Error against counted work on the square: as published, and with matched step, start and smoothing length",
     "make report"},
    {"In space", "space_fig1.svg", 0, "A jump in three dimensions: a slice of the error, and error against spacing",
     "make report"},
    {"Statements of the papers", "claims/claims.html", 1, "Each statement with its measurement", "make claims"},
};
enum { PARTS = sizeof parts / sizeof *parts };

static int ends_in(const char *name, const char *ending) {
    size_t n = strlen(name), k = strlen(ending);
    return n > k && strcmp(name + n - k, ending) == 0;
}

/* Figures of more than one column's width stand alone in their row. */
enum { COLUMN = 640 };

static int width_of(const char *path) {
    char head[512] = "", *at = NULL;
    FILE *in = fopen(path, "r");
    if (in) at = fread(head, 1, sizeof head - 1, in) > 0 ? strstr(head, "width=\"") : NULL, fclose(in);
    return at ? atoi(at + strlen("width=\"")) : 0;
}

static void put_figure(const struct part *part, const char *path, FILE *out) {
    fprintf(out, width_of(path) > COLUMN ? "<figure class=\"wide\">" : "<figure>");
    html_image(out, path, part->text);
    html_print(out, "<figcaption>%s. <code>%s</code></figcaption></figure>\n", part->text, part->command);
}

static void put_text(const char *path, FILE *out) {
    char *text = whole_file_at(path, NULL);
    if (text) html_print(out, "<pre><code>%s</code></pre>\n", text);
    free(text);
}

static int is_made(const struct part *part, const char *dir, char path[PATH]) {
    snprintf(path, PATH, "%s/%s", dir, part->file);
    return access(path, R_OK) == 0;
}

static int put_part(const struct part *part, const char *dir, FILE *out) {
    char path[PATH];
    if (!is_made(part, dir, path)) return 0;
    if (ends_in(part->file, ".svg")) {
        if (part->folded) html_print(out, "<details><summary>%s</summary>\n", part->text);
        put_figure(part, path, out);
        if (part->folded) fprintf(out, "</details>\n");
        return 1;
    }
    if (*part->text) html_print(out, part->folded ? "<details><summary>%s</summary>\n" : "<h3>%s</h3>\n", part->text);
    if (ends_in(part->file, ".html"))
        html_include(out, path);
    else
        put_text(path, out);
    if (part->folded) fprintf(out, "</details>\n");
    if (*part->text) html_print(out, "<p class=\"faint\"><code>%s</code></p>\n", part->command);
    return 1;
}

int parts_has(const char *section, const char *dir) {
    char path[PATH];
    for (int i = 0; i < PARTS; i++)
        if (strcmp(parts[i].section, section) == 0 && is_made(&parts[i], dir, path)) return 1;
    return 0;
}

int parts_put(const char *section, const char *dir, FILE *out) {
    int put = 0;
    for (int i = 0; i < PARTS; i++)
        if (strcmp(parts[i].section, section) == 0) put += put_part(&parts[i], dir, out);
    return put > 0;
}

int parts_has_ladder(const char *scene, const char *dir) {
    char path[PATH];
    snprintf(path, sizeof path, "%s/scene_%s.svg", dir, scene);
    return access(path, R_OK) == 0;
}

void parts_put_scene(const char *scene, const char *dir, FILE *out) {
    static const struct {
        const char *file, *about, *command;
    } figure[] = {
        {"scene_%s.svg", "Error against dx on %s; E1 = sum of |T - T_exact| over sum of |T_exact|", "make verify"},
        {"bench/bench_%s_work.svg", "Error against counted work on %s", "make bench"}};
    for (int i = 0; i < 2; i++) {
        char file[160], text[160];
        snprintf(file, sizeof file, figure[i].file, scene);
        snprintf(text, sizeof text, figure[i].about, scene);
        put_part(&(struct part){scene, file, i == 1, text, figure[i].command}, dir, out);
    }
}

void parts_put_missing(const char *dir, FILE *out) {
    char path[PATH];
    const char *last = NULL;
    for (int i = 0; i < PARTS; i++) {
        int named = is_made(&parts[i], dir, path);
        for (int k = 0; k < i && !named; k++)
            named = !is_made(&parts[k], dir, path) && strcmp(parts[k].command, parts[i].command) == 0;
        if (named) continue;
        if (last && strcmp(last, parts[i].section) == 0)
            fprintf(out, ", ");
        else
            html_print(out, last ? "); %s (" : "<p class=\"faint\">Not made yet: %s (", parts[i].section);
        html_print(out, "<code>%s</code>", parts[i].command);
        last = parts[i].section;
    }
    if (last) fprintf(out, ").</p>\n");
}
