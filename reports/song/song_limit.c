/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Song 2018, section 4.4: the amplification factor of Euler steps and the limits drawn from it.
 *
 * On a lattice the stencils are even (SO) and odd (FO), so that G = 1 + dt S with S real, and |G| <= 1 for all wave
 * numbers is dt <= 2/max(-S): the true limit.  Published:
 *
 *   SO  eq. 34  dt <= 1/|kappa_x eta_i + kappa_y phi_i|, the central weight
 *   FO  eq. 41  dt <= 1/(2 (kappa_x (sum |lambda_j|)^2 + kappa_y (sum |gamma_j|)^2)) */
#include "reports/ledger/claim.h"
#include "reports/song/song.h"

#include "verification/stability/symbol.h"

#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct step_limits {
    double published, actual; /* s, at dx = 0.1 m and kappa = 0.01 m^2/s */
};

/* Limits at h/dx and kappa_y/kappa_x.  Returns 0, or the status; *m, unless NULL, is then failed. */
static int limits_at(int dim, const char *method, const char *kernel, double h, double ratio, struct step_limits *l,
                     struct claims_measured *m) {
    struct model_problem b;
    struct step_limit limit;
    char unequal[40] = "";
    if (ratio < 1) snprintf(unequal, sizeof unequal, " --ratio %.10g", ratio);
    int status =
        claim_model(&b, &limit, m, "limit %s --dim %d --kernel %s --h %.10g%s", method, dim, kernel, h, unequal);
    if (!status) *l = (struct step_limits){0.1 * 0.1 / 0.01 * limit.published, 0.1 * 0.1 / 0.01 * limit.von_neumann};
    return status;
}

/* "METHOD SECONDS": a limit that the text quotes for rod-step, dx = 0.1, h = 1.05 dx. */
void song_limit_quoted_limit(struct claims_measured *m) {
    char method[32];
    struct step_limits l;
    snprintf(method, sizeof method, "%.*s", (int)strcspn(m->argument, " "), m->argument);
    double quoted = atof(m->argument + strlen(method));
    if (limits_at(1, method, "cubic", 1.05, 1, &l, m)) return;
    claim_number(m, l.published, "s", "by the paper's formula");
    claim_number(m, l.actual, "s", "|G| <= 1");
    claim_number(m, quoted / l.published, "", "quoted over formula");
    /* one digit is printed: 10 % */
    claim_decide(m, quoted <= 1.1 * l.actual, fabs(quoted / l.published - 1) <= 0.1,
                 "the quoted limit is stable to its one digit, and the formula gives it to that digit");
}

struct scan {
    double ratio, h;
    const char *kernel;
    int dim;
};

/* The largest published/actual over kernels, dimensions and h/dx = 1.02, 1.07 ... 2.02. */
static int scan(const char *method, struct scan *worst, struct claims_measured *m) {
    *worst = (struct scan){.ratio = 0};
    for (int dim = 1; dim <= 2; dim++)
        for (int k = 0; kernel_words[k]; k++)
            for (int i = 0; i <= 20; i++) {
                struct step_limits l;
                double h = 1.02 + 0.05 * i;
                if (limits_at(dim, method, kernel_words[k], h, 1, &l, m)) return 1;
                if (l.published / l.actual > worst->ratio)
                    *worst = (struct scan){l.published / l.actual, h, kernel_words[k], dim};
            }
    return 0;
}

/* "METHOD": tests whether a step at the published limit is stable. */
void song_limit_bound(struct claims_measured *m) {
    struct step_limits rod, square;
    struct scan worst;
    if (limits_at(1, m->argument, "cubic", 1.05, 1, &rod, m) ||
        limits_at(2, m->argument, "cubic", 1.1, 1, &square, m) || scan(m->argument, &worst, m))
        return;
    double as_run = fmax(rod.published / rod.actual, square.published / square.actual);
    claim_number(m, rod.actual / rod.published, "", "true limit over published, rod as run");
    claim_number(m, square.actual / square.published, "", "true limit over published, square as run");
    claim_number(m, 1 / worst.ratio, "", "the same, worst: %s kernel, %dD, h/dx = %.2f", worst.kernel, worst.dim,
                 worst.h);
    /* 0.1 % for the search over wave numbers */
    claim_decide(m, as_run <= 1.001, worst.ratio <= 1.001,
                 "a step at the published limit has |G| <= 1: in the paper's runs; with any of three kernels, "
                 "h/dx 1.02 to 2.02, 1D and 2D");
}

