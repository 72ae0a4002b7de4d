/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The oracle: every column compared with its definition, and the table written from them. */
#include "verification/case/answer.h"

#include "references/snapshot.h"
#include "solver/shape.h"

#include "verification/unit/odd_scenes.h"
#include "verification/unit/points_text.h"

#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>

static void lists_of_columns_are_checked(void **state) {
    (void)state;
    struct columns c;
    struct failure why;
    char header[COLUMNS_HEADER];
    assert_int_equal(columns_parse("k_x,wall,flux_y", 2, &c, &why), STATUS_OK);
    columns_header(&c, header);
    assert_string_equal(header, "k_x,wall_kind,wall_value,wall_b,flux_y");
    assert_true(c.needs_time && !c.needs_cell);
    assert_int_equal(columns_parse("initial_mean", 1, &c, &why), STATUS_OK);
    assert_true(!c.needs_time && c.needs_cell);
    assert_int_equal(columns_parse("tempurature", 1, &c, &why), STATUS_INPUT);
    assert_has(why.text, "did you mean 'temperature'");
    assert_int_equal(columns_parse("k_x,", 1, &c, &why), STATUS_INPUT);
    assert_int_equal(columns_parse("", 1, &c, &why), STATUS_INPUT);
    assert_int_equal(columns_parse("k_x,k_y", 1, &c, &why), STATUS_INPUT);
    assert_has(why.text, "a rod has no y");
    assert_int_equal(columns_parse("k_x,k_x", 1, &c, &why), STATUS_INPUT);
    assert_has(why.text, "named twice");
}

static int values(const char *what, const struct scene *s, const struct problem *p, const double x[2],
                  const double cell[2], double t, double *value) {
    struct columns c;
    struct failure why = {0};
    if (columns_parse(what, p->dim, &c, &why)) fail_msg("%s", why.text);
    struct image image;
    double at[1][DIM_MAX] = {{0}}, extent[1][DIM_MAX] = {{0}};
    for (int a = 0; a < p->dim; a++) at[0][a] = x[a], extent[0][a] = cell ? cell[a] : 0;
    mapping_image(&(struct mapping){0}, p, &image);
    struct snapshot now = snapshot_take(s, p, t);
    columns_at_points(&c, &image, &now, 1, at, cell ? extent : NULL, value);
    snapshot_free(&now);
    return c.values;
}

/* Every material's value in its own column, and the flux from temperatures at two points. */
static void oracle_columns_equal_the_scene(void **state) {
    (void)state;
    struct problem p;
    double v[COLUMNS_VALUES], d = 1e-4, there[2];
    const struct scene *s = odd_find("rect-manufactured", &p);
    const double x[2] = {0.31, 0.23};
    assert_int_equal(
        values("temperature,initial,source,k_x,k_y,rho_c,flux_x,flux_y,error_bound", s, &p, x, NULL, 1.3, v), 9);
    struct exact e = scene_exact(s, &p, x, 1.3);
    assert_near(v[0], e.temperature, 0);
    assert_near(v[1], p.initial(&p, x), 0);
    assert_near(v[2], problem_source(&p, x, 1.3), 0);
    assert_near(v[3], 0.023, 0);
    assert_near(v[4], 0.0061, 0);
    assert_near(v[5], 1.9, 0);
    for (int a = 0; a < 2; a++) {
        double slope = 0;
        for (int side = -1; side <= 1; side += 2) {
            there[0] = x[0], there[1] = x[1];
            there[a] += side * d;
            slope += side * s->second(&p, there, 1.3).temperature / (2 * d);
        }
        assert_near(v[6 + a], -p.material[0].k[a] * slope, 2e-7);
        assert_order(fabs(v[6 + a]), >, 1e-4);
    }
    assert_near(v[8], e.error_bound, 0);

    s = odd_find("wall-composite", &p); /* two materials; at the interface, the upper one */
    for (int side = 0; side < 2; side++) {
        const double at[2] = {side ? 0.37 : 0.369, 0};
        assert_int_equal(values("k_x,rho_c,flux_x", s, &p, at, NULL, 0.7, v), 3);
        assert_near(v[0], side ? 0.013 : 0.9, 0);
        assert_near(v[1], side ? 0.021 : 1.3, 0);
        assert_near(v[2], 0.9 / (0.37 / 0.9 + 0.73 / 0.013), 3e-4); /* nearly steady */
    }
}

