/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dummies of a cut lattice: the wall at a dummy, the particles near it, and the treatments that give it a
 * temperature. d is the distance from the wall, q a flux into the body, T_a the temperature of surroundings that
 * exchange b (T_a - T).
 *
 * Use `fit` (derived below).  The others are published ones of lower order, for the study of walls:
 *
 * fixed     T_d = T_w (Pamplona 2019, Fig. 3).  The effective wall is at the dummies, up to dx from its true
 *           position: first order.
 *
 * distance  Morris, Fox & Zhu 1997, J. Comput. Phys. 136:214, for each pair of a particle i and a dummy d:
 *           T_d = T_w - (d_d/d_i) (T_i - T_w),   1 + d_d/d_i at most 1.5.
 *           Exact for linear T across the wall unless the bound is active.  It is for most pairs, d_d > d_i/2,
 *           which weakens the wall by a fraction independent of dx.
 *
 * average   Adami, Hu & Adams 2012, J. Comput. Phys. 231:7057, with the Shepard mean <.> at the dummy:
 *           given T_w  T_d = 2 T_w - <T>,   given q  T_d = <T> + (d_d + <d>) q/k.
 *           The particles near a dummy have other distances from the wall.  If T_w is given the error of T_d is
 *           (d_d - <d>) dT/dn = O(dx), which costs an order; a flux has the right slope and an error of O(dx^2).
 *
 * image     Marrone et al. 2011, Comput. Methods Appl. Mech. Engrg. 200:1526, with T_m at the mirror point by
 *           linear moving least squares:
 *           given T_w  T_d = 2 T_w - T_m,   given q  T_d = T_m + 2 d q/k,
 *           exchange   T_d = f T_m + (1 - f) T_a,   f = (k - b d)/(k + b d), as for images of particles.
 *           At a corner one reflection follows the other.  The error of T_m is O(dx^2), and so is that of
 *           mirroring at a curved wall. */
#include "solver/particles/walls.h"

#include "solver/particles/ssph.h"
#include "solver/shape.h"
#include "solver/space/assembly.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct wall_site {        /* the wall at a dummy; several at an edge or a corner */
    double x[DIM_MAX];    /* m, the dummy */
    double foot[DIM_MAX]; /* m, nearest point of the body */
    int walls;            /* 1 to dim */
    enum side side[DIM_MAX];
    double normal[DIM_MAX][DIM_MAX]; /* outward, of each wall */
    double away[DIM_MAX];            /* m, distance of the dummy from each wall */
    double value[DIM_MAX];           /* problem.wall at the foot */
    double k[DIM_MAX];               /* W m^-1 K^-1, along each normal */
};

struct wall_near { /* particles near a point, for a least-squares fit */
    struct neighbourhood nb;
    uint32_t from[NEIGHBOURS_MAX];
    double d[NEIGHBOURS_MAX][DIM_MAX]; /* m */
};

struct walls_fill { /* input of the treatments */
    const struct problem *p;
    const struct options *o;
    const struct cloud *c;
    double spacing;      /* m, unit of the option h */
    double widest;       /* h, maximum extent of a search */
    struct cloud *probe; /* the particles, followed by one point for each dummy: a foot or an image */
    struct neighbours cells;
};

struct wall_sum { /* T of a dummy, sum share[k] T_from[k] + offset */
    size_t n;
    uint32_t from[NEIGHBOURS_MAX];
    double share[NEIGHBOURS_MAX];
    double offset; /* K */
};

struct wall_treatment {
    int flux, exchange; /* 1: supports a given flux, an exchange of heat, besides a given temperature */
    int pairs;          /* 1: T differs from pair to pair (struct cloud, `away`) */
    /* The point near which particles are required for dummy d, m; NULL if none are required. */
    void (*place)(const struct wall_site *site, double x[DIM_MAX]);
    /* STATUS_NUMERICAL if there are too few particles nearby. */
    int (*fill)(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why);
};

/* ---- The wall at a dummy ---- */

static void add_wall(const struct problem *p, int s, const double *x, struct wall_site *site) {
    int n = site->walls++;
    struct foot f = shape_foot(p, s, x);
    site->side[n] = (enum side)s;
    memcpy(site->normal[n], f.normal, sizeof f.normal);
    site->away[n] = -f.depth;
    site->value[n] = p->wall(p, (enum side)s, site->foot, 0);
    site->k[n] = p->material[0].k[walls_axis(f.normal)];
}

