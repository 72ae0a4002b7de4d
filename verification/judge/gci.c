/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Observed order, Richardson extrapolation and GCI of three grids h1 < h2 < h3, r21 = h2/h1, r32 = h3/h2 (Roache
 * 1994; Celik et al. 2008; ASME V&V 20-2009, 2-4):
 *
 *     |e32/e21| = g(p),   g(p) = r21^p (r32^p - s)/(r21^p - s),   s = sign(e32/e21)
 *     f_ext = (r21^p f1 - f2) / (r21^p - 1),   GCI = 1.25 |(f1 - f2)/f1| / (r21^p - 1)
 *
 * g is increasing: with u = p ln r21 and v = p ln r32, p times the derivative of ln g is v/(1 - e^-v) - u/(e^u - 1)
 * for s = 1, with the first term above 1 and the second below, and v/(1 + e^-v) + u/(e^u + 1) for s = -1.  There is
 * thus at most one order p > 0, and it exists if and only if |e32/e21| is above g(0+), which is ln r32/ln r21 for
 * s = 1 and 1 for s = -1.  An upper bound follows from g > r32^p - 1 for s = 1, g > r32^p/2 for s = -1. (The papers
 * iterate p = |ln|e32/e21| - ln((r32^p - s)/(r21^p - s))|/ln r21, which diverges if r32 is well above r21.)
 *
 * 1.25 is the safety factor for three grids or more.  Fields on different points are compared at the points of the
 * coarsest of the three; the finer ones are interpolated there (interpolate.h).  Interpolation has an error of its
 * own, which decreases with an order of its own.  A tenth of either change moves p by up to 0.2/ln r21, 0.3 for
 * ratios of 2; the estimate, the difference from a lower degree, is well above the error.  Beyond it no order is
 * given: nodes that the grids share need no interpolation, nor does the mean sum(w T)/sum(w) with the cells' weights.
 * The result estimates the limit of the code's own answers; it does not show that this limit is the solution. */
#include "verification/judge/gci.h"

#include "solver/problem.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/solve/case_run.h"
#include "verification/case/results.h"
#include "verification/case/rows.h"
#include "verification/case/samples.h"
#include "verification/judge/interpolate.h"
#include "verification/text/json.h"
#include "verification/text/whole_file.h"

#include <float.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double SAFETY = 1.25;
enum { HALVINGS = 60, PROBES = 400 };

/* ln g(p) from the logarithms of the two ratios, so that no power of a ratio overflows. */
static double log_ratio(double p, double log21, double log32, int oscillates) {
    double s = oscillates ? -1 : 1, fine = -expm1(-p * log21), coarse = -expm1(-p * log32);
    if (s < 0) fine = 2 - fine, coarse = 2 - coarse;
    return p * log32 + log(coarse) - log(fine);
}

double gci_order(double e21, double e32, double r21, double r32, int *oscillates) {
    double ratio = fabs(e32 / e21), log21 = log(r21), log32 = log(r32);
    *oscillates = e32 / e21 < 0;
    if (!isfinite(ratio) || !(ratio > (*oscillates ? 1 : log32 / log21))) return NAN;
    double lo = 0, hi = log(*oscillates ? 2 * ratio : 1 + ratio) / log32;
    for (int i = 0; i < HALVINGS; i++) {
        double p = (lo + hi) / 2;
        if (log_ratio(p, log21, log32, *oscillates) < log(ratio))
            lo = p;
        else
            hi = p;
    }
    return hi;
}

/* Mean unit of the last printed digit, from some hundred values. */
static double printed_unit(const double *value, size_t n, int *digits) {
    enum { MOST = 500 };
    size_t stride = n / MOST + 1, count = 0;
    double some[MOST];
    for (size_t i = 0; i < n; i += stride) some[count++] = value[i];
    return number_units(some, count, 0, digits) / (double)count;
}

/* Change of the order for an error `unit` in each of the two last changes, from the slope of ln g. */
static double unsure_by(const struct gci *g, const double *e, double unit, const struct gci_row *row) {
    static const double STEP = 1e-4;
    double log21 = log(g->h[g->n - 2] / g->h[g->n - 1]), log32 = log(g->h[g->n - 3] / g->h[g->n - 2]), p = row->order;
    double off = unit / fabs(e[g->n - 2]) + unit / fabs(e[g->n - 3]);
    if (!isfinite(p)) return off > 0.5 ? INFINITY : 0;
    return off * STEP /
           (log_ratio(p + STEP, log21, log32, row->oscillates) - log_ratio(p, log21, log32, row->oscillates));
}

