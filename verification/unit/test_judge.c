/* Verdicts on ladders made to measure: what must not pass, what must, and how often under scatter. */
#include "verification/ladder/judge.h"

#include "verification/ladder/slope.h"
#include "verification/ladder/window.h"

#include "verification/unit/near.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <string.h>

/* A ladder: dx_i = first/ratio^i, error(dx) with the finest dx as a second argument. */
struct stand_in {
    const char *name;
    double first, ratio;
    int n;
    double (*error)(double x, double finest);
    double lo, hi;
    enum verdict verdict;
    const char *said; /* in the reason */
};

static double power(double x, double finest) {
    (void)finest;
    return 0.37 * pow(x, 1.97);
}

static double first_order(double x, double finest) {
    (void)finest;
    return 0.37 * x;
}

static double growing(double x, double finest) {
    (void)finest;
    return 0.37 * pow(x, -2);
}

static double constant(double x, double finest) {
    (void)x, (void)finest;
    return 0.0123;
}

static double quarter_floor(double x, double finest) { /* of the issue: a quarter of the finest error, about */
    (void)finest;
    return 0.01 * (pow(x / 0.1, 2) + 0.0003);
}

static double exponential(double x, double finest) {
    (void)finest;
    return 0.01 * exp(20 * x);
}

static double stalled(double x, double finest) {
    (void)finest;
    return fmax(0.01 * pow(x / 0.1, 2), 3e-7);
}

static double small_floor(double x, double finest) { /* 0.063 of the finest */
    return x * x + 0.067 * finest * finest;
}

static double some_floor(double x, double finest) { /* 0.13 of the finest */
    return x * x + 0.15 * finest * finest;
}

static double half_floor(double x, double finest) {
    return x * x + finest * finest;
}

static double lower_term(double x, double finest) { /* first order takes over at the fine end */
    return x * x + 0.31 * finest * x;
}

static double higher_term(double x, double finest) {
    (void)finest;
    return x * x * (1 + 0.9 * x);
}

static double higher_term_off(double x, double finest) {
    (void)finest;
    return x * x * (1 - 0.9 * x);
}

static double logarithm(double x, double finest) {
    (void)finest;
    return -x * x * log(x);
}

static double lucky(double x, double finest) { /* the last rung alone is far too good */
    return x * x * (x < 1.01 * finest ? 0.27 : 1);
}

static double unlucky(double x, double finest) {
    return x * x * (x < 1.01 * finest ? 2.3 : 1);
}

static double cancelling(double x, double finest) { /* the error changes its sign */
    return fabs(x * x - 3.7 * finest * x);
}

static double rising_end(double x, double finest) {
    return x < 1.5 * finest ? 1.2 * pow(2 * finest, 2) : x * x;
}

static double zigzag(double x, double finest) { /* 40 % up and down */
    int i = (int)lround(log(x / finest) / log(2));
    return x * x * (i % 2 ? 1.4 : 1 / 1.4);
}

static double steeper_end(double x, double finest) {
    return x * x * (1 - 0.13 * exp(-3 * (x / finest - 1)));
}

static double not_finite(double x, double finest) {
    return x < 1.01 * finest ? NAN : x * x;
}

