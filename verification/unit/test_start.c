/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A start that keeps the heat of a jump, and is refused where that takes it out of its data's range. */
#include "solver/method.h"
#include "solver/particles/particles.h"
#include "solver/space/operator.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <string.h>

extern const struct method method_contact_ssph;

static double jump(const struct problem *p, const double x[2]) {
    return x[0] < p->interface ? 0.4 : 1.3;
}

static struct problem two_halves(void) {
    struct problem p = odd_rod();
    p.materials = 2, p.interface = 0.4; /* the middle of -0.35 to 1.15 m */
    p.material[1] = p.material[0];
    p.jumps[0] = 1, p.jump[0][0] = 0.4;
    p.initial = jump;
    p.t_end = 1e-5;
    return p;
}

static const struct options cells = {
    .dx = 0.05, .h = 1.1, .layout = LAYOUT_JITTER, .jitter = 0, .sampling = SAMPLING_CELL, .stepper = STEPPER_EULER};

/* A chain of equal rates, but for the first particle beyond the contact: -1.02 of one towards it.  What it keeps is
 * of the other sign there, l = -1/1.02, so that its whole is a hundredth of either side, and the side that should
 * hold a half holds some fifty wholes. */
static int one_back(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                    struct failure *why) {
    (void)why;
    for (size_t j = 0; j < nb->n; j++) {
        double d = nb->d[j][0], x = nb->x[0];
        w[0][j] = fabs(d) < 1.4 * o->dx ? nb->kappa[0] / (o->dx * o->dx) : 0;
        if (x > p->interface && x + d < p->interface) w[0][j] *= -1.02;
    }
    return STATUS_OK;
}

static const struct scheme back_scheme = {.two_materials = 1, .sweeps = 1, .keeps_start = 1, .weights = one_back};
static const struct method back = {.name = "back", .accepts = "", .scheme = &back_scheme, .solve = particles_solve};

static void a_start_outside_of_its_data_is_refused(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct failure why = {0};
    struct field f;
    assert_int_equal(method_solve(&back, &p, &cells, &f, &why), STATUS_NUMERICAL);
    if (!strstr(why.text, "the start has ") || !strstr(why.text, "the data are in [0.4, 1.3] K"))
        fail_msg("%s", why.text);
}

static void a_start_within_is_not(void **state) {
    (void)state;
    struct problem p = two_halves();
    struct failure why = {0};
    struct field f;
    if (method_solve(&method_contact_ssph, &p, &cells, &f, &why)) fail_msg("%s", why.text);
    for (size_t i = 0; i < f.n; i++) assert_true(f.T[i] > 0.4 - 0.15 && f.T[i] < 1.3 + 0.15);
    field_free(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_start_outside_of_its_data_is_refused),
        cmocka_unit_test(a_start_within_is_not),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("start", tests, NULL, NULL);
}
