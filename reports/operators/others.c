/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Statements of other papers on time steps and growth, measured on model problems. */
#include "reports/operators/operators.h"

#include "reports/ledger/claim.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double DEFAULT_H = 1.1; /* over dx, of a method without one */

/* The limit from the command "limit `command`".  Returns 0, or 1 with *m failed. */
static int find_limit(struct claims_measured *m, const char *command, double *h, struct step_limit *l) {
    struct model_problem b;
    if (claim_model(&b, l, m, "limit %s", command)) return 1;
    *h = b.method->scheme->cells ? DEFAULT_H : b.options.h;
    return 0;
}

/* "C SCALE | COMMAND | ... | + COMMAND | ...": dt = C (SCALE h)^2/kappa compared with the stable step; parts
 * with + go beyond the statement. */
void others_step(struct claims_measured *m) {
    char part[160];
    double C, scale;
    int held[2] = {1, 1};
    claim_part(&m->argument, part, sizeof part);
    if (sscanf(part, "%lf %lf", &C, &scale) != 2 && claim_fail(m, "no coefficient")) return;
    while (claim_part(&m->argument, part, sizeof part)) {
        int beyond = part[0] == '+';
        struct step_limit l;
        double h = NAN;
        if (find_limit(m, part + (beyond ? 2 : 0), &h, &l)) return;
        double times = C * scale * scale * h * h / l.von_neumann;
        if (l.grows)
            claim_number(m, l.growth, "kappa/dx^2", "growth at any step, %.44s", part + (beyond ? 2 : 0));
        else
            claim_number(m, times, "of the stable step", "%.58s", part + (beyond ? 2 : 0));
        held[beyond] &= !l.grows && times <= 1;
    }
    claim_decide(m, held[0], held[1], "at most the stable step, by von Neumann or eigenvalues");
}

/* "METHOD | OTHER | ...": the first is stable, and of the others none, at kappa_y/kappa_x = 0.1 on a cloud. */
void others_only(struct claims_measured *m) {
    char part[40], command[160];
    int stable = 0, first = 0, count = 0;
    while (claim_part(&m->argument, part, sizeof part)) {
        struct step_limit l;
        double h = NAN;
        snprintf(command, sizeof command, "%s --dim 2 --ratio 0.1 --layout jitter --jitter 0.5 --seed 3", part);
        if (find_limit(m, command, &h, &l)) return;
        claim_number(m, l.grows ? l.growth : 0, "kappa/dx^2", "growth of %s, jitter 0.5, ratio 0.1", part);
        if (count++ == 0)
            first = !l.grows;
        else
            stable += !l.grows;
    }
    claim_decide(m, first && stable == 0, 1, "no mode of the first grows, and one of each other");
}

/* "< LADDER | > LADDER | + < LADDER": the order is below 1, or in [1.8, 2.2]; parts with + are cases that the
 * statement does not exclude. */
void others_orders(struct claims_measured *m) {
    char part[160];
    int held[2] = {1, 1};
    while (claim_part(&m->argument, part, sizeof part)) {
        const char *words = part[0] == '+' ? part + 2 : part;
        char method[24];
        double slope, jitter;
        if (sscanf(words + 2, "%23[a-z_], jitter %lf", method, &jitter) != 2 &&
            claim_fail(m, "no method or no jitter"))
            return;
        if (claim_order(NULL, &slope, m, NULL,
                        "ladder rod-cosine %s --layout jitter --jitter %g --seed 1 --dx 1/20,1/40,1/80,1/160,1/320",
                        method, jitter))
            return;
        claim_number(m, slope, "", "order of %s", words + 2);
        held[part[0] == '+'] &= words[0] == '<' ? slope < 1 : 1.8 <= slope && slope <= 2.2;
    }
    claim_decide(m, held[0], held[1],
                 "an order below 1 of those that are said not to converge, 1.8 to 2.2 of the other");
}
