/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dummies by a quadratic that satisfies the boundary condition.  About the nearest point of the body, with xi
 * outward and eta (in space also zeta) along the wall,
 *   T(xi, eta) = c + c_xi xi + c_eta eta + quadratic terms
 * is fitted to nearby particles by least squares with the kernel as weight, under the exact condition at that point:
 *   Dirichlet  c = T_w,   Neumann  c_xi = q/k,   Robin  c_xi = (b/k) (T_a - c).
 * The condition fixes a known part, and the remaining functions are free; at a corner both walls impose their
 * condition.  The temperatures of a Dirichlet wall next to the foot are also known and join the data.
 *
 * In the plane each fit requires fifteen particles.  With eight, few for five unknowns, the shares are large, and the
 * stability limit at a Dirichlet wall is 0.14 dx^2/kappa instead of 0.5 without walls.  A particle next to the wall
 * may then represent the temperature along it, and modes grow if the wall's own temperatures are not in the data (4
 * of 20 clouds of jitter 0.2; none of 79 with fifteen).  Fifteen are a half disc of radius 3.1 dx.  In space the half
 * ball of that radius has (2 pi/3) (2 15/pi)^(3/2) = 62 particles: the fit requires sixty, for nine unknowns.  In a
 * ball of radius 6 dx the stable step is then that without walls (0.48 dx^2/kappa), for all three conditions; with
 * forty it is 0.40 at a Dirichlet wall, with twenty 0.16.
 *
 * Order: dummies are exact for quadratics that satisfy the boundary condition, so their error is O(dx^3), and that
 * of the operator in a layer one kernel wide is O(dx).  This layer contributes O(dx^3) to T at a Dirichlet wall and
 * O(dx^2) at others: second order, also in the maximum norm. */
#include "solver/particles/walls.h"

#include <math.h>
#include <string.h>

struct bound {                     /* the quadratic at one wall, edge or corner, lengths in units of h */
    int dim, held;                 /* held: number of Dirichlet walls */
    double axis[DIM_MAX][DIM_MAX]; /* directions of xi, eta, ...; first the normals */
    double c;                      /* K, if fixed */
    int bound[DIM_MAX];            /* 1 if the slope along the axis is s + r c */
    double s[DIM_MAX], r[DIM_MAX];
};

/* Completes `given` unit vectors of axis by vectors at right angles to them. */
static void complete_axes(int dim, int given, double axis[DIM_MAX][DIM_MAX]) {
    if (dim == 2 && given == 1) axis[1][0] = -axis[0][1], axis[1][1] = axis[0][0];
    for (int n = given; dim == 3 && n < dim; n++) {
        double *t = axis[n], length = 0;
        for (int k = 0; k < dim && !(length > 0.5); k++) { /* one of the axes is far from all given ones */
            for (int a = 0; a < dim; a++) t[a] = a == k;
            for (int m = 0; m < n; m++) {
                double along = axis[m][k];
                for (int a = 0; a < dim; a++) t[a] -= along * axis[m][a];
            }
            length = sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        }
        for (int a = 0; a < dim; a++) t[a] /= length;
    }
}

static struct bound bind(const struct problem *p, const struct wall_site *site, double h) {
    struct bound b = {.dim = p->dim};
    memcpy(b.axis, site->normal, sizeof b.axis);
    complete_axes(p->dim, site->walls, b.axis);
    for (int n = 0; n < site->walls; n++) {
        enum side side = site->side[n];
        double ratio = p->robin[side] * h / site->k[n];
        if (p->side[side] == DIRICHLET) {
            b.c = (b.held * b.c + site->value[n]) / (b.held + 1);
            b.held++;
            continue;
        }
        b.bound[n] = 1;
        b.s[n] = p->side[side] == ROBIN ? ratio * site->value[n] : site->value[n] * h / site->k[n];
        b.r[n] = p->side[side] == ROBIN ? -ratio : 0;
    }
    return b;
}

