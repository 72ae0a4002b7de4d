/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stability: limits against h/dx (published, von Neumann, measured, by method, kernel and dimension); clouds under
 * jitter (the worst condition number, the sign of the largest real part); the blow-up that a published bound allows;
 * the checkerboard over time. */
#include "reports/stability/stability.h"

#include "reports/figure/figure.h"
#include "solver/particles/ssph.h"
#include "verification/stability/step_limit.h"
#include "verification/text/output.h"

#include <math.h>
#include <stdlib.h>

/* A method by its name, with a kernel and an h/dx (0: the default), defaults not yet resolved. */
static struct model_problem model_of(const char *method, int dim, enum kernel_name kernel, double h) {
    return (struct model_problem){.method = method_find(method), .dim = dim, .options = {.kernel = kernel, .h = h}};
}

/* ---- Limits ---- */

enum { RATIOS = 101, METHODS = 3, KERNELS = 3, DIMS = 2, CASES = DIMS * METHODS * KERNELS * RATIOS };
static const char *const limited[METHODS] = {"so_ssph", "fo_ssph", "brookshaw"};

static double ratio_of(int k) {
    return 0.5 + 0.025 * k;
}

struct point {
    int found; /* 0: refused */
    struct step_limit limit;
};

static void find_limit(int i, struct point *point) {
    struct failure why;
    int k = i % RATIOS, kernel = i / RATIOS % KERNELS, method = i / (RATIOS * KERNELS) % METHODS;
    int dim = 1 + i / (RATIOS * KERNELS * METHODS);
    struct model_problem b = model_of(limited[method], dim, (enum kernel_name)kernel, ratio_of(k));
    struct step_limit *l = &point->limit;
    point->found = !step_limit_model(&b, &why) && !step_limit_predict(&b, l, &why);
    /* by trying: every 0.1 on a rod; on a square every 0.25, and every 0.5 past 1.5 */
    int stride = dim == 1 ? 4 : k <= 40 ? 10 : 20;
    if (point->found && k % stride == 0) step_limit_measure(&b, &l->measured, &why);
}

static void put_limit(FILE *out, const struct point *point, double h) {
    const struct step_limit *l = &point->limit;
    if (!point->found)
        fprintf(out, "%.4g,nan,nan,nan,nan,nan\n", h);
    else
        fprintf(out, "%.4g,%.6g,%.6g,%.6g,%.6g,%.3g\n", h, l->published, l->von_neumann, l->measured, l->beta,
                fmax(0, l->grows * l->growth));
}

static int put_differences(FILE *out, struct failure *why) {
    static const char *const method[] = {"ftcs", "ftcs_flux"};
    for (int i = 0; i < 4; i++) {
        struct model_problem b = model_of(method[i % 2], 1 + i / 2, KERNEL_CUBIC, 0);
        struct step_limit l;
        if (step_limit_model(&b, why) || step_limit_predict(&b, &l, why) || step_limit_measure(&b, &l.measured, why))
            return why->status;
        figure_block(out, "published,von_neumann,measured", "%s %dD", method[i % 2], b.dim);
        fprintf(out, "%.6g,%.6g,%.6g\n", l.published, l.von_neumann, l.measured);
    }
    return STATUS_OK;
}

static int write_limits(FILE *out, struct failure *why) {
    struct point *point = xcalloc(CASES, sizeof *point);
    figure_head(out, "The largest stable step: published, by von Neumann's analysis, by trying",
                "limit so_ssph --dim 1 --kernel quartic --h 1.1");
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < CASES; i++) find_limit(CASES - 1 - i, &point[CASES - 1 - i]); /* the widest stencils first */
    for (int i = 0; i < CASES; i++) {
        if (i % RATIOS == 0)
            figure_block(out, "h/dx,published,von_neumann,measured,beta,growth", "%s %s %dD",
                         limited[i / (RATIOS * KERNELS) % METHODS], kernel_words[i / RATIOS % KERNELS],
                         1 + i / (RATIOS * KERNELS * METHODS));
        put_limit(out, &point[i], ratio_of(i % RATIOS));
    }
    free(point);
    return put_differences(out, why);
}