/* The status of 4000 Euler steps of dt, s, at dx = 0.1 m. */
static int run_steps(const char *words, double dt) {
    struct result run;
    return claim_result(&run, NULL, "run %s --dx 0.1 --stepper euler --dt %.10g --t-end %.10g", words, dt, 4000 * dt);
}

/* A run at 99 % of eq. 34 where the scan above finds weights that it does not cover: a rod, quartic kernel. */
void song_limit_blow_up(struct claims_measured *m) {
    struct step_limits l, worst = {0, 1};
    double h = 0;
    char words[80];
    int status[2];
    for (int i = 0; i <= 30; i++) {
        double at = 1.01 + 0.01 * i;
        if (limits_at(1, "so_ssph", "quartic", at, 1, &l, NULL)) continue;
        if (l.published / l.actual > worst.published / worst.actual) worst = l, h = at;
    }
    snprintf(words, sizeof words, "rod-step so_ssph --kernel quartic --h %.4g", h);
    for (int i = 0; i < 2; i++) status[i] = run_steps(words, 0.99 * (i ? worst.actual : worst.published));
    claim_number(m, h, "", "h/dx");
    claim_number(m, worst.published, "s", "eq. 34");
    claim_number(m, worst.actual, "s", "|G| <= 1");
    claim_number(m, status[0] == STATUS_UNSTABLE, "", "runs of 4000 steps at 0.99 of eq. 34 that blow up");
    claim_number(m, status[1] == STATUS_UNSTABLE, "", "the same at 0.99 of |G| <= 1");
    claim_decide(m, status[0] == STATUS_OK, status[1] == STATUS_OK, "a run at 0.99 of eq. 34 stays bounded");
}

static const char square_line[] = "run square-step so_ssph --dx 0.1 --h 1.1";

/* Eq. 34 where the two diffusivities differ, and runs of 4000 steps at 0.99 of it and of the true limit. */
void song_limit_unequal(struct claims_measured *m) {
    static const double ratio[4] = {1, 0.25, 0.1, 1e-9};
    struct step_limits l[4];
    double worst = 0;
    int status[2];
    for (int i = 0; i < 4; i++) {
        if (limits_at(2, "so_ssph", "cubic", 1.1, ratio[i], &l[i], m)) return;
        double over = l[i].published / l[i].actual;
        claim_number(m, over, "", "eq. 34 over |G| <= 1, kappa_y/kappa_x = %g", ratio[i]);
        worst = fmax(worst, over);
    }
    for (int i = 0; i < 2; i++) {
        double dt = 0.99 * (i ? l[2].actual : l[2].published);
        status[i] = run_steps("square-step so_ssph --h 1.1 --set kappa_y=0.001", dt);
        claim_number(m, dt, "s", "0.99 of %s at 1/10", i ? "|G| <= 1" : "eq. 34");
        claim_number(m, status[i] == STATUS_UNSTABLE, "", "runs of 4000 such steps that blow up");
    }
    claim_decide(m, worst <= 1.001 && status[0] == STATUS_OK, status[1] == STATUS_OK,
                 "a step at eq. 34 has |G| <= 1 (to 0.1 %%), and a run at 0.99 of it stays bounded, for kappa_y "
                 "from 1e-9 kappa_x to kappa_x");
}

/* Weights and undershoots where the two diffusivities differ. */
void song_limit_unequal_weights(struct claims_measured *m) {
    static const double ratio[3] = {1, 0.1, 0.01};
    double lowest = 0, below = 0;
    for (int i = 0; i < 3; i++) {
        struct model_problem b;
        struct symbol s;
        struct result run;
        struct failure why;
        if (claim_model(&b, NULL, m, "limit so_ssph --dim 2 --h 1.1 --ratio %g", ratio[i])) return;
        if (symbol_create(&s, &b, &why) && claim_fail(m, why.text)) return;
        double least = symbol_lowest(&s);
        symbol_free(&s);
        if (claim_result(&run, m, "%s --set kappa_y=%g", square_line, 0.01 * ratio[i])) return;
        claim_number(m, 100 * least, "%", "lowest weight, of the centre's, kappa_y/kappa_x = %g", ratio[i]);
        claim_number(m, run.shape.undershoot, "K", "undershoot below 0 K at 5 s");
        if (i == 0) continue;
        lowest = fmin(lowest, least);
        below = fmax(below, run.shape.undershoot);
    }
    claim_decide(m, below <= 1e-11, lowest >= 0,
                 "no undershoot (to rounding, 1e-11 K) at kappa_y = kappa_x/10 and /100");
}

