/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each exact solution obeys its equation, its sides and its start, and agrees with a second, independent form. */
#include "references/snapshot.h"

#include "verification/unit/odd_scenes.h"

#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>

/* Central differences of eighth order. */
static const double second_difference[] = {-205.0 / 72, 8.0 / 5, -1.0 / 5, 8.0 / 315, -1.0 / 560};
static const double first_difference[] = {0, 4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
/* One-sided difference of sixth order. */
static const double forward[] = {-49.0 / 20, 6, -15.0 / 2, 20.0 / 3, -15.0 / 4, 6.0 / 5, -1.0 / 6};

static double at(const struct scene *s, const struct problem *p, double x, double y, double t) {
    return scene_exact(s, p, (double[2]){x, y}, t).temperature;
}

/* d2T/dx2 for axis 0, d2T/dy2 for axis 1 */
static double curvature(const struct scene *s, const struct problem *p, const double x[2], double t, int axis,
                        double d) {
    double sum = 0;
    for (int i = -4; i <= 4; i++)
        sum += second_difference[abs(i)] * at(s, p, x[0] + (axis == 0) * i * d, x[1] + (axis == 1) * i * d, t);
    return sum / (d * d);
}

static double rate(const struct scene *s, const struct problem *p, const double x[2], double t) {
    double d = 0.01 * t, sum = 0;
    for (int i = 1; i <= 4; i++)
        sum += first_difference[i] * (at(s, p, x[0], x[1], t + i * d) - at(s, p, x[0], x[1], t - i * d));
    return sum / d;
}

static void the_equation_holds(void **state) {
    (void)state;
    for (int o = 0; scenes[o]; o++) {
        struct problem p;
        const struct scene *s = scenes[o];
        const struct scene_odd *odd = &s->odd;
        odd_setup(s, &p);
        unsigned long random = 7;
        double worst = 0, largest = 0;
        for (int trial = 0; trial < 200; trial++) {
            double x[2] = {0, 0}, margin = 10 * odd->step;
            double t = odd->earliest + odd_random(&random) * fmax(0, p.t_end - odd->earliest);
            odd_point(&p, margin, &random, x);
            if (p.materials == 2 && fabs(x[0] - p.interface) < margin) continue;
            const struct material *m = &p.material[p.materials == 2 && x[0] >= p.interface];
            double storage = m->rho_c * rate(s, &p, x, t), flow = 0, part = fabs(storage);
            for (int d = 0; d < p.dim; d++) {
                double term = m->k[d] * curvature(s, &p, x, t, d, odd->step);
                flow += term;
                part = fmax(part, fabs(term));
            }
            flow += problem_source(&p, x, t);
            worst = fmax(worst, fabs(storage - flow));
            largest = fmax(largest, part);
        }
        print_message("%-18s residual %.1e of the largest term\n", s->name, worst / largest);
        assert_near(worst / largest, 0, 2e-8);
    }
}

static void the_sides_hold(void **state) {
    (void)state;
    for (int o = 0; scenes[o]; o++) {
        struct problem p;
        const struct scene *s = scenes[o];
        const struct scene_odd *odd = &s->odd;
        odd_setup(s, &p);
        unsigned long random = 11;
        for (int trial = 0; trial < 100; trial++)
            for (int side = X_LO; side < 2 * p.dim; side++) {
                double x[2] = {0, 0}, t = (0.01 + odd_random(&random)) * p.t_end;
                if (!shape_has_wall(&p, side)) continue;
                if (p.dim == 2) odd_point(&p, 0, &random, x);
                struct foot f = shape_foot(&p, side, x);
                double want = p.wall(&p, (enum side)side, x), flux = 0, off = 0;
                struct exact e = scene_exact(s, &p, f.x, t);
                if (p.side[side] == DIRICHLET) {
                    assert_near(e.temperature, want, 1e-13 * odd->scale);
                    assert_order(e.error_bound, <=, 1e-12 * odd->scale);
                } else {
                    for (int a = 0; a < p.dim; a++) {
                        flux += p.material[0].k[a] * f.normal[a] * e.gradient[a];
                        off += p.material[0].k[a] * fabs(f.normal[a]) * e.gradient_bound[a];
                    }
                    if (p.side[side] == ROBIN) want = p.robin[side] * (want - e.temperature);
                    off += p.robin[side] * e.error_bound;
                    assert_near(flux, want, off);
                    assert_order(off, <, 1e-10 * p.material[0].k[0] * odd->scale / odd->step);
                }
            }
    }
}

static void wall_values_take_any_coordinate_along_their_axis(void **state) {
    (void)state;
    struct problem p;
    odd_find("rect-manufactured", &p);
    for (int side = X_LO; side <= Y_HI; side++) {
        double on[2] = {0.3, 0.2}, off[2] = {0.3, 0.2};
        on[side / 2] = side % 2 ? p.hi[side / 2] : p.lo[side / 2];
        off[side / 2] = on[side / 2] + (side % 2 ? 0.013 : -0.013);
        assert_near(p.wall(&p, (enum side)side, off), p.wall(&p, (enum side)side, on), 0);
        assert_order(fabs(p.wall(&p, (enum side)side, on)), >, 1e-4);
    }
}

static void the_start_holds(void **state) {
    (void)state;
    for (int o = 0; scenes[o]; o++) {
        struct problem p;
        const struct scene *s = scenes[o];
        odd_setup(s, &p);
        unsigned long random = 13;
        for (int trial = 0; trial < 300; trial++) {
            double x[2] = {0, 0};
            odd_point(&p, 0, &random, x);
            assert_near(at(s, &p, x[0], x[1], 0), p.initial(&p, x), 0);
            /* a moment later nothing but what lies at a jump has changed */
            int far = 1;
            for (int d = 0; d < p.dim; d++) {
                for (int j = 0; j < p.jumps[d]; j++) far &= fabs(x[d] - p.jump[d][j]) > 0.001;
                far &= x[d] - p.lo[d] > 0.001 && p.hi[d] - x[d] > 0.001;
            }
            if (far) assert_near(at(s, &p, x[0], x[1], 1e-9 * p.t_end), p.initial(&p, x), 1e-7);
        }
    }
}

static void the_edge_of_the_start_is_closed(void **state) {
    (void)state;
    struct problem p;
    odd_find("rod-step", &p);
    for (int j = 0; j < 2; j++) {
        double edge = p.jump[0][j], out = j ? 1 : -1;
        assert_near(p.initial(&p, (double[2]){edge, 0}), 7.3, 0);
        assert_near(p.initial(&p, (double[2]){edge + out * 1e-15, 0}), 7.3, 0);
        assert_near(p.initial(&p, (double[2]){edge + out * 1e-10, 0}), 0, 0);
    }
    odd_find("rod-contact", &p); /* x_c belongs to the right half, as the material does */
    assert_near(p.initial(&p, (double[2]){0.13, 0}), 0.2, 0);
    assert_near(p.initial(&p, (double[2]){0.13 - 1e-16, 0}), 0.2, 0);
    assert_near(p.initial(&p, (double[2]){0.13 - 1e-9, 0}), 0.9, 0);
}

static void flux_is_continuous_at_an_interface(void **state) {
    (void)state;
    static const char *const with_two[] = {"rod-contact", "wall-composite", "plane-contact"};
    for (int i = 0; i < 3; i++) {
        struct problem p;
        const struct scene *s = odd_find(with_two[i], &p);
        double flux[2], d = 0.002, c = p.interface, t = p.t_end;
        for (int side = 0; side < 2; side++) {
            double sign = side ? 1 : -1, sum = forward[0] * at(s, &p, c + sign * 1e-15, 0, t);
            for (int j = 1; j <= 6; j++) sum += forward[j] * at(s, &p, c + sign * j * d, 0, t);
            flux[side] = p.material[side].k[0] * sign * sum / d;
        }
        assert_near(flux[0], flux[1], 1e-8 * fabs(flux[0]));
        assert_near(at(s, &p, c - 1e-16, 0, t), at(s, &p, c, 0, t), 1e-14);
        assert_order(fabs(flux[0]), >, 1e-3);
    }
}

static void the_second_form_agrees(void **state) {
    (void)state;
    static const double times[] = {0.003, 0.05, 0.41, 1, 1.7};
    for (int o = 0; scenes[o]; o++) {
        struct problem p;
        const struct scene *s = scenes[o];
        odd_setup(s, &p);
        unsigned long random = 17;
        double worst = 0, bound = 0;
        for (int k = 0; k < 5; k++)
            for (int trial = 0; trial < 60; trial++) {
                double x[2] = {0, 0}, t = times[k] * p.t_end;
                odd_point(&p, 0, &random, x);
                struct exact e = scene_exact(s, &p, x, t), f = s->second(&p, x, t);
                assert_near(e.temperature, f.temperature, e.error_bound + f.error_bound);
                worst = fmax(worst, fabs(e.temperature - f.temperature));
                bound = fmax(bound, e.error_bound);
            }
        print_message("%-18s |exact - second| <= %.1e K, bound of exact <= %.1e K\n", s->name, worst, bound);
        assert_near(worst, 0, 1e-12 * s->odd.scale);
        assert_near(bound, 0, 1e-12 * s->odd.scale);
    }
}

/* At the middle, where a Gaussian and its images have no slope and phases are pi/2: bounds are numbers there too. */
static void the_middle_is_known(void **state) {
    (void)state;
    for (int o = 0; scenes[o]; o++) {
        struct problem p;
        const struct scene *s = scenes[o];
        odd_setup(s, &p);
        const double middle[2] = {(p.lo[0] + p.hi[0]) / 2 + (p.radius[0] > 0 ? (p.radius[0] + p.radius[1]) / 2 : 0),
                                  (p.lo[1] + p.hi[1]) / 2};
        for (double t = 1e-3 * p.t_end; t < 2 * p.t_end; t *= 10) {
            struct exact e = scene_exact(s, &p, middle, t);
            assert_near(e.error_bound, 0, 1e-12 * s->odd.scale);
            for (int d = 0; d < p.dim; d++) assert_near(e.gradient_bound[d], 0, 1e-10 * s->odd.scale / s->odd.step);
        }
    }
}

/* Against central differences of the second form, derived apart. */
static void the_gradient_is_that_of_the_second_form(void **state) {
    (void)state;
    for (int o = 0; scenes[o]; o++) {
        struct problem p;
        const struct scene *s = scenes[o];
        const struct scene_odd *odd = &s->odd;
        odd_setup(s, &p);
        unsigned long random = 19;
        double worst = 0, largest = 0;
        for (int trial = 0; trial < 60; trial++) {
            double x[2] = {0, 0}, margin = 10 * odd->step;
            double t = odd->earliest + odd_random(&random) * fmax(0, p.t_end - odd->earliest);
            odd_point(&p, margin, &random, x);
            if (p.materials == 2 && fabs(x[0] - p.interface) < margin) continue;
            struct exact e = scene_exact(s, &p, x, t);
            for (int d = 0; d < p.dim; d++) {
                double sum = 0, step = odd->step;
                for (int i = -4; i <= 4; i++) {
                    double at[2] = {x[0] + (d == 0) * i * step, x[1] + (d == 1) * i * step};
                    sum += (i < 0 ? -1 : 1) * first_difference[abs(i)] * s->second(&p, at, t).temperature;
                }
                worst = fmax(worst, fabs(e.gradient[d] - sum / step));
                largest = fmax(largest, fabs(e.gradient[d]));
                assert_order(e.gradient_bound[d], >=, 0);
                assert_order(e.gradient_bound[d], <, 1e-10 * odd->scale / step);
            }
        }
        print_message("%-18s gradient off by %.1e of the largest\n", s->name, worst / largest);
        assert_near(worst / largest, 0, 2e-8);
    }
}

/* A disc without waves around it: nothing changes along a circle.  Differences over 2 d r miss (d r)^2/6 of the third
 * derivative, some 10/R^2 of the first: 2e-8. */
static void rings_without_waves_have_radial_gradients(void **state) {
    (void)state;
    const struct scene *s = scene_find("disc-mode");
    const double x[2] = {0.31, -0.47}, r = hypot(x[0], x[1]), d = 1e-4;
    struct problem p;
    struct failure why;
    scene_defaults(s, &p);
    for (int i = 0; s->params[i].name; i++)
        if (strcmp(s->params[i].name, "mode") == 0) p.param[i] = 0;
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    struct exact e = scene_exact(s, &p, x, 1);
    double slope = 0;
    for (int side = -1; side <= 1; side += 2) {
        double at[2] = {x[0] * (1 + side * d), x[1] * (1 + side * d)};
        slope += side * scene_exact(s, &p, at, 1).temperature / (2 * d * r);
    }
    assert_order(fabs(slope), >, 0.1);
    for (int a = 0; a < 2; a++) assert_near(e.gradient[a], slope * x[a] / r, 1e-6 * fabs(slope));
}

static void declared_symmetry_is_real(void **state) {
    (void)state;
    for (int o = 0; scenes[o]; o++) {
        struct problem p;
        const struct scene *s = scenes[o];
        odd_setup(s, &p);
        for (int d = 0; d < p.dim && !p.shape; d++) { /* of a round body no half is computed */
            double x[2] = {p.lo[0] + 0.23 * (p.hi[0] - p.lo[0]), p.lo[1] + 0.31 * (p.hi[1] - p.lo[1])},
                   m[2] = {x[0], x[1]};
            m[d] = p.lo[d] + p.hi[d] - x[d];
            double difference = at(s, &p, x[0], x[1], p.t_end) - at(s, &p, m[0], m[1], p.t_end);
            if (p.mirror[d])
                assert_near(difference, 0, 1e-13 * s->odd.scale);
            else
                assert_order(fabs(difference), >, 1e-3);
        }
    }
}

/* Row by row, column by column and along the diagonal: the bits of one point at a time. */
static void many_points_are_each_of_them(void **state) {
    enum { N = 7, ORDERS = 3 };
    (void)state;
    for (int o = 0; scenes[o]; o++) {
        struct problem p;
        odd_setup(scenes[o], &p);
        double at[2][ORDERS * N * N], t = 0.7 * p.t_end;
        struct exact e[ORDERS * N * N];
        for (int k = 0; k < ORDERS * N * N; k++) {
            int i = k % N, j = k / N % N, order = k / (N * N);
            double part[2] = {order == 1 ? j : i, order == 0 ? j : order == 1 ? i : (i + j) % N};
            for (int a = 0; a < 2; a++) at[a][k] = p.lo[a] + (part[a] + 0.5) / N * (p.hi[a] - p.lo[a]);
        }
        struct snapshot now = snapshot_take(scenes[o], &p, t);
        snapshot_at_points(&now, ORDERS * N * N, at[0], p.dim == 2 ? at[1] : NULL, e);
        for (int k = 0; k < ORDERS * N * N; k++) {
            struct exact one = snapshot_at(&now, (double[2]){at[0][k], p.dim == 2 ? at[1][k] : 0});
            if (memcmp(&e[k].temperature, &one.temperature, sizeof one.temperature) != 0 ||
                memcmp(&e[k].error_bound, &one.error_bound, sizeof one.error_bound) != 0)
                fail_msg("%s at (%g, %g): %.17g, and alone %.17g", scenes[o]->name, at[0][k], at[1][k],
                         e[k].temperature, one.temperature);
        }
        snapshot_free(&now);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_equation_holds),
        cmocka_unit_test(the_sides_hold),
        cmocka_unit_test(wall_values_take_any_coordinate_along_their_axis),
        cmocka_unit_test(the_start_holds),
        cmocka_unit_test(the_edge_of_the_start_is_closed),
        cmocka_unit_test(flux_is_continuous_at_an_interface),
        cmocka_unit_test(the_second_form_agrees),
        cmocka_unit_test(the_middle_is_known),
        cmocka_unit_test(the_gradient_is_that_of_the_second_form),
        cmocka_unit_test(rings_without_waves_have_radial_gradients),
        cmocka_unit_test(declared_symmetry_is_real),
        cmocka_unit_test(many_points_are_each_of_them),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("references", tests, NULL, NULL);
}
