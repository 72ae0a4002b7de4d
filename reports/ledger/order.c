/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Orders of accuracy and tables of errors compared with the published ones, and Song's exact solution. */

#include "reports/ledger/order.h"

#include "reports/ledger/claim.h"

#include "references/series.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Half the width of the band around an order: as in gates/gates.def. */
static const double BAND = 0.1;

/* Cuts the label off "label: rest" and returns the rest; without a label, the whole text. */
static char *unlabel(char *part) {
    char *colon = strchr(part, ':');
    if (!colon) return part;
    *colon = '\0';
    return colon + 1;
}

/* "ORDER | label: ladder's words | label: ...": the first is the published setting. */
void ledger_order_order(struct claims_measured *m) {
    char part[320];
    int held[2] = {1, 1}, setting = 0;
    claim_part(&m->argument, part, sizeof part);
    double order = atof(part);
    for (; claim_part(&m->argument, part, sizeof part); setting++) {
        const char *words = unlabel(part);
        double slope;
        int holds;
        if (claim_order(&holds, &slope, m, (double[2]){order - BAND, order + BAND}, "ladder %s", words)) return;
        claim_number(m, slope, "", "order %s", part);
        held[setting > 0] &= holds;
    }
    claim_decide(m, held[0], held[1],
                 "an order of %g +- %g by the rule of the gates in the first setting (as published) and in the "
                 "others, if any",
                 order, BAND);
}

/* "ORDER TABLE METHOD | ...": the slope of the published errors (reports/published). */
void ledger_order_printed_order(struct claims_measured *m) {
    char part[80], name[40], method[24];
    double order, dx[PUBLISHED_COLUMNS];
    int held = 1;
    while (claim_part(&m->argument, part, sizeof part)) {
        struct published t;
        if (sscanf(part, "%lf %39s %23s", &order, name, method) != 3 || claim_published(&t, m, name)) return;
        int row = published_row(&t, method);
        for (int i = 0; i < t.columns; i++) dx[i] = atof(t.where[i]);
        double slope = row < 0 ? NAN : slope_fit(dx, t.value[row], t.columns).value;
        claim_number(m, slope, "", "slope of %s %s", name, method);
        held &= fabs(slope - order) <= BAND;
    }
    claim_decide(m, held, 1, "slope of the printed numbers within %g of the printed order", BAND);
}

/* "TABLE | scene and options": every error of the table, run again. */
void ledger_order_table(struct claims_measured *m) {
    char name[40], options[160];
    double worst = 1;
    struct published t;
    claim_part(&m->argument, name, sizeof name);
    claim_part(&m->argument, options, sizeof options);
    if (claim_published(&t, m, name)) return;
    int scene = (int)strcspn(options, " "), held = 0;
    for (int r = 0; r < t.rows; r++) claim_quote(m, &t, r);
    for (int r = 0; r < t.rows; r++)
        for (int i = 0; i < t.columns; i++) {
            struct result run;
            if (claim_result(&run, m, "run %.*s %s%s --dx %s", scene, options, t.method[r], options + scene,
                             t.where[i]))
                return;
            double measured = run.error.l1, ratio = measured / t.value[r][i];
            int digits = fabs(published_units(t.cell[r][i], measured)) <= 1;
            int near = digits || fabs(ratio - 1) <= 0.02;
            if (!near) claim_number(m, ratio, "", "measured over printed, %s at dx = %s", t.method[r], t.where[i]);
            if (!digits && !(fabs(ratio - 1) <= fabs(worst - 1))) worst = ratio;
            held += near;
        }
    claim_number(m, t.rows * t.columns, "", "errors compared");
    claim_number(m, held, "", "within 2 %% or a unit of the last digit");
    claim_number(m, worst, "", "worst ratio of those more than a unit of the last digit off");
    claim_decide(m, fabs(worst - 1) <= 0.10, held == t.rows * t.columns,
                 "every error within 2 %% or one unit of its last digit; within 10 %% leaves a choice open");
}

/* Two single-parameter fits of the gap in the errors of Table 2: decimals of the exact solution, and an offset of
 * the clock in seconds.  A fit explains them if it reproduces every printed digit, within half a unit of the last
 * one. */
