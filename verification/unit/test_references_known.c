/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values known to 20 digits from the defining series in 40-digit arithmetic, at odd and at extreme parameters; NAFEMS
 * T4; the errors of the forms as printed. */
#include "verification/unit/odd_scenes.h"

#include <string.h>

#include <gsl/gsl_errno.h>

static const struct known {
    const char *scene;
    double x[DIM_MAX], t, T; /* m, s, K */
} known[] = {
    /* sum over |k| <= 60 of (-1)^k T0/2 (erf((a+x-2kL)/s) + erf((a-x+2kL)/s)) */
    {"rod-step", {0.35, 0}, 2.385, 6.284029041367498094},
    {"rod-step", {1.61, 0}, 2.385, 0.00024665316336791097583},
    {"rod-step", {-0.9, 0}, 190, 0.41199430855696426205},
    /* sum over |k| <= 30 of (-1)^k sigma0/sigma exp(-(x-2kL)^2/(2 sigma^2)) */
    {"rod-gauss", {2.7, 0}, 4.3, 0.37148543168177662135},
    {"rod-gauss", {-7.7, 0}, 5100, 0.03233663807057812456},
    /* product of two such box sums */
    {"square-step", {0.51, -0.77}, 3.7, 1.648196930741433049},
    /* T0 + sum_i (T_i - T0) sum over odd n of 4/(n pi) sin(r eta) (sinh(r (W-xi))/sinh(r W)
     *    - 2/W sum_m q/(q^2+r^2) sin(q xi) exp(-(q^2+r^2) alpha t)),  n to 4000, m to 1e-32 */
    {"plate", {0.031, 0.017}, 23.7, 0.30308057558458555081},
    {"plate", {0.118, 0.059}, 2.1, 0.18956335442148398058},
    {"plate", {0.004, 0.067}, 0.9, 0.65582880270356441836},
    /* Tc = (e1 T1 + e2 T2)/(e1 + e2), e = sqrt(k rho_c); Tc + (T_i - Tc) erf(|x - x_c|/sqrt(4 k t/rho_c)) */
    {"rod-contact", {0.13, 0}, 1.1, 0.78214222925527952519},
    {"rod-contact", {0.06, 0}, 1.1, 0.84166383300943714102},
    {"rod-contact", {0.18, 0}, 1.1, 0.5045254040176167147},
    /* T1 - q x/k1 and T2 + q (L-x)/k2, q = 0.9/(0.37/0.9 + 0.73/0.013) */
    {"wall-composite", {0.2, 0}, 4, 1.1964642420029917952},
    {"wall-composite", {0.8, 0}, 4, 0.66717486892008280322},
    /* the closed forms of the opening comments */
    {"rod-cosine", {0.23, 0}, 1.7, 1.2353781717793297199},
    {"rect-manufactured", {0.31, 0.23}, 1.3, 1.9643947954701391570},
    /* the closed forms, Bessel functions by mpmath, roots of their conditions; disc-cooling: 89 modes */
    {"wave", {0.31, 0.87}, 1.3, 1.109229038474516135},
    {"oblique", {0.31, 0.87}, 1.3, 1.1266938538323705352},
    {"disc-mode", {0.7, 0.4}, 1.1, 2.1045280976087505546},
    {"disc-mode", {-0.9, 0.81}, 1.6, 2.3346184466530895198},
    {"annulus", {0.3, 0.55}, 1.1, 2.097694237169056175},
    {"annulus", {-0.9, 0.81}, 1.6, 2.28476637578858675},
    /* the closed form, its root by bisection in 50 digits */
    {"plane-contact", {0.21, 0.13}, 1.1, 2.1170145913975644302},
    {"plane-contact", {0.71, 0.67}, 1.6, 2.3445065874889198088},
    {"disc-cooling", {0.7, 0.4}, 11, 0.87659966183455767969},
    {"disc-cooling", {-0.9, 0.81}, 2.9, 0.82155498777606945895},
    /* sums of images; the closed forms, their roots in 50 digits; ball-cooling: modes to exp(-100) */
    {"cube-step", {0.51, -0.77, 0.33}, 3.7, 1.4123728606428222335},
    {"cube-step", {-1.2, 0.4, 1.3}, 170, 0.011810003990403987639},
    {"box-cosine", {0.31, 0.23, 0.87}, 1.3, 1.1021936269314210626},
    {"box-manufactured", {0.31, 0.23, 0.57}, 1.3, 1.4682865545971352057},
    {"box-contact", {0.21, 0.13, 0.31}, 1.1, 2.101296753270614816},
    {"box-contact", {0.71, 0.67, 0.05}, 1.6, 2.308328177408680692},
    {"ball-cooling", {0.7, 0.4, -0.5}, 11, 0.78280320415800125536},
    {"ball-cooling", {-0.9, 0.3, 0.81}, 2.9, 0.77590219129766525089},
    {"ball-cooling", {0, 0, 0}, 40, 0.62228015745296463188},
    {"ball-mode", {0.7, 0.4, -0.5}, 1.1, 2.0359015577769639663},
    {"ball-mode", {-0.9, 0.3, 0.81}, 1.6, 2.1887616573946827044},
    /* the closed forms in 60 digits */
    {"rod-driven", {0.31, 0}, 2.3, 2.7398288047684185057},
    {"plate-driven", {0.31, 0.23}, 2.3, 2.4327195067972472764},
};

