/* Pamplona, Silva, Bucar, Vasco 2019, Figures 7 and 8: the xi with the least mean relative error at t = 28.8894 s.
 *
 * The volume of a particle is V = area xi / N with N = (n + 4)^2, ghosts counted (eq. 14, m = 0.224 kg).  The
 * operator is exact for x^2 and y^2 on a lattice where V = dx^2 / M, M = sum_j -F_j x_j^2 dx^2 the lattice's moment,
 * so that
 *
 *     xi = 1/M ((n + 4)/n)^2                       in closed form, beside their fit xi = 9 h^(1/3)   (18)
 *
 * A larger xi only makes time pass faster.  Walls of fixed ghosts make the plate lag by ((n + 1)/n)^2, and the best
 * xi makes up for most of that: xi ((n + 1)/n)^2.
 *
 * The step is eq. 15 with beta = 0.08 (report_plate.c).  Order by eq. 19, between the n nearest to h = 0.009 and
 * 0.005 m: dx = h/1.2 must divide 0.1 m. */
#include "reports/pamplona/xi.h"

#include "solver/space/kernel.h"
#include "solver/method.h"
#include "reports/page/figure.h"
#include "verification/command/command_run.h"
#include "verification/text/output.h"
#include "reports/pamplona/plate.h"

#include <gsl/gsl_fit.h>
#include <math.h>
#include <stdlib.h>

enum { SIZES = 7, MATERIALS = 3, COARSE = 1, FINE = 5, USUAL = 4, OTHER = SIZES };

static const double SIDE = 0.1, RATIO = 1.2, BETA = 0.08, TIME = 28.8894; /* m, h/dx, eq. 15, s */
static const int size[SIZES] = {12, 13, 15, 17, 20, 24, 30};              /* particles along a side */
static const char *const material[MATERIALS] = {"steel", "titanium", "vanadium"};

static double h_of(int n) {
    return RATIO * SIDE / n;
}

/* 1/M of the quartic kernel in the plane, by eqs. 12 and 13: F = (dW/dr) r / (r^2 + (0.1 h)^2). */
static double inverse_moment(void) {
    double M = 0;
    for (int j = -3; j <= 3; j++)
        for (int i = -3; i <= 3; i++) {
            double r = hypot(i, j) / RATIO; /* in h; one dx is 1/RATIO */
            if (r >= KERNEL_SUPPORT) continue;
            M -= kernel_slope(KERNEL_QUARTIC, 2, r) * r / (r * r + 0.01) * i * i / pow(RATIO, 4);
        }
    return 1 / M;
}

static double closed_form(int n) {
    return inverse_moment() * pow((n + 4.0) / n, 2);
}

struct best {
    int n, m;       /* particles along a side, material */
    double beta, t; /* of eq. 15; s */
    double xi;      /* m */
    double error;   /* mean relative error, % */
    long long work; /* pairs evaluated by one run */
    double seconds; /* of one run */
    struct failure failure;
};

static double try_xi(double xi, struct best *b) {
    struct command_run run;
    double error[REPORT_PLATE_ERRORS] = {NAN}, h = h_of(b->n);
    double alpha[3] = {60.5 / (7854 * 434.), 21.9 / (4500 * 522.), 30.7 / (6100 * 489.)};
    command_run_line(
        &run,
        "run plate brookshaw --kernel quartic --h 1.2 --volume tuned --xi %.17g --walls fixed --dx %.17g "
        "--stepper rk2 --dt %.17g --set material=%s --t-end %.17g",
        xi, SIDE / b->n, b->beta * h * h / alpha[b->m], material[b->m], b->t);
    if (!command_run_check(&run, &b->failure)) {
        pamplona_plate_errors(&run, b->t, error);
        b->work = run.result.interactions;
        b->seconds = run.result.seconds;
    }
    command_run_free(&run);
    return error[REPORT_PLATE_MEAN_RELATIVE];
}

