/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The columns of `reference`: one table, one function each. */
#include "verification/case/columns.h"

#include "references/cubature.h"
#include "references/kirchhoff.h"
#include "references/mapping.h"
#include "references/scene.h"
#include "solver/shape.h"
#include "solver/status.h"
#include "solver/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct columns_row {
    const struct image *image;
    const struct problem *p; /* the problem of the image */
    const double *x;
    const double *cell;
    double time;        /* s */
    int axis;           /* axis of the column, if it has one */
    struct exact exact; /* if a column depends on time */
};

const char columns_help[] =
    "LIST is one or more of these, separated by commas (SI units):\n"
    "  temperature         the exact solution; nan where it has no value (a corner of two different temperatures)\n"
    "  error_bound         bound of its error by truncation and rounding\n"
    "  flux_x flux_y flux_z   -k_x dT/dx, ..., at a time > 0; at an interface, of the upper material\n"
    "  initial             the initial temperature; on a jump, the value of the closed piece\n"
    "  initial_mean        its average over the cell around the point, clipped to the domain; columns dx, dy and dz\n"
    "                      of the points give the extents of the cell (without dy: dy = dx), else --dx for all\n"
    "  initial_heat        the temperature that keeps the heat of that cell: the integral of rho_c T over the\n"
    "                      integral of rho_c; the plain average in a cell of one material\n"
    "  source k_x k_y k_z rho_c   of the equation; at an interface, of the upper material\n"
    "  wall                three columns, wall_kind, wall_value and wall_b.  Kind 0: not on a side; 1 (Dirichlet):\n"
    "                      T = value; 2 (Neumann): k dT/dn = value, the flux into the body; 3 (Robin):\n"
    "                      k dT/dn = b (value - T).  In a corner: the side of the lowest kind; the mean of\n"
    "                      different temperatures; else the first of the sides across x, y, z\n"
    "  nearest             the nearest wall: its nearest point and outward normal there (nearest_x, nearest_y,\n"
    "                      normal_x, normal_y), the distance, and kind, value and b as for wall; nan without walls\n"
    "  wall_x wall_y wall_z   as wall, for the sides across x, y or z only: a corner gives all\n"
    "--points: CSV with the header x (x,y or x,y,z) and one point a line; other columns are ignored; - is standard "
    "input.\n"
    "Each line of the answer repeats the coordinates as typed (a point within 1e-9 extents of a side moves onto\n"
    "it), then `time` if several are given (all points of the first time come first), then the columns with 17\n"
    "digits.  Columns that do not depend on time need no --time; source, wall and nearest need it in a scene\n"
    "where they change.\n"
    "\n"
    "Initial values for your code:\n"
    "  your unknowns are       use             at                          with the cell\n"
    "  cell averages           initial_heat    the centre of each cell     that cell\n"
    "  values at nodes         initial_heat    each node                   half-way to its neighbours\n"
    "  particles               initial_heat    each particle               its volume, m/rho\n"
    "  nodes of elements       initial         each node, or, where data   -\n"
    "                                          jump, the points of the\n"
    "                                          quadrature of rho_c T v\n"
    "An interface or a jump may cut a cell.  At a node or corner on a side, the cell is its part in the domain.\n";

static int material_at(const struct columns_row *row) {
    return row->p->materials == 2 && row->x[row->image->interface_axis] >= row->p->interface;
}

static void temperature(const struct columns_row *row, double *value) {
    *value = row->exact.no_value ? NAN : mapping_temperature(&row->image->map, row->exact.temperature);
}

static void error_bound(const struct columns_row *row, double *value) {
    *value = row->exact.no_value ? NAN : mapping_scale(&row->image->map) * row->exact.error_bound;
}

static void flux(const struct columns_row *row, double *value) {
    const struct mapping *m = &row->image->map;
    const struct problem *of = row->image->of;
    double at[DIM_MAX];
    mapping_to_scene(m, of->dim, row->x, at);
    int material = of->materials == 2 && at[0] >= of->interface; /* the gradient is that of the same material */
    int along = mapping_axis(m, row->axis);
    double into = mapping_scale(m) * (m->against[row->axis] ? -1 : 1);
    *value = row->exact.no_value
                 ? NAN
                 : -into * kirchhoff_along(of, &of->material[material], along, row->exact.temperature) *
                       row->exact.gradient[along];
}

static void initial(const struct columns_row *row, double *value) {
    *value = row->p->initial(row->p, row->x);
}

static struct approx initial_at(const void *data, const double *x) {
    const struct problem *p = data;
    return (struct approx){p->initial(p, x), 0};
}

/* Average over the part of the domain from lo to hi.  The initial data may have a kink at an interface. */
static double mean_start(const struct image *image, const double *lo, const double *hi) {
    const struct problem *p = &image->problem;
    struct cubature_knots knots = {.grades = 0};
    double volume = (hi[0] - lo[0]) * (hi[1] - lo[1]) * (p->dim == 3 ? hi[2] - lo[2] : 1);
    double part = p->shape ? shape_clipped(p, lo, hi) / volume : 1;
    if (part < 1 - 1e-9 && part > 1e-12) return clipped_mean(p, lo, hi);
    for (int a = 0; a < p->dim; a++) {
        for (int j = 0; j < p->jumps[a]; j++) knots.knot[a][knots.count[a]++].at = p->jump[a][j];
        if (p->dim < 3) { /* the data of a scene may have a peak in the middle */
            knots.knot[a][knots.count[a]].at = (p->lo[a] + p->hi[a]) / 2;
            knots.knot[a][knots.count[a]++].graded = 1;
        }
        if (p->materials == 2 && a == image->interface_axis) knots.knot[a][knots.count[a]++].at = p->interface;
    }
    return cubature_mean(initial_at, p, p->dim, lo, hi, &knots).value;
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
    double lo[DIM_MAX], hi[DIM_MAX];
    cell_of(row, lo, hi);
    *value = mean_start(row->image, lo, hi);
}

