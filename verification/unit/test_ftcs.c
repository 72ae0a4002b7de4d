/* The finite differences against what can be said of them exactly: their symbol, their steady states, their order at
 * the matched step, their walls, and what they refuse. */
#include "solver/method.h" /* before cmocka.h, which makes a macro of `fail` */
#include "solver/problem.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

extern const struct method method_ftcs, method_ftcs_flux;

static const double PI = 3.14159265358979323846;

/* ---- Problems, whose parameters p->param[] are the mode numbers or the coefficients ---- */

/* Vanishes at the walls of p where they are DIRICHLET, has no slope where they are NEUMANN. */
static double mode(const struct problem *p, const double x[2]) {
    double T = 1;
    for (int a = 0; a < p->dim; a++) {
        double phase = p->param[a] * PI * (x[a] - p->lo[a]) / (p->hi[a] - p->lo[a]);
        T *= p->side[2 * a] == DIRICHLET ? sin(phase) : cos(phase);
    }
    return p->param[2] + p->param[3] * T;
}

static double level(const struct problem *p, enum side s, const double x[2]) {
    (void)x;
    return p->side[s] == DIRICHLET ? p->param[2] : 0;
}

static struct problem rod(int number) {
    return (struct problem){.dim = 1,
                            .lo = {-0.7, 0},
                            .hi = {1.6, 0},
                            .t_end = 0.37,
                            .materials = 1,
                            .material = {{{0.29, 0.71}, 2.385}},
                            .param = {number, 0, 0.83, 1.9},
                            .initial = mode,
                            .wall = level};
}

static struct problem plane(int along, int up) {
    struct problem p = rod(along);
    p.dim = 2;
    p.lo[1] = 0.2;
    p.hi[1] = 1.58; /* 2.3 by 1.38 m: 0.023 divides both */
    p.param[1] = up;
    p.side[Y_LO] = p.side[Y_HI] = NEUMANN;
    return p;
}

static struct field solved(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f;
    struct failure why = {0};
    if (m->solve(p, o, &f, &why)) fail_msg("%s", why.text);
    return f;
}

/* Largest |T - (level + amplitude * factor * mode)|. */
static double mode_error(const struct problem *p, const struct field *f, double factor) {
    double worst = 0;
    for (size_t i = 0; i < f->n; i++) {
        double x[2] = {f->x[i], f->y ? f->y[i] : 0};
        double want = p->param[2] + factor * (mode(p, x) - p->param[2]);
        worst = fmax(worst, fabs(f->T[i] - want));
    }
    return worst;
}

/* -dx^2/kappa times the symbol on a mode, along one axis. */
static double symbol(const struct method *m, double number, double dx, double extent) {
    double phase = number * PI * dx / extent;
    return m == &method_ftcs ? 4 * pow(sin(phase / 2), 2) : pow(sin(phase), 2);
}

/* ---- Decay of a discrete mode: every wall on every layout, both methods, exactly n steps ---- */

static void decays_as_its_symbol(const struct method *m, struct problem *p, enum layout_name layout) {
    const double dx = 0.046, dt = 0.00061;
    p->t_end = 217 * dt;
    struct options o = {.dx = dx, .dt = dt, .layout = layout};
    struct field f = solved(m, p, &o);
    double gain = 1;
    for (int a = 0; a < p->dim; a++)
        gain -= p->material[0].k[a] / p->material[0].rho_c * dt / (dx * dx) *
                symbol(m, p->param[a], dx, p->hi[a] - p->lo[a]);
    assert_int_equal(f.steps, 217);
    assert_near(f.dt, dt, 1e-17);
    assert_near(mode_error(p, &f, pow(gain, 217)), 0, 5e-13);
    assert_true(pow(gain, 217) < 0.95 && pow(gain, 217) > 0.001);
    assert_int_equal(f.updates, 217 * (long long)f.n);
    assert_int_equal(f.interactions, f.updates * p->dim * (m == &method_ftcs ? 2 : 4));
    assert_true(f.bytes <= 8 * (3 * f.n + 30 * (size_t)(f.shape[0] + f.shape[1])));
    field_free(&f);
}

