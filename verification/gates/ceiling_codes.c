/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bounds for codes of any kind: multiples of the error of the five-point difference on the same draw, the effect of
 * cell means, and the errors of Euler steps where a source depends on time (battery.def). */
#include "verification/gates/ceiling.h"

#include "references/scene.h"
#include "references/snapshot.h"
#include "solver/shape.h"
#include "solver/status.h"
#include "verification/judge/run.h"

#include <math.h>
#include <string.h>

static double sq(double x) {
    return x * x;
}

/* E1 (or the largest error) of the five-point difference at dx, in steps of that mesh Fourier number; 0: as long as
 * their error is small. */
static double five_point_at(const struct experiment *e, double dx, double fourier, int linf) {
    struct experiment five = {.scene = e->scene, .method = method_find("ftcs"), .problem = e->problem};
    struct result r;
    five.options = (struct options){.dx = dx, .fourier = fourier, .sampling = e->options.sampling};
    if (e->problem.k_law) five.options.mean = MEAN_KIRCHHOFF;
    if (run_experiment(&five, &r, NULL)) return NAN;
    return linf ? r.error.linf : r.error.l1;
}

/* Euler steps of F take up to 6 dim F of the error in space away, a part that is linear in F: two runs show the error
 * without it.  Rings and k(T) have other steps.  In space, twice the spacing leaves four times the error. */
double ceiling_five_point(const struct experiment *e, int linf) {
    const double F = 0.06 / e->problem.dim, dx = fmax(e->options.aspect, 1) * e->options.dx;
    if (e->problem.shape) return five_point_at(e, dx, e->options.fourier, linf);
    if (e->problem.k_law) return five_point_at(e, dx, 0.1, linf);
    double twice = e->problem.dim == 3 ? five_point_at(e, 2 * dx, F, linf) : NAN;
    if (isfinite(twice)) return (2 * twice - five_point_at(e, 2 * dx, 2 * F, linf)) / 4;
    return 2 * five_point_at(e, dx, F, linf) - five_point_at(e, dx, 2 * F, linf);
}

double ceiling_harmonic_mean(const struct experiment *e) {
    struct experiment five = {.scene = e->scene, .method = method_find("ftcs"), .problem = e->problem};
    struct result r;
    five.options = (struct options){.dx = e->options.dx, .fourier = 0.1, .mean = MEAN_HARMONIC};
    return run_experiment(&five, &r, NULL) ? NAN : r.error.l1;
}

double ceiling_five_point_on_faces(const struct experiment *e) {
    struct experiment faces = *e;
    struct failure ignored;
    struct problem p = {0};
    memcpy(p.param, e->problem.param, sizeof p.param);
    for (int i = 0; e->scene->params[i].name; i++)
        if (strcmp(e->scene->params[i].name, "a") == 0) p.param[i] = e->scene->params[i].value;
    if (e->scene->setup(&p, &ignored)) return NAN;
    faces.problem = p;
    return ceiling_five_point(&faces, 0);
}

/* kappa dx^2/12 (T_xxxx + T_yyyy + T_zzzz) acts for t.  The mean of cos^4 over the sphere is 1/5, so that the sum is
 * 3/5 of the bilaplacian, T_tt/kappa^2: t dx^2/20 T_tt/kappa. */
double ceiling_ball(const struct experiment *e) {
    enum { ACROSS = 16, TIMES = 3 };
    const struct problem *p = &e->problem;
    const double step = 0.02 * p->t_end, kappa = problem_diffusivity(p);
    struct snapshot s[TIMES];
    double bend = 0, whole = 0;
    for (int k = 0; k < TIMES; k++) s[k] = snapshot_take(e->scene, p, p->t_end + (k - 1) * step);
    for (int i = 0; i < ACROSS * ACROSS * ACROSS; i++) {
        const int at[DIM_MAX] = {i % ACROSS, i / ACROSS % ACROSS, i / ACROSS / ACROSS};
        double x[DIM_MAX], T[TIMES];
        for (int a = 0; a < p->dim; a++) x[a] = p->lo[a] + (p->hi[a] - p->lo[a]) * (at[a] + 0.5) / ACROSS;
        if (shape_depth(p, x) < 0) continue;
        for (int k = 0; k < TIMES; k++) T[k] = snapshot_at(&s[k], x).temperature;
        bend += fabs(T[0] - 2 * T[1] + T[2]) / (step * step), whole += fabs(T[1]);
    }
    for (int k = 0; k < TIMES; k++) snapshot_free(&s[k]);
    return p->t_end * sq(e->options.dx) / 20 / kappa * bend / whole;
}

