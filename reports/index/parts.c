/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page shows besides scenes and gates: the files that the reports leave, where they are.  A new one is a row
 * of the table. */
#include "reports/index/index.h"

#include "verification/page/html.h"
#include "verification/text/whole_file.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LISTED = 45 }; /* lines of a listing that are not folded away */
enum { WIDE = 950 };  /* pixels */
/* <file>.svg with its data; <file> of Markdown, open or folded; <file> as it is */
enum kind { FIGURE, PAGE, FOLDED, LISTING };

static const char song[] = "Song et al. 2018", pamplona[] = "Pamplona et al. 2019";

static const struct part {
    const char *section; /* of the page */
    enum kind kind;
    const char *file;    /* below the directory */
    const char *data;    /* a figure's data, below the directory */
    const char *text;    /* what it shows */
    const char *command; /* what makes it */
} parts[] = {
    {"Error against time", FIGURE, "league/league.svg", "league/league.csv",
     "Error against time on the square: the methods of this suite and other codes", "make setup-peers league"},
    {"Error against time", FIGURE, "matched_fig1.svg", "matched_fig1.csv",
     "Error against counted work on the square: as published, and with matched step, start and smoothing length",
     "make report"},
    {"Operators", PAGE, "operators.md", NULL, NULL, "make operators"},
    {"Operators", FIGURE, "operators_work.svg", "operators_work.csv",
     "Error against pairs of neighbours on three clouds, by operator", "make operators"},
    {"Operators", FIGURE, "operators_error.svg", "operators_error.csv",
     "Error against neighbours at equal spacing, by operator", "make operators"},
    {"Operators", FIGURE, "operators_growth.svg", "operators_growth.csv",
     "Share of jittered clouds on which a mode grows at any time step, and how far it goes", "make operators"},
    {"Walls", PAGE, "walls.md", NULL, NULL, "make walls"},
    {"Walls", FIGURE, "walls_error.svg", "walls_error.csv", "Error against spacing, by treatment of the wall",
     "make walls"},
    {"Walls", FIGURE, "walls_work.svg", "walls_error.csv", "Error against work, by treatment of the wall",
     "make walls"},
    {"Walls", FIGURE, "walls_offset.svg", "walls_offset.csv", "Order against the offset of plane walls",
     "make walls"},
    {"Walls", FIGURE, "walls_field.svg", "walls_field.csv", "The error on the disc", "make walls"},
    {"Stability", FIGURE, "stability_limits.svg", "stability_limits.csv",
     "Largest stable step against h/dx: published, by von Neumann's analysis, measured", "make stability"},
    {"Stability", FIGURE, "stability_blowup.svg", "stability_blowup.csv", "Runs just below and just above the limit",
     "make stability"},
    {"Stability", FIGURE, "stability_jitter.svg", "stability_jitter.csv", "Spectra of jittered clouds",
     "make stability"},
    {"Stability", FIGURE, "stability_checkerboard.svg", "stability_checkerboard.csv",
     "Amplitude of the checkerboard against time", "make stability"},
    {"Speed", LISTING, "bench/bench.txt", NULL, NULL, "make bench"},
    {"Seeded faults", LISTING, "mutants.txt", NULL, NULL, "make mutants"},
    {"Seeded faults", PAGE, "league/faults.md", NULL, NULL, "make faults"},
    {"Other codes", PAGE, "league/league.md", NULL, NULL, "make league"},
    {"Other codes", FIGURE, "league/league.svg", "league/league.csv", "Error against time, by code", "make league"},
    {song, PAGE, "song_table1.md", NULL, NULL, "make report"},
    {song, FIGURE, "song_fig1a.svg", "song_fig1a.csv", "Figure 1a: temperature on the rod", "make report"},
    {song, FIGURE, "song_fig1b.svg", "song_fig1b.csv",
     "Figure 1b: first-order SSPH oscillates at the jump, second-order does not", "make report"},
    {song, FIGURE, "song_fig2a.svg", "song_fig2a.csv", "Figure 2a: error against spacing, orders 1 and 2 at the jump",
     "make report"},
    {song, PAGE, "song_table2.md", NULL, NULL, "make report"},
    {song, FIGURE, "song_fig2b.svg", "song_fig2b.csv",
     "Figure 2b: error against spacing on the Gaussian, order 2 of both methods", "make report"},
    {song, PAGE, "song_table3.md", NULL, NULL, "make report"},
    {song, FIGURE, "song_fig5.svg", "song_fig5.csv", "Figure 5: error against spacing on the square", "make report"},
    {pamplona, FIGURE, "pamplona_fig5.svg", "pamplona_fig5.csv",
     "Figure 5: isotherms of SPH and of the exact solution", "make report"},
    {pamplona, FIGURE, "pamplona_fig7a.svg", "pamplona_fig7a.csv",
     "Figure 7a: least mean relative error against h, first order", "make report"},
    {pamplona, FIGURE, "pamplona_fig7b.svg", "pamplona_fig7b.csv", "Figure 7b: best xi against h", "make report"},
    {pamplona, FIGURE, "pamplona_fig8.svg", "pamplona_fig8.csv", "Figure 8: cost against h", "make report"},
    {pamplona, FOLDED, "pamplona_table1.md", NULL, "Table 1: published and measured, not all of it explained",
     "make report"},
    {"Statements of the papers", FOLDED, "claims/claims.md", NULL, "Each statement with what is measured",
     "make claims"},
};
enum { PARTS = sizeof parts / sizeof *parts };

