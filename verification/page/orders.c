/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One line a ladder; one curve a method. */
#include "verification/page/page.h"

#include "references/scene.h"
#include "solver/status.h"
#include "verification/page/chart.h"
#include "verification/page/html.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* px.  WIDTH leaves the text 11 px or more on a screen of 400. */
enum { WIDTH = 460, LEFT = 146, RIGHT = 16, TOP = 10, BOTTOM = 44, LINE = 3, GAP = 14 };
enum { NAMED = 60 }; /* ladders that have a line of their own, with its name */
enum { WORD = 80 };
static const char subject[] = "so_ssph";

/* Scene and method of a gate's ladder; 0 where it has none. */
static int words_of(const struct gate_result *r, char scene[WORD], char method[WORD]) {
    return r->measured.rungs.n > 0 && isfinite(r->measured.value) &&
           sscanf(r->typed, "ladder %79s %79s", scene, method) == 2;
}

/* Whether a ladder goes with that name, of a scene or its own. */
static int is_of(const struct gate_result *r, const char *name) {
    char of[WORD], method[WORD];
    if (strcmp(r->gate.id, name) == 0) return r->measured.rungs.n > 0 && isfinite(r->measured.value);
    return words_of(r, of, method) && strcmp(of, name) == 0;
}

static int lines_of(const struct gates *g, const char *scene) {
    int n = 0;
    for (int i = 0; i < g->declared; i++) n += is_of(&g->result[i], scene);
    return n;
}

/* Pixels of a group: room for its name, and a gap. */
static int height_of(int lines) {
    return GAP + (lines * LINE > GAP ? lines * LINE : GAP);
}

struct span {
    double lo, hi;
};

static struct span span_of(const struct gates *g, const char *const scene[]) {
    struct span s = {0, 1};
    for (; *scene; scene++)
        for (int i = 0; i < g->declared; i++) {
            if (!is_of(&g->result[i], *scene)) continue;
            const struct gate_result *r = &g->result[i];
            s.lo = fmin(s.lo, floor(fmin(r->measured.value, r->gate.lo)));
            s.hi = fmax(s.hi, ceil(fmax(r->measured.value, r->gate.hi)));
        }
    return s;
}

static double place(struct span s, double order) {
    return LEFT + (order - s.lo) / (s.hi - s.lo) * (WIDTH - LEFT - RIGHT);
}

/* A ladder with a line of its own is drawn larger. */
static void put_line(const struct gate_result *r, struct span s, double y, int alone, FILE *out) {
    int good = r->measured.verdict == VERDICT_PASS;
    fprintf(out, "<g><title>");
    html_text(out, r->gate.id);
    fprintf(out, ": %.3g, expected %.3g to %.3g</title>", r->measured.value, r->gate.lo, r->gate.hi);
    fprintf(out, "<path d=\"M%.1f %.1fH%.1f\" stroke=\"#b8b8b8\" stroke-width=\"%d\"/>", place(s, r->gate.lo), y,
            place(s, r->gate.hi), alone ? 8 : LINE - 1);
    if (good)
        fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"#0072B2\"/></g>\n",
                place(s, r->measured.value), y, alone ? 4.0 : 1.9);
    else
        fprintf(out, "<path d=\"M%.1f %.1fl8 8m0 -8l-8 8\" stroke=\"#a3200d\" stroke-width=\"2\"/></g>\n",
                place(s, r->measured.value) - 4, y - 4);
}