static void known_values(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        struct problem p;
        const struct scene *s = odd_find(known[i].scene, &p);
        struct exact e = scene_exact(s, &p, known[i].x, known[i].t);
        assert_near(e.temperature, known[i].T, 1e-13 * s->odd.scale);
        assert_near(e.temperature, known[i].T, e.error_bound);
        if (known[i].t <= p.t_end) {
            struct exact f = s->second(&p, known[i].x, known[i].t);
            assert_near(f.temperature, known[i].T, f.error_bound);
        }
    }
}

/* ---- Extreme parameters: sums, integrals and inversions in 45 digits (mpmath 1.3), from the data of the problem and
 * not from the form that the scene uses.  Arguments are the doubles written here. ---- */

static const struct extreme {
    const char *scene;
    double param[PARAM_MAX];
    double x[DIM_MAX], t, T;  /* m, s, K */
    double gradient[DIM_MAX]; /* K/m; NAN where not known */
} extreme[] = {
#include "verification/unit/known_extreme.inc"
};

static double scale_of(const struct scene *s, const struct problem *p) {
    double scale = 0;
    for (int i = 0; s->params[i].name; i++)
        if (strcmp(s->params[i].unit, "K") == 0) scale = fmax(scale, fabs(p->param[i]));
    return scale > 0 ? scale : 1;
}

static void extreme_setup(const struct extreme *k, const struct scene **s, struct problem *p) {
    struct failure why = {0};
    *s = scene_find(k->scene);
    assert_non_null(*s);
    scene_defaults(*s, p);
    memcpy(p->param, k->param, sizeof p->param);
    if ((*s)->setup(p, &why)) fail_msg("%s: %s", k->scene, why.text);
}

static void extreme_values_hold_within_their_bounds(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof extreme / sizeof *extreme; i++) {
        const struct extreme *k = &extreme[i];
        const struct scene *s;
        struct problem p;
        extreme_setup(k, &s, &p);
        struct exact e = scene_exact(s, &p, k->x, k->t), f = s->second(&p, k->x, k->t);
        double scale = scale_of(s, &p), off = fabs(e.temperature - k->T);
        if (!(off <= e.error_bound)) print_error("row %zu, %s at t = %g: off %g\n", i, k->scene, k->t, off);
        assert_near(e.temperature, k->T, e.error_bound);
        assert_near(f.temperature, k->T, f.error_bound);
        assert_order(e.error_bound, <=, 3e-13 * scale);
        for (int a = 0; a < p.dim; a++) {
            if (isnan(k->gradient[a])) continue;
            assert_near(e.gradient[a], k->gradient[a], e.gradient_bound[a]);
        }
    }
}

/* A pulse far narrower than s is small everywhere, and the bound is of its size: 3e-14 of the largest temperature. */
static void bounds_of_small_pulses_are_small(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof extreme / sizeof *extreme; i++) {
        const struct extreme *k = &extreme[i];
        const struct scene *s;
        struct problem p;
        if (strcmp(k->scene, "rod-step") && strcmp(k->scene, "square-step")) continue;
        extreme_setup(k, &s, &p);
        double peak = scene_exact(s, &p, (double[2]){0, 0}, k->t).temperature;
        assert_order(scene_exact(s, &p, k->x, k->t).error_bound, <=, 3e-14 * peak);
    }
}

/* Heisler's one-term values for spheres in four digits (Incropera et al. 2007, table 5.1): theta = C1 exp(-z^2 Fo) at
 * the centre, times sin z/z at the surface; Fo = 0.5. */
