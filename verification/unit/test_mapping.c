/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The image of a scene obeys its own equation, in each of its axes; and the words that say which it is. */
#include "references/kirchhoff.h"
#include "references/mapping.h"
#include "verification/case/case_file.h"
#include "references/columns.h"
#include "references/snapshot.h"

#include "verification/unit/odd_scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>

static const char *const of_rod[] = {"x", "-x"}, *const of_plane[] = {"x,y", "-x,y", "x,-y", "-x,-y",
                                                                      "y,x", "-y,x", "y,-x", "-y,-x"};

static void words_are_read_as_they_are_printed(void **state) {
    (void)state;
    static const char *const wrong[] = {"",    "z", "x,",  "x,x",    "-y,-y", "y",   "--x",    "x,y,x",
                                        "x y", "-", "x,-", "x,y,z,", "x,z",   "z,y", "x,y,-y", "x,y,w"};
    char text[MAPPING_WORDS];
    for (int i = 0; i < 10; i++) {
        struct mapping m = {0};
        const char *word = i < 2 ? of_rod[i] : of_plane[i - 2];
        assert_int_equal(mapping_read(word, &m), 0);
        assert_int_equal(m.axes, i < 2 ? 1 : 2);
        mapping_print(&m, text);
        assert_string_equal(text, word);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct mapping m = {.axes = 2, .from = {1, 0, 2}, .scale = 3};
        if (mapping_read(wrong[i], &m) == 0) fail_msg("'%s' is taken", wrong[i]);
        assert_true(m.axes == 2 && m.from[0] == 1 && m.scale == 3);
    }
    struct mapping m = {0};
    mapping_read("-y,x", &m);
    double to[DIM_MAX];
    mapping_to_scene(&m, 2, (double[2]){3, 5}, to); /* x = -(scene's y) = 3, y = (scene's x) = 5 */
    assert_true(to[0] == 5 && to[1] == -3);
    mapping_to_case(&m, 2, (double[2]){to[0], to[1]}, to);
    assert_true(to[0] == 3 && to[1] == 5);
    assert_int_equal(mapping_side(&m, X_LO), Y_HI);
    assert_int_equal(mapping_side(&m, Y_HI), X_HI);
}

/* The i-th of the 48 maps of a box: six orders of the axes, eight signs. */
static struct mapping of_box(int i) {
    static const char *const order[] = {"xyz", "yzx", "zxy", "xzy", "yxz", "zyx"};
    struct mapping m = {0};
    char text[MAPPING_WORDS] = "", *at = text;
    for (int a = 0; a < 3; a++) at += sprintf(at, "%s%s%c", a ? "," : "", i >> a & 1 ? "-" : "", order[i / 8][a]);
    assert_int_equal(mapping_read(text, &m), 0);
    char again[MAPPING_WORDS];
    mapping_print(&m, again);
    assert_string_equal(again, text);
    return m;
}

/* The image of (1, 2, 3), which identifies a map. */
static int place_of(const struct mapping *m, const struct mapping *n) {
    double once[DIM_MAX], to[DIM_MAX];
    mapping_to_scene(m, 3, (double[]){1, 2, 3}, once);
    mapping_to_scene(n, 3, once, to);
    return (int)(100 * to[0] + 10 * to[1] + to[2]);
}

/* v.K v, which no map changes. */
static double quadratic(const struct problem *p, const double v[DIM_MAX]) {
    double K[DIM_MAX][DIM_MAX], sum = 0;
    problem_tensor(p, v, K);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) sum += v[a] * K[a][b] * v[b];
    return sum;
}

/* The field of the ring turns with the plane. */
static void a_field_turns_with_its_axes(void **state) {
    (void)state;
    struct problem ring;
    const double x[DIM_MAX] = {-0.31, 0.47, 0};
    odd_find("ring", &ring);
    for (int i = 0; i < 8; i++) {
        struct mapping m = {0};
        struct image image;
        double to[DIM_MAX], b[DIM_MAX] = {0}, of[DIM_MAX] = {0}, back[DIM_MAX];
        assert_int_equal(mapping_read(of_plane[i], &m), 0);
        mapping_image(&m, &ring, &image);
        mapping_to_scene(&m, 2, x, to);
        image.problem.direction(&image.problem, x, b);
        ring.direction(&ring, to, of);
        mapping_to_case(&m, 2, of, back);
        for (int a = 0; a < 2; a++) assert_near(fabs(b[0] * back[a] - b[a] * back[0]), 0, 1e-15); /* parallel */
        assert_near(hypot(b[0], b[1]), 1, 1e-15);
    }
}

