/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The joint diagnosis.  A hypothesis is a fault at one place, or at any, with one size in one unit for all rows:
 * of the sizes that rows show.  Its score is the mean share of the squared errors that it explains, over
 * rows and both rungs of each.  The best one that no passing row contradicts is the headline. */
#include "verification/fault/headline.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/fault/fit.h"
#include "verification/fault/response.h"
#include "verification/fault/wording.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double VOTE = 0.8; /* least share of a row's error for a vote */
static const double MOST_ROWS = 0.7;
static const double NOISE = 0.03; /* scores that differ by less do not distinguish two faults */

struct hypothesis {
    struct fault fault; /* at FAULT_ANY: the best place of each row */
    const char *unit;
    double size, score;
    int votes;
    double voted;                  /* mean share of the rows that vote */
    const struct fault_fit *shown; /* the fit of the row that shows it best */
};

/* Whether a row without fits, or with a name that needs none, shows the fault by itself.  An extra step in every run
 * agrees with extra steps in some runs. */
static int names(const struct diagnosis *row, const struct hypothesis *h) {
    static const double SAME = 0.2; /* each size is known to 12 %, half of FIT_STEADY: sqrt(2) of that */
    /* a wall that is taken as linear over half a cell acts dx^2/(8 kappa) late, half a step of dx^2/(4 kappa) */
    static const double HALF_CELL = 0.75;
    const enum fault_kind kind = h->fault.kind;
    int some = kind == FAULT_SOME_STEPS && row->fault.kind == FAULT_CLOCK && strcmp(row->unit, "steps") == 0;
    /* if walls alone change T, an early end and early walls leave the same difference of two runs */
    int early = kind == FAULT_CLOCK && row->fault.kind == FAULT_WALL_TIME && strcmp(h->unit, "steps") == 0;
    /* a wall that heats itself lets T grow without bound */
    int grows = kind == FAULT_AIR_SIGN && row->fault.kind == FAULT_UNSTABLE;
    if (!row->named || (row->fault.kind != kind && !some && !early && !grows)) return 0;
    if (kind == FAULT_WHOLE_STEPS || kind == FAULT_CUT) return row->fault.at == h->fault.at;
    if (kind == FAULT_NOISE || kind == FAULT_UNSTABLE || fault_rows[kind].unit == UNIT_WHOLE) return 1;
    if (strcmp(row->unit, h->unit) != 0) return 0;
    if ((early || kind == FAULT_WALL_TIME) && strcmp(h->unit, "steps") == 0)
        return row->size * h->size > 0 && fabs(row->size - h->size) <= HALF_CELL;
    return fabs(row->size - h->size) <= SAME * fmin(fabs(row->size), fabs(h->size));
}

static int is_made(enum fault_kind kind) {
    return fault_rows[kind].change != NULL;
}

/* The fit of a row to the hypothesis that explains most, with its size in the unit or with that of h; NULL: none. */
static const struct fault_fit *best_fit(const struct evidence *e, const struct hypothesis *h, int own_size,
                                        double *share) {
    const struct fault_fit *best = NULL;
    *share = 0;
    for (int i = 0; e && i < e->n; i++) {
        const struct fault_fit *c = &e->fit[i];
        double of = 0;
        if (c->fault.kind != h->fault.kind || (h->fault.at != FAULT_ANY && c->fault.at != h->fault.at)) continue;
        for (int k = 0; k < 2; k++) {
            double unit = fit_unit(c, h->unit, k);
            of += unit == 0  ? 0
                  : own_size ? c->rung[k].share / 2
                             : fmax(0, fit_share(&c->rung[k], h->size * unit)) / 2;
        }
        if (own_size && (c->rung[0].share < VOTE || c->rung[0].part < FIT_MOST)) continue;
        if (of > *share) *share = of, best = c;
    }
    return best;
}

