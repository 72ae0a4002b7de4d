/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derived quantities of the exact solutions: heat in balance with fluxes and source, known values, infinite fluxes.
 */
#include "references/quantity.h"

#include "references/series.h"
#include "verification/unit/odd_scenes.h"

#include <float.h>
#include <string.h>

#include <gsl/gsl_errno.h>

static struct quantity_value of(const char *name, const struct scene *s, const struct problem *p, double t) {
    struct quantity q;
    struct failure why = {0};
    if (quantity_read(name, p, &q, &why)) fail_msg("%s", why.text);
    return quantity_exact(&q, s, p, t);
}

static double source_of(const struct problem *p, double t) { /* the integral over the body, by Gauss's rule of two */
    const int N = p->dim == 3 ? 100 : 400, all = N * N * (p->dim == 3 ? N : 1);
    double sum = 0, volume = 1;
    for (int a = 0; a < p->dim; a++) volume *= p->hi[a] - p->lo[a];
    for (int i = 0; (p->source || p->source_at) && i < all; i++) {
        double x[DIM_MAX] = {0};
        for (int a = 0, at[DIM_MAX] = {i % N, i / N % N, i / N / N}; a < p->dim; a++) /* two in each of N/2 parts */
            x[a] = p->lo[a] + (at[a] / 2 * 2 + 1 + (at[a] % 2 ? 1 : -1) / sqrt(3)) / N * (p->hi[a] - p->lo[a]);
        if (p->shape) { /* box of r and theta */
            double whole = p->hi[0] - p->lo[0],
                   r = p->radius[0] + (x[0] - p->lo[0]) / whole * (p->radius[1] - p->radius[0]);
            double theta = 2 * M_PI * (x[1] - p->lo[1]) / whole, polar[2] = {r * cos(theta), r * sin(theta)};
            sum += problem_source(p, polar, t) * r * 2 * M_PI * (p->radius[1] - p->radius[0]) / (N * N);
            continue;
        }
        sum += problem_source(p, x, t) * volume / all;
    }
    return sum;
}

/* d(heat)/dt = sum of the fluxes in + source, by differences of sixth order in time: heat comes from temperatures, a
 * Dirichlet side's flux from gradients. */
static void insulated_bodies_keep_their_heat(void **state) {
    (void)state;
    static const char *const flat[] = {"flux_x_lo", "flux_x_hi", "flux_y_lo", "flux_y_hi", "flux_z_lo", "flux_z_hi"};
    static const char *const round[] = {"flux_r_lo", "flux_r_hi"};
    static const double weight[] = {0, 0.75, -0.15, 1.0 / 60};
    for (const struct scene *const *s = scenes; *s; s++) {
        struct problem p;
        odd_setup(*s, &p);
        if (p.k_law == K_PHASES) continue;    /* latent heat too: refused */
        if (strcmp((*s)->name, "plate") == 0) /* sides that agree: else their fluxes are infinite */
            p.param[2] = p.param[3] = p.param[4] = p.param[5];
        double t = 0.6 * p.t_end, dt = 0.02 * t, rate = 0, in = source_of(&p, t), size = fabs(in), error = 0;
        for (int i = 1; i <= 3; i++)
            for (int side = -1; side <= 1; side += 2) {
                struct quantity_value heat = of("heat", *s, &p, t + side * i * dt);
                rate += side * weight[i] * heat.value / dt;
                error += weight[1] * heat.error_bound / dt;
                if (i == 1) size += fabs(heat.value) / (2 * t);
            }
        for (int i = 0; i < 2 * p.dim; i++) {
            if (!shape_has_wall(&p, i)) continue;
            struct quantity_value through = of((p.shape ? round : flat)[i], *s, &p, t);
            in += through.value;
            size += fabs(through.value);
            error += through.error_bound;
        }
        print_message("%-18s d(heat)/dt = %.6g, in %.6g\n", (*s)->name, rate, in);
        assert_near(rate, in, 1e-7 * size + 3 * error); /* (dt/t)^6 times a constant below 2000 */
        assert_order(error, <, 1e-6 * size);
    }
}

