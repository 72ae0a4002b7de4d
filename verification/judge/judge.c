/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The verdict on an order.
 *
 * A straight line through (log x, log error) can mislead in four ways; each has its own test besides the fit.
 *
 * Flattening ladder: a share f of the finest error that does not decrease reduces the last local slope by f (1 -
 * r^-p)/log r (about f for r = 2 and p = 2), but the previous one only by r^-p of that, and so on.  The mean over
 * many rungs hides it, so the local slope of the two finest rungs must be in the band.
 *
 * Scattered errors: with a relative scatter s a local slope has the standard error sqrt(2) s/log r, 0.2 for s = 0.1
 * and r = 2, too much for a band of +-0.1.  The fine slope is then that of the finer half of the local slopes,
 * rounded up: m + 1 rungs at equal ratios have 2 s/log r sqrt(3/(m (m + 1) (m + 2))), 0.046 for 5. window.c decides
 * when errors are scattered.
 *
 * Short span: over a span S errors C exp(a x) look like a power of any order a x, because the local slope changes
 * only by the factor S.  For S >= 4 it leaves any band with hi/lo < 4.
 *
 * Floor between wide rungs: the last local slope of ratio r is log_r(r^p (1 - f) + f).  For large r it decreases
 * more slowly than f: by 0.07 for r = 4, p = 2 and f = 0.1.  Therefore C x^p + F is fitted, and F must be at most a
 * tenth of the finest error.  This is a linear least-squares fit of C x^p/E + F/E = 1 for each p of the band.  It
 * uses the finest rungs that span a factor of 4 (at least four), since coarser ones have higher-order terms.
 * Scattered errors use all rungs, and a floor counts if it is significant: an F-test at 1 % of its reduction of the
 * sum of squares.  Four rungs cannot show that errors scatter (slope_roughness), and more of them not always: a floor
 * that is not significant at 0.3 % leaves them inconclusive.  The fitted floor is positive in at most half of the
 * ladders without one, so that at most 0.15 % of these fail, below 1 in 500; at 1 % up to 0.5 % do.  Counted at 2 %
 * of scatter: 1 in 1,700 of 4 to 8 rungs, and at 1 % 1 in 450 (unit/test_judge_scatter.c).  If the band contains an
 * order of 0, a floor is expected.
 *
 * A ladder that did not pass may show no order without being wrong:
 *
 * Noise: if E1 of two equal runs differs by d, each scatters by d/sqrt(2).  A tenth of the error moves a local slope
 * of ratio r by sqrt(2)/10/log r, 0.2 for r = 2: too much for a band of +-0.1.  An error above its ceiling by three
 * times its scatter is wrong in any case.
 *
 * Printed digits that make up a tenth of the finest error (norms_digits) move a slope by the same amount.
 *
 * Smoothness: C x^p + D x^q, for any C, D, p and q with errors of one sign, has monotone local slopes.  Slopes that
 * turn by 1/2 and back by 1/2 have more than two such terms, for example a tolerance or digits.
 *
 * Rungs: with the scatter s about the line, n rungs at log x = u have the interval +- t(n - 2) s/sqrt(sum (u -
 * mean)^2) about the slope.  The result is the smallest n by halving with an interval inside the band.
 *
 * Small errors: errors of space and time can cancel, for example at a mesh Fourier number of 1/6, and the remainder
 * decreases irregularly.  On a graded grid a jump is at another fraction of a cell on each rung.  Cell means then
 * have a start of -1 to 2 units of dx^2/24 T_xx: of second order, but by a factor that scatters, and more rungs do
 * not give a slope.  Half of the ceiling is twice the error of the five-point difference, the error of cells 1.4
 * times as wide. */
#include "verification/judge/judge.h"

#include "solver/words.h"
#include "verification/judge/slope.h"
#include "verification/judge/window.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Advice for an order alone; a row that fails by its ceiling has none. */
static const char NARROWER[] = ": more or finer rungs narrow it (verify: --rungs N)";
static const double SPAN_LEAST = 4, FLOOR_MOST = 0.1, SIGNIFICANCE = 0.01, SURE = 0.003, ROUNDED = 1 - 1e-9;
static const double FALLEN = 1 - 1e-6; /* a smaller decrease is only a difference in rounding */