/* Whether the fault, with the size of h, is as large there as a correct code's own error. */
static int is_seen(const struct fault_fit *c, const struct hypothesis *h) {
    double part = 0;
    for (int k = 0; c && k < 2; k++)
        part = fmax(part, c->rung[k].part * fabs(h->size * fit_unit(c, h->unit, k) / c->rung[k].size));
    return part >= 1;
}

/* The share of a row's error that it explains; *seen: whether it has a part in it. */
static double share_of(const struct diagnosis *row, const struct hypothesis *h, int *seen) {
    static const double LONGEST = 0.5; /* dx^2/kappa: the longest stable step of Euler in a rod */
    double share = 0;
    int off[2];
    *seen = 1;
    if (names(row, h) && (!is_made(h->fault.kind) || !row->evidence)) return 1;
    if (h->fault.kind == FAULT_WHOLE_STEPS) return fit_whole_steps(row->evidence, h->fault.at, LONGEST);
    if (h->fault.kind == FAULT_SOME_STEPS) {
        share = fit_some_steps(row->evidence, h->size < 0 ? -1 : 1, off);
        *seen = off[0] || off[1];
        return share;
    }
    *seen = is_seen(best_fit(row->evidence, h, 0, &share), h);
    return share;
}

/* Sets score and votes with h->size. */
static void score(struct hypothesis *h, const struct diagnosis *row, int failing, int known) {
    h->score = 0, h->votes = 0, h->voted = 0;
    for (int i = 0; i < failing; i++) {
        int seen;
        double share = share_of(&row[i], h, &seen);
        h->score += share / known;
        h->votes += seen && share >= VOTE;
        h->voted += seen && share >= VOTE ? share : 0;
    }
    if (h->votes) h->voted /= h->votes;
    if (fault_rows[h->fault.kind].is & FAULT_RARE) h->score -= NOISE / 2;
}

/* Sizes that rows show, in the unit of h; returns their number. */
static int sizes_of(struct hypothesis *h, const struct diagnosis *row, int failing, double *size) {
    double share, most = 0;
    size_t n = 0;
    for (int i = 0; i < failing && is_made(h->fault.kind); i++) {
        const struct fault_fit *c = best_fit(row[i].evidence, h, 1, &share);
        if (!c) continue;
        size[n++] = c->rung[0].size / fit_unit(c, h->unit, 0);
        if (h->fault.kind == FAULT_MEAN) share *= 1 - c->geometric; /* shows which of the other means */
        if (share > most) most = share, h->shown = c;
    }
    gsl_sort(size, 1, n);
    return (int)n;
}

/* Sets size, score and votes: of the sizes that rows show, or some of many, the one with the best score.  known: rows
 * with errors or a name. */
static void judge(struct hypothesis *h, const struct diagnosis *row, int failing, int known) {
    enum { TRIED = 9 };
    const struct fault_row *of = &fault_rows[h->fault.kind];
    double *size = xcalloc((size_t)failing + 1, sizeof *size);
    int n = sizes_of(h, row, failing, size), tried = n < TRIED ? n : TRIED;
    if (of->unit == UNIT_WHOLE || of->is & FAULT_CELL) size[0] = of->is & FAULT_CELL ? of->cells : 1, n = tried = 1;
    if (!n) size[0] = h->size, n = tried = 1;
    struct hypothesis best = *h;
    for (int i = 0; i < tried; i++) {
        h->size = size[tried > 1 ? i * (n - 1) / (tried - 1) : 0];
        if (of->is & FAULT_HALF) h->size = nearbyint(2 * h->size) / 2;
        score(h, row, failing, known);
        if (i == 0 || h->score > best.score) best = *h;
    }
    *h = best;
    free(size);
}

static int is_listed(const struct hypothesis *list, int n, const struct hypothesis *h) {
    for (int i = 0; i < n; i++)
        if (list[i].fault.kind == h->fault.kind && list[i].fault.at == h->fault.at &&
            strcmp(list[i].unit, h->unit) == 0)
            return 1;
    return 0;
}

