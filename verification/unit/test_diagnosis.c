/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Faults planted in a correct code are named, with their size; a correct code has none. */
#include "verification/diagnosis/diagnosis.h"
#include "verification/diagnosis/headline.h"
#include "verification/diagnosis/wording.h"

#include "references/scene.h"
#include "solver/method.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct rung {
    struct field field;
    double *exact;
    struct diagnosis_rung at;
};

static const char CHANGING[] = "rect-manufactured whose source changes";

static const struct scene *scene_of(const char *name) {
    return scene_find(strcmp(name, CHANGING) == 0 ? "rect-manufactured" : name);
}

static struct problem problem_of(const char *name) {
    struct problem p;
    struct failure why;
    const struct scene *s = scene_of(name);
    scene_defaults(s, &p);
    if (strcmp(name, "square-step") == 0) p.param[1] = 0.5, p.param[2] = 0.75, p.param[3] = 0.02; /* a, b, kappa_x */
    if (strcmp(name, "rect-manufactured") == 0) p.param[2] = 0.005, p.param[3] = 0.02;     /* k_x, k_y: G matters */
    if (strcmp(name, CHANGING) == 0) p.param[5] = 0.05, p.param[6] = 8, p.param[7] = 0.25; /* A, rise, t_end */
    if (s->setup(&p, &why)) fail_msg("%s", why.text);
    return p;
}

/* A code that solves *p with a fault of the size `units` (cells, steps, or parts) at dx, by ftcs with F = 0.2. */
static void solve(const char *name, const struct problem *p, struct fault fault, double units, double dx,
                  struct rung *r) {
    struct faulty with;
    struct failure why;
    struct options o = {.dx = dx,
                        .fourier = 0.2,
                        .stepper = STEPPER_EULER,
                        .sampling = p->jumps[0] ? SAMPLING_CELL : SAMPLING_POINT,
                        .mean = MEAN_SERIES,
                        .domain = DOMAIN_WHOLE};
    double kappa = 0, size = units;
    for (int m = 0; m < p->materials; m++)
        for (int a = 0; a < p->dim; a++) kappa = fmax(kappa, p->material[m].k[a] / p->material[m].rho_c);
    double dt = p->t_end / ceil(p->t_end * kappa / (0.2 * dx * dx));
    if (fault.kind == FAULT_CLOCK || fault.kind == FAULT_SOURCE_TIME) size *= dt;
    if (fault.kind == FAULT_EXTENT || fault.kind == FAULT_START_SHIFT || fault.kind == FAULT_START_WIDTH ||
        fault.kind == FAULT_INTERFACE || fault.kind == FAULT_MEAN || fault.kind == FAULT_CORNER ||
        fault.kind == FAULT_NEAR_WALL)
        size *= dx;
    double inside[2] = {p->lo[0] + 0.3 * (p->hi[0] - p->lo[0]), p->lo[1] + 0.4 * (p->hi[1] - p->lo[1])};
    if (fault.kind == FAULT_MEAN) o.mean = MEAN_ARITHMETIC;
    assert_true(fault_make(p, fault, size, &with));
    if (fault.kind == FAULT_SOURCE_TIME)
        assert_near(problem_source(&with.problem, inside, 0.1), problem_source(p, inside, 0.1 + size), 1e-15);
    if (method_solve(method_find("ftcs"), &with.problem, &o, &r->field, &why)) fail_msg("%s: %s", name, why.text);
    r->exact = xcalloc(r->field.n, sizeof *r->exact);
    for (size_t i = 0; i < r->field.n; i++) {
        double x[2] = {r->field.x[i], r->field.y ? r->field.y[i] : 0};
        for (int a = 0; a < p->dim; a++) x[a] = with.centre[a] + with.stretch[a] * (x[a] - with.centre[a]);
        r->field.x[i] = x[0];
        if (r->field.y) r->field.y[i] = x[1];
        struct exact e = scene_exact(scene_of(name), p, x, p->t_end);
        r->exact[i] = e.no_value ? NAN : e.temperature;
    }
    r->at = (struct diagnosis_rung){&r->field, r->exact, dx, dt, NAN};
}

/* A fault of units[0] at dx and units[1] at 2 dx; the program prints steps of `says` times their length (0: none). */
static struct diagnosis find_in(const char *name, struct fault fault, double dx, const double units[2],
                                const double says[2]) {
    struct problem p = problem_of(name);
    struct rung r[2];
    struct diagnosis d;
    for (int k = 0; k < 2; k++) {
        solve(name, &p, fault, units[k], k ? 2 * dx : dx, &r[k]);
        r[k].at.dt *= says[k];
    }
    diagnosis_find(&p, &r[0].at, &r[1].at, &d);
    print_message("%-18s %s\n", name, d.what);
    for (int i = 0; i < 2; i++) field_free(&r[i].field), free(r[i].exact);
    return d;
}

static struct diagnosis find(const char *name, struct fault fault, double units, double dx) {
    return find_in(name, fault, dx, (double[2]){units, units}, (double[2]){1, 1});
}