/* ---- Jitter ---- */

enum { LENGTHS = 27, JITTERS = 11, SEEDS = 3, SIDE = 12, CLOUDS = 2 * JITTERS * LENGTHS };
static const char *const jittered[2] = {"so_ssph", "fo_ssph"};

struct cell {
    double condition, growth; /* the worst of the seeds; NaN growth where a cloud was refused */
};

static int worst_condition(const struct model_problem *b, const struct neighbourhood *nb, void *worst,
                           struct failure *why) {
    double *most = worst;
    (void)why;
    *most = fmax(*most, ssph_condition(nb, b->options.kernel, b->method->scheme->sweeps == 2 ? 1 : 2));
    return STATUS_OK;
}

static struct cell measure_cloud(const struct model_problem *b) {
    struct cell cell = {0, NAN};
    struct failure why;
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    struct cloud c;
    struct step_limit l;
    if (model_problem_cloud(b, &p, &c, &why)) return cell;
    model_problem_around(b, &c, c.n, worst_condition, &cell.condition, &why);
    layout_cloud_free(&c);
    if (!step_limit_predict(b, &l, &why)) cell.growth = l.grows ? l.growth : fmin(l.growth, 0);
    return cell;
}

static struct cell worst_of_seeds(int i) {
    struct cell worst = {0, -INFINITY};
    for (unsigned long seed = 1; seed <= SEEDS; seed++) {
        struct model_problem b =
            model_of(jittered[i / (LENGTHS * JITTERS)], 2, KERNEL_CUBIC, 0.7 + 0.05 * (i % LENGTHS));
        struct failure why;
        b.options.layout = LAYOUT_JITTER;
        b.options.jitter = 0.05 * (i / LENGTHS % JITTERS);
        b.options.seed = seed;
        if (model_problem_resolve(&b, SIDE, &why)) return (struct cell){NAN, NAN};
        struct cell cell = measure_cloud(&b);
        worst.condition = fmax(worst.condition, cell.condition);
        if (!(cell.growth <= worst.growth)) worst.growth = cell.growth;
        if (isnan(worst.growth)) break;
    }
    return worst;
}

static int write_jitter(FILE *out, struct failure *why) {
    (void)why;
    struct cell *cell = xcalloc(CLOUDS, sizeof *cell);
    figure_head(out, "Particles off the lattice, 2D, cubic kernel, the worst of three seeds",
                "limit fo_ssph --dim 2 --h 1.1 --layout jitter --jitter 0.2 --seed 3");
#pragma omp parallel for schedule(dynamic, 4)
    for (int i = 0; i < CLOUDS; i++) cell[CLOUDS - 1 - i] = worst_of_seeds(CLOUDS - 1 - i);
    for (int i = 0; i < CLOUDS; i++) {
        if (i % (LENGTHS * JITTERS) == 0)
            figure_block(out, "h/dx,jitter,log10(condition),growth_kappa/dx^2,sign (1 grows, -1 decays, nan refused)",
                         "%s", jittered[i / (LENGTHS * JITTERS)]);
        double sign = isnan(cell[i].growth) ? NAN : cell[i].growth > 0 ? 1 : -1;
        fprintf(out, "%.4g,%.4g,%.4g,%.4g,%.0f\n", 0.7 + 0.05 * (i % LENGTHS), 0.05 * (i / LENGTHS % JITTERS),
                log10(cell[i].condition), cell[i].growth, sign);
        if (i % LENGTHS == LENGTHS - 1) fputc('\n', out);
    }
    free(cell);
    return STATUS_OK;
}

/* ---- Blow-up ---- */

static const double DISTURBANCE = 1e-10; /* K */

