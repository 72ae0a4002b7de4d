/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the commands of a figure in parallel and writes it as one file of named blocks. */
#include "reports/figure/figure.h"

#include "references/scene.h"
#include "reports/figure/reading.h"
#include "verification/judge/run.h"
#include "verification/text/output.h"

#include <math.h>
#include <omp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { FINE = 800, SIDE = 80 };

void figure_head(FILE *out, const char *title, const char *command, ...) {
    va_list arguments;
    va_start(arguments, command);
    fprintf(out, "# title: %s\n# made by: heatladder report DIR\n# command: heatladder ", title);
    vfprintf(out, command, arguments);
    fputc('\n', out);
    va_end(arguments);
}

void figure_block(FILE *out, const char *columns, const char *name, ...) {
    va_list arguments;
    va_start(arguments, name);
    fprintf(out, "\n\n# ");
    vfprintf(out, name, arguments);
    fprintf(out, "\n%s\n", columns);
    va_end(arguments);
}

static void write_rod(const struct command_run *run, FILE *out) {
    const struct field *f = &run->field;
    for (size_t i = 0; i < f->n; i++) fprintf(out, "%.9g,%.9g\n", f->x[0][i], f->T[i]);
}

/* The row of particles nearest to y = at. */
static void write_cut(const struct command_run *run, double at, FILE *out) {
    const struct field *f = &run->field;
    size_t nearest = 0, row = (size_t)f->shape[0];
    for (size_t j = 1; j < (size_t)f->shape[1]; j++)
        if (fabs(f->x[1][j] - at) < fabs(f->x[1][nearest] - at)) nearest = j;
    for (size_t i = 0; i < row; i++) fprintf(out, "%.9g,%.9g\n", f->x[0][i], f->T[nearest * row + i]);
}

static void write_exact(const struct command_run *run, FILE *out) {
    const struct command *r = &run->typed;
    const struct problem *p = &r->experiment.problem;
    double x[2] = {0, r->at.count == 2 ? r->at.value[1] : 0};
    for (int i = 0; i <= FINE; i++) {
        x[0] = p->lo[0] + (p->hi[0] - p->lo[0]) * i / FINE;
        fprintf(out, "%.9g,%.9g\n", x[0], command_run_exact(run, x, r->time.value[0]));
    }
}

/* A row of a lattice ends with a blank line. */
static void write_lattice(const struct command_run *run, const struct figure_series *s, FILE *out) {
    const struct field *f = &run->field;
    figure_block(out, "x [m],y [m],T [K]", "%s computed", s->name);
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX];
        field_place(f, i, x);
        fprintf(out, "%.6g,%.6g,%.6g\n%s", x[0], x[1], f->T[i], (i + 1) % (size_t)f->shape[0] ? "" : "\n");
    }
    figure_block(out, "E [%]", "%s error", s->name);
    fprintf(out, "%.4g\n", 100 * run->result.error[NORM_L1]);
}

static void write_cloud(const struct command_run *run, FILE *out) {
    const struct field *f = &run->field;
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX];
        field_place(f, i, x);
        fprintf(out, "%.6g,%.6g,%.6g\n", x[0], x[1], f->T[i]);
    }
}

/* A cloud at its points; a box in the layer nearest to z = at. */
static void write_error(const struct command_run *run, double at, FILE *out) {
    const struct field *f = &run->field;
    size_t layer = 0, n = f->dim == 3 ? (size_t)f->shape[0] * (size_t)f->shape[1] : f->n;
    for (size_t k = 1; f->dim == 3 && k < (size_t)f->shape[2]; k++)
        if (fabs(f->x[2][k] - at) < fabs(f->x[2][layer] - at)) layer = k;
    for (size_t i = layer * n; i < layer * n + n; i++) {
        double x[DIM_MAX];
        field_place(f, i, x);
        fprintf(out, "%.5g,%.5g,%.4g\n%s", x[0], x[1], fabs(f->T[i] - command_run_exact(run, x, f->time)),
                f->dim == 3 && (i + 1) % (size_t)f->shape[0] == 0 ? "\n" : "");
    }
}