static struct wall_site site_of(const struct problem *p, const struct cloud *c, size_t j) {
    struct wall_site site = {0};
    const double *x = site.x;
    layout_cloud_place(c, j, site.x);
    if (p->shape) {
        int s;
        struct foot f = shape_nearest(p, x, &s);
        memcpy(site.foot, f.x, sizeof f.x);
        add_wall(p, s, x, &site);
        return site;
    }
    for (int a = 0; a < p->dim; a++) site.foot[a] = fmin(fmax(x[a], p->lo[a]), p->hi[a]);
    for (int s = 0; s < 2 * p->dim; s++)
        if (shape_has_wall(p, s) && shape_foot(p, s, x).depth < 0) add_wall(p, s, x, &site);
    return site;
}

/* ---- The particles near a dummy ---- */

static void probe_create(struct walls_fill *w, const struct wall_treatment *t) {
    const struct cloud *c = w->c;
    struct cloud *q = w->probe = xcalloc(1, sizeof *q);
    *q = (struct cloud){.dim = c->dim, .n = c->n, .total = c->total};
    layout_cloud_alloc(q, q->total);
    for (size_t j = 0; j < c->total; j++) {
        double x[DIM_MAX];
        layout_cloud_place(c, j, x);
        if (j >= c->n) {
            struct wall_site site = site_of(w->p, c, j);
            t->place(&site, x);
        }
        layout_cloud_put(q, j, x);
    }
    neighbours_create(&w->cells, q, KERNEL_SUPPORT * w->widest * w->o->h * w->spacing);
}

static void probe_free(struct walls_fill *w) {
    if (!w->probe) return;
    neighbours_free(&w->cells);
    layout_cloud_free(w->probe);
    free(w->probe);
}

/* Searches the particles within 2 H of the point of dummy d.  H starts at h and grows by tenths until there are at
 * least `least` particles and `attempt` succeeds.  Returns STATUS_OK or the last failure of `attempt`. */
static int search_near(const struct walls_fill *w, size_t d, size_t least,
                       int (*attempt)(const struct walls_fill *w, const struct wall_near *near, void *with,
                                      struct failure *why),
                       void *with, struct failure *why) {
    const struct cloud *q = w->probe;
    size_t place = q->n + d;
    uint32_t *all = xcalloc(NEIGHBOURS_MAX, sizeof *all);
    struct wall_near *near = xcalloc(1, sizeof *near);
    near->nb = (struct neighbourhood){.dim = q->dim, .i = place, .d = near->d};
    layout_cloud_place(q, place, near->nb.x);
    size_t found = neighbours_find(&w->cells, place, all, NEIGHBOURS_MAX);
    if (found > NEIGHBOURS_MAX) { /* dummies share a foot; the particles among them must not be cut off */
        free(all);
        all = xcalloc(found, sizeof *all);
        neighbours_find(&w->cells, place, all, found);
    }
    struct failure last; /* failure of the attempts; a success leaves *why unchanged */
    char text[PLACE_TEXT];
    const double *x = near->nb.x;
    int status =
        refuse(&last, STATUS_NUMERICAL, "the wall at %s has fewer than %zu particles within %g h; use a smaller --dx",
               problem_place(q->dim, x, text), least, KERNEL_SUPPORT * w->widest);
    for (double grown = 1; grown <= w->widest && status; grown *= 1.1) {
        double H = grown * w->o->h * w->spacing, most = KERNEL_SUPPORT * H * (1 - 1e-9);
        size_t n = 0;
        for (size_t k = 0; k < found && n < NEIGHBOURS_MAX; k++) {
            if (all[k] >= q->n) continue;
            layout_cloud_place(q, all[k], near->d[n]);
            for (int a = 0; a < DIM_MAX; a++) near->d[n][a] -= x[a];
            if (neighbourhood_distance(&near->nb, n) >= most) continue;
            near->from[n++] = all[k];
        }
        near->nb.n = n, near->nb.h = H;
        if (n >= least) status = attempt(w, near, with, &last);
    }
    if (status) *why = last;
    free(near);
    free(all);
    return status;
}

/* ---- fixed, distance ---- */

static int fill_held(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                     struct failure *why) {
    (void)w, (void)d, (void)why;
    out->offset = 0;
    for (int n = 0; n < site->walls; n++) out->offset += site->value[n] / site->walls;
    return STATUS_OK;
}

static const struct wall_treatment by_fixed = {.fill = fill_held};

static const struct wall_treatment by_distance = {.pairs = 1, .fill = fill_held};

/* ---- average ---- */

static void at_dummy(const struct wall_site *site, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = site->x[a];
}

struct shepard {
    struct wall_sum *out;
    double depth; /* m, <d> */
};

