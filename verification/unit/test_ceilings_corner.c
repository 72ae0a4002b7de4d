/* The error at a corner where two walls of different temperature meet, that plane.def predicts for the plate.  There
 * T = T_y + (T_x - T_y) 2/pi atan(y/x), and the error depends on position/dx alone: one discrete problem on a quarter
 * of the plane, spacing 1, jump 1, solved by relaxation.  Its rim holds the far field: with L = lap + dx^2 (A (d_x^4
 * + d_y^4) + B d_x^2 d_y^2) the error e solves lap e = -(2 A - B) T_xxxx, T_xxxx = 12/pi sin(4 theta)/r^4, so that e
 * = (2 A - B)/pi sin(4 theta)/r^2.  (sin(2 theta)/r^2, of no source, is even when x and y are swapped; e is odd.) */
#include "verification/unit/stencil_moments.h"

enum { N = 36, GHOSTS = 4, WIDE = N + 2 * GHOSTS };

static const double PI = 3.14159265358979323846;

static double far_field(double x, double y) {
    return 2 / PI * atan2(y, x);
}

static double far_error(double x, double y, double excess) {
    return excess / PI * sin(4 * atan2(y, x)) / (x * x + y * y);
}

static double T[WIDE][WIDE];

/* T at cell (i, j) counted from the corner, -1 being the first ghost: y = 0 holds 0, x = 0 holds 1. */
static double at(int i, int j) {
    int gi = i < 0 ? -1 - i : i, gj = j < 0 ? -1 - j : j;
    double inner = T[gj][gi];
    if (i < 0 && j < 0) return inner; /* the mean of the two orders of reflection, 2 + T and T - 2 */
    if (i < 0) return 2 - inner;
    return j < 0 ? -inner : inner;
}

static double relax(const struct stencil *s) {
    double most = 0;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            double sum = 0;
            for (int b = -s->reach[1]; b <= s->reach[1]; b++)
                for (int a = -s->reach[0]; a <= s->reach[0]; a++)
                    if (a || b) sum += stencil_weight(s, a, b) * at(i + a, j + b);
            double change = -sum / stencil_weight(s, 0, 0) - T[j][i];
            T[j][i] += change;
            most = fmax(most, fabs(change));
        }
    return most;
}

/* The largest error, and in *ratio that over the far field's at the cell (7, 2). */
static double largest(const char *method, double *ratio) {
    struct stencil s = stencil_of(method, (const double[]){1, 1});
    double excess = 2 * stencil_moment(&s, 4, 0, 0) / 24 - stencil_moment(&s, 2, 2, 0) / 4, most = 0;
    for (int j = 0; j < WIDE; j++)
        for (int i = 0; i < WIDE; i++) {
            double x = i + 0.5, y = j + 0.5;
            T[j][i] = far_field(x, y) + far_error(x, y, excess);
        }
    while (relax(&s) > 1e-10) continue;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) most = fmax(most, fabs(T[j][i] - far_field(i + 0.5, j + 0.5)));
    *ratio = (T[2][7] - far_field(7.5, 2.5)) / far_error(7.5, 2.5, excess);
    free(s.w);
    return most;
}

static void the_largest_error_at_a_corner(void **state) {
    (void)state;
    double ratio;
    assert_near(largest("so_ssph", &ratio), 0.00704, 0.000005);
    assert_near(ratio, 1, 0.03); /* dx^4/r^6 beside it */
    assert_near(largest("ftcs", &ratio), 0.02193, 0.000005);
    assert_near(ratio, 1, 0.03);
    assert_near(largest("brookshaw", &ratio), 0.002926, 0.0000005); /* 2 A - B = -0.0024: no far field to speak of */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_largest_error_at_a_corner),
    };
    return cmocka_run_group_tests_name("corner", tests, NULL, NULL);
}
