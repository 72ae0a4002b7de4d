/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Responses: the difference of two runs divided by the size of the fault, interpolated to the points by splines
 * (GSL: cubic; Steffen's for two materials or phases, which does not overshoot where they meet; in space by cubics
 * through four points of each axis).  Beyond the outermost cell centres the interpolation on rods and in the plane is
 * linear.
 */
#include "verification/fault/response.h"

#include "references/kirchhoff.h"
#include "solver/method.h"
#include "verification/fault/melting.h"
#include "verification/text/output.h"

#include <gsl/gsl_interp2d.h>
#include <gsl/gsl_spline.h>
#include <gsl/gsl_spline2d.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Small: the time error of Euler's method, dt/2 d2T/dt2, cancels part of the error in space, all of it at 1/6. */
static const double FOURIER = 0.05;

/* For the discretization errors.  With k(T) steps of rkl2, which evaluate source and walls a fifth as often; 0: no
 * Fourier number. */
static double fourier_of(const struct problem *p) {
    return p->k_law ? 0 : FOURIER;
}

/* For the responses.  In the plane and in space five stages of rkl2, which reach a sum of 3.5 over the axes
 * (ftcs_step.c), advance seven times as far as as many steps of Euler's.  The time error of a wave q is (F dx^2
 * q^2)^2/14 of its decay, with Euler's steps F dx^2 q^2/2: with 64 cells and F = 1.75 less for up to six half waves
 * in the body. */
static double fourier_of_responses(const struct problem *p) {
    static const double REACH = 3.5;
    return p->dim == 1 || p->k_law ? fourier_of(p) : REACH / p->dim;
}

/* ---- Steps with a change of the equation ---- */

enum { FACES = 2 * DIM_MAX };

struct steps {
    const struct faulty *f;
    int n[DIM_MAX], stride[DIM_MAX], all;
    double dx;
    double *T, *rate;
    struct face {
        int to;          /* the cell beyond a face; the cell itself at a wall */
        double conducts; /* W m^-3 K^-1; 0 at a wall */
    } (*face)[FACES];    /* x_lo, x_hi, y_lo, ... of each cell */
    double *rho_c;
};

static void centre(const struct steps *c, int i, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = c->f->right->lo[a] + (i / c->stride[a] % c->n[a] + 0.5) * c->dx;
}

/* The material at x. */
static const struct material *material_at(const struct faulty *f, const double *x) {
    const struct problem *p = &f->problem;
    const int a = f->across;
    double part = (p->interface - p->lo[0]) / (p->hi[0] - p->lo[0]);
    return &p->material[p->materials == 2 && x[a] >= p->lo[a] + part * (p->hi[a] - p->lo[a])];
}

/* k of cell i along axis a. */
static double conducts(const struct steps *c, int i, int a) {
    double x[DIM_MAX];
    if (c->f->problem.k_law) return kirchhoff_k(&c->f->problem, c->T[i]);
    centre(c, i, x);
    return material_at(c->f, x)->k[a];
}

/* Whether that face of a wall, in the cell of a corner of a plane, is left out. */
static int is_left_out(const struct steps *c, int i, int a, int hi) {
    const int b = 1 - a, n = c->n[b], place = i / c->stride[b] % n, at = c->f->left_out;
    if (at < 0 || (place > 0 && place < n - 1)) return 0;
    const int upper = place > 0, corner = a == 0 ? 2 * upper + hi : 2 * hi + upper;
    return at < BESIDE_ALL ? corner == at : at - BESIDE_ALL == a;
}

static int is_at_side(const struct steps *c, int i, int a, int hi) {
    return i / c->stride[a] % c->n[a] == (hi ? c->n[a] - 1 : 0);
}

/* The faces between cells, at T. */
static void conduct(struct steps *c) {
    const struct problem *p = &c->f->problem;
    for (int i = 0; i < c->all; i++)
        for (int s = 0; s < 2 * p->dim; s++) {
            const int a = s / 2, at_side = is_at_side(c, i, a, s % 2);
            struct face *face = &c->face[i][s];
            face->to = i;
            if (at_side && p->side[s] != PERIODIC) continue;
            face->to += (s % 2 ? 1 : -1) * c->stride[a] * (at_side ? 1 - c->n[a] : 1);
            double k = conducts(c, i, a), beyond = conducts(c, face->to, a);
            double both = p->k_law ? (k + beyond) / 2 : 2 * k * beyond / (k + beyond);
            face->conducts = (c->f->laplacian ? k : both) * (at_side && c->f->twice[a] ? 2 : 1) / (c->dx * c->dx);
        }
}