/* Two maps in succession are one of the 48; each has its inverse; sides, interfaces and tensors follow their points.
 */
static void maps_of_a_box_form_a_group(void **state) {
    (void)state;
    const struct mapping none = {0};
    struct problem contact, tensor;
    int place[48];
    odd_find("box-contact", &contact);
    odd_find("box-manufactured", &tensor);
    for (int k = 0; k < 3; k++) tensor.cross[k] = (double[]){0.11, -0.07, 0.05}[k] * tensor.material[0].k[0];
    for (int i = 0; i < 48; i++) {
        const struct mapping m = of_box(i);
        place[i] = place_of(&m, &none);
        for (int k = 0; k < i; k++) assert_int_not_equal(place[i], place[k]);
    }
    for (int i = 0; i < 48; i++) {
        const struct mapping m = of_box(i);
        double x[] = {-0.3, 0.7, 1.9}, to[DIM_MAX], back[DIM_MAX];
        mapping_to_scene(&m, 3, x, to);
        mapping_to_case(&m, 3, to, back);
        for (int a = 0; a < 3; a++) assert_true(back[a] == x[a]);
        for (int a = 0; a < 3; a++) assert_int_equal(mapping_axis(&m, mapping_axis_back(&m, a)), a);
        int inverse = 0;
        for (int k = 0; k < 48; k++) {
            const struct mapping n = of_box(k);
            int both = place_of(&m, &n), found = 0;
            for (int l = 0; l < 48; l++) found += place[l] == both;
            assert_int_equal(found, 1);
            inverse += both == place_of(&none, &none);
        }
        assert_int_equal(inverse, 1);
        for (int s = 0; s < SIDES; s++) { /* a point on side s of the cube [-1, 1]^3 */
            double on[3] = {0.1, 0.2, 0.3};
            on[s / 2] = s % 2 ? 1 : -1;
            mapping_to_scene(&m, 3, on, to);
            int t = mapping_side(&m, (enum side)s);
            assert_true(to[t / 2] == (t % 2 ? 1 : -1));
        }
        struct image image;
        mapping_image(&m, &contact, &image);
        assert_int_equal(mapping_axis(&m, image.interface_axis), 0);
        mapping_image(&m, &tensor, &image);
        mapping_to_scene(&m, 3, x, to);
        assert_near(quadratic(&image.problem, x) / quadratic(&tensor, to), 1, 1e-14);
    }
}

struct seen {
    double T, start, source, k[2], rho_c, flux[2], wall[2][3];
};

/* The columns of the oracle for the image at x. */
static struct seen seen_at(const struct scene *s, const struct image *image, const double x[2], double t) {
    static const char *const what[2] = {"temperature,initial,source,rho_c,k_x,flux_x,wall_x",
                                        "temperature,initial,source,rho_c,k_x,flux_x,wall_x,k_y,flux_y,wall_y"};
    struct columns c;
    struct failure why = {0};
    double v[COLUMNS_VALUES] = {0}, at[1][DIM_MAX] = {{x[0], image->problem.dim > 1 ? x[1] : 0}};
    if (columns_parse(what[image->problem.dim - 1], image->problem.dim, &c, &why)) fail_msg("%s", why.text);
    struct snapshot now = snapshot_take(s, image->of, t);
    columns_at_points(&c, image, &now, 1, at, NULL, v);
    snapshot_free(&now);
    struct seen seen = {v[0], v[1], v[2], {v[4], v[9]}, v[3], {v[5], v[10]}, {{0}, {0}}};
    memcpy(seen.wall, v + 6, sizeof *seen.wall);
    memcpy(seen.wall[1], v + 11, sizeof *seen.wall);
    return seen;
}

/* The residual of rho_c dT/dt = -div(flux) + G inside, by differences over d and over the corresponding diffusion
 * time; and of flux = -K grad T. */
