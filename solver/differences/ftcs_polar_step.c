/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps of the finite differences in a round body.
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
 * L_theta is a delta_theta^2 with one a on each circle.  In a disc the inverse is (1 - z)^2 / ((1 - z E)(1 - z / E)),
 * where E is the shift by one ray and z + 1/z = 2 + 1/a: one sweep around in each direction.  In a ball the Fourier
 * modes along theta are decoupled, -delta_theta^2 = 4 sin^2(pi k / rays) for mode k, and each has three diagonals
 * along alpha and no neighbour beyond a pole: Gaussian elimination.  Two inverses in succession would leave an error
 * dt L_theta L_alpha T, of order dx^2 log(1/dx) only, since near the axis both parts of a mode cos(theta) are as 1/r.
 */
#include "solver/differences/ftcs_polar.h"

#include "solver/status.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Rates of the parts along the angles, times dt. */
static void angles_make(struct polar *g, int ring, int band) {
    const double r = ftcs_polar_radius(g, ring), alpha = (band + 0.5) * g->down;
    const ptrdiff_t at = (ptrdiff_t)band * g->rings + ring;
    if (g->dim == 3) {
        double share = g->kappa * g->dt * g->dr / (ftcs_polar_wedge(g, ring) * 2 * sin(alpha) * sin(g->down / 2));
        g->lower[at] = band > 0 ? share * sin(band * g->down) / g->down : 0;
        g->upper[at] = band < g->bands - 1 ? share * sin((band + 1) * g->down) / g->down : 0;
        g->around[at] = share * g->down / (sin(alpha) * g->dtheta * g->dtheta);
        return;
    }
    double a = g->kappa * g->dt / (r * r * g->dtheta * g->dtheta), root = sqrt(1 + 4 * a);
    double rest = (1 + root) / (1 + 2 * a + root); /* 1 - z */
    g->z[at] = 2 * a / (1 + 2 * a + root);
    g->scale[at] = rest * rest;
}

void ftcs_polar_step_factors(struct polar *g) {
    for (int i = 0; i < g->rings; i++) {
        double r = ftcs_polar_radius(g, i), rate = g->kappa / (ftcs_polar_wedge(g, i) * g->dr);
        g->in[i] = i > 0 ? rate * ftcs_polar_face(g, r - g->dr / 2) : 0;
        g->out[i] = i < g->rings - 1 ? rate * ftcs_polar_face(g, r + g->dr / 2) : 0;
        for (int band = 0; band < g->bands; band++) angles_make(g, i, band);
    }
}

/* ---- Fourier modes along theta in a ball ---- */

struct polar_modes {
    fftw_plan to, from;
};

struct polar_modes *ftcs_polar_step_modes(const struct polar *g) {
    const int sheet = g->rings * g->bands;
    const fftw_r2r_kind kind[2] = {FFTW_R2HC, FFTW_HC2R};
    fftw_plan plan[2];
    struct polar_modes *m = xcalloc(1, sizeof *m);
#pragma omp critical(fftw_planner)
    for (int k = 0; k < 2; k++)
        plan[k] = fftw_plan_many_r2r(1, &g->rays, sheet, g->T, NULL, sheet, 1, g->T, NULL, sheet, 1, &kind[k],
                                     FFTW_ESTIMATE | FFTW_UNALIGNED);
    m->to = plan[0], m->from = plan[1];
    return m;
}

void ftcs_polar_step_modes_free(struct polar_modes *m) {
    if (!m) return;
#pragma omp critical(fftw_planner)
    {
        fftw_destroy_plan(m->to);
        fftw_destroy_plan(m->from);
    }
    free(m);
}

