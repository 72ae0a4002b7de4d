/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs what a figure shows, in parallel, and writes it as one file of named blocks. */
#include "reports/figure/figure.h"

#include "references/scene.h"
#include "verification/ladder/command_run.h"
#include "verification/text/output.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

enum { SERIES_MAX = 10, FINE = 800, REFINE = 4 };

void figure_head(FILE *out, const char *title) {
    fprintf(out, "# title: %s\n# made by: heatladder report DIR\n", title);
}

static void head(FILE *out, const char *name, const char *command, const char *columns) {
    fprintf(out, "\n\n# %s\n# heatladder %s\n%s\n", name, command, columns);
}

static double initial(const struct command_run *run, size_t i) {
    double x[2] = {run->field.x[i], run->field.y ? run->field.y[i] : 0};
    return run->typed.experiment.problem.initial(&run->typed.experiment.problem, x);
}

static void write_rod(const struct command_run *run, int start, FILE *out) {
    const struct field *f = &run->field;
    for (size_t i = 0; i < f->n; i++) fprintf(out, "%.9g,%.9g\n", f->x[i], start ? initial(run, i) : f->T[i]);
}

static void write_rows(const struct command_run *run, FILE *out) {
    const struct field *f = &run->field;
    for (size_t i = 0; i < f->n; i++) {
        fprintf(out, "%.9g,%.9g,%.9g\n", f->x[i], f->y[i], initial(run, i));
        if ((i + 1) % (size_t)f->shape[0] == 0) fprintf(out, "\n");
    }
}