static void faults_are_named_with_their_size(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        double dx; /* m, of the finer rung */
        struct fault fault;
        double units, size; /* planted, and found: parts in % */
        const char *what;
    } rows[] = {
        {"rod-gauss", 0.15, {FAULT_CLOCK, 0}, -1, -1, "early"},
        {"rod-step", 0.025, {FAULT_CLOCK, 0}, 20, 20, "late"},
        {"rod-step", 0.025, {FAULT_CONDUCTIVITY, 0}, 0.021, 2.1, "conductivity"},
        {"rod-step", 0.025, {FAULT_START_SHIFT, 0}, 0.5, 0.5, "too far up along x"},
        {"rod-step", 0.025, {FAULT_START_WIDTH, 0}, -0.5, -0.5, "further in"},
        {"rod-contact", 0.01, {FAULT_INTERFACE, 0}, 0.5, 0.5, "interface"},
        {"rod-contact", 0.01, {FAULT_CAPACITY, 0}, 1, 100, "rho c"},
        {"rod-contact", 0.01, {FAULT_WALL, 0}, -1, -100, "side x_lo holds were lost"},
        {"square-step", 0.05, {FAULT_SWAP, 0}, 1, 100, "each other"},
        {"rect-manufactured", 0.025, {FAULT_SOURCE, 0}, -1, -100, "source were lost"},
        {"rect-manufactured", 0.025, {FAULT_WALL, 2}, -2, -200, "y_lo holds had the wrong sign"},
        {"rect-manufactured", 0.025, {FAULT_CONDUCTIVITY, 0}, 0.03, 3, "conductivity"},
        {"rect-manufactured", 0.025, {FAULT_CLOCK, 0}, -3, -3, "early"},
        {"plate", 0.0025, {FAULT_EXTENT, 0}, 0.5, 0.5, "sides across x were"},
        {"rod-cosine", 0.025, {FAULT_EXTENT, 0}, 0.5, 0.5, "sides across x were"},
        {"rod-step", 0.025, {FAULT_AMPLITUDE, 0}, 0.013, 1.3, "temperatures"},
        {"plate", 0.0025, {FAULT_EXTENT, FAULT_BOTH_AXES}, 0.5, 0.5, "across x and y were"},
        {"rect-manufactured", 0.025, {FAULT_WALL, FAULT_ALL_SIDES}, -2, -200, "given flux hold had the wrong sign"},
        {"square-step", 0.05, {FAULT_ISOTROPIC, 1}, 1, 100, "k_y were k_x"},
        {"square-step", 0.05, {FAULT_TRANSPOSED, 0}, 1, 100, "x and y were swapped"},
        {"rod-contact", 0.01, {FAULT_MEAN, 0}, 1, 1, "arithmetic mean"},
        {"rect-manufactured", 0.025, {FAULT_CORNER, 0}, 1, 100, "lost at the corner x_lo, y_lo"},
        {"plate", 0.0025, {FAULT_CORNER, 1}, 1, 100, "lost at the corner x_hi, y_lo"},
        {"plate", 0.0025, {FAULT_CORNER, 2}, 1, 100, "lost at the corner x_lo, y_hi"},
        {"plate", 0.0025, {FAULT_CORNER, 3}, 1, 100, "lost at the corner x_hi, y_hi"},
        {CHANGING, 0.0125, {FAULT_SOURCE_TIME, 0}, 1, 1, "source were that of"},
        {CHANGING, 0.0125, {FAULT_CLOCK, 0}, 0.5, 0.5, "late"},
        {"rod-cooling", 0.005, {FAULT_COEFFICIENT, 1}, 0.02, 2, "coefficient of side x_hi were"},
        {"rod-cooling", 0.005, {FAULT_COEFFICIENT, 1}, -0.5, -50, "coefficient of side x_hi were"},
        {"rod-cooling", 0.005, {FAULT_COEFFICIENT, 1}, 2, 200, "coefficient of side x_hi were"},
        {"square-step", 0.05, {FAULT_AXIS, 1}, 0.6, 60, "k_y were"},
        {"rod-contact", 0.01, {FAULT_RHO_C, 1}, 0.5, 50, "rho c of the second material were"},
        {"rect-manufactured", 0.025, {FAULT_SOURCE, 0}, 0.1, 10, "source were"},
        {"rod-step", 0.025, {FAULT_CONDUCTIVITY, 0}, 1.04, 104, "conductivity were 104 %"},
        {"wall-composite", 0.01, {FAULT_EXTENT, 0}, 0.5, 0.5, "sides across x were"},
        {"wall-composite", 0.01, {FAULT_INTERFACE, 0}, -0.5, -0.5, "too far down"},
        {"rod-contact", 0.01, {FAULT_RHO_C, 0}, 0.1, 10, "rho c of the first material were"},
        {"rod-contact", 0.01, {FAULT_DIFFUSIVITY, 0}, 1, 100, "mean of diffusivities"},
        {"wall-composite", 0.01, {FAULT_DIFFUSIVITY, 0}, 1, 100, "mean of diffusivities"},
        {CHANGING, 0.0125, {FAULT_FROZEN, 0}, 1, 100, "source kept its first value"},
        {"rod-cooling", 0.005, {FAULT_NEAR_WALL, 0}, 0.5, 0.5, "half a cell inside"},
        {"plate-cooling", 0.025, {FAULT_NEAR_WALL, 0}, 0.5, 0.5, "half a cell inside"},
        {"rod-step", 0.025, {FAULT_OFFSET, 0}, -0.07, -0.07, "all temperatures are 0.07 K too low"},
        {"plate", 0.0025, {FAULT_OFFSET, 0}, 273.15, 273.15, "degrees Celsius and kelvin"},
    };
    int wrong = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct diagnosis d = find(rows[i].scene, rows[i].fault, rows[i].units, rows[i].dx);
        wrong += !d.named || !strstr(d.what, rows[i].what) || fabs(d.size - rows[i].size) > 0.2 * fabs(rows[i].size);
    }
    assert_int_equal(wrong, 0);
}

/* A jump a third of a cell below a face at dx = 0.05, a third above one at 0.025: values at the points put it there.
 */
static void values_for_means_are_named(void **state) {
    (void)state;
    struct problem p = problem_of("rod-step");
    struct rung r[2];
    struct diagnosis d;
    struct failure why;
    p.param[1] = 8.0 / 15; /* a */
    if (scene_find("rod-step")->setup(&p, &why)) fail_msg("%s", why.text);
    for (int k = 0; k < 2; k++) {
        solve("rod-step", &p, (struct fault){FAULT_SAMPLES, 0}, k ? 0.05 / 3 : -0.025 / 3, k ? 0.05 : 0.025, &r[k]);
    }
    diagnosis_find(&p, &r[0].at, &r[1].at, &d);
    print_message("%s\n", d.what);
    assert_has(d.what, "values at the points");
    for (int i = 0; i < 2; i++) field_free(&r[i].field), free(r[i].exact);
}

static void rounded_temperatures_are_named(void **state) {
    (void)state;
    double T[40];
    struct field f = {.dim = 1, .n = 40, .T = T};
    struct diagnosis d;
    for (int i = 0; i < 40; i++) T[i] = (float)(1.1 + sqrt(i) / 70);
    assert_int_equal(diagnosis_rounding(&f, 1e-6, 40, &d), 1);
    assert_string_equal(d.what, "as if temperatures were rounded to 7 digits");
    assert_int_equal(diagnosis_rounding(&f, 1e-3, 40, &d), 0); /* more than the digits leave */
    for (int i = 0; i < 40; i++) T[i] = nearbyint(1e8 * T[i]) / 1e8;
    assert_int_equal(diagnosis_rounding(&f, 1e-7, 40, &d), 1);
    assert_near(d.size, 9, 0);
    T[17] = 1.1 + sqrt(17) / 70;
    assert_int_equal(diagnosis_rounding(&f, 1e-7, 40, &d), 0); /* one with all its digits */
    for (int i = 0; i < 40; i++) T[i] = 1 + i / 40.0;
    assert_int_equal(diagnosis_rounding(&f, 1e-7, 40, &d), 0); /* round by themselves */
    for (int i = 0; i < 40; i++) T[i] = i % 4 ? nearbyint(1e5 * (1.1 + sqrt(i) / 70)) / 1e5 : i / 8.0;
    assert_int_equal(diagnosis_rounding(&f, 1e-4, 40, &d), 1);
    assert_near(d.size, 6, 0); /* 0 and 0.5 among them need no more */
}

/* Seven digits, none round by chance. */
static void fill_rounded(double *T, int n) {
    for (int i = 0; i < n; i++) T[i] = nearbyint(1e6 * (1.1 + sqrt(i + 2) / 70)) / 1e6;
}

