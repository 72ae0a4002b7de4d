/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a published table of errors again, by the paper's protocol and by others. */
#include "reports/figure/compare.h"

#include "references/scene.h"
#include "reports/figure/document.h"
#include "reports/figure/figure.h"
#include "verification/judge/run.h"
#include "verification/judge/slope.h"
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
                              run.result.error[NORM_L1]};
        command_run_free(&run);
    }
    return why->status;
}

/* Through all dx, coarsest first (slope.h). */
static struct slope fit(const struct work *w, int method, int published) {
    double x[PUBLISHED_COLUMNS], e[PUBLISHED_COLUMNS];
    int n = w->t.columns;
    for (int i = 0; i < n; i++) {
        x[n - 1 - i] = atof(w->t.where[i]);
        e[n - 1 - i] = published ? w->t.value[method][i] : cell_of(w, 0, method, i)->printed;
    }
    return slope_fit(x, e, n);
}

static void write_protocol(const struct work *w, struct document *d) {
    struct table t =
        table_headed(1, "method|dx [m]|published|measured|ratio|last digit|against the bounded solution");
    for (int m = 0; m < w->t.rows; m++)
        for (int i = 0; i < w->t.columns; i++) {
            const struct cell *e = cell_of(w, 0, m, i);
            table_add(&t, "%s|%s|%s|%.4e|%.4f|%+.0f|%.4e", label_of(w->t.method[m]), w->t.where[i], w->t.cell[m][i],
                      e->printed, e->printed / w->t.value[m][i], published_units(w->t.cell[m][i], e->printed),
                      e->bounded);
        }
    document_table(d, &t);
    document_text(d, "Last digit: the difference in units of the last printed digit, after rounding.");
    t = table_headed(1, "method|slope of the published numbers|slope measured|95 % interval");
    for (int m = 0; m < w->t.rows; m++) {
        struct slope s = fit(w, m, 0);
        table_add(&t, "%s|%.3f|%.3f|%.3f to %.3f", label_of(w->t.method[m]), fit(w, m, 1).value, s.value, s.ci[0],
                  s.ci[1]);
    }
    document_table(d, &t);
}

static void write_choices(const struct work *w, struct document *d) {
    struct table t = table_create(3 + w->t.columns, 3);
    document_heading(d, "What the choices change");
    document_text(d, "Measured over published, by dx [m].");
    table_add(&t, "choice|options|method");
    for (int i = 0; i < w->t.columns; i++) table_add(&t, "%s", w->t.where[i]);
    for (int k = 0; k < w->choices; k++)
        for (int m = 0; m < w->t.rows; m++) {
            table_add(&t, "%s|`%s`|%s", w->c->choice[k].label, w->c->choice[k].options, label_of(w->t.method[m]));
            for (int i = 0; i < w->t.columns; i++)
                table_add(&t, "%.4f", cell_of(w, k, m, i)->printed / w->t.value[m][i]);
        }
    document_table(d, &t);
    for (int i = 0; w->c->note[i]; i++) document_text(d, "%s", w->c->note[i]);
}

/* One block a method, of the measured or the published errors. */
static void write_points(const struct work *w, int m, int published, FILE *out) {
    const char *what = published ? "published" : "measured", *label = label_of(w->t.method[m]);
    char columns[80];
    snprintf(columns, sizeof columns, "dx [m],\"%s %s (slope %.2f)\"", label, what, fit(w, m, published).value);
    figure_block(out, columns, "%s %s", w->t.method[m], what);
    for (int i = 0; i < w->t.columns; i++)
        fprintf(out, "%s,%.6e\n", w->t.where[i], published ? w->t.value[m][i] : cell_of(w, 0, m, i)->printed);
}

/* The ladder of a method, as typed. */
static void ladder_of(const struct work *w, int m, char *text, size_t size) {
    size_t used =
        (size_t)snprintf(text, size, "ladder %s %s %s --dx ", w->c->scene, w->t.method[m], w->c->choice[0].options);
    for (int i = w->t.columns - 1; i >= 0 && used < size; i--)
        used += (size_t)snprintf(text + used, size - used, "%s%s", w->t.where[i], i ? "," : "");
}

static int write_pages(const struct work *w, const char *dir, struct failure *why) {
    struct output figure;
    struct document d;
    char ladder[300];
    FILE *out = output_open(&figure, "%s/%s.csv", dir, w->c->figure);
    document_open(&d, dir, w->c->table, w->c->table_title);
    fprintf(out, "# title: %s\n# made by: heatladder report DIR\n", w->c->figure_title);
    for (int m = 0; m < w->t.rows; m++) {
        ladder_of(w, m, ladder, sizeof ladder);
        document_command(&d, "%s", ladder);
        fprintf(out, "# command: heatladder %s\n", ladder);
    }
    for (int m = 0; m < w->t.rows; m++) write_points(w, m, 0, out), write_points(w, m, 1, out);
    write_protocol(w, &d);
    write_choices(w, &d);
    int status = output_close(&figure, 1, why);
    if (!status) status = document_close(&d, why);
    document_drop(&d);
    return status;
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
