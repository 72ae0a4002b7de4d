/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Song 2018, section 5: oscillations, their later evolution, and the time step. */
#include "reports/ledger/claim.h"
#include "reports/song/song.h"

#include "verification/stability/symbol.h"

#include <math.h>
#include <stdlib.h>

static double outside(const struct result *r) {
    return fmax(r->shape.overshoot, r->shape.undershoot);
}

static double wave(const struct result *r) {
    return fmax(outside(r), r->shape.checkerboard);
}

static double relative_wave(const struct result *r) {
    return wave(r) / r->shape.max;
}

/* "words of run | ... | + words of run | ...": sets held[0], or held[1] from the + on, to 0 if `size` of a run is
 * not within lo to hi.  Returns 0, or 1 with *m failed. */
static int check_runs(struct claims_measured *m, double (*size)(const struct result *), const char *unit, double lo,
                      double hi, int held[2]) {
    char part[200];
    int beyond = 0;
    held[0] = held[1] = 1;
    while (claim_part(&m->argument, part, sizeof part)) {
        struct result run;
        char *words = part;
        if (*words == '+') beyond = 1, words++;
        if (claim_result(&run, m, "run %s", words)) return 1;
        double most = size(&run);
        claim_number(m, most, unit, "%s", words);
        held[beyond] &= lo <= most && most <= hi;
    }
    return 0;
}

/* None leaves its initial range (0 to 10 K) by more than rounding does in thousands of steps. */
void song_wave_no_oscillation(struct claims_measured *m) {
    int held[2];
    if (check_runs(m, outside, "K", 0, 1e-11, held)) return;
    claim_decide(m, held[0], held[1],
                 "no run leaves the initial range of 0 to 10 K (to rounding, 1e-11 K): the first two as "
                 "published, then others");
}

/* Each leaves its initial range, or carries a wave of two points, by 1 % of the jump. */
void song_wave_oscillation(struct claims_measured *m) {
    int held[2];
    if (check_runs(m, wave, "K", 0.1, INFINITY, held)) return;
    claim_decide(m, held[0], held[1],
                 "overshoot, or the amplitude of a wave of two to four points, at least 0.1 K of the 10 K jump");
}

/* The same where there must be none. */
void song_wave_smooth(struct claims_measured *m) {
    int held[2];
    if (check_runs(m, relative_wave, "", 0, 1e-6, held)) return;
    claim_decide(m, held[0], held[1],
                 "overshoot and waves of two to four points below 1e-6 of the largest temperature");
}

/* The wave of two points in the error e: the largest |(1, -4, 6, -4, 1) . e|/16, which a pure (-1)^j passes whole. */
static double sawtooth(const struct command_run *run) {
    const struct field *f = &run->field;
    double most = 0, e[5] = {0};
    for (size_t i = 0; i < f->n; i++) {
        for (int k = 0; k < 4; k++) e[k] = e[k + 1];
        double x[2] = {f->x[0][i], 0};
        e[4] = f->T[i] - command_run_exact(run, x, f->time);
        if (i >= 4) most = fmax(most, fabs(e[0] - 4 * e[1] + 6 * e[2] - 4 * e[3] + e[4]) / 16);
    }
    return most;
}

/* The sawtooth of fo_ssph on the paper's rod, relative to the peak of the temperature.  Waves of number pi - phi and
 * phi have the same rate except for the second neighbours' weights.  Both therefore become single modes at late
 * times, and their ratio tends to that of the two coefficients of the initial data, about 0.04 (half of the box's
 * alternating sum, cos(3 pi/8), divided by its sum, 10). */