/* Hypotheses that some row suggests; returns their number. */
static int suggest(const struct diagnosis *row, int failing, struct hypothesis *list, int most) {
    int n = 0;
    for (int i = 0; i < failing; i++) {
        struct hypothesis own = {.fault = row[i].fault, .unit = row[i].unit, .size = row[i].size};
        if (row[i].named && (!is_made(own.fault.kind) || !row[i].evidence) && n < most && !is_listed(list, n, &own))
            list[n++] = own;
        for (int k = 0; row[i].evidence && k < row[i].evidence->n; k++) {
            const struct fault_fit *c = &row[i].evidence->fit[k];
            const int joins = fault_rows[c->fault.kind].is & FAULT_JOINS ? 1 : 0;
            if (c->rung[0].share < VOTE || c->rung[0].part < FIT_MOST) continue;
            for (const char *const *unit = fit_unit_names(c->fault.kind); *unit; unit++)
                for (int any = 0; any <= joins; any++) {
                    struct hypothesis h = {.fault = {c->fault.kind, any ? FAULT_ANY : c->fault.at}, .unit = *unit};
                    if (fit_unit(c, *unit, 0) != 0 && n < most && !is_listed(list, n, &h)) list[n++] = h;
                }
        }
    }
    return n;
}

/* A time that is not a number of steps is a rare slip: a wrong end is one step off, data that keep their first value
 * are late by any time. */
static int rarity(const struct hypothesis *h) {
    if (h->fault.kind == FAULT_CLOCK && *h->unit == '%') return FAULT_HEAT_CAPACITY + 1;
    return strcmp(h->unit, "s") == 0 ? FAULT_KINDS : (int)h->fault.kind;
}

static const double AS_WELL = 0.02; /* scores that differ by less are equal */

/* The better one explains more; of two that explain as much, it is at one place, or the more common.  Of k, rho c and
 * the end time it has more votes: few rows tell them apart. */
static int is_better(const struct hypothesis *a, const struct hypothesis *b) {
    if (fabs(a->score - b->score) > AS_WELL) return a->score > b->score;
    if (fit_pace(a->fault.kind, a->unit) && fit_pace(b->fault.kind, b->unit) && a->votes != b->votes)
        return a->votes > b->votes;
    if (a->fault.kind != b->fault.kind) return rarity(a) < rarity(b);
    if ((a->fault.at == FAULT_ANY) != (b->fault.at == FAULT_ANY)) return b->fault.at == FAULT_ANY;
    if (strcmp(a->unit, b->unit) != 0) return strcmp(a->unit, "steps") == 0 || !*b->unit; /* if a size is known */
    return a->score > b->score;
}

/* Two votes, or that of the only row whose errors are known: it speaks for others if it leaves no part unexplained.
 */
static int is_heard(const struct hypothesis *h, int known, int failing) {
    return h->votes >= 2 || (known == 1 && h->votes && (failing == 1 || h->voted >= FIT_SHARE));
}

/* The diagnosis of a hypothesis: its share is that of the rows which vote. */
static struct diagnosis named(const struct hypothesis *h, const struct diagnosis *row, int failing) {
    struct diagnosis d = {.named = 1, .fault = h->fault, .size = h->size, .unit = h->unit, .share = NAN};
    if (h->shown) d = diagnosis_of(h->shown, h->unit, h->size);
    d.sides = ~0u;
    for (int i = 0; i < failing; i++) {
        double share;
        const struct fault_fit *c = best_fit(row[i].evidence, h, 0, &share);
        if (!c || share < VOTE || !is_seen(c, h)) continue;
        d.sides &= c->sides;
        if (h->fault.at == FAULT_ANY && c->fault.at != h->shown->fault.at) d.fault.at = FAULT_ANY;
    }
    wording_fault(&d);
    return d;
}