static void wall_columns_give_kind_and_value(void **state) {
    (void)state;
    struct problem p;
    double v[COLUMNS_VALUES];
    const struct scene *s = odd_find("rect-manufactured", &p);
    double W = 0.9, H = 0.6;
    values("wall", s, &p, (double[2]){0.3, 0.2}, NULL, 1, v);
    assert_true(v[0] == 0 && v[1] == 0 && v[2] == 0);
    values("wall", s, &p, (double[2]){W, 0.2}, NULL, 1, v);
    assert_true(v[0] == 1 && v[2] == 0);
    assert_near(v[1], p.wall(&p, X_HI, (double[2]){W, 0.2}, 0), 0);
    values("wall", s, &p, (double[2]){0.3, H}, NULL, 1, v);
    assert_true(v[0] == 2);
    assert_near(v[1], p.wall(&p, Y_HI, (double[2]){0.3, H}, 0), 0);
    values("wall,wall_x,wall_y", s, &p, (double[2]){0, H}, NULL, 1, v); /* the corner of both kinds */
    assert_true(v[0] == 1 && v[3] == 1 && v[6] == 2);
    assert_near(v[1], p.wall(&p, X_LO, (double[2]){0, H}, 0), 0);
    assert_near(v[7], p.wall(&p, Y_HI, (double[2]){0, H}, 0), 0);
    p.side[X_HI] = ROBIN;
    p.robin[X_HI] = 7.5;
    values("wall", s, &p, (double[2]){W, 0.2}, NULL, 1, v);
    assert_true(v[0] == 3 && v[2] == 7.5);
    values("wall", s, &p, (double[2]){W, 0}, NULL, 1, v);
    assert_true(v[0] == 2);

    s = odd_find("plate", &p); /* T1 = 0.31 at y = 0, T4 = 1.19 at x = 0 */
    values("wall,temperature", s, &p, (double[2]){0, 0}, NULL, 1, v);
    assert_true(v[0] == 1 && isnan(v[3]));
    assert_near(v[1], (0.31 + 1.19) / 2, 1e-16);
    s = odd_find("cube-step", &p);
    p.held[X_HI] = 0.3, p.held[Y_HI] = 0.7, p.held[Z_HI] = 1.1;
    values("wall", s, &p, p.hi, NULL, 1, v);
    assert_near(v[1], 0.7, 1e-15);
    s = odd_find("rod-contact", &p);
    values("wall", s, &p, (double[2]){p.hi[0], 0}, NULL, 1, v);
    assert_true(v[0] == 1 && v[1] == p.wall(&p, X_HI, (double[2]){p.hi[0], 0}, 0));
}

/* On a round wall: from (0.3, 0.4), 0.5 from the centre, the foot is in the direction (0.6, 0.8); on a plane wall
 * one by hand. */
static void the_nearest_wall_is_found(void **state) {
    (void)state;
    struct problem p;
    double v[COLUMNS_VALUES];
    const struct scene *s = odd_find("disc-cooling", &p);
    double R = p.radius[1];
    assert_int_equal(values("nearest", s, &p, (double[2]){0.3, 0.4}, NULL, 1, v), 8);
    const double round[] = {0.6 * R, 0.8 * R, 0.6, 0.8, R - 0.5, 3};
    for (int i = 0; i < 6; i++) assert_near(v[i], round[i], 1e-15);
    assert_near(v[7], p.robin[X_HI], 0);
    s = odd_find("rect-manufactured", &p); /* 0.9 by 0.6, fluxes across y */
    values("nearest", s, &p, (double[2]){0.3, 0.5}, NULL, 1, v);
    const double plane[] = {0.3, 0.6, 0, 1, 0.1, 2};
    for (int i = 0; i < 6; i++) assert_near(v[i], plane[i], 1e-15);
    assert_near(v[6], p.wall(&p, Y_HI, (double[2]){0.3, 0.6}, 0), 0);
}

