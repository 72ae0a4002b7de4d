/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Maps: |G| over the wave-number square; under jitter, the worst condition number and the sign of the largest real
 * part; and what walls without ghosts do to the spectrum. */
#include "reports/stability/stability.h"

#include "solver/particles/ssph.h"
#include "verification/stability/step_limit.h"
#include "verification/stability/spectrum.h"
#include "verification/stability/symbol.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct map {
    const char *name, *method;
    enum kernel_name kernel;
    double h, share; /* F is `share` of the true limit; of the published one where it is negative */
};

static const struct map maps[] = {
    {"so_ssph cubic", "so_ssph", KERNEL_CUBIC, 1.1, 1},
    {"fo_ssph cubic", "fo_ssph", KERNEL_CUBIC, 1.1, 1},
    {"brookshaw cubic", "brookshaw", KERNEL_CUBIC, 1.2, 1},
    {"ftcs published", "ftcs", KERNEL_CUBIC, 0, -1},
};

static int write_map(FILE *out, const struct map *m, struct failure *why) {
    enum { CELLS = 96 };
    struct model_problem b = stability_model(m->method, 2, m->kernel, m->h);
    struct symbol s;
    struct step_limit l;
    if (step_limit_model(&b, why) || step_limit_predict(&b, &l, why) || symbol_create(&s, &b, why))
        return why->status;
    double F = m->share < 0 ? -m->share * l.published : m->share * l.von_neumann;
    char columns[80];
    snprintf(columns, sizeof columns, "theta_x/pi,theta_y/pi,|G| at F = %.4g", F);
    stability_block(out, columns, "%s", m->name);
    for (int j = 0; j <= CELLS; j++) {
        for (int i = 0; i <= CELLS; i++) {
            double part[2] = {2.0 * i / CELLS - 1, 2.0 * j / CELLS - 1};
            double theta[2] = {M_PI * part[0], M_PI * part[1]};
            fprintf(out, "%.5g,%.5g,%.5g\n", part[0], part[1],
                    cabs(amplification_factor(&b.step, F * symbol_at(&s, theta))));
        }
        fputc('\n', out);
    }
    symbol_free(&s);
    return STATUS_OK;
}

int stability_symbols_page(FILE *out, struct failure *why) {
    stability_head(out, "What one step of Euler's method does to each wave, in two dimensions",
                   "limit so_ssph --dim 2 --h 1.1");
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++)
        if (write_map(out, &maps[i], why)) return why->status;
    return STATUS_OK;
}

/* ---- Jitter ---- */

enum { RATIOS = 27, JITTERS = 11, SEEDS = 3, SIDE = 12, METHODS = 2 };
static const char *const jittered[METHODS] = {"so_ssph", "fo_ssph"};

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
            stability_model(jittered[i / (RATIOS * JITTERS)], 2, KERNEL_CUBIC, 0.7 + 0.05 * (i % RATIOS));
        struct failure why;
        b.options.layout = LAYOUT_JITTER;
        b.options.jitter = 0.05 * (i / RATIOS % JITTERS);
        b.options.seed = seed;
        if (model_problem_resolve(&b, SIDE, &why)) return (struct cell){NAN, NAN};
        struct cell cell = measure_cloud(&b);
        worst.condition = fmax(worst.condition, cell.condition);
        if (!(cell.growth <= worst.growth)) worst.growth = cell.growth;
        if (isnan(worst.growth)) break;
    }
    return worst;
}

int stability_jitter_page(FILE *out, struct failure *why) {
    (void)why;
    enum { CASES = RATIOS * JITTERS * METHODS };
    struct cell *cell = xcalloc(CASES, sizeof *cell);
    stability_head(out, "Particles off the lattice, 2D, cubic kernel, the worst of three seeds",
                   "limit fo_ssph --dim 2 --h 1.1 --layout jitter --jitter 0.2 --seed 3");
#pragma omp parallel for schedule(dynamic, 4)
    for (int i = 0; i < CASES; i++) cell[CASES - 1 - i] = worst_of_seeds(CASES - 1 - i);
    for (int i = 0; i < CASES; i++) {
        if (i % (RATIOS * JITTERS) == 0)
            stability_block(out,
                            "h/dx,jitter,log10(condition),growth_kappa/dx^2,sign (1 grows, -1 decays, nan refused)",
                            "%s", jittered[i / (RATIOS * JITTERS)]);
        double sign = isnan(cell[i].growth) ? NAN : cell[i].growth > 0 ? 1 : -1;
        fprintf(out, "%.4g,%.4g,%.4g,%.4g,%.0f\n", 0.7 + 0.05 * (i % RATIOS), 0.05 * (i / RATIOS % JITTERS),
                log10(cell[i].condition), cell[i].growth, sign);
        if (i % RATIOS == RATIOS - 1) fputc('\n', out);
    }
    free(cell);
    return STATUS_OK;
}

/* ---- Walls without ghosts ---- */

static int spectrum_of(struct model_problem *b, int ghosts, struct spectrum *s, struct failure *why) {
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    struct heat_operator a;
    struct cloud c;
    if (model_problem_cloud(b, &p, &c, why)) return why->status;
    if (!ghosts) c.total = c.n;
    int status = operator_create_csr(&a, &p, &b->options, b->method->scheme, &c, 1, why);
    layout_cloud_free(&c);
    if (status) return status;
    status = spectrum_create(s, &a, &b->step, why);
    operator_free(&a);
    return status;
}

/* Where nothing is held at the walls, T = x^2 + 2 kappa t solves the equation and A x^2 = 2, A 1 = 0: the eigenvalue
 * 0 is defective, and rounding splits it by the square root of eps.  What lies within that of 0 is 0. */
static void print_spectrum(FILE *out, const struct model_problem *b, const struct spectrum *s) {
    double floor = 10 * sqrt(DBL_EPSILON) * s->radius, limit = INFINITY, reach = amplification_reach(&b->step);
    for (size_t i = 0; i < s->n; i++)
        if (cabs(s->lambda[i]) > floor) limit = fmin(limit, amplification_limit(&b->step, reach, s->lambda[i]));
    fprintf(out, "%.6g,%.6g,%.6g,%.6g\n", fabs(s->growth) < floor ? 0 : s->growth, s->twist < floor ? 0 : s->twist,
            s->radius, limit);
}

int stability_walls_page(FILE *out, struct failure *why) {
    static const char *const method[] = {"so_ssph", "fo_ssph", "brookshaw"};
    stability_head(out, "Walls with mirrored ghosts, and without any: one-sided support", "report stability DIR");
    stability_block(out,
                    "method,dim,h/dx,walls,largest real part,largest |imaginary part|,largest |lambda|,limit (dt "
                    "kappa/dx^2)",
                    "walls");
    for (int i = 0; i < 24; i++) {
        struct model_problem b = stability_model(method[i % 3], 1 + i / 3 % 2, KERNEL_CUBIC, i / 6 % 2 ? 1.6 : 1.1);
        struct spectrum s;
        struct failure refused;
        int ghosts = i / 12;
        b.options.layout = LAYOUT_JITTER; /* of amplitude 0: rows on the lattice */
        if (model_problem_resolve(&b, b.dim == 1 ? 32 : 14, why)) return why->status;
        fprintf(out, "%s,%d,%g,%s,", b.method->name, b.dim, b.options.h, ghosts ? "cold ghosts" : "no ghosts");
        if (spectrum_of(&b, ghosts, &s, &refused)) {
            fprintf(out, "nan,nan,nan,nan\n");
            continue;
        }
        print_spectrum(out, &b, &s);
        spectrum_free(&s);
    }
    return STATUS_OK;
}
