/* What follows from a problem alone. */
#include "solver/problem.h"

#include <math.h>

double problem_diffusivity(const struct problem *p) {
    double kappa = 0;
    for (int m = 0; m < p->materials; m++)
        for (int a = 0; a < p->dim; a++) kappa = fmax(kappa, p->material[m].k[a] / p->material[m].rho_c);
    return kappa;
}
