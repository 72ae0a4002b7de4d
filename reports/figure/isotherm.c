/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Marching squares: an isotherm crosses an edge of the lattice where the ends lie on either side of the level, at the
 * place that linear interpolation gives.  A crossing belongs to at most two cells, so the crossings form chains that
 * can be followed from edge to edge.  Where all four edges of a cell are crossed its mean decides. */
#include "reports/figure/figure.h"

#include "solver/method.h"

#include <gsl/gsl_interp2d.h>
#include <gsl/gsl_spline2d.h>
#include <math.h>
#include <stdlib.h>

struct chains {
    const struct isotherm_grid *g;
    double level;
    int (*link)[2]; /* by edge: the crossings next to it, -1 where there is none */
    char *crossed, *done;
};

enum { ALONG_X, ALONG_Y }; /* edge = 2 (j nx + i) + its direction; it starts at point (i, j) */

static int edge(const struct isotherm_grid *g, int i, int j, int along) {
    return 2 * (j * g->n[0] + i) + along;
}

static double above(const struct chains *c, int i, int j) {
    return c->g->T[j * c->g->n[0] + i] - c->level;
}

static void place(const struct chains *c, int e, double x[2]) {
    const struct isotherm_grid *g = c->g;
    int along = e % 2, i = e / 2 % g->n[0], j = e / 2 / g->n[0];
    double a = above(c, i, j), b = above(c, i + (along == ALONG_X), j + (along == ALONG_Y));
    x[0] = g->lo[0] + i * g->d[0];
    x[1] = g->lo[1] + j * g->d[1];
    x[along] += a / (a - b) * g->d[along];
}

static void join(struct chains *c, int a, int b) {
    c->link[a][c->link[a][0] >= 0] = b;
    c->link[b][c->link[b][0] >= 0] = a;
    c->crossed[a] = c->crossed[b] = 1;
}

static void visit_cell(struct chains *c, int i, int j) {
    const struct isotherm_grid *g = c->g;
    double v[4] = {above(c, i, j), above(c, i + 1, j), above(c, i + 1, j + 1), above(c, i, j + 1)};
    int side[4] = {edge(g, i, j, ALONG_X), edge(g, i + 1, j, ALONG_Y), edge(g, i, j + 1, ALONG_X),
                   edge(g, i, j, ALONG_Y)};
    int cut[4], n = 0;
    for (int k = 0; k < 4; k++)
        if ((v[k] >= 0) != (v[(k + 1) % 4] >= 0)) cut[n++] = side[k];
    if (n == 2) join(c, cut[0], cut[1]);
    if (n != 4) return;
    int turn = (v[0] + v[1] + v[2] + v[3] >= 0) == (v[0] >= 0);
    join(c, cut[0], cut[turn ? 1 : 3]);
    join(c, cut[2], cut[turn ? 3 : 1]);
}

/* Writes the chain that starts at `e`; its length, m. */
static double follow(struct chains *c, int e, FILE *out) {
    double x[2], last[2], length = 0;
    int first = e, from = -1;
    for (int n = 0; e >= 0; n++) {
        place(c, e, x);
        if (n) length += hypot(x[0] - last[0], x[1] - last[1]);
        fprintf(out, "%.6g,%.6g,%.6g\n", x[0], x[1], c->level);
        last[0] = x[0];
        last[1] = x[1];
        if (c->done[e]) break; /* a loop has closed */
        c->done[e] = 1;
        int next = c->link[e][0] != from ? c->link[e][0] : c->link[e][1];
        if (from == first && next == first) next = -1;
        from = e;
        e = next;
    }
    fprintf(out, "\n");
    return length;
}

/* The point `length` m along the chain that starts at `e`. */
static void find_point(const struct chains *c, int e, double length, double at[2]) {
    double x[2], gone = 0;
    int from = -1;
    place(c, e, at);
    while (gone < length) {
        int next = c->link[e][0] != from ? c->link[e][0] : c->link[e][1];
        if (next < 0) return;
        from = e;
        e = next;
        place(c, e, x);
        gone += hypot(x[0] - at[0], x[1] - at[1]);
        at[0] = x[0];
        at[1] = x[1];
    }
}

int isotherm_trace(const struct isotherm_grid *g, double level, double part, FILE *out, double at[2]) {
    size_t edges = 2 * (size_t)g->n[0] * (size_t)g->n[1];
    struct chains c = {g, level, xcalloc(edges, sizeof *c.link), xcalloc(edges, 1), xcalloc(edges, 1)};
    double longest = 0;
    int lines = 0;
    for (size_t e = 0; e < edges; e++) c.link[e][0] = c.link[e][1] = -1;
    for (int j = 0; j + 1 < g->n[1]; j++)
        for (int i = 0; i + 1 < g->n[0]; i++) visit_cell(&c, i, j);
    for (int loops = 0; loops < 2; loops++) /* open chains from their ends first; what is left is closed */
        for (size_t e = 0; e < edges; e++) {
            if (!c.crossed[e] || c.done[e] || (!loops && c.link[e][1] >= 0)) continue;
            double length = follow(&c, (int)e, out);
            lines++;
            if (length <= longest) continue;
            longest = length;
            find_point(&c, (int)e, part * length, at);
        }
    free(c.link);
    free(c.crossed);
    free(c.done);
    return lines;
}

struct isotherm_grid isotherm_refine(const struct isotherm_grid *g, int times) {
    struct isotherm_grid fine = *g;
    double *at[2];
    for (int a = 0; a < 2; a++) {
        fine.n[a] = times * (g->n[a] - 1) + 1;
        fine.d[a] = g->d[a] / times;
        at[a] = xcalloc((size_t)g->n[a], sizeof *at[a]);
        for (int i = 0; i < g->n[a]; i++) at[a][i] = i;
    }
    fine.T = xcalloc((size_t)fine.n[0] * (size_t)fine.n[1], sizeof *fine.T);
    gsl_spline2d *spline = gsl_spline2d_alloc(gsl_interp2d_bicubic, (size_t)g->n[0], (size_t)g->n[1]);
    gsl_spline2d_init(spline, at[0], at[1], g->T, (size_t)g->n[0], (size_t)g->n[1]);
    for (int j = 0; j < fine.n[1]; j++)
        for (int i = 0; i < fine.n[0]; i++)
            fine.T[j * fine.n[0] + i] = gsl_spline2d_eval(spline, (double)i / times, (double)j / times, NULL, NULL);
    gsl_spline2d_free(spline);
    free(at[0]);
    free(at[1]);
    return fine;
}
