#ifndef HEATLADDER_SOLVER_METHOD_H
#define HEATLADDER_SOLVER_METHOD_H

/* A method: its name, options, solver, and an outline of its storage and work. */

#include "solver/field.h"
#include "solver/options.h"
#include "solver/status.h"

struct outline; /* outline.h */
struct problem;
struct scheme; /* space/operator.h: how a particle method weights its neighbours */

struct method {
    const char *name;
    const char *about;   /* one line, with its equation */
    const char *accepts; /* the options that have a meaning here, separated by blanks: "stepper kernel h ..." */
    const struct scheme *scheme; /* NULL for a method that is not a particle method */
    /* 0 and a filled *f (its arrays owned by the caller), or a status with *why filled and *f untouched */
    int (*solve)(const struct problem *p, const struct options *o, struct field *f, struct failure *why);
    /* What solve would store and do, for a stepper other than STEPPER_AUTO; refuses what solve does.  NULL for a
     * method that does not tell. */
    int (*outline)(const struct problem *p, const struct options *o, struct outline *out, struct failure *why);
};

extern const struct method *const methods[]; /* ended by NULL */

const struct method *method_find(const char *name); /* NULL where there is none */

#endif
