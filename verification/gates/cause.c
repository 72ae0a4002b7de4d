/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cause for all rows that do not hold: a fault that explains them and that no row which passes contradicts; else
 * what they share. */
#include "verification/gates/gates.h"

#include "solver/words.h"
#include "verification/fault/headline.h"
#include "verification/case/command.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Features of rows ---- */

static int is_rod(const struct problem *p, double aspect) {
    (void)aspect;
    return p->dim == 1;
}

static int is_plane(const struct problem *p, double aspect) {
    (void)aspect;
    return p->dim == 2;
}

static int is_in_space(const struct problem *p, double aspect) {
    (void)aspect;
    return p->dim == 3;
}

static int has_law(const struct problem *p, double aspect) {
    (void)aspect;
    return p->k_law != K_CONSTANT && p->k_law != K_PHASES;
}

static int has_phases(const struct problem *p, double aspect) {
    (void)aspect;
    return p->k_law == K_PHASES;
}

static int has_cross(const struct problem *p, double aspect) {
    (void)aspect;
    return problem_has_cross(p);
}

static int has_field(const struct problem *p, double aspect) {
    (void)aspect;
    return p->direction != NULL;
}

/* A tensor in the plane, and T that varies beside the middle of a held side by a thousandth of what it does inside.
 */
static int has_cross_at_wall(const struct problem *p, double aspect) {
    enum { N = 16 };
    double inside = 0, beside = 0;
    (void)aspect;
    for (int s = 0; s < 4 && p->dim == 2 && problem_has_cross(p); s++)
        for (int i = 0; i < N && p->side[s] == DIRICHLET; i++) {
            double x[DIM_MAX] = {(p->lo[0] + p->hi[0]) / 2, (p->lo[1] + p->hi[1]) / 2, 0};
            const double wall = (s % 2 ? p->hi : p->lo)[s / 2], away = fabs(x[s / 2] - wall) * (i + 1) / N;
            x[s / 2] = wall + (s % 2 ? -away : away);
            const double apart = fabs(p->initial(p, x) - p->wall(p, (enum side)s, x, 0));
            inside = fmax(inside, apart), beside = fmax(beside, i == 0 ? apart : 0);
        }
    return beside > 1e-3 * inside;
}

static int has_two(const struct problem *p, double aspect) {
    (void)aspect;
    return p->materials == 2;
}

static int has_moving(const struct problem *p, double aspect) {
    (void)aspect;
    return p->wall_rate != NULL;
}

static int has_kind(const struct problem *p, enum side_kind kind) {
    for (int s = 0; s < 2 * p->dim; s++)
        if (p->side[s] == kind) return 1;
    return 0;
}

static int has_periodic(const struct problem *p, double aspect) {
    (void)aspect;
    return has_kind(p, PERIODIC);
}

static int has_robin(const struct problem *p, double aspect) {
    (void)aspect;
    return has_kind(p, ROBIN);
}

static int has_source(const struct problem *p, double aspect) {
    (void)aspect;
    return p->source || p->source_at;
}

static int is_oblong(const struct problem *p, double aspect) {
    return p->dim > 1 && aspect > 0 && aspect != 1;
}

/* A code may have other lines for data that change. */
static int is_steady(const struct problem *p, double aspect) {
    (void)aspect;
    return !problem_changes(p) && !p->source_at;
}

/* Classes of problems first: what a code has a branch for. */
enum { LAW = 3, CLASSES = 9, OBLONG = 11 };
static const struct {
    int (*has)(const struct problem *p, double aspect);
    const char *in, *all; /* "in space"; "all rows that do not pass ..." */
} features[] = {{is_rod, "on rods", "are rods"},
                {is_plane, "in the plane", "are in the plane"},
                {is_in_space, "in space", "are in space"},
                {has_law, "for k(T)", "have k(T)"},
                {has_phases, "with latent heat", "have latent heat"},
                {has_two, "with two materials", "have a second material"},
                {has_moving, "with walls that change", "have walls that change"},
                {has_periodic, "with periodic sides", "have periodic sides"},
                {is_steady, "with steady data", "have steady data"},
                {has_robin, "", "have a Robin wall"},
                {has_source, "", "have a source"},
                {is_oblong, "", "have cells of two widths"},
                {has_field, "", "have a conductivity along a field"},
                {has_cross, "", "have k_xy"},
                {has_cross_at_wall, "", "have k_xy beside held walls"}};
