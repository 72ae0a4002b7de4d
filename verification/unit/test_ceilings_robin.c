/* The errors that gates/cooling.def predicts for rod-cooling: what discrete modes make of its start.
 *
 * u = T - S, S the steady line, vanishes at x = 0 and has k u_x = -b u at x = L.  Modes sin(q x) with q cot(q L) =
 * -b/k decay at kappa q^2.  On a lattice of n particles the wall's ghost, midway, asks for 2 tan(q dx/2)/dx cot(q L)
 * = -b/k, a mode decays at kappa (q^2 - A q^4 dx^2), and the start has the sums over particles for integrals.  The
 * difference of the two, E1/dx^2 at dx = L/640, is the prediction. */
#include "references/scene.h"
#include "verification/unit/stencil_moments.h"

#include <math.h>

enum { N = 640, MODES = 14 };

static const double PI = 3.14159265358979323846, L = 0.3, K = 52, RHO_C = 3.6e6, T0 = 100, B = 750, T_A = 5,
                    TIME = 600;

/* Mode m; dx = 0 for the solution's own. */
static double wave_number(int m, double dx) {
    double lo = (m + 0.5) * PI / L, hi = (m + 1) * PI / L;
    for (int i = 0; i < 200; i++) {
        double q = (lo + hi) / 2, slope = dx > 0 ? 2 * tan(q * dx / 2) / dx : q;
        double sign = m % 2 ? -1 : 1; /* of sin(q L) there */
        *(sign * (slope * cos(q * L) + B / K * sin(q * L)) > 0 ? &lo : &hi) = q;
    }
    return (lo + hi) / 2;
}

static double predicted(double A, double T1) {
    double dx = L / N, kappa = K / RHO_C, rise = (T_A - T1) * B / K / (1 + B / K * L), sum = 0, mean = 0;
    double q[2][MODES], c[2][MODES];
    for (int m = 0; m < MODES; m++) {
        double size = 0, at = q[0][m] = wave_number(m, 0), end = at * L;
        q[1][m] = wave_number(m, dx);
        c[0][m] = ((T0 - T1) * (1 - cos(end)) / at - rise * (sin(end) / at - L * cos(end)) / at) /
                  (L / 2 - sin(2 * end) / (4 * at)) * exp(-kappa * at * at * TIME);
        c[1][m] = 0;
        for (int i = 0; i < N; i++) {
            double x = (i + 0.5) * dx, phi = sin(q[1][m] * x);
            c[1][m] += (T0 - T1 - rise * x) * phi, size += phi * phi;
        }
        c[1][m] *= exp(-kappa * (pow(q[1][m], 2) - A * pow(q[1][m], 4) * dx * dx) * TIME) / size;
    }
    for (int i = 0; i < N; i++) {
        double x = (i + 0.5) * dx, u[2] = {0, 0};
        for (int m = 0; m < MODES; m++)
            for (int k = 0; k < 2; k++) u[k] += c[k][m] * sin(q[k][m] * x);
        sum += fabs(u[1] - u[0]);
        mean += T1 + rise * x + u[0];
    }
    return sum / mean / (dx * dx);
}

/* sum w x^4/24 of a rod's stencil for kappa = dx = 1 */
static double symbol_error(const char *method) {
    char line[80];
    struct request r;
    struct failure why;
    const double one[2] = {1, 1};
    int reach[2];
    double *w, A = 0;
    if (strcmp(method, "ftcs") == 0) return 1.0 / 12;
    snprintf(line, sizeof line, "run rod-step %s --dx 0.1 --h 1.1 --set kappa=1", method);
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    if (operator_stencil(&r.experiment.problem, &r.experiment.options, r.experiment.method->scheme, 1, one, reach, &w,
                         &why))
        fail_msg("%s", why.text);
    for (int i = 1; i <= reach[0]; i++) A += 2 * w[i] * pow(i, 4) / 24;
    free(w);
    arguments_free(&r);
    return A;
}

/* ---- plate-cooling with the hot side as cold as the air: a product of rods, x even and y odd about 0 ---- */

enum { ROWS = 96, PLATE_MODES = 10 }; /* along x */

