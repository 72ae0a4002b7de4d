/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plane walls at arbitrary positions, with so_ssph: rod-cooling (Dirichlet and Robin), rod-cosine (Neumann) and
 * plate-cooling, at the offsets 0, 0.1, ... 0.9 of the lattice. */
#include "reports/walls/walls_planes.h"

#include "reports/figure/document.h"
#include "reports/figure/figure.h"
#include "reports/walls/walls_price.h"
#include "solver/method.h"
#include "verification/judge/command_run.h"
#include "verification/judge/slope.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <string.h>

/* Offsets on rods; for rod-cooling also the errors by spacing and work, and to `error` the mean of the offsets. */
int walls_planes_offsets(FILE *out, struct document *d, FILE *error, struct failure *why) {
    static const struct {
        const char *scene, *walls, *derived; /* order in E1 */
        double length;
    } rods[] = {{"rod-cooling", "mirror", "2", 0.3}, {"rod-cooling", "image", "1", 0.3},
                {"rod-cooling", "fit", "2", 0.3},    {"rod-cooling", "one_sided", "2", 0.3},
                {"rod-cosine", "mirror", "2", 1},    {"rod-cosine", "average", "1", 1},
                {"rod-cosine", "image", "1", 1},     {"rod-cosine", "fit", "2", 1},
                {"rod-cosine", "one_sided", "2", 1}};
    document_heading(d, "Plane walls");
    document_text(
        d, "Offsets 0, 0.1, ... 0.9 of the lattice, dx = L/20 ... L/160: order of E1, the median and the range "
           "of ten; at L/160 the mean E1 and the largest of ten; at L/80 the largest stable step, the least "
           "and the most of ten, by all eigenvalues (0.537 without walls), and the growth.");
    document_table(
        d, "scene|--walls|order derived|order of E1|E1, mean|E1, largest|step, dx^2/kappa|growth, kappa/dx^2");
    figure_head(out, "Plane walls anywhere, so_ssph: order of E1 against the lattice's offset");
    fprintf(out, "# command: heatladder ladder rod-cooling so_ssph --walls fit --shift 0.3 "
                 "--dx 0.3/20,0.3/40,0.3/80,0.3/160\n");
    for (size_t k = 0; k < sizeof rods / sizeof *rods; k++) {
        fprintf(out, "\n\n# %s %s\noffset,order,low,high,E1,step\n", rods[k].scene, rods[k].walls);
        double order[10], last[10], step[10], mean[4] = {0}, work[4] = {0}, dx[4], growth = 0;
        for (int s = 0; s < 10; s++) {
            double E1[4];
            for (int n = 0; n < 4; n++) {
                struct command_run run;
                dx[n] = rods[k].length / (20 << n);
                command_run_line(&run, "run %s so_ssph --walls %s --shift 0.%d --dx %g/%d", rods[k].scene,
                                 rods[k].walls, s, rods[k].length, 20 << n);
                E1[n] = run.result.error.l1;
                mean[n] += E1[n] / 10, work[n] += (double)run.result.cost.interactions / 10;
                int status = command_run_check(&run, why);
                command_run_free(&run);
                if (status) return status;
            }
            struct slope fit = slope_fit(dx, E1, 4);
            char command[200];
            snprintf(command, sizeof command, "run %s so_ssph --walls %s --shift 0.%d --dx %g/80 --stepper euler",
                     rods[k].scene, rods[k].walls, s, rods[k].length);
            struct walls_price price = {.limit = INFINITY};
            if (walls_price_take(&price, why, command)) return why->status;
            step[s] = price.limit, growth = fmax(growth, price.growth);
            fprintf(out, "0.%d,%.4f,%.4f,%.4f,%.4e,%.4f\n", s, fit.value, fit.ci[0], fit.ci[1], E1[3], step[s]);
            order[s] = fit.value, last[s] = E1[3];
        }
        gsl_sort(order, 1, 10);
        gsl_sort(last, 1, 10);
        gsl_sort(step, 1, 10);
        document_cell(d, "%s", rods[k].scene);
        document_cell(d, "`%s`", rods[k].walls);
        document_cell(d, "%s", rods[k].derived);
        document_cell(d, "%.2f [%.2f, %.2f]", gsl_stats_median_from_sorted_data(order, 1, 10), order[0], order[9]);
        document_cell(d, "%.2e", mean[3]);
        document_cell(d, "%.2e", last[9]);
        document_cell(d, "%.3f to %.3f", step[0], step[9]);
        document_cell(d, "%.2g", growth);
        if (strcmp(rods[k].scene, "rod-cooling")) continue;
        fprintf(error, "\n\n# %s, rod-cooling\ndx,%s,interactions\n", rods[k].walls, rods[k].walls);
        for (int n = 0; n < 4; n++) fprintf(error, "%g,%.5e,%.5e\n", dx[n], mean[n], work[n]);
    }
    return STATUS_OK;
}

/* In a plane the fastest mode is the fastest mode of both axes.  A treatment therefore reduces the step of the plane
 * by the same factor as that of a rod: 0.525 dx^2/kappa without walls, compared with 0.537 for the rod. */
int walls_planes_steps(struct document *d, struct failure *why) {
    static const char *const walls[] = {"mirror", "image", "fit", "one_sided"};
    document_heading(d, "plate-cooling --dx 1/15");
    document_text(d,
                  "The largest stable step of ten offsets, the same on both axes, by all eigenvalues (0.525 without "
                  "walls), dx^2/kappa; the growth in kappa/dx^2.");
    document_table(d, "--walls|step, least|step, most|growth");
    for (size_t k = 0; k < sizeof walls / sizeof *walls; k++) {
        double step[10];
        char command[200];
        double growth = 0;
        for (int s = 0; s < 10; s++) {
            struct walls_price price = {.limit = INFINITY};
            snprintf(command, sizeof command,
                     "run plate-cooling so_ssph --walls %s --shift 0.%d --dx 1/15 --stepper euler", walls[k], s);
            if (walls_price_take(&price, why, command)) return why->status;
            step[s] = price.limit;
            growth = fmax(growth, price.growth);
        }
        gsl_sort(step, 1, 10);
        document_cell(d, "`%s`", walls[k]);
        document_cell(d, "%.3f", step[0]);
        document_cell(d, "%.3f", step[9]);
        document_cell(d, "%.2g", growth);
    }
    return STATUS_OK;
}
