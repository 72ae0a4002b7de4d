/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each exact solution obeys its equation, walls and start, agrees with a second form within both bounds, and does not
 * depend on units.  One loop runs over all scenes at odd parameters, and over the branches of scenes that those miss.
 */
#include "references/snapshot.h"

#include "verification/unit/odd_scenes.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>

/* Central differences of eighth order. */
static const double second_difference[] = {-205.0 / 72, 8.0 / 5, -1.0 / 5, 8.0 / 315, -1.0 / 560};
static const double first_difference[] = {0, 4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
/* One-sided difference of sixth order. */
static const double forward[] = {-49.0 / 20, 6, -15.0 / 2, 20.0 / 3, -15.0 / 4, 6.0 / 5, -1.0 / 6};

static struct scene cases[64]; /* ended by a NULL name */

/* Branches that the odd parameters miss: limits of a cooled wall, no waves, other kinds of walls, a
 * contact that resists. */
static const struct {
    const char *scene, *param;
    double value;
} branch[] = {{"rod-cooling", "b", 0},
              {"rod-cooling", "b", 1e5},
              {"plate-cooling", "b", 0},
              {"plate-cooling", "b", 1e5},
              {"disc-mode", "mode", 0},
              {"disc-mode", "wall", 1},
              {"disc-mode", "wall", 2},
              {"plane-contact", "mode", 0},
              {"ball-mode", "l", 2},
              {"ball-mode", "m", 0},
              {"ball-mode", "wall", 1},
              {"ball-mode", "wall", 2},
              {"rod-driven", "omega", 0.03},
              {"wave", "mode_z", 3},
              {"front", "n", 1},
              {"blast", "dim", 3},
              {"blast", "dim", 1},
              {"blast", "n", 0.6},
              {"melt", "latent", 0.07},
              {"wall-kirchhoff", "beta", -0.4},
              {"rod-contact", "R", 7.3},
              {"wall-composite", "R", 5.7}};

static int list_cases(void **state) {
    (void)state;
    int n = 0;
    for (int i = 0; scenes[i]; i++) cases[n++] = *scenes[i];
    for (size_t i = 0; i < sizeof branch / sizeof *branch; i++) {
        struct scene *s = &cases[n++];
        *s = *scene_find(branch[i].scene);
        for (int k = 0; s->params[k].name; k++)
            if (strcmp(s->params[k].name, branch[i].param) == 0) s->odd.param[k] = branch[i].value;
    }
    return 0;
}

static double at(const struct scene *s, const struct problem *p, const double *x, double t) {
    return scene_exact(s, p, x, t).temperature;
}

/* k and its integral from k_ref, for a k that depends on T */
static double conductivity(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_PHASES) return p->phase_k[u > 0];
    return p->k_0 * (p->k_law == K_POWER ? pow(u, p->k_n) : 1 + p->k_beta * u);
}

static double integral(const struct problem *p, double T) {
    double u = T - p->k_ref;
    if (p->k_law == K_PHASES) return p->phase_k[u > 0] * u;
    return p->k_0 * (p->k_law == K_POWER ? pow(u, p->k_n + 1) / (p->k_n + 1) : u + p->k_beta / 2 * u * u);
}

/* Second derivative along the axis, of T or of the integral of k. */
static double curvature(const struct scene *s, const struct problem *p, const double *x, double t, int axis,
                        double d) {
    double sum = 0;
    for (int i = -4; i <= 4; i++) {
        double there[DIM_MAX] = {x[0], x[1], x[2]};
        there[axis] += i * d;
        double T = at(s, p, there, t);
        sum += second_difference[abs(i)] * (p->k_law ? integral(p, T) : T);
    }
    return sum / (d * d);
}

/* d2T/dx_a dx_b */
static double twist(const struct scene *s, const struct problem *p, const double *x, double t, int a, int b,
                    double d) {
    double sum = 0;
    for (int i = -4; i <= 4; i++)
        for (int j = -4; j <= 4; j++) {
            double there[DIM_MAX] = {x[0], x[1], x[2]}, w = first_difference[abs(i)] * first_difference[abs(j)];
            there[a] += i * d, there[b] += j * d;
            if (w != 0) sum += (i * j < 0 ? -w : w) * at(s, p, there, t);
        }
    return sum / (d * d);
}

