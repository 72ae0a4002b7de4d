/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The measures of gates. */
#include "verification/gates/measures.h"

#include "references/quantity.h"
#include "references/scene.h"
#include "solver/field.h"
#include "solver/shape.h"
#include "solver/words.h"
#include "verification/case/command.h"
#include "verification/fault/diagnose.h"
#include "verification/fault/wording.h"
#include "verification/judge/judge.h"
#include "verification/judge/ladder.h"
#include "verification/judge/norms.h"
#include "verification/judge/run.h"
#include "verification/judge/self_difference.h"
#include "verification/solve/program.h"
#include "verification/solve/symmetry.h"
#include "verification/stability/consistency.h"
#include "verification/stability/step_limit.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void measures_fail(struct measured *m, const struct failure *why) {
    *m = (struct measured){.value = NAN, .ci = {NAN, NAN}, .error = NAN};
    m->verdict = why->status == STATUS_SKIPPED ? VERDICT_SKIPPED : VERDICT_FAIL;
    if (why->status == STATUS_UNSTABLE) diagnosis_overflow(&m->found);
    if (why->exchanged) diagnosis_exchanged(why->exchanged - 1, &m->found);
    snprintf(m->reason, sizeof m->reason, "%.390s", why->text);
}

static void put_quantity(const struct experiment *e, char *text, size_t size) {
    const enum quantity_kind kind = e->quantity.kind;
    if (!e->derived)
        words_add(text, size, "the quantity");
    else if (kind == QUANTITY_AT)
        words_add(text, size, "T at %s", e->derived + strlen("at:"));
    else
        words_add(text, size, "%s%s", kind == QUANTITY_FLUX ? "" : "the ", e->derived);
}

/* The sentence of a measure (measures.def) with its value. */
static void say(const struct experiment *e, const char *says, double value, char *text, size_t size) {
    *text = '\0';
    while (*says) {
        const int plain = (int)strcspn(says, "{");
        words_add(text, size, "%.*s", plain, says);
        says += plain;
        if (!*says) break;
        if (says[1] == 'v')
            words_add(text, size, "%.4g", value);
        else if (says[1] == 'u')
            words_add(text, size, "%s", quantity_unit(&e->quantity, &e->problem));
        else
            put_quantity(e, text, size);
        says = strchr(says, '}') + 1;
    }
}

/* The verdict on lo <= value <= hi. */
static void judge_value(const struct command *r, const char *name, double value, double lo, double hi,
                        struct measured *m) {
    struct measured ignored;
    char said[200];
    say(&r->experiment, measures_find(name, &ignored)->says, value, said, sizeof said);
    m->value = m->ci[0] = m->ci[1] = value;
    m->verdict = verdict_within(value, lo, hi);
    int pass = m->verdict == VERDICT_PASS;
    if (!isfinite(value))
        snprintf(m->reason, sizeof m->reason, "%s, not finite; expected %.4g to %.4g", said, lo, hi);
    else if (lo == 0 && value >= 0)
        snprintf(m->reason, sizeof m->reason, "%s, %s %.4g", said, pass ? "at most" : "above the ceiling", hi);
    else
        snprintf(m->reason, sizeof m->reason, "%s, %s [%g, %g]", said, pass ? "inside" : "outside", lo, hi);
}

static void keep_rungs(const struct ladder *l, struct rungs *to) {
    to->n = l->n;
    to->norm = norm_titles[l->norm];
    snprintf(to->axis, sizeof to->axis, "%s%s", l->inverse ? "1 / " : "", ladder_axis(l));
    memcpy(to->x, l->x, sizeof to->x);
    memcpy(to->error, l->error, sizeof to->error);
    memcpy(to->counts, l->window.counts, sizeof to->counts);
}

void measures_diagnosed(struct measured *m, const struct diagnosis *d) {
    free(m->found.evidence);
    m->found = *d;
    if (d->named) wording_text(d, m->diagnosis, sizeof m->diagnosis);
}

