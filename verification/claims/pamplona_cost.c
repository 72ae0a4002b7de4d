/* Pamplona 2019, Table 1 and Fig. 8: what SPH costs.  Judged by counted pairs, which are the same on any machine. */
#include "verification/claims/kit.h"
#include "verification/claims/measures.h"

#include "verification/ladder/slope.h"

#include <math.h>

static const char SPH[] = "run plate brookshaw --dx %.17g --walls fixed --kernel quartic --h 1.2 --volume moment "
                          "--stepper rk2 --dt %.10g --t-end %.10g";

/* SPH over FTCS, in pairs evaluated; the best of three runs in seconds. */
static void take_cheaper(const char *argument, struct claims_measured *m) {
    double pairs[2] = {0, 0}, seconds[2] = {INFINITY, INFINITY}, steps[2] = {1, 1};
    (void)argument;
    for (int i = 0; i < 6; i++) {
        struct command_run run;
        int k = i % 2,
            bad = k ? claims_kit_run(&run, m, "run plate ftcs --dx 0.005 --walls fixed --dt 0.08169 --t-end 115.8822")
                    : claims_kit_run(&run, m, SPH, 0.005, 0.1623, 115.8822);
        pairs[k] = (double)run.result.interactions;
        steps[k] = (double)run.result.steps;
        seconds[k] = fmin(seconds[k], run.result.step_seconds);
        command_run_free(&run);
        if (bad) return;
    }
    double equal = pairs[0] / steps[0] / (pairs[1] / steps[1]);
    claims_kit_number(m, pairs[0] / pairs[1], "", "SPH over FTCS in pairs, steps as published");
    claims_kit_number(m, equal, "", "step for step");
    claims_kit_number(m, seconds[0] / seconds[1], "", "in seconds, on this machine, as published (not judged)");
    claims_kit_decide(m, equal >= 776 / 2.0 && equal <= 2 * 776.0, 1,
                      "776 within a factor of two, in pairs evaluated at equal resolution and number of steps");
}

/* Fig. 8: work over h, as a power of h and as an exponential of h. */
static void take_growth(const char *argument, struct claims_measured *m) {
    enum { SIZES = 6 };
    static const int n[SIZES] = {12, 15, 18, 22, 27, 33};
    const double alpha = 60.5 / (7854 * 434.);
    double h[SIZES], work[SIZES], exp_h[SIZES], rms[2] = {0, 0};
    (void)argument;
    for (int i = 0; i < SIZES; i++) {
        struct command_run run;
        h[i] = 0.12 / n[i];
        exp_h[i] = exp(h[i] / 0.006); /* a straight line in (h, log work) is a power of exp(h) */
        int bad = claims_kit_run(&run, m, SPH, 0.1 / n[i], 0.08 * h[i] * h[i] / alpha, 28.8894);
        work[i] = (double)run.result.interactions;
        command_run_free(&run);
        if (bad) return;
    }
    for (int k = 0; k < 2; k++) {
        const double *x = k ? exp_h : h;
        struct slope s = slope_fit(x, work, SIZES);
        double at = 0;
        for (int i = 0; i < SIZES; i++) at += (log(work[i]) - s.value * log(x[i])) / SIZES;
        for (int i = 0; i < SIZES; i++) rms[k] += pow(log(work[i]) - s.value * log(x[i]) - at, 2) / SIZES;
        rms[k] = sqrt(rms[k]);
        if (k == 0) claims_kit_number(m, s.value, "", "pairs grow as h to the power");
    }
    claims_kit_number(m, 100 * rms[0], "%", "off by (rms), power law");
    claims_kit_number(m, 100 * rms[1], "%", "exponential");
    claims_kit_decide(m, rms[1] < rms[0], 1, "an exponential fits the counted pairs better than a power of h");
}

const struct claims_measure claims_pamplona_cost_measures[] = {
    {"cheaper", take_cheaper}, {"growth", take_growth}, {0}};
