/* The error that contact_ssph makes of a start that jumps at the contact, as gates/operators.def predicts it.
 *
 * The rows of a lattice with a contact keep no heat next to it: what they keep is sum_i l_i T_i, l A = 0, and l is
 * rho_c V but for some particles on either side.  A start that is T1 on one side and T2 on the other then holds Q =
 * sum_i (l_i - rho_c V) T_i more than it should, from the first step on, and no average of the start over cells
 * changes any T_i where the contact lies between cells.  Q at the contact spreads as Q/((e_1 + e_2) sqrt(pi t))
 * exp(-x^2/(4 kappa t)), e the effusivities: first order in dx. */
#include "solver/methods/particles.h"
#include "solver/space/csr.h"
#include "verification/command/arguments.h"
#include "verification/command/request.h"
#include "verification/unit/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WINDOW = 24, ALL = 2 * WINDOW };

/* sum_i l_i A_ij = 0 for the j of the window about the contact, l = rho_c beyond it; in place of *l. */
static void kept_by(const struct heat_operator *a, size_t first, const double *rho_c, double l[ALL]) {
    static double m[ALL][ALL + 1];
    struct row r;
    csr_row_create(&r, a->n);
    for (int j = 0; j < ALL; j++)
        for (int k = 0; k <= ALL; k++) m[j][k] = 0;
    for (size_t i = first - WINDOW; i < first + ALL + WINDOW; i++) {
        operator_row_take(a, i, &r);
        for (int j = 0; j < ALL; j++) {
            double w = r.value[first + (size_t)j];
            if (i >= first && i < first + ALL)
                m[j][i - first] = w;
            else
                m[j][ALL] -= w * rho_c[i];
        }
    }
    csr_row_free(&r);
    for (int p = 0; p < ALL; p++) {
        int at = p;
        for (int j = p + 1; j < ALL; j++)
            if (fabs(m[j][p]) > fabs(m[at][p])) at = j;
        for (int k = 0; k <= ALL; k++) {
            double held = m[p][k];
            m[p][k] = m[at][k], m[at][k] = held;
        }
        for (int j = p + 1; j < ALL; j++) {
            double f = m[j][p] / m[p][p];
            for (int k = p; k <= ALL; k++) m[j][k] -= f * m[p][k];
        }
    }
    for (int p = ALL - 1; p >= 0; p--) {
        l[p] = m[p][ALL];
        for (int k = p + 1; k < ALL; k++) l[p] -= m[p][k] * l[k];
        l[p] /= m[p][p];
    }
}

/* E1/dx on a lattice whose contact lies midway between particles. */
static double predicted(const char *more) {
    struct request r;
    struct failure why;
    struct lattice lattice;
    struct cloud c;
    struct heat_operator a;
    struct options o;
    char line[120];
    int rows;
    snprintf(line, sizeof line, "run rod-contact contact_ssph --dx 1/80%s", more);
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    const struct problem *p = &r.experiment.problem;
    const struct scheme *s = r.experiment.method->scheme;
    r.experiment.options.stepper = STEPPER_EULER;
    if (particles_prepare(p, &r.experiment.options, s, &o, &lattice, &rows, &why) ||
        layout_cloud(p, &o, &lattice, particles_reach(&o, s, &lattice), &c, &why) ||
        operator_create_csr(&a, p, &o, s, &c, lattice.dx[0], &why))
        fail_msg("%s", why.text);
    double *rho_c = xcalloc(a.n, sizeof *rho_c), l[ALL], Q = 0, heat = 0, dx = lattice.dx[0];
    size_t contact = 0;
    for (size_t i = 0; i < a.n; i++) {
        rho_c[i] = p->material[layout_material(p, c.x[i])].rho_c, contact += c.x[i] < p->interface;
        double x[2] = {c.x[i], 0};
        heat += fabs(r.experiment.scene->exact(p, x, p->t_end).temperature) * dx;
    }
    kept_by(&a, contact - WINDOW, rho_c, l);
    for (size_t i = 0; i < ALL; i++) {
        double x[2] = {c.x[contact - WINDOW + i], 0};
        Q += (l[i] - rho_c[contact - WINDOW + i]) * p->initial(p, x); /* of dx */
    }
    double e = 0, spread = 0;
    for (int k = 0; k < 2; k++)
        e += sqrt(p->material[k].k[0] * p->material[k].rho_c),
            spread += sqrt(p->material[k].k[0] / p->material[k].rho_c);
    free(rho_c);
    operator_free(&a);
    layout_cloud_free(&c);
    arguments_free(&r);
    return fabs(Q) * spread / e / heat;
}

static void heat_that_a_jump_misplaces(void **state) {
    (void)state;
    assert_near(predicted(""), 0.0673, 0.0002);
    assert_near(predicted(" --set k1=1 --set rho_c1=200"), 0.01385, 5e-5);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(heat_that_a_jump_misplaces)};
    return cmocka_run_group_tests_name("predicted, a jump at a contact", tests, NULL, NULL);
}
