/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Table 1 of Pamplona 2019 under other readings, by a program of its own: 20 x 20 points with two layers of ghosts,
 * eq. 13 or 16, steps as in plate.h, against eqs. 2 and 4 with signs corrected and their sums cut off.
 *
 *   T = sum_n odd 4/(n pi) [(T1 S(1 - y/a) + T3 S(y/a)) sin(n pi x/a) + (T2 S(x/a) + T4 S(1 - x/a)) sin(n pi y/a)]
 *     - sum_mp K_mp sin(m pi x/a) sin(p pi y/a) exp(-(m^2 + p^2) pi^2 alpha t/a^2),   S(u) = sinh(n pi u)/sinh(n pi)
 *   K_mp = 8/(pi^2 (m^2 + p^2)) [p/m (T1 - (-1)^p T3) for odd m  +  m/p (T4 - (-1)^m T2) for odd p] */
#include "reports/pamplona/readings.h"

#include "solver/space/kernel.h"
#include "reports/figure/published.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const readings_places[READINGS_PLACES] = {"as stated, walls midway", "clock ahead by (21/20)^2 alone",
                                                      "walls on the ghosts, 0.105 m"};
const char *const readings_corners[READINGS_CORNERS] = {"mean", "left and right", "top and bottom"};
const int readings_terms[READINGS_SERIES] = {7, 15, 23, 27, 51, 201};

enum { N = PLATE_SIDE, LAYERS = 2, S = N + 2 * LAYERS, TERMS = 201, REACH = 2 };
typedef double grid[S][S];

static const double T1 = 0.25, T2 = 0.50, T3 = 0.75, T4 = 1.00, DX = 0.005, ALPHA = 60.5 / (7854 * 434.);
static const double STEP = 0.08115; /* s */

static void fill_ghosts(grid T, int corner) {
    memset(T, 0, sizeof(grid));
    for (int j = 0; j < S; j++)
        for (int i = 0; i < S; i++) {
            int beside = i < LAYERS || i >= S - LAYERS, above = j < LAYERS || j >= S - LAYERS;
            double x = i < LAYERS ? T4 : T2, y = j < LAYERS ? T1 : T3;
            double both = corner == 0 ? (x + y) / 2 : corner == 1 ? x : y;
            if (beside || above) T[j][i] = beside && above ? both : beside ? x : y;
        }
}

/* Eq. 13 with xi = 1.643 m and N = 576, or eq. 16; s^-1. */
static void weights_of(int method, double w[2 * REACH + 1][2 * REACH + 1]) {
    const double h = 1.2 * DX, volume = 0.1 * 0.1 * 1.643 / (S * S);
    double sum = 0;
    for (int j = -REACH; j <= REACH; j++)
        for (int i = -REACH; i <= REACH; i++) {
            double r = hypot(i, j) * DX, *at = &w[j + REACH][i + REACH];
            *at = 0;
            if (method == PLATE_FTCS && i * i + j * j == 1) *at = ALPHA / (DX * DX);
            if (method == PLATE_SPH && r > 0 && r < KERNEL_SUPPORT * h)
                *at = -2 * ALPHA * volume * kernel_slope(KERNEL_QUARTIC, 2, r / h) / (h * h * h) * r /
                      (r * r + 0.01 * h * h);
            sum += *at;
        }
    w[REACH][REACH] -= sum;
}

/* next = T + dt L(of), inside. */
static void advance(double w[2 * REACH + 1][2 * REACH + 1], grid T, grid of, double dt, grid next) {
    for (int j = LAYERS; j < S - LAYERS; j++)
        for (int i = LAYERS; i < S - LAYERS; i++) {
            double rate = 0;
            for (int b = -REACH; b <= REACH; b++)
                for (int a = -REACH; a <= REACH; a++) rate += w[b + REACH][a + REACH] * of[j + b][i + a];
            next[j][i] = T[j][i] + dt * rate;
        }
}

/* The inner points after factor * t, at each time of the table. */
static void solve(int method, int corner, double factor, const struct published *t, double T[PLATE_TIMES][N * N]) {
    double w[2 * REACH + 1][2 * REACH + 1];
    grid *g = xcalloc(3, sizeof *g); /* T, half a step on, a step on */
    for (int i = 0; i < 3; i++) fill_ghosts(g[i], corner);
    weights_of(method, w);
    for (int k = 0, step = 0; k < PLATE_TIMES; k++) {
        for (int end = (int)lround(factor * atof(t->where[k]) / STEP); step < end; step++) {
            if (method == PLATE_SPH) advance(w, g[0], g[0], STEP / 2, g[1]);
            advance(w, g[0], g[method == PLATE_SPH], STEP, g[2]);
            memcpy(g[0], g[2], sizeof *g);
        }
        for (int j = 0; j < N; j++) memcpy(&T[k][j * N], &g[0][j + LAYERS][LAYERS], N * sizeof(double));
    }
    free(g);
}

