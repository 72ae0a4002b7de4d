/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quantities of a scene at points: one table, one function each. */
#include "references/columns.h"

#include "references/cubature.h"
#include "references/kirchhoff.h"
#include "references/mapping.h"
#include "references/snapshot.h"
#include "solver/shape.h"
#include "solver/status.h"
#include "solver/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_integration.h>

/* ---- Means over cells ---- */

/* Averages of initial data over cells, weighted with the heat capacity of each material.
 *
 * The cubature is broken at jumps, at an interface, and graded towards a kink.  In a cell that a round wall cuts, the
 * average is along lines in y that end at the wall.  The length of these lines has a kink at the point at which the
 * wall leaves the cell, and a singular slope at a wall parallel to y.  In a ball the lines are along z, at Gauss
 * points of x and y: the same kinks cost some 1e-3 of the variation in the cell. */

/* The line at x[0] of a cell cut by a round wall; its integral or its length. */
struct line {
    const struct problem *p;
    double lo, hi, x; /* m */
    int length;       /* 1: length only */
};

static struct approx initial_on_line(const void *data, const double *y) {
    const struct line *l = data;
    return (struct approx){l->p->initial(l->p, (const double[2]){l->x, y[0]}), 0};
}

static struct approx along_line(const void *data, const double *x) {
    struct line l = *(const struct line *)data;
    double piece[2][2];
    struct approx sum = {0, 0};
    l.x = x[0];
    for (int k = 0, n = shape_pieces(l.p, x[0], l.lo, l.hi, piece); k < n; k++) {
        struct cubature_knots none = {.count = {0, 0}};
        double from[2] = {piece[k][0], 0}, to[2] = {piece[k][1], 0}, length = to[0] - from[0];
        struct approx mean =
            l.length ? (struct approx){1, 0} : cubature_mean(initial_on_line, &l, 1, from, to, &none);
        sum.value += length * mean.value, sum.error += length * mean.error;
    }
    return sum;
}