static double step_of(const struct experiment *e, const struct result *r) {
    return r->dt > 0 || !(r->steps > 0) ? r->dt : e->problem.t_end / (double)r->steps;
}

int measures_ladder(const struct command *r, double lo, double hi, struct ladder *l, struct measured *m) {
    struct failure why = {0};
    struct diagnosis d;
    struct ladder_rungs rungs = r->rungs;
    rungs.expect = (struct numbers){.count = 2, .value = {lo, hi}};
    int status = ladder_run(&r->experiment, &rungs, l, &why);
    measures_fail(m, &why);
    if (status) return status;
    diagnose_ladder(&r->experiment, l, &d);
    *m = (struct measured){.value = l->slope.value,
                           .ci = {l->slope.ci[0], l->slope.ci[1]},
                           .error = ladder_finest_error(l),
                           .dt = step_of(&r->experiment, &l->rung[l->n - 1]),
                           .verdict = l->verdict};
    snprintf(m->reason, sizeof m->reason, "%s", l->reason);
    measures_diagnosed(m, &d);
    return STATUS_OK;
}

/* For a picture of a row that does not hold: takes the field over.  Returns 1, with m->due to be filled, or 0 where
 * there is nothing to draw. */
static int keep_answer(struct field *f, const char *due_is, struct measured *m) {
    if (m->verdict == VERDICT_PASS || f->n == 0) return 0;
    m->field = *f;
    *f = (struct field){0};
    m->due = xcalloc(m->field.n, sizeof *m->due);
    snprintf(m->due_is, sizeof m->due_is, "%s", due_is);
    return 1;
}

static void keep_field(const struct experiment *e, struct field *f, struct measured *m) {
    if (keep_answer(f, "exact", m)) norms_exact(e->scene, &e->problem, &m->field, m->due);
}

void measures_free(struct measured *m) {
    field_free(&m->field);
    free(m->due);
    free(m->found.evidence);
    m->due = NULL, m->found.evidence = NULL;
}

void measures_slope(const struct command *r, double lo, double hi, struct measured *m) {
    struct ladder *l = xcalloc(1, sizeof *l);
    if (!measures_ladder(r, lo, hi, l, m)) {
        keep_rungs(l, &m->rungs);
        keep_field(&r->experiment, &l->kept[0], m);
    }
    ladder_free(l);
    free(l);
}

/* --shift 0, 0.1, ... 0.9, each a ladder. */
void measures_slope_offsets(const struct command *r, double lo, double hi, struct measured *m) {
    enum { OFFSETS = 10 };
    struct command with = *r;
    for (int s = 0; s < OFFSETS; s++) {
        struct measured one = {0};
        with.experiment.options.shift = (double)s / OFFSETS;
        measures_slope(&with, lo, hi, &one);
        measures_free(&one);
        if (s == 0 || one.verdict != VERDICT_PASS || one.error > m->error) *m = one;
        if (m->verdict == VERDICT_PASS) continue;
        snprintf(m->reason, sizeof m->reason, "offset %g dx: %.370s", with.experiment.options.shift, one.reason);
        return;
    }
}

void measures_order(const struct command *r, double lo, double hi, struct measured *m) {
    struct command with = *r;
    with.rungs.scattered = with.rungs.small_passes = 1;
    measures_slope(&with, lo, hi, m);
}

/* Rows of the battery are converted to runs, which have no choice of norm; this measure gives them one. */
void measures_order_linf(const struct command *r, double lo, double hi, struct measured *m) {
    struct command with = *r;
    with.rungs.norm = NORM_LINF;
    measures_order(&with, lo, hi, m);
}

void measures_operator_slope(const struct command *r, double lo, double hi, struct measured *m) {
    struct numbers dx = r->rungs.dx;
    struct experiment e = r->experiment;
    struct failure why = {0};
    double error[RUNG_MAX];
    number_sort_falling(dx.value, dx.count);
    for (int i = 0; i < dx.count; i++) {
        e.options.dx = dx.value[i];
        int status = consistency_error(&e, &error[i], &why);
        measures_fail(m, &why);
        if (status) return;
    }
    struct slope s = slope_fit(dx.value, error, dx.count);
    m->value = s.value;
    m->ci[0] = s.ci[0];
    m->ci[1] = s.ci[1];
    m->error = error[dx.count - 1];
    struct judged judged = {dx.value, error, dx.count, 0, NULL};
    m->verdict = judge_order(&judged, lo, hi, m->reason, sizeof m->reason);
}

