/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Faults planted in a correct code are named, with their size; a correct code has none. */
#include "verification/fault/diagnosis.h"
#include "verification/fault/fit.h"
#include "verification/fault/headline.h"

#include "verification/unit/diagnosed_problems.h"
#include "verification/unit/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* In the plane walls that are cooled or change take seconds: their faults show earlier than at the end time. */
static struct problem early_problem_of(const char *name) {
    struct problem p = problem_of(name);
    struct failure why;
    if (strcmp(name, "plate-cooling") == 0) p.param[8] = 1500; /* t_end, was 6000 s */
    if (strcmp(name, "plate-driven") == 0) p.param[13] = 4;    /* t_end, was 8 s */
    if (scene_of(name)->setup(&p, &why)) fail_msg("%s", why.text);
    return p;
}

/* A fault of units[0] at dx and units[1] at 2 dx; the program prints steps of `says` times their length (0: none). */
static struct diagnosis find_in(const char *name, struct fault fault, double dx, const double units[2],
                                const double says[2]) {
    struct problem p = early_problem_of(name);
    struct rung r[2];
    struct diagnosis d;
    for (int k = 0; k < 2; k++) {
        solve(name, &p, fault, units[k], k ? 2 * dx : dx, &r[k]);
        r[k].at.dt *= says[k];
    }
    diagnosis_find(&p, &r[0].at, &r[1].at, &d);
    print_message("%-18s %s\n", name, d.what);
    for (int i = 0; i < 2; i++) forget(&r[i]);
    free(d.evidence);
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
        {"rod-step", 0.025, {FAULT_CONDUCTIVITY, 0}, 0.021, 2.1, "k/rho c"},
        {"rod-step", 0.025, {FAULT_START_SHIFT, 0}, 0.5, 0.5, "too far up along x"},
        {"rod-step", 0.025, {FAULT_START_WIDTH, 0}, -0.5, -0.5, "further in"},
        {"rod-contact", 0.01, {FAULT_INTERFACE, 0}, 0.5, 0.5, "interface"},
        {"rod-contact", 0.01, {FAULT_CAPACITY, 0}, 1, 100, "rho c"},
        {"rect-manufactured", 0.025, {FAULT_CAPACITY_LOST, 0}, 1, 100, "lost: taken for 1"},
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
        {"rod-cooling", 0.005, {FAULT_INSULATED, 1}, 1, 100, "side x_hi were insulated"},
        {"plate-cooling", 0.025, {FAULT_COEFFICIENT, FAULT_ALL_SIDES}, -1, -100, "cooled sides were insulated"},
        {"rod-cooling", 0.005, {FAULT_COEFFICIENT, 1}, 2, 200, "coefficient of side x_hi were"},
        {"square-step", 0.05, {FAULT_AXIS, 1}, 0.6, 60, "k_y were"},
        {"rod-contact", 0.01, {FAULT_RHO_C, 1}, 0.5, 50, "rho c of the second material were"},
        {"rect-manufactured", 0.025, {FAULT_SOURCE, 0}, 0.1, 10, "source were"},
        {"rod-step", 0.025, {FAULT_CONDUCTIVITY, 0}, 1.04, 104, "k/rho c, were 104 %"},
        {"wall-composite", 0.01, {FAULT_EXTENT, 0}, 0.5, 0.5, "sides across x were"},
        {"wall-composite", 0.01, {FAULT_INTERFACE, 0}, -0.5, -0.5, "too far down"},
        {"rod-contact", 0.01, {FAULT_RHO_C, 0}, 0.1, 10, "rho c of the first material were"},
        {"rod-contact", 0.01, {FAULT_DIFFUSIVITY, 0}, 1, 100, "mean of diffusivities"},
        {"wall-composite", 0.01, {FAULT_DIFFUSIVITY, 0}, 1, 100, "mean of diffusivities"},
        {CHANGING, 0.0125, {FAULT_SOURCE_FROZEN, 0}, 1, 100, "source kept its first value"},
        {"rod-driven", 0.025, {FAULT_WALL_TIME, 0}, -1, -1, "walls were those of"},
        {"rod-driven", 0.025, {FAULT_CLOCK, 0}, -1, -1, "run had stopped"},
        {"rod-driven", 0.025, {FAULT_WALL_FROZEN, 0}, 1, 100, "walls kept their first values"},
        {"plate-driven", 0.05, {FAULT_WALL_TIME, 0}, 2, 2, "walls were those of"},
        {"plate-driven", 0.05, {FAULT_CLOCK, 0}, 2, 2, "run had stopped"},
        {"plate-driven", 0.05, {FAULT_WALL_FROZEN, 0}, 1, 100, "walls kept their first values"},
        {"rect-manufactured", 0.025, {FAULT_POINTS, FAULT_BOTH_AXES}, -0.5, -0.5, "points of the answer were 0.5"},
        {"rect-manufactured", 0.025, {FAULT_ALONG, FAULT_BOTH_AXES}, 1, 1, "cells too far up, along the wall"},
        {"rect-manufactured", 0.025, {FAULT_INSULATED, X_LO}, 1, 100, "side x_lo were insulated"},
        {"wave", 0.025, {FAULT_NOT_PERIODIC, 1}, 1, 100, "periodic sides across y were insulated"},
        {"oblique", 0.025, {FAULT_NORMAL, 0}, 1, 100, "n.grad T were 0 on insulated sides"},
        {"oblique", 0.025, {FAULT_CROSS, 1}, 1, 100, "k_xy had the wrong sign"},
        {"rod-cooling", 0.005, {FAULT_NEAR_WALL, 0}, 0.5, 0.5, "half a cell inside"},
        {"rod-cooling", 0.005, {FAULT_HELD, 0}, 0.5, 0.5, "as if held sides were"},
        {"rod-cosine", 0.025, {FAULT_LEAK, X_LO}, 0.3, 30, "side x_lo lost heat"},
        {"rod-cosine", 0.025, {FAULT_LEAK, FAULT_ALL_SIDES}, 0.05, 5, "insulated sides, or those of given flux,"},
        {"plate-cooling", 0.025, {FAULT_NEAR_WALL, 0}, 0.5, 0.5, "half a cell inside"},
        {"plate-driven", 0.05, {FAULT_NEAR_WALL, 1}, 0.5, 0.5, "Robin walls across y took"},
        {"rod-step", 0.025, {FAULT_OFFSET, 0}, -0.07, -0.07, "all temperatures are 0.07 K too low"},
        {"plate", 0.0025, {FAULT_OFFSET, 0}, 273.15, 273.15, "degrees Celsius and kelvin"},
        {"melt", 0.0125, {FAULT_FRONT, AT_FRONT_LOST}, 1, 100, "latent heat were lost"},
        {"melt", 0.0125, {FAULT_FRONT, AT_FRONT_KEPT}, 1, 100, "first cell"},
        {"melt", 0.0125, {FAULT_PHASES, PHASES_SWAPPED}, 1, 100, "k of solid and liquid"},
        {"melt", 0.0125, {FAULT_PHASES, PHASES_LIQUID}, 1, 100, "k of the solid were that of the liquid"},
        {"melt", 0.0125, {FAULT_PHASES, PHASES_RHO_C + PHASES_SWAPPED}, 1, 100, "rho c of solid and liquid"},
        {"melt", 0.0125, {FAULT_PHASES, PHASES_BOTH}, 1, 100, "if solid and liquid"},
    };
    int wrong = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct diagnosis d = find(rows[i].scene, rows[i].fault, rows[i].units, rows[i].dx);
        int is_right =
            d.named && strstr(d.what, rows[i].what) && fabs(d.size - rows[i].size) <= 0.2 * fabs(rows[i].size);
        if (!is_right) print_message("not %s, %g\n", rows[i].what, rows[i].size);
        wrong += !is_right;
    }
    assert_int_equal(wrong, 0);
}