static void test_symbol(void **state) {
    (void)state;
    const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
    for (int m = 0; m < 2; m++)
        for (int layout = LAYOUT_LATTICE; layout <= LAYOUT_NODE; layout++) {
            struct problem sine = rod(13), cosine = rod(7), flat = plane(5, 3), swapped = plane(7, 4);
            cosine.side[X_LO] = cosine.side[X_HI] = NEUMANN;
            swapped.side[X_LO] = swapped.side[X_HI] = NEUMANN;
            swapped.side[Y_LO] = swapped.side[Y_HI] = DIRICHLET;
            decays_as_its_symbol(both[m], &sine, (enum layout_name)layout);
            decays_as_its_symbol(both[m], &cosine, (enum layout_name)layout);
            decays_as_its_symbol(both[m], &flat, (enum layout_name)layout);
            decays_as_its_symbol(both[m], &swapped, (enum layout_name)layout);
        }
}

/* The fluxes do not see the fastest mode of the grid: cos(N pi x/L) on insulated nodes, +-1. */
static void test_fluxes_are_blind_to_the_checkerboard(void **state) {
    (void)state;
    struct problem p = rod(50);
    p.side[X_LO] = p.side[X_HI] = NEUMANN;
    struct options o = {.dx = 0.046, .fourier = 0.21, .layout = LAYOUT_NODE};
    struct field f = solved(&method_ftcs_flux, &p, &o);
    assert_near(mode_error(&p, &f, 1), 0, 1e-12);
    field_free(&f);
    f = solved(&method_ftcs, &p, &o);
    assert_true(mode_error(&p, &f, 0) < 1e-3);
    field_free(&f);
}

/* ---- Steady states ---- */

static double line(const struct problem *p, const double x[2]) {
    return p->param[0] + p->param[1] * x[0] + p->param[2] * x[1];
}

static double line_wall(const struct problem *p, enum side s, const double x[2]) {
    if (p->side[s] == DIRICHLET) return line(p, x);
    return p->material[0].k[s / 2] * p->param[1 + s / 2] * (s % 2 ? 1 : -1);
}

/* A linear profile with its flux given on two sides stays, for both methods on both layouts. */
static void test_linear_profile_stays(void **state) {
    (void)state;
    const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
    for (int turn = 0; turn < 8; turn++) {
        struct problem p = plane(0, 0);
        p.param[0] = 1.37, p.param[1] = -2.9, p.param[2] = 0.77;
        p.initial = line, p.wall = line_wall;
        p.side[turn & 1 ? X_HI : X_LO] = NEUMANN;
        p.side[turn & 1 ? Y_LO : Y_HI] = DIRICHLET;
        struct options o = {.dx = 0.046, .fourier = 0.2, .layout = turn & 2 ? LAYOUT_NODE : LAYOUT_LATTICE};
        o.sampling = turn & 1 ? SAMPLING_SPLINE : SAMPLING_CELL; /* both keep a linear profile, walls included */
        struct field f = solved(both[turn >> 2], &p, &o);
        assert_true(f.steps > 50);
        for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], line(&p, (double[2]){f.x[i], f.y[i]}), 1e-12);
        field_free(&f);
    }
}

static double steady_source(const struct problem *p, const double x[2]) {
    return -2 * (p->material[0].k[0] * p->param[1] - p->material[0].k[1] * p->param[2]) + 0 * x[0];
}

static double parabola(const struct problem *p, const double x[2]) {
    return p->param[0] + p->param[1] * x[0] * x[0] - p->param[2] * x[1] * x[1];
}

static double parabola_wall(const struct problem *p, enum side s, const double x[2]) {
    if (p->side[s] == DIRICHLET) return parabola(p, x);
    return p->material[0].k[s / 2] * (s % 2 ? 1 : -1) * (s < 2 ? 2 * p->param[1] * x[0] : -2 * p->param[2] * x[1]);
}

/* G = -div(k grad T) of a parabola holds it; with nodes on the walls the differences are exact (with fluxes all but
 * next to a wall whose temperature is given). */