/* Sets orders and index from the differences e[i] between answers i and i + 1, coarsest first. */
static void judge(const struct gci *g, const double *e, double size, struct gci_row *row) {
    int n = g->n, ignored;
    row->order = NAN;
    for (int i = 0; i + 2 < n; i++)
        row->orders[i] = row->order = gci_order(e[i + 1], e[i], g->h[i + 1] / g->h[i + 2], g->h[i] / g->h[i + 1],
                                                i + 3 == n ? &row->oscillates : &ignored);
    double more = pow(g->h[n - 2] / g->h[n - 1], row->order) - 1;
    row->change = fabs(e[n - 2]) / fabs(size);
    row->index = SAFETY * row->change / more;
    row->extrapolated = row->value[n - 1] + (row->value[n - 1] - row->value[n - 2]) / more;
}

static struct gci_row *add(struct gci *g, const char *name) {
    if (g->rows == GCI_QUANTITIES) return NULL;
    struct gci_row *row = &g->row[g->rows++];
    *row = (struct gci_row){0};
    snprintf(row->name, sizeof row->name, "%s", name);
    return row;
}

static void differences(const struct gci *g, const struct gci_row *row, double e[NUMBERS_MAX]) {
    for (int i = 0; i + 1 < g->n; i++) e[i] = row->value[i] - row->value[i + 1];
}

/* unit: by how much a value may be off. */
static void judge_values(const struct gci *g, double unit, struct gci_row *row) {
    double e[NUMBERS_MAX] = {0};
    differences(g, row, e);
    judge(g, e, row->value[g->n - 1], row);
    row->unsure = unsure_by(g, e, unit, row);
}

static void judge_printed(const struct gci *g, struct gci_row *row) {
    judge_values(g, printed_unit(row->value, (size_t)g->n, &row->digits), row);
}

/* ---- A line of values ---- */

/* Stores the numbers of a line of names and one of as many numbers at spacing i: 1, or 0 with *why. */
static int take_values(const struct rows *r, const char *first, int i, struct gci *g, struct failure *why) {
    struct rows_cell name[ROWS_CELLS], value[ROWS_CELLS];
    char separator = rows_separator(r->line->text), label[GCI_NAME], quoted[48];
    int n = rows_split(r, &r->line[0], separator, name, why), m = rows_split(r, &r->line[1], separator, value, why);
    int same = n > 0 && n == m && (i == 0 || n == g->rows);
    if (!same)
        refuse(why, STATUS_INPUT, "%.150s: not a line of %d names and one of as many numbers, as %.150s is", r->name,
               g->rows, first);
    for (int k = 0; k < n && same; k++) {
        double read, ignored;
        snprintf(label, sizeof label, "%.*s", (int)name[k].length, name[k].text);
        if (number_read_printed(value[k].text, value[k].length, &read) ||
            number_read_printed(name[k].text, name[k].length, &ignored) >= 0)
            same = 0, refuse(why, STATUS_INPUT, "%.150s, line %ld, column %d (%s): '%s' is not a number", r->name,
                             r->line[1].number, k + 1, label, rows_quote(value[k].text, value[k].length, quoted));
        else if (i > 0 && strcmp(g->row[k].name, label) != 0)
            same = 0, refuse(why, STATUS_INPUT, "%.150s, line %ld: column %d is '%.40s', but '%.47s' in %.150s",
                             r->name, r->line[0].number, k + 1, label, g->row[k].name, first);
        else if (i > 0 || add(g, label))
            g->row[k].value[i] = read;
        else
            same = 0;
    }
    return same;
}

/* Reads a line of names and a line with as many numbers.  Returns 1; 0 if the first file is not of this form; -1 with
 * *why if a later one differs from `first`. */
static int read_values(const char *path, const char *first, int i, struct gci *g, struct failure *why) {
    struct rows r = {0};
    FILE *in = whole_file_open(path);
    int status =
        in ? rows_read(in, path, &r, why) : refuse(why, STATUS_INPUT, "%.200s: %s", path, whole_file_error());
    if (in) fclose(in);
    if (!status && r.count != 2)
        status =
            refuse(why, STATUS_INPUT, "%.150s: not a line of names and one of numbers, as %.150s is", path, first);
    int same = !status && take_values(&r, first, i, g, why);
    rows_free(&r);
    return same ? 1 : i == 0 ? 0 : -1;
}

/* ---- Fields ---- */

static int read_field(const char *path, const struct column_map *c, struct samples *s, struct failure *why) {
    for (int dim = DIM_MAX; dim > 1; dim--) {
        double lo, hi;
        if (samples_read(path, path, dim, c, s, why)) continue;
        for (; s->dim > 1; s->dim--) { /* an axis along which all points are at one place */
            gsl_stats_minmax(&lo, &hi, s->value[s->dim - 1], 1, s->n);
            if (hi > lo) break;
        }
        return STATUS_OK;
    }
    return samples_read(path, path, 1, c, s, why);
}

