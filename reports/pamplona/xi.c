/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pamplona 2019, eq. 18 and Figs. 7 and 8: the xi that makes the error least, over h and material, and the cost.
 *
 * A tuned volume only scales the rate of heating, so that the best xi has a closed form (xi.h).  Its slope in log h
 * is 1/3 at h = 0.006 m.  On the plate as stated the ghosts make the plate late by ((n + 1)/n)^2 (plate.c), and the
 * best xi takes back most of that as well. */
#include "reports/pamplona/xi.h"

#include "solver/space/kernel.h"
#include "reports/ledger/claim.h"
#include "reports/pamplona/pamplona.h"
#include "reports/pamplona/plate.h"

#include <gsl/gsl_fit.h>
#include <math.h>
#include <stdlib.h>

const char *const xi_materials[XI_MATERIALS] = {"steel", "titanium", "vanadium"};

double xi_diffusivity(int material) {
    static const double alpha[XI_MATERIALS] = {60.5 / (7854 * 434.), 21.9 / (4500 * 522.), 30.7 / (6100 * 489.)};
    return alpha[material];
}

double xi_h(int n) {
    return 1.2 * 0.1 / n;
}

double xi_eq18(double h) {
    return 9 * cbrt(h);
}

/* `vector`: F as printed, with the component x_ij in place of r. */
static double moment(enum kernel_name kernel, double h, double eta, int vector) {
    double M = 0;
    int reach = (int)ceil(2 * h);
    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++) {
            double r = hypot(i, j) / h; /* in h; one dx is 1/h */
            if (r >= KERNEL_SUPPORT) continue;
            M -= kernel_slope(kernel, 2, r) * (vector ? i / h : r) / (r * r + eta * eta) * i * i / pow(h, 4);
        }
    return M;
}

double xi_moment(enum kernel_name kernel, double h, double eta) {
    return moment(kernel, h, eta, 0);
}

double xi_closed_form(int n, enum kernel_name kernel) {
    return pow((n + 4.0) / n, 2) / xi_moment(kernel, 1.2, 0.1);
}

double xi_error(struct xi_best *b, double xi) {
    struct command_run run;
    struct plate_errors e = {.average = NAN};
    double h = xi_h(b->n);
    if (!command_run_read(&run,
                          "run plate brookshaw --kernel %s --h 1.2 --volume tuned --walls %s --dx 0.1/%d "
                          "--stepper rk2 --set material=%s",
                          kernel_words[b->kernel], b->walls ? b->walls : "fixed", b->n, xi_materials[b->material])) {
        struct experiment *r = &run.typed.experiment;
        r->options.xi = xi;
        r->options.dt = b->beta * h * h / xi_diffusivity(b->material);
        r->problem.t_end = b->t;
        command_run_solve(&run);
    }
    if (!command_run_check(&run, &b->failure)) {
        plate_measure(&run, b->t, &e);
        b->work = run.result.cost.interactions;
        b->seconds = run.result.cost.seconds;
    }
    command_run_free(&run);
    return e.average;
}

void xi_find(struct xi_best *b) {
    const double golden = (sqrt(5) - 1) / 2;
    double lo = 0.9 * xi_closed_form(b->n, b->kernel), hi = 1.4 * xi_closed_form(b->n, b->kernel);
    double u = hi - golden * (hi - lo), v = lo + golden * (hi - lo), eu = xi_error(b, u), ev = xi_error(b, v);
    while (hi - lo > 5e-4 && !b->failure.status) {
        if (eu < ev) {
            hi = v, v = u, ev = eu;
            eu = xi_error(b, u = hi - golden * (hi - lo));
        } else {
            lo = u, u = v, eu = ev;
            ev = xi_error(b, v = lo + golden * (hi - lo));
        }
    }
    b->xi = (lo + hi) / 2;
    b->error = fmin(eu, ev);
}

struct xi_line xi_growth(const double *h, const double *work, int n, int power) {
    double *u = xcalloc(2 * (size_t)n, sizeof *u), *v = u + n, c00, c01, c11, left;
    struct xi_line l;
    for (int i = 0; i < n; i++) {
        u[i] = power ? log10(h[i]) : h[i];
        v[i] = log10(work[i]);
    }
    gsl_fit_linear(u, 1, v, 1, (size_t)n, &l.at, &l.slope, &c00, &c01, &c11, &left);
    l.off = pow(10, sqrt(left / n)) - 1;
    free(u);
    return l;
}

struct xi_best xi_as_stated(int n, int material) {
    return (struct xi_best){.n = n, .material = material, .kernel = KERNEL_CUBIC, .beta = 0.08, .t = plate_time(0)};
}

/* ---- Claims ---- */

