/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The peers beside ours: as text, and as the data of a chart. */
#include "verification/bench/peers.h"

#include "verification/bench/bench_print.h"
#include "verification/text/table.h"
#include "verification/text/whole_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ERRORS = 3 };
static const double error_at[ERRORS] = {1e-3, 5e-4, 5e-5};
static const double BEYOND = 5; /* times the error of the finest size */

/* The next row that was measured, of that scene and with a name that begins so; the first where `row` is NULL. */
static const struct peers_row *next(const struct peers *all, const struct peers_row *row, const char *scene,
                                    const char *begins) {
    for (row = row ? row + 1 : all->row; row->peer; row++)
        if (!row->missing && !strcmp(row->peer->scene, scene) && !strncmp(row->peer->who, begins, strlen(begins)))
            return row;
    return NULL;
}

struct reach {              /* of an error, or of a size */
    struct bench_time time; /* s; a median of 0: not reached */
    int beyond;             /* 1: past the finest size */
};

static double between(double a, double b, double part) {
    return a * pow(b / a, part);
}

/* Along the straight line (log-log) through the sizes on either side of the error E; past the finest size by less
 * than a factor of 5 in E along the last two, where those fall at first order or faster.  Sizes that failed are left
 * out. */
static struct reach reach(const struct peers_row *row, int many, double E) {
    const struct peers_runs *a = NULL, *b = NULL;
    double ratio = 1; /* of the two sizes */
    for (int i = 0, last = 0; row && i < row->sizes && !(a && b->error <= E); i++) {
        if (!row->size[i].with[many].count) continue;
        a = b;
        b = &row->size[i].with[many];
        ratio = (double)row->size[i].n / row->size[last].n;
        last = i;
    }
    if (!a || a->error < E) return (struct reach){0};
    struct reach r = {.beyond = b->error > E};
    if (r.beyond && (b->error > BEYOND * E || log(a->error / b->error) / log(ratio) < 1)) return (struct reach){0};
    double part = log(E / a->error) / log(b->error / a->error);
    r.time.median = between(a->time.median, b->time.median, part);
    r.time.lowest = between(a->time.lowest, b->time.lowest, part);
    r.time.highest = between(a->time.highest, b->time.highest, part);
    return r;
}

static struct reach at_size(const struct peers_row *row, int n) {
    for (int i = 0; row && i < row->sizes; i++)
        if (row->size[i].n == n) return (struct reach){.time = row->size[i].with[0].time};
    return (struct reach){0};
}

static void add_seconds(struct table *t, struct reach r) {
    if (r.time.median > 0)
        table_add(t, "%s%.3g", r.beyond ? "~" : "", r.time.median);
    else
        table_add(t, "-");
}

static void print_scene(const struct peers *all, const char *scene, FILE *out) {
    char header[200];
    snprintf(header, sizeof header,
             "%s: solve [s] at E1 =|order, and its gate|1e-3|5e-4|5e-5|%d threads: 1e-3|5e-4|5e-5|start-up [s]",
             scene, all->threads);
    struct table t = table_headed(1, header);
    for (const struct peers_row *row = NULL; (row = next(all, row, scene, ""));) {
        if (row->peer->kind == PEERS_RATE) continue;
        table_add(&t, "%s|%s", row->peer->who, row->order);
        for (int i = 0; i < ERRORS; i++) add_seconds(&t, reach(row, 0, error_at[i]));
        for (int i = 0; i < ERRORS; i++)
            if (row->peer->serial || all->threads == 1)
                table_add(&t, "as one");
            else
                add_seconds(&t, reach(row, 1, error_at[i]));
        int starts = row->peer->kind == PEERS_THEIRS && row->size[0].with[0].count;
        table_number(&t, "%.2g", starts ? fmax(row->size[0].with[0].start_up, 0.001) : NAN, " ");
    }
    table_end(&t, out);
    fputc('\n', out);
}

/* ---- What was aimed at: on square-step, with one thread ---- */