const char *const parts_sections[] = {"Operators", "Walls",         "Stability",
                                      "Speed",     "Seeded faults", "Other codes",
                                      song,        pamplona,        "Statements of the papers",
                                      NULL};

/* Several panels: not to be printed two in a row. */
static int is_wide(const char *path) {
    char head[600] = "";
    FILE *in = whole_file_open(path);
    if (!in) return 0;
    size_t got = fread(head, 1, sizeof head - 1, in);
    fclose(in);
    const char *width = got ? strstr(head, " width=\"") : NULL;
    return width && strtod(width + strlen(" width=\""), NULL) > WIDE;
}

static void put_figure(const struct part *part, const char *path, FILE *out) {
    fprintf(out, "<figure%s>", is_wide(path) ? " class=\"wide\"" : "");
    html_image(out, path, part->text);
    fprintf(out, "<figcaption>");
    html_text(out, part->text);
    fprintf(out, ". <code>%s</code>, <a href=\"%s\">data</a></figcaption></figure>\n", part->command, part->data);
}

/* Lines of the text from `from` up to `to`. */
static int lines_in(const char *from, const char *to) {
    int n = 0;
    for (; from < to; from++) n += *from == '\n';
    return n;
}

/* Behind the blank line that ends a paragraph, or the end of the text. */
static char *after_paragraph(char *text) {
    char *blank = strstr(text, "\n\n");
    return blank ? blank + 2 : text + strlen(text);
}

static void put_lines(char *from, char *to, FILE *out) {
    char kept = *to, *end;
    *to = '\0';
    fprintf(out, "<pre><code>");
    for (; *from; from = end) {
        end = from + strcspn(from, "\n");
        int ends = *end == '\n';
        *end = '\0';
        html_print(out, ends ? "%s\n" : "%s", from);
        if (ends) *end++ = '\n';
    }
    fprintf(out, "</code></pre>\n");
    *to = kept;
}

/* A listing's first paragraphs and a last one of a line; what does not fit between them is folded away. */
static void put_listing(const char *name, char *text, FILE *out) {
    char *end = text + strlen(text), *fold = text, *last = text;
    while (fold < end && lines_in(text, after_paragraph(fold)) <= LISTED) fold = after_paragraph(fold);
    for (char *next = text; next < end; next = after_paragraph(next)) last = next;
    if (last < fold || lines_in(last, end) > 1) last = end;
    if (fold > text) put_lines(text, fold, out);
    if (fold < last) {
        html_print(out, "<details><summary>%s", name);
        fprintf(out, ": %d lines more</summary>\n", lines_in(fold, last));
        put_lines(fold, last, out);
        fprintf(out, "</details>\n");
    }
    if (last < end) put_lines(last, end, out);
}

static void put_file(const struct part *part, const char *path, FILE *out) {
    FILE *in = whole_file_open(path);
    if (!in) return;
    if (part->kind == FOLDED) html_print(out, "<details><summary>%s</summary>\n", part->text);
    if (part->kind == LISTING) {
        char *text = whole_file_read(in, NULL);
        put_listing(part->file, text, out);
        free(text);
    } else {
        markdown_write(out, in, 2);
    }
    fclose(in);
    if (part->kind == FOLDED) fprintf(out, "</details>\n");
    fprintf(out, "<p class=\"faint\"><code>%s</code></p>\n", part->command);
}

static int is_made(const struct part *part, const char *dir) {
    char path[1200];
    snprintf(path, sizeof path, "%s/%s", dir, part->file);
    return access(path, R_OK) == 0;
}

static void put_part(const struct part *part, const char *dir, FILE *out) {
    char path[1200];
    if (!is_made(part, dir)) return;
    snprintf(path, sizeof path, "%s/%s", dir, part->file);
    if (part->kind == FIGURE)
        put_figure(part, path, out);
    else
        put_file(part, path, out);
}

int parts_has(const char *section, const char *dir) {
    for (int i = 0; i < PARTS; i++)
        if (strcmp(parts[i].section, section) == 0 && is_made(&parts[i], dir)) return 1;
    return 0;
}

void parts_put(const char *section, const char *dir, FILE *out) {
    for (int i = 0; i < PARTS; i++)
        if (strcmp(parts[i].section, section) == 0) put_part(&parts[i], dir, out);
}

/* As `make bench` draws them for each scene that it has. */
void parts_put_precision(const char *scene, const char *dir, FILE *out) {
    static const char *const chart[] = {"convergence", "work"};
    static const char *const across[] = {"particles along x", "counted work"};
    for (int i = 0; i < 2; i++) {
        char file[160], data[160], text[160];
        snprintf(file, sizeof file, "bench/bench_%s_%s.svg", scene, chart[i]);
        snprintf(data, sizeof data, "bench/bench_%s.csv", scene);
        snprintf(text, sizeof text, "Error against %s on %s", across[i], scene);
        put_part(&(struct part){scene, FIGURE, file, data, text, "make bench"}, dir, out);
    }
}

/* One line: each command that makes what is not here, once. */
void parts_put_missing(const char *dir, FILE *out) {
    int commands = 0;
    for (int i = 0; i < PARTS; i++) {
        int named = is_made(&parts[i], dir);
        for (int k = 0; k < i && !named; k++)
            named = !is_made(&parts[k], dir) && strcmp(parts[k].command, parts[i].command) == 0;
        if (named) continue;
        const char *lead = commands++ ? ", " : "<p class=\"faint\">Not made yet: ";
        fprintf(out, "%s<code>%s</code>", lead, parts[i].command);
    }
    if (commands) fprintf(out, ".</p>\n");
}
