/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps of the finite volumes.  With f(T, t) the sum over faces of C (T_n - T_i)/(rho_c V), plus G/rho_c:
 *
 *   euler  T += dt f(T, t); in a round body along r, and then the implicit part along the angles (ftcs_round.c)
 *   rk2    T += dt f(T + dt/2 f(T, t), t + dt/2)
 *   rkl2   Y_0 = T,  Y_1 = Y_0 + m_1 dt f_0,  T = Y_s,
 *          Y_j = mu_j Y_(j-1) + nu_j Y_(j-2) + (1 - mu_j - nu_j) Y_0 + m_j dt f_(j-1) - (1 - b_(j-1)) m_j dt f_0
 *          b_j = (j^2 + j - 2)/(2 j (j + 1)), b_0 = b_1 = b_2 = 1/3,  w = 4/(s^2 + s - 2),  m_1 = b_1 w
 *          mu_j = (2j - 1)/j b_j/b_(j-1),  nu_j = -(j - 1)/j b_j/b_(j-2),  m_j = mu_j w
 *          (Meyer, Balsara & Aslam 2014, eqs. 16-18); stage j is at the time c_j dt, c_1 = m_1, c_j = b_j w j(j +
 * 1)/2
 *
 * Orders in time.  A step of order 2 adds dt^3 ((S_1 - 1/6) f' f' f + (S_2/2 - 1/6) f''(f, f)), with S_1 = 0 and S_2
 * = 1/4 for rk2, and S_1 and S_2/2 near 1/9 for rkl2 with many stages: -dt^3/18 T_ttt.
 *
 * All rows are computed as base + h f, the base a sum of states.  The differences of one material, of T or theta(T),
 * have constant coefficients; those of other faces an array.  A source of any dependence on time is taken as the
 * parabola through the start of the last step and both ends of this one (a line in the first step): one evaluation
 * a step, an error of dt^3/24 G_ttt in its mean, beyond the order of the steppers.  There are
 * no reductions, so the results do not depend on the width of vectors.
 *
 * Restrictions: explicit steps are stable for dt sum of kappa/dx^2 up to 1/2, in a ball 0.47; rkl2 takes its stages
 * from that number.  With k(T) it is that of the largest k of the state at the start of each step. */
#include "solver/differences/ftcs.h"

#include "solver/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CHECK_EVERY = 32, TERMS = 4, LEGENDRE_MOST = 1000001 /* stages, whose rounding error is s^2 eps */ };

/* One sweep: out = sum of weight state + h f, f from the differences of `of`. */
struct sweep {
    const struct ftcs_grid *g;
    double h;
    const double *of, *heating;
    int terms; /* 0; 1, of weight 1; or TERMS */
    double weight[TERMS];
    const double *state[TERMS];
    double *out;
};

/* ---- Rows of n cells ---- */

#define INLINE static inline __attribute__((always_inline))

/* T_(i+1) - 2 T_i + T_(i-1), neighbours at the distance s */
INLINE double bend(const double *T, ptrdiff_t s) {
    return (T[s] - T[0]) - (T[0] - T[-s]);
}

/* The differences of one material along `axes` axes, and the source (or NULL). */
INLINE void row_uniform(int axes, ptrdiff_t n, const double F[], const ptrdiff_t s[], double h,
                        const double *restrict heating, const double *base, const double *restrict T,
                        double *restrict out) {
    const double Fx = F[0], Fy = axes > 1 ? F[1] : 0, Fz = axes > 2 ? F[2] : 0;
    const ptrdiff_t x = s[0], y = axes > 1 ? s[1] : 0, z = axes > 2 ? s[2] : 0;
    for (ptrdiff_t i = 0; i < n; i++) {
        double next = base[i] + Fx * bend(T + i, x);
        if (axes > 1) next += Fy * bend(T + i, y);
        if (axes > 2) next += Fz * bend(T + i, z);
        out[i] = heating ? next + h * heating[i] : next;
    }
}

/* Adds the fluxes through the two faces of each cell along one axis, at the distance s. */
INLINE void row_faces(ptrdiff_t n, double h, const double *weight, const double *lower, const double *upper,
                      ptrdiff_t s, const double *restrict T, double *restrict out) {
    for (ptrdiff_t i = 0; i < n; i++)
        out[i] += h * weight[i] * (upper[i] * (T[i + s] - T[i]) - lower[i] * (T[i] - T[i - s]));
}