/* Average weighted with the rho c of each material in the cell. */
static void initial_heat(const struct columns_row *row, double *value) {
    const struct problem *p = row->p;
    const struct image *image = row->image;
    double lo[DIM_MAX] = {0}, hi[DIM_MAX] = {0}, from[DIM_MAX], to[DIM_MAX];
    int a = image->interface_axis;
    cell_of(row, lo, hi);
    int cut = p->materials == 2 && lo[a] < p->interface && p->interface < hi[a];
    *value = 0;
    if (cut) {
        double part[2] = {(p->interface - lo[a]) * p->material[0].rho_c,
                          (hi[a] - p->interface) * p->material[1].rho_c};
        memcpy(from, lo, sizeof from), memcpy(to, hi, sizeof to);
        from[a] = to[a] = p->interface;
        *value = (mean_start(image, lo, to) * part[0] + mean_start(image, from, hi) * part[1]) / (part[0] + part[1]);
    } else {
        *value = mean_start(image, lo, hi);
    }
}

static void source(const struct columns_row *row, double *value) {
    *value = problem_source(row->p, row->x, row->time);
}

static void conductivity(const struct columns_row *row, double *value) {
    *value = row->p->material[material_at(row)].k[row->axis];
}

static void rho_c(const struct columns_row *row, double *value) {
    *value = row->p->material[material_at(row)].rho_c;
}

static const int wall_kind[] = {[DIRICHLET] = 1, [NEUMANN] = 2, [ROBIN] = 3};

static void wall_values(const struct problem *p, int s, const double *x, double t, double *value) {
    value[0] = wall_kind[p->side[s]];
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
    {"temperature", "temperature", 1, 0, 0, temperature, 0, 1, NULL},
    {"error_bound", "error_bound", 1, 0, 0, error_bound, 0, 1, NULL},
    {"initial", "initial", 0, 0, 0, initial, 0, 1, NULL},
    {"initial_mean", "initial_mean", 0, 1, 0, initial_mean, 0, 1, NULL},
    {"initial_heat", "initial_heat", 0, 1, 0, initial_heat, 0, 1, NULL},
    {"source", "source", 0, 0, 0, source, 0, 1, NULL},
    {"k_x", "k_x", 0, 0, 0, conductivity, 0, 1, NULL},
    {"k_y", "k_y", 0, 0, 2, conductivity, 1, 1, NULL},
    {"k_z", "k_z", 0, 0, 3, conductivity, 2, 1, NULL},
    {"rho_c", "rho_c", 0, 0, 0, rho_c, 0, 1, NULL},
    {"flux_x", "flux_x", 1, 0, 0, flux, 0, 1, NULL},
    {"flux_y", "flux_y", 1, 0, 2, flux, 1, 1, NULL},
    {"flux_z", "flux_z", 1, 0, 3, flux, 2, 1, NULL},
    {"wall", "wall_kind,wall_value,wall_b", 0, 0, 0, wall, 0, 3, NULL},
    {"nearest", "nearest_x,nearest_y,normal_x,normal_y,distance,nearest_kind,nearest_value,nearest_b", 0, 0, 0,
     nearest, 0, 8,
     "nearest_x,nearest_y,nearest_z,normal_x,normal_y,normal_z,distance,nearest_kind,nearest_value,nearest_b"},
    {"wall_x", "wall_x_kind,wall_x_value,wall_x_b", 0, 0, 0, wall_across, 0, 3, NULL},
    {"wall_y", "wall_y_kind,wall_y_value,wall_y_b", 0, 0, 2, wall_across, 1, 3, NULL},
    {"wall_z", "wall_z_kind,wall_z_value,wall_z_b", 0, 0, 3, wall_across, 2, 3, NULL},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

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
        at += length;
        if (*at == '\0') return STATUS_OK;
    }
}

int columns_count(const struct columns_kind *kind, int dim) {
    return kind->values + (dim == 3 && kind->space ? 2 : 0);
}

void columns_header(const struct columns *c, char *text) {
    *text = '\0';
    for (int i = 0; i < c->count; i++) {
        const struct columns_kind *kind = c->kind[i];
        words_add(text, COLUMNS_HEADER, ",%s", c->dim == 3 && kind->space ? kind->space : kind->header);
    }
}

int columns_values(const struct columns *c, const struct image *image, double time, const double *x,
                   const double *cell, const struct exact *exact, double *value) {
    struct columns_row row = {.image = image, .p = &image->problem, .x = x, .cell = cell, .time = time};
    int n = 0;
    if (exact) row.exact = *exact;
    for (int i = 0; i < c->count; i++) {
        row.axis = c->kind[i]->axis;
        c->kind[i]->fill(&row, value + n);
        n += columns_count(c->kind[i], c->dim);
    }
    return n;
}