/* A cell cut by a jump; a Gaussian in wide and narrow cells, and one far narrower than its cell; the plane; a cell
 * that reaches out of the domain is clipped. */
static void cell_means_are_integrals(void **state) {
    (void)state;
    struct problem p;
    double v[3];
    const struct scene *s = odd_find("rod-step", &p); /* 7.3 K for |x| <= 0.62 */
    values("initial_mean", s, &p, (double[2]){0.64, 0}, (double[2]){0.1, 0}, 1, v);
    assert_near(v[0], 7.3 * 0.3, 1e-13);
    values("initial_mean", s, &p, (double[2]){-0.1, 0}, (double[2]){9, 0}, 1, v);
    assert_near(v[0], 7.3 * 0.62 / 1.7, 1e-13);
    s = odd_find("rod-gauss", &p);
    for (double sigma = 0.003; sigma < 3; sigma *= 5)
        for (double dx = 0.001; dx < 5; dx *= 7)
            for (double x = -0.2; x < 3; x += 0.57) {
                p.param[1] = sigma;
                values("initial_mean", s, &p, (double[2]){x, 0}, (double[2]){dx, 0}, 1, v);
                double a = (x - dx / 2) / (sigma * sqrt(2)), b = (x + dx / 2) / (sigma * sqrt(2));
                double integral = a > 0 ? erfc(a) - erfc(b) : erf(b) - erf(a);
                assert_near(v[0], sigma * sqrt(3.14159265358979323846 / 2) * integral / dx,
                            2e-13 + 1e-15 * sigma / dx);
            }
    s = odd_find("square-step", &p); /* 6.1 K for |x| <= 0.47, |y| <= 0.83 */
    values("initial_mean", s, &p, (double[2]){0.46, -0.8}, (double[2]){0.04, 0.1}, 1, v);
    assert_near(v[0], 6.1 * 0.75 * 0.8, 1e-13);
    s = odd_find("rect-manufactured", &p);
    values("initial_mean", s, &p, (double[2]){0.31, 0.23}, (double[2]){1e-3, 1e-3}, 1, v);
    double near = p.initial(&p, (double[2]){0.31, 0.23});
    assert_true(v[0] != near && fabs(v[0] - near) < 1e-5);
    double fine = 0;
    for (int i = 0; i < 64; i++) /* 0.31 +- 0.09, 0.23 +- 0.17 in 64 cells: linear */
        fine += (values("initial_mean", s, &p,
                        (double[2]){0.22 + 0.18 * (i % 8 + 0.5) / 8, 0.06 + 0.34 * (i / 8 + 0.5) / 8},
                        (double[2]){0.18 / 8, 0.34 / 8}, 1, v),
                 v[0] / 64);
    values("initial_mean", s, &p, (double[2]){0.31, 0.23}, (double[2]){0.18, 0.34}, 1, v);
    assert_near(v[0], fine, 1e-14);
}

/* A node on an interface keeps the heat of both sides, weighted with rho c; so does one next to it with a cell
 * across the interface.  The old word has the same value. */
static void cell_means_keep_heat(void **state) {
    (void)state;
    struct problem p;
    double v[2];
    const struct scene *s = odd_find("rod-contact", &p);
    double x_c = p.interface, dx = 0.08, T[2] = {p.initial(&p, (double[2]){x_c - dx, 0}), p.initial(&p, p.hi)};
    double c[2] = {p.material[0].rho_c, p.material[1].rho_c};
    for (double off = -0.4; off < 0.5; off += 0.2) {
        double part[2] = {(0.5 - off) * c[0], (0.5 + off) * c[1]};
        values("initial_heat,initial_mean", s, &p, (double[2]){x_c + off * dx, 0}, (double[2]){dx, 0}, 1, v);
        assert_near(v[1], (part[0] * T[0] + part[1] * T[1]) / (part[0] + part[1]), 5e-11);
        assert_near(v[0], v[1], 0);
    }
    scene_defaults(s, &p); /* rho c of 2 and 0.5, at 1 K and 0 K */
    struct failure why;
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    values("initial_mean", s, &p, (double[2]){0, 0}, (double[2]){dx, 0}, 1, v);
    assert_near(v[0], 0.8, 5e-11); /* points within 1e-12 L of the contact start like the right half */
}

