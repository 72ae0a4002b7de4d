/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_STENCIL_MOMENTS_H
#define HEATLADDER_VERIFICATION_UNIT_STENCIL_MOMENTS_H

/* Stencils for tests that predict errors: of a particle method at h/dx = 1.1, or as one writes those of the finite
 * differences down. */

#include "solver/space/operator.h"
#include "verification/case/command.h"
#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct stencil { /* on spacing 1: weights of a quadrant, the rest by symmetry */
    int reach[DIM_MAX];
    double *w;
};

static inline struct stencil stencil_of(const char *method, const double kappa[2]) {
    struct stencil s;
    struct command r;
    struct failure why;
    if (strncmp(method, "ftcs", 4) == 0) {
        int step = strcmp(method, "ftcs") == 0 ? 1 : 2;
        s = (struct stencil){{step, step}, xcalloc((size_t)((step + 1) * (step + 1)), sizeof *s.w)};
        s.w[step] = kappa[0] / (step * step), s.w[step * (step + 1)] = kappa[1] / (step * step);
        s.w[0] = -2 * (s.w[step] + s.w[step * (step + 1)]);
        return s;
    }
    char line[160]; /* brookshaw takes its conductivity from the problem */
    snprintf(line, sizeof line, "run square-step %s%s --dx 0.1 --set kappa_x=%.17g --set kappa_y=%.17g", method,
             strstr(method, "--h ") ? "" : " --h 1.1", kappa[0], kappa[1]);
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    if (operator_stencil(&r.experiment.problem, &r.experiment.options, r.experiment.method->scheme, 1, kappa, s.reach,
                         &s.w, &why))
        fail_msg("%s", why.text);
    command_free(&r);
    return s;
}

static inline double stencil_weight(const struct stencil *s, int i, int j) {
    i = abs(i), j = abs(j);
    return i > s->reach[0] || j > s->reach[1] ? 0 : s->w[j * (s->reach[0] + 1) + i];
}

/* sum w x^a y^b, with `alternate` of w (-1)^x x^a y^b */
static inline double stencil_moment(const struct stencil *s, int a, int b, int alternate) {
    double sum = 0;
    for (int j = -s->reach[1]; j <= s->reach[1]; j++)
        for (int i = -s->reach[0]; i <= s->reach[0]; i++)
            sum += stencil_weight(s, i, j) * pow(i, a) * pow(j, b) * (alternate && i % 2 ? -1 : 1);
    return sum;
}

#endif
