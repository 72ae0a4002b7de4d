/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What no single option can see: which ones a verb lacks, which contradict or need each other. */
#include "verification/command/arguments.h"
#include "solver/time/stepper.h"

#include "references/scene.h"
#include "verification/command/option.h"
#include "verification/command/verb.h"
#include "verification/text/words.h"

#include <math.h>
#include <string.h>

/* Cases of a scene or of the battery. */
static int check_case(const struct request *r, struct failure *why) {
    if (r->experiment.scene && r->battery) return refuse(why, STATUS_INPUT, "--battery has scenes of its own");
    if (!r->experiment.scene && !r->battery)
        return refuse(why, STATUS_INPUT,
                      "case needs a scene, or --battery: heatladder case SCENE --dx A,B,C --into DIR");
    if (r->experiment.scene && !r->rungs.dx.count)
        return refuse(why, STATUS_INPUT, "case needs --dx A,B,C,...: the spacings");
    return r->into ? STATUS_OK : refuse(why, STATUS_INPUT, "case needs --into DIR: where the cases go");
}

int checks_required(const struct request *r, struct failure *why) {
    if (words_among(r->verb->options, "vary") && !r->rungs.dx.count && !r->experiment.program.results)
        return refuse(why, STATUS_INPUT, "%s needs --dx A,B,C,..., or --results DIR with a directory a spacing",
                      r->verb->name);
    if (words_among(r->verb->options, "into") && check_case(r, why)) return why->status;
    for (const struct option *o = options_table; o->key; o++)
        if (words_among(r->verb->required, o->key) && !r->given[o - options_table])
            return refuse(why, STATUS_INPUT, "%s needs --%s %s: %s", r->verb->name, o->name, o->value, o->about);
    return STATUS_OK;
}

static int check_options(const struct request *r, struct failure *why) {
    const struct options *o = &r->experiment.options;
    const struct stepper *stepper = stepper_of(o->stepper);
    if (r->rungs.dt.count && r->rungs.fourier.count)
        return refuse(why, STATUS_INPUT, "--dt and --fourier both set the time step; give one of them");
    if ((r->rungs.dt.count || r->rungs.fourier.count) && stepper && stepper->evolve)
        return refuse(why, STATUS_INPUT, "--stepper %s: has no time step; leave out --%s", stepper->name,
                      r->rungs.dt.count ? "dt" : "fourier");
    if (o->jitter > 0 && o->layout != LAYOUT_JITTER && o->layout != LAYOUT_RELAXED)
        return refuse(why, STATUS_INPUT, "--jitter %g: needs --layout jitter or relaxed", o->jitter);
    if (o->sweeps > 0 && o->layout != LAYOUT_RELAXED)
        return refuse(why, STATUS_INPUT, "--sweeps %d: needs --layout relaxed", o->sweeps);
    if (o->xi > 0 && o->volume != VOLUME_TUNED)
        return refuse(why, STATUS_INPUT, "--xi %g: needs --volume tuned", o->xi);
    if (r->at.count > 2 || (r->at.count && r->experiment.scene && r->at.count != r->experiment.problem.dim))
        return refuse(why, STATUS_INPUT, "--at needs %s for %s",
                      !r->experiment.scene             ? "X or X,Y"
                      : r->experiment.problem.dim == 2 ? "X,Y"
                                                       : "one number",
                      r->experiment.scene ? r->experiment.scene->name : "a point");
    double least = INFINITY;
    for (int i = 0; i < r->rungs.dt.count; i++) least = fmin(least, r->rungs.dt.value[i]);
    if (r->rungs.fine > 0 && !(r->rungs.dt.count > 1 && r->rungs.fine < least))
        return refuse(why, STATUS_INPUT, "--fine %g: needs --dt A,B,C, and to be below the finest of them",
                      r->rungs.fine);
    if (r->rungs.fine > 0 && r->experiment.method && r->experiment.method->scheme)
        return refuse(why, STATUS_INPUT, "--fine: what %s is to reach in time is known; leave it out",
                      r->experiment.method->name);
    const struct numbers *e = &r->rungs.expect;
    if (e->count && !(e->count == 2 && e->value[0] < e->value[1]))
        return refuse(why, STATUS_INPUT, "--expect %.60s: needs LO,HI with LO < HI, such as 1.9,2.1", e->text);
    return STATUS_OK;
}