/* Means over cell centres of |T|, |T_x| + |T_y| and |T_xx + T_yy|, by differences of step dx/8. */
struct means {
    double T, gradient, laplacian;
};

static struct means means_of(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const double dx = e->options.dx, d = dx / 8;
    const int n = (int)round((p->hi[0] - p->lo[0]) / dx),
              rows = p->dim == 2 ? (int)round((p->hi[1] - p->lo[1]) / dx) : 1;
    struct snapshot s = snapshot_take(e->scene, p, p->t_end);
    struct means mean = {0};
    for (int k = 0; k < n * rows; k++) {
        double x[2] = {p->lo[0] + (k % n + 0.5) * dx, p->dim == 2 ? p->lo[1] + (k / n + 0.5) * dx : 0};
        double T = snapshot_at(&s, x).temperature, laplacian = 0;
        for (int a = 0; a < p->dim; a++) {
            double lo[2] = {x[0], x[1]}, hi[2] = {x[0], x[1]};
            lo[a] -= d, hi[a] += d;
            double below = snapshot_at(&s, lo).temperature, above = snapshot_at(&s, hi).temperature;
            laplacian += (below - 2 * T + above) / (d * d), mean.gradient += fabs(above - below) / (2 * d);
        }
        mean.T += fabs(T), mean.laplacian += fabs(laplacian);
    }
    mean.T /= n * rows, mean.gradient /= n * rows, mean.laplacian /= n * rows;
    snapshot_free(&s);
    return mean;
}

double ceiling_cell_mean(const struct experiment *e) {
    struct means mean = means_of(e);
    return sq(e->options.dx) / 24 * mean.laplacian / mean.T;
}

double ceiling_cell_away(const struct experiment *e) {
    struct means mean = means_of(e);
    return e->options.dx * mean.gradient / mean.T;
}

double ceiling_bend(const struct experiment *e) {
    const struct problem *p = &e->problem;
    double d = e->options.dx / 8, x[2] = {p->hi[0], 0}, in[2] = {p->hi[0] - d, 0};
    double end = scene_exact(e->scene, p, x, p->t_end).gradient[0];
    return fabs((end - scene_exact(e->scene, p, in, p->t_end).gradient[0]) / d / end);
}

/* ---- Euler steps on rect-manufactured ---- */

/* Modes n = 1 and 3 of R decay as exp(-kappa (n pi/width)^2 t); R has the amplitudes 1 and -1/10. */
double ceiling_source_step(const struct experiment *e, double dt) {
    enum { POINTS = 400 };
    double rate = ceiling_param(e, "k_x") / ceiling_param(e, "rho_c") * sq(M_PI / ceiling_param(e, "width")), sum = 0;
    double first = 1 - exp(-rate * e->problem.t_end), third = 1 - exp(-9 * rate * e->problem.t_end);
    for (int i = 0; i < POINTS; i++) {
        double a = M_PI * (i + 0.5) / POINTS;
        sum += fabs(first * sin(a) - third * sin(3 * a) / 10) / POINTS;
    }
    return dt * ceiling_param(e, "rise") * sum / means_of(e).T;
}

/* The mean of |Z| is A (2/pi)^2. */
double ceiling_euler(const struct experiment *e, double dt) {
    const double q_x = 2 * M_PI / ceiling_param(e, "width"), q_y = M_PI / ceiling_param(e, "height");
    double rate = (ceiling_param(e, "k_x") * sq(q_x) + ceiling_param(e, "k_y") * sq(q_y)) / ceiling_param(e, "rho_c");
    double t = e->problem.t_end;
    return dt / 2 * sq(rate) * t * ceiling_param(e, "A") * exp(-rate * t) * sq(2 / M_PI) / means_of(e).T;
}