/* Drops the values and orders of a quantity if interpolation, off by off[i] at spacing i, hides its last two changes
 * e. */
static void check_between(const struct gci *g, const double *e, const double *off, struct gci_row *row) {
    for (int i = g->n - 3; i + 1 < g->n; i++)
        if (off[i] + off[i + 1] > 0) row->between = fmax(row->between, (off[i] + off[i + 1]) / fabs(e[i]));
    if (row->between <= GCI_BETWEEN) return;
    for (int i = 0; i < g->n; i++) row->value[i] = row->orders[i] = NAN;
    row->order = row->extrapolated = row->change = row->index = NAN;
}

/* Differences between successive fields at the points of the third finest, at most PROBES of them. */
static int compare_fields(struct gci *g, const struct samples *s, const struct interpolate *f, struct failure *why) {
    const struct samples *coarse = &s[g->n - 3];
    size_t stride = coarse->n / PROBES + 1;
    double e[NUMBERS_MAX] = {0}, off[NUMBERS_MAX] = {0}, size = 0, T[NUMBERS_MAX], by;
    for (size_t k = 0; k < coarse->n; k += stride) {
        double x[DIM_MAX];
        samples_point(coarse, k, x);
        for (int i = 0; i < g->n; i++) {
            if (interpolate_sure(&f[i], x, &T[i], &by, why)) return why->status;
            off[i] += by;
        }
        for (int i = 0; i + 1 < g->n; i++) e[i] += fabs(T[i] - T[i + 1]);
        size += fabs(T[g->n - 1]);
    }
    struct gci_row *row = add(g, "T (mean over the points)");
    if (!row) return STATUS_OK;
    for (int i = 0; i < g->n; i++) row->value[i] = NAN;
    judge(g, e, size, row);
    double unit = printed_unit(s[g->n - 1].value[COLUMN_T], s[g->n - 1].n, &row->digits) / 4;
    row->unsure = unsure_by(g, e, unit * (double)((coarse->n + stride - 1) / stride), row);
    check_between(g, e, off, row);
    return STATUS_OK;
}

static int probe(struct gci *g, const struct interpolate *f, const struct numbers *at, struct failure *why) {
    char name[GCI_NAME];
    const double *x = at->value;
    double e[NUMBERS_MAX] = {0}, off[NUMBERS_MAX];
    const int dim = f->field->dim;
    if (at->count != dim) return refuse(why, STATUS_INPUT, "--at: %d numbers, the points have %d", at->count, dim);
    snprintf(name, sizeof name, "T at %g", x[0]);
    for (int a = 1; a < at->count; a++) words_add(name, sizeof name, ", %g", x[a]);
    struct gci_row *row = add(g, name);
    for (int i = 0; i < g->n; i++)
        if (interpolate_sure(&f[i], x, &row->value[i], &off[i], why)) return why->status;
    differences(g, row, e);
    judge_printed(g, row);
    check_between(g, e, off, row);
    return STATUS_OK;
}

/* sum(w T)/sum(w) of one answer, K, and in *unit what printed digits and rounding leave open, K. */
static double weighted_mean(const struct samples *s, double *unit, int *digits) {
    const double *w = s->value[COLUMN_W], *T = s->value[COLUMN_T];
    double sum = 0, size = 0, weights = 0;
    for (size_t i = 0; i < s->n; i++) sum += w[i] * T[i], size += w[i] * fabs(T[i]), weights += w[i];
    *unit = printed_unit(T, s->n, digits) / 4 + DBL_EPSILON * sqrt((double)s->n) * size / weights;
    return sum / weights;
}

/* The mean, if each answer has weights. */
static int take_means(struct gci *g, struct samples *s, struct failure *why) {
    double unit = 0;
    for (int i = 0; i < g->n; i++) {
        if (!s[i].value[COLUMN_W]) return STATUS_OK;
        if (samples_scale_weights(&s[i], why)) return why->status;
    }
    struct gci_row *row = add(g, "mean of T, weighted by w");
    for (int i = 0; i < g->n; i++) row->value[i] = weighted_mean(&s[i], &unit, &row->digits);
    judge_values(g, unit, row);
    return STATUS_OK;
}

/* Refuses fields on points too few for any quantity. */
static int refuse_hidden(const struct gci *g, const struct interpolate *f, struct failure *why) {
    double least = INFINITY;
    for (int k = 0; k < g->rows; k++) least = fmin(least, g->row[k].between);
    if (least <= GCI_BETWEEN) return STATUS_OK;
    return refuse(
        why, STATUS_INPUT,
        "%.150s: its points differ from those of other spacings, and interpolation between them is off by up to "
        "%.2g of the change from grid to grid; an order needs at most %g: use finer grids, points that all grids "
        "share (nodes), or a column w of volumes for the mean",
        f->name, least, GCI_BETWEEN);
}

