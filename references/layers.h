#ifndef HEATLADDER_REFERENCES_LAYERS_H
#define HEATLADDER_REFERENCES_LAYERS_H

#include "references/scene.h"

/* Two layers in perfect contact at x = 0, between walls at -width[0] and width[1]. */
struct layers {
    double width[2]; /* m */
    double k[2];     /* W m^-1 K^-1 */
    double rho_c[2]; /* J m^-3 K^-1 */
    double wall[2];  /* K, held at the outer face of either layer */
    double start[2]; /* K, either layer throughout at t = 0 */
};

/* T at -width[0] <= x <= width[1] after t > 0 s, by numerical inversion of the Laplace transform; good to 1e-12 of
 * the largest temperature difference.  At t = 0 the start, with no meaning at faces that jump. */
struct exact layers_at(const struct layers *w, double x, double t);

/* Decay rate of the slowest mode, s^-1: the lowest root mu of sum_i k_i q_i cot(q_i width_i) = 0, q_i^2 = mu
 * rho_c_i/k_i, rounded down. */
double layers_slowest(const struct layers *w);

#endif