/* Writes the first defect of the errors that excludes an order to `reason`; returns 0 if there is none. */
static int spoilt(const struct judged *l, double lo, char *reason, size_t size) {
    for (int i = 0; i < l->n; i++)
        if (!isfinite(l->error[i])) return snprintf(reason, size, "the error at %.6g is not finite", l->x[i]);
    for (int i = 0; i + 1 < l->n; i++)
        if (!(l->error[i + 1] < FALLEN * l->error[i]) && !l->scattered && lo > 0)
            return snprintf(reason, size, "the error does not fall: %.4e at %.6g, %.4e at %.6g", l->error[i], l->x[i],
                            l->error[i + 1], l->x[i + 1]);
    return 0;
}

/* Number of rungs in the fine slope. */
static int fine_rungs(const struct judged *l) {
    return l->scattered ? l->n / 2 + 1 : 2;
}

double judge_fine_slope(const struct judged *l) {
    int first = l->n - fine_rungs(l);
    return first < 0 ? NAN : slope_fit(l->x + first, l->error + first, l->n - first).value;
}

struct floor_fit {
    double share;      /* share of the floor in the finest error of the fit */
    double line, with; /* sum of squares of C x^p/E - 1, and of (C x^p + F)/E - 1 */
};

/* Fit for one p.  With a_i = (x_i/x_n)^p E_n/E_i and c_i = E_n/E_i the sums below give C and F in units of E_n. */
static struct floor_fit fit_floor(const double *x, const double *error, int n, double p) {
    double a[RUNG_MAX], c[RUNG_MAX], aa = 0, cc = 0, ac = 0, sa = 0, sc = 0;
    struct floor_fit fit = {0};
    for (int i = 0; i < n; i++) {
        c[i] = error[n - 1] / error[i];
        a[i] = pow(x[i] / x[n - 1], p) * c[i];
        aa += a[i] * a[i], cc += c[i] * c[i], ac += a[i] * c[i];
        sa += a[i], sc += c[i];
    }
    double determinant = aa * cc - ac * ac, C = (sa * cc - sc * ac) / determinant,
           F = (sc * aa - sa * ac) / determinant;
    if (!(F > 0)) F = 0, C = sa / aa; /* a floor is not negative */
    for (int i = 0; i < n; i++) {
        fit.line += pow(sa / aa * a[i] - 1, 2);
        fit.with += pow(C * a[i] + F * c[i] - 1, 2);
    }
    fit.share = F / (C + F);
    return fit;
}

/* significant: 1 if scatter does not explain it. */
static double find_floor(const struct judged *l, double lo, double hi, int *significant) {
    enum { STEPS = 64 };
    struct floor_fit best = {.line = INFINITY, .with = INFINITY};
    int first = l->n - WINDOW_LEAST;
    *significant = 0;
    if (!(lo > 0) || first < 0 || l->n > RUNG_MAX) return 0;
    while (first > 0 && (l->scattered || l->x[first] / l->x[l->n - 1] < SPAN_LEAST * ROUNDED)) first--;
    int n = l->n - first;
    for (int k = 0; k <= STEPS; k++) {
        struct floor_fit fit = fit_floor(l->x + first, l->error + first, n, lo + (hi - lo) * k / STEPS);
        best.line = fmin(best.line, fit.line);
        if (fit.with < best.with) best.with = fit.with, best.share = fit.share;
    }
    double freedom = n - 3, gain = (best.line - best.with) * freedom, by_chance = l->scattered ? SIGNIFICANCE : SURE;
    *significant = gain > gsl_cdf_fdist_Qinv(by_chance, 1, freedom) * best.with;
    return best.share;
}

double judge_floor(const struct judged *l, double lo, double hi) {
    int significant;
    double share = find_floor(l, lo, hi, &significant);
    return l->scattered && !significant ? 0 : share;
}

static enum verdict judge_fine_end(const struct judged *l, double lo, double hi, char *reason, size_t size) {
    int significant;
    double fine = judge_fine_slope(l), share = find_floor(l, lo, hi, &significant);
    if (!(lo <= fine && fine <= hi)) {
        words_add(reason, size, ", but the %d finest rungs have the slope %.4f", fine_rungs(l), fine);
        return VERDICT_FAIL;
    }
    if (!(share > FLOOR_MOST) || (l->scattered && !significant)) return VERDICT_PASS;
    words_add(reason, size, ", but the finest error falls too slowly, as if %.0f %% of it %s (C x^p + floor)%s",
              100 * share, significant ? "did not fall" : "might not fall", significant ? "" : ": more rungs decide");
    return significant ? VERDICT_FAIL : VERDICT_INCONCLUSIVE;
}