/* Initial data with a kink at the interface: the mean of both parts, to rounding. */
static void interface_splits_a_cell_mean(void **state) {
    (void)state;
    struct problem p;
    double v[2];
    const struct scene *s = odd_find("plane-contact", &p);
    const double cell[2] = {0.3, 0.2}, lo = p.interface - 0.2, hi = p.interface + 0.1, x[2] = {(lo + hi) / 2, 0.31};
    values("initial_mean", s, &p, (double[2]){lo + 0.1, x[1]}, (double[2]){0.2, 0.2}, 1, &v[0]);
    values("initial_mean", s, &p, (double[2]){hi - 0.05, x[1]}, (double[2]){0.1, 0.2}, 1, &v[1]);
    double c[2] = {2 * p.material[0].rho_c, p.material[1].rho_c};
    double want = (c[0] * v[0] + c[1] * v[1]) / (c[0] + c[1]);
    values("initial_mean", s, &p, x, cell, 1, v);
    assert_near(v[0], want, 8e-15);
}

/* The heat within a front on a circle or a sphere, over its volume T_c n/(n + 1) in the plane and, from the beta
 * function, 0.6455 T_c in space for n = 5/2: each cell that the front cuts is off by 1/32^1.4 of its own at
 * most; in space 14^2 lines of points are off by 1/14^1.4 with either sign, 1/14^2.4 of a cell, in 100 cells that
 * have a quarter of the heat: 4e-5. */
static void cells_that_a_curved_front_cuts_keep_heat(void **state) {
    (void)state;
    const double part[] = {0, 0, 2.5 / 3.5, 3 / 2. * tgamma(1.5) * tgamma(1.4) / tgamma(2.9)}, r0 = 0.4, dx = 0.05;
    for (int dim = 2; dim < 4; dim++) {
        struct problem p;
        struct failure why;
        double sum = 0, v;
        const struct scene *s = scene_find("blast");
        scene_defaults(s, &p);
        p.param[0] = dim;
        assert_int_equal(s->setup(&p, &why), STATUS_OK);
        for (int k = 0; k < (dim == 2 ? 81 : 729); k++) {
            double x[3] = {(k % 9 + 0.5) * dx, (k / 9 % 9 + 0.5) * dx, (k / 81 + 0.5) * dx};
            values("initial_mean", s, &p, x, (double[3]){dx, dx, dx}, 0, &v);
            sum += v * pow(dx, dim);
        }
        double whole = dim == 2 ? acos(-1) / 4 * r0 * r0 : acos(-1) / 6 * r0 * r0 * r0;
        assert_near(sum, p.initial(&p, (double[3]){0}) * part[dim] * whole, 1e-4 * sum);
    }
}

/* Places along an axis at which initial data may jump or bend. */
static int find_knots(const struct problem *p, int axis, double knot[JUMP_MAX + 2]) {
    int n = 0;
    for (int j = 0; j < p->jumps[axis]; j++) knot[n++] = p->jump[axis][j];
    if (p->kinked[axis]) knot[n++] = p->kink[axis];
    if (p->materials == 2 && axis == 0) knot[n++] = p->interface;
    return n;
}

/* The mean over [lo, hi] along the axis, in parts between the knots that shrink towards them by 4, by the midpoint
 * rule: exact for pieces that are constant, and to 1e-4 of T in the cell for roots at a front, the last part of 4^-20
 * left out. */