/* The exact solution on a lattice over the domain of the field. */
static void write_exact_lattice(const struct command_run *run, const struct figure_series *s, FILE *out) {
    const struct field *f = &run->field;
    const struct problem *p = &run->typed.experiment.problem;
    double lo[2], hi[2];
    for (int a = 0; a < 2; a++) {
        lo[a] = fmax(p->lo[a], f->x[a][0] - f->spacing[a]);
        hi[a] = fmin(p->hi[a], f->x[a][f->shape[a] - 1] + f->spacing[a]);
    }
    figure_block(out, "x [m],y [m],T [K]", "%s exact", s->name);
    for (int j = 0; j <= SIDE; j++) {
        for (int i = 0; i <= SIDE; i++) {
            const double x[2] = {lo[0] + (hi[0] - lo[0]) * i / SIDE, lo[1] + (hi[1] - lo[1]) * j / SIDE};
            fprintf(out, "%.6g,%.6g,%.6g\n", x[0], x[1], command_run_exact(run, x, f->time));
        }
        fprintf(out, "\n");
    }
}

static void write_series(const struct figure_series *s, const struct command_run *run, FILE *out) {
    if (s->part == FIGURE_ISOTHERMS) {
        write_lattice(run, s, out);
        write_exact_lattice(run, s, out);
        return;
    }
    figure_block(out,
                 s->part == FIGURE_ERROR   ? "x [m],y [m],|T - T_exact| [K]"
                 : s->part == FIGURE_CLOUD ? "x [m],y [m],T [K]"
                                           : "x [m],T [K]",
                 "%s", s->name);
    if (s->part == FIGURE_EXACT)
        write_exact(run, out);
    else if (s->part == FIGURE_CUT)
        write_cut(run, s->at, out);
    else if (s->part == FIGURE_CLOUD)
        write_cloud(run, out);
    else if (s->part == FIGURE_ERROR)
        write_error(run, s->at, out);
    else
        write_rod(run, out);
}

static int write_rows(const struct figure_series *s, FILE *out, struct failure *why) {
    int n = 0;
    while (s->value[n]) n++;
    struct reading *r = xcalloc((size_t)n, sizeof *r);
    for (int i = 0; i < n; i++) reading_set(&r[i], s->command, s->value[i]);
    int status = reading_run(r, n, why);
    figure_block(out, s->columns, "%s", s->name);
    for (int i = 0; i < n && !status; i++) reading_row(&r[i], s->keys, out);
    reading_free(r, n);
    free(r);
    return status;
}

static int write_block(const struct figure_series *s, FILE *out, struct failure *why) {
    struct command_run run;
    if (s->part == FIGURE_ROWS) return write_rows(s, out, why);
    int status = command_run_line(&run, "%s", s->command);
    if (!status)
        write_series(s, &run, out);
    else
        command_run_check(&run, why);
    command_run_free(&run);
    return status;
}

/* A command is named once. */
static void write_commands(const struct figure *figure, FILE *out) {
    for (const struct figure_series *s = figure->series; s->name; s++) {
        const struct figure_series *same = figure->series;
        while (same < s && strcmp(same->command, s->command) != 0) same++;
        if (same < s || s->part == FIGURE_EXACT) continue;
        fprintf(out, "# command: heatladder ");
        fprintf(out, s->command, s->value ? *s->value : "");
        fputc('\n', out);
    }
}

int figure_pages(const struct figure_page *pages, size_t count, const char *dir, struct failure *why) {
    int status = STATUS_OK;
    for (size_t i = 0; i < count && !status; i++) {
        struct output page;
        double start = omp_get_wtime();
        status = pages[i].write(output_open(&page, "%s/%s.csv", dir, pages[i].name), why);
        if (!status) status = output_close(&page, 1, why);
        output_drop(&page, 1);
        if (!status) printf("%s/%s.csv (%.1f s)\n", dir, pages[i].name, omp_get_wtime() - start);
        fflush(stdout);
    }
    return status;
}

int figure_write(const struct figure *figure, const char *dir, struct failure *why) {
    struct output page;
    int n = 0, status = STATUS_OK;
    while (figure->series[n].name) n++;
    char **text = xcalloc((size_t)n, sizeof *text);
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < n; i++) {
        size_t size;
        struct failure failed;
        FILE *out = output_stream(&text[i], &size);
        int bad = write_block(&figure->series[i], out, &failed);
        fclose(out);
#pragma omp critical(figure_failure)
        if (bad) status = bad, *why = failed;
    }
    FILE *out = output_open(&page, "%s/%s.csv", dir, figure->name);
    fprintf(out, "# title: %s\n# made by: heatladder report DIR\n", figure->title);
    write_commands(figure, out);
    for (int i = 0; i < n; i++) fputs(text[i], out), free(text[i]);
    if (!status) status = output_close(&page, 1, why);
    output_drop(&page, 1);
    free(text);
    return status;
}

int figure_write_all(const struct figure *figures, const char *dir, struct failure *why) {
    for (; figures->name; figures++)
        if (figure_write(figures, dir, why)) return why->status;
    return STATUS_OK;
}
