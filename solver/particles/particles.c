/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which options go together, as one table (a condition, the option that it refuses, the reason and the remedy), and
 * what a run needs from them: defaults, lattice, cloud. */
#include "solver/particles/particles.h"

#include "solver/particles/walls.h"
#include "solver/shape.h"
#include "solver/time/matched.h"

#include <math.h>
#include <stdio.h>

int particles_rows(const struct problem *p, const struct options *o) {
    return options_is_cloud(o) || p->materials == 2 || p->side[X_LO] == PERIODIC || problem_has_cross(p) ||
           layout_is_cut(p, o);
}

enum subject { LAYOUT, WALLS, SHIFT, SAMPLING, ORDER, VOLUME, MEAN, STEPPER, METHOD };

struct rule {
    int refuses;
    enum subject subject;
    const char *reason, *use;
};

static void name_subject(enum subject subject, const struct options *o, const struct scheme *s, char text[80]) {
    switch (subject) {
    case LAYOUT:
        snprintf(text, 80, "--layout %s", layout_words[o->layout]);
        break;
    case WALLS:
        snprintf(text, 80, "--walls %s", walls_words[o->walls]);
        break;
    case SHIFT:
        snprintf(text, 80, "--shift %g", o->shift);
        break;
    case SAMPLING:
        snprintf(text, 80, "--sampling %s", sampling_words[o->sampling]);
        break;
    case ORDER:
        snprintf(text, 80, "--order %d", o->order);
        break;
    case VOLUME:
        snprintf(text, 80, "--volume %s", volume_words[o->volume]);
        break;
    case MEAN:
        snprintf(text, 80, "--mean %s", mean_words[o->mean]);
        break;
    case STEPPER:
        snprintf(text, 80, "--stepper %s", stepper_words[o->stepper]);
        break;
    case METHOD:
        snprintf(text, 80, "%s", s->name);
        break;
    }
}

static int has_wall(const struct problem *p, enum side_kind kind) {
    for (int side = 0; side < SIDES; side++)
        if (shape_has_wall(p, side) && p->side[side] == kind) return 1;
    return 0;
}

/* The law of a wall that exchanges heat; NULL if there is none. */
static const struct wall_law *exchanging(const struct problem *p) {
    for (int side = 0; side < SIDES; side++)
        if (shape_has_wall(p, side) && problem_law(p, side)->exchange) return problem_law(p, side);
    return NULL;
}

/* A boundary condition of the problem that the dummies of the options do not support; PERIODIC if there is none. */
static enum side_kind kind_without_dummies(const struct problem *p, enum walls walls) {
    for (int side = 0; side < SIDES; side++)
        if (shape_has_wall(p, side) && !walls_support(walls, problem_law(p, side))) return p->side[side];
    return PERIODIC;
}

/* The first material with unequal conductivities; NULL if there is none. */
static const struct material *anisotropic(const struct problem *p) {
    for (int m = 0; m < p->materials; m++)
        for (int a = 1; a < p->dim; a++)
            if (p->material[m].k[0] != p->material[m].k[a]) return &p->material[m];
    return NULL;
}