struct aim {
    double times, whole; /* faster; without symmetry, 0 for none */
};

static void add_verdict(struct table *t, double ratio, double aim) {
    table_number(t, "%g", aim > 0 ? aim : NAN, " ");
    table_add(t, "%s", aim == 0 ? " " : isnan(ratio) ? "unknown" : ratio >= aim ? "held" : "missed");
}

/* How many times faster ours is; `whole`: ours without symmetry. */
static void add_aim(struct table *t, struct reach theirs, struct reach ours, struct reach whole, struct aim aim) {
    int known = theirs.time.median > 0 && ours.time.median > 0;
    struct bench_time ratio = bench_ratio(theirs.time, ours.time);
    double alone = known && whole.time.median > 0 ? theirs.time.median / whole.time.median : NAN;
    table_number(t, "%.3g", known ? ratio.median : NAN, "-");
    if (known)
        table_add(t, "%.3g to %.3g", ratio.lowest, ratio.highest);
    else
        table_add(t, " ");
    add_verdict(t, known ? ratio.median : NAN, aim.times);
    table_number(t, "%.3g", alone, " ");
    add_verdict(t, alone, aim.whole);
    add_seconds(t, ours);
    add_seconds(t, theirs);
}

/* At the error E, beside the fastest of those whose name begins so, which were measured there or else reach beyond.
 */
static void aim_error(const struct peers *all, struct table *t, const char *ours, const char *begins, double E,
                      struct aim aim) {
    const char *scene = "square-step";
    char whole[60];
    struct reach best = {0};
    const struct peers_row *who = NULL, *row = NULL;
    while ((row = next(all, row, scene, begins))) {
        struct reach r = reach(row, 0, E);
        if (row->peer->kind != PEERS_THEIRS || r.time.median == 0) continue;
        if (who && (r.beyond != best.beyond ? r.beyond : r.time.median > best.time.median)) continue;
        best = r;
        who = row;
    }
    snprintf(whole, sizeof whole, "%s unfolded", ours);
    table_add(t, "%s at E1 = %g, %s", ours, E, who ? who->peer->who : *begins ? begins : "the fastest");
    add_aim(t, best, reach(next(all, NULL, scene, ours), 0, E), reach(next(all, NULL, scene, whole), 0, E), aim);
}

/* The plate has no symmetry to do without. */
static void aim_sizes(const struct peers *all, struct table *t, const char *scene) {
    const struct peers_row *ours = next(all, NULL, scene, "so_ssph exact"),
                           *whole = next(all, NULL, scene, "so_ssph exact unfolded"),
                           *theirs = next(all, NULL, scene, "SciPy DST");
    for (int i = 0; ours && i < ours->sizes; i++) {
        int n = ours->size[i].n;
        table_add(t, "so_ssph exact, %s at n = %d, SciPy DST", scene, n);
        add_aim(t, at_size(theirs, n), at_size(ours, n), at_size(whole, n),
                (struct aim){1, !whole    ? 0
                                : n < 576 ? 1
                                          : 3});
    }
}

/* Seconds an update. */
static struct reach update(const struct peers_row *row) {
    const struct peers_runs *runs = row ? &row->size[row->sizes - 1].with[0] : NULL;
    if (!runs || !runs->count) return (struct reach){0};
    double each = 1 / runs->updates;
    return (struct reach){{each * runs->time.median, each * runs->time.lowest, each * runs->time.highest}, 0};
}

static void print_aims(const struct peers *all, FILE *out) {
    struct table t = table_headed(1, "aims on square-step if not said, one thread|times faster|lowest to "
                                     "highest|aim|verdict|without symmetry|aim|verdict|ours [s]|theirs [s]");
    const struct peers_row *theirs = next(all, NULL, "square-step", "PySPH Brookshaw cubic kernel"), *row = NULL;
    for (int i = 0; i < ERRORS; i++) aim_error(all, &t, "so_ssph rkl2", "SUNDIALS", error_at[i], (struct aim){10, 3});
    aim_error(all, &t, "so_ssph matched", "", error_at[ERRORS - 1], (struct aim){100, 0});
    aim_sizes(all, &t, "square-step");
    aim_sizes(all, &t, "plate");
    while ((row = next(all, row, "square-step", "brookshaw"))) {
        table_add(&t, "an update of %s, PySPH", row->peer->who);
        add_aim(&t, update(theirs), update(row), (struct reach){0}, (struct aim){20, 0});
    }
    table_end(&t, out);
    fputc('\n', out);
}