enum verdict judge_order(const struct judged *l, double lo, double hi, char *reason, size_t size) {
    if (spoilt(l, lo, reason, size)) return VERDICT_FAIL;
    if (l->n < WINDOW_LEAST) {
        snprintf(reason, size, "%d rung%s, at least %d must: more rungs are needed", l->n,
                 l->n == 1 ? " counts" : "s count", WINDOW_LEAST);
        return VERDICT_INCONCLUSIVE;
    }
    struct slope s = l->slope ? *l->slope : slope_fit(l->x, l->error, l->n);
    int used = snprintf(reason, size, "the order's interval [%.4f, %.4f] ", s.ci[0], s.ci[1]);
    char *rest = reason + used;
    size_t room = size - (size_t)used;
    double span = l->x[0] / l->x[l->n - 1];
    if (!(isfinite(s.ci[0]) && isfinite(s.ci[1]) && lo <= hi)) {
        snprintf(rest, room, "or the band [%g, %g] is not finite", lo, hi);
        return VERDICT_FAIL;
    }
    if (s.ci[1] < lo || s.ci[0] > hi) {
        snprintf(rest, room, "is outside [%g, %g]", lo, hi);
        return VERDICT_FAIL;
    }
    if (span < SPAN_LEAST * ROUNDED) {
        snprintf(rest, room, "is of rungs that span a factor of %.3g, at least %g is needed: finer rungs", span,
                 SPAN_LEAST);
        return VERDICT_INCONCLUSIVE;
    }
    if (!(lo <= s.ci[0] && s.ci[1] <= hi)) {
        snprintf(rest, room, "reaches past [%g, %g]%s", lo, hi, NARROWER);
        return VERDICT_INCONCLUSIVE;
    }
    snprintf(rest, room, "is inside [%g, %g]", lo, hi);
    return judge_fine_end(l, lo, hi, reason, size);
}

void judge_ceiling(double error, double ceiling, enum verdict *verdict, char *reason, size_t size) {
    char cause[80], rest[400];
    const char *apart = *reason ? "; " : "";
    if (error <= ceiling && *reason) return;
    if (error <= ceiling) {
        snprintf(reason, size, "the error %.4g is below its ceiling %.4g", error, ceiling);
        return;
    }
    int passed = *verdict == VERDICT_PASS;
    *verdict = VERDICT_FAIL;
    if (isfinite(error))
        snprintf(cause, sizeof cause, "the error %.4g is above its ceiling %.4g", error, ceiling);
    else
        snprintf(cause, sizeof cause, "no error to compare with the ceiling %.4g", ceiling);
    snprintf(rest, sizeof rest, "%.399s", reason);
    char *narrower = strstr(rest, NARROWER);
    if (narrower) memmove(narrower, narrower + strlen(NARROWER), strlen(narrower + strlen(NARROWER)) + 1);
    snprintf(reason, size, "%s%s%s", passed ? cause : rest, apart, passed ? rest : cause); /* the cause first */
}

/* ---- Facts ---- */

static const double DIGITS = 0.1, TURN = 0.5; /* a share of the error; a change of a local slope */

/* An error above its ceiling is wrong for any order. */
static void leave_open(const struct judge_facts *f, double error, struct judge_verdict *v) {
    v->verdict = VERDICT_INCONCLUSIVE;
    if (f->ceiling > 0 && !(error <= f->ceiling))
        judge_ceiling(error, f->ceiling, &v->verdict, v->reason, sizeof v->reason);
}

