/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ladders of gates as blocks for gnuplot.  Block "orders" has a line a ladder and a row a scene; "groups" names
 * the rows; "SCENE K" has the errors of the scene's K-th method over dx. */
#include "verification/report/page.h"

#include "references/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WORD = 80, METHODS = 8 /* curves of a scene */ };
static const double SPREAD = 0.72;       /* rows */
static const char subject[] = "so_ssph"; /* the first curve */

/* The two words after "ladder": 1, or 0 where the gate has no ladder with an order. */
static int words_of(const struct gate_result *r, char scene[WORD], char method[WORD]) {
    return r->measured.rungs.n > 0 && isfinite(r->measured.value) &&
           sscanf(r->typed, "ladder %79s %79s", scene, method) == 2;
}

static int is_of(const struct gate_result *r, const char *scene) {
    char of[WORD], method[WORD];
    return words_of(r, of, method) && strcmp(of, scene) == 0;
}

static double middle(const struct gate_result *r) {
    return (r->gate.lo + r->gate.hi) / 2;
}

/* The whole number in the middle of the band; else, as at a front with k(T), its middle. */
static double expected(const struct gate_result *r) {
    double whole = round(middle(r));
    return r->gate.lo <= whole && whole <= r->gate.hi ? whole : middle(r);
}

/* The offset of the gate i from the row of its scene: its ladders are spread over the row. */
static double offset(const struct gates *g, int i, const char *scene) {
    int before = 0, all = 0;
    for (int k = 0; k < g->declared; k++) {
        int same = is_of(&g->result[k], scene);
        before += same && k < i;
        all += same;
    }
    return all > 1 ? SPREAD * (before / (all - 1.0) - 0.5) : 0;
}

static void put_order(const struct gate_result *r, double place, FILE *out) {
    const struct measured *m = &r->measured;
    int has_interval = m->ci[0] < m->ci[1];
    fprintf(out, "%.4g,%.6g,%.6g,%.6g,%.6g,%.6g,%d,%s\n", place, r->gate.lo, r->gate.hi, m->value,
            has_interval ? m->ci[0] : m->value, has_interval ? m->ci[1] : m->value, gates_holds(r), r->gate.id);
}

static int has_ladders(const struct gates *g, const char *scene) {
    int lines = 0;
    for (int i = 0; i < g->declared; i++) lines += is_of(&g->result[i], scene);
    return lines > 0;
}

static void put_orders(const struct gates *g, FILE *out) {
    int row = 0;
    fprintf(out, "\n\n# orders\nplace,low,high,order,order from,order to,holds,gate\n");
    for (int s = 0; scenes[s]; s++) {
        const char *scene = scenes[s]->name;
        for (int i = 0; i < g->declared; i++)
            if (is_of(&g->result[i], scene)) put_order(&g->result[i], row + offset(g, i, scene), out);
        row += has_ladders(g, scene);
    }
}

static void put_groups(const struct gates *g, FILE *out) {
    int row = 0;
    fprintf(out, "\n\n# groups\nrow,scene\n");
    for (int s = 0; scenes[s]; s++)
        if (has_ladders(g, scenes[s]->name)) fprintf(out, "%d,%s\n", row++, scenes[s]->name);
}

static int is_high(const struct gate_result *r) {
    return middle(r) > 2.5;
}

static int same_curve(const struct gate_result *a, const struct gate_result *b) {
    char scene[WORD], method[WORD], other[WORD];
    words_of(a, scene, method);
    words_of(b, scene, other);
    return strcmp(method, other) == 0 && is_high(a) == is_high(b);
}

/* The first ladder in E1 over dx of each method, and its first of a higher order than two; the subject's first.
 * Returns their number. */
static int choose(const struct gates *g, const char *scene, const struct gate_result *chosen[METHODS]) {
    char of[WORD], by[WORD];
    int n = 0;
    for (int others = 0; others < 2; others++)
        for (int i = 0; i < g->declared && n < METHODS; i++) {
            const struct gate_result *r = &g->result[i];
            if (!words_of(r, of, by) || strcmp(of, scene) != 0 || (strcmp(by, subject) != 0) != others) continue;
            if (strcmp(r->measured.rungs.axis, "dx [m]") != 0 || strcmp(r->measured.rungs.norm, "E1") != 0) continue;
            int seen = 0;
            for (int k = 0; k < n; k++) seen += same_curve(chosen[k], r);
            if (!seen) chosen[n++] = r;
        }
    return n;
}

/* Curves on top of each other: the same x, errors within 3 %. */
static int coincides(const struct gate_result *a, const struct gate_result *b) {
    const struct rungs *l = &a->measured.rungs, *m = &b->measured.rungs;
    int apart = l->n != m->n;
    for (int i = 0; i < l->n && !apart; i++) {
        int drawn = l->error[i] > 0;
        apart = fabs(l->x[i] / m->x[i] - 1) > 1e-6 || drawn != (m->error[i] > 0) ||
                (drawn && fabs(l->error[i] / m->error[i] - 1) > 0.03);
    }
    return !apart;
}

/* The curve k, with the names of the later ones that it coincides with; they are set to NULL. */
static void put_errors(const struct gate_result *chosen[METHODS], int n, int k, int block, const char *scene,
                       FILE *out) {
    const struct gate_result *r = chosen[k];
    const struct rungs *l = &r->measured.rungs;
    char of[WORD], method[WORD];
    words_of(r, of, method);
    fprintf(out, "\n\n# %s %d\n%s,%s", scene, block, l->axis, method);
    for (int i = k + 1; i < n; i++) {
        if (!chosen[i] || !coincides(r, chosen[i])) continue;
        words_of(chosen[i], of, method);
        fprintf(out, " = %s", method);
        chosen[i] = NULL;
    }
    fprintf(out, "%s,counts,expected order\n", is_high(r) ? " of order 4" : "");
    for (int i = 0; i < l->n; i++)
        if (l->error[i] > 0) fprintf(out, "%.6g,%.6e,%d,%.3g\n", l->x[i], l->error[i], l->counts[i], expected(r));
}

void page_data_write(const struct gates *g, const char *command, FILE *out) {
    fprintf(out, "# title: Order of each ladder in the band of its gate\n# command: heatladder %s\n", command);
    put_orders(g, out);
    put_groups(g, out);
    for (int s = 0; scenes[s]; s++) {
        const struct gate_result *chosen[METHODS];
        int n = choose(g, scenes[s]->name, chosen), block = 0;
        for (int k = 0; k < n; k++)
            if (chosen[k]) put_errors(chosen, n, k, ++block, scenes[s]->name, out);
    }
}