int measures_run(const struct experiment *e, struct result *r, struct field *f, struct measured *m) {
    int status = run_experiment(e, r, f);
    measures_fail(m, &r->failure);
    if (!status) m->error = r->error[NORM_L1], m->dt = step_of(e, r);
    return status;
}

static void judge_run(const struct command *r, const char *name, struct field *f, double value, double lo, double hi,
                      struct measured *m) {
    judge_value(r, name, value, lo, hi, m);
    keep_field(&r->experiment, f, m);
    field_free(f);
}

/* A number of one run. */
#define OF_RUN(name, value)                                                                                          \
    void measures_##name(const struct command *r, double lo, double hi, struct measured *m) {                        \
        struct result of;                                                                                            \
        struct field f = {0};                                                                                        \
        if (!measures_run(&r->experiment, &of, &f, m)) judge_run(r, #name, &f, value, lo, hi, m);                    \
    }
OF_RUN(error_linf, of.error[NORM_LINF])
OF_RUN(overshoot, fmax(of.shape.overshoot, of.shape.undershoot))
OF_RUN(heat_drift, of.heat_drift)
OF_RUN(quantity, of.derived_name ? of.derived : NAN)
OF_RUN(quantity_error, of.derived_name ? of.error[NORM_QUANTITY] : NAN)
OF_RUN(checkerboard, of.shape.checkerboard)
#undef OF_RUN

/* The rate of the mode is that of the sum of T - T_wall times its initial data. */
void measures_leak(const struct command *r, double lo, double hi, struct measured *m) {
    const struct problem *p = &r->experiment.problem;
    struct result of;
    struct field f = {0};
    double before = 0, after = 0, rate = 0;
    if (measures_run(&r->experiment, &of, &f, m)) return;
    for (size_t i = 0; i < f.n; i++) {
        double x[DIM_MAX], start = p->initial(p, field_place(&f, i, x)) - p->held[0];
        before += start * start, after += start * (f.T[i] - p->held[0]);
    }
    for (int a = 0; a < p->dim; a++) rate += pow(M_PI / (p->hi[a] - p->lo[a]), 2) / p->material[0].rho_c;
    field_free(&f);
    judge_value(r, "leak", (log(before / after) / p->t_end / rate - p->k_perp) / p->k_par, lo, hi, m);
}

void measures_checkerboard_kept(const struct command *r, double lo, double hi, struct measured *m) {
    struct experiment early = r->experiment;
    struct result first, last;
    early.problem.t_end /= 10;
    if (measures_run(&early, &first, NULL, m) || measures_run(&r->experiment, &last, NULL, m)) return;
    judge_value(r, "checkerboard_kept", last.shape.checkerboard / first.shape.checkerboard, lo, hi, m);
}

/* `error` is the largest difference of the two fields, K. */
void measures_symmetry(const struct command *r, double lo, double hi, struct measured *m) {
    const struct experiment *e = &r->experiment;
    struct options whole = e->options;
    struct field a = {0}, b = {0};
    struct failure why = {0};
    whole.domain = DOMAIN_WHOLE;
    int status = symmetry_solve(e->method, &e->problem, &e->options, &a, &why);
    if (!status) status = symmetry_solve(e->method, &e->problem, &whole, &b, &why);
    measures_fail(m, &why);
    if (!status) {
        judge_value(r, "symmetry", (double)b.cost.updates / (double)a.cost.updates, lo, hi, m);
        m->error = a.n == b.n ? field_farthest(&a, b.T) : NAN;
    }
    field_free(&a);
    field_free(&b);
}