/* The next best fault if all rows with fits melt, where many displace the front by as much. */
static struct diagnosis rival(const struct hypothesis *list, int n, int best, const struct diagnosis *row,
                              int failing) {
    const struct diagnosis none = {.named = 0};
    int at = -1, melt = 0, others = 0;
    for (int i = 0; i < n; i++) {
        if (list[i].fault.kind == list[best].fault.kind || list[i].votes < list[best].votes ||
            list[i].score < list[best].score - NOISE)
            continue;
        if (at < 0 || is_better(&list[i], &list[at])) at = i;
    }
    for (int i = 0; i < failing; i++)
        if (row[i].evidence) *(row[i].evidence->melts ? &melt : &others) = 1;
    return at < 0 || !melt || others ? none : named(&list[at], row, failing);
}

/* PACE_... of *best and of those that no row separates from it and no row that passes contradicts; 0: *best is none
 * of them. */
static unsigned paces(const struct hypothesis *list, int n, const struct hypothesis *best,
                      const struct diagnosis *row, int failing, headline_check *contradicts, const void *context) {
    unsigned all = fit_pace(best->fault.kind, best->unit);
    for (int i = 0; i < n && all; i++) {
        const unsigned pace = fit_pace(list[i].fault.kind, list[i].unit);
        if (!pace || all & pace || list[i].score < best->score - AS_WELL || list[i].votes < best->votes) continue;
        struct diagnosis d = named(&list[i], row, failing);
        if (!contradicts || !contradicts(&d, context)) all |= pace;
    }
    return all;
}

/* Whether it is the cause of at least half of the rows, nothing else has a part in them, and no other fault, but
 * `paces`, is nearly as good. */
static int is_firm(const struct hypothesis *list, int n, const struct hypothesis *best, unsigned paces, int known) {
    if (best->voted < FIT_SHARE) return 0;
    double apart = best->votes >= MOST_ROWS * known ? NOISE : 5 * NOISE;
    for (int i = 0; i < n; i++)
        if (list[i].fault.kind != best->fault.kind && list[i].score > best->score - apart &&
            !(paces & fit_pace(list[i].fault.kind, list[i].unit)))
            return 0;
    const int shown = best->fault.kind == FAULT_WHOLE_STEPS; /* by a run of its own */
    return (best->votes >= 3 || best->votes == known) && (best->votes >= 2 || shown) && 2 * best->votes >= known;
}

struct headline headline_choose(const struct diagnosis *found, int failing, headline_check *contradicts,
                                const void *context) {
    enum { MOST = 400, TRIES = 8 };
    struct headline h = {.failing = failing};
    struct hypothesis *list = xcalloc(MOST, sizeof *list);
    int known = 0, n = suggest(found, failing, list, MOST);
    for (int i = 0; i < failing; i++) known += found[i].named || found[i].evidence;
    for (int i = 0; i < n; i++) judge(&list[i], found, failing, known);
    double least = 0;
    for (int try = 0; try < TRIES && n > 0; try++) {
        int best = 0;
        for (int i = 1; i < n; i++)
            if (is_better(&list[i], &list[best])) best = i;
        if (list[best].score < least || !is_heard(&list[best], known, failing)) break;
        struct diagnosis d = named(&list[best], found, failing);
        int scope = contradicts ? contradicts(&d, context) : 0;
        if (scope == 0 || (scope == 2 && !h.fault.named)) {
            d.paces = paces(list, n, &list[best], found, failing, contradicts, context);
            wording_fault(&d);
            int is_sure = is_firm(list, n, &list[best], d.paces, known);
            h = (struct headline){d, list[best].score, list[best].votes, failing, is_sure, scope, {.named = 0}};
            if (!is_sure) h.rival = rival(list, n, best, found, failing);
            if (h.rival.named && contradicts && contradicts(&h.rival, context)) h.rival.named = 0;
        }
        if (scope == 0) break;
        if (scope == 2) least = h.share - NOISE; /* one that no row contradicts is better if it explains as much */
        list[best] = list[--n];
    }
    free(list);
    return h;
}

