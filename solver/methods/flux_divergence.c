/* The divergence of the flux (Lucy 1977; Pamplona 2019, eq. 10): the kernel's gradient, twice,
 *   q_i = -kappa sum_j V_j (T_j - T_i) grad W_ij,   dT_i/dt = -sum_j V_j (q_j - q_i) . grad W_ij.
 *
 * Exact: for constants; with --volume moment, where sum_j V_j x_j dW/dx = 1 on the lattice, for linear T in each
 * sweep there, and so for quadratics in both.  On a cloud the gradient of a linear T is wrong by O(disorder), and its
 * differences by O(disorder / h).
 * As printed the sum takes differences of fluxes: a pair gives both particles the same, not the opposite, so heat is
 * conserved on a lattice only.  Modes of wavelength 2 dx lie in the null space, as with fo_ssph, whose moment matrix
 * is what this one lacks.
 * A particle all of whose neighbours lie on one line has no flux across it (correction_spans): refused.
 * The choices: differences of T in the gradient too, without which a constant would have one on a cloud; where h
 * differs, a pair has the mean of both. */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"
#include "solver/space/gradient.h"
#include "solver/space/kernel.h"

#include <math.h>

static int check(const struct problem *p, const struct options *o, struct failure *why) {
    if (o->volume == VOLUME_TUNED)
        return refuse(why, STATUS_NOT_APPLICABLE, "--volume tuned: flux_divergence takes moment and raw");
    return correction_check(p, "flux_divergence", 0, why);
}

/* -(dW/dr) / r, m^-(d + 2), at distance r > 0 */
static double slope_over_distance(enum kernel_name kernel, int dim, double h, double r) {
    return -kernel_slope(kernel, dim, r / h) / (r * pow(h, dim + 1));
}

static double volume(const struct problem *p, const struct options *o, double h, double dV) {
    double spacing = p->dim == 2 ? sqrt(dV) : dV, moment = 0; /* the gradient of x on the lattice */
    if (o->volume == VOLUME_RAW) return dV;
    int reach = (int)ceil(KERNEL_SUPPORT * h / spacing), across = p->dim == 2 ? reach : 0;
    for (int j = -across; j <= across; j++)
        for (int i = -reach; i <= reach; i++)
            if (i) moment += slope_over_distance(o->kernel, p->dim, h, hypot(i, j) * spacing) * dV * i * i;
    return dV / (moment * spacing * spacing);
}

static int pairs(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                 double C[3], struct failure *why) {
    (void)p;
    for (size_t j = 0; j < nb->n; j++) {
        double r = hypot(nb->d[j][0], nb->d[j][1]), both = nb->volume * neighbourhood_volume(nb, j);
        F[j] = r > 0 ? both * slope_over_distance(o->kernel, nb->dim, neighbourhood_mean_h(nb, j), r) : 0;
    }
    C[0] = C[2] = 1 / nb->volume, C[1] = 0;
    return correction_spans(nb, F, why);
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                   struct failure *why) {
    double F[NEIGHBOURS_MAX], C[3];
    if (pairs(p, o, nb, F, C, why)) return why->status;
    gradient_weights(nb, F, C, w);
    return STATUS_OK;
}

static const struct scheme scheme = {
    .sweeps = 2, .check = check, .volume = volume, .weights = weights, .pairs = pairs};

const struct method method_flux_divergence = {
    .name = "flux_divergence",
    .about = "the divergence of the flux by the kernel's gradient, twice (Pamplona eq. 10)",
    .accepts = "stepper kernel h layout jitter grading sweeps redraw seed sampling walls volume",
    .scheme = &scheme,
    .solve = particles_solve,
    .outline = particles_outline,
};