/* Some ten values that are not round by chance; an error up to N^2 times half a unit of the last digit of 1 K. */
static void few_rounded_temperatures_show_nothing(void **state) {
    (void)state;
    double T[10];
    struct field f = {.dim = 1, .n = 10, .T = T};
    struct diagnosis d;
    fill_rounded(T, 10);
    assert_int_equal(diagnosis_rounding(&f, 7.9e-4, 40, &d), 1);
    assert_near(d.size, 7, 0);
    assert_int_equal(diagnosis_rounding(&f, 8.1e-4, 40, &d), 0);
    f.n = 9;
    assert_int_equal(diagnosis_rounding(&f, 1e-4, 40, &d), 0);
}

/* With an offset of the temperatures, values near 0 have the rounding errors of the others. */
static void rounded_temperatures_are_named_in_any_scale(void **state) {
    (void)state;
    double T[20];
    struct field f = {.dim = 1, .n = 20, .T = T};
    struct diagnosis d;
    fill_rounded(T, 20);
    for (int i = 0; i < 10; i++) T[i] -= 1;
    T[0] = 0.001234 + 3e-15;
    assert_int_equal(diagnosis_rounding(&f, 1e-4, 40, &d), 1);
    assert_near(d.size, 7, 0);
    T[0] = 0.001234 + 3e-14;
    assert_int_equal(diagnosis_rounding(&f, 1e-4, 40, &d), 0);
}

static void runs_that_differ_are_named(void **state) {
    (void)state;
    struct diagnosis d;
    assert_int_equal(diagnosis_repeat(1.1e-9, 1, &d), 1);
    assert_has(d.what, "answers differ by 1.1e-09 K from run to run");
    assert_int_equal(diagnosis_repeat(0.9e-9, 1, &d), 0);
    assert_int_equal(diagnosis_repeat(1.1e-9, 2, &d), 0);
}

/* rod-gauss by a code whose numbers differ from values by `mean` dx^2/24 T_xx, with that fault of a clock. */
static void solve_means(struct problem *p, double mean, double steps, double dx, struct rung *r) {
    const struct scene *s = scene_of("rod-gauss");
    const double d = 1e-3;
    solve("rod-gauss", p, (struct fault){FAULT_CLOCK, 0}, steps, dx, r);
    for (size_t i = 0; i < r->field.n; i++) {
        double x = r->field.x[i], T[3];
        for (int j = 0; j < 3; j++) T[j] = scene_exact(s, p, (double[2]){x + (j - 1) * d, 0}, p->t_end).temperature;
        r->field.T[i] += mean * dx * dx / 24 * (T[0] - 2 * T[1] + T[2]) / (d * d);
    }
}

/* An answer at the start identifies means or values, and thus the remainder for a clock, unless the initial data are
 * linear.  Differences over d = dx/8 of a Gaussian are too small by d^2/12 5/(2 sigma^2): 7e-5. */
static void starts_show_means_over_cells(void **state) {
    (void)state;
    static const double means[] = {0, 1, -2, 2}, steps[] = {1, -1, -1, 1};
    struct problem p = problem_of("rod-gauss"), early = p;
    struct failure why;
    early.param[3] = 1e-5; /* t_end */
    if (scene_of("rod-gauss")->setup(&early, &why)) fail_msg("%s", why.text);
    for (int i = 0; i < 4; i++) {
        struct rung r[2], start;
        struct diagnosis found;
        solve_means(&early, means[i], 0, 0.3, &start);
        double mean = diagnosis_mean(&early, &start.at);
        assert_near(mean, means[i], 2e-4);
        for (int k = 0; k < 2; k++) solve_means(&p, means[i], steps[i], k ? 0.3 : 0.15, &r[k]), r[k].at.mean = mean;
        diagnosis_find(&p, &r[0].at, &r[1].at, &found);
        print_message("%g: %s\n", mean, found.what);
        assert_true(found.named && found.fault.kind == FAULT_CLOCK);
        assert_near(found.size, steps[i], 0.02);
        for (size_t k = 0; k < start.field.n; k++) start.field.T[k] += 0.01 * sin(0.3 * (double)k);
        assert_nan(diagnosis_mean(&early, &start.at)); /* something else */
        field_free(&start.field), free(start.exact);
        for (int k = 0; k < 2; k++) field_free(&r[k].field), free(r[k].exact);
    }
    static const char *const neither[] = {"rect-manufactured", "plate"}; /* a source adds values; no laplace(T) */
    for (int i = 0; i < 2; i++) {
        struct problem made = problem_of(neither[i]);
        struct rung start;
        solve(neither[i], &made, (struct fault){FAULT_CLOCK, 0}, 0, i ? 0.005 : 0.05, &start);
        assert_nan(diagnosis_mean(&made, &start.at));
        field_free(&start.field), free(start.exact);
    }
}

/* A wave in the plane with two wavelengths: cell means, with noise of a millionth of their difference; and
 * values. */
static void starts_in_the_plane_have_both_curvatures(void **state) {
    (void)state;
    struct problem p = problem_of("wave");
    enum { SIDE = 20 };
    const double dx = (p.hi[0] - p.lo[0]) / SIDE, d = 1e-3;
    struct field f;
    double exact[SIDE * SIDE];
    field_alloc(&f, 2, SIDE * SIDE);
    for (int mean = 0; mean < 2; mean++) {
        for (int i = 0; i < SIDE * SIDE; i++) {
            double x = p.lo[0] + (i % SIDE + 0.5) * dx, y = p.lo[1] + (i / SIDE + 0.5) * dx, around = 0;
            for (int k = 0; k < 4; k++)
                around += p.initial(&p, (double[2]){x + (k / 2 ? 0 : k ? d : -d), y + (k / 2 ? k == 3 ? d : -d : 0)});
            f.x[i] = x, f.y[i] = y;
            exact[i] = p.initial(&p, (double[2]){x, y});
            f.T[i] = exact[i] + mean * dx * dx / 24 * (around - 4 * exact[i]) / (d * d) + 1e-9 * (i % 7 - 3);
        }
        assert_near(diagnosis_mean(&p, &(struct diagnosis_rung){&f, exact, dx, 0, NAN}), mean, 2e-3);
    }
    struct problem jumps[2] = {p, p}, contact = p; /* cases in which means are not identifiable */
    for (int a = 0; a < 2; a++) {
        jumps[a].jumps[a] = 1;
        assert_nan(diagnosis_mean(&jumps[a], &(struct diagnosis_rung){&f, exact, dx, 0, NAN}));
    }
    contact.materials = 2;
    assert_nan(diagnosis_mean(&contact, &(struct diagnosis_rung){&f, exact, dx, 0, NAN}));
    field_free(&f);
}

