/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A peer for --solver: SUNDIALS on the five-point method of lines, on the cell-centred points of a rectangle of one
 * material whose sides hold a temperature each.
 *
 *     sundials CASE OUT bdf|dirk|erk TOLERANCE
 *
 * bdf   CVODE's BDF, Newton and conjugate gradients: the manual's choice of Krylov method where the matrix is
 * symmetric, and half the time of GMRES here dirk  ARKODE's diagonally implicit Runge-Kutta of fourth order with the
 * same, told that the problem is linear erk   ARKODE's explicit Runge-Kutta of third order, told the longest stable
 * step so that none is tried in vain
 *
 * Jacobian times vector is given, not differenced. */
#include "verification/bench/peers/peer_rectangle.h"
#include "verification/bench/peers/sundials_kernels.h"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_pcg.h>

/* ---- The equations ---- */

/* out = A T, with the walls' values where `walls` is 1: ghost = 2 wall - T. */
static void laplacian(const struct rectangle *p, const double *restrict T, double *restrict out, int walls) {
    int nx = p->n[0], ny = p->n[1];
    double cx = p->kappa[0] / (p->dx * p->dx), cy = p->kappa[1] / (p->dx * p->dx);
    const double *w = p->side;
#pragma omp parallel for if (nx * ny >= RECTANGLE_FEW)
    for (int j = 0; j < ny; j++) {
        const double *row = T + (size_t)j * (size_t)nx, *below = row - nx, *above = row + nx;
        double *to = out + (size_t)j * (size_t)nx;
        if (j == 0 || j == ny - 1) {
            for (int i = 0; i < nx; i++) {
                double lo = j ? below[i] : 2 * walls * w[2] - row[i],
                       hi = j < ny - 1 ? above[i] : 2 * walls * w[3] - row[i];
                to[i] = cy * (lo - 2 * row[i] + hi);
            }
            for (int i = 1; i < nx - 1; i++) to[i] += cx * (row[i - 1] - 2 * row[i] + row[i + 1]);
        } else {
            to[0] = cy * (below[0] - 2 * row[0] + above[0]);
            for (int i = 1; i < nx - 1; i++)
                to[i] = cx * (row[i - 1] + row[i + 1]) + cy * (below[i] + above[i]) - 2 * (cx + cy) * row[i];
            to[nx - 1] = cy * (below[nx - 1] - 2 * row[nx - 1] + above[nx - 1]);
        }
        to[0] += cx * (2 * walls * w[0] - 3 * row[0] + row[1]);
        to[nx - 1] += cx * (row[nx - 2] - 3 * row[nx - 1] + 2 * walls * w[1]);
    }
}

static int right_side(realtype t, N_Vector y, N_Vector ydot, void *data) {
    (void)t;
    laplacian(data, N_VGetArrayPointer(y), N_VGetArrayPointer(ydot), 1);
    return 0;
}

static int jacobian_times(N_Vector v, N_Vector Jv, realtype t, N_Vector y, N_Vector fy, void *data, N_Vector tmp) {
    (void)t, (void)y, (void)fy, (void)tmp;
    laplacian(data, N_VGetArrayPointer(v), N_VGetArrayPointer(Jv), 0);
    return 0;
}

/* The explicit method's real axis is stable to -2.51; the largest eigenvalue is 4 (kappa_x + kappa_y)/dx^2. */
static int stable_step(N_Vector y, realtype t, realtype *h, void *data) {
    (void)y, (void)t;
    const struct rectangle *p = data;
    *h = 2.51 / (4 * (p->kappa[0] + p->kappa[1])) * p->dx * p->dx;
    return 0;
}

/* ---- The solve ---- */

enum { ITERATIONS = 100, STEPS_MAX = 100000000 };