static double split_mean(const struct problem *p, int axis, double *x, double lo, double hi, double knot) {
    enum { PARTS = 20, POINTS = 400 };
    double heat = 0, size = 0;
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < PARTS; k++) {
            double far = side ? hi - knot : lo - knot, from = far * pow(4, -k - 1), to = far * pow(4, -k);
            for (int i = 0; i < POINTS; i++) {
                x[axis] = knot + from + (to - from) * (i + 0.5) / POINTS;
                double c = p->material[p->materials == 2 && axis == 0 && x[0] >= p->interface].rho_c;
                double part = c * fabs(to - from) / POINTS;
                heat += part * p->initial(p, x), size += part;
            }
        }
    return heat / size;
}

/* A cell that a jump, a kink or an interface just enters, from either side, has its part of it. */
static void cells_that_touch_a_knot_see_it(void **state) {
    (void)state;
    static const double part[] = {1e-6, 1e-3, 0.0157, 0.02, 0.5};
    int seen = 0;
    for (int k = 0; scenes[k]; k++) {
        struct problem p;
        double knot[JUMP_MAX + 2], v[1];
        odd_setup(scenes[k], &p);
        if (strcmp(scenes[k]->name, "front") == 0) p.kink[0] = p.param[1] = 0.31, p.kinked[0] = 1; /* x0 < L */
        for (int a = 0; a < p.dim && !p.shape; a++)
            for (int j = 0, n = find_knots(&p, a, knot); j < n; j++)
                for (int i = 0; i < 10; i++) {
                    double size = 0.1, x[DIM_MAX] = {0}, at[DIM_MAX], cell[DIM_MAX], lo, hi;
                    for (int d = 0; d < p.dim; d++) x[d] = at[d] = 0.4 * p.lo[d] + 0.6 * p.hi[d], cell[d] = 1e-5;
                    lo = i < 5 ? knot[j] - part[i] * size : knot[j] - (1 - part[i - 5]) * size;
                    hi = lo + size, at[a] = (lo + hi) / 2, cell[a] = size;
                    values("initial_mean", scenes[k], &p, at, cell, 1, v);
                    double want = split_mean(&p, a, x, lo, hi, knot[j]);
                    if (!(fabs(v[0] - want) <= 1e-4 * fabs(want) + 1e-10 * scenes[k]->odd.scale))
                        fail_msg("%s, axis %d, knot %g, cell %g to %g: mean %.12g, expected %.12g", scenes[k]->name,
                                 a, knot[j], lo, hi, v[0], want);
                    seen++;
                }
    }
    assert_order(seen, >, 100);
}

static char *answered(struct answer *a, const char *text, const char *what) {
    struct failure why = {0};
    char *page = NULL;
    size_t size = 0;
    if (columns_parse(what, a->image->problem.dim, &a->columns, &why)) fail_msg("%s", why.text);
    if (points_text(text, &a->image->problem, &a->points, &why)) fail_msg("%s", why.text);
    if (answer_check(a, &why)) {
        points_free(&a->points);
        return strdup(why.text);
    }
    FILE *out = open_memstream(&page, &size);
    answer_write(a, out);
    fclose(out);
    points_free(&a->points);
    return page;
}

static void times_have_both_ends(void **state) {
    (void)state;
    double time[4];
    answer_times(0.5, 2, 4, time);
    for (int k = 0; k < 4; k++) assert_near(time[k], 0.5 * (k + 1), 0);
}

