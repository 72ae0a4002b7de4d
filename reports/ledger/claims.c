/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Collecting, measuring and gating claims.
 *
 * A statement is *reproduced* where it holds as published and in the wider setting that the row also looks at;
 * *reproduced with a condition* where it holds as published alone, or under one of two readings that the paper leaves
 * open; *not explained* where a number of theirs comes out under no reading that was tried; else *contradicted*.
 * No verdict is written down anywhere but as the one expected, and one that differs from it is a failure. */
#include "reports/ledger/claims.h"

#include "reports/figure/reading.h"
#include "reports/ledger/claim.h"
#include "verification/text/progress.h"
#include "verification/text/shell.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const claims_verdict_words[] = {"not measured", "reproduced",    "reproduced with a condition",
                                            "contradicted", "not explained", NULL};

static void append(struct claims_measured *m, const char *before, const char *text) {
    size_t used = strlen(m->reason);
    snprintf(m->reason + used, sizeof m->reason - used, "%s%s", used ? before : "", text);
}

/* NaN fails, and so does a verdict without a number. */
static void check(struct claims_measured *m) {
    if (m->verdict == CLAIMS_UNMEASURED) return;
    int bad = m->count == 0;
    for (int i = 0; i < m->count; i++) bad |= !isfinite(m->number[i].value);
    if (!bad) return;
    m->verdict = CLAIMS_UNMEASURED;
    append(m, "; ", m->count ? "a number is not finite" : "nothing was measured");
}

void claims_judge(const struct claims_row *row, struct claims_measured *m) {
    *m = (struct claims_measured){.row = row};
    row->measure(m);
    check(m);
    if (*row->why) append(m, "; ", row->why);
    if (claims_holds(row, m)) return;
    append(m, "; ", "the verdict changed, expected: ");
    append(m, "", claims_verdict_words[row->expected]);
}

/* 1 if the value is in the reading's band; -1 with *m failed where the rungs of a ladder leave that open. */
static int is_held(const struct claims_reading *of, const struct reading *r, double value,
                   struct claims_measured *m) {
    double unit = of->of ? m->number[of->of - 1].value : 1;
    if (strcmp(of->key, "order") != 0) return of->lo <= value / unit && value / unit <= of->hi;
    char verdict[40], reason[400];
    reading_text(r, "verdict", verdict, sizeof verdict);
    reading_text(r, "reason", reason, sizeof reason);
    if (strcmp(verdict, "inconclusive") == 0 && claim_fail(m, reason)) return -1;
    return strcmp(verdict, "pass") == 0;
}

static int take(const struct claims_reading *of, struct reading *r, struct failure *why) {
    if (strcmp(of->key, "order") == 0)
        reading_set(r, "%s --expect %g,%g", of->command, of->lo, of->hi);
    else
        reading_set(r, "%s", of->command);
    return reading_run(r, 1, why);
}

void claims_read(struct claims_measured *m) {
    int held[3] = {1, 1, 1};
    struct failure why;
    for (const struct claims_reading *of = m->row->reading; of->command; of++) {
        struct reading r;
        int order = strcmp(of->key, "order") == 0, in = 0, failed = take(of, &r, &why);
        double value = failed ? NAN : reading_value(&r, order ? "slope" : of->key);
        if (!failed) in = of->part == CLAIMS_SHOWN ? 1 : is_held(of, &r, value, m);
        reading_free(&r, 1);
        if (failed ? claim_fail(m, why.text) : in < 0) return;
        claim_number(m, value, of->unit, "%s", of->name ? of->name : of->command + strcspn(of->command, " ") + 1);
        held[of->part] &= in;
    }
    claim_decide(m, held[CLAIMS_STATED], held[CLAIMS_WIDER], "%s", m->row->argument);
}

int claims_holds(const struct claims_row *row, const struct claims_measured *m) {
    return m->verdict != CLAIMS_UNMEASURED && m->verdict == row->expected;
}

int claims_collect(const struct claims_row *table, const char *only, struct claims *c, struct failure *why) {
    int rows = 0;
    while (table[rows].id) rows++;
    *c = (struct claims){.result = xcalloc((size_t)rows, sizeof *c->result)};
    for (int i = 0; i < rows; i++)
        if (!only || shell_match(only, table[i].id)) c->result[c->count++].row = &table[i];
    if (c->count) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "no claim matches '%.60s' (see: heatladder list claims)", only ? only : "*");
}

void claims_free(struct claims *c) {
    free(c->result);
    *c = (struct claims){0};
}

void claims_run(struct claims *c) {
    struct progress progress = progress_start("claims", c->count);
    /* From the end: the long ones, which fit a parameter by many runs, stand last in the table. */
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < c->count; i++) {
        struct claims_result *result = &c->result[c->count - 1 - i];
        double start = omp_get_wtime();
        claims_judge(result->row, &result->measured);
        result->seconds = omp_get_wtime() - start;
        progress_tick(&progress);
    }
    progress_end(&progress);
}

int claims_hold(const struct claims *c) {
    int held = 0;
    for (int i = 0; i < c->count; i++) held += claims_holds(c->result[i].row, &c->result[i].measured);
    return c->count > 0 && held == c->count;
}

void claims_published(const struct claims_result *r, char *text, size_t size) {
    const char *numbers = r->measured.published;
    snprintf(text, size, "%s%s%s", r->row->published, *numbers ? ": " : "", numbers);
}

void claims_numbers(const struct claims_measured *m, char *text, size_t size) {
    size_t used = 0;
    *text = '\0';
    for (int i = 0; i < m->count && used < size; i++) {
        const struct claims_number *n = &m->number[i];
        int length = snprintf(text + used, size - used, "%s%s %.4g%s%s", i ? "; " : "", n->name, n->value,
                              *n->unit ? " " : "", n->unit);
        used += length > 0 ? (size_t)length : 0;
    }
}