static long solve_bdf(struct rectangle *p, N_Vector y, double tolerance, double absolute, SUNContext context) {
    long steps = 0;
    double t;
    void *cvode = CVodeCreate(CV_BDF, context);
    SUNLinearSolver krylov = SUNLinSol_PCG(y, SUN_PREC_NONE, ITERATIONS, context);
    if (CVodeInit(cvode, right_side, 0, y) || CVodeSStolerances(cvode, tolerance, absolute) ||
        CVodeSetUserData(cvode, p) || CVodeSetLinearSolver(cvode, krylov, NULL) ||
        CVodeSetJacTimes(cvode, NULL, jacobian_times) || CVodeSetMaxNumSteps(cvode, STEPS_MAX) ||
        CVodeSetStopTime(cvode, p->t_end))
        rectangle_die("CVODE was not set up");
    if (CVode(cvode, p->t_end, y, &t, CV_NORMAL) < 0) rectangle_die("CVODE failed");
    CVodeGetNumSteps(cvode, &steps);
    CVodeFree(&cvode);
    SUNLinSolFree(krylov);
    return steps;
}

static long solve_erk(struct rectangle *p, N_Vector y, double tolerance, double absolute, SUNContext context) {
    long steps = 0;
    double t;
    void *arkode = ERKStepCreate(right_side, 0, y, context);
    if (!arkode || ERKStepSStolerances(arkode, tolerance, absolute) || ERKStepSetUserData(arkode, p) ||
        ERKStepSetOrder(arkode, 3) || ERKStepSetStabilityFn(arkode, stable_step, p) ||
        ERKStepSetCFLFraction(arkode, 0.99) || ERKStepSetMaxNumSteps(arkode, STEPS_MAX) ||
        ERKStepSetStopTime(arkode, p->t_end))
        rectangle_die("ARKODE was not set up");
    if (ERKStepEvolve(arkode, p->t_end, y, &t, ARK_NORMAL) < 0) rectangle_die("ARKODE failed");
    ERKStepGetNumSteps(arkode, &steps);
    ERKStepFree(&arkode);
    return steps;
}

static long solve_dirk(struct rectangle *p, N_Vector y, double tolerance, double absolute, SUNContext context) {
    long steps = 0;
    double t;
    void *arkode = ARKStepCreate(NULL, right_side, 0, y, context);
    SUNLinearSolver krylov = SUNLinSol_PCG(y, SUN_PREC_NONE, ITERATIONS, context);
    if (!arkode || ARKStepSStolerances(arkode, tolerance, absolute) || ARKStepSetUserData(arkode, p) ||
        ARKStepSetLinearSolver(arkode, krylov, NULL) || ARKStepSetJacTimes(arkode, NULL, jacobian_times) ||
        ARKStepSetLinear(arkode, 0) || ARKStepSetOrder(arkode, 4) || ARKStepSetMaxNumSteps(arkode, STEPS_MAX) ||
        ARKStepSetStopTime(arkode, p->t_end))
        rectangle_die("ARKODE was not set up");
    if (ARKStepEvolve(arkode, p->t_end, y, &t, ARK_NORMAL) < 0) rectangle_die("ARKODE failed");
    ARKStepGetNumSteps(arkode, &steps);
    ARKStepFree(&arkode);
    SUNLinSolFree(krylov);
    return steps;
}

int main(int argc, char **argv) {
    SUNContext context;
    if (argc == 2 && !strcmp(argv[1], "--version")) return puts(SUNDIALS_VERSION) < 0;
    if (argc != 5) rectangle_die("usage: sundials CASE OUT bdf|dirk|erk TOLERANCE");
    struct rectangle p = rectangle_read(argv[1]);
    double tolerance = atof(argv[4]);
    omp_set_num_threads(p.threads);
    if (SUNContext_Create(NULL, &context)) rectangle_die("no context");
    N_Vector y = N_VNew_Serial((sunindextype)p.n[0] * p.n[1], context);
    sundials_kernels(y);
    double *T = N_VGetArrayPointer(y), start = omp_get_wtime(), begin, seconds, scale = p.T0 == 0 ? 1 : p.T0;
    long steps = 0;
    do {
        begin = omp_get_wtime();
        rectangle_start(&p, T);
        steps = *argv[3] == 'b'   ? solve_bdf(&p, y, tolerance, tolerance * scale, context)
                : *argv[3] == 'd' ? solve_dirk(&p, y, tolerance, tolerance * scale, context)
                                  : solve_erk(&p, y, tolerance, tolerance * scale, context);
        seconds = omp_get_wtime() - begin;
    } while (begin - start < RECTANGLE_WARM);
    rectangle_write(&p, T, argv[2], seconds, steps);
    N_VDestroy(y);
    SUNContext_Free(&context);
    return 0;
}
