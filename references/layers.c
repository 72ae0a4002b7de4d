/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transient heat conduction through two layers by numerical inversion of the Laplace transform.
 *
 * In layer i, at the distance d from the contact and with q_i = sqrt(z rho_c_i/k_i), the transform of T is
 *
 *     T^ = start_i/z + (wall_i - start_i)/z sinh(q_i d)/sinh(q_i w_i)
 *                    + (theta - start_i/z) sinh(q_i (w_i - d))/sinh(q_i w_i)
 *
 * The transform theta(z) of the contact temperature follows from continuity of the flux: sum_i k_i dT^/dd = 0 at
 * d = 0.  The form uses no contact temperature, error function or eigenvalue (Carslaw and Jaeger 1959, chapter 12).
 * The inversion is Talbot's (talbot.h).
 *
 * The transform of the slope is q_i times that of T, with |q_i| < 6/sqrt(kappa_i t) wherever exp(z t) is
 * significant.  At late times it tends to that of the steady flux, which is at most k_i scale/w_i of the thinner
 * layer.
 *
 * Restrictions: constant wall temperatures, uniform initial temperature in each layer. */
#include "references/layers.h"

#include <math.h>

void layers_contour(const struct layers *w, double t, struct layers_contour *c) {
    c->w = *w;
    for (int j = 0; j < TALBOT_NODES; j++) {
        double complex z, weight, q[2], e[2], given[2], conductance = 0, flux = 0;
        talbot_node(j, &z, &weight);
        for (int i = 0; i < 2; i++) {
            q[i] = csqrt(z) * (sqrt(w->rho_c[i] / w->k[i]) / sqrt(t));
            e[i] = cexp(-q[i] * w->width[i]);
            given[i] = talbot_one_less(q[i] * w->width[i], e[i]);
            /* k q coth(q w) = g (1 + e^2) and k q/sinh(q w) = 2 g e */
            double complex g = w->k[i] * q[i] / given[i];
            conductance += g * (1 + e[i] * e[i]);
            flux += g * ((1 + e[i] * e[i]) * (w->start[i] - w->start[0]) + 2 * e[i] * (w->wall[i] - w->start[i]));
        }
        /* z times the transform of the contact temperature */
        double complex theta = w->start[0] + flux / conductance;
        for (int i = 0; i < 2; i++) {
            double complex scale = weight / z / given[i];
            c->node[i][j].q = q[i];
            c->node[i][j].wall = scale * (w->wall[i] - w->start[i]);
            c->node[i][j].core = scale * (theta - w->start[i]);
        }
    }
    double scale =
        fmax(fabs(w->start[1] - w->start[0]), fmax(fabs(w->wall[0] - w->start[0]), fabs(w->wall[1] - w->start[1])));
    double kappa = fmin(w->k[0] / w->rho_c[0], w->k[1] / w->rho_c[1]);
    c->error[0] = 2e-13 * scale + 4e-16 * fmax(fabs(w->start[0]), fabs(w->start[1]));
    double steep = fmax(w->k[0], w->k[1]) / fmin(w->k[0], w->k[1]) / fmin(w->width[0], w->width[1]);
    c->error[1] = 2e-13 * scale * (6 / sqrt(kappa * t) + steep);
}

/* sinh(q d)/sinh(q w) = (exp(-q (w - d)) - exp(-q (w + d)))/(1 - exp(-2 q w)) does not overflow. */
struct curve layers_contour_at(const struct layers_contour *c, double x) {
    int i = x >= 0;
    double d = fabs(x), width = c->w.width[i], sum = 0, slope = 0;
    for (int j = 0; j < TALBOT_NODES; j++) {
        double complex q = c->node[i][j].q, near = cexp(-q * d), far = cexp(-q * (width - d));
        double complex wall = c->node[i][j].wall, core = c->node[i][j].core;
        sum += cimag(wall * far * talbot_one_less(q * d, near) + core * near * talbot_one_less(q * (width - d), far));
        slope += cimag(q * (wall * far * (1 + near * near) - core * near * (1 + far * far)));
    }
    return (struct curve){{c->w.start[i] + sum, c->error[0]}, {i ? slope : -slope, c->error[1]}};
}