/* Sizes follow the spacing in steps, in dx^2/kappa or in seconds; a size that follows none is no fault. */
static void sizes_follow_the_spacing(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        double dx;
        struct fault fault;
        double units[2], says[2]; /* at dx and 2 dx */
        const char *what;         /* "no ..." where none is named */
    } rows[] = {
        {"rod-cosine", 0.025, {FAULT_CONDUCTIVITY, 0}, {0.02, 0.02}, {0, 0}, "as if the conductivity were"},
        {"rod-cooling", 0.01, {FAULT_CLOCK, 0}, {13, 3.25}, {1, 0}, " s late"},
        {"rod-gauss",
         0.15,
         {FAULT_CLOCK, 0},
         {-1, -1},
         {0, 0},
         "dx^2/kappa early: one step, if steps are of that length"},
        {"rod-gauss", 0.15, {FAULT_CLOCK, 0}, {0, 1}, {1, 1}, "runs at some spacings had stopped one step late"},
        {"rod-gauss", 0.15, {FAULT_CLOCK, 0}, {-1, 0}, {1, 1}, "runs at some spacings had stopped one step early"},
        {"rod-step", 0.025, {FAULT_AMPLITUDE, 0}, {0.02, 0.024}, {1, 1}, "all temperatures were"},
        {"rod-step",
         0.025,
         {FAULT_AMPLITUDE, 0},
         {0.02, 0.03},
         {1, 1},
         "no usual fault: what looks like one has a size that "
         "changes with the spacing"},
        {"rod-gauss",
         0.15,
         {FAULT_CLOCK, 0},
         {4, 2},
         {0, 0},
         "no usual fault: what looks like one has a size that changes with "
         "the spacing; `# steps = N` in the answer would show"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct diagnosis d = find_in(rows[i].scene, rows[i].fault, rows[i].dx, rows[i].units, rows[i].says);
        assert_has(d.what, rows[i].what);
        assert_int_equal(d.named, strncmp(rows[i].what, "no ", 3) != 0);
    }
}

/* Effects at a contact are as 1/mean - 1/harmonic: of k = 0.01 and 0.001 that of the geometric mean is 63 % of that
 * of the arithmetic one. */
static void means_of_conductivities_are_distinguished(void **state) {
    (void)state;
    static const double found[] = {1, 0.63, 0.45};
    static const char *const said[] = {"the arithmetic mean", "the geometric mean", "another mean"};
    struct problem p = problem_of("rod-contact");
    for (int i = 0; i < 3; i++) {
        struct rung r[2];
        struct diagnosis d;
        for (int k = 0; k < 2; k++) {
            struct rung wrong;
            double dx = k ? 0.02 : 0.01;
            solve("rod-contact", &p, (struct fault){FAULT_AMPLITUDE, 0}, 0, dx, &r[k]);
            solve("rod-contact", &p, (struct fault){FAULT_MEAN, 0}, 1, dx, &wrong);
            for (size_t j = 0; j < r[k].field.n; j++)
                r[k].field.T[j] += found[i] * (wrong.field.T[j] - r[k].field.T[j]);
            field_free(&wrong.field), free(wrong.exact);
        }
        diagnosis_find(&p, &r[0].at, &r[1].at, &d);
        print_message("%s\n", d.what);
        assert_has(d.what, said[i]);
        for (int k = 0; k < 2; k++) field_free(&r[k].field), free(r[k].exact);
    }
}

static void unstable_runs_are_named(void **state) {
    (void)state;
    struct problem p = problem_of("rod-step");
    struct rung r;
    struct diagnosis d;
    solve("rod-step", &p, (struct fault){FAULT_AMPLITUDE, 0}, 0, 0.05, &r);
    assert_int_equal(diagnosis_unstable(&r.at, &d), 0);
    for (size_t i = 0; i < r.field.n; i++) r.field.T[i] = i % 2 ? 1e9 : -1e9;
    assert_int_equal(diagnosis_unstable(&r.at, &d), 1);
    assert_has(d.what, "the run is unstable, up to 1e+09 K");
    for (size_t i = 0; i < r.field.n; i++) r.field.T[i] = 1e9;
    assert_int_equal(diagnosis_unstable(&r.at, &d), 0); /* another scale, without a sawtooth */
    field_free(&r.field), free(r.exact);
}

/* 2 % more conductivity on a Gaussian of kappa t/sigma0^2 = c: T = (1 + 2 c)^-1/2 exp(-x^2/(2 sigma^2)) loses at x
 * the share 0.02 c (1 - x^2/sigma^2)/(1 + 2 c), and the mean of |1 - u^2| over a Gaussian is 4/sqrt(2 pi e). */
static void effect_of_a_fault_is_its_relative_error(void **state) {
    (void)state;
    struct problem p = problem_of("rod-gauss");
    struct diagnosis d = {.named = 1, .fault = {FAULT_CONDUCTIVITY, 0}, .size = 2, .unit = "%"};
    double c = p.material[0].k[0] * p.t_end / (p.material[0].rho_c * p.param[1] * p.param[1]);
    double want = 0.02 * c / (1 + 2 * c) * 4 / sqrt(2 * M_PI * exp(1));
    assert_near(diagnosis_effect(&p, &d, 0.1, 0), want, 0.03 * want);
    d.fault.kind = FAULT_OFFSET, d.unit = "K", d.size = 0.5;
    assert_near(diagnosis_effect(&p, &d, 0.1, -1) / diagnosis_effect(&p, &d, 0.1, -3), 3.0, 0.4);
    d.fault.kind = FAULT_SOURCE;
    assert_nan(diagnosis_effect(&p, &d, 0.1, 0));
    d.fault.kind = FAULT_NOISE;
    assert_nan(diagnosis_effect(&p, &d, 0.1, 0));
}

/* ---- Words ---- */

