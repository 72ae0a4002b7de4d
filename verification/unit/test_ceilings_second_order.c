/* The errors that gates_manufactured.def foretells, worked out: e_t = L e + r on a grid of its own, with the
 * stencil's truncation, what mirrors miss at the walls, and the (-1)^i that the wide stencils do not see. */
#include "verification/unit/stencil_moments.h"

enum { NX = 60, NY = 42 };

static const double PI = 3.14159265358979323846, HEIGHT = 0.7, TIME = 2, AMPLITUDE = 0.8;

/* d^(a + b) S / dx^a dy^b of the steady part; its 1 counts in S alone */
static double S(double x, double y, int a, int b) {
    double rate = 1.1 / HEIGHT;
    return (a + b == 0) + 0.5 * pow(0.8, a) * exp(0.8 * x) * pow(rate, b) * cos(rate * y + 0.4 + b * PI / 2);
}

struct sides {
    double x[2][NY], y[2][NX]; /* a temperature along x where `held`, else k dT/dn */
};

/* e(TIME) from e(0) in place. */
static void diffuse(double e[NY][NX], double kx, double ky, double r[NY][NX], const struct sides *at, int held) {
    static double new[NY][NX];
    double hx = 1.0 / NX, hy = HEIGHT / NY, dt = 0.2 / (kx / hx / hx + ky / hy / hy);
    int steps = (int)ceil(TIME / dt);
    dt = TIME / steps;
    for (int s = 0; s < steps; s++) {
        for (int j = 0; j < NY; j++)
            for (int i = 0; i < NX; i++) {
                double c = e[j][i], side[4] = {0};
                for (int hi = 0; hi < 2; hi++) {
                    int edge_x = i == (hi ? NX - 1 : 0), edge_y = j == (hi ? NY - 1 : 0);
                    double wall = at->x[hi][j];
                    side[hi] = !edge_x ? e[j][i + 2 * hi - 1] : held ? 2 * wall - c : c + wall * hx / kx;
                    side[2 + hi] = !edge_y ? e[j + 2 * hi - 1][i] : c + at->y[hi][i] * hy / ky;
                }
                new[j][i] = c + dt *(kx * (side[0] + side[1] - 2 * c) / hx / hx +
                                     ky * (side[2] + side[3] - 2 * c) / hy / hy + r[j][i]);
            }
        memcpy(e, new, sizeof new);
    }
}

/* What ghosts miss of S, from the weights across a wall: sum w x_i^a x_ghost^b (-1)^i over pairs of row and ghost. */
static double across(const struct stencil *s, int axis, int a, int b, int alternate) {
    double sum = 0;
    for (int i = 0; i < s->reach[axis]; i++)
        for (int k = i + 1; k <= s->reach[axis]; k++)
            for (int m = -s->reach[1 - axis]; m <= s->reach[1 - axis]; m++)
                sum += (axis ? stencil_weight(s, m, k) : stencil_weight(s, k, m)) * pow(i + 0.5, a) *
                       pow(k - i - 0.5, b) * (alternate && i % 2 ? -1 : 1);
    return sum;
}

struct foretold {
    double e[NY][NX], g[NY][NX]; /* E1 is the mean of max(|e| dx^2, |g| dx) over that of T */
    double mean;
};

