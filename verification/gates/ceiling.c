/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ceiling of a row: the five-point difference on the same rung, times the ratio of moments; and truncation errors
 * from derivatives of the exact solution. */
#include "verification/gates/ceiling.h"

#include "references/scene.h"
#include "references/snapshot.h"
#include "solver/shape.h"
#include "solver/status.h"
#include "solver/time/stepper.h"
#include "verification/gates/ceiling_weights.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double sq(double x) {
    return x * x;
}

/* ---- The one ceiling ---- */

enum { ANGLES = 32 };

/* The k-th direction of the first quadrant or octant; 0 past the last one.  Weights are even in each axis. */
static int direction(int dim, int k, double u[DIM_MAX]) {
    double round = M_PI / 2 * (k % (ANGLES + 1)) / ANGLES, up = M_PI / 2 * (k / (ANGLES + 1)) / ANGLES;
    u[0] = u[1] = u[2] = 0;
    if (dim == 1) return u[0] = 1, k == 0;
    u[0] = cos(up) * cos(round), u[1] = cos(up) * sin(round), u[2] = sin(up);
    return k < (dim == 2 ? 1 : ANGLES + 1) * (ANGLES + 1);
}

double ceiling_worst(const struct experiment *e) {
    struct ceiling_weights w = ceiling_weights(e);
    double u[DIM_MAX], most = 0;
    for (int k = 0; direction(e->problem.dim, k, u); k++) {
        double central = 0;
        for (int a = 0; a < e->problem.dim; a++) central += w.ratio[a] * sq(sq(u[a])) / 12;
        most = fmax(most, ceiling_weights_along(&w, u, 4) / 24 / central);
    }
    return most;
}

/* The error of the finite differences at dx.  Euler steps of F take up to 6 dim F of the error in space away, a part
 * that is linear in F: two runs show the error without it.  Rings divide the radius. */
static double five_point_at(const struct experiment *e, double dx, enum mean mean, int largest) {
    const struct problem *p = &e->problem;
    const double across = p->radius[1] - p->radius[0], ring = p->shape ? across / ceil(across / dx - 1e-9) : dx;
    double error[2];
    for (int k = 0; k < 2; k++) {
        struct experiment five = {.scene = e->scene, .method = method_find("ftcs"), .problem = *p};
        struct result r;
        five.options = (struct options){.dx = ring, .sampling = e->options.sampling, .mean = mean};
        five.options.fourier = (k + 1) * 0.06 / p->dim;
        if (run_experiment(&five, &r, NULL)) return NAN;
        error[k] = largest ? r.error[NORM_LINF] : r.error[NORM_L1];
    }
    return (2 * error[0] - error[1]) * sq(dx / ring);
}

/* Updates of the run at dx. */
static double updates_at(const struct problem *p, double dx) {
    double updates = problem_diffusivity(p) * p->t_end / (0.06 / p->dim * dx * dx);
    for (int a = 0; a < p->dim; a++) updates *= (p->hi[a] - p->lo[a]) / dx;
    return updates;
}

/* Twice the spacing leaves four times the error.  Where no data jump (in space the jumps stay on faces) and k
 * vanishes nowhere, the spacing is doubled until a run is short. */
static double five_point(const struct experiment *e, enum mean mean, int largest) {
    enum { COARSEST = 16 };
    static const double SHORT = 5e5;
    const struct problem *p = &e->problem;
    const double dx = fmax(e->options.aspect, 1) * e->options.dx;
    int twice = p->dim == 3 ? 2 : 1, jumps = p->k_law == K_POWER;
    for (int a = 0; a < p->dim; a++) jumps |= p->jumps[a] > 0;
    while (!jumps && twice < COARSEST && updates_at(p, twice * dx) > SHORT) twice *= 2;
    for (; twice > 1; twice /= 2) {
        double error = five_point_at(e, twice * dx, mean, largest);
        if (isfinite(error)) return error / sq(twice);
    }
    return five_point_at(e, dx, mean, largest);
}

double ceiling_five_point(const struct experiment *e, int largest) {
    const struct problem *p = &e->problem;
    return five_point(e, p->k_law ? MEAN_KIRCHHOFF : p->materials > 1 ? MEAN_SERIES : MEAN_AUTO, largest);
}

double ceiling_harmonic_mean(const struct experiment *e) {
    return five_point(e, MEAN_HARMONIC, 0);
}