/* Without a band the order is only measured; a failed rung fails the ladder, and one that is skipped skips it. */
static void judge_unasked(const struct judge_facts *f, struct judge_verdict *v) {
    const struct judged *r = &f->rungs;
    struct slope s = r->slope ? *r->slope : slope_fit(r->x, r->error, r->n);
    v->verdict = isfinite(s.value) && r->n >= WINDOW_LEAST ? VERDICT_MEASURED : VERDICT_INCONCLUSIVE;
    snprintf(v->reason, sizeof v->reason, "%d of %d rungs count%s", r->n, f->n,
             r->n < WINDOW_LEAST ? ", at least four must" : "");
    if (!f->failure.status) return;
    int skipped = f->failure.status == STATUS_SKIPPED;
    v->verdict = skipped ? VERDICT_SKIPPED : VERDICT_FAIL;
    snprintf(v->reason, sizeof v->reason, "%s%.200s", skipped ? "" : "a rung failed: ", f->failure.text);
}

/* At round-off there is no order to fit; an exact code passes on its ceiling alone. */
static void judge_exact(const struct judge_facts *f, struct judge_verdict *v) {
    int known = f->ceiling > 0;
    if (f->rungs.n >= WINDOW_LEAST || !f->finest_exact) return;
    if (known) v->verdict = VERDICT_PASS;
    snprintf(v->reason, sizeof v->reason, "%d of %d rungs are at round-off, without an order%s", f->exact, f->n,
             known ? "" : ": --ceiling E judges the error");
    if (known && f->finest <= f->ceiling)
        words_add(v->reason, sizeof v->reason, "; the error %.4g is below its ceiling %.4g", f->finest, f->ceiling);
}

/* ---- Errors without an order that need not be wrong ---- */

/* Local slopes of the included rungs; returns their number. */
static int slopes(const struct judged *l, double *slope) {
    slope_local(l->x, l->error, l->n, slope);
    return l->n > 0 ? l->n - 1 : 0;
}

static int is_smooth(const double *slope, int n) {
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i < n; i++) least = fmin(least, slope[i]), most = fmax(most, slope[i]);
    if (least < -TURN && most > TURN) return 0;
    for (int i = 0; i + 2 < n; i++) {
        double turn = slope[i + 1] - slope[i], back = slope[i + 1] - slope[i + 2];
        if (turn * back > 0 && fabs(turn) > TURN && fabs(back) > TURN) return 0;
    }
    return 1;
}

/* "2.1, -0.4, 3.0" */
static void list_slopes(const double *slope, int n, char *text, size_t size) {
    *text = '\0';
    for (int i = 0; i < n && strlen(text) + 12 < size; i++) words_add(text, size, "%s%.2f", i ? ", " : "", slope[i]);
}

/* The smallest number of rungs, with further ones by halving, for an interval inside the band; 0 if there is
 * none. */
static int rungs_needed(const struct judge_facts *f, const struct slope *s) {
    enum { MOST = 12 };
    double u[RUNG_MAX], half = (s->ci[1] - s->ci[0]) / 2;
    int n = f->rungs.n;
    for (int i = 0; i < n; i++) u[i] = log(f->rungs.x[i]);
    double scatter = half / gsl_cdf_tdist_Pinv(0.975, n - 2) * sqrt(gsl_stats_tss(u, 1, (size_t)n)),
           room = fmin(s->value - f->band[0], f->band[1] - s->value), last = u[n - 1];
    for (int i = n; i < MOST; i++) {
        u[i] = last -= log(2);
        if (gsl_cdf_tdist_Pinv(0.975, i - 1) * scatter / sqrt(gsl_stats_tss(u, 1, (size_t)i + 1)) <= room)
            return i + 1 + f->n - n;
    }
    return 0;
}

/* States the missing number of rungs if the error is small and decreases throughout; returns 1 if so. */
static int says_what_is_missing(const struct judge_facts *f, struct judge_verdict *v) {
    static const double FAR = 0.1;
    const struct judged *r = &f->rungs;
    double slope[RUNG_MAX];
    int n = slopes(r, slope), positive = 1;
    char list[80];
    for (int i = 0; i < n; i++) positive = positive && slope[i] > 0;
    if (r->n < WINDOW_LEAST || !positive || !(f->finest <= FAR * f->ceiling) || !f->band) return 0;
    struct slope s = r->slope ? *r->slope : slope_fit(r->x, r->error, r->n);
    int needed = rungs_needed(f, &s);
    list_slopes(slope, n, list, sizeof list);
    snprintf(v->reason, sizeof v->reason,
             "the error %.2g is %.0f times below its ceiling and falls throughout (slopes %s), but the order's "
             "interval [%.2f, %.2f] of %d rungs reaches past [%g, %g]: ",
             f->finest, f->ceiling / f->finest, list, s.ci[0], s.ci[1], r->n, f->band[0], f->band[1]);
    if (needed)
        words_add(v->reason, sizeof v->reason, "with this scatter %d rungs decide (--rungs %d)", needed, needed);
    else
        words_add(v->reason, sizeof v->reason, "no 12 rungs with this scatter decide");
    return 1;
}

