/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_LADDER_LADDER_H
#define HEATLADDER_VERIFICATION_LADDER_LADDER_H

#include "verification/diagnosis/diagnosis.h"
#include "verification/run/experiment.h"
#include "verification/run/result.h"
#include "verification/ladder/slope.h"
#include "verification/text/verdict.h"
#include "verification/ladder/window.h"
#include "verification/text/number.h"

/* Runs that differ in one length, and the order at which their errors fall with it.
 *
 * A ladder in space has several --dx; its errors are against the exact solution.  A ladder in time has one --dx and
 * several --dt or --fourier; its errors are against the solution of the same particles' equations without time error
 * (semidiscrete.h), so that no error of space is in them. */

enum ladder_norm {
#define NORM(NAME, word, title, of) LADDER_##NAME,
#include "verification/ladder/norms.def"
#undef NORM
    LADDER_QUANTITY /* the error of --quantity; has no word */
};
extern const char *const ladder_norm_words[];  /* in the order of the enum, ended by NULL */
extern const char *const ladder_norm_titles[]; /* for a reader, in the same order, LADDER_QUANTITY too */

/* The rungs that are asked for: one list has several numbers. */
struct ladder_rungs {
    struct numbers dx;      /* m */
    struct numbers dt;      /* s */
    struct numbers fourier; /* - */
    struct numbers vary;    /* of a parameter of the program, experiment.program.vary */
    struct numbers expect;  /* lowest and highest slope that pass; none where nothing is to be judged */
    double ceiling;         /* of the error at the finest rung that counts; 0: none */
    enum ladder_norm norm;  /* what is fitted and judged */
    int diagnose;           /* 1: also where the ladder passes or nothing is judged */
    int scattered;          /* 1: the points may lie anywhere, so that errors may scatter (judge.h) */
};

struct ladder {
    int n;                /* rungs, coarsest first */
    int external;         /* 1: by another program; failed and refused rungs are rows of the ladder */
    int in_time;          /* 1: x is dt, s; 0: x is dx, m, or what the program varies in */
    int inverse;          /* 1: x is 1 over what the program varies in, which rises */
    char vary[40];        /* its name; "" for none */
    int self_differences; /* 1: errors come from differences of runs (self_difference.h) */
    struct result rung[RUNG_MAX];
    long long semidiscrete_steps; /* in time: of the polynomials that errors are against; 0: of the exact stepper */
    double semidiscrete_error;    /* its own error, as in struct semidiscrete */
    double x[RUNG_MAX];
    enum ladder_norm norm;
    double error[RUNG_MAX];           /* in that norm; NaN where the run failed */
    int draws;                        /* of each rung: its errors are their geometric means; 0 for one */
    double draw[SEEDS_MAX][RUNG_MAX]; /* the errors of each */
    double local[RUNG_MAX];           /* n - 1 slopes between neighbours */
    struct window window;
    struct slope slope;     /* over the window */
    struct failure failure; /* of the first rung that failed numerically */
    enum verdict verdict;
    char reason[360];
    int diagnosed; /* 1: a ladder in space did not pass, or it was asked: `diagnosis` says what its errors look like
                    */
    struct diagnosis diagnosis;
    int noisy; /* 1: a program's answers differ from run to run by more than a tenth of their error */
    double seconds;
};

/* Runs the rungs, in parallel where the caller is not, the finest first; then fits rungs->norm and judges by
 * rungs->expect and rungs->ceiling. STATUS_OK, STATUS_INPUT with *why filled where a rung is refused, or
 * STATUS_NUMERICAL where one failed: *l is filled but for a refusal. */
int ladder_run(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l, struct failure *why);

/* Its error in a norm; NaN where the run failed. */
double ladder_error_in(const struct result *r, enum ladder_norm norm);

/* Chooses the window and fits the slope in another norm. */
void ladder_fit(struct ladder *l, enum ladder_norm norm);

/* The rungs that count, coarsest first, into x and error of RUNG_MAX each; how many. */
int ladder_counted(const struct ladder *l, double *x, double *error);

/* Sets verdict and reason against a band. */
void ladder_judge(struct ladder *l, double lo, double hi);

/* The error at the finest rung that counts or is exact to rounding, in the norm that was fitted; NaN where none is.
 */
double ladder_finest_error(const struct ladder *l);

/* What x is, "dx [m]" of a ladder in space, and x of a rung as it was asked for: where what a program varies in
 * rises, 1/x. */
const char *ladder_axis(const struct ladder *l);
double ladder_asked(const struct ladder *l, int rung);

/* A row a rung; `timed`: with its seconds, which are others in each run.  The caller ends it. */
struct table ladder_table(const struct ladder *l, int timed);

/* The slope, its interval and of how many rungs, in a line; of fewer than three rungs, why there is no interval. */
void ladder_slope_text(const struct ladder *l, char *text, size_t size);

void ladder_json(const struct ladder *l, struct json *j); /* into an object that is open */

#endif