static void answers_are_csv(void **state) {
    (void)state;
    static const double when[] = {0.25, 1.75, 0};
    static const struct {
        int times, from;
        double cell;
        const char *what, *says;
    } asked[] = {
        {0, 0, 0, "k_x,rho_c", "x,k_x,rho_c\n0.30,0.017000000000000001,1\n1.2,0.017000000000000001,1\n"},
        {0, 0, 0, "temperature", "--what temperature needs --time"},
        {0, 0, 0, "initial_mean", "--what initial_mean needs the cell around each point"},
        {1, 2, 0, "flux_x", "--time 0: --what flux_x needs a time > 0"},
        {2, 0, 0, "wall", "x,time,wall_kind,wall_value,wall_b\n0.30,0.25,0,0,0\n1.2,0.25,0,0,0\n0.30,1.75,0,0,0\n"},
    };
    struct problem p;
    const struct scene *s = odd_find("rod-cosine", &p);
    struct problem made;
    const struct scene *changing = odd_find("rect-manufactured", &made);
    struct image image, other;
    mapping_image(&(struct mapping){0}, &made, &other);
    mapping_image(&(struct mapping){0}, &p, &image);
    struct answer untimed = {.scene = changing, .image = &other};
    char *refused = answered(&untimed, "x,y\n0.3,0.2\n", "source");
    assert_int_equal(strncmp(refused, "--what source depends on time here", 34), 0);
    free(refused);
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
        struct answer a = {.scene = s,
                           .image = &image,
                           .times = asked[i].times,
                           .time = when + asked[i].from,
                           .cell = asked[i].cell};
        char *text = answered(&a, "note,x\nhot,0.30\n,1.2\n", asked[i].what);
        if (strncmp(text, asked[i].says, strlen(asked[i].says)) != 0)
            fail_msg("\"%s\" is not \"%s\"", text, asked[i].says);
        free(text);
    }
}

/* Within 1e-9 of the extent: at the side, and shown there; to rounding: as typed. */
static void snapped_points_are_printed_on_the_side(void **state) {
    (void)state;
    struct problem p;
    struct image image;
    const struct scene *s = odd_find("rod-cosine", &p);
    mapping_image(&(struct mapping){0}, &p, &image);
    struct answer a = {.scene = s, .image = &image};
    char *text = answered(&a, "x\n1.2999999995\n1.30\n1.2999\n", "rho_c");
    assert_string_equal(text, "x,rho_c\n1.3,1\n1.30,1\n1.2999,1\n");
    free(text);
    struct problem plane; /* about 0, 1.9 m each way; the last digit of 1.9000000000000004 is rounding */
    struct image of_plane;
    a.scene = odd_find("square-step", &plane), a.image = &of_plane;
    mapping_image(&(struct mapping){0}, &plane, &of_plane);
    text = answered(&a, "x,y\n1.9000000000000004,-1.90000000000001\n-1.90,1.9000000000000004\n", "rho_c");
    assert_string_equal(text, "x,y,rho_c\n1.9000000000000004,-1.8999999999999999,1\n-1.90,1.9000000000000004,1\n");
    free(text);
}

/* The exact solution is asked for by thousands of points: each gets its own, to the digit. */
static void many_points_are_independent(void **state) {
    (void)state;
    enum { N = 5000 };
    const double time = 0.7;
    struct problem p;
    const struct scene *s = odd_find("plate-cooling", &p);
    struct image image;
    mapping_image(&(struct mapping){0}, &p, &image);
    struct answer a = {.scene = s, .image = &image, .times = 1, .time = &time};
    char *points = xcalloc(40, N), *at = points + sprintf(points, "x,y\n");
    for (int i = 0; i < N; i++) at += sprintf(at, "%.6f,%.6f\n", p.hi[0] * (i % 97) / 97, p.hi[1] * (i % 89) / 89);
    char *text = answered(&a, points, "temperature"), *line = strchr(text, '\n') + 1;
    for (int i = 0; i < N; i++, line = strchr(line, '\n') + 1) {
        double x[2], T;
        if (sscanf(line, "%lf,%lf,%lf", &x[0], &x[1], &T) != 3) fail_msg("point %d: \"%.40s\"", i, line);
        if (i % 83 == 0) assert_near(T, scene_exact(s, &p, x, time).temperature, 1e-12);
    }
    free(text);
    free(points);
}

/* Average of the initial data over the part of a cell inside a round body, by the midpoint rule on a grid: the wall
 * cuts 4 N of its N^2 squares, which are in or out at random: within about (4 N)^0.5/N^2 of the
 * field's range in the cell. */
