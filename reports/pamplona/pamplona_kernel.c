/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pamplona 2019, eqs. 9, 11, 14 to 17, Fig. 8: the kernel, the particles' mass, time steps and their cost. */
#include "reports/ledger/claim.h"
#include "reports/pamplona/pamplona.h"

#include "solver/space/kernel.h"
#include "reports/pamplona/plate.h"
#include "reports/pamplona/xi.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double RHO = 7854; /* steel, section 6: kg/m^3 */

/* Eq. 9 with every sign as printed. */
static double printed_kernel(int dim, double s) {
    const double pi = M_PI, norm[3] = {1, 15 / (7 * pi), 315 / (208 * pi)};
    return norm[dim - 1] * (2.0 / 3 + s * s * (9.0 / 8 + s * (19.0 / 24 + s * 5 / 32)));
}

/* Integral over all space, by Simpson's rule on 400 pieces. */
static double integral(int dim, double (*w)(int dim, double s)) {
    enum { PIECES = 400 };
    const double pi = M_PI, shell[3] = {2, 2 * pi, 4 * pi};
    double sum = 0, step = 2.0 / PIECES;
    for (int i = 0; i < PIECES; i++) { /* open at s = 2, where the kernel is cut off */
        double s = i * step, sample[3] = {s, s + step / 2, s + step * (1 - 1e-15)};
        static const double weight[3] = {1, 4, 1};
        for (int k = 0; k < 3; k++)
            sum += weight[k] * step / 6 * shell[dim - 1] * pow(sample[k], dim - 1) * w(dim, sample[k]);
    }
    return sum;
}

static double quartic(int dim, double s) {
    return kernel_value(KERNEL_QUARTIC, dim, s);
}

void pamplona_kernel_eq9(struct claims_measured *m) {
    double worst[2] = {0, 0};
    for (int dim = 1; dim <= 3; dim++) {
        double as_printed = integral(dim, printed_kernel);
        claim_number(m, as_printed, "", "integral in %dD", dim);
        worst[0] = fmax(worst[0], fabs(as_printed - 1));
        worst[1] = fmax(worst[1], fabs(integral(dim, quartic) - 1));
    }
    claim_number(m, worst[1], "", "|integral - 1|, signs - + - as meant, worst");
    claim_decide(m, worst[0] <= 1e-9, 1, "integral 1 in 1D, 2D and 3D (to 1e-9, the quadrature's error)");
}

/* "positive, decreasing monotonous": the kernel as meant. */
void pamplona_kernel_kernel_shape(struct claims_measured *m) {
    double least = INFINITY, turns = 2, scale = quartic(2, 0);
    for (int i = 1; i < 2000; i++) {
        double s = 0.001 * i;
        least = fmin(least, quartic(2, s) / scale);
        if (kernel_slope(KERNEL_QUARTIC, 2, s) > 1e-12 * scale) turns = fmin(turns, s);
    }
    claim_number(m, least, "", "smallest w(s)/w(0)");
    claim_number(m, turns, "", "rises from s =");
    claim_decide(m, least >= 0 && turns >= 2, 1, "w >= 0 and dw/ds <= 0 for all s < 2");
}

void pamplona_kernel_mass(struct claims_measured *m) {
    const double all = RHO * 0.1 * 0.1 * 1.643, real = all / 400, counted = all / 576;
    claim_number(m, real, "kg", "eq. 14, N = 400");
    claim_number(m, counted, "kg", "N = 576, ghosts counted");
    int is_real = fabs(real - 0.224) <= 0.0005, is_counted = fabs(counted - 0.224) <= 0.0005;
    claim_decide(m, is_real || is_counted, is_real,
                 "0.224 kg to its three digits with N the particles of the plate; on condition, with another N");
}

void pamplona_kernel_ghosts(struct claims_measured *m) {
    const int n = 20, layers = (int)floor(2 * 1.2), ghosts = (n + 2 * layers) * (n + 2 * layers) - n * n;
    claim_number(m, n * n, "", "particles at dx = 0.005 m");
    claim_number(m, ghosts, "", "ghosts in the two layers that 2 h = 2.4 dx reaches");
    claim_decide(m, n * n == 400 && ghosts == 176, 1, "both numbers exactly");
}

/* "the time to reach the steady-state is inversely proportional to mass": the same field in half the time. */
void pamplona_kernel_mass_rate(struct claims_measured *m) {
    static const char command[] = "run plate brookshaw --dx 0.005 --kernel cubic --h 1.2 --walls fixed --volume "
                                  "tuned --stepper rk2 --xi %g --dt %g --t-end %g";
    struct command_run once, twice;
    int bad = claim_run(&once, m, command, 1.2, 0.1, 20.0) | claim_run(&twice, m, command, 2.4, 0.05, 10.0);
    double apart = bad ? NAN : field_farthest(&once.field, twice.field.T);
    command_run_free(&once);
    command_run_free(&twice);
    if (bad) return;
    claim_number(m, apart, "K", "largest difference, xi = 1.2 m at 20 s and 2.4 m at 10 s");
    claim_decide(m, apart <= 1e-12, 1, "twice the mass gives the same field in half the time, to rounding");
}

