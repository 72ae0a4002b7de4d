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

static void invalid_input_is_named(void **state) {
    (void)state;
    struct hl_error why;
    assert_null(hl_problem_create("rod-stp", NULL, &why));
    assert_int_equal(why.status, HL_INPUT);
    assert_has(why.text, "rod-stp");
    assert_null(hl_problem_create("rod-step", (struct hl_setting[]){{"kapa", 1}, {NULL, 0}}, &why));
    assert_has(why.text, "kapa");
    assert_null(hl_problem_create("rod-step", (struct hl_setting[]){{"kappa", NAN}, {NULL, 0}}, &why));
    assert_has(why.text, "finite");
    assert_null(hl_problem_create("rod-step", (struct hl_setting[]){{"kappa", -1}, {NULL, 0}}, NULL));
    struct hl_problem *h = problem_of("rod-step", NULL);
    double x[2] = {0, 99}, T[2];
    assert_int_equal(hl_exact(h, 1, 2, x, NULL, T, NULL, &why), HL_INPUT);
    assert_has(why.text, "point 1: x = 99 m is outside");
    assert_int_equal(hl_exact(h, -1, 1, x, NULL, T, NULL, &why), HL_INPUT);
    const struct {
        const char *method, *says;
        struct hl_options options;
        int status;
    } row[] = {{"so_sph", "so_sph", {.dx = 0.1}, HL_INPUT},
               {"so_ssph", "dx", {.h = 1.1}, HL_INPUT},
               {"so_ssph", "cubicc", {.dx = 0.1, .kernel = "cubicc"}, HL_INPUT},
               {"ftcs", "no option of ftcs", {.dx = 0.1, .kernel = "cubic"}, HL_INPUT},
               {"so_ssph", "order", {.dx = 0.1, .order = 5}, HL_INPUT},
               {"ftcs", "stepper", {.dx = 0.1, .stepper = "rk2"}, HL_NOT_APPLICABLE},
               {"so_ssph", "step", {.dx = 0.1, .stepper = "euler", .fourier = 30}, HL_UNSTABLE}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct hl_field f;
        assert_int_equal(hl_solve(h, row[i].method, &row[i].options, &f, &why), row[i].status);
        assert_has(why.text, row[i].says);
        hl_field_free(&f);
    }
    hl_problem_free(h);
}

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
        cmocka_unit_test(invalid_input_is_named),
        cmocka_unit_test(out_of_memory_is_a_status),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