/* The base of a row: a state itself, or a sum in `row`. */
INLINE const double *row_base(const struct sweep *w, ptrdiff_t at, ptrdiff_t n, double *restrict row) {
    if (w->terms == 1) return w->state[0] + at;
    const double *a = w->state[0] + at, *b = w->state[1] + at, *c = w->state[2] + at, *d = w->state[3] + at;
    for (ptrdiff_t i = 0; i < n && w->terms == 0; i++) row[i] = 0;
    for (ptrdiff_t i = 0; i < n && w->terms == TERMS; i++)
        row[i] = w->weight[0] * a[i] + w->weight[1] * b[i] + w->weight[2] * c[i] + w->weight[3] * d[i];
    return row;
}

/* F of an axis: h kappa/d^2; 0 where ftcs_cross.c has the fluxes. */
INLINE double factor(const struct sweep *w, int a) {
    if (w->g->cross) return 0;
    const double d = w->g->reach * w->g->d[a];
    return w->g->kappa[a] * w->h / (d * d);
}

/* All rows; axes: of the differences of one material, 0 for faces. */
INLINE void sweep_rows(const struct sweep *w, int axes) {
    const struct ftcs_grid *g = w->g;
    const ptrdiff_t n = g->n[0];
    const int along = axes ? axes : g->round ? 1 : g->p->dim;
    const int rows = axes == 1 ? 1 : g->n[1], planes = axes == 1 || axes == 2 ? 1 : g->n[2];
    double F[DIM_MAX];
    ptrdiff_t s[DIM_MAX];
    for (int a = 0; a < along; a++) s[a] = g->reach * g->stride[a], F[a] = factor(w, a);
    for (ptrdiff_t k = 0; k < planes; k++)
        for (ptrdiff_t j = 0; j < rows; j++) {
            const ptrdiff_t at = g->corner + j * g->stride[1] + k * g->stride[2];
            const ptrdiff_t face = g->base + j * g->along[1] + k * g->along[2];
            const double *T = w->of + at, *base = row_base(w, at, n, g->row);
            double *out = w->out + at;
            const double *heating = w->heating ? w->heating + (k * rows + j) * n : NULL;
            if (axes) {
                row_uniform(axes, n, F, s, w->h, heating, base, T, out);
                continue;
            }
            memmove(out, base, (size_t)n * sizeof *out);
            for (int a = 0; a < along; a++)
                row_faces(n, w->h, g->weight + face, g->C[a] + face, g->C[a] + face + g->along[a], s[a], T, out);
            for (ptrdiff_t i = 0; i < n && heating; i++) out[i] += w->h * heating[i];
        }
}

INLINE void sweep(const struct sweep *w) {
    if (w->g->C[0])
        sweep_rows(w, 0);
    else if (w->g->p->dim == 1)
        sweep_rows(w, 1);
    else if (w->g->p->dim == 2)
        sweep_rows(w, 2);
    else
        sweep_rows(w, 3);
}

/* Number of points outside middle +- bound; a NaN is outside. */
INLINE int outside(const struct ftcs_grid *g, ptrdiff_t at) {
    const double *T = g->T + at, middle = g->middle, bound = g->bound;
    int count = 0;
    for (ptrdiff_t i = 0; i < g->n[0]; i++) count += !(fabs(T[i] - middle) <= bound);
    return count;
}

/* ---- Vectors of 2, 4 or 8 doubles ---- */

#if defined(__x86_64__)
#define FOR(machine) __attribute__((target(machine)))
#else
#define FOR(machine)
#endif

static void sweep_2(const struct sweep *w) {
    sweep(w);
}
FOR("avx2") static void sweep_4(const struct sweep *w) {
    sweep(w);
}
FOR("avx512f") static void sweep_8(const struct sweep *w) {
    sweep(w);
}
static int outside_2(const struct ftcs_grid *g, ptrdiff_t at) {
    return outside(g, at);
}
FOR("avx2") static int outside_4(const struct ftcs_grid *g, ptrdiff_t at) {
    return outside(g, at);
}
FOR("avx512f") static int outside_8(const struct ftcs_grid *g, ptrdiff_t at) {
    return outside(g, at);
}

/* ---- Stability ---- */

/* b_j */
static double legendre_share(int j) {
    return j < 2 ? 1. / 3 : ((double)j * j + j - 2) / (2 * j * (j + 1.0));
}

/* The largest dt sum of kappa/dx^2, a quarter of dt times the spectral radius, of s stages. */
static double legendre_reach(int s) {
    return ((double)s * s + s - 2) / 8;
}

/* Smallest odd number of stages for that value: even ones damp the highest modes less. */
static int legendre_stages(double fourier) {
    int s = (int)ceil((sqrt(9 + 32 * fourier) - 1) / 2 - 1e-9) | 1;
    return s < 3 ? 3 : s;
}