static void test_source_holds_a_parabola(void **state) {
    (void)state;
    struct problem p = plane(0, 0);
    p.param[0] = 0.31, p.param[1] = 1.7, p.param[2] = 0.45;
    p.initial = parabola, p.wall = parabola_wall, p.source = steady_source;
    struct options o = {.dx = 0.046, .fourier = 0.2, .layout = LAYOUT_NODE};
    struct field f = solved(&method_ftcs, &p, &o);
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], parabola(&p, (double[2]){f.x[i], f.y[i]}), 2e-12);
    field_free(&f);
    p.dim = 1;
    p.param[2] = 0;
    p.side[X_LO] = p.side[X_HI] = NEUMANN;
    f = solved(&method_ftcs_flux, &p, &o);
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], parabola(&p, (double[2]){f.x[i], 0}), 2e-12);
    field_free(&f);
}

/* ---- Walls ---- */

/* With `fixed`, ghosts half a spacing outside hold the wall's temperature: the wall is felt dx/2 too far out. */
static void test_fixed_walls_lie_half_a_spacing_out(void **state) {
    (void)state;
    struct problem p = rod(0);
    p.param[0] = 1.37, p.param[1] = -2.9, p.param[2] = 0;
    p.initial = line, p.wall = line_wall, p.t_end = 90;
    struct options o = {.dx = 0.115, .fourier = 0.45, .walls = WALLS_FIXED};
    struct field f = solved(&method_ftcs, &p, &o);
    double slope = p.param[1] * 2.3 / (2.3 + 0.115), middle = line(&p, (double[2]){0.45, 0});
    for (size_t i = 0; i < f.n; i++) assert_near(f.T[i], middle + slope * (f.x[i] - 0.45), 1e-9);
    field_free(&f);
}

/* Insulated, with a flux in on one side: heat grows by the flux times the time, on both layouts. */
static double one_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)x;
    return s == X_LO ? p->param[4] : 0;
}

static void test_heat_balance(void **state) {
    (void)state;
    for (int layout = LAYOUT_LATTICE; layout <= LAYOUT_NODE; layout++) {
        struct problem p = plane(4, 3);
        p.side[X_LO] = p.side[X_HI] = NEUMANN;
        p.wall = one_flux, p.param[4] = 0.93;
        struct options o = {.dx = 0.023, .fourier = 0.2, .layout = (enum layout_name)layout};
        struct field f = solved(&method_ftcs, &p, &o);
        assert_near(f.heat[1] - f.heat[0], 0.93 * p.t_end * 1.38, 1e-12);
        assert_near(f.heat[0], 2.385 * 0.83 * 2.3 * 1.38, 1e-12);
        assert_true((f.weight != NULL) == (layout == LAYOUT_NODE));
        double area = 0;
        for (size_t i = 0; i < f.n; i++) area += f.weight ? f.weight[i] : f.spacing[0] * f.spacing[1];
        assert_near(area, 2.3 * 1.38, 1e-12);
        field_free(&f);
    }
}

/* ---- Sampling ---- */

static double step(const struct problem *p, const double x[2]) {
    return (x[0] < p->jump[0][0] ? 1.3 : -0.4) * (p->dim == 1 ? 1 : x[1] < p->jump[1][0] ? 0.6 : 2.1);
}

/* Integral of the cubic B-spline up to u: sum of (u - k)^4 / 24 with the binomial coefficients and their signs. */
static double below(double u) {
    static const int binomial[5] = {1, -4, 6, -4, 1};
    double sum = 0;
    for (int k = 0; k < 5; k++) sum += binomial[k] * pow(fmax(0, fmin(4, u + 2) - k), 4) / 24;
    return sum;
}

/* Without a step in time the field is the sampled data: of a jump, the part of the cell on either side. */
static void test_cell_averages_of_a_jump(void **state) {
    (void)state;
    struct problem p = plane(0, 0);
    p.initial = step, p.t_end = 0;
    p.jumps[0] = p.jumps[1] = 1;
    p.jump[0][0] = 0.4431, p.jump[1][0] = 0.9017;
    p.side[X_LO] = p.side[X_HI] = NEUMANN;
    const double d = 0.046;
    struct options o = {.dx = d, .sampling = SAMPLING_CELL};
    struct field f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 0);
    for (size_t i = 0; i < f.n; i++) {
        double left = fmin(1, fmax(0, (0.4431 - f.x[i]) / d + 0.5));
        double low = fmin(1, fmax(0, (0.9017 - f.y[i]) / d + 0.5));
        assert_near(f.T[i], (1.3 * left - 0.4 * (1 - left)) * (0.6 * low + 2.1 * (1 - low)), 1e-14);
    }
    field_free(&f);
}

