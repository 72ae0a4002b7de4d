/* Collecting, running and judging gates.  Every row of the table becomes one result, and a result that nobody filled
 * is inconclusive, which does not pass; that as many were run as declared is checked on top. */
#include "verification/gates/gates.h"

#include "references/scene.h"
#include "verification/command/arguments.h"
#include "verification/foreign/program.h"
#include "verification/foreign/scratch.h"
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

/* The nearest name into `hint`; of a pattern the nearest group, the part of a name before its slash. */
static void nearest_name(const struct gates *g, const char *glob, char *hint, size_t size) {
    char(*name)[TEXT] = xcalloc((size_t)g->declared, sizeof *name), typed[TEXT];
    const char **names = xcalloc((size_t)g->declared + 1, sizeof *names), *nearest = NULL;
    int pattern = glob[strcspn(glob, "*?[")] != '\0', length = pattern ? (int)strcspn(glob, "/") : (int)strlen(glob);
    snprintf(typed, sizeof typed, "%.*s", length, glob);
    for (int i = 0; i < g->declared; i++) {
        const char *id = g->result[i].gate.id;
        snprintf(name[i], sizeof name[i], "%.*s", pattern ? (int)strcspn(id, "/") : TEXT - 1, id);
        names[i] = name[i];
    }
    if (!strpbrk(typed, "*?[")) nearest = words_nearest(names, typed);
    hint[0] = '\0';
    if (nearest) snprintf(hint, size, "; did you mean '%.60s%s'?", nearest, pattern ? "/*" : "");
    free(names);
    free(name);
}

/* `option`: which one the glob is of. */
static int none_matches(const struct gates *g, const char *option, const char *glob, struct failure *why) {
    char hint[100];
    int file = g->origin && strncmp(g->origin, "--gates", 7) == 0;
    nearest_name(g, glob, hint, sizeof hint);
    return refuse(why, STATUS_INPUT, "--%s: no gate matches '%.60s'%s (see: %s%.200s)", option, glob, hint,
                  file ? "" : "heatladder list ",
                  file        ? g->origin
                  : g->origin ? "battery"
                              : "gates");
}

void gates_add(struct gates *g, const struct gate *gate) {
    struct gate_result *more = xcalloc((size_t)g->declared + 1, sizeof *more);
    if (g->declared) memcpy(more, g->result, (size_t)g->declared * sizeof *more);
    free(g->result);
    g->result = more;
    g->result[g->declared++].gate = *gate;
}

static int matches(const char *glob, const struct gate *gate) {
    return glob && fnmatch(glob, gate->id, 0) == 0;
}

int gates_choose(struct gates *g, const char *only, const char *skip, int quick, struct failure *why) {
    int found = 0, left_out = 0, kept = 0;
    for (int i = 0; i < g->declared; i++) {
        found += matches(only, &g->result[i].gate);
        left_out += matches(skip, &g->result[i].gate);
    }
    if (only && !found) return none_matches(g, "only", only, why);
    if (skip && !left_out) return none_matches(g, "skip", skip, why);
    for (int i = 0; i < g->declared; i++) {
        struct gate gate = g->result[i].gate;
        if ((quick && gate.tier != TIER_QUICK) || (only && !matches(only, &gate)) || matches(skip, &gate)) continue;
        g->result[kept++].gate = gate;
    }
    g->declared = kept;
    if (kept) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "no gate is left: --only '%.60s'%s%s%s%s", only ? only : "*",
                  skip ? " --skip '" : "", skip ? skip : "", skip ? "'" : "", quick ? " --quick" : "");
}