int particles_check(const struct problem *p, const struct options *o, const struct scheme *s, struct failure *why) {
    const struct stepper *stepper = stepper_of(o->stepper);
    const int round = p->shape != NULL, periodic = !round && p->side[X_LO] == PERIODIC, two = p->materials == 2;
    const int cut = layout_is_cut(p, o), twice = cut && s->sweeps == 2;
    const struct wall_law *exchange = exchanging(p);
    const int node = o->layout == LAYOUT_NODE, settled = o->layout == LAYOUT_RELAXED;
    const char *const law = problem_nonlinearity(p); /* NULL: linear */
    const int mirror = o->walls == WALLS_MIRROR, matched = options_is_matched(o);
    const enum side_kind kind = kind_without_dummies(p, o->walls);
    const struct material *unequal = anisotropic(p);
    const int tensor = problem_has_cross(p);
    /* every row is the stencil of a square lattice */
    const int uniform = periodic && o->layout == LAYOUT_LATTICE && !two && !unequal && !tensor && !p->source;
    const struct material *m = unequal ? unequal : &p->material[0];
    const int space = p->dim == 3;
    char axes[120], wall[60], midway[80], varies[100], steppers[2][STEPPER_LIST];
    int used = snprintf(axes, sizeof axes, "isotropic conductivity only, the scene has k_x = %g", m->k[0]);
    if (space) used += snprintf(axes + used, sizeof axes - (size_t)used, ", k_y = %g", m->k[1]);
    snprintf(axes + used, sizeof axes - (size_t)used, " and k_%c = %g", space ? 'z' : 'y', m->k[space ? 2 : 1]);
    snprintf(wall, sizeof wall, "does not support a %s wall", problem_laws[kind].name);
    snprintf(midway, sizeof midway, "a %s wall is midway between a particle and its ghost",
             exchange ? exchange->name : "");
    snprintf(varies, sizeof varies, "the temperature of a %s wall varies, and its ghosts are second order",
             exchange ? exchange->name : "");

    const struct rule rules[] = {
        {space && s->cells, METHOD, "its cells are polygons, on a rod and in the plane only", "so_ssph"},
        /* materials and data */
        {o->volume == VOLUME_TUNED && s->volume && !s->tuned, VOLUME, "supported by brookshaw only", "moment or raw"},
        {two && !s->two_materials, METHOD, "one material only, the scene has two", "brookshaw or contact_ssph"},
        {s->isotropic && unequal && !tensor, METHOD, axes, two ? "contact_ssph" : "so_ssph"},
        {tensor && !s->tensor, METHOD, "a diagonal conductivity only, the scene has k_xy", "so_ssph or ftcs"},
        {tensor && law, METHOD, "a tensor that depends on temperature is not supported", "k_xy = 0"},
        {tensor && (has_wall(p, NEUMANN) || exchange), METHOD,
         "with k_xy T is not even beyond a wall of given flux: n.K grad T is given, not n.grad T", "ftcs"},
        {tensor && !periodic && (!mirror || cut), WALLS, "with k_xy T is odd beyond a held plane wall",
         "mirror, no --shift"},
        {tensor && !periodic && o->layout != LAYOUT_LATTICE && o->layout != LAYOUT_JITTER, LAYOUT,
         "with k_xy images are of particles midway", "lattice or jitter"},
        {tensor && s->sweeps == 2 && o->layout != LAYOUT_LATTICE, LAYOUT,
         "with k_xy derivatives applied twice are second order on a lattice alone", "lattice"},
        {tensor && !periodic && o->order > 2, ORDER, "with k_xy images are exact to first degree", "2"},
        {p->resistance > 0 && (o->mean == MEAN_HARMONIC || o->mean == MEAN_ARITHMETIC), MEAN,
         "has no place for a contact resistance", "series"},
        {two && o->sampling == SAMPLING_SPLINE, SAMPLING, "four cells of two materials have no common average",
         "point or cell"},
        {problem_changes(p) && !law && (cut || two), METHOD,
         "walls or a source that change in time need one material and plane walls that do not cut the lattice",
         "--walls mirror or fixed without --shift"},
        /* k(T) */
        {law && unequal, METHOD, axes, "materials with k_x = k_y"},
        {law && stepper && !stepper->stage, STEPPER, law, stepper_list(1, steppers[0])},
        {law && o->order > 2, ORDER, "with a k that depends on temperature, ghosts are second order", "2"},
        {law && (cut || !mirror), WALLS, "k depends on temperature here, and ghosts are images",
         "mirror, no --shift"},
        {law && (node || settled), LAYOUT, "k depends on temperature here", "lattice, jitter or hexagonal"},
        {law && o->sampling == SAMPLING_SPLINE, SAMPLING, "k depends on temperature here", "point or cell"},
        {law && o->mean == MEAN_SERIES, MEAN, "is for two materials", "harmonic, arithmetic or kirchhoff"},
        {!law && o->mean == MEAN_KIRCHHOFF, MEAN, "is for a k that depends on temperature",
         "harmonic, arithmetic or series"},
        /* layouts */
        {space && (settled || o->layout == LAYOUT_HEXAGONAL), LAYOUT, "on a rod and in the plane only",
         "lattice or jitter"},
        {node && periodic, LAYOUT, "the scene has no walls", "lattice"},
        {node && exchange, LAYOUT, midway, "lattice"},
        {node && two, LAYOUT, "two materials give each particle a row of its own", "lattice"},
        {node && cut, LAYOUT, "requires walls between particles", "lattice, jitter or hexagonal"},
        {cut && settled, LAYOUT, "particles settle between plane walls, with --walls mirror and no --shift",
         "lattice, jitter or hexagonal"},
        {cut && !round && o->layout == LAYOUT_HEXAGONAL, LAYOUT, "requires --walls mirror without --shift here",
         "lattice or jitter"},
        /* walls */
        {periodic && o->shift > 0, SHIFT, "the scene is periodic and has no walls", "0"},
        {periodic && !mirror, WALLS, "the scene is periodic and has no walls", "mirror"},
        {cut && s->cells && !(round && mirror), WALLS, "only round walls can cut cells",
         "--walls mirror without --shift"},
        {cut && two, METHOD, "on a cut lattice one material only, the scene has two",
         "--walls mirror without --shift"},
        {cut && o->order > 2, ORDER, "on a cut lattice dummies are exact for quadratics only", "2"},
        {exchange && o->order > 2, ORDER, varies, "2"},
        {twice && s->adjoint, METHOD, "on a cut lattice an adjoint cannot include dummies", "so_ssph"},
        {twice && o->walls == WALLS_DISTANCE, WALLS, "a dummy that differs from pair to pair has no derivative",
         "fit"},
        /* mirror images are off the lattice; with image 8 of 12 lattices in a disc had growing modes */
        {twice && p->dim > 1 && (mirror || o->walls == WALLS_IMAGE), WALLS,
         "modes grow where a derivative is applied twice", "fit"},
        {o->walls == WALLS_ONE_SIDED && !s->at_wall, WALLS, "needs the least squares of so_ssph", "fit"},
        {round && o->sampling != SAMPLING_POINT, SAMPLING, "a round wall cuts cells", "point"},
        {round && mirror && !s->cells, WALLS, "images of particles need plane walls, the scene has round ones",
         "fit"},
        {cut && kind != PERIODIC, WALLS, wall, "fit"},
        /* steppers */
        {stepper && stepper->needs && particles_rows(p, o) && !(matched && uniform), STEPPER,
         "requires one stencil for all particles",
         "--layout lattice or node, one material and plane walls between particles or on them"},
        {problem_changes(p) && stepper && stepper->needs, STEPPER, "solves dT/dt = A T + g with a constant g only",
         stepper_list(0, steppers[1])},
        {matched && exchange, STEPPER, varies, "another stepper"},
        {stepper && stepper->evolve && o->walls == WALLS_FIXED && has_wall(p, DIRICHLET), STEPPER,
         "a transform requires mirror walls", "--walls mirror"},
    };
    for (size_t k = 0; k < sizeof rules / sizeof *rules; k++) {
        char subject[80];
        if (!rules[k].refuses) continue;
        name_subject(rules[k].subject, o, s, subject);
        return refuse(why, STATUS_NOT_APPLICABLE, "%s: %s; use %s", subject, rules[k].reason, rules[k].use);
    }
    return s->check ? s->check(p, o, why) : STATUS_OK;
}