static void faults_have_sentences(void **state) {
    (void)state;
    static const struct {
        struct fault fault;
        double size;
        const char *unit, *says;
    } rows[] = {
        {{FAULT_CLOCK, 0}, -0.98765, "steps", "as if the run had stopped 0.988 steps early"},
        {{FAULT_CLOCK, 0}, 2, "s", "as if the run had stopped 2 s late"},
        {{FAULT_CLOCK, 0},
         0.25,
         "dx^2/kappa",
         "as if the run had stopped 0.25 dx^2/kappa late: one step, if steps are of that length"},
        {{FAULT_CONDUCTIVITY, 0}, -12.5, "%", "as if the conductivity were 12.5 % too small"},
        {{FAULT_ISOTROPIC, 0}, 100, "", "as if k_x were k_y"},
        {{FAULT_ISOTROPIC, 1}, 100, "", "as if k_y were k_x"},
        {{FAULT_AXIS, 1}, 3, "%", "as if k_y were 3 % too large"},
        {{FAULT_RHO_C, 0}, 3, "%", "as if rho c of the first material were 3 % too large"},
        {{FAULT_RHO_C, 1}, -3, "%", "as if rho c of the second material were 3 % too small"},
        {{FAULT_COEFFICIENT, 2}, 5, "%", "as if the heat transfer coefficient of side y_lo were 5 % too large"},
        {{FAULT_COEFFICIENT, FAULT_ALL_SIDES}, 5, "%", "as if the heat transfer coefficients were 5 % too large"},
        {{FAULT_SOURCE, 0}, 7, "%", "as if the source were 7 % too large"},
        {{FAULT_SOURCE, 0}, 400, "%", "as if the source were 400 % too large"},
        {{FAULT_SOURCE, 0}, -95.1, "%", "as if the source were lost"},
        {{FAULT_SOURCE, 0}, -191, "%", "as if the source had the wrong sign"},
        {{FAULT_SOURCE_TIME, 0}, -1, "steps", "as if the source were that of 1 step earlier"},
        {{FAULT_SOURCE_TIME, 0},
         -0.52,
         "steps",
         "as if the source were that of 0.52 steps earlier: of the step's start, not its middle"},
        {{FAULT_WALL, 3}, -94.9, "%", "as if what side y_hi holds were 94.9 % too small"},
        {{FAULT_WALL, 3}, -104.9, "%", "as if what side y_hi holds were lost"},
        {{FAULT_WALL, 0}, -190.5, "%", "as if what side x_lo holds had the wrong sign"},
        {{FAULT_WALL, 0}, -189, "%", "as if what side x_lo holds were 189 % too small"},
        {{FAULT_WALL, 1}, 299, "%", "as if what side x_hi holds were 299 % too large"},
        {{FAULT_WALL, 1}, 301, "%", "as if what side x_hi holds were another value"},
        {{FAULT_WALL, FAULT_ALL_SIDES}, 5, "%", "as if what sides of given flux hold were 5 % too large"},
        {{FAULT_CORNER, 1}, 100, "%", "as if 100 % of what sides hold were lost at the corner x_hi, y_lo"},
        {{FAULT_EXTENT, 1}, -0.5, "cells", "as if the sides across y were 0.5 cells further in"},
        {{FAULT_EXTENT, FAULT_BOTH_AXES}, 0.5, "cells", "as if the sides across x and y were 0.5 cells further out"},
        {{FAULT_START_SHIFT, 1}, -0.5, "cells", "as if the initial data were 0.5 cells too far down along y"},
        {{FAULT_START_WIDTH, 0}, 1, "cells", "as if the jumps of the initial data were 1 cells further out along x"},
        {{FAULT_INTERFACE, 0}, -0.5, "cells", "as if the interface were 0.5 cells too far down"},
        {{FAULT_AMPLITUDE, 0}, 0.5, "%", "as if all temperatures were 0.5 % too large"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct diagnosis d = {.named = 1, .fault = rows[i].fault, .size = rows[i].size, .unit = rows[i].unit};
        wording_fault(&d);
        assert_string_equal(d.what, rows[i].says);
    }
}

static void sentences_end_with_the_share(void **state) {
    (void)state;
    char text[300];
    struct diagnosis d = {.named = 1, .share = 0.954, .what = "as if late"};
    wording_text(&d, text, sizeof text);
    assert_string_equal(text, "as if late (95 % of the error)");
    d.share = NAN;
    wording_text(&d, text, sizeof text);
    assert_string_equal(text, "as if late");
    d.share = 0.5, d.named = 0;
    wording_text(&d, text, sizeof text);
    assert_string_equal(text, "as if late");
}

/* ---- Headlines ---- */

static const struct diagnosis none = {.unit = NULL};

static struct diagnosis of(enum fault_kind kind, int axis, double size, const char *unit) {
    return (struct diagnosis){.named = 1, .fault = {kind, axis}, .size = size, .unit = unit, .share = 0.95};
}

static void headline_is(const struct diagnosis *found, int failing, const char *wanted) {
    char text[HEADLINE_TEXT];
    struct headline h = headline_choose(found, failing);
    headline_print(&h, text);
    assert_string_equal(text, wanted);
}

static void headlines_need_half_of_the_rows_and_sizes_that_agree(void **state) {
    (void)state;
    const struct diagnosis k1 = of(FAULT_CONDUCTIVITY, 0, 1.06, "%"), k2 = of(FAULT_CONDUCTIVITY, 0, 0.9, "%"),
                           tiny = of(FAULT_CONDUCTIVITY, 0, 0.00111, "%"),
                           huge = of(FAULT_CONDUCTIVITY, 0, 1590, "%"), more = of(FAULT_CONDUCTIVITY, 0, 4120, "%"),
                           late = of(FAULT_CLOCK, 0, 1, "steps"), s = of(FAULT_CLOCK, 0, 1, "s"),
                           yx = of(FAULT_ISOTROPIC, 1, 100, ""), xy = of(FAULT_ISOTROPIC, 0, 100, "");
    headline_is((const struct diagnosis[]){k1, k2}, 2,
                "as if the conductivity were 0.9 % too large (2 of 2 rows that do not pass)");
    headline_is((const struct diagnosis[]){none, k1, late, k2}, 4,
                "as if the conductivity were 0.9 % too large (2 of 4 rows that do not pass)");
    headline_is((const struct diagnosis[]){none, k1, late, k2, none}, 5,
                "perhaps as if the conductivity were 0.9 % too large (2 of 5 rows that do not pass)");
    headline_is((const struct diagnosis[]){k1, tiny}, 2, "");
    headline_is((const struct diagnosis[]){huge, more, k1}, 3, "");
    headline_is((const struct diagnosis[]){late, s}, 2, "");
    headline_is((const struct diagnosis[]){late}, 1,
                "perhaps as if the run had stopped 1 step late (1 of 1 rows that do not pass)");
    headline_is((const struct diagnosis[]){yx, xy, yx}, 3, "as if k_y were k_x (2 of 3 rows that do not pass)");
    headline_is(&none, 1, "");
    headline_is(&none, 0, "");
}

/* A draw mirrors rods and turns planes: sides that differ are one fault; noise has a size in each field. */
static void headlines_join_sides(void **state) {
    (void)state;
    const struct diagnosis lo = of(FAULT_COEFFICIENT, 0, -49.9, "%"), all = of(FAULT_COEFFICIENT, 4, -50.1, "%"),
                           hi = of(FAULT_COEFFICIENT, 1, -50, "%"), x = of(FAULT_EXTENT, 0, 0.49, "cells"),
                           both = of(FAULT_EXTENT, 2, 0.5, "cells"), noisy = of(FAULT_NOISE, 0, 0.2, "K"),
                           less = of(FAULT_NOISE, 0, 0.01, "K"), arithmetic = of(FAULT_MEAN, 0, 1, "cells"),
                           other = of(FAULT_MEAN, 3, 0.6, "cells");
    headline_is((const struct diagnosis[]){lo, all, hi}, 3,
                "as if the heat transfer coefficients were 50 % too small (3 of 3 rows that do not pass)");
    headline_is(
        (const struct diagnosis[]){hi, hi}, 2,
        "as if the heat transfer coefficient of side x_hi were 50 % too small (2 of 2 rows that do not pass)");
    headline_is((const struct diagnosis[]){x, x}, 2,
                "as if the sides across x were 0.49 cells further out (2 of 2 rows that do not pass)");
    headline_is((const struct diagnosis[]){x, both}, 2,
                "as if the sides were 0.49 cells further out (2 of 2 rows that do not pass)");
    headline_is(
        (const struct diagnosis[]){noisy, less}, 2,
        "answers differ by 0.01 K from run to run: random numbers, threads or an unset variable (2 of 2 rows that "
        "do not pass)");
    headline_is((const struct diagnosis[]){arithmetic, other, arithmetic}, 3,
                "as if another mean of two conductivities stood for the harmonic one (3 of 3 rows that do not pass)");
}

/* A row that passes refutes a fault that alone would leave twice its ceiling, if the row has walls of that kind. */
static void rows_that_pass_refute_a_headline(void **state) {
    (void)state;
    struct problem p = problem_of("rod-cosine"); /* insulated */
    struct diagnosis found[2] = {of(FAULT_CONDUCTIVITY, 0, 5, "%"), of(FAULT_CONDUCTIVITY, 0, 5, "%")};
    struct headline h = headline_choose(found, 2);
    double effect = diagnosis_effect(&p, &h.fault, 0.05, 0);
    assert_int_equal(headline_contradicts(&h, &p, 0.05, 0, 0.49 * effect), 1);
    assert_int_equal(headline_contradicts(&h, &p, 0.05, 0, 0.51 * effect), 0);
    for (int k = 0; k < 2; k++) {
        found[0] = of(FAULT_EXTENT, 0, 0.5, "cells");
        found[0].sides = k ? 1u << DIRICHLET : 1u << NEUMANN;
        h = headline_choose(found, 1);
        assert_int_equal(headline_contradicts(&h, &p, 0.05, 0, 1e-6), k == 0);
    }
}

/* Off by 1 % of their largest, up and down from point to point: of this nothing but noise is to be seen. */
static void noise_is_no_fault(void **state) {
    (void)state;
    struct problem p = problem_of("rod-step");
    struct rung r[2];
    struct diagnosis d;
    int percent = -1;
    for (int k = 0; k < 2; k++) {
        solve("rod-step", &p, (struct fault){FAULT_AMPLITUDE, 0}, 0.01, k ? 0.05 : 0.025, &r[k]);
        for (size_t i = 0; i < r[k].field.n; i++) r[k].field.T[i] += i % 2 ? 0.03 : -0.03;
    }
    diagnosis_find(&p, &r[0].at, &r[1].at, &d);
    assert_int_equal(d.named, 0);
    print_message("%s\n", d.what);
    assert_int_equal(sscanf(d.what, "no usual fault explains more than %d %% of the error", &percent), 1);
    double sum[2] = {0, 0.03 * 0.03 * (double)r[0].field.n};
    for (size_t i = 0; i < r[0].field.n; i++) sum[0] += 1e-4 * r[0].exact[i] * r[0].exact[i];
    assert_near(percent, 100 * sum[0] / (sum[0] + sum[1]), 5);
    for (int i = 0; i < 2; i++) field_free(&r[i].field), free(r[i].exact);
}

/* Points behind the array in memory are not read; of many points a sample is used. */
static void large_answers_are_sampled(void **state) {
    (void)state;
    enum { MANY = 41000 };
    struct problem p = problem_of("rod-step");
    struct rung r[2];
    struct diagnosis d;
    double *x = xcalloc(MANY, sizeof *x), *T = xcalloc(MANY, sizeof *T), *exact = xcalloc(MANY, sizeof *exact);
    double *weight = xcalloc(MANY, sizeof *weight);
    solve("rod-step", &p, (struct fault){FAULT_AMPLITUDE, 0}, 0.013, 0.05, &r[1]);
    r[0] = r[1];
    for (int k = 0; k < 2; k++) {
        size_t n = k ? 40999 : 400; /* every third is sampled */
        for (size_t i = 0; i < MANY; i++) {
            x[i] = p.lo[0] + (p.hi[0] - p.lo[0]) * ((double)i + 0.5) / (double)n;
            int wrong = i >= n || (k && i % 3);
            exact[i] = i < n ? scene_exact(scene_of("rod-step"), &p, (double[2]){x[i], 0}, p.t_end).temperature : 3;
            T[i] = wrong ? 100 : 1.013 * exact[i];
            weight[i] = 1;
        }
        struct field many = {.dim = 1, .n = n, .x = x, .T = T, .weight = weight};
        struct diagnosis_rung fine = {&many, exact, 0.025, r[1].at.dt, NAN};
        diagnosis_find(&p, &fine, &r[1].at, &d);
        print_message("%s\n", d.what);
        assert_has(d.what, "all temperatures were 1.3 % too large");
        assert_order(d.share, >, 0.9999);
    }
    free(x), free(T), free(exact), free(weight);
    field_free(&r[1].field), free(r[1].exact);
}

static void impossible_sizes_are_refused(void **state) {
    (void)state;
    struct problem p = problem_of("rod-step");
    static const enum fault_kind bends[] = {FAULT_CONDUCTIVITY, FAULT_AXIS, FAULT_RHO_C, FAULT_COEFFICIENT};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(fault_can_be(&p, bends[i], -0.99), 1);
        assert_int_equal(fault_can_be(&p, bends[i], -1.21), 0);
        assert_int_equal(fault_can_be(&p, bends[i], 4.93), 1);
    }
    assert_int_equal(fault_can_be(&p, FAULT_WALL, -1), 1);    /* lost */
    assert_int_equal(fault_can_be(&p, FAULT_WALL, -2), 1);    /* wrong sign */
    assert_int_equal(fault_can_be(&p, FAULT_WALL, -5.71), 0); /* 571 % too small */
    assert_int_equal(fault_can_be(&p, FAULT_SOURCE, -1.89), 0);
    assert_int_equal(fault_can_be(&p, FAULT_CLOCK, -0.9 * p.t_end), 1);
    assert_int_equal(fault_can_be(&p, FAULT_CLOCK, -1.1 * p.t_end), 0);
    assert_int_equal(fault_can_be(&p, FAULT_AMPLITUDE, -1.2), 0);
    assert_int_equal(fault_can_be(&p, FAULT_EXTENT, -0.1), 1);
}

