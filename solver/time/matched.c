/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The matched run: fourth order from a second-order operator and Euler's method, also for data with jumps.
 *
 * On a lattice of spacing dx the symbol of the operator is, with theta = xi dx,
 *   lambda = (kappa / dx^2) (-|theta|^2 + A sum_a theta_a^4 + B sum_(a<b) theta_a^2 theta_b^2 + O(theta^6)),
 *   A = sum_j w_j x_j^4 / (24 kappa dx^2),   B = sum_j w_j x_j^2 y_j^2 / (4 kappa dx^2)      (w in s^-1).
 * Euler's n = t/dt steps multiply a mode by (1 + dt lambda)^n = exp(n (dt lambda - (dt lambda)^2 / 2 + ...)).  The
 * exponent divided by t is
 *   -kappa |xi|^2 + kappa dx^2 (A sum_a xi_a^4 + B sum_(a<b) xi_a^2 xi_b^2) - (dt/2) kappa^2 |xi|^4 + O(dx^4).
 * With isotropy, B = 2 A, the leading error is A |xi|^4.  Steps with F = kappa dt / dx^2 = 2 A cancel it, and the
 * remaining error is O(dx^4).  A run is rarely a whole number of such steps, and a rounded number would leave an
 * error that jumps from rung to rung.  The condition is on the sum of dt^2: an even number n of steps, at least t /
 * dt(2 A), alternates between d (1 + u) and d (1 - u), d = t / n, with 1 + u^2 = 2 A dx^2 / (kappa d).  Then u^2 < 2
 * / n, so u tends to zero with dx.
 *
 * Initial data: averaging with a B-spline of order m multiplies a mode by
 *   (sin(theta/2) / (theta/2))^m = 1 - m theta^2 / 24 + ... = exp(-kappa xi^2 t_m) up to O(dx^4)
 * with t_m = m dx^2 / (24 kappa), along each axis.  The run therefore starts at t_m.  Point samples of a jump midway
 * between particles have the spectrum of the jump times (theta/2) / sin(theta/2), equivalent to m = -1.  Point
 * samples of smooth data have m = 0.  Other point samples are refused: a jump elsewhere (including a wall with a
 * value that differs from the data), a jump along some axes only, data that vary between jumps.  Aliasing adds an
 * error O(dx^(m+1)), from the zeros of order m at the multiples of 2 pi / dx, so m = 4 keeps fourth order for a jump
 * at any place.
 *
 * Source: in the steady state L T = -G, Euler's method has no error, and the operator leaves A dx^2 / kappa L^2
 * T = -A dx^2 / kappa L G.  In a transient Euler's error (dt/2) T_tt contains (dt/2) L G in addition to (dt/2) L^2
 * T.  In both cases the source must be G + A dx^2 / kappa L G, on the lattice G + A sum_a D_a^2 G with second
 * differences D^2.
 *
 * Limits: no sixth order, and no other lattice.  Let the next term of the symbol be -C (theta_x^6 + theta_y^6) - D
 * (theta_x^4 theta_y^2 + theta_x^2 theta_y^4).  Steps f_i = kappa dt_i / dx^2 of sixth order satisfy, with T = kappa
 * t / dx^2,
 *   sum f = T,   sum f^2 = 2 A T - m / 1440,   sum f^3 = 3 (A sum f^2 - C T - m / 181440).
 * On a rod two step lengths 2 A +- sqrt(2 A^2 - 3 C) in equal shares of the time satisfy this up to whole counts,
 * and finite differences (A = 1/12, C = 1/360) showed order 6.0 on a jump.  But only point samples of a jump midway
 * are that exact, walls would need a further derivative, and the three lengths required by whole counts scatter from
 * rung to rung.  In the plane D = 3 C must hold together with B = 2 A; |D - 3 C| is 0.004 to 0.03 there, and zero
 * for no kernel.  On a hexagonal lattice theta^4 is isotropic at every h/dx (seven points: A = 1/16, F = 1/8), so
 * fourth order holds without --h iso, but theta^6 is not, and the walls of a rectangle follow the rows in at most
 * one direction. */
#include "solver/time/matched.h"
#include "solver/space/sample.h"
#include "solver/time/stepper.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdlib.h>

