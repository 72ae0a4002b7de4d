/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The finite volumes in rods, rectangles and boxes against exact statements: modes, fields that the differences
 * represent, heat, axes, two materials, limits of the step. */

#include "solver/field.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "solver/shape.h"
#include "solver/time/stepper.h"

#include "verification/unit/near.h"

#include <complex.h>
#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

extern const struct method method_ftcs, method_ftcs_flux;
static const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
static const double PI = 3.14159265358979323846;

/* Parameters p->param[]: mode numbers along x, y, z, a level, an amplitude, a rate. */
enum { MODE, LEVEL = 3, AMPLITUDE, RATE };

static double mode(const struct problem *p, const double *x) {
    double T = 1;
    for (int a = 0; a < p->dim; a++) {
        double phase = p->param[MODE + a] * PI * (x[a] - p->lo[a]) / (p->hi[a] - p->lo[a]);
        T *= p->side[2 * a] == DIRICHLET ? sin(phase) : cos(phase);
    }
    return p->param[LEVEL] + p->param[AMPLITUDE] * T;
}

static double level(const struct problem *p, enum side s, const double *x, double t) {
    (void)x, (void)t;
    return p->side[s] == DIRICHLET ? p->param[LEVEL] : 0;
}

/* 0.046, 0.115 and 0.23 m divide its sides of 2.3 m, 1.38 m and 0.92 m; no two of its numbers are equal. */
static struct problem body(int dim) {
    struct problem p = {.dim = dim,
                        .t_end = 0.37,
                        .materials = 1,
                        .material = {{{0.29, 0.71, 0.43}, 2.385}},
                        .param = {7, 4, 3, 0.83, 1.9},
                        .initial = mode,
                        .wall = level};
    static const double lo[DIM_MAX] = {-0.7, 0.2, -0.31}, hi[DIM_MAX] = {1.6, 1.58, 0.61};
    for (int a = 0; a < dim; a++) p.lo[a] = lo[a], p.hi[a] = hi[a];
    return p;
}

static void set_sides(struct problem *p, enum side_kind kind) {
    for (int s = 0; s < SIDES; s++) p->side[s] = kind;
}

static struct field solved(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f;
    struct failure why = {0};
    if (method_solve(m, p, o, &f, &why)) fail_msg("%s", why.text);
    return f;
}

static void refused(const struct method *m, const struct problem *p, const struct options *o, int status,
                    const char *part) {
    struct field f;
    struct failure why = {0};
    assert_int_equal(method_solve(m, p, o, &f, &why), status);
    assert_has(why.text, part);
}

typedef double at_time(const struct problem *p, const double *x, double t);

static double farthest(const struct problem *p, const struct field *f, at_time *want) {
    double most = 0, x[DIM_MAX];
    for (size_t i = 0; i < f->n; i++) {
        double apart = fabs(f->T[i] - want(p, field_place(f, i, x), f->time));
        if (!(apart <= most)) most = apart;
    }
    return most;
}

/* ---- Modes ---- */

/* kappa times the symbol on the mode, s^-1, summed over the axes */
static double decay(const struct method *m, const struct problem *p, double dx) {
    double sum = 0;
    for (int a = 0; a < p->dim; a++) {
        double phase = p->param[MODE + a] * PI * dx / (p->hi[a] - p->lo[a]);
        double symbol = m == &method_ftcs ? 4 * pow(sin(phase / 2), 2) : pow(sin(phase), 2);
        sum += p->material[0].k[a] / p->material[0].rho_c / (dx * dx) * symbol;
    }
    return sum;
}

static double decayed(const struct problem *p, const double *x, double t) {
    (void)t;
    return p->param[LEVEL] + p->param[RATE] * (mode(p, x) - p->param[LEVEL]);
}

/* Each step multiplies a mode by the amplification factor of the stepper, on held, insulated and periodic sides. */
static void modes_are_amplified_by_each_step(void **state) {
    (void)state;
    static const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2, STEPPER_RKL2};
    static const double dt[] = {0.00061, 0.00061, 0.0061, 0.052};
    static const enum side_kind kinds[] = {DIRICHLET, NEUMANN, PERIODIC, NEUMANN};
    enum { STEPS = 31 };
    for (int turn = 0; turn < 3 * 2 * 2 * 4 * 3; turn++) {
        const struct method *m = both[turn / 3 % 2];
        const int k = turn / 12 % 4, node = turn / 6 % 2, of = turn / 48 % 3;
        struct problem p = body(turn % 3 + 1);
        struct options o = {
            .dx = 0.046, .dt = dt[k], .stepper = steppers[k], .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
        if (node && of == 2) continue; /* periodic sides have no nodes */
        for (int s = 0; s < SIDES; s++) p.side[s] = of == 2 ? PERIODIC : kinds[(s / 2 + of) % 2];
        if (of == 2) p.param[0] = 6, p.param[2] = 2;
        p.t_end = STEPS * o.dt;
        struct field f = solved(m, &p, &o);
        const double complex z = -o.dt * decay(m, &p, o.dx);
        p.param[RATE] = pow(creal(stepper_of(o.stepper)->amplification(f.stages, z)), STEPS);
        assert_near(farthest(&p, &f, decayed), 0, 1e-12);
        assert_int_equal(f.steps, STEPS);
        assert_near(f.dt, o.dt, 1e-17);
        assert_int_equal(f.cost.updates, STEPS * f.stages * (long long)f.n);
        assert_int_equal(f.cost.interactions, f.cost.updates * p.dim * (m == &method_ftcs ? 2 : 4));
        field_free(&f);
    }
}

