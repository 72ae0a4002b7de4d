/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the commands of a figure in parallel and writes it as one file of named blocks. */
#include "reports/figure/figure.h"

#include "references/scene.h"
#include "verification/judge/command_run.h"
#include "verification/text/output.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

enum { SERIES_MAX = 10, FINE = 800, SIDE = 80 };

void figure_head(FILE *out, const char *title) {
    fprintf(out, "# title: %s\n# made by: heatladder report DIR\n", title);
}

static void head(FILE *out, const char *name, const char *command, const char *columns) {
    fprintf(out, "\n\n# %s\n# heatladder %s\n%s\n", name, command, columns);
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
    char title[80];
    snprintf(title, sizeof title, "%s computed", s->name);
    head(out, title, s->command, "x [m],y [m],T [K]");
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX];
        field_place(f, i, x);
        fprintf(out, "%.6g,%.6g,%.6g\n%s", x[0], x[1], f->T[i], (i + 1) % (size_t)f->shape[0] ? "" : "\n");
    }
    snprintf(title, sizeof title, "%s error", s->name);
    head(out, title, s->command, "E [%]");
    fprintf(out, "%.4g\n", 100 * run->result.error.l1);
}

/* The exact solution on a lattice over the domain of the field. */
static void write_exact_lattice(const struct command_run *run, const struct figure_series *s, FILE *out) {
    const struct field *f = &run->field;
    const struct problem *p = &run->typed.experiment.problem;
    double lo[2], hi[2];
    char title[80];
    for (int a = 0; a < 2; a++) {
        lo[a] = fmax(p->lo[a], f->x[a][0] - f->spacing[a]);
        hi[a] = fmin(p->hi[a], f->x[a][f->shape[a] - 1] + f->spacing[a]);
    }
    snprintf(title, sizeof title, "%s exact", s->name);
    head(out, title, s->command, "x [m],y [m],T [K]");
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
    head(out, s->name, s->command, "x [m],T [K]");
    if (s->part == FIGURE_EXACT)
        write_exact(run, out);
    else if (s->part == FIGURE_CUT)
        write_cut(run, s->at, out);
    else
        write_rod(run, out);
}

static void write_head(const struct figure *figure, int n, FILE *out) {
    figure_head(out, figure->title);
    for (int i = 0; i < n; i++) {
        const struct figure_series *s = &figure->series[i];
        int again = 0;
        for (int j = 0; j < i; j++) again |= strcmp(figure->series[j].command, s->command) == 0;
        if (!again && s->part != FIGURE_EXACT) fprintf(out, "# command: heatladder %s\n", s->command);
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
    struct command_run *run = xcalloc(SERIES_MAX, sizeof *run);
    char *text[SERIES_MAX] = {0};
    struct output page;
    int n = 0, status = STATUS_OK;
    while (n < SERIES_MAX && figure->series[n].name) n++;
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < n; i++) {
        size_t size;
        FILE *out = output_stream(&text[i], &size);
        command_run_line(&run[i], "%s", figure->series[i].command);
        if (!run[i].result.failure.status) write_series(&figure->series[i], &run[i], out);
        fclose(out);
    }
    for (int i = 0; i < n && !status; i++) status = command_run_check(&run[i], why);
    if (!status) {
        FILE *out = output_open(&page, "%s/%s.csv", dir, figure->name);
        write_head(figure, n, out);
        for (int i = 0; i < n; i++) fputs(text[i], out);
        status = output_close(&page, 1, why);
    }
    for (int i = 0; i < n; i++) {
        free(text[i]);
        command_run_free(&run[i]);
    }
    free(run);
    return status;
}
