/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What other papers state of steps and growth, measured on model problems. */
#include "reports/operators/operators.h"

#include "reports/ledger/kit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double DEFAULT_H = 1.1; /* over dx, of a method without one */

/* Of the command "limit `command`".  0, or 1 with *m failed. */
static int find_limit(struct claims_measured *m, const char *command, double *h, struct step_limit *l) {
    struct model_problem b;
    if (kit_model(&b, l, m, "limit %s", command)) return 1;
    *h = b.method->scheme->cells ? DEFAULT_H : b.options.h;
    return 0;
}

/* "C SCALE | COMMAND | ... | + COMMAND | ...": dt = C (SCALE h)^2/kappa against the stable step; + what goes beyond
 * the statement. */
void others_step(struct claims_measured *m) {
    char part[160];
    double C, scale;
    int held[2] = {1, 1};
    kit_part(&m->argument, part, sizeof part);
    if (sscanf(part, "%lf %lf", &C, &scale) != 2 && kit_fail(m, "no coefficient")) return;
    while (kit_part(&m->argument, part, sizeof part)) {
        int beyond = part[0] == '+';
        struct step_limit l;
        double h = NAN;
        if (find_limit(m, part + (beyond ? 2 : 0), &h, &l)) return;
        double times = C * scale * scale * h * h / l.von_neumann;
        if (l.grows)
            kit_number(m, l.growth, "kappa/dx^2", "growth at any step, %.44s", part + (beyond ? 2 : 0));
        else
            kit_number(m, times, "of the stable step", "%.58s", part + (beyond ? 2 : 0));
        held[beyond] &= !l.grows && times <= 1;
    }
    kit_decide(m, held[0], held[1], "at most the stable step, by von Neumann or eigenvalues");
}

/* "LO HI | METHOD | METHOD": the stable step of the first over that of the second. */
void others_larger(struct claims_measured *m) {
    static const char *const where[] = {" --dim 1 --h 1.1", " --dim 2 --h 1.1", " --dim 2 --h 1.5",
                                        " --dim 2 --layout jitter --jitter 0.3 --seed 1"};
    char part[2][40], command[160];
    double lo, hi, h = NAN;
    int held[2] = {1, 1};
    kit_part(&m->argument, part[0], sizeof part[0]);
    if (sscanf(part[0], "%lf %lf", &lo, &hi) != 2 && kit_fail(m, "no range")) return;
    for (int k = 0; k < 2; k++) kit_part(&m->argument, part[k], sizeof part[k]);
    for (int w = 0; w < 4; w++) {
        struct step_limit l[2];
        for (int k = 0; k < 2; k++) {
            snprintf(command, sizeof command, "%s%s", part[k], where[w]);
            if (find_limit(m, command, &h, &l[k])) return;
        }
        double times = l[0].von_neumann / l[1].von_neumann;
        kit_number(m, times, "times", "larger:%s", where[w]);
        held[w == 3] &= lo <= times && times <= hi;
    }
    kit_decide(m, held[0], held[1], "within the range on lattices; without a condition on a cloud too");
}

/* "METHOD | OTHER | ...": the first is stable, and of the others none, at kappa_y/kappa_x = 0.1 on a cloud. */
void others_only(struct claims_measured *m) {
    char part[40], command[160];
    int stable = 0, first = 0, count = 0;
    while (kit_part(&m->argument, part, sizeof part)) {
        struct step_limit l;
        double h = NAN;
        snprintf(command, sizeof command, "%s --dim 2 --ratio 0.1 --layout jitter --jitter 0.5 --seed 3", part);
        if (find_limit(m, command, &h, &l)) return;
        kit_number(m, l.grows ? l.growth : 0, "kappa/dx^2", "growth of %s, jitter 0.5, ratio 0.1", part);
        if (count++ == 0)
            first = !l.grows;
        else
            stable += !l.grows;
    }
    kit_decide(m, first && stable == 0, 1, "no mode of the first grows, and one of each other");
}

/* "< LADDER | > LADDER | + < LADDER": the order is below 1, or in [1.8, 2.2]; + what the statement does not except.
 */
void others_orders(struct claims_measured *m) {
    char part[160];
    int held[2] = {1, 1};
    while (kit_part(&m->argument, part, sizeof part)) {
        const char *words = part[0] == '+' ? part + 2 : part;
        char method[24];
        double slope, jitter;
        if (sscanf(words + 2, "%23[a-z_], jitter %lf", method, &jitter) != 2 && kit_fail(m, "no method or no jitter"))
            return;
        if (kit_order(NULL, &slope, m, NULL,
                      "ladder rod-cosine %s --layout jitter --jitter %g --seed 1 --dx 1/20,1/40,1/80,1/160,1/320",
                      method, jitter))
            return;
        kit_number(m, slope, "", "order of %s", words + 2);
        held[part[0] == '+'] &= words[0] == '<' ? slope < 1 : 1.8 <= slope && slope <= 2.2;
    }
    kit_decide(m, held[0], held[1],
               "an order below 1 of those that are said not to converge, 1.8 to 2.2 of the other");
}

/* E1 of rect-manufactured; INFINITY where a mode grows. */
static int error_of(double *error, struct claims_measured *m, const char *method, const char *cloud) {
    struct command_run run;
    struct failure why;
    command_run_line(&run, "run rect-manufactured %s --set k_y=0.02%s", method, cloud);
    int status = command_run_check(&run, &why);
    *error = status == STATUS_UNSTABLE ? INFINITY : run.result.error.l1;
    command_run_free(&run);
    return status && status != STATUS_UNSTABLE ? kit_fail(m, why.text) : 0;
}

/* "TIMES | METHOD | OTHER | ...": the least error of the others over that of the first, on fine clouds in disorder
 * and, beyond that, on a coarse one and the lattice. */
void others_better(struct claims_measured *m) {
    static const char *const names[] = {"jitter 0.1, dx 1/50", "jitter 0.3, dx 1/50", "jitter 0.1, dx 1/30",
                                        "lattice, dx 1/30"};
    static const char *const clouds[] = {" --layout jitter --jitter 0.1 --seed 1 --dx 1/50",
                                         " --layout jitter --jitter 0.3 --seed 1 --dx 1/50",
                                         " --layout jitter --jitter 0.1 --seed 1 --dx 1/30", " --dx 1/30"};
    char part[40], first[40];
    double own[4], best[4] = {INFINITY, INFINITY, INFINITY, INFINITY}, times = 0;
    int held[2] = {1, 1}, count = 0;
    while (kit_part(&m->argument, part, sizeof part)) {
        if (count == 0) times = atof(part);
        if (count == 1) snprintf(first, sizeof first, "%s", part);
        for (int c = 0; c < 4 && count > 0; c++) {
            double error;
            if (error_of(&error, m, part, clouds[c])) return;
            if (count == 1)
                own[c] = error;
            else
                best[c] = fmin(best[c], error);
        }
        count++;
    }
    for (int c = 0; c < 4 && count > 2; c++) {
        kit_number(m, best[c] / own[c], "times", "E1 over that of %s, %s", first, names[c]);
        held[c > 1] &= best[c] / own[c] >= times;
    }
    kit_decide(m, held[0], held[1], "at least %g on fine clouds in disorder; without a condition elsewhere too",
               times);
}