/* -1 and 1 by turns: the fluxes between them are zero. */
static void fluxes_annihilate_checkers(void **state) {
    (void)state;
    for (int dim = 1; dim <= 3; dim++) {
        struct problem p = body(dim);
        struct options o = {.dx = 0.23, .fourier = 0.1, .layout = LAYOUT_NODE};
        set_sides(&p, NEUMANN);
        for (int a = 0; a < dim; a++) p.param[MODE + a] = nearbyint((p.hi[a] - p.lo[a]) / 0.23);
        struct field f = solved(&method_ftcs_flux, &p, &o);
        p.param[RATE] = 1;
        assert_near(farthest(&p, &f, decayed), 0, 1e-12);
        field_free(&f);
    }
}

/* T = level + t mode: its initial value and the source of its start, exact in Euler's steps. */
static double level_alone(const struct problem *p, const double *x) {
    (void)x;
    return p->param[LEVEL];
}

static double rising(const struct problem *p, const double *x) {
    return p->material[0].rho_c * (mode(p, x) - p->param[LEVEL]) / p->param[AMPLITUDE];
}

static double rising_more(const struct problem *p, const double *x) {
    return p->param[6] * rising(p, x);
}

static double rising_at(const struct problem *p, const double *x, double t) {
    return rising(p, x) + t * rising_more(p, x);
}

static void changing_source_is_taken_at_the_old_time(void **state) {
    (void)state;
    for (int turn = 0; turn < 12; turn++) {
        const struct method *m = both[turn % 2];
        struct problem p = body(turn / 2 % 3 + 1);
        struct options o = {.dx = 0.046, .dt = 0.00061};
        p.initial = level_alone, p.t_end = 61 * o.dt, p.param[6] = decay(m, &p, o.dx);
        if (turn < 6)
            p.source = rising, p.source_rate = rising_more;
        else
            p.source_at = rising_at;
        struct field f = solved(m, &p, &o);
        p.param[RATE] = p.t_end / p.param[AMPLITUDE];
        assert_near(farthest(&p, &f, decayed), 0, 1e-13);
        field_free(&f);
    }
}

/* ---- T = quadratic(x) + drift t line(x), with the source and the walls that it needs ---- */

static const double slope_of[DIM_MAX] = {1.1, -0.7, 0.4}, bend_of[DIM_MAX] = {1.7, -0.9, 2.3},
                    slant_of[DIM_MAX] = {0.6, 1.3, -0.8}, /* yz, zx, xy */
    drift_of[DIM_MAX] = {0.8, 1.9, -1.2}, DRIFT = 0.7;

/* A Robin wall is exact for T without a second derivative across it. */
static double bend(const struct problem *p, int axis) {
    return p->side[2 * axis] == ROBIN || p->side[2 * axis + 1] == ROBIN ? 0 : bend_of[axis];
}

static double line_at(const struct problem *p, const double *x) {
    double T = 0.6;
    for (int a = 0; a < p->dim; a++) T += drift_of[a] * x[a];
    return T;
}

static double quadratic_at(const struct problem *p, const double *x, double t) {
    double T = 0.31 + DRIFT * t * line_at(p, x);
    for (int a = 0; a < p->dim; a++) T += slope_of[a] * x[a] + bend(p, a) / 2 * x[a] * x[a];
    if (p->dim > 1) T += slant_of[2] * x[0] * x[1];
    return p->dim > 2 ? T + slant_of[0] * x[1] * x[2] + slant_of[1] * x[2] * x[0] : T;
}

static double quadratic(const struct problem *p, const double *x) {
    return quadratic_at(p, x, 0);
}

static double quadratic_wall(const struct problem *p, enum side s, const double *x, double t) {
    const int a = (int)s / 2;
    double flux = slope_of[a] + bend(p, a) * x[a] + DRIFT * t * drift_of[a];
    for (int b = 0; b < p->dim; b++)
        if (b != a) flux += slant_of[3 - a - b] * x[b];
    flux *= p->material[0].k[a] * (s % 2 ? 1 : -1);
    if (p->side[s] == NEUMANN) return flux;
    return quadratic_at(p, x, t) + (p->side[s] == ROBIN ? flux / p->robin[s] : 0);
}

static double quadratic_wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)t;
    return quadratic_wall(p, s, x, 1) - quadratic_wall(p, s, x, 0);
}

static double quadratic_source(const struct problem *p, const double *x) {
    double G = p->material[0].rho_c * DRIFT * line_at(p, x);
    for (int a = 0; a < p->dim; a++) G -= p->material[0].k[a] * bend(p, a);
    return G;
}

/* No step has an error where T is linear in t, and the differences none where it is quadratic in x: in any dimension,
 * layout and kinds of walls, only data of another time or a ghost without dT_w/dt would. */
