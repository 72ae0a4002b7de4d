/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a published table of errors again, by the paper's protocol and by others. */
#include "reports/figure/compare.h"

#include "references/scene.h"
#include "reports/figure/figure.h"
#include "verification/ladder/command_run.h"
#include "verification/ladder/slope.h"
#include "verification/text/output.h"
#include "reports/figure/published.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

struct cell {
    double printed; /* E1 against the solution as printed */
    double bounded; /* E1 against the solution between walls */
};

struct work {
    const struct compare *c;
    struct published t;
    int choices;
    struct cell *cell; /* [choice][method][column] */
};

static const char *const labels[][2] = {
    {"fo_ssph", "FO-SSPH"}, {"so_ssph", "SO-SSPH"}, {"ftcs", "FTCS"}, {NULL, NULL}};

static const char *label_of(const char *method) {
    for (int i = 0; labels[i][0]; i++)
        if (strcmp(labels[i][0], method) == 0) return labels[i][1];
    return method;
}

static struct cell *cell_of(const struct work *w, int choice, int method, int column) {
    return &w->cell[(choice * w->t.rows + method) * w->t.columns + column];
}

/* The cases first .. last - 1, in parallel, the finest of all methods before the coarser. */
static int run_cases(struct work *w, int first, int last, struct failure *why) {
    int each = w->t.rows * w->t.columns;
    *why = (struct failure){0};
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = first * each; i < last * each; i++) {
        int choice = i / each, column = i % each / w->t.rows, method = i % w->t.rows;
        struct command_run run;
        command_run_line(&run, "run %s %s --dx %s %s", w->c->scene, w->t.method[method], w->t.where[column],
                         w->c->choice[choice].options);
        if (!command_run_note(&run, why))
            *cell_of(w, choice, method, column) =
                (struct cell){command_run_error(&run, w->c->choice[choice].decimals, w->c->choice[choice].late),
                              run.result.error.l1};
        command_run_free(&run);
    }
    return why->status;
}

/* The ladders that a user would type, one a line. */
static void write_ladders(const struct work *w, const char *before, FILE *out) {
    for (int m = 0; m < w->t.rows; m++) {
        fprintf(out, "%sheatladder ladder %s %s %s --dx ", before, w->c->scene, w->t.method[m],
                w->c->choice[0].options);
        for (int i = w->t.columns - 1; i >= 0; i--) fprintf(out, "%s%s", w->t.where[i], i ? "," : "\n");
    }
}

static void write_csv(const struct work *w, FILE *out) {
    figure_head(out, w->c->table_title);
    write_ladders(w, "# command: ", out);
    fprintf(out, "choice,method,dx,published,measured,ratio,last_digits,measured_between_walls\n");
    for (int k = 0; k < w->choices; k++)
        for (int m = 0; m < w->t.rows; m++)
            for (int i = 0; i < w->t.columns; i++) {
                const struct cell *e = cell_of(w, k, m, i);
                fprintf(out, "\"%s\",%s,%s,%s,%.6e,%.5f,%+.0f,%.6e\n", w->c->choice[k].label, w->t.method[m],
                        w->t.where[i], w->t.cell[m][i], e->printed, e->printed / w->t.value[m][i],
                        published_units(w->t.cell[m][i], e->printed), e->bounded);
            }
}

/* Through all dx; coarsest first, as slope.h wants it. */
static struct slope fit(const struct work *w, int method, int published) {
    double x[PUBLISHED_COLUMNS], e[PUBLISHED_COLUMNS];
    int n = w->t.columns;
    for (int i = 0; i < n; i++) {
        x[n - 1 - i] = atof(w->t.where[i]);
        e[n - 1 - i] = published ? w->t.value[method][i] : cell_of(w, 0, method, i)->printed;
    }
    return slope_fit(x, e, n);
}

static void write_protocol(const struct work *w, FILE *out) {
    fprintf(out, "| method | dx [m] | published | measured | ratio | last digit | against the bounded solution |\n"
                 "|---|---:|---:|---:|---:|---:|---:|\n");
    for (int m = 0; m < w->t.rows; m++)
        for (int i = 0; i < w->t.columns; i++) {
            const struct cell *e = cell_of(w, 0, m, i);
            fprintf(out, "| %s | %s | %s | %.4e | %.4f | %+.0f | %.4e |\n", label_of(w->t.method[m]), w->t.where[i],
                    w->t.cell[m][i], e->printed, e->printed / w->t.value[m][i],
                    published_units(w->t.cell[m][i], e->printed), e->bounded);
        }
    fprintf(out, "\n`last digit`: by how many units of its last printed digit the measured number, rounded alike, "
                 "differs.\n\n| method | slope of the published numbers | slope measured (95 %% interval) |\n"
                 "|---|---:|---:|\n");
    for (int m = 0; m < w->t.rows; m++) {
        struct slope s = fit(w, m, 0);
        fprintf(out, "| %s | %.3f | %.3f (%.3f to %.3f) |\n", label_of(w->t.method[m]), fit(w, m, 1).value, s.value,
                s.ci[0], s.ci[1]);
    }
}

