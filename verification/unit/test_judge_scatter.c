/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How often ladders with scatter pass: honest ones as often as they can, flattening ones no more than they must. */
#include "verification/judge/slope.h"

#include "verification/unit/judged_ladder.h"
#include "verification/unit/near.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

struct coverage {
    double pass, interval, recognised;
};

enum { TRIALS = 1500 };

/* Coverage for n rungs at x_i = 0.1/ratio^i with the error x^2 + part * finest^(2-q) x^q and a scatter s of the
 * logarithm. */
static struct coverage count(int n, double ratio, double s, double part, double q) {
    struct coverage c = {0};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 2385);
    double finest = 0.1 / pow(ratio, n - 1);
    for (int t = 0; t < TRIALS; t++) {
        double x[RUNG_MAX], error[RUNG_MAX];
        char reason[240];
        int scattered;
        for (int i = 0; i < n; i++) {
            x[i] = 0.1 / pow(ratio, i);
            error[i] = (x[i] * x[i] + part * pow(finest, 2 - q) * pow(x[i], q)) * exp(gsl_ran_gaussian(random, s));
        }
        struct slope all = slope_fit(x, error, n);
        c.interval += (1.9 <= all.ci[0] && all.ci[1] <= 2.1) / (double)TRIALS;
        c.pass += (judge(x, error, n, 1.9, 2.1, &scattered, reason) == VERDICT_PASS) / (double)TRIALS;
        c.recognised += scattered / (double)TRIALS;
    }
    gsl_rng_free(random);
    return c;
}

/* The interval of a fit alone is inside the band in a share of cases that the scatter fixes: with the slope's error
 * d ~ N(0, s^2/S) and the interval's half width t sqrt(s^2 X/(m-2)/S), X of chi squared, both independent.
 * Quadrature over X, by midpoints of equal probability. */
static double share_inside(int n, double ratio, double s) {
    enum { CELLS = 4000 };
    double S = pow(log(ratio), 2) * n * (n * n - 1.0) / 12, sigma = s / sqrt(S), share = 0;
    double t = gsl_cdf_tdist_Pinv(0.975, n - 2);
    for (int k = 0; k < CELLS; k++) {
        double room = 0.1 - t * sigma * sqrt(gsl_cdf_chisq_Pinv((k + 0.5) / CELLS, n - 2) / (n - 2));
        if (room > 0) share += (1 - 2 * gsl_cdf_ugaussian_Q(room / sigma)) / CELLS;
    }
    return share;
}

/* Three standard errors of a share that was counted. */
static double noise(double share) {
    return 3 * sqrt(fmax(share * (1 - share), 0.01) / TRIALS);
}

/* A correct ladder can fail because of the interval (as intended), because the finer half of the m = n/2 local
 * slopes is outside the band, and by chance in the window and in the floor: with probability 0.01 at most for the
 * F-test, and 0.04 for scatter that is not recognised, which is then judged by the two finest rungs. */
static void scattered_ladders_pass_at_the_expected_rate(void **state) {
    (void)state;
    static const struct {
        int n;
        double ratio, s;
    } ladder[] = {{8, 2, 0.1}, {11, 1.6, 0.1}, {16, 1.41421356237309505, 0.1}, {6, 2, 0.03}, {8, 2, 0.03}};
    for (size_t k = 0; k < sizeof ladder / sizeof ladder[0]; k++) {
        int n = ladder[k].n, m = n / 2;
        struct coverage c = count(n, ladder[k].ratio, ladder[k].s, 0, 2);
        double inside = share_inside(n, ladder[k].ratio, ladder[k].s);
        double fine = 2 * ladder[k].s / log(ladder[k].ratio) * sqrt(3.0 / (m * (m + 1.0) * (m + 2)));
        double lost = 2 * gsl_cdf_ugaussian_Q(0.1 / fine) + 0.05;
        assert_near(c.interval, inside, noise(inside));
        assert_order(c.pass, <=, inside + noise(inside));
        if (!(c.pass >= inside - lost - noise(inside)))
            fail_msg("%d rungs: %.3f pass, %.3f are inside, %.3f may be lost", n, c.pass, inside, lost);
        assert_order(c.recognised, >, 0.85);
    }
}