/* The heat that a wall adds to cell i, W m^-3. */
static double through_wall(const struct steps *c, int i, int s, double t) {
    const struct problem *p = &c->f->problem;
    const int a = s / 2;
    double x[DIM_MAX], half = c->dx / (2 * conducts(c, i, a));
    centre(c, i, x);
    x[a] = s % 2 ? p->hi[a] : p->lo[a];
    double value = p->wall(p, (enum side)s, x, t);
    if (p->side[s] == NEUMANN) return value / c->dx;
    if (is_left_out(c, i, a, s % 2)) return 0;
    return (value - c->T[i]) / (half + (p->side[s] == ROBIN ? 1 / p->robin[s] : 0)) / c->dx;
}

static void step(struct steps *c, double t, double dt) {
    const struct problem *p = &c->f->problem;
    const int faces = 2 * p->dim, heated = p->source || p->source_at;
    if (p->k_law) conduct(c);
    for (int i = 0; i < c->all; i++) {
        double sum = 0, x[DIM_MAX];
        if (heated) centre(c, i, x), sum = problem_source(p, x, t);
        for (int s = 0; s < faces; s++) {
            const struct face *face = &c->face[i][s];
            sum += face->to == i ? through_wall(c, i, s, t) : face->conducts * (c->T[face->to] - c->T[i]);
        }
        c->rate[i] = sum / c->rho_c[i];
    }
    for (int i = 0; i < c->all; i++) c->T[i] += dt * c->rate[i];
}

/* Euler's method for changes of the equation that no problem of the solver has, up to an interrupt: its row has no
 * verdict. */
static void solve_by_steps(const struct faulty *f, double dx, struct field *out) {
    const struct problem *p = &f->problem;
    struct steps c = {.f = f, .dx = dx, .all = 1};
    for (int a = 0; a < DIM_MAX; a++) {
        c.n[a] = a < p->dim ? (int)lround((p->hi[a] - p->lo[a]) / dx) : 1;
        c.stride[a] = c.all;
        c.all *= c.n[a];
    }
    field_alloc_lattice(out, p->dim, c.n, NULL);
    c.T = out->T;
    c.rate = xcalloc((size_t)c.all, sizeof *c.rate);
    c.rho_c = xcalloc((size_t)c.all, sizeof *c.rho_c);
    c.face = xcalloc((size_t)c.all, sizeof *c.face);
    for (int i = 0; i < c.all; i++) {
        double x[DIM_MAX];
        centre(&c, i, x);
        c.T[i] = p->initial(p, x);
        c.rho_c[i] = material_at(f, x)->rho_c;
    }
    conduct(&c);
    const double steps = ceil(p->t_end * problem_diffusivity(p) * p->dim / (0.3 * dx * dx)), dt = p->t_end / steps;
    for (double n = 0; n < steps && !output_noted(); n++) step(&c, n * dt, dt);
    free(c.rate);
    free(c.rho_c);
    free(c.face);
}

/* ---- Runs ---- */

/* A mesh Fourier number above 1/2 is one of rkl2, as is 0. */
static int solve(const struct faulty *with, double dx, double fourier, struct field *f) {
    const struct problem *p = &with->problem;
    const int euler = fourier > 0 && fourier <= 0.5;
    struct failure ignored;
    if (p->k_law == K_PHASES) {
        melting_solve(with, dx, f);
        return 0;
    }
    struct options o = {.dx = dx,
                        .fourier = fourier,
                        .stepper = euler ? STEPPER_EULER : STEPPER_RKL2,
                        .sampling = p->jumps[0] + p->jumps[1] + p->jumps[2] ? SAMPLING_CELL : SAMPLING_POINT,
                        .mean = p->k_law && with->mean != MEAN_HARMONIC ? MEAN_KIRCHHOFF
                                : with->right->resistance > 0           ? MEAN_SERIES
                                                                        : with->mean,
                        .domain = DOMAIN_WHOLE};
    if (!method_solve(method_find("ftcs"), p, &o, f, &ignored)) return 0;
    if (!euler || with->mean != MEAN_ARITHMETIC) return -1;
    o.stepper = STEPPER_RKL2, o.fourier = 0; /* between conductivities a hundred apart Euler's steps are unstable */
    return method_solve(method_find("ftcs"), p, &o, f, &ignored);
}