enum { FEATURES = sizeof features / sizeof *features };

struct row {
    unsigned has;                /* 1 << feature; 0: unknown */
    int fails, passes, is_wrong; /* is_wrong: it fails on the answers of its program */
    const struct gate *gate;
    double dt; /* s, of the finest rung; 0: unknown */
};

struct rows {
    int n;
    struct row *row;
    unsigned shared; /* by all rows that fail */
};

static const char *const external[] = {"--solver", "{case} {out}", NULL}; /* METHOD is then a label */

static unsigned features_of(const struct gate *gate) {
    struct command r;
    struct failure ignored;
    unsigned has = 0;
    if (!gate->command) return 0;
    if (!command_read_with(gate->command, external, &r, &ignored))
        for (int i = 0; i < FEATURES; i++)
            if (features[i].has(&r.experiment.problem, r.experiment.options.aspect)) has |= 1u << i;
    command_free(&r);
    return has;
}

/* Rows that pass with that feature, or without it. */
static int passing(const struct rows *rows, unsigned feature, int with) {
    int n = 0;
    for (int i = 0; i < rows->n; i++) n += rows->row[i].passes && !(rows->row[i].has & feature) == !with;
    return n;
}

/* The chance that rows drawn at random, as many as fail, all have that feature. */
static double by_chance(const struct rows *rows, unsigned feature, int failing) {
    double with = failing + passing(rows, feature, 1), all = with + passing(rows, feature, 0), chance = 1;
    for (int i = 0; i < failing; i++) chance *= (with - i) / (all - i);
    return chance;
}

/* The feature that sets the rows that fail apart: fewest rows that pass have it, no more than fail or so few that it
 * is no chance; -1: none. */
static int telling(const struct rows *rows, int from, int to, int failing) {
    static const double RARE = 0.01;
    int best = -1, fewest = rows->n;
    for (int i = from; i < to; i++) {
        unsigned bit = 1u << i;
        int with = passing(rows, bit, 1);
        if (!(rows->shared & bit) || !passing(rows, bit, 0) || with >= fewest) continue;
        if (with > failing && by_chance(rows, bit, failing) > RARE) continue;
        fewest = with, best = i;
    }
    return best;
}

/* ---- Rows that pass ---- */

/* 1 where a row that passed could not have done so with the fault. */
static int row_contradicts(const struct row *row, const struct diagnosis *fault) {
    const struct gate *gate = row->gate;
    struct command r;
    struct failure ignored;
    struct image image;
    int against = 0;
    const int is_order = strcmp(gate->measure, "order") == 0, is_error = strcmp(gate->measure, "error") == 0;
    const double ceiling = is_error ? gate->hi : gate->ceiling;
    if (!(is_order || is_error) || !(ceiling > 0)) return 0;
    if (!command_read_with(gate->command, external, &r, &ignored)) {
        const struct experiment *e = &r.experiment;
        double finest = r.rungs.dx.count ? r.rungs.dx.value[0] : e->options.dx;
        for (int i = 1; i < r.rungs.dx.count; i++) finest = fmin(finest, r.rungs.dx.value[i]);
        mapping_image(&e->program.map, &e->problem, &image);
        if (!e->derived && (e->problem.materials == 1 || image.interface_axis == 0))
            against = headline_contradicts(fault, &image.problem, finest, row->dt, e->program.map.offset, ceiling);
    }
    command_free(&r);
    return against;
}