/* The divergence of K grad T of a field. */
static double along_field(const struct scene *s, const struct problem *p, const double *x, double t, double d) {
    double sum = 0;
    for (int a = 0; a < p->dim; a++)
        for (int i = -4; i <= 4; i++) {
            double there[DIM_MAX] = {x[0], x[1], x[2]}, K[DIM_MAX][DIM_MAX];
            there[a] += i * d;
            struct exact e = scene_exact(s, p, there, t);
            problem_tensor(p, there, K);
            for (int b = 0; b < p->dim; b++)
                sum += (i < 0 ? -1 : 1) * first_difference[abs(i)] * K[a][b] * e.gradient[b] / d;
        }
    return sum;
}

static double rate(const struct scene *s, const struct problem *p, const double *x, double t) {
    double d = 0.01 * t, sum = 0;
    for (int i = 1; i <= 4; i++) sum += first_difference[i] * (at(s, p, x, t + i * d) - at(s, p, x, t - i * d));
    return sum / d;
}

static int is_near_front(const struct scene *s, const struct problem *p, double x, double t, double margin) {
    double lo = at(s, p, &(double){x - margin}, t), hi = at(s, p, &(double){x + margin}, t);
    return (lo - p->k_ref) * (hi - p->k_ref) <= 0;
}

/* The flux that ends at the front is the latent heat of its motion. */
static void front_takes_latent_heat(void **state) {
    (void)state;
    struct problem p;
    const struct scene *s = odd_find("melt", &p);
    double sign = p.param[8] > p.param[7] ? 1 : -1, s0 = p.kink[0], e = 1e-9, d = 1e-3;
    struct exact hot = scene_exact(s, &p, &(double){s0 - e}, 0), cold = scene_exact(s, &p, &(double){s0 + e}, 0);
    double flux =
        conductivity(&p, hot.temperature) * hot.gradient[0] - conductivity(&p, cold.temperature) * cold.gradient[0];
    double later = s0 + d; /* the time at which the front is there, by bisection: T there is T_m */
    double lo = 0, hi = p.t_end;
    for (int i = 0; i < 80; i++) {
        double t = (lo + hi) / 2;
        *((at(s, &p, &later, t) - p.k_ref) * sign > 0 ? &hi : &lo) = t;
    }
    assert_near(-sign * flux, p.latent * d / hi, 0.51 * p.latent * d * d / s0 / hi + 1e-6);
}

static void residual_of_the_equation_vanishes(void **state) {
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        const struct scene_odd *odd = &s->odd;
        odd_setup(s, &p);
        unsigned long random = 7;
        double worst = 0, largest = 0;
        for (int trial = 0; trial < 60; trial++) {
            double x[DIM_MAX], margin = 10 * odd->step;
            double t = odd->earliest + odd_random(&random) * fmax(0, p.t_end - odd->earliest);
            odd_point(&p, margin, &random, x);
            if (p.materials == 2 && fabs(x[0] - p.interface) < margin) continue;
            if (p.k_law == K_PHASES && is_near_front(s, &p, x[0], t, margin)) continue;
            const struct material *m = &p.material[p.materials == 2 && x[0] >= p.interface];
            const int phase = at(s, &p, x, t) > p.k_ref;
            double rho_c = p.k_law == K_PHASES ? p.phase_rho_c[phase] : m->rho_c;
            double storage = rho_c * rate(s, &p, x, t), flow = 0, part = fabs(storage);
            for (int d = 0; d < p.dim; d++) {
                double term = (p.k_law ? 1 : m->k[d]) * curvature(s, &p, x, t, d, odd->step);
                flow += term;
                part = fmax(part, fabs(term));
                for (int b = 0; b < d && problem_has_cross(&p); b++)
                    flow += 2 * p.cross[problem_pair(b, d)] * twist(s, &p, x, t, b, d, odd->step);
            }
            if (p.direction) flow = along_field(s, &p, x, t, odd->step);
            flow += problem_source(&p, x, t);
            worst = fmax(worst, fabs(storage - flow));
            largest = fmax(largest, part);
        }
        print_message("%-18s residual %.1e of the largest term\n", s->name, worst / largest);
        assert_near(worst / largest, 0, 2e-8);
    }
}