struct axis_modes {
    int n;
    double q[2][PLATE_MODES], c[2][PLATE_MODES]; /* of the solution, of the lattice */
};

/* b/k 750/52; a start of 1 */
static struct axis_modes axis_modes(double length, double dx, int odd) {
    struct axis_modes a = {.n = (int)round(length / dx)};
    for (int m = 0; m < PLATE_MODES; m++)
        for (int k = 0; k < 2; k++) {
            double lo = (m + 0.5 * odd) * PI / length, hi = (m + 0.5 + 0.5 * odd) * PI / length, size = 0;
            for (int i = 0; i < 200; i++) {
                double q = (lo + hi) / 2, slope = k ? 2 * tan(q * dx / 2) / dx : q, sign = m % 2 ? -1 : 1;
                double left = odd ? slope * cos(q * length) + B / K * sin(q * length)
                                  : B / K * cos(q * length) - slope * sin(q * length);
                *(sign * left > 0 ? &lo : &hi) = q;
            }
            double q = a.q[k][m] = (lo + hi) / 2, end = q * length;
            a.c[0][m] =
                k ? a.c[0][m]
                  : (odd ? 1 - cos(end) : sin(end)) / q / (length / 2 + (odd ? -1 : 1) * sin(2 * end) / (4 * q));
            for (int i = 0; k && i < a.n; i++) {
                double x = (i + 0.5) * dx, phi = odd ? sin(q * x) : cos(q * x);
                a.c[1][m] += phi, size += phi * phi;
            }
            if (k) a.c[1][m] /= size;
        }
    return a;
}

/* E1/dx^2 of so_ssph or brookshaw, whose symbol errs by A (theta_x^4 + theta_y^4) + B theta_x^2 theta_y^2 */
static double plate_predicted(const char *method, double T_a, double warm, double time) {
    const double one[2] = {1, 1}, width = 0.6, height = 1, dx = width / ROWS, kappa = K / RHO_C;
    struct stencil s = stencil_of(method, one);
    double error[2] = {stencil_moment(&s, 4, 0, 0) / 24, stencil_moment(&s, 2, 2, 0) / 4}, sum = 0, mean = 0;
    struct axis_modes x = axis_modes(width, dx, 0), y = axis_modes(height, dx, 1);
    free(s.w);
    for (int j = 0; j < y.n; j++)
        for (int i = 0; i < x.n; i++) {
            double u[2] = {0, 0};
            for (int k = 0; k < 2; k++)
                for (int n = 0; n < PLATE_MODES; n++)
                    for (int m = 0; m < PLATE_MODES; m++) {
                        double p = pow(x.q[k][m], 2), q = pow(y.q[k][n], 2);
                        double rate = p + q - (k ? dx * dx * (error[0] * (p * p + q * q) + error[1] * p * q) : 0);
                        if (kappa * rate * time > 40) continue;
                        u[k] += x.c[k][m] * y.c[k][n] * exp(-kappa * rate * time) * cos(x.q[k][m] * (i + 0.5) * dx) *
                                sin(y.q[k][n] * (j + 0.5) * dx);
                    }
            sum += fabs(u[1] - u[0]) * warm, mean += T_a + warm * u[0];
        }
    return sum / mean / (dx * dx);
}

static void errors_of_a_cooled_plate(void **state) {
    (void)state;
    assert_near(plate_predicted("so_ssph", 5, 95, 6000), 2.048, 0.003);
    assert_near(plate_predicted("brookshaw", 5, 95, 6000), 1.813, 0.003);
}

static void errors_of_a_cooled_rod(void **state) {
    (void)state;
    const struct {
        const char *method;
        double T1, want;
    } row[] = {{"so_ssph", 20, 5.61},
               {"brookshaw", 20, 5.48},
               {"ftcs", 20, 4.97},
               {"so_ssph", 100, 1.635},
               {"fo_ssph", 100, 4.77}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        assert_near(predicted(symbol_error(row[k].method), row[k].T1) / row[k].want, 1, 0.003);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_a_cooled_rod),
        cmocka_unit_test(errors_of_a_cooled_plate),
    };
    return cmocka_run_group_tests_name("ceilings of a cooled rod", tests, NULL, NULL);
}
