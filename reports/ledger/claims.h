/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_LEDGER_CLAIMS_H
#define HEATLADDER_REPORTS_LEDGER_CLAIMS_H

/* The ledger: checkable statements of papers, measured.  A statement is a row of its paper's table (song.def,
 * pamplona.def, others.def; papers.h joins them).  Numbers give its verdict, which must equal the expected one.
 *
 * To add a row: READ(id, source, published, rule, expected, why, readings...) where commands give its numbers, one
 * reading a number (a command, the key of its JSON, a band); else CLAIM(..., measure, argument, expected, why) with a
 * function of your own beside the table (claim.h). */

#include <stdio.h>
#include <stddef.h>

struct failure;

enum claims_verdict {
    CLAIMS_UNMEASURED,
    CLAIMS_REPRODUCED,
    CLAIMS_CONDITION,
    CLAIMS_CONTRADICTED,
    CLAIMS_UNEXPLAINED
};
extern const char *const claims_verdict_words[]; /* in the order of the enum, ended by NULL */

enum { CLAIMS_NUMBERS = 16 };

struct claims_number {
    char name[72];
    const char *unit; /* "" for none */
    double value;
};

/* A number that a command gives, and the band that it is held against. */
enum claims_part { CLAIMS_SHOWN, CLAIMS_STATED, CLAIMS_WIDER }; /* no band; as published; in the wider setting */

struct claims_reading {
    enum claims_part part;
    int of;                    /* the band is in units of this reading of the row, counted from 1; 0: as it stands */
    const char *name, *unit;   /* name NULL: the command */
    const char *command, *key; /* figure/reading.h; "order": the slope, judged by the rule of the gates (judge.h) */
    double lo, hi;             /* the band, ends included */
};

struct claims_measured {
    const struct claims_row *row;
    enum claims_verdict verdict;
    int count; /* numbers */
    struct claims_number number[CLAIMS_NUMBERS];
    char published[320]; /* numbers of a published table; else "" */
    char reason[720];    /* the rule that leads from the numbers to the verdict; the remark of the row; whether the
                            verdict changed */
};

struct claims_row {
    const char *id;
    const char *source;    /* paper, and equation, table, figure or section */
    const char *published; /* the statement or the number */
    void (*measure)(struct claims_measured *m);
    const char *argument; /* for the measure; the rule where that is claims_read */
    enum claims_verdict expected;
    const char *why;                      /* explanation of the numbers */
    const struct claims_reading *reading; /* ended by a NULL command; NULL for none */
};

struct claims_result {
    const struct claims_row *row;
    struct claims_measured measured;
    double seconds;
};

struct claims {
    int count;
    struct claims_result *result; /* in the order of the table */
};

/* Collects the rows of `table`, which a NULL id ends, with an id that matches the glob `only` (NULL: all).
 * STATUS_OK, or STATUS_INPUT if none matches.  The caller calls claims_free. */
int claims_collect(const struct claims_row *table, const char *only, struct claims *c, struct failure *why);
void claims_free(struct claims *c);

/* Measures all of them, in parallel. */
void claims_run(struct claims *c);

/* Judges one row.  If it cannot be measured, or a result is not finite, it is CLAIMS_UNMEASURED with the reason. */
void claims_judge(const struct claims_row *row, struct claims_measured *m);

/* The measure of rows of readings: as published where all of CLAIMS_STATED are in their bands, without a condition
 * where all of CLAIMS_WIDER are too. */
void claims_read(struct claims_measured *m);

/* 1 where the verdict is the one that the row expects. */
int claims_holds(const struct claims_row *row, const struct claims_measured *m);
/* 1 where that is so for every row, and there is one. */
int claims_hold(const struct claims *c);

/* The published statement: the row's text, and the numbers of its table. */
void claims_published(const struct claims_result *r, char *text, size_t size);

/* "name 1.234 unit; name ..." cut to size. */
void claims_numbers(const struct claims_measured *m, char *text, size_t size);

/* The ledger as text, a paragraph a claim, and as JSON. */
void claims_write_text(const struct claims *c, FILE *out);
void claims_write_json(const struct claims *c, FILE *out);
/* As text the claims with an unexpected verdict, and the count of all. */
void claims_write_changed(const struct claims *c, FILE *out);

/* claims.md and claims.html into `dir`: equal verdicts give equal files. */
int claims_write_files(const struct claims *c, const char *dir, struct failure *why);

#endif