/* 1 if a run to the last time of Table 1 stays bounded; gamma as in eq. 17. */
static int stable(double gamma) {
    struct result run;
    return !claim_result(&run, NULL, "run plate ftcs --dx 0.005 --fourier %.10g --t-end %.10g", 2 * gamma,
                         plate_time(PLATE_TIMES - 1));
}

void pamplona_kernel_eq17(struct claims_measured *m) {
    double lo = 0.05, hi = 0.5;
    int published = stable(0.25);
    while (hi / lo > 1.002) {
        double middle = sqrt(lo * hi);
        if (stable(middle))
            lo = middle;
        else
            hi = middle;
    }
    claim_number(m, published, "", "runs at gamma = 1/4 that stay bounded");
    claim_number(m, lo, "", "largest gamma of a bounded run");
    claim_number(m, 0.125, "", "by |G| <= 1, dx = dy");
    claim_decide(m, published, lo <= 0.26, "a run at gamma = 1/4 stays bounded, and 1/4 is the limit");
}

enum { HALVINGS = 5 };

/* "ORDER | words": order in dt of one run, from differences between halved steps (Richardson). */
void pamplona_kernel_time_order(struct claims_measured *m) {
    char part[200];
    struct command_run run[HALVINGS] = {0};
    double dt[HALVINGS], apart[HALVINGS] = {0};
    int bad = 0;
    claim_part(&m->argument, part, sizeof part);
    double order = atof(part);
    claim_part(&m->argument, part, sizeof part);
    for (int i = 0; i < HALVINGS; i++) {
        dt[i] = plate_time(0) / (200 << i);
        bad |= claim_run(&run[i], m, "run %s --dt %.17g", part, dt[i]);
    }
    for (int i = 0; i + 1 < HALVINGS && !bad; i++)
        for (size_t k = 0; k < run[i].field.n; k++) apart[i] += fabs(run[i].field.T[k] - run[i + 1].field.T[k]);
    for (int i = 0; i < HALVINGS; i++) command_run_free(&run[i]);
    if (bad) return;
    int held;
    struct judged rungs = {.x = dt, .error = apart, .n = HALVINGS - 1};
    claim_number(m, slope_fit(dt, apart, HALVINGS - 1).value, "", "order in dt");
    if (claim_judge(&held, m, &rungs, order - 0.1, order + 0.1)) return;
    claim_decide(m, held, 1,
                 "differences between runs whose step is halved fall with dt to the power %g +- 0.1, by the "
                 "rule of the gates",
                 order);
}

void pamplona_kernel_step_order(struct claims_measured *m) {
    double dt[XI_MATERIALS];
    for (int i = 0; i < XI_MATERIALS; i++) {
        dt[i] = 0.08 * 0.006 * 0.006 / xi_diffusivity(i);
        claim_number(m, dt[i], "s", "%s, beta = 0.08, h = 0.006 m", xi_materials[i]);
    }
    claim_decide(m, dt[1] > dt[2] && dt[2] > dt[0], 1, "titanium, vanadium, steel by falling step (eq. 15)");
}

/* ---- Cost, by counted pairs, which are the same on any machine ---- */

/* Pairs of both methods, step for step, and the printed seconds. */
void pamplona_kernel_cheaper(struct claims_measured *m) {
    double each[PLATE_METHODS];
    struct published t;
    if (claim_published(&t, m, "pamplona_table1")) return;
    for (int k = 0; k < PLATE_METHODS; k++) {
        struct result run;
        if (claim_result(&run, m, "run plate %s --t-end %s", plate_words[k], t.where[PLATE_TIMES - 1])) return;
        each[k] = (double)run.cost.interactions / (double)run.steps;
    }
    double seconds = t.value[0][PLATE_TIMES] / t.value[1][PLATE_TIMES], pairs = each[PLATE_SPH] / each[PLATE_FTCS];
    claim_number(m, seconds, "", "printed seconds of SPH over those of FTCS");
    claim_number(m, pairs, "", "pairs evaluated, step for step");
    claim_number(m, seconds / pairs, "", "left to the programs, time per pair");
    claim_decide(m, fabs(seconds - 776) <= 0.5, pairs >= 776 / 2.0 && pairs <= 2 * 776.0,
                 "776 is the ratio of the printed seconds; of the methods too, for no condition, if pairs evaluated "
                 "at equal resolution and steps give it within a factor of two");
}