/* Golden section: the error falls to one minimum and rises again. */
static void find_best(struct best *b) {
    const double golden = (sqrt(5) - 1) / 2;
    double lo = closed_form(b->n), hi = 1.4 * closed_form(b->n);
    double u = hi - golden * (hi - lo), v = lo + golden * (hi - lo), eu = try_xi(u, b), ev = try_xi(v, b);
    while (hi - lo > 5e-4 && !b->failure.status) {
        if (eu < ev) {
            hi = v, v = u, ev = eu;
            eu = try_xi(u = hi - golden * (hi - lo), b);
        } else {
            lo = u, u = v, eu = ev;
            ev = try_xi(v = lo + golden * (hi - lo), b);
        }
    }
    b->xi = (lo + hi) / 2;
    b->error = fmin(eu, ev);
}

static void head(FILE *out, const char *title) {
    figure_head(out, title);
    fprintf(out,
            "# command: heatladder run plate brookshaw --kernel quartic --h 1.2 --volume tuned --xi XI --walls fixed "
            "--dx 0.1/N --stepper rk2 --dt DT --set material=M\n");
}

static void write_errors(const struct best (*b)[MATERIALS], FILE *out) {
    head(out, "Pamplona 2019, Figure 7a: least mean relative error on the plate, t = 28.9 s");
    for (int m = 0; m < MATERIALS; m++) {
        fprintf(out, "\n\n# %s\nh [m],error [%%]\n", material[m]);
        for (int i = 0; i < SIZES; i++) fprintf(out, "%.8g,%.5g\n", h_of(size[i]), b[i][m].error);
    }
    double e = 0.7 * b[FINE][0].error, x = h_of(size[FINE]), X = h_of(size[COARSE]);
    fprintf(out, "\n\n# triangle\nh [m],error [%%]\n%.6g,%.6g\n%.6g,%.6g\n%.6g,%.6g\n%.6g,%.6g\n", x, e, X, e, X,
            e * X / x, x, e);
    fprintf(out, "\n\n# label\nh [m],error [%%],text\n%.6g,%.6g,order 1\n", X * 1.02, e * sqrt(X / x));
}

static void write_xi(const struct best (*b)[MATERIALS], FILE *out) {
    head(out, "Pamplona 2019, Figure 7b: best xi on the plate, t = 28.9 s");
    for (int m = 0; m < MATERIALS; m++) {
        fprintf(out, "\n\n# %s\nh [m],xi [m]\n", material[m]);
        for (int i = 0; i < SIZES; i++) fprintf(out, "%.8g,%.6g\n", h_of(size[i]), b[i][m].xi);
    }
    fprintf(out, "\n\n# moment\nh [m],xi [m]\n");
    for (int n = 30; n >= 12; n--) fprintf(out, "%.8g,%.6g\n", h_of(n), closed_form(n));
    fprintf(out, "\n\n# lag\nh [m],xi [m]\n");
    for (int n = 30; n >= 12; n--) fprintf(out, "%.8g,%.6g\n", h_of(n), closed_form(n) * pow((n + 1.0) / n, 2));
    fprintf(out, "\n\n# published\nh [m],xi [m]\n");
    for (int n = 30; n >= 12; n--) fprintf(out, "%.8g,%.6g\n", h_of(n), 9 * cbrt(h_of(n)));
}

struct line { /* log10(work) = at + slope u, u = log10(h) or h */
    double at, slope, scatter;
};

static struct line fit(const struct best (*b)[MATERIALS], int m, int power) {
    double u[SIZES], v[SIZES], c00, c01, c11, left;
    struct line l;
    for (int i = 0; i < SIZES; i++) {
        u[i] = power ? log10(h_of(size[i])) : h_of(size[i]);
        v[i] = log10((double)b[i][m].work);
    }
    gsl_fit_linear(u, 1, v, 1, SIZES, &l.at, &l.slope, &c00, &c01, &c11, &left);
    l.scatter = sqrt(left / SIZES);
    return l;
}

