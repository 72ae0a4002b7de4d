/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transient heat conduction through two layers by numerical inversion of the Laplace transform.
 *
 * In layer i, at the distance d from the contact and with q_i = sqrt(z rho_c_i/k_i), the transform of T is
 *
 *     T^ = start_i/z + (wall_i - start_i)/z sinh(q_i d)/sinh(q_i w_i)
 *                    + (theta_i - start_i/z) sinh(q_i (w_i - d))/sinh(q_i w_i)
 *
 * The transforms theta_i(z) of the two temperatures at the contact follow from its flux, k_1 dT^/dd = -k_2 dT^/dd =
 * (theta_2 - theta_1)/R at d = 0.  With k_i dT^/dd = a_i/z - G_i theta_i, G_i = k_i q_i coth(q_i w_i), they are
 *
 *     z theta_i = (a_i + a_j/B_j)/(G_i + G_j/B_j),   B_j = 1 + R G_j:
 *
 * the other layer acts in series with R.  The form uses no contact temperature, error function or eigenvalue (Carslaw
 * and Jaeger 1959, chapter 12).  The inversion is Talbot's (talbot.h).
 *
 * The transform of the slope is q_i times that of T, with |q_i| < 6/sqrt(kappa_i t) wherever exp(z t) is
 * significant.  At late times it tends to that of the steady flux, which is at most k_i scale/w_i of the thinner
 * layer.
 *
 * Restrictions: constant wall temperatures, uniform initial temperature in each layer. */
#include "references/layers.h"

#include "references/roots.h"

#include <math.h>
#include <float.h>

