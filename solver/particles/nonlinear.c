/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particles with a conductivity that depends on T: dT/dt = L(T, t) by explicit steps, with walls and source at the
 * time of each stage.
 *
 *   euler  T += dt L(T, t)
 *   rk2    H = T + dt/2 L(T, t),  T += dt L(H, t + dt/2)
 *   rkl2   Y_1 = Y_0 + m_1 dt L_0
 *          Y_j = a_j Y_(j-1) + n_j Y_(j-2) + (1 - a_j - n_j) Y_0 + m_j dt L_(j-1) + g_j dt L_0
 *          a_j = (2j - 1)/j b_j/b_(j-1),  n_j = -(j - 1)/j b_j/b_(j-2),  m_j = w a_j,  g_j = -(1 - b_(j-1)) m_j,
 *          m_1 = w b_1,  w = 4/(s^2 + s - 2),  b_j = (j^2 + j - 2)/(2 j (j + 1)), b_0 = b_1 = b_2
 *
 * (Meyer, Balsara & Aslam 2014, eqs. 16-18).  For an L that depends on time, t joins the unknowns with the rate 1:
 * a stage then has the time that the scheme itself gives to t, t + c_j dt with c_1 = m_1 = 4/(3 (s^2 + s - 2)) and
 * c_j = (j^2 + j - 2)/(s^2 + s - 2).  The conditions for order 2 are the same for linear and nonlinear L, so order 2
 * holds with data that change.
 *
 * Without --dt a step is half of the stable one (rkl2: sqrt(t_end/bound)) for the largest k of the state at its
 * start.  RKL2 takes its number of stages from the same k. */
#include "solver/particles/conduction.h"
#include "solver/space/sample.h"
#include "solver/work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct run {
    struct conduction *c;
    const struct problem *p;
    const struct options *o;
    const struct stepper *stepper;
    size_t n;
    double *T, *state[4]; /* K: the particles; Y_(j-1), Y_(j-2), and K s^-1: L_0, L */
    double t, dt;
    long long steps, applications;
    int stages; /* most in a step */
};

static void apply(struct run *r, const double *T, double t, double *out) {
    conduction_rate(r->c, T, t, out);
    r->applications++;
}

static void step_euler(struct run *r) {
    for (size_t i = 0; i < r->n; i++) r->T[i] += r->dt * r->state[2][i];
}

static void step_rk2(struct run *r) {
    for (size_t i = 0; i < r->n; i++) r->state[0][i] = r->T[i] + r->dt / 2 * r->state[2][i];
    apply(r, r->state[0], r->t + r->dt / 2, r->state[3]);
    for (size_t i = 0; i < r->n; i++) r->T[i] += r->dt * r->state[3][i];
}

static double b(int j) {
    return j < 2 ? 1. / 3 : ((double)j * j + j - 2) / (2 * j * (j + 1.0));
}

static void step_rkl2(struct run *r, int s) {
    double all = (double)s * s + s - 2, w = 4 / all, *newer = r->state[0], *older = r->state[1];
    const double *L0 = r->state[2], *L = r->state[3];
    for (size_t i = 0; i < r->n; i++) older[i] = r->T[i], newer[i] = r->T[i] + w * b(1) * r->dt * L0[i];
    for (int j = 2; j <= s; j++) {
        double c = j == 2 ? w * b(1) : ((j - 1.0) * (j - 1) + j - 3) / all;
        double a = (2.0 * j - 1) / j * b(j) / b(j - 1), v = -(j - 1.0) / j * b(j) / b(j - 2), m = w * a;
        apply(r, newer, r->t + c * r->dt, r->state[3]);
        for (size_t i = 0; i < r->n; i++)
            older[i] =
                a * newer[i] + v * older[i] + (1 - a - v) * r->T[i] + r->dt * m * (L[i] - (1 - b(j - 1)) * L0[i]);
        double *swap = newer;
        newer = older, older = swap;
    }
    memcpy(r->T, newer, r->n * sizeof *newer);
}

/* Refuses a state outside the data by more than their range and the heat received; a NaN is outside. */
static int check_range(const struct run *r, const double data[2], struct failure *why) {
    double lo, hi, heating, x[DIM_MAX];
    conduction_range(r->c, &lo, &hi, &heating);
    lo = fmin(lo, data[0]), hi = fmax(hi, data[1]);
    double slack = hi - lo + 2 * heating * r->p->t_end + 1e-6 * fmax(fabs(lo), fabs(hi));
    for (size_t i = 0; i < r->n; i++) {
        if (r->T[i] >= lo - slack && r->T[i] <= hi + slack) continue;
        layout_cloud_place(conduction_cloud(r->c), i, x);
        return refuse(
            why, STATUS_UNSTABLE,
            "unstable: at step %lld (t = %.6g s) particle %zu at (%.6g, %.6g) m has %.4g K, the data are in "
            "[%.4g, %.4g] K; dt = %.6g s is too large for k(T)",
            r->steps, r->t, i, x[0], x[1], r->T[i], lo, hi, r->dt);
    }
    return STATUS_OK;
}

