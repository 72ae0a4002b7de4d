/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_LADDER_H
#define HEATLADDER_VERIFICATION_JUDGE_LADDER_H

#include "verification/case/experiment.h"
#include "verification/judge/judge.h"
#include "verification/judge/run.h"
#include "verification/judge/slope.h"
#include "verification/text/verdict.h"
#include "verification/judge/window.h"
#include "verification/text/number.h"

/* Runs that differ in one length, and the order at which their errors decrease with it.
 *
 * A ladder in space has several --dx; its errors are relative to the exact solution.  A ladder in time has one --dx
 * and several --dt or --fourier; its errors are relative to the solution of the particles' semi-discrete equations
 * (time_step.h), so they contain no spatial error. */

struct ladder {
    struct ladder_rungs asked;
    int n;                /* number of rungs, coarsest first */
    int external;         /* 1: by an external program; failed and refused rungs are rows of the ladder */
    int in_time;          /* 1: x is dt, s; 0: x is dx, m, or the varied parameter */
    int inverse;          /* 1: x is the inverse of the varied parameter, which increases */
    char vary[40];        /* name of the varied parameter; "" for none */
    int self_differences; /* 1: errors come from differences of runs (self_difference.h) */
    double fine;          /* s: the step of the run that they are from; 0: of successive runs */
    struct result rung[RUNG_MAX];
    long long semidiscrete_steps; /* ladder in time: number of steps of the reference solution; 0: exact stepper */
    double semidiscrete_error;    /* error of the reference, see struct semidiscrete */
    double x[RUNG_MAX + 1];       /* the rungs, and --fine */
    enum norm norm;
    double error[RUNG_MAX];           /* in that norm; NaN if the run failed */
    int draws;                        /* draws per rung; the errors are their geometric means; 0 for one run */
    double draw[SEEDS_MAX][RUNG_MAX]; /* errors of each draw */
    double local[RUNG_MAX];           /* n - 1 slopes between adjacent rungs */
    struct window window;
    struct slope slope;     /* over the window */
    struct failure failure; /* that of the first rung that failed numerically */
    enum verdict verdict;
    char reason[360];
    double seconds;

    /* For a diagnosis: known for a ladder in space that did not pass, or on request. */
    int open;                 /* 1: known */
    struct field kept[2];     /* owned: at the finest rung and at the one before; n = 0 if a rung has none */
    struct judge_noise noise; /* a program: between equal runs */
    double printed;           /* a program: the share of the printed digits in the finest error */
    int digits;               /* how many are printed */
    int named;                /* 1: a fault explains the errors (ladder_explained) */
};

/* Runs the rungs, finest first, in parallel unless the caller is; then fits rungs->norm and judges by rungs->expect
 * and rungs->ceiling.  Returns STATUS_OK, STATUS_INPUT with *why if a rung is refused, or STATUS_NUMERICAL if one
 * failed; *l is set except after a refusal.  Release with ladder_free in any case. */
int ladder_run(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l, struct failure *why);

/* Frees what *l owns. */
void ladder_free(struct ladder *l);

/* The error in a norm; NaN if the run failed. */
double ladder_error_in(const struct result *r, enum norm norm);

/* Chooses the window and fits the slope in another norm. */
void ladder_fit(struct ladder *l, enum norm norm);

/* Copies the included rungs, coarsest first, to x and error of RUNG_MAX each; returns their number. */
int ladder_counted(const struct ladder *l, double *x, double *error);

/* Judges the ladder against another band. */
void ladder_judge(struct ladder *l, double lo, double hi);

/* Judges it once more, where a fault explains the errors: then they need not be smooth. */
void ladder_explained(struct ladder *l);

/* The error at the finest rung that is included or exact to round-off, in the fitted norm; NaN if there is none. */
double ladder_finest_error(const struct ladder *l);

/* The name of x, "dx [m]" for a ladder in space; and x of a rung as requested, 1/x for an increasing parameter. */
const char *ladder_axis(const struct ladder *l);
double ladder_asked(const struct ladder *l, int rung);

/* One row per rung; `timed`: with its seconds, which differ between runs.  The caller frees it. */
struct table ladder_table(const struct ladder *l, int timed);

/* One line with the slope, its interval and the number of rungs; for fewer than three rungs, the reason why there is
 * no interval. */
void ladder_slope_text(const struct ladder *l, char *text, size_t size);

/* A line with spacings that put each jump of the data and each interface on faces, if the rungs in use put one at
 * different places in a cell; else "".  p: the problem of the ladder. */
void ladder_places_text(const struct ladder *l, const struct problem *p, char *text, size_t size);

void ladder_json(const struct ladder *l, struct json *j); /* into an open object */

#endif
