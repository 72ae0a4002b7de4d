/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors that plane.def predicts for matched runs (solver/time/matched.c).  In units of the lattice, theta = xi
 * dx and r = kappa/dx^2 along either axis, an isotropic stencil has the symbol
 *
 *   r (-|theta|^2 + A |theta|^4 - c60 (theta_x^6 + theta_y^6) - c42 (theta_x^4 theta_y^2 + theta_x^2 theta_y^4)),
 *   c60 = sum w x^6/720,   c42 = sum w x^4 y^2/48.
 *
 * n Euler steps d (1 +- u), r d (1 + u^2) = 2 A, take a mode by sum log(1 + dt lambda): the second order cancels, and
 *
 *   r t (K |theta|^6 - c60 (...) - c42 (...)),   K = 2 A^2 - (r d)^2 (1 + 3 u^2)/3
 *
 * is left; so is -m/2880 (theta_x^4 + theta_y^4) of a start averaged with a B-spline of order m, whose clock starts
 * at m/(24 r).  E1 is the mean of that, applied to the exact solution by derivatives, over the mean of T. */
#include "verification/unit/stencil_moments.h"

#include "references/scene.h"

#include "solver/time/matched.h"

/* U = (erf((a + x)/s) + erf((a - x)/s))/2 and its derivatives of even order up to six */
static void box(double x, double a, double s, double d[4]) {
    double side[2] = {(a + x) / s, (a - x) / s};
    for (int k = 0; k < 4; k++) d[k] = 0;
    for (int k = 0; k < 2; k++) {
        double z = side[k], g = exp(-z * z) / sqrt(3.14159265358979323846);
        d[0] += erf(z) / 2;
        d[1] += -2 * z * g / pow(s, 2);
        d[2] += -(8 * pow(z, 3) - 12 * z) * g / pow(s, 4);
        d[3] += -(32 * pow(z, 5) - 160 * pow(z, 3) + 120 * z) * g / pow(s, 6);
    }
}

/* exp(-x^2/(2 s^2)) likewise, up to a factor */
static void gauss(double x, double s, double d[4]) {
    double z = x / s, g = exp(-z * z / 2);
    d[0] = g;
    d[1] = (z * z - 1) * g / pow(s, 2);
    d[2] = (pow(z, 4) - 6 * z * z + 3) * g / pow(s, 4);
    d[3] = (pow(z, 6) - 15 * pow(z, 4) + 45 * z * z - 15) * g / pow(s, 6);
}

/* What an error is made of: factors of D_x^6 + D_y^6, D_x^4 D_y^2 + D_x^2 D_y^4, D_x^4 + D_y^4, D_x^2 D_y^2 and
 * D_x^2 + D_y^2, D the derivative by the cell. */
struct terms {
    double sixth, mixed_sixth, fourth, mixed_fourth, second;
};

/* The even derivatives by the cell along one axis, continued as odd about the cold walls. */
static void derivatives(const struct experiment *e, int axis, double dx, const double half[2], double x,
                        double d[4]) {
    const struct problem *p = &e->problem;
    double kappa = p->material[0].k[axis];
    int smooth = strcmp(e->scene->name, "rod-gauss") == 0;
    for (int k = 0; k < 4; k++) d[k] = 0;
    for (int image = -2; image <= 2; image++) {
        double at = x - image * (p->hi[axis] - p->lo[axis]), part[4];
        if (smooth)
            gauss(at, sqrt(half[0] * half[0] + 2 * kappa * p->t_end), part);
        else
            box(at, half[axis], sqrt(4 * kappa * p->t_end), part);
        for (int k = 0; k < 4; k++) d[k] += (image % 2 ? -1 : 1) * part[k] * pow(dx, 2 * k);
    }
}

static double mean_of(const struct experiment *e, const double dx[2], const struct terms *t) {
    const struct problem *p = &e->problem;
    double half[2] = {0.5, 0.5}, sum = 0, whole = 0;
    int cells[2] = {0, 1};
    for (int i = 0; e->scene->params[i].name; i++) {
        const char *name = e->scene->params[i].name;
        if (strcmp(name, "a") == 0 || strcmp(name, "sigma0") == 0) half[0] = p->param[i];
        if (strcmp(name, "b") == 0) half[1] = p->param[i];
    }
    for (int a = 0; a < p->dim; a++) cells[a] = (int)nearbyint((p->hi[a] - p->lo[a]) / dx[a]);
    for (int j = 0; j < cells[1]; j++)
        for (int i = 0; i < cells[0]; i++) {
            double d[2][4] = {{0}, {1, 0, 0, 0}};
            for (int a = 0; a < p->dim; a++)
                derivatives(e, a, dx[a], half, p->lo[a] + ((a ? j : i) + 0.5) * dx[a], d[a]);
            const double *U = d[0], *V = d[1];
            sum += fabs(t->sixth * (U[3] * V[0] + U[0] * V[3]) + t->mixed_sixth * (U[2] * V[1] + U[1] * V[2]) +
                        t->fourth * (U[2] * V[0] + U[0] * V[2]) + t->mixed_fourth * U[1] * V[1] +
                        t->second * (U[1] * V[0] + U[0] * V[1]));
            whole += fabs(U[0] * V[0]);
        }
    return sum / whole;
}