/* Points that fill the domain evenly and have no symmetry of it: the additive sequences of the plastic number. */
static void odd_point(const struct problem *p, int i, double x[DIM_MAX]) {
    static const double step[DIM_MAX] = {0.7548776662466927, 0.5698402909980532, 0.3247179572447460};
    do {
        for (int a = 0; a < DIM_MAX; a++) {
            double u = 0.137 + 0.174 * a + step[a] * i;
            x[a] = p->lo[a] + (p->hi[a] - p->lo[a]) * (u - floor(u));
        }
        i += 1000;
    } while (p->shape && shape_depth(p, x) < 0);
}

/* The difference of the two forms of a reference, in units of their error bounds.  The ceiling limits the bound at
 * the end time, where runs are judged, relative to the largest temperature: a reference cannot pass with a loose
 * bound. */
void measures_reference(const struct command *r, double lo, double hi, struct measured *m) {
    enum { POINTS = 32, TIMES = 4 };
    static const double part[TIMES] = {0.0113, 0.173, 0.619, 1};
    const struct problem *p = &r->experiment.problem;
    double worst = 0, where[DIM_MAX] = {0}, when = 0, bound = 0, size = 0;
    for (int i = 0; i < POINTS * TIMES && !isnan(worst); i++) {
        double x[DIM_MAX], t = p->t_end * part[i % TIMES];
        odd_point(p, i / TIMES, x);
        struct exact a = scene_exact(r->experiment.scene, p, x, t), b = r->experiment.scene->second(p, x, t);
        double apart = fabs(a.temperature - b.temperature);
        double allowed = a.error_bound + b.error_bound;
        double ratio = !(allowed >= 0 && allowed < INFINITY) ? NAN : apart == 0 ? 0 : apart / allowed;
        if (t == p->t_end) bound = fmax(bound, a.error_bound);
        size = fmax(size, fabs(a.temperature));
        if (ratio <= worst) continue;
        worst = ratio;
        memcpy(where, x, sizeof where), when = t;
    }
    measures_fail(m, &(struct failure){0});
    judge_value(r, "reference", worst, lo, hi, m);
    m->error = bound / size;
    if (m->verdict == VERDICT_PASS) return;
    snprintf(m->reason, sizeof m->reason, "the two forms are %.3g of their bounds apart at %g, %g, %g m, %g s", worst,
             where[0], where[1], where[2], when);
}

#define MEASURE(name, ceiling, about, says) {#name, about, says, ceiling, measures_##name},
const struct measure measures[] = {
#include "verification/gates/measures.def"
    {0}};
#undef MEASURE

const struct measure *measures_find(const char *name, struct measured *m) {
    const char *names[WORDS_MAX] = {0};
    struct failure why = {0};
    for (int i = 0; measures[i].name && i < WORDS_MAX - 1; i++) names[i] = measures[i].name;
    int i = words_index(names, name);
    if (i >= 0) return &measures[i];
    words_unknown(names, "measure", name, &why);
    measures_fail(m, &why);
    return NULL;
}

/* ---- Another program ---- */

static void skip(struct measured *m, const char *text) {
    struct failure why;
    refuse(&why, STATUS_SKIPPED, "%s", text);
    measures_fail(m, &why);
}

/* Runs the same case twice, into two fields that the caller frees.  Returns 1 if the answers can be compared, with
 * their relative difference.  The second run is not kept, so that it cannot read the answer of the first. */
static int run_twice(const struct experiment *e, struct result *first, struct field f[2], double apart[NORM_QUANTITY],
                     struct measured *m) {
    struct experiment again = *e;
    struct result second;
    int comparable = 0;
    again.program.keep = NULL;
    if (!e->program.solver) {
        skip(m, "needs --solver: --results has one run");
    } else if (!measures_run(e, first, &f[0], m) && !measures_run(&again, &second, &f[1], m)) {
        comparable = self_difference_fields(&e->problem, &f[0], &f[1], apart);
        if (!comparable) skip(m, "the points differ from run to run");
    }
    return comparable;
}

