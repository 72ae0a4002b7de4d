/* A peer for --solver: SUNDIALS on the five-point method of lines, on the cell-centred points of a rectangle of one
 * material whose sides hold a temperature each.
 *
 *     sundials CASE OUT bdf|erk TOLERANCE
 *
 * bdf: CVODE's BDF with Newton and unpreconditioned GMRES, which the CVODE manual recommends for diffusion without
 * reaction; erk: ARKODE's explicit Runge-Kutta of third order.  Jacobian times vector is given, not differenced.
 * Distributions compile the library without optimisation, so its vector kernels are replaced by those below. */
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <time.h>

struct problem {
    char scene[64];
    int n[2];
    double lo[2], hi[2], dx, t_end, kappa[2], side[4], T0, half[2];
};

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void die(const char *text) {
    fprintf(stderr, "sundials: %s\n", text);
    exit(1);
}

/* ---- The case ---- */

static void take(struct problem *p, const char *key, const char *value) {
    static const char *const sides[] = {"side_x_lo", "side_x_hi", "side_y_lo", "side_y_hi"};
    if (!strcmp(key, "scene")) snprintf(p->scene, sizeof p->scene, "%.60s", value);
    if (!strcmp(key, "lo")) sscanf(value, "%lf, %lf", &p->lo[0], &p->lo[1]);
    if (!strcmp(key, "hi")) sscanf(value, "%lf, %lf", &p->hi[0], &p->hi[1]);
    if (!strcmp(key, "dx")) p->dx = atof(value);
    if (!strcmp(key, "t_end")) p->t_end = atof(value);
    if (!strcmp(key, "k_x")) p->kappa[0] = atof(value);
    if (!strcmp(key, "k_y")) p->kappa[1] = atof(value);
    if (!strcmp(key, "param_T0")) p->T0 = atof(value);
    if (!strcmp(key, "param_a")) p->half[0] = atof(value);
    if (!strcmp(key, "param_b")) p->half[1] = atof(value);
    for (int s = 0; s < 4; s++)
        if (!strcmp(key, sides[s]) && sscanf(value, "dirichlet, %lf", &p->side[s]) != 1)
            die("only sides that hold a temperature");
}

static void read_case(struct problem *p, const char *path) {
    char line[512];
    double rho_c = 1;
    FILE *in = fopen(path, "r");
    if (!in) die("cannot read the case");
    while (fgets(line, sizeof line, in)) {
        char *value = strstr(line, " = ");
        if (!value) continue;
        *value = '\0';
        value[3 + strcspn(value + 3, "\n")] = '\0';
        if (!strcmp(line, "rho_c")) rho_c = atof(value + 3);
        take(p, line, value + 3);
    }
    fclose(in);
    for (int a = 0; a < 2; a++) {
        p->kappa[a] /= rho_c;
        p->n[a] = (int)lround((p->hi[a] - p->lo[a]) / p->dx);
    }
    if (strcmp(p->scene, "square-step") && strcmp(p->scene, "plate")) die("knows square-step and plate");
}

static double start(const struct problem *p, double x, double y) {
    if (!strcmp(p->scene, "plate")) return p->T0;
    return fabs(x) <= p->half[0] * (1 + 1e-12) && fabs(y) <= p->half[1] * (1 + 1e-12) ? p->T0 : 0;
}

/* ---- The equations ---- */