static void correct_codes_have_no_fault(void **state) {
    (void)state;
    static const char *const names[] = {"rod-gauss",   "rod-step", "rod-cosine",       "rod-contact",
                                        "square-step", "plate",    "rect-manufactured"};
    static const double fine[] = {0.15, 0.025, 0.025, 0.01, 0.05, 0.0025, 0.025};
    int named = 0;
    for (int i = 0; i < 7; i++) {
        named += find(names[i], (struct fault){FAULT_AMPLITUDE, 0}, 0, fine[i]).named;
    }
    assert_int_equal(named, 0);
}

/* Probes along y have the extent of y; the walls across y, and no others, keep k dT/dn = b (value - T) in a
 * stretched body. */
static void faults_along_y_have_the_extent_of_y(void **state) {
    (void)state;
    struct problem p = problem_of("plate-cooling"), rod = problem_of("rod-step");
    struct faulty with;
    struct fault along_y = {.kind = FAULT_EXTENT, .axis = 1};
    assert_near(fault_probe(&p, along_y), (p.hi[1] - p.lo[1]) / 200, 1e-15);
    assert_true(fault_make(&p, along_y, 0.05, &with));
    double s = 1 + 2 * 0.05 / (p.hi[1] - p.lo[1]);
    for (int side = X_LO; side <= X_HI; side++) assert_near(with.problem.robin[side], p.robin[side], 0);
    for (int side = Y_LO; side <= Y_HI; side++) assert_near(with.problem.robin[side], p.robin[side] / s, 1e-12);
    struct problem cooled = p;
    cooled.robin[Y_LO] = 3;
    assert_true(fault_make(&cooled, (struct fault){.kind = FAULT_EXTENT, .axis = 0}, 0.05, &with));
    assert_near(with.problem.robin[Y_LO], 3, 0);
    struct fault all = {FAULT_COEFFICIENT, FAULT_ALL_SIDES};
    assert_true(fault_make(&p, all, 0.1, &with));
    for (int side = 0; side < 4; side++) assert_near(with.problem.robin[side], 1.1 * p.robin[side], 1e-12);
    struct fault swap = {.kind = FAULT_SWAP}, isotropic = {.kind = FAULT_ISOTROPIC};
    assert_false(fault_make(&rod, swap, 1, &with)); /* a rod has one conductivity, and so has the plate */
    assert_false(fault_make(&p, swap, 1, &with));
    assert_false(fault_make(&p, isotropic, 1, &with));
}