int gates_collect(const char *only, const char *skip, int quick, struct gates *g, struct failure *why) {
    int rows = 0, references = 0;
    while (gates_table[rows].id) rows++;
    while (scenes[references]) references++;
    *g = (struct gates){.declared = rows + references,
                        .result = xcalloc((size_t)(rows + references), sizeof *g->result),
                        .text = xcalloc((size_t)references, 2 * TEXT)};
    for (int i = 0; i < rows; i++) g->result[i].gate = gates_table[i];
    for (int s = 0; s < references; s++) g->result[rows + s].gate = reference_gate(scenes[s], g->text + 2 * TEXT * s);
    return gates_choose(g, only, skip, quick, why);
}

void gates_free(struct gates *g) {
    free(g->result);
    free(g->text);
    *g = (struct gates){0};
}

/* The norm of a measure of slopes: "slope", "slope_NORM", "order" or "order_NORM"; -1 for any other measure. */
static int slope_norm(const char *measure) {
    if (strcmp(measure, "slope") == 0 || strcmp(measure, "order") == 0) return LADDER_L1;
    if (strncmp(measure, "order_", 6) == 0) return words_index(ladder_norm_words, measure + 6);
    return strncmp(measure, "slope_", 6) == 0 ? words_index(ladder_norm_words, measure + 6) : -1;
}

static void judge_refused(struct measured *m, const char *text) {
    m->verdict = VERDICT_FAIL;
    m->value = m->ci[0] = m->ci[1] = m->error = NAN;
    snprintf(m->reason, sizeof m->reason, "%.300s", text);
}

/* The words that let another program answer a gate, ended by NULL; what they keep lies below a name of the gate's. */
struct words {
    const char *word[9];
    char keep[400], timeout[40];
};

static void words_of(const struct gate *gate, const struct program *g, struct words *w) {
    int n = 0;
    *w = (struct words){{NULL}, "", ""};
    if (!g) return;
    w->word[n++] = g->solver ? "--solver" : "--results";
    w->word[n++] = g->solver ? g->solver : g->results;
    if (g->keep) {
        snprintf(w->keep, sizeof w->keep, "%.200s/%.100s", g->keep, gate->id);
        w->word[n++] = "--keep", w->word[n++] = w->keep;
    }
    if (g->timeout > 0) {
        snprintf(w->timeout, sizeof w->timeout, "%.17g", g->timeout);
        w->word[n++] = "--timeout", w->word[n++] = w->timeout;
    }
    if (g->columns.text) w->word[n++] = "--columns", w->word[n++] = g->columns.text;
}

/* Of a ladder or a run alone: no other verb can be done by another program. */
static int parse(const struct gate *gate, const struct program *program, struct request *r, struct failure *why) {
    struct words w;
    words_of(gate, program, &w);
    if (arguments_parse_line_with(gate->command, w.word, r, why)) return why->status;
    if (!isnan(gate->ceiling)) r->rungs.ceiling = gate->ceiling;
    return STATUS_OK;
}

void gates_judge_by(const struct gate *gate, const struct program *program, struct measured *m) {
    struct request r;
    struct failure why;
    *m = (struct measured){0};
    const struct measure *measure = measures_find(gate->measure, m);
    if (!measure) return;
    if (parse(gate, program, &r, &why)) {
        judge_refused(m, why.text);
    } else if (measure->ceiling && !(gate->ceiling > 0)) {
        judge_refused(m, "this measure needs an error ceiling beside it");
    } else {
        measure->take(&r, gate->lo, gate->hi, m);
        if (!isnan(gate->ceiling) && m->verdict != VERDICT_SKIPPED && slope_norm(gate->measure) < 0)
            judge_ceiling(m->error, gate->ceiling, &m->verdict, m->reason, sizeof m->reason);
    }
    arguments_free(&r);
}

void gates_judge(const struct gate *gate, struct measured *m) {
    gates_judge_by(gate, NULL, m);
}

static void put_word(FILE *out, const char *word) {
    if (scratch_is_plain(word) || strncmp(word, "--", 2) == 0) {
        fprintf(out, " %s", word);
        return;
    }
    fprintf(out, " '");
    for (; *word; word++)
        if (*word == '\'')
            fprintf(out, "'\\''");
        else
            fputc(*word, out);
    fprintf(out, "'");
}

