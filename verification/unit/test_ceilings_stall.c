/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors at which pair operators stall on rods off the lattice, as gates/operators.def predicts them.
 *
 * A cloud of pairs is a chain of conductors F_ij, with what its links in parallel and in series conduct: k_eff/k =
 * the least of sum_pairs F_ij (T_j - T_i)^2 for a unit of slope, solved here, over the lattice's.  brookshaw's
 * diffusivity is that; brookshaw_corrected divides by each particle's own S_i = sum_j F_ij d_ij^2, and has that of
 * the chain over the mean S_i/2.  A field of a diffusivity 1 - s times too small is late: T(t (1 - s)). */
#include "references/scene.h"
#include "verification/command/arguments.h"
#include "verification/command/request.h"
#include "verification/unit/near.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static const double H = 1.1; /* dx */

enum { REACH = 4, BAND = 2 * REACH + 1 };

/* F(r), of the cubic kernel up to its norm; eta: 0.1 h or 0 */
static double conductor(double r, double eta) {
    double s = r / H, slope = s < 1 ? s * (2 - 1.5 * s) : s < 2 ? (2 - s) * (2 - s) / 2 : 0;
    return slope * r / (r * r + eta * eta);
}

/* Any numbers in -1 to 1 (Knuth's MMIX generator). */
static double draw(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return 2 * ((double)(*state >> 11) * 0x1p-53) - 1;
}

/* T of the chain between ends held at -x, by Gauss within the band. */
static void settle(int n, const double *x, double eta, double *T) {
    double(*a)[BAND] = xcalloc((size_t)n, sizeof *a);
    for (int i = 0; i < n; i++) {
        int held = i < REACH || i >= n - REACH;
        T[i] = held ? -x[i] : 0;
        if (held) a[i][REACH] = 1;
        for (int o = -REACH; o <= REACH && !held; o++) {
            double F = o ? conductor(fabs(x[i + o] - x[i]), eta) : 0;
            a[i][REACH] += F, a[i][REACH + o] -= F;
        }
    }
    for (int p = 0; p < n; p++)
        for (int o = 1; o <= REACH && p + o < n; o++) {
            double f = a[p + o][REACH - o] / a[p][REACH];
            for (int z = 0; z <= REACH; z++) a[p + o][REACH - o + z] -= f * a[p][REACH + z];
            T[p + o] -= f * T[p];
        }
    for (int p = n - 1; p >= 0; T[p] /= a[p][REACH], p--)
        for (int z = 1; z <= REACH && p + z < n; z++) T[p] -= a[p][REACH + z] * T[p + z];
    free(a);
}

/* 1 - diffusivity of a rod of n particles, up to j dx off, over the true one. */
static double missing(int n, double j, int corrected, uint64_t *state) {
    double eta = corrected ? 0 : 0.1 * H, found = 0, affine = 0, lattice = 0;
    double *x = xcalloc((size_t)n, sizeof *x), *T = xcalloc((size_t)n, sizeof *T);
    for (int i = 0; i < n; i++) x[i] = i + j * draw(state);
    settle(n, x, eta, T);
    for (int i = 0; i < n; i++)
        for (int k = i + 1; k <= i + REACH && k < n; k++) {
            double F = conductor(fabs(x[k] - x[i]), eta);
            found += F * pow(T[k] - T[i], 2), affine += F * pow(x[k] - x[i], 2);
        }
    for (int m = 1; m <= REACH; m++) lattice += conductor(m, eta) * m * m * (x[n - 1] - x[0]);
    free(x), free(T);
    return 1 - found / (corrected ? affine : lattice);
}

/* Mean and standard deviation over draws. */
static void drawn(int n, double j, int corrected, double *mean, double *scatter) {
    enum { DRAWS = 60 };
    uint64_t state = 20181;
    double sum = 0, squares = 0;
    for (int k = 0; k < DRAWS; k++) {
        double s = missing(n, j, corrected, &state);
        sum += s, squares += s * s;
    }
    *mean = sum / DRAWS, *scatter = sqrt(squares / DRAWS - *mean * *mean);
}

/* E1 of a scene that is late by the part s of its time; dx is not in it. */
static double late(const char *name, double t, double s) {
    enum { POINTS = 2000 };
    struct request r;
    struct failure why;
    char line[80];
    double sum = 0, all = 0;
    snprintf(line, sizeof line, "run %s so_ssph --dx 0.1", name);
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    const struct problem *p = &r.experiment.problem;
    for (int i = 0; i < POINTS; i++) {
        double x[2] = {p->lo[0] + (p->hi[0] - p->lo[0]) * (i + 0.5) / POINTS, 0};
        double T = scene_exact(r.experiment.scene, p, x, t).temperature;
        sum += fabs(scene_exact(r.experiment.scene, p, x, t * (1 - s)).temperature - T), all += fabs(T);
    }
    arguments_free(&r);
    return sum / all;
}

static void links_in_series(void **state) {
    (void)state;
    double mean, scatter;
    const struct {
        const char *scene;
        double time, jitter;
        int particles, corrected;
        double error, apart; /* E1, and 3 standard deviations of draws */
    } row[] = {{"rod-cosine", 1, 0.1, 1280, 0, 4.46e-3, 0.63e-3},
               {"rod-cosine", 1, 0.3, 1280, 0, 0.0380, 0.0054},
               {"rod-cosine", 1, 0.1, 1280, 1, 2.35e-3, 0.29e-3},
               {"rod-cosine", 1, 0.3, 1280, 1, 0.0251, 0.0036},
               {"wall-composite", 0.1, 0.3, 128, 0, 0.129, 0.051}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        drawn(row[k].particles, row[k].jitter, row[k].corrected, &mean, &scatter);
        double error = late(row[k].scene, row[k].time, mean);
        assert_near(error, row[k].error, 0.01 * row[k].error);
        assert_near(late(row[k].scene, row[k].time, mean + 3 * scatter) - error, row[k].apart, 0.02 * row[k].apart);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(links_in_series),
    };
    return cmocka_run_group_tests_name("predicted, stalls", tests, NULL, NULL);
}