/* The right problem, as a faulty one. */
static void make_none(const struct problem *p, struct faulty *none) {
    faulty_make(p, (struct fault){FAULT_AMPLITUDE, 0}, 0, none);
}

static int is_face(double at, double lo, double dx) {
    double cells = (at - lo) / dx;
    return fabs(cells - nearbyint(cells)) < 1e-9 * fabs(cells) + 1e-12;
}

/* Number of jumps and interfaces on faces of n cells along x; -1 if the cells do not fit the domain. */
static int fit(const struct problem *p, int n) {
    double dx = (p->hi[0] - p->lo[0]) / n;
    int faces = p->materials == 2 && is_face(p->interface, p->lo[0], dx);
    for (int a = 0; a < p->dim; a++) {
        if (!is_face(p->hi[a], p->lo[a], dx)) return -1;
        for (int k = 0; k < p->jumps[a]; k++) faces += is_face(p->jump[a][k], p->lo[a], dx);
    }
    return faces;
}

/* T on the lattice, and its size; NULL: no solution. */
static double *without_fault(const struct problem *p, struct response_lattice *l, double fourier) {
    struct field f;
    struct faulty none;
    make_none(p, &none);
    if (solve(&none, l->dx, fourier, &f)) return NULL;
    memcpy(l->n, f.shape, sizeof l->n);
    double *T = f.T;
    f.T = NULL;
    field_free(&f);
    return T;
}

int response_lattice_create(const struct problem *p, struct response_lattice *l) {
    /* the steps of k(T), and of walls that change in the plane, take ten times as long */
    const int coarse = p->k_law || (p->wall_rate && p->dim > 1) ? 2 : 1;
    const int melts = p->k_law == K_PHASES, fine = 128; /* the front is known to a part of a cell */
    const int least = melts ? fine : p->dim == 3 ? 16 : 64 / coarse, few = 4;
    const int most = p->dim == 3 ? 40 : 2 * least;
    double longest = 1; /* in units of the extent along x; a column has few cells along x */
    for (int a = 0; a < p->dim && p->dim == 3; a++)
        longest = fmax(longest, (p->hi[a] - p->lo[a]) / (p->hi[0] - p->lo[0]));
    int best = -1, n = 0;
    for (int i = few; i <= most; i++)
        if (i * longest >= least - 0.5 && i * longest <= most + 0.5 && fit(p, i) > best) best = fit(p, i), n = i;
    if (best < 0 || p->shape) return -1; /* rings do not form a lattice */
    const double steps = p->t_end * problem_diffusivity(p) / (FOURIER * pow((p->hi[0] - p->lo[0]) / n, 2));
    if (p->direction && steps > 1e4) return -1; /* minutes for each fault */
    *l = (struct response_lattice){.dx = (p->hi[0] - p->lo[0]) / n};
    l->T = without_fault(p, l, fourier_of(p));
    if (!l->T || melts) return l->T ? 0 : -1;
    l->longer = without_fault(p, l, 3 * FOURIER);
    l->apart = without_fault(p, l, fourier_of_responses(p));
    if (!l->longer || !l->apart) {
        response_lattice_free(l);
        return -1;
    }
    const double longer = 3 * FOURIER - fourier_of(p);
    for (int i = 0; i < l->n[0] * l->n[1] * l->n[2]; i++) {
        l->longer[i] = (l->longer[i] - l->T[i]) / longer;
        l->apart[i] = l->T[i] - l->apart[i];
    }
    return 0;
}

void response_lattice_free(struct response_lattice *l) {
    free(l->T);
    free(l->longer);
    free(l->apart);
    *l = (struct response_lattice){0};
}

/* The place at which the answer with a fault takes its value for point i. */
static double *place(const struct faulty *with, const struct field *f, size_t i, double x[DIM_MAX]) {
    field_place(f, i, x);
    for (int a = 0; a < f->dim; a++) {
        if (with->mirrored[a]) x[a] = 2 * with->centre[a] - x[a];
        x[a] -= with->moved[a];
    }
    return x;
}