static int contradict(const struct diagnosis *fault, const void *context) {
    const struct rows *rows = context;
    const unsigned class = rows->shared & ((1u << CLASSES) - 1);
    int outside = 0;
    for (int i = 0; i < rows->n; i++) {
        const int is_outside = (rows->row[i].has & class) != class;
        if (!rows->row[i].passes || (is_outside && outside) || !row_contradicts(&rows->row[i], fault)) continue;
        if (!is_outside) return 1;
        outside = 2;
    }
    return outside;
}

/* ---- Without a name ---- */

/* The side next to which the errors of all rows are; -1: none. */
static int common_side(const struct diagnosis *found, int failing) {
    unsigned sides = ~0u;
    int known = 0;
    for (int i = 0; i < failing; i++)
        if (found[i].evidence) sides &= found[i].beside, known++;
    for (int s = 0; s < SIDES; s++)
        if (known && sides & 1u << s) return s;
    return -1;
}

/* "detects ..." of the first row that fails on its answers; NULL: it has no such text. */
static const char *detected_alone(const struct rows *rows) {
    int i = 0;
    while (i < rows->n && !(rows->row[i].is_wrong)) i++;
    const char *why = i < rows->n ? rows->row[i].gate->why : NULL;
    return why && strncmp(why, "detects ", 8) == 0 ? why : NULL;
}

static void print_shared(const struct rows *rows, const struct diagnosis *found, int failing, char *text,
                         size_t size) {
    static const char *const sides[] = {"x_lo", "x_hi", "y_lo", "y_hi", "z_lo", "z_hi"};
    int side = common_side(found, failing), what = telling(rows, 0, FEATURES, failing);
    const char *alone = failing == 1 ? detected_alone(rows) : NULL;
    *text = '\0';
    if (side >= 0)
        snprintf(text, size,
                 "the errors of all rows that do not pass (%d) are beside side %s, in one layer of cells along %c",
                 failing, sides[side], "xyz"[side / 2]);
    else if (alone)
        snprintf(text, size, "one row alone does not pass: it %.*s", (int)strcspn(alone, ";"), alone);
    else if (what >= 0)
        snprintf(text, size, "all rows that do not pass (%d) %s%s", failing, features[what].all,
                 passing(rows, 1u << what, 1) ? "" : ", and no other row does");
}

/* The rows of cells of two widths have fluxes on sides across different axes. */
static void print_widths(const struct rows *rows, char *text, size_t size) {
    int some = passing(rows, 1u << OBLONG, 1);
    snprintf(text, size, "%sas if dx were taken for dy%s: no row of square cells fails", some ? "perhaps " : "",
             some ? " where fluxes are given" : ", or each for the other");
}

static const double LEFT = 0.5; /* a cause leaves a row unexplained below this share of its error */

/* The words of a row, given the headline. */
static void print_left(const struct headline *h, struct measured *m) {
    double share = headline_share(h, &m->found);
    if (!isfinite(share) || !h->fault.named) return;
    if (share > 0.995 && isnan(h->fault.share))
        snprintf(m->diagnosis, sizeof m->diagnosis, "%s", h->fault.what);
    else if (share >= LEFT)
        snprintf(m->diagnosis, sizeof m->diagnosis, "%s%s (%.0f %% of the error)", h->is_firm ? "" : "perhaps ",
                 h->fault.what, 100 * share);
    else if (h->is_firm)
        snprintf(m->diagnosis, sizeof m->diagnosis, "the fault of the other rows explains %.0f %% of this error",
                 100 * share);
}

static int is_open(const struct measured *m) {
    return m->verdict == VERDICT_FAIL || m->verdict == VERDICT_INCONCLUSIVE;
}

/* Whether the runs of all rows that do not pass overflow or have no answer, as one that is not a number. */
static int all_overflow(const struct gates *g, const struct headline *h) {
    if (!h->fault.named || h->fault.fault.kind != FAULT_UNSTABLE) return 0;
    for (int i = 0; i < g->declared; i++) {
        const struct measured *m = &g->result[i].measured;
        if (is_open(m) && isfinite(m->value) && !(headline_share(h, &m->found) == 1)) return 0;
    }
    return 1;
}