/* spline: the order of the averages at the start, 0 for points; F: of Euler's steps, 0 for exact ones */
static void foretell(const char *method, double k_y, int spline, double F, struct foretold *f) {
    static double r[NY][NX], none[NY][NX];
    static struct sides at, feed;
    double k[2] = {0.02 / 1.7, k_y / 1.7}, q = 2 * PI, p = PI / HEIGHT, rate = k[0] * q * q + k[1] * p * p;
    struct stencil s = stencil_of(method, k);
    double a = stencil_moment(&s, 4, 0, 0) / 24, b = stencil_moment(&s, 0, 4, 0) / 24;
    double c = stencil_moment(&s, 2, 2, 0) / 4, flux = -across(&s, 1, 0, 3, 0) / 3;
    double wall = -across(&s, 0, 1, 2, 0) / k[0], kink = -across(&s, 0, 0, 2, 1);
    double Z = AMPLITUDE * exp(-rate * TIME), mode = TIME * (a * pow(q, 4) + b * pow(p, 4) + c * q * q * p * p);
    mode -= TIME * F / 2 / k[0] * rate * rate + spline / 24.0 * (q * q + p * p);
    *f = (struct foretold){.mean = 0};
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++) {
            double x = (i + 0.5) / NX, y = (j + 0.5) * HEIGHT / NY;
            r[j][i] = a * S(x, y, 4, 0) + b * S(x, y, 0, 4) + c * S(x, y, 2, 2);
            f->e[j][i] = spline / 24.0 * (S(x, y, 2, 0) + S(x, y, 0, 2));
            f->mean += (S(x, y, 0, 0) + Z * sin(q * x) * cos(p * y)) / (NX * NY);
            for (int hi = 0; hi < 2; hi++) {
                at.x[hi][j] = wall * S(hi, y, 2, 0);
                at.y[hi][i] = flux * (hi ? 1 : -1) * S(x, hi * HEIGHT, 0, 3);
                feed.x[hi][j] = (hi ? -1 : 1) * kink * S(hi, y, 2, 0); /* the last of an even number is odd */
            }
        }
    diffuse(f->e, k[0], k[1], r, &at, 1);
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++)
            f->e[j][i] += mode * Z * sin(q * (i + 0.5) / NX) * cos(p * (j + 0.5) * HEIGHT / NY);
    double m = stencil_moment(&s, 2, 0, 1) / 2, n = stencil_moment(&s, 0, 2, 1) / 2;
    if (fabs(stencil_moment(&s, 0, 0, 1)) < 1e-12) diffuse(f->g, m, n, none, &feed, 0);
    free(s.w);
}

static double E1(const struct foretold *f, double dx) {
    double sum = 0;
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++) sum += fmax(fabs(f->e[j][i]) * dx * dx, fabs(f->g[j][i]) * dx);
    return sum / (NX * NY) / f->mean;
}

static void errors_of_second_order(void **state) {
    (void)state;
    struct foretold *f = xcalloc(1, sizeof *f);
    const struct {
        const char *method;
        double k_y;
        int spline;
        double F, want;
    } row[] = {{"so_ssph", 0.005, 0, 0, 0.534},
               {"so_ssph", 0.005, 4, 0, 0.2665},
               {"brookshaw", 0.02, 0, 0, 0.434},
               {"ftcs", 0.005, 0, 0, 0.262},
               {"ftcs", 0.005, 4, 0.1, 0.7205}};
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        foretell(row[k].method, row[k].k_y, row[k].spline, row[k].F, f);
        assert_near(E1(f, 1) / row[k].want, 1, 0.005);
    }
    free(f);
}

static void errors_with_a_checkerboard(void **state) {
    (void)state;
    struct foretold *f = xcalloc(1, sizeof *f);
    foretell("fo_ssph", 0.005, 0, 0, f);
    assert_near(E1(f, 1.0 / 80) / 2.907e-4, 1, 0.005);
    assert_near(E1(f, 1.0 / 320) / 2.536e-5, 1, 0.005);
    assert_near(E1(f, 1.0 / 640) / 9.344e-6, 1, 0.005);
    foretell("ftcs_flux", 0.005, 0, 0.1, f);
    assert_near(E1(f, 1.0 / 80) / 1.586e-4, 1, 0.005);
    foretell("ftcs_flux", 0.005, 0, 0.559, f);
    assert_near(E1(f, 1.0 / 160) * 160, 0.00468, 0.00003);
    free(f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_second_order),
        cmocka_unit_test(errors_with_a_checkerboard),
    };
    return cmocka_run_group_tests_name("foretold", tests, NULL, NULL);
}
