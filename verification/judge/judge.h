/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_JUDGE_H
#define HEATLADDER_VERIFICATION_JUDGE_JUDGE_H

/* From the facts of a ladder to its verdict.  Verdict and reason are written here alone. */

#include "solver/status.h"
#include "verification/text/verdict.h"

#include <stddef.h>

struct slope;

struct judged {
    const double *x, *error; /* the included rungs; x is decreasing */
    int n;
    int scattered;             /* 1: errors scatter at random from rung to rung (window.h) */
    const struct slope *slope; /* fit to all draws, if `error` has their means; NULL: fit to `error` */
};

/* Difference between two equal runs at the rung before the finest, in the norm of the ladder. */
struct judge_noise {
    double apart;  /* K, maximum difference; 0 if they agree or it is unknown */
    double share;  /* the scatter of one run relative to the error of that rung */
    double finest; /* the scatter at the finest rung, in the unit of its error */
};

static const double JUDGE_NOISE = 0.1; /* a larger share shows no order */

struct judge_facts {
    struct judged rungs;     /* those that count */
    const double *x, *error; /* all rungs, coarsest first */
    int n, exact;            /* how many, and how many of them are at round-off */
    int finest_exact;        /* 1: the finest is one of these */
    double finest;           /* error at the finest rung that counts or is at round-off; NaN: none */
    const double *band;      /* LO, HI of the slope; NULL: none */
    double ceiling;          /* bound of `finest`; 0: none */
    int small_passes;        /* 1: an error far below its ceiling passes with any slope */
    struct failure failure;  /* the first rung that failed */

    /* Another program, with a ladder that did not pass: */
    int answers;              /* 1: the members below are known */
    struct judge_noise noise; /* between equal runs */
    double printed;           /* share of the printed digits in the finest error */
    int digits;               /* how many are printed */
    int named;                /* 1: a fault explains the errors */
};

struct judge_verdict {
    enum verdict verdict;
    char reason[360]; /* one line; for VERDICT_INCONCLUSIVE with the next step */
};

/* The verdict on a ladder.  In order: a failed rung; round-off; the slope against its band; the finest error against
 * its ceiling; then what excuses a ladder that did not pass. */
struct judge_verdict judge_ladder(const struct judge_facts *f);

/* The slope alone, against [lo, hi]. */
enum verdict judge_order(const struct judged *l, double lo, double hi, char *reason, size_t size);

/* The right order with the wrong size does not pass: appends to `reason` if the error is not below the ceiling. */
void judge_ceiling(double error, double ceiling, enum verdict *verdict, char *reason, size_t size);

/* The local slope of the two finest rungs; for scattered errors that of the finer half.  NaN for fewer than two
 * rungs. */
double judge_fine_slope(const struct judged *l);

/* The share of the finest error that does not decrease with x, from a fit of C x^p + floor with p in [lo, hi]. 0 if
 * there is none, if scatter explains it, or if the band contains an order of 0. */
double judge_floor(const struct judged *l, double lo, double hi);

#endif