void song_wave_persistence(struct claims_measured *m) {
    static const double time[3] = {50, 500, 1500};
    double wave[2][3], peak[2][3];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) {
            struct command_run run;
            int bad = claim_run(&run, m, "run rod-step %s --h 1.05 --dx 0.1 --t-end %g", k ? "so_ssph" : m->argument,
                                time[i]);
            if (!bad) wave[k][i] = sawtooth(&run);
            peak[k][i] = run.result.shape.max;
            command_run_free(&run);
            if (bad) return;
        }
    for (int i = 0; i < 3; i++)
        claim_number(m, 100 * wave[0][i] / peak[0][i], "% of the peak", "sawtooth at %g s", time[i]);
    claim_number(m, wave[0][0], "K", "at %g s", time[0]);
    claim_number(m, wave[0][2], "K", "at %g s", time[2]);
    claim_number(m, 100 * wave[1][2] / peak[1][2], "% of the peak", "so_ssph at %g s", time[2]);
    claim_decide(m, wave[0][2] / peak[0][2] >= 0.99 * wave[0][1] / peak[0][1], wave[0][2] >= 0.99 * wave[0][0],
                 "relative to the peak of the heat the sawtooth at 1500 s is that at 500 s (99 %% or more); "
                 "without a condition if that is so in K too");
}

/* A smooth bump with a sawtooth of 0.3 K on it, made from rod-gauss. */
static double bump_with_sawtooth(const struct problem *p, const double x[2]) {
    long particle = lround((x[0] - p->lo[0]) / 0.25 - 0.5);
    return exp(-x[0] * x[0] / 8) + (particle % 2 ? -0.3 : 0.3);
}

/* The sawtooth left of rod-gauss at 50 s by one method, K, with 0.3 K of it in the initial data or without. */
static int sawtooth_left(double *left, const char *method, int with, struct claims_measured *m) {
    struct command_run run;
    struct failure why;
    struct field field = {0};
    int bad = claim_run(&run, m, "run rod-gauss %s --h 1.05 --dx 0.25 --stepper euler --dt 0.5 --t-end 50", method);
    struct experiment *e = &run.typed.experiment;
    if (with) e->problem.initial = bump_with_sawtooth;
    if (!bad && method_solve(e->method, &e->problem, &e->options, &field, &why)) bad = claim_fail(m, why.text);
    field_free(&run.field);
    run.field = field;
    if (!bad) *left = sawtooth(&run);
    command_run_free(&run);
    if (!bad)
        claim_number(m, *left, "K", "sawtooth at 50 s, %s, %s of it in the data", method, with ? "0.3 K" : "none");
    return bad;
}

/* "METHOD | OTHER": smooth data, and smooth data with a sawtooth on top: no gradient is infinite. */
void song_wave_infinite_gradient(struct claims_measured *m) {
    char method[40];
    double smooth, added, other;
    claim_part(&m->argument, method, sizeof method);
    if (sawtooth_left(&smooth, method, 0, m) || sawtooth_left(&added, method, 1, m)) return;
    claim_part(&m->argument, method, sizeof method);
    if (sawtooth_left(&other, method, 1, m)) return;
    claim_decide(
        m, smooth <= 0.01 * 0.3, added <= 0.01 * 0.3,
        "smooth data have no sawtooth (below 1 %% of 0.3 K) after 50 s; without a condition if FO also damps "
        "one that is in them to 1 %%");
}

/* Area above a temperature, and above half of the peak, from 1 to 5 s: "run's words". */
void song_wave_expands(struct claims_measured *m) {
    static const double level[2] = {1, 5};
    double area[5][3];
    for (int t = 1; t <= 5; t++) {
        struct command_run run;
        int bad = claim_run(&run, m, "run %s --t-end %d", m->argument, t);
        const double level_of[3] = {level[0], level[1], run.result.shape.max / 2}, cell = 0.1 * 0.1;
        for (int k = 0; k < 3; k++) {
            area[t - 1][k] = 0;
            for (size_t i = 0; i < run.field.n && !bad; i++)
                area[t - 1][k] += run.field.T[i] > level_of[k] ? cell : 0;
        }
        command_run_free(&run);
        if (bad) return;
    }
    for (int k = 0; k < 3; k++)
        for (int t = 1; t <= 5; t += 4)
            claim_number(m, area[t - 1][k], "m^2", "above %s at %d s",
                         k == 2 ? "half the peak"
                         : k    ? "5 K"
                                : "1 K",
                         t);
    claim_decide(m, area[4][0] > area[0][0], area[4][1] > area[0][1],
                 "the area above 1 K is larger at 5 s than at 1 s; without a condition that above 5 K, half of the "
                 "jump, too");
}