void layers_contour(const struct layers *w, double t, struct layers_contour *c) {
    c->w = *w;
    for (int j = 0; j < TALBOT_NODES; j++) {
        double complex z, weight, q[2], e[2], given[2], G[2], B[2], flux[2];
        talbot_node(j, &z, &weight);
        for (int i = 0; i < 2; i++) {
            q[i] = csqrt(z) * (sqrt(w->rho_c[i] / w->k[i]) / sqrt(t));
            e[i] = cexp(-q[i] * w->width[i]);
            given[i] = talbot_one_less(q[i] * w->width[i], e[i]);
            /* k q coth(q w) = g (1 + e^2) and k q/sinh(q w) = 2 g e */
            double complex g = w->k[i] * q[i] / given[i];
            G[i] = g * (1 + e[i] * e[i]);
            B[i] = 1 + w->R * G[i];
            flux[i] = g * ((1 + e[i] * e[i]) * (w->start[i] - w->start[0]) + 2 * e[i] * (w->wall[i] - w->start[i]));
        }
        for (int i = 0; i < 2; i++) {
            /* z times the transform of the temperature on this side of the contact */
            double complex theta = w->start[0] + (flux[i] + flux[1 - i] / B[1 - i]) / (G[i] + G[1 - i] / B[1 - i]);
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

/* ---- Second form: eigenfunctions ---- */

/* Transient heat conduction through two layers by eigenfunctions.
 *
 *     T = S(x) + sum_n c_n phi_n(x) exp(-w_n^2 t),   phi = A_i sin(q_i d_i),   q_i = w sqrt(rho_c_i/k_i)
 *
 * S is the steady state, d_i the distance to the wall of layer i, w_i its width.  At the contact the flux is
 * continuous and T falls by R times the flux, which we attribute to layer 1:
 *
 *     A_1 (sin(p_1) + R e_1 w cos(p_1)) = A_2 sin(p_2),   e_1 A_1 cos(p_1) = -e_2 A_2 cos(p_2),
 *     p_i = q_i w_i,  e_i = sqrt(k_i rho_c_i)
 *
 * Define the angle a_i by tan(a_i) = (e/e_i) tan(p_i), with R e w more for i = 1, and a_i = p_i at the odd multiples
 * of pi/2.  It increases with w, so a_1 + a_2 = n pi has exactly one root for each n >= 1, including modes with a
 * node at the contact (Sturm).  With v = T - start, Green's second identity gives c_n = -sum_i (wall_i - start) k_i
 * q_i A_i/(w^2 N), where N is the integral of rho_c phi^2 (Carslaw and Jaeger 1959, section 14.1; Ozisik 1993,
 * chapter 8); its terms at the contact, R times the product of two fluxes, cancel.
 *
 * Rounding: let r_i = e/e_i and H_i^2 = r_i sin^2(p_i) + cos^2(p_i)/r_i, so that da_i/dp_i = 1/H_i^2; with R the sine
 * of layer 1 is that of a_1.  The rounding of n pi changes w by a relative error n pi/sum_i(p_i/H_i^2) times larger.
 * It changes A of the other layer, which is proportional to H_i, by d(ln H_i)/dp_i = (r_i - 1/r_i) sin(p_i)
 * cos(p_i)/H_i^2, up to r_i/2 if layer i oscillates between a wall and an almost stationary contact.
 *
 * Restrictions: constant wall temperatures, uniform initial temperature. */

static const double last_exponent = 41.5; /* exp(-41.5) = 9.5e-19 */

struct angles {
    double time[2]; /* s^1/2: width sqrt(rho_c/k) */
    double ratio[2];
    double jump[2]; /* s^1/2: R e of layer 1, e the mean effusivity; 0 */
    double target;  /* n pi */
};

static struct angles angles_of(const struct layers *w) {
    struct angles a = {0};
    double e[2];
    for (int i = 0; i < 2; i++) {
        a.time[i] = w->width[i] * sqrt(w->rho_c[i] / w->k[i]);
        e[i] = sqrt(w->k[i] * w->rho_c[i]);
    }
    a.ratio[0] = sqrt(e[1] / e[0]);
    a.ratio[1] = 1 / a.ratio[0];
    a.jump[0] = w->R * sqrt(e[0] * e[1]);
    return a;
}

static double excess(double frequency, const void *data) {
    const struct angles *a = data;
    double sum = -a->target;
    for (int i = 0; i < 2; i++) sum += frequency * a->time[i];
    for (int i = 0; i < 2; i++) {
        double s = sin(frequency * a->time[i]), c = cos(frequency * a->time[i]);
        double jump = frequency * a->jump[i] * c;
        sum += atan2((a->ratio[i] - 1) * s * c + jump * c, c * c + a->ratio[i] * s * s + jump * s);
    }
    return sum;
}

double layers_modes_needed(const struct layers *w, double t) {
    struct angles a = angles_of(w);
    return 2 + (a.time[0] + a.time[1]) * sqrt(last_exponent / t) / M_PI + (w->R > 0);
}

/* Stores mode n at time t in m->mode[n - 1].  Returns 0 if the mode has decayed. */
static int add_mode(struct layers_modes *m, struct angles *a, int n, double t) {
    const struct layers *w = &m->w;
    a->target = n * M_PI;
    double sum = a->time[0] + a->time[1];
    double first = w->R > 0 ? fmax(0, n - 1.5) : n - 1; /* the jump turns a_1 by up to pi more than p_1 */
    double frequency = roots_increasing(excess, a, first * M_PI / sum, (n + 1) * M_PI / sum);
    double exponent = frequency * frequency * t, decay = exp(-exponent), A[2], q[2], sine[2], cosine[2];
    if (exponent > last_exponent) return 0;
    for (int i = 0; i < 2; i++) {
        q[i] = frequency * sqrt(w->rho_c[i] / w->k[i]);
        sine[i] = sin(q[i] * w->width[i]) * sqrt(a->ratio[i]);
        cosine[i] = cos(q[i] * w->width[i]) / sqrt(a->ratio[i]);
        sine[i] += frequency * a->jump[i] * cosine[i];
    }
    A[0] = hypot(sine[1], cosine[1]) * sqrt(a->ratio[0]);
    A[1] = copysign(hypot(sine[0], cosine[0]), sine[0] * sine[1] - cosine[0] * cosine[1]) * sqrt(a->ratio[1]);
    double norm = 0, size = 0, whole = 0, turn = 0, swing = 0;
    for (int i = 0; i < 2; i++) {
        double width = w->width[i], phase = 2 * q[i] * width;
        norm += w->rho_c[i] * A[i] * A[i] * width / 2 * (1 - sin(phase) / phase);
        size -= (w->wall[i] - w->start[i]) * w->k[i] * q[i] * A[i];
        whole += fabs((w->wall[i] - w->start[i]) * w->k[i] * q[i] * A[i]);
        double H2 = sine[i] * sine[i] + cosine[i] * cosine[i];
        turn += (q[i] * width + frequency * a->jump[i] * cosine[i] * cosine[i]) / H2;
        swing += q[i] * width * fabs((a->ratio[i] - 1 / a->ratio[i]) * sine[i] * cosine[i]) / H2;
    }
    double per_norm = decay / (frequency * frequency * norm), moved = fmax(1, a->target / turn);
    for (int i = 0; i < 2; i++) {
        double rounding = DBL_EPSILON * whole * per_norm * fabs(A[i]) *
                          (20 + moved * (8 * exponent + 4 * q[i] * w->width[i] + 4 * swing));
        m->mode[n - 1].size[i] = size * per_norm * A[i];
        m->mode[n - 1].q[i] = q[i];
        m->error[0] += rounding;
        m->error[1] += q[i] * rounding;
    }
    return 1;
}

void layers_modes(const struct layers *w, double t, struct layers_modes *m) {
    struct angles a = angles_of(w);
    double scale = fabs(w->wall[0] - w->start[0]) + fabs(w->wall[1] - w->start[1]);
    double steep = scale / fmin(w->width[0], w->width[1]) * fmax(w->k[0], w->k[1]) / fmin(w->k[0], w->k[1]);
    m->w = *w;
    m->n = 0;
    m->error[0] = 4 * DBL_EPSILON * (fabs(w->wall[0]) + fabs(w->wall[1])) + 1e-17 * scale;
    m->error[1] = 16 * DBL_EPSILON * steep;
    while (m->n < LAYERS_MODES && add_mode(m, &a, m->n + 1, t)) m->n++;
    if (m->n == LAYERS_MODES) m->error[0] = m->error[1] = INFINITY; /* some significant modes are missing */
}

struct curve layers_modes_at(const struct layers_modes *m, double x) {
    const struct layers *w = &m->w;
    int i = x >= 0;
    double sign = i ? -1 : 1, d = w->width[i] - fabs(x);
    double flux = (w->wall[1] - w->wall[0]) / (w->width[0] / w->k[0] + w->R + w->width[1] / w->k[1]);
    struct curve T = {{w->wall[i] + sign * flux / w->k[i] * d, m->error[0]}, {flux / w->k[i], m->error[1]}};
    for (int n = 0; n < m->n; n++) {
        T.at.value += m->mode[n].size[i] * sin(m->mode[n].q[i] * d);
        T.slope.value += sign * m->mode[n].size[i] * m->mode[n].q[i] * cos(m->mode[n].q[i] * d);
    }
    return T;
}