/* The same for B-splines; next to an insulated wall the data on its far side are the image, jump included. */
static void test_spline_averages_of_a_jump(void **state) {
    (void)state;
    const double d = 0.046, jump[] = {0.4431, -0.7 + 0.0617, 1.6 - 0.0271};
    for (int k = 0; k < 3; k++) {
        struct problem p = rod(0);
        p.initial = step, p.t_end = 0;
        p.jumps[0] = 1, p.jump[0][0] = jump[k];
        p.side[X_LO] = p.side[X_HI] = NEUMANN;
        struct options o = {.dx = d, .sampling = SAMPLING_SPLINE};
        struct field f = solved(&method_ftcs, &p, &o);
        for (size_t i = 0; i < f.n; i++) {
            double image[] = {2 * p.lo[0] - jump[k], 2 * p.hi[0] - jump[k]};
            double left =
                below((jump[k] - f.x[i]) / d) - below((image[0] - f.x[i]) / d) + 1 - below((image[1] - f.x[i]) / d);
            assert_near(f.T[i], 1.3 * left - 0.4 * (1 - left), 1e-13);
        }
        field_free(&f);
    }
}

/* A mode continued past its walls is the mode: its average is the mode times the transform of the B-spline. */
static void test_sampling_past_the_walls(void **state) {
    (void)state;
    struct problem p = plane(9, 5);
    p.t_end = 0;
    struct options o = {.dx = 0.046, .sampling = SAMPLING_SPLINE};
    struct field f = solved(&method_ftcs, &p, &o);
    double u = 9 * PI * 0.046 / 2.3 / 2, v = 5 * PI * 0.046 / 1.38 / 2;
    assert_near(mode_error(&p, &f, pow(sin(u) / u * sin(v) / v, 4)), 0, 2e-8);
    field_free(&f);
}

/* ---- The matched step ---- */

static double order_between(const struct method *m, enum sampling sampling, double fourier, double *fine) {
    double error[2];
    for (int rung = 0; rung < 2; rung++) {
        struct problem p = rod(3);
        p.t_end =
            64 * pow(2.3 / 72, 2) / (6 * 0.29 / 2.385); /* whole steps at the matched F, which else is met nearly */
        struct options o = {.dx = 2.3 / (72 << rung), .sampling = sampling, .stepper = STEPPER_MATCHED};
        if (fourier > 0) o.stepper = STEPPER_EULER, o.fourier = fourier;
        struct field f = solved(m, &p, &o);
        double rate = 0.29 / 2.385 * pow(3 * PI / 2.3, 2);
        error[rung] = mode_error(&p, &f, exp(-rate * p.t_end));
        field_free(&f);
    }
    *fine = error[1];
    return log2(error[0] / error[1]);
}

/* What the sampling has smoothed already is not integrated again; a jump sampled at points is the reverse. */
static void test_matched_starts_late(void **state) {
    (void)state;
    const double m[] = {0, 1, 4, -1, 1, 4}, dx = 0.046;
    for (int i = 0; i < 6; i++) {
        struct problem p = rod(3);
        p.jumps[0] = i / 3, p.jump[0][0] = 0.4431;
        struct options o = {.dx = dx, .stepper = STEPPER_MATCHED, .sampling = (enum sampling)(i % 3)};
        struct field f = solved(&method_ftcs, &p, &o);
        double run = p.t_end - m[i] * dx * dx * 2.385 / (24 * 0.29), matched = dx * dx * 2.385 / (6 * 0.29);
        assert_near((double)f.steps * f.dt, run, 1e-15);
        assert_near((double)f.steps, run / matched + 1, 1); /* the next even number */
        assert_int_equal(f.steps % 2, 0);
        assert_near(f.time, p.t_end, 0);
        field_free(&f);
    }
}