static const struct stand_in cases[] = {
    {"a power", 0.4, 2, 6, power, 1.9, 2.1, VERDICT_PASS, "lies inside"},
    {"a power, four rungs of ratio 2", 0.4, 2, 4, power, 1.9, 2.1, VERDICT_PASS, "lies inside"},
    {"a power, span of 4", 0.4, 1.41421356237309505, 5, power, 1.9, 2.1, VERDICT_PASS, "lies inside"},
    {"a term of higher order", 0.4, 2, 6, higher_term, 1.9, 2.1, VERDICT_PASS, "lies inside"},
    {"a term of higher order, the other sign", 0.4, 2, 6, higher_term_off, 1.9, 2.1, VERDICT_PASS, "lies inside"},
    {"a logarithm in its band", 0.1, 2, 6, logarithm, 1.7, 2, VERDICT_PASS, "lies inside"},
    {"a floor of 6 % between rungs of ratio 4", 0.4, 4, 5, small_floor, 1.9, 2.1, VERDICT_PASS, "lies inside"},
    {"a floor, where order 0 is in the band", 0.4, 2, 5, constant, -0.1, 0.1, VERDICT_PASS, "lies inside"},
    {"first order", 0.4, 2, 6, first_order, 1.9, 2.1, VERDICT_FAIL, "lies outside"},
    {"growing", 0.4, 2, 6, growing, 1.9, 2.1, VERDICT_FAIL, "does not fall"},
    {"constant", 0.4, 2, 6, constant, 1.9, 2.1, VERDICT_FAIL, "does not fall"},
    {"a quarter of floor", 0.1, 1.41421356237309505, 11, quarter_floor, 1.9, 2.1, VERDICT_FAIL, "2 finest rungs"},
    {"a quarter of floor, ratio 1.2", 0.1, 1.2, 20, quarter_floor, 1.9, 2.1, VERDICT_FAIL, "2 finest rungs"},
    {"no span", 0.1, 1.002960, 11, exponential, 1.9, 2.1, VERDICT_INCONCLUSIVE, "span a factor of 1.03"},
    {"stalled at 3e-7", 0.1, 2, 11, stalled, 1.9, 2.1, VERDICT_FAIL, "does not fall"},
    {"flattening, a wide band", 0.4, 4, 5, some_floor, 1.5, 2.5, VERDICT_FAIL, "13 % of the finest error"},
    {"flattening, wide rungs", 0.4, 4, 5, some_floor, 1.9, 2.1, VERDICT_FAIL, "of the finest error"},
    {"half a floor", 0.4, 2, 9, half_floor, 1.8, 2.2, VERDICT_FAIL, "2 finest rungs"},
    {"first order takes over", 0.4, 2, 9, lower_term, 1.9, 2.1, VERDICT_FAIL, "2 finest rungs"},
    {"a lucky last rung", 0.4, 2, 9, lucky, 1.5, 2.5, VERDICT_FAIL, "2 finest rungs"},
    {"an unlucky last rung", 0.4, 2, 9, unlucky, 1.5, 2.5, VERDICT_FAIL, "2 finest rungs"},
    {"a sign that changes", 0.4, 2, 8, cancelling, 1.9, 2.1, VERDICT_INCONCLUSIVE, "reaches past"},
    {"a rise at the end", 0.4, 2, 6, rising_end, 1.5, 2.1, VERDICT_FAIL, "does not fall"},
    {"steeper at the end", 0.4, 2, 8, steeper_end, 1.9, 2.1, VERDICT_FAIL, "2 finest rungs"},
    {"up and down", 0.4, 2, 6, zigzag, 1.9, 2.1, VERDICT_INCONCLUSIVE, "reaches past"},
    {"a span of 3.4 alone", 0.4, 1.5, 4, power, 1.9, 2.1, VERDICT_INCONCLUSIVE, "span a factor of 3.38"},
    {"three rungs", 0.4, 2, 3, power, 1.9, 2.1, VERDICT_INCONCLUSIVE, "3 rungs count"},
    {"no rungs", 0.4, 2, 0, power, 1.9, 2.1, VERDICT_INCONCLUSIVE, "0 rungs count"},
    {"not finite", 0.4, 2, 6, not_finite, 1.9, 2.1, VERDICT_FAIL, "not finite"},
    {"no band", 0.4, 2, 6, power, NAN, 2.1, VERDICT_FAIL, "not finite"},
    {"no band above", 0.4, 2, 6, power, 1.9, NAN, VERDICT_FAIL, "not finite"},
    {"a band upside down", 0.4, 2, 6, power, 2.1, 1.9, VERDICT_FAIL, "not finite"},
};

/* Through the window, as a ladder goes. */
static enum verdict judge(const double *x, const double *error, int n, double lo, double hi, int *scattered,
                          char reason[240]) {
    struct window_rung rung[RUNG_MAX] = {0};
    struct window w;
    double in[RUNG_MAX], of[RUNG_MAX];
    int m = 0;
    for (int i = 0; i < n; i++) rung[i] = (struct window_rung){.x = x[i], .error = error[i]};
    window_choose(rung, n, &w);
    for (int i = 0; i < n; i++)
        if (w.counts[i]) in[m] = x[i], of[m++] = error[i];
    struct judged judged = {in, of, m, w.scattered};
    *scattered = w.scattered;
    return judge_order(&judged, lo, hi, reason, 240);
}

static void stand_ins_get_their_verdict(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        const struct stand_in *c = &cases[k];
        double x[RUNG_MAX], error[RUNG_MAX], finest = c->first / pow(c->ratio, c->n - 1);
        char reason[240];
        int scattered;
        for (int i = 0; i < c->n; i++) {
            x[i] = c->first / pow(c->ratio, i);
            error[i] = c->error(x[i], finest);
        }
        enum verdict verdict = judge(x, error, c->n, c->lo, c->hi, &scattered, reason);
        if (verdict != c->verdict || !strstr(reason, c->said))
            fail_msg("%s: %s: %s", c->name, verdict_words[verdict], reason);
    }
}

struct coverage {
    double pass, interval, recognised;
};

enum { TRIALS = 1500 };

/* Of n rungs at x_i = 0.1/ratio^i with error x^2 + part * finest^(2-q) x^q and a scatter of s (of the logarithm). */
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

/* The interval of a fit alone lies inside the band in a share of cases that the scatter fixes: with the slope's error
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

/* An honest ladder is lost to the interval (as it must), to the finer half of m = n/2 local slopes outside the band,
 * and to what chance does in the window and in the floor: at most 0.01 for the F-test, and 0.04 for scatter that is
 * not recognised, which is then judged by its two finest rungs. */
