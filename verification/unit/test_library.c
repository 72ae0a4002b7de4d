/* SPDX-License-Identifier: GPL-3.0-or-later */
/* libheatladder gives the numbers of the program, and returns a status where it cannot. */
#include "references/library/heatladder.h"

#include "references/scene.h"
#include "solver/method.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

static const struct hl_setting kappa[] = {{"kappa", 0.0213}, {"t_end", 3.7}, {NULL, 0}};

static struct hl_problem *problem_of(const char *scene, const struct hl_setting *settings) {
    struct hl_error why;
    struct hl_problem *p = hl_problem_create(scene, settings, &why);
    if (!p) fail_msg("%s: %s", scene, why.text);
    return p;
}

/* More points than one batch. */
static void exact_temperatures_are_those_of_the_scene(void **state) {
    (void)state;
    enum { N = 5000 };
    static double x[N], T[N], bound[N];
    struct hl_error why;
    struct hl_box box;
    struct hl_problem *h = problem_of("rod-step", kappa);
    const struct scene *s = scene_find("rod-step");
    struct problem p;
    struct failure failure;
    scene_defaults(s, &p);
    for (int i = 0; s->params[i].name; i++)
        for (int k = 0; k < 2; k++)
            if (strcmp(s->params[i].name, kappa[k].name) == 0) p.param[i] = kappa[k].value;
    assert_int_equal(s->setup(&p, &failure), STATUS_OK);
    hl_problem_box(h, &box);
    assert_int_equal(box.dim, 1);
    assert_near(box.hi[0], p.hi[0], 0);
    assert_near(box.t_end, 3.7, 0);
    for (int i = 0; i < N; i++) x[i] = box.lo[0] + (box.hi[0] - box.lo[0]) * i / (N - 1);
    assert_int_equal(hl_exact(h, 1.9, N, x, NULL, T, bound, &why), HL_OK);
    for (int i = 0; i < N; i += 7) {
        struct exact e = scene_exact(s, &p, (double[2]){x[i], 0}, 1.9);
        assert_near(T[i], e.temperature, e.error_bound);
        assert_near(bound[i], e.error_bound, e.error_bound);
    }
    hl_problem_free(h);
}

static void scenes_have_initial_data(void **state) {
    (void)state;
    for (int i = 0; hl_scene(i); i++) {
        struct hl_problem *h = problem_of(hl_scene(i), NULL);
        struct hl_box box;
        struct hl_error why;
        double T, bound;
        hl_problem_box(h, &box);
        double x = (box.lo[0] + 2 * box.hi[0]) / 3 + box.hole / 3, y = (box.lo[1] + box.hi[1]) / 2,
               z = (2 * box.lo[2] + box.hi[2]) / 3;
        assert_int_equal(hl_exact_at(h, 0, 1, &x, &y, &z, &T, &bound, &why), HL_OK);
        assert_true(isfinite(T) && bound >= 0);
        hl_problem_free(h);
    }
    assert_null(hl_scene(-1));
}

/* Bit for bit, though the library has one thread and no OpenMP. */
static void fields_are_those_of_the_solver(void **state) {
    (void)state;
    static const struct hl_options row[] = {
        {.dx = 0.1},
        {.dx = 0.1, .layout = "jitter", .jitter = 0.2, .seed = 3, .stepper = "rk2"},
        {.dx = 0.1, .kernel = "wendland", .h = 1.3, .stepper = "rkl2", .dt = 0.1}};
    static const struct options same[] = {
        {.dx = 0.1, .stepper = STEPPER_EXACT},
        {.dx = 0.1, .layout = LAYOUT_JITTER, .jitter = 0.2, .seed = 3, .stepper = STEPPER_RK2, .threads = 2},
        {.dx = 0.1, .kernel = KERNEL_WENDLAND, .h = 1.3, .stepper = STEPPER_RKL2, .dt = 0.1, .threads = 2}};
    const struct scene *s = scene_find("square-step");
    struct problem p;
    struct failure failure;
    struct hl_error why;
    scene_defaults(s, &p);
    assert_int_equal(s->setup(&p, &failure), STATUS_OK);
    struct hl_problem *h = problem_of("square-step", NULL);
    for (int i = 0; i < 3; i++) {
        struct hl_field a;
        struct field b;
        if (hl_solve(h, "so_ssph", &row[i], &a, &why)) fail_msg("row %d: %s", i, why.text);
        assert_int_equal(method_solve(method_find("so_ssph"), &p, &same[i], &b, &failure), STATUS_OK);
        assert_int_equal(a.n, b.n);
        assert_int_equal(a.steps, b.steps);
        assert_memory_equal(a.T, b.T, a.n * sizeof *a.T);
        double x[DIM_MAX];
        for (size_t k = 0; k < a.n; k++) assert_near(a.y[k], field_place(&b, k, x)[1], 0);
        hl_field_free(&a);
        field_free(&b);
    }
    hl_problem_free(h);
}