static double ball_mean(const struct problem *p, const double *lo, const double *hi) {
    enum { POINTS = 10 };
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(POINTS);
    double sum = 0, volume = 0, at[2][POINTS], weight[2][POINTS];
    for (int a = 0; a < 2; a++)
        for (size_t i = 0; i < POINTS; i++)
            gsl_integration_glfixed_point(lo[a], hi[a], i, &at[a][i], &weight[a][i], rule);
    for (int k = 0; k < POINTS * POINTS; k++) {
        double x[DIM_MAX] = {at[0][k % POINTS], at[1][k / POINTS], 0}, w;
        double half = sqrt(fmax(0, p->radius[1] * p->radius[1] - x[0] * x[0] - x[1] * x[1]));
        double from = fmax(lo[2], -half), to = fmin(hi[2], half);
        for (size_t i = 0; i < POINTS && to > from; i++) {
            gsl_integration_glfixed_point(from, to, i, &x[2], &w, rule);
            w *= weight[0][k % POINTS] * weight[1][k / POINTS];
            sum += w * p->initial(p, x), volume += w;
        }
    }
    gsl_integration_glfixed_table_free(rule);
    return volume > 0 ? sum / volume
                      : p->initial(p, (double[]){(lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2});
}

static double clipped(const struct problem *p, const double *lo, const double *hi) {
    if (p->dim == 3) return ball_mean(p, lo, hi);
    struct cubature_knots knots = {.count = {0, 0}};
    struct line l = {p, lo[1], hi[1], 0, 0};
    int n = 0;
    for (int s = X_LO; s <= X_HI; s++) {
        double R = p->radius[s],
               place[] = {-R, R, sqrt(fmax(0, R * R - lo[1] * lo[1])), sqrt(fmax(0, R * R - hi[1] * hi[1]))};
        if (!shape_has_wall(p, s)) continue;
        for (int k = 0; k < 6 && n < CUBATURE_KNOTS; k++) {
            double at = k < 4 ? place[k] : -place[k - 2];
            if (!(at >= lo[0] && at <= hi[0])) continue;
            knots.knot[0][n].at = at;
            knots.knot[0][n++].graded = 1;
        }
    }
    knots.count[0] = n;
    double sum = cubature_mean(along_line, &l, 1, lo, hi, &knots).value;
    l.length = 1;
    return sum / cubature_mean(along_line, &l, 1, lo, hi, &knots).value;
}

static struct approx initial_at(const void *data, const double *x) {
    const struct problem *p = data;
    return (struct approx){p->initial(p, x), 0};
}

static void add_graded(struct cubature_knots *knots, int axis, double at) {
    int k = knots->count[axis]++;
    knots->knot[axis][k].at = at;
    knots->knot[axis][k].graded = 1;
}

/* Data that jump or bend along curves: the midpoint rule with n points an axis.  The n^(dim - 1) parts that the curve
 * cuts are off by 1/n^dim of the jump at most, with either sign: 1/n^((dim + 1)/2) of it, 0.5 % for both n. */
static double mean_of_points(const struct problem *p, const double *lo, const double *hi) {
    const int n = p->dim > 2 ? 14 : 32, layers = p->dim > 2 ? n : 1;
    double sum = 0;
    for (int k = 0; k < n * n * layers; k++) {
        const int i[DIM_MAX] = {k % n, k / n % n, k / n / n};
        double x[DIM_MAX] = {0};
        for (int a = 0; a < p->dim; a++) x[a] = lo[a] + (hi[a] - lo[a]) * (i[a] + 0.5) / n;
        sum += p->initial(p, x);
    }
    return sum / (n * n * layers);
}

/* Average over the part of the body from lo to hi.  The data of a scene may have a kink at an interface, and on a rod
 * or in the plane a peak in the middle. */
static double mean(const struct problem *p, int interface_axis, const double *lo, const double *hi) {
    struct cubature_knots knots = {.cell = p->dim > 1};
    double volume = (hi[0] - lo[0]) * (hi[1] - lo[1]) * (p->dim == 3 ? hi[2] - lo[2] : 1);
    double part = p->shape ? shape_clipped(p, lo, hi) / volume : 1;
    if (part < 1 - 1e-9 && part > 1e-12) return clipped(p, lo, hi);
    if (p->breaks_on_curves) return mean_of_points(p, lo, hi);
    for (int a = 0; a < p->dim; a++) {
        for (int j = 0; j < p->jumps[a]; j++) knots.knot[a][knots.count[a]++].at = p->jump[a][j];
        if (p->dim < 3) add_graded(&knots, a, (p->lo[a] + p->hi[a]) / 2);
        if (p->kinked[a]) add_graded(&knots, a, p->kink[a]);
        if (p->materials == 2 && a == interface_axis) knots.knot[a][knots.count[a]++].at = p->interface;
    }
    return cubature_mean(initial_at, p, p->dim, lo, hi, &knots).value;
}

/* K: the temperature that keeps the initial heat of the part of the body from lo to hi (m): the integral of rho_c T
 * over that of rho_c.  A cell of zero extent has the value at its point. */
static double initial_mean_of(const struct image *image, const double *lo, const double *hi) {
    const struct problem *p = &image->problem;
    const int a = image->interface_axis;
    double below[DIM_MAX], above[DIM_MAX], heat[2];
    if (p->materials < 2 || !(lo[a] < p->interface && p->interface < hi[a])) return mean(p, a, lo, hi);
    for (int d = 0; d < DIM_MAX; d++)
        below[d] = d == a ? p->interface : hi[d], above[d] = d == a ? p->interface : lo[d];
    heat[0] = (p->interface - lo[a]) * p->material[0].rho_c;
    heat[1] = (hi[a] - p->interface) * p->material[1].rho_c;
    return (mean(p, a, lo, below) * heat[0] + mean(p, a, above, hi) * heat[1]) / (heat[0] + heat[1]);
}

/* ---- The columns ---- */

struct columns_row {
    const struct image *image;
    const struct problem *p; /* the problem of the image */
    const double *x;
    const double *cell;
    double time;        /* s */
    int axis;           /* axis of the column, if it has one */
    struct exact exact; /* if a column depends on time */
};

static int material_at(const struct columns_row *row) {
    return row->p->materials == 2 && row->x[row->image->interface_axis] >= row->p->interface;
}

static void temperature(const struct columns_row *row, double *value) {
    *value = row->exact.no_value ? NAN : mapping_temperature(&row->image->map, row->exact.temperature);
}

static void error_bound(const struct columns_row *row, double *value) {
    const struct exact *e = &row->exact;
    *value = e->no_value ? NAN : mapping_bound(&row->image->map, e->temperature, e->error_bound);
}

static void flux(const struct columns_row *row, double *value) {
    const struct mapping *m = &row->image->map;
    const struct problem *of = row->image->of;
    double at[DIM_MAX];
    mapping_to_scene(m, of->dim, row->x, at);
    int material = of->materials == 2 && at[0] >= of->interface; /* the gradient is that of the same material */
    int along = mapping_axis(m, row->axis);
    double into = mapping_scale(m) * (m->against[row->axis] ? -1 : 1);
    double K[DIM_MAX][DIM_MAX], sum = 0;
    problem_tensor(of, at, K);
    if (!of->direction) K[along][along] = kirchhoff_along(of, &of->material[material], along, row->exact.temperature);
    for (int a = 0; a < of->dim; a++) sum += K[along][a] * row->exact.gradient[a];
    *value = row->exact.no_value ? NAN : -into * sum;
}

static void initial(const struct columns_row *row, double *value) {
    *value = row->p->initial(row->p, row->x);
}

/* The cell around the point, clipped to the domain. */
static void cell_of(const struct columns_row *row, double lo[DIM_MAX], double hi[DIM_MAX]) {
    for (int a = 0; a < row->p->dim; a++) {
        int clip = row->p->side[2 * a] != PERIODIC;
        lo[a] = fmax(row->x[a] - row->cell[a] / 2, clip ? row->p->lo[a] : -INFINITY);
        hi[a] = fmin(row->x[a] + row->cell[a] / 2, clip ? row->p->hi[a] : INFINITY);
    }
}

static void initial_mean(const struct columns_row *row, double *value) {
    double lo[DIM_MAX] = {0}, hi[DIM_MAX] = {0};
    cell_of(row, lo, hi);
    *value = initial_mean_of(row->image, lo, hi);
}

static void source(const struct columns_row *row, double *value) {
    *value = problem_source(row->p, row->x, row->time);
}

static void conductivity(const struct columns_row *row, double *value) {
    double K[DIM_MAX][DIM_MAX];
    *value = row->p->material[material_at(row)].k[row->axis];
    if (!row->p->direction) return;
    problem_tensor(row->p, row->x, K);
    *value = K[row->axis][row->axis];
}

static void cross(const struct columns_row *row, double *value) {
    static const int first[] = {0, 0, 1}, second[] = {1, 2, 2};
    double K[DIM_MAX][DIM_MAX];
    problem_tensor(row->p, row->x, K);
    *value = K[first[row->axis]][second[row->axis]];
}

static void direction(const struct columns_row *row, double *value) {
    double b[DIM_MAX] = {NAN, NAN, NAN};
    if (row->p->direction) row->p->direction(row->p, row->x, b);
    *value = b[row->axis];
}

static void rho_c(const struct columns_row *row, double *value) {
    *value = row->p->material[material_at(row)].rho_c;
}

static void wall_values(const struct problem *p, int s, const double *x, double t, double *value) {
    value[0] = problem_law(p, s)->number;
    value[1] = p->wall(p, (enum side)s, x, t);
    value[2] = p->side[s] == ROBIN ? p->robin[s] : 0;
}

static void wall_at(const struct columns_row *row, int axis, double *value) {
    const struct problem *p = row->p;
    int upper = row->x[axis] >= p->hi[axis], s = 2 * axis + upper;
    value[0] = value[1] = value[2] = 0;
    if (p->shape || p->side[s] == PERIODIC || (!upper && row->x[axis] > p->lo[axis])) return;
    wall_values(p, s, row->x, row->time, value);
}

static void wall_across(const struct columns_row *row, double *value) {
    wall_at(row, row->axis, value);
}

/* A point is on a round wall within round-off. */
static void round_wall(const struct problem *p, const double *x, double t, double *value) {
    int s;
    value[0] = value[1] = value[2] = 0;
    if (fabs(shape_nearest(p, x, &s).depth) <= 1e-9 * p->radius[1]) wall_values(p, s, x, t, value);
}

static void nearest(const struct columns_row *row, double *value) {
    int s, dim = row->p->dim < 3 ? 2 : 3;
    struct foot f = shape_nearest(row->p, row->x, &s);
    for (int a = 0; a < dim; a++) value[a] = s < 0 ? NAN : f.x[a], value[dim + a] = s < 0 ? NAN : f.normal[a];
    value[2 * dim] = s < 0 ? NAN : f.depth;
    for (int k = 1; k <= 3; k++) value[2 * dim + k] = 0;
    if (s >= 0) wall_values(row->p, s, f.x, row->time, value + 2 * dim + 1);
}

/* The lowest kind of the walls at x; the mean of several temperatures. */
static void wall(const struct columns_row *row, double *value) {
    double other[3], sum = 0;
    int held = 0;
    if (row->p->shape) {
        round_wall(row->p, row->x, row->time, value);
        return;
    }
    for (int a = 0; a < row->p->dim; a++) {
        wall_at(row, a, other);
        if (other[0] == 1) held++, sum += other[1];
        if (a == 0 || value[0] == 0 || (other[0] > 0 && other[0] < value[0])) memcpy(value, other, sizeof other);
    }
    if (held > 1) value[1] = sum / held;
}

static const struct columns_kind kinds[] = {
    {"temperature", "temperature", 1, 0, 0, temperature, 0, 1, NULL, NULL},
    {"error_bound", "error_bound", 1, 0, 0, error_bound, 0, 1, NULL, NULL},
    {"initial", "initial", 0, 0, 0, initial, 0, 1, NULL, NULL},
    {"initial_mean", "initial_mean", 0, 1, 0, initial_mean, 0, 1, NULL, NULL},
    {"initial_heat", "initial_heat", 0, 1, 0, initial_mean, 0, 1, NULL, "initial_mean"},
    {"source", "source", 0, 0, 0, source, 0, 1, NULL, NULL},
    {"k_x", "k_x", 0, 0, 0, conductivity, 0, 1, NULL, NULL},
    {"k_y", "k_y", 0, 0, 2, conductivity, 1, 1, NULL, NULL},
    {"k_z", "k_z", 0, 0, 3, conductivity, 2, 1, NULL, NULL},
    {"k_xy", "k_xy", 0, 0, 2, cross, 0, 1, NULL, NULL},
    {"k_xz", "k_xz", 0, 0, 3, cross, 1, 1, NULL, NULL},
    {"k_yz", "k_yz", 0, 0, 3, cross, 2, 1, NULL, NULL},
    {"b_x", "b_x", 0, 0, 2, direction, 0, 1, NULL, NULL},
    {"b_y", "b_y", 0, 0, 2, direction, 1, 1, NULL, NULL},
    {"rho_c", "rho_c", 0, 0, 0, rho_c, 0, 1, NULL, NULL},
    {"flux_x", "flux_x", 1, 0, 0, flux, 0, 1, NULL, NULL},
    {"flux_y", "flux_y", 1, 0, 2, flux, 1, 1, NULL, NULL},
    {"flux_z", "flux_z", 1, 0, 3, flux, 2, 1, NULL, NULL},
    {"wall", "wall_kind,wall_value,wall_b", 0, 0, 0, wall, 0, 3, NULL, NULL},
    {"nearest", "nearest_x,nearest_y,normal_x,normal_y,distance,nearest_kind,nearest_value,nearest_b", 0, 0, 0,
     nearest, 0, 8,
     "nearest_x,nearest_y,nearest_z,normal_x,normal_y,normal_z,distance,nearest_kind,nearest_value,nearest_b", NULL},
    {"wall_x", "wall_x_kind,wall_x_value,wall_x_b", 0, 0, 0, wall_across, 0, 3, NULL, NULL},
    {"wall_y", "wall_y_kind,wall_y_value,wall_y_b", 0, 0, 2, wall_across, 1, 3, NULL, NULL},
    {"wall_z", "wall_z_kind,wall_z_value,wall_z_b", 0, 0, 3, wall_across, 2, 3, NULL, NULL},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static int count_values(const struct columns_kind *kind, int dim) {
    return kind->values + (dim == 3 && kind->space ? 2 : 0);
}

int columns_parse(const char *list, int dim, struct columns *c, struct failure *why) {
    const char *names[KINDS + 1] = {0};
    for (int k = 0; k < KINDS; k++) names[k] = kinds[k].name;
    *c = (struct columns){.dim = dim};
    for (const char *at = list;; at++) {
        char name[64];
        size_t length = strcspn(at, ",");
        snprintf(name, sizeof name, "%.*s", (int)(length < 63 ? length : 63), at);
        int k = words_index(names, name);
        if (k < 0) return words_unknown(names, "--what", name, why);
        if (kinds[k].axes > dim)
            return refuse(why, STATUS_INPUT, "--what %s: %s has no %c", name, dim == 1 ? "a rod" : "a plane scene",
                          "xyz"[kinds[k].axes - 1]);
        for (int i = 0; i < c->count; i++)
            if (c->kind[i] == &kinds[k]) return refuse(why, STATUS_INPUT, "--what %s: is named twice", name);
        c->kind[c->count++] = &kinds[k];
        c->needs_time |= kinds[k].needs_time;
        c->needs_cell |= kinds[k].needs_cell;
        c->values += count_values(&kinds[k], dim);
        at += length;
        if (*at == '\0') return STATUS_OK;
    }
}

/* Columns that depend on time in some scenes only. */
static int depends_on_time(const struct problem *p, const char *column) {
    if (strcmp(column, "source") == 0) return p->source_rate || p->source_at;
    return p->wall_rate && (strncmp(column, "wall", 4) == 0 || strcmp(column, "nearest") == 0);
}

int columns_check(const struct columns *c, const struct problem *p, int times, const double *time, int has_cell,
                  struct failure *why) {
    for (int i = 0; i < c->count; i++) {
        const struct columns_kind *kind = c->kind[i];
        if (kind->needs_time && times == 0)
            return refuse(why, STATUS_INPUT, "--what %s needs --time T[,T...], in s", kind->name);
        if (times == 0 && depends_on_time(p, kind->name))
            return refuse(why, STATUS_INPUT, "--what %s depends on time here and needs --time T[,T...], in s",
                          kind->name);
        if (kind->needs_cell && !has_cell)
            return refuse(
                why, STATUS_INPUT,
                "--what %s needs the cell around each point: columns dx, dy and dz of the points, or --dx DX",
                kind->name);
        for (int k = 0; k < times && strncmp(kind->name, "flux", 4) == 0; k++)
            if (time[k] == 0)
                return refuse(why, STATUS_INPUT,
                              "--time 0: --what %s needs a time > 0, at which the gradient is finite", kind->name);
    }
    return STATUS_OK;
}

void columns_header(const struct columns *c, char *text) {
    *text = '\0';
    for (int i = 0; i < c->count; i++) {
        const struct columns_kind *kind = c->kind[i];
        words_add(text, COLUMNS_HEADER, "%s%s", i ? "," : "",
                  c->dim == 3 && kind->space ? kind->space : kind->header);
    }
}

/* The exact solution at the points, for columns that need it. */
static struct exact *exact_of(const struct image *image, const struct snapshot *now, size_t n, double (*x)[DIM_MAX]) {
    struct exact *e = xcalloc(n, sizeof *e);
    double *to = xcalloc(DIM_MAX * n, sizeof *to), at[DIM_MAX];
    for (size_t i = 0; i < n; i++) {
        mapping_to_scene(&image->map, image->of->dim, x[i], at);
        for (int a = 0; a < DIM_MAX; a++) to[(size_t)a * n + i] = at[a];
    }
    snapshot_at_points(now, n, to, to + n, to + 2 * n, e);
    free(to);
    return e;
}

void columns_at_points(const struct columns *c, const struct image *image, const struct snapshot *now, size_t n,
                       double (*x)[DIM_MAX], double (*cell)[DIM_MAX], double *value) {
    struct exact *exact = c->needs_time ? exact_of(image, now, n, x) : NULL;
    for (size_t i = 0; i < n; i++) {
        struct columns_row row = {
            .image = image, .p = &image->problem, .x = x[i], .cell = cell ? cell[i] : NULL, .time = now->time};
        if (exact) row.exact = exact[i];
        for (int k = 0; k < c->count; k++) {
            row.axis = c->kind[k]->axis;
            c->kind[k]->fill(&row, value);
            value += count_values(c->kind[k], c->dim);
        }
    }
    free(exact);
}