/* If answers differ from run to run, they differ at each time step, and errors are differences of two answers. */
static void judge_noise(const struct command *r, const struct ladder *l, struct measured *m) {
    struct experiment e = r->experiment;
    struct measured tried = *m;
    double apart[NORM_QUANTITY];
    struct result first;
    struct field f[2] = {{0}, {0}};
    struct diagnosis d;
    double error = ladder_finest_error(l), ceiling = r->rungs.ceiling;
    e.options.dt = l->x[l->n - 1];
    e.program.keep = NULL;
    e.program.diagnosis = 1;
    int differ = e.program.solver && run_twice(&e, &first, f, apart, &tried) &&
                 apart[NORM_L1] > JUDGE_NOISE * error && diagnosis_repeat(apart[NORM_LINF], field_largest(&f[0]), &d);
    for (int k = 0; k < 2; k++) field_free(&f[k]);
    if (!differ) return;
    if (ceiling > 0 && error - 3 * apart[NORM_L1] > ceiling) return;
    measures_diagnosed(m, &d);
    snprintf(m->reason, sizeof m->reason, "%s", m->diagnosis);
    m->verdict = VERDICT_INCONCLUSIVE;
}

/* Compares the answers at the two finest rungs, where the error has its order. */
static void diagnose_steps(const struct command *r, const struct ladder *l, struct measured *m) {
    struct experiment e = r->experiment;
    struct measured tried = *m;
    struct result result[2];
    struct field f[2] = {{0}, {0}};
    int usable = e.program.solver != NULL && l->n >= 2;
    e.program.keep = NULL;
    e.program.diagnosis = 1;
    for (int k = 0; k < 2 && usable; k++) {
        e.options.dt = l->x[l->n - 2 + k];
        usable = !measures_run(&e, &result[k], &f[k], &tried);
    }
    usable = usable && f[0].n == f[1].n;
    for (size_t i = 0; usable && i < f[0].n; i++) {
        double x[2][DIM_MAX];
        for (int k = 0; k < 2; k++) field_place(&f[k], i, x[k]);
        for (int a = 0; a < f[0].dim; a++) usable = usable && x[0][a] == x[1][a];
    }
    if (usable) {
        struct diagnosis d;
        for (size_t i = 0; i < f[0].n; i++) f[0].T[i] -= f[1].T[i];
        diagnosis_steps(&e.problem, &f[1], f[0].T, result[0].dt - result[1].dt, &d);
        measures_diagnosed(m, &d);
    }
    for (int k = 0; k < 2; k++) field_free(&f[k]);
}

/* A program with its own time step gives the same answer for every requested step: the row does not apply. */
void measures_slope_time(const struct command *r, double lo, double hi, struct measured *m) {
    struct ladder *l = xcalloc(1, sizeof *l);
    struct command with = *r;
    with.rungs.small_passes = 1;
    int status = measures_ladder(&with, lo, hi, l, m), differ = 0;
    for (int i = 0; i < l->n; i++) differ += l->error[i] != 0;
    if (!status && !differ)
        skip(m, "the answers are the same for every dt: the program takes a time step of its own");
    else if (m->verdict != VERDICT_PASS && !l->failure.status)
        judge_noise(r, l, m);
    if (m->verdict == VERDICT_FAIL && !l->failure.status && !m->found.named) diagnose_steps(r, l, m);
    if (m->verdict == VERDICT_FAIL || m->verdict == VERDICT_INCONCLUSIVE) keep_rungs(l, &m->rungs);
    ladder_free(l);
    free(l);
}

/* A single run has few known digits; other faults are identified with a run at twice the spacing.  If runs differ,
 * or if the printed digits could account for the excess over `hi`, the error is inconclusive. */
