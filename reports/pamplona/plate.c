/* Pamplona, Silva, Bucar, Vasco 2019, Table 1.
 *
 * What the paper leaves open, and what its numbers say:
 *   time step   its four times are 178, 357, 536 and 714 steps of 0.1623 s, which is eq. 15 with beta = 0.08
 *   error       "average error": the definitions below
 *   geometry    20 particles and a ghost layer at either end make 21 spacings from ghost to ghost.  With ghosts that
 *               hold the wall's temperature, a plate of 20 spacings runs late, as one that is 21/20 as wide: by
 *               (21/20)^2 in time.  A plate of 21 spacings would not; its field at time t is ours at (21/20)^2 t. */
#include "reports/pamplona/plate.h"

#include "references/scene.h"
#include "reports/page/figure.h"
#include "verification/command/command_run.h"
#include "verification/text/output.h"
#include "verification/claims/published.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const definitions[REPORT_PLATE_ERRORS] = {
    "mean of abs(e)/T",
    "sum abs(e) / sum T (Song eq. 46)",
    "mean abs(e) over 1 K, the hottest side",
    "root mean square of e, over 1 K",
    "L2 of e over L2 of T",
    "mean of abs(e)/T, ghosts counted as free of error",
    "max abs(e) over 1 K",
};

void pamplona_plate_errors(const struct command_run *run, double t, double error[REPORT_PLATE_ERRORS]) {
    const struct field *f = &run->field;
    double relative = 0, e1 = 0, e2 = 0, T1 = 0, T2 = 0, most = 0, n = (double)f->n;
    double all = (f->shape[0] + 4.0) * (f->shape[1] + 4.0); /* two layers of ghosts on each side */
    for (size_t i = 0; i < f->n; i++) {
        double x[2] = {f->x[i], f->y[i]}, T = command_run_exact(run, x, t), e = fabs(f->T[i] - T);
        relative += e / T;
        e1 += e;
        e2 += e * e;
        T1 += T;
        T2 += T * T;
        most = fmax(most, e);
    }
    const double value[REPORT_PLATE_ERRORS] = {relative / n,  e1 / T1,        e1 / n, sqrt(e2 / n),
                                               sqrt(e2 / T2), relative / all, most};
    for (int i = 0; i < REPORT_PLATE_ERRORS; i++) error[i] = 100 * value[i];
}

enum { TIMES = 4, METHODS = 2, LEADS = 2 };

static const struct {
    const char *method, *label, *options;
} rows[METHODS] = {
    {"brookshaw", "SPH",
     "--kernel quartic --h 1.2 --volume tuned --xi 1.643 --walls fixed --dx 0.005 --stepper rk2 --dt 0.1623"},
    {"ftcs", "FTCS", "--walls fixed --dx 0.005 --dt 0.08169"}, /* eq. 17 with gamma = 0.029 */
};

static const struct {
    double factor;
    const char *label;
} lead[LEADS] = {{1, "20 spacings"}, {1.1025, "21 spacings"}};

struct results {
    struct published t;
    double error[LEADS][METHODS][TIMES][REPORT_PLATE_ERRORS];
};

static int run_all(struct results *s, struct failure *why) {
    int status = STATUS_OK;
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < LEADS * METHODS * TIMES; i++) {
        int l = i / (METHODS * TIMES), m = i / TIMES % METHODS, k = i % TIMES;
        double t = atof(s->t.where[k]);
        struct command_run run;
        struct failure own;
        command_run_line(&run, "run plate %s %s --t-end %.10g", rows[m].method, rows[m].options, lead[l].factor * t);
        if (command_run_check(&run, &own)) {
#pragma omp critical(report_plate)
            {
                *why = own;
                status = own.status;
            }
        } else {
            pamplona_plate_errors(&run, t, s->error[l][m][k]);
        }
        command_run_free(&run);
    }
    return status;
}

/* How far a definition is from the eight printed numbers: the root mean square of log(measured / published). */
static double distance(const struct results *s, int l, int definition) {
    double sum = 0;
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++)
            sum += pow(log(s->error[l][m][k][definition] / s->t.value[m][k]), 2) / (METHODS * TIMES);
    return sqrt(sum);
}

static int nearest(const struct results *s, int l) {
    int best = 0;
    for (int d = 1; d < REPORT_PLATE_ERRORS; d++)
        if (distance(s, l, d) < distance(s, l, best)) best = d;
    return best;
}