/* One row cannot tell all faults that displace a front apart, but sizes each. */
static void faults_of_melting_are_sized(void **state) {
    (void)state;
    static const struct {
        struct fault fault;
        double size;
    } rows[] = {{{FAULT_LATENT, 0}, -0.3},
                {{FAULT_CONDUCTIVITY, 0}, 0.2},
                {{FAULT_PHASE_PART, 1}, 0.3},
                {{FAULT_MELTING_POINT, 0}, 0.2}};
    struct problem p = problem_of("melt");
    for (int i = 0; i < 4; i++) {
        struct rung r[2];
        struct diagnosis d;
        int found = 0;
        for (int k = 0; k < 2; k++) solve("melt", &p, rows[i].fault, rows[i].size, k ? 0.025 : 0.0125, &r[k]);
        diagnosis_find(&p, &r[0].at, &r[1].at, &d);
        print_message("%s\n", d.what);
        for (int j = 0; j < d.evidence->n; j++) {
            const struct fault_fit *fit = &d.evidence->fit[j];
            if (fit->fault.kind != rows[i].fault.kind || fit->fault.at != rows[i].fault.at) continue;
            assert_near(fit->rung[0].size, rows[i].size, 0.1 * fabs(rows[i].size));
            assert_order(fit->rung[0].share, >, FIT_SHARE);
            found++;
        }
        assert_int_equal(found, 1);
        for (int k = 0; k < 2; k++) forget(&r[k]);
        free(d.evidence);
    }
}