static void quadratic_that_rises_evenly_is_exact(void **state) {
    (void)state;
    static const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2};
    for (int turn = 0; turn < 108; turn++) {
        struct problem p = body(turn / 12 % 3 + 1);
        const int node = turn / 2 % 2, first = turn / 4 % 3;
        struct options o = {.dx = 0.115,
                            .fourier = turn < 72 ? 0.1 : 2.9,
                            .stepper = steppers[turn / 36],
                            .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
        for (int s = 0; s < SIDES; s++) {
            p.side[s] = (enum side_kind)((s + first) % (node ? 2 : 3));
            p.robin[s] = 0.6 + 0.2 * s;
        }
        p.initial = quadratic, p.wall = quadratic_wall, p.source = quadratic_source;
        p.wall_rate = quadratic_wall_rate, p.t_end = 1.7;
        struct field f = solved(both[turn % 2], &p, &o);
        assert_order(f.steps, >, 4);
        assert_near(farthest(&p, &f, quadratic_at), 0, 3e-12);
        field_free(&f);
    }
}

/* With `fixed`, ghosts half a spacing outside have the wall's temperature: the wall acts dx/2 too far out. */
static double slope_over(const struct problem *p, const double *x, double t) {
    (void)t;
    return p->param[LEVEL] + p->param[RATE] * (x[0] - 0.45);
}

static double ends(const struct problem *p, enum side s, const double *x, double t) {
    (void)x, (void)t;
    return p->param[LEVEL] + (s % 2 ? 1.15 : -1.15);
}

static void fixed_walls_are_half_a_spacing_outside(void **state) {
    (void)state;
    struct problem p = body(1);
    struct options o = {.dx = 0.115, .fourier = 0.45, .walls = WALLS_FIXED};
    p.initial = level_alone, p.wall = ends, p.t_end = 90;
    struct field f = solved(&method_ftcs, &p, &o);
    p.param[RATE] = 2.3 / (2.3 + 0.115);
    assert_near(farthest(&p, &f, slope_over), 0, 1e-9);
    field_free(&f);
}

/* The mean over a B-spline of order m adds m d^2/24 T_aa of each axis. */
static void averages_of_a_quadratic_are_exact(void **state) {
    (void)state;
    for (int how = 0; how < 3; how++) {
        struct problem p = body(3);
        const double dx = 0.115, order = how == SAMPLING_SPLINE ? 4 : how;
        struct options o = {.dx = dx, .sampling = (enum sampling)how};
        p.initial = quadratic, p.wall = quadratic_wall, p.t_end = 0;
        struct field f = solved(&method_ftcs, &p, &o);
        for (size_t i = 0; i < f.n; i++) {
            double x[DIM_MAX], more = 0, depth = INFINITY;
            field_place(&f, i, x);
            for (int a = 0; a < 3; a++) {
                more += order * dx * dx / 24 * bend_of[a];
                depth = fmin(depth, fmin(x[a] - p.lo[a], p.hi[a] - x[a]));
            }
            if (depth > 2 * dx) assert_near(f.T[i], quadratic(&p, x) + more, 1e-13);
        }
        field_free(&f);
    }
}

/* ---- Heat ---- */

static double fluxes(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x, (void)t;
    return 0.93 - 0.21 * s;
}

/* By the given fluxes over the faces, on both layouts, with two materials and with k(T), there on periodic sides too.
 */
static void heat_rises_by_the_fluxes(void **state) {
    (void)state;
    for (int turn = 0; turn < 18; turn++) {
        struct problem p = body(turn % 3 + 1);
        const int what = turn / 3; /* lattice, node, two materials, k(T) by two means and periodic */
        struct options o = {.dx = 0.115, .fourier = 0.1, .layout = what == 1 ? LAYOUT_NODE : LAYOUT_LATTICE};
        double in = 0, volume = 1, sum = 0, heat = 0;
        set_sides(&p, what == 5 ? PERIODIC : NEUMANN);
        p.wall = fluxes;
        if (what == 2) p.materials = 2, p.interface = 0.17, p.material[1] = (struct material){{0.4, 0.1, 0.3}, 1.7};
        if (what > 2) {
            p.k_law = K_LINEAR, p.k_0 = 0.15, p.k_beta = 0.3, p.k_ref = 0.2;
            o.mean = what == 3 ? MEAN_KIRCHHOFF : MEAN_HARMONIC;
            for (int a = 0; a < 3; a++) p.material[0].k[a] = 0.29;
        }
        for (int a = 0; a < p.dim; a++) volume *= p.hi[a] - p.lo[a];
        for (int s = 0; s < 2 * p.dim && what < 5; s++)
            in += p.t_end * fluxes(&p, (enum side)s, NULL, 0) * volume / (p.hi[s / 2] - p.lo[s / 2]);
        struct field f = solved(&method_ftcs, &p, &o);
        assert_true((f.weight != NULL) == (what == 1));
        for (size_t i = 0; i < f.n; i++) {
            double w = f.weight ? f.weight[i] : pow(0.115, p.dim);
            sum += w, heat += w * 2.385 * f.T[i];
        }
        assert_near(sum, volume, 1e-12);
        if (what != 2) assert_near(heat, f.heat[1], 1e-12);
        assert_near(f.heat[1] - f.heat[0], in, 2e-12);
        field_free(&f);
    }
}

/* ---- Axes ---- */