static double equation_is_off(const struct scene *s, const struct image *image, const double x[2], double t) {
    const struct problem *p = &image->problem;
    const double d = s->odd.step / 4, dt = 1e-4 * t;
    double off = 0;
    struct seen here = seen_at(s, image, x, t);
    double rise = (seen_at(s, image, x, t + dt).T - seen_at(s, image, x, t - dt).T) / (2 * dt), into = here.source;
    double slope[2] = {0};
    for (int a = 0; a < p->dim; a++) {
        double lo[2] = {x[0], x[1]}, hi[2] = {x[0], x[1]};
        lo[a] -= d, hi[a] += d;
        struct seen below = seen_at(s, image, lo, t), above = seen_at(s, image, hi, t);
        into -= (above.flux[a] - below.flux[a]) / (2 * d);
        slope[a] = (above.T - below.T) / (2 * d);
    }
    for (int a = 0; a < p->dim; a++) {
        double flux = here.k[a] * slope[a] + (p->dim > 1 ? p->cross[0] * slope[1 - a] : 0);
        off = fmax(off, fabs(here.flux[a] + flux) / (here.k[a] / d));
    }
    return fmax(off, fabs(here.rho_c * rise - into) / (here.rho_c / t));
}

/* Distance from the condition of side i at x, in units of the temperature. */
static double side_is_off(const struct scene *s, const struct image *image, int i, const double x[2], double t) {
    struct seen here = seen_at(s, image, x, t);
    int a = i / 2;
    const double *wall = here.wall[a];
    double into = i % 2 ? -here.flux[a] : here.flux[a]; /* k dT/dn: the inward flux */
    if (wall[0] == 1) return fabs(here.T - wall[1]);
    double law = wall[0] == 2 ? wall[1] : wall[2] * (wall[1] - here.T);
    return fabs(into - law) / (here.k[a] / (image->problem.hi[a] - image->problem.lo[a]));
}

/* Differences of the second order over a quarter of the scene's own step leave below 1e-2 of its temperatures; a
 * sign, a swap or a lost scale leaves some tenths. */
static void image_satisfies_its_equation(void **state) {
    (void)state;
    static const char *const name[] = {"rod-contact",   "rod-cooling",  "rod-driven", "rect-manufactured",
                                       "plate-cooling", "plate-driven", "oblique",    "wave"};
    for (int n = 0; n < 8; n++)
        for (int i = 0; i < (n < 3 ? 2 : 8); i++) {
            struct problem of;
            struct image image;
            struct mapping m = {.scale = 1.7, .offset = -2.3};
            const struct scene *s = odd_find(name[n], &of);
            mapping_read(n < 3 ? of_rod[i] : of_plane[i], &m);
            mapping_image(&m, &of, &image);
            const struct problem *p = &image.problem;
            double t = of.t_end, bound = 0.02 * s->odd.scale, worst[3] = {0}, x[2] = {0};
            for (int k = 0; k < 9; k++) {
                for (int a = 0; a < p->dim; a++)
                    x[a] = p->lo[a] + (p->hi[a] - p->lo[a]) * (0.13 + 0.091 * (a ? 8 - k : k));
                int across = image.interface_axis;
                if (p->materials == 2 && fabs(x[across] - p->interface) < s->odd.step) continue;
                worst[0] = fmax(worst[0], equation_is_off(s, &image, x, t));
                struct seen start = seen_at(s, &image, x, 0);
                worst[2] = fmax(worst[2], fabs(start.start - start.T));
                for (int side = 0; side < 2 * p->dim; side++) {
                    double foot[2] = {x[0], x[1]};
                    if (p->side[side] == PERIODIC) continue;
                    foot[side / 2] = side % 2 ? p->hi[side / 2] : p->lo[side / 2];
                    worst[1] = fmax(worst[1], side_is_off(s, &image, side, foot, t));
                }
            }
            if (!(worst[0] < bound && worst[1] < bound && worst[2] < bound))
                fail_msg("%s, %s: equation %.2g, sides %.2g, start %.2g of %.2g", name[n],
                         n < 3 ? of_rod[i] : of_plane[i], worst[0], worst[1], worst[2], bound);
        }
}