void ledger_order_gap(struct claims_measured *m) {
    static const struct {
        const char *name;
        double late;
        int decimals;
    } fit[3] = {{"as stated", 0, 0}, {"exact solution to 6 decimals", 0, 6}, {"clock 3e-4 s short", 3e-4, 0}};
    double worst[3] = {1, 1, 1};
    int met[3] = {0, 0, 0};
    struct published t;
    if (claim_published(&t, m, "song_table2")) return;
    int all = t.rows * t.columns;
    for (int r = 0; r < t.rows; r++)
        for (int i = 0; i < t.columns; i++)
            for (int k = 0; k < 3; k++) {
                struct command_run run;
                int bad = claim_run(&run, m, "run rod-gauss %s --h 1.05 --stepper exact --dx %s --t-end %.10g",
                                    t.method[r], t.where[i], 5 - fit[k].late);
                double error = bad ? NAN : command_run_error(&run, fit[k].decimals, fit[k].late);
                command_run_free(&run);
                if (bad) return;
                worst[k] = fmax(worst[k], exp(fabs(log(error / t.value[r][i]))));
                met[k] += published_units(t.cell[r][i], error) == 0;
            }
    for (int k = 0; k < 3; k++) {
        claim_number(m, met[k], "", "of %d in every digit, %s", all, fit[k].name);
        claim_number(m, worst[k], "", "off by a factor of at most");
    }
    claim_decide(m, met[0] == all, 1,
                 "every printed digit of every error as stated; else not explained where both fits give them, or "
                 "neither does");
    if (met[0] < all && (met[1] == all) == (met[2] == all)) m->verdict = CLAIMS_UNEXPLAINED;
}

/* ---- Eqs. 44, 45: the solution that errors are measured against ---- */

static const double T0 = 10, A = 0.5, KAPPA = 0.01, L = 2; /* section 5.1: K, m, m^2/s, m */

/* Eq. 45 letter by letter. */
static double printed(double x, double t, double kappa_x, double kappa_y) {
    return T0 / 2 * (erf((A + x) / sqrt(4 * t * kappa_x)) + erf((A - x) / sqrt(4 * t * kappa_y)));
}

/* Largest |T(x) - T(-x)|: the problem is even. */
void ledger_order_eq45(struct claims_measured *m) {
    double apart[2] = {0, 0};
    for (int i = 1; i <= 20; i++) {
        double x = 0.1 * i;
        apart[0] = fmax(apart[0], fabs(printed(x, 5, KAPPA, KAPPA) - printed(-x, 5, KAPPA, KAPPA)));
        apart[1] = fmax(apart[1], fabs(printed(x, 5, KAPPA, KAPPA / 3) - printed(-x, 5, KAPPA, KAPPA / 3)));
    }
    claim_number(m, apart[0], "K", "|T(x) - T(-x)|, kappa_y = kappa_x");
    claim_number(m, apart[1], "K", "kappa_y = kappa_x/3");
    claim_decide(m, apart[0] <= 1e-12, apart[1] <= 1e-12,
                 "as even as the problem is: for the one kappa_y that makes it so, and for any");
}

/* Eq. 45 is the solution of the infinite line; eq. 44 has walls at zero.  Relative to the errors of Table 1. */
void ledger_order_walls(struct claims_measured *m) {
    static const double time[2] = {5, 50};
    struct published t;
    double share[2], smallest = INFINITY;
    if (claim_published(&t, m, "song_table1")) return;
    for (int r = 0; r < t.rows; r++)
        for (int i = 0; i < t.columns; i++) smallest = fmin(smallest, t.value[r][i]);
    for (int i = 0; i < 2; i++) {
        double apart = 0, size = 0, s = sqrt(4 * KAPPA * time[i]);
        for (int j = 0; j < 400; j++) {
            double x = -L + (j + 0.5) * 0.01, T = series_box(x, L, A, s).at.value;
            apart += fabs(series_box_line(x, A, s) - T);
            size += T;
        }
        share[i] = apart / size;
        claim_number(m, share[i], "", "sum of differences over sum of T at %g s", time[i]);
    }
    claim_number(m, 2 * printed(L, 5, KAPPA, KAPPA) / T0 / 2, "", "T(L)/T0 of eq. 45 at 5 s");
    claim_decide(m, share[0] <= 0.01 * smallest, share[1] <= 0.01 * smallest,
                 "eq. 45 misses the walls by at most 1 %% of the smallest error of Table 1, %.4g: at 5 s, as "
                 "published, and ten times later",
                 smallest);
}

/* ---- The other forms of the Laplacian, on the lattice and off it ---- */

static const char SMOOTH[] = "run rect-manufactured %s --set k_y=0.02 --dx %g%s";
static const char SHAKEN[] = " --layout jitter --jitter 0.1 --seed 1";

