/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors that gates/time.def predicts, worked out from the references alone, and what it says of RKL2's steps.
 */
#include "solver/method.h" /* before cmocka.h, which makes a macro of `fail` */

#include "references/scene.h"
#include "verification/stability/amplification.h"
#include "verification/command/arguments.h"
#include "verification/gates/gates.h"
#include "verification/unit/near.h"

#include <complex.h>
#include <gsl/gsl_errno.h>
#include <string.h>

/* (1 + 8/(s^2 + s - 2))/18 */
static double constant(double s) {
    return (1 + 8 / (s * s + s - 2)) / 18;
}

/* The coefficients of G = sum c_k z^k by Cauchy's integral, exact for a polynomial whose degree is below POINTS. */
static void the_third_order_term_is_known(void **state) {
    (void)state;
    enum { POINTS = 64 };
    for (int s = 3; s <= 27; s += 2) {
        struct amplification a = {STEPPER_RKL2, s};
        double complex c[4] = {0};
        for (int i = 0; i < POINTS; i++) {
            double complex z = cexp(2 * M_PI * I * i / POINTS), G = amplification_factor(&a, z);
            for (int k = 0; k < 4; k++) c[k] += G / cpow(z, k) / POINTS;
        }
        for (int k = 0; k < 3; k++) assert_near(creal(c[k]), k < 2 ? 1 : 0.5, 1e-12);
        assert_near(1. / 6 - creal(c[3]), constant(s), 1e-12);
    }
}

static void stiff_modes_fall_however_stiff_they_are(void **state) {
    (void)state;
    for (int s = 3; s <= 35; s += 2) {
        struct amplification a = {STEPPER_RKL2, s};
        double most = 0, end = amplification_interval(&a);
        for (int i = 0; i <= 20000; i++) {
            double z = 1.8 + (end - 1.8) * i / 20000;
            most = fmax(most, cabs(amplification_factor(&a, -z)));
        }
        assert_order(most, <, (s == 3 ? 0.771 : s < 9 ? 0.73 : 0.7108));
    }
}

/* Its third derivative in time, K s^-3, by differences of the fourth order. */
static double third_derivative(const struct scene *s, const struct problem *p, const double x[2]) {
    static const double weight[] = {-1. / 8, 1, -13. / 8};
    double step = 0.02 * p->t_end, sum = 0;
    for (int i = 1; i <= 3; i++)
        sum += weight[3 - i] *
               (s->second(p, x, p->t_end + i * step).temperature - s->second(p, x, p->t_end - i * step).temperature);
    return sum / (step * step * step);
}

/* t <|d3T/dt3|>/<|T|>, s^-2. */
static double strength(const struct scene *s, const struct problem *p) {
    int n[2] = {p->dim == 2 ? 16 : 200, p->dim == 2 ? 16 : 1};
    double third = 0, size = 0;
    for (int i = 0; i < n[0] * n[1]; i++) {
        double x[2];
        for (int a = 0; a < 2; a++)
            x[a] = p->lo[a] + (p->hi[a] - p->lo[a]) * ((a ? i / n[0] : i % n[0]) + 0.5) / n[a];
        third += fabs(third_derivative(s, p, x));
        size += fabs(s->second(p, x, p->t_end).temperature);
    }
    return p->t_end * third / size;
}

static void ceilings_are_the_predicted_errors(void **state) {
    (void)state;
    int found = 0;
    for (const struct gate *g = gates_table; g->id; g++) {
        struct request r;
        struct failure why;
        struct field f;
        if (strncmp(g->id, "time/rkl2/", 10) != 0) continue;
        if (arguments_parse_line(g->command, &r, &why)) fail_msg("%s: %s", g->id, why.text);
        struct options finest = r.experiment.options;
        for (int i = 0; i < r.rungs.dt.count; i++) finest.dt = fmin(finest.dt, r.rungs.dt.value[i]);
        if (method_solve(r.experiment.method, &r.experiment.problem, &finest, &f, &why))
            fail_msg("%s: %s", g->id, why.text);
        double predicted = constant(f.stages) * f.dt * f.dt * strength(r.experiment.scene, &r.experiment.problem);
        if (!(fabs(g->ceiling / predicted - 1.03) <= 0.012))
            fail_msg("%s: ceiling %g, predicted %g, %d stages", g->id, g->ceiling, predicted, f.stages);
        field_free(&f);
        arguments_free(&r);
        found++;
    }
    assert_order(found, >=, 20);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_third_order_term_is_known),
        cmocka_unit_test(stiff_modes_fall_however_stiff_they_are),
        cmocka_unit_test(ceilings_are_the_predicted_errors),
    };
    return cmocka_run_group_tests_name("predicted time", tests, NULL, NULL);
}