/* A jump a third of a cell below a face at dx = 0.05, a third above one at 0.025: values at the points put it there.
 */
static void point_values_in_place_of_means_are_named(void **state) {
    (void)state;
    struct problem p = problem_of("rod-step");
    struct rung r[2];
    struct diagnosis d;
    struct failure why;
    p.param[1] = 8.0 / 15; /* a */
    if (scene_find("rod-step")->setup(&p, &why)) fail_msg("%s", why.text);
    for (int k = 0; k < 2; k++) {
        solve("rod-step", &p, (struct fault){FAULT_SAMPLES, 0}, k ? 1 / 3.0 : -1 / 3.0, k ? 0.05 : 0.025, &r[k]);
    }
    diagnosis_find(&p, &r[0].at, &r[1].at, &d);
    print_message("%s\n", d.what);
    assert_has(d.what, "values at the points");
    for (int i = 0; i < 2; i++) forget(&r[i]);
    free(d.evidence);
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
    for (int i = 0; i < 40; i++) T[i] = nearbyint(1e4 * (1.1 + sqrt(i) / 70)) / 1e4;
    assert_int_equal(diagnosis_rounding(&f, 1e-3, 40, &d), 1);
    assert_near(d.size, 5, 0);
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
static void few_rounded_temperatures_are_not_named(void **state) {
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
    assert_int_equal(diagnosis_repeat(1.1e-8, 1, &d), 1);
    assert_has(d.what, "answers differ by 1.1e-08 K from run to run");
    assert_int_equal(diagnosis_repeat(0.9e-8, 1, &d), 0);
    assert_int_equal(diagnosis_repeat(1.1e-8, 2, &d), 0);
}

/* rod-gauss by a code whose answers differ from point values by `mean` dx^2/24 T_xx, with that fault of a clock. */
static void solve_means(struct problem *p, double mean, double steps, double dx, struct rung *r) {
    const struct scene *s = scene_of("rod-gauss");
    const double d = 1e-3;
    solve("rod-gauss", p, (struct fault){FAULT_CLOCK, 0}, steps, dx, r);
    for (size_t i = 0; i < r->field.n; i++) {
        double x = r->field.x[0][i], T[3];
        for (int j = 0; j < 3; j++) T[j] = scene_exact(s, p, (double[2]){x + (j - 1) * d, 0}, p->t_end).temperature;
        r->field.T[i] += mean * dx * dx / 24 * (T[0] - 2 * T[1] + T[2]) / (d * d);
    }
}

/* An answer at the start identifies means or values, and thus the remainder for a clock, unless the initial data are
 * linear.  Differences over d = dx/8 of a Gaussian are too small by d^2/12 5/(2 sigma^2): 7e-5. */
static void initial_data_reveal_cell_means(void **state) {
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
        forget(&start), free(found.evidence);
        for (int k = 0; k < 2; k++) forget(&r[k]);
    }
    static const char *const neither[] = {"rect-manufactured", "plate"}; /* a source adds values; no laplace(T) */
    for (int i = 0; i < 2; i++) {
        struct problem made = problem_of(neither[i]);
        struct rung start;
        solve(neither[i], &made, (struct fault){FAULT_CLOCK, 0}, 0, i ? 0.005 : 0.05, &start);
        assert_nan(diagnosis_mean(&made, &start.at));
        forget(&start);
    }
}