/* On the lattice and with places up to 0.1 dx off: E1 at dx = 0.025 m, and its order from 0.05; and the largest
 * growth rate with places up to 0.3 dx off, kappa/dx^2 (0 where none grows). */
struct shaken {
    double error[2], order[2], growth;
};

static int shake(const char *method, struct shaken *out, struct claims_measured *m) {
    struct result coarse, fine;
    struct model_problem b;
    struct step_limit limit;
    *out = (struct shaken){{NAN, NAN}, {NAN, NAN}, NAN};
    for (int off = 0; off < 2; off++) {
        if (claim_result(&coarse, m, SMOOTH, method, 0.05, off ? SHAKEN : "") ||
            claim_result(&fine, m, SMOOTH, method, 0.025, off ? SHAKEN : ""))
            return 1;
        out->error[off] = fine.error.l1, out->order[off] = log2(coarse.error.l1 / fine.error.l1);
        claim_number(m, out->error[off], "", "E1 of %s, %s", method, off ? "0.1 dx off" : "lattice");
        claim_number(m, out->order[off], "", "its order");
    }
    if (claim_model(&b, &limit, m, "limit %s --dim 2 --layout jitter --jitter 0.3 --seed 1", method)) return 1;
    out->growth = limit.grows ? limit.growth : 0;
    claim_number(m, out->growth, "kappa/dx^2", "growth 0.3 dx off");
    return 0;
}

/* 1.5: nearer to an order lost than to none.  Seeds 1 to 3 give 0.58 to 1.28 for those that lose it, and the same
 * methods a growing mode: no verdict hangs on the draw. */
static int is_sensitive(const struct shaken *of) {
    return of->order[0] >= 1.9 && of->order[1] < 1.5;
}

/* METHOD: its order where places are off. */
void ledger_order_sensitive(struct claims_measured *m) {
    struct shaken of;
    if (shake(m->argument, &of, m)) return;
    claim_decide(m, is_sensitive(&of), 1,
                 "of second order on the lattice, and half an order short of it with places 0.1 dx off");
}

/* METHOD: and a run of small steps that leaves all bounds. */
void ledger_order_diverges(struct claims_measured *m) {
    struct shaken of;
    struct result run;
    if (shake(m->argument, &of, m)) return;
    int fails = claim_result(&run, NULL, "run rect-manufactured %s --set k_y=0.02 --dx 0.05%s", m->argument,
                             " --layout jitter --jitter 0.3 --seed 1 --stepper euler --fourier 0.05") != 0;
    claim_number(m, fails, "", "runs that leave their bounds, 0.3 dx off, F = 0.05");
    claim_decide(m, is_sensitive(&of) && fails && of.growth > 0, 1,
                 "half an order short with places 0.1 dx off; 0.3 dx off a mode grows and a run fails");
}

/* "METHOD | METHOD | ...": the first where particles are in disorder, against the others. */
void ledger_order_steadier(struct claims_measured *m) {
    struct shaken of, other;
    char method[40];
    int better = 1;
    claim_part(&m->argument, method, sizeof method);
    if (shake(method, &of, m)) return;
    while (claim_part(&m->argument, method, sizeof method)) {
        if (shake(method, &other, m)) return;
        better &= of.error[1] < other.error[1] && other.growth > 0;
    }
    claim_decide(m, better && of.growth == 0, !is_sensitive(&of),
                 "the least E1 with places off, and the only one without a growing mode; without a condition if "
                 "it keeps its order");
}

/* "METHOD | METHOD": accuracy and stability of the first against the second. */
void ledger_order_better(struct claims_measured *m) {
    struct shaken of[2];
    double step[2];
    for (int k = 0; k < 2; k++) {
        char method[40];
        struct model_problem b;
        struct step_limit limit;
        claim_part(&m->argument, method, sizeof method);
        if (shake(method, &of[k], m) || claim_model(&b, &limit, m, "limit %s --dim 2", method)) return;
        step[k] = limit.von_neumann;
        claim_number(m, step[k], "dx^2/kappa", "largest step on the lattice");
    }
    claim_decide(m, of[0].error[1] < of[1].error[1] && step[0] > step[1],
                 of[0].error[0] < of[1].error[0] && of[0].growth == 0,
                 "less error with places off and a larger step on the lattice; without a condition if also less "
                 "error there, and no growth 0.3 dx off");
}