/* p->param[6 + a] is the axis of x[] that has the data of axis a. */
static void unturned(const struct problem *p, const double *x, double y[DIM_MAX]) {
    for (int a = 0; a < 3; a++) y[a] = x[(int)p->param[6 + a]];
}

static double turned(const struct problem *p, const double *x) {
    double y[DIM_MAX];
    unturned(p, x, y);
    return sin(1.3 * y[0] + 0.7) * exp(0.4 * y[1]) + y[2] * y[2] * y[0];
}

static double turned_wall(const struct problem *p, enum side s, const double *x, double t) {
    double y[DIM_MAX];
    unturned(p, x, y);
    for (int a = 0; a < 3; a++)
        if ((int)s / 2 == (int)p->param[6 + a])
            return 0.3 + 0.2 * a - 0.5 * (s % 2) + 0.1 * y[(a + 1) % 3] * y[(a + 1) % 3] + 0.2 * t;
    return NAN;
}

static double turned_wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0.2;
}

static double turned_source(const struct problem *p, const double *x) {
    double y[DIM_MAX];
    unturned(p, x, y);
    return y[0] + 2 * y[1] * y[1] - cos(y[2]);
}

static struct problem turned_box(const int to[3]) {
    static const enum side_kind kinds[] = {DIRICHLET, NEUMANN, ROBIN, DIRICHLET, NEUMANN, NEUMANN};
    struct problem p = body(3), q = p;
    p.initial = turned, p.wall = turned_wall, p.wall_rate = turned_wall_rate, p.source = turned_source;
    for (int a = 0; a < 3; a++) {
        p.param[6 + a] = to[a];
        p.lo[to[a]] = q.lo[a], p.hi[to[a]] = q.hi[a], p.material[0].k[to[a]] = q.material[0].k[a];
        for (int s = 0; s < 2; s++) p.side[2 * to[a] + s] = kinds[2 * a + s], p.robin[2 * to[a] + s] = 0.6;
    }
    return p;
}

static void axes_can_be_permuted(void **state) {
    (void)state;
    static const int orders[][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int turn = 0; turn < 12; turn++) {
        const int *to = orders[turn % 6];
        struct options o = {.dx = 0.115, .dt = 0.001, .sampling = SAMPLING_CELL};
        struct problem p = turned_box(orders[0]), q = turned_box(to);
        struct field want = solved(both[turn / 6], &p, &o), f = solved(both[turn / 6], &q, &o);
        double worst = 0;
        for (size_t i = 0; i < want.n; i++) {
            size_t rest = i, k = 0, stride[3] = {1, (size_t)f.shape[0], (size_t)(f.shape[0] * f.shape[1])};
            for (int a = 0; a < 3; a++)
                k += rest % (size_t)want.shape[a] * stride[to[a]], rest /= (size_t)want.shape[a];
            worst = fmax(worst, fabs(f.T[k] - want.T[i]));
        }
        assert_near(worst, 0, 2e-14);
        assert_near(f.heat[1], want.heat[1], 1e-13);
        field_free(&f);
        field_free(&want);
    }
}

/* Smooth data of x that the walls bend. */
static double along_x(const struct problem *p, const double *x) {
    (void)p;
    return 0.4 + sin(3.1 * x[0]) + x[0] * x[0];
}

static double x_walls(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x, (void)t;
    return s < 2 ? 0.9 - 0.7 * (s % 2) : 0;
}

static double x_source(const struct problem *p, const double *x) {
    (void)p;
    return 0.3 + cos(2.2 * x[0]);
}

/* To the last bit, for the differences across are zero. */
static void rod_repeated_across_is_the_rod(void **state) {
    (void)state;
    for (int turn = 0; turn < 24; turn++) {
        const int dim = turn % 2 + 2, m = turn / 2 % 2,
                  what = turn / 4; /* held, flux, Robin; node; k(T), two means */
        if (m == 1 && what > 3) continue;
        struct problem r = body(1), p = body(dim);
        struct options o = {.dx = 0.115, .dt = 0.001, .layout = what == 3 ? LAYOUT_NODE : LAYOUT_LATTICE};
        r.side[X_HI] = what < 3 ? (enum side_kind)what : NEUMANN, r.robin[X_HI] = 1.4;
        r.initial = along_x, r.wall = x_walls, r.source = x_source;
        if (what > 3) {
            r.k_law = K_POWER, r.k_0 = 0.1, r.k_n = 1.3, r.k_ref = -1, r.side[X_HI] = ROBIN;
            o.mean = what == 4 ? MEAN_KIRCHHOFF : MEAN_ARITHMETIC;
            for (int a = 0; a < 3; a++) r.material[0].k[a] = 0.5;
        }
        struct problem whole = r;
        whole.dim = dim;
        for (int a = 1; a < dim; a++) whole.lo[a] = p.lo[a], whole.hi[a] = p.hi[a];
        for (int s = Y_LO; s < SIDES; s++) whole.side[s] = NEUMANN;
        struct field want = solved(both[m], &r, &o), f = solved(both[m], &whole, &o);
        for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], want.T[i % want.n], what > 3 ? 1e-14 : 0);
        field_free(&f);
        field_free(&want);
    }
}

/* ---- Two materials ---- */

static double across(const struct problem *p, const double *x) {
    return cos(PI * x[1] / p->hi[1]) * (p->dim == 3 ? cos(PI * x[2] / p->hi[2]) : 1);
}

