/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_RUN_H
#define HEATLADDER_VERIFICATION_JUDGE_RUN_H

#include "solver/method.h"
#include "verification/case/command.h"
#include "verification/judge/norms.h"

#include <stdarg.h>

/* The result of one run: options as resolved, norms, counts and times. */

struct json;

struct result {
    const struct scene *scene;
    const struct method *method;
    struct options options; /* as used, with stepper and h resolved */
    struct failure failure; /* STATUS_OK if there is a solution; otherwise only the options above are set */
    double t_end;           /* s */
    double dt;              /* s; 0 for the exact stepper */
    double fourier;         /* dt max(kappa) / dx^2 */
    long long steps;
    int stages;    /* operator applications per step */
    double saving; /* updates of the fewest stable Euler steps over those of a stepper with stages; NaN: unknown */
    size_t particles;
    double error[NORM_QUANTITY + 1]; /* in each norm; of the quantity |difference| over |exact|, or |difference| if
                                        that is 0.  A point is near a wall within a tenth of the extent. */
    size_t left_out;                 /* points without an exact value */
    struct norms_shape shape;
    double heat_drift;
    const char *derived_name;      /* the quantity of struct experiment; NULL for none */
    double derived, derived_exact; /* numerical and exact */
    double derived_bound;          /* possible share of the exact value's own error */
    double derived_rounding;       /* possible share of rounding */
    double growth;                 /* s^-1: of the fastest growing mode, 0 if none grows, NaN if not determined */
    double time_error;             /* share of the time step in error[NORM_L1]; 0 for exact, NaN if unknown */
    double reference_error;        /* possible share of the reference's own error in error[NORM_L1] */
    double rounding;               /* possible share of rounding in error[NORM_L1] */
    struct cost cost;
    long long search_updates; /* updates of the other runs in the search for the time step */
};

/* 1 if the method accepts the option. */
int result_accepts(const struct result *r, const char *option);

/* 1 if a mode grows by more than a factor of 2 in the run. */
int result_grows(const struct result *r);

/* Warns on standard error if a mode grows. */
void result_warn(const struct result *r);

/* Writes the members of the `run --json` contract into an open object. */
void result_json(const struct result *r, struct json *j);

/* One line: what was run, and how; truncated to size. */
void result_describe(const struct result *r, char *text, size_t size);

/* ---- Runs ---- */

struct time_step; /* verification/judge/time_step.h */

/* The result of an experiment that has not run: its options, no failure, time_error NaN. */
struct result run_blank(const struct experiment *e);

/* Runs the experiment and measures it. *out is always set; its failure has the reason, and its status is returned.
 * If `field` is not NULL, the caller owns *field after STATUS_OK. */
int run_experiment(const struct experiment *e, struct result *out, struct field *field);

/* Solves by e->program, which chooses its own time step.  Its reported number of steps counts for
 * rounding up to the square of time_step_weights, more than an explicit scheme needs.  It rounds temperatures of the
 * case: an offset (mapping.h) raises the rounding in terms of E1. */
int run_program(struct experiment *e, struct field *f, struct time_step *step, struct failure *why);

/* The same, with the error relative to `reference` (on the same points) instead of the exact solution; its own
 * relative error is `error`, in terms of E1. */
int run_against(const struct experiment *e, const double *reference, double error, struct result *out);

/* Solves repeatedly for 0.1 s, to warm up program, memory and processor. */
int run_warm_up(const struct experiment *e, struct failure *why);

/* ---- Commands ---- */

/* A command line, run and kept, for claims and reports: each of their numbers has a command that repeats it. */

struct command_run {
    char command[400]; /* as a user would type it after the program's name */
    struct command typed;
    struct result result; /* its failure: of the command line or of the run */
    struct field field;
};

/* Reads a command line (printf-like) and, where its verb is `run`, runs it.  The status, which is also that of
 * run->result.failure; command_run_free in any case.  Safe from any thread. */
int command_run_line(struct command_run *run, const char *format, ...) __attribute__((format(printf, 2, 3)));
int command_run_list(struct command_run *run, const char *format, va_list arguments)
    __attribute__((format(printf, 2, 0)));

/* The two halves of that: between them numbers can be set in run->typed.experiment that no user would type. */
int command_run_read(struct command_run *run, const char *format, ...) __attribute__((format(printf, 2, 3)));
int command_run_solve(struct command_run *run);

/* The failure, if any, with the command that it is of. */
int command_run_check(const struct command_run *run, struct failure *why);

/* Keeps the failure of a run of a parallel loop in *any, whose status was STATUS_OK; the run's status. */
int command_run_note(const struct command_run *run, struct failure *any);

/* E1 (Song eq. 46) against the solution as the source prints it, or the exact one where the two are one, taken `late`
 * seconds after the end of the run and rounded to so many decimals, 0 for none. */
double command_run_error(const struct command_run *run, int decimals, double late);

/* The exact solution of the command's scene at x and time t (s), K. */
double command_run_exact(const struct command_run *run, const double x[2], double t);

void command_run_free(struct command_run *run);

#endif
