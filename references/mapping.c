/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transformations between a scene and its image. */
#include "references/mapping.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

int mapping_is_none(const struct mapping *m) {
    return m->axes == 0 && m->scale == 0 && m->offset == 0;
}

int mapping_same(const struct mapping *m, const struct mapping *n) {
    for (int a = 0; a < DIM_MAX; a++)
        if (mapping_axis(m, a) != mapping_axis(n, a) || m->against[a] != n->against[a]) return 0;
    return mapping_scale(m) == mapping_scale(n) && m->offset == n->offset;
}

int mapping_read(const char *text, struct mapping *m) {
    struct mapping read = {.from = {0, 1, 2}, .scale = m->scale, .offset = m->offset};
    int named[DIM_MAX] = {0};
    for (const char *at = text; read.axes < DIM_MAX; at++) {
        int n = read.axes++, minus = *at == '-', axis = at[minus] - 'x';
        if (axis < 0 || axis >= DIM_MAX || named[axis]++) return -1;
        read.from[n] = axis, read.against[n] = minus;
        at += minus + 1;
        if (*at == ',') continue;
        for (int a = 0; a < read.axes; a++)
            if (*at || !named[a]) return -1;
        *m = read;
        return 0;
    }
    return -1;
}

void mapping_print(const struct mapping *m, char *text) {
    size_t used = 0;
    text[0] = '\0';
    for (int a = 0; a < m->axes; a++)
        used += (size_t)snprintf(text + used, MAPPING_WORDS - used, "%s%s%c", a ? "," : "", m->against[a] ? "-" : "",
                                 "xyz"[m->from[a]]);
}

int mapping_axis(const struct mapping *m, int axis) {
    return m->axes ? m->from[axis] : axis;
}

int mapping_axis_back(const struct mapping *m, int axis) {
    int a = 0;
    while (mapping_axis(m, a) != axis) a++;
    return a;
}

enum side mapping_side(const struct mapping *m, enum side s) {
    int axis = (int)s / 2;
    return (enum side)(2 * mapping_axis(m, axis) + ((int)s % 2 != m->against[axis]));
}

/* 0 - x avoids a negative zero. */
void mapping_to_scene(const struct mapping *m, int dim, const double *x, double to[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) to[a] = 0;
    for (int a = 0; a < dim; a++) to[mapping_axis(m, a)] = m->against[a] ? 0 - x[a] : x[a];
}

void mapping_to_case(const struct mapping *m, int dim, const double *x, double to[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) to[a] = 0;
    for (int a = 0; a < dim; a++) {
        double along = x[mapping_axis(m, a)];
        to[a] = m->against[a] ? 0 - along : along;
    }
}

double mapping_scale(const struct mapping *m) {
    return m->scale > 0 ? m->scale : 1;
}

double mapping_temperature(const struct mapping *m, double T) {
    return mapping_scale(m) * T + m->offset;
}

/* The product and the sum each round by half an ulp; the identity is exact. */
double mapping_bound(const struct mapping *m, double T, double bound) {
    double scale = mapping_scale(m), product = fabs(scale * T), sum = fabs(mapping_temperature(m, T));
    return scale * bound + DBL_EPSILON / 2 * ((scale != 1) * product + (m->offset != 0) * sum);
}

double mapping_temperature_back(const struct mapping *m, double T) {
    return (T - m->offset) / mapping_scale(m);
}

static double initial(const struct problem *p, const double *x) {
    const struct image *i = p->data;
    double at[DIM_MAX];
    mapping_to_scene(&i->map, p->dim, x, at);
    return mapping_temperature(&i->map, i->of->initial(i->of, at));
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    const struct image *i = p->data;
    double at[DIM_MAX];
    mapping_to_scene(&i->map, p->dim, x, at);
    double held = i->of->wall(i->of, p->shape ? s : mapping_side(&i->map, s), at, t);
    return p->side[s] == NEUMANN ? mapping_scale(&i->map) * held : mapping_temperature(&i->map, held);
}

