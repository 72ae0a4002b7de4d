/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Evaluation of the rungs of a ladder: errors, window, slope, verdict. */
#include "verification/judge/ladder.h"

#include "solver/words.h"
#include "verification/judge/judge.h"
#include "verification/text/json.h"
#include "verification/text/table.h"

#include <math.h>
#include <stdio.h>

double ladder_error_in(const struct result *r, enum norm norm) {
    return r->failure.status ? NAN : r->error[norm];
}

int ladder_counted(const struct ladder *l, double *x, double *error) {
    int m = 0;
    for (int i = 0; i < l->n; i++) {
        if (!l->window.counts[i]) continue;
        x[m] = l->x[i];
        error[m++] = l->error[i];
    }
    return m;
}

double ladder_finest_error(const struct ladder *l) {
    double error = NAN;
    for (int i = 0; i < l->n; i++)
        if (l->window.counts[i] || l->window.exact[i]) error = l->error[i];
    return error;
}

const char *ladder_axis(const struct ladder *l) {
    return l->in_time ? "dt [s]" : *l->vary ? l->vary : "dx [m]";
}

double ladder_asked(const struct ladder *l, int rung) {
    return l->inverse ? 1 / l->x[rung] : l->x[rung];
}

/* With a quantity E1 is the only norm of the field; else each norm with a column, and the fitted one. */
static int is_shown(const struct ladder *l, int norm) {
    return l->norm == NORM_QUANTITY ? norm == NORM_L1 : norm_columns[norm] || norm == (int)l->norm;
}

static void add_rung(struct table *t, const struct ladder *l, int timed, int i) {
    const struct result *r = &l->rung[i];
    int failed = r->failure.status != STATUS_OK;
    table_add(t, "%.6g|%zu|%lld", ladder_asked(l, i), r->particles, r->steps);
    for (int k = 0; k < NORM_QUANTITY; k++)
        if (is_shown(l, k)) table_number(t, "%.4e", failed ? NAN : r->error[k], "-");
    if (l->norm == NORM_QUANTITY) {
        table_number(t, "%.4e", failed ? NAN : r->derived, "-");
        table_number(t, "%.4e", failed ? NAN : r->error[NORM_QUANTITY], "-");
    }
    if (i == 0)
        table_add(t, " ");
    else
        table_number(t, "%.3f", l->local[i - 1], "-");
    table_number(t, "%.2g", 100 * r->time_error, " ");
    if (timed) table_number(t, "%.2g", r->cost.seconds, "-");
    table_add(t, "%s", failed ? r->failure.text : l->window.left_out[i]);
}

struct table ladder_table(const struct ladder *l, int timed) {
    char header[240];
    snprintf(header, sizeof header, "%s|particles|steps", ladder_axis(l));
    for (int k = 0; k < NORM_QUANTITY; k++)
        if (is_shown(l, k))
            words_add(header, sizeof header, "|%s", norm_columns[k] ? norm_columns[k] : norm_titles[k]);
    if (l->norm == NORM_QUANTITY) words_add(header, sizeof header, "|quantity|its error");
    words_add(header, sizeof header, "|slope|time [%%]|%sleft out", timed ? "seconds|" : "");
    struct table t = table_headed(0, header);
    for (int i = 0; i < l->n; i++) add_rung(&t, l, timed, i);
    return t;
}

void ladder_slope_text(const struct ladder *l, char *text, size_t size) {
    int used = snprintf(text, size, "slope of %s: ", norm_titles[l->norm]);
    char *rest = text + used;
    size_t room = size - (size_t)used;
    int known = 0;
    for (int i = 0; i < l->n; i++) known += l->window.counts[i] && isfinite(l->error[i]) && l->error[i] > 0;
    if (!isfinite(l->slope.value))
        snprintf(rest, room, "- (of %d rungs %d have an error, a slope needs two)", l->n, known);
    else if (l->slope.n < 3)
        snprintf(rest, room, "%.4f, 95 %% interval - (undefined for two rungs), over 2 of %d rungs", l->slope.value,
                 l->n);
    else
        snprintf(rest, room, "%.4f, 95 %% interval [%.4f, %.4f], over %d of %d rungs", l->slope.value, l->slope.ci[0],
                 l->slope.ci[1], l->slope.n, l->n);
}