/* A wave in the plane with two wavelengths: cell means, with noise of a millionth of their difference; and
 * values. */
static void initial_data_reveal_cell_means_in_the_plane(void **state) {
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
            field_put(&f, (size_t)i, (double[2]){x, y});
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
        {"rod-cosine",
         0.025,
         {FAULT_CONDUCTIVITY, 0},
         {0.02, 0.02},
         {0, 0},
         "as if the diffusivity, k/rho c, or the end time were"},
        {"rod-cooling", 0.01, {FAULT_CLOCK, 0}, {13, 3.25}, {1, 0}, "% too small, or the end time "},
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
            forget(&wrong);
        }
        diagnosis_find(&p, &r[0].at, &r[1].at, &d);
        print_message("%s\n", d.what);
        assert_has(d.what, said[i]);
        for (int k = 0; k < 2; k++) forget(&r[k]);
        free(d.evidence);
    }
}

static void unstable_runs_are_named(void **state) {
    (void)state;
    struct problem p = problem_of("rod-step");
    struct rung r;
    struct diagnosis d;
    solve("rod-step", &p, (struct fault){FAULT_AMPLITUDE, 0}, 0, 0.05, &r);
    assert_int_equal(diagnosis_unstable(&r.at, &d), 0);
    double first = r.exact[0];
    r.exact[0] = INFINITY; /* no temperature there */
    assert_int_equal(diagnosis_unstable(&r.at, &d), 0);
    r.exact[0] = first;
    for (size_t i = 0; i < r.field.n; i++) r.field.T[i] = i % 2 ? 1e9 : -1e9;
    assert_int_equal(diagnosis_unstable(&r.at, &d), 1);
    assert_has(d.what, "the run is unstable, up to 1e+09 K");
    for (size_t i = 0; i < r.field.n; i++) r.field.T[i] = 1e9;
    assert_int_equal(diagnosis_unstable(&r.at, &d), 0); /* another scale, without a sawtooth */
    forget(&r);
}

static double level(const struct problem *p, const double *x) {
    (void)x;
    return p->param[0];
}

/* From each end, by a tenth of the range. */
static void temperatures_that_are_cut_off_are_named(void **state) {
    (void)state;
    for (int at = CUT_BELOW; at <= CUT_ABOVE; at++) {
        struct problem p = problem_of("rod-gauss");
        const double sign = at == CUT_BELOW ? 1 : -1;
        struct rung r;
        struct diagnosis d;
        solve("rod-gauss", &p, (struct fault){FAULT_AMPLITUDE, 0}, 0, 0.1, &r);
        assert_int_equal(diagnosis_cut(&p, &r.at, &d), 0);
        double lo = r.exact[0], hi = r.exact[0];
        for (size_t i = 0; i < r.field.n; i++) lo = fmin(lo, r.exact[i]), hi = fmax(hi, r.exact[i]);
        const double end = at == CUT_BELOW ? lo + 0.1 * (hi - lo) : hi - 0.1 * (hi - lo);
        for (size_t i = 0; i < r.field.n; i++) r.field.T[i] = sign * fmax(sign * r.field.T[i], sign * end);
        assert_int_equal(diagnosis_cut(&p, &r.at, &d), 1);
        assert_int_equal(d.fault.at, at);
        assert_has(d.what, at == CUT_BELOW ? "temperatures below a lowest value were cut off" : "above a highest");
        struct problem as_it_began = p;
        as_it_began.initial = level, as_it_began.param[0] = end;
        assert_int_equal(diagnosis_cut(&as_it_began, &r.at, &d), 0);
        for (size_t i = 0; i < r.field.n; i++) r.exact[i] = r.field.T[i];
        assert_int_equal(diagnosis_cut(&p, &r.at, &d), 0); /* a solution that is level there */
        forget(&r);
    }
}