static void judge_smoothness(const struct judge_facts *f, struct judge_verdict *v) {
    double slope[RUNG_MAX];
    int n = slopes(&f->rungs, slope);
    char list[80];
    if (is_smooth(slope, n) || f->named) return;
    list_slopes(slope, n, list, sizeof list);
    snprintf(v->reason, sizeof v->reason,
             "errors do not fall smoothly (slopes %s): points at random, a solver's tolerance, or errors that cancel",
             list);
    leave_open(f, f->finest, v);
}

static void judge_answers(const struct judge_facts *f, struct judge_verdict *v) {
    if (f->noise.share > JUDGE_NOISE) {
        snprintf(v->reason, sizeof v->reason,
                 "answers differ by %.2g K from run to run, %.0f %% of the error: random numbers, threads or an "
                 "unset variable; no order shows",
                 f->noise.apart, 100 * f->noise.share);
        leave_open(f, f->finest - 3 * f->noise.finest, v);
    } else if (f->printed > DIGITS) {
        snprintf(v->reason, sizeof v->reason,
                 "printed digits: %d in the file make up %.0f %% of the finest error; more of them show the order",
                 f->digits, 100 * fmin(f->printed, 1));
        leave_open(f, f->finest, v);
    } else if (!(v->verdict == VERDICT_INCONCLUSIVE && says_what_is_missing(f, v))) {
        judge_smoothness(f, v);
    }
}

/* 1 if each error is below half of the ceiling, raised to coarser rungs by the order in the middle of the band. */
static int is_below_all(const struct judge_facts *f) {
    static const double PART = 0.5;
    double order = nearbyint(f->band[0] + 0.5);
    int all = f->n > 0;
    for (int i = 0; i < f->n; i++) all &= f->error[i] <= PART * f->ceiling * pow(f->x[i] / f->x[f->n - 1], order);
    return all;
}

static void judge_small(const struct judge_facts *f, struct judge_verdict *v) {
    static const double SMALL = 1.0 / 40;
    if (f->finest <= SMALL * f->ceiling)
        snprintf(v->reason, sizeof v->reason, "the error %.4g is below 1/40 of its ceiling %.4g", f->finest,
                 f->ceiling);
    else if (v->verdict == VERDICT_INCONCLUSIVE && is_below_all(f))
        snprintf(v->reason, sizeof v->reason,
                 "the slope scatters, but on each rung the error is below half of its"
                 " ceiling there; %.4g on the finest",
                 f->finest);
    else
        return;
    v->verdict = VERDICT_PASS;
}

/* An error of exactly 0 has no order, and after errors that are no rounding no code has it by itself. */
static int is_zero_alone(const struct judge_facts *f, struct judge_verdict *v) {
    if (!f->finest_exact || f->finest != 0 || f->exact == f->n) return 0;
    v->verdict = VERDICT_INCONCLUSIVE;
    snprintf(
        v->reason, sizeof v->reason,
        "the finest error is exactly 0, after errors that are not at round-off: is that answer the program's own?");
    return 1;
}

struct judge_verdict judge_ladder(const struct judge_facts *f) {
    struct judge_verdict v = {VERDICT_PASS, ""};
    if (f->failure.status || !(f->band || f->ceiling > 0)) {
        judge_unasked(f, &v);
        return v;
    }
    if (is_zero_alone(f, &v)) return v;
    if (f->band) {
        v.verdict = judge_order(&f->rungs, f->band[0], f->band[1], v.reason, sizeof v.reason);
        judge_exact(f, &v);
    }
    if (f->ceiling > 0) judge_ceiling(f->finest, f->ceiling, &v.verdict, v.reason, sizeof v.reason);
    if (v.verdict != VERDICT_PASS && f->answers) judge_answers(f, &v);
    if (v.verdict != VERDICT_PASS && f->small_passes) judge_small(f, &v);
    return v;
}