static double insulated(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

/* The sum that the refusal of an unstable run states. */
static double fourier_in(const struct failure *why) {
    const char *text = strstr(why->text, "sum of kappa dt/dx^2 is ");
    double sum = NAN;
    if (!text || sscanf(text, "sum of kappa dt/dx^2 is %lf", &sum) != 1) fail_msg("%s", why->text);
    return sum;
}

/* The interface is 0.3 of a cell behind a face.  The data have no flux along x, and a step takes (k_a/rho_c) dt
 * (2 sin(pi d/2 H_a)/d)^2 of them along y and z, k_a and rho_c averaged over the cell; a cell average is the mean
 * across. */
static void two_materials_conduct_in_parallel_across(void **state) {
    (void)state;
    const double d = 0.1, dt = 1e-3, k[2][3] = {{0.7, 0.5, 0.3}, {0.09, 0.2, 0.6}}, rho_c[2] = {1.3, 2.9};
    for (int turn = 0; turn < 4; turn++) {
        struct problem p = {.dim = turn % 2 + 2, .hi = {1, 0.8, 0.5}, .t_end = dt, .materials = 2, .interface = 0.43};
        struct options o = {.dx = d, .dt = dt, .sampling = turn / 2 ? SAMPLING_CELL : SAMPLING_POINT};
        double mean = 1, sum = 0;
        set_sides(&p, NEUMANN);
        p.initial = across, p.wall = insulated;
        for (int m = 0; m < 2; m++) p.material[m] = (struct material){{k[m][0], k[m][1], k[m][2]}, rho_c[m]};
        for (int a = 1; a < p.dim && turn / 2; a++) mean *= sin(PI * d / 2 / p.hi[a]) / (PI * d / 2 / p.hi[a]);
        struct field f = solved(&method_ftcs, &p, &o);
        for (size_t i = 0; i < f.n; i++) {
            double x[DIM_MAX], loss = 0;
            field_place(&f, i, x);
            double part = fmin(1, fmax(0, (p.interface - x[0]) / d + 0.5));
            for (int a = 1; a < p.dim; a++)
                loss += dt * (part * k[0][a] + (1 - part) * k[1][a]) / (part * rho_c[0] + (1 - part) * rho_c[1]) *
                        pow(2 * sin(PI * d / 2 / p.hi[a]) / d, 2);
            assert_near(f.T[i], mean * (1 - loss) * across(&p, x), turn / 2 ? 2e-9 : 1e-14); /* four nodes */
        }
        field_free(&f);
        struct failure why = {0};
        for (int a = 0; a < p.dim; a++) sum += k[0][a] / rho_c[0];
        p.interface = 0.4, o.dt = 0.05, p.t_end = 200 * o.dt;
        assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
        assert_near(fourier_in(&why), o.dt / (d * d) * sum, 1e-5); /* far from the interface */
    }
}

/* Two halves of one material are that material, behind walls of all kinds; a cell that the interface cuts averages
 * its two parts by four nodes each. */
static void two_equal_materials_are_one(void **state) {
    (void)state;
    for (int turn = 0; turn < 6; turn++) {
        struct problem p = body(turn % 3 + 1), q;
        struct options o = {.dx = 0.115, .fourier = 0.1, .sampling = turn / 3 ? SAMPLING_CELL : SAMPLING_POINT};
        for (int s = X_HI; s < SIDES; s++) p.side[s] = s == Y_LO ? DIRICHLET : ROBIN, p.robin[s] = 0.7 + 0.2 * s;
        q = p, q.materials = 2, q.interface = -0.7 + (turn / 3 ? 8.8 : 9) * 0.115, q.material[1] = q.material[0];
        struct field want = solved(&method_ftcs, &p, &o), f = solved(&method_ftcs, &q, &o);
        for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], want.T[i], turn / 3 ? 1e-8 : 1e-14);
        field_free(&f);
        field_free(&want);
    }
}

/* ---- A tensor ---- */

static double oblique(const struct problem *p, const double *x) {
    double phase = 0.3;
    for (int a = 0; a < p->dim; a++) phase += p->param[MODE + a] * PI * (x[a] - p->lo[a]) / (p->hi[a] - p->lo[a]);
    return p->param[LEVEL] + p->param[AMPLITUDE] * cos(phase);
}

static double oblique_decayed(const struct problem *p, const double *x, double t) {
    (void)t;
    return p->param[LEVEL] + p->param[RATE] * (oblique(p, x) - p->param[LEVEL]);
}

/* Rate of the wave of half a phase h between cells, times dx^2/4 (the head of ftcs_cross.c). */
static double tensor_rate(const struct problem *p, enum cross cross, const double h[DIM_MAX]) {
    double sum = 0;
    for (int a = 0; a < p->dim; a++)
        for (int b = 0; b < p->dim; b++) {
            double K = a == b ? p->material[0].k[a] : p->cross[problem_pair(a, b)], w = K * sin(h[a]) * sin(h[b]);
            for (int c = 0; c < p->dim && cross == CROSS_CORNER; c++) w *= pow(cos(h[c]), (c != a) + (c != b));
            if (cross == CROSS_FACE && a != b) w *= cos(h[a]) * cos(h[b]);
            sum += w;
        }
    return sum;
}