static void cooled_balls_follow_heisler(void **state) {
    (void)state;
    static const double row[][3] = {{0.1, 0.5423, 1.0298}, {1, 1.5708, 1.2732}, {10, 2.8363, 1.9249}}; /* Bi, z, C1 */
    const struct scene *s = scene_find("ball-cooling");
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct problem p;
        struct failure why;
        double z = row[i][1], centre = row[i][2] * exp(-z * z / 2);
        scene_defaults(s, &p);
        p.param[5] = row[i][0] * p.param[1] / p.param[0];
        assert_int_equal(s->setup(&p, &why), STATUS_OK);
        double t = 0.5 * p.radius[1] * p.radius[1] * p.material[0].rho_c / p.material[0].k[2];
        assert_near(scene_exact(s, &p, (double[DIM_MAX]){0}, t).temperature, centre, 5e-4 * centre);
        double surface = centre * sin(z) / z, at[DIM_MAX] = {0, 0.6 * p.radius[1], -0.8 * p.radius[1]};
        assert_near(scene_exact(s, &p, at, t).temperature, surface, 5e-4 * surface);
    }
}

/* j_1(s) = s/3 - ..., and Y_1m = sqrt(3/(4 pi)) times z/r for m = 0, x/r for m = 1. */
static void gradients_hold_at_the_centre_of_a_ball(void **state) {
    (void)state;
    const double centre[DIM_MAX] = {0};
    for (int m = 0; m < 2; m++) {
        struct problem p;
        struct scene s = *scene_find("ball-mode");
        s.odd.param[3] = 1, s.odd.param[8] = m;
        odd_setup(&s, &p);
        double lambda = p.param[10], amplitude = p.param[5] * sqrt(3 / (4 * M_PI)) * lambda / (3 * p.radius[1]);
        struct exact e = scene_exact(&s, &p, centre, 0);
        assert_near(e.temperature, p.param[4], e.error_bound);
        for (int a = 0; a < 3; a++) assert_near(e.gradient[a], a == (m ? 0 : 2) ? amplitude : 0, e.gradient_bound[a]);
    }
    struct problem p;
    const struct scene *s = odd_find("ball-cooling", &p);
    for (double t = 0.01; t < 20; t *= 9)
        for (int a = 0; a < 3; a++) assert_near(scene_exact(s, &p, centre, t).gradient[a], 0, 0);
}

/* With diffusivity zero along an axis the middle of the brick along it stays hot. */
static void slow_axes_leave_a_square_and_a_rod(void **state) {
    (void)state;
    struct problem p, q, r;
    const struct scene *cube = odd_find("cube-step", &p), *square = scene_find("square-step"),
                       *rod = scene_find("rod-step");
    struct failure why;
    const double *v = p.param, slow = 1e-6;
    scene_defaults(square, &q);
    scene_defaults(rod, &r);
    memcpy(q.param, (double[]){v[0], v[1], v[2], v[4], v[5], v[7], v[8]}, 7 * sizeof(double));
    memcpy(r.param, (double[]){v[0], v[1], v[4], v[7], v[8]}, 5 * sizeof(double));
    p.param[6] = slow;
    assert_int_equal(cube->setup(&p, &why) || square->setup(&q, &why) || rod->setup(&r, &why), STATUS_OK);
    for (int i = 0; i < 20; i++) {
        double x[DIM_MAX] = {-1.7 + 0.17 * i, 1.1 - 0.13 * i, 0}, t = 3.7;
        struct exact a = scene_exact(cube, &p, x, t), b = scene_exact(square, &q, x, t);
        assert_near(a.temperature, b.temperature, a.error_bound + b.error_bound);
        struct problem bar = p;
        bar.param[5] = slow, x[1] = 0;
        a = scene_exact(cube, &bar, x, t), b = scene_exact(rod, &r, x, t);
        assert_near(a.temperature, b.temperature, a.error_bound + b.error_bound);
    }
}

static void plate_of_the_paper(void **state) {
    (void)state;
    struct problem p;
    struct failure why;
    const struct scene *s = scene_find("plate");
    scene_defaults(s, &p);
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    assert_near(scene_exact(s, &p, (double[2]){0.05, 0.05}, 28.8894).temperature, 0.26102989127156064378, 1e-14);
    /* steady, the middle of a square is the mean of its sides */
    assert_near(scene_exact(s, &p, (double[2]){0.05, 0.05}, 1e5).temperature, 0.625, 1e-14);
}

/* Published to four digits: test T4 of the standard NAFEMS benchmarks. */
static void nafems_t4(void **state) {
    (void)state;
    struct problem p;
    struct failure why;
    const struct scene *s = scene_find("plate-cooling");
    const double x[2] = {0.6, 0.2};
    scene_defaults(s, &p);
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    assert_near(scene_exact(s, &p, x, 2.5e5).temperature, 18.25, 0.005);
    assert_near(scene_exact(s, &p, x, 2.5e5).temperature, scene_exact(s, &p, x, 1e9).temperature, 1e-12);
    assert_order(scene_exact(s, &p, x, 6000).temperature, <, 17);
}