/* The interface is across the case's y, with the material of the scene's lower half above it. */
static void case_file_uses_its_own_axes(void **state) {
    (void)state;
    struct problem of;
    struct mapping m = {.scale = 2, .offset = -3};
    const struct scene *s = odd_find("rect-manufactured", &of);
    struct options o = {.dx = 0.1};
    char *text;
    size_t size;
    struct rows r;
    struct failure why;
    of.materials = 2, of.interface = 0.3; /* no scene of the plane has two */
    of.material[1] = (struct material){{7, 11}, 13};
    mapping_read("y,-x", &m);
    FILE *out = open_memstream(&text, &size);
    case_file_write(s, &of, &o, &(struct case_extra){.label = "mine", .map = &m}, out);
    fclose(out);
    static const char *const says[][2] = {{"map", "y,-x"},           {"scale", "2"},
                                          {"offset", "-3"},          {"interface", "-0."},
                                          {"interface_axis", "y"},   {"k_x", "11, 0.006"},
                                          {"k_y", "7, 0.02"},        {"rho_c", "13, 1.8"},
                                          {"lo", "0, -0.9"},         {"hi", "0.59999999999999998, 0"},
                                          {"cells", "6, 9"},         {"side_x_lo", "neumann"},
                                          {"side_y_hi", "dirichlet"}};
    assert_int_equal(rows_of(text, "case", &r, &why), 0);
    for (size_t i = 0; i < sizeof says / sizeof *says; i++) {
        const char *value = case_file_value(&r, says[i][0], NULL);
        if (!value || strncmp(value, says[i][1], strlen(says[i][1])) != 0)
            fail_msg("%s = %s, not %s", says[i][0], value, says[i][1]);
    }
    assert_has(case_file_value(&r, "oracle", NULL), " --map y,-x --scale 2 --offset -3");
    rows_free(&r);
}

static void k_of_an_image_is_that_of_the_scene(void **state) {
    (void)state;
    static const char *const name[] = {"front", "wall-kirchhoff", "plate-kirchhoff"};
    for (int n = 0; n < 3; n++) {
        struct problem of;
        struct image image;
        const struct mapping m = {.scale = 1.7, .offset = -2.3};
        odd_find(name[n], &of);
        mapping_image(&m, &of, &image);
        for (double T = 0.3; T < 3; T += 0.7)
            assert_near(kirchhoff_k(&image.problem, mapping_temperature(&m, T)), kirchhoff_k(&of, T), 1e-14);
    }
}

/* A bound of a mapped temperature holds in long double: the offset takes digits that the scene's bound has. */
static void bounds_hold_the_rounding_of_the_map(void **state) {
    (void)state;
    static const struct mapping maps[] = {{.offset = 1e6}, {.scale = 3.7}, {.scale = 0.013, .offset = -273.15}, {0}};
    struct problem p;
    const struct scene *s = odd_find("rod-gauss", &p);
    double worst = 0;
    for (size_t k = 0; k < sizeof maps / sizeof *maps; k++)
        for (double x = -1; x < 1; x += 0.0137) {
            struct exact e = scene_exact(s, &p, &x, 2);
            double T = mapping_temperature(&maps[k], e.temperature),
                   bound = mapping_bound(&maps[k], e.temperature, 0);
            long double off = (long double)mapping_scale(&maps[k]) * e.temperature + maps[k].offset - T;
            assert_true(fabsl(off) <= bound);
            worst = fmax(worst, (double)fabsl(off));
            assert_near(mapping_bound(&(struct mapping){0}, e.temperature, 1e-9), 1e-9, 0);
        }
    assert_order(worst, >, 1e-11); /* 1e6 K has steps of 1.2e-10 K */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds_hold_the_rounding_of_the_map), cmocka_unit_test(words_are_read_as_they_are_printed),
        cmocka_unit_test(image_satisfies_its_equation),        cmocka_unit_test(k_of_an_image_is_that_of_the_scene),
        cmocka_unit_test(case_file_uses_its_own_axes),         cmocka_unit_test(maps_of_a_box_form_a_group),
        cmocka_unit_test(a_field_turns_with_its_axes),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("mapping", tests, NULL, NULL);
}