/* xi_find; 0, or *m failed. */
static int find(struct xi_best *b, struct claims_measured *m) {
    xi_find(b);
    return b->failure.status && claim_fail(m, b->failure.text);
}

/* Eq. 12 as printed, a vector, in place of the factor that eq. 13 multiplies by. */
void pamplona_xi_eq12(struct claims_measured *m) {
    double printed = moment(KERNEL_QUARTIC, 1.2, 0.1, 1), meant = xi_moment(KERNEL_QUARTIC, 1.2, 0.1);
    claim_number(m, printed, "", "eq. 13's answer to x^2/2 with x_ij, component along x (1 is exact)");
    claim_number(m, meant, "", "with r_ij");
    claim_decide(m, fabs(printed - meant) <= 0.01, 1, "a component of F_ij as printed answers as r_ij does (0.01)");
}

/* Eq. 13 as it stands, with the volume dx^2: its answer to x^2/2. */
void pamplona_xi_eq13(struct claims_measured *m) {
    static const double h[] = {1.2, 2, 3};
    double worst = 0, as_run = fabs(xi_moment(KERNEL_QUARTIC, h[0], 0.1) - 1);
    for (int i = 0; i < 3; i++) {
        double M = xi_moment(KERNEL_QUARTIC, h[i], 0.1);
        claim_number(m, M, "", "answer to x^2/2, where 1 is exact, h/dx = %g", h[i]);
        worst = fmax(worst, fabs(M - 1));
    }
    claim_decide(m, as_run <= 0.15, worst <= 0.01,
                 "within 15 %% as run, since the paper tunes xi for what is left; within 1 %% at every h/dx for no "
                 "condition");
}

/* The law is 9 h^(1/3), and a coefficient printed as 9 is in [8.5, 9.5).  It fits an h if the best xi/h^(1/3) is in
 * this range, with the kernel of the public code and with the printed one. */
void pamplona_xi_eq18(struct claims_measured *m) {
    static const int n[] = {18, 20, 24, 30};
    static const enum kernel_name kernel[] = {KERNEL_CUBIC, KERNEL_QUARTIC};
    int suits[2] = {1, 1};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 4; i++) {
            struct xi_best b = xi_as_stated(n[i], 0);
            b.kernel = kernel[k];
            if (find(&b, m)) return;
            double c = b.xi / cbrt(xi_h(n[i]));
            suits[k] &= 8.5 <= c && c < 9.5;
            claim_number(m, c, "m^(2/3)", "best xi/h^(1/3) at h = %.4g m, %s kernel", xi_h(n[i]),
                         kernel_words[kernel[k]]);
        }
    claim_decide(m, suits[0], suits[1],
                 "best xi/h^(1/3) rounds to 9, the digit that is printed, at each h up to 0.007 m: with the cubic "
                 "kernel of the public code; without a condition with the printed quartic too");
}

/* The error that eq. 18 adds to the least one.  Two numbers are printed, 9 and 3.5: they agree where some factor that
 * rounds to 9 adds an error that rounds to 3.5 %.  The error falls as xi rises to the best one. */
void pamplona_xi_eq18_rise(struct claims_measured *m) {
    static const enum kernel_name kernel[] = {KERNEL_QUARTIC, KERNEL_CUBIC};
    static const double factor[] = {8.5, 9, 9.5};
    int agree[2];
    for (int k = 0; k < 2; k++) {
        struct xi_best b = xi_as_stated(PLATE_SIDE, 0);
        double rise[3];
        b.kernel = kernel[k];
        if (find(&b, m)) return;
        claim_number(m, b.error, "%", "error at the best xi, %s kernel", kernel_words[kernel[k]]);
        for (int i = 0; i < 3; i++) {
            rise[i] = xi_error(&b, factor[i] * cbrt(xi_h(b.n))) - b.error;
            claim_number(m, rise[i], "%", "added by %g h^(1/3)", factor[i]);
        }
        agree[k] = fmin(rise[0], rise[2]) < 3.55 && rise[0] >= 3.45;
    }
    claim_decide(m, agree[0], agree[1],
                 "a factor that rounds to 9 adds an error that rounds to 3.5 %% at h = 0.006 m: with the printed "
                 "kernel; without a condition with the public code's too");
}

void pamplona_xi_xi_materials(struct claims_measured *m) {
    static const int n[] = {13, 17, 20, 24};
    double most = 0;
    for (int i = 0; i < 4; i++) {
        double mean = 0, sum = 0;
        for (int k = 0; k < XI_MATERIALS; k++) {
            struct xi_best b = xi_as_stated(n[i], k);
            if (find(&b, m)) return;
            mean += b.xi / XI_MATERIALS;
            sum += b.xi * b.xi / XI_MATERIALS;
        }
        double spread = sqrt(fmax(0, sum - mean * mean));
        claim_number(m, spread, "m", "h = %.4f m", xi_h(n[i]));
        most = fmax(most, spread);
    }
    claim_decide(m, most <= 0.0302 + 5e-4, 1,
                 "standard deviation of the fitted xi over the three materials at most 0.0302 m, xi being fitted "
                 "to 5e-4 m");
}