/* The bound of the heat: if every box is fine enough, its rules differ by 1e-14 |T|, sums round to 8 eps |T|, and the
 * rest is the bound of the temperatures; in space the rules differ by 1e-10
 * |T|, of a ball times r^2 sin(theta) over a box of angles of 4.7 times its volume.  Boxes are graded down to 4^-12
 * of a plate; kappa t is above that. */
/* T there is the melting point, and s^2 is linear in time. */
static void front_is_at_the_melting_point(void **state) {
    (void)state;
    struct problem p;
    const struct scene *s = odd_find("melt", &p);
    struct quantity_value end = of("front", s, &p, p.t_end), start = of("front", s, &p, 0);
    assert_near(start.value, p.param[1], 1e-14);
    assert_near(scene_exact(s, &p, &end.value, p.t_end).temperature, p.k_ref, 1e-14);
    assert_order(end.error_bound, <, 1e-11);
    double half = of("front", s, &p, p.t_end / 2).value;
    assert_near(2 * half * half, start.value * start.value + end.value * end.value, 1e-13);
}

/* A scene at its odd parameters, with the front in the body: its parameter `at` is `place`. */
static const struct scene *with_front(const char *name, int at, double place, struct problem *p) {
    static struct scene within;
    within = *scene_find(name);
    within.odd.param[at] = place;
    odd_setup(&within, p);
    return &within;
}

/* T is 0 beyond it and not before it; r_f^(n d + 2) of a blast is linear in time, x of a front that a wall drives. */
static void front_is_where_conduction_ends(void **state) {
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct problem p;
        const struct scene *s = i == 0 ? with_front("blast", 2, 0.37, &p) : with_front("front", 1, 0.37, &p);
        const double power = i == 0 ? p.k_n * p.dim + 2 : 1;
        double at[3];
        for (int k = 0; k < 3; k++) {
            const struct quantity_value v = of("front", s, &p, k * p.t_end / 2);
            double x[DIM_MAX] = {v.value};
            assert_order(v.error_bound, <, 1e-13);
            assert_true(scene_exact(s, &p, x, k * p.t_end / 2).temperature > 0);
            x[0] += 1e-12;
            assert_near(scene_exact(s, &p, x, k * p.t_end / 2).temperature, 0, 0);
            at[k] = pow(v.value, power);
        }
        assert_near(2 * at[1], at[0] + at[2], 1e-11);
    }
}

static void heat_bound_covers_narrow_features(void **state) {
    (void)state;
    for (const struct scene *const *s = scenes; *s; s++) {
        struct problem p;
        odd_setup(*s, &p);
        if (p.k_law == K_PHASES) continue; /* latent heat too: refused */
        int parts = p.dim == 3 ? 8 : 10, all = (int)pow(parts + 1, p.dim);
        double whole = shape_volume(&p);
        double rho_c = fmax(p.material[0].rho_c, p.material[1].rho_c);
        for (double t = (p.dim == 3 ? 0.6 : 1e-10) * p.t_end; t < 2 * p.t_end; t *= 1e8) {
            double most = 0, unknown = 0;
            for (int k = 0; k < all; k++) {
                double x[DIM_MAX];
                for (int a = 0, rest = k; a < DIM_MAX; a++, rest /= parts + 1)
                    x[a] = p.lo[a] + rest % (parts + 1) * (p.hi[a] - p.lo[a]) / parts;
                if (shape_depth(&p, x) < 0) continue;
                struct exact e = scene_exact(*s, &p, x, t);
                if (e.no_value) continue;
                most = fmax(most, fabs(e.temperature)), unknown = fmax(unknown, e.error_bound);
            }
            double bound = of("heat", *s, &p, t).error_bound;
            assert_near(bound, 0,
                        whole * rho_c * (most * ((p.dim == 3 ? 5e-10 : 1e-14) + 8 * DBL_EPSILON) + unknown));
        }
    }
}