/* The inverse for the mode with -delta_theta^2 = bend on one sheet, in place. */
static void solve_bands(const struct polar *g, double bend, double *sheet) {
    const ptrdiff_t n = g->rings, all = n * g->bands;
    for (ptrdiff_t at = 0; at < all; at += n) {
        const double *lower = g->lower + at, *upper = g->upper + at, *around = g->around + at;
        double *T = sheet + at, *ratio = g->row + at;
        for (ptrdiff_t i = 0; i < n; i++) { /* lower is 0 in the first band */
            double before = at ? ratio[i - n] : 0, known = at ? T[i - n] : 0;
            double inverse = 1 / (1 + lower[i] * (1 - before) + upper[i] + around[i] * bend);
            T[i] = (T[i] + lower[i] * known) * inverse;
            ratio[i] = upper[i] * inverse;
        }
    }
    for (ptrdiff_t at = all - 2 * n; at >= 0; at -= n)
        for (ptrdiff_t i = at; i < at + n; i++) sheet[i] += g->row[i] * sheet[i + n];
}

static void step_angles(struct polar *g) {
    const ptrdiff_t n = (ptrdiff_t)g->rings * g->bands;
    fftw_execute(g->modes->to);
    for (ptrdiff_t k = 0; k < g->rays; k++) {
        double half = sin(M_PI * (double)k / g->rays);
        solve_bands(g, 4 * half * half, g->T + k * n);
    }
    fftw_execute(g->modes->from);
    for (ptrdiff_t i = 0; i < n * g->rays; i++) g->T[i] /= g->rays;
}

/* ---- One step ---- */

/* T + dt (the part along r + heating) of one line, in place. */
static void step_line(struct polar *g, ptrdiff_t line) {
    const int n = g->rings;
    const double dt = g->dt, *in = g->in, *out = g->out, *heating = g->heating + line * n;
    double *restrict row = g->row, *T = g->T + line * n;
    row[0] = T[0] + dt * (out[0] * (T[1] - T[0]) - in[0] * (T[0] - g->beside[0][line]) + heating[0]);
    for (int i = 1; i < n - 1; i++)
        row[i] = T[i] + dt * (out[i] * (T[i + 1] - T[i]) - in[i] * (T[i] - T[i - 1]) + heating[i]);
    row[n - 1] = T[n - 1] + dt * (out[n - 1] * (g->beside[1][line] - T[n - 1]) - in[n - 1] * (T[n - 1] - T[n - 2]) +
                                  heating[n - 1]);
    memcpy(T, row, (size_t)n * sizeof *T);
}

/* The filter 1 / (1 - z E) around each ring of a disc, along the rays or backwards; `sum` over all rays, weighted by
 * powers of z, is the value before the first ray times 1 - z^rays.  The first makes the sums for the way back. */
static void sum_up(struct polar *g, ptrdiff_t ray) {
    const double *z = g->z, *T = g->T + ray * g->rings;
    double *restrict sum = g->sum;
    for (int i = 0; i < g->rings; i++) sum[i] = T[i] + z[i] * sum[i];
}

static void sweep_around(struct polar *g, int backwards) {
    const int n = g->rings;
    const double *z = g->z;
    double *restrict before = g->row;
    for (int i = 0; i < n; i++) {
        before[i] = g->sum[i] / -expm1(g->rays * log(z[i]));
        g->sum[i] = 0;
    }
    for (ptrdiff_t k = 0; k < g->rays; k++) {
        double *restrict T = g->T + (backwards ? g->rays - 1 - k : k) * n;
        for (int i = 0; i < n; i++) before[i] = T[i] = T[i] + z[i] * before[i];
    }
    for (ptrdiff_t j = g->rays - 1; j >= 0 && !backwards; j--) sum_up(g, j);
}

void ftcs_polar_step(struct polar *g) {
    const ptrdiff_t lines = (ptrdiff_t)g->rays * g->bands;
    if (g->dim == 2) memset(g->sum, 0, (size_t)g->rings * sizeof *g->sum);
    for (ptrdiff_t line = 0; line < lines; line++) {
        step_line(g, line);
        if (g->dim == 2) sum_up(g, line);
    }
    if (g->dim == 3) {
        step_angles(g);
        return;
    }
    sweep_around(g, 0);
    sweep_around(g, 1);
    for (ptrdiff_t j = 0; j < g->rays; j++)
        for (int i = 0; i < g->rings; i++) g->T[j * g->rings + i] *= g->scale[i];
}