/* T at t = 0 of rect-manufactured in long double: near x = width sin turns through a whole period, and the rounding
 * of its argument is several times the rest of the bound. */
static void bound_holds_near_a_full_period(void **state) {
    (void)state;
    const struct scene *s = scene_find("rect-manufactured");
    const long double pi = 3.141592653589793238462643383279502884L;
    struct problem p;
    struct failure why;
    scene_defaults(s, &p);
    p.param[5] = 1; /* A */
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    for (int i = 0; i < 2000; i++) {
        double x[2] = {p.hi[0] * (1 - i / 20011.0), 0.013};
        long double u = (long double)x[0] / p.hi[0], v = (long double)x[1] / p.hi[1];
        long double T = 1 + 0.5L * expl((long double)0.8 * u) * cosl((long double)1.1 * v + (long double)0.4) +
                        sinl(2 * pi * u) * cosl(pi * v);
        struct exact e = scene_exact(s, &p, x, 0);
        assert_near((double)(e.temperature - T), 0, e.error_bound);
    }
}

/* The solution on the infinite line differs from that between walls by the temperature that has reached the walls,
 * and not at all far from them. */
static void published_infinite_line_ignores_walls(void **state) {
    (void)state;
    static const char *const lines[] = {"rod-step", "rod-gauss", "square-step", "cube-step"};
    static const double at_wall[] = {5.2e-6, 6.2e-13, 5.2e-6,
                                     3.7e-4}; /* T0/2 erfc((L-a)/s) etc., half of it at the wall */
    for (int i = 0; i < 4; i++) {
        struct problem p;
        struct failure why;
        const struct scene *s = scene_find(lines[i]);
        scene_defaults(s, &p);
        assert_int_equal(s->setup(&p, &why), STATUS_OK);
        double far[DIM_MAX] = {0.1, -0.2}, wall[DIM_MAX] = {p.dim < 3 ? p.hi[0] : 0, 0, p.hi[2]};
        assert_near(s->published(&p, far, p.t_end), scene_exact(s, &p, far, p.t_end).temperature, 1e-13);
        double miss = s->published(&p, wall, p.t_end) - scene_exact(s, &p, wall, p.t_end).temperature;
        print_message("%-12s as published misses the wall by %.3e K\n", lines[i], miss);
        assert_order(miss, >, at_wall[i]);
        assert_order(miss, <, 3 * at_wall[i]);
    }
}

/* Only T2 is right among the plate's four sides as printed; T3 becomes right once steady, T1 and T4 never. */
static void published_plate_by_side(void **state) {
    (void)state;
    static const double x[2] = {0.031, 0.017};
    for (int side = 0; side < 4; side++) {
        struct problem p;
        struct scene plate = *scene_find("plate"), *s = &plate;
        for (int i = 2; i <= 6; i++) plate.odd.param[i] = i == 2 + side ? 1.3 : 0;
        odd_setup(s, &p);
        double soon = s->published(&p, x, 23.7) - scene_exact(s, &p, x, 23.7).temperature;
        double late = s->published(&p, x, 1e5) - scene_exact(s, &p, x, 1e5).temperature;
        print_message("T%d alone, as printed: off by %.3g K early, %.3g K steady\n", side + 1, soon, late);
        if (side == 1) assert_near(soon, 0, 1e-13);
        if (side == 1 || side == 2) assert_near(late, 0, 1e-13);
        if (side == 0 || side == 3) assert_near(late, -2 * scene_exact(s, &p, x, 1e5).temperature, 1e-13);
        if (side != 1) assert_order(fabs(soon), >, 0.01);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_values),
        cmocka_unit_test(extreme_values_hold_within_their_bounds),
        cmocka_unit_test(bounds_of_small_pulses_are_small),
        cmocka_unit_test(nafems_t4),
        cmocka_unit_test(cooled_balls_follow_heisler),
        cmocka_unit_test(gradients_hold_at_the_centre_of_a_ball),
        cmocka_unit_test(slow_axes_leave_a_square_and_a_rod),
        cmocka_unit_test(plate_of_the_paper),
        cmocka_unit_test(bound_holds_near_a_full_period),
        cmocka_unit_test(published_infinite_line_ignores_walls),
        cmocka_unit_test(published_plate_by_side),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("references, known values", tests, NULL, NULL);
}