/* At the points from `from` to `to`. */
static void along_part(const struct faulty *with, const double *x, const double *D, size_t n, double from, double to,
                       const struct field *f, double *out) {
    const int bends = with->right->materials == 2 || with->right->k_law == K_PHASES;
    const gsl_interp_type *type = bends ? gsl_interp_steffen : gsl_interp_cspline;
    gsl_spline *spline = gsl_spline_alloc(type, n);
    gsl_interp_accel *near = gsl_interp_accel_alloc();
    gsl_spline_init(spline, x, D, n);
    for (size_t i = 0; i < f->n; i++) {
        double point[DIM_MAX], there = place(with, f, i, point)[0];
        if (!(there >= from && there < to)) continue;
        double at = fmin(fmax(there, x[0]), x[n - 1]);
        out[i] = gsl_spline_eval(spline, at, near);
        if (at != there) out[i] += (there - at) * gsl_spline_eval_deriv(spline, at, near);
    }
    gsl_interp_accel_free(near);
    gsl_spline_free(spline);
}

/* With a contact resistance D jumps at the interface, so each side has a spline of its own. */
static void along_rod(const struct faulty *with, const double *x, const double *D, size_t n, const struct field *f,
                      double *out) {
    enum { LEAST = 3 }; /* points for Steffen's spline */
    const struct problem *p = with->right;
    size_t below = 0;
    while (p->resistance > 0 && below < n && x[below] < p->interface) below++;
    const int jumps = below >= LEAST && n - below >= LEAST;
    if (jumps) along_part(with, x, D, below, -INFINITY, p->interface, f, out);
    if (!jumps) below = 0;
    along_part(with, x + below, D + below, n - below, jumps ? p->interface : -INFINITY, INFINITY, f, out);
}

static void in_plane(const struct faulty *with, double *const x[2], const double *D, const int n[2],
                     const struct field *f, double *out) {
    gsl_spline2d *spline = gsl_spline2d_alloc(gsl_interp2d_bicubic, (size_t)n[0], (size_t)n[1]);
    gsl_interp_accel *near[2] = {gsl_interp_accel_alloc(), gsl_interp_accel_alloc()};
    gsl_spline2d_init(spline, x[0], x[1], D, (size_t)n[0], (size_t)n[1]);
    for (size_t i = 0; i < f->n; i++) {
        double to[DIM_MAX], at[2];
        place(with, f, i, to);
        for (int a = 0; a < 2; a++) at[a] = fmin(fmax(to[a], x[a][0]), x[a][n[a] - 1]);
        out[i] = gsl_spline2d_eval(spline, at[0], at[1], near[0], near[1]);
        if (at[0] != to[0])
            out[i] += (to[0] - at[0]) * gsl_spline2d_eval_deriv_x(spline, at[0], at[1], near[0], near[1]);
        if (at[1] != to[1])
            out[i] += (to[1] - at[1]) * gsl_spline2d_eval_deriv_y(spline, at[0], at[1], near[0], near[1]);
    }
    for (int a = 0; a < 2; a++) gsl_interp_accel_free(near[a]);
    gsl_spline2d_free(spline);
}

/* Lagrange's cubic through four of the n equidistant x: the first of them, and their weights at `at`. */
static int cubic_weights(const double *x, int n, double at, double w[4]) {
    double place = (at - x[0]) / (x[1] - x[0]);
    int first = (int)fmin(fmax(floor(place) - 1, 0), n - 4);
    for (int k = 0; k < 4; k++) {
        w[k] = 1;
        for (int m = 0; m < 4; m++) w[k] *= m == k ? 1 : (place - first - m) / (k - m);
    }
    return first;
}

static void in_space(const struct faulty *with, double *const x[], const double *D, const int n[],
                     const struct field *f, double *out) {
    for (size_t i = 0; i < f->n; i++) {
        double at[DIM_MAX], w[DIM_MAX][4], sum = 0;
        int first[DIM_MAX];
        place(with, f, i, at);
        for (int a = 0; a < DIM_MAX; a++) first[a] = cubic_weights(x[a], n[a], at[a], w[a]);
        for (int k = 0; k < 64; k++) {
            int c = first[0] + k % 4 + n[0] * (first[1] + k / 4 % 4 + n[1] * (first[2] + k / 16));
            sum += w[0][k % 4] * w[1][k / 4 % 4] * w[2][k / 16] * D[c];
        }
        out[i] = sum;
    }
}