static int shepard_mean(const struct walls_fill *w, const struct wall_near *near, void *with, struct failure *why) {
    struct shepard *m = with;
    double sum = 0;
    (void)why;
    m->out->n = near->nb.n, m->depth = 0;
    for (size_t j = 0; j < near->nb.n; j++) {
        double W = kernel_value(w->o->kernel, near->nb.dim, neighbourhood_distance(&near->nb, j) / near->nb.h);
        m->out->from[j] = near->from[j], m->out->share[j] = W;
        sum += W;
    }
    if (!(sum > 0)) return refuse(why, STATUS_NUMERICAL, "a dummy has no neighbour with a positive weight");
    for (size_t j = 0; j < near->nb.n; j++) {
        m->out->share[j] /= sum;
        double x[DIM_MAX];
        layout_cloud_place(w->c, near->from[j], x);
        m->depth += m->out->share[j] * shape_depth(w->p, x);
    }
    return STATUS_OK;
}

/* At an edge or a corner the wall at the larger distance determines the dummy. */
static int fill_average(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                        struct failure *why) {
    int n = 0;
    for (int k = 1; k < site->walls; k++)
        if (site->away[k] > site->away[n]) n = k;
    struct shepard m = {out, 0};
    if (search_near(w, d, 1, shepard_mean, &m, why)) return why->status;
    if (problem_law(w->p, (int)site->side[n])->is_flux) {
        out->offset = (site->away[n] + m.depth) * site->value[n] / site->k[n];
        return STATUS_OK;
    }
    for (size_t j = 0; j < out->n; j++) out->share[j] = -out->share[j];
    out->offset = 2 * site->value[n];
    return STATUS_OK;
}

static const struct wall_treatment by_average = {.flux = 1, .place = at_dummy, .fill = fill_average};

/* ---- image ---- */

static void at_image(const struct wall_site *site, double x[DIM_MAX]) {
    at_dummy(site, x);
    for (int n = 0; n < site->walls; n++)
        for (int a = 0; a < DIM_MAX; a++) x[a] -= 2 * site->away[n] * site->normal[n][a];
}

static int interpolate(const struct walls_fill *w, const struct wall_near *near, void *with, struct failure *why) {
    struct wall_sum *out = with;
    double P[NEIGHBOURS_MAX][FIT_TERMS_MAX], target[DIM_MAX + 1] = {1};
    for (size_t j = 0; j < near->nb.n; j++) {
        P[j][0] = 1;
        for (int a = 0; a < DIM_MAX; a++) P[j][a + 1] = near->d[j][a] / near->nb.h;
        out->from[j] = near->from[j];
    }
    out->n = near->nb.n;
    return ssph_fit(&near->nb, w->o->kernel, w->p->dim + 1, P, NULL, target, out->share, why);
}

static int fill_image(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                      struct failure *why) {
    double factor = 1;
    static const size_t least[] = {0, 3, 5, 9};
    double x[DIM_MAX];
    if (search_near(w, d, least[w->p->dim], interpolate, out, why)) return why->status;
    out->offset = 0;
    at_dummy(site, x);
    for (int n = 0; n < site->walls; n++) {
        enum side s = site->side[n];
        double f = layout_image_factor(w->p, (int)s, site->k[n], site->away[n]);
        double q = problem_law(w->p, (int)s)->is_flux ? 2 * site->away[n] / site->k[n] : 1 - f;
        struct foot foot = shape_foot(w->p, (int)s, x);
        out->offset += factor * q * w->p->wall(w->p, s, foot.x, 0);
        factor *= f;
        for (int a = 0; a < DIM_MAX; a++) x[a] = 2 * foot.x[a] - x[a];
    }
    for (size_t j = 0; j < out->n; j++) out->share[j] *= factor;
    return STATUS_OK;
}

static const struct wall_treatment by_image = {.flux = 1, .exchange = 1, .place = at_image, .fill = fill_image};

/* ---- fit: a quadratic that satisfies the boundary condition ---- */

/* About the nearest point of the body, with xi outward and eta (in space also zeta) along the wall,
 *   T(xi, eta) = c + c_xi xi + c_eta eta + quadratic terms
 * is fitted to nearby particles by least squares with the kernel as weight, under the exact condition at that point:
 *   given T_w  c = T_w,   given q  c_xi = q/k,   exchange  c_xi = (b/k) (T_a - c).
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
 * Order: dummies are exact for quadratics that satisfy the boundary condition, so their error is O(dx^3), and that of
 * the operator in a layer one kernel wide is O(dx).  This layer contributes O(dx^3) to T at a Dirichlet wall and
 * O(dx^2) at others: second order, also in the maximum norm. */

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

