/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What one chooses an operator by, in one table: heat kept, order, growth, step, work for an error. */
#include "reports/operators/candidates.h"

#include <math.h>

/* What is rounding is kept. */
static void heat_text(const struct choice *c, char text[16]) {
    if (c->drift < 1e-11)
        snprintf(text, 16, "kept");
    else
        snprintf(text, 16, "%.0e", c->drift);
}

static void write_row(const struct candidate_operator *o, const struct choice *c, FILE *csv) {
    char heat[16];
    heat_text(c, heat);
    fprintf(csv, "%s%s,%d,%s,%.2f,%.2f,%.2f,%d,%d,%d,%.3f,%.3f", o->method, o->options, o->materials,
            o->materials == 1 ? heat : "", c->order[0], c->order[1], c->worst, c->failed, c->growing, c->draws,
            c->step[0], c->step[1]);
    for (int k = 0; k < 3; k++) fprintf(csv, ",%.2e", c->pairs[k]);
    fprintf(csv, "\n");
}

static void tabulate_order(const struct choice *c, FILE *md) {
    fprintf(md, " %.2f to %.2f", c->order[0], c->order[1]);
    if (c->failed) fprintf(md, ", none on %d of %d", c->failed, CLOUDS);
    fprintf(md, " | %.2g |", c->worst);
}

static void tabulate_pairs(const struct choice *c, FILE *md) {
    for (int k = 0; k < 3; k++) {
        if (isnan(c->pairs[k]))
            fprintf(md, " - |");
        else
            fprintf(md, " %.1e |", c->pairs[k]);
    }
    fprintf(md, "\n");
}

static void tabulate_one(const struct candidate_operator *o, const struct choice *c, FILE *md) {
    char heat[16];
    heat_text(c, heat);
    fprintf(md, "| `%s` | %s |", o->method, heat);
    tabulate_order(c, md);
    fprintf(md, " %d of %d | %.3f, %.3f |", c->growing, c->draws, c->step[0], c->step[1]);
    tabulate_pairs(c, md);
}

void operators_choice(const struct choice choice[OPERATORS], FILE *csv, FILE *md) {
    fprintf(csv, "operator,materials,heat drift,least order,largest order,worst E1 over the lattice's,clouds without,"
                 "growing,draws,step on the lattice [dx^2/kappa],at jitter 0.3,pairs on the lattice,at jitter "
                 "0.3,relaxed\n");
    fprintf(
        md,
        "\n## Which to take\n\nHeat: the largest drift on a cloud (rod-cosine). Order: least and largest on the "
        "five clouds (rect-manufactured). Worst: the largest E1 of a cloud over that of the lattice. Growing: draws "
        "of jittered clouds (jitter 0.1 to 0.5, kappa_y/kappa_x 1 to 0.1, h/dx 1.1 and 1.5, 196 and 900 "
        "particles) with a mode that grows. Step: the largest stable one, dx^2/kappa, on the lattice and at "
        "jitter 0.3 (0: none). Work: pairs of neighbours, in all steps, for E1 = 0.001; -: not reached.\n\n"
        "| operator | heat drift | order | worst | growing | step | work: lattice | jitter 0.3 | relaxed |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    for (int k = 0; k < OPERATORS; k++) {
        write_row(&operators[k], &choice[k], csv);
        if (operators[k].materials == 1) tabulate_one(&operators[k], &choice[k], md);
    }
    fprintf(md,
            "\nTwo materials, k 1 : 1000: the same on wall-composite.\n\n| operator | order | worst | work: lattice "
            "| jitter 0.3 | relaxed |\n|---|---|---|---|---|---|\n");
    for (int k = 0; k < OPERATORS; k++)
        if (operators[k].materials == 2) {
            fprintf(md, "| `%s%s` |", operators[k].method, operators[k].options);
            tabulate_order(&choice[k], md);
            tabulate_pairs(&choice[k], md);
        }
    fprintf(md, "\nWalls of any kind: walls.md (make walls).\n");
    fprintf(md, "\n![Error against work](operators_work.svg)\n\n![Growing modes](operators_growth.svg)\n\n![Error "
                "against neighbours](operators_error.svg)\n");
}
