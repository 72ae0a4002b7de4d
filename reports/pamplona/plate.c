/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pamplona 2019, section 6 and Table 1: errors on the plate.
 *
 * One interpretation fits all rows: the plate is 0.1 m wide, as stated, with 20 spacings, and its walls are midway
 * between the outermost particles and the first ghosts, which have the walls' temperatures.  The computed plate is
 * then 21 spacings wide and late by the factor (21/20)^2 in time: an error of first order, largest at early times.
 *
 * The paper prints a quartic kernel and eta = 0.1 h.  The first author's public code (github, almeriopamplona/msph,
 * folder twoDimensionalSPH) has the cubic kernel and eta = 0.01 h, and ghosts in the corners by polar order.  This
 * suite uses the cubic kernel with eta = 0.1 h, and the mean of both walls in the corners. */
#include "reports/pamplona/plate.h"

#include "reports/figure/published.h"
#include "reports/pamplona/xi.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const char *const plate_words[PLATE_METHODS] = {
    "brookshaw --kernel cubic --h 1.2 --volume tuned --xi 1.643 --walls fixed --dx 0.005 --stepper rk2 --dt 0.1623",
    "ftcs --walls fixed --dx 0.005 --dt 0.08115",
    ("brookshaw --kernel quartic --h 1.2 --volume tuned --xi 1.643 --walls fixed --dx 0.005 --stepper rk2 "
     "--dt 0.1623")};

double plate_time(int k) {
    struct published t;
    struct failure why;
    return published_read(&t, "pamplona_table1", &why) ? NAN : atof(t.where[k]);
}

double plate_conducts(void) {
    const double n = PLATE_SIDE, share = n / (n + 4);
    return 1.643 * share * share * xi_moment(KERNEL_CUBIC, 1.2, 0.01);
}

/* Adds one point's error to the sums over the ring, the left column and the middle. */
static void add_point(struct plate_errors *e, int depth, int left, int middle, double apart, double T) {
    double size = fabs(apart);
    if (depth == 0) e->ring_mean += size, e->ring_late -= apart, e->ring_part -= apart / T;
    if (left) e->left_mean += size, e->left_max = fmax(e->left_max, size);
    if (!middle) return;
    e->centre_mean += size, e->centre_max = fmax(e->centre_max, size);
    e->centre_late -= apart, e->centre_part -= apart / T;
}

void plate_measure(const struct command_run *run, double t, struct plate_errors *e) {
    const struct field *f = &run->field;
    int n = f->shape[0], middle = 0;
    double ring = 4.0 * (n - 1);
    *e = (struct plate_errors){.result = run->result};
    for (int k = 0; k < n * n; k++) {
        double x[2] = {f->x[0][k % n], f->x[1][k / n]}, exact = command_run_exact(run, x, t);
        int i = k % n, j = k / n;
        int depth = (int)fmin(fmin(i, j), fmin(n - 1 - i, n - 1 - j)), inner = depth >= n / 2 - 2;
        add_point(e, depth, i == 0, inner, f->T[k] - exact, exact);
        e->average += 100 * fabs(f->T[k] / exact - 1) / (n * n);
        middle += inner;
    }
    e->left_mean /= n;
    e->centre_mean /= middle, e->centre_late /= middle, e->centre_part /= middle;
    e->ring_mean /= ring, e->ring_late /= ring, e->ring_part /= ring;
}