/* By quadrature of the exact forms in 30 digits. */
static void known_values(void **state) {
    (void)state;
    static const struct {
        const char *scene, *quantity;
        double t, value;
    } known[] = {
        {"rod-step", "heat", 2.385, 9.0519889300850331546},
        {"rod-step", "flux_x_hi", 31.7, -0.037918604139578366584},
        {"rod-gauss", "heat", 4.3, 4.7625935902234183701},
        {"square-step", "heat", 3.7, 9.5184333685508621286},
        {"square-step", "flux_y_lo", 170, -0.0032554797055087294106},
        {"wall-composite", "heat", 0.4, 0.58395253844801412},
        {"wall-composite", "flux_x_lo", 0.4, 0.049974917348278331},
        {"rod-cooling", "heat", 450, 74022878.979507157},
        {"rod-cooling", "flux_x_lo", 450, -19060.295738334468},
        {"rod-cooling", "flux_x_hi", 450, -21089.033882998277},
        {"cube-step", "heat", 3.7, 11.612487880624660298},
        {"cube-step", "flux_z_hi", 170, -0.0021568464093695450241},
        {"cube-step", "flux_y_lo", 170, -0.0016443790513188274607},
        {"ball-cooling", "heat", 11, 12.986451344630909565},
        {"ball-cooling", "flux_r_hi", 11, -0.27112008571838913578},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        struct problem p;
        const struct scene *s = odd_find(known[i].scene, &p);
        struct quantity_value v = of(known[i].quantity, s, &p, known[i].t);
        assert_near(v.value, known[i].value, v.error_bound);
        assert_order(v.error_bound, <, (p.dim == 3 ? 1e-9 : 1e-11) * fabs(v.value) + 1e-13 * s->odd.scale);
    }
}

/* All its sides hold 0.9 K. */
static const struct scene *plate_of_sides_alike(struct problem *p) {
    const struct scene *s = odd_find("plate", p);
    for (int i = 2; i <= 5; i++) p->param[i] = 0.9;
    return s;
}

/* The difference from 0.9 K is a product of two boxes with means that are sums over modes. */
static void plate_heat_equals_its_series(void **state) {
    (void)state;
    struct problem p;
    const struct scene *s = plate_of_sides_alike(&p);
    double kappa = p.material[0].k[0] / p.material[0].rho_c;
    for (double t = 0.02; t < 200; t *= 49) {
        double mean[2] = {0, 0};
        for (int a = 0; a < 2; a++)
            for (int n = 1; n < 4000; n += 2) {
                double q = n * 3.14159265358979323846, decay = kappa * t * q * q / (p.hi[a] * p.hi[a]);
                mean[a] += 8 / (q * q) * exp(-decay);
            }
        double want = p.material[0].rho_c * p.hi[0] * p.hi[1] * (0.9 + (0.11 - 0.9) * mean[0] * mean[1]);
        struct quantity_value v = of("heat", s, &p, t);
        assert_near(v.value, want, v.error_bound + 1e-9 * want * (t < 0.1));
        assert_order(v.error_bound, <, 1e-11 * want);
    }
}

static void an_infinite_value_is_no_value(void **state) {
    (void)state;
    static const char *const flux[] = {"flux_x_lo", "flux_x_hi", "flux_y_lo", "flux_y_hi"};
    struct problem p;
    const struct scene *s = odd_find("plate", &p);
    for (int i = 0; i < 4; i++) assert_true(of(flux[i], s, &p, 20).no_value);
    assert_true(of("at:0,0", s, &p, 20).no_value);
    struct quantity_value v = of("at:0.031,0.017", s, &p, 23.7);
    assert_near(v.value, 0.30308057558458555, v.error_bound);
    p.param[2] = p.param[5]; /* T1 = T4: two corners still disagree */
    assert_true(!of("at:0,0", s, &p, 20).no_value && of("flux_x_lo", s, &p, 20).no_value);
    assert_int_equal(of("heat", s, &p, 20).no_value, 0);
}