/* Points of a file, or one; and of that one the temperature at a time, or what is named. */
static int check_reference(const struct request *r, struct failure *why) {
    if (!r->points == !r->at.count)
        return refuse(why, STATUS_INPUT, "reference needs either --at X[,Y] or --points FILE (- for standard input)");
    if (!r->what && r->time.count == 0)
        return refuse(why, STATUS_INPUT, "reference needs --time T[,T...]: when, s; or --what names columns without");
    if (r->json && (r->points || r->what || r->time.count > 1))
        return refuse(why, STATUS_INPUT,
                      "--json prints the temperature at one point and time (--at, --time); %s is CSV",
                      r->points ? "--points"
                      : r->what ? "--what"
                                : "--time T,T,...");
    if (r->rungs.dx.count > 1) return refuse(why, STATUS_INPUT, "--dx: one extent for all cells");
    return STATUS_OK;
}

static int check_program(const struct request *r, struct failure *why) {
    const struct program *g = &r->experiment.program;
    if (g->solver && g->results)
        return refuse(why, STATUS_INPUT, "--solver runs a program, --results judges what one left: give one of them");
    if (!g->solver && (g->keep || g->timeout > 0))
        return refuse(why, STATUS_INPUT, "--%s needs --solver 'CMD'", g->keep ? "keep" : "timeout");
    if (!g->solver && r->jobs) return refuse(why, STATUS_INPUT, "--jobs needs --solver 'CMD'");
    if (r->order && !r->battery && !program_given(g) && words_among(r->verb->options, "order-of"))
        return refuse(why, STATUS_INPUT, "--order needs --solver, --results or --battery: of which code?");
    for (const struct option *o = options_table; o->key; o++)
        if (strcmp(o->key, "draw") == 0 && r->given[o - options_table] && !r->battery &&
            (!program_given(g) || r->gates_path))
            return refuse(why, STATUS_INPUT,
                          "--seed draws the battery: it needs --solver, --results or --battery, and no --gates");
    if (r->profile && !r->battery && (!program_given(g) || r->gates_path))
        return refuse(why, STATUS_INPUT,
                      "--profile chooses rows of the battery: it needs --solver, --results or --battery, and no "
                      "--gates");
    int judges = words_among(r->verb->options, "solver") && !words_among(r->verb->options, "into");
    if (!mapping_is_none(&g->map) && judges && !program_given(g))
        return refuse(why, STATUS_INPUT, "--%s needs --solver or --results: our own methods see the scene as it is",
                      g->map.axes        ? "map"
                      : g->map.plane     ? "axes"
                      : g->map.scale > 0 ? "scale"
                                         : "offset");
    const struct problem *p = &r->experiment.problem;
    if (r->experiment.options.aspect > 0 && judges && !program_given(g))
        return refuse(why, STATUS_INPUT, "--aspect needs --solver or --results: our own methods have dx = dy");
    if (r->experiment.options.aspect > 0 && (p->dim == 1 || p->shape))
        return refuse(why, STATUS_INPUT, "--aspect: %s has no rows of cells along y; take a scene on a rectangle",
                      r->experiment.scene->name);
    if (g->map.plane && p->dim == 1)
        return refuse(why, STATUS_INPUT, "--axes: %s is a rod along x; take a scene in the plane",
                      r->experiment.scene->name);
    if (g->map.axes && g->map.axes != r->experiment.problem.dim)
        return refuse(why, STATUS_INPUT, "--map: %s has %s", r->experiment.scene->name,
                      r->experiment.problem.dim == 1 ? "x alone: x or -x" : "x and y, such as y,-x");
    if ((r->more_rungs || r->time_order > 0) && !r->battery && !program_given(g) && !r->gates_path)
        return refuse(why, STATUS_INPUT, "--%s needs --solver, --results, --gates or --battery: of which code?",
                      r->more_rungs ? "rungs" : "time-order");
    if (g->seeds && words_among(r->verb->options, "gates") && !program_given(g))
        return refuse(why, STATUS_INPUT, "--seeds needs --solver or --results: each rung is run so often");
    if (*g->vary && !program_given(g)) return refuse(why, STATUS_INPUT, "--vary needs --solver or --results");
    for (int k = 0; k < COLUMN_COUNT && !program_given(g); k++)
        if (g->columns.name[k][0]) return refuse(why, STATUS_INPUT, "--columns needs --solver or --results");
    return STATUS_OK;
}

int checks_together(const struct request *r, struct failure *why) {
    if (words_among(r->verb->options, "points") && check_reference(r, why)) return why->status;
    if (check_program(r, why)) return why->status;
    return check_options(r, why);
}