/* Tests whether the divergence of materials is caused by their time steps: with smaller steps, and at equal alpha
 * t. */
void pamplona_xi_xi_divergence(struct claims_measured *m) {
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {0};
    for (int k = 0; k < XI_MATERIALS; k++) {
        struct xi_best b = xi_as_stated(PLATE_SIDE, k), slow = b, equal = b;
        slow.beta /= 8;
        equal.t *= xi_diffusivity(0) / xi_diffusivity(k);
        if (find(&b, m) || find(&equal, m)) return;
        const double error[3] = {b.error, xi_error(&slow, b.xi), equal.error};
        for (int i = 0; i < 3; i++) {
            lo[i] = fmin(lo[i], error[i]);
            hi[i] = fmax(hi[i], error[i]);
        }
    }
    claim_number(m, hi[0] - lo[0], "%", "errors of the materials differ by");
    claim_number(m, hi[1] - lo[1], "%", "with an eighth of the step");
    claim_number(m, hi[2] - lo[2], "%", "at equal alpha t and equal steps");
    claim_decide(m, hi[1] - lo[1] <= 0.5 * (hi[0] - lo[0]), 1,
                 "caused by the step if an eighth of it at least halves the difference");
}

/* Eq. 19 between n = 13 and 24, h = 0.0092 and 0.005 m, of the best error; NaN with *m failed. */
static double order_of(int material, const char *walls, struct claims_measured *m) {
    struct xi_best a = xi_as_stated(13, material), b = xi_as_stated(24, material);
    a.walls = b.walls = walls;
    return find(&a, m) || find(&b, m) ? NAN : log(a.error / b.error) / log(xi_h(a.n) / xi_h(b.n));
}

void pamplona_xi_observed_order(struct claims_measured *m) {
    double order[2] = {0, 0};
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < XI_MATERIALS; k++) {
            double p = order_of(k, i ? "mirror" : "fixed", m);
            if (isnan(p)) return;
            order[i] += p / XI_MATERIALS;
            if (i == 0) claim_number(m, p, "", "order, %s", xi_materials[k]);
        }
    claim_number(m, order[0], "", "mean");
    claim_number(m, order[1], "", "mean, mirror walls");
    claim_decide(m, fabs(order[0] - 1) <= 0.2, fabs(order[1] - 1) <= 0.2 && fabs(order[0] - 1.1253) <= 0.1,
                 "first order +- 0.2 as published; no condition if with exact walls too, and within 0.1 of "
                 "1.1253");
}

/* The order of FTCS on the same plates, by eq. 19. */
void pamplona_xi_same_order(struct claims_measured *m) {
    static const char *const walls[2] = {"fixed", "mirror"};
    static const int n[2] = {13, 24};
    double p[2], sph = order_of(0, "fixed", m);
    for (int i = 0; i < 2; i++) {
        double error[2];
        for (int k = 0; k < 2; k++) {
            struct command_run run;
            struct plate_errors e;
            int bad = claim_run(&run, m, "run plate ftcs --walls %s --dx 0.1/%d --fourier 0.0576 --t-end %g",
                                walls[i], n[k], plate_time(0));
            if (!bad) plate_measure(&run, plate_time(0), &e);
            command_run_free(&run);
            if (bad || isnan(sph)) return;
            error[k] = e.average;
        }
        p[i] = log(error[0] / error[1]) / log(xi_h(n[0]) / xi_h(n[1]));
    }
    claim_number(m, sph, "", "order of SPH at its best xi, steel");
    claim_number(m, p[0], "", "order of FTCS, fixed ghosts");
    claim_number(m, p[1], "", "with mirror ghosts");
    claim_decide(m, fabs(p[0] - sph) <= 0.2, 1, "the two orders within 0.2, with fixed ghosts as published");
}

/* Section 6: with xi kept, a smaller h heats faster. */
void pamplona_xi_xi_direction(struct claims_measured *m) {
    double coarse = 1.643 * pow(13 / 17., 2), fine = 1.643 * pow(24 / 28., 2), M = xi_moment(KERNEL_CUBIC, 1.2, 0.1);
    claim_number(m, coarse * M, "", "rate over the true one, xi = 1.643 m, h = %.4f m", xi_h(13));
    claim_number(m, fine * M, "", "h = %.4f m", xi_h(24));
    claim_decide(m, fine > coarse, 1, "with xi kept, the particles conduct faster at the smaller h");
}
