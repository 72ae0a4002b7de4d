/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pamplona, Silva, Bucar, Vasco 2019, Figures 7 and 8: the xi with the least mean relative error at the first time of
 * Table 1, and what a run costs (reports/pamplona/xi.h).
 *
 * Walls of fixed ghosts make the plate late by ((n + 1)/n)^2, and the best xi makes up for most of that: the closed
 * form times ((n + 1)/n)^2.  Sizes: dx = h/1.2 must divide 0.1 m; order by eq. 19 between the n nearest to h = 0.009
 * and 0.005 m. */
#include "reports/pamplona/pamplona.h"

#include "reports/figure/document.h"
#include "reports/figure/figure.h"
#include "reports/pamplona/plate.h"
#include "reports/figure/published.h"
#include "reports/pamplona/xi.h"

#include <math.h>
#include <stdlib.h>

enum { SIZES = 7, MATERIALS = XI_MATERIALS, COARSE = 1, FINE = 5 };

static const int size[SIZES] = {12, 13, 15, 17, 20, 24, 30}; /* particles along a side */

struct results {
    struct published table;
    struct xi_best best[SIZES][MATERIALS], quartic[SIZES]; /* the last: steel, the printed kernel */
};

static void head(FILE *out, const char *title) {
    figure_head(out, title);
    fprintf(out,
            "# command: heatladder run plate brookshaw --kernel cubic --h 1.2 --volume tuned --xi XI --walls fixed "
            "--dx 0.1/N --stepper rk2 --dt DT --set material=M\n");
}

static void write_errors(const struct results *s, FILE *out) {
    head(out, "Pamplona 2019, Figure 7a: least mean relative error on the plate, t = 28.9 s");
    for (int m = 0; m < MATERIALS; m++) {
        fprintf(out, "\n\n# %s\nh [m],error [%%]\n", xi_materials[m]);
        for (int i = 0; i < SIZES; i++) fprintf(out, "%.8g,%.5g\n", xi_h(size[i]), s->best[i][m].error);
    }
    fprintf(out, "\n\n# printed\nh [m],error [%%]\n%.8g,%s\n", xi_h(PLATE_SIDE), s->table.cell[PLATE_SPH][0]);
}

static void write_xi(const struct results *s, FILE *out) {
    head(out, "Pamplona 2019, Figure 7b: best ξ on the plate, t = 28.9 s");
    for (int m = 0; m < MATERIALS; m++) {
        fprintf(out, "\n\n# %s\nh [m],xi [m]\n", xi_materials[m]);
        for (int i = 0; i < SIZES; i++) fprintf(out, "%.8g,%.6g\n", xi_h(size[i]), s->best[i][m].xi);
    }
    fprintf(out, "\n\n# quartic\nh [m],xi [m]\n");
    for (int i = 0; i < SIZES; i++) fprintf(out, "%.8g,%.6g\n", xi_h(size[i]), s->quartic[i].xi);
    fprintf(out, "\n\n# printed\nh [m],xi [m]\n%.8g,1.643\n", xi_h(PLATE_SIDE));
    fprintf(out, "\n\n# moment\nh [m],xi [m]\n");
    for (int n = 30; n >= 12; n--) fprintf(out, "%.8g,%.6g\n", xi_h(n), xi_closed_form(n, KERNEL_CUBIC));
    fprintf(out, "\n\n# lag\nh [m],xi [m]\n");
    for (int n = 30; n >= 12; n--)
        fprintf(out, "%.8g,%.6g\n", xi_h(n), xi_closed_form(n, KERNEL_CUBIC) * pow((n + 1.0) / n, 2));
    fprintf(out, "\n\n# published\nh [m],xi [m]\n");
    for (int n = 30; n >= 12; n--) fprintf(out, "%.8g,%.6g\n", xi_h(n), xi_eq18(xi_h(n)));
}

static struct xi_line growth(const struct results *s, int m, int power) {
    double h[SIZES], work[SIZES];
    for (int i = 0; i < SIZES; i++) h[i] = xi_h(size[i]), work[i] = (double)s->best[i][m].work;
    return xi_growth(h, work, SIZES, power);
}

static void write_work(const struct results *s, FILE *out) {
    head(out, "Pamplona 2019, Figure 8: cost on the plate, t = 28.9 s, as pairs evaluated");
    for (int m = 0; m < MATERIALS; m++) {
        fprintf(out, "\n\n# %s\nh [m],%s (h^{%.2f})\n", xi_materials[m], xi_materials[m], growth(s, m, 1).slope);
        for (int i = 0; i < SIZES; i++) fprintf(out, "%.8g,%lld\n", xi_h(size[i]), s->best[i][m].work);
    }
    for (int power = 0; power < 2; power++) {
        struct xi_line l = growth(s, 0, power);
        fprintf(out, "\n\n# %s\nh [m],%s fitted to steel (off by %.1f %%)\n", power ? "power" : "exponential",
                power ? "power law" : "exponential", 100 * l.off);
        for (int n = 30; n >= 12; n--)
            fprintf(out, "%.8g,%.6g\n", xi_h(n), pow(10, l.at + l.slope * (power ? log10(xi_h(n)) : xi_h(n))));
    }
}

