/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The page that `make report` ends in: the verdict, the order of every ladder, error against time, then the scenes
 * from the simplest to the hardest, operators, walls, stability, speed, faults, other codes, and the papers.  Nothing
 * is computed here. */
#include "reports/index/index.h"

#include "references/scene.h"
#include "solver/status.h"
#include "verification/page/html.h"
#include "verification/page/page.h"
#include "verification/text/letter.h"
#include "verification/text/output.h"

#include <string.h>

/* The simplest scenes, in the order to read them; the others follow as they stand. */
static const char *const simplest[] = {"rod-gauss",         "rod-step",       "rod-cosine",    "rod-cooling",
                                       "rod-contact",       "wall-composite", "square-step",   "plane-contact",
                                       "rect-manufactured", "plate",          "plate-cooling", "disc-mode",
                                       "disc-cooling"};
enum { SIMPLEST = sizeof simplest / sizeof *simplest, SCENES_ROOM = 200 };

static int is_among(const char *name, const char *const *among, int n) {
    for (int i = 0; i < n; i++)
        if (strcmp(among[i], name) == 0) return 1;
    return 0;
}

/* Every scene once, NULL last. */
static void order_scenes(const char *name[SCENES_ROOM]) {
    int n = 0;
    for (int i = 0; i < SIMPLEST; i++)
        if (scene_find(simplest[i])) name[n++] = simplest[i];
    for (const struct scene *const *s = scenes; *s && n < SCENES_ROOM - 1; s++)
        if (!is_among((*s)->name, simplest, SIMPLEST)) name[n++] = (*s)->name;
    name[n] = NULL;
}

static void put_contents(const char *const scene[], const char *dir, FILE *out) {
    fprintf(out, "<nav><h2>Contents</h2>\n<ul>\n");
    for (; *scene; scene++) fprintf(out, "<li><a href=\"#%s\">%s</a>\n", *scene, *scene);
    for (int i = 0; parts_sections[i]; i++)
        if (parts_has(parts_sections[i], dir)) fprintf(out, "<li><a href=\"#part%d\">%s</a>\n", i, parts_sections[i]);
    fprintf(out, "</ul></nav>\n");
}

static void put_scene(const char *name, const struct gates *g, const char *dir, FILE *out) {
    const struct scene *s = scene_find(name);
    fprintf(out, "<section id=\"%s\">\n<h2>%s</h2>\n<p>", s->name, s->name);
    html_text(out, s->about);
    fprintf(out, ". <span class=\"faint\">");
    html_text(out, s->citation);
    fprintf(out, "</span></p>\n");
    orders_put_scene(g, name, out);
    page_put_scene(g, name, out);
    parts_put_precision(name, dir, out);
    fprintf(out, "</section>\n");
}

static void put_verdict(const struct gates *g, const char *made, FILE *out) {
    if (g->declared > 0)
        page_put_gates(g, made, out);
    else
        fprintf(out, "<p class=\"verdict\">%s</p>\n",
                "No verdict: the gates were not run. <code>make verify</code> runs them.");
}

static void put_origin(FILE *out) {
    char now[PAGE_ORIGIN];
    page_origin(now, sizeof now);
    html_print(out, "<p class=\"faint\">This page was made %s from existing files.</p>\n", now);
}

static void write_page(const char *dir, const struct gates *g, const char *made, FILE *out) {
    const char *scene[SCENES_ROOM];
    order_scenes(scene);
    html_open(out, "heatladder: verification of transient heat conduction");
    put_verdict(g, made, out);
    orders_put(g, scene, "make verify", out);
    parts_put("Error against time", dir, out);
    parts_put_missing(dir, out);
    put_origin(out);
    put_contents(scene, dir, out);
    for (int i = 0; scene[i]; i++) put_scene(scene[i], g, dir, out);
    for (int i = 0; parts_sections[i]; i++) {
        if (!parts_has(parts_sections[i], dir)) continue;
        fprintf(out, "<section id=\"part%d\">\n<h2>%s</h2>\n", i, parts_sections[i]);
        parts_put(parts_sections[i], dir, out);
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

static void put_row(const struct gate_result *r, FILE *out) {
    put_cell(r->gate.id, out);
    put_cell(verdict_words[r->measured.verdict], out);
    put_cell(r->measured.reason, out);
    fputs("|\n", out);
}

static void write_summary(const struct gates *g, FILE *out) {
    int good = gates_tally(g, NULL).passed;
    fprintf(out, "## heatladder: %d of %d gates hold\n", good, g->declared);
    if (good == g->declared) return;
    fprintf(out, "\n| gate | verdict | reason |\n|---|---|---|\n");
    for (int i = 0; i < g->declared; i++)
        if (g->result[i].measured.verdict != VERDICT_PASS) put_row(&g->result[i], out);
}

int index_write(const char *dir, struct failure *why) {
    char path[1200];
    const char *made;
    struct output page[2];
    struct gates g;
    snprintf(path, sizeof path, "%s/gates.json", dir);
    gates_json_read(path, &g, &made);
    write_page(dir, &g, made, output_open(&page[0], "%s/index.html", dir));
    write_summary(&g, output_open(&page[1], "%s/summary.md", dir));
    gates_free(&g);
    return output_close(page, 2, why);
}
