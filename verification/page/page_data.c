/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ladders of gates as blocks for gnuplot.  Block "orders" has a line a ladder, ordered by scene; "groups" has the
 * place of each scene's name; "SCENE K" has the errors of the scene's K-th method over dx. */
#include "verification/page/page.h"

#include "references/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WORD = 80, METHODS = 6 /* curves of a scene */ };
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

static void put_orders(const struct gates *g, FILE *out) {
    int place = 0;
    fprintf(out, "\n\n# orders\nplace,low,high,order,holds,gate\n");
    for (int s = 0; scenes[s]; s++) {
        int before = place;
        for (int i = 0; i < g->declared; i++) {
            const struct gate_result *r = &g->result[i];
            if (!is_of(r, scenes[s]->name)) continue;
            fprintf(out, "%d,%.6g,%.6g,%.6g,%d,%s\n", place++, r->gate.lo, r->gate.hi, r->measured.value,
                    gates_holds(r), r->gate.id);
        }
        if (place > before) place += 3; /* a gap */
    }
}

static void put_groups(const struct gates *g, FILE *out) {
    int place = 0;
    fprintf(out, "\n\n# groups\nplace,scene\n");
    for (int s = 0; scenes[s]; s++) {
        int lines = 0;
        for (int i = 0; i < g->declared; i++) lines += is_of(&g->result[i], scenes[s]->name);
        if (lines) fprintf(out, "%g,%s\n", place + (lines - 1) / 2.0, scenes[s]->name), place += lines + 3;
    }
}

/* The first ladder in E1 over dx of each method, the subject's first; returns their number. */
static int choose(const struct gates *g, const char *scene, const struct gate_result *chosen[METHODS]) {
    char method[METHODS][WORD], of[WORD], by[WORD];
    int n = 0;
    for (int others = 0; others < 2; others++)
        for (int i = 0; i < g->declared && n < METHODS; i++) {
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

static void put_errors(const struct gate_result *r, const char *scene, int k, FILE *out) {
    const struct rungs *l = &r->measured.rungs;
    fprintf(out, "\n\n# %s %d\n%s,%s,counts\n", scene, k, l->axis, r->gate.id);
    for (int i = 0; i < l->n; i++)
        if (l->error[i] > 0) fprintf(out, "%.6g,%.6e,%d\n", l->x[i], l->error[i], l->counts[i]);
}

void page_data_write(const struct gates *g, const char *command, FILE *out) {
    fprintf(out, "# title: Order reached and order expected, ladder by ladder\n# command: heatladder %s\n", command);
    put_orders(g, out);
    put_groups(g, out);
    for (int s = 0; scenes[s]; s++) {
        const struct gate_result *chosen[METHODS];
        int n = choose(g, scenes[s]->name, chosen);
        for (int k = 0; k < n; k++) put_errors(chosen[k], scenes[s]->name, k + 1, out);
    }
}