/* 2 % more conductivity on a Gaussian of kappa t/sigma0^2 = c: T = (1 + 2 c)^-1/2 exp(-x^2/(2 sigma^2)) loses at x
 * the share 0.02 c (1 - x^2/sigma^2)/(1 + 2 c), and the mean of |1 - u^2| over a Gaussian is 4/sqrt(2 pi e). */
static void response_is_the_relative_error_of_a_fault(void **state) {
    (void)state;
    struct problem p = problem_of("rod-gauss");
    struct diagnosis d = {.named = 1, .fault = {FAULT_CONDUCTIVITY, 0}, .size = 2, .unit = "%"};
    double c = p.material[0].k[0] * p.t_end / (p.material[0].rho_c * p.param[1] * p.param[1]);
    double want = 0.02 * c / (1 + 2 * c) * 4 / sqrt(2 * M_PI * exp(1));
    assert_near(headline_effect(&p, &d, 0.1, 0, 0), want, 0.03 * want);
    d.fault.kind = FAULT_OFFSET, d.unit = "K", d.size = 0.5;
    assert_near(headline_effect(&p, &d, 0.1, 0, -1) / headline_effect(&p, &d, 0.1, 0, -3), 3.0, 0.4);
    d.fault.kind = FAULT_SOURCE;
    assert_nan(headline_effect(&p, &d, 0.1, 0, 0));
    d.fault.kind = FAULT_NOISE;
    assert_nan(headline_effect(&p, &d, 0.1, 0, 0));
}

/* Off by 1 % of their largest, up and down from point to point: of this nothing but noise is to be seen. */
static void noise_is_not_named(void **state) {
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
    for (int i = 0; i < 2; i++) forget(&r[i]);
    free(d.evidence);
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
        struct field many = {.dim = 1, .n = n, .x = {x}, .T = T, .weight = weight};
        struct diagnosis_rung fine = {&many, exact, 0.025, r[1].at.dt, NAN};
        diagnosis_find(&p, &fine, &r[1].at, &d);
        print_message("%s\n", d.what);
        assert_has(d.what, "all temperatures were 1.3 % too large");
        assert_order(d.share, >, 0.9999);
        free(d.evidence);
    }
    free(x), free(T), free(exact), free(weight);
    forget(&r[1]);
}

static void correct_codes_have_no_fault(void **state) {
    (void)state;
    static const char *const names[] = {"rod-gauss",   "rod-step", "rod-cosine",        "rod-contact",
                                        "square-step", "plate",    "rect-manufactured", "melt"};
    static const double fine[] = {0.15, 0.025, 0.025, 0.01, 0.05, 0.0025, 0.025, 0.0125};
    int named = 0;
    for (int i = 0; i < 8; i++) {
        named += find(names[i], (struct fault){FAULT_AMPLITUDE, 0}, 0, fine[i]).named;
    }
    assert_int_equal(named, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_are_named_with_their_size),
        cmocka_unit_test(faults_of_melting_are_sized),
        cmocka_unit_test(point_values_in_place_of_means_are_named),
        cmocka_unit_test(rounded_temperatures_are_named),
        cmocka_unit_test(few_rounded_temperatures_are_not_named),
        cmocka_unit_test(rounded_temperatures_are_named_in_any_scale),
        cmocka_unit_test(runs_that_differ_are_named),
        cmocka_unit_test(initial_data_reveal_cell_means),
        cmocka_unit_test(initial_data_reveal_cell_means_in_the_plane),
        cmocka_unit_test(sizes_follow_the_spacing),
        cmocka_unit_test(means_of_conductivities_are_distinguished),
        cmocka_unit_test(unstable_runs_are_named),
        cmocka_unit_test(temperatures_that_are_cut_off_are_named),
        cmocka_unit_test(response_is_the_relative_error_of_a_fault),
        cmocka_unit_test(noise_is_not_named),
        cmocka_unit_test(large_answers_are_sampled),
        cmocka_unit_test(correct_codes_have_no_fault),
    };
    return cmocka_run_group_tests_name("diagnosis", tests, NULL, NULL);
}
