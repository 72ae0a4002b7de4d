/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums over the kernel's gradient: V_i V_j (-dW/dr)/r is the same from either particle of a pair. */
#include "solver/particles/kernel_gradient.h"
#include "solver/particles/correction.h"
#include "solver/space/kernel.h"

#include <math.h>

/* -(dW/dr) / r, m^-(d + 2), at distance r > 0 */
static double slope_over_distance(enum kernel_name kernel, int dim, double h, double r) {
    return -kernel_slope(kernel, dim, r / h) / (r * pow(h, dim + 1));
}

double kernel_gradient_volume(const struct problem *p, const struct options *o, double h, double dV) {
    double spacing = p->dim == 2 ? sqrt(dV) : dV, moment = 0; /* the gradient of x on the lattice */
    if (o->volume == VOLUME_RAW) return dV;
    int reach = (int)ceil(KERNEL_SUPPORT * h / spacing), across = p->dim == 2 ? reach : 0;
    for (int j = -across; j <= across; j++)
        for (int i = -reach; i <= reach; i++)
            if (i) moment += slope_over_distance(o->kernel, p->dim, h, hypot(i, j) * spacing) * dV * i * i;
    return dV / (moment * spacing * spacing);
}

int kernel_gradient_pairs(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                          double C[3], struct failure *why) {
    (void)p;
    for (size_t j = 0; j < nb->n; j++) {
        double r = hypot(nb->d[j][0], nb->d[j][1]), both = nb->volume * nb->volume;
        F[j] = r > 0 ? both * slope_over_distance(o->kernel, nb->dim, nb->h, r) : 0;
    }
    C[0] = C[2] = 1 / nb->volume, C[1] = 0;
    return correction_spans(nb, F, why);
}