/* From an octant of weights in units of kappa / dx^2. */
static struct symbol_error symbol_of(const int reach[DIM_MAX], const double *w, double unit) {
    struct symbol_error e = {0, 0};
    for (int k = 0; k <= reach[2]; k++)
        for (int j = 0; j <= reach[1]; j++)
            for (int i = 0; i <= reach[0]; i++) {
                double all = w[operator_offset(reach, i, j, k)] / unit * operator_images(i, j, k);
                double x2 = i * i, y2 = j * j;
                e.A += all * x2 * x2 / 24;
                e.B += all * x2 * y2 / 4;
            }
    return e;
}

int matched_symbol(int dim, const struct options *o, const struct scheme *s, struct symbol_error *e,
                   struct failure *why) {
    struct problem unit = {
        .dim = dim, .hi = {1, 1, 1}, .materials = 1, .material = {{{1, 1, 1}, 1}}, .wall = problem_held};
    double kappa[DIM_MAX] = {1, 1, 1}, *w;
    int reach[DIM_MAX];
    if (operator_stencil(&unit, o, s, 1, kappa, reach, &w, why)) return why->status;
    *e = symbol_of(reach, w, 1);
    free(w);
    return STATUS_OK;
}

struct isotropy {
    int dim;
    struct options o;
    const struct scheme *s;
    double end[2], value[2]; /* known values at the ends of a bracket */
};

static double anisotropy(double h, void *context) {
    struct isotropy *c = context;
    struct symbol_error e;
    struct failure ignored;
    for (int k = 0; k < 2; k++)
        if (h == c->end[k]) return c->value[k];
    c->o.h = h;
    return matched_symbol(c->dim, &c->o, c->s, &e, &ignored) ? NAN : e.B - 2 * e.A;
}

/* Root in [lo, hi] by Brent's method; at_lo and at_hi are the values at the ends. */
static double polish(struct isotropy *c, double lo, double hi, double at_lo, double at_hi) {
    gsl_function f = {anisotropy, c};
    c->end[0] = lo, c->end[1] = hi, c->value[0] = at_lo, c->value[1] = at_hi;
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_root_fsolver_set(solver, &f, lo, hi);
    double root = NAN, before;
    for (int k = 0; k < 100; k++) {
        gsl_root_fsolver_iterate(solver);
        before = root, root = gsl_root_fsolver_root(solver);
        if (gsl_root_test_delta(root, before, 1e-8, 0) == GSL_SUCCESS) break; /* 1e-12: the order is 1.6 */
    }
    gsl_root_fsolver_free(solver);
    return root;
}

/* At order 4 A and B vanish at every h. */
static int check_order(const struct options *o, const char *option, struct failure *why) {
    if (o->order < 4) return STATUS_OK;
    return refuse(why, STATUS_NOT_APPLICABLE, "%s: --order %d has no second-order error to cancel; use --order 2",
                  option, o->order);
}

int matched_isotropic(int dim, const struct options *o, const struct scheme *s, double *h, struct failure *why) {
    if (check_order(o, "--h iso", why)) return why->status;
    struct isotropy c = {.dim = dim == 3 ? 3 : 2, .o = *o, .s = s};
    const double middle = c.dim == 3 ? 1 : 1.2, step = 1.0 / 16, least = 0.75, most = 3;
    double above = anisotropy(middle, &c), below = above, best = NAN;
    /* Search outward from the middle.  The weight of a new neighbour starts from zero, so B - 2 A is continuous in h
     * and a change of sign is a root.  If both directions find one in the same step, the closer one is used.  The
     * roots of a kernel are about 0.3 apart, and at least 0.1. */
    for (int k = 1; isnan(best) && middle + (k - 1) * step < most; k++) {
        double far = middle + k * step, near = middle - k * step, up = anisotropy(far, &c), down = NAN;
        if (near > least) down = anisotropy(near, &c);
        if (above * up <= 0) best = polish(&c, far - step, far, above, up);
        double other = below * down <= 0 ? polish(&c, near, near + step, down, below) : NAN;
        if (isnan(best) || fabs(other - middle) < fabs(best - middle)) best = other;
        above = up, below = down;
    }
    if (isnan(best))
        return refuse(why, STATUS_NOT_APPLICABLE, "--h iso: this kernel has no isotropic h/dx between 0.75 and 3");
    *h = best;
    return STATUS_OK;
}

/* Planes normal to an axis at which the lattice data jump: those of the problem, and walls with other values than
 * the data. */