/* One side is at another temperature than the rest: in its own corners, which are those of its neighbours too, the
 * flux is infinite; only the side across from it has none of them. */
static void a_flux_between_corners_that_agree_has_a_value(void **state) {
    (void)state;
    static const char *const flux[] = {"flux_x_lo", "flux_x_hi", "flux_y_lo", "flux_y_hi"};
    static const int T[] = {5, 3, 2, 4}; /* parameters, by side */
    for (int k = 0; k < 8; k++) {
        struct problem p;
        struct scene plate = *scene_find("plate");
        int hot = k % 4;
        plate.odd.param[0] = k < 4 ? 0.13 : 0.05; /* wider and less wide than high */
        for (int i = 0; i < 4; i++) plate.odd.param[T[i]] = i == hot ? 1.3 : 0.7;
        odd_setup(&plate, &p);
        for (int i = 0; i < 4; i++)
            assert_int_equal(of(flux[i], &plate, &p, 20).no_value, i != (hot ^ 1)); /* hot ^ 1: across */
    }
}

static void words_are_checked(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } bad[] = {
        {"flux_y_lo", "unknown quantity 'flux_y_lo' (valid: flux_x_lo, flux_x_hi, heat, at:X)"},
        {"at:", "needs one number"},
        {"at:0.1,0.2", "needs one number"},
        {"at:nan", "needs one number"},
        {"at:1.4", "x = 1.4 m is outside 0 to 1.3 m"},
        {"", "unknown quantity"},
    };
    struct problem p;
    struct quantity q;
    struct failure why = {0};
    odd_find("rod-cosine", &p);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_int_equal(quantity_read(bad[i].text, &p, &q, &why), STATUS_INPUT);
        if (!strstr(why.text, bad[i].says)) fail_msg("\"%s\" lacks \"%s\"", why.text, bad[i].says);
    }
    assert_int_equal(quantity_read("flux_x_hi", &p, &q, &why), STATUS_OK);
    assert_true(q.kind == QUANTITY_FLUX && q.side == X_HI);
    assert_string_equal(quantity_unit(&q, &p), "W/m^2");
    odd_find("plate", &p);
    assert_string_equal(quantity_unit(&q, &p), "W/m");
    assert_int_equal(quantity_read("at:0.1,0.02", &p, &q, &why), STATUS_OK);
    assert_near(q.at[1], 0.02, 0);
    assert_int_equal(quantity_read("at:0.1", &p, &q, &why), STATUS_INPUT);
    assert_has(why.text, "needs X,Y, such as at:0.1,0.2");
    assert_int_equal(quantity_read("front", &p, &q, &why), STATUS_INPUT); /* no front here */
    with_front("blast", 2, 0.37, &p);
    assert_int_equal(quantity_read("front_diagonals", &p, &q, &why), STATUS_OK);
    assert_true(q.kind == QUANTITY_FRONT && q.sector == FRONT_DIAGONALS);
    odd_find("blast", &p); /* the body is behind the front */
    assert_int_equal(quantity_read("front", &p, &q, &why), STATUS_INPUT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(insulated_bodies_keep_their_heat),
        cmocka_unit_test(known_values),
        cmocka_unit_test(front_is_at_the_melting_point),
        cmocka_unit_test(front_is_where_conduction_ends),
        cmocka_unit_test(heat_bound_covers_narrow_features),
        cmocka_unit_test(plate_heat_equals_its_series),
        cmocka_unit_test(an_infinite_value_is_no_value),
        cmocka_unit_test(a_flux_between_corners_that_agree_has_a_value),
        cmocka_unit_test(words_are_checked),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("quantities", tests, NULL, NULL);
}