double ceiling_five_point_on_faces(const struct experiment *e) {
    static const char *const halves[] = {"a", "b", "c"};
    struct experiment faces = *e;
    struct failure ignored;
    struct problem p = {0};
    const double face = 2 * e->options.dx;
    memcpy(p.param, e->problem.param, sizeof p.param);
    for (int i = 0; e->scene->params[i].name; i++)
        for (int k = 0; k < 3; k++)
            if (strcmp(e->scene->params[i].name, halves[k]) == 0) p.param[i] = face * round(p.param[i] / face);
    if (e->scene->setup(&p, &ignored)) return NAN;
    faces.problem = p;
    return ceiling_five_point(&faces, 0);
}

static const double MARGIN = 1.3;

double ceiling(const struct experiment *e) {
    return MARGIN * ceiling_worst(e) * ceiling_five_point(e, 0);
}

double ceiling_largest(const struct experiment *e) {
    return MARGIN * ceiling_worst(e) * ceiling_five_point(e, 1);
}

double ceiling_harmonic_pairs(const struct experiment *e) {
    return MARGIN * ceiling_worst(e) * ceiling_harmonic_mean(e);
}

double ceiling_jitter(const struct experiment *e) {
    return 1 + 4 * sq(e->options.jitter);
}

/* ---- Derivatives of the exact solution ---- */

/* The k-th of the points that fill the domain evenly; 0 past the last one. */
static int place(const struct problem *p, int k, double x[DIM_MAX]) {
    const int side = p->dim == 1 ? 400 : p->dim == 2 ? 48 : 12; /* points along an axis */
    for (int a = 0; a < DIM_MAX; a++, k /= side) {
        double lo = a < p->dim && p->dim == 3 && p->mirror[a] ? (p->lo[a] + p->hi[a]) / 2 : p->lo[a];
        x[a] = a < p->dim ? lo + (p->hi[a] - lo) * (k % side + 0.5) / side : 0;
        if (a == p->dim - 1 && k / side > 0) return 0;
    }
    return 1;
}

/* Factors of T_t/kappa, T_tt/kappa and T_ttt/kappa^2 (errors in space), and of T_tt and T_ttt (errors in time). */
struct terms {
    double laplacian, fourth, sixth, second, third;
};

/* The mean of |the sum of these terms| at the time t over the mean of |T| at the end.  kappa is the smallest of the
 * axes. */
static double mean_of(const struct experiment *e, const struct terms *c, double t) {
    enum { TIMES = 7 };
    static const double first[3] = {3. / 4, -3. / 20, 1. / 60}, second[3] = {3. / 2, -3. / 20, 1. / 90},
                        third[3] = {-13. / 8, 1, -1. / 8};
    const struct problem *p = &e->problem;
    const double step = 0.02 * p->t_end;
    struct snapshot s[TIMES], end = snapshot_take(e->scene, p, p->t_end);
    double x[DIM_MAX], sum = 0, whole = 0;
    for (int k = 0; k < TIMES; k++) s[k] = snapshot_take(e->scene, p, t + (k - 3) * step);
    for (int i = 0; place(p, i, x); i++) {
        const struct material *m = &p->material[p->materials > 1 && x[0] >= p->interface];
        double T[TIMES], rate[4] = {0}, kappa = INFINITY;
        if (p->shape && shape_depth(p, x) < 0) continue;
        for (int a = 0; a < p->dim; a++) kappa = fmin(kappa, m->k[a] / m->rho_c);
        for (int k = 0; k < TIMES; k++) T[k] = snapshot_at(&s[k], x).temperature;
        for (int k = 0; k < 3; k++) {
            double odd = T[4 + k] - T[2 - k], even = T[4 + k] + T[2 - k] - 2 * T[3];
            rate[1] += first[k] * odd / step;
            rate[2] += second[k] * even / (step * step);
            rate[3] += third[k] * odd / pow(step, 3);
        }
        double error = fabs(c->laplacian * rate[1] / kappa + rate[2] * (c->fourth / kappa + c->second) +
                            rate[3] * (c->sixth / (kappa * kappa) + c->third));
        sum += error, whole += fabs(snapshot_at(&end, x).temperature);
    }
    for (int k = 0; k < TIMES; k++) snapshot_free(&s[k]);
    snapshot_free(&end);
    return sum / whole;
}

/* ---- At the end, times t ---- */