static struct problem tensor_body(int dim) {
    struct problem p = body(dim);
    set_sides(&p, PERIODIC);
    p.initial = oblique;
    p.cross[0] = 0.21, p.param[0] = 6, p.param[2] = 2;
    if (dim == 3) p.cross[1] = -0.09, p.cross[2] = 0.13;
    return p;
}

/* Every wave, in a fixed order of signs. */
static double sign_of_place(const struct problem *p, const double *x) {
    double place = 0;
    for (int a = 0; a < p->dim; a++) place += nearbyint((x[a] - p->lo[a]) / 0.046 - 0.5) * (17 + 31 * a * a);
    return sin(place * place) > 0 ? 1 : -1;
}

/* Waves are multiplied by the amplification factor of the stepper at each step. */
static void waves_of_a_tensor_are_amplified_by_each_step(void **state) {
    (void)state;
    static const enum stepper_name steppers[] = {STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2};
    static const double dt[] = {0.00061, 0.00061, 0.0061};
    enum { STEPS = 31 };
    for (int turn = 0; turn < 3 * 2 * 2; turn++) {
        const int k = turn % 3;
        struct problem p = tensor_body(turn / 3 % 2 + 2);
        struct options o = {.dx = 0.046, .dt = dt[k], .stepper = steppers[k], .cross = (enum cross)(turn / 6)};
        p.t_end = STEPS * o.dt;
        struct field f = solved(&method_ftcs, &p, &o);
        double h[DIM_MAX] = {0};
        for (int a = 0; a < p.dim; a++) h[a] = p.param[MODE + a] * PI * o.dx / (p.hi[a] - p.lo[a]) / 2;
        const double complex z = -o.dt * 4 / (o.dx * o.dx) * tensor_rate(&p, o.cross, h) / p.material[0].rho_c;
        p.param[RATE] = pow(creal(stepper_of(o.stepper)->amplification(f.stages, z)), STEPS);
        assert_near(farthest(&p, &f, oblique_decayed), 0, 1e-12);
        field_free(&f);
    }
}

/* k b b^T along a diagonal has the smallest steps: 1/4, with fluxes at corners 1/2, of dx^2/kappa in the plane, 4/27
 * and 3/8 in space.  To these the lattice has waves within 2 % of the worst one. */
