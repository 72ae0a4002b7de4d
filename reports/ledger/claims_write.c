/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ledger for people and for programs. */
#include "reports/ledger/claims.h"

#include "reports/figure/document.h"
#include "solver/status.h"
#include "verification/text/json.h"
#include "verification/text/verdict.h"

#include <string.h>

enum { NUMBERS = 1400, PUBLISHED = 600 }; /* characters for all numbers of a claim, and for its published numbers */

static const char *verdict_of(const struct claims_result *r) {
    return claims_verdict_words[r->measured.verdict];
}

static void count(const struct claims *c, int counts[5], int *changed) {
    *changed = 0;
    for (int i = 0; i < 5; i++) counts[i] = 0;
    for (int i = 0; i < c->count; i++) {
        counts[c->result[i].measured.verdict]++;
        *changed += !claims_holds(c->result[i].row, &c->result[i].measured);
    }
}

static void put_claim(const struct claims_result *r, FILE *out) {
    char numbers[NUMBERS], published[PUBLISHED];
    const char *mark = claims_holds(r->row, &r->measured) ? "pass" : "fail";
    claims_numbers(&r->measured, numbers, sizeof numbers);
    fprintf(out, "%s%s%s: %s\n", verdict_colour(out, mark), r->row->id, verdict_colour_end(out, mark), verdict_of(r));
    claims_published(r, published, sizeof published);
    fprintf(out, "  published  %s (%s)\n  measured   %s\n  because    %s\n\n", published, r->row->source, numbers,
            r->measured.reason);
}

static void put_counts(const struct claims *c, FILE *out) {
    int counts[5], changed;
    count(c, counts, &changed);
    fprintf(out,
            "%d statement%s of the papers: %d reproduced, %d with a condition, %d contradicted, %d not explained",
            c->count, c->count == 1 ? "" : "s", counts[CLAIMS_REPRODUCED], counts[CLAIMS_CONDITION],
            counts[CLAIMS_CONTRADICTED], counts[CLAIMS_UNEXPLAINED]);
    if (counts[CLAIMS_UNMEASURED]) fprintf(out, ", %d not measured", counts[CLAIMS_UNMEASURED]);
    if (changed)
        fprintf(out, "; %d verdict%s not as expected\n", changed, changed == 1 ? " is" : "s are");
    else
        fprintf(out, "; every verdict as expected\n");
}

void claims_write_text(const struct claims *c, FILE *out) {
    for (int i = 0; i < c->count; i++) put_claim(&c->result[i], out);
    put_counts(c, out);
}

void claims_write_changed(const struct claims *c, FILE *out) {
    for (int i = 0; i < c->count; i++)
        if (!claims_holds(c->result[i].row, &c->result[i].measured)) put_claim(&c->result[i], out);
    put_counts(c, out);
}

static void claim_json(const struct claims_result *r, struct json *j) {
    const struct claims_measured *m = &r->measured;
    char numbers[NUMBERS], published[PUBLISHED];
    claims_numbers(m, numbers, sizeof numbers);
    claims_published(r, published, sizeof published);
    json_object(j, NULL);
    json_text(j, "id", r->row->id);
    json_text(j, "source", r->row->source);
    json_text(j, "published", published);
    json_text(j, "measured", numbers);
    json_array(j, "numbers");
    for (int i = 0; i < m->count; i++) {
        json_object(j, NULL);
        json_text(j, "name", m->number[i].name);
        json_number(j, "value", m->number[i].value);
        json_text(j, "unit", m->number[i].unit);
        json_end(j);
    }
    json_end(j);
    json_text(j, "verdict", verdict_of(r));
    json_text(j, "expected", claims_verdict_words[r->row->expected]);
    json_text(j, "reason", m->reason);
    json_number(j, "seconds", r->seconds);
    json_end(j);
}

void claims_write_json(const struct claims *c, FILE *out) {
    struct json j = json_on(out);
    json_array(&j, "claims");
    for (int i = 0; i < c->count; i++) claim_json(&c->result[i], &j);
    json_end(&j);
    json_end(&j);
}

static void put_table(const struct claims *c, const char *title, const char *paper, struct document *d) {
    char numbers[NUMBERS], published[PUBLISHED];
    struct table t = table_headed(6, "claim|source|published|measured|verdict|why");
    for (int i = 0; i < c->count; i++) {
        const struct claims_result *r = &c->result[i];
        if (strncmp(r->row->id, paper, strlen(paper)) != 0) continue;
        claims_numbers(&r->measured, numbers, sizeof numbers);
        claims_published(r, published, sizeof published);
        const char *const cell[] = {r->row->id, r->row->source, published,
                                    numbers,    verdict_of(r),  r->measured.reason};
        for (int k = 0; k < 6; k++) table_add(&t, "%s", cell[k]);
    }
    document_heading(d, "%s", title);
    document_table(d, &t);
}

int claims_write_files(const struct claims *c, const char *dir, struct failure *why) {
    int counts[5], changed;
    struct document d;
    count(c, counts, &changed);
    document_open(&d, dir, "claims", "What the papers claim, measured");
    document_command(&d, "report claims DIR");
    document_text(
        &d, "A statement is reproduced where it holds as published and in the wider setting that is also looked "
            "at; reproduced with a condition where it holds as published alone or under one reading alone; not "
            "explained where a number of theirs comes out under no reading that was tried; else contradicted. "
            "Numbers decide, by the rule that stands first under why.");
    document_text(&d, "%d statements: %d reproduced, %d with a condition, %d contradicted, %d not explained.",
                  c->count, counts[CLAIMS_REPRODUCED], counts[CLAIMS_CONDITION], counts[CLAIMS_CONTRADICTED],
                  counts[CLAIMS_UNEXPLAINED]);
    if (changed) document_text(&d, "%d verdicts differ from those expected.", changed);
    put_table(c, "Song, Xing, Hou, Lu 2018", "song/", &d);
    put_table(c, "Pamplona, Silva, Bucar, Vasco 2019", "pamplona/", &d);
    put_table(c, "Other papers", "others/", &d);
    return document_close(&d, why);
}