static void diagnose(const struct command *r, const struct field *f, double hi, struct measured *m) {
    struct experiment again = r->experiment;
    const struct experiment *e = &again;
    const double dx = e->options.dx;
    double extent = fmax(e->problem.hi[0] - e->problem.lo[0], e->problem.hi[1] - e->problem.lo[1]);
    struct ladder_rungs rungs = {.dx = {.count = 2, .value = {2 * dx, dx}}, .diagnose = 1};
    struct ladder *l = xcalloc(1, sizeof *l);
    struct failure ignored;
    struct diagnosis d = {.unit = ""};
    struct field given = program_as_given(&e->program, f, NULL);
    int digits, rounded = diagnosis_rounding(&given, m->error, extent / dx, &d);
    double printed = norms_digits(f, &e->program.map, &digits);
    again.program.diagnosis = 1;
    if (!rounded && e->program.solver && !ladder_run(e, &rungs, l, &ignored)) diagnose_ladder(e, l, &d);
    measures_diagnosed(m, &d);
    if (l->noise.share > JUDGE_NOISE) {
        snprintf(m->reason, sizeof m->reason, "%s", m->diagnosis);
        m->verdict = VERDICT_INCONCLUSIVE;
    } else if ((rounded || !d.named) && m->error - 2 * printed <= hi) {
        snprintf(m->reason, sizeof m->reason,
                 "printed digits: %d in the file make up %.0f %% of the error; more of them show what is left",
                 digits, 100 * fmin(printed / m->error, 1));
        m->verdict = VERDICT_INCONCLUSIVE;
    }
    field_free(&given);
    ladder_free(l);
    free(l);
}

void measures_error(const struct command *r, double lo, double hi, struct measured *m) {
    const struct experiment *e = &r->experiment;
    struct result result;
    struct field f = {0};
    if (!measures_run(e, &result, &f, m)) {
        judge_value(r, "error", result.error[NORM_L1], lo, hi, m);
        if (e->external && m->verdict == VERDICT_FAIL) diagnose(r, &f, hi, m);
        keep_field(e, &f, m);
    }
    field_free(&f);
}

void measures_repeat(const struct command *r, double lo, double hi, struct measured *m) {
    double apart[NORM_QUANTITY];
    struct result first;
    struct field f[2] = {{0}, {0}};
    struct diagnosis d;
    if (run_twice(&r->experiment, &first, f, apart, m)) {
        double largest = field_largest(&f[0]);
        judge_value(r, "repeat", apart[NORM_LINF] / largest, lo, hi, m);
        m->error = first.error[NORM_L1];
        if (m->verdict == VERDICT_FAIL && diagnosis_repeat(apart[NORM_LINF], largest, &d)) {
            measures_diagnosed(m, &d);
            snprintf(m->reason, sizeof m->reason, "%s; where that is meant, --skip this row", m->diagnosis);
            m->verdict = VERDICT_INCONCLUSIVE;
        }
        if (keep_answer(&f[0], "second run", m)) self_difference_other(&m->field, &f[1], m->due);
    }
    for (int k = 0; k < 2; k++) field_free(&f[k]);
}

/* For a picture of temperatures with few digits: each beside its rounding to those, decimal or of 24 bits, and room
 * for half a unit of the last digit, over which full precision would scatter. */
static void keep_digits(struct field *given, int digits, double off, struct measured *m) {
    char name[sizeof m->due_is], text[NUMBER_PRINTED];
    const double largest = field_largest(given);
    snprintf(name, sizeof name, "T to %d digits", digits);
    if (!(largest > 0) || !keep_answer(given, name, m)) return;
    m->due_scale = 0.5 * pow(10, floor(log10(largest)) + 1 - digits);
    for (size_t i = 0; i < m->field.n; i++) {
        const double T = m->field.T[i];
        snprintf(text, sizeof text, "%.*e", digits - 1, T);
        m->due[i] = fabs(T - (float)T) <= off ? (float)T : strtod(text, NULL);
    }
}