static void test_matched_is_fourth_order(void **state) {
    (void)state;
    double matched, plain;
    assert_near(order_between(&method_ftcs, SAMPLING_POINT, 0, &matched), 4, 0.02);
    /* here the steps are uneven: sum dt^3 is off by 3 swing^2 < 6/64 at the coarse rung, half of the constant's terms
     */
    assert_near(order_between(&method_ftcs, SAMPLING_SPLINE, 0, &matched), 4, 0.07);
    assert_near(order_between(&method_ftcs_flux, SAMPLING_POINT, 0, &matched), 4, 0.02);
    assert_near(order_between(&method_ftcs, SAMPLING_POINT, 0.31, &plain), 2, 0.1);
    assert_true(plain > 50 * matched);
}

/* ---- What is refused, and how a run fails ---- */

static void refused(const struct method *m, const struct problem *p, const struct options *o, const char *words[]) {
    struct field f = {.n = 77};
    struct failure why = {0};
    assert_int_equal(m->solve(p, o, &f, &why), STATUS_INPUT);
    assert_int_equal(why.status, STATUS_INPUT);
    assert_int_equal(f.n, 77);
    for (; *words; words++)
        if (!strstr(why.text, *words)) fail_msg("'%s' is not in: %s", *words, why.text);
}

#define REFUSED(m, p, o, ...) refused(m, p, &(struct options)o, (const char *[]){__VA_ARGS__, NULL})
#define O(...)                                                                                                       \
    { __VA_ARGS__ }

static void test_refusals(void **state) {
    (void)state;
    struct problem r = rod(3), s = plane(3, 2), two = rod(3), late = rod(3), odd = plane(3, 2);
    two.materials = 2;
    late.t_end = NAN;
    odd.hi[1] = odd.lo[1] + sqrt(2);
    REFUSED(&method_ftcs, &r, O(.dx = 0.3), "--dx 0.3", "0.3285714286", "0.2875");
    REFUSED(&method_ftcs, &s, O(.dx = 0.05), "--dx 0.05", "2.3 m by 1.38 m", "0.05111111111", "0.046");
    REFUSED(&method_ftcs, &odd, O(.dx = 0.05), "--dx 0.05", "1.41421 m", "nearest: 0.0038");
    REFUSED(&method_ftcs, &r, O(.dx = 5), "--dx 5", "nearest: 0.575");
    REFUSED(&method_ftcs, &r, O(.dx = 1.15), "--dx 1.15", "4 or more", "nearest: 0.575");
    REFUSED(&method_ftcs, &r, O(.dx = 0), "--dx 0");
    REFUSED(&method_ftcs, &r, O(.dx = NAN), "--dx nan");
    REFUSED(&method_ftcs, &r, O(.dx = INFINITY), "--dx inf");
    REFUSED(&method_ftcs, &r, O(.dx = -0.1), "--dx -0.1");
    REFUSED(&method_ftcs, &s, O(.dx = 1e-9), "--dx 1e-09", "grid points");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .dt = -0.25), "--dt -0.25");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .dt = NAN), "--dt nan");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .fourier = -0.2), "--fourier -0.2");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .dt = 0.1, .fourier = 0.2), "--dt 0.1", "--fourier 0.2");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .dt = 1e-300), "time steps");
    REFUSED(&method_ftcs, &late, O(.dx = 0.115), "--t-end nan");
    REFUSED(&method_ftcs, &two, O(.dx = 0.115), "ftcs", "2", "material");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .layout = LAYOUT_JITTER), "--layout jitter", "lattice or node");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .stepper = STEPPER_RK2), "--stepper rk2", "euler", "matched");
    REFUSED(&method_ftcs_flux, &s, O(.dx = 0.046, .stepper = STEPPER_EXACT), "--stepper exact", "ftcs_flux", "euler");
    REFUSED(&method_ftcs, &s, O(.dx = 0.046, .stepper = STEPPER_MATCHED), "--stepper matched", "isotropic", "euler");
    REFUSED(&method_ftcs, &r, O(.dx = 0.115, .stepper = STEPPER_MATCHED, .dt = 0.1), "matched", "--dt");
    late.t_end = 0.01;
    REFUSED(&method_ftcs, &late, O(.dx = 0.115, .stepper = STEPPER_MATCHED, .sampling = SAMPLING_SPLINE), "matched",
            "0.018", "--dx below 0.085");
}