/* ---- Planes of jumps in cells ---- */

struct plane {
    int axis;
    double at; /* m */
    const char *what;
};

enum { PLANES = DIM_MAX * JUMP_MAX + 1 };

/* Sorted by axis, one at each place. */
static int find_planes(const struct problem *p, struct plane plane[PLANES]) {
    int n = 0;
    for (int a = 0; a < p->dim && !p->shape; a++)
        for (int j = 0; j < p->jumps[a]; j++) plane[n++] = (struct plane){a, p->jump[a][j], "jump"};
    if (p->materials == 2 && !p->jumps[0]) plane[n++] = (struct plane){0, p->interface, "interface"};
    return n;
}

/* Distance of the plane to the nearest face, in cells: 0 to 1/2; errors of both sides are nearly the same. */
static double off_face(const struct problem *p, const struct plane *plane, double dx) {
    int a = plane->axis;
    double extent = p->hi[a] - p->lo[a], cells = fmax(1, nearbyint(extent / dx));
    return fabs(remainder((plane->at - p->lo[a]) / extent * cells, 1));
}

static const double SAME_PLACE = 0.01; /* cells */

/* The spacing nearest to dx, below `most`, that divides the domain along x with all planes on faces; 0: none up to
 * twice finer. */
static double on_faces(const struct problem *p, const struct plane *plane, int planes, double dx, double most) {
    double extent = p->hi[0] - p->lo[0], cells = nearbyint(extent / dx);
    for (double away = 0; away <= cells + 4; away++)
        for (int side = -1; side <= 1; side += 2) {
            double n = cells + side * away, off = 0;
            if (n < 1 || extent / n >= most) continue;
            for (int k = 0; k < planes; k++) off = fmax(off, off_face(p, &plane[k], extent / n));
            if (off < 1e-6) return extent / n;
        }
    return 0;
}

void ladder_places_text(const struct ladder *l, const struct problem *p, char *text, size_t size) {
    struct plane plane[PLANES];
    int planes = find_planes(p, plane), moves = -1;
    int layout = (int)l->rung[0].options.layout;
    *text = '\0';
    if (l->in_time || *l->vary || layout == LAYOUT_JITTER || layout == LAYOUT_RELAXED) return;
    for (int k = 0; k < planes && moves < 0; k++) {
        double lo = INFINITY, hi = -INFINITY;
        for (int i = 0; i < l->n; i++) {
            if (!l->window.counts[i]) continue;
            double off = off_face(p, &plane[k], l->x[i]);
            lo = fmin(lo, off), hi = fmax(hi, off);
        }
        if (hi - lo > SAME_PLACE) moves = k;
    }
    if (moves < 0) return;
    snprintf(text, size, "the %s at %c = %.4g m is", plane[moves].what, "xyz"[plane[moves].axis], plane[moves].at);
    for (int i = 0; i < l->n; i++)
        words_add(text, size, "%s %.2g", i ? "," : "", off_face(p, &plane[moves], l->x[i]));
    words_add(text, size, " cells from a face: the error scatters from rung to rung");
    double dx = INFINITY;
    char better[160] = "";
    for (int i = 0; i < l->n && dx > 0; i++) {
        dx = on_faces(p, plane, planes, l->x[i], dx);
        words_add(better, sizeof better, "%s%.8g", i ? "," : "", dx);
    }
    if (dx > 0) words_add(text, size, "; on faces with --dx %s", better);
}

/* The slope and its interval from all draws of all included rungs. */
static void fit_draws(struct ladder *l) {
    double x[RUNG_MAX * SEEDS_MAX], error[RUNG_MAX * SEEDS_MAX];
    int n = 0, rungs = l->slope.n;
    for (int i = 0; i < l->n; i++)
        for (int k = 0; k < l->draws && l->window.counts[i]; k++) x[n] = l->x[i], error[n++] = l->draw[k][i];
    l->window.scattered = 1;
    l->slope = slope_fit(x, error, n);
    l->slope.n = rungs;
}

