/* What a run of a particle method would store and do: its lattice, its operator and its steps, without its states.
 *
 * Rows are assembled to be counted, up to ASSEMBLED particles.  Past that those of a lattice `finer` times coarser
 * stand in: they have as many entries a particle, and a spectrum finer^2 times smaller. */
#include "solver/methods/particles.h"
#include "solver/methods/start.h"
#include "solver/outline.h"

#include <math.h>

static const double ASSEMBLED = 2e5, FEWEST = 2000; /* particles: most, and least of a stand-in */

/* How many times coarser the lattice is whose rows are counted, *coarse. */
static double coarsening(const struct problem *p, const struct options *o, const struct lattice *l,
                         struct lattice *coarse) {
    double n = (double)l->n[0] * l->n[1];
    struct options with = *o;
    struct failure ignored;
    for (double m = 2; n > ASSEMBLED && n / pow(m, p->dim) > FEWEST; m++) {
        with.dx = m * o->dx;
        if (n / pow(m, p->dim) <= ASSEMBLED / 4 && !layout_lattice(p, &with, 1, coarse, &ignored)) return m;
    }
    *coarse = *l;
    return 1;
}

/* Rows whose counts are those of the lattice *l; *bound is that of its operator. */
static int count_rows(const struct problem *p, const struct options *o, const struct scheme *s,
                      const struct lattice *l, struct heat_operator *a, double *bound, struct outline *out,
                      struct failure *why) {
    struct lattice coarse;
    struct cloud c;
    double finer = coarsening(p, o, l, &coarse), n = (double)l->n[0] * l->n[1];
    if (layout_cloud(p, o, &coarse, particles_reach(o, s, &coarse), &c, why)) return why->status;
    int status = operator_create_csr(a, p, o, s, &c, coarse.dx[0], why);
    layout_cloud_free(&c);
    if (status) return status;
    double times = n / (double)a->n;
    *bound = operator_bound(a) * finer * finer;
    a->state = (size_t)n + (size_t)((double)(a->state - a->n) * pow(finer, p->dim - 1)); /* ghosts */
    a->n = (size_t)n;
    a->pairs = (size_t)(times * (double)a->pairs), a->bytes = (size_t)(times * (double)a->bytes);
    if (finer > 1) out->stand_in = coarse.dx[0];
    return STATUS_OK;
}

static void hold(const struct problem *p, const struct options *o, const struct heat_operator *a,
                 const struct march *m, struct outline *out) {
    size_t constants = a->constant ? (a->weight ? a->state : a->n) * sizeof *a->g : 0, unit = sizeof(double);
    out->answer = p->dim + 1 + (o->layout == LAYOUT_GRADED); /* whose cells differ in volume */
    out->on_lattice = particles_on_lattice(p, o, out->rows);
    out->neighbours = (double)a->pairs / (double)a->n;
    outline_hold(out, out->answer > p->dim + 1 ? "places, temperatures and volumes" : "places and temperatures",
                 a->n * (size_t)out->answer * unit, OUTLINE_SET_UP, OUTLINE_STEPS);
    outline_hold(out,
                 a->gradient ? "first derivatives: pairs, places, ghosts, fluxes"
                 : out->rows ? "rows: weights, columns, diagonal, bands of a rod"
                             : "stencil: a quadrant of weights, for all particles",
                 a->bytes - constants, OUTLINE_SET_UP, OUTLINE_STEPS);
    outline_hold(out, "what walls and source add", constants, OUTLINE_SET_UP, OUTLINE_STEPS);
    /* lists that grow by doubling, and the cloud with its ghosts; of pairs each is listed once */
    const size_t bands = a->banded ? (size_t)(2 * a->band + 1) * a->n * unit : 0;
    outline_hold(out, "neighbours while they are found, about",
                 out->rows ? (a->gradient ? 1 : 2) * (a->bytes - bands) : 0, OUTLINE_SET_UP, OUTLINE_SET_UP);
    /* on a rod; in the plane what transforms hold depends on the data, and is less than what the measured error holds
     */
    if (o->stepper == STEPPER_EXACT && p->dim == 1)
        outline_hold(out, "rates of the modes and a transform", a->n * (size_t)(a->reach[0] + 2) * unit,
                     OUTLINE_SET_UP, OUTLINE_SET_UP);
    if (o->stepper != STEPPER_EXACT)
        outline_hold(
            out, stepper_arrays(m->stepper) == 3 ? "three states with their ghosts" : "two states with their ghosts",
            (size_t)stepper_arrays(m->stepper) * a->state * unit, OUTLINE_STEPS, OUTLINE_STEPS);
}

static const char *weights_of(const struct problem *p, int rows) {
    return !rows               ? "one stencil for all particles: a lattice of one material, no neighbour list"
           : p->materials == 2 ? "a row for each particle: two materials, so that pairs differ"
                               : "a row for each particle: off the lattice each has its own neighbours";
}

int particles_outline(const struct method *m, const struct problem *p, const struct options *given,
                      struct outline *out, struct failure *why) {
    const struct scheme *s = m->scheme;
    struct options resolved, *o = &resolved;
    struct lattice l;
    struct heat_operator a = {0};
    struct march march;
    double bound = 0;
    *out = (struct outline){0};
    if (particles_prepare(p, given, s, o, &l, &out->rows, why)) return why->status;
    int status =
        out->rows ? count_rows(p, o, s, &l, &a, &bound, out, why) : operator_outline_lattice(&a, p, o, s, &l, why);
    if (!status && !out->rows) bound = operator_bound(&a);
    if (!status) status = particles_march(p, o, s, &l, &a, bound, &march, why);
    if (!status) {
        out->weights = weights_of(p, out->rows);
        particles_count(p, o, s, &l, &a, &march, &out->run);
        hold(p, o, &a, &march, out);
        if (start_is_kept(p, o, s))
            outline_hold(out, "rows once more, for what they keep of the start", 3 * a.bytes, OUTLINE_SET_UP,
                         OUTLINE_SET_UP);
        out->run.bytes = out->bytes[OUTLINE_STEPS];
    }
    operator_free(&a);
    return status;
}