/* Whether all rows that do not pass are of a higher order and have the slope of second order. */
static int are_of_order_two(const struct gates *g) {
    static const double band[2] = {1.5, 2.9};
    int n = 0;
    for (int i = 0; i < g->declared; i++) {
        const struct measured *m = &g->result[i].measured;
        const struct gate *gate = &g->result[i].gate;
        if (!is_open(m)) continue;
        if (strcmp(gate->measure, "order") != 0 || !(gate->lo > band[1])) return 0;
        if (!(m->value >= band[0] && m->value <= band[1])) return 0;
        n++;
    }
    return n;
}

/* A second cause: the firm one of at least two rows that a firm first one leaves unexplained. */
static struct headline second_cause(const struct headline *first, const struct diagnosis *found, int failing,
                                    const struct rows *rows) {
    struct diagnosis *rest = xcalloc((size_t)failing, sizeof *rest);
    struct headline second = {.is_firm = 0};
    int n = 0;
    for (int i = 0; i < failing; i++)
        if (headline_share(first, &found[i]) < LEFT) rest[n++] = found[i];
    if (first->is_firm && n > 1) second = headline_choose(rest, n, contradict, rows);
    if (!second.is_firm || second.votes < 2 || second.scope) second.fault.named = 0;
    free(rest);
    return second;
}

void gates_diagnose(struct gates *g) {
    struct diagnosis *found = xcalloc((size_t)g->declared + 1, sizeof *found);
    struct rows rows = {g->declared, xcalloc((size_t)g->declared + 1, sizeof *rows.row), ~0u};
    int failing = 0;
    for (int i = 0; i < g->declared; i++)
        if (is_open(&g->result[i].measured)) found[failing++] = g->result[i].measured.found;
    for (int i = 0; i < g->declared && failing; i++) {
        struct row *row = &rows.row[i];
        *row = (struct row){.has = features_of(&g->result[i].gate),
                            .fails = is_open(&g->result[i].measured),
                            .passes = gates_holds(&g->result[i]),
                            .is_wrong = g->result[i].measured.verdict == VERDICT_FAIL &&
                                        isfinite(g->result[i].measured.value),
                            .gate = &g->result[i].gate,
                            .dt = g->result[i].measured.dt};
        if (row->fails) rows.shared &= row->has;
    }
    *g->diagnosis = '\0';
    if (are_of_order_two(g)) {
        snprintf(g->diagnosis, sizeof g->diagnosis, "all %d rows that do not pass converge with order 2: --order 2",
                 failing);
        for (int i = 0; i < g->declared; i++) *g->result[i].measured.diagnosis = '\0';
    } else if (failing) {
        int class = telling(&rows, 0, CLASSES, g->declared);
        struct headline h = headline_choose(found, failing, contradict, &rows);
        if (h.fault.fault.kind == FAULT_UNSTABLE)
            h.is_firm = all_overflow(g, &h) || (h.is_firm && 2 * h.votes >= failing);
        if (h.fault.fault.kind == FAULT_UNSTABLE && rows.shared & 1u << LAW)
            words_add(h.fault.what, sizeof h.fault.what, ", or k(T) < 0");
        struct headline second = {.is_firm = 0};
        if (rows.shared & 1u << OBLONG && passing(&rows, 1u << OBLONG, 0)) {
            print_widths(&rows, g->diagnosis, sizeof g->diagnosis);
        } else {
            headline_print(&h, class >= 0 ? features[class].in : "", g->diagnosis);
            second = second_cause(&h, found, failing, &rows);
        }
        if (second.fault.named)
            words_add(g->diagnosis, sizeof g->diagnosis, "; of the others %d: %s", second.votes, second.fault.what);
        if (!*g->diagnosis) print_shared(&rows, found, failing, g->diagnosis, sizeof g->diagnosis);
        for (int i = 0; i < g->declared; i++) {
            struct measured *m = &g->result[i].measured;
            const int is_second = headline_share(&second, &m->found) > headline_share(&h, &m->found);
            if (rows.row[i].fails) print_left(is_second ? &second : &h, m);
        }
    }
    free(rows.row);
    free(found);
}