static void write_work(const struct best (*b)[MATERIALS], FILE *out) {
    head(out, "Pamplona 2019, Figure 8: cost on the plate, t = 28.9 s, as pairs evaluated");
    for (int m = 0; m < MATERIALS; m++) {
        fprintf(out, "\n\n# %s\nh [m],%s (h^{%.2f})\n", material[m], material[m], fit(b, m, 1).slope);
        for (int i = 0; i < SIZES; i++) fprintf(out, "%.8g,%lld\n", h_of(size[i]), b[i][m].work);
    }
    for (int power = 0; power < 2; power++) {
        struct line l = fit(b, 0, power);
        fprintf(out, "\n\n# %s\nh [m],%s fitted to steel (off by %.1f %%)\n", power ? "power" : "exponential",
                power ? "power law" : "exponential", 100 * (pow(10, l.scatter) - 1));
        for (int n = 30; n >= 12; n--)
            fprintf(out, "%.8g,%.6g\n", h_of(n), pow(10, l.at + l.slope * (power ? log10(h_of(n)) : h_of(n))));
    }
}

static void write_seconds(const struct best (*b)[MATERIALS], FILE *out) {
    head(out, "Pamplona 2019, Figure 8: cost on the plate, t = 28.9 s, in seconds of one run");
    for (int m = 0; m < MATERIALS; m++) {
        fprintf(out, "\n\n# %s\nh [m],%s\n", material[m], material[m]);
        for (int i = 0; i < SIZES; i++) fprintf(out, "%.8g,%.4g\n", h_of(size[i]), b[i][m].seconds);
    }
}

static double order(const struct best (*b)[MATERIALS], int m) {
    return log(b[COARSE][m].error / b[FINE][m].error) / log(h_of(size[COARSE]) / h_of(size[FINE]));
}

static void write_order(const struct best (*b)[MATERIALS], FILE *out) {
    fprintf(out,
            "\n\n## Observed order (eq. 19), h = %.5f to %.5f m\n\nThe paper: 1.1253, h = 0.009 to 0.005 m. Here",
            h_of(size[COARSE]), h_of(size[FINE]));
    double mean = 0;
    for (int m = 0; m < MATERIALS; m++) {
        fprintf(out, " %s %.4f,", material[m], order(b, m));
        mean += order(b, m) / MATERIALS;
    }
    fprintf(out, " mean %.4f. (dx = h/1.2 must divide 0.1 m: N = %d and %d are the nearest.)\n", mean, size[COARSE],
            size[FINE]);
}

static void write_cost(const struct best (*b)[MATERIALS], FILE *out) {
    fprintf(out, "\n## Cost\n\n");
    for (int m = 0; m < MATERIALS; m++) {
        struct line power = fit(b, m, 1), exponential = fit(b, m, 0);
        fprintf(
            out, "- %s: pairs grow as h^%.3f; the power law is off by %.1f %% (rms), an exponential by %.1f %%.\n",
            material[m], power.slope, 100 * (pow(10, power.scatter) - 1), 100 * (pow(10, exponential.scatter) - 1));
    }
    fprintf(out, "\nParticles grow as h^-2 and steps (eq. 15) as h^-2: h^-4, a power law. The paper calls it "
                 "exponential.\n");
}

/* The paper lays the differences between the materials to their time steps. */
static void write_materials(const struct best (*b)[MATERIALS], FILE *out) {
    const struct best *ti = &b[USUAL][1], *steel = &b[USUAL][0], *other = b[OTHER];
    fprintf(out,
            "\n## Why the materials differ\n\nThe paper: by the time step, which eq. 15 sets. At N = %d, best xi "
            "and its error:\n\n| case | xi [m] | error [%%] |\n|---|---:|---:|\n",
            ti->n);
    fprintf(out, "| titanium | %.4f | %.4f |\n", ti->xi, ti->error);
    fprintf(out, "| titanium, a quarter of the time step | %.4f | %.4f |\n", other[0].xi, other[0].error);
    fprintf(out, "| titanium at %.4f s, when its alpha t is steel's | %.4f | %.4f |\n", other[1].t, other[1].xi,
            other[1].error);
    fprintf(out,
            "| steel | %.4f | %.4f |\n\nSo it is alpha t, how far the plate has warmed up by the same t, and not the "
            "time step.\n",
            steel->xi, steel->error);
}