/* sinh(q u)/sinh(q), 0 <= u <= 1 */
static double strip(double q, double u) {
    return exp(q * (u - 1)) * (1 - exp(-2 * q * u)) / (1 - exp(-2 * q));
}

static double coefficient(int m, int p) {
    const double pi = M_PI, sign_m = m % 2 ? -1 : 1, sign_p = p % 2 ? -1 : 1;
    double sum = (m % 2 ? (double)p / m * (T1 - sign_p * T3) : 0) + (p % 2 ? (double)m / p * (T4 - sign_m * T2) : 0);
    return 8 / (pi * pi * (m * m + p * p)) * sum;
}

/* Cut off after `terms`; a plate of side a, m, whose points begin at x0. */
static void series(double a, double x0, double t, int terms, double T[N * N]) {
    const double pi = M_PI;
    double(*table)[N] = xcalloc(4 * (TERMS + 1), sizeof *table);
    double(*sine)[N] = table, (*inner)[N] = sine + TERMS + 1, (*lo)[N] = inner + TERMS + 1, (*hi)[N] = lo + TERMS + 1;
    for (int n = 1; n <= terms; n++)
        for (int i = 0; i < N; i++) {
            double u = (x0 + i * DX) / a;
            sine[n][i] = sin(n * pi * (x0 + i * DX) / a);
            lo[n][i] = strip(n * pi, 1 - u), hi[n][i] = strip(n * pi, u);
        }
    for (int m = 1; m <= terms; m++) /* the double sum over p, for each row of points */
        for (int p = 1; p <= terms; p++) {
            double decay = (m * m + p * p) * pi * pi * ALPHA * t / (a * a);
            double K = decay < 60 ? coefficient(m, p) * exp(-decay) : 0;
            for (int j = 0; j < N && K != 0; j++) inner[m][j] += K * sine[p][j];
        }
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            double sum = 0;
            for (int n = 1; n <= terms; n++) {
                sum -= sine[n][i] * inner[n][j];
                if (n % 2 == 0) continue;
                double q = n * pi;
                sum += 4 / q * sine[n][i] * (T1 * lo[n][j] + T3 * hi[n][j]);
                sum += 4 / q * sine[n][j] * (T2 * hi[n][i] + T4 * lo[n][i]);
            }
            T[j * N + i] = sum;
        }
    free(table);
}

static void compare(struct reading *r, const struct published *t, double (*T)[PLATE_TIMES][N * N],
                    double exact[PLATE_TIMES][N * N]) {
    double error[PLATE_DEFINITIONS];
    for (int k = 0; k < PLATE_TIMES; k++)
        for (int i = 0; i < PLATE_METHODS; i++) {
            plate_average(T[i][k], exact[k], N, error);
            for (int d = 0; d < PLATE_DEFINITIONS; d++) {
                r->error[d][i][k] = error[d];
                r->off[d] = fmax(r->off[d], exp(fabs(log(error[d] / t->value[i][k]))));
            }
        }
    for (int d = 0; d < PLATE_DEFINITIONS; d++)
        if (r->off[d] < r->off[r->best]) r->best = d;
}

struct readings *readings_try(const struct published *t) {
    struct readings *all = xcalloc(1, sizeof *all);
    double(*T)[PLATE_TIMES][N * N] = xcalloc(PLATE_METHODS, sizeof *T);
    double(*exact)[PLATE_TIMES][N * N] = xcalloc(READINGS_SERIES, sizeof *exact);
    for (int place = 0; place < READINGS_PLACES; place++) {
        int outside = place == 2;
        for (int terms = 0; terms < READINGS_SERIES; terms++)
            for (int k = 0; k < PLATE_TIMES; k++)
                series(N * DX + outside * DX, (1 + outside) * DX / 2, atof(t->where[k]), readings_terms[terms],
                       exact[terms][k]);
        for (int corner = 0; corner < READINGS_CORNERS; corner++) {
            for (int i = 0; i < PLATE_METHODS; i++) solve(i, corner, place == 1 ? 1.1025 : 1, t, T[i]);
            for (int terms = 0; terms < READINGS_SERIES; terms++) {
                struct reading *r = &all->reading[all->count];
                *r = (struct reading){.place = place, .corner = corner, .terms = terms};
                compare(r, t, T, exact[terms]);
                const struct reading *nearest = &all->reading[all->nearest];
                if (r->off[r->best] < nearest->off[nearest->best]) all->nearest = all->count;
                all->count++;
            }
        }
    }
    free(exact);
    free(T);
    return all;
}
