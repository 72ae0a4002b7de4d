/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pamplona 2019, eq. 18 and Figs. 7 and 8: the xi that makes the error least, over h and material, and the cost.
 *
 * A tuned volume only scales the rate of heating, so that the best xi has a closed form (xi.h).  Its slope in log h
 * is 1/3 at h = 0.006 m.  On the plate as stated the ghosts make the plate late by ((n + 1)/n)^2 (plate.c), and the
 * best xi takes back most of that as well. */
#include "reports/pamplona/xi.h"

#include "solver/space/kernel.h"
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

double xi_moment_printed(enum kernel_name kernel, double h, double eta) {
    return moment(kernel, h, eta, 1);
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