/* ---- What went wrong ---- */

static void print_failures(const struct peers *all, FILE *out) {
    int failed = 0;
    for (const struct peers_row *row = all->row; row->peer; row++) {
        const struct peer *p = row->peer;
        if (row->missing) fprintf(out, "not installed (make setup-peers): %s on %s\n", p->who, p->scene);
        for (int k = 0; k < 2 * row->sizes; k++) {
            const struct peers_size *s = &row->size[k / 2];
            if (*s->with[k % 2].failure)
                failed = fprintf(out, "failed: %s, %s, n = %d, %s: %s\n", p->scene, p->who, s->n,
                                 k % 2 ? "all threads" : "one thread", s->with[k % 2].failure);
        }
    }
    if (!failed) fprintf(out, "No run failed.\n");
}

static const char notes[] = "\norder: the suite's verdict on its slope.  -: not reached; ~: beyond the finest size; "
                            "as one: it knows no threads or is\n"
                            "the slower of two.  start-up: at the first size, with writing and reading the answer; "
                            "ours has none.  unfolded: ours\n"
                            "without symmetry, as the others always.  Times are medians of up to nine solves, each "
                            "after 0.1 s of the same, with the\n"
                            "loosest tolerance whose error is within 5 % of the tightest's.  An update is that of "
                            "the time loop; PySPH's has the\n"
                            "search for neighbours in it, once, 2 % of it.  SUNDIALS as packaged is compiled without "
                            "optimisation: the stand-in\n"
                            "brings its own vector kernels and right-hand side, compiled at -O3 -march=native.  "
                            "PySPH keeps h/dx = 1.1 and the\n"
                            "volume dx^2, and its fixed ghosts make a wall first order.\n";

static void print_versions(FILE *out) {
    FILE *in = popen(peers_versions, "r");
    char *text = in ? whole_file_read(in, NULL) : NULL;
    if (text) fputs(text, out);
    free(text);
    if (in) pclose(in);
}

void peers_print(const struct peers *all, FILE *out) {
    bench_print_machine(out);
    print_versions(out);
    fprintf(out, "times with all threads mean little unless the machine was theirs\n\n");
    for (const struct peers_row *row = all->row; row->peer; row++)
        if (row == all->row || strcmp(row->peer->scene, row[-1].peer->scene)) print_scene(all, row->peer->scene, out);
    print_aims(all, out);
    print_failures(all, out);
    fputs(notes, out);
}

void peers_print_data(const struct peers *all, const char *scene, int many, FILE *out) {
    fprintf(out, "# title: %s: others beside ours, %s\n# command: make bench-peers\n", scene,
            many ? "all threads" : "one thread");
    int blocks = 0;
    for (const struct peers_row *row = NULL; (row = next(all, row, scene, ""));) {
        const struct peer *p = row->peer;
        if (p->kind == PEERS_WHOLE || p->kind == PEERS_RATE) continue;
        int alone = many && p->serial;
        const char *note = alone ? " (one thread)" : "";
        fprintf(out, "%s# %s\nn,E1 [-],solve [s],%s%s\n", blocks++ ? "\n\n" : "", p->who, p->who, note);
        for (const struct peers_size *s = row->size; s < row->size + row->sizes; s++) {
            const struct peers_runs *runs = &s->with[many && !alone];
            if (runs->count) fprintf(out, "%d,%.17g,%.6e,%s%s\n", s->n, runs->error, runs->time.median, p->who, note);
        }
    }
}