/* The largest k of the state over rho_c: k grows with T, or falls with it (k_beta < 0). */
static double law_diffusivity(const struct ftcs_grid *g) {
    double most = 0;
    int i[DIM_MAX] = {0};
    do {
        const double *T = g->T + ftcs_at(g, i);
        double lo = T[0], hi = T[0];
        for (int k = 1; k < g->n[0]; k++) lo = T[k] < lo ? T[k] : lo, hi = T[k] > hi ? T[k] : hi;
        most = fmax(most, fmax(ftcs_face_law(g->p, lo), ftcs_face_law(g->p, hi)));
        i[0] = g->n[0] - 1;
    } while (ftcs_next(g, i));
    return most / g->rho_c;
}

/* dt sum of kappa/dx^2, a quarter of dt times the spectral radius; in a round body along r. */
static double fourier(const struct ftcs_grid *g) {
    const struct problem *p = g->p;
    double rate = 0, most = 0;
    for (int a = 0; a < (g->round ? 1 : p->dim); a++) rate += (p->k_law ? 1 : g->kappa[a]) / (g->d[a] * g->d[a]);
    if (g->cross && p->dim == 3) rate *= 9. / 8; /* ftcs_cross.c */
    for (int i = 0; p->k_frozen && i < (int)g->size; i++) most = fmax(most, g->law[i]);
    if (p->k_law) rate *= p->k_frozen ? most / g->rho_c : law_diffusivity(g);
    for (int i = 0; p->materials == 2 && i < g->n[0]; i++) {
        double here = 0;
        for (int a = 0; a < p->dim; a++) here += g->weight[i] * (g->C[a][i] + g->C[a][i + g->along[a]]) / 2;
        rate = fmax(rate, here);
    }
    return g->dt * rate;
}

static double fourier_most(const struct ftcs_grid *g) {
    const double most = g->o->stepper == STEPPER_RKL2 ? legendre_reach(LEGENDRE_MOST) : 0.5;
    return g->round && g->p->dim == 3 ? 0.47 : most * g->reach * g->reach;
}

/* ---- Steps ---- */

/* w->out = base + w->h f(T, t) */
static void advance(struct sweep *w, struct ftcs_grid *g, double *T, double t) {
    static void (*const sweeps[])(const struct sweep *) = {sweep_2, sweep_4, sweep_8};
    if (g->changes) ftcs_set_time(g, t);
    if (g->law && !g->p->k_frozen) ftcs_face_refresh(g, T);
    ftcs_wall_ghosts(g, T);
    if (g->cross) ftcs_cross(g, T);
    w->g = g, w->heating = g->cross ? g->cross : g->heating, w->of = g->law && !g->C[0] ? g->law : T;
    sweeps[g->width](w);
    g->applications++;
}

static void step_euler(struct ftcs_grid *g, double t) {
    double *T = g->T, *next = g->state[0];
    advance(&(struct sweep){.h = g->dt, .terms = 1, .state = {T}, .out = next}, g, T, t);
    if (g->round) ftcs_round_angles(g, next);
    g->T = next, g->state[0] = T;
}

static void step_midpoint(struct ftcs_grid *g, double t) {
    double *T = g->T, *half = g->state[0], *next = g->state[1];
    advance(&(struct sweep){.h = g->dt / 2, .terms = 1, .state = {T}, .out = half}, g, T, t);
    advance(&(struct sweep){.h = g->dt, .terms = 1, .state = {T}, .out = next}, g, half, t + g->dt / 2);
    g->T = next, g->state[1] = T;
}

static void step_legendre(struct ftcs_grid *g, double t) {
    const int s = legendre_stages(fourier(g) / (g->reach * g->reach));
    const double w = 4 / ((double)s * s + s - 2), dt = g->dt, first = w / 3;
    double *T = g->T, *rate = g->state[2], *newer = g->state[0], *older = T;
    advance(&(struct sweep){.h = dt, .out = rate, .state = {T, T, T, T}}, g, T, t);
    for (size_t i = 0; i < g->size; i++) newer[i] = T[i] + first * rate[i];
    for (int j = 2; j <= s; j++) {
        const double b = legendre_share(j), mu = (2.0 * j - 1) / j * b / legendre_share(j - 1), m = mu * w;
        const double nu = -(j - 1.0) / j * b / legendre_share(j - 2);
        const double time = j == 2 ? first : legendre_share(j - 1) * w * j * (j - 1.0) / 2;
        double *out = j == 2 ? g->state[1] : older;
        advance(&(struct sweep){.h = m * dt,
                                .terms = TERMS,
                                .weight = {mu, nu, 1 - mu - nu, -(1 - legendre_share(j - 1)) * m},
                                .state = {newer, older, T, rate},
                                .out = out},
                g, newer, t + time * dt);
        older = newer, newer = out;
    }
    g->T = newer, g->state[0] = older, g->state[1] = T;
    if (s > g->stages) g->stages = s;
}