/* Point samples of a jump midway between lattice points act as -dx^2/24 T_xx, averages of order m as +m. */
static double start_of(const struct experiment *e) {
    const int *jumps = e->problem.jumps;
    const enum sampling sampling = e->options.sampling;
    if (sampling != SAMPLING_POINT) return sampling == SAMPLING_CELL ? 1 : 4;
    return jumps[0] + jumps[1] + jumps[2] > 0 ? -1 : 0;
}

static double step_of(const struct experiment *e) {
    const struct problem *p = &e->problem;
    double dt = e->options.dt > 0 ? e->options.dt : e->options.fourier * sq(e->options.dx) / problem_diffusivity(p);
    return p->t_end / ceil(p->t_end / dt - 1e-9);
}

static int is_euler(const struct experiment *e) {
    const struct stepper *stepper = stepper_of(e->options.stepper);
    return !e->method->scheme || (stepper && stepper->order == 1);
}

/* The mean over the directions of the fourth moment. */
static double mean_moment(const struct experiment *e) {
    struct ceiling_weights w = ceiling_weights(e);
    double straight = ceiling_weights_moment(&w, 4, 0, 0) / 24, mixed = ceiling_weights_moment(&w, 2, 2, 0) / 4;
    if (!e->problem.shape) return straight;
    return e->problem.dim == 3 ? (3 * straight + mixed) / 5 : (3 * straight + mixed / 2) / 4;
}

/* 1 if even initial data are cooled from the start: the jump of dT/dn has the same weight as the slope of the
 * mode. */
static int is_cooled_at_once(const struct experiment *e) {
    int robin = 0;
    for (int s = 0; s < SIDES; s++) robin |= e->problem.side[s] == ROBIN;
    return robin && e->problem.shape && e->problem.initial == problem_start;
}

double ceiling_truncation(const struct experiment *e) {
    const double dx2 = sq(e->options.dx), t = e->problem.t_end, A = mean_moment(e) * dx2;
    struct terms c = {.fourth = A * t, .laplacian = is_cooled_at_once(e) ? A : start_of(e) / 24 * dx2};
    if (is_euler(e) && !e->problem.shape)
        c.second = -e->options.fourier * dx2 / problem_diffusivity(&e->problem) / 2 * t;
    return mean_of(e, &c, t);
}

double ceiling_central(const struct experiment *e) {
    struct experiment central = *e;
    central.method = method_find("ftcs"), central.options.fourier = 0;
    return ceiling_truncation(&central);
}

double ceiling_sixth(const struct experiment *e) {
    struct terms c = {.sixth = pow(e->options.dx, 4) / 540 * e->problem.t_end};
    return mean_of(e, &c, e->problem.t_end);
}

double ceiling_fourth(const struct experiment *e) {
    struct ceiling_weights w = ceiling_weights(e);
    const double t = e->problem.t_end;
    struct terms c = {.sixth = ceiling_weights_moment(&w, 6, 0, 0) / 720 * pow(e->options.dx, 4) * t};
    return mean_of(e, &c, t);
}

/* n Euler steps of d (1 +- u), r d (1 + u^2) = 2 A, r = kappa/dx^2, multiply a mode by exp(sum log(1 + dt lambda)).
 * The second order cancels and leaves r t (K - sum w (u.x)^6/720) q^6, K = 2 A^2 - (r d)^2 (1 + 3 u^2)/3, and, for
 * initial data averaged with a B-spline of order m, whose clock starts at m/(24 r), -m/2880 of the fourth
 * derivatives. */
static double matched_rest(double A, double rt) {
    double n = 2 * ceil(rt / (2 * A) / 2 - 1e-9), rd = rt / n, u2 = 2 * A / rd - 1;
    return 2 * A * A - rd * rd * (1 + 3 * u2) / 3;
}

/* The moment K - sum w (u.x)^6/720 of the next term, in the direction of the largest; K = 0: an operator of order
 * 4. */
static double sixth_left(const struct experiment *e, double K) {
    struct ceiling_weights w = ceiling_weights(e);
    double u[DIM_MAX], most = 0;
    for (int k = 0; direction(e->problem.dim, k, u); k++) {
        double left = K - ceiling_weights_along(&w, u, 6) / 720;
        if (fabs(left) > fabs(most)) most = left;
    }
    return most;
}

/* kappa t/dx^2 and K of a matched run. */
static double matched_time(const struct experiment *e, double *K) {
    struct ceiling_weights w = ceiling_weights(e);
    double rt = problem_diffusivity(&e->problem) * e->problem.t_end / sq(e->options.dx) - start_of(e) / 24;
    *K = matched_rest(ceiling_weights_moment(&w, 4, 0, 0) / 24, rt);
    return rt;
}