void gates_command_by(const struct gate *gate, const struct program *program, char *text, size_t size) {
    struct words w;
    int norm = slope_norm(gate->measure);
    FILE *out = fmemopen(text, size, "w");
    if (!out) return;
    if (norm < 0)
        fprintf(out, "verify --only '%s'", gate->id);
    else
        fprintf(out, "%s --expect %g,%g", gate->command, gate->lo, gate->hi);
    if (norm > 0) fprintf(out, " --norm %s", ladder_norm_words[norm]);
    if (norm >= 0 && !isnan(gate->ceiling)) fprintf(out, " --ceiling %.10g", gate->ceiling);
    words_of(gate, program, &w);
    for (int i = 0; w.word[i]; i++) put_word(out, w.word[i]);
    fclose(out);
    text[size - 1] = '\0';
}

void gates_command(const struct gate *gate, char *text, size_t size) {
    gates_command_by(gate, NULL, text, size);
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

/* Rungs of a ladder, in whatever it climbs; 1 of a run. */
static int runs_of(const struct gate *gate, const struct program *program) {
    struct request r;
    struct failure why;
    int runs = 1;
    if (!parse(gate, program, &r, &why)) {
        const struct numbers *climbs[] = {&r.rungs.dx, &r.rungs.dt, &r.rungs.fourier, &r.rungs.vary};
        for (int i = 0; i < 4; i++)
            if (climbs[i]->count > runs) runs = climbs[i]->count;
    }
    arguments_free(&r);
    return runs;
}

int gates_runs(const struct gates *g) {
    int runs = 0;
    for (int i = 0; i < g->declared; i++) runs += runs_of(&g->result[i].gate, g->program);
    return runs;
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
    if (!g->program) qsort(job, (size_t)g->declared, sizeof *job, heaviest_first);
    struct progress progress = progress_start("gates", g->declared);
    int executed = 0;
#pragma omp parallel for schedule(dynamic, 1) reduction(+ : executed) if (!g->program)
    for (int i = 0; i < g->declared; i++) {
        struct gate_result *result = &g->result[job[i].gate];
        double start = omp_get_wtime();
        gates_command_by(&result->gate, g->program, result->typed, sizeof result->typed);
        size_t used = strlen(result->typed);
        if (g->origin && strncmp(result->typed, "verify", 6) == 0)
            snprintf(result->typed + used, sizeof result->typed - used, " %s", g->origin);
        gates_judge_by(&result->gate, g->program, &result->measured);
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
    int passed = 0, unclear = 0, skipped = 0, silent = 0;
    for (int i = 0; i < g->declared; i++) {
        const struct gate_result *r = &g->result[i];
        silent += r->executed && r->measured.verdict == VERDICT_FAIL && isnan(r->measured.value);
        passed += r->executed && r->measured.verdict == VERDICT_PASS;
        unclear += r->executed && r->measured.verdict == VERDICT_INCONCLUSIVE;
        skipped += r->executed && r->measured.verdict == VERDICT_SKIPPED;
    }
    if (g->program && silent && silent + skipped == g->declared) return STATUS_NUMERICAL;
    if (g->declared == 0 || g->executed != g->declared || passed + unclear + skipped < g->declared)
        return STATUS_GATE;
    if (!passed) unclear = 1;
    return unclear ? STATUS_INCONCLUSIVE : STATUS_OK;
}

int gates_has_order(const char *scene, const char *method) {
    char start[120];
    int length = snprintf(start, sizeof start, "ladder %s %s ", scene, method);
    for (const struct gate *gate = gates_table; gate->id; gate++)
        if (strncmp(gate->measure, "slope", 5) == 0 && strncmp(gate->command, start, (size_t)length) == 0) return 1;
    return 0;
}