static int list_jumps(const struct problem *p, const struct lattice *l, int axis, double plane[JUMP_MAX + 2]) {
    int n = 0;
    for (int k = 0; k < p->jumps[axis]; k++)
        if (p->jump[axis][k] > p->lo[axis] && p->jump[axis][k] < p->hi[axis]) plane[n++] = p->jump[axis][k];
    for (int s = 2 * axis; s < 2 * axis + 2; s++)
        if (p->side[s] == DIRICHLET && !sample_meets_wall(p, l, (enum side)s))
            plane[n++] = s % 2 ? p->hi[axis] : p->lo[axis];
    return n;
}

/* 1 if the data differ between two neighbours with no plane between them. */
static int varies(const struct problem *p, const struct lattice *l, int axis, const double *plane, int planes) {
    for (int k = 0; k < l->n[2] - (axis == 2); k++)
        for (int j = 0; j < l->n[1] - (axis == 1); j++)
            for (int i = 0; i < l->n[0] - (axis == 0); i++) {
                double x[DIM_MAX], next[DIM_MAX];
                int divided = 0;
                layout_position(l, i, j, k, x);
                layout_position(l, i + (axis == 0), j + (axis == 1), k + (axis == 2), next);
                for (int m = 0; m < planes; m++) divided |= x[axis] < plane[m] && plane[m] < next[axis];
                if (!divided && p->initial(p, x) != p->initial(p, next)) return 1;
            }
    return 0;
}

/* 1 if T_nnnn is not zero on some Dirichlet side: there is a source, or the wall value varies along the side. */
static int walls_bend(const struct problem *p, const struct lattice *l) {
    for (int s = 0; s < 2 * l->dim; s++) {
        int axis = s / 2, along = axis == 0, across = axis == 2 ? 1 : 2;
        double first[DIM_MAX], foot[DIM_MAX];
        if (p->side[s] != DIRICHLET) continue;
        if (p->source) return 1;
        layout_position(l, 0, 0, 0, first);
        first[axis] = s % 2 ? p->hi[axis] : p->lo[axis];
        for (int line = 1; line < l->n[along] * l->n[across]; line++) {
            int at[DIM_MAX] = {0};
            at[along] = line % l->n[along], at[across] = line / l->n[along];
            layout_position(l, at[0], at[1], at[2], foot);
            foot[axis] = first[axis];
            if (p->wall(p, (enum side)s, foot, 0) != p->wall(p, (enum side)s, first, 0)) return 1;
        }
    }
    return 0;
}

int matched_check(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                  struct failure *why) {
    double plane[DIM_MAX][JUMP_MAX + 2];
    int jumps[DIM_MAX], jumping = 0, vary = 0; /* number of axes with jumps */
    if (s->sweeps == 2 && walls_bend(p, l))
        return refuse(
            why, STATUS_NOT_APPLICABLE,
            "--stepper matched: a first derivative applied twice annihilates (-1)^i, which a wall with a source or "
            "with varying data excites at third order; use so_ssph");
    if (o->sampling != SAMPLING_POINT) return STATUS_OK;
    for (int a = 0; a < p->dim; a++) {
        jumps[a] = list_jumps(p, l, a, plane[a]), jumping += jumps[a] > 0;
        for (int k = 0; k < jumps[a]; k++) {
            double at = (plane[a][k] - l->first[a]) / l->dx[a];
            if (fabs(at - floor(at) - 0.5) < 1e-6) continue;
            return refuse(
                why, STATUS_NOT_APPLICABLE,
                "--stepper matched: the initial data jump at %c = %.6g m, not midway between two particles, so point "
                "samples have no known order; use --sampling spline",
                "xyz"[a], plane[a][k]);
        }
        vary |= varies(p, l, a, plane[a], jumps[a]);
    }
    if (jumping > 0 && (vary || jumping < p->dim))
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "--stepper matched: the initial data jump %s: point samples of jumps and of smooth data start "
                      "at different times; "
                      "use --sampling spline",
                      vary          ? "and vary between the jumps"
                      : jumping > 1 ? "along two axes only"
                                    : "along one axis only");
    return STATUS_OK;
}

/* Valid for data accepted by matched_check. */
static double filter_order(const struct problem *p, const struct options *o, const struct lattice *l) {
    double plane[JUMP_MAX + 2];
    if (o->sampling == SAMPLING_CELL) return 1;
    if (o->sampling == SAMPLING_SPLINE) return 4;
    return list_jumps(p, l, 0, plane) ? -1 : 0;
}