/* Fig. 8: work over h, as a power of h and as an exponential of h. */
void pamplona_kernel_growth(struct claims_measured *m) {
    enum { SIZES = 6 };
    static const int n[SIZES] = {12, 15, 18, 22, 27, 33};
    double h[SIZES], work[SIZES];
    for (int i = 0; i < SIZES; i++) {
        struct xi_best b = xi_as_stated(n[i], 0);
        if (isnan(xi_error(&b, xi_closed_form(n[i], b.kernel))) && claim_fail(m, b.failure.text)) return;
        h[i] = xi_h(n[i]);
        work[i] = (double)b.work;
    }
    struct xi_line power = xi_growth(h, work, SIZES, 1), exponential = xi_growth(h, work, SIZES, 0);
    claim_number(m, power.slope, "", "pairs grow as h to the power");
    claim_number(m, 100 * power.off, "%", "off by (rms), power law");
    claim_number(m, 100 * exponential.off, "%", "exponential");
    claim_decide(m, exponential.off < power.off, 1, "an exponential fits the counted pairs better than a power of h");
}

/* Section 6: the costs of the materials differ by the number of their steps. */
void pamplona_kernel_cost_materials(struct claims_measured *m) {
    double pairs[XI_MATERIALS], apart = 0;
    for (int k = 0; k < XI_MATERIALS; k++) {
        struct xi_best b = xi_as_stated(PLATE_SIDE, k);
        if (isnan(xi_error(&b, 1.643)) && claim_fail(m, b.failure.text)) return;
        pairs[k] = (double)b.work;
        double expected = xi_diffusivity(k) / xi_diffusivity(0); /* steps go as 1/dt, and dt as 1/alpha (eq. 15) */
        claim_number(m, pairs[k] / pairs[0], "", "pairs of %s over those of steel", xi_materials[k]);
        claim_number(m, expected, "", "number of steps, by eq. 15");
        apart = fmax(apart, fabs(pairs[k] / pairs[0] / expected - 1));
    }
    claim_decide(m, apart <= 0.02, 1, "pairs in proportion to steps, within 2 %% (a step more or less)");
}

/* ---- Eq. 11 ---- */

/* The contact of two materials with eq. 11's mean of the conductivities, and with eq. 13's. */
void pamplona_kernel_eq11(struct claims_measured *m) {
    static const char *const mean[2] = {"arithmetic", "harmonic"};
    static const double converges[2] = {0.5, 3};
    double slope;
    int held;
    for (int i = 0; i < 2; i++) {
        struct result run;
        if (claim_order(i ? NULL : &held, &slope, m, converges,
                        "ladder rod-contact brookshaw --h 1.1 --mean %s --dx 2/80,2/160,2/320,2/640,2/1280",
                        mean[i]) ||
            claim_result(&run, m, "run rod-contact brookshaw --h 1.1 --mean %s --dx 2/320", mean[i]))
            return;
        claim_number(m, slope, "", "order, %s mean", mean[i]);
        claim_number(m, run.error.l1, "", "E at 320 particles");
    }
    claim_decide(m, !held, 1, "eq. 11 cannot deal with a jump of k if no order of 1/2 or more is held");
}

/* The kernel's second derivative increases in an interval, and the Laplacian based on it is less accurate than one
 * based on the first derivative. */
void pamplona_kernel_curvature(struct claims_measured *m) {
    static const char *const words[] = {"quartic", "cubic", "wendland"};
    static const enum kernel_name kernel[] = {KERNEL_QUARTIC, KERNEL_CUBIC, KERNEL_WENDLAND};
    int held[2] = {1, 1};
    for (int k = 0; k < 3; k++) {
        double from = 2, E[2];
        for (int i = 1; i < 2000 && from == 2; i++)
            if (kernel_curvature(kernel[k], 2, 0.001 * i) > kernel_curvature(kernel[k], 2, 0.001 * (i - 1)) + 1e-9)
                from = 0.001 * (i - 1);
        for (int second = 0; second < 2; second++) {
            struct result run;
            char more[60];
            snprintf(more, sizeof more, " --kernel %s --h 1.2", words[k]);
            if (claim_result(&run, m, "run rect-manufactured %s --set k_y=0.02 --dx 0.05%s",
                             second ? "kernel_second" : "brookshaw", more))
                return;
            E[second] = run.error.l1;
        }
        claim_number(m, from, "h", "W'' rises from, %s", words[k]);
        claim_number(m, E[1] / E[0], "", "E1 by W'' over E1 by W', lattice, h/dx 1.2");
        held[k > 0] &= from < 2 && E[1] > E[0];
    }
    claim_decide(m, held[0], held[1],
                 "W'' rises within the support, and E1 is larger by it than by W' with the paper's kernel; without "
                 "a condition if so with the others");
}