/* Just inside the limit a run is bounded, just outside it is a status with step, time and place. */
static void test_stability(void **state) {
    (void)state;
    const struct method *const both[] = {&method_ftcs, &method_ftcs_flux};
    const double limit[] = {0.5, 2}; /* of dt (kappa_x + kappa_y) / dx^2 */
    for (int m = 0; m < 2; m++) {
        struct problem p = plane(3, 2);
        p.initial = step, p.jumps[0] = 1, p.jump[0][0] = 0.2431, p.jump[1][0] = 0.9017, p.t_end = 60;
        double share = 0.71 / (0.29 + 0.71); /* of the larger kappa, which --fourier is made with */
        struct options o = {.dx = 0.046, .fourier = 0.995 * limit[m] * share};
        struct field f = solved(both[m], &p, &o);
        for (size_t i = 0; i < f.n; i++) assert_true(fabs(f.T[i]) < 4);
        field_free(&f);

        struct failure why = {0};
        o.fourier = 1.02 * limit[m] * share;
        assert_int_equal(both[m]->solve(&p, &o, &f, &why), STATUS_NUMERICAL);
        const char *text = strstr(why.text, "unstable at step ");
        long step_seen = 0, steps = 0;
        assert_non_null(text);
        assert_int_equal(sscanf(text, "unstable at step %ld of %ld,", &step_seen, &steps), 2);
        assert_true(step_seen % 32 == 0 && step_seen < steps / 2); /* it is not run to the end */
        assert_non_null(strstr(why.text, " t = "));
        assert_non_null(strstr(why.text, " at x = "));
        assert_non_null(strstr(why.text, ", y = "));
        o.fourier = 3 * limit[m], p.t_end = 19.5 * o.fourier * 0.046 * 0.046 * 2.385 / 0.71; /* at the last step */
        assert_int_equal(both[m]->solve(&p, &o, &f, &why), STATUS_NUMERICAL);
        assert_non_null(strstr(why.text, "unstable at step 20 of 20,"));
        p.initial = mode, p.param[2] = NAN; /* not a number from the start */
        assert_int_equal(both[m]->solve(&p, &o, &f, &why), STATUS_NUMERICAL);
    }
}

/* The step is whole: t_end / ceil(t_end / dt); a dx that is out by rounding is snapped. */
static void test_whole_steps(void **state) {
    (void)state;
    struct problem p = rod(3);
    struct options o = {.dx = 0.0383333333, .dt = 0.0037};
    struct field f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 100);
    assert_near(f.dt, 0.0037, 1e-18);
    assert_near(f.spacing[0], 2.3 / 60, 1e-16);
    assert_int_equal(f.shape[0], 60);
    assert_int_equal(f.shape[1], 1);
    assert_near(f.time, 0.37, 0);
    field_free(&f);
    o.dt = 0.00371;
    f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 100);
    field_free(&f);
    o.dt = 0.00369;
    f = solved(&method_ftcs, &p, &o);
    assert_int_equal(f.steps, 101);
    assert_near(f.range[0], 0.83 + 1.9 * sin(3 * PI * 29.5 / 60), 1e-14);
    field_free(&f);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_symbol),
        cmocka_unit_test(test_fluxes_are_blind_to_the_checkerboard),
        cmocka_unit_test(test_linear_profile_stays),
        cmocka_unit_test(test_source_holds_a_parabola),
        cmocka_unit_test(test_fixed_walls_lie_half_a_spacing_out),
        cmocka_unit_test(test_heat_balance),
        cmocka_unit_test(test_cell_averages_of_a_jump),
        cmocka_unit_test(test_spline_averages_of_a_jump),
        cmocka_unit_test(test_sampling_past_the_walls),
        cmocka_unit_test(test_matched_starts_late),
        cmocka_unit_test(test_matched_is_fourth_order),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_stability),
        cmocka_unit_test(test_whole_steps),
    };
    return cmocka_run_group_tests_name("ftcs", tests, NULL, NULL);
}