static void boundary_conditions_hold(void **state) {
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        const struct scene_odd *odd = &s->odd;
        odd_setup(s, &p);
        unsigned long random = 11;
        for (int trial = 0; trial < 40; trial++)
            for (int side = X_LO; side < 2 * p.dim; side++) {
                double x[DIM_MAX] = {0}, t = (0.01 + odd_random(&random)) * p.t_end;
                if (!shape_has_wall(&p, side)) continue;
                if (p.dim > 1) odd_point(&p, 0, &random, x);
                struct foot f = shape_foot(&p, side, x);
                double want = p.wall(&p, (enum side)side, f.x, t), flux = 0, off = 0;
                struct exact e = scene_exact(s, &p, f.x, t);
                if (p.side[side] == DIRICHLET) {
                    assert_near(e.temperature, want, 1e-13 * odd->scale);
                    assert_order(e.error_bound, <=, 1e-12 * odd->scale);
                } else {
                    double K[DIM_MAX][DIM_MAX];
                    problem_tensor(&p, f.x, K);
                    for (int a = 0; a < p.dim; a++)
                        for (int b = 0; b < p.dim; b++) {
                            double k = p.k_law ? (a == b) * conductivity(&p, e.temperature) : K[a][b];
                            flux += k * f.normal[a] * e.gradient[b];
                            off += fabs(k * f.normal[a]) * e.gradient_bound[b];
                        }
                    if (p.side[side] == ROBIN) want = p.robin[side] * (want - e.temperature);
                    off += p.robin[side] * e.error_bound;
                    assert_near(flux, want, off);
                    assert_order(off, <, 1e-10 * p.material[0].k[0] * odd->scale / odd->step);
                }
            }
    }
}

static void rate_of_a_wall_is_its_derivative(void **state) {
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        odd_setup(s, &p);
        unsigned long random = 29;
        for (int trial = 0; trial < 20 && p.wall_rate; trial++)
            for (int side = X_LO; side < 2 * p.dim; side++) {
                double x[DIM_MAX] = {0}, t = odd_random(&random) * p.t_end, d = 0.01 * p.t_end, sum = 0;
                odd_point(&p, 0, &random, x);
                for (int i = 1; i <= 4; i++)
                    sum += first_difference[i] *
                           (p.wall(&p, (enum side)side, x, t + i * d) - p.wall(&p, (enum side)side, x, t - i * d));
                assert_near(p.wall_rate(&p, (enum side)side, x, t), sum / d, 1e-10 * s->odd.scale);
            }
    }
}

static void initial_condition_holds(void **state) {
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        odd_setup(s, &p);
        unsigned long random = 13;
        for (int trial = 0; trial < 100; trial++) {
            double x[DIM_MAX];
            odd_point(&p, 0, &random, x);
            assert_near(at(s, &p, x, 0), p.initial(&p, x), 0);
            /* a moment later only points at a jump have changed */
            int far = 1;
            for (int d = 0; d < p.dim; d++) {
                for (int j = 0; j < p.jumps[d]; j++) far &= fabs(x[d] - p.jump[d][j]) > 0.001;
                far &= x[d] - p.lo[d] > 0.001 && p.hi[d] - x[d] > 0.001;
            }
            if (far) assert_near(at(s, &p, x, 1e-9 * p.t_end), p.initial(&p, x), 1e-7);
        }
    }
}

static void jump_belongs_to_the_closed_piece(void **state) {
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
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        odd_setup(s, &p);
        if (p.materials != 2) continue;
        double flux[2], d = 0.002, c = p.interface, t = p.t_end;
        for (int side = 0; side < 2; side++) {
            double sign = side ? 1 : -1, sum = 0;
            for (int j = 0; j <= 6; j++)
                sum += forward[j] * at(s, &p, (double[DIM_MAX]){c + sign * fmax(2e-12, j * d)}, t);
            flux[side] = p.material[side].k[0] * sign * sum / d;
        }
        assert_near(flux[0], flux[1], 1e-8 * fabs(flux[0]));
        assert_near(at(s, &p, (double[DIM_MAX]){c - 1e-16}, t), at(s, &p, (double[DIM_MAX]){c}, t), 1e-14);
        double fall = at(s, &p, (double[DIM_MAX]){c - 2e-12}, t) - at(s, &p, (double[DIM_MAX]){c}, t);
        assert_near(fall, -p.resistance * flux[0], 1e-8 * p.resistance * fabs(flux[0]) + 1e-11);
        assert_order(fabs(flux[0]), >, 1e-3);
    }
}