double headline_share(const struct headline *h, const struct diagnosis *row) {
    if (!h->fault.named) return NAN;
    struct hypothesis of = {.fault = h->fault.fault, .unit = h->fault.unit, .size = h->fault.size};
    if (*of.unit == '%') of.size /= 100;
    if (*of.unit == '\0') of.unit = "%", of.size = 1;
    if (of.fault.kind == FAULT_MEAN) of.fault.at = 0;
    int seen;
    const double share = row->named || row->evidence ? share_of(row, &of, &seen) : NAN;
    return isfinite(share) && !seen ? 0 : share;
}

void headline_print(const struct headline *h, const char *class, char text[HEADLINE_TEXT]) {
    *text = '\0';
    if (h->fault.named)
        snprintf(text, HEADLINE_TEXT, "%s%s%s%s%s%s (%d of %d rows that do not pass)", h->is_firm ? "" : "perhaps ",
                 h->scope ? class : "", h->scope ? ", " : "", h->fault.what, h->rival.named ? ", or " : "",
                 h->rival.named ? h->rival.what : "", h->votes, h->failing);
}

/* ---- Rows that pass ---- */

/* The size of *d at spacing dx, in the unit of its fault. */
static double size_at(const struct problem *p, const struct diagnosis *d, double dx, double dt) {
    double diffusive = dx * dx / problem_diffusivity(p);
    if (strcmp(d->unit, "cells") == 0) return d->size * dx;
    if (strcmp(d->unit, "%") == 0) return d->size / 100 * fault_whole(p, d->fault);
    if (strcmp(d->unit, "steps") == 0) return d->size * (dt > 0 ? dt : d->fourier * diffusive);
    if (strcmp(d->unit, FIT_DIFFUSIVE) == 0) return d->size * diffusive;
    return *d->unit ? d->size : 1;
}

double headline_effect(const struct problem *p, const struct diagnosis *d, double dx, double dt, double zero) {
    struct response_lattice l;
    struct response r;
    struct fault fault = d->fault;
    const unsigned is = fault_rows[fault.kind].is;
    double size = size_at(p, d, dx, dt), sum = 0, whole = 0;
    if (fault.kind == FAULT_MEAN) fault.at = 0;
    if (is & FAULT_RUNG || fault.kind == FAULT_SAMPLES || response_lattice_create(p, &l)) return NAN;
    int failed = response_take(p, &l, fault, is & (FAULT_BENDS | FAULT_CELL) ? size : 0, &r);
    if (!failed) {
        struct field f;
        field_alloc_lattice(&f, p->dim, l.n, NULL);
        for (int a = 0; a < p->dim; a++)
            for (int i = 0; i < l.n[a]; i++) f.x[a][i] = p->lo[a] + (i + 0.5) * l.dx;
        response_at(&r, &l, &f, l.T, f.T);
        for (size_t i = 0; i < f.n; i++) sum += fabs(size * f.T[i]), whole += fabs(l.T[i] - zero);
        field_free(&f);
        response_free(&r);
    }
    response_lattice_free(&l);
    return failed ? NAN : sum / whole;
}

int headline_contradicts(const struct diagnosis *fault, const struct problem *p, double dx, double dt, double zero,
                         double ceiling) {
    static const double SURE = 2; /* the rest of the error, up to a ceiling itself, may have the other sign */
    struct diagnosis d = *fault;
    int other_mean = d.fault.kind == FAULT_MEAN && (d.fault.at == FAULT_ANY || d.fault.at == MEAN_IS_OTHER);
    if (other_mean || (d.fault.at == FAULT_ANY && p->dim > 1)) return 0; /* it may differ from row to row */
    if (d.fault.at == FAULT_ANY) d.fault.at = 0;
    if (p->k_law && d.fault.kind == FAULT_CONDUCTIVITY) return 0; /* k there is from a law of its own */
    int of_sides = d.fault.kind == FAULT_EXTENT || d.fault.kind == FAULT_WALL;
    if (of_sides && (!d.sides || d.sides & ~fault_sides(p, d.fault))) return 0; /* walls of another kind */
    return headline_effect(p, &d, dx, dt, zero) > SURE * ceiling;
}