static void write_table(const struct results *s, struct document *d) {
    document_command(d, "run plate brookshaw --kernel cubic --h 1.2 --volume tuned --xi XI --walls fixed --dx 0.1/N "
                        "--stepper rk2 --dt DT --set material=M");
    document_text(
        d,
        "Mean relative error at t = %.4f s, at the xi that makes it least; eq. 15 with beta = %g; the cubic "
        "kernel of the public code, and with steel the printed quartic.",
        s->best[0][0].t, s->best[0][0].beta);
    document_table(d, "N|h [m]|9 h^(1/3)|lattice moment x ((N+4)/N)^2|and x ((N+1)/N)^2|quartic: xi [m]");
    for (int m = 0; m < MATERIALS; m++) {
        document_header(d, "%s: xi [m]", xi_materials[m]);
        document_header(d, "error [%%]");
        document_header(d, "pairs");
    }
    for (int i = 0; i < SIZES; i++) {
        int n = size[i];
        double closed = xi_closed_form(n, KERNEL_CUBIC);
        document_cell(d, "%d", n);
        document_cell(d, "%.5f", xi_h(n));
        document_cell(d, "%.4f", xi_eq18(xi_h(n)));
        document_cell(d, "%.4f", closed);
        document_cell(d, "%.4f", closed * pow((n + 1.0) / n, 2));
        document_cell(d, "%.4f", s->quartic[i].xi);
        for (int m = 0; m < MATERIALS; m++) {
            document_cell(d, "%.4f", s->best[i][m].xi);
            document_cell(d, "%.4f", s->best[i][m].error);
            document_cell(d, "%.3e", (double)s->best[i][m].work);
        }
    }
    document_text(d,
                  "Order by eq. 19 from h = %.5f to %.5f m (the paper: 1.1253 from 0.009 to 0.005 m), and the growth "
                  "of the cost: particles grow as h^-2 and steps as h^-2.",
                  xi_h(size[COARSE]), xi_h(size[FINE]));
    document_table(d, "material|order|pairs grow as h to the power|off by, %|an exponential off by, %");
    for (int m = 0; m < MATERIALS; m++) {
        struct xi_line power = growth(s, m, 1), exponential = growth(s, m, 0);
        document_cell(d, "%s", xi_materials[m]);
        document_cell(d, "%.4f",
                      log(s->best[COARSE][m].error / s->best[FINE][m].error) /
                          log(xi_h(size[COARSE]) / xi_h(size[FINE])));
        document_cell(d, "%.3f", power.slope);
        document_cell(d, "%.1f", 100 * power.off);
        document_cell(d, "%.1f", 100 * exponential.off);
    }
}

static int find_all(struct results *s, struct failure *why) {
    enum { CASES = SIZES * (MATERIALS + 1) };
    struct xi_best *of[CASES];
    for (int i = 0; i < CASES; i++) {
        int n = size[i / (MATERIALS + 1)], m = i % (MATERIALS + 1);
        of[i] = m < MATERIALS ? &s->best[i / (MATERIALS + 1)][m] : &s->quartic[i / (MATERIALS + 1)];
        *of[i] = xi_as_stated(n, m % MATERIALS);
        if (m == MATERIALS) of[i]->kernel = KERNEL_QUARTIC;
    }
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = CASES - 1; i >= 0; i--) xi_find(of[i]);
    for (int i = 0; i < CASES; i++) {
        if (!of[i]->failure.status) continue;
        *why = of[i]->failure;
        return why->status;
    }
    return STATUS_OK;
}

int pamplona_fig7_write(const char *dir, struct failure *why) {
    struct results *s = xcalloc(1, sizeof *s);
    struct output data[3] = {{0}};
    struct document d = {0};
    int status = published_read(&s->table, "pamplona_table1", why);
    if (!status) status = find_all(s, why);
    if (!status) {
        write_errors(s, output_open(&data[0], "%s/pamplona_fig7a.csv", dir));
        write_xi(s, output_open(&data[1], "%s/pamplona_fig7b.csv", dir));
        write_work(s, output_open(&data[2], "%s/pamplona_fig8.csv", dir));
        document_open(&d, dir, "pamplona_fig7", "Pamplona 2019, Figures 7 and 8: best xi, its error, its cost");
        write_table(s, &d);
        status = output_close(data, 3, why);
    }
    if (!status) status = document_close(&d, why);
    output_drop(data, 3);
    document_drop(&d);
    free(s);
    return status;
}
