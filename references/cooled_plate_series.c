/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A plate with one hot, one insulated and two cooled sides: the steady state by a series along one axis, minus the
 * double series of the transient.
 *
 *     along x:  F = sum_m I_m/N_m cos(p x) (p cosh(p (H - y)) + h sinh(p (H - y)))/(p cosh(p H) + h sinh(p H))
 *     along y:  F = 1 - h y/(1 + h H) - sum_n h/(r M_n) sin(r y) cosh(r x)/(r sinh(r W) + h cosh(r W))
 *
 * The notation is that of cooled_plate.c.  The terms decay as exp(-p y) and exp(-r (W - x)); the series that decays
 * faster is used. */
#include "references/cooled_plate.h"

#include "references/cooling.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { MOST = 20000, MODES = 2000 /* along each axis */ };
static const double last_exponent = 41.5;

static void steady_along_x(double W, double H, double h, const double x[2], struct approx *F) {
    double term = 0;
    for (int m = 1; m <= MOST; m++) {
        struct cooling_mode X = cooling_mode(m, 1, W, h);
        double p = X.q, down = p == 0 ? 1
                                      : exp(-p * x[1]) * ((p + h) + (p - h) * exp(-2 * p * (H - x[1]))) /
                                            ((p + h) + (p - h) * exp(-2 * p * H));
        term = X.integral / X.norm * down;
        F->value += term * cos(p * x[0]);
        F->error += DBL_EPSILON * fabs(term) * (8 + 4 * m + 4 * p * x[1]);
        if (p * x[1] > last_exponent) return;
    }
    F->error += 2 * MOST * fabs(term); /* the terms decay as 1/m^2 */
}

static void steady_along_y(double W, double H, double h, const double x[2], struct approx *F) {
    double term = 0;
    F->value += 1 - h * x[1] / (1 + h * H);
    for (int n = 1; n <= MOST; n++) {
        struct cooling_mode Y = cooling_mode(n, 0, H, h);
        double r = Y.q, away = exp(-r * (W - x[0])) * (1 + exp(-2 * r * x[0]));
        term = h / (r * Y.norm) * away / (r * -expm1(-2 * r * W) + h * (1 + exp(-2 * r * W)));
        F->value -= term * sin(r * x[1]);
        F->error += DBL_EPSILON * fabs(term) * (8 + 4 * n + 4 * r * (W - x[0]));
        if (r * (W - x[0]) > last_exponent) return;
    }
    F->error += 2 * MOST * fabs(term);
}

struct approx cooled_plate_series(double W, double H, double h, double hot, double start, double s,
                                  const double x[2]) {
    struct approx T = {0, 1e-17 * (fabs(hot) + fabs(start))}, F = {0, 4 * DBL_EPSILON};
    (x[1] * H > (W - x[0]) * W ? steady_along_x : steady_along_y)(W, H, h, x, &F);
    T.value = hot * F.value;
    T.error += fabs(hot) * F.error;
    double needed = s < INFINITY ? fmax(W, H) / s * 2 * sqrt(last_exponent) / M_PI : 0;
    if (needed > MODES) T.error = INFINITY; /* some significant modes are missing */
    int most = needed == 0 || needed > MODES ? 0 : (int)(2 + W / s * 2 * sqrt(last_exponent) / M_PI);
    struct cooling_mode *along = xcalloc((size_t)most, sizeof *along);
    for (int m = 0; m < most; m++) along[m] = cooling_mode(m + 1, 1, W, h);
    for (int n = 1, alive = most; n <= MOST && alive; n++) {
        struct cooling_mode Y = cooling_mode(n, 0, H, h);
        alive = 0;
        for (int m = 0; m < most; m++) {
            double p = along[m].q, rate = p * p + Y.q * Y.q, exponent = rate * s * s / 4;
            double shape = along[m].integral / (along[m].norm * Y.norm) * exp(-exponent);
            if (exponent > last_exponent) break;
            alive = 1;
            T.value += shape * (start * Y.integral - hot * Y.q / rate) * cos(p * x[0]) * sin(Y.q * x[1]);
            T.error += DBL_EPSILON * fabs(shape) * (fabs(start * Y.integral) + fabs(hot * Y.q / rate)) *
                       (12 + 8 * exponent + 4 * (m + n));
        }
    }
    free(along);
    return T;
}