/* Decimal digits of the temperatures as they are printed; numbers of single precision have seven. */
void measures_digits(const struct command *r, double lo, double hi, struct measured *m) {
    enum { MANY = 10 };
    struct result result;
    struct field f = {0};
    struct diagnosis d;
    if (!measures_run(&r->experiment, &result, &f, m)) {
        struct field given = program_as_given(&r->experiment.program, &f, NULL);
        const double off = 16 * DBL_EPSILON * field_largest(&given);
        const int single = diagnosis_rounding(&given, 0, 1, &d);
        int digits = single ? (int)d.size : 0;
        char text[NUMBER_PRINTED];
        for (size_t i = 0; i < given.n && digits < MANY && !single; i++) {
            double T = given.T[i];
            digits = (int)fmax(digits, number_digits(T, T == 0 ? 0 : off / fabs(T), MANY - 1, text));
        }
        judge_value(r, "digits", digits, lo, hi, m);
        if (single) measures_diagnosed(m, &d);
        keep_digits(&given, digits, off, m);
        field_free(&given);
    }
    field_free(&f);
}

/* ---- Stability ---- */

/* The model problem, the limit that theory gives where l is not NULL, and the one that runs show where `measured`. 0,
 * or *m failed. */
static int model_of(const struct command *r, struct model_problem *b, struct step_limit *l, int measured,
                    struct measured *m) {
    struct failure why = {0};
    int status = step_limit_setup(r->experiment.method, &r->experiment.options, r->dim, r->ratio, r->field,
                                  r->contact, r->stages, b, &why);
    if (!status && l) status = step_limit_predict(b, l, &why);
    if (!status && l && measured) status = step_limit_measure(b, &l->measured, &why);
    measures_fail(m, &why);
    return status;
}

void measures_limit_agree(const struct command *r, double lo, double hi, struct measured *m) {
    static const double ratio[] = {1.05, 1.5, 2.05};
    double worst = 0, at[3] = {NAN, NAN, NAN};
    int count = r->experiment.options.h > 0 || !r->experiment.method->scheme ? 1 : 3;
    for (int k = 0; k < count; k++) {
        struct command with = *r;
        struct model_problem b;
        struct step_limit l;
        if (count > 1) with.experiment.options.h = ratio[k];
        if (model_of(&with, &b, &l, 1, m)) return;
        double apart = fabs(l.measured / l.von_neumann - 1);
        if (apart < worst) continue;
        worst = apart;
        at[0] = b.options.h, at[1] = l.measured, at[2] = l.von_neumann;
        if (isnan(apart)) break;
    }
    judge_value(r, "limit_agree", worst, lo, hi, m);
    words_add(m->reason, sizeof m->reason, " (h/dx %.4g: measured %.5g, von Neumann %.5g)", at[0], at[1], at[2]);
}

/* A ratio alone is a formula against a formula: a run must grow just below the published limit if that is too large,
 * and only then. */
void measures_limit_published(const struct command *r, double lo, double hi, struct measured *m) {
    enum { STEPS = 1000 };
    struct model_problem b;
    struct step_limit l;
    struct failure why;
    if (model_of(r, &b, &l, 0, m)) return;
    const double tried = 0.99 * l.published;
    const int grows = step_limit_grows(&b, tried, STEPS, &why), agrees = grows == (tried > l.von_neumann);
    judge_value(r, "limit_published", agrees ? l.published / l.von_neumann : NAN, lo, hi, m);
    words_add(m->reason, sizeof m->reason, " (published %.5g, von Neumann %.5g)", l.published, l.von_neumann);
    if (!agrees) words_add(m->reason, sizeof m->reason, "; yet a run at %.5g %s", tried, grows ? "grew" : "decayed");
}

void measures_limit_interval(const struct command *r, double lo, double hi, struct measured *m) {
    struct model_problem b;
    struct step_limit l;
    if (model_of(r, &b, &l, 1, m)) return;
    judge_value(r, "limit_interval", l.measured * l.radius / amplification_interval(&b.step), lo, hi, m);
    words_add(m->reason, sizeof m->reason, " (measured %.5g of 1/|lambda|, theory %.5g; |G| = 1 at %.5g)",
              l.measured * l.radius, amplification_interval(&b.step), amplification_reach(&b.step));
}

void measures_growth(const struct command *r, double lo, double hi, struct measured *m) {
    struct model_problem b;
    struct step_limit l;
    if (!model_of(r, &b, &l, 0, m)) judge_value(r, "growth", l.growth, lo, hi, m);
}
