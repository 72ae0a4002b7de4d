/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls that cut the lattice at arbitrary positions: accuracy and stability of each treatment with so_ssph.
 *
 * Round walls: eight lattices (origin and angle by seeds 1 to 8) at each spacing, in one fit of the order; steps and
 * growth from all eigenvalues of the operator at dx = 0.125, the worst of four lattices.  Plane walls: rod-cooling
 * (Dirichlet and Robin), rod-cosine (Neumann) and plate-cooling, at the offsets 0, 0.1, ... 0.9 of the lattice. */
#include "reports/walls/walls_study.h"

#include "reports/figure/document.h"
#include "reports/figure/figure.h"
#include "reports/figure/reading.h"
#include "solver/method.h"
#include "solver/particles/particles.h"
#include "solver/space/assembly.h"
#include "solver/time/stepper.h"
#include "verification/case/command.h"
#include "verification/judge/slope.h"
#include "verification/stability/spectrum.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <omp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- The price of a treatment: the stable step and growth, and the amplification by dummies ---- */

struct price {            /* the worst of some runs */
    double limit, growth; /* dx^2/kappa, kappa/dx^2 */
    double amplification; /* largest sum of the |shares| of a dummy */
};

/* The amplification of the particles' errors in a dummy: the largest sum of |share|. */
static void take_dummies(const struct cloud *c, struct price *price) {
    size_t dummies = c->begin ? c->total - c->n : 0;
    for (size_t j = 0; j < dummies; j++) {
        double sum = 0;
        for (size_t k = c->begin[j]; k < c->begin[j + 1]; k++) sum += fabs(c->share[k]);
        price->amplification = fmax(price->amplification, sum);
    }
}

/* The operator of a request's run, all eigenvalues. */
static int take_spectrum(const struct experiment *e, struct price *price, struct failure *why) {
    struct options o;
    struct lattice l;
    struct cloud c;
    struct heat_operator a;
    struct spectrum s;
    int rows;
    const struct scheme *scheme = e->method->scheme;
    double unit = problem_diffusivity(&e->problem) / (e->options.dx * e->options.dx);
    if (particles_prepare(&e->problem, &e->options, scheme, &o, &l, &rows, why)) return why->status;
    if (particles_cloud(&e->problem, &o, scheme, &l, &c, why)) return why->status;
    int status = assembly_operator(&a, &e->problem, &o, scheme, &c, l.dx[0], why);
    take_dummies(&c, price);
    layout_cloud_free(&c);
    if (status) return status;
    status = spectrum_create(&s, &a, &(struct amplification){stepper_auto(1, 1, 0), 0}, why);
    operator_free(&a);
    if (status) return status;
    price->limit = fmin(price->limit, s.limit * unit);
    price->growth = fmax(price->growth, s.growth > spectrum_rounding(&s) ? s.growth / unit : 0);
    spectrum_free(&s);
    return STATUS_OK;
}

/* Raises *price to that of the run of a command (printf-like) where that is worse; it starts with the limit INFINITY.
 */