/* The slope of the finer half without scatter, and its standard error. */
static double fine_inside(int n, double ratio, double s, double part, double q) {
    double x[RUNG_MAX], error[RUNG_MAX], finest = 0.1 / pow(ratio, n - 1);
    int m = n / 2;
    for (int i = 0; i < n; i++) {
        x[i] = 0.1 / pow(ratio, i);
        error[i] = x[i] * x[i] + part * pow(finest, 2 - q) * pow(x[i], q);
    }
    struct judged l = {x, error, n, 1, NULL};
    double slope = judge_fine_slope(&l);
    double off = 2 * s / log(ratio) * sqrt(3.0 / (m * (m + 1.0) * (m + 2)));
    return gsl_cdf_ugaussian_P((2.1 - slope) / off) - gsl_cdf_ugaussian_P((1.9 - slope) / off);
}

/* A floor of a quarter of the finest error, or first order.  With two per cent of scatter: never with a floor, with
 * first order only if the scatter is recognised, so that the finer half decides; with ten per cent no more often
 * than that half is in the band by chance. */
static void flattening_ladders_fail_at_the_expected_rate(void **state) {
    (void)state;
    static const struct {
        int n;
        double ratio;
    } ladder[] = {{8, 2}, {11, 1.41421356237309505}, {16, 1.41421356237309505}};
    for (int k = 0; k < 3; k++)
        for (int q = 0; q < 2; q++) {
            struct coverage c = count(ladder[k].n, ladder[k].ratio, 0.02, 1.0 / 3, q);
            if (!(c.pass <= (q ? c.recognised : 0) + 0.02)) fail_msg("%d, q = %d: %.3f", ladder[k].n, q, c.pass);
            c = count(ladder[k].n, ladder[k].ratio, 0.1, 1.0 / 3, q);
            double most = fmin(c.interval, fine_inside(ladder[k].n, ladder[k].ratio, 0.1, 1.0 / 3, q));
            if (!(c.pass <= most + noise(most))) fail_msg("%d, q = %d: %.3f > %.3f", ladder[k].n, q, c.pass, most);
        }
}

/* Cells of 10 to 160 against [1.5, 2.9], as a ladder is typed: with 2 % of scatter at most 1 of 500 ladders of second
 * order fails, and none of orders up to 1.45 passes in 300. */
static void a_little_scatter_is_no_floor(void **state) {
    (void)state;
    static const double cells[] = {10, 20, 30, 40, 60, 80, 120, 160}, order[] = {2, 1, 1.4, 1.45};
    static const int rungs[] = {4, 5, 6, 8};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 2385);
    for (int k = 0; k < 4; k++)
        for (int o = 0; o < 4; o++) {
            int n = rungs[k], failed = 0, passed = 0, trials = o ? 300 : 1000;
            for (int t = 0; t < trials; t++) {
                double x[8], error[8];
                char reason[240];
                int scattered;
                for (int i = 0; i < n; i++) {
                    x[i] = 1 / cells[i];
                    error[i] = pow(x[i], order[o]) / 2 * exp(gsl_ran_gaussian(random, 0.02));
                }
                enum verdict v = judge(x, error, n, 1.5, 2.9, &scattered, reason);
                failed += v == VERDICT_FAIL, passed += v == VERDICT_PASS;
            }
            if (o ? passed > 0 : failed > trials / 500)
                fail_msg("%d rungs of order %g: %d pass, %d fail of %d", n, order[o], passed, failed, trials);
        }
    gsl_rng_free(random);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scattered_ladders_pass_at_the_expected_rate),
        cmocka_unit_test(flattening_ladders_fail_at_the_expected_rate),
        cmocka_unit_test(a_little_scatter_is_no_floor),
    };
    return cmocka_run_group_tests_name("judge_scatter", tests, NULL, NULL);
}