struct symbol {
    double A, B, c60, c42;
};

static struct symbol symbol_of(const struct experiment *e) {
    struct options o = e->options;
    struct problem unit = e->problem;
    struct stencil s;
    struct failure why;
    const struct scheme *scheme = e->method->scheme;
    const double one[2] = {1, 1};
    if (!scheme) return (struct symbol){1.0 / 12, 0, 1.0 / 360, 0};
    unit.material[0] = (struct material){{1, 1}, 1};
    if (!(o.h > 0)) o.h = 1.1;
    if (o.h_iso) assert_int_equal(matched_isotropic(&e->options, scheme, &o.h, &why), STATUS_OK);
    o.h_iso = 0;
    assert_int_equal(operator_stencil(&unit, &o, scheme, 1, one, s.reach, &s.w, &why), STATUS_OK);
    struct symbol symbol = {stencil_moment(&s, 4, 0, 0) / 24, stencil_moment(&s, 2, 2, 0) / 4,
                            stencil_moment(&s, 6, 0, 0) / 720, stencil_moment(&s, 4, 2, 0) / 48};
    free(s.w);
    return symbol;
}

static struct request request(const char *line) {
    struct request r;
    struct failure why;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    return r;
}

/* E1 of a matched run whose start is averaged to order m. */
static double matched(const char *line, int m) {
    struct request r = request(line);
    const struct experiment *e = &r.experiment;
    const double *kappa = e->problem.material[0].k,
                 dx[2] = {e->options.dx, e->options.dx * sqrt(kappa[1] / kappa[0])};
    struct symbol s = symbol_of(e);
    double rate = kappa[0] / (dx[0] * dx[0]), rt = rate * e->problem.t_end - m / 24.0;
    double n = 2 * ceil(rt / (2 * s.A) / 2 - 1e-9), rd = rt / n, u2 = 2 * s.A / rd - 1;
    double K = 2 * s.A * s.A - rd * rd * (1 + 3 * u2) / 3;
    struct terms t = {-rt * (K - s.c60), -rt * (3 * K - s.c42), -m / 2880.0, 0, 0};
    double error = mean_of(e, dx, &t);
    arguments_free(&r);
    return error;
}

/* Where one of its three parts is missing, second order is left: factors of the biharmonic and of D_x^2 D_y^2, both
 * times kappa t, and of the Laplacian. */
static double unmatched(const char *line, double biharmonic, double mixed, double laplacian) {
    struct request r = request(line);
    const double dx[2] = {r.experiment.options.dx, r.experiment.options.dx};
    double rt = r.experiment.problem.material[0].k[0] * r.experiment.problem.t_end / (dx[0] * dx[0]);
    struct terms t = {0, 0, biharmonic * rt, (2 * biharmonic + mixed) * rt, laplacian};
    double error = mean_of(&r.experiment, dx, &t);
    arguments_free(&r);
    return error;
}

#define GAUSS_LINE " --stepper matched --set t_end=50 --dx 0.0625"
#define PLANE_LINE "run square-step so_ssph --stepper matched --h iso --sampling spline --set L=1 "
static void errors_of_matched_runs(void **state) {
    (void)state;
    static const struct {
        const char *line;
        int m;
        double want;
    } row[] = {
        {"run rod-gauss so_ssph" GAUSS_LINE, 0, 8.864e-10},
        {"run rod-gauss ftcs" GAUSS_LINE, 0, 1.562e-9},
        {"run rod-step ftcs --stepper matched --sampling spline --dx 4/640", 4, 3.261e-10},
        {"run rod-step ftcs --stepper matched --sampling spline --dx 4/642", 4, 3.221e-10},
        {"run rod-step ftcs --stepper matched --sampling spline --dx 4/644", 4, 3.182e-10},
        {"run rod-step so_ssph --stepper matched --dx 4/640", -1, 2.766e-10},
        {"run rod-step so_ssph --stepper matched --sampling spline --dx 4/640", 4, 1.639e-10},
        {"run rod-step so_ssph --stepper matched --sampling spline --dx 4/642", 4, 1.618e-10},
        {"run rod-step so_ssph --stepper matched --sampling spline --dx 4/644", 4, 1.598e-10},
        {"run square-step so_ssph --stepper matched --h iso --sampling spline --dx 0.1", 4, 3.655e-5},
        {PLANE_LINE "--dx 1/224", 4, 1.224e-10},
        {PLANE_LINE "--dx 2/450", 4, 1.203e-10},
        {PLANE_LINE "--dx 2/452", 4, 1.183e-10},
        {PLANE_LINE "--kernel wendland --set kappa_y=0.0025 --set b=0.7 --dx 1/160", 4, 3.215e-10},
        {PLANE_LINE "--set kappa_x=0.009 --set kappa_y=0.004 --set b=0.7 --dx 1/160", 4, 3.237e-10},
        {PLANE_LINE "--kernel quartic --set kappa_x=0.009 --set kappa_y=0.004 --set b=0.7 --dx 1/112", 4, 1.339e-9},
        {PLANE_LINE "--kernel wendland --set kappa_x=0.01 --set kappa_y=0.0225 --set b=0.7 --dx 1/120", 4, 1.618e-9}};
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++)
        assert_near(matched(row[k].line, row[k].m) / row[k].want, 1, 0.001);
}