static const double theta[2] = {0.7, 1.9}; /* radians a particle */

/* sum w_j (1 - exp(i nu h_j)) */
static double complex transfer(const struct claim_cell *cell, const double *w, double dx) {
    double complex sum = 0;
    for (size_t j = 0; j < cell->nb.n; j++)
        sum += w[j] * (1 - cexp(I * (theta[0] * cell->d[j][0] + theta[1] * cell->d[j][1]) / dx));
    return sum;
}

/* G of eq. 33 as printed, eta with kappa_y and phi with kappa_x, compared with one step of the scheme on a plane
 * wave. "versions": also with the journal's web page, which has kappa_y in both and, in eq. 34, kappa_x in both. */
void song_limit_eq33(struct claims_measured *m) {
    static const double kappas[2][2] = {{0.01, 0.01}, {0.013, 0.004}};
    static const double one[2][2] = {{1, 0}, {0, 1}};
    const double dt = 0.1;
    struct claim_cell cell, part[2];
    double apart[2], web[2], limit[2];
    for (int a = 0; a < 2; a++)
        if (claim_weights(&part[a], one[a], m, square_line)) return;
    for (int i = 0; i < 2; i++) {
        if (claim_weights(&cell, kappas[i], m, square_line)) return;
        double complex step = 1 - dt * transfer(&cell, cell.w[0], 0.1);
        double complex printed = 1 - dt * (kappas[i][1] * transfer(&part[0], part[0].w[0], 0.1) +
                                           kappas[i][0] * transfer(&part[1], part[1].w[0], 0.1));
        double complex on_the_web =
            1 - dt * kappas[i][1] * (transfer(&part[0], part[0].w[0], 0.1) + transfer(&part[1], part[1].w[0], 0.1));
        double centre[2] = {0, 0}; /* centre weights: of the step; of eta + phi */
        for (size_t j = 0; j < cell.nb.n; j++) {
            centre[0] += cell.w[0][j];
            centre[1] += part[0].w[0][j] + part[1].w[0][j];
        }
        limit[i] = centre[0] / (kappas[i][0] * centre[1]);
        apart[i] = cabs(step - printed);
        web[i] = cabs(step - on_the_web);
    }
    int versions = m->argument[0] == 'v';
    claim_number(m, apart[0], "", "|G printed - G| for kappa_x = kappa_y");
    claim_number(m, apart[1], "", "for kappa_x = 0.013, kappa_y = 0.004");
    if (versions) {
        claim_number(m, web[1], "", "the same, eq. 33 of the web page");
        claim_number(m, limit[1], "", "dt of eq. 34 on the web page over the PDF's");
        claim_decide(m, fabs(web[1] - apart[1]) <= 1e-12 && fabs(limit[1] - 1) <= 1e-12, 1,
                     "eqs. 33 and 34 are the same in both (to rounding, 1e-12) where the diffusivities differ");
        return;
    }
    claim_decide(m, apart[0] <= 1e-12, apart[1] <= 1e-12,
                 "the two agree to rounding (1e-12): for one diffusivity, and for two");
}

/* G of eqs. 39 and 40 as printed, with a minus sign before the square, against one step of the scheme. */
void song_limit_eq39(struct claims_measured *m) {
    struct claim_cell cell;
    const double kappa[2] = {0.01, 0}, dt = 0.5; /* s, by eq. 41 */
    if (claim_weights(&cell, kappa, m, "run rod-step fo_ssph --dx 0.1 --h 1.05")) return;
    double complex square = cpow(transfer(&cell, cell.w[0], 0.1), 2);
    double complex printed = 1 - kappa[0] * dt * square, step = 1 + kappa[0] * dt * square;
    claim_number(m, cabs(printed), "", "|G| as printed, dt by eq. 41");
    claim_number(m, cabs(step), "", "|G| of the step (eq. 38)");
    claim_decide(m, cabs(printed - step) <= 1e-12, 1, "the two agree to rounding (1e-12)");
}