static void put_axis(struct span s, int high, FILE *out) {
    for (int order = (int)s.lo; order <= (int)s.hi; order++) {
        double x = place(s, order);
        fprintf(out, "<path d=\"M%.1f %dV%d\" stroke=\"#ddd\"/>\n", x, TOP, high - BOTTOM);
        fprintf(out, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%d</text>\n", x, high - BOTTOM + 18, order);
    }
    fprintf(out, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">order</text>\n", (LEFT + WIDTH - RIGHT) / 2,
            high - 8);
}

void orders_put(const struct gates *g, const char *const scene[], const char *command, FILE *out) {
    int high = TOP + BOTTOM, all = 0;
    for (int k = 0; scene[k]; k++) {
        int n = lines_of(g, scene[k]);
        all += n;
        high += n ? height_of(n) : 0;
    }
    if (!all) return;
    struct span s = span_of(g, scene);
    fprintf(out, "<figure>\n");
    chart_open(out, "Order reached and order expected, ladder by ladder", WIDTH, high);
    put_axis(s, high, out);
    int top = TOP;
    for (int k = 0; scene[k]; k++) {
        int n = lines_of(g, scene[k]), line = 0;
        if (!n) continue;
        double middle = top + height_of(n) / 2.0, y = middle - (n - 1) * LINE / 2.0;
        fprintf(out, "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">", LEFT - 10, middle + 4);
        html_text(out, scene[k]);
        fprintf(out, "</text>\n");
        for (int i = 0; i < g->declared; i++)
            if (is_of(&g->result[i], scene[k])) put_line(&g->result[i], s, y + LINE * line++, n == 1, out);
        top += height_of(n);
    }
    fprintf(out,
            "</svg>\n<figcaption>Order reached (dot) and order expected (grey) of %d ladders. A red cross: the gate "
            "does not hold.",
            all);
    if (command) html_print(out, " <code>%s</code>", command);
    fprintf(out, "</figcaption></figure>\n");
}

void orders_put_all(const struct gates *g, FILE *out) {
    int ladders = 0, n = 0, known = 0;
    while (scenes[known]) known++;
    for (int i = 0; i < g->declared; i++) ladders += g->result[i].measured.rungs.n > 0;
    const char **name = xcalloc((size_t)(ladders + known + 1), sizeof *name);
    if (ladders <= NAMED)
        for (int i = 0; i < g->declared; i++) {
            if (g->result[i].measured.rungs.n > 0) name[n++] = g->result[i].gate.id;
        }
    else
        for (; n < known; n++) name[n] = scenes[n]->name;
    orders_put(g, name, NULL, out);
    free(name);
}

/* The first ladder of each method whose errors are E1 over dx, the subject's first; how many. */
static int choose(const struct gates *g, const char *scene, const struct gate_result *chosen[]) {
    char method[CHART_STYLES][WORD], of[WORD], by[WORD];
    int n = 0;
    for (int others = 0; others < 2; others++)
        for (int i = 0; i < g->declared && n < CHART_STYLES; i++) {
            const struct gate_result *r = &g->result[i];
            if (!words_of(r, of, by) || strcmp(of, scene) != 0 || (strcmp(by, subject) != 0) != others) continue;
            if (strcmp(r->measured.rungs.axis, "dx [m]") != 0 || strcmp(r->measured.rungs.norm, "E1") != 0) continue;
            int seen = 0;
            for (int k = 0; k < n; k++) seen += strcmp(method[k], by) == 0;
            if (seen) continue;
            memcpy(method[n], by, sizeof by);
            chosen[n++] = r;
        }
    return n;
}

void orders_put_scene(const struct gates *g, const char *scene, FILE *out) {
    const struct gate_result *chosen[CHART_STYLES];
    struct chart_series series[CHART_STYLES];
    int n = choose(g, scene, chosen);
    char title[2 * WORD];
    if (n == 0 && g->declared > 0) fprintf(out, "<p class=\"faint\">No gate has a ladder in space here.</p>\n");
    if (n == 0) return;
    for (int k = 0; k < n; k++) {
        const struct rungs *l = &chosen[k]->measured.rungs;
        series[k] = (struct chart_series){chosen[k]->gate.id, l->n, l->x, l->error, l->counts};
    }
    snprintf(title, sizeof title, "Error against spacing on %.60s", scene);
    fprintf(out, "<figure>\n");
    chart_write(&(struct chart){title, "dx [m]", "E1", n, series, page_order(chosen[0]->gate.lo, chosen[0]->gate.hi)},
                out);
    html_print(out,
               "<figcaption>%s, one ladder a method. Hollow: left out of the fit. <code>make verify</code>"
               "</figcaption></figure>\n",
               title);
}