static struct bound bind_wall(const struct problem *p, const struct wall_site *site, double h) {
    struct bound b = {.dim = p->dim};
    memcpy(b.axis, site->normal, sizeof b.axis);
    complete_axes(p->dim, site->walls, b.axis);
    for (int n = 0; n < site->walls; n++) {
        enum side side = site->side[n];
        double ratio = problem_transfer(p, (int)side) * h / site->k[n];
        int is_flux = problem_law(p, (int)side)->is_flux;
        if (p->side[side] == DIRICHLET) {
            b.c = (b.held * b.c + site->value[n]) / (b.held + 1);
            b.held++;
            continue;
        }
        b.bound[n] = 1;
        b.s[n] = is_flux ? site->value[n] * h / site->k[n] : ratio * site->value[n];
        b.r[n] = is_flux ? 0 : -ratio;
    }
    return b;
}

/* The known part at d (m from the foot), K, and the free functions there; returns their number. */
static int quadratic_functions(const struct bound *b, const double *d, double h, double *known, double *P) {
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

static int fit_quadratic(const struct walls_fill *w, const struct wall_near *near, void *with, struct failure *why) {
    const struct fit *f = with;
    double P[NEIGHBOURS_MAX][FIT_TERMS_MAX], known[NEIGHBOURS_MAX], target[FIT_TERMS_MAX], away[DIM_MAX];
    double d[NEIGHBOURS_MAX][DIM_MAX], given[WALL_DATA], share[NEIGHBOURS_MAX], h = near->nb.h;
    struct neighbourhood nb = near->nb;
    struct bound b = bind_wall(w->p, f->site, h);
    if (nb.n + WALL_DATA > NEIGHBOURS_MAX) return refuse(why, STATUS_NUMERICAL, "too many particles at a wall");
    memcpy(d, near->d, nb.n * sizeof *d);
    nb.n += wall_data(w->p, f->site, h, d + nb.n, given);
    nb.d = d;
    for (int a = 0; a < DIM_MAX; a++) away[a] = f->site->x[a] - f->site->foot[a];
    int terms = quadratic_functions(&b, away, h, &f->out->offset, target);
    for (size_t j = 0; j < nb.n; j++) quadratic_functions(&b, d[j], h, &known[j], P[j]);
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

static void at_foot(const struct wall_site *site, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = site->foot[a];
}

static int fill_fit(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                    struct failure *why) {
    struct fit f = {site, out};
    return search_near(w, d, walls_least[w->p->dim], fit_quadratic, &f, why);
}

static const struct wall_treatment by_fit = {.flux = 1, .exchange = 1, .place = at_foot, .fill = fill_fit};

/* ---- All dummies ---- */

/* NULL for walls without dummies. */
static const struct wall_treatment *treatment(enum walls walls) {
    static const struct wall_treatment *const all[] = {
        [WALLS_FIXED] = &by_fixed, [WALLS_DISTANCE] = &by_distance, [WALLS_AVERAGE] = &by_average,
        [WALLS_IMAGE] = &by_image, [WALLS_FIT] = &by_fit,           [WALLS_ONE_SIDED] = NULL};
    return all[walls];
}

int walls_support(enum walls walls, const struct wall_law *law) {
    const struct wall_treatment *t = treatment(walls);
    return !t || ((t->flux || !law->is_flux) && (t->exchange || !law->exchange));
}

static void append_sum(struct cloud *c, size_t d, const struct wall_sum *sum, size_t *room) {
    size_t used = c->begin[d];
    while (used + sum->n > *room) {
        size_t larger = *room ? 2 * *room : 1024;
        c->from = xgrow(c->from, *room, larger, sizeof *c->from);
        c->share = xgrow(c->share, *room, larger, sizeof *c->share);
        *room = larger;
    }
    for (size_t k = 0; k < sum->n; k++) c->from[used + k] = sum->from[k], c->share[used + k] = sum->share[k];
    c->begin[d + 1] = used + sum->n;
    c->offset[c->n + d] = sum->offset;
}

int walls_fill(const struct problem *p, const struct options *o, struct cloud *c, double spacing,
               struct failure *why) {
    const struct wall_treatment *t = treatment(o->walls);
    struct walls_fill w = {.p = p, .o = o, .c = c, .spacing = spacing, .widest = assembly_widest(p->dim, o->h)};
    size_t dummies = c->total - c->n, room = 0;
    int status = STATUS_OK;
    if (!layout_is_cut(p, o) || !t) return STATUS_OK;
    c->begin = xcalloc(dummies + 1, sizeof *c->begin);
    if (t->pairs) c->away = xcalloc(dummies, sizeof *c->away);
    if (t->place) probe_create(&w, t);
    struct wall_sum *sum = xcalloc(1, sizeof *sum);
    for (size_t d = 0; d < dummies && !status; d++) {
        struct wall_site site = site_of(p, c, c->n + d);
        sum->n = 0;
        status = t->fill(&w, d, &site, sum, why);
        append_sum(c, d, sum, &room);
        if (c->away) c->away[d] = site.away[0];
    }
    free(sum);
    probe_free(&w);
    return status;
}