/* "run's words": E with each kernel over E with the cubic spline; and the order with each. */
void song_wave_kernels(struct claims_measured *m) {
    static const char *const kernel[] = {"cubic", "quartic", "wendland"};
    double E[3], slope, apart = 0;
    int held = 1, holds;
    for (int k = 0; k < 3; k++) {
        struct result run;
        if (claim_result(&run, m, "run %s --dx 0.05 --kernel %s", m->argument, kernel[k]) ||
            claim_order(&holds, &slope, m, (double[2]){1.9, 2.1},
                        "ladder %s --dx 0.25,0.1,0.05,0.02,0.01 --kernel %s", m->argument, kernel[k]))
            return;
        E[k] = run.error.l1;
        if (k) claim_number(m, E[k] / E[0], "", "E at dx = 0.05 m over the cubic spline's, %s", kernel[k]);
        claim_number(m, slope, "", "order, %s", kernel[k]);
        held &= holds;
        apart = fmax(apart, fabs(log(E[k] / E[0])));
    }
    claim_decide(
        m, held, apart <= log(1.05),
        "second order +- 0.1 with each of three kernels; without a condition if their errors are within 5 %% "
        "too");
}

/* "METHOD | METHOD": the central wave of two points is in the null space. */
void song_wave_null_space(struct claims_measured *m) {
    const double theta[2] = {M_PI, 0};
    char method[40];
    int held = 1;
    while (claim_part(&m->argument, method, sizeof method)) {
        struct model_problem b;
        struct symbol s;
        struct failure why;
        if (claim_model(&b, NULL, m, "limit %s --dim 1 --h 1.05", method)) return;
        if (symbol_create(&s, &b, &why) && claim_fail(m, why.text)) return;
        double rate = creal(symbol_at(&s, theta));
        symbol_free(&s);
        claim_number(m, rate, "kappa/dx^2", "rate of (-1)^j, %s", method);
        held &= (fabs(rate) <= 1e-12) == (b.method->scheme->sweeps == 2);
    }
    claim_decide(m, held, 1, "0 to rounding (1e-12) for first derivatives applied twice, and for them alone");
}

/* "words | dt": the time error of the published Euler step, relative to the same run without any time error. */
void song_wave_time_error(struct claims_measured *m) {
    char words[160], dt[32];
    double most = 0;
    while (claim_part(&m->argument, words, sizeof words) && claim_part(&m->argument, dt, sizeof dt)) {
        struct command_run euler, exact;
        int bad = claim_run(&euler, m, "run %s --stepper euler --dt %s", words, dt) |
                  claim_run(&exact, m, "run %s --stepper exact", words);
        double share = bad ? 0 : field_distance(&exact.field, euler.field.T, exact.field.T) / exact.result.error.l1;
        command_run_free(&euler);
        command_run_free(&exact);
        if (bad) return;
        claim_number(m, 100 * share, "% of E", "time error, dt = %s s, %s", dt, words);
        most = fmax(most, share);
    }
    /* 5 % at the finest of spacings 1:50 moves the slope through them by log(1.05)/log(50) = 0.012 */
    claim_decide(m, most <= 0.05, most <= 0.01,
                 "the time step makes up at most 5 %% of the error at the finest spacing, which moves the slope by "
                 "0.01; at most 1 %%, which leaves the printed digits alone, for no condition");
}

/* E1 against the exact solution at five times: too small to be visible in a plot. */
void song_wave_agreement(struct claims_measured *m) {
    double worst = 0, last = INFINITY;
    int falling = 1;
    for (int t = 1; t <= 5; t++) {
        struct result run;
        if (claim_result(&run, m, "run %s --t-end %d", m->argument, t)) return;
        falling &= run.shape.max <= last;
        worst = fmax(worst, run.error.linf / 10);
        last = run.shape.max;
        claim_number(m, last, "K", "peak at %d s", t);
    }
    claim_number(m, 100 * worst, "% of T0", "largest error at any of the times");
    claim_decide(m, worst <= 0.05 && falling, worst <= 0.01,
                 "peaks fall, and no point is off by more than 5 %% of T0 (1 %% for no condition)");
}