static void second_form_agrees(void **state) {
    (void)state;
    static const double times[] = {0.003, 0.05, 0.41, 1, 1.7};
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        odd_setup(s, &p);
        unsigned long random = 17;
        double worst = 0, bound = 0;
        for (int k = 0; k < 5; k++)
            for (int trial = 0; trial < 30; trial++) {
                double x[DIM_MAX] = {0}, t = times[k] * p.t_end;
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

/* On circles of the patch, which jumps across two of them. */
static void patch_is_a_rod_without_ends(void **state) {
    (void)state;
    struct problem p;
    const struct scene *s = odd_find("ring", &p);
    struct failure why;
    p.param[3] = 1;
    assert_int_equal(s->setup(&p, &why), 0);
    unsigned long random = 23;
    for (int trial = 0; trial < 200; trial++) {
        double r = 0.53 + 0.29 * odd_random(&random), theta = 6.3 * odd_random(&random), d = 0.02;
        double t = 3 * pow(odd_random(&random), 2), x[DIM_MAX] = {r * cos(theta), r * sin(theta)}, bend = 0;
        struct exact e = scene_exact(s, &p, x, t), f = s->second(&p, x, t);
        if (isfinite(f.error_bound)) assert_near(e.temperature, f.temperature, e.error_bound + f.error_bound);
        assert_order(e.error_bound, <, 1e-11);
        if (t < 0.4) continue; /* the spread is 0.16, eight steps */
        for (int i = -4; i <= 4; i++) {
            double there[DIM_MAX] = {r * cos(theta + i * d), r * sin(theta + i * d)};
            bend += second_difference[abs(i)] * at(s, &p, there, t) / (d * d);
        }
        assert_near(rate(s, &p, x, t), p.k_par / p.material[0].rho_c / (r * r) * bend, 1e-4 * p.param[12]);
    }
}

/* Every number within a factor of 8 of the odd one, if the scene accepts it. */
static void second_form_agrees_at_any_parameters_in_space(void **state) {
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        unsigned long random = 37;
        int compared = 0;
        odd_setup(s, &p);
        for (int trial = 0; trial < 60 && p.dim == 3; trial++) {
            struct problem q = p;
            struct failure why;
            for (int i = 0; s->params[i].name; i++)
                if (*s->params[i].unit) q.param[i] = s->odd.param[i] * exp2(6 * odd_random(&random) - 3);
            if (s->setup(&q, &why)) continue;
            for (int k = 0; k < 4; k++) {
                double x[DIM_MAX], t = 2 * q.t_end * pow(odd_random(&random), 3);
                odd_point(&q, 0, &random, x);
                struct exact e = scene_exact(s, &q, x, t), f = s->second(&q, x, t);
                if (!isfinite(f.error_bound)) continue;
                assert_near(e.temperature, f.temperature, e.error_bound + f.error_bound);
                compared++;
            }
        }
        if (p.dim == 3) assert_order(compared, >, 20);
    }
}

/* Against central differences of the second form, derived apart. */
static void gradient_equals_that_of_the_second_form(void **state) {
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        const struct scene_odd *odd = &s->odd;
        odd_setup(s, &p);
        unsigned long random = 19;
        double worst = 0, largest = 0;
        for (int trial = 0; trial < 12; trial++) {
            double x[DIM_MAX], margin = 10 * odd->step;
            double t = odd->earliest + odd_random(&random) * fmax(0, p.t_end - odd->earliest);
            odd_point(&p, margin, &random, x);
            if (p.materials == 2 && fabs(x[0] - p.interface) < margin) continue;
            if (p.k_law == K_PHASES && is_near_front(s, &p, x[0], t, margin)) continue;
            struct exact e = scene_exact(s, &p, x, t);
            for (int d = 0; d < p.dim; d++) {
                double sum = 0, step = odd->step;
                for (int i = -4; i <= 4; i++) {
                    double there[DIM_MAX] = {x[0], x[1], x[2]};
                    there[d] += i * step;
                    sum += (i < 0 ? -1 : 1) * first_difference[abs(i)] * s->second(&p, there, t).temperature;
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

static void declared_symmetry_is_real(void **state) {
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        odd_setup(s, &p);
        for (int d = 0; d < p.dim && !p.shape; d++) { /* round bodies are not halved */
            static const double part[DIM_MAX] = {0.23, 0.31, 0.17};
            double x[DIM_MAX], m[DIM_MAX];
            for (int a = 0; a < DIM_MAX; a++) x[a] = m[a] = p.lo[a] + part[a] * (p.hi[a] - p.lo[a]);
            m[d] = p.lo[d] + p.hi[d] - x[d];
            double difference = at(s, &p, x, p.t_end) - at(s, &p, m, p.t_end);
            if (p.mirror[d]) assert_near(difference, 0, 1e-13 * s->odd.scale);
        }
    }
}

/* Along each axis and along the diagonal: the bits of one point at a time. */
static void batch_evaluation_equals_single_points(void **state) {
    enum { N = 7, ORDERS = 4, POINTS = ORDERS * N * N };
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        struct problem p;
        odd_setup(s, &p);
        double at[DIM_MAX][POINTS], t = 0.7 * p.t_end;
        struct exact e[POINTS];
        for (int k = 0; k < POINTS; k++)
            for (int a = 0, i = k % N, j = k / N % N, order = k / (N * N); a < DIM_MAX; a++) {
                int part = order == a ? i : order < DIM_MAX ? j : (i + a * j) % N;
                at[a][k] = p.lo[a] + (part + 0.5) / N * (p.hi[a] - p.lo[a]);
            }
        struct snapshot now = snapshot_take(s, &p, t);
        snapshot_at_points(&now, POINTS, at[0], p.dim > 1 ? at[1] : NULL, p.dim > 2 ? at[2] : NULL, e);
        for (int k = 0; k < POINTS; k++) {
            struct exact one = snapshot_at(&now, (double[DIM_MAX]){at[0][k], at[1][k], at[2][k]});
            if (memcmp(&e[k].temperature, &one.temperature, sizeof one.temperature) != 0 ||
                memcmp(&e[k].error_bound, &one.error_bound, sizeof one.error_bound) != 0)
                fail_msg("%s at (%g, %g, %g): %.17g, and alone %.17g", s->name, at[0][k], at[1][k], at[2][k],
                         e[k].temperature, one.temperature);
        }
        snapshot_free(&now);
    }
}

/* Exponents of 2 of temperatures, lengths and, twice the latter, times; conductivities and heat capacities stay. */
struct powers {
    int temperature, length;
};

static int power_of(const char *unit, struct powers by) {
    if (strcmp(unit, "K") == 0 || strcmp(unit, "J/m^3") == 0) return by.temperature;
    if (strcmp(unit, "m") == 0) return by.length;
    if (strcmp(unit, "s") == 0) return 2 * by.length;
    if (strcmp(unit, "W/m^2/K") == 0) return -by.length;
    if (strcmp(unit, "m^2 K/W") == 0) return by.length;
    if (strcmp(unit, "W/m^2") == 0) return by.temperature - by.length;
    if (strcmp(unit, "W/m^3") == 0) return by.temperature - 2 * by.length;
    if (strcmp(unit, "m/s") == 0) return -by.length;
    if (strcmp(unit, "1/K") == 0) return -by.temperature;
    if (strcmp(unit, "K/s") == 0) return by.temperature - 2 * by.length;
    if (strcmp(unit, "1/s") == 0) return -2 * by.length;
    return 0;
}

/* got is 2^power times want, except for underflow. */
static void assert_times(double got, double want, int power) {
    if (isinf(want))
        assert_true(isinf(got)); /* a form that would take too many terms */
    else
        assert_near(ldexp(got, -power), want, DBL_MIN * fmax(1, ldexp(1, -power)));
}

static void assert_scales(const struct scene *s, struct powers by) {
    struct problem p, q;
    struct failure why;
    odd_setup(s, &p);
    odd_setup(s, &q);
    for (int i = 0; s->params[i].name; i++) q.param[i] = ldexp(p.param[i], power_of(s->params[i].unit, by));
    if (s->setup(&q, &why)) fail_msg("%s: %s", s->name, why.text);
    unsigned long random = 23;
    for (int trial = 0; trial < 30; trial++) {
        double x[DIM_MAX], y[DIM_MAX] = {0}, t = p.t_end * pow(odd_random(&random), 3);
        odd_point(&p, 0, &random, x);
        for (int d = 0; d < p.dim; d++) y[d] = ldexp(x[d], by.length);
        for (int form = 0; form < 2; form++) {
            struct exact e = form ? s->second(&p, x, t) : scene_exact(s, &p, x, t);
            struct exact f =
                form ? s->second(&q, y, ldexp(t, 2 * by.length)) : scene_exact(s, &q, y, ldexp(t, 2 * by.length));
            assert_times(f.temperature, e.temperature, by.temperature);
            assert_times(f.error_bound, e.error_bound, by.temperature);
            for (int d = 0; d < p.dim && !form; d++) {
                assert_times(f.gradient[d], e.gradient[d], by.temperature - by.length);
                assert_times(f.gradient_bound[d], e.gradient_bound[d], by.temperature - by.length);
            }
        }
    }
}

/* Powers of 2 change no digit; the manufactured scenes are about a level of 1 K. */
static void references_scale_with_units(void **state) {
    (void)state;
    for (const struct scene *s = cases; s->name; s++) {
        int given = 0;
        for (int i = 0; s->params[i].name; i++) given += strcmp(s->params[i].unit, "K") == 0;
        if (given && !strstr(s->name, "-manufactured")) assert_scales(s, (struct powers){.temperature = -20});
        for (int power = -7; power <= 10; power += 17) assert_scales(s, (struct powers){.length = power});
    }
}

/* From 1e-310 s on a scene has a temperature with a bound, and its second form is within the bounds, or has none;
 * rod-contact only while its walls are not felt. */
static void bounds_exist_at_all_times(void **state) {
    (void)state;
    for (int i = 0; scenes[i]; i++) {
        const struct scene *s = scenes[i];
        struct problem p;
        struct failure why;
        scene_defaults(s, &p);
        assert_int_equal(s->setup(&p, &why), STATUS_OK);
        double x[DIM_MAX] = {0.31 * p.lo[0] + 0.69 * p.hi[0], 0.57 * p.lo[1] + 0.43 * p.hi[1],
                             0.43 * p.lo[2] + 0.57 * p.hi[2]};
        if (p.shape) x[0] = 0.31 * p.radius[0] + 0.69 * p.radius[1]; /* and y near 0 */
        int bounded = 0;
        for (double t = 1e-310; t < 1e300; t *= 3e9) {
            if (strcmp(s->name, "rod-contact") == 0 && t > p.t_end) break;
            struct exact e = scene_exact(s, &p, x, t), f = s->second(&p, x, t);
            if (!isfinite(e.temperature) || !isfinite(e.error_bound)) fail_msg("%s, t = %g", s->name, t);
            if (!isfinite(f.error_bound)) continue;
            double apart = fabs(e.temperature - f.temperature);
            if (!(apart <= e.error_bound + f.error_bound))
                fail_msg("%s, t = %g: %g apart, bounds %g and %g", s->name, t, apart, e.error_bound, f.error_bound);
            bounded++;
        }
        assert_order(bounded, >, 0);
    }
}

static void defaults_are_accepted(void **state) {
    (void)state;
    for (const struct scene *const *s = scenes; *s; s++) {
        struct problem p;
        struct failure why = {0};
        int last = 0;
        scene_defaults(*s, &p);
        assert_int_equal((*s)->setup(&p, &why), STATUS_OK);
        while ((*s)->params[last + 1].name) last++;
        assert_order(last, <, PARAM_MAX);
        assert_string_equal((*s)->params[last].name, "t_end");
        assert_near(p.t_end, (*s)->params[last].value, 0);
        assert_true((*s)->about && (*s)->citation && (*s)->exact && (*s)->second && p.initial && p.wall);
        for (int i = 0; i < last; i++) assert_true((*s)->params[i].unit && (*s)->params[i].about);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(front_takes_latent_heat),
        cmocka_unit_test(residual_of_the_equation_vanishes),
        cmocka_unit_test(boundary_conditions_hold),
        cmocka_unit_test(rate_of_a_wall_is_its_derivative),
        cmocka_unit_test(initial_condition_holds),
        cmocka_unit_test(jump_belongs_to_the_closed_piece),
        cmocka_unit_test(flux_is_continuous_at_an_interface),
        cmocka_unit_test(second_form_agrees),
        cmocka_unit_test(patch_is_a_rod_without_ends),
        cmocka_unit_test(second_form_agrees_at_any_parameters_in_space),
        cmocka_unit_test(gradient_equals_that_of_the_second_form),
        cmocka_unit_test(declared_symmetry_is_real),
        cmocka_unit_test(batch_evaluation_equals_single_points),
        cmocka_unit_test(references_scale_with_units),
        cmocka_unit_test(bounds_exist_at_all_times),
        cmocka_unit_test(defaults_are_accepted),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("references", tests, list_cases, NULL);
}
