/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_LEDGER_CLAIM_H
#define HEATLADDER_REPORTS_LEDGER_CLAIM_H

/* Tools of the ledger's measures: numbers, verdicts, runs by command line, model problems, the weights of one
 * particle. */

#include "solver/space/operator.h"
#include "verification/stability/step_limit.h"
#include "reports/ledger/claims.h"
#include "verification/judge/run.h"
#include "verification/judge/judge.h"
#include "verification/judge/slope.h"
#include "reports/figure/published.h"

/* Adds a number, its unit and its name (printf-like); past CLAIMS_NUMBERS it is dropped. */
void claim_number(struct claims_measured *m, double value, const char *unit, const char *name, ...)
    __attribute__((format(printf, 4, 5)));

/* Sets the verdict, given whether the statement holds as published and whether it holds beyond that; and the
 * rule. */
void claim_decide(struct claims_measured *m, int as_published, int beyond, const char *rule, ...)
    __attribute__((format(printf, 4, 5)));

/* Leaves *m unmeasured, with the reason; returns 1. */
int claim_fail(struct claims_measured *m, const char *text);

/* command_run_line; with *m not NULL, a failure is *m's.  command_run_free in any case. */
int claim_run(struct command_run *run, struct claims_measured *m, const char *command, ...)
    __attribute__((format(printf, 3, 4)));

/* As claim_run, but keeps only the measures, so that nothing must be freed. */
int claim_result(struct result *out, struct claims_measured *m, const char *command, ...)
    __attribute__((format(printf, 3, 4)));

/* reports/published/<name>.csv: 0, or 1 with *m failed. */
int claim_published(struct published *t, struct claims_measured *m, const char *name);

/* Adds a row of the table to the published numbers of the ledger. */
void claim_quote(struct claims_measured *m, const struct published *t, int row);

/* Judges the order of errors that decrease with x against [lo, hi] by the rule of the gates (judge.h).  *held: 1 if
 * it passes.  Returns 0, or 1 with *m failed if the rungs are inconclusive. */
int claim_judge(int *held, struct claims_measured *m, const struct judged *l, double lo, double hi);

/* The model problem of "limit ..." (model_problem.h), resolved, and its limits into *l where that is not NULL.  0, or
 * the status, with *m, where it is not NULL, failed. */
int claim_model(struct model_problem *b, struct step_limit *l, struct claims_measured *m, const char *command, ...)
    __attribute__((format(printf, 4, 5)));

/* One particle of a lattice, its neighbours within 2 h and the weights that a method gives them. */
struct claim_cell {
    struct neighbourhood nb;
    double d[NEIGHBOURS_MAX][DIM_MAX];
    double w[2][NEIGHBOURS_MAX];
};

/* Weights of the method at dx, h and kernel of a command line.  Returns 0, or 1 with *m failed. */
int claim_weights(struct claim_cell *cell, const double kappa[2], struct claims_measured *m, const char *command);

#endif