static void write_table(const struct best (*b)[MATERIALS], FILE *out) {
    fprintf(out,
            "# Pamplona 2019, Figures 7 and 8: best xi, its error, its cost\n\nMade by `heatladder report DIR`. Mean "
            "relative error at t = %.4f s, at the xi that makes it least; eq. 15 with beta = %g.\n\n"
            "| N | h [m] | 9 h^(1/3) | lattice moment x ((N+4)/N)^2 | and x ((N+1)/N)^2 |",
            TIME, BETA);
    for (int m = 0; m < MATERIALS; m++) fprintf(out, " %s: xi [m] | error [%%] | pairs |", material[m]);
    fprintf(out, "\n|---:|---:|---:|---:|---:|");
    for (int m = 0; m < 3 * MATERIALS; m++) fprintf(out, "---:|");
    for (int i = 0; i < SIZES; i++) {
        int n = size[i];
        fprintf(out, "\n| %d | %.5f | %.4f | %.4f | %.4f |", n, h_of(n), 9 * cbrt(h_of(n)), closed_form(n),
                closed_form(n) * pow((n + 1.0) / n, 2));
        for (int m = 0; m < MATERIALS; m++)
            fprintf(out, " %.4f | %.4f | %.3e |", b[i][m].xi, b[i][m].error, (double)b[i][m].work);
    }
    write_order(b, out);
    write_cost(b, out);
    write_materials(b, out);
}

static const struct {
    const char *name, *ending;
    void (*write)(const struct best (*b)[MATERIALS], FILE *out);
} pages[] = {
    {"pamplona_fig7a", ".csv", write_errors}, {"pamplona_fig7b", ".csv", write_xi},
    {"pamplona_fig8", ".csv", write_work},    {"pamplona_fig8_seconds", ".csv", write_seconds},
    {"pamplona_fig7", ".md", write_table},
};

/* Row OTHER: titanium at a quarter of the time step, and at the time when its alpha t is that of steel. */
static void set_cases(struct best (*b)[MATERIALS]) {
    for (int i = 0; i < SIZES; i++)
        for (int m = 0; m < MATERIALS; m++) b[i][m] = (struct best){.n = size[i], .m = m, .beta = BETA, .t = TIME};
    double slower = 60.5 / (7854 * 434) * (4500 * 522) / 21.9; /* alpha of steel over alpha of titanium */
    b[OTHER][0] = (struct best){.n = size[USUAL], .m = 1, .beta = BETA / 4, .t = TIME};
    b[OTHER][1] = (struct best){.n = size[USUAL], .m = 1, .beta = BETA, .t = slower * TIME};
}

int pamplona_xi_write(const char *dir, struct failure *why) {
    struct best(*b)[MATERIALS] = xcalloc(SIZES + 1, sizeof *b);
    int status = STATUS_OK, cases = SIZES * MATERIALS + 2;
    set_cases(b);
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = cases - 1; i >= 0; i--) find_best(&b[i / MATERIALS][i % MATERIALS]);
    for (int i = 0; i < cases && !status; i++) {
        const struct failure *failure = &b[i / MATERIALS][i % MATERIALS].failure;
        status = failure->status;
        if (status) *why = *failure;
    }
    for (size_t i = 0; i < sizeof pages / sizeof *pages && !status; i++) {
        struct output page;
        status = output_open(&page, why, "%s/%s%s", dir, pages[i].name, pages[i].ending);
        if (status) break;
        pages[i].write((const struct best(*)[MATERIALS])b, page.out);
        status = output_close(&page, 1, why);
    }
    free(b);
    return status;
}