static void write_choices(const struct work *w, FILE *out) {
    fprintf(out,
            "\n## What the choices change\n\nMeasured over published, by dx [m].\n\n| choice | options | method |");
    for (int i = 0; i < w->t.columns; i++) fprintf(out, " %s |", w->t.where[i]);
    fprintf(out, "\n|---|---|---|");
    for (int i = 0; i < w->t.columns; i++) fprintf(out, "---:|");
    fprintf(out, "\n");
    for (int k = 0; k < w->choices; k++)
        for (int m = 0; m < w->t.rows; m++) {
            fprintf(out, "| %s | `%s` | %s |", w->c->choice[k].label, w->c->choice[k].options,
                    label_of(w->t.method[m]));
            for (int i = 0; i < w->t.columns; i++)
                fprintf(out, " %.4f |", cell_of(w, k, m, i)->printed / w->t.value[m][i]);
            fprintf(out, "\n");
        }
}

static void write_markdown(const struct work *w, FILE *out) {
    fprintf(out, "# %s\n\nMade by `heatladder report DIR`; one method alone:\n\n", w->c->table_title);
    write_ladders(w, "    ", out);
    fprintf(out, "\n");
    write_protocol(w, out);
    write_choices(w, out);
    fprintf(out, "\n%s\n", w->c->note);
}

/* Points with their fitted line, of the measured or the published errors. */
static void write_points(const struct work *w, int m, int published, FILE *out) {
    struct slope s = fit(w, m, published);
    const char *what = published ? "published" : "measured", *label = label_of(w->t.method[m]);
    double mean_x = 0, mean_e = 0;
    fprintf(out, "\n\n# %s %s\ndx [m],\"%s %s (slope %.2f)\"\n", w->t.method[m], what, label, what, s.value);
    for (int i = 0; i < w->t.columns; i++) {
        double e = published ? w->t.value[m][i] : cell_of(w, 0, m, i)->printed;
        mean_x += log(atof(w->t.where[i])) / w->t.columns;
        mean_e += log(e) / w->t.columns;
        fprintf(out, "%s,%.6e\n", w->t.where[i], e);
    }
    fprintf(out, "\n\n# %s line %s\ndx [m],fit\n", w->t.method[m], what);
    for (int i = 0; i < w->t.columns; i += w->t.columns - 1) {
        double x = atof(w->t.where[i]);
        fprintf(out, "%s,%.6e\n", w->t.where[i], exp(mean_e + s.value * (log(x) - mean_x)));
    }
}

struct triangle {
    int order;
    double x, e, right, top;
};

/* Of the order that is expected of method m, below its errors. */
static struct triangle triangle_of(const struct work *w, int m) {
    double a = atof(w->t.where[0]), b = atof(w->t.where[w->t.columns - 1]), slope = fit(w, m, 0).value;
    struct triangle t = {.order = (int)round(slope), .x = a * pow(b / a, 0.3)};
    t.e = 0.42 * cell_of(w, 0, m, 0)->printed * pow(t.x / a, slope);
    t.right = t.x * pow(b / a, 0.2);
    t.top = t.e * pow(t.right / t.x, t.order);
    return t;
}

/* One for each order, below the last method that has it. */
static void write_triangles(const struct work *w, FILE *out) {
    struct triangle t[PUBLISHED_ROWS];
    int n = 0;
    for (int m = 0; m < w->t.rows; m++) {
        n += m == 0 || triangle_of(w, m).order != t[n - 1].order;
        t[n - 1] = triangle_of(w, m);
    }
    fprintf(out, "\n\n# triangles\ndx [m],E\n");
    for (int i = 0; i < n; i++)
        fprintf(out, "%.6g,%.6g\n%.6g,%.6g\n%.6g,%.6g\n%.6g,%.6g\n\n", t[i].x, t[i].e, t[i].right, t[i].e, t[i].right,
                t[i].top, t[i].x, t[i].e);
    fprintf(out, "\n\n# orders\ndx [m],E,text\n");
    for (int i = 0; i < n; i++)
        fprintf(out, "%.6g,%.6g,order %d\n", sqrt(t[i].x * t[i].right), 0.74 * t[i].e, t[i].order);
}

static void write_figure(const struct work *w, FILE *out) {
    figure_head(out, w->c->figure_title);
    write_ladders(w, "# command: ", out);
    for (int m = 0; m < w->t.rows; m++) {
        write_points(w, m, 0, out);
        write_points(w, m, 1, out);
    }
    write_triangles(w, out);
}

static int write_pages(const struct work *w, const char *dir, struct failure *why) {
    struct output page[3];
    write_csv(w, output_open(&page[0], "%s/%s.csv", dir, w->c->table));
    write_markdown(w, output_open(&page[1], "%s/%s.md", dir, w->c->table));
    write_figure(w, output_open(&page[2], "%s/%s.csv", dir, w->c->figure));
    return output_close(page, 3, why);
}

int compare_write(const struct compare *c, const char *dir, struct failure *why) {
    struct work w = {.c = c};
    int status = published_read(&w.t, c->table, why);
    if (status) return status;
    while (c->choice[w.choices].label) w.choices++;
    w.cell = xcalloc((size_t)(w.choices * w.t.rows * w.t.columns), sizeof *w.cell);
    double start = omp_get_wtime();
    status = run_cases(&w, 0, 1, why);
    if (!status) {
        printf("  %s: %d runs by the paper's protocol in %.2f s\n", c->table, w.t.rows * w.t.columns,
               omp_get_wtime() - start);
        status = run_cases(&w, 1, w.choices, why);
    }
    if (!status) status = write_pages(&w, dir, why);
    free(w.cell);
    return status;
}
