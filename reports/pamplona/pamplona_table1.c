/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pamplona, Silva, Bucar, Vasco 2019, Table 1: tables of reports/pamplona/plate.h and readings.h. */
#include "reports/pamplona/pamplona.h"

#include "reports/figure/figure.h"
#include "reports/figure/published.h"
#include "reports/pamplona/readings.h"
#include "verification/text/output.h"

#include <math.h>
#include <stdlib.h>

enum { TIMES = PLATE_TIMES, METHODS = PLATE_METHODS };

static const char *const label[METHODS] = {"SPH", "FTCS"};

struct results {
    struct published t;
    struct plate_errors plate[METHODS][TIMES];
    struct readings *readings;
};

static int run_all(struct results *s, struct failure *why) {
    *why = (struct failure){0};
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < METHODS * TIMES; i++) {
        struct command_run run;
        command_run_line(&run, "run plate %s --t-end %s", plate_words[i / TIMES], s->t.where[i % TIMES]);
        if (!command_run_note(&run, why)) plate_measure(&run, &s->plate[i / TIMES][i % TIMES]);
        command_run_free(&run);
    }
    return why->status;
}

static void write_csv(const struct results *s, FILE *out) {
    figure_head(out, "Pamplona 2019, Table 1: average error on the plate, %");
    for (int m = 0; m < METHODS; m++) fprintf(out, "# command: heatladder run plate %s --t-end T\n", plate_words[m]);
    fprintf(out, "definition,method,t,published,measured,ratio\n");
    for (int d = 0; d < PLATE_DEFINITIONS; d++)
        for (int m = 0; m < METHODS; m++)
            for (int k = 0; k < TIMES; k++) {
                double e = s->plate[m][k].average[d];
                fprintf(out, "\"%s\",%s,%s,%s,%.6g,%.5f\n", plate_definitions[d], s->t.method[m], s->t.where[k],
                        s->t.cell[m][k], e, e / s->t.value[m][k]);
            }
}

/* The head of a table of the eight numbers, and the printed ones. */
static void write_top(const struct results *s, const char *first, FILE *out) {
    fprintf(out, "\n| %s |", first);
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++) fprintf(out, " %s %.0f s |", label[m], atof(s->t.where[k]));
    fprintf(out, " off by |\n|---|");
    for (int i = 0; i <= METHODS * TIMES; i++) fprintf(out, "---:|");
    fprintf(out, "\n| **published** |");
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++) fprintf(out, " **%s** |", s->t.cell[m][k]);
    fprintf(out, " |\n");
}

static void write_definitions(const struct results *s, FILE *out) {
    write_top(s, "definition of the error, %", out);
    for (int d = 0; d < PLATE_DEFINITIONS; d++) {
        double off = 1;
        fprintf(out, "| %s |", plate_definitions[d]);
        for (int m = 0; m < METHODS; m++)
            for (int k = 0; k < TIMES; k++) {
                double e = s->plate[m][k].average[d];
                off = fmax(off, exp(fabs(log(e / s->t.value[m][k]))));
                fprintf(out, " %.4f |", e);
            }
        fprintf(out, " %.3f |\n", off);
    }
}

static void write_readings(const struct results *s, FILE *out) {
    const struct reading *nearest = &s->readings->reading[s->readings->nearest];
    write_top(s, "walls; corner ghosts; terms of the series; definition", out);
    for (int i = 0; i < s->readings->count; i++) {
        const struct reading *r = &s->readings->reading[i];
        fprintf(out, "| %s; %s; %d; %s |", readings_places[r->place], readings_corners[r->corner],
                readings_terms[r->terms], plate_definitions[r->best]);
        for (int m = 0; m < METHODS; m++)
            for (int k = 0; k < TIMES; k++) fprintf(out, " %.4f |", r->error[r->best][m][k]);
        fprintf(out, " %.3f |\n", r->off[r->best]);
    }
    fprintf(out,
            "\nThe nearest of these %d readings times %d definitions is off by a factor of %.3f in one of the eight "
            "numbers: the table is not explained.\n",
            s->readings->count, PLATE_DEFINITIONS, nearest->off[nearest->best]);
}

static void write_markdown(const struct results *s, FILE *out) {
    fprintf(out, "# Pamplona 2019, Table 1: average error on the plate\n\nMade by `heatladder report DIR`; one run "
                 "alone, T one of the four times:\n\n");
    for (int m = 0; m < METHODS; m++) fprintf(out, "    heatladder run plate %s --t-end T\n", plate_words[m]);
    fprintf(
        out,
        "\nThe paper does not define its average error. `off by`: the largest factor between a measured and a "
        "printed number. The time steps, not printed either, make the four times whole numbers of steps: 178, "
        "357, 536 and 714 of 0.1623 s, or twice as many of 0.08115 s.\n\n## The plate as stated\n\n20 spacings, "
        "the walls midway between particles and ghosts. Ghosts that hold the walls' temperature half a spacing "
        "outside make the plate computed 21 spacings wide and late by (21/20)^2 in time: an error of first order, "
        "largest early.\n");
    write_definitions(s, out);
    fprintf(out,
            "\n## Other readings, each by its nearest definition\n\nThe clock of the second is ahead of the "
            "field's by the lag above; its geometry is not that of any plate. On the third the walls stand where "
            "the ghosts are, and finite differences are second order there: 0.06 to 0.2 %%.\n");
    write_readings(s, out);
}

int pamplona_table1_write(const char *dir, struct failure *why) {
    struct results *s = xcalloc(1, sizeof *s);
    struct output page[2];
    int status = published_read(&s->t, "pamplona_table1", why);
    if (!status) status = run_all(s, why);
    if (!status) {
        s->readings = readings_try(&s->t);
        write_csv(s, output_open(&page[0], "%s/pamplona_table1.csv", dir));
        write_markdown(s, output_open(&page[1], "%s/pamplona_table1.md", dir));
        status = output_close(page, 2, why);
    }
    free(s->readings);
    free(s);
    return status;
}