/* The time error of rkl2 at the end of a run: a linear problem with steady data adds -dt^3/18 (1 + 8/(s^2 + s - 2))
 * T_ttt in each of its steps, and their sum is t times the last one, since T_ttt decays as the errors do.  (With
 * walls that change it is less.)  dt^2 T_ttt is the second difference of f in the last two steps.  A source that is
 * linear in a step adds dt^3/12 G_tt/rho_c, 3/2 of the first where T_ttt is due to the source. */
static double time_error(struct ftcs_grid *g) {
    const double s = g->stages, *last = g->state[2], *before = g->before;
    double *rate = g->state[0], sum = 0, volume = 0;
    int i[DIM_MAX] = {0};
    advance(&(struct sweep){.h = g->dt, .out = rate, .state = {g->T, g->T, g->T, g->T}}, g, g->T,
            (double)g->steps * g->dt);
    g->applications--;
    do {
        const ptrdiff_t at = ftcs_at(g, i);
        const double cell = ftcs_volume(g, i);
        sum += cell * fabs((rate[at] - last[at]) - (last[at] - before[at])), volume += cell;
    } while (ftcs_next(g, i));
    return (double)g->steps / 18 * (1 + 8 / (s * s + s - 2)) * sum / volume;
}

/* ---- A run ---- */

/* Whether the state is one of a stable run. */
static int is_stable(const struct ftcs_grid *g) {
    static int (*const outsides[])(const struct ftcs_grid *, ptrdiff_t) = {outside_2, outside_4, outside_8};
    for (ptrdiff_t k = 0; k < g->n[2]; k++)
        for (ptrdiff_t j = 0; j < g->n[1]; j++)
            if (outsides[g->width](g, g->corner + j * g->stride[1] + k * g->stride[2])) return 0;
    return !g->p->k_law || fourier(g) <= fourier_most(g) * (1 + 1e-9);
}

/* The first cell outside the bound; else, with k(T), the hottest one. */
static int refuse_unstable(const struct ftcs_grid *g, long long step, struct failure *why) {
    int i[DIM_MAX] = {0}, at[DIM_MAX] = {0};
    do {
        double T = g->T[ftcs_at(g, i)], most = g->T[ftcs_at(g, at)];
        int is_outside = !(fabs(T - g->middle) <= g->bound);
        if (is_outside || ftcs_face_law(g->p, T) > ftcs_face_law(g->p, most)) memcpy(at, i, sizeof at);
        if (is_outside) break;
    } while (ftcs_next(g, i));
    double x[DIM_MAX];
    char place[120] = "", pace[PACE_TEXT], limit[PACE_TEXT];
    ftcs_place(g, at, x);
    for (int a = 0; a < g->p->dim; a++) {
        size_t used = strlen(place);
        snprintf(place + used, sizeof place - used, "%s%c = %g m", a ? ", " : "", 'x' + a, x[a]);
    }
    snprintf(limit, sizeof limit, "; sum of kappa dt/dx^2 is %g, stable up to %g%s", fourier(g), fourier_most(g),
             g->p->k_law ? "; use a smaller --dt" : "");
    problem_wall_pace(g->p, g->dt, pace);
    return refuse(why, STATUS_UNSTABLE, "%s: unstable at step %lld of %lld, t = %g s: T = %g K at %s%s", g->method,
                  step, g->steps, g->start + (double)step * g->dt, ftcs_face_temperature(g->p, g->T[ftcs_at(g, at)]),
                  place, *pace ? pace : limit);
}

int ftcs_run(struct ftcs_grid *g, struct failure *why) {
    const double mean = g->dt;
    const int every = g->p->k_law ? 1 : CHECK_EVERY;
    const enum stepper_name stepper = g->o->stepper;
    for (long long step = 0; step <= g->steps; step++) {
        if ((step % every == 0 || step == g->steps) && !is_stable(g)) return refuse_unstable(g, step, why);
        if (step == g->steps) break;
        const double t = (double)step * mean;
        if (stepper == STEPPER_RKL2 && step > 1 && step == g->steps - 1) {
            g->before = g->state[2];
            g->state[2] = xcalloc(g->size, sizeof *g->before);
            g->held += g->size;
        }
        g->dt = mean * (step % 2 ? 1 - g->alternation : 1 + g->alternation);
        ftcs_set_step(g, t);
        (stepper == STEPPER_RKL2 ? step_legendre : stepper == STEPPER_RK2 ? step_midpoint : step_euler)(g, t);
        g->dt = mean;
    }
    if (g->before) g->time_error = time_error(g);
    return STATUS_OK;
}