static void write_csv(const struct results *s, FILE *out) {
    figure_head(out, "Pamplona 2019, Table 1: average error on the plate, %");
    for (int m = 0; m < METHODS; m++)
        fprintf(out, "# command: heatladder run plate %s %s --t-end T\n", rows[m].method, rows[m].options);
    fprintf(out, "geometry,definition,method,t,published,measured,ratio\n");
    for (int l = 0; l < LEADS; l++)
        for (int d = 0; d < REPORT_PLATE_ERRORS; d++)
            for (int m = 0; m < METHODS; m++)
                for (int k = 0; k < TIMES; k++) {
                    double e = s->error[l][m][k][d];
                    fprintf(out, "%s,\"%s\",%s,%s,%s,%.6g,%.5f\n", lead[l].label, definitions[d], rows[m].method,
                            s->t.where[k], s->t.cell[m][k], e, e / s->t.value[m][k]);
                }
}

static void write_definitions(const struct results *s, int l, FILE *out) {
    fprintf(out, "\n| definition of the error, %% |");
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++) fprintf(out, " %s %.0f s |", rows[m].label, atof(s->t.where[k]));
    fprintf(out, " off by a factor of |\n|---|");
    for (int i = 0; i <= METHODS * TIMES; i++) fprintf(out, "---:|");
    fprintf(out, "\n| **published** |");
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++) fprintf(out, " **%s** |", s->t.cell[m][k]);
    fprintf(out, " |\n");
    for (int d = 0; d < REPORT_PLATE_ERRORS; d++) {
        fprintf(out, "| %s |", definitions[d]);
        for (int m = 0; m < METHODS; m++)
            for (int k = 0; k < TIMES; k++) fprintf(out, " %.4f |", s->error[l][m][k][d]);
        fprintf(out, " %.3f |\n", exp(distance(s, l, d)));
    }
    fprintf(out, "\nNearest: %s.\n", definitions[nearest(s, l)]);
}

static void write_markdown(const struct results *s, FILE *out) {
    fprintf(out, "# Pamplona 2019, Table 1: average error on the plate\n\nMade by `heatladder report DIR`; one run "
                 "alone, at T = 28.8894, 57.9411, 86.9928 or 115.8822:\n\n");
    for (int m = 0; m < METHODS; m++)
        fprintf(out, "    heatladder run plate %s %s --t-end T\n", rows[m].method, rows[m].options);
    fprintf(out,
            "\nThe paper does not define its average error. `off by a factor of`: exp of the root mean square of "
            "log(measured/published).\n\n## The plate is 20 spacings wide, its walls midway between particles "
            "and ghosts\n");
    write_definitions(s, 0, out);
    fprintf(out, "\nThe ghosts half a spacing outside hold the wall's temperature, so that the plate computed is 21 "
                 "spacings wide and warms up late by (21/20)^2 in time: an error of first order, largest early.\n\n"
                 "## As if the plate were 21 spacings wide: the same fields at (21/20)^2 t\n");
    write_definitions(s, 1, out);
    fprintf(
        out,
        "\nThe published numbers fall by a third from the first time to the last; that is what the mean relative "
        "error does once the lag is taken out, for both methods alike. What is left at the last time, near the "
        "steady state, is geometry: walls half a spacing off, most of it at the corners where the sides disagree, "
        "and the same for a method that has no xi to tune. So the published errors fit a mean relative error, of "
        "fields that lag less than walls half a spacing off allow.\n\n"
        "The four times are 178, 357, 536 and 714 steps of 0.1623 s: eq. 15 with beta = 0.08, which the paper "
        "does not print.\n");
}

int pamplona_plate_write(const char *dir, struct failure *why) {
    struct results *s = xcalloc(1, sizeof *s);
    struct output page[2] = {0};
    int status = published_read(&s->t, "pamplona_table1", why);
    if (!status && (s->t.rows != METHODS || s->t.columns < TIMES))
        status = refuse(why, STATUS_INPUT, "pamplona_table1.csv: wants %d methods at %d times", METHODS, TIMES);
    if (!status) status = run_all(s, why);
    if (!status) status = output_open(&page[0], why, "%s/pamplona_table1.csv", dir);
    if (!status) status = output_open(&page[1], why, "%s/pamplona_table1.md", dir);
    if (!status) {
        write_csv(s, page[0].out);
        write_markdown(s, page[1].out);
        status = output_close(page, 2, why);
    }
    output_drop(page, 2);
    free(s);
    return status;
}