/* The facts of the rungs, and of the program's answers if they are known, to the judge. */
static void judge(struct ladder *l) {
    double x[RUNG_MAX], error[RUNG_MAX];
    struct judge_facts f = {
        .rungs = {x, error, ladder_counted(l, x, error), l->window.scattered, l->draws > 1 ? &l->slope : NULL},
        .x = l->x,
        .error = l->error,
        .n = l->n,
        .finest_exact = l->n > 0 && l->window.exact[l->n - 1],
        .finest = ladder_finest_error(l),
        .band = l->asked.expect.count ? l->asked.expect.value : NULL,
        .ceiling = l->asked.ceiling,
        .small_passes = l->asked.small_passes,
        .failure = l->failure,
        .answers = l->open && l->external,
        .noise = l->noise,
        .printed = l->printed,
        .digits = l->digits,
        .named = l->named};
    for (int i = 0; i < l->n; i++) f.exact += l->window.exact[i];
    struct judge_verdict v = judge_ladder(&f);
    l->verdict = v.verdict;
    snprintf(l->reason, sizeof l->reason, "%s", v.reason);
}

void ladder_judge(struct ladder *l, double lo, double hi) {
    l->asked.expect = (struct numbers){.count = 2, .value = {lo, hi}};
    judge(l);
}

void ladder_explained(struct ladder *l) {
    l->named = 1;
    judge(l);
}

void ladder_fit(struct ladder *l, enum norm norm) {
    struct window_rung rung[RUNG_MAX];
    double x[RUNG_MAX], error[RUNG_MAX];
    enum norm share = norm == NORM_QUANTITY ? norm : NORM_L1; /* shares of E1 apply to other norms of the field */
    l->norm = norm;
    for (int i = 0; i < l->n; i++) {
        const struct result *r = &l->rung[i];
        l->error[i] = ladder_error_in(r, norm);
        rung[i] = (struct window_rung){
            .x = l->x[i],
            .error = l->error[i],
            .time = l->in_time ? NAN : r->time_error,
            .reference = (norm == NORM_QUANTITY ? r->derived_bound : r->reference_error) / r->error[share],
            .rounding = (norm == NORM_QUANTITY ? r->derived_rounding : r->rounding) / r->error[share],
            /* in a ladder in time the positions do not change */
            .random = (r->options.layout == LAYOUT_JITTER || r->options.layout == LAYOUT_RELAXED) && !l->in_time};
    }
    slope_local(l->x, l->error, l->n, l->local);
    window_choose(rung, l->n, &l->window);
    l->window.scattered |= l->asked.scattered;
    for (int i = 0; i < l->n; i++)
        if (l->rung[i].failure.status) l->window.counts[i] = 0;
    l->slope = slope_fit(x, error, ladder_counted(l, x, error));
    if (l->draws > 1) fit_draws(l);
    judge(l);
}

void ladder_json(const struct ladder *l, struct json *j) {
    json_array(j, "rungs");
    for (int i = 0; i < l->n; i++) {
        json_object(j, NULL);
        result_json(&l->rung[i], j);
        if (*l->vary) json_number(j, l->vary, ladder_asked(l, i));
        json_number(j, "slope", i > 0 ? l->local[i - 1] : NAN); /* to the rung before */
        json_whole(j, "counts", l->window.counts[i]);
        json_text(j, "left_out", l->window.left_out[i][0] ? l->window.left_out[i] : NULL);
        json_end(j);
    }
    json_end(j);
    json_text(j, "against", l->in_time ? "dt" : *l->vary ? l->vary : "dx");
    json_number(j, "slope", l->slope.value);
    json_numbers(j, "slope_ci95", l->slope.ci, 2);
    json_numbers(j, "local_slopes", l->local, l->n - 1);
    json_add(j, "verdict %s|reason %s", verdict_words[l->verdict], l->reason);
}
