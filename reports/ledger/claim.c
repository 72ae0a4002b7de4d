/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Components of the measures of claims. */
#include "reports/ledger/claim.h"

#include "verification/case/command.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void claim_number(struct claims_measured *m, double value, const char *unit, const char *name, ...) {
    va_list arguments;
    if (m->count == CLAIMS_NUMBERS) return;
    struct claims_number *n = &m->number[m->count++];
    va_start(arguments, name);
    vsnprintf(n->name, sizeof n->name, name, arguments);
    va_end(arguments);
    n->value = value;
    n->unit = unit;
}

void claim_decide(struct claims_measured *m, int as_published, int beyond, const char *rule, ...) {
    va_list arguments;
    m->verdict = !as_published ? CLAIMS_CONTRADICTED : beyond ? CLAIMS_REPRODUCED : CLAIMS_CONDITION;
    va_start(arguments, rule);
    vsnprintf(m->reason, sizeof m->reason, rule, arguments);
    va_end(arguments);
}

int claim_fail(struct claims_measured *m, const char *text) {
    m->verdict = CLAIMS_UNMEASURED;
    snprintf(m->reason, sizeof m->reason, "%s", text);
    return 1;
}

int claim_run(struct command_run *run, struct claims_measured *m, const char *command, ...) {
    va_list arguments;
    va_start(arguments, command);
    int status = command_run_list(run, command, arguments);
    va_end(arguments);
    if (status && m) claim_fail(m, run->result.failure.text);
    return status;
}

int claim_result(struct result *out, struct claims_measured *m, const char *command, ...) {
    struct command_run run;
    va_list arguments;
    va_start(arguments, command);
    int status = command_run_list(&run, command, arguments);
    va_end(arguments);
    if (status && m) claim_fail(m, run.result.failure.text);
    *out = run.result;
    command_run_free(&run);
    return status;
}

int claim_published(struct published *t, struct claims_measured *m, const char *name) {
    struct failure why;
    return published_read(t, name, &why) && claim_fail(m, why.text);
}

void claim_quote(struct claims_measured *m, const struct published *t, int row) {
    size_t used = strlen(m->published), size = sizeof m->published;
    for (int i = 0; i < t->columns && used < size; i++)
        used += (size_t)snprintf(m->published + used, size - used, "%s%s%s%s", !used || i ? "" : "; ",
                                 i ? ", " : t->method[row], i ? "" : " ", t->cell[row][i]);
}

int claim_judge(int *held, struct claims_measured *m, const struct judged *l, double lo, double hi) {
    char reason[240];
    enum verdict v = judge_order(l, lo, hi, reason, sizeof reason);
    *held = v == VERDICT_PASS;
    return v == VERDICT_INCONCLUSIVE && claim_fail(m, reason);
}

int claim_model(struct model_problem *b, struct step_limit *l, struct claims_measured *m, const char *command, ...) {
    char line[200];
    va_list arguments;
    struct failure why;
    struct command r;
    va_start(arguments, command);
    vsnprintf(line, sizeof line, command, arguments);
    va_end(arguments);
    int status = command_read(line, &r, &why);
    if (!status)
        status = step_limit_setup(r.experiment.method, &r.experiment.options, r.dim, r.ratio, r.field, r.contact,
                                  r.stages, b, &why);
    if (!status && l) status = step_limit_predict(b, l, &why);
    command_free(&r);
    if (status && m) claim_fail(m, why.text);
    return status;
}

int claim_weights(struct claim_cell *cell, const double kappa[2], struct claims_measured *m, const char *command) {
    struct command r;
    struct failure why;
    const struct problem *p = &r.experiment.problem;
    const struct options *o = &r.experiment.options;
    double *w[2] = {cell->w[0], cell->w[1]};
    int status = command_read(command, &r, &why);
    if (!status) status = operator_neighbourhood(p->dim, o->dx, o->h, cell->d, &cell->nb, &why);
    if (!status) {
        cell->nb.rho_c = p->material[0].rho_c;
        for (int a = 0; a < 2; a++) cell->nb.kappa[a] = kappa[a];
        status = operator_weights(r.experiment.method->scheme, p, o, &cell->nb, w, &why);
    }
    command_free(&r);
    return status && claim_fail(m, why.text);
}