static double start_time(const struct problem *p, const struct options *o, const struct lattice *l) {
    return filter_order(p, o, l) * l->dx[0] * l->dx[0] / (24 * p->material[0].k[0] / p->material[0].rho_c);
}

void matched_source(const struct problem *p, const struct options *o, struct heat_operator *a, double *T) {
    const struct lattice *l = &a->lattice;
    double unit = p->material[0].k[0] / p->material[0].rho_c / (l->dx[0] * l->dx[0]), late = start_time(p, o, l);
    double A = symbol_of(a->reach, a->weight, unit).A;
    for (int k = 0; k < l->n[2] && p->source && a->g; k++)
        for (int j = 0; j < l->n[1]; j++)
            for (int i = 0; i < l->n[0]; i++) {
                double x[DIM_MAX], beside[DIM_MAX], G, around = 0;
                layout_position(l, i, j, k, x);
                G = p->source(p, x) / p->material[0].rho_c;
                for (int step = -1; step < 2; step += 2)
                    for (int d = 0; d < l->dim; d++) {
                        layout_position(l, i + (d == 0) * step, j + (d == 1) * step, k + (d == 2) * step, beside);
                        around += p->source(p, beside) / p->material[0].rho_c - G;
                    }
                a->g[operator_place(a, j, k) + i] += A * around;
                *T++ += late * G;
            }
}

/* F = 2 A, or the step given by the user. */
static int matching_step(const struct problem *p, const struct options *o, const struct scheme *s,
                         const struct heat_operator *a, double unit, double *F, struct failure *why) {
    *F = o->fourier;
    if (o->fourier > 0) return STATUS_OK;
    if (check_order(o, "--stepper matched", why)) return why->status;
    struct symbol_error e;
    if (a->weight)
        e = symbol_of(a->reach, a->weight, unit);
    else if (matched_symbol(p->dim, o, s, &e, why)) /* rows of a periodic lattice */
        return why->status;
    if (p->dim > 1 && !(fabs(e.B - 2 * e.A) < 1e-9 * fabs(e.A))) {
        double iso;
        if (matched_isotropic(p->dim, o, s, &iso, why)) return why->status;
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "--h %.12g: not isotropic (A = %.4g, B = %.4g; B = 2 A is required), so no step matches; use "
                      "--h iso (%.12g)",
                      o->h, e.A, e.B, iso);
    }
    if (!(e.A > 0))
        return refuse(why, STATUS_NOT_APPLICABLE, "--stepper matched: A = %.4g, no positive step matches", e.A);
    *F = 2 * e.A;
    return STATUS_OK;
}

/* An even number of Euler steps that alternate between dt (1 + alternation) and dt (1 - alternation), and their
 * total time. --fourier F replaces the matching step, to show the effect of the match. */
static int plan(const struct problem *p, const struct options *o, const struct scheme *s,
                const struct heat_operator *a, struct march *m, struct failure *why) {
    struct lattice l = a->lattice;
    if (!a->weight && layout_lattice(p, o, &l, why)) return why->status;
    double F, kappa = p->material[0].k[0] / p->material[0].rho_c, dx2 = l.dx[0] * l.dx[0];
    if (o->dt > 0) return refuse(why, STATUS_INPUT, "--stepper matched: sets its own step; omit --dt");
    if (matching_step(p, o, s, a, kappa / dx2, &F, why)) return why->status;
    m->time = p->t_end - start_time(p, o, &l);
    if (!(m->time > 0))
        return refuse(why, STATUS_INPUT, "--t-end %g: the averaged initial data correspond to %g s", p->t_end,
                      p->t_end - m->time);
    double matching = m->time * kappa / (F * dx2); /* number of steps of F */
    if (!(matching > 1e-6 && matching < 1e12))
        return refuse(why, STATUS_INPUT, "--stepper matched: with F = %g the run has %.3g steps; valid: 1e-6 to 1e12",
                      F, matching);
    m->steps = 2 * (long long)ceil(matching / 2 - 1e-9);
    m->alternation = sqrt(fmax(0, (double)m->steps / matching - 1));
    m->stepper = STEPPER_EULER;
    return STATUS_OK;
}

const struct stepper stepper_matched = {.name = "matched",
                                        .about = "the Euler step that cancels the spatial error: fourth order",
                                        .needs = matched_check,
                                        .plan = plan};