/* Length of the next step: a whole number of equal steps to the end. */
static double next_step(const struct run *r, double bound) {
    const struct options *o = r->o;
    double left = r->p->t_end - r->t, dt = o->dt;
    if (dt == 0 && o->fourier > 0) dt = o->fourier * o->dx * o->dx / problem_diffusivity(r->p);
    if (dt == 0) dt = r->stepper->length ? r->stepper->length(0, r->p->t_end, bound) : 1 / bound;
    return left / fmax(1, ceil(left / dt - 1e-9));
}

static int march(struct run *r, const double data[2], struct failure *why) {
    enum { STEPS_MAX = 100000000 };
    while (r->t < r->p->t_end) {
        apply(r, r->T, r->t, r->state[2]);
        double bound = conduction_bound(r->c);
        r->dt = next_step(r, bound);
        int s = r->stepper->count ? r->stepper->count(r->dt, bound) : r->stepper->stages;
        if (!(r->dt > 1e-12 * r->p->t_end) || s > STEPPER_STAGES_MAX || r->steps >= STEPS_MAX)
            return refuse(why, STATUS_UNSTABLE,
                          "unstable: at step %lld (t = %.6g s) k(T) would need steps of %.3g s with %d stages",
                          r->steps, r->t, r->dt, s);
        r->stages = s > r->stages ? s : r->stages;
        if (r->stepper->count)
            step_rkl2(r, s);
        else if (r->stepper->stages == 2)
            step_rk2(r);
        else
            step_euler(r);
        double left = r->p->t_end - r->t;
        r->t = left - r->dt <= 1e-9 * r->dt ? r->p->t_end : r->t + r->dt;
        r->steps++;
        if (check_range(r, data, why)) return why->status;
    }
    return STATUS_OK;
}

static void count(const struct run *r, const struct lattice *l, struct field *f) {
    f->h = r->o->h;
    f->steps = r->steps, f->stages = r->stages, f->dt = r->steps ? r->p->t_end / (double)r->steps : 0;
    f->applications = r->applications;
    f->bound = conduction_bound(r->c);
    f->cost.updates = r->applications * (long long)r->n;
    f->cost.interactions = r->applications * (long long)conduction_pairs(r->c);
    f->cost.work = WORK_SCALAR * ((double)f->cost.interactions + WORK_FUNCTION * (double)f->cost.updates);
    f->cost.bytes = conduction_bytes(r->c) + r->n * (size_t)(l->dim + 5) * sizeof(double);
    for (int a = 0; a < l->dim; a++) {
        f->shape[a] = l->dim == 1 && !options_is_cloud(r->o) ? l->n[a] : 0;
        f->spacing[a] = l->dx[a];
    }
    for (int a = l->dim; a < DIM_MAX && f->shape[0]; a++) f->shape[a] = 1;
}

static double heat(const struct problem *p, const struct field *f, double volume) {
    double sum = 0;
    for (size_t i = 0; i < f->n; i++) sum += f->T[i];
    return p->material[0].rho_c * volume * sum;
}

/* Positions and initial data. */
static void start(const struct problem *p, const struct options *o, const struct lattice *l, const struct cloud *c,
                  struct field *f) {
    field_alloc(f, p->dim, c->n);
    f->range[0] = INFINITY, f->range[1] = -INFINITY;
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX];
        layout_cloud_place(c, i, x);
        field_put(f, i, x);
        f->T[i] = sample_initial(p, o->sampling, l->dx, x);
        f->range[0] = fmin(f->range[0], f->T[i]), f->range[1] = fmax(f->range[1], f->T[i]);
    }
}

int nonlinear_solve(const struct method *m, const struct problem *p, const struct options *given, struct field *out,
                    struct failure *why) {
    double begin = field_clock();
    struct options o;
    struct lattice l;
    struct conduction *c = NULL;
    struct field f = {0};
    int rows;
    if (particles_prepare(p, given, m->scheme, &o, &l, &rows, why)) return why->status;
    if (o.stepper == STEPPER_AUTO) o.stepper = stepper_auto(1, o.dt > 0 || o.fourier > 0, 0);
    int status = conduction_create(&c, p, &o, m->scheme, &l, why);
    if (!status) {
        start(p, &o, &l, conduction_cloud(c), &f);
        struct run r = {.c = c, .p = p, .o = &o, .stepper = stepper_of(o.stepper), .n = f.n, .T = f.T};
        for (int k = 0; k < 4; k++) r.state[k] = xcalloc(f.n, sizeof(double));
        f.heat[0] = heat(p, &f, layout_volume(&l));
        double loop = field_clock();
        status = march(&r, f.range, why);
        f.cost.step_seconds = field_clock() - loop;
        f.heat[1] = heat(p, &f, layout_volume(&l));
        f.time = p->t_end;
        count(&r, &l, &f);
        for (int k = 0; k < 4; k++) free(r.state[k]);
    }
    conduction_free(c);
    f.cost.seconds = field_clock() - begin;
    if (status)
        field_free(&f);
    else
        *out = f;
    return status;
}