/* The cell centres along an axis, in the coordinates of the right problem; the caller frees them. */
static double *centres(const struct faulty *f, const struct response_lattice *l, int axis) {
    double *x = xcalloc((size_t)l->n[axis], sizeof *x);
    for (int i = 0; i < l->n[axis]; i++) {
        double at = f->right->lo[axis] + (i + 0.5) * l->dx;
        x[i] = f->centre[axis] + f->stretch[axis] * (at - f->centre[axis]);
    }
    return x;
}

static void carry(const struct faulty *f, const struct response_lattice *l, const double *T, const struct field *to,
                  double *out) {
    double *x[DIM_MAX] = {NULL};
    for (int a = 0; a < f->right->dim; a++) x[a] = centres(f, l, a);
    if (x[2])
        in_space(f, x, T, l->n, to, out);
    else if (x[1])
        in_plane(f, x, T, l->n, to, out);
    else
        along_rod(f, x[0], T, (size_t)l->n[0], to, out);
    for (int a = 0; a < DIM_MAX; a++) free(x[a]);
}

void response_base(const struct problem *p, const struct response_lattice *l, const struct field *f, double *base,
                   double *longer) {
    struct faulty none;
    make_none(p, &none);
    carry(&none, l, l->T, f, base);
    if (l->longer) carry(&none, l, l->longer, f, longer);
}

void response_laplacian(const struct problem *p, const struct response_lattice *l, const struct field *f,
                        double *out) {
    struct faulty none;
    const int *n = l->n, all = n[0] * n[1] * n[2];
    double *D = xcalloc((size_t)all, sizeof *D);
    for (int c = 0; c < all; c++)
        for (int a = 0, stride = 1; a < p->dim; stride *= n[a++]) {
            int at = c / stride % n[a], inner = at < 1 ? 1 : at > n[a] - 2 ? n[a] - 2 : at; /* next to the wall */
            const double *T = l->T + c + (inner - at) * stride;
            D[c] += (T[stride] - 2 * *T + T[-stride]) / (l->dx * l->dx);
        }
    make_none(p, &none);
    carry(&none, l, D, f, out);
    free(D);
}

int response_take(const struct problem *p, const struct response_lattice *l, struct fault fault, double size,
                  struct response *r) {
    r->size = size != 0 ? size : fault.kind == FAULT_MEAN ? l->dx : fault_probe(p, fault); /* one cell: it is local */
    if (!faulty_make(p, fault, r->size, &r->with)) return -1;
    if (solve(&r->with, l->dx, fourier_of_responses(p), &r->T)) return -1;
    for (size_t i = 0; i < r->T.n && l->apart; i++) r->T.T[i] += l->apart[i];
    return 0;
}

void response_free(struct response *r) {
    field_free(&r->T);
}

void response_at(const struct response *r, const struct response_lattice *l, const struct field *f,
                 const double *base, double *out) {
    carry(&r->with, l, r->T.T, f, out);
    for (size_t i = 0; i < f->n; i++) out[i] = (out[i] - base[i]) / r->size;
}

/* by_steps: of both problems, as one of them has a change of the equation. */
static int run_on_cells(const struct faulty *with, double dx, int by_steps, struct field *f) {
    if (!by_steps) return solve(with, dx, fourier_of_responses(&with->problem), f);
    solve_by_steps(with, dx, f);
    return 0;
}

int response_on_cells(const struct problem *p, double dx, struct fault fault, const struct field *f,
                      double *response) {
    const int most = p->dim == 3 ? 48 : 160;
    struct faulty with, none;
    struct field right, faulty;
    if ((p->hi[0] - p->lo[0]) / dx > most + 0.5 || !faulty_make(p, fault, dx, &with)) return -1;
    for (int a = 0; a < p->dim; a++)
        if (!is_face(p->hi[a], p->lo[a], dx)) return -1;
    make_none(p, &none);
    int failed = run_on_cells(&none, dx, with.by_steps, &right);
    if (failed) return -1;
    failed = run_on_cells(&with, dx, with.by_steps, &faulty);
    if (!failed) {
        struct response_lattice l = {{right.shape[0], right.shape[1], right.shape[2]}, dx, right.T, NULL, NULL};
        for (size_t i = 0; i < right.n; i++) right.T[i] = faulty.T[i] - right.T[i];
        carry(&with, &l, l.T, f, response);
        field_free(&faulty);
    }
    field_free(&right);
    return failed ? -1 : 0;
}
