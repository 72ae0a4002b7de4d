/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pamplona, Silva, Bucar, Vasco 2019, Figures 7 and 8: the xi with the least mean relative error at the first time of
 * Table 1, and the cost of a run (xi.h).
 *
 * Walls of fixed ghosts make the plate late by ((n + 1)/n)^2, and the best xi makes up for most of that: the closed
 * form times ((n + 1)/n)^2.  dx = h/1.2 must divide 0.1 m. */
#include "reports/pamplona/pamplona.h"

#include "reports/figure/figure.h"
#include "reports/figure/published.h"
#include "reports/pamplona/plate.h"
#include "reports/pamplona/xi.h"
#include "verification/text/output.h"

#include <math.h>
#include <stdlib.h>

enum { SIZES = 7, MATERIALS = XI_MATERIALS };

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
    struct output data[3];
    int status = published_read(&s->table, "pamplona_table1", why);
    if (!status) status = find_all(s, why);
    if (!status) {
        write_errors(s, output_open(&data[0], "%s/pamplona_fig7a.csv", dir));
        write_xi(s, output_open(&data[1], "%s/pamplona_fig7b.csv", dir));
        write_work(s, output_open(&data[2], "%s/pamplona_fig8.csv", dir));
        status = output_close(data, 3, why);
    }
    free(s);
    return status;
}
