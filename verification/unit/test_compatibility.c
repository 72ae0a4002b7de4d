/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options that do not go together are refused: one command for each row of the tables of the particles and of the
 * finite differences. */
#include "verification/judge/run.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <string.h>

static const struct row {
    const char *command, *text;
} rows[] = {
    /* materials and data */
    {"rod-cosine kernel_second --dx 0.1 --volume tuned",
     "--volume tuned: supported by brookshaw only; use moment or raw"},
    {"rod-contact so_ssph --dx 0.1", "so_ssph: one material only, the scene has two; use brookshaw or contact_ssph"},
    {"rect-manufactured brookshaw --dx 0.1", "k_x = 0.02 and k_y = 0.005; use so_ssph"},
    {"rod-contact contact_ssph --dx 0.1 --sampling spline", "--sampling spline: four cells of two materials"},
    {"rect-manufactured so_ssph --dx 0.1 --set rise=2 --shift 0.3",
     "so_ssph: walls or a source that change in time need one material"},
    {"wave schwaiger --dx 0.1 --set kappa_xy=0.004", "schwaiger: a diagonal conductivity only, the scene has k_xy"},
    {"ring brookshaw --dx 0.1", "brookshaw: takes k_xy where it is constant and sides are periodic"},
    {"wave fo_ssph --dx 0.1 --set kappa_xy=0.004 --layout jitter",
     "--layout jitter: with k_xy derivatives applied twice are second order on a lattice alone; use lattice"},
    /* layouts */
    {"wave so_ssph --dx 0.1 --layout node", "--layout node: the scene has no walls; use lattice"},
    {"rod-cooling so_ssph --dx 0.03 --layout node", "--layout node: a Robin wall is midway"},
    {"rod-contact contact_ssph --dx 0.1 --layout node", "--layout node: two materials give each particle a row"},
    {"rod-cosine so_ssph --dx 0.1 --layout node --shift 0.3", "--layout node: requires walls between particles"},
    {"disc-mode so_ssph --dx 0.1 --layout relaxed", "--layout relaxed: particles settle between plane walls"},
    {"rod-cosine so_ssph --dx 0.1 --layout hexagonal --shift 0.3", "--layout hexagonal: requires --walls mirror"},
    /* walls */
    {"wave so_ssph --dx 0.1 --shift 0.3", "--shift 0.3: the scene is periodic and has no walls; use 0"},
    {"wave so_ssph --dx 0.1 --walls fit", "--walls fit: the scene is periodic and has no walls; use mirror"},
    {"rod-cosine voronoi_flux --dx 0.1 --walls fit", "--walls fit: only round walls can cut cells"},
    {"rod-contact contact_ssph --dx 0.1 --walls fit", "on a cut lattice one material only"},
    {"rod-cosine so_ssph --dx 0.1 --walls fit --order 3", "--order 3: on a cut lattice dummies are exact"},
    {"rod-cooling so_ssph --dx 0.03 --order 4", "--order 4: the temperature of a Robin wall varies"},
    {"rod-cosine conjugate --dx 0.1 --walls fit", "conjugate: on a cut lattice an adjoint cannot include dummies"},
    {"rod-step fo_ssph --dx 0.1 --walls distance", "--walls distance: a dummy that differs from pair to pair"},
    {"square-step fo_ssph --dx 0.1 --walls image", "--walls image: modes grow where a derivative is applied twice"},
    {"square-step fo_ssph --dx 0.1 --shift 0.2", "--walls mirror: modes grow where a derivative is applied twice"},
    {"disc-mode fatehi_manzari --dx 0.1 --walls one_sided", "--walls one_sided: needs the least squares of so_ssph"},
    {"disc-mode so_ssph --dx 0.1 --sampling cell", "--sampling cell: a round wall cuts cells; use point"},
    {"disc-mode so_ssph --dx 0.1 --walls mirror", "--walls mirror: images of particles need plane walls"},
    {"annulus so_ssph --dx 0.1 --walls fixed", "--walls fixed: does not support a Neumann wall; use fit"},
    /* steppers */
    {"rod-step so_ssph --dx 0.1 --stepper exact --layout jitter", "--stepper exact: requires one stencil"},
    {"rod-driven so_ssph --dx 0.1 --stepper exact", "--stepper exact: solves dT/dt = A T + g with a constant g"},
    {"rod-cooling so_ssph --dx 0.03 --stepper matched", "--stepper matched: the temperature of a Robin wall varies"},
    {"rod-step so_ssph --dx 0.1 --stepper exact --walls fixed", "--stepper exact: a transform requires mirror walls"},
    /* finite differences */
    {"disc-mode ftcs_flux --dx 0.1", "ftcs_flux: needs a rod or a rectangle, this scene has a round body; use ftcs"},
    {"disc-mode ftcs --dx 0.1 --layout node", "--layout node: a round body has rings and rays"},
    {"disc-mode ftcs --dx 0.1 --sampling cell", "--sampling cell: rings and rays take points; use point"},
    {"disc-mode ftcs --dx 0.1 --walls fixed", "--walls fixed: is for particles; use mirror"},
    {"disc-mode ftcs --dx 0.1 --stepper rk2", "--stepper rk2: a round body has euler and auto"},
    {"rod-contact brookshaw --dx 0.1 --set R=1 --mean harmonic", "--mean harmonic: has no place for a contact res"},
    {"rod-contact ftcs --dx 0.1 --set R=1 --mean arithmetic", "--mean arithmetic: has no place for a contact res"},
    {"rod-contact ftcs_flux --dx 0.1", "ftcs_flux: takes one material, the scene has two; use ftcs"},
    {"rod-contact ftcs --dx 0.1 --sampling spline", "--sampling spline: takes one material; use point or cell"},
    {"rod-contact ftcs --dx 0.1 --layout node", "--layout node: takes one material; use lattice"},
    {"rod-contact ftcs --dx 0.1 --stepper matched", "--stepper matched: takes one material; use euler"},
    {"wave ftcs_flux --dx 0.1 --set kappa_xy=0.004", "a diagonal conductivity only, the scene has k_xy"},
    {"wave ftcs --dx 0.1 --cross corner", "--cross corner: k_xy is 0 in this scene; omit it"},
    {"rod-cooling ftcs --dx 0.03 --layout node", "--layout node: a Robin wall is midway"},
    {"rod-cooling ftcs --dx 0.03 --stepper matched", "--stepper matched: the ghosts of a Robin wall"},
    {"wave ftcs --dx 0.1 --layout node", "--layout node: the scene is periodic and has no walls; use lattice"},
    {"wave ftcs --dx 0.1 --walls fixed", "--walls fixed: the scene is periodic and has no walls; use mirror"},
    {"rod-step ftcs --dx 0.1 --layout jitter", "--layout jitter: finite differences need a grid"},
    {"rod-step ftcs --dx 0.1 --walls fit", "--walls fit: is for particles; use mirror or fixed"},
    {"rod-step ftcs --dx 0.1 --stepper chebyshev", "--stepper chebyshev: finite differences have euler, rk2"},
    {"square-step ftcs --dx 0.1 --stepper matched", "--stepper matched: in the plane the error is not isotropic"},
};

static void incompatible_options_are_refused(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct command_run run;
        int status = command_run_line(&run, "run %s", rows[k].command);
        if (status != STATUS_NOT_APPLICABLE || !strstr(run.result.failure.text, rows[k].text))
            fail_msg("%s: status %d, %s", rows[k].command, status, run.result.failure.text);
        command_run_free(&run);
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {cmocka_unit_test(incompatible_options_are_refused)};
    return cmocka_run_group_tests_name("compatibility", tests, NULL, NULL);
}