/* The known part at d (m from the foot), K, and the free functions there; returns their number. */
static int functions(const struct bound *b, const double *d, double h, double *known, double *P) {
    double x[DIM_MAX] = {0}, with_c = 1;
    int n = 0;
    for (int a = 0; a < b->dim; a++) x[a] = (d[0] * b->axis[a][0] + d[1] * b->axis[a][1] + d[2] * b->axis[a][2]) / h;
    *known = b->held ? b->c : 0;
    for (int a = 0; a < b->dim; a++) {
        if (b->bound[a])
            *known += (b->s[a] + (b->held ? b->r[a] * b->c : 0)) * x[a], with_c += b->r[a] * x[a];
        else
            P[n++] = x[a];
    }
    if (!b->held) P[n++] = with_c / (1 + fabs(b->r[0]) + fabs(b->r[1]) + fabs(b->r[2]));
    for (int e = 0; e < b->dim; e++)
        for (int a = 0; a <= e; a++) P[n++] = x[a] * x[e] * (a == e ? 0.5 : 1);
    return n;
}

enum { WALL_DATA = 24 };

struct fit {
    const struct wall_site *site;
    struct wall_sum *out;
};

/* Points on the Dirichlet walls of the site, m from the foot, with their temperatures, K, as data of the fit.
 * Returns their number. */
static size_t wall_data(const struct problem *p, const struct wall_site *site, double h, double d[WALL_DATA][DIM_MAX],
                        double T[WALL_DATA]) {
    static const double plane[][2] = {{-1, 0}, {-0.5, 0}, {0.5, 0}, {1, 0}}; /* h along the wall */
    static const double space[][2] = {{-1, 0},      {1, 0},      {0, -1},     {0, 1},
                                      {-0.5, -0.5}, {-0.5, 0.5}, {0.5, -0.5}, {0.5, 0.5}};
    const double(*at)[2] = p->dim == 3 ? space : plane;
    size_t n = 0;
    for (int k = 0; k < site->walls && p->dim > 1; k++)
        for (int i = 0; i < (p->dim == 3 ? 8 : 4) && p->side[site->side[k]] == DIRICHLET; i++) {
            double axis[DIM_MAX][DIM_MAX] = {{0}}, x[DIM_MAX];
            memcpy(axis[0], site->normal[k], sizeof axis[0]);
            complete_axes(p->dim, 1, axis);
            for (int a = 0; a < DIM_MAX; a++)
                x[a] = site->foot[a] + at[i][0] * h * axis[1][a] + at[i][1] * h * axis[2][a];
            struct foot f = shape_foot(p, (int)site->side[k], x);
            for (int a = 0; a < DIM_MAX; a++) d[n][a] = f.x[a] - site->foot[a];
            T[n++] = p->wall(p, site->side[k], f.x, 0);
        }
    return n;
}

static int attempt(const struct walls_fill *w, const struct wall_near *near, void *with, struct failure *why) {
    const struct fit *f = with;
    double P[NEIGHBOURS_MAX][FIT_TERMS_MAX], known[NEIGHBOURS_MAX], target[FIT_TERMS_MAX], away[DIM_MAX];
    double d[NEIGHBOURS_MAX][DIM_MAX], given[WALL_DATA], share[NEIGHBOURS_MAX], h = near->nb.h;
    struct neighbourhood nb = near->nb;
    struct bound b = bind(w->p, f->site, h);
    if (nb.n + WALL_DATA > NEIGHBOURS_MAX) return refuse(why, STATUS_NUMERICAL, "too many particles at a wall");
    memcpy(d, near->d, nb.n * sizeof *d);
    nb.n += wall_data(w->p, f->site, h, d + nb.n, given);
    nb.d = d;
    for (int a = 0; a < DIM_MAX; a++) away[a] = f->site->x[a] - f->site->foot[a];
    int terms = functions(&b, away, h, &f->out->offset, target);
    for (size_t j = 0; j < nb.n; j++) functions(&b, d[j], h, &known[j], P[j]);
    if (ssph_fit(&nb, w->o->kernel, terms, P, NULL, target, share, why)) return why->status;
    f->out->n = near->nb.n;
    for (size_t j = 0; j < nb.n; j++) {
        f->out->offset -= share[j] * known[j];
        if (j < near->nb.n)
            f->out->from[j] = near->from[j], f->out->share[j] = share[j];
        else
            f->out->offset += share[j] * given[j - near->nb.n];
    }
    return STATUS_OK;
}

static void place(const struct wall_site *site, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = site->foot[a];
}

static int fill(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why) {
    struct fit f = {site, out};
    return walls_near(w, d, walls_least[w->p->dim], attempt, &f, why);
}

const struct wall_treatment walls_fit = {
    .kinds = 1u << DIRICHLET | 1u << NEUMANN | 1u << ROBIN, .place = place, .fill = fill};