double ceiling_matched(const struct experiment *e) {
    double K, rt = matched_time(e, &K), m = start_of(e), dx4 = pow(e->options.dx, 4), t = e->problem.t_end;
    double of_run = rt / (rt + m / 24), kappa = problem_diffusivity(&e->problem);
    struct terms c = {.sixth = -sixth_left(e, K) * dx4 * of_run * t, .fourth = -m / 2880 * dx4 / kappa};
    return mean_of(e, &c, t);
}

double ceiling_next(const struct experiment *e, double q) {
    double K = 0;
    if (options_is_matched(&e->options)) matched_time(e, &K);
    return MARGIN * 12 * fabs(sixth_left(e, K)) * sq(q * e->options.dx) * ceiling_five_point(e, 0);
}

/* The factor of dt^2 T_ttt of a step of order 2. */
static double third_of(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const struct stepper *stepper = stepper_of(e->options.stepper);
    struct ceiling_weights w = ceiling_weights(e);
    if (stepper && stepper->order > 2) return NAN;
    double stages = 3, bound = 2 * ceiling_weights_row(&w) * p->material[0].k[0] / p->material[0].rho_c;
    if (stepper && stepper->stages == 2) return 1.0 / 6;
    while (stages * stages + stages - 2 < 2 * step_of(e) * bound / sq(e->options.dx)) stages += 2;
    return (1 + 8 / (stages * stages + stages - 2)) / 18;
}

double ceiling_euler(const struct experiment *e, double dt) {
    return mean_of(e, &(struct terms){.second = dt / 2 * e->problem.t_end}, e->problem.t_end);
}

double ceiling_time(const struct experiment *e) {
    const double dt = step_of(e), t = e->problem.t_end;
    if (is_euler(e)) return ceiling_euler(e, dt);
    return mean_of(e, &(struct terms){.third = dt * dt * third_of(e) * t}, t);
}

/* ---- Over the run ---- */

static double over_the_run(const struct experiment *e, const struct terms *c) {
    enum { TIMES = 24 };
    double sum = 0, t = e->problem.t_end;
    for (int k = 0; k < TIMES; k++) sum += mean_of(e, c, t * (k + 0.5) / TIMES) * t / TIMES;
    return sum;
}

/* A step of order 2 leaves -p dt^3 f''(f, f) - q dt^3 f' f' f, with T_t = f and the data of the walls as further
 * unknowns: p = 1/24, q = 1/6 of the midpoint rule; p and q near 1/18 of rkl2 with many stages.  Since T_ttt =
 * f''(f, f) + f' f' f and f' f = T_tt,
 *
 *     e_t = f' e - dt^2 (p T_ttt + (q - p) f' T_tt),   e = dt^2 s T_tt + u,   u_t = f' u - q dt^2 T_ttt
 *
 * with s = q - p, and u = -dt^2 s T_tt at the start.  Data that are linear in a step add dt^3/12 g_tt: s = q + 1/12
 * where T is linear in them. */
double ceiling_run_time(const struct experiment *e) {
    const double dt = e->options.dt, q = third_of(e);
    const int law = e->problem.k_law != K_CONSTANT;
    double s = !law ? q + 1.0 / 12 : e->options.stepper == STEPPER_RK2 ? 1.0 / 8 : 0;
    if (e->options.stepper == STEPPER_EULER) return over_the_run(e, &(struct terms){.second = dt / 2});
    struct terms ends = {.second = dt * dt * s};
    return mean_of(e, &ends, 0) + mean_of(e, &ends, e->problem.t_end) +
           over_the_run(e, &(struct terms){.third = q * dt * dt});
}

/* A wall between its values at c = 0, 1/4, .. 1 of a step is off by (omega dt)^5 A |c (c - 1/4) .. (c - 1)|/120, at
 * most 3.55e-3/120 of them.  The sign changes within the step: what enters is the layer sqrt(4 kappa dt/pi) of the
 * last one. */
double ceiling_polynomials(const struct experiment *e) {
    const struct problem *p = &e->problem;
    const double dt = e->options.dt, layer = sqrt(4 * problem_diffusivity(p) * dt / M_PI);
    double wall = ceiling_param(e, "A") * pow(ceiling_param(e, "omega") * dt, 5) * 3.55e-3 / 120;
    return wall * layer / p->hi[0] / ceiling_param(e, "Tm");
}