/* The difference of a disturbed and an undisturbed run after this number of steps, K; NaN if one was refused. */
static double apart(const struct model_problem *b, double F, long long steps) {
    struct field f[2];
    struct failure why;
    struct options o = b->options;
    for (int i = 0; i < 2; i++) {
        struct problem p = model_problem_setup(b, MODEL_HILL, i * DISTURBANCE);
        p.t_end = F * (double)steps;
        o.dt = F;
        if (!method_solve(b->method, &p, &o, &f[i], &why)) continue;
        if (i) field_free(&f[0]);
        return NAN;
    }
    double most = field_farthest(&f[0], f[1].T);
    field_free(&f[0]);
    field_free(&f[1]);
    return most;
}

static int follow(FILE *out, const char *name, struct model_problem b, int stride, struct failure *why) {
    enum { POINTS = 100 };
    struct step_limit l;
    if (step_limit_model(&b, why) || step_limit_predict(&b, &l, why)) return why->status;
    const double F[2] = {0.99 * l.published, 0.99 * l.von_neumann};
    for (int k = 0; k < 2; k++) {
        double distance[POINTS];
        figure_block(out, "step,distance_K,F", "%s %s", name, k ? "true" : "published");
#pragma omp parallel for schedule(dynamic, 1)
        for (int i = 0; i < POINTS; i++) distance[i] = apart(&b, F[k], (long long)stride * (i + 1));
        for (int i = 0; i < POINTS && !isnan(distance[i]); i++)
            fprintf(out, "%d,%.6g,%.6g\n", stride * (i + 1), distance[i], F[k]);
    }
    return STATUS_OK;
}

static int write_blowup(FILE *out, struct failure *why) {
    figure_head(out, "A disturbance of 1e-10 K at 0.99 of the published bound, and at 0.99 of the true one",
                "limit so_ssph --dim 1 --kernel quartic --h 1.1");
    fprintf(out, "# command: heatladder limit ftcs --dim 2\n");
    if (follow(out, "so_ssph", model_of("so_ssph", 1, KERNEL_QUARTIC, 1.1), 10, why)) return why->status;
    return follow(out, "ftcs", model_of("ftcs", 2, KERNEL_CUBIC, 0), 1, why);
}

/* ---- The checkerboard over time: what of the jump of rod-step oscillates, and for how long ---- */

#define OVER_TIME(name, words)                                                                                       \
    FIGURE_READ(name, "run rod-step " words " --t-end %s", "t_s,checkerboard/peak,total_variation/peak,peak_K",      \
                "t_end checkerboard/max variation/max max", times)
#define PLACES(method, more)                                                                                         \
    OVER_TIME(method " midway", method " --dx 4/80" more), OVER_TIME(method " quarter", method " --dx 4/82" more),   \
        OVER_TIME(method " on", method " --dx 4/84" more)

static const char *const times[] = {/* seven a decade */
                                    "0.01",      "0.0140241", "0.0196675", "0.027582", "0.0386812", "0.0542469",
                                    "0.0760764", "0.10669",   "0.149624",  "0.209834", "0.294273",  "0.412691",
                                    "0.578762",  "0.811662",  "1.13828",   "1.59634",  "2.23872",   "3.1396",
                                    "4.40301",   "6.17483",   "8.65964",   "12.1444",  "17.0314",   "23.885",
                                    "33.4965",   "46.9759",   "65.8795",   "92.39",    "129.569",   "181.708",
                                    "254.83",    "357.376",   "501.187",   NULL};

static const struct figure_series checkerboard[] = {PLACES("fo_ssph", ""),
                                                    PLACES("so_ssph", ""),
                                                    PLACES("ftcs", " --fourier 0.2"),
                                                    PLACES("ftcs_flux", " --fourier 0.2"),
                                                    {0}};

int stability_write(const char *dir, struct failure *why) {
    static const struct figure_page pages[] = {
        {"stability_limits", write_limits}, {"stability_jitter", write_jitter}, {"stability_blowup", write_blowup}};
    static const struct figure over_time = {"stability_checkerboard",
                                            "The jump of rod-step: what oscillates, and for how long", checkerboard};
    if (output_directory(dir, "stability_limits.csv", why) || figure_pages(pages, 3, dir, why)) return why->status;
    return figure_write(&over_time, dir, why);
}