/* Probes across both axes have the extent of x; probes of all sides a fraction of it. */
static void faults_of_both_axes_have_one_probe(void **state) {
    (void)state;
    struct problem p = problem_of("rect-manufactured");
    assert_near(fault_probe(&p, (struct fault){FAULT_EXTENT, FAULT_BOTH_AXES}), (p.hi[0] - p.lo[0]) / 200, 1e-15);
    assert_near(fault_probe(&p, (struct fault){FAULT_COEFFICIENT, FAULT_ALL_SIDES}), 0.01, 0);
}

/* The plate's sides are of four temperatures: a transposed code has each beside the other axis, and one that loses a
 * corner loses 2 k T/dx^2 of the two sides that meet there. */
static void sides_and_corners_have_faults_of_their_own(void **state) {
    (void)state;
    struct problem p = problem_of("plate");
    const double dx = 0.01, side = p.hi[0], k = p.material[0].k[0], along[2] = {0.3 * side, 0.8 * side};
    struct faulty with;
    double T[4];
    for (int s = 0; s < 4; s++) T[s] = p.wall(&p, (enum side)s, along);
    assert_true(fault_make(&p, (struct fault){FAULT_TRANSPOSED, 0}, 1, &with));
    for (int s = 0; s < 4; s++)
        assert_near(with.problem.wall(&with.problem, (enum side)s, along), T[s ^ 2], 1e-15 * fabs(T[s ^ 2]));
    for (int corner = 0; corner < 4; corner++) {
        int right = corner & 1, upper = corner >> 1;
        double x[2] = {right ? side - dx / 2 : dx / 2, upper ? side - dx / 2 : dx / 2};
        double lost = 2 * k * (T[X_LO + right] + T[Y_LO + upper]) / (dx * dx);
        assert_true(fault_make(&p, (struct fault){FAULT_CORNER, corner}, dx, &with));
        assert_near(problem_source(&with.problem, x, 0), -lost, 1e-12 * lost);
    }
}

/* A rod has no y, a body of one material no second, an oblong cannot be transposed, and what is not there is not
 * wrong. */
static void bodies_have_the_faults_of_their_parts(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        struct fault fault;
        int can;
    } rows[] = {
        {"square-step", {FAULT_TRANSPOSED, 0}, 1},
        {"rect-manufactured", {FAULT_TRANSPOSED, 0}, 0},
        {"rod-step", {FAULT_TRANSPOSED, 0}, 0},
        {"rect-manufactured", {FAULT_SWAP, 0}, 1},
        {"rect-manufactured", {FAULT_ISOTROPIC, 1}, 1},
        {"rod-step", {FAULT_ISOTROPIC, 0}, 0},
        {"rect-manufactured", {FAULT_SOURCE, 0}, 1},
        {"rect-manufactured", {FAULT_SOURCE_TIME, 0}, 0},
        {CHANGING, {FAULT_SOURCE_TIME, 0}, 1},
        {"square-step", {FAULT_SOURCE, 0}, 0},
        {"rod-contact", {FAULT_CAPACITY, 0}, 1},
        {"rod-step", {FAULT_CAPACITY, 0}, 0},
        {"rod-contact", {FAULT_RHO_C, 1}, 1},
        {"rod-contact", {FAULT_RHO_C, 2}, 0},
        {"rod-step", {FAULT_RHO_C, 0}, 0},
        {"rod-contact", {FAULT_AXIS, 0}, 0},
        {"plate", {FAULT_AXIS, 1}, 1},
        {"plate", {FAULT_AXIS, 2}, 0},
        {"rod-contact", {FAULT_INTERFACE, 0}, 1},
        {"rod-contact", {FAULT_MEAN, 0}, 1},
        {"rod-step", {FAULT_INTERFACE, 0}, 0},
        {"rod-step", {FAULT_MEAN, 0}, 0},
        {"rod-cooling", {FAULT_COEFFICIENT, X_HI}, 1},
        {"rod-cooling", {FAULT_COEFFICIENT, X_LO}, 0},
        {"rod-cooling", {FAULT_COEFFICIENT, Y_LO}, 0},
        {"rod-cooling", {FAULT_COEFFICIENT, FAULT_ALL_SIDES}, 0},
        {"plate-cooling", {FAULT_COEFFICIENT, FAULT_ALL_SIDES}, 1},
        {"rect-manufactured", {FAULT_WALL, Y_HI}, 1},
        {"rect-manufactured", {FAULT_WALL, FAULT_ALL_SIDES}, 1},
        {"plate", {FAULT_WALL, FAULT_ALL_SIDES}, 0},
        {"rod-cosine", {FAULT_WALL, X_LO}, 0},
        {"rod-contact", {FAULT_WALL, X_HI}, 0}, /* all at 0 K */
        {"rod-contact", {FAULT_WALL, Y_LO}, 0},
        {"rod-step", {FAULT_START_WIDTH, 0}, 1},
        {"rod-step", {FAULT_START_WIDTH, 1}, 0},
        {"rod-contact", {FAULT_START_WIDTH, 0}, 0}, /* one jump */
        {"square-step", {FAULT_SAMPLES, 1}, 1},
        {"rod-gauss", {FAULT_SAMPLES, 0}, 0},
        {"rod-gauss", {FAULT_START_SHIFT, 0}, 1},
        {"rod-gauss", {FAULT_START_SHIFT, 1}, 0},
        {"square-step", {FAULT_START_SHIFT, 1}, 1},
        {"rod-gauss", {FAULT_EXTENT, 1}, 0},
        {"rod-gauss", {FAULT_EXTENT, FAULT_BOTH_AXES}, 0},
        {"plate", {FAULT_EXTENT, FAULT_BOTH_AXES}, 1},
        {"plate", {FAULT_EXTENT, 3}, 0},
        {"plate", {FAULT_CORNER, 2}, 1},
        {"square-step", {FAULT_CORNER, 0}, 0}, /* held at 0 */
        {"rod-contact", {FAULT_CORNER, 0}, 0},
        {"plate", {FAULT_CLOCK, 1}, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct problem p = problem_of(rows[i].scene);
        struct faulty with;
        if (fault_make(&p, rows[i].fault, 0.01, &with) != rows[i].can)
            fail_msg("%s: fault %d of %d", rows[i].scene, rows[i].fault.kind, rows[i].fault.axis);
    }
}