/* Averages over cells of a jump s dx off a particle: cell by cell the sum misses -dx^3/24 phi'', the cell that is cut
 * (1/8 - s^2/2) dx^2 phi', together (1/12 - s^2/2) dx^2, of which the clock takes 1/24: dx^2/24 at s = 0. */
static void errors_without_one_part(void **state) {
    (void)state;
    const char *iso = "run square-step so_ssph --h iso --dx 4/320",
               *usual = "run square-step so_ssph --h 1.1 --dx 4/320";
    struct request r = request(iso), q = request(usual);
    struct symbol s = symbol_of(&r.experiment), t = symbol_of(&q.experiment);
    assert_near(unmatched(usual, 0, t.B - 2 * t.A, 0) / 1.4194e-5, 1, 0.001);
    assert_near(unmatched(iso, s.A - 0.1, 0, 0) / 5.7155e-5, 1, 0.001);
    assert_near(unmatched(iso, 0, 0, 4 / 24.0) / 2.1011e-4, 1, 0.001);
    assert_near(unmatched("run rod-step so_ssph --dx 4/340", 0, 0, 1 / 24.0) / 2.8913e-5, 1, 0.001);
    arguments_free(&r);
    arguments_free(&q);
}

/* Good input that no step matches is not applicable; what is no input at all, or told twice, is bad. */
static void what_does_not_match_is_not_bad_input(void **state) {
    (void)state;
    static const struct {
        const char *line, *word;
        int status;
    } all[] = {
        {"run square-step so_ssph --stepper matched --h 1.1 --dx 0.1", "--h iso", STATUS_NOT_APPLICABLE},
        {"run square-step ftcs --stepper matched --dx 0.1", "isotropic", STATUS_NOT_APPLICABLE},
        {"run plate so_ssph --stepper matched --h iso --set T1=0 --set T3=0 --dx 0.01", "along one axis only",
         STATUS_NOT_APPLICABLE},
        {"run square-step so_ssph --stepper matched --h iso --dx 0.1 --dt 0.1", "--dt", STATUS_INPUT},
        {"run rod-gauss so_ssph --stepper matched --sampling spline --dx 0.5 --t-end 1e-3", "--t-end", STATUS_INPUT},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        struct request r = request(all[i].line);
        struct experiment *e = &r.experiment;
        struct field f;
        struct failure why = {0};
        assert_int_equal(method_solve(e->method, &e->problem, &e->options, &f, &why), all[i].status);
        if (!strstr(why.text, all[i].word)) fail_msg("'%s' is not in: %s", all[i].word, why.text);
        arguments_free(&r);
    }
}

static double along_y_hi(const struct problem *p, enum side s, const double x[2]) {
    (void)p;
    return s == Y_HI ? x[0] : 0;
}

/* A first derivative taken twice, on a rectangle that is 0 but for one side: refused there, wherever that is. */
static void walls_that_vary_are_seen_on_each_side(void **state) {
    (void)state;
    struct request r = request("run square-step fo_ssph --dx 0.1 --sampling spline");
    const struct experiment *e = &r.experiment;
    struct problem p = e->problem;
    struct lattice l;
    struct failure why = {0};
    assert_int_equal(layout_lattice(&p, &e->options, 1, &l, &why), STATUS_OK);
    assert_int_equal(matched_check(&p, &e->options, e->method->scheme, &l, &why), STATUS_OK);
    p.wall = along_y_hi;
    assert_int_equal(matched_check(&p, &e->options, e->method->scheme, &l, &why), STATUS_NOT_APPLICABLE);
    assert_non_null(strstr(why.text, "a first derivative applied twice"));
    arguments_free(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_matched_runs),
        cmocka_unit_test(errors_without_one_part),
        cmocka_unit_test(what_does_not_match_is_not_bad_input),
        cmocka_unit_test(walls_that_vary_are_seen_on_each_side),
    };
    return cmocka_run_group_tests_name("ceilings_matched", tests, NULL, NULL);
}