static void honest_scatter_passes_as_often_as_it_can(void **state) {
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
        assert_true(c.pass <= inside + noise(inside));
        if (!(c.pass >= inside - lost - noise(inside)))
            fail_msg("%d rungs: %.3f pass, %.3f are inside, %.3f may be lost", n, c.pass, inside, lost);
        assert_true(c.recognised > 0.85);
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
    struct judged l = {x, error, n, 1};
    double slope = judge_fine_slope(&l);
    double off = 2 * s / log(ratio) * sqrt(3.0 / (m * (m + 1.0) * (m + 2)));
    return gsl_cdf_ugaussian_P((2.1 - slope) / off) - gsl_cdf_ugaussian_P((1.9 - slope) / off);
}

/* A quarter of the finest error a floor, or first order.  With two per cent of scatter: a floor never, first order
 * only where the scatter is recognised, so that the finer half decides; with ten no more often than that half happens
 * to lie in the band. */
static void flattening_passes_no_more_than_it_must(void **state) {
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

static void what_does_not_fall_is_named(void **state) {
    (void)state;
    const double x[5] = {16, 8, 4, 2, 1}, error[5] = {70, 30, 16, 17.5, 2};
    struct judged l = {x, error, 5, 0};
    char reason[240];
    assert_int_equal(judge_order(&l, 0.9, 1.1, reason, sizeof reason), VERDICT_FAIL);
    assert_string_equal(reason, "the error does not fall: 1.6000e+01 at 4, 1.7500e+01 at 2");
}

static void the_fine_slope_by_hand(void **state) {
    (void)state;
    const double x[5] = {16, 8, 4, 2, 1}, error[5] = {7, 3, 16, 4, 2};
    struct judged l = {x, error, 5, 0};
    assert_near(judge_fine_slope(&l), 1, 1e-14);
    l.scattered = 1; /* of 16, 4, 2: log2 4, 2, 1 at 2, 1, 0: 3/2 */
    assert_near(judge_fine_slope(&l), 1.5, 1e-14);
    l.n = 1, l.scattered = 0;
    assert_true(isnan(judge_fine_slope(&l)));
}

static void the_floor_by_hand(void **state) {
    (void)state;
    double x[6], error[6];
    for (int i = 0; i < 6; i++) {
        x[i] = 0.32 / pow(2, i);
        error[i] = 2.385 * pow(x[i], 1.5) + 2.385 * pow(0.01, 1.5) * 0.25; /* a fifth of the finest */
    }
    struct judged l = {x, error, 6, 0};
    assert_near(judge_floor(&l, 1.4, 1.6), 0.2, 1e-9); /* 1.5 is one of the orders tried */
    assert_near(judge_floor(&l, -0.2, 1.6), 0, 0);
    l.scattered = 1;
    assert_near(judge_floor(&l, 1.4, 1.6), 0.2, 1e-9);
    l.n = 3;
    assert_near(judge_floor(&l, 1.4, 1.6), 0, 0);
}

/* The coarse half has another floor than the fine one: which rungs are fitted must not depend on the unit of x. */
static void the_unit_of_x_does_not_matter(void **state) {
    (void)state;
    double x[8], error[8];
    for (int i = 0; i < 8; i++) {
        x[i] = pow(2, -i);
        error[i] = pow(x[i], 1.5) * (i < 4 ? 1.3 : 1) + 0.2 * pow(2, -7 * 1.5); /* a sixth of the finest */
    }
    for (int k = 0; k < 3; k++) {
        struct judged l = {x, error, 8, 0};
        assert_near(judge_floor(&l, 1.4, 1.6), 1.0 / 6, 1e-9);
        for (int i = 0; i < 8; i++) x[i] *= 1e3;
    }
}

/* 1, 0, 0, 0, 0 at equal distances: the differences (1, 0) of weights 1, 3, 3, 1 over sqrt(20), and about the line
 * 1/5 - (k - 2)/5 a sum of squares of 1 - 1/5 - 4/10: (1/20)/2 over 0.4/3. */
static void roughness_by_hand(void **state) {
    (void)state;
    const double e = exp(1), x[5] = {1, 1 / e, pow(e, -2), pow(e, -3), pow(e, -4)}, error[5] = {e, 1, 1, 1, 1};
    assert_near(slope_roughness(x, error, 5), (1.0 / 20 / 2) / (0.4 / 3), 1e-12);
    assert_near(slope_roughness(x, error, 4), 0, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stand_ins_get_their_verdict),
        cmocka_unit_test(honest_scatter_passes_as_often_as_it_can),
        cmocka_unit_test(flattening_passes_no_more_than_it_must),
        cmocka_unit_test(what_does_not_fall_is_named),
        cmocka_unit_test(the_fine_slope_by_hand),
        cmocka_unit_test(the_floor_by_hand),
        cmocka_unit_test(the_unit_of_x_does_not_matter),
        cmocka_unit_test(roughness_by_hand),
    };
    return cmocka_run_group_tests_name("judge", tests, NULL, NULL);
}