static void cells_cut_by_a_round_wall_have_a_mean(void **state) {
    (void)state;
    enum { N = 600 };
    static const struct {
        const char *scene;
        double x[2], half;
    } cell[] = {
        {"disc-mode", {0.95, 0.05}, 0.05},  {"disc-mode", {0.65, 0.75}, 0.05}, {"disc-mode", {-0.72, -0.68}, 0.05},
        {"disc-mode", {0.05, -0.99}, 0.05}, {"disc-mode", {-0.4, 0.7}, 0.35},  {"annulus", {-0.25, 0.3}, 0.05},
        {"annulus", {0.72, -0.68}, 0.05},   {"annulus", {0.03, 0.42}, 0.05},   {"annulus", {0.75, 0}, 0.36}};
    for (size_t c = 0; c < sizeof cell / sizeof *cell; c++) {
        struct problem p;
        struct failure why;
        const struct scene *s = scene_find(cell[c].scene);
        double v[COLUMNS_VALUES], h = cell[c].half, sum = 0, lo = INFINITY, hi = -INFINITY;
        int count = 0;
        scene_defaults(s, &p);
        if (s->setup(&p, &why)) fail_msg("%s", why.text);
        values("initial_mean", s, &p, cell[c].x, (const double[2]){2 * h, 2 * h}, 0, v);
        for (int i = 0; i < N * N; i++) {
            double x[2] = {cell[c].x[0] + h * (2 * (i % N + 0.5) / N - 1),
                           cell[c].x[1] + h * (2 * (i / N + 0.5) / N - 1)};
            double r = hypot(x[0], x[1]), T;
            if (r < p.radius[0] || r > p.radius[1]) continue;
            T = p.initial(&p, x);
            sum += T, count++;
            lo = fmin(lo, T), hi = fmax(hi, T);
        }
        assert_order(count, <, N * N); /* the wall cuts the cell */
        assert_near(v[0], sum / count, 4 * sqrt(4. * N) / count * (hi - lo));
    }
}

/* A mean over a cell is the mean over its parts, weighted by their volumes inside the body, to round-off: ends of
 * the wall inside the cell, where its slope is undefined, do not reduce the accuracy. */
static void cell_means_are_additive(void **state) {
    (void)state;
    enum { PARTS = 5 };
    struct problem p;
    struct failure why;
    double v[COLUMNS_VALUES], size = 0.9 / PARTS;
    const double cell[][2] = {{0.97, 0.2}, {-0.97, -0.2}, {0.2, -0.97}};
    const struct scene *s = scene_find("disc-mode");
    scene_defaults(s, &p);
    if (s->setup(&p, &why)) fail_msg("%s", why.text);
    for (int c = 0; c < 3; c++) {
        double sum = 0, area = 0;
        for (int i = 0; i < PARTS * PARTS; i++) {
            double at[2] = {cell[c][0] + (i % PARTS - 2) * size, cell[c][1] + (i / PARTS - 2) * size};
            double lo[2] = {at[0] - size / 2, at[1] - size / 2}, hi[2] = {at[0] + size / 2, at[1] + size / 2};
            double part = shape_clipped(&p, lo, hi);
            if (part < 1e-12) continue;
            values("initial_mean", s, &p, at, (const double[2]){size, size}, 0, v);
            sum += part * v[0], area += part;
        }
        values("initial_mean", s, &p, cell[c], (const double[2]){0.9, 0.9}, 0, v);
        assert_near(v[0], sum / area, 1e-12);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lists_of_columns_are_checked),
        cmocka_unit_test(oracle_columns_equal_the_scene),
        cmocka_unit_test(wall_columns_give_kind_and_value),
        cmocka_unit_test(the_nearest_wall_is_found),
        cmocka_unit_test(cell_means_are_integrals),
        cmocka_unit_test(cell_means_keep_heat),
        cmocka_unit_test(interface_splits_a_cell_mean),
        cmocka_unit_test(cells_that_a_curved_front_cuts_keep_heat),
        cmocka_unit_test(cells_that_touch_a_knot_see_it),
        cmocka_unit_test(times_have_both_ends),
        cmocka_unit_test(answers_are_csv),
        cmocka_unit_test(snapped_points_are_printed_on_the_side),
        cmocka_unit_test(many_points_are_independent),
        cmocka_unit_test(cells_cut_by_a_round_wall_have_a_mean),
        cmocka_unit_test(cell_means_are_additive),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("oracle", tests, NULL, NULL);
}