/* In batches of 4096. */
static void points_in_space_are_those_of_the_scene(void **state) {
    (void)state;
    enum { N = 5000 };
    static double x[3][N], T[N], bound[N];
    static const char *const name[] = {"cube-step", "ball-mode"};
    for (int k = 0; k < 2; k++) {
        const struct scene *s = scene_find(name[k]);
        struct hl_problem *h = problem_of(name[k], NULL);
        struct hl_error why;
        struct hl_box box;
        struct problem p;
        struct failure failure;
        scene_defaults(s, &p);
        assert_int_equal(s->setup(&p, &failure), STATUS_OK);
        hl_problem_box(h, &box);
        assert_int_equal(box.dim, 3);
        for (int i = 0; i < N; i++)
            for (int a = 0; a < 3; a++)
                x[a][i] = 0.55 * (box.lo[a] + (box.hi[a] - box.lo[a]) * (i * (a + 3) % N) / N);
        assert_int_equal(hl_exact_at(h, 0.9, N, x[0], x[1], x[2], T, bound, &why), HL_OK);
        for (int i = 0; i < N; i += 7) {
            struct exact e = scene_exact(s, &p, (double[DIM_MAX]){x[0][i], x[1][i], x[2][i]}, 0.9);
            assert_near(T[i], e.temperature, e.error_bound);
            assert_near(bound[i], e.error_bound, e.error_bound);
        }
        assert_int_equal(hl_exact(h, 0.9, N, x[0], x[1], T, bound, &why), HL_INPUT);
        assert_has(why.text, "z is missing");
        x[2][3] = 77;
        assert_int_equal(hl_exact_at(h, 0.9, N, x[0], x[1], x[2], T, bound, &why), HL_INPUT);
        assert_has(why.text, "point 3: z = 77 m is outside");
        hl_problem_free(h);
    }
}

/* The columns of `reference`: means over cells of widths of their own, a wall of three values, the exact solution;
 * more points than one batch. */
static void data_are_those_of_the_scene(void **state) {
    (void)state;
    enum { N = 5000 };
    static double x[N], dx[N], value[6 * N];
    static const char what[] = "initial_mean,temperature,wall,rho_c";
    struct hl_error why;
    struct hl_problem *h = problem_of("rod-step", kappa);
    struct hl_points points = {.n = N, .x = x, .dx = dx};
    char names[80];
    for (int i = 0; i < N; i++) x[i] = -2 + 4.0 * i / (N - 1), dx[i] = 0.01 + 1e-6 * i;
    assert_int_equal(hl_reference_values(h, what, names, sizeof names, &why), 6);
    assert_string_equal(names, "initial_mean,temperature,wall_kind,wall_value,wall_b,rho_c");
    if (hl_reference(h, what, 1.9, &points, value, &why)) fail_msg("%s", why.text);
    for (int i = 0; i < N; i += 41) { /* 10 K for |x| <= 0.5 */
        double lo = fmax(fmax(x[i] - dx[i] / 2, -0.5), -2), hi = fmin(fmin(x[i] + dx[i] / 2, 0.5), 2), T;
        double size = fmin(x[i] + dx[i] / 2, 2) - fmax(x[i] - dx[i] / 2, -2);
        assert_near(value[i], 10 * fmax(hi - lo, 0) / size, 1e-11);
        assert_int_equal(hl_exact(h, 1.9, 1, &x[i], NULL, &T, NULL, &why), HL_OK);
        assert_near(value[N + i], T, 0);
        assert_near(value[2 * N + i], i == 0 || i == N - 1, 0);
        assert_near(value[5 * N + i], 1, 0);
    }
    hl_problem_free(h);
}

