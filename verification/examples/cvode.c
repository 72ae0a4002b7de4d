/* cvode CASE OUT: SUNDIALS' CVODE (BDF, a banded matrix) on finite volumes on a grid of cells.  What the case does
   not tell, `heatladder reference` does, at the centres of cells and of faces on the sides; $HEATLADDER is that. */
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <sunlinsol/sunlinsol_band.h>
enum { MEAN, SOURCE, RHO_C, K, KIND, VALUE, B, COLUMNS = 11 }; /* K to B of x, then of y */
static int dim = 1, n[2] = {1, 1}, nx, all;
static double t, t_end, lo[2], hi[2] = {0, 1}, h[2], (*p)[COLUMNS], (*g)[2]; /* g: to the next, over the width */
/* Cells 1 to n along each axis, framed by the faces on the sides; a rod is one row, without a frame in y. */
static int place(int c, int d) { return d ? c / nx : c % nx; }
static int is_side(int c, int d) { return d < dim && (place(c, d) == 0 || place(c, d) == n[d] + 1); }
static int is_in(int c) { return !is_side(c, 0) && !is_side(c, 1); }
static double at(int c, int d) { return d < dim ? fmin(fmax(lo[d] + (place(c, d) - 0.5) * h[d], lo[d]), hi[d]) : 0; }
static double half(int c, int d) { /* a resistance: none where T is given, without end where the flux is */
    double k = p[c][K + 4 * d], kind = p[c][KIND + 4 * d];
    return !is_side(c, d) ? h[d] / (2 * k) : kind == 1 ? 0 : kind == 3 ? 1 / p[c][B + 4 * d] : INFINITY;
}
static int rhs(double now, N_Vector v, N_Vector to, void *user) {
    double *T = N_VGetArrayPointer(v), *rate = N_VGetArrayPointer(to);
    for (int c = 0; c < all; c++) rate[c] = is_in(c) ? p[c][SOURCE] / p[c][RHO_C] : 0;
    for (int c = 0; c < all; c++) for (int d = 0, s = 1; is_in(c) && d < dim; d++, s = nx)
        rate[c] += (g[c][d] * (T[c + s] - T[c]) + g[c - s][d] * (T[c - s] - T[c])) / p[c][RHO_C];
    return 0;
}
int main(int argc, char **argv) {
    char line[4096], oracle[2048] = "", kind[9] = "", *program = getenv("HEATLADDER");
    FILE *f = argc == 3 ? fopen(argv[1], "r") : NULL;
    while (f && fgets(line, sizeof line, f))
        sscanf(line, "dim = %d", &dim), sscanf(line, "cells = %d, %d", n, n + 1), sscanf(line, "t_end = %lf", &t_end),
            sscanf(line, "lo = %lf, %lf", lo, lo + 1), sscanf(line, "hi = %lf, %lf", hi, hi + 1),
            sscanf(line, "oracle = %2047[^\n]", oracle), sscanf(line, "source = %8s", kind);
    if (*kind == 'c') return 77; /* the times are the integrator's */
    for (int d = 0; d < 2; d++) h[d] = (hi[d] - lo[d]) / n[d];
    nx = n[0] + 2, all = nx * (dim == 2 ? n[1] + 2 : 1), p = calloc(all, sizeof *p), g = calloc(all, sizeof *g);
    SUNContext sun;
    N_Vector v = SUNContext_Create(NULL, &sun) ? NULL : N_VNew_Serial(all, sun);
    double *T = N_VGetArrayPointer(v);
    snprintf(line, sizeof line, "%s.points", argv[2]), f = fopen(line, "w"), fprintf(f, "x,y,dx,dy\n");
    for (int c = 0; c < all; c++) fprintf(f, "%.17g,%.17g,%.17g,%.17g\n", at(c, 0), at(c, 1), h[0], h[1]);
    fclose(f), snprintf(line, sizeof line, "%s reference %s --points %s.points --what initial_heat,source,rho_c,%s",
             program ? program : "heatladder", oracle, argv[2], dim == 2 ? "k_x,wall_x,k_y,wall_y" : "k_x,wall_x");
    f = popen(line, "r"), fgets(line, sizeof line, f);
    for (int c = 0; c < all; T[c] = p[c][MEAN], c++)
        for (int i = -dim; i < K + 4 * dim; i++) if (fscanf(f, "%lf,", i < 0 ? &t : &p[c][i]) != 1) return 1;
    for (int c = 0; c < all; c++) for (int d = 0, e = c + 1; d < dim; d++, e = c + nx)
        for (int s = 0, q = c, other = e; !is_side(c, !d) && place(c, d) <= n[d] && s < 2; s++, q = e, other = c) {
            g[c][d] = 1 / (half(c, d) + half(e, d)) / h[d];
            if (is_side(q, d)) T[q] = p[q][VALUE + 4 * d], p[other][SOURCE] += isinf(half(q, d)) ? T[q] / h[d] : 0;
        }
    void *ode = CVodeCreate(CV_BDF, sun), *J = SUNBandMatrix(all, dim < 2 ? 1 : nx, dim < 2 ? 1 : nx, sun);
    if (CVodeInit(ode, rhs, 0, v) || CVodeSStolerances(ode, 1e-8, 1e-10) || CVodeSetMaxNumSteps(ode, 1000000) ||
        CVodeSetLinearSolver(ode, SUNLinSol_Band(v, J, sun), J) || CVode(ode, t_end, v, &t, CV_NORMAL)) return 1;
    f = fopen(argv[2], "w"), fprintf(f, dim == 2 ? "x y T\n" : "x T\n");
    for (int c = 0; c < all; c++) for (int d = 0; is_in(c) && d <= dim; d++)
        fprintf(f, d < dim ? "%.17g " : "%.17g\n", d < dim ? at(c, d) : T[c]);
    return fclose(f) != 0;
}