/* The row of particles nearest to y = at. */
static void write_cut(const struct command_run *run, double at, FILE *out) {
    const struct field *f = &run->field;
    size_t nearest = 0;
    for (size_t i = 1; i < f->n; i++)
        if (fabs(f->y[i] - at) < fabs(f->y[nearest] - at)) nearest = i;
    for (size_t i = 0; i < f->n; i++)
        if (fabs(f->y[i] - f->y[nearest]) < f->spacing[1] / 2) fprintf(out, "%.9g,%.9g\n", f->x[i], f->T[i]);
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

/* The block "NAME what", and with it, of the exact solution, "NAME levels": where to write them. */
static void trace(const struct figure *figure, const struct isotherm_grid *g, const struct figure_series *s,
                  const char *what, int labels, FILE *out) {
    char title[80];
    double middle[2], (*at)[3] = xcalloc(64, sizeof *at);
    int n = 0;
    snprintf(title, sizeof title, "%s %s", s->name, what);
    head(out, title, s->command, "x [m],y [m],T [K]");
    for (double T = figure->level[0]; T < figure->level[2] + figure->level[1] / 2 && n < 64; T += figure->level[1]) {
        double part = n % 2 ? 0.35 : 0.6; /* so that labels of neighbours do not meet */
        if (isotherm_trace(g, T, part, out, middle) == 0) continue;
        at[n][0] = middle[0];
        at[n][1] = middle[1];
        at[n++][2] = T;
    }
    if (labels) {
        snprintf(title, sizeof title, "%s levels", s->name);
        head(out, title, s->command, "x [m],y [m],T [K]");
        for (int i = 0; i < n; i++) fprintf(out, "%.6g,%.6g,%.6g\n", at[i][0], at[i][1], at[i][2]);
    }
    free(at);
}

/* The value beyond the walls at x, from the nearest point inside: a ghost, as the walls' option has it. */
static double beyond(const struct command_run *run, const double x[2], double inside) {
    const struct problem *p = &run->typed.experiment.problem;
    double sum = 0;
    int sides = 0;
    for (int a = 0; a < 2; a++) {
        if (x[a] > p->lo[a] && x[a] < p->hi[a]) continue;
        double wall = p->wall(p, (enum side)(2 * a + (x[a] >= p->hi[a])), x);
        sum += run->typed.experiment.options.walls == WALLS_FIXED ? wall : 2 * wall - inside;
        sides++;
    }
    return sum / sides; /* in a corner the mean of both */
}

/* The particles' temperatures with one layer of ghosts around them.  The caller frees T. */
static struct isotherm_grid with_ghosts(const struct command_run *run) {
    const struct field *f = &run->field;
    int nx = f->shape[0], ny = f->shape[1];
    struct isotherm_grid g = {{nx + 2, ny + 2},
                              {f->x[0] - f->spacing[0], f->y[0] - f->spacing[1]},
                              {f->spacing[0], f->spacing[1]},
                              xcalloc((size_t)(nx + 2) * (size_t)(ny + 2), sizeof *g.T)};
    for (int j = 0; j < ny + 2; j++)
        for (int i = 0; i < nx + 2; i++) {
            int near[2] = {i < 1 ? 0 : i > nx ? nx - 1 : i - 1, j < 1 ? 0 : j > ny ? ny - 1 : j - 1};
            double inside = f->T[near[1] * nx + near[0]], x[2] = {g.lo[0] + i * g.d[0], g.lo[1] + j * g.d[1]};
            int is_ghost = i < 1 || i > nx || j < 1 || j > ny;
            g.T[j * (nx + 2) + i] = is_ghost ? beyond(run, x, inside) : inside;
        }
    return g;
}

/* Up to the walls and to the ghosts behind them; both by the same lines, the exact one from values on the refined
 * lattice, which are a wall's own behind it. */
static void write_isotherms(const struct figure *figure, const struct figure_series *s, const struct command_run *run,
                            FILE *out) {
    const struct problem *p = &run->typed.experiment.problem;
    struct isotherm_grid g = with_ghosts(run), fine = isotherm_refine(&g, REFINE);
    char title[80];
    trace(figure, &fine, s, "computed", 0, out);
    for (int j = 0; j < fine.n[1]; j++)
        for (int i = 0; i < fine.n[0]; i++) {
            double x[2] = {fine.lo[0] + i * fine.d[0], fine.lo[1] + j * fine.d[1]};
            for (int a = 0; a < 2; a++) x[a] = fmin(fmax(x[a], p->lo[a]), p->hi[a]);
            fine.T[j * fine.n[0] + i] = command_run_exact(run, x, run->field.time);
        }
    trace(figure, &fine, s, "exact", 1, out);
    snprintf(title, sizeof title, "%s error", s->name);
    head(out, title, s->command, "E [%]");
    fprintf(out, "%.4g\n", 100 * run->result.error.l1);
    free(fine.T);
    free(g.T);
}

static void write_series(const struct figure *figure, const struct figure_series *s, const struct command_run *run,
                         FILE *out) {
    int rod = run->typed.experiment.problem.dim == 1;
    if (s->part == FIGURE_ISOTHERMS) {
        write_isotherms(figure, s, run, out);
        return;
    }
    int surface = s->part == FIGURE_START && !rod;
    head(out, s->name, s->command, surface ? "x [m],y [m],T [K]" : "x [m],T [K]");
    if (s->part == FIGURE_EXACT)
        write_exact(run, out);
    else if (s->part == FIGURE_CUT)
        write_cut(run, s->at, out);
    else if (surface)
        write_rows(run, out);
    else
        write_rod(run, s->part == FIGURE_START, out);
}

static void write_head(const struct figure *figure, int n, FILE *out) {
    figure_head(out, figure->title);
    for (int i = 0; i < n; i++) {
        const struct figure_series *s = &figure->series[i];
        int again = 0;
        for (int j = 0; j < i; j++) again |= strcmp(figure->series[j].command, s->command) == 0;
        if (!again && s->part != FIGURE_EXACT)
            fprintf(out, "# command: heatladder %s%s\n", s->command, s->part == FIGURE_START ? "  (its start)" : "");
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
        if (!run[i].result.failure.status) write_series(figure, &figure->series[i], &run[i], out);
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
