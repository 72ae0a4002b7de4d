/* The page that `make report` ends in: the verdict, then scene by scene what was published beside what is measured,
 * then operators, stability, the ledger, seeded faults, other codes, speed.  Nothing is computed here. */
#include "reports/index/index.h"

#include "reports/index/gates_json.h"
#include "references/scene.h"
#include "solver/status.h"
#include "verification/page/html.h"
#include "verification/page/markdown.h"
#include "verification/text/letter.h"
#include "verification/text/output.h"
#include "verification/text/whole_file.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LISTED = 45 };                /* lines of a listing that are not folded away */
enum { WIDE = 950 };                 /* pixels */
enum kind { FIGURE, PAGE, LISTING }; /* <file>.svg with its data, <file> of Markdown, <file> as it is */

static const struct part {
    const char *section; /* of the page; a scene's name for what belongs to it */
    enum kind kind;
    const char *file;    /* below the directory */
    const char *data;    /* a figure's data, below the directory */
    const char *text;    /* what it shows */
    const char *command; /* what makes it */
} parts[] = {
    {"rod-step", PAGE, "song_table1.md", NULL, NULL, "make report"},
    {"rod-step", FIGURE, "song_fig1a.svg", "song_fig1a.csv", "Song Figure 1a: temperature on the rod", "make report"},
    {"rod-step", FIGURE, "song_fig1b.svg", "song_fig1b.csv",
     "Song Figure 1b: first-order SSPH oscillates at the jump, second-order does not", "make report"},
    {"rod-step", FIGURE, "song_fig2a.svg", "song_fig2a.csv",
     "Song Figure 2a: error against spacing, orders 1 and 2 at the jump", "make report"},
    {"rod-gauss", PAGE, "song_table2.md", NULL, NULL, "make report"},
    {"rod-gauss", FIGURE, "song_fig2b.svg", "song_fig2b.csv",
     "Song Figure 2b: error against spacing, order 2 of both on the Gaussian", "make report"},
    {"square-step", PAGE, "song_table3.md", NULL, NULL, "make report"},
    {"square-step", FIGURE, "song_fig5.svg", "song_fig5.csv", "Song Figure 5: error against spacing on the square",
     "make report"},
    {"square-step", FIGURE, "matched_fig1.svg", "matched_fig1.csv",
     "Error against work, as published and with matched step, start and smoothing length", "make report"},
    {"plate", PAGE, "pamplona_table1.md", NULL, NULL, "make report"},
    {"plate", FIGURE, "pamplona_fig5.svg", "pamplona_fig5.csv",
     "Pamplona Figure 5: isotherms of SPH and of the exact solution", "make report"},
    {"plate", FIGURE, "pamplona_fig7a.svg", "pamplona_fig7a.csv",
     "Pamplona Figure 7a: least mean relative error against h, first order", "make report"},
    {"plate", FIGURE, "pamplona_fig7b.svg", "pamplona_fig7b.csv", "Pamplona Figure 7b: best xi against h",
     "make report"},
    {"plate", FIGURE, "pamplona_fig8.svg", "pamplona_fig8.csv", "Pamplona Figure 8: cost against h", "make report"},
    {"Operators", PAGE, "operators.md", NULL, NULL, "make operators"},
    {"Operators", FIGURE, "operators_error.svg", "operators_error.csv",
     "Error against neighbours at equal spacing, operator by operator", "make operators"},
    {"Operators", FIGURE, "operators_growth.svg", "operators_growth.csv",
     "Share of jittered clouds on which a mode grows at any time step", "make operators"},
    {"Operators", FIGURE, "operators_redraw.svg", "operators_redraw.csv",
     "Error where the cloud is drawn anew every N steps", "make operators"},
    {"Walls", PAGE, "walls.md", NULL, NULL, "make walls"},
    {"Walls", FIGURE, "walls_error.svg", "walls_error.csv", "Error against spacing, by treatment of the wall",
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
    {"Stability", FIGURE, "stability_checkerboard.svg", "stability_checkerboard.csv", "The checkerboard over time",
     "make stability"},
    {"Ledger", PAGE, "claims/claims.md", NULL, NULL, "make claims"},
    {"Seeded faults", LISTING, "mutants.txt", NULL, NULL, "make mutants"},
    {"Seeded faults", PAGE, "league/faults.md", NULL, NULL, "make faults"},
    {"Other codes", PAGE, "league/league.md", NULL, NULL, "make league"},
    {"Other codes", FIGURE, "league/league.svg", "league/league.csv", "Error against time, code by code",
     "make league"},
    {"Speed", LISTING, "bench/bench.txt", NULL, NULL, "make bench"},
    {"Speed", FIGURE, "peers/peers_square-step.svg", "peers/peers_square-step.csv",
     "Error against time on the square: this suite's methods and others", "make setup-peers bench-peers"},
};
enum { PARTS = sizeof parts / sizeof *parts };

static const char *const sections[] = {"Operators",     "Walls",       "Stability", "Ledger",
                                       "Seeded faults", "Other codes", "Speed"};
enum { SECTIONS = sizeof sections / sizeof *sections };

static int missing(const struct part *part, FILE *out) {
    fprintf(out, "<p class=\"faint\">Not here: ");
    html_text(out, part->file);
    fprintf(out, "; <code>%s</code> makes it.</p>\n", part->command);
    return 0;
}

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

static int put_figure(const struct part *part, const char *path, FILE *out) {
    if (access(path, R_OK)) return missing(part, out);
    fprintf(out, "<figure%s>", is_wide(path) ? " class=\"wide\"" : "");
    html_image(out, path, part->text);
    fprintf(out, "<figcaption>");
    html_text(out, part->text);
    fprintf(out, ". <code>%s</code>, <a href=\"%s\">data</a></figcaption></figure>\n", part->command, part->data);
    return 1;
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

static int put_file(const struct part *part, const char *path, FILE *out) {
    FILE *in = whole_file_open(path);
    if (!in) return missing(part, out);
    if (part->kind == PAGE) {
        markdown_write(out, in, 2);
    } else {
        char *text = whole_file_read(in, NULL);
        put_listing(part->file, text, out);
        free(text);
    }
    fclose(in);
    fprintf(out, "<p class=\"faint\"><code>%s</code></p>\n", part->command);
    return 1;
}

static void put_part(const struct part *part, const char *dir, FILE *out) {
    char path[1200];
    snprintf(path, sizeof path, "%s/%s", dir, part->file);
    if (part->kind == FIGURE)
        put_figure(part, path, out);
    else
        put_file(part, path, out);
}

static void put_parts(const char *section, const char *dir, FILE *out) {
    for (int i = 0; i < PARTS; i++)
        if (strcmp(parts[i].section, section) == 0) put_part(&parts[i], dir, out);
}

/* As `make bench` draws them for each scene that it has. */
static void put_precision(const struct scene *s, const char *dir, FILE *out) {
    static const char *const chart[] = {"convergence", "work"};
    static const char *const across[] = {"particles along x", "counted work"};
    for (int i = 0; i < 2; i++) {
        char file[160], data[160], text[160];
        snprintf(file, sizeof file, "bench/bench_%s_%s.svg", s->name, chart[i]);
        snprintf(data, sizeof data, "bench/bench_%s.csv", s->name);
        snprintf(text, sizeof text, "Error against %s on %s", across[i], s->name);
        put_part(&(struct part){s->name, FIGURE, file, data, text, "make bench"}, dir, out);
    }
}

static void put_contents(FILE *out) {
    fprintf(out, "<nav><h2>Contents</h2>\n<ul>\n");
    for (const struct scene *const *s = scenes; *s; s++)
        fprintf(out, "<li><a href=\"#%s\">%s</a>\n", (*s)->name, (*s)->name);
    for (int i = 0; i < SECTIONS; i++) fprintf(out, "<li><a href=\"#part%d\">%s</a>\n", i, sections[i]);
    fprintf(out, "</ul></nav>\n");
}

static void put_scene(const struct scene *s, const struct gates_json *g, const char *dir, FILE *out) {
    fprintf(out, "<section id=\"%s\">\n<h2>%s</h2>\n<p>", s->name, s->name);
    html_text(out, s->about);
    fprintf(out, ". <span class=\"faint\">");
    html_text(out, s->citation);
    fprintf(out, "</span></p>\n");
    page_put_scene(g->gate, g->count, s->name, out);
    put_parts(s->name, dir, out);
    put_precision(s, dir, out);
    fprintf(out, "</section>\n");
}

static void put_verdict(const struct gates_json *g, FILE *out) {
    char now[PAGE_ORIGIN];
    page_origin(now, sizeof now);
    if (g->count > 0)
        page_put_gates(g->gate, g->count, g->made, out);
    else
        fprintf(out, "<p class=\"verdict\">%s</p>\n",
                "No verdict: the gates were not run. <code>make verify</code> runs them.");
    html_print(out, "<p class=\"faint\">This page was made %s, of the files that lay there.</p>\n", now);
}

static void write_page(const char *dir, const struct gates_json *g, FILE *out) {
    html_open(out, "heatladder: verification of transient heat conduction");
    put_verdict(g, out);
    put_contents(out);
    for (const struct scene *const *s = scenes; *s; s++) put_scene(*s, g, dir, out);
    for (int i = 0; i < SECTIONS; i++) {
        fprintf(out, "<section id=\"part%d\">\n<h2>%s</h2>\n", i, sections[i]);
        put_parts(sections[i], dir, out);
        fprintf(out, "</section>\n");
    }
    html_close(out);
}

/* A cell of Markdown: no bar of its text ends it, and none of its words is a tag. */
static void put_cell(const char *text, FILE *out) {
    fputs("| ", out);
    for (size_t length; *text; text += length ? length : 1) {
        length = letter_length(text);
        if (*text == '<')
            fputs("&lt;", out);
        else if (*text == '&')
            fputs("&amp;", out);
        else if (strchr("|`*_[\\", *text))
            fprintf(out, "\\%c", *text);
        else
            fwrite(length ? text : " ", 1, length ? length : 1, out);
    }
    fputc(' ', out);
}

static void put_row(const struct page_gate *g, FILE *out) {
    put_cell(g->id, out);
    put_cell(g->verdict, out);
    put_cell(g->reason, out);
    fputs("|\n", out);
}

static void write_summary(const struct gates_json *g, FILE *out) {
    int good = 0;
    for (int i = 0; i < g->count; i++) good += strcmp(g->gate[i].verdict, "pass") == 0;
    fprintf(out, "## heatladder: %d of %d gates hold\n", good, g->count);
    if (good == g->count) return;
    fprintf(out, "\n| gate | verdict | reason |\n|---|---|---|\n");
    for (int i = 0; i < g->count; i++)
        if (strcmp(g->gate[i].verdict, "pass") != 0) put_row(&g->gate[i], out);
}

int index_write(const char *dir, struct failure *why) {
    char path[1200];
    struct output page[2];
    struct gates_json g = {0};
    snprintf(path, sizeof path, "%s/gates.json", dir);
    gates_json_read(path, &g);
    write_page(dir, &g, output_open(&page[0], "%s/index.html", dir));
    write_summary(&g, output_open(&page[1], "%s/summary.md", dir));
    gates_json_free(&g);
    return output_close(page, 2, why);
}