static int read_fields(char (*path)[RESULTS_PATH + 16], const struct column_map *c, const struct numbers *at,
                       struct gci *g, struct failure *why) {
    struct samples *s = xcalloc((size_t)g->n, sizeof *s);
    int status = STATUS_OK, read = 0;
    for (; read < g->n && !status; read++) status = read_field(path[read], c, &s[read], why);
    for (int i = 1; i < g->n && !status; i++)
        if (s[i].dim != s[0].dim)
            status = refuse(why, STATUS_INPUT, "%.200s has points of %d coordinates, %.200s of %d", path[i], s[i].dim,
                            path[0], s[0].dim);
    struct interpolate *f = xcalloc((size_t)g->n, sizeof *f);
    struct field *view = xcalloc((size_t)g->n, sizeof *view); /* shares the arrays of the samples */
    for (int i = 0; i < g->n && !status; i++) {
        double *const *value = s[i].value;
        view[i] = (struct field){.dim = s[i].dim, .n = s[i].n, .T = value[COLUMN_T]};
        for (int a = 0; a < s[i].dim; a++) view[i].x[a] = value[COLUMN_X + a];
        f[i] = interpolate_begin(s[i].path, &view[i]);
        interpolate_find_rows(&f[i]);
    }
    if (!status) status = compare_fields(g, s, f, why);
    if (!status && at->count) status = probe(g, f, at, why);
    if (!status) status = take_means(g, s, why);
    if (!status) status = refuse_hidden(g, &f[g->n - 3], why);
    for (int i = 0; i < g->n; i++) interpolate_end(&f[i]);
    free(f);
    free(view);
    for (int i = 0; i < read; i++) samples_free(&s[i]);
    free(s);
    return status;
}

/* ---- All spacings ---- */

static int find_answer(const char *dir, double h, char path[RESULTS_PATH + 16], struct failure *why) {
    char of[RESULTS_PATH];
    if (results_directory(dir, h, of)) return refuse(why, STATUS_INPUT, "--results '%.200s': too long a path", dir);
    if (results_answer(of, path, RESULTS_PATH + 16)) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "%.300s: no answer; needs out.csv, out.npy or out.dat", of);
}

int gci_read(const char *dir, const struct column_map *c, const struct numbers *at, struct gci *g,
             struct failure *why) {
    struct numbers h;
    char(*path)[RESULTS_PATH + 16] = xcalloc(NUMBERS_MAX, sizeof *path);
    *g = (struct gci){0};
    int status = results_list(dir, &h, why), values = 1;
    if (!status && h.count < 3)
        status = refuse(why, STATUS_INPUT, "--results '%.200s': %d spacings; without an exact solution needs three",
                        dir, h.count);
    if (!status) {
        number_sort_falling(h.value, h.count);
        memcpy(g->h, h.value, sizeof g->h);
        g->n = h.count;
    }
    for (int i = 0; i < g->n && !status; i++) status = find_answer(dir, g->h[i], path[i], why);
    for (int i = 0; i < g->n && !status && values > 0; i++)
        if ((values = read_values(path[i], path[0], i, g, why)) < 0) status = why->status;
    if (!status && values)
        for (int k = 0; k < g->rows; k++) judge_printed(g, &g->row[k]);
    else if (!status) {
        g->rows = 0;
        status = read_fields(path, c, at, g, why);
    }
    free(path);
    return status;
}

void gci_json(const struct gci *g, struct json *j) {
    json_numbers(j, "spacings", g->h, g->n);
    json_numbers(j, "used", g->h + g->n - 3, 3); /* in observed_order, extrapolated, relative_change and gci */
    json_array(j, "quantities");
    for (int k = 0; k < g->rows; k++) {
        const struct gci_row *row = &g->row[k];
        json_object(j, NULL);
        json_text(j, "quantity", row->name);
        json_numbers(j, "spacings", g->h, g->n); /* a row of a table has all that it needs */
        json_numbers(j, "values", row->value, g->n);
        json_number(j, "observed_order", row->order);
        json_numbers(j, "orders", row->orders, g->n - 2);
        json_add(j, "extrapolated %g|relative_change %g|gci %g|oscillates %d", row->extrapolated, row->change,
                 row->index, row->oscillates);
        json_add(j, "printed_digits %d|order_unsure_by %g|interpolation_share %g", row->digits, row->unsure,
                 row->between);
        json_end(j);
    }
    json_end(j);
}
