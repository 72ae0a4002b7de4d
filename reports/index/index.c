/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The page of `make report`: verdict, orders, error against time, scenes from the simplest to the hardest, operators,
 * walls, stability, speed, papers.  It joins files and computes nothing. */
#include "reports/index/index.h"

#include "references/scene.h"
#include "solver/method.h"
#include "verification/text/html.h"
#include "verification/text/output.h"

#include <string.h>

/* The simplest scenes in the order to read them; the others follow in alphabetical order. */
static const char *const simplest[] = {"rod-gauss",         "rod-step",       "rod-cosine",    "rod-cooling",
                                       "rod-contact",       "wall-composite", "square-step",   "plane-contact",
                                       "rect-manufactured", "plate",          "plate-cooling", "disc-mode",
                                       "disc-cooling"};
enum { SIMPLEST = sizeof simplest / sizeof *simplest };

static const char *const sections[] = {
    "Operators", "Walls",         "Along a field",   "Stability", "Speed",
    "Song 2018", "Pamplona 2019", "The matched run", "In space",  "Statements of the papers"};
enum { SECTIONS = sizeof sections / sizeof *sections };

static int is_simple(const char *name) {
    for (int i = 0; i < SIMPLEST; i++)
        if (strcmp(simplest[i], name) == 0) return 1;
    return 0;
}

static void put_scene(const struct scene *s, const char *dir, FILE *out) {
    if (!s) return;
    html_print(out, "<section id=\"%s\">\n<h2>%s</h2>\n<p>%s. <span class=\"faint\">%s</span></p>\n", s->name,
               s->name, s->about, s->citation);
    parts_put_scene(s->name, dir, out);
    fprintf(out, "</section>\n");
}

/* With a figure of their ladders, or without one: beside a figure these would leave an empty place. */
static void put_scenes(int drawn, const char *dir, FILE *out) {
    for (int i = 0; i < SIMPLEST; i++)
        if (parts_has_ladder(simplest[i], dir) == drawn) put_scene(scene_find(simplest[i]), dir, out);
    for (const struct scene *const *s = scenes; *s; s++)
        if (!is_simple((*s)->name) && parts_has_ladder((*s)->name, dir) == drawn) put_scene(*s, dir, out);
}

static void put_contents(const char *dir, FILE *out) {
    fprintf(out, "<nav><h2>Contents</h2>\n<ul>\n<li><a href=\"#scenes\">Scenes</a>\n");
    for (int i = 0; i < SECTIONS; i++)
        if (parts_has(sections[i], dir)) fprintf(out, "<li><a href=\"#part%d\">%s</a>\n", i, sections[i]);
    fprintf(out, "</ul></nav>\n");
}

/* Two sentences: the tests, and the methods under test. */
static void put_lead(FILE *out) {
    int cases = 0, solvers = 0;
    while (scenes[cases]) cases++;
    while (methods[solvers]) solvers++;
    fprintf(
        out,
        "<p>%d methods for transient heat conduction, particles and finite differences, run on %d scenes with exact "
        "solutions. A gate holds where the error, and the order at which it falls with the spacing, are in the "
        "bands that theory gives.</p>\n",
        solvers, cases);
}

int index_write(const char *dir, struct failure *why) {
    struct output page;
    FILE *out = output_open(&page, "%s/index.html", dir);
    html_open(out, "heatladder: verification of transient heat conduction");
    put_lead(out);
    if (!parts_put("Verdict", dir, out))
        fprintf(out,
                "<p class=\"verdict\">No verdict: the gates were not run. <code>make verify</code> runs them.</p>\n");
    parts_put("Charts", dir, out);
    put_contents(dir, out);
    parts_put("Error against time", dir, out);
    parts_put_missing(dir, out);
    fprintf(out, "<div id=\"scenes\">\n");
    put_scenes(1, dir, out);
    put_scenes(0, dir, out);
    fprintf(out, "</div>\n");
    for (int i = 0; i < SECTIONS; i++) {
        if (!parts_has(sections[i], dir)) continue;
        fprintf(out, "<section id=\"part%d\">\n<h2>%s</h2>\n", i, sections[i]);
        parts_put(sections[i], dir, out);
        fprintf(out, "</section>\n");
    }
    html_close(out);
    return output_close(&page, 1, why);
}