/* The influx across y is that of the higher body; Dirichlet values at x depend on the position along y. */
static void stretched_bodies_keep_walls_and_sources(void **state) {
    (void)state;
    struct problem p = problem_of("rect-manufactured");
    struct faulty with;
    const double size = 0.03, s = 1 + 2 * size / (p.hi[1] - p.lo[1]), middle = (p.lo[1] + p.hi[1]) / 2;
    assert_true(fault_make(&p, (struct fault){FAULT_EXTENT, 1}, size, &with));
    for (int k = 0; k < 4; k++) {
        double x[2] = {p.hi[0] * (0.1 + 0.23 * k), p.hi[1] * (0.2 + 0.19 * k)};
        double right[2] = {x[0], middle + s * (x[1] - middle)};
        enum side side = (enum side)k;
        double held = p.wall(&p, side, right);
        assert_near(with.problem.wall(&with.problem, side, x), side < Y_LO ? held : held / s, 1e-14);
        assert_near(with.problem.initial(&with.problem, x), p.initial(&p, right), 1e-14);
        assert_near(problem_source(&with.problem, x, 0), problem_source(&p, right, 0), 1e-14);
    }
    assert_near(with.problem.material[0].k[0], p.material[0].k[0], 0);
    assert_near(with.problem.material[0].k[1], p.material[0].k[1] / (s * s), 1e-15);
}

/* The start of square-step, hot for |y| <= b = 0.75 m: each jump further out, or both further up. */
static void starts_move_along_y(void **state) {
    (void)state;
    struct problem p = problem_of("square-step");
    const enum fault_kind kinds[] = {FAULT_START_WIDTH, FAULT_START_SHIFT};
    const double b = p.jump[1][1], size = 0.05;
    assert_near(b, 0.75, 0);
    for (int k = 0; k < 2; k++) {
        struct faulty with;
        assert_true(fault_make(&p, (struct fault){kinds[k], 1}, size, &with));
        const struct problem *q = &with.problem;
        double low = k ? -b + size : -b - size;
        assert_near(q->jump[1][0], low, 1e-15);
        assert_near(q->jump[1][1], b + size, 1e-15);
        for (int i = 0; i < 2; i++) assert_near(q->jump[0][i], p.jump[0][i], 0);
        double hot = p.initial(&p, (double[2]){0.1, 0.1});
        assert_near(q->initial(q, (double[2]){0.1, b + 0.9 * size}), hot, 0);
        assert_near(q->initial(q, (double[2]){0.1, b + 1.1 * size}), 0, 0);
        assert_near(q->initial(q, (double[2]){0.1, low + 0.1 * size}), hot, 0);
        assert_near(q->initial(q, (double[2]){0.1, low - 0.1 * size}), 0, 0);
        assert_near(q->initial(q, (double[2]){p.jump[0][1] + 0.1 * size, 0.1}), 0, 0);
    }
}

static double warm_middle(const struct problem *p, enum side s, const double x[2]) {
    double along = (x[1 - s / 2] - p->lo[1 - s / 2]) / (p->hi[1 - s / 2] - p->lo[1 - s / 2]);
    return along > 0.4 && along < 0.6;
}

/* A side that is warm in its middle alone, at the coordinate along it. */
static void sides_may_be_warm_in_part(void **state) {
    (void)state;
    struct problem p = problem_of("plate");
    struct faulty with;
    p.wall = warm_middle;
    p.lo[0] += 10, p.hi[0] += 10;
    for (int s = 0; s < 4; s++) {
        p.side[s] = NEUMANN;
        assert_true(fault_make(&p, (struct fault){FAULT_WALL, s}, 0.01, &with));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_are_named_with_their_size),
        cmocka_unit_test(values_for_means_are_named),
        cmocka_unit_test(rounded_temperatures_are_named),
        cmocka_unit_test(few_rounded_temperatures_show_nothing),
        cmocka_unit_test(rounded_temperatures_are_named_in_any_scale),
        cmocka_unit_test(runs_that_differ_are_named),
        cmocka_unit_test(starts_show_means_over_cells),
        cmocka_unit_test(starts_in_the_plane_have_both_curvatures),
        cmocka_unit_test(sizes_follow_the_spacing),
        cmocka_unit_test(means_of_conductivities_are_distinguished),
        cmocka_unit_test(unstable_runs_are_named),
        cmocka_unit_test(effect_of_a_fault_is_its_relative_error),
        cmocka_unit_test(faults_have_sentences),
        cmocka_unit_test(sentences_end_with_the_share),
        cmocka_unit_test(headlines_need_half_of_the_rows_and_sizes_that_agree),
        cmocka_unit_test(headlines_join_sides),
        cmocka_unit_test(rows_that_pass_refute_a_headline),
        cmocka_unit_test(noise_is_no_fault),
        cmocka_unit_test(large_answers_are_sampled),
        cmocka_unit_test(impossible_sizes_are_refused),
        cmocka_unit_test(correct_codes_have_no_fault),
        cmocka_unit_test(faults_along_y_have_the_extent_of_y),
        cmocka_unit_test(faults_of_both_axes_have_one_probe),
        cmocka_unit_test(sides_and_corners_have_faults_of_their_own),
        cmocka_unit_test(bodies_have_the_faults_of_their_parts),
        cmocka_unit_test(stretched_bodies_keep_walls_and_sources),
        cmocka_unit_test(starts_move_along_y),
        cmocka_unit_test(sides_may_be_warm_in_part),
    };
    return cmocka_run_group_tests_name("diagnosis", tests, NULL, NULL);
}
