/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Customary time steps for conduction in SPH, dt = C h^2/kappa.
 *
 * Morris, Fox & Zhu 1997 (J. Comput. Phys. 136:214): C = 0.125 for a viscosity nu in place of kappa, with a quintic
 * spline
 *   of support 3 h. For a kernel with the support 2 h used here, their h is 2/3 of this h.
 * Cleary & Monaghan 1999 (J. Comput. Phys. 148:227): C = 0.15, dt = 0.15 rho c h^2/k, a cubic spline of support 2
 * h.  Biriukov & Price 2019 (MNRAS 483:4901), table of the largest stable C for three kernels in three dimensions:
 * Brookshaw's
 *   pairs 0.15, 0.18, 0.2; direct second derivatives 0.2, 0.35, 0.4; two first derivatives 0.6, 1.2, 1.6. The
 * smallest of each is used, with h of a kernel of support 2 h.
 *
 * For a method without h (cells) the default h/dx of the other methods is used, as in a code that changes only its
 * operator. */
#include "verification/stability/step_limit.h"

#include "solver/time/stepper.h"
#include <string.h>

static double biriukov(const char *method) {
    static const struct {
        const char *method;
        double C;
    } table[] = {{"brookshaw", 0.15}, {"kernel_second", 0.2}, {"conjugate", 0.6}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        if (strcmp(table[k].method, method) == 0) return table[k].C;
    return 0;
}

int customary_steps(const struct model_problem *b, struct customary_step out[CUSTOMARY_STEPS]) {
    const struct scheme *s = b->method->scheme;
    if (!s || stepper_of(b->step.stepper)->order != 1) return 0;
    double h = s->cells ? 1.1 : b->options.h, morris = h * 2 / 3, C = biriukov(b->method->name);
    int n = 0;
    out[n++] = (struct customary_step){"Morris et al. 1997, 0.125 h^2/kappa, kernel to 3 h", 0.125 * morris * morris};
    out[n++] = (struct customary_step){"Cleary & Monaghan 1999, 0.15 rho c h^2/k, kernel to 2 h", 0.15 * h * h};
    if (C > 0) out[n++] = (struct customary_step){"Biriukov & Price 2019, table, kernel to 2 h", C * h * h};
    return n;
}
