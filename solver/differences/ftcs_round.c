/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells on rings, bands and rays of a round body: the balance of each cell,
 *
 *   r_i = r_hole + (i + 1/2) dr,   theta_j = (j + 1/2) dtheta,   dr = dx, dtheta = 2 pi/ceil(2 pi radius/dx)
 *   disc   volume r dr dtheta;  faces r_+- dtheta and dr;  distances dr and r dtheta
 *   ball   with the angle alpha from the axis z in ceil(pi radius/dx) bands
 *          volume (r_+^3 - r_-^3)/3 (cos alpha_- - cos alpha_+) dtheta
 *          faces r_+-^2 (cos alpha_- - cos alpha_+) dtheta, r dr sin(alpha_+-) dtheta and r dr dalpha
 *          distances dr, r dalpha and r sin(alpha) dtheta
 *
 * r_- = 0 closes the centre, sin(alpha_+-) = 0 the poles: faces without area carry no flux.  All three boundary
 * conditions are second order.
 *
 * Cells at the centre are dx^2 / (2 radius) wide, in a ball dx^3 / (4 radius^2) at the axis.  The stable step of an
 * explicit method would scale with their square, so each step is explicit along r and implicit along the angles,
 *
 *   (1 - dt (L_theta + L_alpha)) T_new = T + dt (the part along r + G / rho_c),
 *
 * and first order in dt.  In the norm weighted by the volumes of the cells both parts are symmetric, and the inverse
 * is at most 1: stable as far as the explicit part is.  Its largest eigenvalue is below 4 kappa / dr^2 in a disc, and
 * in a ball at most 4.24 kappa / dr^2 (of a mode at the centre, 4.121 for many rings; 4.232 for four with a held
 * wall): stable up to kappa dt / dr^2 = 1/2 and 0.47.
 *
 * The Fourier modes along theta are decoupled, -delta_theta^2 = 4 sin^2(pi k / rays) for mode k, and each has three
 * diagonals along alpha and no neighbour beyond a pole: Gaussian elimination; in a disc, of one band, a division. Two
 * inverses in succession would leave an error dt L_theta L_alpha T, of order dx^2 log(1/dx) only, since near the axis
 * both parts of a mode cos(theta) are as 1/r. */
#include "solver/differences/ftcs.h"

#include "solver/status.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>

static int is_ball(const struct ftcs_grid *g) {
    return g->p->dim == 3;
}

/* cos alpha_- - cos alpha_+ of a band; 1 in a disc */
static double band_share(const struct ftcs_grid *g, int band) {
    return is_ball(g) ? 2 * sin(g->first[1] + band * g->d[1]) * sin(g->d[1] / 2) : 1;
}

double ftcs_round_volume(const struct ftcs_grid *g, const int i[DIM_MAX]) {
    const double dr = g->d[0], r = g->first[0] + i[0] * dr;
    return (is_ball(g) ? r * r + dr * dr / 12 : r) * dr * band_share(g, i[1]) * g->d[2];
}

/* m^(dim-2): area over distance of the lower face of a cell along an axis. */
double ftcs_round_face(const struct ftcs_grid *g, int axis, const int i[DIM_MAX]) {
    const double dr = g->d[0], r = g->first[0] + i[0] * dr, below = g->p->radius[0] + i[0] * dr;
    const double alpha = g->first[1] + i[1] * g->d[1];
    switch (axis) {
    case 0:
        return (is_ball(g) ? below * below : below) * band_share(g, i[1]) * g->d[2] / dr;
    case 1:
        return i[1] == 0 || i[1] == g->n[1] ? 0 : dr * sin(i[1] * g->d[1]) * g->d[2] / g->d[1];
    default:
        return is_ball(g) ? dr * g->d[1] / (sin(alpha) * g->d[2]) : dr / (r * g->d[2]);
    }
}

struct ftcs_modes {
    fftw_plan to, from; /* along the rays, of all cells and ghosts of a sheet */
    double *ratio;      /* by ring and band, for the elimination */
};

void ftcs_round_make(struct ftcs_grid *g) {
    const int sheet = (int)g->stride[2];
    const fftw_r2r_kind kind[2] = {FFTW_R2HC, FFTW_HC2R};
    fftw_plan plan[2];
    g->modes = xcalloc(1, sizeof *g->modes);
    g->modes->ratio = xcalloc((size_t)sheet, sizeof *g->modes->ratio);
    g->held += (size_t)sheet;
#pragma omp critical(fftw_planner)
    for (int k = 0; k < 2; k++)
        plan[k] = fftw_plan_many_r2r(1, &g->n[2], sheet, g->T, NULL, sheet, 1, g->T, NULL, sheet, 1, &kind[k],
                                     FFTW_ESTIMATE | FFTW_UNALIGNED);
    g->modes->to = plan[0], g->modes->from = plan[1];
}

void ftcs_round_free(struct ftcs_grid *g) {
    if (!g->modes) return;
#pragma omp critical(fftw_planner)
    {
        fftw_destroy_plan(g->modes->to);
        fftw_destroy_plan(g->modes->from);
    }
    free(g->modes->ratio);
    free(g->modes);
    g->modes = NULL;
}

/* The inverse for the mode with -delta_theta^2 = bend on one sheet, in place; scale: 1 over the number of rays. */
static void solve_bands(const struct ftcs_grid *g, double bend, double scale, double *sheet) {
    const ptrdiff_t n = g->n[0], up = g->stride[1];
    double *ratio = g->modes->ratio;
    for (ptrdiff_t band = 0; band < g->n[1]; band++) {
        const ptrdiff_t faces = band * g->along[1], at = g->corner + band * up;
        const double *weight = g->weight + faces, *lower = g->C[1] + faces, *upper = lower + g->along[1];
        const double *around = g->C[2] + faces;
        for (ptrdiff_t i = 0; i < n; i++) { /* lower is 0 in the first band */
            double w = g->dt * weight[i], before = band ? ratio[at + i - up] : 0;
            double known = band ? sheet[at + i - up] : 0;
            double inverse = 1 / (1 + w * (lower[i] * (1 - before) + upper[i] + around[i] * bend));
            sheet[at + i] = (sheet[at + i] * scale + w * lower[i] * known) * inverse;
            ratio[at + i] = w * upper[i] * inverse;
        }
    }
    for (ptrdiff_t band = g->n[1] - 2; band >= 0; band--)
        for (ptrdiff_t i = g->corner + band * up; i < g->corner + band * up + n; i++)
            sheet[i] += ratio[i] * sheet[i + up];
}

/* The implicit part of a step, in place. */
void ftcs_round_angles(const struct ftcs_grid *g, double *T) {
    fftw_execute_r2r(g->modes->to, T, T);
    for (int k = 0; k < g->n[2]; k++) {
        double half = sin(M_PI * k / g->n[2]);
        solve_bands(g, 4 * half * half, 1.0 / g->n[2], T + k * g->stride[2]);
    }
    fftw_execute_r2r(g->modes->from, T, T);
}