static int take_price(struct price *price, struct failure *why, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static int take_price(struct price *price, struct failure *why, const char *format, ...) {
    char line[240];
    struct command r;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    int status = command_read(line, &r, why);
    if (!status) status = take_spectrum(&r.experiment, price, why);
    command_free(&r);
    return status;
}

/* ---- Round walls ---- */

enum { TREATMENTS = 7 };
static const char *const treatments[TREATMENTS] = {"mirror", "fixed", "distance", "average",
                                                   "image",  "fit",   "one_sided"};
static const struct body {
    const char *name, *scene, *set;
    const char *derived[TREATMENTS]; /* order in E1; NULL: refused */
} bodies[] = {
    {"disc held", "disc-mode", " --set wall=1", {NULL, "1", "1", "1", "2", "2", "2"}},
    {"disc flux", "disc-mode", " --set wall=2", {NULL, NULL, NULL, "1", "1", "2", "2"}},
    {"disc cooled", "disc-mode", " --set wall=3", {NULL, NULL, NULL, NULL, "1", "2", "2"}},
    {"annulus held and flux", "annulus", "", {NULL, NULL, NULL, "1", "1", "2", "2"}},
};
static const double spacings[] = {0.1, 0.07, 0.05, 0.035, 0.025};
enum { BODIES = 4, SPACINGS = 5, SEEDS = 8, RUNS = SPACINGS * SEEDS, SPECTRA = 4 };

struct entry { /* one treatment at one body */
    double dx[RUNS], E1[RUNS], largest[RUNS], work[RUNS], drift[RUNS], neighbours[RUNS]; /* work: interactions */
    struct price price;
};

static int take_entry(const struct body *b, const char *walls, struct entry *e, struct failure *why) {
    struct reading r[RUNS];
    for (int k = 0; k < RUNS; k++)
        reading_set(&r[k], "run %s so_ssph%s --walls %s --seed %d --dx %g", b->scene, b->set, walls, 1 + k % SEEDS,
                    spacings[k / SEEDS]);
    int status = reading_run(r, RUNS, why);
    for (int k = 0; k < RUNS; k++) {
        e->dx[k] = spacings[k / SEEDS];
        e->E1[k] = reading_value(&r[k], "error_l1"), e->largest[k] = reading_value(&r[k], "error_linf");
        e->work[k] = reading_value(&r[k], "interactions"),
        e->drift[k] = fmax(0, fabs(reading_value(&r[k], "heat_drift"))); /* 0 for NaN */
        e->neighbours[k] = reading_value(&r[k], "interactions/updates");
    }
    reading_free(r, RUNS);
    e->price.limit = INFINITY;
    for (int seed = 1; seed <= SPECTRA && !status; seed++)
        status = take_price(&e->price, why, "run %s so_ssph%s --walls %s --seed %d --dx 0.125 --stepper euler",
                            b->scene, b->set, walls, seed);
    return status;
}

/* Checks that such a run is refused, as the table states. */
static int check_refusal(const struct body *b, const char *walls, struct failure *why) {
    struct reading r;
    reading_set(&r, "run %s so_ssph%s --walls %s --dx 0.1", b->scene, b->set, walls);
    int status = reading_run(&r, 1, why);
    reading_free(&r, 1);
    if (status == STATUS_NOT_APPLICABLE) return STATUS_OK;
    return refuse(why, STATUS_NUMERICAL, "heatladder %.100s was to be refused: status %d", r.command, status);
}

/* Mean and most over the eight lattices at the finest spacing. */
static double mean_of(const double *x) {
    return gsl_stats_mean(x + RUNS - SEEDS, 1, SEEDS);
}

static double most_of(const double *x) {
    return gsl_stats_max(x + RUNS - SEEDS, 1, SEEDS);
}

static void put_row(const char *walls, const char *derived, const struct entry *e, struct table *t) {
    table_add(t, "`%s`|%s", walls, derived ? derived : "refused");
    if (!derived) {
        table_add(t, "%s|%s|%s|%s|%s|%s|%s|%s|%s", "", "", "", "", "", "", "", "", "");
        return;
    }
    struct slope s = slope_fit(e->dx, e->E1, RUNS), m = slope_fit(e->dx, e->largest, RUNS);
    table_add(t, "%.2f|%.2f to %.2f|%.2f", s.value, s.ci[0], s.ci[1], m.value);
    table_add(t, "%.2e|%.2e|%.3f|%.2g, %.1e", mean_of(e->E1), most_of(e->largest), e->price.limit, e->price.growth,
              most_of(e->drift));
    table_add(t, "%.1f|%.1f", mean_of(e->neighbours), e->price.amplification);
}

static void put_round(const struct entry *all, struct document *d) {
    document_text(d,
                  "`so_ssph`, h/dx 1.1, eight lattices of random origin and angle at each of dx = 0.1 to 0.025 m. "
                  "Errors at 0.025 m: the mean E1, and the largest error of all. Step and growth by eigenvalues at "
                  "0.125 m, the worst of four lattices. Amplification: the largest sum of |share| of a dummy.");
    for (int b = 0; b < BODIES; b++) {
        struct table t = table_headed(
            2, "--walls|order derived|order of E1|95 % interval|order of the largest error|E1|largest error, "
               "K|step, dx^2/kappa|growth, kappa/dx^2; heat drift|neighbours|amplification");
        for (int k = 0; k < TREATMENTS; k++)
            put_row(treatments[k], bodies[b].derived[k], &all[b * TREATMENTS + k], &t);
        document_heading(d, "%s (%s%s)", bodies[b].name, bodies[b].scene, bodies[b].set);
        document_table(d, &t);
    }
}

static void write_errors(const struct entry *all, FILE *out) {
    figure_head(out, "so_ssph, walls that cut the lattice: error by treatment of the wall",
                "run disc-mode so_ssph --set wall=1 --walls fit --seed 1 --dx 0.1");
    for (int k = 0; k < BODIES * TREATMENTS; k++) {
        char columns[60];
        if (!bodies[k / TREATMENTS].derived[k % TREATMENTS]) continue;
        snprintf(columns, sizeof columns, "dx,%s,interactions", treatments[k % TREATMENTS]);
        figure_block(out, columns, "%s, %s", treatments[k % TREATMENTS], bodies[k / TREATMENTS].name);
        for (int i = 0; i < RUNS; i += SEEDS)
            fprintf(out, "%g,%.5e,%.5e\n", all[k].dx[i], gsl_stats_mean(all[k].E1 + i, 1, SEEDS),
                    gsl_stats_mean(all[k].work + i, 1, SEEDS));
    }
}

static int take_all(struct entry *all, struct failure *why) {
    int status = STATUS_OK;
    for (int k = 0; k < BODIES * TREATMENTS && !status; k++) {
        const struct body *b = &bodies[k / TREATMENTS];
        const char *walls = treatments[k % TREATMENTS];
        status = b->derived[k % TREATMENTS] ? take_entry(b, walls, &all[k], why) : check_refusal(b, walls, why);
    }
    return status;
}

/* ---- Plane walls ---- */

enum { OFFSETS = 10, RUNGS = 4 };
static const struct rod {
    const char *scene, *walls, *derived; /* order in E1 */
    double length;
} rods[] = {
    {"rod-cooling", "mirror", "2", 0.3},    {"rod-cooling", "image", "1", 0.3}, {"rod-cooling", "fit", "2", 0.3},
    {"rod-cooling", "one_sided", "2", 0.3}, {"rod-cosine", "mirror", "2", 1},   {"rod-cosine", "average", "1", 1},
    {"rod-cosine", "image", "1", 1},        {"rod-cosine", "fit", "2", 1},      {"rod-cosine", "one_sided", "2", 1}};

/* All offsets of a rod; for rod-cooling also the mean errors by spacing and work, to `error`. */
static int take_rod(const struct rod *rod, FILE *out, struct table *t, FILE *error, struct failure *why) {
    double order[OFFSETS], last[OFFSETS], step[OFFSETS], mean[RUNGS] = {0}, work[RUNGS] = {0}, dx[RUNGS], growth = 0;
    figure_block(out, "offset,order,low,high,E1,step", "%s %s", rod->scene, rod->walls);
    for (int s = 0; s < OFFSETS; s++) {
        double E1[RUNGS];
        struct reading r[RUNGS];
        struct price price = {.limit = INFINITY};
        for (int n = 0; n < RUNGS; n++)
            reading_set(&r[n], "run %s so_ssph --walls %s --shift 0.%d --dx %g/%d", rod->scene, rod->walls, s,
                        rod->length, 20 << n);
        int status = reading_run(r, RUNGS, why);
        for (int n = 0; n < RUNGS; n++) {
            dx[n] = rod->length / (20 << n), E1[n] = reading_value(&r[n], "error_l1");
            mean[n] += E1[n] / OFFSETS, work[n] += reading_value(&r[n], "interactions") / OFFSETS;
        }
        reading_free(r, RUNGS);
        if (!status)
            status = take_price(&price, why, "run %s so_ssph --walls %s --shift 0.%d --dx %g/80 --stepper euler",
                                rod->scene, rod->walls, s, rod->length);
        if (status) return status;
        struct slope fit = slope_fit(dx, E1, RUNGS);
        order[s] = fit.value, last[s] = E1[RUNGS - 1], step[s] = price.limit, growth = fmax(growth, price.growth);
        fprintf(out, "0.%d,%.4f,%.4f,%.4f,%.4e,%.4f\n", s, fit.value, fit.ci[0], fit.ci[1], last[s], step[s]);
    }
    gsl_sort(order, 1, OFFSETS);
    table_add(t, "%s|`%s`|%s|%.2f [%.2f, %.2f]", rod->scene, rod->walls, rod->derived,
              gsl_stats_median_from_sorted_data(order, 1, OFFSETS), order[0], order[OFFSETS - 1]);
    table_add(t, "%.2e|%.2e|%.3f to %.3f|%.2g", mean[RUNGS - 1], gsl_stats_max(last, 1, OFFSETS),
              gsl_stats_min(step, 1, OFFSETS), gsl_stats_max(step, 1, OFFSETS), growth);
    if (strcmp(rod->scene, "rod-cooling") != 0) return STATUS_OK;
    char columns[60];
    snprintf(columns, sizeof columns, "dx,%s,interactions", rod->walls);
    figure_block(error, columns, "%s, rod-cooling", rod->walls);
    for (int n = 0; n < RUNGS; n++) fprintf(error, "%g,%.5e,%.5e\n", dx[n], mean[n], work[n]);
    return STATUS_OK;
}

static int write_offsets(FILE *out, struct document *d, FILE *error, struct failure *why) {
    struct table t = table_headed(
        3, "scene|--walls|order derived|order of E1|E1, mean|E1, largest|step, dx^2/kappa|growth, kappa/dx^2");
    int status = STATUS_OK;
    figure_head(out, "Plane walls anywhere, so_ssph: order of E1 against the lattice's offset",
                "ladder rod-cooling so_ssph --walls fit --shift 0.3 --dx 0.3/20,0.3/40,0.3/80,0.3/160");
    for (size_t k = 0; k < sizeof rods / sizeof *rods && !status; k++)
        status = take_rod(&rods[k], out, &t, error, why);
    document_heading(d, "Plane walls");
    document_text(
        d, "Offsets 0, 0.1, ... 0.9 of the lattice, dx = L/20 ... L/160: order of E1, the median and the range "
           "of ten; at L/160 the mean E1 and the largest of ten; at L/80 the largest stable step, the least "
           "and the most of ten, by all eigenvalues (0.537 without walls), and the growth.");
    document_table(d, &t);
    return status;
}

/* In a plane the fastest mode is the fastest mode of both axes.  A treatment therefore reduces the step of the plane
 * by the same factor as that of a rod: 0.525 dx^2/kappa without walls, compared with 0.537 for the rod. */
static int put_steps(struct document *d, struct failure *why) {
    static const char *const walls[] = {"mirror", "image", "fit", "one_sided"};
    struct table t = table_headed(1, "--walls|step, least|step, most|growth");
    int status = STATUS_OK;
    for (int k = 0; k < 4; k++) {
        double step[OFFSETS] = {0}, growth = 0;
        for (int s = 0; s < OFFSETS && !status; s++) {
            struct price price = {.limit = INFINITY};
            status =
                take_price(&price, why, "run plate-cooling so_ssph --walls %s --shift 0.%d --dx 1/15 --stepper euler",
                           walls[k], s);
            step[s] = price.limit, growth = fmax(growth, price.growth);
        }
        table_add(&t, "`%s`|%.3f|%.3f|%.2g", walls[k], gsl_stats_min(step, 1, OFFSETS),
                  gsl_stats_max(step, 1, OFFSETS), growth);
    }
    document_heading(d, "plate-cooling --dx 1/15");
    document_text(d,
                  "The largest stable step of ten offsets, the same on both axes, by all eigenvalues (0.525 without "
                  "walls), dx^2/kappa; the growth in kappa/dx^2.");
    document_table(d, &t);
    return status;
}

/* ---- All ---- */

#define ON_DISC(walls)                                                                                               \
    FIGURE_FIELD(walls, "run disc-mode so_ssph --walls " walls " --seed 1 --dx 0.05", FIGURE_ERROR, 0)
static const struct figure_series on_disc[] = {ON_DISC("fixed"), ON_DISC("average"), ON_DISC("fit"), {0}};
static const struct figure field = {
    "walls_field", "so_ssph on a disc whose wall is held, dx = 0.05 m: |T - T exact|, K, by treatment of the wall",
    on_disc};

static int write_pages(const struct entry *all, const char *dir, struct failure *why) {
    struct output data[2];
    struct document d;
    document_open(&d, dir, "walls", "Walls that cut the lattice anywhere");
    FILE *error = output_open(&data[0], "%s/walls_error.csv", dir);
    FILE *offset = output_open(&data[1], "%s/walls_offset.csv", dir);
    put_round(all, &d);
    write_errors(all, error);
    int status = write_offsets(offset, &d, error, why);
    if (!status) status = put_steps(&d, why);
    if (!status) status = output_close(data, 2, why);
    if (!status) status = document_close(&d, why);
    output_drop(data, 2);
    document_drop(&d);
    return status;
}

int walls_study_write(const char *dir, struct failure *why) {
    double start = omp_get_wtime();
    if (output_directory(dir, "walls.md", why)) return why->status;
    struct entry *all = xcalloc(BODIES * TREATMENTS, sizeof *all);
    int status = take_all(all, why);
    if (!status) status = write_pages(all, dir, why);
    if (!status) status = figure_write(&field, dir, why);
    free(all);
    if (!status) printf("%s/walls.md, data of four figures (%.1f s)\n", dir, omp_get_wtime() - start);
    return status;
}
