/* Collecting, running and judging gates.  Every row of the table becomes one result, and a result that nobody filled
 * is inconclusive, which does not pass; that as many were run as declared is checked on top. */
#include "verification/gates/gates.h"

#include "references/scene.h"
#include "verification/command/arguments.h"
#include "verification/ladder/judge.h"
#include "verification/ladder/ladder.h"
#include "verification/text/progress.h"
#include "verification/text/words.h"

#include <fnmatch.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GATE(id, tier, measure, command, lo, hi, ceiling, why)                                                       \
    {id, TIER_##tier, measure, command, lo, hi, ceiling, why},
const struct gate gates_table[] = {
#include "verification/gates/rod.def"
#include "verification/gates/manufactured.def"
#include "verification/gates/cooling.def"
#include "verification/gates/materials.def"
#include "verification/gates/plane.def"
#include "verification/gates/operators.def"
#include "verification/gates/stability.def"
#include "verification/gates/time.def"
#include "verification/gates/use.def"
/* Every claim's verdict is gated without a row. */
#define CLAIM(id, source, published, measure, argument, expected, why)                                               \
    {"claim/" id, TIER_FULL, "claim", "claims --only " id, 0.5, 1.5, NAN, "expected of it in claims.def: " #expected},
#include "verification/claims/claims.def"
#undef CLAIM
    {0}};
#undef GATE

enum { TEXT = 160 }; /* of the name and of the command of a reference's gate */

static int matches(const struct gate *gate, const char *only, int quick) {
    if (quick && gate->tier != TIER_QUICK) return 0;
    return !only || fnmatch(only, gate->id, 0) == 0;
}

/* Every scene's reference is gated without a row: its two forms agree within their bounds, which are small. */
static struct gate reference_gate(const struct scene *s, char *text) {
    struct problem p;
    struct failure why;
    char *id = text, *command = text + TEXT;
    scene_defaults(s, &p);
    snprintf(id, TEXT, "reference/%s", s->name);
    if (s->setup(&p, &why)) p.dim = 1; /* its command then fails with that text */
    double x = p.lo[0] + 0.137 * (p.hi[0] - p.lo[0]), y = p.lo[1] + 0.311 * (p.hi[1] - p.lo[1]);
    int n = snprintf(command, TEXT, "reference %s --at %.3g", s->name, x);
    if (p.dim == 2) n += snprintf(command + n, (size_t)(TEXT - n), ",%.3g", y);
    snprintf(command + n, (size_t)(TEXT - n), " --time %.3g", p.t_end);
    return (struct gate){
        id, TIER_QUICK, "reference", command,
        0,  1,          1e-12,       "two forms derived apart differ by no more than the sum of their bounds"};
}

/* A pattern has no nearest name. */
static int none_matches(const char *only, int rows, struct failure *why) {
    const char **ids = xcalloc((size_t)rows + 1, sizeof *ids), *nearest = NULL;
    for (int i = 0; i < rows; i++) ids[i] = gates_table[i].id;
    if (only && !strpbrk(only, "*?[")) nearest = words_nearest(ids, only);
    free(ids);
    return refuse(why, STATUS_INPUT, "no gate matches '%.60s'%s%s%s (see: heatladder list gates)", only ? only : "*",
                  nearest ? "; did you mean '" : "", nearest ? nearest : "", nearest ? "'?" : "");
}

int gates_collect(const char *only, int quick, struct gates *g, struct failure *why) {
    int rows = 0, references = 0;
    while (gates_table[rows].id) rows++;
    while (scenes[references]) references++;
    *g = (struct gates){.result = xcalloc((size_t)(rows + references), sizeof *g->result),
                        .text = xcalloc((size_t)references, 2 * TEXT)};
    for (int i = 0; i < rows + references; i++) {
        int s = i - rows;
        struct gate gate = s < 0 ? gates_table[i] : reference_gate(scenes[s], g->text + 2 * TEXT * s);
        if (matches(&gate, only, quick)) g->result[g->declared++].gate = gate;
    }
    return g->declared ? STATUS_OK : none_matches(only, rows, why);
}

void gates_free(struct gates *g) {
    free(g->result);
    free(g->text);
    *g = (struct gates){0};
}

static void judge_refused(struct measured *m, const char *text) {
    m->verdict = VERDICT_FAIL;
    m->value = m->ci[0] = m->ci[1] = m->error = NAN;
    snprintf(m->reason, sizeof m->reason, "%.300s", text);
}

void gates_judge(const struct gate *gate, struct measured *m) {
    struct request r;
    struct failure why;
    *m = (struct measured){0};
    const struct measure *measure = measures_find(gate->measure, m);
    if (!measure) return;
    if (arguments_parse_line(gate->command, &r, &why)) {
        judge_refused(m, why.text);
    } else if (measure->ceiling && !(gate->ceiling > 0)) {
        judge_refused(m, "this measure needs an error ceiling beside it");
    } else {
        measure->take(&r, gate->lo, gate->hi, m);
        if (!isnan(gate->ceiling)) judge_ceiling(m->error, gate->ceiling, &m->verdict, m->reason, sizeof m->reason);
    }
    arguments_free(&r);
}

/* The norm of a measure of slopes: "slope" or "slope_NORM"; -1 for any other measure. */
static int slope_norm(const char *measure) {
    if (strcmp(measure, "slope") == 0) return LADDER_L1;
    return strncmp(measure, "slope_", 6) == 0 ? words_index(ladder_norm_words, measure + 6) : -1;
}

void gates_command(const struct gate *gate, char *text, size_t size) {
    int norm = slope_norm(gate->measure);
    if (norm < 0) {
        snprintf(text, size, "verify --only '%s'", gate->id);
        return;
    }
    int used = snprintf(text, size, "%s --expect %g,%g", gate->command, gate->lo, gate->hi);
    if (norm > 0 && (size_t)used < size)
        used += snprintf(text + used, size - (size_t)used, " --norm %s", ladder_norm_words[norm]);
    if (!isnan(gate->ceiling) && (size_t)used < size)
        snprintf(text + used, size - (size_t)used, " --ceiling %.10g", gate->ceiling);
}

/* About how many particle updates a command takes: the sum over rungs of particles x steps; steps = t kappa / (F
 * dx^2), with F as given, or the 1/600 or so at which the time error of Euler's method falls below 1 %, and a few for
 * the exact stepper.  The heaviest starts first; nothing else depends on it. */
static double steps_at(const struct request *r, double dx) {
    const struct experiment *e = &r->experiment;
    const struct material *m = &e->problem.material[0];
    double diffusion = e->problem.t_end * m->k[0] / m->rho_c / (dx * dx), steps = 0;
    for (int i = 0; i < r->rungs.dt.count; i++) steps += e->problem.t_end / r->rungs.dt.value[i];
    for (int i = 0; i < r->rungs.fourier.count; i++) steps += diffusion / r->rungs.fourier.value[i];
    if (steps > 0) return steps;
    return e->method && e->method->scheme && e->options.stepper <= STEPPER_EXACT ? 20 : 600 * diffusion;
}

static double job_size(const struct request *r) {
    const struct problem *p = &r->experiment.problem;
    double work = 0;
    for (int i = 0; i < r->rungs.dx.count; i++) {
        double particles = 1;
        for (int a = 0; a < p->dim; a++) particles *= (p->hi[a] - p->lo[a]) / r->rungs.dx.value[i];
        work += particles * steps_at(r, r->rungs.dx.value[i]);
    }
    return work;
}

static double job_size_of(const char *command) {
    struct request r;
    struct failure why;
    double work = arguments_parse_line(command, &r, &why) ? 0 : job_size(&r);
    arguments_free(&r);
    return isfinite(work) ? work : 0;
}

struct job {
    int gate;
    double size;
};

static int heaviest_first(const void *a, const void *b) {
    const struct job *x = a, *y = b;
    return x->size != y->size ? (x->size < y->size) - (x->size > y->size) : (x->gate > y->gate) - (x->gate < y->gate);
}

void gates_run(struct gates *g) {
    struct job *job = xcalloc((size_t)g->declared, sizeof *job);
    for (int i = 0; i < g->declared; i++) job[i] = (struct job){i, job_size_of(g->result[i].gate.command)};
    qsort(job, (size_t)g->declared, sizeof *job, heaviest_first);
    struct progress progress = progress_start("gates", g->declared);
    int executed = 0;
#pragma omp parallel for schedule(dynamic, 1) reduction(+ : executed)
    for (int i = 0; i < g->declared; i++) {
        struct gate_result *result = &g->result[job[i].gate];
        double start = omp_get_wtime();
        gates_command(&result->gate, result->typed, sizeof result->typed);
        gates_judge(&result->gate, &result->measured);
        result->seconds = omp_get_wtime() - start;
        executed += !result->executed;
        result->executed = 1;
        progress_tick(&progress);
    }
    progress_end(&progress);
    g->executed = executed;
    free(job);
}

int gates_status(const struct gates *g) {
    int passed = 0, unclear = 0;
    for (int i = 0; i < g->declared; i++) {
        passed += g->result[i].executed && g->result[i].measured.verdict == VERDICT_PASS;
        unclear += g->result[i].executed && g->result[i].measured.verdict == VERDICT_INCONCLUSIVE;
    }
    if (g->declared == 0 || g->executed != g->declared || passed + unclear < g->declared) return STATUS_GATE;
    return unclear ? STATUS_INCONCLUSIVE : STATUS_OK;
}

int gates_has_order(const char *scene, const char *method) {
    char start[120];
    int length = snprintf(start, sizeof start, "ladder %s %s ", scene, method);
    for (const struct gate *gate = gates_table; gate->id; gate++)
        if (strncmp(gate->measure, "slope", 5) == 0 && strncmp(gate->command, start, (size_t)length) == 0) return 1;
    return 0;
}