static void steps_of_a_tensor_have_their_limit(void **state) {
    (void)state;
    static const double limit[2][2] = {{1. / 4, 1. / 2}, {4. / 27, 3. / 8}};
    for (int turn = 0; turn < 4; turn++) {
        struct problem p = tensor_body(turn / 2 + 2);
        struct options o = {.dx = 0.046, .cross = (enum cross)(turn % 2)};
        struct failure why = {0};
        struct field f;
        for (int a = 0; a < p.dim; a++) p.material[0].k[a] = 0.4;
        for (int k = 0; k < (p.dim == 3 ? 3 : 1); k++) p.cross[k] = 0.4;
        p.initial = sign_of_place;
        o.fourier = 0.99 * limit[turn / 2][turn % 2];
        p.t_end = 300 * o.fourier * 0.046 * 0.046 * 2.385 / 0.4;
        f = solved(&method_ftcs, &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_order(fabs(f.T[i]), <, 4);
        field_free(&f);
        o.fourier *= 1.04 / 0.99, p.t_end *= 1.04 / 0.99;
        assert_int_equal(method_solve(&method_ftcs, &p, &o, &f, &why), STATUS_UNSTABLE);
        /* rkl2 in steps that without 9/8 in space would have nine stages, stable up to 44 of the 49.5 that are due */
        o.fourier = 0, o.stepper = STEPPER_RKL2, o.dt = 43.9 / 4 / p.dim * 0.046 * 0.046 * 2.385 / 0.4;
        p.t_end = 10 * o.dt;
        f = solved(&method_ftcs, &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_order(fabs(f.T[i]), <, 4);
        field_free(&f);
    }
}

/* ---- Steps and limits ---- */

static double jumps(const struct problem *p, const double *x) {
    double T = 1.3;
    for (int a = 0; a < p->dim; a++) T *= x[a] < 0.2431 ? 0.6 : -1.1;
    return T;
}

/* Just inside the limit of dt sum of kappa/dx^2 a run is bounded, just outside it is a status with step, time and
 * place. */
static void steps_up_to_the_limit_are_stable(void **state) {
    (void)state;
    for (int turn = 0; turn < 6; turn++) {
        const struct method *m = both[turn % 2];
        const double limit = turn % 2 ? 2 : 0.5;
        struct problem p = body(turn / 2 + 1);
        double sum = 0, most = 0;
        for (int a = 0; a < p.dim; a++) sum += p.material[0].k[a], most = fmax(most, p.material[0].k[a]);
        p.initial = jumps;
        struct options o = {.dx = 0.046, .fourier = 0.995 * limit * most / sum}; /* counts in the largest kappa */
        const double step = 0.046 * 0.046 * 2.385 / most;
        p.t_end = 900 * o.fourier * step;
        struct field f = solved(m, &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_order(fabs(f.T[i]), <, 4);
        field_free(&f);
        struct failure why = {0};
        long seen = 0, steps = 0;
        o.fourier *= 1.04 / 0.995, p.t_end = 1000 * o.fourier * step;
        assert_int_equal(method_solve(m, &p, &o, &f, &why), STATUS_UNSTABLE);
        assert_int_equal(sscanf(strstr(why.text, "at step"), "at step %ld of %ld, t = ", &seen, &steps), 2);
        assert_true(seen % 32 == 0 && seen < steps); /* it is not run to the end */
        assert_near(fourier_in(&why), 1.04 * limit, 0.01 * limit);
        for (int a = 0; a < p.dim; a++) assert_has(why.text, a == 0 ? " at x = " : a == 1 ? ", y = " : ", z = ");
        o.fourier = 3 * limit, p.t_end = 19.5 * o.fourier * step;
        refused(m, &p, &o, STATUS_UNSTABLE, "unstable at step 20 of 20,");
        p.initial = mode, p.param[LEVEL] = NAN;
        refused(m, &p, &o, STATUS_UNSTABLE, "unstable at step");
    }
}

static double hot(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x;
    return s == X_LO ? 500 * t : 0;
}

static double hot_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)p, (void)x, (void)t;
    return s == X_LO ? 500 : 0;
}

/* The range of a stable run grows with that of the walls. */
static void hot_wall_is_no_instability(void **state) {
    (void)state;
    struct problem p = body(1);
    struct options o = {.dx = 0.115, .fourier = 0.01};
    p.wall = hot, p.wall_rate = hot_rate;
    struct field f = solved(&method_ftcs, &p, &o);
    assert_order(f.T[0], >, 100);
    field_free(&f);
    o.fourier = 0.7, p.t_end = 40;
    refused(&method_ftcs, &p, &o, STATUS_UNSTABLE, "unstable");
}

static long asked;

static double counted(const struct problem *p, enum side s, const double *x, double t) {
    asked++;
    return level(p, s, x, t);
}

static void steady_walls_are_read_once(void **state) {
    (void)state;
    long before = 0;
    for (int turn = 0; turn < 4; turn++) {
        struct problem p = body(2);
        struct options o = {.dx = 0.115, .dt = p.t_end / (turn % 2 ? 100 : 10)};
        asked = 0, p.wall = counted;
        struct field f = solved(both[turn / 2], &p, &o);
        if (turn % 2) assert_int_equal(asked, before);
        before = asked;
        field_free(&f);
    }
}

static double parabola(const struct problem *p, const double *x, double t) {
    (void)x;
    asked++;
    return p->param[RATE] * (1 + t * t);
}

/* A source that depends on time is read once a step for all stages: a parabola in time as it is, a line in the first
 * step.  The midpoint rule of rk2 makes t^2 smaller by dt^2/12; in the first step the line makes it larger by dt^2/6.
 */
static void source_is_read_once_a_step(void **state) {
    (void)state;
    for (int many = 0; many < 2; many++) {
        enum { STEPS = 20 };
        struct problem p = body(2);
        const double t = p.t_end, dt = t / STEPS;
        struct options o = {.dx = many ? 0.046 : 0.115, .dt = dt, .stepper = many ? STEPPER_RKL2 : STEPPER_RK2};
        set_sides(&p, PERIODIC);
        p.source_at = parabola, p.param[AMPLITUDE] = 0, p.param[RATE] = 1.7, asked = 0;
        struct field f = solved(&method_ftcs, &p, &o);
        const double rise = t + t * t * t / 3 + dt * dt * dt * (1. / 6 - (STEPS - 1) / 12.);
        assert_int_equal(f.stages, many ? 7 : 2);
        if (!many) assert_near(f.T[0], p.param[LEVEL] + p.param[RATE] / p.material[0].rho_c * rise, 1e-12);
        assert_int_equal(asked, (long)f.n * (STEPS + 3)); /* the start; the range of the source, at both ends */
        field_free(&f);
    }
}

/* t_end / ceil(t_end / dt); a dx that is out by rounding is snapped. */
static void steps_are_whole_and_dx_is_snapped(void **state) {
    (void)state;
    static const double dt[] = {0.0037, 0.00371, 0.00369};
    for (int k = 0; k < 3; k++) {
        struct problem p = body(1);
        struct options o = {.dx = 0.0383333333, .dt = dt[k]};
        struct field f = solved(&method_ftcs, &p, &o);
        assert_int_equal(f.steps, k < 2 ? 100 : 101);
        assert_near((double)f.steps * f.dt, 0.37, 1e-15);
        assert_near(f.spacing[0], 2.3 / 60, 1e-16);
        assert_int_equal(f.shape[0], 60);
        assert_int_equal(f.shape[1], 1);
        assert_near(f.time, 0.37, 0);
        field_free(&f);
    }
}

/* Smoothing by the sampling shortens the matched run by its time; a jump sampled at points lengthens it. */
static void matched_run_starts_at_the_sampling_time(void **state) {
    (void)state;
    const double m[] = {0, 1, 4, -1, 1, 4}, dx = 0.046;
    for (int i = 0; i < 9; i++) {
        const struct method *method = i < 6 ? &method_ftcs : &method_ftcs_flux; /* spacing 2 dx */
        struct problem p = body(1);
        if (i >= 3 && i < 6)
            p.jumps[0] = 1, p.jump[0][0] = 0.45, p.param[AMPLITUDE] = 0; /* midway; the same level on either side */
        struct options o = {.dx = dx, .stepper = STEPPER_MATCHED, .sampling = (enum sampling)(i % 3)};
        struct field f = solved(method, &p, &o);
        double unit = dx * dx * 2.385 / 0.29, run = p.t_end - m[i % 6] * unit / 24;
        assert_near((double)f.steps * f.dt, run, 1e-15);
        assert_near((double)f.steps, run / (i < 6 ? unit / 6 : 2 * unit / 3) + 1, 1); /* the next even number */
        assert_int_equal(f.steps % 2, 0);
        assert_near(f.time, p.t_end, 0);
        field_free(&f);
    }
}

static void bits_do_not_depend_on_the_width_of_vectors(void **state) {
    (void)state;
    for (int turn = 0; turn < 5; turn++) {
        struct problem p = turned_box((const int[]){0, 1, 2});
        struct options o = {.dx = 0.115, .dt = 0.001, .lanes = 2};
        if (turn == 2) p.materials = 2, p.material[1] = (struct material){{0.5, 0.2, 0.1}, 1.7};
        if (turn == 3) p.k_law = K_LINEAR, p.k_0 = 0.2, p.k_beta = 0.1, p.k_ref = 0.3;
        if (turn == 4) o.stepper = STEPPER_RKL2, o.dt = 0.05;
        struct field want = solved(both[turn == 1], &p, &o);
        for (o.lanes = 4; o.lanes <= options_lanes_most(); o.lanes *= 2) {
            struct field f = solved(both[turn == 1], &p, &o);
            assert_memory_equal(f.T, want.T, f.n * sizeof *f.T);
            field_free(&f);
        }
        field_free(&want);
    }
}

static void refusals_state_the_reason(void **state) {
    (void)state;
    struct options matched = {.dx = 0.115, .stepper = STEPPER_MATCHED}, coarse = {.dx = 0.1};
    struct options chebyshev = {.dx = 0.115, .stepper = STEPPER_CHEBYSHEV}, plain = {.dx = 0.115};
    struct problem rod = body(1), plane = body(2), box = body(3), ball = box, two = box;
    refused(&method_ftcs, &plane, &matched, STATUS_NOT_APPLICABLE, "in the plane the error is not isotropic");
    refused(&method_ftcs, &box, &matched, STATUS_NOT_APPLICABLE, "in space the error is not isotropic");
    refused(&method_ftcs, &box, &coarse, STATUS_INPUT, "does not divide 2.3 m by 1.38 m by 0.92 m");
    refused(&method_ftcs, &rod, &chebyshev, STATUS_NOT_APPLICABLE, "finite differences have euler, rk2, rkl2");
    two.materials = 2, two.material[1] = two.material[0], two.interface = 0.3;
    refused(&method_ftcs_flux, &two, &plain, STATUS_NOT_APPLICABLE, "takes one material, the scene has two");
    two = plane, two.cross[0] = 0.1, two.side[Y_LO] = ROBIN;
    refused(&method_ftcs, &two, &plain, STATUS_NOT_APPLICABLE, "takes k_xy between held or periodic sides");
    rod.wall_rate = hot_rate;
    refused(&method_ftcs, &rod, &matched, STATUS_NOT_APPLICABLE, "are derived for steady walls");
    shape_make_ball(&ball, 0.46);
    refused(&method_ftcs, &ball, &plain, STATUS_NOT_APPLICABLE, "takes one material with k_x = k_y");
    ball.material[0].k[1] = ball.material[0].k[0];
    refused(&method_ftcs, &ball, &plain, STATUS_NOT_APPLICABLE, "with k_x = k_y = k_z in a ball");
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(modes_are_amplified_by_each_step),
        cmocka_unit_test(fluxes_annihilate_checkers),
        cmocka_unit_test(changing_source_is_taken_at_the_old_time),
        cmocka_unit_test(quadratic_that_rises_evenly_is_exact),
        cmocka_unit_test(fixed_walls_are_half_a_spacing_outside),
        cmocka_unit_test(averages_of_a_quadratic_are_exact),
        cmocka_unit_test(heat_rises_by_the_fluxes),
        cmocka_unit_test(axes_can_be_permuted),
        cmocka_unit_test(rod_repeated_across_is_the_rod),
        cmocka_unit_test(two_materials_conduct_in_parallel_across),
        cmocka_unit_test(two_equal_materials_are_one),
        cmocka_unit_test(waves_of_a_tensor_are_amplified_by_each_step),
        cmocka_unit_test(steps_of_a_tensor_have_their_limit),
        cmocka_unit_test(steps_up_to_the_limit_are_stable),
        cmocka_unit_test(hot_wall_is_no_instability),
        cmocka_unit_test(steady_walls_are_read_once),
        cmocka_unit_test(source_is_read_once_a_step),
        cmocka_unit_test(steps_are_whole_and_dx_is_snapped),
        cmocka_unit_test(matched_run_starts_at_the_sampling_time),
        cmocka_unit_test(bits_do_not_depend_on_the_width_of_vectors),
        cmocka_unit_test(refusals_state_the_reason),
    };
    return cmocka_run_group_tests_name("ftcs", tests, NULL, NULL);
}