/* One row for each argument of a function of the header: it returns a status with what is wrong. */
#define REFUSED(call, due, says)                                                                                     \
    do {                                                                                                             \
        why = (struct hl_error){-1, ""};                                                                             \
        (void)(call);                                                                                                \
        if (why.status != (due) || !strstr(why.text, says))                                                          \
            fail_msg("%s: status %d, \"%s\"; expected %d, \"%s\"", #call, why.status, why.text, due, says);          \
    } while (0)

static void bad_arguments_of_problems_are_named(void **state) {
    (void)state;
    struct hl_error why;
    struct hl_parameter parameter;
    struct hl_box box = {.dim = 7};
    const struct hl_setting nan[] = {{"kappa", NAN}, {NULL, 0}}, negative[] = {{"kappa", -1.5}, {NULL, 0}};
    const struct hl_setting name[] = {{"kapa", 1}, {NULL, 0}}, word[] = {{"material", 3}, {NULL, 0}};
    assert_null(hl_scene(-1));
    assert_null(hl_method(-1));
    assert_null(hl_scene(1000));
    assert_null(hl_method(1000));
    assert_non_null(hl_version());
    assert_int_equal(hl_parameter(NULL, 0, &parameter), 0);
    assert_int_equal(hl_parameter("rod-stp", 0, &parameter), 0);
    assert_int_equal(hl_parameter("rod-step", 0, NULL), 0);
    assert_int_equal(hl_parameter("rod-step", -1, &parameter), 0);
    assert_int_equal(hl_parameter("rod-step", 99, &parameter), 0);
    REFUSED(hl_problem_create(NULL, NULL, &why), HL_INPUT, "scene is missing");
    REFUSED(hl_problem_create("rod-stp", NULL, &why), HL_INPUT, "unknown scene 'rod-stp'; did you mean 'rod-step'?");
    REFUSED(hl_problem_create("rod-step", name, &why), HL_INPUT,
            "unknown parameter of rod-step 'kapa'; did you mean");
    REFUSED(hl_problem_create("rod-step", nan, &why), HL_INPUT, "--set kappa=nan: must be a finite number");
    REFUSED(hl_problem_create("rod-step", negative, &why), HL_INPUT,
            "--set kappa=-1.5: needs a finite number greater");
    REFUSED(hl_problem_create("plate", word, &why), HL_INPUT, "--set material=3: must be the place of a word");
    assert_null(hl_problem_create("rod-step", negative, NULL));
    hl_problem_box(NULL, &box);
    assert_int_equal(box.dim, 0);
    hl_problem_box(NULL, NULL);
    hl_problem_free(NULL);
    hl_field_free(NULL);
}

static void bad_arguments_at_points_are_named(void **state) {
    (void)state;
    struct hl_error why;
    struct hl_problem *h = problem_of("rod-step", NULL), *plane = problem_of("square-step", NULL);
    const double x[2] = {0, 99}, nan = NAN, less = -0.1;
    double T[2], bound[2];
    char names[5];
    const struct hl_points at = {.n = 1, .x = x}, none = {.n = 1}, off = {.n = 1, .x = &nan},
                           outside = {.n = 2, .x = x};
    const struct hl_points cells = {.n = 1, .x = x, .dx = &less}, empty = {0};
    REFUSED(hl_exact_at(NULL, 1, 1, x, NULL, NULL, T, bound, &why), HL_INPUT, "problem is missing");
    REFUSED(hl_exact_at(h, 1, 1, NULL, NULL, NULL, T, bound, &why), HL_INPUT, "x is missing: rod-step has 1 axis");
    REFUSED(hl_exact_at(h, 1, 1, x, NULL, NULL, NULL, bound, &why), HL_INPUT, "T is missing");
    REFUSED(hl_exact_at(plane, 1, 1, x, NULL, NULL, T, bound, &why), HL_INPUT,
            "y is missing: square-step has 2 axes");
    REFUSED(hl_exact_at(h, -1, 1, x, NULL, NULL, T, bound, &why), HL_INPUT, "t = -1 s: must be finite and >= 0");
    REFUSED(hl_exact_at(h, NAN, 1, x, NULL, NULL, T, bound, &why), HL_INPUT, "t = nan s");
    REFUSED(hl_exact_at(h, INFINITY, 1, x, NULL, NULL, T, bound, &why), HL_INPUT, "t = inf s");
    REFUSED(hl_exact_at(h, 1, 1, &nan, NULL, NULL, T, bound, &why), HL_INPUT, "point 0: x = nan m is outside");
    REFUSED(hl_exact(h, 1, 2, x, NULL, T, NULL, &why), HL_INPUT, "point 1: x = 99 m is outside -2 to 2 m");
    REFUSED(hl_exact(NULL, 1, 1, x, NULL, T, bound, &why), HL_INPUT, "problem is missing");
    REFUSED(hl_exact(h, 1, 0, NULL, NULL, NULL, NULL, &why), HL_OK, "");
    REFUSED(hl_reference(NULL, "initial", 0, &at, T, &why), HL_INPUT, "problem is missing");
    REFUSED(hl_reference(h, NULL, 0, &at, T, &why), HL_INPUT, "what is missing");
    REFUSED(hl_reference(h, "initial", 0, NULL, T, &why), HL_INPUT, "points is missing");
    REFUSED(hl_reference(h, "initial", 0, &at, NULL, &why), HL_INPUT, "value is missing");
    REFUSED(hl_reference(h, "initial", 0, &none, T, &why), HL_INPUT, "x is missing");
    REFUSED(hl_reference(h, "initial", 0, &off, T, &why), HL_INPUT, "x = nan m is outside");
    REFUSED(hl_reference(h, "initial", 0, &outside, T, &why), HL_INPUT, "point 1: x = 99 m");
    REFUSED(hl_reference(h, "initial", NAN, &at, T, &why), HL_INPUT, "t = nan s");
    REFUSED(hl_reference(h, "inital", 0, &at, T, &why), HL_INPUT, "'inital'; did you mean 'initial'?");
    REFUSED(hl_reference(h, "k_y", 0, &at, T, &why), HL_INPUT, "a rod has no y");
    REFUSED(hl_reference(h, "flux_x", 0, &at, T, &why), HL_INPUT, "needs a time > 0");
    REFUSED(hl_reference(h, "initial_mean", 0, &at, T, &why), HL_INPUT, "needs the cell around each point");
    REFUSED(hl_reference(h, "initial_mean", 0, &cells, T, &why), HL_INPUT, "point 0: dx = -0.1 m");
    REFUSED(hl_reference(h, "initial", 0, &empty, NULL, &why), HL_OK, "");
    REFUSED(hl_reference_values(NULL, "initial", NULL, 0, &why), HL_INPUT, "problem is missing");
    REFUSED(hl_reference_values(h, NULL, NULL, 0, &why), HL_INPUT, "what is missing");
    REFUSED(hl_reference_values(h, "walls", NULL, 0, &why), HL_INPUT, "did you mean 'wall'?");
    REFUSED(hl_reference_values(h, "initial", names, sizeof names, &why), HL_INPUT, "the names take 8 characters");
    assert_int_equal(hl_reference_values(h, "walls", NULL, 0, NULL), -1);
    hl_problem_free(h);
    hl_problem_free(plane);
}

static void bad_options_of_a_run_are_named(void **state) {
    (void)state;
    struct hl_error why;
    struct hl_field f;
    struct hl_problem *h = problem_of("rod-step", NULL);
    const struct {
        const char *method, *says;
        struct hl_options options;
        int status;
    } row[] = {
        {NULL, "method is missing", {.dx = 0.1}, HL_INPUT},
        {"so_sph", "unknown method 'so_sph'; did you mean 'so_ssph'?", {.dx = 0.1}, HL_INPUT},
        {"so_ssph", "--dx is missing", {.h = 1.1}, HL_INPUT},
        {"so_ssph", "--dx -0.1: must be a finite number > 0", {.dx = -0.1}, HL_INPUT},
        {"ftcs", "--dx nan", {.dx = NAN}, HL_INPUT},
        {"ftcs", "--dx inf", {.dx = INFINITY}, HL_INPUT},
        {"so_ssph", "--dt -1", {.dx = 0.1, .dt = -1}, HL_INPUT},
        {"ftcs", "--dt nan", {.dx = 0.1, .dt = NAN}, HL_INPUT},
        {"ftcs", "--dt 50: a step exceeds the end time", {.dx = 0.1, .dt = 50}, HL_INPUT},
        {"so_ssph", "--fourier -0.3", {.dx = 0.1, .fourier = -0.3}, HL_INPUT},
        {"so_ssph", "exclude each other", {.dx = 0.1, .dt = 0.1, .fourier = 0.1}, HL_INPUT},
        {"so_ssph", "takes no time step", {.dx = 0.1, .dt = 0.1, .stepper = "exact"}, HL_INPUT},
        {"so_ssph", "--h -1.1", {.dx = 0.1, .h = -1.1}, HL_INPUT},
        {"so_ssph", "--h nan", {.dx = 0.1, .h = NAN}, HL_INPUT},
        {"so_ssph", "these particles do not move", {.dx = 0.1, .jitter = 0.2}, HL_INPUT},
        {"so_ssph", "--jitter 0.7", {.dx = 0.1, .jitter = 0.7, .layout = "jitter"}, HL_INPUT},
        {"so_ssph", "--jitter nan", {.dx = 0.1, .jitter = NAN, .layout = "jitter"}, HL_INPUT},
        {"so_ssph", "unknown kernel 'cubicc'; did you mean 'cubic'?", {.dx = 0.1, .kernel = "cubicc"}, HL_INPUT},
        {"so_ssph", "unknown walls ''", {.dx = 0.1, .walls = ""}, HL_INPUT},
        {"ftcs", "--kernel: no option of ftcs", {.dx = 0.1, .kernel = "cubic"}, HL_INPUT},
        {"so_ssph", "--order 5: must be 2, 3 or 4", {.dx = 0.1, .order = 5}, HL_INPUT},
        {"so_ssph", "--order -2", {.dx = 0.1, .order = -2}, HL_INPUT},
        {"ftcs", "stepper", {.dx = 0.1, .stepper = "exact"}, HL_NOT_APPLICABLE},
        {"so_ssph", "step", {.dx = 0.1, .stepper = "euler", .fourier = 30}, HL_UNSTABLE}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        REFUSED(hl_solve(h, row[i].method, &row[i].options, &f, &why), row[i].status, row[i].says);
        assert_true(f.n == 0 && !f.T);
        hl_field_free(&f);
    }
    REFUSED(hl_solve(NULL, "ftcs", &row[2].options, &f, &why), HL_INPUT, "problem is missing");
    REFUSED(hl_solve(h, "ftcs", NULL, &f, &why), HL_INPUT, "options is missing");
    REFUSED(hl_solve(h, "ftcs", &row[2].options, NULL, &why), HL_INPUT, "field is missing");
    hl_problem_free(h);
}
#undef REFUSED

static void host(const char *reason, const char *file, int line, int error) {
    (void)reason, (void)file, (void)line, (void)error;
}

/* The host's handler of GSL is in place again; memory of a failed call is released, or the third would fail. */
static void out_of_memory_is_a_status(void **state) {
    (void)state;
#ifdef __SANITIZE_ADDRESS__
    skip(); /* it takes terabytes of addresses for itself */
#endif
    struct rlimit before, less;
    struct hl_error why;
    struct hl_field f;
    struct hl_problem *h = problem_of("rod-step", NULL);
    gsl_error_handler_t *mine = gsl_set_error_handler(host);
    getrlimit(RLIMIT_AS, &before);
    less = before;
    less.rlim_cur = 1u << 30;
    setrlimit(RLIMIT_AS, &less);
    for (int i = 0; i < 3; i++) {
        struct hl_options much = {.dx = 4.0 / 40000000}, little = {.dx = 4.0 / 4000000};
        assert_int_equal(hl_solve(h, "so_ssph", &much, &f, &why), HL_MEMORY);
        assert_string_equal(why.text, "out of memory");
        assert_int_equal(hl_solve(h, "so_ssph", &little, &f, &why), HL_OK);
        hl_field_free(&f);
    }
    setrlimit(RLIMIT_AS, &before);
    assert_ptr_equal(gsl_set_error_handler(mine), host);
    hl_problem_free(h);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_temperatures_are_those_of_the_scene),
        cmocka_unit_test(scenes_have_initial_data),
        cmocka_unit_test(fields_are_those_of_the_solver),
        cmocka_unit_test(points_in_space_are_those_of_the_scene),
        cmocka_unit_test(data_are_those_of_the_scene),
        cmocka_unit_test(bad_arguments_of_problems_are_named),
        cmocka_unit_test(bad_arguments_at_points_are_named),
        cmocka_unit_test(bad_options_of_a_run_are_named),
        cmocka_unit_test(out_of_memory_is_a_status),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