/* out = A T, with the walls' values where `walls` is 1: ghost = 2 wall - T. */
static void laplacian(const struct problem *p, const double *restrict T, double *restrict out, int walls) {
    int nx = p->n[0], ny = p->n[1];
    double cx = p->kappa[0] / (p->dx * p->dx), cy = p->kappa[1] / (p->dx * p->dx);
    const double *w = p->side;
    for (int j = 0; j < ny; j++) {
        const double *row = T + (size_t)j * (size_t)nx, *below = row - nx, *above = row + nx;
        double *to = out + (size_t)j * (size_t)nx;
        if (j == 0 || j == ny - 1) {
            for (int i = 0; i < nx; i++) {
                double lo = j ? below[i] : 2 * walls * w[2] - row[i],
                       hi = j < ny - 1 ? above[i] : 2 * walls * w[3] - row[i];
                to[i] = cy * (lo - 2 * row[i] + hi);
            }
        } else {
            for (int i = 0; i < nx; i++) to[i] = cy * (below[i] - 2 * row[i] + above[i]);
        }
        to[0] += cx * (2 * walls * w[0] - 3 * row[0] + row[1]);
        for (int i = 1; i < nx - 1; i++) to[i] += cx * (row[i - 1] - 2 * row[i] + row[i + 1]);
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

/* ---- Vector kernels, compiled with optimisation ---- */

#define LENGTH(v) ((size_t)N_VGetLength_Serial(v))
#define ARRAY(v) N_VGetArrayPointer_Serial(v)

static void linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z) {
    const double *p = ARRAY(x), *q = ARRAY(y);
    double *r = ARRAY(z);
    size_t n = LENGTH(x);
    for (size_t i = 0; i < n; i++) r[i] = a * p[i] + b * q[i];
}

static void scale(realtype c, N_Vector x, N_Vector z) {
    const double *p = ARRAY(x);
    double *r = ARRAY(z);
    size_t n = LENGTH(x);
    for (size_t i = 0; i < n; i++) r[i] = c * p[i];
}

static void constant(realtype c, N_Vector z) {
    double *r = ARRAY(z);
    size_t n = LENGTH(z);
    for (size_t i = 0; i < n; i++) r[i] = c;
}

static void magnitude(N_Vector x, N_Vector z) {
    const double *p = ARRAY(x);
    double *r = ARRAY(z);
    size_t n = LENGTH(x);
    for (size_t i = 0; i < n; i++) r[i] = fabs(p[i]);
}

static void inverse(N_Vector x, N_Vector z) {
    const double *p = ARRAY(x);
    double *r = ARRAY(z);
    size_t n = LENGTH(x);
    for (size_t i = 0; i < n; i++) r[i] = 1 / p[i];
}

static void add_constant(N_Vector x, realtype b, N_Vector z) {
    const double *p = ARRAY(x);
    double *r = ARRAY(z);
    size_t n = LENGTH(x);
    for (size_t i = 0; i < n; i++) r[i] = p[i] + b;
}

static void product(N_Vector x, N_Vector y, N_Vector z) {
    const double *p = ARRAY(x), *q = ARRAY(y);
    double *r = ARRAY(z);
    size_t n = LENGTH(x);
    for (size_t i = 0; i < n; i++) r[i] = p[i] * q[i];
}

/* Sums by eights, so that they vectorise without leave to reorder. */
#define SUM(term)                                                                                                    \
    double part[8] = {0}, sum = 0;                                                                                   \
    size_t n = LENGTH(x), i = 0;                                                                                     \
    for (; i + 8 <= n; i += 8)                                                                                       \
        for (size_t k = i; k < i + 8; k++) part[k - i] += term;                                                      \
    for (size_t k = i; k < n; k++) sum += term;                                                                      \
    for (int k = 0; k < 8; k++) sum += part[k];

static realtype dot(N_Vector x, N_Vector y) {
    const double *p = ARRAY(x), *q = ARRAY(y);
    SUM(p[k] * q[k])
    return sum;
}

static realtype weighted_norm(N_Vector x, N_Vector w) {
    const double *p = ARRAY(x), *q = ARRAY(w);
    SUM((p[k] * q[k]) * (p[k] * q[k]))
    return sqrt(sum / (double)n);
}

static void use_own_kernels(N_Vector v) {
    v->ops->nvlinearsum = linear_sum;
    v->ops->nvscale = scale;
    v->ops->nvconst = constant;
    v->ops->nvabs = magnitude;
    v->ops->nvinv = inverse;
    v->ops->nvaddconst = add_constant;
    v->ops->nvprod = product;
    v->ops->nvdotprod = dot;
    v->ops->nvwrmsnorm = weighted_norm;
}

/* ---- The solve ---- */

static long solve_bdf(struct problem *p, N_Vector y, double tolerance, SUNContext context) {
    long steps = 0;
    double t;
    void *cvode = CVodeCreate(CV_BDF, context);
    SUNLinearSolver krylov = SUNLinSol_SPGMR(y, SUN_PREC_NONE, 20, context);
    if (CVodeInit(cvode, right_side, 0, y) || CVodeSStolerances(cvode, tolerance, tolerance * p->T0) ||
        CVodeSetUserData(cvode, p) || CVodeSetLinearSolver(cvode, krylov, NULL) ||
        CVodeSetJacTimes(cvode, NULL, jacobian_times) || CVodeSetMaxNumSteps(cvode, 1000000) ||
        CVodeSetStopTime(cvode, p->t_end))
        die("CVODE was not set up");
    if (CVode(cvode, p->t_end, y, &t, CV_NORMAL) < 0) die("CVODE failed");
    CVodeGetNumSteps(cvode, &steps);
    CVodeFree(&cvode);
    SUNLinSolFree(krylov);
    return steps;
}

static long solve_erk(struct problem *p, N_Vector y, double tolerance, SUNContext context) {
    long steps = 0;
    double t;
    void *arkode = ERKStepCreate(right_side, 0, y, context);
    if (!arkode || ERKStepSStolerances(arkode, tolerance, tolerance * p->T0) || ERKStepSetUserData(arkode, p) ||
        ERKStepSetOrder(arkode, 3) || ERKStepSetMaxNumSteps(arkode, 100000000) ||
        ERKStepSetStopTime(arkode, p->t_end))
        die("ARKODE was not set up");
    if (ERKStepEvolve(arkode, p->t_end, y, &t, ARK_NORMAL) < 0) die("ARKODE failed");
    ERKStepGetNumSteps(arkode, &steps);
    ERKStepFree(&arkode);
    return steps;
}

static void write_answer(const struct problem *p, const double *T, const char *path, double seconds, long steps) {
    FILE *out = fopen(path, "w");
    if (!out) die("cannot write the answer");
    fprintf(out, "# seconds = %.9g\n# steps = %ld\nx,y,T\n", seconds, steps);
    for (int j = 0; j < p->n[1]; j++)
        for (int i = 0; i < p->n[0]; i++)
            fprintf(out, "%.17g,%.17g,%.17g\n", p->lo[0] + (i + 0.5) * p->dx, p->lo[1] + (j + 0.5) * p->dx,
                    T[(size_t)j * (size_t)p->n[0] + (size_t)i]);
    if (fclose(out)) die("cannot write the answer");
}

int main(int argc, char **argv) {
    struct problem p = {.T0 = 1};
    SUNContext context;
    if (argc != 5) die("usage: sundials CASE OUT bdf|erk TOLERANCE");
    read_case(&p, argv[1]);
    if (SUNContext_Create(NULL, &context)) die("no context");
    double begin = now();
    N_Vector y = N_VNew_Serial((sunindextype)p.n[0] * p.n[1], context);
    use_own_kernels(y);
    double *T = N_VGetArrayPointer(y);
    for (int j = 0; j < p.n[1]; j++)
        for (int i = 0; i < p.n[0]; i++)
            T[(size_t)j * (size_t)p.n[0] + (size_t)i] =
                start(&p, p.lo[0] + (i + 0.5) * p.dx, p.lo[1] + (j + 0.5) * p.dx);
    if (p.T0 == 0) p.T0 = 1; /* the scale of the temperatures where the start is at zero */
    double tolerance = atof(argv[4]);
    long steps = strcmp(argv[3], "erk") ? solve_bdf(&p, y, tolerance, context) : solve_erk(&p, y, tolerance, context);
    write_answer(&p, T, argv[2], now() - begin, steps);
    N_VDestroy(y);
    SUNContext_Free(&context);
    return 0;
}