static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    const struct image *i = p->data;
    double at[DIM_MAX];
    mapping_to_scene(&i->map, p->dim, x, at);
    return mapping_scale(&i->map) * i->of->wall_rate(i->of, p->shape ? s : mapping_side(&i->map, s), at, t);
}

static double source(const struct problem *p, const double *x) {
    const struct image *i = p->data;
    double at[DIM_MAX];
    mapping_to_scene(&i->map, p->dim, x, at);
    return mapping_scale(&i->map) * i->of->source(i->of, at);
}

static double source_rate(const struct problem *p, const double *x) {
    const struct image *i = p->data;
    double at[DIM_MAX];
    mapping_to_scene(&i->map, p->dim, x, at);
    return mapping_scale(&i->map) * i->of->source_rate(i->of, at);
}

static double source_at(const struct problem *p, const double *x, double t) {
    const struct image *i = p->data;
    double at[DIM_MAX];
    mapping_to_scene(&i->map, p->dim, x, at);
    return mapping_scale(&i->map) * i->of->source_at(i->of, at, t);
}

static void direction(const struct problem *p, const double *x, double b[DIM_MAX]) {
    const struct image *i = p->data;
    double at[DIM_MAX], own[DIM_MAX] = {0};
    mapping_to_scene(&i->map, p->dim, x, at);
    i->of->direction(i->of, at, own);
    mapping_to_case(&i->map, p->dim, own, b);
}

/* k as a function of s T + c. */
static void image_law(struct image *image) {
    struct problem *of = &image->problem;
    double s = mapping_scale(&image->map);
    of->k_ref = mapping_temperature(&image->map, of->k_ref);
    of->k_beta /= s;
    of->latent *= s;
    if (of->k_law == K_POWER) of->k_0 /= pow(s, of->k_n);
}

/* Extents, jumps and conductivities along axis a of the case. */
static void image_axis(struct image *image, int a) {
    const struct problem *p = image->of;
    struct problem *of = &image->problem;
    int from = mapping_axis(&image->map, a), against = image->map.against[a], n = p->jumps[from];
    of->lo[a] = against ? 0 - p->hi[from] : p->lo[from];
    of->hi[a] = against ? 0 - p->lo[from] : p->hi[from];
    of->mirror[a] = p->mirror[from];
    of->jumps[a] = n;
    for (int j = 0; j < n; j++) of->jump[a][j] = against ? 0 - p->jump[from][n - 1 - j] : p->jump[from][j];
    of->kinked[a] = p->kinked[from];
    of->kink[a] = against ? 0 - p->kink[from] : p->kink[from];
    for (int i = 0; i < p->materials; i++) of->material[i].k[a] = p->material[i].k[from];
    for (int b = 0; b < a; b++) {
        double k = p->cross[problem_pair(mapping_axis(&image->map, b), from)];
        of->cross[problem_pair(b, a)] = against != image->map.against[b] ? 0 - k : k;
    }
    for (int s = 2 * a; s < 2 * a + 2 && !p->shape; s++) { /* the walls of a round body do not depend on the axes */
        of->side[s] = p->side[mapping_side(&image->map, (enum side)s)];
        of->robin[s] = p->robin[mapping_side(&image->map, (enum side)s)];
    }
}

void mapping_image(const struct mapping *m, const struct problem *p, struct image *image) {
    *image = (struct image){.problem = *p, .of = p, .map = *m, .interface_axis = mapping_axis_back(m, 0)};
    struct problem *of = &image->problem;
    of->data = image;
    of->initial = initial;
    of->wall = wall;
    if (p->wall_rate) of->wall_rate = wall_rate;
    if (p->source) of->source = source;
    if (p->source_rate) of->source_rate = source_rate;
    if (p->source_at) of->source_at = source_at;
    if (p->direction) of->direction = direction;
    if (p->k_law) image_law(image);
    for (int a = 0; a < p->dim; a++) image_axis(image, a);
    if (p->materials == 2 && m->against[image->interface_axis]) {
        struct material first = of->material[0];
        of->material[0] = of->material[1], of->material[1] = first;
        of->interface = 0 - p->interface;
    }
}