int particles_resolve(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct failure *why) {
    *resolved = *o;
    int order = o->order > 2 ? o->order : 2;
    if (o->h == 0) resolved->h = s->h ? s->h(p) : 1.1 * order / 2;
    if (o->layout == LAYOUT_RELAXED && o->jitter == 0) resolved->jitter = 0.5;
    if (o->layout == LAYOUT_RELAXED && o->sweeps == 0) resolved->sweeps = 2000;
    if (particles_check(p, resolved, s, why)) return why->status;
    if (o->h_iso) return matched_isotropic(p->dim, resolved, s, &resolved->h, why);
    return STATUS_OK;
}

int particles_prepare(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct lattice *l, int *rows, struct failure *why) {
    const struct stepper *stepper = stepper_of(o->stepper);
    if (particles_resolve(p, o, s, resolved, why)) return why->status;
    if (layout_lattice(p, resolved, l, why)) return why->status;
    *rows = particles_rows(p, o);
    if (!stepper || !stepper->needs) return STATUS_OK;
    return stepper->needs(p, o, s, l, why);
}

double particles_reach(const struct options *o, const struct scheme *s, const struct lattice *l) {
    return s->sweeps * 2.0 * o->h * l->dx[0];
}

int particles_cloud(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                    struct cloud *c, struct failure *why) {
    if (layout_cloud(p, o, l, particles_reach(o, s, l), c, why)) return why->status;
    int status = walls_fill(p, o, c, l->dx[0], why);
    if (status) layout_cloud_free(c);
    return status;
}
